"""Positions and velocities of other programs in the order of percuss, and models from their memory.

    >>> converter = percuss.converters.Converter.of_pinocchio(model, pinocchio_model)
    >>> state = converter.state(pinocchio_q, pinocchio_v)     # (..., nq), (..., nv): one state or many
    >>> percuss.sweep(model, contact, state)
    >>> q, v = converter.of_state(state)                      # and back

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

The free joint of the root link of a floating model is no joint of percuss: it is base_pose and base_twist of a State. Mimic joints
follow their masters and are not read. prefix="left_": joints of the other program have this prefix, and joints without it are of other
robots.
"""

from __future__ import annotations

import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._from_memory import from_mujoco, from_pinocchio
from ._gradients import position_gradient, rotation_of
from ._percuss import Model
from ._usd import from_usd
from .errors import InputError, ModelWarning
from .state import VELOCITIES, State, follow_masters, turned, velocity_ranges, zero_positions

__all__ = ["Converter", "from_mujoco", "from_pinocchio", "from_usd", "position_gradient"]

_Array = NDArray[np.float64]


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
        return np.concatenate([turned(back, found[..., :3] - drawn[:3]), _product(inverse, found[..., 3:])], axis=-1)

    def from_percuss(self, x: _Array) -> _Array:
        found = x
        if self.drawn is not None and len(self.drawn) == 1:
            found = x + self.drawn[0]
        elif self.drawn is not None:
            drawn = np.asarray(self.drawn)
            moved = turned(rotation_of(drawn[3:]), x[..., :3]) + drawn[:3]
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


def _twist_to_percuss(twist: str, v: _Array, rotation: _Array | None) -> _Array:
    """Angular, then linear velocity in the axes of the child."""
    if twist == "linear_first":
        return v[..., [3, 4, 5, 0, 1, 2]]
    if twist in ("same", "planar_child") or rotation is None:
        return v
    back = np.swapaxes(rotation, -1, -2)
    if twist == "ball_parent":
        return turned(back, v)
    if twist == "linear_parent":
        return np.concatenate([v[..., 3:], turned(back, v[..., :3])], axis=-1)
    return np.concatenate([turned(back, v[..., :3]), turned(back, v[..., 3:])], axis=-1)


def _twist_from_percuss(twist: str, v: _Array, rotation: _Array | None) -> _Array:
    if twist == "linear_first":
        return v[..., [3, 4, 5, 0, 1, 2]]
    if twist in ("same", "planar_child") or rotation is None:
        return v
    if twist == "ball_parent":
        return turned(rotation, v)
    if twist == "linear_parent":
        return np.concatenate([turned(rotation, v[..., 3:]), v[..., :3]], axis=-1)
    return np.concatenate([turned(rotation, v[..., :3]), turned(rotation, v[..., 3:])], axis=-1)


@dataclass(frozen=True)
class Converter:
    """Converts positions and velocities between another program and percuss; any number of leading axes.

    >>> percuss.converters.Converter.of_joint_state(arm, ["elbow", "yaw"]).state([0.3, -0.2]).by_joint()["elbow"]
    """

    model: Model
    program: str
    #: Numbers of positions and velocities of the other program.
    position_count: int
    velocity_count: int
    blocks: tuple[_Block, ...]
    base: _Block | None = field(default=None)

    @classmethod
    def of_pinocchio(cls, model: Model, other: Any, *, prefix: str = "") -> Converter:
        """For a pinocchio.Model with joints of the same names.

        A free joint without a joint of its name in percuss is that of the base. A ModelWarning names mimics that move independently in the
        other model: pinocchio.buildModelFromUrdf(path, mimic=True) reads them.
        """
        joints: dict[str, tuple[slice, slice, str]] = {}
        masters = {joint.name: joint.mimics for joint in model.joints if joint.mimics}
        for number in range(1, int(other.njoints)):
            joint = other.joints[number]
            if int(joint.nv) > 0 and (master := masters.get(str(other.names[number]).removeprefix(prefix))):
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

        return cls._of(model, "Pinocchio", int(other.nq), int(other.nv), joints, layout, prefix=prefix)

    @classmethod
    def of_mujoco(cls, model: Model, other: Any, *, prefix: str = "") -> Converter:
        """For a mujoco.MjModel with joints of the same names; joints without a name are found by their body. A free joint of another name is
        that of the base."""
        joints: dict[str, tuple[slice, slice, str]] = {}
        # In percuss, and in its reader of MJCF, a joint is at zero as drawn.
        drawn: dict[str, tuple[float, ...]] = {}
        # Free, ball, slide, hinge: mjtJoint.
        widths = [(7, 6), (4, 3), (1, 1), (1, 1)]
        for number in range(int(other.njnt)):
            name, kind = str(other.joint(number).name), int(other.jnt_type[number])
            q, v = int(other.jnt_qposadr[number]), int(other.jnt_dofadr[number])
            nq, nv = widths[kind]
            name = name or prefix + _unnamed_joint(model, other, number, prefix)
            joints[name] = (slice(q, q + nq), slice(v, v + nv), "free" if kind == 0 else "")
            if kind != 1:
                drawn[name] = tuple(float(x) for x in other.qpos0[q : q + nq])

        def layout(kind: str, _: int) -> tuple[str, str]:
            return "plain", ("linear_parent" if kind == "floating" else "same")

        return cls._of(model, "MuJoCo", int(other.nq), int(other.nv), joints, layout, drawn=drawn, prefix=prefix)

    @classmethod
    def of_drake(cls, model: Model, plant: Any, instance: Any = None, *, prefix: str = "") -> Converter:
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
        return cls._of(model, "Drake", count, velocities, joints, layout, prefix=prefix)

    @classmethod
    def of_joint_state(cls, model: Model, names: Sequence[str], *, prefix: str = "") -> Converter:
        """For the joints named in a ROS sensor_msgs/JointState: positions and velocities in the order of its name field.

        Joints without an entry are at zero; entries of other joints (of other robots) are ignored. A ModelWarning names both if there are
        both. Raises InputError if no name is that of a joint.

            >>> converter = Converter.of_joint_state(model, message.name, prefix="left_")
            >>> state = converter.state(message.position, message.velocity)
        """
        joints = {name: (slice(k, k + 1), slice(k, k + 1), "") for k, name in enumerate(names)}
        if len(joints) != len(names):
            raise InputError(f"names has {len(names)} entries, {len(joints)} of them different; expected each joint once")
        own = [joint.name for joint in model.joints if joint.kind != "fixed" and joint.mimics is None]
        of_model = {prefix + joint.name for joint in model.joints}
        foreign = [name for name in names if name not in of_model and name.startswith(prefix)]
        absent = [name for name in own if prefix + name not in joints]
        if own and len(absent) == len(own):
            raise InputError(
                f"names has {', '.join(map(repr, names))}: none is a joint of the model, which has {', '.join(map(repr, own))}. "
                f"Joints are matched by name{f' after the prefix {prefix!r}' if prefix else '; prefix= names a prefix'}"
            )
        if foreign and absent:
            warnings.warn(
                f"no joint of the model: {', '.join(map(repr, foreign))}; without an entry, and at zero: {', '.join(map(repr, absent))}",
                ModelWarning,
                stacklevel=2,
            )
        return cls._of(
            model, "JointState", len(names), len(names), joints, lambda *_: ("plain", "same"), partial=True, prefix=prefix
        )

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
        prefix: str = "",
    ) -> Converter:
        blocks: list[_Block] = []
        missing = []
        for joint, own_velocity in velocity_ranges(model):
            own, other_name = slice(*joint.positions), prefix + joint.name
            if own.start == own.stop:
                continue
            if other_name not in joints:
                if joint.mimics is None and not partial:
                    missing.append(other_name)
                continue
            q, v, _ = joints[other_name]
            if q.start == q.stop:
                # A mimic that the other program has no position for.
                continue
            how, twist = layout(joint.kind, q.stop - q.start)
            expected = len(_from_percuss(how, np.zeros(own.stop - own.start)))
            if q.stop - q.start != expected:
                raise InputError(
                    f'joint "{joint.name}" ({joint.kind}) has {q.stop - q.start} positions in {program}; expected {expected}'
                )
            at_zero = (drawn or {}).get(other_name)
            blocks.append(_Block(joint.name, own, q, own_velocity, v, how, twist, at_zero))
        if missing:
            raise InputError(
                f"{program} has no joint {', '.join(map(repr, missing))}; it has {', '.join(map(repr, joints))}. "
                "Joints are matched by name"
            )
        known = {prefix + joint.name for joint in model.joints}
        free = [name for name, (q, _, kind) in joints.items() if name not in known and q.stop - q.start == 7 and "free" in kind.lower()]
        free = [name for name in free if name.startswith(prefix)] or free
        base = None
        if len(free) > 1:
            raise InputError(
                f"{program} has several free joints that are none of the model: {', '.join(map(repr, free))}; expected one, of the base. "
                "prefix= selects the joints of one robot"
            )
        for name in free:
            q, v, _ = joints[name]
            base = _Block(name, slice(0, 7), q, slice(0, 6), v, *layout("floating", 7))
        return cls(model, program, count, velocities, tuple(blocks), base)

    def __repr__(self) -> str:
        base = "" if self.base is None else ", floating base"
        return f'<Converter of "{self.model.name}" and {self.program}: {len(self.blocks)} joints{base}>'

    @property
    def velocity_names(self) -> list[str]:
        """Joint of each velocity of percuss, in the order of Model.velocity_names."""
        return [joint.name for joint in self.model.joints for _ in range(VELOCITIES[joint.kind])]

    def state(self, q: ArrayLike, v: ArrayLike | None = None, *, nan: Literal["refuse", "no answer"] = "refuse") -> State:
        """State of percuss at positions q (..., nq) and velocities v (..., nv) of the other program, in its order: joints, base, mimics.
        nan: as for State."""
        found = self._checked(q, "q", self.position_count, self.program)
        velocities = None if v is None else self.velocities(v, found)
        twist = None if v is None else self.base_velocity(v, found)
        base = self.base_pose(found)
        return State(self.model, self.positions(found), velocities=velocities, base_pose=base, base_twist=twist, nan=nan)

    def of_state(self, state: State) -> tuple[_Array, _Array | None]:
        """Positions (..., nq) and velocities (..., nv; None if the state has none) of the other program at a State."""
        q = self.from_positions(state.positions, state.base_pose)
        if state.velocities is None and state.base_twist is None:
            return q, None
        velocities = np.zeros((*q.shape[:-1], len(self.velocity_names))) if state.velocities is None else state.velocities
        v = self.from_velocities(velocities, state.positions)
        if self.base is None:
            return q, v
        pose = np.array([0.0, 0, 0, 1, 0, 0, 0]) if state.base_pose is None else state.base_pose
        v[..., self.base.other_velocity] = _twist_from_percuss(self.base.twist, state.twist(), rotation_of(pose[..., 3:]))
        return q, v

    def _checked(self, x: ArrayLike, what: str, count: int, program: str) -> _Array:
        found = np.asarray(x, dtype=np.float64)
        if found.ndim == 0 or found.shape[-1] != count:
            raise InputError(f"{what} has shape {found.shape}; expected (..., {count}), the order of {program}")
        return found

    def positions(self, q: ArrayLike) -> _Array:
        """Positions of percuss (..., p) of those of the other program."""
        found = self._checked(q, "q", self.position_count, self.program)
        # Joints that the other program does not have are at zero.
        out = zero_positions(self.model, found.shape[:-1])
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
        follow_masters(self.model, out, frozenset())
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
        """Velocities of the other program (..., nv) of those of percuss; q: positions of percuss. A floating base is at rest: of_state has its
        velocity."""
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


def _unnamed_joint(model: Model, other: Any, number: int, prefix: str) -> str:
    """Name in percuss of a joint without a name in a mujoco.MjModel: found by its body."""
    name = f"joint {number}"
    by_child = {joint.child: joint for joint in model.joints}
    body = int(other.jnt_bodyid[number])
    found = by_child.get(str(other.body(body).name).removeprefix(prefix) or f"body{body}")
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
