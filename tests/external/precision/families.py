"""Mechanisms, positions and contacts of the fixtures: seeded random short decimals.

A family is {"mechanisms": [rows], "cases": [case]}. A case names its mechanism, the drivers' values (strings), guesses
for the dependent joints (floats, here), the base, and contacts, still without masses.
"""

import math
import random

from mpmath import mp, mpf

MASSES = ["1e-9", "1e-6", "1e-3", "1", "1e3", "1e6", "1e9"]
UPRIGHT = "0 0 1"


def text(x, digits=3):
    return f"{x:.{digits}g}"


class Draw:
    """Seeded random numbers; `random.Random.random` is the same in every version of Python."""

    def __init__(self, *seed):
        self.r = random.Random("percuss/" + "/".join(map(str, seed)))

    def real(self, low, high):
        return low + (high - low) * self.r.random()

    def index(self, n):
        return min(int(self.r.random() * n), n - 1)

    def pick(self, options):
        return options[self.index(len(options))]

    def number(self, low, high, digits=3):
        return text(self.real(low, high), digits)

    def three(self, size, digits=3):
        return " ".join(self.number(-size, size, digits) for _ in range(3))

    def decades(self, low, high):
        return text(10 ** self.real(low, high))

    def direction(self, digits=2):
        while True:
            a = [self.real(-1, 1) for _ in range(3)]
            if 0.3 < math.hypot(*a) < 1:
                return " ".join(text(x, digits) for x in a)

    def height(self):
        """A height that is exact in binary, as are sums of a few heights."""
        return (self.index(17) - 8) / 16

    def inertia(self, mass, size, turned=False):
        """Inertia of a real body: moments from positive second moments."""
        a, b, c = (self.real(0.02, 0.1) for _ in range(3))
        ab, ac, bc = (self.real(-0.3, 0.3) * min(a, b, c) for _ in range(3))
        scale = float(mass) * size * size
        values = [b + c, -ab, -ac, a + c, -bc, a + b]
        row = [mass, self.three(0.3 * size, 2), " ".join(text(scale * x, 2) for x in values)]
        return row + [self.three(3, 2)] if turned else row


def contact(on, point, normal, against=None, world=False, toward=None):
    """Contact row. With `toward`, a link, `normal` is the target point on this link."""
    return {"on": on, "against": against, "point": point, "normal": normal, "world": world, "toward": toward}


def exact(x):
    """Shortest decimal of a double."""
    return repr(float(x))


def plain(height):
    """Exact decimal of a sum of sixteenths."""
    assert float(f"{height:g}") == height
    return f"{height:g}"


def yawed(angle):
    return "" if angle == "0" else f"0 0 {angle}"


MOUNT, CRANK, COUPLER, THIRD = 1, 2, 3, 4


def planar(draw, masses, crank, coupler, third, closure, size, mount=None, root=None, driver=CRANK):
    """root - mount - crank - coupler, mount - third; the last two closed by a hinge.

    Planar in exact arithmetic: heights are exact, every axis is the mount's z or normal to it. crank: (x, y, yaw);
    coupler: (x, y, yaw) in the crank; third: (kind, x, y, yaw, axis); closure: (x, y) in the coupler and in the
    third."""
    z = [draw.height() for _ in range(3)]
    before = draw.height()
    after = z[0] + z[1] + before - z[2]
    links = [root or [], []] + [draw.inertia(m, size) for m in masses]
    where = mount or [draw.three(1), draw.three(3)]
    kind, x, y, yaw, axis = third
    joints = [
        ["f", 0, where[0], UPRIGHT, where[1]],
        ["c", MOUNT, f"{crank[0]} {crank[1]} {plain(z[0])}", UPRIGHT, yawed(crank[2])],
        ["c", CRANK, f"{coupler[0]} {coupler[1]} {plain(z[1])}", UPRIGHT, yawed(coupler[2])],
        [kind, MOUNT, f"{x} {y} {plain(z[2])}", axis, yawed(yaw)],
    ]
    joints[driver - 1].append(1)
    (bx, by), (cx, cy) = closure
    loops = [[COUPLER, f"{bx} {by} {plain(before)}", THIRD, f"{cx} {cy} {plain(after)}", UPRIGHT]]
    return {"links": links, "joints": joints, "loops": loops}


def turned(angle, x, y):
    s, c = math.sin(angle), math.cos(angle)
    return c * x - s * y, s * x + c * y


def moves(rows, case, least):
    """True if every contact moves by more than this (m) along its normal, per rad of the crank (m per m of a
    slider). By differences, which are accurate enough for a choice of contacts."""
    from mechanics import Mechanism, closed
    mechanism = Mechanism(rows)
    driver = next(iter(case["drivers"]))
    value = mpf(float(case["drivers"][driver]))
    step = mpf(10) ** -20
    guess = case["guess"]
    at = closed(mechanism, {driver: value}, guess)
    later = closed(mechanism, {driver: value + step}, {i: at.q[i] for i in guess})
    for c in case["contacts"]:
        p, n = at.touched(c)
        travel = mpf(0)
        for body, sign in [(c["on"], 1), (c["against"], -1)]:
            if body is not None:
                local = [sum(at.r[body][b][a] * (p[b] - at.p[body][b]) for b in range(3)) for a in range(3)]
                there = later.point(body, local)
                travel += sign * sum(n[a] * (there[a] - p[a]) for a in range(3))
        if abs(travel / step) < least:
            return False
    return True


def contacts_on(draw, links, size, pairs=False):
    """A contact on each link; every third contact is between two links."""
    out = [
        contact(link, draw.three(size, 2), draw.direction(), world=draw.r.random() < 0.5) for link in links
    ]
    if pairs:
        on = draw.pick(links)
        other = draw.pick([link for link in links if link != on])
        out.append(contact(on, draw.three(size, 2), draw.direction(), against=other))
    return out


def slider_crank(draw, masses, **more):
    """Case away from dead centres; (rows, case)."""
    while True:
        x, y, yaw = draw.number(-0.3, 0.3), draw.number(-0.3, 0.3), draw.number(-3, 3)
        length, bend = draw.number(0.2, 0.6), draw.number(-2, 2)
        rod = (draw.number(0.4, 1.2), draw.number(-0.3, 0.3))
        tx, ty, ax, ay = draw.number(-0.4, 0.4), draw.number(-0.4, 0.4), draw.number(-1, 1), draw.number(-1, 1)
        pin = (draw.number(-0.2, 0.2), draw.number(-0.2, 0.2))
        theta = draw.number(-3, 3)
        rows = planar(draw, masses, (x, y, yaw), (length, "0", bend), ("p", tx, ty, "0", f"{ax} {ay} 0"),
                      (rod, pin), 0.5, **more)
        sign = draw.pick([1, -1])
        # The crank's pin A, and q with |A - slide(q)| equal to the rod's length.
        yaw, theta, bend, length = float(yaw), float(theta), float(bend), float(length)
        ax, ay = float(ax), float(ay)
        norm = math.hypot(ax, ay)
        if norm < 0.3:
            continue
        ax, ay = ax / norm, ay / norm
        dx, dy = turned(yaw + theta, length, 0)
        pin_x, pin_y = float(x) + dx, float(y) + dy
        rel = pin_x - float(tx) - float(pin[0]), pin_y - float(ty) - float(pin[1])
        along, across = rel[0] * ax + rel[1] * ay, rel[1] * ax - rel[0] * ay
        reach = math.hypot(float(rod[0]), float(rod[1]))
        left = reach * reach - across * across
        if left < 0.3 * reach * reach:
            continue
        q = along + sign * math.sqrt(left)
        end = q * ax - rel[0], q * ay - rel[1]
        angle = math.atan2(end[1], end[0]) - math.atan2(float(rod[1]), float(rod[0])) - yaw - theta - bend
        case = {"drivers": {CRANK: exact(theta)}, "guess": {COUPLER: math.remainder(angle, math.tau), THIRD: q}}
        case["contacts"] = contacts_on(draw, [CRANK, COUPLER, THIRD], 0.3, pairs=draw.index(3) == 0)
        if moves(rows, case, 0.02):
            return rows, case


def four_bar(draw, masses, **more):
    """Case away from change points and limits; (rows, case)."""
    while True:
        x, y = draw.number(-0.3, 0.3), draw.number(-0.3, 0.3)
        tx, ty = draw.number(0.4, 1), draw.number(-0.4, 0.4)
        yaw, bend, twist, theta = (draw.number(-3, 3) for _ in range(4))
        length = draw.number(0.15, 0.7)
        rod = draw.number(0.3, 1), draw.number(-0.3, 0.3)
        arm = draw.number(0.3, 0.8), draw.number(-0.3, 0.3)
        rows = planar(draw, masses, (x, y, yaw), (length, "0", bend), ("c", tx, ty, twist, UPRIGHT),
                      (rod, arm), 0.5, **more)
        sign = draw.pick([1, -1])
        yaw, bend, twist, theta = map(float, (yaw, bend, twist, theta))
        dx, dy = turned(yaw + theta, float(length), 0)
        ax, ay = float(x) + dx, float(y) + dy
        gap = float(tx) - ax, float(ty) - ay
        d = math.hypot(*gap)
        one, two = math.hypot(*map(float, rod)), math.hypot(*map(float, arm))
        cos = (one * one + d * d - two * two) / (2 * one * d)
        # The angle between coupler and rocker must also be well away from 0 and pi.
        other = (one * one + two * two - d * d) / (2 * one * two)
        if abs(cos) > 0.95 or abs(other) > 0.95:
            continue
        heading = math.atan2(gap[1], gap[0]) + sign * math.acos(cos)
        bx, by = ax + one * math.cos(heading), ay + one * math.sin(heading)
        coupler = heading - math.atan2(float(rod[1]), float(rod[0])) - yaw - theta - bend
        rocker = math.atan2(by - float(ty), bx - float(tx)) - math.atan2(float(arm[1]), float(arm[0])) - twist
        guess = {COUPLER: math.remainder(coupler, math.tau), THIRD: math.remainder(rocker, math.tau)}
        case = {"drivers": {CRANK: exact(theta)}, "guess": guess}
        case["contacts"] = contacts_on(draw, [CRANK, COUPLER, THIRD], 0.3, pairs=draw.index(3) == 0)
        if moves(rows, case, 0.02):
            return rows, case


def tree(draw, masses, first=None, root=None):
    """Open tree with a number of links besides the root; (rows, case)."""
    n = len(masses)
    bushy = draw.index(2) == 0
    links, joints, drivers = [root or []], [], {}
    for i, mass in enumerate(masses, 1):
        links.append(draw.inertia(mass, 0.5, turned=draw.index(3) == 0))
        parent = draw.index(i) if bushy else max(0, i - 1 - draw.index(2))
        part = draw.r.random()
        kind = "c" if part < 0.7 or i == 1 else "p" if part < 0.95 else "f"
        place = [draw.three(0.6, 2), draw.three(3, 2)]
        if first and parent == 0:
            place[0] = " ".join(exact(float(a) + float(b)) for a, b in zip(first.split(), place[0].split()))
        joints.append([kind, parent, place[0], draw.direction(), place[1]])
        if kind != "f":
            drivers[i] = draw.number(-3, 3) if kind == "c" else draw.number(-0.5, 0.5)
    on = draw.index(n) + 1
    contacts = [contact(on, draw.three(0.3, 2), draw.direction(), world=draw.index(2) == 0)]
    if n > 1:
        on = draw.index(n) + 1
        other = draw.pick([i for i in range(n + 1) if i != on])
        contacts.append(contact(on, draw.three(0.3, 2), draw.direction(), against=other))
    return {"links": links, "joints": joints}, {"drivers": drivers, "guess": {}, "contacts": contacts}


class Family:
    def __init__(self):
        self.mechanisms, self.cases = [], []

    def mechanism(self, rows):
        self.mechanisms.append(rows)
        return len(self.mechanisms) - 1

    def case(self, group, seed, index, case, floating=False, count=None):
        self.cases.append({"group": group, "seed": seed, "mechanism": index, "floating": floating, "count": count,
                           **case})


def slider_cranks():
    family = Family()
    for seed in range(250):
        draw = Draw("slider-crank", seed)
        rows, case = slider_crank(draw, [draw.pick(MASSES) for _ in range(3)])
        family.case("slider-crank", seed, family.mechanism(rows), case)
    return family


def decades():
    family = Family()
    for seed in range(125):
        draw = Draw("four-bar", seed)
        rows, case = four_bar(draw, [draw.decades(-9, 9) for _ in range(3)])
        family.case("four-bar", seed, family.mechanism(rows), case)
    for seed in range(125):
        draw = Draw("tree", seed)
        floating = draw.index(2) == 0
        root = draw.inertia(draw.decades(-9, 9), 0.5) if floating else None
        rows, case = tree(draw, [draw.decades(-9, 9) for _ in range(1 + draw.index(9))], root=root)
        family.case("tree", seed, family.mechanism(rows), case, floating)
    return family


def chains():
    """Chain of links of 1 m and 1 kg, 5 cm thick."""
    family = Family()
    draw = Draw("chain")
    link = ["1", "0.5 0 0", "0.0003 0 0 0.0834 0 0.0834"]
    for name in ["chain, any axes", "chain, planar"]:
        joints = []
        for i in range(1000):
            axis = UPRIGHT if name == "chain, planar" else draw.direction()
            joints.append(["c", i, "1 0 0" if i else "0 0 0", axis, ""])
        index = family.mechanism({"links": [[], link] + [1] * 999, "joints": joints})
        for n in [10, 30, 100, 300, 1000]:
            for seed in range(10):
                draw = Draw(name, n, seed)
                drivers = {i: f"{draw.real(-3.14, 3.14):.2f}" for i in range(1, n + 1)}
                tip = contact(n, "1 0 0", draw.direction(), world=True)
                middle = contact(n // 2, draw.three(0.5), draw.direction(), world=True)
                both = contact(n, "1 0 0", draw.direction(), against=n // 2)
                case = {"drivers": drivers, "guess": {}, "contacts": [tip, middle, both]}
                family.case(f"{name}, {n:4}", seed, index, case, count=n)
    return family


def engine(draw, length, rod, offset, driver):
    """Crank at the mount's origin, slider along x at y = offset; without yaw, so that dead centres have closed
    forms."""
    masses = [draw.number(0.5, 5) for _ in range(3)]
    return planar(draw, masses, ("0", "0", "0"), (length, "0", "0"), ("p", "0", offset, "0", "1 0 0"),
                  ((rod, "0"), ("0", "0")), 0.5, driver=driver)


def engine_at(rows, theta, driver, sign=1):
    """The engine at the doubles closest to a crank angle (mpf), the rod towards +x (sign 1) or -x."""
    length, rod, offset = (float(rows["joints"][2][2].split()[0]), float(rows["loops"][0][1].split()[0]),
                           float(rows["joints"][3][2].split()[1]))
    if driver == CRANK:
        theta = mpf(float(theta))
    rise = (offset - length * mp.sin(theta)) / mpf(rod)
    heading = mp.asin(rise) if sign > 0 else mp.pi - mp.asin(rise)
    q = length * mp.cos(theta) + rod * mp.cos(heading)
    guess = {CRANK: theta, COUPLER: heading - theta, THIRD: q}
    return {"drivers": {driver: exact(guess.pop(driver))}, "guess": guess}


def half_decades(last):
    return [mpf(10) ** (-mpf(k) / 2) for k in range(2, 2 * last + 1)]


def dead_centres():
    family = Family()
    touched = [
        contact(CRANK, "0.1 0.2 0.1", "0.3 0.9 0.2"),
        contact(COUPLER, "0.3 0.1 0", "0.7 -0.5 0.1"),
        contact(THIRD, "0.1 0.1 0.1", "0.8 0.3 0.2"),
    ]
    # Dead centre of the slider: aligned with the crank (offset 0), or with an offset.
    for seed, (length, rod, offset) in enumerate([("0.3", "0.7", "0"), ("0.35", "0.8", "0.13"), ("0.25", "1.1", "-0.2")]):
        for group, driver in [("dead centre of the slider, crank drives", CRANK),
                              ("dead centre of the slider, slider drives", THIRD)]:
            rows = engine(Draw(group, seed), length, rod, offset, driver)
            index = family.mechanism(rows)
            l, r, e = (mpf(float(x)) for x in (length, rod, offset))
            for near in [True, False]:
                centre = mp.asin(e / (r + l)) if near else mp.pi + mp.asin(e / (r - l))
                for delta in half_decades(7):
                    for side in [1, -1]:
                        if driver == CRANK or side == 1:
                            case = engine_at(rows, centre + side * delta, driver)
                            case["contacts"] = touched
                            case["near"] = side * delta
                            family.case(group, seed, index, case)
    # Dead centre of a crank longer than the rod: the rod is normal to the slide.
    for seed, (length, rod, offset) in enumerate([("0.7", "0.3", "0"), ("0.8", "0.35", "0.13")]):
        group = "dead centre of the crank, crank drives"
        rows = engine(Draw(group, seed), length, rod, offset, CRANK)
        index = family.mechanism(rows)
        l, r, e = (mpf(float(x)) for x in (length, rod, offset))
        for delta in half_decades(7):
            for sign in [1, -1]:
                case = engine_at(rows, mp.asin((e + r) / l) - delta, CRANK, sign)
                case["contacts"] = touched
                case["near"] = delta
                family.case(group, seed, index, case)
    group = "change point of a parallelogram"
    for seed, (ground, crank) in enumerate([("0.8", "0.3"), ("0.4", "0.7")]):
        draw = Draw(group, seed)
        rows = planar(draw, [draw.number(0.5, 5) for _ in range(3)], ("0", "0", "0"), (crank, "0", "0"),
                      ("c", ground, "0", "0", UPRIGHT), ((ground, "0"), (crank, "0")), 0.5)
        index = family.mechanism(rows)
        g, c = mpf(float(ground)), mpf(float(crank))
        for delta in half_decades(5):
            for centre in [mpf(0), mp.pi]:
                for side in [1, -1]:
                    theta = mpf(float(centre + side * delta))
                    # The diagonal is the pin's distance from the rocker's hinge; B is D mirrored in the diagonal, or
                    # opposite.
                    ax, ay = c * mp.cos(theta), c * mp.sin(theta)
                    diagonal = mp.atan2(-ay, g - ax)
                    opened = mp.atan2(0, 1) - theta
                    crossed_heading = 2 * diagonal
                    bx, by = ax + g * mp.cos(crossed_heading), ay + g * mp.sin(crossed_heading)
                    for guess in [
                        {COUPLER: opened, THIRD: theta},
                        {COUPLER: crossed_heading - theta, THIRD: mp.atan2(by, bx - g)},
                    ]:
                        case = {"drivers": {CRANK: exact(theta)}, "guess": guess, "contacts": touched,
                                "near": side * delta}
                        family.case(group, seed, index, case)
    return family


def hubs():
    """The small mechanisms have the first arms of the large mechanism."""
    family = Family()
    for name, floating in [("hub, floating", True), ("hub, hinged", False)]:
        draw = Draw(name)
        hub = draw.inertia("40", 1)
        links, joints = ([hub], []) if floating else ([[], hub], [["c", 0, "0 0 0.2", "0.2 0.3 0.9", ""]])
        centre = len(links) - 1
        for i in range(301):
            # Twenty kinds of arms.
            links.append(draw.inertia(draw.number(0.2, 2), 0.4) if i < 20 else centre + 1 + i % 20)
            joints.append(["c" if draw.index(4) else "p", centre, draw.three(0.5, 2), draw.direction(),
                           draw.three(3, 2)])
        drivers = {i: draw.number(-0.5, 0.5) for i in range(1, len(links))}
        arm = centre + 7
        contacts = [
            contact(centre, draw.three(0.5), draw.direction(), world=True),
            contact(arm, draw.three(0.5), draw.direction(), world=True),
            contact(arm, draw.three(0.5), draw.direction(), against=centre + 200),
        ]
        index = family.mechanism({"links": links, "joints": joints})
        for n in [296, 299, 300, 301]:
            kept = {i: q for i, q in drivers.items() if i <= centre + n}
            case = {"drivers": kept, "guess": {}, "contacts": contacts}
            family.case(name, n, index, case, floating, count=centre + n)
    return family


def far():
    family = Family()
    for k in range(1, 5):
        for seed in range(5):
            for floating in [False, True]:
                base = "floating" if floating else "fixed"
                for name, make in [("slider-crank", slider_crank), ("four-bar", four_bar)]:
                    draw = Draw("far", name, k, seed, base)
                    place = [draw.three(10 ** k, 5), draw.three(3)]
                    root = draw.inertia(draw.number(1, 9), 0.5) if floating and seed % 2 else None
                    rows, case = make(draw, [draw.number(0.5, 5) for _ in range(3)], mount=place, root=root)
                    rows["links"][MOUNT] = draw.inertia(draw.number(1, 9), 0.5)
                    family.case(f"far {name}, {base}, 1e{k} m", seed, family.mechanism(rows), case, floating)
                draw = Draw("far", "tree", k, seed, base)
                first = draw.three(10 ** k, 5)
                root = draw.inertia(draw.number(1, 9), 0.5) if floating else None
                rows, case = tree(draw, [draw.number(0.5, 5) for _ in range(2 + draw.index(6))], first, root)
                family.case(f"far tree, {base}, 1e{k} m", seed, family.mechanism(rows), case, floating)
    return family


def rpy_of(r):
    return mp.atan2(r[2][1], r[2][2]), mp.asin(-r[2][0]), mp.atan2(r[1][0], r[0][0])


def ring(draw, n, spatial, is_round):
    """One loop of n links, the root included; (rows, case). Planar in exact arithmetic, or with axes in all
    directions."""
    from mechanics import Mechanism, Position, about, closure_rows, eliminate, numbers, paths, product, transpose, unit
    last = n - 1
    kinds = min(last, 20)
    links = [[]] + [draw.inertia(draw.number(0.1, 10), 0.3, turned=draw.index(3) == 0) for _ in range(kinds)]
    links += [1 + draw.index(kinds) for _ in range(last - kinds)]
    side = 2 if is_round else 8
    joints, values = [], {}
    for i in range(1, n):
        height = plain(draw.height()) if not spatial else draw.number(-0.3, 0.3)
        place = f"{draw.number(0.2, 1)} {draw.number(-0.1, 0.1)} {height if i > 1 else '0'}"
        axis = draw.direction() if spatial else UPRIGHT
        joints.append(["c", i - 1, place, axis, ""])
        values[i] = f"{2 * math.pi / n + draw.real(-1, 1) / side:.3f}" if is_round else draw.number(-2.5, 2.5)
    rows = {"links": links, "joints": joints, "loops": []}
    doubles = {i: mpf(float(q)) for i, q in values.items()}
    tip = ["0.5", "0.05", "0"]
    if spatial:
        # The last link becomes parallel to the root.
        before = Position(Mechanism(rows), doubles).r[last - 1]
        turn = about(unit(numbers(joints[-1][3])), doubles[last])
        joints[-1][4] = " ".join(exact(x) for x in rpy_of(transpose(product(turn, before))))
    at = Position(Mechanism(rows), doubles)
    end = at.point(last, [mpf(float(x)) for x in tip])
    if not spatial:
        end[2] = sum(mpf(float(j[2].split()[2])) for j in joints)
    rows["loops"] = [[0, " ".join(exact(x) for x in end), last, " ".join(tip), draw.direction() if spatial else UPRIGHT]]
    at = Position(Mechanism(rows), doubles)
    path, columns = paths(at)
    # Heights and rotations out of the plane vanish, except for the rounding of the last link's rotation.
    clear = [[x if abs(x) > mpf(10) ** -12 else mpf(0) for x in row] for row in closure_rows(at, path, columns)[0]]
    pivots, _ = eliminate(clear)
    follows = sorted(k + 1 for _, k in pivots)
    for i in values:
        if i not in follows:
            joints[i - 1].append(1)
    case = {"drivers": {i: q for i, q in values.items() if i not in follows},
            "guess": {i: float(values[i]) for i in follows}}
    on = [1 + draw.index(last) for _ in range(3)]
    other = draw.pick([i for i in range(1, n) if i != on[2]])
    case["contacts"] = [
        contact(on[0], draw.three(0.3, 2), draw.direction(), world=True),
        contact(on[1], draw.three(0.3, 2), draw.direction()),
        contact(on[2], draw.three(0.3, 2), draw.direction(), against=other),
    ]
    return rows, case


def rings(sizes=((10, 4), (40, 4), (90, 2), (300, 1))):
    family = Family()
    for spatial in [False, True]:
        for is_round in [True, False]:
            for n, seeds in sizes:
                group = f"ring, {'any axes' if spatial else 'planar'}, {'round' if is_round else 'crumpled'}, {n:4}"
                for seed in range(seeds):
                    rows, case = ring(Draw(group, seed), n, spatial, is_round)
                    family.case(group, seed, family.mechanism(rows), case)
    return family


def powers(first, last):
    return [f"1e{k}" for k in range(first, last - 1, -1)]


def carried(draw, between, last, joints, beside):
    """A link on a hinge, and a heavy link attached to it by joints in series with nearly massless links: (rows,
    contacts). The contact is on the first link, or also on the last link unless the series is off the contact path."""
    links = [[], draw.inertia(draw.number(0.5, 5), 0.5)] + [between] * (len(joints) - 1) + [last]
    rows = [["c", 0, draw.three(0.5), draw.direction(), draw.three(3)]]
    rows += [[kind, i, place, axis, turn] for i, (kind, place, axis, turn) in enumerate(joints, 1)]
    contacts = [contact(1, draw.three(0.3), draw.direction())]
    if not beside:
        n = len(joints) + 1
        contacts += [contact(n, draw.three(0.3), draw.direction()),
                     contact(n, draw.three(0.3), draw.direction(), against=1),
                     contact(n, draw.three(0.3), draw.three(0.5), against=1, toward=1)]
    return {"links": links, "joints": rows}, contacts


def pivots():
    """Small pivots that transmit sums of large terms; contacts with little resistance; lines."""
    family = Family()
    for beside in [True, False]:
        side = "beside" if beside else "behind"
        for delta in powers(-1, -7):
            for seed in range(8):
                light = [[], draw_light(seed, delta)][seed % 2]
                # Three hinges that form a ball joint; the ball locks at zero angle of the middle hinge.
                group = f"{side} a ball's lock"
                draw = Draw(group, delta, seed)
                heavy = draw.inertia(draw.pick(["1", "30", "1e3"]), 0.5)
                place, turn = draw.three(0.5), draw.three(3)
                joints = [("c", place, UPRIGHT, turn), ("c", "0 0 0", "0 1 0", ""), ("c", "0 0 0", UPRIGHT, "")]
                rows, contacts = carried(draw, light, heavy, joints, beside)
                drivers = {1: draw.number(-3, 3), 2: draw.number(-3, 3), 3: delta, 4: draw.number(-3, 3)}
                case = {"drivers": drivers, "guess": {}, "contacts": contacts, "near": mpf(delta)}
                family.case(group, seed, family.mechanism(rows), case)
                # Two slides that are nearly parallel.
                group = f"{side} two slides"
                draw = Draw(group, delta, seed)
                heavy = draw.inertia(draw.pick(["1", "30", "1e3"]), 0.5)
                joints = [("p", draw.three(0.5), "1 0 0", draw.three(3)), ("p", draw.three(0.5), f"1 {delta} 0", "")]
                rows, contacts = carried(draw, light, heavy, joints, beside)
                drivers = {1: draw.number(-3, 3), 2: draw.number(-0.5, 0.5), 3: draw.number(-0.5, 0.5)}
                case = {"drivers": drivers, "guess": {}, "contacts": contacts, "near": mpf(delta)}
                family.case(group, seed, family.mechanism(rows), case)
    for part in powers(-1, -12):
        for seed in range(6):
            group = "light feeler"
            draw = Draw(group, part, seed)
            links = [[], draw.inertia(draw.number(1, 9), 0.5), draw.inertia(part, 0.3)]
            joints = [["c", 0, draw.three(0.5), draw.direction(), draw.three(3)],
                      ["c", 1, draw.three(0.5), draw.direction(), draw.three(3)]]
            contacts = [contact(2, draw.three(0.3), draw.direction()), contact(1, draw.three(0.3), draw.direction()),
                        contact(2, draw.three(0.3), draw.direction(), against=1),
                        contact(2, draw.three(0.3), draw.three(0.3), against=1, toward=1)]
            case = {"drivers": {1: draw.number(-3, 3), 2: draw.number(-3, 3)}, "guess": {}, "contacts": contacts}
            family.case(group, seed, family.mechanism({"links": links, "joints": joints}), case)
            # A rolling needle: its own moment is a small fraction of the other moments; and a needle with a small
            # offset.
            group = "rolling needle"
            draw = Draw(group, part, seed)
            aside = part if seed % 2 else "0"
            needle = ["2", f"{draw.number(0.2, 0.5)} {aside} 0", f"{part} 0 0 0.2 0 0.2"]
            links = [[], draw.inertia(draw.number(1, 9), 0.5), needle]
            joints = [["c", 0, draw.three(0.5), draw.direction(), draw.three(3)],
                      ["c", 1, draw.three(0.5), "1 0 0", draw.three(3)]]
            contacts = [contact(2, "0.3 0.1 0", "0 0 1"), contact(2, f"0.4 {part} 0", "0 0.3 1"),
                        contact(1, draw.three(0.3), draw.direction())]
            case = {"drivers": {1: draw.number(-3, 3), 2: draw.number(-3, 3)}, "guess": {}, "contacts": contacts}
            family.case(group, seed, family.mechanism({"links": links, "joints": joints}), case)
    for seed in range(40):
        for group, make in [("slider-crank along a line", slider_crank), ("four-bar along a line", four_bar)]:
            draw = Draw(group, seed)
            rows, case = make(draw, [draw.decades(-9, 9) for _ in range(3)])
            case["contacts"] = []
            for on, to in [(CRANK, THIRD), (COUPLER, MOUNT), (THIRD, COUPLER)]:
                against = draw.pick([None, to])
                case["contacts"].append(contact(on, draw.three(0.3), draw.three(0.5), against=against, toward=to))
            if moves(rows, case, 0.02):
                family.case(group, seed, family.mechanism(rows), case)
        group = "tree along a line"
        draw = Draw(group, seed)
        n = 2 + draw.index(8)
        rows, case = tree(draw, [draw.decades(-9, 9) for _ in range(n)])
        on = draw.index(n) + 1
        to = draw.pick([i for i in range(n + 1) if i != on])
        short = 10 ** -draw.real(0, 3)
        case["contacts"] = [contact(on, draw.three(short), draw.three(short), against=draw.pick([None, to]), toward=to)]
        family.case(group, seed, family.mechanism(rows), case)
        # Nearly parallel axes with light links between them.
        group = "tree of axes alike"
        draw = Draw(group, seed)
        rows, case = tree(draw, [draw.decades(-9, 9) for _ in range(2 + draw.index(8))])
        common, size = [draw.real(-1, 1) for _ in range(3)], 10 ** -draw.real(1, 6)
        for row in rows["joints"]:
            row[3] = " ".join(f"{c + draw.real(-size, size):.8f}" for c in common)
            row[4] = ""
        for i in case["drivers"]:
            case["drivers"][i] = f"{draw.real(-size, size):.8f}"
        family.case(group, seed, family.mechanism(rows), case)
    return family


def draw_light(seed, delta):
    """A link of 1e-12 to 1e-3 kg."""
    draw = Draw("light", seed, delta)
    return draw.inertia(draw.decades(-12, -3), 0.2)


def rings_1000():
    return rings([(1000, 1)])


FAMILIES = {
    "slider_cranks": slider_cranks,
    "decades": decades,
    "chains": chains,
    "dead_centres": dead_centres,
    "hubs": hubs,
    "far": far,
    "rings": rings,
    "rings_1000": rings_1000,
    "pivots": pivots,
}
