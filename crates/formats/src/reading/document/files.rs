//! Main file and included files of a model, joined to one tree.

use crate::reading::document::element_tree::{ElementTree, FileText};
use crate::reading::limits::{MAX_ELEMENT_DEPTH, MAX_ELEMENTS, MAX_INCLUDED_BYTES};
use crate::reading::report::{Place, Report};
use crate::reading::tolerance::tolerant_text;
use crate::{SharedFiles, Source};
use percuss_mechanism::Severity;
use std::path::{Path, PathBuf};

/// Tree of a model with one report per file.
pub(crate) struct Files {
    pub tree: ElementTree,
    pub reports: Vec<Report>,
    store: SharedFiles,
    /// Total size of all files, bytes.
    bytes: u64,
}

impl Files {
    /// Starts with the main file (`text`, named `name`), whose elements are appended later.
    pub fn new(store: &SharedFiles, name: &str, text: &str, report: Report) -> Self {
        let file = FileText { name: name.to_owned(), text: text.to_owned(), model: 0 };
        let tree = ElementTree { elements: Vec::new(), files: vec![file] };
        Self { tree, reports: vec![report], store: store.clone(), bytes: text.len() as u64 }
    }

    /// True if a further element at this nesting depth and position exceeds a limit, with an error.
    pub fn is_full(&mut self, file: usize, offset: usize, depth: usize) -> bool {
        let is_full = depth > MAX_ELEMENT_DEPTH || self.tree.elements.len() >= MAX_ELEMENTS;
        if is_full {
            let place = Place::Offset(offset);
            self.reports[file].add_once(Severity::Error, "too-complex", String::new(), place, || {
                format!(
                    "with all included files, the model has more than {MAX_ELEMENTS} elements, or elements nested \
                     deeper than {MAX_ELEMENT_DEPTH} levels"
                )
            });
        }
        is_full
    }

    /// Canonical path of a file; the path itself if there is none.
    pub fn canonical(&self, path: &Path) -> PathBuf {
        self.store.canonical(path).unwrap_or_else(|_| path.to_owned())
    }

    /// Reads a further file and returns its number; its report has an error if the file is no text. The error of the function is the
    /// reason why the file cannot be read.
    pub fn open(&mut self, path: &Path, model: usize) -> Result<usize, String> {
        let left = MAX_INCLUDED_BYTES.saturating_sub(self.bytes);
        let source = Source::read_from(&self.store, &path.to_string_lossy(), left)
            .map_err(|error| error.diagnostics.into_iter().next().map(|d| d.message).unwrap_or_default())?;
        self.bytes += source.bytes.len() as u64;
        let mut report = Report::default();
        let text = source.text(&mut report).map(|text| tolerant_text(&text, &mut report).into_owned());
        self.tree.files.push(FileText { name: source.name, text: text.unwrap_or_default(), model });
        self.reports.push(report);
        Ok(self.reports.len() - 1)
    }
}
