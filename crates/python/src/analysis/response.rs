//! Response to a contact at a pose.

use crate::analysis::contact::Contact as PickledContact;
use crate::analysis::pose::Pose;
use crate::conversion::arrays::triple;
use crate::conversion::diagnostic::Diagnostic;
use crate::conversion::errors::input;
use crate::conversion::pickle::{Rebuilt, result_of};
use crate::conversion::threads::interruptible_if_large;
use numpy::PyArray1;
use percuss::nalgebra::Vector3;
use percuss::study::response_findings;
use percuss::{Contact, ContactResponse, EffectiveMass, PointVelocity, Route, RouteChoice};
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::{PyAny, PyDict};

/// m̄ at a contact of a pose, and the quantities derived from it.
///
///     >>> response = model.pose().respond(contact)
///     >>> response.effective_mass, response.error, response.contributions
#[pyclass(frozen, module = "percuss.results")]
#[derive(Clone, Debug)]
pub struct Response {
    pub pose: Pose,
    pub contact: Contact,
    pub route: RouteChoice,
    /// Masses given to `against_mass`, kg.
    pub masses: Vec<f64>,
    pub response: ContactResponse,
}

/// Name of an outcome.
pub fn status(mass: EffectiveMass) -> &'static str {
    match mass {
        EffectiveMass::Finite(_) => "finite",
        EffectiveMass::Immovable => "immovable",
        EffectiveMass::Massless => "massless",
    }
}

/// m̄ in kg; `None` unless finite.
pub fn value(mass: EffectiveMass) -> Option<f64> {
    if let EffectiveMass::Finite(m) = mass { Some(m) } else { None }
}

/// Parses a route name.
pub fn route_choice(name: &str) -> PyResult<RouteChoice> {
    match name {
        "auto" => Ok(RouteChoice::Auto),
        "dense" => Ok(RouteChoice::Only(Route::Dense)),
        "articulated" => Ok(RouteChoice::Only(Route::Articulated)),
        _ => Err(input(format_args!("route is \"{name}\"; expected \"auto\", \"dense\" or \"articulated\""))),
    }
}

/// Name of a choice of routes.
fn route_name(choice: RouteChoice) -> &'static str {
    match choice {
        RouteChoice::Auto => "auto",
        RouteChoice::Only(Route::Dense) => "dense",
        RouteChoice::Only(Route::Articulated) => "articulated",
    }
}

#[pymethods]
impl Response {
    /// m̄ in the unit given by unit; None unless finite.
    #[getter]
    fn effective_mass(&self) -> Option<f64> {
        value(self.response.effective_mass)
    }

    /// Unit of the effective mass and its errors: "kg", or "kg·m²" for a moment about an axis.
    #[getter]
    fn unit(&self) -> &'static str {
        if self.response.contact.is_moment { "kg·m²" } else { "kg" }
    }

    /// "finite"; "immovable": no admissible motion closes the gap; "massless": a motion without energy closes it.
    #[getter]
    fn status(&self) -> &'static str {
        status(self.response.effective_mass)
    }

    /// Error of m̄, kg: the sum of the known parts of the error budget; None if the rounding or the closing part is
    /// unknown.
    #[getter]
    fn error(&self) -> Option<f64> {
        self.response.effective_mass_error()
    }

    /// Parts of the error budget, kg: "rounding", "closing", "file"; None for a part without a measure.
    #[getter]
    fn error_budget<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let budget = self.response.error.unwrap_or_default();
        let parts = PyDict::new(py);
        parts.set_item("rounding", budget.rounding)?;
        parts.set_item("closing", budget.closing)?;
        parts.set_item("file", budget.file)?;
        Ok(parts)
    }

    /// "dense" or "articulated".
    #[getter]
    fn route(&self) -> &'static str {
        match self.response.route {
            Route::Dense => "dense",
            Route::Articulated => "articulated",
        }
    }

    /// dim ker A at the pose, a floating base's 6 included.
    #[getter]
    fn degrees_of_freedom(&self) -> usize {
        self.response.degrees_of_freedom
    }

    /// True if branches cross at the pose: m̄ is then a lower bound that no branch attains.
    #[getter]
    fn singular_pose(&self) -> bool {
        self.response.singular_pose
    }

    /// Remarks about the result.
    #[getter]
    fn remarks(&self) -> Vec<String> {
        self.response.remarks.iter().map(ToString::to_string).collect()
    }

    /// Findings about the pose and the result, as in reports of the command line. At a singular pose, its branches are
    /// followed.
    #[getter]
    fn findings(&self, py: Python<'_>) -> PyResult<Vec<Diagnostic>> {
        let coordinates = self.pose.pose.positions().len();
        let found = interruptible_if_large(py, coordinates, || {
            response_findings(&self.pose.system.system, &self.pose.pose, &self.contact, &self.response)
        })?;
        Ok(found.into_iter().map(Diagnostic).collect())
    }

    /// v*: velocities of each joint at unit closing speed, by joint name; (d,) rad or m, per m (per rad for a moment).
    #[getter]
    fn joint_velocities<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let by_name = PyDict::new(py);
        let joints = self.pose.model.read.mechanism.joints();
        for (joint, velocities) in joints.iter().zip(&self.response.joint_velocities) {
            by_name.set_item(joint.name(), PyArray1::from_slice(py, velocities))?;
        }
        Ok(by_name)
    }

    /// v* of a floating root link: 3 angular (rad/s), 3 linear (m/s), per unit closing speed, root link's axes; (6,).
    #[getter]
    fn base_velocity<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        let twist = &self.response.base_velocity;
        let parts = twist.angular.iter().chain(twist.linear.iter()).copied();
        PyArray1::from_vec(py, parts.collect())
    }

    /// Share of each link in the kinetic energy at unit closing speed, by link name; None unless finite.
    #[getter]
    fn contributions<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        let Some(shares) = &self.response.contributions else { return Ok(None) };
        let by_name = PyDict::new(py);
        for (link, share) in self.pose.model.read.mechanism.links().iter().zip(&shares.links) {
            by_name.set_item(link.name(), share)?;
        }
        Ok(Some(by_name))
    }

    /// Share of each rotor (armature) in the kinetic energy at unit closing speed, by joint name; None unless finite.
    #[getter]
    fn rotor_contributions<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        let Some(shares) = &self.response.contributions else { return Ok(None) };
        let by_name = PyDict::new(py);
        for &(joint, share) in &shares.rotors {
            by_name.set_item(self.pose.model.read.mechanism.joint(joint).name(), share)?;
        }
        Ok(Some(by_name))
    }

    /// The contact point in the world, m; (3,).
    #[getter]
    fn point_world<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, self.response.contact.point_world.as_slice())
    }

    /// The normal in the world, out of the contact link; (3,).
    #[getter]
    fn normal_world<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, self.response.contact.normal_world.as_slice())
    }

    /// Limits of m̄ along the branches that cross at a singular pose, kg; None for a branch along which the gap does
    /// not close.
    fn branch_limits(&self, py: Python<'_>) -> PyResult<Vec<Option<f64>>> {
        let coordinates = self.pose.pose.positions().len();
        let limits =
            interruptible_if_large(py, coordinates, || self.pose.pose.branch_limits(&self.contact).limits)?;
        let limit = |mass: EffectiveMass| match mass {
            EffectiveMass::Finite(m) => Some(m),
            EffectiveMass::Immovable => None,
            EffectiveMass::Massless => Some(0.0),
        };
        Ok(limits.into_iter().map(limit).collect())
    }

    /// Velocity of a point of a link at unit closing speed, relative to the contact's other side; (3,). Its length is
    /// the motion ratio. Axes of the root link or of the world, as for Pose.link_frame. None if the response has no
    /// motion, or if a massless motion leaves the velocity undetermined.
    #[pyo3(signature = (link, point, *, frame=None))]
    fn point_velocity<'py>(
        &self,
        py: Python<'py>,
        link: &str,
        point: &Bound<'py, PyAny>,
        frame: Option<&str>,
    ) -> PyResult<Option<Bound<'py, PyArray1<f64>>>> {
        let link = self.pose.model.read.mechanism.find_link(link).map_err(input)?;
        let point = Vector3::from(triple(point, "point")?);
        let axes = self.pose.axes(frame)?;
        Ok(match self.pose.pose.point_velocity(&self.response, link, &point) {
            Some(PointVelocity::Known(velocity)) => {
                Some(PyArray1::from_slice(py, (axes * velocity).as_slice()))
            }
            Some(PointVelocity::Undetermined) | None => None,
        })
    }

    /// The response with a free body of this mass (kg) as the other side.
    fn against_mass(&self, mass: f64) -> PyResult<Self> {
        let response = self.response.clone().against_mass(mass).map_err(input)?;
        let masses = self.masses.iter().copied().chain([mass]).collect();
        Ok(Self { response, masses, ..self.clone() })
    }

    /// Pickles a response as its pose and contact.
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Rebuilt<'py>> {
        let pose = self.pose.clone().into_bound_py_any(py)?;
        let contact = PickledContact::of_resolved(&self.pose.model.read.mechanism, &self.contact);
        let route = route_name(self.route).into_bound_py_any(py)?;
        let Some((last, before)) = self.masses.split_last() else {
            return result_of(pose, "respond", (contact,), &[("route", route)]);
        };
        let keywords = PyDict::new(py);
        keywords.set_item("route", route)?;
        let mut owner = pose.call_method("respond", (contact,), Some(&keywords))?;
        for mass in before {
            owner = owner.call_method1("against_mass", (*mass,))?;
        }
        result_of(owner, "against_mass", (*last,), &[])
    }

    fn __repr__(&self) -> String {
        let what = match self.effective_mass() {
            Some(m) => match self.error() {
                Some(error) => format!("{m} {} ± {error:.1e}", self.unit()),
                None => format!("{m} {}", self.unit()),
            },
            None => self.status().to_owned(),
        };
        let singular = if self.response.singular_pose { ", singular pose" } else { "" };
        format!("<Response: {what}, {} degrees of freedom{singular}>", self.response.degrees_of_freedom)
    }
}
