"""Load, pose, respond, for every contact stated in the shipped models."""

from __future__ import annotations

import json
import pickle
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from cases import CASES, MODELS, ROOT, Case

import percuss

COMMAND = Path(sys.executable).parent / "percuss"


def command(*arguments: str, input: str | None = None) -> subprocess.CompletedProcess[str]:
    words = [str(COMMAND), *arguments]
    return subprocess.run(words, capture_output=True, text=True, cwd=ROOT, timeout=60, input=input)


@pytest.mark.parametrize("case", CASES, ids=str)
def test_the_stated_mass_by_every_way(case: Case) -> None:
    report = percuss.mass(percuss.load(case.path), case.contact, case.conditions)
    assert report.status == "finite"
    assert report.effective_mass == pytest.approx(case.expected, rel=max(case.tolerance, 1e-11))

    pose = case.pose()
    response = pose.respond(case.contact)
    if case.conditions.against_mass is not None:
        response = response.against_mass(case.conditions.against_mass)
    assert response.status == "finite" and response.effective_mass is not None
    assert response.effective_mass == pytest.approx(report.effective_mass, rel=1e-12)
    assert response.error is not None and 0 < response.error < 1e-6 * response.effective_mass
    budget = response.error_budget
    known = [budget["rounding"], budget["closing"], budget["file"]]
    assert sum(part or 0 for part in known) == pytest.approx(response.error)
    shares = (response.contributions or {}) | (response.rotor_contributions or {})
    if case.conditions.against_mass is None:
        assert sum(shares.values()) == pytest.approx(1, abs=1e-9)
        assert [body["share"] for body in report.bodies] == pytest.approx(
            list((response.contributions or {}).values())
        )
    assert response.point_world == pytest.approx(report.contact["point_world"])
    assert response.normal_world == pytest.approx(report.contact["normal_world"])


@pytest.mark.parametrize("case", [c for c in CASES if c.conditions.against_mass is None], ids=str)
def test_the_matrices_of_a_pose_have_its_mass(case: Case) -> None:
    pose = case.pose()
    response = pose.respond(case.contact)
    mass, rows, row = pose.mass_matrix(), pose.constraint_matrix(), pose.contact_row(case.contact)
    n = pose.model.system(
        base=case.conditions.base or "fixed", lock=list(case.conditions.lock)
    ).coordinates
    assert mass.shape == (n, n) and rows.shape[1] == n and row.shape == (n,)
    assert mass.dtype == rows.dtype == row.dtype == np.float64
    assert mass == pytest.approx(mass.T)
    found = percuss.effective_mass(mass, row, rows)
    assert found.status == response.status and found.effective_mass is not None
    assert found.effective_mass == pytest.approx(response.effective_mass, rel=1e-9)
    assert found.degrees_of_freedom == response.degrees_of_freedom
    v = found.velocity
    assert row @ v == pytest.approx(1)
    assert rows @ v == pytest.approx(np.zeros(len(rows)), abs=1e-9 * np.abs(v).max())
    assert v @ mass @ v == pytest.approx(found.effective_mass, rel=1e-9)
    w = np.concatenate([np.zeros(3), response.normal_world, np.zeros(3), -response.normal_world])
    try:
        phi = pose.contact_mobility(case.contact)
    except percuss.NoAnswerError as error:
        assert "motion without mass" in str(error)
        return
    if case.conditions.base == "fixed" or case.contact.against:
        assert phi.shape == (12, 12) and 1 / (w @ phi @ w) == pytest.approx(response.effective_mass, rel=1e-9)


@pytest.mark.parametrize("case", CASES[::4], ids=str)
def test_the_command_says_the_same(case: Case) -> None:
    # Without the expected mass and its tolerance.
    words = case.command[: case.command.index("--expect")]
    ran = command(*words, "--format", "json")
    assert ran.returncode == 0, ran.stderr
    printed = json.loads(ran.stdout)
    report = percuss.mass(percuss.load(case.path), case.contact, case.conditions)
    for key in ("effective_mass", "effective_mass_error", "bodies", "pose", "contact", "degrees_of_freedom"):
        assert printed[key] == report[key], key
    assert set(printed) == set(report)


def test_exit_codes_of_the_command() -> None:
    assert command("--version").stdout.split() == ["percuss", percuss.__version__]
    assert command("check", "models/four_bar.urdf").returncode == 0
    bad = command("check", "no/such.urdf")
    assert bad.returncode == 2 and "no/such.urdf" in bad.stderr and bad.stdout == ""
    assert command("mass").returncode == 2
    flags = ("models/four_bar.urdf", "--link", "coupler", "--point", "0.35,0.1,0", "--normal", "0,1,0")
    wrong = command("mass", *flags, "--expect", "5")
    assert wrong.returncode == 1, "not the mass that was expected: no answer"
    reached = command("mass", *flags, "--set", "coupler_hinge=3")
    assert reached.returncode == 2 and "coupler_hinge" in reached.stderr


def test_the_command_reads_standard_input_and_a_closed_output_is_no_error() -> None:
    ran = command("check", "-", input=(ROOT / "models/four_bar.urdf").read_text())
    assert ran.returncode == 0 and "four_bar" in ran.stdout
    pipe = f"'{COMMAND}' sweep models/four_bar.urdf --link coupler --point 0.35,0.1,0 --normal 0,1,0 --vary crank_hinge=0:1:20000 | head -n 1"
    ran = subprocess.run(["bash", "-o", "pipefail", "-c", pipe], capture_output=True, text=True, cwd=ROOT, timeout=60)
    assert ran.returncode == 0 and ran.stdout.startswith("row,"), ran.stderr


@pytest.mark.parametrize("path", MODELS, ids=lambda path: path.stem)
def test_what_a_model_tells(path: Path) -> None:
    model = percuss.load(path)
    report = percuss.reports.check(model)
    assert model.name == report.name and model.links == [link["name"] for link in report.links]
    assert model.total_mass == pytest.approx(report.total_mass)
    assert [joint.name for joint in model.joints] == [joint["name"] for joint in report.joints]
    last = model.joints[-1].positions[1] if model.joints else 0
    assert model.position_count == len(model.position_names) == last
    assert model.name in repr(model)
    assembly = model.assemble()
    assert assembly.degrees_of_freedom == report.generic_degrees_of_freedom
    assert assembly.drivers == report.drivers
    again = percuss.loads(model.to_urdf(), name="again.urdf")
    assert again.links == model.links and again.position_names == model.position_names
    sent = pickle.loads(pickle.dumps(model))
    assert sent.to_urdf() == model.to_urdf()
    pose = model.pose()
    assert np.array_equal(sent.pose().positions, pose.positions)
    frame = pose.link_frame(model.links[-1])
    assert frame.shape == (4, 4) and frame[:3, :3] @ frame[:3, :3].T == pytest.approx(np.eye(3))
    # The rows of a Jacobian are the rates of the point.
    jacobian = pose.point_jacobian(model.links[-1], [0.1, 0.2, 0.3])
    assert jacobian.shape == (3, model.system().coordinates)


def test_models_are_read_and_written_as_mjcf() -> None:
    model = percuss.load(ROOT / "models/four_bar.urdf")
    again = percuss.loads(model.to_mjcf(), name="four_bar.xml")
    assert again.total_mass == pytest.approx(model.total_mass)
    contact = percuss.Contact("coupler", [0.35, 0.1, 0.0], normal=[0.0, 1.0, 0.0])
    masses = [m.pose({"crank_hinge": 0.4}).respond(contact).effective_mass for m in (model, again)]
    assert masses[1] == pytest.approx(masses[0], rel=1e-12)
    joint = "<joint name='j' type='continuous'><parent link='a'/><child link='b'/></joint>"
    with pytest.raises(percuss.InputError, match="without mass"):
        percuss.loads(f"<robot name='r'><link name='a'/><link name='b'/>{joint}</robot>").to_mjcf()


def test_models_are_read_and_written_as_sdformat() -> None:
    model = percuss.load(ROOT / "models/four_bar.urdf")
    again = percuss.loads(model.to_sdf(), name="four_bar.sdf")
    contact = percuss.Contact("coupler", [0.35, 0.1, 0.0], normal=[0.0, 1.0, 0.0])
    masses = [m.pose({"crank_hinge": 0.4}).respond(contact).effective_mass for m in (model, again)]
    assert masses[1] == pytest.approx(masses[0], rel=1e-12)
    with pytest.raises(percuss.InputError, match="no distance joint"):
        percuss.load(ROOT / "models/double_wishbone.urdf").to_sdf()
    two = "<sdf version='1.9'><model name='a'><link name='x'/></model><model name='b'><link name='y'/></model></sdf>"
    assert percuss.loads(two, name="two.sdf#b").links[-1] == "y"
    with pytest.raises(percuss.LoadError, match="several models: a, b"):
        percuss.loads(two, name="two.sdf")


def test_contacts_compare_print_and_travel() -> None:
    contact = percuss.Contact("a", (1, 2, 3), np.array([0, 0, 1]), against="b", normal_frame="world")
    assert contact == pickle.loads(pickle.dumps(contact)) == eval(repr(contact), {"Contact": percuss.Contact})
    toward = percuss.Contact("a", [0, 0, 0], toward=("b", [1, 0, 0]))
    assert toward == pickle.loads(pickle.dumps(toward)) and toward != contact
    assert toward.normal is None and toward.toward == ("b", (1.0, 0.0, 0.0))
    cable = percuss.Contact("a", [0, 0, 0], toward=("b", [1, 0, 0]), cable=True)
    assert cable == pickle.loads(pickle.dumps(cable)) == eval(repr(cable), {"Contact": percuss.Contact})
    assert cable != toward and cable.against == "b" and cable.cable and not cable.turning and not toward.cable


def test_a_cable_has_the_mass_of_its_line() -> None:
    arm = percuss.load(ROOT / "models/planar_2r.urdf")
    pose = arm.pose({"elbow": 0.7})
    line = percuss.Contact("outer", [0.4, 0, 0], toward=("ground", [0, 1, 0]), turning=True, against="ground")
    cable = percuss.Contact("outer", [0.4, 0, 0], toward=("ground", [0, 1, 0]), cable=True)
    pushed, pulled = pose.respond(line), pose.respond(cable)
    assert pulled.effective_mass == pytest.approx(pushed.effective_mass, rel=1e-12)
    # The gap closes while the cable gets longer.
    for joint, rates in pulled.joint_velocities.items():
        assert rates == pytest.approx(-pushed.joint_velocities[joint], rel=1e-12)
    with pytest.raises(percuss.InputError, match="toward"):
        percuss.Contact("outer", [0.4, 0, 0], [0, 1, 0], cable=True)
    with pytest.raises(percuss.InputError, match="turning"):
        percuss.Contact("outer", [0.4, 0, 0], toward=("ground", [0, 1, 0]), cable=True, turning=True)


def test_a_base_pose_moves_the_world_and_no_mass() -> None:
    model = percuss.load(ROOT / "models/four_bar.urdf")
    contact = percuss.Contact("coupler", [0.35, 0.1, 0], [0, 1, 0])
    system = model.system()
    here = system.pose({"crank_hinge": 0.3}).respond(contact)
    there = system.pose({"crank_hinge": 0.3}, base_pose=[1, 2, 3, 0, 0, 0, 1]).respond(contact)
    assert there.effective_mass == pytest.approx(here.effective_mass, rel=1e-12)
    turned = here.point_world * [-1, -1, 1] + [1, 2, 3]
    assert there.point_world == pytest.approx(turned)
    speed = here.point_velocity
    at = system.pose({"crank_hinge": 0.3})
    assert speed("coupler", [0.35, 0.1, 0]) @ here.normal_world == pytest.approx(1)  # type: ignore[operator]
    assert at.closure_residual is not None and at.closure_residual < 1e-12


def test_outcomes_that_are_no_number() -> None:
    pose = percuss.load(ROOT / "models/physical_pendulum.urdf").pose()
    along = pose.respond(percuss.Contact("body", [0, 0, -0.5], [0, 0, 1]))
    assert (along.status, along.effective_mass, along.error, along.contributions) == ("immovable", None, None, None)
    assert "immovable" in repr(along)
    text = """<robot name="free"><link name="ground"/><link name="rod"/><joint name="hinge" type="continuous">
        <parent link="ground"/><child link="rod"/><axis xyz="0 1 0"/></joint></robot>"""
    free = percuss.loads(text).pose().respond(percuss.Contact("rod", [0, 0, 1], [1, 0, 0]))
    assert (free.status, free.effective_mass) == ("massless", None)


def test_limits_along_branches() -> None:
    pose = percuss.load(ROOT / "models/antiparallelogram.urdf").system().pose(
        {"crank_hinge": np.arctan2(0.3, 0.72) - np.arctan2(0.3, 0.4)}
    )
    response = pose.respond(percuss.Contact("rocker", [0.4, -0.3, 0.0], [3.0, 4.0, 0.0]))
    assert pose.is_singular and response.singular_pose and "singular" in repr(response)
    assert len(response.branch_limits()) == 2


def test_warnings_and_diagnostics() -> None:
    path = ROOT / "models/four_bar.urdf"
    text = path.read_text()
    with pytest.warns(percuss.ModelWarning, match="some.urdf") as caught:
        model = percuss.loads(text.replace("</robot>", '<joint_that_is_none name="x"/></robot>'), name="some.urdf")
    of_model = [d for d in model.diagnostics if d.severity == "warning"]
    assert of_model and str(of_model[0]) == str(caught[0].message)
    assert caught[0].filename == __file__, "the warning is not at the line of the caller"
    assert of_model[0].path == "some.urdf" and of_model[0].line and of_model[0].code
    assert of_model[0].message in repr(of_model[0])


def four_bar() -> percuss.Model:
    return percuss.load(ROOT / "models/four_bar.urdf")


@pytest.mark.parametrize(
    ("call", "kind", "words"),
    [
        (lambda: percuss.load("no/such/file.urdf"), percuss.LoadError, "no/such/file.urdf"),
        (lambda: percuss.loads("<robot"), percuss.LoadError, "<text>"),
        (lambda: percuss.load(ROOT / "models/four_bar.urdf", accept=["all"]), percuss.InputError, "indefinite-inertia"),
        (lambda: four_bar().pose({"crank_hing": 1}), percuss.InputError, "crank_hinge"),
        (lambda: four_bar().pose({"crank_hinge": [1, 2]}), percuss.InputError, "2 values given"),
        (lambda: four_bar().pose({"crank_hinge": np.nan}), percuss.InputError, "finite"),
        (lambda: four_bar().pose({"crank_hinge": "20deg"}), percuss.InputError, "text '20deg'; expected numbers"),
        (lambda: percuss.load("<robot name='a'/>"), percuss.InputError, "percuss.loads reads text"),
        (lambda: percuss.loads("models/four_bar.urdf"), percuss.InputError, "percuss.load reads files"),
        (lambda: four_bar().pose([1.0]), percuss.InputError, "1 positions are given, the mechanism has 3"),
        (lambda: four_bar().pose([[1.0]]), percuss.InputError, r"shape \(1, 1\)"),
        (lambda: four_bar().pose(["a"]), percuss.InputError, "real numbers"),
        (lambda: four_bar().pose([1j, 0, 0]), percuss.InputError, "complex128"),
        (lambda: four_bar().pose({"coupler_hinge": 3.0}), percuss.PercussError, "coupler_hinge"),
        (lambda: four_bar().system(base="free"), percuss.InputError, "floating"),  # type: ignore[arg-type]
        (lambda: four_bar().system(lock=["none"]), percuss.InputError, "none"),
        (lambda: four_bar().system(hold=[("coupler",)]), percuss.InputError, "hold"),  # type: ignore[list-item]
        (lambda: four_bar().system(armature={"crank_hinge": -1}), percuss.InputError, "armature"),
        (lambda: percuss.Contact("a", [0, 0], [1, 0, 0]), percuss.InputError, "2 numbers; expected 3"),
        (lambda: percuss.Contact("a", [0, 0, 0]), percuss.InputError, "normal and toward"),
        (lambda: percuss.Contact("a", [0, 0, 0], [1, 0, 0], normal_frame="x"), percuss.InputError, "world"),  # type: ignore[arg-type]
        (lambda: four_bar().pose().respond(percuss.Contact("a", [0, 0, 0], [1, 0, 0])), percuss.InputError, '"a"'),
        (
            lambda: four_bar().pose().respond(percuss.Contact("coupler", [0, 0, 0], [0, 0, 0])),
            percuss.InputError,
            "normal",
        ),
        (
            lambda: four_bar().pose().respond(percuss.Contact("coupler", [0, 0, 0], [1, 0, 0]), route="fast"),  # type: ignore[arg-type]
            percuss.InputError,
            "articulated",
        ),
        (lambda: four_bar().system().pose(base_pose=[1, 2]), percuss.InputError, "expected 7"),
        (lambda: four_bar().system().pose(base_pose=[0, 0, 0, 1, 1, 0, 0]), percuss.InputError, "unit quaternion"),
    ],
)
def test_bad_input(call, kind, words) -> None:  # type: ignore[no-untyped-def]
    with pytest.raises(kind, match=words):
        call()
    assert issubclass(percuss.InputError, ValueError)


def test_every_finding_of_a_bad_file_is_an_object() -> None:
    with pytest.raises(percuss.LoadError) as raised:
        percuss.loads('<robot name="x"><link name="a"/><link name="a"/></robot>', name="twice.urdf")
    found = raised.value.diagnostics
    assert any(d.severity == "error" and d.line for d in found)
    assert str(raised.value) == "\n".join(str(d) for d in found if d.severity == "error")
    ran = command("check", "-", input='<robot name="x"><link name="a"/><link name="a"/></robot>')
    assert found[0].message in ran.stderr


def test_what_does_not_assemble() -> None:
    model = percuss.load(ROOT / "models/double_wishbone.urdf")
    driver = model.assemble().drivers[0]
    with pytest.raises(percuss.errors.AssemblyError, match=driver):
        model.pose({driver: 3.0})
    with pytest.raises(percuss.errors.AssemblyError, match=driver):
        percuss.mass(model, percuss.Contact("wheel_centre", [0, 0, 0], [0, 0, -1]), percuss.Conditions(set={driver: 3.0}))


def test_a_bush_is_that_of_the_file() -> None:
    text = """<robot name="cart"><link name="rail"/>
      <link name="cart"><inertial><mass value="3"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
      <link name="lamp"><inertial><mass value="2"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
      <joint name="slide" type="prismatic"><parent link="rail"/><child link="cart"/><limit lower="-1" upper="1" effort="0" velocity="0"/></joint>
      <joint name="mount" type="fixed"><parent link="cart"/><child link="lamp"/></joint>{}</robot>"""
    bushing = """<bushing name="rubber" parent="lamp" child="cart"><origin xyz="0 0 0.1" rpy="0 1.5707963267948966 0"/>
      <stiffness xyz="4e4 4e4 8e4" rpy="30 30 20" loss_factor="0.1"/><joint name="mount"/></bushing>"""
    plain, read = percuss.loads(text.format("")), percuss.loads(text.format(bushing))
    contact = percuss.Contact("lamp", [0, 0, 0], [1, 0, 0])
    built = plain.with_bush(
        "rubber", "lamp", against="cart", at=[0, 0, 0.1], axis=[1, 0, 0], x_axis=[0, 0, -1],
        stiffness=[30, 30, 20, 4e4, 4e4, 8e4], loss_factor=0.1, replaces=["mount"],
    )  # fmt: skip
    assert built.bushes == ["rubber"] and plain.bushes == []
    expected, found = percuss.mass(read, contact).compliance, percuss.mass(built, contact).compliance
    assert expected is not None and found is not None and found.free_mass == pytest.approx(expected.free_mass, rel=1e-12)
    assert found.residual_stiffness == pytest.approx(expected.residual_stiffness, rel=1e-12)
    # The bush is kept by later changes and by pickling.
    for kept in (built.changed(link_mass={"lamp": 2.0}), pickle.loads(pickle.dumps(built))):
        assert kept.bushes == ["rubber"]
        again = percuss.mass(kept, contact).compliance
        assert again is not None and again.residual_stiffness == pytest.approx(found.residual_stiffness, rel=1e-12)
    with pytest.raises(percuss.InputError, match="lampe"):
        plain.with_bush("rubber", "lampe", stiffness=[0.0] * 6)
    with pytest.raises(percuss.InputError, match="axis"):
        plain.with_bush("rubber", "lamp", axis=[0, 0, 0], stiffness=[0.0] * 6)
