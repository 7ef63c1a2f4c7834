"""Contact laws: dampers for a coefficient of restitution, impacts in time, parameters of simulators.

    >>> law = percuss.contact_law.Damping(restitution=0.3, stiffness=2e5, speed=1.0, tools=["mujoco"])
    >>> percuss.contact_law.damp(2.0, law).damping          # N·s/m for an effective mass of 2 kg
"""

from __future__ import annotations

import json
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from . import _percuss, records
from ._arguments import checked
from ._percuss import Contact, laws, tools
from ._request import Conditions, Damping, Of, asked, tables


@checked
def damp(mass: float, damping: Damping) -> records.DampingReport:
    """Damper for an effective mass (kg), and parameters for simulators. As ``percuss damp --mass``.

        >>> percuss.contact_law.damp(2.0, law).damping
    """
    return records.DampingReport.of(json.loads(_percuss.damp_mass(mass, (tables(**damping._tables()), None, None))))


@checked
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
    model, request = asked(model, None, conditions, **damping._tables(joint if end is None else f"{joint}:{end}"))
    return records.DampingReport.of(json.loads(_percuss.damp(model, request)))


@checked
def impact_history(mass: float, damping: Damping, samples: int = 200) -> NDArray[np.float64]:
    """Impact of a mass (kg) over time, with the approach speed damping.speed. Returns (samples, 4): time (s),
    penetration (m), penetration rate (m/s), force (N).

        >>> time, penetration, rate, force = percuss.contact_law.impact_history(2.0, law).T
    """
    return _percuss.impact_history(mass, (tables(**damping._tables()), None, None), samples)


__all__ = ["Damping", "damp", "damp_contact", "damp_stop", "impact_history", "laws", "tools"]
