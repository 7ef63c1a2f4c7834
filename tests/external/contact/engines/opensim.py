"""Impacts in OpenSim. The parameter "stiffness·sqrt(R)" is divided by the root of the sphere's radius."""

import math

import numpy as np

from impacts import Outcome
from scenes import Absent, velocities

try:
    import opensim
except ImportError:
    opensim = None

TOOL = "opensim"
SOLVERS = {"": None}
# The spring is Hertz's.
EXPONENT = 1.5
# The flight before the contact, and the longest impact that is waited for, in the integrator's greatest steps.
FLIGHT, LONGEST = 20, 400
# The same of the four-bar, whose speed changes as it moves.
SHORT_FLIGHT, AWAITED = 2, 200


def engine():
    if not opensim:
        raise Absent("opensim==4.6")
    opensim.Logger.setLevelString("Error")
    return f"OpenSim {opensim.GetVersion().split('-')[0]}"


def ball(parameters, solver, ball, speed):
    """On a slider along y, OpenSim's vertical."""

    def build(model):
        about = 0.4 * ball.mass * ball.radius**2
        body = opensim.Body("struck", ball.mass, opensim.Vec3(0), opensim.Inertia(about, about, about, 0, 0, 0))
        upright = opensim.Vec3(0, 0, math.pi / 2)
        joint = opensim.SliderJoint("joint", model.getGround(), opensim.Vec3(0), upright, body, opensim.Vec3(0), upright)
        return body, joint, opensim.Vec3(0)

    return impacts(build, parameters, 1.0, ball.radius, speed)


def pendulum(parameters, solver, pendulum, speed):
    """In the plane of x and y, about z. The rotor's inertia is added to the body's about the hinge's axis."""

    def build(model):
        about = pendulum.inertia
        inertia = opensim.Inertia(about, about, about + pendulum.rotor, 0, 0, 0)
        body = opensim.Body("struck", pendulum.mass, opensim.Vec3(pendulum.centre, pendulum.offset, 0), inertia)
        joint = opensim.PinJoint("joint", model.getGround(), opensim.Vec3(0), opensim.Vec3(0), body, opensim.Vec3(0), opensim.Vec3(0))
        return body, joint, opensim.Vec3(pendulum.lever, 0, 0)

    return impacts(build, parameters, pendulum.lever, pendulum.radius, speed)


def two_bodies(parameters, solver, bodies, speed):
    """The relative radius of two spheres is r₁r₂/(r₁ + r₂)."""
    p, about = bodies.lever, 0.4 * bodies.mass * bodies.radius**2
    model = opensim.Model()
    model.setGravity(opensim.Vec3(0))
    ground, none = model.getGround(), opensim.Vec3(0)
    rod = opensim.Body("struck", p.mass, opensim.Vec3(p.centre, p.offset, 0), opensim.Inertia(p.inertia, p.inertia, p.inertia, 0, 0, 0))
    ball = opensim.Body("ball", bodies.mass, none, opensim.Inertia(about, about, about, 0, 0, 0))
    upright = opensim.Vec3(0, 0, math.pi / 2)
    below = opensim.Vec3(p.lever, -bodies.distance, 0)
    joints = (
        opensim.PinJoint("hinge", ground, none, none, rod, none, none),
        opensim.SliderJoint("along", ground, below, upright, ball, none, upright),
    )
    for body, joint in zip((rod, ball), joints):
        model.addBody(body)
        model.addJoint(joint)
    model.addContactGeometry(opensim.ContactSphere(bodies.radius, none, ball, "stop"))
    model.addContactGeometry(opensim.ContactSphere(p.radius, opensim.Vec3(p.lever, 0, 0), rod, "struck"))
    force(model, parameters, p.radius * bodies.radius / bodies.distance)
    model.initSystem()
    coordinates = [model.getCoordinateSet().get(i) for i in range(2)]
    shares = (bodies.share / p.lever, bodies.share - 1)

    def run(phase):
        state = model.initializeState()
        for coordinate, share in zip(coordinates, shares):
            coordinate.setValue(state, (FLIGHT + phase) * parameters["maximum_step_size"] * speed * share)
            coordinate.setSpeedValue(state, -speed * share)
        table = integrated(model, parameters, state, FLIGHT + LONGEST)
        (angles, rates), (places, speeds) = (columns(table, coordinate) for coordinate in coordinates)
        heights = p.lever * np.sin(angles) - places
        deepest = int(np.argmin(heights))
        opened = deepest + int(np.argmax(heights[deepest:] > 0))
        assert heights[deepest] < 0 < heights[opened], "the impact did not end"
        return (p.lever * rates[opened] - speeds[opened]) / speed, -heights[deepest]

    return Outcome.of(run)


def four_bar(parameters, solver, four_bar, speed):
    """The trees of the crank and of the rocker, closed by a PointConstraint. Built where it is drawn, before a wall that is a gap
    away. The speed is that where the gap opens: a linkage's changes as it moves on."""
    rates = {name: rate for name, (_, rate) in velocities(four_bar, speed).items()}
    origins = {"crank": (0.0, 0.0), "coupler": (0.0, 0.3), "rocker": (0.65, 0.0)}
    parents = {"crank": None, "coupler": "crank", "rocker": None}

    def local(name, at):
        return opensim.Vec3(*(x - origin for x, origin in zip(at, origins[name])), 0)

    def run(phase):
        model = opensim.Model()
        model.setGravity(opensim.Vec3(0))
        bodies = {None: model.getGround()}
        for name, parent in parents.items():
            mass, inertia, centre, _ = four_bar.bodies[name]
            body = opensim.Body(name, mass, local(name, centre), opensim.Inertia(inertia, inertia, inertia, 0, 0, 0))
            at = local(parent, origins[name]) if parent else opensim.Vec3(*origins[name], 0)
            joint = opensim.PinJoint("to_" + name, bodies[parent], at, opensim.Vec3(0), body, opensim.Vec3(0), opensim.Vec3(0))
            model.addBody(body)
            model.addJoint(joint)
            bodies[name] = body
        pin = (0.4, 0.6)
        closed = opensim.PointConstraint(bodies["coupler"], local("coupler", pin), bodies["rocker"], local("rocker", pin))
        model.addConstraint(closed)
        gap = (SHORT_FLIGHT + phase) * parameters["maximum_step_size"] * speed
        wall = four_bar.point[1] - gap
        contact(model, parameters, bodies["coupler"], local("coupler", four_bar.point), four_bar.radius, wall)
        state = model.initSystem()
        coordinates = {name: model.getJointSet().get("to_" + name).getCoordinate() for name in parents}
        for name, parent in parents.items():
            coordinates[name].setSpeedValue(state, rates[name] - (rates[parent] if parent else 0.0))
        table = integrated(model, parameters, state, SHORT_FLIGHT + AWAITED)
        crank, coupler = (columns(table, coordinates[name]) for name in ("crank", "coupler"))
        turned, rate = crank[0] + coupler[0], crank[1] + coupler[1]
        x, y = (p - origin for p, origin in zip(four_bar.point, origins["coupler"]))
        length = origins["coupler"][1]
        heights = length * np.cos(crank[0]) + x * np.sin(turned) + y * np.cos(turned) - wall
        speeds = -length * np.sin(crank[0]) * crank[1] + (x * np.cos(turned) - y * np.sin(turned)) * rate
        deepest = int(np.argmin(heights))
        opened = deepest + int(np.argmax(heights[deepest:] > 0))
        assert heights[deepest] < 0 < heights[opened], "the impact did not end"
        return speeds[opened] / speed, -heights[deepest]

    return Outcome.of(run)


def impacts(build, parameters, lever, radius, speed):
    model = opensim.Model()
    model.setGravity(opensim.Vec3(0))
    body, joint, place = build(model)
    model.addBody(body)
    model.addJoint(joint)
    contact(model, parameters, body, place, radius, 0.0)
    model.initSystem()
    coordinate, step = model.getCoordinateSet().get(0), parameters["maximum_step_size"]

    def run(phase):
        state = model.initializeState()
        coordinate.setValue(state, (FLIGHT + phase) * step * speed / lever)
        coordinate.setSpeedValue(state, -speed / lever)
        table = integrated(model, parameters, state, FLIGHT + LONGEST)
        heights, speeds = columns(table, coordinate)
        return speeds[-1] * lever / speed, -heights.min() * lever

    return Outcome.of(run)


def contact(model, parameters, body, place, radius, wall):
    """A sphere at `place` of the body, and a half space that it touches when it is at the height `wall`."""
    down = opensim.Vec3(0, 0, -math.pi / 2)
    model.addContactGeometry(opensim.ContactHalfSpace(opensim.Vec3(0, wall - radius, 0), down, model.getGround(), "stop"))
    model.addContactGeometry(opensim.ContactSphere(radius, place, body, "struck"))
    force(model, parameters, radius)


def force(model, parameters, radius):
    """Between the geometries "stop" and "struck", of that relative radius."""
    added = opensim.HuntCrossleyForce()
    for name in ("stop", "struck"):
        added.addGeometry(name)
    added.setStiffness(parameters["stiffness·sqrt(R)"] / math.sqrt(radius))
    added.setDissipation(parameters["dissipation"])
    added.setStaticFriction(0.0)
    added.setDynamicFriction(0.0)
    added.setViscousFriction(0.0)
    model.addForce(added)


def integrated(model, parameters, state, steps):
    """The table of all states: the states themselves end with the manager."""
    manager = opensim.Manager(model)
    manager.setIntegratorAccuracy(parameters["integrator_accuracy"])
    manager.setIntegratorMaximumStepSize(parameters["maximum_step_size"])
    manager.initialize(state)
    manager.integrate(steps * parameters["maximum_step_size"])
    return manager.getStatesTable()


def columns(table, coordinate):
    """A coordinate's values and speeds."""
    names = coordinate.getStateVariableNames()
    return [table.getDependentColumn(names.get(i)).to_numpy() for i in range(2)]


def pasted(text, parameters):
    names = {}
    exec(text, names)
    force = names["contact_force"](["stop", "struck"], 4.0)
    found = force.getStiffness() * 2.0, force.getDissipation()
    assert found == (parameters["stiffness·sqrt(R)"], parameters["dissipation"]), found
    model = opensim.Model()
    model.initSystem()
    names["set_integrator"](opensim.Manager(model))


SNIPPETS = {"python": pasted}
