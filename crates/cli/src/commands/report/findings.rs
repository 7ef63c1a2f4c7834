//! Warnings about a result, beside the number or the figure that they concern.

use crate::files::html::Page;
use percuss_mechanism::Severity;
use percuss_study::DiagnosticRecord;

/// Adds the warnings about a result as boxes. Findings about files, and notes, are listed with the inputs.
pub(super) fn add_warnings<'d>(findings: impl IntoIterator<Item = &'d DiagnosticRecord>, page: &mut Page) {
    let concerns = |finding: &&DiagnosticRecord| finding.path.is_none() && finding.severity != Severity::Note;
    for finding in findings.into_iter().filter(concerns) {
        page.warning(&finding.line());
    }
}
