//! Poses: a mechanism at one configuration, its matrices, its answers.

use crate::arrays::{matrix, triple};
use crate::contact::Contact;
use crate::errors::{self, input};
use crate::model::Model;
use crate::response::{Response, route_choice};
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use percuss::nalgebra::Vector3;
use percuss::{LocatedContact, Pose as Posed};
use pyo3::prelude::*;
use pyo3::types::{PyAny, PyDict};

/// A mechanism at one configuration, its loops closed. Cannot be changed: threads may share it.
#[pyclass(frozen, module = "percuss")]
#[derive(Clone, Debug)]
pub struct Pose {
    pub model: Model,
    pub pose: Posed,
}

impl Pose {
    fn located(&self, contact: &Contact) -> PyResult<LocatedContact> {
        self.pose.locate(&contact.on(&self.model.read.mechanism)?).map_err(input)
    }
}

#[pymethods]
impl Pose {
    /// The model.
    #[getter]
    fn model(&self) -> Model {
        self.model.clone()
    }

    /// Positions of all joints one after another, in the order of the file; (p,).
    #[getter]
    fn positions<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, self.pose.positions())
    }

    /// Position of each movable joint, by its name; (1,), or as many as it has.
    #[getter]
    fn joints<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let (by_name, mechanism) = (PyDict::new(py), &self.model.read.mechanism);
        for id in mechanism.joint_ids() {
            let joint = mechanism.joint(id);
            if joint.kind().positions() > 0 {
                by_name.set_item(joint.name(), PyArray1::from_slice(py, self.pose.joint(id)))?;
            }
        }
        Ok(by_name)
    }

    /// Degrees of freedom here; a floating base counts 6.
    #[getter]
    fn degrees_of_freedom(&self) -> usize {
        self.pose.degrees_of_freedom()
    }

    /// Whether branches cross here.
    #[getter]
    fn is_singular(&self) -> bool {
        self.pose.rank().singular
    }

    /// How far the farthest loop is from closed, m; None without loops.
    #[getter]
    fn closure_residual(&self) -> Option<f64> {
        self.pose.loops().map(|loops| loops.residual)
    }

    /// Where a link stands in the root link's frame, homogeneous; (4, 4).
    fn link_frame<'py>(&self, py: Python<'py>, link: &str) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let frame = self.pose.link(self.model.read.mechanism.find_link(link).map_err(input)?);
        let mut values = Vec::with_capacity(16);
        for row in 0..3 {
            values.extend(frame.rotation.row(row).iter());
            values.push(frame.translation[row]);
        }
        values.extend([0.0, 0.0, 0.0, 1.0]);
        PyArray1::from_vec(py, values).reshape([4, 4])
    }

    /// M over the coordinates, kg, kg·m, kg·m²; (n, n), armatures included.
    fn mass_matrix<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        matrix(py, &self.pose.mass_matrix())
    }

    /// A: Jacobian of closures, couplings and held points over the coordinates; (m, n).
    fn constraint_matrix<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        matrix(py, &self.pose.constraint_matrix())
    }

    /// j: closing speed of the gap at unit rates, m, 1; (n,).
    fn contact_row<'py>(&self, py: Python<'py>, contact: &Contact) -> PyResult<Bound<'py, PyArray1<f64>>> {
        Ok(PyArray1::from_vec(py, self.pose.contact_row(&self.located(contact)?)))
    }

    /// Jacobian of a point (m, link's frame) over the coordinates, root link's axes, m, 1; (3, n).
    fn point_jacobian<'py>(
        &self,
        py: Python<'py>,
        link: &str,
        point: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let link = self.model.read.mechanism.find_link(link).map_err(input)?;
        matrix(py, &self.pose.point_jacobian(link, &Vector3::from(triple(point, "point")?)))
    }

    /// Φ = J M⁻¹ Jᵀ of both sides of a contact at its point, constraints included; (12, 12), 1/kg and so on: six rows, angular
    /// then linear (root link's axes), for the struck link, six for the other; 1/m̄ = wᵀΦw with w = (0, n̂, 0, −n̂).
    fn inverse_operational_inertia<'py>(
        &self,
        py: Python<'py>,
        contact: &Contact,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let located = self.located(contact)?;
        let phi = self.pose.inverse_operational_inertia(&located).map_err(errors::route)?;
        let rows: Vec<f64> = phi.matrix().transpose().as_slice().to_vec();
        PyArray1::from_vec(py, rows).reshape([12, 12])
    }

    /// m̄ at a contact, and what follows from it. route: "auto", "dense" (O(n³)) or "articulated" (O(n)).
    #[pyo3(signature = (contact, *, route="auto"))]
    fn respond(&self, py: Python<'_>, contact: &Contact, route: &str) -> PyResult<Response> {
        let (contact, route) = (contact.on(&self.model.read.mechanism)?, route_choice(route)?);
        let response = py.detach(|| self.pose.respond(&contact, route)).map_err(errors::response)?;
        Ok(Response { model: self.model.clone(), pose: self.pose.clone(), response })
    }

    fn __repr__(&self) -> String {
        let singular = if self.is_singular() { ", singular" } else { "" };
        format!(
            "<Pose of \"{}\": {} degrees of freedom{singular}>",
            self.model.read.mechanism.name(),
            self.pose.degrees_of_freedom()
        )
    }
}
