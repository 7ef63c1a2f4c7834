//! Impact and extremes of a study, added to the report of the contact.

use crate::question::errors::question_error::StudyError;
use crate::reports::impact::extremes::ExtremesReport;
use crate::reports::impact::report::ImpactReport;
use crate::study_file::file::StudyFile;
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

impl StudyFile {
    /// Impact and extremes at the contact of the study.
    ///
    /// # Errors
    /// [`StudyError`], as for [`impact`](crate::impact) and [`extremes`](crate::extremes).
    pub fn additions(&self) -> Result<StudyAdditions, StudyError> {
        let question = self.question.as_ref();
        Ok(StudyAdditions {
            impact: self.impact_report(question)?,
            extremes: self.extremes_report(question)?,
        })
    }
}
