"""Published models in MJCF compared with MuJoCo: every model that both programs read gives the same effective mass at random contacts,
is refused by percuss by name, or is in the ledger (corpora.json) with a reason. Models are not part of the project: `--install FOLDER`
installs the packages that contain them; further folders, such as clones of repositories, are arguments.

    corpora.py --percuss PATH --install FOLDER [FOLDER...]

Prints one line for each model that deviates or fails, and the counts.
"""

import argparse
import collections
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys

import numpy as np

from mjcf import MESH_TOLERANCE, TOLERANCE, Peer, compare_file

# Packages with models in MJCF; the versions for which the ledger holds.
PACKAGES = ["dm_control==1.0.50", "gymnasium==1.4.0", "gymnasium-robotics==1.4.2"]
CONTACTS = 3
# Codes of refusals that name an element or a value without a form in a mechanism.
BY_NAME = {"unsupported", "implausible-inertia", "bad-mesh", "no-worldbody", "too-complex", "indefinite-inertia"}


def install(folder):
    target = pathlib.Path(folder)
    command = [sys.executable, "-m", "pip", "install", "--quiet", "--no-deps", "--upgrade", "--target", str(target), *PACKAGES]
    subprocess.run(command, check=True)
    return target


def models(folder):
    """MJCF files of a folder; parts that other files include have another root or no world."""
    for path in sorted(pathlib.Path(folder).rglob("*.xml")):
        try:
            text = path.read_text(errors="replace")
        except OSError:
            continue
        if re.search(r"<mujoco[\s>]", text) and "<worldbody" in text:
            yield path


def outcome(percuss, path):
    """Kind of outcome and a text."""
    try:
        peer = Peer(path)
    except (ValueError, RuntimeError, UnicodeDecodeError) as error:
        return "refused by MuJoCo", str(error).splitlines()[0]
    if not peer.model.nv:
        return "without joints", ""
    check = subprocess.run([percuss, "check", str(path), "--format", "json"], capture_output=True, text=True)
    if check.returncode:
        # Codes at the ends of the errors; the first words of a wrapped message are enough for a ledger.
        words = " ".join(check.stderr.split())
        code = re.search(r"error: .*?\[([a-z-]+)\]", words)
        shown = words[words.find("error:") :][:200]
        named = (code and code[1] in BY_NAME) or re.search(r"unsupported|not read|not computed|no such|belongs to|refuse|deformable|replicate", words)
        return ("refused by name" if named else "refused"), shown
    try:
        answer = compare_file(percuss, str(path), np.random.default_rng(1), CONTACTS, peer=peer)
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
    parser.add_argument("--install")
    parser.add_argument("folders", nargs="*")
    arguments = parser.parse_args()
    folders = list(arguments.folders)
    if arguments.install:
        folders.insert(0, install(arguments.install))
    ledger = json.loads((pathlib.Path(__file__).parent / "corpora.json").read_text())
    counts, failed = collections.Counter(), 0
    for folder in folders:
        paths = list(models(folder))
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            results = pool.map(lambda path: outcome(arguments.percuss, path), paths)
            for path, (kind, text) in zip(paths, results):
                name = path.relative_to(folder).as_posix()
                known = next((entry for entry in ledger if name.endswith(entry["model"]) and entry["outcome"] == kind), None)
                counts[f"{kind} (ledger)" if known else kind] += 1
                if kind in ("deviates", "no result", "refused", "out of reach", "singular") and not known:
                    failed += 1
                    print(f"FAILED {name}: {kind}: {text}", flush=True)
                elif kind == "refused by name":
                    print(f"{name}: {kind}: {text}", flush=True)
    print(", ".join(f"{count} {kind}" for kind, count in sorted(counts.items())))
    print(f"{sum(counts.values()) - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    raise SystemExit(main())
