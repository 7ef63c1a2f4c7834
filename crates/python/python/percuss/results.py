"""Types of results, and of what a model contains: none is made by its name.

    >>> isinstance(percuss.sweep(arm, tool, q), percuss.results.Sweep)
"""

from ._impacts import Impacts
from ._matrices import MatrixBatch
from ._percuss import Accelerations, Diagnostic, Joint, MatrixResponse, Response, Sweep
from ._sweeps import SweepRow

__all__ = ["Accelerations", "Diagnostic", "Impacts", "Joint", "MatrixBatch", "MatrixResponse", "Response", "Sweep", "SweepRow"]
