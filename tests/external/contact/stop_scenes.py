"""Joints that run into their stops, for all engines. No gravity; all motions in the x-y plane."""

import dataclasses
import math
from pathlib import Path

from impacts import Contact
from scenes import FOUR_BAR, velocities


@dataclasses.dataclass(frozen=True)
class Body:
    """Inertia about the centre of mass along z (engines may use the same value for all axes); position of the centre
    of mass, and its velocity when the stopped joint moves at unit speed into its stop."""

    name: str
    mass: float  # kg
    inertia: float  # kg·m²
    centre: tuple  # m
    velocity: tuple
    rate: float


@dataclasses.dataclass(frozen=True)
class Joint:
    """A hinge along z at `where`, or a slider along it: motion of `child` relative to `parent` (None: the ground)."""

    child: str
    parent: str | None
    where: tuple
    slides: bool = False


@dataclasses.dataclass(frozen=True)
class Stop:
    """`flags`: the question for percuss, `urdf`: a model that replaces a file of models/ (written as {name}.urdf).
    The joint `limited` of `joints` moves at `speed` into its stop at the `end` (1 upper, -1 lower) of its range;
    `bodies` move with the least energy for this. `tree`: shoulder, elbow, for models without loops: the angle of
    each joint at the stop, its rate over the limited joint's rate, and its rotor's inertia."""

    flags: tuple
    bodies: tuple
    joints: tuple
    limited: int
    stiffness: float
    speed: float
    own_mass: float
    end: int = 1
    urdf: str | None = None
    tree: tuple | None = None

    @property
    def slides(self):
        return self.joints[self.limited].slides

    @property
    def effective_mass(self):
        """Inertia at the stop, kg·m², or kg for a slider."""
        rotors = sum(rotor * rate**2 for _, rate, rotor in self.tree or ())
        return rotors + sum(b.mass * (b.velocity[0] ** 2 + b.velocity[1] ** 2) + b.inertia * b.rate**2 for b in self.bodies)

    def contact(self, folder):
        flags = self.flags
        if self.urdf:
            path = Path(folder) / "stopped.urdf"
            path.write_text(self.urdf)
            flags = ("--mass-from", str(path), *flags)
        return Contact(flags, self.stiffness, self.speed)

    def alone(self, folder):
        """The stop with the stopped link alone."""
        path = Path(folder) / "alone.urdf"
        path.write_text(single("prismatic" if self.slides else "continuous", self.own_mass))
        return Contact(("--mass-from", str(path), "--limit", "joint"), self.stiffness, self.speed)


def single(kind, amount):
    """URDF of one link on one joint, with mass or inertia about the joint `amount`."""
    mass, inertia = (amount, 1.0) if kind == "prismatic" else (1.0, amount)
    return f"""<robot name="single">
  <link name="ground"/>
  <link name="link">
    <inertial>
      <mass value="{mass!r}"/>
      <inertia ixx="{inertia!r}" ixy="0" ixz="0" iyy="{inertia!r}" iyz="0" izz="{inertia!r}"/>
    </inertial>
  </link>
  <joint name="joint" type="{kind}"><parent link="ground"/><child link="link"/><axis xyz="0 0 1"/></joint>
</robot>
"""


def hinge(end, rotor):
    """A link of 2 kg on a hinge with a range of -0.7 … 0.4 rad and a rotor."""
    mass, arm, inertia = 2.0, 0.3, 0.06
    angle = 0.4 if end > 0 else -0.7
    c, s = math.cos(angle), math.sin(angle)
    urdf = f"""<robot name="hinged">
  <link name="ground"/>
  <link name="link">
    <inertial>
      <origin xyz="{arm} 0 0"/>
      <mass value="{mass}"/>
      <inertia ixx="{inertia}" ixy="0" ixz="0" iyy="{inertia}" iyz="0" izz="{inertia}"/>
    </inertial>
  </link>
  <joint name="hinge" type="revolute">
    <parent link="ground"/>
    <child link="link"/>
    <axis xyz="0 0 1"/>
    <limit lower="-0.7" upper="0.4" effort="0" velocity="0"/>
    <dynamics armature="{rotor}"/>
  </joint>
</robot>
"""
    return Stop(
        flags=("--limit", "hinge:upper" if end > 0 else "hinge:lower"),
        urdf=urdf,
        bodies=(Body("link", mass, inertia, (arm * c, arm * s), (-end * arm * s, end * arm * c), end),),
        joints=(Joint("link", None, (0.0, 0.0)),),
        limited=0,
        stiffness=700.0,
        speed=1.0,
        own_mass=inertia + mass * arm**2,
        end=end,
        tree=((angle, end, rotor),),
    )


def elbow():
    """The elbow of models/planar_2r.urdf at 1 rad, without rotors; the shoulder is free. The speed is so low that
    the inertia hardly changes."""
    m1, l1, m2, l2, angle = 4.0, 0.5, 2.0, 0.4, 1.0
    along = m2 * l1 * l2 / 2 * math.cos(angle)
    m11 = m1 * l1**2 / 3 + m2 * l1**2 + m2 * l2**2 / 3 + 2 * along
    m12 = m2 * l2**2 / 3 + along
    shoulder = -m12 / m11
    c, s, turn = math.cos(angle), math.sin(angle), 1 + shoulder
    outer = (l1 + l2 / 2 * c, l2 / 2 * s)
    moves = (-turn * l2 / 2 * s, shoulder * l1 + turn * l2 / 2 * c)
    return Stop(
        flags=("--mass-from", "models/planar_2r.urdf", "--limit", "elbow", "--set", "elbow=1")
        + ("--armature", "shoulder=0", "--armature", "elbow=0"),
        bodies=(
            Body("inner", m1, m1 * l1**2 / 12, (l1 / 2, 0.0), (0.0, shoulder * l1 / 2), shoulder),
            Body("outer", m2, m2 * l2**2 / 12, outer, moves, turn),
        ),
        joints=(Joint("inner", None, (0.0, 0.0)), Joint("outer", "inner", (l1, 0.0))),
        limited=1,
        stiffness=700.0,
        speed=0.01,
        own_mass=m2 * l2**2 / 3,
        tree=((0.0, shoulder, 0.0), (angle, 1.0, 0.0)),
    )


def crank():
    """The crank of models/four_bar.urdf in the drawn pose; the speed is so low that the inertia hardly changes."""
    moving = velocities(FOUR_BAR, 1 / FOUR_BAR.crank_rate)
    bodies = [Body(name, m, i, at, *moving[name]) for name, (m, i, at, _) in FOUR_BAR.bodies.items()]
    mass, inertia, (x, y), _ = FOUR_BAR.bodies["crank"]
    return Stop(
        flags=("--mass-from", "models/four_bar.urdf", "--limit", "crank_hinge"),
        bodies=tuple(bodies),
        joints=tuple(Joint(a, b, at) for a, b, at in FOUR_BAR.hinges),
        limited=0,
        stiffness=1e4,
        speed=2e-3,
        own_mass=inertia + mass * (x * x + y * y),
    )


def slide():
    """The slider of models/slider_crank.urdf in the drawn pose: the rod does not rotate, all bodies except the crank
    have the same velocity."""
    return Stop(
        flags=("--mass-from", "models/slider_crank.urdf", "--limit", "guide"),
        bodies=(
            Body("crank", 2.0, 0.015, (0.0, 0.15), (0.5, 0.0), -1 / 0.3),
            Body("rod", 1.2, 0.025, (0.2, 0.15), (1.0, 0.0), 0.0),
            Body("slider", 0.9, 0.001, (0.4, 0.0), (1.0, 0.0), 0.0),
        ),
        joints=(
            Joint("crank", None, (0.0, 0.0)),
            Joint("rod", "crank", (0.0, 0.3)),
            Joint("slider", "rod", (0.4, 0.0)),
            Joint("slider", None, (1.0, 0.0), slides=True),
        ),
        limited=3,
        stiffness=1e6,
        speed=1e-3,
        own_mass=0.9,
    )


STOPS = {
    "stop, hinge": hinge(1, 0.0),
    "stop, hinge, rotor": hinge(-1, 0.36),
    "stop, elbow": elbow(),
    "stop, four-bar": crank(),
    "stop, slider-crank": slide(),
}
