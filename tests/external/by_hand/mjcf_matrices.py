"""Compares mass matrices M, constraint matrices A and point Jacobians J of MJCF models with MuJoCo, at random poses with closed loops.

    PYTHONPATH=tests/external:FOLDER_OF_PERCUSS python mjcf_matrices.py [--poses N] FOLDER...

The two programs use different velocities, v and v' = T v. T is the least-squares solution of J = J' T for points of all links. The checks
are J = J' T, M = Tᵀ M' T, and that the rows of A and of A' T span the same space. Limits relative to the largest entry: 1e-9; 2e-7 with
meshes, because MuJoCo stores vertices in single precision.
"""

import argparse
import collections
import json
import pathlib
import sys

import mujoco
import numpy as np
import percuss
from mjcf import MESH_TOLERANCE, TOLERANCE, Peer, random_position
from mjcf_models import MOST_COORDINATES, models

# Singular values below this fraction of the largest one count as 0.
RANK = 1e-8


def row_space(rows, size):
    """Orthonormal basis of the row space, as rows."""
    rows = rows / np.maximum(np.abs(rows).max(axis=1, keepdims=True, initial=0), 1e-300)
    if not len(rows):
        return np.zeros((0, size))
    _, s, vt = np.linalg.svd(rows, full_matrices=False)
    return vt[s > RANK * max(s.max(), 1e-300)]


def deviation(peer, pose, rng):
    """Largest deviations of J, of M, and of the row space of A, relative to the largest entry (A: absolute); None if T is not unique."""
    peer.set_pose({name: list(values) for name, values in pose.joints.items()})
    mass, rows = peer.matrices()
    m, d = peer.model, peer.data
    ours, theirs = [], []
    for body in range(1, m.nbody):
        for _ in range(4):
            point = rng.uniform(-1, 1, 3)
            at = d.xpos[body] + d.xmat[body].reshape(3, 3) @ point
            jacobian = np.zeros((3, m.nv))
            mujoco.mj_jac(m, d, jacobian, None, at, body)
            theirs.append(jacobian)
            ours.append(pose.point_jacobian(peer.links[body], point))
    ours, theirs = np.vstack(ours), np.vstack(theirs)
    if np.linalg.matrix_rank(theirs, tol=RANK * np.abs(theirs).max()) < m.nv:
        return None
    velocities, *_ = np.linalg.lstsq(theirs, ours, rcond=None)
    own = pose.mass_matrix()
    # Rows that the velocities satisfy, such as those of mimics, are rounding.
    size = (np.abs(rows) @ np.abs(velocities)).max(axis=1, initial=0)
    reduced = rows @ velocities
    reduced = reduced[np.abs(reduced).max(axis=1, initial=0) > RANK * size]
    space, other = row_space(pose.constraint_matrix(), own.shape[0]), row_space(reduced, own.shape[0])
    if space.shape != other.shape:
        return {"rank of A": 1.0}
    difference = space - space @ other.T @ other
    return {
        "J": np.abs(theirs @ velocities - ours).max() / np.abs(ours).max(),
        "M": np.abs(velocities.T @ mass @ velocities - own).max() / np.abs(own).max(),
        "A": np.abs(difference).max(initial=0),
    }


def outcome(path, count, rng):
    try:
        peer = Peer(path)
        model = percuss.load(path)
    except (ValueError, RuntimeError, percuss.PercussError) as error:
        return "not read by both", str(error).splitlines()[0][:120]
    if not 0 < peer.model.nv <= MOST_COORDINATES:
        return "none or many coordinates", str(peer.model.nv)
    if not set(model.links[1:]) >= set(peer.links[1:]):
        return "other links", ""
    if any(peer.model.tendon_armature):
        return "tendons with an armature", "percuss adds a coordinate for each tendon"
    system = model.assemble()
    info = {joint.name: joint for joint in model.joints}
    worst = collections.Counter()
    done = 0
    for number in range(count):
        names = system.drivers if model.closures else [n for n, j in info.items() if j.kind != "fixed" and j.mimics is None]
        size = 0.3 * (number % 3) / 2 if model.closures else 1.0
        q = {}
        for name in names:
            joint = info[name]
            if model.closures and (size == 0 or joint.kind in ("spherical", "floating")):
                continue
            q[name] = random_position(rng, joint.kind, joint.limits, size)
        try:
            pose = system.pose(q)
        except percuss.PercussError:
            continue
        found = deviation(peer, pose, rng)
        if found is None:
            return "coaxial joints", "the points do not determine all velocities"
        done += 1
        for name, value in found.items():
            worst[name] = max(worst[name], value)
    if not done:
        return "out of reach", ""
    limit = MESH_TOLERANCE if peer.uses_mesh() else TOLERANCE
    text = f"{done} poses " + " ".join(f"{name} {value:.1e}" for name, value in worst.items())
    return ("equal" if max(worst.values()) <= limit else "deviates"), text


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", type=pathlib.Path)
    parser.add_argument("--poses", type=int, default=100)
    parser.add_argument("--verbose", action="store_true")
    options = parser.parse_args()
    ledger = json.loads((pathlib.Path(__file__).parents[1] / "mjcf_models.json").read_text())
    counts, rng = collections.Counter(), np.random.default_rng(0)
    for folder in options.folders:
        for path in models(folder):
            kind, text = outcome(path, options.poses, rng)
            if any(path.as_posix().endswith(entry["model"]) and entry["outcome"] == kind for entry in ledger):
                kind = f"{kind} (ledger)"
            counts[kind] += 1
            if options.verbose or kind == "deviates":
                print(f"{kind:18} {path.relative_to(folder)} {text}", flush=True)
    print(dict(counts))
    print(f"{counts['equal']} passed, {counts['deviates']} failed")
    sys.exit(bool(counts["deviates"]))


if __name__ == "__main__":
    main()
