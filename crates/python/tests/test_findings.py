"""Every finding at every output: each finding is raised by a small model, and appears in the response of a pose and in the sweep, whose remarks
have its flag."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

import percuss
from percuss import RemarkFlags as Flags

BODY = '<inertial><mass value="2"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'


#: Four-bar of which all links lie on one line with all joints at 0: branches cross.
FLAT = f"""<robot name="flat"><link name="ground"/><link name="crank">{BODY}</link><link name="coupler">{BODY}</link>
    <link name="rocker">{BODY}</link><joint name="crank_hinge" type="continuous" independent="true"><parent link="ground"/>
    <child link="crank"/><axis xyz="0 0 1"/></joint>
    <joint name="pin" type="continuous"><parent link="crank"/><child link="coupler"/><origin xyz="0.5 0 0"/><axis xyz="0 0 1"/></joint>
    <joint name="rocker_hinge" type="continuous"><parent link="ground"/><child link="rocker"/><origin xyz="1 0 0"/>
    <axis xyz="0 0 1"/></joint><loop name="end" type="revolute"><predecessor link="coupler"><origin xyz="1 0 0"/></predecessor>
    <successor link="rocker"><origin xyz="0.5 0 0"/></successor><axis xyz="0 0 1"/></loop></robot>"""


def chain(rod: str = BODY, tip: str = BODY) -> str:
    """A link on a slide within -1 and 1, and a link on a hinge within -1 and 1; a stop 0.5 in front of the link on the slide."""
    limit = '<limit lower="-1" upper="1" effort="1" velocity="1"/>'
    return f"""<robot name="chain"><link name="ground"/><link name="rod">{rod}</link><link name="tip">{tip}</link>
        <joint name="slide" type="prismatic"><parent link="ground"/><child link="rod"/><axis xyz="1 0 0"/>{limit}</joint>
        <joint name="turn" type="revolute"><parent link="rod"/><child link="tip"/><axis xyz="0 0 1"/>{limit}</joint>
        <contact name="buffer" type="stop"><body link="rod" xyz="0 0 0"/><other link="ground"/><normal xyz="1 0 0"/>
        <gap value="0.5"/></contact></robot>"""


ALONG, ACROSS = [1.0, 0.0, 0.0], [1e-7, 1.0, 0.0]
STOP = percuss.Contact("rod", [0, 0, 0], ALONG, against="ground", normal_frame="against")
OTHER = percuss.Contact("rod", [0, 0, 0], ALONG)
#: Code of the finding at a pose, flag, model, contact, positions of the slide and the hinge.
CASES = {
    "outside-limits": (Flags.OUTSIDE_LIMITS, chain(), OTHER, [2.0, 0.0]),
    "many-turns": (Flags.OUTSIDE_LIMITS | Flags.MANY_TURNS, chain(), OTHER, [0.0, 90.0]),
    "open-gap": (Flags.OPEN_GAP, chain(), STOP, [0.1, 0.0]),
    "nearly-immovable": (Flags.NEARLY_IMMOVABLE, chain(), percuss.Contact("rod", [0, 0, 0], ACROSS), [0.1, 0.0]),
    "massless-motions": (Flags.MASSLESS_MOTIONS | Flags.UNDETERMINED_MOTION, chain(tip=""), OTHER, [0.1, 0.2]),
    "singular-pose": (Flags.SINGULAR_POSE, FLAT, percuss.Contact("coupler", [0.3, 0, 0], [0, 1, 0]), [0.0, 0.0, 0.0]),
}


@pytest.mark.parametrize("code", CASES)
def test_a_finding_is_in_the_pose_and_in_the_sweep(code: str) -> None:
    flag, text, contact, q = CASES[code]
    model = percuss.loads(text)
    response = model.pose(q).respond(contact)
    at_pose = {finding.code: finding.message for finding in response.findings}
    # At a pose, the finding of the limits contains the hint of degrees.
    assert ("outside-limits" if code == "many-turns" else code) in at_pose
    assert code != "many-turns" or "for degrees write 90deg" in at_pose["outside-limits"]
    driving = ["crank_hinge"] if text == FLAT else ["slide", "turn"]
    rows = np.array([q, q])
    for swept in (percuss.sweep(model, contact, rows), percuss.sweep(model, contact, rows[:, : len(driving)], joints=driving)):
        assert all(bits & flag == flag for bits in swept.remarks.tolist()), [Flags(bits) for bits in swept.remarks.tolist()]
        assert code in {finding.code for finding in swept.findings}


def test_a_stop_at_its_touch_and_other_contacts_have_no_open_gap() -> None:
    model = percuss.loads(chain())
    q = np.array([[0.5, 0.0], [0.6, 0.0]])
    assert not percuss.sweep(model, STOP, q).remarks.any()
    assert not percuss.sweep(model, OTHER, np.array([[0.1, 0.3]])).remarks.any()


#: Reports that do not show the estimate and the motion ratios of the conditions, as calls with conditions.
REPORTS: dict[str, Callable[[percuss.Model, percuss.Conditions], object]] = {
    "map_point": lambda model, given: percuss.reports.map_point(model, OTHER, 3, given),
    "explain": lambda model, given: percuss.reports.explain(model, OTHER, given),
    "friction_thresholds": lambda model, given: percuss.reports.friction_thresholds(model, OTHER, given),
    "tolerate": lambda model, given: percuss.reports.tolerate(model, OTHER, "mass=2%", given),
    "reflected_inertias": lambda model, given: percuss.reports.reflected_inertias(model, ["slide"], given),
    "extremes": lambda model, given: percuss.extremes(model, OTHER, given, starts=2),
    "safe_speed": lambda model, given: percuss.safe_speed(model, OTHER, None, given, energy=1.0),
    "damp_contact": lambda model, given: percuss.contact_law.damp_contact(model, OTHER, percuss.contact_law.Damping(0.5, 1e4, speed=1.0), given),
    "damp_stop": lambda model, given: percuss.contact_law.damp_stop(
        model, "slide", percuss.contact_law.Damping(0.5, 1e4, speed=1.0), given, end="upper"
    ),
}
IGNORED = {"estimate": percuss.Conditions(estimate=(["rod"],)), "ratio_at": percuss.Conditions(ratio_at=[("rod", [0, 0, 0])])}


@pytest.mark.parametrize("name", REPORTS)
def test_conditions_without_influence_are_refused(name: str) -> None:
    model = percuss.loads(chain())
    assert REPORTS[name](model, percuss.Conditions()) is not None
    for key, given in IGNORED.items():
        with pytest.raises(percuss.InputError, match=f"conditions.{key}: it has no influence"):
            REPORTS[name](model, given)
    with pytest.raises(percuss.InputError, match="conditions.ratio_at: it has no influence"):
        percuss.reports.sweep_report(model, OTHER, IGNORED["ratio_at"], vary="slide=0:1:2")
    given = percuss.Conditions(estimate=(["rod"],), ratio_at=[("rod", [0, 0, 0])])
    assert percuss.mass(model, OTHER, given).motion_ratios and percuss.impact(model, OTHER, 0.5, given, speed=1.0).mass.estimate


def test_parts_of_a_mass_report_have_its_findings() -> None:
    model, given = percuss.loads(chain()), percuss.Conditions(set={"slide": 2.0})
    for part in (
        percuss.reports.explain(model, OTHER, given),
        percuss.reports.friction_thresholds(model, OTHER, given),
        percuss.reports.tolerate(model, OTHER, "mass=2%", given),
    ):
        assert part is not None
        assert [finding["code"] for finding in part["diagnostics"]] == ["outside-limits"]


def test_fields_of_a_damping_without_influence_are_refused() -> None:
    model = percuss.loads(chain())
    damping = percuss.contact_law.Damping
    for given in (damping(0.5, 1e4, accuracy=0.1), damping(0.5, 1e4, time_step=1e-4), damping(0.5, 1e4, other_own_mass=2.0)):
        # Without a simulator.
        for call in (
            lambda: percuss.contact_law.damp(2.0, given),
            lambda: percuss.contact_law.damp_contact(model, OTHER, given),
            lambda: percuss.mass(model, OTHER, damping=given),
        ):
            with pytest.raises(percuss.InputError, match="it belongs to the parameters of a simulator"):
                call()
    with pytest.raises(percuss.InputError, match="damping.own_mass: it has no influence"):
        percuss.contact_law.damp_stop(model, "slide", damping(0.5, 1e4, own_mass=2.0), end="upper")
    with pytest.raises(percuss.InputError, match="damping.tools: it has no influence"):
        percuss.contact_law.impact_history(2.0, damping(0.5, 1e4, speed=1.0, tools=["mujoco"]))
    with pytest.raises(percuss.InputError, match="damping.accuracy: it has no influence"):
        peak = damping(0.5, 1e4, speed=1.0, accuracy=0.1)
        percuss.extremes(model, OTHER, starts=2, quantity="peak:slide", contact_law=peak)
