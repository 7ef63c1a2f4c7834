"""Tests of examples/parallel_robots.py."""

from __future__ import annotations

import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest
import yaml
from cases import ROOT

import percuss

SCRIPT = ROOT / "crates/python/examples/parallel_robots.py"

BODY = '<inertial><origin xyz="0 0 -1"/><mass value="2"/><inertia ixx="0.3" ixy="0" ixz="0" iyy="0.5" iyz="0" izz="0.1"/></inertial>'


def convert(folder: Path, urdf: str, options: dict[str, object]) -> percuss.Model:
    (folder / "robot.urdf").write_text(urdf)
    (folder / "robot.yaml").write_text(yaml.safe_dump(options))
    file = folder / "converted.urdf"
    ran = subprocess.run([sys.executable, str(SCRIPT), str(folder), "-o", str(file)], capture_output=True, text=True)
    assert ran.returncode == 0, ran.stderr
    return percuss.load(file)


@pytest.mark.parametrize("kind", ["6d", "3d"])
def test_a_four_bar_keeps_its_closed_form(tmp_path: Path, kind: str) -> None:
    robot = ElementTree.parse(ROOT / "models/four_bar.urdf").getroot()
    for loop in robot.findall("loop"):
        robot.remove(loop)
    crank = robot.find("joint[@name='crank_hinge']")
    assert crank is not None
    del crank.attrib["independent"]
    # Pin between coupler and rocker: frame `pin_A` is fixed to the coupler, and frame `pin_B` turns on the rocker.
    for name, parent, joint, at in (("A", "coupler", "fixed", "0.4 0.3 0"), ("B", "rocker", "continuous", "-0.25 0.6 0")):
        ElementTree.SubElement(robot, "link", name=f"pin_{name}")
        own = ElementTree.SubElement(robot, "joint", name=f"to_{name}", type=joint)
        ElementTree.SubElement(own, "origin", xyz=at)
        ElementTree.SubElement(own, "parent", link=parent)
        ElementTree.SubElement(own, "child", link=f"pin_{name}")
        if joint != "fixed":
            ElementTree.SubElement(own, "axis", xyz="0 0 1")
    # A loop may name a fixed joint (`to_A`) or a link. 3d joins points only, so `rocker_pin` can be fixed to the rocker.
    names = ["to_A", "pin_B" if kind == "6d" else "rocker_pin"]
    if kind == "3d":
        ElementTree.SubElement(robot, "link", name="rocker_pin")
        own = ElementTree.SubElement(robot, "joint", name="to_pin", type="fixed")
        ElementTree.SubElement(own, "origin", xyz="-0.25 0.6 0")
        ElementTree.SubElement(own, "parent", link="rocker")
        ElementTree.SubElement(own, "child", link="rocker_pin")
        for element in [*robot.findall("joint[@name='to_B']"), *robot.findall("link[@name='pin_B']")]:
            robot.remove(element)
    options: dict[str, object] = {
        "closed_loop": [names], "type": [kind], "name_mot": ["crank_hinge"], "joint_name": [], "joint_type": [],
    }
    model = convert(tmp_path, ElementTree.tostring(robot, encoding="unicode"), options)
    report = percuss.mass(model, percuss.Contact("coupler", point=(0.35, 0.1, 0), normal=(0, 1, 0)))
    # The closed form of models/four_bar.urdf.
    assert report.effective_mass == pytest.approx(417304 / 6125, rel=1e-12)


def test_types_of_joints(tmp_path: Path) -> None:
    joint = '<joint name="j" type="revolute"><parent link="base"/><child link="body"/><axis xyz="0 0 1"/><limit lower="0" upper="1" effort="0" velocity="0"/></joint>'
    urdf = f'<robot name="r"><link name="base"/><link name="body">{BODY}</link>{joint}</robot>'
    along_x = percuss.Contact("body", point=(0, 0, -1), normal=(1, 0, 0))
    # Rotation about y: I = 0.5 + 2·1² kg·m²; m̄ = I / (1 m)² = 2.5 kg.
    for kind in ("SPHERICAL", "UJOINT_ZY", "CARDAN"):
        model = convert(tmp_path, urdf, {"joint_name": ["j"], "joint_type": [kind]})
        assert percuss.mass(model, along_x).effective_mass == pytest.approx(2.5, rel=1e-12)
    cardan = convert(tmp_path, urdf, {"joint_name": ["j"], "joint_type": ["CARDAN"]})
    assert [joint.name for joint in cardan.joints] == ["j_X", "j_Y"]
    assert percuss.mass(convert(tmp_path, urdf, {"joint_name": ["j"], "joint_type": ["FIXED"]}), along_x).status == "immovable"


def test_unknown_types_are_refused(tmp_path: Path) -> None:
    (tmp_path / "robot.urdf").write_text('<robot name="r"><link name="a"/><link name="b"/></robot>')
    (tmp_path / "robot.yaml").write_text("closed_loop: [[a, b]]\ntype: [5d]\n")
    ran = subprocess.run([sys.executable, str(SCRIPT), str(tmp_path)], capture_output=True, text=True)
    assert ran.returncode != 0 and "'5d', expected 3d or 6d" in ran.stderr
