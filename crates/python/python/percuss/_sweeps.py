"""Status of results, rows and tables of a sweep."""

from __future__ import annotations

import enum
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ._percuss import Sweep, sweep_of_parts
from ._remarks import RemarkFlags


class Status(enum.IntEnum):
    """Outcome of a contact, as in the status arrays of sweeps, matrices, maps and impacts.

        >>> percuss.Status(percuss.sweep(arm, tool, q).status[0]).name
    """

    FINITE = 0
    """m̄ is finite."""
    IMMOVABLE = 1
    """No admissible motion closes the gap."""
    MASSLESS = 2
    """A motion without energy closes the gap."""
    NO_ANSWER = 3
    """The pose does not exist, or no route solves it."""
    MASSLESS_TO_ROUNDING = 4
    """Massless to rounding only: the error is the largest possible m̄."""


class SweepRow(NamedTuple):
    """Row of a Sweep.

        >>> percuss.sweep(arm, tool, q)[0].effective_mass
    """

    #: m̄, kg; NaN unless finite.
    effective_mass: float
    #: Error of m̄, kg; NaN if unknown.
    error: float
    #: Outcome.
    status: Status
    #: Kinds of findings about the row.
    remarks: RemarkFlags
    #: Gradient by the velocities, (n,); None if not requested.
    gradient: NDArray[np.float64] | None
    #: Gradient by the twist of the root link, (6,); None if not requested.
    base_gradient: NDArray[np.float64] | None
    #: Λ⁻¹, (6, 6); None if not requested.
    inverse_operational_inertia: NDArray[np.float64] | None


def select(sweep: Sweep, rows: Any) -> Sweep | SweepRow:
    """A row by its number, or the sweep of some rows."""
    own, shared = sweep._parts()
    if hasattr(rows, "__index__") and not hasattr(rows, "__len__"):
        number = rows.__index__()
        one: dict[str, Any] = {name: None if part is None else part[number] for name, part in own.items() if name != "index"}
        numbers = {"effective_mass": float(one["effective_mass"]), "error": float(one["error"])}
        return SweepRow(**{**one, **numbers, "status": Status(one["status"]), "remarks": RemarkFlags(int(one["remarks"]))})
    parts: dict[str, Any] = {name: None if part is None else part[rows] for name, part in own.items()}
    parts = {name: np.ascontiguousarray(part) if isinstance(part, np.ndarray) else part for name, part in parts.items()}
    if parts["status"].ndim != 1:
        raise IndexError("expected the number of a row, a slice, an array of numbers, or a mask")
    return sweep_of_parts({**parts, **shared})


def dataframe(sweep: Sweep) -> Any:
    """Table with a row for each configuration; see Sweep.to_dataframe."""
    import pandas as pd

    own, shared = sweep._parts()
    columns: dict[str, Any] = {
        "effective_mass": own["effective_mass"],
        "error": own["error"],
        "status": [Status(code).name for code in own["status"]],
    }
    for flag in RemarkFlags:
        found = own["remarks"] & np.uint32(flag) != 0
        if found.any():
            columns[str(flag.name)] = found
    if own["gradient"] is not None:
        columns |= {f"gradient[{name}]": own["gradient"][:, k] for k, name in enumerate(shared["velocity_names"])}
        if own["base_gradient"] is not None and own["base_gradient"].any():
            columns |= {f"base_gradient[{k}]": own["base_gradient"][:, k] for k in range(6)}
    return pd.DataFrame(columns, index=own["index"])


__all__ = ["Status", "SweepRow", "dataframe", "select"]
