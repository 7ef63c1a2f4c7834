"""Writes percuss/records: the types of all reports, with the fields, types and comments of the structures in crates/study and crates/contact.

    records.py             writes the modules
    records.py --check     fails if a module is out of date
"""

from __future__ import annotations

import re
import sys
import textwrap
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
SOURCES = [ROOT / "crates/study/src", ROOT / "crates/contact/src"]
PACKAGE = ROOT / "crates/python/python/percuss/records"
#: Modules in the order of their imports, and the reports in each. A structure is in the first module that needs it.
MODULES = {
    "damping": ["DampingReport"],
    "mass": ["MassReport", "ContactListReport"],
    "sweep": ["SweepReport", "ComparisonReport", "KinematicsReport"],
    "impact": ["ImpactReport", "ExtremesReport", "ReflectedReport"],
    "surfaces": ["MapReport", "PointMapReport", "SafeSpeedReport", "CheckReport"],
}
#: Reports whose name is that of a class with arrays in the package, and the name of their record.
RENAMED = {"MapReport": "MapRecord"}
#: Keys that repr shows, with their units.
ANSWERS = {
    "DampingReport": {"damping": "", "dissipation": "", "achieved_restitution": "", "peak_force": "N"},
    "MassReport": {"effective_mass": "kg", "effective_mass_error": "kg", "status": ""},
    "ReflectedReport": {"drivers": "", "reflected_inertia": "", "reflected_over": ""},
    "FrictionThresholdsRecord": {"sticking": "", "jamming": ""},
    "Explanation": {"effective_mass": "", "links": ""},
    "ToleranceReport": {"effective_mass": "", "root_sum_square": "", "worst_case": ""},
    "ContactListReport": {"contacts": ""},
    "SweepReport": {"link": "", "rows": ""},
    "SweepRow": {"row": "", "effective_mass": "", "status": ""},
    "ComparisonReport": {"designs": "", "rows": ""},
    "DesignRecord": {"name": "", "effective_mass": "kg", "difference_percent": "%"},
    "KinematicsReport": {"variable": "", "columns": "", "rows": ""},
    "ImpactReport": {"impulse": "N s", "energy_loss": "J", "closing_speed": "m/s"},
    "ExtremesReport": {"least.effective_mass": "kg", "most.effective_mass": "kg"},
    "ExtremeRecord": {"effective_mass": "", "status": ""},
    "MapReport": {"links": ""},
    "PointMapReport": {"link": "", "principal": "", "directions": ""},
    "SafeSpeedReport": {"reflected.speed": "m/s", "standard.speed": "m/s", "limited_by": ""},
    "CheckReport": {"name": "", "total_mass": "kg", "degrees_of_freedom": "", "links": "", "diagnostics": ""},
}
NUMBERS = {"f64": "float", "usize": "int", "u64": "int", "u32": "int", "u8": "int", "i8": "int", "i32": "int"}
PLAIN = {
    **NUMBERS,
    "bool": "bool",
    "String": "str",
    "str": "str",
    "Severity": "Literal[\"error\", \"warning\", \"note\"]",
    "Value": "float | list[float] | str",
    "KinematicUnit": "str",
    "Positions": "dict[str, list[float]]",
    "VariedValues": "dict[str, float]",
    "RowGradient": "dict[str, list[float]]",
    "KinematicsRow": "dict[str, float | str | None]",
}
DOC = r"((?:[ \t]*///[^\n]*\n)*)"
ATTRIBUTES = r"((?:[ \t]*#\[[^\n]*\]\n)*)"


def words(doc: str) -> str:
    """Text of a comment of Rust for Python: None instead of null, no links."""
    text = " ".join(line.strip().removeprefix("///").strip() for line in doc.strip().splitlines())
    text = re.sub(r"\[`?([^\]`]*)`?\]\([^)]*\)", r"\1", text)
    return re.sub(r'"?\b[Nn]ull\b"?', "None", re.sub(r"\[`([^\]`]*)`\]", r"\1", text).replace("`", '"')).strip()


class Sources:
    """Structures and enumerations that serde writes."""

    def __init__(self) -> None:
        self.structures: dict[str, tuple[str, str]] = {}
        self.choices: dict[str, list[str]] = {}
        for path in (path for folder in SOURCES for path in sorted(folder.rglob("*.rs"))):
            if "study_file" in path.parts:
                continue
            text = path.read_text()
            head = DOC + ATTRIBUTES
            for doc, attributes, name, body in re.findall(head + r"pub struct (\w+)(?:<'a>)? \{\n(.*?)^\}", text, re.M | re.S):
                if "Serialize" in attributes:
                    self.structures[name] = (words(doc), body)
            for _, attributes, name, body in re.findall(head + r"pub enum (\w+) \{\n(.*?)^\}", text, re.M | re.S):
                if "Serialize" in attributes and "rename_all" in attributes:
                    self.choices[name] = [re.sub(r"(?<!^)(?=[A-Z])", "_", v).lower() for v in re.findall(r"^\s*(\w+),", body, re.M)]

    def fields(self, name: str) -> list[tuple[str, str, str]]:
        """Key, type in Rust and comment of every serialized field."""
        found = []
        pattern = DOC + ATTRIBUTES + r"[ \t]*pub(?:\(\w+\))? (?:r#)?(\w+): ([^\n]+),\n"
        for doc, attributes, key, kind in re.findall(pattern, self.structures[name][1], re.M):
            if "serde(skip)" in attributes:
                continue
            if "flatten" in attributes:
                found += self.fields(kind)
                continue
            renamed = re.search(r'rename = "([^"]+)"', attributes)
            if "skip_serializing_if" in attributes and not kind.startswith("Option"):
                kind = f"Option<{kind}>"
            found.append((renamed[1] if renamed else key, kind, words(doc)))
        return found

    def python(self, kind: str) -> str:
        """Type in Python."""
        kind = kind.replace("&'static ", "").replace("&'a ", "").strip()
        if inner := re.fullmatch(r"Option<(.*)>", kind):
            of = self.python(inner[1])
            return of if of.endswith("| None") else f"{of} | None"
        if inner := re.fullmatch(r"(?:Box|Arc)<(.*)>", kind):
            return self.python(inner[1])
        if inner := re.fullmatch(r"Vec<(.*)>|\[(.*); \w+\]|\[([^;]*)\]", kind):
            return f"list[{self.python(inner[1] or inner[2] or inner[3])}]"
        if inner := re.fullmatch(r"BTreeMap<(.*?), (.*)>", kind):
            return f"dict[{self.python(inner[1])}, {self.python(inner[2])}]"
        if inner := re.fullmatch(r"\((.*)\)", kind):
            kinds = sorted({self.python(part) for part in inner[1].split(", ")})
            return f"list[{' | '.join(kinds)}]"
        if kind in PLAIN:
            return PLAIN[kind]
        if kind in self.choices:
            return f"Literal[{', '.join(repr(choice) for choice in self.choices[kind]).replace(chr(39), chr(34))}]"
        if kind in self.structures:
            return RENAMED.get(kind, kind)
        raise SystemExit(f"records.py: no type in Python for {kind}")

    def needed(self, name: str) -> list[str]:
        """Structures of the fields."""
        kinds = [kind for _, kind, _ in self.fields(name)]
        return [word for kind in kinds for word in re.findall(r"\w+", kind) if word in self.structures and word not in PLAIN]


def wrapped(text: str, indent: str) -> list[str]:
    lines = textwrap.wrap(text, 125 - len(indent))
    return [f'{indent}"""{lines[0]}', *(indent + line for line in lines[1:])]


def docstring(text: str, indent: str) -> list[str]:
    lines = wrapped(text or "Record.", indent)
    # A quotation mark at the end of the text needs a space before the closing quotation marks.
    return [*lines[:-1], lines[-1] + (' """' if lines[-1].endswith('"') else '"""')]


def record(sources: Sources, name: str) -> list[str]:
    """Lines of one class."""
    lines = ["", "", f"class {RENAMED.get(name, name)}(Record):", *docstring(sources.structures[name][0], "    "), ""]
    if name in ANSWERS:
        lines += [f"    _answer = {str(ANSWERS[name]).replace(chr(39), chr(34))}", ""]
    for key, kind, comment in sources.fields(name):
        if key == "from":
            # `from` is a keyword of Python: the key has no attribute.
            continue
        lines += [f"    {key}: {sources.python(kind)}", *docstring(comment, "    ")]
    return lines


def modules() -> dict[str, str]:
    """Text of every module."""
    sources, place, texts = Sources(), dict[str, str](), dict[str, str]()
    for module, roots in MODULES.items():
        own: list[str] = []

        def visit(name: str) -> None:
            if name in place:
                return
            place[name] = module
            for other in sources.needed(name):
                visit(other)
            own.append(name)

        for root in roots:
            visit(root)
        body = [line for name in own for line in record(sources, name)]
        known = {other for name in own for other in sources.needed(name)}
        imports: dict[str, list[str]] = {}
        for name in sorted(known):
            if place[name] != module:
                imports.setdefault(place[name], []).append(RENAMED.get(name, name))
        head = [f'"""Records of reports: {", ".join(RENAMED.get(root, root) for root in roots)}. Written by tests/records.py."""', ""]
        head += ["from __future__ import annotations", ""]
        if any("Literal[" in line for line in body):
            head += ["from typing import Literal", ""]
        head += [f"from .{other} import {', '.join(names)}" for other, names in imports.items()]
        head += ["from .record import Record"]
        texts[module] = "\n".join([*head, *body]) + "\n"
    names = {module: sorted(RENAMED.get(n, n) for n, at in place.items() if at == module) for module in MODULES}
    head = ['"""Types of the reports and of their parts. Written by tests/records.py."""', ""]
    for module, own in names.items():
        head += [f"from .{module} import (", *(f"    {name}," for name in own), ")"]
    head += ["from .record import AnyRecord, Record", "", "__all__ = ["]
    head += [f'    "{name}",' for name in sorted([*(n for own in names.values() for n in own), "AnyRecord", "Record"])]
    texts["__init__"] = "\n".join([*head, "]", ""])
    return texts


def main() -> None:
    stale = []
    for module, text in modules().items():
        path = PACKAGE / f"{module}.py"
        if not path.exists() or path.read_text() != text:
            stale.append(path.name)
            if "--check" not in sys.argv:
                path.write_text(text)
    if "--check" in sys.argv and stale:
        raise SystemExit(f"percuss/records: {', '.join(stale)} differ from the structures in crates/study and crates/contact; run crates/python/tests/records.py")


if __name__ == "__main__":
    main()
