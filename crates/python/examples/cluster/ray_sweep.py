"""m̄ of a contact at the rows of a Parquet table, distributed by Ray Data: each worker receives the model once, then
one batch after another.

    ray_sweep.py MODEL.urdf LINK X,Y,Z NX,NY,NZ IN OUT [--workers N] [--batch ROWS] [--address ADDRESS]

IN has a column "row" that names each row, and a column for each position of the model (Model.position_names), rad, m. OUT gets "row",
"effective_mass" (kg; NaN unless finite), "error" (kg), "status" (0 finite, 1 immovable, 2 massless, 3 no answer) and "worker" (a
process). Without an address the cluster is this machine. Without --batch a task has as many rows as take about a second, measured at the
first rows of the table: starting and writing a task takes some tenths of a second.
"""

from __future__ import annotations

import argparse
import logging
import os
import time

import numpy as np
import pyarrow.dataset
import ray
import ray.data
from numpy.typing import NDArray

import percuss


#: Time of a task, s; rows from which it is estimated; least and most rows of a task: a hundred megabytes for some ten columns.
TASK, SAMPLE, ROWS = 1.0, 4096, (1 << 10, 1 << 20)


def rows_of_task(model: percuss.Model, contact: percuss.Contact, source: str) -> int:
    """Rows that one processor computes in about TASK."""
    sample = pyarrow.dataset.dataset(source).head(SAMPLE, columns=model.position_names)
    q = np.array([sample[name].to_numpy() for name in model.position_names], dtype=np.float64).T
    assembly, rows, begun = model.assemble(), 0, time.perf_counter()
    # The first call compiles the mechanism.
    percuss.sweep(assembly, contact, q[:1], threads=1)
    while rows == 0 or time.perf_counter() - begun < 0.1:
        percuss.sweep(assembly, contact, q, threads=1)
        rows += max(len(q), 1)
    per_row = (time.perf_counter() - begun) / rows
    return int(np.clip(TASK / per_row, *ROWS))


class Sweeper:
    """Worker with its own assembly, built once."""

    def __init__(self, model: percuss.Model, contact: percuss.Contact) -> None:
        self.assembly, self.contact, self.columns = model.assemble(), contact, model.position_names

    def __call__(self, batch: dict[str, NDArray[np.generic]]) -> dict[str, NDArray[np.generic]]:
        # Column by column, as in Parquet: the fastest layout.
        q = np.array([batch[name] for name in self.columns], dtype=np.float64).T
        swept = percuss.sweep(self.assembly, self.contact, q)
        worker = np.full(len(swept), os.getpid(), dtype=np.int32)
        return {
            "row": batch["row"],
            "effective_mass": swept.effective_mass,
            "error": swept.error,
            "status": swept.status,
            "worker": worker,
        }


def sweep(
    model: percuss.Model,
    contact: percuss.Contact,
    source: str,
    target: str,
    *,
    workers: int,
    batch: int | None = None,
) -> None:
    """Runs on a number of workers. A dead worker is replaced, and its task runs again: every file of the table has a
    fixed name, so no file is doubled. batch: rows per task and per output file; None: rows_of_task."""
    batch = rows_of_task(model, contact, source) if batch is None else batch
    # Small files are read together; without repartition, one worker might receive all rows.
    table = ray.data.read_parquet(source).repartition(target_num_rows_per_block=batch)
    answered = table.map_batches(
        Sweeper,
        fn_constructor_args=(model, contact),
        batch_size=batch,
        batch_format="numpy",
        compute=ray.data.ActorPoolStrategy(size=workers),
        num_cpus=1,
    )
    answered.write_parquet(target)


def start(address: str | None, workers: int) -> None:
    """A worker has one processor and uses no more."""
    environment = {"env_vars": {"RAYON_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}}
    logging.getLogger("ray.data").setLevel(logging.WARNING)
    # Reading and writing need two more places.
    local = {} if address else {"num_cpus": workers + 2, "include_dashboard": False}
    ray.init(address=address, runtime_env=environment, log_to_driver=False, **local)


def triple(text: str) -> list[float]:
    return [float(x) for x in text.split(",")]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("model", "link"):
        parser.add_argument(name)
    for name in ("point", "normal"):
        parser.add_argument(name, type=triple)
    for name in ("source", "target"):
        parser.add_argument(name)
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--batch", type=int)
    parser.add_argument("--address")
    given = parser.parse_args()
    start(given.address, given.workers)
    model, contact = percuss.load(given.model), percuss.Contact(given.link, given.point, given.normal)
    begun = time.perf_counter()
    sweep(model, contact, given.source, given.target, workers=given.workers, batch=given.batch)
    print(f"{time.perf_counter() - begun:.1f} s")


if __name__ == "__main__":
    main()
