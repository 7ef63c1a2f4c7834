#!/usr/bin/env bash
# Builds the book of docs/ with mdBook, with the pages of its gallery. A warning of mdBook is a failure. The first run compiles mdBook: about
# a minute of one core.
#   book.sh [PERCUSS]   PERCUSS: a program with the explorer; default: builds one
set -euo pipefail
program=${1:+$(realpath "$1")}
cd "$(dirname "$0")/../.."
target=$(realpath -m "${CARGO_TARGET_DIR:-target}")
version=0.5.4
mdbook=$target/mdbook-$version/bin/mdbook
if [ ! -x "$mdbook" ]; then
  cargo install --locked --quiet --no-default-features --features search --debug --root "$target/mdbook-$version" \
    --target-dir "$target/mdbook-build" "mdbook@$version"
fi
printed=$("$mdbook" build docs --dest-dir "$target/book" 2>&1) || { echo "$printed"; exit 1; }
echo "$printed"
if grep -qE '(WARN|ERROR)' <<< "$printed"; then
  echo "mdBook has warnings"
  exit 1
fi

if [ -z "$program" ]; then
  cargo build --quiet --locked --release -p percuss-cli --features explorer
  program=$target/release/percuss
fi
crates/explorer/gallery.sh "$target/book/live" "$program"
# Pictures open their pages. The book has no files of the repository outside docs: links to them become text.
cd "$target/book"
picture='<label[^>]*><input[^>]*>(<img src="[^"]*figures\/(gallery\/[a-z]+\/)?([a-z-]+)\.(webp|svg)"[^>]*>)<span[^>]*><img[^>]*><\/span><\/label>'
text='(([^<]|<code>|<\/code>)*)<\/a>'
sed -E -i "s/$picture/<a href=\"..\/live\/\3.html\">\1<\/a>/" howto/GALLERY.html
for page in index.html INTRODUCTION.html; do
  sed -E -i "s/$picture/<a href=\"live\/\3.html\">\1<\/a>/; s/howto\/GALLERY.html(\">Open)/live\/double-wishbone.html\1/
    s/<a href=\"\.\.\/[^\"]*\">$text/\1/g" $page
done
sed -E -i "s/<a href=\"(\.\.\/){2}[^\"]*\">$text/\2/g" */*.html
missing=$(grep -ohE 'live/[a-z-]+\.html' index.html howto/GALLERY.html | sort -u | while read -r page; do [ -f "$page" ] || echo "$page"; done)
[ -z "$missing" ] || { echo "pages are missing: $missing"; exit 1; }
