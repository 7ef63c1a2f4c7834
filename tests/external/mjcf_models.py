"""Compares published MJCF models with MuJoCo, as mjcf.py does. A model passes if percuss and MuJoCo give the same effective mass at random
contacts, if percuss refuses it and names the unsupported part, or if mjcf_models.json lists its outcome with a reason. Models that MuJoCo
refuses, that do not move or that are too large are counted only.

    mjcf_models.py --percuss PATH                    packages gymnasium and mujoco, as run.sh does
    mjcf_models.py --percuss PATH --folder FOLDER... all models in the folders, for example clones of mujoco or menagerie
    mjcf_models.py --percuss PATH --install FOLDER   installs packages with many models (dm_control, gymnasium-robotics) in FOLDER

Prints the refused models, the failures, the counts of the outcomes, and `N passed, N failed`.
"""

import argparse
import collections
import concurrent.futures
import importlib.util
import json
import os
import pathlib
import re
import subprocess
import sys

import numpy as np

from mjcf import MESH_TOLERANCE, TOLERANCE, Peer, compare_file, run

# Packages of --install, in the versions for which mjcf_models.json is valid.
PACKAGES = ["dm_control==1.0.50", "gymnasium==1.4.0", "gymnasium-robotics==1.4.2"]
# Models with more coordinates than this take minutes.
MOST_COORDINATES = 120
# Codes and words of errors that name the unsupported element or value.
CODES = {"unsupported", "implausible-inertia", "bad-mesh", "no-worldbody", "too-complex", "indefinite-inertia"}
WORDS = re.compile("unsupported|not read|not computed|no such|belongs to|refuse|deformable|replicate")
# Expected counts of the outcomes without --folder and --install.
EXPECTED = {"equal": 15}
FAILURES = {"deviates", "no result", "refused", "out of reach", "singular"}


def install(folder):
    command = [sys.executable, "-m", "pip", "install", "--quiet", "--no-deps", "--upgrade", "--target", str(folder), *PACKAGES]
    subprocess.run(command, check=True)
    return folder


def package_folders():
    for name in ("gymnasium", "mujoco"):
        yield pathlib.Path(importlib.util.find_spec(name).origin).parent


def models(folder):
    """MJCF files of a folder; parts that other files include have another root or no world."""
    for path in sorted(folder.rglob("*.xml")):
        try:
            text = path.read_text(errors="replace")
        except OSError:
            continue
        if re.search(r"<mujoco[\s>]", text) and "<worldbody" in text:
            yield path


def outcome(percuss, path, contacts):
    """Outcome: (kind, text)."""
    try:
        peer = Peer(path)
    except (ValueError, RuntimeError, UnicodeDecodeError) as error:
        return "refused by MuJoCo", str(error).splitlines()[0]
    if peer.model.nv == 0 or not peer.contact_links():
        return "without motion", ""
    if peer.model.nv > MOST_COORDINATES:
        return "large", f"{peer.model.nv} coordinates"
    check = run(percuss, "check", str(path), "--format", "json")
    if check.returncode:
        # Codes are at the ends of the errors.
        words = " ".join(check.stderr.split())
        code = re.search(r"error: .*?\[([a-z-]+)\]", words)
        is_named = (code and code[1] in CODES) or WORDS.search(words)
        return ("refused by name" if is_named else "refused"), words[words.find("error:") :][:200]
    try:
        answer = compare_file(percuss, str(path), np.random.default_rng(0), contacts, peer=peer)
    except np.linalg.LinAlgError:
        return "singular", "the reduced mass matrix of MuJoCo"
    except (ValueError, KeyError) as error:
        return "no result", f"{type(error).__name__}: {error}"
    if isinstance(answer, str):
        return "no result", answer
    deviations, unreachable = answer
    if not deviations:
        return "out of reach", f"{unreachable} poses"
    worst = max(deviation for deviation, _ in deviations)
    limit = MESH_TOLERANCE if peer.uses_mesh() else TOLERANCE
    return ("equal" if worst <= limit else "deviates"), f"{worst:.1e}"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--percuss", required=True)
    parser.add_argument("--folder", nargs="*", type=pathlib.Path, default=[])
    parser.add_argument("--install", type=pathlib.Path)
    parser.add_argument("--contacts", type=int, default=4, help="number of random contacts, each at a random pose, per model")
    parser.add_argument("--verbose", action="store_true")
    options = parser.parse_args()
    ledger = json.loads(pathlib.Path(__file__).with_suffix(".json").read_text())
    folders = [*options.folder, *([install(options.install)] if options.install else [])]
    counts, failures = collections.Counter(), []
    for folder in folders or package_folders():
        paths = list(models(folder))
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            results = pool.map(lambda path: outcome(options.percuss, path, options.contacts), paths)
            for path, (kind, text) in zip(paths, results):
                name = path.relative_to(folder).as_posix()
                is_known = any(name.endswith(entry["model"]) and entry["outcome"] == kind for entry in ledger)
                counts[f"{kind} (ledger)" if is_known else kind] += 1
                if options.verbose or kind == "refused by name":
                    print(f"{kind:18} {name} {text}", flush=True)
                if kind in FAILURES and not is_known:
                    failures.append(f"{name}: {kind}: {text}")
    if not folders and dict(counts) != EXPECTED:
        failures.append(f"{dict(counts)}, expected {EXPECTED}")
    print("\n".join(failures))
    print(f"models of MJCF: {dict(counts)}")
    print(f"{sum(counts.values()) - len(failures)} passed, {len(failures)} failed")
    sys.exit(bool(failures))


if __name__ == "__main__":
    main()
