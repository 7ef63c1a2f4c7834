//! m̄ of many contacts of a link at one pose.

use crate::analysis::pose::Pose;
use crate::analysis::response::{status, value};
use crate::conversion::arrays::{float64_matrix, shape, triple};
use crate::conversion::errors::{input, of_argument};
use crate::conversion::labels::AXES;
use crate::conversion::threads::interruptible_if_large;
use numpy::ndarray::{ArrayView2, s};
use numpy::{PyArray1, PyUntypedArrayMethods};
use percuss::nalgebra::Vector3;
use percuss::{ContactColumns, ContactMap, ContactStatus, MapAnswers};
use pyo3::prelude::*;
use pyo3::types::{PyAny, PyDict};

/// Number of contacts between two checks for Ctrl-C.
const PORTION: usize = 1 << 18;

/// m̄ (kg), its error (kg), status code.
pub type Answers<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<u8>>);

/// Contact map: Φ of a link about `centre`, for contacts within the radius `reach` (m).
fn contact_map_about<'a>(
    pose: &'a Pose,
    link: &str,
    against: Option<&str>,
    centre: Vector3<f64>,
    reach: f64,
) -> PyResult<ContactMap<'a>> {
    let mechanism = &pose.model.read.mechanism;
    let link = mechanism.find_link(link).map_err(input)?;
    let against = against.map(|link| mechanism.find_link(link)).transpose();
    let against = against.map_err(|error| of_argument("against")(input(error)))?;
    pose.pose.contact_map(link, against, centre, reach).map_err(input)
}

/// The three columns of an (N, 3) array.
fn columns(values: ArrayView2<'_, f64>) -> [Vec<f64>; 3] {
    [0, 1, 2].map(|axis| values.column(axis).iter().copied().collect())
}

/// Refuses entries that are not finite; checks for Ctrl-C.
fn check_finite(py: Python<'_>, values: ArrayView2<'_, f64>, what: &str) -> PyResult<()> {
    for first in (0..values.nrows()).step_by(PORTION) {
        let part = values.slice(s![first..values.nrows().min(first + PORTION), ..]);
        if let Some(((row, axis), bad)) = part.indexed_iter().find(|(_, x)| !x.is_finite()) {
            let row = first + row;
            return Err(input(format_args!("{what}[{row}, {axis}] is {bad}; expected finite numbers")));
        }
        py.check_signals()?;
    }
    Ok(())
}

/// Least and greatest entries of the three columns; checks for Ctrl-C.
fn bounds(py: Python<'_>, values: ArrayView2<'_, f64>) -> PyResult<[[f64; 2]; 3]> {
    let mut found = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
    for first in (0..values.nrows()).step_by(PORTION) {
        let part = values.slice(s![first..values.nrows().min(first + PORTION), ..]);
        for (axis, [least, most]) in found.iter_mut().enumerate() {
            for x in part.column(axis) {
                (*least, *most) = (least.min(*x), most.max(*x));
            }
        }
        py.check_signals()?;
    }
    Ok(if values.nrows() == 0 { [[0.0; 2]; 3] } else { found })
}

/// m̄ of many contacts of a link.
pub fn contact_map<'py>(
    py: Python<'py>,
    pose: &Pose,
    link: &str,
    points: &Bound<'py, PyAny>,
    normals: &Bound<'py, PyAny>,
    against: Option<&str>,
) -> PyResult<Answers<'py>> {
    let points = float64_matrix(points, "points", "(N, 3)", &AXES, "")?;
    let normals = float64_matrix(normals, "normals", "(N, 3)", &AXES, "")?;
    let count = points.shape()[0];
    for (what, array) in [("points", &points), ("normals", &normals)] {
        if array.shape() != [count, 3] {
            let expected =
                if what == "points" { "(N, 3)".to_owned() } else { shape(&[count, 3]) + ", as points" };
            return Err(input(format_args!(
                "{what} has shape {}; expected {expected}",
                shape(array.shape())
            )));
        }
        check_finite(py, array.as_array(), what)?;
    }
    let (points, normals) = (points.as_array(), normals.as_array());
    // Φ refers to the middle of a box around the points; error bounds hold for contacts in this box.
    let bounds = bounds(py, points)?;
    let centre = Vector3::from_fn(|axis, _| 0.5 * (bounds[axis][0] + bounds[axis][1]));
    let reach = Vector3::from_fn(|axis, _| 0.5 * (bounds[axis][1] - bounds[axis][0])).norm();
    let coordinates = pose.pose.positions().len();
    let map =
        interruptible_if_large(py, coordinates, || contact_map_about(pose, link, against, centre, reach))??;
    let (mut masses, mut errors) = (vec![0.0; count], vec![0.0; count]);
    let mut statuses = vec![ContactStatus::Finite; count];
    for first in (0..count).step_by(PORTION) {
        let rows = first..count.min(first + PORTION);
        let part = |all: &ArrayView2<'_, f64>| columns(all.slice(s![rows.clone(), ..]));
        let (points, normals) = (part(&points), part(&normals));
        let mut answers = MapAnswers {
            masses: &mut masses[rows.clone()],
            errors: &mut errors[rows.clone()],
            statuses: &mut statuses[rows.clone()],
        };
        let contacts = ContactColumns {
            points: [&points[0], &points[1], &points[2]],
            normals: [&normals[0], &normals[1], &normals[2]],
        };
        interruptible_if_large(py, rows.len(), || map.fill_answers(contacts, &mut answers))?
            .map_err(input)?;
        py.check_signals()?;
    }
    for ((mass, error), status) in masses.iter_mut().zip(&mut errors).zip(&statuses) {
        // Errors of a map are relative.
        *error *= *mass;
        if *status != ContactStatus::Finite {
            (*mass, *error) = (f64::NAN, f64::NAN);
        }
    }
    let codes = statuses.into_iter().map(u8::from).collect();
    Ok((PyArray1::from_vec(py, masses), PyArray1::from_vec(py, errors), PyArray1::from_vec(py, codes)))
}

/// Three directions along which m̄ is stationary at a point (link's frame, m), each a dict with its m̄; None if one of them cannot be
/// computed.
pub fn principal_masses<'py>(
    py: Python<'py>,
    pose: &Pose,
    link: &str,
    point: &Bound<'py, PyAny>,
    against: Option<&str>,
) -> PyResult<Option<Vec<Bound<'py, PyDict>>>> {
    let point = Vector3::from(triple(point, "point")?);
    let found = py.detach(|| {
        PyResult::Ok(contact_map_about(pose, link, against, point, 0.0)?.principal_masses(&point))
    })?;
    let Some(found) = found else { return Ok(None) };
    let one = |principal: percuss::PrincipalMass| {
        let record = PyDict::new(py);
        record.set_item("effective_mass", value(principal.mass))?;
        record.set_item("status", status(principal.mass))?;
        record.set_item("error", principal.error)?;
        record.set_item("direction", PyArray1::from_slice(py, principal.direction.as_slice()))?;
        Ok(record)
    };
    found.into_iter().map(one).collect::<PyResult<_>>().map(Some)
}
