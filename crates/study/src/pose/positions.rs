//! Joint positions of poses by name. The names are stored once and shared by all poses.

use crate::values::quantities::schema_of;
use nalgebra::Vector3;
use percuss_dynamics::Pose;
use percuss_mechanism::{JointId, JointKind, Mechanism};
use serde::ser::{Serialize, Serializer};
use std::ops::Range;
use std::sync::Arc;

/// Names of the movable joints, and the layout of the numbers of a pose.
#[derive(Debug, PartialEq)]
pub struct PoseLayout {
    joints: Vec<JointSlot>,
}

#[derive(Debug, PartialEq)]
struct JointSlot {
    name: String,
    joint: JointId,
    kind: JointKind,
    range: Range<usize>,
    /// Index of the first number of the joint in the list of all joints, in joint order.
    column: usize,
}

impl PoseLayout {
    /// Layout of the poses of a mechanism.
    pub(crate) fn new(mechanism: &Mechanism) -> Arc<Self> {
        let mut movable: Vec<JointId> =
            mechanism.joint_ids().filter(|id| mechanism.joint(*id).kind().dofs() > 0).collect();
        movable.sort_by_key(|id| mechanism.joint(*id).name());
        let places: Vec<Range<usize>> = mechanism.position_ranges().collect();
        let mut first = 0;
        let numbered = |joint: JointId| {
            let numbers = first..first + mechanism.joint(joint).kind().positions();
            first = numbers.end;
            JointSlot {
                name: mechanism.joint(joint).name().to_owned(),
                joint,
                kind: mechanism.joint(joint).kind(),
                range: numbers,
                column: places[joint.index()].start,
            }
        };
        Arc::new(Self { joints: movable.into_iter().map(numbered).collect() })
    }

    /// Names of the joints, and the number of values of each position.
    pub fn joints(&self) -> impl Iterator<Item = (&str, usize)> {
        self.joints.iter().map(|joint| (joint.name.as_str(), joint.range.len()))
    }
}

/// Displacement of a joint from its position 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum JointDisplacement {
    /// Angle of the rotation, rad.
    Turn(f64),
    /// Translation along the axis, m.
    Shift(f64),
    /// Rotation, rad, and translation in the axes of the joint, m.
    TurnAndShift {
        /// Angle of the rotation.
        angle: f64,
        /// Translation.
        shift: [f64; 3],
    },
}

/// Position of every movable joint, in the layout of `--set`; empty for an unreachable pose. In JSON: an object
/// with a list per joint name.
#[derive(Clone, Debug, PartialEq)]
pub struct Positions {
    layout: Arc<PoseLayout>,
    values: Vec<f64>,
}

impl Positions {
    /// Positions of a pose.
    pub(crate) fn from_pose(layout: &Arc<PoseLayout>, pose: &Pose) -> Self {
        let values = layout.joints.iter().flat_map(|joint| pose.joint(joint.joint)).copied().collect();
        Self { layout: Arc::clone(layout), values }
    }

    /// Positions from those of all joints, in joint order.
    pub(crate) fn from_list(layout: &Arc<PoseLayout>, all: &[f64]) -> Self {
        let values = layout.joints.iter().flat_map(|joint| &all[joint.column..][..joint.range.len()]);
        Self { layout: Arc::clone(layout), values: values.copied().collect() }
    }

    /// Positions of a row without a pose.
    pub(crate) fn none(layout: &Arc<PoseLayout>) -> Self {
        Self { layout: Arc::clone(layout), values: Vec::new() }
    }

    /// Positions by name; empty without a pose.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &[f64])> {
        let known = self.layout.joints.iter().filter(|joint| joint.range.end <= self.values.len());
        known.map(|joint| (joint.name.as_str(), &self.values[joint.range.clone()]))
    }

    /// All values in sequence; empty without a pose.
    pub fn numbers(&self) -> &[f64] {
        &self.values
    }

    /// Position of a joint.
    pub fn get(&self, name: &str) -> Option<&[f64]> {
        let at = self.layout.joints.binary_search_by(|joint| joint.name.as_str().cmp(name)).ok()?;
        self.values.get(self.layout.joints[at].range.clone())
    }

    /// Displacement of a joint from its position 0; `None` for an unknown joint or without a pose.
    pub fn displacement(&self, name: &str) -> Option<JointDisplacement> {
        let at = self.layout.joints.binary_search_by(|joint| joint.name.as_str().cmp(name)).ok()?;
        let rotation = |q: &[f64]| Vector3::new(q[1], q[2], q[3]).norm().atan2(q[0].abs()) * 2.0;
        match (self.layout.joints[at].kind, self.get(name)?) {
            (JointKind::Revolute | JointKind::Continuous, [angle]) => Some(JointDisplacement::Turn(*angle)),
            (JointKind::Prismatic, [shift]) => Some(JointDisplacement::Shift(*shift)),
            (JointKind::Planar, [x, y, angle]) => {
                Some(JointDisplacement::TurnAndShift { angle: *angle, shift: [*x, *y, 0.0] })
            }
            (JointKind::Spherical, q @ [_, _, _, _]) => Some(JointDisplacement::Turn(rotation(q))),
            (JointKind::Floating, [x, y, z, q @ ..]) if q.len() == 4 => {
                Some(JointDisplacement::TurnAndShift { angle: rotation(q), shift: [*x, *y, *z] })
            }
            _ => None,
        }
    }

    /// Positions of all joints in joint order, 0 for the joints without a degree of freedom; empty without a pose.
    pub(crate) fn in_joint_order(&self) -> Vec<f64> {
        let joints = &self.layout.joints;
        let count = joints.iter().map(|joint| joint.column + joint.range.len()).max().unwrap_or(0);
        let mut all = vec![0.0; if self.values.is_empty() { 0 } else { count }];
        for joint in joints {
            if let Some(values) = self.values.get(joint.range.clone()) {
                all[joint.column..joint.column + values.len()].copy_from_slice(values);
            }
        }
        all
    }

    /// Number of joints with a position.
    pub fn len(&self) -> usize {
        self.iter().count()
    }

    /// True if no joint can move, or there is no pose.
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }
}

schema_of!(Positions, std::collections::BTreeMap<String, Vec<f64>>);

impl Serialize for Positions {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.iter())
    }
}
