"""Licences, sources and advisories of the dependencies by the rules of deny.toml, without cargo-deny.

    python3 tests/dependencies.py [TRIPLE]                      exit 1 with each dependency that the rules do not allow
    python3 tests/dependencies.py --advisories FOLDER           the same for all entries of Cargo.lock, by a clone of
                                                                https://github.com/rustsec/advisory-db

Without the clone advisories are not checked: tests run without a network. Yanked versions are not checked here; `cargo deny check` does.
"""

import json
import pathlib
import re
import subprocess
import sys
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent


def allowed(expression, licences):
    """Whether an SPDX expression holds with these licences; the slash of old manifests is OR."""
    words = re.findall(r"[()]|AND|OR|[\w.+-]+(?: WITH [\w.-]+)?", expression.replace("/", " OR "))
    text = " ".join(w.lower() if w in ("AND", "OR") else w if w in "()" else str(w in licences) for w in words)
    return bool(eval(text, {"__builtins__": {}}))  # of True, False, and, or, parentheses alone


def version(text):
    """Major, minor and patch, then what orders a pre-release before its release."""
    text = text.strip().split("+")[0]
    numbers, _, before = text.partition("-")
    parts = [int(part) for part in numbers.split(".")]
    return (*(parts + [0, 0, 0])[:3], before == "", before)


def holds(requirement, found):
    """Whether a version meets a requirement of an advisory, such as ">= 1.2.3, < 2"; a bare version is ^version."""
    for part in requirement.split(","):
        operator, text = re.fullmatch(r"\s*(>=|<=|>|<|=|\^|~)?\s*(\S+)\s*", part).groups()
        wanted, (major, minor, patch) = version(text), version(text)[:3]
        if operator in (None, "^", "~"):
            if operator == "~" or major == 0 and minor > 0:
                end = (major, minor + 1, 0)
            else:
                end = (major + 1, 0, 0) if major > 0 else (0, 0, patch + 1)
            met = found >= wanted and found[:3] < end
        else:
            met = {">=": found >= wanted, "<=": found <= wanted, ">": found > wanted, "<": found < wanted, "=": found == wanted}[operator]
        if not met:
            return False
    return True


def advisories(folder):
    """Exit 1 with each vulnerability or unsound version among the entries of Cargo.lock; those without a fix are told only."""
    packages = tomllib.loads((ROOT / "Cargo.lock").read_text())["package"]
    accepted = {ignored["id"] for ignored in tomllib.loads((ROOT / "deny.toml").read_text())["advisories"]["ignore"]}
    read, faults, told = 0, [], []
    for package in packages:
        for path in sorted((folder / "crates" / package["name"]).glob("*.md")):
            text = path.read_text()
            advisory = tomllib.loads(text[text.index("```toml") + 7 : text.index("```", text.index("```toml") + 7)])
            read += 1
            head, versions, found = advisory["advisory"], advisory["versions"], version(package["version"])
            safe = versions.get("patched", []) + versions.get("unaffected", [])
            if head.get("withdrawn") or any(holds(requirement, found) for requirement in safe):
                continue
            line = f"{package['name']} {package['version']}: {head['id']} {head.get('informational', 'vulnerability')}"
            if head["id"] in accepted:
                continue
            (told if head.get("informational") in ("unmaintained", "notice") else faults).append(line)
    print("\n".join(faults + told))
    print(f"{len(packages)} packages, {read} advisories: {len(faults)} to mend, {len(told)} unmaintained, accepted by deny.toml: {', '.join(sorted(accepted))}")
    if not read:
        sys.exit(f"{folder} has no advisory for any package; expected a clone of rustsec/advisory-db")
    sys.exit(bool(faults))


def main():
    if sys.argv[1:2] == ["--advisories"]:
        advisories(pathlib.Path(sys.argv[2]))
    rules = tomllib.loads((ROOT / "deny.toml").read_text())
    triple = sys.argv[1:2] or [re.search(r"host: (.*)", subprocess.check_output(["rustc", "-vV"], text=True))[1]]
    command = ["cargo", "metadata", "--locked", "--offline", "--format-version", "1", "--filter-platform", *triple]
    packages = json.loads(subprocess.check_output(command, cwd=ROOT))["packages"]
    exceptions = {e["crate"]: e["allow"] for e in rules["licenses"]["exceptions"]}
    registries = ["registry+" + url for url in rules["sources"]["allow-registry"]]
    faults = []
    for package in packages:
        name = f"{package['name']} {package['version']}"
        licences = rules["licenses"]["allow"] + exceptions.get(package["name"], [])
        if not package["license"] or not allowed(package["license"], licences):
            faults.append(f"{name}: licence {package['license']}; allowed are those of deny.toml")
        if package["source"] not in [None, *registries]:
            faults.append(f"{name}: source {package['source']}; allowed is crates.io")
    print("\n".join(faults) or f"{len(packages)} dependencies: licences and sources are allowed")
    sys.exit(bool(faults))


main()
