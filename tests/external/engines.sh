#!/usr/bin/env bash
# Runs the exports in ODE, PyBullet, Bullet, Rapier and new Gazebo (contact/engines_check.py). Options go to it.
#   engines.sh PERCUSS [--with-gazebo] [--only MODULE] [--without MODULE]
# As root it installs what is missing: libode-dev and libbullet-dev; and with --with-gazebo Debian's ign-physics (over 300
# packages, 150 MB). Without that, new Gazebo is run where it is installed already. Rapier is built by cargo (two minutes of
# one core, the first time). Gazebo Classic: by_hand/gazebo_classic.sh.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
percuss=$1
shift
gazebo=libignition-physics5-dartsim-plugin5
wanted=(libode-dev libbullet-dev)
if [ "${1:-}" = --with-gazebo ]; then
  shift
  wanted+=(libignition-physics-dev "$gazebo")
elif ! dpkg -s "$gazebo" libignition-physics-dev >/dev/null 2>&1; then
  echo "new Gazebo: not installed, not run (engines.sh --with-gazebo)"
  set -- --without gazebo "$@"
fi
missing=()
for package in "${wanted[@]}"; do
  dpkg -s "$package" >/dev/null 2>&1 || missing+=("$package")
done
if [ ${#missing[@]} -gt 0 ] && [ "$(id -u)" = 0 ]; then
  export DEBIAN_FRONTEND=noninteractive
  apt-get update -qq
  apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
fi
cd "$here/../.."
python=target/external/venv/bin/python
[ -x "$python" ] || python=python3
PYTHONPATH=$here "$python" "$here/contact/engines_check.py" --percuss "$percuss" "$@"
