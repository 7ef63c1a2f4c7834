//! Poses: a mechanism at one configuration. What Python asks of one: `pose_methods.rs`.

use crate::model::Model;
use percuss::{Pose as Posed, System};
use pyo3::prelude::*;

/// A mechanism at one configuration, its loops closed. Cannot be changed: threads may share it.
#[pyclass(frozen, module = "percuss")]
#[derive(Clone, Debug)]
pub struct Pose {
    pub model: Model,
    pub system: System,
    pub pose: Posed,
}
