"""Records of reports: SweepReport, ComparisonReport, KinematicsReport. Written by tests/records.py."""

from __future__ import annotations

from typing import Literal

from .damping import DiagnosticRecord, Input
from .record import Record


class VariedColumn(Record):
    """Varied column: a component of a joint position, or the travel of a point."""

    name: str
    """Name of the column: the joint; "JOINT[0]", "JOINT[1]", … for a joint with several numbers; or "travel:LINK"."""
    unit: str
    """"rad" or "m"; empty for the components of a quaternion."""


class SweepRow(Record):
    """A row of a sweep."""

    _answer = {"row": "", "effective_mass": "", "status": ""}

    row: int
    """Number of the row, from 0."""
    varied: dict[str, float]
    """The varied numbers, rad or m, by name."""
    status: str
    """"finite", "immovable", "massless"; "unreachable" if the pose does not exist; "no answer"."""
    effective_mass: float | None
    """m̄, kg; None unless finite."""
    effective_mass_error: float | None
    """First-order error bound of m̄, kg."""
    closure_residual: float | None
    """Closure residual of the loops, m; None without loops."""
    singular_pose: bool | None
    """True if the pose is singular."""
    motion_ratio: float | None
    """Motion ratio: closing of the contact per travel of the point along its direction; without a travel, per travel of the
    estimate's point."""
    estimate: float | None
    """The classical estimate, kg."""
    estimate_error_percent: float | None
    """Difference of the estimate from m̄, per cent."""
    gap: float | None
    """Gap of the named contact at the pose of the row, m, negative for a penetration; None without a pose. The key is absent
    for a contact without a gap."""
    gradient: dict[str, list[float]] | None
    """Gradient of m̄, one number per velocity of every movable joint, kg/rad or kg/m; empty unless m̄ is finite. The key is
    absent unless gradients are requested."""
    pose: dict[str, list[float]]
    """Position of every movable joint; empty if the pose was not reached."""
    error: str | None
    """Reason for a missing result."""


class SweepReport(Record):
    """A sweep with all its rows."""

    _answer = {"link": "", "rows": ""}

    schema: str
    """"percuss.sweep/2"."""
    percuss: str
    """Version of percuss."""
    inputs: list[Input]
    """Input files: model, study, and file of positions."""
    varied: list[VariedColumn]
    """Varied columns; for a grid the slowest range is first."""
    continuation: Literal["path", "lines", "independent"]
    """Continuation of the rows."""
    seed: int | None
    """Seed of the random positions; None without random positions."""
    link: str
    """Contact link."""
    unit: str
    """Unit of all effective masses: "kg"; "kg·m²" for a moment about an axis, and for the stop of a revolute joint."""
    motion_ratio_of: str | None
    """Travel of the motion ratio: the name of the varied travel, or "estimate" for the point of the estimate. The ratio of one
    point holds for the motion of the impact (with a sliding rack held, and without spin of a wheel with the contact on it).
    The ratio of "heave" or "roll" holds for this motion of the wheels, per upward travel of the wheel on the side of the
    contact. The key is absent without a motion ratio."""
    rows: list[SweepRow]
    """All rows."""
    diagnostics: list[DiagnosticRecord]
    """Findings about the file and the rows."""


class DesignChange(Record):
    """Difference of a design from its reference."""

    kind: Literal["point", "mass", "centre_of_mass", "inertia", "gap", "link", "contact", "pose", "conditions"]
    """Kind of the difference."""
    name: str
    """Name of the link, the hardpoint, or the contact of a gap; empty for the contact, the pose and the conditions of the
    question."""
    reference: list[float] | None
    """Value of the reference, kg, kg·m² or m (hardpoints in the axes of the sheet, centres of mass in the link frame); None
    without a value."""
    value: list[float] | None
    """Value of the design, in the same unit."""


class DesignRecord(Record):
    """Result of a design at the pose of the question."""

    _answer = {"name": "", "effective_mass": "kg", "difference_percent": "%"}

    name: str
    """Name of the design."""
    contact: str | None
    """Named contact of the design; None if link, point and normal give the contact."""
    reference: int | None
    """Number of the design that this design is compared with, from 0; None for the first with its contact."""
    inputs: list[Input]
    """Input files of the design."""
    status: Literal["finite", "immovable", "massless"] | None
    """Kind of result; None without a result."""
    effective_mass: float | None
    """m̄ in the unit of "mass_unit"; None unless finite."""
    mass_unit: str
    """Unit of the effective masses of the design: "kg"; "kg·m²" for a moment about an axis, and for the stop of a revolute
    joint."""
    effective_mass_error: float | None
    """Error bound of m̄, in the unit of "mass_unit"."""
    motion_ratio: float | None
    """Motion ratio: closing of the contact per upward travel of the wheel; None if it differs between motions of the mechanism."""
    travel_at_touch: float | None
    """Upward travel of the wheel at the touch, m; None unless the contact is a stop that was brought to the touch."""
    difference_percent: float | None
    """Difference from m̄ of the reference, per cent of the reference."""
    difference_range_percent: list[float] | None
    """Smallest and largest difference over the rows, per cent."""
    changes: list[DesignChange]
    """Differences from the reference; empty without a reference."""
    most: list[list[float | str]]
    """Links with the largest shares of m̄, and the shares."""
    error: str | None
    """Reason for a missing result."""


class ComparisonRow(Record):
    """Row of the comparison with the values of all designs."""

    row: int
    """Number of the row, from 0."""
    varied: list[float]
    """The varied numbers, rad or m."""
    effective_mass: list[float | None]
    """m̄ of each design, in the unit of its "mass_unit"; None without a finite result."""
    difference_percent: list[float | None]
    """Difference of each design from its reference, per cent."""
    motion_ratio: list[float | None]
    """Motion ratio of each design: closing of the contact per varied travel; None without a travel."""


class ComparisonReport(Record):
    """Report of "percuss compare", as JSON."""

    _answer = {"designs": "", "rows": ""}

    schema: str
    """"percuss.compare/1"."""
    percuss: str
    """Version of percuss."""
    designs: list[DesignRecord]
    """Results of the designs. Each is compared with the first design that has the same contact."""
    varied: list[VariedColumn]
    """Varied columns; empty without rows."""
    rows: list[ComparisonRow]
    """Rows with the values of all designs."""
    diagnostics: list[DiagnosticRecord]
    """Findings about all designs."""


class KinematicColumn(Record):
    """Column of a report."""

    quantity: str
    """Quantity."""
    side: str
    """"left", "right", or empty for one wheel and for both together."""
    unit: str
    """SI unit; empty for a plain number."""
    missing: str | None
    """Reason for the absence of all values; None if a row has a value."""


class KinematicsReport(Record):
    """Kinematics of a suspension."""

    _answer = {"variable": "", "columns": "", "rows": ""}

    schema: str
    """Schema of this report."""
    percuss: str
    """Version of percuss."""
    inputs: list[Input]
    """Source files."""
    derivatives: str
    """Motion of the derivatives: "heave" (all wheels up) or "roll" (left up, right down)."""
    variable: str | None
    """Variable of the rows; None for a single row."""
    columns: list[KinematicColumn]
    """Columns, without the variable."""
    rows: list[dict[str, float | str | None]]
    """Rows."""
    diagnostics: list[DiagnosticRecord]
    """Warnings and notes."""
