//! Poses by products of 4×4 homogeneous matrices, independent of the transforms of percuss-spatial.

use nalgebra::{Matrix4, Quaternion, Rotation3, Translation3, Unit, UnitQuaternion, Vector3};
use percuss_mechanism::{Joint, JointKind, Mechanism};
use percuss_spatial::plane_basis;

/// X_pj as a 4×4 matrix.
pub(super) fn origin(joint: &Joint) -> Matrix4<f64> {
    let mut x_pj = Matrix4::identity();
    x_pj.fixed_view_mut::<3, 3>(0, 0).copy_from(&joint.origin().rotation);
    x_pj.fixed_view_mut::<3, 1>(0, 3).copy_from(&joint.origin().translation);
    x_pj
}

/// X_jc: child frame in the joint frame at position `q`.
pub(super) fn motion(joint: &Joint, q: &[f64]) -> Matrix4<f64> {
    assert_eq!(q.len(), joint.kind().positions(), "position of joint {}", joint.name());
    let turn =
        |angle| Rotation3::from_axis_angle(&Unit::new_normalize(*joint.axis()), angle).to_homogeneous();
    let shift = |p: Vector3<f64>| Translation3::from(p).to_homogeneous();
    let quaternion =
        |q: &[f64]| UnitQuaternion::from_quaternion(Quaternion::new(q[0], q[1], q[2], q[3])).to_homogeneous();
    match joint.kind() {
        JointKind::Fixed => Matrix4::identity(),
        JointKind::Revolute | JointKind::Continuous => turn(q[0]),
        JointKind::Prismatic => shift(joint.axis() * q[0]),
        JointKind::Planar => {
            let (e1, e2) = plane_basis(joint.axis());
            shift(e1 * q[0] + e2 * q[1]) * turn(q[2])
        }
        JointKind::Spherical => quaternion(q),
        JointKind::Floating => shift(Vector3::new(q[0], q[1], q[2])) * quaternion(&q[3..]),
    }
}

/// X_wl of all links; the root link is the world.
///
/// # Panics
/// If the positions do not match the joints.
pub fn poses(mechanism: &Mechanism, positions: &[Vec<f64>]) -> Vec<Matrix4<f64>> {
    assert_eq!(positions.len(), mechanism.joints().len(), "one position a joint");
    let mut x_wl = vec![Matrix4::identity(); mechanism.links().len()];
    for &link in mechanism.order() {
        if let Some(id) = mechanism.parent_joint(link) {
            let joint = mechanism.joint(id);
            x_wl[link.index()] =
                x_wl[joint.parent().index()] * origin(joint) * motion(joint, &positions[id.index()]);
        }
    }
    x_wl
}
