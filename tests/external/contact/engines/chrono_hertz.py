"""Project Chrono's smooth contacts with material properties, Hertz: see chrono.py for its usage."""

from engines import chrono
from engines.chrono import engine  # noqa: F401

TOOL, BY_HAND, SNIPPETS = chrono.TOOL, True, chrono.SNIPPETS
EXPONENT = 1.5
SOLVERS = {"Hertz, material properties": "default"}
# Time step, not set by the export, s: several hundred steps per contact.
STEP = 5e-6


def contact(parameters):
    return "hertz", parameters["E_eff"], parameters["cr"], STEP


def ball(parameters, solver, ball, speed):
    return chrono.ball(parameters, solver, ball, speed, contact)


def pendulum(parameters, solver, pendulum, speed):
    return chrono.pendulum(parameters, solver, pendulum, speed, contact)


def four_bar(parameters, solver, four_bar, speed):
    return chrono.four_bar(parameters, solver, four_bar, speed, contact)
