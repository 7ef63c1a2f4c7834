"""Gradients and inverse operational inertias of sweeps, against poses, differences and the masses themselves; threads and progress."""

from __future__ import annotations

import pickle

import numpy as np
import pytest
from cases import ROOT

import percuss

ARM = percuss.load(ROOT / "models/six_r_arm.urdf")
TOOL = percuss.Contact("tool", [0.08, 0.01, -0.02], [0.3, 1, -0.2])
#: Deviation from a pose: the agreement of m̄ that the kernel demands, for differences of larger terms.
POSE = 1e-8
#: Central differences with a step h: truncation h², rounding 1e-15 / h.
STEP, DIFFERENCES = 1e-5, 1e-7


def rows(model: percuss.Model, count: int, seed: int) -> np.ndarray:
    return np.random.default_rng(seed).uniform(-1, 1, (count, model.position_count))


def test_gradients_are_those_of_poses_and_of_differences() -> None:
    q = rows(ARM, 300, 1)
    swept = percuss.sweep(ARM, TOOL, q, gradient=True)
    assert swept.gradient.shape == (300, len(ARM.velocity_names))
    plain = percuss.sweep(ARM, TOOL, q)
    assert (plain.effective_mass == swept.effective_mass).all() and not hasattr(plain, "gradient")
    with pytest.raises(percuss.errors.NotComputedError, match=r"gradient was not requested; call percuss.sweep\(…, gradient=True\)"):
        print(plain.gradient)
    for row in range(0, 300, 60):
        expected = ARM.pose(q[row]).effective_mass_gradient(TOOL)
        assert expected is not None
        wanted = np.concatenate([expected[joint.name] for joint in ARM.joints if joint.kind != "fixed"])
        assert np.abs(swept.gradient[row] - wanted).max() <= POSE * np.abs(wanted).max()
    by_position = percuss.converters.position_gradient(ARM, q, swept.gradient)
    for column in range(ARM.position_count):
        step = np.zeros(ARM.position_count)
        step[column] = STEP
        masses = [percuss.sweep(ARM, TOOL, q + sign * step).effective_mass for sign in (1, -1)]
        differences = (masses[0] - masses[1]) / (2 * STEP)
        scale = np.abs(by_position).max(axis=1) + swept.effective_mass
        assert (np.abs(by_position[:, column] - differences) <= DIFFERENCES * scale).all(), column


def test_points_and_normals_per_row() -> None:
    q, random = rows(ARM, 64, 2), np.random.default_rng(3)
    points, normals = random.uniform(-0.1, 0.1, (64, 3)), random.normal(size=(64, 3))
    contact = percuss.Contact("tool", [0, 0, 0], [1, 0, 0], normal_frame="world")
    base = [0.1, 0.2, 0.3, 0.5, 0.5, -0.5, 0.5]
    swept = percuss.sweep(
        ARM, contact, q, points=points, normals=normals, base_pose=base, gradient=True, inverse_operational_inertia=True
    )
    for row in range(0, 64, 8):
        own = percuss.Contact("tool", points[row], normals[row], normal_frame="world")
        pose = ARM.pose(q[row], base_pose=base)
        expected = pose.effective_mass_gradient(own)
        assert expected is not None
        wanted = np.concatenate([expected[joint.name] for joint in ARM.joints if joint.kind != "fixed"])
        assert np.abs(swept.gradient[row] - wanted).max() <= POSE * np.abs(wanted).max()
        phi = pose.inverse_operational_inertia(own, frame="root")
        assert np.abs(swept.inverse_operational_inertia[row] - phi).max() <= POSE * np.abs(phi).max()


def test_inverse_inertias_give_the_masses() -> None:
    q = rows(ARM, 200, 4)
    contact = percuss.Contact("tool", [0.08, 0, 0], [0, 0.6, 0.8], normal_frame="world")
    swept = percuss.sweep(ARM, contact, q, inverse_operational_inertia=True)
    phi = swept.inverse_operational_inertia
    assert phi.shape == (200, 6, 6)
    normal = np.array([0, 0.6, 0.8])
    assert 1 / np.einsum("i,nij,j->n", normal, phi[:, 3:, 3:], normal) == pytest.approx(swept.effective_mass, rel=1e-9)
    again = pickle.loads(pickle.dumps(swept))
    assert (again.inverse_operational_inertia == phi).all() and not hasattr(again, "gradient")


def test_linkages_and_floating_models() -> None:
    four_bar = percuss.load(ROOT / "models/four_bar.urdf")
    contact = percuss.Contact("coupler", [0.35, 0.1, 0.0], [0.0, 1.0, 0.0])
    poses = [four_bar.pose({"crank_hinge": angle}) for angle in (0.1, 0.3, 0.5)]
    q = np.stack([pose.positions for pose in poses])
    swept = percuss.sweep(four_bar, contact, q, gradient=True)
    for pose, found in zip(poses, swept.gradient):
        rates = pose.respond(contact).joint_velocities
        expected = pose.effective_mass_rate(contact, rates)
        velocities = np.concatenate([rates[joint.name] for joint in four_bar.joints if joint.kind != "fixed"])
        assert found @ velocities == pytest.approx(expected, rel=1e-9, abs=1e-12)
    floating = ARM.system(base="floating")
    q = rows(ARM, 20, 6)
    swept = percuss.sweep(floating, TOOL, q, gradient=True)
    of_pose = floating.pose(q[3]).effective_mass_gradient(TOOL)
    assert of_pose is not None
    wanted = np.concatenate([of_pose[joint.name] for joint in ARM.joints if joint.kind != "fixed"])
    assert np.abs(swept.gradient[3] - wanted).max() <= POSE * np.abs(wanted).max()


@pytest.mark.parametrize(("name", "link", "driver"), [("four_bar.urdf", "coupler", "crank_hinge"), ("six_bar.urdf", "link_6", None)])
def test_paths_of_linkages_have_derivatives_points_and_normals(name: str, link: str, driver: str | None) -> None:
    """Driving joints in the columns, loops closed on the way: the same numbers as at the positions that the path reaches."""
    model = percuss.load(ROOT / "models" / name)
    driver = driver or model.assemble().drivers[0]
    contact = percuss.Contact(link, [0.05, 0.02, 0.0], [0.0, 1.0, 0.0])
    angles, random = np.linspace(0.4, 0.7, 700), np.random.default_rng(9)
    points = np.column_stack([random.uniform(-0.1, 0.1, (700, 2)), np.zeros(700)])
    directions = random.uniform(0, 2 * np.pi, 700)
    normals = np.column_stack([np.cos(directions), np.sin(directions), np.zeros(700)])
    wanted = {"points": points, "normals": normals, "gradient": True, "inverse_operational_inertia": True}
    path = percuss.sweep(model, contact, angles[:, None], joints=[driver], **wanted)  # type: ignore[arg-type]
    q = np.stack([model.pose({driver: angle}).positions for angle in angles])
    at = percuss.sweep(model, contact, q, **wanted)  # type: ignore[arg-type]
    assert (path.status == percuss.Status.FINITE).all() and (at.status == percuss.Status.FINITE).all()
    assert path.effective_mass == pytest.approx(at.effective_mass, rel=POSE)
    assert np.abs(path.inverse_operational_inertia - at.inverse_operational_inertia).max() <= POSE * np.abs(at.inverse_operational_inertia).max()
    # Only sums over admissible motions have a meaning: along the path, by the change of all positions.
    same = percuss.sweep(model, contact, angles[:, None], joints=[driver], gradient=True)
    plain = percuss.sweep(model, contact, angles[:, None], joints=[driver])
    assert same.effective_mass == pytest.approx(plain.effective_mass, rel=POSE)
    step = angles[1] - angles[0]
    along = np.einsum("rn,rn->r", same.gradient[1:-1], (q[2:] - q[:-2]) / (2 * step))
    differences = (plain.effective_mass[2:] - plain.effective_mass[:-2]) / (2 * step)
    # Truncation of the differences: the third derivative is of the size of m̄ over the cube of a length of about 0.1 rad.
    assert np.abs(along - differences).max() <= 1e3 * step**2 * plain.effective_mass.max()
    for threads in (1, 3):
        again = percuss.sweep(model, contact, angles[:, None], joints=[driver], threads=threads, **wanted)  # type: ignore[arg-type]
        assert (again.gradient == path.gradient).all() and (again.effective_mass == path.effective_mass).all()


def test_rows_out_of_reach_have_no_derivatives() -> None:
    model = percuss.load(ROOT / "models/six_bar.urdf")
    driver = model.assemble().drivers[0]
    contact = percuss.Contact("link_6", [-0.48, 0.36, 0], [3, 4, 0])
    rows = np.concatenate([np.linspace(0, 0.5, 9), np.deg2rad([80.0, 85.0]), [0.2]])[:, None]
    swept = percuss.sweep(model, contact, rows, joints=[driver], gradient=True, inverse_operational_inertia=True)
    assert list(swept.status) == [percuss.Status.FINITE] * 9 + [percuss.Status.NO_ANSWER] * 2 + [percuss.Status.FINITE]
    assert np.isnan(swept.gradient[9:11]).all() and np.isnan(swept.inverse_operational_inertia[9:11]).all()
    assert np.isfinite(swept.gradient[11]).all() and np.isnan(swept.effective_mass[9:11]).all()
    assert (swept.remarks[9:11] != 0).all() and swept.findings[0].message


def test_threads_change_nothing_but_the_time() -> None:
    q = rows(ARM, 5000, 7)
    expected = percuss.sweep(ARM, TOOL, q, gradient=True)
    for threads in (1, 2, 3):
        found = percuss.sweep(ARM, TOOL, q, gradient=True, threads=threads)
        assert (found.effective_mass == expected.effective_mass).all() and (found.gradient == expected.gradient).all()
    percuss.set_threads(1)
    try:
        assert (percuss.sweep(ARM, TOOL, q).effective_mass == expected.effective_mass).all()
        assert (percuss.mass(ARM, TOOL).effective_mass or 0) > 0
    finally:
        percuss.set_threads(None)
    for wrong in (0, 2000):
        with pytest.raises(percuss.InputError, match="threads"):
            percuss.sweep(ARM, TOOL, q, threads=wrong)


def test_progress_is_reported_and_may_stop_the_sweep() -> None:
    q = rows(ARM, 100_000, 8)
    seen: list[tuple[int, int]] = []
    percuss.sweep(ARM, TOOL, q, progress=lambda done, count: seen.append((done, count)))
    assert seen[-1] == (100_000, 100_000) and all(a < b for (a, _), (b, _) in zip(seen, seen[1:]))

    class Enough(Exception):
        pass

    def stop(done: int, count: int) -> None:
        raise Enough

    with pytest.raises(Enough):
        percuss.sweep(ARM, TOOL, q, progress=stop)
