"""The sweep of ray_sweep.py with Dask: the partitions of the table are tasks of its scheduler.

    dask_sweep.py MODEL.urdf LINK X,Y,Z NX,NY,NZ IN OUT [--workers N] [--address ADDRESS]
"""

from __future__ import annotations

import argparse
import os
import time
from functools import lru_cache

import dask
import dask.dataframe
import numpy as np
import pandas as pd
from dask.distributed import Client, LocalCluster

import percuss

META = {"row": "int64", "effective_mass": "float64", "error": "float64", "status": "uint8", "worker": "int32"}


@lru_cache(maxsize=1)
def assembly(text: str) -> percuss.Assembly:
    """Assembly of a worker, built once."""
    return percuss.loads(text).assemble()


def answer(part: pd.DataFrame, text: str, contact: percuss.Contact) -> pd.DataFrame:
    made = assembly(text)
    q = np.asfortranarray(part[made.model.position_names].to_numpy(dtype=np.float64))
    swept = percuss.sweep(made, contact, q)
    return pd.DataFrame(
        {
            "row": part["row"].to_numpy(),
            "effective_mass": swept.effective_mass,
            "error": swept.error,
            "status": swept.status,
            "worker": np.full(len(swept), os.getpid(), dtype=np.int32),
        }
    )


def sweep(model: percuss.Model, contact: percuss.Contact, source: str, target: str) -> None:
    """Runs on the workers of the connected client. If a worker dies, its task runs again elsewhere and writes the
    same file."""
    table = dask.dataframe.read_parquet(source, split_row_groups=False)
    answered = table.map_partitions(answer, model.to_urdf(), contact, meta=pd.DataFrame(columns=list(META)).astype(META))
    answered.to_parquet(target, write_index=False)


def start(address: str | None, workers: int) -> Client:
    if address:
        return Client(address)
    os.environ["RAYON_NUM_THREADS"] = "1"
    return Client(LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=None))


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
    parser.add_argument("--address")
    given = parser.parse_args()
    with start(given.address, given.workers):
        model, contact = percuss.load(given.model), percuss.Contact(given.link, given.point, given.normal)
        begun = time.perf_counter()
        sweep(model, contact, given.source, given.target)
        print(f"{time.perf_counter() - begun:.1f} s")


if __name__ == "__main__":
    main()
