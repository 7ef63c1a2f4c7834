#!/bin/sh
# Installs the header files, the static and the shared library, the pkg-config file and the CMake package.
#   install.sh --prefix DIR [--libraries DIR | --without-suspensions]
# Without --libraries they are built in the profile `dist`, with link-time optimisation; --crate-type omits the Rust library, with which cargo
# would skip it. Both are installed without information for debuggers.
# --without-suspensions omits percuss_suspension_…, percuss_kinematics_…, percuss_pose_touch and percuss_ask. Linux and macOS.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
prefix=
libraries=
features=
while [ $# -gt 0 ]; do
  case $1 in
    --prefix) prefix=$2; shift 2 ;;
    --libraries) libraries=$2; shift 2 ;;
    --without-suspensions) features=--no-default-features; shift ;;
    *) echo "install.sh: unknown argument $1; expected --prefix DIR [--libraries DIR | --without-suspensions]" >&2; exit 2 ;;
  esac
done
[ -n "$prefix" ] || { echo "install.sh: --prefix DIR is missing" >&2; exit 2; }
root=$(cd "$here/../../.." && pwd)
if [ -z "$libraries" ]; then
  # shellcheck disable=SC2086
  cargo rustc --locked --profile dist --manifest-path "$root/Cargo.toml" -p percuss-capi --lib $features --crate-type staticlib,cdylib
  libraries=${CARGO_TARGET_DIR:-$root/target}/dist
fi
header=$here/../include/percuss.h
version=$(sed -n 's/^#define PERCUSS_VERSION "\(.*\)"$/\1/p' "$header")
interface=${version%.*}
mkdir -p "$prefix/include" "$prefix/lib/pkgconfig" "$prefix/lib/cmake/percuss"
prefix=$(cd "$prefix" && pwd)
cp "$header" "$here/../include/percuss.hpp" "$prefix/include/"
cp "$libraries/libpercuss_c.a" "$prefix/lib/libpercuss.a"
if [ "$(uname)" = Darwin ]; then
  shared=libpercuss.$interface.dylib
  cp "$libraries/libpercuss_c.dylib" "$prefix/lib/$shared"
  install_name_tool -id "$prefix/lib/$shared" "$prefix/lib/$shared"
  ln -sf "$shared" "$prefix/lib/libpercuss.dylib"
  strip -S "$prefix/lib/libpercuss.a" "$prefix/lib/$shared"
  unused=-Wl,-dead_strip
  system="-framework CoreFoundation -liconv -lm"
else
  # Programs look for the second version number; the first changes less often still.
  shared=libpercuss.so.$interface
  cp "$libraries/libpercuss_c.so" "$prefix/lib/libpercuss.so.$version"
  ln -sf "libpercuss.so.$version" "$prefix/lib/$shared"
  ln -sf "$shared" "$prefix/lib/libpercuss.so"
  # The unwinder is the compiler's own: libgcc_s, or libgcc_eh with -static.
  system="-lutil -lrt -lpthread -lm -ldl"
  strip --strip-debug "$prefix/lib/libpercuss.a"
  strip --strip-unneeded "$prefix/lib/libpercuss.so.$version"
  # The linker omits the parts of the static library that a program does not call.
  unused=-Wl,--gc-sections
fi
for file in percuss.pc:pkgconfig percuss-static.pc:pkgconfig percuss-config.cmake:cmake/percuss percuss-config-version.cmake:cmake/percuss; do
  name=${file%:*}
  sed -e "s|@PREFIX@|$prefix|g" -e "s|@VERSION@|$version|g" -e "s|@INTERFACE@|$interface|g" -e "s|@SHARED@|$shared|g" \
    -e "s|@SYSTEM@|$system|g" -e "s|@UNUSED@|$unused|g" "$here/$name.in" > "$prefix/lib/${file#*:}/$name"
done
