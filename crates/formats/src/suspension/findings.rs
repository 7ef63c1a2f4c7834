//! What is said of suspension files while they are read: each finding with its key path and its place.

use super::text::line_and_column;
use crate::Diagnostic;
use crate::limits::MOST_FINDINGS;
use percuss_mechanism::Severity;

/// Where something stands in a file: its key path and its first byte.
#[derive(Clone, Debug, Default)]
pub(super) struct Spot {
    pub path: Option<String>,
    /// A byte of the text; none where the file is none, or the place is not known.
    pub at: Option<usize>,
    /// Which of the files that are read together: 0 is the one that was named.
    pub file: usize,
}

impl Spot {
    /// The key path as a reader would say it.
    pub fn label(&self) -> &str {
        self.path.as_deref().unwrap_or("the file")
    }

    /// Whether it is a place of a file at all.
    pub fn is_somewhere(&self) -> bool {
        self.path.is_some()
    }
}

struct Finding {
    severity: Severity,
    code: &'static str,
    spot: Spot,
    message: String,
}

/// The findings so far.
#[derive(Default)]
pub(super) struct Findings {
    list: Vec<Finding>,
    untold: usize,
}

impl Findings {
    /// Adds a finding; the same one twice is reported once.
    pub fn add(&mut self, severity: Severity, code: &'static str, spot: &Spot, message: String) {
        let same = |f: &Finding| f.code == code && f.spot.path == spot.path && f.message == message;
        if self.list.iter().any(same) {
            return;
        }
        if severity != Severity::Error && self.list.len() >= MOST_FINDINGS {
            self.untold += 1;
            return;
        }
        self.list.push(Finding { severity, code, spot: spot.clone(), message });
    }

    /// An error.
    pub fn error(&mut self, code: &'static str, spot: &Spot, message: String) {
        self.add(Severity::Error, code, spot, message);
    }

    /// A warning.
    pub fn warning(&mut self, code: &'static str, spot: &Spot, message: String) {
        self.add(Severity::Warning, code, spot, message);
    }

    /// A note.
    pub fn note(&mut self, code: &'static str, spot: &Spot, message: String) {
        self.add(Severity::Note, code, spot, message);
    }

    /// Whether anything forbids a mechanism.
    pub fn has_errors(&self) -> bool {
        self.list.iter().any(|f| f.severity == Severity::Error)
    }

    /// All findings in the order of the files (their names and texts), those without a place first.
    pub fn finish(mut self, files: &[(&str, &str)]) -> Vec<Diagnostic> {
        if self.untold > 0 {
            let message = format!("and {} more warnings and notes", self.untold);
            let spot = Spot::default();
            self.list.push(Finding { severity: Severity::Warning, code: "and-more", spot, message });
        }
        self.list.sort_by_key(|f| (f.spot.file, f.spot.at));
        let diagnostic = |f: Finding| {
            let (path, text) = files.get(f.spot.file).copied().unwrap_or_default();
            let place = f.spot.at.map(|at| line_and_column(text, at));
            Diagnostic {
                severity: f.severity,
                code: f.code,
                path: path.to_owned(),
                line: place.map(|(line, _)| line),
                column: place.map(|(_, column)| column),
                element: f.spot.path,
                message: f.message,
            }
        };
        self.list.into_iter().map(diagnostic).collect()
    }
}
