"""Independent URDF reader of the comparison: joints, limits, mimics. Uses Python's XML parser, so that no code is
shared with percuss, Pinocchio or MuJoCo."""

import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field

import numpy as np

BASE = "<base>"
MOVABLE = ("revolute", "continuous", "prismatic", "planar", "floating")
ONE_VALUE = ("revolute", "continuous", "prismatic")


class Refused(Exception):
    """Another program does not accept the file."""


def vector(text):
    return np.array([float(x) for x in text.split()])


@dataclass
class Joint:
    name: str
    kind: str
    parent: str
    child: str
    axis: np.ndarray
    limits: tuple
    mimic: tuple | None  # master, multiplier, offset: as written

    def draw(self, rng):
        """A position within the limits, if they are finite and not absurd."""
        if self.kind == "planar":
            return rng.uniform([-1, -1, -np.pi], [1, 1, np.pi]).tolist()
        if self.kind == "floating":
            return rng.uniform(-1, 1, 3).tolist() + unit(rng, 4).tolist()
        reach = 1.0 if self.kind == "prismatic" else np.pi
        low, high = (-reach, reach) if self.kind == "continuous" else self.limits
        low = low if np.isfinite(low) and abs(low) < 10 else -reach
        high = high if np.isfinite(high) and abs(high) < 10 else reach
        return [float(rng.uniform(min(low, high), max(low, high)))]


@dataclass
class Robot:
    links: list = field(default_factory=list)
    joints: dict = field(default_factory=dict)

    def __post_init__(self):
        self.above = {j.child: j for j in self.joints.values()}
        self.movable = [j for j in self.joints.values() if j.kind in MOVABLE]

    def follows(self, name):
        """Master, multiplier and offset of a joint; itself, 1, 0 without a mimic. Chains are multiplied out; a
        missing or fixed master counts as none."""
        multiplier, offset = 1.0, 0.0
        while (mimic := self.joints[name].mimic) and mimic[0] in self.joints:
            if self.joints[mimic[0]].kind not in ONE_VALUE:
                break
            name, offset, multiplier = mimic[0], offset + multiplier * mimic[2], multiplier * mimic[1]
        return name, multiplier, offset

    def is_master(self, joint):
        return self.follows(joint.name)[0] == joint.name

    def positions(self, drawn):
        """Positions of every movable joint, given the masters' positions."""
        all_of_them = {}
        for joint in self.movable:
            master, multiplier, offset = self.follows(joint.name)
            same = master == joint.name
            all_of_them[joint.name] = drawn[master] if same else [multiplier * drawn[master][0] + offset]
        return all_of_them

    def chain(self, link):
        """Movable joints from a link to the root."""
        joints = []
        while joint := self.above.get(link):
            joints += [joint] if joint.kind in MOVABLE else []
            link = joint.parent
        return joints


def read(path):
    root = ElementTree.parse(path).getroot()
    joints = {}
    for element in root.findall("joint"):
        mimic, limit, axis = (element.find(tag) for tag in ("mimic", "limit", "axis"))
        axis = vector(axis.get("xyz")) if axis is not None else np.array([1.0, 0, 0])
        limit = limit if limit is not None else {}
        joint = Joint(
            element.get("name"),
            element.get("type"),
            element.find("parent").get("link"),
            element.find("child").get("link"),
            axis / max(np.linalg.norm(axis), 1e-300),
            (float(limit.get("lower", 0)), float(limit.get("upper", 0))),
            None if mimic is None else master_of(mimic),
        )
        joints[joint.name] = joint
    return Robot([element.get("name") for element in root.findall("link")], joints)


def master_of(mimic):
    return mimic.get("joint"), float(mimic.get("multiplier", 1)), float(mimic.get("offset", 0))


def unit(rng, count=3):
    v = rng.normal(size=count)
    return v / np.linalg.norm(v)
