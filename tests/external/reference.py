"""m̄ = 1/(j M⁻¹ jᵀ) from somebody else's M and j, or why there is none."""

from dataclasses import dataclass

import numpy as np

# Sizes relative to those of the terms that were summed. Below the first, an entry of j is rounding; above the second,
# it is not; what lies between may be told either way.
ROUNDING, REAL = 1e-11, 1e-8
# Condition of M beyond which it is singular.
SINGULAR = 1e13


@dataclass
class Outcome:
    """What may be answered to a contact. `refused`: M is indefinite and leaves a negative mass."""

    statuses: tuple
    effective_mass: float | None = None
    # How much rounding is magnified on the way to m̄: condition of M, |terms of j| / |j|, a few operations.
    magnified: float = 0.0


class Inertia:
    """M scaled to unit diagonal, without the coordinates that move no mass: their rows are exactly zero where only
    massless links follow them."""

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
        """Of a contact row whose terms have the given sizes."""
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
