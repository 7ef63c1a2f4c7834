//! Gap of a named contact: distance along its normal between the contact point and the other side.

use crate::analysis::pose::Pose;
use crate::kinematics::contact::{Contact, Direction, Frame};
use crate::kinematics::frames::Kinematics;
use crate::model::Model;
use nalgebra::Vector3;
use percuss_mechanism::{ContactNormal, LinkId, NamedContact};

/// Gap of a named contact as a function of the pose.
///
/// g = g₀ − s, m. s is the approach since all joints were at 0: for a fixed normal n, s = n · (p − p₀) in the frame of
/// the other side; for a line of length L, s = L₀ − L, or L − L₀ for a stop of the extension. ds/dt is the closing speed j q̇ of the contact.
#[derive(Clone, Debug)]
pub struct Gap {
    link: LinkId,
    point: Vector3<f64>,
    /// The other side; the root link for the ground.
    other: LinkId,
    normal: ContactNormal,
    /// n · p₀ + g₀ for a fixed normal; for a line, its length at the touch.
    touch: f64,
}

impl Contact {
    /// Contact of a named contact: a fixed normal in the frame of the other side, or a line that turns with the
    /// mechanism.
    pub fn named(contact: &NamedContact, root: LinkId) -> Self {
        let other = contact.against().unwrap_or(root);
        Self {
            link: contact.link(),
            against: contact.against(),
            point: *contact.point(),
            normal: match *contact.normal() {
                ContactNormal::Fixed(normal) => Direction::Along(normal, Frame::Against),
                ContactNormal::Toward(point) => Direction::TurningToward(other, point),
                ContactNormal::Away(point) => Direction::TurningAwayFrom(other, point),
            },
        }
    }
}

impl Gap {
    /// Gap of a contact of the pose's mechanism; `None` if its parts always touch.
    pub fn new(pose: &Pose, contact: &NamedContact) -> Option<Self> {
        let model = pose.assembly.pose_model();
        let other = contact.against().unwrap_or(pose.mechanism().root());
        let drawn =
            model.drawn_frame(other).inverse_point(&model.drawn_frame(contact.link()).point(contact.point()));
        let gap = contact.gap()?;
        let touch = match contact.normal() {
            ContactNormal::Fixed(normal) => normal.dot(&drawn) + gap,
            ContactNormal::Toward(point) => (point - drawn).norm() - gap,
            ContactNormal::Away(point) => (point - drawn).norm() + gap,
        };
        Some(Self { link: contact.link(), point: *contact.point(), other, normal: *contact.normal(), touch })
    }

    /// Gap at a pose of the same mechanism, m; negative for a penetration.
    pub fn at(&self, pose: &Pose) -> f64 {
        self.of_point(&self.point_on_other(pose))
    }

    /// Gap for a position of the contact point in the frame of the other side.
    fn of_point(&self, here: &Vector3<f64>) -> f64 {
        match &self.normal {
            ContactNormal::Fixed(normal) => self.touch - normal.dot(here),
            ContactNormal::Toward(point) => (point - here).norm() - self.touch,
            ContactNormal::Away(point) => self.touch - (point - here).norm(),
        }
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
        let point = self.point_on_other_in(model, &kinematics);
        self.of_point(&point)
    }

    /// The contact link.
    pub(crate) fn link(&self) -> LinkId {
        self.link
    }

    /// The contact point in the frame of the contact link, m.
    pub(crate) fn point(&self) -> &Vector3<f64> {
        &self.point
    }

    /// Contact point in the frame of the other side, m.
    fn point_on_other(&self, pose: &Pose) -> Vector3<f64> {
        self.point_on_other_in(pose.assembly.pose_model(), &pose.kinematics)
    }

    fn point_on_other_in(&self, model: &Model, kinematics: &Kinematics) -> Vector3<f64> {
        let at = kinematics.link_frame(model, self.link).point(&self.point);
        kinematics.link_frame(model, self.other).inverse_point(&at)
    }

    /// −dg/dt at given rates of the coordinates, m/s.
    pub(crate) fn closing_speed(&self, pose: &Pose, u: &[f64]) -> f64 {
        let (model, kinematics) = (pose.assembly.pose_model(), &pose.kinematics);
        let here = self.point_on_other(pose);
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
