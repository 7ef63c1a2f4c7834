//! Results of a sweep as a Python object.

use crate::conversion::diagnostic::Diagnostic;
use crate::conversion::errors;
use numpy::ndarray::Dimension;
use numpy::{PyArray, PyArray1, PyArray2, PyArray3, PyArrayMethods, PyUntypedArrayMethods};
use percuss::RemarkFlags;
use percuss::study::row_findings;
use percuss_render::{Figure, Panel, Picture, Series, Style};
use pyo3::prelude::*;
use pyo3::types::{PyAny, PyDict};

/// m̄ of a contact at many configurations.
///
///     >>> swept = percuss.sweep(arm, tool, q)
///     >>> swept.effective_mass, swept.error, swept.findings
///     >>> swept[swept.status == percuss.Status.FINITE].to_dataframe()
#[pyclass(frozen, module = "percuss.results")]
#[derive(Debug)]
pub struct Sweep {
    /// m̄, kg; NaN unless finite; (N,).
    #[pyo3(get)]
    pub effective_mass: Py<PyArray1<f64>>,
    /// Error of m̄, kg; NaN unless m̄ is finite, and with the remark UNKNOWN_ERROR; (N,).
    #[pyo3(get)]
    pub error: Py<PyArray1<f64>>,
    /// 0 finite, 1 immovable, 2 massless, 3 no answer: the pose does not exist, or no route solves it; 4 massless to
    /// rounding only: error is then the largest possible m̄ of the contact; uint8, (N,).
    #[pyo3(get)]
    pub status: Py<PyArray1<u8>>,
    /// Findings about each row: RemarkFlags added together; uint32, (N,).
    #[pyo3(get)]
    pub remarks: Py<PyArray1<u32>>,
    /// Gradients, if requested.
    pub gradient: Option<Py<PyArray2<f64>>>,
    /// Gradients by the twist of the root link, with the gradients.
    pub base_gradient: Option<Py<PyArray2<f64>>>,
    /// Inverse operational inertias, if requested.
    pub inverse_operational_inertia: Option<Py<PyArray3<f64>>>,
    /// Link name in the title of the picture.
    pub link: String,
    /// Reason for the first missing answer of a path.
    pub no_answer: Option<String>,
    /// Labels of the rows of a table of positions; None for arrays.
    #[pyo3(get)]
    pub index: Option<Py<PyAny>>,
    /// Name of each velocity.
    pub velocity_names: Vec<String>,
}

/// Array of a sweep; `NotComputedError` if the array was not requested.
fn requested<T>(array: Option<&Py<T>>, py: Python<'_>, name: &str) -> PyResult<Py<T>> {
    array.map(|array| array.clone_ref(py)).ok_or_else(|| {
        errors::not_computed(format_args!("{name} was not requested; call percuss.sweep(…, {name}=True)"))
    })
}

/// Array of the axes of `D`.
fn array_of_rank<D: Dimension>(array: Bound<'_, PyAny>) -> PyResult<Py<PyArray<f64, D>>> {
    Ok(array.cast_into::<PyArray<f64, D>>()?.unbind())
}

/// Rebuilds a sweep from its parts: of another process, or of some rows.
#[pyfunction]
pub fn sweep_of_parts(parts: &Bound<'_, PyDict>) -> PyResult<Sweep> {
    let part = |name: &str| -> PyResult<Option<Bound<'_, PyAny>>> {
        Ok(parts.get_item(name)?.filter(|value| !value.is_none()))
    };
    let needed =
        |name: &str| part(name)?.ok_or_else(|| errors::input(format_args!("the sweep has no {name}")));
    Ok(Sweep {
        effective_mass: needed("effective_mass")?.extract()?,
        error: needed("error")?.extract()?,
        status: needed("status")?.extract()?,
        remarks: needed("remarks")?.extract()?,
        gradient: part("gradient")?.map(array_of_rank::<numpy::Ix2>).transpose()?,
        base_gradient: part("base_gradient")?.map(array_of_rank::<numpy::Ix2>).transpose()?,
        inverse_operational_inertia: part("inverse_operational_inertia")?
            .map(array_of_rank::<numpy::Ix3>)
            .transpose()?,
        link: needed("link")?.extract()?,
        no_answer: part("no_answer")?.map(|reason| reason.extract()).transpose()?,
        index: part("index")?.map(Bound::unbind),
        velocity_names: needed("velocity_names")?.extract()?,
    })
}

#[pymethods]
impl Sweep {
    fn __len__(&self, py: Python<'_>) -> usize {
        self.status.bind(py).len()
    }

    /// Findings about the rows: one per kind of remark, with the first row and the number of further rows. Pose.respond
    /// at a row has the numbers.
    #[getter]
    fn findings(&self, py: Python<'_>) -> Vec<Diagnostic> {
        let flags = self.remarks.bind(py).readonly();
        let rows = flags.as_array();
        let rows = rows.iter().map(|bits| RemarkFlags::from_bits(*bits));
        row_findings(rows, self.no_answer.as_deref()).into_iter().map(Diagnostic).collect()
    }

    /// Gradient of m̄ by the velocities of all joints (Model.velocity_names), kg/rad or kg/m; NaN unless m̄ is finite with an error of at most 1e-6 m̄; (N, n). With loops,
    /// only sums over admissible motions have a meaning. Raises NotComputedError unless the sweep had gradient=True.
    #[getter]
    fn gradient(&self, py: Python<'_>) -> PyResult<Py<PyArray2<f64>>> {
        requested(self.gradient.as_ref(), py, "gradient")
    }

    /// Φ = J M_c⁻¹ Jᵀ of the contact link at the contact point, in root axes, angular part first: the inverse of the operational
    /// inertia Λ; (N, 6, 6). The block [:, 3:, 3:] is that of forces, 1/kg. Raises NotComputedError unless the sweep had
    /// inverse_operational_inertia=True.
    #[getter]
    fn inverse_operational_inertia(&self, py: Python<'_>) -> PyResult<Py<PyArray3<f64>>> {
        requested(self.inverse_operational_inertia.as_ref(), py, "inverse_operational_inertia")
    }

    /// Gradient of m̄ by the twist of the root link while the joints are at rest, angular (kg/rad), then linear (kg/m), in root axes; (N, 6):
    /// dm̄/dt = gradient · velocities + base_gradient · base_twist. It is zero unless the normal is fixed in the world. Raises
    /// NotComputedError unless the sweep had gradient=True.
    #[getter]
    fn base_gradient(&self, py: Python<'_>) -> PyResult<Py<PyArray2<f64>>> {
        match (&self.gradient, &self.base_gradient) {
            (Some(_), None) => Err(errors::not_computed(
                "base_gradient is not computed for a normal that is fixed in the world against another link; \
                 Pose.base_gradient computes it",
            )),
            _ => requested(self.base_gradient.as_ref(), py, "gradient"),
        }
    }

    /// Parts of the sweep by name: arrays with a row for each configuration, then what all rows share.
    fn _parts<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyDict>, Bound<'py, PyDict>)> {
        let (rows, shared) = (PyDict::new(py), PyDict::new(py));
        rows.set_item("effective_mass", &self.effective_mass)?;
        rows.set_item("error", &self.error)?;
        rows.set_item("status", &self.status)?;
        rows.set_item("remarks", &self.remarks)?;
        rows.set_item("gradient", &self.gradient)?;
        rows.set_item("base_gradient", &self.base_gradient)?;
        rows.set_item("inverse_operational_inertia", &self.inverse_operational_inertia)?;
        rows.set_item("index", &self.index)?;
        shared.set_item("link", &self.link)?;
        shared.set_item("no_answer", &self.no_answer)?;
        shared.set_item("velocity_names", &self.velocity_names)?;
        Ok((rows, shared))
    }

    /// A row (SweepRow) by its number, or the Sweep of some rows by a slice, an array of numbers, or a mask.
    fn __getitem__<'py>(slf: &Bound<'py, Self>, rows: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        slf.py().import("percuss._sweeps")?.call_method1("select", (slf, rows))
    }

    /// Table (pandas) with a row for each configuration, under the labels of q: effective_mass, error, status (text), a column for each kind
    /// of finding that occurs (RemarkFlags), and the entries of the gradient as gradient[JOINT].
    fn to_dataframe<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        slf.py().import("percuss._sweeps")?.call_method1("dataframe", (slf,))
    }

    /// Pickles a sweep as its parts.
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, (Bound<'py, PyDict>,))> {
        let (rows, shared) = self._parts(py)?;
        rows.update(shared.as_mapping())?;
        Ok((py.import("percuss")?.getattr("_sweep")?, (rows,)))
    }

    fn __repr__(&self, py: Python<'_>) -> String {
        let (masses, codes) = (self.effective_mass.bind(py).readonly(), self.status.bind(py).readonly());
        let finite: Vec<f64> = masses.as_array().iter().copied().filter(|m| m.is_finite()).collect();
        let least = finite.iter().copied().reduce(f64::min);
        let most = finite.iter().copied().reduce(f64::max);
        let range = match (least, most) {
            (Some(least), Some(most)) => format!(", {least:.6} to {most:.6} kg"),
            _ => String::new(),
        };
        format!("<Sweep: {} configurations, {} finite{range}>", codes.len(), finite.len())
    }

    /// The picture as SVG: m̄ over the row number.
    fn to_svg(&self, py: Python<'_>) -> String {
        let masses = self.effective_mass.bind(py).readonly();
        let points = masses.as_array();
        let points = points.iter().enumerate();
        let points = points.map(|(row, m)| (row as f64, Some(*m).filter(|m| m.is_finite()))).collect();
        let mass = Series { name: "effective mass".into(), style: Style::Line, points };
        let figure = Figure {
            title: format!("Effective mass at {}", self.link),
            x_label: "row".into(),
            panels: vec![Panel { y_label: "m̄ (kg)".into(), series: vec![mass], ..Panel::default() }],
            ..Figure::default()
        };
        figure.to_svg()
    }

    /// Description and plot of the sweep, for notebooks.
    fn _repr_html_(&self, py: Python<'_>) -> String {
        let heading = self.__repr__(py).replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
        format!("<div><p><code>{heading}</code></p>{}</div>", self.to_svg(py))
    }
}
