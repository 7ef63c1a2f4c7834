"""Converters without the other programs: joints by name, shapes, what is refused. tests/peers/converters.py has the programs."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest
from cases import ROOT

import percuss
from percuss.converters import Converter

ARM = percuss.load(ROOT / "models/six_r_arm.urdf")
FREE = """<robot name="free"><link name="world"/><link name="body"><inertial><mass value="1"/>
<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="root" type="floating"><parent link="world"/><child link="body"/></joint></robot>"""


def test_joint_states_by_name() -> None:
    with pytest.warns(percuss.ModelWarning, match=r"no joint of the model: 'gripper'; without an entry"):
        converter = Converter.of_joint_state(ARM, ["elbow", "gripper", "yaw"])
    q = converter.positions([[0.1, 5.0, 0.2], [0.3, 6.0, 0.4]])
    names = ARM.position_names
    assert q.shape == (2, len(names))
    assert q[:, names.index("elbow")].tolist() == [0.1, 0.3] and q[:, names.index("yaw")].tolist() == [0.2, 0.4]
    assert np.count_nonzero(q) == 4
    assert converter.from_positions(q)[0].tolist() == [0.1, 0.0, 0.2]
    assert converter.velocities([1.0, 2.0, 3.0])[ARM.velocity_names.index("yaw")] == 3.0
    assert converter.base_pose([0.0, 0.0, 0.0]) is None
    with pytest.raises(percuss.InputError, match=r"\(\.\.\., 3\), the order of JointState"):
        converter.positions([0.1, 0.2])
    with pytest.raises(percuss.InputError, match="each joint once"):
        Converter.of_joint_state(ARM, ["yaw", "yaw"])
    with pytest.raises(percuss.InputError, match="none is a joint of the model"):
        Converter.of_joint_state(ARM, ["left_elbow", "left_yaw"])


def test_rates_of_mimics_follow_their_masters() -> None:
    """dm̄/dt = gradient · velocities, against a central difference over the positions of the other program."""
    link = """<link name="{}"><inertial><origin xyz="0.1 0 0.02"/><mass value="2"/>
    <inertia ixx="0.01" iyy="0.02" izz="0.02" ixy="0" ixz="0" iyz="0"/></inertial></link>"""
    joint = """<joint name="{0}" type="continuous"><parent link="{1}"/><child link="{2}"/><origin xyz="{4} 0 0"/><axis xyz="0 1 0"/>{3}</joint>"""
    follows = '<mimic joint="a" multiplier="-1.7" offset="0.2"/>'
    parts = [*map(link.format, "xy"), joint.format("a", "g", "x", "", 0), joint.format("b", "x", "y", follows, 0.3)]
    model = percuss.loads(f'<robot name="m"><link name="g"/>{"".join(parts)}</robot>')
    assert [(j.mimics, j.multiplier, j.offset) for j in model.joints] == [(None, None, None), ("a", -1.7, 0.2)]
    converter, contact = Converter.of_joint_state(model, ["a"]), percuss.Contact("y", [0.2, 0, 0], [0.3, 0, 1])

    def mass(a: float) -> float:
        return float(percuss.sweep(model, contact, converter.positions([[a]])).effective_mass[0])

    h = 1e-5
    slope = (mass(0.4 + h) - mass(0.4 - h)) / (2 * h)
    gradient = percuss.sweep(model, contact, converter.positions([[0.4]]), gradient=True).gradient[0]
    # The error of the difference is of the order h².
    assert gradient @ converter.velocities([1.0]) == pytest.approx(slope, rel=1e-7)
    pose = model.pose({"a": 0.4})
    assert pose.effective_mass_rate(contact, {"a": 1.0, "b": -1.7}) == pytest.approx(slope, rel=1e-7)
    with pytest.raises(percuss.InputError, match='follows "a"'):
        pose.effective_mass_rate(contact, {"a": 1.0, "b": 1.0})


def test_joints_of_mujoco_without_names() -> None:
    """Free joint of the trunk and hinge of the leg, without names; velocity of the base in the axes of MuJoCo."""
    bodies = [SimpleNamespace(name=name) for name in ("world", "trunk", "leg")]
    other = SimpleNamespace(
        njnt=2, nq=8, nv=7, joint=([SimpleNamespace(name="")] * 2).__getitem__, body=bodies.__getitem__, jnt_type=[0, 3], jnt_qposadr=[0, 7],
        jnt_dofadr=[0, 6], jnt_bodyid=[1, 2], body_jntadr=[-1, 0, 1], body_jntnum=[0, 1, 1], qpos0=[0, 0, 0, 1, 0, 0, 0, 0],
    )  # fmt: skip
    model = percuss.loads(
        """<mujoco><worldbody><body name="trunk"><freejoint/><geom size="0.1" mass="2"/>
        <body name="leg" pos="0 0 -.2"><joint axis="0 1 0"/><geom size="0.05" pos="0 0 -.2" mass="1"/></body></body></worldbody></mujoco>"""
    )
    converter = Converter.of_mujoco(model, other)
    assert [block.name for block in converter.blocks] == [joint.name for joint in model.joints if joint.kind != "fixed"]
    assert converter.base is None and converter.base_velocity(np.zeros(7)) is None


def test_free_joints_of_drake() -> None:
    """Drake: quaternion before translation, velocities in the axes of the world."""
    joint = SimpleNamespace(
        name=lambda: "root", position_start=lambda: 0, num_positions=lambda: 7, velocity_start=lambda: 0, num_velocities=lambda: 6
    )
    plant = SimpleNamespace(
        GetJointIndices=lambda: [0], get_joint=lambda _: joint, num_positions=lambda: 7, num_velocities=lambda: 6
    )
    model = percuss.loads(FREE)
    converter = Converter.of_drake(model, plant)
    half = np.sqrt(0.5)
    # A quarter turn about z.
    other = [half, 0, 0, half, 1, 2, 3]
    q = converter.positions(other)
    assert q == pytest.approx([1, 2, 3, half, 0, 0, half])
    v = converter.velocities([1, 0, 0, 0, 5, 0], other)
    assert v == pytest.approx([0, -1, 0, 5, 0, 0])
    assert converter.from_velocities(v, q) == pytest.approx([1, 0, 0, 0, 5, 0])
    assert converter.from_positions(q) == pytest.approx(other)
    with pytest.raises(percuss.InputError, match="expected q"):
        converter.velocities([1, 0, 0, 0, 5, 0])
    with pytest.raises(percuss.InputError, match="matched by name"):
        Converter.of_drake(ARM, plant)


def test_gradients_by_quaternions_are_differences() -> None:
    text = FREE.replace("floating", "spherical")
    model = percuss.loads(text)
    contact = percuss.Contact("body", [0.3, 0.2, 0.1], [1, 0.5, 0], normal_frame="world")
    q = np.array([[0.8, 0.2, -0.4, 0.4]])
    q /= np.linalg.norm(q)
    swept = percuss.sweep(model, contact, q, gradient=True)
    assert swept.gradient is not None
    gradient = percuss.converters.position_gradient(model, q, swept.gradient)[0]
    assert gradient @ q[0] == pytest.approx(0, abs=1e-12)
    step = 1e-6
    for k in range(4):
        moved = [q + sign * step * np.eye(4)[k] for sign in (1, -1)]
        masses = [percuss.sweep(model, contact, x / np.linalg.norm(x)).effective_mass[0] for x in moved]
        # Central differences: rounding 1e-16 / 1e-6.
        assert gradient[k] == pytest.approx((masses[0] - masses[1]) / (2 * step), abs=1e-8)
