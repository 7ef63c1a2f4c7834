#!/usr/bin/env bash
# Counts the instructions of benchmark tasks and compares them with benches/counts.txt. The counts do not depend on the load of the
# machine.
#
#     benches/counts.sh            compares; exit code 1 if a task exceeds the tolerance
#     benches/counts.sh --write    writes a new table
#
# Each task runs twice under valgrind, with and without the work; the difference is the cost of the work. Lanes are limited to AVX2,
# which valgrind supports. Without valgrind nothing is counted, and the script prints a note.
set -euo pipefail
cd "$(dirname "$0")/.."
table=benches/counts.txt
# Permitted increase of a count, per cent.
tolerance=3
if ! command -v valgrind > /dev/null; then
  echo "counts.sh: nothing is counted: there is no valgrind here"
  exit 0
fi
program=${PERCUSS_COUNTS:-${CARGO_TARGET_DIR:-target}/dist/percuss-counts}
[ -n "${PERCUSS_COUNTS:-}" ] || cargo build --locked --profile dist -q -p percuss-benches --bin percuss-counts

# count TASK TIMES: number of instructions, and units of work.
count() {
  local units log
  log=$(mktemp)
  units=$(valgrind --tool=cachegrind --cache-sim=no --cachegrind-out-file=/dev/null "$program" "$1" "$2" 2> "$log")
  awk -v units="$units" '/I +refs/ { gsub(",", "", $NF); print $NF, units }' "$log"
  rm -f "$log"
}

tasks=$(awk '!/^#/ { print $1 }' "$table")
written=$(grep '^#' "$table")
failed=0
for task in $tasks; do
  read -r before _ < <(count "$task" 0)
  read -r after units < <(count "$task" 1)
  got=$(((after - before) / units))
  wanted=$(awk -v task="$task" '$1 == task { print $2 }' "$table")
  verdict=$(awk -v got="$got" -v wanted="$wanted" -v tolerance="$tolerance" 'BEGIN {
    change = 100 * (got / wanted - 1)
    printf("%+.1f %%%s", change, (change > tolerance) ? "  more than " tolerance " % more" : "") }')
  printf '%-18s %12d %12d  %s\n' "$task" "$got" "$wanted" "$verdict"
  case $verdict in *more*) failed=1 ;; esac
  written+=$'\n'$(printf '%-18s %d' "$task" "$got")
done
if [ "${1:-}" = --write ]; then
  printf '%s\n' "$written" > "$table"
elif [ "$failed" = 1 ]; then
  exit 1
fi
