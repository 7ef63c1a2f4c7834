"""The contacts stated in the shipped models, with their masses: <?percuss mass MODEL --flag … --expect KG?>."""

from __future__ import annotations

import argparse
import re
import shlex
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import percuss

ROOT = Path(__file__).resolve().parents[3]
MODELS = sorted((ROOT / "models").glob("*.urdf"))


@dataclass
class Case:
    command: list[str]
    path: Path
    contact: percuss.Contact
    conditions: percuss.Conditions
    expected: float
    tolerance: float

    def __str__(self) -> str:
        return f"{self.path.stem}-{self.contact.link}"

    def pose(self) -> percuss.Pose:
        """Response through the library's steps, not through the report."""
        given = self.conditions
        system = percuss.load(self.path).system(
            base=given.base or "fixed", lock=list(given.lock), armature=dict(given.armature)
        )
        return system.pose({joint: degrees(value) for joint, value in given.set.items()})


def degrees(value: Any) -> float:
    if isinstance(value, str) and value.endswith("deg"):
        return float(value[:-3]) * 3.141592653589793 / 180
    return float(value)


def numbers(text: str) -> list[float]:
    return [float(x) for x in text.split(",")]


def pairs(texts: list[str]) -> dict[str, str]:
    return dict(text.split("=", 1) for text in texts)


def parse(command: str) -> Case:
    flags = argparse.ArgumentParser()
    flags.add_argument("model")
    for name in ("link", "point", "normal", "along-line", "against", "base", "expect"):
        flags.add_argument(f"--{name}")
    flags.add_argument("--against-mass", type=float)
    flags.add_argument("--tolerance", type=float, default=1e-12)
    for name in ("set", "lock", "armature"):
        flags.add_argument(f"--{name}", action="append", default=[])
    words = [re.sub(r"^(--point|--normal)$", r"\1", word) for word in shlex.split(command)[1:]]
    joined: list[str] = []
    for word in words:
        # argparse would read -1,0,0 as a flag.
        if joined and joined[-1] in ("--point", "--normal"):
            joined[-1] += "=" + word
        else:
            joined.append(word)
    given = flags.parse_args(joined)
    toward = None
    if given.along_line:
        link, point = given.along_line.rsplit(":", 1)
        toward = (link, numbers(point))
    contact = percuss.Contact(
        given.link,
        numbers(given.point),
        numbers(given.normal) if given.normal else None,
        toward=toward,
        against=given.against,
    )
    conditions = percuss.Conditions(
        against_mass=given.against_mass,
        set=pairs(given.set),
        lock=given.lock,
        armature={joint: float(value) for joint, value in pairs(given.armature).items()},
        base=given.base or "fixed",
    )
    return Case(
        ["mass", *joined], ROOT / given.model, contact, conditions, float(given.expect), given.tolerance
    )


def cases() -> list[Case]:
    found = []
    for path in MODELS:
        for command in re.findall(r"<\?percuss (mass .*?)\?>", path.read_text()):
            found.append(parse(command))
    assert len(found) > 30, f"only {len(found)} cases were found"
    return found


CASES = cases()
