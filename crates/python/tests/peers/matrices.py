"""percuss.effective_mass with matrices of other programs: Pinocchio (M, the Jacobian of a point), MuJoCo (mj_fullM, a
contact's Jacobian, equality rows) and Drake (the mass matrix of a plant) gives the effective mass of percuss's own
pose.

    matrices.py --package FOLDER     runs what can be imported; prints `N passed, N failed`
"""

import argparse
import importlib.util
import re
import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[4]
# Both sides compute M and J by their own recursions; condition numbers up to some thousand.
TOLERANCE = 1e-9

passed = failed = 0


def compare(what, found, expected):
    global passed, failed
    if found is not None and abs(found / expected - 1) <= TOLERANCE:
        passed += 1
    else:
        failed += 1
        print(f"{what}: {found}, expected {expected}")


def contacts(model, count, seed):
    """Random contacts of links with mass, except the root link."""
    random = np.random.default_rng(seed)
    links = [link["name"] for link in percuss.reports.check(model).links if link["mass"] > 0 and link["name"] != model.links[0]]
    for _ in range(count):
        link = links[random.integers(len(links))]
        yield percuss.Contact(link, random.uniform(-0.3, 0.3, 3), random.normal(size=3))


def plain(path):
    """File without processing instructions, which some XML readers refuse."""
    return re.sub(r"<\?percuss.*?\?>", "", path.read_text())


def arms():
    """Serial arms: the shipped arm, and further arms if the package example_robot_data is installed."""
    paths = [ROOT / "models/six_r_arm.urdf"]
    if importlib.util.find_spec("example_robot_data"):
        spec = importlib.util.find_spec("example_robot_data")
        robots = Path(spec.origin).parents[4] / "share/example-robot-data/robots"
        robots = robots if robots.is_dir() else next(Path(sys.prefix).rglob("example-robot-data/robots"))
        paths += [robots / "panda_description/urdf/panda.urdf", robots / "ur_description/urdf/ur5_robot.urdf"]
    return paths


def pinocchio():
    import pinocchio as pin

    for path in arms():
        model = percuss.load(path)
        peer = pin.buildModelFromXML(plain(path))
        data = peer.createData()
        random = np.random.default_rng(3)
        for number, contact in enumerate(contacts(model, 20, 5)):
            # Pinocchio's joints by name. Pinocchio treats mimics as independent joints, so no joint is locked and
            # mimics get no position.
            joints = [joint for joint in model.joints if joint.kind != "fixed"]
            values = {joint.name: random.uniform(*(joint.limits or (-1, 1))) for joint in joints if not joint.mimics}
            q = pin.neutral(peer)
            for name, value in values.items():
                joint = peer.joints[peer.getJointId(name)]
                # A hinge without limits is a cosine and a sine.
                q[joint.idx_q : joint.idx_q + joint.nq] = value if joint.nq == 1 else (np.cos(value), np.sin(value))
            pose = model.pose(values)
            response = pose.respond(contact)
            if response.status != "finite":
                continue
            pin.crba(peer, data, q)
            mass = np.triu(data.M) + np.triu(data.M, 1).T
            pin.computeJointJacobians(peer, data, q)
            pin.updateFramePlacements(peer, data)
            frame = peer.getFrameId(contact.link, pin.FrameType.BODY)
            jacobian = pin.getFrameJacobian(peer, data, frame, pin.LOCAL_WORLD_ALIGNED)
            arm = data.oMf[frame].rotation @ contact.point
            normal = data.oMf[frame].rotation @ contact.normal
            normal /= np.linalg.norm(normal)
            at_point = jacobian[:3] - pin.skew(arm) @ jacobian[3:]
            mimics = [joint for joint in model.joints if joint.mimics]
            rows = np.zeros((len(mimics), peer.nv))
            for row, joint in zip(rows, mimics):
                # In these files a mimic moves exactly as its master.
                row[peer.joints[peer.getJointId(joint.name)].idx_v] = 1
                row[peer.joints[peer.getJointId(joint.mimics)].idx_v] = -1
            found = percuss.effective_mass(mass, normal @ at_point, rows)
            compare(f"Pinocchio, {path.stem}, contact {number}", found.effective_mass, response.effective_mass)


def mujoco():
    import mujoco as mj

    sys.path.insert(0, str(ROOT / "tests/external"))
    import loops

    for name in ("four_bar", "six_bar", "double_wishbone"):
        path = ROOT / f"models/{name}.urdf"
        model, peer = percuss.load(path), loops.Peer(path)
        driver, values, spared = loops.MODELS[name]
        driver = driver or model.assemble().drivers[0]
        m, d = peer.model, peer.data
        for number, (value, contact) in enumerate(zip(values, contacts(model, len(values), 9))):
            if contact.link in spared:
                continue
            try:
                pose = model.pose({driver: value})
            except percuss.errors.AssemblyError:
                continue
            response = pose.respond(contact)
            if response.status != "finite":
                continue
            for joint, position in pose.joints.items():
                address = m.joint(joint).qposadr[0]
                d.qpos[address : address + len(position)] = position
            mj.mj_fwdPosition(m, d)
            mass = np.zeros((m.nv, m.nv))
            mj.mj_fullM(m, d, mass)
            rows = d.efc_J.reshape(d.nefc, m.nv)[d.efc_type == mj.mjtConstraint.mjCNSTR_EQUALITY]
            jacobian = np.zeros((3, m.nv))
            mj.mj_jac(m, d, jacobian, None, response.point_world, m.body(contact.link).id)
            # MuJoCo's equality rows of closed loops hold to about 1e-9; the rank floor is above.
            found = percuss.effective_mass(mass, response.normal_world @ jacobian, rows, rank_floor=1e-8)
            compare(f"MuJoCo, {name}, contact {number}", found.effective_mass, response.effective_mass)
            assert found.rank["redundant_rows"] or name == "double_wishbone"
    contact_of_its_own(mj)


def contact_of_its_own(mj):
    """A contact found by MuJoCo: a ball at the end of a double pendulum on a plane. The first row belongs to the
    normal."""
    text = """<mujoco><option cone="elliptic"/><worldbody><geom type="plane" size="5 5 1"/>
      <body pos="0 0 0.9"><joint type="hinge" axis="0 1 0"/><geom type="capsule" fromto="0 0 0 0.5 0 0" size="0.02" mass="2" contype="0" conaffinity="0"/>
        <body pos="0.5 0 0"><joint type="hinge" axis="0 1 0"/>
          <geom type="capsule" fromto="0 0 0 0.5 0 0" size="0.02" mass="1" contype="0" conaffinity="0"/>
          <geom type="sphere" pos="0.5 0 0" size="0.1" mass="0.3" name="tip"/></body></body></worldbody></mujoco>"""
    m = mj.MjModel.from_xml_string(text)
    d = mj.MjData(m)
    # Penetration of the tip: 5 mm.
    d.qpos[:] = (np.arcsin(0.9), np.arcsin(0.71) - np.arcsin(0.9))
    mj.mj_fwdPosition(m, d)
    assert d.ncon == 1, d.ncon
    mass = np.zeros((m.nv, m.nv))
    mj.mj_fullM(m, d, mass)
    row = d.efc_J.reshape(d.nefc, m.nv)[d.contact[0].efc_address]
    found = percuss.effective_mass(mass, row)
    compare("MuJoCo's own contact", found.effective_mass, 1 / (row @ np.linalg.solve(mass, row)))
    # The contact point is in the middle of the overlap, not on the ball; the row is the Jacobian of this point.
    jacobian = np.zeros((3, m.nv))
    mj.mj_jac(m, d, jacobian, None, d.contact[0].pos, m.geom("tip").bodyid[0])
    compare("MuJoCo's contact row", float(row @ row), float((jacobian[2]) @ jacobian[2]))


def drake():
    from pydrake.multibody.parsing import Parser
    from pydrake.multibody.plant import MultibodyPlant
    from pydrake.multibody.tree import JacobianWrtVariable

    path = ROOT / "models/six_r_arm.urdf"
    model = percuss.load(path)
    plant = MultibodyPlant(0.0)
    Parser(plant).AddModelsFromString(plain(path), "urdf")
    root = plant.GetBodyByName(model.links[0])
    plant.WeldFrames(plant.world_frame(), root.body_frame())
    plant.Finalize()
    context = plant.CreateDefaultContext()
    world, random = plant.world_frame(), np.random.default_rng(4)
    for number, contact in enumerate(contacts(model, 30, 6)):
        values = {joint.name: random.uniform(-2, 2) for joint in model.joints if joint.kind != "fixed"}
        for name, value in values.items():
            plant.GetJointByName(name).set_angle(context, value)
        response = model.pose(values).respond(contact)
        if response.status != "finite":
            continue
        mass = plant.CalcMassMatrix(context)
        jacobian = plant.CalcJacobianTranslationalVelocity(
            context, JacobianWrtVariable.kV, plant.GetFrameByName(contact.link), np.array(contact.point), world, world
        )
        found = percuss.effective_mass(mass, response.normal_world @ jacobian)
        compare(f"Drake, contact {number}", found.effective_mass, response.effective_mass)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--package", required=True, help="folder that holds the package percuss")
    sys.path.append(parser.parse_args().package)
    global percuss
    import percuss

    ran = []
    for module, check in (("pinocchio", pinocchio), ("mujoco", mujoco), ("pydrake", drake)):
        if importlib.util.find_spec(module) is None:
            continue
        before = passed
        check()
        ran.append(f"{module} {passed - before}")
        if passed - before < 10:
            raise SystemExit(f"{module}: only {passed - before} contacts were compared")
    print(f"matrices of others: {', '.join(ran)}")
    print(f"{passed} passed, {failed} failed")
    return 1 if failed or not passed else 0


if __name__ == "__main__":
    sys.exit(main())
