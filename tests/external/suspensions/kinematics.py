"""Kinematics of suspensions compared with an independent program.

    kinematics.py --percuss PATH [--count N] [--seed S] [--template NAME]     prints `N passed, N failed`

For each template N random cars: every hardpoint displaced, random wheel, spring, stop and vehicle data, random travel and
rack. All quantities of `percuss kinematics` are compared. The program here shares no code and no method with percuss: the
wheel carrier is one rigid body held by rods, points and lines from the hardpoints (an arm on a hinge is two rods to its
ball joint; Watt's crank is eliminated), closed by Newton's method on their lengths. Velocities are the solution of six linear equations; the second
derivative of a length is a difference of first derivatives. Rockers, struts and links on universal joints follow from the
carrier in closed form. Definitions: docs/howto/KINEMATICS.md. The unsprung mass is that of mechanics.py at the pose of touch.py.
"""

import argparse
import json
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from cars import MIDDLE, build, with_leaf_points
from mechanics import Independent
from sheets import example, written
from touch import Linkage, moved_car

ROOT = Path(__file__).resolve().parents[3]
# Both programs close the loops to some 1e-15 m and solve linear systems of condition up to 1e4; lengths in m, angles in rad.
TOLERANCE = 1e-9
# Longer step of the differences for second derivatives, m; the shorter one is a quarter. Extrapolation removes the error of fourth
# order, which is 1e-6 for a rocker near its dead centre. Rounding: 1e-15 over the shorter step, 2e-11.
STEP = 3e-4
Z = np.array([0.0, 0.0, 1.0])


def cross(v):
    return np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def rotation(v):
    angle = np.linalg.norm(v)
    k = cross(v)
    return np.eye(3) + np.sinc(angle / np.pi) * k + 0.5 * np.sinc(angle / 2 / np.pi) ** 2 * k @ k


def turned(r):
    """Rotation vector of a small rotation, to third order."""
    return 0.5 * np.array([r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]])


def unit(v):
    return v / np.linalg.norm(v)


@dataclass
class Rod:
    """Distance of a chassis point and a carrier point, both as drawn."""

    chassis: np.ndarray
    carrier: np.ndarray
    steers: bool = False


@dataclass
class Coincident:
    """Carrier point that stays at a chassis point."""

    at: np.ndarray


@dataclass
class OnLine:
    """Chassis point on a line of the carrier."""

    top: np.ndarray
    bottom: np.ndarray


@dataclass
class Sliding:
    """Carrier that slides along a line and does not turn."""

    along: np.ndarray


@dataclass
class Planar:
    """Carrier that moves parallel to the middle plane."""


@dataclass
class Watt:
    """Crank on the carrier, about the carrier's x axis at the pivot, with two rods to the chassis: (chassis, crank)."""

    pivot: np.ndarray
    left: tuple
    right: tuple


@dataclass
class Guided:
    """Carrier of which a point stays in the vehicle's middle plane, and which does not pitch: its x axis stays horizontal."""

    point: np.ndarray


# Number of equations of each part.
COUNTS = {Rod: 1, Coincident: 3, OnLine: 2, Sliding: 5, Planar: 3, Watt: 1, Guided: 2}


def across(line):
    """Two directions normal to a line."""
    return np.linalg.svd(line[None])[2][1:]


class Carrier:
    """Rigid body of the wheel carrier (or of the axle) and its constraints; `heights`: carrier points of given height."""

    def __init__(self, constraints, heights):
        self.constraints, self.heights = constraints, heights

    def point(self, pose, x):
        r, c = pose
        return c + r @ x

    def equations(self, pose, travels, rack):
        """Errors, and rows over the angular velocity and the velocity of the origin of the carrier."""
        r, c = pose
        errors, rows = [], []

        def add(error, along, at):
            errors.append(error)
            rows.append(np.concatenate([np.cross(at - c, along), along]))

        for part in self.constraints:
            match part:
                case Rod(chassis, carrier, steers):
                    inner = chassis + rack * np.array([0, 1.0, 0]) * steers
                    at = self.point(pose, carrier)
                    line, length = at - inner, np.linalg.norm(carrier - chassis)
                    add((line @ line - length**2) / (2 * length), line / length, at)
                case Coincident(point):
                    at = self.point(pose, point)
                    for axis in np.eye(3):
                        add(axis @ (at - point), axis, at)
                case OnLine(top, bottom):
                    for e in across(unit(top - bottom)):
                        e, low = r @ e, self.point(pose, bottom)
                        # e · (top − low) = 0, with e and low on the carrier.
                        errors.append(e @ (top - low))
                        rows.append(np.concatenate([np.cross(e, top - low) - np.cross(low - c, e), -e]))
                case Sliding(along):
                    for e, error in zip(np.eye(3), turned(r)):
                        errors.append(error)
                        rows.append(np.concatenate([e, np.zeros(3)]))
                    for e in across(along):
                        add(e @ c, e, c)
                case Planar():
                    small = turned(r)
                    for e, error in ((np.array([1.0, 0, 0]), small[0]), (Z, small[2])):
                        errors.append(error)
                        rows.append(np.concatenate([e, np.zeros(3)]))
                    add(c[1], np.array([0, 1.0, 0]), c)
                case Guided(point):
                    at, x = self.point(pose, point), r @ np.array([1.0, 0, 0])
                    add(at[1], np.array([0, 1.0, 0]), at)
                    errors.append(x[2])
                    rows.append(np.concatenate([np.cross(x, Z), np.zeros(3)]))
                case Watt():
                    error, row = self.watt(pose, part)
                    errors.append(error)
                    rows.append(row)
        for x, travel in zip(self.heights, travels):
            at = self.point(pose, x)
            add(at[2] - x[2] - travel, Z, at)
        return np.array(errors), np.array(rows)

    def watt(self, pose, part):
        """Error of the right rod with the crank at the angle at which the left rod has its length, and its row."""
        r, c = pose
        axis = r @ np.array([1.0, 0, 0])
        angle = 0.0

        def rod(ends):
            chassis, crank = ends
            at = self.point(pose, part.pivot + rotation(np.array([angle, 0, 0])) @ (crank - part.pivot))
            line, length = at - chassis, np.linalg.norm(crank - chassis)
            turn = line @ np.cross(axis, at - self.point(pose, part.pivot)) / length
            return (line @ line - length**2) / (2 * length), turn, np.concatenate([np.cross(at - c, line), line]) / length

        for _ in range(30):
            error, turn, left = rod(part.left)
            angle -= error / turn
            if abs(error) < 1e-16:
                break
        _, turn, left = rod(part.left)
        error, other, right = rod(part.right)
        return error, right - left * other / turn

    def closed(self, travels, rack):
        pose = (np.eye(3), np.zeros(3))
        parts = 20
        for part in range(1, parts + 1):
            for _ in range(30):
                errors, rows = self.equations(pose, [part / parts * t for t in travels], part / parts * rack)
                by = np.linalg.lstsq(rows, -errors, rcond=1e-12)[0]
                pose = (rotation(by[:3]) @ pose[0], pose[1] + by[3:])
                if np.abs(by).max() < 1e-15:
                    break
            assert np.abs(errors).max() < 1e-13, "the loops do not close"
        return pose

    def velocity(self, pose, travels, rack, rates, rack_rate=0.0, held=None):
        """Angular velocity and velocity of the origin at given rates of the heights, or with `held` (row) in their place."""
        _, rows = self.equations(pose, travels, rack)
        target = np.zeros(len(rows))
        count = len(self.heights)
        if held is not None:
            rows = np.vstack([rows[:-count], held])
            # A rod of which the inner end moves: line · v_outer = line · v_inner.
            i = 0
            for part in self.constraints:
                if isinstance(part, Rod) and part.steers:
                    target[i] = rack_rate * rows[i][4]
                i += COUNTS[type(part)]
        else:
            target[-count:] = rates
        solution = np.linalg.lstsq(rows, target, rcond=1e-12)[0]
        return solution[:3], solution[3:]


def linkage(car):
    """Constraints of a template, the points of the arms with their hinges, and the steering axis."""
    p = car.points
    wheel = p["wheel_centre"]
    right = np.diag([1.0, -1, 1])
    arms, axis = {}, None
    if car.template in ("double-wishbone", "double-wishbone-rods", "pushrod-rocker", "pushrod-third-spring"):
        rods = [
            Rod(p["lower_front"], p["lower_ball"]),
            Rod(p["lower_back"], p["lower_ball"]),
            Rod(p["upper_front"], p["upper_ball"]),
            Rod(p["upper_back"], p["upper_ball"]),
            Rod(p["tie_rod_inner"], p["tie_rod_outer"], True),
        ]
        axis = [("carrier", p["lower_ball"]), ("carrier", p["upper_ball"])]
        arms = {"lower_arm": ("lower_front", "lower_back", "lower_ball"), "upper_arm": ("upper_front", "upper_back", "upper_ball")}
    elif car.template == "macpherson-strut":
        rods = [
            Rod(p["lower_front"], p["lower_ball"]),
            Rod(p["lower_back"], p["lower_ball"]),
            OnLine(p["strut_top"], p["strut_bottom"]),
            Rod(p["tie_rod_inner"], p["tie_rod_outer"], True),
        ]
        axis = [("carrier", p["lower_ball"]), ("chassis", p["strut_top"])]
        arms = {"lower_arm": ("lower_front", "lower_back", "lower_ball")}
    elif car.template == "multi-link":
        rods = [
            Rod(p["upper_front"], p["upper_ball"]),
            Rod(p["upper_back"], p["upper_ball"]),
            Rod(p["lateral_chassis"], p["lateral_outer"]),
            Rod(p["trailing_link_chassis"], p["trailing_link_outer"]),
            Rod(p["tie_rod_inner"], p["tie_rod_outer"], True),
        ]
        arms = {"upper_arm": ("upper_front", "upper_back", "upper_ball")}
    elif car.template == "five-link":
        links = ("upper_front_link", "upper_back_link", "lower_front_link", "lower_back_link")
        rods = [Rod(p[f"{link}_chassis"], p[f"{link}_outer"]) for link in links]
        rods.append(Rod(p["tie_rod_inner"], p["tie_rod_outer"], True))
    elif car.template in ("semi-trailing-arm", "twist-beam"):
        rods = [Coincident(p["arm_outer"]), Coincident(p["arm_inner"])]
    elif car.template == "swing-axle":
        rods = [Coincident(p["pivot_front"]), Coincident(p["pivot_back"])]
    elif car.template == "rear-four-bar":
        ends = (("lower_pivot", "lower_link_end"), ("rocker_pivot", "rocker_triangle"))
        rods = [Planar(), *(Rod(p[one], p[other]) for one, other in ends)]
    elif car.template in ("swing-arm", "rear-rocker-on-frame", "rear-rocker-on-arm"):
        rods = [Coincident(p["swing_arm_left"]), Coincident(p["swing_arm_right"])]
    elif car.template == "telescopic-fork":
        rods = [Sliding(unit(p["fork_top"] - p["fork_bottom"]))]
        axis = [("chassis", p["steering_bottom"]), ("chassis", p["steering_top"])]
    elif car.template == "three-link":
        rods = [
            Coincident(p["arm_chassis"]),
            Rod(p["upper_link_chassis"], p["upper_link_outer"]),
            Rod(p["lower_link_chassis"], p["lower_link_outer"]),
        ]
    elif car.template == "solid-axle-four-links":
        rods = []
        for link in ("lower_link", "upper_link"):
            inner, outer = p[f"{link}_chassis"], p[f"{link}_outer"]
            rods += [Rod(inner, outer), Rod(right @ inner, right @ outer)]
        return Carrier(rods, [wheel, right @ wheel]), arms, axis
    elif car.template in ("solid-axle-panhard", "solid-axle-de-dion"):
        inner, outer = p["lower_link_chassis"], p["lower_link_outer"]
        rods = [
            Rod(inner, outer),
            Rod(right @ inner, right @ outer),
            Rod(p["middle_link_chassis"], p["middle_link_axle"]),
            Rod(p["panhard_chassis"], p["panhard_axle"]),
        ]
        return Carrier(rods, [wheel, right @ wheel]), arms, axis
    elif car.template == "solid-axle-leaf-springs":
        p = with_leaf_points(p)
        eye, joint = p["leaf_front_eye"], p["leaf_front_joint"]
        rods = [Rod(eye, joint), Rod(right @ eye, right @ joint), Guided(p["leaf_roll_point"])]
        return Carrier(rods, [wheel, right @ wheel]), arms, axis
    elif car.template == "solid-axle-watt":
        inner, outer = p["lower_link_chassis"], p["lower_link_outer"]
        rods = [
            Rod(inner, outer),
            Rod(right @ inner, right @ outer),
            Rod(p["middle_link_chassis"], p["middle_link_axle"]),
            Watt(p["watt_pivot"], *((p[f"watt_{side}_chassis"], p[f"watt_{side}_crank"]) for side in ("left", "right"))),
        ]
        return Carrier(rods, [wheel, right @ wheel]), arms, axis
    else:
        raise ValueError(car.template)
    return Carrier(rods, [wheel]), arms, axis


# Links that carry springs, dampers and stops here.
CARRIERS = {
    "double-wishbone": ["lower_arm", "upper_arm", "upright"],
    "double-wishbone-rods": ["upright"],
    "macpherson-strut": ["lower_arm", "upright", "strut"],
    "multi-link": ["upper_arm", "upright", "trailing_link"],
    "five-link": ["upright"],
    "semi-trailing-arm": ["trailing_arm"],
    "swing-axle": ["axle_tube"],
    "three-link": ["trailing_arm"],
    "solid-axle-four-links": ["axle"],
    "solid-axle-panhard": ["axle"],
    "solid-axle-de-dion": ["axle"],
    "solid-axle-watt": ["axle"],
    "solid-axle-leaf-springs": ["axle"],
    "pushrod-rocker": ["lower_arm", "upper_arm", "upright", "rocker"],
    "pushrod-third-spring": ["lower_arm", "upper_arm", "upright", "rocker"],
    "twist-beam": ["trailing_arm", "beam"],
    "swing-arm": ["swing_arm"],
    "telescopic-fork": ["fork_lower"],
    "rear-four-bar": ["lower_link", "rear_triangle", "rocker"],
    "rear-rocker-on-frame": ["swing_arm", "rocker"],
    "rear-rocker-on-arm": ["swing_arm", "rocker"],
}
ELEMENTS = {
    "spring": ("spring_seat", "spring_chassis_seat"),
    "damper": ("damper_seat", "damper_chassis_seat"),
    "bump_stop": ("bump_stop_pad", "bump_stop"),
    "rebound_stop": ("rebound_stop_pad", "rebound_stop"),
}


class Suspension:
    """A car at a state, and the motion per wheel travel."""

    def __init__(self, car, forces, travels, rack, rates):
        self.car, self.forces, self.travels, self.rack, self.rates = car, forces, travels, rack, rates
        self.carrier, self.arms, self.axis = linkage(car)
        self.pose = self.carrier.closed(travels, rack)
        self.omega, self.v = self.carrier.velocity(self.pose, travels, rack, rates)

    def at(self, x):
        return self.carrier.point(self.pose, x)

    def speed(self, at, motion=None):
        omega, v = motion or (self.omega, self.v)
        return v + np.cross(omega, at - self.pose[1])

    def on_link(self, link, x, motion=None):
        """Position and velocity of a point of a link."""
        if self.car.template == "rear-four-bar" and link in ("lower_link", "rocker"):
            pivot, end = ("lower_pivot", "lower_link_end") if link == "lower_link" else ("rocker_pivot", "rocker_triangle")
            return self.on_lever(self.car.points[pivot], self.car.points[end], x, motion)
        if link == "rocker":
            return self.on_rocker(x, motion)
        if link in ("strut", "trailing_link"):
            return self.on_universal_joint(link, x, motion)
        if link not in self.arms:
            at = self.at(x)
            return at, self.speed(at, motion)
        front, back, ball = (self.car.points[name] for name in self.arms[link])
        a = unit(back - front)

        def frame(end):
            e = unit(end - front - a * (a @ (end - front)))
            return np.column_stack([a, e, np.cross(a, e)])

        now = self.at(ball)
        at = front + frame(now) @ frame(ball).T @ (x - front)
        lever = np.cross(a, now - front)
        turn = lever @ self.speed(now, motion) / (lever @ lever)
        return at, turn * np.cross(a, at - front)

    def on_lever(self, pivot, end, x, motion):
        """Planar lever from the frame to a point of the carrier."""
        a, now = np.array([0, 1.0, 0]), self.at(end)
        drawn, lever = end - pivot, now - pivot
        angle = np.arctan2(a @ np.cross(drawn, lever), drawn @ lever - drawn[1] * lever[1])
        at = pivot + rotation(angle * a) @ (x - pivot)
        turn = np.cross(a, lever) @ self.speed(now, motion) / (lever @ lever - lever[1] ** 2)
        return at, turn * np.cross(a, at - pivot)

    def on_rocker(self, x, motion):
        """Rocker on its hinge: the rod keeps its length, on the branch as drawn."""
        p = self.car.points
        if "rocker_front" in p:
            pivot, a = p["rocker_front"], unit(p["rocker_back"] - p["rocker_front"])
            outer, v_outer = self.on_link(self.car.on["pushrod"], p["pushrod_outer"], motion)
            return self.rocker(pivot, a, p["pushrod_rocker"], p["pushrod_outer"], outer, v_outer, x)
        pivot, a, end = p["rocker_pivot"], np.array([0, 1.0, 0]), p["rod_rocker"]
        if "rod_arm" in p:
            outer, v_outer = self.on_link("swing_arm", p["rod_arm"], motion)
            return self.rocker(pivot, a, end, p["rod_arm"], outer, v_outer, x)
        # In the frame of the swing arm, the frame's end of the rod moves.
        r, c = self.pose
        fixed = p["rod_frame"]
        at, v = self.rocker(pivot, a, end, fixed, r.T @ (fixed - c), -r.T @ self.speed(fixed, motion), x)
        at = self.at(at)
        return at, self.speed(at, motion) + r @ v

    def rocker(self, pivot, a, end_drawn, outer_drawn, outer, v_outer, x):
        """Point of a rocker about the axis `a` and its velocity; `outer`: other end of its rod."""
        arm = end_drawn - pivot
        length = np.linalg.norm(end_drawn - outer_drawn)

        def parts(outer):
            """|arm turned by θ − (outer − pivot)|² = length² as cosine, sine and constant."""
            d = outer - pivot
            flat, along = arm - a * (a @ arm), a @ arm
            constant = (arm @ arm + d @ d - length**2) / 2 - along * (a @ d)
            return flat @ d, np.cross(a, flat) @ d, constant

        def angles(outer):
            cosine, sine, constant = parts(outer)
            middle, half = np.arctan2(sine, cosine), np.arccos(constant / np.hypot(cosine, sine))
            return [(angle + np.pi) % (2 * np.pi) - np.pi for angle in (middle - half, middle + half)]

        branch = int(np.argmin(np.abs(angles(outer_drawn))))
        r = rotation(angles(outer)[branch] * a)
        end, at = pivot + r @ arm, pivot + r @ (x - pivot)
        line = end - outer
        turn = line @ v_outer / (line @ np.cross(a, end - pivot))
        return at, turn * np.cross(a, at - pivot)

    def on_universal_joint(self, link, x, motion):
        """Link on a universal joint at the chassis; its line is that of the carrier's strut, or ends at a carrier point. The
        first pin is normal to the line as drawn and to the vehicle's x, the second one normal to the line and to the first."""
        p = self.car.points
        if link == "strut":
            base, drawn = p["strut_top"], unit(p["strut_top"] - p["strut_bottom"])
            line = self.pose[0] @ drawn
            rate = np.cross((motion or (self.omega, self.v))[0], line)
        else:
            base, outer = p["trailing_link_chassis"], p["trailing_link_outer"]
            drawn, now = unit(outer - base), self.at(outer)
            line, v = unit(now - base), self.speed(now, motion)
            rate = (v - line * (line @ v)) / np.linalg.norm(now - base)
        stated = self.car.bodies[link].pin
        first = unit(np.cross(drawn, [1.0, 0, 0]) if stated is None else stated)

        def frame(line):
            second = unit(np.cross(line, first))
            return np.array([line, second, np.cross(line, second)])

        rows = frame(line)
        across = np.cross(line, first)
        second_rate = np.cross(rate, first)
        second_rate = (second_rate - rows[1] * (rows[1] @ second_rate)) / np.linalg.norm(across)
        rates = [rate, second_rate, np.cross(rate, rows[1]) + np.cross(line, second_rate)]
        omega = 0.5 * sum(np.cross(e, de) for e, de in zip(rows, rates))
        at = base + rows.T @ frame(drawn) @ (x - base)
        return at, np.cross(omega, at - base)

    def third_spring(self):
        """Compression of the spring to the mirror image of its seat, in heave, per travel; and the compression."""
        seat = self.car.points["third_spring_seat"]
        at, v = self.on_link(self.car.on["third_spring"], seat)
        side = np.sign(at[1])
        return -2 * side * v[1] / self.rates[0], 2 * (abs(seat[1]) - abs(at[1]))

    def element(self, name, mirror=False):
        """Compression per travel of the own wheel, and compression, of a spring, damper or stop."""
        pad, face = (self.car.points[key] for key in ELEMENTS[name])
        rate = self.rates[1 if mirror else 0]
        if mirror:
            pad, face = pad * [1, -1, 1], face * [1, -1, 1]
        at, v = self.on_link(self.car.on[name], pad)
        if name in ("spring", "damper"):
            line = face - at
            return unit(line) @ v / rate, np.linalg.norm(face - pad) - np.linalg.norm(line)
        stop = self.car.stops[name]
        normal = unit(face - pad) if stop.direction is None else stop.direction
        if mirror and stop.direction is not None:
            normal = normal * [1, -1, 1]
        gap = normal @ (face - pad) if stop.gap is None else stop.gap
        return normal @ v / rate, normal @ (at - pad) - gap

    def moved(self, by):
        travels = [t + by * r for t, r in zip(self.travels, self.rates)]
        return Suspension(self.car, self.forces, travels, self.rack, self.rates)


def frequencies(k, mu, ms, kt):
    a = np.array([[k / ms, -k / ms], [-k / mu, (k + kt) / mu]])
    return np.sqrt(np.sort(np.linalg.eigvals(a).real)) / (2 * np.pi)


def expected_values(s, data, drawn):
    """All quantities of all wheels, by name."""
    car, values = s.car, {}
    axle, middle = len(s.rates) == 2, car.template in MIDDLE
    toe, camber = car.wheel.toe, car.wheel.camber
    out = np.array([np.sin(toe) * np.cos(camber), np.cos(toe) * np.cos(camber), -np.sin(camber)])
    ends = ["_left", "_right"] if axle else [""]
    lines = []
    roll = s if not axle else Suspension(car, s.forces, s.travels, s.rack, [1.0, -1.0])
    nearby = {by: s.moved(by * STEP) for by in (-2, -1, -0.5, -0.25, 0.25, 0.5, 1, 2)}

    def slope(of):
        wide, narrow = (
            (of(nearby[-2 * part]) - 8 * of(nearby[-part]) + 8 * of(nearby[part]) - of(nearby[2 * part])) / (12 * part * STEP)
            for part in (1, 0.25)
        )
        return narrow + (narrow - wide) / (4**4 - 1)

    rate_sum = 0.0
    for k, end in enumerate(ends):
        sign = 1 - 2 * k
        flip = np.array([1.0, sign, 1.0])
        rate = s.rates[k]

        def add(name, value):
            values[name + end] = value

        centre = s.at(car.points["wheel_centre"] * flip)
        spin = s.pose[0] @ (out * flip)

        def contact_of(state):
            spin = state.pose[0] @ (out * flip)
            down = unit(spin * spin[2] - Z)
            return state.at(car.points["wheel_centre"] * flip) + car.wheel.radius * down

        contact, before = contact_of(s), contact_of(drawn)
        add("wheel_travel", s.travels[k])
        add("camber", -np.arcsin(spin[2]))
        add("toe", np.arctan2(spin[0], sign * spin[1]))
        spin_rate = np.cross(s.omega, spin) / rate
        flat = spin[0] ** 2 + spin[1] ** 2
        add("camber_gradient", -spin_rate[2] / np.sqrt(1 - spin[2] ** 2))
        add("toe_gradient", sign * (spin_rate[0] * spin[1] - spin[0] * spin_rate[1]) / flat)
        add("half_track_change", sign * (contact - before)[1])
        add("forward_displacement", (contact - before)[0])
        v = s.speed(contact) / rate
        if not axle and not middle:
            tilt = s.omega[0] / rate
            add("instant_centre_distance", sign * v[2] / tilt)
            add("instant_centre_height", v[1] / tilt)
        add("side_view_angle", np.arctan2(v[0], v[2]))
        vc = s.speed(centre) / rate
        add("side_view_angle_centre", np.arctan2(vc[0], vc[2]))
        along = 1.0 if data["front"] else -1.0
        share = data["bias"] if data["front"] else 1 - data["bias"]
        leverage = data["wheelbase"] / data["height"]
        brake = vc if data["inboard_brakes"] else v
        drive = vc if data["inboard_drive"] else v
        add("anti_dive" if data["front"] else "anti_lift_braking", along * share * leverage * brake[0] / brake[2])
        add("anti_lift_driving" if data["front"] else "anti_squat", along * data["drive"] * leverage * drive[0] / drive[2])
        if s.axis or car.template in ("multi-link", "five-link"):
            if s.axis:
                lower, upper = (s.at(x) if on == "carrier" else x for on, x in s.axis)
                point, k_axis = lower, unit(upper - lower)
            else:
                pad, face = (car.points[key] for key in ELEMENTS["spring"])
                # The row of the spring's length over the twist of the carrier, by unit twists.
                row = []
                for i in range(6):
                    twist = np.eye(6)[i]
                    at, vs = s.on_link(car.on["spring"], pad, (twist[:3], twist[3:]))
                    row.append(unit(face - at) @ vs)
                omega, vo = s.carrier.velocity(s.pose, s.travels, s.rack, None, 1.0, np.array(row))
                at_centre = vo + np.cross(omega, centre - s.pose[1])
                point, k_axis = centre + np.cross(omega, at_centre) / (omega @ omega), unit(omega)
            k_axis = k_axis * np.sign(k_axis[2])
            add("caster", np.arctan2(-k_axis[0], k_axis[2]))
            add("kingpin_inclination", np.arctan2(-sign * k_axis[1], k_axis[2]))
            hit = point + k_axis * (contact[2] - point[2]) / k_axis[2] - contact
            outward = unit(spin * [1, 1, 0])
            forward = sign * np.cross(outward, Z)
            add("scrub_radius", -hit @ outward)
            add("mechanical_trail", hit @ forward)
        for name in ELEMENTS:
            mirror = k == 1
            ratio, compression = s.element(name, mirror)
            add(f"motion_ratio_{name}", ratio)
            if middle and name in ("spring", "damper"):
                add(f"leverage_ratio_{name}", 1 / ratio)
            if name == "damper":
                continue
            force, stiffness = s.forces[name](compression)
            add(f"force_{name}", force)
            rate_sum += stiffness * ratio**2 + force * slope(lambda state: state.element(name, mirror)[0] * rate)
        if car.template == "pushrod-third-spring":
            ratio, compression = s.third_spring()
            add("motion_ratio_third_spring", ratio)
            force, stiffness = s.forces["third_spring"](compression)
            add("force_third_spring", force)
            rate_sum += 0.5 * (stiffness * ratio**2 + force * slope(lambda state: state.third_spring()[0] * rate))
        vr = roll.speed(contact)
        lines.append((contact, -vr[1] / vr[2]))
    for end in ends:
        values["wheel_rate" + end] = rate_sum / len(ends)
    if axle:
        (l, ml), (r, mr) = lines
        # The point of the axle's roll motion without velocity, in the front view of the contact points' plane.
        y = (r[2] - l[2] + ml * l[1] - mr * r[1]) / (ml - mr)
        ground = l[2] + (y - l[1]) * (r[2] - l[2]) / (r[1] - l[1])
        values["roll_centre_lateral"], values["roll_centre_height"] = y, l[2] + ml * (y - l[1]) - ground
    elif not middle:
        (at, m) = lines[0]
        values["roll_centre_lateral"], values["roll_centre_height"] = 0.0, -at[1] * m
    return values


def unsprung(car, travels, rates):
    """Masses at the contact patches at wheel travels: m̄ of one wheel; of two wheels on an axle that move with the rates s,
    mᵢ = sᵢ Σ (Λ⁻¹)ᵢⱼ sⱼ with the inverse masses Λ = J M⁻¹ Jᵀ."""
    ends = ["_left", "_right"] if len(travels) == 2 else [""]
    built = build(car, "both" if len(travels) == 2 else "left")
    linkage = Linkage(built)
    centres = [built.frames[f"wheel_centre{end}"] for end in ends]
    pose = linkage.drawn()
    for part in range(1, 11):

        def heights(pose, part=part):
            errors, rows = [], []
            for (link, centre), travel in zip(centres, travels):
                index = linkage.group[link]
                at = linkage.point(pose, index, centre)
                rows.append(np.zeros(linkage.width))
                linkage.add_point(rows[-1], pose, index, at, Z)
                errors.append(at[2] - centre[2] - part / 10 * travel)
            return np.array(errors), rows

        pose = linkage.closed(pose, heights, 30)
        assert pose is not None, "the loops do not close"
    there = moved_car(linkage, pose)
    own = Independent(there)

    def lowest(end):
        """Lowest point of a wheel at the pose: not the point that was lowest as drawn."""
        link, centre = there.frames[f"wheel_centre{end}"]
        radius = np.linalg.norm(there.frames[f"contact_patch{end}"][1] - centre)
        spin = next(j.along for j in there.joints if j.kind == "hinge" and j.second == f"spindle{end}")
        return link, centre + radius * unit(spin * spin[2] - Z)

    patches = [lowest(end) for end in ends]
    jacobian = np.array([own.velocities.moving(link, at, Z) @ own.free for link, at in patches])
    masses = np.linalg.inv(jacobian @ np.linalg.solve(own.mass, jacobian.T))
    return np.array(rates) * (masses @ rates)


def random_car(rng, template):
    car = example(ROOT / "models/suspensions" / f"{template}.toml")
    for name in car.points:
        car.points[name] = car.points[name] + rng.uniform(-0.02, 0.02, size=3)
    if template in MIDDLE:
        car.points["wheel_centre"][1] = 0.0
    for name in (*ELEMENTS, *(name for name in ("third_spring",) if name in car.on)):
        car.on[name] = str(rng.choice(CARRIERS[template]))
    if "pushrod" in car.on:
        car.on["pushrod"] = str(rng.choice(["lower_arm", "upper_arm", "upright"]))
    car.wheel.camber, car.wheel.toe = np.radians(rng.uniform(-3, 3, size=2))
    car.wheel.radius *= rng.uniform(0.9, 1.1)
    for name in ("bump_stop", "rebound_stop"):
        car.stops[name].gap = float(rng.uniform(-0.01, 0.02))
    return car


def random_forces(rng, springs):
    """Force and rate over the compression, and the lines of the sheet."""
    forces, lines = {}, {}
    for name in springs:
        rate, preload = rng.uniform(1e4, 6e4), rng.uniform(-500, 4000)
        forces[name] = lambda x, rate=rate, preload=preload: (preload + rate * x, rate)
        lines[name] = f'rate = "{rate!r} N/m"\npreload = {preload!r}'
    for name in ("bump_stop", "rebound_stop"):
        x = np.concatenate([[0.0], np.cumsum(rng.uniform(0.004, 0.02, size=3))])
        f = np.concatenate([[0.0], np.cumsum(rng.uniform(50, 900, size=3))])

        def force(c, x=x, f=f):
            if c < 0:
                return 0.0, 0.0
            i = min(int(np.searchsorted(x, c, side="right")), len(x) - 1)
            slope = (f[i] - f[i - 1]) / (x[i] - x[i - 1])
            return f[i - 1] + slope * (c - x[i - 1]), slope

        forces[name] = force
        listed = ", ".join(repr(float(1e3 * y)) for y in x)
        lines[name] = f"deflections = [{listed}]\nforces = [{', '.join(repr(float(y)) for y in f)}]"
    return forces, lines


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--percuss", required=True)
    parser.add_argument("--count", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--template", choices=sorted(CARRIERS))
    parser.add_argument("--keep", type=Path, help="a folder for the sheets")
    args = parser.parse_args()
    passed, failed, states, unreached, worst, quantities = 0, 0, 0, 0, 0.0, set()
    with tempfile.TemporaryDirectory() as temporary:
        sheet = Path(temporary) / "car.toml"
        for number, template in enumerate(sorted(CARRIERS)):
            if args.template not in (None, template):
                continue
            rng = np.random.default_rng([args.seed, number, 7])
            for i in range(args.count):
                car = random_car(rng, template)
                third = template == "pushrod-third-spring"
                forces, lines = random_forces(rng, ["spring", "third_spring"] if third else ["spring"])
                axle = template.startswith("solid")
                text = written(car, ("mm", "kg m2", False, False), "both" if axle or third else "left")
                for section, more in lines.items():
                    assert f"[{section}]\n" in text
                    text = text.replace(f"[{section}]\n", f"[{section}]\n{more}\n")
                sheet.write_text(text)
                if args.keep:
                    (args.keep / f"{template}-{i}.toml").write_text(text)
                steers = not axle and any(isinstance(c, Rod) and c.steers for c in linkage(car)[0].constraints)
                # Both sides are mirror images in heave without steering.
                rack = float(rng.uniform(-0.02, 0.02)) if steers and not third and rng.integers(2) else 0.0
                rolls = axle and bool(rng.integers(2))
                most = 0.02 if template.startswith(("pushrod", "rear")) else 0.05
                heave, roll = float(rng.uniform(-most, most)), float(rng.uniform(-0.03, 0.03)) if rolls else 0.0
                travels = [heave + roll, heave - roll] if axle else [heave]
                rates = [1.0, -1.0 if rolls else 1.0] if axle else [1.0]
                data = {
                    "front": bool(rng.integers(2)),
                    "bias": rng.uniform(0.2, 0.8),
                    "drive": rng.uniform(0, 1),
                    "height": rng.uniform(0.3, 0.8),
                    "wheelbase": rng.uniform(2, 3),
                    "inboard_brakes": bool(rng.integers(2)),
                    "inboard_drive": bool(rng.integers(2)),
                }
                sprung, tyre = rng.uniform(150, 500), rng.uniform(1e5, 3e5)
                words = ["--axle", "front" if data["front"] else "rear", "--brake-bias", repr(data["bias"])]
                words += ["--drive-share", repr(data["drive"]), "--cg-height", repr(data["height"])]
                words += ["--wheelbase", repr(data["wheelbase"]), "--sprung-mass", repr(sprung), "--tyre-rate", f"{tyre!r}N/m"]
                words += [f"--{flag.replace('_', '-')}" for flag in ("inboard_brakes", "inboard_drive") if data[flag]]
                words += [f"--heave={heave!r}"] + ([f"--steer={rack!r}"] if rack else [])
                words += [f"--roll={roll!r}:{roll!r}:1"] if rolls else []
                done = subprocess.run(
                    [args.percuss, "kinematics", str(sheet), *words, "--format", "json"], capture_output=True, text=True
                )
                where = f"{template} {i}"
                states += 1
                if done.returncode == 1 and "reached" in done.stderr:
                    # The drop link and the anti-roll bar, which this program does not have, are in line in some states.
                    unreached += 1
                    continue
                if done.returncode != 0:
                    failed += 1
                    print(f"FAILED {where}: {done.stderr}", flush=True)
                    continue
                row = json.loads(done.stdout)["rows"][0]
                if rack:
                    # The travel is measured from the steered pose, which depends on the driving joint; the column is
                    # the height over the pose as drawn.
                    travels = [row["wheel_travel"]]
                s = Suspension(car, forces, travels, rack, rates)
                drawn = Suspension(car, forces, [0.0] * len(travels), 0.0, rates)
                expected = expected_values(s, data, drawn)
                if not rack:
                    for end, mass in zip(["_left", "_right"] if axle else [""], unsprung(car, travels, rates)):
                        expected["unsprung_mass" + end] = mass
                        k = expected["wheel_rate" + end]
                        if k > 0:
                            both = frequencies(k, mass, sprung, tyre)
                            expected["body_frequency" + end], expected["wheel_hop_frequency" + end] = both
                if third:
                    shared = {name: x for name, x in expected.items() if name.startswith("roll_centre")}
                    of_wheel = {name: x for name, x in expected.items() if name not in shared}
                    expected = shared | {f"{name}_{side}": x for name, x in of_wheel.items() for side in ("left", "right")}
                for name, value in expected.items():
                    found = row.get(name)
                    # The denominator of a centre (the tilt rate, a difference of slopes) amplifies in proportion to the value.
                    power = 2 if name.startswith(("instant_centre", "roll_centre")) else 1
                    off = np.inf if found is None else abs(found - value) / max(1.0, abs(value)) ** power
                    worst, quantities = max(worst, off if np.isfinite(off) else 0), quantities | {name}
                    good = off <= TOLERANCE
                    passed, failed = passed + good, failed + (not good)
                    if not good:
                        print(f"FAILED {where}: {name}: {found} where {value} is expected ({off:.1e}): {words}", flush=True)
    print(f"{unreached} of {states} states not reached by percuss; at most 2 % are accepted")
    failed += unreached > 0.02 * states
    print(f"{len(quantities)} quantities, largest deviation {worst:.1e} of {TOLERANCE:.0e}")
    print(f"{passed} passed, {failed} failed")
    return 1 if failed or not passed else 0


if __name__ == "__main__":
    sys.exit(main())
