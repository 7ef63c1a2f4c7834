//! Checks of models, questions and results, and the findings they report.

pub(crate) mod design_variant;
pub(crate) mod far_point_check;
pub(crate) mod finding;
pub(crate) mod finding_kind;
pub(crate) mod findings;
pub(crate) mod held_contact;
pub(crate) mod joint_limits;
pub(crate) mod model_check;
pub(crate) mod response_findings;
