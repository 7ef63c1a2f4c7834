"""MJCF compared with MuJoCo: both programs read the same file; the effective mass from MuJoCo's mass matrix and the Jacobian of its
equality constraints, at random positions that percuss closes.

    mjcf.py --percuss PATH                   random models, as in .ci/nightly; prints `N passed, N failed`
    mjcf.py --percuss PATH --models FILE...  files instead; prints one line for each
"""

import argparse
import collections
import glob
import json
import os
import subprocess
import tempfile
import xml.etree.ElementTree as ElementTree

import mujoco
import numpy as np

from loops import least_energy, numbers

TOLERANCE = 1e-9
# MuJoCo stores meshes in single precision: 6e-8 of a coordinate, up to three times that of a moment.
MESH_TOLERANCE = 2e-7
# Random models of the default run, contacts for each, and what they give.
COUNT, CONTACTS = 120, 2
EXPECTED = {"models": 97, "refused by MuJoCo": 22, "written": 34, "refused by name": 5}
# An answer without a value: the row of the contact on the kernel of the constraints, relative to the row, below this is rounding.
NO_MOTION = 1e-9

mujoco.set_mju_user_warning(lambda message: None)


def run(*command):
    return subprocess.run(command, capture_output=True, text=True)


class Peer:
    """MuJoCo's model of a file, with the names that percuss gives to bodies and joints without names."""

    def __init__(self, path):
        spec = mujoco.MjSpec.from_file(str(path))
        spec.option.jacobian = mujoco.mjtJacobian.mjJAC_DENSE
        spec.option.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONTACT | mujoco.mjtDisableBit.mjDSBL_LIMIT
        self.model = m = spec.compile()
        self.data = mujoco.MjData(m)
        self.links = [m.body(b).name or f"body{b}" for b in range(m.nbody)]
        used = {m.joint(j).name for j in range(m.njnt)}
        self.joints = {}
        for j in range(m.njnt):
            name = wanted = m.joint(j).name or f"{self.links[m.jnt_bodyid[j]]}_joint"
            number = 2
            while not m.joint(j).name and name in used:
                name, number = f"{wanted}_{number}", number + 1
            used.add(name)
            self.joints[name] = j

    def uses_mesh(self):
        return any(self.model.geom_type == mujoco.mjtGeom.mjGEOM_MESH)

    def set_pose(self, pose):
        m, d = self.model, self.data
        d.qpos[:] = m.qpos0
        for e in range(m.neq):
            # A joint without a partner is locked; percuss has no position for it.
            if m.eq_type[e] == mujoco.mjtEq.mjEQ_JOINT and m.eq_obj2id[e] < 0:
                address = m.jnt_qposadr[m.eq_obj1id[e]]
                d.qpos[address] = m.qpos0[address] + m.eq_data[e, 0]
        for name, values in pose.items():
            if name not in self.joints:
                # The length of a tendon with an armature is a joint of percuss only.
                continue
            j = self.joints[name]
            at, kind = m.jnt_qposadr[j], m.jnt_type[j]
            if kind == mujoco.mjtJoint.mjJNT_FREE:
                # percuss: relative to the drawing.
                turned, quaternion = np.zeros(3), np.zeros(4)
                mujoco.mju_rotVecQuat(turned, np.array(values[:3]), m.qpos0[at + 3 : at + 7])
                mujoco.mju_mulQuat(quaternion, m.qpos0[at + 3 : at + 7], np.array(values[3:]))
                d.qpos[at : at + 7] = [*(m.qpos0[at : at + 3] + turned), *quaternion]
            elif kind == mujoco.mjtJoint.mjJNT_BALL:
                d.qpos[at : at + 4] = values
            else:
                d.qpos[at] = m.qpos0[at] + values[0]
        mujoco.mj_fwdPosition(m, d)

    def matrices(self):
        m, d = self.model, self.data
        mass = np.zeros((m.nv, m.nv))
        mujoco.mj_fullM(m, d, mass)
        mass += self.left_out()
        rows = np.ravel(d.efc_J)[: d.nefc * m.nv].reshape(d.nefc, m.nv)
        rows = rows[d.efc_type == mujoco.mjtConstraint.mjCNSTR_EQUALITY]
        # A tendon between sites of one rigid body has a row of rounding errors.
        return mass, rows[np.abs(rows).max(axis=1, initial=0) > NO_MOTION]

    def left_out(self):
        """Entries of tendon armatures between joints of different branches, which MuJoCo leaves out of M."""
        m, d = self.model, self.data
        related = np.eye(m.nv, dtype=bool)
        for dof in range(m.nv):
            above = m.dof_parentid[dof]
            while above >= 0:
                related[dof, above] = related[above, dof] = True
                above = m.dof_parentid[above]
        missing = np.zeros((m.nv, m.nv))
        for t in np.flatnonzero(m.tendon_armature):
            row = np.zeros(m.nv)
            first, count = m.ten_J_rowadr[t], m.ten_J_rownnz[t]
            row[m.ten_J_colind[first : first + count]] = np.ravel(d.ten_J)[first : first + count]
            missing += m.tendon_armature[t] * np.where(related, 0, np.outer(row, row))
        return missing

    def compare(self, report):
        """Deviation of the effective mass, or of what takes its place, and the largest residual of a constraint."""
        m, d = self.model, self.data
        self.set_pose(report["pose"])
        mass, rows = self.matrices()
        contact = report["contact"]
        body = self.links.index(contact["link"])
        jacobian = np.zeros((3, m.nv))
        mujoco.mj_jac(m, d, jacobian, None, np.array(contact["point_world"]), body)
        row = np.array(contact["normal_world"]) @ jacobian
        residual = np.abs(d.efc_pos[d.efc_type == mujoco.mjtConstraint.mjCNSTR_EQUALITY]).max(initial=0)
        return deviation(report, mass, rows, row), residual

    def contact_links(self):
        """Links that can move."""
        return [link for link in self.links[1:] if self.model.body_weldid[self.links.index(link)] != 0]


def deviation(report, mass, rows, row):
    """Relative deviation of the effective mass from that of the matrices; 0 or 1 where percuss found no motion."""
    if report["status"] == "immovable":
        scaled = rows / np.maximum(np.abs(rows).max(axis=1, keepdims=True, initial=0), 1e-300)
        u, s, vt = np.linalg.svd(scaled) if len(rows) else (None, np.zeros(0), np.eye(len(mass)))
        rank = int((s > 1e-8 * s.max(initial=0)).sum())
        motion = np.abs(vt[rank:] @ row).max(initial=0) / max(np.abs(row).max(initial=0), 1e-300)
        return 0.0 if motion < NO_MOTION or np.abs(row).max(initial=0) < NO_MOTION else 1.0
    if report["status"] != "finite":
        return 1.0
    return abs(report["effective_mass"] / least_energy(mass, rows, row) - 1)


def random_position(rng, kind, limits, size):
    if kind == "spherical":
        q = rng.normal(size=4)
        q /= np.linalg.norm(q)
        return q
    if kind == "floating":
        q = rng.normal(size=4)
        return [*rng.uniform(-1, 1, 3), *(q / np.linalg.norm(q))]
    lower, upper = limits or (-1, 1)
    # Limits beyond ±1 leave the limit nearest to 0.
    nearest = min(max(0, lower), upper)
    return [rng.uniform(max(lower, min(-1, nearest)), min(upper, max(1, nearest))) * size]


def compare_file(percuss, path, rng, count, options=(), peer=None):
    """Deviations from the peer, MuJoCo by default, at `count` random contacts. Returns (deviations, number of poses out of reach), or a
    refusal as text."""
    check = run(percuss, "check", path, "--format", "json", *options)
    if check.returncode:
        return check.stderr.strip().splitlines()[0] if check.stderr else "refused"
    check = json.loads(check.stdout)
    peer = peer or Peer(path)
    kinds = {joint["name"]: (joint["kind"], joint.get("limits")) for joint in check["joints"]}
    looped = bool(check["closures"])
    movable = [joint["name"] for joint in check["joints"] if joint["kind"] != "fixed" and not joint["mimics"]]
    drivers = check["drivers"] if looped else movable
    links = peer.contact_links()
    deviations, unreachable = [], 0
    for number in range(count):
        link = links[rng.integers(len(links))]
        point = ",".join(str(x) for x in rng.uniform(-0.3, 0.3, 3))
        normal = ",".join(str(x) for x in rng.uniform(-1, 1, 3))
        command = [percuss, "mass", path, "--link", link, f"--point={point}", f"--normal={normal}"]
        size = 1.0 if not looped else 0.3 * (number % 3) / 2
        settings = []
        for driver in drivers:
            kind, limits = kinds[driver]
            if looped and (size == 0 or kind in ("spherical", "floating")):
                continue
            values = ",".join(str(x) for x in random_position(rng, kind, limits, size))
            settings += ["--set", f"{driver}={values}"]
        answer = run(*command, *settings, "--format", "json", *options)
        # The position of a driver with several velocities may be determined in part by loops.
        while answer.returncode == 2 and "too many joints" in answer.stderr and settings:
            settings = settings[:-2]
            answer = run(*command, *settings, "--format", "json", *options)
        if answer.returncode == 1:
            unreachable += 1
            continue
        if answer.returncode:
            return answer.stderr.strip().splitlines()[0]
        deviations.append(peer.compare(json.loads(answer.stdout)))
    return deviations, unreachable


class RandomModel:
    """Random MJCF: a tree of bodies with several joints, frames, classes, geoms or declared inertias, and constraints."""

    def __init__(self, seed, is_attached=False):
        self.rng = np.random.default_rng(seed)
        self.child = None
        # MuJoCo resolves a name outside of an attached part in the surrounding model.
        self.mark = "c" if is_attached else ""
        self.degrees = self.rng.random() < 0.5
        self.bodies, self.scalar, self.sites = [], [], []
        self.root = ElementTree.Element("mujoco", model=f"random {seed}")
        sequence = "".join(self.rng.choice(list("xyzXYZ"), 3))
        compiler = ElementTree.SubElement(self.root, "compiler", eulerseq=sequence)
        if not self.degrees or self.rng.random() < 0.5:
            compiler.set("angle", "degree" if self.degrees else "radian")
        self.defaults()
        self.asset()
        world = ElementTree.SubElement(self.root, "worldbody")
        for _ in range(self.rng.integers(1, 3)):
            self.body(world, 0)
        self.constraints()
        if not is_attached and self.chance(0.3):
            self.attach(seed)

    def attach(self, seed):
        """A second random model, with its own settings and classes, attached twice: a body of it and all of it."""
        self.child = RandomModel(seed + 100_000, is_attached=True)
        ElementTree.SubElement(self.root.find("asset"), "model", name="other", file=f"{seed}_attached.xml")
        world = self.root.find("worldbody")
        holder = world if self.chance(0.5) else world.find(".//body")
        frame = ElementTree.SubElement(holder, "frame", pos=self.vector(3, 0.3))
        self.orientation(frame)
        free = {body.get("name") for body in self.child.root.iter("body") if body.find("freejoint") is not None}
        fixed = [body for body in self.child.bodies if body not in free]
        if fixed:
            ElementTree.SubElement(frame, "attach", model="other", body=str(self.rng.choice(fixed)), prefix="one_")
        ElementTree.SubElement(world, "attach", model="other", prefix="two_")

    def chance(self, probability):
        return self.rng.random() < probability

    def vector(self, size, scale=1.0):
        return numbers(self.rng.uniform(-scale, scale, size))

    def angle(self, value):
        return value * 180 / np.pi if self.degrees else value

    def orientation(self, element):
        kind = self.rng.integers(6)
        if kind == 0:
            element.set("quat", self.vector(4))
        elif kind == 1:
            axis = self.rng.uniform(-1, 1, 3)
            element.set("axisangle", numbers([*axis, self.angle(self.rng.uniform(-3, 3))]))
        elif kind == 2:
            element.set("xyaxes", self.vector(6))
        elif kind == 3:
            element.set("zaxis", self.vector(3))
        elif kind == 4:
            element.set("euler", numbers([self.angle(a) for a in self.rng.uniform(-3, 3, 3)]))

    def defaults(self):
        top = ElementTree.SubElement(self.root, "default")
        ElementTree.SubElement(top, "geom", density="800")
        ElementTree.SubElement(top, "joint", armature="0.01")
        ElementTree.SubElement(top, "motor", gear="3")
        arm = ElementTree.SubElement(top, "default", {"class": "arm"})
        ElementTree.SubElement(arm, "geom", type="capsule", size="0.05 0.1", density="1500")
        ElementTree.SubElement(arm, "joint", axis="0 1 0")
        ElementTree.SubElement(arm, "general", armature="0.02")
        inner = ElementTree.SubElement(arm, "default", {"class": "inner"})
        ElementTree.SubElement(inner, "joint", type="slide", armature="0.3")
        ElementTree.SubElement(inner, "geom", mass="0.4")

    def asset(self):
        asset = ElementTree.SubElement(self.root, "asset")
        ElementTree.SubElement(
            asset, "mesh", name="tetrahedron", vertex="0 0 0 .25 0 0 0 .25 0 0 0 .25", face="0 2 1 0 1 3 0 3 2 1 2 3",
            inertia=str(self.rng.choice(["exact", "legacy", "shell", "convex"])), scale="1 2 0.5", refpos="0.125 0 0.25",
        )

    def body(self, parent, depth):
        inside = parent
        if self.chance(0.3):
            inside = ElementTree.SubElement(parent, "frame", pos=self.vector(3, 0.3))
            self.orientation(inside)
            if self.chance(0.3):
                inside.set("childclass", "arm")
        name = f"{self.mark}b{len(self.bodies)}"
        body = ElementTree.SubElement(inside, "body", name=name, pos=self.vector(3, 0.5))
        self.orientation(body)
        if self.chance(0.3):
            body.set("childclass", "arm" if self.chance(0.5) else "inner")
        self.bodies.append(name)
        self.joints(body, depth)
        self.inertia(body)
        for _ in range(self.rng.integers(0, 3)):
            site = ElementTree.SubElement(body, "site", name=f"{self.mark}s{len(self.sites)}", pos=self.vector(3, 0.3))
            self.orientation(site)
            self.sites.append((site.get("name"), name))
        if depth < 3 and len(self.bodies) < 7:
            for _ in range(self.rng.choice([0, 1, 1, 2])):
                self.body(body, depth + 1)

    def joints(self, body, depth):
        if depth == 0 and self.chance(0.2):
            ElementTree.SubElement(body, "freejoint", name=f"{body.get('name')}_free")
            return
        if self.chance(0.2):
            ball = ElementTree.SubElement(body, "joint", name=f"{body.get('name')}_ball", type="ball")
            ball.set("pos", self.vector(3, 0.2))
            return
        for i in range(self.rng.choice([0, 1, 1, 1, 2, 3])):
            holder = body
            if self.chance(0.2):
                holder = ElementTree.SubElement(body, "frame", pos=self.vector(3, 0.3))
                self.orientation(holder)
            name = f"{body.get('name')}_j{i}"
            joint = ElementTree.SubElement(holder, "joint", name=name)
            if self.chance(0.6):
                joint.set("axis", self.vector(3))
            if self.chance(0.6):
                joint.set("pos", self.vector(3, 0.3))
            if self.chance(0.6):
                joint.set("type", str(self.rng.choice(["hinge", "slide"])))
            if self.chance(0.3):
                joint.set("armature", f"{self.rng.uniform(0, 0.5):.3f}")
            if self.chance(0.2):
                joint.set("ref", f"{self.rng.uniform(-1, 1):.3f}")
            if self.chance(0.2):
                joint.set("class", "inner")
            self.scalar.append(name)

    def inertia(self, body):
        if self.chance(0.4):
            inertial = ElementTree.SubElement(body, "inertial", pos=self.vector(3, 0.2), mass=f"{self.rng.uniform(0.2, 3):.3f}")
            factor = self.rng.normal(size=(3, 3))
            second = factor @ factor.T * 0.01
            full = np.trace(second) * np.eye(3) - second
            if self.chance(0.5):
                moments = full[[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]]
                inertial.set("fullinertia", numbers(moments))
            else:
                inertial.set("diaginertia", numbers(np.linalg.eigvalsh(full)))
                self.orientation(inertial)
            return
        for _ in range(self.rng.integers(1, 4)):
            geom = ElementTree.SubElement(body, "geom")
            kind = str(self.rng.choice(["sphere", "capsule", "cylinder", "box", "ellipsoid", "mesh", "class"]))
            if self.chance(0.2) and kind not in ("mesh", "class"):
                geom.set("fromto", self.vector(6, 0.3))
            else:
                geom.set("pos", self.vector(3, 0.3))
                self.orientation(geom)
            if kind == "class":
                geom.set("class", "arm")
            else:
                geom.set("type", kind)
            if kind == "mesh":
                geom.set("mesh", "tetrahedron")
            elif kind != "class":
                geom.set("size", numbers(self.rng.uniform(0.05, 0.3, 3)))
            if self.chance(0.3):
                geom.set("mass", f"{self.rng.uniform(0.1, 2):.3f}")
            elif self.chance(0.3):
                geom.set("density", f"{self.rng.uniform(300, 3000):.1f}")
            if self.chance(0.2) and kind in ("sphere", "capsule", "cylinder", "box"):
                geom.set("shellinertia", "true")
            if self.chance(0.2):
                geom.set("contype", "0")
                geom.set("conaffinity", "0")

    def constraints(self):
        equality = ElementTree.SubElement(self.root, "equality")
        tendon = ElementTree.SubElement(self.root, "tendon")
        actuator = ElementTree.SubElement(self.root, "actuator")
        for number in range(self.rng.integers(0, 3)):
            first, second = self.rng.choice(self.bodies), self.rng.choice(["world", *self.bodies])
            if first == second:
                continue
            kind = self.rng.choice(["connect", "connect", "weld", "rod"])
            if kind == "rod" and len(self.sites) > 1:
                a, b = self.rng.choice(len(self.sites), 2, replace=False)
                path = ElementTree.SubElement(tendon, "spatial", name=f"rod{number}")
                for site in (self.sites[a], self.sites[b]):
                    ElementTree.SubElement(path, "site", site=site[0])
                ElementTree.SubElement(equality, "tendon", tendon1=f"rod{number}")
            elif kind != "rod":
                bond = ElementTree.SubElement(equality, str(kind), body1=str(first), anchor=self.vector(3, 0.3))
                if second != "world":
                    bond.set("body2", str(second))
                if kind == "weld" and self.chance(0.3):
                    bond.set("torquescale", str(self.rng.choice(["0.5", "0"])))
                if self.chance(0.15):
                    bond.set("active", "false")
        joints = list(self.rng.permutation(self.scalar))
        while len(joints) >= 2 and self.chance(0.5):
            relation = ElementTree.SubElement(equality, "joint", joint1=joints.pop())
            if self.chance(0.8):
                relation.set("joint2", joints.pop())
            if self.chance(0.8):
                count = self.rng.choice([1, 2, 2, 5])
                # Loops with many constraints close only as drawn.
                offset = 0.0 if len(equality) > 1 else 0.1
                relation.set("polycoef", numbers([offset, *self.rng.uniform(-2, 2, 4)][:count]))
        if len(joints) >= 2 and self.chance(0.3):
            fixed = ElementTree.SubElement(tendon, "fixed", name="pair")
            for joint in (joints.pop(), joints.pop()):
                ElementTree.SubElement(fixed, "joint", joint=joint, coef=f"{self.rng.uniform(0.5, 2):.3f}")
            ElementTree.SubElement(equality, "tendon", tendon1="pair")
        self.sums(joints, equality, tendon)
        for joint in self.scalar:
            if self.chance(0.3):
                kind = str(self.rng.choice(["motor", "general", "position"]))
                drive = ElementTree.SubElement(actuator, kind, joint=joint)
                if self.chance(0.5):
                    drive.set("armature", f"{self.rng.uniform(0, 0.1):.3f}")
                if self.chance(0.3):
                    drive.set("class", "arm")

    def sums(self, joints, equality, tendon):
        """Relations of several joints, and armatures of tendons over several joints."""
        if len(joints) >= 3 and self.chance(0.4):
            for name, count in (("sum", 2), ("argument", 1)):
                fixed = ElementTree.SubElement(tendon, "fixed", name=name)
                for _ in range(count):
                    ElementTree.SubElement(fixed, "joint", joint=joints.pop(), coef=f"{self.rng.uniform(0.5, 2):.3f}")
            relation = ElementTree.SubElement(equality, "tendon", tendon1="sum", tendon2="argument")
            relation.set("polycoef", numbers([0, *self.rng.uniform(-1, 1, 4)]))
        if len(self.scalar) >= 2 and self.chance(0.4):
            armature = f"{self.rng.uniform(0.1, 1):.3f}"
            fixed = ElementTree.SubElement(tendon, "fixed", name="rotor", armature=armature)
            for joint in self.rng.choice(self.scalar, min(3, len(self.scalar)), replace=False):
                ElementTree.SubElement(fixed, "joint", joint=str(joint), coef=f"{self.rng.uniform(0.5, 2):.3f}")

    def write(self, path):
        if self.child:
            self.child.write(path.replace(".xml", "_attached.xml"))
        ElementTree.indent(self.root)
        ElementTree.ElementTree(self.root).write(path)


def random_models(percuss, count, contacts, first=0):
    """Compares random models. MuJoCo refuses some (a moving body without mass, joints without motion between); these do not count."""
    outcomes, failures = collections.Counter(), []
    worst = (0.0, None)
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(first, first + count):
            path = os.path.join(folder, f"{seed}.xml")
            RandomModel(seed).write(path)
            try:
                peer = Peer(path)
            except ValueError:
                outcomes["refused by MuJoCo"] += 1
                continue
            if not peer.model.nv:
                outcomes["without joints"] += 1
                continue
            answer = compare_file(percuss, path, np.random.default_rng(seed), contacts)
            if isinstance(answer, str):
                failures.append(f"{seed}: {answer}")
                continue
            deviations, unreachable = answer
            outcomes["models"] += 1
            outcomes["out of reach"] += unreachable
            for deviation, residual in deviations:
                if not peer.uses_mesh():
                    worst = max(worst, (deviation, seed), key=lambda item: item[0])
                outcomes["contacts"] += 1
                if not deviation <= (MESH_TOLERANCE if peer.uses_mesh() else TOLERANCE):
                    failures.append(f"{seed}: deviation {deviation:.1e}, residual {residual:.1e}")
    return outcomes, failures, worst


def suspension_models(percuss, folder):
    """URDF of every template of a suspension."""
    listed = run(percuss, "template", "--list").stdout.splitlines()
    for name in [line.split()[0] for line in listed if line[:1].strip()]:
        sheet, model = os.path.join(folder, f"{name}.toml"), os.path.join(folder, f"{name}.urdf")
        made = run(percuss, "template", name, "-o", sheet).returncode == 0
        if made and run(percuss, "import", sheet, "-o", model).returncode == 0:
            yield model


def written_models(percuss):
    """Shipped models and suspensions as MJCF: MuJoCo loads the file, and its effective mass is that of the original."""
    outcomes, failures, worst = collections.Counter(), [], 0.0
    with tempfile.TemporaryDirectory() as folder:
        for source in [*sorted(glob.glob("models/*.urdf")), *suspension_models(percuss, folder)]:
            name = os.path.basename(source)
            path = os.path.join(folder, f"{name}.xml")
            converted = run(percuss, "convert", source, "-o", path)
            if converted.returncode == 2 and "cannot be written as MJCF" in converted.stderr:
                outcomes["refused by name"] += 1
                continue
            outcomes["written"] += 1
            try:
                peer = Peer(path)
            except ValueError as error:
                failures.append(f"{name}: MuJoCo: {str(error).splitlines()[0]}")
                continue
            if not peer.model.nv:
                continue
            rng = np.random.default_rng(3)
            answer = compare_file(percuss, path, rng, 3)
            if isinstance(answer, str):
                failures.append(f"{name}: {answer}")
                continue
            link = peer.links[-1]
            contact = ["--link", link, "--point=0.1,0.2,0.3", "--normal=0.3,0.5,1", "--format", "json"]
            both = [run(percuss, "mass", model, *contact) for model in (source, path)]
            first, second = (json.loads(one.stdout)["effective_mass"] if one.returncode == 0 else None for one in both)
            own = abs(first / second - 1) if first and second else float(first != second)
            for deviation in [own, *(deviation for deviation, _ in answer[0])]:
                outcomes["comparisons"] += 1
                worst = max(worst, deviation)
                if not deviation <= TOLERANCE:
                    failures.append(f"{name}: deviation {deviation:.1e}")
    return outcomes, failures, worst


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--percuss", required=True)
    parser.add_argument("--count", type=int, default=COUNT)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--contacts", type=int, default=CONTACTS)
    parser.add_argument("--models", nargs="*")
    arguments = parser.parse_args()
    if arguments.models is not None:
        for path in arguments.models:
            try:
                answer = compare_file(arguments.percuss, path, np.random.default_rng(1), arguments.contacts)
            except ValueError as error:
                answer = f"MuJoCo: {str(error).splitlines()[0]}"
            if not isinstance(answer, str):
                worst = max((deviation for deviation, _ in answer[0]), default=float("nan"))
                answer = f"worst {worst:.1e} of {len(answer[0])} contacts, {answer[1]} out of reach"
            print(f"{path}: {answer}", flush=True)
        return 0
    outcomes, failures, worst = random_models(arguments.percuss, arguments.count, arguments.contacts, arguments.first)
    for failure in failures[:10]:
        print(f"FAILED: {failure}")
    print(", ".join(f"{count} {name}" for name, count in sorted(outcomes.items())), f"worst {worst[0]:.1e} (seed {worst[1]})")
    written, refused, worst = written_models(arguments.percuss)
    for failure in refused[:10]:
        print(f"FAILED: {failure}")
    print(", ".join(f"{count} {name}" for name, count in sorted(written.items())), f"worst {worst:.1e}")
    # Counts of the default run: a model that drops out is noticed.
    default = (arguments.count, arguments.first, arguments.contacts) == (COUNT, 0, CONTACTS)
    found = {name: (outcomes | written)[name] for name in EXPECTED}
    if default and found != EXPECTED:
        refused.append(f"counts {found}, expected {EXPECTED}")
        print(f"FAILED: {refused[-1]}")
    failed = len(failures) + len(refused)
    print(f"{outcomes['contacts'] + written['comparisons'] - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    raise SystemExit(main())
