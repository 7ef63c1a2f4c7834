"""Proofs of `percuss mass --certify` and `percuss extremes --certify` against other programs: no value of m̄ lies outside.

Trees: URDFs of example-robot-data and shipped models, m̄ = 1/(j M⁻¹ jᵀ) from M and j of Pinocchio. Linkages: shipped models, m̄ from M and the
constraint rows of MuJoCo, closed here by Newton's method. The points are random, corners of the ranges, and iterates of an optimisation. At
one pose: m̄ in 90 digits (precision/mechanics.py), if mpmath is installed.

    certified_points.py PERCUSS [--points 1050000] [--only NAME...]
"""
import argparse
import itertools
import json
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
import zlib
from pathlib import Path

import numpy as np
import pinocchio as pin
import scipy.optimize

import loops
import pinocchio_peer
import urdf_file
from compare import ROBOTS

sys.path.append(str(Path(__file__).parent / "precision"))
MODELS = Path(__file__).parents[2] / "models"
TREES = ("double_pendulum", "leg", "physical_pendulum", "planar_2r", "point_mass_pendulum", "semi_trailing_arm", "shaped_arm", "six_r_arm")
# Linkage: driver, middle and half width of its range (rad, m), link with point and normal (world axes).
LINKAGES = {
    "four_bar": ("crank_hinge", 1.0, 0.3, "coupler", "0.35,0.1,0", "0,1,0"),
    "antiparallelogram": ("crank_hinge", 1.0, 0.2, "coupler", "0.1,0,0", "0,1,0"),
    "parallelogram": ("first_hinge", 1.0, 0.2, "platform", "0.1,0,0", "0,1,0"),
    "six_bar": (None, 0.0, 0.1, None, "0.05,0.02,0", "0,1,0"),
    "slider_crank": (None, 0.7, 0.2, None, "0.05,0.02,0", "1,0.5,0"),
    "double_wishbone": ("lower_arm_hinge", 0.0, 0.2, "wheel_centre", "0,0,0", "0,0,-1"),
}
ROUNDING = 1e-9  # relative: roundings of the other program, magnified by M
# Share of the points at which the other program has an answer.
MOST_ANSWERED = 0.99
QUESTIONS = 2  # of each tree


def percuss(program, *words):
    """Report in JSON; the message for a refused question."""
    run = subprocess.run([program, *words, "--format", "json"], capture_output=True, text=True, timeout=900)
    return json.loads(run.stdout) if run.returncode == 0 else run.stderr.strip()


def words(values):
    return ",".join(repr(float(x)) for x in values)


class Tree:
    """m̄ of a tree by Pinocchio at changed positions."""

    def __init__(self, path):
        self.robot = urdf_file.read(path)
        self.peer = pinocchio_peer.Peer(path, self.robot, False)
        self.masters = [joint for joint in self.robot.movable if self.robot.is_master(joint)]
        # Rotor inertias, which Pinocchio does not read.
        armature, self.has_rotors = np.zeros(self.peer.model.nv), False
        for joint in ElementTree.parse(path).getroot().findall("joint"):
            dynamics = joint.find("dynamics")
            if dynamics is not None and float(dynamics.get("armature", 0)) > 0:
                armature[self.peer.joints[joint.get("name")].idx_v] = float(dynamics.get("armature"))
                self.has_rotors = True
        self.peer.model.armature = armature

    def start(self, drawn, joints):
        size = {"planar": 3, "floating": 6}
        coordinates = [(j.name, k) for j in self.masters for k in range(size.get(j.kind, 1))]
        self.peer.pose(coordinates, self.robot.positions(drawn), None)
        followers = [(j.name, *self.robot.follows(j.name)) for j in self.robot.movable]
        self.moved = [
            [(self.peer.joints[name], times, offset) for name, master, times, offset in followers if master == joint] for joint in joints
        ]

    def mass(self, x, link, point, normal, is_world):
        peer = self.peer
        for value, moved in zip(x, self.moved):
            for joint, times, offset in moved:
                at = [times * value + offset]
                peer.q[joint.idx_q : joint.idx_q + joint.nq] = pinocchio_peer.layout(joint, at if joint.nq == 1 else at[0:1])
        mass, frame = peer.mass_matrix(), peer.frame(link)
        rows = pin.computeFrameJacobian(peer.model, peer.data, peer.q, frame, pin.LOCAL).reshape(6, -1) @ peer.t
        if is_world:
            pin.forwardKinematics(peer.model, peer.data, peer.q)
            pin.updateFramePlacement(peer.model, peer.data, frame)
            normal = peer.data.oMf[frame].rotation.T @ normal
        row = normal @ (rows[:3] - pinocchio_peer.skew(point) @ rows[3:])
        try:
            inverse = row @ np.linalg.solve(mass, row)
        except np.linalg.LinAlgError:  # a motion without energy
            return 0.0 if abs(row @ np.linalg.eigh(mass)[1][:, 0]) > 1e-9 else np.nan
        return 1 / inverse if inverse > 0 else np.inf


class Linkage(loops.Peer):
    """m̄ of a linkage by MuJoCo: the loops are closed from the pose of the question in steps of the driver."""

    def start(self, report, driver):
        for joint, values in report["pose"].items():
            address = self.model.joint(joint).qposadr[0]
            self.data.qpos[address : address + len(values)] = values
        self.driver = self.model.joint(driver)
        self.closed = [(report["pose"][driver][0], self.data.qpos.copy())]

    def rows(self):
        m, d = self.model, self.data
        loops.mujoco.mj_fwdPosition(m, d)
        equal = d.efc_type == loops.mujoco.mjtConstraint.mjCNSTR_EQUALITY
        return d.efc_J.reshape(d.nefc, m.nv)[equal], d.efc_pos[equal]

    def mass(self, x, link, point, normal, _):
        m, d = self.model, self.data
        start, d.qpos[:] = min(self.closed, key=lambda pair: abs(pair[0] - x[0]))
        others = np.arange(m.nv) != self.driver.dofadr[0]
        for value in np.linspace(start, x[0], int(abs(x[0] - start) / 0.05) + 2)[1:]:
            d.qpos[self.driver.qposadr[0]] = value
            for _ in range(8):
                rows, error = self.rows()
                move = np.zeros(m.nv)
                move[others] = np.linalg.lstsq(rows[:, others], -error, rcond=loops.RANK)[0]
                loops.mujoco.mj_integratePos(m, d.qpos, move, 1.0)
                if np.abs(move).max() < 1e-13:
                    break
        rows, error = self.rows()
        assert np.abs(error).max() < 1e-10, "not closed"
        if len(self.closed) < 100:
            self.closed.append((x[0], d.qpos.copy()))
        mass, jacobian, body = np.zeros((m.nv, m.nv)), np.zeros((3, m.nv)), m.body(link).id
        loops.mujoco.mj_fullM(m, d, mass)
        loops.mujoco.mj_jac(m, d, jacobian, None, d.xpos[body] + d.xmat[body].reshape(3, 3) @ point, body)
        return loops.least_energy(mass, rows, normal @ jacobian)


class Tally:
    def __init__(self):
        self.points = self.proofs = self.sharp = self.outside = self.unanswered = self.poses = self.planted = 0
        self.failures, self.reasons, self.models, self.widest = [], {}, set(), 0.0

    def without(self, name, why):
        self.reasons.setdefault(why.splitlines()[-1][:110], []).append(name)

    def check(self, is_right, message):
        if not is_right:
            self.outside += 1
            self.failures.append(message)


def check_brackets(tally, name, report, count, bounds, value, rng):
    """Random points, corners and iterates of an optimisation in the unit box of `bounds` (joints, then edges and cone)."""
    proof = report["certificate"]
    least, most = proof["least"], proof["most"]
    for bracket in (least, most):
        bracket.pop("divisions")
    low = (least["lower"] or 0.0) * (1 - ROUNDING)
    high = (most["upper"] or np.inf) * (1 + ROUNDING)
    n, counted = len(bounds), 0

    def at(part):
        nonlocal counted
        m = value(bounds[:, 0] + np.clip(part, 0, 1) * (bounds[:, 1] - bounds[:, 0]))
        counted += 1
        if np.isnan(m):
            tally.unanswered += 1
        else:
            tally.check(low <= m <= high, f"{name}: {m!r} outside {least} {most}")
        return m

    corners = list(itertools.islice(itertools.product((0.0, 1.0), repeat=n), 256))
    values = [at(np.array(corner)) for corner in corners]
    for side in (1, -1):
        for start in range(2):
            part = np.array(corners[int(np.argmin(np.multiply(side, values)))]) if start == 0 else rng.uniform(0, 1, n)
            def objective(part):
                m = at(part)
                return side * np.log(m) if np.isfinite(m) and m > 0 else 0.0
            scipy.optimize.minimize(objective, part, method="L-BFGS-B", bounds=[(0, 1)] * n, options={"maxfun": 60 * (n + 1)})
    while counted < count:
        at(rng.uniform(0, 1, n))
    # The best positions have at least, or at most, the inner bound.
    for bracket, end, sign in ((most, "lower", 1), (least, "upper", -1)):
        if bracket[end] is not None:
            m = value(np.array(bracket["positions"]))
            tally.check(sign * m >= sign * bracket[end] * (1 - sign * ROUNDING), f"{name}: {m!r} at {bracket}")
    tally.points += counted
    tally.proofs += 1
    tally.sharp += most["is_proved"] and least["is_proved"]
    tally.models.add(name)


def around(normal, psi, theta):
    """Normal turned by θ about the first tangent e₁, then by ψ about the given normal."""
    e1 = np.eye(3)[(int(np.argmax(np.abs(normal))) + 1) % 3]
    e1 = e1 - normal * (normal @ e1)
    e1 /= np.linalg.norm(e1)
    # A turn by θ about e₁ moves the normal towards −e₂ = e₁ × n.
    e2 = np.cross(normal, e1)
    return np.cos(theta) * normal + np.sin(theta) * (np.sin(psi) * e1 - np.cos(psi) * e2)


def one_tree(program, path, tally, points):
    name = path.stem
    try:
        tree = Tree(path)
    except urdf_file.Refused as refusal:
        return tally.without(name, f"Pinocchio: {refusal}")
    for number in range(QUESTIONS):
        rng = np.random.default_rng([57, number, zlib.crc32(str(path.name).encode())])
        drawn = {j.name: j.draw(rng) for j in tree.masters}
        links = [link for link in tree.robot.links if any(j.kind in urdf_file.ONE_VALUE for j in tree.robot.chain(link))]
        if not links:
            return tally.without(name, "no link moves")
        link = links[rng.integers(len(links))]
        chain = [tree.robot.follows(j.name)[0] for j in tree.robot.chain(link) if j.kind in urdf_file.ONE_VALUE]
        joints = list(dict.fromkeys(chain))[: int(rng.integers(1, 5))]
        is_world, has_patch = bool(rng.integers(2)), number == 1
        point, normal = rng.uniform(-0.2, 0.2, 3), urdf_file.unit(rng)
        ranges = np.array([[drawn[j][0] - half, drawn[j][0] + half] for j in joints for half in [rng.uniform(0.02, 0.2)]])
        contact = ["--link", link, f"--point={words(point)}", f"--normal={words(normal)}", "--normal-frame", "world" if is_world else "link"]
        contact += ["--accept", "indefinite-inertia"]
        held = [f"--set={j.name}={words(drawn[j.name])}" for j in tree.masters if j.name not in joints]
        question = [f"--range={j}={a!r}:{b!r}" for j, (a, b) in zip(joints, ranges.tolist())]
        edge, cone = rng.uniform(-0.05, 0.05, 3), 0.0
        if has_patch:
            cone = 0.1
            question += [f"--edge={words(edge)}", "--normals", "cone:0.1rad"]
        report = percuss(program, "extremes", str(path), *contact, *held, *question, "--certify", "5%", "--boxes", "1000", "--starts", "1")
        if isinstance(report, str):
            tally.without(name, report)
            continue
        tree.start(drawn, joints)
        one_pose(program, path, tally, tree, drawn, link, point, normal, is_world, contact)
        if report["certificate"]["reason"]:
            tally.without(name, report["certificate"]["reason"])
            continue
        bounds, n = ranges, len(joints)
        if has_patch:
            bounds = np.vstack([ranges, [0, np.linalg.norm(edge)], [-np.pi, np.pi], [0, cone]])

        def value(x):
            if not has_patch:
                return tree.mass(x, link, point, normal, is_world)
            at = point + edge / np.linalg.norm(edge) * x[n]
            sign = -1 if is_world else 1  # a normal of the world is turned against the bodies
            return tree.mass(x[:n], link, at, around(normal, sign * x[n + 1], sign * x[n + 2]), is_world)

        check_brackets(tally, name, report, points, bounds, value, rng)


def one_pose(program, path, tally, tree, drawn, link, point, normal, is_world, contact):
    """m̄ in 90 digits is in the proved bounds; a mass that is wrong by 1e-12 is not, if the bounds are that narrow."""
    try:
        import icub
        from mechanics import Mechanism, Position, by_recursion
        from mpmath import mpf

        rows, links, moving = icub.rows_of(path)
    except (ImportError, AssertionError, KeyError):
        return
    if tree.has_rotors or any(body and float(body[0]) == 0 and any(map(float, body[2].split())) for body in rows["links"]):
        return  # mechanics.py has no moments without mass, and no rotors
    held = [f"--set={j.name}={words(drawn[j.name])}" for j in tree.masters]
    report = percuss(program, "mass", str(path), *contact, *held, "--certify")
    if isinstance(report, str) or report["certificate"]["reason"]:
        return tally.without(path.stem, report if isinstance(report, str) else report["certificate"]["reason"])
    exact = [" ".join(repr(float(x)) for x in v) for v in (point, normal)]
    asked = {"on": links.index(link), "against": None, "point": exact[0], "normal": exact[1], "world": is_world, "toward": None}
    truth = by_recursion(Position(Mechanism(rows), {moving[j]: mpf(q[0]) for j, q in drawn.items()}), [asked])[0]
    lower, upper = report["certificate"]["lower"], report["certificate"]["upper"]
    tally.check(truth is not None and lower <= truth <= upper, f"{path.stem}: {truth} outside {lower} {upper}")
    tally.poses += 1
    tally.widest = max(tally.widest, upper / lower - 1)
    tally.planted += upper < truth * (1 + mpf("1e-12")) and truth * (1 - mpf("1e-12")) < lower


def one_linkage(program, name, tally, points):
    driver, middle, half, link, point, normal = LINKAGES[name]
    path = str(MODELS / f"{name}.urdf")
    check = percuss(program, "check", path)
    driver = driver or check["drivers"][0]
    peer = Linkage(path)
    link = link or [l["name"] for l in check["links"] if l["mass"] > 0 and l["name"] in peer.links][-1]
    contact = ["--link", link, f"--point={point}", f"--normal={normal}", "--normal-frame", "world"]
    report = percuss(program, "extremes", path, *contact, f"--range={driver}={middle - half!r}:{middle + half!r}", "--certify", "2%")
    start = percuss(program, "mass", path, *contact, f"--set={driver}={middle!r}", "--certify")
    for found in (report, start):
        if isinstance(found, str) or found["certificate"]["reason"]:
            return tally.without(name, found if isinstance(found, str) else found["certificate"]["reason"])
    peer.start(start, driver)
    point, normal = (np.array([float(x) for x in v.split(",")]) for v in (point, normal))
    normal /= np.linalg.norm(normal)
    rng = np.random.default_rng(57)
    bounds = np.array([[middle - half, middle + half]])
    value = lambda x: peer.mass(x, link, point, normal, True)
    m, proof = value([middle]), start["certificate"]
    tally.check(proof["lower"] * (1 - ROUNDING) <= m <= proof["upper"] * (1 + ROUNDING), f"{name}: {m!r} outside {proof}")
    check_brackets(tally, name, report, points, bounds, value, rng)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("percuss")
    parser.add_argument("--points", type=int, default=1_050_000)
    parser.add_argument("--only", nargs="*", default=[])
    options = parser.parse_args()
    wanted = lambda name: not options.only or any(part in name for part in options.only)
    paths = [path for path in sorted(ROBOTS.rglob("*.urdf")) + [MODELS / f"{name}.urdf" for name in TREES] if wanted(str(path))]
    linkages = [name for name in LINKAGES if wanted(name)]
    tally, each = Tally(), options.points // max(QUESTIONS * len(paths) + len(linkages), 1) + 1
    for path in paths:
        one_tree(options.percuss, path, tally, each)
        print(f"{path.stem}: {tally.proofs} proofs, {tally.points} points, {tally.outside} outside", file=sys.stderr, flush=True)
    for name in linkages:
        one_linkage(options.percuss, name, tally, each)
    for why, names in tally.reasons.items():
        print(f"no proof compared ({len(names)}): {why}: {', '.join(sorted(set(names)))}")
    print(f"{tally.poses} poses in 90 digits, relative width at most {tally.widest:.0e}; an error of 1e-12 is outside at {tally.planted}")
    print(f"{tally.proofs} proofs ({tally.sharp} within their tolerance) of {len(tally.models)} models, {tally.points} points, {tally.outside} outside")
    print("\n".join(tally.failures[:20]))
    answered = tally.points - tally.unanswered
    print(f"{answered + tally.poses - tally.outside} passed, {tally.outside} failed; no answer of the other program at {tally.unanswered} points")
    compared = len(tally.models) + sum(len(set(names)) for names in tally.reasons.values())
    sys.exit(bool(tally.outside) or answered < MOST_ANSWERED * tally.points or 2 * len(tally.models) <= compared)


if __name__ == "__main__":
    main()
