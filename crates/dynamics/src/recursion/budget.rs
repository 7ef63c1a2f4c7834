//! Work and memory of the clusters' matrices, computed before any matrix is formed.

use crate::kinematics::outcome::RouteError;
use crate::mobility::GroupMobility;
use crate::model::{Cluster, ClusterGroup, Model};
use crate::tolerances::{CLUSTER_BYTES, CLUSTER_WORK, LARGE_CLUSTER};

/// Cost of a cluster.
#[derive(Clone, Copy, Default)]
struct Cost {
    /// Independent coordinates.
    freedoms: usize,
    bytes: f64,
    /// Multiplications.
    work: f64,
}

impl Model {
    /// Refuses clusters whose matrices over a scalar need too much memory or time. Allocates nothing.
    pub fn refuse_large_clusters(&self, groups: &[GroupMobility]) -> Result<(), RouteError> {
        let (mut bytes, mut work) = (0.0, 0.0);
        let mut most: Option<(&Cluster, Cost)> = None;
        for cluster in self.clusters.iter().filter(|cluster| cluster.is_bound) {
            let cost = cluster_cost(cluster, groups);
            bytes += cost.bytes;
            work += cost.work;
            if most.is_none_or(|(_, known)| cost.bytes > known.bytes) {
                most = Some((cluster, cost));
            }
        }
        match most {
            Some((cluster, cost)) if bytes > CLUSTER_BYTES as f64 || work > CLUSTER_WORK => {
                let names = |own: &ClusterGroup| self.group_names(&self.groups[own.group]);
                Err(RouteError::ClusterTooLarge {
                    loops: cluster.groups.iter().flat_map(names).collect(),
                    coordinates: cluster.coordinates.len(),
                    freedoms: cost.freedoms,
                    bytes,
                    most_bytes: CLUSTER_BYTES as f64,
                    work,
                    most_work: CLUSTER_WORK,
                })
            }
            _ => Ok(()),
        }
    }
}

/// Cost of `eliminate_cluster`, its decisions and the closing speed for one cluster.
fn cluster_cost(cluster: &Cluster, groups: &[GroupMobility]) -> Cost {
    let bodies = cluster.bodies.len() as f64;
    let n = cluster.coordinates.len() as f64;
    let bound: usize = cluster.groups.iter().map(|own| own.coordinates.len()).sum();
    let free: usize = cluster.groups.iter().map(|own| groups[own.group].independent.len()).sum();
    let freedoms = cluster.coordinates.len() - bound + free;
    let d = freedoms as f64;
    let rank = bound as f64 - free as f64;
    // G twice (the group's and the cluster's), Ψ and D; in a large cluster the mass matrix and its product with G.
    let large = freedoms > LARGE_CLUSTER;
    let by_mass = if large { n * n + n * d } else { 0.0 };
    let entries = 2.0 * n * d + 6.0 * bodies * d + d * d + by_mass;
    // Sizes of the terms of G and of Ψ; the basis of the closing speed.
    let sizes = n * d + 2.0 * bodies * d + rank.min(d) * n;
    let blocks = if large { 6.0 * n * n + (n * d + d * d) * rank } else { 32.0 * bodies * d * d };
    Cost {
        freedoms,
        bytes: entries * size_of::<f64>() as f64 + sizes * size_of::<f64>() as f64,
        work: blocks + d * d * d + 4.0 * rank.min(d).powi(2) * n,
    }
}
