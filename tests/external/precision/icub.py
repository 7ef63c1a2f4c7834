"""Effective masses of iCub (or of another open tree of hinges and slides) in lanes and at poses, against 90 digits.

    python icub.py URDF [--rows 1200] [--seed 1]

Needs the package percuss, mpmath and gmpy2. Rows lie within the joint limits; in every third batch they are near poses
at which the axes of the neck are nearly in line, where the mass matrix is almost singular. The reference reads the
numbers of the file itself and shares no code with percuss. No stated error may be exceeded.
"""

from __future__ import annotations

import argparse
import sys
import warnings
import xml.etree.ElementTree as ElementTree

import numpy as np
from mpmath import mpf

from mechanics import Mechanism, Position, by_recursion

# Rows of a batch, which has one contact per link.
BATCH = 100
CONTACTS = 4
HALF = float(np.finfo(float).eps) / 2


def rows_of(path):
    """Rows of the reference, names of its links, and number of each moving joint's link by joint name."""
    robot = ElementTree.parse(path).getroot()
    texts = {}
    for link in robot.findall("link"):
        inertial = link.find("inertial")
        texts[link.get("name")] = []
        if inertial is not None:
            origin, inertia = inertial.find("origin"), inertial.find("inertia")
            xyz, rpy = ("0 0 0", "0 0 0") if origin is None else (origin.get("xyz", "0 0 0"), origin.get("rpy", "0 0 0"))
            moments = " ".join(inertia.get(name, "0") for name in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"))
            texts[link.get("name")] = [inertial.find("mass").get("value"), xyz, moments, rpy]
    by_parent = {}
    for joint in robot.findall("joint"):
        assert joint.find("mimic") is None
        by_parent.setdefault(joint.find("parent").get("link"), []).append(joint)
    children = {joint.find("child").get("link") for joints in by_parent.values() for joint in joints}
    names = [name for name in texts if name not in children]
    assert len(names) == 1
    joints, moving = [], {}
    for number, name in enumerate(names):
        for joint in by_parent.get(name, []):
            kind = {"fixed": "f", "revolute": "c", "continuous": "c", "prismatic": "p"}[joint.get("type")]
            origin, axis = joint.find("origin"), joint.find("axis")
            xyz, rpy = ("0 0 0", "0 0 0") if origin is None else (origin.get("xyz", "0 0 0"), origin.get("rpy", "0 0 0"))
            along = "1 0 0" if kind == "f" or axis is None else axis.get("xyz")
            joints.append([kind, number, xyz, along, rpy])
            names.append(joint.find("child").get("link"))
            if kind != "f":
                moving[joint.get("name")] = len(names) - 1
    return {"links": [texts[name] for name in names], "joints": joints}, names, moving


def main():
    import percuss

    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("urdf")
    parser.add_argument("--rows", type=int, default=1200)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    warnings.simplefilter("ignore")
    rows, links, moving = rows_of(given.urdf)
    mechanism = Mechanism(rows)
    model = percuss.load(given.urdf)
    assembly = model.assemble()
    order = model.position_names
    assert sorted(order) == sorted(moving)
    limits = {joint.name: joint.limits for joint in model.joints if joint.name in moving}
    random = np.random.default_rng(given.seed)
    # Links that move.
    carried = {0}
    for number, joint in enumerate(rows["joints"], 1):
        if joint[0] == "f" and joint[1] in carried:
            carried.add(number)
    able = [number for number in range(len(links)) if number not in carried]
    counts = {kind: {"stated": 0, "exceeded": 0, "worst": 0.0, "ratios": []} for kind in ("lanes", "poses")}
    again, wrong, complaints = 0, [], []

    def take(kind, label, mass, error, truth):
        tally = counts[kind]
        off = float(abs(mpf(mass) - truth))
        rounding = HALF * float(truth)
        part = (off - rounding) / error
        tally["stated"] += 1
        tally["worst"] = max(tally["worst"], part)
        tally["ratios"].append(error / max(off, rounding))
        if not part <= 1.0:
            tally["exceeded"] += 1
            complaints.append(f"{kind}, {label}: {mass!r} +- {error:.1e}, true {float(truth)!r}")

    for batch in range(-(-given.rows // BATCH)):
        count = min(BATCH, given.rows - batch * BATCH)
        q = np.empty((count, len(order)))
        for column, name in enumerate(order):
            lower, upper = limits[name] or (-3.0, 3.0)
            q[:, column] = random.uniform(max(lower, -3.0), min(upper, 3.0), count)
        if batch % 3 == 2:
            # The axes of yaw and pitch are in line a quarter turn of the roll from zero.
            roll = order.index("neck_roll")
            q[:, roll] = random.choice([-1.0, 1.0], count) * np.pi / 2 + 10.0 ** random.uniform(-7, -1, count)
        contacts = []
        for k in range(CONTACTS):
            head = k == 0 and "head" in links
            link = links.index("head") if head else int(random.choice(able))
            point, normal = random.uniform(-0.3, 0.3, 3), random.uniform(-1, 1, 3)
            words = [" ".join(repr(float(x)) for x in numbers) for numbers in (point, normal)]
            exact = {"on": link, "against": None, "point": words[0], "normal": words[1], "world": False, "toward": None}
            contacts.append((percuss.Contact(links[link], list(point), list(normal)), exact))
        swept = [percuss.sweep(assembly, contact, q) for contact, _ in contacts]
        for row in range(count):
            exact_q = {moving[name]: mpf(float(q[row, column])) for column, name in enumerate(order)}
            truths = by_recursion(Position(mechanism, exact_q), [exact for _, exact in contacts])
            pose = assembly.pose(q[row])
            for k, ((contact, _), found, truth) in enumerate(zip(contacts, swept, truths, strict=True)):
                label = f"batch {batch}, contact {k} ({contact.link}), row {row}"
                if found.status[row] != percuss.Status.FINITE or truth is None:
                    wrong.append(f"{label}: status {found.status[row]}, true {truth and float(truth)}")
                    continue
                if np.isnan(found.error[row]):
                    again += 1
                else:
                    take("lanes", label, float(found.effective_mass[row]), float(found.error[row]), truth)
                response = pose.respond(contact)
                error = np.inf if response.error is None else response.error
                take("poses", label, response.effective_mass, error, truth)
    for kind, tally in counts.items():
        median = np.median(tally["ratios"]) if tally["ratios"] else np.nan
        print(
            f"{kind}: {given.rows} rows of {CONTACTS} contacts, {tally['stated']} stated, {tally['exceeded']} exceeded, "
            f"true/stated at most {tally['worst']:.2f}, stated/true median {median:.0f}"
        )
    print(f"{again} rows asked again, {len(wrong)} wrong outcomes")
    for complaint in (complaints + wrong)[:20]:
        print(f"  {complaint}")
    return 1 if complaints or wrong else 0


if __name__ == "__main__":
    sys.exit(main())
