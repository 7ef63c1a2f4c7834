"""One list of input rules for every entry point: invalid numbers are refused, labels are matched by name."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import pandas as pd
import pytest
from cases import ROOT

import percuss

ARM = percuss.load(ROOT / "models/six_r_arm.urdf")
LOOP = percuss.load(ROOT / "models/four_bar.urdf")
TOOL = percuss.Contact("tool", [0.08, 0, 0], [0, 1, 0])
WORLD = percuss.Contact("tool", [0.08, 0, 0], [0, 1, 0], normal_frame="world")
COUPLER = percuss.Contact("coupler", [0.35, 0.1, 0], [0, 1, 0])
HOME = ARM.pose()
JOINTS = ARM.position_names
Q = np.array([0.1, -0.2, 0.3, 0.4, -0.5, 0.6])
#: x, y, z, then w, x, y, z.
BASE = [0.1, 0.2, 0.3, 0.8, 0.6, 0.0, 0.0]

BALL = percuss.loads("""<robot name="ball"><link name="ground"/>
  <link name="body"><inertial><origin xyz="0.1 0 0.3"/><mass value="2"/>
    <inertia ixx="1" iyy="2" izz="1.5" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="ball" type="spherical"><parent link="ground"/><child link="body"/></joint></robot>""")
ON_BALL = percuss.Contact("body", [0.3, 0.1, 0.5], [1, 2, 0])


def finite(value: Any) -> float:
    """The first number of a result; fails if the result has no number."""
    if isinstance(value, percuss.results.Sweep):
        assert (value.status != percuss.Status.NO_ANSWER).all()
        return float(value.effective_mass[0])
    if isinstance(value, tuple):
        return float(value[0][0])
    if isinstance(value, (percuss.results.Response, percuss.results.MatrixResponse)):
        assert value.effective_mass is not None
        return value.effective_mass
    return float(np.ravel(np.asarray(value))[0])


@dataclass
class Entry:
    """Entry point with an argument of numbers, and a valid value of this argument."""

    call: Callable[[Any], Any]
    good: Any
    #: Names along the last axis; None if labels have no meaning.
    names: list[str] | None = None


M = np.array([[4.0, 1.0, 0.5], [1.0, 3.0, 0.2], [0.5, 0.2, 2.0]])
A = np.array([[1.0, -1.0, 0.0]])
J = np.array([1.0, 0.0, 0.3])
VECTOR = ["x", "y", "z"]
POINTS = np.array([[0.08, 0.0, 0.0], [0.0, 0.05, 0.0]])
NORMALS = np.array([[0.0, 1.0, 0.0], [0.0, 1.0, 0.1]])

ENTRIES: Mapping[str, Entry] = {
    "Model.pose": Entry(lambda q: ARM.pose(q).respond(TOOL), Q, JOINTS),
    "System.pose": Entry(lambda q: ARM.system().pose(q).respond(TOOL), Q, JOINTS),
    "Assembly.pose": Entry(lambda q: ARM.assemble().pose(q).respond(TOOL), Q, JOINTS),
    "pose, base_pose": Entry(lambda b: ARM.system().pose(base_pose=b).respond(WORLD), BASE),
    "Workspace.effective_mass": Entry(lambda q: ARM.assemble().workspace(TOOL).effective_mass(q), Q, JOINTS),
    "workspace, base_pose": Entry(
        lambda b: ARM.assemble().workspace(WORLD, base_pose=b).effective_mass(Q), BASE
    ),
    "sweep": Entry(lambda q: percuss.sweep(ARM, TOOL, q), np.array([Q, 2 * Q]), JOINTS),
    "sweep, joints": Entry(
        lambda q: percuss.sweep(ARM, TOOL, q, joints=JOINTS[:3]), np.array([Q, 2 * Q])[:, :3], JOINTS[:3]
    ),
    "sweep, path": Entry(
        lambda q: percuss.sweep(LOOP, COUPLER, q, joints=["crank_hinge"]),
        np.array([[0.1], [0.2]]),
        ["crank_hinge"],
    ),
    "sweep, base_pose": Entry(lambda b: percuss.sweep(ARM, WORLD, [Q], base_pose=b), BASE),
    "Contact, point": Entry(
        lambda p: HOME.respond(percuss.Contact("tool", p, [0, 1, 0])), [0.08, 0.0, 0.01], VECTOR
    ),
    "Contact, normal": Entry(
        lambda n: HOME.respond(percuss.Contact("tool", [0.08, 0, 0], n)), [0.0, 1.0, 0.2], VECTOR
    ),
    "Contact, toward": Entry(
        lambda p: HOME.respond(percuss.Contact("tool", [0.08, 0, 0], toward=("forearm", p))), [0.1, 1.0, 0.2], VECTOR
    ),
    "contact_map, points": Entry(lambda p: HOME.contact_map("tool", p, NORMALS), POINTS, VECTOR),
    "contact_map, normals": Entry(lambda n: HOME.contact_map("tool", POINTS, n), NORMALS, VECTOR),
    "principal_masses": Entry(
        lambda p: next((m["effective_mass"] for m in HOME.principal_masses("tool", p) or []), np.nan),
        [0.08, 0.0, 0.01],
        VECTOR,
    ),
    "point_jacobian": Entry(lambda p: HOME.point_jacobian("tool", p).sum(), [0.08, 0.0, 0.01], VECTOR),
    "point_velocity": Entry(
        lambda p: HOME.respond(TOOL).point_velocity("tool", p), [0.08, 0.0, 0.01], VECTOR
    ),
    "Travel, point": Entry(
        lambda p: percuss.suspension.Travel(HOME, "tool", p, [0, 1, 0]).point, [0.08, 0.0, 0.01], VECTOR
    ),
    "Travel, direction": Entry(
        lambda d: percuss.suspension.Travel(HOME, "tool", [0.08, 0, 0], d).direction, [0.1, 1.0, 0.2], VECTOR
    ),
    "accelerations, gravity": Entry(
        lambda g: HOME.accelerations(gravity=g).joints["elbow"], [0.3, 0.0, -9.81], VECTOR
    ),
    "accelerations, force": Entry(
        lambda f: HOME.accelerations(forces=[("tool", [0, 0, 0], f)]).joints["elbow"], [0.3, 1.0, -9.81], VECTOR
    ),
    "effective_mass, M": Entry(lambda m: percuss.effective_mass(m, J, A), M),
    "effective_mass, j": Entry(lambda j: percuss.effective_mass(M, j, A), J),
    "effective_mass, A": Entry(lambda a: percuss.effective_mass(M, J, a), A),
    "effective_mass, lengths": Entry(lambda x: percuss.effective_mass(M, J, A, lengths=x), [1.0, 2.0, 3.0]),
    "effective_masses, M": Entry(lambda m: percuss.effective_masses(m, J, A), np.array([M, 2 * M])),
    "effective_masses, j": Entry(lambda j: percuss.effective_masses(np.array([M, M]), j, A), np.array([J, 2 * J])),
    "effective_masses, A": Entry(lambda a: percuss.effective_masses(np.array([M, M]), J, a), np.array([A, A])),
}


def one(good: Any, value: Any) -> Any:
    """The array with its last number replaced."""
    array = np.array(good, dtype=object if isinstance(value, str) else None)
    array = array.astype(complex) if isinstance(value, complex) else array
    array.reshape(-1)[-1] = value
    return array


def longer(good: Any) -> Any:
    array = np.asarray(good)
    return np.concatenate([array, array[..., :1]], axis=-1)


RULES: Mapping[str, Callable[[Any], Any]] = {
    "NaN": lambda good: one(good, np.nan),
    "infinite": lambda good: one(good, np.inf),
    "minus infinity in a list": lambda good: one(good, -np.inf).tolist(),
    "NaN in single precision": lambda good: one(good, np.nan).astype(np.float32),
    "complex": lambda good: one(good, 1j),
    "text among numbers": lambda good: one(good, "x"),
    "text": lambda good: ",".join(str(x) for x in np.ravel(good)),
    "truth values": lambda good: np.asarray(good) > 0,
    "dates": lambda good: np.zeros_like(np.asarray(good), dtype="datetime64[s]"),
    "too long": longer,
    "too many axes": lambda good: np.asarray(good)[None, None],
    "nothing": lambda good: np.array([]),
    "a hidden number": lambda good: np.ma.masked_array(good, mask=one(np.zeros_like(good), 1).astype(bool)),
    "a dict in a list": lambda good: [{}],
}

#: Rules with another meaning at an entry point.
MEANT = {
    # A table with an extra row has an extra constraint.
    ("effective_mass, A", "nothing"),
}
CASES = [(e, r) for e in ENTRIES for r in RULES if (e, r) not in MEANT]


def test_the_table_is_complete() -> None:
    assert (len(ENTRIES), len(RULES), len(CASES)) == (29, 14, 29 * 14 - len(MEANT))


@pytest.mark.parametrize("entry", ENTRIES)
def test_good_numbers_are_answered(entry: str) -> None:
    found = ENTRIES[entry]
    assert np.isfinite(finite(found.call(found.good)))
    assert finite(found.call(np.asarray(found.good).tolist())) == finite(found.call(found.good))


@pytest.mark.parametrize(("entry", "rule"), CASES)
def test_numbers_that_break_a_rule_are_refused(entry: str, rule: str) -> None:
    found = ENTRIES[entry]
    with pytest.raises(percuss.InputError) as refusal:
        found.call(RULES[rule](found.good))
    words = ("expected", "has shape", "number", "masked entries; fill them", "positions are given")
    assert any(word in str(refusal.value) for word in words)


@pytest.mark.parametrize("entry", [e for e in ENTRIES if np.ndim(ENTRIES[e].good) < 3 and e != "effective_mass, M"])
def test_labels_are_matched_or_refused(entry: str) -> None:
    found = ENTRIES[entry]
    array, names = np.asarray(found.good, float), found.names
    table: Any = pd.Series if array.ndim == 1 else pd.DataFrame
    axis = "index" if array.ndim == 1 else "columns"
    plain = finite(found.call(found.good))
    # Numbered entries are in order.
    assert finite(found.call(table(array))) == plain
    unknown = [f"other {k}" for k in range(array.shape[-1])]
    with pytest.raises(percuss.InputError, match="label|names its coordinates"):
        found.call(table(array, **{axis: unknown}))
    if names is None:
        return
    for order in (range(len(names)), range(len(names))[::-1]):
        mixed = table(array[..., list(order)], **{axis: [names[k] for k in order]})
        assert finite(found.call(mixed)) == pytest.approx(plain, rel=1e-15)
    if len(names) > 1:
        with pytest.raises(percuss.InputError, match="twice|label"):
            found.call(table(array, **{axis: names[:-1] + names[:1]}))
    # Numbers from 0 in another order are labels too.
    if len(names) > 1:
        with pytest.raises(percuss.InputError, match="label"):
            found.call(table(array, **{axis: list(range(len(names)))[::-1]}))


def test_matrices_with_labels() -> None:
    names = ["a", "b", "c"]
    order = [2, 0, 1]
    mixed = [names[k] for k in order]
    mass = pd.DataFrame(M, index=names, columns=names)
    plain = percuss.effective_mass(M, J, A).effective_mass
    row = pd.Series(J, names)[mixed]
    rows = pd.DataFrame(A, columns=names)[mixed]
    assert percuss.effective_mass(mass, row, rows).effective_mass == plain
    assert percuss.effective_mass(mass, J, A).effective_mass == plain
    with pytest.raises(percuss.InputError, match="other labels on its rows"):
        percuss.effective_mass(mass.loc[mixed], row, rows)
    with pytest.raises(percuss.InputError, match="j names its coordinates and M does not"):
        percuss.effective_mass(M, row, rows)


def test_the_accuracy_follows_from_the_type() -> None:
    # The second row is a third of the first, rounded.
    rows = np.array([[1.0, -3.0], [1.0 / 3.0, -1.0]])
    mass, j = np.diag([2.0, 9.0]), np.array([1.0, 0.0])
    single = [x.astype(np.float32) for x in (mass, j, rows)]
    found = percuss.effective_mass(*single)
    assert found.rank["rank"] == 1 and found.effective_mass is not None and found.error is not None
    assert abs(found.effective_mass - 3) <= found.error and 1e-8 < found.error < 1e-4
    # Each array has its own type; a table has the types of its columns.
    of_rows = percuss.effective_mass(mass, j, pd.DataFrame(rows.astype(np.float32)))
    assert of_rows.rank["rank"] == 1
    assert percuss.effective_mass(*single, accuracy=1e-16).status == "immovable"
    whole = percuss.effective_mass(np.eye(2, dtype=int), [1, 0], np.array([[1, -1]]))
    assert whole.effective_mass == pytest.approx(2) and whole.error is not None and whole.error < 1e-13
    half = percuss.effective_mass(np.diag([0.1, 0.3]).astype(np.float16), [1.0, 1.0])
    assert half.error is not None and 1e-5 < half.error < 1e-2


def test_rows_in_any_unit() -> None:
    rows = np.array([[1.0, -1.0, 0.0], [0.0, 1.0, -1.0]])
    for scale in (1e-90, 1e-17, 1e-11, 1.0, 1e11, 1e90):
        found = percuss.effective_mass(np.eye(3), [1.0, 0.0, 0.0], rows * [[1.0], [scale]], row_noise=0.0)
        assert found.effective_mass is not None and found.error is not None
        assert abs(found.effective_mass - 3) <= found.error < 1e-11
    noise = percuss.effective_mass(np.eye(3), [1.0, 0.0, 0.0], rows * [[1.0], [1e-17]], row_noise=0.0)
    assert noise.rank["small_rows"] == [1] and any("row_noise" in remark for remark in noise.remarks)
    without = percuss.effective_mass(np.eye(3), [1.0, 0.0, 0.0], rows * [[1.0], [1e-17]])
    assert without.effective_mass == pytest.approx(2) and without.rank["small_rows"] == []


#: Rules of `dynamics` for rows of positions.
ROWS: Mapping[str, Callable[[percuss.Model, percuss.Contact, np.ndarray], Any]] = {
    "workspace": lambda model, contact, q: model.assemble().workspace(contact).effective_mass(q),
    "sweep": lambda model, contact, q: percuss.sweep(model, contact, [q]),
}


@pytest.mark.parametrize("entry", ROWS)
def test_quaternions_of_another_length_have_no_number(entry: str) -> None:
    call = ROWS[entry]
    unit = np.array([0.8, 0.0, 0.6, 0.0])
    assert np.isfinite(finite(call(BALL, ON_BALL, unit)))
    for factor in (0.5, 0.9, 1.1, 3.0):
        without_number(call, BALL, ON_BALL, factor * unit)
        with pytest.raises(percuss.InputError, match="norm"):
            BALL.pose(factor * unit)


@pytest.mark.parametrize("entry", ROWS)
def test_open_loops_have_no_number(entry: str) -> None:
    call = ROWS[entry]
    closed = LOOP.pose({"crank_hinge": 0.4}).positions
    assert np.isfinite(finite(call(LOOP, COUPLER, closed)))
    for column in range(1, len(closed)):
        open_ = closed.copy()
        open_[column] += 0.3
        without_number(call, LOOP, COUPLER, open_)


def without_number(call: Any, model: percuss.Model, contact: percuss.Contact, q: np.ndarray) -> None:
    try:
        found = call(model, contact, q)
    except percuss.PercussError:
        return
    assert isinstance(found, percuss.results.Sweep) and list(found.status) == [percuss.Status.NO_ANSWER]
    assert np.isnan(found.effective_mass).all()


def test_one_world_for_all() -> None:
    moved = ARM.pose(Q, base_pose=BASE)
    response = moved.respond(WORLD)
    plain = ARM.pose(Q).respond(WORLD)
    assert response.effective_mass != pytest.approx(plain.effective_mass, rel=1e-3)
    # The same world in a workspace and in a sweep.
    workspace = ARM.assemble().workspace(WORLD, base_pose=BASE)
    assert workspace.effective_mass(Q) == pytest.approx(response.effective_mass, rel=1e-12)
    swept = percuss.sweep(ARM, WORLD, [Q], base_pose=BASE)
    assert swept.effective_mass[0] == pytest.approx(response.effective_mass, rel=1e-12)
    named = percuss.sweep(ARM, WORLD, [Q], joints=JOINTS, base_pose=BASE)
    assert named.effective_mass[0] == pytest.approx(response.effective_mass, rel=1e-12)
    # The frame of root-link vectors is explicit: mixed with world vectors, the masses were different.
    root = moved.link_frame("tool", frame="root")
    world = moved.link_frame("tool", frame="world")
    assert np.allclose(root, ARM.pose(Q).link_frame("tool"), atol=1e-15)
    assert np.allclose(world @ [0.08, 0, 0, 1], [*response.point_world, 1])
    phi = moved.contact_mobility(WORLD, frame="world")
    wrench = np.concatenate([np.zeros(3), response.normal_world, np.zeros(3), -response.normal_world])
    assert 1 / (wrench @ phi @ wrench) == pytest.approx(response.effective_mass, rel=1e-12)
    velocity = response.point_velocity("tool", [0.08, 0, 0], frame="world")
    assert velocity is not None and velocity @ response.normal_world == pytest.approx(1)
    down = np.array([0.0, 0.0, -9.81])
    falling = moved.accelerations(gravity=down, frame="world")
    turned = world[:3, :3] @ root[:3, :3].T
    assert falling.joints["elbow"] == pytest.approx(
        ARM.pose(Q).accelerations(gravity=turned.T @ down).joints["elbow"]
    )
    jacobian = moved.point_jacobian("tool", [0.08, 0, 0], frame="world")
    assert response.normal_world @ jacobian == pytest.approx(moved.contact_row(WORLD))
    found = falling.point("tool", [0, 0, 0], frame="world")
    assert turned.T @ found == pytest.approx(falling.point("tool", [0, 0, 0], frame="root"))


@pytest.mark.parametrize(
    "call",
    [
        lambda pose: pose.link_frame("tool"),
        lambda pose: pose.point_jacobian("tool", [0, 0, 0]),
        lambda pose: pose.inverse_operational_inertia(TOOL),
        lambda pose: pose.accelerations(gravity=[0, 0, -9.81]),
        lambda pose: pose.accelerations(forces=[("tool", [0, 0, 0], [0, 0, 1])]),
        lambda pose: pose.accelerations().point("tool", [0, 0, 0]),
        lambda pose: pose.respond(TOOL).point_velocity("tool", [0, 0, 0]),
    ],
)
def test_a_frame_that_is_not_named_is_refused_where_there_are_two(call: Callable[[percuss.Pose], Any]) -> None:
    call(HOME)
    with pytest.raises(percuss.InputError, match='expected frame="root" or frame="world"'):
        call(ARM.pose(base_pose=BASE))


def test_base_poses_that_mean_nothing() -> None:
    frame = np.eye(4)
    for bad, words in [
        (frame, r"shape \(4, 4\)|number, or a list"),
        (frame[:3], "shape"),
        ([0, 0, 0, 0, 0, 0, 2.0], "norm"),
        (np.zeros(7), "norm"),
        ([0, 0, 0, 1.0], "expected 7"),
    ]:
        with pytest.raises(percuss.InputError, match=words):
            ARM.pose(base_pose=bad)  # type: ignore[arg-type]


def codes(found: list[percuss.results.Diagnostic] | None) -> list[str]:
    assert found is not None
    return [finding.code for finding in found]


def test_findings_are_those_of_the_command() -> None:
    outside = percuss.load(ROOT / "models/six_r_arm.urdf")
    limited = [joint for joint in outside.joints if joint.limits is not None]
    at = {limited[0].name: limited[0].limits[1] + 0.1} if limited and limited[0].limits else {}
    for model, contact, q in [(LOOP, COUPLER, {"crank_hinge": 0.4}), (outside, TOOL, at)]:
        report = percuss.mass(model, contact, percuss.Conditions(set=q))
        expected = [found["code"] for found in report.diagnostics if found["path"] is None]
        pose = model.pose(q)
        response = pose.respond(contact)
        assert codes(response.findings) == expected
        assert set(codes(pose.findings)) <= set(expected)
        workspace = model.assemble().workspace(contact)
        assert workspace.findings is None
        workspace.effective_mass(pose.positions)
        assert set(codes(workspace.findings)) >= {code for code in expected if code != "drivers-chosen"}
    if at:
        assert "outside-limits" in codes(outside.pose(at).respond(TOOL).findings)


def test_another_assembly_mode_is_asked_for() -> None:
    model = percuss.load(ROOT / "models/six_bar.urdf")
    contact = percuss.Contact("link_6", [-0.48, 0.36, 0], [3, 4, 0])
    driver = model.assemble().drivers[0]
    beyond = np.deg2rad([80.0, 85.0, 90.0])
    for angle in beyond:
        with pytest.raises(percuss.errors.AssemblyError, match="on another assembly mode"):
            model.pose({driver: angle})
        found = model.pose({driver: angle}, other_assembly=True).respond(contact)
        assert found.effective_mass is not None
        assert "other-assembly" in codes(found.findings)
    rows = np.concatenate([np.linspace(0, 0.5, 9), beyond])[:, None]
    swept = percuss.sweep(model, contact, rows, joints=[driver])
    assert (swept.status[:9] == percuss.Status.FINITE).all() and (swept.status[9:] == percuss.Status.NO_ANSWER).all()


def test_paths_are_the_same_to_the_last_bit() -> None:
    for model, contact, drivers in [
        (LOOP, COUPLER, ["crank_hinge"]),
        (
            percuss.load(ROOT / "models/double_wishbone.urdf"),
            percuss.Contact("wheel_centre", [0, 0, 0], [0, 0, -1]),
            None,
        ),
    ]:
        names = drivers or model.assemble().drivers
        angles = np.linspace(0, 0.1, 6000)[:, None] * np.ones(len(names))
        first = percuss.sweep(model, contact, angles, joints=names)
        for _ in range(3):
            again = percuss.sweep(model, contact, angles, joints=names)
            assert np.array_equal(again.effective_mass, first.effective_mass)
            assert np.array_equal(again.error, first.error, equal_nan=True)


def test_a_mass_alone_has_the_parameters_of_loops() -> None:
    asked = percuss.contact_law.Damping(restitution=0.2, stiffness=1e5, speed=0.05, tools=["mujoco"])
    found = percuss.contact_law.damp(68.0, asked).exports["mujoco"]
    assert "equality_solref" in str(found) and "<equality" in str(found)
    of_loop = percuss.contact_law.damp_contact(LOOP, COUPLER, asked).exports["mujoco"]
    assert "<equality" in str(of_loop)
    tree = percuss.contact_law.Damping(restitution=0.2, stiffness=1e5, speed=0.05, tools=["mujoco"], closed_loops=False)
    assert "<equality" not in str(percuss.contact_law.damp(68.0, tree).exports["mujoco"])
