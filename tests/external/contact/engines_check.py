"""Whether the other engines bounce as asked with the parameters that `percuss damp` writes for them.

    engines_check.py --percuss PATH [--only TOOL]…     prints a table and `N passed, N failed`

Each module of `engines` whose program is installed is run: a ball and pendulums, e = 0.2, 0.5, 0.8, five phases, at the step that
percuss exports, at twice and at half of it; and with the struck body's own mass in place of the effective mass."""

import argparse
import importlib
import pkgutil
import sys
import tempfile
import time
from pathlib import Path

import engines
from impacts import answer, damp
from scenes import BALL, PENDULUMS, Refused
from tally import Tally

RESTITUTIONS = (0.2, 0.5, 0.8)
STEPS = (1.0, 2.0, 0.5)
# Of the effective mass by closed form.
MASS = 1e-12
# A scene's name: the module's function and what it is given.
SCENES = {"ball": ("ball", BALL)} | {f"pendulum, rotor {p.rotor}": ("pendulum", p) for p in PENDULUMS}


def export(report, tool):
    return report["exports"][tool]


class Check:
    def __init__(self, percuss, folder):
        self.percuss, self.folder = percuss, folder
        self.tally, self.lines = Tally(), []

    def engine(self, module):
        tool, engine = module.TOOL, module.engine()
        for scene, (function, what) in SCENES.items():
            run = getattr(module, function)
            contact = what.contact(self.folder)
            for e in RESTITUTIONS:
                report = damp(self.percuss, contact, e, "--for", tool)
                if function == "pendulum":
                    deviation = abs(report["effective_mass"] / what.effective_mass - 1)
                    self.tally.within("effective mass by closed form", f"{scene}, e = {e}", deviation, MASS)
                for name, solver in module.SOLVERS.items():
                    self.runs(tool, engine, name, scene, report, contact, lambda p: run(p, solver, what, contact.speed))

    def runs(self, tool, engine, solver, scene, report, contact, run):
        """A scene at three steps, each within the bound that percuss states there, and within what the export says was measured."""
        e, given = report["restitution"], export(report, tool)
        where = f"{engine} {solver}, {scene}, e = {e}"
        if given["error"]:
            self.lines.append(f"{where}: percuss: {given['error']}")
            return
        measured = [m for m in given["measured"] if m["engine"] == engine and m["solver"] == solver]
        self.tally.check("the export names engine and solver", where, len(measured) == 1, f"{given['measured']}")
        line = f"{engine + ' ' + solver:34} {scene:20} {e:4}"
        for factor in STEPS:
            here = given
            if factor != 1.0 and given["time_step"]:
                step = repr(factor * given["time_step"])
                here = export(damp(self.percuss, contact, e, "--for", tool, "--time-step", step), tool)
            if here["error"]:
                line += f"  {'refused':>8}"
                continue
            try:
                outcome = run(here["parameters"])
            except Refused as refused:
                line += f"  {str(refused):>8}"
                continue
            error = outcome.error(e)
            line += f"  {error:8.1e}"
            if here["error_bound"]:
                self.tally.within(f"within the stated bound: {tool} {solver}", f"{where}, step × {factor}", error / here["error_bound"], 1.0)
            if factor == 1.0 and measured:
                known = measured[0]["worst"][RESTITUTIONS.index(e)]
                self.tally.within(f"as measured before: {tool} {solver}", where, error / known, 1.0)
            if not given["time_step"]:
                break
        own = answer(
            self.percuss, "damp", "--mass", repr(SCENES[scene][1].own_mass), "--own-mass", repr(SCENES[scene][1].own_mass),
            "--restitution", repr(e), "--stiffness", repr(contact.stiffness), "--speed", repr(contact.speed), "--for", tool,
        )
        own = export(own, tool)
        if not own["error"]:
            try:
                line += f"   own mass {run(own['parameters']).mean:.3f}"
            except Refused as refused:
                line += f"   own mass: {refused}"
        print(line, flush=True)
        self.lines.append(line)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--percuss", required=True)
    parser.add_argument("--only", action="append", default=[])
    arguments = parser.parse_args()
    started = time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        check = Check(arguments.percuss, Path(folder))
        for found in pkgutil.iter_modules(engines.__path__):
            if not arguments.only or found.name in arguments.only:
                check.engine(importlib.import_module(f"engines.{found.name}"))
    return check.tally.report(time.monotonic() - started)


if __name__ == "__main__":
    sys.exit(main())
