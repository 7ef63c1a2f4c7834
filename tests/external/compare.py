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
from reference import Inertia
from tally import Tally

HERE = Path(__file__).resolve().parent
ROBOTS = Path(sysconfig.get_paths()["purelib"]) / "cmeel.prefix/share/example-robot-data/robots"
OURS = HERE / "robots"
FILES = 69
SEED = 20261121

MATRIX = 1e-10  # relative Frobenius
MASS = 1e-9  # relative
PLACE = 1e-12  # relative: points, normals, positions
IN_MUJOCO = ()
EXPECTED = ("finite", "immovable", "massless")


def ask(probe, **request):
    run = subprocess.run([probe], input=json.dumps(request), capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(f"the probe failed on {request['model']}: {run.stderr.strip()}")
    return json.loads(run.stdout)


def relative(got, wanted):
    """Of matrices or vectors, by the norm of what is wanted."""
    got, wanted = np.asarray(got, float), np.asarray(wanted, float)
    if got.shape != wanted.shape:
        return np.inf
    size = np.linalg.norm(wanted)
    return np.linalg.norm(got - wanted) / size if size > 0 else float(np.linalg.norm(got) > 0)


def load(probe, path, entry, tally, name):
    """Loads a file as the ledger says, and compares what is said of it. True where a mechanism comes of it."""
    plain = ask(probe, model=str(path))
    found = {"diagnostics": counted(plain)}
    accept = False
    if not plain["loaded"]:
        codes = {d["code"] for d in plain["diagnostics"] if d["severity"] == "error"}
        found = {"refused": counted(plain)}
        accept = codes == {"indefinite-inertia"}
        if accept:
            accepted = ask(probe, model=str(path), accept_indefinite_inertia=True)
            found |= {"accept": ["indefinite-inertia"], "diagnostics": counted(accepted)}
            tally.check("loads when accepted", name, accepted["loaded"])
    tally.check("diagnostics as in the ledger", name, found == entry, f"{found} and not {entry}")
    return found


def counted(answer):
    return dict(sorted(collections.Counter(f"{d['severity']} {d['code']}" for d in answer["diagnostics"]).items()))


def compare(probe, path, name, floating, accept, options, tally):
    """One file on one base."""
    robot = urdf_file.read(path)
    label = f"{name}, {'floating' if floating else 'fixed'}"
    rng = np.random.default_rng([SEED, zlib.crc32(name.encode()), floating])
    asked = questions.configurations(robot, floating, options.configurations, 5, rng)
    base = "floating" if floating else "fixed"
    answer = ask(probe, model=str(path), accept_indefinite_inertia=accept, base=base, configurations=asked)
    coordinates = [tuple(c) for c in answer["coordinates"]]
    peer = pinocchio_peer.Peer(path, robot, floating)
    folding = None
    if any(j.mimic for j in robot.movable):
        try:
            folding = pinocchio_peer.Peer(path, robot, floating, fold=True)
        except pinocchio_peer.Refused as refusal:
            tally.refused_mimic[name] = str(refusal).strip()
    mujoco = mujoco_peer.Peer(path, robot, floating) if Path(name).stem in IN_MUJOCO else None
    for k, (wanted, got) in enumerate(zip(asked, answer["configurations"], strict=True)):
        where = f"{label}, configuration {k}"
        positions = robot.positions(wanted["joints"])
        off = [relative(got["pose"].get(j, []), p) if np.any(p) else np.abs(got["pose"][j]).max() for j, p in positions.items()]
        tally.within("pose, mimics included", where, max(off, default=0.0), PLACE)
        m = np.array(got["mass_matrix"]).reshape(len(coordinates), len(coordinates))
        peer.pose(coordinates, positions, wanted["base"])
        inertia = Inertia(peer.mass_matrix())
        tally.condition(label, inertia.condition)
        tally.within("M, Pinocchio", where, relative(m, peer.mass_matrix()), MATRIX)
        if folding:
            folding.pose(coordinates, positions, wanted["base"])
            tally.within("M, Pinocchio folding mimics", where, relative(m, folding.mass_matrix()), MATRIX)
        contacts(peer, inertia, wanted, got, where, MASS, tally)
        if mujoco:
            mujoco.pose(coordinates, positions, wanted["base"])
            theirs = mujoco.mass_matrix()
            tally.within("M, MuJoCo", where, relative(m, theirs), MATRIX)
            contacts(mujoco, Inertia(theirs), wanted, got, where, MASS, tally)


def contacts(peer, inertia, wanted, got, where, tolerance, tally):
    """Every contact of a configuration, against one peer."""
    for c, (contact, answer) in enumerate(zip(wanted["contacts"], got["contacts"], strict=True)):
        here = f"{where}, contact {c}"
        point, normal = peer.located(contact)
        tally.within(f"contact in the world, {peer.name}", here, max(relative(answer["point_world"], point), relative(answer["normal_world"], normal)), PLACE)
        on, size = peer.point_jacobian(contact["link"], point)
        if contact["against"]:
            against, more = peer.point_jacobian(contact["against"], point)
            on, size = on - against, size + more
        row = normal @ on
        off = np.abs(np.array(answer["row"]) - row).max(initial=0.0)
        tally.within(f"j, {peer.name}", here, off / size.max() if off > 0 else 0.0, MATRIX)
        outcome = inertia.outcome(row, size)
        for route in ("chosen", "dense"):
            ours = answer if route == "chosen" else answer["dense"]
            same = ours["status"] == outcome.status
            tally.check(f"status, {peer.name}, {route} route", here, same, f"{ours['status']} and not {outcome} ({ours['error']})")
            if same and outcome.status == "finite":
                off = abs(ours["effective_mass"] / outcome.effective_mass - 1)
                tally.within(f"m̄, {peer.name}, {route} route", here, off, max(tolerance, 1e-14*inertia.condition), inertia.condition)
        tally.status(peer.name, answer["status"], answer["route"])


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--probe", required=True)
    parser.add_argument("--only", default="", help="files whose path contains this")
    parser.add_argument("--configurations", type=int, default=20)
    parser.add_argument("--update-ledger", action="store_true")
    options = parser.parse_args()
    start = time.monotonic()
    tally, ledger_path = Tally(), HERE / "ledger.json"
    ledger = json.loads(ledger_path.read_text()) if ledger_path.exists() else {}
    paths = {str(p.relative_to(ROBOTS)): p for p in sorted(ROBOTS.rglob("*.urdf"))}
    tally.check("all files there", "example-robot-data", len(paths) == FILES, f"{len(paths)} files and not {FILES}")
    found = {}
    for name, path in paths.items():
        if options.only not in name:
            continue
        entry = ledger.get(name)
        found[name] = load(options.probe, path, entry, tally, name)
        accept = "accept" in (found if options.update_ledger else ledger).get(name, {})
        if "diagnostics" in found[name] and accept == ("accept" in found[name]):
            for floating in (False, True):
                compare(options.probe, path, name, floating, accept, options, tally)
    if options.update_ledger and not options.only:
        ledger_path.write_text(json.dumps(found, indent=2) + "\n")
    tally.report(time.monotonic() - start)


if __name__ == "__main__":
    main()
