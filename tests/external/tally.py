"""Counts passed and failed checks, keeps the worst deviation of each, and prints the tables."""

import collections
import json
import os
import sys
from pathlib import Path

SHOWN = 5  # failures of one check that are printed


class Tally:
    def __init__(self):
        self.passed, self.failed = collections.Counter(), collections.Counter()
        self.worst = {}
        self.failures = collections.defaultdict(list)
        self.answers = collections.Counter()
        self.undecided = collections.Counter()
        self.conditions = {}
        # Per suite: routes of finite contacts, and reasons for the dense route.
        self.routes = collections.defaultdict(collections.Counter)
        self.reasons = collections.defaultdict(collections.Counter)

    def check(self, check, where, ok, message=""):
        (self.passed if ok else self.failed)[check] += 1
        if not ok:
            self.failures[check].append(f"{where}: {message}")

    def within(self, check, where, deviation, tolerance):
        deviation = float(deviation)
        if not deviation <= self.worst.get(check, (-1.0,))[0]:
            self.worst[check] = (deviation, where, tolerance)
        self.check(check, where, deviation <= tolerance, f"{deviation:.1e} is more than {tolerance:.0e}")

    def condition(self, label, value):
        self.conditions[label] = max(self.conditions.get(label, 0.0), value)

    def answered(self, suite, contact):
        """Counts the route of a finite contact, as percuss_tests::routes does."""
        if contact["status"] != "finite":
            return
        why = contact["careful_reason"]
        by = "dense" if contact["route"] == "dense" else "kept" if why else "recursion"
        self.routes[suite][by] += 1
        if why:
            self.reasons[suite][why] += 1

    def keep(self, folder):
        program = Path(sys.argv[0])
        name = f"{program.parent.name}-{program.stem}" if program.parent.name != "external" else program.stem
        checks = []
        for check in sorted({*self.passed, *self.failed}):
            worst = self.worst.get(check)
            kept = worst and {"deviation": worst[0], "where": str(worst[1]), "limit": worst[2]}
            checks.append({"name": check, "passed": self.passed[check], "failed": self.failed[check], "worst": kept})
        (folder / f"{name}.tally.json").write_text(json.dumps({"program": name, "checks": checks}))

    def report(self, seconds):
        """Prints all results; returns the exit code. Keeps them for the validation report in the folder PERCUSS_VALIDATION."""
        if folder := os.environ.get("PERCUSS_VALIDATION"):
            self.keep(Path(folder))
        for check, lines in self.failures.items():
            print(f"\nFAILED: {check} ({len(lines)})")
            for line in lines[:SHOWN]:
                print(f"    {line}")
        print("\nchecks                                           passed   failed    worst    limit  where")
        for check in sorted({*self.passed, *self.failed}):
            worst = self.worst.get(check)
            tail = f"{worst[0]:9.1e}{worst[2]:9.0e}  {worst[1]}" if worst and worst[0] > 0 else ""
            print(f"{check:48}{self.passed[check]:7}{self.failed[check]:9}{tail}")
        if self.answers:
            print("\ncontacts            base       finite   immovable    massless     refused")
        for peer, base in sorted({key[:2] for key in self.answers}):
            counts = [self.answers[peer, base, status] for status in ("finite", "immovable", "massless", "refused")]
            print(f"{peer:20}{base:9}" + "".join(f"{count:8}    " for count in counts).rstrip())
        for (peer, status), count in sorted(self.undecided.items()):
            print(f"{peer}: {count} more answered {status} where rounding decides")
        if self.routes:
            print("\nfinite contacts         recursion    dense     kept  reasons for the dense route")
        for suite, counts in self.routes.items():
            why = ", ".join(f"{reason}: {count}" for reason, count in self.reasons[suite].most_common())
            line = f"{suite:22}{counts['recursion']:11}{counts['dense']:9}{counts['kept']:9}  {why}"
            print(line.rstrip())
        if self.conditions:
            print("\nworst conditions of M scaled to unit diagonal")
        for label, value in sorted(self.conditions.items(), key=lambda item: -item[1])[:6]:
            print(f"    {value:8.1e}  {label}")
        print(f"\n{seconds:.0f} s")
        print(f"{self.passed.total()} passed, {self.failed.total()} failed")
        return 1 if self.failed or not self.passed else 0
