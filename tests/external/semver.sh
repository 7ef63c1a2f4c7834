#!/usr/bin/env bash
# Compares the public interfaces of the published libraries with the last release (tag v*), by cargo-semver-checks, which is installed if
# missing. Without a tag there is nothing to compare. Needs the network, and the tags of the repository.
set -euo pipefail
cd "$(dirname "$0")/../.."
if ! last=$(git describe --tags --abbrev=0 --match 'v*' 2> /dev/null); then
  echo "semver.sh: no tag v*: there is no release to compare with"
  exit 0
fi
cargo semver-checks --version 2> /dev/null || nice cargo install --locked cargo-semver-checks
# The library of the command is for its own program.
cargo semver-checks --workspace --exclude percuss-cli --baseline-rev "$last"
