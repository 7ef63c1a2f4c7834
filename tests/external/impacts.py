"""Impacts with friction and with several contacts compared with an independent program.

    impacts.py --percuss PATH [--count N] [--seed S]     prints `N passed, N failed`

Random planar arms and free bodies. The mobility of the contact points is computed here from the Jacobians and mass matrices of the textbook. A
planar impact with friction is followed in exact rational arithmetic from event to event; only the end of the expansion needs a
square root. An impact in space and one of several contacts are integrated by the classical Runge-Kutta method with a small step. No
code and no method is shared with percuss.
"""

import argparse
import json
import math
import random
import subprocess
import sys
import tempfile
from fractions import Fraction
from pathlib import Path

import numpy as np

BODY = """<robot name="b"><link name="body"><inertial><mass value="{m}"/>
<inertia ixx="{a}" iyy="{b}" izz="{c}" ixy="0" ixz="0" iyz="0"/></inertial></link></robot>"""
# Rounding of percuss and of the text of its input.
EXACT = 1e-10
# Error of the Runge-Kutta method with the steps below.
INTEGRATED = 1e-6


def run(percuss, model, *flags):
    command = [percuss, "impact", str(model), *flags, "--format", "json"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(command)}\n{done.stderr}")
    return json.loads(done.stdout)


def exact_planar(nn, nt, tt, un, ut, mu, e):
    """Impulse (normal, tangential) of Stronge's law. All arguments are fractions."""
    start = un
    pn, pt, work, compression = Fraction(0), Fraction(0), Fraction(0), None
    while True:
        if ut != 0:
            ratio = -mu if ut > 0 else mu
        elif abs(nt) <= mu * tt:
            ratio = -nt / tt
        else:
            ratio = -mu if nt > 0 else mu
        alpha, beta = nn + nt * ratio, nt + tt * ratio
        if ut == 0 and abs(nt) <= mu * tt:
            beta = Fraction(0)
        stops = -ut / beta if ut * beta < 0 else None
        if compression is None:
            ends = -un / alpha if alpha > 0 else None
            step = min(s for s in (stops, ends) if s is not None)
        else:
            wanted = float(-e * e * compression - (work - compression))
            if wanted <= 0:
                return float(pn), float(pt)
            last = 2 * wanted / (float(un) + math.sqrt(float(un * un) + 2 * float(alpha) * wanted))
            if stops is None or last <= stops:
                return float(pn) + last, float(pt) + float(ratio) * last
            step = stops
        pn, pt = pn + step, pt + ratio * step
        work += un * step + alpha * step * step / 2
        un, ut = un + alpha * step, Fraction(0) if stops is not None and step == stops else ut + beta * step
        if compression is None and un == 0:
            compression = work
        assert abs(un) < 1000 * abs(start)


def planar_arm(rng, percuss, folder):
    """Arm of two uniform rods in the plane: exact process."""
    l1, l2, m1, m2 = (Fraction(rng.randint(20, 90), 100) for _ in range(4))
    half = Fraction(1, 2)
    model = folder / "arm.urdf"
    rod = '<link name="{n}"><inertial><origin xyz="{h} 0 0"/><mass value="{m}"/><inertia ixx="0" iyy="{i}" izz="{i}" ixy="0" ixz="0" iyz="0"/></inertial></link>'
    joint = '<joint name="{n}" type="continuous"><parent link="{p}"/><child link="{c}"/><origin xyz="{x} 0 0"/><axis xyz="0 0 1"/></joint>'
    model.write_text(
        '<robot name="a"><link name="ground"/>'
        + rod.format(n="inner", h=float(l1 / 2), m=float(m1), i=repr(float(m1 * l1 * l1 / 12)))
        + rod.format(n="outer", h=float(l2 / 2), m=float(m2), i=repr(float(m2 * l2 * l2 / 12)))
        + joint.format(n="shoulder", p="ground", c="inner", x=0)
        + joint.format(n="elbow", p="inner", c="outer", x=float(l1))
        + "</robot>"
    )
    # Absolute angles 0 and b; the sines are those of the floating-point angle.
    b = rng.uniform(0.3, 2.8)
    sb, cb = Fraction(math.sin(b)), Fraction(math.cos(b))
    w1, w2 = Fraction(rng.randint(-30, 30), 10), Fraction(rng.randint(-30, 30), 10)
    # Mass matrix over absolute rates; velocity of the tip.
    a11, a22, a12 = m1 * l1 * l1 / 3 + m2 * l1 * l1, m2 * l2 * l2 / 3, m2 * l1 * l2 * half * cb
    jx, jy = (Fraction(0), -l2 * sb), (l1, l2 * cb)
    det = a11 * a22 - a12 * a12
    inverse = ((a22 / det, -a12 / det), (-a12 / det, a11 / det))

    def form(p, q):
        return sum(p[i] * inverse[i][j] * q[j] for i in range(2) for j in range(2))

    w, ww = (w1, w2), lambda j: j[0] * w1 + j[1] * w2
    # The surface is below (normal −y out of the link) or above.
    sign = 1 if ww(jy) < 0 else -1
    if abs(ww(jy)) < Fraction(1, 100):
        return None
    jn = tuple(sign * x for x in jy)
    mu, e = Fraction(rng.randint(0, 20), 10), Fraction(rng.randint(0, 10), 10)
    expected = exact_planar(form(jn, jn), form(jn, jx), form(jx, jx), ww(jn), ww(jx), mu, e)
    report = run(
        percuss, model, "--link", "outer", "--point", f"{float(l2)},0,0", "--normal", f"0,{-sign},0",
        "--set", f"elbow={b!r}", "--restitution", str(float(e)), "--friction", str(float(mu)),
        "--rates", f"shoulder={float(w[0])}", "--rates", f"elbow={float(w[1] - w[0])!r}", "--normal-frame", "world",
    )
    found = (report["impulse"], report["friction"]["tangential_impulse_world"][0])
    size = math.hypot(*expected)
    return max(abs(a - b) for a, b in zip(found, expected)) / size, EXACT


def body_mobility(m, inertia, points):
    """W of points of a free body with its centre at the origin: three rows each, world axes."""
    rows = []
    for r in points:
        cross = np.array([[0, -r[2], r[1]], [r[2], 0, -r[0]], [-r[1], r[0], 0]])
        rows.append(np.hstack([np.eye(3), -cross]))
    j = np.vstack(rows)
    return j @ np.diag([1 / m] * 3 + [1 / i for i in inertia]) @ j.T, j


def free_body(rng, folder):
    m = rng.uniform(1, 5)
    inertia = [rng.uniform(0.2, 0.35) for _ in range(3)]
    model = folder / "body.urdf"
    model.write_text(BODY.format(m=repr(m), a=repr(inertia[0]), b=repr(inertia[1]), c=repr(inertia[2])))
    return model, m, inertia


def spatial(rng, percuss, folder):
    """Free body with friction in space."""
    model, m, inertia = free_body(rng, folder)
    r = np.array([rng.uniform(-0.5, 0.5) for _ in range(3)])
    w, j = body_mobility(m, inertia, [r])
    twist = np.array([rng.uniform(-1, 1) for _ in range(6)])  # linear, angular
    twist[2] = -3
    u = j @ twist
    mu, e = rng.uniform(0.05, 0.5), rng.uniform(0.1, 1)
    if u[2] > -0.3:
        return None

    def rate(v):
        s = np.append(-mu * v[:2] / np.hypot(*v[:2]), 1.0)
        return w @ s, s

    def step(v, h):
        a, pa = rate(v)
        b, pb = rate(v + h / 2 * a)
        c, pc = rate(v + h / 2 * b)
        d, pd = rate(v + h * c)
        return v + h / 6 * (a + 2 * b + 2 * c + d), h / 6 * (pa + 2 * pb + 2 * pc + pd), h * v[2] + h * h / 6 * (a + b + c)[2]

    h, p, work, compression = -u[2] / w[2, 2] / 3000, np.zeros(3), 0.0, None
    while True:
        if np.hypot(*u[:2]) < 0.02:
            return None
        v, dp, dw = step(u, h)
        if compression is None and v[2] < 0 or compression is not None and work + dw < -e * e * compression:
            u, p, work = v, p + dp, work + dw
            continue
        low, high = 0.0, h
        for _ in range(60):
            mid = (low + high) / 2
            v, dp, dw = step(u, mid)
            before = v[2] < 0 if compression is None else work + dw < -e * e * compression
            low, high = (mid, high) if before else (low, mid)
        v, dp, dw = step(u, high)
        u, p = v, p + dp
        if compression is not None:
            break
        compression, work = work + dw, 0.0
    report = run(
        percuss, model, "--base", "floating", "--link", "body", "--point", ",".join(map(repr, r.tolist())), "--normal", "0,0,-1",
        "--restitution", repr(e), "--friction", repr(mu),
        "--base-twist=" + ",".join(map(repr, [*twist[3:].tolist(), *twist[:3].tolist()])),
    )
    found = np.array([*report["friction"]["tangential_impulse_world"][:2], report["impulse"]])
    return np.abs(found - p).max() / np.abs(p).max(), INTEGRATED


def several(rng, percuss, folder):
    """Free body on two or three points without friction, energetic law with stiffness ratios."""
    model, m, inertia = free_body(rng, folder)
    k = rng.choice([2, 3])
    points = [np.array([rng.uniform(-0.5, 0.5), rng.uniform(-0.5, 0.5), -0.2]) for _ in range(k)]
    w = body_mobility(m, inertia, points)[0][2::3, 2::3]
    e, eta = rng.uniform(0.3, 1), rng.choice([1.0, 1.5])
    ratios = [1.0] + [rng.uniform(0.3, 3) for _ in range(k - 1)]
    u0 = -np.ones(k)

    def rates(depth, p):
        u = u0 + w @ p
        change = np.where(u < 0, -u, np.where(depth > 0, -u / e**2, 0))
        return change, np.array(ratios) * np.maximum(depth, 0) ** eta

    depth, p = np.zeros(k), np.zeros(k)
    h = 2e-4 / math.sqrt(w.max())
    for _ in range(400000):
        a = rates(depth, p)
        b = rates(depth + h / 2 * a[0], p + h / 2 * a[1])
        c = rates(depth + h / 2 * b[0], p + h / 2 * b[1])
        d = rates(depth + h * c[0], p + h * c[1])
        depth = np.maximum(depth + h / 6 * (a[0] + 2 * b[0] + 2 * c[0] + d[0]), 0)
        p = p + h / 6 * (a[1] + 2 * b[1] + 2 * c[1] + d[1])
        if (depth == 0).all() and (u0 + w @ p >= -1e-9).all():
            break
    also = [x for r in points[1:] for x in ("--also", f"body:{','.join(map(repr, r.tolist()))}:0,0,-1")]
    report = run(
        percuss, model, "--base", "floating", "--link", "body", "--point", ",".join(map(repr, points[0].tolist())),
        "--normal", "0,0,-1", "--restitution", repr(e), "--base-twist", "0,0,0,0,0,-1", *also,
        "--stiffness-ratio", ",".join(map(repr, ratios)), "--contact-exponent", repr(eta),
    )
    law = next(law for law in report["simultaneous"]["laws"] if law["law"] == "energetic")
    # The kink at the end of each contact limits the plain method.
    return np.abs(np.array(law["impulses"]) - p).max() / np.abs(p).max(), 1e-4


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--percuss", required=True)
    parser.add_argument("--count", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    rng = random.Random(options.seed)
    passed = failed = 0
    worst = {}
    with tempfile.TemporaryDirectory() as name:
        for case in (planar_arm, spatial, several):
            count = max(2, options.count // 5) if case is several else options.count
            done = 0
            while done < count:
                result = case(rng, options.percuss, Path(name))
                if result is None:
                    continue
                done += 1
                error, limit = result
                worst[case.__name__] = max(worst.get(case.__name__, 0), error)
                passed += error < limit
                failed += not error < limit
                if not error < limit:
                    print(f"{case.__name__}: {error:.1e}", file=sys.stderr)
    print(", ".join(f"{name} {error:.1e}" for name, error in worst.items()))
    print(f"{passed} passed, {failed} failed")
    sys.exit(failed > 0)


if __name__ == "__main__":
    main()
