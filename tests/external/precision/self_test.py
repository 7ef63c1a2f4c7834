"""Tests of the reference program: closed forms, other equations, and more digits."""

from mpmath import mp, mpf

import mechanics
from families import COUPLER, CRANK, THIRD, Draw, contact
from mechanics import Mechanism, Position, by_bodies, by_joints, by_recursion, closed, masses
from spatial import FAMILIES


def near(what, got, expected, digits=60):
    error = abs(got / expected - 1)
    assert error < mpf(10) ** -digits, f"{what}: {mp.nstr(got, 30)}, expected {mp.nstr(expected, 30)}"


def pendulum():
    """m (r_A/r_B)^2, and J_O/r_B^2."""
    point = {"links": [[], ["2", "0 0 -0.5", "0 0 0 0 0 0"]], "joints": [["c", 0, "1 2 3", "0 1 0", "0.3 0 0"]]}
    at = Position(Mechanism(point), {1: mpf(float("0.7"))})
    touched = [contact(1, "0 0 -0.75", "1 0 0")]
    for way in (by_recursion, by_joints):
        near("point pendulum", way(at, touched)[0], mpf(2) * (mpf("0.5") / mpf("0.75")) ** 2)
    body = {"links": [[], ["3", "0.25 0 0.5", "0.5 0 0 0.75 0 0.5"]], "joints": [["c", 0, "1 2 3", "0 1 0", "0 1 0"]]}
    at = Position(Mechanism(body), {1: mpf(2)})
    touched = [contact(1, "0 0 0.5", "3 0 0")]
    for way in (by_recursion, by_joints, by_bodies):
        near("pendulum", way(at, touched)[0], (mpf("0.75") + 3 * (mpf("0.25") ** 2 + mpf("0.5") ** 2)) / mpf("0.25"))


def central_impact():
    """Two free bodies: m1 m2 / (m1 + m2). The second body is on three slides of a massless chain."""
    sphere = ["3", "0 0 0", "0.5 0 0 0.5 0 0.5"]
    rows = {
        "links": [sphere, [], [], ["5", "0 0 0", "0.25 0 0 0.25 0 0.25"]],
        "joints": [["p", i, "0 0 0", axis, ""] for i, axis in enumerate(["1 0 0", "0 1 0", "0 0 1"])],
    }
    at = Position(Mechanism(rows), {1: mpf(1) / 2, 2: mpf(1), 3: mpf(-2)}, floating=True)
    # Line through both centres: relative to the centre (0.5, 1, -2), the other centre is at the negative of this
    # vector.
    for way in (by_recursion, by_joints, by_bodies):
        near("central impact", way(at, [contact(3, "0 0 0", "0.5 1 -2", against=0)])[0], mpf(15) / 8)
        # A force at its centre does not turn the body, and its passenger, which slides in any direction, does not
        # contribute.
        near("a free body", way(at, [contact(0, "0 0 0", "0.3 0.4 0.1")])[0], mpf(3))


def crank_formula():
    """Twice the energy per unit speed of the slider, from derivatives by hand."""
    l, r, theta = mpf(float("0.3")), mpf(float("0.7")), mpf(float("0.9"))
    rows = {
        "links": [[], [], ["2", "0.15 0.05 0", "1 0 0 1 0 0.25"], ["3", "0.3 0.1 0", "1 0 0 1 0 0.5"],
                  ["4", "0.1 0.2 0", "1 0 0 1 0 0.75"]],
        "joints": [["f", 0, "3 1 2", "0 0 1", "0.4 1.1 -0.6"], ["c", 1, "0 0 0", "0 0 1", ""],
                   ["c", 2, "0.3 0 0", "0 0 1", ""], ["p", 1, "0 0 0", "1 0 0", ""]],
        "loops": [[3, "0.7 0 0", 4, "0 0 0", "0 0 1"]],
    }
    phi = mp.asin(-l * mp.sin(theta) / r)
    at = closed(Mechanism(rows), {CRANK: theta}, {COUPLER: phi - theta, THIRD: l * mp.cos(theta) + r * mp.cos(phi)})
    turn = -l * mp.cos(theta) / (r * mp.cos(phi))
    slide = -l * mp.sin(theta) - r * mp.sin(phi) * turn
    a, b = mpf(float("0.15")), mpf(float("0.05"))
    energy = mpf("0.25") + 2 * (a * a + b * b)
    a, b = mpf(float("0.3")), mpf(float("0.1"))
    vx = -l * mp.sin(theta) + turn * (-a * mp.sin(phi) - b * mp.cos(phi))
    vy = l * mp.cos(theta) + turn * (a * mp.cos(phi) - b * mp.sin(phi))
    energy += mpf("0.5") * turn ** 2 + 3 * (vx * vx + vy * vy) + 4 * slide ** 2
    touched = [contact(THIRD, "0.3 0.2 0.1", "1 0 0"), contact(CRANK, "0.25 0 0", "0 1 0")]
    for way in (by_joints, by_bodies):
        got = way(at, touched)
        near("slider", got[0], energy / slide ** 2)
        near("crank", got[1], energy / mpf("0.25") ** 2)


def other_equations(position):
    """Samples of the families: other equations, and 50 % more digits."""
    count = 0
    for name, make in FAMILIES.items():
        if name == "rings_1000":
            # Like the smaller rings, but a minute per sample.
            continue
        family = make()
        sample = [c for i, c in enumerate(family.cases) if i % (7 if name == "far" else 23) == 0]
        worst_second = worst_digits = mpf(0)
        ways = set()
        for case in sample:
            rows, contacts = family.mechanisms[case["mechanism"]], case["contacts"]
            at = position(rows, case)
            first = masses(at, contacts)
            bodies = len(at.mechanism.bodies)
            seconds = []
            if bodies <= 13:
                seconds.append(by_bodies)
            if not at.mechanism.loops and bodies <= 31:
                seconds.append(by_joints)
            for way in seconds:
                ways.add(way.__name__)
                for a, b in zip(first, way(at, contacts)):
                    assert (a is None) == (b is None)
                    if a is not None:
                        worst_second = max(worst_second, abs(a / b - 1))
            usual = mp.dps
            mp.dps = usual * 3 // 2
            for a, b in zip(first, masses(position(rows, case), contacts)):
                if a is not None:
                    worst_digits = max(worst_digits, abs(a / b - 1))
            mp.dps = usual
            count += len(contacts)
        print(f"{name}: {len(sample)} cases, other equations ({', '.join(sorted(ways)) or 'none'}) within "
              f"{mp.nstr(worst_second, 2)}, more digits within {mp.nstr(worst_digits, 2)}", flush=True)
        assert worst_second < mpf(10) ** -40 and worst_digits < mpf(10) ** -40
    print(f"{count} contacts")


def large_hub():
    """The recursion compared with the dense equations for many arms."""
    draw = Draw("self-test hub")
    rows = {"links": [draw.inertia("40", 1)], "joints": []}
    for _ in range(40):
        rows["links"].append(draw.inertia("1", 0.4))
        rows["joints"].append(["c", 0, draw.three(0.5), draw.direction(), draw.three(3)])
    at = Position(Mechanism(rows), {i: mpf(draw.real(-1, 1)) for i in range(1, 41)}, floating=True)
    touched = [contact(0, "0.1 0.2 0.3", "1 2 3"), contact(7, "0.1 0.2 0.3", "1 2 3", against=30)]
    for a, b in zip(by_recursion(at, touched), by_joints(at, touched)):
        near("hub", a, b)


def conditions(position):
    """Condition of m with respect to small relative changes of all numbers: a lower bound of the error of any double
    arithmetic."""
    draw = Draw("conditions")
    usual, size = mechanics.numbers, mpf(10) ** -40

    def wobbling(text):
        # Zeros, ones and the heights of planar linkages are kept, so that the linkages remain planar.
        return [x if x * 16 == int(x * 16) else x * (1 + size * draw.real(-1, 1)) for x in usual(text)]

    for name, make in FAMILIES.items():
        if name == "rings_1000":
            # Like the smaller rings, but a minute per sample.
            continue
        family, groups = make(), {}
        for i, case in enumerate(family.cases):
            if case["count"] is not None and case["count"] > 300 or name == "dead_centres" and i % 5:
                continue
            rows = family.mechanisms[case["mechanism"]]
            first = masses(position(rows, case), case["contacts"])
            worst = [mpf(0)] * len(first)
            for _ in range(3):
                mechanics.numbers = wobbling
                drivers = {i: mpf(float(q)) * (1 + size * draw.real(-1, 1)) for i, q in case["drivers"].items()}
                other = masses(position(rows, {**case, "drivers": drivers}), case["contacts"])
                mechanics.numbers = usual
                worst = [max(w, abs(b / a - 1) / size) if a else w for w, a, b in zip(worst, first, other)]
            groups.setdefault(case["group"], []).extend(worst)
        for group, all_of_it in groups.items():
            all_of_it.sort()
            print(f"{group}: median {mp.nstr(all_of_it[len(all_of_it) // 2], 2)}, most {mp.nstr(all_of_it[-1], 2)}",
                  flush=True)


def run(position):
    for test in (pendulum, central_impact, crank_formula, large_hub):
        test()
        print(f"{test.__name__}: as it should be")
    other_equations(position)
