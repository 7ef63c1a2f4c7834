"""Suspensions of rFactor (.pm) read by percuss, compared with an independent program.

    rfactor.py --percuss PATH [--count N] [--seed S]     prints `N passed, N failed`

For each car a random file: five bars, with common ends on the spindle in every second file, spindle and wheel with masses and inertias, left
and right, front and rear. The effective mass at a random point of the wheel along a random direction is that of both bodies in maximal
coordinates: twelve velocities, five rows of the bars and five of the hinge, 1/(j N (N' M N)^-1 N' j') with the null space N of the rows.
"""

import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

# Both programs solve linear systems of condition up to 1e4.
TOLERANCE = 1e-9
# Ends on body and spindle, m, x left, y up, z backward: upper and lower, front and rear, and the steering arm.
BARS = {
    "upper_front": (0.35, 0.12, -1.75, 0.62, 0.14, -1.58),
    "upper_back": (0.35, 0.12, -1.45, 0.61, 0.15, -1.56),
    "lower_front": (0.25, -0.12, -1.8, 0.66, -0.12, -1.6),
    "lower_back": (0.25, -0.12, -1.4, 0.65, -0.11, -1.58),
    "steering": (0.3, -0.05, -1.72, 0.64, -0.05, -1.74),
}
# From the axes of rFactor to those of ISO 8855.
TO_ISO = np.array([[0.0, 0, -1], [1, 0, 0], [0, 1, 0]])


def cross(v):
    return np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def inertia_about_origin(mass, com, inertia):
    c = cross(com)
    return np.block([[inertia - mass * c @ c, mass * c], [-mass * c, mass * np.eye(3)]])


def row(point, along):
    return np.r_[np.cross(point, along), along]


def text_of(v):
    return "(" + ",".join(repr(float(x)) for x in v) + ")"


def wheel_axes(outward, side):
    """Axes of a wheel: R_z(-toe) R_x(-camber), mirrored for the right side."""
    left = outward * [1, side, 1]
    camber, toe = -np.arcsin(left[2]), np.arctan2(left[0], left[1])
    c, s = np.cos(camber), np.sin(camber)
    about_x = np.array([[1, 0, 0], [0, c, s], [0, -s, c]])
    c, s = np.cos(toe), np.sin(toe)
    about_z = np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])
    mirror = np.diag([1.0, side, 1.0])
    return mirror @ about_z @ about_x @ mirror


def car(rng, number):
    """Text of a file, corner, and the data of the bodies."""
    side, axle = (1 if number % 4 < 2 else -1), ("f" if number % 8 < 4 else "r")
    corner = axle + ("l" if side > 0 else "r")
    bars = {name: np.array(ends) + rng.uniform(-0.02, 0.02, 6) for name, ends in BARS.items()}
    if number % 2:
        for level in ("upper", "lower"):
            bars[f"{level}_back"][3:] = bars[f"{level}_front"][3:]
    for ends in bars.values():
        ends[[0, 3]] *= side
    centre = np.array([side * 0.74, 0.01, -1.6]) + rng.uniform(-0.02, 0.02, 3)
    com = centre + rng.uniform(-0.04, 0.04, 3)
    masses, spindle = rng.uniform(5, 25, 2), rng.uniform(0.02, 0.03, 3)
    wheel = np.array([1.2, 0.7, 0.65]) * rng.uniform(0.9, 1.1)
    axis = np.array([rng.choice([-0.7, 0.7]), *rng.uniform(-0.03, 0.03, 2)])
    text = "[BODY] // the vehicle\nname=body mass=(0.0) inertia=(0,0,0)\npos=(0,0,0) ori=(0,0,0)\n"
    for name, mass, moments, at in (("spindle", masses[0], spindle, com), ("wheel", masses[1], wheel, centre)):
        text += f"[BODY]\nName={corner}_{name} mass=( {float(mass)!r} ) inertia={text_of(moments)}\npos={text_of(at)} ori=(0,0,0)\n"
    text += f"[JOINT&HINGE]\nposbody={corner}_wheel negbody={corner}_spindle pos={corner}_wheel axis={text_of(axis)}\n"
    for name, ends in bars.items():
        named = f"name={corner}_steering " if name == "steering" else ""
        ends_of = (text_of(ends[:3]), text_of(ends[3:]))
        if rng.integers(2):
            text += f"[BAR] // {name}\n{named}posbody=body negbody={corner}_spindle pos={ends_of[0]} neg={ends_of[1]}\n"
        else:
            text += f"[BAR]\n{named}posbody={corner}_spindle negbody=body pos={ends_of[1]} neg={ends_of[0]}\n"
    return text, corner, bars, (com, masses, spindle, wheel, centre, axis, side)


def expected_mass(bars, bodies, point, along):
    com, masses, spindle, wheel, centre, axis, side = bodies
    outward = TO_ISO @ axis / np.linalg.norm(axis)
    axes = wheel_axes(outward * np.sign(outward[1]) * side, side)
    centre, com = TO_ISO @ centre, TO_ISO @ com
    # The wheel of a file turns about x; the directions of the wheel are forward, the spin axis, upward.
    of_wheel = axes @ np.diag(wheel[[2, 0, 1]]) @ axes.T
    mass = np.zeros((12, 12))
    mass[:6, :6] = inertia_about_origin(masses[0], com, TO_ISO @ np.diag(spindle) @ TO_ISO.T)
    mass[6:, 6:] = inertia_about_origin(masses[1], centre, of_wheel)
    rows = []
    for ends in bars.values():
        inner, outer = TO_ISO @ ends[:3], TO_ISO @ ends[3:]
        rows.append(np.r_[row(outer, (outer - inner) / np.linalg.norm(outer - inner)), np.zeros(6)])
    rows += [np.r_[row(centre, e), -row(centre, e)] for e in np.eye(3)]
    rows += [np.r_[e, np.zeros(3), -e, np.zeros(3)] for e in np.linalg.svd(axes[:, 1][None])[2][1:]]
    values = np.linalg.svd(np.array(rows))
    free = values[2][np.sum(values[1] > 1e-9) :].T
    moved = np.r_[np.zeros(6), row(centre + point, along)] @ free
    return 1 / (moved @ np.linalg.solve(free.T @ mass @ free, moved))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--percuss", required=True)
    parser.add_argument("--count", type=int, default=24)
    parser.add_argument("--seed", type=int, default=1)
    args = parser.parse_args()
    rng, passed, failed, worst = np.random.default_rng(args.seed), 0, 0, 0.0
    with tempfile.TemporaryDirectory() as temporary:
        for number in range(args.count):
            text, corner, bars, bodies = car(rng, number)
            (Path(temporary) / "car.pm").write_text(text)
            sheet = Path(temporary) / "car.toml"
            words = ['points = "car.pm"', f'side = "{"left" if corner[1] == "l" else "right"}"', 'axes = "iso"']
            words += [f'worksheet = "{"front" if corner[0] == "f" else "rear"}"']
            sheet.write_text("\n".join(words) + "\n")
            point, along = rng.uniform(-0.3, 0.3, 3), rng.normal(size=3)
            listed = [",".join(repr(float(x)) for x in v) for v in (point, along)]
            command = [args.percuss, "mass", str(sheet), "--link", "wheel_centre", f"--point={listed[0]}", f"--normal={listed[1]}"]
            done = subprocess.run([*command, "--format", "json"], capture_output=True, text=True)
            found = json.loads(done.stdout)["effective_mass"] if done.returncode == 0 else np.inf
            off = abs(found / expected_mass(bars, bodies, point, along / np.linalg.norm(along)) - 1)
            good = off <= TOLERANCE
            passed, failed, worst = passed + good, failed + (not good), max(worst, off)
            if not good:
                print(f"FAILED {number} {corner}: {off:.1e}: {done.stderr}", flush=True)
    print(f"largest deviation {worst:.1e} of {TOLERANCE:.0e}")
    print(f"{passed} passed, {failed} failed")
    return 1 if failed or not passed else 0


if __name__ == "__main__":
    sys.exit(main())
