"""Records of reports: MassReport, ContactListReport. Written by tests/records.py."""

from __future__ import annotations

from typing import Literal

from .damping import DampingReport, DiagnosticRecord, Input, NamedContactRecord, StopRecord
from .record import Record


class ErrorBudgetRecord(Record):
    """Parts of the error bound of m̄, kg; None if a part is unknown or m̄ is not finite."""

    rounding: float | None
    """Rounding of positions, frames and constraint rows, and of the computation."""
    closing: float | None
    """Part due to the closure residual of the loops."""
    file: float | None
    """Part due to inexact loops in the file."""


class BodyShare(Record):
    """Share of a link in m̄."""

    link: str
    """The link."""
    share: float | None
    """Share of the kinetic energy at unit closing speed; None unless m̄ is finite."""


class RotorShare(Record):
    """Share of a rotor in m̄."""

    joint: str
    """Joint driven by the rotor."""
    share: float | None
    """Share of the kinetic energy at unit closing speed; None unless m̄ is finite."""


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


class HoldRecord(Record):
    """A held point."""

    link: str
    """The link."""
    point: list[float]
    """The point in the link's frame, m."""
    normal: list[float] | None
    """The normal in world axes; None if all three directions are held."""


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


class ConditionsRecord(Record):
    """Conditions of a result, sufficient to repeat the question."""

    base: str
    """"fixed" or "floating"."""
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


class FrictionThresholdsRecord(Record):
    """Coefficients of friction at which the behaviour of a contact changes. They do not depend on the velocities."""

    _answer = {"sticking": "", "jamming": ""}

    slope: float | None
    """Sliding speed per closing speed, t, of a contact with one relative motion; None for other contacts."""
    sticking: float | None
    """Coefficient of friction from which the contact can stick; None for one relative motion, and if no friction suffices."""
    jamming: float | None
    """Coefficient of friction from which sliding can jam. For one relative motion: 1/t, from which the contact wedges. None if
    no friction suffices."""


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


class RotorSensitivity(Record):
    """Sensitivity of m̄ to the armature of a joint."""

    joint: str
    """The joint."""
    per_armature: list[float]
    """dm̄/dI = q̇² for each velocity, kg/(kg·m²) for a rotation, kg/kg for a translation."""


class PointSensitivity(Record):
    """Sensitivity of m̄ to a hardpoint."""

    point: str
    """The hardpoint."""
    per_metre: list[float] | None
    """dm̄/dx, dm̄/dy, dm̄/dz, kg/m, in the sheet's axes; None if the question has no result at a neighbouring design."""
    per_metre_error: float | None
    """Error estimate of the differences, kg/m."""


class MassChange(Record):
    """Change of mass that lowers m̄; the opposite change raises m̄."""

    link: str
    """The link."""
    lowers_by: float
    """Decrease of m̄ per kilogram of removed mass, kg, to first order."""


class PointChange(Record):
    """Displacement that lowers m̄; the opposite displacement raises m̄."""

    point: str
    """The hardpoint."""
    direction: list[float]
    """Direction of the displacement, a unit vector in the sheet's axes."""
    lowers_by: float
    """Decrease of m̄ per millimetre, kg, to first order."""


class Explanation(Record):
    """Sensitivities of an effective mass."""

    _answer = {"effective_mass": "", "links": ""}

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


class ToleranceReport(Record):
    """Variation of m̄ within tolerances."""

    _answer = {"effective_mass": "", "root_sum_square": "", "worst_case": ""}

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


class MassReport(Record):
    """Report of "percuss mass", as JSON. All keys are always present; a value is None if not applicable."""

    _answer = {"effective_mass": "kg", "effective_mass_error": "kg", "status": ""}

    schema: str
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
    drivers: list[str]
    """Joints that drive the loops."""
    assembly_modes: list[int]
    """Assembly mode of each group of loops: 1 or -1; 0 at a dead centre or a change point."""
    redundant_loops: list[list[str]]
    """Loops and couplings with redundant rows; entries that cannot be separated form one group."""
    branch_limits: list[float | None]
    """Limits of m̄ along the branches that cross at a singular pose, kg; None for a branch along which the gap does not close."""
    estimate: EstimateRecord | None
    """Classical estimate, if requested."""
    motion_ratios: list[MotionRatioRecord]
    """Motion ratios relative to the contact: of the wheel, if the mechanism has named wheel points and the ratio holds for
    every motion, and of requested points."""
    friction_thresholds: FrictionThresholdsRecord | None
    """Coefficients of friction for sticking, jamming and wedging, if requested; None without a single finite effective mass."""
    explanation: Explanation | None
    """Sensitivities of m̄, if requested."""
    tolerance: ToleranceReport | None
    """Variation of m̄ within tolerances, if given."""
    damper: DampingReport | None
    """Damper for a restitution, if requested."""
    diagnostics: list[DiagnosticRecord]
    """Findings about the file and the result."""


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


class ContactListReport(Record):
    """Effective masses at all named contacts, as JSON."""

    _answer = {"contacts": ""}

    schema: str
    """"percuss.contacts/1"."""
    percuss: str
    """Version of percuss."""
    inputs: list[Input]
    """Input files."""
    contacts: list[ListedContact]
    """The contacts: stops, springs, dampers, contact patches, others; for a study, in the order of its contacts."""
    diagnostics: list[DiagnosticRecord]
    """Findings about the file and the results; a finding about one contact begins with its name."""
