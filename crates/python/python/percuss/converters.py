"""Positions and velocities of other programs in the order of percuss, and models from their memory.

    >>> converter = percuss.converters.Converter.of_pinocchio(model, pinocchio_model)
    >>> q = converter.positions(pinocchio_q)          # (..., p), the order of Model.position_names
    >>> percuss.sweep(model, contact, q)

Conventions (quaternions: w, x, y, z in percuss, MuJoCo and Drake; x, y, z, w in Pinocchio and ROS):

    joint       percuss              Pinocchio            MuJoCo               Drake
    hinge       angle                angle; cos, sin      angle                angle
                                     without limits
    ball        w x y z              x y z w              w x y z              roll pitch yaw
    free        x y z, w x y z       x y z, x y z w       x y z, w x y z       w x y z, x y z
    planar      x y angle            x y cos sin          slide slide hinge    x y angle
    ball, ω     of the child         of the child         of the child         of the parent
    free, ω v   ω v of the child     v ω of the child     v of the parent,     ω v of the parent
                                                          ω of the child

The free joint of the root link of a floating model is no joint of percuss: base_pose gives x, y, z, w, x, y, z for
base_pose= of a sweep. Mimic joints follow their masters and are not read.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any
from xml.sax.saxutils import quoteattr

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._errors import InputError, ModelWarning
from ._gradients import rotation_of
from ._percuss import Joint, Model, loads

__all__ = ["Converter", "from_mujoco", "from_pinocchio"]

_Array = NDArray[np.float64]
#: Velocities of a joint of percuss by its kind.
_VELOCITIES = {"revolute": 1, "continuous": 1, "prismatic": 1, "planar": 3, "spherical": 3, "floating": 6, "fixed": 0}


@dataclass(frozen=True)
class _Block:
    """Joint in both programs.

    layout: "plain" (the same numbers), "circle" (cosine and sine), "ball_last", "free_last" (quaternions with w last),
    "free_drake" (quaternion before translation), "ball_angles" (roll, pitch, yaw), "planar_circle".
    twist: axes and order of the six velocities of a free joint: "same", "linear_first", "linear_parent", "parent"; of the
    three of a ball: "same", "ball_parent".
    drawn: position of the other program as drawn, which is zero in percuss: an angle, or x, y, z, w, x, y, z.
    """

    name: str
    own: slice
    other: slice
    own_velocity: slice
    other_velocity: slice
    layout: str = "plain"
    twist: str = "same"
    drawn: tuple[float, ...] | None = None

    def to_percuss(self, x: _Array) -> _Array:
        found = _to_percuss(self.layout, x)
        if self.drawn is None:
            return found
        if len(self.drawn) == 1:
            return found - self.drawn[0]
        drawn = np.asarray(self.drawn)
        back = np.swapaxes(rotation_of(drawn[3:]), -1, -2)
        inverse = drawn[3:] * np.array([1.0, -1.0, -1.0, -1.0])
        return np.concatenate([_turn(back, found[..., :3] - drawn[:3]), _product(inverse, found[..., 3:])], axis=-1)

    def from_percuss(self, x: _Array) -> _Array:
        found = x
        if self.drawn is not None and len(self.drawn) == 1:
            found = x + self.drawn[0]
        elif self.drawn is not None:
            drawn = np.asarray(self.drawn)
            moved = _turn(rotation_of(drawn[3:]), x[..., :3]) + drawn[:3]
            found = np.concatenate([moved, _product(drawn[3:], x[..., 3:])], axis=-1)
        return _from_percuss(self.layout, found)


def _product(a: _Array, b: _Array) -> _Array:
    """Products of quaternions w, x, y, z."""
    w = a[..., :1] * b[..., :1] - np.sum(a[..., 1:] * b[..., 1:], axis=-1, keepdims=True)
    v = a[..., :1] * b[..., 1:] + b[..., :1] * a[..., 1:] + np.cross(a[..., 1:], b[..., 1:])
    return np.concatenate([w, v], axis=-1)


def _to_percuss(layout: str, x: _Array) -> _Array:
    if layout == "circle":
        return np.arctan2(x[..., 1:2], x[..., 0:1])
    if layout == "planar_circle":
        return np.concatenate([x[..., :2], np.arctan2(x[..., 3:4], x[..., 2:3])], axis=-1)
    if layout == "ball_last":
        return x[..., [3, 0, 1, 2]]
    if layout == "free_last":
        return x[..., [0, 1, 2, 6, 3, 4, 5]]
    if layout == "free_drake":
        return x[..., [4, 5, 6, 0, 1, 2, 3]]
    if layout == "ball_angles":
        return _quaternion(x)
    return x


def _from_percuss(layout: str, x: _Array) -> _Array:
    if layout == "circle":
        return np.concatenate([np.cos(x), np.sin(x)], axis=-1)
    if layout == "planar_circle":
        return np.concatenate([x[..., :2], np.cos(x[..., 2:]), np.sin(x[..., 2:])], axis=-1)
    if layout == "ball_last":
        return x[..., [1, 2, 3, 0]]
    if layout == "free_last":
        return x[..., [0, 1, 2, 4, 5, 6, 3]]
    if layout == "free_drake":
        return x[..., [3, 4, 5, 6, 0, 1, 2]]
    if layout == "ball_angles":
        return _angles(x)
    return x


def _quaternion(angles: _Array) -> _Array:
    """Quaternions w, x, y, z of roll, pitch, yaw: R = Rz(yaw) Ry(pitch) Rx(roll)."""
    c, s = np.cos(0.5 * angles), np.sin(0.5 * angles)
    (cr, cp, cy), (sr, sp, sy) = np.moveaxis(c, -1, 0), np.moveaxis(s, -1, 0)
    parts = [
        cr * cp * cy + sr * sp * sy,
        sr * cp * cy - cr * sp * sy,
        cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
    ]
    return np.stack(parts, axis=-1)


def _angles(x: _Array) -> _Array:
    """Roll, pitch, yaw of quaternions w, x, y, z; pitch within a right angle."""
    r = rotation_of(x)
    pitch = np.arctan2(-r[..., 2, 0], np.hypot(r[..., 0, 0], r[..., 1, 0]))
    roll, yaw = np.arctan2(r[..., 2, 1], r[..., 2, 2]), np.arctan2(r[..., 1, 0], r[..., 0, 0])
    return np.stack([roll, pitch, yaw], axis=-1)


def _turn(rotation: _Array, v: _Array) -> _Array:
    turned: _Array = np.einsum("...ij,...j->...i", rotation, v)
    return turned


def _twist_to_percuss(twist: str, v: _Array, rotation: _Array | None) -> _Array:
    """Angular, then linear velocity in the axes of the child."""
    if twist == "linear_first":
        return v[..., [3, 4, 5, 0, 1, 2]]
    if twist in ("same", "planar_child") or rotation is None:
        return v
    back = np.swapaxes(rotation, -1, -2)
    if twist == "ball_parent":
        return _turn(back, v)
    if twist == "linear_parent":
        return np.concatenate([v[..., 3:], _turn(back, v[..., :3])], axis=-1)
    return np.concatenate([_turn(back, v[..., :3]), _turn(back, v[..., 3:])], axis=-1)


def _twist_from_percuss(twist: str, v: _Array, rotation: _Array | None) -> _Array:
    if twist == "linear_first":
        return v[..., [3, 4, 5, 0, 1, 2]]
    if twist in ("same", "planar_child") or rotation is None:
        return v
    if twist == "ball_parent":
        return _turn(rotation, v)
    if twist == "linear_parent":
        return np.concatenate([_turn(rotation, v[..., 3:]), v[..., :3]], axis=-1)
    return np.concatenate([_turn(rotation, v[..., :3]), _turn(rotation, v[..., 3:])], axis=-1)


@dataclass(frozen=True)
class Converter:
    """Converts positions and velocities between another program and percuss; any number of leading axes."""

    model: Model
    program: str
    #: Numbers of positions and velocities of the other program.
    position_count: int
    velocity_count: int
    blocks: tuple[_Block, ...]
    base: _Block | None = field(default=None)

    @classmethod
    def of_pinocchio(cls, model: Model, other: Any) -> Converter:
        """For a pinocchio.Model with joints of the same names.

        A free joint without a joint of its name in percuss is that of the base. A ModelWarning names mimics that move independently in the
        other model: pinocchio.buildModelFromUrdf(path, mimic=True) reads them.
        """
        joints: dict[str, tuple[slice, slice, str]] = {}
        masters = {joint.name: joint.mimics for joint in model.joints if joint.mimics}
        for number in range(1, int(other.njoints)):
            joint = other.joints[number]
            if int(joint.nv) > 0 and (master := masters.get(str(other.names[number]))):
                warnings.warn(
                    f'joint "{other.names[number]}" follows "{master}" in percuss and moves independently in the Pinocchio model, so that '
                    "effective masses differ; pinocchio.buildModelFromUrdf(path, mimic=True) reads mimics",
                    ModelWarning,
                    stacklevel=2,
                )
            q, v = (int(joint.idx_q), int(joint.nq)), (int(joint.idx_v), int(joint.nv))
            joints[str(other.names[number])] = (slice(q[0], sum(q)), slice(v[0], sum(v)), str(joint.shortname()))

        def layout(kind: str, width: int) -> tuple[str, str]:
            if kind == "floating":
                return "free_last", "linear_first"
            if kind == "planar":
                return "planar_circle", "planar_child"
            if kind == "spherical":
                return "ball_last", "same"
            return ("circle" if width == 2 else "plain"), "same"

        return cls._of(model, "Pinocchio", int(other.nq), int(other.nv), joints, layout)

    @classmethod
    def of_mujoco(cls, model: Model, other: Any) -> Converter:
        """For a mujoco.MjModel with joints of the same names; joints without a name are found by their body. A free joint of another name is that of the base."""
        joints: dict[str, tuple[slice, slice, str]] = {}
        # In percuss, and in its reader of MJCF, a joint is at zero as drawn.
        drawn: dict[str, tuple[float, ...]] = {}
        # Free, ball, slide, hinge: mjtJoint.
        widths = [(7, 6), (4, 3), (1, 1), (1, 1)]
        for number in range(int(other.njnt)):
            name, kind = str(other.joint(number).name), int(other.jnt_type[number])
            q, v = int(other.jnt_qposadr[number]), int(other.jnt_dofadr[number])
            nq, nv = widths[kind]
            name = name or _unnamed_joint(model, other, number)
            joints[name] = (slice(q, q + nq), slice(v, v + nv), "free" if kind == 0 else "")
            if kind != 1:
                drawn[name] = tuple(float(x) for x in other.qpos0[q : q + nq])

        def layout(kind: str, _: int) -> tuple[str, str]:
            return "plain", ("linear_parent" if kind == "floating" else "same")

        return cls._of(model, "MuJoCo", int(other.nq), int(other.nv), joints, layout, drawn=drawn)

    @classmethod
    def of_drake(cls, model: Model, plant: Any, instance: Any = None) -> Converter:
        """For a pydrake MultibodyPlant that is finalized; instance: the model instance, if there are several.

        Positions are those of plant.GetPositions(context), of all instances. A quaternion joint without a joint of its
        name in percuss is that of the base.
        """
        joints: dict[str, tuple[slice, slice, str]] = {}
        for index in plant.GetJointIndices() if instance is None else plant.GetJointIndices(instance):
            joint = plant.get_joint(index)
            q, v = int(joint.position_start()), int(joint.velocity_start())
            nq, nv = int(joint.num_positions()), int(joint.num_velocities())
            if nq:
                free = "free" if nq == 7 else ""
                joints[str(joint.name())] = (slice(q, q + nq), slice(v, v + nv), free)

        def layout(kind: str, _: int) -> tuple[str, str]:
            if kind == "spherical":
                return "ball_angles", "ball_parent"
            return ("free_drake", "parent") if kind == "floating" else ("plain", "same")

        count, velocities = int(plant.num_positions()), int(plant.num_velocities())
        return cls._of(model, "Drake", count, velocities, joints, layout)

    @classmethod
    def of_joint_state(cls, model: Model, names: Sequence[str]) -> Converter:
        """For the joints named in a ROS sensor_msgs/JointState: positions and velocities in the order of its name field.

        Joints without an entry are at zero; entries of other joints (of other robots) are ignored. A ModelWarning names both if there are
        both. Raises InputError if no name is that of a joint.
        """
        joints = {name: (slice(k, k + 1), slice(k, k + 1), "") for k, name in enumerate(names)}
        if len(joints) != len(names):
            raise InputError(f"names has {len(names)} entries, {len(joints)} of them different; expected each joint once")
        own = [joint.name for joint in model.joints if joint.kind != "fixed" and joint.mimics is None]
        foreign = [name for name in names if name not in {joint.name for joint in model.joints}]
        absent = [name for name in own if name not in joints]
        if own and len(absent) == len(own):
            raise InputError(
                f"names has {', '.join(map(repr, names))}: none is a joint of the model, which has {', '.join(map(repr, own))}. "
                "Joints are matched by name; a prefix must be removed"
            )
        if foreign and absent:
            warnings.warn(
                f"no joint of the model: {', '.join(map(repr, foreign))}; without an entry, and at zero: {', '.join(map(repr, absent))}",
                ModelWarning,
                stacklevel=2,
            )
        return cls._of(model, "JointState", len(names), len(names), joints, lambda *_: ("plain", "same"), partial=True)

    @classmethod
    def _of(
        cls,
        model: Model,
        program: str,
        count: int,
        velocities: int,
        joints: Mapping[str, tuple[slice, slice, str]],
        layout: Any,
        partial: bool = False,
        drawn: Mapping[str, tuple[float, ...]] | None = None,
    ) -> Converter:
        blocks: list[_Block] = []
        first_velocity, missing = 0, []
        for joint in model.joints:
            nv = _VELOCITIES[joint.kind]
            own_velocity = slice(first_velocity, first_velocity + nv)
            first_velocity += nv
            own = slice(*joint.positions)
            if own.start == own.stop:
                continue
            if joint.name not in joints:
                if joint.mimics is None and not partial:
                    missing.append(joint.name)
                continue
            q, v, _ = joints[joint.name]
            if q.start == q.stop:
                # A mimic that the other program has no position for.
                continue
            how, twist = layout(joint.kind, q.stop - q.start)
            expected = len(_from_percuss(how, np.zeros(own.stop - own.start)))
            if q.stop - q.start != expected:
                raise InputError(
                    f'joint "{joint.name}" ({joint.kind}) has {q.stop - q.start} positions in {program}; expected {expected}'
                )
            at_zero = (drawn or {}).get(joint.name)
            blocks.append(_Block(joint.name, own, q, own_velocity, v, how, twist, at_zero))
        if missing:
            raise InputError(
                f"{program} has no joint {', '.join(map(repr, missing))}; it has {', '.join(map(repr, joints))}. "
                "Joints are matched by name"
            )
        base = None
        known = {joint.name for joint in model.joints}
        for name, (q, v, kind) in joints.items():
            if name not in known and q.stop - q.start == 7 and ("free" in kind.lower()):
                how, twist = layout("floating", 7)
                base = _Block(name, slice(0, 7), q, slice(0, 6), v, how, twist)
        return cls(model, program, count, velocities, tuple(blocks), base)

    def _own_velocities(self) -> list[tuple[Joint, slice]]:
        """Joints of percuss with the ranges of their velocities."""
        found, first = [], 0
        for joint in self.model.joints:
            found.append((joint, slice(first, first + _VELOCITIES[joint.kind])))
            first = found[-1][1].stop
        return found

    @property
    def velocity_names(self) -> list[str]:
        """Joint of each velocity of percuss, in the order of Model.velocity_names."""
        return [joint.name for joint in self.model.joints for _ in range(_VELOCITIES[joint.kind])]

    def _checked(self, x: ArrayLike, what: str, count: int, program: str) -> _Array:
        found = np.asarray(x, dtype=np.float64)
        if found.ndim == 0 or found.shape[-1] != count:
            raise InputError(f"{what} has shape {found.shape}; expected (..., {count}), the order of {program}")
        return found

    def positions(self, q: ArrayLike) -> _Array:
        """Positions of percuss (..., p) of those of the other program."""
        found = self._checked(q, "q", self.position_count, self.program)
        out = np.zeros((*found.shape[:-1], self.model.position_count))
        for joint in self.model.joints:
            # Quaternions of joints that the other program does not have: no rotation.
            if joint.kind in ("spherical", "floating"):
                out[..., joint.positions[0] + (0 if joint.kind == "spherical" else 3)] = 1.0
        for block in self.blocks:
            out[..., block.own] = block.to_percuss(found[..., block.other])
        return out

    def from_positions(self, q: ArrayLike, base_pose: ArrayLike | None = None) -> _Array:
        """Positions of the other program (..., nq) of those of percuss; base_pose: (..., 7), default: the origin."""
        found = self._checked(q, "q", self.model.position_count, "percuss")
        out = np.zeros((*found.shape[:-1], self.position_count))
        for block in self.blocks:
            out[..., block.other] = block.from_percuss(found[..., block.own])
        if self.base is not None:
            pose = np.asarray([0, 0, 0, 1, 0, 0, 0] if base_pose is None else base_pose, dtype=np.float64)
            out[..., self.base.other] = _from_percuss(self.base.layout, pose)
        return out

    def base_pose(self, q: ArrayLike) -> _Array | None:
        """Pose of the root link (..., 7): x, y, z, w, x, y, z. None if the base of the other program is fixed."""
        found = self._checked(q, "q", self.position_count, self.program)
        return None if self.base is None else _to_percuss(self.base.layout, found[..., self.base.other])

    def velocities(self, v: ArrayLike, q: ArrayLike | None = None) -> _Array:
        """Velocities of percuss (..., n), the order of the gradient of a sweep, of those of the other program.

        Mimic joints follow their masters. The velocity of a floating base is no velocity of a joint: base_velocity has it.
        q: positions of the other program; needed with free and planar joints, whose axes differ.
        """
        found = self._checked(v, "v", self.velocity_count, self.program)
        out = np.zeros((*found.shape[:-1], len(self.velocity_names)))
        own = None if q is None else self.positions(q)
        for block in self.blocks:
            rotation = self._axes(block, own)
            out[..., block.own_velocity] = _twist_to_percuss(block.twist, found[..., block.other_velocity], rotation)
            if block.twist == "planar_child" and own is not None:
                out[..., block.own_velocity] = _plane(out[..., block.own_velocity], own[..., block.own][..., 2], 1.0)
        first = {joint.name: at.start for joint, at in self._own_velocities()}
        for joint, at in self._own_velocities():
            if joint.mimics is not None:
                out[..., at.start] = (joint.multiplier or 0.0) * out[..., first[joint.mimics]]
        return out

    def base_velocity(self, v: ArrayLike, q: ArrayLike | None = None) -> _Array | None:
        """Velocity of the root link (..., 6), as Response.base_velocity: angular, then linear, in the axes of the root link at its origin.

        q: positions of the other program; needed for MuJoCo and Drake, whose axes are those of the world. None if the base of the other
        program is fixed.
        """
        found = self._checked(v, "v", self.velocity_count, self.program)
        if self.base is None:
            return None
        rotation = None
        if self.base.twist != "linear_first":
            if q is None:
                raise InputError(f"the velocity of the base is in other axes in {self.program}; expected q, the positions, too")
            pose = self.base_pose(q)
            rotation = None if pose is None else rotation_of(pose[..., 3:])
        return _twist_to_percuss(self.base.twist, found[..., self.base.other_velocity], rotation)

    def from_velocities(self, v: ArrayLike, q: ArrayLike | None = None) -> _Array:
        """Velocities of the other program (..., nv) of those of percuss; q: positions of percuss."""
        found = self._checked(v, "v", len(self.velocity_names), "percuss")
        own = None if q is None else self._checked(q, "q", self.model.position_count, "percuss")
        out = np.zeros((*found.shape[:-1], self.velocity_count))
        for block in self.blocks:
            part = found[..., block.own_velocity]
            if block.twist == "planar_child" and own is not None:
                part = _plane(part, own[..., block.own][..., 2], -1.0)
            out[..., block.other_velocity] = _twist_from_percuss(block.twist, part, self._axes(block, own))
        return out

    def _axes(self, block: _Block, own: _Array | None) -> _Array | None:
        """Rotation of the child of a free joint; None if both programs use the same axes."""
        if block.twist in ("same", "linear_first"):
            return None
        if own is None:
            raise InputError(
                f'joint "{block.name}": its velocities are in other axes in {self.program}; expected q, the positions, too'
            )
        if block.twist == "planar_child":
            return None
        if block.twist == "ball_parent":
            return rotation_of(own[..., block.own])
        # From the axes of the child to those of the parent of the other program, the world of MuJoCo.
        return rotation_of(_to_percuss(block.layout, block.from_percuss(own[..., block.own]))[..., 3:])


def _unnamed_joint(model: Model, other: Any, number: int) -> str:
    """Name in percuss of a joint without a name in a mujoco.MjModel: found by its body."""
    name = f"joint {number}"
    by_child = {joint.child: joint for joint in model.joints}
    body = int(other.jnt_bodyid[number])
    found = by_child.get(str(other.body(body).name) or f"body{body}")
    # The last joint of a body moves the link of the body, the joints before it massless links; a joint with a position is followed by a
    # fixed one.
    left = int(other.body_jntadr[body]) + int(other.body_jntnum[body]) - 1 - number
    while found is not None and (left > 0 or found.kind == "fixed"):
        left -= found.kind != "fixed"
        found = by_child.get(found.parent)
    return name if found is None or any(joint.name == name for joint in model.joints) else found.name


def _plane(v: _Array, angle: _Array, sense: float) -> _Array:
    """Turns the translation of a planar joint from the axes of the child to those of the joint (sense 1), or back."""
    c, s = np.cos(angle), sense * np.sin(angle)
    x, y = v[..., 0], v[..., 1]
    return np.stack([c * x - s * y, s * x + c * y, v[..., 2]], axis=-1)


def _numbers(values: Iterable[float]) -> str:
    return " ".join(repr(float(x)) for x in values)


def _rpy(rotation: Any) -> tuple[float, float, float]:
    """Roll, pitch, yaw of a rotation matrix."""
    r = np.asarray(rotation, dtype=np.float64)
    pitch = math.atan2(-r[2, 0], math.hypot(r[0, 0], r[1, 0]))
    if math.hypot(r[0, 0], r[1, 0]) < 1e-9:
        # Pitch of a right angle: roll and yaw are about one axis.
        return math.atan2(-r[1, 2], r[1, 1]), pitch, 0.0
    return math.atan2(r[2, 1], r[2, 2]), pitch, math.atan2(r[1, 0], r[0, 0])


def _origin(placement: Any) -> str:
    return f'<origin xyz="{_numbers(placement.translation)}" rpy="{_numbers(_rpy(placement.rotation))}"/>'


def _tensor(i: Any) -> str:
    parts = {"ixx": (0, 0), "ixy": (0, 1), "ixz": (0, 2), "iyy": (1, 1), "iyz": (1, 2), "izz": (2, 2)}
    return "<inertia " + " ".join(f'{name}="{float(i[at])!r}"' for name, at in parts.items()) + "/>"


def from_pinocchio(model: Any, *, name: str | None = None) -> Model:
    """Model of a pinocchio.Model in memory: its joints, inertias, armatures, limits, and body frames as links.

    A free-flyer at the root becomes the base: use Model.system(base="floating"). The link of joint J is named as the body
    frame at J's origin, else J. Raises InputError for composite joints, which URDF does not have.
    """
    axes = {"X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1)}
    bodies: dict[int, list[tuple[str, Any]]] = {}
    for frame in model.frames:
        if "BODY" in str(frame.type):
            bodies.setdefault(int(getattr(frame, "parentJoint", frame.parent if hasattr(frame, "parent") else 0)), []).append(
                (str(frame.name), frame.placement)
            )
    links: dict[int, str] = {}
    lines = [f"<robot name={quoteattr(name or str(model.name) or 'pinocchio')}>"]
    free_base = [i for i in range(1, model.njoints) if model.joints[i].nq == 7 and model.parents[i] == 0]
    root = free_base[0] if free_base else 0
    if free_base and sum(1 for parent in list(model.parents)[1:] if parent == 0) > 1:
        raise InputError("the model has a free-flyer and further joints on the universe; expected one root joint")
    for number in range(int(model.njoints)):
        if number == 0 and root:
            continue
        at_origin = [frame for frame, placed in bodies.get(number, []) if placed.isIdentity(0.0)]
        links[number] = at_origin[0] if at_origin else ("universe" if number == 0 else f"{model.names[number]}_link")
    for number, link in links.items():
        inertia = model.inertias[number]
        mass = float(inertia.mass)
        body = ""
        if mass != 0.0 or np.any(np.asarray(inertia.inertia)):
            com = f'<origin xyz="{_numbers(inertia.lever)}"/>'
            body = f'<inertial>{com}<mass value="{mass!r}"/>{_tensor(np.asarray(inertia.inertia))}</inertial>'
        lines.append(f"<link name={quoteattr(link)}>{body}</link>")
        for frame, placed in bodies.get(number, []):
            if frame != link:
                lines.append(f"<link name={quoteattr(frame)}/>")
                lines.append(
                    f'<joint name={quoteattr(frame + " (frame)")} type="fixed"><parent link={quoteattr(link)}/>'
                    f"<child link={quoteattr(frame)}/>{_origin(placed)}</joint>"
                )
    armature = np.asarray(getattr(model, "armature", np.zeros(model.nv)), dtype=np.float64)
    for number in range(1, int(model.njoints)):
        if number == root:
            continue
        joint, own = model.joints[number], str(model.names[number])
        kind = str(joint.shortname())
        extra = ""
        letters = kind.replace("JointModel", "")
        if letters in ("RX", "RY", "RZ", "RUBX", "RUBY", "RUBZ"):
            axis: Sequence[float] = axes[letters[-1]]
            motion = "continuous" if "UB" in letters else "revolute"
        elif letters in ("PX", "PY", "PZ"):
            axis, motion = axes[letters[-1]], "prismatic"
        elif letters in ("RevoluteUnaligned", "RevoluteUnboundedUnaligned", "PrismaticUnaligned"):
            inner = joint.extract() if hasattr(joint, "extract") else joint
            axis = [float(x) for x in inner.axis]
            motion = "prismatic" if letters.startswith("P") else "continuous" if "Unbounded" in letters else "revolute"
        elif letters == "Spherical":
            axis, motion = (1, 0, 0), "spherical"
        elif letters == "FreeFlyer":
            axis, motion = (1, 0, 0), "floating"
        elif letters == "Planar":
            axis, motion = (0, 0, 1), "planar"
        else:
            raise InputError(
                f'joint "{own}" is a {kind}; expected hinges, slides, balls, planar and free joints. Load the file that the '
                "model was read from"
            )
        if motion in ("revolute", "prismatic"):
            q = int(joint.idx_q)
            low, high = float(model.lowerPositionLimit[q]), float(model.upperPositionLimit[q])
            if math.isfinite(low) and math.isfinite(high) and low <= high:
                extra += f'<limit lower="{low!r}" upper="{high!r}" effort="0" velocity="0"/>'
            elif motion == "revolute":
                motion = "continuous"
        if motion not in ("spherical", "floating"):
            extra += f'<axis xyz="{_numbers(axis)}"/>'
        rotor = armature[int(joint.idx_v) : int(joint.idx_v) + int(joint.nv)]
        if rotor.any() and len(rotor) == 1:
            extra += f'<dynamics armature="{float(rotor[0])!r}"/>'
        parent = links[int(model.parents[number])]
        lines.append(
            f'<joint name={quoteattr(own)} type="{motion}"><parent link={quoteattr(parent)}/>'
            f"<child link={quoteattr(links[number])}/>{_origin(model.jointPlacements[number])}{extra}</joint>"
        )
    lines.append("</robot>")
    return loads("\n".join(lines), name=name or str(model.name) or "pinocchio")


def from_mujoco(model: Any, *, name: str = "mujoco") -> Model:
    """Model of a mujoco.MjModel in memory: bodies, joints, armatures, limits, and connect, weld and joint equalities.

    A body with several joints has massless links between them, as in a file of MuJoCo. Raises InputError for tendons' and
    flexes' equalities.
    """
    mujoco_free, mujoco_kinds = 0, ("free", "ball", "slide", "hinge")

    def quoted(kind: str, number: int) -> str:
        return quoteattr(str(getattr(model, kind)(number).name) or f"{kind} {number}")

    children: dict[int, list[int]] = {}
    for number in range(1, int(model.nbody)):
        children.setdefault(int(model.body_parentid[number]), []).append(number)

    def body(number: int) -> list[str]:
        at = f'pos="{_numbers(model.body_pos[number])}" quat="{_numbers(model.body_quat[number])}"'
        lines = [f"<body name={quoted('body', number)} {at}>"]
        mass = float(model.body_mass[number])
        if mass != 0.0:
            lines.append(
                f'<inertial pos="{_numbers(model.body_ipos[number])}" quat="{_numbers(model.body_iquat[number])}" '
                f'mass="{mass!r}" diaginertia="{_numbers(model.body_inertia[number])}"/>'
            )
        first = int(model.body_jntadr[number])
        for joint in range(first, first + int(model.body_jntnum[number])):
            kind = int(model.jnt_type[joint])
            own = f"name={quoted('joint', joint)}"
            armature = float(model.dof_armature[int(model.jnt_dofadr[joint])])
            if kind == mujoco_free:
                lines.append(f"<freejoint {own}/>")
                continue
            text = f'<joint {own} type="{mujoco_kinds[kind]}" pos="{_numbers(model.jnt_pos[joint])}"'
            text += f' axis="{_numbers(model.jnt_axis[joint])}" armature="{armature!r}"'
            if kind > 1:
                text += f' ref="{float(model.qpos0[int(model.jnt_qposadr[joint])])!r}"'
                if model.jnt_limited[joint]:
                    text += f' limited="true" range="{_numbers(model.jnt_range[joint])}"'
            lines.append(text + "/>")
        for child in children.get(number, []):
            lines += body(child)
        return [*lines, "</body>"]

    lines = [f"<mujoco model={quoteattr(name)}>", '<compiler angle="radian" autolimits="false"/>', "<worldbody>"]
    for child in children.get(0, []):
        lines += body(child)
    lines.append("</worldbody>")
    equalities = []
    for number in range(int(model.neq)):
        if not model.eq_active0[number]:
            continue
        kind, data = int(model.eq_type[number]), model.eq_data[number]
        one, two = int(model.eq_obj1id[number]), int(model.eq_obj2id[number])
        label = f"name={quoted('equality', number)}"
        if kind == 2:
            second = f" joint2={quoted('joint', two)}" if two >= 0 else ""
            equalities.append(
                f'<joint {label} joint1={quoted("joint", one)}{second} polycoef="{_numbers(data[:5])}"/>'
            )
        elif kind in (0, 1) and int(model.eq_objtype[number]) == 1:
            ends = f"body1={quoted('body', one)}" + (f" body2={quoted('body', two)}" if two > 0 else "")
            if kind == 0:
                equalities.append(f'<connect {label} {ends} anchor="{_numbers(data[:3])}"/>')
            else:
                pose = _numbers([*data[3:6], *data[6:10]])
                equalities.append(f'<weld {label} {ends} anchor="{_numbers(data[:3])}" relpose="{pose}"/>')
        else:
            raise InputError(
                f"equality {number} is of type {kind}; expected connect, weld (of bodies) or joint. Load the file that the "
                "model was compiled from"
            )
    if equalities:
        lines += ["<equality>", *equalities, "</equality>"]
    lines.append("</mujoco>")
    return loads("\n".join(lines), name=name)
