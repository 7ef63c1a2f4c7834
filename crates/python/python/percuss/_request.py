"""Questions as the tables of a study (docs/reference/STUDY_KEYS.md), JSON."""

from __future__ import annotations

import functools
import json
import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Concatenate, Literal, ParamSpec, Protocol, TypeVar, Union, cast, overload

import numpy as np

from ._arguments import array_of, check_fields, checked, shown
from ._percuss import Assembly, Contact, Model, Pose, System
from .errors import InputError
from .state import State, velocity_ranges

#: Position of a joint: a number (rad, m), several numbers, or text with a unit: "30deg", "12mm".
Position = Union[float, Sequence[float], str]
#: Mechanism of a report: a model, a system or an assembly with its conditions, a pose with those and its positions, or a state with its
#: model and positions.
Of = Union[Model, System, Assembly, Pose, State]
#: Range of a sweep: text in command-line syntax, or (joint, from, to, count) in SI.
Range = Union[str, tuple[str, float, float, int]]
#: Travel of a point: text in command-line syntax, or (link, point, direction, distance) in SI.
Travel = Union[str, tuple[str, Sequence[float], Sequence[float], float]]
#: Tables as JSON, contact and pose.
Request = tuple[str, Union[Contact, str, None], Union[Pose, None]]
#: Contacts and names of contacts.
Contacts = Union[list[Any], tuple[Any, ...]]
_Further = ParamSpec("_Further")
_Report = TypeVar("_Report")


class ContactQuestion(Protocol[_Further, _Report]):
    """Question about a contact, or about each contact of a list."""

    @overload
    def __call__(self, model: Of, contact: Contact | str, *args: _Further.args, **kwargs: _Further.kwargs) -> _Report: ...
    @overload
    def __call__(self, model: Of, contact: Contacts, *args: _Further.args, **kwargs: _Further.kwargs) -> list[_Report]: ...


def of_contacts(function: Callable[Concatenate[Of, Contact | str, _Further], _Report]) -> ContactQuestion[_Further, _Report]:
    """Question with checked arguments; for a list of contacts, the list of its reports."""
    one = checked(function)

    @functools.wraps(function)
    def call(*args: Any, **kwargs: Any) -> Any:
        given = args[1] if len(args) > 1 else kwargs.get("contact")
        if not isinstance(given, (list, tuple)):
            return one(*args, **kwargs)
        if not given:
            raise InputError("contact is an empty list; expected a Contact, a name, or a list of them")
        if len(args) > 1:
            return [one(args[0], contact, *args[2:], **kwargs) for contact in given]
        return [one(*args, **{**kwargs, "contact": contact}) for contact in given]

    return cast("ContactQuestion[_Further, _Report]", call)


@dataclass(frozen=True)
class Conditions:
    """Conditions of a contact: the flags of ``percuss mass``.

    frame: frame of the contact point: "link", "world", "against".
    against_mass: mass of a free body on the other side, kg.
    set: driving joints and their positions. guess: initial positions in the search for dependent joints.
    travel: moves of points from the pose of set, as text "LINK:X,Y,Z:DX,DY,DZ=DISTANCE" or (link, point, direction,
    distance): point in m in the link's frame, direction in world axes, distance in m.
    pose: JSON file with the positions of all joints, such as a saved report, or a Pose; set and guess take precedence. Its base_pose is that
    of the report, and its normals, directions and gravity have axes of the world.
    lock: names of joints that are locked, one name, or "all". hold: points that are held: (link, point) or (link, point, normal).
    armature: joints and the inertia of their rotors, kg·m² or kg. base: "fixed" or "floating"; default: that of the System, or "fixed".
    estimate: adds the classical estimate to the result: (links,), (links, point) or (links, point, direction); other reports than mass,
    impact and sweep_report refuse it. ratio_at: adds motion ratios at points to the result of mass and impact: (link, point) or (link,
    point, direction), default upwards.
    gear_stiffness: joints and the stiffness of their gears between rotor and joint, N·m/rad or N/m, or stiffness and damping.

        >>> percuss.mass(arm, tool, percuss.Conditions(set={"elbow": "30deg"}, lock=["yaw"])).effective_mass
    """

    frame: Literal["link", "world", "against"] = "link"
    against_mass: float | None = None
    set: Mapping[str, Position] = field(default_factory=dict)
    guess: Mapping[str, Position] = field(default_factory=dict)
    lock: str | Sequence[str] = ()
    hold: Sequence[Sequence[Any]] = ()
    armature: Mapping[str, float | Sequence[float]] = field(default_factory=dict)
    base: Literal["fixed", "floating"] | None = None
    estimate: Sequence[Any] | None = None
    travel: Sequence[Travel] = ()
    pose: str | os.PathLike[str] | Pose | None = None
    ratio_at: Sequence[Sequence[Any]] = ()
    gear_stiffness: Mapping[str, Position] = field(default_factory=dict)

    def __post_init__(self) -> None:
        check_fields(self)


@dataclass(frozen=True)
class Damping:
    """Damper to design: the flags of ``percuss damp``.

    restitution: e, 0 to 1. stiffness: k, N/m^exponent (N·m/rad for the stop of a revolute joint); default: the force curve
    of the stop in a suspension sheet. exponent: p of the spring's force k x^p, default 1 unless the law has another exponent.
    stiffness_curve: force curve in place of a stiffness, {"deflections": m, increasing from 0, "forces": N}, or {"coefficients": N/m^p, "exponents": p, "to": m}. speed: approach
    speed, m/s. law: a name of laws(), default "kelvin-voigt", on a force curve "hunt-crossley". separation: "force" (the contact ends when the force vanishes) or "gap". tools: simulators whose parameters
    are computed, names of tools(), or ("all",). accuracy: permitted error of a simulator's restitution. time_step: time
    step of the simulator, s. own_mass, other_own_mass: masses of the two bodies alone, kg. diagonal_ratio: MuJoCo's
    diagonal ratio. closed_loops: true if loops bind the contact link. A model supplies this value; for a mass alone,
    None means unknown, and the parameters of MuJoCo's equality constraints are given too. accuracy, time_step, other_own_mass and
    diagonal_ratio require tools.

        >>> law = percuss.contact_law.Damping(restitution=0.3, stiffness=2e5, speed=1.0, tools=["mujoco"])
    """

    restitution: float
    stiffness: float | None = None
    exponent: float | None = None
    speed: float | None = None
    law: str | None = None
    separation: Literal["force", "gap"] | None = None
    tools: Sequence[str] = ()
    accuracy: float | None = None
    time_step: float | None = None
    own_mass: float | None = None
    other_own_mass: float | None = None
    diagonal_ratio: float | None = None
    closed_loops: bool | None = None
    stiffness_curve: Mapping[str, Sequence[float] | float] | None = None

    def __post_init__(self) -> None:
        check_fields(self)

    def _refuse(self, *names: str) -> None:
        """Refuses fields without influence on a result."""
        for name in names:
            if getattr(self, name) not in (None, (), []):
                raise InputError(f"damping.{name}: it has no influence on this result; leave it out")

    def _tables(self, stop: str | None = None) -> dict[str, Any]:
        """Tables of the damper, at the stop of a joint if given."""
        keys = {name: value for name, value in vars(self).items() if name not in ("tools", "closed_loops")}
        return {"damping": {**keys, "for": self.tools, "limit": stop}, "closed_loops": self.closed_loops}


#: Fields of Damping for the parameters of simulators, and the masses of the bodies alone.
OF_SIMULATORS = ("tools", "accuracy", "time_step", "own_mass", "other_own_mass", "diagonal_ratio", "closed_loops")


def plain(value: Any) -> Any:
    """Value of another type as numbers, lists and dicts."""
    if isinstance(value, (np.generic, np.ndarray)):
        return value.tolist()
    if isinstance(value, Mapping):
        return dict(value)
    if isinstance(value, Sequence) and not isinstance(value, (bytes, bytearray)):
        return list(value)
    if hasattr(value, "__index__"):
        return int(value)
    if hasattr(value, "__float__"):
        return float(value)
    raise TypeError(f"{type(value).__name__} is given")


def json_of(value: object, name: str) -> str:
    """JSON of a value; an InputError that names it if it has none."""
    try:
        text = json.dumps(value, default=plain, allow_nan=False, ensure_ascii=False)
        text.encode()
    except (TypeError, ValueError, OverflowError, RecursionError) as error:
        message = f"{name} is {shown(value)}; expected finite numbers, texts, lists and tables: {error}"
    else:
        return text
    raise InputError(message.encode("utf-8", "backslashreplace").decode())


def tables(**given: Any) -> str:
    """JSON of tables; tables and keys without a value are left out."""
    parts = []
    for table, keys in given.items():
        if isinstance(keys, dict):
            inner = [f'"{key}":{json_of(value, key)}' for key, value in keys.items() if value is not None]
            parts.append(f'"{table}":{{{",".join(inner)}}}')
        elif keys is not None:
            parts.append(f'"{table}":{json_of(keys, table)}')
    return "{" + ",".join(parts) + "}"


def _parts(given: Any, name: str, keys: Sequence[str], least: int) -> dict[str, Any]:
    """Parts of a tuple by key, without those that are None."""
    if isinstance(given, (str, Mapping)) or not isinstance(given, (Sequence, np.ndarray)) or not least <= len(given) <= len(keys):
        forms = " or ".join(f"({', '.join(keys[:count])}{',' if count == 1 else ''})" for count in range(least, len(keys) + 1))
        raise InputError(f"{name}: expected {forms}")
    return {key: value for key, value in zip(keys, given) if value is not None}


def numbers(value: Any, name: str) -> str:
    """Numbers as text, with all digits."""
    return ",".join(repr(float(number)) for number in array_of(value, name).ravel())


def _travel(given: Any) -> str:
    if isinstance(given, str):
        return given
    parts = _parts(given, "travel", ("link", "point", "direction", "distance"), 4)
    point, direction, distance = (numbers(parts.get(key), f"{key} of travel") for key in ("point", "direction", "distance"))
    return f"{parts.get('link')}:{point}:{direction}={distance}"


def _estimate(given: Any) -> dict[str, Any]:
    parts = _parts(given, "estimate", ("links", "point", "direction"), 1)
    links = parts.get("links")
    return {**parts, "links": [links] if isinstance(links, str) else links}


def _range(given: Any) -> str:
    if isinstance(given, str):
        return given
    joint, start, end, count = _parts(given, "vary", ("joint", "from", "to", "count"), 4).values()
    return f"{joint}={numbers(start, 'vary')}:{numbers(end, 'vary')}:{count}"


def rows(
    vary: Range | Sequence[Range] | None, input: str | os.PathLike[str] | None, ignore: Sequence[str], random: int | None, seed: int
) -> dict[str, Any] | None:
    """Table of the rows; None if no row source is given."""
    if vary is None and input is None and random is None and not len(ignore) and not seed:
        return None
    is_one = isinstance(vary, str) or isinstance(vary, tuple) and len(vary) == 4 and not isinstance(vary[1], (str, tuple))
    ranges = [vary] if is_one else cast("Sequence[Range]", () if vary is None else vary)
    return {
        "vary": [_range(one) for one in ranges],
        "input": None if input is None else os.fspath(input),
        "ignore": ignore,
        "random": random,
        "seed": None if random is None and not seed else seed,
    }


def rates_of(state: State) -> tuple[dict[str, Position], list[float] | None]:
    """Rates of the joints that follow no other joint, and the twist of the root link in axes of the world, of one state."""
    rates: dict[str, Position] = {}
    if state.velocities is not None:
        for joint, at in velocity_ranges(state.model):
            if joint.mimics is None and at.stop > at.start:
                rates[joint.name] = state.velocities[at].tolist()
    return rates, None if state.base_twist is None else state.twist(frame="world").tolist()


def _in_world(pose: Pose, vector: Any) -> Any:
    """Vector in axes of the root link, as System(hold=…) has it, in axes of the world."""
    if vector is None:
        return None
    link = pose.model.links[0]
    axes = pose.link_frame(link, frame="world") @ np.linalg.inv(pose.link_frame(link, frame="root"))
    return (axes[:3, :3] @ array_of(vector, "hold")).tolist()


#: Conditions that belong to a contact or to one report, and the reports that read them.
_OF_SOME = {
    "frame": "a result at a contact point reads it",
    "against_mass": "a result at a contact reads it",
    "estimate": "percuss.mass, percuss.impact and percuss.reports.sweep_report show it",
    "ratio_at": "percuss.mass and percuss.impact show it",
}
#: All of them.
EVERY_CONDITION = tuple(_OF_SOME)


def asked(
    of: Of,
    contact: Contact | str | None,
    conditions: Conditions | None,
    against: str | None = None,
    reads: Sequence[str] = ("frame", "against_mass"),
    **further: Any,
) -> tuple[Model, Request]:
    """Model and request of a report. The conditions of a System, Assembly or Pose are added. reads: conditions of ``_OF_SOME`` that the
    report reads; the others are refused."""
    given = Conditions() if conditions is None else conditions
    for name, readers in _OF_SOME.items():
        value = getattr(given, name)
        is_given = len(value) > 0 if name == "ratio_at" else value not in (None, "link") if name == "frame" else value is not None
        if is_given and name not in reads:
            raise InputError(f"conditions.{name}: it has no influence on this result; {readers}")
    if isinstance(of, State):
        if of.positions.ndim > 1:
            raise InputError(f"model is {of!r}; a report takes one state, such as state[0], and sweep, impacts and safe_speeds take all")
        if given.pose is not None:
            raise InputError("conditions.pose: the State has its own positions; expected the model, or conditions without pose")
        given, of = replace(given, pose=of.model.pose(of)), of.model
    elif not isinstance(of, Model):
        own = of._conditions
        for name in own:
            value = getattr(given, name)
            if value != getattr(Conditions(), name) and (name != "base" or value != own[name]):
                raise InputError(f"conditions.{name}: the {type(of).__name__} has its own; expected the model, or conditions without {name}")
        given = replace(given, **own)
    pose = given.pose if isinstance(given.pose, Pose) else None
    if pose is not None and not isinstance(of, Model):
        given = replace(given, hold=[(*hold[:2], *(_in_world(pose, normal) for normal in hold[2:])) for hold in given.hold])
    of_contact = {
        "frame": None if given.frame == "link" else given.frame,
        "against_mass": given.against_mass,
        "estimate": None if given.estimate is None else _estimate(given.estimate),
        "ratio_at": [_parts(one, "ratio_at", ("link", "point", "direction"), 2) for one in given.ratio_at],
        "against": against,
    }
    text = tables(
        contact=of_contact,
        pose={
            "set": given.set,
            "guess": given.guess,
            "travel": [_travel(one) for one in given.travel],
            "file": None if given.pose is None or isinstance(given.pose, Pose) else os.fspath(given.pose),
        },
        conditions={
            "lock": [given.lock] if isinstance(given.lock, str) else given.lock,
            "armature": given.armature,
            "gear_stiffness": given.gear_stiffness,
            "base": given.base,
        },
        hold=[_parts(one, "hold", ("link", "point", "normal"), 2) for one in given.hold],
        **further,
    )
    return of if isinstance(of, Model) else of.model, (text, contact, pose)
