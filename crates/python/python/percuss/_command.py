"""The percuss command."""

from __future__ import annotations

import signal
import sys
from typing import NoReturn

from ._percuss import run_command


def main() -> NoReturn:
    """Runs the command, with the same output and exit codes as the program."""
    # Ctrl-C ends the process at once, as for the program.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    run_command(["percuss", *sys.argv[1:]])
