#!/usr/bin/env python3
"""The licences of what is linked into the command, as text on stdout.

    licences.py TRIPLE

The crates are those that cargo resolves for the target, without what only builds or tests; each with the files of its licence,
those of the same text together. Ends with exit code 1 where a crate names no licence.
"""

import json
import subprocess
import sys
from pathlib import Path

NAMES = ("licen", "copying", "notice", "copyright", "unlicense")
# What the toolchain links in besides: file of Debian's package, where it is installed.
TOOLCHAIN = {
    "musl": [("musl, the C library", "/usr/share/doc/musl/copyright")],
    "windows-gnu": [
        ("mingw-w64, the start of the program and its libraries", "/usr/share/doc/mingw-w64-common/copyright"),
        ("libgcc, by its runtime library exception", "/usr/share/doc/gcc-mingw-w64-x86-64/copyright"),
    ],
}


def crates(triple):
    """Packages that are linked into percuss-cli, without those of this repository."""
    command = ["cargo", "metadata", "--locked", "--format-version", "1", "--filter-platform", triple]
    metadata = json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout)
    packages = {package["id"]: package for package in metadata["packages"]}
    nodes = {node["id"]: node for node in metadata["resolve"]["nodes"]}
    ahead = [name for name, package in packages.items() if package["name"] == "percuss-cli"]
    seen = set(ahead)
    while ahead:
        for dependency in nodes[ahead.pop()]["deps"]:
            is_linked = any(kind["kind"] is None for kind in dependency["dep_kinds"])
            target = packages[dependency["pkg"]]
            is_macro = any("proc-macro" in part["kind"] for part in target["targets"])
            if is_linked and not is_macro and dependency["pkg"] not in seen:
                seen.add(dependency["pkg"])
                ahead.append(dependency["pkg"])
    found = [packages[name] for name in seen if packages[name]["source"]]
    return sorted(found, key=lambda package: (package["name"], package["version"]))


def files(folder):
    """The texts of the licence files in a crate's folder, and one level below: of sources in C that it builds, too."""
    entries = sorted(folder.iterdir())
    entries += sorted(inner for entry in entries if entry.is_dir() for inner in entry.iterdir())
    named = [entry for entry in entries if entry.name.lower().startswith(NAMES) or entry.parent.name.lower().startswith(NAMES)]
    found = [entry for entry in named if entry.is_file() and entry.suffix not in (".rs", ".toml")]
    return [entry.read_text(encoding="utf-8", errors="replace").strip() for entry in found]


def main(triple):
    texts, users, without = {}, {}, 0

    def used(text, title):
        # Those that differ in line ends and indents are one.
        key = " ".join(text.split())
        texts.setdefault(key, text)
        users.setdefault(key, {})[title] = None

    linked = crates(triple)
    print("percuss is under MIT OR Apache-2.0 (LICENSE-MIT, LICENSE-APACHE). Linked into it are:\n")
    for package in linked:
        title = f"{package['name']} {package['version']}"
        authors = ", ".join(package["authors"])
        print(f"{title}: {package['license'] or 'see below'}; {package['repository'] or 'crates.io'}; {authors or 'authors not named'}")
        found = files(Path(package["manifest_path"]).parent)
        without += not (found or package["license"])
        for text in found:
            used(text, title)
    print("Rust's standard library: MIT OR Apache-2.0; https://github.com/rust-lang/rust")
    font = Path("crates/render/assets/LICENSE-APACHE").read_text(encoding="utf-8").strip()
    used(font, "Roboto, the font of figures")
    for part, entries in TOOLCHAIN.items():
        for title, path in entries if part in triple else []:
            print(f"{title}: see below")
            used(Path(path).read_text(encoding="utf-8", errors="replace").strip(), title)
    for key, text in texts.items():
        print(f"\n{'=' * 100}\n{', '.join(users[key])}\n{'-' * 100}\n{text}")
    return 1 if without or not linked else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
