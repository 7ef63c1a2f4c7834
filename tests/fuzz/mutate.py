"""Runs the command over files that are changed at random: bytes, numbers, lines and elements.

    tests/fuzz/mutate.py [--program target/debug/percuss] [--count 5000] [--seed 1]

The files are those of tests/fuzz/corpus, and the flags those that read them. A run must end by itself with the exit code 0, 1 or 2,
without a panic, within 10 s of processor time and 1.5 GB of address space, and write less than 200 kB of messages. Prints the counts of
each format, and exits with 1 where a run did not; its file is kept in tests/fuzz/found.
"""

import argparse
import collections
import io
import os
import pathlib
import random
import re
import resource
import subprocess
import sys
import tempfile
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
CPU_SECONDS = 10
ADDRESS_SPACE = 1_500_000 << 10
MESSAGES = 200_000

POSE = ["--link", "outer", "--point", "0.4,0,0", "--normal", "1,0,0"]
# Commands for each reader: FILE is the changed file, PLANAR a model with the joints "shoulder" and "elbow", ROBOT one with a mesh,
# MESHES one whose inertias follow from the mesh.
COMMANDS = {
    "urdf": [["check", "FILE"], ["mass", "FILE", "--link", "coupler", "--point", "0,0,0", "--normal", "0,1,0"]],
    "mjcf": [["check", "FILE"], ["convert", "FILE", "--to", "sdf", "-o", "-"], ["convert", "FILE", "--to", "mjcf", "-o", "-"]],
    "sdf": [["check", "FILE"], ["convert", "FILE", "--to", "urdf", "-o", "-"], ["convert", "FILE", "--to", "sdf", "-o", "-"]],
    "sheet.toml": [["import", "FILE", "-o", "-"]],
    "sheet.csv": [["import", "FILE", "-o", "-"]],
    "sheet.xlsx": [["import", "FILE", "-o", "-"]],
    "sheet.json": [["import", "FILE", "-o", "-"]],
    "study.toml": [["run", "FILE"]],
    "pose.json": [["mass", "PLANAR", *POSE, "--pose", "FILE"]],
    "rows.csv": [["sweep", "PLANAR", *POSE, "--input", "FILE"]],
    "rows.parquet": [["sweep", "PLANAR", *POSE, "--input", "FILE"]],
    "obj": [["map", "ROBOT", "--link", "a", "--edge", "1"]],
    "stl": [["map", "ROBOT", "--link", "a", "--edge", "1"]],
    "dae": [["map", "ROBOT", "--link", "a", "--edge", "1"]],
    "msh": [["map", "ROBOT", "--link", "a", "--edge", "1"], ["check", "MESHES"]],
}
WORDS = [
    b"0", b"-1", b"1e308", b"1e-308", b"nan", b"inf", b"-0.0", b"18446744073709551616", b"99999999999", b"4294967295", b"\xff\xfe", b"\x00",
    b"\xe2\x80\xae", b"\x1b[2J", b'"', b"'", b"<", b"]]>", b"&x;", b"{", b"[", b"\n", b"\r\n", b",", b"=", b"#", b"..", b"/dev/zero",
]  # fmt: skip


def mutated(data: bytes, others: list[bytes], rng: random.Random) -> bytes:
    """One to four changes of bytes, numbers, lines and elements."""
    for _ in range(rng.choice([1, 1, 1, 2, 4])):
        kind, at = rng.randrange(9), rng.randrange(len(data) + 1)
        end = min(len(data), at + rng.choice([1, 4, 30, 300]))
        if kind == 0 and at < len(data):
            data = data[:at] + bytes([data[at] ^ 1 << rng.randrange(8)]) + data[at + 1 :]
        elif kind == 1:
            data = data[:at] + rng.choice(WORDS) + data[end if rng.random() < 0.5 else at :]
        elif kind == 2:
            data = data[:at] + data[end:]
        elif kind == 3:
            data = data[:at] + data[at:end] * rng.choice([2, 3, 100]) + data[end:]
        elif kind == 4:
            numbers = list(re.finditer(rb"-?\d+(\.\d+)?([eE][-+]?\d+)?", data))
            if numbers:
                found = rng.choice(numbers)
                data = data[: found.start()] + rng.choice(WORDS[:10]) + data[found.end() :]
        elif kind == 5:
            lines = data.split(b"\n")
            a, b = rng.randrange(len(lines)), rng.randrange(len(lines))
            lines[a], lines[b] = lines[b], lines[a]
            data = b"\n".join(lines)
        elif kind == 6:
            elements = list(re.finditer(rb"<[^<>]*>", data))
            if elements:
                found = rng.choice(elements)
                times = rng.choice([0, 2, 50])
                data = data[: found.start()] + found.group() * times + data[found.end() :]
        elif kind == 7:
            other = rng.choice(others)
            cut = rng.randrange(len(other) + 1)
            data = data[:at] + other[cut : cut + 500] + data[end:]
        else:
            data = data[:at]
    return data[: 1 << 20]


def mutated_workbook(data: bytes, others: list[bytes], rng: random.Random) -> bytes:
    """A workbook with one changed part, packed anew: changed bytes of the archive itself rarely pass its checksums."""
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            parts = {name: archive.read(name) for name in archive.namelist()}
    except zipfile.BadZipFile:
        return mutated(data, others, rng)
    changed, packed = rng.choice(list(parts)), io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, part in parts.items():
            archive.writestr(name, mutated(part, list(parts.values()), rng) if name == changed else part)
    return packed.getvalue()


def limit() -> None:
    resource.setrlimit(resource.RLIMIT_AS, (ADDRESS_SPACE, ADDRESS_SPACE))
    resource.setrlimit(resource.RLIMIT_CPU, (CPU_SECONDS, CPU_SECONDS))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=str(ROOT / "target/debug/percuss"))
    parser.add_argument("--count", type=int, default=5000)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    program = str(pathlib.Path(arguments.program).resolve())
    rng = random.Random(arguments.seed)
    corpus = {r: [p.read_bytes() for p in sorted((HERE / "corpus" / r).iterdir())] for r in COMMANDS}
    codes = collections.defaultdict(collections.Counter)
    faults, most_seconds, most_memory = 0, 0.0, 0
    readers = list(COMMANDS)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        # Studies of the corpus name these models.
        for model in (ROOT / "models").glob("*.urdf"):
            (folder / model.name).write_bytes(model.read_bytes())
        for number in range(arguments.count):
            reader = readers[number % len(readers)]
            path = folder / ("file.xml" if reader == "mjcf" else f"file.{reader}")
            change = mutated_workbook if reader == "sheet.xlsx" and rng.random() < 0.8 else mutated
            data = change(rng.choice(corpus[reader]), corpus[reader], rng)
            path.write_bytes(data)
            (folder / "robot.urdf").write_text(
                f'<robot name="r"><link name="base"/><link name="a"><inertial><mass value="1"/><inertia ixx="1e-2" iyy="1e-2" izz="1e-2" '
                f'ixy="0" ixz="0" iyz="0"/></inertial><collision><geometry><mesh filename="{path.name}"/></geometry></collision></link>'
                f'<joint name="j" type="continuous"><parent link="base"/><child link="a"/><axis xyz="0 0 1"/></joint></robot>'
            )
            rules = ["legacy", "exact", "shell", "convex"]
            (folder / "meshes.xml").write_text(
                "<mujoco><asset>"
                + "".join(f'<mesh name="{rule}" file="{path.name}" inertia="{rule}"/>' for rule in rules)
                + "</asset><worldbody>"
                + "".join(f'<body><joint/><geom type="mesh" mesh="{rule}"/></body>' for rule in rules)
                + "</worldbody></mujoco>"
            )
            places = {
                "FILE": str(path),
                "PLANAR": str(folder / "planar_2r.urdf"),
                "ROBOT": str(folder / "robot.urdf"),
                "MESHES": str(folder / "meshes.xml"),
            }
            command = [program, *(places.get(word, word) for word in rng.choice(COMMANDS[reader]))]
            messages = tempfile.TemporaryFile()
            run = subprocess.Popen(
                command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=messages, preexec_fn=limit, cwd=folder
            )
            _, status, used = os.wait4(run.pid, 0)
            run.returncode = code = os.waitstatus_to_exitcode(status)
            seconds = used.ru_utime + used.ru_stime
            most_seconds, most_memory = max(most_seconds, seconds), max(most_memory, used.ru_maxrss)
            length = messages.seek(0, os.SEEK_END)
            messages.seek(0)
            text = messages.read(MESSAGES)
            messages.close()
            codes[reader][code] += 1
            if code not in (0, 1, 2) or b"panicked" in text or length > MESSAGES:
                faults += 1
                (HERE / "found").mkdir(exist_ok=True)
                kept = HERE / "found" / f"{arguments.seed}-{number}.{reader}"
                kept.write_bytes(data)
                print(f"{reader}: exit code {code}, {length} bytes of messages, {seconds:.1f} s: {kept}\n  {' '.join(command[1:])}")
    for reader, counts in codes.items():
        print(f"{reader}: " + ", ".join(f"{n} with exit code {code}" for code, n in sorted(counts.items())))
    print(f"{arguments.count} runs, {faults} faults; at most {most_seconds:.2f} s of processor time and {most_memory >> 10} MB")
    sys.exit(faults > 0)


main()
