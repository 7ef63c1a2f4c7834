#!/usr/bin/env bash
# Sweeps on a local cluster of two workers, 10 million configurations, with a worker killed during the work: by Ray
# Data, and by Dask. Uses the wheel built by python.sh. Needs python3.11 to 3.13 and, the first time, the network (400
# MB).
#   cluster.sh [--prepare | [ray|dask] [OPTION OF cluster.py...]]     --prepare: only creates the environment; without an engine: both
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
cd "$here/../.."
. "$here/environment.sh"
engines=(ray dask)
case ${1-} in
  ray | dask) engines=("$1") && shift ;;
esac
work=$PWD/target/external/cluster
environment "$work" "$(first python3.11 python3.12 python3.13)" "$here/requirements-cluster.txt"
[ "${1-}" != --prepare ] || exit 0
wheel=$(ls target/external/python/wheel/percuss-*.whl 2> /dev/null) || { echo "no wheel: run python.sh first"; exit 1; }
"$work/bin/pip" install --quiet --disable-pip-version-check --no-deps --force-reinstall "$wheel"
export PYTHONDONTWRITEBYTECODE=1 RAY_USAGE_STATS_ENABLED=0
for engine in "${engines[@]}"; do
  "$work/bin/python" "$here/cluster.py" --engine "$engine" "$@"
done
