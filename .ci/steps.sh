# Steps of the two scripts in this folder, with their times; sourced. KEEP_GOING=1 runs the steps after a failed one too.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
export CARGO_TERM_COLOR=never RUST_BACKTRACE=0 CARGO_INCREMENTAL=0
steps=$PWD/target/steps
rm -rf "$steps" && mkdir -p "$steps"
beside=()
trap 'kill $(jobs -p) 2> /dev/null' EXIT

# run_step NAME COMMAND...: writes wall and CPU seconds and the exit code to a file.
run_step() {
  local name=$1 code TIMEFORMAT='%R %U %S'
  shift
  echo "== $name: $*"
  # In a subshell: otherwise the time contains that of steps beside which end meanwhile.
  ( time "$@" 2>&3 ) 3>&2 2> "$steps/$name.time"
  code=$?
  echo "$code" > "$steps/$name.code"
  echo "== $name: exit $code"
  return $code
}

# step NAME COMMAND...: one step; a failed one ends the script, unless KEEP_GOING is set.
step() {
  echo "$1" >> "$steps/order"
  run_step "$@" || [ -n "${KEEP_GOING-}" ] || finish
}

# step_beside NAME COMMAND...: in the background; finish_beside waits for these steps and prints their output.
step_beside() {
  echo "$1" >> "$steps/order"
  run_step "$@" > "$steps/$1.log" 2>&1 &
  beside+=("$! $1")
}
# step_after 'EARLIER...' NAME COMMAND...: in the background, after steps of the background; not run if one of them failed.
step_after() {
  local earlier=$1
  shift
  echo "$1" >> "$steps/order"
  (
    for name in $earlier; do
      until [ -s "$steps/$name.code" ]; do sleep 0.2; done
      [ "$(cat "$steps/$name.code")" = 0 ] || exit 1
    done
    run_step "$@"
  ) > "$steps/$1.log" 2>&1 &
  beside+=("$! $1")
}
finish_beside() {
  local entry failed=''
  for entry in "${beside[@]}"; do
    wait "${entry% *}" || failed=1
    cat "$steps/${entry#* }.log"
  done
  beside=()
  [ -z "$failed" ] || [ -n "${KEEP_GOING-}" ] || finish
}

# Prints the table of all steps; the exit code is 1 if one failed.
finish() {
  local name code wall user system passed=0 failed=0
  printf '\n%-24s %8s %8s  %s\n' step 'wall, s' 'CPU, s' result
  while read -r name; do
    code=$(cat "$steps/$name.code" 2> /dev/null || echo 'not finished')
    read -r wall user system < <(tail -n 1 "$steps/$name.time" 2> /dev/null) || wall=0 user=0 system=0
    [ "$code" = 0 ] && passed=$((passed + 1)) || failed=$((failed + 1))
    awk -v name="$name" -v wall="$wall" -v user="$user" -v system_time="$system" -v code="$code" \
      'BEGIN { printf "%-24s %8.0f %8.0f  %s\n", name, wall, user + system_time, code == "0" ? "passed" : "FAILED (" code ")" }'
  done < "$steps/order"
  printf '%-24s %8d\n' 'all, side by side' "$SECONDS"
  echo "$passed passed, $failed failed"
  [ "$failed" = 0 ]
  exit
}

command -v cargo > /dev/null || { echo "a Rust toolchain with cargo is needed"; exit 1; }
for component in rustfmt clippy; do
  cargo "${component/rust/}" --version > /dev/null 2>&1 || rustup component add "$component"
done
if ! python3 -c 'import venv, ensurepip' 2> /dev/null; then
  apt-get update -qq && apt-get install -y -qq python3 python3-venv python3-pip
fi

# readme_command BEGINNING: a command that the README promises.
readme_command() { grep -m1 -E "^$1" README.md || { echo "the README has no command that begins with $1" >&2; return 1; }; }
# A lock file that is not complete is refused at once, and not by the last step.
lock_files() {
  local project
  for project in . tests/fuzz; do
    cargo metadata --locked --format-version 1 --manifest-path $project/Cargo.toml > /dev/null || return 1
  done
}
