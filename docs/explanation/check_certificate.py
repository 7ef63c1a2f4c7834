"""Checks the proof of `percuss extremes MODEL … --certify TOLERANCE --format json` without percuss: python3 check_certificate.py report.json

All bounds are computed again, with outward rounding: m̄ at the two best positions, and one bound for each box of the divisions. Exit code
1 and a reason if a bound of the report is not proved. Equations: docs/explanation/CERTIFICATES.md. Trees only.
"""
import json, math, sys
from fractions import Fraction

BITS = 120
QUARTER = Fraction("1.57079632679489661923132169163975144209858469968755291")  # π/2, 54 digits

class I:  # interval with outward rounding
    def __init__(self, lo, hi=None):
        self.lo, self.hi = lo, lo if hi is None else hi

    def __add__(self, o):
        o = o if isinstance(o, I) else I(o)
        return out(self.lo + o.lo, self.hi + o.hi)

    def __mul__(self, o):
        o = o if isinstance(o, I) else I(o)
        return out(self.lo * o.lo, self.lo * o.hi, self.hi * o.lo, self.hi * o.hi)

    __radd__, __rmul__ = __add__, __mul__
    def __neg__(self): return I(-self.hi, -self.lo)
    def __sub__(self, o): return self + -o
    def __rsub__(self, o): return -self + o
    def mag(self): return max(abs(self.lo), abs(self.hi))

def out(*values):  # hull of rounded numbers, rounded outward
    if any(math.isnan(x) for x in values): return I(-math.inf, math.inf)
    return I(math.nextafter(min(values), -math.inf), math.nextafter(max(values), math.inf))

def sin_cos_at(x):  # of a float, as intervals: fixed point with 120 bits, error below 2^-100
    k = round(Fraction(x) / QUARTER)
    r = int((Fraction(x) - k * QUARTER) * (1 << BITS))
    values, term, n = [0, 0], 1 << BITS, 0
    while term and n < 60:
        values[n % 2] += term if n % 4 < 2 else -term
        n += 1
        term = (term * r >> BITS) // n
    c, s = (out(float(Fraction(v, 1 << BITS))) for v in values)
    return [(s, c), (c, -s), (-s, -c), (-c, s)][k % 4]

def sin_cos(x):
    if not isinstance(x, I): return math.sin(x), math.cos(x)
    (s, c), (t, d) = sin_cos_at(x.lo), sin_cos_at(min(x.hi, x.lo + 6.3))
    both, slack = [[min(a.lo, b.lo), max(a.hi, b.hi)] for a, b in ((s, t), (c, d))], Fraction(1, 10**9)
    for k in range(math.floor(Fraction(x.lo) / QUARTER), math.ceil(Fraction(min(x.hi, x.lo + 6.3)) / QUARTER) + 1):
        if Fraction(x.lo) - slack <= k * QUARTER <= Fraction(x.hi) + slack:  # an extreme: of the sine for odd k
            both[1 - k % 2][0 if k % 4 > 1 else 1] = -1.0 if k % 4 > 1 else 1.0
    return I(*both[0]), I(*both[1])

def cross(a, b): return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
def dot(a, b): return sum((x * y for x, y in zip(a[1:], b[1:])), a[0] * b[0])
def add(a, b): return [x + y for x, y in zip(a, b)]
def turned(m, v): return [dot(m[3 * i:3 * i + 3], v) for i in range(3)]
def back(m, v): return [dot(m[i::3], v) for i in range(3)]
def across(v): return [v[1], -v[0], 0.0]

def child(place, v, sign=1.0):  # components in the turned frame of a hinge; sign −1: back
    if place[0] != 1: return v
    s, c = place[1][0] * sign, place[1][1]
    return [c * v[0] + s * v[1], c * v[1] - s * v[0], v[2]]

class Tree:  # bodies and contact, as intervals, or as floats for the motions u, which may be any numbers
    def __init__(self, tree, number):
        pairs = lambda row, first: [number(*row[k:k + 2]) for k in range(first, len(row), 2)]
        self.bodies = []
        for row in tree["bodies"]:
            v = pairs(row, 4)
            self.bodies.append((*map(int, row[:4]), v[:4], v[4:13], v[13:16], v[16], v[17:20], v[20:29]))
        self.n = 1 + max(body[3] for body in self.bodies)
        (self.on, self.moment, self.fixed), v = map(int, tree["contact"][:3]), pairs(tree["contact"], 3)
        self.point, self.normal = v[:3], v[3:]

    def place(self, q):  # placements of the joints, unit wrench of the contact, and the normal in all bodies if it is fixed in the root
        places, normals = [], []
        for parent, motion, position, _, (factor, offset, _, _), rotation, *_ in self.bodies:
            x = factor * q[position] + offset if motion else 0.0
            places.append((motion, sin_cos(x) if motion == 1 else x))
            normals.append(child(places[-1], back(rotation, normals[parent] if parent >= 0 else self.normal)))
        n = normals[self.on] if self.fixed else self.normal
        return places, n + [0.0] * 3 if self.moment else cross(self.point, n) + n, normals if self.fixed else None

    def momentum(self, body, twist):
        (w, v), (mass, h, inertia) = twist, body[7:]
        return add(turned(inertia, w), cross(h, v)) + [mass * a - b for a, b in zip(v, cross(h, w))]

    def motion(self, places, u, load):  # twists of the bodies, and loads minus momenta of their subtrees
        twists = []
        for place, (parent, motion, _, k, (_, _, rate, _), r, t, *_) in zip(places, self.bodies):
            w, v = [0.0] * 3, [0.0] * 3
            if parent >= 0:
                a, b = twists[parent]
                w, v = child(place, back(r, a)), child(place, back(r, add(b, cross(a, t))))
                if motion == 2: v = add(v, [w[1] * place[1], -(w[0] * place[1]), 0.0])
            if k >= 0: (w if motion == 1 else v)[2] = (w if motion == 1 else v)[2] + rate * u[k]
            twists.append((w, v))
        sums = [[-x for x in self.momentum(*both)] for both in zip(self.bodies, twists)]
        sums[self.on] = add(sums[self.on], load or [0.0] * 6)
        for i in range(len(self.bodies) - 1, -1, -1):
            parent, motion, _, _, _, r, t, *_ = self.bodies[i]
            if parent >= 0:
                n, f = child(places[i], sums[i][:3], -1.0), child(places[i], sums[i][3:], -1.0)
                if motion == 2: n = add(n, [-(places[i][1] * f[1]), places[i][1] * f[0], 0.0])
                force = turned(r, f)
                sums[parent] = add(sums[parent], add(turned(r, n), cross(t, force)) + force)
        return twists, sums

    def residual(self, sums, u):  # r = j − M u
        r = [0.0] * self.n
        for (_, motion, _, k, (_, _, rate, armature), *_), total in zip(self.bodies, sums):
            if k >= 0: r[k] = r[k] + (total[2 if motion == 1 else 5] * rate - rate * armature * (rate * u[k]))
        return r

    def energy(self, twists, u, load):  # 2 j·u − uᵀM u
        total = 2.0 * dot(load, twists[self.on][0] + twists[self.on][1])
        for body, twist in zip(self.bodies, twists):
            total = total - dot(self.momentum(body, twist), twist[0] + twist[1])
            if body[3] >= 0: total = total - body[4][3] * (body[4][2] * u[body[3]]) * (body[4][2] * u[body[3]])
        return total

    def slopes(self, places, a, b, normals, times):  # derivatives by the positions of j·a + j·b − aᵀM b: δ_a·B + δ_b·A
        found, chain, i, (w, v) = {}, {}, self.on, a[0][self.on]
        velocity = w if self.moment else add(v, cross(w, self.point))
        while i >= 0 and normals:
            chain[i] = velocity
            velocity, i = turned(self.bodies[i][5], child(places[i], velocity, -1.0)), self.bodies[i][0]
        for i, (_, motion, position, _, (factor, *_), *_) in enumerate(self.bodies):
            change = lambda t: across(t[0]) + across(t[1]) if motion == 1 else [0.0] * 3 + across(t[0])
            if motion:
                slope = dot(b[1][i], change(a[0][i])) + dot(a[1][i], change(b[0][i]))
                if i in chain and motion == 1: slope = slope + dot(chain[i], across(normals[i])) * times
                found[position] = found.get(position, 0.0) + slope * factor
        return found

    def units(self, places):  # motions of the unit rates
        unit = lambda k: [float(i == k) for i in range(self.n)]
        return [(unit(k), *self.motion(places, unit(k), None)) for k in range(self.n)]

def inverse_cholesky(m):
    n, l, c = range(len(m)), [[0.0] * len(m) for _ in m], [[0.0] * len(m) for _ in m]
    for i in n:
        for j in range(i + 1):
            s = m[i][j] - sum(l[i][k] * l[j][k] for k in range(j))
            l[i][j] = math.sqrt(s) if i == j else s / l[j][j]
        for j in range(i + 1):
            c[i][j] = (float(i == j) - sum(l[i][k] * c[k][j] for k in range(j, i))) / l[i][i]
    return c

class Check:
    def __init__(self, tree):
        self.exact, self.near = Tree(tree, I), Tree(tree, lambda lo, hi: 0.5 * lo + 0.5 * hi)
        self.q, self.ranges = [I(*x) for x in tree["positions"]], tree["ranges"]

    def at(self, x, q):
        return [dict((k, v) for (k, _, _), v in zip(self.ranges, x)).get(i, held) for i, held in enumerate(q)]

    def solve(self, x):  # u = M⁻¹j and C with C M Cᵀ ≈ 1, in floats
        tree = self.near
        places, load, _ = tree.place(self.at(x, [0.5 * v.lo + 0.5 * v.hi for v in self.q]))
        j = tree.residual(tree.motion(places, [0.0] * tree.n, load)[1], [0.0] * tree.n)
        c = inverse_cholesky([[-r for r in tree.residual(sums, u)] for u, _, sums in tree.units(places)])
        y = [dot(row, j) for row in c]
        return [sum(c[i][k] * y[i] for i in range(tree.n)) for k in range(tree.n)], c

    def bound(self, box, x, sign):  # lower bound of sign · 1/m̄ in a box with the motion of the point x, and the worst corner
        tree, (u, c) = self.exact, self.solve(x)
        points = lambda x: tree.place(self.at([I(v) for v in x], self.q))
        places, load, normals = tree.place(self.at([I(*b) for b in box], self.q))
        motion = tree.motion(places, u, load)
        slopes = tree.slopes(places, motion, motion, normals, 2.0)
        corner, loss, reach = list(x), I(0.0), [I(*b) - I(v) for b, v in zip(box, x)]
        for k, (position, _, _) in enumerate(self.ranges):
            slope = slopes[position] * sign
            if slope.lo >= 0.0 or slope.hi <= 0.0:
                corner[k] = box[k][0 if slope.lo >= 0.0 else 1]
            else:
                loss = loss + I(min((slope * reach[k]).lo, 0.0))
        there, load_there, _ = points(corner)
        value = (tree.energy(tree.motion(there, u, load_there)[0], u, load_there) * sign + loss).lo
        best = max(value, (tree.energy(motion[0], u, load) * sign).lo)
        if sign < 0.0:  # w ≤ G + rᵀM⁻¹r
            there, load_there, _ = points(x)
            white, units = tree.residual(tree.motion(there, u, load_there)[1], u), tree.units(places)
            white, columns = [dot(row, white) for row in c], [tree.slopes(places, e[1:], motion, normals, 1.0) for e in units]
            for k, (position, _, _) in enumerate(self.ranges):
                white = [w + dot(row, [column[position] for column in columns]) * reach[k] for w, row in zip(white, c)]
            half = [[dot(row, [-x for x in tree.residual(sums, e)]) for row in c] for e, _, sums in units]
            rows = [[(dot(c[i], column) - float(i == j)).mag() for i in range(tree.n)] for j, column in enumerate(zip(*half))]
            least = (I(1.0) - max((sum(map(I, row), I(0.0)) for row in rows), key=lambda x: x.hi)).lo
            square = sum((w * w for w in white), I(0.0)).hi
            best = (I(best) - I(math.nextafter(square / least, math.inf))).lo if least > 0.0 else -math.inf
        return best, corner

    def extreme(self, name, bracket, sign, tolerance):  # all masses within the tolerance: m̄ by the factor of the extreme masses
        x, fail = bracket["positions"], lambda why: sys.exit(f"{name}: {why}")
        if any(not lower <= v <= upper for (_, lower, upper), v in zip(self.ranges, x)): fail("the best positions are outside the ranges")
        (inner, outer), one = (bracket["lower"], bracket["upper"])[::int(sign)], (I(sign * tolerance) + 1.0) * sign
        # At the best positions w ≤ factor/inner for the largest m̄, w ≥ factor/inner for the smallest one; in all boxes the opposite with outer.
        if not (I(self.bound([(v, v) for v in x], x, -sign)[0]) * inner + one).lo >= 0.0:
            fail(f"{inner} is not proved at the best positions")
        boxes, leaves = [[(lower, upper) for _, lower, upper in self.ranges]], 0
        for division in bracket["divisions"]:
            box = boxes.pop() if boxes else fail("more divisions than boxes")
            if division >= len(box): fail(f"no range {division} to divide")
            if division >= 0:
                (lower, upper), middle = box[division], 0.5 * box[division][0] + 0.5 * box[division][1]
                boxes += [box[:division] + [half] + box[division + 1:] for half in ((middle, upper), (lower, middle))]
                continue
            centre, leaves = [0.5 * a + 0.5 * b for a, b in box], leaves + 1
            found, corner = self.bound(box, centre, sign)
            if not (I(found) * outer - one).lo >= 0.0: found = max(found, self.bound(box, corner, sign)[0])
            if not (I(found) * outer - one).lo >= 0.0: fail(f"{outer} is not proved in the box {box}")
        if boxes: fail(f"{len(boxes)} boxes are not covered")
        print(f"{name}: {bracket['lower']} to {bracket['upper']} is proved, with {leaves} boxes")

if __name__ == "__main__":
    with open(sys.argv[1]) as file:
        report = json.load(file)
    proof = report.get("certificate") or (report.get("proved") or {}).get("certificate")
    check = Check((proof and proof.get("tree")) or sys.exit("the report has no certificate of a tree"))
    proved = [tuple(bounds) for _, *bounds in check.ranges]
    stated = [tuple(bounds) for _, *bounds in report.get("ranges", [])]
    if stated and not all(any(a <= c and d <= b for a, b in proved) for c, d in stated): sys.exit(f"the report states ranges outside the proved ones {proved}")
    print(f"ranges (rad or m): {proved}")
    for name, key, sign in (("largest", "most", 1.0), ("smallest", "least", -1.0)):
        bracket = proof[key]
        if bracket is None or None in (bracket["lower"], bracket["upper"]): print(f"{name}: the report proves no bracket")
        else: check.extreme(name, bracket, sign, proof["mass_tolerance"])
