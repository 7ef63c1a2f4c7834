"""Impacts in time with force curves, springs, dampers, tyre and gravity compared with an independent integration.

    curved_contacts.py --percuss PATH [--count N] [--seed S]                  prints `N passed, N failed`

Of N contacts, three fourths are two links in a plane with springs and dampers between points and at the joints, one fourth the contact of a bump stop of
a double wishbone: two arms, upright and wheel in maximal coordinates (positions and unit quaternions, constraints at the level of
accelerations), the tie rod as a rod of constant length, with the spring, its preload, the damper, the tyre that leaves the road, and the stop of the
sheet. The program here shares no code and no method with percuss; scipy integrates with an error of 1e-12 per step (DOP853).
"""

import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import minimize_scalar

ROOT = Path(__file__).resolve().parents[3]
SHEET = ROOT / "models/suspensions/double-wishbone-bushes.toml"
# Restitution; peak force and penetration; balance of energies of percuss, of the kinetic energy before.
RESTITUTION, PEAK, ENERGY = 1e-6, 1e-5, 1e-9
LAWS = ["damping", "hunt-crossley", "loss-factor"]


def number(value):
    return repr(float(value))


def numbers(values):
    return ",".join(number(value) for value in values)


def curve(places, forces, x):
    """Linear between points, with the first and the last slope beyond them."""
    i = min(max(np.searchsorted(places, x, side="right"), 1), len(places) - 1)
    return forces[i - 1] + (x - places[i - 1]) * (forces[i] - forces[i - 1]) / (places[i] - places[i - 1])


class Law:
    """Force of a contact over its penetration and speed."""

    def __init__(self, kind, value, places, forces):
        self.kind, self.value, self.places, self.forces, self.phase = kind, value, places, forces, 1.0

    def force(self, x, rate):
        still = max(0.0, curve(self.places, self.forces, x)) if x > 0 else 0.0
        if self.kind == "damping":
            return still + self.value * rate
        if self.kind == "hunt-crossley":
            return still * max(0.0, 1 + self.value * rate)
        return still * (1 + np.pi / 2 * self.value * self.phase)


def random_law(rng, number_of_case, energy, mass, speed, depth):
    """Law whose curve stores about the kinetic energy over the depth."""
    count = int(rng.integers(2, 6))
    places = np.concatenate([[0], np.cumsum(rng.uniform(0.2, 1, count))])
    forces = np.concatenate([[0], np.cumsum(rng.uniform(0.1, 1, count) * np.arange(1, count + 1))])
    places *= depth / places[-1]
    forces *= 2 * energy / depth / forces[-1] * rng.uniform(0.6, 2.5)
    kind = LAWS[number_of_case % 3]
    value = {"damping": rng.uniform(0.02, 0.4) * 2 * np.sqrt(forces[-1] / places[-1] * mass), "hunt-crossley": rng.uniform(0.05, 2) / speed,
             "loss-factor": rng.uniform(0.02, 0.5)}[kind]
    return Law(kind, value, places, forces)


def integrate(system, law, start, speed, depth):
    """Restitution, largest force and penetration. `system`: rate(y, force) of the state, gap(y): penetration and its rate."""
    time, y, law.phase = 0.0, start, 1.0
    whole = np.pi * depth / speed
    peak, deepest = law.force(0.0, speed), 0.0

    def force(y):
        return law.force(*system.gap(y))

    def end(_, y):
        x, rate = system.gap(y)
        if rate >= 0:
            return 1.0
        return min(law.force(x, rate) / law.forces[-1], x / depth) if law.kind == "damping" else x / depth

    def reversal(_, y):
        return system.gap(y)[1] * law.phase

    end.terminal, end.direction = True, -1
    reversal.terminal, reversal.direction = law.kind == "loss-factor", -1
    for _ in range(12):
        found = solve_ivp(lambda _, y: system.rate(y, force(y)), [time, time + 60 * whole], y, method="DOP853", rtol=1e-12, atol=1e-13,
                          max_step=whole / 60, dense_output=True, events=[end, reversal])
        grid = np.unique(np.concatenate([np.linspace(found.t[i], found.t[i + 1], 5) for i in range(len(found.t) - 1)]))
        for k, of in enumerate((force, lambda y: system.gap(y)[0])):
            values = np.array([of(found.sol(t)) for t in grid])
            top = int(np.argmax(values))
            around = (grid[max(top - 1, 0)], grid[min(top + 1, len(grid) - 1)])
            best = minimize_scalar(lambda t: -of(found.sol(t)), bounds=around, method="bounded", options={"xatol": 1e-13 * whole + 1e-16})
            most = max(values[top], -best.fun)
            peak, deepest = (max(peak, most), deepest) if k == 0 else (peak, max(deepest, most))
        y, time = found.y[:, -1], found.t[-1]
        if len(found.t_events[0]):
            return -system.gap(y)[1] / speed, peak, deepest
        if found.status != 1:
            return None
        law.phase = -law.phase
        # The jump of the force can keep the sides at rest: such a contact has no end here.
        later = y + 1e-9 * whole * system.rate(y, force(y))
        if system.gap(later)[1] * law.phase < 0:
            return None
    return None


class Plane:
    """Two links in the plane of x and z, each on a hinge about y."""

    def __init__(self, rng, case):
        u = rng.uniform
        self.m, self.c, self.i = (u(1, 8), u(0.5, 6)), (u(0.05, 0.3), u(0.05, 0.3)), (u(0.01, 0.1), u(0.005, 0.05))
        self.length, self.q0, self.tip, angle = u(0.2, 0.6), u(-1.2, 1.2, 2), u(0.15, 0.5), u(0, 2 * np.pi)
        self.n = np.array([np.cos(angle), np.sin(angle)])
        self.p0, j = self.point(self.q0, 1, self.tip)
        j = self.n @ j
        self.mass = 1 / (j @ np.linalg.solve(self.mass_matrix(self.q0), j))
        self.speed = u(0.3, 2)
        self.start = np.concatenate([self.q0, self.speed * self.mass * np.linalg.solve(self.mass_matrix(self.q0), j)])
        energy, self.depth = 0.5 * self.mass * self.speed**2, u(2e-3, 15e-3)
        self.law = random_law(rng, case, energy, self.mass, self.speed, self.depth)
        slope = self.law.forces[-1] / self.law.places[-1]
        self.gravity = 9.81 if case % 2 else 0.0
        self.seat, self.anchor = u(0.1, 0.4), u(-0.6, 0.6, 2) + [0, 0.9]
        whole = np.linalg.norm(self.point(self.q0, 1, self.seat)[0] - self.anchor)
        self.rate_of_spring = u(0.002, 0.1) * slope
        self.free = max(whole + u(-0.3, 1) * 0.02 * self.law.forces[-1] / self.rate_of_spring, 0.3 * whole) if case % 4 else None
        self.at_touch = whole
        self.damper_at, self.damper_end = u(0.1, 0.3), u(-0.6, 0.6, 2) - [0, 0.9]
        self.speeds = np.array([-0.5, -0.1, 0, 0.15, 1])
        self.damper = np.array([-3, -1, 0, 2, 4]) * u(0.05, 0.3) * self.mass * self.speed / 0.05
        # Springs of the joints in the model: stiffness, damping, position without force.
        self.joints = [(u(0, 0.3) * slope * 0.01, u(0, 0.2), u(-1, 1)) if rng.random() < 0.7 else None for _ in range(2)]
        self.whole_springs = bool(rng.random() < 0.5)

    def point(self, q, link, x):
        one, both = q[0], q[0] + q[1]
        along, across = np.array([np.cos(one), -np.sin(one)]), np.array([-np.sin(one), -np.cos(one)])
        if link == 0:
            return x * along, np.column_stack([x * across, 0 * across])
        then, turned = np.array([np.cos(both), -np.sin(both)]), np.array([-np.sin(both), -np.cos(both)])
        return self.length * along + x * then, np.column_stack([self.length * across + x * turned, x * turned])

    def mass_matrix(self, q):
        matrix = np.zeros((2, 2))
        for k, turn in ((0, np.array([1, 0])), (1, np.array([1, 1]))):
            j = self.point(q, k, self.c[k])[1]
            matrix += self.m[k] * j.T @ j + self.i[k] * np.outer(turn, turn)
        return matrix

    def gap(self, y):
        p, j = self.point(y[:2], 1, self.tip)
        return self.n @ (p - self.p0), self.n @ j @ y[2:]

    def rate(self, y, force):
        q, u = y[:2], y[2:]
        total = -self.point(q, 1, self.tip)[1].T @ self.n * force
        for link, x, end, of in (
            (1, self.seat, self.anchor, lambda length, _: self.rate_of_spring * ((self.free or self.at_touch) - length)),
            (0, self.damper_at, self.damper_end, lambda _, rate: -curve(self.speeds, self.damper, rate)),
        ):
            p, j = self.point(q, link, x)
            line = p - end
            length = np.linalg.norm(line)
            line = line / length
            total = total + j.T @ line * of(length, line @ j @ u)
        for k, spring in enumerate(self.joints):
            if spring is not None:
                free = spring[2] if self.whole_springs else self.q0[k]
                total[k] += spring[0] * (free - q[k]) - spring[1] * u[k]
        one, both, whole = q[0], q[0] + q[1], u[0] + u[1]
        along, then = np.array([np.cos(one), -np.sin(one)]), np.array([np.cos(both), -np.sin(both)])
        centripetal = (-self.c[0] * along * u[0] ** 2, -self.length * along * u[0] ** 2 - self.c[1] * then * whole**2)
        for k in range(2):
            total = total + self.point(q, k, self.c[k])[1].T @ (self.m[k] * (np.array([0, -self.gravity]) - centripetal[k]))
        return np.concatenate([u, np.linalg.solve(self.mass_matrix(q), total)])

    def words(self, folder):
        link = lambda name, k: (f'<link name="{name}"><inertial><origin xyz="{number(self.c[k])} 0 0"/><mass value="{number(self.m[k])}"/><inertia '
                                + " ".join(f'{key}="{number(self.i[k])}"' for key in ("ixx", "iyy", "izz")) + ' ixy="0" ixz="0" iyz="0"/></inertial></link>')
        spring = lambda k: "" if self.joints[k] is None else (
            f'<dynamics spring_stiffness="{number(self.joints[k][0])}" damping="{number(self.joints[k][1])}" spring_reference="{number(self.joints[k][2])}"/>')
        joint = lambda name, parent, child, at, k: (f'<joint name="{name}" type="continuous"><origin xyz="{number(at)} 0 0"/><parent link="{parent}"/>'
                                                    f'<child link="{child}"/><axis xyz="0 1 0"/>{spring(k)}</joint>')
        path = Path(folder) / "plane.urdf"
        path.write_text('<robot name="plane"><link name="base"/>' + link("a", 0) + link("b", 1) + joint("j1", "base", "a", 0.0, 0)
                        + joint("j2", "a", "b", self.length, 1) + "</robot>")
        of_law = ",".join(f"{number(x)}:{number(f)}" for x, f in zip(self.law.places, self.law.forces))
        of_damper = ",".join(f"{number(v)}:{number(f)}" for v, f in zip(self.speeds, self.damper))
        free = "" if self.free is None else f"={number(self.free)}"
        words = [str(path), "--link", "b", f"--point={number(self.tip)},0,0", f"--normal={number(self.n[0])},0,{number(self.n[1])}", "--normal-frame", "world",
                 f"--set=j1={number(self.q0[0])}", f"--set=j2={number(self.q0[1])}", "--stiffness-curve", of_law,
                 f"--spring=b:{number(self.seat)},0,0=base:{number(self.anchor[0])},0,{number(self.anchor[1])}={number(self.rate_of_spring)}{free}",
                 f"--damper=a:{number(self.damper_at)},0,0=base:{number(self.damper_end[0])},0,{number(self.damper_end[1])}={of_damper}"]
        if any(self.joints) and self.whole_springs:
            words += ["--springs", "full"]
        return words + ([f"--gravity=0,0,{-self.gravity}"] if self.gravity else [])


def cross(v):
    return np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def rotation(q):
    w, v = q[0], q[1:]
    return np.eye(3) + 2 * w * cross(v) + 2 * cross(v) @ cross(v)


class Car:
    """Corner with a double wishbone. Bodies: lower and upper arm, upright, wheel; state: position, quaternion, velocity, angular velocity of each."""

    NAMES = ["lower_arm", "upper_arm", "upright", "wheel"]

    def __init__(self, rng, case):
        u = rng.uniform
        text = SHEET.read_text()
        text = text[: text.index("# Bushes at hardpoints")]
        drop = ("anti_roll_bar_outer", "anti_roll_bar_inner", "drop_link_bar", "drop_link_end", "rebound_stop_pad", "rebound_stop ")
        lines, skipped = [], False
        for line in text.split("\n"):
            if line.startswith("["):
                skipped = line.split("#")[0].strip() in ("[anti_roll_bar]", "[drop_link]", "[rebound_stop]", "[rack]")
            key, found, rest = line.partition(" = [")
            if found and not skipped and key in ("lower_front", "lower_back", "lower_ball", "upper_front", "upper_back", "upper_ball", "tie_rod_inner",
                                                 "tie_rod_outer", "spring_seat", "spring_chassis_seat", "damper_seat", "damper_chassis_seat", "bump_stop_pad"):
                values = [float(x) + u(-12, 12) for x in rest.split("]")[0].split(",")]
                line = f"{key} = {values}"
            if not skipped and not line.startswith(drop):
                lines.append(line)
        text = "\n".join(lines)
        import tomllib

        sheet = tomllib.loads(text)
        self.at = {name: np.array(point) * 1e-3 for name, point in sheet["points"].items()}
        bodies = [sheet[name] for name in ("lower_arm", "upper_arm", "upright")]
        masses = [body["mass"] for body in bodies] + [sheet["spindle"]["mass"] + sheet["wheel"]["mass"]]
        centres = [np.array(body["com"]) * 1e-3 for body in bodies] + [self.at["wheel_centre"]]
        def matrix(i):
            i = list(i) + [0] * (6 - len(i))
            return np.array([[i[0], i[3], i[4]], [i[3], i[1], i[5]], [i[4], i[5], i[2]]])
        inertias = [matrix(body["inertia"]) for body in bodies]
        inertias.append(matrix(sheet["spindle"]["inertia"]) + matrix(sheet["wheel"]["inertia"]))
        # A slender rod with one end at rest is a third of its mass at the other end.
        self.rod = sheet["tie_rod"]["mass"]
        self.m, self.centres, self.inertias = np.array(masses), centres, inertias
        local = lambda k, name: self.at[name] - centres[k]
        self.local = {(k, name): local(k, name) for k in range(4) for name in self.at}
        self.hinges = []
        for k, (front, back) in ((0, ("lower_front", "lower_back")), (1, ("upper_front", "upper_back"))):
            axis = self.at[back] - self.at[front]
            axis /= np.linalg.norm(axis)
            one = np.cross(axis, [0.3, 0.5, -0.8])
            one /= np.linalg.norm(one)
            self.hinges.append((k, front, back, one, np.cross(axis, one)))
        self.rod_length = np.linalg.norm(self.at["tie_rod_outer"] - self.at["tie_rod_inner"])
        normal = self.at["bump_stop"] - self.at["bump_stop_pad"]
        self.n = normal / np.linalg.norm(normal)
        gap = sheet["bump_stop"]["gap"] * 1e-3
        pose = np.concatenate([np.concatenate([centre, [1, 0, 0, 0]]) for centre in centres])
        self.touch = pose = self.move_to_touch(pose, gap)
        mass, g, _, _ = self.equations(pose, np.zeros(24))
        j = self.closing(pose)
        self.speed = u(0.3, 2.5)
        kkt = np.block([[mass, g.T, j[:, None]], [g, np.zeros((len(g), len(g) + 1))], [j[None, :], np.zeros((1, len(g) + 1))]])
        right = np.zeros(len(kkt))
        right[-1] = self.speed
        velocity = np.linalg.lstsq(kkt, right, rcond=None)[0][:24]
        self.mass = velocity @ mass @ velocity / self.speed**2
        self.start = np.concatenate([pose, velocity])
        energy, self.depth = 0.5 * self.mass * self.speed**2, u(8e-3, 30e-3)
        self.law = random_law(rng, case, energy, self.mass, self.speed, self.depth)
        self.whole = bool(rng.random() < 0.5)
        self.spring = (u(2e4, 8e4), u(1e3, 6e3))
        self.speeds = np.array([-1, -0.2, 0, 0.15, 1.0])
        self.damper = np.array([-900, -300, 0, 500, 1800]) * u(0.3, 1.5)
        self.tyre = (u(1.5e5, 3e5), u(0, 400), u(500, 5000))
        self.gravity = 9.81 if case % 2 else 0.0
        seats = lambda p, seat, end: np.linalg.norm(self.point(p, 0, seat)[0] - self.at[end])
        drawn = np.concatenate([np.concatenate([centre, [1, 0, 0, 0]]) for centre in centres])
        self.spring_at_touch = seats(pose, "spring_seat", "spring_chassis_seat")
        self.spring_drawn = seats(drawn, "spring_seat", "spring_chassis_seat")
        self.height = self.point(pose, 3, "wheel_centre")[0][2]
        keep = [("[spring]", f'rate = "{number(self.spring[0])} N/m"\npreload = "{number(self.spring[1])} N"'),
                ("[damper]", f"speeds = {self.speeds.tolist()}\nforces = {self.damper.tolist()}"),
                ("[bump_stop]", f"deflections = {(1e3 * self.law.places).tolist()}\nforces = {self.law.forces.tolist()}")]
        for head, more in keep:
            text = text.replace(head + "\n", head + "\n" + more + "\n", 1)
        stiffness, damping, load = self.tyre
        self.text = text + f'\n[tyre]\nvertical = "{number(stiffness)} N/m"\ndamping = "{number(damping)} N·s/m"\nload = "{number(load)} N"\n'

    def point(self, pose, k, name):
        """Position in the world, and arm from the centre of mass."""
        arm = rotation(pose[7 * k + 3:7 * k + 7]) @ self.local[k, name]
        return pose[7 * k:7 * k + 3] + arm, arm

    def closing(self, pose):
        row = np.zeros(24)
        arm = self.point(pose, 0, "bump_stop_pad")[1]
        row[:3], row[3:6] = self.n, np.cross(arm, self.n)
        return row

    def constraints(self, pose, v):
        """Errors, rows, and right sides of the accelerations."""
        errors, rows, right = [], [], []
        def add(error, terms, quadratic):
            """terms: (body, direction, arm) of n·ẍ; quadratic: part of the second derivative without accelerations."""
            row = np.zeros(24)
            for k, direction, arm in terms:
                row[6 * k:6 * k + 3] += direction
                row[6 * k + 3:6 * k + 6] += np.cross(arm, direction)
            errors.append(error)
            rows.append(row)
            right.append(-quadratic)
        omega = lambda k: v[6 * k + 3:6 * k + 6]
        swing = lambda k, arm: np.cross(omega(k), np.cross(omega(k), arm))
        speed = lambda k, arm: v[6 * k:6 * k + 3] + np.cross(omega(k), arm)
        for k, front, back, one, two in self.hinges:
            for name, axes in ((front, np.eye(3)), (back, (one, two))):
                at, arm = self.point(pose, k, name)
                for axis in axes:
                    add(axis @ (at - self.at[name]), [(k, axis, arm)], axis @ swing(k, arm))
        for a, b, name in ((0, 2, "lower_ball"), (1, 2, "upper_ball"), (2, 3, "wheel_centre")):
            (at, arm), (to, other) = self.point(pose, a, name), self.point(pose, b, name)
            for axis in np.eye(3):
                add(axis @ (at - to), [(a, axis, arm), (b, -axis, other)], axis @ (swing(a, arm) - swing(b, other)))
        # The spin axis of the wheel stays along y of the upright.
        upright, wheel = (rotation(pose[7 * k + 3:7 * k + 7]) for k in (2, 3))
        y = wheel[:, 1]
        dy = np.cross(omega(3), y)
        for x in (upright[:, 0], upright[:, 2]):
            dx = np.cross(omega(2), x)
            row = np.zeros(24)
            row[15:18], row[21:24] = np.cross(x, y), np.cross(y, x)
            errors.append(x @ y)
            rows.append(row)
            right.append(-(np.cross(omega(2), dx) @ y + 2 * dx @ dy + x @ np.cross(omega(3), dy)))
        at, arm = self.point(pose, 2, "tie_rod_outer")
        line = at - self.at["tie_rod_inner"]
        rate = speed(2, arm)
        add(0.5 * (line @ line - self.rod_length**2), [(2, line, arm)], rate @ rate + line @ swing(2, arm))
        return np.array(errors), np.array(rows), np.array(right)

    def equations(self, pose, v):
        """Mass matrix, rows of the constraints, generalised forces without those of the elements, right sides."""
        mass, force = np.zeros((24, 24)), np.zeros(24)
        for k in range(4):
            turn = rotation(pose[7 * k + 3:7 * k + 7])
            inertia = turn @ self.inertias[k] @ turn.T
            omega = v[6 * k + 3:6 * k + 6]
            mass[6 * k:6 * k + 3, 6 * k:6 * k + 3] = self.m[k] * np.eye(3)
            mass[6 * k + 3:6 * k + 6, 6 * k + 3:6 * k + 6] = inertia
            force[6 * k + 3:6 * k + 6] = -np.cross(omega, inertia @ omega)
        arm = self.point(pose, 2, "tie_rod_outer")[1]
        j = np.zeros((3, 24))
        j[:, 12:15], j[:, 15:18] = np.eye(3), -cross(arm)
        omega = v[15:18]
        mass += self.rod / 3 * j.T @ j
        force -= self.rod / 3 * j.T @ np.cross(omega, np.cross(omega, arm))
        _, g, right = self.constraints(pose, v)
        return mass, g, force, right

    def move_to_touch(self, pose, gap):
        """Pose on the branch at which the gap is closed: Newton's method in ten steps of the gap."""
        start = self.point(pose, 0, "bump_stop_pad")[0]
        for part in np.linspace(0.1, 1, 10):
            for _ in range(30):
                errors, rows, _ = self.constraints(pose, np.zeros(24))
                j = self.closing(pose)
                spin = np.zeros(24)
                spin[22], spin[16] = 1.0, -1.0
                errors = np.concatenate([errors, [self.n @ (self.point(pose, 0, "bump_stop_pad")[0] - start) - part * gap, 0.0]])
                move = np.linalg.lstsq(np.vstack([rows, j, spin]), -errors, rcond=None)[0]
                pose = self.moved(pose, move)
                if np.abs(move).max() < 1e-15:
                    break
        return pose

    @staticmethod
    def moved(pose, move):
        pose = pose.copy()
        for k in range(4):
            pose[7 * k:7 * k + 3] += move[6 * k:6 * k + 3]
            q, half = pose[7 * k + 3:7 * k + 7], 0.5 * move[6 * k + 3:6 * k + 6]
            q = q + np.concatenate([[-half @ q[1:]], q[0] * half + np.cross(half, q[1:])])
            pose[7 * k + 3:7 * k + 7] = q / np.linalg.norm(q)
        return pose

    def gap(self, y):
        pad, arm = self.point(y, 0, "bump_stop_pad")
        start = self.point(self.touch, 0, "bump_stop_pad")[0]
        return self.n @ (pad - start), self.closing(y) @ y[28:]

    def rate(self, y, force):
        pose, v = y[:28], y[28:]
        mass, g, total, right = self.equations(pose, v)
        total = total - self.closing(pose) * force

        def push(k, name, vector):
            total[6 * k:6 * k + 3] += vector
            total[6 * k + 3:6 * k + 6] += np.cross(self.point(pose, k, name)[1], vector)

        stiffness, preload = self.spring
        free = self.spring_drawn + preload / stiffness if self.whole else self.spring_at_touch
        for seat, end, of in (("spring_seat", "spring_chassis_seat", lambda length, _: stiffness * (free - length)),
                              ("damper_seat", "damper_chassis_seat", lambda _, rate: -curve(self.speeds, self.damper, rate))):
            at, arm = self.point(pose, 0, seat)
            line = at - self.at[end]
            length = np.linalg.norm(line)
            line = line / length
            push(0, seat, line * of(length, line @ (v[:3] + np.cross(v[3:6], arm))))
        stiffness, damping, load = self.tyre
        at, _ = self.point(pose, 3, "wheel_centre")
        vertical = max(0.0, load - stiffness * (at[2] - self.height) - damping * v[20])
        push(3, "wheel_centre", np.array([0, 0, vertical - (0 if self.whole else load)]))
        if self.gravity:
            for k in range(4):
                total[6 * k + 2] -= self.m[k] * self.gravity
            push(2, "tie_rod_outer", np.array([0, 0, -self.rod / 2 * self.gravity]))
        n = len(g)
        solved = np.linalg.solve(np.block([[mass, g.T], [g, np.zeros((n, n))]]), np.concatenate([total, right]))
        out = np.zeros(52)
        for k in range(4):
            q, omega = pose[7 * k + 3:7 * k + 7], v[6 * k + 3:6 * k + 6]
            out[7 * k:7 * k + 3] = v[6 * k:6 * k + 3]
            out[7 * k + 3:7 * k + 7] = 0.5 * np.concatenate([[-omega @ q[1:]], q[0] * omega + np.cross(omega, q[1:])])
        out[28:] = solved[:24]
        return out

    def words(self, folder):
        path = Path(folder) / "car.toml"
        path.write_text(self.text)
        words = [str(path), "--at", "bump_stop"] + (["--springs", "full"] if self.whole else [])
        return words + ([f"--gravity=0,0,{-self.gravity}"] if self.gravity else [])


def compare(percuss, system, folder):
    """Outcome and differences: of restitution, peak force, penetration, and the error of the balance of energies."""
    law = system.law
    words = [percuss, "impact", *system.words(folder), "--in-time", "--speed", number(system.speed), f"--{law.kind}", number(law.value), "--format", "json"]
    found = subprocess.run(words, capture_output=True, text=True)
    expected = integrate(system, law, system.start, system.speed, system.depth)
    if not found.stdout.startswith("{"):
        refused = "does not end" in found.stderr and expected is None
        return ("no end" if refused else "error", found.stderr.strip() or "no report")
    report = json.loads(found.stdout)["in_time"]
    if expected is None:
        return ("no end", "") if report["duration"] is None else ("error", "the integration has no end")
    e, peak, depth = expected
    energy = abs(report["energy"]["residual"]) / report["energy"]["kinetic_before"]
    return "compared", [abs(report["restitution"] - e), abs(report["peak_force"] / peak - 1), abs(report["max_penetration"] / depth - 1), energy]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--percuss", required=True)
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    args = parser.parse_args()
    passed, failed, ended, worst = 0, 0, 0, np.zeros(4)
    limits = np.array([RESTITUTION, PEAK, PEAK, ENERGY])
    with tempfile.TemporaryDirectory() as folder:
        for case in range(args.count):
            rng = np.random.default_rng([args.seed, case])
            system = (Car if case % 4 == 3 else Plane)(rng, case)
            outcome, found = compare(args.percuss, system, folder)
            if outcome == "compared":
                worst = np.maximum(worst, found)
                ended += 1
            is_right = outcome == "no end" or outcome == "compared" and bool((np.array(found) <= limits).all())
            passed, failed = passed + is_right, failed + (not is_right)
            if not is_right:
                print(f"contact {case} ({type(system).__name__}, {system.law.kind}): {found}")
    of = "restitution {:.1e}, peak force {:.1e}, penetration {:.1e}, energies {:.1e}".format(*worst)
    print(f"{ended} with an end; largest differences: {of}; {passed} passed, {failed} failed")
    sys.exit(failed > 0)


if __name__ == "__main__":
    main()
