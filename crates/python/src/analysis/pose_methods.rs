//! Python methods of a pose.

use crate::analysis::contact::GivenContact;
use crate::analysis::maps::{Answers, contact_map, principal_masses};
use crate::analysis::model::Model;
use crate::analysis::motion::{
    Accelerations, accelerations, by_joint, effective_mass_gradient, effective_mass_rate,
};
use crate::analysis::pose::Pose;
use crate::analysis::response::{Response, route_choice};
use crate::analysis::system::{by_name, seven_numbers};
use crate::conversion::arrays::{matrix, triple};
use crate::conversion::diagnostic::Diagnostic;
use crate::conversion::errors::{self, input};
use crate::conversion::pickle::{Rebuilt, result_of};
use crate::conversion::threads::interruptible_if_large;
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use percuss::LocatedContact;
use percuss::nalgebra::{DMatrix, Matrix3, Vector3};
use percuss::spatial::Transform;
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyAny, PyDict};
use std::collections::BTreeMap;
use std::sync::Arc;

impl Pose {
    /// The contact resolved at this pose.
    fn located(&self, contact: &GivenContact<'_>) -> PyResult<LocatedContact> {
        self.pose.locate(&contact.resolve(&self.model.read.mechanism)?).map_err(input)
    }

    /// Φ of both sides of a contact, 12×12.
    fn mobility(&self, contact: &GivenContact<'_>, frame: Option<&str>) -> PyResult<DMatrix<f64>> {
        let (located, axes) = (self.located(contact)?, self.axes(frame)?);
        let phi = self.pose.inverse_operational_inertia(&located).map_err(errors::route)?;
        let mut turned = DMatrix::from_column_slice(12, 12, phi.matrix().as_slice());
        for (row, column) in (0..12).step_by(3).flat_map(|row| (0..12).step_by(3).map(move |c| (row, c))) {
            let block: Matrix3<f64> = turned.fixed_view::<3, 3>(row, column).into_owned();
            turned.fixed_view_mut::<3, 3>(row, column).copy_from(&(axes * block * axes.transpose()));
        }
        Ok(turned)
    }
}

#[pymethods]
impl Pose {
    /// The model.
    #[getter]
    fn model(&self) -> Model {
        self.model.clone()
    }

    /// Positions of all joints, concatenated in the order of the file; (p,).
    #[getter]
    fn positions<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, self.pose.positions())
    }

    /// Position of each movable joint, by joint name; (1,), or one entry per position of the joint.
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

    /// Degrees of freedom at this pose; a floating base counts 6.
    #[getter]
    fn degrees_of_freedom(&self) -> usize {
        self.pose.degrees_of_freedom()
    }

    /// True if branches cross at this pose.
    #[getter]
    fn is_singular(&self) -> bool {
        self.pose.rank().singular
    }

    /// Largest closure error of all loops, m; None without loops.
    #[getter]
    fn closure_residual(&self) -> Option<f64> {
        self.pose.loops().map(|loops| loops.residual)
    }

    /// Findings about the pose, as in reports of the command line: joints outside their limits, loops open as drawn,
    /// another assembly mode, an unclear rank.
    #[getter]
    fn findings(&self, py: Python<'_>) -> PyResult<Vec<Diagnostic>> {
        let coordinates = self.pose.positions().len();
        let found = interruptible_if_large(py, coordinates, || {
            percuss::study::pose_findings(&self.system.system, &self.pose)
        })?;
        Ok(found.into_iter().map(Diagnostic).collect())
    }

    /// The frame of a link in the root link's frame (frame="root") or in the world (frame="world"), homogeneous; (4,
    /// 4). frame may be omitted if the pose has no base_pose: both frames are then the same.
    #[pyo3(signature = (link, *, frame=None))]
    fn link_frame<'py>(
        &self,
        py: Python<'py>,
        link: &str,
        frame: Option<&str>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let own = self.pose.link(self.model.read.mechanism.find_link(link).map_err(input)?);
        // The pose stores link frames in the world.
        let frame = self.frame(frame)? * (self.pose.base().inverse() * own);
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
    fn contact_row<'py>(
        &self,
        py: Python<'py>,
        contact: GivenContact<'_>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        Ok(PyArray1::from_vec(py, self.pose.contact_row(&self.located(&contact)?)))
    }

    /// Jacobian of a point (m, link's frame) over the coordinates, m, 1; (3, n). Axes of the root link or of the world, as for
    /// link_frame.
    #[pyo3(signature = (link, point, *, frame=None))]
    fn point_jacobian<'py>(
        &self,
        py: Python<'py>,
        link: &str,
        point: &Bound<'py, PyAny>,
        frame: Option<&str>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let link = self.model.read.mechanism.find_link(link).map_err(input)?;
        let rows = self.pose.point_jacobian(link, &Vector3::from(triple(point, "point")?));
        let turned = self.axes(frame)? * rows;
        matrix(py, &DMatrix::from_column_slice(3, turned.ncols(), turned.as_slice()))
    }

    /// Jacobian of a link at a point (m, link's frame) over the coordinates, angular velocity first; (6, n). Axes of the root link or of the
    /// world, as for link_frame.
    #[pyo3(signature = (link, point, *, frame=None))]
    fn jacobian<'py>(
        &self,
        py: Python<'py>,
        link: &str,
        point: &Bound<'py, PyAny>,
        frame: Option<&str>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let link = self.model.read.mechanism.find_link(link).map_err(input)?;
        let axes = self.axes(frame)?;
        let angular = axes * self.pose.angular_jacobian(link);
        let linear = axes * self.pose.point_jacobian(link, &Vector3::from(triple(point, "point")?));
        let rows = |r: usize, c: usize| if r < 3 { angular[(r, c)] } else { linear[(r - 3, c)] };
        matrix(py, &DMatrix::from_fn(6, linear.ncols(), rows))
    }

    /// T with q̇ = T u: velocities of all joints (Model.velocity_names) by the rates u of the coordinates of M, A, j and the Jacobians; mimics
    /// follow, locked joints are at rest; (velocities, n). gradient @ T has the columns of M.
    fn velocity_matrix<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let n = self.pose.coordinate_joints().len();
        let column = |k: usize| -> Vec<f64> {
            let unit: Vec<f64> = (0..n).map(|c| if c == k { 1.0 } else { 0.0 }).collect();
            self.pose.joint_velocities(&unit).0.concat()
        };
        let velocities = self.model.read.mechanism.joints().iter().map(|joint| joint.kind().dofs()).sum();
        let values: Vec<f64> = (0..n).flat_map(column).collect();
        matrix(py, &DMatrix::from_vec(velocities, n, values))
    }

    /// Φ = J M⁻¹ Jᵀ of the contact link at the contact point, constraints included; (6, 6), angular part first: the inverse of the
    /// operational-space inertia Λ. The lower right block is that of forces, 1/kg: 1/m̄ = n̂ᵀ Φ[3:, 3:] n̂ for a contact with the ground. Axes
    /// of the root link or of the world, as for link_frame.
    #[pyo3(signature = (contact, *, frame=None))]
    fn inverse_operational_inertia<'py>(
        &self,
        py: Python<'py>,
        contact: GivenContact<'_>,
        frame: Option<&str>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        matrix(py, &self.mobility(&contact, frame)?.view((0, 0), (6, 6)).into_owned())
    }

    /// Φ of both sides of a contact at its point; (12, 12), 1/kg and so on. Rows: six for the contact link (angular, then linear), six for
    /// the other side. 1/m̄ = wᵀΦw with w = (0, n̂, 0, −n̂). Axes as for inverse_operational_inertia, the upper left block.
    #[pyo3(signature = (contact, *, frame=None))]
    fn contact_mobility<'py>(
        &self,
        py: Python<'py>,
        contact: GivenContact<'_>,
        frame: Option<&str>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        matrix(py, &self.mobility(&contact, frame)?)
    }

    /// m̄ of many contacts of a link with the ground or with another link: points (N, 3) m and normals (N, 3), out of
    /// the link, of any nonzero length, in the link's frame. Costs some nanoseconds per contact, by Φ about the middle
    /// of the points. Returns effective_mass (N,) kg, NaN unless finite; error (N,) kg, NaN if unknown; status (N,)
    /// uint8: 0 finite, 1 immovable, 2 massless, 3 no answer.
    #[pyo3(signature = (link, points, normals, *, against=None))]
    fn contact_map<'py>(
        &self,
        py: Python<'py>,
        link: &str,
        points: &Bound<'py, PyAny>,
        normals: &Bound<'py, PyAny>,
        against: Option<&str>,
    ) -> PyResult<Answers<'py>> {
        contact_map(py, self, link, points, normals, against)
    }

    /// The three directions along which m̄ is stationary among all directions at a point (3,) m of a link, lightest
    /// first, as dicts: "effective_mass" (kg; None unless finite), "status", "error" (kg) and "direction" (a unit
    /// vector, link's frame, (3,)). None if a mass has no answer.
    #[pyo3(signature = (link, point, *, against=None))]
    fn principal_masses<'py>(
        &self,
        py: Python<'py>,
        link: &str,
        point: &Bound<'py, PyAny>,
        against: Option<&str>,
    ) -> PyResult<Option<Vec<Bound<'py, PyDict>>>> {
        principal_masses(py, self, link, point, against)
    }

    /// dm̄/dt at a contact, kg/s, at joint velocities: a dict of joints to rates (rad/s, m/s), with joints without an entry at rest; an array
    /// (n,) in the order of Model.velocity_names; or a State, which also has the twist of the root link. Mimics follow. For loops, all moving
    /// joints must be given: velocities that open loops are refused. Velocities of a Response are admissible. base_twist: (6,), angular
    /// (rad/s), then linear (m/s), of the root link at its origin, in axes of the root link or of the world as for link_frame. None unless m̄
    /// is finite with an error of at most 1e-6 m̄.
    #[pyo3(signature = (contact, velocities, *, base_twist=None, frame=None))]
    fn effective_mass_rate(
        &self,
        py: Python<'_>,
        contact: GivenContact<'_>,
        velocities: &Bound<'_, PyAny>,
        base_twist: Option<&Bound<'_, PyAny>>,
        frame: Option<&str>,
    ) -> PyResult<Option<f64>> {
        effective_mass_rate(py, self, &contact, velocities, base_twist, frame)
    }

    /// Gradient of m̄ at a contact: for each movable joint, by name, the change of m̄ per unit velocity (kg/rad, kg/m);
    /// (1,), or one entry per velocity of the joint. dm̄/dt is the sum of its products with the velocities of an admissible
    /// motion; in a mechanism with loops a single entry is not the derivative along one joint. base_gradient has the part of
    /// the root link. None unless m̄ is finite with an error of at most 1e-6 m̄.
    fn effective_mass_gradient<'py>(
        &self,
        py: Python<'py>,
        contact: GivenContact<'_>,
    ) -> PyResult<Option<Bound<'py, PyDict>>> {
        let Some(gradient) = effective_mass_gradient(py, self, &contact)? else { return Ok(None) };
        by_joint(py, &self.model.read.mechanism, &gradient.joints).map(Some)
    }

    /// Gradient of m̄ by the twist of the root link with all joints at rest: angular (kg/rad), then linear (kg/m); (6,). It is zero unless
    /// the normal is fixed in the world. Axes of the root link or of the world, as for link_frame. None as for effective_mass_gradient.
    #[pyo3(signature = (contact, *, frame=None))]
    fn base_gradient<'py>(
        &self,
        py: Python<'py>,
        contact: GivenContact<'_>,
        frame: Option<&str>,
    ) -> PyResult<Option<Bound<'py, PyArray1<f64>>>> {
        let axes = self.axes(frame)?;
        let Some(gradient) = effective_mass_gradient(py, self, &contact)? else { return Ok(None) };
        let [angular, linear] = [0, 3].map(|k| axes * Vector3::from_column_slice(&gradient.base[k..k + 3]));
        Ok(Some(PyArray1::from_vec(py, angular.iter().chain(linear.iter()).copied().collect())))
    }

    /// Accelerations of a tree at joint velocities (a dict; other joints are at rest), base (6,): the twist of a
    /// floating root (angular, linear), gravity (3,) m/s², zero by default, and forces: a list of (link, point (3,) m
    /// in the link's frame, force (3,) N). base, gravity and forces have the axes of the root link or of the world, as
    /// for link_frame. Raises InputError with loops, mimics or held points.
    #[pyo3(signature = (velocities=None, *, base=None, gravity=None, forces=Vec::new(), frame=None))]
    #[allow(clippy::too_many_arguments, reason = "what acts on the mechanism")]
    fn accelerations(
        &self,
        py: Python<'_>,
        velocities: Option<&Bound<'_, PyDict>>,
        base: Option<&Bound<'_, PyAny>>,
        gravity: Option<&Bound<'_, PyAny>>,
        forces: Vec<Bound<'_, PyAny>>,
        frame: Option<&str>,
    ) -> PyResult<Accelerations> {
        let vectors = base.is_some() || gravity.is_some() || !forces.is_empty();
        let axes = if vectors { self.axes(frame)? } else { Matrix3::identity() };
        accelerations(py, self, velocities, base, gravity, &forces, &axes)
    }

    /// The pose after a motion along v* of a response at this pose until the gap has closed by a distance (m; negative:
    /// opened), with the loops closed again: exact to second order. None if the loops do not close there, or if nothing
    /// moves.
    fn advanced_along(&self, py: Python<'_>, response: &Response, distance: f64) -> PyResult<Option<Self>> {
        if !Arc::ptr_eq(&response.pose.model.read.mechanism, &self.model.read.mechanism) {
            return Err(input("the response is of another model; expected one of this pose"));
        }
        if !distance.is_finite() {
            return Err(input(format_args!("distance is {distance}; expected a finite number")));
        }
        let coordinates = self.pose.positions().len();
        let pose = interruptible_if_large(py, coordinates, || {
            self.pose.advanced_along(&response.response, distance)
        })?;
        Ok(pose.map(|pose| Self { pose, ..self.clone() }))
    }

    /// Joints outside their limits: joint to (position, (lower, upper)), rad or m.
    fn outside_limits(&self) -> BTreeMap<String, (f64, (f64, f64))> {
        let name = |joint| self.model.read.mechanism.joint(joint).name().to_owned();
        let outside = self.pose.outside_limits();
        outside.map(|(joint, at, limits)| (name(joint), (at, (limits.lower, limits.upper)))).collect()
    }

    /// Rank report of A at this pose: "rank"; "gap", the least gap between counted singular values and those taken as
    /// zero (None without rows); "is_clear"; "is_singular".
    fn rank<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let (report, rank) = (PyDict::new(py), self.pose.rank());
        report.set_item("rank", rank.rank)?;
        report.set_item("gap", rank.gap)?;
        report.set_item("is_clear", rank.clear)?;
        report.set_item("is_singular", rank.singular)?;
        Ok(report)
    }

    /// m̄ at a contact, and the quantities derived from it. route: "auto", "dense" (O(n³)) or "articulated" (O(n)).
    #[pyo3(signature = (contact, *, route="auto"))]
    fn respond(&self, py: Python<'_>, contact: GivenContact<'_>, route: &str) -> PyResult<Response> {
        let (contact, route) = (contact.resolve(&self.model.read.mechanism)?, route_choice(route)?);
        let coordinates = self.pose.positions().len();
        let response =
            interruptible_if_large(py, coordinates, || self.pose.respond_by_route(&contact, route))?
                .map_err(errors::response)?;
        let own = self.clone();
        Ok(Response { pose: own, contact, route, masses: Vec::new(), response })
    }

    /// Conditions of the system, and the pose.
    #[getter]
    fn _conditions<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyDict>> {
        let conditions = slf.get().system.keywords(slf.py())?.into_py_dict(slf.py())?;
        conditions.set_item("pose", slf)?;
        Ok(conditions)
    }

    /// Pickles a pose as its system or assembly, and all positions. The loops are closed again: to rounding.
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Rebuilt<'py>> {
        let base = self.pose.base();
        let base = (*base != Transform::identity()).then(|| seven_numbers(base));
        let keywords =
            [("base_pose", base.into_bound_py_any(py)?), ("other_assembly", true.into_bound_py_any(py)?)];
        let system = self.system.clone().into_bound_py_any(py)?;
        let owner = match self.guess.is_empty() {
            true => system,
            false => system.call_method1("assemble", (by_name(py, &self.guess)?,))?,
        };
        result_of(owner, "pose", (self.positions(py),), &keywords)
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
