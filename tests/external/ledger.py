"""What is said of each file: compared with ledger.json, so that a change is seen and nothing is skipped in silence.

An entry holds `diagnostics` (severity and code, and how many). A file that is refused has `refused` in the same form;
if an indefinite inertia is all that is wrong with it, also `accept`, and `diagnostics` when accepted. `peers` says
which of the other programs do not take the file, and why.
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
        """Asks for the file as the entry says. Returns whether to accept indefinite inertias; none: no mechanism."""
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
        """Compares what was found with the entries, or writes it."""
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
