"""percuss.from_usd against the importer of Newton: effective masses of the scenes that Newton ships, in random poses, with Newton's matrices.

    usd.py --package FOLDER     needs newton[importers]; prints `N passed, N failed`
"""

import argparse
import sys
import warnings
from pathlib import Path

import newton
import newton.usd
import numpy as np
from pxr import Usd

# Newton computes in single precision, 6e-8, of which masses of colliders lose two digits; relative to the condition number of its matrix.
TOLERANCE = 1e-5
POSES = 10
# Scenes with a body that Newton moves and percuss holds (kinematic), or in sequences that Newton orders by name.
OTHER_MEANING = ("actuator_test", "humanoid_mjc", "ant_multi")


def rotation(x, y, z, w):
    v = np.array([x, y, z])
    skew = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return 2 * np.outer(v, v) + (w * w - v @ v) * np.eye(3) + 2 * w * skew


def compare(percuss, stage, random):
    """Largest relative difference by the condition number, or the reason why Newton has no articulation of this scene."""
    model = percuss.from_usd(stage)
    builder = newton.ModelBuilder()
    resolvers = [newton.usd.SchemaResolverNewton(), newton.usd.SchemaResolverPhysx(), newton.usd.SchemaResolverMjc()]
    builder.add_usd(stage, collapse_fixed_joints=False, schema_resolvers=resolvers)
    try:
        peer = builder.finalize(device="cpu")
    except ValueError as error:
        return str(error).split(".")[0]
    if peer.articulation_count == 0:
        return "no articulation"
    kinds, starts, dofs = peer.joint_type.numpy(), peer.joint_q_start.numpy(), peer.joint_qd_start.numpy()
    articulations, children = peer.articulation_start.numpy(), peer.joint_child.numpy()
    links, joints = set(model.links), [joint.name for joint in model.joints]
    grounded, drawn, worst = "world" in links, peer.joint_q.numpy().copy(), 0.0

    def name(label, names):
        return label if label in names else label.rsplit("/", 1)[-1]

    for _ in range(POSES):
        q, positions = drawn.copy(), {}
        for joint, label in enumerate(peer.joint_label):
            first, last = starts[joint], starts[joint + 1]
            if kinds[joint] == int(newton.JointType.FREE):
                if not grounded:
                    q[first:last] = [0, 0, 0, 0, 0, 0, 1]
                continue
            own = name(label, joints)
            if kinds[joint] == int(newton.JointType.BALL):
                q[first:last] = (lambda x: x / np.linalg.norm(x))(random.normal(size=4))
                positions[own] = q[[last - 1, first, first + 1, first + 2]].tolist()
                continue
            q[first:last] = random.uniform(-0.7, 0.7, last - first)
            parts = [joint for joint in joints if joint == own or joint.startswith(f"{own}:")]
            if last > first:
                parts = [part for part in parts if "(frame)" not in part]
                positions.update(zip(parts, q[first:last].tolist(), strict=True))
        peer.joint_q.assign(q)
        state = peer.state()
        newton.eval_fk(peer, peer.joint_q, peer.joint_qd, state)
        matrices, jacobians = newton.eval_mass_matrix(peer, state).numpy(), newton.eval_jacobian(peer, state).numpy()
        pose = model.pose(positions) if grounded else model.system(base="floating").pose(positions)
        for number in range(peer.articulation_count):
            low, high = articulations[number], articulations[number + 1]
            free = (dofs[high] if high < len(dofs) else peer.joint_dof_count) - dofs[low]
            k = int(random.integers(high - low))
            body = children[low + k]
            turn = rotation(*state.body_q.numpy()[body][3:].astype(float))
            point, normal = random.normal(size=3) * 0.2, random.normal(size=3)
            normal /= np.linalg.norm(normal)
            arm = turn @ (point - peer.body_com.numpy()[body])
            rows = jacobians[number][6 * k : 6 * k + 6, :free].astype(float)
            row = normal @ rows[:3] + np.cross(arm, normal) @ rows[3:]
            if np.linalg.norm(row) < 1e-6:
                continue
            matrix = matrices[number][:free, :free].astype(float)
            expected = 1.0 / (row @ np.linalg.solve(matrix, row))
            link = name(peer.body_label[body], links)
            contact = percuss.Contact(link, point=point, normal=normal, normal_frame="world")
            worst = max(worst, abs(pose.respond(contact).effective_mass / expected - 1.0) / np.linalg.cond(matrix))
    return worst


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--package", required=True)
    sys.path.insert(0, parser.parse_args().package)
    import percuss

    warnings.simplefilter("ignore")
    passed = failed = 0
    random = np.random.default_rng(1)
    folder = Path(newton.__file__).parent
    for path in sorted(folder.rglob("*.usda")):
        if path.stem in OTHER_MEANING:
            continue
        try:
            found = compare(percuss, Usd.Stage.Open(str(path)), random)
        except percuss.PercussError as error:
            found = str(error).split(";")[0]
        if isinstance(found, str):
            print(f"{path.relative_to(folder)}: not compared: {found}")
            continue
        passed, failed = passed + (found < TOLERANCE), failed + (found >= TOLERANCE)
        print(f"{path.relative_to(folder)}: {found:.1e}")
    print(f"{passed} passed, {failed} failed")
    sys.exit(failed != 0 or passed < 20)


main()
