#!/usr/bin/env bash
# Compares percuss with Pinocchio, MuJoCo and Drake: robots of example-robot-data, closed linkages, contacts that bounce (there
# and, by engines.sh, in other engines), reference files. README.md says what and how.
# Needs python3 and, the first time, the network. Options go to compare.py (--only NAME, --update-ledger, …).
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
cd "$here/../.."
target=${CARGO_TARGET_DIR:-$PWD/target}
venv=$PWD/target/external/venv
if ! cmp -s "$here/requirements.txt" "$venv/requirements.txt"; then
  rm -rf "$venv"
  # PyBullet has no wheel for later ones.
  "$(command -v python3.11 || command -v python3)" -m venv "$venv"
  "$venv/bin/pip" install --quiet --disable-pip-version-check --requirement "$here/requirements.txt"
  # Jolt is run by node, where there is one.
  if command -v npm > /dev/null; then
    npm install --silent --no-save --prefix "$PWD/target/external" jolt-physics@1.1.0
  fi
  # Last, so that a venv that was only half made is made again.
  cp "$here/requirements.txt" "$venv/requirements.txt"
fi
cargo build --quiet --release -p percuss-tests --bins -p percuss-cli
export PYTHONDONTWRITEBYTECODE=1 OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
failed=0
"$venv/bin/python" "$here/compare.py" --probe "$target/release/percuss-probe" "$@" || failed=1
"$venv/bin/python" "$here/loops.py" --percuss "$target/release/percuss" || failed=1
PYTHONPATH=$here "$venv/bin/python" "$here/contact/check.py" --percuss "$target/release/percuss" || failed=1
"$here/engines.sh" "$target/release/percuss" || failed=1
PYTHONPATH=$here "$venv/bin/python" "$here/contact/integrators.py" --percuss "$target/release/percuss" || failed=1
# The shipped models: route A against the oracle's route C.
"$target/release/percuss-reference" "shipped models" models/*.urdf || failed=1
# Reference files of the loop dialect, where they are at hand: beside the repository, or where PERCUSS_REFERENCE says.
reference=${PERCUSS_REFERENCE:-../shared/data}
if [ -d "$reference" ]; then
  "$target/release/percuss-reference" "reference files" "$reference"/urdf-plus/*.urdf "$reference"/rounded/*.urdf || failed=1
else
  echo "reference files: not at hand ($reference), not compared"
fi
exit $failed
