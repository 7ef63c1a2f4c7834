"""Impacts in OpenSim. The parameter "stiffness·sqrt(R)" is divided by the root of the sphere's radius."""

import math

from impacts import Outcome
from scenes import Absent

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
        body = opensim.Body("struck", pendulum.mass, opensim.Vec3(pendulum.centre, 0, 0), inertia)
        joint = opensim.PinJoint("joint", model.getGround(), opensim.Vec3(0), opensim.Vec3(0), body, opensim.Vec3(0), opensim.Vec3(0))
        return body, joint, opensim.Vec3(pendulum.lever, 0, 0)

    return impacts(build, parameters, pendulum.lever, pendulum.radius, speed)


def impacts(build, parameters, lever, radius, speed):
    model = opensim.Model()
    model.setGravity(opensim.Vec3(0))
    body, joint, place = build(model)
    model.addBody(body)
    model.addJoint(joint)
    down = opensim.Vec3(0, 0, -math.pi / 2)
    model.addContactGeometry(opensim.ContactHalfSpace(opensim.Vec3(0, -radius, 0), down, model.getGround(), "stop"))
    model.addContactGeometry(opensim.ContactSphere(radius, place, body, "struck"))
    force = opensim.HuntCrossleyForce()
    for name in ("stop", "struck"):
        force.addGeometry(name)
    force.setStiffness(parameters["stiffness·sqrt(R)"] / math.sqrt(radius))
    force.setDissipation(parameters["dissipation"])
    force.setStaticFriction(0.0)
    force.setDynamicFriction(0.0)
    force.setViscousFriction(0.0)
    model.addForce(force)
    model.initSystem()
    coordinate, step = model.getCoordinateSet().get(0), parameters["maximum_step_size"]

    def run(phase):
        state = model.initializeState()
        coordinate.setValue(state, (FLIGHT + phase) * step * speed / lever)
        coordinate.setSpeedValue(state, -speed / lever)
        manager = opensim.Manager(model)
        manager.setIntegratorAccuracy(parameters["integrator_accuracy"])
        manager.setIntegratorMaximumStepSize(step)
        manager.initialize(state)
        state = manager.integrate((FLIGHT + LONGEST) * step)
        heights = manager.getStatesTable().getDependentColumn(coordinate.getStateVariableNames().get(0)).to_numpy()
        return coordinate.getSpeedValue(state) * lever / speed, -heights.min() * lever

    return Outcome.of(run)


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
