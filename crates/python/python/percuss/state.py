"""State of a model, or of many: positions and velocities of all joints, pose and twist of the root link."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arguments import array_of
from ._gradients import rotation_of
from ._percuss import Joint, Model
from .errors import InputError

_Array = NDArray[np.float64]
_ByJoint = Mapping[str, ArrayLike]
#: Velocities of a joint by its kind.
VELOCITIES = {"revolute": 1, "continuous": 1, "prismatic": 1, "planar": 3, "spherical": 3, "floating": 6, "fixed": 0}
#: Largest relative difference between the given velocity of a mimic and that of its master: rounding of sums.
_MIMIC_SLACK = 1e-9
#: Largest difference of the norm of a quaternion from 1, as for base_pose of Model.pose: quaternions rounded to two digits.
_QUATERNION_SLACK = 0.01


def velocity_ranges(model: Model) -> list[tuple[Joint, slice]]:
    """Joints with the ranges of their entries in Model.velocity_names."""
    found, first = [], 0
    for joint in model.joints:
        found.append((joint, slice(first, first + VELOCITIES[joint.kind])))
        first = found[-1][1].stop
    return found


def zero_positions(model: Model, leading: tuple[int, ...] = ()) -> _Array:
    """Positions of all joints at zero (..., p), quaternions without rotation."""
    out = np.zeros((*leading, model.position_count))
    for joint in model.joints:
        if joint.kind in ("spherical", "floating"):
            out[..., joint.positions[0] + (0 if joint.kind == "spherical" else 3)] = 1.0
    return out


def turned(rotation: _Array, v: _Array) -> _Array:
    """Vectors (..., 3) turned by rotations (..., 3, 3)."""
    found: _Array = np.einsum("...ij,...j->...i", rotation, v)
    return found


def follow_masters(model: Model, velocities: _Array, given: frozenset[str]) -> None:
    """Sets the velocities (..., n) of mimics to those of their masters; refuses other velocities of the joints in given."""
    ranges = {joint.name: at for joint, at in velocity_ranges(model)}
    for joint in model.joints:
        if joint.mimics is None:
            continue
        own, master = velocities[..., ranges[joint.name]], velocities[..., ranges[joint.mimics]]
        follows = (joint.multiplier or 0.0) * master
        if joint.name in given and np.any(np.abs(own - follows) > _MIMIC_SLACK * np.abs(follows)):
            raise InputError(
                f'velocities of "{joint.name}": it follows "{joint.mimics}" with the multiplier {joint.multiplier}; expected these '
                f'velocities, or those of "{joint.mimics}" alone in a dict'
            )
        velocities[..., ranges[joint.name]] = follows


class State:
    """State of a model, or N states: in place of q in ``pose``, ``sweep``, ``impacts`` and the reports.

    positions: (..., p), the order of Model.position_names, rad and m, or a dict of joints to positions; None: all joints at zero. Loops are
    not closed: ``State(model, model.pose(q).positions)`` does so. velocities: (..., n), the order of Model.velocity_names, rad/s and m/s, or a
    dict; mimics follow their masters. base_pose: pose of the root link in the world, x, y, z (m), w, x, y, z; (7,) or (..., 7). base_twist:
    velocity of the root link at its origin, angular (rad/s), then linear (m/s); (6,) or (..., 6); in axes of the root link
    (frame="root") or of the world (frame="world"); linear_first=True: linear, then angular. ``converters.Converter.state`` reads the state
    of Pinocchio, MuJoCo, Drake or ROS. Numbers that are not finite are an InputError; nan="no answer" keeps those of positions, for
    ``sweep`` with the same argument.

        >>> state = percuss.State(arm, {"shoulder": 0.4}, velocities={"shoulder": 1.0}, base_twist=[0, 0, 0.5, 0, 0, 0])
        >>> arm.system(base="floating").pose(state).respond(tool).effective_mass
    """

    #: The model.
    model: Model
    #: Positions of all joints; (..., p).
    positions: _Array
    #: Velocities of all joints; (..., n). None if not given.
    velocities: _Array | None
    #: Pose of the root link in the world, x, y, z (m), w, x, y, z; (..., 7). None if not given: the origin of the world.
    base_pose: _Array | None
    #: Twist of the root link at its origin, angular, then linear, in axes of the root link; (..., 6). None if not given.
    base_twist: _Array | None

    def __init__(
        self,
        model: Model,
        positions: ArrayLike | _ByJoint | None = None,
        *,
        velocities: ArrayLike | _ByJoint | None = None,
        base_pose: ArrayLike | None = None,
        base_twist: ArrayLike | None = None,
        frame: Literal["root", "world"] = "root",
        linear_first: bool = False,
        nan: Literal["refuse", "no answer"] = "refuse",
    ) -> None:
        if not isinstance(model, Model):
            raise InputError(f"model is a {type(model).__name__}; expected a Model")
        if nan not in ("refuse", "no answer"):
            raise InputError(f'nan is {nan!r}; expected "refuse" or "no answer"')
        if frame not in ("root", "world"):
            raise InputError(f'frame is {frame!r}; expected "root" or "world"')
        self.model = model
        ranges = velocity_ranges(model)
        places = {joint.name: slice(*joint.positions) for joint in model.joints}
        if positions is None or isinstance(positions, Mapping):
            self.positions = _of_joints(model, positions or {}, places, zero_positions(model), "positions")
            for joint in model.joints:
                if joint.mimics is not None:
                    master = self.positions[places[joint.mimics]]
                    self.positions[places[joint.name]] = (joint.multiplier or 0.0) * master + (joint.offset or 0.0)
        else:
            self.positions = _table(positions, "positions", model.position_count, None)
        if nan == "refuse":
            _refuse_not_finite(self.positions, "positions")
        leading = self.positions.shape[:-1]
        width = len(model.velocity_names)
        if isinstance(velocities, Mapping):
            own = _of_joints(model, velocities, {joint.name: at for joint, at in ranges}, np.zeros(width), "velocities")
            _refuse_not_finite(own, "velocities")
            follow_masters(model, own, frozenset(velocities))
            self.velocities = np.broadcast_to(own, (*leading, width)).copy()
        else:
            self.velocities = None if velocities is None else _table(velocities, "velocities", width, leading)
            if self.velocities is not None:
                _refuse_not_finite(self.velocities, "velocities")
                follow_masters(model, self.velocities, frozenset(joint.name for joint in model.joints))
        self.base_pose = None if base_pose is None else _table(base_pose, "base_pose", 7, leading)
        self.base_twist = None if base_twist is None else _table(base_twist, "base_twist", 6, leading)
        if self.base_pose is not None:
            _refuse_not_finite(self.base_pose, "base_pose")
            norms = np.linalg.norm(self.base_pose[..., 3:], axis=-1)
            if np.any(np.abs(norms - 1) > _QUATERNION_SLACK):
                norm = norms[np.abs(norms - 1) > _QUATERNION_SLACK].flat[0]
                raise InputError(f"base_pose: a quaternion w, x, y, z has norm {norm:g}; expected a unit quaternion")
        if self.base_twist is not None:
            _refuse_not_finite(self.base_twist, "base_twist")
            if linear_first:
                self.base_twist = self.base_twist[..., [3, 4, 5, 0, 1, 2]]
            if frame == "world":
                self.base_twist = self._in_axes(self.base_twist, inverse=True)

    def _in_axes(self, twist: _Array, *, inverse: bool) -> _Array:
        """Twist turned from axes of the root link to those of the world, or back."""
        if self.base_pose is None:
            return twist
        rotation = rotation_of(self.base_pose[..., 3:])
        rotation = np.swapaxes(rotation, -1, -2) if inverse else rotation
        return np.concatenate([turned(rotation, twist[..., :3]), turned(rotation, twist[..., 3:])], axis=-1)

    def twist(self, *, frame: Literal["root", "world"] = "root", linear_first: bool = False) -> _Array:
        """Twist of the root link at its origin (..., 6), in axes of the root link or of the world; zero if not given."""
        if frame not in ("root", "world"):
            raise InputError(f'frame is {frame!r}; expected "root" or "world"')
        found = np.zeros((*self.positions.shape[:-1], 6)) if self.base_twist is None else self.base_twist
        found = self._in_axes(found, inverse=False) if frame == "world" else found
        return found[..., [3, 4, 5, 0, 1, 2]] if linear_first else found

    def by_joint(self) -> dict[str, _Array]:
        """Positions of each movable joint by name; (..., 1), or one entry per position of the joint."""
        return {joint.name: self.positions[..., slice(*joint.positions)] for joint in self.model.joints if joint.kind != "fixed"}

    def __len__(self) -> int:
        if self.positions.ndim == 1:
            raise TypeError("one state has no length; states (N, p) have")
        return len(self.positions)

    def __getitem__(self, rows: Any) -> State:
        """The state of a row, or the states of some rows by a slice, an array of numbers, or a mask."""
        if self.positions.ndim == 1:
            raise InputError("one state has no rows")
        parts = {name: getattr(self, name) for name in ("velocities", "base_pose", "base_twist")}
        own = {name: part[rows] for name, part in parts.items() if part is not None}
        return State(self.model, self.positions[rows], **own, nan="no answer")

    def __iter__(self) -> Iterator[State]:
        return (self[row] for row in range(len(self)))

    def __repr__(self) -> str:
        shape = "1" if self.positions.ndim == 1 else " × ".join(map(str, self.positions.shape[:-1]))
        own = [name for name in ("velocities", "base_pose", "base_twist") if getattr(self, name) is not None]
        return f'<State of "{self.model.name}": {shape}, {", ".join(["positions", *own])}>'


def _table(given: ArrayLike, name: str, width: int, leading: tuple[int, ...] | None) -> _Array:
    """Copy of an array (..., width), with the leading axes of the positions."""
    found = array_of(given, name)
    expected = "(..., " if leading is None else "(" + "".join(f"{n}, " for n in leading)
    if found.ndim == 0 or found.shape[-1] != width or (leading is not None and found.ndim > 1 and found.shape[:-1] != leading):
        either = f"({width},) or " if leading else ""
        raise InputError(f"{name} has shape {found.shape}; expected {either}{expected}{width})")
    return found.copy() if leading is None else np.broadcast_to(found, (*leading, width)).copy()


def _refuse_not_finite(given: _Array, name: str) -> None:
    """Refuses numbers that are not finite, with the place of the first."""
    if not np.isfinite(given).all():
        place = np.argwhere(~np.isfinite(given))[0]
        raise InputError(f"{name}[{', '.join(map(str, place))}] is {given[tuple(place)]}; expected finite numbers")


def _of_joints(model: Model, given: _ByJoint, places: Mapping[str, slice], out: _Array, name: str) -> _Array:
    """Numbers by joint in an array of all."""
    mimics = {joint.name: joint.mimics for joint in model.joints if joint.mimics is not None}
    for joint, values in given.items():
        if joint not in places:
            raise InputError(f"{name}: the model has no joint {joint!r}; it has {', '.join(map(repr, places))}")
        if name == "positions" and joint in mimics:
            raise InputError(f'positions: "{joint}" follows "{mimics[joint]}"; give the position of "{mimics[joint]}"')
        own = np.atleast_1d(array_of(values, f'{name} of "{joint}"'))
        width = places[joint].stop - places[joint].start
        if own.shape != (width,):
            raise InputError(f'{name} of "{joint}" has shape {own.shape}; expected {width} numbers')
        out[places[joint]] = own
    return out


__all__ = ["State"]
