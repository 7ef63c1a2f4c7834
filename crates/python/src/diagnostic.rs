//! What was noticed in a file, as an object.

use percuss::study::DiagnosticRecord;
use pyo3::prelude::*;

/// Something that was noticed in a file, or about an answer.
#[pyclass(frozen, module = "percuss")]
#[derive(Clone, Debug)]
pub struct Diagnostic(pub DiagnosticRecord);

#[pymethods]
impl Diagnostic {
    /// "error", "warning" or "note".
    #[getter]
    fn severity(&self) -> &'static str {
        self.0.severity
    }

    /// A short name that programs can rely on.
    #[getter]
    fn code(&self) -> &'static str {
        self.0.code
    }

    /// The file; None for a finding about an answer.
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

    /// What is the matter.
    #[getter]
    fn message(&self) -> &str {
        &self.0.message
    }

    fn __str__(&self) -> String {
        self.0.line()
    }

    fn __repr__(&self) -> String {
        format!("<{}>", self.0.line())
    }
}
