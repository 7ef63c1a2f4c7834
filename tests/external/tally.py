"""Counts what passed and what failed, and keeps the worst of each check."""

import collections
import sys

SHOWN = 5


class Tally:
    def __init__(self):
        self.passed, self.failed = collections.Counter(), collections.Counter()
        self.worst = {}
        self.statuses = collections.Counter()
        self.refused_mimic = {}
        self.conditions = {}
        self.failures = []

    def check(self, check, where, ok, message=""):
        (self.passed if ok else self.failed)[check] += 1
        if not ok:
            self.failures.append((check, where, message))

    def within(self, check, where, deviation, tolerance, condition=None):
        if not deviation <= self.worst.get(check, (-1.0,))[0]:
            self.worst[check] = (deviation, where, condition)
        if condition and condition<1e5 and not deviation <= self.worst.get(check+' well', (-1.0,))[0]:
            self.worst[check+' well'] = (deviation, where, condition)
        self.check(check, where, deviation <= tolerance, f"{deviation:.2e} > {tolerance:.0e} (condition {condition})")

    def condition(self, label, value):
        self.conditions[label] = max(self.conditions.get(label, 0), value)

    def status(self, peer, status, route):
        self.statuses[peer, status, route] += 1

    def report(self, seconds):
        by = collections.defaultdict(list)
        for check, where, message in self.failures:
            by[check].append(f"{where}: {message}")
        for check, lines in by.items():
            print(f"FAILED {check}: {len(lines)}")
            print("".join(f"    {l}\n" for l in lines[:SHOWN]))
        for check in sorted({*self.passed, *self.failed}):
            w = self.worst.get(check)
            print(f"{check:45} {self.passed[check]:7} {self.failed[check]:7} {w if w else ''}")
        print({k:v for k,v in self.worst.items() if 'well' in k});print(self.statuses)
        print(self.refused_mimic)
        print(sorted(self.conditions.items(), key=lambda kv: -kv[1])[:12])
        print(f"{seconds:.0f} s")
        print(f"{self.passed.total()} passed, {self.failed.total()} failed")
