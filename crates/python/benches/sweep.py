"""percuss.sweep on (1,000,000, p), or as many rows as given, compared with the same batch in Rust: CPU time of all threads, in turns on the same
machine. Rust writes its results into a new vector, as Python does into new arrays, and into a reused vector, which
shows the cost of allocation.

    cargo bench -p percuss-python --no-run      prints the program's path
    sweep.py PROGRAM [ROWS]                     prints the median over turns of the best of five runs each, and the ratios
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
COUNT = int(sys.argv[2]) if len(sys.argv) > 2 else 1_000_000
TURNS = 9
REPETITIONS = 5

CASES = [
    ("six_r_arm", "tool", (0.08, 0.0, 0.0), (0.0, 1.0, 0.0)),
    ("double_wishbone", "wheel_centre", (0.0, 0.0, 0.0), (0.0, 0.0, -1.0)),
    ("slider_crank", "slider", (0.0, 0.0, 0.0), (1.0, 0.0, 0.0)),
]


def configurations(model: percuss.Model) -> np.ndarray:
    """Random configurations of a tree; for a linkage, a few closed configurations in repetition."""
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
        spent: dict[str, list[float]] = {"Rust, new": [], "Rust, kept": [], "Python": [], "Python, F order": []}
        with tempfile.NamedTemporaryFile() as file:
            q.tofile(file.name)
            words = [sys.argv[1], str(path), link, ",".join(map(str, point)), ",".join(map(str, normal)), file.name]
            for _ in range(TURNS):
                ran = subprocess.run(words, capture_output=True, text=True, check=True)
                for what, seconds in zip(("Rust, new", "Rust, kept"), ran.stdout.split()):
                    spent[what].append(float(seconds))
                for what, array in (("Python", q), ("Python, F order", by_columns)):
                    best = np.inf
                    for _ in range(REPETITIONS):
                        begun = time.process_time()
                        percuss.sweep(assembly, contact, array)
                        best = min(best, time.process_time() - begun)
                    spent[what].append(best)
        median = {what: float(np.median(seconds)) for what, seconds in spent.items()}
        times = ", ".join(f"{what} {1e3 * seconds:.1f} ms" for what, seconds in median.items())
        ratios = [median["Python"] / median[what] for what in ("Rust, new", "Rust, kept")]
        print(f"{name}: {times}; Python over Rust {ratios[0]:.3f} (new), {ratios[1]:.3f} (kept)")


if __name__ == "__main__":
    main()
