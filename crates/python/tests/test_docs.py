"""The Python of docs/PYTHON.md runs, block after block, and so do the examples."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest
from cases import ROOT

EXAMPLES = Path(__file__).resolve().parents[1] / "examples"


def test_the_blocks_of_the_page(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    blocks = re.findall(r"```python\n(.*?)```", (ROOT / "docs/PYTHON.md").read_text(), flags=re.S)
    assert len(blocks) >= 6
    names: dict[str, object] = {}
    for block in blocks:
        exec(block, names)


@pytest.mark.parametrize("name", ["suspension_study.py", "arm_trajectory.py", "tree_poses.py"])
def test_examples(name: str, tmp_path: Path) -> None:
    ran = subprocess.run(
        [sys.executable, "-W", "error::DeprecationWarning", str(EXAMPLES / name)],
        capture_output=True, text=True, cwd=tmp_path, timeout=120,
    )
    assert ran.returncode == 0, ran.stderr
    assert "kg" in ran.stdout
