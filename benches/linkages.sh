#!/usr/bin/env bash
# Time of percuss and of MuJoCo for m̄ of mechanisms with loops and mimics, at the pose as drawn, in one run.
#
#     benches/linkages.sh FOLDER < LIST
#
# Each line of LIST: NAME MODEL CONTACT FLAGS..., with the link, point and normal of the contact as `LINK X,Y,Z X,Y,Z`. `percuss export` writes
# the model for MuJoCo, and FOLDER receives the files. Both m̄ must agree within 1e-9. Needs gcc and the Python package mujoco. Environment:
# PERCUSS is the path of the command, PYTHON that of the interpreter.
set -euo pipefail
cd "$(dirname "$0")/.."
folder=$1
mkdir -p "$folder"
mujoco=$("${PYTHON:-python3}" -c 'import mujoco, os; print(os.path.dirname(mujoco.__file__))')
gcc -O3 -march=native benches/mujoco_linkages.c -I"$mujoco/include" "$mujoco"/libmujoco.so.* -Wl,-rpath,"$mujoco" -lm \
  -o "$folder/mujoco_linkages"
: > "$folder/times"
while read -r name model link point normal flags; do
  # shellcheck disable=SC2086
  "${PERCUSS:-target/release/percuss}" export "$model" --link "$link" --point "$point" --normal "$normal" --normal-frame world $flags \
    --restitution 0.5 --stiffness 1e5 --force -o "$folder/$name.xml" > "$folder/$name.export" 2>&1 || { cat "$folder/$name.export"; exit 1; }
  "$folder/mujoco_linkages" "$folder/$name.xml" "$name" | tee -a "$folder/times"
  base=fixed
  [[ $flags != *"--base floating"* ]] || base=floating
  printf '{"urdf": "%s", "link": "%s", "point": [%s], "normal_world": [%s], "base": "%s", "effective_mass": [%s]}\n' \
    "$model" "$link" "$point" "$normal" $base "$(awk -v n="$name" '$2 == n {print $5}' "$folder/times")" > "$folder/$name.json"
done
benches/peers.sh "$folder" "$folder/times"
