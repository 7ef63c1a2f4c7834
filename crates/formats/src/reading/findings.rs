//! Findings about the elements of a model, with their positions in the main file and in the included files.

use crate::Diagnostic;
use crate::reading::document::element_tree::{ElementId, ElementTree};
use crate::reading::limits::{LONGEST_COMPARED_NAME, MAX_CANDIDATES};
use crate::reading::report::{NOT_READ, Place, Report, finish_reports, shortened};
use percuss_mechanism::{Severity, near_names};

/// Collected findings, bounded in number.
pub(crate) struct Findings<'t> {
    pub tree: &'t ElementTree,
    /// One report for each file of the tree.
    reports: Vec<Report>,
}

impl<'t> Findings<'t> {
    /// Continues the reports of the files of a tree.
    pub fn new(tree: &'t ElementTree, reports: Vec<Report>) -> Self {
        Self { tree, reports }
    }

    /// Adds a finding about an element.
    pub fn add(
        &mut self,
        severity: Severity,
        code: &'static str,
        element: ElementId,
        message: impl FnOnce() -> String,
    ) {
        let (file, offset) = (self.tree.element(element).file, self.tree.element(element).offset);
        let path = self.path(element);
        self.reports[file].add(severity, code, Place::Named(offset, &path), message);
    }

    /// Adds an error about an element.
    pub fn error(&mut self, code: &'static str, element: ElementId, message: impl FnOnce() -> String) {
        self.add(Severity::Error, code, element, message);
    }

    /// Adds a warning about an element.
    pub fn warning(&mut self, code: &'static str, element: ElementId, message: impl FnOnce() -> String) {
        self.add(Severity::Warning, code, element, message);
    }

    /// Adds a note about an element.
    pub fn note(&mut self, code: &'static str, element: ElementId, message: impl FnOnce() -> String) {
        self.add(Severity::Note, code, element, message);
    }

    /// Adds an error about an attribute of an element.
    pub fn attribute_error(
        &mut self,
        code: &'static str,
        element: ElementId,
        attribute: &str,
        message: impl FnOnce() -> String,
    ) {
        let (file, offset) =
            (self.tree.element(element).file, self.tree.attribute_offset(element, attribute));
        let path = self.path(element);
        self.reports[file].error(code, Place::Named(offset, &path), message);
    }

    /// Adds a finding once per code and `kind`; repetitions are counted.
    pub fn add_once(
        &mut self,
        severity: Severity,
        code: &'static str,
        kind: &str,
        element: ElementId,
        message: impl FnOnce() -> String,
    ) {
        let (file, offset) = (self.tree.element(element).file, self.tree.element(element).offset);
        let path = self.path(element);
        self.reports[file].add_once(severity, code, kind.to_owned(), Place::Named(offset, &path), message);
    }

    /// Adds a note about a part of the file that is no part of a mechanism, once per `kind`.
    pub fn add_unread(&mut self, element: ElementId, kind: impl FnOnce() -> String) {
        let kind = kind();
        self.add_once(Severity::Note, NOT_READ, &kind, element, || kind.clone());
    }

    /// Reports of the files.
    pub fn into_reports(self) -> Vec<Report> {
        self.reports
    }

    /// True if a finding is an error.
    pub fn has_errors(&self) -> bool {
        self.reports.iter().any(Report::has_errors)
    }

    /// Diagnostics of all files: those of the main file first.
    pub fn finish(self) -> Vec<Diagnostic> {
        let files = self.reports.into_iter().zip(&self.tree.files);
        finish_reports(files.map(|(report, file)| (report, &*file.name, &*file.text)))
    }

    /// XML path of an element: `mujoco/worldbody/body[arm]/joint`.
    fn path(&self, element: ElementId) -> String {
        let mut steps = Vec::new();
        let mut current = Some(element);
        while let Some(id) = current {
            let element = self.tree.element(id);
            let tag = shortened(&element.tag);
            steps.push(match self.tree.attribute(id, "name") {
                Some(name) if element.parent.is_some() => format!("{tag}[{}]", shortened(name)),
                _ => tag,
            });
            current = element.parent;
        }
        steps.reverse();
        steps.join("/")
    }
}

/// ` (did you mean "…"?)` with the most similar of the first names; empty if none is similar. The comparison is quadratic in the
/// length of the names, so long names are left out.
pub(crate) fn similar_name<'n>(name: &str, names: impl Iterator<Item = &'n str>) -> String {
    if name.len() > LONGEST_COMPARED_NAME {
        return String::new();
    }
    let candidates = names.take(MAX_CANDIDATES).filter(|known| known.len() <= LONGEST_COMPARED_NAME);
    did_you_mean(&near_names(name, candidates))
}

/// ` (did you mean "…"?)` with the first name; empty without names.
pub(crate) fn did_you_mean(near: &[String]) -> String {
    near.first().map(|near| format!(" (did you mean \"{near}\"?)")).unwrap_or_default()
}
