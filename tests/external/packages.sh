#!/usr/bin/env bash
# Installs, as root, missing Debian packages of the checks; other users install them beforehand.
#   packages.sh [--page | --firefox | [--with-gazebo] [--with-octave]]
# --page: Chromium (80 MB), xz, and npm unless it is installed, for the explorer. --firefox: Firefox, and a screen for it.
# Without these flags also ODE, Bullet and the SDFormat program (8 MB). --with-gazebo: ign-physics (306 packages, four minutes).
# --with-octave: Octave, which reads the MATLAB snippet (135 packages, 80 MB). Without these two flags the checks use
# both if already installed.
set -euo pipefail
wanted=(libode-dev libbullet-dev ignition-tools libsdformat-dev chromium xz-utils)
# npm builds the bundle of the page again, for a comparison with the committed one.
[ "${1-}" != --page ] || wanted=(chromium xz-utils)
command -v npm > /dev/null || wanted+=(npm)
[ "${1-}" != --firefox ] || wanted=(firefox-esr xvfb)
for option in "$@"; do
  case $option in
    --with-gazebo) wanted+=(libignition-physics-dev libignition-physics5-dartsim-plugin5) ;;
    --with-octave) wanted+=(octave) ;;
  esac
done
missing=()
for package in "${wanted[@]}"; do
  dpkg -s "$package" > /dev/null 2>&1 || missing+=("$package")
done
if [ ${#missing[@]} -gt 0 ] && [ "$(id -u)" = 0 ] && command -v apt-get > /dev/null; then
  export DEBIAN_FRONTEND=noninteractive
  apt-get update -qq
  apt-get install -y -qq --no-install-recommends "${missing[@]}" > /dev/null
fi
