//! Closures with general frames, chosen to be closed at a given position of the tree.

use crate::maximal::poses;
use nalgebra::Matrix4;
use percuss_mechanism::{ClosureDescription, ClosureKind, Mechanism};
use percuss_spatial::{Matrix3, Transform, Vector3, rotation_about, rotation_from_rpy};

/// Admissible relative pose X_ps of the loop frames for a closure kind, from its axis and parameters, and the
/// second axis (used by universal closures only).
pub(crate) fn admissible_relative_pose(
    kind: ClosureKind,
    axis: &Vector3<f64>,
    p: Vector3<f64>,
    rpy: [f64; 3],
) -> (Transform<f64>, Vector3<f64>) {
    let about = rotation_about(axis, rpy[0]);
    let any = rotation_from_rpy(rpy);
    let slide = axis * p.x;
    let (still, straight) = (Vector3::zeros(), Matrix3::identity());
    let (rotation, translation) = match kind {
        ClosureKind::Fixed => (straight, still),
        ClosureKind::Revolute => (about, still),
        ClosureKind::Prismatic => (straight, slide),
        ClosureKind::Cylindrical => (about, slide),
        ClosureKind::Universal | ClosureKind::Spherical => (any, still),
        ClosureKind::Planar => (about, p - axis * axis.dot(&p)),
        ClosureKind::Distance => (any, p),
    };
    // Normal to the first axis, in a general direction.
    let axis2 = any.tr_mul(&axis.cross(&Vector3::new(0.3, -0.5, 0.8))).normalize();
    (Transform::new(rotation, translation), axis2)
}

/// Completes a closure with given predecessor and axis: sets the second axis, the length of a distance closure, and
/// the successor's loop frame such that the relative pose at these tree positions is X_ps.
pub(crate) fn complete_closure(
    tree: &Mechanism,
    positions: &[Vec<f64>],
    closure: ClosureDescription,
    (x_ps, axis2): (Transform<f64>, Vector3<f64>),
) -> ClosureDescription {
    let x_wl = poses(tree, positions);
    let pose = |link: &str| match tree.find_link(link) {
        Ok(link) => transform(&x_wl[link.index()]),
        Err(_) => Transform::identity(),
    };
    let x_ws = pose(&closure.predecessor) * closure.predecessor_frame * x_ps;
    let successor_frame = pose(&closure.successor).inverse() * x_ws;
    let distance = (closure.kind == ClosureKind::Distance).then(|| x_ps.translation.norm());
    ClosureDescription { successor_frame, axis2, distance, ..closure }
}

/// Rigid transform of a homogeneous 4×4 matrix.
fn transform(x: &Matrix4<f64>) -> Transform<f64> {
    Transform::new(x.fixed_view::<3, 3>(0, 0).into_owned(), x.fixed_view::<3, 1>(0, 3).into_owned())
}
