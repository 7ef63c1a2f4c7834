"""One effective mass by a scalar call from Python: percuss compared with code for Pinocchio and MuJoCo, and the cost of
the call alone. Run it where the compared programs are installed. CPU time of the thread; libraries of linear algebra
must not start their own threads (OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1).

    scalar.py [URDF LINK]
"""

from __future__ import annotations

import importlib.util
import re
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np

import percuss

ROOT = Path(__file__).resolve().parents[3]
POINT, NORMAL = np.array([0.08, 0.0, 0.0]), np.array([0.0, 1.0, 0.0])


TURNS = 25


def best_of(calls: dict[str, Callable[[np.ndarray], object]], rows: np.ndarray) -> dict[str, float]:
    """Microseconds per call: CPU time of this thread, the least of several turns, with all calls in each turn."""
    best = dict.fromkeys(calls, np.inf)
    for _ in range(TURNS):
        for name, call in calls.items():
            begun = time.thread_time_ns()
            for row in rows:
                call(row)
            best[name] = min(best[name], 1e-3 * (time.thread_time_ns() - begun) / len(rows))
    return best


def main() -> None:
    path = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "models/six_r_arm.urdf"
    link = sys.argv[2] if len(sys.argv) > 2 else "tool"
    model = percuss.load(path)
    contact = percuss.Contact(link, POINT, NORMAL)
    rows = np.random.default_rng(0).uniform(-1, 1, (1000, model.position_count))
    assembly = model.assemble()
    workspace = assembly.workspace(contact)
    expected = workspace.effective_mass(rows[0])
    calls: dict[str, Callable[[np.ndarray], object]] = {}

    def add(name: str, call: Callable[[np.ndarray], float | None]) -> None:
        value = call(rows[0])
        assert value is not None and expected is not None and abs(value / expected - 1) < 1e-9, (name, value, expected)
        calls[name] = call

    add("percuss, Workspace.effective_mass", workspace.effective_mass)
    add("percuss, Assembly.pose().respond()", lambda q: assembly.pose(q).respond(contact).effective_mass)
    if importlib.util.find_spec("pinocchio"):
        import pinocchio as pin

        peer = pin.buildModelFromXML(re.sub(r"<\?percuss.*?\?>", "", path.read_text()))
        data = peer.createData()
        frame = peer.getFrameId(link, pin.FrameType.BODY)

        def of_pinocchio(q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
            pin.crba(peer, data, q)
            mass = np.triu(data.M) + np.triu(data.M, 1).T
            pin.computeJointJacobians(peer, data, q)
            pin.updateFramePlacements(peer, data)
            jacobian = pin.getFrameJacobian(peer, data, frame, pin.LOCAL_WORLD_ALIGNED)
            turn = data.oMf[frame].rotation
            return mass, (turn @ NORMAL) @ (jacobian[:3] - pin.skew(turn @ POINT) @ jacobian[3:])

        def by_pinocchio(q: np.ndarray) -> float:
            mass, row = of_pinocchio(q)
            return float(1 / (row @ np.linalg.solve(mass, row)))

        add("Pinocchio and numpy", by_pinocchio)
        add("Pinocchio and percuss.effective_mass", lambda q: percuss.effective_mass(*of_pinocchio(q)).effective_mass)
        calls["of these, Pinocchio's crba alone"] = lambda q: pin.crba(peer, data, q)
    if importlib.util.find_spec("mujoco"):
        import mujoco

        text = re.sub(r"<\?percuss.*?\?>|<(visual|collision)\b.*?</\1>", "", path.read_text(), flags=re.S)
        compiler = '<mujoco><compiler fusestatic="false" balanceinertia="false" inertiafromgeom="false"/></mujoco>'
        text = re.sub(r"(<robot\b[^>]*>)", lambda found: found[1] + compiler, text, count=1)
        m = mujoco.MjModel.from_xml_string(text)
        d = mujoco.MjData(m)
        mass, jacobian, body = np.zeros((m.nv, m.nv)), np.zeros((3, m.nv)), m.body(link).id

        def by_mujoco(q: np.ndarray) -> float:
            d.qpos[:] = q
            mujoco.mj_fwdPosition(m, d)
            mujoco.mj_fullM(m, d, mass)
            turn = d.xmat[body].reshape(3, 3)
            mujoco.mj_jac(m, d, jacobian, None, d.xpos[body] + turn @ POINT, body)
            row = (turn @ NORMAL) @ jacobian
            return float(1 / (row @ np.linalg.solve(mass, row)))

        add("MuJoCo and numpy", by_mujoco)
        calls["of these, mj_fwdPosition alone"] = lambda q: mujoco.mj_fwdPosition(m, d)
    calls["an attribute of percuss (what a call costs)"] = lambda q: workspace.status
    calls["an empty function of Python's"] = lambda q: None
    for name, spent in best_of(calls, rows).items():
        print(f"{name:46} {spent:8.2f} µs")


if __name__ == "__main__":
    main()
