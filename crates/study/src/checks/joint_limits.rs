//! Joint limits of rows given by the positions of all joints, without poses.

use crate::checks::finding::{Finding, FindingSubject};
use crate::checks::finding_kind::FindingKind;
use percuss_dynamics::Pose;
use percuss_mechanism::{JointId, JointKind, Limits, Mechanism};
use percuss_units::Quantity;
use std::f64::consts::TAU;

/// Limited joints, each with the index of its position.
#[derive(Debug)]
pub(crate) struct LimitedJoints(Vec<(JointId, usize, Limits)>);

impl LimitedJoints {
    /// Limited joints of a mechanism.
    pub fn of(mechanism: &Mechanism) -> Self {
        let limited = mechanism.joint_ids().zip(mechanism.position_ranges()).filter_map(|(id, range)| {
            let limits = mechanism.joint(id).limits().filter(|_| range.len() == 1)?;
            Some((id, range.start, limits))
        });
        Self(limited.collect())
    }

    /// Findings about joints outside their limits. `position`: position with a given index.
    pub fn findings(
        &self,
        mechanism: &Mechanism,
        position: impl Fn(usize) -> f64,
    ) -> impl Iterator<Item = Finding> {
        self.0.iter().filter_map(move |&(joint, index, limits)| {
            let value = position(index);
            Pose::is_outside(value, limits).then(|| joint_limit_finding(mechanism, joint, value, limits))
        })
    }
}

/// Finding for a number without a unit that turns a joint by more than `turns` turns: it is probably in degrees. `how`: verb of the
/// message. `None` for another joint or number, and outside the limits of the joint: that finding has the same hint.
pub(crate) fn many_turns_finding(
    mechanism: &Mechanism,
    joint: JointId,
    number: Quantity,
    turns: f64,
    how: &str,
) -> Option<Finding> {
    let on = mechanism.joint(joint);
    let turns_freely = match on.kind() {
        JointKind::Continuous => true,
        JointKind::Revolute => on.limits().is_none_or(|limits| !Pose::is_outside(number.value, limits)),
        _ => false,
    };
    (turns_freely && number.dimension.is_none() && number.value.abs() > turns * TAU).then(|| {
        let message = format!(
            "joint \"{}\" {how} {}, {:.1} turns; a number without a unit is in rad: for degrees write {}deg",
            on.name(),
            number.value,
            number.value / TAU,
            number.value
        );
        Finding::new(FindingKind::ManyTurns, FindingSubject::Joint(joint), message)
    })
}

/// Finding for a joint outside its limits.
pub(crate) fn joint_limit_finding(
    mechanism: &Mechanism,
    joint: JointId,
    value: f64,
    limits: Limits,
) -> Finding {
    let hint = if Pose::is_many_turns(mechanism.joint(joint).kind(), value) {
        format!("; the position is in rad: for degrees write {}deg", (value * 1e9).round() / 1e9)
    } else {
        String::new()
    };
    let message = format!(
        "joint \"{}\" is at {value}, outside its limits {} to {}{hint}",
        mechanism.joint(joint).name(),
        limits.lower,
        limits.upper
    );
    Finding::new(FindingKind::OutsideLimits, FindingSubject::Joint(joint), message)
}
