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
    gradient = percuss.position_gradient(model, q, swept.gradient)[0]
    assert gradient @ q[0] == pytest.approx(0, abs=1e-12)
    step = 1e-6
    for k in range(4):
        moved = [q + sign * step * np.eye(4)[k] for sign in (1, -1)]
        masses = [percuss.sweep(model, contact, x / np.linalg.norm(x)).effective_mass[0] for x in moved]
        # Central differences: rounding 1e-16 / 1e-6.
        assert gradient[k] == pytest.approx((masses[0] - masses[1]) / (2 * step), abs=1e-8)
