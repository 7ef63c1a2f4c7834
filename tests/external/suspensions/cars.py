"""Meaning of a suspension's sheet, from docs/reference/SUSPENSIONS.md alone: bodies and joints of each template.

A car is in metres and kilograms, in axes of ISO 8855 (x forward, y left, z up), and describes its left side:

    points   name: position
    bodies   section: Given, or None for an omitted section
    on       carrier link of each part: spring, damper, bump_stop, rebound_stop, drop_link, pushrod
"""

from dataclasses import dataclass, field

import numpy as np

MIRROR = np.diag([1.0, -1.0, 1.0])
CHASSIS = "chassis"

# Points of the whole axle: their positions do not depend on the described side.
SHARED = {
    "middle_link_chassis", "middle_link_axle", "panhard_chassis", "panhard_axle", "watt_pivot", "watt_left_chassis",
    "watt_left_crank", "watt_right_chassis", "watt_right_crank",
}  # fmt: skip
SHARED_BODIES = {"axle", "middle_link", "panhard_rod", "watt_crank", "watt_left_rod", "watt_right_rod", "rack"}

# Possible carrier links of a spring, a stop or a drop link.
CARRIERS = {
    "double-wishbone": ["lower_arm", "upper_arm", "upright"],
    "double-wishbone-rods": ["upright"],
    "macpherson-strut": ["lower_arm", "upright", "strut"],
    "semi-trailing-arm": ["trailing_arm"],
    "three-link": ["trailing_arm"],
    "multi-link": ["upper_arm", "upright", "trailing_link"],
    "five-link": ["upright"],
    "pushrod-rocker": ["lower_arm", "upper_arm", "upright", "rocker"],
    "pushrod-third-spring": ["lower_arm", "upper_arm", "upright", "rocker"],
    "solid-axle-four-links": ["axle"],
    "solid-axle-panhard": ["axle"],
    "solid-axle-watt": ["axle", "watt_crank"],
    "solid-axle-de-dion": ["axle"],
    "solid-axle-leaf-springs": ["axle"],
    "twist-beam": ["trailing_arm", "beam"],
    "swing-axle": ["axle_tube"],
    "swing-arm": ["swing_arm"],
    "telescopic-fork": ["fork_lower"],
    "rear-four-bar": ["lower_link", "rear_triangle", "rocker"],
    "rear-rocker-on-frame": ["swing_arm", "rocker"],
    "rear-rocker-on-arm": ["swing_arm", "rocker"],
}
AXLES = {
    "solid-axle-four-links", "solid-axle-panhard", "solid-axle-watt", "solid-axle-de-dion", "solid-axle-leaf-springs",
}  # fmt: skip
# Bicycles and motorcycles: one wheel, in the middle plane.
MIDDLE = {"swing-arm", "telescopic-fork", "rear-four-bar", "rear-rocker-on-frame", "rear-rocker-on-arm"}
# Rods: their end points; the first is at the universal joint.
RODS = {
    "tie_rod": ("tie_rod_inner", "tie_rod_outer"),
    "upper_link": ("upper_link_chassis", "upper_link_outer"),
    "lower_link": ("lower_link_chassis", "lower_link_outer"),
    "lateral": ("lateral_chassis", "lateral_outer"),
    "trailing_link": ("trailing_link_chassis", "trailing_link_outer"),
    "upper_front_rod": ("upper_front", "upper_ball"),
    "upper_back_rod": ("upper_back", "upper_ball"),
    "lower_front_rod": ("lower_front", "lower_ball"),
    "lower_back_rod": ("lower_back", "lower_ball"),
    "upper_front_link": ("upper_front_link_chassis", "upper_front_link_outer"),
    "upper_back_link": ("upper_back_link_chassis", "upper_back_link_outer"),
    "lower_front_link": ("lower_front_link_chassis", "lower_front_link_outer"),
    "lower_back_link": ("lower_back_link_chassis", "lower_back_link_outer"),
    "pushrod": ("pushrod_outer", "pushrod_rocker"),
    "drop_link": ("drop_link_bar", "drop_link_end"),
    "linkage_rod": ("rod_arm", "rod_rocker"),
    "middle_link": ("middle_link_chassis", "middle_link_axle"),
    "panhard_rod": ("panhard_chassis", "panhard_axle"),
    "watt_left_rod": ("watt_left_chassis", "watt_left_crank"),
    "watt_right_rod": ("watt_right_chassis", "watt_right_crank"),
    "leaf_front": ("leaf_front_eye", "leaf_front_joint"),
    "leaf_back": ("leaf_back_joint", "leaf_back_eye"),
}


def with_leaf_points(points):
    """Points with those that follow for a leaf spring: ends of the links of 3/4 of the free length from the eyes; the point of
    the middle plane on the line of the eyes in side view, at the wheel's centre."""
    if "leaf_front_eye" not in points:
        return points
    front, back, x = points["leaf_front_eye"], points["leaf_back_eye"], points["wheel_centre"][0]
    height = np.interp(x, [back[0], front[0]], [back[2], front[2]])
    return points | {
        "leaf_front_joint": 0.25 * front + 0.75 * points["leaf_clamp_front"],
        "leaf_back_joint": 0.25 * back + 0.75 * points["leaf_clamp_back"],
        "leaf_roll_point": np.array([x, 0.0, height]),
    }


@dataclass
class Given:
    """A section of a body: inertia about the centre of mass, in the vehicle's axes; for a rod, the mass alone is
    sufficient. `pin`: direction of the pin of its universal joint on the first body, if the sheet states it."""

    mass: float
    com: np.ndarray | None = None
    inertia: np.ndarray | None = None
    pin: np.ndarray | None = None


@dataclass
class Wheel:
    mass: float
    inertia: np.ndarray
    radius: float
    camber: float
    toe: float


@dataclass
class StopKeys:
    """Keys of a stop's section; a stop whose points are missing is on the damper and has a gap."""

    gap: float | None = None
    direction: np.ndarray | None = None


@dataclass
class Car:
    template: str
    points: dict
    bodies: dict
    on: dict
    wheel: Wheel
    axle_inertia: float
    rack_slides: bool
    rack_mass: float
    # Keys of bump_stop and rebound_stop.
    stops: dict = field(default_factory=dict)


@dataclass
class Body:
    mass: float
    com: np.ndarray
    inertia: np.ndarray


@dataclass
class Joint:
    """A joint between two bodies: kind, position, and a direction (the axis; for a universal joint, the blocked axis
    of rotation; for a rod, its line, with `at` as its end on the first body). `pin`: the pin of a universal joint on the first
    body; `None`: normal to the line and to the vehicle's x."""

    kind: str
    first: str
    second: str
    at: np.ndarray
    along: np.ndarray | None = None
    pin: np.ndarray | None = None


@dataclass
class Stop:
    """A stop: pad on a moving link, face on the chassis, unit vector from pad to face (`None`: on the damper, along the line
    of its ends), gap at the design position. `extends`: it limits the extension of the damper."""

    link: str
    pad: np.ndarray
    face: np.ndarray
    direction: np.ndarray | None
    gap: float
    extends: bool = False


@dataclass
class Built:
    bodies: dict = field(default_factory=dict)
    joints: list = field(default_factory=list)
    # Frames of the command: body and position.
    frames: dict = field(default_factory=dict)
    stops: dict = field(default_factory=dict)


def turned_about(axis, angle):
    c, s = np.cos(angle), np.sin(angle)
    if axis == "x":
        return np.array([[1, 0, 0], [0, c, -s], [0, s, c]])
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def unit(v):
    return v / np.linalg.norm(v)


class Side:
    """Builds one side of a car, or the shared parts."""

    def __init__(self, car, built, right, ending):
        self.car, self.built, self.ending = car, built, ending
        self.mirror = MIRROR if right else np.eye(3)

    def name(self, link):
        return link if link in SHARED_BODIES or link == CHASSIS else link + self.ending

    def point(self, name):
        at = with_leaf_points(self.car.points)[name]
        return at if name in SHARED else self.mirror @ at

    def has(self, name):
        return name in self.car.points

    def body(self, link, given=None):
        given = given or self.car.bodies[link]
        mirror = np.eye(3) if link in SHARED_BODIES else self.mirror
        self.built.bodies[self.name(link)] = Body(given.mass, mirror @ given.com, mirror @ given.inertia @ mirror)

    def join(self, kind, first, second, at, along=None):
        at = self.point(at) if isinstance(at, str) else at
        along = None if along is None else unit(along)
        self.built.joints.append(Joint(kind, self.name(first), self.name(second), at, along))

    def universal(self, first, link, at, line):
        """A universal joint; its second pin, on the link, is normal to the line and to the first pin."""
        given = self.car.bodies.get(link)
        pin = None if given is None else given.pin
        if pin is None:
            return self.join("universal", first, link, at, line)
        pin = unit(pin if link in SHARED_BODIES else self.mirror @ pin)
        blocked = np.cross(pin, unit(np.cross(line, pin)))
        self.join("universal", first, link, at, blocked)
        self.built.joints[-1].pin = pin

    def arm(self, link, one, other, carrier=CHASSIS):
        """A body on a hinge through two points."""
        self.body(link)
        self.join("hinge", carrier, link, one, self.point(other) - self.point(one))

    def rod(self, link, first, second):
        """A rod between its two ends: massless, slender, or any body; it does not rotate about its line relative to
        its first end."""
        inner, outer = RODS[link]
        # The rod of a rocker on the swing arm begins on the frame.
        inner = inner if inner in with_leaf_points(self.car.points) else "rod_frame"
        a, b = self.point(inner), self.point(outer)
        given = self.car.bodies.get(link)
        if given is None:
            self.built.joints.append(Joint("rod", self.name(first), self.name(second), a, b - a))
            return
        if given.inertia is None:
            line = b - a
            across = line @ line * np.eye(3) - np.outer(line, line)
            self.built.bodies[self.name(link)] = Body(given.mass, (a + b) / 2, given.mass / 12 * across)
        else:
            self.body(link)
        self.universal(first, link, a, b - a)
        self.join("ball", link, second, b)

    def wheel(self, carrier):
        car, at = self.car, self.point("wheel_centre")
        axes = turned_about("z", -car.wheel.toe) @ turned_about("x", -car.wheel.camber)
        axes = self.mirror @ axes @ self.mirror
        spin = axes[:, 1]
        hub = car.bodies["spindle"]
        about_axes = lambda inertia: axes @ inertia @ axes.T  # noqa: E731
        com = at if hub.com is None else self.mirror @ hub.com
        inertia = about_axes(hub.inertia) + car.axle_inertia * np.outer(spin, spin)
        self.built.bodies[self.name("spindle")] = Body(hub.mass, com, inertia)
        self.join("hinge", carrier, "spindle", at, spin)
        self.built.bodies[self.name("wheel")] = Body(car.wheel.mass, at, about_axes(car.wheel.inertia))
        self.join("fixed", "spindle", "wheel", at)
        self.frame("wheel_centre", "spindle", at)
        self.frame("contact_patch", "spindle", at - car.wheel.radius * axes[:, 2])

    def frame(self, name, link, at):
        self.built.frames[name + self.ending] = (self.name(link), at)

    def seats(self):
        for what, seat, on_chassis in [
            ("spring", "spring_seat", "spring_chassis_seat"),
            ("damper", "damper_seat", "damper_chassis_seat"),
            ("bump_stop", "bump_stop_pad", "bump_stop"),
            ("rebound_stop", "rebound_stop_pad", "rebound_stop"),
        ]:
            if self.has(seat):
                self.frame(seat, self.car.on[what], self.point(seat))
                self.frame(on_chassis, CHASSIS, self.point(on_chassis))

        if self.has("third_spring_seat"):
            self.frame("third_spring_seat", self.car.on["third_spring"], self.point("third_spring_seat"))
        for what in ("bump_stop", "rebound_stop"):
            self.stop(what, self.car.stops.get(what, StopKeys()))

    def stop(self, what, keys):
        on_damper = not self.has(what)
        part, pad, face = ("damper", "damper_seat", "damper_chassis_seat") if on_damper else (what, f"{what}_pad", what)
        if on_damper and keys.gap is None:
            return
        pad, face, link = self.point(pad), self.point(face), self.name(self.car.on[part])
        direction = None
        if not on_damper:
            direction = unit(face - pad if keys.direction is None else self.mirror @ keys.direction)
        gap = direction @ (face - pad) if keys.gap is None else keys.gap
        self.built.stops[what + self.ending] = Stop(link, pad, face, direction, gap, on_damper and what == "rebound_stop")

    def anti_roll_bar(self):
        if self.has("anti_roll_bar_outer"):
            self.arm("anti_roll_bar", "anti_roll_bar_outer", "anti_roll_bar_inner")
            self.rod("drop_link", "anti_roll_bar", self.car.on["drop_link"])

    def steering(self):
        self.rod("tie_rod", "rack" if self.car.rack_slides else CHASSIS, "upright")


def corner(side):
    """One side of an independent suspension."""
    template = side.car.template
    if template in ("double-wishbone", "pushrod-rocker", "pushrod-third-spring"):
        side.arm("lower_arm", "lower_front", "lower_back")
        side.arm("upper_arm", "upper_front", "upper_back")
        side.body("upright")
        side.join("ball", "lower_arm", "upright", "lower_ball")
        side.join("ball", "upper_arm", "upright", "upper_ball")
        side.steering()
        side.wheel("upright")
        if template.startswith("pushrod"):
            side.arm("rocker", "rocker_front", "rocker_back")
            side.rod("pushrod", side.car.on["pushrod"], "rocker")
    elif template == "double-wishbone-rods":
        side.body("upright")
        for rod in ("upper_front_rod", "upper_back_rod", "lower_front_rod", "lower_back_rod"):
            side.rod(rod, CHASSIS, "upright")
        side.steering()
        side.wheel("upright")
    elif template == "macpherson-strut":
        side.arm("lower_arm", "lower_front", "lower_back")
        side.body("upright")
        side.body("strut")
        line = side.point("strut_top") - side.point("strut_bottom")
        side.join("ball", "lower_arm", "upright", "lower_ball")
        side.universal(CHASSIS, "strut", "strut_top", line)
        side.join("cylinder", "strut", "upright", "strut_bottom", line)
        side.steering()
        side.wheel("upright")
    elif template in ("semi-trailing-arm", "twist-beam"):
        side.arm("trailing_arm", "arm_outer", "arm_inner")
        if template == "twist-beam" and "beam" in side.car.bodies:
            side.body("beam")
            side.join("fixed", "trailing_arm", "beam", side.car.bodies["beam"].com)
        side.wheel("trailing_arm")
    elif template == "three-link":
        side.body("trailing_arm")
        side.join("ball", CHASSIS, "trailing_arm", "arm_chassis")
        side.rod("upper_link", CHASSIS, "trailing_arm")
        side.rod("lower_link", CHASSIS, "trailing_arm")
        side.wheel("trailing_arm")
    elif template == "multi-link":
        side.arm("upper_arm", "upper_front", "upper_back")
        side.body("upright")
        side.join("ball", "upper_arm", "upright", "upper_ball")
        side.rod("lateral", CHASSIS, "upright")
        side.rod("trailing_link", CHASSIS, "upright")
        side.steering()
        side.wheel("upright")
    elif template == "five-link":
        side.body("upright")
        for rod in ("upper_front_link", "upper_back_link", "lower_front_link", "lower_back_link"):
            side.rod(rod, CHASSIS, "upright")
        side.steering()
        side.wheel("upright")
    elif template == "swing-axle":
        side.arm("axle_tube", "pivot_front", "pivot_back")
        side.wheel("axle_tube")
    elif template == "swing-arm":
        side.arm("swing_arm", "swing_arm_left", "swing_arm_right")
        side.wheel("swing_arm")
    elif template == "rear-four-bar":
        y = np.array([0.0, 1.0, 0.0])
        for link in ("lower_link", "rear_triangle", "rocker"):
            side.body(link)
        side.join("hinge", CHASSIS, "lower_link", "lower_pivot", y)
        side.join("hinge", "lower_link", "rear_triangle", "lower_link_end", y)
        side.join("hinge", CHASSIS, "rocker", "rocker_pivot", y)
        side.join("ball", "rocker", "rear_triangle", "rocker_triangle")
        side.wheel("rear_triangle")
    elif template in ("rear-rocker-on-frame", "rear-rocker-on-arm"):
        carrier, other = ("swing_arm", CHASSIS) if template.endswith("arm") else (CHASSIS, "swing_arm")
        side.arm("swing_arm", "swing_arm_left", "swing_arm_right")
        side.wheel("swing_arm")
        side.body("rocker")
        side.join("hinge", carrier, "rocker", "rocker_pivot", np.array([0.0, 1.0, 0.0]))
        side.rod("linkage_rod", other, "rocker")
    elif template == "telescopic-fork":
        side.body("fork_lower")
        side.join("slide", CHASSIS, "fork_lower", "fork_bottom", side.point("fork_top") - side.point("fork_bottom"))
        side.wheel("fork_lower")
    else:
        raise ValueError(template)
    side.seats()
    side.anti_roll_bar()


def axle(car, built, sides):
    """A solid axle with both its wheels."""
    both = sides[0]
    both.body("axle")
    if car.template == "solid-axle-leaf-springs":
        return leaf_springs(both, sides)
    for side in sides:
        side.rod("lower_link", CHASSIS, "axle")
        if car.template == "solid-axle-four-links":
            side.rod("upper_link", CHASSIS, "axle")
        side.wheel("axle")
        side.seats()
        side.anti_roll_bar()
    if car.template != "solid-axle-four-links":
        both.rod("middle_link", CHASSIS, "axle")
    if car.template in ("solid-axle-panhard", "solid-axle-de-dion"):
        both.rod("panhard_rod", CHASSIS, "axle")
    if car.template == "solid-axle-watt":
        both.body("watt_crank")
        both.join("hinge", "axle", "watt_crank", "watt_pivot", np.array([1.0, 0, 0]))
        both.rod("watt_left_rod", CHASSIS, "watt_crank")
        both.rod("watt_right_rod", CHASSIS, "watt_crank")


def leaf_springs(both, sides):
    """An axle on leaf springs: it moves along x and z, yaws and rolls about the roll point."""
    x, _, z = np.eye(3)
    at = both.point("leaf_roll_point")
    steps = [("axle_forward", "slide", x), ("axle_up", "slide", z), ("axle_yaw", "hinge", z), ("axle", "hinge", x)]
    last = CHASSIS
    for name, kind, along in steps:
        if name != "axle":
            both.built.bodies[name] = Body(0.0, at, np.zeros((3, 3)))
        both.built.joints.append(Joint(kind, last, name, at, along))
        last = name
    for side in sides:
        side.rod("leaf_front", CHASSIS, "axle")
        side.body("shackle")
        side.join("hinge", CHASSIS, "shackle", "shackle_chassis", np.array([0.0, 1, 0]))
        side.rod("leaf_back", "axle", "shackle")
        side.wheel("axle")
        side.seats()
        side.anti_roll_bar()


def build(car, which):
    """The bodies and joints of `left`, `right` or `both`; for both, names end in _left and _right."""
    built = Built()
    endings = {"left": [(False, "")], "right": [(True, "")], "both": [(False, "_left"), (True, "_right")]}[which]
    sides = [Side(car, built, right, ending) for right, ending in endings]
    if car.rack_slides and "tie_rod_inner" in car.points:
        built.bodies["rack"] = Body(car.rack_mass, np.zeros(3), 1e-3 * np.eye(3))
        built.joints.append(Joint("slide", CHASSIS, "rack", np.zeros(3), np.array([0.0, 1, 0])))
    if car.template in AXLES:
        axle(car, built, sides)
    else:
        for side in sides:
            corner(side)
    return built
