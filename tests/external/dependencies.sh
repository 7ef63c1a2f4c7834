#!/usr/bin/env bash
# Licences, sources, duplicates and advisories of the dependencies, by cargo-deny and deny.toml; those of the fuzzer also.
#   dependencies.sh [--require-advisories] [--advisories FOLDER]     FOLDER: a clone of https://github.com/RustSec/advisory-db
# Exit 1 with each dependency that deny.toml does not allow. Where the database of advisories cannot be fetched, advisories are
# NOT CHECKED: the last line says so, and with --require-advisories the exit code is 1.
# Needs python3 (3.10 or later), git and cargo; the first time, the network.
set -euo pipefail
database=https://github.com/RustSec/advisory-db
required=false
while [ $# -gt 0 ]; do
  case $1 in
    --require-advisories) required=true ;;
    --advisories)
      [ -d "${2-}" ] || { echo "dependencies.sh: --advisories: \"${2-}\" is no folder" >&2; exit 2; }
      # The clone in place of the address.
      export GIT_CONFIG_COUNT=1 GIT_CONFIG_VALUE_0=$database
      GIT_CONFIG_KEY_0=url.file://$(cd "$2" && pwd).insteadOf
      export GIT_CONFIG_KEY_0
      required=true
      shift
      ;;
    *) echo "dependencies.sh: unknown argument $1; expected [--require-advisories] [--advisories FOLDER]" >&2; exit 2 ;;
  esac
  shift
done
here=$(cd "$(dirname "$0")" && pwd)
cd "$here/../.."
. "$here/environment.sh"
tools=$PWD/target/external/deny
environment "$tools" "$(first python3.11 python3.12 python3.13)" "$here/requirements-deny.txt"
# deny PROJECT ARGUMENT...
deny() {
  local project=$1
  shift
  "$tools/bin/cargo-deny" --manifest-path "$project/Cargo.toml" --config deny.toml --locked "$@"
}
failed=0
for project in . tests/fuzz; do
  echo "dependencies of $project:"
  deny "$project" check --hide-inclusion-graph --allow duplicate licenses bans sources || failed=1
done
if timeout 120 "$tools/bin/cargo-deny" --config deny.toml fetch db > "$tools/fetch.log" 2>&1; then
  for project in . tests/fuzz; do
    echo "advisories on dependencies of $project:"
    deny "$project" --offline check --hide-inclusion-graph --allow advisory-not-detected advisories || failed=1
  done
else
  grep -v '^$' "$tools/fetch.log" | tail -n 1
  echo "ADVISORIES: NOT CHECKED, because their database cannot be fetched. This is no pass."
  [ $required = false ] || failed=1
fi
exit $failed
