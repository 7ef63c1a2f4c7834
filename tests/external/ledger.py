"""Findings for each file, compared with ledger.json: every change is visible, and no file is skipped silently.

An entry holds `diagnostics` (severity and code, with counts). A refused file has `refused` in the same form; if an
indefinite inertia is its only error, also `accept`, and `diagnostics` after acceptance. `peers` lists the other
programs that do not accept the file, with the reasons.
"""

import collections
import json
from pathlib import Path

PATH = Path(__file__).resolve().parent / "ledger.json"
INDEFINITE = "indefinite-inertia"


class Ledger:
    def __init__(self, update):
        self.update = update
        self.entries = json.loads(PATH.read_text()) if PATH.exists() else {}
        self.found = {}

    def load(self, name, ask):
        """Loads the file as its entry states. Returns True if indefinite inertias are accepted; None without a
        mechanism."""
        plain = ask(False)
        found = self.found[name] = {}
        if plain["loaded"]:
            found["diagnostics"] = counted(plain)
            return False
        found["refused"] = counted(plain)
        listed = "accept" in self.entries.get(name, {})
        only_indefinite = {d["code"] for d in plain["diagnostics"] if d["severity"] == "error"} == {INDEFINITE}
        if not (listed or self.update and only_indefinite):
            return None
        accepted = ask(True)
        if accepted["loaded"]:
            found |= {"accept": [INDEFINITE], "diagnostics": counted(accepted)}
        return True if accepted["loaded"] else None

    def refused_by(self, name, peer, reason):
        self.found[name].setdefault("peers", {})[peer] = str(reason)

    def close(self, tally, everything):
        """Compares the findings with the entries, or writes the entries."""
        if self.update and everything:
            PATH.write_text(json.dumps(self.found, indent=1) + "\n")
            self.entries = self.found
        for name, found in self.found.items():
            entry = self.entries.get(name)
            tally.check("as in the ledger", name, found == entry, f"found {found}, in the ledger {entry}")
        if everything:
            for name in self.entries.keys() - self.found.keys():
                tally.check("as in the ledger", name, False, "in the ledger, but there is no such file")


def counted(answer):
    found = collections.Counter(f"{d['severity']} {d['code']}" for d in answer["diagnostics"])
    return dict(sorted(found.items()))
