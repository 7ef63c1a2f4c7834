"""Copies of every public object, by pickle and by copy, answer as the object does."""

from __future__ import annotations

import copy
import pickle
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from typing import Any

import numpy as np
import pytest
from cases import CASES, ROOT, Case

import percuss

WAYS: dict[str, Callable[[Any], Any]] = {
    "pickle": lambda found: pickle.loads(pickle.dumps(found)),
    "copy": copy.copy,
    "deepcopy": copy.deepcopy,
}
way = pytest.mark.parametrize("again", WAYS.values(), ids=WAYS.keys())


@way
@pytest.mark.parametrize("case", CASES, ids=str)
def test_poses_and_responses(case: Case, again: Callable[[Any], Any]) -> None:
    pose = again(case.pose())
    assert pose.positions == pytest.approx(case.pose().positions, abs=1e-12)
    response = case.pose().respond(case.contact)
    if case.conditions.against_mass is not None:
        response = response.against_mass(case.conditions.against_mass)
    assert again(response).effective_mass == pytest.approx(response.effective_mass, rel=1e-11)


@way
def test_systems_and_assemblies(again: Callable[[Any], Any]) -> None:
    model = percuss.load(ROOT / "models/six_r_arm.urdf")
    hold = [("tool", [0.08, 0, 0], [0, 0, 1])]
    system = model.system(base="floating", lock=["yaw"], armature={"elbow": 0.5}, hold=hold)
    contact = percuss.Contact("tool", [0.08, 0, 0], [0, 1, 0], normal_frame="world")
    base = [0.1, 0.2, 0.3, 0.5, 0.5, 0.5, 0.5]
    q = {"elbow": 0.4, "shoulder": 0.2}
    expected = system.pose(q, base_pose=base).respond(contact, route="dense").effective_mass
    assert again(system).pose(q, base_pose=base).respond(contact).effective_mass == pytest.approx(expected, rel=1e-12)
    pose = again(system.pose(q, base_pose=base))
    assert again(pose.respond(contact, route="dense")).effective_mass == pytest.approx(expected, rel=1e-12)
    assembly = again(percuss.load(ROOT / "models/four_bar.urdf").assemble({"crank_pin": 0.3}))
    assert assembly.degrees_of_freedom == 1
    assert again(assembly.pose()).positions == pytest.approx(assembly.pose().positions, abs=1e-12)


@way
def test_workspaces_and_travels(again: Callable[[Any], Any]) -> None:
    model = percuss.load(ROOT / "models/four_bar.urdf")
    contact = percuss.Contact("coupler", [0.35, 0.1, 0], [0, 1, 0])
    pose = model.pose({"crank_hinge": 0.2})
    workspace = model.assemble().workspace(contact)
    assert again(workspace).effective_mass(pose.positions) == workspace.effective_mass(pose.positions)
    travel = percuss.suspension.Travel(pose, "coupler", [0.35, 0.1, 0], [0, 1, 0])
    moved = travel.pose(pose, 0.01)
    sent_travel, sent_pose = again((travel, moved))
    assert sent_travel.link == "coupler" and sent_pose.positions == pytest.approx(moved.positions, abs=1e-12)
    joint = again(model.joints[0])
    assert repr(joint) == repr(model.joints[0]) and joint.positions == model.joints[0].positions


@way
def test_sheets_findings_and_errors(again: Callable[[Any], Any]) -> None:
    sheet = percuss.suspension.load(ROOT / "models/suspensions/double-wishbone.toml")
    sent = again(sheet)
    assert sent.links == sheet.links and sent.total_mass == pytest.approx(sheet.total_mass, rel=1e-15)
    with pytest.raises(percuss.LoadError) as caught:
        percuss.loads("<robot name='r'><link name='a'/><link name='a'/></robot>")
    error = again(caught.value)
    assert str(error) == str(caught.value)
    assert [str(found) for found in error.diagnostics] == [str(found) for found in caught.value.diagnostics] != []
    assert error.diagnostics[0].code == caught.value.diagnostics[0].code


def mass(pose: percuss.Pose, contact: percuss.Contact) -> float | None:
    return pose.respond(contact).effective_mass


def test_poses_in_other_processes() -> None:
    model = percuss.load(ROOT / "models/four_bar.urdf")
    contact = percuss.Contact("coupler", [0.35, 0.1, 0], [0, 1, 0])
    poses = [model.pose({"crank_hinge": angle}) for angle in np.linspace(0, 0.5, 4)]
    with ProcessPoolExecutor(2, mp_context=get_context("spawn")) as workers:
        answers = list(workers.map(mass, poses, [contact] * len(poses)))
    assert answers == pytest.approx([mass(pose, contact) for pose in poses], rel=1e-12)


def test_functions_and_methods() -> None:
    """As multiprocessing sends them: by their names."""
    for function in (percuss.sweep, percuss.load, percuss.mass, percuss.Model.pose, percuss.Pose.respond):
        assert pickle.loads(pickle.dumps(function)) is function
    pose = pickle.loads(pickle.dumps(percuss.load(ROOT / "models/four_bar.urdf").pose))
    assert pose({"crank_hinge": 0.1}).joints["crank_hinge"] == pytest.approx(0.1)
