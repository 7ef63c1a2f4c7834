//! Clusters: bodies coupled by constraints or mimics, including all bodies between them. The clusters form a tree; a
//! plain joint is a cluster of one body.

/// Tree velocity within a cluster.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ClusterVelocity {
    /// Index of the body within the cluster.
    pub body: usize,
    pub component: usize,
    /// Index of the coordinate within the cluster, and the multiplier of the velocity.
    pub coordinate: usize,
    pub multiplier: f64,
    pub armature: f64,
    /// Index among the tree velocities.
    pub index: usize,
}

/// Group of constraints within a cluster.
#[derive(Clone, Debug)]
pub(crate) struct ClusterGroup {
    pub group: usize,
    /// For each coordinate of the group: its index within the cluster.
    pub coordinates: Vec<usize>,
}

/// Coupled bodies, including all bodies between them, with one parent body or the ground.
#[derive(Clone, Debug, Default)]
pub(crate) struct Cluster {
    /// Bodies, parents first.
    pub bodies: Vec<usize>,
    /// For each body: index of its parent within the cluster; `None` for a parent outside the cluster.
    pub parents: Vec<Option<usize>>,
    /// Parent body of the cluster; `None` for the ground.
    pub parent: Option<usize>,
    /// True if constraints or mimics couple the cluster; otherwise the cluster is one body with independent
    /// velocities.
    pub is_bound: bool,
    /// Indices of the coordinates, ascending.
    pub coordinates: Vec<usize>,
    /// Velocities, body by body.
    pub velocities: Vec<ClusterVelocity>,
    pub groups: Vec<ClusterGroup>,
}
