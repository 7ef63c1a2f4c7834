#!/usr/bin/env bash
# Tests the page of `percuss explore` in headless Chromium. Before that, compares the bundle with its sources.
# Needs npm, Chromium and xz (Debian: apt install chromium xz-utils).
#   run.sh [--gate] [TEST…]   only the tests whose names contain one of the words
#     --gate: as .ci/run: the tests named below, in the release profile; as root, installs missing Debian packages
# Environment, with defaults: EXPLORER_DRAGS, random drags per seed (350); EXPLORER_SEEDS, seeds separated by commas (7,11,23);
# EXPLORER_MOVES, moves of the pointer in the test of the memory (10000);
# EXPLORER_JUDGE_TIMES, 1: times are compared with their limits; 0: times are only printed (1; with --gate not set)
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../../.." && pwd)
work=$root/target/explorer-tests
target=${CARGO_TARGET_DIR:-$root/target}
build=() profile=debug
if [ "${1:-}" = --gate ]; then
  # The gate has already built the dependencies in this profile. The engine of the gate is compiled faster, and is larger.
  build=(--release) profile=release
  export CARGO_PROFILE_WEB_OPT_LEVEL=1 CARGO_PROFILE_WEB_LTO=off CARGO_PROFILE_WEB_CODEGEN_UNITS=16
  set -- 'the engine imports nothing' 'every shipped model' 'a hardpoint is dragged, undone' 'outcomes without a number'
  "$here/../packages.sh" --page
else
  export EXPLORER_JUDGE_TIMES=${EXPLORER_JUDGE_TIMES:-1}
fi
browser=${CHROMIUM:-$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)}
[ -n "$browser" ] || { echo "Chromium is needed: apt install chromium, or CHROMIUM=/path/to/it" >&2; exit 1; }
node "$root/crates/explorer/page/build.mjs" --check
mkdir -p "$work"
cp "$here/package.json" "$here/package-lock.json" "$work"
[ -d "$work/node_modules/playwright-core" ] && cmp -s "$here/package-lock.json" "$work/installed.json" ||
  (cd "$work" && npm ci --ignore-scripts --no-audit --no-fund --silent && cp package-lock.json installed.json)
cargo build --quiet --locked --manifest-path "$root/Cargo.toml" ${build[@]+"${build[@]}"} -p percuss-cli --features explorer
cp "$here"/*.mjs "$work"
CHROMIUM=$browser PERCUSS=$target/$profile/percuss node "$work/tests.mjs" "$root" "$@"
