//! Texts of faults that depend on the names of flags, study keys or fields.

use crate::question::names::{Names, assembly_error_message};
use percuss_dynamics::AssemblyError;
use percuss_mechanism::JointKind;

/// Message: a joint is varied and set.
pub(super) fn varied_is_set(joint: &str, names: Names) -> String {
    format!("\"{joint}\": it is already set{}; use only one of the two", names.hint("pose.set"))
}

/// Message: a joint without limits cannot have random positions.
pub(super) fn no_limits(joint: &str, kind: JointKind, names: Names) -> String {
    let (set, vary) = (names.hint("pose.set"), names.hint("sweep.vary"));
    let what = match kind {
        JointKind::Planar | JointKind::Floating => "has no limits",
        JointKind::Fixed
        | JointKind::Revolute
        | JointKind::Continuous
        | JointKind::Prismatic
        | JointKind::Spherical => "has no <limit>",
    };
    let remedy = if kind.positions() == 1 {
        format!("give it a <limit>, set it{set}, or vary ranges instead of random positions{vary}")
    } else {
        format!("set it{set}")
    };
    format!("joint \"{joint}\" is {} and {what} to sample between; {remedy}", kind.name())
}

/// Message: no pose for the conversion of a contact point.
pub(super) fn no_reference_pose(source: &AssemblyError, names: Names) -> String {
    let how = match names {
        Names::Fields => "",
        Names::Flags => " (--frame link)",
        Names::Keys(_) => " (contact.frame = \"link\")",
    };
    let why = assembly_error_message(source, names);
    format!(
        "a point in this frame is converted to the frame of the contact link with the varied joint at 0, but \
         this pose cannot be reached ({why}); give the point in the frame of the contact link{how}"
    )
}
