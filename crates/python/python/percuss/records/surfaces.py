"""Records of reports: MapRecord, PointMapReport, SafeSpeedReport, CheckReport. Written by tests/records.py."""

from __future__ import annotations

from .mass import ConditionsRecord
from .damping import DiagnosticRecord, Input
from .record import Record


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


class OmittedLink(Record):
    """Link omitted from the map."""

    link: str
    """The link."""
    reason: str
    """Reason."""


class MapRecord(Record):
    """Report of "percuss map", as JSON. All keys are always present; a value is None if not applicable."""

    _answer = {"links": ""}

    schema: str
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


class PointMapReport(Record):
    """Report of "percuss map --point", as JSON."""

    _answer = {"link": "", "principal": "", "directions": ""}

    schema: str
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


class SpeedRecord(Record):
    """Speed for one mass of the robot."""

    robot_mass: float | None
    """Robot mass m_R, kg: the mass of the standard, or the effective mass plus its error bound (at a singular pose the largest
    limit along the branches). None if the robot is immovable."""
    reduced_mass: float | None
    """μ = 1/(1/m_H + 1/m_R), kg; None if neither side can move."""
    speed: float
    """Largest relative speed, m/s."""


class ReachableSpeedRecord(Record):
    """Greatest closing speed within the rate limits of the joints."""

    speed: float
    """Closing speed at the pose, m/s."""
    limited_by: list[str]
    """Joints whose rate limits determine this speed."""


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


class SafeSpeedReport(Record):
    """Report of "percuss safe-speed", as JSON."""

    _answer = {"reflected.speed": "m/s", "standard.speed": "m/s", "limited_by": ""}

    schema: str
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
    along: AlongRecord | None
    """Slowest row, if there are rows of positions."""
    diagnostics: list[DiagnosticRecord]
    """Findings."""


class LinkRecord(Record):
    """A link in a CheckReport."""

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


class JointRecord(Record):
    """A joint in a CheckReport."""

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
    mimics: str | None
    """Master joint of a mimic."""


class RelationTermRecord(Record):
    """Joint of a relation in a ClosureRecord."""

    joint: str
    """Joint."""
    coefficient: float
    """Coefficient of its position."""


class ClosureRecord(Record):
    """A loop closure or coupling in a CheckReport."""

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


class CheckReport(Record):
    """Report of "percuss check", as JSON."""

    _answer = {"name": "", "total_mass": "kg", "degrees_of_freedom": "", "links": "", "diagnostics": ""}

    schema: str
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
