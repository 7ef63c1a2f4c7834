//! Joint of a cluster of mimics, as a part of the plan.

/// Largest number of coordinates of a cluster.
pub(super) const MOST: usize = 4;

/// Joint of a cluster.
#[derive(Clone, Debug)]
pub(super) struct ClusterJoint {
    /// Index of the cluster.
    pub cluster: usize,
    /// Index of the body within the cluster, and of its parent body; `None` for the parent of the cluster.
    pub body: usize,
    pub parent: Option<usize>,
    /// Coordinate, multiplier and armature; `None` for a locked joint.
    pub velocity: Option<(usize, f64, f64)>,
    /// For each coordinate: true if joints beyond this one have it.
    pub beyond: [bool; MOST],
    /// True for the joint that is visited last.
    pub is_last: bool,
}
