"""Takes files that run.sh found, and that reach code that no file of tests/fuzz/corpus reaches, into tests/fuzz/corpus.

    tests/fuzz/keep.py [--count 10] [--bytes 1024] [READER...]

For each reader libFuzzer selects the files that together reach all code that was reached. Of those with at most this number of bytes,
some of every size are taken.
"""

import argparse
import hashlib
import os
import pathlib
import subprocess
import tempfile

HERE = pathlib.Path(__file__).resolve().parent


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=10)
    parser.add_argument("--bytes", type=int, default=1024)
    parser.add_argument("readers", nargs="*")
    arguments = parser.parse_args()
    target = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", HERE.parent.parent / "target")) / "fuzz"
    program = next(target.glob("*/release/percuss-fuzz"))
    for found in sorted((target / "corpus").iterdir()):
        if arguments.readers and found.name not in arguments.readers:
            continue
        corpus = HERE / "corpus" / found.name
        with tempfile.TemporaryDirectory() as chosen:
            command = [program, "-set_cover_merge=1", "-timeout=5", "-rss_limit_mb=1500", "-artifact_prefix=/dev/null", chosen, corpus, found]
            subprocess.run(command, check=True, capture_output=True, env={**os.environ, "PERCUSS_READER": found.name})
            here = {path.read_bytes() for path in corpus.iterdir()}
            new = {path.read_bytes() for path in pathlib.Path(chosen).iterdir()} - here
        small = sorted((data for data in new if len(data) <= arguments.bytes), key=lambda data: (len(data), data))
        count = min(arguments.count, len(small))
        kept = [small[(number + 1) * len(small) // count - 1] for number in range(count)]
        for data in kept:
            (corpus / hashlib.sha256(data).hexdigest()[:12]).write_bytes(data)
        print(f"{found.name}: {len(kept)} of {len(new)} files taken, {sum(map(len, kept))} bytes")


main()
