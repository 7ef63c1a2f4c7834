#!/usr/bin/env bash
# The Python package: built and installed as a user would, its tests, its types (mypy, pyright; the stubs held against the module by
# stubtest), its examples; then the peers' matrices, where run.sh has made their environments: Pinocchio and MuJoCo, Drake.
# Needs python3 (3.10 or later), cargo, node for pyright, and the first time the network. Options go to pytest.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
cd "$here/../.."
root=$PWD
work=$root/target/external/python
package=crates/python
if ! cmp -s "$here/requirements-python.txt" "$work/venv/requirements.txt"; then
  rm -rf "$work/venv"
  python=python3
  for candidate in python3.11 python3.12 python3.13; do
    if "$candidate" -c 'import venv, ensurepip' 2> /dev/null; then python=$candidate && break; fi
  done
  "$python" -m venv "$work/venv"
  "$work/venv/bin/pip" install --quiet --disable-pip-version-check --requirement "$here/requirements-python.txt"
  cp "$here/requirements-python.txt" "$work/venv/requirements.txt"
fi
bin=$work/venv/bin
export PATH=$bin:$PATH PIP_DISABLE_PIP_VERSION_CHECK=1 PYTHONDONTWRITEBYTECODE=1 OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
rm -rf "$work/wheel" "$work/site"
CARGO=$here/cargo.sh "$bin/pip" wheel --quiet --no-build-isolation --no-deps --wheel-dir "$work/wheel" "./$package"
"$bin/pip" install --quiet --no-deps --force-reinstall "$work"/wheel/percuss-*.whl
"$bin/pip" install --quiet --no-deps --target "$work/site" "$work"/wheel/percuss-*.whl
failed=0
(cd "$package" && "$bin/python" -m pytest -q -p no:cacheprovider tests "$@") || failed=1
"$bin/python" -m mypy --config-file "$package/pyproject.toml" --cache-dir "$work/mypy" -p percuss || failed=1
"$bin/python" -m mypy --config-file "$package/pyproject.toml" --cache-dir "$work/mypy" "$package"/tests/*.py "$package"/examples/*.py || failed=1
"$bin/python" -m mypy --config-file "$package/pyproject.toml" --cache-dir "$work/mypy" "$package"/examples/cluster/*.py || failed=1
"$bin/python" -m mypy.stubtest percuss --mypy-config-file "$package/pyproject.toml" || failed=1
"$bin/pyright" --project "$package/pyproject.toml" --pythonpath "$bin/python" || failed=1
# The peers have environments of their own; the same extension serves every Python from 3.10 on.
for peer in venv drake; do
  python=$root/target/external/$peer/bin/python
  [ -x "$python" ] || { echo "peers: no $peer environment; run.sh makes it"; continue; }
  "$python" "$package/tests/peers/matrices.py" --package "$work/site" || failed=1
done
exit $failed
