"""Licences and sources of the dependencies by the rules of deny.toml, without a network and without cargo-deny.

    python3 tests/dependencies.py [TRIPLE]        exit 1 with each dependency that the rules do not allow

Advisories need their database: `cargo deny check advisories`.
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


def main():
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
