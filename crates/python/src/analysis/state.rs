//! `percuss.State` as an argument in place of positions.

use crate::analysis::model::Model;
use crate::conversion::errors::input;
use percuss::Mechanism;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyAny, PyType};
use std::sync::Arc;

/// Class `percuss.State`.
static STATE: PyOnceLock<Py<PyType>> = PyOnceLock::new();

/// Value of an argument, if it is given.
pub type Given<'py> = Option<Bound<'py, PyAny>>;

/// True if an argument is a State. Checks that its model is `mechanism`, or has joints of the same names and kinds.
pub fn is_state(given: &Bound<'_, PyAny>, mechanism: &Arc<Mechanism>) -> PyResult<bool> {
    if !given.is_instance(STATE.import(given.py(), "percuss.state", "State")?)? {
        return Ok(false);
    }
    let model = given.getattr("model")?;
    let own = &model.cast::<Model>()?.get().read.mechanism;
    let is_same = || {
        let joints = own.joints().iter().zip(mechanism.joints());
        own.joints().len() == mechanism.joints().len()
            && joints.into_iter().all(|(a, b)| a.name() == b.name() && a.kind() == b.kind())
    };
    match Arc::ptr_eq(own, mechanism) || is_same() {
        true => Ok(true),
        false => Err(input(format_args!(
            "the State is of the model \"{}\"; expected one of the model \"{}\"",
            own.name(),
            mechanism.name()
        ))),
    }
}

/// Positions and base pose of a State; other values are returned as they are.
pub fn positions_and_base<'py>(
    q: &Bound<'py, PyAny>,
    base_pose: Option<&Bound<'py, PyAny>>,
    mechanism: &Arc<Mechanism>,
) -> PyResult<(Bound<'py, PyAny>, Given<'py>)> {
    if !is_state(q, mechanism)? {
        return Ok((q.clone(), base_pose.cloned()));
    }
    if base_pose.is_some() {
        return Err(input(
            "base_pose: the State has its own; expected a State without base_pose, or no base_pose",
        ));
    }
    Ok((q.getattr("positions")?, attribute(q, "base_pose")?))
}

/// Attribute of a State; `None` if it is absent.
pub fn attribute<'py>(state: &Bound<'py, PyAny>, name: &str) -> PyResult<Given<'py>> {
    Ok(Some(state.getattr(name)?).filter(|value| !value.is_none()))
}
