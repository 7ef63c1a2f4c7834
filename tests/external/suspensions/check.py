"""Imported suspensions compared with the same cars built independently.

    check.py --percuss PATH [--count N] [--seed S] [--template NAME] [--keep FOLDER]     prints `N passed, N failed`

For each template N random sheets: all numbers different, sections omitted at random, any unit, both axes conventions,
either side described, one or both sides built. Three results are compared at the wheel's centre, the contact patch, the
stops and the seats: percuss with the sheet; a URDF+ file of the same car, with a random spanning tree and other link
axes; and a program that shares neither code nor method with percuss (velocities of all bodies, every joint as rows).
The last two interpret a sheet by docs/reference/SUSPENSIONS.md. Mobilities are compared too, and hardpoints moved by --move,
masses and centres of mass given by --link-mass and --link-com. With both sides built, each left contact has the same
mass as the right contact if the car is symmetric. Named contacts (`--at`) are compared in named_contacts.py, with stops at
the pose of the touch (touch.py), with their wheel travels and motion ratios; extremes at the contact patch in extremes.py.
"""

import argparse
import dataclasses
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

from cars import AXLES, CARRIERS, CHASSIS, MIDDLE, build
from mechanics import Independent, Twin
from extremes import compare_extremes
from named_contacts import Tally, compare_named_contacts
from sheets import example, random_build, random_car, random_spelling, to_sheet, written

ROOT = Path(__file__).resolve().parents[3]
# Both programs round at 1e-16; conditions of the reduced mass matrix and of the rows reach some 1e5 together.
TOLERANCE = 1e-9
# Left and right have the same numbers except for signs; the loops' elimination may use another order.
MIRRORED = 1e-12
STOPS = [
    ("bump_stop_pad", "bump_stop"),
    ("rebound_stop_pad", "rebound_stop"),
    ("spring_seat", "spring_chassis_seat"),
    ("damper_seat", "damper_chassis_seat"),
]


def unit(v):
    return v / np.linalg.norm(v)


class Checker:
    def __init__(self, percuss, folder):
        self.percuss, self.folder = percuss, folder
        self.passed, self.failed, self.worst, self.worst_mirrored = 0, 0, 0.0, 0.0
        self.stops = Tally()
        # Number of searches for extremes, and the largest deviation of their masses.
        self.searches, self.extremes = 0, 0.0

    def run(self, *words):
        done = subprocess.run([self.percuss, *words], capture_output=True, text=True, encoding="utf-8")
        return done.returncode, done.stdout, done.stderr

    def verdict(self, good, what):
        good = bool(good)
        self.passed, self.failed = self.passed + good, self.failed + (not good)
        if not good:
            print(f"FAILED {what}", flush=True)
        return good

    def answer(self, model, flags):
        code, out, err = self.run("mass", str(model), *flags, "--format", "json")
        return json.loads(out)["effective_mass"] if code == 0 else err.strip()

    def coms(self, model):
        """Centre of mass of each link with a mass, in its own frame."""
        code, out, _ = self.run("check", str(model), "--format", "json")
        links = json.loads(out)["links"] if code == 0 else []
        return {link["name"]: link["com"] for link in links if link["com"] is not None}

    def freedom(self, model):
        code, out, err = self.run("check", str(model), "--format", "json")
        return json.loads(out)["generic_degrees_of_freedom"] if code == 0 else err.strip()


def contacts(built, rng):
    """Name, link and position of each contact, its direction, and the flags for the contact in the imported model."""
    for ending in ("", "_left", "_right"):
        if f"wheel_centre{ending}" not in built.frames:
            continue
        for pad, stop in STOPS:
            if f"{pad}{ending}" in built.frames:
                link, at = built.frames[f"{pad}{ending}"]
                above = built.frames[f"{stop}{ending}"][1]
                flags = ["--link", f"{pad}{ending}", "--point", "0,0,0", "--along-line", f"{stop}{ending}:0,0,0"]
                yield pad, ending, link, at, unit(above - at), [*flags, "--against", CHASSIS]
        for frame in ("wheel_centre", "contact_patch"):
            link, at = built.frames[f"{frame}{ending}"]
            for direction in (np.array([0.0, 0, 1]), unit(rng.normal(size=3))):
                given = ",".join(repr(float(x)) for x in direction)
                flags = ["--link", f"{frame}{ending}", "--point", "0,0,0", "--normal", given, "--normal-frame", "world"]
                yield frame, ending, link, at, direction, flags


def compare(checker, car, spelling, which, rng, name):
    sheet, model, twin_file = (checker.folder / f"{name}{end}" for end in (".toml", ".urdf", "-twin.urdf"))
    sheet.write_text(written(car, spelling, which))
    code, _, err = checker.run("import", str(sheet), "-o", str(model), "--force")
    if not checker.verdict(code == 0, f"{name}: import: {err}"):
        return
    built = build(car, which)
    own = Independent(built)
    twin = Twin(built, rng)
    twin_file.write_text(twin.xml())
    for file in (model, twin_file):
        found = checker.freedom(file)
        checker.verdict(found == own.freedom, f"{name}: {file.name} has {found} degrees of freedom, {own.freedom} are expected")
    for what, ending, link, at, direction, flags in contacts(built, rng):
        expected = own.effective_mass(link, at, direction)
        for file, words in ((model, flags), (twin_file, twin.contact(link, at, direction))):
            mass = checker.answer(file, words)
            off = abs(mass / expected - 1) if isinstance(mass, float) else np.inf
            checker.worst = max(checker.worst, off) if np.isfinite(off) else checker.worst
            where = f"{name} {spelling} {which}: {file.name}: {what}{ending}"
            checker.verdict(off <= TOLERANCE, f"{where}: {mass} where {expected} is expected ({off:.1e}): {' '.join(words)}")


def changed(checker, car, spelling, which, rng, name):
    """Hardpoints moved, masses and centres of mass changed by the flags, compared with a car that has these values."""
    sheet = checker.folder / f"{name}.toml"
    sheet.write_text(written(car, spelling, which))
    built = build(car, which)
    found = list(contacts(built, rng))
    coms = checker.coms(sheet)

    def ask(kind, flag, given, other):
        what, ending, link, _, direction, flags = found[int(rng.integers(len(found)))]
        frame, stop = f"{what}{ending}", dict(STOPS).get(what)
        at = other.frames[frame][1]
        direction = direction if stop is None else unit(other.frames[f"{stop}{ending}"][1] - at)
        expected = Independent(other).effective_mass(link, at, direction)
        mass = checker.answer(sheet, [*flags, flag, given])
        off = abs(mass / expected - 1) if isinstance(mass, float) else np.inf
        checker.worst = max(checker.worst, off) if np.isfinite(off) else checker.worst
        where = f"{name} {spelling} {which}: {kind}: {what}{ending}"
        checker.verdict(off <= TOLERANCE, f"{where}: {mass} where {expected} is expected ({off:.1e}): {flag} {given}")

    for _ in range(3):
        point, by = str(rng.choice(list(car.points))), rng.uniform(-0.02, 0.02, size=3)
        if car.template in MIDDLE and point == "wheel_centre":
            by[1] = 0.0
        moved = dataclasses.replace(car, points={**car.points, point: car.points[point] + by})
        given = ",".join(repr(float(x)) for x in to_sheet(spelling, point) @ by)
        ask("move", "--move", f"{point}={given}", build(moved, which))
    for _ in range(2):
        link = str(rng.choice([link for link, body in built.bodies.items() if body.mass > 0]))
        body = built.bodies[link]
        mass = float(body.mass * rng.uniform(0.3, 3))
        other = build(car, which)
        other.bodies[link] = dataclasses.replace(body, mass=mass, inertia=body.inertia * mass / body.mass)
        ask("link-mass", "--link-mass", f"{link}={mass!r}", other)
        by = rng.uniform(-0.03, 0.03, size=3)
        other = build(car, which)
        other.bodies[link] = dataclasses.replace(body, com=body.com + by)
        if link in coms:
            given = ",".join(repr(float(x)) for x in np.array(coms[link]) + by)
            ask("link-com", "--link-com", f"{link}={given}", other)
        else:
            checker.verdict(False, f"{name}: no link is named {link}: {list(coms)}")


def mirrored(checker, car, spelling, rng, name):
    """Both sides of a corner: every contact of the left side and its mirror image."""
    sheet, model = (checker.folder / f"{name}{end}" for end in (".toml", ".urdf"))
    sheet.write_text(written(car, spelling, "both"))
    code, _, err = checker.run("import", str(sheet), "-o", str(model), "--force")
    if not checker.verdict(code == 0, f"{name}: import: {err}"):
        return
    for what, ending, _, _, direction, flags in contacts(build(car, "both"), rng):
        if ending == "_left":
            other = [word.replace("_left", "_right") for word in flags]
            if "--normal" in other:
                other[other.index("--normal") + 1] = ",".join(repr(float(x)) for x in direction * [1, -1, 1])
            left, right = checker.answer(model, flags), checker.answer(model, other)
            off = abs(left / right - 1) if isinstance(left, float) and isinstance(right, float) else np.inf
            checker.worst_mirrored = max(checker.worst_mirrored, off) if np.isfinite(off) else checker.worst_mirrored
            checker.verdict(off <= MIRRORED, f"{name}: {what}: left {left}, right {right} ({off:.1e})")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--percuss", required=True)
    parser.add_argument("--count", type=int, default=12)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--template", choices=sorted(CARRIERS))
    parser.add_argument("--keep", type=Path, help="a folder for the files")
    args = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        folder = args.keep or Path(temporary)
        folder.mkdir(exist_ok=True)
        checker, templates = Checker(args.percuss, folder), 0
        for number, template in enumerate(sorted(CARRIERS)):
            if args.template not in (None, template):
                continue
            path = ROOT / "models/suspensions" / f"{template}.toml"
            templates += 1
            rng = np.random.default_rng([args.seed, number])
            plain = ("mm", "kg m2", False, False)
            which = "both" if template in AXLES else "left"
            for against in (compare, compare_named_contacts):
                against(checker, example(path), plain, which, rng, f"{template}-example")
            for case in range(args.count):
                car = random_car(rng, path)
                which = random_build(rng, template)
                spelling = random_spelling(rng)
                for against in (compare, compare_named_contacts):
                    against(checker, car, spelling, which, rng, f"{template}-{case}")
                changed(checker, car, random_spelling(rng), which, rng, f"{template}-{case}-changed")
                if template not in AXLES:
                    sheet = checker.folder / f"{template}-{case}-extremes.toml"
                    sheet.write_text(written(car, spelling, "left"))
                    checker.searches += compare_extremes(checker, sheet, build(car, "left"), f"{sheet.name} {spelling}")
                if template not in AXLES | MIDDLE and case < 3:
                    mirrored(checker, car, random_spelling(rng), rng, f"{template}-{case}-mirrored")
    print(f"suspensions: off by at most {checker.worst:.1e}; left from right by {checker.worst_mirrored:.1e}")
    print(f"suspensions: {checker.stops.text()}")
    print(f"suspensions: {checker.searches} searches for extremes at the contact patch, off by at most {checker.extremes:.1e}")
    # Each example has two stops; most random cars have two, but few of those of a single template may reach them.
    touched, least = checker.stops.touched(), 2 if args.template else templates * (2 + args.count)
    checker.verdict(touched >= least, f"{touched} stops at the touch, at least {least} are expected")
    # Far from the drawing, where parts turn over.
    most = 1 + touched // 200
    checker.verdict(checker.stops.ended <= most, f"{checker.stops.ended} searches ended before the touch, at most {most} are expected")
    if args.count >= 4 and not args.template:
        every = [*checker.stops.kinds.values(), checker.stops.not_reached, checker.stops.remaining]
        checker.verdict(min(every) > 0, "every kind of stop, and stops that cannot be reached, must be compared")
    print(f"suspensions: {checker.passed} passed, {checker.failed} failed")
    sys.exit(checker.failed > 0 or checker.passed == 0)


if __name__ == "__main__":
    main()
