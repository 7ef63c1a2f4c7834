#!/usr/bin/env bash
# Coverage-guided fuzzing of every reader of files, each in turn:
#   tests/fuzz/run.sh [SECONDS] [READER...]
# SECONDS is the time for each reader (300: an hour for all twelve). Exit 1 on a panic, on a file that takes more than 5 s or more
# than 1.5 GB; the file is then in tests/fuzz/found. What is new by its coverage is in target/fuzz/corpus; keep.py takes
# small files of it into tests/fuzz/corpus, which tests/readers.rs reads in every test run.
# Needs a C++ compiler (libFuzzer is compiled from the crate libfuzzer-sys) and no sanitizer: percuss has no unsafe code in its readers.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
seconds=${1:-300}
shift $(($# > 0 ? 1 : 0))
readers=("$@")
[ ${#readers[@]} -gt 0 ] || readers=(urdf mjcf sdf sheet.toml sheet.csv sheet.xlsx sheet.json study.toml pose.json rows.csv rows.parquet obj stl dae)
target=${CARGO_TARGET_DIR:-$root/target}/fuzz
coverage="-Cpasses=sancov-module -Cllvm-args=-sanitizer-coverage-level=3 -Cllvm-args=-sanitizer-coverage-inline-8bit-counters -Cllvm-args=-sanitizer-coverage-pc-table -Cllvm-args=-sanitizer-coverage-trace-compares -Ccodegen-units=1 --cfg fuzzing"
host=$(rustc -vV | sed -n 's/^host: //p')
# With a target given, build scripts and macros are compiled without the counters.
RUSTFLAGS=$coverage cargo build --locked --release --quiet --manifest-path "$here/Cargo.toml" --target "$host" --target-dir "$target"
# A frame of code that is not optimised can exceed the usual stack of a thread.
export RUST_MIN_STACK=67108864
mkdir -p "$here/found"
folder=$(mktemp -d -p /dev/shm 2> /dev/null || mktemp -d)
trap 'rm -rf "$folder"' EXIT
failed=0
for reader in "${readers[@]}"; do
  mkdir -p "$target/corpus/$reader"
  if ! TMPDIR=$folder PERCUSS_READER=$reader "$target/$host/release/percuss-fuzz" -max_total_time="$seconds" -timeout=5 -rss_limit_mb=1500 \
    -max_len=16384 -print_final_stats=1 -artifact_prefix="$here/found/$reader-" "$target/corpus/$reader" "$here/corpus/$reader" \
    > "$target/$reader.log" 2>&1; then
    echo "$reader: FAILED, see $target/$reader.log and $here/found" >&2
    failed=1
  fi
  awk -v reader="$reader" '/stat::number_of_executed_units/ { runs = $2 } /stat::peak_rss_mb/ { rss = $2 }
    /cov: / { for (i = 1; i < NF; i++) if ($i == "cov:") cov = $(i + 1) }
    END { printf "%s: %d files, coverage %d, at most %d MB\n", reader, runs, cov, rss }' "$target/$reader.log"
done
rmdir "$here/found" 2> /dev/null || true
exit $failed
