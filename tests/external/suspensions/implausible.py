"""Plausible cars have results; cars with one mistake of the user have an error or a warning.

    implausible.py --percuss PATH [--count N] [--seed S] [--template NAME]     prints `N passed, N failed`

For each template N random cars of sheets.py: hardpoints, masses and inertias varied, sections omitted, any unit, both axes
conventions, either side described. Each car is written as it is, and once for every mistake of `MISTAKES`. A car with a mistake
must end with exit code 2 or with a warning that the plausible car does not have. Mistakes that leave the car plausible (a sign of a
coordinate near zero, an inertia that hardly changes) are counted, not compared.
"""

import argparse
import copy
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

from cars import AXLES, CARRIERS, MIDDLE
from sheets import INERTIAS, LENGTHS, random_build, random_car, random_spelling, written

ROOT = Path(__file__).resolve().parents[3]
# A wrong sign of a coordinate below this size, m, moves the point by less than twice this length: a small change of design.
LEAST_SIGN = 0.15
# The distance term of an inertia about the wrong point, relative to the inertia, below which the inertia remains that of a body of
# the same size.
LEAST_STEINER = 3.0


def other_unit(rng, car, spelling, text):
    """The sheet states a wrong unit of length."""
    unit = spelling[0]
    other = str(rng.choice([name for name in LENGTHS if name != unit]))
    return text.replace(f'unit = "{unit}"', f'unit = "{other}"', 1)


def other_inertia_unit(rng, car, spelling, text):
    """The sheet states a wrong unit of inertia, larger or smaller by a factor of at least a hundred."""
    unit = spelling[1]
    others = [name for name, value in INERTIAS.items() if max(value / INERTIAS[unit], INERTIAS[unit] / value) > 99]
    return text.replace(f'inertia_unit = "{unit}"', f'inertia_unit = "{rng.choice(others)}"', 1)


def other_sign(rng, car, spelling, text):
    """The lateral coordinate of one hardpoint has the wrong sign."""
    names = [name for name, at in car.points.items() if abs(at[1]) >= LEAST_SIGN]
    if not names:
        return None
    changed = copy.deepcopy(car)
    changed.points[str(rng.choice(names))][1] *= -1
    return changed


def other_height(rng, car, spelling, text):
    """The vertical coordinate of one hardpoint has the wrong sign."""
    names = [name for name, at in car.points.items() if abs(at[2]) >= LEAST_SIGN]
    if not names:
        return None
    changed = copy.deepcopy(car)
    changed.points[str(rng.choice(names))][2] *= -1
    return changed


def other_side(rng, car, spelling, text):
    """The sheet states the wrong side of the vehicle."""
    if car.template in MIDDLE:
        return None
    one, other = ("right", "left") if spelling[3] else ("left", "right")
    return text.replace(f'side = "{one}"', f'side = "{other}"', 1)


def other_axes(rng, car, spelling, text):
    """The sheet states the wrong convention of axes."""
    if car.template in MIDDLE:
        return None
    one, other = ("adams", "iso") if spelling[2] else ("iso", "adams")
    return text.replace(f'axes = "{one}"', f'axes = "{other}"', 1)


def turned(rng, car, spelling, text):
    """The sheet states wrong axes and the wrong side: the car is turned by 180 degrees about z."""
    if car.template in ("solid-axle-four-links", "solid-axle-panhard", "solid-axle-watt", "solid-axle-de-dion"):
        return None  # The links of a solid axle may lie before or behind the axle.
    axes, other_axes = ("adams", "iso") if spelling[2] else ("iso", "adams")
    side, other_side = ("right", "left") if spelling[3] else ("left", "right")
    text = text.replace(f'axes = "{axes}"', f'axes = "{other_axes}"', 1)
    return text.replace(f'side = "{side}"', f'side = "{other_side}"', 1)


def zero_gap(rng, car, spelling, text):
    """The gap of a stop is 0, as in a form that is not filled in."""
    names = [name for name, keys in car.stops.items() if keys.gap is not None]
    if not names:
        return None
    changed = copy.deepcopy(car)
    changed.stops[str(rng.choice(names))].gap = 0.0
    return changed


def grams(rng, car, spelling, text):
    """One mass is in grams."""
    changed = copy.deepcopy(car)
    name = str(rng.choice([*changed.bodies, "wheel"]))
    body = changed.wheel if name == "wheel" else changed.bodies[name]
    body.mass *= 1000
    return changed


def all_grams(rng, car, spelling, text):
    """All masses are in grams, with the inertias as before."""
    changed = copy.deepcopy(car)
    for body in [*changed.bodies.values(), changed.wheel]:
        body.mass *= 1000
    return changed


def tonnes(rng, car, spelling, text):
    """All masses are in tonnes, as in a table in t and mm."""
    changed = copy.deepcopy(car)
    for body in [*changed.bodies.values(), changed.wheel]:
        body.mass /= 1000
    return changed


def about_the_origin(rng, car, spelling, text):
    """One inertia is about the origin of the vehicle."""
    changed = copy.deepcopy(car)
    far = []
    for name, body in changed.bodies.items():
        if body.inertia is None or body.com is None or name == "spindle":
            continue
        added = body.mass * (body.com @ body.com * np.eye(3) - np.outer(body.com, body.com))
        if np.trace(added) >= LEAST_STEINER * np.trace(body.inertia):
            far.append((body, added))
    if not far:
        return None
    body, added = far[int(rng.integers(len(far)))]
    body.inertia = body.inertia + added
    return changed


def replaced(text, section, key, value):
    """The sheet with another value of a key in a section; None without the section."""
    head = f"\n[{section}]\n"
    if head not in text:
        return None
    before, rest = text.split(head, 1)
    lines = rest.split("\n")
    end = next((i for i, line in enumerate(lines) if line.startswith("[")), len(lines))
    kept = [line for line in lines[:end] if not line.startswith(f"{key} = ")]
    return before + head + "\n".join([f"{key} = {value}", *kept, *lines[end:]])


def camber_in_radians(rng, car, spelling, text):
    """The camber of some degrees is written in rad, or has ten times its value."""
    angle = rng.uniform(0.5, 3) * rng.choice([-1, 1])
    return replaced(text, "wheel", "camber", f'"{angle} rad"' if rng.integers(2) else f'"{10 * angle + 8 * np.sign(angle)} deg"')


def wheel_y(rng, car, spelling, text):
    """The lateral coordinate of the wheel centre is ten times too large or too small, or has the wrong sign."""
    if car.template in MIDDLE:
        return None
    changed = copy.deepcopy(car)
    changed.points["wheel_centre"][1] *= rng.choice([10, 0.1, -1])
    return changed


def far_ball(rng, car, spelling, text):
    """A joint of the upright is 0.67 m away from the wheel."""
    names = [name for name in ("lower_ball", "upper_ball") if name in car.points]
    if not names or "upright" not in car.bodies:
        return None
    changed = copy.deepcopy(car)
    name = str(rng.choice(names))
    direction = rng.choice([-1.0, 1.0])
    changed.points[name] = changed.points["wheel_centre"] + np.array([direction * 0.67, -0.04, rng.uniform(-0.1, 0.1)])
    return changed


def gap_in_metres(rng, car, spelling, text):
    """The gap of a stop is a number of metres in a sheet in another unit."""
    names = [name for name, keys in car.stops.items() if keys.gap is not None]
    if not names or spelling[0] in ("m", "in"):
        return None
    changed = copy.deepcopy(car)
    name = str(rng.choice(names))
    # 30 mm are 0.03 mm in a sheet in mm, and 0.3 mm in one in cm.
    changed.stops[name].gap *= LENGTHS[spelling[0]]
    return changed if changed.stops[name].gap < 2e-4 else None


def rate_of_another_unit(rng, car, spelling, text):
    """The rate of the spring is a thousand times too large or too small."""
    return replaced(text, "spring", "rate", '"%g kN/mm"' % rng.uniform(15, 150) if rng.integers(2) else '"%g N/m"' % rng.uniform(15, 150))


def preload_of_another_unit(rng, car, spelling, text):
    """The preload of the spring is a thousand times too large, or in kN without a unit."""
    with_rate = replaced(text, "spring", "rate", '"40 N/mm"')
    value = rng.uniform(2, 9)
    return with_rate and replaced(with_rate, "spring", "preload", f'"{1e3 * value} kN"' if rng.integers(2) else value)


def exchanged_ends(rng, car, spelling, text):
    """The two ends of a lateral rod are exchanged."""
    if car.template in AXLES:
        return None  # The links of an axle may converge at the axle.
    changed = copy.deepcopy(car)
    rods = []
    for outer in car.points:
        rod = outer.removesuffix("_outer")
        inner = next((name for name in (f"{rod}_inner", f"{rod}_chassis") if name in car.points), None)
        if rod == outer or rod in ("anti_roll_bar", "arm") or inner is None:
            continue
        across = abs(car.points[outer][1]) - abs(car.points[inner][1])
        if across > 0.6 * np.linalg.norm(car.points[outer] - car.points[inner]):
            rods.append((outer, inner))
    if not rods:
        return None
    one, other = rods[int(rng.integers(len(rods)))]
    changed.points[one], changed.points[other] = car.points[other], car.points[one]
    return changed


def curve(text, section, deflections, forces):
    with_forces = replaced(text, section, "forces", forces)
    return with_forces and replaced(with_forces, section, "deflections", deflections)


def deflections_in_metres(rng, car, spelling, text):
    """The deflections of the curve of a stop are in m."""
    if spelling[0] not in ("mm", "cm"):
        return None
    return curve(text, "bump_stop", "[0.0, 0.01, %g]" % rng.uniform(0.02, 0.06), "[0.0, 700.0, 5200.0]")


def forces_in_kilonewtons(rng, car, spelling, text):
    """The forces of the curve of a stop are in kN without a unit."""
    depth = rng.uniform(0.02, 0.06) / LENGTHS[spelling[0]]
    return curve(text, "bump_stop", f"[0.0, {depth / 3}, {depth}]", "[0.0, 0.7, %g]" % rng.uniform(2, 9))


def exchanged_seats(rng, car, spelling, text):
    """The points of a spring or damper are exchanged, with their distances from the link far apart."""
    changed = copy.deepcopy(car)
    pairs = [pair for pair in (("spring_seat", "spring_chassis_seat"), ("damper_seat", "damper_chassis_seat")) if pair[0] in car.points]
    # A rod of an axle may be as near to one seat as to the other, and one wheel of an axle has no motion ratio.
    pairs = [pair for pair in pairs if car.template not in AXLES or car.on[pair[0].removesuffix("_seat")] == "axle"]
    if not pairs:
        return None
    one, other = pairs[int(rng.integers(len(pairs)))]
    changed.points[one], changed.points[other] = car.points[other], car.points[one]
    return changed


MISTAKES = [
    other_unit, other_inertia_unit, other_sign, other_height, other_side, other_axes, turned, zero_gap, grams, all_grams, tonnes, about_the_origin,
    camber_in_radians, wheel_y, far_ball, gap_in_metres, rate_of_another_unit, preload_of_another_unit, deflections_in_metres,
    forces_in_kilonewtons, exchanged_seats, exchanged_ends,
]  # fmt: skip


class Family:
    def __init__(self, percuss, folder, keep):
        self.percuss, self.folder, self.keep = percuss, folder, keep
        self.passed, self.failed, self.skipped = 0, 0, 0
        self.cars, self.warned, self.ends = 0, 0, {mistake.__name__: [0, 0, 0] for mistake in MISTAKES}

    def outcome(self, text):
        """Exit code, messages of the warnings about the file and about the results at all contacts, and standard error."""
        sheet = self.folder / "car.toml"
        sheet.write_text(text)
        words = [self.percuss, "mass", str(sheet), "--at", "all", "--format", "json"]
        done = subprocess.run(words, capture_output=True, text=True, encoding="utf-8")
        if done.returncode == 2:
            return 2, [], done.stderr
        found = json.loads(done.stdout)["diagnostics"] if done.stdout else []
        warnings = [each["message"] for each in found if each["severity"] == "warning"]
        return done.returncode, warnings, done.stderr

    def compare(self, rng, car, spelling, which, where):
        text = written(car, spelling, which)
        code, warnings, messages = self.outcome(text)
        self.cars += 1
        self.warned += bool(warnings)
        if warnings and self.keep:
            print(f"{where}: {warnings}")
        self.verdict(code == 0, f"{where}: the plausible car: {messages}", text)
        for mistake in MISTAKES:
            changed = mistake(rng, car, spelling, text)
            if changed is None:
                self.skipped += 1
                continue
            changed = changed if isinstance(changed, str) else written(changed, spelling, which)
            assert changed != text, mistake.__name__
            code, found, messages = self.outcome(changed)
            found = [warning for warning in found if warning not in warnings]
            ends = self.ends[mistake.__name__]
            ends[0 if code == 2 else 1 if found else 2] += 1
            self.verdict(code == 2 or found, f"{where}: {mistake.__name__}: no error and no warning", changed)

    def verdict(self, good, what, text):
        self.passed, self.failed = self.passed + bool(good), self.failed + (not good)
        if not good:
            print(f"FAILED {what}", flush=True)
            if self.keep:
                name = what.split(": ")
                (self.keep / f"{name[0].replace(' ', '-')}-{name[1]}.toml").write_text(text)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--percuss", required=True)
    parser.add_argument("--count", type=int, default=28)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--template", choices=sorted(CARRIERS))
    parser.add_argument("--keep", type=Path, help="a folder for the sheets that fail")
    args = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        family = Family(args.percuss, Path(temporary), args.keep)
        for number, template in enumerate(sorted(CARRIERS)):
            if args.template not in (None, template):
                continue
            rng = np.random.default_rng([args.seed, number, 9])
            for case in range(args.count):
                car = random_car(rng, ROOT / "models/suspensions" / f"{template}.toml")
                which, spelling = random_build(rng, template), random_spelling(rng)
                family.compare(rng, car, spelling, which, f"{template} {case} {spelling}")
    print(f"{family.cars} plausible cars, {family.warned} with a warning; {family.skipped} mistakes leave a car plausible")
    for name, (errors, warnings, silent) in family.ends.items():
        print(f"  {name}: {errors} errors, {warnings} warnings, {silent} silent")
    print(f"implausible cars: {family.passed} passed, {family.failed} failed")
    return 1 if family.failed or not family.passed else 0


if __name__ == "__main__":
    sys.exit(main())
