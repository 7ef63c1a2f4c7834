"""Contact laws: dampers for a coefficient of restitution, impacts in time, parameters of simulators.

    >>> law = percuss.contact_law.Damping(restitution=0.3, stiffness=2e5, speed=1.0, tools=["mujoco"])
    >>> percuss.contact_law.damp(2.0, law).damping          # N·s/m for an effective mass of 2 kg
"""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _percuss, records
from ._arguments import array_of, checked
from ._percuss import Assembly, Contact, Model, System, laws, tools
from ._request import OF_SIMULATORS, Conditions, Damping, Of, asked, of_contacts, tables
from .errors import InputError
from .state import State


class FrictionThresholds(NamedTuple):
    """Coefficients of friction at which the behaviour of a contact changes, at N positions; (N,) each.

    >>> percuss.contact_law.friction_thresholds(arm, tool, q).sticking
    """

    slope: NDArray[np.float64]
    """Sliding speed per closing speed of a contact with one relative motion; NaN for others."""
    sticking: NDArray[np.float64]
    """Coefficient from which the contact can stick; NaN with one relative motion, and if no friction suffices."""
    jamming: NDArray[np.float64]
    """Coefficient from which sliding can jam, or from which one relative motion wedges; NaN if no friction suffices."""


@checked
def friction_thresholds(
    model: Model | System | Assembly,
    contact: Contact | str,
    q: ArrayLike | State,
    *,
    base_pose: ArrayLike | None = None,
    threads: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> FrictionThresholds:
    """Coefficients of friction at which a contact can stick or jam, at the rows of q (N, p) with closed loops, or at the states of a State.

    µ_s = |A_tt⁻¹ a_tn| and µ_j = a_nn/|a_tn|, with the blocks of the mobility of the contact point; 1/t for one relative motion with the
    slope t (Stronge 2000, ch. 5). NaN in all three for rows without a finite m̄ and for singular poses. base_pose, threads, progress: as for
    ``sweep``. ``reports.friction_thresholds`` is the report of one pose.

        >>> percuss.contact_law.friction_thresholds(arm, tool, q).jamming
    """
    if isinstance(q, State):
        if base_pose is not None:
            raise InputError("base_pose: the State has its own; expected a State without base_pose, or no base_pose")
        base_pose = q.base_pose
        q = q.positions
    base = None if base_pose is None else array_of(base_pose, "base_pose")
    # Columns of a table are matched by their names.
    rows = q if hasattr(q, "columns") else np.atleast_2d(array_of(q, "q"))
    found = _percuss.friction_rows(model, contact, rows, base, threads, progress)
    return FrictionThresholds(*np.ascontiguousarray(found.T))


@checked
def damp(mass: float, damping: Damping) -> records.DampingReport:
    """Damper for an effective mass (kg), and parameters for simulators. As ``percuss damp --mass``.

        >>> percuss.contact_law.damp(2.0, law).damping
    """
    return records.DampingReport.of(json.loads(_percuss.damp_mass(mass, (tables(**damping._tables()), None, None))))


@of_contacts
def damp_contact(
    model: Of, contact: Contact | str, damping: Damping, conditions: Conditions | None = None
) -> records.DampingReport:
    """Damper for a contact of a model, and its changes over the penetration. As ``percuss damp --mass-from``.

        >>> percuss.contact_law.damp_contact(arm, tool, law).damping
    """
    model, request = asked(model, contact, conditions, **damping._tables())
    return records.DampingReport.of(json.loads(_percuss.damp(model, request)))


@checked
def damp_stop(
    model: Of,
    joint: str,
    damping: Damping,
    conditions: Conditions | None = None,
    *,
    end: Literal["lower", "upper"] | None = None,
) -> records.DampingReport:
    """Damper for a joint's stop, at the joint's position or at an end of its range ("lower", "upper"). As ``percuss
    damp --limit``.

        >>> percuss.contact_law.damp_stop(arm, "elbow", percuss.contact_law.Damping(0.5, 1e3, speed=1.0), end="upper").damping
    """
    damping._refuse("own_mass", "other_own_mass")
    stop = joint if end is None else f"{joint}:{end}"
    model, request = asked(model, None, conditions, reads=("against_mass",), **damping._tables(stop))
    return records.DampingReport.of(json.loads(_percuss.damp(model, request)))


@checked
def impact_history(mass: float, damping: Damping, samples: int = 200) -> NDArray[np.float64]:
    """Impact of a mass (kg) over time, with the approach speed damping.speed. Returns (samples, 4): time (s),
    penetration (m), penetration rate (m/s), force (N).

        >>> time, penetration, rate, force = percuss.contact_law.impact_history(2.0, law).T
    """
    damping._refuse(*OF_SIMULATORS)
    return _percuss.impact_history(mass, (tables(**damping._tables()), None, None), samples)


__all__ = ["Damping", "FrictionThresholds", "damp", "damp_contact", "damp_stop", "friction_thresholds", "impact_history", "laws", "tools"]
