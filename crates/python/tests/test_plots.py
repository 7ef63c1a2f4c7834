"""Pictures of sweeps, maps and ellipsoids show the numbers that they are drawn from."""

from __future__ import annotations

import matplotlib
import numpy as np
import pytest
from cases import ROOT

import percuss
from percuss import plots

matplotlib.use("Agg")

ARM = percuss.load(ROOT / "models/six_r_arm.urdf")
TOOL = percuss.Contact("tool", [0.08, 0, 0], [0, 1, 0])


def test_a_sweep_is_a_line_with_a_band() -> None:
    swept = percuss.sweep(ARM, TOOL, np.linspace(0, 1, 50)[:, None] * np.ones(ARM.position_count))
    ax = plots.plot_sweep(swept, np.linspace(0, 1, 50), label="tool")
    (line,) = ax.lines
    assert (line.get_ydata() == swept.effective_mass).all() and line.get_xdata()[-1] == 1
    assert len(ax.collections) == 1 and "kg" in ax.get_ylabel()
    with pytest.raises(percuss.InputError, match=r"\(50,\)"):
        plots.plot_sweep(swept, np.zeros(3))


def test_a_map_colours_its_facets() -> None:
    report = percuss.map(percuss.load(ROOT / "models/shaped_arm.urdf"))
    ax = plots.plot_map(report)
    (drawn,) = ax.collections
    masses = np.concatenate([facets["effective_mass"] for facets in report.facets.values()])
    assert np.sort(np.asarray(drawn.get_array())) == pytest.approx(np.sort(masses[np.isfinite(masses)]))
    with pytest.raises(percuss.InputError, match="quantity"):
        plots.plot_map(report, quantity="colour")


def test_an_ellipsoid_has_the_principal_masses_as_labels() -> None:
    pose = ARM.pose({"elbow": 0.5})
    principal = pose.principal_masses("tool", [0.08, 0, 0])
    assert principal is not None
    ax = plots.plot_ellipsoid(pose, "tool", [0.08, 0, 0], scale=1.0)
    shown = [text.get_text() for text in ax.texts]
    assert shown == [f"{mass['effective_mass']:.3g} kg" for mass in principal]
    # The longest half axis is that of the lightest direction.
    lengths = [float(np.linalg.norm(np.diff(np.stack(line.get_data_3d()), axis=1))) for line in ax.lines]
    assert lengths == pytest.approx([float(mass["effective_mass"] or 0) ** -0.5 for mass in principal])
