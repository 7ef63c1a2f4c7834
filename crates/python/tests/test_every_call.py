"""Every public call in a forked and in a spawned process, in threads, and without a leak.

The calls are those of the stubs and of `percuss.__all__`: a new function, method or property without a case fails.
"""

from __future__ import annotations

import ast
import concurrent.futures
import gc
import multiprocessing
import os
import resource
import subprocess
import sys
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from cases import ROOT

import percuss

warnings.simplefilter("ignore", percuss.ModelWarning)
STUBS = Path(percuss.__file__).with_name("_percuss.pyi")
#: Functions of the extension module without a case of their own, and the public function that calls each.
WITHIN = {
    "check": "reports.check", "regions": "reports.regions", "Travel": "suspension.Travel",
    "compare": "study.compare", "compare_study": "study.compare_study", "damp": "contact_law.damp_contact",
    "damp_mass": "contact_law.damp", "extremes": "extremes", "impact": "impact", "impact_history": "contact_law.impact_history",
    "kinematics": "suspension.kinematics", "map_point_report": "reports.map_point", "map_report": "map", "mass_report": "mass",
    "matrix_findings": "results.MatrixBatch", "run_study": "study.run", "reflected_inertias": "reports.reflected_inertias", "safe_speed": "safe_speed",
    "starting_study": "study.starting", "study_schema": "study.schema", "sweep_report": "reports.sweep_report", "impact_rows": "impacts",
    "friction_rows": "contact_law.friction_thresholds",
    "ask": "study.ask", "laws": "contact_law.laws", "tools": "contact_law.tools", "load_suspension": "suspension.load",
    "suspension_template": "suspension.template", "suspension_templates": "suspension.templates",
}  # fmt: skip
#: Functions without a case: test_pickle.py tests those for pickles; run_command ends its process.
APART = {"diagnostic_of_parts", "joint_of_parts", "model_of_bytes", "sweep_of_parts", "run_command"}
#: Exceptions, constants and modules.
NO_CALLS = {
    "ArgumentTypeError", "AssemblyError", "InputError", "LoadError", "ModelWarning", "NoAnswerError", "NotComputedError", "PercussError",
    "converters", "errors", "records", "reports", "results", "Report", "MapReport", "Impacts", "SweepRow",
    # These need other programs; tests/peers/converters.py tests them.
    "from_mujoco", "from_pinocchio", "from_usd",
}  # fmt: skip

ARM = percuss.load(ROOT / "models/six_r_arm.urdf")
BAR = percuss.load(ROOT / "models/four_bar.urdf")
CORNER = percuss.load(ROOT / "models/suspensions/double-wishbone.toml")
SHAPED = percuss.load(ROOT / "models/shaped_arm.urdf")
TOOL = percuss.Contact("tool", [0.08, 0, 0], [0, 1, 0])
COUPLER = percuss.Contact("coupler", [0.35, 0.1, 0], [0, 1, 0])
SYSTEM, ASSEMBLY = ARM.system(), BAR.assemble()
POSE, CLOSED = ARM.pose({"elbow": 0.3}), BAR.pose({"crank_hinge": 0.2})
RESPONSE = CLOSED.respond(COUPLER)
TRAVEL = percuss.suspension.Travel(BAR.pose(), "coupler", [0.35, 0.1, 0], [0, 1, 0])
DAMPING = percuss.contact_law.Damping(0.5, 2e5, speed=1.0)
DESIGNS = [percuss.study.Design("a", CORNER, "bump_stop"), percuss.study.Design("b", CORNER, "spring")]
MASS, ROW = np.array([[2.0, 0.3], [0.3, 1.0]]), np.array([1.0, -0.5])
Q = np.linspace(-0.5, 0.5, 600).reshape(100, 6)
POINTS = np.tile([0.08, 0.01, 0.0], (100, 1))
STATE = percuss.State(ARM, Q[:3], velocities=Q[3:6])
SWEEP = percuss.sweep(ARM, TOOL, Q, gradient=True, inverse_operational_inertia=True)
MATRIX = percuss.effective_mass(MASS, ROW)
MOVING = POSE.accelerations({"yaw": 1.0}, gravity=[0, 0, -9.81])
STUDY = ROOT / "models/four_bar.toml"


def workspace() -> percuss.Workspace:
    made = ASSEMBLY.workspace(COUPLER)
    made.effective_mass(CLOSED.positions)
    return made


def diagnostic() -> percuss.results.Diagnostic:
    try:
        percuss.loads("<robot/>")
    except percuss.LoadError as error:
        return error.diagnostics[0]
    raise AssertionError("an empty robot was read")


#: A case for every public call.
CASES: dict[str, Callable[[], Any]] = {
    "load": lambda: percuss.load(ROOT / "models/planar_2r.urdf").name,
    "loads": lambda: percuss.loads((ROOT / "models/planar_2r.urdf").read_text()).name,
    "suspension.load": lambda: percuss.suspension.load(ROOT / "models/suspensions/double-wishbone.toml").name,
    "suspension.template": lambda: percuss.suspension.template("double-wishbone"),
    "suspension.templates": percuss.suspension.templates,
    "contact_law.laws": percuss.contact_law.laws,
    "contact_law.tools": percuss.contact_law.tools,
    "reports.regions": percuss.reports.regions,
    "set_threads": lambda: percuss.set_threads(None),
    "reports.check": lambda: percuss.reports.check(ARM).total_mass,
    "mass": lambda: percuss.mass(CORNER, "bump_stop").effective_mass,
    "reports.sweep_report": lambda: percuss.reports.sweep_report(BAR, COUPLER, vary="crank_hinge=0:0.2:5", gradient=True).rows,
    "map": lambda: percuss.map(SHAPED, links=["finger"]).links,
    "reports.map_point": lambda: percuss.reports.map_point(ARM, TOOL, 20).principal,
    "contact_law.damp": lambda: percuss.contact_law.damp(2.0, DAMPING).damping,
    "contact_law.damp_contact": lambda: percuss.contact_law.damp_contact(CORNER, "bump_stop", DAMPING).damping,
    "contact_law.damp_stop": lambda: percuss.contact_law.damp_stop(ARM, "elbow", percuss.contact_law.Damping(0.5, 1e3, speed=1.0), end="upper").damping,
    "contact_law.impact_history": lambda: percuss.contact_law.impact_history(2.0, DAMPING, 20).tolist(),
    "reports.explain": lambda: percuss.reports.explain(ARM, TOOL),
    "reports.friction_thresholds": lambda: percuss.reports.friction_thresholds(ARM, TOOL),
    "reports.reflected_inertias": lambda: percuss.reports.reflected_inertias(BAR, ["crank_hinge"]),
    "reports.tolerate": lambda: percuss.reports.tolerate(ARM, TOOL, "mass=2%", samples=20),
    "study.compare": lambda: percuss.study.compare(DESIGNS).designs,
    "study.compare_study": lambda: percuss.study.compare_study(ROOT / "models/studies/variants.toml").designs,
    "impact": lambda: percuss.impact(ARM, TOOL, 0.5, speed=1.0).impulse,
    "extremes": lambda: percuss.extremes(ARM, TOOL, ranges={"elbow": (-1.0, 1.0)}, starts=2).least,
    "safe_speed": lambda: percuss.safe_speed(ARM, TOOL, "chest", force=140.0).reflected,
    "reports.safe_speed_directions": lambda: percuss.reports.safe_speed_directions(ARM, TOOL, "chest", [[0, 1, 0]], force=140.0),
    "suspension.kinematics": lambda: percuss.suspension.kinematics(CORNER, wheel_travel=[0.0, 0.01]).values["camber"].tolist(),
    "study.ask": lambda: percuss.study.ask(ARM, {"contact": {"link": "tool", "point": [0.08, 0, 0], "normal": [0, 1, 0]}}).mass,
    "study.run": lambda: percuss.study.run(STUDY).schema,
    "study.starting": lambda: percuss.study.starting(BAR, "four_bar.urdf"),
    "study.schema": percuss.study.schema,
    "sweep": lambda: percuss.sweep(ARM, TOOL, Q, points=POINTS, gradient=True, inverse_operational_inertia=True).effective_mass.sum(),
    "converters.position_gradient": lambda: percuss.converters.position_gradient(ARM, Q[:1], np.ones((1, 6))).tolist(),
    "effective_mass": lambda: percuss.effective_mass(MASS, ROW).effective_mass,
    "effective_masses": lambda: percuss.effective_masses(np.stack([MASS, MASS]), ROW).effective_mass.tolist(),
    "results.MatrixBatch": lambda: [str(f) for f in percuss.effective_masses(np.stack([MASS, MASS]), ROW).findings],
    "impacts": lambda: percuss.impacts(ARM, TOOL, STATE, restitution=0.5).velocities.tolist(),
    "contact_law.friction_thresholds": lambda: [part.tolist() for part in percuss.contact_law.friction_thresholds(ARM, TOOL, Q[:2])],
    "safe_speeds": lambda: percuss.safe_speeds([1.0, 2.0], "chest", force=140.0).tolist(),
    "State": lambda: STATE.by_joint()["elbow"].tolist(),
    "Status": lambda: percuss.Status(2).name,
    "RemarkFlags": lambda: int(percuss.RemarkFlags.OUTSIDE_LIMITS),
    "Conditions": lambda: percuss.Conditions(base="floating").base,
    "contact_law.Damping": lambda: percuss.contact_law.Damping(0.5, 1e5).law,
    "study.Design": lambda: percuss.study.Design("a", ARM, TOOL).name,
    "Contact": lambda: percuss.Contact("tool", [0, 0, 0], [0, 0, 1]).point,
    "Contact.about_axis": lambda: percuss.Contact.about_axis("tool", [0, 0, 1]).axis,
    "Contact.axis": lambda: TOOL.axis,
    "Contact.link": lambda: TOOL.link,
    "Contact.against": lambda: TOOL.against,
    "Contact.point": lambda: TOOL.point,
    "Contact.normal": lambda: TOOL.normal,
    "Contact.toward": lambda: TOOL.toward,
    "Contact.normal_frame": lambda: TOOL.normal_frame,
    "Contact.turning": lambda: TOOL.turning,
    "Contact.cable": lambda: TOOL.cable,
    "Model.contact": lambda: CORNER.contact("spring").point,
    "Model.changed": lambda: ARM.changed(link_mass={"tool": 1.0}).total_mass,
    "Model.with_bush": lambda: ARM.with_bush("rubber", "tool", stiffness=[100, 100, 50, 1e6, 1e6, 1e5]).bushes,
    "Model.to_urdf": ARM.to_urdf,
    "Model.to_mjcf": ARM.to_mjcf,
    "Model.to_sdf": ARM.to_sdf,
    "Model.system": lambda: ARM.system(lock=["yaw"]).coordinates,
    "Model.assemble": lambda: BAR.assemble().drivers,
    "Model.pose": lambda: BAR.pose({"crank_hinge": 0.1}).positions.tolist(),
    "System": lambda: SYSTEM.coordinates,
    "System.assemble": lambda: SYSTEM.assemble().drivers,
    "System.pose": lambda: SYSTEM.pose({"elbow": 0.1}).positions.tolist(),
    "Assembly": lambda: ASSEMBLY.degrees_of_freedom,
    "Assembly.rigid_loops": ASSEMBLY.rigid_loops,
    "Assembly.drawn_gaps": ASSEMBLY.drawn_gaps,
    "Assembly.pose": lambda: ASSEMBLY.pose({"crank_hinge": 0.1}).positions.tolist(),
    "Assembly.workspace": lambda: ASSEMBLY.workspace(COUPLER).effective_mass(CLOSED.positions),
    "Workspace.effective_mass": lambda: workspace().effective_mass(CLOSED.positions),
    "Workspace.status": lambda: workspace().status,
    "Workspace.findings": lambda: [str(f) for f in workspace().findings or []],
    "Pose.link_frame": lambda: POSE.link_frame("tool").tolist(),
    "Pose.mass_matrix": lambda: POSE.mass_matrix().tolist(),
    "Pose.constraint_matrix": lambda: CLOSED.constraint_matrix().tolist(),
    "Pose.contact_row": lambda: POSE.contact_row(TOOL).tolist(),
    "Pose.point_jacobian": lambda: POSE.point_jacobian("tool", [0, 0, 0]).tolist(),
    "Pose.inverse_operational_inertia": lambda: POSE.inverse_operational_inertia(TOOL).tolist(),
    "Pose.contact_mobility": lambda: POSE.contact_mobility(TOOL).tolist(),
    "Pose.jacobian": lambda: POSE.jacobian("tool", [0, 0, 0]).tolist(),
    "Pose.velocity_matrix": lambda: POSE.velocity_matrix().tolist(),
    "Pose.base_gradient": lambda: np.asarray(POSE.base_gradient(TOOL)).tolist(),
    "Pose.contact_map": lambda: POSE.contact_map("tool", POINTS, POINTS)[0].tolist(),
    "Pose.principal_masses": lambda: [p["effective_mass"] for p in POSE.principal_masses("tool", [0, 0, 0]) or []],
    "Pose.effective_mass_gradient": lambda: sorted(POSE.effective_mass_gradient(TOOL) or {}),
    "Pose.effective_mass_rate": lambda: POSE.effective_mass_rate(TOOL, {"elbow": 1.0}),
    "Pose.accelerations": lambda: POSE.accelerations(gravity=[0, 0, -9.81]).joints["elbow"].tolist(),
    "Pose.advanced_along": lambda: CLOSED.advanced_along(RESPONSE, 1e-4) is None,
    "Pose.outside_limits": POSE.outside_limits,
    "Pose.rank": CLOSED.rank,
    "Pose.respond": lambda: POSE.respond(TOOL).effective_mass,
    "suspension.Travel": lambda: percuss.suspension.Travel(CLOSED, "coupler", [0, 0, 0], [0, 1, 0]).link,
    "Travel.displacement": lambda: TRAVEL.displacement(CLOSED),
    "Travel.rate": lambda: TRAVEL.rate(CLOSED, "crank_hinge"),
    "Travel.driver": lambda: TRAVEL.driver(CLOSED),
    "Travel.pose": lambda: TRAVEL.pose(BAR.pose(), 0.001).positions.tolist(),
    "Accelerations.joints": lambda: MOVING.joints["elbow"].tolist(),
    "Accelerations.point": lambda: MOVING.point("tool", [0, 0, 0]).tolist(),
    "Response.branch_limits": RESPONSE.branch_limits,
    "Response.point_velocity": lambda: np.asarray(RESPONSE.point_velocity("coupler", [0, 0, 0])).tolist(),
    "Response.against_mass": lambda: RESPONSE.against_mass(2.0).effective_mass,
    "Sweep.to_svg": SWEEP.to_svg,
    "Sweep.to_dataframe": lambda: str(SWEEP.to_dataframe()),
    "Sweep._parts": lambda: str(SWEEP._parts()),
    "Sweep._repr_html_": lambda: SWEEP._repr_html_(),
}
#: Objects whose properties are all read.
OBJECTS: dict[str, Any] = {
    "Model": ARM, "System": SYSTEM, "Assembly": ASSEMBLY, "Pose": CLOSED, "Response": RESPONSE, "Travel": TRAVEL,
    "MatrixResponse": MATRIX, "Sweep": SWEEP, "Joint": ARM.joints[0], "Diagnostic": diagnostic(),
}  # fmt: skip


def stub_calls() -> tuple[set[str], set[str]]:
    """Functions and methods, and properties, of the stubs."""
    calls: set[str] = set()
    properties: set[str] = set()
    for node in ast.parse(STUBS.read_text()).body:
        if isinstance(node, ast.FunctionDef):
            calls.add(node.name)
        elif isinstance(node, ast.ClassDef) and not any(getattr(base, "id", "") == "TypedDict" for base in node.bases):
            for method in node.body:
                if isinstance(method, ast.FunctionDef) and not method.name.startswith("__"):
                    is_property = any(getattr(d, "id", "") == "property" for d in method.decorator_list)
                    (properties if is_property else calls).add(f"{node.name}.{method.name}")
    return calls, properties


CALLS, PROPERTIES = stub_calls()
for owner, name in (item.split(".") for item in sorted(PROPERTIES)):
    if owner in OBJECTS:
        CASES.setdefault(f"{owner}.{name}", lambda owner=owner, name=name: str(getattr(OBJECTS[owner], name)))  # type: ignore[misc]


def test_every_public_call_has_a_case() -> None:
    assert len(CALLS) > 60 and len(PROPERTIES) > 60
    expected = {WITHIN.get(name, name) for name in CALLS - APART} | PROPERTIES
    assert expected - set(CASES) == set(), "without a case"
    public = {name for name in percuss.__all__ if name not in NO_CALLS} - {name.split(".")[0] for name in CASES}
    assert public - set(OBJECTS) == set(), "without a case"
    assert {name for name in CASES if "." not in name} <= set(percuss.__all__), "no longer public"


def outcome(name: str) -> str:
    """Result of a case as text."""
    return repr(CASES[name]())


def outcomes(names: list[str]) -> list[str]:
    return [outcome(name) for name in names]


@pytest.fixture(scope="module")
def expected() -> dict[str, str]:
    return {name: outcome(name) for name in CASES}


def test_the_same_call_has_the_same_result(expected: dict[str, str]) -> None:
    assert {name: outcome(name) for name in CASES} == expected


def test_forked(expected: dict[str, str]) -> None:
    """All calls in a fork of a process that has used its threads."""
    with warnings.catch_warnings():
        # Python warns of forks with threads.
        warnings.simplefilter("ignore")
        with multiprocessing.get_context("fork").Pool(1) as pool:
            found = pool.apply_async(outcomes, (list(CASES),)).get(timeout=60)
    assert dict(zip(CASES, found)) == expected


def test_spawned(expected: dict[str, str]) -> None:
    with concurrent.futures.ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("spawn")) as pool:
        found = pool.submit(outcomes, list(CASES)).result(timeout=120)
    assert dict(zip(CASES, found)) == expected


def test_threads(expected: dict[str, str]) -> None:
    """All calls in four threads at once, in different orders."""
    names = list(CASES)
    orders = [names[k * 31 % len(names) :] + names[: k * 31 % len(names)] for k in range(4)]
    with concurrent.futures.ThreadPoolExecutor(4) as pool:
        for order, found in zip(orders, pool.map(outcomes, orders)):
            assert dict(zip(order, found)) == expected


#: Calls of each case before the memory is measured, and while it is measured.
WARM_UP, REPETITIONS = 30, 60
#: Largest growth of all cases together, bytes: allocators keep pages; a leak of 1 kB per call in each of 100 cases is 6 MB.
GROWTH_OF_ALL = 4 << 20

LEAKS = """
import gc, sys
sys.path.insert(0, {tests!r})
from test_every_call import CASES, REPETITIONS, WARM_UP
def resident():
    gc.collect()
    return int(open("/proc/self/statm").read().split()[1]) * {page}
slow = {{"map", "compare", "compare_study", "kinematics", "Sweep._repr_html_", "load_suspension", "tolerate"}}
def run(times):
    for name, case in CASES.items():
        for _ in range(times // 10 if name in slow else times):
            case()
run(WARM_UP)
before = resident()
run(REPETITIONS)
middle = resident()
run(REPETITIONS)
print(middle - before, resident() - middle)
"""


def test_no_call_leaks() -> None:
    """Resident memory grows in both halves of the repetitions only if a call leaks memory."""
    program = LEAKS.format(tests=str(Path(__file__).parent), page=resource.getpagesize())
    ran = subprocess.run([sys.executable, "-W", "ignore", "-c", program], capture_output=True, text=True, env=os.environ, timeout=300)
    assert ran.returncode == 0, ran.stderr[-2000:]
    growths = [int(word) for word in ran.stdout.split()]
    assert min(growths) <= GROWTH_OF_ALL, growths
    gc.collect()
