"""Writes the docstrings of the extension module into its stub, percuss/_percuss.pyi, where editors read them.

    stub_docs.py             writes the stub
    stub_docs.py --check     fails if a docstring is out of date
"""

from __future__ import annotations

import ast
import inspect
import sys
from pathlib import Path
from typing import Any

STUB = Path(__file__).resolve().parents[1] / "python/percuss/_percuss.pyi"


def docstring(item: Any, indent: str) -> list[str]:
    """Lines of the docstring of an object, indented; empty without one."""
    # Functions that convert errors have the docstring of the function of the extension.
    text = getattr(item, "__doc__", None)
    if not isinstance(text, str) or not text.strip():
        return []
    lines = inspect.cleandoc(text).replace("\\", "\\\\").splitlines()
    # The signature that the extension writes for inspect.
    if "--" in lines[:3]:
        lines = lines[lines.index("--") + 1 :]
    while lines and not lines[0].strip():
        lines = lines[1:]
    if not lines:
        return []
    quoted = ['"""' + lines[0], *lines[1:]]
    quoted[-1] += '"""'
    return [indent + line if line.strip() else "" for line in quoted]


def is_docstring(node: ast.stmt) -> bool:
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str)


def with_docstrings(source: str, module: Any) -> str:
    """The stub with the present docstrings."""
    lines = source.splitlines()
    #: First line, last line (from 0, exclusive) and new lines of every change.
    changes: list[tuple[int, int, list[str]]] = []

    def visit(node: ast.stmt, owner: Any) -> None:
        if not isinstance(node, (ast.ClassDef, ast.FunctionDef)):
            return
        item = getattr(owner, node.name, None)
        if item is None:
            return
        indent = " " * (node.col_offset + 4)
        text = docstring(item, indent) if not node.name.startswith("__") else []
        first = node.body[0]
        if isinstance(node, ast.ClassDef):
            old = (first.lineno - 1, first.end_lineno or first.lineno) if is_docstring(first) else (first.lineno - 1,) * 2
            # Decorators of the first method stand before it.
            if not is_docstring(first) and isinstance(first, ast.FunctionDef) and first.decorator_list:
                old = (first.decorator_list[0].lineno - 1,) * 2
            changes.append((old[0], old[1], text))
            for inner in node.body:
                visit(inner, item)
            return
        start, end = first.lineno - 1, node.end_lineno or node.lineno
        if first.lineno == node.lineno or lines[start][: first.col_offset].strip():
            # `def name(…) -> type: ...` in one line.
            head = lines[start][: first.col_offset].rstrip()
            changes.append((start, end, [head, *text] if text else [head + " ..."]))
        else:
            changes.append((start, end, text or [lines[start - 1].rstrip() + " ..."]) if text else (start - 1, end, [lines[start - 1] + " ..."]))

    for node in ast.parse(source).body:
        visit(node, module)
    for start, end, new in sorted(changes, reverse=True):
        lines[start:end] = new
    return "\n".join(lines) + "\n"


def main() -> int:
    from percuss import _percuss

    old = STUB.read_text()
    new = with_docstrings(old, _percuss)
    if "--check" in sys.argv[1:]:
        return int(new != old)
    STUB.write_text(new)
    return 0


if __name__ == "__main__":
    sys.exit(main())
