#!/usr/bin/env bash
# Builds the command for machines without Rust, tries what it built, and packs it.
#
#   standalone.sh linux      a static binary for Linux; what is packed is run in an empty root
#   standalone.sh windows    percuss.exe; the command's own tests and what is packed run under Wine
#   standalone.sh native     the system that it runs on, with the command's own tests (the release workflow does so)
#   standalone.sh            linux and windows
#
# Needs rustup with a toolchain. What else is missing is installed where there is apt-get: musl-tools (linux);
# gcc-mingw-w64-x86-64, wine, wine64, zip (windows); python3. What it makes is in target/standalone: archives with their
# checksums.
#
# Run on Debian 12: `linux`, whole; `windows`, its tests and then the rest. In a run of the 222 tests under Wine one fails now and then,
# another each time, since Wine does not start the command (its error 1359); each was seen to pass. Not run: `native`, apt-get on a
# machine without the packages, and the three with the engine of the explorer.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
cd "$here/../../.."
target=${CARGO_TARGET_DIR:-$PWD/target}
out=$target/standalone
version=$(sed -n 's/^version = "\(.*\)"$/\1/p' Cargo.toml | head -n 1)
python=$(command -v python3 || command -v python || echo python3)
room=$(mktemp -d)
# The same sources give the same archives: no paths of this machine in the binaries, and the time of the last commit everywhere.
export SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2> /dev/null || echo 946684800)}
export RUSTFLAGS="${RUSTFLAGS:-} --remap-path-prefix=${CARGO_HOME:-$HOME/.cargo}=/cargo --remap-path-prefix=$PWD=/percuss"
trap 'rm -rf "$room"' EXIT
mkdir -p "$out"

fails() {
  echo "standalone.sh: $*" >&2
  exit 1
}

# needs COMMAND PACKAGE…: the command is there, or Debian's packages are installed.
needs() {
  local command=$1 as=()
  shift
  command -v "$command" > /dev/null && return
  [ "$(id -u)" = 0 ] || as=(sudo)
  if command -v apt-get > /dev/null; then
    # Without ${…+…} an empty list is an unset name in older shells.
    ${as[@]+"${as[@]}"} apt-get update -qq
    ${as[@]+"${as[@]}"} apt-get install --yes -qq --no-install-recommends "$@"
  fi
  command -v "$command" > /dev/null || { echo "standalone.sh: $command is missing; Debian's package: $*" >&2; exit 2; }
}

# with_target NAME: the standard library of a target.
with_target() {
  command -v rustup > /dev/null || { echo "standalone.sh: rustup is missing; it installs the target $1" >&2; exit 2; }
  rustup target list --installed | grep -qx "$1" || rustup target add "$1"
}

# package SYSTEM TRIPLE BINARY: the binary with what a user needs beside it, as an archive that the system opens.
package() {
  local name=percuss-$version-$1 triple=$2 binary=$3 archive
  mkdir -p "$room/packed/$name"
  cp "$binary" "$room/packed/$name/"
  cp -r models docs README.md CHANGELOG.md LICENSE-MIT LICENSE-APACHE "$room/packed/$name/"
  "$python" "$here/licences.py" "$triple" > "$room/packed/$name/LICENSES-OF-PARTS.txt"
  case $triple in
    *windows*) archive=$name.zip ;;
    *) archive=$name.tar.gz ;;
  esac
  rm -f "$out/$archive" "$out/$archive.sha256"
  "$python" "$here/archive.py" "$room/packed" "$name" "$out/$archive"
  (cd "$out" && checksum "$archive" > "$archive.sha256")
  echo "made $out/$archive: $(wc -c < "$out/$archive") bytes, the binary $(wc -c < "$binary")"
}

checksum() {
  if command -v sha256sum > /dev/null; then sha256sum "$@"; else shasum -a 256 "$@"; fi
}

# unpacked SYSTEM: the folder that a user has after unpacking; what is in it is checked.
unpacked() {
  local name=percuss-$version-$1 file
  mkdir -p "$room/user"
  (cd "$out" && checksum -c "$name".*.sha256 > "$room/checked") || fails "the checksum of $name is wrong"
  if [ -e "$out/$name.zip" ]; then
    "$python" -m zipfile -e "$out/$name.zip" "$room/user"
  else
    tar -xzf "$out/$name.tar.gz" -C "$room/user"
  fi
  for file in README.md LICENSE-MIT LICENSE-APACHE LICENSES-OF-PARTS.txt docs/reference/OUTPUTS.md models/four_bar.urdf \
    models/suspensions/double-wishbone.toml; do
    [ -s "$room/user/$name/$file" ] || fails "$name has no $file"
  done
  echo "$room/user/$name"
}

linux() {
  local triple=x86_64-unknown-linux-musl
  needs musl-gcc musl-tools
  needs "$python" python3
  with_target $triple
  CC_x86_64_unknown_linux_musl=musl-gcc cargo build --locked --profile dist -p percuss-cli --features full,explorer --target $triple
  local binary=$target/$triple/dist/percuss folder
  # Nothing is loaded with it.
  LC_ALL=C ldd "$binary" 2>&1 | grep -qE "not a dynamic executable|statically linked" || fails "$binary is not static"
  package x86_64-linux $triple "$binary"
  folder=$(unpacked x86_64-linux)
  in_empty_root "$folder"
}

# in_empty_root FOLDER: the folder as a root: no shell, no libraries, no /proc, no fonts.
in_empty_root() {
  local folder=$1 passed=0
  mkdir "$folder/out"
  inside() {
    if [ "$(id -u)" = 0 ]; then chroot "$folder" /percuss "$@"; else unshare -r chroot "$folder" /percuss "$@"; fi
  }
  # shows WORD COMMAND…: the command ends well and shows the word.
  shows() {
    local word=$1 text
    shift
    text=$(inside "$@") || fails "percuss $* fails in an empty root"
    grep -qF -- "$word" <<< "$text" || fails "percuss $* does not show $word: $text"
    passed=$((passed + 1))
  }
  # made FILE: it is there and not empty.
  made() {
    [ -s "$folder/out/$1" ] || fails "$1 was not written in an empty root"
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
  inside explore models/four_bar.urdf -o out/four_bar.html > /dev/null
  made four_bar.html
  inside run models/four_bar.toml --report out/report.html --allow-outside > /dev/null
  made report.html
  echo "static binary in an empty root: $passed passed, 0 failed"
}

windows() {
  local triple=x86_64-pc-windows-gnu folder stub
  needs x86_64-w64-mingw32-gcc gcc-mingw-w64-x86-64
  needs wine wine wine64
  needs "$python" python3
  with_target $triple
  export WINEPREFIX=$target/wine WINEDEBUG=-all WINEDLLOVERRIDES="mscoree,mshtml="
  wineboot --init > /dev/null 2>&1
  stub=$WINEPREFIX/drive_c/windows/system32/bcryptprimitives.dll
  # Later versions of Wine have it.
  [ -e "$stub" ] || x86_64-w64-mingw32-gcc -shared -O2 -o "$stub" "$here/bcryptprimitives.c" -ladvapi32
  CARGO_TARGET_X86_64_PC_WINDOWS_GNU_RUNNER=wine tested --target $triple
  only_system_libraries "$target/$triple/dist/percuss.exe"
  package x86_64-windows $triple "$target/$triple/dist/percuss.exe"
  folder=$(unpacked x86_64-windows)
  "$here/windows.sh" "$folder/percuss.exe"
}

# only_system_libraries EXE: it loads nothing that Windows does not have.
only_system_libraries() {
  local foreign
  foreign=$(x86_64-w64-mingw32-objdump -p "$1" | sed -n 's/.*DLL Name: //p' | grep -viE \
    '^(advapi32|bcrypt|bcryptprimitives|kernel32|msvcrt|ntdll|ole32|shell32|user32|userenv|ws2_32|api-ms-win-.*)\.dll$' || true)
  [ -z "$foreign" ] || fails "$1 loads what is no part of Windows: $foreign"
}

# tested ARGUMENT…: the command's own tests, counted. The program that they run is the one that is packed then.
tested() {
  local code=0
  cargo test --locked --profile dist -p percuss-cli --features explorer --no-fail-fast "$@" > "$room/tests" 2>&1 || code=$?
  awk '/^test result:/ { passed += $4; failed += $6; ignored += $8 }
       END { printf "the command'"'"'s own tests: %d passed, %d failed, %d ignored\n", passed, failed, ignored; exit passed == 0 }' "$room/tests" || code=1
  [ $code -eq 0 ] || { grep -vE "^test .* ok$" "$room/tests" >&2; fails "the command's own tests fail"; }
}

native() {
  local triple system binary
  triple=$(rustc -vV | sed -n 's/^host: //p')
  case $triple in
    *-linux-*) system=linux binary=percuss ;;
    *-apple-darwin) system=macos binary=percuss ;;
    *-windows-*) system=windows binary=percuss.exe ;;
    *) fails "no name for the system of $triple" ;;
  esac
  system=${triple%%-*}-$system
  tested
  package "$system" "$triple" "$target/dist/$binary"
  (cd "$(unpacked "$system")" && "./$binary" mass models/suspensions/double-wishbone.toml --link bump_stop_pad --point 0,0,0 \
    --along-line bump_stop:0,0,0 --against chassis --expect 137.818755 --tolerance 1e-8)
}

case ${1:-all} in
  linux) linux ;;
  windows) windows ;;
  native) native ;;
  all) linux; windows ;;
  *) echo "standalone.sh: unknown argument $1; expected linux, windows, native or nothing" >&2; exit 2 ;;
esac
