"""Converts a robot of example-parallel-robots (`robot.urdf` and `robot.yaml`) to one URDF+ file. Needs PyYAML.

    python parallel_robots.py FOLDER [-o FILE.urdf]
    percuss check FILE.urdf

Keys of robot.yaml:

    closed_loop             pairs of frames that a loop joins; a frame is a link or a fixed joint
    type                    of each pair: 3d (the origins coincide) or 6d (the frames coincide); default 6d
    joint_name, joint_type  joints that get another type: FIXED, SPHERICAL, UJOINT_ZX (two hinges, about z and then about x of the joint's
                            frame; any two axes) or CARDAN (the same as UJOINT_XY). Their axes, limits and mimics are dropped
    name_mot                joints with motors: marked as driving joints

Unknown joint names cause a warning; an unknown frame of a loop is an error.
"""

from __future__ import annotations

import argparse
import re
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from typing import Any

import yaml

AXES = {"X": "1 0 0", "Y": "0 1 0", "Z": "0 0 1"}


def convert(urdf: str, options: dict[str, Any]) -> str:
    """Returns the text of the URDF+ file. Raises KeyError for an unknown frame of a loop, ValueError for an unknown type."""
    robot = ElementTree.fromstring(urdf)
    joints = {joint.attrib["name"]: joint for joint in robot.findall("joint")}
    links = {link.attrib["name"] for link in robot.findall("link")}
    unknown = [name for key in ("joint_name", "name_mot") for name in options.get(key, []) if name not in joints]
    if unknown:
        print(f"warning: names of robot.yaml without a joint in robot.urdf: {', '.join(unknown)}", file=sys.stderr)
    for name, kind in zip(options.get("joint_name", []), options.get("joint_type", []), strict=True):
        if name in joints:
            change_joint(robot, joints[name], kind)
    for name in options.get("name_mot", []):
        # Only joints with one degree of freedom can be driving joints.
        if name in joints and joints[name].attrib["type"] in ("revolute", "continuous", "prismatic"):
            joints[name].set("independent", "true")
    pairs = options.get("closed_loop", [])
    for pair, kind in zip(pairs, options.get("type", ["6d"] * len(pairs)), strict=True):
        if kind.lower() not in ("3d", "6d"):
            raise ValueError(f"loop {pair}: the type is {kind!r}, expected 3d or 6d")
        loop = ElementTree.SubElement(robot, "loop", name=" ".join(pair), type="spherical" if kind.lower() == "3d" else "fixed")
        for side, frame in zip(("predecessor", "successor"), pair, strict=True):
            # The frame of a fixed joint is that of its child link.
            link = frame if frame in links else joints[frame].find("child").attrib["link"]  # type: ignore[union-attr]
            ElementTree.SubElement(loop, side, link=link)
    ElementTree.indent(robot)
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + ElementTree.tostring(robot, encoding="unicode") + "\n"


def change_joint(robot: ElementTree.Element, joint: ElementTree.Element, kind: str) -> None:
    """Changes the type of a joint; drops its axis, limits and mimic. Two hinges get a massless link between them."""
    name = joint.attrib["name"]
    axes = re.fullmatch(r"UJOINT_([XYZ])(?!\1)([XYZ])", "UJOINT_XY" if kind == "CARDAN" else kind)
    if kind == "FIXED":
        joint.set("type", "fixed")
    elif kind == "SPHERICAL":
        joint.set("type", "spherical")
    elif axes:
        child = joint.find("child")
        assert child is not None
        ElementTree.SubElement(robot, "link", name=f"{name}_cross")
        second = ElementTree.SubElement(robot, "joint", name=f"{name}_{axes[2]}", type="continuous")
        ElementTree.SubElement(second, "parent", link=f"{name}_cross")
        ElementTree.SubElement(second, "child", link=child.attrib["link"])
        ElementTree.SubElement(second, "axis", xyz=AXES[axes[2]])
        child.set("link", f"{name}_cross")
        joint.attrib |= {"name": f"{name}_{axes[1]}", "type": "continuous"}
    else:
        raise ValueError(f"joint {name}: the type is {kind!r}, expected FIXED, SPHERICAL, CARDAN or UJOINT_ with two axes, such as UJOINT_XY")
    for tag in ("axis", "limit", "mimic", "dynamics", "safety_controller", "calibration"):
        for element in joint.findall(tag):
            joint.remove(element)
    if axes:
        ElementTree.SubElement(joint, "axis", xyz=AXES[axes[1]])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("-o", "--output", type=Path, help="default: the standard output")
    options = parser.parse_args()
    text = convert(
        (options.folder / "robot.urdf").read_text(encoding="utf-8"),
        yaml.safe_load((options.folder / "robot.yaml").read_text(encoding="utf-8")),
    )
    if options.output:
        options.output.write_text(text, encoding="utf-8")
    else:
        sys.stdout.write(text)


if __name__ == "__main__":
    main()
