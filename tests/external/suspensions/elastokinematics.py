"""Elastokinematics of double wishbones compared with an independent program.

    elastokinematics.py --percuss PATH [--count N] [--seed S]                 prints `N passed, N failed`

N cars: the hardpoints of models/suspensions/double-wishbone-bushes.toml displaced; random bushes with different rates in all directions, random axes,
preloads and spring; travel held or not. All motions per load and the compliance matrix of `percuss kinematics --compliance` are compared. The program here shares
no code and no method with percuss: four rigid bodies in maximal coordinates with rotations to second order, energies of bushes, spring and wheel load
as polynomials of second order, and the second derivative of the Lagrange function in the null space of the constraints. Of the forces of the bushes
at the pose, the part that is not given follows from their stiffness (docs/howto/BUSHES.md).
"""

import argparse
import json
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

import numpy as np
from scipy.linalg import lstsq, null_space

ROOT = Path(__file__).resolve().parents[3]
SHEET = ROOT / "models/suspensions/double-wishbone-bushes.toml"
# Condition of the stiffness 1e5; with preloads, percuss has second derivatives by differences of fourth order.
TOLERANCE, PRELOADED = 1e-9, 1e-8
BODIES = ["lower", "upper", "upright", "tie"]
SIZE = 6 * len(BODIES)
BODY_OF = {"lower_front": "lower", "lower_back": "lower", "upper_front": "upper", "upper_back": "upper", "tie_rod_inner": "tie"}
HINGES = {"lower": ("lower_front", "lower_back"), "upper": ("upper_front", "upper_back")}
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
    flexible = n @ np.linalg.solve(n.T @ second @ n, n.T)
    patch = point("upright", at["wheel_centre"] - [0, 0, radius])
    of = [[row.gradient for row in rows] for rows in (centre, turn["upright"], patch)]
    loads = {"lateral_force": of[2][1], "braking_force": -of[2][0], "driving_force": of[0][0], "vertical_force": of[2][2], "aligning_torque": of[1][2]}
    motions = dict(zip(QUANTITIES, [-of[1][2], -of[1][0], *of[0], *of[2][:2]]))
    table = {f"{name}_per_{case}": row @ flexible @ g for name, row in motions.items() for case, g in loads.items() if not (held and case == "vertical_force")}
    all_rows = np.array(of[0] + of[1])
    return table, all_rows @ flexible @ all_rows.T


def car(rng):
    """Random sheet as text, its data, bushes by their axes, spring, travel held."""
    text = SHEET.read_text()
    head = text[: text.index("[bush.lower_front]")].split("\n")
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
    return text, tomllib.loads(text), bushes, spring, bool(rng.random() < 0.5)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--percuss", required=True)
    parser.add_argument("--count", type=int, default=40)
    parser.add_argument("--seed", type=int, default=1)
    args = parser.parse_args()
    passed, failed, worst = 0, 0, 0.0
    with tempfile.TemporaryDirectory() as folder:
        for number in range(args.count):
            text, sheet, bushes, spring, held = car(np.random.default_rng([args.seed, number]))
            path = Path(folder) / "car.toml"
            path.write_text(text)
            words = [args.percuss, "kinematics", str(path), "--compliance", "--format", "json", *(["--travel-held"] if held else [])]
            found = subprocess.run(words, capture_output=True, text=True)
            wrong = []
            if found.returncode != 0:
                wrong = [found.stderr]
            else:
                report = json.loads(found.stdout)
                table, matrix = answer(sheet, bushes, spring, held)
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
            passed, failed = passed + (not wrong), failed + bool(wrong)
            for line in wrong[:4]:
                print(f"car {number}: {line}")
    print(f"largest difference {worst:.1e}; {passed} passed, {failed} failed")
    sys.exit(failed > 0)


if __name__ == "__main__":
    main()
