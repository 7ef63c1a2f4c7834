"""Impacts of many states, and safe speeds of many masses."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _percuss
from ._arguments import array_of, checked
from ._percuss import Assembly, Contact, Model, Sweep, System
from .errors import InputError
from .reports import limit_of
from .state import State

_Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Impacts:
    """Impacts of k contacts at N states, as ``impacts`` returns them; NaN in rows without a result.

        >>> found = percuss.impacts(arm, tool, percuss.State(arm, q, velocities=np.ones((len(q), 6))))
        >>> found.normal_impulses, found.velocities
    """

    status: NDArray[np.uint8]
    """Status of each row: FINITE, or NO_ANSWER; (N,)."""
    reasons: list[tuple[int, str]]
    """Rows without a result, and the reason."""
    closing_speeds: _Array
    """Closing speed of each contact before the impact, m/s (rad/s for a moment); negative if it opens; (N, k). Without a positive one there
    is no impact, and the impulses are zero."""
    impulses: _Array
    """Impulse on each contact link, N·s (N·m·s), axes of the world; of least norm if redundant contacts leave it open; (N, k, 3)."""
    normal_impulses: _Array
    """Normal impulse of each contact, N·s (N·m·s); NaN if redundant contacts leave it open; (N, k)."""
    sticks: NDArray[np.bool_]
    """True for the contacts that stick, with the law "sticking"; (N, k)."""
    velocities: _Array
    """Velocities of all joints after the impact, in the order of Model.velocity_names; (N, n)."""
    base_twist: _Array
    """Twist of a floating root link after the impact, as State.base_twist; (N, 6)."""
    energy_loss: _Array
    """Lost kinetic energy, J; (N,)."""
    impact_map: _Array | None
    """Δ of u⁺ = Δ u⁻ over the coordinates u of System.coordinate_joints, with the law "sticking"; (N, c, c). None if not requested."""
    reactions: _Array | None
    """Impulse (N·s), then moment (N·m·s), of the parent on the child link of each joint, about the origin of the child link; axes: two
    transverse directions and the axis of the joint, those of the link without an axis; NaN if open; (N, joints, 6). None if not requested."""

    def __len__(self) -> int:
        return len(self.status)

    def __repr__(self) -> str:
        return f"<Impacts: {len(self)} states, {self.normal_impulses.shape[1]} contacts, {int((self.status == 0).sum())} with a result>"


@checked
def impacts(
    model: Model | System | Assembly,
    contacts: Contact | str | Sequence[Contact | str],
    state: State,
    *,
    restitution: float | Sequence[float] = 0.0,
    law: Literal["newton", "poisson", "energetic", "sticking"] = "newton",
    reactions: bool = False,
    impact_map: bool = False,
    threads: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Impacts:
    """Rigid impacts of contacts that touch at the same time, at each of N states with velocities.

    p = (1 + e) m̄ c for one contact. law: of several contacts without friction, "newton" (0 ≤ u⁺ + e min(u⁻, 0) ⊥ P ≥ 0), "poisson" or
    "energetic" (equal stiffnesses); "sticking": the plastic impact in which the points stick, u⁺ = 0, unless a contact would pull.
    restitution: e, one number, or one for each contact; 0 for "sticking". reactions, impact_map: True also computes Impacts.reactions and
    Impacts.impact_map. threads, progress: as for ``sweep``. Raises InputError for velocities that open loops or move locked joints, and for
    a moving root link that is fixed.

        >>> state = percuss.State(arm, q, velocities=np.zeros((len(q), 6)), base_twist=[0, 0, 0, 0, 0, -1])     # N states
        >>> feet = [percuss.Contact("tool", [x, 0.02, 0], [0, 0, -1], normal_frame="world") for x in (0.0, 0.08)]
        >>> landed = percuss.impacts(arm.system(base="floating"), feet, state, law="sticking")
        >>> landed.velocities, landed.base_twist, landed.normal_impulses
    """
    given = [contacts] if isinstance(contacts, (Contact, str)) else list(contacts)
    if not given:
        raise InputError("contacts is empty; expected at least one")
    each = array_of(restitution, "restitution")
    if each.shape not in ((), (len(given),)):
        raise InputError(f"restitution has shape {each.shape}; expected one number, or {len(given)}: one for each contact")
    if not ((each >= 0) & (each <= 1)).all():
        raise InputError(f"restitution is {restitution}; expected 0 to 1")
    if law == "sticking" and each.any():
        raise InputError("restitution: contacts that stick have none; expected 0, or another law")
    if impact_map and law != "sticking":
        raise InputError('impact_map: without friction the map depends on the contacts that close; expected law="sticking"')
    own = model if isinstance(model, Model) else model.model
    if own.position_names != state.model.position_names:
        raise InputError(f'model is "{own.name}", and the state is of "{state.model.name}"; expected the same joints')
    if state.velocities is None:
        raise InputError("state has no velocities; expected State(model, q, velocities=…)")
    if state.positions.ndim > 2:
        raise InputError(f"state has positions of the shape {state.positions.shape}; expected (p,) or (N, p)")

    def rows(part: _Array | None) -> _Array | None:
        return None if part is None else np.atleast_2d(part)

    found = _percuss.impact_rows(
        model, given, np.atleast_2d(state.positions), np.atleast_2d(state.velocities), rows(state.base_pose), rows(state.base_twist),
        np.broadcast_to(each, (len(given),)).tolist(), law, (reactions, impact_map), threads, progress,
    )  # fmt: skip
    return Impacts(**{"impact_map": None, "reactions": None, **found})


@checked
def safe_speeds(
    mass: ArrayLike | Sweep,
    region: str | None,
    *,
    force: float | None = None,
    pressure: float | None = None,
    area: float | None = None,
    energy: float | None = None,
    momentum: float | None = None,
) -> _Array:
    """Safe speeds (m/s) of many effective masses (kg) in a possible impact with a person, in the shape of mass.

    v = F / √(μ k) with μ = 1/(1/m_H + 1/m̄), from one limit: force (N), pressure (Pa) with area (m²), energy (J) or momentum (N·s). region,
    limits: as for ``safe_speed``. mass: an array, inf for an immovable robot; or a Sweep, of which each mass is increased by its error.
    NaN for NaN and for rows without an upper bound of m̄.

        >>> limits = percuss.safe_speeds(percuss.sweep(arm, tool, q), "chest", force=140.0)
    """
    limit_of(region, force, pressure, area, energy, momentum)
    if isinstance(mass, Sweep):
        # The error of a mass that is massless to rounding bounds the mass.
        bounds = {0: mass.effective_mass + mass.error, 1: np.full(len(mass), np.inf), 4: mass.error}
        masses = np.select([mass.status == code for code in bounds], list(bounds.values()), np.nan)
    else:
        masses = array_of(mass, "mass")
    flat = np.ascontiguousarray(masses).ravel()
    return _percuss.safe_speeds(flat, region, (force, pressure, area, energy, momentum)).reshape(masses.shape)


__all__ = ["Impacts", "impacts", "safe_speeds"]
