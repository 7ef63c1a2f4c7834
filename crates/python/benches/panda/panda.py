"""m̄ of the Panda in 100,000 random rows with a contact point and a normal each: percuss.sweep compared with Pinocchio in Python and C++.
The program compares every m̄, and prints the CPU time per row: the least of several runs, with the libraries in turn. It compiles the
C++ program with the headers of the packages pin and cmeel-eigen.

    panda.py [--rows N] [--package FOLDER]      needs pin, example-robot-data, numpy and, for C++, g++
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import tempfile
import time
import warnings
from pathlib import Path

import numpy as np

# Both sides solve by Cholesky with condition numbers of M up to some thousand.
TOLERANCE = 1e-10
RUNS = 5
LINK = "panda_link7"


def options() -> list[str]:
    """Options of the compiler: folders of headers, and the lengths of Boost's type lists that Pinocchio requires."""
    import pinocchio

    prefix = next(p for p in Path(pinocchio.__file__).parents if p.name == "cmeel.prefix")
    eigen = [p for p in (prefix / "include/eigen3", Path("/usr/include/eigen3")) if p.exists()]
    limits = ["-DBOOST_MPL_LIMIT_LIST_SIZE=30", "-DBOOST_MPL_LIMIT_VECTOR_SIZE=30", "-DBOOST_FUSION_INVOKE_MAX_ARITY=12"]
    return [*limits, "-DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS", *(f"-I{folder}" for folder in (prefix / "include", *eigen))]


def description(model: object, frame: object) -> str:
    """Joints and inertias of a pinocchio.Model, for pinocchio.cc."""

    def numbers(*arrays: object) -> str:
        return " ".join(repr(float(x)) for array in arrays for x in np.asarray(array).ravel())

    lines = [f"{frame.parentJoint} {numbers(frame.placement.rotation, frame.placement.translation)}"]
    for k in range(1, model.njoints):
        joint = model.joints[k].extract() if hasattr(model.joints[k], "extract") else model.joints[k]
        axis = getattr(joint, "axis", [0.0, 0.0, 0.0])
        at, inertia = model.jointPlacements[k], model.inertias[k]
        parts = numbers(at.rotation, at.translation, inertia.mass, inertia.lever, inertia.inertia)
        lines.append(f"{model.joints[k].shortname()} {model.parents[k]} {numbers(axis)} {parts}")
    return "\n".join(lines)


def main() -> None:
    flags = argparse.ArgumentParser()
    flags.add_argument("--rows", type=int, default=100_000)
    flags.add_argument("--package", type=Path)
    given = flags.parse_args()
    if given.package:
        sys.path.insert(0, str(given.package))
    import pinocchio as pin

    import percuss

    warnings.simplefilter("ignore", percuss.ModelWarning)
    root = next(p for p in Path(pin.__file__).parents if p.name == "cmeel.prefix")
    urdf = root / "share/example-robot-data/robots/panda_description/urdf/panda.urdf"
    text = urdf.read_text()
    # The second finger mimics the first, which Pinocchio leaves out.
    text = "\n".join(line for line in text.splitlines() if "<mimic" not in line)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "panda.urdf"
        path.write_text(text)
        peer = pin.buildModelFromUrdf(str(path))
        data = peer.createData()
        model = percuss.load(path)
        converter = percuss.converters.Converter.of_pinocchio(model, peer)
        random = np.random.default_rng(0)
        lower, upper = peer.lowerPositionLimit, peer.upperPositionLimit
        rows = random.uniform(lower, upper, (given.rows, peer.nq))
        points, normals = random.uniform(-0.1, 0.1, (given.rows, 3)), random.normal(size=(given.rows, 3))
        q = converter.positions(rows)
        contact = percuss.Contact(LINK, [0, 0, 0], [0, 0, 1])
        assembly = model.assemble()
        frame = peer.getFrameId(LINK, pin.FrameType.BODY)

        def by_percuss() -> np.ndarray:
            return percuss.sweep(assembly, contact, q, points=points, normals=normals, threads=1).effective_mass

        def by_python() -> np.ndarray:
            found = np.empty(given.rows)
            for k in range(given.rows):
                mass = pin.crba(peer, data, rows[k])
                jacobian = pin.computeFrameJacobian(peer, data, rows[k], frame, pin.LOCAL_WORLD_ALIGNED)
                rotation = data.oMf[frame].rotation
                direction = rotation @ normals[k]
                direction /= np.sqrt(direction @ direction)
                arm = rotation @ points[k]
                row = direction @ jacobian[:3] + np.cross(arm, direction) @ jacobian[3:]
                found[k] = 1.0 / (row @ np.linalg.solve(mass, row))
            return found

        program = Path(folder) / "pinocchio"
        source = str(Path(__file__).with_name("pinocchio.cc"))
        compiled = subprocess.run(
            ["g++", "-std=c++17", "-O3", "-march=native", "-DNDEBUG", "-w", source, "-o", str(program), *options()],
            capture_output=True, text=True,
        )
        if compiled.returncode:
            print(compiled.stderr[-2000:], "Pinocchio's C++ could not be compiled", sep="\n")
        (Path(folder) / "model").write_text(description(peer, peer.frames[frame]))
        np.hstack([rows, points, normals]).tofile(Path(folder) / "rows")

        def by_cpp() -> tuple[np.ndarray, float]:
            words = [str(program), str(Path(folder) / "model"), str(Path(folder) / "rows"), str(Path(folder) / "masses"), "1"]
            seconds = float(subprocess.run(words, capture_output=True, text=True, check=True).stdout)
            return np.fromfile(Path(folder) / "masses"), seconds

        spent = {"percuss": np.inf, "Pinocchio, Python": np.inf, "Pinocchio, C++": np.inf}
        found: dict[str, np.ndarray] = {}
        for run in range(RUNS):
            for name, work in (("percuss", by_percuss), ("Pinocchio, Python", by_python)):
                if name != "percuss" and run > 1:
                    continue
                begun = time.process_time()
                found[name] = work()
                spent[name] = min(spent[name], time.process_time() - begun)
            if compiled.returncode == 0:
                found["Pinocchio, C++"], seconds = by_cpp()
                spent["Pinocchio, C++"] = min(spent["Pinocchio, C++"], seconds)
        for name, masses in found.items():
            worst = np.abs(masses / found["percuss"] - 1).max()
            assert worst <= TOLERANCE, f"{name}: {worst}"
            ratio = spent[name] / spent["percuss"]
            print(f"{name}: {1e9 * spent[name] / given.rows:.1f} ns for a row, {ratio:.1f} times percuss; largest difference {worst:.1e}")
        print(f"m̄ from {found['percuss'].min():.4f} to {found['percuss'].max():.1f} kg, {given.rows} rows")


if __name__ == "__main__":
    main()
