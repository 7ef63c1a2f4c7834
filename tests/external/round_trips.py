"""Round trips of random models of mjcf.py: MJCF to URDF+, URDF+ to MJCF, and MJCF to SDFormat, by `percuss convert`. The effective mass
of the written file is that of the source, or the error names an element.

    round_trips.py --percuss PATH [--count N]    prints `N passed, N failed`
"""

import argparse
import collections
import json
import os
import re
import sys
import tempfile

import numpy as np

from mjcf import RandomModel, run

# Rounding of rotations as roll, pitch and yaw, and of fullinertia.
TOLERANCE = 1e-12
# Difference of positions, rad or m, below which two poses are equal. A linkage that is open as drawn is closed by moving joints that the
# reader selects, so the poses of two files can differ.
SAME_POSE = 1e-9
# Number of random models of the default run, and the expected numbers of outcomes.
COUNT = 200
EXPECTED = {
    "urdf compared": 179,
    "urdf same status": 21,
    "mjcf compared": 178,
    "mjcf same status": 21,
    "mjcf other pose": 1,
    "sdf compared": 29,
    "sdf same status": 7,
    "sdf refused": 164,
}


def report(percuss, path, contact):
    """Report of the contact; None without one."""
    answer = run(percuss, "mass", path, *contact, "--format", "json")
    return None if answer.returncode == 2 else json.loads(answer.stdout)


def same_pose(first, second):
    common = set(first["pose"]) & set(second["pose"])
    return all(np.abs(np.subtract(first["pose"][joint], second["pose"][joint])).max() < SAME_POSE for joint in common)


def compare(source, written):
    """Outcome of a written file: (kind, deviation)."""
    if written is None:
        return "not read", 1.0
    if not same_pose(source, written):
        return "other pose", 0.0
    if source["status"] != written["status"]:
        return "other status", 1.0
    if source["status"] != "finite":
        return "same status", 0.0
    return "compared", abs(written["effective_mass"] / source["effective_mass"] - 1)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--percuss", required=True)
    parser.add_argument("--count", type=int, default=COUNT)
    options = parser.parse_args()
    counts, failures, worst = collections.Counter(), [], 0.0
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(options.count):
            model, rng = RandomModel(seed), np.random.default_rng(seed)
            source = os.path.join(folder, f"{seed}.xml")
            model.write(source)
            point, normal = (",".join(f"{x:.3f}" for x in rng.uniform(-1, 1, 3)) for _ in range(2))
            contact = ["--link", str(rng.choice(model.bodies)), f"--point={point}", f"--normal={normal}"]
            expected = report(options.percuss, source, contact)
            if expected is None:
                counts["source refused"] += 1
                continue
            urdf = os.path.join(folder, f"{seed}.urdf")
            for origin, ending in [(source, "urdf"), (urdf, "mjcf"), (source, "sdf")]:
                path = os.path.join(folder, f"{seed}_back.xml") if ending == "mjcf" else f"{folder}/{seed}.{ending}"
                converted = run(options.percuss, "convert", origin, "--to", ending, "-o", path)
                if converted.returncode:
                    counts[f"{ending} refused"] += 1
                    if not re.search(r'(link|loop|joint|coupling) "', " ".join(converted.stderr.split())):
                        failures.append(f"{seed} as {ending}: the refusal names no element: {converted.stderr[-200:]}")
                    continue
                kind, deviation = compare(expected, report(options.percuss, path, contact))
                counts[f"{ending} {kind}"] += 1
                worst = max(worst, deviation)
                if not deviation <= TOLERANCE:
                    failures.append(f"{seed} as {ending}: {kind}, deviation {deviation:.1e}")
    if options.count == COUNT and dict(counts) != EXPECTED:
        failures.append(f"{dict(counts)}, expected {EXPECTED}")
    print("\n".join(failures))
    print(f"round trips: {dict(counts)}; largest deviation {worst:.1e}")
    print(f"{sum(counts.values()) - len(failures)} passed, {len(failures)} failed")
    sys.exit(bool(failures))


if __name__ == "__main__":
    main()
