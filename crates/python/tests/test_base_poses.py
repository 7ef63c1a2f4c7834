"""Reports with the root link away from the origin of the world: numbers do not change if all vectors in the world turn with it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from cases import ROOT
from numpy.typing import NDArray

import percuss

ARM = percuss.load(ROOT / "models/six_r_arm.urdf").changed(link_mass={"pedestal": 5.0}, link_inertia={"pedestal": [0.2, 0.3, 0.1]})
BAR = percuss.load(ROOT / "models/four_bar.urdf")
BASE = np.array([0.3, -0.2, 0.5, 0.5, -0.7, 0.1, 0.5])
_Array = NDArray[np.float64]
FLOATING = percuss.Conditions(base="floating")


def turn_of(base: _Array) -> _Array:
    """Rotation of a base pose."""
    pose = ARM.pose(base_pose=base)
    return pose.link_frame(ARM.links[0], frame="world")[:3, :3]


class Placed:
    """The arm or the linkage at a base pose, with vectors given for a root link at the origin."""

    def __init__(self, base: _Array) -> None:
        self.base, self.rotation = base, turn_of(base)
        self.pose = ARM.system(base="floating").pose({"elbow": 0.4, "shoulder": -0.3}, base_pose=base)
        self.bar = BAR.pose({"crank_hinge": 0.4}, base_pose=base)
        self.contact = percuss.Contact("tool", [0.08, 0, 0.02], self.turned([0.3, 0.2, 1.0]), normal_frame="world")
        self.hit = percuss.Contact("coupler", [0.35, 0.1, 0], self.turned([0, 1, 0]), normal_frame="world")

    def turned(self, vector: Any) -> Any:
        return (self.rotation @ np.asarray(vector, dtype=float)).tolist()

    def state(self) -> percuss.State:
        twist = [0.1, 0.2, -0.1, 0.3, -0.2, 0.4]
        return percuss.State(ARM, self.pose.positions, velocities=np.linspace(-1, 1, 6), base_pose=self.base, base_twist=twist)


def held(placed: Placed) -> Any:
    system = BAR.system(hold=[("coupler", [0.1, 0, 0], [0, 0, 1])])
    return percuss.mass(system.pose({"crank_hinge": 0.4}, base_pose=placed.base), placed.hit)


def impact_in_time(placed: Placed) -> Any:
    return percuss.impact(
        placed.bar, placed.hit, 0.3, speed=1.0, in_time=True, stiffness=1e5, gravity=placed.turned([0, -9.81, 0])
    )


def extremes(placed: Placed) -> Any:
    normals = "across:" + ",".join(map(repr, placed.turned([0, 0, 1])))
    return percuss.extremes(ARM.pose(base_pose=placed.base), placed.contact, ranges={"elbow": (-1, 1)}, starts=4, normals=normals)


def travel(placed: Placed) -> Any:
    along = percuss.Conditions(travel=[("coupler", [0.35, 0.1, 0], placed.turned([0, 1, 0]), 0.01)])
    return percuss.mass(placed.bar, placed.hit, along)


def estimates(placed: Placed) -> Any:
    up = placed.turned([0, 0, 1])
    return percuss.mass(placed.pose, placed.contact, percuss.Conditions(ratio_at=[("tool", [0, 0, 0], up)], estimate=(["tool"], [0, 0, 0], up)))


REPORTS: dict[str, Callable[[Placed], Any]] = {
    "mass": lambda p: percuss.mass(p.pose, p.contact, certify=True),
    "held": held,
    "travel": travel,
    "estimates": estimates,
    "impact": lambda p: percuss.impact(p.state(), p.contact, 0.3, FLOATING, friction=0.3),
    "several": lambda p: percuss.impact(
        p.state(), p.contact, 0.0, FLOATING, sticking=True,
        also=[percuss.Contact("tool", [0, 0.05, 0], p.turned([0, 0.1, 1]), normal_frame="world")],
    ),
    "impact in time": impact_in_time,
    "explain": lambda p: percuss.reports.explain(p.pose, p.contact),
    "friction thresholds": lambda p: percuss.reports.friction_thresholds(p.bar, p.hit),
    "tolerate": lambda p: percuss.reports.tolerate(p.pose, p.contact, "mass=2%,com=1mm", samples=20),
    "safe speed": lambda p: percuss.safe_speed(p.pose, p.contact, "chest", force=140.0),
    "directions": lambda p: percuss.reports.safe_speed_directions(p.pose, p.contact, "chest", [p.turned([0, 1, 0])], worst=True, force=140.0),
    "sweep": lambda p: percuss.reports.sweep_report(p.bar, p.hit, vary=("crank_hinge", 0.4, 0.5, 3), gradient=True),
    "map": lambda p: percuss.map(percuss.load(ROOT / "models/shaped_arm.urdf").pose({"elbow": 0.4}, base_pose=p.base), links=["finger"]),
    "point": lambda p: percuss.reports.map_point(p.pose, p.contact, 20),
    "extremes": extremes,
    "damper": lambda p: percuss.contact_law.damp_contact(p.bar, p.hit, percuss.contact_law.Damping(0.5, 2e5, speed=1.0)),
    "reflected": lambda p: percuss.reports.reflected_inertias(p.bar, ["crank_hinge"]),
}


def differences(here: Any, there: Any, placed: Placed, key: str = "") -> list[str]:
    """Keys whose values differ by more than the motion of the base."""
    if isinstance(here, dict):
        names = [name for name in here if name not in ("base_pose", "inputs", "gravity_world", "normals", "direction", "message", "contact_text")]
        return [bad for name in names for bad in differences(here[name], there[name], placed, f"{key}.{name}")]
    if isinstance(here, list) and here and not isinstance(here[0], (float, type(None))):
        return [bad for k, (a, b) in enumerate(zip(here, there, strict=True)) for bad in differences(a, b, placed, f"{key}[{k}]")]
    name = key.rsplit(".", 1)[-1]
    if isinstance(here, list) and ("_world" in name or ".base." in key or ".hold" in key and name == "normal"):
        here = np.asarray(here) @ placed.rotation.T + (placed.base[:3] if name.startswith("point") else 0)
        # The normal of an extreme and its opposite have the same m̄.
        here = here if name != "normal_world" or not key.startswith((".least", ".most")) or here @ there > 0 else -here
    if isinstance(here, (float, list, np.ndarray)):
        # Roundings of a few hundred operations on numbers of the order of one; forces in time have the tolerance of their integration.
        fits = np.allclose(np.asarray(there, dtype=float), np.asarray(here, dtype=float), rtol=1e-6, atol=1e-7, equal_nan=True)
        is_error = any(part in name for part in ("error", "residual", "rounding", "up_to", "starts", "gap"))
        return [] if fits or is_error else [f"{key}: {here}, {there}"]
    return [] if here == there else [f"{key}: {here}, {there}"]


@pytest.mark.parametrize("name", REPORTS)
def test_numbers_are_those_at_the_origin(name: str) -> None:
    origin, placed = Placed(np.array([0.0, 0, 0, 1, 0, 0, 0])), Placed(BASE)
    here, there = REPORTS[name](origin), REPORTS[name](placed)
    assert differences(here, there, placed) == []


def test_the_report_has_the_base_pose() -> None:
    placed = Placed(BASE)
    report = percuss.mass(placed.pose, placed.contact)
    assert report.conditions.base_pose == pytest.approx(BASE, abs=1e-12)
    origin = percuss.mass(ARM.system(base="floating").pose(placed.pose.positions), placed.contact)
    assert origin.conditions.base_pose is None and origin.effective_mass != pytest.approx(report.effective_mass, rel=1e-3)


def test_a_saved_report_keeps_the_base_pose(tmp_path: Any) -> None:
    placed, file = Placed(BASE), tmp_path / "report.json"
    report = percuss.mass(placed.pose, placed.contact)
    file.write_text(report.to_json())
    again = percuss.mass(ARM, placed.contact, percuss.Conditions(pose=file, base="floating"))
    assert again.effective_mass == pytest.approx(report.effective_mass, rel=1e-12)
    assert again.conditions.base_pose == pytest.approx(BASE, abs=1e-12)


def test_a_list_of_contacts_is_a_list_of_reports() -> None:
    placed = Placed(BASE)
    contacts: list[percuss.Contact | str] = [placed.contact, "elbow:upper"]
    found = percuss.mass(placed.pose, contacts)
    assert [report.effective_mass for report in found] == [percuss.mass(placed.pose, one).effective_mass for one in contacts]
    speeds = percuss.safe_speed(placed.pose, contact=(placed.contact,) * 2, region="chest", force=140.0)
    assert len(speeds) == 2 and speeds[0].reflected.speed == speeds[1].reflected.speed
    assert [report.impulse for report in percuss.impact(placed.state(), [placed.contact], 0.3, FLOATING)][0] != 0
    with pytest.raises(percuss.InputError, match="empty list"):
        percuss.mass(placed.pose, [])
    with pytest.raises(percuss.InputError, match="contact is 3"):
        percuss.mass(placed.pose, [placed.contact, 3])
