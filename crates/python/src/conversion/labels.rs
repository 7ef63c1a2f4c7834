//! Labels of tables and series (pandas, polars, xarray): entries are matched by name, or refused.

use crate::conversion::errors::input;
use numpy::{PyArrayDyn, PyArrayMethods, PyUntypedArray, PyUntypedArrayMethods};
use pyo3::PyTypeInfo;
use pyo3::prelude::*;
use pyo3::types::{PyAny, PyDict, PyList, PySlice, PyString, PyTuple};

/// Names of the three components of a point or a vector.
pub const AXES: [&str; 3] = ["x", "y", "z"];

/// Names along an axis; `None` if entries are only numbered from 0.
type Names = Option<Vec<String>>;

/// Labels of a table (its rows and its columns) or of a series (its entries, as columns).
#[derive(Debug, Default, PartialEq)]
pub struct Labels {
    pub rows: Names,
    pub columns: Names,
}

impl Labels {
    /// Reads the labels of a value. Arrays, lists and numbers have none.
    pub fn of(value: &Bound<'_, PyAny>, what: &str) -> PyResult<Self> {
        let py = value.py();
        let is_plain = value.get_type().is(PyUntypedArray::type_object(py))
            || value.is_instance_of::<PyList>()
            || value.is_instance_of::<PyTuple>()
            || value.is_instance_of::<PyString>()
            || value.is_instance_of::<PyDict>()
            || value.is_instance_of::<PySlice>();
        if is_plain {
            return Ok(Self::default());
        }
        if value.hasattr("dims")? && value.hasattr("to_pandas")? {
            // xarray; pandas has no form for more than two dimensions.
            let is_table = value.getattr("ndim")?.extract::<usize>().is_ok_and(|axes| axes == 1 || axes == 2);
            return match is_table {
                true => Self::of(&value.call_method0("to_pandas")?, what),
                false => Ok(Self::default()),
            };
        }
        let along = |axis: &str| -> PyResult<Names> {
            match value.getattr_opt(axis)? {
                Some(labels) if !labels.is_callable() => names(&labels, what),
                _ => Ok(None),
            }
        };
        // Tables of pandas and polars have `columns`; tables of Arrow have `column_names`.
        for columns in ["columns", "column_names"] {
            if value.hasattr(columns)? {
                return Ok(Self { rows: along("index")?, columns: along(columns)? });
            }
        }
        let is_series = value.hasattr("iloc")?;
        Ok(Self { rows: None, columns: if is_series { along("index")? } else { None } })
    }

    /// Labels of the rows of a table, as its `index`; `None` for other values.
    pub fn index_of(table: &Bound<'_, PyAny>) -> PyResult<Option<Py<PyAny>>> {
        match table.hasattr("columns")? {
            true => Ok(table.getattr_opt("index")?.filter(|index| !index.is_callable()).map(Bound::unbind)),
            false => Ok(None),
        }
    }

    /// Refuses labels for unnamed quantities: their order would be ignored.
    pub fn refuse(&self, what: &str) -> PyResult<()> {
        match &self.columns {
            None => Ok(()),
            Some(names) => Err(input(format_args!(
                "{what} has the labels {}, which have no meaning here; expected numbers without labels: .to_numpy() gives \
                 them in their order",
                list_names(names)
            ))),
        }
    }

    /// Column number of each expected name; `None` if the columns have no labels or are in order already. `hint` is
    /// appended to the message if the names differ.
    pub fn order<S: AsRef<str>>(
        &self,
        what: &str,
        expected: &[S],
        hint: &str,
    ) -> PyResult<Option<Vec<usize>>> {
        let Some(names) = &self.columns else { return Ok(None) };
        if let Some(twice) = names.iter().enumerate().find(|(n, name)| names[..*n].contains(name)) {
            return Err(input(format_args!("{what} has the label \"{}\" twice", twice.1)));
        }
        let index_of = |name: &S| names.iter().position(|found| found == name.as_ref());
        let order: Option<Vec<usize>> = expected.iter().map(index_of).collect();
        match order.filter(|order| order.len() == names.len()) {
            None => Err(input(format_args!(
                "{what} has the labels {}; expected {}, in any order{hint}",
                list_names(names),
                list_names(expected)
            ))),
            Some(order) if order.iter().copied().eq(0..order.len()) => Ok(None),
            Some(order) => Ok(Some(order)),
        }
    }
}

/// The labels of an axis as names; `None` if they are 0, 1, 2, …
fn names(labels: &Bound<'_, PyAny>, what: &str) -> PyResult<Names> {
    let all: Vec<Bound<'_, PyAny>> = labels.try_iter()?.collect::<PyResult<_>>()?;
    let is_number = |(n, label): (usize, &Bound<'_, PyAny>)| {
        !label.is_instance_of::<PyString>() && label.extract::<usize>().is_ok_and(|found| found == n)
    };
    if all.iter().enumerate().all(is_number) {
        return Ok(None);
    }
    let name = |label: &Bound<'_, PyAny>| match label.cast::<PyString>() {
        Ok(text) => Ok(text.to_string()),
        Err(_) => Ok(label.repr()?.to_string()),
    };
    let found = all.iter().map(name).collect::<PyResult<Vec<String>>>();
    found.map(Some).map_err(|error: PyErr| input(format_args!("the labels of {what}: {error}")))
}

/// Permutes the last axis of an array.
pub fn permute_last_axis<'py>(
    array: &Bound<'py, PyArrayDyn<f64>>,
    order: Option<Vec<usize>>,
) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    let Some(order) = order else { return Ok(array.clone()) };
    let axis = array.ndim().saturating_sub(1);
    let taken = array.as_any().call_method1("take", (order, axis))?;
    let py = array.py();
    // Gives a scalar for an array without dimensions.
    let taken = py.import("numpy")?.call_method1("asarray", (taken,))?;
    Ok(taken.cast_into::<PyArrayDyn<f64>>()?.to_dyn().clone())
}

/// First eight names, for messages.
fn list_names<S: AsRef<str>>(names: &[S]) -> String {
    let shown: Vec<String> = names.iter().take(8).map(|name| format!("\"{}\"", name.as_ref())).collect();
    let more = names.len().saturating_sub(8);
    let more = if more > 0 { format!(" and {more} more") } else { String::new() };
    format!("{}{more}", shown.join(", "))
}
