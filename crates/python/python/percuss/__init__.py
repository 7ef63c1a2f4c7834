"""Effective mass at a contact of a mechanism, and the contact damping that gives a restitution.

    >>> import percuss
    >>> model = percuss.load("models/four_bar.urdf")
    >>> contact = percuss.Contact("coupler", point=[0.35, 0.1, 0.0], normal=[0.0, 1.0, 0.0])
    >>> response = model.pose({"crank_hinge": 0.4}).respond(contact)
    >>> response.effective_mass  # kg

load, pose, respond: one contact. sweep: one contact at many configurations, arrays in and out. effective_mass: matrices of your own
solver. mass, sweep_report, map, damp, impact, extremes, safe_speed, compare, explain, run_study: the reports of the command line. kinematics: wheel
angles and motion ratios of suspensions. SI units throughout; quaternions are w, x, y, z.
"""

from __future__ import annotations

from importlib.metadata import version as _version
from typing import Any as _Any

from . import _arguments, _percuss

_arguments.convert_all(_percuss, [name for name in _percuss.__all__ if name != "Workspace"])

from . import converters, records
from ._errors import (
    ArgumentTypeError,
    AssemblyError,
    InputError,
    LoadError,
    ModelWarning,
    NoAnswerError,
    NotComputedError,
    PercussError,
)
from ._gradients import position_gradient
from ._kinematics import Kinematics, kinematics
from ._matrices import MatrixBatch
from ._percuss import (
    Accelerations,
    Assembly,
    Contact,
    Diagnostic,
    Joint,
    MatrixResponse,
    Model,
    Pose,
    Response,
    Sweep,
    System,
    Travel,
    Workspace,
    effective_mass,
    effective_masses,
    laws,
    load,
    load_suspension,
    loads,
    regions,
    set_threads,
    suspension_template,
    suspension_templates,
    sweep,
    tools,
)
from ._percuss import diagnostic_of_parts as _diagnostic
from ._percuss import joint_of_parts as _joint
from ._percuss import model_of_bytes as _model_of_bytes
from ._percuss import sweep_of_arrays as _sweep_of_arrays
from ._remarks import RemarkFlags
from ._reports import (
    Design,
    MapReport,
    Report,
    ask,
    check,
    compare,
    compare_study,
    damp,
    damp_contact,
    damp_stop,
    explain,
    extremes,
    friction_thresholds,
    impact,
    impact_history,
    map,
    map_point,
    mass,
    reflected_inertias,
    run_study,
    safe_speed,
    safe_speed_directions,
    starting_study,
    study_schema,
    sweep_report,
    tolerate,
)
from ._request import Conditions, Damping
from .converters import from_mujoco, from_pinocchio

__version__ = _version("percuss")

#: Status codes in the arrays of sweep, effective_masses and contact maps.
FINITE, IMMOVABLE, MASSLESS, NO_ANSWER, MASSLESS_TO_ROUNDING = range(5)

__all__ = [
    "FINITE",
    "IMMOVABLE",
    "MASSLESS",
    "MASSLESS_TO_ROUNDING",
    "NO_ANSWER",
    "Accelerations",
    "ArgumentTypeError",
    "Assembly",
    "AssemblyError",
    "Conditions",
    "Contact",
    "Damping",
    "Design",
    "Diagnostic",
    "InputError",
    "Joint",
    "Kinematics",
    "LoadError",
    "MapReport",
    "MatrixBatch",
    "MatrixResponse",
    "Model",
    "ModelWarning",
    "NoAnswerError",
    "NotComputedError",
    "PercussError",
    "Pose",
    "RemarkFlags",
    "Report",
    "Response",
    "Sweep",
    "System",
    "Travel",
    "Workspace",
    "ask",
    "check",
    "compare",
    "compare_study",
    "converters",
    "damp",
    "damp_contact",
    "damp_stop",
    "effective_mass",
    "effective_masses",
    "explain",
    "extremes",
    "friction_thresholds",
    "from_mujoco",
    "from_pinocchio",
    "impact",
    "impact_history",
    "kinematics",
    "laws",
    "load",
    "load_suspension",
    "loads",
    "map",
    "map_point",
    "mass",
    "position_gradient",
    "records",
    "reflected_inertias",
    "regions",
    "run_study",
    "safe_speed",
    "safe_speed_directions",
    "set_threads",
    "starting_study",
    "study_schema",
    "suspension_template",
    "suspension_templates",
    "sweep",
    "sweep_report",
    "tolerate",
    "tools",
]


def _contact(
    link: str,
    point: tuple[float, float, float],
    normal: tuple[float, float, float] | None,
    against: str | None,
    toward: tuple[str, tuple[float, float, float]] | None,
    normal_frame: _Any,
    turning: bool,
    cable: bool,
    axis: tuple[float, float, float] | None = None,
) -> Contact:
    """Rebuilds a pickled contact."""
    if axis is not None:
        return Contact.about_axis(link, axis, against=against, axis_frame=normal_frame)
    return Contact(
        link,
        point,
        normal,
        against=against,
        toward=toward,
        normal_frame=normal_frame,
        turning=turning,
        cable=cable,
    )


def _result_of(owner: _Any, method: str, arguments: tuple[_Any, ...], keywords: dict[str, _Any]) -> _Any:
    """Rebuilds a pickled object: the result of a method of another object."""
    return getattr(owner, method)(*arguments, **keywords)


def _model(text: bytes, name: str, accept: list[str]) -> Model:
    """Rebuilds a pickled model, without the warnings of its first loading."""
    import warnings

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ModelWarning)
        return _model_of_bytes(text, name, accept)


def _sweep(
    effective_mass: _Any,
    error: _Any,
    status: _Any,
    remarks: _Any,
    link: str,
    no_answer: str | None,
    gradient: _Any = None,
    inverse: _Any = None,
) -> Sweep:
    """Rebuilds a pickled sweep."""
    return _sweep_of_arrays(effective_mass, error, status, remarks, link, no_answer, gradient, inverse)
