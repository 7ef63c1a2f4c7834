"""Changed masses, comparisons of designs and safe speeds, compared with an independent program.

    designs.py --percuss PATH [--count N] [--seed S]        prints `N passed, N failed`

N random open chains and trees (hinges, slides, fixed joints, axes and frames in any direction) are written as URDF,
read here by a short parser, and posed at random. The effective mass is 1/(j M⁻¹ jᵀ) with M summed over the links' own
Jacobians. Checked flags:

    --link-mass, --link-com   mass of the tree with another mass (moments in proportion) or another centre of mass
    --link-inertia            mass of the tree with other moments about the centre of mass, alone and with another mass of the link
    compare                   100 (m/m₁ − 1) of three such trees
    safe-speed                F = v √(μ k), F = p A, E = ½ μ v², I = μ v with 1/μ = 1/m_H + 1/m_R; m_R the effective
                              mass of the tree with the load as a point mass at the contact, or M/2 + m_L; without a
                              region μ = m_R or M + m_L; the slowest of several directions, of all directions, and of
                              the rows of a table

The meaning of the flags is taken from docs/howto/DESIGNS.md alone; m_H and k are from crates/contact/data.
"""

import argparse
import json
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
# Both programs round at 1e-16; conditions of M scaled to unit diagonal are below 1e6 here.
TOLERANCE = 1e-9


def vector(text):
    return np.array([float(x) for x in text.split()])


def rotation(rpy):
    (sr, sp, sy), (cr, cp, cy) = np.sin(rpy), np.cos(rpy)
    return np.array(
        [
            [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
            [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
            [-sp, cp * sr, cp * cr],
        ]
    )


def turn(axis, angle):
    k = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    return np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * k @ k


def words(values):
    return " ".join(repr(float(x)) for x in values)


def commas(values):
    return ",".join(repr(float(x)) for x in values)


def random_tree(rng):
    """A random URDF text. Every leaf has a mass; some links between are massless."""
    count = int(rng.integers(2, 9))
    text = ['<robot name="random">', '  <link name="ground"/>']
    parents = [int(rng.integers(max(0, i - 2), i + 1)) for i in range(count)]
    leaves = set(range(1, count + 1)) - set(parents)
    for i in range(1, count + 1):
        moving = rng.uniform(0.2, 8) if i in leaves or rng.integers(4) else 0
        inertial = ""
        if moving:
            points = rng.normal(size=(4, 3))
            second = points.T @ points
            inertia = (np.trace(second) * np.eye(3) - second) * moving * 0.002
            entries = zip(("ixx", "ixy", "ixz", "iyy", "iyz", "izz"), inertia[np.triu_indices(3)])
            values = " ".join(f'{key}="{float(value)!r}"' for key, value in entries)
            inertial = (
                f'<inertial><origin xyz="{words(rng.uniform(-0.2, 0.2, size=3))}" rpy="{words(rng.uniform(-1, 1, size=3))}"/>'
                f'<mass value="{float(moving)!r}"/><inertia {values}/></inertial>'
            )
        text.append(f'  <link name="link {i}">{inertial}</link>')
    for i, parent in enumerate(parents, start=1):
        kind = str(rng.choice(["revolute", "continuous", "prismatic", "fixed"], p=[0.4, 0.2, 0.25, 0.15]))
        kind = "revolute" if i == 1 else kind
        axis = rng.normal(size=3)
        limit = '<limit lower="-2" upper="2" effort="1" velocity="1"/>' if kind in ("revolute", "prismatic") else ""
        name = "ground" if parent == 0 else f"link {parent}"
        text.append(
            f'  <joint name="joint{i}" type="{kind}"><origin xyz="{words(rng.uniform(-0.5, 0.5, size=3))}" '
            f'rpy="{words(rng.uniform(-1.4, 1.4, size=3))}"/><parent link="{name}"/><child link="link {i}"/>'
            f'<axis xyz="{words(axis / np.linalg.norm(axis))}"/>{limit}</joint>'
        )
    return "\n".join([*text, "</robot>\n"])


class Tree:
    """A tree from a URDF with hinges, slides and fixed joints, parents before children."""

    def __init__(self, text):
        root = ElementTree.fromstring(text)
        self.links, self.joints = {}, []
        for link in root.iter("link"):
            inertial = link.find("inertial")
            if inertial is None:
                self.links[link.get("name")] = (0.0, np.zeros(3), np.zeros((3, 3)))
                continue
            origin, values = inertial.find("origin"), inertial.find("inertia")
            r = rotation(vector(origin.get("rpy")))
            i = {key: float(values.get(key)) for key in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")}
            inertia = np.array([[i["ixx"], i["ixy"], i["ixz"]], [i["ixy"], i["iyy"], i["iyz"]], [i["ixz"], i["iyz"], i["izz"]]])
            mass = float(inertial.find("mass").get("value"))
            self.links[link.get("name")] = (mass, vector(origin.get("xyz")), r @ inertia @ r.T)
        for joint in root.iter("joint"):
            origin = joint.find("origin")
            place = (rotation(vector(origin.get("rpy"))), vector(origin.get("xyz")))
            ends = (joint.find("parent").get("link"), joint.find("child").get("link"))
            self.joints.append((joint.get("name"), joint.get("type"), ends, place, vector(joint.find("axis").get("xyz"))))
        self.moving = [name for name, kind, *_ in self.joints if kind != "fixed"]

    def moving_mass(self):
        """Total mass of all moving links."""
        still = {"ground"}
        for _, kind, (parent, child), *_ in self.joints:
            if kind == "fixed" and parent in still:
                still.add(child)
        return sum(mass for name, (mass, *_) in self.links.items() if name not in still)

    def posed(self, q):
        """Per link: rotation, position, and the 6×n Jacobian of its angular velocity and of its origin's velocity,
        in world axes."""
        n = len(self.moving)
        found = {"ground": (np.eye(3), np.zeros(3), np.zeros((6, n)))}
        for name, kind, (parent, child), (r, p), axis in self.joints:
            rp, pp, jp = found[parent]
            r, p, j = rp @ r, pp + rp @ p, jp.copy()
            if kind == "prismatic":
                p = p + r @ axis * q[name]
            j[3:] = jp[3:] + np.cross(jp[:3].T, p - pp).T
            if kind == "prismatic":
                j[3:, self.moving.index(name)] += r @ axis
            elif kind != "fixed":
                j[:3, self.moving.index(name)] += r @ axis
                r = r @ turn(axis, q[name])
            found[child] = (r, p, j)
        return found

    def operational(self, q, link, point, load=0.0, changes=None):
        """J M⁻¹ Jᵀ at a point of a link, in world axes, and the link's rotation; `load` is a point mass at the
        point."""
        posed = self.posed(q)
        m = np.zeros((len(self.moving),) * 2)
        for name, given in self.links.items():
            mass, com, inertia = (changes or {}).get(name, given)
            r, _, j = posed[name]
            at = j[3:] + np.cross(j[:3].T, r @ com).T
            m += mass * at.T @ at + j[:3].T @ (r @ inertia @ r.T) @ j[:3]
        r, _, j = posed[link]
        at = j[3:] + np.cross(j[:3].T, r @ point).T
        m += load * at.T @ at
        return at @ np.linalg.solve(m, at.T), r, np.linalg.cond(m / np.sqrt(np.outer(np.diag(m), np.diag(m))))

    def mass(self, q, link, point, normal, **more):
        inverse, r, condition = self.operational(q, link, point, **more)
        n = r @ normal / np.linalg.norm(normal)
        admittance = n @ inverse @ n
        return (1 / admittance if admittance > 0 else np.inf), condition


def speed(limit, region, mass):
    """The greatest safe speed for the effective mass `mass`."""
    kind, value = limit
    mu, k = (mass, None) if region is None else (1 / (1 / region["mass"] + 1 / mass), region["stiffness"])
    if kind == "energy":
        return np.sqrt(2 * value / mu)
    if kind == "momentum":
        return value / mu
    return value / np.sqrt(mu * k)


class Checker:
    def __init__(self, percuss):
        self.percuss, self.passed, self.failed, self.worst, self.kinds = percuss, 0, 0, 0.0, {}

    def answer(self, *flags):
        done = subprocess.run([self.percuss, *flags, "--format", "json"], capture_output=True, text=True, encoding="utf-8")
        return json.loads(done.stdout) if done.returncode == 0 else done.stderr.strip()

    def same(self, kind, found, expected, what):
        off = abs(found / expected - 1) if isinstance(found, float) else np.inf
        good = bool(off <= TOLERANCE)
        self.passed, self.failed = self.passed + good, self.failed + (not good)
        self.kinds[kind] = self.kinds.get(kind, 0) + 1
        self.worst = max(self.worst, off) if np.isfinite(off) else self.worst
        if not good:
            print(f"FAILED {kind}: {found} where {expected} is expected: {what}")

    def value(self, report, *keys):
        for key in keys:
            if isinstance(report, str):
                return report
            report = report[key]
        return report


def changed_masses(check, tree, path, flags, q, link, point, normal, rng):
    bodies = [name for name, (mass, *_) in tree.links.items() if mass > 0]
    name = str(rng.choice(bodies))
    mass, com, inertia = tree.links[name]
    other = mass * rng.uniform(0.2, 4)
    expected, _ = tree.mass(q, link, point, normal, changes={name: (other, com, inertia * other / mass)})
    given = [*flags, "--link-mass", f"{name}={other!r}"]
    check.same("link-mass", check.value(check.answer("mass", path, *given), "effective_mass"), expected, given)
    moved = rng.uniform(-0.3, 0.3, size=3)
    expected, _ = tree.mass(q, link, point, normal, changes={name: (mass, moved, inertia)})
    given = [*flags, "--link-com", f"{name}={commas(moved)}"]
    check.same("link-com", check.value(check.answer("mass", path, *given), "effective_mass"), expected, given)
    # Adding the moments of three point masses on the axes keeps the tensor valid: a body can have it.
    a, b, c = rng.uniform(0, 0.1, size=3)
    moments = np.diag(inertia) + [b + c, a + c, a + b]
    # The products of inertia scale with the mass; with a smaller mass, the tensor remains valid.
    for new in (mass, min(mass, other)):
        turned = inertia * new / mass
        np.fill_diagonal(turned, moments)
        expected, _ = tree.mass(q, link, point, normal, changes={name: (new, com, turned)})
        given = [*flags, "--link-mass", f"{name}={new!r}", "--link-inertia", f"{name}={commas(moments)}"]
        check.same("link-inertia", check.value(check.answer("mass", path, *given), "effective_mass"), expected, given)


def compared(check, trees, paths, q, link, point, normal):
    """The same question for several files."""
    flags = ["--link", link, "--point", commas(point), "--normal", commas(normal)]
    flags += [word for name, value in q.items() for word in ("--set", f"{name}={value!r}")]
    masses = [tree.mass(q, link, point, normal)[0] for tree in trees]
    report = check.answer("compare", *paths, *flags)
    for i, mass in enumerate(masses):
        found = check.value(report, "designs")
        found = found if isinstance(found, str) else found[i]
        check.same("compare", check.value(found, "effective_mass"), mass, paths)
        if i > 0:
            # A difference in per cent has the accuracy of the masses.
            found = check.value(found, "difference_percent")
            found = 1 + found / 100 if isinstance(found, float) else found
            check.same("difference", found, mass / masses[0], paths)


def safe_speeds(check, tree, path, flags, pose, q, link, point, normal, regions, rng, folder):
    region = regions[int(rng.integers(len(regions)))]
    load = float(rng.uniform(0.5, 5)) * float(rng.integers(2))
    loaded = ["--load", repr(load)] if load else []
    total = tree.moving_mass()
    value = float(rng.uniform(1, 300))
    limits = [
        (["--force", repr(value)], ("force", value), region),
        (["--pressure", repr(value), "--area", "1.7"], ("force", value * 1.7), region),
        (["--energy", repr(value)], ("energy", value), region),
        (["--momentum", repr(value)], ("momentum", value), region),
        (["--energy", repr(value)], ("energy", value), None),
        (["--momentum", repr(value)], ("momentum", value), None),
    ]
    inverse, r, _ = tree.operational(q, link, point, load=load)
    n = r @ normal
    for given, limit, of in limits:
        words_of = [*loaded, *given, *([] if of is None else ["--region", of["name"]])]
        report = check.answer("safe-speed", path, *flags, *words_of)
        reflected = speed(limit, of, 1 / (n @ inverse @ n))
        by_standard = speed(limit, of, total / 2 + load if of is not None else total + load)
        check.same(f"speed by {limit[0]}", check.value(report, "reflected", "speed"), reflected, words_of)
        check.same("by the standard", check.value(report, "standard", "speed"), by_standard, words_of)
    place = ["--link", link, "--point", commas(point), *pose, *loaded, "--region", region["name"], "--force", "200"]
    directions = rng.normal(size=(3, 3))
    asked = [word for d in directions for word in ("--direction", commas(d))]
    reports = check.answer("safe-speed", path, *place, *asked)
    for i, d in enumerate(directions):
        d = d / np.linalg.norm(d)
        found = reports if isinstance(reports, str) else check.value(reports[i], "reflected", "speed")
        check.same("directions", found, speed(("force", 200.0), region, 1 / (d @ inverse @ d)), asked)
    # The heaviest direction is the eigenvector of the least eigenvalue of J M⁻¹ Jᵀ, if the point can move in all three
    # directions.
    least, most = np.linalg.eigvalsh(inverse)[[0, 2]]
    if least > 1e-6 * most:
        report = check.answer("safe-speed", path, *place, "--worst-direction")
        found = check.value(report, "reflected", "speed")
        check.same("worst direction", found, speed(("force", 200.0), region, 1 / least), place)
    # A table of positions: the slowest row.
    rows = [{name: float(rng.uniform(-1.5, 1.5)) for name in tree.moving} for _ in range(6)]
    table = folder / "rows.csv"
    table.write_text(",".join(tree.moving) + "\n" + "".join(",".join(repr(x) for x in row.values()) + "\n" for row in rows))
    speeds = []
    for row in rows:
        inverse, r, _ = tree.operational(row, link, point, load=load)
        speeds.append(speed(("force", 200.0), region, 1 / (r @ normal @ inverse @ (r @ normal))))
    contact = ["--link", link, "--point", commas(point), "--normal", commas(normal)]
    given = [*contact, *loaded, "--region", region["name"], "--force", "200", "--input", str(table)]
    report = check.answer("safe-speed", path, *given)
    check.same("slowest row", check.value(report, "along", "slowest", "speed"), min(speeds), given)
    found = check.value(report, "along", "row")
    # If a single joint moves all links, several rows have the same speed.
    check.same("which row", float(speeds[found]) if isinstance(found, int) else found, min(speeds), given)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--percuss", required=True)
    parser.add_argument("--count", type=int, default=40)
    parser.add_argument("--seed", type=int, default=1)
    args = parser.parse_args()
    source = (ROOT / "crates/contact/src/transient_contact/body_region.rs").read_text()
    rows = re.findall(r'region\(\s*"([^"]+)",\s*"[^"]+",\s*([\d.e]+),\s*([\d.e]+),', source)
    regions = [{"name": name, "mass": float(mass), "stiffness": float(k)} for name, mass, k in rows]
    assert len(regions) == 12, "the table of regions has another layout"
    check, skipped = Checker(args.percuss), 0
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        for number in range(args.count):
            rng = np.random.default_rng([args.seed, number])
            text = random_tree(rng)
            tree = Tree(text)
            q = {name: float(rng.uniform(-1.5, 1.5)) for name in tree.moving}
            link = list(tree.links)[-1]
            point, normal = rng.uniform(-0.3, 0.3, size=3), rng.normal(size=3)
            normal /= np.linalg.norm(normal)
            expected, condition = tree.mass(q, link, point, normal)
            inverse = tree.operational(q, link, point)[0]
            # Massless motions and contacts that hardly close have their own accuracy, which other checks test.
            if condition > 1e6 or not 1 / expected > 1e-6 * max(np.trace(inverse), 1e-12):
                skipped += 1
                continue
            paths = [str(folder / f"{number}-{i}.urdf") for i in range(3)]
            Path(paths[0]).write_text(text)
            pose = [word for name, value in q.items() for word in ("--set", f"{name}={value!r}")]
            flags = ["--link", link, "--point", commas(point), "--normal", commas(normal), *pose]
            check.same("mass", check.value(check.answer("mass", paths[0], *flags), "effective_mass"), expected, paths[0])
            for _ in range(3):
                changed_masses(check, tree, paths[0], flags, q, link, point, normal, rng)
            trees = [tree]
            for path in paths[1:]:
                root = ElementTree.fromstring(text)
                for inertial in root.iter("inertial"):
                    factor = rng.uniform(0.5, 2)
                    for element in (inertial.find("mass"), inertial.find("inertia")):
                        for key, value in element.attrib.items():
                            element.set(key, repr(float(value) * factor))
                other = ElementTree.tostring(root, encoding="unicode")
                Path(path).write_text(other)
                trees.append(Tree(other))
            compared(check, trees, paths, q, link, point, normal)
            safe_speeds(check, tree, paths[0], flags, pose, q, link, point, normal, regions, rng, folder)
    kinds = ", ".join(f"{kind} {count}" for kind, count in sorted(check.kinds.items()))
    print(f"designs: {kinds}; off by at most {check.worst:.1e}; {skipped} of {args.count} trees left out (hardly move)")
    print(f"designs: {check.passed} passed, {check.failed} failed")
    sys.exit(check.failed > 0 or check.passed == 0 or skipped > args.count // 2)


if __name__ == "__main__":
    main()
