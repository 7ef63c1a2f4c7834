"""m̄ of a batch of matrices."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._percuss import Diagnostic, matrix_findings


class MatrixBatch(tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.uint8]]):
    """m̄, error and status of a batch of matrices, with the findings about it.

    Unpacks into effective_mass, error, status, which are its attributes too.
    """

    #: Findings about each problem: RemarkFlags added together; uint32, (b,).
    remarks: NDArray[np.uint32]
    _small_rows: list[int]

    def __new__(
        cls,
        effective_mass: NDArray[np.float64],
        error: NDArray[np.float64],
        status: NDArray[np.uint8],
        remarks: NDArray[np.uint32],
        small_rows: list[int],
    ) -> MatrixBatch:
        """Made by effective_masses. small_rows: numbers of the problems with small rows of A."""
        made = super().__new__(cls, (effective_mass, error, status))
        made.remarks, made._small_rows = remarks, small_rows
        return made

    @property
    def effective_mass(self) -> NDArray[np.float64]:
        """m̄, kg; NaN unless finite; (b,)."""
        return self[0]

    @property
    def error(self) -> NDArray[np.float64]:
        """Error of m̄, kg; NaN if unknown; (b,)."""
        return self[1]

    @property
    def status(self) -> NDArray[np.uint8]:
        """0 finite, 1 immovable, 2 massless; uint8, (b,)."""
        return self[2]

    @property
    def findings(self) -> list[Diagnostic]:
        """Findings about the batch: one per kind, with the number of the first problem and of further problems.

        effective_mass of a problem alone has the numbers in its remarks.
        """
        return matrix_findings(self.remarks, self._small_rows)

    def __getnewargs__(self) -> tuple[Any, ...]:
        """Arguments of the constructor, for copies and pickle."""
        return (*self, self.remarks, self._small_rows)

    def __repr__(self) -> str:
        finite = int(np.count_nonzero(self.status == 0))
        return f"<MatrixBatch: {len(self.status)} problems, {finite} finite, {len(self.findings)} findings>"
