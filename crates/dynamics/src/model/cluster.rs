//! Clusters: bodies that constraints or mimics bind together, with everything between them. Seen from outside, the
//! mechanism is a tree of clusters; a plain joint is a cluster of one.

/// A tree velocity within a cluster.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ClusterVelocity {
    /// Its body, by index into the cluster's.
    pub body: usize,
    pub component: usize,
    /// The coordinate it follows, by index into the cluster's, and its multiplier.
    pub coordinate: usize,
    pub multiplier: f64,
    pub armature: f64,
    /// Among the tree's velocities.
    pub index: usize,
}

/// A group's place in a cluster.
#[derive(Clone, Debug)]
pub(crate) struct ClusterGroup {
    pub group: usize,
    /// For each coordinate of the group, its index into the cluster's.
    pub coordinates: Vec<usize>,
}

/// Bodies bound together, with everything between them, carried by one body or the ground.
#[derive(Clone, Debug, Default)]
pub(crate) struct Cluster {
    /// Parents first.
    pub bodies: Vec<usize>,
    /// For each body, the index (into the cluster's) of the body that carries it; none where that is outside.
    pub parents: Vec<Option<usize>>,
    /// The body outside that carries it all; none: the ground.
    pub parent: Option<usize>,
    /// Whether anything binds it; else it is one body whose velocities are coordinates of their own.
    pub is_bound: bool,
    /// Indices of coordinates, ascending.
    pub coordinates: Vec<usize>,
    /// Body by body.
    pub velocities: Vec<ClusterVelocity>,
    pub groups: Vec<ClusterGroup>,
}
