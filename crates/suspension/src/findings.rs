//! Findings about suspension files, each with its key path and its position.

use super::text::line_and_column;
use percuss_formats::Diagnostic;
use percuss_formats::reading::MOST_FINDINGS;
use percuss_mechanism::Severity;

/// Position in a file: key path and first byte.
#[derive(Clone, Debug, Default)]
pub(super) struct Spot {
    pub path: Option<String>,
    /// Byte offset in the text; `None` without a file or with an unknown position.
    pub at: Option<usize>,
    /// Index of the file: 0 for the file named by the user, larger for files read with it.
    pub file: usize,
}

impl Spot {
    /// Key path for messages.
    pub fn label(&self) -> &str {
        self.path.as_deref().unwrap_or("the file")
    }

    /// True if the position has a key path.
    pub fn has_path(&self) -> bool {
        self.path.is_some()
    }
}

/// Code of the finding about the worksheets of a workbook.
pub(super) const FIRST_WORKSHEET: &str = "first-worksheet";

#[derive(Clone, Debug)]
struct Finding {
    severity: Severity,
    code: &'static str,
    spot: Spot,
    message: String,
}

/// Findings collected so far.
#[derive(Clone, Debug, Default)]
pub(super) struct Findings {
    list: Vec<Finding>,
    /// Number of warnings and notes beyond the limit.
    omitted: usize,
}

impl Findings {
    /// Adds a finding; identical findings are reported once.
    pub fn add(&mut self, severity: Severity, code: &'static str, spot: &Spot, message: String) {
        let same = |f: &Finding| f.code == code && f.spot.path == spot.path && f.message == message;
        if self.list.iter().any(same) {
            return;
        }
        if severity != Severity::Error && self.list.len() >= MOST_FINDINGS {
            self.omitted += 1;
            return;
        }
        self.list.push(Finding { severity, code, spot: spot.clone(), message });
    }

    /// Adds an error.
    pub fn error(&mut self, code: &'static str, spot: &Spot, message: String) {
        self.add(Severity::Error, code, spot, message);
    }

    /// Adds a warning.
    pub fn warning(&mut self, code: &'static str, spot: &Spot, message: String) {
        self.add(Severity::Warning, code, spot, message);
    }

    /// Adds a note.
    pub fn note(&mut self, code: &'static str, spot: &Spot, message: String) {
        self.add(Severity::Note, code, spot, message);
    }

    /// True if a finding with this code is about this key path.
    pub fn has(&self, code: &str, path: &str) -> bool {
        self.list.iter().any(|f| f.code == code && f.spot.path.as_deref() == Some(path))
    }

    /// True if a finding has this code.
    pub fn has_code(&self, code: &str) -> bool {
        self.list.iter().any(|f| f.code == code)
    }

    /// Removes warnings and notes with these codes; another finding states their common cause.
    pub fn remove(&mut self, codes: &[&str]) {
        self.list.retain(|f| f.severity == Severity::Error || !codes.contains(&f.code));
    }

    /// Unwraps a value computed from hardpoints. `None` is reported as degenerate geometry, unless an earlier error
    /// explains it; the result is then the default.
    pub fn unwrap_geometry<T: Default>(&mut self, value: Option<T>, spot: &Spot, defect: &str) -> T {
        if value.is_none() && !self.has_errors() {
            self.error("degenerate-geometry", spot, defect.to_owned());
        }
        value.unwrap_or_default()
    }

    /// True if an error was added.
    pub fn has_errors(&self) -> bool {
        self.list.iter().any(|f| f.severity == Severity::Error)
    }

    /// Returns all findings in the order of the files (pairs of name and text), findings without a position first.
    pub fn finish(mut self, files: &[(&str, &str)]) -> Vec<Diagnostic> {
        if self.omitted > 0 {
            let message = format!("and {} more warnings and notes", self.omitted);
            let spot = Spot::default();
            self.list.push(Finding { severity: Severity::Warning, code: "and-more", spot, message });
        }
        // The wrong worksheet may be the cause of an error in a workbook; the list of the worksheets is then part of the error.
        if self.has_errors() {
            let of_worksheets = self.list.iter_mut().filter(|f| f.code == FIRST_WORKSHEET);
            of_worksheets.for_each(|f| f.severity = Severity::Error);
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

#[cfg(test)]
mod tests {
    use super::*;

    /// The list of worksheets is a note; after an error in the worksheet, such as missing masses, it is part of the error.
    #[test]
    fn worksheets_are_listed_with_an_error() {
        let listed = |with_error: bool| {
            let mut findings = Findings::default();
            findings.note(FIRST_WORKSHEET, &Spot::default(), "the workbook has 2 worksheets".to_owned());
            if with_error {
                findings.error("missing-key", &Spot::default(), "no masses".to_owned());
            }
            let found = findings.finish(&[("car.xlsx", "")]);
            found.iter().find(|d| d.code == FIRST_WORKSHEET).map(|d| d.severity)
        };
        assert_eq!(listed(false), Some(Severity::Note));
        assert_eq!(listed(true), Some(Severity::Error));
    }
}
