//! Diagnostics as lines of text.

use crate::terminal::limits;
use percuss_mechanism::Severity;
use percuss_study::DiagnosticRecord;
use std::collections::HashMap;

/// One line per diagnostic. Of many warnings or notes of one kind, only the first few are shown, with a count. Notes
/// are summarised in one line unless `notes_shown`.
pub fn lines(diagnostics: &[DiagnosticRecord], notes_shown: bool) -> Vec<String> {
    let notes = diagnostics.iter().filter(|d| d.severity == Severity::Note).count();
    if !notes_shown && notes > 0 {
        let rest: Vec<DiagnosticRecord> =
            diagnostics.iter().filter(|d| d.severity != Severity::Note).cloned().collect();
        let mut lines = lines(&rest, true);
        lines.push(match notes {
            1 => "1 note: --notes shows it".to_owned(),
            notes => format!("{notes} notes: --notes shows them"),
        });
        return lines;
    }
    let mut totals: HashMap<&str, usize> = HashMap::new();
    for d in diagnostics {
        *totals.entry(d.code).or_default() += 1;
    }
    let mut shown: HashMap<&str, usize> = HashMap::new();
    let mut lines = Vec::new();
    for d in diagnostics {
        let (total, so_far) = (totals[d.code], shown.entry(d.code).or_default());
        *so_far += 1;
        if d.severity == Severity::Error
            || total <= limits::DIAGNOSTICS_SHOWN + 1
            || *so_far <= limits::DIAGNOSTICS_SHOWN
        {
            lines.push(d.line());
        } else if *so_far == total {
            let rest = total - limits::DIAGNOSTICS_SHOWN;
            lines.push(format!(
                "{}: and {rest} more of this kind ({}); all in --format json",
                d.severity.name(),
                d.code
            ));
        }
    }
    lines
}
