#!/usr/bin/env bash
# Project Chrono with percuss's parameters. Builds its core module (no FEA, no other modules; 25 minutes of one core)
# from a source tree, compiles chrono.cc with it and runs its modules of engines_check.py. Needs cmake, ninja, c++ and
# Eigen (Debian's cmake, ninja-build, g++, libeigen3-dev).
#   chrono.sh PERCUSS SOURCES [FOLDER]        PERCUSS: the program; SOURCES: source tree of Chrono 10
#   (projectchrono/chrono); FOLDER: build folder
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
percuss=$(realpath "$1")
sources=$(realpath "$2")
build=$(realpath -m "${3:-$here/../../../target/external/chrono}")
cd "$here/../../.."
if [ ! -f "$build/build.ninja" ]; then
  mkdir -p "$build"
  cmake -S "$sources" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O1 -DCMAKE_CXX_FLAGS=-w \
    -DCMAKE_UNITY_BUILD=ON -DBUILD_SHARED_LIBS=OFF -DBUILD_DEMOS=OFF -DBUILD_TESTING=OFF -DCH_ENABLE_MODULE_FEA=OFF \
    -DCH_ENABLE_YAML=OFF -DCH_ENABLE_OPENMP=OFF > "$build/configured.log"
  # Files that are compiled together; two of them define the same constant.
  sed -E -i 's!^#include ".*/(ChRotation|ChFunctionPositionLine)\.cpp"!#define FD_STEP FD_STEP_\1\n&\n#undef FD_STEP!' \
    "$build"/src/chrono/CMakeFiles/Chrono_core.dir/Unity/unity_*.cxx
fi
ninja -C "$build" Chrono_core
# Chrono is built for this processor, which determines Eigen's layout of its types.
c++ -std=c++17 -O1 -w -march=native -I"$build" -I"$sources/src" -isystem /usr/include/eigen3 -o "$build/chrono_impacts" "$here/chrono.cc" \
  "$build/lib/libChrono_core.a" -lpthread
python=target/external/venv/bin/python
[ -x "$python" ] || python=python3
export PERCUSS_CHRONO=$build/chrono_impacts PERCUSS_CHRONO_HEADERS=$build:$sources/src:/usr/include/eigen3
PYTHONPATH=tests/external PYTHONDONTWRITEBYTECODE=1 \
  "$python" tests/external/contact/engines_check.py --percuss "$percuss" --only chrono --only chrono_hertz
