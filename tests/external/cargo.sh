#!/bin/sh
# cargo as maturin calls it (CARGO): the Python package together with the programs that run.sh builds. By itself it has other features of
# some dependencies, and everything below would be compiled once more.
if [ "$1" = rustc ]; then
  shift
  exec cargo build --package percuss-python --package percuss-tests --package percuss-cli --bins "$@"
fi
exec cargo "$@"
