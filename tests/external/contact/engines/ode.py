"""Open Dynamics Engine: `ode.c` and `ode_stops.c`, compiled by cc on Debian's libode-dev. Step and QuickStep, maximal coordinates."""

import re

from engines import _built

TOOL = "ode"
# The program's word, and QuickStep's iterations.
SOLVERS = {"Step": ("step", 0), "QuickStep": ("quick", 20)}
LIBRARIES = ("-lode", "-lstdc++", "-lm", "-lpthread")


def engine():
    _built.needs("libode-dev", "cc", "ode-config")
    return f"ODE {_built.output('ode-config', '--version').strip()}"


def run(parameters, solver, speed, *scene):
    program = _built.c("ode.c", LIBRARIES)
    p = parameters
    numbers = (p["soft_erp"], p["soft_cfm"], p["time_step"], speed)
    return _built.outcome(program, (*solver, *numbers, *scene), speed * p["time_step"])


def ball(parameters, solver, ball, speed):
    return run(parameters, solver, speed, "ball", ball.mass, ball.radius)


def pendulum(parameters, solver, pendulum, speed):
    p = pendulum
    return run(parameters, solver, speed, "pendulum", p.mass, p.centre, p.offset, p.turning_inertia, p.lever, p.radius)


def two_bodies(parameters, solver, bodies, speed):
    p = bodies.lever
    lever = (p.mass, p.centre, p.offset, p.turning_inertia, p.lever, p.radius)
    return run(parameters, solver, speed, "two_bodies", *lever, bodies.share, bodies.mass, bodies.radius)


def four_bar(parameters, solver, four_bar, speed):
    return run(parameters, solver, speed, "linkage", *_built.linkage(four_bar, speed))


linkage = four_bar


def stop(parameters, solver, stop, speed):
    """A body on a fixed hinge takes the hinge's rotor to its inertia."""
    names = [body.name for body in stop.bodies]
    rotor = stop.tree[stop.limited][2] if stop.tree else 0.0
    p = parameters
    words = [*solver, p["stop_erp"], p["stop_cfm"], p["bounce"], p["time_step"], speed]
    words += [len(stop.bodies), len(stop.joints), stop.limited, stop.end]
    for body in stop.bodies:
        held = rotor if body.name == stop.joints[stop.limited].child else 0.0
        words += [body.mass, body.inertia + held, *body.centre, *(speed * v for v in body.velocity), speed * body.rate]
    for joint in stop.joints:
        words += [int(joint.slides), names.index(joint.child), names.index(joint.parent) if joint.parent else -1, *joint.where]
    return _built.outcome(_built.c("ode_stops.c", LIBRARIES), words, speed * p["time_step"])


def compiles(text, parameters):
    """In a near callback and a loop of a user's."""
    source = "#include <ode/ode.h>\nvoid paste(dContact &contact, dJointID joint, dWorldID world) {\n" + text + "}\n"
    _built.compiles(source, "-fsyntax-only")
    for name, number in re.findall(r"(soft_erp|soft_cfm) = ([^;]+);", text):
        assert float(number) == parameters[name], name
    for name, number in re.findall(r"dParam(StopERP|StopCFM|Bounce), ([^)]+)\)", text):
        assert float(number) == parameters[{"StopERP": "stop_erp", "StopCFM": "stop_cfm", "Bounce": "bounce"}[name]], name
    assert float(re.search(r"dWorldStep\(world, (.*)\);", text)[1]) == parameters["time_step"]


SNIPPETS = {"cpp": compiles}
