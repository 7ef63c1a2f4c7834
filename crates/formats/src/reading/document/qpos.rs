//! Positions of MuJoCo (`qpos`) as positions of the mechanism.

use nalgebra::{Rotation3, UnitQuaternion};
use percuss_spatial::{Transform, Vector3};
use std::ops::Range;

/// Layout of `qpos` of a model in MJCF: converts positions of MuJoCo to positions of the mechanism.
///
/// MuJoCo has `ref` as the position of a hinge or a slide as drawn, and the pose in the world for a free joint; percuss has 0 as drawn, and
/// for a free joint the pose relative to the drawing. The order of the joints may differ.
#[derive(Clone, Debug)]
pub struct QposLayout {
    /// Number of entries of `qpos`.
    pub(crate) count: usize,
    pub(crate) joints: Vec<QposJoint>,
    pub(crate) lengths: Vec<LengthJoint>,
    /// Positions of all joints as drawn.
    pub(crate) drawn: Vec<f64>,
    /// True if MuJoCo moves the frame of a free body to its centre of mass.
    pub(crate) is_aligned: bool,
}

/// Joint of MuJoCo.
#[derive(Clone, Debug)]
pub(crate) struct QposJoint {
    pub name: String,
    pub qpos: Range<usize>,
    /// Positions of the joint of the mechanism; `None` for a locked joint and for a mimic, which are not written.
    pub own: Option<Range<usize>>,
    pub reference: f64,
    /// Pose of the body as drawn (in the world for a free joint).
    pub pose: Transform<f64>,
}

/// Length joint of a tendon with an armature, which follows the joints of the tendon.
#[derive(Clone, Debug)]
pub(crate) struct LengthJoint {
    pub name: String,
    pub own: usize,
    pub factor: f64,
    pub constant: f64,
    /// Index and value as drawn of a number of `qpos`, and its factor.
    pub terms: Vec<(usize, f64, f64)>,
}

/// Error of positions of MuJoCo.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum QposError {
    /// Wrong number of entries.
    #[error("qpos has {got} numbers; expected {expected}, the positions of all joints")]
    Count {
        /// Number of entries.
        got: usize,
        /// Number of positions of the joints of the model in MuJoCo.
        expected: usize,
    },
    /// Wrong number of positions of the mechanism.
    #[error("the output has space for {got} positions; expected {expected}, the positions of all joints")]
    PositionCount {
        /// Length of the output.
        got: usize,
        /// Number of positions of the mechanism.
        expected: usize,
    },
    /// An entry is NaN or infinite.
    #[error("qpos[{index}] is {value}; expected finite numbers")]
    NotFinite {
        /// Index of the entry.
        index: usize,
        /// The entry.
        value: f64,
    },
    /// A quaternion is zero, or its norm is not a number in double precision.
    #[error("the quaternion of joint \"{joint}\" has no norm; expected w, x, y, z of length 1")]
    Quaternion {
        /// The joint.
        joint: String,
    },
    /// The model has an aligned free body.
    #[error(
        "MuJoCo moves the frame of an aligned free body, and qpos refers to that frame; set alignfree=\"false\" in <compiler>, or align=\"false\" in <freejoint>"
    )]
    Aligned,
}

impl QposLayout {
    /// Number of entries of `qpos`: `nq` of MuJoCo.
    pub fn qpos_count(&self) -> usize {
        self.count
    }

    /// Writes the positions of all joints of the mechanism, in joint order, for `qpos` of MuJoCo. Positions of mimics and locked
    /// joints are as drawn; they are not read. Allocates nothing.
    ///
    /// # Errors
    /// [`QposError`]; `positions` is then unchanged.
    pub fn convert(&self, qpos: &[f64], positions: &mut [f64]) -> Result<(), QposError> {
        let (got, expected) = (positions.len(), self.drawn.len());
        if got != expected {
            return Err(QposError::PositionCount { got, expected });
        }
        if qpos.len() != self.count {
            return Err(QposError::Count { got: qpos.len(), expected: self.count });
        }
        if self.is_aligned {
            return Err(QposError::Aligned);
        }
        if let Some(index) = qpos.iter().position(|value| !value.is_finite()) {
            return Err(QposError::NotFinite { index, value: qpos[index] });
        }
        for joint in &self.joints {
            if let [.., w, x, y, z] = qpos[joint.qpos.clone()]
                && !(w * w + x * x + y * y + z * z).is_normal()
            {
                return Err(QposError::Quaternion { joint: joint.name.clone() });
            }
        }
        positions.copy_from_slice(&self.drawn);
        for joint in &self.joints {
            if let Some(own) = &joint.own {
                joint.convert(&qpos[joint.qpos.clone()], &mut positions[own.clone()]);
            }
        }
        for length in &self.lengths {
            let terms = length.terms.iter().map(|(index, drawn, factor)| factor * (qpos[*index] - drawn));
            positions[length.own] = (length.constant - terms.sum::<f64>()) / length.factor;
        }
        Ok(())
    }

    /// Positions by joint for a `qpos`, or as drawn; without mimics and locked joints.
    pub(crate) fn by_name(&self, qpos: Option<&[f64]>) -> Result<Vec<(String, Vec<f64>)>, QposError> {
        let mut all = self.drawn.clone();
        match qpos {
            Some(qpos) => self.convert(qpos, &mut all)?,
            None => self.lengths.iter().for_each(|length| all[length.own] = length.constant / length.factor),
        }
        let joints = self.joints.iter().filter_map(|joint| Some((&joint.name, joint.own.clone()?)));
        let lengths = self.lengths.iter().map(|length| (&length.name, length.own..length.own + 1));
        Ok(joints.chain(lengths).map(|(name, own)| (name.clone(), all[own].to_vec())).collect())
    }
}

impl QposJoint {
    /// Writes the position of the joint of the mechanism.
    fn convert(&self, qpos: &[f64], to: &mut [f64]) {
        let unit = |w, x, y, z| UnitQuaternion::from_quaternion(nalgebra::Quaternion::new(w, x, y, z));
        match *qpos {
            [value] => to[0] = value - self.reference,
            [w, x, y, z] => {
                let q = unit(w, x, y, z);
                to.copy_from_slice(&[q.w, q.i, q.j, q.k]);
            }
            [px, py, pz, w, x, y, z] => {
                let pose = &self.pose;
                let at = pose.inverse_vector(&(Vector3::new(px, py, pz) - pose.translation));
                let drawn =
                    UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(pose.rotation));
                let q = drawn.inverse() * unit(w, x, y, z);
                to.copy_from_slice(&[at.x, at.y, at.z, q.w, q.i, q.j, q.k]);
            }
            _ => {}
        }
    }
}
