//! Patches of solids, parametrised by two numbers from 0 to 1.

use super::facet::Facet;
use nalgebra::Vector3;
use std::f64::consts::TAU;

/// Surface patch in the frame of its solid, m, and the number of parts along each parameter.
pub(super) struct Patch {
    kind: PatchKind,
    parts: (usize, usize),
}

enum PatchKind {
    /// Parallelogram: corner, first edge, second edge. The normal is first × second.
    Parallelogram([Vector3<f64>; 3]),
    /// Side of a cylinder about z: radius, length.
    CylinderSide(f64, f64),
    /// End disc of a cylinder: radius, height, side (1 for the upper end, −1 for the lower).
    CylinderEnd(f64, f64, f64),
    /// Zone of a sphere: radius, height of the centre, first latitude, range of latitudes (rad).
    SphereZone(f64, f64, f64, f64),
}

impl Patch {
    /// Faces of a box centred at the origin: edge lengths, parts along each axis.
    pub fn box_faces(size: [f64; 3], parts: [usize; 3]) -> Vec<Self> {
        let mut patches = Vec::with_capacity(6);
        for axis in 0..3 {
            let (second, third) = ((axis + 1) % 3, (axis + 2) % 3);
            for sign in [1.0, -1.0] {
                let edge = |axis: usize| {
                    let mut edge = Vector3::zeros();
                    edge[axis] = size[axis];
                    edge
                };
                let corner = 0.5 * (sign * edge(axis) - edge(second) - edge(third));
                let (first, last) = if sign > 0.0 { (second, third) } else { (third, second) };
                patches.push(Self {
                    kind: PatchKind::Parallelogram([corner, edge(first), edge(last)]),
                    parts: (parts[first], parts[last]),
                });
            }
        }
        patches
    }

    /// Side of a cylinder about z, centred at the origin.
    pub fn cylinder_side(radius: f64, length: f64, parts: (usize, usize)) -> Self {
        Self { kind: PatchKind::CylinderSide(radius, length), parts }
    }

    /// End disc of a cylinder about z; `side` is 1 for the upper end, −1 for the lower.
    pub fn cylinder_end(radius: f64, height: f64, side: f64, parts: (usize, usize)) -> Self {
        Self { kind: PatchKind::CylinderEnd(radius, height, side), parts }
    }

    /// Zone of a sphere about z: first latitude and range of latitudes (rad).
    pub fn sphere_zone(radius: f64, height: f64, (first, span): (f64, f64), parts: (usize, usize)) -> Self {
        Self { kind: PatchKind::SphereZone(radius, height, first, span), parts }
    }

    /// Includes degenerate facets at the poles.
    pub fn facet_count(&self) -> usize {
        self.parts.0.saturating_mul(self.parts.1).saturating_mul(2)
    }

    /// Point and normal (of any length) at the parameters (u, v), from 0 to 1.
    fn point_and_normal(&self, u: f64, v: f64) -> (Vector3<f64>, Vector3<f64>) {
        let (sine, cosine) = (TAU * u).sin_cos();
        match self.kind {
            PatchKind::Parallelogram([corner, first, second]) => {
                let normal = first.cross(&second);
                (corner + first * u + second * v, normal)
            }
            PatchKind::CylinderSide(radius, length) => {
                let normal = Vector3::new(cosine, sine, 0.0);
                (normal * radius + Vector3::z() * (length * (v - 0.5)), normal)
            }
            PatchKind::CylinderEnd(radius, height, side) => {
                (Vector3::new(radius * v * cosine, radius * v * sine, height), Vector3::z() * side)
            }
            PatchKind::SphereZone(radius, height, first, span) => {
                let (up, level) = (first + span * v).sin_cos();
                let normal = Vector3::new(level * cosine, level * sine, up);
                (normal * radius + Vector3::z() * height, normal)
            }
        }
    }

    /// Appends two facets per part, except degenerate ones.
    pub fn append_facets(&self, out: &mut Vec<Facet>) {
        let (across, along) = self.parts;
        let part = |i: usize, k: usize| (i as f64 / across as f64, k as f64 / along as f64);
        for i in 0..across {
            for k in 0..along {
                let [a, b, c, d] = [part(i, k), part(i + 1, k), part(i + 1, k + 1), part(i, k + 1)];
                self.append_facet([a, b, c], out);
                self.append_facet([a, c, d], out);
            }
        }
    }

    /// Appends the facet with corners at these (u, v), unless degenerate.
    fn append_facet(&self, parameters: [(f64, f64); 3], out: &mut Vec<Facet>) {
        let mut corners = parameters.map(|(u, v)| self.point_and_normal(u, v).0);
        let mean = |coordinate: fn(&(f64, f64)) -> f64| parameters.iter().map(coordinate).sum::<f64>() / 3.0;
        let (point, normal) = self.point_and_normal(mean(|p| p.0), mean(|p| p.1));
        let cross = (corners[1] - corners[0]).cross(&(corners[2] - corners[0]));
        let (length, normal_length) = (cross.norm(), normal.norm());
        let size = corners.iter().map(|c| c.norm_squared()).fold(0.0, f64::max);
        // Triangles at a pole are degenerate, up to rounding.
        if normal_length == 0.0 || length <= 1e-14 * size {
            return;
        }
        if cross.dot(&normal) < 0.0 {
            corners.swap(1, 2);
        }
        out.push(Facet { corners, point, normal: normal / normal_length, area: 0.5 * length });
    }
}
