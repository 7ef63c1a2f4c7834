"""What collides in the engines, whatever the engine: a ball, pendulums, a four-bar."""

import dataclasses
from pathlib import Path

from impacts import Contact

STIFFNESS, SPEED = 1e5, 0.3


class Refused(Exception):
    """The tool cannot have this scene."""


@dataclasses.dataclass(frozen=True)
class Ball:
    """Flies along z against a wall that stands still; no gravity, no friction, no spin."""

    mass: float
    radius: float

    @property
    def own_mass(self):
        return self.mass

    def contact(self, folder):
        return Contact(("--mass", repr(self.mass), "--own-mass", repr(self.mass)), STIFFNESS, SPEED)


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


BALL = Ball(2.0, 0.05)
# m̄ = 1.5 and 3.75 kg, of a body of 2 kg.
PENDULUMS = [Pendulum(2.0, 0.3, 0.06, 0.4, 0.02, rotor) for rotor in (0.0, 0.36)]
