//! Findings of the reader and of the solver as Python objects.

use percuss::Severity;
use percuss::study::DiagnosticRecord;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use std::collections::BTreeSet;
use std::sync::{Mutex, PoisonError};

/// Severity, code, place (path, line, column, element) and text of a finding.
type Parts = (String, String, (Option<String>, Option<u32>, Option<u32>, Option<String>), String);

/// Rebuilds a pickled finding.
#[pyfunction]
pub fn diagnostic_of_parts(
    severity: &str,
    code: &str,
    place: (Option<String>, Option<u32>, Option<u32>, Option<String>),
    message: String,
) -> PyResult<Diagnostic> {
    let severities = [Severity::Error, Severity::Warning, Severity::Note];
    let found = severities.into_iter().find(|known| known.name() == severity);
    let severity = found.ok_or_else(|| PyValueError::new_err(format!("severity is \"{severity}\"")))?;
    let (path, line, column, element) = place;
    Ok(Diagnostic(DiagnosticRecord { severity, code: shared(code), path, line, column, element, message }))
}

/// The text with the lifetime of the program; each text is kept once.
fn shared(text: &str) -> &'static str {
    static KEPT: Mutex<BTreeSet<&'static str>> = Mutex::new(BTreeSet::new());
    let mut kept = KEPT.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(found) = kept.get(text) {
        return found;
    }
    let found: &'static str = Box::leak(text.into());
    kept.insert(found);
    found
}

/// Finding about a file or about a result.
///
///     >>> [(finding.code, finding.message) for finding in model.diagnostics]
#[pyclass(frozen, module = "percuss.results")]
#[derive(Clone, Debug)]
pub struct Diagnostic(pub DiagnosticRecord);

#[pymethods]
impl Diagnostic {
    /// "error", "warning" or "note".
    #[getter]
    fn severity(&self) -> &'static str {
        self.0.severity.name()
    }

    /// Stable short name, for programs.
    #[getter]
    fn code(&self) -> &'static str {
        self.0.code
    }

    /// The file; None for a finding about a result.
    #[getter]
    fn path(&self) -> Option<&str> {
        self.0.path.as_deref()
    }

    /// Line, from 1.
    #[getter]
    fn line(&self) -> Option<u32> {
        self.0.line
    }

    /// Column, from 1.
    #[getter]
    fn column(&self) -> Option<u32> {
        self.0.column
    }

    /// The element, as an XML path.
    #[getter]
    fn element(&self) -> Option<&str> {
        self.0.element.as_deref()
    }

    /// Text of the finding.
    #[getter]
    fn message(&self) -> &str {
        &self.0.message
    }

    /// Pickles a finding as its parts.
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Parts)> {
        let record = self.0.clone();
        let place = (record.path, record.line, record.column, record.element);
        let parts = (record.severity.name().to_owned(), record.code.to_owned(), place, record.message);
        Ok((py.import("percuss")?.getattr("_diagnostic")?, parts))
    }

    fn __str__(&self) -> String {
        self.0.line()
    }

    fn __repr__(&self) -> String {
        format!("<{}>", self.0.line())
    }
}
