#!/usr/bin/env bash
# Wheels of the Python package, one per platform for all Pythons from 3.10 on, in FOLDER (default: target/wheels).
#
#   wheels.sh [--output FOLDER] [PLATFORM...]      PLATFORM: manylinux, windows, macos; default: all that this machine can build
#
# manylinux: x86_64, glibc 2.17, linked by zig (packages maturin and ziglang of pip, in an environment of this script). The wheel is
#   installed in a clean environment, and its tests run there.
# windows: x86_64, by MinGW-w64 (Debian: gcc-mingw-w64-x86-64) and `rustup target add x86_64-pc-windows-gnu`. It is not run here: on
#   Windows, `pip install percuss-….whl` and `python -m pytest crates/python/tests`.
# macos: x86_64 and arm64 in one wheel, on a Mac with `rustup target add x86_64-apple-darwin aarch64-apple-darwin`; Apple's headers
#   cannot be used elsewhere.
set -euo pipefail
cd "$(dirname "$0")/../../.."
root=$PWD
target=${CARGO_TARGET_DIR:-$root/target}
output=$target/wheels
platforms=()
while [ $# -gt 0 ]; do
  case $1 in
    --output) output=$2; shift ;;
    manylinux | windows | macos) platforms+=("$1") ;;
    *) echo "wheels.sh: unknown argument $1; expected [--output FOLDER] [manylinux] [windows] [macos]" >&2; exit 2 ;;
  esac
  shift
done
has_target() { rustup target list --installed 2> /dev/null | grep -qx "$1"; }
if [ ${#platforms[@]} -eq 0 ]; then
  case $(uname -s) in
    Darwin) platforms=(macos) ;;
    *)
      platforms=(manylinux)
      if command -v x86_64-w64-mingw32-gcc > /dev/null && has_target x86_64-pc-windows-gnu; then
        platforms+=(windows)
      else
        echo "wheels.sh: no wheel for Windows: install gcc-mingw-w64-x86-64 and run rustup target add x86_64-pc-windows-gnu"
      fi
      echo "wheels.sh: no wheel for macOS: it is built on a Mac, by wheels.sh macos"
      ;;
  esac
fi
mkdir -p "$output"
tools=$target/external/wheels/tools
if [ ! -x "$tools/bin/maturin" ]; then
  python3 -m venv "$tools"
  "$tools/bin/pip" install --quiet --disable-pip-version-check "maturin>=1.7,<2" ziglang
fi
export PATH=$tools/bin:$PATH
# PERCUSS_WHEEL_PROFILE: another profile of the workspace, to test this script faster than with link-time optimisation.
wheel() { maturin build --locked --profile "${PERCUSS_WHEEL_PROFILE:-dist}" --manifest-path crates/python/Cargo.toml --out "$output" "$@"; }

# The newest wheel of a platform is installed in a new environment, away from the sources, and tested there.
test_wheel() {
  local made clean=$target/external/wheels/clean
  made=$(find "$output" -name "percuss-*$1*.whl" -printf '%T@ %p\n' | sort -n | tail -n 1 | cut -d' ' -f2)
  rm -rf "$clean"
  python3 -m venv "$clean"
  "$clean/bin/pip" install --quiet --disable-pip-version-check "$made" pytest scipy
  # Tests without other programs: the numbers, the models, and every public call in forks and threads.
  (cd "$root/crates/python" && PYTHONDONTWRITEBYTECODE=1 "$clean/bin/python" -m pytest -q -p no:cacheprovider \
    tests/test_models.py tests/test_motion.py tests/test_matrices.py tests/test_every_call.py)
  "$clean/bin/percuss" --version
  echo "wheels.sh: $(basename "$made") is installed and tested, $(du -k "$made" | cut -f1) kB"
}

for platform in "${platforms[@]}"; do
  case $platform in
    manylinux)
      wheel --target x86_64-unknown-linux-gnu --zig --compatibility manylinux2014
      test_wheel manylinux
      ;;
    windows)
      # Python's import library is not needed: PyO3 names the functions of python3.dll itself.
      wheel --target x86_64-pc-windows-gnu
      ;;
    macos)
      wheel --target universal2-apple-darwin
      ;;
  esac
done
ls -l "$output"
