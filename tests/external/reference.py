"""m̄ = 1/(j M⁻¹ jᵀ) from M and j of another program, or the reason for another outcome."""

from dataclasses import dataclass

import numpy as np

# Sizes relative to the summed terms. Below the first limit, an entry of j is rounding; above the second, it is
# significant; in between, both outcomes are accepted.
ROUNDING, REAL = 1e-11, 1e-8
# Condition limit of M; above, M counts as singular.
SINGULAR = 1e13


@dataclass
class Outcome:
    """Permitted results for a contact. `refused`: M is indefinite, and the mass would be negative."""

    statuses: tuple
    effective_mass: float | None = None
    # Amplification of rounding in m̄: condition of M, |terms of j| / |j|, a few operations.
    magnified: float = 0.0


class Inertia:
    """M scaled to unit diagonal, without the coordinates that move no mass: their rows are exactly zero if all
    following links are massless."""

    def __init__(self, mass):
        diagonal = np.diag(mass)
        self.weighs = diagonal != 0
        self.scale = 1 / np.sqrt(np.abs(diagonal[self.weighs]))
        self.scaled = mass[np.ix_(self.weighs, self.weighs)] * np.outer(self.scale, self.scale)
        values = np.linalg.eigvalsh(self.scaled) if self.weighs.any() else np.ones(1)
        least = np.abs(values).min()
        self.condition = np.abs(values).max() / least if least > 0 else np.inf
        self.indefinite = bool((values < 0).any())

    def outcome(self, row, size):
        """Permitted results for a contact row with terms of the given sizes."""
        parts = np.abs(row) / size.max() if len(row) and size.max() > 0 else np.zeros(1)
        approach = parts.max()
        if approach <= ROUNDING:
            return Outcome(("immovable",))
        free = parts[~self.weighs].max(initial=0.0) if len(row) else 0.0
        if free >= REAL:
            return Outcome(("massless",))
        heavy = self.finite(row[self.weighs] * self.scale)
        statuses = ("finite",) if heavy > 0 else ("refused",)
        statuses += ("massless",) if free > ROUNDING else ()
        statuses += ("immovable",) if approach < REAL else ()
        return Outcome(statuses, heavy, 10 + self.condition + 1 / approach)

    def finite(self, j):
        if self.indefinite:
            return 1 / (j @ np.linalg.solve(self.scaled, j))
        half = np.linalg.solve(np.linalg.cholesky(self.scaled), j)
        return 1 / (half @ half)
