"""Gradient of m̄ by positions, from that by velocities."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arguments import array_of, checked
from ._percuss import Model
from .errors import InputError

_Array = NDArray[np.float64]
#: Velocities of a joint by its kind, if they are not as many as its positions.
_TURNING = {"spherical": 3, "floating": 6}


def multipliers(model: Model) -> dict[str, float]:
    """Multiplier of every mimic by its master's position."""
    mimics = [joint for joint in model.joints if joint.mimics]
    if mimics and model.closures:
        raise InputError(
            f'the model has loops and "{mimics[0].name}" mimics "{mimics[0].mimics}": gradients by positions are not '
            "defined; use Sweep.gradient with velocities"
        )
    return {joint.name: joint.multiplier or 0.0 for joint in mimics}


def _columns(quaternion: _Array) -> _Array:
    """E (..., 4, 3) with q̇ = ½ E ω, ω in the axes of the child."""
    w, x, y, z = np.moveaxis(quaternion, -1, 0)
    rows = [[-x, -y, -z], [w, -z, y], [z, w, -x], [-y, x, w]]
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def rotation_of(quaternion: _Array) -> _Array:
    """Rotation matrices (..., 3, 3) of unit quaternions w, x, y, z."""
    w, x, y, z = np.moveaxis(quaternion, -1, 0)
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


@checked
def position_gradient(model: Model, q: ArrayLike, gradient: ArrayLike) -> _Array:
    """Gradient of m̄ by the positions q (..., p), from that by the velocities (..., n), as Sweep.gradient has it.

    dm̄ = g · dq for every change of q that keeps quaternions at unit length; their part of g is tangent to the unit sphere.
    Mimics are not read: their part is added to that of their masters.

        >>> percuss.converters.position_gradient(arm, q, percuss.sweep(arm, tool, q, gradient=True).gradient)
    """
    positions, by_velocity = array_of(q, "q"), array_of(gradient, "gradient")
    widths = (model.position_count, len(model.velocity_names))
    is_table = min(positions.ndim, by_velocity.ndim) > 0 and (positions.shape[-1], by_velocity.shape[-1]) == widths
    if not is_table or positions.shape[:-1] != by_velocity.shape[:-1]:
        raise InputError(
            f"q has shape {positions.shape} and gradient {by_velocity.shape}; expected (..., {model.position_count}) and "
            f"(..., {len(model.velocity_names)})"
        )
    out = np.zeros(positions.shape)
    factors = multipliers(model)
    starts = {joint.name: joint.positions[0] for joint in model.joints}
    first = 0
    for joint in model.joints:
        start, stop = joint.positions
        count = _TURNING.get(joint.kind, stop - start)
        own = by_velocity[..., first : first + count]
        first += count
        if joint.mimics:
            out[..., starts[joint.mimics]] += factors[joint.name] * own[..., 0]
        elif joint.kind == "spherical":
            out[..., start:stop] = 2 * np.einsum("...ij,...j->...i", _columns(positions[..., start:stop]), own)
        elif joint.kind == "floating":
            quaternion = positions[..., start + 3 : stop]
            out[..., start : start + 3] = np.einsum("...ij,...j->...i", rotation_of(quaternion), own[..., 3:])
            out[..., start + 3 : stop] = 2 * np.einsum("...ij,...j->...i", _columns(quaternion), own[..., :3])
        else:
            out[..., start:stop] += own
    return out


def mass_and_gradient(
    model: Model, system: Any, contact: Any, q: _Array, options: dict[str, Any], *, gradient: bool
) -> tuple[_Array, _Array]:
    """m̄ of an array of positions (..., p), and its gradient (..., p) if wanted."""
    from ._percuss import sweep

    positions = np.ascontiguousarray(q, dtype=np.float64)
    if positions.ndim == 0 or positions.shape[-1] != model.position_count:
        raise InputError(f"q has shape {positions.shape}; expected (..., {model.position_count})")
    rows = positions.reshape(-1, model.position_count)
    swept = sweep(system, contact, rows, gradient=gradient, **options)
    mass = swept.effective_mass.reshape(positions.shape[:-1])
    if not gradient:
        return mass, np.zeros(0)
    return mass, position_gradient(model, rows, swept.gradient).reshape(positions.shape)


def model_of(model: Any) -> Model:
    """Model of a Model, System or Assembly."""
    found = model if isinstance(model, Model) else model.model
    assert isinstance(found, Model)
    return found


__all__ = ["mass_and_gradient", "model_of", "multipliers", "position_gradient", "rotation_of"]
