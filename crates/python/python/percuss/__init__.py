"""Effective mass at a contact of a mechanism, and the contact damping that gives a restitution.

    >>> import percuss
    >>> model = percuss.load("models/four_bar.urdf")
    >>> contact = percuss.Contact("coupler", point=[0.35, 0.1, 0.0], normal=[0.0, 1.0, 0.0])
    >>> response = model.pose({"crank_hinge": 0.4}).respond(contact)
    >>> response.effective_mass  # kg

load, pose, respond: one contact. sweep: one contact at many configurations, arrays in and out. effective_mass: matrices of your own
solver. State, impacts, safe_speeds: states of other programs, impacts and safe speeds in arrays. mass, map, impact, extremes, safe_speed: reports
of the command line; reports has the others. suspension, study, contact_law, converters, errors, results, records: modules of these names. SI units
throughout; quaternions are w, x, y, z.
"""

from __future__ import annotations

import warnings as _warnings
from importlib.metadata import version as _version
from typing import TYPE_CHECKING as _TYPE_CHECKING
from typing import Any as _Any

from . import _arguments, _percuss

_arguments.convert_all(_percuss, [name for name in _percuss.__all__ if name != "Workspace"])

from . import contact_law, converters, errors, records, reports, results, study, suspension
from ._impacts import impacts, safe_speeds
from ._percuss import (
    Assembly,
    Contact,
    Model,
    Pose,
    System,
    Workspace,
    effective_mass,
    effective_masses,
    load,
    loads,
    set_threads,
    sweep,
)
from ._percuss import diagnostic_of_parts as _diagnostic
from ._percuss import joint_of_parts as _joint
from ._percuss import model_of_bytes as _model_of_bytes
from ._percuss import sweep_of_parts as _sweep_of_parts
from ._remarks import RemarkFlags
from ._request import Conditions
from ._sweeps import Status
from .converters import from_mujoco, from_pinocchio, from_usd
from .errors import InputError, LoadError, ModelWarning, NoAnswerError, PercussError
from .reports import extremes, impact, map, mass, safe_speed
from .results import Sweep as _Sweep
from .state import State

__version__ = _version("percuss")

__all__ = [
    "Assembly",
    "Conditions",
    "Contact",
    "InputError",
    "LoadError",
    "Model",
    "ModelWarning",
    "NoAnswerError",
    "PercussError",
    "Pose",
    "RemarkFlags",
    "State",
    "Status",
    "System",
    "Workspace",
    "contact_law",
    "converters",
    "effective_mass",
    "effective_masses",
    "errors",
    "extremes",
    "from_mujoco",
    "from_pinocchio",
    "from_usd",
    "impact",
    "impacts",
    "load",
    "loads",
    "map",
    "mass",
    "records",
    "reports",
    "results",
    "safe_speed",
    "safe_speeds",
    "set_threads",
    "study",
    "suspension",
    "sweep",
]


#: Names that have moved.
_MOVED = {
    "Accelerations": "results.Accelerations",
    "ArgumentTypeError": "errors.ArgumentTypeError",
    "AssemblyError": "errors.AssemblyError",
    "Damping": "contact_law.Damping",
    "Design": "study.Design",
    "Diagnostic": "results.Diagnostic",
    "FINITE": "Status.FINITE",
    "IMMOVABLE": "Status.IMMOVABLE",
    "Impacts": "results.Impacts",
    "Joint": "results.Joint",
    "Kinematics": "suspension.Kinematics",
    "MASSLESS": "Status.MASSLESS",
    "MASSLESS_TO_ROUNDING": "Status.MASSLESS_TO_ROUNDING",
    "MapReport": "reports.MapReport",
    "MatrixBatch": "results.MatrixBatch",
    "MatrixResponse": "results.MatrixResponse",
    "NO_ANSWER": "Status.NO_ANSWER",
    "NotComputedError": "errors.NotComputedError",
    "Report": "reports.Report",
    "Response": "results.Response",
    "Sweep": "results.Sweep",
    "SweepRow": "results.SweepRow",
    "Travel": "suspension.Travel",
    "ask": "study.ask",
    "check": "reports.check",
    "compare": "study.compare",
    "compare_study": "study.compare_study",
    "damp": "contact_law.damp",
    "damp_contact": "contact_law.damp_contact",
    "damp_stop": "contact_law.damp_stop",
    "explain": "reports.explain",
    "friction_thresholds": "reports.friction_thresholds",
    "impact_history": "contact_law.impact_history",
    "kinematics": "suspension.kinematics",
    "laws": "contact_law.laws",
    "load_suspension": "suspension.load",
    "map_point": "reports.map_point",
    "position_gradient": "converters.position_gradient",
    "reflected_inertias": "reports.reflected_inertias",
    "regions": "reports.regions",
    "run_study": "study.run",
    "safe_speed_directions": "reports.safe_speed_directions",
    "starting_study": "study.starting",
    "study_schema": "study.schema",
    "suspension_template": "suspension.template",
    "suspension_templates": "suspension.templates",
    "sweep_report": "reports.sweep_report",
    "tolerate": "reports.tolerate",
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


def _sweep(parts: dict[str, _Any]) -> _Sweep:
    """Rebuilds a pickled sweep."""
    return _sweep_of_parts(parts)


del annotations
