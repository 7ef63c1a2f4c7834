"""m̄ from the matrices of an external solver."""

from __future__ import annotations

import copy
import pickle

import numpy as np
import pytest
import scipy.sparse

import percuss


def test_two_carts() -> None:
    found = percuss.effective_mass([[2.0, 0.0], [0.0, 3.0]], [1.0, 0.0], [[1.0, -1.0]])
    assert found.effective_mass == pytest.approx(5) and found.status == "finite"
    assert found.error is not None and 0 < found.error < 1e-12
    assert found.velocity == pytest.approx([1, 1]) and found.degrees_of_freedom == 1
    assert found.rank["rank"] == 1 and found.rank["is_clear"] and found.rank["redundant_rows"] == []
    assert "kg ±" in repr(found)


def test_the_three_outcomes_and_the_rank() -> None:
    held = percuss.effective_mass(np.eye(2), [1.0, 0.0], [[1.0, 0.0], [2.0, 0.0], [0.0, 0.0]])
    assert (held.status, held.effective_mass, held.error) == ("immovable", None, None)
    assert np.array_equal(held.velocity, [0, 0]) and held.degrees_of_freedom == 1
    assert held.rank["rank"] == 1 and len(held.rank["redundant_rows"]) == 2
    assert [2] in held.rank["dependent_sets"] and "immovable" in repr(held)
    free = percuss.effective_mass(np.diag([1.0, 0.0]), [0.0, 1.0])
    assert (free.status, free.effective_mass) == ("massless", None) and free.remarks
    assert percuss.effective_mass(np.diag([1.0, 0.0]), [1.0, 0.0]).effective_mass == pytest.approx(1)


def family(seed: int, n: int, m: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    random = np.random.default_rng(seed)
    root = random.normal(size=(n, n))
    return root @ root.T + 0.1 * np.eye(n), random.normal(size=n), random.normal(size=(m, n))


def reference(M: np.ndarray, j: np.ndarray, A: np.ndarray) -> float:
    """Saddle-point system, regular here."""
    n, m = len(j), len(A) + 1
    rows = np.vstack([A, j])
    saddle = np.block([[M, rows.T], [rows, np.zeros((m, m))]])
    v = np.linalg.solve(saddle, np.concatenate([np.zeros(n + m - 1), [1.0]]))[:n]
    return float(v @ M @ v)


@pytest.mark.parametrize("seed", range(12))
def test_every_form_is_the_same(seed: int) -> None:
    n, m = 3 + seed, seed % 3
    M, j, A = family(seed, n, m)
    expected = reference(M, j, A)
    plain = percuss.effective_mass(M, j, A)
    assert plain.effective_mass == pytest.approx(expected, rel=1e-9)
    assert plain.error is not None and abs(plain.effective_mass - expected) <= 100 * plain.error + 1e-10 * expected  # type: ignore[operator]
    big = np.zeros((2 * n, 3 * n))
    big[::2, ::3] = M
    wide = np.zeros((m, 2 * n))
    wide[:, ::2] = A
    others = [
        percuss.effective_mass(np.asfortranarray(M), j, np.asfortranarray(A)),
        percuss.effective_mass(big[::2, ::3], j[::-1].copy()[::-1], wide[:, ::2]),
        percuss.effective_mass(scipy.sparse.csr_matrix(M), j, scipy.sparse.coo_array(A)),
        percuss.effective_mass(M.tolist(), j.reshape(1, n), A if m else None),
    ]
    for other in others:
        assert other.effective_mass == plain.effective_mass and np.array_equal(other.velocity, plain.velocity)


def test_a_coordinate_whose_mass_is_rounding_is_massless_in_batches() -> None:
    # An entry beside the diagonal that is larger than √(M₁₁ M₂₂) allows, and a rounding of M₁₁: the coordinate has no mass.
    M = np.array([[[1.0, beside], [beside, mass]] for beside, mass in ((0.0, 1e-3), (0.0, 1e-18), (1e-15, 1e-33))])
    batch = percuss.effective_masses(M, [0.0, 1.0])
    alone = [percuss.effective_mass(one, [0.0, 1.0]).status for one in M]
    assert [percuss.Status(code).name.lower() for code in batch.status] == alone == ["finite", "finite", "massless"]


def test_batches() -> None:
    families = [family(seed, 6, 2) for seed in range(700)]
    M, j, A = (np.array(parts) for parts in zip(*families))
    masses, errors, status = percuss.effective_masses(M, j, A)
    assert masses.shape == errors.shape == status.shape == (700,) and not status.any()
    for at in (0, 300, 699):
        one = percuss.effective_mass(M[at], j[at], A[at])
        assert one.error is not None and one.effective_mass is not None
        assert abs(masses[at] - one.effective_mass) <= errors[at] + one.error and errors[at] <= 10 * one.error
    same, _, _ = percuss.effective_masses(np.asfortranarray(M), j[3], A[3])
    assert same[5] == pytest.approx(percuss.effective_mass(M[5], j[3], A[3]).effective_mass, rel=1e-12)
    backwards, _, _ = percuss.effective_masses(M[::-1], j[::-1], A[::-1])
    assert np.array_equal(backwards, masses[::-1])
    _, _, outcomes = percuss.effective_masses(
        np.array([np.eye(2), np.diag([0.0, 1.0])]), np.array([[0.0, 0.0001], [1.0, 0.0]]), [[0.0, 1.0]]
    )
    assert list(outcomes) == [percuss.Status.IMMOVABLE, percuss.Status.MASSLESS]


def test_a_batch_has_the_findings_of_its_problems() -> None:
    flags, slope = percuss.RemarkFlags, 1e-8
    M = np.array([np.eye(2), np.diag([1.0, 0.0]), np.eye(2), np.diag([1.0, 0.0]), np.eye(2)])
    j = np.array([[1.0, 0.0], [1.0, 0.0], [slope, 1.0], [0.0, 1.0], [1.0, 0.0]])
    A = np.array([[[0.0, 0.0]], [[0.0, 0.0]], [[0.0, 1.0]], [[0.0, 0.0]], [[0.0, 0.0]]])
    batch = percuss.effective_masses(M, j, A)
    assert len(batch) == 3 and batch[0] is batch.effective_mass and batch[2] is batch.status
    assert batch.remarks.dtype == np.uint32 and batch.remarks.shape == (5,)
    assert list(batch.status) == [percuss.Status.FINITE, percuss.Status.FINITE, percuss.Status.FINITE, percuss.Status.MASSLESS, percuss.Status.FINITE]
    # A problem of the batch has as many kinds of findings as alone.
    for at in range(5):
        alone = percuss.effective_mass(M[at], j[at], A[at]).remarks
        assert int(batch.remarks[at]).bit_count() == len(alone), alone
    found = {finding.code: finding for finding in batch.findings}
    assert batch.remarks[2] == flags.NEARLY_IMMOVABLE and batch.remarks[1] & flags.MASSLESS_MOTIONS
    assert found["nearly-immovable"].severity == "warning" and found["nearly-immovable"].message.endswith(" (number 2)")
    assert found["massless-motions"].severity == "note"
    assert found["massless-motions"].message.endswith(" (number 1, and 1 more)")
    for other in (copy.deepcopy(batch), pickle.loads(pickle.dumps(batch))):
        assert type(other) is percuss.results.MatrixBatch
        for copied, column in zip(other, batch):
            np.testing.assert_array_equal(copied, column)
        assert [str(finding) for finding in other.findings] == [str(finding) for finding in batch.findings]
    assert percuss.effective_masses(M[:1], j[0]).findings == []
    assert "5 problems, 4 finite" in repr(batch)


def test_small_rows_of_a_batch_are_a_finding() -> None:
    rows = np.array([[1.0, 1.0, 0.0], [0.0, 1e-17, 1e-17]])
    A = np.array([rows, np.eye(3)[:2], rows])
    batch = percuss.effective_masses(np.array([np.eye(3)] * 3), [1.0, 0.0, 0.0], A, row_noise=0)
    assert percuss.effective_mass(np.eye(3), [1.0, 0.0, 0.0], rows, row_noise=0).rank["small_rows"] == [1]
    (small,) = (finding for finding in batch.findings if finding.code == "small-rows")
    assert small.message.endswith("row_noise (number 0, and 1 more)")
    plain = percuss.effective_masses(np.array([np.eye(3)] * 3), [1.0, 0.0, 0.0], A)
    assert all(finding.code != "small-rows" for finding in plain.findings)


def test_lengths_decide_what_is_zero() -> None:
    # Rotation of a millimetre-sized part: with the default lengths, the row is below the floor.
    A = np.array([[1.0, 0.0, 0.0], [0.0, 1e-11, 0.0]])
    M, j = np.eye(3), np.array([0.0, 1.0, 1.0])
    joined = np.array([[1.0, 1.0, 0.0], [1.0, 1.0 + 1e-11, 0.0]])
    assert percuss.effective_mass(M, j, joined).rank["rank"] == 1
    # Rows without a common coordinate are decided separately.
    assert percuss.effective_mass(M, j, A).rank["rank"] == 2
    skew = np.array([[1.0, 1e-12, 0.0], [1.0, -1e-12, 0.0]])
    assert percuss.effective_mass(M, j, skew).rank["rank"] == 1
    assert percuss.effective_mass(M, j, skew, lengths=[1.0, 1e-12, 1.0]).rank["rank"] == 2
    assert percuss.effective_mass(M, j, joined, rank_floor=1e-13).rank["rank"] == 2
    loose = percuss.effective_mass(M, [1.0, 1.0, 1.0], accuracy=1e-6)
    exact = percuss.effective_mass(M, [1.0, 1.0, 1.0])
    assert loose.effective_mass == exact.effective_mass and loose.error > 1e6 * exact.error  # type: ignore[operator]


@pytest.mark.parametrize(
    ("M", "j", "A", "options", "words"),
    [
        ([1.0], [1.0], None, {}, r"M has shape \(1,\); expected \(n, n\)"),
        ([[1.0, 2.0]], [1.0], None, {}, "1×2"),
        (np.eye(2), [1.0], None, {}, "contact row|j"),
        (np.eye(2), [1.0, 0.0], np.eye(3), {}, "3"),
        ([[1.0, np.nan], [np.nan, 1.0]], [1.0, 0.0], None, {}, "NaN"),
        ([[1.0, 0.5], [0.0, 1.0]], [1.0, 0.0], None, {}, "symmetric"),
        (-np.eye(2), [1.0, 0.0], None, {}, "on its diagonal"),
        ([[1.0, 2.0], [2.0, 1.0]], [1.0, 0.0], None, {}, "semi-definite|negative"),
        (np.eye(2), [1.0, 0.0], None, {"lengths": [1.0]}, "length"),
        (np.eye(2), [1.0, 0.0], None, {"lengths": [1.0, -1.0]}, "length"),
        (np.eye(2), [1.0, 0.0], None, {"rank_floor": 2.0}, "floor"),
        (np.eye(2), [1.0, 0.0], None, {"accuracy": 1.0}, "accura"),
        (np.array([["x"]]), [1.0], None, {}, "real numbers"),
        (np.eye(2, dtype=complex), [1.0, 0.0], None, {}, "complex128"),
        (np.eye(2, dtype=bool), [1.0, 0.0], None, {}, "bool"),
        (np.zeros((2, 2, 2)), [1.0, 0.0], None, {}, "effective_masses takes a batch"),
    ],
)
def test_matrices_that_mean_nothing(M, j, A, options, words) -> None:  # type: ignore[no-untyped-def]
    with pytest.raises(percuss.InputError, match=words):
        percuss.effective_mass(M, j, A, **options)


def test_a_bad_one_of_a_batch_is_named() -> None:
    M = np.array([np.eye(2)] * 400)
    M[321, 0, 1] = 5.0
    with pytest.raises(percuss.InputError, match="number 321 of the batch: .*symmetric"):
        percuss.effective_masses(M, [1.0, 0.0])
    with pytest.raises(percuss.InputError, match=r"j has shape \(3, 2\), M \(400, 2, 2\)"):
        percuss.effective_masses(M, np.ones((3, 2)))


def test_one_mass_matrix_with_many_rows() -> None:
    random = np.random.default_rng(5)
    root = random.normal(size=(6, 6))
    mass, rows, constraints = root @ root.T + np.eye(6), random.normal(size=(40, 6)), random.normal(size=(2, 6))
    for bound in (None, constraints, np.tile(constraints, (40, 1, 1))):
        shared = percuss.effective_masses(mass, rows, bound)
        stacked = percuss.effective_masses(np.tile(mass, (40, 1, 1)), rows, bound)
        assert (shared.effective_mass == stacked.effective_mass).all() and (shared.error == stacked.error).all()
    many = percuss.effective_masses(mass, rows[0], np.stack([constraints, 2 * constraints]))
    assert many.effective_mass[0] == pytest.approx(many.effective_mass[1], rel=1e-12)
    with pytest.raises(percuss.InputError, match="none has a batch axis; effective_mass"):
        percuss.effective_masses(mass, rows[0], constraints)
    with pytest.raises(percuss.InputError, match=r"A has shape \(3, 2, 6\), j \(40, 6\): their batches differ"):
        percuss.effective_masses(mass, rows, np.tile(constraints, (3, 1, 1)))
