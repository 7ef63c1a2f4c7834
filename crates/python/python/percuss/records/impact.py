"""Records of reports: ImpactReport, ExtremesReport, ReflectedReport. Written by tests/records.py."""

from __future__ import annotations

from typing import Literal

from .mass import ConditionsRecord, MassReport
from .damping import DiagnosticRecord, Input, VaryingMassImpact
from .record import Record


class PhaseRecord(Record):
    """Phase of an impact with friction."""

    kind: str
    """"slip", "jam", "stick" or "reverse slip"."""
    stage: str
    """"compression" or "expansion"."""
    normal_impulse: float
    """Normal impulse of the phase, N·s."""


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


class RatesAfterRecord(Record):
    """Rates of a joint after an impact."""

    joint: str
    """The joint."""
    after: list[float]
    """Velocities after the impact, rad/s or m/s."""


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


class OtherBodyRecord(Record):
    """Free body on the other side."""

    mass: float
    """Mass, kg."""
    speed_change: float
    """Change of its velocity along the normal, m/s."""


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


class ImpactLawRecord(Record):
    """Compliant contact with the peak force of the impact."""

    law: str
    """Contact law."""
    stiffness: float
    """Stiffness, N/m^p."""
    exponent: float
    """Exponent p."""
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


class JointMotionRecord(Record):
    """Motion of a joint over the time of an impact."""

    joint: str
    """The joint."""
    rates: list[list[float]]
    """Velocities of the joint at each time, rad/s or m/s."""


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


class ImpactTimeRecord(Record):
    """Impact in time with a compliant contact."""

    restitution: float
    """Restitution that is reached: separation speed divided by closing speed."""
    duration: float
    """Duration of the contact, s."""
    max_penetration: float
    """Largest penetration, m."""
    peak_force: float
    """Largest force of the contact, N."""
    mass_change: float | None
    """Relative change of m̄ from the touch to the largest penetration; None if m̄ is not finite there. The change is unbounded
    near a pose at which the contact is immovable."""
    one_freedom: VaryingMassImpact | None
    """The impact of a mechanism of one degree of freedom by m̄ over the penetration alone; None for others, with gravity, or if
    the motion ends before."""
    gravity_world: list[float]
    """Gravity, world axes, m/s²."""
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


class GreatestSpeedRecord(Record):
    """Greatest closing speed by the limits of joint rates and gears."""

    speed: float
    """Speed, m/s."""
    joint: str
    """Joint that limits it."""
    limit: str
    """Limit that is reached: "rate", "gear" (impulse in the gear) or "gear-torque"."""


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


class ImpactReport(Record):
    """Report of "percuss impact", as JSON. All keys are always present; a value is None if not applicable."""

    _answer = {"impulse": "N s", "energy_loss": "J", "closing_speed": "m/s"}

    schema: str
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


class KeptRecord(Record):
    """Link or point that stays in place."""

    link: str
    """The link."""
    point: list[float] | None
    """The point in the frame of the link, m; None for the position and the orientation of the link."""
    normal: list[float] | None
    """Direction (world axes) along which the coordinate of the point is kept; None for all directions."""


class PathRecord(Record):
    """Path of a search."""

    joints: list[str]
    """Moved joints."""
    rows: int
    """Number of rows."""
    unreached: int
    """Number of rows whose pose is not reachable; a straight line joins the rows before and after them."""


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

    _answer = {"effective_mass": "", "status": ""}

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
    kept_error: float | None
    """Largest error of a coordinate of a kept point, m; None without kept points."""
    normal_world: list[float] | None
    """Normal (for a moment: axis) at the extreme, world axes, up to its sign; None if the search uses the normal of the
    contact."""
    residual: float
    """Largest component of the projected gradient times its range, relative to the value (for a bearing, of the square of the
    impulse): zero at an exact optimum."""
    agreeing: int
    """Number of starts that reached this value to six digits."""
    starts: int
    """Number of starts that were searched; on a path the number of local searches."""
    is_stopped: bool
    """True if the limit of work ended the search before all starts were searched: the value is the best one found."""


class ExtremesReport(Record):
    """Report of "percuss extremes", as JSON."""

    _answer = {"least.effective_mass": "kg", "most.effective_mass": "kg"}

    schema: str
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
    diagnostics: list[DiagnosticRecord]
    """Findings about the ranges, or about the rows of the path."""


class ReflectedReport(Record):
    """Reflected inertias without a contact, as JSON."""

    _answer = {"drivers": "", "reflected_inertia": "", "reflected_over": ""}

    schema: str
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
