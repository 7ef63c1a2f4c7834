//! Findings of the reader and of the solver as Python objects.

use percuss::study::DiagnosticRecord;
use pyo3::prelude::*;

/// Finding about a file or about a result.
#[pyclass(frozen, module = "percuss")]
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

    fn __str__(&self) -> String {
        self.0.line()
    }

    fn __repr__(&self) -> String {
        format!("<{}>", self.0.line())
    }
}
