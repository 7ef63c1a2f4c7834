//! A facet.

use nalgebra::Vector3;

/// A small triangle of a surface, link's frame, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facet {
    /// Its corners, anticlockwise seen from outside.
    pub corners: [Vector3<f64>; 3],
    /// A point of the surface within it: the centroid, on the round itself where it stands for a part of a round.
    pub point: Vector3<f64>,
    /// The outward normal there, a unit vector.
    pub normal: Vector3<f64>,
    /// Its area, m².
    pub area: f64,
}
