"""One effective mass by a scalar call from Python: percuss beside what is written with Pinocchio and MuJoCo, and what of it is the
call alone. Run it where what is to be compared is installed.

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


def microseconds(call: Callable[[np.ndarray], object], rows: np.ndarray) -> float:
    best = np.inf
    for _ in range(7):
        begun = time.perf_counter()
        for row in rows:
            call(row)
        best = min(best, (time.perf_counter() - begun) / len(rows))
    return 1e6 * best


def main() -> None:
    path = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "models/six_r_arm.urdf"
    link = sys.argv[2] if len(sys.argv) > 2 else "tool"
    model = percuss.load(path)
    contact = percuss.Contact(link, POINT, NORMAL)
    rows = np.random.default_rng(0).uniform(-1, 1, (2000, model.position_count))
    assembly = model.assemble()
    workspace = assembly.workspace(contact)
    expected = workspace.effective_mass(rows[0])
    found: dict[str, tuple[float, float]] = {}

    def add(name: str, call: Callable[[np.ndarray], float | None]) -> None:
        value = call(rows[0])
        assert value is not None and expected is not None and abs(value / expected - 1) < 1e-9, (name, value, expected)
        found[name] = (microseconds(call, rows), value)

    add("percuss, Workspace.effective_mass", workspace.effective_mass)
    add("percuss, Assembly.pose().respond()", lambda q: assembly.pose(q).respond(contact).effective_mass)
    if importlib.util.find_spec("pinocchio"):
        import pinocchio as pin

        peer = pin.buildModelFromXML(re.sub(r"<\?percuss.*?\?>", "", path.read_text()))
        data = peer.createData()
        frame = peer.getFrameId(link, pin.FrameType.BODY)

        def by_pinocchio(q: np.ndarray) -> float:
            pin.crba(peer, data, q)
            mass = np.triu(data.M) + np.triu(data.M, 1).T
            pin.computeJointJacobians(peer, data, q)
            pin.updateFramePlacements(peer, data)
            jacobian = pin.getFrameJacobian(peer, data, frame, pin.LOCAL_WORLD_ALIGNED)
            turn = data.oMf[frame].rotation
            row = (turn @ NORMAL) @ (jacobian[:3] - pin.skew(turn @ POINT) @ jacobian[3:])
            return float(1 / (row @ np.linalg.solve(mass, row)))

        add("Pinocchio and numpy", by_pinocchio)

        def matrices(q: np.ndarray) -> float | None:
            pin.crba(peer, data, q)
            pin.computeJointJacobians(peer, data, q)
            pin.updateFramePlacements(peer, data)
            mass = np.triu(data.M) + np.triu(data.M, 1).T
            jacobian = pin.getFrameJacobian(peer, data, frame, pin.LOCAL_WORLD_ALIGNED)
            turn = data.oMf[frame].rotation
            row = (turn @ NORMAL) @ (jacobian[:3] - pin.skew(turn @ POINT) @ jacobian[3:])
            return percuss.effective_mass(mass, row).effective_mass

        add("Pinocchio and percuss.effective_mass", matrices)
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
    calls: list[tuple[str, Callable[[np.ndarray], object]]] = [("an attribute of percuss (the call alone)", lambda q: workspace.status)]
    for name, call in calls:
        found[name] = (microseconds(call, rows), np.nan)
    for name, (time_, value) in found.items():
        print(f"{name:42} {time_:8.2f} µs   {'' if np.isnan(value) else f'{value:.12g} kg'}")


if __name__ == "__main__":
    main()
