"""Impacts in Jolt, by npm's jolt-physics and node: jolt_scenes.mjs has the scenes.

The package is looked for in target/external/node_modules, or where PERCUSS_JOLT says."""

import dataclasses
import json
import os
import shutil
import subprocess
from pathlib import Path

import numpy as np

from impacts import PHASES, Outcome
from scenes import Absent, Refused, velocities

TOOL = "jolt"
# mNumVelocitySteps of closed loops and chains, which the export does not compute, and of one body.
LOOPS = 1000
SOLVERS = {"one body": False, "chains and closed loops": True}
# Where there is no node.
BY_HAND = True
HERE = Path(__file__).parent
PACKAGE = Path(os.environ.get("PERCUSS_JOLT", HERE.parents[3] / "target/external/node_modules/jolt-physics"))


def engine():
    if not PACKAGE.is_dir() or not shutil.which("node"):
        raise Absent("node, and jolt-physics@1.1.0 by npm")
    return f"jolt-physics {json.loads((PACKAGE / 'package.json').read_text())['version']}"


def ball(parameters, solver, ball, speed):
    return outcome({"ball": dataclasses.asdict(ball)}, parameters, solver, speed)


def pendulum(parameters, solver, pendulum, speed):
    """The rotor's inertia is added to the body's about the hinge's axis."""
    return outcome({"pendulum": dataclasses.asdict(pendulum)}, parameters, solver, speed)


def two_bodies(parameters, solver, bodies, speed):
    scene = dataclasses.asdict(bodies.lever) | {"ball": {"mass": bodies.mass, "radius": bodies.radius, "share": 1 - bodies.share}}
    return outcome({"pendulum": scene}, parameters, solver, speed)


def four_bar(parameters, solver, four_bar, speed):
    names, moving = [*four_bar.bodies], velocities(four_bar, speed)
    bodies = [
        {"mass": mass, "inertia": inertia, "centre": centre, "velocity": moving[name][0], "rate": moving[name][1]}
        for name, (mass, inertia, centre, _) in four_bar.bodies.items()
    ]
    hinges = [(names.index(a), names.index(b) if b else None, *at) for a, b, at in four_bar.hinges]
    scene = {"radius": four_bar.radius, "point": four_bar.point, "struck": names.index(four_bar.struck), "bodies": bodies, "hinges": hinges}
    return outcome({"four_bar": scene}, parameters, solver, speed)


linkage = four_bar


def outcome(scene, parameters, solver, speed):
    if solver is not None and (parameters["mNumVelocitySteps"] == LOOPS) != solver:
        raise Refused("turns")
    request = {
        "package": str(PACKAGE),
        "parameters": parameters,
        "other": None,
        "step": parameters["inDeltaTime"],
        "phases": PHASES,
        "speed": speed,
    }
    run = subprocess.run(
        ["node", HERE / "jolt_scenes.mjs"], input=json.dumps(request | scene), capture_output=True, text=True
    )
    if run.returncode:
        raise RuntimeError(run.stderr)
    restitutions, depths = np.array(json.loads(run.stdout)["impacts"]).T
    return Outcome(restitutions, float(depths.max()))


def pasted(text, parameters):
    """Whether node takes it, and sets what it says."""
    test = (
        text
        + "\nconst body = {}, settings = {}; dress(body);"
        + "\nsetUp({ GetPhysicsSettings: () => settings, SetPhysicsSettings: () => {} });"
        + "\nconsole.log(JSON.stringify({ ...body, ...settings }));\n"
    )
    run = subprocess.run(["node", "--input-type=module"], input=test, capture_output=True, text=True, check=True)
    for name, value in json.loads(run.stdout).items():
        assert value == parameters[name], name


SNIPPETS = {"javascript": pasted}
