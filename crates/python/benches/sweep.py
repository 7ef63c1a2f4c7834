"""percuss.sweep on (1,000,000, p) beside the same batch in Rust: CPU time of all threads, in turns on the same machine.

    cargo bench -p percuss-python --no-run      prints the program's path
    sweep.py PROGRAM                            prints the best of some runs each, and the ratio
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
import time
import warnings
from pathlib import Path

import numpy as np

import percuss

ROOT = Path(__file__).resolve().parents[3]
COUNT = 1_000_000
TURNS = 4

CASES = [
    ("six_r_arm", "tool", (0.08, 0.0, 0.0), (0.0, 1.0, 0.0)),
    ("double_wishbone", "wheel_centre", (0.0, 0.0, 0.0), (0.0, 0.0, -1.0)),
    ("slider_crank", "slider", (0.0, 0.0, 0.0), (1.0, 0.0, 0.0)),
]


def configurations(model: percuss.Model) -> np.ndarray:
    """Random ones of a tree; of a linkage closed ones, again and again."""
    drivers = model.assemble().drivers
    if not drivers:
        return np.random.default_rng(0).uniform(-1, 1, (COUNT, model.position_count))
    few = [model.pose({drivers[0]: value}).positions for value in np.linspace(0, 0.1, 250)]
    return np.tile(np.array(few), (COUNT // len(few), 1))


def main() -> None:
    warnings.simplefilter("ignore", percuss.ModelWarning)
    for name, link, point, normal in CASES:
        path = ROOT / f"models/{name}.urdf"
        model = percuss.load(path)
        q, contact = configurations(model), percuss.Contact(link, point, normal)
        by_columns, assembly = np.asfortranarray(q), model.assemble()
        best = {"Rust": np.inf, "Python": np.inf, "Python, F order": np.inf}
        with tempfile.NamedTemporaryFile() as file:
            q.tofile(file.name)
            words = [sys.argv[1], str(path), link, ",".join(map(str, point)), ",".join(map(str, normal)), file.name]
            for _ in range(TURNS):
                ran = subprocess.run(words, capture_output=True, text=True, check=True)
                best["Rust"] = min(best["Rust"], float(ran.stdout))
                for what, array in (("Python", q), ("Python, F order", by_columns)):
                    for _ in range(5):
                        begun = time.process_time()
                        percuss.sweep(assembly, contact, array)
                        best[what] = min(best[what], time.process_time() - begun)
        times = ", ".join(f"{what} {1e3 * seconds:.1f} ms" for what, seconds in best.items())
        print(f"{name}: {times}; Python over Rust {best['Python'] / best['Rust']:.3f}")


if __name__ == "__main__":
    main()
