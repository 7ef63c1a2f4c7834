"""Reflected mass of an arm's hand along a trajectory, and the safe speed of the hand near a person.

The trajectory is a CSV of joint angles: a header with the joints' names, rad; the default is a built-in reaching
motion. The force limit is an example: use the limit from the applicable edition of the standard.

    arm_trajectory.py [ARM.urdf LINK ANGLES.csv]
"""

from __future__ import annotations

import csv
import sys
from pathlib import Path

import numpy as np

import percuss

ARM = Path(__file__).with_name("seven_axis_arm.urdf")
FORCE = 140.0  # N
REGION = "chest"
POINT, NORMAL = [0.0, 0.0, 0.1], [0.0, 0.0, 1.0]


def trajectory(model: percuss.Model, path: str | None) -> tuple[list[str], np.ndarray]:
    """Joint names, and a row of angles per time step."""
    if path is not None:
        with open(path, newline="") as file:
            heading, *rows = csv.reader(file)
        return heading, np.array(rows, dtype=float)
    names = [joint.name for joint in model.joints if joint.kind != "fixed"]
    start = np.array([0.0, -0.4, 0.0, 1.8, 0.0, 1.2, 0.0])
    end = np.array([0.8, 0.7, 0.3, 0.9, 0.4, 0.6, 0.5])
    smooth = 0.5 - 0.5 * np.cos(np.linspace(0, np.pi, 101))
    return names, start + smooth[:, None] * (end - start)


def main() -> None:
    path, link, angles = (*sys.argv[1:4], *[None] * 3)[:3]
    model = percuss.load(path or ARM)
    contact = percuss.Contact(link or "hand", POINT, NORMAL)
    names, q = trajectory(model, angles)
    swept = percuss.sweep(model, contact, q, joints=names)
    print(swept)
    print("row   reflected mass (kg)   safe speed (m/s)   by the standard's M/2 + m_L (m/s)")
    for row in range(0, len(q), max(1, len(q) // 10)):
        mass = "–" if swept.status[row] else f"{swept.effective_mass[row]:.4f}"
        here = percuss.Conditions(set=dict(zip(names, q[row].tolist())))
        safe = percuss.safe_speed(model, contact, REGION, here, force=FORCE)
        print(f"{row:3} {mass:>21} {safe.reflected['speed']:18.3f} {safe.standard['speed']:18.3f}")
    Path("reflected_mass.svg").write_text(swept.to_svg())


if __name__ == "__main__":
    main()
