#!/bin/sh
# cargo as maturin calls it (CARGO) for `python.sh --gate`: the extension with the features of `cargo test --workspace`,
# so that it alone is compiled. Features of tests count where a test is named: any will do. Maturin passes --locked, and
# cargo takes it once.
if [ "$1" = rustc ]; then
  shift
  exec cargo build --workspace --test capi "$@" # with --locked
fi
exec cargo "$@"
