//! Headings in the help that several commands share.

/// Link, point and normal.
pub const CONTACT: &str = "Contact";
/// Joint positions.
pub const POSE: &str = "Pose";
/// Locks, fixed points, armatures, base.
pub const CONDITIONS: &str = "Conditions";
/// Output in addition to the effective mass.
pub const ADDITIONAL: &str = "Additional results";
/// Changes to masses and hardpoints.
pub const CHANGES: &str = "Changes to the model";
/// Limits and checks of input files.
pub const READING: &str = "Reading";
/// Format of the result.
pub const ANSWER: &str = "Result";
/// Output files.
pub const OUTPUT: &str = "Output";
