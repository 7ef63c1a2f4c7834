#!/usr/bin/env bash
# The Python package: built and installed as by a user, its tests, its types (mypy, pyright; the stubs compared with the
# module by stubtest; those of all pages and notebooks), its examples, executed notebooks among them; then the peers' matrices, if run.sh has created their
# environments: Pinocchio and MuJoCo, Drake, and the converters of positions; arrays of PyTorch and JAX. Needs python3 (3.10 or later), cargo, node for pyright, and, the first
# time, the network.
#   python.sh [--prepare | --gate] [PYTEST OPTION...]
#     --prepare: only creates the environment
#     --gate: in the profile of `cargo test --workspace`, with its build results; some tests, and the types of the package and of all tests
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
cd "$here/../.."
. "$here/environment.sh"
build=() prepare_only='' gate=''
if [ "${1-}" = --prepare ]; then
  prepare_only=1
elif [ "${1-}" = --gate ]; then
  shift
  gate=1
  build=(CARGO="$here/cargo.sh" MATURIN_PEP517_ARGS=--profile=dev)
fi
root=$PWD
work=$root/target/external/python
package=crates/python
environment "$work/venv" "$(first python3.11 python3.12 python3.13)" "$here/requirements-python.txt"
[ -z "$prepare_only" ] || exit 0
bin=$work/venv/bin
export PATH=$bin:$PATH PIP_DISABLE_PIP_VERSION_CHECK=1 PYTHONDONTWRITEBYTECODE=1 OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
failed=0
# step NAME COMMAND...: a failed step does not stop the others.
step() {
  local name=$1 start=$SECONDS
  shift
  "$@" || failed=1
  echo "Python: $name, $((SECONDS - start)) s"
}
wheel() {
  rm -rf "$work/wheel" "$work/site"
  env ${build[@]+"${build[@]}"} "$bin/pip" wheel --quiet --no-build-isolation --no-deps --wheel-dir "$work/wheel" "./$package" &&
    "$bin/pip" install --quiet --no-deps --force-reinstall "$work"/wheel/percuss-*.whl &&
    "$bin/pip" install --quiet --no-deps --target "$work/site" "$work"/wheel/percuss-*.whl
}
check() {
  (cd "$package" && "$bin/python" -m pytest -q -p no:cacheprovider tests "$@")
}
types() {
  local mypy=("$bin/python" -m mypy --config-file "$package/pyproject.toml" --cache-dir "$work/mypy")
  "${mypy[@]}" -p percuss && "${mypy[@]}" "$package"/tests/*.py "$package"/examples/*.py && "${mypy[@]}" "$package"/examples/cluster/*.py
}
# Pages and notebooks, with the types of the installed package.
documentation() {
  "$bin/python" "$package/tests/blocks.py" "$work/blocks" &&
    "$bin/python" -m mypy --config-file "$package/pyproject.toml" --cache-dir "$work/mypy" "$work"/blocks/*.py || return 1
  echo '{"include": ["blocks"], "reportMissingModuleSource": false, "reportMissingImports": false, "reportUnusedExpression": false}' > "$work/blocks.json"
  "$bin/pyright" --project "$work/blocks.json" --pythonpath "$bin/python"
}
stubs() {
  "$bin/python" -m mypy.stubtest percuss --mypy-config-file "$package/pyproject.toml" --allowlist "$package/tests/not_installed.txt" --ignore-unused-allowlist
}
step wheel wheel
[ $failed = 0 ] || exit 1
if [ -n "$gate" ]; then
  # Records are compared with the sources; pages and names with the package; calls of each kind.
  step tests check -k "records or facade or docs or models or pickle or usd" "$@"
  step mypy types
  step stubtest stubs
  exit $failed
fi
step tests check "$@"
step mypy types
step "types of pages and notebooks" documentation
step stubtest stubs
step pyright "$bin/pyright" --project "$package/pyproject.toml" --pythonpath "$bin/python"
# The peers have separate environments; the same extension works with every Python from 3.10 on.
for peer in venv drake; do
  python=$root/target/external/$peer/bin/python
  [ -x "$python" ] || { echo "Python: no matrices of peers, run.sh makes target/external/$peer"; continue; }
  step "matrices of peers ($peer)" "$python" "$package/tests/peers/matrices.py" --package "$work/site"
  step "converters ($peer)" "$python" "$package/tests/peers/converters.py" --package "$work/site"
done
# PyTorch (3 GB) and JAX, where an environment has them: PERCUSS_ARRAYS names its interpreter.
if [ -n "${PERCUSS_ARRAYS-}" ]; then
  step "arrays of PyTorch and JAX" "$PERCUSS_ARRAYS" "$package/tests/peers/arrays.py" --package "$work/site"
else
  echo "Python: arrays of PyTorch and JAX are not compared; PERCUSS_ARRAYS=INTERPRETER names one that has them"
fi
# Newton (200 MB with Warp): PERCUSS_NEWTON names an interpreter with newton[importers].
if [ -n "${PERCUSS_NEWTON-}" ]; then
  step "stages of USD (newton)" "$PERCUSS_NEWTON" "$package/tests/peers/usd.py" --package "$work/site"
else
  echo "Python: stages of USD are not compared with Newton; PERCUSS_NEWTON=INTERPRETER names one that has newton[importers]"
fi
exit $failed
