"""Exceptions and warnings. Messages are the same as on the command line."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ._percuss import Diagnostic


class PercussError(Exception):
    """Base class of all percuss exceptions."""


class InputError(PercussError, ValueError):
    """Invalid argument: a name, a number, a shape (exit code 2 of the command)."""


class ArgumentTypeError(InputError, TypeError):
    """Argument of a wrong type; the message names it."""


class NotComputedError(InputError, AttributeError):
    """Attribute of a result that was not requested from the call that made the result."""


class LoadError(InputError):
    """Unreadable file. The message lists every error; diagnostics lists warnings and notes too."""

    diagnostics: list[Diagnostic]

    def __init__(self, message: str, diagnostics: Sequence[Diagnostic] = ()) -> None:
        super().__init__(message)
        self.diagnostics = list(diagnostics)


class NoAnswerError(PercussError):
    """Valid question without an answer (exit code 1 of the command)."""


class AssemblyError(NoAnswerError):
    """Loops that do not close, or joints unable to reach their requested positions."""


class ModelWarning(UserWarning):
    """Warning about a file: probably not the author's intention."""
