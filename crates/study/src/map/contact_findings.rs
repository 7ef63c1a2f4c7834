//! Findings about single contacts of a map.

use crate::checks::finding::{Finding, FindingTally};
use crate::checks::finding_kind::{FindingKind, FindingScope};
use crate::evaluation::prepared_question::PreparedQuestion;
use crate::model::record::DiagnosticRecord;
use crate::thresholds::{EXAMINED_CONTACTS, PLAIN_CONTACT_ERROR};
use percuss_dynamics::{Contact, ContactStatus, Pose};

/// Findings about a motion without mass or about the rank: all contacts of a pose share them.
pub(crate) const OF_POSE: [FindingKind; 4] = [
    FindingKind::IndefiniteMassMatrix,
    FindingKind::MasslessMotions,
    FindingKind::UnclearRankHere,
    FindingKind::UndeterminedMotion,
];

/// Results of the contacts of a map for the mechanism alone.
pub(crate) struct MapResults<'m, C: Fn(usize) -> Contact> {
    pub statuses: &'m [ContactStatus],
    /// Relative errors of m̄; NaN if unknown.
    pub errors: &'m [f64],
    /// Contact with a number.
    pub contact: C,
    /// Word for a contact in messages.
    pub word: &'static str,
}

/// Findings about the contacts of a map beyond those of its pose, counted, with the number of the first contact.
///
/// A finite result with a small error has no finding of its own. The others are computed again, each with all remarks of its response; of
/// a large map, evenly spaced ones.
pub(crate) fn map_contact_findings<C: Fn(usize) -> Contact>(
    prepared: &PreparedQuestion,
    pose: &Pose,
    results: &MapResults<C>,
) -> Vec<DiagnosticRecord> {
    let is_examined = |number: &usize| match results.statuses[*number] {
        _ if prepared.holds_by_pushing() => true,
        ContactStatus::Finite => {
            results.errors[*number] > PLAIN_CONTACT_ERROR || results.errors[*number].is_nan()
        }
        // An immovable contact has a finding only against a body, whose mass is then the result.
        ContactStatus::Immovable => prepared.other_mass().is_some(),
        _ => true,
    };
    let numbers = || (0..results.statuses.len()).filter(is_examined);
    let stride = numbers().count().div_ceil(EXAMINED_CONTACTS).max(1);
    // The first contact with a mass has the findings of the pose.
    let first = results.statuses.iter().position(|status| *status == ContactStatus::Finite);
    let first = first.filter(|first| !is_examined(first));
    let mut of_pose: Vec<Finding> = Vec::new();
    let mut tally = FindingTally::default();
    for number in first.into_iter().chain(numbers().step_by(stride)) {
        let contact = (results.contact)(number);
        let Ok(response) = pose.respond(&contact) else { continue };
        let Ok(found) = prepared.findings_of_response(pose, &contact, &response) else { continue };
        for finding in found.into_iter().filter(|finding| finding.kind().scope() == FindingScope::Pose) {
            if !OF_POSE.contains(&finding.kind()) {
                tally.add(number, [finding]);
            } else if of_pose.iter().all(|known| known.kind() != finding.kind()) {
                of_pose.push(finding);
            }
        }
    }
    if stride > 1 {
        let message = format!(
            "of {} contacts with a large error or a held contact, one in {stride} was examined; the findings count the examined ones",
            numbers().count()
        );
        of_pose.push(Finding::about_result(FindingKind::RowsNotTried, message));
    }
    let of_contacts = tally.into_records_of(results.statuses.len(), results.word);
    of_contacts.chain(of_pose.into_iter().map(DiagnosticRecord::from)).collect()
}
