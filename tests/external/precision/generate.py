"""Writes tests/data/precision/*.json: `python generate.py [FAMILY…]`. `--self-test` tests the mechanics instead,
`--conditions` prints the condition of the questions. See README.md in this folder."""

import json
import sys
import time
from pathlib import Path

from mpmath import mp, mpf

import families
import self_test
from mechanics import Mechanism, Position, closed, masses
from spatial import FAMILIES

OUT = Path(__file__).resolve().parents[2] / "data" / "precision"


def position(rows, case):
    mechanism = Mechanism(rows, case["count"])
    drivers = {i: mpf(float(q)) if isinstance(q, str) else q for i, q in case["drivers"].items()}
    if case["guess"]:
        return closed(mechanism, drivers, case["guess"], case["floating"])
    return Position(mechanism, drivers, case["floating"])


def check(case, found):
    """Checks that the solution is on the requested branch."""
    for i, guess in case["guess"].items():
        bound = abs(case.get("near", mpf(1))) / 4
        assert abs(found.q[i] - guess) < min(bound, mpf(10) ** -6), (case["group"], case["seed"], i)


def written(x):
    """25 digits and a power of ten."""
    power = int(mp.floor(mp.log10(x)))
    return f"{mp.nstr(x / mpf(10) ** power, 25, strip_zeros=False)}e{power}"


def fixture(family):
    contacts, groups = {}, {}
    for case in family.cases:
        found = position(family.mechanisms[case["mechanism"]], case)
        check(case, found)
        answers = []
        for c, m in zip(case["contacts"], masses(found, case["contacts"])):
            if m is not None:
                against = -1 if c["against"] is None else c["against"]
                toward = () if c["toward"] is None else (c["toward"],)
                key = (c["on"], against, c["point"], c["normal"], int(c["world"]), *toward)
                answers.append([contacts.setdefault(key, len(contacts)), written(m)])
        row = {"seed": case["seed"], "of": case["mechanism"]}
        if case["count"] is not None:
            row["count"] = case["count"]
        if case["floating"]:
            row["floating"] = True
        if "near" in case:
            row["near"] = float(f"{float(case['near']):.3e}")
        values = [case["drivers"].get(i) or families.exact(found.q[i]) for i in found.mechanism.moving()]
        groups.setdefault(case["group"], []).append({**row, "values": " ".join(values), "masses": answers})
    for rows in family.mechanisms:
        rows["joints"] = [row[:-1] if row[-1] == "" else row for row in rows["joints"]]
    return family.mechanisms, list(contacts), groups


def listed(rows):
    return ",\n".join(json.dumps(row, separators=(",", ":")) for row in rows)


def main():
    names = [a for a in sys.argv[1:] if not a.startswith("-")]
    if "--self-test" in sys.argv:
        self_test.run(position)
        return
    if "--conditions" in sys.argv:
        self_test.conditions(position)
        return
    OUT.mkdir(parents=True, exist_ok=True)
    for name in names or FAMILIES:
        began = time.time()
        mechanisms, contacts, groups = fixture(FAMILIES[name]())
        inside = ",\n".join(f"{json.dumps(group)}:[\n{listed(cases)}]" for group, cases in groups.items())
        path = OUT / f"{name}.json"
        path.write_text(f'{{"mechanisms":[\n{listed(mechanisms)}],\n"contacts":[\n{listed(contacts)}],\n'
                        f'"groups":{{\n{inside}}}}}\n')
        cases = [case for some in groups.values() for case in some]
        count = sum(len(case["masses"]) for case in cases)
        print(f"{name}: {len(cases)} cases, {count} contacts, {path.stat().st_size} bytes, "
              f"{time.time() - began:.0f} s", flush=True)


if __name__ == "__main__":
    main()
