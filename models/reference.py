#!/usr/bin/env python3
"""The figures behind the models' word "Reference", from a program that shares no code and no method with percuss.

    python3 models/reference.py [models/NAME.urdf ...]        needs numpy

Unknowns are the six velocities of every link, in world axes about the world's origin. Every joint, loop and coupling becomes
rows on them; m̄ is the least of twice the kinetic energy at unit closing speed. No joint coordinates, no mass matrix of joints,
no recursion. Only the pose in which all joints are 0 is known here: commands with --set, --guess or --hold are passed over.
"""
import re
import shlex
import sys
import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np


def vector(text):
    return np.array([float(x) for x in text.replace(",", " ").split()])


def rotation(roll, pitch, yaw):
    (a, b, c), (s, t, u) = np.cos([roll, pitch, yaw]), np.sin([roll, pitch, yaw])
    about_x = np.array([[1, 0, 0], [0, a, -s], [0, s, a]])
    about_y = np.array([[b, 0, t], [0, 1, 0], [-t, 0, b]])
    about_z = np.array([[c, -u, 0], [u, c, 0], [0, 0, 1]])
    return about_z @ about_y @ about_x


def frame(element):
    origin = element.find("origin")
    if origin is None:
        return np.eye(3), np.zeros(3)
    return rotation(*vector(origin.get("rpy", "0 0 0"))), vector(origin.get("xyz", "0 0 0"))


def cross(v):
    return np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def across(axis):
    """Two directions at right angles to an axis."""
    return np.linalg.svd(np.atleast_2d(axis))[2][1:]


class Mechanism:
    def __init__(self, text, floating=False, locked=()):
        robot = ET.fromstring(text)
        names = [link.get("name") for link in robot.findall("link")]
        self.index = {name: i for i, name in enumerate(names)}
        self.size = 6 * len(names)
        joints = robot.findall("joint")
        above = {j.find("child").get("link"): j for j in joints}
        self.frames = {}
        for name in names:
            self.place(name, above)
        self.masses = {}
        self.energy = sum((self.inertia(link) for link in robot.findall("link")), np.zeros((self.size, self.size)))
        self.rows = []
        if not floating:
            root = next(n for n in names if n not in above)
            self.rows += [*self.spin(root), *self.velocity(root, np.zeros(3))]
        for j in joints:
            a, b = j.find("parent").get("link"), j.find("child").get("link")
            turn, point = self.frames[b]
            axis = j.find("axis")
            axis = turn @ (vector(axis.get("xyz")) if axis is not None else np.array([1.0, 0, 0]))
            self.join("fixed" if j.get("name") in locked else j.get("type"), a, b, point, point, axis)
        for loop in robot.findall("loop"):
            ends = []
            for end in (loop.find("predecessor"), loop.find("successor")):
                (turn, place), (more, at) = self.frames[end.get("link")], frame(end)
                ends.append((end.get("link"), turn @ more, place + turn @ at))
            (a, turn, p), (b, _, q) = ends
            axis = loop.find("axis")
            axis = turn @ (vector(axis.get("xyz")) if axis is not None else np.array([1.0, 0, 0]))
            self.join(loop.get("type"), a, b, p, q, axis)
        for coupling in robot.findall("coupling"):
            rate = []
            for end in ("predecessor", "successor"):
                link = coupling.find(end).get("link")
                axis = self.frames[link][0] @ vector(above[link].find("axis").get("xyz"))
                rate.append(axis @ (self.spin(link) - self.spin(above[link].find("parent").get("link"))))
            self.rows.append(rate[1] - float(coupling.find("ratio").get("value")) * rate[0])
        _, singular, right = np.linalg.svd(np.array(self.rows) if self.rows else np.zeros((1, self.size)))
        self.motions = right[(singular > 1e-9 * max(singular[0], 1e-300)).sum() :].T

    def place(self, name, above):
        if name not in self.frames:
            if name in above:
                turn, at = self.place(above[name].find("parent").get("link"), above)
                more, offset = frame(above[name])
                self.frames[name] = (turn @ more, at + turn @ offset)
            else:
                self.frames[name] = (np.eye(3), np.zeros(3))
        return self.frames[name]

    def spin(self, link):
        rows = np.zeros((3, self.size))
        rows[:, 6 * self.index[link] :][:, :3] = np.eye(3)
        return rows

    def velocity(self, link, point):
        rows = np.zeros((3, self.size))
        rows[:, 6 * self.index[link] :][:, :6] = np.hstack([-cross(point), np.eye(3)])
        return rows

    def inertia(self, link):
        inertial, name = link.find("inertial"), link.get("name")
        if inertial is None:
            return np.zeros((self.size, self.size))
        (turn, place), (more, centre) = self.frames[name], frame(inertial)
        mass, tensor = float(inertial.find("mass").get("value")), inertial.find("inertia")
        xx, xy, xz, yy, yz, zz = (float(tensor.get(k)) for k in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"))
        axes = turn @ more
        about = axes @ np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]) @ axes.T
        spin, speed = self.spin(name), self.velocity(name, place + turn @ centre)
        return mass * speed.T @ speed + spin.T @ about @ spin

    def join(self, kind, a, b, p, q, axis):
        """p is the joint's point as a has it, q as b has it; the rows say what it forbids."""
        speed = self.velocity(b, q) - self.velocity(a, p)
        turn = self.spin(b) - self.spin(a)
        if kind == "distance":
            self.rows.append((q - p) / np.linalg.norm(q - p) @ (self.velocity(b, q) - self.velocity(a, p)))
        elif kind == "cylindrical":
            at_q = self.velocity(b, q) - self.velocity(a, q)
            self.rows += [*(across(axis) @ turn), *(across(axis) @ at_q)]
        elif kind in ("revolute", "continuous"):
            self.rows += [*speed, *(across(axis) @ turn)]
        elif kind == "prismatic":
            self.rows += [*turn, *(across(axis) @ speed)]
        elif kind == "spherical":
            self.rows += [*speed]
        elif kind == "fixed":
            self.rows += [*speed, *turn]
        elif kind != "floating":
            raise ValueError(f"no rows are known for {kind}")

    def effective_mass(self, link, point, normal=None, toward=None, against=None):
        turn, place = self.frames[link]
        at = place + turn @ point
        if toward is not None:
            other, end = toward
            normal = self.frames[other][1] + self.frames[other][0] @ end - at
        else:
            normal = turn @ normal
        closing = normal / np.linalg.norm(normal) @ self.velocity(link, at)
        if against not in (None, "world"):
            closing = closing - normal / np.linalg.norm(normal) @ self.velocity(against, at)
        # Lagrange's equations of the minimum; least squares, since massless motions leave some of them empty.
        energy, closing = self.motions.T @ self.energy @ self.motions, closing @ self.motions
        equations = np.block([[energy, closing[:, None]], [closing[None], np.zeros((1, 1))]])
        rates = np.linalg.lstsq(equations, np.append(np.zeros(len(closing)), 1), rcond=1e-14)[0][:-1]
        return rates @ energy @ rates


def answer(text, command):
    words = shlex.split(command)
    flags = {}
    for flag, value in zip(words[2::2], words[3::2]):
        flags.setdefault(flag, []).append(value)
    one = {flag: values[0] for flag, values in flags.items()}
    if {"--set", "--guess", "--hold", "--armature", "--frame"} & set(one) or "armature=" in text:
        return None, one
    mechanism = Mechanism(text, one.get("--base") == "floating", flags.get("--lock", ()))
    toward = None
    if "--along-line" in one:
        link, point = one["--along-line"].rsplit(":", 1)
        toward = (link, vector(point))
    normal = vector(one["--normal"]) if "--normal" in one else None
    mass = mechanism.effective_mass(one["--link"], vector(one["--point"]), normal, toward, one.get("--against"))
    if "--against-mass" in one:
        other = float(one["--against-mass"])
        mass = mass * other / (mass + other)
    return mass, one


def main():
    paths = [Path(p) for p in sys.argv[1:]] or sorted(Path(__file__).parent.glob("*.urdf"))
    worst = 0.0
    for path in paths:
        text = path.read_text()
        for command in re.findall(r"<\?percuss (mass .*?)\?>", text):
            mass, flags = answer(text, command)
            if mass is not None:
                expected = float(flags["--expect"])
                off = abs(mass / expected - 1)
                worst = max(worst, off)
                print(f"{path.stem:26} {mass:.14g} kg, expected {expected:.14g}, off by {off:.0e}: {command.split(' ', 2)[2]}")
    sys.exit(0 if worst < 1e-11 else 1)


if __name__ == "__main__":
    main()
