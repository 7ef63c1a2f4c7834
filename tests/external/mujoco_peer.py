"""MuJoCo's results, in percuss's coordinates. MuJoCo reads the URDF itself, without its shapes."""

import xml.etree.ElementTree as ElementTree

import mujoco
import numpy as np

from urdf_file import ONE_VALUE, Refused


# MuJoCo's repairs are off: no balancing, bounding, welding or inertia from shapes. No shapes, so that no meshes are
# loaded.
COMPILER = {
    "fusestatic": "false",
    "discardvisual": "false",
    "balanceinertia": "false",
    "inertiafromgeom": "false",
    "boundmass": "0",
    "boundinertia": "0",
}

# Warnings (mimics of fixed joints, equal limits) are neither printed nor written to a log file.
mujoco.set_mju_user_warning(lambda message: None)


class Peer:
    name = "MuJoCo"
    knows_contacts = True
    rounding = 1e-14  # of its M, relative: it turns inertias into principal axes and quaternions

    def __init__(self, path, robot, floating):
        self.robot, self.floating = robot, floating
        if any(joint.kind not in ONE_VALUE for joint in robot.movable):
            raise Refused("not asked: planar and floating joints are translated for Pinocchio only")
        try:
            spec = mujoco.MjSpec.from_string(text(path))
            if floating:
                (root,) = spec.worldbody.bodies
                root.add_freejoint()
            self.model = spec.compile()
        except ValueError as error:
            raise Refused(str(error).splitlines()[0]) from error
        self.data = mujoco.MjData(self.model)

    def pose(self, coordinates, positions, base):
        """Sets the pose. T: velocities of the model = T · percuss's coordinates."""
        m, d = self.model, self.data
        self.t = np.zeros((m.nv, len(coordinates)))
        column = {key: k for k, key in enumerate(coordinates)}
        if self.floating:
            d.qpos[:7] = base  # x,y,z and quaternion w,x,y,z, as percuss has it
            # MuJoCo: linear in the world's axes, then angular in the body's · percuss: angular first, both in the
            # body's.
            self.t[3:6, :3] = np.eye(3)
            self.t[:3, 3:6] = rotation(base[3:])
        for joint in self.robot.movable:
            theirs = m.joint(joint.name)
            d.qpos[theirs.qposadr[0]] = positions[joint.name][0]
            master, multiplier, _ = self.robot.follows(joint.name)
            self.t[theirs.dofadr[0], column[master, 0]] = multiplier
        mujoco.mj_fwdPosition(m, d)

    def mass_matrix(self):
        full = np.zeros((self.model.nv, self.model.nv))
        mujoco.mj_fullM(self.model, self.data, full)
        return self.t.T @ full @ self.t

    def located(self, contact):
        """Point and normal in the world."""
        body = self.data.body(renamed(contact["link"]))
        turn, normal = body.xmat.reshape(3, 3), np.array(contact["normal"])
        return body.xpos + turn @ contact["point"], turn @ normal / np.linalg.norm(normal)

    def point_jacobian(self, link, point):
        """Velocity Jacobian of the link's point at `point`, world axes; and the size of the terms of each column."""
        body = self.model.body(renamed(link)).id
        linear, angular = np.zeros((3, self.model.nv)), np.zeros((3, self.model.nv))
        mujoco.mj_jac(self.model, self.data, linear, angular, point, body)
        linear, angular = linear @ self.t, angular @ self.t
        return linear, np.linalg.norm(linear, axis=0) + np.linalg.norm(angular, axis=0)


def text(path):
    """The URDF without shapes, with the compiler's changes disabled."""
    root = ElementTree.parse(path).getroot()
    for tag in ("mujoco", "gazebo", "transmission", "material"):
        for element in root.findall(tag):
            root.remove(element)
    for link in root.findall("link"):
        for element in link.findall("visual") + link.findall("collision"):
            link.remove(element)
    for element in root.iter():
        for key, value in element.attrib.items():
            if key == "link" or element.tag == "link" and key == "name":
                element.set(key, renamed(value))
    ElementTree.SubElement(ElementTree.SubElement(root, "mujoco"), "compiler", COMPILER)
    return ElementTree.tostring(root, encoding="unicode")


def renamed(link):
    """A link called world would become MuJoCo's ground."""
    return "the world" if link == "world" else link


def rotation(quaternion):
    turn = np.zeros(9)
    mujoco.mju_quat2Mat(turn, np.array(quaternion))
    return turn.reshape(3, 3)
