"""Pictures with matplotlib: axes of a sweep, a map, the ellipsoid of m̄ at a point.

Each function draws on given axes or on those of a new figure, and returns them. Needs matplotlib.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ._percuss import Pose, Sweep
from .errors import InputError, NoAnswerError
from .reports import MapReport

__all__ = ["plot_ellipsoid", "plot_map", "plot_sweep"]

#: Points of an ellipsoid along its meridians and parallels: smooth at the size of a page.
_ELLIPSOID_POINTS = 40
#: Factor of the values from which a scale is logarithmic, and of the largest value over the quantile from which it ends there.
_LOGARITHMIC, _CAP = 20.0, 0.95


def _new_axes(projection: str | None = None) -> Any:
    import matplotlib.pyplot as plt

    return plt.figure(layout="constrained").add_subplot(projection=projection)


def plot_sweep(swept: Sweep, x: ArrayLike | None = None, *, label: str | None = None, ax: Any = None) -> Any:
    """m̄ over x (N,), by default the row number, with the stated error as a band. Rows that are not finite leave a gap."""
    axes = _new_axes() if ax is None else ax
    rows = np.arange(len(swept)) if x is None else np.asarray(x)
    if rows.shape != (len(swept),):
        raise InputError(f"x has shape {rows.shape}; expected ({len(swept)},), a number for each row of the sweep")
    mass, error = swept.effective_mass, np.nan_to_num(swept.error)
    (line,) = axes.plot(rows, mass, label=label)
    axes.fill_between(rows, mass - error, mass + error, color=line.get_color(), alpha=0.3, linewidth=0)
    axes.set_xlabel("row" if x is None else "")
    axes.set_ylabel("effective mass (kg)")
    return axes


def plot_map(report: MapReport, *, quantity: str = "effective_mass", ax: Any = None) -> Any:
    """Surfaces of a map in space, facets coloured by a quantity of MapReport.facets, with the scale of ``percuss map``: logarithmic if the
    values extend over a factor of 20; ending at the value that 95 % of the facets do not exceed if a few values are far above all others.

        >>> percuss.plots.plot_map(percuss.map(model, links=["finger"]))
    """
    from matplotlib.colors import LogNorm, Normalize
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection

    axes = _new_axes("3d") if ax is None else ax
    points = np.concatenate([facets["points_world"] for facets in report.facets.values()])
    if quantity not in ("effective_mass", "area", "error"):
        raise InputError(f"quantity is {quantity!r}; expected 'effective_mass', 'area' or 'error'")
    values = np.concatenate([facets[quantity] for facets in report.facets.values()])
    area = np.concatenate([facets["area"] for facets in report.facets.values()])
    normals = np.concatenate([facets["normals_world"] for facets in report.facets.values()])
    known = np.isfinite(values) & (values > 0)
    if not known.any():
        raise NoAnswerError(f"no facet of the map has a {quantity}: nothing to draw")
    low, high = values[known].min(), values[known].max()
    quantile = np.sort(values[known])[int(_CAP * (known.sum() - 1))]
    is_capped = bool(high > _LOGARITHMIC * quantile)
    high = quantile if is_capped else high
    scale = (LogNorm if high > _LOGARITHMIC * low else Normalize)(low, high)
    drawn = Poly3DCollection(squares_of(points[known], normals[known], area[known]), norm=scale)
    drawn.set_array(values[known])
    axes.add_collection3d(drawn)
    _equal(axes, points[known])
    axes.figure.colorbar(drawn, ax=axes, extend="max" if is_capped else "neither", label="effective mass (kg)" if quantity == "effective_mass" else quantity)
    return axes


def squares_of(points: Any, normals: Any, area: Any) -> Any:
    """Squares of the given areas about points, at right angles to the normals: (k, 4, 3)."""
    axis = np.eye(3)[np.argmin(np.abs(normals), axis=1)]
    e1 = np.cross(normals, axis)
    e1 /= np.linalg.norm(e1, axis=1, keepdims=True)
    e2 = np.cross(normals, e1)
    half = np.sqrt(area)[:, None] / 2
    corners = [(1, 1), (-1, 1), (-1, -1), (1, -1)]
    return np.stack([points + half * (a * e1 + b * e2) for a, b in corners], axis=1)


def _equal(axes: Any, points: Any) -> None:
    """Limits of the axes around points, at one scale."""
    low, high = points.min(axis=0), points.max(axis=0)
    middle, half = (low + high) / 2, (high - low).max() / 2 or 1.0
    for set_limits, centre in zip((axes.set_xlim, axes.set_ylim, axes.set_zlim), middle):
        set_limits(centre - half, centre + half)
    axes.set_box_aspect((1, 1, 1))
    axes.set(xlabel="x (m)", ylabel="y (m)", zlabel="z (m)")


def ellipsoid_of(pose: Pose, link: str, point: ArrayLike, scale: float | None) -> tuple[Any, Any, Any, Any]:
    """Centre (3,), half axes (3,) in m, directions (3, 3) by columns in root axes, and the principal masses."""
    principal = pose.principal_masses(link, point)
    if principal is None:
        raise NoAnswerError(f'the masses at the point of "{link}" have no principal directions: motions without mass')
    frame = pose.link_frame(link, frame="root")
    centre = frame[:3, :3] @ np.asarray(point, dtype=np.float64) + frame[:3, 3]
    # Without a mass in a direction, the point does not move in it.
    halves = np.array([0.0 if p["effective_mass"] is None else p["effective_mass"] ** -0.5 for p in principal])
    directions = frame[:3, :3] @ np.stack([np.asarray(p["direction"]) for p in principal], axis=1)
    if scale is None:
        scale = max(0.1, 0.1 * float(np.linalg.norm(centre))) / max(float(halves.max()), 1e-300)
    return centre, halves * scale, directions, principal


def plot_ellipsoid(pose: Pose, link: str, point: ArrayLike, *, scale: float | None = None, ax: Any = None) -> Any:
    """Ellipsoid of mobility at a point of a link, in root axes: half axes 1/√m̄ along the principal directions.

    scale: metres per 1/√kg; default: the longest half axis is a tenth of the distance from the root, at least 0.1 m. The belted
    surface of m̄ itself is not convex; this ellipsoid is nᵀ Φ n of the contact (Khatib 1987).
    """
    axes = _new_axes("3d") if ax is None else ax
    centre, halves, directions, principal = ellipsoid_of(pose, link, point, scale)
    turn, tilt = np.meshgrid(
        np.linspace(0, 2 * np.pi, _ELLIPSOID_POINTS), np.linspace(0, np.pi, _ELLIPSOID_POINTS // 2)
    )
    sphere = np.stack([np.cos(turn) * np.sin(tilt), np.sin(turn) * np.sin(tilt), np.cos(tilt)])
    surface = np.einsum("ij,jkl->ikl", directions * halves, sphere) + centre[:, None, None]
    axes.plot_surface(*surface, alpha=0.4)
    for k, mass in enumerate(principal):
        end = centre + directions[:, k] * halves[k]
        axes.plot(*np.stack([centre, end], axis=1))
        known = mass["effective_mass"]
        axes.text(*end, "immovable" if known is None else f"{known:.3g} kg")
    _equal(axes, surface.reshape(3, -1).T)
    return axes
