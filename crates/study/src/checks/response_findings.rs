//! Findings about poses and responses for programs that use the library directly; the reports list the same
//! findings.

use crate::checks::findings::{about_branches, about_pose, about_response};
use crate::model::record::DiagnosticRecord;
use crate::question::field::Names;
use percuss_dynamics::{Contact, ContactResponse, Pose, System};

/// Findings about a pose: joints outside their limits, closure of the loops, rank of the constraint rows.
pub fn pose_findings(system: &System, pose: &Pose) -> Vec<DiagnosticRecord> {
    about_pose(system, pose, Names::Fields).into_iter().map(DiagnosticRecord::from).collect()
}

/// Findings about a contact response and its [pose](pose_findings). At a singular pose the branches are
/// followed to find the limits of m̄.
pub fn response_findings(
    system: &System,
    pose: &Pose,
    contact: &Contact,
    response: &ContactResponse,
) -> Vec<DiagnosticRecord> {
    let mut findings = about_pose(system, pose, Names::Fields);
    findings.extend(about_response(system, contact, response, Names::Fields));
    if response.singular_pose {
        findings.extend(about_branches(pose, response, &pose.branch_limits(contact)));
    }
    findings.into_iter().map(DiagnosticRecord::from).collect()
}
