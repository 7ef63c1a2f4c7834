"""SDFormat compared with Drake: both programs read the same file; the effective mass from Drake's mass matrix and Jacobians, at random
positions that percuss closes. Drake has no loops: joints that close one, gearboxes and mimics are taken out of its file, and their rows are
written here from Drake's Jacobians.

    sdf.py --percuss PATH        random models, and shipped models and suspensions that percuss writes; prints `N passed, N failed`
"""

import argparse
import collections
import glob
import json
import logging
import os
import tempfile
import xml.etree.ElementTree as ElementTree

import numpy as np
from pydrake.common.eigen_geometry import Quaternion
from pydrake.math import RigidTransform, RollPitchYaw, RotationMatrix
from pydrake.multibody.parsing import Parser
from pydrake.multibody.plant import MultibodyPlant
from pydrake.multibody.tree import BallRpyJoint, FrameIndex, JacobianWrtVariable, ModelInstanceIndex, UniversalJoint

from loops import numbers
from mjcf import NO_MOTION, compare_file, deviation, run, suspension_models

# Drake and percuss compute M and A independently, with conditions up to a few thousand.
TOLERANCE = 1e-9
# Least eigenvalue of a mass matrix, kg·m² or kg, from which on its inverse has digits: files with massless links have 0.
SINGULAR = 1e-9
# Random models of the default run, contacts for each, and what they give.
COUNT, CONTACTS = 560, 2
EXPECTED = {"models": 560, "refused by Drake": 15, "written": 34, "refused by name": 5, "massless in Drake": 16}


logging.getLogger("drake").setLevel(logging.ERROR)
# libsdformat compares prefixes, not namespaces.
ElementTree.register_namespace("drake", "http://drake.mit.edu")


def vector(element, default):
    text = element.text if element is not None and element.text else default
    return np.array([float(x) for x in text.split()])


def pose(element):
    x, y, z, roll, pitch, yaw = vector(element, "0 0 0 0 0 0")
    return RigidTransform(RollPitchYaw(roll, pitch, yaw), [x, y, z])


class Peer:
    """Drake's plant of a file, with the names that percuss gives to links and joints."""

    def __init__(self, path, tree_joints):
        tree = ElementTree.parse(path)
        model = tree.getroot().find(".//model")
        # A joint between two links that cannot move is neither in the tree nor a loop for percuss.
        self.loops = [joint for joint in model.findall("joint") if joint.get("name") not in tree_joints]
        for joint in self.loops:
            model.remove(joint)
        self.followers = []
        for joint in model.findall("joint"):
            for axis in joint.findall("axis") + joint.findall("axis2"):
                if axis.find("mimic") is not None:
                    self.followers.append((joint.get("name"), axis.tag, axis.find("mimic")))
                    axis.remove(axis.find("mimic"))
        self.plant = plant = MultibodyPlant(0.0)
        reduced = f"{path}.tree.sdf"
        tree.write(reduced)
        parser = Parser(plant)
        # The included model is in a folder beside the folder of the file.
        arm = os.path.join(os.path.dirname(os.path.dirname(path)), "arm")
        if os.path.exists(arm):
            parser.package_map().Add("arm", arm)
        (self.instance, *_) = parser.AddModels(reduced)
        plant.Finalize()
        self.context = plant.CreateDefaultContext()
        scope = plant.GetModelInstanceName(self.instance) + "::"
        self.bodies = {body.scoped_name().get_full().removeprefix(scope): body for body in self.all_bodies()}
        self.bodies["world"] = plant.world_body()
        # Frames of the file are links without mass for percuss. Drake names them after the model of their body.
        names = {frame.get("name"): frame.get("name") for frame in model.findall("frame")}
        names |= {frame.get("name"): f"n::{frame.get('name')}" for frame in model.findall("model/frame")}
        include = model.find("include")
        if include is not None:
            prefix = "" if include.get("merge") else "i::"
            frames = ElementTree.parse(os.path.join(arm, "model.sdf")).iter("frame")
            names |= {frame.get("name"): prefix + frame.get("name") for frame in frames}
        every = [plant.get_frame(FrameIndex(i)) for i in range(plant.num_frames())]
        self.frames = {names[frame.name()]: frame for frame in every if frame.name() in names}
        self.frames |= {name: body.body_frame() for name, body in self.bodies.items()}
        indices = [index for i in self.instances() for index in plant.GetJointIndices(i)]
        # Drake may count a joint of a model to one nested in it: names are without those of models.
        self.joints = {plant.get_joint(index).name(): plant.get_joint(index) for index in indices}
        # Poses as drawn: where the loops are closed.
        self.drawn = {name: self.body_pose(name) for name in self.bodies}

    def instances(self):
        """The model and the models nested in it."""
        plant = self.plant
        every = [ModelInstanceIndex(i) for i in range(plant.num_model_instances())]
        name = plant.GetModelInstanceName(self.instance)
        return [i for i in every if plant.GetModelInstanceName(i).split("::")[0] == name]

    def all_bodies(self):
        return [self.plant.get_body(index) for i in self.instances() for index in self.plant.GetBodyIndices(i)]

    def body_pose(self, name):
        return self.frames[name].CalcPoseInWorld(self.context)

    def contact_links(self):
        fixed = {body.index() for body in self.plant.GetBodiesWeldedTo(self.plant.world_body())}
        return [name for name, frame in self.frames.items() if frame.body().index() not in fixed]

    def set_pose(self, given):
        values = {name if name.endswith("_floating") else name.split("::")[-1]: value for name, value in given.items()}
        for name, joint in self.joints.items():
            if isinstance(joint, BallRpyJoint) and name in values:
                w, x, y, z = values[name]
                rpy = RollPitchYaw(RotationMatrix(Quaternion(np.array([w, x, y, z]) / np.linalg.norm([w, x, y, z]))))
                joint.set_angles(self.context, rpy.vector())
            elif isinstance(joint, UniversalJoint):
                joint.set_angles(self.context, [values[f"{name}/{axis}"][0] for axis in ("axis", "axis2")])
            elif joint.num_positions() == 1:
                positions = self.plant.GetPositions(self.context)
                positions[joint.position_start()] = values[name][0]
                self.plant.SetPositions(self.context, positions)
        for name, body in self.bodies.items():
            at = values.get(f"{name}_floating")
            if at is not None:
                moved = RigidTransform(Quaternion(np.array(at[3:]) / np.linalg.norm(at[3:])), at[:3])
                self.plant.SetFreeBodyPose(self.context, body, self.drawn[name] @ moved)

    def jacobian(self, name, point):
        """Angular and linear rows of a point, m, in the frame of a link."""
        plant, world = self.plant, self.plant.world_frame()
        return plant.CalcJacobianSpatialVelocity(
            self.context, JacobianWrtVariable.kV, self.frames[name], point, world, world
        )

    def closure(self, joint):
        """Rows of a joint that closes a loop, and its residual."""
        kind = joint.get("type")
        parent, child = (joint.find(tag).text for tag in ("parent", "child"))
        x_cj = pose(joint.find("pose"))
        x_pj = self.drawn[parent].inverse() @ self.drawn[child] @ x_cj
        now_p, now_c = self.body_pose(parent) @ x_pj, self.body_pose(child) @ x_cj
        origin = now_c.translation()
        at_parent = self.body_pose(parent).inverse().multiply(origin)
        relative = self.jacobian(child, x_cj.translation()) - self.jacobian(parent, at_parent)
        angular, linear = relative[:3], relative[3:]
        gap = now_p.rotation().matrix().T @ (origin - now_p.translation())
        turned = now_p.rotation().matrix().T @ now_c.rotation().matrix()
        directions = [vector(joint.find(f"{tag}/xyz"), "0 0 1") for tag in ("axis", "axis2")]
        axis = directions[0] / np.linalg.norm(directions[0])
        across = np.linalg.svd(axis[None])[2][1:]
        world = now_p.rotation().matrix() @ across.T
        if kind == "ball":
            return linear, np.abs(gap).max()
        if kind == "fixed":
            return relative, max(np.abs(gap).max(), np.abs(turned - np.eye(3)).max())
        if kind in ("revolute", "continuous"):
            return np.vstack([linear, world.T @ angular]), max(np.abs(gap).max(), np.abs(turned @ axis - axis).max())
        if kind == "prismatic":
            return np.vstack([world.T @ linear, angular]), max(np.abs(across @ gap).max(), np.abs(turned - np.eye(3)).max())
        first = now_p.rotation().matrix() @ axis
        second = now_c.rotation().matrix() @ (directions[1] / np.linalg.norm(directions[1]))
        return np.vstack([linear, np.cross(first, second) @ angular]), max(np.abs(gap).max(), abs(first @ second))

    def rows(self):
        rows, residual = [np.zeros((0, self.plant.num_velocities()))], 0.0
        for joint in self.loops:
            own, error = self.closure(joint)
            rows.append(own)
            residual = max(residual, error)
        for name, tag, mimic in self.followers:
            row = np.zeros(self.plant.num_velocities())
            for joint, axis, factor in [(name, tag, 1.0), (mimic.get("joint"), mimic.get("axis", "axis"), -float(mimic.find("multiplier").text))]:
                row[self.joints[joint].velocity_start() + (axis == "axis2")] += factor
            rows.append(row[None])
        rows = np.vstack(rows)
        # A joint between links without motion between them has rows of rounding errors.
        return rows[np.abs(rows).max(axis=1, initial=0) > NO_MOTION], residual

    def compare(self, report):
        """Deviation of the effective mass, or of what takes its place, and the largest residual of a loop."""
        self.set_pose(report["pose"])
        contact = report["contact"]
        name = contact["link"]
        point = self.body_pose(name).inverse().multiply(np.array(contact["point_world"]))
        row = np.array(contact["normal_world"]) @ self.jacobian(name, point)[3:]
        rows, residual = self.rows()
        return deviation(report, self.plant.CalcMassMatrix(self.context), rows, row), residual


class RandomModel:
    """Random SDFormat: links in a tree with frames, nested and included models and joints in either direction, and joints that close loops.
    `letter`: before the names of an included model, which has neither nested models nor loops."""

    def __init__(self, rng, letter=""):
        self.rng, self.letter = rng, letter
        self.minor = int(rng.integers(4, 12))
        self.root = ElementTree.Element("sdf", version=f"1.{self.minor}")
        self.model = ElementTree.SubElement(self.root, "model", name=f"{letter}m")
        self.text(self.model, "pose", self.pose_text())
        self.frames, self.links, self.leaders, self.closures = [], [], [], []
        # Link to which a frame is attached.
        self.link_of = {}
        self.nested = self.included = None
        if not letter and self.chance(0.4) and self.minor > 4:
            self.nested = ElementTree.SubElement(self.model, "model", name="n")
            self.text(self.nested, "pose", self.pose_text())
        for number in range(rng.integers(2, 3 if letter else 6)):
            self.link(number)
        ends = [(str(rng.choice(self.links[:number])), self.links[number]) for number in range(1, len(self.links))]
        if not letter and self.chance(0.4):
            ends.append((str(rng.choice(self.links)), self.include()))
        if not letter and self.chance(0.7):
            self.joint("to_world", "world", self.links[0])
        for number, (parent, child) in enumerate(ends):
            self.joint(f"{letter}j{number + 1}", parent, child)
        for model, prefix in ((self.model, ""), (self.nested, "n::")):
            own = [frame.removeprefix(prefix) for frame in self.frames if frame.startswith(prefix)]
            own = [frame for frame in own if "::" not in frame and frame != "__model__"]
            if model is not None and own and self.minor > 7 and self.chance(0.3):
                model.set("placement_frame", str(rng.choice(own)))
        while not letter and self.chance(0.4) and len(self.closures) < 2:
            self.loop()

    def chance(self, probability):
        return self.rng.random() < probability

    def text(self, parent, tag, text, **attributes):
        element = ElementTree.SubElement(parent, tag, **attributes)
        element.text = text
        return element

    def pose_text(self):
        return numbers([*self.rng.uniform(-0.5, 0.5, 3), *self.rng.uniform(-1.5, 1.5, 3)])

    def place(self, element, frames):
        """A pose, relative to a frame; the attribute has another name in older versions."""
        if self.chance(0.2):
            return
        attributes = {}
        if frames and self.minor > 4 and self.chance(0.6):
            choice = [*frames, "__model__"] if self.minor > 6 else frames
            attributes["relative_to" if self.minor > 6 else "frame"] = str(self.rng.choice(choice))
        text = self.pose_text()
        if self.minor >= 9 and self.chance(0.3):
            attributes["degrees"] = "true"
            text = numbers([*self.rng.uniform(-0.5, 0.5, 3), *self.rng.uniform(-90, 90, 3)])
        elif self.minor >= 9 and self.chance(0.3):
            q = self.rng.normal(size=4)
            text = numbers([*self.rng.uniform(-0.5, 0.5, 3), *(q / np.linalg.norm(q))])
            attributes["rotation_format"] = "quat_xyzw"
        self.text(element, "pose", text, **attributes)

    def link(self, number):
        holder, prefix = self.model, ""
        if self.nested is not None and (number == 1 or self.chance(0.3)):
            holder, prefix = self.nested, "n::"
        own = [frame.removeprefix("n::") for frame in self.frames if frame.startswith("n::")] if prefix else self.frames
        plain = f"{self.letter}l{number}"
        link = ElementTree.SubElement(holder, "link", name=plain)
        self.place(link, own)
        inertial = ElementTree.SubElement(link, "inertial")
        if self.chance(0.7):
            self.text(inertial, "pose", self.pose_text())
        self.text(inertial, "mass", f"{self.rng.uniform(0.2, 3):.3f}")
        factor = self.rng.normal(size=(3, 3))
        second = factor @ factor.T * 0.01
        full = np.trace(second) * np.eye(3) - second
        inertia = ElementTree.SubElement(inertial, "inertia")
        for tag, i, j in [("ixx", 0, 0), ("iyy", 1, 1), ("izz", 2, 2), ("ixy", 0, 1), ("ixz", 0, 2), ("iyz", 1, 2)]:
            self.text(inertia, tag, numbers([full[i, j]]))
        name = f"{prefix}{plain}"
        self.links.append(name)
        self.frames.append(name)
        self.link_of[name] = name
        if self.minor > 6 and self.chance(0.4):
            attached = str(self.rng.choice([*own, plain, plain]))
            frame = ElementTree.SubElement(holder, "frame", name=f"{self.letter}f{number}", attached_to=attached)
            self.place(frame, [*own, plain])
            self.frames.append(f"{prefix}{self.letter}f{number}")
            self.link_of[self.frames[-1]] = self.link_of[prefix + attached]

    def include(self):
        """Includes another model; returns the name of its first link."""
        self.included = inner = RandomModel(self.rng, "a")
        merge = self.minor > 8 and self.chance(0.5)
        include = ElementTree.SubElement(self.model, "include", **({"merge": "true"} if merge else {}))
        self.text(include, "uri", "model://arm/model.sdf")
        if not merge:
            self.text(include, "name", "i")
        self.place(include, self.frames)
        if self.minor > 7 and include.find("pose") is not None and self.chance(0.4):
            self.text(include, "placement_frame", str(self.rng.choice(inner.frames)))
        prefix = "" if merge else "i::"
        self.frames += [prefix + frame for frame in inner.frames]
        self.links += [prefix + link for link in inner.links]
        self.link_of |= {prefix + frame: prefix + link for frame, link in inner.link_of.items()}
        return prefix + inner.links[0]

    def axes(self, joint, tags, directions, frames, mimic=True):
        """Axes of a joint, in one frame."""
        attributes, flag = {}, None
        if frames and self.chance(0.4):
            attributes["expressed_in"] = str(self.rng.choice([*frames, "__model__"] if self.minor > 6 else frames))
        if self.minor <= 6 and self.chance(0.6):
            flag = str(self.rng.choice(["true", "false", "1", "0"]))
        for tag, direction in zip(tags, directions, strict=True):
            axis = ElementTree.SubElement(joint, tag)
            self.text(axis, "xyz", numbers(direction), **attributes)
            if flag is not None:
                self.text(axis, "use_parent_model_frame", flag)
            if mimic and self.minor >= 11 and self.leaders and self.chance(0.2):
                leader, leading = self.leaders[self.rng.integers(len(self.leaders))]
                relation = ElementTree.SubElement(axis, "mimic", joint=leader, axis=leading)
                self.text(relation, "multiplier", numbers([self.rng.uniform(-2, 2)]))
                self.text(relation, "offset", "0")
                self.text(relation, "reference", "0")
            elif mimic:
                self.leaders.append((joint.get("name"), tag))

    def joint(self, name, parent, child):
        kinds = ["revolute", "revolute", "prismatic", "ball", "universal", "fixed"]
        kind = str(self.rng.choice(kinds + (["screw"] if self.minor >= 11 else [])))
        if parent != "world" and kind in ("revolute", "prismatic", "fixed") and self.chance(0.3):
            parent, child = child, parent
        holder, frames, mimic = self.model, self.frames, kind != "universal"
        if self.nested is not None and parent.startswith("n::") and child.startswith("n::") and self.chance(0.7):
            parent, child = parent.removeprefix("n::"), child.removeprefix("n::")
            frames = [frame.removeprefix("n::") for frame in self.frames if frame.startswith("n::")]
            # Relations name joints of the same model.
            holder, mimic = self.nested, False
        elif self.minor > 6 and parent != "world" and self.chance(0.3):
            parent = str(self.rng.choice([frame for frame, link in self.link_of.items() if link == parent]))
        joint = ElementTree.SubElement(holder, "joint", name=name, type=kind)
        self.text(joint, "parent", parent)
        self.text(joint, "child", child)
        self.place(joint, frames)
        if kind == "screw":
            self.text(joint, "screw_thread_pitch", numbers([self.rng.uniform(-0.5, 0.5)]))
        direction = self.rng.normal(size=3)
        if kind == "universal":
            across = np.cross(direction, self.rng.normal(size=3))
            self.axes(joint, ["axis", "axis2"], [direction, across], frames, mimic=mimic)
        elif kind in ("revolute", "prismatic", "screw"):
            self.axes(joint, ["axis"], [direction], frames, mimic=mimic)

    def loop(self):
        first, second = self.rng.choice(len(self.links) + 1, 2, replace=False)
        ends = ["world", *self.links]
        parent, child = (ends[first], ends[second]) if second else (ends[second], ends[first])
        kind = str(self.rng.choice(["ball", "ball", "universal", "revolute", "prismatic"]))
        name = f"loop{len(self.closures)}"
        joint = ElementTree.SubElement(self.model, "joint", name=name, type=kind)
        self.text(joint, "parent", parent)
        self.text(joint, "child", child)
        self.text(joint, "pose", self.pose_text())
        physics = ElementTree.SubElement(ElementTree.SubElement(joint, "physics"), "simbody")
        self.text(physics, "must_be_loop_joint", "true")
        first = self.rng.normal(size=3)
        if kind != "ball":
            tags = ["axis", "axis2"][: 1 + (kind == "universal")]
            for tag, direction in zip(tags, [first, np.cross(first, self.rng.normal(size=3))]):
                axis = ElementTree.SubElement(joint, tag)
                self.text(axis, "xyz", numbers(direction))
                if self.minor == 4:
                    self.text(axis, "use_parent_model_frame", "false")
        self.closures.append(name)

    def write(self, path):
        """Writes the file, and its included model in a folder `arm` beside its own folder."""
        os.makedirs(os.path.dirname(path), exist_ok=True)
        ElementTree.indent(self.root)
        ElementTree.ElementTree(self.root).write(path)
        if self.included is not None:
            folder = os.path.join(os.path.dirname(os.path.dirname(path)), "arm")
            self.included.write(os.path.join(folder, "model.sdf"))


def tree_joints(percuss, path):
    """Names in the file of the joints of the tree that percuss has chosen; a refusal as text."""
    check = run(percuss, "check", path, "--format", "json")
    if check.returncode:
        return check.stderr.strip()
    return {joint["name"].split("/")[0] for joint in json.loads(check.stdout)["joints"]}


def has_impossible_inertia(path):
    """True if a link has moments A + B < C, which no body has."""
    for inertia in ElementTree.parse(path).getroot().iter("inertia"):
        value = lambda tag: float(inertia.find(tag).text)
        xx, xy, xz, yy, yz, zz = map(value, ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"))
        moments = np.linalg.eigvalsh([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        if moments[0] + moments[1] < moments[2] * (1 - 1e-9):
            return True
    return False


def compare(percuss, path, seed, contacts, outcomes, failures):
    """Largest deviation of a file."""
    name = os.path.basename(path)
    joints = tree_joints(percuss, path)
    if isinstance(joints, str):
        failures.append(f"{name}: {joints}")
        return 0.0
    try:
        peer = Peer(path, joints)
    except RuntimeError as error:
        if "reversed" not in str(error):
            raise
        outcomes["refused by Drake"] += 1
        return 0.0
    floating = [joint.removesuffix("_floating") for joint in joints if joint.endswith("_floating")]
    if not all(peer.bodies[body].is_floating_base_body() for body in floating):
        outcomes["another base in Drake"] += 1
        return 0.0
    if has_impossible_inertia(path):
        outcomes["moments A + B < C, which Drake changes"] += 1
        return 0.0
    least = np.linalg.eigvalsh(peer.plant.CalcMassMatrix(peer.context)).min(initial=1.0)
    if least < SINGULAR:
        outcomes["massless in Drake"] += 1
        return 0.0
    if not peer.contact_links():
        outcomes["without motion"] += 1
        return 0.0
    answer = compare_file(percuss, path, np.random.default_rng(seed), contacts, peer=peer)
    if isinstance(answer, str):
        failures.append(f"{name}: {answer}")
        return 0.0
    deviations, unreachable = answer
    outcomes["out of reach"] += unreachable
    for own, residual in deviations:
        outcomes["contacts"] += 1
        if not own <= TOLERANCE:
            failures.append(f"{name}: deviation {own:.1e}, residual {residual:.1e}")
    return max((own for own, _ in deviations), default=0.0)


def random_models(percuss, count, contacts, first, outcomes, failures):
    worst = 0.0
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(first, first + count):
            path = os.path.join(folder, str(seed), "main", f"{seed}.sdf")
            RandomModel(np.random.default_rng(seed)).write(path)
            outcomes["models"] += 1
            worst = max(worst, compare(percuss, path, seed, contacts, outcomes, failures))
    return worst


def compare_original(percuss, source, path, failures):
    """Deviation of a written file from its original, both read by percuss: contacts at the links of the file."""
    worst = 0.0
    links = [link.get("name") for link in ElementTree.parse(path).getroot().iter("link")]
    for link in links:
        contact = ["--link", link, "--point=0.1,0.2,0.3", "--normal=0.3,0.5,1", "--format", "json"]
        both = [run(percuss, "mass", model, *contact) for model in (source, path)]
        first, second = (json.loads(one.stdout)["effective_mass"] if one.returncode == 0 else None for one in both)
        own = abs(first / second - 1) if first and second else float(first != second)
        worst = max(worst, own)
        if not own <= 1e-12:
            failures.append(f"{os.path.basename(path)}, {link}: {first} kg, written {second} kg")
    return worst


def written_models(percuss, outcomes, failures):
    """Shipped models and suspensions as SDFormat: Drake reads the file, and its effective mass is that of the original."""
    worst = 0.0
    with tempfile.TemporaryDirectory() as folder:
        for source in [*sorted(glob.glob("models/*.urdf")), *suspension_models(percuss, folder)]:
            path = os.path.join(folder, os.path.basename(source) + ".sdf")
            converted = run(percuss, "convert", source, "-o", path)
            if converted.returncode == 2 and "cannot be written as SDFormat" in converted.stderr:
                outcomes["refused by name"] += 1
                continue
            outcomes["written"] += 1
            worst = max(worst, compare_original(percuss, source, path, failures))
            worst = max(worst, compare(percuss, path, 3, 3, outcomes, failures))
    return worst


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--percuss", required=True)
    parser.add_argument("--count", type=int, default=COUNT)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--contacts", type=int, default=CONTACTS)
    parser.add_argument("--models", nargs="*")
    arguments = parser.parse_args()
    outcomes, failures = collections.Counter(), []
    if arguments.models is not None:
        for path in arguments.models:
            print(path, f"{compare(arguments.percuss, path, 0, arguments.contacts, outcomes, failures):.1e}")
    else:
        worst = random_models(arguments.percuss, arguments.count, arguments.contacts, arguments.first, outcomes, failures)
        worst = max(worst, written_models(arguments.percuss, outcomes, failures))
        if (arguments.count, arguments.first) == (COUNT, 0):
            for name, expected in EXPECTED.items():
                if outcomes[name] != expected:
                    failures.append(f"{name}: {outcomes[name]}, expected {expected}")
        print(f"largest deviation {worst:.1e}")
    print(", ".join(f"{name}: {count}" for name, count in sorted(outcomes.items())))
    for failure in failures:
        print(f"FAILED {failure}")
    print(f"{outcomes['contacts']} passed, {len(failures)} failed")
    raise SystemExit(bool(failures))


if __name__ == "__main__":
    main()
