//! Collection of findings while a file is read: bounded in number, with positions computed at the end.
//!
//! Functions with a `Report` parameter add every defect to the report, and then return `None`, a default or an empty text.

use crate::Diagnostic;
use crate::reading::limits::{MAX_COLUMN_OFFSET, MAX_QUOTED_CHARACTERS, MAX_REPEATED_KINDS, MOST_FINDINGS};
use percuss_mechanism::{Accept, Problem, Severity};
use roxmltree::Node;
use std::collections::HashMap;

/// Position of a finding.
#[derive(Clone, Copy)]
pub enum Place<'a, 'i> {
    /// The whole file.
    File,
    /// Byte offset in the text.
    Offset(usize),
    /// An element.
    Element(Node<'a, 'i>),
    /// An attribute of an element; the element if the attribute is absent.
    Attribute(Node<'a, 'i>, &'a str),
    /// Byte offset in the text, and the XML path of the element there.
    Named(usize, &'a str),
}

/// Code of the notes about parts of a file that are no part of a mechanism.
pub const NOT_READ: &str = "not-read";

/// Finding with its position as a byte offset.
struct Finding {
    severity: Severity,
    code: &'static str,
    offset: Option<usize>,
    element: Option<String>,
    message: String,
    repeats: usize,
}

/// Findings collected so far, bounded in number.
#[derive(Default)]
pub struct Report {
    findings: Vec<Finding>,
    /// Number of findings per severity, and of parts that are not read, including those beyond the limit.
    counts: [usize; KINDS],
    /// Index in `findings` per code and kind; `None` beyond the limit.
    once: HashMap<(&'static str, String), Option<usize>>,
    is_xacro: bool,
    accept: Accept,
}

/// Number of kinds of findings.
const KINDS: usize = 4;

/// Index in `Report::counts`.
fn kind_index(severity: Severity, code: &str) -> usize {
    match severity {
        Severity::Error => 0,
        Severity::Warning => 1,
        Severity::Note if code == NOT_READ => 3,
        Severity::Note => 2,
    }
}

impl Report {
    /// Adds a finding; beyond the limit, the finding is only counted.
    pub fn add(
        &mut self,
        severity: Severity,
        code: &'static str,
        place: Place<'_, '_>,
        message: impl FnOnce() -> String,
    ) {
        let count = &mut self.counts[kind_index(severity, code)];
        *count += 1;
        if *count > MOST_FINDINGS {
            return;
        }
        let (offset, element) = match place {
            Place::File => (None, None),
            Place::Offset(offset) => (Some(offset), None),
            Place::Named(offset, path) => (Some(offset), Some(path.to_owned())),
            Place::Element(node) => (Some(node.range().start), Some(element_path(node))),
            Place::Attribute(node, name) => {
                let offset = node.attribute_node(name).map_or(node.range().start, |a| a.range().start);
                (Some(offset), Some(element_path(node)))
            }
        };
        self.findings.push(Finding { severity, code, offset, element, message: message(), repeats: 0 });
    }

    /// Sets the findings that the user accepts.
    pub(crate) fn accept(&mut self, accept: Accept) {
        self.accept = accept;
    }

    /// Findings that the user accepts.
    pub(crate) fn accepted(&self) -> Accept {
        self.accept
    }

    /// Adds a note about a part of the file that is no part of a mechanism, once per `kind`.
    pub(crate) fn add_unread(&mut self, place: Place<'_, '_>, kind: impl FnOnce() -> String) {
        let kind = kind();
        self.add_once(Severity::Note, NOT_READ, kind.clone(), place, || kind);
    }

    /// Adds a problem that the builder of mechanisms would find.
    pub(crate) fn add_problem(&mut self, place: Place<'_, '_>, problem: &Problem) {
        self.add(problem.severity(), problem.code(), place, || problem.to_string());
    }

    /// Adds an error.
    pub fn error(&mut self, code: &'static str, place: Place<'_, '_>, message: impl FnOnce() -> String) {
        self.add(Severity::Error, code, place, message);
    }

    /// Adds a warning.
    pub fn warning(&mut self, code: &'static str, place: Place<'_, '_>, message: impl FnOnce() -> String) {
        self.add(Severity::Warning, code, place, message);
    }

    /// Adds a note.
    pub fn note(&mut self, code: &'static str, place: Place<'_, '_>, message: impl FnOnce() -> String) {
        self.add(Severity::Note, code, place, message);
    }

    /// Adds a finding once per code and `kind`; repetitions are counted.
    pub(crate) fn add_once(
        &mut self,
        severity: Severity,
        code: &'static str,
        kind: String,
        place: Place<'_, '_>,
        message: impl FnOnce() -> String,
    ) {
        if let Some(first) = self.once.get(&(code, kind.clone())) {
            if let Some(finding) = first {
                self.findings[*finding].repeats += 1;
            }
            return;
        }
        let before = self.findings.len();
        self.add(severity, code, place, message);
        if self.once.len() < MAX_REPEATED_KINDS {
            let is_listed = self.findings.len() > before;
            self.once.insert((code, kind), is_listed.then_some(before));
        }
    }

    /// Adds the error for an unexpanded xacro file, at most once. `evidence`: xacro syntax in the file.
    pub(crate) fn add_xacro_error(&mut self, place: Place<'_, '_>, evidence: &str) {
        let message = || {
            format!(
                "this is a xacro file, not yet a URDF (it has {evidence}): run \"xacro FILE.xacro > FILE.urdf\" and \
                 load the result"
            )
        };
        if !std::mem::replace(&mut self.is_xacro, true) {
            self.error("xacro", place, message);
        }
    }

    /// True if the file is a xacro file; all other findings are then irrelevant.
    pub(crate) fn is_xacro(&self) -> bool {
        self.is_xacro
    }

    /// True if an error was added.
    pub fn has_errors(&self) -> bool {
        self.counts[kind_index(Severity::Error, "")] > 0
    }

    /// Converts the findings to diagnostics in the order of the file, findings without a position first.
    pub fn finish(self, path: &str, text: &str) -> Vec<Diagnostic> {
        finish_reports([(self, path, text)])
    }
}

/// Converts the findings of several files (report, path, text) to diagnostics, as [`Report::finish`]. The limit holds for all files
/// together.
pub(crate) fn finish_reports<'f>(
    files: impl IntoIterator<Item = (Report, &'f str, &'f str)>,
) -> Vec<Diagnostic> {
    let mut diagnostics: Vec<Diagnostic> = Vec::new();
    let (mut counts, mut shown, mut first) = ([0; KINDS], [0; KINDS], None);
    for (mut report, path, text) in files {
        first.get_or_insert(path);
        report.findings.sort_by_key(|finding| finding.offset);
        let mut line_counter = LineCounter { text: text.as_bytes(), position: 0, line: 1, line_start: 0 };
        (0..counts.len()).for_each(|severity| counts[severity] += report.counts[severity]);
        for finding in report.findings {
            let own = &mut shown[kind_index(finding.severity, finding.code)];
            if *own == MOST_FINDINGS {
                continue;
            }
            *own += 1;
            let place = finding.offset.map(|offset| line_counter.advance_to(offset));
            let mut message = finding.message;
            if finding.repeats > 0 {
                message.push_str(&format!(" ({} more like it)", finding.repeats));
            }
            diagnostics.push(Diagnostic {
                severity: finding.severity,
                code: finding.code,
                path: path.to_owned(),
                line: place.map(|(line, _)| line),
                column: place.and_then(|(_, column)| column),
                element: finding.element,
                message,
            });
        }
    }
    let more = |severity: Severity| (severity, "and-more");
    let kinds = [Severity::Error, Severity::Warning, Severity::Note].map(more);
    for (severity, code) in kinds.into_iter().chain([(Severity::Note, NOT_READ)]) {
        let omitted = counts[kind_index(severity, code)].saturating_sub(MOST_FINDINGS);
        if omitted > 0 {
            diagnostics.push(Diagnostic {
                severity,
                code,
                path: first.unwrap_or_default().to_owned(),
                line: None,
                column: None,
                element: None,
                message: format!("and {omitted} more {}s", severity.name()),
            });
        }
    }
    diagnostics
}

/// Converts ascending byte offsets to lines and columns in one pass over the text.
struct LineCounter<'t> {
    text: &'t [u8],
    position: usize,
    line: u32,
    line_start: usize,
}

impl LineCounter<'_> {
    /// Line and column of a byte offset, both from 1; `None` for a column far into a line. Offsets must not decrease.
    fn advance_to(&mut self, offset: usize) -> (u32, Option<u32>) {
        let offset = offset.min(self.text.len());
        while self.position < offset {
            if self.text[self.position] == b'\n' {
                self.line = self.line.saturating_add(1);
                self.line_start = self.position + 1;
            }
            self.position += 1;
        }
        let before = &self.text[self.line_start..offset.max(self.line_start)];
        // Counts the bytes that begin a UTF-8 character.
        let column = || before.iter().filter(|b| **b & 0xC0 != 0x80).count() as u32 + 1;
        (self.line, (before.len() <= MAX_COLUMN_OFFSET).then(column))
    }
}

/// XML path of an element, for example `robot/joint[hinge]/axis`.
fn element_path(node: Node<'_, '_>) -> String {
    let mut steps: Vec<String> = node
        .ancestors()
        .filter(Node::is_element)
        .map(|n| {
            let prefix = n.tag_name().namespace().and_then(|uri| n.lookup_prefix(uri));
            let lead = prefix.map(|p| format!("{}:", shortened(p))).unwrap_or_default();
            let tag = format!("{lead}{}", shortened(n.tag_name().name()));
            match n.attribute("name") {
                Some(name) if n.parent_element().is_some() => format!("{tag}[{}]", shortened(name)),
                Some(_) | None => tag,
            }
        })
        .collect();
    steps.reverse();
    steps.join("/")
}

/// Text in quotes on one line, truncated to `MAX_QUOTED_CHARACTERS` characters.
pub fn quoted(text: &str) -> String {
    format!("\"{}\"", shortened(text))
}

/// Text on one line, truncated to `MAX_QUOTED_CHARACTERS` characters.
pub fn shortened(text: &str) -> String {
    cut(text, MAX_QUOTED_CHARACTERS)
}

/// Text on one line, truncated to `longest` characters.
pub fn cut(text: &str, longest: usize) -> String {
    let printable = |c: char| if c.is_control() { ' ' } else { c };
    match text.char_indices().nth(longest) {
        Some((end, _)) => text[..end].chars().map(printable).chain(['…']).collect(),
        None => text.chars().map(printable).collect(),
    }
}
