//! Links, joints and frames for the mechanisms of [`zoo`](crate::zoo) and [`linkage`](crate::linkage).

use percuss_mechanism::{Inertial, JointDescription, JointKind, LinkDescription};
use percuss_spatial::{Matrix3, Transform, Vector3, rotation_from_rpy};

/// Joint between two links by name.
pub(crate) fn joint(name: &str, kind: JointKind, parent: &str, child: &str) -> JointDescription {
    JointDescription::new(name, kind, parent, child)
}

/// Massless link `ground`.
pub(crate) fn ground() -> LinkDescription {
    LinkDescription::massless("ground")
}

/// Frame with roll, pitch and yaw (rad) and origin (m).
pub(crate) fn frame(rpy: [f64; 3], p: [f64; 3]) -> Transform<f64> {
    Transform::new(rotation_from_rpy(rpy), p.into())
}

/// Body without symmetry: principal moments m·(0.011, 0.017, 0.024) size², in general orientation.
pub(crate) fn lump(name: &str, mass: f64, com: [f64; 3], size: f64) -> LinkDescription {
    let turn = rotation_from_rpy([0.4 + mass, -0.3 * mass, 0.9]);
    let moments = Matrix3::from_diagonal(&(Vector3::new(0.11, 0.17, 0.24) * (0.1 * mass * size * size)));
    LinkDescription::new(
        name,
        Inertial { mass, com: com.into(), about_com: turn * moments * turn.transpose() },
    )
}
