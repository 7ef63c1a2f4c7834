"""One contact at many configurations: arrays of every layout, linkages by their drivers, Ctrl-C, threads."""

from __future__ import annotations

import copy
import os
import pickle
import re
import signal
import subprocess
import sys
import textwrap
import threading
import time
from collections.abc import Callable

import numpy as np
import pytest
from cases import CASES, ROOT, Case
from numpy.typing import NDArray

import percuss

PLAIN = [c for c in CASES if not c.conditions.lock and c.conditions.against_mass is None and c.conditions.base == "fixed"]


def poses(case: Case, count: int = 40) -> NDArray[np.float64]:
    """Closed configurations near the stated configuration."""
    pose = case.pose()
    assembly = percuss.load(case.path).assemble()
    random, rows = np.random.default_rng(1), []
    for _ in range(count):
        q = pose.positions + random.uniform(-0.03, 0.03, pose.positions.size)
        for joint in assembly.model.joints:
            first, last = joint.positions
            if joint.kind in ("spherical", "floating"):
                q[last - 4 : last] /= np.linalg.norm(q[last - 4 : last])
        rows.append(assembly.pose(q).positions)
    return np.array(rows)


@pytest.mark.parametrize("case", PLAIN, ids=str)
def test_a_sweep_answers_as_poses_do(case: Case) -> None:
    model = percuss.load(case.path)
    q = poses(case)
    swept = percuss.sweep(model.assemble(), case.contact, q)
    assert len(swept) == len(q) and (swept.status == percuss.Status.FINITE).all()
    alone = [model.pose(row).respond(case.contact).effective_mass for row in q]
    assert swept.effective_mass == pytest.approx(alone, rel=1e-9)
    workspace = model.assemble().workspace(case.contact)
    assert workspace.status is None
    assert [workspace.effective_mass(row) for row in q] == list(swept.effective_mass)
    assert workspace.status == "finite"


@pytest.mark.parametrize("case", PLAIN, ids=str)
def test_points_and_normals_of_rows(case: Case) -> None:
    model = percuss.load(case.path)
    q, random = poses(case), np.random.default_rng(5)
    points, normals = random.uniform(-0.1, 0.1, (2, len(q), 3))
    contact = percuss.Contact(case.contact.link, [0, 0, 0], [1, 0, 0], against=case.contact.against)
    swept = percuss.sweep(model.assemble(), contact, q, points=points, normals=normals)
    for row, answer, status in zip(range(len(q)), swept.effective_mass, swept.status, strict=True):
        own = percuss.Contact(contact.link, points[row], normals[row], against=contact.against)
        alone = model.pose(q[row]).respond(own)
        assert status == {"finite": percuss.Status.FINITE, "immovable": percuss.Status.IMMOVABLE, "massless": percuss.Status.MASSLESS}[alone.status]
        if alone.effective_mass is not None:
            assert answer == pytest.approx(alone.effective_mass, rel=1e-9)
    only_points = percuss.sweep(model.assemble(), contact, q, points=points)
    ones = np.tile([1.0, 0.0, 0.0], (len(q), 1))
    both = percuss.sweep(model.assemble(), contact, q, points=points, normals=ones)
    assert np.array_equal(only_points.effective_mass, both.effective_mass, equal_nan=True)


def test_base_poses_of_rows() -> None:
    model = percuss.load(ROOT / "models/six_r_arm.urdf")
    system, random = model.system(base="floating"), np.random.default_rng(6)
    q = random.uniform(-1, 1, (20, model.position_count))
    base = random.normal(size=(20, 7))
    base[:, 3:] /= np.linalg.norm(base[:, 3:], axis=1, keepdims=True)
    contact = percuss.Contact("tool", [0.08, 0, 0], [0, 0, 1], normal_frame="world")
    swept = percuss.sweep(system, contact, q, base_pose=base)
    alone = [system.pose(row, base_pose=at).respond(contact).effective_mass for row, at in zip(q, base, strict=True)]
    assert swept.effective_mass == pytest.approx(alone, rel=1e-11)
    same_base = percuss.sweep(system, contact, q, base_pose=base[3])
    assert (swept.remarks == same_base.remarks).all() and same_base.effective_mass[3] == pytest.approx(alone[3], rel=1e-11)
    normals = random.normal(size=(20, 3))
    turned = percuss.sweep(system, contact, q, base_pose=base, normals=normals)
    one = percuss.Contact("tool", [0.08, 0, 0], normals[3], normal_frame="world")
    assert turned.effective_mass[3] == pytest.approx(system.pose(q[3], base_pose=base[3]).respond(one).effective_mass, rel=1e-11)
    fixed = percuss.sweep(system, contact, q, base_pose=base[3], normals=normals)
    assert fixed.effective_mass[3] == pytest.approx(turned.effective_mass[3], rel=1e-12)
    moment = percuss.Contact.about_axis("tool", [0, 0, 1], axis_frame="world")
    about = percuss.sweep(system, moment, q, base_pose=base)
    alone = [system.pose(row, base_pose=at).respond(moment).effective_mass for row, at in zip(q, base, strict=True)]
    assert about.effective_mass == pytest.approx(alone, rel=1e-11)


def test_wrong_points_and_normals() -> None:
    model = percuss.load(ROOT / "models/six_r_arm.urdf")
    contact = percuss.Contact("tool", [0.08, 0, 0], [0, 0, 1])
    q, three = np.zeros((4, model.position_count)), np.ones((4, 3))
    bad = three.copy()
    bad[2, 1] = np.nan
    with pytest.raises(percuss.InputError, match=r"points\[2, 1\] is NaN"):
        percuss.sweep(model, contact, q, points=bad)
    with pytest.raises(percuss.InputError, match=r"normals\[1\] has no length"):
        percuss.sweep(model, contact, q, normals=three * np.array([[1], [0], [1], [1]]))
    with pytest.raises(percuss.InputError, match=r"normals has shape \(3, 3\); expected \(4, 3\)"):
        percuss.sweep(model, contact, q, normals=three[:3])
    with pytest.raises(percuss.InputError, match=r"base_pose has shape \(3, 7\)"):
        percuss.sweep(model, contact, q, base_pose=np.ones((3, 7)))
    toward = percuss.Contact("tool", [0.08, 0, 0], toward=("tool", [1, 0, 0]))
    with pytest.raises(percuss.InputError, match="toward"):
        percuss.sweep(model, toward, q, points=three)
    loops = percuss.load(ROOT / "models/four_bar.urdf")
    hit = percuss.Contact("coupler", [0.35, 0.1, 0], [0, 1, 0])
    with pytest.raises(percuss.InputError, match=r"normals has shape \(2, 3\); expected \(1, 3\)"):
        percuss.sweep(loops, hit, [[0.1]], joints=["crank_hinge"], normals=[[0, 1, 0]] * 2)


LAYOUTS: dict[str, Callable[[NDArray[np.float64]], object]] = {
    "fortran": np.asfortranarray,
    "every other row": lambda q: np.repeat(q, 2, axis=0)[::2],
    "columns of a wider array": lambda q: np.hstack([q, q])[:, : q.shape[1]],
    "backwards twice": lambda q: q[::-1].copy()[::-1],
    "big endian": lambda q: q.astype(">f8"),
    "list": lambda q: q.tolist(),
    "read only": lambda q: np.frombuffer(q.tobytes()).reshape(q.shape),
}


@pytest.mark.parametrize("layout", LAYOUTS)
@pytest.mark.parametrize("name", ["six_r_arm-tool", "four_bar-coupler", "rocker_bogie-left_front"])
def test_layouts_make_no_difference(layout: str, name: str) -> None:
    case = next(c for c in PLAIN if str(c) == name)
    q = np.tile(poses(case, 30), (70, 1))
    model = percuss.load(case.path)
    plain = percuss.sweep(model, case.contact, q)
    other = percuss.sweep(model, case.contact, LAYOUTS[layout](q))  # type: ignore[arg-type]
    assert np.array_equal(plain.effective_mass, other.effective_mass)
    assert np.array_equal(plain.error, other.error, equal_nan=True) and np.array_equal(plain.status, other.status)


def test_the_caller_keeps_his_array() -> None:
    case = PLAIN[0]
    q = poses(case)
    before = q.copy()
    q.flags.writeable = False
    percuss.sweep(percuss.load(case.path), case.contact, q)
    assert np.array_equal(q, before)


@pytest.mark.parametrize(
    ("model", "contact", "drivers", "span"),
    [
        ("four_bar", percuss.Contact("coupler", [0.35, 0.1, 0], [0, 1, 0]), ["crank_hinge"], 0.5),
        ("slider_crank", percuss.Contact("slider", [0, 0, 0], [1, 0, 0]), None, 0.5),
        ("six_bar", percuss.Contact("link_6", [-0.48, 0.36, 0], [3, 4, 0]), None, 0.1),
        ("double_wishbone", percuss.Contact("wheel_centre", [0, 0, 0], [0, 0, -1]), None, 0.1),
        ("six_r_arm", percuss.Contact("tool", [0.08, 0, 0], [0, 1, 0]), None, 1.0),
    ],
)
def test_drivers_alone(model: str, contact: percuss.Contact, drivers: list[str] | None, span: float) -> None:
    found = percuss.load(ROOT / f"models/{model}.urdf")
    if drivers is None:
        bound = found.assemble().drivers
        drivers = bound or [joint.name for joint in found.joints if joint.kind != "fixed"]
    steps = np.linspace(0, span, 300)
    q = np.outer(steps, np.linspace(1, 0.5, len(drivers)))
    swept = percuss.sweep(found, contact, q, joints=drivers)
    assert (swept.status == percuss.Status.FINITE).all()
    report = [found.pose(dict(zip(drivers, row))).respond(contact).effective_mass for row in q[::23]]
    assert swept.effective_mass[::23] == pytest.approx(report, rel=1e-8)
    if len(drivers) == 1:
        rows = percuss.reports.sweep_report(found, contact, vary=(drivers[0], 0.0, span, 300)).rows
        assert [row["effective_mass"] for row in rows] == pytest.approx(list(swept.effective_mass), rel=1e-8)
    assert np.array_equal(
        percuss.sweep(found, contact, np.asfortranarray(q), joints=drivers).effective_mass, swept.effective_mass
    )


def test_rows_out_of_reach_have_no_answer_and_the_path_goes_on() -> None:
    model = percuss.load(ROOT / "models/double_wishbone.urdf")
    contact = percuss.Contact("wheel_centre", [0, 0, 0], [0, 0, -1])
    driver = model.assemble().drivers[0]
    there = np.concatenate([np.linspace(0, 0.1, 50), [3.0, -3.0], np.linspace(0.1, 0, 50)])[:, None]
    drivers = [driver]
    swept = percuss.sweep(model, contact, there, joints=drivers)
    assert list(swept.status[50:52]) == [percuss.Status.NO_ANSWER] * 2 and np.isnan(swept.effective_mass[50:52]).all()
    ok = np.delete(swept.effective_mass, [50, 51])
    assert ok[:50] == pytest.approx(ok[50:][::-1], rel=1e-8)


def test_mimics_are_not_read() -> None:
    text = """<robot name="pair"><link name="ground"/>
      <link name="a"><inertial><mass value="2"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
      <link name="b"><inertial><mass value="3"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
      <joint name="first" type="continuous"><parent link="ground"/><child link="a"/><axis xyz="0 1 0"/></joint>
      <joint name="second" type="continuous"><parent link="a"/><child link="b"/><origin xyz="1 0 0"/><axis xyz="0 1 0"/>
        <mimic joint="first" multiplier="-2"/></joint></robot>"""
    model = percuss.loads(text)
    contact = percuss.Contact("b", [0.5, 0, 0], [0, 0, 1])
    angles = np.linspace(-1, 1, 50)
    q = np.column_stack([angles, np.full(50, 9.0)])
    swept = percuss.sweep(model, contact, q)
    by_name = percuss.sweep(model, contact, angles[:, None], joints=["first"])
    assert np.array_equal(swept.effective_mass, by_name.effective_mass)
    assert swept.effective_mass[7] == pytest.approx(
        model.pose({"first": angles[7]}).respond(contact).effective_mass
    )
    assert model.joints[1].mimics == "first"
    with pytest.raises(percuss.InputError, match="first"):
        percuss.sweep(model, contact, q, joints=["first", "second"])


def test_outcomes_in_arrays() -> None:
    model = percuss.load(ROOT / "models/physical_pendulum.urdf")
    contact = percuss.Contact("body", [0, 0, -0.5], [1, 0, 0], normal_frame="world")
    swept = percuss.sweep(model, contact, [[0.0], [np.pi / 2], [0.3]])
    assert list(swept.status) == [percuss.Status.FINITE, percuss.Status.IMMOVABLE, percuss.Status.FINITE]
    assert np.isnan(swept.effective_mass[1]) and swept.effective_mass[0] == pytest.approx(2.2)
    assert swept.effective_mass.dtype == swept.error.dtype == np.float64 and swept.status.dtype == np.uint8
    assert "3 configurations, 2 finite" in repr(swept)
    picture = swept._repr_html_()
    assert "<svg" in picture and "kg" in picture and "&lt;Sweep" in picture
    empty = percuss.sweep(model, contact, np.empty((0, 1)))
    assert len(empty) == 0 and "0 configurations" in repr(empty)
    workspace = model.assemble().workspace(contact)
    assert workspace.effective_mass([np.pi / 2]) is None and workspace.status == "immovable"


@pytest.mark.parametrize(
    ("q", "joints", "words"),
    [
        ([1.0, 2.0], None, r"q has shape \(2,\)"),
        ([[1.0, 2.0]], None, r"q has shape \(1, 2\); expected 6 columns"),
        (np.zeros((2, 6), complex), None, "complex128"),
        (np.array([["a"]]), None, "expected real numbers"),
        ([[1.0], [2.0, 3.0]], None, "no array of numbers"),
        ([[0.0] * 6, [0, 0, 0, np.nan, 0, 0]], None, r"q\[1, 3\] is NaN"),
        (np.asfortranarray([[0.0] * 6, [0, 0, 0, 0, np.inf, 0]]), None, r"q\[1, 4\] is inf"),
        (np.repeat([[0.0] * 6, [0, 0, np.nan, 0, 0, 0]], 2, axis=0)[::2], None, r"q\[1, 2\] is NaN"),
        ([[0.0, np.nan]], ["yaw", "shoulder"], r"q\[0, 1\] is NaN"),
        ([[0.0]], ["yaw", "shoulder"], "joints names 2 columns"),
        ([[0.0]], ["yaw_"], "yaw"),
        ([[0.0, 0.0]], ["yaw", "yaw"], "set twice"),
        ([[0.0]], "yaw", "joints is 'yaw'; expected a list of names"),
        (np.zeros((6, 9)), None, r"q has shape \(6, 9\).*of its transpose, q.T, there are as many"),
        ("0,0,0,0,0,0", None, "q is the text '0,0,0,0,0,0'; expected numbers"),
        (np.ma.masked_array(np.zeros((2, 6)), mask=np.eye(2, 6, dtype=bool)), None, "q has masked entries"),
    ],
)
def test_arrays_that_mean_nothing(q: object, joints: list[str] | str | None, words: str) -> None:
    model = percuss.load(ROOT / "models/six_r_arm.urdf")
    with pytest.raises(percuss.InputError, match=words):
        percuss.sweep(model, percuss.Contact("tool", [0.08, 0, 0], [0, 1, 0]), q, joints=joints)  # type: ignore[arg-type]


def test_a_mask_that_hides_nothing_is_none() -> None:
    model, contact = percuss.load(ROOT / "models/six_r_arm.urdf"), percuss.Contact("tool", [0.08, 0, 0], [0, 1, 0])
    plain = percuss.sweep(model, contact, np.zeros((2, 6)))
    masked = np.ma.masked_array(np.zeros((2, 6)), mask=False)
    assert np.array_equal(percuss.sweep(model, contact, masked).effective_mass, plain.effective_mass)


def test_what_no_sweep_goes_over() -> None:
    contact = percuss.Contact("tool", [0.08, 0, 0], [0, 1, 0])
    with pytest.raises(TypeError, match=r"model is 'arm.urdf' \(str\); expected a Model, as percuss.load reads it"):
        percuss.sweep("arm.urdf", contact, np.zeros((2, 6)))  # type: ignore[arg-type]


def test_a_sweep_comes_from_another_process() -> None:
    model, contact = percuss.load(ROOT / "models/six_r_arm.urdf"), percuss.Contact("tool", [0.08, 0, 0], [0, 1, 0])
    swept = percuss.sweep(model, contact, np.random.default_rng(0).uniform(-1, 1, (9, 6)))
    for found in (pickle.loads(pickle.dumps(swept)), copy.deepcopy(swept)):
        assert repr(found) == repr(swept) and found.to_svg() == swept.to_svg()
        for name in ("effective_mass", "error", "status", "remarks"):
            assert np.array_equal(getattr(found, name), getattr(swept, name))


def codes(swept: percuss.results.Sweep) -> list[str]:
    return sorted(finding.code for finding in swept.findings)


def test_remarks_are_those_of_the_c_interface() -> None:
    header = (ROOT / "crates/capi/include/percuss.h").read_text()
    in_c = {name: int(bits) for name, bits in re.findall(r"#define PERCUSS_REMARK_(\w+) (\d+)", header)}
    assert len(in_c) == 24
    assert {flag.name: flag.value for flag in percuss.RemarkFlags} == in_c


def test_every_row_of_a_path_has_its_findings() -> None:
    model = percuss.load(ROOT / "models/double_wishbone.urdf")
    contact = percuss.Contact("wheel_centre", [0, 0, 0], [0, 0, -1])
    driver = model.assemble().drivers[0]
    there = np.concatenate([np.linspace(0, 0.1, 50), [3.0, -3.0], np.linspace(0.1, 0, 50)])[:, None]
    swept = percuss.sweep(model, contact, there, joints=[driver])
    assert swept.remarks.dtype == np.uint32 and len(swept.remarks) == len(swept)
    missing = swept.remarks & percuss.RemarkFlags.NO_ANSWER != 0
    assert np.array_equal(missing, swept.status == percuss.Status.NO_ANSWER) and missing.sum() == 2
    told = next(finding for finding in swept.findings if finding.code == "no-answer")
    assert told.severity == "warning" and told.message.endswith("(row 50, and 1 more)")
    assert "the pose does not exist, or" not in told.message
    copied = pickle.loads(pickle.dumps(swept))
    assert [str(f) for f in copied.findings] == [str(f) for f in swept.findings]


def test_limits_are_found_on_a_path_and_a_wide_gap_in_every_row() -> None:
    text = (ROOT / "models/four_bar.urdf").read_text()
    contact = percuss.Contact("coupler", [0.35, 0.1, 0], [0, 1, 0])
    plain = percuss.loads(text)
    angles = np.linspace(0, 0.4, 41)[:, None]
    path = percuss.sweep(plain, contact, angles, joints=["crank_hinge"])
    assert not path.remarks.any() and path.findings == []
    q = np.array([plain.pose({"crank_hinge": angle}).positions for angle in angles[:, 0]])
    whole = percuss.sweep(plain, contact, q)
    assert not whole.remarks.any() and whole.findings == []

    limited = re.sub(
        r'(<joint name="crank_hinge" type=")continuous("[^>]*>)',
        r'\1revolute\2<limit lower="-1" upper="0.2005" effort="1" velocity="1"/>',
        text,
    )
    assert limited != text
    path = percuss.sweep(percuss.loads(limited), contact, angles, joints=["crank_hinge"])
    outside = path.remarks & percuss.RemarkFlags.OUTSIDE_LIMITS != 0
    assert np.array_equal(outside, angles[:, 0] > 0.2005) and 0 < outside.sum() < len(outside)
    assert codes(path) == ["outside-limits"] and "row 21" in path.findings[0].message
    report = percuss.reports.sweep_report(percuss.loads(limited), contact, vary=("crank_hinge", 0.0, 0.4, 41))
    assert "outside-limits" in [finding["code"] for finding in report.diagnostics]


def test_rows_of_trees_have_errors_and_limits() -> None:
    """Rows outside the lanes state the error of a pose; positions in degrees are outside the limits."""
    arm = percuss.load(ROOT / "models/six_r_arm.urdf")
    about = percuss.Contact.about_axis("tool", [0.3, 0.1, 1])
    q = np.random.default_rng(8).uniform(-1, 1, (50, 6))
    swept = percuss.sweep(arm, about, q)
    stated = [arm.pose(row).respond(about).error for row in q]
    assert swept.error == pytest.approx(stated, rel=0.5) and not swept.remarks.any()

    limited = percuss.loads(
        re.sub(r'type="(continuous|revolute)">', 'type="revolute"><limit lower="-3" upper="3" effort="1" velocity="1"/>',
               re.sub(r"<limit[^>]*/>", "", (ROOT / "models/six_r_arm.urdf").read_text()))
    )  # fmt: skip
    q = np.vstack([q, np.full((1, 6), 90.0)])
    for contact in (about, percuss.Contact("tool", [0.08, 0, 0], [0, 1, 0])):
        swept = percuss.sweep(limited, contact, q)
        outside = swept.remarks & percuss.RemarkFlags.OUTSIDE_LIMITS != 0
        assert outside.tolist() == [False] * 50 + [True] and codes(swept) == ["many-turns", "outside-limits"]


def test_findings_of_positions() -> None:
    model = percuss.load(ROOT / "models/four_bar.urdf")
    contact = percuss.Contact("coupler", [0.35, 0.1, 0], [0, 1, 0])
    closed = model.pose({"crank_hinge": 0.3}).positions
    swept = percuss.sweep(model, contact, [closed, closed + [0.1, 0, 0]])
    assert list(swept.remarks) == [0, percuss.RemarkFlags.OPEN_LOOPS] and codes(swept) == ["open-loops"]
    assert list(swept.status) == [percuss.Status.FINITE, percuss.Status.NO_ANSWER]

    arm = percuss.load(ROOT / "models/six_r_arm.urdf")
    world = percuss.Contact("tool", [0.08, 0, 0], [0, 1, 0], normal_frame="world")
    system = arm.system(base="floating")
    q = np.random.default_rng(3).uniform(-1, 1, (300, 6))
    lost = percuss.sweep(system, world, q)
    assert (lost.remarks & percuss.RemarkFlags.BASE_NOT_GIVEN != 0).all() and "base-not-given" in codes(lost)
    given = percuss.sweep(system, world, q, base_pose=[0, 0, 1, 1, 0, 0, 0])
    assert not (given.remarks & percuss.RemarkFlags.BASE_NOT_GIVEN).any() and "base-not-given" not in codes(given)
    assert np.array_equal(given.effective_mass, lost.effective_mass)


def test_a_nearly_immovable_row_says_so() -> None:
    model = percuss.load(ROOT / "models/physical_pendulum.urdf")
    contact = percuss.Contact("body", [0, 0, -0.5], [1, 0, 0], normal_frame="world")
    swept = percuss.sweep(model, contact, [[0.0], [np.pi / 2 - 1e-9], [0.3]])
    flags = percuss.RemarkFlags.NEARLY_IMMOVABLE | percuss.RemarkFlags.UNCERTAIN_MASS
    assert swept.remarks[1] == flags and not swept.remarks[[0, 2]].any()
    assert codes(swept) == ["nearly-immovable", "uncertain-mass"]


@pytest.mark.skipif(not hasattr(os, "fork"), reason="processes are not forked on Windows")
def test_forked_processes_have_threads_of_their_own() -> None:
    # A forked process has none of the threads of its parent and would wait for them forever.
    program = textwrap.dedent(f"""
        import multiprocessing, numpy as np, percuss
        model = percuss.load({str(ROOT / "models/six_r_arm.urdf")!r})
        contact = percuss.Contact("tool", [0.08, 0, 0], [0, 1, 0])
        q = np.random.default_rng(0).uniform(-1, 1, (5000, 6))
        def work(_):
            swept = percuss.sweep(model, contact, q)
            rows = percuss.reports.sweep_report(model, contact, random=50).rows
            masses, _, _ = percuss.effective_masses(np.broadcast_to(np.eye(3), (600, 3, 3)), np.ones(3))
            return swept, len(rows), masses.sum()
        here = work(0)
        for _ in range(2):
            with multiprocessing.get_context("fork").Pool(2) as pool:
                for there in pool.map(work, range(4)):
                    assert np.array_equal(there[0].effective_mass, here[0].effective_mass) and there[1:] == here[1:]
        print("all answered")
    """)
    # Well above the required seconds; a process that waits for threads never ends.
    ran = subprocess.run(
        [sys.executable, "-W", "ignore", "-c", program], capture_output=True, text=True, timeout=300
    )
    assert ran.stdout == "all answered\n", ran.stderr


@pytest.mark.skipif(sys.platform != "linux", reason="limits of memory end the start of threads on Linux")
def test_a_forked_process_without_threads_is_an_error() -> None:
    program = textwrap.dedent(f"""
        import os, re, resource, numpy as np, percuss
        model = percuss.load({str(ROOT / "models/six_r_arm.urdf")!r})
        contact = percuss.Contact("tool", [0.08, 0, 0], [0, 1, 0])
        q = np.zeros((2000, 6))
        child = os.fork()
        if child == 0:
            # Less than the stack of a thread is left, and no stack of an earlier thread can be used again.
            size = int(re.search(r"VmSize:\\s+(\\d+)", open("/proc/self/status").read())[1]) * 1024
            resource.setrlimit(resource.RLIMIT_AS, (size + (1 << 20), size + (1 << 20)))
            calls = [
                lambda: percuss.sweep(model, contact, q),
                lambda: percuss.reports.sweep_report(model, contact, random=5),
                lambda: percuss.mass(model, contact),
            ]
            for call in calls:
                try:
                    call()
                except RuntimeError as error:
                    assert "was forked and cannot start threads" in str(error), error
                else:
                    os._exit(3)
            os._exit(7)
        print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
    """)
    # Well above the required seconds; a process that waits for threads never ends.
    ran = subprocess.run(
        [sys.executable, "-W", "ignore", "-c", program],
        capture_output=True,
        text=True,
        timeout=120,
        env={**os.environ, "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"},
    )
    assert ran.stdout == "7\n", ran.stderr


def test_other_threads_run_meanwhile() -> None:
    model = percuss.load(ROOT / "models/six_r_arm.urdf")
    contact = percuss.Contact("tool", [0.08, 0, 0], [0, 1, 0])
    q = np.random.default_rng(0).uniform(-1, 1, (400_000, 6))
    started, counted, over = threading.Event(), 0, False

    def count() -> None:
        nonlocal counted
        started.set()
        while not over:
            counted += 1
            time.sleep(0.0005)

    thread = threading.Thread(target=count)
    thread.start()
    started.wait()
    before, portions = counted, []
    percuss.sweep(model, contact, q, progress=lambda rows, _: portions.append(rows))
    after = counted
    over = True
    thread.join()
    # Portions last 50 ms or more: with the interpreter held, one turn each.
    assert after - before > 2.5 * len(portions) > 0, (after - before, portions)


@pytest.mark.filterwarnings("ignore:Setting the strides:DeprecationWarning")
@pytest.mark.parametrize("order", ["C", "F"])
def test_a_changed_array_has_no_influence(order: str) -> None:
    """The array of the caller changes its values, shape and strides during the sweep: all results are of the values at the call."""
    model, contact = percuss.load(ROOT / "models/planar_2r.urdf"), percuss.Contact("outer", [0.3, 0, 0], [0, 1, 0])
    count = 30_000
    given = np.random.default_rng(2).uniform(-1, 1, (count, 2))
    expected = percuss.sweep(model, contact, given.copy())
    changes: list[Callable[[np.ndarray], object]] = [
        lambda q: q.fill(np.nan),
        lambda q: setattr(q, "strides", (8, 8)),
        lambda q: q.resize((5, 2), refcheck=False),
    ]
    for change in changes:
        q = np.array(given, order=order)  # type: ignore[call-overload]
        portions: list[int] = []

        def report(rows: int, _: int) -> None:
            if not portions:
                change(q)
            portions.append(rows)

        found = percuss.sweep(model, contact, q, progress=report)
        assert len(portions) > 1
        np.testing.assert_array_equal(found.effective_mass, expected.effective_mass)


@pytest.mark.parametrize("what", ["whole", "drivers", "report", "matrices"])
def test_ctrl_c_stops_it(what: str) -> None:
    program = textwrap.dedent(f"""
        import numpy as np, percuss, sys
        if {what!r} in ("whole", "matrices"):
            model = percuss.load({str(ROOT / "models/six_r_arm.urdf")!r})
            contact = percuss.Contact("tool", [0.08, 0, 0], [0, 1, 0])
            q = np.lib.stride_tricks.as_strided(np.zeros(6), (2_000_000_000, 6), (0, 8))[:100_000_000]
        else:
            model = percuss.load({str(ROOT / "models/four_bar.urdf")!r})
            contact = percuss.Contact("coupler", [0.35, 0.1, 0], [0, 1, 0])
            q = np.lib.stride_tricks.as_strided(np.zeros(1), (100_000_000, 1), (0, 8))
        print("begun", flush=True)
        try:
            if {what!r} == "whole": percuss.sweep(model, contact, q)
            if {what!r} == "drivers": percuss.sweep(model, contact, q, joints=["crank_hinge"])
            if {what!r} == "report": percuss.reports.sweep_report(model, contact, vary=("crank_hinge", 0.0, 0.5, 1_000_000))
            if {what!r} == "matrices":
                M = np.broadcast_to(np.eye(40), (50_000, 40, 40))
                percuss.effective_masses(M, np.ones(40))
        except KeyboardInterrupt:
            print("stopped")
            sys.exit(7)
        print("finished")
    """)
    run = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True)
    assert run.stdout is not None and run.stdout.readline() == "begun\n"
    time.sleep(0.4)
    os.kill(run.pid, signal.SIGINT)
    rest, _ = run.communicate(timeout=60)
    assert (run.returncode, rest) == (7, "stopped\n")
