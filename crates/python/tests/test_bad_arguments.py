"""Every argument of every public call with invalid values: a PercussError with the name of the argument, or a result; never another
exception, a panic, an abort or an endless computation.

The calls are those of the stubs and of the public functions; a new call or argument without an entry fails.
"""

from __future__ import annotations

import concurrent.futures
import dataclasses
import inspect
import multiprocessing
import os
import signal
import threading
import traceback
import warnings
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from cases import ROOT
from test_every_call import (
    APART, ARM, ASSEMBLY, BAR, CALLS, CLOSED, CORNER, COUPLER, DAMPING, MASS, MOVING, NO_CALLS, POINTS, POSE, Q, RESPONSE, ROW, SHAPED,
    STATE, STUDY, SWEEP, SYSTEM, TOOL, TRAVEL, WITHIN, workspace,
)  # fmt: skip

import percuss

#: Time of one call with an invalid argument, s. Reports of valid questions of this file take less than one.
TIME = 60
#: Arguments that a message names otherwise: a file by its path, a text by its line, a limit by the file that exceeds it, a
#: request by its keys, a density by the masses.
OTHER_NAMES = {"path", "text", "input", "max_size", "rack_mass", "request", "shape_density", "replaces"}
#: Values that are valid alone: the message names the part that does not fit to them.
VALID_ALONE = {"a model", "another model", "another contact", "a pose of another model"}
#: Values whose results are out of range: the message names the result.
OUT_OF_RANGE = {"a large number", "a small number", "a large integer"}
#: Functions of the caller: their exceptions are passed on.
OWN_ERRORS = {("progress", "a function"), ("progress", "a class")}
VARIANTS = ROOT / "models/studies/variants.toml"


@dataclass
class Call:
    """Function with valid arguments."""

    function: Callable[..., Any]
    arguments: dict[str, Any]


def conditions_of(**fields: Any) -> Any:
    return percuss.mass(ARM, TOOL, percuss.Conditions(**fields))


def damping_of(**fields: Any) -> Any:
    return percuss.contact_law.damp(2.0, percuss.contact_law.Damping(**fields))


def design_of(**fields: Any) -> Any:
    return percuss.study.compare([percuss.study.Design(**fields), percuss.study.Design("other", ARM, TOOL)])


ROWS: dict[str, Any] = {"vary": None, "input": None, "ignore": [], "random": 3, "seed": 0}
LIMITS: dict[str, Any] = {"force": 140.0, "pressure": None, "area": None, "energy": None, "momentum": None, "load": 0.0}
HERE: dict[str, Any] = {"q": {"elbow": 0.1}, "guess": {}, "base_pose": [0, 0, 0, 1, 0, 0, 0], "other_assembly": False}
PLACE: dict[str, Any] = {"link": "tool", "point": [0.0, 0.0, 0.0]}
MATRICES: dict[str, Any] = {
    "M": MASS, "j": ROW, "A": np.zeros((0, 2)), "lengths": [1.0, 1.0], "rank_floor": 1e-14, "accuracy": 1e-16, "row_noise": 0.0,
}  # fmt: skip

CASES: dict[str, Call] = {
    "load": Call(percuss.load, {"path": ROOT / "models/planar_2r.urdf", "accept": [], "max_size": 1 << 20}),
    "loads": Call(percuss.loads, {"text": (ROOT / "models/planar_2r.urdf").read_text(), "name": "arm", "accept": []}),
    "suspension.load": Call(
        percuss.suspension.load,
        {"path": ROOT / "models/suspensions/double-wishbone.toml", "side": None, "unit": None, "axes": None, "template": None,
         "wheel": None, "rack_mass": None, "move": {}, "allow_outside": False, "worksheet": None, "names": None},
    ),
    "suspension.template": Call(percuss.suspension.template, {"name": "double-wishbone", "unit": "mm", "axes": "iso"}),
    "suspension.templates": Call(percuss.suspension.templates, {}),
    "contact_law.laws": Call(percuss.contact_law.laws, {}),
    "contact_law.tools": Call(percuss.contact_law.tools, {}),
    "reports.regions": Call(percuss.reports.regions, {}),
    "study.schema": Call(percuss.study.schema, {}),
    "set_threads": Call(percuss.set_threads, {"threads": 2}),
    "reports.check": Call(percuss.reports.check, {"model": ARM}),
    "mass": Call(percuss.mass, {"model": ARM, "contact": TOOL, "conditions": None, "damping": None, "certify": False}),
    "reports.sweep_report": Call(
        percuss.reports.sweep_report, {"model": ARM, "contact": TOOL, "conditions": None, **ROWS, "gradient": False}
    ),
    "map": Call(
        percuss.map,
        {"model": SHAPED, "conditions": None, "against": None, "links": ["finger"], "shapes": "auto", "edge": 0.05, "packages": {}},
    ),
    "reports.map_point": Call(percuss.reports.map_point, {"model": ARM, "contact": TOOL, "directions": 20, "conditions": None}),
    "contact_law.damp": Call(percuss.contact_law.damp, {"mass": 2.0, "damping": DAMPING}),
    "contact_law.damp_contact": Call(
        percuss.contact_law.damp_contact, {"model": CORNER, "contact": "bump_stop", "damping": DAMPING, "conditions": None}
    ),
    "contact_law.damp_stop": Call(
        percuss.contact_law.damp_stop, {"model": ARM, "joint": "elbow", "damping": DAMPING, "conditions": None, "end": "upper"}
    ),
    "contact_law.impact_history": Call(percuss.contact_law.impact_history, {"mass": 2.0, "damping": DAMPING, "samples": 20}),
    "reports.explain": Call(percuss.reports.explain, {"model": ARM, "contact": TOOL, "conditions": None}),
    "reports.friction_thresholds": Call(percuss.reports.friction_thresholds, {"model": ARM, "contact": TOOL, "conditions": None}),
    "reports.reflected_inertias": Call(
        percuss.reports.reflected_inertias, {"model": BAR, "joints": ["crank_hinge"], "conditions": None}
    ),
    "reports.tolerate": Call(
        percuss.reports.tolerate,
        {"model": ARM, "contact": TOOL, "tolerance": "mass=2%", "conditions": None, "samples": 5, "seed": 0},
    ),
    "study.compare": Call(
        percuss.study.compare,
        {"designs": [percuss.study.Design("a", ARM, TOOL), percuss.study.Design("b", ARM, TOOL)], **ROWS},
    ),
    "study.compare_study": Call(percuss.study.compare_study, {"path": VARIANTS}),
    "impact": Call(
        percuss.impact,
        {"model": ARM, "contact": TOOL, "restitution": 0.5, "conditions": None, "speed": 1.0, "friction": None, "rates": None,
         "base_twist": None, "stiffness": 1e5, "exponent": None, "law": "kelvin-voigt", "rate_limit": None, "reflected": [],
         "percussion": [], "restitution_law": None, "also": [], "sticking": False, "stiffness_ratio": [],
         "contact_exponent": None, "in_time": False, "gravity": None, "also_restitution": [], "gear_limit": None,
         "point_error": None, "joint_spring": None, "stiffness_curve": None, "springs": None, "spring": [], "damper": [],
         "drive": [], "reach": False, "damping": None, "hunt_crossley": None, "loss_factor": None, "compliance": False},
    ),
    "extremes": Call(
        percuss.extremes,
        {"model": ARM, "contact": TOOL, "conditions": None, "ranges": {"elbow": (-1.0, 1.0)}, "normals": "given", "starts": 2,
         "quantity": "mass", "contact_law": None, "keep": [], "vary": None, "input": None, "ignore": []},
    ),
    "safe_speed": Call(
        percuss.safe_speed, {"model": ARM, "contact": TOOL, "region": "chest", "conditions": None, **LIMITS, **ROWS}
    ),
    "reports.safe_speed_directions": Call(
        percuss.reports.safe_speed_directions,
        {"model": ARM, "contact": TOOL, "region": "chest", "directions": [[0, 1, 0]], "conditions": None, "worst": False, **LIMITS},
    ),
    "suspension.kinematics": Call(
        percuss.suspension.kinematics,
        {name: parameter.default for name, parameter in inspect.signature(percuss.suspension.kinematics).parameters.items()}
        | {"model": CORNER, "wheel_travel": [0.0, 0.01]},
    ),
    "study.ask": Call(percuss.study.ask, {"model": ARM, "request": {"contact": {"link": "tool", "point": [0, 0, 0], "normal": [1, 0, 0]}}}),
    "study.run": Call(percuss.study.run, {"path": STUDY}),
    "study.starting": Call(percuss.study.starting, {"model": BAR, "path": "four_bar.urdf"}),
    "sweep": Call(
        percuss.sweep,
        {"model": ARM, "contact": TOOL, "q": Q[:4], "joints": None, "base_pose": None, "other_assembly": False, "points": POINTS[:4],
         "normals": POINTS[:4], "gradient": True, "inverse_operational_inertia": True, "ignore": [], "nan": "refuse", "threads": 1,
         "progress": None},
    ),
    "impacts": Call(
        percuss.impacts,
        {"model": ARM, "contacts": [TOOL], "state": STATE, "restitution": 0.5, "law": "newton", "reactions": True, "impact_map": False,
         "threads": 1, "progress": None},
    ),
    "contact_law.friction_thresholds": Call(
        percuss.contact_law.friction_thresholds,
        {"model": ARM, "contact": TOOL, "q": Q[:2], "base_pose": None, "threads": 1, "progress": None},
    ),
    "safe_speeds": Call(percuss.safe_speeds, {"mass": [1.0, 2.0], "region": "chest", **{name: LIMITS[name] for name in list(LIMITS)[:5]}}),
    "converters.position_gradient": Call(percuss.converters.position_gradient, {"model": ARM, "q": Q[:1], "gradient": np.ones((1, 6))}),
    "effective_mass": Call(percuss.effective_mass, MATRICES),
    "effective_masses": Call(percuss.effective_masses, {**MATRICES, "M": np.stack([MASS, MASS]), "A": None}),
    "Conditions": Call(
        conditions_of,
        {field.name: getattr(percuss.Conditions(), field.name) for field in dataclasses.fields(percuss.Conditions)},
    ),
    "contact_law.Damping": Call(
        damping_of, {field.name: getattr(DAMPING, field.name) for field in dataclasses.fields(percuss.contact_law.Damping)}
    ),
    "study.Design": Call(design_of, {"name": "a", "model": ARM, "contact": TOOL, "conditions": None}),
    "Contact": Call(
        lambda **given: POSE.respond(percuss.Contact(**given)),
        {"link": "tool", "point": [0.08, 0, 0], "normal": [0, 1, 0], "against": "forearm", "toward": None, "normal_frame": "link",
         "turning": False, "cable": False},
    ),
    "Contact.about_axis": Call(
        lambda **given: POSE.respond(percuss.Contact.about_axis(**given)),
        {"link": "tool", "axis": [0, 0, 1], "against": "forearm", "axis_frame": "link"},
    ),
    "Model.contact": Call(ARM.contact, {"name": "elbow:upper"}),
    "Model.changed": Call(
        ARM.changed,
        {"link_mass": {"tool": 1.0}, "link_com": {"tool": [0, 0, 0]}, "link_inertia": {"tool": [1e-3, 1e-3, 1e-3]}, "move": {}, "shape_density": None,
         "total_mass": None},
    ),
    "Model.with_bush": Call(
        ARM.with_bush,
        {"name": "rubber", "link": "tool", "stiffness": [100.0, 100.0, 50.0, 1e6, 1e6, 1e5], "against": "world", "at": [0.0, 0.0, 0.0],
         "axis": [0.0, 0.0, 1.0], "x_axis": [1.0, 0.0, 0.0], "damping": [0.0] * 6, "loss_factor": 0.1, "dynamic_factor": 1.2,
         "preload": [0.0] * 6, "replaces": [], "rigid": [False] * 6},
    ),
    "Model.to_urdf": Call(ARM.to_urdf, {}),
    "Model.to_mjcf": Call(ARM.to_mjcf, {}),
    "Model.to_sdf": Call(ARM.to_sdf, {}),
    "Model.system": Call(
        ARM.system,
        {"base": "fixed", "lock": ["yaw"], "armature": {"elbow": 0.1}, "hold": [("tool", [0, 0, 0], [0, 0, 1])]},
    ),
    "Model.assemble": Call(BAR.assemble, {"guess": {}}),
    "Model.pose": Call(ARM.pose, HERE),
    "System.assemble": Call(SYSTEM.assemble, {"guess": {}}),
    "System.pose": Call(SYSTEM.pose, HERE),
    "Assembly.rigid_loops": Call(ASSEMBLY.rigid_loops, {}),
    "Assembly.drawn_gaps": Call(ASSEMBLY.drawn_gaps, {}),
    "Assembly.pose": Call(ASSEMBLY.pose, {**HERE, "q": {"crank_hinge": 0.1}}),
    "Assembly.workspace": Call(
        lambda **given: ASSEMBLY.workspace(**given).effective_mass(CLOSED.positions), {"contact": COUPLER, "base_pose": None}
    ),
    "Workspace.effective_mass": Call(lambda **given: workspace().effective_mass(**given), {"q": CLOSED.positions}),
    "Pose.link_frame": Call(POSE.link_frame, {"link": "tool", "frame": None}),
    "Pose.mass_matrix": Call(POSE.mass_matrix, {}),
    "Pose.constraint_matrix": Call(POSE.constraint_matrix, {}),
    "Pose.contact_row": Call(POSE.contact_row, {"contact": TOOL}),
    "Pose.point_jacobian": Call(POSE.point_jacobian, {**PLACE, "frame": None}),
    "Pose.inverse_operational_inertia": Call(POSE.inverse_operational_inertia, {"contact": TOOL, "frame": None}),
    "Pose.contact_mobility": Call(POSE.contact_mobility, {"contact": TOOL, "frame": None}),
    "Pose.jacobian": Call(POSE.jacobian, {**PLACE, "frame": None}),
    "Pose.velocity_matrix": Call(POSE.velocity_matrix, {}),
    "Pose.base_gradient": Call(POSE.base_gradient, {"contact": TOOL, "frame": None}),
    "Pose.contact_map": Call(
        POSE.contact_map, {"link": "tool", "points": POINTS[:3], "normals": POINTS[:3], "against": None}
    ),
    "Pose.principal_masses": Call(POSE.principal_masses, {**PLACE, "against": None}),
    "Pose.effective_mass_gradient": Call(POSE.effective_mass_gradient, {"contact": TOOL}),
    "Pose.effective_mass_rate": Call(POSE.effective_mass_rate, {"contact": TOOL, "velocities": {"elbow": 1.0}, "base_twist": [0.0] * 6, "frame": None}),
    "Pose.accelerations": Call(
        POSE.accelerations,
        {"velocities": {"elbow": 1.0}, "base": [0.0] * 6, "gravity": [0, 0, -9.81], "forces": [("tool", [0, 0, 0], [0, 0, 1])],
         "frame": None},
    ),
    "Pose.advanced_along": Call(CLOSED.advanced_along, {"response": RESPONSE, "distance": 1e-4}),
    "Pose.outside_limits": Call(POSE.outside_limits, {}),
    "Pose.rank": Call(POSE.rank, {}),
    "Pose.respond": Call(POSE.respond, {"contact": TOOL, "route": "auto"}),
    "suspension.Travel": Call(percuss.suspension.Travel, {"pose": CLOSED, "link": "coupler", "point": [0, 0, 0], "direction": [0, 1, 0]}),
    "Travel.displacement": Call(TRAVEL.displacement, {"pose": CLOSED}),
    "Travel.rate": Call(TRAVEL.rate, {"pose": CLOSED, "joint": "crank_hinge"}),
    "Travel.driver": Call(TRAVEL.driver, {"pose": CLOSED, "set": []}),
    "Travel.pose": Call(TRAVEL.pose, {"start": BAR.pose(), "displacement": 0.001, "driver": None, "q": None}),
    "Accelerations.point": Call(MOVING.point, {**PLACE, "frame": None}),
    "Response.branch_limits": Call(RESPONSE.branch_limits, {}),
    "Response.point_velocity": Call(
        RESPONSE.point_velocity, {"link": "coupler", "point": [0, 0, 0], "frame": None}
    ),
    "Response.against_mass": Call(RESPONSE.against_mass, {"mass": 2.0}),
    "Sweep.to_svg": Call(SWEEP.to_svg, {}),
    "Sweep.to_dataframe": Call(SWEEP.to_dataframe, {}),
    "Sweep._parts": Call(SWEEP._parts, {}),
    "Sweep._repr_html_": Call(SWEEP._repr_html_, {}),
}  # fmt: skip


def endless() -> Iterator[int]:
    """Numbers without an end: no call may read them all."""
    number = 0
    while True:
        yield number
        number += 1


def containing_itself() -> list[Any]:
    found: list[Any] = []
    found.append(found)
    return found


#: Invalid values; some are valid for some arguments.
VALUES: dict[str, Any] = {
    "None": None, "minus one": -1, "zero": 0, "a very large integer": 10**400, "a large integer": 2**62, "NaN": float("nan"),
    "infinite": float("inf"), "minus infinity": float("-inf"), "a large number": 1e308, "a small number": 1e-308, "complex": 1j,
    "an empty text": "", "an unknown name": "no such thing", "a zero byte": "a\0b", "a surrogate": "\ud800", "a long text": "x" * 100_000,
    "bytes": b"x", "an empty list": [], "nested empty lists": [[]], "a list with NaN": [float("nan")] * 3, "two numbers": [1.0, 2.0],
    "numbers for text": [1, 2, 3], "texts": ["no such thing"], "a list with None": [None], "an empty array": np.zeros((0, 3)),
    "an array with NaN": np.full((4, 3), np.nan), "an array with infinity": np.full((4, 6), np.inf), "huge numbers": np.full((4, 6), 1e308),
    "many axes": np.zeros((1,) * 30), "an array of texts": np.array(["x", "y"]), "an array of objects": np.array([object()] * 3),
    "dates": np.zeros(3, "datetime64[s]"), "an array of complex numbers": np.ones((4, 3), complex), "an empty dict": {},
    "a dict with an unknown name": {"no such thing": 1.0}, "a dict with NaN": {"elbow": float("nan"), "tool": float("nan")},
    "a dict with text": {"elbow": "no number", "tool": "no number"}, "a dict with None": {"elbow": None, "tool": None},
    "a dict of numbers": {1: 2}, "an object": object(), "a function": len, "a class": dict, "a model": ARM, "another model": BAR,
    "another contact": COUPLER, "a pose of another model": CLOSED, "a list that contains itself": containing_itself(),
    "a set": {1.0, 2.0}, "a range": range(3), "a path that is not there": Path("/no/such/file"), "a folder": Path("/"),
    "a truth value": True, "an exception": ValueError("x"), "a tuple of texts": ("tool", "tool"),
}  # fmt: skip


def test_every_call_has_arguments() -> None:
    assert {WITHIN.get(name, name) for name in CALLS - APART} - {"results.MatrixBatch"} - set(CASES) == set(), "without arguments"
    functions = {name for name in percuss.__all__ if name not in NO_CALLS and inspect.isroutine(getattr(percuss, name))}
    assert functions - set(CASES) == set(), "without arguments"
    for name, call in CASES.items():
        target: Any = percuss
        for part in name.split("."):
            target = getattr(target, part)
        parameters = [p for p in inspect.signature(target).parameters if p != "self"]
        assert parameters == list(call.arguments), f"{name}: other arguments"


def attempts(name: str) -> Iterator[tuple[str, str, dict[str, Any]]]:
    """Argument, kind of value and arguments of each call."""
    call = CASES[name]
    for argument in call.arguments:
        for kind, value in VALUES.items():
            yield argument, kind, {**call.arguments, argument: value}
        yield argument, "an endless generator", {**call.arguments, argument: endless()}


class Endless(BaseException):
    """A call took longer than TIME."""


def stop(_signal: int, _frame: object) -> None:
    raise Endless


def faults_of(name: str) -> list[str]:
    """Calls with an exception that is no PercussError, or whose message does not name the argument, or that take too long."""
    warnings.simplefilter("ignore")
    found = []
    own_thread = threading.current_thread() is threading.main_thread()
    for argument, kind, arguments in attempts(name):
        if (argument, kind) in OWN_ERRORS:
            continue
        place = f"{name}({argument}={kind})"
        if own_thread:
            signal.signal(signal.SIGALRM, stop)
            signal.alarm(TIME)
        try:
            CASES[name].function(**arguments)
        except percuss.NoAnswerError:
            pass
        except percuss.PercussError as error:
            # The model of kinematics may be a path.
            if argument in OTHER_NAMES or (name, argument) == ("suspension.kinematics", "model") or kind in VALID_ALONE | OUT_OF_RANGE:
                continue
            if argument.lower() not in str(error).lower().replace("-", "_").replace(" ", "_"):
                found.append(f"{place}: the message does not name it: {str(error)[:300]}")
        except Endless:
            found.append(f"{place}: more than {TIME} s")
        except BaseException as error:  # noqa: BLE001 - panics are BaseExceptions
            last = traceback.extract_tb(error.__traceback__)[-1]
            found.append(f"{place}: {type(error).__name__}: {str(error)[:300]} ({Path(last.filename).name}:{last.lineno})")
        finally:
            signal.alarm(0)
    return found


def faults_in_a_thread(name: str) -> list[str]:
    with concurrent.futures.ThreadPoolExecutor(1) as pool:
        return pool.submit(faults_of, name).result()


#: Calls that are also made in another thread than the main one, where Ctrl-C cannot stop them: one in three, for the time of the test.
PLACES = [(name, faults_of) for name in CASES] + [(name, faults_in_a_thread) for name in list(CASES)[::3]]


@pytest.mark.parametrize(("name", "faults"), PLACES)
def test_invalid_arguments(name: str, faults: Callable[[str], list[str]]) -> None:
    """In a process of its own, forked from one that has used its threads; an abort is a failure of this test alone."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        context = multiprocessing.get_context("fork")
        receiver, sender = context.Pipe(duplex=False)
        child = context.Process(target=lambda: sender.send(faults(name)))
        child.start()
        sender.close()
        try:
            found = receiver.recv() if receiver.poll(5 * TIME) else ["no answer"]
        except EOFError:
            found = [f"{name}: the process ended"]
        if child.is_alive() and found == ["no answer"]:
            os.kill(child.pid or 0, signal.SIGKILL)
        child.join()
    assert not found, "\n".join(found)
