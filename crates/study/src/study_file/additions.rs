//! Impact and extremes of a study, added to the report of the contact.

use crate::reports::impact::extremes::ExtremesReport;
use crate::reports::impact::report::ImpactReport;
use serde::Serialize;

/// Impact and extremes of a study: keys that are added to the report of the contact.
#[derive(Clone, Debug, Default, Serialize)]
pub struct StudyAdditions {
    /// Report of `[impact]`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub impact: Option<ImpactReport>,
    /// Report of `[extremes]`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub extremes: Option<ExtremesReport>,
}

/// Report with the keys `impact` and `extremes`; a key is absent if the study does not have its table.
#[derive(Debug, Serialize)]
pub struct WithAdditions<'a, R> {
    /// Report of the contact.
    #[serde(flatten)]
    pub report: &'a R,
    /// Impact and extremes.
    #[serde(flatten)]
    pub additions: &'a StudyAdditions,
}
