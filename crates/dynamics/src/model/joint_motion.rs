//! Motion of each kind of joint. No other module of this crate distinguishes joint kinds in kinematics.

use nalgebra::Vector3;
use percuss_mechanism::{Joint, JointKind};
use percuss_spatial::{Transform, Twist, plane_basis, rotation_about, rotation_from_quaternion};

/// Kind and axes of a joint.
#[derive(Clone, Debug)]
pub(crate) struct JointMotion {
    pub kind: JointKind,
    axis: Vector3<f64>,
    plane: (Vector3<f64>, Vector3<f64>),
}

impl JointMotion {
    pub fn of(joint: &Joint) -> Self {
        let plane = match joint.kind() {
            JointKind::Planar => plane_basis(joint.axis()),
            _ => (Vector3::zeros(), Vector3::zeros()),
        };
        Self { kind: joint.kind(), axis: *joint.axis(), plane }
    }

    /// Free motion of a floating base.
    pub fn floating() -> Self {
        Self { kind: JointKind::Floating, axis: Vector3::z(), plane: (Vector3::x(), Vector3::y()) }
    }

    /// True for a motion of the same kind whose axes differ by at most `most` in each component.
    pub fn is_near(&self, other: &Self, most: f64) -> bool {
        let pairs = [(self.axis, other.axis), (self.plane.0, other.plane.0), (self.plane.1, other.plane.1)];
        self.kind == other.kind && pairs.iter().all(|(own, other)| (own - other).amax() <= most)
    }

    /// Unit vector of the axis in the joint frame; unused for joints without an axis.
    pub fn axis(&self) -> Vector3<f64> {
        self.axis
    }

    /// X_jc: frame of the child in the joint frame at position `q` (layout of [`JointKind`]).
    #[inline]
    pub fn transform(&self, q: &[f64]) -> Transform<f64> {
        match self.kind {
            JointKind::Fixed => Transform::identity(),
            JointKind::Revolute | JointKind::Continuous => {
                Transform::new(rotation_about(&self.axis, q[0]), Vector3::zeros())
            }
            JointKind::Prismatic => Transform::from_translation(self.axis * q[0]),
            JointKind::Planar => {
                let (e1, e2) = (self.plane.0, self.plane.1);
                Transform::new(rotation_about(&self.axis, q[2]), e1 * q[0] + e2 * q[1])
            }
            JointKind::Spherical => {
                Transform::new(rotation_from_quaternion([q[0], q[1], q[2], q[3]]), Vector3::zeros())
            }
            JointKind::Floating => Transform::new(
                rotation_from_quaternion([q[3], q[4], q[5], q[6]]),
                Vector3::new(q[0], q[1], q[2]),
            ),
        }
    }

    /// Column `k` of the motion subspace S: twist of the child relative to the parent at unit velocity `k`, in the
    /// child's axes at the child's origin.
    #[inline]
    pub fn column(&self, k: usize, q: &[f64]) -> Twist<f64> {
        let turn = |a: &Vector3<f64>| Twist::new(*a, Vector3::zeros());
        let slide = |a: &Vector3<f64>| Twist::new(Vector3::zeros(), *a);
        match (self.kind, k) {
            (JointKind::Revolute | JointKind::Continuous, _) => turn(&self.axis),
            (JointKind::Prismatic, _) => slide(&self.axis),
            (JointKind::Planar, 0 | 1) => {
                // x and y move along the axes of the joint frame, expressed in the rotated child frame.
                let e = if k == 0 { &self.plane.0 } else { &self.plane.1 };
                let back = rotation_about(&self.axis, -q[2]);
                Twist::new(Vector3::zeros(), back * e)
            }
            (JointKind::Planar, _) => turn(&self.axis),
            (JointKind::Spherical, _) | (JointKind::Floating, 0..3) => turn(&unit(k)),
            (JointKind::Floating, _) => slide(&unit(k - 3)),
            (JointKind::Fixed, _) => Twist::zero(),
        }
    }

    /// Change of S v per unit velocity `k` of the joint, at fixed joint velocities `v`, in the child's axes.
    ///
    /// Nonzero only for planar joints, whose x and y columns rotate relative to the child.
    pub fn column_rate(&self, k: usize, q: &[f64], v: &[f64]) -> Twist<f64> {
        if self.kind != JointKind::Planar || k != 2 {
            return Twist::zero();
        }
        let slide = self.column(0, q) * v[0] + self.column(1, q) * v[1];
        Twist::new(Vector3::zeros(), slide.linear.cross(&self.axis))
    }

    /// Bias c = Ṡ v at the joint velocities `v`, in the child's axes.
    #[inline]
    pub fn bias(&self, q: &[f64], v: &[f64]) -> Twist<f64> {
        (0..v.len()).fold(Twist::zero(), |sum, k| sum + self.column_rate(k, q, v) * v[k])
    }

    /// True if velocity `k` is a rotation (rad/s), false for a translation (m/s).
    pub fn turns(&self, k: usize) -> bool {
        self.kind.turns(k)
    }
}

fn unit(k: usize) -> Vector3<f64> {
    let mut e = Vector3::zeros();
    e[k % 3] = 1.0;
    e
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::tangent;

    /// Every column is the derivative of the transform: the twist of X(q)⁻¹ X(q ⊕ h e_k), by central differences.
    #[test]
    fn columns_are_derivatives_of_the_transform() {
        let axis = Vector3::new(0.3, -0.8, 0.5).normalize();
        let h = 1e-5;
        for kind in JointKind::ALL {
            let motion = JointMotion { kind, axis, plane: plane_basis(&axis) };
            let q: Vec<f64> = match kind {
                JointKind::Fixed => vec![],
                JointKind::Revolute | JointKind::Continuous | JointKind::Prismatic => vec![0.7],
                JointKind::Planar => vec![0.2, -0.4, 1.1],
                JointKind::Spherical => vec![0.5, 0.5, -0.5, 0.5],
                JointKind::Floating => vec![1.0, 2.0, -0.5, 0.5, 0.5, -0.5, 0.5],
            };
            for k in 0..kind.dofs() {
                let mut v = vec![0.0; kind.dofs()];
                v[k] = 1.0;
                let step = |h: f64| motion.transform(&tangent::advanced(kind, &q, &v, h));
                let x = motion.transform(&q);
                let (plus, minus) = (x.inverse() * step(h), x.inverse() * step(-h));
                let r = (plus.rotation - minus.rotation) / (2.0 * h);
                let omega = Vector3::new(r[(2, 1)], r[(0, 2)], r[(1, 0)]);
                let linear = (plus.translation - minus.translation) / (2.0 * h);
                let s = motion.column(k, &q);
                // Truncation h², rounding ε/h: both about 1e-10.
                assert!((s.angular - omega).norm() < 1e-9, "{kind:?} {k}");
                assert!((s.linear - linear).norm() < 1e-9, "{kind:?} {k}");
                assert_eq!(motion.turns(k), s.angular.norm() > 0.5, "{kind:?} {k}");
            }
        }
    }
}
