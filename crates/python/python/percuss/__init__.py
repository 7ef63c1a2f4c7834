"""Effective mass at a contact of a mechanism, and the contact damping that gives a restitution.

    >>> import percuss
    >>> model = percuss.load("models/four_bar.urdf")
    >>> contact = percuss.Contact("coupler", point=[0.35, 0.1, 0.0], normal=[0.0, 1.0, 0.0])
    >>> response = model.pose({"crank_hinge": 0.4}).respond(contact)
    >>> response.effective_mass  # kg

load, pose, respond: one contact. sweep: one contact at many configurations, arrays in and out. effective_mass: matrices of your own
solver. State, impacts, safe_speeds: states of other programs, impacts and safe speeds in arrays. mass, sweep_report, map, impact, extremes,
safe_speed, explain: the reports of the command line. suspension, study, contact_law: modules of these names. SI units throughout; quaternions are w, x, y, z.
"""

from __future__ import annotations

import warnings as _warnings
from importlib.metadata import version as _version
from typing import TYPE_CHECKING as _TYPE_CHECKING
from typing import Any as _Any

from . import _arguments, _percuss

_arguments.convert_all(_percuss, [name for name in _percuss.__all__ if name != "Workspace"])

from . import contact_law, converters, records, study, suspension
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
from ._impacts import Impacts, impacts, safe_speeds
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
    load,
    loads,
    regions,
    set_threads,
    sweep,
)
from ._percuss import diagnostic_of_parts as _diagnostic
from ._percuss import joint_of_parts as _joint
from ._percuss import model_of_bytes as _model_of_bytes
from ._percuss import sweep_of_parts as _sweep_of_parts
from ._remarks import RemarkFlags
from ._reports import (
    MapReport,
    Report,
    check,
    explain,
    extremes,
    friction_thresholds,
    impact,
    map,
    map_point,
    mass,
    reflected_inertias,
    safe_speed,
    safe_speed_directions,
    sweep_report,
    tolerate,
)
from ._request import Conditions
from ._sweeps import Status, SweepRow
from .converters import from_mujoco, from_pinocchio
from .state import State

__version__ = _version("percuss")

__all__ = [
    "Accelerations",
    "ArgumentTypeError",
    "Assembly",
    "AssemblyError",
    "Conditions",
    "Contact",
    "Diagnostic",
    "Impacts",
    "InputError",
    "Joint",
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
    "State",
    "Status",
    "Sweep",
    "SweepRow",
    "System",
    "Travel",
    "Workspace",
    "check",
    "contact_law",
    "converters",
    "effective_mass",
    "effective_masses",
    "explain",
    "extremes",
    "friction_thresholds",
    "from_mujoco",
    "from_pinocchio",
    "impact",
    "impacts",
    "load",
    "loads",
    "map",
    "map_point",
    "mass",
    "position_gradient",
    "records",
    "reflected_inertias",
    "regions",
    "safe_speed",
    "safe_speed_directions",
    "safe_speeds",
    "set_threads",
    "study",
    "suspension",
    "sweep",
    "sweep_report",
    "tolerate",
]


#: Names that have moved.
_MOVED = {
    "Damping": "contact_law.Damping",
    "Design": "study.Design",
    "FINITE": "Status.FINITE",
    "IMMOVABLE": "Status.IMMOVABLE",
    "Kinematics": "suspension.Kinematics",
    "MASSLESS": "Status.MASSLESS",
    "MASSLESS_TO_ROUNDING": "Status.MASSLESS_TO_ROUNDING",
    "NO_ANSWER": "Status.NO_ANSWER",
    "ask": "study.ask",
    "compare": "study.compare",
    "compare_study": "study.compare_study",
    "damp": "contact_law.damp",
    "damp_contact": "contact_law.damp_contact",
    "damp_stop": "contact_law.damp_stop",
    "impact_history": "contact_law.impact_history",
    "kinematics": "suspension.kinematics",
    "laws": "contact_law.laws",
    "load_suspension": "suspension.load",
    "run_study": "study.run",
    "starting_study": "study.starting",
    "study_schema": "study.schema",
    "suspension_template": "suspension.template",
    "suspension_templates": "suspension.templates",
    "tools": "contact_law.tools",
}


if not _TYPE_CHECKING:

    def __getattr__(name: str) -> _Any:
        """Object of a name that has moved; it will be removed in the next release."""
        if name not in _MOVED:
            raise AttributeError(f"module 'percuss' has no attribute {name!r}")
        _warnings.warn(f"percuss.{name} is now percuss.{_MOVED[name]}", DeprecationWarning, stacklevel=2)
        module, attribute = _MOVED[name].split(".")
        return getattr(globals()[module], attribute)


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


def _sweep(parts: dict[str, _Any]) -> Sweep:
    """Rebuilds a pickled sweep."""
    return _sweep_of_parts(parts)
