"""Published MJCF models, compared with MuJoCo as in mjcf.py: models of the packages gymnasium and mujoco, or of given folders.

    mjcf_models.py --percuss PATH                    the models of the packages; prints `N passed, N failed`
    mjcf_models.py --percuss PATH --folder FOLDER... all .xml files below, for example a checkout of mujoco, of menagerie or the wheels of
                                                     dm_control, robosuite and metaworld
"""

import argparse
import collections
import importlib.util
import pathlib
import sys

import numpy as np

from mjcf import MESH_TOLERANCE, TOLERANCE, Peer, compare_file, run

CONTACTS = 4
# MuJoCo's own models with more coordinates than this take minutes.
MOST_COORDINATES = 120
# Known differences and refusals: end of the path of the model, and reason.
KNOWN = {
    "user/testdata/dzhanibekov.xml": "align: MuJoCo moves the frame of the free body to its centre of mass",
    "user/testdata/freejoint.xml": "alignfree: MuJoCo moves the frame of the free body to its centre of mass",
}
# Words in the messages of expected refusals, and reasons: no rigid mechanism, or an inertia that only MuJoCo's code can compute.
REFUSALS = {
    "deformable bodies": "flex",
    "armature of a spatial tendon": "armature of a spatial tendon",
    "builtin": "mesh that MuJoCo makes itself",
    "sdf": "geom by a plugin",
    "OBJ file": "mesh without triangles",
    "MSH file": "mesh of Gmsh",
    "radius of gyration": "inertia that no body of this size has",
    "A + B": "inertia that no body has",
}
# Expected numbers of outcomes of the models of the packages.
EXPECTED = {"compared": 15, "no motion": 1}


def package_folders():
    for name in ("gymnasium", "mujoco"):
        yield pathlib.Path(importlib.util.find_spec(name).origin).parent


def outcome(percuss, path):
    """Outcome: (kind, text)."""
    head = path.read_text(errors="replace")
    if "<mujoco" not in head or "<mujocoinclude" in head:
        return "no model", ""
    checked = run(percuss, "check", str(path))
    try:
        peer = Peer(path)
    except ValueError as error:
        kind = "refused by MuJoCo alone" if checked.returncode == 0 else "refused by both"
        return kind, str(error).splitlines()[0]
    known = next((reason for end, reason in KNOWN.items() if str(path).endswith(end)), None)
    if known:
        return "known", known
    if peer.model.nv == 0 or not peer.contact_links():
        return "no motion", ""
    if peer.model.nv > MOST_COORDINATES:
        return "large", f"{peer.model.nv} coordinates"
    answer = compare_file(percuss, str(path), np.random.default_rng(0), CONTACTS, peer=peer)
    if isinstance(answer, str):
        text = " ".join(checked.stderr.split())
        reason = next((reason for words, reason in REFUSALS.items() if words in text), None)
        return ("refused", reason) if reason else ("failed", text[-300:])
    deviations, unreachable = answer
    if not deviations:
        return "out of reach", f"{unreachable} poses"
    worst = max(deviation for deviation, _ in deviations)
    limit = MESH_TOLERANCE if peer.uses_mesh() else TOLERANCE
    return ("compared" if worst <= limit else "failed"), f"{worst:.1e}"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--percuss", required=True)
    parser.add_argument("--folder", nargs="*", type=pathlib.Path)
    parser.add_argument("--verbose", action="store_true")
    options = parser.parse_args()
    counts, failures = collections.Counter(), []
    for folder in options.folder or package_folders():
        for path in sorted(folder.rglob("*.xml")):
            kind, text = outcome(options.percuss, path)
            counts[kind] += 1
            if options.verbose:
                print(f"{kind:24} {path.relative_to(folder)} {text}")
            if kind == "failed":
                failures.append(f"{path.relative_to(folder)}: {text}")
    if not options.folder and dict(counts) != EXPECTED:
        failures.append(f"{dict(counts)}, expected {EXPECTED}")
    print("\n".join(failures))
    print(f"models of MJCF: {dict(counts)}")
    print(f"{counts['compared'] + counts['known']} passed, {len(failures)} failed")
    sys.exit(bool(failures))


if __name__ == "__main__":
    main()
