"""Every finding at every output: each finding is raised by a small model, and appears in the response of a pose and in the sweep, whose remarks
have its flag."""

from __future__ import annotations

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
