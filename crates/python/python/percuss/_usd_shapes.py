"""Volumes and inertias of colliders of USD."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .errors import InputError

_Array = NDArray[np.float64]


def unit_shape(prim: Any, shape: Any) -> tuple[float, _Array, _Array, tuple[float, float, float, float]]:
    """Volume, centre, inertia about the centre for density 1, and rotation (w, x, y, z) of a collider in units of the stage."""
    w, (x, y, z) = float(shape.localRot.GetReal()), (float(v) for v in shape.localRot.GetImaginary())
    turn, centre = (w, x, y, z), np.zeros(3)
    kind = shape.type.name
    if kind == "MeshShape":
        volume, centre, tensor = _mesh(prim, shape)
        return volume, centre, tensor, turn
    if kind == "CubeShape":
        a, b, c = (2.0 * float(v) for v in shape.halfExtents)
        volume = a * b * c
        return volume, centre, volume / 12.0 * np.diag([b * b + c * c, a * a + c * c, a * a + b * b]), turn
    r = float(getattr(shape, "radius", math.nan))
    if kind == "SphereShape":
        volume = 4.0 / 3.0 * math.pi * r**3
        return volume, centre, 0.4 * volume * r * r * np.eye(3), turn
    if kind not in ("CapsuleShape", "CylinderShape", "ConeShape"):
        raise InputError(f'collider "{prim.GetPath()}" is a {kind.removesuffix("Shape")}; give mass, centre and inertia of the body')
    h, own = 2.0 * float(shape.halfHeight), "XYZ".index(shape.axis.name)
    cylinder = math.pi * r * r * h
    if kind == "ConeShape":
        volume = cylinder / 3.0
        along, across = 0.3 * volume * r * r, volume * (0.15 * r * r + 0.0375 * h * h)
        centre[own] = -0.25 * h
    elif kind == "CylinderShape":
        volume = cylinder
        along, across = 0.5 * volume * r * r, volume * (3.0 * r * r + h * h) / 12.0
    else:
        ball = 4.0 / 3.0 * math.pi * r**3
        volume = cylinder + ball
        along = 0.5 * cylinder * r * r + 0.4 * ball * r * r
        across = cylinder * (3.0 * r * r + h * h) / 12.0 + ball * (0.4 * r * r + 0.25 * h * h + 0.375 * h * r)
    tensor = np.full(3, across)
    tensor[own] = along
    return volume, centre, np.diag(tensor), turn


def _mesh(prim: Any, shape: Any) -> tuple[float, _Array, _Array]:
    """Volume, centre and inertia of a closed mesh, or of its convex hull where the collider is one."""
    from pxr import UsdGeom

    mesh = UsdGeom.Mesh(prim)
    points = np.asarray(mesh.GetPointsAttr().Get(), dtype=np.float64).reshape(-1, 3) * np.array([float(x) for x in shape.meshScale])
    counts = np.asarray(mesh.GetFaceVertexCountsAttr().Get(), dtype=np.int64)
    corners = np.asarray(mesh.GetFaceVertexIndicesAttr().Get(), dtype=np.int64)
    approximation = str(shape.approximation).rsplit(".", 1)[-1] if hasattr(shape, "approximation") else "none"
    starts = np.concatenate([[0], np.cumsum(counts)[:-1]])
    parts = [corners[[s, s + k, s + k + 1]] for s, n in zip(starts, counts, strict=True) for k in range(1, n - 1)]
    if len(points) < 4 or not parts or corners.min() < 0 or corners.max() >= len(points):
        raise InputError(f'collider "{prim.GetPath()}" is a mesh without faces; give mass, centre and inertia of the body')
    faces = np.array(parts)
    if approximation in ("convexHull", "ConvexHull"):
        faces = _hull_faces(prim, points)
    edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    merged = np.unique(points, axis=0, return_inverse=True)[1].reshape(-1)[edges]
    merged = merged[merged[:, 0] != merged[:, 1]]
    _, balance = np.unique(np.sort(merged, axis=1), axis=0, return_inverse=True)
    sign = np.where(merged[:, 0] < merged[:, 1], 1, -1)
    if np.bincount(balance.reshape(-1), weights=sign).any():
        raise InputError(f'the mesh of the collider "{prim.GetPath()}" is not closed; give mass, centre and inertia of the body')
    a, b, c = points[faces[:, 0]], points[faces[:, 1]], points[faces[:, 2]]
    six = np.einsum("ni,ni->n", a, np.cross(b, c))
    volume = six.sum() / 6.0
    if not abs(volume) > 1e-9 * np.ptp(points, axis=0).max() ** 3:
        raise InputError(f'the mesh of the collider "{prim.GetPath()}" has no volume; give mass, centre and inertia of the body')
    centre = (six[:, None] * (a + b + c)).sum(axis=0) / (24.0 * volume)
    a, b, c = a - centre, b - centre, c - centre
    six = np.einsum("ni,ni->n", a, np.cross(b, c))
    s = a + b + c
    second = sum(np.einsum("n,ni,nj->ij", six, x, x) for x in (a, b, c, s)) / 120.0
    second, volume = (second, volume) if volume > 0.0 else (-second, -volume)
    return float(volume), centre, np.trace(second) * np.eye(3) - second


def _hull_faces(prim: Any, points: _Array) -> NDArray[np.int64]:
    try:
        from scipy.spatial import ConvexHull
    except ImportError as error:
        raise InputError(f'the convex hull of the collider "{prim.GetPath()}" needs the package scipy: pip install scipy') from error
    hull = ConvexHull(points)
    faces = np.asarray(hull.simplices, dtype=np.int64)
    a, b, c = points[faces[:, 0]], points[faces[:, 1]], points[faces[:, 2]]
    inward = np.einsum("ni,ni->n", np.cross(b - a, c - a), hull.equations[:, :3]) < 0.0
    faces[inward] = faces[inward][:, ::-1]
    return faces
