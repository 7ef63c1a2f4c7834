"""Suspension over its wheel travel: the effective mass at the spring, the classical estimate, and the damper of a bump
stop.

    suspension_study.py [SHEET.toml]
"""

from __future__ import annotations

import sys
import warnings
from pathlib import Path

import percuss

SHEET = Path(__file__).resolve().parents[3] / "models/suspensions/double-wishbone.toml"


def main() -> None:
    # Some real inertias violate the triangle inequality, which raises a warning.
    warnings.simplefilter("ignore", percuss.ModelWarning)
    corner = percuss.suspension.load(Path(sys.argv[1]) if len(sys.argv) > 1 else SHEET)
    spring = percuss.Contact(
        "spring_seat", [0, 0, 0], toward=("spring_chassis_seat", [0, 0, 0]), against="chassis"
    )
    conditions = percuss.Conditions(estimate=(["wheel", "spindle", "upright"], [0, 0, 0], [0, 0, 1]))
    travel = "travel:wheel:0,0,0:0,0,1=-40mm:40mm:9"
    report = percuss.reports.sweep_report(corner, spring, conditions, vary=travel)
    print("travel (mm)   effective mass (kg)   estimate (kg)   motion ratio")
    for row in report.rows:
        (where,) = row["varied"].values()
        print(f"{1e3 * where:11.1f} {row['effective_mass']:21.4f} {row['estimate']:15.4f} {row['motion_ratio']:14.4f}")
    damping = percuss.contact_law.Damping(restitution=0.3, stiffness=2e5, speed=1.0)
    damper = percuss.contact_law.damp_contact(corner, spring, damping)
    print(f"for e = 0.3 on 200 N/mm, {damper.effective_mass:.4f} kg: damping ratio {damper.damping_ratio:.6f}")


if __name__ == "__main__":
    main()
