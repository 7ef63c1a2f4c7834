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


def two_bodies(parameters, solver, bodies, speed):
    """The speeds are those just after the impact: a lever's changes as it moves on."""
    p = bodies.lever

    def run(where):
        step, phase = where
        world = dartpy.simulation.World()
        world.setGravity([0, 0, 0])
        world.setTimeStep(step)
        hinged, ball = dartpy.dynamics.Skeleton("struck"), dartpy.dynamics.Skeleton("ball")
        joint, rod = hinged.createRevoluteJointAndBodyNodePair()
        joint.setAxis([0, -1, 0])
        rod.setInertia(dartpy.dynamics.Inertia(p.mass, [p.centre, 0, p.offset], p.inertia * np.eye(3)))
        dress(rod, dartpy.dynamics.SphereShape(p.radius), [p.lever, 0, 0], parameters["RestitutionCoeff"], parameters)
        joint, body = ball.createPrismaticJointAndBodyNodePair()
        joint.setAxis([0, 0, 1])
        body.setInertia(dartpy.dynamics.Inertia(bodies.mass, [0, 0, 0], 0.4 * bodies.mass * bodies.radius**2 * np.eye(3)))
        place = [p.lever, 0, -bodies.distance]
        dress(body, dartpy.dynamics.SphereShape(bodies.radius), place, parameters["RestitutionCoeff_other"], parameters)
        for skeleton, share, arm in ((hinged, bodies.share, -p.lever), (ball, 1 - bodies.share, 1.0)):
            skeleton.setVelocities([share * speed / arm])
            skeleton.setPositions([-(FLIGHT + phase) * step * share * speed / arm])
            world.addSkeleton(skeleton)
        opening, depth = -speed, 0.0
        for _ in range(LONGEST):
            world.step()
            depth = max(depth, ball.getPositions()[0] - p.lever * hinged.getPositions()[0])
            opening = p.lever * hinged.getVelocities()[0] - ball.getVelocities()[0]
            if opening > 0:
                break
        return opening / speed, depth

    steps = (parameters["TimeStep"],) if "TimeStep" in parameters else TIME_STEPS
    return Outcome.of(run, [(step, phase) for step in steps for phase in PHASES])


def linkage(parameters, solver, linkage, speed):
    """Trees in the x-y plane; what is drawn along y is along z, and a turn about z is one about −y. Only hinges in the order of the bodies."""

    def run(where):
        step, phase = where
        world = dartpy.simulation.World()
        world.setGravity([0, 0, 0])
        world.setTimeStep(step)
        skeleton = dartpy.dynamics.Skeleton("struck")
        above, origin, made, rates, before = None, (0.0, 0.0), {}, [], 0.0
        for name, _, at in linkage.hinges:
            joint, body = skeleton.createRevoluteJointAndBodyNodePair(above) if above else skeleton.createRevoluteJointAndBodyNodePair()
            joint.setAxis([0, -1, 0])
            pose = dartpy.math.Isometry3()
            pose.set_translation([at[0] - origin[0], 0, at[1] - origin[1]])
            joint.setTransformFromParentBodyNode(pose)
            mass, inertia, centre, _ = linkage.bodies[name]
            body.setInertia(dartpy.dynamics.Inertia(mass, [centre[0] - at[0], 0, centre[1] - at[1]], inertia * np.eye(3)))
            rate = linkage.velocities(speed)[name][1]
            rates.append(rate - before)
            above, origin, before, made[name] = body, at, rate, at
        x, z = (p - o for p, o in zip(linkage.point, made[linkage.struck]))
        dress(body, dartpy.dynamics.SphereShape(linkage.radius), [x, 0, z], parameters["RestitutionCoeff"], parameters)
        gap = (1 + phase) * step * speed
        stop = dartpy.dynamics.Skeleton("stop")
        _, ground = stop.createWeldJointAndBodyNodePair()
        place = [linkage.point[0], 0, linkage.point[1] - linkage.radius - gap - 0.5]
        dress(ground, dartpy.dynamics.BoxShape([2, 2, 1]), place, parameters["RestitutionCoeff_other"], parameters)
        for each in (stop, skeleton):
            world.addSkeleton(each)
        skeleton.setVelocities(rates)
        rebound = -speed
        for _ in range(LONGEST):
            world.step()
            rebound = body.getLinearVelocity([x, 0, z])[2]
            # Just after the impact: the speed changes as the linkage moves on.
            if rebound > 0:
                break
        return rebound / speed, 0.0

    steps = (parameters["TimeStep"],) if "TimeStep" in parameters else TIME_STEPS
    return Outcome.of(run, [(step, phase) for step in steps for phase in PHASES])


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
