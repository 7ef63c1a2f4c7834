//! Surface of a link: facets with a point, an outward normal and an area, in the link frame.

mod facet;
mod grid;
pub(crate) mod hull;
mod orient;

pub use facet::Facet;
pub use orient::Orientation;

use crate::meshes::files::{MeshError, MeshFolders, Triangles, read_mesh, read_mesh_file};
use crate::reading::limits::FACETS_PER_TURN;
use crate::shape::{Purpose, Shape, Solid};
use grid::Patch;
use nalgebra::Vector3;
use percuss_spatial::Transform;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::path::PathBuf;

/// Reason for refusing to divide a surface.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SurfaceError {
    /// More facets are needed than the caller allows.
    #[error("{needed} facets are needed; at most {most} are made: take longer edges")]
    TooMany {
        /// Number of facets needed.
        needed: usize,
        /// Largest number allowed.
        most: usize,
    },
}

/// Shapes of a link, with the triangles of all meshes oriented outward.
#[derive(Clone, Debug, Default)]
pub struct Surface {
    parts: Vec<Part>,
    orientation: Orientation,
    files: Vec<PathBuf>,
}

/// Part of a surface.
#[derive(Clone, Debug)]
enum Part {
    /// Solid, and the pose of its frame in the link frame.
    Solid(Solid, Transform<f64>),
    /// Triangles of a mesh, m.
    Mesh(Vec<[Vector3<f64>; 3]>),
}

impl Surface {
    /// Reads the meshes of `shapes`, each of at most `max_size` bytes.
    ///
    /// # Errors
    /// [`MeshError`] of the first unreadable mesh.
    pub fn read<'a>(
        shapes: impl IntoIterator<Item = &'a Shape>,
        folders: &MeshFolders,
        max_size: u64,
    ) -> Result<Self, MeshError> {
        let mut surface = Self::default();
        for shape in shapes {
            let Solid::Mesh { file, scale } = &shape.solid else {
                surface.parts.push(Part::Solid(shape.solid.clone(), shape.frame));
                continue;
            };
            let path = folders.find(file)?;
            let triangles = read_mesh(&*folders.files, &path, max_size)?;
            surface.files.push(path);
            let mut triangles = in_link_frame(triangles, *scale, &shape.frame);
            surface.orientation.add(&orient::orient_outward(&mut triangles));
            surface.parts.push(Part::Mesh(triangles));
        }
        Ok(surface)
    }

    /// Mesh files that were read.
    pub fn files(&self) -> &[PathBuf] {
        &self.files
    }

    /// Changes that oriented the meshes outward.
    pub fn orientation(&self) -> &Orientation {
        &self.orientation
    }

    /// Centre (link frame) and radius (m) of a sphere around the surface, not the smallest one; `None` for an empty surface.
    pub fn bounds(&self) -> Option<(Vector3<f64>, f64)> {
        let (low, high) = bounds_of(&self.parts)?;
        Some((0.5 * (low + high), 0.5 * (high - low).norm()))
    }

    /// Divides the surface into facets with edges of about `max_edge` (m) at most. Triangles of a mesh are divided but
    /// never merged.
    ///
    /// # Errors
    /// [`SurfaceError::TooMany`] if more than `max_count` facets are needed.
    pub fn facets(&self, max_edge: f64, max_count: usize) -> Result<Vec<Facet>, SurfaceError> {
        let needed = self.parts.iter().map(|part| facet_count(part, max_edge)).fold(0, usize::saturating_add);
        if needed > max_count {
            return Err(SurfaceError::TooMany { needed, most: max_count });
        }
        let mut facets = Vec::with_capacity(needed);
        for part in &self.parts {
            match part {
                Part::Solid(solid, frame) => {
                    let first = facets.len();
                    solid_patches(solid, max_edge).iter().for_each(|patch| patch.append_facets(&mut facets));
                    for facet in &mut facets[first..] {
                        facet.corners = facet.corners.map(|p| frame.point(&p));
                        facet.point = frame.point(&facet.point);
                        facet.normal = frame.vector(&facet.normal);
                    }
                }
                Part::Mesh(triangles) => {
                    triangles.iter().for_each(|t| append_triangle_facets(t, max_edge, &mut facets))
                }
            }
        }
        Ok(facets)
    }
}

/// Corners of a mesh in the link frame, m.
fn in_link_frame(triangles: Triangles, scale: [f64; 3], frame: &Transform<f64>) -> Vec<[Vector3<f64>; 3]> {
    let scale = Vector3::from(scale);
    let point = |p: [f64; 3]| frame.point(&Vector3::from(p).component_mul(&scale));
    triangles.into_iter().map(|corners| corners.map(point)).collect()
}

/// Least and greatest coordinates of parts in the link frame; `None` without parts.
fn bounds_of(parts: &[Part]) -> Option<(Vector3<f64>, Vector3<f64>)> {
    let (mut low, mut high) = (Vector3::repeat(f64::INFINITY), Vector3::repeat(f64::NEG_INFINITY));
    let mut include = |p: &Vector3<f64>| {
        low = low.inf(p);
        high = high.sup(p);
    };
    for part in parts {
        match part {
            Part::Solid(solid, frame) => {
                let half = half_extents(solid);
                for corner in 0..8_usize {
                    let side = |axis: usize| if corner >> axis & 1 == 0 { -half[axis] } else { half[axis] };
                    include(&frame.point(&Vector3::new(side(0), side(1), side(2))));
                }
            }
            Part::Mesh(triangles) => triangles.iter().flatten().for_each(&mut include),
        }
    }
    (low.x <= high.x).then_some((low, high))
}

/// Box around shapes with the axes of the link; `None` without shapes. Reads meshes of at most `max_size` bytes in total, and reduces it.
///
/// # Errors
/// [`MeshError`] of the first unreadable mesh.
pub(crate) fn bounding_box(
    shapes: &[Shape],
    folders: &MeshFolders,
    max_size: &mut u64,
) -> Result<Option<Shape>, MeshError> {
    let mut parts = Vec::new();
    for shape in shapes {
        let Solid::Mesh { file, scale } = &shape.solid else {
            parts.push(Part::Solid(shape.solid.clone(), shape.frame));
            continue;
        };
        let mesh = read_mesh_file(&*folders.files, &folders.find(file)?, *max_size)?;
        *max_size = max_size.saturating_sub(mesh.size);
        parts.push(Part::Mesh(in_link_frame(mesh.triangles, *scale, &shape.frame)));
    }
    Ok(bounds_of(&parts).map(|(low, high)| Shape {
        purpose: Purpose::Collision,
        solid: Solid::Box { size: (high - low).into() },
        frame: Transform::from_translation(0.5 * (low + high)),
    }))
}

/// Half the edge lengths of the bounding box of a solid in its own frame, m; 0 for a mesh.
fn half_extents(solid: &Solid) -> [f64; 3] {
    match solid {
        Solid::Box { size } => size.map(|s| 0.5 * s),
        Solid::Sphere { radius } => [*radius; 3],
        Solid::Cylinder { radius, length } => [*radius, *radius, 0.5 * length],
        Solid::Capsule { radius, length } => [*radius, *radius, 0.5 * length + radius],
        Solid::Mesh { .. } => [0.0; 3],
    }
}

/// Number of facets of a part, including degenerate ones.
fn facet_count(part: &Part, max_edge: f64) -> usize {
    match part {
        Part::Solid(solid, _) => {
            solid_patches(solid, max_edge).iter().map(Patch::facet_count).fold(0, usize::saturating_add)
        }
        Part::Mesh(triangles) => {
            let facets_of_triangle = |t: &[Vector3<f64>; 3]| {
                triangle_subdivisions(t, max_edge).saturating_mul(triangle_subdivisions(t, max_edge))
            };
            triangles.iter().map(facets_of_triangle).fold(0, usize::saturating_add)
        }
    }
}

/// Number of pieces of at most `max_edge` in an edge of this length.
fn subdivisions(length: f64, max_edge: f64) -> usize {
    let parts = (length / max_edge).ceil();
    // NaN gives one part. A very large number is refused later, by the number of facets.
    if parts >= 1.0 { parts as usize } else { 1 }
}

/// Number n of pieces of at most `max_edge` in the longest edge.
fn triangle_subdivisions(triangle: &[Vector3<f64>; 3], max_edge: f64) -> usize {
    let edge = |from: usize, to: usize| (triangle[to] - triangle[from]).norm();
    let longest = edge(0, 1).max(edge(1, 2)).max(edge(2, 0));
    subdivisions(longest, max_edge)
}

/// Appends n² congruent facets, n = [`triangle_subdivisions`].
fn append_triangle_facets(triangle: &[Vector3<f64>; 3], max_edge: f64, out: &mut Vec<Facet>) {
    let n = triangle_subdivisions(triangle, max_edge);
    let at = |i: usize, k: usize| {
        if n == 1 {
            // Uses the exact corner, without the rounding of a sum.
            return triangle[if i == 1 { 1 } else { 2 * k }];
        }
        let [a, b, c] = triangle;
        a + (b - a) * (i as f64 / n as f64) + (c - a) * (k as f64 / n as f64)
    };
    for i in 0..n {
        for k in 0..n - i {
            append_flat_facet([at(i, k), at(i + 1, k), at(i, k + 1)], out);
            if i + k + 1 < n {
                append_flat_facet([at(i + 1, k), at(i + 1, k + 1), at(i, k + 1)], out);
            }
        }
    }
}

/// Appends a facet with its centroid and right-handed normal, unless degenerate.
fn append_flat_facet(corners: [Vector3<f64>; 3], out: &mut Vec<Facet>) {
    let [a, b, c] = corners;
    let cross = (b - a).cross(&(c - a));
    let length = cross.norm();
    // A degenerate triangle has no normal.
    if length > 0.0 && length.is_finite() {
        out.push(Facet { corners, point: (a + b + c) / 3.0, normal: cross / length, area: 0.5 * length });
    }
}

/// Patches that form the surface of a solid, for edges of about `max_edge`; empty for a mesh.
fn solid_patches(solid: &Solid, max_edge: f64) -> Vec<Patch> {
    let around = |radius: f64| {
        subdivisions(TAU * radius, max_edge).clamp(*FACETS_PER_TURN.start(), *FACETS_PER_TURN.end())
    };
    let straight = |length: f64| subdivisions(length, max_edge);
    match *solid {
        Solid::Box { size } => Patch::box_faces(size, size.map(straight)),
        Solid::Sphere { radius } => {
            let n = around(radius);
            vec![Patch::sphere_zone(radius, 0.0, (-FRAC_PI_2, PI), (n, n.div_ceil(2)))]
        }
        Solid::Cylinder { radius, length } => {
            let (n, rings) = (around(radius), straight(radius));
            vec![
                Patch::cylinder_side(radius, length, (n, straight(length))),
                Patch::cylinder_end(radius, 0.5 * length, 1.0, (n, rings)),
                Patch::cylinder_end(radius, -0.5 * length, -1.0, (n, rings)),
            ]
        }
        Solid::Capsule { radius, length } => {
            let n = around(radius);
            let half = (n, n.div_ceil(4));
            vec![
                Patch::cylinder_side(radius, length, (n, straight(length))),
                Patch::sphere_zone(radius, 0.5 * length, (0.0, FRAC_PI_2), half),
                Patch::sphere_zone(radius, -0.5 * length, (-FRAC_PI_2, FRAC_PI_2), half),
            ]
        }
        Solid::Mesh { .. } => Vec::new(),
    }
}
