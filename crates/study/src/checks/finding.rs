//! Finding about a result: severity, kind, subject and message, and the count of equal findings over rows.

use crate::checks::finding_kind::FindingKind;
use crate::model::record::DiagnosticRecord;
use percuss_mechanism::{JointId, LinkId, Severity};
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

/// Subject of a finding. Findings of the same kind and subject are counted as one, even if the numbers in the
/// messages differ.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum FindingSubject {
    /// Result as a whole.
    Result,
    /// Link.
    Link(LinkId),
    /// Joint.
    Joint(JointId),
    /// Loop or coupling, by name.
    Closure(String),
    /// Held contact, by number in the question.
    Hold(usize),
    /// Named contact, by number in the model.
    Contact(usize),
}

/// Finding for the reader of a result.
#[derive(Clone, Debug)]
pub(crate) struct Finding {
    severity: Severity,
    kind: FindingKind,
    subject: FindingSubject,
    message: String,
}

impl Finding {
    /// Kind of the finding.
    pub fn kind(&self) -> FindingKind {
        self.kind
    }

    /// Finding about a subject.
    pub fn new(kind: FindingKind, subject: FindingSubject, message: impl Into<String>) -> Self {
        Self { severity: kind.severity(), kind, subject, message: message.into() }
    }

    /// Finding about the result as a whole.
    pub fn about_result(kind: FindingKind, message: impl Into<String>) -> Self {
        Self::new(kind, FindingSubject::Result, message)
    }

    /// Subject of the finding.
    pub fn subject(&self) -> &FindingSubject {
        &self.subject
    }

    /// The finding with the place of its pose at the end of the message.
    pub fn with_place(self, place: &str) -> Self {
        Self { message: format!("{} ({place})", self.message), ..self }
    }

    /// The finding with the severity of a note.
    pub fn into_note(self) -> Self {
        Self { severity: Severity::Note, ..self }
    }
}

impl From<Finding> for DiagnosticRecord {
    fn from(finding: Finding) -> Self {
        let Finding { severity, kind, message, .. } = finding;
        Self { severity, code: kind.code(), path: None, line: None, column: None, element: None, message }
    }
}

/// Findings over the rows of a sweep, one entry per kind and subject, with the first row and the number of
/// rows.
#[derive(Debug, Default)]
pub(crate) struct FindingTally {
    counts: BTreeMap<(FindingKind, FindingSubject), CountedFinding>,
}

#[derive(Debug)]
struct CountedFinding {
    /// First occurrence.
    finding: Finding,
    first_row: usize,
    rows: usize,
}

impl FindingTally {
    /// Adds the findings of a row.
    pub fn add(&mut self, row: usize, findings: impl IntoIterator<Item = Finding>) {
        for finding in findings {
            let key = (finding.kind, finding.subject.clone());
            self.counts.entry(key).or_insert(CountedFinding { finding, first_row: row, rows: 0 }).rows += 1;
        }
    }

    /// Adds findings that hold for each of `rows` rows.
    pub fn add_repeated(&mut self, first_row: usize, rows: usize, findings: &[Finding]) {
        for finding in findings {
            let key = (finding.kind, finding.subject.clone());
            let counted = || CountedFinding { finding: finding.clone(), first_row, rows: 0 };
            self.counts.entry(key).or_insert_with(counted).rows += rows;
        }
    }

    /// Adds the findings of later rows.
    pub fn append(&mut self, later: Self) {
        for (key, counted) in later.counts {
            match self.counts.entry(key) {
                Entry::Vacant(entry) => drop(entry.insert(counted)),
                Entry::Occupied(mut entry) => entry.get_mut().rows += counted.rows,
            }
        }
    }

    /// All findings of `rows` rows as records. A finding that does not occur in all rows gets the first row and
    /// the number of further rows appended.
    pub fn into_records(self, rows: usize) -> impl Iterator<Item = DiagnosticRecord> {
        self.into_records_of(rows, "row")
    }

    /// As [`into_records`](Self::into_records), with another word for a row.
    pub fn into_records_of(self, rows: usize, row: &'static str) -> impl Iterator<Item = DiagnosticRecord> {
        self.counts.into_values().map(move |counted| {
            let mut record = DiagnosticRecord::from(counted.finding);
            if counted.rows < rows {
                record.message += &match counted.rows {
                    1 => format!(" ({row} {})", counted.first_row),
                    more => format!(" ({row} {}, and {} more)", counted.first_row, more - 1),
                };
            }
            record
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Findings of equal kind and subject are counted as one; the message text is ignored.
    #[test]
    fn a_message_is_not_read() {
        let mut tally = FindingTally::default();
        let rod = || FindingSubject::Closure("rod".into());
        tally.add(0, [Finding::new(FindingKind::DrawnOpen, rod(), "\"a\" 1")]);
        tally.add(
            1,
            [
                Finding::new(FindingKind::DrawnOpen, rod(), "\"b\" 2"),
                Finding::new(FindingKind::DrawnOpen, FindingSubject::Hold(0), "\"a\" 1"),
            ],
        );
        tally.add(2, [Finding::new(FindingKind::DrawnOpen, rod(), "\"c\" 3")]);
        let messages: Vec<String> = tally.into_records(3).map(|record| record.message).collect();
        assert_eq!(messages, ["\"a\" 1", "\"a\" 1 (row 1)"]);
    }
}
