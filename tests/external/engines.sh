#!/usr/bin/env bash
# Runs the exports in ODE, PyBullet, Bullet, Rapier and new Gazebo (contact/engines_check.py). Options are passed on to
# engines_check.py.
#   engines.sh PERCUSS [--with-gazebo] [--only MODULE] [--without MODULE]
# packages.sh installs missing packages; without --with-gazebo, new Gazebo is used only if already installed. Rapier is
# built by cargo (two minutes of one core, the first time). Gazebo Classic: by_hand/gazebo_classic.sh; Project Chrono:
# by_hand/chrono.sh.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
percuss=$1
shift
if [ "${1:-}" = --with-gazebo ]; then
  shift
  "$here/packages.sh" --with-gazebo
else
  "$here/packages.sh"
  if ! dpkg -s libignition-physics5-dartsim-plugin5 libignition-physics-dev > /dev/null 2>&1; then
    echo "new Gazebo: not installed, not run (engines.sh --with-gazebo)"
    set -- --without gazebo "$@"
  fi
fi
cd "$here/../.."
python=target/external/venv/bin/python
[ -x "$python" ] || python=python3
PYTHONPATH=$here "$python" "$here/contact/engines_check.py" --percuss "$percuss" "$@"
