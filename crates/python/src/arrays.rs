//! Numbers of the caller's: what is no array of float64 is made one, or refused with what it is and what is expected.

use crate::errors::input;
use numpy::{
    PyArray1, PyArray2, PyArrayDyn, PyArrayMethods, PyReadonlyArray2, PyReadonlyArrayDyn, PyUntypedArray,
    PyUntypedArrayMethods,
};
use percuss::nalgebra::DMatrix;
use pyo3::PyTypeInfo;
use pyo3::prelude::*;
use pyo3::types::{PyAny, PyString};

/// An array of float64 of so many dimensions, where it lies if it is one already. Sparse matrices become dense.
pub fn float64<'py>(
    value: &Bound<'py, PyAny>,
    what: &str,
    dimensions: &[usize],
    expected: &str,
) -> PyResult<PyReadonlyArrayDyn<'py, f64>> {
    refuse_hidden(value, what)?;
    let found = match value.cast::<PyArrayDyn<f64>>() {
        Ok(array) => array.clone(),
        Err(_) => converted(value, what)?,
    };
    if !dimensions.contains(&found.ndim()) {
        return Err(input(format_args!("{what} has shape {}; expected {expected}", shape(found.shape()))));
    }
    found.try_readonly().map_err(|error| input(format_args!("{what}: {error}")))
}

/// The same with two dimensions.
pub fn float64_matrix<'py>(
    value: &Bound<'py, PyAny>,
    what: &str,
    expected: &str,
) -> PyResult<PyReadonlyArray2<'py, f64>> {
    let found = float64(value, what, &[2], expected)?;
    let found = found.cast::<PyArray2<f64>>()?.clone();
    found.try_readonly().map_err(|error| input(format_args!("{what}: {error}")))
}

/// Refuses entries that a mask hides: as plain numbers they would count.
fn refuse_hidden(value: &Bound<'_, PyAny>, what: &str) -> PyResult<()> {
    let py = value.py();
    if value.get_type().is(PyUntypedArray::type_object(py)) || !value.hasattr("mask")? {
        return Ok(());
    }
    match py.import("numpy")?.getattr("ma")?.call_method1("is_masked", (value,))?.is_truthy()? {
        true => Err(input(format_args!("{what} has masked entries; fill them or leave their rows away"))),
        false => Ok(()),
    }
}

fn converted<'py>(value: &Bound<'py, PyAny>, what: &str) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    let py = value.py();
    if value.is_instance_of::<PyString>() {
        let text = value.repr()?;
        return Err(input(format_args!("{what} is the text {text}; expected numbers, in SI (m, rad)")));
    }
    let numpy = py.import("numpy")?;
    let dense = if value.hasattr("toarray")? { value.call_method0("toarray")? } else { value.clone() };
    // Rows of different lengths.
    let array = numpy
        .call_method1("asarray", (dense,))
        .map_err(|error| input(format_args!("{what} is no array of numbers: {}", error.value(py))))?;
    let dtype = array.getattr("dtype")?;
    let kind: String = dtype.getattr("kind")?.extract()?;
    if !matches!(kind.as_str(), "f" | "i" | "u") {
        let name: String = dtype.getattr("name")?.extract()?;
        return Err(input(format_args!("{what} has dtype {name}; expected real numbers (float64)")));
    }
    let array = array.call_method1("astype", ("float64",))?;
    Ok(array.cast_into::<PyArrayDyn<f64>>()?)
}

/// As numpy writes it.
pub fn shape(lengths: &[usize]) -> String {
    match lengths {
        [one] => format!("({one},)"),
        _ => format!("({})", lengths.iter().map(usize::to_string).collect::<Vec<_>>().join(", ")),
    }
}

/// A list of numbers: a number, a sequence, an array of one dimension.
pub fn list(value: &Bound<'_, PyAny>, what: &str) -> PyResult<Vec<f64>> {
    if let Ok(number) = value.extract::<f64>() {
        return Ok(vec![number]);
    }
    let array = float64(value, what, &[0, 1], "a number, or a list of numbers")?;
    Ok(array.as_array().iter().copied().collect())
}

/// Three numbers.
pub fn triple(value: &Bound<'_, PyAny>, what: &str) -> PyResult<[f64; 3]> {
    let found = list(value, what)?;
    <[f64; 3]>::try_from(found)
        .map_err(|found| input(format_args!("{what} has {} numbers; expected 3", found.len())))
}

/// A matrix to Python, row by row.
pub fn matrix<'py>(py: Python<'py>, matrix: &DMatrix<f64>) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let rows: Vec<f64> = matrix.transpose().as_slice().to_vec();
    PyArray1::from_vec(py, rows).reshape([matrix.nrows(), matrix.ncols()])
}
