"""Compares `percuss extremes` at the contact patch with an independent program (poses: touch.py, m̄: mechanics.py).

The driving joint is a hinge between the chassis and a part. At several angles of this part, the independent program closes all joints
and computes m̄ at the lowest point of the wheel. Its m̄ must agree with percuss at both extremes, and at no other angle may it be
smaller than the minimum or larger than the maximum.
"""

import json

import numpy as np

from cars import CHASSIS, unit
from mechanics import Independent
from touch import Linkage, moved_car

# Half of the range of the driving joint, rad, and the number of own positions in it.
REACH, POSITIONS = 0.06, 13
# m̄ at a given position, relative: joints closed to 1e-12 by both programs, times d ln m̄/dq.
AT_POSITION = 1e-9
# The search ends where m̄ changes by less than this part.
BETWEEN = 1e-9


class Driver:
    """Poses of a linkage at angles of a part about its hinge on the chassis."""

    def __init__(self, linkage, part, axis):
        hinges = [j for j in linkage.built.joints if j.kind == "hinge" and {j.first, j.second} == {CHASSIS, part}]
        (joint,) = hinges
        # Only the sense of positive rotation is taken from percuss.
        self.axis = joint.along * np.sign(joint.along @ axis) / np.linalg.norm(joint.along)
        self.across = unit(np.cross(self.axis, [0.6, 0.0, 0.8]))
        self.linkage, self.group = linkage, linkage.group[part]

    def angle(self, pose):
        turned = self.linkage.vector(pose, self.group, self.across)
        return np.arctan2(self.axis @ np.cross(self.across, turned), self.across @ turned)

    def at(self, pose, angle):
        """Pose with this angle, from a pose next to it."""

        def difference(pose):
            row = np.zeros(self.linkage.width)
            # Unknowns of touch.py: 0.3 m times the rotation.
            row[6 * self.group :][:3] = self.axis
            return np.array([0.3 * (self.angle(pose) - angle)]), [row]

        return self.linkage.closed(pose, difference, 20)


def mass_at(linkage, pose):
    """m̄ of the independent program at the lowest point of the wheel, upwards."""
    there = moved_car(linkage, pose)
    drawn = linkage.built
    link, centre = there.frames["wheel_centre"]
    radius = np.linalg.norm(drawn.frames["contact_patch"][1] - drawn.frames["wheel_centre"][1])
    spin = next(j.along for j in there.joints if j.kind == "hinge" and j.second == "spindle")
    z = np.array([0.0, 0.0, 1.0])
    return Independent(there).effective_mass(link, centre + radius * unit(spin * spin[2] - z), z)


def compare_extremes(checker, sheet, built, where):
    """Compares the extremes of a one-sided suspension. False if no driving joint is a hinge on the chassis."""
    code, out, _ = checker.run("check", str(sheet), "--format", "json")
    if code != 0:
        return False
    content = json.loads(out)
    listed = {joint["name"]: joint for joint in content["joints"]}
    hinges = [f"{j.second}_hinge" for j in built.joints if j.kind == "hinge" and j.first == CHASSIS]
    driver = next((name for name in hinges if name in content["drivers"]), None)
    if driver is None or "contact_patch" not in built.frames:
        return False
    part, axis = driver.removesuffix("_hinge"), np.array(listed[driver]["axis"])
    words = ["extremes", str(sheet), "--at", "contact_patch", "--range", f"{driver}={-REACH}:{REACH}", "--format", "json"]
    code, out, err = checker.run(*words)
    if not checker.verdict(code == 0, f"{where}: {' '.join(words)}: {err}"):
        return False
    report = json.loads(out)
    found = [(report[end]["positions"][0]["position"], report[end]["effective_mass"]) for end in ("least", "most")]
    linkage = Linkage(built)
    hinge = Driver(linkage, part, axis)
    angles = sorted([*np.linspace(-REACH, REACH, POSITIONS), *(at for at, _ in found)])
    own, pose = {}, linkage.drawn()
    # From the drawing outwards.
    for side in ([a for a in angles if a >= 0], [a for a in reversed(angles) if a < 0]):
        pose = linkage.drawn()
        for angle in side:
            pose = hinge.at(pose, angle)
            if pose is None:
                break  # The end of reach, or a position next to the end, at which the own Newton's method does not converge.
            own[angle] = mass_at(linkage, pose)
    checker.verdict(len(own) > 2, f"{where}: {driver}: own program: only {len(own)} positions are closed")
    for at, mass in found:
        if at not in own:
            beyond = [angle for angle in own if abs(angle) > abs(at) and angle * at > 0]
            checker.verdict(not beyond, f"{where}: {driver} = {at}: own program: not closed, but it is at {beyond}")
            continue
        off = abs(mass / own[at] - 1)
        checker.extremes = max(checker.extremes, off)
        checker.verdict(off <= AT_POSITION, f"{where}: {driver} = {at}: {mass} where {own[at]} is expected ({off:.1e})")
    least, most = found[0][1] * (1 - BETWEEN), found[1][1] * (1 + BETWEEN)
    inside = all(least <= mass <= most for mass in own.values())
    checker.verdict(inside, f"{where}: own masses {min(own.values())} to {max(own.values())} outside of {least} to {most}")
    return True
