"""Pose at which a stop touches: positions of all bodies, every joint as equations, closed by Newton's method.

No code and no method of percuss: percuss uses joint coordinates and a driving joint; here every body has a rotation and a
translation, and the path is followed by its arc length. Sources: docs/howto/SUSPENSIONS.md ("Stops") for the gap,
docs/reference/SUSPENSIONS.md for the joints.

During the motion the wheels do not spin relative to their carriers and the rack does not steer: these joints are
fixed here. One degree of freedom per side remains. With both sides built, both gaps have the same value along the path.
"""

from dataclasses import replace

import numpy as np

from cars import CHASSIS, Built, Joint, unit
from mechanics import across, cross

# Length for the comparison of rotations with translations, m.
ARM = 0.3
# Arc length of a step: root of the sum of squares over all bodies, m.
STEP, LEAST_STEP, MOST_STEPS = 0.03, 1e-7, 400
# Joints and gaps are closed to this length, m: some hundred roundings of coordinates of a metre.
CLOSED = 1e-13
# Singular values below this part of the largest are zero. Regular poses are above 1e-5.
RANK = 1e-9


class NotReached(Exception):
    """The gap has a minimum above zero on the path; the minimum is `remaining`, m."""

    def __init__(self, remaining):
        super().__init__(f"{1e3 * remaining:.4f} mm of the gap remain")
        self.remaining = remaining


def pins(joint):
    """Pins of a universal joint: as stated, or normal to the line and to the vehicle's x, on the first body; normal to the
    line and to the first pin, on the second body."""
    first = unit(np.cross(joint.along, [1.0, 0, 0])) if joint.pin is None else joint.pin
    return first, np.cross(joint.along, first)


def is_held(joint):
    """True for a joint that does not move on the way to the touch: bearings of the wheels, the rack, fixed joints."""
    is_rack = joint.kind == "slide" and joint.second == "rack"
    return joint.kind == "fixed" or is_rack or joint.kind == "hinge" and joint.second.startswith("spindle")


def rotation(angle):
    """Rotation matrix of a rotation vector (Rodrigues)."""
    size = np.linalg.norm(angle)
    k = cross(angle)
    half = np.sinc(size / (2 * np.pi))
    return np.eye(3) + np.sinc(size / np.pi) * k + 0.5 * half * half * k @ k


class Pose:
    """Rotation R and position c of each rigid group: a point x of the design is at c + R (x − x₀)."""

    def __init__(self, rotations, positions):
        self.rotations, self.positions = rotations, positions


class Linkage:
    """Rigid groups of bodies and the equations of the joints between them."""

    def __init__(self, built):
        self.built = built
        group = {name: name for name in [CHASSIS, *built.bodies]}
        for joint in built.joints:
            if is_held(joint):
                one, other = group[joint.first], group[joint.second]
                one, other = (other, one) if other == CHASSIS else (one, other)
                group = {name: one if of == other else of for name, of in group.items()}
        moving = [name for name in built.bodies if group[name] == name]
        number = {CHASSIS: -1} | {name: i for i, name in enumerate(moving)}
        self.group = {name: number[of] for name, of in group.items()}
        self.origins = np.array([built.bodies[name].com for name in moving])
        self.width = 6 * len(moving)
        # Equations: points that coincide, directions that are perpendicular, points on a line, distances.
        self.equations = [equation for joint in built.joints for equation in self.equations_of(joint)]

    def equations_of(self, joint):
        i, j = self.group[joint.first], self.group[joint.second]
        if i == j:
            return
        at, along = joint.at, joint.along
        if joint.kind == "rod":
            yield "distance", i, at, j, at + along
            return
        if joint.kind in ("cylinder", "slide"):
            for direction in across(along):
                yield "normal", i, at, j, at, direction
        else:
            yield "point", i, at, j, at
        if joint.kind in ("hinge", "cylinder"):
            for direction in across(along):
                yield "perpendicular", i, along, j, direction
        elif joint.kind == "slide":
            x, y, z = np.eye(3)
            yield from (("perpendicular", i, one, j, other) for one, other in ((x, y), (y, z), (z, x)))
        elif joint.kind == "universal":
            yield "perpendicular", i, pins(joint)[0], j, pins(joint)[1]
        else:
            assert joint.kind == "ball", joint.kind

    def drawn(self):
        count = len(self.origins)
        return Pose(np.array([np.eye(3)] * count), self.origins.copy())

    def vector(self, pose, group, direction):
        return direction if group < 0 else pose.rotations[group] @ direction

    def point(self, pose, group, at):
        return at if group < 0 else pose.positions[group] + pose.rotations[group] @ (at - self.origins[group])

    def add_point(self, row, pose, group, at, direction, factor=1.0):
        """Adds the speed of a point (vehicle's axes) along a direction; unknowns: ARM ω, v of each group."""
        if group >= 0:
            row[6 * group :][:3] += factor / ARM * np.array(cross(at - pose.positions[group]) @ direction)
            row[6 * group + 3 :][:3] += factor * direction

    def closure(self, pose):
        """Errors of all equations, m, and their derivatives."""
        errors, rows = [], []
        for kind, i, one, j, other, *rest in self.equations:
            if kind == "perpendicular":
                a, b = self.vector(pose, i, one), self.vector(pose, j, other)
                row = np.zeros(self.width)
                turn = cross(a) @ b
                for group, direction in ((i, turn), (j, -turn)):
                    if group >= 0:
                        row[6 * group :][:3] += direction
                errors.append(ARM * (a @ b))
                rows.append(row)
                continue
            a, b = self.point(pose, i, one), self.point(pose, j, other)
            apart = b - a
            if kind == "point":
                directions = np.eye(3)
                errors += list(apart)
            elif kind == "distance":
                length = np.linalg.norm(apart)
                directions = [apart / length]
                errors.append(length - np.linalg.norm(other - one))
            else:
                direction = self.vector(pose, i, rest[0])
                directions = [direction]
                errors.append(direction @ apart)
            for direction in directions:
                row = np.zeros(self.width)
                # For a normal fixed to the first body, the first body's velocity is taken at the second point.
                self.add_point(row, pose, i, b if kind == "normal" else a, direction, -1.0)
                self.add_point(row, pose, j, b, direction)
                rows.append(row)
        return np.array(errors), np.array(rows)

    def gap(self, pose, stop):
        """Gap of a stop, m, and its derivative."""
        i = self.group[stop.link]
        pad = self.point(pose, i, stop.pad)
        row = np.zeros(self.width)
        if stop.direction is not None:
            drawn = stop.direction @ (stop.face - stop.pad)
            self.add_point(row, pose, i, pad, -stop.direction)
            return stop.direction @ (stop.face - pad) - drawn + stop.gap, row
        line = stop.face - pad
        length, drawn = np.linalg.norm(line), np.linalg.norm(stop.face - stop.pad)
        sense = -1.0 if stop.extends else 1.0
        self.add_point(row, pose, i, pad, -sense * line / length)
        return sense * (length - drawn) + stop.gap, row

    def moved(self, pose, by):
        by = by.reshape(-1, 6)
        rotations = np.array([rotation(turn / ARM) @ r for turn, r in zip(by[:, :3], pose.rotations)])
        return Pose(rotations, pose.positions + by[:, 3:])

    def closed(self, pose, extra, rounds=8):
        """Nearest pose at which all equations and those of `extra` are satisfied; `None` if the iteration does not
        converge."""
        for _ in range(rounds):
            errors, rows = self.closure(pose)
            more, more_rows = extra(pose)
            errors, rows = np.concatenate([errors, more]), np.vstack([rows, *more_rows])
            if np.abs(errors).max() <= CLOSED:
                return pose
            by = np.linalg.lstsq(rows, -errors, rcond=RANK)[0]
            if not np.linalg.norm(by) < 0.3:
                return None
            pose = self.moved(pose, by)
        return None


class PathToTouch:
    """Poses with equal gaps of the stops, one stop per side, by arc length from the design position."""

    def __init__(self, built, names):
        """Stops: names of stops of the built car."""
        self.linkage, self.names, self.stops = Linkage(built), names, [built.stops[name] for name in names]

    def gaps(self, pose):
        found = [self.linkage.gap(pose, stop) for stop in self.stops]
        return np.array([gap for gap, _ in found]), [row for _, row in found]

    def differences(self, pose):
        gaps, rows = self.gaps(pose)
        return gaps[1:] - gaps[:-1], [b - a for a, b in zip(rows, rows[1:])]

    def tangent(self, pose, last):
        """Direction of the path and the rate of the gap along it; `last` is the direction before, if there is one."""
        _, rows = self.linkage.closure(pose)
        _, s, vt = np.linalg.svd(rows)
        rank = int((s > RANK * s[0]).sum())
        free = vt[rank:].T
        if free.shape[1] != len(self.stops):
            raise RuntimeError(f"{free.shape[1]} degrees of freedom without spin and steering, {len(self.stops)} sides")
        _, gap_rows = self.gaps(pose)
        along = np.eye(1)[0]
        if len(self.stops) == 2:
            across_path = (gap_rows[1] - gap_rows[0]) @ free
            if np.linalg.norm(across_path) > 1e-7:
                along = unit(np.array([-across_path[1], across_path[0]]))
            else:
                # Both gaps have their minimum here: the direction is the previous one.
                along = unit(last @ free)
        direction = free @ along
        if last is None:
            direction = -direction if gap_rows[0] @ direction > 0 else direction
        elif direction @ last < 0:
            direction = -direction
        return direction, gap_rows[0] @ direction

    def advanced(self, pose, direction, step):
        """Pose after a step, its direction and rate; `None` if the step is too large for a safe continuation."""
        there = self.linkage.closed(self.linkage.moved(pose, step * direction), self.differences, 5)
        if there is None:
            return None
        further, rate = self.tangent(there, direction)
        return (there, further, rate) if further @ direction > 0.95 else None

    def touch(self):
        """Pose at the first touch."""
        pose = self.linkage.drawn()
        direction, rate = self.tangent(pose, None)
        step = STEP
        for _ in range(MOST_STEPS):
            gap = self.gaps(pose)[0][0]
            if gap <= 0:
                return self.at_touch(pose)
            if rate >= -1e-12:
                raise NotReached(gap)
            # Close to the touch, a step ends there.
            step = min(step, max(1.05 * gap / -rate, 1e-4))
            found = self.advanced(pose, direction, step)
            if found is None:
                step /= 2
                if step < LEAST_STEP:
                    raise RuntimeError("the path cannot be continued")
                continue
            there, further, new_rate = found
            if new_rate >= 0:
                return self.at_minimum(pose, direction, step)
            if self.gaps(there)[0][0] <= 0:
                return self.at_touch(there)
            pose, direction, rate = there, further, new_rate
            step = min(1.5 * step, STEP)
        raise RuntimeError("too many steps")

    def at_touch(self, pose):
        """The touch from a pose next to it, before the minimum of the gap: Newton's method converges to the first touch."""
        touched = self.linkage.closed(pose, self.gaps, 12)
        if touched is None:
            raise RuntimeError("the gap cannot be closed from a pose next to the touch")
        return touched

    def at_minimum(self, pose, direction, step):
        """The touch within a step that passes the minimum of the gap, or an error with the minimum."""
        low, high, least = 0.0, step, np.inf
        # The error of the minimum is of second order in the length of the interval.
        while high - low > 1e-5:
            # At the minimum itself both gaps of a symmetric car are stationary, and their difference is no equation.
            for part in (0.5, 0.4, 0.6, 0.3, 0.7):
                middle = low + part * (high - low)
                found = self.advanced(pose, direction, middle)
                if found is not None:
                    break
            else:
                raise RuntimeError("the minimum of the gap cannot be found")
            there, _, rate = found
            least = self.gaps(there)[0][0]
            if least <= 0 and rate < 0:
                return self.at_touch(there)
            low, high = (middle, high) if rate < 0 else (low, middle)
        raise NotReached(least)


def moved_car(linkage, pose):
    """The built car at a pose: bodies, joints and frames moved."""
    group, point, vector = linkage.group, linkage.point, linkage.vector

    def body(name, given):
        r = vector(pose, group[name], np.eye(3))
        return replace(given, com=point(pose, group[name], given.com), inertia=r @ given.inertia @ r.T)

    def joint(given):
        i, j = group[given.first], group[given.second]
        at = point(pose, j, given.at)
        if given.kind == "rod":
            at = point(pose, i, given.at)
            along = point(pose, j, given.at + given.along) - at
        elif given.kind == "universal":
            first, second = pins(given)
            along = unit(np.cross(vector(pose, i, first), vector(pose, j, second)))
        else:
            along = None if given.along is None else vector(pose, i, given.along)
        return Joint(given.kind, given.first, given.second, at, along)

    built = linkage.built
    return Built(
        {name: body(name, given) for name, given in built.bodies.items()},
        [joint(given) for given in built.joints],
        {name: (link, point(pose, group[link], at)) for name, (link, at) in built.frames.items()},
    )


def normal_at(stop, pad):
    """Direction in which a stop with its pad at a point closes: fixed to the chassis, or along the line of the damper."""
    if stop.direction is not None:
        return stop.direction
    return unit(pad - stop.face if stop.extends else stop.face - pad)
