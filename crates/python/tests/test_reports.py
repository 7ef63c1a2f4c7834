"""Reports of the package and of the command line have the same keys and numbers."""

from __future__ import annotations

import json
import warnings
from collections.abc import Callable
from dataclasses import fields
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from cases import ROOT
from test_models import command

import percuss

MODEL = "models/double_wishbone.urdf"
SEAT = percuss.Contact("spring_seat", [0, 0, 0], toward=("spring_chassis_seat", [0, 0, 0]), against="chassis")
FLAGS = ("--link", "spring_seat", "--point", "0,0,0", "--along-line", "spring_chassis_seat:0,0,0", "--against", "chassis")


def printed(*arguments: str) -> dict[str, object]:
    ran = command(*arguments)
    assert ran.returncode == 0, ran.stderr
    found = json.loads(ran.stdout)
    assert isinstance(found, dict)
    return found


def without_paths(report: dict[str, object]) -> dict[str, object]:
    """The report, and the report of the mass in it, without file names, which depend on the given path."""
    kept = {key: value for key, value in report.items() if key not in ("inputs", "diagnostics")}
    mass = kept.get("mass")
    return kept | {"mass": without_paths(mass)} if isinstance(mass, dict) else kept


def test_check() -> None:
    assert without_paths(percuss.reports.check(percuss.load(ROOT / MODEL))) == without_paths(
        printed("check", MODEL, "--format", "json")
    )


def test_mass_with_a_damper_and_an_estimate() -> None:
    damping = percuss.contact_law.Damping(0.5, 2e5, speed=1.0, tools=["mujoco", "drake"])
    links = percuss.load(ROOT / MODEL).links
    conditions = percuss.Conditions(lock=["spin"], estimate=([links[-1]],))
    report = percuss.mass(percuss.load(ROOT / MODEL), SEAT, conditions, damping=damping)
    flags = ("--lock", "spin", "--estimate", links[-1], "--restitution", "0.5", "--stiffness", "2e5", "--speed", "1")
    command_line = printed("mass", MODEL, *FLAGS, *flags, "--for", "mujoco,drake", "--format", "json")
    of_damper, of_command = report.pop("damper"), command_line.pop("damper")
    assert without_paths(report) == without_paths(command_line)
    assert isinstance(of_command, dict) and without_paths(of_damper) == without_paths(of_command)
    assert set(of_damper["exports"]) == {"mujoco", "drake"}
    assert report.status == "finite" and report.estimate


#: Python names of keys of a study that have another name there. An empty name: the key is no field of a question.
PYTHON_NAMES = {
    "pose.file": "pose",
    "contact.along_line": "toward",
    "contact.turning_normal": "turning",
    "damping.for": "tools",
    # Names one of several contacts of a study.
    "contact.name": "",
    "damping.limit": "",
    "damping.output": "",
}
#: Fields that are no keys of a study: the model of a study has the loops.
FIELDS_ONLY = {"closed_loops"}


def keys(table: str) -> set[str]:
    """Python names of the keys of a table of a study."""
    schema: dict[str, Any] = percuss.study.schema()["properties"][table]
    # A table, or a list of tables.
    known: dict[str, Any] = next(one["properties"] for one in (schema, *schema.get("anyOf", ())) if "properties" in one)
    return {PYTHON_NAMES.get(f"{table}.{key}", key) for key in known} - {""}


def names(question: type[Any]) -> set[str]:
    """Fields of a question."""
    return {field.name for field in fields(question)}


def test_questions_have_the_keys_of_studies() -> None:
    contact = {name for name in dir(percuss.Contact) if not name.startswith("_")}
    # A named contact is given by its name in place of a Contact.
    of_contact = keys("contact") - {"at"}
    expected = keys("conditions") | keys("pose") | (of_contact - contact) | {"hold"}
    assert names(percuss.Conditions) == expected
    assert of_contact <= contact | names(percuss.Conditions)
    assert names(percuss.contact_law.Damping) - FIELDS_ONLY == keys("damping")


def test_named_contacts() -> None:
    model = percuss.load(ROOT / "models/suspensions/double-wishbone.toml")
    assert model.contacts == ["contact_patch", "spring", "damper", "bump_stop", "rebound_stop"]
    for name in model.contacts:
        expected = printed("mass", "models/suspensions/double-wishbone.toml", "--at", name, "--format", "json")
        assert without_paths(percuss.mass(model, name)) == without_paths(expected)
    damping = percuss.contact_law.Damping(restitution=0.3, stiffness=1e6, speed=0.1)
    named = percuss.contact_law.damp_contact(model, "bump_stop", damping).named_contact
    assert named is not None and named.brought_to_touch
    with pytest.raises(percuss.InputError, match="did you mean"):
        percuss.mass(model, "bumpstop")


def test_a_pose_or_a_system_replaces_the_model() -> None:
    bar = percuss.load(ROOT / "models/four_bar.urdf")
    system = bar.system(armature={"crank_hinge": 0.2})
    pose, set = system.pose({"crank_hinge": 0.4}), {"crank_hinge": 0.4}
    given = percuss.Conditions(set=set, armature={"crank_hinge": 0.2})
    contact = percuss.Contact("coupler", [0.35, 0.1, 0], [0, 1, 0])
    damping = percuss.contact_law.Damping(0.5, 2e5, speed=1.0)
    calls: list[Callable[[Any, Any], Any]] = [
        lambda of, conditions: percuss.mass(of, contact, conditions).effective_mass,
        lambda of, conditions: percuss.impact(of, contact, 0.3, conditions, speed=1.0).impulse,
        lambda of, conditions: percuss.contact_law.damp_contact(of, contact, damping, conditions).effective_mass,
        lambda of, conditions: percuss.safe_speed(of, contact, None, conditions, energy=1.0).reflected.speed,
        lambda of, conditions: percuss.reports.map_point(of, contact, 20, conditions).principal[0].effective_mass,
        lambda of, conditions: percuss.reports.reflected_inertias(of, ["crank_hinge"], conditions).reflected_inertia[0].free,
        lambda of, conditions: percuss.study.compare([percuss.study.Design(n, of, contact, conditions) for n in "ab"]).designs[0].effective_mass,
    ]
    for number, call in enumerate(calls):
        expected = call(bar, given)
        assert call(pose, None) == pytest.approx(expected, rel=1e-11), number
        assert call(system, percuss.Conditions(set=set)) == call(system.assemble(), percuss.Conditions(pose=pose)) == pytest.approx(expected), number
    swept = percuss.reports.sweep_report(system, contact, vary=("crank_hinge", 0.4, 0.4, 1))
    assert swept.rows[0].effective_mass == pytest.approx(calls[0](bar, given), rel=1e-11)
    refused: list[tuple[Any, percuss.Conditions | None]] = [
        (system, percuss.Conditions(armature={"crank_hinge": 0.1})),
        (pose, percuss.Conditions(pose=pose)),
        (bar.system(base="floating"), percuss.Conditions(base="fixed")),
        (system, percuss.Conditions(base="floating")),
    ]
    for of, conditions in refused:
        with pytest.raises(percuss.InputError):
            percuss.mass(of, contact, conditions)
    assert percuss.mass(system, contact, percuss.Conditions(base="fixed")).conditions.base == "fixed"
    # A pose of another file has the finding of a saved pose of another file; the same file, read again, has none.
    other = percuss.loads((ROOT / "models/four_bar.urdf").read_text() + "\n")
    for model, expected in [(other, 1), (percuss.load(ROOT / "models/four_bar.urdf"), 0)]:
        report = percuss.mass(model, contact, percuss.Conditions(pose=pose))
        assert [finding.code for finding in report.diagnostics].count("pose-of-another-file") == expected


def test_names_of_contacts_in_arrays() -> None:
    car = percuss.suspension.load(ROOT / "models/suspensions/double-wishbone.toml")
    pose = car.pose()
    for name in car.contacts:
        contact = car.contact(name)
        mass = pose.respond(contact).effective_mass
        assert pose.respond(name).effective_mass == mass
        assert percuss.sweep(car, name, pose.positions[None, :]).effective_mass[0] == pytest.approx(mass, rel=1e-9)
        assert car.assemble().workspace(name).effective_mass(pose.positions) == pytest.approx(mass, rel=1e-9)
        assert np.array_equal(pose.contact_row(name), pose.contact_row(contact))
    arm = percuss.load(ROOT / "models/six_r_arm.urdf")
    stop = arm.pose().respond("elbow:upper")
    assert stop.unit == "kg·m²" and stop.effective_mass == arm.pose().respond(arm.contact("elbow:upper")).effective_mass
    first, second = percuss.Contact("tool", [0.08, 0, 0], [0, 1, 0], normal_frame="world"), "tool:0,0.05,0:0,0,1"
    further = percuss.Contact("tool", [0, 0.05, 0], [0, 0, 1], normal_frame="world")
    hits = [percuss.impact(arm, first, 0.3, speed=1.0, also=[also]).to_dict() for also in (second, further)]
    assert hits[0] == hits[1]
    for wrong, words in [("bumpstop", "bump_stop"), (7, "a Contact")]:
        with pytest.raises(percuss.InputError, match=words):
            pose.respond(wrong)  # type: ignore[arg-type]


def test_travels_poses_and_motion_ratios(tmp_path: Path) -> None:
    model = percuss.load(ROOT / MODEL)
    travel, ratio = ("wheel_centre:0,0,0:0,0,1=20mm", "spindle:0.01,0,0:0,0,1")
    expected = printed("mass", MODEL, *FLAGS, "--lock", "spin", "--travel", travel, "--ratio-at", ratio, "--format", "json")
    by_text = percuss.Conditions(lock=["spin"], travel=[travel], ratio_at=[("spindle", [0.01, 0, 0])])
    in_si = percuss.Conditions(
        lock=["spin"],
        travel=[("wheel_centre", [0, 0, 0], [0, 0, 1], 0.02)],
        ratio_at=[("spindle", [0.01, 0, 0], [0, 0, 1])],
    )
    for conditions in (by_text, in_si):
        assert without_paths(percuss.mass(model, SEAT, conditions)) == without_paths(expected)
    assert percuss.mass(model, SEAT, in_si).motion_ratios != percuss.mass(model, SEAT, percuss.Conditions(lock=["spin"])).motion_ratios
    pose = tmp_path / "pose.json"
    pose.write_text(json.dumps(expected))
    flags = ("--lock", "spin", "--pose", str(pose), "--format", "json")
    at_pose = percuss.mass(model, SEAT, percuss.Conditions(lock=["spin"], pose=pose))
    assert without_paths(at_pose) == without_paths(printed("mass", MODEL, *FLAGS, *flags))
    assert at_pose.effective_mass == pytest.approx(expected["effective_mass"], rel=1e-9)
    four_bar = percuss.load(ROOT / "models/four_bar.urdf")
    contact = percuss.Contact("coupler", [0.35, 0.1, 0], [0, 1, 0])
    (tmp_path / "none.json").write_text("{}")
    for given, words in [
        (percuss.Conditions(travel=["coupler=1mm"]), "LINK:X,Y,Z"),
        (percuss.Conditions(travel=[("nope", [0, 0, 0], [0, 0, 1], 0.001)]), "nope"),
        (percuss.Conditions(travel=[("coupler", [0, 0, 0], [0, 0, 0], 0.001)]), "no length"),
        (percuss.Conditions(travel=[("coupler", [0, 0, 0], [0, 0, 1], float("nan"))]), "travel: .*nan"),
        (percuss.Conditions(travel=[("coupler", [0, 0, 0])]), "link, point, direction, distance"),  # type: ignore[list-item]
        (percuss.Conditions(pose=tmp_path / "missing.json"), "missing.json"),
        (percuss.Conditions(pose=tmp_path / "none.json"), "pose: .*names no joint"),
        (percuss.Conditions(ratio_at=[("coupler",)]), "ratio_at: expected"),
        (percuss.Conditions(ratio_at=[("nope", [0, 0, 0])]), "nope"),
    ]:
        with pytest.raises(percuss.InputError, match=words):
            percuss.mass(four_bar, contact, given)


def test_sweeps_of_ranges_files_and_random_rows(tmp_path) -> None:  # type: ignore[no-untyped-def]
    model = percuss.load(ROOT / "models/four_bar.urdf")
    contact = percuss.Contact("coupler", [0.35, 0.1, 0], [0, 1, 0])
    by_text = percuss.reports.sweep_report(model, contact, vary="crank_hinge=0:30deg:7")
    by_numbers = percuss.reports.sweep_report(model, contact, vary=[("crank_hinge", 0.0, np.pi / 6, 7)])
    assert by_text.rows == by_numbers.rows and len(by_text.rows) == 7
    table = tmp_path / "angles.csv"
    table.write_text("crank_hinge [deg],other\n" + "".join(f"{5 * i},x\n" for i in range(7)))
    by_file = percuss.reports.sweep_report(model, contact, input=table, ignore=["other"])
    masses = [row["effective_mass"] for row in by_text.rows]
    assert [row["effective_mass"] for row in by_file.rows] == pytest.approx(masses, rel=1e-9)
    arm = percuss.load(ROOT / "models/six_r_arm.urdf")
    tool = percuss.Contact("tool", [0.08, 0, 0], [0, 1, 0])
    random = percuss.reports.sweep_report(arm, tool, random=5, seed=3)
    again = percuss.reports.sweep_report(arm, tool, random=5, seed=3)
    assert random.rows == again.rows and random.seed == 3
    q = [[row["pose"][joint.name][0] for joint in arm.joints if joint.kind != "fixed"] for row in random.rows]
    assert percuss.sweep(arm, tool, q).effective_mass == pytest.approx([row["effective_mass"] for row in random.rows])
    with pytest.raises(percuss.InputError, match="one of vary, input and random"):
        percuss.reports.sweep_report(model, contact)
    with pytest.raises(percuss.InputError, match="COUNT"):
        percuss.reports.sweep_report(model, contact, vary="crank_hinge=0:1")
    with pytest.raises(percuss.InputError, match="crank_hinge"):
        percuss.reports.sweep_report(model, contact, vary="crank=0:1:3")


def test_maps() -> None:
    model = percuss.load(ROOT / "models/shaped_arm.urdf")
    report = percuss.map(model)
    expected = printed("map", "models/shaped_arm.urdf", "--all", "--format", "json")
    assert without_paths(report) == without_paths(expected)
    assert set(report.facets) == {link["link"] for link in report.links}
    for link in report.links:
        facets = report.facets[link["link"]]
        assert facets["points"].shape == facets["normals"].shape == (link["contacts"], 3)
        assert (facets["status"] == percuss.Status.FINITE).sum() == link["finite"]
        assert facets["area"].sum() == pytest.approx(link["area"])
        finite = facets["effective_mass"][facets["status"] == percuss.Status.FINITE]
        if link["smallest"]:
            assert finite.min() == link["smallest"]["effective_mass"]
    assert "<svg" in report._repr_html_() and report.to_svg().startswith("<svg")
    at = percuss.reports.map_point(model, percuss.Contact("finger", [0.1, 0, 0], [0, 1, 0]), 50)
    assert len(at.directions) == 50 and len(at.principal) <= 3
    with pytest.raises(percuss.InputError, match="visual"):
        percuss.map(model, shapes="round")  # type: ignore[arg-type]


def test_dampers() -> None:
    damping = percuss.contact_law.Damping(0.5, 1e5, speed=0.4)
    # The command assumes a body without loops for a mass alone.
    report = percuss.contact_law.damp(2.281, percuss.contact_law.Damping(0.5, 1e5, speed=0.4, tools=["all"], closed_loops=False))
    assert percuss.contact_law.damp(2.281, damping).exports == {}
    assert without_paths(report) == without_paths(
        printed("damp", "--mass", "2.281", "--stiffness", "1e5", "--restitution", "0.5", "--speed", "0.4", "--format", "json")
    )
    history = percuss.contact_law.impact_history(2.281, damping, 400)
    assert history.shape == (400, 4) and history[0, 1] == 0
    assert history[-1, 2] == pytest.approx(-0.2, rel=1e-6)
    model = percuss.load(ROOT / MODEL)
    assert percuss.contact_law.damp_contact(model, SEAT, damping).effective_mass == pytest.approx(517.26528028793)
    arm = percuss.load(ROOT / "models/six_r_arm.urdf")
    joint = arm.joints[0].name
    stop = percuss.contact_law.damp_stop(arm, joint, damping, percuss.Conditions(set={joint: "10deg"}))
    assert stop.stop == {"joint": joint, "motion": "turn"}
    names = [law[0] for law in percuss.contact_law.laws()]
    assert "kelvin-voigt" in names and len(names) == 15
    assert len(percuss.contact_law.tools()) > 10 and percuss.reports.regions()
    for wrong, words in [
        (percuss.contact_law.Damping(1.5, 1e5), "restitution"),
        (percuss.contact_law.Damping(0.5, -1.0), "stiffness"),
        (percuss.contact_law.Damping(0.5, 1e5, law="none"), "none"),
        (percuss.contact_law.Damping(0.5, 1e5, tools=["none"]), "none"),
    ]:
        with pytest.raises(percuss.InputError, match=words):
            percuss.contact_law.damp(1.0, wrong)
    with pytest.raises(percuss.errors.ArgumentTypeError, match=r"Damping.separation is 'late' \(str\); expected 'force' or 'gap'"):
        percuss.contact_law.Damping(0.5, 1e5, separation="late")  # type: ignore[arg-type]


def test_safe_speeds() -> None:
    model, contact = percuss.load(ROOT / "models/six_r_arm.urdf"), percuss.Contact("tool", [0.08, 0, 0], [0, 1, 0])
    region = percuss.reports.regions()[0][0]
    report = percuss.safe_speed(model, contact, region, force=140.0)
    flags = ("--link", "tool", "--point", "0.08,0,0", "--normal", "0,1,0", "--region", region, "--force", "140")
    assert without_paths(report) == without_paths(
        printed("safe-speed", "models/six_r_arm.urdf", *flags, "--format", "json")
    )
    by_pressure = percuss.safe_speed(model, contact, region, pressure=1.4e6, area=1e-4)
    assert by_pressure.reflected["speed"] == pytest.approx(report.reflected["speed"])
    for given, words in (({}, "given: none"), ({"force": 1.0, "energy": 1.0}, "given: force and energy"), ({"area": 1e-4}, "given: area")):
        with pytest.raises(percuss.InputError, match=words):
            percuss.safe_speed(model, contact, region, **given)  # type: ignore[call-overload]
    with pytest.raises(percuss.InputError, match="directions: none"):
        percuss.reports.safe_speed_directions(model, contact, region, [], force=1.0)
    with pytest.raises(percuss.InputError, match="nose"):
        percuss.safe_speed(model, contact, "nose", force=1.0)


def test_impacts() -> None:
    model = percuss.load(ROOT / "models/four_bar.urdf")
    contact = percuss.Contact("coupler", [0.35, 0.1, 0], [0, 1, 0])
    report = percuss.impact(model, contact, 0.3, rates={"crank_hinge": "-120deg/s"}, reflected=["crank_hinge"])
    flags = ("--link", "coupler", "--point", "0.35,0.1,0", "--normal", "0,1,0", "--restitution", "0.3")
    more = ("--rates", "crank_hinge=-120deg/s", "--reflected", "crank_hinge", "--format", "json")
    assert without_paths(report) == without_paths(printed("impact", "models/four_bar.urdf", *flags, *more))
    hinge = report.reactions[0]
    assert hinge["name"] == "crank_hinge" and hinge["force"][2] is None and hinge["open_by"] == ["rocker_pin"]
    # The rates of 52163/110250 kg·m² at the crank (models/four_bar.urdf).
    assert report.reflected_inertia[0]["free"] == pytest.approx(52163 / 110250, rel=1e-12)
    peaks = percuss.impact(model, contact, 0.3, speed=1.0, stiffness=1e5)
    assert peaks.contact_law is not None and peaks.contact_law.peak_force > 0 and peaks.reactions[0]["peak_force"][0] is not None
    friction = percuss.impact(model, contact, 0.3, speed=1.0, friction=0.2, restitution_law="poisson").friction
    assert friction is not None and friction["law"] == "poisson" and len(friction["laws"]) == 4
    with pytest.raises(percuss.InputError, match="restitution_law"):
        percuss.impact(model, contact, 0.3, speed=1.0, friction=0.2, restitution_law="kane")  # type: ignore[call-overload]
    also = ["coupler:0.1,0.1,0:0,1,0"]
    several = percuss.impact(model, contact, 0.3, speed=1.0, also=also, sticking=True).simultaneous
    assert several is not None and [law["law"] for law in several["laws"]] == ["newton", "poisson", "energetic"]
    assert len(several["delassus"]) == 6 and len(several["sticking"]["sticks"]) == 2
    with pytest.raises(percuss.InputError, match="closing speed"):
        percuss.impact(model, contact, 0.3)
    with pytest.raises(percuss.InputError, match="nope"):
        percuss.impact(model, contact, 0.3, rates={"nope": 1.0})
    with pytest.raises(percuss.InputError, match="closing speed"):
        percuss.impact(model, contact, 0.3, speed=-1.0)


def test_extremes() -> None:
    model = percuss.load(ROOT / "models/planar_2r.urdf")
    contact = percuss.Contact("outer", [0.4, 0, 0], [0, 1, 0])
    report = percuss.extremes(model, contact, ranges={"elbow": (0.3, 2.5)})
    assert report.least["effective_mass"] < report.most["effective_mass"]
    assert report.least["residual"] < 1e-6 and report.least["agreeing"] > 1
    wide = percuss.extremes(model, contact, ranges={"elbow": (0.3, 2.5)}, starts=5)
    assert wide.least["effective_mass"] == pytest.approx(report.least["effective_mass"], rel=1e-9)
    with pytest.raises(percuss.InputError, match="nope"):
        percuss.extremes(model, contact, ranges={"nope": (0.0, 1.0)})
    # The tip keeps its height; the path has the positions of a sweep.
    ranges = {"shoulder": (-3.0, 3.0), "elbow": (0.3, 2.5)}
    bent = percuss.Conditions(set={"elbow": 1.0})
    kept = percuss.extremes(model, contact, bent, ranges=ranges, keep=["outer:0.4,0,0:0,1,0"])
    assert kept.kept[0]["link"] == "outer" and kept.most["kept_error"] < 1e-9
    path = percuss.extremes(model, contact, vary=("elbow", 0.3, 2.5, 5))
    assert path.ranges == [] and path.path is not None and path.path["rows"] == 5
    assert path.least["effective_mass"] == pytest.approx(report.least["effective_mass"], rel=1e-9)
    assert path.most["effective_mass"] == pytest.approx(report.most["effective_mass"], rel=1e-9)
    law = percuss.contact_law.Damping(0.3, 2e5, speed=2.0)
    peak = percuss.extremes(model, contact, ranges={"elbow": (0.3, 2.5)}, quantity="peak:ground", contact_law=law)
    assert peak.unit == "N" and 0.0 < peak.least["value"] < peak.most["value"]
    with pytest.raises(percuss.InputError, match="contact law"):
        percuss.extremes(model, contact, ranges={"elbow": (0.3, 2.5)}, quantity="peak:ground")
    with pytest.raises(percuss.InputError, match="neither range nor keep"):
        percuss.extremes(model, contact, ranges=ranges, vary=("elbow", 0.3, 2.5, 5))


@pytest.mark.parametrize("path", sorted((ROOT / "models").glob("*.toml")), ids=lambda path: path.stem)
def test_studies(path) -> None:  # type: ignore[no-untyped-def]
    report = percuss.study.run(path)
    if report.schema.startswith("percuss.sweep"):
        assert len(report.rows) > 1 and any(row["status"] == "finite" for row in report.rows)
        assert "rows" in repr(report)
    else:
        expected = printed("run", str(path.relative_to(ROOT)), "--format", "json")
        assert report.effective_mass == expected["effective_mass"]
    assert "<table>" in report._repr_html_()
    assert report.schema == report["schema"]
    with pytest.raises(AttributeError, match="no 'nothing'"):
        report.nothing


SHEETS = sorted((ROOT / "models/suspensions").glob("*.toml"))


@pytest.mark.parametrize("path", SHEETS, ids=lambda path: path.stem)
def test_suspension_sheets(path, tmp_path) -> None:  # type: ignore[no-untyped-def]
    import warnings

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", percuss.ModelWarning)
        model = percuss.suspension.load(path)
    urdf = tmp_path / "out.urdf"
    ran = command("import", str(path), "-o", str(urdf))
    assert ran.returncode == 0, ran.stderr
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", percuss.ModelWarning)
        written = percuss.load(urdf)
    assert written.links == model.links and written.total_mass == pytest.approx(model.total_mass)
    seats = [link for link in model.links if link.startswith("spring_seat")]
    for seat in seats:
        contact = percuss.Contact(seat, [0, 0, 0], [0, 0, 1])
        here, there = (m.pose().respond(contact) for m in (model, written))
        assert here.status == there.status
        if here.effective_mass is not None:
            assert there.effective_mass == pytest.approx(here.effective_mass, rel=1e-9)


def test_a_table_of_points_is_in_the_folder_of_its_sheet(tmp_path: Path) -> None:
    folder = ROOT / "models/suspensions"
    (tmp_path / "sheets").mkdir()
    (tmp_path / "points.xlsx").write_bytes((folder / "double-wishbone-points.xlsx").read_bytes())
    text = (folder / "double-wishbone-with-table.toml").read_text()
    sheet = tmp_path / "sheets/my.toml"
    sheet.write_text(text.replace("double-wishbone-points.xlsx", "../points.xlsx"))
    with pytest.raises(percuss.LoadError, match="allow_outside"):
        percuss.suspension.load(sheet)
    assert "upright" in percuss.suspension.load(sheet, allow_outside=True).links
    with pytest.raises(percuss.LoadError, match="nowhere"):
        percuss.suspension.load(sheet, allow_outside=True, worksheet="nowhere")


def test_suspension_options_and_templates() -> None:
    names = [name for name, _ in percuss.suspension.templates()]
    assert len(SHEETS) >= 10 and "double-wishbone" in names
    assert "double" in percuss.suspension.template("double-wishbone", unit="in", axes="adams").lower()
    with pytest.raises(percuss.InputError, match="did you mean double-wishbone"):
        percuss.suspension.template("double-wishbon")
    path = ROOT / "models/suspensions/double-wishbone.toml"
    both = percuss.suspension.load(path, side="both")
    assert any(link.endswith("_left") for link in both.links) and any(link.endswith("_right") for link in both.links)
    steered = percuss.suspension.load(path, rack_mass=3.0, wheel=(20.0, (0.5, 0.9, 0.5), 0.3))
    rack = next(joint for joint in steered.joints if joint.name == "rack")
    assert rack.kind == "prismatic" and "contact_patch" in steered.links
    with pytest.raises(percuss.InputError, match="side"):
        percuss.suspension.load(path, side="front")
    with pytest.raises(percuss.LoadError, match="none.toml"):
        percuss.suspension.load("none.toml")


def test_a_study_to_begin_with(tmp_path: Path) -> None:
    path = ROOT / "models/four_bar.urdf"
    text = percuss.study.starting(percuss.load(path), path)
    ran = command("init", str(path))
    assert ran.returncode == 0 and text == ran.stdout
    (tmp_path / "study.toml").write_text(text)
    report = percuss.study.run(tmp_path / "study.toml")
    assert report.effective_mass > 0
    assert percuss.study.schema() == printed("schema") and "safe_speed" in percuss.study.schema()["properties"]


def test_kinematics_are_those_of_the_command_and_of_the_motion_ratio() -> None:
    model = percuss.suspension.load(ROOT / "models/suspensions/double-wishbone.toml")
    travels = [-0.04, 0.0, 0.04]
    found = percuss.suspension.kinematics(model, wheel_travel=travels)
    assert found.variable == "wheel-travel" and len(found) == 3 and found.problems == [None] * 3
    assert found.positions == pytest.approx(travels, abs=1e-15)
    single = percuss.suspension.kinematics(model)
    assert len(single) == 1
    for name, column in found.values.items():
        assert column.shape == (3,)
        # The middle row is the design position.
        assert column[1] == pytest.approx(single[name][0], rel=1e-9, abs=1e-12, nan_ok=True), name
        assert name in found.units
    with pytest.raises(KeyError, match="there are"):
        found["cambre"]
    with pytest.raises(percuss.PercussError):
        percuss.suspension.kinematics(percuss.load(ROOT / "models/four_bar.urdf"))


def test_kinematics_need_no_masses(tmp_path: Path) -> None:
    text = (ROOT / "models/suspensions/double-wishbone.toml").read_text()
    sheet = tmp_path / "light.toml"
    sheet.write_text("\n".join(line for line in text.splitlines() if not line.startswith(("mass", "com", "inertia"))))
    whole = percuss.suspension.kinematics(percuss.suspension.load(ROOT / "models/suspensions/double-wishbone.toml"), heave=[-0.02, 0.03])
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", percuss.ModelWarning)
        light = percuss.suspension.kinematics(sheet, heave=[-0.02, 0.03])
    assert "unsprung_mass" in light.missing
    for name, values in whole.values.items():
        if name not in light.missing:
            assert light[name] == pytest.approx(values, rel=1e-9, abs=1e-9, nan_ok=True), name


def test_gradients_of_sweeps() -> None:
    """By joint, as the arrays of a sweep; over a linkage, the difference of neighbouring rows."""
    arm, tool = percuss.load(ROOT / "models/six_r_arm.urdf"), percuss.Contact("tool", [0.08, 0, 0], [0, 1, 0])
    rows = percuss.reports.sweep_report(arm, tool, random=50, gradient=True).rows
    q = np.array([[row.pose[name][0] for name in arm.position_names] for row in rows])
    expected = percuss.sweep(arm, tool, q, gradient=True).gradient
    found = np.array([[(row.gradient or {})[name][0] for name in arm.velocity_names] for row in rows])
    assert expected is not None and np.allclose(found, expected, rtol=1e-12, atol=0)
    assert "gradient" not in percuss.reports.sweep_report(arm, tool, random=1).rows[0]
    bar, contact, step = percuss.load(ROOT / "models/four_bar.urdf"), percuss.Contact("coupler", [0.35, 0.1, 0], [0, 1, 0]), 1e-3
    low, at, high = percuss.reports.sweep_report(bar, contact, vary=("crank_hinge", 0.2 - step, 0.2 + step, 3), gradient=True).rows
    assert low.effective_mass is not None and high.effective_mass is not None
    slope = (high.effective_mass - low.effective_mass) / (2 * step)
    rates = {name: (high.pose[name][0] - low.pose[name][0]) / (2 * step) for name in high.pose}
    # Central differences: step² of the third derivative.
    assert sum((at.gradient or {})[name][0] * rate for name, rate in rates.items()) == pytest.approx(slope, rel=1e-4)


def test_ask_answers_the_tables_of_a_study() -> None:
    model = percuss.load(ROOT / "models/four_bar.urdf")
    contact = percuss.Contact("coupler", [0.35, 0.1, 0.0], [0.0, 1.0, 0.0])
    table = {"link": "coupler", "point": np.array([0.35, 0.1, 0.0]), "normal": [0, 1, 0]}
    found = percuss.study.ask(
        model,
        {
            "contact": table,
            "mass": {"explain": True, "friction_thresholds": True, "tolerance": "mass=2%"},
            "damping": {"restitution": 0.3, "stiffness": "200 N/mm"},
            "impact": {"restitution": 0.3, "speed": "1 m/s"},
            "extremes": {"range": "crank_hinge=0:1"},
            "sweep": {"vary": "crank_hinge=0:0.5:4"},
            "map": {"directions": 20},
            "safe_speed": {"region": "chest", "force": 280},
        },
    )
    damping = percuss.contact_law.Damping(0.3, 2e5)
    assert found["mass"].damper == percuss.mass(model, contact, damping=damping).damper
    assert {**found["mass"].explanation, "diagnostics": found["mass"].diagnostics} == percuss.reports.explain(model, contact)
    assert {**found["mass"].friction_thresholds, "diagnostics": found["mass"].diagnostics} == percuss.reports.friction_thresholds(model, contact)
    assert {**found["mass"].tolerance, "diagnostics": found["mass"].diagnostics} == percuss.reports.tolerate(model, contact, "mass=2%")
    assert found["impact"] == percuss.impact(model, contact, 0.3, speed=1.0)
    assert found["extremes"] == percuss.extremes(model, contact, ranges={"crank_hinge": (0.0, 1.0)})
    assert found["sweep"] == percuss.reports.sweep_report(model, contact, vary=["crank_hinge=0:0.5:4"])
    assert found["map"] == percuss.reports.map_point(model, contact, 20)
    assert found["safe_speed"][0] == percuss.safe_speed(model, contact, "chest", force=280.0)
    wrong: list[tuple[dict[str, Any], str]] = [
        ({"impact": {"restitution": 0.3, "speed": 1, "stiffness": -5}}, "impact.stiffness"),
        ({"extremes": {"speed": 1, "restitution": 0.3, "stiffness": -5, "quantity": "peak:crank_hinge"}}, "extremes.stiffness"),
        ({"sweep": {"vary": "none=0:1:3"}}, "sweep.vary"),
        ({"sweep": {"vary": "crank_hinge=0:1:3", "output": "rows.csv"}}, "sweep.output"),
        ({"safe_speed": {"region": "chest", "force": -1}}, "safe_speed.force"),
        ({"impakt": {}}, "impakt"),
        ({"pose": {"set": {"crank_hinge": None}}}, "pose.set.crank_hinge"),
    ]
    for tables, key in wrong:
        with pytest.raises(percuss.InputError, match=key.replace(".", r"\.")):
            percuss.study.ask(model, {"contact": table, **tables})
