"""What collides in the engines, whatever the engine: a ball, pendulums, a four-bar."""

import dataclasses
from pathlib import Path

from impacts import Contact

STIFFNESS, SPEED = 1e5, 0.3


class Refused(Exception):
    """The tool cannot have this scene."""


class Absent(Exception):
    """The engine is not on this machine; says what to install."""


def alone(own_mass):
    """What percuss is asked of the struck body by itself."""
    return Contact(("--mass", repr(own_mass), "--own-mass", repr(own_mass)), STIFFNESS, SPEED)


@dataclasses.dataclass(frozen=True)
class Ball:
    """Flies along z against a wall that stands still; no gravity, no friction, no spin."""

    mass: float
    radius: float

    @property
    def own_mass(self):
        return self.mass

    def contact(self, folder):
        return alone(self.mass)

    def alone(self, folder):
        return alone(self.mass)


@dataclasses.dataclass(frozen=True)
class Pendulum:
    """A body on a hinge at the origin, whose axis is −y: a positive turn lifts what lies on +x along +z. Its centre of
    mass is on +x; a sphere of `radius` at `lever` on +x strikes a wall below it (surface normal +z) when the angle is 0.
    The rotor turns with it about the hinge: where a tool has no armature, its inertia is added to the body's about y. No gravity."""

    mass: float
    centre: float
    inertia: float  # about the centre of mass, the same for all axes, kg m²
    lever: float
    radius: float
    rotor: float

    @property
    def own_mass(self):
        return self.mass

    @property
    def effective_mass(self):
        """(I + m a² + rotor)/l²."""
        return (self.inertia + self.mass * self.centre**2 + self.rotor) / self.lever**2

    @property
    def urdf(self):
        i = self.inertia
        return f"""<robot name="pendulum">
  <link name="world"/>
  <link name="rod">
    <inertial>
      <origin xyz="{self.centre} 0 0"/>
      <mass value="{self.mass}"/>
      <inertia ixx="{i}" ixy="0" ixz="0" iyy="{i}" iyz="0" izz="{i}"/>
    </inertial>
  </link>
  <joint name="hinge" type="continuous">
    <parent link="world"/>
    <child link="rod"/>
    <axis xyz="0 -1 0"/>
  </joint>
</robot>
"""

    def contact(self, folder):
        path = Path(folder) / "pendulum.urdf"
        path.write_text(self.urdf)
        where = ("--link", "rod", "--point", f"{self.lever},0,0", "--normal", "0,0,1")
        return Contact(
            ("--mass-from", str(path), *where, "--armature", f"hinge={self.rotor}", "--own-mass", repr(self.mass)),
            STIFFNESS,
            SPEED,
        )

    def alone(self, folder):
        return alone(self.own_mass)


@dataclasses.dataclass(frozen=True)
class FourBar:
    """models/four_bar.urdf as it is drawn, in the x-y plane: a sphere of `radius` about the coupler's point strikes a wall below it
    (surface normal +y). `bodies` has mass, inertia about the centre of mass along z (the same may be taken for all axes), the
    centre of mass, and the rate over the crank's; `hinges`, all along z, two bodies (None: the ground) and where. No gravity."""

    radius: float = 0.02
    point: tuple = (0.35, 0.4)
    struck: str = "coupler"
    own_mass: float = 4.8
    effective_mass: float = 417304 / 6125
    # The crank's rate per approach speed of the point, rad/m.
    crank_rate: float = 12.0
    bodies = {
        "crank": (2.0, 0.015, (0.0, 0.15), 1.0),
        "coupler": (4.8, 0.1, (0.2, 0.45), -5 / 21),
        "rocker": (3.0, 0.105625, (0.525, 0.3), 8 / 21),
    }
    hinges = (
        ("crank", None, (0.0, 0.0)),
        ("coupler", "crank", (0.0, 0.3)),
        ("coupler", "rocker", (0.4, 0.6)),
        ("rocker", None, (0.65, 0.0)),
    )

    def contact(self, folder):
        """Stiff and slow, so that the effective mass hardly changes while it lasts."""
        where = ("--link", "coupler", "--point", "0.35,0.1,0", "--normal", "0,1,0", "--own-mass", repr(self.own_mass))
        return Contact(("--mass-from", "models/four_bar.urdf", *where), 1e6, 2e-3)

    def alone(self, folder):
        return dataclasses.replace(alone(self.own_mass), stiffness=1e6, speed=2e-3)


BALL = Ball(2.0, 0.05)
FOUR_BAR = FourBar()
# m̄ = 1.5 and 3.75 kg, of a body of 2 kg.
PENDULUMS = [Pendulum(2.0, 0.3, 0.06, 0.4, 0.02, rotor) for rotor in (0.0, 0.36)]


def velocities(four_bar, speed):
    """(x and y of the centre of mass's velocity, rate) of each body when the point approaches the wall at `speed`."""
    crank = four_bar.crank_rate * speed
    anchors = {"crank": (0.0, 0.0), "rocker": (0.65, 0.0)}
    moving = {}
    for name, (_, _, (x, y), ratio) in four_bar.bodies.items():
        rate = ratio * crank
        if name in anchors:
            u, w = x - anchors[name][0], y - anchors[name][1]
            moving[name] = ((-w * rate, u * rate), rate)
        else:  # about the crank's pin at (0, 0.3), which moves with the crank
            moving[name] = ((-0.3 * crank - (y - 0.3) * rate, x * rate), rate)
    return moving
