"""m̄ = 1/(j M⁻¹ jᵀ) from somebody else's M and j, and whether there is one."""

from dataclasses import dataclass

import numpy as np

IMMOVABLE = 1e-10  # |j| relative to the size of its terms
SINGULAR = 1e-13  # eigenvalues of M scaled to unit diagonal


@dataclass
class Outcome:
    status: str  # finite, immovable, massless, or refused: negative under an indefinite M
    effective_mass: float | None = None


class Inertia:
    """M scaled to unit diagonal, without the coordinates that carry no mass."""

    def __init__(self, mass):
        diagonal = np.diag(mass)
        self.weighs = diagonal != 0
        self.scale = 1 / np.sqrt(np.abs(np.where(self.weighs, diagonal, 1.0)))
        kept = np.ix_(self.weighs, self.weighs)
        self.scaled = (mass * np.outer(self.scale, self.scale))[kept]
        values, self.vectors = np.linalg.eigh(self.scaled) if self.weighs.any() else (np.ones(1), None)
        self.null = np.abs(values) <= SINGULAR * np.abs(values).max()
        self.condition = np.inf if self.null.any() else np.abs(values).max() / np.abs(values).min()
        self.indefinite = bool((values[~self.null] < 0).any())

    def outcome(self, row, size):
        """Of a contact row whose terms have the given size."""
        if len(row) == 0 or np.abs(row).max() <= IMMOVABLE * size.max():
            return Outcome("immovable")
        if (np.abs(row[~self.weighs]) > IMMOVABLE * size.max()).any():
            return Outcome("massless")
        j = (row * self.scale)[self.weighs]
        if self.null.any():
            return self.singular(j)
        if self.indefinite:
            inverse = j @ np.linalg.solve(self.scaled, j)
            return Outcome("finite", 1 / inverse) if inverse > 0 else Outcome("refused")
        half = np.linalg.solve(np.linalg.cholesky(self.scaled), j)
        return Outcome("finite", 1 / (half @ half))

    def singular(self, j):
        raise NotImplementedError("M is singular beyond zero rows")
