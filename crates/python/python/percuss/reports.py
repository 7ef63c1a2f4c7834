"""Questions and reports of the command line."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from typing import Any, Literal, TypeVar

import numpy as np
from numpy.typing import NDArray

from . import _percuss, records
from ._arguments import checked
from ._percuss import Contact, Model, regions
from ._request import EVERY_CONDITION, OF_SIMULATORS, Conditions, Damping, Of, Position, Range, Request, asked, json_of, numbers, of_contacts, rates_of, rows, tables
from .errors import InputError
from .state import State


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


def with_rows(parts: tuple[str, list[str]]) -> Any:
    """Report from its JSON, with the rows from lists in JSON."""
    report = json.loads(parts[0])
    if parts[1]:
        report["rows"] = [row for rows in parts[1] for row in json.loads(rows)]
    return report


class Explanation(records.Explanation):
    """Sensitivities of m̄."""

    diagnostics: list[records.DiagnosticRecord]
    """Findings of the mass."""


class FrictionThresholdsRecord(records.FrictionThresholdsRecord):
    """Coefficients of friction for sticking, jamming and wedging."""

    diagnostics: list[records.DiagnosticRecord]
    """Findings of the mass."""


class ToleranceReport(records.ToleranceReport):
    """Variation of m̄ within tolerances."""

    diagnostics: list[records.DiagnosticRecord]
    """Findings of the mass."""


_Part = TypeVar("_Part", bound=Report)


def _part(kind: type[_Part], model: Model, request: Request, name: str) -> _Part | None:
    """Part of the report of a mass, with the findings of the report; None if the report has no such part."""
    report = records.MassReport.of(json.loads(_percuss.mass_report(model, request)))
    part = report[name]
    return None if part is None else kind({**part, "diagnostics": report.diagnostics})


@checked
def check(model: Model) -> records.CheckReport:
    """Summary of a model: links, joints, loops, mobility, redundancy, mass, diagnostics. As ``percuss check``.

        >>> percuss.reports.check(model).degrees_of_freedom
    """
    return records.CheckReport.of(json.loads(_percuss.check(model)))


@of_contacts
def mass(
    model: Of, contact: Contact | str, conditions: Conditions | None = None, *, damping: Damping | None = None, certify: bool = False
) -> records.MassReport:
    """Report on one contact of a model, with the damper if damping is given. contact: a Contact, or the name of a
    contact of the model (Model.contacts), such as "bump_stop"; a stop is brought to the touch. A list of contacts gives a list of
    reports, here and in every other question about a contact. certify: proves bounds of m̄ with interval arithmetic. As ``percuss mass``.

        >>> percuss.mass(corner, "bump_stop").effective_mass
        >>> [report.effective_mass for report in percuss.mass(corner, ["spring", "damper"])]
    """
    model, request = asked(model, contact, conditions, reads=EVERY_CONDITION, mass={"certify": certify}, **({} if damping is None else damping._tables()))
    return records.MassReport.of(json.loads(_percuss.mass_report(model, request)))


@of_contacts
def sweep_report(
    model: Of,
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

        >>> percuss.reports.sweep_report(model, contact, vary="crank_hinge=0:0.2:5").rows[0].effective_mass
    """
    model, request = asked(
        model, contact, conditions, reads=("frame", "against_mass", "estimate"),
        sweep={**(rows(vary, input, ignore, random, seed) or {}), "gradient": gradient},
    )
    return records.SweepReport.of(with_rows(_percuss.sweep_report(model, request)))


@checked
def map(
    model: Of,
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

        >>> percuss.map(percuss.load("models/shaped_arm.urdf"), links=["finger"]).facets["finger"]["effective_mass"]
    """
    if links is not None and not len(links):
        raise InputError("links is empty; expected names of links, or None for all links with a shape")
    folders = {name: os.fspath(path) for name, path in (packages or {}).items()}
    model, request = asked(
        model, None, conditions, against, ("against_mass",),
        map={"link": links, "all": links is None, "shapes": shapes, "edge": edge, "package": folders},
    )
    report, facets, svg = _percuss.map_report(model, request)
    return MapReport(json.loads(report), facets, svg)


@of_contacts
def map_point(
    model: Of, contact: Contact | str, directions: int = 500, conditions: Conditions | None = None
) -> records.PointMapReport:
    """m̄ in many directions at the point of a contact, and the principal effective masses. The contact's normal is
    not used.

        >>> percuss.reports.map_point(arm, tool, 100).principal
    """
    model, request = asked(model, contact, conditions)
    return records.PointMapReport.of(json.loads(_percuss.map_point_report(model, request, directions)))


@of_contacts
def explain(model: Of, contact: Contact | str, conditions: Conditions | None = None) -> Explanation | None:
    """Sensitivity of m̄: its derivative with respect to the mass and the centre of mass of each link, each armature,
    and each hardpoint of a sheet. None if the contact has no finite mass, or different masses on its branches. As
    ``percuss mass --explain``; the key "diagnostics" has the findings of ``mass``.

        >>> percuss.reports.explain(arm, tool)
    """
    model, request = asked(model, contact, conditions, mass={"explain": True})
    return _part(Explanation, model, request, "explanation")


@of_contacts
def friction_thresholds(
    model: Of, contact: Contact | str, conditions: Conditions | None = None
) -> FrictionThresholdsRecord | None:
    """Coefficients of friction from which the contact can stick, jam or wedge. They do not depend on the velocities. None if the contact
    has no finite mass, or if the pose is singular. As ``percuss mass --friction-thresholds``; the key "diagnostics" has the findings of ``mass``.

        >>> percuss.reports.friction_thresholds(arm, tool)
    """
    model, request = asked(model, contact, conditions, mass={"friction_thresholds": True})
    return _part(FrictionThresholdsRecord, model, request, "friction_thresholds")


@checked
def reflected_inertias(
    model: Of, joints: Sequence[str], conditions: Conditions | None = None
) -> records.ReflectedReport:
    """Inertias reflected to joints: with all other joints free, and with the other driving joints at rest. joints: "JOINT" for the
    inertia at the pose; "JOINT=FROM:TO:COUNT" for the inertia over a range of positions, with two substitutes for simulators without
    loops. As ``percuss impact --reflected`` without a contact.

        >>> percuss.reports.reflected_inertias(model, ["crank_hinge"])
    """
    model, request = asked(model, None, conditions, reads=())
    return records.ReflectedReport.of(json.loads(_percuss.reflected_inertias(model, request, list(joints))))


@of_contacts
def tolerate(
    model: Of,
    contact: Contact | str,
    tolerance: str,
    conditions: Conditions | None = None,
    *,
    samples: int | None = None,
    seed: int = 0,
) -> ToleranceReport | None:
    """Variation of m̄ within tolerances, to first order and by random samples. tolerance:
    "mass=2%,com=1mm,armature=10%,point=0.5mm", or some of these. None as for ``explain``. As ``percuss mass
    --tolerance``; the key "diagnostics" has the findings of ``mass``.

        >>> percuss.reports.tolerate(arm, tool, "mass=2%,com=1mm", samples=100)
    """
    drawn = {} if samples is None and not seed else {"samples": samples, "seed": seed}
    model, request = asked(model, contact, conditions, mass={"tolerance": tolerance, **drawn})
    return _part(ToleranceReport, model, request, "tolerance")


@of_contacts
def impact(
    model: Of,
    contact: Contact | str,
    restitution: float | None = None,
    conditions: Conditions | None = None,
    *,
    speed: float | None = None,
    friction: float | None = None,
    rates: Mapping[str, Position] | None = None,
    base_twist: Sequence[float] | None = None,
    stiffness: float | None = None,
    exponent: float | None = None,
    law: str | None = None,
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
    stiffness_curve: Mapping[str, Sequence[float] | float] | None = None,
    springs: Literal["change", "full", "none"] | None = None,
    spring: Sequence[str] = (),
    damper: Sequence[str] = (),
    drive: Sequence[str] = (),
    reach: bool = False,
    damping: float | None = None,
    hunt_crossley: float | None = None,
    loss_factor: float | None = None,
    compliance: bool = False,
) -> records.ImpactReport:
    """Rigid impact at a contact (of a list, one impact at each): impulse, rates of all joints before and after, energy loss, and the reactions in all
    joints, closures and held points. speed: closing speed, m/s; without rates, the motion of least energy with this
    speed is assumed. friction: coefficient (Coulomb), with restitution_law "energetic" (Stronge, default), "poisson", "newton" or
    "algebraic". rates: driving joints and their rates before the impact, rad/s or m/s; the others follow.
    base_twist: velocity of a floating base, rad/s then m/s, world axes. stiffness, exponent, law, stiffness_curve: contact law
    for the peak forces of all bearings, as in Damping; default: the force curve of the stop in a suspension sheet. rate_limit: largest jumps of joint rates, for the greatest closing speed. reflected:
    joints whose reflected inertia is added. percussion: joints, loop closures or "ground" whose centre of percussion is added,
    "JOINT" in the tangent plane or "JOINT:X,Y,Z" along a line. Components that redundant loops leave open are None. also: further
    contacts that touch at the same time: a Contact, the name of a contact, a point "LINK:X,Y,Z:NX,NY,NZ" (point in the link's frame, normal
    in world axes), a moment "LINK:about:X,Y,Z" (axis in the link's frame), a cable "LINK:X,Y,Z=LINK:X,Y,Z", or a stop
    "JOINT:upper"; "=OTHER" after a point or a moment gives another link on the other side. stiffness_ratio and contact_exponent:
    their stiffnesses relative to the first, and the exponent of their forces, for the energetic law; also_restitution: their restitutions. sticking: adds the plastic impact with sticking
    points. in_time: adds the impact in time with the contact law, gravity in m/s² and world axes. gear_limit: largest impulses in
    gears (N·m·s or N·s) or, as text with a unit, largest torques ("80N·m"; requires stiffness), for the greatest closing speed.
    point_error: largest displacement of the contact point (m), for the worst impulse at the joints of percussion. joint_spring: during the impact in time, stiffness (N·m/rad or N/m)
    of a joint, or stiffness, damping (N·m·s/rad or N·s/m) and the position without force (rad or m). springs: springs of a suspension
    sheet during the impact in time, "change" (default; change of their forces since the touch), "full" (with the preload) or "none".
    spring: further springs between points, "LINK:X,Y,Z=LINK:X,Y,Z=RATE" or "…=RATE=FREE". damper: dampers between points,
    "LINK:X,Y,Z=LINK:X,Y,Z=DAMPING" or "…=SPEED:FORCE,SPEED:FORCE,…". drive: constant forces of drives, "JOINT=TORQUE" or
    "LINK:X,Y,Z=LINK:X,Y,Z=FORCE" (pushes apart). reach: the damping with which the impact in time reaches the restitution, with all these
    forces. damping (N·s/m), hunt_crossley (s/m), loss_factor: damping of the contact in place of a restitution. compliance: adds the impact in time with the
    elastic bushes and gears of the model and conditions. The velocities of a State in place of the model are the rates. As ``percuss impact``; ``impacts`` takes arrays of states.

        >>> percuss.impact(arm, tool, restitution=0.5, speed=1.0).impulse
    """
    if isinstance(model, State) and (model.velocities is not None or model.base_twist is not None):
        if rates is not None or base_twist is not None:
            raise InputError("rates, base_twist: the State has velocities; expected a State without velocities, or no rates")
        rates, base_twist = rates_of(model)
    model, request = asked(
        model, contact, conditions, reads=EVERY_CONDITION,
        impact={
            "restitution": restitution, "speed": speed, "friction": friction, "restitution_law": restitution_law,
            "also": [one if isinstance(one, str) else "contact" for one in also], "also_restitution": also_restitution,
            "sticking": sticking, "stiffness_ratio": stiffness_ratio, "contact_exponent": contact_exponent, "rates": rates,
            "base_twist": base_twist, "stiffness": stiffness, "exponent": exponent,
            "law": law, "stiffness_curve": stiffness_curve, "springs": springs, "spring": spring, "damper": damper, "drive": drive,
            "in_time": in_time, "reach": reach, "compliance": compliance, "gravity": gravity,
            "joint_spring": joint_spring, "rate_limit": rate_limit, "gear_limit": gear_limit, "point_error": point_error,
            "reflected": reflected, "percussion": percussion, "damping": damping, "hunt_crossley": hunt_crossley, "loss_factor": loss_factor,
        },
    )
    contacts = [None if isinstance(one, str) else one for one in also]
    return records.ImpactReport.of(json.loads(_percuss.impact(model, request, contacts)))


@of_contacts
def extremes(
    model: Of,
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
    without the columns in ignore. Both are as for ``sweep_report``. The command is ``percuss extremes``.

        >>> percuss.extremes(arm, tool, ranges={"elbow": (-1.0, 1.0)}, starts=4).least.effective_mass
    """
    path = rows(vary, input, ignore, None, 0) or {}
    if vary is not None and input is not None:
        raise InputError("vary: give one of vary and input")
    if contact_law is not None:
        contact_law._refuse(*OF_SIMULATORS)
    model, request = asked(
        model, contact, conditions,
        extremes={
            "range": [f"{joint}={numbers(lower, 'ranges')}:{numbers(upper, 'ranges')}" for joint, (lower, upper) in (ranges or {}).items()], "normals": normals,
            "starts": starts, "quantity": quantity, "keep": keep, "ignore": ignore,
            "path": path.get("input") or next(iter(path.get("vary", ())), None),
        },
        **({} if contact_law is None else contact_law._tables()),
    )
    return records.ExtremesReport.of(json.loads(_percuss.extremes(model, request)))


def limit_of(
    region: str | None,
    force: float | None,
    pressure: float | None,
    area: float | None,
    energy: float | None,
    momentum: float | None,
    load: float = 0.0,
) -> dict[str, Any]:
    """Table of the limit of a safe speed."""
    limits = {"force": force, "pressure": pressure, "area": area, "energy": energy, "momentum": momentum}
    given = [name for name, value in limits.items() if value is not None]
    if given not in (["force"], ["pressure", "area"], ["energy"], ["momentum"]):
        raise InputError(
            f"one limit is required: force (N), pressure (Pa) with area (m²), energy (J) or momentum (N·s); given: {' and '.join(given) or 'none'}"
        )
    # Numbers without a unit are in N/cm² and cm².
    units = {"pressure": f"{numbers(pressure, 'pressure')}Pa", "area": f"{numbers(area, 'area')}m²"} if "pressure" in given else {}
    return {"region": region, **limits, **units, "load": load}


@of_contacts
def safe_speed(
    model: Of,
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
    ``sweep_report``; the slowest row is under "along". As ``percuss safe-speed``.

        >>> percuss.safe_speed(arm, tool, "chest", force=140.0).reflected.speed
    """
    limit = limit_of(region, force, pressure, area, energy, momentum, load)
    model, request = asked(model, contact, conditions, safe_speed=limit, sweep=rows(vary, input, ignore, random, seed))
    return records.SafeSpeedReport.of(json.loads(_percuss.safe_speed(model, request))[0])


@of_contacts
def safe_speed_directions(
    model: Of,
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
    direction: the direction of the greatest effective mass at the point. The contact's normal is not used.

        >>> percuss.reports.safe_speed_directions(arm, tool, "chest", [[0, 1, 0]], worst=True, force=140.0)[-1].normal_world
    """
    if not len(directions) and not worst:
        raise InputError("directions: none is given; give at least one, or worst=True")
    along = [[float(x) for x in direction] for direction in directions]
    for number, direction in enumerate(along):
        if len(direction) != 3 or not np.isfinite(direction).all():
            raise InputError(f"directions[{number}] is {direction}; expected three finite numbers")
    limit = {**limit_of(region, force, pressure, area, energy, momentum, load), "direction": along, "worst_direction": worst}
    model, request = asked(model, contact, conditions, safe_speed=limit)
    return [records.SafeSpeedReport.of(report) for report in json.loads(_percuss.safe_speed(model, request))]


__all__ = [
    "MapReport",
    "Report",
    "check",
    "explain",
    "extremes",
    "friction_thresholds",
    "impact",
    "map",
    "map_point",
    "mass",
    "reflected_inertias",
    "regions",
    "safe_speed",
    "safe_speed_directions",
    "sweep_report",
    "tolerate",
]
