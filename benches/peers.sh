#!/usr/bin/env bash
# Time of percuss for m̄ of the robots, poses and contacts with which other programs were timed, and the ratio to the fastest of them.
#
#     benches/peers.sh FOLDER [TIMES]
#
# FOLDER contains NAME.json for every robot: urdf, link, point, normal_world, base (fixed or floating), joints, poses and
# effective_mass, the expected results. It may contain suspensions, NAME.urdf as written by `percuss import`; their poses and
# expected m̄ are computed by percuss. TIMES contains the times of the other programs, measured on this machine in the same session:
# one line `PROGRAM ROBOT VELOCITIES NANOSECONDS` each. All m̄ are compared to 1e-9 before timing.
set -euo pipefail
cd "$(dirname "$0")/.."
cargo build --locked --profile dist -q -p percuss-benches --bin percuss-peers
"${CARGO_TARGET_DIR:-target}/dist/percuss-peers" "$1" | tee /tmp/percuss-peers.$$
[ $# -ge 2 ] && awk '
  NR == FNR { if ($4 + 0 > 0 && (!($2 in least) || $4 < least[$2])) least[$2] = $4; next }
  $2 in least && $NF + 0 > 0 && !/agrees|asked/ {
    what = $3; for (i = 4; i < NF; i++) what = what " " $i
    printf "%-8s %-24s %8.1f ns  %5.1f times the fastest other (%d ns)\n", $2, what, $NF, least[$2] / $NF, least[$2]
  }' "$2" /tmp/percuss-peers.$$
rm -f /tmp/percuss-peers.$$
