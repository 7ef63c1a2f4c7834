"""Random cars, and a car written as a sheet: any unit, both axes conventions, either side."""

import tomllib

import numpy as np

from cars import (
    AXLES, CARRIERS, MIDDLE, MIRROR, RODS, SHARED, SHARED_BODIES, Car, Given, StopKeys, Wheel, unit, with_leaf_points,
)  # fmt: skip

# One unit of the sheet in metres.
LENGTHS = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "in": 0.0254}
INERTIAS = {"kg m2": 1.0, "kg cm2": 1e-4, "kg mm2": 1e-6, "g mm2": 1e-9, "t mm2": 1e-3}
# Optional points, with their parts.
PAIRS = {
    "spring": ("spring_seat", "spring_chassis_seat"),
    "damper": ("damper_seat", "damper_chassis_seat"),
    "rebound_stop": ("rebound_stop_pad", "rebound_stop"),
}
STOPS = ("bump_stop", "rebound_stop")
BAR = ("anti_roll_bar_outer", "anti_roll_bar_inner", "drop_link_bar", "drop_link_end")


def symmetric(values):
    xx, yy, zz, xy, xz, yz = (*values, 0, 0, 0)[:6]
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]], dtype=float)


def example(path):
    """The car of a shipped sheet: in mm and ISO 8855, the left side."""
    with open(path, "rb") as file:
        sheet = tomllib.load(file)
    assert (sheet["unit"], sheet["axes"], sheet["side"], sheet["inertia_unit"]) == ("mm", "iso", "left", "kg m2"), path
    points = {name: 1e-3 * np.array(at) for name, at in sheet["points"].items()}
    bodies = {
        name: Given(
            section["mass"],
            1e-3 * np.array(section["com"]) if "com" in section else None,
            symmetric(section["inertia"]) if "inertia" in section else None,
        )
        for name, section in sheet.items()
        if isinstance(section, dict) and "mass" in section and name not in ("wheel", "rack")
    }
    on = {name: section["on"] for name, section in sheet.items() if isinstance(section, dict) and "on" in section}
    wheel = sheet["wheel"]
    return Car(
        sheet["template"],
        points,
        bodies,
        on,
        Wheel(wheel["mass"], np.diag(wheel["inertia"]), 1e-3 * wheel["radius"], 0.0, 0.0),
        0.0,
        False,
        2.5,
        {name: StopKeys(1e-3 * sheet[name]["gap"]) for name in STOPS},
    )


def random_inertia(rng, size):
    """Inertia of a rigid body, from second moments of a density."""
    directions = rng.normal(size=(4, 3))
    second = directions.T @ directions
    inertia = np.trace(second) * np.eye(3) - second
    return inertia * size / np.trace(inertia)


def random_stop(rng, car, name):
    """Keys of a stop: on the damper, with its own points, with a gap, with a direction near the line of its points."""
    pad, face = f"{name}_pad", name
    gap = rng.uniform(0.005, 0.04)
    if "damper" in car.on and rng.integers(4) == 0:
        for end in (pad, face):
            car.points.pop(end, None)
        car.on.pop(name, None)
        car.stops[name] = StopKeys(gap)
    elif name in car.on:
        line = car.points[face] - car.points[pad]
        direction = line + 0.3 * np.linalg.norm(line) * rng.uniform(-1, 1, size=3)
        # Only the direction of the vector counts.
        direction = unit(direction) * rng.choice([1.0, rng.uniform(0.2, 50)])
        car.stops[name] = StopKeys(gap if rng.integers(3) else None, direction if rng.integers(2) else None)


def random_car(rng, path):
    """The example with all numbers changed: points displaced by some centimetres, sections and parts omitted at
    random."""
    car = example(path)
    for name in car.points:
        car.points[name] = car.points[name] + rng.uniform(-0.03, 0.03, size=3)
    if car.template in MIDDLE:
        car.points["wheel_centre"][1] = 0.0
    if "strut_top" in car.points:
        # The line of the strut has a length.
        assert np.linalg.norm(car.points["strut_top"] - car.points["strut_bottom"]) > 0.1
    carriers = CARRIERS[car.template]
    for what in car.on:
        # A drop link or a pushrod to its own first link would not move.
        choice = [link for link in carriers if not (what == "pushrod" and link == "rocker")]
        car.on[what] = str(rng.choice(choice))
    for name, given in list(car.bodies.items()):
        given.mass *= rng.uniform(0.4, 2.5)
        if name in RODS and given.inertia is None:
            a, b = (with_leaf_points(car.points)[end] for end in RODS[name])
            kind = rng.integers(3)
            if kind == 0:
                del car.bodies[name]
            elif kind == 1:
                given.com = (a + b) / 2 + rng.uniform(-0.01, 0.01, size=3)
                given.inertia = random_inertia(rng, given.mass * np.dot(b - a, b - a) / 8)
            continue
        if given.com is not None:
            given.com = given.com + rng.uniform(-0.02, 0.02, size=3)
        elif name == "spindle" and rng.integers(2):
            given.com = car.points["wheel_centre"] + rng.uniform(-0.02, 0.02, size=3)
        if name != "spindle":
            given.inertia = random_inertia(rng, np.trace(given.inertia) * rng.uniform(0.5, 2))
        else:
            given.inertia = np.diag(np.diag(random_inertia(rng, np.trace(given.inertia))))
    for name, given in car.bodies.items():
        ends = ("strut_bottom", "strut_top") if name == "strut" else RODS.get(name)
        if ends and given.inertia is not None and rng.integers(2):
            a, b = (with_leaf_points(car.points)[end] for end in ends)
            line = (b - a) / np.linalg.norm(b - a)
            across = rng.normal(size=3)
            across -= line * (line @ across)
            # At most 45° from the normal of the line.
            given.pin = across / np.linalg.norm(across) + line * rng.uniform(-1, 1)
    if "beam" in car.bodies and rng.integers(3) == 0:
        del car.bodies["beam"]
        car.on = {what: "trailing_arm" if link == "beam" else link for what, link in car.on.items()}
    for what, ends in PAIRS.items():
        if rng.integers(4) == 0:
            del car.on[what]
            for end in ends:
                del car.points[end]
    car.stops = {}
    for name in STOPS:
        random_stop(rng, car, name)
    if car.template not in MIDDLE and rng.integers(3) == 0:
        for end in BAR:
            del car.points[end]
        for name in ("anti_roll_bar", "drop_link"):
            car.bodies.pop(name, None)
        del car.on["drop_link"]
    car.wheel.mass *= rng.uniform(0.5, 2)
    car.wheel.inertia = np.diag(np.diag(random_inertia(rng, 2.3)))
    car.wheel.radius *= rng.uniform(0.8, 1.2)
    car.wheel.camber, car.wheel.toe = np.radians(rng.uniform(-4, 4, size=2)) * rng.integers(2)
    car.axle_inertia = rng.uniform(0, 0.5) * rng.integers(2)
    car.rack_slides = bool(rng.integers(2)) and "tie_rod_inner" in car.points
    car.rack_mass = rng.uniform(1, 5)
    return car


def turned_axes(adams, right, shared):
    """Matrix from the car's axes to the sheet's axes."""
    axes = np.diag([-1.0, -1, 1]) if adams else np.eye(3)
    return axes @ (MIRROR if right and not shared else np.eye(3))


def to_sheet(spelling, point):
    """Matrix for the axes of a point."""
    _, _, adams, right = spelling
    return turned_axes(adams, right, point in SHARED)


def written(car, spelling, build):
    """The sheet of a car."""
    length, inertia_unit, adams, right = spelling

    def turned(shared):
        return turned_axes(adams, right, shared)

    def triple(v):
        return "[" + ", ".join(repr(float(x)) for x in v) + "]"

    def point(at, shared):
        return triple(turned(shared) @ at / LENGTHS[length])

    def moments(matrix):
        return triple(np.diag(matrix) / INERTIAS[inertia_unit])

    def inertia(matrix):
        i = matrix / INERTIAS[inertia_unit]
        return triple((i[0, 0], i[1, 1], i[2, 2], i[0, 1], i[0, 2], i[1, 2]))

    text = [f'template = "{car.template}"', f'unit = "{length}"', f'inertia_unit = "{inertia_unit}"']
    text += [f'axes = "{"adams" if adams else "iso"}"', f'side = "{"right" if right else "left"}"']
    text += [f'build = "{build}"', "", "[points]"]
    text += [f"{name} = {point(at, name in SHARED)}" for name, at in car.points.items()]
    for name, given in car.bodies.items():
        shared = name in SHARED_BODIES
        text += ["", f"[{name}]", f"mass = {float(given.mass)!r}"]
        if given.com is not None:
            text.append(f"com = {point(given.com, shared)}")
        if given.inertia is not None:
            # The spindle's inertia is in the wheel's own axes.
            by = turned(shared)
            text.append(f"inertia = {moments(given.inertia) if name == 'spindle' else inertia(by @ given.inertia @ by.T)}")
        if given.pin is not None:
            text.append(f"pin = {triple(turned(shared) @ given.pin)}")
        if name == "spindle":
            text.append(f"axle_inertia = {float(car.axle_inertia / INERTIAS[inertia_unit])!r}")
        if name in car.on:
            text.append(f'on = "{car.on[name]}"')
    for what in [*car.on, *(name for name in car.stops if name not in car.on)]:
        if what in car.bodies:
            continue
        text += ["", f"[{what}]"]
        if what in car.on:
            text.append(f'on = "{car.on[what]}"')
        keys = car.stops.get(what, StopKeys())
        if keys.gap is not None:
            text.append(f"gap = {float(keys.gap / LENGTHS[length])!r}")
        if keys.direction is not None:
            text.append(f"direction = {triple(turned(False) @ keys.direction)}")
    wheel = car.wheel
    text += ["", "[wheel]", f"mass = {float(wheel.mass)!r}", f"inertia = {moments(wheel.inertia)}"]
    text += [f"radius = {float(wheel.radius / LENGTHS[length])!r}"]
    text += [f'{key} = "{float(np.degrees(angle))!r} deg"' for key, angle in (("camber", wheel.camber), ("toe", wheel.toe))]
    if "tie_rod_inner" in car.points:
        text += ["", "[rack]", f"slides = {str(car.rack_slides).lower()}", f"mass = {float(car.rack_mass)!r}"]
    return "\n".join(text) + "\n"


def random_spelling(rng):
    return str(rng.choice(list(LENGTHS))), str(rng.choice(list(INERTIAS))), bool(rng.integers(2)), bool(rng.integers(2))


def random_build(rng, template):
    if template in MIDDLE:
        return "left"
    return "both" if template in AXLES else str(rng.choice(["left", "right", "both"]))


