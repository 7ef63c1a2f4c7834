"""Rapier: the cargo project in `rapier/`, with a lock file of its own. A pendulum is a multibody there; impulse joints do not
reach the restitution."""

import json
import re

from engines import _built
from impacts import PHASES, Outcome

TOOL = "rapier"
SOLVERS = {"multibody joints": "multibody"}
PROJECT = _built.HERE.parent / "rapier"
# Where the export leaves it open, each of these.
TIME_STEPS = (1 / 60, 1 / 240, 1e-3, 1e-4)


def cargo(command, project, *more):
    target = (_built.BUILT / "rapier").absolute()
    _built.needs("Rust", "cargo")
    flags = ("--quiet", "--locked", "--release", "--manifest-path", project / "Cargo.toml", "--target-dir", target)
    _built.output("cargo", command, *flags, *more)
    return target


def engine():
    version = re.search(r'name = "rapier3d-f64"\nversion = "(.*)"', (PROJECT / "Cargo.lock").read_text())[1]
    cargo("build", PROJECT)
    return f"Rapier {version}"


def impacts(parameters, speed, **what):
    program = _built.BUILT / "rapier/release/rapier-impacts"
    step, shown = parameters.get("dt"), []
    for h in (step,) if step else TIME_STEPS:
        gaps = [phase * h * speed for phase in PHASES]
        asked = {"restitution": parameters["restitution"], "dt": h, "speed": speed, "gaps": gaps} | what
        asked["damping"] = parameters["multibody_damping"]
        shown += json.loads(_built.output(program, input=json.dumps(asked)))
    shown = iter(shown)
    return Outcome.of(lambda _: next(shown), range(len(PHASES) * (1 if step else len(TIME_STEPS))))


def ball(parameters, solver, ball, speed):
    inertia = 0.4 * ball.mass * ball.radius**2
    body = {"mass": ball.mass, "radius": ball.radius, "inertia": inertia, "centre": 0.0, "offset": 0.0, "lever": 0.0, "rotor": 0.0}
    return impacts(parameters, speed, joint=None, **body)


def pendulum(parameters, solver, pendulum, speed):
    p = pendulum
    body = {"mass": p.mass, "radius": p.radius, "inertia": p.inertia, "centre": p.centre, "offset": p.offset, "lever": p.lever, "rotor": p.rotor}
    return impacts(parameters, speed, joint=solver, **body)


def linkage(parameters, solver, linkage, speed):
    """An open chain, its hinges in the order of the bodies."""
    chain, before, moving = [], 0.0, linkage.velocities(speed)
    for name, _, at in linkage.hinges:
        mass, inertia, centre, _ = linkage.bodies[name]
        rate = moving[name][1]
        chain.append({"mass": mass, "inertia": inertia, "centre": centre, "hinge": at, "rate": rate - before})
        before = rate
    return impacts(parameters, speed, chain=chain, point=linkage.point, radius=linkage.radius)


def two_bodies(parameters, solver, bodies, speed):
    p, other = bodies.lever, {"mass": bodies.mass, "radius": bodies.radius, "speed": (1 - bodies.share) * speed}
    body = {"mass": p.mass, "radius": p.radius, "inertia": p.inertia, "centre": p.centre, "offset": p.offset, "lever": p.lever, "rotor": p.rotor}
    return impacts(parameters, speed, joint=solver, other=other, **body)


def compiles(text, parameters):
    """As a module of the project, in a copy of it."""
    copy = (_built.BUILT / "rapier-pasted").absolute()
    (copy / "src").mkdir(parents=True, exist_ok=True)
    for name in ("Cargo.toml", "Cargo.lock"):
        (copy / name).write_text((PROJECT / name).read_text().replace('"rapier-impacts"', '"rapier-pasted"'))
    (copy / "src/main.rs").write_text("#![allow(dead_code, unused_imports)]\n" + text + "\nfn main() {}\n")
    cargo("build", copy)
    assert f"restitution({parameters['restitution']!r})" in text


SNIPPETS = {"rust": compiles}
