"""Project Chrono's smooth contacts, by the program of tests/external/by_hand/chrono.cc, which chrono.sh there builds and runs this with.
Hooke with user coefficients; the wall is a fixed body with Chrono's default mass."""

import functools
import os
import re
from pathlib import Path

from engines import _built
from scenes import Absent

TOOL = "chrono"
# The program's word for the solver of the joints; by "qr" and "lu", direct ones, it is the same to 1e-10.
SOLVERS = {"Hooke, kn and gn": "default"}
BY_HAND = True


def program():
    given = os.environ.get("PERCUSS_CHRONO")
    if not given:
        raise Absent("it by tests/external/by_hand/chrono.sh, which runs this")
    return Path(given)


def engine():
    return f"Chrono {_built.output(program(), '--version').strip()}"


def contact(parameters):
    """Model, its two numbers, step."""
    return "hooke", parameters["kn"], parameters["gn"], parameters["step"]


def run(contact, solver, speed, *scene):
    step, no_friction, wall = contact[3], 0.0, 0.0
    return _built.outcome(program(), (*contact, speed, solver, no_friction, wall, *scene), speed * step)


def ball(parameters, solver, ball, speed, contact=contact):
    return run(contact(parameters), solver, speed, "ball", ball.mass, ball.radius)


def pendulum(parameters, solver, pendulum, speed, contact=contact):
    p = pendulum
    return run(contact(parameters), solver, speed, "pendulum", p.mass, p.centre, p.offset, p.turning_inertia, p.lever, p.radius)


def four_bar(parameters, solver, four_bar, speed, contact=contact):
    return run(contact(parameters), solver, speed, "four-bar", *_built.four_bar(four_bar, speed))


HEADERS = """#include "chrono/physics/ChContactMaterialSMC.h"
#include "chrono/physics/ChSystemSMC.h"
void paste(chrono::ChSystemSMC &system, std::shared_ptr<chrono::ChContactMaterialSMC> material) {
%s}
"""


@functools.cache
def compiles(text):
    folders = os.environ["PERCUSS_CHRONO_HEADERS"].split(":")
    _built.compiles(HEADERS % text, "-w", *(word for folder in folders for word in ("-isystem", folder)))


def pasted(text, parameters):
    """The numbers are the exported ones, and with others a compiler takes it: once, for it takes ten seconds."""
    numbers = {"SetKn": "kn", "SetGn": "gn", "DoStepDynamics": "step", "SetRestitution": "cr"}
    for setter, number in re.findall(r"(\w+)\(([-+.e\d]+)f?\);", text):
        if name := numbers.get(setter):
            assert float(number) == parameters[name], name
    compiles(re.sub(r"\d+\.\d*(e-?\d+)?", "0.5", text))


SNIPPETS = {"cpp": pasted}
