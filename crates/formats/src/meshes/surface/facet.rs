//! Facet of a surface.

use nalgebra::Vector3;

/// Small triangle of a surface; link frame, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facet {
    /// Corners, anticlockwise seen from outside.
    pub corners: [Vector3<f64>; 3],
    /// Reference point: the centroid of a flat facet, a point on the surface itself for a part of a curved surface.
    pub point: Vector3<f64>,
    /// Outward unit normal at `point`.
    pub normal: Vector3<f64>,
    /// Area, m².
    pub area: f64,
}
