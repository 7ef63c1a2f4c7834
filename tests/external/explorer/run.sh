#!/usr/bin/env bash
# Tests of the page of `percuss explore` in headless Chromium: the bundle is that of the sources, the engine is built if it is not up
# to date, then the tests of the page. Needs npm and Chromium (Debian: apt install chromium binaryen xz-utils).
#   run.sh [TEST…]   only the tests whose names contain one of the words
# EXPLORER_DRAGS: number of random drags of each seed (150); EXPLORER_SEEDS: their seeds (7,11), separated by commas
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../../.." && pwd)
work=$root/target/explorer-tests
browser=${CHROMIUM:-$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)}
[ -n "$browser" ] || { echo "Chromium is needed: apt install chromium, or CHROMIUM=/path/to/it" >&2; exit 1; }
"$root/crates/explorer/build.sh" page --check
"$root/crates/explorer/build.sh" engine
mkdir -p "$work"
cp "$here/package.json" "$here/package-lock.json" "$work"
[ -d "$work/node_modules/playwright-core" ] && cmp -s "$here/package-lock.json" "$work/installed.json" ||
  (cd "$work" && npm ci --ignore-scripts --no-audit --no-fund --silent && cp package-lock.json installed.json)
cargo build --quiet --locked --manifest-path "$root/Cargo.toml" -p percuss-cli --features explorer
cp "$here"/*.mjs "$work"
CHROMIUM=$browser PERCUSS=${CARGO_TARGET_DIR:-$root/target}/debug/percuss node "$work/tests.mjs" "$root" "$@"
