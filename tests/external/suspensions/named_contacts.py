"""Named contacts of a sheet compared with the own programs: stops at the touch, seats and contact patches as drawn."""

import json
import re

import numpy as np

from cars import StopKeys, build, unit
from mechanics import Independent
from touch import NotReached, PathToTouch, moved_car, normal_at

# As drawn: both programs round at 1e-16, conditions reach 1e5.
AS_DRAWN = 1e-9
# Positions at the touch, m. percuss closes a gap to 1e-12 of the size of the car, and two gaps together to 1e-11; the
# wheel moves up to some ten times as far as the pad.
PLACE = 1e-9
# Mass at the touch, relative: the same error of the gap times d ln m̄/dg, which is 1/(g − g_min) near a minimum of g.
AT_TOUCH = 1e-8
# Motion ratio at the touch, relative: the error of the pose times its derivative, as for the mass.
RATIO = 1e-8
# Error of the own mass, in addition to the stated error of percuss: joints closed to 1e-13 m.
OWN_ERROR = 1e-11
# Gap that remains, m: percuss ends its search at 1e-9; the own minimum is of second order in a step of 1e-5.
REMAINING = 2e-9
# Gap that remains in a message, m: two decimals in mm, three in inches.
REMAINING_IN_MESSAGE = 1.3e-5


class Tally:
    """Numbers of compared stops and their worst deviations."""

    def __init__(self):
        # At the touch, by kind; not reached by both programs; of these, with a remaining gap.
        self.kinds = dict.fromkeys(("line of the points", "direction", "damper, bump", "damper, rebound"), 0)
        self.not_reached, self.remaining = 0, 0
        # The search of percuss ended before the touch, and says so.
        self.ended = 0
        # Motion ratios of the wheel at the touch; of these, with the rack held.
        self.ratios, self.held, self.worst_ratio = 0, 0, 0.0
        self.worst_mass, self.worst_place, self.worst_remaining = 0.0, 0.0, 0.0

    def touched(self):
        return sum(self.kinds.values())

    def text(self):
        kinds = ", ".join(f"{kind}: {count}" for kind, count in self.kinds.items())
        return (
            f"{self.touched()} stops at the touch ({kinds}), mass off by at most {self.worst_mass:.1e}, positions by "
            f"{self.worst_place:.1e} m; {self.not_reached} not reached, {self.ended} searches ended before, {self.remaining} remaining gaps, off by at most "
            f"{self.worst_remaining:.1e} m; {self.ratios} motion ratios of the wheel, {self.held} with the rack held, off by at most "
            f"{self.worst_ratio:.1e}"
        )


def drawn_contacts(built):
    """Name and (link, position, direction) of each named contact without a gap."""
    for frame, (link, at) in built.frames.items():
        name, _, ending = frame.partition("_seat")
        if name in ("spring", "damper"):
            yield name + ending, (link, at, unit(built.frames[f"{name}_chassis_seat{ending}"][1] - at))
        elif frame == "third_spring_seat_left":
            other, end = built.frames["third_spring_seat_right"]
            yield "third_spring", (link, at, unit(end - at), other)
        elif frame.startswith("contact_patch"):
            yield frame, (link, at, np.array([0.0, 0, 1]))


def compare_named_contacts(checker, car, spelling, which, rng, name):
    """All named contacts of a sheet that `check.compare` has written and imported."""
    sheet, model = (checker.folder / f"{name}{end}" for end in (".toml", ".urdf"))
    where = f"{name} {spelling} {which}"
    built = build(car, which)
    code, out, err = checker.run("mass", str(sheet), "--at", "all", "--format", "json")
    if not checker.verdict(code == 0, f"{where}: --at all: {err}"):
        return
    listed = {entry["name"]: entry for entry in json.loads(out)["contacts"]}
    seats = dict(drawn_contacts(built))
    expected = sorted([*seats, *built.stops])
    if not checker.verdict(sorted(listed) == expected, f"{where}: contacts {sorted(listed)}, {expected} are expected"):
        return
    drawn = Independent(built)
    for contact, place in seats.items():
        mass, own = (listed[contact]["report"] or {}).get("effective_mass"), drawn.effective_mass(*place)
        off = abs(mass / own - 1) if isinstance(mass, float) else np.inf
        checker.verdict(off <= AS_DRAWN, f"{where}: {contact}: {mass} where {own} is expected ({off:.1e})")
    for kind in ("bump_stop", "rebound_stop"):
        names = [stop for stop in built.stops if stop.startswith(kind)]
        if not names:
            continue
        path, remaining = PathToTouch(built, names), None
        try:
            pose = path.touch()
        except NotReached as error:
            pose, remaining = None, error.remaining
        except RuntimeError as error:
            checker.verdict(False, f"{where}: {kind}: own program: {error}")
            continue
        for stop in names:
            touched = compare_stop(checker, path, pose, remaining, stop, listed[stop], f"{where}: {sheet.name} --at {stop}")
            if touched:
                keys = car.stops.get(kind, StopKeys())
                own_points = "line of the points" if keys.direction is None else "direction"
                on_damper = "damper, rebound" if built.stops[stop].extends else "damper, bump"
                checker.stops.kinds[own_points if kind in car.points else on_damper] += 1
        # One of them alone, with the sheet and with the imported model.
        stop = str(rng.choice(names))
        for file in (sheet, model):
            compare_alone(checker, file, stop, listed[stop], remaining, f"{where}: {file.name} --at {stop}")


def compare_stop(checker, path, pose, remaining, name, entry, where):
    """Stop in the list of percuss and at the own pose. `pose` is `None` if the gap cannot be closed. True if the stop was
    compared at the touch."""
    report, stop, tally = entry["report"], path.linkage.built.stops[name], checker.stops
    if pose is None or report is None:
        if report is None and pose is not None and "was not reached: the search ends" in entry["problem"]:
            tally.ended += 1
            return False
        alike = pose is None and report is None
        tally.not_reached += alike
        own = "touches" if remaining is None else f"{1e3 * remaining:.3f} mm remain"
        checker.verdict(alike, f"{where}: {entry['problem'] or 'touches'}; own program: {own}")
        if alike and entry["remaining_gap"] is not None:
            tally.remaining += 1
            off = abs(entry["remaining_gap"] - remaining)
            tally.worst_remaining = max(tally.worst_remaining, off)
            checker.verdict(off <= REMAINING, f"{where}: {entry['remaining_gap']} m remain, {remaining} are expected ({off:.1e})")
        return False
    linkage, named, contact = path.linkage, report["named_contact"], report["contact"]
    moved, pad = moved_car(linkage, pose), linkage.point(pose, linkage.group[stop.link], stop.pad)
    ending = name.removeprefix("bump_stop").removeprefix("rebound_stop")
    wheel = f"wheel_centre{ending}"
    travels = {entry["link"]: entry["travel"] for entry in named["wheel_travel"]}
    checker.verdict(list(travels) == [wheel], f"{where}: wheel travel of {list(travels)}, {wheel} is expected")
    direction = normal_at(stop, pad)
    for what, found, own in [
        ("gap as drawn", named["gap_as_drawn"], stop.gap),
        ("gap", named["gap"], 0.0),
        ("pad", contact["point_world"], pad),
        ("normal", contact["normal_world"], direction),
        ("wheel travel", travels.get(wheel, np.nan), moved.frames[wheel][1][2] - linkage.built.frames[wheel][1][2]),
    ]:
        off = np.abs(np.subtract(found, own)).max()
        tally.worst_place = max(tally.worst_place, off)
        if not checker.verdict(off <= PLACE, f"{where}: {what}: {found} where {own} is expected ({off:.1e})"):
            # At another pose all other results differ too.
            return True
    others = [other for other in path.names if other != name]
    touching = named["brought_to_touch"] and named["touching"] == others
    checker.verdict(touching, f"{where}: {others} is expected to touch too: {named}")
    compare_ratio(checker, linkage, pose, stop, wheel, report["motion_ratios"], where)
    independent, freedom = Independent(moved), report["degrees_of_freedom"]
    expected = independent.freedom
    checker.verdict(freedom == expected, f"{where}: {freedom} degrees of freedom, {expected} are expected")
    mass, own = report["effective_mass"], independent.effective_mass(stop.link, pad, direction)
    off = abs(mass / own - 1) if isinstance(mass, float) else np.inf
    tally.worst_mass = max(tally.worst_mass, off)
    checker.verdict(off <= AT_TOUCH, f"{where}: {mass} where {own} is expected ({off:.1e})")
    if others:
        stops = [linkage.built.stops[stop] for stop in [name, *others]]
        pads = [linkage.point(pose, linkage.group[stop.link], stop.pad) for stop in stops]
        lines = [independent.velocities.moving(s.link, at, normal_at(s, at)) for s, at in zip(stops, pads)]
        jacobian = np.array(lines) @ independent.free
        inverse = jacobian @ np.linalg.solve(independent.mass, jacobian.T)
        impulses = np.linalg.solve(inverse, np.ones(len(stops)))
        own = impulses[0] if (impulses > 0).all() else None
        found = named["effective_mass_together"]
        alike = found is None if own is None else isinstance(found, float) and abs(found / own - 1) <= AT_TOUCH
        checker.verdict(alike, f"{where}: {found} with {others}, {own} is expected")
    stated = report["effective_mass_error"]
    checker.verdict(off <= stated + OWN_ERROR, f"{where}: off by {off:.1e}; the stated error is {stated:.1e}")
    return True


def compare_ratio(checker, linkage, pose, stop, wheel, listed, where):
    """The motion ratio (closing of the stop per upward travel of the wheel) against the inverse `ratio` of own poses, with a rack that stays and a wheel that does not spin: the same in all
    motions of an independent suspension; a solid axle has no such ratio."""
    tally = checker.stops
    _, rows = linkage.closure(pose)
    _, s, vt = np.linalg.svd(rows)
    free = vt[int((s > 1e-9 * s[0]).sum()) :].T
    link, centre = linkage.built.frames[wheel]
    up = np.zeros(linkage.width)
    group = linkage.group[link]
    linkage.add_point(up, pose, group, linkage.point(pose, group, centre), np.array([0.0, 0, 1]))
    rise, closing = up @ free, -linkage.gap(pose, stop)[1] @ free
    ratio = (rise @ closing) / (closing @ closing)
    is_single = np.linalg.norm(rise - ratio * closing) <= RATIO * np.linalg.norm(rise)
    found = next((entry for entry in listed if entry["link"] == wheel and entry["one_travel"]), None)
    if not is_single or found is None:
        # With a massless part the motion of the impact may be undetermined: no ratio is stated.
        checker.verdict(found is None or is_single, f"{where}: motion ratio {found}; the own motions differ")
        return
    off = abs(found["contact_per_wheel"] * ratio - 1)
    tally.ratios, tally.held = tally.ratios + 1, tally.held + (found["held"] is not None)
    tally.worst_ratio = max(tally.worst_ratio, off)
    checker.verdict(off <= RATIO, f"{where}: motion ratio {found}, {ratio} is expected ({off:.1e})")


def compare_alone(checker, file, name, entry, remaining, where):
    """`--at NAME` and the entry of the list: the same mass, or exit code 1 and the gap that remains."""
    code, out, err = checker.run("mass", str(file), "--at", name, "--format", "json")
    message = " ".join(err.split())
    if entry["report"] is not None:
        mass = json.loads(out)["effective_mass"] if code == 0 else np.nan
        expected = entry["report"]["effective_mass"]
        checker.verdict(abs(mass / expected - 1) <= AT_TOUCH, f"{where}: {mass}, {expected} in the list: {message}")
        return
    is_refused = "cannot be reached" in message or "was not reached" in message
    checker.verdict(code == 1 and is_refused, f"{where}: exit code {code}: {message}")
    stated = re.search(r"and ([0-9.]+) (mm|in) remain", message)
    if stated and remaining is not None:
        off = abs({"mm": 1e-3, "in": 0.0254}[stated[2]] * float(stated[1]) - remaining)
        checker.verdict(off <= REMAINING_IN_MESSAGE, f"{where}: {message}; own program: {1e3 * remaining:.3f} mm remain")
