#!/usr/bin/env bash
# Compares percuss with Pinocchio, MuJoCo and Drake: robots of example-robot-data, closed linkages, contacts that bounce (there
# and, by engines.sh, in other engines), suspensions and designs, reference files. README.md says what and how.
# Needs python3 and, the first time, the network.
#   run.sh [--gate] [--prepare] [OPTION...]
#     --gate: three robots, a linkage and a suspension, with percuss-probe of `cargo test --workspace` and the command of
#     `cargo build --release`
#     --prepare: only installs the other programs
#     further options go to compare.py (--only NAME..., --update-ledger, …)
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
cd "$here/../.."
target=${CARGO_TARGET_DIR:-$PWD/target}
venv=$PWD/target/external/venv
drake=$PWD/target/external/drake
. "$here/environment.sh"
prepare_only='' gate=''
while :; do
  case ${1-} in
    --gate) gate=1 ;;
    --prepare) prepare_only=1 ;;
    *) break ;;
  esac
  shift
done

if [ -n "$gate" ]; then
  environment "$venv" "$(first python3.11)" "$here/requirements.txt"
  "$here/packages.sh" --page
else
  # PyBullet has no wheel for later ones.
  environment "$venv" "$(first python3.11)" "$here/requirements.txt" "$here/requirements-engines.txt"
  # Jolt is run by node, where there is one.
  jolt=target/external/node_modules/jolt-physics/package.json
  if command -v npm > /dev/null && ! grep -qs '"version": "1.1.0"' "$jolt"; then
    npm install --silent --no-save --prefix "$PWD/target/external" jolt-physics@1.1.0
  fi
  # Drake 1.58 has no wheel for earlier ones.
  newer=(python3.13 python3.12 "$HOME"/.pyenv/versions/3.13.*/bin/python3 "$HOME"/.pyenv/versions/3.12.*/bin/python3)
  environment "$drake" "$(first "${newer[@]}")" "$here/requirements-drake.txt"
  # For contact/compilers.py: C++ headers that packages of Rust carry (10 MB), and Debian packages.
  host=$(rustc -vV | sed -n 's/^host: //p')
  cargo fetch --quiet --locked --target "$host" --manifest-path "$here/contact/headers/Cargo.toml"
  "$here/packages.sh"
fi
[ -z "$prepare_only" ] || exit 0

# The command is optimised: the checks call it some thousand times.
percuss=$target/release/percuss
if [ -n "$gate" ]; then
  programs=$target/debug
  cargo build --locked --quiet --release
else
  programs=$target/release
  cargo build --locked --quiet --release -p percuss-tests --bins -p percuss-cli --features percuss-cli/full
fi
for program in "$percuss" "$programs/percuss-probe" "$programs/percuss-reference"; do
  [ -x "$program" ] || { echo "$program is missing: the tests of the workspace build it"; exit 1; }
done
# Before OMP_NUM_THREADS is set, which `nproc` would report.
processors=$(nproc)
export PYTHONDONTWRITEBYTECODE=1 OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
output=$(mktemp -d)
trap 'rm -rf "$output"' EXIT
export PERCUSS_VALIDATION=$output
# check NAME COMMAND...: runs beside the others, one for each processor; its output is printed when all have ended.
names=()
check() {
  local name=$1
  shift
  names+=("$name")
  # Polled: `wait -n` would miss a check that ends just before it.
  while [ "$(jobs -pr | wc -l)" -ge "$processors" ]; do sleep 0.5; done
  {
    local start=$SECONDS code=0
    "$@" > "$output/$name" 2>&1 || code=$?
    echo "$name: $((SECONDS - start)) s, exit $code" >> "$output/$name"
    echo "$code" > "$output/$name.code"
  } &
}
if [ -n "$gate" ]; then
  check robots "$venv/bin/python" "$here/compare.py" --probe "$programs/percuss-probe" --configurations 20 --only /panda.urdf /ur5_robot.urdf \
    talos_full_v2.urdf
  check linkage "$venv/bin/python" "$here/loops.py" --percuss "$percuss" --only four_bar
  check suspension "$venv/bin/python" "$here/suspensions/check.py" --percuss "$percuss" --count 1 --template double-wishbone
  check shipped_models "$programs/percuss-reference" "shipped models" models/four_bar.urdf models/six_r_arm.urdf models/floating_body.urdf
  check curved_contacts "$venv/bin/python" "$here/contact/curved_contacts.py" --percuss "$percuss" --count 4
else
  # The longest first.
  check suspensions "$venv/bin/python" "$here/suspensions/check.py" --percuss "$percuss" --count 2
  check elastokinematics "$venv/bin/python" "$here/suspensions/elastokinematics.py" --percuss "$percuss" --count 100
  check implausible "$venv/bin/python" "$here/suspensions/implausible.py" --percuss "$percuss" --count 2
  check rfactor "$venv/bin/python" "$here/suspensions/rfactor.py" --percuss "$percuss"
  check kinematics "$venv/bin/python" "$here/suspensions/kinematics.py" --percuss "$percuss" --count 4
  check impacts "$venv/bin/python" "$here/impacts.py" --percuss "$percuss" --count 20
  check robots "$venv/bin/python" "$here/compare.py" --probe "$programs/percuss-probe" "$@"
  check engines "$here/engines.sh" "$percuss"
  check integrators env PYTHONPATH="$here" "$venv/bin/python" "$here/contact/integrators.py" --percuss "$percuss"
  check curved_contacts "$venv/bin/python" "$here/contact/curved_contacts.py" --percuss "$percuss" --count 32
  check contacts env PYTHONPATH="$here" "$drake/bin/python" "$here/contact/check.py" --percuss "$percuss"
  check reports python3 "$here/reports.py" --percuss "$percuss"
  check designs "$venv/bin/python" "$here/designs.py" --percuss "$percuss" --count 30
  check compliance "$venv/bin/python" "$here/compliance.py" --percuss "$percuss" --count 200 --exudyn
  check linkages "$venv/bin/python" "$here/loops.py" --percuss "$percuss"
  check mjcf "$venv/bin/python" "$here/mjcf.py" --percuss "$percuss"
  check mjcf_models env PYTHONPATH="$here" "$venv/bin/python" "$here/mjcf_models.py" --percuss "$percuss"
  check round_trips env PYTHONPATH="$here" "$venv/bin/python" "$here/round_trips.py" --percuss "$percuss"
  check impact_models "$venv/bin/python" "$here/impact_models.py" --percuss "$percuss"
  check sdf env PYTHONPATH="$here" "$drake/bin/python" "$here/sdf.py" --percuss "$percuss"
  robots=$("$venv/bin/python" -c 'import site; print(site.getsitepackages()[0])')/cmeel.prefix/share/example-robot-data/robots
  check certified_points "$venv/bin/python" "$here/certified_points.py" "$percuss"
  check certificates "$venv/bin/python" "$here/certificates.py" "$percuss"
  check generated_code "$venv/bin/python" "$here/generated_code.py" "$percuss" "$robots" 8
  # The shipped models: route A against the oracle's route C.
  check shipped_models "$programs/percuss-reference" "shipped models" models/*.urdf
  # Reference files of the loop dialect, where they are at hand: beside the repository, or where PERCUSS_REFERENCE says.
  reference=${PERCUSS_REFERENCE:-../shared/data}
  if [ -d "$reference" ]; then
    check reference_files "$programs/percuss-reference" "reference files" "$reference"/urdf-plus/*.urdf "$reference"/rounded/*.urdf
  fi
fi
wait || true
failed=0
for name in "${names[@]}"; do
  cat "$output/$name"
  [ "$(cat "$output/$name.code")" = 0 ] || failed=1
done
[ -z "$gate" ] || exit $failed
python3 "$here/validation.py" "$output" -o target/external/validation.md --python "$venv/bin/python" --python "$drake/bin/python" || failed=1
[ -d "$reference" ] || echo "reference files: not at hand ($reference), not compared"
exit $failed
