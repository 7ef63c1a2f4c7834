//! Checks of models, questions and results, and the findings they report.

pub(crate) mod design;
pub(crate) mod far_point;
pub(crate) mod finding;
pub(crate) mod findings;
pub(crate) mod holds;
pub(crate) mod model_check;
pub(crate) mod response_findings;
