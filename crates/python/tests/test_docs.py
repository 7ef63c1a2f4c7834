"""The Python blocks of each page of docs run in order; the examples and the notebook run too."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from typing import Any

import nbclient
import nbformat
import pytest
from blocks import pages
from cases import ROOT

EXAMPLES = Path(__file__).resolve().parents[1] / "examples"
PAGES = {name: blocks for name, blocks in pages() if name.startswith("docs_")}


@pytest.mark.parametrize("page", sorted(PAGES))
def test_the_blocks_of_a_page(page: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    names: dict[str, object] = {}
    for block in PAGES[page]:
        exec(block, names)


@pytest.mark.parametrize("name", ["suspension_study.py", "arm_trajectory.py", "tree_poses.py"])
def test_examples(name: str, tmp_path: Path) -> None:
    ran = subprocess.run(
        [sys.executable, "-W", "error::DeprecationWarning", str(EXAMPLES / name)],
        capture_output=True, text=True, cwd=tmp_path, timeout=120,
    )
    assert ran.returncode == 0, ran.stderr
    assert "kg" in ran.stdout


def executed(name: str) -> list[Any]:
    """Outputs of all cells of a notebook, run in a fresh kernel."""
    notebook = nbformat.read(EXAMPLES / name, as_version=4)  # type: ignore[no-untyped-call]
    assert all(not cell.get("outputs") for cell in notebook.cells), "it is kept without its outputs"
    client = nbclient.NotebookClient(notebook, timeout=120, resources={"metadata": {"path": str(ROOT)}})
    client.execute()
    return [output for cell in notebook.cells for output in cell.get("outputs", [])]


def printed(shown: list[Any]) -> str:
    return "".join(output["text"] for output in shown if output["output_type"] == "stream")


def test_the_notebook_of_an_arm() -> None:
    shown = executed("arm.ipynb")
    pages = [output["data"]["text/html"] for output in shown if "text/html" in output.get("data", {})]
    # Pictures: the curve of the motion and the surface of the map. Tables: the reports.
    assert sum("<svg" in page for page in pages) == 2, len(pages)
    assert sum("<table" in page for page in pages) == 3
    assert "kg ±" in printed(shown) and "m/s with the effective mass" in printed(shown)


@pytest.mark.parametrize("name", sorted(path.name for path in EXAMPLES.glob("*.ipynb") if path.name != "arm.ipynb"))
def test_notebooks_with_pictures(name: str) -> None:
    shown = executed(name)
    assert "kg" in printed(shown)
    assert any("image/png" in output.get("data", {}) for output in shown), "no picture was drawn"
