#!/bin/sh
# cargo as maturin calls it (CARGO) for `python.sh --tested`: the extension with the features with which `cargo test --workspace` has built
# everything below it, so that it alone is compiled. Maturin passes --locked, and cargo takes it once. Features of tests count where a test is asked for: any will do, and is there.
if [ "$1" = rustc ]; then
  shift
  exec cargo build --workspace --test header "$@" # with --locked
fi
exec cargo "$@"
