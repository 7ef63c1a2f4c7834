"""Impacts in PhysX 5, by ovphysx. The phases are run at once, as bodies beside one another."""

import math
import string
import tempfile
from pathlib import Path

import numpy as np

from impacts import PHASES, Outcome
from scenes import Absent, Refused

try:
    import ovphysx
    import ovstage
    from ovphysx.samples.python_samples.schema_support import physx_schema_paths
    from ovphysx.types import ObjectScope, SimObjectType
except ImportError:
    ovphysx = None

TOOL = "physx"
# The scene's solver, and the parameter that is the damping for it.
SOLVERS = {
    "PGS": ("PGS", "compliant_contact_damping"),
    "TGS, 0 velocity iterations": ("TGS", "compliant_contact_damping_tgs"),
}
# PhysX's own numbers of iterations, position and velocity; with TGS they are the export's.
ITERATIONS = (4, 1)
# It is 1.1 GB when installed.
BY_HAND = True
# Steps of free flight before the contact, and how long its end is waited for, in undamped half periods.
FLIGHT, LONGEST = 2, 1.2
# Between the bodies, m.
APART = 1.0
HEAD = """#usda 1.0
(
    defaultPrim = "World"
    metersPerUnit = 1
    kilogramsPerUnit = 1
    upAxis = "Z"
)
def Xform "World"
{
    def PhysicsScene "Scene" (prepend apiSchemas = ["PhysxSceneAPI"])
    {
        float physics:gravityMagnitude = 0
        uniform token physxScene:solverType = "$SOLVER"
        bool physxScene:enableGPUDynamics = 0
        uniform token physxScene:broadphaseType = "MBP"
    }
    def Material "Surface" (prepend apiSchemas = ["PhysicsMaterialAPI", "PhysxMaterialAPI"])
    {
        float physics:staticFriction = 0
        float physics:dynamicFriction = 0
        float physics:restitution = 0
        float physxMaterial:compliantContactStiffness = $STIFFNESS
        float physxMaterial:compliantContactDamping = $DAMPING
    }
"""
STOP = """    def Cube "Stop" (prepend apiSchemas = ["PhysicsCollisionAPI", "MaterialBindingAPI"])
    {
        double size = 1
        double3 xformOp:translate = (0, 0, $CENTRE)
        double3 xformOp:scale = (40, 40, 1)
        uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:scale"]
        rel material:binding:physics = </World/Surface>
    }
"""
BODY = """    def Xform "Body$NUMBER" (prepend apiSchemas = ["PhysicsRigidBodyAPI", "PhysicsMassAPI", "PhysxRigidBodyAPI"])
    {
        double3 xformOp:translate = ($X, $Y, $Z)
        quatd xformOp:orient = ($W, 0, $TURN, 0)
        uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:orient"]
        float physics:mass = $MASS
        point3f physics:centerOfMass = ($CENTRE, 0, 0)
        float3 physics:diagonalInertia = ($IX, $IY, $IZ)
        quatf physics:principalAxes = (1, 0, 0, 0)
        vector3f physics:velocity = ($VX, $VY, $VZ)
        vector3f physics:angularVelocity = (0, $SPIN, $TURNING)
        float physxRigidBody:angularDamping = 0
        float physxRigidBody:linearDamping = 0
        float physxRigidBody:sleepThreshold = 0
        int physxRigidBody:solverPositionIterationCount = $POSITION_TURNS
        int physxRigidBody:solverVelocityIterationCount = $VELOCITY_TURNS
        def Sphere "Shape" (prepend apiSchemas = ["PhysicsCollisionAPI", "MaterialBindingAPI"])
        {
            double radius = $RADIUS
            double3 xformOp:translate = ($LEVER, 0, 0)
            uniform token[] xformOpOrder = ["xformOp:translate"]
            rel material:binding:physics = </World/Surface>
        }
    }
"""
HINGE = """    def PhysicsRevoluteJoint "Hinge$NUMBER"
    {
        uniform token physics:axis = "Y"
        rel physics:body1 = </World/Body$NUMBER>
        point3f physics:localPos0 = (0, $Y, 0)
        quatf physics:localRot0 = (1, 0, 0, 0)
        point3f physics:localPos1 = (0, 0, 0)
        quatf physics:localRot1 = (1, 0, 0, 0)
    }
"""
STOPPED = """    def PhysicsRevoluteJoint "Joint$NUMBER" (prepend apiSchemas = ["PhysxLimitAPI:angular"])
    {
        uniform token physics:axis = "Z"
        rel physics:body1 = </World/Body$NUMBER>
        point3f physics:localPos0 = (0, 0, $Z)
        quatf physics:localRot0 = ($W, 0, 0, $TURN)
        point3f physics:localPos1 = (0, 0, 0)
        quatf physics:localRot1 = (1, 0, 0, 0)
        float physics:lowerLimit = $LOWER
        float physics:upperLimit = $UPPER
        float physxLimit:angular:stiffness = $STIFFNESS
        float physxLimit:angular:damping = $DAMPING
    }
"""


def engine():
    if not ovphysx:
        raise Absent("ovphysx==0.7.0.74035321, physx-usd-schemas and newton-usd-schemas")
    return f"ovphysx {'.'.join(ovphysx.__version__.split('.')[:3])}"


def ball(parameters, solver, ball, speed):
    def body(height):
        about = 0.4 * ball.mass * ball.radius**2
        return {
            "X": 0, "Z": ball.radius + height, "W": 1, "TURN": 0, "MASS": ball.mass, "CENTRE": 0,
            "IX": about, "IY": about, "IZ": about, "VX": 0, "VZ": -speed, "SPIN": 0, "RADIUS": ball.radius, "LEVER": 0,
        }

    return impacts(body, "", parameters, solver, 0.0, ball.mass, speed, lambda read: read("linearVelocity")[:, 2])


def pendulum(parameters, solver, pendulum, speed):
    """A rigid body on a joint. The rotor's inertia is added to the body's about the hinge's axis."""

    def body(height):
        angle, about = math.asin(height / pendulum.lever), pendulum.inertia
        rate = -speed / pendulum.lever
        return {
            "X": 0, "Z": 0, "W": math.cos(angle / 2), "TURN": -math.sin(angle / 2), "MASS": pendulum.mass,
            "CENTRE": pendulum.centre, "IX": about, "IY": about + pendulum.rotor, "IZ": about,
            "VX": -rate * pendulum.centre * math.sin(angle), "VZ": rate * pendulum.centre * math.cos(angle),
            "SPIN": math.degrees(-rate), "RADIUS": pendulum.radius, "LEVER": pendulum.lever,
        }

    def opening(read):
        return -read("angularVelocity")[:, 1] * pendulum.lever

    return impacts(body, HINGE, parameters, solver, -pendulum.radius, pendulum.effective_mass, speed, opening)


def stop(parameters, solver, stop, speed):
    """A hinge, with PGS. The schema's stiffness and damping are per radian, its limits are degrees."""
    if solver is not SOLVERS["PGS"] or len(stop.bodies) > 1:
        raise Refused("no stop")
    (body,), ((angle, rate, rotor),) = stop.bodies, stop.tree
    step, rate = parameters["dt"], rate * speed
    arm = math.hypot(*body.centre)
    document = fill(HEAD, {"STIFFNESS": 0, "DAMPING": 0, "SOLVER": solver[0]})
    for number, phase in enumerate(PHASES):
        # The body stands along x, and the joint's frame of the world is turned.
        at = angle + stop.end * (FLIGHT + phase) * step * speed
        lower, upper = (-180.0, math.degrees(at)) if stop.end > 0 else (math.degrees(at), 180.0)
        document += fill(BODY, {
            "NUMBER": number, "X": 0, "Y": 0, "Z": number * APART, "W": 1, "TURN": 0, "MASS": body.mass, "CENTRE": arm,
            "IX": body.inertia, "IY": body.inertia, "IZ": body.inertia + rotor, "VX": 0, "VY": rate * arm, "VZ": 0, "SPIN": 0,
            "TURNING": math.degrees(rate), "RADIUS": 0.01, "LEVER": 0, "POSITION_TURNS": ITERATIONS[0], "VELOCITY_TURNS": ITERATIONS[1],
        })
        document += fill(STOPPED, {
            "NUMBER": number, "Z": number * APART, "W": math.cos(angle / 2), "TURN": -math.sin(angle / 2), "LOWER": lower, "UPPER": upper,
            "STIFFNESS": parameters["limit_stiffness"], "DAMPING": parameters["limit_damping"],
        })
    half = math.pi * math.sqrt(stop.effective_mass / parameters["limit_stiffness"])

    def opening(read):
        return -stop.end * read("angularVelocity")[:, 2]

    return run(document, step, half, speed, opening)


def impacts(body, joint, parameters, solver, top, mass, speed, opening):
    """Against a box whose upper face is at z = top; mass: for the duration only."""
    step = parameters["dt"]
    kind, damping = solver
    turns = ITERATIONS
    if kind == "TGS":
        turns = (int(parameters["tgs_position_iterations"]), int(parameters["tgs_velocity_iterations"]))
    surface = {"STIFFNESS": parameters["compliant_contact_stiffness"], "DAMPING": parameters[damping]}
    document = fill(HEAD, surface | {"SOLVER": kind})
    document += fill(STOP, {"CENTRE": top - 0.5})
    for number, phase in enumerate(PHASES):
        values = body((FLIGHT + phase) * step * speed)
        common = {"NUMBER": number, "Y": number * APART, "VY": 0, "TURNING": 0, "POSITION_TURNS": turns[0], "VELOCITY_TURNS": turns[1]}
        document += fill(BODY, common | values) + fill(joint, common)
    return run(document, step, math.pi * math.sqrt(mass / parameters["compliant_contact_stiffness"]), speed, opening)


def run(document, step, half, speed, opening):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "scene.usda"
        path.write_text(document + "}\n")
        return Outcome(simulated(path, step, FLIGHT + math.ceil(LONGEST * half / step), opening) / speed, 0.0)


def fill(text, values):
    return string.Template(text).substitute(values)


_engine, _runs = None, 0


def physx():
    """One for all runs: it is set up once a process."""
    global _engine
    if _engine is None:
        ovphysx.PhysX.set_cpu_mode(True)
        ovstage.population.register_usd_schemas([*map(str, physx_schema_paths()), str(ovphysx.newton_schema_root())])
        _engine = ovphysx.PhysX()
    return _engine


def simulated(path, step, steps, opening):
    global _runs
    simulator = physx()
    _runs += 1
    stage = ovstage.Stage(f"scene{_runs}")
    ovstage.population.open_usd(stage, str(path), ordinal=1, domains=ovstage.PopulationDomain.ALL)
    stage.advance_write_floor(ordinal=1).wait()
    simulator.wait_task(simulator.attach_ovstage(stage, read_ordinal=1))
    try:
        simulator.wait_all()
        for _ in range(steps):
            simulator.step_sync(step)

        def read(name):
            columns = []
            with simulator.read_sync(SimObjectType.RIGID_BODY, [name], scope=ObjectScope.ALL) as result:
                for group in result.groups:
                    if not group.is_delete and not group.is_array and group.tensors:
                        columns.append(np.array(group.tensors[0].numpy(), dtype=float))
            return np.concatenate(columns, axis=0)

        return opening(read)
    finally:
        simulator.wait_task(simulator.detach_ovstage())
        stage.destroy()
