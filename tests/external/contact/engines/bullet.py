"""PyBullet: one body, or a multibody in reduced coordinates (btMultiBodyDynamicsWorld); loops are closed by constraints of finite
force. PyPI has wheels up to Python 3.11."""

import importlib.metadata
import math
import tempfile
from pathlib import Path

from engines import _built
from impacts import Outcome
from scenes import Absent, velocities

try:
    import pybullet
except ImportError:
    pybullet = None

TOOL = "bullet"
SOLVERS = {"": None}
# As long an impact as is waited for, in steps.
LONGEST = 200_000
INERT = {"linearDamping": 0.0, "angularDamping": 0.0, "jointDamping": 0.0}
HIDDEN = '<inertial><mass value="0"/><inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/></inertial>'
BODY = ("contactStiffness", "contactDamping", "restitution", "lateralFriction", "rollingFriction", "spinningFriction")


def engine():
    if not pybullet:
        raise Absent("pybullet 3.2.7, with Python 3.11 (later ones have no wheel)")
    return f"PyBullet {importlib.metadata.version('pybullet')}"


def world(parameters):
    if not pybullet.isConnected():
        pybullet.connect(pybullet.DIRECT)
    pybullet.resetSimulation()
    pybullet.setGravity(0, 0, 0)
    pybullet.setPhysicsEngineParameter(
        fixedTimeStep=parameters["fixedTimeStep"],
        contactSlop=parameters["contactSlop"],
        numSubSteps=0,
        enableFileCaching=0,
    )


def surface(body, link, parameters):
    pybullet.changeDynamics(body, link, **INERT, **{name: parameters[name] for name in BODY})


def plane(below, parameters):
    shape = pybullet.createCollisionShape(pybullet.GEOM_PLANE)
    surface(pybullet.createMultiBody(0, shape, basePosition=[0, 0, below]), -1, parameters)


def impacts(build, parameters, speed):
    """`build(gap)` gives what reads the height over the place of touching and its rate."""
    travel = speed * parameters["fixedTimeStep"]

    def run(phase):
        world(parameters)
        state = build(phase * travel)
        depth, touched = 0.0, False
        for _ in range(LONGEST):
            pybullet.stepSimulation()
            height, rate = state()
            depth, touched = max(depth, -height), touched or height < 0
            if touched and height > 2 * travel and rate > 0:
                break
        return rate / speed, depth

    return Outcome.of(run)


def ball(parameters, solver, ball, speed):
    def build(gap):
        plane(-ball.radius, parameters)
        shape = pybullet.createCollisionShape(pybullet.GEOM_SPHERE, radius=ball.radius)
        body = pybullet.createMultiBody(ball.mass, shape, basePosition=[0, 0, gap])
        surface(body, -1, parameters)
        pybullet.resetBaseVelocity(body, [0, 0, -speed])
        return lambda: (pybullet.getBasePositionAndOrientation(body)[0][2], pybullet.getBaseVelocity(body)[0][2])

    return impacts(build, parameters, speed)


def pendulum(parameters, solver, pendulum, speed):
    def opposite(gap):
        plane(-pendulum.radius, parameters)
        return lambda: (0.0, 0.0)

    return levered(parameters, pendulum, speed, 1.0, opposite)


def two_bodies(parameters, solver, bodies, speed):
    lever = bodies.lever

    def opposite(gap):
        shape = pybullet.createCollisionShape(pybullet.GEOM_SPHERE, radius=bodies.radius)
        start = -bodies.distance - (1 - bodies.share) * gap
        ball = pybullet.createMultiBody(bodies.mass, shape, basePosition=[lever.lever, 0, start])
        surface(ball, -1, parameters)
        pybullet.resetBaseVelocity(ball, [0, 0, (1 - bodies.share) * speed])

        def state():
            return pybullet.getBasePositionAndOrientation(ball)[0][2] + bodies.distance, pybullet.getBaseVelocity(ball)[0][2]

        return state

    return levered(parameters, lever, speed, bodies.share, opposite)


def levered(parameters, p, speed, share, opposite):
    """A pendulum that takes part in the closing speed by `share`. `opposite(gap)` builds the other side; it returns a function of the other
    side's height, 0 at the touch, and rate."""
    about_centre = p.turning_inertia
    urdf = f"""<robot name="pendulum">
  <link name="world">{HIDDEN}</link>
  <link name="rod">
    <inertial>
      <origin xyz="{p.centre} 0 {p.offset}"/>
      <mass value="{p.mass}"/>
      <inertia ixx="{about_centre!r}" iyy="{about_centre!r}" izz="{about_centre!r}" ixy="0" ixz="0" iyz="0"/>
    </inertial>
    <collision><origin xyz="{p.lever} 0 0"/><geometry><sphere radius="{p.radius}"/></geometry></collision>
  </link>
  <joint name="hinge" type="continuous"><parent link="world"/><child link="rod"/><axis xyz="0 -1 0"/></joint>
</robot>
"""

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "pendulum.urdf"
        path.write_text(urdf)

        def build(gap):
            other = opposite(gap)
            body = pybullet.loadURDF(str(path), useFixedBase=True, flags=pybullet.URDF_USE_INERTIA_FROM_FILE)
            pybullet.setJointMotorControl2(body, 0, pybullet.VELOCITY_CONTROL, force=0)
            surface(body, 0, parameters)
            pybullet.resetJointState(body, 0, share * gap / p.lever, -share * speed / p.lever)
            return lambda: [p.lever * x - y for x, y in zip(pybullet.getJointState(body, 0)[:2], other())]

        return impacts(build, parameters, speed)


def four_bar(parameters, solver, four_bar, speed):
    """In the x-y plane, as drawn: the trees of the crank and of the rocker, closed by a point-to-point constraint."""
    places = {"crank": (0.0, 0.0), "coupler": (0.0, 0.3), "rocker": (0.65, 0.0)}
    moving = {name: rate for name, (_, rate) in velocities(four_bar, speed).items()}
    point = tuple(x - at for x, at in zip(four_bar.point, places["coupler"]))

    def link(name):
        mass, inertia, centre, _ = four_bar.bodies[name]
        x, y = (c - at for c, at in zip(centre, places[name]))
        sphere = f'<collision><origin xyz="{point[0]!r} {point[1]!r} 0"/><geometry><sphere radius="{four_bar.radius}"/></geometry></collision>'
        i = f'<inertia ixx="{inertia!r}" iyy="{inertia!r}" izz="{inertia!r}" ixy="0" ixz="0" iyz="0"/>'
        return f'''<link name="{name}"><inertial><origin xyz="{x!r} {y!r} 0"/><mass value="{mass!r}"/>{i}</inertial>
{sphere if name == four_bar.struck else ""}</link>'''

    def joint(parent, child):
        x, y = (b - a for a, b in zip(places.get(parent, (0.0, 0.0)), places[child]))
        return f'''<joint name="to_{child}" type="continuous"><parent link="{parent}"/><child link="{child}"/>
<origin xyz="{x!r} {y!r} 0"/><axis xyz="0 0 1"/></joint>'''

    tree = (("world", "crank"), ("crank", "coupler"), ("world", "rocker"))
    parts = [f'<link name="world">{HIDDEN}</link>', *map(link, places), *(joint(*pair) for pair in tree)]
    urdf = f'<robot name="four_bar">{"".join(parts)}</robot>'

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "four_bar.urdf"
        path.write_text(urdf)

        def build(gap):
            wall = four_bar.point[1] - four_bar.radius - gap
            shape = pybullet.createCollisionShape(pybullet.GEOM_PLANE, planeNormal=[0, 1, 0])
            surface(pybullet.createMultiBody(0, shape, basePosition=[0, wall, 0]), -1, parameters)
            body = pybullet.loadURDF(str(path), useFixedBase=True, flags=pybullet.URDF_USE_INERTIA_FROM_FILE)
            index = {pybullet.getJointInfo(body, i)[12].decode(): i for i in range(3)}
            rates = {"crank": moving["crank"], "coupler": moving["coupler"] - moving["crank"], "rocker": moving["rocker"]}
            for name, i in index.items():
                pybullet.setJointMotorControl2(body, i, pybullet.VELOCITY_CONTROL, force=0)
                surface(body, i, parameters)
                pybullet.resetJointState(body, i, 0.0, rates[name])
            ends = [[x - c for x, c in zip((0.4, 0.6), four_bar.bodies[name][2])] + [0] for name in ("coupler", "rocker")]
            closed = pybullet.createConstraint(
                body, index["coupler"], body, index["rocker"], pybullet.JOINT_POINT2POINT, [0, 0, 0], *ends
            )
            pybullet.changeConstraint(closed, maxForce=1e9)
            lever = [x - c for x, c in zip(four_bar.point, four_bar.bodies["coupler"][2])]

            def state():
                found = pybullet.getLinkState(body, index["coupler"], computeLinkVelocity=1, computeForwardKinematics=1)
                turned = pybullet.getEulerFromQuaternion(found[1])[2]
                across = lever[0] * math.cos(turned) - lever[1] * math.sin(turned)
                along = lever[0] * math.sin(turned) + lever[1] * math.cos(turned)
                return found[0][1] + along - four_bar.radius - wall, found[6][1] + found[7][2] * across

            return state

        return impacts(build, parameters, speed)


def pasted(text, parameters):
    names = {}
    world(parameters)
    shape = pybullet.createCollisionShape(pybullet.GEOM_SPHERE, radius=1)
    body = pybullet.createMultiBody(1, shape)
    exec(text, names)
    names["set_contact"](body, -1)
    names["set_step"]()
    info = pybullet.getDynamicsInfo(body, -1)
    found = {"lateralFriction": info[1], "restitution": info[5], "rollingFriction": info[6], "spinningFriction": info[7]}
    found |= {"contactDamping": info[8], "contactStiffness": info[9]}
    found["fixedTimeStep"] = pybullet.getPhysicsEngineParameters()["fixedTimeStep"]
    # PyBullet does not give it back.
    assert f"contactSlop={parameters['contactSlop']!r}" in text
    for name, value in found.items():
        assert value == parameters[name], f"{name}: {value}, exported {parameters[name]}"


def compiles(text, parameters):
    _built.needs("libbullet-dev", "c++")
    source = "#include <btBulletDynamicsCommon.h>\nvoid paste(btRigidBody *body, btDiscreteDynamicsWorld *world) {\n" + text + "}\n"
    _built.compiles(source, "-I/usr/include/bullet")


SNIPPETS = {"python": pasted, "cpp": compiles}
