"""Whether the other engines bounce as asked with the parameters that `percuss damp` writes for them.

    engines_check.py --percuss PATH [--only MODULE]… [--without MODULE]… [--levers COUNT]     prints a table and `N passed, N failed`

Each module of `engines` is run (one whose program is not installed fails): a ball, pendulums, a four-bar where the tool
closes loops, and stops of joints where percuss writes them; e = 0.2, 0.5, 0.8, five phases, at the step that percuss exports, at twice and at half of it; and with the struck
body's own mass in place of the effective mass. Then balls of other masses, speeds and stiffnesses, an oblique double pendulum, a lever against
a free ball, and COUNT (5) random compound levers, at the exported step. Snippets are given to the tool. Run from the repository's root."""

import argparse
import dataclasses
import importlib
import pkgutil
import sys
import tempfile
import time
from pathlib import Path

import engines
from impacts import damp
from scenes import BALL, BALLS, DOUBLE_PENDULUM, FOUR_BAR, PENDULUMS, TWO_BODIES, Absent, Refused, levers
from stop_scenes import STOPS
from tally import Tally

RESTITUTIONS = (0.2, 0.5, 0.8)
STEPS = (1.0, 2.0, 0.5)
# Of the effective mass by closed form.
MASS = 1e-12
# The stiffness where the exponent of the spring is not 1, N/m^1.5.
HERTZ = 1e8
# A scene's name: the module's function and what it is given.
SCENES = (
    {"ball": ("ball", BALL)}
    | {f"pendulum, rotor {p.rotor}": ("pendulum", p) for p in PENDULUMS}
    | {"four-bar": ("four_bar", FOUR_BAR)}
    | {name: ("stop", stop) for name, stop in STOPS.items()}
)
# Name, the module's function, what it is given, restitution: run at the exported step.
FURTHER = [(f"ball {i}", "ball", ball, e) for i, (ball, e) in enumerate(BALLS)]
FURTHER += [(f"double pendulum, e = {e}", "linkage", DOUBLE_PENDULUM, e) for e in (0.3, 0.9)]
FURTHER += [(f"two moving bodies {i}", "two_bodies", bodies, e) for i, (bodies, e) in enumerate(TWO_BODIES)]
# Of a stiffness in N/m, the one in N/m^1.5 of about the same penetration, 1e-4 m.
PER_ROOT = 100.0


def export(report, tool):
    return report["exports"][tool]


class Check:
    def __init__(self, percuss, folder, levers):
        self.percuss, self.folder, self.levers = percuss, folder, levers
        self.tally, self.lines = Tally(), []

    def engine(self, module):
        tool = module.TOOL
        try:
            engine = module.engine()
        except Absent as absent:
            if getattr(module, "BY_HAND", False):
                print(f"{tool}: not run; install {absent}")
                return
            self.tally.check("the engine is installed", module.__name__, False, f"install {absent}")
            return
        for scene, (function, what) in SCENES.items():
            run = getattr(module, function, None)
            if not run:
                continue
            contact = what.contact(self.folder)
            if exponent := getattr(module, "EXPONENT", None):
                flags = (*contact.flags, "--exponent", repr(exponent))
                contact = dataclasses.replace(contact, flags=flags, stiffness=HERTZ)
            for e in RESTITUTIONS:
                report = damp(self.percuss, contact, e, "--for", "all")
                if function in ("ball", "stop"):
                    self.snippets(module, f"{engine}, {scene}, e = {e}", export(report, tool))
                if function != "ball":
                    deviation = abs(report["effective_mass"] / what.effective_mass - 1)
                    self.tally.within("effective mass by closed form", f"{scene}, e = {e}", deviation, MASS)
                for name, solver in module.SOLVERS.items():
                    bound = function not in getattr(module, "UNBOUND", ())
                    self.runs(tool, engine, name, scene, report, contact, lambda p: run(p, solver, what, contact.speed), bound, getattr(module, "SINGLE", ()))

        made = [(f"lever {i}", "pendulum", lever, e) for i, (lever, e) in enumerate(levers(self.levers))]
        for scene, function, what, e in FURTHER + made:
            if run := getattr(module, function, None):
                self.further(module, engine, scene, function, run, what, e)

    def further(self, module, engine, scene, function, run, what, e):
        """Runs a scene with one restitution at the exported step: within the bound, or refused."""
        contact = what.contact(self.folder)
        if exponent := getattr(module, "EXPONENT", None):
            flags = (*contact.flags, "--exponent", repr(exponent))
            contact = dataclasses.replace(contact, flags=flags, stiffness=PER_ROOT * contact.stiffness)
        report = damp(self.percuss, contact, e, "--for", "all")
        if function != "ball":
            deviation = abs(report["effective_mass"] / what.effective_mass - 1)
            self.tally.within("effective mass by closed form", scene, deviation, MASS)
        given = export(report, module.TOOL)
        line = f"{engine:24} {scene:24} {e:5.3f} m̄ {report['effective_mass']:8.3f}"
        if given["error"]:
            print(f"{line}: percuss: {given['error']}", flush=True)
            return
        for name, solver in module.SOLVERS.items():
            try:
                error = run(given["parameters"], solver, what, contact.speed).error(e)
            except Refused as refused:
                print(f"{line} {name}: {refused}", flush=True)
                continue
            bound = given["error_bound"]
            if bound and name in getattr(module, "SINGLE", ()):
                bound += given["single_precision_error"]
            print(f"{line} {name}: {error:8.1e}, bound {bound or float('nan'):8.1e}", flush=True)
            if bound:
                self.tally.within(f"further scenes within the bound: {module.TOOL} {name}", scene, error / bound, 1.0)
            else:
                stated = any("No error is stated" in text or "no error is stated" in text for text in given["assumptions"])
                self.tally.check("further scenes: a reason where no bound is stated", f"{engine}, {scene}", stated or given["missing"], "")

    def snippets(self, module, where, given):
        """What is to paste, given to the tool."""
        seen = set()
        for snippet in given["snippets"]:
            language = snippet["language"]
            if reader := getattr(module, "SNIPPETS", {}).get(language):
                seen.add(language)
                wrong = ""
                try:
                    reader(snippet["text"], given["parameters"])
                except Exception as error:  # whatever a foreign reader raises is the answer looked for
                    wrong = f"{type(error).__name__}: {error}"
                self.tally.check(f"snippets: {module.TOOL}, {language}", f"{where}, {snippet['title']}", not wrong, wrong)
        if not given["error"]:
            missing = set(getattr(module, "SNIPPETS", {})) - seen
            self.tally.check("snippets: none is missing", where, not missing, f"{missing}")

    def runs(self, tool, engine, solver, scene, report, contact, run, bound, single=()):
        """A scene at three steps, each within the bound that percuss states there, and within what the export says was measured.
        Not `bound`: the export states no error for this scene, and what was measured is not of it."""
        e, given = report["restitution"], export(report, tool)
        where = f"{engine} {solver}, {scene}, e = {e}"
        if given["error"]:
            self.lines.append(f"{where}: percuss: {given['error']}")
            return
        measured = [m for m in given["measured"] if m["engine"] == engine and m["solver"] == solver]
        self.tally.check("the export names engine and solver", where, len(measured) == 1, f"{given['measured']}")
        if not bound:
            self.tally.check("no error is stated", where, given["error_bound"] is None, f"{given['error_bound']}")
        line = f"{engine + ' ' + solver:34} {scene:20} {e:4}"
        # Twice and half the step: of the ball, in whose place the others' error halves and doubles too.
        for factor in STEPS if scene == "ball" else STEPS[:1]:
            here = given
            if factor != 1.0 and given["time_step"]:
                step = repr(factor * given["time_step"])
                here = export(damp(self.percuss, contact, e, "--for", "all", "--time-step", step), tool)
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
            if limit := here["error_bound"]:
                limit += here["single_precision_error"] or 0.0 if solver in single else 0.0
                self.tally.within(f"within the stated bound: {tool} {solver}", f"{where}, step × {factor}", error / limit, 1.0)
            if factor == 1.0 and measured and bound:
                # None: refused in another scene, or not run.
                if known := measured[0]["worst"][RESTITUTIONS.index(e)]:
                    self.tally.within(f"as measured before: {tool} {solver}", where, error / known, 1.0)
            if not given["time_step"]:
                break
        exponent = contact.flags[-2:] if "--exponent" in contact.flags else ()
        alone = SCENES[scene][1].alone(self.folder)
        alone = dataclasses.replace(alone, flags=(*alone.flags, *exponent), stiffness=contact.stiffness)
        own = export(damp(self.percuss, alone, e, "--for", "all"), tool)
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
    parser.add_argument("--without", action="append", default=[])
    parser.add_argument("--levers", type=int, default=5, help="random compound levers in each engine (50 in the long run)")
    arguments = parser.parse_args()
    started = time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        check = Check(arguments.percuss, Path(folder), arguments.levers)
        for found in pkgutil.iter_modules(engines.__path__):
            wanted = not arguments.only or found.name in arguments.only
            if wanted and found.name not in arguments.without and not found.name.startswith("_"):
                check.engine(importlib.import_module(f"engines.{found.name}"))
    return check.tally.report(time.monotonic() - started)


if __name__ == "__main__":
    sys.exit(main())
