"""View of a mechanism in space with meshcat, in a browser or a notebook: links, contact, ellipsoid of mobility, map.

    >>> from percuss import view
    >>> viewer = view.show(pose, contact, report=percuss.map(model))  # viewer.url() is the address for the browser

Axes of the root link; a map has its own pose. Needs meshcat.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._percuss import Contact, Pose
from .errors import InputError
from .plots import ellipsoid_of, squares_of
from .reports import MapReport

__all__ = ["show"]

_Array = NDArray[np.float64]
#: Colours from a small to a large mass: five points of the scale viridis.
_SCALE = np.array([[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]]) / 255
_LINKS, _CONTACT, _ELLIPSOID = 0x555555, 0xD62728, 0x1F77B4


def colours_of(masses: _Array) -> _Array:
    """Colours (k, 3) of masses on a logarithmic scale; grey without a mass."""
    known = np.isfinite(masses) & (masses > 0)
    found = np.full((len(masses), 3), 0.6)
    if known.any():
        exponents = np.log(masses[known])
        span = max(float(exponents.max() - exponents.min()), 1e-12)
        places = (exponents - exponents.min()) / span * (len(_SCALE) - 1)
        found[known] = np.stack([np.interp(places, np.arange(len(_SCALE)), channel) for channel in _SCALE.T], axis=1)
    return found


def _place(rotation: _Array, origin: _Array) -> _Array:
    """Homogeneous matrix (4, 4)."""
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = rotation, origin
    return matrix


def _line(colour: int, width: int) -> Any:
    """Material of lines; the stubs of meshcat do not accept it for line segments."""
    import meshcat.geometry as shapes

    return shapes.LineBasicMaterial(color=colour, linewidth=width)


def show(
    pose: Pose,
    contact: Contact | str | None = None,
    *,
    report: MapReport | None = None,
    scale: float | None = None,
    viewer: Any = None,
) -> Any:
    """Draws a pose in a meshcat Visualizer and returns it: links as lines between the origins of their frames.

    contact: its point, its normal, and the ellipsoid of mobility with the half axes 1/√m̄ along the principal directions (scale: metres
    per 1/√kg, as for plots.plot_ellipsoid). report: the facets of a map, coloured by m̄ on a logarithmic scale. viewer: an open
    meshcat.Visualizer, whose earlier drawing of percuss is replaced; default: a new one.
    """
    import meshcat
    import meshcat.geometry as shapes

    if not isinstance(pose, Pose):
        raise InputError(f"pose is {pose!r}; expected a Pose, as Model.pose makes it")
    found = meshcat.Visualizer() if viewer is None else viewer
    root = found["percuss"]
    root.delete()
    origins = {link: pose.link_frame(link, frame="root")[:3, 3] for link in pose.model.links}
    size = max(float(np.ptp(np.stack(list(origins.values())), axis=0).max()), 0.1)
    bones = [origins[link] for joint in pose.model.joints for link in (joint.parent, joint.child)]
    if bones:
        lines = shapes.PointsGeometry(np.stack(bones, axis=1).astype(np.float32))
        root["links"].set_object(shapes.LineSegments(lines, _line(_LINKS, 3)))
    for link, origin in origins.items():
        ball = root["origins"][link.replace("/", "_")]
        ball.set_object(shapes.Sphere(0.01 * size), shapes.MeshLambertMaterial(color=_LINKS))
        ball.set_transform(_place(np.eye(3), origin))
    if contact is not None:
        contact = pose.model.contact(contact) if isinstance(contact, str) else contact
        response = pose.respond(contact)
        frame = pose.link_frame(contact.link, frame="root")
        point = frame[:3, :3] @ np.asarray(contact.point) + frame[:3, 3]
        # The normal in root axes, from that in world axes by the frames of the contact link in both.
        turned = frame[:3, :3] @ pose.link_frame(contact.link, frame="world")[:3, :3].T
        normal = turned @ response.normal_world
        ball = root["contact"]["point"]
        ball.set_object(shapes.Sphere(0.02 * size), shapes.MeshLambertMaterial(color=_CONTACT))
        ball.set_transform(_place(np.eye(3), point))
        ends = np.stack([point, point + 0.25 * size * normal], axis=1).astype(np.float32)
        arrow = shapes.LineSegments(shapes.PointsGeometry(ends), _line(_CONTACT, 4))
        root["contact"]["normal"].set_object(arrow)
        centre, halves, directions, _ = ellipsoid_of(pose, contact.link, contact.point, scale)
        # A rotation: three directions of right hand.
        directions = directions * np.array([1.0, 1.0, np.sign(np.linalg.det(directions)) or 1.0])
        radii = np.maximum(halves, 1e-3 * halves.max())
        glass = shapes.MeshLambertMaterial(color=_ELLIPSOID, opacity=0.4, transparent=True)
        root["contact"]["ellipsoid"].set_object(shapes.Ellipsoid(radii), glass)
        root["contact"]["ellipsoid"].set_transform(_place(directions, centre))
    if report is not None:
        for link, facets in report.facets.items():
            corners = squares_of(facets["points_world"], facets["normals_world"], facets["area"])
            first = 4 * np.arange(len(corners), dtype=np.uint32)[:, None]
            faces = np.concatenate([first + np.array([0, 1, 2], np.uint32), first + np.array([0, 2, 3], np.uint32)])
            colours = np.repeat(colours_of(facets["effective_mass"]), 4, axis=0)
            surface = shapes.TriangularMeshGeometry(
                corners.reshape(-1, 3).astype(np.float32), faces, color=colours.astype(np.float32)
            )
            root["map"][link.replace("/", "_")].set_object(surface, shapes.MeshBasicMaterial(vertexColors=True, side=2))
    return found
