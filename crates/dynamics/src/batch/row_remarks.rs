//! Findings about the positions of a row: joints outside their limits, and a contact that does not touch.

use crate::analysis::pose::Pose;
use crate::kinematics::contact::Contact;
use crate::kinematics::frames::Kinematics;
use crate::kinematics::gap::Gap;
use crate::kinematics::remarks::RemarkFlags;
use crate::model::Model;
use percuss_mechanism::{JointKind, Limits};

/// Limited joints with one position: index of the position, limits and kind.
#[derive(Clone, Debug)]
pub(super) struct PositionLimits(Vec<(usize, Limits, JointKind)>);

impl PositionLimits {
    /// Limits of the joints of a model. `reads_mimics`: true if the positions of mimics follow their masters, false if they are not read.
    pub fn of(model: &Model, reads_mimics: bool) -> Self {
        let with_limits = model.mechanism.joints().iter().zip(&model.joint_q).filter_map(|(joint, q)| {
            let is_read = q.len() == 1 && (reads_mimics || joint.mimic().is_none());
            Some((q.start, joint.limits().filter(|_| is_read)?, joint.kind()))
        });
        Self(with_limits.collect())
    }

    /// [`RemarkFlags::OUTSIDE_LIMITS`] if a position is outside its limits, and [`RemarkFlags::MANY_TURNS`] if it is probably in degrees.
    #[inline]
    pub fn flags(&self, position: impl Fn(usize) -> f64) -> RemarkFlags {
        let mut flags = RemarkFlags::NONE;
        for (q, limits, kind) in &self.0 {
            let value = position(*q);
            if (value < limits.lower || value > limits.upper) && Pose::is_outside(value, *limits) {
                flags |= RemarkFlags::OUTSIDE_LIMITS;
                if Pose::is_many_turns(*kind, value) {
                    flags |= RemarkFlags::MANY_TURNS;
                }
            }
        }
        flags
    }
}

/// Gap of the contact of a batch or a path, with its own frames.
#[derive(Clone, Debug)]
pub(super) struct RowGap {
    gap: Gap,
    kinematics: Kinematics,
}

impl RowGap {
    /// Gap of a [named contact](Gap::of_contact); `None` for other contacts.
    pub fn of(model: &Model, contact: &Contact) -> Option<Self> {
        Some(Self { gap: Gap::of_contact(model, contact)?, kinematics: Kinematics::new(model) })
    }

    /// [`RemarkFlags::OPEN_GAP`] if the contact does not touch at the positions.
    pub fn flags(&mut self, model: &Model, position: impl Fn(usize) -> f64) -> RemarkFlags {
        self.kinematics.q.iter_mut().enumerate().for_each(|(q, to)| *to = position(q));
        self.kinematics.refill(model);
        let gap = self.gap.open_at(model, &self.kinematics);
        gap.map_or(RemarkFlags::NONE, |_| RemarkFlags::OPEN_GAP)
    }
}
