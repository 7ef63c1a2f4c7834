# Types of the extension module; tests/external/python.sh compares them with the module (stubtest).
import os
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Literal, NoReturn, TypedDict, final, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._matrices import MatrixBatch
from ._request import Request
from ._sweeps import SweepRow
from .state import State

__all__ = [
    "Accelerations",
    "Assembly",
    "Contact",
    "Diagnostic",
    "Joint",
    "MatrixResponse",
    "Model",
    "Pose",
    "Response",
    "Sweep",
    "System",
    "Travel",
    "Workspace",
    "check",
    "compare",
    "compare_study",
    "damp",
    "damp_mass",
    "diagnostic_of_parts",
    "effective_mass",
    "effective_masses",
    "extremes",
    "impact",
    "impact_history",
    "joint_of_parts",
    "kinematics",
    "laws",
    "load",
    "load_suspension",
    "loads",
    "map_point_report",
    "map_report",
    "mass_report",
    "matrix_findings",
    "model_of_bytes",
    "reflected_inertias",
    "regions",
    "run_command",
    "run_study",
    "safe_speed",
    "safe_speeds",
    "set_threads",
    "ask",
    "friction_rows",
    "impact_rows",
    "starting_study",
    "study_schema",
    "suspension_template",
    "suspension_templates",
    "sweep",
    "sweep_of_parts",
    "sweep_report",
    "tools",
]

_Status = Literal["finite", "immovable", "massless"]
_Route = Literal["auto", "dense", "articulated"]
_Frame = Literal["root", "world"]
_NormalFrame = Literal["link", "world", "against"]
_Base = Literal["fixed", "floating"]
_JointKind = Literal["fixed", "revolute", "continuous", "prismatic", "planar", "spherical", "floating"]
_Severity = Literal["error", "warning", "note"]
_Vector = tuple[float, float, float]
_Positions = dict[str, Any]
_Array = NDArray[np.float64]
_Held = tuple[str, ArrayLike] | tuple[str, ArrayLike, ArrayLike | None]

class _ErrorBudget(TypedDict):
    rounding: float | None
    closing: float | None
    file: float | None

class _PoseRank(TypedDict):
    rank: int
    gap: float | None
    is_clear: bool
    is_singular: bool

class _DepartingAxis(TypedDict):
    closure: str
    joint: str | None
    slides: bool
    angle: float
    direction: _Array

class _RigidLoops(TypedDict):
    loops: list[str]
    joints: list[str]
    departing: list[_DepartingAxis]

class _DrawnGap(TypedDict):
    constraint: str
    gap: float
    size: float
    moved: tuple[str, float] | None
    is_wide: bool

class _PrincipalMass(TypedDict):
    effective_mass: float | None
    status: _Status
    error: float | None
    direction: _Array

class _RankReport(TypedDict):
    rank: int
    gap: float | None
    is_clear: bool
    redundant_rows: list[int]
    dependent_sets: list[list[int]]
    small_rows: list[int]

@final
class Diagnostic:
    """Finding about a file or about a result.

    >>> [(finding.code, finding.message) for finding in model.diagnostics]"""
    @property
    def severity(self) -> _Severity:
        """"error", "warning" or "note"."""
    @property
    def code(self) -> str:
        """Stable short name, for programs."""
    @property
    def path(self) -> str | None:
        """The file; None for a finding about a result."""
    @property
    def line(self) -> int | None:
        """Line, from 1."""
    @property
    def column(self) -> int | None:
        """Column, from 1."""
    @property
    def element(self) -> str | None:
        """The element, as an XML path."""
    @property
    def message(self) -> str:
        """Text of the finding."""
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class Joint:
    """A joint of a model.

    >>> [joint.limits for joint in arm.joints]"""
    @property
    def name(self) -> str:
        """Name of the joint."""
    @property
    def kind(self) -> _JointKind:
        """"fixed", "revolute", "continuous", "prismatic", "planar", "spherical" or "floating"."""
    @property
    def parent(self) -> str:
        """Parent link."""
    @property
    def child(self) -> str:
        """Child link."""
    @property
    def limits(self) -> tuple[float, float] | None:
        """Least and greatest position, rad or m; None without limits."""
    @property
    def mimics(self) -> str | None:
        """Name of the joint that a mimic joint follows; None for other joints."""
    @property
    def multiplier(self) -> float | None:
        """Multiplier of the position of the followed joint; None for other joints."""
    @property
    def offset(self) -> float | None:
        """Offset of a mimic joint, rad or m; None for other joints."""
    @property
    def positions(self) -> tuple[int, int]:
        """Range of the joint's entries in the position vector: first index, and last index plus one."""
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class Contact:
    """Contact between a point of a link and another link or the ground.

    link: the contact link. point: (3,) m, in its frame. normal: (3,), out of the contact link into the other side; its
    length does not matter. against: the other link; None: the ground. toward: (link, point), instead of normal: the
    normal points from the contact towards that point (m, in that link's frame). normal_frame: "link": the normal turns
    with the contact link; "world"; "against". turning: True if the line of toward may turn: a spring, a damper, a rod.
    cable: True if the line of toward is a cable, which resists lengthening; without against, the other side is its link.
    Contact.about_axis creates a contact by a moment about an axis.

        >>> contact = percuss.Contact("coupler", point=[0.35, 0.1, 0.0], normal=[0.0, 1.0, 0.0])"""
    def __new__(
        cls,
        link: str,
        point: ArrayLike,
        normal: ArrayLike | None = None,
        *,
        against: str | None = None,
        toward: tuple[str, ArrayLike] | None = None,
        normal_frame: _NormalFrame = "link",
        turning: bool = False,
        cable: bool = False,
    ) -> Contact: ...
    @property
    def link(self) -> str:
        """The contact link."""
    @property
    def against(self) -> str | None:
        """The other link; None: the ground."""
    @property
    def point(self) -> _Vector:
        """The contact point in the contact link's frame, m."""
    @property
    def normal(self) -> _Vector | None:
        """The normal as given; None if toward is given, and for a moment."""
    @property
    def axis(self) -> _Vector | None:
        """The axis of a moment as given; None for other contacts."""
    @property
    def toward(self) -> tuple[str, _Vector] | None:
        """The link and the point (m, its frame) that the normal points to; None if normal is given, and for a moment."""
    @property
    def normal_frame(self) -> _NormalFrame:
        """Frame of the normal or the axis: "link", "world" or "against"."""
    @property
    def turning(self) -> bool:
        """True if the line of toward may turn: a spring, a damper, a rod."""
    @property
    def cable(self) -> bool:
        """True if the line of toward is a cable, which resists lengthening."""
    @staticmethod
    def about_axis(
        link: str, axis: ArrayLike, *, against: str | None = None, axis_frame: _NormalFrame = "link"
    ) -> Contact:
        """Contact by a moment about an axis (a couple), such as a rotational stop: effective masses are inertias in kg·m²; the units of
        speeds, impulses and forces are rad/s, N·m·s and N·m.

        axis: (3,), its length does not matter. axis_frame: "link", "world" or "against"."""
    def __eq__(self, other: object, /) -> bool: ...
    def __ne__(self, other: object, /) -> bool: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class Model:
    """Mechanism read from a file. Immutable, so that threads can share it.

    >>> percuss.load("models/four_bar.urdf").position_names"""
    @property
    def name(self) -> str:
        """The mechanism's name."""
    @property
    def links(self) -> list[str]:
        """Names of the links, in the order of the file."""
    @property
    def joints(self) -> list[Joint]:
        """The joints, in the order of the file, which is also the order of their positions."""
    @property
    def closures(self) -> list[str]:
        """Names of the loop closures and couplings."""
    @property
    def bushes(self) -> list[str]:
        """Names of the bushes."""
    @property
    def contacts(self) -> list[str]:
        """Names of the contacts."""
    def contact(self, name: str) -> Contact:
        """The contact of a name (Model.contacts), or of a text as for impact(also=…), such as "JOINT:upper". Its point, normal and links are
        those of the model; a gap is not part of it."""
    @property
    def position_count(self) -> int:
        """Number of positions of a configuration: the positions of all joints together."""
    @property
    def position_names(self) -> list[str]:
        """Names of the positions, in order: the joint's name, or JOINT[0], JOINT[1], … for a joint with several positions."""
    @property
    def velocity_names(self) -> list[str]:
        """Name of each velocity, in the order of Sweep.gradient: joints in the order of the file."""
    @property
    def total_mass(self) -> float:
        """Total mass, kg."""
    @property
    def poses(self) -> dict[str, dict[str, list[float]]]:
        """Poses that the file names, keyframes of MJCF: by name, the position of every joint that moves on its own, rad or m."""
    @property
    def diagnostics(self) -> list[Diagnostic]:
        """Warnings and notes, in the order of the file."""
    @property
    def hardpoints(self) -> list[str]:
        """Names of the hardpoints that `changed` can move; empty unless the model comes from a sheet."""
    def changed(
        self,
        *,
        link_mass: Mapping[str, float] = ...,
        link_com: Mapping[str, Sequence[float]] = ...,
        link_inertia: Mapping[str, Sequence[float]] = ...,
        move: Mapping[str, Sequence[float]] = ...,
        shape_density: float | None = None,
        total_mass: float | None = None,
    ) -> Model:
        """Copy of the model with changes, added to earlier changes. shape_density: kg/m³ of the shapes of the links, from which masses and
        inertias are computed first, with a warning. total_mass: kg of all links, to which all masses are scaled last. link_mass: link to mass in kg; the moments about the
        centre of mass scale in proportion. link_com: link to centre of mass, (3,) m in the link's frame; the moments
        about the centre of mass are unchanged. link_inertia: link to moments of inertia about the centre of mass, (3,) kg·m²,
        about the axes of the link's frame; the products of inertia are unchanged. move: hardpoint of a sheet to displacement,
        (3,) m, sheet's axes."""
    def with_bush(
        self,
        name: str,
        link: str,
        *,
        stiffness: Sequence[float],
        against: str = "world",
        at: Sequence[float] = ...,
        axis: Sequence[float] = ...,
        x_axis: Sequence[float] | None = None,
        damping: Sequence[float] = ...,
        loss_factor: float = 0.0,
        dynamic_factor: float = 1.0,
        preload: Sequence[float] = ...,
        replaces: Sequence[str] = ...,
        rigid: Sequence[bool] | None = None,
    ) -> Model:
        """Copy of the model with a bush: an elastic connection of two links, with one row for each direction of the bush (BushDescription in Rust).

        against: link on the other side, "world" for the ground. at: (3,) m, axis: (3,) direction z of the bush, x_axis: (3,) its x, by default any
        direction across the axis; all in the axes of `link`. stiffness: (6,) of small rotations about x and y (conical) and z (torsional), N·m/rad, then
        of translations along x and y (radial) and z (axial), N/m; math.inf for a row that allows no motion. damping: (6,) N·m·s/rad and N·s/m.
        loss_factor, dynamic_factor: of all rows. preload: (6,) N·m and N on `link` at all poses. replaces: joints and closures in whose place the bush is.
        rigid: (6,) rows that the rigid mechanism holds; by default the translations if the bush replaces a joint. `mass`, `response` and
        impact(in_time=True, compliance=True) have its effect."""
    def to_urdf(self) -> str:
        """The mechanism as URDF."""
    def to_mjcf(self) -> str:
        """The mechanism as MJCF, for MuJoCo 3.2.3 and later. Loops become equality constraints."""
    def to_sdf(self) -> str:
        """The mechanism as SDFormat 1.7, or 1.11 if a joint follows another. Loops become joints."""
    def system(
        self,
        *,
        base: _Base = "fixed",
        lock: str | Sequence[str] | None = ...,
        armature: dict[str, Any] | None = None,
        hold: Sequence[_Held] = ...,
    ) -> System:
        """The mechanism under conditions.

        base: "fixed" or "floating". lock: names of joints that are locked, one name, or "all". armature: joint to inertia (kg·m² or kg), one value,
        or one for each velocity of the joint. hold: points that are held, (link, point) or (link, point, normal): point
        (3,) m in the link's frame, normal (3,) in the root link's axes; without a normal, the point is held in all
        directions."""
    def assemble(self, guess: _Positions | None = None) -> Assembly:
        """Assembles the loops with every joint free and a fixed base: system().assemble(guess)."""
    def pose(
        self,
        q: _Positions | ArrayLike | State | None = None,
        *,
        guess: _Positions | None = None,
        base_pose: ArrayLike | None = None,
        other_assembly: bool = False,
    ) -> Pose:
        """The pose at a configuration with every joint free and a fixed base: system().pose(…)."""
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class System:
    """Mechanism under conditions. Immutable, so that threads can share it.

    >>> arm.system(base="floating", lock=["elbow"]).coordinates"""
    @property
    def model(self) -> Model:
        """The model."""
    @property
    def _conditions(self) -> dict[str, Any]:
        """Conditions as given: the arguments of Model.system."""
    @property
    def coordinates(self) -> int:
        """n: independent velocities of the tree, without locked joints and mimics; a floating base counts 6."""
    @property
    def coordinate_joints(self) -> list[tuple[str | None, int]]:
        """Joint (None for the base) and velocity number of each coordinate, in the order of M, A, j."""
    def assemble(self, guess: _Positions | None = None) -> Assembly:
        """Assembles the loops, from all joints at 0 or from guesses (joint to position). Raises AssemblyError."""
    def pose(
        self,
        q: _Positions | ArrayLike | State | None = None,
        *,
        guess: _Positions | None = None,
        base_pose: ArrayLike | None = None,
        other_assembly: bool = False,
    ) -> Pose:
        """The pose at a configuration, with closed loops.

        q: dict of driving joints to their positions (rad, m; quaternions w, x, y, z), others at 0; or the positions of
        all joints, (p,): driving joints keep the given positions, dependent joints take the nearest solution; a pandas
        Series is matched by name (Model.position_names). guess: initial positions in the search for dependent joints.
        base_pose: pose of the root link in the world, x, y, z (m), w, x, y, z; contacts with normal_frame="world" and
        travels refer to that world. other_assembly: accepts a pose on another assembly mode, beyond the reach of the
        branch of the first closed pose. Raises AssemblyError."""
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class Assembly:
    """System with assembled loops. Immutable, so that threads can share it.

    >>> model.assemble().drivers"""
    @property
    def model(self) -> Model:
        """The model."""
    @property
    def _conditions(self) -> dict[str, Any]:
        """Conditions of the system, and the guess."""
    @property
    def degrees_of_freedom(self) -> int:
        """Degrees of freedom at a generic pose; a floating base counts 6."""
    @property
    def redundant_constraints(self) -> int:
        """Rows of A that are redundant at a generic pose."""
    @property
    def redundant_loops(self) -> list[list[str]]:
        """Groups of loops and couplings with redundant rows; a group cannot be separated further."""
    @property
    def drivers(self) -> list[str]:
        """Joints that drive the loops."""
    def rigid_loops(self) -> list[_RigidLoops]:
        """Loops and couplings that leave their joints no motion at a generic pose, without regard to locks and holds, as
        dicts: "loops" and "joints" (names), and "departing": for each loop whose other axes fit a planar motion, the
        axis that does not fit, with "closure", "joint" (None: the loop's own axis), "slides" (true for the axis of a
        slide, which should be normal to the direction), "angle" (rad) and "direction", shared by the other hinges
        ((3,), root link's axes)."""
    def drawn_gaps(self) -> list[_DrawnGap]:
        """Loops and couplings that are open as drawn (all joints at 0, or at the guess), as dicts: "constraint", "gap"
        (m), "size" of its group (m), "moved" (the joint with the largest motion in closing, and this motion, rad or m;
        or None), "is_wide": the gap exceeds a hundredth of the size, so it is not rounding."""
    def pose(
        self,
        q: _Positions | ArrayLike | State | None = None,
        *,
        guess: _Positions | None = None,
        base_pose: ArrayLike | None = None,
        other_assembly: bool = False,
    ) -> Pose:
        """The pose at a configuration of this assembly; parameters as for System.pose."""
    def workspace(self, contact: Contact | str, *, base_pose: ArrayLike | None = None) -> Workspace:
        """Workspace of a contact, for one configuration after another. base_pose: pose of the root link in the world, for
        normals in the world; as for pose."""
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class Workspace:
    """Workspace of a contact, for one configuration after another. Concurrent use by two threads raises an error.

    >>> workspace = arm.assemble().workspace(tool)
    >>> workspace.effective_mass(q[0])"""
    def effective_mass(self, q: ArrayLike) -> float | None:
        """m̄ in kg at the positions of all joints, (p,), with closed loops; None unless finite, with the outcome in
        status. A pandas Series is matched by name. findings holds the findings about the last result; Pose.respond
        returns more quantities."""
    @property
    def status(self) -> _Status | None:
        """Outcome of the last configuration: "finite", "immovable" or "massless"; None before the first configuration, and
        after an error."""
    @property
    def findings(self) -> list[Diagnostic] | None:
        """Findings about the last configuration and its result, as in reports of the command line. Reading this property
        computes them, by Pose.respond at that configuration. None before the first configuration, and after an error."""
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class Pose:
    """Mechanism at one configuration with closed loops. Immutable, so that threads can share it.

    >>> model.pose({"crank_hinge": 0.4}).respond(contact).effective_mass"""
    @property
    def model(self) -> Model:
        """The model."""
    @property
    def _conditions(self) -> dict[str, Any]:
        """Conditions of the system, and the pose."""
    @property
    def positions(self) -> _Array:
        """Positions of all joints, concatenated in the order of the file; (p,)."""
    @property
    def joints(self) -> dict[str, _Array]:
        """Position of each movable joint, by joint name; (1,), or one entry per position of the joint."""
    @property
    def degrees_of_freedom(self) -> int:
        """Degrees of freedom at this pose; a floating base counts 6."""
    @property
    def is_singular(self) -> bool:
        """True if branches cross at this pose."""
    @property
    def closure_residual(self) -> float | None:
        """Largest closure error of all loops, m; None without loops."""
    @property
    def findings(self) -> list[Diagnostic]:
        """Findings about the pose, as in reports of the command line: joints outside their limits, loops open as drawn,
        another assembly mode, an unclear rank."""
    def link_frame(self, link: str, *, frame: _Frame | None = None) -> _Array:
        """The frame of a link in the root link's frame (frame="root") or in the world (frame="world"), homogeneous; (4,
        4). frame may be omitted if the pose has no base_pose: both frames are then the same."""
    def mass_matrix(self) -> _Array:
        """M over the coordinates, kg, kg·m, kg·m²; (n, n), armatures included."""
    def constraint_matrix(self) -> _Array:
        """A: Jacobian of closures, couplings and held points over the coordinates; (m, n)."""
    def contact_row(self, contact: Contact | str) -> _Array:
        """j: closing speed of the gap at unit rates, m, 1; (n,)."""
    def point_jacobian(
        self, link: str, point: ArrayLike, *, frame: _Frame | None = None
    ) -> _Array:
        """Jacobian of a point (m, link's frame) over the coordinates, m, 1; (3, n). Axes of the root link or of the world, as for
        link_frame."""
    def jacobian(self, link: str, point: ArrayLike, *, frame: _Frame | None = None) -> _Array:
        """Jacobian of a link at a point (m, link's frame) over the coordinates, angular velocity first; (6, n). Axes of the root link or of the
        world, as for link_frame."""
    def velocity_matrix(self) -> _Array:
        """T with q̇ = T u: velocities of all joints (Model.velocity_names) by the rates u of the coordinates of M, A, j and the Jacobians; mimics
        follow, locked joints are at rest; (velocities, n). gradient @ T has the columns of M."""
    def inverse_operational_inertia(self, contact: Contact | str, *, frame: _Frame | None = None) -> _Array:
        """Φ = J M⁻¹ Jᵀ of the contact link at the contact point, constraints included; (6, 6), angular part first: the inverse of the
        operational-space inertia Λ. The lower right block is that of forces, 1/kg: 1/m̄ = n̂ᵀ Φ[3:, 3:] n̂ for a contact with the ground. Axes
        of the root link or of the world, as for link_frame."""
    def contact_mobility(self, contact: Contact | str, *, frame: _Frame | None = None) -> _Array:
        """Φ of both sides of a contact at its point; (12, 12), 1/kg and so on. Rows: six for the contact link (angular, then linear), six for
        the other side. 1/m̄ = wᵀΦw with w = (0, n̂, 0, −n̂). Axes as for inverse_operational_inertia, the upper left block."""
    def contact_map(
        self, link: str, points: ArrayLike, normals: ArrayLike, *, against: str | None = None
    ) -> tuple[_Array, _Array, NDArray[np.uint8]]:
        """m̄ of many contacts of a link with the ground or with another link: points (N, 3) m and normals (N, 3), out of
        the link, of any nonzero length, in the link's frame. Costs some nanoseconds per contact, by Φ about the middle
        of the points. Returns effective_mass (N,) kg, NaN unless finite; error (N,) kg, NaN if unknown; status (N,)
        uint8: 0 finite, 1 immovable, 2 massless, 3 no answer."""
    def principal_masses(
        self, link: str, point: ArrayLike, *, against: str | None = None
    ) -> list[_PrincipalMass] | None:
        """The three directions along which m̄ is stationary among all directions at a point (3,) m of a link, lightest
        first, as dicts: "effective_mass" (kg; None unless finite), "status", "error" (kg) and "direction" (a unit
        vector, link's frame, (3,)). None if a mass has no answer."""
    def effective_mass_gradient(self, contact: Contact | str) -> dict[str, _Array] | None:
        """Gradient of m̄ at a contact: for each movable joint, by name, the change of m̄ per unit velocity (kg/rad, kg/m);
        (1,), or one entry per velocity of the joint. dm̄/dt is the sum of its products with the velocities of an admissible
        motion; in a mechanism with loops a single entry is not the derivative along one joint. base_gradient has the part of
        the root link. None unless m̄ is finite with an error of at most 1e-6 m̄."""
    def effective_mass_rate(
        self,
        contact: Contact | str,
        velocities: Mapping[str, ArrayLike] | ArrayLike | State,
        *,
        base_twist: ArrayLike | None = None,
        frame: _Frame | None = None,
    ) -> float | None:
        """dm̄/dt at a contact, kg/s, at joint velocities: a dict of joints to rates (rad/s, m/s), with joints without an entry at rest; an array
        (n,) in the order of Model.velocity_names; or a State, which also has the twist of the root link. Mimics follow. For loops, all moving
        joints must be given: velocities that open loops are refused. Velocities of a Response are admissible. base_twist: (6,), angular
        (rad/s), then linear (m/s), of the root link at its origin, in axes of the root link or of the world as for link_frame. None unless m̄
        is finite with an error of at most 1e-6 m̄."""
    def base_gradient(self, contact: Contact | str, *, frame: _Frame | None = None) -> _Array | None:
        """Gradient of m̄ by the twist of the root link with all joints at rest: angular (kg/rad), then linear (kg/m); (6,). It is zero unless
        the normal is fixed in the world. Axes of the root link or of the world, as for link_frame. None as for effective_mass_gradient."""
    def accelerations(
        self,
        velocities: _Positions | None = None,
        *,
        base: ArrayLike | None = None,
        gravity: ArrayLike | None = None,
        forces: Sequence[tuple[str, ArrayLike, ArrayLike]] = ...,
        frame: _Frame | None = None,
    ) -> Accelerations:
        """Accelerations of a tree at joint velocities (a dict; other joints are at rest), base (6,): the twist of a
        floating root (angular, linear), gravity (3,) m/s², zero by default, and forces: a list of (link, point (3,) m
        in the link's frame, force (3,) N). base, gravity and forces have the axes of the root link or of the world, as
        for link_frame. Raises InputError with loops, mimics or held points."""
    def advanced_along(self, response: Response, distance: float) -> Pose | None:
        """The pose after a motion along v* of a response at this pose until the gap has closed by a distance (m; negative:
        opened), with the loops closed again: exact to second order. None if the loops do not close there, or if nothing
        moves."""
    def outside_limits(self) -> dict[str, tuple[float, tuple[float, float]]]:
        """Joints outside their limits: joint to (position, (lower, upper)), rad or m."""
    def rank(self) -> _PoseRank:
        """Rank report of A at this pose: "rank"; "gap", the least gap between counted singular values and those taken as
        zero (None without rows); "is_clear"; "is_singular"."""
    def respond(self, contact: Contact | str, *, route: _Route = "auto") -> Response:
        """m̄ at a contact, and the quantities derived from it. route: "auto", "dense" (O(n³)) or "articulated" (O(n))."""
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class Travel:
    """Travel of a point along a direction, measured from the point's position at a pose. Immutable, so that threads can
    share it.

        >>> height = percuss.suspension.Travel(model.pose(), "coupler", [0.35, 0.1, 0.0], [0.0, 1.0, 0.0])
        >>> height.pose(model.pose(), 0.01).joints["crank_hinge"]"""
    def __new__(cls, pose: Pose, link: str, point: ArrayLike, direction: ArrayLike) -> Travel: ...
    @property
    def link(self) -> str:
        """The link of the point."""
    @property
    def point(self) -> _Array:
        """The point, m, link's frame; (3,)."""
    @property
    def direction(self) -> _Array:
        """Unit vector, world axes; (3,)."""
    def displacement(self, pose: Pose) -> float:
        """Displacement of the point at a pose of the same model, m."""
    def rate(self, pose: Pose, joint: str) -> float | None:
        """ds/dq at a pose: displacement per motion of a driving joint, m/rad or m/m. The loops stay closed and other
        drivers are at rest. None at a change point, at a dead centre of the joint, and for a joint that cannot drive."""
    def driver(self, pose: Pose, *, set: Sequence[str] = ...) -> str:
        """The joint that turns furthest with the point at a pose, among the joints that can drive the point. Joints in set
        are excluded. Raises NoAnswerError if no joint moves the point."""
    def pose(
        self, start: Pose, displacement: float, *, driver: str | None = None, q: _Positions | None = None
    ) -> Pose:
        """The pose with a given displacement of the point (m), followed from the pose start along its branch. driver: the
        joint that moves; None: the result of `driver`. q: positions of other driving joints, as for Model.pose; None:
        all at zero. Raises NoAnswerError beyond the range in which the displacement is monotonic; the message gives the
        nearest reachable value."""
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class Accelerations:
    """Accelerations of a moving mechanism.

    >>> arm.pose().accelerations(gravity=[0, 0, -9.81]).joints["elbow"]"""
    @property
    def joints(self) -> dict[str, _Array]:
        """Rates of the velocities of each movable joint, by joint name: rad/s², m/s²; (1,), or one entry per velocity of
        the joint."""
    def point(self, link: str, point: ArrayLike, *, frame: _Frame | None = None) -> _Array:
        """Acceleration of a point (m, link's frame) of a link, m/s²; (3,). Axes of the root link or of the world, as for
        Pose.link_frame."""

@final
class Response:
    """m̄ at a contact of a pose, and the quantities derived from it.

    >>> response = model.pose().respond(contact)
    >>> response.effective_mass, response.error, response.contributions"""
    @property
    def effective_mass(self) -> float | None:
        """m̄ in the unit given by unit; None unless finite."""
    @property
    def unit(self) -> str:
        """Unit of the effective mass and its errors: "kg", or "kg·m²" for a moment about an axis."""
    @property
    def status(self) -> _Status:
        """"finite"; "immovable": no admissible motion closes the gap; "massless": a motion without energy closes it."""
    @property
    def error(self) -> float | None:
        """Error of m̄, kg: the sum of the known parts of the error budget; None if the rounding or the closing part is
        unknown."""
    @property
    def error_budget(self) -> _ErrorBudget:
        """Parts of the error budget, kg: "rounding", "closing", "file"; None for a part without a measure."""
    @property
    def route(self) -> Literal["dense", "articulated"]:
        """"dense" or "articulated"."""
    @property
    def degrees_of_freedom(self) -> int:
        """dim ker A at the pose, a floating base's 6 included."""
    @property
    def singular_pose(self) -> bool:
        """True if branches cross at the pose: m̄ is then a lower bound that no branch attains."""
    @property
    def remarks(self) -> list[str]:
        """Remarks about the result."""
    @property
    def findings(self) -> list[Diagnostic]:
        """Findings about the pose and the result, as in reports of the command line. At a singular pose, its branches are
        followed."""
    @property
    def joint_velocities(self) -> dict[str, _Array]:
        """v*: velocities of each joint at unit closing speed, by joint name; (d,) rad or m, per m (per rad for a moment)."""
    @property
    def base_velocity(self) -> _Array:
        """v* of a floating root link: 3 angular (rad/s), 3 linear (m/s), per unit closing speed, root link's axes; (6,)."""
    @property
    def contributions(self) -> dict[str, float] | None:
        """Share of each link in the kinetic energy at unit closing speed, by link name; None unless finite."""
    @property
    def rotor_contributions(self) -> dict[str, float] | None:
        """Share of each rotor (armature) in the kinetic energy at unit closing speed, by joint name; None unless finite."""
    @property
    def point_world(self) -> _Array:
        """The contact point in the world, m; (3,)."""
    @property
    def normal_world(self) -> _Array:
        """The normal in the world, out of the contact link; (3,)."""
    def branch_limits(self) -> list[float | None]:
        """Limits of m̄ along the branches that cross at a singular pose, kg; None for a branch along which the gap does
        not close."""
    def point_velocity(
        self, link: str, point: ArrayLike, *, frame: _Frame | None = None
    ) -> _Array | None:
        """Velocity of a point of a link at unit closing speed, relative to the contact's other side; (3,). Its length is
        the motion ratio. Axes of the root link or of the world, as for Pose.link_frame. None if the response has no
        motion, or if a massless motion leaves the velocity undetermined."""
    def against_mass(self, mass: float) -> Response:
        """The response with a free body of this mass (kg) as the other side."""
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class MatrixResponse:
    """m̄ from matrices, with its error, rank report and remarks.

    >>> percuss.effective_mass(np.eye(2), [1.0, 0.0], [[0.0, 1.0]]).velocity"""
    @property
    def effective_mass(self) -> float | None:
        """m̄, in the unit of M (kg); None unless finite."""
    @property
    def status(self) -> _Status:
        """"finite"; "immovable": no motion with A v = 0 closes the gap; "massless": a motion without energy closes it."""
    @property
    def error(self) -> float | None:
        """Bound on the error of m̄ from the accuracy of the entries and from rounding, kg; None if unknown, or if the rank
        is unclear."""
    @property
    def velocity(self) -> _Array:
        """v*: velocities at unit closing speed, in the units of the coordinates; zero if immovable; (n,)."""
    @property
    def degrees_of_freedom(self) -> int:
        """Degrees of freedom: coordinates minus rank of A."""
    @property
    def rank(self) -> _RankReport:
        """Rank report of A, with row numbers from 0: "rank"; "gap" (least gap between counted singular values and those
        taken as zero; None without rows); "is_clear"; "redundant_rows"; "dependent_sets"; "small_rows" (counted rows
        below the rounding of other rows)."""
    @property
    def remarks(self) -> list[str]:
        """Remarks about the result."""

@final
class Sweep:
    """m̄ of a contact at many configurations.

    >>> swept = percuss.sweep(arm, tool, q)
    >>> swept.effective_mass, swept.error, swept.findings
    >>> swept[swept.status == percuss.Status.FINITE].to_dataframe()"""
    @property
    def effective_mass(self) -> _Array:
        """m̄, kg; NaN unless finite; (N,)."""
    @property
    def error(self) -> _Array:
        """Error of m̄, kg; NaN unless m̄ is finite, and with the remark UNKNOWN_ERROR; (N,)."""
    @property
    def status(self) -> NDArray[np.uint8]:
        """0 finite, 1 immovable, 2 massless, 3 no answer: the pose does not exist, or no route solves it; 4 massless to
        rounding only: error is then the largest possible m̄ of the contact; uint8, (N,)."""
    @property
    def remarks(self) -> NDArray[np.uint32]:
        """Findings about each row: RemarkFlags added together; uint32, (N,)."""
    @property
    def findings(self) -> list[Diagnostic]:
        """Findings about the rows: one per kind of remark, with the first row and the number of further rows. Pose.respond
        at a row has the numbers."""
    @property
    def gradient(self) -> _Array:
        """Gradient of m̄ by the velocities of all joints (Model.velocity_names), kg/rad or kg/m; NaN unless m̄ is finite with an error of at most 1e-6 m̄; (N, n). With loops,
        only sums over admissible motions have a meaning. Raises NotComputedError unless the sweep had gradient=True."""
    @property
    def inverse_operational_inertia(self) -> _Array:
        """Φ = J M_c⁻¹ Jᵀ of the contact link at the contact point, in root axes, angular part first: the inverse of the operational
        inertia Λ; (N, 6, 6). The block [:, 3:, 3:] is that of forces, 1/kg. Raises NotComputedError unless the sweep had
        inverse_operational_inertia=True."""
    @property
    def base_gradient(self) -> _Array:
        """Gradient of m̄ by the twist of the root link while the joints are at rest, angular (kg/rad), then linear (kg/m), in root axes; (N, 6):
        dm̄/dt = gradient · velocities + base_gradient · base_twist. It is zero unless the normal is fixed in the world. Raises
        NotComputedError unless the sweep had gradient=True."""
    @property
    def index(self) -> Any:
        """Labels of the rows of a table of positions; None for arrays."""
    def _parts(self) -> tuple[dict[str, Any], dict[str, Any]]:
        """Parts of the sweep by name: arrays with a row for each configuration, then what all rows share."""
    @overload
    def __getitem__(self, rows: int | np.integer[Any], /) -> SweepRow: ...
    @overload
    def __getitem__(self, rows: slice | Sequence[int] | NDArray[Any], /) -> Sweep: ...
    def to_dataframe(self) -> Any:
        """Table (pandas) with a row for each configuration, under the labels of q: effective_mass, error, status (text), a column for each kind
        of finding that occurs (RemarkFlags), and the entries of the gradient as gradient[JOINT]."""
    def to_svg(self) -> str:
        """The picture as SVG: m̄ over the row number."""
    def _repr_html_(self) -> str:
        """Description and plot of the sweep, for notebooks."""
    def __len__(self) -> int: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

def load(
    path: str | os.PathLike[str], *, accept: Sequence[str] = ..., max_size: int = ...
) -> Model:
    """Reads a URDF file, closed loops and couplings included.

    accept: findings that are accepted: "indefinite-inertia", "implausible-inertia", "second-inertial". max_size: size limit in bytes;
    larger files are refused. Warnings go through `warnings` (ModelWarning); the model's diagnostics hold warnings and
    notes. Raises LoadError, with every error of the file.

        >>> model = percuss.load("models/four_bar.urdf")"""
def loads(text: str, *, name: str = "<text>", accept: Sequence[str] = ...) -> Model:
    """Reads URDF from text. name replaces the file name in messages. Other parameters as for load.

    >>> percuss.loads('<robot name="r"><link name="a"/></robot>').links"""
def sweep_of_parts(parts: dict[str, Any]) -> Sweep:
    """Rebuilds a sweep from its parts: of another process, or of some rows."""
def impact_rows(
    model: Model | System | Assembly,
    contacts: Sequence[Contact | str],
    positions: _Array,
    velocities: _Array,
    base_pose: _Array | None,
    base_twist: _Array | None,
    restitution: Sequence[float],
    law: str,
    wants: tuple[bool, bool],
    threads: int | None,
    progress: Callable[[int, int], object] | None,
) -> dict[str, Any]:
    """Arrays of a call by name: results of N states, k contacts, n velocities, c coordinates and the joints.

    velocities: (N, n). base_twist: (N, 6) in root axes. restitution: one for each contact. law: "newton", "poisson", "energetic", "sticking"."""
def friction_rows(
    model: Model | System | Assembly,
    contact: Contact | str,
    positions: ArrayLike,
    base_pose: _Array | None,
    threads: int | None,
    progress: Callable[[int, int], object] | None,
) -> _Array:
    """Thresholds of friction of a contact at N positions, (N, 3): sliding per closing speed, sticking, jamming; NaN without a value."""
def set_threads(threads: int | None = None) -> None:
    """Number of threads of every call from now on, 1 to 1024; None: one per processor (or RAYON_NUM_THREADS). Results do not depend on it.

    >>> percuss.set_threads(4)"""
def diagnostic_of_parts(
    severity: _Severity,
    code: str,
    place: tuple[str | None, int | None, int | None, str | None],
    message: str,
) -> Diagnostic:
    """Rebuilds a pickled finding."""
def joint_of_parts(
    names: tuple[str, str, str],
    kind: _JointKind,
    limits: tuple[float, float] | None,
    mimic: tuple[str, float, float] | None,
    positions: tuple[int, int],
) -> Joint:
    """Rebuilds a pickled joint."""
def model_of_bytes(bytes: bytes, name: str, accept: Sequence[str]) -> Model:
    """Rebuilds a pickled model in another process."""
def effective_mass(
    M: Any,
    j: Any,
    A: Any = None,
    *,
    lengths: ArrayLike | None = None,
    rank_floor: float | None = None,
    accuracy: float | None = None,
    row_noise: float | None = None,
) -> MatrixResponse:
    """Effective mass along a contact row of a system given by its matrices, in the unit of M (kg).

    m̄ = min { vᵀMv : Av = 0, jv = 1 }; 1/(j M⁻¹ jᵀ) if M is regular and A is None. M: (n, n), symmetric, positive
    semi-definite, kg, kg·m, kg·m². j: (n,), closing speed per rate, m, 1. A: (m, n) or None, Jacobian of the
    constraints, each row in any unit. Arrays may be dense with any strides or
    sparse (made dense: the cost is O(n³ + m n²), up to 1000 coordinates). Labels of tables (pandas) name the
    coordinates: j, A and lengths are put in the order of M.

    lengths: (n,), scale of each coordinate for rank decisions and for the test of whether the gap closes at all:
    displacement per unit rate, in one unit for all coordinates: 1 for a slide in metres, a typical length for an angle.
    Default: 1 for all. A finite m̄ does not depend on lengths, except for rounding. rank_floor: singular values of A
    below this fraction of the largest count as zero, with each row scaled to 1; default 1e-10, or 10 times the accuracy
    if larger. accuracy: relative error of the entries, 0 to 1e-3; default by the type of each array: 2.2e-16 (float64),
    6e-8 (float32), 4.9e-4 (float16), exact (integers). row_noise: rows of A with no entry above this value, in A's
    unit, count as zero; default: 1e-14 of the largest entry of the rows that bind the same coordinates.

        >>> percuss.effective_mass([[2.0, 0.3], [0.3, 1.0]], [1.0, -0.5]).effective_mass"""
def effective_masses(
    M: ArrayLike,
    j: ArrayLike,
    A: ArrayLike | None = None,
    *,
    lengths: ArrayLike | None = None,
    rank_floor: float | None = None,
    accuracy: float | None = None,
    row_noise: float | None = None,
) -> MatrixBatch:
    """m̄, error and status for a batch: M (b, n, n) or (n, n), j (b, n) or (n,), A (b, m, n), (m, n) or None. An array without a
    batch axis is shared by the whole batch: one M with many j. Returns a MatrixBatch, which unpacks into effective_mass (b,) kg, NaN
    unless finite; error (b,) kg, NaN if unknown; status (b,) uint8: 0 finite, 1 immovable, 2 massless. Its findings are
    the warnings about all problems. Other parameters as for effective_mass. An error message names the number of the
    failing problem.

        >>> masses, errors, status = percuss.effective_masses(np.stack([np.eye(2), 2 * np.eye(2)]), [1.0, 0.0])"""
def matrix_findings(remarks: NDArray[np.uint32], small_rows: Sequence[int]) -> list[Diagnostic]:
    """Findings about a batch, from the remarks of each problem and the numbers of the problems with small rows."""
def sweep(
    model: Model | System | Assembly,
    contact: Contact | str,
    q: ArrayLike | State,
    *,
    joints: Sequence[str] | None = None,
    base_pose: ArrayLike | None = None,
    other_assembly: bool = False,
    points: ArrayLike | None = None,
    normals: ArrayLike | None = None,
    gradient: bool = False,
    inverse_operational_inertia: bool = False,
    ignore: Sequence[str] = ...,
    nan: Literal["refuse", "no answer"] = "refuse",
    threads: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Sweep:
    """m̄ of a contact at the rows of q, on all processors. Results do not depend on the number of processors.

    model: a Model, System or Assembly. q: (N, p) float64, rad, m: the positions of all joints in the order of the file,
    with closed loops (positions of a Pose satisfy this); mimics are not read. Any strides; an F-ordered array is the fastest. Other numeric
    types are converted. The sweep works on a copy of the values at the call.

    joints: names of the driving joints in the columns of q, with one position each: (N, len(joints)). Other joints are
    at 0 or follow; loops are closed, and each row continues from the row before, on one branch. Unreachable rows have
    no answer.

    A DataFrame is matched by its column names, which are those of joints or of Model.position_names, in any order.

    points, normals: (N, 3), a contact point (m, in the contact link's frame) and a normal (in the frame of the contact's
    normal, of any length) for each row, instead of those of the contact. A DataFrame has the columns x, y, z.

    A State in place of q gives positions and base_pose. ignore: columns of a table that are no positions. nan: "refuse" raises InputError for
    a position that is not a finite number; with "no answer" its row has the status NO_ANSWER and the remark NOT_FINITE, if m̄ depends on
    that position.

    base_pose: pose of the root link in the world, x, y, z (m), w, x, y, z, for normals in the world: (7,), or (N, 7), one
    for each row; default: the world's origin. other_assembly: also solves rows on another assembly mode, beyond the reach of the branch of the
    first closed pose; otherwise these rows have no answer. Ctrl-C stops the sweep.

    gradient, inverse_operational_inertia: True also computes Sweep.gradient and Sweep.base_gradient, Sweep.inverse_operational_inertia. threads: number of
    threads of this call, 1 to 1024; default: those of set_threads. progress: function of the numbers of finished rows and of all
    rows, called about 20 times a second; its exceptions stop the sweep.

        >>> percuss.sweep(arm, tool, q).effective_mass
        >>> percuss.sweep(model, contact, [[0.1], [0.2]], joints=["crank_hinge"]).effective_mass"""
def load_suspension(
    path: str | os.PathLike[str],
    *,
    side: str | None = None,
    unit: str | None = None,
    axes: str | None = None,
    template: str | None = None,
    wheel: tuple[float, Sequence[float], float | None] | None = None,
    rack_mass: float | None = None,
    move: Mapping[str, Sequence[float]] | None = None,
    allow_outside: bool = False,
    worksheet: str | None = None,
    names: str | None = None,
) -> Model:
    """Reads a sheet (TOML), a table of hardpoints (CSV, XLSX) or a suspension file of Chrono::Vehicle (JSON).

    side: "left", "right" or "both". unit: "m", "cm", "mm", "in"; axes: "iso", "adams", "sae", "rfactor", or such as "-z x y" (the axes that point forward, left and up); template: values that the file
    does not state. wheel: (mass kg, (Ixx, Iyy, Izz) kg·m² about its centre, radius m or None). rack_mass: mass of a
    sliding rack, kg. move: hardpoints of a sheet that are moved: name to (3,) m, in the sheet's own axes. allow_outside:
    the sheet may name a table of points outside its folder. worksheet: worksheet of a workbook, by default the first.
    names: file of the names of a table's points, lower_ball = "LBJ". Warnings and errors as for load.

        >>> percuss.suspension.load("models/suspensions/double-wishbone.toml").contacts"""
def suspension_templates() -> list[tuple[str, str]]:
    """Templates of sheets: name, title.

    >>> [name for name, title in percuss.suspension.templates()]"""
def suspension_template(name: str, *, unit: str = "mm", axes: str = "iso") -> str:
    """Empty sheet of a template, to fill in: TOML text.

    >>> percuss.suspension.template("macpherson-strut", unit="mm")"""
def laws() -> list[tuple[str, str, str, str, bool, bool]]:
    """Contact laws: name, title, formula, source, exactness, need for the impact speed.

    >>> [law[0] for law in percuss.contact_law.laws()]"""
def tools() -> list[tuple[str, str]]:
    """Simulators: name, title.

    >>> [name for name, title in percuss.contact_law.tools()]"""
def regions() -> list[tuple[str, str, float, float]]:
    """Body regions: name, title, mass (kg), stiffness (N/m).

    >>> [name for name, title, mass, stiffness in percuss.reports.regions()]"""
def run_command(arguments: Sequence[str]) -> NoReturn:
    """Runs the command and ends the process with its exit code. The first argument is the program name."""

# JSON reports; _reports and _kinematics convert them.
def kinematics(
    model: Model | str | os.PathLike[str], request: Request, state: Sequence[tuple[str, float]], range: tuple[str, list[float]] | None
) -> str:
    """Report on the kinematics of a suspension. state: values by variable, m; range: variable of the rows and its values."""
def check(model: Model) -> str:
    """Summary of a model."""
def mass_report(model: Model, request: Request) -> str:
    """Report on one contact of a model, with the damper and the results of the table of the mass that are requested."""
def sweep_report(model: Model, request: Request) -> tuple[str, list[str]]:
    """Report on a contact at many rows of positions."""
def map_report(model: Model, request: Request) -> tuple[str, dict[str, dict[str, NDArray[Any]]], str]:
    """Maps of links: the report, the facets of each link as arrays, the picture as SVG."""
def map_point_report(model: Model, request: Request, directions: int) -> str:
    """Report on directions at a point."""
def reflected_inertias(model: Model, request: Request, joints: Sequence[str]) -> str:
    """Inertias reflected to joints. `joints`: "JOINT", or "JOINT=FROM:TO:COUNT" for a range of positions."""
def impact(model: Model, request: Request, also: Sequence[Contact | None]) -> str:
    """Report on a rigid impact at a contact of a model. also: further contacts that are no text, each in the place of its text."""
def extremes(model: Model, request: Request) -> str:
    """Smallest and largest effective mass, or another quantity, over ranges of driving joints, with kept links or points, or along a path."""
def safe_speed(model: Model, request: Request) -> str:
    """Safe speeds of a contact of a robot, as a list: at its pose, or at the slowest row of positions; or in each of
    several world directions, the worst direction last."""
def safe_speeds(
    masses: _Array, region: str | None, limits: tuple[float | None, float | None, float | None, float | None, float | None]
) -> _Array:
    """Safe speeds (m/s) of masses (kg; infinite for an immovable robot): a region of the body, and one limit of force (N), pressure (Pa) with
    area (m²), energy (J) or momentum (N·s). NaN for a mass that is NaN."""
def compare(designs: Sequence[tuple[str, Model, Request]], rows: Request) -> tuple[str, list[str]]:
    """Compares several designs by one question, at the same rows of positions if rows are given."""
def compare_study(path: str | os.PathLike[str]) -> tuple[str, list[str]]:
    """Compares the designs of a study file: its model, then its variants."""
def run_study(path: str | os.PathLike[str]) -> tuple[str, list[str]]:
    """Runs a study and returns the report of its sweep, or of its contact if the study has no sweep; adds the impact and the extremes."""
def ask(model: Model, request: str) -> str:
    """Results of the tables of a request, JSON."""
def starting_study(model: Model, path: str | os.PathLike[str]) -> str:
    """Initial study file for a model, which the file refers to by a path."""
def study_schema() -> str:
    """JSON schema of study files."""
def damp_mass(mass: float, request: Request) -> str:
    """Damper for an effective mass, kg."""
def damp(model: Model, request: Request) -> str:
    """Damper for a contact of a model, or for the stop of a joint."""
def impact_history(mass: float, request: Request, samples: int) -> _Array:
    """Time (s), penetration (m), its rate (m/s) and force (N) during an impact; (samples, 4)."""
