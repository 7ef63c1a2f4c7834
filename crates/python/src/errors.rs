//! Errors of the library as exceptions of `percuss._errors`, with the same messages.

use crate::diagnostic::Diagnostic;
use percuss::study::{DesignError, DiagnosticRecord, Names, StudyError, StudyFileError};
use percuss::{AssemblyError, LoadError as Refused, ResponseError, RouteError, TravelError};
use pyo3::prelude::*;
use std::fmt::Display;

pyo3::import_exception!(percuss._errors, InputError);
pyo3::import_exception!(percuss._errors, LoadError);
pyo3::import_exception!(percuss._errors, ModelWarning);
pyo3::import_exception!(percuss._errors, NoAnswerError);
mod named {
    pyo3::import_exception!(percuss._errors, AssemblyError);
}
use named::AssemblyError as LoopsError;

/// Something that was given means nothing.
pub fn input(error: impl Display) -> PyErr {
    InputError::new_err(error.to_string())
}

/// What was asked is fine and has no answer.
pub fn no_answer(error: impl Display) -> PyErr {
    NoAnswerError::new_err(error.to_string())
}

/// Loops that do not close, or not there.
pub fn assembly(error: AssemblyError) -> PyErr {
    loops(error)
}

/// The same, in words of this crate.
pub fn loops(error: impl Display) -> PyErr {
    LoopsError::new_err(error.to_string())
}

/// A contact that means nothing, or that no route answers.
pub fn response(error: ResponseError) -> PyErr {
    match error {
        ResponseError::Contact(error) => input(error),
        ResponseError::Route(error) => route(error),
        other => no_answer(other),
    }
}

/// A route that declines.
pub fn route(error: RouteError) -> PyErr {
    match error {
        RouteError::ForeignLink { .. }
        | RouteError::ForeignAccelerations { .. }
        | RouteError::Velocities(_)
        | RouteError::Bound { .. } => input(error),
        other => no_answer(other),
    }
}

/// A travel that means nothing, or that the mechanism does not make.
pub fn travel(error: TravelError) -> PyErr {
    match error {
        TravelError::Assembly(error) => assembly(error),
        TravelError::NothingMoves { .. } | TravelError::Unreachable { .. } | TravelError::TooFar { .. } => {
            no_answer(error)
        }
        other => input(other),
    }
}

/// A file that cannot be read: every error of it in the message, everything that was found as objects.
pub fn load(error: Refused) -> PyErr {
    let records: Vec<DiagnosticRecord> = error.diagnostics.into_iter().map(Into::into).collect();
    let of_errors: Vec<String> =
        records.iter().filter(|record| record.severity == "error").map(DiagnosticRecord::line).collect();
    let found: Vec<Diagnostic> = records.into_iter().map(Diagnostic).collect();
    LoadError::new_err((of_errors.join("\n"), found))
}

/// A question of the command line's kind.
pub fn study(error: StudyError) -> PyErr {
    let message = error.message(Names::Fields);
    match error {
        StudyError::Assembly(_) => LoopsError::new_err(message),
        error if error.is_no_answer() => no_answer(message),
        _ => input(message),
    }
}

/// A change of a model that cannot be had.
pub fn design(error: DesignError) -> PyErr {
    match error {
        DesignError::Load(error) => load(error),
        DesignError::Change(error) => study(error),
        other => input(other),
    }
}

/// A study that cannot be run.
pub fn study_file(error: StudyFileError) -> PyErr {
    match error {
        StudyFileError::Load(error) => load(error),
        other => input(other),
    }
}

/// Warns of what was found in a file; notes stand among the model's diagnostics.
pub fn warn(py: Python<'_>, found: &[DiagnosticRecord]) -> PyResult<()> {
    let category = py.get_type::<ModelWarning>();
    for record in found.iter().filter(|record| record.severity == "warning") {
        let text = std::ffi::CString::new(record.line().replace('\0', "\u{fffd}"))?;
        PyErr::warn(py, &category, &text, 1)?;
    }
    Ok(())
}
