//! m̄ from matrices M, j and A of the caller's own solver.

use crate::analysis::response::{status, value};
use crate::conversion::arrays::{Numbers, shape};
use crate::conversion::diagnostic::Diagnostic;
use crate::conversion::errors::input;
use crate::conversion::threads::{interruptible, interruptible_if_large};
use numpy::{PyArray1, PyReadonlyArray1, PyReadonlyArrayDyn, PyUntypedArrayMethods};
use percuss::study::matrix_findings as findings_of_batch;
use percuss::{
    EffectiveMass, MatrixName, MatrixOptions, MatrixResponse as Found, MatrixView, RegularMatrices,
    RemarkFlags, effective_mass as of_matrices, interruption,
};
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;
use pyo3::types::{PyAny, PyDict};
use rayon::prelude::*;

/// m̄ from matrices, with its error, rank report and remarks.
///
///     >>> percuss.effective_mass(np.eye(2), [1.0, 0.0], [[0.0, 1.0]]).velocity
#[pyclass(frozen, module = "percuss.results")]
#[derive(Clone, Debug)]
pub struct MatrixResponse(Found);

#[pymethods]
impl MatrixResponse {
    /// m̄, in the unit of M (kg); None unless finite.
    #[getter]
    fn effective_mass(&self) -> Option<f64> {
        value(self.0.effective_mass)
    }

    /// "finite"; "immovable": no motion with A v = 0 closes the gap; "massless": a motion without energy closes it.
    #[getter]
    fn status(&self) -> &'static str {
        status(self.0.effective_mass)
    }

    /// Bound on the error of m̄ from the accuracy of the entries and from rounding, kg; None if unknown, or if the rank
    /// is unclear.
    #[getter]
    fn error(&self) -> Option<f64> {
        self.0.error
    }

    /// v*: velocities at unit closing speed, in the units of the coordinates; zero if immovable; (n,).
    #[getter]
    fn velocity<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, &self.0.velocity)
    }

    /// Degrees of freedom: coordinates minus rank of A.
    #[getter]
    fn degrees_of_freedom(&self) -> usize {
        self.0.degrees_of_freedom
    }

    /// Rank report of A, with row numbers from 0: "rank"; "gap" (least gap between counted singular values and those
    /// taken as zero; None without rows); "is_clear"; "redundant_rows"; "dependent_sets"; "small_rows" (counted rows
    /// below the rounding of other rows).
    #[getter]
    fn rank<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let (report, rank) = (PyDict::new(py), &self.0.rank);
        report.set_item("rank", rank.rank)?;
        report.set_item("gap", rank.gap)?;
        report.set_item("is_clear", rank.is_clear)?;
        report.set_item("redundant_rows", &rank.redundant_rows)?;
        report.set_item("dependent_sets", &rank.dependent_sets)?;
        report.set_item("small_rows", &rank.small_rows)?;
        Ok(report)
    }

    /// Remarks about the result.
    #[getter]
    fn remarks(&self) -> Vec<String> {
        let small = &self.0.rank.small_rows;
        let small = (!small.is_empty()).then(|| {
            format!(
                "rows {small:?} of A count and are below the rounding of others: small units, or rounding to be excluded by \
                 row_noise"
            )
        });
        self.0.remarks.iter().map(ToString::to_string).chain(small).collect()
    }

    fn __repr__(&self) -> String {
        let what = match (self.effective_mass(), self.0.error) {
            (Some(m), Some(error)) => format!("{m} kg ± {error:.1e}"),
            (Some(m), None) => format!("{m} kg"),
            (None, _) => self.status().to_owned(),
        };
        format!("<MatrixResponse: {what}, {} degrees of freedom>", self.0.degrees_of_freedom)
    }
}

/// Options in owned form, for use while the interpreter is released.
struct OwnedOptions {
    lengths: Option<Vec<f64>>,
    rank_floor: Option<f64>,
    row_noise: Option<f64>,
    /// Accuracies of M, A and j.
    accuracy: [f64; 3],
}

/// M, j and A with their coordinates in the same order.
struct Matrices<'py> {
    mass: PyReadonlyArrayDyn<'py, f64>,
    row: PyReadonlyArrayDyn<'py, f64>,
    constraints: Option<PyReadonlyArrayDyn<'py, f64>>,
    reading: OwnedOptions,
}

/// Arguments of the caller before validation.
struct MatrixArguments<'a, 'py> {
    mass: &'a Bound<'py, PyAny>,
    row: &'a Bound<'py, PyAny>,
    constraints: Option<&'a Bound<'py, PyAny>>,
    lengths: Option<&'a Bound<'py, PyAny>>,
    rank_floor: Option<f64>,
    accuracy: Option<f64>,
    row_noise: Option<f64>,
}

/// Permitted numbers of dimensions of each matrix, with the expected shape as text.
struct Shapes {
    mass: (&'static [usize], &'static str),
    row: (&'static [usize], &'static str),
    constraints: (&'static [usize], &'static str),
}

impl<'py> MatrixArguments<'_, 'py> {
    /// Converts M, j and A to float64 with their coordinates in the order of M, and checks the shapes.
    fn read(self, shapes: &Shapes) -> PyResult<Matrices<'py>> {
        let mass = Numbers::of(self.mass, "M", shapes.mass.0, shapes.mass.1)?;
        let names = &mass.labels.columns;
        if let (Some(rows), Some(columns)) = (&mass.labels.rows, names)
            && rows != columns
        {
            return Err(input(
                "M has other labels on its rows than on its columns; expected the same coordinates in the same order",
            ));
        }
        if names.is_none() && mass.labels.rows.is_some() {
            return Err(input("M has labels on its rows and none on its columns; expected the same on both"));
        }
        let in_order_of = |found: Numbers<'py>, what: &str| match names {
            Some(names) => found.in_order_of(what, names, ": the coordinates of M"),
            None if found.labels.columns.is_some() => Err(input(format_args!(
                "{what} names its coordinates and M does not; expected labels on both, or on none"
            ))),
            None => Ok(found),
        };
        let row = in_order_of(Numbers::of(self.row, "j", shapes.row.0, shapes.row.1)?, "j")?;
        let constraints = self
            .constraints
            .map(|a| in_order_of(Numbers::of(a, "A", shapes.constraints.0, shapes.constraints.1)?, "A"))
            .transpose()?;
        let lengths = self
            .lengths
            .map(|lengths| {
                let expected = "one dimension: a length for each coordinate";
                let found = in_order_of(Numbers::of(lengths, "lengths", &[1], expected)?, "lengths")?;
                PyResult::Ok(found.array.as_array().iter().copied().collect())
            })
            .transpose()?;
        let own = |found: &Numbers<'_>| self.accuracy.unwrap_or(found.accuracy);
        let accuracy = [own(&mass), constraints.as_ref().map_or(own(&mass), own), own(&row)];
        Ok(Matrices {
            mass: mass.array,
            row: row.array,
            constraints: constraints.map(|a| a.array),
            reading: OwnedOptions {
                lengths,
                rank_floor: self.rank_floor,
                row_noise: self.row_noise,
                accuracy,
            },
        })
    }
}

impl OwnedOptions {
    /// Options for a call of the library.
    fn options(&self) -> MatrixOptions<'_> {
        let [mass, constraints, row] = self.accuracy;
        let mut options = MatrixOptions::new()
            .accuracy_of(MatrixName::Mass, mass)
            .accuracy_of(MatrixName::Constraints, constraints)
            .accuracy_of(MatrixName::ContactRow, row);
        if let Some(lengths) = &self.lengths {
            options = options.lengths(lengths);
        }
        if let Some(floor) = self.rank_floor {
            options = options.rank_floor(floor);
        }
        if let Some(noise) = self.row_noise {
            options = options.row_noise(noise);
        }
        options
    }
}

/// Values of an array with their layout. Only arrays that are not in one contiguous block are copied.
struct Block<'a> {
    values: std::borrow::Cow<'a, [f64]>,
    shape: Vec<usize>,
    strides: Vec<isize>,
}

impl<'a> Block<'a> {
    /// Block of an array; copies the values if they are not contiguous.
    fn of(array: &'a PyReadonlyArrayDyn<'_, f64>) -> Self {
        let view = array.as_array();
        let shape = view.shape().to_vec();
        let by_rows = || {
            let mut strides = vec![1; shape.len()];
            for axis in (1..shape.len()).rev() {
                strides[axis - 1] = strides[axis] * shape[axis].max(1) as isize;
            }
            strides
        };
        match array.as_slice() {
            Ok(values) if array.is_c_contiguous() => {
                Self { values: values.into(), strides: by_rows(), shape }
            }
            // One block, column by column.
            Ok(values) => Self { values: values.into(), strides: view.strides().to_vec(), shape },
            Err(_) => {
                let values: Vec<f64> = view.iter().copied().collect();
                Self { values: values.into(), strides: by_rows(), shape }
            }
        }
    }

    /// Matrix `c` of a batch (last two axes), or the only matrix.
    fn matrix(&self, c: usize) -> PyResult<MatrixView<'_>> {
        let axes = self.shape.len();
        let first = if axes == 3 { c as isize * self.strides[0] } else { 0 };
        let (shape, strides) =
            ([self.shape[axes - 2], self.shape[axes - 1]], [self.strides[axes - 2], self.strides[axes - 1]]);
        MatrixView::strided(&self.values, first.unsigned_abs(), shape, strides).map_err(input)
    }

    /// Row `c` of a batch (last axis), or the only row.
    fn row(&self, c: usize) -> PyResult<MatrixView<'_>> {
        let axes = self.shape.len();
        let first = if axes == 2 { c as isize * self.strides[0] } else { 0 };
        let (count, stride) = (self.shape[axes - 1], self.strides[axes - 1]);
        MatrixView::strided(&self.values, first.unsigned_abs(), [1, count], [0, stride]).map_err(input)
    }
}

/// Effective mass along a contact row of a system given by its matrices, in the unit of M (kg).
///
/// m̄ = min { vᵀMv : Av = 0, jv = 1 }; 1/(j M⁻¹ jᵀ) if M is regular and A is None. M: (n, n), symmetric, positive
/// semi-definite, kg, kg·m, kg·m². j: (n,), closing speed per rate, m, 1. A: (m, n) or None, Jacobian of the
/// constraints, each row in any unit. Arrays may be dense with any strides or
/// sparse (made dense: the cost is O(n³ + m n²), up to 1000 coordinates). Labels of tables (pandas) name the
/// coordinates: j, A and lengths are put in the order of M.
///
/// lengths: (n,), scale of each coordinate for rank decisions and for the test of whether the gap closes at all:
/// displacement per unit rate, in one unit for all coordinates: 1 for a slide in metres, a typical length for an angle.
/// Default: 1 for all. A finite m̄ does not depend on lengths, except for rounding. rank_floor: singular values of A
/// below this fraction of the largest count as zero, with each row scaled to 1; default 1e-10, or 10 times the accuracy
/// if larger. accuracy: relative error of the entries, 0 to 1e-3; default by the type of each array: 2.2e-16 (float64),
/// 6e-8 (float32), 4.9e-4 (float16), exact (integers). row_noise: rows of A with no entry above this value, in A's
/// unit, count as zero; default: 1e-14 of the largest entry of the rows that bind the same coordinates.
///
///     >>> percuss.effective_mass([[2.0, 0.3], [0.3, 1.0]], [1.0, -0.5]).effective_mass
#[pyfunction]
#[pyo3(signature = (M, j, A=None, *, lengths=None, rank_floor=None, accuracy=None, row_noise=None))]
#[allow(non_snake_case, reason = "the names that users of matrices expect")]
#[allow(clippy::too_many_arguments, reason = "the options of the question")]
pub fn effective_mass(
    py: Python<'_>,
    M: &Bound<'_, PyAny>,
    j: &Bound<'_, PyAny>,
    A: Option<&Bound<'_, PyAny>>,
    lengths: Option<&Bound<'_, PyAny>>,
    rank_floor: Option<f64>,
    accuracy: Option<f64>,
    row_noise: Option<f64>,
) -> PyResult<MatrixResponse> {
    let given = MatrixArguments { mass: M, row: j, constraints: A, lengths, rank_floor, accuracy, row_noise };
    let shapes = Shapes {
        mass: (&[2], "(n, n); effective_masses takes a batch"),
        row: (&[1, 2], "(n,)"),
        constraints: (&[2], "(m, n)"),
    };
    let Matrices { mass, row, constraints: rows, reading } = given.read(&shapes)?;
    let (mass, rows) = (Block::of(&mass), rows.as_ref().map(Block::of));
    let row = Block::of(&row);
    let row = if row.shape.len() == 2 { row.matrix(0)? } else { row.row(0)? };
    let coordinates = mass.shape[0];
    let (mass, rows) = (mass.matrix(0)?, rows.as_ref().map(|rows| rows.matrix(0)).transpose()?);
    let options = reading.options();
    let found =
        interruptible_if_large(py, coordinates, || of_matrices(mass, row, rows, &options))?.map_err(input)?;
    Ok(MatrixResponse(found))
}

/// m̄, error and status for a batch: M (b, n, n) or (n, n), j (b, n) or (n,), A (b, m, n), (m, n) or None. An array without a
/// batch axis is shared by the whole batch: one M with many j. Returns a MatrixBatch, which unpacks into effective_mass (b,) kg, NaN
/// unless finite; error (b,) kg, NaN if unknown; status (b,) uint8: 0 finite, 1 immovable, 2 massless. Its findings are
/// the warnings about all problems. Other parameters as for effective_mass. An error message names the number of the
/// failing problem.
///
///     >>> masses, errors, status = percuss.effective_masses(np.stack([np.eye(2), 2 * np.eye(2)]), [1.0, 0.0])
#[pyfunction]
#[pyo3(signature = (M, j, A=None, *, lengths=None, rank_floor=None, accuracy=None, row_noise=None))]
#[allow(non_snake_case, reason = "the names that users of matrices expect")]
#[allow(clippy::too_many_arguments, reason = "the options of the question")]
pub fn effective_masses<'py>(
    py: Python<'py>,
    M: &Bound<'py, PyAny>,
    j: &Bound<'py, PyAny>,
    A: Option<&Bound<'py, PyAny>>,
    lengths: Option<&Bound<'py, PyAny>>,
    rank_floor: Option<f64>,
    accuracy: Option<f64>,
    row_noise: Option<f64>,
) -> PyResult<Bound<'py, PyAny>> {
    let given = MatrixArguments { mass: M, row: j, constraints: A, lengths, rank_floor, accuracy, row_noise };
    let shapes = Shapes {
        mass: (&[2, 3], "(b, n, n) or (n, n)"),
        row: (&[1, 2], "(b, n) or (n,)"),
        constraints: (&[2, 3], "(b, m, n) or (m, n)"),
    };
    let Matrices { mass, row, constraints: rows, reading } = given.read(&shapes)?;
    let (mass, row, rows) = (Block::of(&mass), Block::of(&row), rows.as_ref().map(Block::of));
    let given = [Some(("M", &mass, 3)), Some(("j", &row, 2)), rows.as_ref().map(|rows| ("A", rows, 3))];
    let batches = given.into_iter().flatten().filter(|(_, block, axes)| block.shape.len() == *axes);
    let batches: Vec<(&str, &[usize])> = batches.map(|(name, block, _)| (name, &block.shape[..])).collect();
    let Some((first, of_first)) = batches.first().copied() else {
        return Err(input("M, j, A: none has a batch axis; effective_mass solves one problem"));
    };
    let count = of_first[0];
    if let Some((name, other)) = batches.iter().find(|(_, other)| other[0] != count) {
        return Err(input(format_args!(
            "{name} has shape {}, {first} {}: their batches differ",
            shape(other),
            shape(of_first)
        )));
    }
    let options = reading.options();
    let one = |regular: &mut RegularMatrices, c: usize| -> Result<Solved, PyErr> {
        if interruption::is_requested() {
            return Err(PyKeyboardInterrupt::new_err(()));
        }
        let (mass, row) = (mass.matrix(c)?, row.row(c)?);
        let rows = rows.as_ref().map(|rows| rows.matrix(c)).transpose()?;
        if let Some((mass, error)) = regular.solve(&mass, &row, rows.as_ref(), &options) {
            return Ok(Solved {
                mass,
                error,
                code: 0,
                remarks: RemarkFlags::default(),
                has_small_rows: false,
            });
        }
        let found = of_matrices(mass, row, rows, &options)
            .map_err(|error| input(format_args!("number {c} of the batch: {error}")))?;
        let (mass, code) = mass_and_code(Some(found.effective_mass));
        let error = found.error.unwrap_or(f64::NAN);
        let remarks: RemarkFlags = found.remarks.iter().collect();
        Ok(Solved { mass, error, code, remarks, has_small_rows: !found.rank.small_rows.is_empty() })
    };
    // 256 problems per portion, with a check for Ctrl-C between portions.
    let (mut masses, mut errors, mut codes) = (Vec::new(), Vec::new(), Vec::new());
    let (mut remarks, mut small_rows) = (Vec::new(), Vec::new());
    for first in (0..count).step_by(256) {
        let part = interruptible(py, || {
            let part = (first..count.min(first + 256)).into_par_iter();
            part.map_init(RegularMatrices::default, one).collect::<PyResult<Vec<_>>>()
        })??;
        for solved in part {
            if solved.has_small_rows {
                small_rows.push(masses.len());
            }
            masses.push(solved.mass);
            errors.push(solved.error);
            codes.push(solved.code);
            remarks.push(solved.remarks.bits());
        }
        py.check_signals()?;
    }
    let (masses, errors) = (PyArray1::from_vec(py, masses), PyArray1::from_vec(py, errors));
    let (codes, remarks) = (PyArray1::from_vec(py, codes), PyArray1::from_vec(py, remarks));
    py.import("percuss._matrices")?
        .getattr("MatrixBatch")?
        .call1((masses, errors, codes, remarks, small_rows))
}

/// Result of one problem of a batch.
struct Solved {
    /// m̄ (NaN unless finite) and its error (NaN if unknown), kg.
    mass: f64,
    error: f64,
    /// Status code.
    code: u8,
    remarks: RemarkFlags,
    has_small_rows: bool,
}

/// Findings about a batch, from the remarks of each problem and the numbers of the problems with small rows.
#[pyfunction]
#[allow(clippy::needless_pass_by_value, reason = "arguments are extracted by value")]
pub fn matrix_findings(remarks: PyReadonlyArray1<'_, u32>, small_rows: Vec<usize>) -> Vec<Diagnostic> {
    let problems = remarks.as_array();
    let problems = problems.iter().map(|bits| RemarkFlags::from_bits(*bits));
    findings_of_batch(problems, &small_rows).into_iter().map(Diagnostic).collect()
}

/// m̄ (NaN unless finite) and status code of an outcome.
pub fn mass_and_code(mass: Option<EffectiveMass>) -> (f64, u8) {
    match mass {
        Some(EffectiveMass::Finite(m)) => (m, 0),
        Some(EffectiveMass::Immovable) => (f64::NAN, 1),
        Some(EffectiveMass::Massless) => (f64::NAN, 2),
        None => (f64::NAN, 3),
    }
}
