"""Spatial linkages without a redundant row: chains of hinges and slides with axes in all directions, closed by balls
and held by rods."""

from mpmath import mp, mpf

import families
from families import Draw, Family, contact, exact
from mechanics import Mechanism, Position, apply, closure_rows, eliminate, paths, sub, transpose

SEEDS = 30


def chain(draw, links, joints, values, carrier, count, mass):
    """Appends links in series to a base link; returns the last."""
    for _ in range(count):
        links.append(draw.inertia(mass(), 0.3, turned=draw.index(3) == 0))
        kind = "p" if draw.index(4) == 0 else "c"
        place = f"{draw.number(0.2, 0.6)} {draw.number(-0.2, 0.2)} {draw.number(-0.2, 0.2)}"
        joints.append([kind, carrier, place, draw.direction(), draw.three(3) if draw.index(2) else ""])
        carrier = len(links) - 1
        values[carrier] = draw.number(-0.2, 0.2) if kind == "p" else draw.number(-2, 2)
    return carrier


def linkage(draw, decades, rods):
    """A chain from the root with a ball on the root at its end; with rods, one or two branches whose ends are held
    by rods."""
    def mass():
        return draw.decades(-decades, decades) if decades else draw.number(0.2, 5)

    links, joints, values = [[]], [], {}
    last = chain(draw, links, joints, values, 0, 4 + draw.index(3), mass)
    held = [(0, last, draw.three(0.3), False)]
    for _ in range(rods):
        end = chain(draw, links, joints, values, 1 + draw.index(last), 1 + draw.index(2), mass)
        on = draw.pick([i for i in range(len(links)) if i != end])
        held.append((on, end, draw.three(0.4), True))
    rows = {"links": links, "joints": joints, "loops": []}
    at = Position(Mechanism(rows), {i: mpf(float(q)) for i, q in values.items()})
    for one, two, place, is_rod in held:
        end = at.point(two, [mpf(float(x)) for x in place.split()])
        if is_rod:
            there = draw.three(0.4)
            gap = sub(end, at.point(one, [mpf(float(x)) for x in there.split()]))
            length = mp.sqrt(sum((x * x for x in gap), mpf(0)))
            if length < 0.1:
                return None
            rows["loops"].append([one, there, two, place, exact(length)])
        else:
            there = apply(transpose(at.r[one]), sub(end, at.p[one]))
            rows["loops"].append([one, " ".join(exact(x) for x in there), two, place, ""])
    at = Position(Mechanism(rows), at.q)
    found, columns = paths(at)
    pivots, reduced = eliminate(closure_rows(at, found, columns)[0])
    # Singular poses, additional rows and other branches belong to other families.
    if len(pivots) < 3 + rods or max(abs(x) for row in reduced for x in row) > 30:
        return None
    follows = sorted(k + 1 for _, k in pivots)
    for i in values:
        if i not in follows:
            joints[i - 1].append(1)
    case = {"drivers": {i: q for i, q in values.items() if i not in follows},
            "guess": {i: float(values[i]) for i in follows}}
    on = [1 + draw.index(len(links) - 1) for _ in range(3)]
    other = draw.pick([i for i in range(1, len(links)) if i != on[2]])
    case["contacts"] = [
        contact(on[0], draw.three(0.3, 2), draw.direction(), world=True),
        contact(on[1], draw.three(0.3, 2), draw.direction()),
        contact(on[2], draw.three(0.3, 2), draw.direction(), against=other),
        contact(on[2], draw.three(0.3, 2), draw.three(0.5), against=other, toward=other),
    ]
    return rows, case


def linkages():
    family = Family()
    for name, decades in [("of one size", 0), ("masses over 8 decades", 4)]:
        for rods in range(3):
            for floating in [False, True]:
                group = f"ball and {rods} rods, {name}, {'floating' if floating else 'fixed'}"
                for seed in range(SEEDS if not floating else SEEDS // 3):
                    draw = Draw(group, seed)
                    made = linkage(draw, decades, rods)
                    if made is None:
                        continue
                    rows, case = made
                    if floating:
                        rows["links"][0] = draw.inertia(draw.number(1, 9), 0.5)
                    family.case(group, seed, family.mechanism(rows), case, floating)
    return family


FAMILIES = {**families.FAMILIES, "spatial": linkages}
