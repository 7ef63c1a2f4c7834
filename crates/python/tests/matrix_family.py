"""Random matrix problems (M, A, j) compared with 60-digit arithmetic: no stated error is exceeded.

    python matrix_family.py [--problems 100000] [--seed 1]

A problem consists of exact numbers, rounded to the type of the arrays. The result of percuss must agree with the exact
result within the stated error. test_matrix_family.py runs a few hundred problems.
"""

# gmpy2 has no types.
# pyright: reportAttributeAccessIssue=false
from __future__ import annotations

import argparse
import sys
from collections import Counter
from dataclasses import dataclass, field
from typing import Any

import gmpy2
import numpy as np
from numpy.typing import NDArray

import percuss

gmpy2.get_context().precision = 200

#: Arrays of gmpy2.mpfr.
Exact = NDArray[Any]
TYPES = {"float64": 0.7, "float32": 0.2, "float16": 0.05, "int64": 0.05}
#: A number of the exact arithmetic below this fraction of its terms is zero: 200 bits leave 1e-60.
ZERO = gmpy2.mpfr("1e-40")


def exact(values: Any) -> Exact:
    array = np.asarray(values)
    found = np.empty(array.size, dtype=object)
    found[:] = [gmpy2.mpfr(x.item()) for x in array.ravel()]
    return found.reshape(array.shape)


@dataclass
class Problem:
    kind: str
    M: Exact
    A: Exact
    """Independent rows; A of the arrays has combinations of them too."""
    j: Exact
    arrays: tuple[NDArray[Any], NDArray[Any], NDArray[Any]]


def problem(random: np.random.Generator, number: int) -> Problem:
    kind = str(random.choice(list(TYPES), p=list(TYPES.values())))
    whole = kind == "int64"
    n = int(random.integers(1, 8))
    decades = {"float64": 18, "float32": 8, "float16": 2, "int64": 0}[kind] * random.random()

    def normal(*shape: int) -> Exact:
        if whole:
            return exact(random.integers(-3, 4, shape))
        # Zeros, as in Jacobians.
        return exact(random.normal(size=shape) * (random.random(shape) < 0.8))

    bodies = normal(n + int(random.integers(-1, 3)), n)
    masses = 10.0 ** random.uniform(-decades / 2, decades / 2, len(bodies)) if not whole else np.ones(len(bodies))
    masses[random.random(len(bodies)) < 0.15] = 0.0
    M = bodies.T @ (exact(masses)[:, None] * bodies) if len(bodies) else exact(np.zeros((n, n)))
    A = normal(int(random.integers(0, n)), n)
    # Difference of a row from a combination of other rows.
    beside = 10.0 ** -random.uniform(0, {"float64": 8, "float32": 4, "float16": 1, "int64": 0}[kind])
    if len(A) > 1 and random.random() < 0.2:
        A[-1] = exact(beside) * A[-1] + normal(len(A) - 1) @ A[:-1]
    A = independent(A)
    j = normal(n)
    if len(A) and random.random() < 0.16:
        j = normal(len(A)) @ A + exact(beside if random.random() < 0.5 and not whole else 0.0) * j
    combined = exact(random.integers(-2, 3, (int(random.integers(0, 3)) if len(A) else 0, len(A)))) @ A
    rows = np.concatenate([A, combined.reshape(-1, n)])
    span = {"float64": 12.0, "float32": 12.0, "float16": 1.0, "int64": 0.0}[kind]
    scale = exact(2.0 ** np.round(np.log2(10.0) * random.uniform(-span, span, len(rows))))
    rows = rows * scale[:, None]

    def rounded(array: Exact) -> NDArray[Any]:
        return array.astype(np.float64).astype(kind)

    return Problem(kind, M, A, j, (rounded(M), rounded(rows), rounded(j)))


def independent(rows: Exact) -> Exact:
    """Rows that are linearly independent of the rows before."""
    kept: list[Exact] = []
    reduced: list[tuple[int, Exact]] = []
    for row in rows:
        left, size = row.copy(), max(abs(row))
        for column, other in reduced:
            left = left - left[column] * other
        column = int(np.argmax(abs(left)))
        if size > 0 and abs(left[column]) > ZERO * size:
            reduced.append((column, left / left[column]))
            kept.append(row)
    return np.array(kept, dtype=object).reshape(-1, rows.shape[1])


def kernel(rows: Exact) -> Exact:
    """Columns that span the motions with rows @ v = 0."""
    n = rows.shape[1]
    pivots: list[int] = []
    done = rows.copy()
    for r in range(len(done)):
        column = int(np.argmax(abs(done[r])))
        done[r] = done[r] / done[r, column]
        for other in range(len(done)):
            if other != r:
                done[other] = done[other] - done[other, column] * done[r]
        pivots.append(column)
    free = [c for c in range(n) if c not in pivots]
    basis = exact(np.zeros((n, len(free))))
    for k, c in enumerate(free):
        basis[c, k] = gmpy2.mpfr(1)
        for r, pivot in enumerate(pivots):
            basis[pivot, k] = -done[r, c]
    return basis


def solved(problem: Problem) -> tuple[str, Any]:
    """The outcome and m̄."""
    basis = kernel(problem.A)
    along = problem.j @ basis
    if basis.shape[1] == 0 or max(abs(along), default=0) <= ZERO * max(abs(problem.j)) or not any(problem.j):
        return "immovable", None
    pivot = int(np.argmax(abs(along)))
    # v = first + motions y, with j v = 1.
    first = basis[:, pivot] / along[pivot]
    others = [k for k in range(basis.shape[1]) if k != pivot]
    motions = basis[:, others] - first[:, None] * along[others]
    energy = first @ problem.M @ first
    H, g = motions.T @ problem.M @ motions, motions.T @ problem.M @ first
    size: Any = abs(np.diag(H)).copy() if len(others) else []
    least, left = energy, np.ones(len(others), bool)
    for _ in others:
        ratios = [H[k, k] / size[k] if left[k] and size[k] > 0 else gmpy2.mpfr(0) for k in range(len(others))]
        k = int(np.argmax(ratios))
        if ratios[k] <= ZERO:
            break
        least = least - g[k] ** 2 / H[k, k]
        row, pivot_ = H[k].copy(), H[k, k]
        g = g - row * g[k] / pivot_
        H = H - np.outer(row, row) / pivot_
        left[k] = False
    terms = sum(abs(x) for x in (first * (problem.M @ first))) + energy
    return ("massless", None) if least <= ZERO * max(terms, ZERO) else ("finite", least)


@dataclass
class Tally:
    counts: Counter[str] = field(default_factory=Counter)
    #: Finite results only: true error over stated error, and stated error over true error.
    worst: dict[str, float] = field(default_factory=dict)
    ratios: dict[str, list[float]] = field(default_factory=dict)
    failures: list[str] = field(default_factory=list)
    #: Finite results of batches with a stated error.
    in_batches: int = 0

    def judge_batch(self, name: str, problem: Problem, truth: Any) -> None:
        """The same problem in a batch, unless rows of A may count as rounding there."""
        M, A, j = problem.arrays
        sizes = abs(A.astype(float)).max(axis=1, initial=0.0)
        if len(A) and sizes.min() < 1e-10 * sizes.max():
            return
        (mass,), (error,), (status,) = percuss.effective_masses(M[None], j, A)
        if status == percuss.Status.FINITE and np.isfinite(error):
            self.in_batches += 1
            if abs(gmpy2.mpfr(float(mass)) - truth) > error:
                self.failures.append(f"{name}: in a batch {mass} ± {error:.2e}, truly {float(truth)}")

    def judge(self, number: int, problem: Problem) -> None:
        outcome, truth = solved(problem)
        M, A, j = problem.arrays
        name = f"problem {number} ({problem.kind})"
        try:
            found = percuss.effective_mass(M, j, A, row_noise=0.0)
        except percuss.InputError as refusal:
            self.failures.append(f"{name}: {refusal}")
            return
        what = f"{outcome} as {found.status}"
        if not found.rank["is_clear"]:
            self.counts[f"{problem.kind}: unclear rank"] += 1
            if found.error is not None:
                self.failures.append(f"{name}: an error is stated with an unclear rank")
            return
        if len(A) - len(problem.A) != len(found.rank["redundant_rows"]):
            self.failures.append(f"{name}: rank {found.rank}, {len(problem.A)} independent rows")
            return
        if outcome == "finite":
            self.judge_batch(name, problem, truth)
        if outcome == "finite" and found.status == "finite":
            if found.error is None:
                what += " without a stated error"
            else:
                off = abs(gmpy2.mpfr(found.effective_mass) - truth)
                self.worst[problem.kind] = max(self.worst.get(problem.kind, 0.0), float(off / found.error))
                if off > 0:
                    self.ratios.setdefault(problem.kind, []).append(float(found.error / off))
                if off > found.error:
                    self.failures.append(f"{name}: {found.effective_mass} ± {found.error:.2e}, truly {float(truth)}")
        elif outcome == "finite" and found.status == "massless":
            # Mass lost in the rounding of M: below the reported limit, or below 1e-9 of the greatest mass, which is not
            # reported.
            limits = [float(r.split("up to ")[1].split(" ")[0]) for r in found.remarks if "up to" in r]
            most = max([*limits, 1e-9 * float(np.max(np.diag(M).astype(float)))])
            if truth > 1.05 * most:
                self.failures.append(f"{name}: massless up to {most}, truly {float(truth)}")
        elif outcome == "massless" and found.status == "finite":
            # A positive energy at rounding level.
            if found.error is not None and found.error < found.effective_mass:  # type: ignore[operator]
                self.failures.append(f"{name}: {found.effective_mass} ± {found.error:.2e}, truly massless")
        elif outcome != found.status:
            uncertain = any("nearly immovable" in remark for remark in found.remarks)
            if not uncertain:
                self.failures.append(f"{name}: {found.status}, truly {outcome} {truth} {found.remarks}")
            what += ", reported as uncertain"
        self.counts[f"{problem.kind}: {what}"] += 1

    def median(self, kind: str) -> float:
        return float(np.median(self.ratios[kind]))

    def report(self) -> str:
        lines = [f"{what}: {count}" for what, count in sorted(self.counts.items())]
        for kind, worst in self.worst.items():
            lines.append(f"{kind}: true/stated at most {worst:.3f}, median of stated/true {self.median(kind):.0f}")
        return "\n".join([*lines, f"{len(self.failures)} failures", *self.failures[:20]])


def family(problems: int, seed: int) -> Tally:
    random, tally = np.random.default_rng(seed), Tally()
    for number in range(problems):
        tally.judge(number, problem(random, number))
    return tally


if __name__ == "__main__":
    flags = argparse.ArgumentParser()
    flags.add_argument("--problems", type=int, default=100_000)
    flags.add_argument("--seed", type=int, default=1)
    given = flags.parse_args()
    found = family(given.problems, given.seed)
    print(found.report())
    sys.exit(bool(found.failures))
