//! Where the joints of a pose stand, by name: the names once, the numbers for every pose.

use percuss_dynamics::Pose;
use percuss_mechanism::{JointId, Mechanism};
use serde::ser::{Serialize, SerializeMap, Serializer};
use std::ops::Range;
use std::sync::Arc;

/// The joints that can move, by name, and where each stands among the numbers of a pose.
#[derive(Debug, PartialEq)]
pub struct PoseLayout {
    joints: Vec<JointNumbers>,
}

#[derive(Debug, PartialEq)]
struct JointNumbers {
    name: String,
    joint: JointId,
    numbers: Range<usize>,
    /// Its first number among those of all joints, in joint order.
    place: usize,
}

impl PoseLayout {
    /// The layout of a mechanism's poses.
    pub(crate) fn new(mechanism: &Mechanism) -> Arc<Self> {
        let mut movable: Vec<JointId> =
            mechanism.joint_ids().filter(|id| mechanism.joint(*id).kind().dofs() > 0).collect();
        movable.sort_by_key(|id| mechanism.joint(*id).name());
        let mut places = Vec::with_capacity(mechanism.joints().len());
        let mut place = 0;
        for joint in mechanism.joints() {
            places.push(place);
            place += joint.kind().positions();
        }
        let mut first = 0;
        let numbered = |joint: JointId| {
            let numbers = first..first + mechanism.joint(joint).kind().positions();
            first = numbers.end;
            JointNumbers {
                name: mechanism.joint(joint).name().to_owned(),
                joint,
                numbers,
                place: places[joint.index()],
            }
        };
        Arc::new(Self { joints: movable.into_iter().map(numbered).collect() })
    }

    /// The joints, and how many numbers each position has.
    pub fn joints(&self) -> impl Iterator<Item = (&str, usize)> {
        self.joints.iter().map(|joint| (joint.name.as_str(), joint.numbers.len()))
    }
}

/// Position of every movable joint, in the layout of `--set`; empty where a pose was not reached. In JSON a list for
/// each name.
#[derive(Clone, Debug, PartialEq)]
pub struct Positions {
    layout: Arc<PoseLayout>,
    values: Vec<f64>,
}

impl Positions {
    pub(crate) fn of(layout: &Arc<PoseLayout>, pose: &Pose) -> Self {
        let values = layout.joints.iter().flat_map(|joint| pose.joint(joint.joint)).copied().collect();
        Self { layout: Arc::clone(layout), values }
    }

    /// Of row `i` of some, whose numbers stand in columns of so many rows, those of all joints in joint order.
    pub(crate) fn of_columns(layout: &Arc<PoseLayout>, columns: &[f64], rows: usize, i: usize) -> Self {
        let places = layout.joints.iter().flat_map(|joint| joint.place..joint.place + joint.numbers.len());
        let values = places.map(|place| columns[place * rows + i]).collect();
        Self { layout: Arc::clone(layout), values }
    }

    pub(crate) fn none(layout: &Arc<PoseLayout>) -> Self {
        Self { layout: Arc::clone(layout), values: Vec::new() }
    }

    /// The positions by name; nothing where there is no pose.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &[f64])> {
        let known = self.layout.joints.iter().filter(|joint| joint.numbers.end <= self.values.len());
        known.map(|joint| (joint.name.as_str(), &self.values[joint.numbers.clone()]))
    }

    /// All numbers one after another; none where there is no pose.
    pub fn numbers(&self) -> &[f64] {
        &self.values
    }

    /// The position of a joint.
    pub fn get(&self, name: &str) -> Option<&[f64]> {
        let at = self.layout.joints.binary_search_by(|joint| joint.name.as_str().cmp(name)).ok()?;
        self.values.get(self.layout.joints[at].numbers.clone())
    }

    /// How many joints can move.
    pub fn len(&self) -> usize {
        self.iter().count()
    }

    /// Whether none can, or there is no pose.
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }
}

impl Serialize for Positions {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        for (joint, values) in self.iter() {
            map.serialize_entry(joint, values)?;
        }
        map.end()
    }
}
