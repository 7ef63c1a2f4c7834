"""Stops of joints of random mechanisms: percuss's inertia compared with MuJoCo's matrices, and for some of them
MuJoCo's rebound. Trees of revolute and prismatic joints; four-bars and slider-cranks on a base that is fixed, turns
or slides; lengths, masses, inertias, rotors, frames and ends of the range from a seed."""

import dataclasses
import tempfile
from pathlib import Path

import mujoco_scenes
import numpy as np
from impacts import Contact, answer, damp, parameters

SEED, TREES, LINKAGES = 20261122, 28, 28
# Every fourth mechanism runs in MuJoCo too.
RUN_EVERY = 4
RESTITUTIONS = (0.2, 0.5, 0.8)
# Tolerances: inertia, relative; α; restitution.
INERTIA, ALPHA, RESTITUTION = 1e-9, 1e-6, 1e-3
# Stiff and slow, so that the inertia hardly changes: rad/s, and rad/s or m/s.
FREQUENCY, SPEED = 100.0, 1e-3


@dataclasses.dataclass
class Case:
    name: str
    urdf: str
    joint: str
    end: int
    # Position of the stopped joint; positions of other joints that are set.
    at: float
    pose: dict


class Maker:
    def __init__(self, seed):
        self.rng = np.random.default_rng(seed)
        self.lines, self.names = ['<robot name="random">', '  <link name="ground"/>'], []

    def numbers(self, values):
        return " ".join(repr(float(v)) for v in values)

    def between(self, low, high):
        return float(self.rng.uniform(low, high))

    def decades(self, low, high):
        return float(10 ** self.rng.uniform(low, high))

    def link(self, name):
        mass, size = self.decades(-0.5, 1), self.between(0.05, 0.3)
        # Positive moments within the triangle inequality.
        moments = mass * size**2 * self.rng.uniform(0.7, 1.0, 3)
        axes, _ = np.linalg.qr(self.rng.normal(size=(3, 3)))
        i = axes @ np.diag(moments) @ axes.T
        self.lines.append(
            f'  <link name="{name}"><inertial><origin xyz="{self.numbers(self.rng.uniform(-0.3, 0.3, 3))}"/><mass value="{mass!r}"/>'
            f'<inertia ixx="{float(i[0, 0])!r}" ixy="{float(i[0, 1])!r}" ixz="{float(i[0, 2])!r}" iyy="{float(i[1, 1])!r}" '
            f'iyz="{float(i[1, 2])!r}" izz="{float(i[2, 2])!r}"/></inertial></link>'
        )

    def joint(self, name, kind, parent, child, xyz=(0, 0, 0), rpy=(0, 0, 0), axis=(0, 0, 1), limits=None, more=""):
        rotor = self.decades(-2, 0) if self.rng.random() < 0.4 else 0.0
        limit = f'<limit lower="{limits[0]!r}" upper="{limits[1]!r}" effort="0" velocity="0"/>' if limits else ""
        dynamics = f'<dynamics armature="{rotor!r}"/>' if kind != "fixed" else ""
        axis = f'<axis xyz="{self.numbers(axis)}"/>' if kind != "fixed" else ""
        self.lines.append(
            f'  <joint name="{name}" type="{kind}"{more}><parent link="{parent}"/><child link="{child}"/>'
            f'<origin xyz="{self.numbers(xyz)}" rpy="{self.numbers(rpy)}"/>{axis}{limit}{dynamics}</joint>'
        )

    def urdf(self):
        return "\n".join([*self.lines, "</robot>", ""])

    def direction(self):
        v = self.rng.normal(size=3)
        return v / np.linalg.norm(v)

    def end(self):
        return 1 if self.rng.random() < 0.5 else -1


def tree(number):
    """A tree of 2 to 6 links, chains and branched trees; general parameters."""
    make = Maker([SEED, 0, number])
    count = int(make.rng.integers(2, 7))
    stopped, pose, at = int(make.rng.integers(1, count + 1)), {}, 0.0
    end = make.end()
    for i in range(1, count + 1):
        make.link(f"link_{i}")
        parent = "ground" if i == 1 else f"link_{make.rng.integers(max(1, i - 2), i)}"
        kind = "prismatic" if make.rng.random() < 0.35 else "revolute"
        limits = (make.between(-1.5, -0.1), make.between(0.1, 1.5))
        make.joint(
            f"joint_{i}", kind, parent, f"link_{i}", make.rng.uniform(-0.4, 0.4, 3), make.rng.uniform(-3, 3, 3), make.direction(), limits
        )
        if i == stopped:
            at = limits[1] if end > 0 else limits[0]
        else:
            pose[f"joint_{i}"] = make.between(*limits)
    return Case(f"tree {number} of {count}", make.urdf(), f"joint_{stopped}", end, at, pose)


def based(make):
    """A base on the ground, fixed or movable, with the plane of the linkage."""
    kind = ("fixed", "revolute", "prismatic")[int(make.rng.integers(3))]
    make.link("base")
    limits = (-1.0, 1.0) if kind != "fixed" else None
    make.joint("base_joint", kind, "ground", "base", make.rng.uniform(-1, 1, 3), make.rng.uniform(-3, 3, 3), make.direction(), limits)
    return {"base_joint": make.between(-0.8, 0.8)} if limits else {}


def loop(before, at_before, after, at_after):
    return (
        f'  <loop name="pin" type="revolute"><predecessor link="{before}"><origin xyz="{at_before}"/></predecessor>'
        f'<successor link="{after}"><origin xyz="{at_after}"/></successor><axis xyz="0 0 1"/></loop>'
    )


def four_bar(number):
    """A four-bar with the crank as its shortest link, which turns fully; the stop is on the crank or on the rocker."""
    make = Maker([SEED, 1, number])
    pose = based(make)
    crank = make.between(0.1, 0.2)
    ground, coupler, rocker = (make.between(2.2, 3.0) * crank for _ in range(3))
    angle = make.between(0.5, 2.6) * make.end()
    d = np.array([ground, 0.0])

    def closed(angle):
        """The pins of the coupler."""
        a = crank * np.array([np.cos(angle), np.sin(angle)])
        along, across = d - a, np.array([a[1] - d[1], d[0] - a[0]])
        reach = np.linalg.norm(along)
        part = (coupler**2 - rocker**2 + reach**2) / (2 * reach**2)
        return a, a + part * along + np.sqrt(coupler**2 / reach**2 - part**2) * across

    def turned(by):
        """Angle of the rocker from its drawn position, as a function of the crank angle."""
        (x0, y0), (x, y) = closed(angle)[1] - d, closed(angle + by)[1] - d
        return float(np.arctan2(x0 * y - y0 * x, x0 * x + y0 * y))

    a, b = closed(angle)
    which = ("crank_hinge", "rocker_hinge")[int(make.rng.integers(2))]
    end, ends = make.end(), (-make.between(0.1, 0.5), make.between(0.1, 0.5))
    limits = ends if which == "crank_hinge" else tuple(sorted(turned(by) for by in ends))
    of = {which: limits}
    for name in ("crank", "coupler", "rocker"):
        make.link(name)
    make.joint("crank_hinge", "revolute" if which == "crank_hinge" else "continuous", "base", "crank", limits=of.get("crank_hinge"))
    make.joint("crank_pin", "continuous", "crank", "coupler", (*a, 0))
    make.joint("rocker_hinge", "revolute" if which == "rocker_hinge" else "continuous", "base", "rocker", (ground, 0, 0), limits=of.get("rocker_hinge"))
    make.lines.append(loop("coupler", make.numbers([*(b - a), 0]), "rocker", make.numbers([*(b - d), 0])))
    return Case(f"four-bar {number}", make.urdf(), which, end, limits[1] if end > 0 else limits[0], pose)


def slider_crank(number):
    """A slider-crank with a stop of the crank or of the slide."""
    make = Maker([SEED, 2, number])
    pose = based(make)
    crank = make.between(0.1, 0.3)
    rod = make.between(1.6, 3.0) * crank
    angle = make.between(0.6, 2.5) * make.end()
    a = crank * np.array([np.cos(angle), np.sin(angle)])
    x = float(a[0] + np.sqrt(rod**2 - a[1] ** 2))

    def moved(by):
        """Displacement of the slider from its drawn position, as a function of the crank angle."""
        c, s = crank * np.cos(angle + by), crank * np.sin(angle + by)
        return float(c + np.sqrt(rod**2 - s**2)) - x

    which = ("crank_hinge", "guide")[int(make.rng.integers(2))]
    end, ends = make.end(), (-make.between(0.1, 0.4), make.between(0.1, 0.4))
    limits = ends if which == "crank_hinge" else tuple(sorted(moved(by) for by in ends))
    for name in ("crank", "rod", "slider"):
        make.link(name)
    make.joint(
        "crank_hinge", "revolute" if which == "crank_hinge" else "continuous", "base", "crank", limits=limits if which == "crank_hinge" else None
    )
    make.joint("crank_pin", "continuous", "crank", "rod", (*a, 0))
    make.joint("guide", "prismatic", "base", "slider", (x, 0, 0), axis=(1, 0, 0), limits=limits if which == "guide" else (-9.0, 9.0))
    make.lines.append(loop("rod", make.numbers([x - a[0], -a[1], 0]), "slider", "0 0 0"))
    return Case(f"slider-crank {number}", make.urdf(), which, end, limits[1] if end > 0 else limits[0], pose)


def family():
    yield from (tree(number) for number in range(TREES))
    for number in range(LINKAGES // 2):
        yield from (four_bar(number), slider_crank(number))


def check(percuss, tally):
    with tempfile.TemporaryDirectory() as folder:
        path = str(Path(folder) / "random.urdf")
        for number, case in enumerate(family()):
            Path(path).write_text(case.urdf)
            one(percuss, tally, case, path, run=number % RUN_EVERY == 0)


def one(percuss, tally, case, path, run):
    set_flags = [word for name, value in case.pose.items() for word in ("--set", f"{name}={value!r}")]
    flags = ("--mass-from", path, "--limit", f"{case.joint}:{'upper' if case.end > 0 else 'lower'}", *set_flags)
    inertia = damp(percuss, Contact(flags, 1.0, SPEED), 0.5)["effective_mass"]
    stop = ("--set", f"{case.joint}={case.at!r}")
    pose = answer(percuss, "mass", path, "--link", anywhere(case), "--point", "0.1,0.2,0.3", "--normal", "1,2,3", *set_flags, *stop)
    theirs = mujoco_scenes.LimitedJoint(path, pose, case.joint, case.end)
    their = theirs.effective_mass(theirs.pose)
    where = f"{case.name}, {case.joint}, {'upper' if case.end > 0 else 'lower'}"
    tally.within("random stops: inertia by MuJoCo's matrices", where, abs(inertia / their - 1), INERTIA)
    if not run:
        return
    for e in RESTITUTIONS:
        stiffness = inertia * FREQUENCY**2
        report = damp(percuss, Contact(flags, stiffness, SPEED), e, "--for", "mujoco")
        given = parameters(report, "mujoco")
        d = given["solimplimit"][0]
        alpha = (-given["solreflimit"][0] * inertia / stiffness - d) / (1 - d)
        their_alpha = theirs.inverse_diagonal() * their
        tally.within("random stops: α by MuJoCo's dof_invweight0", where, abs(alpha / their_alpha - 1), ALPHA)
        outcome = theirs.impact(given, SPEED)[0]
        bound = min(RESTITUTION, report["exports"]["mujoco"]["error_bound"])
        tally.within("random stops: restitution over the stated bound: MuJoCo", f"{where}, e = {e}", outcome.error(e) / bound, 1.0)
        # Sampled once per step.
        depth = abs(outcome.depth / report["max_penetration"] - 1)
        tally.within("random stops: penetration: MuJoCo", f"{where}, e = {e}", depth, 5e-3)


def anywhere(case):
    """Name of a moving link."""
    return "link_1" if case.joint.startswith("joint") else "crank"
