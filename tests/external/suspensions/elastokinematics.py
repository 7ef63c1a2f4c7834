"""Elastokinematics of double wishbones compared with an independent program.

    elastokinematics.py --percuss PATH [--count N] [--seed S]                 prints `N passed, N failed`

N cars: the hardpoints of models/suspensions/double-wishbone-bushes.toml displaced; random bushes with different rates in all directions, random axes,
preloads and spring; travel held or not. All motions per load and the compliance matrix of `percuss kinematics --compliance` are compared. The program here shares
no code and no method with percuss: four rigid bodies in maximal coordinates with rotations to second order, energies of bushes, spring and wheel load
as polynomials of second order, and the second derivative of the Lagrange function in the null space of the constraints. Of the forces of the bushes
at the pose, the part that is not given follows from their stiffness (docs/howto/BUSHES.md).

`percuss response` at a point of the upright is compared too: natural frequencies, residual compliance and receptance with the same stiffness and the
masses of the sheet.
"""

import argparse
import json
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

import numpy as np
from scipy.linalg import eigh, lstsq, null_space

ROOT = Path(__file__).resolve().parents[3]
SHEET = ROOT / "models/suspensions/double-wishbone-bushes.toml"
# Condition of the stiffness 1e5; with preloads, percuss has second derivatives by differences of fourth order.
TOLERANCE, PRELOADED = 1e-9, 1e-8
# Frequencies by the QZ method here: rounding of the largest square.
FREQUENCY = 1e-9
BODIES = ["lower", "upper", "upright", "tie"]
SIZE = 6 * len(BODIES)
BODY_OF = {"lower_front": "lower", "lower_back": "lower", "upper_front": "upper", "upper_back": "upper", "tie_rod_inner": "tie"}
HINGES = {"lower": ("lower_front", "lower_back"), "upper": ("upper_front", "upper_back")}
# Point of the upright, from the wheel centre, m.
POINT = np.array([0.02, -0.05, 0.03])
QUANTITIES = ["toe", "camber", "wheel_centre_x", "wheel_centre_y", "wheel_centre_z", "contact_patch_x", "contact_patch_y"]


class Poly:
    """Polynomial of second order: value, gradient, second derivative."""

    def __init__(self, value, gradient=None, second=None):
        self.value = value
        self.gradient = np.zeros(SIZE) if gradient is None else gradient
        self.second = np.zeros((SIZE, SIZE)) if second is None else second

    def __add__(self, other):
        other = other if isinstance(other, Poly) else Poly(other)
        return Poly(self.value + other.value, self.gradient + other.gradient, self.second + other.second)

    __radd__ = __add__

    def __mul__(self, other):
        other = other if isinstance(other, Poly) else Poly(other)
        a, b = self, other
        mixed = np.outer(a.gradient, b.gradient)
        return Poly(a.value * b.value, a.gradient * b.value + b.gradient * a.value, a.second * b.value + b.second * a.value + mixed + mixed.T)

    __rmul__ = __mul__

    def __neg__(self):
        return self * -1.0

    def __sub__(self, other):
        return self + -1.0 * other

    def sqrt(self):
        root = np.sqrt(self.value)
        g = self.gradient
        return Poly(root, g / (2 * root), self.second / (2 * root) - np.outer(g, g) / (4 * root**3))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def floats(v):
    return [float(x) for x in v]


def answer(sheet, bushes, spring, held):
    """Motions per load, and the compliance matrix. bushes: name -> axes (columns), stiffness and preload, rotations first."""
    at = {name: np.array(point) * 1e-3 for name, point in sheet["points"].items()}
    variable = lambda i: Poly(0.0, np.eye(SIZE)[i])
    turn = {body: [variable(6 * i + j) for j in range(3)] for i, body in enumerate(BODIES)}
    shift = {body: [variable(6 * i + 3 + j) for j in range(3)] for i, body in enumerate(BODIES)}
    origin = dict(zip(BODIES, (at[name] for name in ("lower_ball", "upper_ball", "wheel_centre", "tie_rod_outer"))))

    def vector(body, v):
        once = cross(turn[body], floats(v))
        return [v + a + 0.5 * b for v, a, b in zip(floats(v), once, cross(turn[body], once))]

    def point(body, p):
        return [a + b + float(o) for a, b, o in zip(vector(body, p - origin[body]), shift[body], origin[body])]

    joints = (("lower", "lower_ball"), ("upper", "upper_ball"), ("tie", "tie_rod_outer"))
    ideal = [row for body, name in joints for row in minus(point(body, at[name]), point("upright", at[name]))]
    line = at["tie_rod_outer"] - at["tie_rod_inner"]
    rows, stiffness, preload, moves = [], [], [], []
    for name, (axes, rates, forces) in bushes.items():
        body = BODY_OF[name]
        rows += [dot(floats(axis), turn[body]) for axis in axes.T]
        away = minus(point(body, at[name]), floats(at[name]))
        rows += [dot(vector(body, axis), away) for axis in axes.T]
        stiffness, preload, moves = stiffness + list(rates), preload + list(forces), moves + [False] * 3 + [True] * 3
    b, k, p, moves = np.array([row.gradient for row in rows]), np.array(stiffness), np.array(preload), np.array(moves)
    # The spin of the tie rod, if no bush holds it, moves nothing else.
    if not bushes["tie_rod_inner"][1][:3].any():
        ideal.append(dot(floats(line), turn["tie"]))
    rate, force = spring
    length = minus(point("lower", at["spring_seat"]), floats(at["spring_chassis_seat"]))
    length = dot(length, length).sqrt()
    centre, radius = point("upright", at["wheel_centre"]), sheet["wheel"]["radius"] * 1e-3
    spin = vector("upright", [0, 1, 0])
    lowest = centre[2] - radius * (1.0 + -1.0 * spin[2] * spin[2]).sqrt()
    a = np.array([row.gradient for row in ideal])
    load = 0.0
    is_loaded = force != 0 or p.any()
    if is_loaded:
        spins = [dot(floats(line), turn["tie"]).gradient]
        (travel,) = null_space(np.vstack([a, b[moves], spins]), rcond=1e-12).T
        load = -(force * length.gradient @ travel + p @ b @ travel) / (lowest.gradient @ travel)
    constraints = ideal + ([centre[2]] if held else [])
    a = np.array([row.gradient for row in constraints])
    n = null_space(a, rcond=1e-12)
    given = force * length.gradient + load * lowest.gradient + b.T @ p
    deflection = lstsq(n.T @ (b.T * k) @ b @ n, n.T @ given, cond=1e-13)[0]
    f = p - k * (b @ n @ deflection)
    rest = force * length.gradient + load * lowest.gradient + b.T @ f
    reactions = lstsq(a.T, rest)[0]
    assert np.linalg.norm(a.T @ reactions - rest) <= 1e-9 * max(np.linalg.norm(rest), 1.0)
    second = (b.T * k) @ b + rate * np.outer(length.gradient, length.gradient)
    if is_loaded:
        second = second - sum(x * row.second for x, row in zip(f, rows)) - force * length.second - load * lowest.second
        second = second + sum(x * row.second for x, row in zip(reactions, constraints))
    vibrating = {"n": n, "stiffness": second, "geometric": second - (b.T * k) @ b - rate * np.outer(length.gradient, length.gradient),
                 "height": centre[2].gradient}
    # The universal joint of the tie rod holds the rotation about the axis of its bush.
    held_rows = moves.copy()
    held_rows[6 * list(bushes).index("tie_rod_inner") + 2] = True
    vibrating["rigid"], vibrating["k"] = b[held_rows], k[held_rows]
    vibrating["mass"], vibrating["point"] = masses(sheet, at, point, turn)
    flexible = n @ np.linalg.solve(n.T @ second @ n, n.T)
    patch = point("upright", at["wheel_centre"] - [0, 0, radius])
    of = [[row.gradient for row in rows] for rows in (centre, turn["upright"], patch)]
    loads = {"lateral_force": of[2][1], "braking_force": -of[2][0], "driving_force": of[0][0], "vertical_force": of[2][2], "aligning_torque": of[1][2]}
    motions = dict(zip(QUANTITIES, [-of[1][2], -of[1][0], *of[0], *of[2][:2]]))
    table = {f"{name}_per_{case}": row @ flexible @ g for name, row in motions.items() for case, g in loads.items() if not (held and case == "vertical_force")}
    all_rows = np.array(of[0] + of[1])
    return table, all_rows @ flexible @ all_rows.T, vibrating


def masses(sheet, at, point, turn):
    """Mass matrix with a wheel that spins freely, and rows of a point of the upright."""
    matrix = np.zeros((SIZE, SIZE))

    def add(body, mass, com, inertia):
        rows = np.array([row.gradient for row in point(body, com)])
        turns = np.array([row.gradient for row in turn[body]])
        return mass * rows.T @ rows + turns.T @ inertia @ turns

    for body, name in (("lower", "lower_arm"), ("upper", "upper_arm"), ("upright", "upright")):
        i = list(sheet[name]["inertia"]) + [0] * (6 - len(sheet[name]["inertia"]))
        inertia = np.array([[i[0], i[3], i[4]], [i[3], i[1], i[5]], [i[4], i[5], i[2]]])
        matrix += add(body, sheet[name]["mass"], np.array(sheet[name]["com"]) * 1e-3, inertia)
    for name in ("spindle", "wheel"):
        i = sheet[name]["inertia"]
        matrix += add("upright", sheet[name]["mass"], at["wheel_centre"], np.diag([i[0], 0, i[2]]))
    line = at["tie_rod_outer"] - at["tie_rod_inner"]
    middle, rod = (at["tie_rod_outer"] + at["tie_rod_inner"]) / 2, sheet["tie_rod"]["mass"]
    matrix += add("tie", rod, middle, rod / 12 * (line @ line * np.eye(3) - np.outer(line, line)))
    return matrix, np.array([row.gradient for row in point("upright", at["wheel_centre"] + POINT)])


def vibrations(v, normal, tyre, omegas):
    """Natural frequencies in Hz, residual compliance, receptances."""
    n = v["n"]
    reduce = lambda matrix: n.T @ matrix @ n
    mass, j = reduce(v["mass"]), normal @ v["point"] @ n
    stiffness = reduce(v["stiffness"] + tyre * np.outer(v["height"], v["height"]))
    receptances = [j @ np.linalg.solve(stiffness - w * w * mass, j) for w in omegas]
    sizes, axes = np.linalg.eigh(mass)
    heavy, light = axes[:, sizes > 1e-9 * sizes[-1]], axes[:, sizes <= 1e-9 * sizes[-1]]
    if light.size:
        heavy = heavy - light @ np.linalg.solve(light.T @ stiffness @ light, light.T @ stiffness @ heavy)
    squares = eigh(heavy.T @ stiffness @ heavy, heavy.T @ mass @ heavy, eigvals_only=True)
    rows = v["rigid"] @ n
    rigid = null_space(rows, rcond=1e-11)
    across = np.linalg.svd(rows)[2][: rows.shape[1] - rigid.shape[1]].T
    inner = np.linalg.pinv(rigid.T @ mass @ rigid, rcond=1e-9)
    motion = rigid @ inner @ rigid.T @ j
    motion = motion / (j @ motion)
    force = j - mass @ motion / (motion @ mass @ motion)
    free = across - rigid @ inner @ rigid.T @ mass @ across
    sizes, axes = np.linalg.eigh(rigid.T @ mass @ rigid)
    light = rigid @ axes[:, sizes <= 1e-9 * sizes[-1]]
    own = light.T @ stiffness @ light
    if light.size and np.linalg.eigvalsh(own)[0] > 1e-9 * np.abs(stiffness).max():
        free = free - light @ np.linalg.solve(own, light.T @ stiffness @ free)
    held = across.T @ (rows.T * v["k"]) @ rows @ across + free.T @ reduce(v["geometric"]) @ free
    applied = across.T @ force
    return np.sqrt(np.abs(squares)) / (2 * np.pi), applied @ np.linalg.solve(held, applied), receptances


def car(rng):
    """Random sheet as text, its data, bushes by their axes, spring, travel held."""
    text = SHEET.read_text()
    head, skipped = [], False
    for line in text[: text.index("[bush.lower_front]")].split("\n"):
        if line.startswith("["):
            skipped = line.startswith(("[anti_roll_bar]", "[drop_link]"))
        if not skipped and not line.startswith(("anti_roll_bar_", "drop_link_")):
            head.append(line)
    for i, line in enumerate(head):
        key, found, rest = line.partition(" = [")
        if found and key in tomllib.loads(text)["points"] and key != "wheel_centre":
            values = [float(x) + rng.uniform(-12, 12) for x in rest.split("]")[0].split(",")]
            head[i] = f"{key} = {values}"
    spring = (rng.uniform(2e4, 8e4), 0.0 if rng.random() < 0.4 else rng.uniform(1e3, 7e3))
    preload = f'preload = "{spring[1]!r} N"\n' if spring[1] else ""
    text = "\n".join(head).replace("[spring]\n", f'[spring]\nrate = "{spring[0]!r} N/m"\n{preload}')
    points = tomllib.loads(text)["points"]
    bushes = {}
    for name, body in BODY_OF.items():
        z = rng.normal(size=3) if rng.random() < 0.4 or body == "tie" else None
        axis = np.array(points[HINGES[body][1]]) - np.array(points[HINGES[body][0]]) if z is None else z
        axis = axis / np.linalg.norm(axis)
        x = rng.normal(size=3)
        y = np.cross(axis, x)
        y /= np.linalg.norm(y)
        axes = np.column_stack([np.cross(y, axis), y, axis])
        rates = np.concatenate([10 ** rng.uniform(1.5, 3, 3), 10 ** rng.uniform(5.8, 7.2, 3)])
        force, moment = np.zeros(3), np.zeros(3)
        if rng.random() < 0.4:
            force, moment = rng.uniform(-1500, 1500, 3), rng.uniform(-20, 20, 3)
        bushes[name] = (axes, rates, np.concatenate([axes.T @ moment, axes.T @ force]))
        numbers = lambda values: [float(v) for v in values]
        with_unit = lambda values, unit: "[" + ", ".join(f'"{float(v)!r} {unit}"' for v in values) + "]"
        text += f"\n[bush.{name}]\nradial = {with_unit(rates[3:5], 'N/m')}\naxial = \"{float(rates[5])!r} N/m\"\nconical = {with_unit(rates[:2], 'N·m/rad')}\n"
        text += f"torsional = \"{float(rates[2])!r} N·m/rad\"\nx_axis = {numbers(x)}\n" + (f"axis = {numbers(z)}\n" if z is not None else "")
        if force.any():
            text += f"preload = {with_unit(force, 'N')}\npreload_torque = {with_unit(moment, 'N·m')}\n"
    tyre = rng.uniform(1e5, 3e5)
    text += f'\n[tyre]\nvertical = "{tyre!r} N/m"\n'
    return text, tomllib.loads(text), bushes, spring, bool(rng.random() < 0.5), tyre


def at_link(sheet):
    """Wheel centre in the frame of the upright, whose origin is its lower ball joint."""
    return (np.array(sheet["points"]["wheel_centre"]) - np.array(sheet["points"]["lower_ball"])) * 1e-3


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--percuss", required=True)
    parser.add_argument("--count", type=int, default=40)
    parser.add_argument("--seed", type=int, default=1)
    args = parser.parse_args()
    passed, failed, worst, vibrating = 0, 0, 0.0, 0.0
    with tempfile.TemporaryDirectory() as folder:
        for number in range(args.count):
            text, sheet, bushes, spring, held, tyre = car(np.random.default_rng([args.seed, number]))
            path = Path(folder) / "car.toml"
            path.write_text(text)
            words = [args.percuss, "kinematics", str(path), "--compliance", "--format", "json", *(["--travel-held"] if held else [])]
            found = subprocess.run(words, capture_output=True, text=True)
            wrong = []
            if found.returncode != 0:
                wrong = [found.stderr]
            else:
                report = json.loads(found.stdout)
                table, matrix, _ = answer(sheet, bushes, spring, held)
                loaded = spring[1] != 0 or any(forces.any() for _, _, forces in bushes.values())
                limit = PRELOADED if loaded else TOLERANCE
                # A held height does not move.
                sizes = {name: max(abs(value) for key, value in table.items() if key.startswith(name)) for name in QUANTITIES}
                largest = {name: max(size, 1e-3 * sizes["wheel_centre_y"]) for name, size in sizes.items()}
                for key, value in table.items():
                    got = report["rows"][0][key]
                    scale = largest[key.split("_per_")[0]]
                    error = abs(got - value) / scale if got is not None else np.inf
                    worst = max(worst, error)
                    if not error <= limit:
                        wrong.append(f"{key}: {got} for {value}")
                got = report["compliance_matrices"][0]
                error = np.inf if got is None else np.abs(np.array(got) - matrix).max() / np.abs(matrix).max()
                worst = max(worst, error)
                if not error <= limit:
                    wrong.append(f"compliance matrix: {error}")
                normal = np.array([0.48, 0.6, 0.64])
                words = ["--link", "upright", f"--point={','.join(repr(float(x)) for x in POINT + at_link(sheet))}", "--normal=0.48,0.6,0.64"]
                found = subprocess.run([args.percuss, "response", str(path), *words, "--frequency", "3:300Hz:6", "--format", "json"], capture_output=True, text=True)
                if found.returncode != 0:
                    wrong.append(found.stderr)
                else:
                    report = json.loads(found.stdout)
                    omegas = 2 * np.pi * np.array(report["frequency"])
                    squares, compliance, h = vibrations(answer(sheet, bushes, spring, False)[2], normal, tyre, omegas)
                    modes = np.array([mode["frequency"] for mode in report["modes"]])[-len(squares):]
                    pairs = [("residual compliance", report["compliance"]["residual_compliance"], compliance, limit)]
                    pairs += [("frequency", a, b, FREQUENCY) for a, b in zip(modes, squares)]
                    mobility = report["mobility"]
                    pairs += [("receptance", complex(re, im) / (1j * w), value, limit * np.abs(h).max() / abs(value))
                              for re, im, w, value in zip(mobility["real"], mobility["imaginary"], omegas, h)]
                    left_out = [found for found in report["diagnostics"] if found["code"] == "no-geometric-stiffness"]
                    wrong += [found["message"] for found in left_out]
                    for what, got, value, most in pairs:
                        error = abs(got - value) / abs(value)
                        vibrating = max(vibrating, error)
                        if not error <= most:
                            wrong.append(f"{what}: {got} for {value}")
            passed, failed = passed + (not wrong), failed + bool(wrong)
            for line in wrong[:4]:
                print(f"car {number}: {line}")
    print(f"largest difference {worst:.1e}, of vibrations {vibrating:.1e}; {passed} passed, {failed} failed")
    sys.exit(failed > 0)


if __name__ == "__main__":
    main()
