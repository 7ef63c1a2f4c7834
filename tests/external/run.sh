#!/usr/bin/env bash
# Compares percuss with Pinocchio, MuJoCo and Drake: robots of example-robot-data, closed linkages, contacts that bounce (there
# and, by engines.sh, in other engines), suspensions and designs, reference files. README.md says what and how.
# Needs python3 and, the first time, the network. Options go to compare.py (--only NAME, --update-ledger, …).
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
cd "$here/../.."
target=${CARGO_TARGET_DIR:-$PWD/target}
venv=$PWD/target/external/venv
drake=$PWD/target/external/drake
. "$here/environment.sh"

# PyBullet has no wheel for later ones.
environment "$venv" "$here/requirements.txt" "$(first python3.11)"
# Jolt is run by node, where there is one.
jolt=target/external/node_modules/jolt-physics/package.json
if command -v npm > /dev/null && ! grep -qs '"version": "1.1.0"' "$jolt"; then
  npm install --silent --no-save --prefix "$PWD/target/external" jolt-physics@1.1.0
fi
# Drake 1.58 has no wheel for earlier ones.
newer=(python3.13 python3.12 "$HOME"/.pyenv/versions/3.13.*/bin/python3 "$HOME"/.pyenv/versions/3.12.*/bin/python3)
environment "$drake" "$here/requirements-drake.txt" "$(first "${newer[@]}")"
# For contact/compilers.py: C++ headers that packages of Rust carry (10 MB), and Debian packages.
host=$(rustc -vV | sed -n 's/^host: //p')
cargo fetch --quiet --locked --target "$host" --manifest-path "$here/contact/headers/Cargo.toml"
"$here/packages.sh"
cargo build --locked --quiet --release -p percuss-tests --bins -p percuss-cli --features percuss-cli/full
export PYTHONDONTWRITEBYTECODE=1 OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
failed=0
"$venv/bin/python" "$here/compare.py" --probe "$target/release/percuss-probe" "$@" || failed=1
"$venv/bin/python" "$here/loops.py" --percuss "$target/release/percuss" || failed=1
"$venv/bin/python" "$here/suspensions/check.py" --percuss "$target/release/percuss" --count 4 || failed=1
"$venv/bin/python" "$here/designs.py" --percuss "$target/release/percuss" --count 30 || failed=1
PYTHONPATH=$here "$drake/bin/python" "$here/contact/check.py" --percuss "$target/release/percuss" || failed=1
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
