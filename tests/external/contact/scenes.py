"""Scenes of all engines: balls, levers, a lever against a free ball, a double pendulum, a four-bar."""

import dataclasses
import math
import random
from pathlib import Path

from impacts import Contact

STIFFNESS, SPEED = 1e5, 0.3


class Refused(Exception):
    """The tool cannot have this scene."""


class Absent(Exception):
    """The engine is not on this machine; says what to install."""


def alone(own_mass):
    """Contact of the body without joints."""
    return Contact(("--mass", repr(own_mass), "--own-mass", repr(own_mass)), STIFFNESS, SPEED)


@dataclasses.dataclass(frozen=True)
class Ball:
    """Flies along z against a wall that stands still; no gravity, no friction, no spin."""

    mass: float
    radius: float
    stiffness: float = STIFFNESS
    speed: float = SPEED

    @property
    def own_mass(self):
        return self.mass

    def contact(self, folder):
        return dataclasses.replace(alone(self.mass), stiffness=self.stiffness, speed=self.speed)

    alone = contact


@dataclasses.dataclass(frozen=True)
class Pendulum:
    """A body on a hinge at the origin, whose axis is −y: a positive turn lifts what lies on +x along +z. Its centre of
    mass is at (`centre`, 0, `offset`); a sphere of `radius` at `lever` on +x strikes a wall below it (surface normal +z) when the angle is 0.
    The rotor turns with it about the hinge: where a tool has no armature, its inertia is added to the body's about y. No gravity."""

    mass: float
    centre: float
    inertia: float  # about the centre of mass, the same for all axes, kg m²
    lever: float
    radius: float
    rotor: float = 0.0
    # Distance of the centre of mass from the line from hinge to contact, m.
    offset: float = 0.0
    stiffness: float = STIFFNESS
    speed: float = SPEED

    @property
    def own_mass(self):
        return self.mass

    @property
    def effective_mass(self):
        """(I + m (a² + b²) + rotor)/l²."""
        return self.hinge_inertia / self.lever**2

    @property
    def hinge_inertia(self):
        """About the hinge, with the rotor's, kg m²."""
        return self.inertia + self.mass * (self.centre**2 + self.offset**2) + self.rotor

    @property
    def turning_inertia(self):
        """About the centre of mass, with the rotor's, kg m²."""
        return self.inertia + self.rotor

    @property
    def urdf(self):
        i = self.inertia
        return f"""<robot name="pendulum">
  <link name="world"/>
  <link name="rod">
    <inertial>
      <origin xyz="{self.centre} 0 {self.offset}"/>
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
            self.stiffness,
            self.speed,
        )

    def alone(self, folder):
        return alone(self.own_mass)


@dataclasses.dataclass(frozen=True)
class TwoBodies:
    """The lever of a Pendulum and a free ball below its sphere, both moving: the contact normal is +z, towards the lever. The closing speed is
    shared as in the motion of least energy. No gravity, no friction."""

    lever: Pendulum
    mass: float
    radius: float = 0.05

    @property
    def speed(self):
        return self.lever.speed

    @property
    def effective_mass(self):
        return 1 / (1 / self.lever.effective_mass + 1 / self.mass)

    @property
    def distance(self):
        """Distance of the spheres' centres at the touch, m."""
        return self.lever.radius + self.radius

    @property
    def share(self):
        """Part of the closing speed that is the lever's."""
        return self.effective_mass / self.lever.effective_mass

    def contact(self, folder):
        contact = self.lever.contact(folder)
        return dataclasses.replace(contact, flags=(*contact.flags, "--against-mass", repr(self.mass)))


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

    def velocities(self, speed):
        return four_bar_velocities(self, speed)

    def alone(self, folder):
        return dataclasses.replace(alone(self.own_mass), stiffness=1e6, speed=2e-3)


@dataclasses.dataclass(frozen=True)
class DoublePendulum:
    """Two bodies on hinges in the x-y plane, both oblique to the normal +y; fields of FourBar. The bodies move with the least energy for
    the approach speed. `struck` is the outer body. No gravity."""

    radius: float = 0.02
    point: tuple = (0.6, 0.05)
    struck: str = "outer"
    own_mass: float = 1.2
    elbow: tuple = (0.25, 0.2)
    stiffness: float = STIFFNESS
    speed: float = 0.1
    # Mass, inertia about the centre of mass along z, centre of mass.
    bodies = {"inner": (2.0, 0.03, (0.14, 0.08), None), "outer": (1.2, 0.015, (0.44, 0.16), None)}

    @property
    def hinges(self):
        return (("inner", None, (0.0, 0.0)), ("outer", "inner", self.elbow))

    def response(self):
        """Rates of both bodies, rad/s, for an opening speed of 1 m/s, and the effective mass."""
        (m, i, c, _), (n, j, d, _) = self.bodies.values()
        (ex, ey), arm = self.elbow, (d[0] - self.elbow[0], d[1] - self.elbow[1])
        a = i + m * (c[0] ** 2 + c[1] ** 2) + n * (ex**2 + ey**2)
        b = n * (ex * arm[0] + ey * arm[1])
        e = j + n * (arm[0] ** 2 + arm[1] ** 2)
        row = (ex, self.point[0] - ex)
        free = ((e * row[0] - b * row[1]) / (a * e - b * b), (a * row[1] - b * row[0]) / (a * e - b * b))
        mass = 1 / (row[0] * free[0] + row[1] * free[1])
        return tuple(mass * rate for rate in free), mass

    @property
    def effective_mass(self):
        return self.response()[1]

    def velocities(self, speed):
        (inner, outer), _ = self.response()
        (ex, ey), c, d = self.elbow, self.bodies["inner"][2], self.bodies["outer"][2]
        inner, outer = -speed * inner, -speed * outer
        outer_velocity = (-inner * ey - outer * (d[1] - ey), inner * ex + outer * (d[0] - ex))
        return {"inner": ((-inner * c[1], inner * c[0]), inner), "outer": (outer_velocity, outer)}

    @property
    def urdf(self):
        links = ""
        for name, origin in (("inner", (0.0, 0.0)), ("outer", self.elbow)):
            mass, i, c, _ = self.bodies[name]
            inertia = f'<inertia ixx="{i}" iyy="{i}" izz="{i}" ixy="0" ixz="0" iyz="0"/>'
            links += f"""
  <link name="{name}"><inertial><origin xyz="{c[0] - origin[0]!r} {c[1] - origin[1]!r} 0"/><mass value="{mass}"/>{inertia}</inertial></link>"""
        return f"""<robot name="double_pendulum">
  <link name="world"/>{links}
  <joint name="shoulder" type="continuous"><parent link="world"/><child link="inner"/><axis xyz="0 0 1"/></joint>
  <joint name="elbow" type="continuous">
    <parent link="inner"/><child link="outer"/><origin xyz="{self.elbow[0]} {self.elbow[1]} 0"/><axis xyz="0 0 1"/>
  </joint>
</robot>
"""

    def contact(self, folder):
        path = Path(folder) / "double_pendulum.urdf"
        path.write_text(self.urdf)
        point = ",".join(repr(p - e) for p, e in zip(self.point, self.elbow))
        where = ("--link", "outer", "--point", f"{point},0", "--normal", "0,1,0", "--own-mass", repr(self.own_mass))
        return Contact(("--mass-from", str(path), *where), self.stiffness, self.speed)

    def alone(self, folder):
        return dataclasses.replace(alone(self.own_mass), stiffness=self.stiffness, speed=self.speed)


def levers(count, seed=24):
    """Random compound levers without rotors, each with a restitution: m̄/m from 0.1 to 50; the centre of mass up to 0.3 m off the line
    from hinge to contact; e from 0.15 to 0.9, 0.02 to 2 m/s, 1e4 to 1e6 N/m."""
    dice, made = random.Random(seed), []

    def between(low, high):
        return math.exp(dice.uniform(math.log(low), math.log(high)))

    while len(made) < count:
        # Golden-ratio sequence: the first few levers are spread over the range of m̄/m.
        share = (len(made) * 0.618 + dice.random() * 0.1) % 1
        mass, lever, ratio = between(0.3, 5.0), dice.uniform(0.2, 0.6), 0.1 * 500**share
        centre, offset = dice.uniform(0.05, 0.6), dice.uniform(-0.3, 0.3)
        inertia = mass * (ratio * lever**2 - centre**2 - offset**2)
        stiffness, speed, restitution = between(1e4, 1e6), between(0.02, 2.0), dice.uniform(0.15, 0.9)
        if inertia > 0.05 * mass * ratio * lever**2:
            made.append((Pendulum(mass, centre, inertia, lever, 0.02, 0.0, offset, stiffness, speed), restitution))
    return made


BALL = Ball(2.0, 0.05)
# (ball, restitution): light and fast, heavy and slow.
BALLS = [(Ball(0.37, 0.05, 1e4, 2.0), 0.15), (Ball(0.37, 0.05, 1e6, 0.3), 0.9), (Ball(2.0, 0.05, 1e5, 0.02), 0.5)]
# (scene, restitution): m̄/m of the lever 0.25 against a heavy ball, 8 against a light one; the centres of mass off the line.
TWO_BODIES = [
    (TwoBodies(Pendulum(2.0, 0.15, 0.02, 0.4, 0.03, offset=0.1, speed=0.5), 3.0), 0.35),
    (TwoBodies(Pendulum(1.1, 0.5, 0.7, 0.35, 0.03, offset=-0.2, stiffness=3e5, speed=1.2), 0.6), 0.75),
]
FOUR_BAR = FourBar()
DOUBLE_PENDULUM = DoublePendulum()
# m̄ = 1.5 and 3.75 kg, of a body of 2 kg.
PENDULUMS = [Pendulum(2.0, 0.3, 0.06, 0.4, 0.02, rotor) for rotor in (0.0, 0.36)]


def velocities(linkage, speed):
    """(x and y of the centre of mass's velocity, rate) of each body when the point approaches the wall at `speed`."""
    return linkage.velocities(speed)


def four_bar_velocities(four_bar, speed):
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
