#!/usr/bin/env bash
# Builds the parts of the explorer that cargo embeds but does not build.
#   build.sh engine        WebAssembly module -> engine/percuss.wasm.lzma; then: cargo build --release --features explorer
#   build.sh page          bundle of the page -> page/dist; needs npm
#   build.sh page --check  builds the bundle again and compares the bytes with page/dist
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
# Limits of the compressed module, bytes, with and without wasm-opt. Every page contains the module.
largest_module=1350000
largest_without_tools=1450000

engine() {
  rustup target list --installed | grep -qx wasm32-unknown-unknown || rustup target add wasm32-unknown-unknown
  # No path of this machine is in the module: the bytes are the same on every machine with the same compiler. Only as a cdylib: cargo
  # leaves out the link-time optimisation of a crate that is an rlib as well.
  local cargo_home=${CARGO_HOME:-$HOME/.cargo}
  local sysroot; sysroot=$(rustc --print sysroot)
  RUSTFLAGS="--remap-path-prefix=$root=percuss --remap-path-prefix=$cargo_home=cargo --remap-path-prefix=$sysroot=rust" \
    cargo rustc --locked --manifest-path "$root/Cargo.toml" --profile web --target wasm32-unknown-unknown -p percuss-web --crate-type cdylib
  local module=${CARGO_TARGET_DIR:-$root/target}/wasm32-unknown-unknown/web/percuss_web.wasm
  local packed=$here/engine/percuss.wasm.lzma
  if [ "$packed" -nt "$module" ]; then
    echo "engine/percuss.wasm.lzma is up to date"
    return
  fi
  if command -v wasm-opt > /dev/null; then
    # The features that the compiler uses by default.
    wasm-opt -Oz --enable-simd --enable-bulk-memory --enable-sign-ext --enable-nontrapping-float-to-int --enable-mutable-globals \
      --enable-multivalue --enable-reference-types "$module" -o "$module.small"
    module=$module.small
  else
    echo "wasm-opt is not installed (Debian: apt install binaryen): the page is a twentieth larger"
    largest_module=$largest_without_tools
  fi
  # LZMA is a fifth smaller than gzip; the page decodes the module in a third of a second.
  if command -v xz > /dev/null; then
    xz --format=lzma -9e -c "$module" > "$packed.part"
  elif ! python3 - "$module" > "$packed.part" <<< 'import lzma, sys
sys.stdout.buffer.write(lzma.compress(open(sys.argv[1], "rb").read(), lzma.FORMAT_ALONE, preset=9 | lzma.PRESET_EXTREME))'; then
    echo "xz or python3 is needed (Debian: apt install xz-utils)" >&2
    exit 1
  fi
  local size; size=$(wc -c < "$packed.part")
  echo "engine/percuss.wasm.lzma: $size bytes ($(wc -c < "$module") unpacked)"
  if [ "$size" -gt "$largest_module" ]; then
    echo "the module is larger than $largest_module bytes" >&2
    exit 1
  fi
  for prefix in "$root" "$cargo_home" "$sysroot"; do
    if grep -qaF "$prefix" "$module"; then
      echo "the module contains the path $prefix" >&2
      exit 1
    fi
  done
  mv "$packed.part" "$packed"
}

page() {
  local work=$root/target/explorer-page
  mkdir -p "$work"
  cp "$here/page/package.json" "$here/page/package-lock.json" "$work"
  [ -d "$work/node_modules" ] && cmp -s "$here/page/package-lock.json" "$work/installed.json" ||
    (cd "$work" && npm ci --ignore-scripts --no-audit --no-fund --silent && cp package-lock.json installed.json)
  node "$here/page/build.mjs" "$here/page" "$work" "$@"
}

case ${1:-} in
  engine) engine ;;
  page) shift; page "$@" ;;
  *) sed -n '2,6s/^# \{0,1\}//p' "$0"; exit 2 ;;
esac
