//! Pickling: an object is rebuilt by a call of a method with the same arguments.

use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

/// Function that rebuilds an object, and its arguments: owner, method, positional arguments, keyword arguments.
pub type Rebuilt<'py> =
    (Bound<'py, PyAny>, (Bound<'py, PyAny>, &'static str, Bound<'py, PyTuple>, Bound<'py, PyDict>));

/// Description of an object for pickle: the result of `owner.method(*arguments, **keywords)`.
pub fn result_of<'py, A>(
    owner: Bound<'py, PyAny>,
    method: &'static str,
    arguments: A,
    keywords: &[(&str, Bound<'py, PyAny>)],
) -> PyResult<Rebuilt<'py>>
where
    A: IntoPyObject<'py, Target = PyTuple, Output = Bound<'py, PyTuple>>,
    PyErr: From<A::Error>,
{
    let py = owner.py();
    let given = PyDict::new(py);
    for (name, value) in keywords {
        given.set_item(name, value)?;
    }
    Ok((py.import("percuss")?.getattr("_result_of")?, (owner, method, arguments.into_pyobject(py)?, given)))
}
