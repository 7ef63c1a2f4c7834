"""Exceptions and warnings. Messages are those of the command line."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ._percuss import Diagnostic


class PercussError(Exception):
    """What percuss raises."""


class InputError(PercussError, ValueError):
    """Something that was given means nothing: a name, a number, a shape (exit code 2 of the command)."""


class LoadError(InputError):
    """A file that cannot be read: every error of it in the message, warnings and notes too in diagnostics."""

    diagnostics: list[Diagnostic]

    def __init__(self, message: str, diagnostics: Sequence[Diagnostic] = ()) -> None:
        super().__init__(message)
        self.diagnostics = list(diagnostics)


class NoAnswerError(PercussError):
    """What was asked is fine and has no answer (exit code 1 of the command)."""


class AssemblyError(NoAnswerError):
    """Loops that do not close, or joints that cannot get where they are set."""


class ModelWarning(UserWarning):
    """A warning about a file: probably not what was meant."""
