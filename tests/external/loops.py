"""Closed linkages compared with MuJoCo: the same mechanism as MJCF, the effective mass from its mass matrix and the
Jacobian of its equality constraints (a Schur complement on their kernel), at poses closed by percuss.

    loops.py --percuss PATH        prints `N passed, N failed`
"""

import argparse
import json
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

import mujoco
import numpy as np

# percuss and MuJoCo compute M and A independently; both solve systems with conditions up to a few hundred.
TOLERANCE = 1e-9
# Rank threshold relative to the largest singular value: smaller values belong to rows of redundant closures.
RANK = 1e-8

MODELS = {
    # model: (driver, its values, links without contacts)
    "four_bar": ("crank_hinge", np.linspace(-3, 3, 25), ()),
    "six_bar": (None, np.linspace(-0.3, 0.3, 13), ()),
    # Spinning links have contacts only as the other side: their moment about the spin axis differs in MuJoCo (see
    # `presentable`).
    "double_wishbone": (None, np.linspace(-0.2, 0.2, 25), ("spindle", "wheel")),
}


def vector(text, default="0 0 0"):
    return np.array([float(x) for x in (text or default).split()])


def rotation(rpy):
    (sr, sp, sy), (cr, cp, cy) = np.sin(rpy), np.cos(rpy)
    return np.array(
        [
            [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
            [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
            [-sp, cp * sr, cp * cr],
        ]
    )


def origin(element):
    found = element.find("origin") if element is not None else None
    if found is None:
        return np.zeros(3), np.eye(3)
    return vector(found.get("xyz")), rotation(vector(found.get("rpy")))


def numbers(values):
    return " ".join(f"{x:.17g}" for x in np.ravel(values))


def quaternion(matrix):
    q = np.zeros(4)
    mujoco.mju_mat2Quat(q, np.ascontiguousarray(matrix).ravel())
    return numbers(q)


JOINTS = {"revolute": "hinge", "continuous": "hinge", "prismatic": "slide", "spherical": "ball", "fixed": None}


def mjcf(path):
    """MJCF of a URDF+: tree, point and hinge closures as `connect`, rods as tendons of fixed length."""
    robot = ElementTree.parse(path).getroot()
    links = {link.get("name"): link for link in robot.findall("link")}
    below = {}
    for joint in robot.findall("joint"):
        below.setdefault(joint.find("parent").get("link"), []).append(joint)
    root = (set(links) - {j.find("child").get("link") for js in below.values() for j in js}).pop()
    sites = {name: [] for name in links}
    equality, tendons = [], []
    for loop in robot.findall("loop"):
        name, kind = loop.get("name"), loop.get("type")
        ends = [loop.find(side) for side in ("predecessor", "successor")]
        (p1, r1), (p2, r2) = origin(ends[0]), origin(ends[1])
        body1, body2 = ends[0].get("link"), ends[1].get("link")
        axis = vector(loop.find("axis").get("xyz")) if loop.find("axis") is not None else np.array([1.0, 0, 0])
        if kind == "distance":
            for i, (body, p) in enumerate(((body1, p1), (body2, p2))):
                sites[body].append((f"{name}_{i}", p))
            tendons.append(name)
            continue
        # A hinge: two points of its axis coincide (the second adds two independent rows and one dependent row).
        points = {"spherical": [0.0], "revolute": [0.0, 1.0], "continuous": [0.0, 1.0]}[kind]
        for i, along in enumerate(points):
            for side, (body, p, r) in enumerate(((body1, p1, r1), (body2, p2, r2))):
                sites[body].append((f"{name}_{i}_{side}", p + r @ axis * along))
            equality.append(f'<connect site1="{name}_{i}_0" site2="{name}_{i}_1"/>')

    def body(name, joint):
        p, r = origin(joint)
        out = [f'<body name="{name}" pos="{numbers(p)}" quat="{quaternion(r)}">']
        kind = JOINTS[joint.get("type")]
        if kind:
            axis = joint.find("axis")
            axis = f'axis="{axis.get("xyz")}"' if axis is not None and kind != "ball" else ""
            out.append(f'<joint name="{joint.get("name")}" type="{kind}" {axis}/>')
        out += contents(name)
        return out + ["</body>"]

    def contents(name):
        inertial = links[name].find("inertial")
        out = []
        if inertial is not None and name != root:
            p, r = origin(inertial)
            i = inertial.find("inertia")
            ixx, iyy, izz, ixy, ixz, iyz = (float(i.get(k)) for k in ("ixx", "iyy", "izz", "ixy", "ixz", "iyz"))
            full = presentable(r @ np.array([[ixx, ixy, ixz], [ixy, iyy, iyz], [ixz, iyz, izz]]) @ r.T)
            values = [full[0, 0], full[1, 1], full[2, 2], full[0, 1], full[0, 2], full[1, 2]]
            mass = inertial.find("mass").get("value")
            out.append(f'<inertial pos="{numbers(p)}" mass="{mass}" fullinertia="{numbers(values)}"/>')
        out += [f'<site name="{site}" pos="{numbers(p)}"/>' for site, p in sites[name]]
        return out + [line for joint in below.get(name, []) for line in body(joint.find("child").get("link"), joint)]

    rods = "".join(
        f'<spatial name="{t}"><site site="{t}_0"/><site site="{t}_1"/></spatial>' for t in tendons
    )
    equality += [f'<tendon tendon1="{t}"/>' for t in tendons]
    return (
        '<mujoco><compiler angle="radian" balanceinertia="false" boundmass="0" boundinertia="0"/>'
        '<option gravity="0 0 0"/>'
        f'<worldbody>{"".join(contents(root))}</worldbody><tendon>{rods}</tendon>'
        f'<equality>{"".join(equality)}</equality></mujoco>'
    ), [name for name in links if name != root]


def presentable(inertia):
    """An inertia that MuJoCo accepts: MuJoCo refuses thin rods and violations of the triangle inequality.

    Neither change affects an effective mass here: a moment of zero becomes 1e-12 kg·m²; a moment beyond the sum of
    the others is reduced to the sum. In these models only arms (which turn about another axis) and the freely
    spinning spindle have such a moment, and the contacts avoid them."""
    moments, axes = np.linalg.eigh(inertia)
    moments = np.maximum(moments, 1e-12)
    if moments[2] > moments[0] + moments[1]:
        moments[2] = (moments[0] + moments[1]) * (1 - 1e-9)
    return axes @ np.diag(moments) @ axes.T


def least_energy(mass, rows, row):
    """min vᵀMv with Av = 0, jv = 1, on the kernel of A, which may have no rows."""
    size = 1 / np.sqrt(np.diag(mass))
    u, s, vt = np.linalg.svd(rows * size)
    rank = int((s > RANK * s.max(initial=0)).sum())
    kernel = vt[rank:].T * size[:, None]
    along = row @ kernel
    return 1 / (along @ np.linalg.solve(kernel.T @ mass @ kernel, along))


class Peer:
    def __init__(self, path):
        text, self.links = mjcf(path)
        self.model = mujoco.MjModel.from_xml_string(text)
        self.data = mujoco.MjData(self.model)

    def effective_mass(self, report):
        m, d = self.model, self.data
        for joint, values in report["pose"].items():
            address = m.joint(joint).qposadr[0]
            d.qpos[address : address + len(values)] = values
        mujoco.mj_fwdPosition(m, d)
        mass = np.zeros((m.nv, m.nv))
        mujoco.mj_fullM(m, d, mass)
        rows = np.zeros((d.nefc, m.nv))
        rows[:] = d.efc_J.reshape(d.nefc, m.nv)
        rows = rows[d.efc_type == mujoco.mjtConstraint.mjCNSTR_EQUALITY]
        assert len(rows), "MuJoCo has no equality row"
        contact = report["contact"]
        jacobian = np.zeros((3, m.nv))
        point = np.array(contact["point_world"])
        mujoco.mj_jac(m, d, jacobian, None, point, m.body(contact["link"]).id)
        return least_energy(mass, rows, np.array(contact["normal_world"]) @ jacobian)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--percuss", required=True)
    parser.add_argument("--only", choices=sorted(MODELS))
    options = parser.parse_args()
    percuss = options.percuss
    rng = np.random.default_rng(7)
    passed = failed = 0
    for name, (driver, values, spared) in MODELS.items():
        if options.only not in (None, name):
            continue
        path = f"models/{name}.urdf"
        peer = Peer(path)
        check = json.loads(subprocess.run([percuss, "check", path, "--format", "json"], capture_output=True, check=True, text=True).stdout)
        driver = driver or check["drivers"][0]
        massive = [l["name"] for l in check["links"] if l["mass"] > 0 and l["name"] in peer.links and l["name"] not in spared]
        worst, here = 0.0, 0
        for value in values:
            link = massive[rng.integers(len(massive))]
            point = ",".join(str(x) for x in rng.uniform(-0.3, 0.3, 3))
            normal = ",".join(str(x) for x in rng.uniform(-1, 1, 3))
            command = [percuss, "mass", path, "--link", link, f"--point={point}", f"--normal={normal}"]
            command += ["--set", f"{driver}={value}", "--format", "json"]
            run = subprocess.run(command, capture_output=True, text=True)
            if run.returncode == 1:  # out of this linkage's reach
                continue
            if run.returncode:
                failed += 1
                print(f"{name}: {run.stderr}")
                continue
            report = json.loads(run.stdout)
            if report["status"] != "finite":
                continue
            deviation = abs(report["effective_mass"] / peer.effective_mass(report) - 1)
            worst, here = max(worst, deviation), here + 1
            if deviation <= TOLERANCE:
                passed += 1
            else:
                failed += 1
                print(f"{name}: {driver} = {value}, {link}: {deviation:.1e} off")
        print(f"{name}: {here} contacts, worst {worst:.1e}")
        if here < 5:
            failed += 1
            print(f"{name}: only {here} contacts had an answer to compare")
    print(f"{passed} passed, {failed} failed")
    return 1 if failed or not passed else 0


if __name__ == "__main__":
    sys.exit(main())
