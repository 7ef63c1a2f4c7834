# Types of the extension module; tests/external/python.sh compares them with the module (stubtest).
import os
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Literal, NoReturn, TypedDict, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._kinematics import _Question
from ._matrices import MatrixBatch
from ._reports import Conditions, Damping, Design, _Impact, _SafeSpeed

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
    "explain",
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
    "regions",
    "run_command",
    "run_study",
    "safe_speed",
    "set_threads",
    "starting_study",
    "study_schema",
    "suspension_template",
    "suspension_templates",
    "sweep",
    "sweep_of_arrays",
    "sweep_report",
    "tolerate",
    "tools",
]

_Status = Literal["finite", "immovable", "massless"]
_Route = Literal["auto", "dense", "articulated"]
_Frame = Literal["root", "world"]
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
    @property
    def severity(self) -> str: ...
    @property
    def code(self) -> str: ...
    @property
    def path(self) -> str | None: ...
    @property
    def line(self) -> int | None: ...
    @property
    def column(self) -> int | None: ...
    @property
    def element(self) -> str | None: ...
    @property
    def message(self) -> str: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class Joint:
    @property
    def name(self) -> str: ...
    @property
    def kind(self) -> str: ...
    @property
    def parent(self) -> str: ...
    @property
    def child(self) -> str: ...
    @property
    def limits(self) -> tuple[float, float] | None: ...
    @property
    def mimics(self) -> str | None: ...
    @property
    def positions(self) -> tuple[int, int]: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class Contact:
    def __new__(
        cls,
        link: str,
        point: ArrayLike,
        normal: ArrayLike | None = None,
        *,
        against: str | None = None,
        toward: tuple[str, ArrayLike] | None = None,
        normal_frame: str = "link",
        turning: bool = False,
    ) -> Contact: ...
    @property
    def link(self) -> str: ...
    @property
    def against(self) -> str | None: ...
    @property
    def point(self) -> _Vector: ...
    @property
    def normal(self) -> _Vector | None: ...
    @property
    def toward(self) -> tuple[str, _Vector] | None: ...
    @property
    def normal_frame(self) -> str: ...
    @property
    def turning(self) -> bool: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __ne__(self, other: object, /) -> bool: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class Model:
    @property
    def name(self) -> str: ...
    @property
    def links(self) -> list[str]: ...
    @property
    def joints(self) -> list[Joint]: ...
    @property
    def closures(self) -> list[str]: ...
    @property
    def contacts(self) -> list[str]: ...
    @property
    def position_count(self) -> int: ...
    @property
    def position_names(self) -> list[str]: ...
    @property
    def velocity_names(self) -> list[str]: ...
    @property
    def total_mass(self) -> float: ...
    @property
    def diagnostics(self) -> list[Diagnostic]: ...
    @property
    def hardpoints(self) -> list[str]: ...
    def changed(
        self,
        *,
        link_mass: Mapping[str, float] = ...,
        link_com: Mapping[str, Sequence[float]] = ...,
        move: Mapping[str, Sequence[float]] = ...,
    ) -> Model: ...
    def to_urdf(self) -> str: ...
    def to_mjcf(self) -> str: ...
    def to_sdf(self) -> str: ...
    def system(
        self,
        *,
        base: str = "fixed",
        lock: Sequence[str] = ...,
        armature: dict[str, Any] | None = None,
        hold: Sequence[_Held] = ...,
    ) -> System: ...
    def assemble(self, guess: _Positions | None = None) -> Assembly: ...
    def pose(
        self,
        q: _Positions | ArrayLike | None = None,
        *,
        guess: _Positions | None = None,
        base_pose: ArrayLike | None = None,
        other_assembly: bool = False,
    ) -> Pose: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class System:
    @property
    def model(self) -> Model: ...
    @property
    def coordinates(self) -> int: ...
    @property
    def coordinate_joints(self) -> list[tuple[str | None, int]]: ...
    def assemble(self, guess: _Positions | None = None) -> Assembly: ...
    def pose(
        self,
        q: _Positions | ArrayLike | None = None,
        *,
        guess: _Positions | None = None,
        base_pose: ArrayLike | None = None,
        other_assembly: bool = False,
    ) -> Pose: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class Assembly:
    @property
    def model(self) -> Model: ...
    @property
    def degrees_of_freedom(self) -> int: ...
    @property
    def redundant_constraints(self) -> int: ...
    @property
    def redundant_loops(self) -> list[list[str]]: ...
    @property
    def drivers(self) -> list[str]: ...
    def rigid_loops(self) -> list[_RigidLoops]: ...
    def drawn_gaps(self) -> list[_DrawnGap]: ...
    def pose(
        self,
        q: _Positions | ArrayLike | None = None,
        *,
        guess: _Positions | None = None,
        base_pose: ArrayLike | None = None,
        other_assembly: bool = False,
    ) -> Pose: ...
    def workspace(self, contact: Contact, *, base_pose: ArrayLike | None = None) -> Workspace: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class Workspace:
    def effective_mass(self, q: ArrayLike) -> float | None: ...
    @property
    def status(self) -> _Status | None: ...
    @property
    def findings(self) -> list[Diagnostic] | None: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class Pose:
    @property
    def model(self) -> Model: ...
    @property
    def positions(self) -> _Array: ...
    @property
    def joints(self) -> dict[str, _Array]: ...
    @property
    def degrees_of_freedom(self) -> int: ...
    @property
    def is_singular(self) -> bool: ...
    @property
    def closure_residual(self) -> float | None: ...
    @property
    def findings(self) -> list[Diagnostic]: ...
    def link_frame(self, link: str, *, frame: _Frame | None = None) -> _Array: ...
    def mass_matrix(self) -> _Array: ...
    def constraint_matrix(self) -> _Array: ...
    def contact_row(self, contact: Contact) -> _Array: ...
    def point_jacobian(
        self, link: str, point: ArrayLike, *, frame: _Frame | None = None
    ) -> _Array: ...
    def inverse_operational_inertia(
        self, contact: Contact, *, frame: _Frame | None = None
    ) -> _Array: ...
    def contact_map(
        self, link: str, points: ArrayLike, normals: ArrayLike, *, against: str | None = None
    ) -> tuple[_Array, _Array, NDArray[np.uint8]]: ...
    def principal_masses(
        self, link: str, point: ArrayLike, *, against: str | None = None
    ) -> list[_PrincipalMass] | None: ...
    def effective_mass_gradient(self, contact: Contact) -> dict[str, _Array] | None: ...
    def effective_mass_rate(self, contact: Contact, velocities: _Positions) -> float | None: ...
    def accelerations(
        self,
        velocities: _Positions | None = None,
        *,
        base: ArrayLike | None = None,
        gravity: ArrayLike | None = None,
        forces: Sequence[tuple[str, ArrayLike, ArrayLike]] = ...,
        frame: _Frame | None = None,
    ) -> Accelerations: ...
    def advanced_along(self, response: Response, distance: float) -> Pose | None: ...
    def outside_limits(self) -> dict[str, tuple[float, tuple[float, float]]]: ...
    def rank(self) -> _PoseRank: ...
    def respond(self, contact: Contact, *, route: _Route = "auto") -> Response: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class Travel:
    def __new__(cls, pose: Pose, link: str, point: ArrayLike, direction: ArrayLike) -> Travel: ...
    @property
    def link(self) -> str: ...
    @property
    def point(self) -> _Array: ...
    @property
    def direction(self) -> _Array: ...
    def displacement(self, pose: Pose) -> float: ...
    def rate(self, pose: Pose, joint: str) -> float | None: ...
    def driver(self, pose: Pose, *, set: Sequence[str] = ...) -> str: ...
    def pose(
        self, start: Pose, displacement: float, *, driver: str | None = None, q: _Positions | None = None
    ) -> Pose: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class Accelerations:
    @property
    def joints(self) -> dict[str, _Array]: ...
    def point(self, link: str, point: ArrayLike, *, frame: _Frame | None = None) -> _Array: ...

@final
class Response:
    @property
    def effective_mass(self) -> float | None: ...
    @property
    def status(self) -> _Status: ...
    @property
    def error(self) -> float | None: ...
    @property
    def error_budget(self) -> _ErrorBudget: ...
    @property
    def route(self) -> Literal["dense", "articulated"]: ...
    @property
    def degrees_of_freedom(self) -> int: ...
    @property
    def singular_pose(self) -> bool: ...
    @property
    def remarks(self) -> list[str]: ...
    @property
    def findings(self) -> list[Diagnostic]: ...
    @property
    def joint_velocities(self) -> dict[str, _Array]: ...
    @property
    def base_velocity(self) -> _Array: ...
    @property
    def contributions(self) -> dict[str, float] | None: ...
    @property
    def rotor_contributions(self) -> dict[str, float] | None: ...
    @property
    def point_world(self) -> _Array: ...
    @property
    def normal_world(self) -> _Array: ...
    def branch_limits(self) -> list[float | None]: ...
    def point_velocity(
        self, link: str, point: ArrayLike, *, frame: _Frame | None = None
    ) -> _Array | None: ...
    def against_mass(self, mass: float) -> Response: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class MatrixResponse:
    @property
    def effective_mass(self) -> float | None: ...
    @property
    def status(self) -> _Status: ...
    @property
    def error(self) -> float | None: ...
    @property
    def velocity(self) -> _Array: ...
    @property
    def degrees_of_freedom(self) -> int: ...
    @property
    def rank(self) -> _RankReport: ...
    @property
    def remarks(self) -> list[str]: ...

@final
class Sweep:
    @property
    def effective_mass(self) -> _Array: ...
    @property
    def error(self) -> _Array: ...
    @property
    def status(self) -> NDArray[np.uint8]: ...
    @property
    def remarks(self) -> NDArray[np.uint32]: ...
    @property
    def findings(self) -> list[Diagnostic]: ...
    @property
    def gradient(self) -> _Array: ...
    @property
    def inverse_operational_inertia(self) -> _Array: ...
    def to_svg(self) -> str: ...
    def _repr_html_(self) -> str: ...
    def __len__(self) -> int: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

def load(
    path: str | os.PathLike[str], *, accept: Sequence[str] = ..., max_size: int = ...
) -> Model: ...
def loads(text: str, *, name: str = "<text>", accept: Sequence[str] = ...) -> Model: ...
def sweep_of_arrays(
    effective_mass: _Array,
    error: _Array,
    status: NDArray[np.uint8],
    remarks: NDArray[np.uint32],
    link: str,
    no_answer: str | None,
    gradient: _Array | None,
    inverse_operational_inertia: _Array | None,
) -> Sweep: ...
def set_threads(threads: int | None = None) -> None: ...
def diagnostic_of_parts(
    severity: str,
    code: str,
    place: tuple[str | None, int | None, int | None, str | None],
    message: str,
) -> Diagnostic: ...
def joint_of_parts(
    names: tuple[str, str, str],
    kind: str,
    limits: tuple[float, float] | None,
    mimics: str | None,
    positions: tuple[int, int],
) -> Joint: ...
def model_of_bytes(bytes: bytes, name: str, accept: Sequence[str]) -> Model: ...
def effective_mass(
    M: Any,
    j: Any,
    A: Any = None,
    *,
    lengths: ArrayLike | None = None,
    rank_floor: float | None = None,
    accuracy: float | None = None,
    row_noise: float | None = None,
) -> MatrixResponse: ...
def effective_masses(
    M: ArrayLike,
    j: ArrayLike,
    A: ArrayLike | None = None,
    *,
    lengths: ArrayLike | None = None,
    rank_floor: float | None = None,
    accuracy: float | None = None,
    row_noise: float | None = None,
) -> MatrixBatch: ...
def matrix_findings(remarks: NDArray[np.uint32], small_rows: Sequence[int]) -> list[Diagnostic]: ...
def sweep(
    model: Model | System | Assembly,
    contact: Contact,
    q: ArrayLike,
    *,
    joints: Sequence[str] | None = None,
    base_pose: ArrayLike | None = None,
    other_assembly: bool = False,
    points: ArrayLike | None = None,
    normals: ArrayLike | None = None,
    gradient: bool = False,
    inverse_operational_inertia: bool = False,
    threads: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Sweep: ...
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
) -> Model: ...
def suspension_templates() -> list[tuple[str, str]]: ...
def suspension_template(name: str, *, unit: str = "mm", axes: str = "iso") -> str: ...
def laws() -> list[tuple[str, str, str, str, bool, bool]]: ...
def tools() -> list[tuple[str, str]]: ...
def regions() -> list[tuple[str, str, float, float]]: ...
def run_command(arguments: Sequence[str]) -> NoReturn: ...

# JSON reports; _reports and _kinematics convert them.
def kinematics(model: Model, question: _Question) -> str: ...
def check(model: Model) -> str: ...
def mass_report(model: Model, contact: Contact | str, conditions: Conditions, damping: Damping | None) -> str: ...
def sweep_report(
    model: Model,
    contact: Contact | str,
    conditions: Conditions,
    vary: Sequence[str | tuple[str, float, float, int]] | None,
    input: tuple[str, Sequence[str]] | None,
    random: tuple[int, int] | None,
    gradient: bool,
) -> tuple[str, list[str]]: ...
def map_report(
    model: Model,
    conditions: Conditions,
    against: str | None,
    links: Sequence[str] | None,
    shapes: str,
    edge: float | None,
    packages: Sequence[tuple[str, str]],
) -> tuple[str, dict[str, dict[str, NDArray[Any]]], str]: ...
def map_point_report(model: Model, contact: Contact | str, conditions: Conditions, directions: int) -> str: ...
def explain(model: Model, contact: Contact | str, conditions: Conditions) -> str: ...
def tolerate(
    model: Model, contact: Contact | str, conditions: Conditions, tolerance: str, samples: tuple[int, int] | None
) -> str: ...
def impact(
    model: Model, contact: Contact | str, conditions: Conditions, impact: _Impact
) -> str: ...
def extremes(
    model: Model,
    contact: Contact | str,
    conditions: Conditions,
    ranges: Sequence[str],
    quantity: str,
    normals: str,
    starts: int,
) -> str: ...
def safe_speed(
    model: Model,
    contact: Contact | str,
    conditions: Conditions,
    speed: _SafeSpeed,
    vary: Sequence[str | tuple[str, float, float, int]] | None,
    input: tuple[str, Sequence[str]] | None,
    random: tuple[int, int] | None,
) -> str: ...
def compare(
    designs: Sequence[Design],
    vary: Sequence[str | tuple[str, float, float, int]] | None,
    input: tuple[str, Sequence[str]] | None,
    random: tuple[int, int] | None,
) -> tuple[str, list[str]]: ...
def compare_study(path: str | os.PathLike[str], name: str) -> tuple[str, list[str]]: ...
def run_study(path: str | os.PathLike[str]) -> tuple[str, list[str]]: ...
def starting_study(model: Model, path: str | os.PathLike[str]) -> str: ...
def study_schema() -> str: ...
def damp_mass(mass: float, damping: Damping) -> str: ...
def damp(
    model: Model,
    contact: Contact | str | None,
    stop: tuple[str, str | None] | None,
    conditions: Conditions,
    damping: Damping,
) -> str: ...
def impact_history(mass: float, damping: Damping, samples: int) -> _Array: ...
