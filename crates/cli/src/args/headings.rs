//! Headings of the help that several commands share.

/// Where the contact is.
pub const CONTACT: &str = "Contact";
/// How the mechanism stands.
pub const POSE: &str = "Pose";
/// What else holds of it.
pub const CONDITIONS: &str = "Conditions";
/// What is shown beside the answer.
pub const BESIDE: &str = "Beside the answer";
/// What is changed of the model.
pub const CHANGES: &str = "Changes to the model";
/// How files are read.
pub const READING: &str = "Reading";
/// How the answer is shown.
pub const ANSWER: &str = "Answer";
/// What is written.
pub const OUTPUT: &str = "Output";
