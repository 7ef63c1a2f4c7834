#!/usr/bin/env bash
# Builds the command for machines without Rust, and tries it.
#
#   standalone.sh linux      a static binary, tried in an empty chroot
#   standalone.sh windows    percuss.exe; the command's own tests run on it under Wine
#   standalone.sh            both
#
# Needs rustup, and as Debian packages: musl-tools (linux); gcc-mingw-w64-x86-64, wine, wine64 (windows). What it makes is in
# target/standalone, with checksums.
#
# Not run whole: a static binary and percuss.exe were built, unoptimised, with the targets named here; the former answered and wrote
# every kind of table and figure in an empty root, the latter went through windows.sh. The release build of this script, its
# archives, and the suites of `cargo test` under Wine were not run.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
cd "$here/../../.."
target=${CARGO_TARGET_DIR:-$PWD/target}
out=$target/standalone
version=$(sed -n 's/^version = "\(.*\)"$/\1/p' Cargo.toml | head -n 1)
mkdir -p "$out"

needs() {
  command -v "$1" > /dev/null || { echo "standalone.sh: $1 is missing; Debian's package: $2" >&2; exit 2; }
}

# with_target NAME: the standard library of a target.
with_target() {
  rustup target list --installed | grep -qx "$1" || rustup target add "$1"
}

linux() {
  local triple=x86_64-unknown-linux-musl
  needs musl-gcc musl-tools
  with_target $triple
  CC_x86_64_unknown_linux_musl=musl-gcc cargo build --locked --release -p percuss-cli --target $triple
  local binary=$target/$triple/release/percuss
  # Nothing is loaded with it.
  if ! LC_ALL=C ldd "$binary" 2>&1 | grep -qE "not a dynamic executable|statically linked"; then
    echo "standalone.sh: $binary is not static" >&2
    exit 1
  fi
  in_empty_root "$binary"
  package linux "$binary" percuss
}

# in_empty_root BINARY: a root that holds the binary and some models, no shell, no libraries, no /proc, no fonts.
in_empty_root() {
  local room passed=0
  room=$(mktemp -d)
  cp "$1" "$room/percuss"
  cp -r models "$room/models"
  mkdir "$room/out"
  inside() {
    if [ "$(id -u)" = 0 ]; then chroot "$room" /percuss "$@"; else unshare -r chroot "$room" /percuss "$@"; fi
  }
  # shows WORD COMMAND…: the command ends well and shows the word.
  shows() {
    local word=$1 text
    shift
    text=$(inside "$@") || { echo "standalone.sh: percuss $* fails in an empty root" >&2; exit 1; }
    grep -qF -- "$word" <<< "$text" || { echo "standalone.sh: percuss $* does not show $word: $text" >&2; exit 1; }
    passed=$((passed + 1))
  }
  # made FILE: it is there and not empty.
  made() {
    [ -s "$room/out/$1" ] || { echo "standalone.sh: $1 was not written in an empty root" >&2; exit 1; }
    passed=$((passed + 1))
  }
  local stop="--link bump_stop_pad --point 0,0,0 --along-line bump_stop:0,0,0 --against chassis"
  shows "percuss $version" --version
  shows "0.78125 kg" mass models/point_mass_pendulum.urdf --link rod --point 0,0,-0.8 --normal 1,0,0 --expect 0.78125
  shows "degrees of freedom" check models/six_bar.urdf
  shows "137.818755 kg" mass models/suspensions/double-wishbone.toml $stop
  shows "double wishbone" import models/suspensions/double-wishbone-with-table.toml -o out/my.urdf --picture out/my.png
  made my.urdf
  made my.png
  local ending
  for ending in csv xlsx parquet json svg png pdf; do
    # With figures' text: fonts are in the binary.
    inside sweep models/double_wishbone.urdf $stop --vary travel:spindle:0,0,0:0,0,1=-20mm:20mm:5 --threads 2 \
      -o out/sweep.$ending > /dev/null
    made sweep.$ending
  done
  inside run models/four_bar.toml --report out/report.html --allow-outside > /dev/null
  made report.html
  rm -rf "$room"
  echo "static binary in an empty root: $passed passed, 0 failed"
}

windows() {
  local triple=x86_64-pc-windows-gnu
  needs x86_64-w64-mingw32-gcc gcc-mingw-w64-x86-64
  needs wine "wine and wine64"
  with_target $triple
  cargo build --locked --release -p percuss-cli --target $triple
  package windows "$target/$triple/release/percuss.exe" percuss.exe
  export WINEPREFIX=$target/wine WINEDEBUG=-all WINEDLLOVERRIDES="mscoree,mshtml="
  wineboot --init > /dev/null 2>&1
  x86_64-w64-mingw32-gcc -shared -O2 -o "$WINEPREFIX/drive_c/windows/system32/bcryptprimitives.dll" \
    "$here/bcryptprimitives.c" -ladvapi32
  CARGO_TARGET_X86_64_PC_WINDOWS_GNU_RUNNER=wine cargo test --locked --release -p percuss-cli --target $triple --no-fail-fast
  "$here/windows.sh" "$target/$triple/release/percuss.exe"
}

# package SYSTEM BINARY NAME: the binary with what a user needs beside it.
package() {
  local name=percuss-$version-x86_64-$1 folder
  folder=$out/$name
  rm -rf "$folder"
  mkdir -p "$folder"
  cp "$2" "$folder/$3"
  cp -r models README.md LICENSE-MIT LICENSE-APACHE "$folder/"
  (cd "$out" && tar -czf "$name.tar.gz" "$name" && sha256sum "$name.tar.gz" > "$name.tar.gz.sha256")
  rm -rf "$folder"
  echo "made $out/$name.tar.gz"
}

case ${1:-all} in
  linux) linux ;;
  windows) windows ;;
  all) linux; windows ;;
  *) echo "standalone.sh: unknown argument $1; expected linux, windows or nothing" >&2; exit 2 ;;
esac
