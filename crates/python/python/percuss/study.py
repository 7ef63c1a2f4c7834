"""Studies: questions in a file or in memory, and designs that are compared.

    >>> percuss.study.run("models/studies/variants.toml")
    >>> percuss.study.ask(model, {"contact": {"at": "bump_stop"}, "impact": {"restitution": 0.3, "speed": 1}})
"""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, cast

from . import _percuss, records
from ._arguments import check_fields, checked
from ._percuss import Contact, Model
from ._request import Conditions, Of, Range, asked, json_of, rows, tables
from .errors import InputError
from .reports import Report, with_rows


@dataclass(frozen=True)
class Design:
    """Design for ``compare``: a model, a contact and conditions, under a name.

        >>> percuss.study.Design("stock", corner, "bump_stop")
    """

    name: str
    model: Of
    contact: Contact | str
    conditions: Conditions | None = None

    def __post_init__(self) -> None:
        check_fields(self)


@checked
def compare(
    designs: Sequence[Design],
    *,
    vary: Range | Sequence[Range] | None = None,
    input: str | os.PathLike[str] | None = None,
    ignore: Sequence[str] = (),
    random: int | None = None,
    seed: int = 0,
) -> records.ComparisonReport:
    """Compares at least two designs by one question: each result, with its difference from the first. vary, input,
    random: row source, as for ``sweep_report``; without rows, only the pose is compared. As ``percuss compare``.

        >>> percuss.study.compare([percuss.study.Design("a", corner, "bump_stop"), percuss.study.Design("b", corner, "spring")]).designs
    """
    if len(designs) < 2:
        raise InputError(f"designs has {len(designs)} entries; expected two at least")
    table = rows(vary, input, ignore, random, seed)
    reads = ("frame", "against_mass", "ratio_at", *(() if table is None else ("estimate",)))
    given = [(design.name, *asked(design.model, design.contact, design.conditions, reads=reads)) for design in designs]
    source = tables(sweep=table)
    return records.ComparisonReport.of(with_rows(_percuss.compare(given, (source, None, None))))


@checked
def compare_study(path: str | os.PathLike[str]) -> records.ComparisonReport:
    """Compares the variants of a study (TOML) with its model, which has the name ``[model] name``. As ``percuss compare STUDY``.

        >>> percuss.study.compare_study("models/studies/variants.toml").designs
    """
    return records.ComparisonReport.of(with_rows(_percuss.compare_study(path)))


#: Reports of studies by their schema.
_BY_SCHEMA: Mapping[str, type[Report]] = {
    "percuss.sweep": records.SweepReport,
    "percuss.mass": records.MassReport,
    "percuss.damp": records.DampingReport,
    "percuss.map": records.MapRecord,
    "percuss.map-point": records.PointMapReport,
    "percuss.safe-speed": records.SafeSpeedReport,
    "percuss.check": records.CheckReport,
    "percuss.kinematics": records.KinematicsReport,
}

@checked
def run(path: str | os.PathLike[str]) -> records.AnyRecord:
    """Runs a study (TOML) and returns the report of its sweep, or of its contact if the study has no sweep. If the study has the tables
    [impact] and [extremes], the keys "impact" and "extremes" of the report contain the reports of ``impact`` and ``extremes``. Safe speeds
    in several directions are a list under the key "reports". Writes no file. As ``percuss run``.

        >>> percuss.study.run("models/four_bar.toml")
    """
    found = with_rows(_percuss.run_study(path))
    if isinstance(found, list):
        speeds = [records.SafeSpeedReport.of(one) for one in found]
        return cast("records.AnyRecord", speeds[0] if len(speeds) == 1 else Report(reports=speeds))
    report = _BY_SCHEMA[found["schema"].split("/")[0]].of(found)
    for key, record in (("impact", records.ImpactReport), ("extremes", records.ExtremesReport)):
        if key in found:
            report[key] = record.of(found[key])
    return cast("records.AnyRecord", report)


@checked
def ask(model: Model, request: Mapping[str, Any]) -> records.RequestReport:
    """Answers the tables of a study about a model: ``{"contact": {"at": "bump_stop"}, "impact": {"restitution": 0.3, "speed": 1}}``. The
    request has the tables and keys of docs/reference/STUDY_KEYS.md, without the path of a model and without output files. The keys of
    the result are the tables: "mass", "contacts", "damping", "impact", "extremes", "sweep", "comparison", "kinematics", "targets", "map",
    "safe_speed" (a list), "check"; "generate", "convert", "export" (files as text). SI units; text with a unit is allowed. Raises InputError, whose message contains the key, and NoAnswerError.

        >>> percuss.study.ask(corner, {"contact": {"at": "bump_stop"}, "impact": {"restitution": 0.3, "speed": 1}}).impact
    """
    return records.RequestReport.of(json.loads(_percuss.ask(model, json_of(request, "request"))))


@checked
def starting(model: Model, path: str | os.PathLike[str]) -> str:
    """Complete initial study of a model as TOML, with a contact. path: path of the model's file in the study,
    relative to the study's folder. As ``percuss init``.

        >>> print(percuss.study.starting(model, "four_bar.urdf"))
    """
    return _percuss.starting_study(model, path)


def schema() -> dict[str, Any]:
    """JSON schema of studies: the permitted tables and keys. As ``percuss schema``.

        >>> percuss.study.schema()["properties"].keys()
    """
    return cast("dict[str, Any]", json.loads(_percuss.study_schema()))


__all__ = ["Design", "ask", "compare", "compare_study", "run", "schema", "starting"]
