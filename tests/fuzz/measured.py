"""Runs a command, appends its processor time, peak memory and exit code to a table, and ends with the same exit code.

    PERCUSS_UNDER="python3 tests/fuzz/measured.py TABLE" cargo test --locked --workspace --test cli bounded -- --test-threads=1

The tests of bounded files then run the command below this script. With PERCUSS_PROGRAM another build of percuss runs instead, for
example target/release/percuss.
"""

import os
import subprocess
import sys

table, program, *arguments = sys.argv[1:]
program = os.environ.get("PERCUSS_PROGRAM", program)
run = subprocess.Popen([program, *arguments])
_, status, used = os.wait4(run.pid, 0)
code = os.waitstatus_to_exitcode(status)
with open(table, "a", encoding="utf-8") as file:
    names = " ".join(os.path.basename(word) for word in arguments[:2])
    file.write(f"{names:<28} {used.ru_utime + used.ru_stime:7.2f} s {used.ru_maxrss >> 10:6} MB  exit code {code}\n")
sys.exit(code if code >= 0 else 128 - code)
