//! m̄ of many contacts of a link at one pose.

use crate::analysis::pose::Pose;
use crate::analysis::response::{status, value};
use crate::conversion::arrays::{float64_matrix, shape, triple};
use crate::conversion::errors::{input, of_argument};
use crate::conversion::labels::AXES;
use crate::conversion::threads::interruptible_if_large;
use numpy::ndarray::{ArrayView2, s};
use numpy::{PyArray1, PyReadonlyArray2, PyUntypedArrayMethods};
use percuss::LinkId;
use percuss::nalgebra::Vector3;
use pyo3::prelude::*;
use pyo3::types::{PyAny, PyDict};

/// Number of contacts between two checks for Ctrl-C.
const PORTION: usize = 1 << 18;

/// m̄ (kg), its error (kg), status code.
pub type Answers<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<u8>>);

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

/// Contact link, and the link on the other side.
fn links(pose: &Pose, link: &str, against: Option<&str>) -> PyResult<(LinkId, Option<LinkId>)> {
    let mechanism = &pose.model.read.mechanism;
    let link = mechanism.find_link(link).map_err(input)?;
    let against = against.map(|link| mechanism.find_link(link)).transpose();
    Ok((link, against.map_err(|error| of_argument("against")(input(error)))?))
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
    let (link, against) = links(pose, link, against)?;
    let rows = |array: &PyReadonlyArray2<'_, f64>| -> Vec<[f64; 3]> {
        array.as_array().rows().into_iter().map(|row| [row[0], row[1], row[2]]).collect()
    };
    let (points, normals) = (rows(&points), rows(&normals));
    let size = count.max(pose.pose.positions().len());
    let found =
        interruptible_if_large(py, size, || pose.pose.contact_masses(link, against, &points, &normals))?;
    let found = found.map_err(input)?;
    let codes = found.statuses.into_iter().map(u8::from).collect();
    let [masses, errors] = [found.masses, found.errors].map(|numbers| PyArray1::from_vec(py, numbers));
    Ok((masses, errors, PyArray1::from_vec(py, codes)))
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
    let (link, against) = links(pose, link, against)?;
    let found = py.detach(|| pose.pose.principal_masses(link, against, point)).map_err(input)?;
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
