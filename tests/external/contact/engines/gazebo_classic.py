"""Gazebo Classic 11 in a Debian 11 root that tests/external/by_hand/gazebo_classic.sh makes; that script runs this."""

import os
from pathlib import Path

from engines import _built
from impacts import PHASES, Outcome
from scenes import Absent

TOOL = "gazebo-classic"
SOLVERS = {"world": None}
# Its paths; no model database, no network.
ENVIRONMENT = ". /usr/share/gazebo/setup.sh; export HOME=/tmp GAZEBO_MODEL_DATABASE_URI= GAZEBO_IP=127.0.0.1;"
BY_HAND = True
# The time that is simulated, s: several contacts.
TIME = 0.06


def root():
    folder = os.environ.get("PERCUSS_GAZEBO_CLASSIC")
    if not folder:
        raise Absent("it by tests/external/by_hand/gazebo_classic.sh, which runs this")
    return Path(folder)


def inside(*command):
    return _built.output("chroot", root(), "sh", "-c", f'{ENVIRONMENT} exec "$0" "$@"', *command, timeout=300)


def engine():
    version = inside("pkg-config", "--modversion", "gazebo").strip()
    return f"Gazebo Classic {version}"


def surface(p):
    return f"""<surface>
        <friction><ode><mu>{p["mu"]!r}</mu><mu2>{p["mu"]!r}</mu2></ode></friction>
        <contact><ode>
          <kp>{p["kp"]!r}</kp><kd>{p["kd"]!r}</kd><max_vel>{p["max_vel"]!r}</max_vel><min_depth>{p["min_depth"]!r}</min_depth>
        </ode></contact>
      </surface>"""


def impacts(parameters, speed, lever, mass, centre, offset, inertia, radius):
    """All phases side by side in one world."""
    p, i = parameters, f"<ixx>{inertia!r}</ixx><iyy>{inertia!r}</iyy><izz>{inertia!r}</izz>"
    h = p["max_step_size"]
    gaps = [phase * h * speed for phase in PHASES]
    models = ""
    for n, gap in enumerate(gaps):
        hinge = '<joint name="hinge" type="revolute"><parent>world</parent><child>link</child><axis><xyz>0 -1 0</xyz></axis></joint>'
        models += f"""
  <model name="floor{n}"><static>true</static><pose>{9 * n} 0 {-radius - gap - 1!r} 0 0 0</pose><link name="link">
    <collision name="c"><geometry><box><size>2 2 2</size></box></geometry>{surface(p)}</collision>
  </link></model>
  <model name="struck{n}"><pose>{9 * n} 0 0 0 0 0</pose>
    <link name="link">
      <inertial><pose>{centre!r} 0 {offset!r} 0 0 0</pose><mass>{mass!r}</mass><inertia>{i}</inertia></inertial>
      <collision name="c"><pose>{lever!r} 0 0 0 0 0</pose>
        <geometry><sphere><radius>{radius!r}</radius></sphere></geometry>{surface(p)}
      </collision>
    </link>
    {hinge if lever else ""}
  </model>"""
    # As in the export.
    text = f"""<sdf version="1.6"><world name="default">
  <gravity>0 0 0</gravity>
  <physics name="step" type="ode"><max_step_size>{h!r}</max_step_size><real_time_update_rate>0</real_time_update_rate>
    <ode><solver><type>{p["solver"]}</type></solver></ode>
  </physics>{models}
</world></sdf>"""
    (root() / "tmp/percuss.world").write_text(text)
    words = ("/tmp/percuss.world", round(TIME / h), repr(speed), repr(lever), *map(repr, gaps))
    lines = iter(inside("/tmp/gazebo_classic", *words).splitlines()[-len(gaps) :])
    return Outcome.of(lambda _: [float(word) for word in next(lines).split()])


def ball(parameters, solver, ball, speed):
    return impacts(parameters, speed, 0.0, ball.mass, 0.0, 0.0, 0.4 * ball.mass * ball.radius**2, ball.radius)


def pendulum(parameters, solver, pendulum, speed):
    p = pendulum
    return impacts(parameters, speed, p.lever, p.mass, p.centre, p.offset, p.turning_inertia, p.radius)


def read(text, parameters):
    """By Classic's own SDFormat."""
    (root() / "tmp/percuss.sdf").write_text(text)
    shown = inside("gz", "sdf", "-p", "/tmp/percuss.sdf")
    for name in ("kp", "kd", "max_vel"):
        found = float(shown.split(f"<{name}>")[1].split("<")[0])
        assert abs(found / parameters[name] - 1) < 1e-5, f"{name}: {found}, exported {parameters[name]}"
    assert "<type>world</type>" in shown


SNIPPETS = {"xml": read}
