"""The percuss command."""

from __future__ import annotations

import signal
import sys
from typing import NoReturn

from ._percuss import run_command


def main() -> NoReturn:
    """Runs the command as the program does: the same output, the same exit codes."""
    # Ctrl-C ends it at once, as it does the program.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    run_command(["percuss", *sys.argv[1:]])
