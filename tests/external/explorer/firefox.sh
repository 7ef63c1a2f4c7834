#!/usr/bin/env bash
# The page of `percuss explore` in Firefox: m̄ of every example of the gallery is that of the command, before and after a change, and
# the address keeps the state. Needs Firefox (Debian: apt install firefox-esr), python3 and the engine. WebGL
# needs a screen or Xvfb (apt install xvfb); without, the mechanism is drawn as lines.
#   firefox.sh [PERCUSS]   PERCUSS: a program with the explorer; default: target/debug/percuss
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../../.." && pwd)
work=$root/target/explorer-firefox
browser=${FIREFOX:-$(command -v firefox-esr || command -v firefox || true)}
[ -n "$browser" ] || { echo "Firefox is needed: apt install firefox-esr, or FIREFOX=/path/to/it" >&2; exit 1; }
percuss=$(realpath "${1:-$root/target/debug/percuss}")
"$root/crates/explorer/gallery.sh" "$work/pages" "$percuss"
run=(python3 "$here/firefox.py" "$browser" "$work/pages" "$percuss" "$root")
if [ -z "${DISPLAY:-}" ] && command -v xvfb-run > /dev/null; then
  xvfb-run -a "${run[@]}"
else
  "${run[@]}" --headless
fi
