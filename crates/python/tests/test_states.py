"""States: conversions, gradients with a moving root link, impacts and safe speeds in arrays. tests/peers has other programs."""

from __future__ import annotations

import pickle
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from cases import ROOT
from numpy.typing import NDArray

import percuss
from percuss.converters import Converter

ARM = percuss.load(ROOT / "models/six_r_arm.urdf")
FLOATING = ARM.system(base="floating")
POINT, NORMAL = [0.08, 0.0, 0.02], [0.3, 0.2, 1.0]
WORLD = percuss.Contact("tool", POINT, NORMAL, normal_frame="world")
AGAINST = percuss.Contact("tool", POINT, NORMAL, against=ARM.links[2], normal_frame="world")
AXIS = percuss.Contact.about_axis("tool", NORMAL, axis_frame="world")
#: Sides of both: rounding of a few hundred operations, with conditions of M up to 1e4.
ROUNDING = 1e-9
_Array = NDArray[np.float64]


def states(count: int, seed: int = 3) -> percuss.State:
    """Random states of the floating arm."""
    random = np.random.default_rng(seed)
    base = random.normal(size=(count, 7))
    base[:, 3:] /= np.linalg.norm(base[:, 3:], axis=1, keepdims=True)
    n = ARM.position_count
    q, v, twist = random.uniform(-1, 1, (count, n)), random.normal(size=(count, n)), random.normal(size=(count, 6))
    return percuss.State(ARM, q, velocities=v, base_pose=base, base_twist=twist)


def pinocchio(state: percuss.State) -> tuple[Any, _Array, _Array]:
    """Stand-in for a model of Pinocchio with a free-flyer and joints in reverse order, and its q and v: quaternions x, y, z, w; linear first."""
    names = ["universe", "root_joint", *(f"left_{name}" for name in reversed(ARM.position_names))]
    free = SimpleNamespace(idx_q=0, nq=7, idx_v=0, nv=6, shortname=lambda: "JointModelFreeFlyer")
    hinges = [SimpleNamespace(idx_q=7 + k, nq=1, idx_v=6 + k, nv=1, shortname=lambda: "JointModelRX") for k in range(ARM.position_count)]
    other = SimpleNamespace(njoints=len(names), joints=[None, free, *hinges], names=names, nq=7 + len(hinges), nv=6 + len(hinges))
    assert state.base_pose is not None and state.velocities is not None
    q = np.concatenate([state.base_pose[..., [0, 1, 2, 4, 5, 6, 3]], state.positions[..., ::-1]], axis=-1)
    v = np.concatenate([state.twist(linear_first=True), state.velocities[..., ::-1]], axis=-1)
    return other, q, v


def test_states_of_another_program_with_a_prefix() -> None:
    given = states(5)
    other, q, v = pinocchio(given)
    converter = Converter.of_pinocchio(ARM, other, prefix="left_")
    found = converter.state(q, v)
    for name in ("positions", "velocities", "base_pose", "base_twist"):
        assert np.array_equal(getattr(found, name), getattr(given, name)), name
    back = converter.of_state(found)
    assert np.array_equal(back[0], q) and back[1] is not None and np.array_equal(back[1], v)
    assert "6 joints, floating base" in repr(converter) and len(found) == 5
    with pytest.raises(percuss.InputError, match="no joint"):
        Converter.of_pinocchio(ARM, other, prefix="right_")
    joints = Converter.of_joint_state(ARM, ["left_elbow", "right_elbow"], prefix="left_")
    assert joints.state([0.3, 5.0], [1.0, 2.0]).by_joint()["elbow"].tolist() == [0.3]


def test_states_of_dicts() -> None:
    state = percuss.State(ARM, {"elbow": 0.3}, velocities={"yaw": 2.0}, base_twist=[1, 2, 3, 4, 5, 6], linear_first=True)
    assert state.velocities is not None and state.velocities[ARM.velocity_names.index("yaw")] == 2.0
    assert state.twist().tolist() == [4, 5, 6, 1, 2, 3] and state.by_joint()["elbow"].tolist() == [0.3]
    quarter = [0, 0, 0, np.sqrt(0.5), 0, 0, np.sqrt(0.5)]
    turned = percuss.State(ARM, base_pose=quarter, base_twist=[0, 1, 0, 1, 0, 0], frame="world")
    assert turned.twist() == pytest.approx([1, 0, 0, 0, -1, 0]) and turned.twist(frame="world") == pytest.approx([0, 1, 0, 1, 0, 0])
    copied = pickle.loads(pickle.dumps(state))
    assert np.array_equal(copied.positions, state.positions) and copied.model.name == ARM.name
    wrong: list[tuple[dict[str, Any], str]] = [
        ({"positions": {"elbo": 1.0}}, "no joint 'elbo'"), ({"positions": np.zeros((2, 5))}, r"positions has shape \(2, 5\)"),
        ({"positions": np.zeros((2, 6)), "velocities": np.zeros((3, 6))}, r"velocities has shape \(3, 6\); expected \(6,\) or \(2, 6\)"),
        ({"base_pose": [0, 0, 0]}, "base_pose has shape"), ({"frame": "link"}, 'expected "root" or "world"'),
    ]  # fmt: skip
    for arguments, message in wrong:
        with pytest.raises(percuss.InputError, match=message):
            percuss.State(ARM, **arguments)
    with pytest.raises(percuss.InputError, match=r"of the model .* expected one of the model"):
        percuss.load(ROOT / "models/planar_2r.urdf").pose(state)


def test_states_refuse_numbers_that_are_not_finite() -> None:
    q = np.zeros((3, ARM.position_count))
    q[1, 2] = np.nan
    wrong: list[tuple[dict[str, Any], str]] = [
        ({"positions": q}, r"positions\[1, 2\] is nan"), ({"positions": {"elbow": np.inf}}, r"positions\[\d\] is inf"),
        ({"velocities": {"elbow": np.nan}}, "velocities"), ({"base_twist": [np.nan] * 6}, r"base_twist\[0\] is nan"),
        ({"base_pose": [0, 0, 0, 0, 0, 0, 0]}, "norm 0; expected a unit quaternion"), ({"nan": "keep"}, '"refuse" or "no answer"'),
    ]  # fmt: skip
    for arguments, message in wrong:
        with pytest.raises(percuss.InputError, match=message):
            percuss.State(ARM, **arguments)
    kept = percuss.State(ARM, q, nan="no answer")
    assert percuss.sweep(ARM, WORLD, kept[1:], nan="no answer").status.tolist() == [percuss.Status.NO_ANSWER, percuss.Status.FINITE]
    with pytest.raises(percuss.InputError, match="a report takes one state"):
        percuss.mass(states(2), WORLD)


def test_names_of_locked_joints() -> None:
    """A free body has m̄ = 1/(n M⁻¹ nᵀ) with the 6×6 mass matrix of all links together."""
    heavy = ARM.changed(link_mass={"pedestal": 5.0}, link_inertia={"pedestal": [0.2, 0.3, 0.1]})
    free = heavy.system(base="floating", lock="all")
    assert free.coordinates == 6 and ARM.system(lock="elbow").coordinates == ARM.system(lock=["elbow"]).coordinates == 5
    pose = free.pose()
    row = pose.contact_row(WORLD)
    expected = 1 / (row @ np.linalg.solve(pose.mass_matrix(), row))
    assert pose.respond(WORLD).effective_mass == pytest.approx(expected, rel=1e-10)
    for lock in ("all", ["all"]):
        report = percuss.mass(heavy, WORLD, percuss.Conditions(base="floating", lock=lock), certify=True)
        assert report.effective_mass == pytest.approx(expected, rel=1e-10) and report.certificate is not None
    with pytest.raises(percuss.InputError, match="lock"):
        ARM.system(lock=3)  # type: ignore[arg-type]


def moved(state: percuss.State, h: float) -> percuss.State:
    """The states after h seconds of their velocities; a quaternion moves by its rate, to second order."""
    assert state.base_pose is not None and state.velocities is not None
    base = state.base_pose.copy()
    w, v = base[:, 3:4].copy(), base[:, 4:].copy()
    omega = state.twist()[:, :3]
    base[:, 3:4] -= h / 2 * np.sum(v * omega, axis=1, keepdims=True)
    base[:, 4:] += h / 2 * (w * omega + np.cross(v, omega))
    base[:, 3:] /= np.linalg.norm(base[:, 3:], axis=1, keepdims=True)
    base[:, :3] += h * state.twist(frame="world")[:, 3:]
    return percuss.State(ARM, state.positions + h * state.velocities, base_pose=base)


@pytest.mark.parametrize("system", [ARM, FLOATING], ids=["fixed", "floating"])
@pytest.mark.parametrize("contact", [WORLD, AXIS, AGAINST, percuss.Contact("tool", POINT, NORMAL)], ids=["world", "axis", "against", "link"])
def test_gradients_with_a_moving_root_link(system: percuss.Model | percuss.System, contact: percuss.Contact) -> None:
    """dm̄/dt of joints and root link together, against central differences, whose error is of the order h²."""
    state, h = states(8), 1e-5
    rate = np.subtract(*(percuss.sweep(system, contact, moved(state, sign * h)).effective_mass for sign in (1, -1))) / (2 * h)
    scale = np.abs(rate).max()
    of_poses = np.array([system.pose(one).effective_mass_rate(contact, one) for one in state], dtype=np.float64)
    assert np.abs(of_poses - rate).max() <= 1e-7 * scale
    swept = percuss.sweep(system, contact, state, gradient=True)
    if contact is AGAINST:
        with pytest.raises(percuss.errors.NotComputedError, match=r"Pose\.base_gradient"):
            swept.base_gradient  # noqa: B018
        return
    assert (swept.base_gradient[:, 3:] == 0).all() and swept.base_gradient.any() == (contact.normal_frame == "world")
    assert state.velocities is not None
    found = np.sum(swept.gradient * state.velocities, axis=1) + np.sum(swept.base_gradient * state.twist(), axis=1)
    assert np.abs(found - rate).max() <= 1e-7 * scale
    pose = system.pose(state[0])
    gradient = pose.base_gradient(contact, frame="world")
    assert gradient is not None
    twist = state[0].twist(frame="world")
    still = pose.effective_mass_rate(contact, {}, base_twist=twist, frame="world")
    assert still == pytest.approx(gradient @ twist, rel=1e-12)


def test_matrices_with_locks_fit_together() -> None:
    """Λ⁻¹ = J M⁻¹ Jᵀ; the columns of a gradient are those of M by the velocity matrix."""
    pose = ARM.system(base="floating", lock=["elbow"]).pose(states(1)[0])
    jacobian, phi = pose.jacobian("tool", POINT, frame="root"), pose.inverse_operational_inertia(WORLD, frame="root")
    assert jacobian.shape == (6, 11) and phi.shape == (6, 6)
    assert phi == pytest.approx(jacobian @ np.linalg.solve(pose.mass_matrix(), jacobian.T), rel=1e-8, abs=1e-8)
    assert np.array_equal(pose.contact_mobility(WORLD, frame="root")[:6, :6], phi)
    assert np.array_equal(jacobian[3:], pose.point_jacobian("tool", POINT, frame="root"))
    velocities = pose.velocity_matrix()
    assert velocities.shape == (6, 11) and not velocities[ARM.velocity_names.index("elbow")].any() and velocities.sum() == 5


def test_rows_of_a_sweep() -> None:
    pandas = pytest.importorskip("pandas")
    state = states(4)
    table = pandas.DataFrame(state.positions, columns=ARM.position_names, index=list("abcd")).assign(time="now")
    table.loc["c", "elbow"] = np.nan
    with pytest.raises(percuss.InputError, match=r"q\[2, \d\] is NaN"):
        percuss.sweep(ARM, WORLD, table, ignore=["time"])
    with pytest.raises(percuss.InputError, match='no column "speed"'):
        percuss.sweep(ARM, WORLD, table, ignore=["speed"])
    swept = percuss.sweep(ARM, WORLD, table, ignore=["time"], nan="no answer", gradient=True)
    assert swept.status.tolist() == [0, 0, percuss.Status.NO_ANSWER, 0] and np.isnan(swept.gradient[2]).all()
    found = swept.to_dataframe()
    assert found.index.tolist() == list("abcd") and found.loc["c", "NOT_FINITE"] and found.loc["c", "status"] == "NO_ANSWER"
    assert found["gradient[elbow]"].to_numpy()[:2] == pytest.approx(swept.gradient[:2, ARM.velocity_names.index("elbow")])
    row = swept[1]
    assert row.status is percuss.Status.FINITE and row.effective_mass == swept.effective_mass[1] and row.gradient is not None
    part = swept[swept.status == percuss.Status.FINITE]
    assert len(part) == 3 and part.index.tolist() == ["a", "b", "d"] and not part.findings and len(swept.findings) == 1
    assert np.array_equal(pickle.loads(pickle.dumps(part)).gradient, part.gradient)
    bar, hit = percuss.load(ROOT / "models/four_bar.urdf"), percuss.Contact("coupler", [0.35, 0.1, 0], [0, 1, 0])
    path = percuss.sweep(bar, hit, [[0.1], [np.nan], [0.2]], joints=["crank_hinge"], nan="no answer")
    assert path.status.tolist() == [0, 3, 0] and percuss.RemarkFlags(int(path.remarks[1])) == percuss.RemarkFlags.NOT_FINITE


def test_thresholds_of_friction_are_those_of_the_reports() -> None:
    state = states(6)
    found = percuss.contact_law.friction_thresholds(ARM, WORLD, state)
    assert np.isnan(found.slope).all()
    for row, one in enumerate(state):
        report = percuss.reports.friction_thresholds(ARM.pose(one), WORLD)
        assert report is not None
        assert (found.sticking[row], found.jamming[row]) == pytest.approx((report.sticking, report.jamming), rel=ROUNDING)
    bar, hit = percuss.load(ROOT / "models/four_bar.urdf"), percuss.Contact("coupler", [0.35, 0.1, 0], [0, 1, 0])
    pose = bar.pose({"crank_hinge": 0.4})
    of_bar = percuss.contact_law.friction_thresholds(bar, hit, pose.positions)
    expected = percuss.reports.friction_thresholds(pose, hit)
    assert expected is not None and np.isnan(of_bar.sticking).all()
    assert (of_bar.slope[0], of_bar.jamming[0]) == pytest.approx((expected.slope, expected.jamming), rel=ROUNDING)
    with pytest.raises(percuss.InputError, match="moment"):
        percuss.contact_law.friction_thresholds(ARM, AXIS, state)


def corners() -> list[percuss.Contact]:
    """Five points of the tool in contact with the ground: redundant."""
    points = [[0.1, 0.05, 0.0], [0.1, -0.05, 0.0], [-0.1, 0.05, 0.0], [-0.1, -0.05, 0.0], [0.0, 0.0, 0.0]]
    return [percuss.Contact("tool", point, [0.0, 0.0, -1.0]) for point in points]


def test_sticking_impacts_of_states() -> None:
    """M (u⁺ − u⁻) = Jᵀ P, u⁺ = Δ u⁻, the loss of energy, and points that rest; the law and the report agree."""
    # A tool that falls flat: no contact pulls.
    state = states(30)
    twist = state.twist()
    velocities = np.zeros_like(state.positions)
    approach = np.array([FLOATING.pose(one).link_frame("tool", frame="root")[:3, 2] for one in state])
    twist[:, :3], twist[:, 3:] = 0, -approach
    state = percuss.State(ARM, state.positions, velocities=velocities, base_pose=state.base_pose, base_twist=twist)
    found = percuss.impacts(FLOATING, corners(), state, law="sticking", impact_map=True)
    assert found.impact_map is not None and found.closing_speeds == pytest.approx(np.ones((30, 5)), rel=ROUNDING)
    landed = 0
    for k, one in enumerate(state):
        if found.status[k] != percuss.Status.FINITE or not found.sticks[k].any():
            continue
        landed += 1
        pose = FLOATING.pose(one)
        before = np.concatenate([one.twist(), velocities[k]])
        after = np.concatenate([found.base_twist[k], found.velocities[k]])
        jacobian = np.vstack([pose.jacobian("tool", contact.point, frame="world")[3:] for contact in corners()])
        mass = pose.mass_matrix()
        momentum = jacobian.T @ found.impulses[k].ravel()
        assert mass @ (after - before) == pytest.approx(momentum, abs=ROUNDING * np.abs(momentum).max())
        assert found.impact_map[k] @ before == pytest.approx(after, abs=ROUNDING * np.abs(after).max())
        loss = (before @ mass @ before - after @ mass @ after) / 2
        assert found.energy_loss[k] == pytest.approx(loss, rel=ROUNDING)
        sticking = np.repeat(found.sticks[k], 3)
        assert np.abs((jacobian @ after)[sticking]).max() <= 1e-7
    assert landed >= 5


def test_impacts_of_states_and_reports_agree() -> None:
    contact = percuss.Contact("tool", POINT, NORMAL)
    state = states(12)
    state = percuss.State(ARM, state.positions, velocities=state.velocities)
    found = percuss.impacts(ARM, contact, state, restitution=0.3, reactions=True)
    swept = percuss.sweep(ARM, contact, state)
    closing = found.closing_speeds[:, 0]
    assert found.normal_impulses[:, 0] == pytest.approx(np.where(closing > 0, 1.3 * swept.effective_mass * closing, 0), rel=ROUNDING)
    assert found.reactions is not None and (closing > 0).any() and (closing < 0).any()
    for row in np.flatnonzero(closing > 0):
        report = percuss.impact(state[row], contact, 0.3)
        after = [rate for joint in report.rates for rate in joint.after]
        assert found.velocities[row] == pytest.approx(after, rel=ROUNDING, abs=ROUNDING)
        reactions = {reaction.name: [*reaction.force, *reaction.moment] for reaction in report.reactions if reaction.place == "joint"}
        own = dict(zip((joint.name for joint in ARM.joints), found.reactions[row], strict=True))
        assert all(own[name] == pytest.approx(reaction, rel=1e-7, abs=1e-7) for name, reaction in reactions.items()) and reactions
    still = percuss.State(ARM, state.positions)
    moving = percuss.State(ARM, state.positions, velocities=state.velocities, base_twist=[0, 0, 0, 1, 0, 0])
    bar = percuss.load(ROOT / "models/four_bar.urdf")
    opens = percuss.State(bar, bar.pose({"crank_hinge": 0.4}).positions, velocities={"crank_hinge": 1.0})
    hit = percuss.Contact("coupler", [0.35, 0.1, 0], [0, 1, 0])
    wrong: list[tuple[tuple[Any, ...], dict[str, Any], str]] = [
        ((ARM, contact, still), {}, "no velocities"), ((ARM, contact, moving), {}, "the root link is fixed"),
        ((ARM, [], state), {}, "contacts is empty"), ((ARM, contact, state), {"restitution": [0.1, 0.2]}, r"restitution has shape \(2,\)"),
        ((ARM, contact, state), {"law": "sticking", "restitution": 0.1}, "contacts that stick have none"),
        ((bar, hit, opens), {}, "state 0: velocities: with these the loops open"), ((ARM, contact, state), {"impact_map": True}, "impact_map"),
    ]  # fmt: skip
    for arguments, options, message in wrong:
        with pytest.raises(percuss.InputError, match=message):
            percuss.impacts(*arguments, **options)


def test_safe_speeds_of_masses() -> None:
    contact = percuss.Contact("tool", [0.08, 0, 0], [0, 1, 0])
    swept = percuss.sweep(ARM, contact, states(6).positions)
    mass, stiffness = next((mass, stiffness) for name, _, mass, stiffness in percuss.reports.regions() if name == "chest")
    expected = 140.0 * np.sqrt((1 / mass + 1 / swept.effective_mass) / stiffness)
    assert percuss.safe_speeds(swept, "chest", force=140.0) == pytest.approx(expected, rel=1e-9)
    one = percuss.safe_speed(percuss.State(ARM, states(6).positions[2]), contact, "chest", force=140.0)
    assert percuss.safe_speeds(swept, "chest", force=140.0)[2] == pytest.approx(one.reflected.speed, rel=1e-9)
    limits = percuss.safe_speeds([[2.0, np.inf], [np.nan, 1.0]], None, momentum=3.0)
    assert limits[0].tolist() == [1.5, 0.0] and np.isnan(limits[1, 0]) and limits[1, 1] == 3.0
    with pytest.raises(percuss.InputError, match="mass number 1"):
        percuss.safe_speeds([1.0, -1.0], "chest", force=140.0)
    with pytest.raises(percuss.InputError, match="without a region there is no spring"):
        percuss.safe_speeds([1.0], None, force=140.0)
