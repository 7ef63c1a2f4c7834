"""Effective masses in many digits, from the numbers of a mechanism alone.

m = min { v'Mv : A v = 0, j v = 1 }, by four methods that share only the positions of the bodies:

- `by_recursion`: open trees, from the leaves to the root, O(n).
- `by_closing`: loops, from the responses of their tree to closing wrenches, O(n).
- `by_joints`: mass matrix over the joints, kernel of the closures' rows, one linear solve.
- `by_bodies`: six velocities for every body, every joint a constraint, the KKT equations.

Numbers are decimal strings and denote exactly the nearest doubles. All further arithmetic uses `mp.dps` digits. All
vectors are in the root link's axes; twists are (angular velocity, velocity at the root's origin).
"""

from mpmath import mp, mpf

mp.dps = 90

# Lengths decide a rank; they are between one and 1e4, and the noise is 1e-80.
RANK = mpf(10) ** -40
# Largest number of bodies for equations over all joints of loops.
SMALL = 13


def numbers(text):
    """Doubles of a string of decimals."""
    return [mpf(float(word)) for word in text.split()]


# Three-vectors and 3x3 matrices as lists.

def dot(a, b):
    return sum((x * y for x, y in zip(a, b)), mpf(0))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def add(a, b):
    return [x + y for x, y in zip(a, b)]


def sub(a, b):
    return [x - y for x, y in zip(a, b)]


def times(s, a):
    return [s * x for x in a]


def unit(a):
    return times(1 / mp.sqrt(dot(a, a)), a)


def apply(r, a):
    return [dot(row, a) for row in r]


def product(r, s):
    columns = list(zip(*s))
    return [[dot(row, c) for c in columns] for row in r]


def transpose(r):
    return [list(row) for row in zip(*r)]


def about(axis, angle):
    """Rotation about a unit vector (Rodrigues)."""
    s, c = mp.sin(angle), mp.cos(angle)
    x, y, z = axis
    t = 1 - c
    return [
        [t * x * x + c, t * x * y - s * z, t * x * z + s * y],
        [t * x * y + s * z, t * y * y + c, t * y * z - s * x],
        [t * x * z - s * y, t * y * z + s * x, t * z * z + c],
    ]


def of_rpy(rpy):
    """Rz(yaw) Ry(pitch) Rx(roll), as in URDF."""
    one, zero = mpf(1), mpf(0)
    x, y, z = [one, zero, zero], [zero, one, zero], [zero, zero, one]
    return product(about(z, rpy[2]), product(about(y, rpy[1]), about(x, rpy[0])))


def perpendiculars(a):
    """Two unit vectors normal to a and to each other."""
    least = min(range(3), key=lambda i: abs(a[i]))
    e = [mpf(int(i == least)) for i in range(3)]
    t = unit(cross(a, e))
    return t, cross(a, t)


class Joint:
    def __init__(self, kind, parent, xyz, axis, rpy=""):
        self.kind, self.parent = kind, parent
        self.xyz, self.turn = numbers(xyz), of_rpy(numbers(rpy or "0 0 0"))
        self.axis = unit(numbers(axis))


class Body:
    """Empty, or mass, centre, moments about the centre in the link's axes."""

    def __init__(self, row):
        self.mass = mpf(0)
        if row:
            self.mass = numbers(row[0])[0]
            self.centre = numbers(row[1])
            xx, xy, xz, yy, yz, zz = numbers(row[2])
            self.moments = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
            if len(row) > 3:
                r = of_rpy(numbers(row[3]))
                self.moments = product(product(r, self.moments), transpose(r))


class Loop:
    """A closure: frames are parallel to their links' axes. An axis: revolute; one number, the distance of the two
    points: a rod; neither: a ball."""

    def __init__(self, row):
        self.predecessor, before, self.successor, after, words = row
        self.before, self.after = numbers(before), numbers(after)
        of = numbers(words)
        self.axis = unit(of) if len(of) == 3 else None
        self.length = of[0] if len(of) == 1 else None

    def ends(self, position):
        return position.point(self.predecessor, self.before), position.point(self.successor, self.after)


class Mechanism:
    """Mechanism from a fixture's rows (README.md); `count` links besides the root, all by default."""

    def __init__(self, rows, count=None):
        links = rows["links"]
        count = len(links) - 1 if count is None else count
        full = [links[row] if isinstance(row, int) else row for row in links[: count + 1]]
        self.bodies = [Body(row) for row in full]
        # Joint i is the parent joint of link i; the root has no joint.
        self.joints = [None] + [Joint(*row[:5]) for row in rows["joints"][:count]]
        self.loops = [Loop(row) for row in rows.get("loops", [])]
        assert len(self.joints) == len(self.bodies)

    def moving(self):
        return [i for i, j in enumerate(self.joints) if j and j.kind != "f"]


class Position:
    """Poses of the bodies; q maps joint to value."""

    def __init__(self, mechanism, q, floating=False):
        self.mechanism, self.q, self.floating = mechanism, q, floating
        one, zero = mpf(1), mpf(0)
        self.r = [[[one, zero, zero], [zero, one, zero], [zero, zero, one]]]
        self.p = [[zero, zero, zero]]
        self.axis = [None]
        for i, joint in enumerate(mechanism.joints[1:], 1):
            r0, p0 = self.r[joint.parent], self.p[joint.parent]
            p = add(p0, apply(r0, joint.xyz))
            r = product(r0, joint.turn)
            axis = apply(r, joint.axis)
            if joint.kind == "c":
                r = product(r, about(joint.axis, q[i]))
            elif joint.kind == "p":
                p = add(p, times(q[i], axis))
            self.r.append(r)
            self.p.append(p)
            self.axis.append(axis)

    def point(self, body, p):
        return add(self.p[body], apply(self.r[body], p))

    def column(self, i):
        """Twist of joint i at unit rate."""
        if self.mechanism.joints[i].kind == "c":
            return self.axis[i] + cross(self.p[i], self.axis[i])
        return [mpf(0)] * 3 + self.axis[i]

    def inertia(self, i):
        """6x6 about the root's origin: [[I, m c~], [-m c~, m]]."""
        body = self.mechanism.bodies[i]
        zero = mpf(0)
        out = [[zero] * 6 for _ in range(6)]
        if body.mass == 0:
            return out
        m = body.mass
        c = self.point(i, body.centre)
        about_centre = product(product(self.r[i], body.moments), transpose(self.r[i]))
        cc = dot(c, c)
        for a in range(3):
            for b in range(3):
                out[a][b] = about_centre[a][b] + m * ((cc if a == b else 0) - c[a] * c[b])
            out[3 + a][3 + a] = m
        h = times(m, c)
        for a, b, value in [(0, 1, -h[2]), (0, 2, h[1]), (1, 2, -h[0])]:
            out[a][3 + b] = out[3 + b][a] = value
            out[b][3 + a] = out[3 + a][b] = -value
        return out

    def touched(self, contact):
        """Contact point and normal in the root's axes."""
        point = self.point(contact["on"], numbers(contact["point"]))
        if contact["toward"] is not None:
            return point, unit(sub(self.point(contact["toward"], numbers(contact["normal"])), point))
        normal = unit(numbers(contact["normal"]))
        return point, normal if contact["world"] else apply(self.r[contact["on"]], normal)


def dot6(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3] + a[4] * b[4] + a[5] * b[5]


def by_recursion(position, contacts):
    """Masses of an open tree; None for a contact that does not move."""
    assert not position.mechanism.loops
    inverse = responses(position, [wrench_on(position, c) for c in contacts], crossed=False)
    return [1 / x if x > RANK else None for x in inverse]


def wrench_on(position, contact):
    """Per body: a unit force along the normal, and its opposite."""
    p, normal = position.touched(contact)
    w = cross(p, normal) + normal
    out = {contact["on"]: w}
    against = contact["against"]
    if against is not None:
        out[against] = sub(out.get(against, [mpf(0)] * 6), w)
    return out


def responses(position, wrenches, crossed):
    """w' M^-1 w of the tree for every wrench; with `crossed`, for every pair of wrenches."""
    mechanism = position.mechanism
    n, count = len(mechanism.bodies), len(wrenches)
    inertia = [position.inertia(i) for i in range(n)]
    zero6 = [mpf(0)] * 6
    force = [[w.get(i) for i in range(n)] for w in wrenches]
    out = [[mpf(0)] * count for _ in range(count)]

    def count_in(parts, weights):
        for a in range(count):
            if parts[a]:
                for b in range(count) if crossed else [a]:
                    if parts[b]:
                        out[a][b] += parts[a] * weights[b]

    for i in range(n - 1, 0, -1):
        joint, own = mechanism.joints[i], inertia[i]
        parent = inertia[joint.parent]
        if joint.kind == "f":
            for a in range(6):
                for b in range(6):
                    parent[a][b] += own[a][b]
            for f in force:
                if f[i] is not None:
                    f[joint.parent] = add(f[joint.parent] or zero6, f[i])
            continue
        s = position.column(i)
        u = [dot6(row, s) for row in own]
        d = dot6(s, u)
        for a in range(6):
            scaled = u[a] / d
            for b in range(a, 6):
                parent[a][b] += own[a][b] - scaled * u[b]
                parent[b][a] = parent[a][b]
        parts = [None if f[i] is None else dot6(s, f[i]) for f in force]
        weights = [None if t is None else t / d for t in parts]
        count_in(parts, weights)
        for f, weight in zip(force, weights):
            if f[i] is not None:
                passed = [x - y * weight for x, y in zip(f[i], u)]
                f[joint.parent] = add(f[joint.parent] or zero6, passed)
        inertia[i] = None
    if position.floating:
        on_root = [f[0] for f in force]
        moved = [None if f is None else solve(inertia[0], [[x] for x in f], column=0) for f in on_root]
        for a in range(count):
            for b in range(count) if crossed else [a]:
                if on_root[a] is not None and on_root[b] is not None:
                    out[a][b] += dot6(on_root[a], moved[b])
    return out if crossed else [out[a][a] for a in range(count)]


def by_closing(position, contacts):
    """Masses for few loops with many joints: responses of the tree to the contacts and to the closing wrenches."""
    closing = []
    for loop in position.mechanism.loops:
        before, after = loop.predecessor, loop.successor
        p, s = loop.ends(position)
        if loop.length is not None:
            along = unit(sub(s, p))
            closing.append({after: cross(s, along) + along, before: times(-1, cross(p, along) + along)})
            continue
        assert max(map(abs, sub(s, p))) < mpf(10) ** (10 - mp.dps)
        pushes = [[mpf(int(a == b)) for a in range(3)] for b in range(3)]
        wrenches = [cross(p, push) + push for push in pushes]
        turns = perpendiculars(apply(position.r[before], loop.axis)) if loop.axis else []
        wrenches += [list(turn) + [mpf(0)] * 3 for turn in turns]
        closing += [{after: w, before: times(-1, w)} for w in wrenches]
    k = len(contacts)
    all_of_it = responses(position, [wrench_on(position, c) for c in contacts] + closing, crossed=True)
    bound = [row[k:] for row in all_of_it[k:]]
    pivots, _ = eliminate(bound)
    rows, columns = [i for i, _ in pivots], [c for _, c in pivots]
    square = [[bound[i][c] for c in columns] for i in rows]
    out = []
    for a in range(k):
        held = solve(square, [[all_of_it[k + i][a]] for i in rows], column=0)
        inverse = all_of_it[a][a] - sum((all_of_it[a][k + c] * x for c, x in zip(columns, held)), mpf(0))
        out.append(1 / inverse if inverse > RANK else None)
    return out


def solve(matrix, right, column=None):
    """Gauss elimination with partial pivoting of scaled rows."""
    n = len(matrix)
    work = []
    for row, r in zip(matrix, right):
        scale = 1 / max(abs(x) for x in row)
        work.append([x * scale for x in list(row) + list(r)])
    for k in range(n):
        best = max(range(k, n), key=lambda i: abs(work[i][k]))
        work[k], work[best] = work[best], work[k]
        pivot = work[k]
        assert pivot[k] != 0
        for i in range(k + 1, n):
            row = work[i]
            if row[k]:
                factor = row[k] / pivot[k]
                work[i] = [mpf(0)] * (k + 1) + [x - factor * y for x, y in zip(row[k + 1:], pivot[k + 1:])]
    width = len(work[0]) - n
    out = [[mpf(0)] * width for _ in range(n)]
    for k in range(n - 1, -1, -1):
        for c in range(width):
            known = sum((work[k][i] * out[i][c] for i in range(k + 1, n)), mpf(0))
            out[k][c] = (work[k][n + c] - known) / work[k][k]
    return out if column is None else [row[column] for row in out]


def eliminate(rows):
    """Gauss-Jordan elimination with complete pivoting: [(row, column)] of the pivots and the reduced rows. Every
    pivot exceeds 1e-40, and the remainder is smaller by at least 1e20: no rank is ambiguous."""
    work = [list(row) for row in rows]
    free = set(range(len(work)))
    columns = set(range(len(work[0]))) if work else set()
    pivots = []
    while free and columns:
        size, i, k = max((abs(work[i][k]), i, k) for i in free for k in columns)
        if size < RANK:
            assert size < RANK * mpf(10) ** -20, f"rank in doubt: {mp.nstr(size)}"
            break
        free.discard(i)
        columns.discard(k)
        pivots.append((i, k))
        inverse = 1 / work[i][k]
        work[i] = [x * inverse for x in work[i]]
        for other in range(len(work)):
            factor = work[other][k]
            if other != i and factor:
                work[other] = [x - factor * y for x, y in zip(work[other], work[i])]
    return pivots, work


def paths(position):
    """Coordinates that move each body."""
    mechanism = position.mechanism
    base = list(range(6)) if position.floating else []
    place = {i: len(base) + k for k, i in enumerate(mechanism.moving())}
    out = [base]
    for i, joint in enumerate(mechanism.joints[1:], 1):
        out.append(out[joint.parent] + ([place[i]] if i in place else []))
    columns = [[mpf(int(a == b)) for a in range(6)] for b in base]
    columns += [position.column(i) for i in mechanism.moving()]
    return out, columns


def velocity_rows(position, path, columns, p):
    """Rows of the angular velocity and of the velocity at the point p, for a body moved by `path`."""
    rows = [[mpf(0)] * len(columns) for _ in range(6)]
    for k in path:
        turning, at_origin = columns[k][:3], columns[k][3:]
        v = add(at_origin, cross(turning, p))
        for a in range(3):
            rows[a][k], rows[3 + a][k] = turning[a], v[a]
    return rows


def closure_rows(position, path, columns):
    """A and the residuals of the loops."""
    rows, residual = [], []
    for loop in position.mechanism.loops:
        before, after = loop.predecessor, loop.successor
        p, s = loop.ends(position)
        one = velocity_rows(position, path[before], columns, p)
        two = velocity_rows(position, path[after], columns, s)
        difference = [sub(b, a) for a, b in zip(one, two)]
        if loop.length is not None:
            along = unit(sub(s, p))
            rows.append([dot(along, column) for column in zip(*difference[3:])])
            residual.append(dot(along, sub(s, p)) - loop.length)
            continue
        rows += difference[3:]
        residual += sub(s, p)
        if loop.axis is None:
            continue
        axis, other = apply(position.r[before], loop.axis), apply(position.r[after], loop.axis)
        for t in perpendiculars(axis):
            # d(t . other) = (angular velocity of the successor - angular velocity of the predecessor) . (other x t)
            weights = cross(other, t)
            rows.append([dot(weights, column) for column in zip(*difference[:3])])
            residual.append(dot(t, other))
    return rows, residual


def closed(mechanism, drivers, guess, floating=False):
    """The closed position, by Newton's method from the guess."""
    dependent = sorted(guess)
    moving = mechanism.moving()
    q = {**drivers, **{i: mpf(x) for i, x in guess.items()}}
    for _ in range(60):
        position = Position(mechanism, q)
        path, columns = paths(position)
        rows, residual = closure_rows(position, path, columns)
        if max(map(abs, residual)) < mpf(10) ** (8 - mp.dps):
            return Position(mechanism, q, floating)
        chosen = [[row[moving.index(i)] for i in dependent] + [-r] for row, r in zip(rows, residual)]
        # Pivots among the unknowns only; dropped rows are dependent.
        pivots, _ = eliminate([row[:-1] for row in chosen])
        assert len(pivots) == len(dependent), "the dependent joints are not determined"
        square = [chosen[i] for i, _ in pivots]
        step = solve([row[:-1] for row in square], [[row[-1]] for row in square], column=0)
        for i, x in zip(dependent, step):
            q[i] += x
    raise ArithmeticError(f"the loops do not close: {mp.nstr(max(map(abs, residual)))}")


def kernel(rows, n):
    """Basis of the kernel of the rows, as lists of columns."""
    pivots, work = eliminate(rows)
    bound = {k for _, k in pivots}
    basis = []
    for f in range(n):
        if f not in bound:
            v = [mpf(0)] * n
            v[f] = mpf(1)
            for i, k in pivots:
                v[k] = -work[i][f]
            basis.append(v)
    return basis


def by_joints(position, contacts):
    """Masses over the joints' rates; None for a contact that does not move. Loops must be closed."""
    mechanism = position.mechanism
    path, columns = paths(position)
    n = len(columns)
    mass = [[mpf(0)] * n for _ in range(n)]
    for i, body in enumerate(mechanism.bodies):
        if body.mass == 0:
            continue
        inertia = position.inertia(i)
        momenta = {k: apply(inertia, columns[k]) for k in path[i]}
        for a in path[i]:
            for b in path[i]:
                mass[a][b] += dot(columns[a], momenta[b])
    rows, residual = closure_rows(position, path, columns)
    assert not residual or max(map(abs, residual)) < mpf(10) ** (10 - mp.dps)
    basis = kernel(rows, n) if rows else [[mpf(int(a == b)) for a in range(n)] for b in range(n)]
    images = [apply(mass, v) for v in basis]
    reduced = [[dot(v, image) for image in images] for v in basis]
    out = []
    for contact in contacts:
        p, normal = position.touched(contact)
        j = [mpf(0)] * n
        for body, sign in [(contact["on"], 1), (contact["against"], -1)]:
            if body is not None:
                velocity = velocity_rows(position, path[body], columns, p)[3:]
                j = add(j, [sign * dot(normal, column) for column in zip(*velocity)])
        row = [dot(j, v) for v in basis]
        if not row or max(map(abs, row)) < RANK:
            out.append(None)
            continue
        inverse = dot(row, solve(reduced, [[x] for x in row], column=0))
        out.append(1 / inverse)
    return out


def by_bodies(position, contacts):
    """Masses over six velocities per body (angular velocity, velocity of the centre), with every joint as a
    constraint."""
    mechanism = position.mechanism
    n = len(mechanism.bodies)
    centres = [position.point(i, b.centre) if b.mass else position.p[i] for i, b in enumerate(mechanism.bodies)]

    def row(parts):
        out = [mpf(0)] * (6 * n)
        for body, turning, velocity in parts:
            for a in range(3):
                out[6 * body + a] += turning[a]
                out[6 * body + 3 + a] += velocity[a]
        return out

    def point(body, p, direction, sign=1):
        """Row of sign direction . velocity at p."""
        return body, times(sign, cross(sub(p, centres[body]), direction)), times(sign, direction)

    zero = [mpf(0)] * 3
    axes = [[mpf(int(a == b)) for a in range(3)] for b in range(3)]
    rows = []

    def alike(one, two, p, axis, turns, slides):
        """Rows for equal motion of two bodies at p, except for a rotation about the axis or a translation along it."""
        across = perpendiculars(axis)
        for direction in across if turns else axes:
            rows.append(row([(one, direction, zero), (two, times(-1, direction), zero)]))
        for direction in across if slides else axes:
            rows.append(row([point(one, p, direction), point(two, p, direction, -1)]))

    if not position.floating:
        rows += [row([(0, e, zero)]) for e in axes] + [row([(0, zero, e)]) for e in axes]
    for i, joint in enumerate(mechanism.joints[1:], 1):
        alike(joint.parent, i, position.p[i], position.axis[i], joint.kind == "c", joint.kind == "p")
    for loop in mechanism.loops:
        one, two = loop.predecessor, loop.successor
        p, s = loop.ends(position)
        if loop.length is not None:
            along = unit(sub(s, p))
            rows.append(row([point(two, s, along), point(one, p, along, -1)]))
        elif loop.axis is None:
            rows += [row([point(one, p, e), point(two, p, e, -1)]) for e in axes]
        else:
            alike(one, two, p, apply(position.r[one], loop.axis), True, False)
    pivots, _ = eliminate(rows)
    rows = [rows[i] for i, _ in pivots]
    size, m = 6 * n, len(rows)
    kkt = [[mpf(0)] * (size + m) for _ in range(size + m)]
    for i, body in enumerate(mechanism.bodies):
        if body.mass:
            moments = product(product(position.r[i], body.moments), transpose(position.r[i]))
            for a in range(3):
                for b in range(3):
                    kkt[6 * i + a][6 * i + b] = moments[a][b]
                kkt[6 * i + 3 + a][6 * i + 3 + a] = body.mass
    for k, r in enumerate(rows):
        for a, x in enumerate(r):
            kkt[a][size + k] = kkt[size + k][a] = x
    right = [[] for _ in range(size + m)]
    forces = []
    for contact in contacts:
        p, normal = position.touched(contact)
        parts = [point(contact["on"], p, normal)]
        if contact["against"] is not None:
            parts.append(point(contact["against"], p, normal, -1))
        forces.append(row(parts))
        for a in range(size + m):
            right[a].append(forces[-1][a] if a < size else mpf(0))
    velocities = solve(kkt, right)
    out = []
    for k, force in enumerate(forces):
        inverse = sum((f * velocities[a][k] for a, f in enumerate(force)), mpf(0))
        out.append(1 / inverse if abs(inverse) > RANK else None)
    return out


def masses(position, contacts):
    """Masses by the appropriate formulation."""
    if not position.mechanism.loops:
        return by_recursion(position, contacts)
    return (by_joints if len(position.mechanism.bodies) <= SMALL else by_closing)(position, contacts)
