//! Gaps of the loops of a mechanism, from 4×4 matrices.

use super::pose;
use super::row::{rotation, translation};
use crate::positions::zero_positions;
use nalgebra::{Matrix4, Vector3};
use percuss_mechanism::{Closure, ClosureKind, Coupling, Curve, JointId, JointKind, LoopFrame, Mechanism};

/// X_wf: loop frame in the world (the frame of the root link).
pub(super) fn loop_frame_in_world(end: &LoopFrame, x_wl: &[Matrix4<f64>]) -> Matrix4<f64> {
    let mut x_lf = Matrix4::identity();
    x_lf.fixed_view_mut::<3, 3>(0, 0).copy_from(&end.frame.rotation);
    x_lf.fixed_view_mut::<3, 1>(0, 3).copy_from(&end.frame.translation);
    end.link.map_or(x_lf, |link| x_wl[link.index()] * x_lf)
}

/// Two unit vectors that complete a unit vector to a right-handed frame.
pub(super) fn across(axis: &Vector3<f64>) -> [Vector3<f64>; 2] {
    let first = axis.cross(&Vector3::ith(axis.iamin(), 1.0)).normalize();
    [first, axis.cross(&first)]
}

/// |p| without overflow and underflow of squares.
pub(super) fn distance(p: &Vector3<f64>) -> f64 {
    p[0].hypot(p[1]).hypot(p[2])
}

/// Largest gap of all closures and couplings, m; angles times the characteristic length. Zero without loops.
///
/// # Panics
/// If the positions do not match the joints.
pub fn residual(mechanism: &Mechanism, positions: &[Vec<f64>]) -> f64 {
    residuals(mechanism, positions).iter().map(|of_one| norm(of_one)).fold(0.0, f64::max)
}

/// Residuals of every closure, then of every coupling, m; angles times the characteristic length.
///
/// Frames and axes are compared by components: no angle is computed, a reversed axis has the largest residual,
/// and near a closed position the norm of each list equals the angle or displacement between the two sides.
///
/// # Panics
/// If the positions do not match the joints.
pub fn residuals(mechanism: &Mechanism, positions: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let x_wl = pose::poses(mechanism, positions);
    let closures = mechanism.closures().iter().map(|closure| closure_residuals(closure, mechanism, &x_wl));
    let couplings =
        mechanism.couplings().iter().map(|coupling| vec![coupling_residual(coupling, mechanism, positions)]);
    closures.chain(couplings).collect()
}

/// Euclidean norm without overflow of squares.
fn norm(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |sum: f64, value| sum.hypot(*value))
}

/// Residuals of a closure, m; angles times the characteristic length.
fn closure_residuals(closure: &Closure, mechanism: &Mechanism, x_wl: &[Matrix4<f64>]) -> Vec<f64> {
    let size = mechanism.characteristic_length();
    let x_wp = loop_frame_in_world(closure.predecessor(), x_wl);
    let x_ws = loop_frame_in_world(closure.successor(), x_wl);
    let r_ps = rotation(&x_wp).transpose() * rotation(&x_ws);
    let p = rotation(&x_wp).tr_mul(&(translation(&x_ws) - translation(&x_wp)));
    let axis = closure.axis();
    let point = || p.iter().copied();
    let sides = || across(axis).map(|e| e.dot(&p));
    let tilt = || (r_ps * axis - axis) * size;
    // All nine components; each small angle appears in two of them.
    let rotation_residual = || (r_ps - nalgebra::Matrix3::identity()) * (size / 2f64.sqrt());
    match closure.kind() {
        ClosureKind::Fixed => point().chain(rotation_residual().iter().copied()).collect(),
        ClosureKind::Revolute => point().chain(tilt().iter().copied()).collect(),
        ClosureKind::Prismatic => sides().into_iter().chain(rotation_residual().iter().copied()).collect(),
        ClosureKind::Cylindrical => sides().into_iter().chain(tilt().iter().copied()).collect(),
        ClosureKind::Universal => point().chain([size * axis.dot(&(r_ps * closure.axis2()))]).collect(),
        ClosureKind::Planar => [axis.dot(&p)].into_iter().chain(tilt().iter().copied()).collect(),
        ClosureKind::Spherical => point().collect(),
        ClosureKind::Distance => {
            let declared = closure.distance().unwrap_or_else(|| distance_at_zero(closure, mechanism));
            vec![distance(&p) - declared]
        }
    }
}

/// Length of a distance closure without declared length: the distance with all joints at 0.
fn distance_at_zero(closure: &Closure, mechanism: &Mechanism) -> f64 {
    let x_wl = pose::poses(mechanism, &zero_positions(mechanism));
    let [from, to] = [closure.predecessor(), closure.successor()].map(|end| loop_frame_in_world(end, &x_wl));
    distance(&(translation(&to) - translation(&from)))
}

/// Argument of a coupling's curve at given positions of all joints.
fn curve_argument(curve: &Curve, positions: &[Vec<f64>]) -> f64 {
    curve.offset()
        + curve.terms().iter().map(|&(joint, factor)| factor * positions[joint.index()][0]).sum::<f64>()
}

/// Joints of a coupling with their entries at given positions; a joint may occur twice.
pub(super) fn coupling_entries(coupling: &Coupling, positions: &[Vec<f64>]) -> Vec<(JointId, f64)> {
    let mut entries = coupling.terms().to_vec();
    if let Some(curve) = coupling.curve() {
        let s = curve_argument(curve, positions);
        let powers = curve.coefficients().into_iter().zip(2..);
        let slope: f64 = powers.map(|(a, k)| f64::from(k) * a * s.powi(k - 1)).sum();
        entries.extend(curve.terms().iter().map(|&(joint, factor)| (joint, -slope * factor)));
    }
    entries
}

/// Σ factor · q − constant − curve; a length if the first joint is prismatic.
fn coupling_residual(coupling: &Coupling, mechanism: &Mechanism, positions: &[Vec<f64>]) -> f64 {
    let sum: f64 = coupling.terms().iter().map(|&(joint, factor)| factor * positions[joint.index()][0]).sum();
    let curve = coupling.curve().map_or(0.0, |curve| {
        let s = curve_argument(curve, positions);
        curve.coefficients().into_iter().zip(2..).map(|(a, k)| a * s.powi(k)).sum::<f64>()
    });
    let sum = sum - coupling.constant() - curve;
    let slides = coupling.terms().first().map(|&(joint, _)| mechanism.joint(joint).kind());
    if slides == Some(JointKind::Prismatic) { sum } else { sum * mechanism.characteristic_length() }
}
