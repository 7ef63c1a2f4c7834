//! Rows of a linkage that are followed several at once: where m̄ is all that is asked, and nothing but where the joints stand
//! can be said of one row and not of another.

use crate::answer::Prepared;
use crate::finding::Finding;
use crate::findings::outside_limits;
use crate::positions::{PoseLayout, Positions};
use crate::setting::Setting;
use percuss_dynamics::{Contact, DrivenPath, EffectiveMass, PathAnswer, Pose};
use percuss_mechanism::{JointId, Limits};
use std::sync::Arc;

/// What is said of every pose of a branch alike.
const OF_THE_BRANCH: [&str; 10] = [
    "drawn-open",
    "driver-off-zero",
    "drivers-chosen",
    "far-point",
    "inexact-loops",
    "off-target",
    "reversed-axis",
    "rigid-loops",
    "unclear-rank",
    "weakly-constrained",
];

/// Rows that follow one another from a pose.
#[derive(Debug)]
pub(crate) struct Following {
    path: DrivenPath,
    /// What is said of all of them.
    findings: Arc<[Finding]>,
    limits: Vec<(JointId, usize, Limits)>,
    answers: Vec<PathAnswer>,
    positions: Vec<f64>,
}

/// A row that was followed.
#[derive(Debug)]
pub(crate) struct FollowedRow {
    pub positions: Positions,
    /// m̄ and what it may be off by, kg.
    pub mass: (f64, f64),
    /// m.
    pub residual: f64,
    /// Said of every row of its branch.
    pub alike: Arc<[Finding]>,
    /// Said of this one.
    pub own: Vec<Finding>,
}

/// How a row was reached.
pub(crate) enum Reached {
    Answered(FollowedRow),
    /// Its m̄ is to be asked.
    Posed(Arc<Pose>),
}

impl Following {
    /// From a pose on; none where rows must be posed one by one.
    pub fn from(prepared: &Prepared, setting: &Setting, contact: &Contact, pose: &Pose) -> Option<Self> {
        if !prepared.is_plain() || setting.travels() || pose.loops().is_none() {
            return None;
        }
        let single = |(joint, numbers): (JointId, &std::ops::Range<usize>)| {
            (numbers.len() == 1).then_some((numbers.start, joint))
        };
        let mut joints: Vec<(usize, JointId)> = setting.joints().map(single).collect::<Option<_>>()?;
        joints.sort_unstable();
        let joints: Vec<JointId> = joints.into_iter().map(|(_, joint)| joint).collect();
        let path = pose.driven_path(contact, &joints).ok().flatten()?;
        let answer = prepared.answer(pose, contact).ok()?;
        let alike = |finding: &Finding| OF_THE_BRANCH.contains(&finding.code());
        let plain = |finding: &Finding| alike(finding) || finding.code() == "outside-limits";
        let finite = matches!(answer.response.effective_mass, EffectiveMass::Finite(_));
        if !finite || answer.response.singular_pose || !answer.findings.iter().all(plain) {
            return None;
        }
        let mechanism = prepared.system.mechanism();
        let mut next = 0;
        let limited = mechanism.joint_ids().filter_map(|id| {
            let joint = mechanism.joint(id);
            let place = next;
            next += joint.kind().positions();
            let limits = joint.limits().filter(|_| joint.kind().positions() == 1)?;
            Some((id, place, limits))
        });
        let limits = limited.collect();
        let findings = answer.findings.into_iter().filter(alike).collect();
        Some(Self { path, findings, limits, answers: Vec::new(), positions: Vec::new() })
    }

    /// Follows rows until the branch of one is in doubt, and hands them out. Gives how many were reached.
    pub fn follow(
        &mut self,
        prepared: &Prepared,
        layout: &Arc<PoseLayout>,
        rows: &[f64],
        mut each: impl FnMut(Reached),
    ) -> usize {
        let Self { path, findings, limits, answers, positions } = self;
        answers.clear();
        positions.clear();
        let reached = path.follow(rows, answers, positions);
        let width = positions.len() / reached.max(1);
        for (answer, own) in answers.iter().zip(positions.chunks(width.max(1))) {
            let Some(mass) = answer.mass else {
                // As many positions as the mechanism has.
                if let Ok(pose) = path.pose_at(own, answer.residual) {
                    each(Reached::Posed(Arc::new(pose)));
                }
                continue;
            };
            let outside = limits.iter().filter(|(_, place, limits)| Pose::is_outside(own[*place], *limits));
            let outside = outside.map(|&(joint, place, limits)| {
                outside_limits(prepared.system.mechanism(), joint, own[place], limits)
            });
            each(Reached::Answered(FollowedRow {
                positions: Positions::of_columns(layout, own, 1, 0),
                mass,
                residual: answer.residual,
                alike: Arc::clone(findings),
                own: outside.collect(),
            }));
        }
        reached
    }

    /// The pose where it stands.
    pub fn pose(&self) -> Pose {
        self.path.pose()
    }

    /// Goes on from another pose of the branch; whether it can.
    pub fn restart(&mut self, pose: &Pose) -> bool {
        self.path.restart(pose)
    }
}
