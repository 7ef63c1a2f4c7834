"""Sweeps in several processes: the examples for Ray Data and Dask on a local cluster of two workers, one of which is
killed during the work.

    cluster.py --engine ray|dask [--rows N] [--files N] [--folder FOLDER]

Configurations are read from Parquet and masses are written to Parquet. Rows are compared with the plain call: as a
multiset of their numbers (no row lost, no row doubled), and m̄, error and status bitwise. Prints the times with and
without the kill, and the time of the plain call with the same reading and writing.
"""

from __future__ import annotations

import argparse
import importlib
import os
import shutil
import signal
import sys
import threading
import time
import types
from pathlib import Path

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq

import percuss

ROOT = Path(__file__).resolve().parents[2]
MODEL = ROOT / "models/six_r_arm.urdf"
CONTACT = percuss.Contact("tool", [0.08, 0.0, 0.0], [0.0, 1.0, 0.0])
WORKERS = 2
#: Seconds without a file after which the job counts as not started.
PATIENCE = 300.0


def write_rows(folder: Path, model: percuss.Model, rows: int, files: int) -> None:
    random = np.random.default_rng(0)
    for number, part in enumerate(np.array_split(np.arange(rows, dtype=np.int64), files)):
        columns = {"row": part} | {name: random.uniform(-2, 2, len(part)) for name in model.position_names}
        pq.write_table(pa.table(columns), folder / f"part-{number:04}.parquet")


def plain(model: percuss.Model, source: Path, target: Path) -> float:
    """One process with all its threads; file by file, with the batch size of the workers."""
    begun = time.perf_counter()
    assembly = model.assemble()
    target.mkdir()
    for path in sorted(source.iterdir()):
        table = pq.read_table(path)
        q = np.array([table[name].to_numpy() for name in model.position_names]).T
        swept = percuss.sweep(assembly, CONTACT, q)
        columns = {"row": table["row"], "effective_mass": swept.effective_mass, "error": swept.error, "status": swept.status}
        pq.write_table(pa.table(columns), target / path.name)
    return time.perf_counter() - begun


class Killer(threading.Thread):
    """Kills the worker of the first results."""

    def __init__(self, target: Path) -> None:
        super().__init__(daemon=True)
        self.target, self.over, self.pid, self.finished = target, threading.Event(), 0, 0

    def files(self) -> list[Path]:
        return [path for path in self.target.rglob("*.parquet") if path.stat().st_size] if self.target.exists() else []

    def run(self) -> None:
        begun = time.monotonic()
        while not self.over.is_set() and time.monotonic() - begun < PATIENCE:
            for path in self.files():
                try:
                    pid = int(pq.read_table(path, columns=["worker"])["worker"][0].as_py())
                except (OSError, pa.ArrowException, IndexError):
                    # The file is still being written.
                    continue
                self.finished = len(self.files())
                os.kill(pid, signal.SIGKILL)
                self.pid = pid
                return
            time.sleep(0.005)


def read(folder: Path) -> pa.Table:
    paths = sorted(folder.rglob("*.parquet"))
    return pa.concat_tables([pq.read_table(path, columns=["row", "effective_mass", "error", "status", *extra(path)]) for path in paths])


def extra(path: Path) -> list[str]:
    return [name for name in pq.read_schema(path).names if name == "worker"]


def compare(answered: pa.Table, expected: pa.Table, rows: int) -> None:
    """Compares the rows as a multiset, and every number bitwise."""
    found = answered["row"].to_numpy()
    counts = np.bincount(found, minlength=rows)
    lost, doubled = int((counts == 0).sum()), int((counts > 1).sum())
    assert len(found) == rows and lost == doubled == 0 and len(counts) == rows, f"{lost} rows are lost, {doubled} doubled"
    order, own = np.argsort(found, kind="stable"), np.argsort(expected["row"].to_numpy(), kind="stable")
    for name in ("effective_mass", "error", "status"):
        there, here = answered[name].to_numpy()[order], expected[name].to_numpy()[own]
        assert np.array_equal(there, here, equal_nan=name != "status"), f"{name} differs from the plain call"


def ran(engine: types.ModuleType, model: percuss.Model, source: Path, target: Path, batch: int) -> float:
    begun = time.perf_counter()
    if engine.__name__ == "ray_sweep":
        engine.sweep(model, CONTACT, str(source), str(target), workers=WORKERS, batch=batch)
    else:
        engine.sweep(model, CONTACT, str(source), str(target))
    return time.perf_counter() - begun


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--engine", choices=["ray", "dask"], required=True)
    parser.add_argument("--rows", type=int, default=10_000_000)
    parser.add_argument("--files", type=int, default=80)
    parser.add_argument("--folder", type=Path, default=ROOT / "target/external/cluster-rows")
    given = parser.parse_args()
    examples = str(ROOT / "crates/python/examples/cluster")
    sys.path.insert(0, examples)
    # The workers import the module too.
    os.environ["PYTHONPATH"] = os.pathsep.join(filter(None, [examples, os.environ.get("PYTHONPATH")]))
    engine = importlib.import_module(f"{given.engine}_sweep")
    shutil.rmtree(given.folder, ignore_errors=True)
    source = given.folder / "in"
    source.mkdir(parents=True)
    model = percuss.load(MODEL)
    write_rows(source, model, given.rows, given.files)
    alone = min(plain(model, source, given.folder / f"plain-{turn}") for turn in range(2))
    expected = read(given.folder / "plain-0")
    connection = engine.start(None, WORKERS)
    batch = -(-given.rows // given.files)
    # Includes the start of the workers: modules, the model.
    whole = ran(engine, model, source, given.folder / "whole", batch)
    answered = read(given.folder / "whole")
    compare(answered, expected, given.rows)
    workers = set(answered["worker"].to_numpy().tolist())
    assert len(workers) == WORKERS, f"{len(workers)} workers answered"
    killer = Killer(given.folder / "killed")
    killer.start()
    killed = ran(engine, model, source, given.folder / "killed", batch)
    killer.over.set()
    killer.join()
    answered = read(given.folder / "killed")
    compare(answered, expected, given.rows)
    assert killer.pid, "no worker was killed: the job was over before its first file was seen"
    written = len(list((given.folder / "killed").rglob("*.parquet")))
    assert killer.finished < written, f"all {written} files were written before the kill"
    after = set(answered["worker"].to_numpy().tolist())
    # The other results come from the other worker, or from a replacement.
    assert after - {killer.pid}, "only the killed worker answered"
    if connection is not None:
        connection.close()
    shutil.rmtree(given.folder)
    print(
        f"{given.engine}: {given.rows} rows in {given.files} files, {WORKERS} workers: {whole:.1f} s; plain call {alone:.1f} s (all threads); "
        f"overhead {whole / alone:.2f} times, {1e6 * (whole - alone) / given.rows:.2f} µs a row"
    )
    print(
        f"{given.engine}: worker {killer.pid} killed after {killer.finished} of {written} files: {killed:.1f} s, nothing lost, nothing doubled, "
        f"{len(after)} workers answered"
    )


if __name__ == "__main__":
    main()
