//! Path follower for the rows of a linkage: several rows are evaluated in one call. Applicable if only m̄ is
//! requested and rows differ in joint positions and joint-limit findings only.

use crate::checks::finding::Finding;
use crate::checks::findings::joint_limit_finding;
use crate::evaluation::prepared_question::PreparedQuestion;
use crate::pose::positions::{PoseLayout, Positions};
use crate::sweep::row_layout::RowLayout;
use percuss_dynamics::{Contact, DrivenPath, EffectiveMass, PathAnswer, Pose};
use percuss_mechanism::{JointId, Limits};
use std::sync::Arc;

/// Codes of findings that hold for every pose of a branch.
const BRANCH_FINDING_CODES: [&str; 10] = [
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

/// Follower of consecutive rows from a starting pose.
#[derive(Debug)]
pub(crate) struct PathFollower {
    path: DrivenPath,
    /// Findings that hold for all rows.
    findings: Arc<[Finding]>,
    limits: Vec<(JointId, usize, Limits)>,
    results: Vec<PathAnswer>,
    positions: Vec<f64>,
}

/// Row evaluated by the follower.
#[derive(Debug)]
pub(crate) struct FollowedRow {
    pub positions: Positions,
    /// m̄ and the error bound, kg.
    pub mass: (f64, f64),
    /// Closure residual, m.
    pub residual: f64,
    /// Findings that hold for every row of the branch.
    pub shared_findings: Arc<[Finding]>,
    /// Findings about this row only.
    pub own: Vec<Finding>,
}

/// Result of following one row.
pub(crate) enum FollowResult {
    Evaluated(FollowedRow),
    /// Pose found; m̄ must be evaluated separately.
    Posed(Arc<Pose>),
}

impl PathFollower {
    /// Follower from a pose; `None` if the rows require separate poses.
    pub fn from(
        prepared: &PreparedQuestion,
        setting: &RowLayout,
        contact: &Contact,
        pose: &Pose,
    ) -> Option<Self> {
        if !prepared.needs_only_mass() || setting.travels() || pose.loops().is_none() {
            return None;
        }
        let single = |(joint, numbers): (JointId, &std::ops::Range<usize>)| {
            (numbers.len() == 1).then_some((numbers.start, joint))
        };
        let mut joints: Vec<(usize, JointId)> = setting.joints().map(single).collect::<Option<_>>()?;
        joints.sort_unstable();
        let joints: Vec<JointId> = joints.into_iter().map(|(_, joint)| joint).collect();
        let path = pose.driven_path(contact, &joints).ok().flatten()?;
        let answer = prepared.evaluate(pose, contact).ok()?;
        let alike = |finding: &Finding| BRANCH_FINDING_CODES.contains(&finding.code());
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
        Some(Self { path, findings, limits, results: Vec::new(), positions: Vec::new() })
    }

    /// Follows rows until the branch of a row is uncertain, and passes each result to `each`. Returns the
    /// number of rows reached.
    pub fn follow(
        &mut self,
        prepared: &PreparedQuestion,
        layout: &Arc<PoseLayout>,
        rows: &[f64],
        mut each: impl FnMut(FollowResult),
    ) -> usize {
        let Self { path, findings, limits, results: answers, positions } = self;
        answers.clear();
        positions.clear();
        let reached = path.follow(rows, answers, positions);
        let width = positions.len() / reached.max(1);
        for (answer, own) in answers.iter().zip(positions.chunks(width.max(1))) {
            let Some(mass) = answer.mass else {
                // The positions come from the path, so their number matches the mechanism.
                if let Ok(pose) = path.pose_at(own, answer.residual) {
                    each(FollowResult::Posed(Arc::new(pose)));
                }
                continue;
            };
            let outside = limits.iter().filter(|(_, place, limits)| Pose::is_outside(own[*place], *limits));
            let outside = outside.map(|&(joint, place, limits)| {
                joint_limit_finding(prepared.system.mechanism(), joint, own[place], limits)
            });
            each(FollowResult::Evaluated(FollowedRow {
                positions: Positions::from_columns(layout, own, 1, 0),
                mass,
                residual: answer.residual,
                shared_findings: Arc::clone(findings),
                own: outside.collect(),
            }));
        }
        reached
    }

    /// Current pose of the path.
    pub fn pose(&self) -> Pose {
        self.path.pose()
    }

    /// Restarts from another pose of the branch. Returns true on success.
    pub fn restart(&mut self, pose: &Pose) -> bool {
        self.path.restart(pose)
    }
}
