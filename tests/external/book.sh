#!/usr/bin/env bash
# Builds the book of docs/ with mdBook. A warning of mdBook is a failure. The first run compiles mdBook: about a minute of one core.
set -euo pipefail
cd "$(dirname "$0")/../.."
target=$(realpath -m "${CARGO_TARGET_DIR:-target}")
version=0.5.4
mdbook=$target/mdbook-$version/bin/mdbook
if [ ! -x "$mdbook" ]; then
  cargo install --locked --quiet --no-default-features --debug --root "$target/mdbook-$version" --target-dir "$target/mdbook-build" \
    "mdbook@$version"
fi
printed=$("$mdbook" build docs --dest-dir "$target/book" 2>&1) || { echo "$printed"; exit 1; }
echo "$printed"
if grep -qE '(WARN|ERROR)' <<< "$printed"; then
  echo "mdBook has warnings"
  exit 1
fi
