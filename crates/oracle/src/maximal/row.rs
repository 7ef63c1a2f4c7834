//! Linear forms on the velocities of the links.

use nalgebra::{DVector, Matrix3, Matrix4, Vector3};
use percuss_mechanism::Link;

/// World axes.
pub(super) const WORLD: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Linear form: coefficients of (ω, v) of some links.
#[derive(Clone, Default)]
pub(super) struct Row(pub(super) Vec<(usize, Vector3<f64>, Vector3<f64>)>);

impl Row {
    /// `self` + `factor` · `other`.
    pub(super) fn add_scaled(mut self, factor: f64, other: &Row) -> Row {
        self.0
            .extend(other.0.iter().map(|&(link, angular, linear)| (link, angular * factor, linear * factor)));
        self
    }

    /// Coefficients for the scaled velocities.
    pub(super) fn dense(&self, links: usize, length: f64) -> DVector<f64> {
        let mut dense = DVector::zeros(6 * links);
        for (link, angular, linear) in &self.0 {
            for i in 0..3 {
                dense[6 * link + i] += angular[i] / length;
                dense[6 * link + 3 + i] += linear[i];
            }
        }
        dense
    }
}

/// n · (velocity of the point of `link` at `arm` from its centre of mass).
pub(super) fn velocity_row(link: usize, arm: &Vector3<f64>, n: &Vector3<f64>) -> Row {
    Row(vec![(link, arm.cross(n), *n)])
}

/// Rotation of a homogeneous matrix.
pub(super) fn rotation(x: &Matrix4<f64>) -> Matrix3<f64> {
    x.fixed_view::<3, 3>(0, 0).into_owned()
}

/// Translation of a homogeneous matrix.
pub(super) fn translation(x: &Matrix4<f64>) -> Vector3<f64> {
    x.fixed_view::<3, 1>(0, 3).into_owned()
}

/// Centre of mass in the link frame; the origin for a massless link.
pub(super) fn com(link: &Link) -> Vector3<f64> {
    let inertia = link.inertia();
    if inertia.mass > 0.0 { inertia.first_moment / inertia.mass } else { Vector3::zeros() }
}
