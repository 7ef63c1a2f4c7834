"""New Gazebo: `gz_dartsim.cc`, the dartsim plugin of gz-physics (Debian's ign-physics 5, the same code under its older name)."""

import tempfile
from pathlib import Path

import numpy as np
from engines import _built
from impacts import PHASES, Outcome
from scenes import Absent

TOOL = "gazebo"
SOLVERS = {"dartsim": None}
PACKAGES = ("ignition-physics5", "ignition-physics5-sdf", "ignition-plugin1-loader", "sdformat12")
PLUGIN = "ign-physics-5/engine-plugins/libignition-physics-dartsim-plugin.so"
# Where the export leaves it open, each of these.
TIME_STEPS = (1e-3, 1e-2, 1e-4)


def engine():
    _built.needs("libignition-physics-dev, libignition-physics5-dartsim-plugin5", "c++", "pkg-config")
    try:
        version = _built.output("pkg-config", "--modversion", PACKAGES[0]).strip()
        assert plugin().exists()
    except (RuntimeError, AssertionError):
        raise Absent("libignition-physics-dev, libignition-physics5-dartsim-plugin5") from None
    return f"ign-physics {version}"


def plugin():
    return Path(_built.output("pkg-config", "--variable=libdir", PACKAGES[0]).strip()) / PLUGIN


def surface(coefficient, mu):
    return f"""<surface>
        <friction><ode><mu>{mu!r}</mu><mu2>{mu!r}</mu2></ode></friction>
        <bounce><restitution_coefficient>{coefficient!r}</restitution_coefficient></bounce>
      </surface>"""


def world(struck, below, p):
    """`struck` is the model's inside; a floor at the height `below`."""
    return f"""<sdf version="1.9"><world name="w">
  <gravity>0 0 0</gravity>
  <model name="floor">
    <static>true</static>
    <pose>0 0 {below!r} 0 0 0</pose>
    <link name="link"><collision name="c">
      <geometry><plane><normal>0 0 1</normal><size>9 9</size></plane></geometry>
      {surface(p["other_restitution_coefficient"], p["mu"])}
    </collision></link>
  </model>
  <model name="struck">{struck}</model>
</world></sdf>"""


def link(mass, centre, offset, inertia, at, radius, p):
    i = f"<ixx>{inertia!r}</ixx><iyy>{inertia!r}</iyy><izz>{inertia!r}</izz>"
    return f"""
    <link name="link">
      <inertial><pose>{centre!r} 0 {offset!r} 0 0 0</pose><mass>{mass!r}</mass><inertia>{i}</inertia></inertial>
      <collision name="c">
        <pose>{at!r} 0 0 0 0 0</pose>
        <geometry><sphere><radius>{radius!r}</radius></sphere></geometry>
        {surface(p["restitution_coefficient"], p["mu"])}
      </collision>
    </link>"""


def impacts(struck, radius, parameters, speed, lever):
    flags = [word for way in ("--cflags", "--libs") for word in _built.output("pkg-config", way, *PACKAGES).split()]
    program = _built.c("gz_dartsim.cc", flags, ("c++", "-std=c++17", "-O1"))
    step = parameters.get("max_step_size")
    shown = []
    with tempfile.TemporaryDirectory() as folder:
        for h in (step,) if step else TIME_STEPS:
            files = []
            for phase in PHASES:
                files.append(Path(folder) / f"{h}-{phase}.sdf")
                files[-1].write_text(world(struck, -radius - phase * h * speed, parameters))
            lines = _built.output(program, plugin(), repr(h), repr(speed), repr(lever), *files).splitlines()
            shown += [[float(word) for word in line.split()] for line in lines]
    restitutions, depths = np.array(shown).T
    return Outcome(restitutions, float(depths.max()))


def ball(parameters, solver, ball, speed):
    struck = link(ball.mass, 0.0, 0.0, 0.4 * ball.mass * ball.radius**2, 0.0, ball.radius, parameters)
    return impacts(struck, ball.radius, parameters, speed, 0.0)


def pendulum(parameters, solver, pendulum, speed):
    p = pendulum
    struck = link(p.mass, p.centre, p.offset, p.turning_inertia, p.lever, p.radius, parameters)
    struck += """
    <joint name="hinge" type="revolute"><parent>world</parent><child>link</child><axis><xyz>0 -1 0</xyz></axis></joint>"""
    return impacts(struck, p.radius, parameters, speed, p.lever)

