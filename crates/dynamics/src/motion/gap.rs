//! Gap of a named contact at a pose, and its closing speed.

use crate::analysis::pose::Pose;
use crate::kinematics::frames::Kinematics;
use crate::kinematics::gap::Gap;
use crate::model::Model;
use nalgebra::Vector3;
use percuss_mechanism::{ContactNormal, LinkId, NamedContact};

impl Gap {
    /// Gap of a contact of the pose's mechanism; `None` if its parts always touch.
    pub fn new(pose: &Pose, contact: &NamedContact) -> Option<Self> {
        Self::named(pose.assembly.pose_model(), contact)
    }

    /// Gap at a pose of the same mechanism, m; negative for a penetration.
    pub fn at(&self, pose: &Pose) -> f64 {
        self.at_frames(pose.assembly.pose_model(), &pose.kinematics)
    }

    /// Gap at given positions of all joints, in joint order, m. The base of `pose`, a pose of the same mechanism, has no
    /// influence.
    pub fn at_positions(&self, pose: &Pose, positions: &[f64]) -> f64 {
        let model = pose.assembly.pose_model();
        let mut kinematics = Kinematics::new(model);
        let mut first = 0;
        for range in &model.joint_q {
            let end = first + range.len();
            if let Some(values) = positions.get(first..end) {
                kinematics.q[range.clone()].copy_from_slice(values);
            }
            first = end;
        }
        kinematics.refill(model);
        self.at_frames(model, &kinematics)
    }

    /// −dg/dt at given rates of the coordinates, m/s.
    pub(crate) fn closing_speed(&self, pose: &Pose, u: &[f64]) -> f64 {
        let (model, kinematics) = (pose.assembly.pose_model(), &pose.kinematics);
        let here = self.point_on_other(model, kinematics);
        let normal = match self.normal {
            ContactNormal::Fixed(normal) => normal,
            ContactNormal::Toward(point) => (point - here).normalize(),
            ContactNormal::Away(point) => (here - point).normalize(),
        };
        let along = kinematics.link_frame(model, self.other).vector(&normal);
        speed_along(model, pose, (self.link, &self.point), &along, u)
            - speed_along(model, pose, (self.other, &here), &along, u)
    }
}

/// Speed of a point (m, link's frame) along a direction in the root link's axes, at given rates of the coordinates,
/// m/s.
pub(crate) fn speed_along(
    model: &Model,
    pose: &Pose,
    (link, point): (LinkId, &Vector3<f64>),
    along: &Vector3<f64>,
    u: &[f64],
) -> f64 {
    let jacobian = model.point_jacobian(&pose.kinematics, link, point);
    let moving = jacobian.column_iter().zip(u).filter(|(_, u)| **u != 0.0);
    moving.map(|(column, u)| along.dot(&column) * u).sum()
}
