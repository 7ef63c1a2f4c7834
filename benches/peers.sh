#!/usr/bin/env bash
# m̄ by percuss on the robots, poses and questions that other programs were timed with, and the ratio to the fastest of them.
#
#     benches/peers.sh FOLDER [TIMES]
#
# FOLDER holds NAME.json for every robot: urdf, link, point, normal_world, base (fixed or floating), joints, poses and
# effective_mass, the answers. It may hold suspensions, NAME.urdf as `percuss import` writes them: their poses, and the m̄ that is
# compared, are our own. TIMES is what the others took, on this machine and just now: a line
# `PROGRAM ROBOT VELOCITIES NANOSECONDS` each. All m̄ are compared to 1e-9 before anything is timed.
set -euo pipefail
cd "$(dirname "$0")/.."
cargo build --locked --release -q -p percuss-benches --bin percuss-peers
"${CARGO_TARGET_DIR:-target}/release/percuss-peers" "$1" | tee /tmp/percuss-peers.$$
[ $# -ge 2 ] && awk '
  NR == FNR { if ($4 + 0 > 0 && (!($2 in least) || $4 < least[$2])) least[$2] = $4; next }
  $2 in least && $NF + 0 > 0 && !/agrees|asked/ {
    what = $3; for (i = 4; i < NF; i++) what = what " " $i
    printf "%-8s %-24s %8.1f ns  %5.1f times the fastest other (%d ns)\n", $2, what, $NF, least[$2] / $NF, least[$2]
  }' "$2" /tmp/percuss-peers.$$
rm -f /tmp/percuss-peers.$$
