//! Inertia of a triangle mesh, by the four rules of MuJoCo.

use crate::meshes::files::Triangles;
use percuss_spatial::{Matrix3, Vector3};

/// Rule for the inertia of a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum MeshRule {
    /// Volume of the convex hull.
    Convex,
    /// Pyramids over all faces, with the absolute values of their volumes.
    Legacy,
    /// Volume enclosed by the faces.
    Exact,
    /// Mass spread over the faces.
    Shell,
}

/// Volume (m³; area, m², of a shell), centre of mass, and inertia about it at unit density.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct MeshInertia {
    pub volume: f64,
    pub com: Vector3<f64>,
    pub about_com: Matrix3<f64>,
}

/// Inertia of triangles, m. The volume is 0 or less for a mesh without an interior.
///
/// The rule `Legacy` depends on the apex of the pyramids: the centre of mass is computed with the area-weighted centroid of the
/// faces as apex, the volume and the inertia with that centre of mass, as in MuJoCo.
pub(crate) fn mesh_inertia(triangles: &Triangles, rule: MeshRule) -> MeshInertia {
    let corners = |triangle: &[[f64; 3]; 3]| triangle.map(Vector3::from);
    let (mut area, mut centroid) = (0.0, Vector3::zeros());
    for [a, b, c] in triangles.iter().map(corners) {
        let own = 0.5 * (b - a).cross(&(c - a)).norm();
        area += own;
        centroid += (a + b + c) * (own / 3.0);
    }
    centroid /= if area > 0.0 { area } else { 1.0 };
    if rule == MeshRule::Shell {
        let mut second = Matrix3::zeros();
        for triangle in triangles {
            let [a, b, c] = corners(triangle).map(|p| p - centroid);
            let own = 0.5 * (b - a).cross(&(c - a)).norm();
            second += second_moment([a, b, c]) * (own / 12.0);
        }
        return MeshInertia { volume: area, com: centroid, about_com: inertia_of(&second) };
    }
    let signed = |volume: f64| if rule == MeshRule::Legacy { volume.abs() } else { volume };
    let pyramid = |[a, b, c]: [Vector3<f64>; 3]| signed(a.cross(&b).dot(&c) / 6.0);
    let (mut volume, mut moment) = (0.0, Vector3::zeros());
    for triangle in triangles {
        let [a, b, c] = corners(triangle).map(|p| p - centroid);
        let own = pyramid([a, b, c]);
        volume += own;
        moment += (a + b + c) * (own / 4.0);
    }
    let com = centroid + if volume > 0.0 { moment / volume } else { Vector3::zeros() };
    let (mut volume, mut second) = (0.0, Matrix3::zeros());
    for triangle in triangles {
        let from_com = corners(triangle).map(|p| p - com);
        let own = pyramid(from_com);
        volume += own;
        second += second_moment(from_com) * (own / 20.0);
    }
    MeshInertia { volume, com, about_com: inertia_of(&second) }
}

/// Σ p pᵀ + s sᵀ with s = Σ p: 12 times the second moment of a triangle of unit area, 20 times that of a pyramid of unit volume
/// with its apex at the origin.
fn second_moment(corners: [Vector3<f64>; 3]) -> Matrix3<f64> {
    let sum: Vector3<f64> = corners.iter().sum();
    corners.iter().map(|p| p * p.transpose()).sum::<Matrix3<f64>>() + sum * sum.transpose()
}

/// Inertia of a second moment S: tr(S) 1 − S.
fn inertia_of(second: &Matrix3<f64>) -> Matrix3<f64> {
    Matrix3::from_diagonal_element(second.trace()) - second
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn a_tetrahedron_has_the_closed_form() {
        let (o, x, y, z) = ([0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
        let faces = vec![[o, y, x], [o, x, z], [o, z, y], [x, y, z]];
        for rule in [MeshRule::Exact, MeshRule::Legacy] {
            let found = mesh_inertia(&faces, rule);
            assert_relative_eq!(found.volume, 1.0 / 6.0, epsilon = 1e-15);
            assert_relative_eq!(found.com, Vector3::repeat(0.25), epsilon = 1e-15);
            // About the origin: Ixx = 1/30, Ixy = −∫xy = −1/120; the centre of mass shifts them.
            assert_relative_eq!(found.about_com[(0, 0)], 1.0 / 30.0 - 2.0 / 6.0 / 16.0, epsilon = 1e-15);
            assert_relative_eq!(found.about_com[(0, 1)], -1.0 / 120.0 + 1.0 / 6.0 / 16.0, epsilon = 1e-15);
        }
    }
}
