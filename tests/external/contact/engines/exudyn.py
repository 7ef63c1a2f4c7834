"""Impacts in Exudyn."""

import contextlib
import math

import numpy as np

from impacts import Outcome
from scenes import Absent, velocities

try:
    import exudyn
    from exudyn.utilities import (
        InertiaSphere,
        MarkerBodyRigid,
        NodeGenericData,
        ObjectContactSphereSphere,
        RigidBodyInertia,
        SensorBody,
    )
except ImportError:
    exudyn = None

TOOL = "exudyn"
SOLVERS = {"": None}
# The sphere that stands for a wall, m.
WALL = 1.0
# Steps of free flight before the contact, how long its end is waited for, in undamped half periods, and steps after it.
FLIGHT, LONGEST, AFTER = 2, 2.5, 2
# The hinge that closes the four-bar.
CLOSES = ("coupler", "rocker")


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
    return impacts(lever(pendulum, speed), parameters, pendulum.effective_mass, pendulum.radius, speed)


def two_bodies(parameters, solver, bodies, speed):
    built, share = lever(bodies.lever, bodies.share * speed), bodies.share

    def build(system, ground, height):
        return built(system, ground, share * height)

    def opposite(system, height):
        body = system.CreateRigidBody(
            inertia=InertiaSphere(bodies.mass, bodies.radius),
            referencePosition=[bodies.lever.lever, 0, -bodies.distance - (1 - share) * height],
            initialVelocity=[0, 0, (1 - share) * speed],
            gravity=[0, 0, 0],
        )
        return body, bodies.radius

    return impacts(build, parameters, bodies.effective_mass, bodies.lever.radius, speed, opposite)


def lever(pendulum, speed):
    """The rotor's inertia is added to the body's about the hinge's axis."""

    def build(system, ground, height):
        angle = math.asin(height / pendulum.lever)
        about = pendulum.inertia
        # It warns that no body has such an inertia: it has the rotor's too.
        with contextlib.redirect_stdout(None):
            inertia = RigidBodyInertia(pendulum.mass, np.diag([about, about + pendulum.rotor, about]))
        rate = -speed / pendulum.lever
        turn = [[math.cos(angle), 0, -math.sin(angle)], [0, 1, 0], [math.sin(angle), 0, math.cos(angle)]]
        x, z = pendulum.centre, pendulum.offset
        centre = [x * math.cos(angle) - z * math.sin(angle), 0, x * math.sin(angle) + z * math.cos(angle)]
        body = system.CreateRigidBody(
            inertia=inertia,
            referencePosition=centre,
            referenceRotationMatrix=turn,
            initialAngularVelocity=[0, -rate, 0],
            initialVelocity=[-rate * centre[2], 0, rate * centre[0]],
            gravity=[0, 0, 0],
        )
        system.CreateRevoluteJoint(bodyNumbers=[ground, body], position=[0, 0, 0], axis=[0, 1, 0], useGlobalFrame=True, show=False)
        return body, [pendulum.lever - pendulum.centre, 0, -pendulum.offset]

    return build


def four_bar(parameters, solver, four_bar, speed):
    """In the plane of x and z: what is drawn along y is along z, and a turn about z is one about −y. The hinge that closes the
    loop holds x and z only: its other rows would be redundant."""

    def build(system, ground, height):
        bodies = {None: ground}
        for name, (velocity, rate) in velocities(four_bar, speed).items():
            mass, inertia, (x, y), _ = four_bar.bodies[name]
            bodies[name] = system.CreateRigidBody(
                inertia=RigidBodyInertia(mass, inertia * np.eye(3)),
                referencePosition=[x, 0, y],
                initialVelocity=[velocity[0], 0, velocity[1]],
                initialAngularVelocity=[0, -rate, 0],
                gravity=[0, 0, 0],
            )
        for a, b, (x, y) in four_bar.hinges:
            pair, at = [bodies[b], bodies[a]], [x, 0, y]
            if (a, b) == CLOSES:
                system.CreateGenericJoint(bodyNumbers=pair, position=at, constrainedAxes=[1, 0, 1, 0, 0, 0], useGlobalFrame=True, show=False)
            else:
                system.CreateRevoluteJoint(bodyNumbers=pair, position=at, axis=[0, 1, 0], useGlobalFrame=True, show=False)
        centre = four_bar.bodies[four_bar.struck][2]
        return bodies[four_bar.struck], [four_bar.point[0] - centre[0], 0, four_bar.point[1] - centre[1]]

    return impacts(build, parameters, four_bar.effective_mass, four_bar.radius, speed)


linkage = four_bar


def impacts(build, parameters, mass, radius, speed, opposite=None):
    """A plane is a sphere of 1 m; mass: for the duration only. `opposite(system, height)` builds another body instead and returns it with
    its sphere's radius. The speed is that shortly after the gap has opened: a linkage's changes as it moves on."""
    step = parameters["stepSize"]
    steps = FLIGHT + math.ceil(LONGEST * math.pi * math.sqrt(mass / parameters["contactStiffness"]) / step)

    def run(phase):
        system = exudyn.SystemContainer().AddSystem()
        ground = system.CreateGround(referencePosition=[0, 0, 0])
        height = (FLIGHT + phase) * step * speed
        body, place = build(system, ground, height)
        below = system.GetObjectOutputBody(body, exudyn.OutputVariableType.Position, place, exudyn.ConfigurationType.Reference)
        if opposite:
            other, wall = opposite(system, height)
            stop = system.AddMarker(MarkerBodyRigid(bodyNumber=other, localPosition=[0, 0, 0]))
        else:
            other, wall = ground, WALL
            stop = system.AddMarker(MarkerBodyRigid(bodyNumber=ground, localPosition=[below[0], 0, below[2] - height - radius - WALL]))
        struck = system.AddMarker(MarkerBodyRigid(bodyNumber=body, localPosition=place))
        node = system.AddNode(NodeGenericData(numberOfDataCoordinates=4, initialCoordinates=[height, 0, 0, 0]))
        system.AddObject(
            ObjectContactSphereSphere(
                markerNumbers=[stop, struck],
                nodeNumber=node,
                spheresRadii=[wall, radius],
                contactStiffness=parameters["contactStiffness"],
                contactDamping=parameters["contactDamping"],
                contactStiffnessExponent=parameters["contactStiffnessExponent"],
                impactModel=int(parameters["impactModel"]),
                dynamicFriction=parameters["dynamicFriction"],
            )
        )
        kinds = exudyn.OutputVariableType.Position, exudyn.OutputVariableType.Velocity
        sensors = [
            system.AddSensor(SensorBody(bodyNumber=of, localPosition=at, outputVariableType=kind, storeInternal=True, writeToFile=False))
            for of, at in ((body, place), (other, [0, 0, 0]))
            for kind in kinds
        ]
        system.Assemble()
        settings = exudyn.SimulationSettings()
        settings.timeIntegration.numberOfSteps = steps
        settings.timeIntegration.endTime = steps * step
        settings.timeIntegration.discontinuous.iterationTolerance = parameters["discontinuous.iterationTolerance"]
        settings.timeIntegration.discontinuous.maxIterations = int(parameters["discontinuous.maxIterations"])
        settings.solutionSettings.writeSolutionToFile = False
        settings.solutionSettings.sensorsWritePeriod = step
        system.SolveDynamic(settings)
        # Of each sample the time, then x, y, z.
        heights, rates, other_heights, other_rates = (system.GetSensorStoredData(sensor)[:, 3] for sensor in sensors)
        if opposite:
            heights, rates = heights - other_heights - radius - wall, rates - other_rates
        else:
            heights -= below[2] - height
        deepest = int(np.argmin(heights))
        opened = deepest + int(np.argmax(heights[deepest:] > 0))
        assert heights[opened] > 0, "the impact did not end"
        return rates[min(opened + AFTER, len(rates) - 1)] / speed, -heights[deepest]

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
