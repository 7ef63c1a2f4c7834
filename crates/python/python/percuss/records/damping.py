"""Records of reports: DampingReport. Written by tests/records.py."""

from __future__ import annotations

from typing import Literal

from .record import Record


class Input(Record):
    """Source file of a result."""

    path: str
    """Path as given by the user."""
    sha256: str
    """SHA-256 of the bytes, in hexadecimal."""


class WheelTravelRecord(Record):
    """Upward travel of a wheel centre, m."""

    link: str
    """Link at the wheel centre."""
    travel: float
    """Travel, m."""


class NamedContactRecord(Record):
    """Named contact of a result. Lengths in m."""

    name: str
    """Name."""
    kind: str
    """"stop", "spring", "damper", "patch" or "other"."""
    on: str
    """Body of the contact link: the link to which the contact link is fixed."""
    element: str | None
    """Spring or damper between the same two links, such as the damper of a stop on its rod; None without one."""
    gap_as_drawn: float | None
    """Gap as drawn (all joints at 0); None if the parts always touch."""
    gap: float | None
    """Gap at the pose of the result; None if the parts always touch."""
    brought_to_touch: bool
    """True if the mechanism was moved until the stop touches."""
    touching: list[str]
    """Other stops that touch at this pose: the same stop of the other side of the vehicle."""
    effective_mass_together: float | None
    """Effective mass of this stop, kg, in the motion in which all touching stops close at the same speed; None if no other stop
    touches, or if no impulses cause this motion."""
    wheel_travel: list[WheelTravelRecord]
    """Upward travel of each wheel centre from the pose as drawn to the pose of the result."""


class StopRecord(Record):
    """Stop of a joint, in reports."""

    joint: str
    """The joint."""
    motion: Literal["turn", "slide"]
    """Motion of the joint. "turn": the mass is an inertia in kg·m², the stiffness is in N·m/rad, the speed in rad/s, and so on.
    "slide": kg, N/m, m/s."""


class Drift(Record):
    """Change of m̄ over the penetration. A large change means that one constant mass is a poor approximation."""

    per_metre: float | None
    """Relative rate (dm̄/dδ)/m̄ along the direction of impact, 1/m."""
    over_penetration: float | None
    """m̄ at maximum penetration over m̄ at first touch, minus 1; None without a speed, and if the maximum penetration is not
    reachable."""
    ends_at: float | None
    """Penetration at which the motion of impact ends before the maximum penetration, m; None if the motion does not end early."""


class VaryingMassImpact(Record):
    """Key figures of an impact with an effective mass that changes over the penetration."""

    restitution: float
    """Rebound speed divided by approach speed."""
    max_penetration: float
    """Largest penetration, m."""
    mass_at_max_penetration: float
    """m̄ at the largest penetration, kg."""
    peak_force: float
    """Largest force, N."""


class BodyAlone(Record):
    """Mass of the contact body taken alone, a common substitute for m̄."""

    mass: float
    """Mass, kg."""
    restitution: float | None
    """Restitution on the real contact of a damper designed for this mass; None for laws of the Hunt–Crossley family, whose
    dissipation does not depend on the mass."""


class Measurement(Record):
    """Measurement: the tool, run with exported parameters at the exported time step and accuracy 1e-3."""

    engine: str
    """Program and version."""
    solver: str
    """Solver or mode; empty if there is only one."""
    scenes: str
    """Colliding bodies."""
    worst: list[float | None]
    """Largest error of e over all scenes and phases, rounded up, for e = 0.2, 0.5, 0.8; "None" if the export refuses this e."""
    by_hand: str | None
    """Repetition: with every run of the checks, or by hand on a date."""


class Snippet(Record):
    """Text for a file of the tool."""

    title: str
    """Title."""
    language: str
    """Language: "xml", "python", "cpp", "rust", "matlab", "javascript", "adams"."""
    text: str
    """Well-formed text; numbers have all their digits."""


class Penetration(Record):
    """Greatest penetration of an impact."""

    solver: str
    """Solver or mode of the tool, empty if there is only one."""
    value: float
    """Value in "unit"."""
    unit: str
    """m; rad for a stop that turns."""


class ExportRecord(Record):
    """Contact in the parameters of a simulator, or the reason for missing support. All keys are always present; a value is None
    or empty if not applicable."""

    title: str
    """Name of the tool, in the spelling of its makers."""
    law: str
    """Contact law integrated by the tool."""
    measured: list[Measurement]
    """Results measured with exported parameters; empty without a measurement."""
    combines: str
    """Rule by which the tool combines the values of the two sides."""
    caution: str
    """Precautions for use."""
    parameters: dict[str, float | list[float] | str]
    """Parameters by the tool's own names."""
    units: dict[str, str]
    """Units of the parameters that have one."""
    snippet: str | None
    """First snippet, the text to paste."""
    snippets: list[Snippet]
    """All snippets."""
    time_step: float | None
    """Time step, s; None if the tool chooses the step."""
    error_bound: float | None
    """Error bound of the restitution at this time step, without gravity."""
    single_precision_error: float | None
    """Additional error of a single-precision build, for tools with builds of both precisions."""
    penetrations: list[Penetration]
    """Greatest penetration by the tool's own law, m (rad for a stop that turns); empty without a speed and for rigid contacts."""
    missing: list[str]
    """Missing numbers and their purpose."""
    assumptions: list[str]
    """Assumptions for the requested restitution."""
    cannot: list[str]
    """Limitations of the tool."""
    sources: list[str]
    """Documentation and source files used as sources."""
    error: str | None
    """Reason for missing parameters; None if there are parameters."""


class DiagnosticRecord(Record):
    """Finding about a file or a result."""

    severity: Literal["error", "warning", "note"]
    """Severity; "error", "warning" or "note" in JSON."""
    code: str
    """Stable short name for scripts."""
    path: str | None
    """File; None for a finding about the result."""
    line: int | None
    """Line, from 1."""
    column: int | None
    """Column, from 1."""
    element: str | None
    """Element, as an XML path."""
    message: str
    """Message."""


class DampingReport(Record):
    """Report of "percuss damp", as JSON."""

    _answer = {"damping": "", "dissipation": "", "achieved_restitution": "", "peak_force": "N"}

    schema: str
    """"percuss.damp/1"."""
    percuss: str
    """Version of percuss."""
    inputs: list[Input]
    """Input files; empty if the mass is given directly."""
    effective_mass: float
    """m̄ in the unit of "unit"."""
    unit: str
    """Unit of the effective mass: "kg", or "kg·m²" for a moment."""
    is_moment: bool
    """True for a moment about an axis, and for the stop of a revolute joint: lengths are angles (rad), forces are moments
    (N·m)."""
    named_contact: NamedContactRecord | None
    """Named contact; None for a contact given by link, point and normal, and for a joint stop."""
    stop: StopRecord | None
    """Joint stop; None for other contacts."""
    restitution: float
    """Requested coefficient of restitution."""
    stiffness: float
    """Stiffness k, N/m^p."""
    exponent: float
    """Exponent p."""
    speed: float | None
    """Approach speed, m/s."""
    law: str
    """Damper law."""
    law_alias: str | None
    """Alias by which the law was requested."""
    law_is_exact: bool
    """True if the law gives the requested restitution exactly."""
    separation: str | None
    """Condition for the end of the contact: "force" or "gap"; None for laws with a force that vanishes with the gap."""
    damping_ratio: float | None
    """Damping ratio ζ; None for laws of the Hunt–Crossley family."""
    damping: float | None
    """Damping coefficient c, N·s/m^((p+1)/2), which is N·s/m for a linear spring; None for laws of the Hunt–Crossley family."""
    dissipation: float | None
    """Dissipation d of the force k xᵖ (1 + d ẋ), s/m. For the Kelvin–Voigt law, the value of the exact Hunt–Crossley law, None
    without a speed."""
    achieved_restitution: float
    """Restitution that the damper achieves."""
    contact_duration: float | None
    """Time from first touch to separation, s; None if the duration depends on a speed that is not given, or is infinite."""
    max_penetration: float | None
    """Maximum penetration, m; None without a speed, as are all following values."""
    time_of_max_penetration: float | None
    """Time of maximum penetration, s."""
    peak_force: float | None
    """Peak force, N."""
    time_of_peak_force: float | None
    """Time of peak force, s."""
    energy_lost: float | None
    """Energy lost, J."""
    rebound_speed: float | None
    """Rebound speed, m/s."""
    drift: Drift | None
    """Change of m̄ over the penetration; None if the mass is given directly."""
    over_stroke: VaryingMassImpact | None
    """The same damper in an impact with m̄ as it changes over the penetration: exact for a mechanism with one degree of
    freedom, otherwise along the motion of the impact. None without a speed, if the mass is given directly, and if the motion
    ends before the largest penetration."""
    body_alone: BodyAlone | None
    """Mass of the contact body alone and the resulting restitution; None if neither the model nor the options give this mass."""
    exports: dict[str, ExportRecord]
    """Parameters and code snippets by simulator."""
    diagnostics: list[DiagnosticRecord]
    """Findings about the file and the result."""
