"""Project Chrono's smooth contacts with material properties, Hertz: chrono.py says how it is run."""

from engines import chrono
from engines.chrono import engine  # noqa: F401

TOOL, BY_HAND, SNIPPETS = chrono.TOOL, True, chrono.SNIPPETS
EXPONENT = 1.5
SOLVERS = {"Hertz, material properties": "default"}
# The step that the export leaves open, s: several hundred in a contact.
STEP = 5e-6


def contact(parameters):
    return "hertz", parameters["E_eff"], parameters["cr"], STEP


def ball(parameters, solver, ball, speed):
    return chrono.ball(parameters, solver, ball, speed, contact)


def pendulum(parameters, solver, pendulum, speed):
    return chrono.pendulum(parameters, solver, pendulum, speed, contact)


def four_bar(parameters, solver, four_bar, speed):
    return chrono.four_bar(parameters, solver, four_bar, speed, contact)
