"""Questions and reports of the command line."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Literal, Union, cast

import numpy as np
from numpy.typing import NDArray

from . import _percuss, records
from ._arguments import check_fields, checked
from ._errors import InputError
from ._percuss import Assembly, Contact, Model, Pose, System

#: Position of a joint: a number (rad, m), several numbers, or text with a unit: "30deg", "12mm".
Position = Union[float, Sequence[float], str]
#: Mechanism of a report: a model, a system or an assembly with its conditions, or a pose with those and its positions.
_Of = Union[Model, System, Assembly, Pose]
#: Range of a sweep: text in command-line syntax, or (joint, from, to, count) in SI.
Range = Union[str, tuple[str, float, float, int]]
#: Travel of a point: text in command-line syntax, or (link, point, direction, distance) in SI.
Travel = Union[str, tuple[str, Sequence[float], Sequence[float], float]]


@dataclass(frozen=True)
class Conditions:
    """Conditions of a contact: the flags of ``percuss mass``.

    frame: frame of the contact point: "link", "world", "against".
    against_mass: mass of a free body on the other side, kg.
    set: driving joints and their positions. guess: initial positions in the search for dependent joints.
    travel: moves of points from the pose of set, as text "LINK:X,Y,Z:DX,DY,DZ=DISTANCE" or (link, point, direction,
    distance): point in m in the link's frame, direction in world axes, distance in m.
    pose: JSON file with the positions of all joints, such as a saved report, or a Pose; set and guess take precedence.
    lock: joints that are locked. hold: points that are held: (link, point) or (link, point, normal).
    armature: joints and the inertia of their rotors, kg·m² or kg. base: "fixed" or "floating"; default: that of the System, or "fixed".
    estimate: adds the classical estimate to the result: (links,), (links, point) or (links, point, direction).
    ratio_at: adds motion ratios at points to the result: (link, point) or (link, point, direction), default upwards.
    """

    frame: Literal["link", "world", "against"] = "link"
    against_mass: float | None = None
    set: Mapping[str, Position] = field(default_factory=dict)
    guess: Mapping[str, Position] = field(default_factory=dict)
    lock: Sequence[str] = ()
    hold: Sequence[Sequence[Any]] = ()
    armature: Mapping[str, float | Sequence[float]] = field(default_factory=dict)
    base: Literal["fixed", "floating"] | None = None
    estimate: Sequence[Any] | None = None
    travel: Sequence[Travel] = ()
    pose: str | os.PathLike[str] | Pose | None = None
    ratio_at: Sequence[Sequence[Any]] = ()

    def __post_init__(self) -> None:
        check_fields(self)


@dataclass(frozen=True)
class Damping:
    """Damper to design: the flags of ``percuss damp``.

    restitution: e, 0 to 1. stiffness: k, N/m^exponent (N·m/rad for the stop of a revolute joint). exponent: p of the
    spring's force k x^p, default 1 unless the law has another exponent. speed: approach speed, m/s. law: a name of
    laws(). separation: "force" (the contact ends when the force vanishes) or "gap". tools: simulators whose parameters
    are computed, names of tools(), or ("all",). accuracy: permitted error of a simulator's restitution. time_step: time
    step of the simulator, s. own_mass, other_own_mass: masses of the two bodies alone, kg. diagonal_ratio: MuJoCo's
    diagonal ratio. closed_loops: true if loops bind the contact link. A model supplies this value; for a mass alone,
    None means unknown, and the parameters of MuJoCo's equality constraints are given too.
    """

    restitution: float
    stiffness: float
    exponent: float | None = None
    speed: float | None = None
    law: str = "kelvin-voigt"
    separation: Literal["force", "gap"] | None = None
    tools: Sequence[str] = ()
    accuracy: float | None = None
    time_step: float | None = None
    own_mass: float | None = None
    other_own_mass: float | None = None
    diagonal_ratio: float | None = None
    closed_loops: bool | None = None

    def __post_init__(self) -> None:
        check_fields(self)


@dataclass(frozen=True)
class Design:
    """Design for ``compare``: a model, a contact and conditions, under a name."""

    name: str
    model: _Of
    contact: Contact | str
    conditions: Conditions | None = None

    def __post_init__(self) -> None:
        check_fields(self)


@dataclass(frozen=True)
class _Impact:
    """Impact question in the form that the extension reads."""

    restitution: float
    speed: float | None
    friction: float | None
    restitution_law: str | None
    also: Sequence[Contact | str]
    also_restitution: Sequence[float]
    sticking: bool
    stiffness_ratios: Sequence[float]
    contact_exponent: float | None
    rates: Mapping[str, Position]
    base_twist: Sequence[float] | None
    law: Damping | None
    in_time: bool
    gravity: Sequence[float] | None
    joint_springs: Mapping[str, Position]
    rate_limits: Mapping[str, Position]
    gear_limits: Mapping[str, Position]
    point_error: float | None
    reflected: Sequence[str]
    percussion: Sequence[str]


@dataclass(frozen=True)
class _SafeSpeed:
    """Safe-speed question in the form that the extension reads."""

    region: str | None
    force: float | None
    pressure: float | None
    area: float | None
    energy: float | None
    momentum: float | None
    load: float
    directions: Sequence[Sequence[float]] = ()
    worst: bool = False


#: Row source in the form that the extension reads: ranges, file, random rows.
_Rows = tuple[
    Union[Sequence[Range], None], Union[tuple[str, list[str]], None], Union[tuple[int, int], None]
]


def _rows(
    vary: Range | Sequence[Range] | None,
    input: str | os.PathLike[str] | None,
    ignore: Sequence[str],
    random: int | None,
    seed: int,
) -> _Rows:
    ranges: list[Range] | None
    if vary is None:
        ranges = None
    elif isinstance(vary, str):
        ranges = [vary]
    elif isinstance(vary, tuple) and len(vary) == 4 and not isinstance(vary[1], (str, tuple)):
        ranges = [cast("Range", vary)]
    else:
        ranges = list(cast("Sequence[Range]", vary))
    file = None if input is None else (os.fspath(input), list(ignore))
    return ranges, file, None if random is None else (random, seed)


#: Base of all reports.
Report = records.Record


class MapReport(records.MapRecord):
    """Maps of links. facets: for each link a dict of arrays: points, normals (link's frame), points_world, normals_world (k, 3), m, area (k,) m²,
    effective_mass and error (k,) kg (NaN unless finite), status (k,) uint8."""

    def __init__(self, report: dict[str, Any], facets: dict[str, dict[str, NDArray[Any]]], svg: str) -> None:
        super().__init__(records.MapRecord.of(report))
        object.__setattr__(self, "facets", facets)
        object.__setattr__(self, "_svg", svg)

    facets: dict[str, dict[str, NDArray[Any]]]
    _svg: str

    def to_svg(self) -> str:
        """The picture: two views with a scale of colours."""
        return self._svg

    def _repr_html_(self) -> str:
        return f"<div>{super()._repr_html_()}{self._svg}</div>"


def _asked(of: _Of, conditions: Conditions | None) -> tuple[Model, Conditions]:
    """Model of a report, and the conditions with plain dicts and lists, as the extension requires. Those of a System, Assembly or Pose are
    added."""
    given = Conditions() if conditions is None else conditions
    if not isinstance(of, Model):
        own = of._conditions
        for name in own:
            value = getattr(given, name)
            if value != getattr(Conditions(), name) and (name != "base" or value != own[name]):
                raise InputError(f"conditions.{name}: the {type(of).__name__} has its own; expected the model, or conditions without {name}")
        given = replace(given, **own)
    return of if isinstance(of, Model) else of.model, replace(
        given,
        set=dict(given.set),
        guess=dict(given.guess),
        travel=list(given.travel),
        pose=given.pose if given.pose is None or isinstance(given.pose, Pose) else os.fspath(given.pose),
        lock=list(given.lock),
        hold=list(given.hold),
        armature=dict(given.armature),
        ratio_at=list(given.ratio_at),
    )


def _with_rows(parts: tuple[str, list[str]]) -> Any:
    """Report from its JSON, with the rows from lists in JSON."""
    report = json.loads(parts[0])
    if parts[1]:
        report["rows"] = [row for rows in parts[1] for row in json.loads(rows)]
    return report


@checked
def check(model: Model) -> records.CheckReport:
    """Summary of a model: links, joints, loops, mobility, redundancy, mass, diagnostics. As ``percuss check``."""
    return records.CheckReport.of(json.loads(_percuss.check(model)))


@checked
def mass(
    model: _Of, contact: Contact | str, conditions: Conditions | None = None, *, damping: Damping | None = None
) -> records.MassReport:
    """Report on one contact of a model, with the damper if damping is given. contact: a Contact, or the name of a
    contact of the model (Model.contacts), such as "bump_stop"; a stop is brought to the touch. As ``percuss mass``."""
    model, conditions = _asked(model, conditions)
    return records.MassReport.of(json.loads(_percuss.mass_report(model, contact, conditions, damping)))


@checked
def sweep_report(
    model: _Of,
    contact: Contact | str,
    conditions: Conditions | None = None,
    *,
    vary: Range | Sequence[Range] | None = None,
    input: str | os.PathLike[str] | None = None,
    ignore: Sequence[str] = (),
    random: int | None = None,
    seed: int = 0,
    gradient: bool = False,
) -> records.SweepReport:
    """Report on a contact at many rows of positions, with loops closed along one branch; each row has its pose,
    estimate and motion ratio. As ``percuss sweep``; ``sweep`` takes arrays and is far quicker.

    vary: one range or several, the first the slowest: "JOINT=FROM:TO:COUNT",
    "travel:LINK:X,Y,Z:DX,DY,DZ=FROM:TO:COUNT", or (joint, from, to, count). input: a file of positions, .csv or
    .parquet, without the columns of ignore. random: number of random rows within the limits of the joints, with seed.
    Exactly one of vary, input and random. gradient: adds the gradient of m̄, one number per velocity of every movable joint.
    """
    model, conditions = _asked(model, conditions)
    rows = _rows(vary, input, ignore, random, seed)
    return records.SweepReport.of(_with_rows(_percuss.sweep_report(model, contact, conditions, *rows, gradient)))


@checked
def map(
    model: _Of,
    conditions: Conditions | None = None,
    *,
    against: str | None = None,
    links: Sequence[str] | None = None,
    shapes: Literal["auto", "collision", "visual"] = "auto",
    edge: float | None = None,
    packages: Mapping[str, str | os.PathLike[str]] | None = None,
) -> MapReport:
    """m̄ over the surfaces of links, with one contact per facet, along its outward normal. As ``percuss map``.

    against: the other side; None: the ground. links: None: all links with a shape. shapes: "auto", "collision",
    "visual".
    edge: longest edge of a facet, m. packages: folders of ``package://`` names.
    """
    model, conditions = _asked(model, conditions)
    folders = [(name, os.fspath(path)) for name, path in (packages or {}).items()]
    named = None if links is None else list(links)
    if named == []:
        raise InputError("links is empty; expected names of links, or None for all links with a shape")
    report, facets, svg = _percuss.map_report(model, conditions, against, named, shapes, edge, folders)
    return MapReport(json.loads(report), facets, svg)


@checked
def map_point(
    model: _Of, contact: Contact | str, directions: int = 500, conditions: Conditions | None = None
) -> records.PointMapReport:
    """m̄ in many directions at the point of a contact, and the principal effective masses. The contact's normal is
    not used."""
    model, conditions = _asked(model, conditions)
    return records.PointMapReport.of(json.loads(_percuss.map_point_report(model, contact, conditions, directions)))


@checked
def damp(mass: float, damping: Damping) -> records.DampingReport:
    """Damper for an effective mass (kg), and parameters for simulators. As ``percuss damp --mass``."""
    return records.DampingReport.of(json.loads(_percuss.damp_mass(mass, damping)))


@checked
def damp_contact(
    model: _Of, contact: Contact | str, damping: Damping, conditions: Conditions | None = None
) -> records.DampingReport:
    """Damper for a contact of a model, and its changes over the penetration. As ``percuss damp --mass-from``."""
    model, conditions = _asked(model, conditions)
    return records.DampingReport.of(json.loads(_percuss.damp(model, contact, None, conditions, damping)))


@checked
def damp_stop(
    model: _Of,
    joint: str,
    damping: Damping,
    conditions: Conditions | None = None,
    *,
    end: Literal["lower", "upper"] | None = None,
) -> records.DampingReport:
    """Damper for a joint's stop, at the joint's position or at an end of its range ("lower", "upper"). As ``percuss
    damp --limit``."""
    model, conditions = _asked(model, conditions)
    return records.DampingReport.of(json.loads(_percuss.damp(model, None, (joint, end), conditions, damping)))


@checked
def impact_history(mass: float, damping: Damping, samples: int = 200) -> NDArray[np.float64]:
    """Impact of a mass (kg) over time, with the approach speed damping.speed. Returns (samples, 4): time (s),
    penetration (m), penetration rate (m/s), force (N)."""
    return _percuss.impact_history(mass, damping, samples)


@checked
def explain(model: _Of, contact: Contact | str, conditions: Conditions | None = None) -> records.Explanation | None:
    """Sensitivity of m̄: its derivative with respect to the mass and the centre of mass of each link, each armature,
    and each hardpoint of a sheet. None if the contact has no finite mass, or different masses on its branches. As
    ``percuss mass --explain``."""
    model, conditions = _asked(model, conditions)
    found = json.loads(_percuss.explain(model, contact, conditions))
    return None if found is None else records.Explanation.of(found)


@checked
def friction_thresholds(
    model: _Of, contact: Contact | str, conditions: Conditions | None = None
) -> records.FrictionThresholdsRecord | None:
    """Coefficients of friction from which the contact can stick, jam or wedge. They do not depend on the velocities. None if the contact
    has no finite mass, or if the pose is singular. As ``percuss mass --friction-thresholds``."""
    model, conditions = _asked(model, conditions)
    found = json.loads(_percuss.friction_thresholds(model, contact, conditions))
    return None if found is None else records.FrictionThresholdsRecord.of(found)


@checked
def reflected_inertias(
    model: _Of, joints: Sequence[str], conditions: Conditions | None = None
) -> records.ReflectedReport:
    """Inertias reflected to joints: with all other joints free, and with the other driving joints at rest. joints: "JOINT" for the
    inertia at the pose; "JOINT=FROM:TO:COUNT" for the inertia over a range of positions, with two substitutes for simulators without
    loops. As ``percuss impact --reflected`` without a contact."""
    model, conditions = _asked(model, conditions)
    return records.ReflectedReport.of(json.loads(_percuss.reflected_inertias(model, list(joints), conditions)))


@checked
def tolerate(
    model: _Of,
    contact: Contact | str,
    tolerance: str,
    conditions: Conditions | None = None,
    *,
    samples: int | None = None,
    seed: int = 0,
) -> records.ToleranceReport | None:
    """Variation of m̄ within tolerances, to first order and by random samples. tolerance:
    "mass=2%,com=1mm,armature=10%,point=0.5mm", or some of these. None as for ``explain``. As ``percuss mass
    --tolerance``."""
    model, conditions = _asked(model, conditions)
    drawn = None if samples is None else (samples, seed)
    found = json.loads(_percuss.tolerate(model, contact, conditions, tolerance, drawn))
    return None if found is None else records.ToleranceReport.of(found)


@checked
def compare(
    designs: Sequence[Design],
    *,
    vary: Range | Sequence[Range] | None = None,
    input: str | os.PathLike[str] | None = None,
    ignore: Sequence[str] = (),
    random: int | None = None,
    seed: int = 0,
) -> records.ComparisonReport:
    """Compares at least two designs by one question: each result, with its difference from the first. vary, input,
    random: row source, as for ``sweep_report``; without rows, only the pose is compared. As ``percuss compare``."""
    if len(designs) < 2:
        raise InputError(f"designs has {len(designs)} entries; expected two at least")
    asked = [Design(d.name, model, d.contact, given) for d in designs for model, given in [_asked(d.model, d.conditions)]]
    return records.ComparisonReport.of(_with_rows(_percuss.compare(asked, *_rows(vary, input, ignore, random, seed))))


@checked
def compare_study(path: str | os.PathLike[str], name: str = "as given") -> records.ComparisonReport:
    """Compares the variants of a study (TOML) with its model, under the given name. As ``percuss compare STUDY``."""
    return records.ComparisonReport.of(_with_rows(_percuss.compare_study(path, name)))


@checked
def impact(
    model: _Of,
    contact: Contact | str,
    restitution: float,
    conditions: Conditions | None = None,
    *,
    speed: float | None = None,
    friction: float | None = None,
    rates: Mapping[str, Position] | None = None,
    base_twist: Sequence[float] | None = None,
    stiffness: float | None = None,
    exponent: float | None = None,
    law: str = "kelvin-voigt",
    rate_limit: Mapping[str, Position] | None = None,
    reflected: Sequence[str] = (),
    percussion: Sequence[str] = (),
    restitution_law: Literal["energetic", "poisson", "newton", "algebraic"] | None = None,
    also: Sequence[Contact | str] = (),
    sticking: bool = False,
    stiffness_ratio: Sequence[float] = (),
    contact_exponent: float | None = None,
    in_time: bool = False,
    gravity: Sequence[float] | None = None,
    also_restitution: Sequence[float] = (),
    gear_limit: Mapping[str, Position] | None = None,
    point_error: float | None = None,
    joint_spring: Mapping[str, Position] | None = None,
) -> records.ImpactReport:
    """Rigid impact at a contact: impulse, rates of all joints before and after, energy loss, and the reactions in all
    joints, closures and held points. speed: closing speed, m/s; without rates, the motion of least energy with this
    speed is assumed. friction: coefficient (Coulomb), with restitution_law "energetic" (Stronge, default), "poisson", "newton" or
    "algebraic". rates: driving joints and their rates before the impact, rad/s or m/s; the others follow.
    base_twist: velocity of a floating base, rad/s then m/s, world axes. stiffness, exponent, law: contact law for the
    peak forces of all bearings. rate_limit: largest jumps of joint rates, for the greatest closing speed. reflected:
    joints whose reflected inertia is added. percussion: joints, loop closures or "ground" whose centre of percussion is added,
    "JOINT" in the tangent plane or "JOINT:X,Y,Z" along a line. Components that redundant loops leave open are None. also: further
    contacts that touch at the same time: a Contact, the name of a contact, a point "LINK:X,Y,Z:NX,NY,NZ" (point in the link's frame, normal
    in world axes), a moment "LINK:about:X,Y,Z" (axis in the link's frame), a cable "LINK:X,Y,Z=LINK:X,Y,Z", or a stop
    "JOINT:upper"; "=OTHER" after a point or a moment gives another link on the other side. stiffness_ratio and contact_exponent:
    their stiffnesses relative to the first, and the exponent of their forces, for the energetic law; also_restitution: their restitutions. sticking: adds the plastic impact with sticking
    points. in_time: adds the impact in time with the contact law, gravity in m/s² and world axes. gear_limit: largest impulses in
    gears (N·m·s or N·s) or, as text with a unit, largest torques ("80N·m"; requires stiffness), for the greatest closing speed.
    point_error: largest displacement of the contact point (m), for the worst impulse at the joints of percussion. joint_spring: during the impact in time, stiffness (N·m/rad or N/m)
    of a joint, or stiffness, damping (N·m·s/rad or N·s/m) and the position without force (rad or m). As ``percuss impact``."""
    model, conditions = _asked(model, conditions)
    if in_time and stiffness is None:
        raise InputError("in_time: the impact in time requires stiffness, that of the contact")
    if in_time and friction is not None:
        raise InputError("in_time: the impact in time has no friction; expected friction=None")
    damping = None if stiffness is None else Damping(restitution, stiffness, exponent, law=law)
    asked = _Impact(
        restitution, speed, friction, restitution_law, list(also), also_restitution, sticking, stiffness_ratio, contact_exponent,
        rates or {}, base_twist, damping, in_time, gravity, joint_spring or {}, rate_limit or {}, gear_limit or {}, point_error, reflected,
        percussion,
    )
    return records.ImpactReport.of(json.loads(_percuss.impact(model, contact, conditions, asked)))


@checked
def extremes(
    model: _Of,
    contact: Contact | str,
    conditions: Conditions | None = None,
    *,
    ranges: Mapping[str, tuple[float, float]] | None = None,
    normals: str = "given",
    starts: int = 32,
    quantity: str = "mass",
    contact_law: Damping | None = None,
    keep: Sequence[str] = (),
    vary: Range | None = None,
    input: str | os.PathLike[str] | None = None,
    ignore: Sequence[str] = (),
) -> records.ExtremesReport:
    """Smallest and largest effective mass of a contact over ranges of its driving joints (rad or m); without ranges, over the
    limits of all driving joints with limits. quantity: "mass", "reflected:JOINT" or "held:JOINT" (inertia at a joint with the other
    drivers free or at rest), "bearing:JOINT" (impulse in a bearing per closing speed of a plastic impact, kg), "peak:JOINT" (peak
    force in a bearing, N, with contact_law, which requires a speed: the closing speed). A bearing is a joint, a loop closure or
    "ground".
    normals: "given", "any", or "across:X,Y,Z" for all normals perpendicular to an axis (world axes): the extremes are those over
    positions and normals. starts: number of starts of the local searches. The report has the positions, the active limits, the
    optimality residual and the number of starts that agree.
    keep: links or points that stay in place, "LINK", "LINK:X,Y,Z" or "LINK:X,Y,Z:NX,NY,NZ" (m, link's frame; direction in world axes): the
    search covers the self-motion. A path replaces the ranges. vary: one range of a joint or of a travel. input: a file of positions,
    without the columns in ignore. Both are as for ``sweep_report``. The command is ``percuss extremes``."""
    model, conditions = _asked(model, conditions)
    given = [f"{joint}={lower!r}:{upper!r}" for joint, (lower, upper) in (ranges or {}).items()]
    return records.ExtremesReport.of(json.loads(_percuss.extremes(
        model, contact, conditions, given, quantity, normals, starts, list(keep), contact_law, _rows(vary, input, ignore, None, 0)
    )))


@checked
def safe_speed(
    model: _Of,
    contact: Contact | str,
    region: str | None,
    conditions: Conditions | None = None,
    *,
    force: float | None = None,
    pressure: float | None = None,
    area: float | None = None,
    energy: float | None = None,
    momentum: float | None = None,
    load: float = 0.0,
    vary: Range | Sequence[Range] | None = None,
    input: str | os.PathLike[str] | None = None,
    ignore: Sequence[str] = (),
    random: int | None = None,
    seed: int = 0,
) -> records.SafeSpeedReport:
    """Safe speed of a robot in a possible impact with a person. region: a name of regions(); None: a rigid obstacle,
    with a limit of energy or momentum. Exactly one limit, from the applicable edition of the standard: force (N),
    pressure (Pa) with area (m²), energy (J), momentum (N·s). load: kg. vary, input, random: row source, as for
    ``sweep_report``; the slowest row is under "along". As ``percuss safe-speed``."""
    model, conditions = _asked(model, conditions)
    speed = _SafeSpeed(region, force, pressure, area, energy, momentum, load)
    rows = _rows(vary, input, ignore, random, seed)
    return records.SafeSpeedReport.of(json.loads(_percuss.safe_speed(model, contact, conditions, speed, *rows))[0])


@checked
def safe_speed_directions(
    model: _Of,
    contact: Contact | str,
    region: str | None,
    directions: Sequence[Sequence[float]],
    conditions: Conditions | None = None,
    *,
    worst: bool = False,
    force: float | None = None,
    pressure: float | None = None,
    area: float | None = None,
    energy: float | None = None,
    momentum: float | None = None,
    load: float = 0.0,
) -> list[records.SafeSpeedReport]:
    """``safe_speed`` in several directions, (3,) each, world axes. With worst, the last report is for the worst
    direction: the direction of the greatest effective mass at the point. The contact's normal is not used."""
    model, conditions = _asked(model, conditions)
    along = [[float(x) for x in direction] for direction in directions]
    for number, direction in enumerate(along):
        if len(direction) != 3 or not np.isfinite(direction).all():
            raise InputError(f"directions[{number}] is {direction}; expected three finite numbers")
    if not along and not worst:
        raise InputError("directions: none is given; give at least one, or worst=True")
    speed = _SafeSpeed(region, force, pressure, area, energy, momentum, load, along, worst)
    found = _percuss.safe_speed(model, contact, conditions, speed, None, None, None)
    return [records.SafeSpeedReport.of(report) for report in json.loads(found)]


#: Reports of studies by their schema.
_BY_SCHEMA: Mapping[str, type[Report]] = {
    "percuss.sweep": records.SweepReport,
    "percuss.mass": records.MassReport,
    "percuss.damp": records.DampingReport,
    "percuss.map": records.MapRecord,
    "percuss.map-point": records.PointMapReport,
    "percuss.safe-speed": records.SafeSpeedReport,
}


@checked
def run_study(path: str | os.PathLike[str]) -> records.AnyRecord:
    """Runs a study (TOML) and returns the report of its sweep, or of its contact if the study has no sweep. If the study has the tables
    [impact] and [extremes], the keys "impact" and "extremes" of the report contain the reports of ``impact`` and ``extremes``. Safe speeds
    in several directions are a list under the key "reports". Writes no file. As ``percuss run``."""
    found = _with_rows(_percuss.run_study(path))
    if isinstance(found, list):
        speeds = [records.SafeSpeedReport.of(one) for one in found]
        return cast("records.AnyRecord", speeds[0] if len(speeds) == 1 else Report(reports=speeds))
    report = _BY_SCHEMA[found["schema"].split("/")[0]].of(found)
    for key, record in (("impact", records.ImpactReport), ("extremes", records.ExtremesReport)):
        if key in found:
            report[key] = record.of(found[key])
    return cast("records.AnyRecord", report)


#: Record of each table of a report.
_TABLES: Mapping[str, type[Report]] = {
    "mass": records.MassReport,
    "damping": records.DampingReport,
    "impact": records.ImpactReport,
    "extremes": records.ExtremesReport,
    "sweep": records.SweepReport,
    "comparison": records.ComparisonReport,
    "kinematics": records.KinematicsReport,
    "contacts": records.ContactListReport,
}


@checked
def ask(model: Model, request: Mapping[str, Any]) -> Report:
    """Answers the tables of a study about a model: ``{"contact": {"at": "bump_stop"}, "impact": {"restitution": 0.3, "speed": 1}}``. The
    request has the tables and keys of docs/reference/STUDY_KEYS.md, without the path of a model and without output files. The keys of
    the result are the tables: "mass", "contacts", "damping", "impact", "extremes", "sweep", "comparison", "kinematics", "map", "safe_speed"
    (a list). SI units; text with a unit is allowed. Raises InputError, whose message contains the key, and NoAnswerError."""
    try:
        text = json.dumps(request, default=_plain, allow_nan=False)
    except (TypeError, ValueError) as error:
        raise InputError(f"request: {error}; expected numbers, texts, lists and tables") from None
    found = json.loads(_percuss.ask(model, text))
    for table, record in _TABLES.items():
        if table in found:
            found[table] = record.of(found[table])
    if "map" in found:
        found["map"] = _BY_SCHEMA[found["map"]["schema"].split("/")[0]].of(found["map"])
    if "safe_speed" in found:
        found["safe_speed"] = [records.SafeSpeedReport.of(one) for one in found["safe_speed"]]
    return Report(found)


def _plain(value: object) -> Any:
    """Numbers and arrays of numpy as numbers and lists."""
    if isinstance(value, (np.generic, np.ndarray)):
        return value.tolist()
    raise TypeError(f"{type(value).__name__} is given")


@checked
def starting_study(model: Model, path: str | os.PathLike[str]) -> str:
    """Complete initial study of a model as TOML, with a contact. path: path of the model's file in the study,
    relative to the study's folder. As ``percuss init``."""
    return _percuss.starting_study(model, path)


def study_schema() -> dict[str, Any]:
    """JSON schema of studies: the permitted tables and keys. As ``percuss schema``."""
    return cast("dict[str, Any]", json.loads(_percuss.study_schema()))
