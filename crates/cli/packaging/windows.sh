#!/usr/bin/env bash
# percuss.exe as a Windows user has it, under Wine: drive letters, backslashes, line ends of Windows, names with umlauts and
# spaces, output redirected by cmd.exe in a console with a code page.
#
#   windows.sh PERCUSS.EXE      (WINEPREFIX as standalone.sh sets it)
set -euo pipefail
exe=$(realpath "$1")
here=$(cd "$(dirname "$0")" && pwd)
models=$(realpath "$here/../../../models")
export WINEDEBUG=-all
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
passed=0 failed=0

# The folder as drive P:, so that paths begin with a letter of their own.
ln -sfn "$folder" "$WINEPREFIX/dosdevices/p:"
mkdir "$folder/Fahrwerk vorne ä"
cp "$models/point_mass_pendulum.urdf" "$folder/Fahrwerk vorne ä/Pendel ü.urdf"
cp "$models/suspensions/double-wishbone.toml" "$folder/my.toml"
cp "$exe" "$folder/percuss.exe"

# verdict CODE WHAT
verdict() {
  if [ "$1" -eq 0 ]; then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    echo "FAILED $2"
  fi
}

# holds FILE TEXT WHAT: the file has this text, in UTF-8.
holds() {
  local code=0
  grep -qF -- "$2" "$1" || code=1
  verdict $code "$3: no $2 in $1: $(head -c 600 "$1")"
}

percuss() { (cd "$folder" && wine percuss.exe "$@"); }
pendulum=(--link rod --point 0,0,-0.8 --normal 1,0,0)

percuss mass 'P:\Fahrwerk vorne ä\Pendel ü.urdf' "${pendulum[@]}" > "$folder/letter.txt" || true
holds "$folder/letter.txt" "0.78125 kg" "a path with a drive letter, spaces and umlauts"
percuss mass '.\Fahrwerk vorne ä/Pendel ü.urdf' "${pendulum[@]}" > "$folder/mixed.txt" || true
holds "$folder/mixed.txt" "0.78125 kg" "a path with both kinds of slashes"
code=0
percuss mass 'P:\nothing\at all.urdf' "${pendulum[@]}" 2> "$folder/missing.txt" || code=$?
verdict "$([ $code -eq 2 ]; echo $?)" "a missing file: exit code $code, 2 is expected"
tr -d '\r\n' < "$folder/missing.txt" > "$folder/missing-line.txt"
holds "$folder/missing-line.txt" 'P:\nothing\at all.urdf' "a missing file is named as it was given"

# Files as an editor of Windows saves them: CR LF, and a byte order mark.
sed 's/$/\r/' "$models/four_bar.urdf" > "$folder/crlf.urdf"
percuss check 'P:\crlf.urdf' > "$folder/crlf.txt" || true
holds "$folder/crlf.txt" "four_bar" "a model with line ends of Windows"
{ printf '\xef\xbb\xbf'; sed 's/$/\r/' "$folder/my.toml"; } > "$folder/bom.toml"
percuss import 'P:\bom.toml' -o 'P:\bom.urdf' > "$folder/bom.txt" || true
holds "$folder/bom.txt" "double wishbone" "a sheet with line ends and the mark of Windows"
{ printf 'crank_hinge [deg]\r\n0\r\n30\r\n60\r\n'; } > "$folder/rows.csv"
percuss sweep 'P:\crlf.urdf' --link coupler --point 0.35,0.1,0 --normal 0,1,0 --input 'P:\rows.csv' -o 'P:\out.csv' || true
holds "$folder/out.csv" "effective_mass" "a table with line ends of Windows"
verdict "$([ "$(wc -l < "$folder/out.csv")" -eq 4 ]; echo $?)" "a table of three rows and a header"

# A file is replaced, also by another spelling of the name; an input is refused, also by another spelling.
percuss sweep 'P:\crlf.urdf' --link coupler --point 0.35,0.1,0 --normal 0,1,0 --vary crank_hinge=0:1:7 -o 'p:\OUT.csv' || true
verdict "$([ "$(wc -l < "$folder/out.csv")" -eq 8 ]; echo $?)" "a file that is there is replaced"
code=0
percuss import 'P:\my.toml' -o 'p:\MY.toml' --force 2> "$folder/input.txt" || code=$?
verdict "$([ $code -eq 2 ]; echo $?)" "an input as output: exit code $code, 2 is expected"
holds "$folder/my.toml" "lower_ball" "an input is left as it is"

# cmd.exe with a code page, its output redirected: the file is UTF-8, as programs read it.
cat > "$folder/run.bat" <<'BATCH'
@echo off
chcp 850 >nul
P:
percuss.exe mass "P:\Fahrwerk vorne *" >nul 2>nul
percuss.exe mass P:\crlf.urdf --link coupler --point 0.35,0.1,0 --normal 0,1,0 > P:\redirected.txt
percuss.exe mass P:\crlf.urdf --link nope --point 0.35,0.1,0 --normal 0,1,0 2> P:\errors.txt
>P:\level.txt echo %ERRORLEVEL%
type P:\crlf.urdf | percuss.exe check - > P:\piped.txt
BATCH
sed -i 's/$/\r/' "$folder/run.bat"
(cd "$folder" && wine cmd /c run.bat) > /dev/null 2>&1 || true
holds "$folder/redirected.txt" "contribution of each link" "output redirected by cmd.exe"
holds "$folder/redirected.txt" "█" "bars in UTF-8"
holds "$folder/errors.txt" "nope" "errors redirected by cmd.exe"
holds "$folder/level.txt" "2" "the exit code in cmd.exe"
holds "$folder/piped.txt" "four_bar" "a model piped by cmd.exe"
rm -f "$WINEPREFIX/dosdevices/p:"
echo "percuss.exe under Wine: $passed passed, $failed failed"
[ $failed -eq 0 ] && [ $passed -gt 0 ]
