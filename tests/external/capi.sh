#!/usr/bin/env bash
# The C interface: its test programs and its example under the address sanitizer and under valgrind (no leak, no error),
# and programs built by pkg-config and by CMake from an installed copy. Installs missing packages, as root: gcc, g++,
# valgrind, cmake, pkg-config.
#   capi.sh [--libraries DIR]     DIR: the libraries of `cargo test`, target/debug/deps; default: built as for users
set -euo pipefail
libraries=()
case ${1-} in
  --libraries) libraries=(--libraries "$(cd "$2" && pwd)") ;;
  "") ;;
  *) echo "capi.sh: unknown argument $1; expected [--libraries DIR]" >&2; exit 2 ;;
esac
here=$(cd "$(dirname "$0")" && pwd)
cd "$here/../.."
root=$PWD
missing=()
for program in gcc:gcc g++:g++ valgrind:valgrind cmake:cmake make:make pkg-config:pkg-config; do
  command -v "${program%:*}" > /dev/null || missing+=("${program#*:}")
done
if [ ${#missing[@]} -gt 0 ] && [ "$(id -u)" = 0 ] && command -v apt-get > /dev/null; then
  export DEBIAN_FRONTEND=noninteractive
  apt-get update -qq
  apt-get install -y -qq --no-install-recommends "${missing[@]}" > /dev/null
fi
for program in gcc g++ valgrind cmake make pkg-config; do
  command -v "$program" > /dev/null || { echo "C interface: $program is needed"; exit 1; }
done
work=$root/target/external/capi
rm -rf "$work"
mkdir -p "$work"
crates/capi/packaging/install.sh --prefix "$work/prefix" "${libraries[@]}" > "$work/install.log" 2>&1 || { cat "$work/install.log"; exit 1; }
export PKG_CONFIG_PATH=$work/prefix/lib/pkgconfig LD_LIBRARY_PATH=$work/prefix/lib
flags=(-g -O1 -Wall -Wextra -Wpedantic -Werror)
system=$(sed -n 's/^Libs.private: //p' "$PKG_CONFIG_PATH/percuss.pc")
# check SOURCE: with the sanitizers and the static library, under valgrind with the shared library.
check() {
  local source=$1 name compiler=(gcc -std=c11)
  name=$(basename "$source")
  case $name in *.cc) compiler=(g++ -std=c++17) ;; esac
  # shellcheck disable=SC2086
  "${compiler[@]}" "${flags[@]}" -fsanitize=address,undefined -fno-sanitize-recover=all -I "$work/prefix/include" "$source" \
    "$work/prefix/lib/libpercuss.a" $system -o "$work/$name.sanitized"
  ASAN_OPTIONS=detect_leaks=1 "$work/$name.sanitized" > "$work/$name.log" 2>&1 || { cat "$work/$name.log"; echo "$name: address sanitizer"; return 1; }
  # shellcheck disable=SC2046
  "${compiler[@]}" "${flags[@]}" "$source" $(pkg-config --cflags --libs percuss) -lm -lpthread -o "$work/$name.plain"
  # Memory held by threads of the library until the program ends is "possibly lost"; unreferenced memory is lost.
  valgrind --quiet --error-exitcode=9 --leak-check=full --errors-for-leak-kinds=definite,indirect --show-leak-kinds=definite,indirect \
    "$work/$name.plain" > "$work/$name.log" 2>&1 || { cat "$work/$name.log"; echo "$name: valgrind"; return 1; }
  echo "$name: address sanitizer, valgrind"
}

# A static program, the static library in a shared program, and the shared library, by pkg-config.
api=crates/capi/tests/c/api.c
# shellcheck disable=SC2046
{
  gcc -std=c11 -static "$api" $(pkg-config --static --cflags --libs percuss) -o "$work/api.static" 2> "$work/static.log" || { cat "$work/static.log"; exit 1; }
  gcc -std=c11 "$api" $(pkg-config --cflags --libs percuss-static) -o "$work/api.archive"
  gcc -std=c11 "$api" $(pkg-config --cflags --libs percuss) -lm -o "$work/api.shared"
}
needs() { readelf -d "$1" | grep -c 'NEEDED.*libpercuss' || true; }
[ "$(readelf -d "$work/api.static" | grep -c NEEDED || true)" = 0 ] || { echo "a static program needs a shared library"; exit 1; }
[ "$(needs "$work/api.archive")" = 0 ] || { echo "percuss-static links the shared library"; exit 1; }
[ "$(needs "$work/api.shared")" = 1 ] || { echo "percuss links no shared library"; exit 1; }
for linked in static archive shared; do
  "$work/api.$linked" > "$work/api.$linked.log" || { cat "$work/api.$linked.log"; echo "pkg-config: $linked"; exit 1; }
done
echo "pkg-config: static, archive, shared"
ran=0
jobs=()
for source in crates/capi/tests/c/*.c crates/capi/tests/c/wrapper.cc crates/capi/examples/*.c; do
  # With MuJoCo's header and library, or with arguments: below.
  case $(basename "$source") in mujoco_*.c | real_time.c) continue ;; esac
  (check "$source") &
  jobs+=($!)
done
for job in "${jobs[@]}"; do
  wait "$job" || exit 1
  ran=$((ran + 1))
done
[ "$ran" -ge 9 ] || { echo "only $ran programs were found"; exit 1; }
# The couplings to MuJoCo, with the library of its Python package, where run.sh or PERCUSS_MUJOCO (a folder with include and
# libmujoco.so.*) has it.
mujoco=${PERCUSS_MUJOCO:-$(find "$root/target/external/venv/lib" -maxdepth 3 -type d -name mujoco 2> /dev/null | head -n 1 || true)}
if [ -n "$mujoco" ] && [ -f "$mujoco/include/mujoco/mujoco.h" ]; then
  library=$(find "$mujoco" -maxdepth 1 -name 'libmujoco.so*' | head -n 1)
  for name in mujoco_coupling mujoco_contacts; do
    # MuJoCo's headers are not those of a C11 program without extensions.
    # shellcheck disable=SC2046
    gcc -std=gnu11 -O1 -Wall -Wextra -Werror -isystem "$mujoco/include" "crates/capi/examples/$name.c" \
      $(pkg-config --cflags --libs percuss) "$library" -Wl,-rpath,"$mujoco" -lm -o "$work/$name"
    "$work/$name" || { echo "the coupling to MuJoCo fails: $name"; exit 1; }
  done
else
  echo "C interface: MuJoCo is not installed, the coupling is not run"
fi
# The real-time loop, with every allocation of the program and of the static library counted: its exit code is 1 after one in the loop.
# shellcheck disable=SC2086
gcc -std=c11 "${flags[@]}" -DCOUNT_ALLOCATIONS -Wl,--wrap=malloc,--wrap=calloc,--wrap=realloc,--wrap=posix_memalign \
  -I "$work/prefix/include" crates/capi/examples/real_time.c "$work/prefix/lib/libpercuss.a" $system -o "$work/real_time"
"$work/real_time" models/four_bar.urdf 1000 || { echo "the real-time loop fails"; exit 1; }
# Octave (packages octave and octave-dev), and Julia.
if command -v mkoctfile > /dev/null && command -v octave > /dev/null; then
  (cd "$work" && mkoctfile --mex -I"$work/prefix/include" -L"$work/prefix/lib" "-Wl,-rpath,$work/prefix/lib" \
    "$root/crates/capi/examples/matlab/percuss_mass.c" -lpercuss -o percuss_mass.mex)
  (cd "$work" && octave --quiet --no-gui "$root/crates/capi/examples/matlab/two_links.m" "$root/models/planar_2r.urdf" 2> octave.log) ||
    { cat "$work/octave.log"; echo "the example for Octave fails"; exit 1; }
else
  echo "C interface: Octave (octave, octave-dev) is not installed, its example is not run"
fi
if command -v julia > /dev/null; then
  julia --startup-file=no crates/capi/examples/two_links.jl models/planar_2r.urdf || { echo "the example for Julia fails"; exit 1; }
else
  echo "C interface: Julia is not installed, its example is not run"
fi
# CMake, both libraries.
mkdir -p "$work/cmake"
cat > "$work/cmake/CMakeLists.txt" << END
cmake_minimum_required(VERSION 3.16)
project(uses_percuss C CXX)
find_package(percuss 0.1 REQUIRED)
add_executable(example $root/crates/capi/examples/rebound.c)
target_link_libraries(example percuss::percuss m)
add_executable(layer $root/crates/capi/tests/c/wrapper.cc)
set_target_properties(layer PROPERTIES CXX_STANDARD 17)
target_link_libraries(layer percuss::static)
END
cmake -S "$work/cmake" -B "$work/cmake/build" -DCMAKE_PREFIX_PATH="$work/prefix" > "$work/cmake.log" 2>&1 &&
  cmake --build "$work/cmake/build" >> "$work/cmake.log" 2>&1 || { cat "$work/cmake.log"; exit 1; }
"$work/cmake/build/example" | tail -n 1
"$work/cmake/build/layer"
# Another version of the interface is refused.
sed -i 's/find_package(percuss 0.1 /find_package(percuss 0.9 /' "$work/cmake/CMakeLists.txt"
if cmake -S "$work/cmake" -B "$work/cmake/other" -DCMAKE_PREFIX_PATH="$work/prefix" > "$work/cmake.log" 2>&1; then
  echo "CMake took another version of the interface"
  exit 1
fi
echo "C interface: $ran programs, pkg-config, CMake"
