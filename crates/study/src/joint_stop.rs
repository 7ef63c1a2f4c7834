//! The stop of a joint, as a contact between its two links.

use crate::error::{Fault, StudyError};
use crate::field::Field;
use crate::model::Model;
use crate::position::GivenPosition;
use crate::question::{MassQuestion, Normal};
use nalgebra::Vector3;
use percuss_contact::exports::StopMotion;
use percuss_dynamics::Frame;
use percuss_mechanism::{Joint, JointKind};
use serde::Serialize;

/// Which end of a joint's range.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum StopEnd {
    /// The least position.
    Lower,
    /// The greatest position.
    Upper,
}

/// The stop of a joint with one degree of freedom.
#[derive(Clone, Debug, PartialEq)]
pub struct JointStop {
    /// The joint.
    pub joint: String,
    /// The end, where the joint is put on; none: it is stopped where the pose has it, on its way up.
    pub end: Option<StopEnd>,
}

/// The stop of a joint, as it stands in reports.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct StopRecord {
    /// The joint.
    pub joint: String,
    /// `turn`: the mass is an inertia in kg·m², the stiffness in N·m/rad, the speed in rad/s, and so on; or `slide`.
    pub motion: StopMotion,
}

impl JointStop {
    /// Reads `JOINT`, `JOINT:lower` or `JOINT:upper`.
    ///
    /// # Errors
    /// How it should look.
    pub fn parse(text: &str) -> Result<Self, String> {
        let (joint, end) = match text.rsplit_once(':') {
            Some((joint, "lower")) => (joint, Some(StopEnd::Lower)),
            Some((joint, "upper")) => (joint, Some(StopEnd::Upper)),
            _ => (text, None),
        };
        match joint {
            "" => Err("expected JOINT, JOINT:lower or JOINT:upper, such as elbow:upper".into()),
            _ => Ok(JointStop { joint: joint.to_owned(), end }),
        }
    }

    /// How the joint moves into its stop.
    ///
    /// # Errors
    /// [`StudyError`]: no such joint; one that is fixed or has several degrees of freedom.
    pub fn motion(&self, model: &Model) -> Result<StopMotion, StudyError> {
        self.find(model).map(|(_, motion)| motion)
    }

    fn find<'a>(&self, model: &'a Model) -> Result<(&'a Joint, StopMotion), StudyError> {
        let mechanism = &model.mechanism;
        let id = mechanism.find_joint(&self.joint).map_err(|error| StudyError::input(Field::Limit, error))?;
        let joint = mechanism.joint(id);
        let motion = motion_of(joint).ok_or_else(|| {
            StudyError::input(Field::Limit, Fault::NoStop { joint: self.joint.clone(), kind: joint.kind() })
        })?;
        Ok((joint, motion))
    }

    /// The contact: a point of the child link against the parent link, 1 m beside the axis of a turn, along its motion;
    /// any point along the axis of a slide. The two links then close at just the joint's rate q̇, so that m̄ in kg is
    /// 1/(e_j M_c⁻¹ e_jᵀ), the inertia (kg·m²) or the mass that the joint feels through the loops. The other words of the
    /// question (`conditions`) stay.
    ///
    /// # Errors
    /// [`StudyError`]: no such joint; one that is fixed or has several degrees of freedom; an end without a limit.
    pub fn question(
        &self,
        model: &Model,
        conditions: MassQuestion,
    ) -> Result<(MassQuestion, StopRecord), StudyError> {
        let mechanism = &model.mechanism;
        let refuse = |fault: Fault| StudyError::input(Field::Limit, fault);
        let (joint, motion) = self.find(model)?;
        let axis = joint.axis();
        let (point, mut normal) = match motion {
            StopMotion::Turn => {
                let beside = beside(axis);
                (beside, axis.cross(&beside))
            }
            StopMotion::Slide => (Vector3::zeros(), *axis),
        };
        if self.end == Some(StopEnd::Lower) {
            normal = -normal;
        }
        let link = |id| mechanism.link(id).name().to_owned();
        let mut question = MassQuestion {
            link: link(joint.child()),
            point: point.into(),
            normal: Normal::Along(normal.into()),
            frame: Frame::Link,
            normal_frame: Frame::Link,
            against: Some(link(joint.parent())),
            against_mass: None,
            ..conditions
        };
        if let Some(end) = self.end.filter(|_| !question.set.iter().any(|(name, _)| *name == self.joint)) {
            let limits =
                joint.limits().ok_or_else(|| refuse(Fault::NoLimit { joint: self.joint.clone() }))?;
            let at = if end == StopEnd::Lower { limits.lower } else { limits.upper };
            let position = GivenPosition::from_numbers(&[at]);
            let wrong = |source| refuse(Fault::Position { joint: self.joint.clone(), source });
            question.set.push((self.joint.clone(), position.map_err(wrong)?));
        }
        Ok((question, StopRecord { joint: self.joint.clone(), motion }))
    }
}

/// None for a joint without a stop of one number.
fn motion_of(joint: &Joint) -> Option<StopMotion> {
    match joint.kind() {
        JointKind::Revolute | JointKind::Continuous => Some(StopMotion::Turn),
        JointKind::Prismatic => Some(StopMotion::Slide),
        JointKind::Fixed | JointKind::Planar | JointKind::Spherical | JointKind::Floating => None,
    }
}

/// A unit vector across another.
fn beside(axis: &Vector3<f64>) -> Vector3<f64> {
    let least = axis.iamin();
    let mut other = Vector3::zeros();
    other[least] = 1.0;
    axis.cross(&other).normalize()
}
