//! Numbers of the caller's: what is no array of float64 is made one, or refused with what it is and what is expected.

use crate::errors::input;
use crate::labels::{AXES, Labels, reordered};
use numpy::{
    PyArray1, PyArray2, PyArrayDyn, PyArrayMethods, PyReadonlyArray2, PyReadonlyArrayDyn, PyUntypedArray,
    PyUntypedArrayMethods,
};
use percuss::nalgebra::DMatrix;
use pyo3::PyTypeInfo;
use pyo3::prelude::*;
use pyo3::types::{PyAny, PyString};

/// Numbers of the caller.
pub struct Numbers<'py> {
    pub array: PyReadonlyArrayDyn<'py, f64>,
    /// Relative error of each by the type in which they were held: a rounding of single or half precision, 0 for whole numbers.
    pub accuracy: f64,
    pub labels: Labels,
}

impl<'py> Numbers<'py> {
    /// An array of float64 of one of some numbers of dimensions, read where it lies if it is one already. Sparse matrices become
    /// dense.
    pub fn of(value: &Bound<'py, PyAny>, what: &str, dimensions: &[usize], expected: &str) -> PyResult<Self> {
        refuse_hidden(value, what)?;
        let labels = Labels::of(value, what)?;
        let (found, accuracy) = match value.cast::<PyArrayDyn<f64>>() {
            Ok(array) => (array.clone(), f64::EPSILON),
            Err(_) => converted(value, what)?,
        };
        if !dimensions.contains(&found.ndim()) {
            return Err(input(format_args!(
                "{what} has shape {}; expected {expected}",
                shape(found.shape())
            )));
        }
        let array = found.try_readonly().map_err(|error| input(format_args!("{what}: {error}")))?;
        Ok(Self { array, accuracy, labels })
    }

    /// With the last axis in the order of these names, where it has labels.
    pub fn in_order<S: AsRef<str>>(self, what: &str, names: &[S], hint: &str) -> PyResult<Self> {
        let Some(order) = self.labels.order(what, names, hint)? else { return Ok(self) };
        let found = reordered(&self.array.as_any().cast::<PyArrayDyn<f64>>()?.clone(), Some(order))?;
        let array = found.try_readonly().map_err(|error| input(format_args!("{what}: {error}")))?;
        Ok(Self { array, ..self })
    }
}

/// The same for numbers that have no names.
pub fn float64<'py>(
    value: &Bound<'py, PyAny>,
    what: &str,
    dimensions: &[usize],
    expected: &str,
) -> PyResult<PyReadonlyArrayDyn<'py, f64>> {
    let found = Numbers::of(value, what, dimensions, expected)?;
    found.labels.refuse(what)?;
    Ok(found.array)
}

/// The same with two dimensions, and with names of the columns.
pub fn float64_matrix<'py, S: AsRef<str>>(
    value: &Bound<'py, PyAny>,
    what: &str,
    expected: &str,
    names: &[S],
    hint: &str,
) -> PyResult<PyReadonlyArray2<'py, f64>> {
    let found = Numbers::of(value, what, &[2], expected)?.in_order(what, names, hint)?;
    let found = found.array.cast::<PyArray2<f64>>()?.clone();
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

/// Relative error of numbers by the name of their type; 0 where they are exact.
fn accuracy_of_type(name: &str) -> f64 {
    let name = name.to_ascii_lowercase();
    let ends = |type_: &str| name.ends_with(type_);
    if ends("float16") {
        0.5f64.powi(11)
    } else if ends("float32") {
        0.5f64.powi(24)
    } else if name.contains("float") {
        f64::EPSILON
    } else {
        0.0
    }
}

/// As an array of float64, with the relative error of the type in which the numbers were held.
fn converted<'py>(value: &Bound<'py, PyAny>, what: &str) -> PyResult<(Bound<'py, PyArrayDyn<f64>>, f64)> {
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
    let mut accuracy = accuracy_of_type(&dtype.getattr("name")?.extract::<String>()?);
    // Columns of a table have types of their own, of which the array has the widest.
    if let Some(types) = value.getattr_opt("dtypes")?
        && let Ok(types) = types.try_iter()
    {
        for column in types {
            accuracy = accuracy.max(accuracy_of_type(&column?.str()?.to_string()));
        }
    }
    let array = array.call_method1("astype", ("float64",))?;
    Ok((array.cast_into::<PyArrayDyn<f64>>()?, accuracy))
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

/// Three components, by the names x, y, z where they have names; finite.
pub fn triple(value: &Bound<'_, PyAny>, what: &str) -> PyResult<[f64; 3]> {
    let found = Numbers::of(value, what, &[1], "(3,)")?.in_order(what, &AXES, "")?;
    let found: Vec<f64> = found.array.as_array().iter().copied().collect();
    let found = <[f64; 3]>::try_from(found)
        .map_err(|found| input(format_args!("{what} has {} numbers; expected 3", found.len())))?;
    match found.iter().find(|x| !x.is_finite()) {
        Some(bad) => Err(input(format_args!("{what} has {bad}; expected finite numbers"))),
        None => Ok(found),
    }
}

/// A matrix to Python, row by row.
pub fn matrix<'py>(py: Python<'py>, matrix: &DMatrix<f64>) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let rows: Vec<f64> = matrix.transpose().as_slice().to_vec();
    PyArray1::from_vec(py, rows).reshape([matrix.nrows(), matrix.ncols()])
}
