"""Report of the comparisons of one run: what was compared with which version of which program, and the worst deviations.

    validation.py FOLDER -o FILE [--python PYTHON]...

FOLDER: the outputs of the checks (NAME, NAME.code) and the tallies of those that keep one (*.tally.json), as run.sh collects them.
PYTHON: interpreters whose installed packages are listed.
"""

import argparse
import json
import re
import subprocess
import sys
from datetime import date
from pathlib import Path

# Packages that are compared with; all others are their dependencies.
PEERS = (
    "pin", "mujoco", "drake", "pybullet", "dartpy", "exudyn", "opensim", "newton-physics", "rapier3d", "numpy", "scipy",
    "example-robot-data", "mpmath", "gmpy2", "torch", "jax",
)  # fmt: skip


def versions(python):
    """Name and version of the installed peers of an interpreter."""
    listed = subprocess.run([python, "-m", "pip", "list", "--format=json"], capture_output=True, text=True)
    if listed.returncode:
        return {}
    return {p["name"].lower(): p["version"] for p in json.loads(listed.stdout) if p["name"].lower() in PEERS}


def counts(text):
    """Passed and failed checks of an output: its last line `N passed, N failed`; None without one."""
    found = re.findall(r"^(\d+) passed, (\d+) failed", text, flags=re.M)
    return tuple(map(int, found[-1])) if found else None


def report(folder, pythons):
    names = sorted(path.stem for path in folder.glob("*.code"))
    if not names:
        raise SystemExit(f"validation.py: {folder} has no results (*.code); expected the outputs of run.sh")
    lines = ["# Validation report", "", f"Made by `tests/external/run.sh` on {date.today()}; not written by hand.", ""]
    found = {name: version for python in pythons for name, version in versions(python).items()}
    if found:
        lines += ["| program | version |", "|---|---|", *(f"| {name} | {found[name]} |" for name in sorted(found)), ""]
    lines += ["| comparison | passed | failed | result |", "|---|---|---|---|"]
    for name in names:
        code = (folder / f"{name}.code").read_text().strip()
        passed, failed = counts((folder / name).read_text()) or ("", "")
        lines.append(f"| {name} | {passed} | {failed} | {'passed' if code == '0' else f'FAILED (exit code {code})'} |")
    for path in sorted(folder.glob("*.tally.json")):
        tally = json.loads(path.read_text())
        lines += ["", f"## {tally['program']}", "", "| check | passed | failed | worst | limit | where |", "|---|---|---|---|---|---|"]
        for check in tally["checks"]:
            worst = check["worst"]
            tail = f"{worst['deviation']:.1e} | {worst['limit']:.0e} | {worst['where']}" if worst else " | | "
            lines.append(f"| {check['name']} | {check['passed']} | {check['failed']} | {tail} |".replace("\n", " "))
    return "\n".join(lines) + "\n"


def main():
    flags = argparse.ArgumentParser()
    flags.add_argument("folder", type=Path)
    flags.add_argument("-o", "--output", type=Path, required=True)
    flags.add_argument("--python", action="append", default=[])
    given = flags.parse_args()
    given.output.write_text(report(given.folder, given.python))
    print(f"validation report: {given.output}")


if __name__ == "__main__":
    sys.exit(main())
