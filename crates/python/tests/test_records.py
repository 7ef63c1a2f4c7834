"""Reports have the keys and types that their classes state, show the answer, and become plain dicts."""

from __future__ import annotations

import copy
import json
import pickle
import types
import typing
from collections.abc import Callable, Iterator
from typing import Any

import pytest
import stub_docs
from cases import ROOT

import percuss
from percuss.records import Record

ARM = percuss.load(ROOT / "models/six_r_arm.urdf")
TOOL = percuss.Contact("tool", [0.08, 0, 0], [0, 1, 0])
CORNER = percuss.load(ROOT / "models/suspensions/double-wishbone.toml")
DAMPING = percuss.contact_law.Damping(0.5, 2e5, speed=1.0, tools=["all"])
TRAVEL = "wheel-travel=-10mm:10mm:3"
HIT: dict[str, Any] = {"speed": 1.0, "stiffness": 1e5}
MORE: dict[str, Any] = {"friction": 0.3, "reflected": ["elbow"], "percussion": ["elbow"], "rate_limit": {"elbow": 1.0}}
AT_ONCE: dict[str, Any] = {"sticking": True, "also": ["tool:0,0.1,0:0,0,1"]}
WIDE = {"yaw": (-1.0, 1.0), "elbow": (-1.0, 1.0)}
GUESS = percuss.Conditions(estimate=(["tool"],), ratio_at=[("tool", [0, 0, 0])], travel=[("tool", [0, 0, 0], [0, 0, 1], 0.0)])
DESIGNS = [percuss.study.Design("a", CORNER, "bump_stop"), percuss.study.Design("b", CORNER, "spring")]

#: Calls with their type, and text in repr of their result.
CALLS: dict[str, tuple[Callable[[], Any], str, str]] = {
    "check": (lambda: percuss.reports.check(CORNER), "CheckReport", "kg"),
    "mass": (lambda: percuss.mass(CORNER, "bump_stop", damping=DAMPING), "MassReport", "kg, status: finite"),
    "mass of an arm": (lambda: percuss.mass(ARM, TOOL, GUESS), "MassReport", "effective_mass: 3."),
    "sweep": (lambda: percuss.reports.sweep_report(ARM, TOOL, random=3), "SweepReport", "rows: 3"),
    "sweep of a stop": (lambda: percuss.reports.sweep_report(CORNER, "bump_stop", vary=TRAVEL), "SweepReport", "rows: 3"),
    "map": (lambda: percuss.map(percuss.load(ROOT / "models/shaped_arm.urdf")), "MapReport", "links: "),
    "map of a point": (lambda: percuss.reports.map_point(ARM, TOOL, 10), "PointMapReport", "directions: 10"),
    "damp": (lambda: percuss.contact_law.damp(2.0, DAMPING), "DampingReport", "peak_force: "),
    "damp a contact": (lambda: percuss.contact_law.damp_contact(CORNER, "bump_stop", DAMPING), "DampingReport", " N"),
    "damp a stop": (lambda: percuss.contact_law.damp_stop(ARM, "elbow", percuss.contact_law.Damping(0.5, 1e3, speed=1.0), end="upper"), "DampingReport", " N"),
    "explain": (lambda: percuss.reports.explain(CORNER, "bump_stop"), "Explanation", "links"),
    "friction_thresholds": (lambda: percuss.reports.friction_thresholds(CORNER, "bump_stop"), "FrictionThresholdsRecord", "jamming"),
    "reflected_inertias": (
        lambda: percuss.reports.reflected_inertias(ARM, ["elbow", "elbow=0:1:3"]), "ReflectedReport", "reflected_over",
    ),
    "tolerate": (lambda: percuss.reports.tolerate(CORNER, "bump_stop", "mass=2%,point=0.5mm", samples=10), "ToleranceReport", "worst_case"),
    "compare": (lambda: percuss.study.compare(DESIGNS, vary=TRAVEL), "ComparisonReport", "designs: 2"),
    "impact": (lambda: percuss.impact(ARM, TOOL, 0.5, **HIT, **MORE, **AT_ONCE), "ImpactReport", "impulse: 5."),
    "impact in time": (lambda: percuss.impact(ARM, TOOL, 0.5, **HIT, in_time=True), "ImpactReport", "impulse: 5."),
    "extremes": (lambda: percuss.extremes(ARM, TOOL, ranges=WIDE, starts=3), "ExtremesReport", "least.effective_mass: 3."),
    "safe speed": (lambda: percuss.safe_speed(ARM, TOOL, "chest", force=140.0, random=10), "SafeSpeedReport", "m/s"),
    "directions": (
        lambda: percuss.reports.safe_speed_directions(ARM, TOOL, "chest", [[0, 1, 0]], force=140.0)[0], "SafeSpeedReport", "m/s"
    ),
    "kinematics": (lambda: percuss.suspension.kinematics(CORNER, wheel_travel=[-0.01, 0, 0.01]).report, "KinematicsReport", "rows: 3"),
    "study": (lambda: percuss.study.run(ROOT / "models/four_bar.toml"), "", ""),
}
#: Keys that are no names in Python.
NO_NAMES = {"from"}


def problems(value: Any, hint: Any, path: str) -> Iterator[str]:
    """Values whose type is not the stated one."""
    if isinstance(hint, types.UnionType) or typing.get_origin(hint) is typing.Union:
        found = [list(problems(value, part, path)) for part in typing.get_args(hint)]
        if all(found):
            yield found[0][0]
    elif typing.get_origin(hint) is typing.Literal:
        if value not in typing.get_args(hint):
            yield f"{path}: {value!r} is not one of {typing.get_args(hint)}"
    elif typing.get_origin(hint) in (list, dict):
        if not isinstance(value, typing.get_origin(hint)):
            yield f"{path}: {type(value)} is not {hint}"
        elif isinstance(value, list):
            for number, one in enumerate(value):
                yield from problems(one, typing.get_args(hint)[0], f"{path}[{number}]")
        else:
            for key, one in value.items():
                yield from problems(one, typing.get_args(hint)[1], f"{path}.{key}")
    elif isinstance(hint, type) and issubclass(hint, Record):
        if type(value) is not hint:
            yield f"{path}: {type(value)} is not {hint}"
        else:
            yield from keys_and_types(value, path)
    elif not isinstance(value, (int, float) if hint is float else hint) or (isinstance(value, bool) and hint is not bool):
        yield f"{path}: {value!r} is not {hint}"


def keys_and_types(record: Record, path: str) -> Iterator[str]:
    """Keys that the type does not state, stated keys that are missing, and values of other types."""
    hints = {key: hint for key, hint in typing.get_type_hints(type(record)).items() if not key.startswith("_")}
    # Of a map: the arrays, which are attributes and no keys.
    hints.pop("facets", None)
    if unknown := set(record) - set(hints) - NO_NAMES:
        yield f"{path}: keys without a type: {unknown}"
    for key, hint in hints.items():
        if key in record:
            yield from problems(record[key], hint, f"{path}.{key}")
        elif type(None) not in typing.get_args(hint):
            yield f"{path}: no {key}"


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("name", CALLS)
def test_keys_and_types(name: str) -> None:
    call, kind, shown = CALLS[name]
    report = call()
    assert kind in ("", type(report).__name__)
    assert list(keys_and_types(report, name)) == []
    assert shown in repr(report) and repr(report).startswith(f"<{type(report).__name__}")
    assert {key for key in report if key.isidentifier()} <= set(dir(report))
    plain = report.to_dict()
    assert type(plain) is dict and plain == report and json.loads(report.to_json()) == json.loads(json.dumps(plain))
    assert not any(isinstance(value, Record) for value in plain.values())
    for again in (pickle.loads(pickle.dumps(report)), copy.deepcopy(report)):
        assert again == report and type(again) is type(report)
    assert all(getattr(report, key) is report[key] for key in report if key not in NO_NAMES)
    with pytest.raises(AttributeError, match="no 'nothing'"):
        report.nothing  # noqa: B018


def test_a_wrong_type_is_found() -> None:
    report = percuss.contact_law.damp(2.0, percuss.contact_law.Damping(0.5, 2e5))
    assert list(keys_and_types(percuss.records.DampingReport.of({**report, "damping": "x"}), "damp"))
    assert list(keys_and_types(percuss.records.DampingReport.of({**report, "other": 1}), "damp"))


def test_the_stub_has_the_docstrings_of_the_module() -> None:
    source = stub_docs.STUB.read_text()
    assert stub_docs.with_docstrings(source, percuss._percuss) == source, "run crates/python/tests/stub_docs.py"
    assert source.count('"""') > 200
