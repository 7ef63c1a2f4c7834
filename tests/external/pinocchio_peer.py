"""Pinocchio's results, in percuss's coordinates."""

import numpy as np
import pinocchio as pin

from urdf_file import BASE, Refused


def skew(r):
    return np.array([[0, -r[2], r[1]], [r[2], 0, -r[0]], [-r[1], r[0], 0]])



class Peer:
    """A model with mimics as ordinary joints; T combines them with their masters."""

    name = "Pinocchio"
    knows_contacts = True
    rounding = 1e-15  # of its M, relative
    options = {}

    def __init__(self, path, robot, floating):
        root = [pin.JointModelFreeFlyer()] if floating else []
        try:
            self.model = pin.buildModelFromUrdf(str(path), *root, **self.options)
        except Exception as error:  # Pinocchio's own, of several types
            raise Refused(str(error).strip().splitlines()[-1]) from error
        self.data, self.robot = self.model.createData(), robot
        named = list(zip(self.model.names, self.model.joints))[1:]  # the first is the universe
        self.joints = {BASE if floating and k == 0 else name: joint for k, (name, joint) in enumerate(named)}

    def pose(self, coordinates, positions, base):
        """Sets the pose. T: velocities of the model = T · percuss's coordinates."""
        q = pin.neutral(self.model)
        self.t = np.zeros((self.model.nv, len(coordinates)))
        column = {key: k for k, key in enumerate(coordinates)}
        for name, joint in self.joints.items():
            at = base if name == BASE else positions[name]
            q[joint.idx_q : joint.idx_q + joint.nq] = layout(joint, at)
            master, multiplier, _ = (BASE, 1.0, 0.0) if name == BASE else self.robot.follows(name)
            columns = [column[master, k] for k in range(joint.nv)]
            self.t[joint.idx_v : joint.idx_v + joint.nv, columns] = multiplier * velocity(joint, at)
        self.q = q
        pin.framesForwardKinematics(self.model, self.data, q)

    def mass_matrix(self):
        if self.model.nv == 0:
            return np.zeros((0, 0))
        m = pin.crba(self.model, self.data, self.q)
        m = np.triu(m) + np.triu(m, 1).T
        return self.t.T @ m @ self.t

    def frame(self, link):
        return self.model.getFrameId(link, pin.FrameType.BODY)

    def located(self, contact):
        """Point and normal in the world."""
        placement = self.data.oMf[self.frame(contact["link"])]
        normal = np.array(contact["normal"])
        return placement.act(np.array(contact["point"])), placement.rotation @ normal / np.linalg.norm(normal)

    def point_jacobian(self, link, point):
        """Velocity Jacobian of the link's point at `point`, world axes; and the size of the terms of each column."""
        if self.model.nv == 0:
            return np.zeros((3, 0)), np.zeros(0)
        frame = self.frame(link)
        j = pin.computeFrameJacobian(self.model, self.data, self.q, frame, pin.LOCAL_WORLD_ALIGNED) @ self.t
        arm = point - self.data.oMf[frame].translation
        size = np.linalg.norm(j[:3], axis=0) + np.linalg.norm(j[3:], axis=0) * max(np.linalg.norm(arm), 1e-3)
        return j[:3] - skew(arm) @ j[3:], size


class FoldingPeer(Peer):
    """A model in which Pinocchio itself combines mimics with their masters. Used for M only."""

    name = "Pinocchio folding mimics"
    knows_contacts = False
    options = {"mimic": True}

    def __init__(self, path, robot, floating):
        super().__init__(path, robot, floating)
        mimics = {joint.name for joint in robot.movable if not robot.is_master(joint)}
        self.joints = {name: joint for name, joint in self.joints.items() if name not in mimics}


def layout(joint, at):
    """percuss's position in Pinocchio's layout."""
    if joint.nq == 7:  # free flyer: x,y,z and quaternion x,y,z,w
        return [*at[:3], *at[4:7], at[3]]
    if joint.nq == 4:  # planar: x, y, cos, sin
        return [at[0], at[1], np.cos(at[2]), np.sin(at[2])]
    if joint.nq == 2:  # unbounded revolute
        return [np.cos(at[0]), np.sin(at[0])]
    return at


def velocity(joint, at):
    """Matrix from percuss's to Pinocchio's velocities of a joint."""
    if joint.nv == 6:  # linear first · angular first, both in the child's axes
        return np.roll(np.eye(6), 3, axis=1)
    if joint.nv == 3:  # planar: in the child's axes · in the joint's
        c, s = np.cos(at[2]), np.sin(at[2])
        return np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])
    return np.eye(joint.nv)
