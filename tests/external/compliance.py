"""Mechanisms with bushes and elastic gears compared with an independent program, and with Exudyn where it is installed.

    compliance.py --percuss PATH [--count N] [--seed S] [--exudyn]            prints `N passed, N failed`

N random mechanisms as URDF+ with `<bushing>`: trees of two to five links on revolute, prismatic, ball and fixed joints, some with loops of ball joints;
bushes in place of joints and loops, with random axes, three rates each, dampers or loss factors, torsional rates, springs of joints, and gears, given
by `<elastic>` or by a flag. The program here
shares no code and no method with percuss: six coordinates for each link, ideal joints as rows, a null space by numpy. Compared are free and rigid mass, residual
compliance with its shares, natural frequencies with participations, the receptance, and impacts without damping: exact by the modes
of the mechanism on the spring of the contact.

--exudyn: frequencies of five mechanisms by Exudyn, with rigid bodies, generic joints and spring-dampers of its own.
"""

import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from scipy.linalg import eigh, null_space, solve_triangular
from scipy.optimize import brentq, minimize_scalar

# Limits and residual compliance; frequencies; receptance; impacts. Both programs solve systems of condition up to 1e5 in double precision.
LIMITS, FREQUENCY, RECEPTANCE, IMPACT = 1e-10, 1e-9, 1e-8, 1e-8
# Largest forces of bushes and ideal joints, of the largest one.
ELEMENT = 1e-6
# Exudyn has unit quaternions and a numerical Jacobian of its constraints.
EXUDYN = 1e-7
AXES = np.eye(3)


def cross(v):
    return np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def rotation(rng):
    q, r = np.linalg.qr(rng.normal(size=(3, 3)))
    q = q @ np.diag(np.sign(np.diag(r)))
    return q * np.linalg.det(q)


def rpy(r):
    return np.arctan2(r[2, 1], r[2, 2]), -np.arcsin(r[2, 0]), np.arctan2(r[1, 0], r[0, 0])


def text(values):
    return " ".join(repr(float(x)) for x in values)


class Case:
    """Random mechanism: all frames are parallel to the world with the joints at zero; positions in the world."""

    def __init__(self, rng, plain=False):
        self.rng, self.links, self.joints, self.loops, self.bushes, self.worst = rng, [], [], [], [], {}
        for i in range(rng.integers(2, 6)):
            parent = -1 if i == 0 else int(rng.integers(-1, i))
            at = rng.normal(size=3) * 0.4
            half = rng.uniform(0.05, 0.4, size=3)
            mass = rng.uniform(0.5, 20)
            turn = rotation(rng)
            inertia = turn @ np.diag(mass / 3 * np.array([half[1] ** 2 + half[2] ** 2, half[0] ** 2 + half[2] ** 2, half[0] ** 2 + half[1] ** 2])) @ turn.T
            self.links.append({"mass": mass, "com": at + rng.normal(size=3) * 0.2, "inertia": inertia, "origin": at})
            kind = rng.choice(["revolute", "revolute", "prismatic", "spherical", "fixed"])
            axis = rng.normal(size=3)
            joint = {"kind": kind, "parent": parent, "child": i, "at": at, "axis": axis / np.linalg.norm(axis)}
            joint["bush"] = bool(rng.random() < 0.6 or kind == "fixed")
            joint["gear"] = None
            if not joint["bush"] and kind == "revolute" and rng.random() < 0.5 and not plain:
                joint["gear"] = (rng.uniform(0.05, 1), 10 ** rng.uniform(2, 5), rng.uniform(0, 2))
            joint["spring"] = None
            if not joint["bush"] and kind in ("revolute", "prismatic") and rng.random() < 0.6 and not plain:
                joint["spring"] = (10 ** rng.uniform(1, 4), rng.uniform(0, 5))
            self.joints.append(joint)
        if len(self.links) > 2 and rng.random() < 0.5:
            at = rng.normal(size=3) * 0.4
            self.loops.append({"links": (len(self.links) - 1, -1), "at": at, "bush": bool(rng.random() < 0.7)})
        for joint in self.joints + self.loops:
            if joint["bush"]:
                self.add_bush(joint, plain)
        self.link = int(rng.integers(0, len(self.links)))
        self.point = rng.normal(size=3) * 0.4
        normal = rng.normal(size=3)
        self.normal = normal / np.linalg.norm(normal)

    def add_bush(self, joint, plain):
        rng = self.rng
        kind = joint.get("kind", "spherical")
        frame = rotation(rng)
        if kind in ("revolute", "prismatic"):
            x = np.cross(joint["axis"], rng.normal(size=3))
            x /= np.linalg.norm(x)
            frame = np.column_stack([x, np.cross(joint["axis"], x), joint["axis"]])
        rigid = {"revolute": [1, 1, 0, 1, 1, 1], "prismatic": [1, 1, 1, 1, 1, 0], "spherical": [0, 0, 0, 1, 1, 1], "fixed": [1] * 6}[kind]
        stiffness = np.concatenate([10 ** rng.uniform(2, 4, 3), 10 ** rng.uniform(5, 7, 3)])
        soft = np.array(rigid) == 0
        if rng.random() < 0.5:
            stiffness[soft] *= 0.01
        else:
            stiffness[soft] = 0
        damping = stiffness * 10 ** rng.uniform(-4, -3) * (0 if plain or rng.random() < 0.5 else 1)
        loss = 0 if plain or rng.random() < 0.5 else rng.uniform(0.05, 0.2)
        links = joint["links"] if "links" in joint else (joint["child"], joint["parent"])
        self.bushes.append({"links": links, "at": joint["at"], "frame": frame, "k": stiffness, "c": damping, "loss": loss, "rigid": rigid})

    def urdf(self):
        name = lambda i: "base" if i < 0 else f"l{i}"
        origin = lambda i: np.zeros(3) if i < 0 else self.links[i]["origin"]
        out = ["<robot name='case'>", "<link name='base'/>"]
        for i, link in enumerate(self.links):
            m = link["inertia"]
            entries = " ".join(f"{key}='{m[a, b]!r}'".replace("np.float64(", "").replace(")", "") for key, a, b in
                               (("ixx", 0, 0), ("ixy", 0, 1), ("ixz", 0, 2), ("iyy", 1, 1), ("iyz", 1, 2), ("izz", 2, 2)))
            out.append(f"<link name='{name(i)}'><inertial><origin xyz='{text(link['com'] - link['origin'])}'/><mass value='{float(link['mass'])!r}'/>"
                       f"<inertia {entries}/></inertial></link>")
        for i, joint in enumerate(self.joints):
            kind = {"revolute": "continuous"}.get(joint["kind"], joint["kind"])
            rotor = f" armature='{float(joint['gear'][0])!r}'" if joint["gear"] else ""
            spring = f" spring_stiffness='{float(joint['spring'][0])!r}' damping='{float(joint['spring'][1])!r}'" if joint["spring"] else ""
            gear = f"<dynamics{rotor}{spring}/>" if rotor or spring else ""
            limit = "<limit lower='-1' upper='1' effort='0' velocity='0'/>" if kind == "prismatic" else ""
            axis = f"<axis xyz='{text(joint['axis'])}'/>" if kind in ("continuous", "prismatic") else ""
            out.append(f"<joint name='j{i}' type='{kind}'><origin xyz='{text(joint['at'] - origin(joint['parent']))}'/><parent link='{name(joint['parent'])}'/>"
                       f"<child link='{name(joint['child'])}'/>{axis}{limit}{gear}</joint>")
            if joint["gear"] and i % 2:
                out.append(f"<elastic joint='j{i}' stiffness='{float(joint['gear'][1])!r}' damping='{float(joint['gear'][2])!r}'/>")
        for i, loop in enumerate(self.loops):
            a, b = loop["links"]
            out.append(f"<loop name='c{i}' type='spherical'><predecessor link='{name(a)}'><origin xyz='{text(loop['at'] - origin(a))}'/></predecessor>"
                       f"<successor link='{name(b)}'><origin xyz='{text(loop['at'] - origin(b))}'/></successor></loop>")
        names = [f"j{i}" for i, joint in enumerate(self.joints) if joint["bush"]] + [f"c{i}" for i, loop in enumerate(self.loops) if loop["bush"]]
        for bush, joint in zip(self.bushes, names):
            a, b = bush["links"]
            rows = lambda values: f"xyz='{text(values[3:])}' rpy='{text(values[:3])}'"
            out.append(f"<bushing name='b_{joint}' parent='{name(a)}' child='{name(b)}'><origin xyz='{text(bush['at'] - origin(a))}' rpy='{text(rpy(bush['frame']))}'/>"
                       f"<stiffness {rows(bush['k'])} loss_factor='{float(bush['loss'])!r}'/><damping {rows(bush['c'])}/><rigid {rows(bush['rigid'])}/><joint name='{joint}'/></bushing>")
        return "\n".join(out + ["</robot>"])

    def rows(self, links, at, frame):
        """Rotation and translation of the first link relative to the second at a point, along the axes of a frame."""
        out = np.zeros((6, self.size()))
        for sign, i in ((1, links[0]), (-1, links[1])):
            if i >= 0:
                arm = at - self.links[i]["com"]
                out[:3, 6 * i:6 * i + 3] += sign * frame.T
                out[3:, 6 * i:6 * i + 3] += sign * frame.T @ -cross(arm)
                out[3:, 6 * i + 3:6 * i + 6] += sign * frame.T
        return out

    def size(self):
        return 6 * len(self.links) + sum(joint["gear"] is not None for joint in self.joints)

    def matrices(self):
        n = self.size()
        mass = np.zeros((n, n))
        for i, link in enumerate(self.links):
            mass[6 * i:6 * i + 3, 6 * i:6 * i + 3] = link["inertia"]
            mass[6 * i + 3:6 * i + 6, 6 * i + 3:6 * i + 6] = link["mass"] * np.eye(3)
        ideal, elastic, labels, rotor = [], [], [], 6 * len(self.links)
        for number, joint in enumerate(self.joints):
            if joint["bush"]:
                continue
            z = joint["axis"]
            x = np.cross(z, [0.3, -0.5, 0.8])
            x /= np.linalg.norm(x)
            rows = self.rows((joint["child"], joint["parent"]), joint["at"], np.column_stack([x, np.cross(z, x), z]))
            held = {"revolute": [0, 1, 3, 4, 5], "prismatic": [0, 1, 2, 3, 4], "spherical": [3, 4, 5], "fixed": range(6)}[joint["kind"]]
            ideal += [rows[r] for r in held]
            labels += [f"j{number}" if r > 2 else "" for r in held]
            if joint["spring"]:
                elastic.append((rows[2 if joint["kind"] == "revolute" else 5], *joint["spring"], 0.0, False))
            if joint["gear"]:
                inertia, k, c = joint["gear"]
                mass[rotor, rotor] = inertia
                twist = rows[2].copy()
                twist[rotor] = -1
                elastic.append((twist, k, c, 0.0, True))
                rotor += 1
        for number, loop in enumerate(self.loops):
            if not loop["bush"]:
                ideal += list(self.rows(loop["links"], loop["at"], AXES)[3:])
                labels += [f"c{number}"] * 3
        for bush in self.bushes:
            rows = self.rows(bush["links"], bush["at"], bush["frame"])
            elastic += [(row, k, c, bush["loss"], bool(r)) for row, k, c, r in zip(rows, bush["k"], bush["c"], bush["rigid"]) if k > 0]
        ideal = np.array(ideal).reshape(-1, n)
        self.full = (mass, ideal, labels)
        j = np.zeros(n)
        arm = self.point - self.links[self.link]["com"]
        j[6 * self.link:6 * self.link + 3] = np.cross(arm, self.normal)
        j[6 * self.link + 3:6 * self.link + 6] = self.normal
        basis = null_space(ideal, rcond=1e-12) if len(ideal) else np.eye(n)
        self.maximal = (j, elastic, basis)
        return basis.T @ mass @ basis, j @ basis, [(row @ basis, k, c, eta, r) for row, k, c, eta, r in elastic]

    def answer(self, omegas, stiffnesses):
        mass, j, elastic = self.matrices()
        total = lambda f: sum((f(e) * np.outer(e[0], e[0]) for e in elastic), np.zeros_like(mass))
        k = total(lambda e: e[1])
        least = lambda m, j: 1 / (j @ np.linalg.solve(m, j))
        out = {"free": least(mass, j)}
        held = np.array([e[0] for e in elastic if e[4]]).reshape(-1, len(j))
        rigid = null_space(held, rcond=1e-11) if len(held) else np.eye(len(j))
        jr = j @ rigid
        if np.linalg.norm(jr) > 1e-9 * np.linalg.norm(j):
            mr = rigid.T @ mass @ rigid
            out["rigid"] = least(mr, jr)
            motion = rigid @ np.linalg.solve(mr, jr) * out["rigid"]
            force = j - mass @ motion / out["rigid"]
        else:
            out["rigid"], motion, force = None, None, j
        # In the space of the rows, by the roots of the stiffness: the condition is the root of that of the stiffness.
        sizes, across = np.linalg.svd(held / np.linalg.norm(held, axis=1, keepdims=True))[1:] if len(held) else (np.zeros(0), np.eye(len(j)))
        across = across[: int((sizes > 1e-9).sum())].T
        applied = across.T @ force
        roots = np.sqrt([e[1] for e in elastic if e[4]])
        triangle = np.linalg.qr(roots[:, None] * (held @ across), mode="r")
        out["compliance"] = np.sum(solve_triangular(triangle.T, applied, lower=True) ** 2) if across.size else 0.0
        squares, modes = eigh(k, mass)
        out["frequencies"] = np.sqrt(np.clip(squares, 0, None)) / (2 * np.pi)
        out["participation"] = (j @ modes) ** 2
        c, lossy = total(lambda e: e[2]), total(lambda e: e[1] * e[3])
        out["h"] = [j @ np.linalg.solve(k + 1j * (w * c + lossy) - w * w * mass, j) for w in omegas]
        out["impacts"] = []
        for stiffness in stiffnesses if motion is not None else []:
            # Elastic bushes alone, without dampers: exact by modes.
            s, v = eigh(k + stiffness * np.outer(j, j), mass)
            w = np.sqrt(np.clip(s, 0, None))
            amplitude = (j @ v) * (v.T @ mass @ motion)
            moving = w > 1e-6 * w.max()
            x = lambda t: amplitude[moving] @ (np.sin(w[moving] * t) / w[moving]) + amplitude[~moving].sum() * t
            speed = lambda t: amplitude[moving] @ np.cos(w[moving] * t) + amplitude[~moving].sum()
            step = 0.02 / w.max()
            long = 40 * np.pi * np.sqrt(out["rigid"] / stiffness)
            if long / step > 400_000:
                out["impacts"].append(None)
                continue
            times = np.arange(1, int(long / step)) * step
            values = np.zeros_like(times)
            for a, b in zip(amplitude[moving], w[moving]):
                values += a * np.sin(b * times) / b
            values += amplitude[~moving].sum() * times
            below = np.nonzero(values <= 0)[0]
            if not len(below):
                out["impacts"].append(None)
                continue
            first = below[0]
            end = brentq(x, times[first - 1], times[first], xtol=1e-16, rtol=1e-14)
            top = np.argmax(values[:first])
            peak = brentq(speed, times[max(top - 1, 0)], times[top + 1], xtol=1e-16, rtol=1e-14)
            impulse = stiffness * (amplitude[moving] @ ((1 - np.cos(w[moving] * end)) / w[moving] ** 2) + amplitude[~moving].sum() * end**2 / 2)
            e = -speed(end)
            out["impacts"].append({"e": e, "duration": end, "force_mass": stiffness * x(peak) ** 2, "impulse_mass": impulse / (1 + e)})
        return out


    def bearings(self, stiffness):
        """Largest forces of bushes and ideal joints in an impact without damping: maximal coordinates, forces of the rows by least squares, extrema of
        the sum of the modes."""
        mass, j, elastic = self.matrices()
        whole_mass, ideal, labels = self.full
        j6, elastic6, basis = self.maximal
        rigid = null_space(np.array([e[0] for e in elastic if e[4]]), rcond=1e-11)
        jr, mr = j @ rigid, rigid.T @ mass @ rigid
        start = rigid @ np.linalg.solve(mr, jr) / (jr @ np.linalg.solve(mr, jr))
        k = sum(e[1] * np.outer(e[0], e[0]) for e in elastic)
        s, v = eigh(k + stiffness * np.outer(j, j), mass)
        w = np.sqrt(np.clip(s, 0, None))
        amplitude = v.T @ mass @ start
        moving = w > 1e-6 * w.max()
        # Forces per mode, whose wave is sin(w t)/w, or t without stiffness.
        z, squares = v * amplitude, np.where(moving, s, 0)
        u = basis @ z
        supplied = -whole_mass @ u * squares + np.outer(j6, stiffness * (j6 @ u))
        supplied += sum(np.outer(e[0], e[1] * (e[0] @ u)) for e in elastic6)
        forces = np.linalg.lstsq(ideal.T, supplied, rcond=None)[0] if len(ideal) else np.zeros((0, len(w)))
        largest = np.where(moving, 1 / np.where(moving, w, 1), self.end)
        assert np.linalg.norm((ideal.T @ forces - supplied) * largest) <= 1e-9 * np.linalg.norm(whole_mass @ u * squares * largest)
        parts = {name: forces[[label == name for label in labels]] for name in sorted(set(labels) - {""})}
        names = [f"j{i}" for i, joint in enumerate(self.joints) if joint["bush"]] + [f"c{i}" for i, loop in enumerate(self.loops) if loop["bush"]]
        for bush, name in zip(self.bushes, names):
            rows = self.rows(bush["links"], bush["at"], bush["frame"])[3:]
            parts[f"b_{name}"] = bush["k"][3:, None] * (rows @ u)
        count = int(np.clip(20 * w.max() * self.end, 4000, 400_000))
        times = np.linspace(0, self.end, count)

        def wave(t):
            t = np.atleast_1d(t)
            return np.where(moving[:, None], np.sin(np.outer(w, t)) / np.where(moving, w, 1)[:, None], t)

        whole = wave(times)
        peaks = {}
        for name, part in parts.items():
            size = lambda t: np.linalg.norm(part @ wave(t), axis=0)
            values = np.linalg.norm(part @ whole, axis=0)
            inner = np.nonzero((values[1:-1] >= values[:-2]) & (values[1:-1] >= values[2:]))[0] + 1
            best = max(values[0], values[-1])
            for k in inner[values[inner] > 0.999 * values.max()][:200]:
                found = minimize_scalar(lambda t: -size(t)[0], bounds=(times[k - 1], times[k + 1]), method="bounded", options={"xatol": 1e-9 * (times[1] - times[0])})
                best = max(best, -found.fun, values[k])
            peaks[name] = best
        return peaks


def run(percuss, words):
    found = subprocess.run([percuss, *words, "--format", "json"], capture_output=True, text=True)
    return json.loads(found.stdout) if found.stdout.startswith("{") else found.stderr


def compare(percuss, case, folder):
    """Differences beyond the tolerances."""
    path = folder / "case.urdf"
    path.write_text(case.urdf())
    origin = case.links[case.link]["origin"]
    contact = [str(path), "--link", f"l{case.link}", f"--point={','.join(text([x]) for x in case.point - origin)}",
               f"--normal={','.join(text([x]) for x in case.normal)}"]
    for i, joint in enumerate(case.joints):
        if joint["gear"] and i % 2 == 0:
            contact += ["--gear-stiffness", f"j{i}={joint['gear'][1]!r},{joint['gear'][2]!r}".replace("np.float64(", "").replace(")", "")]
    has_elastic = case.bushes or any(joint["gear"] for joint in case.joints)
    if not has_elastic:
        return []
    found = run(percuss, ["response", *contact, "--frequency", "3:900Hz:12"])
    if isinstance(found, str):
        return [found]
    omegas = 2 * np.pi * np.array(found["frequency"])
    stiffnesses = [2e4, 2e5, 2e6]
    expected = case.answer(omegas, stiffnesses)
    wrong = []

    def close(what, got, want, tolerance, scale=None):
        scale = abs(want) if scale is None else scale
        if got is not None and scale > 0:
            kind = what.split(" ")[0]
            case.worst[kind] = max(case.worst.get(kind, 0.0), abs(got - want) / scale)
        if got is None or not abs(got - want) <= tolerance * scale:
            wrong.append(f"{what}: {got} for {want}")

    compliance = found["compliance"]
    close("free mass", compliance["free_mass"], expected["free"], LIMITS)
    if expected["rigid"] is not None:
        close("rigid mass", found["effective_mass"], expected["rigid"], LIMITS)
    close("compliance", compliance["residual_compliance"] or 0.0, expected["compliance"], LIMITS, max(expected["compliance"], 1e-12))
    highest = expected["frequencies"].max()
    if len(found["modes"]) != len(expected["frequencies"]):
        wrong.append(f"{len(found['modes'])} modes for {len(expected['frequencies'])}")
    for mode, f in zip(found["modes"], expected["frequencies"]):
        # The rounding here is that of the largest square; a motion without stiffness is zero to the square root of the rounding.
        if f > 1e-5 * highest:
            close("frequency", mode["frequency"], f, FREQUENCY + 1e-15 * (highest / f) ** 2)
        else:
            close("frequency", mode["frequency"], 0.0, 1.0, 1e-5 * highest)
    close("participations", sum(m["participation"] for m in found["modes"]), expected["participation"].sum(), LIMITS)
    for k, h in enumerate(expected["h"]):
        got = complex(found["mobility"]["real"][k], found["mobility"]["imaginary"][k]) / (1j * omegas[k])
        close(f"receptance at {omegas[k]:.4g}", got, h, RECEPTANCE)
    if expected["rigid"] is not None and not any(b["c"].any() or b["loss"] for b in case.bushes) and not any(j["gear"] or j["spring"] for j in case.joints):
        for stiffness, impact in zip(stiffnesses, expected["impacts"]):
            report = run(percuss, ["mass", *contact, "--stiffness", f"{stiffness / 1e3!r}N/mm"])
            got = None if isinstance(report, str) else report["compliance"]["contact"]["impact"]
            if impact is None or impact["e"] < 0.02 or got is None or got["duration"] is None:
                continue
            case.impacts = getattr(case, "impacts", 0) + 1
            if stiffness == stiffnesses[1] and np.linalg.matrix_rank(case.full[1]) == len(case.full[1]):
                words = ["impact", *contact, "--speed", "1", "--stiffness", f"{stiffness / 1e3!r}N/mm", "--restitution", "1", "--in-time", "--compliance"]
                report = run(percuss, words)
                elements = [] if isinstance(report, str) else report["in_time"]["compliant"]["elements"]
                case.end = impact["duration"]
                bearings = case.bearings(stiffness)
                largest = max(bearings.values())
                for name, force in bearings.items():
                    of = [one["peak_force"] for one in elements if one["element"] == name and one["direction"] is None]
                    # Joints at rest are left out.
                    if not of and force <= ELEMENT * largest:
                        continue
                    close(f"force of {name}", of[0] if of else None, force, ELEMENT, largest)
                    case.bearings_compared = getattr(case, "bearings_compared", 0) + 1
            for key, name in (("impulse_mass",) * 2, ("force_mass",) * 2, ("restitution", "e"), ("duration",) * 2):
                close(f"{key} at {stiffness}", got[key], impact[name], IMPACT)
    return wrong


def exudyn_frequencies(case):
    import exudyn
    from exudyn.utilities import InertiaCuboid, NodeRigidBodyEP  # noqa: F401
    import exudyn.itemInterface as items
    from exudyn.rigidBodyUtilities import RigidBodyInertia

    container = exudyn.SystemContainer()
    system = container.AddSystem()
    ground = system.CreateGround()
    bodies = []
    for link in case.links:
        inertia = RigidBodyInertia(mass=link["mass"], inertiaTensor=link["inertia"])
        bodies.append(system.CreateRigidBody(inertia=inertia, referencePosition=list(link["com"]), nodeType=exudyn.NodeType.RotationRotationVector))

    def marker(i, at):
        local = at if i < 0 else at - case.links[i]["com"]
        return system.AddMarker(items.MarkerBodyRigid(bodyNumber=ground if i < 0 else bodies[i], localPosition=list(local)))

    for joint in case.joints:
        if joint["bush"]:
            continue
        z = joint["axis"]
        x = np.cross(z, [0.3, -0.5, 0.8])
        x /= np.linalg.norm(x)
        frame = np.column_stack([x, np.cross(z, x), z])
        free = {"revolute": [1, 1, 1, 1, 1, 0], "prismatic": [1, 1, 0, 1, 1, 1], "spherical": [1, 1, 1, 0, 0, 0], "fixed": [1] * 6}[joint["kind"]]
        markers = [marker(joint["parent"], joint["at"]), marker(joint["child"], joint["at"])]
        system.AddObject(items.ObjectJointGeneric(markerNumbers=markers, constrainedAxes=free, rotationMarker0=frame, rotationMarker1=frame))
    for loop in case.loops:
        if not loop["bush"]:
            markers = [marker(i, loop["at"]) for i in loop["links"]]
            system.AddObject(items.ObjectJointGeneric(markerNumbers=markers, constrainedAxes=[1, 1, 1, 0, 0, 0]))
    for bush in case.bushes:
        a, b = bush["links"]
        k = np.diag(np.concatenate([bush["k"][3:], bush["k"][:3]]))
        system.AddObject(items.ObjectConnectorRigidBodySpringDamper(
            markerNumbers=[marker(a, bush["at"]), marker(b, bush["at"])], stiffness=k, damping=np.zeros((6, 6)),
            rotationMarker0=bush["frame"], rotationMarker1=bush["frame"]))
    system.Assemble()
    values, _ = system.ComputeODE2Eigenvalues(computeComplexEigenvalues=False, useAbsoluteValues=True, ignoreAlgebraicEquations=False)
    return np.sort(np.sqrt(np.abs(np.real(values)))) / (2 * np.pi)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--percuss", required=True)
    parser.add_argument("--count", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--exudyn", action="store_true")
    args = parser.parse_args()
    passed, failed, impacts, bearings, worst = 0, 0, 0, 0, {}
    with tempfile.TemporaryDirectory() as folder:
        for number in range(args.count):
            case = Case(np.random.default_rng([args.seed, number]), plain=number % 3 == 0)
            wrong = compare(args.percuss, case, Path(folder))
            impacts += getattr(case, "impacts", 0)
            bearings += getattr(case, "bearings_compared", 0)
            for kind, error in case.worst.items():
                worst[kind] = max(worst.get(kind, 0.0), error)
            passed, failed = passed + (not wrong), failed + bool(wrong)
            for line in wrong[:6]:
                print(f"case {number}: {line}")
    if args.exudyn:
        done = 0
        for number in range(0, 3 * args.count, 3):
            case = Case(np.random.default_rng([args.seed, number]), plain=True)
            if done == 5 or not case.bushes or any(joint["gear"] for joint in case.joints):
                continue
            expected = case.answer([], [])["frequencies"]
            found = exudyn_frequencies(case)
            elastic = expected > 1e-4 * expected.max()
            pairs = list(zip(found[-elastic.sum():], expected[elastic]))
            wrong = [pair for pair in pairs if not abs(pair[0] / pair[1] - 1) <= EXUDYN]
            done += 1
            passed, failed = passed + (not wrong), failed + bool(wrong)
            worst = max(abs(a / b - 1) for a, b in pairs)
            print(f"Exudyn, case {number}: {len(pairs)} frequencies, largest difference {worst:.1e}")
    print("largest differences:", ", ".join(f"{kind} {error:.1e}" for kind, error in worst.items()))
    print(f"{impacts} impacts, {bearings} forces of bushes and joints; {passed} passed, {failed} failed")
    sys.exit(failed > 0)


if __name__ == "__main__":
    main()
