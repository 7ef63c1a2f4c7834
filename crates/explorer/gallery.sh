#!/usr/bin/env bash
# Writes the pages of docs/howto/GALLERY.md: every command `percuss explore` and `percuss run` of that page is run.
#   gallery.sh FOLDER [PERCUSS]   PERCUSS: a program with the explorer; default: target/release/percuss
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
[ $# -ge 1 ] || { sed -n '2,3s/^# \{0,1\}//p' "$0"; exit 2; }
mkdir -p "$1"
folder=$(cd "$1" && pwd)
percuss=$(realpath "${2:-$root/target/release/percuss}")
cd "$root"
count=0
while read -r _ command; do
  read -ra words <<< "$command"
  words[-1]=$folder/${words[-1]}
  # A report may be outside the folder of its study.
  if [ "${words[0]}" = run ]; then words+=(--allow-outside); fi
  "$percuss" "${words[@]}" --force > /dev/null
  count=$((count + 1))
done < <(grep -E '^target/release/percuss (explore|run) ' docs/howto/GALLERY.md)
[ "$count" -gt 0 ] || { echo "docs/howto/GALLERY.md has no command"; exit 1; }
echo "$count pages in $folder"
