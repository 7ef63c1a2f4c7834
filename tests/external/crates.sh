#!/usr/bin/env bash
# Packages of the crates, as a registry would get them. CARGO_TARGET_DIR names a target folder to use again. Needs cargo 1.90, the first
# that packages crates that depend on each other.
#   crates.sh --quick [FLAG...]   packages every crate without compiling it, and checks the files of each published package
#   crates.sh [FLAG...]           also compiles each package, installs percuss-cli from the packages in an empty folder, and runs it there
# FLAG: of `cargo package`, such as --allow-dirty for sources with changes that are not committed, or --offline.
set -euo pipefail
cd "$(dirname "$0")/../.."
target=${CARGO_TARGET_DIR:-$PWD/target}
# Bytes of the largest package, compressed. crates.io accepts ten times as much.
largest=1000000

quick=false
if [ "${1-}" = --quick ]; then
  quick=true
  shift
  set -- --no-verify "$@"
fi
rm -f "$target"/package/*.crate
# Tests and benchmarks read the models of the repository and are not published: they do not compile outside it.
$quick || for name in $(cargo metadata --no-deps --locked --format-version 1 | python3 -c '
import json, sys
print(*(package["name"] for package in json.load(sys.stdin)["packages"] if package["publish"] == []))'); do
  set -- --exclude "$name" "$@"
done
cargo package --workspace --locked "$@"

published=$(cargo metadata --no-deps --locked --format-version 1 | python3 -c '
import json, sys
for package in json.load(sys.stdin)["packages"]:
    if package["publish"] != []:
        print(package["name"] + "-" + package["version"])')
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
mkdir "$room/packages" "$room/empty"
fails() {
  echo "crates.sh: $*" >&2
  exit 1
}
for package in $published; do
  archive=$target/package/$package.crate
  size=$(wc -c < "$archive")
  echo "$package: $size bytes"
  [ "$size" -le $largest ] || fails "$package has $size bytes; $largest is the most"
  tar -xzf "$archive" -C "$room/packages"
  for file in Cargo.lock LICENSE-APACHE LICENSE-MIT README.md src/lib.rs; do
    [ -s "$room/packages/$package/$file" ] || fails "$package has no file $file"
  done
  # A checkout without symbolic links has the path in place of the text.
  cmp -s LICENSE-MIT "$room/packages/$package/LICENSE-MIT" || fails "$package has another licence than this folder"
  for folder in benches examples tests; do
    [ ! -e "$room/packages/$package/$folder" ] || fails "$package has the folder $folder"
  done
done
[ $quick = false ] || exit 0

# The registry does not have the packages that percuss-cli needs: folders take their place. The first command writes this to the lock
# file of the package, and keeps the versions of all other packages.
command=$(printf '%s\n' $published | grep '^percuss-cli-')
patches=()
for package in $published; do
  name=${package%-*}
  if grep -q "^name = \"$name\"$" "$room/packages/$command/Cargo.lock" && [ "$package" != "$command" ]; then
    patches+=(--config "patch.crates-io.$name.path='$room/packages/$package'")
  fi
done
cd "$room/empty"
cargo "${patches[@]}" metadata --format-version 1 --manifest-path "$room/packages/$command/Cargo.toml" > "$room/metadata.json"
# Without optimisation: the dependencies are those that the verification has compiled.
cargo "${patches[@]}" install --locked --debug --features full --path "$room/packages/$command" --root "$room/installed" \
  --target-dir "$target"
cat > pendulum.urdf <<'URDF'
<robot name="pendulum">
  <link name="ground"/>
  <link name="rod"/>
  <link name="bob">
    <inertial><mass value="2"/><inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/></inertial>
  </link>
  <joint name="hinge" type="continuous"><parent link="ground"/><child link="rod"/><axis xyz="0 1 0"/></joint>
  <joint name="weld" type="fixed"><parent link="rod"/><child link="bob"/><origin xyz="0 0 -0.5"/></joint>
</robot>
URDF
"$room/installed/bin/percuss" mass pendulum.urdf --link rod --point 0,0,-0.8 --normal 1,0,0 --expect 0.78125
