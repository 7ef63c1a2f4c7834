//! Poses: a mechanism at one configuration. The Python methods are in `pose_methods.rs`.

use crate::analysis::model::Model;
use crate::analysis::system::System;
use crate::conversion::errors::input;
use percuss::Pose as Posed;
use percuss::nalgebra::Matrix3;
use percuss::spatial::Transform;
use pyo3::prelude::*;
use std::sync::Arc;

/// Mechanism at one configuration with closed loops. Immutable, so that threads can share it.
///
///     >>> model.pose({"crank_hinge": 0.4}).respond(contact).effective_mass
#[pyclass(frozen, module = "percuss")]
#[derive(Clone, Debug)]
pub struct Pose {
    pub model: Model,
    pub system: System,
    /// Guess of its assembly: joint and position.
    pub guess: Arc<Vec<(String, Vec<f64>)>>,
    pub pose: Posed,
}

impl Pose {
    /// Transform from the root link's frame to the frame of the caller's vectors.
    ///
    /// frame: "root", "world", or `None`. `None` is accepted only if both frames are the same, because no base_pose
    /// moves the root link.
    pub fn frame(&self, frame: Option<&str>) -> PyResult<Transform<f64>> {
        let base = self.pose.base();
        match frame {
            Some("root") => Ok(Transform::identity()),
            Some("world") => Ok(*base),
            None if *base == Transform::identity() => Ok(Transform::identity()),
            None => Err(input(
                "the pose has a base_pose, so the root link's frame is not the world's; expected frame=\"root\" or \
                 frame=\"world\"",
            )),
            Some(other) => Err(input(format_args!("frame is \"{other}\"; expected \"root\" or \"world\""))),
        }
    }

    /// The rotation of [`frame`](Self::frame).
    pub fn axes(&self, frame: Option<&str>) -> PyResult<Matrix3<f64>> {
        Ok(self.frame(frame)?.rotation)
    }
}
