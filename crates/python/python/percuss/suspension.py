"""Suspensions: sheets of hardpoints, templates, wheel angles and motion ratios.

    >>> corner = percuss.suspension.load("models/suspensions/double-wishbone.toml")
    >>> percuss.suspension.kinematics(corner, wheel_travel=[-0.05, 0, 0.05])["camber"]
"""

from __future__ import annotations

import json
import os
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _percuss
from ._arguments import array_of, checked
from ._percuss import Model, Travel
from ._percuss import load_suspension as load
from ._percuss import suspension_template as template
from ._percuss import suspension_templates as templates
from ._request import tables
from .errors import InputError
from .records import KinematicsReport


@dataclass(frozen=True)
class Kinematics:
    """Kinematics of a suspension, one row per value of the variable; SI units, axes of ISO 8855.

    variable: "wheel-travel", "heave", "roll" or "steer"; None for a single row. positions: its values, (rows,) m.
    derivatives: motion of the gradients and ratios, "heave" (all wheels up) or "roll" (left up, right down).
    values: columns by name, (rows,) each, NaN where a quantity is missing; with two wheels the names end in "_left" and
    "_right". units: SI unit of each column, "" for a plain number. missing: reason for each column without values.
    problems: reason for each row without a pose, None for a row with one. report: as ``percuss kinematics --format json``.

        >>> table = percuss.suspension.kinematics(corner, wheel_travel=[-0.05, 0, 0.05])
        >>> table["toe"], table.units["toe"]
    """

    variable: str | None
    positions: NDArray[np.float64]
    derivatives: str
    values: dict[str, NDArray[np.float64]]
    units: dict[str, str]
    missing: dict[str, str]
    problems: list[str | None]
    report: KinematicsReport

    def __getitem__(self, name: str) -> NDArray[np.float64]:
        """Column of a quantity."""
        try:
            return self.values[name]
        except KeyError:
            raise KeyError(f"no column {name!r}; there are: {', '.join(self.values)}") from None

    def __len__(self) -> int:
        return len(self.problems)


@checked
def kinematics(
    model: Model | str | os.PathLike[str],
    *,
    wheel_travel: ArrayLike | None = None,
    heave: ArrayLike | None = None,
    roll: ArrayLike | None = None,
    steer: ArrayLike | None = None,
    axle: str | None = None,
    brake_bias: float | None = None,
    drive_share: float | None = None,
    cg_height: float | None = None,
    wheelbase: float | None = None,
    inboard_brakes: bool = False,
    inboard_drive: bool = False,
    sprung_mass: float | None = None,
    tyre_rate: float | None = None,
    compliance: str | None = None,
    travel_held: bool = False,
) -> Kinematics:
    """Wheel angles, steering axis, roll centre, motion ratios and wheel rates of a suspension. As ``percuss kinematics``.

    The motion ratio of a spring or damper of the length l is i = −dl/dz, and the wheel rate k i² − F d²l/dz², with the
    travel z of the own wheel centre, the rate k and the force F of the spring. The loops are closed, and the derivatives
    are those of the closed linkage: no quantity is a difference of positions.

    model: of ``load_suspension``, or of ``load`` for a sheet; or the path of a file, whose masses may be missing. wheel_travel, heave, roll: travel of the wheel centres
    upward, m, from the design position (roll: left up, right down); steer: travel of the rack to the left, m. One of the
    four may have several values, one for each row.
    axle: "front" or "rear"; brake_bias: share of the front axle in the braking force; drive_share: share of this axle in the
    driving force; cg_height, wheelbase: m; inboard_brakes, inboard_drive: the torque is carried by the body. They give the
    columns anti_dive, anti_lift_braking, anti_squat, anti_lift_driving (1: all load transfer is carried by the links).
    sprung_mass: above one wheel, kg; tyre_rate: N/m, None for a rigid tyre. They give body_frequency and
    wheel_hop_frequency, Hz.
    compliance: "single", "parallel" or "opposed": toe, camber and displacements per load (N, N·m) with the bushes of the sheet, such as
    toe_per_lateral_force, rad/N; travel_held: the heights of the wheel centres are held.

        >>> percuss.suspension.kinematics(corner, wheel_travel=[-0.05, 0, 0.05])["camber"]
    """
    state: list[tuple[str, float]] = []
    ranges: dict[str, list[float]] = {}
    for name, value in (("steer", steer), ("wheel_travel", wheel_travel), ("heave", heave), ("roll", roll)):
        numbers_of = None if value is None else array_of(value, name)
        if numbers_of is None:
            continue
        if not np.isfinite(numbers_of).all():
            raise InputError(f"{name} has a value that is not finite; finite numbers in m are expected")
        if numbers_of.ndim == 0:
            state.append((name.replace("_", "-"), float(numbers_of)))
        elif numbers_of.size == 0:
            raise InputError(f"{name} has no values; give at least one")
        else:
            ranges[name] = numbers_of.ravel().tolist()
    if len(ranges) > 1:
        raise InputError(f"{' and '.join(ranges)} have several values each; only one variable has rows")
    varied = next(((name.replace("_", "-"), values) for name, values in ranges.items()), None)
    vehicle = {
        "axle": axle, "brake_bias": brake_bias, "drive_share": drive_share, "cg_height": cg_height, "wheelbase": wheelbase,
        "inboard_brakes": inboard_brakes, "inboard_drive": inboard_drive, "sprung_mass": sprung_mass, "tyre_rate": tyre_rate,
        "compliance": compliance, "travel_held": travel_held,
    }
    report = KinematicsReport.of(json.loads(_percuss.kinematics(model, (tables(vehicle=vehicle), None, None), state, varied)))
    rows = report["rows"]
    names = [f"{c['quantity']}_{c['side']}" if c["side"] else c["quantity"] for c in report["columns"]]

    def numbers(key: str) -> NDArray[np.float64]:
        found = (row.get(key) for row in rows)
        return np.array([np.nan if x is None else x for x in found], dtype=float)

    return Kinematics(
        variable=report["variable"],
        positions=numbers("variable"),
        derivatives=report["derivatives"],
        values={name: numbers(name) for name in names},
        units={name: column["unit"] for name, column in zip(names, report["columns"])},
        missing={n: c["missing"] for n, c in zip(names, report["columns"]) if c["missing"] is not None},
        problems=[row["problem"] for row in rows],
        report=report,
    )


__all__ = ["Kinematics", "Travel", "kinematics", "load", "template", "templates"]
