"""Converters of positions and velocities, and models from memory, against Pinocchio, MuJoCo and Drake: frames of links, effective masses,
and the closing speed by velocities agree.

    converters.py --package FOLDER     runs what can be imported; prints `N passed, N failed`
"""

import argparse
import importlib.util
import sys
import warnings
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[4]
# Both sides compute frames and M by their own recursions; condition numbers up to some thousand.
TOLERANCE = 1e-9

passed = failed = 0

ROBOT = """<robot name="all">
<link name="base"><inertial><mass value="3"/><inertia ixx=".1" iyy=".2" izz=".15" ixy="0" ixz="0" iyz="0"/></inertial></link>
{links}{joints}</robot>"""
LINK = """<link name="{0}"><inertial><origin xyz="0.1 0.02 -0.03"/><mass value="1.5"/>
<inertia ixx=".02" iyy=".03" izz=".04" ixy=".001" ixz="0" iyz="-.002"/></inertial></link>"""
JOINT = """<joint name="{0}" type="{1}"><parent link="{2}"/><child link="{3}"/><origin xyz="0.2 0.1 0.05" rpy="0.3 -0.4 0.7"/>
<axis xyz="{4}"/>{5}</joint>"""


def check(what, found, expected):
    global passed, failed
    found, expected = np.asarray(found, dtype=float), np.asarray(expected, dtype=float)
    if found.shape == expected.shape and np.abs(found - expected).max() <= TOLERANCE * max(1.0, np.abs(expected).max()):
        passed += 1
    else:
        failed += 1
        print(f"{what}: {found}, expected {expected}")


def unit(random):
    x = random.normal(size=4)
    return x / np.linalg.norm(x)


def urdf():
    """Hinge, hinge without limits, slide, a branch; names against the alphabet, so that programs order them otherwise."""
    limit = '<limit lower="-2" upper="2" effort="0" velocity="0"/>'
    joints = [
        JOINT.format("z_hinge", "revolute", "base", "first", "0 0 1", limit),
        JOINT.format("m_turn", "continuous", "first", "second", "0 1 0", ""),
        JOINT.format("a_slide", "prismatic", "second", "third", "1 0 0", limit),
        JOINT.format("b_branch", "revolute", "first", "fourth", "0.6 0 0.8", limit),
    ]
    links = [LINK.format(name) for name in ("first", "second", "third", "fourth")]
    return ROBOT.format(links="".join(links), joints="".join(joints))


def closing_speeds(model, converter, q, v, point, link="third"):
    """Speed of a point of a link by the velocities of percuss."""
    pose = model.pose(converter.positions(q))
    velocities = converter.velocities(v, q)
    names = model.velocity_names
    jacobian = pose.point_jacobian(link, point)
    system = model.system().coordinate_joints
    order = [names.index(joint if f"{joint}[0]" not in names else f"{joint}[{k}]") for joint, k in system]
    return (jacobian @ velocities[order])[-3:]


def mimics(pin):
    """A joint that follows another: independent in Pinocchio, with a warning, unless its reader is told to read mimics."""
    text = urdf().replace('<joint name="b_branch" type="revolute">', '<joint name="b_branch" type="revolute"><mimic joint="z_hinge" multiplier="-2"/>')
    model = percuss.loads(text)
    with warnings.catch_warnings(record=True) as found:
        warnings.simplefilter("always")
        percuss.converters.Converter.of_pinocchio(model, pin.buildModelFromXML(text))
        independent = [str(warning.message) for warning in found]
        percuss.converters.Converter.of_pinocchio(model, pin.buildModelFromXML(text, mimic=True))
    assert len(found) == len(independent) == 1 and '"b_branch" follows "z_hinge"' in independent[0], found
    peer = pin.buildModelFromXML(text, mimic=True)
    data, converter = peer.createData(), percuss.converters.Converter.of_pinocchio(model, peer)
    normal = np.array([0.6, 0.0, 0.8])
    for number in range(10):
        q = pin.randomConfiguration(peer, np.full(peer.nq, -1.0), np.full(peer.nq, 1.0))
        mass = pin.crba(peer, data, q)
        mass = np.triu(mass) + np.triu(mass, 1).T
        pin.framesForwardKinematics(peer, data, q)
        pin.computeJointJacobians(peer, data, q)
        jacobian = pin.getFrameJacobian(peer, data, peer.getFrameId("fourth", pin.FrameType.BODY), pin.LOCAL_WORLD_ALIGNED)
        row = normal @ jacobian[:3]
        contact = percuss.Contact("fourth", [0, 0, 0], normal, normal_frame="world")
        response = model.pose(converter.positions(q)).respond(contact)
        check(f"Pinocchio, mimics {number}", 1 / response.effective_mass, row @ np.linalg.solve(mass, row))


def states(pin, peer, data, converter, system, contact, q):
    """States there and back; dm̄/dt with a moving base against differences of m̄ of Pinocchio; rates after an impact from its M and J."""
    v = np.random.default_rng(5).normal(size=(len(q), peer.nv))
    frame, normal = peer.getFrameId("third", pin.FrameType.BODY), np.asarray(contact.normal) / np.linalg.norm(contact.normal)

    def matrices(q):
        mass = pin.crba(peer, data, q)
        jacobian = pin.computeFrameJacobian(peer, data, q, frame, pin.LOCAL_WORLD_ALIGNED)
        pin.framesForwardKinematics(peer, data, q)
        arm = data.oMf[frame].rotation @ contact.point
        return np.triu(mass) + np.triu(mass, 1).T, normal @ (jacobian[:3] - pin.skew(arm) @ jacobian[3:])

    def of_pinocchio(q):
        mass, row = matrices(q)
        return 1 / (row @ np.linalg.solve(mass, row))

    state = converter.state(q, v)
    back = converter.of_state(state)
    check("Pinocchio, states back", back[0], q)
    check("Pinocchio, velocities of states back", back[1], v)
    swept = percuss.sweep(system, contact, state, gradient=True)
    rates = np.sum(swept.gradient * state.velocities, axis=1) + np.sum(swept.base_gradient * state.twist(), axis=1)
    after = percuss.impacts(system, contact, state, restitution=0.3)
    after = percuss.State(state.model, state.positions, velocities=after.velocities, base_pose=state.base_pose, base_twist=after.base_twist)
    step = 1e-5
    for number, (q_row, v_row, found) in enumerate(zip(q, v, converter.of_state(after)[1])):
        mass, row = matrices(q_row)
        closing = max(row @ v_row, 0.0)
        expected = v_row - 1.3 * closing * of_pinocchio(q_row) * np.linalg.solve(mass, row)
        check(f"Pinocchio, impact {number}", found, expected)
        slope = np.subtract(*(of_pinocchio(pin.integrate(peer, q_row, sign * step * v_row)) for sign in (1, -1))) / (2 * step)
        # As for MuJoCo: the error of central differences.
        check(f"Pinocchio, rate {number}", round(abs(rates[number] - slope) / (1 + abs(slope)), 6), 0.0)


def pinocchio():
    import pinocchio as pin

    text = urdf()
    model = percuss.loads(text)
    point = np.array([0.05, -0.1, 0.2])
    contact = percuss.Contact("third", point, [0.2, -0.3, 0.9], normal_frame="world")
    for floating in (False, True):
        peer = pin.buildModelFromXML(text, pin.JointModelFreeFlyer()) if floating else pin.buildModelFromXML(text)
        data, converter = peer.createData(), percuss.converters.Converter.of_pinocchio(model, peer)
        random = np.random.default_rng(4)
        rows = []
        for number in range(20):
            q = pin.randomConfiguration(peer, np.full(peer.nq, -1.0), np.full(peer.nq, 1.0))
            pin.framesForwardKinematics(peer, data, q)
            own = converter.positions(q)
            base = converter.base_pose(q)
            pose = model.system(base="floating" if floating else "fixed").pose(own, base_pose=base)
            for link in ("first", "third", "fourth"):
                frame = data.oMf[peer.getFrameId(link, pin.FrameType.BODY)].homogeneous
                check(f"Pinocchio, floating {floating}, {link} {number}", pose.link_frame(link, frame="world"), frame)
            back = converter.from_positions(own, base)
            check(f"Pinocchio, back {number}", pin.normalize(peer, back), q)
            rows.append(q)
            if not floating:
                v = random.normal(size=peer.nv)
                frame = peer.getFrameId("third", pin.FrameType.BODY)
                jacobian = pin.computeFrameJacobian(peer, data, q, frame, pin.LOCAL_WORLD_ALIGNED)
                arm = data.oMf[frame].rotation @ point
                expected = (jacobian[:3] - pin.skew(arm) @ jacobian[3:]) @ v
                check(f"Pinocchio, velocities {number}", closing_speeds(model, converter, q, v, point), expected)
                check(f"Pinocchio, velocities back {number}", converter.from_velocities(converter.velocities(v)), v)
        check("Pinocchio, rows", converter.positions(np.stack(rows))[7], converter.positions(rows[7]))
        states(pin, peer, data, converter, model.system(base="floating" if floating else "fixed"), contact, np.stack(rows))
        built = percuss.from_pinocchio(peer)
        base_kind = "floating" if floating else "fixed"
        system, again = model.system(base=base_kind), built.system(base=base_kind)
        of_built = percuss.converters.Converter.of_pinocchio(built, peer)
        for number, q in enumerate(rows):
            given = {"base_pose": converter.base_pose(q)} if floating else {}
            expected = system.pose(converter.positions(q), **given).respond(contact).effective_mass
            found = again.pose(of_built.positions(q), **given).respond(contact).effective_mass
            check(f"from_pinocchio, floating {floating}, {number}", found, expected)
    mimics(pin)
    try:
        percuss.converters.Converter.of_pinocchio(percuss.load(ROOT / "models/six_r_arm.urdf"), peer)
        check("a model of other joints is refused", 0, 1)
    except percuss.InputError as error:
        check("a model of other joints is refused", "matched by name" in str(error), True)


MJCF = """<mujoco model="m"><compiler angle="radian"/><worldbody><body name="trunk" pos="0 0 1"><freejoint name="root"/>
<inertial pos="0.01 0 0" mass="4" diaginertia=".1 .2 .15"/>
<body name="upper" pos="0.2 0 0" quat="0.9 0.1 0.3 -0.2"><inertial pos="0 .1 0" mass="1" diaginertia=".02 .03 .04"/>
<joint name="ball" type="ball" armature="0.01"/>
<body name="third" pos="0 0.3 0"><inertial pos="0 .1 .02" mass=".7" diaginertia=".01 .02 .02"/>
<joint name="slide" type="slide" axis="0 1 0"/><joint name="hinge" axis="1 0 1" pos="0 0.05 0" ref="0.2" armature="0.02"/>
</body></body></body>
<body name="crank"><inertial pos=".1 0 0" mass="1" diaginertia=".01 .01 .01"/><joint name="crank" axis="0 1 0"/>
<body name="coupler" pos=".2 0 0"><inertial pos=".1 0 0" mass="1" diaginertia=".01 .01 .01"/><joint name="coupler" axis="0 1 0"/>
</body></body></worldbody>
<equality><joint joint1="coupler" joint2="crank" polycoef="0 -0.5 0 0 0"/></equality></mujoco>"""


def mujoco():
    import mujoco as mj

    peer = mj.MjModel.from_xml_string(MJCF)
    data = mj.MjData(peer)
    model = percuss.from_mujoco(peer)
    file = percuss.loads(MJCF)
    converter = percuss.converters.Converter.of_mujoco(model, peer)
    random = np.random.default_rng(8)
    contact = percuss.Contact("third", [0.1, 0.2, 0], [0.3, 0.5, -0.2], normal_frame="world")
    for number in range(20):
        q = random.uniform(-0.6, 0.6, peer.nq)
        for joint in range(peer.njnt):
            first = peer.jnt_qposadr[joint]
            if peer.jnt_type[joint] < 2:
                first += 3 if peer.jnt_type[joint] == 0 else 0
                q[first : first + 4] = unit(random)
        data.qpos[:] = q
        mj.mj_forward(peer, data)
        own = converter.positions(q)
        check(f"MuJoCo, back {number}", converter.from_positions(own, converter.base_pose(q)), q)
        masses = []
        for candidate in (model, file):
            pose = candidate.pose(percuss.converters.Converter.of_mujoco(candidate, peer).positions(q))
            masses.append(pose.respond(contact).effective_mass)
            for link in ("trunk", "upper", "third"):
                body = data.body(link)
                frame = np.eye(4)
                frame[:3, :3], frame[:3, 3] = body.xmat.reshape(3, 3), body.xpos
                check(f"MuJoCo, {link} {number}", pose.link_frame(link), frame)
        check(f"from_mujoco {number}", masses[0], masses[1])
        # m̄ without the coupling of the other mechanism, by M and the Jacobian of MuJoCo.
        mass, jacobian = np.zeros((peer.nv, peer.nv)), np.zeros((3, peer.nv))
        mj.mj_fullM(peer, mass, data.qM) if hasattr(data, "qM") else mj.mj_fullM(peer, data, mass)
        body = data.body("third")
        point = body.xpos + body.xmat.reshape(3, 3) @ contact.point
        mj.mj_jac(peer, data, jacobian, None, point, peer.body("third").id)
        row = np.asarray(contact.normal) / np.linalg.norm(contact.normal) @ jacobian
        check(f"MuJoCo, mass {number}", masses[0], 1 / (row @ np.linalg.solve(mass, row)))
        # dm̄/dt by the gradient, with velocities of MuJoCo, against a step of MuJoCo's integration of positions.
        v = random.normal(size=peer.nv)
        v[[peer.joint(name).dofadr[0] for name in ("crank", "coupler")]] = 0
        step, masses = 1e-5, []
        for sign in (1, -1):
            moved = q.copy()
            mj.mj_integratePos(peer, moved, v, sign * step)
            masses.append(percuss.sweep(model, contact, converter.positions(moved)[None]).effective_mass[0])
        swept = percuss.sweep(model, contact, own[None], gradient=True)
        found = swept.gradient[0] @ converter.state(q, v).velocities
        expected = (masses[0] - masses[1]) / (2 * step)
        # Central differences: 1e-10 of the third derivative, 1e-16 / 1e-5 of rounding.
        check(f"MuJoCo, rate {number}", round(abs(found - expected) / (1 + abs(expected)), 6), 0.0)


DRAKE = """<robot name="d">
<link name="trunk"><inertial><mass value="3"/><inertia ixx=".1" iyy=".2" izz=".15" ixy="0" ixz="0" iyz="0"/></inertial></link>
{links}
{joints}
<drake:joint name="ball" type="ball" xmlns:drake="http://drake.mit.edu"><parent link="trunk"/><child link="first"/>
<origin xyz="0.2 0.1 0.05" rpy="0.3 -0.4 0.7"/></drake:joint></robot>"""


def drake_models(kind):
    """Text for Drake and for percuss: a tree with a ball, a hinge, a slide and a planar or free joint."""
    limit = '<limit lower="-2" upper="2" effort="0" velocity="0"/>'
    joints = [
        JOINT.format("z_hinge", "revolute", "first", "second", "0 0.6 0.8", limit),
        JOINT.format("a_slide", "prismatic", "second", "third", "1 0 0", limit),
        JOINT.format("b_" + kind, kind, "trunk", "fourth", "0 0 1", limit),
    ]
    links = [LINK.format(name) for name in ("first", "second", "third", "fourth")]
    text = DRAKE.format(links="".join(links), joints="".join(joints))
    own = text.replace("drake:joint", "joint").replace('"ball" type="ball"', '"ball" type="spherical"')
    if kind == "planar":
        head, _, tail = text.partition('<joint name="b_planar"')
        text = f'{head}<drake:joint name="b_planar"{tail.replace("</joint>", "</drake:joint>", 1)}'
    else:
        # Drake has no floating joint in URDF: the plant receives it.
        head, _, tail = text.partition('<joint name="b_floating"')
        text = head + tail.partition("</joint>")[2]
    return text, own.replace(' xmlns:drake="http://drake.mit.edu"', "")


def fixed_frame(body, pose):
    from pydrake.multibody.tree import FixedOffsetFrame

    return FixedOffsetFrame("origin of the joint", body.body_frame(), pose)


def drake():
    from pydrake.math import RigidTransform, RollPitchYaw
    from pydrake.multibody.parsing import Parser
    from pydrake.multibody.plant import MultibodyPlant
    from pydrake.multibody.tree import JacobianWrtVariable, QuaternionFloatingJoint

    random = np.random.default_rng(11)
    point = np.array([0.05, -0.1, 0.2])
    contact = percuss.Contact("third", point, [0.2, -0.3, 0.9], normal_frame="world")
    for kind in ("planar", "floating"):
        for floating in (False, True):
            text, own_text = drake_models(kind)
            plant = MultibodyPlant(0.0)
            Parser(plant).AddModelsFromString(text, "urdf")
            trunk = plant.GetBodyByName("trunk")
            if kind == "floating":
                # The origin in JOINT.
                origin = RigidTransform(RollPitchYaw(0.3, -0.4, 0.7), [0.2, 0.1, 0.05])
                fourth = plant.GetBodyByName("fourth").body_frame()
                plant.AddJoint(QuaternionFloatingJoint("b_floating", plant.AddFrame(fixed_frame(trunk, origin)), fourth))
            if not floating:
                plant.WeldFrames(plant.world_frame(), trunk.body_frame(), RigidTransform())
            plant.Finalize()
            context, model = plant.CreateDefaultContext(), percuss.loads(own_text)
            converter = percuss.converters.Converter.of_drake(model, plant)
            system = model.system(base="floating" if floating else "fixed")
            rows = []
            for number in range(20):
                case = f"Drake, {kind}, floating {floating}, {number}"
                q = random.uniform(-1.0, 1.0, plant.num_positions())
                for index in plant.GetJointIndices():
                    joint = plant.get_joint(index)
                    if joint.num_positions() == 7:
                        q[joint.position_start() : joint.position_start() + 4] = unit(random)
                plant.SetPositions(context, q)
                own, base = converter.positions(q), converter.base_pose(q)
                pose = system.pose(own, base_pose=base)
                for link in ("trunk", "first", "third", "fourth"):
                    frame = plant.EvalBodyPoseInWorld(context, plant.GetBodyByName(link)).GetAsMatrix4()
                    check(f"{case}, {link}", pose.link_frame(link, frame="world"), frame)
                check(f"{case}, back", converter.from_positions(own, base), q)
                rows.append(q)
                # m̄ by M and the Jacobian of Drake.
                body = plant.GetBodyByName("third").body_frame()
                jacobian = plant.CalcJacobianTranslationalVelocity(
                    context, JacobianWrtVariable.kV, body, point, plant.world_frame(), plant.world_frame()
                )
                row = np.asarray(contact.normal) / np.linalg.norm(contact.normal) @ jacobian
                mass = 1 / (row @ np.linalg.solve(plant.CalcMassMatrix(context), row))
                check(f"{case}, mass", pose.respond(contact).effective_mass, mass)
                if not floating:
                    v = random.normal(size=plant.num_velocities())
                    check(f"{case}, velocities", closing_speeds(model, converter, q, v, point), jacobian @ v)
                    of_fourth = plant.CalcJacobianTranslationalVelocity(
                        context, JacobianWrtVariable.kV, plant.GetBodyByName("fourth").body_frame(), point,
                        plant.world_frame(), plant.world_frame(),
                    )
                    check(f"{case}, {kind} joint", closing_speeds(model, converter, q, v, point, "fourth"), of_fourth @ v)
                    check(f"{case}, velocities back", converter.from_velocities(converter.velocities(v, q), own), v)
            check(f"Drake, {kind}, rows", converter.positions(np.stack(rows))[7], converter.positions(rows[7]))


def run(name, work):
    if importlib.util.find_spec(name):
        work()


flags = argparse.ArgumentParser()
flags.add_argument("--package", type=Path)
given = flags.parse_args()
if given.package:
    sys.path.insert(0, str(given.package))
import percuss  # noqa: E402

run("pinocchio", pinocchio)
run("mujoco", mujoco)
run("pydrake", drake)
print(f"{passed} passed, {failed} failed")
sys.exit(failed > 0 or passed == 0)
