"""Compares percuss with Pinocchio and MuJoCo on the URDFs of example-robot-data. Run by run.sh; see README.md."""

import argparse
import collections
import json
import subprocess
import sys
import sysconfig
import time
import zlib
from pathlib import Path

import numpy as np

import mujoco_peer
import pinocchio_peer
import questions
import urdf_file
from ledger import INDEFINITE, Ledger
from reference import SINGULAR, Inertia
from tally import Tally

ROBOTS = Path(sysconfig.get_paths()["purelib"]) / "cmeel.prefix/share/example-robot-data/robots"
OURS = Path(__file__).resolve().parent / "robots"
FILES = 69  # in ROBOTS
SEED = 20261121
CONTACTS = 5  # per configuration

# Reasons: README.md.
PLACE = 1e-12  # points (m), normals, positions
MATRIX = 1e-13  # M, relative by Frobenius' norm; j, relative to the size of its terms
AMPLIFIED = 1e-14  # m̄, relative, for each time that rounding is magnified
RECURSION = 1e-11  # m̄, relative: percuss's own limit for its recursion
MASS = 1e-9  # m̄, relative, wherever the two above allow it

ALWAYS_IN_MUJOCO = ("ur5_robot", "panda", "g1_29dof_rev_1_0", "talos_full_v2")
STATUSES = ("finite", "immovable", "massless")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--probe", required=True)
    parser.add_argument("--only", nargs="*", default=[], help="files whose path contains one of these")
    parser.add_argument("--configurations", type=int, default=100, help="of each file on each base")
    parser.add_argument("--update-ledger", action="store_true", help="take what is found as right")
    options = parser.parse_args()
    start, tally, ledger = time.monotonic(), Tally(), Ledger(options.update_ledger)
    files = {str(path.relative_to(ROBOTS)): path for path in sorted(ROBOTS.rglob("*.urdf"))}
    tally.check("all files are there", str(ROBOTS), len(files) == FILES, f"{len(files)} files, and not {FILES}")
    files |= {f"ours/{path.name}": path for path in sorted(OURS.glob("*.urdf"))}
    for name, path in files.items():
        if not options.only or any(part in name for part in options.only):
            one_file(name, path, options, ledger, tally)
    compared = sum("diagnostics" in entry for entry in ledger.found.values())
    tally.check("every file was compared", str(options.only), compared >= max(len(options.only), 1), f"{compared} files")
    everything = not options.only
    ledger.close(tally, everything)
    if everything:
        nothing_was_skipped(ledger, tally)
    summary(ledger)
    sys.exit(tally.report(time.monotonic() - start))


def one_file(name, path, options, ledger, tally):
    def ask(accept, **more):
        request = {"model": str(path), "accept_indefinite_inertia": accept, **more}
        run = subprocess.run([options.probe], input=json.dumps(request), capture_output=True, text=True)
        if run.returncode != 0:
            sys.exit(f"the probe failed on {name}: {run.stderr.strip()}")
        return json.loads(run.stdout)

    accept = ledger.load(name, ask)
    if accept is None:
        return
    robot = urdf_file.read(path)
    for base in ("fixed", "floating"):
        rng = np.random.default_rng([SEED, zlib.crc32(name.encode()), base == "floating"])
        asked = questions.configurations(robot, base == "floating", options.configurations, CONTACTS, rng)
        answer = ask(accept, base=base, configurations=asked)
        coordinates = [tuple(c) for c in answer["coordinates"]]
        peers = list(peers_of(name, path, robot, base == "floating", ledger))
        for k, (wanted, got) in enumerate(zip(asked, answer["configurations"], strict=True)):
            where = f"{name}, {base}, configuration {k}"
            positions = robot.positions(wanted["joints"])
            one_pose(positions, got["pose"], where, tally)
            for contact in got["contacts"]:
                tally.answered(f"robots, {base} base", contact)
            for peer in peers:
                peer.pose(coordinates, positions, wanted["base"])
                one_configuration(peer, base, wanted["contacts"], got, where, tally)


def peers_of(name, path, robot, floating, ledger):
    """Peers that accept the file."""
    yield pinocchio_peer.Peer(path, robot, floating)
    for peer, wanted in [
        (pinocchio_peer.FoldingPeer, any(joint.mimic for joint in robot.movable)),
        (mujoco_peer.Peer, True),
    ]:
        try:
            if wanted:
                yield peer(path, robot, floating)
        except urdf_file.Refused as refusal:
            ledger.refused_by(name, peer.name, refusal)


def one_pose(wanted, got, where, tally):
    tally.check("joints that move", where, got.keys() == wanted.keys(), f"{got.keys() ^ wanted.keys()}")
    off = [np.abs(np.subtract(got[joint], wanted[joint])).max() for joint in wanted if joint in got]
    tally.within("positions, mimics included", where, max(off, default=0.0), PLACE)


def one_configuration(peer, base, contacts, got, where, tally):
    theirs = peer.mass_matrix()
    ours = np.array(got["mass_matrix"]).reshape(theirs.shape)
    size = np.linalg.norm(theirs)
    off = np.linalg.norm(ours - theirs)
    tally.within(f"M, {peer.name}", where, off / size if off > 0 else 0.0, MATRIX)
    if not peer.knows_contacts:
        return
    inertia = Inertia(theirs)
    regular = inertia.condition < SINGULAR
    tally.check(f"M regular but for zero rows, {peer.name}", where, regular, f"condition {inertia.condition:.1e}")
    tally.condition(where.rsplit(",", 1)[0], inertia.condition)
    for c, (contact, answer) in enumerate(zip(contacts, got["contacts"], strict=True)):
        one_contact(peer, base, inertia, contact, answer, f"{where}, contact {c}", tally)


def one_contact(peer, base, inertia, contact, answer, where, tally):
    point, normal = peer.located(contact)
    off = max(np.abs(point - answer["point_world"]).max(), np.abs(normal - answer["normal_world"]).max())
    tally.within(f"point and normal, {peer.name}", where, off, PLACE)
    jacobian, size = peer.point_jacobian(contact["link"], point)
    if contact["against"]:
        # Row of the relative motion: a sum of the two sides' inverses would omit the cross terms.
        against, more = peer.point_jacobian(contact["against"], point)
        jacobian, size = jacobian - against, size + more
    row = normal @ jacobian
    off = np.abs(row - answer["row"]).max(initial=0.0)
    tally.within(f"j, {peer.name}", where, off / size.max() if off > 0 else 0.0, MATRIX)
    outcome = inertia.outcome(row, size)
    for route, ours in (("chosen", answer), ("dense", answer["dense"])):
        status = ours["status"]
        message = f"{status} ({ours['error']}), and not {outcome}"
        tally.check(f"status, {route} route, {peer.name}", where, status in outcome.statuses, message)
        if status == "finite" and "finite" in outcome.statuses:
            one_mass(ours, outcome, peer, route, where, tally)
    if len(outcome.statuses) == 1:
        tally.answers[peer.name, base, answer["status"]] += 1
    else:
        tally.undecided[peer.name, answer["status"]] += 1


def one_mass(ours, outcome, peer, route, where, tally):
    label = f"{route} route, {peer.name}"
    off = abs(ours["effective_mass"] / outcome.effective_mass - 1)
    bound = RECURSION + AMPLIFIED * outcome.magnified
    tally.within(f"m̄ by rounding's bound, {label}", where, off / bound, 1.0)
    if bound <= MASS:
        tally.within(f"m̄, {label}", where, off, MASS)
    claimed = ours["effective_mass_error"] / outcome.effective_mass
    tally.within(f"m̄ by its own bound, {label}", where, off / (claimed + peer.rounding * outcome.magnified), 1.0)


def nothing_was_skipped(ledger, tally):
    for base in ("fixed", "floating"):
        for status in STATUSES:
            count = tally.answers[pinocchio_peer.Peer.name, base, status]
            tally.check("every status occurs", f"{base}, {status}", count > 0, "never")
    for stem in ALWAYS_IN_MUJOCO:
        entries = [entry for name, entry in ledger.found.items() if Path(name).stem == stem]
        taken = bool(entries) and all(mujoco_peer.Peer.name not in entry.get("peers", {}) for entry in entries)
        tally.check("MuJoCo takes it", stem, taken, "it was not compared")


def summary(ledger):
    entries = ledger.found
    loaded = [name for name, entry in entries.items() if "diagnostics" in entry]
    print(f"{len(entries)} files, {len(loaded)} loaded; refused: {', '.join(entries.keys() - set(loaded)) or 'none'}")
    print(f"with accept {INDEFINITE}: {', '.join(name for name in loaded if 'accept' in entries[name]) or 'none'}")
    for peer in (pinocchio_peer.FoldingPeer.name, mujoco_peer.Peer.name):
        reasons = collections.Counter(e["peers"][peer] for e in entries.values() if peer in e.get("peers", {}))
        for reason, count in reasons.items():
            print(f"{peer} does not take {count}: {reason}")


if __name__ == "__main__":
    main()
