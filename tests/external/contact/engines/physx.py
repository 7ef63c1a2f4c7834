"""Impacts in PhysX 5, by ovphysx. The phases are run at once, as bodies beside one another."""

import math
import string
import tempfile
from pathlib import Path

import numpy as np

from impacts import PHASES, Outcome
from scenes import Absent, Refused, velocities

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
# Of its four-bar no error is stated: what comes out is printed.
UNBOUND = ("four_bar",)
# The four-bar is run so many times faster than in other engines: what its mass changes takes 2e-4, 8e-4, 1.5e-3 from e = 0.2, 0.5, 0.8.
FASTER = 10
# It is 1.1 GB when installed.
BY_HAND = True
# Steps of free flight before the contact, and how long its end is waited for, in undamped half periods.
FLIGHT, LONGEST = 2, 1.2
# Between the bodies, and the thickness of a wall of one phase, m.
APART, THICK = 1.0, 0.01
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
        point3f physics:centerOfMass = ($CENTRE, 0, $OFFSET)
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
# A wall of its own for each phase, thin so that its face is near its middle.
WALL = """    def Cube "Wall$NUMBER" (prepend apiSchemas = ["PhysicsCollisionAPI", "MaterialBindingAPI"])
    {
        double size = 1
        double3 xformOp:translate = ($X, $Y, $Z)
        double3 xformOp:scale = (0.2, $THICK, 0.2)
        uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:scale"]
        rel material:binding:physics = </World/Surface>
    }
"""
LINK = """    def Xform "Body$NAME" (prepend apiSchemas = ["PhysicsRigidBodyAPI", "PhysicsMassAPI", "PhysxRigidBodyAPI"])
    {
        double3 xformOp:translate = ($X, $Y, $Z)
        uniform token[] xformOpOrder = ["xformOp:translate"]
        float physics:mass = $MASS
        point3f physics:centerOfMass = (0, 0, 0)
        float3 physics:diagonalInertia = ($INERTIA, $INERTIA, $INERTIA)
        quatf physics:principalAxes = (1, 0, 0, 0)
        vector3f physics:velocity = ($VX, $VY, 0)
        vector3f physics:angularVelocity = (0, 0, $TURNING)
        float physxRigidBody:angularDamping = 0
        float physxRigidBody:linearDamping = 0
        float physxRigidBody:sleepThreshold = 0
        float physxRigidBody:stabilizationThreshold = 0
        int physxRigidBody:solverPositionIterationCount = $POSITION_TURNS
        int physxRigidBody:solverVelocityIterationCount = $VELOCITY_TURNS
$SHAPE    }
"""
STRIKER = """        def Sphere "Shape" (prepend apiSchemas = ["PhysicsCollisionAPI", "MaterialBindingAPI"])
        {
            double radius = $RADIUS
            double3 xformOp:translate = ($X, $Y, 0)
            uniform token[] xformOpOrder = ["xformOp:translate"]
            rel material:binding:physics = </World/Surface>
        }
"""
PIN = """    def PhysicsRevoluteJoint "Pin$NAME"
    {
        uniform token physics:axis = "Z"
$OTHER        rel physics:body1 = </World/Body$BODY>
        point3f physics:localPos0 = ($X0, $Y0, $Z0)
        quatf physics:localRot0 = (1, 0, 0, 0)
        point3f physics:localPos1 = ($X1, $Y1, 0)
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
            "X": 0, "Z": ball.radius + height, "W": 1, "TURN": 0, "MASS": ball.mass, "CENTRE": 0, "OFFSET": 0,
            "IX": about, "IY": about, "IZ": about, "VX": 0, "VZ": -speed, "SPIN": 0, "RADIUS": ball.radius, "LEVER": 0,
        }

    return impacts(body, "", parameters, solver, 0.0, ball.mass, speed, lambda read: read("linearVelocity")[:, 2])


def pendulum(parameters, solver, pendulum, speed):
    def opening(read):
        return -read("angularVelocity")[:, 1] * pendulum.lever

    return impacts(lever(pendulum, speed), HINGE, parameters, solver, -pendulum.radius, pendulum.effective_mass, speed, opening)


def two_bodies(parameters, solver, bodies, speed):
    hinged, share = lever(bodies.lever, bodies.share * speed), bodies.share

    def body(height):
        return hinged(share * height)

    def ball(height):
        about = 0.4 * bodies.mass * bodies.radius**2
        return {
            "X": bodies.lever.lever, "Z": -bodies.distance - (1 - share) * height, "W": 1, "TURN": 0, "MASS": bodies.mass, "CENTRE": 0,
            "OFFSET": 0, "IX": about, "IY": about, "IZ": about, "VX": 0, "VZ": (1 - share) * speed, "SPIN": 0, "RADIUS": bodies.radius,
            "LEVER": 0,
        }

    def opening(read):
        # In the order of the names, each lever is followed by its ball.
        return -read("angularVelocity")[0::2, 1] * bodies.lever.lever - read("linearVelocity")[1::2, 2]

    return impacts(body, HINGE, parameters, solver, None, bodies.effective_mass, speed, opening, ball)


def lever(pendulum, speed):
    """A rigid body on a joint. The rotor's inertia is added to the body's about the hinge's axis."""

    def body(height):
        angle, about = math.asin(height / pendulum.lever), pendulum.inertia
        rate = -speed / pendulum.lever
        return {
            "X": 0, "Z": 0, "W": math.cos(angle / 2), "TURN": -math.sin(angle / 2), "MASS": pendulum.mass,
            "CENTRE": pendulum.centre, "OFFSET": pendulum.offset, "IX": about, "IY": about + pendulum.rotor, "IZ": about,
            "VX": -rate * (pendulum.centre * math.sin(angle) + pendulum.offset * math.cos(angle)),
            "VZ": rate * (pendulum.centre * math.cos(angle) - pendulum.offset * math.sin(angle)),
            "SPIN": math.degrees(-rate), "RADIUS": pendulum.radius, "LEVER": pendulum.lever,
        }

    return body


def four_bar(parameters, solver, four_bar, speed):
    """Faster than elsewhere: at 2 mm/s the travel of a step is that of its places' rounding, and −0.1 to 0.7 come of 0.5."""
    return linkage(parameters, solver, four_bar, FASTER * speed)


def linkage(parameters, solver, four_bar, speed):
    """Rigid bodies on hinges. The origin is the struck body's centre of mass, where its place is known best."""
    step, stiffness = parameters["dt"], parameters["compliant_contact_stiffness"]
    kind, damping = solver
    turns = ITERATIONS
    if kind == "TGS":
        turns = (int(parameters["tgs_position_iterations"]), int(parameters["tgs_velocity_iterations"]))
    common = {"POSITION_TURNS": turns[0], "VELOCITY_TURNS": turns[1]}
    document = fill(HEAD, {"STIFFNESS": stiffness, "DAMPING": parameters[damping], "SOLVER": kind})
    ox, oy = four_bar.bodies[four_bar.struck][2]
    px, py = four_bar.point[0] - ox, four_bar.point[1] - oy
    striker = fill(STRIKER, {"RADIUS": four_bar.radius, "X": px, "Y": py})
    moving, places = velocities(four_bar, speed), {name: body[2] for name, body in four_bar.bodies.items()}
    for number, phase in enumerate(PHASES):
        z, gap = number * APART, (FLIGHT + phase) * step * speed
        document += fill(WALL, {
            "NUMBER": number, "X": px, "Y": py - four_bar.radius - gap - THICK / 2, "Z": z, "THICK": THICK,
        })
        for name, (mass, inertia, (x, y), _) in four_bar.bodies.items():
            (vx, vy), rate = moving[name]
            document += fill(LINK, common | {
                "NAME": f"{number}{name}", "X": x - ox, "Y": y - oy, "Z": z, "MASS": mass, "INERTIA": inertia, "VX": vx, "VY": vy,
                "TURNING": math.degrees(rate), "SHAPE": striker if name == four_bar.struck else "",
            })
        for which, (body, other, (x, y)) in enumerate(four_bar.hinges):
            base, rel = ((ox, oy), "") if other is None else (places[other], f"        rel physics:body0 = </World/Body{number}{other}>\n")
            document += fill(PIN, {
                "NAME": f"{number}x{which}", "OTHER": rel, "BODY": f"{number}{body}", "X0": x - base[0], "Y0": y - base[1],
                "Z0": z if other is None else 0, "X1": x - places[body][0], "Y1": y - places[body][1],
            })

    def opening(read):
        # Of each phase the bodies by name.
        struck = sorted(four_bar.bodies).index(four_bar.struck)
        rows = slice(struck, None, len(four_bar.bodies))
        return read("linearVelocity")[rows, 1] + px * read("angularVelocity")[rows, 2]

    return run(document, step, math.pi * math.sqrt(four_bar.effective_mass / stiffness), speed, opening)


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
            "NUMBER": number, "X": 0, "Y": 0, "Z": number * APART, "W": 1, "TURN": 0, "MASS": body.mass, "CENTRE": arm, "OFFSET": 0,
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


def impacts(body, joint, parameters, solver, top, mass, speed, opening, ball=None):
    """Against a box whose upper face is at z = top, or against `ball(height)`; mass: for the duration only."""
    step = parameters["dt"]
    kind, damping = solver
    turns = ITERATIONS
    if kind == "TGS":
        turns = (int(parameters["tgs_position_iterations"]), int(parameters["tgs_velocity_iterations"]))
    surface = {"STIFFNESS": parameters["compliant_contact_stiffness"], "DAMPING": parameters[damping]}
    document = fill(HEAD, surface | {"SOLVER": kind})
    if not ball:
        document += fill(STOP, {"CENTRE": top - 0.5})
    for number, phase in enumerate(PHASES):
        height = (FLIGHT + phase) * step * speed
        values = body(height)
        common = {"NUMBER": number, "Y": number * APART, "VY": 0, "TURNING": 0, "POSITION_TURNS": turns[0], "VELOCITY_TURNS": turns[1]}
        document += fill(BODY, common | values) + fill(joint, common)
        if ball:
            document += fill(BODY, common | ball(height) | {"NUMBER": f"{number}ball"})
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
        # Without threads: of so small scenes their waiting takes many times as long.
        _engine = ovphysx.PhysX(config=ovphysx.PhysXConfig(num_threads=0))
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
            """By the bodies' names: they come in any order."""
            rows = {}
            with simulator.read_sync(SimObjectType.RIGID_BODY, [name], scope=ObjectScope.ALL) as result:
                for group in result.groups:
                    if not group.is_delete and not group.is_array and group.tensors:
                        with ovstage.PathDictionary(stage) as names:
                            paths = names.get_path_strings(group.prim_list)
                        rows |= dict(zip(paths, np.array(group.tensors[0].numpy(), dtype=float), strict=True))
            return np.array([rows[path] for path in sorted(rows)])

        return opening(read)
    finally:
        simulator.wait_task(simulator.detach_ovstage())
        stage.destroy()
