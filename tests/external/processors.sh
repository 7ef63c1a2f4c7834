#!/usr/bin/env bash
# Lanes of other processors: the example `lanes` of the crate percuss on 64-bit ARM (qemu) and in WebAssembly with 128-bit SIMD (node). Each run
# compares one configuration and lanes with the poses, and fails if they differ. Not a part of run.sh: two builds of three minutes each.
set -euo pipefail
cd "$(dirname "$0")/../.."

install() { command -v "$1" > /dev/null || { apt-get update -qq && apt-get install -y -qq "${@:2}"; }; }
install qemu-aarch64 qemu-user
install aarch64-linux-gnu-gcc gcc-aarch64-linux-gnu libc6-dev-arm64-cross
install node nodejs
rustup target add aarch64-unknown-linux-gnu wasm32-wasip1

build() { cargo build --locked --release --package percuss --example lanes --target "$1"; }
target=${CARGO_TARGET_DIR:-target}

CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_LINKER=aarch64-linux-gnu-gcc build aarch64-unknown-linux-gnu
qemu-aarch64 -L /usr/aarch64-linux-gnu "$target/aarch64-unknown-linux-gnu/release/examples/lanes"

RUSTFLAGS="-C target-feature=+simd128" build wasm32-wasip1
node --no-warnings --input-type=module - "$target/wasm32-wasip1/release/examples/lanes.wasm" <<'JS'
import { readFileSync } from "node:fs";
import { WASI } from "node:wasi";
const wasi = new WASI({ version: "preview1", args: ["lanes"] });
const compiled = await WebAssembly.compile(readFileSync(process.argv.at(-1)));
wasi.start(await WebAssembly.instantiate(compiled, wasi.getImportObject()));
JS
