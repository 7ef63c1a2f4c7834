#!/usr/bin/env bash
# Tests of the page of `percuss explore` in headless Chromium: the bundle is that of the sources, the engine is built if it is not up
# to date, then the tests of the page. Needs npm and Chromium (Debian: apt install chromium binaryen xz-utils).
#   run.sh [--gate] [TEST…]   only the tests whose names contain one of the words
#     --gate: with the profile and the numbers of .ci/run; Debian packages that are missing are installed
# EXPLORER_DRAGS: number of random drags of each seed (350); EXPLORER_SEEDS: their seeds (7,11,23), separated by commas;
# EXPLORER_MOVES: moves of the pointer in the test of the memory (10000)
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../../.." && pwd)
work=$root/target/explorer-tests
target=${CARGO_TARGET_DIR:-$root/target}
build=() profile=debug
if [ "${1:-}" = --gate ]; then
  shift
  # The command of this profile is built already.
  build=(--release) profile=release
  export EXPLORER_DRAGS=${EXPLORER_DRAGS:-60} EXPLORER_SEEDS=${EXPLORER_SEEDS:-23} EXPLORER_MOVES=${EXPLORER_MOVES:-2000}
  "$here/../packages.sh"
fi
browser=${CHROMIUM:-$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)}
[ -n "$browser" ] || { echo "Chromium is needed: apt install chromium, or CHROMIUM=/path/to/it" >&2; exit 1; }
"$root/crates/explorer/build.sh" page --check
"$root/crates/explorer/build.sh" engine
mkdir -p "$work"
cp "$here/package.json" "$here/package-lock.json" "$work"
[ -d "$work/node_modules/playwright-core" ] && cmp -s "$here/package-lock.json" "$work/installed.json" ||
  (cd "$work" && npm ci --ignore-scripts --no-audit --no-fund --silent && cp package-lock.json installed.json)
cargo build --quiet --locked --manifest-path "$root/Cargo.toml" ${build[@]+"${build[@]}"} -p percuss-cli --features explorer
cp "$here"/*.mjs "$work"
CHROMIUM=$browser PERCUSS=$target/$profile/percuss node "$work/tests.mjs" "$root" "$@"
