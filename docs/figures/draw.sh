#!/usr/bin/env bash
# Draws the figures of the documentation again: docs/figures/draw.sh [PERCUSS]
set -euo pipefail
cd "$(dirname "$0")/../.."
percuss=${1:-target/debug/percuss}
figures=docs/figures
stop="--at bump_stop"
# The first picture of a report is the drawing of the mechanism in one view.
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
drawing() { # STUDY FIGURE
  "$percuss" run "$1" --report "$work/report.html" --allow-outside > "$work/printed"
  python3 - "$work/report.html" "$2" <<'PYTHON'
import re, sys
page = open(sys.argv[1], encoding="utf-8").read()
picture = re.search(r"<svg .*?</svg>", page, re.S)[0].replace("<svg ", '<svg xmlns="http://www.w3.org/2000/svg" ', 1)
open(sys.argv[2], "w", encoding="utf-8").write(picture + "\n")
PYTHON
}

cat > "$work/corner.toml" <<'TOML'
[model]
path = "model.toml"
[contact]
at = "bump_stop"
TOML
cp models/suspensions/double-wishbone.toml "$work/model.toml"
drawing "$work/corner.toml" $figures/double-wishbone.svg
drawing models/massless_arm_suspension.toml $figures/massless-arms.svg
# shellcheck disable=SC2086 # several flags
"$percuss" sweep models/suspensions/double-wishbone.toml $stop --vary travel:wheel_centre:0,0,0:0,0,1=-50mm:50mm:21 \
  --unit mm --output $figures/travel.svg --title "Effective mass at the bump stop" --force
"$percuss" response models/suspensions/double-wishbone-bushes.toml $stop --frequency 1:2000Hz:400 --output $figures/apparent-mass.svg \
  > "$work/printed"
"$percuss" sweep models/six_r_arm.urdf --link tool --point 0.08,0,0 --normal 0,0,-1 --normal-frame world \
  --set shoulder=-40deg --vary elbow=0deg:110deg:45 --output $figures/arm.svg --title "Tool pressed down" --force
