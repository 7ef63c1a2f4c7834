"""Writes the Python of the documentation as files, one for each page and notebook, for mypy and pyright.

    blocks.py FOLDER
"""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]


def pages() -> Iterator[tuple[str, list[str]]]:
    """Name and blocks of every page and notebook with Python."""
    for page in sorted([ROOT / "README.md", ROOT / "crates/python/README.md", *(ROOT / "docs").rglob("*.md")]):
        blocks = re.findall(r"^```python\n(.*?)^```", page.read_text(), flags=re.S | re.M)
        if blocks:
            yield "_".join(page.relative_to(ROOT).with_suffix("").parts), blocks
    for notebook in sorted((ROOT / "crates/python/examples").glob("*.ipynb")):
        cells = json.loads(notebook.read_text())["cells"]
        yield notebook.stem + "_notebook", ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]


def statement(line: str) -> str:
    """A line without the commands of notebooks."""
    return line if not line.lstrip().startswith("%") else ""


def main() -> None:
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.glob("*.py"):
        old.unlink()
    for name, blocks in pages():
        lines = "\n\n".join(blocks).splitlines()
        # Later imports belong at the head.
        imports = [line for line in lines if line.startswith("from __future__")]
        rest = [statement(line) for line in lines if not line.startswith("from __future__")]
        (folder / f"{name.replace('-', '_')}.py").write_text("\n".join([*imports, *rest, ""]))
    written = list(folder.glob("*.py"))
    print(f"{len(written)} files in {folder}")
    if len(written) < 5:
        raise SystemExit("blocks.py: the pages and notebooks were not found")


if __name__ == "__main__":
    main()
