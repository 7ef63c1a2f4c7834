//! Conversion of the caller's numbers to float64 arrays. A value that cannot be converted is refused; the message names
//! the value and the expected type.

use crate::conversion::errors::input;
use crate::conversion::labels::{AXES, Labels, permute_last_axis};
use numpy::{
    PyArray1, PyArray2, PyArrayDyn, PyArrayMethods, PyReadonlyArray2, PyReadonlyArrayDyn, PyUntypedArray,
    PyUntypedArrayMethods,
};
use percuss::nalgebra::DMatrix;
use pyo3::PyTypeInfo;
use pyo3::prelude::*;
use pyo3::types::{PyAny, PyString};

/// Array of the caller, with accuracy and labels.
pub struct Numbers<'py> {
    pub array: PyReadonlyArrayDyn<'py, f64>,
    /// Relative error of the entries, from their original type: the rounding of single or half precision; 0 for
    /// integers.
    pub accuracy: f64,
    pub labels: Labels,
}

impl<'py> Numbers<'py> {
    /// Copy of an array as float64, with a permitted number of dimensions; sparse matrices become dense. Calls release the interpreter: other
    /// threads, and the callbacks of a call, may change the array of the caller.
    pub fn of(value: &Bound<'py, PyAny>, what: &str, dimensions: &[usize], expected: &str) -> PyResult<Self> {
        refuse_masked(value, what)?;
        let labels = Labels::of(value, what)?;
        let (found, accuracy) = match value.cast::<PyArrayDyn<f64>>() {
            Ok(array) => {
                let own = array.try_readonly().map_err(|error| input(format_args!("{what}: {error}")))?;
                (PyArrayDyn::from_owned_array(value.py(), own.as_array().to_owned()), f64::EPSILON)
            }
            Err(_) => to_float64(value, what)?,
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

    /// Reorders the last axis by the given names if the value has labels.
    pub fn in_order_of<S: AsRef<str>>(self, what: &str, names: &[S], hint: &str) -> PyResult<Self> {
        let Some(order) = self.labels.order(what, names, hint)? else { return Ok(self) };
        let found = permute_last_axis(&self.array.as_any().cast::<PyArrayDyn<f64>>()?.clone(), Some(order))?;
        let array = found.try_readonly().map_err(|error| input(format_args!("{what}: {error}")))?;
        Ok(Self { array, ..self })
    }
}

/// Like [`Numbers::of`], for values whose entries have no names: labels are refused.
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

/// Like [`Numbers::of`], for matrices whose columns have the given names: labelled columns are matched by name and reordered.
pub fn float64_matrix<'py, S: AsRef<str>>(
    value: &Bound<'py, PyAny>,
    what: &str,
    expected: &str,
    names: &[S],
    hint: &str,
) -> PyResult<PyReadonlyArray2<'py, f64>> {
    let found = Numbers::of(value, what, &[2], expected)?.in_order_of(what, names, hint)?;
    let found = found.array.cast::<PyArray2<f64>>()?.clone();
    found.try_readonly().map_err(|error| input(format_args!("{what}: {error}")))
}

/// Refuses arrays with masked entries: as plain numbers they would count.
fn refuse_masked(value: &Bound<'_, PyAny>, what: &str) -> PyResult<()> {
    let py = value.py();
    if value.get_type().is(PyUntypedArray::type_object(py)) || !value.hasattr("mask")? {
        return Ok(());
    }
    match py.import("numpy")?.getattr("ma")?.call_method1("is_masked", (value,))?.is_truthy()? {
        true => Err(input(format_args!("{what} has masked entries; fill them or leave their rows away"))),
        false => Ok(()),
    }
}

/// Relative error of numbers from the name of their type; 0 for exact types.
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

/// Converts to an array of float64 and returns the relative error of the original type.
fn to_float64<'py>(value: &Bound<'py, PyAny>, what: &str) -> PyResult<(Bound<'py, PyArrayDyn<f64>>, f64)> {
    let py = value.py();
    if value.is_instance_of::<PyString>() {
        let text = value.repr()?;
        return Err(input(format_args!("{what} is the text {text}; expected numbers, in SI (m, rad)")));
    }
    let numpy = py.import("numpy")?;
    let dense = if value.hasattr("toarray")? { value.call_method0("toarray")? } else { value.clone() };
    // Fails for rows of different lengths.
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
    // Each column of a table has its own type; the array has the widest type of all columns.
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

/// Shape in the notation of numpy.
pub fn shape(lengths: &[usize]) -> String {
    match lengths {
        [one] => format!("({one},)"),
        _ => format!("({})", lengths.iter().map(usize::to_string).collect::<Vec<_>>().join(", ")),
    }
}

/// Accepts a number, a sequence or an array of one dimension.
pub fn list(value: &Bound<'_, PyAny>, what: &str) -> PyResult<Vec<f64>> {
    if let Ok(number) = value.extract::<f64>() {
        return Ok(vec![number]);
    }
    let array = float64(value, what, &[0, 1], "a number, or a list of numbers")?;
    Ok(array.as_array().iter().copied().collect())
}

/// Three finite components, matched by the names x, y, z if the value has labels.
pub fn triple(value: &Bound<'_, PyAny>, what: &str) -> PyResult<[f64; 3]> {
    let found = Numbers::of(value, what, &[1], "(3,)")?.in_order_of(what, &AXES, "")?;
    let found: Vec<f64> = found.array.as_array().iter().copied().collect();
    let found = <[f64; 3]>::try_from(found)
        .map_err(|found| input(format_args!("{what} has {} numbers; expected 3", found.len())))?;
    match found.iter().find(|x| !x.is_finite()) {
        Some(bad) => Err(input(format_args!("{what} has {bad}; expected finite numbers"))),
        None => Ok(found),
    }
}

/// Matrix as a numpy array, row by row.
pub fn matrix<'py>(py: Python<'py>, matrix: &DMatrix<f64>) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let rows: Vec<f64> = matrix.transpose().as_slice().to_vec();
    PyArray1::from_vec(py, rows).reshape([matrix.nrows(), matrix.ncols()])
}
