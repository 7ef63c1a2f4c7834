#!/usr/bin/env bash
# Sweeps by Ray Data and by Dask on a local cluster of two workers, 10 million configurations each, a worker killed while it works: by
# hand. Takes the wheel that python.sh has built. Needs python3.11 to 3.13 and the first time the network (400 MB). Options go to cluster.py.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
cd "$here/../.."
work=$PWD/target/external/cluster
wheel=$(ls target/external/python/wheel/percuss-*.whl 2> /dev/null) || { echo "no wheel: run python.sh first"; exit 1; }
if ! cmp -s "$here/requirements-cluster.txt" "$work/requirements.txt"; then
  rm -rf "$work"
  python=python3
  for candidate in python3.11 python3.12 python3.13; do
    if "$candidate" -c 'import venv, ensurepip' 2> /dev/null; then python=$candidate && break; fi
  done
  "$python" -m venv "$work"
  "$work/bin/pip" install --quiet --disable-pip-version-check --requirement "$here/requirements-cluster.txt"
  cp "$here/requirements-cluster.txt" "$work/requirements.txt"
fi
"$work/bin/pip" install --quiet --disable-pip-version-check --no-deps --force-reinstall "$wheel"
export PYTHONDONTWRITEBYTECODE=1 RAY_USAGE_STATS_ENABLED=0
for engine in ray dask; do
  "$work/bin/python" "$here/cluster.py" --engine "$engine" "$@"
done
