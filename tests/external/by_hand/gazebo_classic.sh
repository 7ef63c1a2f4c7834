#!/usr/bin/env bash
# Gazebo Classic 11 with percuss's parameters. Debian 12 does not contain it; this script installs Debian 11's package
# into a separate root (debootstrap, 2.5 GB, about 10 minutes the first time), and must run as root.
#   gazebo_classic.sh PERCUSS [FOLDER]        PERCUSS: the program; FOLDER: the separate root, created if missing
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
percuss=$(realpath "$1")
root=$(realpath -m "${2:-$here/../../../target/external/bullseye}")
cd "$here/../../.."
if [ ! -x "$root/usr/bin/gzserver" ]; then
  command -v debootstrap >/dev/null || apt-get install -y -q debootstrap
  [ -x "$root/usr/bin/apt-get" ] || debootstrap --variant=minbase --include=ca-certificates bullseye "$root" http://deb.debian.org/debian
  DEBIAN_FRONTEND=noninteractive chroot "$root" apt-get install -y -q --no-install-recommends gazebo libgazebo-dev g++ pkg-config
fi
mountpoint -q "$root/proc" || { mount --bind /proc "$root/proc" && trap 'umount "$root/proc"' EXIT; }
echo "127.0.0.1 localhost" > "$root/etc/hosts"
cp "$here/gazebo_classic.cc" "$root/tmp/"
chroot "$root" sh -c 'c++ -std=c++17 -O1 -w -o /tmp/gazebo_classic /tmp/gazebo_classic.cc $(pkg-config --cflags --libs gazebo) 2>/dev/null'
python=target/external/venv/bin/python
[ -x "$python" ] || python=python3
PERCUSS_GAZEBO_CLASSIC=$root PYTHONPATH=tests/external PYTHONDONTWRITEBYTECODE=1 \
  "$python" tests/external/contact/engines_check.py --percuss "$percuss" --only gazebo_classic
