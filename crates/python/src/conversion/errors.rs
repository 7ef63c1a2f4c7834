//! Errors of the library as exceptions of `percuss.errors`, with the same messages.

use crate::conversion::diagnostic::Diagnostic;
use percuss::study::{
    AskError, DesignError, DiagnosticRecord, KinematicsError, Names, StudyError, StudyFileError,
};
use percuss::{AssemblyError, LoadError as Refused, ResponseError, RouteError, Severity, TravelError};
use pyo3::exceptions::{PyOverflowError, PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyAny;
use std::fmt::Display;

pyo3::import_exception!(percuss.errors, ArgumentTypeError);
pyo3::import_exception!(percuss.errors, InputError);
pyo3::import_exception!(percuss.errors, LoadError);
pyo3::import_exception!(percuss.errors, ModelWarning);
pyo3::import_exception!(percuss.errors, NoAnswerError);
pyo3::import_exception!(percuss.errors, NotComputedError);
mod named {
    pyo3::import_exception!(percuss.errors, AssemblyError);
}
use named::AssemblyError as LoopsError;

/// `InputError`: an invalid argument.
pub fn input(error: impl Display) -> PyErr {
    InputError::new_err(error.to_string())
}

/// `ArgumentTypeError`: an argument of a wrong type.
pub fn argument_type(error: impl Display) -> PyErr {
    ArgumentTypeError::new_err(error.to_string())
}

/// `NotComputedError`: an attribute that was not requested.
pub fn not_computed(error: impl Display) -> PyErr {
    NotComputedError::new_err(error.to_string())
}

/// Conversion for `map_err`: puts the name of the argument before the message, unless the message starts with it. An `InputError` keeps its
/// type; other type, value and overflow errors become `ArgumentTypeError`. `LoadError`, `NoAnswerError`, `NotComputedError` and all others stay as they are.
pub fn of_argument(name: &str) -> impl Fn(PyErr) -> PyErr {
    move |error| {
        Python::attach(|py| {
            let message = error.value(py).to_string();
            let message = match message.starts_with(name) {
                true => message,
                false => format!("{name}: {message}"),
            };
            if error.is_instance_of::<LoadError>(py)
                || error.is_instance_of::<NoAnswerError>(py)
                || error.is_instance_of::<NotComputedError>(py)
            {
                error
            } else if error.get_type(py).is(py.get_type::<InputError>()) {
                input(message)
            } else if error.is_instance_of::<PyTypeError>(py)
                || error.is_instance_of::<PyValueError>(py)
                || error.is_instance_of::<PyOverflowError>(py)
            {
                argument_type(message)
            } else {
                error
            }
        })
    }
}

/// Converts an argument of a constructor.
///
/// # Errors
/// The error of the conversion by [`of_argument`], usually `ArgumentTypeError`.
pub fn extract<'a, 'py, T: FromPyObject<'a, 'py>>(given: &'a Bound<'py, PyAny>, name: &str) -> PyResult<T> {
    given.extract().map_err(|error: T::Error| of_argument(name)(error.into()))
}

/// `NoAnswerError`: a valid question without an answer.
pub fn no_answer(error: impl Display) -> PyErr {
    NoAnswerError::new_err(error.to_string())
}

/// `AssemblyError`: loops that do not close, or that do not close at the requested configuration.
pub fn assembly(error: AssemblyError) -> PyErr {
    loops(error)
}

/// `AssemblyError` with a message of this crate.
pub fn loops(error: impl Display) -> PyErr {
    LoopsError::new_err(error.to_string())
}

/// Error of a response: an invalid contact, or a contact that no route solves.
pub fn response(error: ResponseError) -> PyErr {
    match error {
        ResponseError::Contact(error) => input(error),
        ResponseError::Route(error) => route(error),
        other => no_answer(other),
    }
}

/// Error of a route.
pub fn route(error: RouteError) -> PyErr {
    match error {
        RouteError::ForeignLink { .. }
        | RouteError::ForeignAccelerations { .. }
        | RouteError::Velocities(_)
        | RouteError::Bound { .. } => input(error),
        other => no_answer(other),
    }
}

/// Error of a travel: invalid arguments, or a displacement that the mechanism cannot make.
pub fn travel(error: TravelError) -> PyErr {
    match error {
        TravelError::Assembly(error) => assembly(error),
        TravelError::NothingMoves { .. } | TravelError::Unreachable { .. } | TravelError::TooFar { .. } => {
            no_answer(error)
        }
        other => input(other),
    }
}

/// `LoadError` for an unreadable file: the message lists every error; the second argument lists all findings as
/// objects.
pub fn load(error: Refused) -> PyErr {
    let records: Vec<DiagnosticRecord> = error.diagnostics.into_iter().map(Into::into).collect();
    let of_errors: Vec<String> = records
        .iter()
        .filter(|record| record.severity == Severity::Error)
        .map(DiagnosticRecord::line)
        .collect();
    let found: Vec<Diagnostic> = records.into_iter().map(Diagnostic).collect();
    LoadError::new_err((of_errors.join("\n"), found))
}

/// Error of a study function, also used by the command line.
pub fn study(error: StudyError) -> PyErr {
    let message = error.message(Names::Fields);
    match error.without_table() {
        StudyError::Assembly(_) => LoopsError::new_err(message),
        error if error.has_no_result() => no_answer(message),
        _ => input(message),
    }
}

/// Error of a question about kinematics.
pub fn kinematics(error: KinematicsError) -> PyErr {
    match error {
        KinematicsError::Study(error) => study(error),
        error => input(error),
    }
}

/// Error of a table of a study.
pub fn ask(error: AskError) -> PyErr {
    match error {
        AskError::Question(error) => study(error),
        AskError::Kinematics(error) => kinematics(error),
        error if error.has_no_result() => no_answer(error.message()),
        error => input(error.message()),
    }
}

/// Error of a design change.
pub fn design(error: DesignError) -> PyErr {
    match error {
        DesignError::Load(error) => load(error),
        DesignError::Change(error) => study(error),
        other => input(other),
    }
}

/// Error of a study file.
pub fn study_file(error: StudyFileError) -> PyErr {
    match error {
        StudyFileError::Load(error) => load(error),
        other => input(other),
    }
}

/// Issues a `ModelWarning` for each warning of a file. Stack level 2 is the line of the user's call: the functions that read files are
/// wrapped by `percuss._arguments.converted`. Notes are only in the model's diagnostics.
pub fn warn(py: Python<'_>, found: &[DiagnosticRecord]) -> PyResult<()> {
    let category = py.get_type::<ModelWarning>();
    for record in found.iter().filter(|record| record.severity == Severity::Warning) {
        let text = std::ffi::CString::new(record.line().replace('\0', "\u{fffd}"))?;
        PyErr::warn(py, &category, &text, 2)?;
    }
    Ok(())
}
