"""docs/reference/PYTHON_NAMES.md lists every public item of the Rust façade, with its Python name or the reason for omission."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from cases import ROOT

import percuss

PAGE = ROOT / "docs/reference/PYTHON_NAMES.md"
#: Sections of the page, and the source files of their public names.
SECTIONS = {
    "percuss": "crates/percuss/src/lib.rs",
    "percuss::study": "crates/study/src/lib.rs",
    "percuss::contact": "crates/contact/src/lib.rs",
    "percuss::suspension": "crates/suspension/src/lib.rs",
}


def public_names(path: Path) -> set[str]:
    """Names that a file re-exports or declares in public."""
    text = re.sub(r"//.*", "", path.read_text())
    found: set[str] = set()
    for used in re.findall(r"^pub use ([^;]+);", text, flags=re.M):
        # a::b::{C, d as e}: the last name of each path.
        inside = re.sub(r"^.*\{|\}$", "", used.strip(), flags=re.S) if "{" in used else used
        for item in filter(None, (part.strip() for part in inside.split(","))):
            found.add(re.split(r"::|\s+as\s+", item)[-1])
    found |= set(re.findall(r"^pub (?:fn|struct|enum|trait|mod|const|type) (\w+)", text, flags=re.M))
    return found


def rows() -> dict[str, list[tuple[list[str], str]]]:
    """For each section: names in Rust, and the next cell."""
    found: dict[str, list[tuple[list[str], str]]] = {}
    section = ""
    for line in PAGE.read_text().splitlines():
        if line.startswith("## "):
            section = line[3:].strip("`")
            found[section] = []
        elif line.startswith("| `"):
            rust, python = (cell.strip() for cell in line.strip("|").split(" | "))
            found[section].append((re.findall(r"`(\w+)`", rust), python))
    return found


ROWS = rows()


@pytest.mark.parametrize("section", SECTIONS)
def test_every_name_stands_once(section: str) -> None:
    expected = public_names(ROOT / SECTIONS[section])
    assert len(expected) >= 10, f"only {len(expected)} names were found"
    listed = [name for names, _ in ROWS[section] for name in names]
    assert sorted(listed) == sorted(set(listed)), "a name stands twice"
    assert expected - set(listed) == set(), "without a row"
    assert set(listed) - expected == set(), "no longer there"


@pytest.mark.parametrize(("names", "cell"), [row for table in ROWS.values() for row in table], ids=lambda x: x[0] if isinstance(x, list) else "")
def test_the_names_of_python_are_there(names: list[str], cell: str) -> None:
    found = re.findall(r"`percuss\.([\w.]+)`", cell)
    if cell.startswith("–"):
        assert len(cell) > 20, f"{names}: no reason"
    else:
        assert found or cell == "below", f"{names}: no name of Python's"
    for name in found:
        at: object = percuss
        for part in name.split("."):
            assert hasattr(at, part), f"{names}: percuss.{name} is not there"
            at = getattr(at, part)


def test_everything_of_python_stands_on_the_page() -> None:
    """The reverse: every export of the package is on a documentation page."""
    text = PAGE.read_text() + (ROOT / "docs/howto/PYTHON.md").read_text()
    for name in percuss.__all__:
        assert re.search(rf"\b{name}\b", text), f"{name} stands on neither page"


@pytest.mark.parametrize("name", percuss._MOVED)
def test_a_name_that_has_moved_warns(name: str) -> None:
    expected: object = percuss
    for part in percuss._MOVED[name].split("."):
        expected = getattr(expected, part)
    with pytest.warns(DeprecationWarning, match=percuss._MOVED[name]):
        assert getattr(percuss, name) is expected
    assert name not in percuss.__all__


def test_the_citation_has_the_version() -> None:
    cited = re.search(r"^version: (\S+)$", (ROOT / "CITATION.cff").read_text(), flags=re.M)
    assert cited is not None and cited[1] == percuss.__version__


MODEL, ARM = percuss.load(ROOT / "models/four_bar.urdf"), percuss.load(ROOT / "models/six_r_arm.urdf")
#: Names in the examples of docstrings.
NAMES: dict[str, object] = {
    "percuss": percuss, "np": np, "model": MODEL, "arm": ARM, "corner": percuss.load(ROOT / "models/suspensions/double-wishbone.toml"),
    "contact": percuss.Contact("coupler", [0.35, 0.1, 0.0], [0.0, 1.0, 0.0]), "tool": percuss.Contact("tool", [0.08, 0, 0], [0, 1, 0]),
    "q": np.linspace(-0.5, 0.5, 60).reshape(10, 6), "law": percuss.contact_law.Damping(0.3, 2e5, speed=1.0),
}  # fmt: skip
PUBLIC = {
    f"{owner.__name__}.{name}": getattr(owner, name)
    for owner in (percuss, percuss.suspension, percuss.study, percuss.contact_law, percuss.reports, percuss.results, percuss.converters)
    for name in owner.__all__
}
EXAMPLES = {
    name: item for name, item in PUBLIC.items()
    if callable(item) and not (isinstance(item, type) and issubclass(item, (Exception, percuss.reports.Report)))
}  # fmt: skip


@pytest.mark.parametrize("name", sorted(EXAMPLES))
def test_the_example_of_a_docstring(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Every function and class has an example, and it runs; those with other programs are run in tests/peers."""
    lines = re.findall(r"^\s*>>> (.*)$", EXAMPLES[name].__doc__ or "", flags=re.M)
    assert lines, "no example"
    monkeypatch.chdir(ROOT)
    names = dict(NAMES)
    try:
        for line in lines:
            if "pinocchio" not in line and "mujoco." not in line and "Usd." not in line:
                exec(line, names)
    finally:
        percuss.set_threads(None)
