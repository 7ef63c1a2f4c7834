#!/usr/bin/env bash
# Writes the pages of docs/howto/GALLERY.md: every command `percuss explore` of that page is run.
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
  "$percuss" "${words[@]}" --force > /dev/null
  count=$((count + 1))
done < <(grep '^target/release/percuss explore ' docs/howto/GALLERY.md)
[ "$count" -gt 0 ] || { echo "docs/howto/GALLERY.md has no command"; exit 1; }
echo "$count pages in $folder"
