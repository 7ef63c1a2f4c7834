"""Impacts in Exudyn."""

import contextlib
import math

import numpy as np

from impacts import Outcome
from scenes import Absent

try:
    import exudyn
    from exudyn.utilities import (
        InertiaSphere,
        MarkerBodyRigid,
        NodeGenericData,
        ObjectContactSphereSphere,
        RigidBodyInertia,
    )
except ImportError:
    exudyn = None

TOOL = "exudyn"
SOLVERS = {"": None}
# The sphere that stands for a wall, m.
WALL = 1.0
# Steps of free flight before the contact, and how long its end is waited for, in undamped half periods.
FLIGHT, LONGEST = 2, 2.5


def engine():
    if not exudyn:
        raise Absent("exudyn==1.13.6")
    return f"Exudyn {exudyn.__version__}"


def ball(parameters, solver, ball, speed):
    def build(system, ground, height):
        body = system.CreateRigidBody(
            inertia=InertiaSphere(ball.mass, ball.radius), referencePosition=[0, 0, height], initialVelocity=[0, 0, -speed], gravity=[0, 0, 0]
        )
        return body, [0, 0, 0]

    return impacts(build, parameters, ball.mass, ball.radius, speed)


def pendulum(parameters, solver, pendulum, speed):
    """The rotor's inertia is added to the body's about the hinge's axis."""

    def build(system, ground, height):
        angle = math.asin(height / pendulum.lever)
        about = pendulum.inertia
        # It warns that no body has such an inertia: it has the rotor's too.
        with contextlib.redirect_stdout(None):
            inertia = RigidBodyInertia(pendulum.mass, np.diag([about, about + pendulum.rotor, about]))
        rate = -speed / pendulum.lever
        turn = [[math.cos(angle), 0, -math.sin(angle)], [0, 1, 0], [math.sin(angle), 0, math.cos(angle)]]
        centre = [pendulum.centre * math.cos(angle), 0, pendulum.centre * math.sin(angle)]
        body = system.CreateRigidBody(
            inertia=inertia,
            referencePosition=centre,
            referenceRotationMatrix=turn,
            initialAngularVelocity=[0, -rate, 0],
            initialVelocity=[-rate * centre[2], 0, rate * centre[0]],
            gravity=[0, 0, 0],
        )
        system.CreateRevoluteJoint(bodyNumbers=[ground, body], position=[0, 0, 0], axis=[0, 1, 0], useGlobalFrame=True, show=False)
        return body, [pendulum.lever - pendulum.centre, 0, 0]

    return impacts(build, parameters, pendulum.effective_mass, pendulum.radius, speed)


def impacts(build, parameters, mass, radius, speed):
    """A plane is a sphere of 1 m; mass: for the duration only. The penetration is not looked at."""
    step = parameters["stepSize"]
    steps = FLIGHT + math.ceil(LONGEST * math.pi * math.sqrt(mass / parameters["contactStiffness"]) / step)

    def run(phase):
        system = exudyn.SystemContainer().AddSystem()
        ground = system.CreateGround(referencePosition=[0, 0, 0])
        height = (FLIGHT + phase) * step * speed
        body, place = build(system, ground, height)
        below = system.GetObjectOutputBody(body, exudyn.OutputVariableType.Position, place, exudyn.ConfigurationType.Reference)
        stop = system.AddMarker(MarkerBodyRigid(bodyNumber=ground, localPosition=[below[0], 0, -WALL - radius]))
        struck = system.AddMarker(MarkerBodyRigid(bodyNumber=body, localPosition=place))
        node = system.AddNode(NodeGenericData(numberOfDataCoordinates=4, initialCoordinates=[height, 0, 0, 0]))
        system.AddObject(
            ObjectContactSphereSphere(
                markerNumbers=[stop, struck],
                nodeNumber=node,
                spheresRadii=[WALL, radius],
                contactStiffness=parameters["contactStiffness"],
                contactDamping=parameters["contactDamping"],
                contactStiffnessExponent=parameters["contactStiffnessExponent"],
                impactModel=int(parameters["impactModel"]),
                dynamicFriction=parameters["dynamicFriction"],
            )
        )
        system.Assemble()
        settings = exudyn.SimulationSettings()
        settings.timeIntegration.numberOfSteps = steps
        settings.timeIntegration.endTime = steps * step
        settings.timeIntegration.discontinuous.iterationTolerance = parameters["discontinuous.iterationTolerance"]
        settings.timeIntegration.discontinuous.maxIterations = int(parameters["discontinuous.maxIterations"])
        settings.solutionSettings.writeSolutionToFile = False
        system.SolveDynamic(settings)
        velocity = system.GetObjectOutputBody(body, exudyn.OutputVariableType.Velocity, place)
        return velocity[2] / speed, 0.0

    return Outcome.of(run)


def pasted(text, parameters):
    names = {}
    exec(text, names)
    found = names["contact"]([0, 1], 0, [1.0, 1.0])
    for name in ("contactStiffness", "contactDamping", "impactModel"):
        assert getattr(found, name) == parameters[name], name
    found = names["settings"](1.0).timeIntegration
    assert found.discontinuous.iterationTolerance == parameters["discontinuous.iterationTolerance"]


SNIPPETS = {"python": pasted}
