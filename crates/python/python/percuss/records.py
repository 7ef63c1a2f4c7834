"""Types of the reports and of their parts. Written from the JSON schema of the reports: CONTRIBUTING.md."""

from __future__ import annotations

from typing import Literal

from ._record import AnyRecord as AnyRecord
from ._record import Record as Record


class AlongRecord(Record):
    """Slowest row of a list of positions."""

    rows: int
    """Number of rows."""
    unanswered: int
    """Number of rows without a speed: unreachable poses, singular poses, contacts without an upper bound of m̄."""
    first_unanswered: int | None
    """First row without a speed."""
    row: int
    """Row with the smallest speed, from 0."""
    slowest: SpeedRecord
    """Speed in this row."""
    pose: dict[str, list[float]]
    """Joint positions in this row."""


class AntiRollBarRecord(Record):
    """Anti-roll bar during an impact in time: the moment of its twist since the touch."""

    hinges: list[str]
    """Hinges of the halves of the bar: one if the model has one side, with the other half at rest."""
    stiffness: float
    """Torsional stiffness, N·m/rad."""


class BaseRateRecord(Record):
    """Velocity of a floating base, world axes."""

    angular_before: list[float]
    """Angular velocity before the impact, rad/s."""
    linear_before: list[float]
    """Velocity of the root's origin before the impact, m/s."""
    angular_after: list[float]
    """Angular velocity after the impact, rad/s."""
    linear_after: list[float]
    """Velocity of the root's origin after the impact, m/s."""


class BearingForceRecord(Record):
    """Force in one bearing over the time of an impact."""

    place: Literal["ground", "joint", "closure", "hold"]
    """Place."""
    name: str
    """Name of the joint or closure; of the held link; of the root link."""
    force: list[float]
    """Magnitude of the force at each time, N: of the components that redundant loops leave determinate."""
    peak_force: float
    """Largest magnitude, N."""
    peak_time: float
    """Time of the largest magnitude, s."""
    estimate: float
    """For comparison: reaction per unit impulse at the touch, times the largest contact force of the impact in time, N."""
    open_components: list[bool]
    """True for each component (two transverse directions, the axis of the joint) that redundant loops leave open."""


class BodyAlone(Record):
    """Mass of the contact body taken alone, a common substitute for m̄."""

    mass: float
    """Mass, kg."""
    restitution: float | None
    """Restitution on the real contact of a damper designed for this mass; None for laws with a damping that does not depend on
    the mass (Hunt–Crossley, loss factor)."""


class BodyShare(Record):
    """Share of a link in m̄."""

    link: str
    """The link."""
    mass: float
    """Mass of the link, kg; 0 for a link without inertia."""
    share: float | None
    """Share of the kinetic energy at unit closing speed; None unless m̄ is finite."""


class BracketRecord(Record):
    """Proved bounds of an extreme."""

    lower: float | None
    """Proved lower bound of the extreme, in the unit of the report; None without a proof."""
    upper: float | None
    """Proved upper bound of the extreme, in the unit of the report; None without a proof."""
    is_proved: bool
    """True if the bounds agree within the tolerance."""
    boxes: int
    """Number of evaluated boxes."""
    positions: list[float]
    """Positions of the ranges with the best value, rad or m; then those on the edges, m, and the angles ψ about the normal and
    θ from the normal of a cone, rad."""
    divisions: list[int]
    """Division of the ranges in preorder: −1 for a box with a sufficient bound, otherwise the index of the range that is
    halved, then its lower half and its upper half. Empty for linkages."""


class BushShareRecord(Record):
    """Share of a bush."""

    bush: str
    """The bush, or the joint of a gear."""
    direction: str
    """Direction in the bush: "radial x", "radial y", "axial", "conical x", "conical y", "torsional"; "twist" of a gear."""
    share: float
    """Share of the elastic energy, from 0 to 1."""


class ChangeRecord(Record):
    """Part of a model that has another form in the written file, or none."""

    effect: str
    """"changed" or "lost"."""
    element: str
    """The part: a link, joint, loop, coupling or contact with its name, or an element of the file as an XML path."""
    path: str | None
    """File of the element; None for a part of the mechanism."""
    line: int | None
    """Line of the element, from 1."""
    what: str
    """Form in the written file, or what is lost."""
    reason: str
    """Reason."""


class CheckReport(Record):
    """Report of "percuss check", as JSON."""

    schema: Literal["percuss.check/1"]
    """"percuss.check/1"."""
    percuss: str
    """Version of percuss."""
    inputs: list[Input]
    """Input files."""
    name: str
    """Name of the mechanism."""
    root: str
    """Name of the root link."""
    links: list[LinkRecord]
    """All links, in file order."""
    joints: list[JointRecord]
    """All joints, in file order."""
    closures: list[ClosureRecord]
    """Loop closures and couplings, in file order."""
    degrees_of_freedom: int
    """Degrees of freedom with the root fixed, at the pose shown."""
    generic_degrees_of_freedom: int
    """Degrees of freedom with the root fixed, at a generic pose."""
    redundant_constraints: int
    """Number of linearly dependent constraint rows."""
    redundant_loops: list[list[str]]
    """Loops and couplings with redundant rows; entries that cannot be separated form one group."""
    rank_gap: float | None
    """Gap between the singular values of A above and below the rank; None without loops."""
    drivers: list[str]
    """Joints that drive the loops."""
    closure_residual: float | None
    """Closure residual of the loops, m; None without loops."""
    total_mass: float
    """Total mass, kg."""
    pose: dict[str, list[float]]
    """Position of every movable joint, in the layout of "--set"."""
    poses: list[str]
    """Names of the poses of the file, for "--pose": keyframes of MJCF."""
    diagnostics: list[DiagnosticRecord]
    """Findings of the reader and of the assembly."""


class ClosureRecord(Record):
    """A loop closure or coupling in a "CheckReport"."""

    name: str
    """Name of the closure or coupling."""
    kind: str
    """Kind of the closure; "coupling" for a ratio of two links, "relation" for a relation of joints."""
    predecessor: str | None
    """Predecessor link; None for a relation of joints."""
    successor: str | None
    """Successor link; None for a relation of joints."""
    rows: int
    """Number of constraint rows."""
    ratio: float | None
    """Ratio of the successor's rate to the predecessor's rate; None unless a coupling of two links."""
    joints: list[RelationTermRecord]
    """Joints of a relation Σ fᵢ qᵢ = c (or c plus a polynomial) with their coefficients fᵢ; empty for other closures."""


class CodeReport(Record):
    """Generated source code."""

    schema: Literal["percuss.generate/1"]
    """"percuss.generate/1"."""
    percuss: str
    """Version of percuss."""
    inputs: list[Input]
    """Input files."""
    language: Literal["c", "rust"]
    """Language."""
    name: str
    """Prefix of all names in the code."""
    positions: int
    """Number of positions."""
    operations: int
    """Number of arithmetic operations of one configuration, without sines and cosines."""
    angles: int
    """Number of pairs of sine and cosine."""
    references: int
    """Number of reference values in the self-test."""
    files: list[TextFile]
    """Files: header, source and self-test, or one Rust file."""
    diagnostics: list[DiagnosticRecord]
    """Findings about the file of the model."""


class ComparedMass(Record):
    """Identified effective mass beside that of the model."""

    expected: float
    """m̄ of the model, or the given mass, kg."""
    difference: float
    """Identified mass minus the expected one, kg."""
    agrees: bool | None
    """True if the difference is at most two standard uncertainties; None if these are above a fifth of the mass."""
    explanations: list[MassExplanation]
    """Links whose mass explains the difference, the smallest relative change first."""


class ComparisonReport(Record):
    """Report of "percuss compare", as JSON."""

    schema: Literal["percuss.compare/1"]
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


class ComplexSeries(Record):
    """Complex numbers over frequency; None where the response does not exist."""

    real: list[float | None]
    """Real parts."""
    imaginary: list[float | None]
    """Imaginary parts."""


class ComplianceRecord(Record):
    """Compliance of the bushes and gears at a contact. Units of a contact along a normal; N·m for N and rad for m at a moment."""

    elastic: str
    """Elastic parts: "bushes", "gears", or "bushes and gears". "Bushes" in the descriptions of the other keys means all of
    them."""
    free_mass: float | None
    """m̄ with all bushes free, the limit of stiff contacts, in the unit of the report; None unless finite."""
    free_status: Literal["finite", "immovable", "massless"]
    """Kind of result with all bushes free."""
    residual_compliance: float | None
    """Residual compliance c_res of the bushes, m/N; None if the contact is massless or immovable."""
    residual_stiffness: float | None
    """Residual stiffness 1/c_res, N/m; None if no bush gives way."""
    rows: list[BushShareRecord]
    """Shares of the bushes in the elastic energy of the residual compliance, the largest first."""
    lower_bounds_hold: bool
    """True if no spring, damper, tyre, anti-roll bar or free rotation of a bush with stiffness acts along the motion of the
    rigid mechanism: the lower bounds of an impact hold."""
    beside: list[str]
    """Springs, dampers, tyres and anti-roll bars of the sheet; joints with a spring or a damper."""
    rigid_up_to: list[float] | None
    """Largest stiffnesses of a contact, N/m, up to which the rigid mass is right within 1 % and within 5 %, by the rule of
    thumb."""
    contact: CompliantContactRecord | None
    """Contact of the given stiffness; None without a stiffness."""


class CompliantContactRecord(Record):
    """Contact of a given stiffness on the mechanism with bushes."""

    stiffness: float
    """Stiffness k of the contact, N/m."""
    frequency: float | None
    """Frequency √(k/m̄)/2π of the rigid mechanism on the contact, Hz; None unless m̄ is finite."""
    duration: float | None
    """Duration π√(m̄/k) of the contact of the rigid mechanism, s; None unless m̄ is finite."""
    impulse_change: float | None
    """Estimated relative change of the impulse by the bushes, 1.3 k c_res: a rule of thumb for small values."""
    force_change: float | None
    """Estimated relative change of the peak force by the bushes, 1.2 k c_res: a rule of thumb for small values."""
    peak_force_per_speed: list[float | None]
    """Proved bounds of the peak force per approach speed, N·s/m: √(k m_free) and √(k m̄). The lower bound is None if a
    stiffness or a damping acts along the motion, the upper bound if m̄ is not finite."""
    peak_force: list[float | None] | None
    """The same bounds at the given approach speed, N."""
    least_duration: float | None
    """Least duration of the contact, π√(m_free/k), s: proved without contact damping; None if a stiffness or a damping acts
    along the motion."""
    impact: UndampedImpactRecord | None
    """Impact on this contact without damping, with the elastic bushes and gears and without springs and dampers of the sheet,
    from the motion of least energy; None if the contact is immovable or massless."""


class CompliantEnergyRecord(Record):
    """Energies of an impact with elastic bushes and gears, J."""

    kinetic_before: float
    """Kinetic energy at the touch."""
    kinetic_after: float
    """Kinetic energy at the end, vibrations included."""
    stored: float
    """Energy that bushes, springs and gears store at the end."""
    dissipated: float
    """Energy that bushes, dampers and gears take."""
    taken_by_contact: float
    """Work that the contact takes."""
    work_of_other_forces: float
    """Work of gravity, preloads, drives and of forces that are not linear."""
    residual: float
    """Error of the balance."""


class CompliantImpactRecord(Record):
    """Impact in time with elastic bushes and gears, linear about the touch: small displacements, no geometric stiffness, whose
    effect "with_geometric_stiffness" states. Units of a contact along a normal."""

    restitution: float
    """Separation speed divided by closing speed; 0 without rebound."""
    end: Literal["separates", "grazes", "no-rebound"]
    """End of the contact."""
    duration: float | None
    """Duration of the contact, s; None without rebound."""
    max_penetration: float
    """Largest penetration, m."""
    peak_force: float
    """Largest force of the contact, N."""
    impulse: float
    """Impulse P of the contact, N·s."""
    impulse_mass: float
    """m_imp = P/(v⁻ + v⁺), kg: mass of a free body with the same impulse between the same speeds."""
    loss_frequency: float
    """Frequency f at which loss factors act as dampers, c = ηk/(2πf), Hz: that of the rigid mechanism on the contact."""
    with_geometric_stiffness: DirectionChangeRecord | None
    """Size of an assumption: the same impact with the geometric stiffness of the preloads and springs, which forces on the
    wheels balance at the touch; None without such forces, or if they are in no balance."""
    second_hit: SecondHitRecord | None
    """Second touch within the duration of the first contact; None if there is none."""
    energy: CompliantEnergyRecord
    """Energies."""
    elements: list[ElementForceRecord]
    """Largest forces of bushes, springs, dampers, tyres and gears."""
    times: list[float]
    """Times since the touch, s."""
    penetration: list[float]
    """Penetration at each time, m."""
    closing_speed: list[float]
    """Closing speed at each time, m/s."""
    force: list[float]
    """Force of the contact at each time, N."""


class ConditionsRecord(Record):
    """Conditions of a result, sufficient to repeat the question."""

    base: str
    """"fixed" or "floating"."""
    base_pose: list[float] | None
    """Pose of the root link in the world, x, y, z (m), w, x, y, z; None at the origin of the world."""
    lock: list[str]
    """Joints locked by the question."""
    hold: list[HoldRecord]
    """Points held by the question."""
    armature: dict[str, list[float]]
    """Armatures that replace those of the model."""
    against_mass: float | None
    """Mass of a free body on the other side, kg."""
    guess: dict[str, str]
    """Initial guesses of joint positions, as typed."""
    travel: list[TravelRecord]
    """Travels that drove the pose."""


class ContactListReport(Record):
    """Effective masses at all named contacts, as JSON."""

    schema: Literal["percuss.contacts/1"]
    """"percuss.contacts/1"."""
    percuss: str
    """Version of percuss."""
    inputs: list[Input]
    """Input files."""
    contacts: list[ListedContact]
    """The contacts: stops, springs, dampers, contact patches, others; for a study, in the order of its contacts."""
    diagnostics: list[DiagnosticRecord]
    """Findings about the file and the results; a finding about one contact begins with its name."""


class ContactRecord(Record):
    """Contact, in the world frame and in the frame of the contact link."""

    link: str
    """Contact link."""
    against: str | None
    """Other link; None for the ground."""
    point_world: list[float]
    """Contact point, world frame, m."""
    normal_world: list[float]
    """Unit normal out of the contact link, world axes; the unit axis of a moment."""
    point_link: list[float]
    """Contact point, link's frame, m; the origin of the link for a moment, which has no point."""
    normal_link: list[float]
    """Unit normal out of the contact link, link's axes; the unit axis of a moment."""
    is_moment: bool
    """True for a moment about an axis, and for the stop of a revolute joint: masses in kg·m², speeds in rad/s, impulses in
    N·m·s, forces in N·m."""


class ConversionReport(Record):
    """Report of "percuss convert", as JSON."""

    schema: Literal["percuss.convert/1"]
    """"percuss.convert/1"."""
    percuss: str
    """Version of percuss."""
    inputs: list[Input]
    """Input files."""
    output: str
    """Written file, or the name of the file in "files"."""
    format: str
    """Format of the written file: "mjcf", "sdf" or "urdf"."""
    links: int
    """Number of links."""
    joints: int
    """Number of joints."""
    loops: int
    """Number of loops."""
    couplings: int
    """Number of couplings and relations."""
    contacts: int
    """Number of named contacts."""
    changes: list[ChangeRecord]
    """Everything that changes or is lost."""
    mass_change: list[float] | None
    """Least and largest relative change of the effective mass of a contact at the drawn pose by balanced moments of inertia;
    None without them, and without a bound."""
    diagnostics: list[DiagnosticRecord]
    """Other findings about the file."""
    files: list[TextFile] | None
    """The model as text; absent if it is written to a file."""


class DampingReport(Record):
    """Report of "percuss damp", as JSON."""

    schema: Literal["percuss.damp/1"]
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
    stiffness: float | None
    """Stiffness k, N/m^p; None for a force curve."""
    exponent: float | None
    """Exponent p; None for a force curve."""
    stiffness_curve: ForceCurveRecord | None
    """Force curve F_s of the contact; None for a stiffness."""
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
    """Damping ratio ζ; None for other laws than Kelvin–Voigt and for a force curve."""
    damping: float | None
    """Damping coefficient c, N·s/m^((p+1)/2), which is N·s/m for a linear spring and for a force curve; None for other laws
    than Kelvin–Voigt."""
    dissipation: float | None
    """Dissipation d of the force F_s(x) (1 + d ẋ), F_s = k xᵖ or the force curve, s/m. For the Kelvin–Voigt law, the value of
    the exact Hunt–Crossley law, None without a speed."""
    loss_factor: float | None
    """Loss factor η of the force F_s(x) (1 + (π/2) η sgn ẋ); None for other laws."""
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


class DirectionChangeRecord(Record):
    """The same impact with the change of direction of the forces at the touch."""

    restitution: float
    """Restitution."""
    peak_force: float
    """Largest force of the contact, N."""


class DirectionMass(Record):
    """m̄ along a direction."""

    direction_link: list[float]
    """Unit vector, link's axes."""
    direction_world: list[float]
    """Unit vector, world axes."""
    status: str
    """"finite", "immovable", "massless" or "no answer"."""
    effective_mass: float | None
    """m̄, kg; None unless finite."""
    effective_mass_error: float | None
    """Error bound of m̄, kg; None if unknown."""


class Drift(Record):
    """Change of m̄ over the penetration. A large change means that one constant mass is a poor approximation."""

    per_metre: float | None
    """Relative rate (dm̄/dδ)/m̄ along the direction of impact, 1/m."""
    over_penetration: float | None
    """m̄ at maximum penetration over m̄ at first touch, minus 1; None without a speed, and if the maximum penetration is not
    reachable."""
    ends_at: float | None
    """Penetration at which the motion of impact ends before the maximum penetration, m; None if the motion does not end early."""


class DriveRecord(Record):
    """Drive with a constant force during an impact in time."""

    name: str
    """Joint, or both links of a line."""
    value: float
    """Force (N) or moment (N·m): along the motion of the joint, or apart along the line."""
    unit: str
    """Unit of the value."""
    work: float
    """Work until the largest penetration, J."""


class ElementForceRecord(Record):
    """Largest force of a bush, a spring, a damper, a tyre, a gear or an ideal joint."""

    element: str
    """The bush, spring, damper, tyre, anti-roll bar or drive; the joint or loop of a gear or of an ideal bearing."""
    direction: str | None
    """Direction in the bush: "radial x", "radial y", "axial", "conical x", "conical y", "torsional"; "motion" of a spring or
    damper, "twist" of a gear; None for the magnitude of the force of a bush or of an ideal joint."""
    unit: str
    """"N", or "N·m" for a moment."""
    peak_force: float
    """Largest magnitude during the contact, N or N·m."""
    peak_time: float
    """Its time, s."""
    peak_force_after: float | None
    """Largest magnitude after the contact, for as long as the contact lasted or until the second touch; None without a
    separation."""
    force: list[float]
    """Force at each time, with the sign of the displacement, N or N·m."""


class EnergyRecord(Record):
    """Energies of an impact in time, J. Kinetic energies include a free body on the other side."""

    kinetic_before: float
    """Kinetic energy at the touch."""
    kinetic_after: float
    """Kinetic energy at the end."""
    taken_by_contact: float
    """Work that the contact takes."""
    work_of_other_forces: float
    """Work of gravity, springs and dampers on the mechanism."""
    residual: float
    """Error of the balance: after − before + taken by the contact − work of the other forces."""


class ErrorBudgetRecord(Record):
    """Parts of the error bound of m̄, kg; None if a part is unknown or m̄ is not finite."""

    rounding: float | None
    """Rounding of positions, frames and constraint rows, and of the computation."""
    closing: float | None
    """Part due to the closure residual of the loops."""
    file: float | None
    """Part due to inexact loops in the file."""


class Estimate(Record):
    """Identified value with its standard uncertainty."""

    value: float
    """Value."""
    uncertainty: float
    """Standard uncertainty; 0 for a known value. The true value lies within two standard uncertainties in 95 of 100 cases."""


class EstimateRecord(Record):
    """Classical estimate m_K v_A²: mass of some links, all moving with the speed of point A. l̄ = 1/v_A is r_B/r_A of Euler's
    note (Fayzullin 2018). v_A is the component of the velocity along a direction: the given one, or upwards in a suspension,
    as for all motion ratios of a wheel. In other models without a direction, v_A is the magnitude of the velocity."""

    links: list[str]
    """Links with a mass counted in m_K."""
    mass: float
    """m_K, kg."""
    point_link: list[float]
    """Point A, in the first link's frame, m."""
    direction: list[float] | None
    """Direction of the speed of A, a unit vector in world axes; None for the magnitude of the velocity."""
    motion_ratio: float | None
    """Motion ratio l̄: closing speed of the contact per speed of A, negative for a motion against the direction. None if A does
    not move, or if a massless motion leaves its speed undetermined."""
    estimate: float | None
    """m_K / l̄², kg."""
    error_percent: float | None
    """Difference from the exact value, per cent."""
    share_left_out: float | None
    """Share of the other links and of the rotors in the exact value; the estimate omits this share."""


class Explanation(Record):
    """Sensitivities of an effective mass."""

    effective_mass: float
    """m̄, kg."""
    links: list[LinkSensitivity]
    """Links with mass, in file order."""
    rotors: list[RotorSensitivity]
    """Joints that move in the motion v*, including joints without armature."""
    points: list[PointSensitivity]
    """Hardpoints of a sheet; empty for a URDF."""
    most_per_kilogram: list[MassChange]
    """Links with the largest rate per kilogram, largest first."""
    most_per_millimetre: list[PointChange]
    """Hardpoints with the largest rate per millimetre, largest first."""


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


class ExportReport(Record):
    """Report of "percuss export", as JSON."""

    schema: Literal["percuss.export/1"]
    """"percuss.export/1"."""
    percuss: str
    """Version of percuss."""
    inputs: list[Input]
    """Input files."""
    output: str
    """Written model."""
    script: str
    """Written script."""
    format: str
    """Format of the model."""
    stop: StopRecord | None
    """Stop of a joint; its "motion" determines the units. None for a contact."""
    effective_mass: float
    """m̄ at the touch, kg."""
    approach_speed: float
    """Closing speed at the touch, m/s."""
    restitution: float
    """Required restitution."""
    predicted_restitution: float | None
    """Restitution with the mass as it changes over the penetration, for an infinitely short time step; None if the mechanism
    cannot follow the impact."""
    error_bound: float | None
    """Bound of the difference between the restitution that the simulator reaches and the required one; None if unknown."""
    time_step: float
    """Time step, s."""
    changes: list[ChangeRecord]
    """Everything that changes or is lost."""
    mass_change: list[float] | None
    """Least and largest relative change of the effective mass of a contact at the drawn pose by balanced moments of inertia;
    None without them, and without a bound. All other keys are those of the balanced moments."""
    diagnostics: list[DiagnosticRecord]
    """Findings about the file and the result."""
    files: list[TextFile] | None
    """The model and the script as text; absent if they are written to files."""


class Extreme(Record):
    """Contact with the smallest or largest m̄."""

    effective_mass: float
    """m̄, kg."""
    effective_mass_error: float | None
    """Error bound of m̄, kg; None if unknown."""
    point_link: list[float]
    """Contact point, link's frame, m."""
    normal_link: list[float]
    """Unit normal out of the link, link's axes."""
    point_world: list[float]
    """Contact point, world frame, m."""
    normal_world: list[float]
    """Unit normal out of the link, world axes."""


class ExtremePosition(Record):
    """Position of a joint at an extreme."""

    joint: str
    """The joint."""
    position: float
    """Position, rad or m."""
    limit: str | None
    """"lower" or "upper" if the extreme is at an end of the range; None otherwise."""


class ExtremeRecord(Record):
    """Extreme of the searched quantity."""

    effective_mass: float | None
    """Effective mass in the unit of the report; None if it is not finite or if another quantity is searched."""
    value: float | None
    """Value of the quantity in the unit of the report; None if not finite."""
    status: Literal["finite", "immovable", "massless"]
    """Kind of the value; "immovable" is a valid largest value of a mass or an inertia. The largest impulse or peak force in a
    bearing is "immovable" if it grows without bound towards these positions, at which the contact is immovable."""
    positions: list[ExtremePosition]
    """Positions of the varied joints."""
    gap: float | None
    """Gap of a stop at these positions, m: the stop is open if it is positive, and pressed if negative; None for other
    contacts."""
    row: float | None
    """Fractional row number on the path, from 0: 2.25 is a quarter of the way from row 2 to row 3; None without a path."""
    place: PathPlace | None
    """Value of the varied number of the path at the extreme; None without a path, and for a path with several varied numbers."""
    kept_error: float | None
    """Largest error of a coordinate of a kept point, m; None without kept points."""
    normal_world: list[float] | None
    """Normal (for a moment: axis) at the extreme, world axes, up to its sign; None if the search uses the normal of the
    contact."""
    point_link: list[float] | None
    """Contact point at the extreme in the frame of the contact link, m; None without edges."""
    residual: float
    """Largest component of the projected gradient times its range, relative to the value (for a bearing, of the square of the
    impulse): zero at an exact optimum."""
    agreeing: int
    """Number of starts that reached this value to six digits."""
    starts: int
    """Number of starts that were searched; on a path the number of local searches."""
    is_stopped: bool
    """True if the limit of work ended the search before all starts were searched: the value is the best one found."""


class ExtremesCertificateRecord(Record):
    """Proved bounds of the extremes of m̄ over ranges, for rigid links, ideal joints, and the numbers of the model as read."""

    tolerance: float
    """Wanted relative distance of the bounds."""
    mass_tolerance: float
    """Relative tolerance t of all masses, moments of inertia and rotor inertias, each by its own factor from 1 − t to 1 + t."""
    least: BracketRecord | None
    """Smallest m̄; None without a proof."""
    most: BracketRecord | None
    """Largest m̄; None without a proof."""
    peak_force: float | None
    """Upper bound of the peak force v √(k m̄) of a linear spring without damping, N; None without stiffness and speed."""
    pieces: int | None
    """Number of boxes with a proved assembly; None for a tree."""
    omitted: list[OmittedRowRecord]
    """Rows of loops that are left out without a proof."""
    reason: str | None
    """Reason for no proof; None with a proof."""
    tree: TreeRecord | None
    """Numbers for an independent check; None for linkages, and for contacts or joints that the checker does not know."""


class ExtremesReport(Record):
    """Report of "percuss extremes", as JSON."""

    schema: Literal["percuss.extremes/1"]
    """"percuss.extremes/1"."""
    percuss: str
    """Version of percuss."""
    quantity: str
    """Quantity: "effective_mass", "reflected_inertia", "held_inertia", "bearing_impulse" (impulse in the bearing per closing
    speed of a plastic impact) or "bearing_peak_force" (peak force in the bearing with the contact law)."""
    is_moment: bool
    """True for a moment about an axis, and for the stop of a revolute joint: closing speeds in rad/s."""
    joint: str | None
    """Joint or bearing of the quantity: name of a joint or of a closure, or "ground"; None for the effective mass."""
    unit: str
    """Unit of the values: "kg" or "kg·m²"; "kg·m" for the impulse in a bearing per closing speed of a moment; "N" for a peak
    force."""
    ranges: list[list[float | str]]
    """Ranges of the varied joints: joint, lower and upper end, rad or m; empty for a path."""
    cone: float | None
    """Largest angle between the normals and that of the contact, rad; None without a cone."""
    edges: list[list[float]]
    """Edges of the patch of contact points, in the frame of the contact link, m."""
    kept: list[KeptRecord]
    """Links and points that stay in place over the ranges."""
    path: PathRecord | None
    """Path; None for ranges."""
    held: list[list[list[float] | str]]
    """Driving joints that do not vary, with their positions, rad or m."""
    starts: int
    """Number of starts; on a path the number of local searches, the larger one of both extremes."""
    least: ExtremeRecord
    """Smallest value of the quantity."""
    most: ExtremeRecord
    """Largest value of the quantity."""
    certificate: ExtremesCertificateRecord | None
    """Proved bounds of the extremes; None without "certify"."""
    diagnostics: list[DiagnosticRecord]
    """Findings about the ranges, or about the rows of the path."""


class ForceCurveRecord(Record):
    """Force curve of a contact, in a report."""

    stop: str | None
    """Named contact of the suspension sheet that has the curve; None for a given curve."""
    deflections: list[float]
    """Penetrations, m."""
    forces: list[float]
    """Force at each penetration, N."""
    coefficients: list[float]
    """Coefficients of the sum of powers between both penetrations, N/m^p; empty for points with lines."""
    exponents: list[float]
    """Exponents p of the powers."""


class FoundCoordinate(Record):
    """Unknown before and after a search: coordinates in the unit and axes of the sheet, masses in kg."""

    coordinate: str
    """Name "POINT.AXIS", "LINK.mass", "CONTACT.curve" or "CONTACT.damping"."""
    unit: str
    """Unit; × for a factor on the forces of a curve or on a stiffness."""
    old: float
    """Value in the sheet."""
    new: float
    """Value found."""


class FrictionRecord(Record):
    """Coulomb friction at the contact."""

    coefficient: float
    """Coefficient of friction µ."""
    law: str
    """Meaning of the coefficient of restitution: "energetic", "poisson", "newton" or "algebraic"."""
    slope: float | None
    """Sliding speed per closing speed, t, of a contact of one relative motion; None for others."""
    wedged: bool
    """True if the contact sticks and does not rebound: µt ≥ 1 for one relative motion."""
    kinematic_restitution: float
    """Separation speed divided by closing speed."""
    tangential_impulse_world: list[float]
    """Impulse of the friction on the contact link, N·s, world axes."""
    sliding_before_world: list[float]
    """Sliding velocity of the contact link against the other side before the impact, m/s, world axes."""
    sliding_after_world: list[float]
    """Sliding velocity after the impact."""
    phases: list[PhaseRecord]
    """Phases of the impact in order; empty for the algebraic form."""
    sticking_threshold: float | None
    """Coefficient of friction above which the contact can stick; None for one relative motion."""
    jamming_threshold: float | None
    """Coefficient of friction above which sliding can jam; for one relative motion above which the contact wedges; None without
    one."""
    laws: list[LawRecord]
    """Results of all laws of restitution with the same coefficients."""


class FrictionThresholdsRecord(Record):
    """Coefficients of friction at which the behaviour of a contact changes. They do not depend on the velocities."""

    slope: float | None
    """Sliding speed per closing speed, t, of a contact with one relative motion; None for other contacts."""
    sticking: float | None
    """Coefficient of friction from which the contact can stick; None for one relative motion, and if no friction suffices."""
    jamming: float | None
    """Coefficient of friction from which sliding can jam. For one relative motion: 1/t, from which the contact wedges. None if
    no friction suffices."""


class GreatestSpeedRecord(Record):
    """Greatest closing speed by the limits of joint rates and gears."""

    speed: float
    """Speed, m/s."""
    joint: str
    """Joint that limits it."""
    limit: str
    """Limit that is reached: "rate", "gear" (impulse in the gear) or "gear-torque"."""


class HoldRecord(Record):
    """A held point."""

    link: str
    """The link."""
    point: list[float]
    """The point in the link's frame, m."""
    normal: list[float] | None
    """The normal in world axes; None if all three directions are held."""


class IdentificationReport(Record):
    """Report of "percuss identify", as JSON."""

    schema: Literal["percuss.identification/1"]
    """"percuss.identification/1"."""
    percuss: str
    """Version of percuss."""
    inputs: list[Input]
    """Files of the data and of the model."""
    named_contact: NamedContactRecord | None
    """Named contact of the model."""
    effective_mass: Estimate
    """Effective mass m̄, kg. Uncertainties are standard uncertainties: the value lies within two of them in 95 of 100 cases."""
    finds_mass: bool
    """True if the data determine the mass; false if it is the given one."""
    compared: ComparedMass | None
    """Comparison with the model or the given mass."""
    damper: Literal["kelvin-voigt", "hunt-crossley"]
    """Form of the damper."""
    other_form: float | None
    """Mean square of the residuals with the other form, divided by that with this form; None if the form is given."""
    stiffness: Estimate
    """Stiffness k of k x^p, N/m^p."""
    exponent: Estimate
    """Exponent p."""
    second_stiffness: Estimate | None
    """Coefficient c of a second term c x^q of the spring, N/m^q; None if the spring has one term."""
    second_exponent: float | None
    """Exponent q of the second term."""
    damping: Estimate | None
    """Damping c of c x^((p-1)/2) v, N·s/m^((p+1)/2); None for the other form."""
    dissipation: Estimate | None
    """Dissipation d of d k x^p v, s/m; None for the other form."""
    correlation: list[list[float]]
    """Correlations of mass, stiffness, exponent and damping or dissipation."""
    impacts: list[MeasuredImpact]
    """Measured impacts."""
    diagnostics: list[DiagnosticRecord]
    """Findings about the files and the result."""


class IdentifiedSignal(Record):
    """Signal of a record after the identification."""

    quantity: Literal["force", "acceleration", "velocity", "displacement"]
    """Quantity."""
    is_reversed: bool
    """True if the values fall where a pushing force, the deceleration, the closing speed or the penetration grows."""
    offset: Estimate | None
    """Value of the sensor without force or penetration, at the touch; None for a velocity."""
    drift: Estimate | None
    """Change of the offset, per second; None for a velocity and a displacement."""
    residual: float
    """Root mean square of the residuals."""
    relative_residual: float
    """Residual relative to the largest value."""
    correlation_time: float
    """Time over which residuals are correlated, s; 0 if neighbours are independent."""
    excess: float | None
    """Root mean square of the residuals during the contact divided by that before and after it, by which the uncertainties are
    larger; None if the residuals are independent, or not significantly larger during the contact."""
    clipped: int
    """Number of samples at the limit of the sensor, which are not used."""
    outliers: list[float]
    """Times of outliers, s, which are not used."""
    at_touch: int
    """Number of samples beside a jump of the force at the touch, which are not used."""


class ImpactLawRecord(Record):
    """Compliant contact with the peak force of the impact."""

    law: str
    """Contact law."""
    stiffness: float | None
    """Stiffness, N/m^p; None for a force curve."""
    exponent: float | None
    """Exponent p; None for a force curve."""
    stiffness_curve: ForceCurveRecord | None
    """Force curve of the contact; None for a stiffness."""
    duration: float | None
    """Duration of the contact, s; None if infinite, and with friction."""
    max_penetration: float | None
    """Largest penetration, m."""
    peak_force: float
    """Largest normal force at the contact, N."""
    mass_in_compression: float | None
    """Mass of a frictionless contact with the same work of compression, kg; None without friction."""
    direction_changes: bool
    """True if the direction of the contact force changes during compression; the peaks of the bearings are then for its mean
    direction."""
    mass_change_over_penetration: float | None
    """Relative change of m̄ over the penetration: order of magnitude of the relative error of all peak forces, apart from the
    forces of "motion_force"; None if the penetration is not reachable."""
    motion_force: MotionForceRecord | None
    """Force of the velocities before the impact in the bearing with the largest ratio of this force to its peak force. None if
    no bearing has a finite ratio. The peak forces exclude these forces."""


class ImpactReport(Record):
    """Report of "percuss impact", as JSON. All keys are always present; a value is None if not applicable."""

    schema: Literal["percuss.impact/1"]
    """"percuss.impact/1"."""
    percuss: str
    """Version of percuss."""
    mass: MassReport
    """Effective mass, contact, pose and conditions: the report of "percuss mass". Its findings are in "diagnostics"."""
    restitution: float
    """Coefficient of restitution e; with friction the energetic one."""
    closing_speed: float
    """Closing speed before the impact, m/s; rad/s for a moment ("mass.contact.is_moment")."""
    impulse: float
    """Normal impulse between the two sides, N·s (N·m·s for a moment); −impulse · normal acts on the contact link."""
    energy_loss: float
    """Lost kinetic energy, J."""
    friction: FrictionRecord | None
    """Friction, if requested."""
    simultaneous: SimultaneousRecord | None
    """Several contacts at once, if further contacts or sticking points are requested. All other results are those of the first
    contact alone."""
    sticking_mass: float | None
    """Mass of the contact point if it cannot slide in the tangent plane (nᵀΛn), kg; None if not finite. The effective mass is
    that of a sliding contact, 1/(nᵀΛ⁻¹n). None for contacts without a contact point: a moment, the stop of a joint, a cable,
    a spring or a rod."""
    sticking_status: Literal["finite", "immovable", "massless"] | None
    """Kind of the sticking mass; None for contacts without a contact point."""
    mass_states: list[MassStateRecord]
    """Sliding and sticking masses with rotors decoupled, with rotors coupled, and with locked joints. Empty for contacts
    without a contact point."""
    motion_before: str
    """Motion before the impact: "given", or "least-energy", the motion v* times the closing speed."""
    rates: list[JointRateRecord]
    """Rates of every movable joint."""
    base: BaseRateRecord | None
    """Velocity of a floating base; None for a fixed base."""
    other_body: OtherBodyRecord | None
    """Free body on the other side; None without one."""
    reactions: list[ReactionRecord]
    """Reactions in all joints, closures and held points, and that of the ground."""
    joint_constraints: list[JointConstraintRecord]
    """Impulses of the locks, mimics and couplings on their joints."""
    reaction_residual: float
    """Largest unbalanced impulse of the reactions, relative to the impulse."""
    contact_law: ImpactLawRecord | None
    """Compliant contact, if a contact law was requested."""
    in_time: ImpactTimeRecord | None
    """Impact in time with the contact law, if requested."""
    greatest_closing_speed: GreatestSpeedRecord | None
    """Greatest closing speed by limits of joint rates and gears, if requested."""
    limits_without_effect: list[str]
    """Joints with a limit of the rate or of the gear that has no effect: the impact does not change their rates."""
    reflected_inertia: list[ReflectedRecord]
    """Reflected inertias, if requested."""
    reflected_over: list[ReflectedRangeRecord]
    """Reflected inertias over ranges of positions, if requested."""
    percussion: list[PercussionRecord]
    """Centres of percussion, if requested."""
    diagnostics: list[DiagnosticRecord]
    """Findings about the file and the result."""


class ImpactTimeRecord(Record):
    """Impact in time with a compliant contact."""

    restitution: float
    """Restitution that is reached: separation speed divided by closing speed; 0 if the sides do not separate."""
    duration: float | None
    """Duration of the contact, s; None if the sides do not separate."""
    max_penetration: float
    """Largest penetration, m."""
    peak_force: float
    """Largest force of the contact, N."""
    mass_change: float | None
    """Relative change of m̄ from the touch to the largest penetration; None if m̄ is not finite there. The change is unbounded
    near a pose at which the contact is immovable."""
    restitution_is_reached: bool
    """True if the damping was found for the requested restitution of the impact in time, and false if it is that of the contact
    alone."""
    damping: float | None
    """Damping of the contact law, N·s/m^((p+1)/2); None for other laws than Kelvin–Voigt."""
    dissipation: float | None
    """Dissipation of the contact law, s/m; None for other laws than those of the Hunt–Crossley family."""
    loss_factor: float | None
    """Loss factor of the contact law; None for other laws."""
    one_freedom: VaryingMassImpact | None
    """The impact of a mechanism of one degree of freedom by m̄ over the penetration alone; None for others, with gravity, or if
    the motion ends before."""
    gravity_world: list[float]
    """Gravity, world axes, m/s²."""
    springs: list[PointSpringRecord]
    """Springs between points that act."""
    dampers: list[PointDamperRecord]
    """Dampers between points that act."""
    tyres: list[TyreRecord]
    """Tyres that act."""
    anti_roll_bars: list[AntiRollBarRecord]
    """Anti-roll bars that act."""
    joint_springs: list[JointSpringRecord]
    """Springs and dampers of joints that act: those of the model, and given ones."""
    drives: list[DriveRecord]
    """Drives that act."""
    effective_weight: float | None
    """Effective weight of absorber catalogues, kg (kg·m² for a moment): m̄ + 2W/v² with the work W of the drives until the
    largest penetration and the closing speed v. It is no mass of the mechanism; None without drives."""
    springs_left_out: list[str]
    """Springs, dampers, tyres and anti-roll bars of the suspension sheet and springs of joints that are left out."""
    with_whole_forces: DirectionChangeRecord | None
    """Size of an assumption: only the change of the forces of the springs since the touch acts; here the same impact with their
    whole forces, which change their direction, and with constant vertical forces on the wheel centres that balance them at
    the touch. None if the whole forces act or are unknown."""
    second_touch: SecondTouchRecord | None
    """Second touch of the contact within three of its durations after its end, without the force of the contact in between;
    None if there is none."""
    energy: EnergyRecord
    """Energies of the motion."""
    loop_gap: float
    """Largest gap of the loops during the motion, m: error of the integration."""
    times: list[float]
    """Times since the touch, s."""
    penetration: list[float]
    """Penetration at each time, m."""
    closing_speed: list[float]
    """Closing speed at each time, m/s."""
    force: list[float]
    """Force of the contact at each time, N."""
    effective_mass: list[float | None]
    """m̄ at each time, kg; None if not finite."""
    joints: list[JointMotionRecord]
    """Velocities of the movable joints."""
    bearings: list[BearingForceRecord]
    """Forces in the bearings."""
    compliant: CompliantImpactRecord | None
    """The same impact with elastic bushes and gears; None unless requested."""


class Input(Record):
    """Source file of a result."""

    path: str
    """Path as given by the user."""
    sha256: str
    """SHA-256 of the bytes, in hexadecimal."""


class JointConstraintRecord(Record):
    """Impulses of a lock, a mimic or a coupling on its joints."""

    kind: Literal["lock", "mimic", "coupling"]
    """Kind."""
    name: str
    """Name of the locked joint, of the joint that mimics another, or of the coupling."""
    joints: list[str]
    """Joint of each impulse; a locked joint occurs once for each of its velocities."""
    impulses: list[float | None]
    """Impulse on each velocity, N·m·s or N·s. None if redundant constraints leave the impulse open; the sum on the joint
    ("constraint" of its reaction) can still be determinate."""
    open_by: list[str]
    """Constraints that leave impulses open: loops, couplings, mimics and locks."""


class JointMotionRecord(Record):
    """Motion of a joint over the time of an impact."""

    joint: str
    """The joint."""
    rates: list[list[float]]
    """Velocities of the joint at each time, rad/s or m/s."""


class JointRateRecord(Record):
    """Rates of a joint before and after the impact."""

    joint: str
    """The joint."""
    before: list[float]
    """Velocities before the impact, rad/s or m/s, in the layout of the joint's kind."""
    after: list[float]
    """Velocities after the impact."""
    undetermined: bool
    """True if a motion without mass moves the joint: its rates after the impact are not determined."""


class JointRecord(Record):
    """A joint in a "CheckReport"."""

    name: str
    """Name of the joint."""
    kind: str
    """Kind of the joint."""
    parent: str
    """Parent link."""
    child: str
    """Child link."""
    axis: list[float] | None
    """Axis in the joint frame; None if the kind has no axis."""
    limits: list[float] | None
    """Position limits, rad or m."""
    armature: list[float]
    """Rotor inertia reflected to the joint, one value per velocity."""
    spring: list[float] | None
    """Stiffness (N·m/rad or N/m), damping (N·m·s/rad or N·s/m) and position without force (rad or m) of the spring of the
    joint."""
    gear: list[float] | None
    """Stiffness (N·m/rad or N/m) and damping (N·m·s/rad or N·s/m) of the elastic gear of the joint."""
    mimics: str | None
    """Master joint of a mimic."""


class JointSpringRecord(Record):
    """Spring and damper parallel to a joint during an impact in time: of the model, or given."""

    joint: str
    """The joint."""
    stiffness: float
    """Stiffness, N·m/rad or N/m."""
    damping: float
    """Damping, N·m·s/rad or N·s/m."""
    force_at_touch: float
    """Force or moment of the spring at the touch on the joint, N·m or N; 0 if only the change of the force acts."""


class KeptRecord(Record):
    """Link or point that stays in place."""

    link: str
    """The link."""
    point: list[float] | None
    """The point in the frame of the link, m; None for the position and the orientation of the link."""
    normal: list[float] | None
    """Direction (world axes) along which the coordinate of the point is kept; None for all directions."""


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


class KinematicLoadCase(Record):
    """Load on the wheels."""

    name: str
    """Name in the columns."""
    acts_at: str
    """"contact point" or "wheel centre" of a force, "wheel" of a moment."""
    direction: str
    """Direction of a positive load, on the left wheel."""
    left: list[float]
    """Force (N) or moment (N·m) on the left wheel, axes of the vehicle."""
    right: list[float]
    """Force or moment on the right wheel; for "single", that of the columns of the right wheel."""


class KinematicLoads(Record):
    """Loads of the motions per load: elastokinematics."""

    wheels: str
    """"single": the wheel of the quantity alone, on the right wheel the mirror image of the load on the left; "parallel": both
    wheels, the same vector; "opposed": both wheels, opposite vectors."""
    travel_held: bool
    """True if the heights of the wheel centres are held; false if springs, touched stops and anti-roll bar hold the wheels."""
    cases: list[KinematicLoadCase]
    """Loads of the columns. The wheels are locked to their carriers, and the tyres are left out."""


class KinematicsReport(Record):
    """Kinematics of a suspension."""

    schema: Literal["percuss.kinematics/1"]
    """"percuss.kinematics/1"."""
    percuss: str
    """Version of percuss."""
    inputs: list[Input]
    """Source files."""
    derivatives: str
    """Motion of the derivatives: "heave" (all wheels up) or "roll" (left up, right down)."""
    variable: str | None
    """Variable of the rows; None for a single row."""
    loads: KinematicLoads | None
    """Loads of the motions per load; None without compliance."""
    columns: list[KinematicColumn]
    """Columns, without the variable."""
    rows: list[dict[str, float | str | None]]
    """Rows."""
    compliance_matrices: list[list[list[float]] | None]
    """Compliance matrix of each row, empty without compliance: displacements (m) along x, y, z and rotations (rad) about them
    of the wheel centres per unit force (N) and moment (N·m), 6×6, or 12×12 with the left wheel first; None if a motion
    without stiffness gives way."""
    diagnostics: list[DiagnosticRecord]
    """Warnings and notes."""


class LawRecord(Record):
    """Result of one law of restitution; None if the law has no solution."""

    law: str
    """Law."""
    normal_impulse: float | None
    """Normal impulse, N·s."""
    tangential_impulse: float | None
    """Magnitude of the friction, N·s."""
    separation_speed: float | None
    """Separation speed, m/s."""
    energy_loss: float | None
    """Lost kinetic energy, J."""
    creates_energy: bool
    """True if the law creates energy: its result is not valid."""


class LinkMap(Record):
    """Summary of a link."""

    link: str
    """The link."""
    shapes: str
    """Shapes that form the surface: "collision" or "visual"."""
    contacts: int
    """Number of contacts, one per facet, along the outward normal."""
    finite: int
    """Number of contacts with a finite m̄."""
    immovable: int
    """Number of immovable contacts: no motion closes the gap."""
    massless: int
    """Number of massless contacts: a motion without mass closes the gap."""
    unanswered: int
    """Number of contacts without a result."""
    area: float
    """Area of the surface, m²."""
    smallest: Extreme | None
    """Contact with the smallest m̄; None without a finite m̄."""
    largest: Extreme | None
    """Contact with the largest finite m̄."""
    area_mean: float | None
    """Harmonic mean of m̄ over the area, kg: 1 over the mean of 1/m̄; 1/m̄ is 0 at immovable contacts. None if no contact is
    finite or any contact is massless."""
    worst_relative_error: float | None
    """Largest stated relative error; None if unknown."""
    orientation: OrientationRecord | None
    """Orientation of the mesh triangles; None without a mesh."""


class LinkRecord(Record):
    """A link in a "CheckReport"."""

    name: str
    """Name of the link."""
    mass: float
    """Mass, kg."""
    com: list[float] | None
    """Centre of mass in the link frame, m; None without mass."""
    has_inertial: bool
    """True if the link has an "<inertial>"."""
    geometry: str
    """Kind of the shape: "none", "primitives" or "mesh"."""


class LinkSensitivity(Record):
    """Sensitivity of m̄ to a link."""

    link: str
    """The link."""
    mass: float
    """Mass of the link, kg."""
    share: float
    """Share of the link in m̄."""
    per_kilogram: float
    """dm̄/dm = share · m̄ / m, kg/kg, with moments about the centre of mass in proportion to the mass."""
    per_metre_of_com: list[float] | None
    """dm̄/dc, kg/m, in the link's axes, with constant moments about the centre of mass. None if a velocity is undetermined."""


class ListedContact(Record):
    """Named contact with its result."""

    name: str
    """Name."""
    kind: str
    """"stop", "spring", "damper", "patch" or "other"."""
    report: MassReport | None
    """Result; None if the contact has none."""
    problem: str | None
    """Reason for a missing result."""
    remaining_gap: float | None
    """Smallest gap of a stop that cannot be reached, m, if known."""


class MapRecord(Record):
    """Report of "percuss map", as JSON. All keys are always present; a value is None if not applicable."""

    schema: Literal["percuss.map/1"]
    """"percuss.map/1"."""
    percuss: str
    """Version of percuss."""
    inputs: list[Input]
    """Input files."""
    links: list[LinkMap]
    """Summaries of the links."""
    left_out: list[OmittedLink]
    """Omitted links."""
    edge: float | None
    """Requested longest edge of a facet, m; None for a fraction of each link's size."""
    against: str | None
    """Other link; None for the ground."""
    conditions: ConditionsRecord
    """Conditions of the question."""
    singular_pose: bool
    """True if the pose is singular; every m̄ is then a lower bound."""
    degrees_of_freedom: int
    """dim ker A at the pose, including the 6 of a floating base."""
    pose: dict[str, list[float]]
    """Joint positions."""
    diagnostics: list[DiagnosticRecord]
    """Warnings and notes."""


class MassCertificateRecord(Record):
    """Proved bounds of m̄ at a pose, for rigid links, ideal joints, and the numbers of the model as read."""

    lower: float | None
    """Proved lower bound of m̄ in the unit of the report; None without a proof."""
    upper: float | None
    """Proved upper bound of m̄ in the unit of the report; None without a proof."""
    uniqueness: float | None
    """Distance of each dependent position, rad or m, within which no other assembly exists; None for a tree."""
    rows: int
    """Number of rows of the loops."""
    implied: int
    """Number of rows that are proved to be zero at all positions."""
    omitted: list[OmittedRowRecord]
    """Rows that are left out without a proof. "upper" then assumes that the loops have the mobility of the pose; "lower" holds
    without it."""
    reason: str | None
    """Reason for no proof; None with a proof."""


class MassChange(Record):
    """Change of mass that lowers m̄; the opposite change raises m̄."""

    link: str
    """The link."""
    lowers_by: float
    """Decrease of m̄ per kilogram of removed mass, kg, to first order."""


class MassExplanation(Record):
    """Change of the mass of a link at which the effective mass of the model is the identified one, to first order."""

    link: str
    """The link."""
    change: float
    """Change of its mass, kg."""
    relative_change: float
    """Change of its mass, relative."""


class MassReport(Record):
    """Report of "percuss mass", as JSON. All keys are always present; a value is None if not applicable."""

    schema: Literal["percuss.mass/1"]
    """"percuss.mass/1"."""
    percuss: str
    """Version of percuss."""
    inputs: list[Input]
    """Input files."""
    effective_mass: float | None
    """m̄ in the unit of "unit"; None unless finite."""
    unit: str
    """Unit of all effective masses: "kg"; "kg·m²" for a moment about an axis, and for the stop of a revolute joint."""
    status: Literal["finite", "immovable", "massless"]
    """Kind of result."""
    singular_pose: bool
    """True if the pose is singular: A has a lower rank than at a generic pose."""
    degrees_of_freedom: int
    """dim ker A at the pose, including the 6 of a floating base."""
    generic_degrees_of_freedom: int
    """dim ker A at a generic pose, including the 6 of a floating base."""
    redundant_constraints: int
    """Number of linearly dependent constraint rows."""
    rank_gap: float | None
    """Gap between the singular values of A above and below the rank; None without loops."""
    route: str
    """Method: "dense" or "articulated"."""
    condition: float | None
    """Condition number of the mass matrix scaled to unit diagonal; None if the matrix is singular or has more than 300
    coordinates."""
    effective_mass_error: float | None
    """Error bound of m̄, kg: sum of the known parts of the budget; None if the part of rounding or of loop closure is unknown."""
    error_budget: ErrorBudgetRecord
    """Parts of the error bound."""
    bodies: list[BodyShare]
    """Shares of the links, in file order."""
    rotors: list[RotorShare]
    """Shares of the rotors."""
    other_mass_share: float | None
    """Share of the other body, if given by its mass."""
    pose: dict[str, list[float]]
    """Position of every movable joint, in the layout of "--set"."""
    closure_residual: float | None
    """Closure residual of the loops, m; None without loops."""
    closure_inexactness: float | None
    """Closure error of the loops as given in the file, m; None without loops."""
    characteristic_length: float
    """Length that scales the rank decisions, m."""
    contact: ContactRecord
    """The contact."""
    named_contact: NamedContactRecord | None
    """Named contact; None for a contact given by link, point and normal."""
    joint_stop: StopRecord | None
    """Stop of a joint as the contact; None for other contacts."""
    conditions: ConditionsRecord
    """Conditions of the question."""
    other_base: OtherBaseRecord | None
    """m̄ with the chassis free, or held if the base floats; None unless the model is a suspension whose chassis has a mass."""
    drivers: list[str]
    """Joints that drive the loops."""
    assembly_modes: list[int]
    """Assembly mode of each group of loops: 1 or -1; 0 at a dead centre or a change point."""
    redundant_loops: list[list[str]]
    """Loops and couplings with redundant rows; entries that cannot be separated form one group."""
    branch_limits: list[float | None]
    """Limits of m̄ along the branches that cross at a singular pose, kg; None for a branch along which the gap does not close."""
    compliance: ComplianceRecord | None
    """Compliance of the bushes; None for a model without bushes."""
    estimate: EstimateRecord | None
    """Classical estimate, if requested."""
    motion_ratios: list[MotionRatioRecord]
    """Motion ratios relative to the contact: of the wheel, if the mechanism has named wheel points and the ratio holds for
    every motion, and of requested points."""
    friction_thresholds: FrictionThresholdsRecord | None
    """Coefficients of friction for sticking, jamming and wedging, if requested; None without a single finite effective mass."""
    explanation: Explanation | None
    """Sensitivities of m̄, if requested."""
    certificate: MassCertificateRecord | None
    """Proved bounds of m̄, if requested."""
    tolerance: ToleranceReport | None
    """Variation of m̄ within tolerances, if given."""
    damper: DampingReport | None
    """Damper for a restitution, if requested."""
    diagnostics: list[DiagnosticRecord]
    """Findings about the file and the result."""


class MassStateRecord(Record):
    """Mass of a contact for one state of rotors and joints."""

    state: str
    """"rotors-decoupled": all armatures are 0, as with compliant gears. "rotors-coupled": the rotors move with the joints, as
    in all other results. "joints-locked": all moving links form one free rigid body (composite rigid body). Impacts on
    robots with stiff joint control are often nearer to this mass. A mechanism with locked joints on a fixed base would be
    immovable."""
    sliding: float | None
    """Effective mass of a sliding contact point, 1/(nᵀΛ⁻¹n), kg; None if not finite."""
    sliding_status: Literal["finite", "immovable", "massless"]
    """Kind of this mass."""
    sticking: float | None
    """Mass of a contact point that cannot slide in the tangent plane, nᵀΛn, kg; None if not finite."""
    sticking_status: Literal["finite", "immovable", "massless"]
    """Kind of this mass."""


class MeasuredImpact(Record):
    """Measured impact of a file."""

    file: str
    """File."""
    columns: list[RecordColumn]
    """Columns that were used."""
    speed: Estimate
    """Approach speed, m/s."""
    restitution: Estimate
    """Rebound speed divided by approach speed."""
    peak_force: Estimate
    """Largest contact force, N."""
    max_penetration: Estimate
    """Largest penetration, m."""
    contact_duration: Estimate
    """Duration of the contact, s."""
    touch: Estimate
    """Time of the touch, s."""
    used: list[float]
    """First and last used time, s."""
    unused_samples: int
    """Number of samples outside these times."""
    signals: list[IdentifiedSignal]
    """Signals."""


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


class MimicJointRecord(Record):
    """Joint that follows the driving joint: position = multiplier · position of the driving joint + offset."""

    joint: str
    """The joint."""
    multiplier: float
    """Ratio of the positions: least-squares fit over the range."""
    offset: float
    """Position at the zero of the driving joint, rad or m."""
    position_error: float
    """Largest difference from the position in the linkage, rad or m."""


class MimicSubstituteRecord(Record):
    """Open tree of a linkage in which all dependent joints are mimic joints of the driving joint."""

    joints: list[MimicJointRecord]
    """Mimic joints."""
    inertias: list[float]
    """Inertia of this tree at the driving joint at each position, kg·m² or kg; without the additional armature."""
    armature: float
    """Armature in addition to the armature of the driving joint, kg·m² or kg: it minimises the largest relative error. Can be
    negative."""
    largest_error: float
    """Largest relative error of the reflected inertia over the range, with this armature."""


class ModeRecord(Record):
    """Natural mode of the mechanism with bushes."""

    frequency: float
    """Natural frequency, Hz; 0 for a motion without stiffness."""
    damping_ratio: float
    """Damping ratio of dampers and loss factors, to first order."""
    participation: float
    """Participation φ² of the contact in the mass-normalised shape, 1/kg: 1/m_app = Σ φ² ω²/(ω² − ωᵢ²)."""
    share: float | None
    """Part of the mode in 1/m_free, from 0 to 1; None if the contact is massless with free bushes."""
    links: list[ModeShareRecord]
    """Links with their shares of the kinetic energy, the largest first, at most three: the first names the shape."""
    elements: list[ModeShareRecord]
    """Bushes, springs and directions with their shares of the elastic energy, the largest first, at most three."""


class ModeShareRecord(Record):
    """Share of a link or of an element in the energy of a mode."""

    name: str
    """The link; the element with its direction."""
    share: float
    """Share, from 0 to 1."""


class MotionForceRecord(Record):
    """Force in a bearing that the velocities before the impact cause alone; it is quadratic in the rates."""

    place: Literal["ground", "joint", "closure", "hold"]
    """Place."""
    name: str
    """Name of the joint or closure; of the held link; of the root link."""
    force: float
    """Magnitude of the determinate components of the force, N."""
    ratio: float
    """Ratio of this force to the peak force of the bearing."""


class MotionRatioRecord(Record):
    """Motion ratio of the contact relative to a point, in the motion v*: closing of the contact per travel of the point, such
    as spring compression per wheel travel."""

    link: str
    """Link of the point: "wheel_centre" or "contact_patch" if the model has these links, or the requested link."""
    point: list[float]
    """The point in the link's frame, m."""
    direction: list[float]
    """Direction of the speed, a unit vector in world axes."""
    contact_per_wheel: float | None
    """Closing speed of the contact per speed of the point along the direction (rad/m for a moment); negative if the contact
    closes while the point moves against the direction. None if the point does not move."""
    one_travel: bool
    """True if every motion of the mechanism has this ratio; otherwise the ratio holds for the motion v* only."""
    held: str | None
    """Joint that is held for this ratio, although it moves in the impact: the rack of a steered axle; None if none is."""


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


class OmittedLink(Record):
    """Link omitted from the map."""

    link: str
    """The link."""
    reason: str
    """Reason."""


class OmittedRowRecord(Record):
    """Rows of a constraint that the proof leaves out, without a proof that the other rows imply them."""

    constraint: str
    """Name of the closure or coupling."""
    residual: float
    """Largest error of the row at the proved assembly, m or rad."""


class OrientationRecord(Record):
    """Orientation of mesh triangles, so that the normals point outward."""

    pieces: int
    """Connected pieces of the meshes."""
    turned: int
    """Number of reversed triangles."""
    open: int
    """Open pieces without an interior; the normals point away from the centre of the mesh."""
    conflicting: int
    """Pieces without a consistent orientation."""


class OtherBaseRecord(Record):
    """Effective mass with the other kind of base, all else equal."""

    base: str
    """"fixed" or "floating"."""
    link: str
    """Root link, which this base holds or sets free."""
    effective_mass: float | None
    """m̄ in the unit of the report; None unless finite."""
    effective_mass_error: float | None
    """Error bound of m̄, as "effective_mass_error"."""
    status: Literal["finite", "immovable", "massless"]
    """Kind of result."""


class OtherBodyRecord(Record):
    """Free body on the other side."""

    mass: float
    """Mass, kg."""
    speed_change: float
    """Change of its velocity along the normal, m/s."""


class PathPlace(Record):
    """Value of the varied number of a path, linear between two rows."""

    name: str
    """Name of the column: the joint, or the travel."""
    value: float
    """Value in the unit."""
    unit: str
    """Unit: "rad" or "m"; empty for the components of a quaternion."""


class PathRecord(Record):
    """Path of a search."""

    joints: list[str]
    """Moved joints."""
    rows: int
    """Number of rows."""
    unreached: int
    """Number of rows whose pose is not reachable; a straight line joins the rows before and after them."""


class Penetration(Record):
    """Greatest penetration of an impact."""

    solver: str
    """Solver or mode of the tool, empty if there is only one."""
    value: float
    """Value in "unit"."""
    unit: str
    """m; rad for a stop that turns."""


class PercussionRecord(Record):
    """Centre of percussion of a joint, a closure or the ground."""

    joint: str
    """Bearing with the least impulse: name of a joint or of a closure, or "ground"."""
    direction: list[float] | None
    """Direction of the line, axes of the contact link; None for the tangent plane."""
    point_link: list[float]
    """Best contact point, frame of the contact link, m."""
    point_world: list[float]
    """The same point in the world, m."""
    distance: float
    """Displacement from the given contact point, m."""
    given_ratio: float
    """Impulse at the joint for the given point, per impulse at the contact."""
    remaining_ratio: float
    """Remaining impulse at the joint for the best point, per impulse at the contact. Both ratios are those of the determinate
    components."""
    open_components: list[bool]
    """True for each component of the impulse (two transverse directions, the axis of the joint) that redundant loops leave
    open."""
    open_by: list[str]
    """Loops that leave these components open."""
    worst_ratio: float | None
    """Largest impulse at the joint, per impulse at the contact, for contact points displaced by at most the given distance in
    the tangent plane; None without a distance."""
    worst_point_link: list[float] | None
    """Contact point with this impulse, frame of the contact link, m."""


class PhaseRecord(Record):
    """Phase of an impact with friction."""

    kind: str
    """"slip", "jam", "stick" or "reverse slip"."""
    stage: str
    """"compression" or "expansion"."""
    normal_impulse: float
    """Normal impulse of the phase, N·s."""


class PointChange(Record):
    """Displacement that lowers m̄; the opposite displacement raises m̄."""

    point: str
    """The hardpoint."""
    direction: list[float]
    """Direction of the displacement, a unit vector in the sheet's axes."""
    lowers_by: float
    """Decrease of m̄ per millimetre, kg, to first order."""


class PointDamperRecord(Record):
    """Damper between two points during an impact in time."""

    name: str
    """Named contact of the suspension sheet, or both links of a given damper."""
    speeds: list[float]
    """Speeds of the force curve, m/s, positive in rebound."""
    forces: list[float]
    """Force at each speed, N."""


class PointMapReport(Record):
    """Report of "percuss map --point", as JSON."""

    schema: Literal["percuss.map-point/1"]
    """"percuss.map-point/1"."""
    percuss: str
    """Version of percuss."""
    inputs: list[Input]
    """Input files."""
    link: str
    """The link."""
    point_link: list[float]
    """Point, link's frame, m."""
    point_world: list[float]
    """Point, world frame, m."""
    principal: list[DirectionMass]
    """The three directions with stationary m̄, from the lightest to the heaviest; empty if any of them has no result."""
    directions: list[DirectionMass]
    """Directions distributed evenly over the sphere."""
    against: str | None
    """Other link; None for the ground."""
    conditions: ConditionsRecord
    """Conditions of the question."""
    singular_pose: bool
    """True if the pose is singular; every m̄ is then a lower bound."""
    pose: dict[str, list[float]]
    """Joint positions."""
    diagnostics: list[DiagnosticRecord]
    """Warnings and notes."""


class PointSensitivity(Record):
    """Sensitivity of m̄ to a hardpoint."""

    point: str
    """The hardpoint."""
    per_metre: list[float] | None
    """dm̄/dx, dm̄/dy, dm̄/dz, kg/m, in the sheet's axes; None if the question has no result at a neighbouring design."""
    per_metre_error: float | None
    """Error estimate of the differences, kg/m."""


class PointSpringRecord(Record):
    """Spring between two points during an impact in time."""

    name: str
    """Named contact of the suspension sheet, or both links of a given spring."""
    rate: float
    """Rate, N/m."""
    force_at_touch: float
    """Force at the touch, N, positive in compression; 0 if only the change of the force acts."""
    force_at_end: float
    """Force at the end of the contact, N."""


class ProvedPatchRecord(Record):
    """Part of the surface of a link with the largest bound of m̄."""

    link: str
    """The link."""
    patches: int
    """Number of parts of the surface."""
    point: list[float]
    """First point of the part in the frame of the link, m: on the axis of a curved part."""
    normal: list[float]
    """Outward normal of a flat part; axis of a curved part."""
    edges: list[list[float]]
    """Edges of the part from the point, m; the radius of a disc, the length of a cylinder."""
    is_curved: bool
    """True for a part of a sphere or a cylinder."""


class ProvedSpeedRecord(Record):
    """Speed that holds for all positions in ranges of joints, for rigid links, ideal joints, and the numbers of the model as
    read."""

    speed: SpeedRecord | None
    """Speed for the upper bound of m̄, and for an immovable robot if no bound is proved; None without a certificate."""
    is_sharp: bool
    """True if the bounds of the largest m̄ agree within the tolerance; otherwise the speed is lower than necessary."""
    surface: ProvedPatchRecord | None
    """Part of the surface with the largest bound, of the shapes that are read: boxes, spheres, cylinders, capsules and meshes;
    None for the contact of the question."""
    segments: int | None
    """Number of segments between rows of positions; None for ranges."""
    slowest_segment: int | None
    """Segment with the largest bound, from 0, from the row of this number to the next one; None for ranges."""
    share_above_standard: float | None
    """Share of the positions at which the standard's mass is too small: m̄ of the given normal and point at sampled positions
    of the ranges, or segments with a proved larger m̄. From 0 to 1; None without an answer."""
    certificate: ExtremesCertificateRecord
    """Proved bounds of the largest m̄ over the ranges, or over the segment and the part of the surface with the largest bound."""


class RatesAfterRecord(Record):
    """Rates of a joint after an impact."""

    joint: str
    """The joint."""
    after: list[float]
    """Velocities after the impact, rad/s or m/s."""


class ReachableSpeedRecord(Record):
    """Greatest closing speed within the rate limits of the joints."""

    speed: float
    """Closing speed at the pose, m/s."""
    limited_by: list[str]
    """Joints whose rate limits determine this speed."""


class ReachedTarget(Record):
    """Value reached for a target, SI units."""

    quantity: str
    """Column."""
    required: float
    """Required value."""
    old: float
    """Value before the search."""
    reached: float
    """Value at the new coordinates."""


class ReactionRecord(Record):
    """Impulsive reaction at one place, component by component. None marks components that redundant loops leave open."""

    place: Literal["ground", "joint", "closure", "hold"]
    """Place."""
    name: str
    """Name of the joint or closure; of the held link; of the root link."""
    on: str | None
    """Link on which the reaction acts; None for the ground."""
    point_world: list[float]
    """Point to which the moment refers, world frame, m."""
    axes_world: list[list[float]]
    """Unit vectors of the components, world axes: two transverse directions, then the axis of the joint."""
    force: list[float | None]
    """Impulse along the axes, N·s."""
    moment: list[float | None]
    """Moment impulse about the point, N·m·s."""
    open_by: list[str]
    """Loops whose redundancy leaves components open."""
    gear: list[float]
    """Impulse in the gear of each velocity of the joint, armature · Δq̇, N·m·s or N·s; empty without a joint."""
    constraint: list[float | None]
    """Sum of the impulses of the lock, the mimics and the couplings on each velocity of the joint, N·m·s or N·s; empty without
    a joint. "joint_constraints" of the report contains the single impulses."""
    peak_force: list[float | None] | None
    """Largest force along the axes in a compliant contact, N; None without a contact law."""
    peak_moment: list[float | None] | None
    """Largest moment in a compliant contact, N·m; None without a contact law."""


class ReboundRecord(Record):
    """Impact at one approach speed."""

    solver: str
    """Solver or mode of the simulator; empty if there is only one."""
    speed: float
    """Approach speed, m/s."""
    restitution: float
    """Rebound speed divided by approach speed."""
    error_bound: float | None
    """Error bound of the restitution at the time step of the simulator; None if unknown, and without a simulator."""
    rebound_speed: float
    """Rebound speed, m/s."""
    contact_duration: float | None
    """Duration of the contact, s; None for a rigid contact, for Adams, and if the gap never closes."""
    max_penetration: float | None
    """Largest penetration, m; None for a rigid contact."""
    peak_force: float | None
    """Largest force, N; None for a rigid contact and for Adams."""
    energy_lost: float
    """Lost energy, J."""


class RecordColumn(Record):
    """Column of a record and what it is taken for."""

    column: str
    """Name in the file."""
    quantity: str
    """"time", "force", "acceleration", "velocity" or "displacement"."""
    unit: str
    """Unit."""


class ReflectedRangeRecord(Record):
    """Inertia reflected to a joint over a range of its positions."""

    joint: str
    """The joint."""
    unit: str
    """Unit: "kg·m²" or "kg"."""
    positions: list[float]
    """Positions of the joint, rad or m."""
    free: list[float | None]
    """Inertia with all other joints free at each position; None if not finite."""
    held: list[float | None]
    """Inertia with the other drivers at rest; None if not finite, and for a joint that is no driver."""
    least: float | None
    """Smallest finite held inertia (free for a joint that is no driver); None if no inertia is finite."""
    most: float | None
    """Largest finite held inertia."""
    best_constant: float | None
    """Constant armature that minimises the largest relative error: the harmonic mean of "least" and "most"; None unless the
    inertia is finite at all positions."""
    largest_error: float | None
    """Largest relative error of this constant; None without a constant."""
    substitute: MimicSubstituteRecord | None
    """Substitute for simulators without loops: the open tree with mimic joints and an additional armature. None if the joint is
    no driver, if an inertia is not finite, and if no other joint or a joint with several velocities moves with the joint."""
    substitute_refused_by: str | None
    """Joint with several velocities that moves with the joint: the reason for a missing substitute; None otherwise."""


class ReflectedRecord(Record):
    """Inertia reflected to a joint."""

    joint: str
    """The joint."""
    component: int
    """Index of the velocity within the joint."""
    direction: str | None
    """Label of a velocity of a joint with several velocities: "about x", "along y", "about the normal"; None for one velocity.
    x, y and z are the axes of the child link; for a planar joint, x and y are the two axes of the plane."""
    unit: str
    """Unit: "kg·m²" or "kg"."""
    free: float | None
    """Inertia with all other joints free; None if not finite."""
    free_status: Literal["finite", "immovable", "massless"]
    """Kind of "free"."""
    held: float | None
    """Inertia with the other drivers at rest; None if not finite, and for a joint that is no driver."""
    held_status: Literal["finite", "immovable", "massless"] | None
    """Kind of "held"; None for a joint that is no driver."""
    other_drivers: list[str]
    """The other drivers, which are at rest for "held". Joints whose positions are given drive; the others are chosen
    automatically."""


class ReflectedReport(Record):
    """Reflected inertias without a contact, as JSON."""

    schema: Literal["percuss.reflected/1"]
    """"percuss.reflected/1"."""
    percuss: str
    """Version of percuss."""
    inputs: list[Input]
    """Input files."""
    pose: dict[str, list[float]]
    """Joint positions."""
    conditions: ConditionsRecord
    """Conditions."""
    drivers: list[str]
    """Driving joints: the drivers of the loops, and the joints outside loops."""
    reflected_inertia: list[ReflectedRecord]
    """Reflected inertias at the pose."""
    reflected_over: list[ReflectedRangeRecord]
    """Reflected inertias over ranges of positions."""
    diagnostics: list[DiagnosticRecord]
    """Findings about the file and the result."""


class RelationTermRecord(Record):
    """Joint of a relation in a "ClosureRecord"."""

    joint: str
    """Joint."""
    coefficient: float
    """Coefficient of its position."""


class RequestReport(Record):
    """Results of all tables of a study. The key of a table is absent if the study does not have the table."""

    schema: Literal["percuss.report/1"]
    """"percuss.report/1"."""
    percuss: str
    """Version of percuss."""
    check: CheckReport | None
    """Contents of the model."""
    comparison: ComparisonReport | None
    """Comparison of several contacts and variants."""
    contacts: ContactListReport | None
    """All contacts of a study with several."""
    convert: ConversionReport | None
    """The model in another format."""
    damping: DampingReport | None
    """Damper at the stop of a joint."""
    export: ExportReport | None
    """The impact as a model for MuJoCo."""
    extremes: ExtremesReport | None
    """Extremes."""
    generate: CodeReport | None
    """Source code of the effective mass at the contact."""
    identify: IdentificationReport | None
    """Contact of measured impacts."""
    impact: ImpactReport | None
    """Impact."""
    kinematics: KinematicsReport | None
    """Kinematics of a suspension."""
    map: MapRecord | PointMapReport | None
    """Map."""
    mass: MassReport | None
    """The contact at its pose, with the results of "[mass]" and the damper of "[damping]"."""
    mass_problem: str | None
    """Reason for a missing effective mass at the pose, for a study with a sweep or variants."""
    response: ResponseReport | None
    """Response over frequency."""
    restitution: RestitutionReport | None
    """Restitution of a spring and damper."""
    safe_speed: list[SafeSpeedReport] | None
    """Safe speeds."""
    sweep: SweepReport | None
    """Rows of the sweep."""
    targets: TargetReport | None
    """Search for required values of a suspension."""


class ResponseReport(Record):
    """Report of "percuss response", as JSON. Units of a contact along a normal; N·m for N, rad for m and kg·m² for kg at a
    moment."""

    schema: Literal["percuss.response/1"]
    """"percuss.response/1"."""
    percuss: str
    """Version of percuss."""
    inputs: list[Input]
    """Input files."""
    named_contact: NamedContactRecord | None
    """Named contact; None for a contact given by link, point and normal."""
    link: str
    """Contact link."""
    effective_mass: float | None
    """m̄ with rigid bushes in the unit of "unit"; None unless finite."""
    status: Literal["finite", "immovable", "massless"]
    """Kind of result with rigid bushes."""
    unit: str
    """Unit of masses: "kg", or "kg·m²" for a moment about an axis."""
    is_moment: bool
    """True for a moment about an axis."""
    compliance: ComplianceRecord | None
    """Free mass and residual stiffness; None for a model without bushes in place of joints."""
    static_stiffness: float | None
    """Static stiffness of the contact, N/m; None if a motion without stiffness closes the gap."""
    frequency: list[float]
    """Frequencies, Hz."""
    apparent_mass: ComplexSeries
    """Apparent mass F/ẍ = −1/(ω²h), kg."""
    accelerance: ComplexSeries
    """Accelerance ẍ/F, 1/kg."""
    mobility: ComplexSeries
    """Mobility ẋ/F, m/(N·s)."""
    dynamic_stiffness: ComplexSeries
    """Dynamic stiffness F/x = 1/h, N/m."""
    over_stiffness: list[UndampedImpactRecord]
    """Impacts on contacts without damping over their stiffness, with the elastic bushes and gears alone: from soft contacts,
    which meet the rigid mass, to stiff ones, which meet the free mass first; empty without bushes and gears."""
    modes: list[ModeRecord]
    """Natural modes in ascending order of the frequency."""
    diagnostics: list[DiagnosticRecord]
    """Findings about the file and the result."""


class RestRecord(Record):
    """Penetration at rest."""

    solver: str
    """Solver or mode of the simulator; empty if there is only one."""
    load: float
    """Force along the normal, N."""
    penetration: float | None
    """Penetration, m; None for a rigid contact."""


class RestitutionReport(Record):
    """Report of "percuss restitution", as JSON."""

    schema: Literal["percuss.restitution/1"]
    """"percuss.restitution/1"."""
    percuss: str
    """Version of percuss."""
    inputs: list[Input]
    """Input files; empty if the mass is given directly."""
    effective_mass: float
    """m̄, kg."""
    named_contact: NamedContactRecord | None
    """Named contact; None for a contact given by link, point and normal."""
    tool: str | None
    """Simulator; None for a given spring and damper."""
    stiffness_curve: ForceCurveRecord | None
    """Force curve of the contact; None for a stiffness or a simulator."""
    impacts: list[ReboundRecord]
    """Impacts, for each solver in the order of the speeds."""
    at_rest: list[RestRecord]
    """Penetration at rest in each solver; empty without a load."""
    diagnostics: list[DiagnosticRecord]
    """Findings about the file and the result."""


class RotorSensitivity(Record):
    """Sensitivity of m̄ to the armature of a joint."""

    joint: str
    """The joint."""
    per_armature: list[float]
    """dm̄/dI = q̇² for each velocity, kg/(kg·m²) for a rotation, kg/kg for a translation."""


class RotorShare(Record):
    """Share of a rotor in m̄."""

    joint: str
    """Joint driven by the rotor."""
    share: float | None
    """Share of the kinetic energy at unit closing speed; None unless m̄ is finite."""


class SafeSpeedReport(Record):
    """Report of "percuss safe-speed", as JSON."""

    schema: Literal["percuss.safe-speed/2"]
    """"percuss.safe-speed/2"."""
    percuss: str
    """Version of percuss."""
    inputs: list[Input]
    """Input files."""
    region: str | None
    """Body region; None for a body that cannot move."""
    region_mass: float | None
    """Effective mass of the region, kg."""
    region_stiffness: float | None
    """Stiffness of the region, N/m."""
    region_note: str | None
    """Note about uncertain values of the region."""
    limited_by: str
    """Limited quantity: "force", "pressure", "energy" or "momentum"."""
    force: float | None
    """Largest force, N, at the speed for the standard's mass; None without a region."""
    energy: float
    """Energy of the impact, J, at the speed for the standard's mass."""
    standard: SpeedRecord
    """Speed for the standard's mass M/2 + m_L; without a region for the full moving mass, M + m_L."""
    reflected: SpeedRecord
    """Speed for the effective mass at the contact."""
    reachable: ReachableSpeedRecord | None
    """Greatest closing speed within the rate limits of the joints ("velocity" in URDF); None if no motion closes the gap, or if
    a motion without limited joints closes the gap."""
    normal_world: list[float]
    """Contact normal, out of the robot, world axes."""
    moving_mass: float
    """M: mass of all links that can move, kg."""
    load: float
    """m_L: load, kg."""
    proved: ProvedSpeedRecord | None
    """Speed that is proved for all positions in the ranges; None without a proof."""
    along: AlongRecord | None
    """Slowest row, if there are rows of positions."""
    diagnostics: list[DiagnosticRecord]
    """Findings."""


class SampleRecord(Record):
    """m̄ of designs with random deviations, uniform between the limits."""

    count: int
    """Number of samples with a finite m̄."""
    unanswered: int
    """Number of samples without a finite m̄."""
    seed: int
    """The seed."""
    mean: float
    """Mean, kg."""
    standard_deviation: float
    """Standard deviation, kg."""
    least: float
    """Smallest m̄, kg."""
    greatest: float
    """Largest m̄, kg."""
    percentile_2_5: float
    """2.5th percentile, kg."""
    percentile_97_5: float
    """97.5th percentile, kg."""


class SecondHitRecord(Record):
    """Second touch after the separation."""

    time: float
    """Time since the first touch, s."""
    speed: float
    """Closing speed, m/s."""


class SecondTouchRecord(Record):
    """Second touch of a contact after its end."""

    time: float
    """Time since the first touch, s."""
    speed: float
    """Closing speed, m/s."""


class SimultaneousLawRecord(Record):
    """Result of one law for several contacts without friction."""

    law: str
    """"newton", "poisson" or "energetic"."""
    impulses: list[float | None]
    """Normal impulse of each contact, N·s; None if redundant contacts leave it open, or if the contact cannot move."""
    opening_speeds: list[float]
    """Opening speed of each contact after the impact, m/s; empty if the law has no solution."""
    energy_loss: float | None
    """Lost kinetic energy, J; None if the law has no solution."""
    creates_energy: bool
    """True if the law creates energy: its result is not valid."""
    rates: list[RatesAfterRecord]
    """Rates of all movable joints after the impact."""
    refusal: str | None
    """Reason why the law has no solution; None otherwise."""


class SimultaneousRecord(Record):
    """Impact of several contacts at once."""

    contacts: list[TouchingRecord]
    """The contacts; the first is that of all other results."""
    delassus: list[list[float]]
    """Delassus matrix W, 1/kg: three rows for each contact, the opening direction and two tangents. For a moment: angular
    velocities about these axes; its block is in 1/(kg·m²)."""
    delassus_axes_world: list[list[list[float]]]
    """Axes of the rows: for each contact the opening direction and the two tangents, world axes."""
    stiffness_ratios: list[float]
    """Stiffness of each contact relative to the first, in the energetic law."""
    contact_exponent: float
    """Exponent of the contact forces in the energetic law."""
    laws: list[SimultaneousLawRecord]
    """Results of the laws without friction; empty for one contact."""
    spread: float | None
    """Largest difference of an opening speed between two laws, divided by the largest closing speed; None for one contact. If
    some contacts are moments and others forces, each speed is first multiplied by the square root of the effective mass (kg,
    or kg·m² for a moment) of its contact."""
    sticking: StickingRecord | None
    """Plastic impact with sticking points, if requested."""


class Snippet(Record):
    """Text for a file of the tool."""

    title: str
    """Title."""
    language: str
    """Language: "xml", "python", "cpp", "rust", "matlab", "javascript", "adams"."""
    text: str
    """Well-formed text; numbers have all their digits."""


class SpeedRecord(Record):
    """Speed for one mass of the robot."""

    robot_mass: float | None
    """Robot mass m_R, kg: the mass of the standard, or the effective mass plus its error bound (at a singular pose the largest
    limit along the branches). None if the robot is immovable."""
    reduced_mass: float | None
    """μ = 1/(1/m_H + 1/m_R), kg; None if neither side can move."""
    speed: float
    """Largest relative speed, m/s."""


class StickingRecord(Record):
    """Plastic impact with sticking points."""

    sticks: list[bool]
    """For each contact: true if it sticks, false if it lets go."""
    normal_impulses: list[float | None]
    """Normal impulse of each contact, N·s; None if open."""
    tangential_impulses: list[float | None]
    """Magnitude of the tangential impulse, N·s; None if open."""
    required_friction: list[float | None]
    """Coefficient of friction that the sticking needs; None if open, and for contacts that let go."""
    least_friction: float | None
    """Least coefficient of friction for which all these contacts can stick: with redundant contacts, over all distributions of
    the open impulses. None if none suffices: a contact has a tangential impulse without a normal one."""
    friction_suffices: bool | None
    """True if the given friction suffices for all contacts to stick; None without a given friction."""
    opening_speeds: list[float]
    """Opening speed of each contact after the impact, m/s."""
    energy_loss: float
    """Lost kinetic energy, J."""
    consistent_subsets: int
    """Number of subsets of sticking contacts without pulling and closing contacts; that with the most contacts is given."""
    coordinates: list[str]
    """Names of the rates of the impact map: joints, with the number of the velocity, and "base"."""
    impact_map: list[list[float]]
    """Impact map Δ: q̇⁺ = Δ q̇⁻ over these rates."""
    rates: list[RatesAfterRecord]
    """Rates of all movable joints after the impact."""


class StopRecord(Record):
    """Stop of a joint, in reports."""

    joint: str
    """The joint."""
    motion: Literal["turn", "slide"]
    """Motion of the joint. "turn": the mass is an inertia in kg·m², the stiffness is in N·m/rad, the speed in rad/s, and so on.
    "slide": kg, N/m, m/s."""


class SweepReport(Record):
    """A sweep with all its rows."""

    schema: Literal["percuss.sweep/2"]
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
    rows: list[SweepRow]
    """All rows."""
    diagnostics: list[DiagnosticRecord]
    """Findings about the file and the rows."""
    motion_ratio_of: str | None
    """Travel of the motion ratio: the name of the varied travel, or "estimate" for the point of the estimate. The ratio of one
    point holds for the motion of the impact (with a sliding rack held, and without spin of a wheel with the contact on it).
    The ratio of "heave" or "roll" holds for this motion of the wheels, per upward travel of the wheel on the side of the
    contact. The key is absent without a motion ratio."""


class SweepRow(Record):
    """A row of a sweep."""

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
    pose: dict[str, list[float]]
    """Position of every movable joint; empty if the pose was not reached."""
    error: str | None
    """Reason for a missing result."""
    gap: float | None
    """Gap of the named contact at the pose of the row, m, negative for a penetration; None without a pose. The key is absent
    for a contact without a gap."""
    gradient: dict[str, list[float]] | None
    """Gradient of m̄, one number per velocity of every movable joint, kg/rad or kg/m; empty unless m̄ is finite. The key is
    absent unless gradients are requested."""


class TargetReport(Record):
    """Result of a search."""

    schema: Literal["percuss.target/1"]
    """"percuss.target/1"."""
    percuss: str
    """Version of percuss."""
    inputs: list[Input]
    """Source files."""
    is_reached: bool
    """True if all values are reached."""
    within: float
    """Largest change of a coordinate, m."""
    loads: KinematicLoads | None
    """Loads of the motions per load; None without compliance."""
    coordinates: list[FoundCoordinate]
    """Coordinates."""
    targets: list[ReachedTarget]
    """Quantities."""
    evaluations: int
    """Number of evaluated designs."""
    moves: list[list[list[float] | str]]
    """Displacements of the hardpoints, m, in the axes of the sheet, as for "--move"."""
    link_masses: list[list[float | str]]
    """Masses of links, kg, as for "--link-mass"."""
    diagnostics: list[DiagnosticRecord]
    """Findings about the file, and about the contacts of the values in the design found."""


class TextFile(Record):
    """File as text."""

    name: str
    """Name of the file."""
    text: str
    """Content of the file."""


class Tolerance(Record):
    """Tolerances of the parts of a model. Each number varies independently by at most the tolerance to either side."""

    mass: float
    """Mass of each link, relative; the moments of inertia change in proportion."""
    com: float
    """Each coordinate of the centre of mass of each link, m."""
    armature: float
    """Armature of each joint, relative."""
    point: float
    """Each coordinate of each hardpoint of a sheet, m."""


class ToleranceParts(Record):
    """First-order variation of m̄ due to each kind of number, kg, as root sum square."""

    mass: float
    """Masses of links."""
    com: float
    """Centres of mass."""
    armature: float
    """Armatures."""
    point: float
    """Hardpoints."""


class ToleranceReport(Record):
    """Variation of m̄ within tolerances."""

    effective_mass: float
    """m̄, kg."""
    tolerance: Tolerance
    """Tolerances."""
    root_sum_square: float
    """First-order variation of m̄, kg: root sum square of the effects of all numbers at their limits, for independent numbers."""
    worst_case: float
    """First-order variation of m̄, kg: sum of the absolute effects of all numbers at their limits."""
    parts: ToleranceParts
    """Root sum square of each kind of number, kg."""
    samples: SampleRecord | None
    """Random samples, if requested."""


class TouchingRecord(Record):
    """One of several contacts."""

    name: str
    """Name of the contact, or its link and number."""
    is_joint_stop: bool
    """True for the stop of a joint."""
    is_moment: bool
    """True for a moment about an axis, and for the stop of a revolute joint: masses in kg·m², speeds in rad/s, impulses in
    N·m·s."""
    link: str
    """Contact link."""
    point_world: list[float]
    """Point, world frame, m."""
    normal_world: list[float]
    """Normal out of the contact link, world axes."""
    gap: float | None
    """Gap at the pose: of a named contact, m; of the stop of a joint with limits, the distance of the joint from the stop, rad
    or m. The results assume a gap of zero. None for other contacts, and for the first contact."""
    closing_speed: float
    """Closing speed before the impact, m/s (rad/s for a moment, whose masses below are in kg·m²); negative if the gap opens."""
    effective_mass: float | None
    """Effective mass of the contact alone, kg; None if immovable."""
    principal_masses: list[float | None]
    """Principal masses of the point, kg, ascending; None for a direction in which it cannot move. For a moment: principal
    inertias, kg·m²."""
    principal_directions_world: list[list[float]]
    """Directions of the principal masses, world axes."""


class TravelRecord(Record):
    """A travel that drove the pose."""

    motion: str
    """"point", or the motion of the wheels: "wheel-travel", "heave", "roll"."""
    link: str | None
    """The link; None for a motion of the wheels, as are the next two."""
    point: list[float] | None
    """The point, m, link's frame."""
    direction: list[float] | None
    """Direction, world axes."""
    distance: float
    """Displacement, m."""


class TreeRecord(Record):
    """Bodies, contact and ranges of a proof, as enclosures: pairs of a lower and an upper bound."""

    bodies: list[list[float]]
    """One row per body, parents first: parent (−1: ground), motion (0 fixed, 1 hinge about z, 2 slider along z), index of the
    position, coordinate (−1: none), then pairs: factor and offset of the position, factor and armature of the rate, rotation
    (9, by rows) and translation (3) of the joint frame in the parent, mass, first moment (3), moments of inertia (9) in the
    body's frame."""
    contact: list[float]
    """Body, 1 for a moment, 1 for a normal fixed in the root link; then pairs: point (3), normal (3)."""
    positions: list[list[float]]
    """Positions of all joints."""
    ranges: list[list[float | int]]
    """Index of the position, lower and upper end of each range, rad or m."""


class TyreRecord(Record):
    """Tyre during an impact in time: a vertical force on the wheel centre that never pulls."""

    name: str
    """Link of the wheel centre."""
    rate: float
    """Vertical stiffness, N/m."""
    damping: float
    """Damping, N·s/m."""
    force_at_touch: float
    """Force at the touch, N: as given, or the force that balances the springs of this side."""
    leaves_road_at: float | None
    """Time of the first sample without force, s: the tyre has left the road; None if it keeps contact."""


class UndampedImpactRecord(Record):
    """Impact of a mechanism with elastic bushes and gears on a linear contact without damping."""

    stiffness: float
    """Stiffness k of the contact, N/m."""
    impulse_mass: float
    """m_imp = P/(v⁻ + v⁺), kg: mass of a free body with the same impulse P between the same speeds."""
    force_mass: float
    """F²/(k v²), kg: mass of a free body with the same peak force F."""
    restitution: float
    """Separation speed divided by closing speed."""
    duration: float | None
    """Duration of the contact, s; None without a separation."""
    most_impulse_mass: float | None
    """Largest m_imp by the proof, 2 m̄/(1 + e), kg; None if a stiffness or a damping acts along the motion. The least is the
    free mass."""


class VariedColumn(Record):
    """Varied column: a component of a joint position, or the travel of a point."""

    name: str
    """Name of the column: the joint; "JOINT[0]", "JOINT[1]", … for a joint with several numbers; or "travel:LINK"."""
    unit: str
    """Unit: "rad" or "m"; empty for the components of a quaternion."""


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


class WheelTravelRecord(Record):
    """Upward travel of a wheel centre, m."""

    link: str
    """Link at the wheel centre."""
    travel: float
    """Travel, m."""
