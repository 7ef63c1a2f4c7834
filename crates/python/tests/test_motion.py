"""Other pose methods than respond: contact maps, travels, rates, accelerations; and changes of a model."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from cases import CASES, ROOT, Case
from numpy.typing import NDArray

import percuss

PLAIN = [c for c in CASES if not c.conditions.lock and c.conditions.against_mass is None and c.conditions.base == "fixed"]


@pytest.mark.parametrize("case", PLAIN, ids=str)
def test_a_map_answers_as_contacts_do(case: Case) -> None:
    pose, random = case.pose(), np.random.default_rng(2)
    points = np.array(case.contact.point) + random.uniform(-0.1, 0.1, (30, 3))
    normals = random.normal(size=(30, 3))
    against = case.contact.against
    masses, errors, status = pose.contact_map(case.contact.link, points, normals[:, :], against=against)
    assert masses.shape == errors.shape == status.shape == (30,) and status.dtype == np.uint8
    for at, (point, normal) in enumerate(zip(points, normals)):
        response = pose.respond(percuss.Contact(case.contact.link, point, normal, against=against))
        assert ["finite", "immovable", "massless"][status[at]] == response.status
        if response.effective_mass is None:
            assert np.isnan(masses[at]) and np.isnan(errors[at])
        else:
            assert response.error is not None
            # Both results state an error; the last term covers second order.
            allowed = errors[at] + response.error + 1e-13 * response.effective_mass
            assert abs(masses[at] - response.effective_mass) <= allowed
    again = pose.contact_map(case.contact.link, np.asfortranarray(points), normals.tolist(), against=against)
    assert np.array_equal(again[0], masses, equal_nan=True)


def test_principal_masses_bound_all_directions() -> None:
    pose = percuss.load(ROOT / "models/six_r_arm.urdf").pose({"shoulder": 0.3, "elbow": 0.7})
    principal = pose.principal_masses("tool", [0.08, 0, 0])
    assert principal is not None and len(principal) == 3
    masses = [one["effective_mass"] for one in principal]
    assert masses == sorted(masses) and all(one["status"] == "finite" and one["error"] for one in principal)  # type: ignore[type-var]
    axes = np.array([one["direction"] for one in principal])
    assert axes @ axes.T == pytest.approx(np.eye(3), abs=1e-9)
    normals = np.random.default_rng(0).normal(size=(500, 3))
    found, _, _ = pose.contact_map("tool", np.tile([0.08, 0, 0], (500, 1)), normals)
    assert masses[0] * (1 - 1e-9) <= found.min() and found.max() <= masses[2] * (1 + 1e-9)  # type: ignore[operator]
    # 1/m̄ is a quadratic form of the direction, with the principal directions as axes.
    unit = normals / np.linalg.norm(normals, axis=1)[:, None]
    form = ((unit @ axes.T) ** 2 / np.array(masses, dtype=float)).sum(axis=1)
    assert 1 / found == pytest.approx(form, rel=1e-9)


@pytest.mark.parametrize(
    ("points", "normals", "words"),
    [
        ([[0, 0]], [[0, 0, 1]], r"points has shape \(1, 2\); expected \(N, 3\)"),
        ([[0, 0, 0]], [[0, 0, 1]] * 2, r"normals has shape \(2, 3\); expected \(1, 3\)"),
        ([[0, np.nan, 0]], [[0, 0, 1]], r"points\[0, 1\] is NaN"),
        ([[0, 0, 0]], [[np.inf, 0, 1]], r"normals\[0, 0\] is inf"),
        ([0.0, 0, 0], [[0, 0, 1]], r"points has shape \(3,\)"),
    ],
)
def test_maps_refuse_what_means_nothing(points: object, normals: object, words: str) -> None:
    pose = percuss.load(ROOT / "models/six_r_arm.urdf").pose()
    with pytest.raises(percuss.InputError, match=words):
        pose.contact_map("tool", points, normals)  # type: ignore[arg-type]
    with pytest.raises(percuss.InputError, match='"tol"'):
        pose.contact_map("tol", [[0, 0, 0]], [[0, 0, 1]])
    empty = pose.contact_map("tool", np.empty((0, 3)), np.empty((0, 3)))
    assert all(len(column) == 0 for column in empty)


def test_a_contact_without_a_direction_has_no_answer() -> None:
    pose = percuss.load(ROOT / "models/six_r_arm.urdf").pose()
    masses, _, status = pose.contact_map("tool", np.zeros((2, 3)), [[0, 0, 0], [0, 1, 0]])
    assert list(status) == [percuss.Status.NO_ANSWER, percuss.Status.FINITE] and np.isnan(masses[0])


LINKAGES = [
    ("double_wishbone", "wheel_centre", [0.0, 0.0, 1.0], 0.03),
    ("four_bar", "rocker", [1.0, 0.0, 0.0], 0.02),
    ("slider_crank", "slider", [1.0, 0.0, 0.0], 0.02),
    ("six_r_arm", "tool", [0.0, 0.0, 1.0], 0.02),
]


@pytest.mark.parametrize(("name", "link", "direction", "distance"), LINKAGES)
def test_travels(name: str, link: str, direction: list[float], distance: float) -> None:
    model = percuss.load(ROOT / f"models/{name}.urdf")
    start = model.pose({"crank_hinge": 0.4}) if name in ("four_bar", "slider_crank") else model.pose()
    travel = percuss.suspension.Travel(start, link, [0.05, 0.1, 0.02], np.multiply(direction, 3.0))
    assert travel.link == link and travel.displacement(start) == 0 and link in repr(travel)
    assert travel.direction == pytest.approx(direction) and travel.point == pytest.approx([0.05, 0.1, 0.02])
    driver = travel.driver(start)
    moved = travel.pose(start, distance, driver=driver)
    # Newton's method, to 1e-12 of the mechanism's size.
    assert travel.displacement(moved) == pytest.approx(distance, abs=1e-10)
    frames = [pose.link_frame(link) @ [0.05, 0.1, 0.02, 1] for pose in (start, moved)]
    assert (frames[1] - frames[0])[:3] @ direction == pytest.approx(distance, abs=1e-10)
    rate, h = travel.rate(moved, driver), 1e-5
    at = moved.joints[driver][0]
    ends = [travel.displacement(model.pose({driver: at + step})) for step in (h, -h)] if name != "four_bar" else []
    if ends:
        # A central difference: h² and rounding over h.
        assert rate == pytest.approx((ends[0] - ends[1]) / (2 * h), rel=1e-6)
    with pytest.raises(percuss.NoAnswerError, match="nearest"):
        travel.pose(start, 50.0, driver=driver)
    with pytest.raises(percuss.InputError, match="another model"):
        travel.displacement(percuss.load(ROOT / "models/physical_pendulum.urdf").pose())
    with pytest.raises(percuss.InputError, match="no length"):
        percuss.suspension.Travel(start, link, [0, 0, 0], [0, 0, 0])


def seeded(model: percuss.Model, seed: int) -> Iterator[tuple[dict[str, float], dict[str, float]]]:
    random = np.random.default_rng(seed)
    joints = [joint.name for joint in model.joints if joint.kind != "fixed" and joint.mimics is None]
    for _ in range(5):
        yield dict(zip(joints, random.uniform(-1, 1, len(joints)))), dict(zip(joints, random.normal(size=len(joints))))


def test_the_rate_of_m_on_a_tree() -> None:
    model = percuss.load(ROOT / "models/six_r_arm.urdf")
    contact, h = percuss.Contact("tool", [0.08, 0, 0], [0, 1, 0]), 1e-5
    place: dict[str, float] = {}
    rates: dict[str, float] = {}
    rate: float | None = None
    for place, rates in seeded(model, 4):
        rate = model.pose(place).effective_mass_rate(contact, rates)
        ends = [
            model.pose({name: q + step * rates[name] for name, q in place.items()}).respond(contact).effective_mass
            for step in (h, -h)
        ]
        assert ends[0] is not None and ends[1] is not None and rate is not None
        assert rate == pytest.approx((ends[0] - ends[1]) / (2 * h), rel=1e-5, abs=1e-7)
    # A rate is linear in the velocities.
    pose = model.pose(place)
    double = pose.effective_mass_rate(contact, {name: 2 * v for name, v in rates.items()})
    assert double == pytest.approx(2 * rate, rel=1e-12)  # type: ignore[operator]
    assert pose.effective_mass_rate(contact, {}) == 0


@pytest.mark.parametrize(("name", "link"), [("four_bar", "coupler"), ("double_wishbone", "wheel_centre"), ("six_bar", "link_6")])
def test_the_rate_of_m_on_a_linkage(name: str, link: str) -> None:
    pose = percuss.load(ROOT / f"models/{name}.urdf").pose()
    contact, h = percuss.Contact(link, [0.1, 0.05, 0.02], [0.6, 0.8, 0.0]), 1e-5
    response = pose.respond(contact)
    rate = pose.effective_mass_rate(contact, response.joint_velocities)
    ends = [pose.advanced_along(response, step) for step in (h, -h)]
    assert ends[0] is not None and ends[1] is not None
    masses = [end.respond(contact).effective_mass for end in ends if end]
    assert rate == pytest.approx((masses[0] - masses[1]) / (2 * h), rel=1e-4)  # type: ignore[operator]
    with pytest.raises(percuss.InputError, match="loops open"):
        first = next(joint for joint, rates in response.joint_velocities.items() if rates.any())
        pose.effective_mass_rate(contact, {first: 1.0})


def test_rates_that_mean_nothing() -> None:
    model = percuss.load(ROOT / "models/six_r_arm.urdf")
    contact = percuss.Contact("tool", [0.08, 0, 0], [0, 1, 0])
    locked = model.system(lock=["yaw"]).pose()
    wrong: list[tuple[percuss.Pose, dict[str, Any], str]] = [
        (model.pose(), {"yaw": [1.0, 2.0]}, "2 numbers; expected 1"),
        (model.pose(), {"yaw": np.nan}, "finite"),
        (model.pose(), {"yaww": 1.0}, "yaww"),
        (locked, {"yaw": 1.0}, "locked"),
    ]
    for pose, rates, words in wrong:
        with pytest.raises(percuss.InputError, match=words):
            pose.effective_mass_rate(contact, rates)
    pendulum = percuss.load(ROOT / "models/physical_pendulum.urdf").pose()
    assert pendulum.effective_mass_rate(percuss.Contact("body", [0, 0, -0.5], [0, 0, 1]), {"hinge": 1.0}) is None


def test_accelerations() -> None:
    pendulum = percuss.load(ROOT / "models/physical_pendulum.urdf")
    for angle in (-1.2, 0.0, 0.4, 2.0):
        found = pendulum.pose({"hinge": angle}).accelerations({"hinge": 0.7}, gravity=[0, 0, -9.81])
        # m g h sin q / J: 3 kg, 0.4 m, 0.55 kg·m².
        assert found.joints["hinge"][0] == pytest.approx(-3 * 9.81 * 0.4 * np.sin(angle) / 0.55, rel=1e-12)
    arm = percuss.load(ROOT / "models/six_r_arm.urdf")
    point, force = [0.08, 0.02, 0.0], np.array([3.0, -5.0, 2.0])
    for place, _ in seeded(arm, 6):
        pose = arm.pose(place)
        found = pose.accelerations(forces=[("tool", point, force)])
        # At rest M q̈ = Jᵀ f, and the point's acceleration is J q̈.
        order = [joint for joint, _ in arm.system().coordinate_joints]
        rates = np.array([found.joints[joint][0] for joint in order if joint])
        jacobian = pose.point_jacobian("tool", point)
        assert pose.mass_matrix() @ rates == pytest.approx(jacobian.T @ force, rel=1e-8, abs=1e-10)
        assert found.point("tool", point) == pytest.approx(jacobian @ rates, rel=1e-9)
    # A free body falls; a force accelerates its centre of mass by force over mass.
    free = pendulum.system(base="floating", lock=["hinge"]).pose()
    falling = free.accelerations(gravity=[0, 0, -9.81], forces=[("body", [0, 0, -0.4], [6.0, 0, 0])])
    assert falling.point("body", [0, 0, -0.4]) == pytest.approx([2.0, 0, -9.81], rel=1e-9)
    with pytest.raises(percuss.InputError, match="loops"):
        percuss.load(ROOT / "models/four_bar.urdf").pose().accelerations()
    with pytest.raises(percuss.InputError, match="link, point, force"):
        arm.pose().accelerations(forces=[("tool", point)])  # type: ignore[list-item]
    with pytest.raises(percuss.InputError, match="expected 6"):
        free.accelerations(base=[1, 2, 3])


TRIANGLE = """<robot name="triangle"><link name="ground"/><link name="a"/><link name="b"/>
  <joint name="left" type="continuous"><parent link="ground"/><child link="a"/><axis xyz="0 0 1"/></joint>
  <joint name="top" type="continuous"><parent link="a"/><child link="b"/><origin xyz="0.5 0.5 0"/><axis xyz="{axis}"/></joint>
  <loop name="right" type="revolute"><predecessor link="b"><origin xyz="0.5 -0.5 0"/></predecessor>
    <successor link="ground"><origin xyz="1 0 0"/></successor><axis xyz="0 0 1"/></loop></robot>"""


def test_rigid_loops_and_gaps_as_drawn() -> None:
    (rigid,) = percuss.loads(TRIANGLE.format(axis="0 0 1")).assemble().rigid_loops()
    assert rigid["loops"] == ["right"] and sorted(rigid["joints"]) == ["left", "top"]
    four_bar = percuss.load(ROOT / "models/four_bar.urdf").assemble()
    assert four_bar.rigid_loops() == []
    assert four_bar.drawn_gaps() == []
    # The pin of the coupler is 4 mm from the pin of the rocker.
    text = (ROOT / "models/four_bar.urdf").read_text().replace("0.4 0.3 0", "0.404 0.3 0", 1)
    (gap,) = percuss.loads(text).assemble().drawn_gaps()
    assert gap["constraint"] == "rocker_pin" and not gap["is_wide"]
    assert gap["gap"] == pytest.approx(0.004) and gap["size"] > 0.4 and gap["moved"] and gap["moved"][1] != 0
    pose = percuss.load(ROOT / "models/four_bar.urdf").pose()
    assert pose.rank() == {"rank": 2, "gap": pytest.approx(pose.rank()["gap"]), "is_clear": True, "is_singular": False}


def test_joints_outside_their_limits() -> None:
    limited = """<robot name="x"><link name="ground"/><link name="a"/><joint name="j" type="revolute"><parent link="ground"/>
        <child link="a"/><axis xyz="0 0 1"/><limit lower="-1" upper="2" effort="1" velocity="1"/></joint></robot>"""
    model = percuss.loads(limited)
    assert model.pose({"j": 1.5}).outside_limits() == {}
    assert model.pose({"j": 2.5}).outside_limits() == {"j": (2.5, (-1.0, 2.0))}


def changed_masses(model: percuss.Model, contact: percuss.Contact, link: str, mass: float, h: float) -> NDArray[np.float64]:
    return np.array(
        [
            model.changed(link_mass={link: mass + step}).pose().respond(contact).effective_mass
            for step in (h, -h)
        ]
    )


def test_what_a_mass_depends_on() -> None:
    model = percuss.load(ROOT / "models/six_r_arm.urdf")
    contact = percuss.Contact("tool", [0.08, 0, 0], [0, 1, 0])
    found = percuss.reports.explain(model, contact)
    assert found is not None
    m = model.pose().respond(contact).effective_mass
    assert found.effective_mass == pytest.approx(m, rel=1e-12)
    assert sum(link["share"] for link in found.links) == pytest.approx(1, abs=1e-9)
    for link in found.links:
        h = 1e-4 * link["mass"]
        ends = changed_masses(model, contact, link["link"], link["mass"], h)
        assert link["per_kilogram"] == pytest.approx((ends[0] - ends[1]) / (2 * h), rel=1e-5, abs=1e-7)
    left = percuss.reports.tolerate(model, contact, "mass=2%", samples=400, seed=5)
    assert m is not None and left is not None and left.samples is not None and left.samples.count == 400
    assert m - left.worst_case * 1.01 <= left.samples.least <= left.samples.greatest <= m + left.worst_case * 1.01
    # Uniform numbers: the standard deviation is the root sum square over √3.
    assert left.samples.standard_deviation == pytest.approx(left.root_sum_square / np.sqrt(3), rel=0.15)
    pendulum = percuss.load(ROOT / "models/physical_pendulum.urdf")
    along = percuss.Contact("body", [0, 0, -0.5], [0, 0, 1])
    assert percuss.reports.explain(pendulum, along) is None and percuss.reports.tolerate(pendulum, along, "mass=1%") is None
    for wrong in ("mass", "mass=200%", "weight=1%"):
        with pytest.raises(percuss.InputError, match=wrong.split("=")[0]):
            percuss.reports.tolerate(model, contact, wrong)


def test_designs_side_by_side() -> None:
    path = ROOT / "models/suspensions/double-wishbone.toml"
    import warnings

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", percuss.ModelWarning)
        sheet = percuss.load(path)
        assert "upper_outer" in sheet.hardpoints or len(sheet.hardpoints) > 5
        point = sheet.hardpoints[0]
        moved = sheet.changed(move={point: [0.0, 0.0, 0.005]})
        heavy = moved.changed(link_mass={"upright": 30.0})
    assert percuss.reports.check(heavy).total_mass != percuss.reports.check(sheet).total_mass
    contact = percuss.Contact("spring_seat", [0, 0, 0], toward=("spring_chassis_seat", [0, 0, 0]), against="chassis")
    designs = [percuss.study.Design("as drawn", sheet, contact), percuss.study.Design("moved", moved, contact), percuss.study.Design("heavy", heavy, contact)]
    report = percuss.study.compare(designs, vary="travel:wheel:0,0,0:0,0,1=-10mm:10mm:3")
    assert [design["name"] for design in report.designs] == ["as drawn", "moved", "heavy"] and len(report.rows) == 3
    for design, asked in zip(report.designs, designs):
        alone = percuss.mass(asked.model, contact)
        assert design["effective_mass"] == alone.effective_mass
        expected = 100 * (alone.effective_mass / report.designs[0]["effective_mass"] - 1)
        if design["difference_percent"] is not None:
            assert design["difference_percent"] == pytest.approx(expected, abs=1e-9)
    assert report.rows[1]["effective_mass"] == pytest.approx([d["effective_mass"] for d in report.designs], rel=1e-8)
    with pytest.raises(percuss.InputError, match="two at least"):
        percuss.study.compare(designs[:1])
    with pytest.raises(percuss.InputError, match="upright_"):
        sheet.changed(link_mass={"upright_": 1.0})
    with pytest.raises(percuss.InputError, match="sheet"):
        percuss.load(ROOT / "models/four_bar.urdf").changed(move={"x": [0, 0, 1]})


def test_a_study_with_variants(tmp_path) -> None:  # type: ignore[no-untyped-def]
    study = tmp_path / "study.toml"
    study.write_text(
        f'[model]\npath = "{ROOT}/models/six_r_arm.urdf"\nname = "arm"\n[contact]\nlink = "tool"\npoint = [0.08, 0, 0]\nnormal = [0, 1, 0]\n'
        '[[variant]]\nname = "light tool"\nlink_mass = { tool = "0.2kg" }\n'
    )
    report = percuss.study.compare_study(study)
    assert [design["name"] for design in report.designs] == ["arm", "light tool"]
    model, contact = percuss.load(ROOT / "models/six_r_arm.urdf"), percuss.Contact("tool", [0.08, 0, 0], [0, 1, 0])
    light = model.changed(link_mass={"tool": 0.2}).pose().respond(contact).effective_mass
    assert report.designs[1]["effective_mass"] == pytest.approx(light, rel=1e-12)


def test_studies_of_a_model(tmp_path) -> None:  # type: ignore[no-untyped-def]
    study, model = tmp_path / "study.toml", f'[model]\npath = "{ROOT}/models/suspensions/double-wishbone.toml"\n'
    for table, schema in (('[kinematics]\nvary = "wheel-travel=-10mm:10mm:3"\n', "percuss.kinematics/1"), ("[check]\n", "percuss.check/1")):
        study.write_text(model + table)
        assert percuss.study.run(study).schema == schema


def test_safe_speeds_by_energy_momentum_and_rows() -> None:
    model, contact = percuss.load(ROOT / "models/six_r_arm.urdf"), percuss.Contact("tool", [0.08, 0, 0], [0, 1, 0])
    region = percuss.reports.regions()[0][0]
    of_region = {name: mass for name, _, mass, _ in percuss.reports.regions()}[region]
    energy = percuss.safe_speed(model, contact, region, energy=2.0)
    robot = energy.reflected["robot_mass"]
    reduced = 1 / (1 / robot + 1 / of_region)
    assert energy.limited_by == "energy" and energy.reflected["reduced_mass"] == pytest.approx(reduced)
    assert energy.reflected["speed"] == pytest.approx(np.sqrt(2 * 2.0 / reduced))
    momentum = percuss.safe_speed(model, contact, None, momentum=0.5)
    assert momentum.limited_by == "momentum" and momentum.region is None
    assert momentum.reflected["speed"] * momentum.reflected["reduced_mass"] <= 0.5 * (1 + 1e-12)
    along = percuss.safe_speed(model, contact, region, force=140.0, vary=("shoulder", -0.5, 0.5, 5)).along
    assert along is not None and along.rows == 5
    each = [
        percuss.safe_speed(model, contact, region, percuss.Conditions(set={"shoulder": at}), force=140.0).reflected["speed"]
        for at in np.linspace(-0.5, 0.5, 5).tolist()
    ]
    assert along["slowest"]["speed"] == pytest.approx(min(each), rel=1e-9) and along["row"] == int(np.argmin(each))
    directions = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.3, -0.8, 0.5]]
    *some, worst = percuss.reports.safe_speed_directions(model, contact, region, directions, force=140.0, worst=True)
    assert len(some) == 4 and worst.reflected["speed"] <= min(one.reflected["speed"] for one in some) * (1 + 1e-9)
    for limit in ({}, {"force": 1.0, "energy": 1.0}, {"pressure": 1e6}):
        with pytest.raises(percuss.InputError, match="one limit is required"):
            percuss.safe_speed(model, contact, region, **limit)  # type: ignore[call-overload]


def test_the_gradient_gives_every_rate() -> None:
    arm = percuss.load(ROOT / "models/six_r_arm.urdf")
    contact = percuss.Contact("tool", [0.08, 0, 0], [0, 1, 0])
    for place, rates in seeded(arm, 9):
        pose = arm.pose(place)
        gradient = pose.effective_mass_gradient(contact)
        assert gradient is not None
        total = sum(float(gradient[name] @ np.atleast_1d(rate)) for name, rate in rates.items())
        assert total == pytest.approx(pose.effective_mass_rate(contact, rates), rel=1e-12)
    pendulum = percuss.load(ROOT / "models/physical_pendulum.urdf").pose()
    assert pendulum.effective_mass_gradient(percuss.Contact("body", [0, 0, -0.5], [0, 0, 1])) is None
