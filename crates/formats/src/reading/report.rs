//! Collection of findings while a file is read: bounded in number, with positions computed at the end.

use crate::Diagnostic;
use crate::reading::limits::{FARTHEST_COLUMN, LONGEST_SHOWN, MOST_FINDINGS, MOST_KINDS};
use percuss_mechanism::Severity;
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
}

struct Item {
    severity: Severity,
    code: &'static str,
    offset: Option<usize>,
    element: Option<String>,
    message: String,
    repeats: usize,
}

/// Findings collected so far.
#[derive(Default)]
pub struct Report {
    items: Vec<Item>,
    counts: [usize; 3],
    folded: HashMap<(&'static str, String), Option<usize>>,
    is_xacro: bool,
}

fn rank(severity: Severity) -> usize {
    match severity {
        Severity::Error => 0,
        Severity::Warning => 1,
        Severity::Note => 2,
    }
}

impl Report {
    /// Adds a finding. The message is formatted only for a finding within the limit.
    pub fn add(
        &mut self,
        severity: Severity,
        code: &'static str,
        place: Place<'_, '_>,
        message: impl FnOnce() -> String,
    ) {
        self.counts[rank(severity)] += 1;
        if self.counts[rank(severity)] > MOST_FINDINGS {
            return;
        }
        let (offset, element) = match place {
            Place::File => (None, None),
            Place::Offset(offset) => (Some(offset), None),
            Place::Element(node) => (Some(node.range().start), Some(path_of(node))),
            Place::Attribute(node, name) => {
                let offset = node.attribute_node(name).map_or(node.range().start, |a| a.range().start);
                (Some(offset), Some(path_of(node)))
            }
        };
        self.items.push(Item { severity, code, offset, element, message: message(), repeats: 0 });
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

    /// Adds a finding once per `kind`; repetitions are counted.
    pub(crate) fn fold(
        &mut self,
        severity: Severity,
        code: &'static str,
        kind: String,
        place: Place<'_, '_>,
        message: impl FnOnce() -> String,
    ) {
        if let Some(first) = self.folded.get(&(code, kind.clone())) {
            if let Some(item) = first {
                self.items[*item].repeats += 1;
            }
            return;
        }
        let before = self.items.len();
        self.add(severity, code, place, message);
        if self.folded.len() < MOST_KINDS {
            let told = self.items.len() > before;
            self.folded.insert((code, kind), told.then_some(before));
        }
    }

    /// Adds the error for a xacro file, at most once.
    pub(crate) fn xacro(&mut self, place: Place<'_, '_>, sign: &str) {
        let message = || {
            format!(
                "this is a xacro file, not yet a URDF (it has {sign}): run \"xacro FILE.xacro > FILE.urdf\" and \
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
        self.counts[rank(Severity::Error)] > 0
    }

    /// Returns all findings in the order of the file, findings without a position first.
    pub fn finish(mut self, path: &str, text: &str) -> Vec<Diagnostic> {
        self.items.sort_by_key(|item| item.offset);
        let mut places = Places { text: text.as_bytes(), at: 0, line: 1, line_start: 0 };
        let mut diagnostics: Vec<Diagnostic> = Vec::with_capacity(self.items.len() + 3);
        for item in self.items {
            let place = item.offset.map(|offset| places.of(offset));
            let mut message = item.message;
            if item.repeats > 0 {
                message.push_str(&format!(" ({} more like it)", item.repeats));
            }
            diagnostics.push(Diagnostic {
                severity: item.severity,
                code: item.code,
                path: path.to_owned(),
                line: place.map(|(line, _)| line),
                column: place.and_then(|(_, column)| column),
                element: item.element,
                message,
            });
        }
        for severity in [Severity::Error, Severity::Warning, Severity::Note] {
            let more = self.counts[rank(severity)].saturating_sub(MOST_FINDINGS);
            if more > 0 {
                diagnostics.push(Diagnostic {
                    severity,
                    code: "and-more",
                    path: path.to_owned(),
                    line: None,
                    column: None,
                    element: None,
                    message: format!("and {more} more {}s", severity.name()),
                });
            }
        }
        diagnostics
    }
}

/// Converts ascending byte offsets to lines and columns in one pass over the text.
struct Places<'t> {
    text: &'t [u8],
    at: usize,
    line: u32,
    line_start: usize,
}

impl Places<'_> {
    fn of(&mut self, offset: usize) -> (u32, Option<u32>) {
        let offset = offset.min(self.text.len());
        while self.at < offset {
            if self.text[self.at] == b'\n' {
                self.line = self.line.saturating_add(1);
                self.line_start = self.at + 1;
            }
            self.at += 1;
        }
        let before = &self.text[self.line_start..offset.max(self.line_start)];
        // Counts the bytes that begin a UTF-8 character.
        let column = || before.iter().filter(|b| **b & 0xC0 != 0x80).count() as u32 + 1;
        (self.line, (before.len() <= FARTHEST_COLUMN).then(column))
    }
}

/// XML path of an element, for example `robot/joint[hinge]/axis`.
fn path_of(node: Node<'_, '_>) -> String {
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

/// Text in quotes on one line, truncated to `LONGEST_SHOWN` characters.
pub fn quoted(text: &str) -> String {
    format!("\"{}\"", shortened(text))
}

/// Text on one line, truncated to `LONGEST_SHOWN` characters.
pub fn shortened(text: &str) -> String {
    cut(text, LONGEST_SHOWN)
}

/// Text on one line, truncated to `longest` characters.
pub fn cut(text: &str, longest: usize) -> String {
    let printable = |c: char| if c.is_control() { ' ' } else { c };
    match text.char_indices().nth(longest) {
        Some((end, _)) => text[..end].chars().map(printable).chain(['…']).collect(),
        None => text.chars().map(printable).collect(),
    }
}
