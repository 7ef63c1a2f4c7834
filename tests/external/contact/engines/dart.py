"""Impacts in DART, by dartpy."""

import numpy as np

from impacts import PHASES, Outcome
from scenes import Absent

try:
    import dartpy
except ImportError:
    dartpy = None

TOOL = "dart"
SOLVERS = {"": None}
# s; where the export leaves it open, each of these.
TIME_STEPS = (1e-2, 1e-3, 1e-4)
# Steps of free flight before the contact, and the steps that are waited for its end.
FLIGHT, LONGEST = 2, 20


def engine():
    if not dartpy:
        raise Absent("dartpy==6.20.0")
    return f"dartpy {dartpy.__version__}"


def ball(parameters, solver, ball, speed):
    def build(skeleton):
        joint, body = skeleton.createPrismaticJointAndBodyNodePair()
        joint.setAxis([0, 0, 1])
        body.setInertia(dartpy.dynamics.Inertia(ball.mass, [0, 0, 0], 0.4 * ball.mass * ball.radius**2 * np.eye(3)))
        return body, [0, 0, 0]

    return impacts(build, parameters, 1.0, ball.radius, speed)


def pendulum(parameters, solver, pendulum, speed):
    """The rotor's inertia is added to the body's about the hinge's axis."""

    def build(skeleton):
        joint, body = skeleton.createRevoluteJointAndBodyNodePair()
        joint.setAxis([0, -1, 0])
        about = pendulum.inertia * np.eye(3)
        about[1, 1] += pendulum.rotor
        body.setInertia(dartpy.dynamics.Inertia(pendulum.mass, [pendulum.centre, 0, pendulum.offset], about))
        return body, [pendulum.lever, 0, 0]

    return impacts(build, parameters, pendulum.lever, pendulum.radius, speed)


def impacts(build, parameters, lever, radius, speed):
    """A skeleton of one coordinate; `lever`: metres of gap for each unit of it. Built where it touches."""

    def run(where):
        step, phase = where
        world = dartpy.simulation.World()
        world.setGravity([0, 0, 0])
        world.setTimeStep(step)
        stop = dartpy.dynamics.Skeleton("stop")
        _, ground = stop.createWeldJointAndBodyNodePair()
        dress(ground, dartpy.dynamics.BoxShape([2, 2, 1]), [0, 0, -radius - 0.5], parameters["RestitutionCoeff_other"], parameters)
        skeleton = dartpy.dynamics.Skeleton("struck")
        body, place = build(skeleton)
        dress(body, dartpy.dynamics.SphereShape(radius), place, parameters["RestitutionCoeff"], parameters)
        for each in (stop, skeleton):
            world.addSkeleton(each)
        skeleton.setPositions([(FLIGHT + phase) * step * speed / lever])
        skeleton.setVelocities([-speed / lever])
        depth = 0.0
        for _ in range(LONGEST):
            world.step()
            depth = max(depth, -skeleton.getPositions()[0] * lever)
        return skeleton.getVelocities()[0] * lever / speed, depth

    steps = (parameters["TimeStep"],) if "TimeStep" in parameters else TIME_STEPS
    return Outcome.of(run, [(step, phase) for step in steps for phase in PHASES])


def dress(body, shape, place, restitution, parameters):
    node = body.createShapeNode(shape)
    node.createCollisionAspect()
    node.createDynamicsAspect()
    node.getDynamicsAspect().setRestitutionCoeff(restitution)
    node.getDynamicsAspect().setFrictionCoeff(parameters["FrictionCoeff"])
    pose = dartpy.math.Isometry3()
    pose.set_translation(place)
    node.setRelativeTransform(pose)


def pasted(text, parameters):
    names = {}
    exec(text, names)
    body = dartpy.dynamics.Skeleton("pasted").createFreeJointAndBodyNodePair()[1]
    nodes = [body.createShapeNode(dartpy.dynamics.SphereShape(0.1)) for _ in range(2)]
    names["set_contact"](*nodes)
    found = [node.getDynamicsAspect().getRestitutionCoeff() for node in nodes]
    assert found == [parameters["RestitutionCoeff"], parameters["RestitutionCoeff_other"]], found


SNIPPETS = {"python": pasted}
