"""m̄ of a batch of matrices."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._percuss import Diagnostic, matrix_findings


class MatrixBatch:
    """m̄, error and status of a batch of matrices, with the findings about it.

    Unpacks into effective_mass, error, status.

        >>> masses, errors, status = percuss.effective_masses(np.stack([np.eye(2), 2 * np.eye(2)]), [1.0, 0.0])
    """

    def __init__(
        self,
        effective_mass: NDArray[np.float64],
        error: NDArray[np.float64],
        status: NDArray[np.uint8],
        remarks: NDArray[np.uint32],
        small_rows: list[int],
    ) -> None:
        """Made by effective_masses. small_rows: numbers of the problems with small rows of A."""
        self._parts = (effective_mass, error, status)
        self._remarks, self._small_rows = remarks, small_rows

    def __iter__(self) -> Iterator[NDArray[Any]]:
        return iter(self._parts)

    def __len__(self) -> int:
        return len(self._parts)

    def __getitem__(self, index: int) -> NDArray[Any]:
        return self._parts[index]

    @property
    def effective_mass(self) -> NDArray[np.float64]:
        """m̄, kg; NaN unless finite; (b,)."""
        return self._parts[0]

    @property
    def error(self) -> NDArray[np.float64]:
        """Error of m̄, kg; NaN if unknown; (b,)."""
        return self._parts[1]

    @property
    def status(self) -> NDArray[np.uint8]:
        """0 finite, 1 immovable, 2 massless; uint8, (b,)."""
        return self._parts[2]

    @property
    def remarks(self) -> NDArray[np.uint32]:
        """Findings about each problem: RemarkFlags added together; uint32, (b,)."""
        return self._remarks

    @property
    def findings(self) -> list[Diagnostic]:
        """Findings about the batch: one per kind, with the number of the first problem and of further problems.

        effective_mass of a problem alone has the numbers in its remarks.
        """
        return matrix_findings(self.remarks, self._small_rows)

    def __repr__(self) -> str:
        finite = int(np.count_nonzero(self.status == 0))
        return f"<MatrixBatch: {len(self.status)} problems, {finite} finite, {len(self.findings)} findings>"
