//! Rows of a linkage without poses, if only m̄ is requested: the rows differ in joint positions and joint-limit findings
//! only.

use crate::checks::finding::Finding;
use crate::checks::joint_limits::LimitedJoints;
use crate::evaluation::prepared_question::PreparedQuestion;
use crate::pose::positions::{PoseLayout, Positions};
use crate::sweep::row_layout::RowLayout;
use percuss_dynamics::{Contact, DrivenPath, Pose};
use percuss_mechanism::JointId;
use std::sync::Arc;

/// Findings of the rows of a path.
#[derive(Debug)]
pub(crate) struct PathFindings {
    /// Findings that hold for all rows.
    shared: Arc<[Finding]>,
    limits: LimitedJoints,
}

/// Row evaluated without a pose.
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

impl PathFindings {
    /// Path from a pose, and the findings of its rows; `None` if the rows require separate poses.
    pub fn of_path(
        prepared: &PreparedQuestion,
        setting: &RowLayout,
        contact: &Contact,
        pose: &Pose,
    ) -> Option<(DrivenPath, Self)> {
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
        let shared = prepared.evaluate(pose, contact).ok()?.into_branch_findings()?.into();
        Some((path, Self { shared, limits: LimitedJoints::of(prepared.system.mechanism()) }))
    }

    /// Row with a result for m̄. `positions`: positions of all joints.
    pub fn row(
        &self,
        prepared: &PreparedQuestion,
        layout: &Arc<PoseLayout>,
        mass: (f64, f64),
        residual: f64,
        positions: &[f64],
    ) -> FollowedRow {
        FollowedRow {
            positions: Positions::from_columns(layout, positions, 1, 0),
            mass,
            residual,
            shared_findings: Arc::clone(&self.shared),
            own: self.limits.findings(prepared.system.mechanism(), |index| positions[index]).collect(),
        }
    }
}
