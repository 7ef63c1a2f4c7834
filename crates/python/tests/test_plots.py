"""Pictures of sweeps, maps and ellipsoids show the numbers that they are drawn from."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import matplotlib
import numpy as np
import pytest
from cases import ROOT

import percuss
from percuss import plots, view

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


def test_facets_of_a_map_are_drawn_as_the_link_is_turned() -> None:
    model = percuss.load(ROOT / "models/shaped_arm.urdf")
    turned = {joint.name: 0.7 for joint in model.joints if joint.kind in ("revolute", "continuous")}
    report = percuss.map(model, percuss.Conditions(set=turned))
    pose = model.pose(turned)
    for link, facets in report.facets.items():
        frame = pose.link_frame(link)
        assert facets["normals_world"] == pytest.approx(facets["normals"] @ frame[:3, :3].T, abs=1e-12)
        assert facets["points_world"] == pytest.approx(facets["points"] @ frame[:3, :3].T + frame[:3, 3], abs=1e-12)
        squares = plots.squares_of(facets["points_world"], facets["normals_world"], facets["area"])
        edges = np.stack([squares[:, 1] - squares[:, 0], squares[:, 3] - squares[:, 0]], axis=1)
        assert np.abs(np.einsum("kij,kj->ki", edges, facets["normals_world"])).max() < 1e-9
        assert np.linalg.norm(np.cross(edges[:, 0], edges[:, 1]), axis=1) == pytest.approx(facets["area"], rel=1e-9)


class Recorder:
    """A Visualizer that keeps the objects and their transforms by path."""

    def __init__(self, path: str = "", kept: dict[str, dict[str, Any]] | None = None) -> None:
        self.path, self.kept = path, {} if kept is None else kept

    def __getitem__(self, name: str) -> Recorder:
        return Recorder(f"{self.path}/{name}", self.kept)

    def delete(self) -> None:
        for path in [path for path in self.kept if path.startswith(self.path)]:
            del self.kept[path]

    def set_object(self, shape: Any, material: Any = None) -> None:
        self.kept.setdefault(self.path, {})["object"] = (shape, material)

    def set_transform(self, matrix: Any) -> None:
        self.kept.setdefault(self.path, {})["transform"] = matrix


def test_a_view_has_links_contact_ellipsoid_and_map() -> None:
    pytest.importorskip("meshcat")
    model = percuss.load(ROOT / "models/shaped_arm.urdf")
    report = percuss.map(model)
    pose = model.pose()
    link = next(iter(report.facets))
    contact = percuss.Contact(link, [0.02, 0.01, 0.0], [0.0, 1.0, 0.0])
    recorder = Recorder()
    assert view.show(pose, contact, report=report, scale=1.0, viewer=recorder) is recorder
    kept = recorder.kept
    assert {f"/percuss/origins/{name}" for name in model.links} <= set(kept)
    origin = kept[f"/percuss/origins/{link}"]["transform"][:3, 3]
    assert origin == pytest.approx(pose.link_frame(link)[:3, 3])
    response = pose.respond(contact)
    start, end = np.asarray(kept["/percuss/contact/normal"]["object"][0].geometry.position).T
    assert (end - start) / np.linalg.norm(end - start) == pytest.approx(response.normal_world, abs=1e-6)
    # The half axes of the ellipsoid: sqrt(n·Φ n) along its axes.
    shape, placed = kept["/percuss/contact/ellipsoid"]["object"][0], kept["/percuss/contact/ellipsoid"]["transform"]
    phi = pose.inverse_operational_inertia(contact)[3:6, 3:6]
    assert np.linalg.det(placed[:3, :3]) == pytest.approx(1)
    for radius, direction in zip(shape.radii, placed[:3, :3].T):
        assert radius == pytest.approx(np.sqrt(max(direction @ phi @ direction, 0.0)), rel=1e-6, abs=2e-3 * max(shape.radii))
    for name, facets in report.facets.items():
        surface = kept[f"/percuss/map/{name}"]["object"][0]
        masses = facets["effective_mass"]
        assert len(surface.vertices) == 4 * len(masses) and len(surface.faces) == 2 * len(masses)
        colours = np.asarray(surface.color)[::4]
        known = np.isfinite(masses)
        if not known.any():
            assert (colours == colours[0]).all()
            continue
        lightest, heaviest = masses[known].argmin(), masses[known].argmax()
        assert colours[known][lightest] == pytest.approx(np.array([68, 1, 84]) / 255, abs=1e-6)
        assert colours[known][heaviest] == pytest.approx(np.array([253, 231, 37]) / 255, abs=1e-6)
    view.show(pose, viewer=recorder)
    assert not any(path.startswith(("/percuss/contact", "/percuss/map")) for path in kept)
    with pytest.raises(percuss.InputError, match="pose"):
        view.show(model, viewer=recorder)  # type: ignore[arg-type]


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


def test_a_few_huge_values_do_not_take_the_scale_of_a_map() -> None:
    """The last of a hundred facets has a mass of 1e18 kg: the scale ends at the 95th of 100 values, as that of the command."""
    masses = np.append(np.linspace(1.0, 2.0, 99), 1e18)
    points, normals = np.random.default_rng(0).normal(size=(2, 100, 3))
    facets = {"effective_mass": masses, "points_world": points, "normals_world": normals, "area": np.full(100, 1e-4)}
    ax = plots.plot_map(SimpleNamespace(facets={"link": facets}))  # type: ignore[arg-type]
    assert ax.collections[0].norm.vmax == pytest.approx(masses[94]) and ax.collections[0].norm.vmin == 1.0
