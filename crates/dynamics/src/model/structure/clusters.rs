//! Computation of the clusters of a model.

use super::cluster::{Cluster, ClusterGroup, ClusterVelocity};
use crate::model::Model;
use crate::model::structure::partition::Partition;
use std::collections::BTreeMap;

impl Model {
    /// Partitions the bodies into clusters.
    pub(in crate::model) fn compile_clusters(&mut self) {
        let mut partition = Partition::new(self.bodies.len());
        let mut bound = vec![false; self.bodies.len()];
        // Edges of the tree whose two bodies are in one cluster: a later path passes all of them in one step.
        let mut joined = Partition::new(self.bodies.len());
        for bodies in self.bound_bodies() {
            let all = self.with_all_between(&bodies, &mut joined);
            all.iter().for_each(|&b| bound[b] = true);
            all.windows(2).for_each(|pair| partition.join(pair[0], pair[1]));
            for &body in &all {
                if let Some(parent) = self.bodies[body].parent
                    && partition.root(parent) == partition.root(body)
                {
                    joined.join(parent, body);
                }
            }
        }
        let mut clusters: Vec<Cluster> = Vec::new();
        let mut of_root = vec![usize::MAX; self.bodies.len()];
        self.cluster_of = vec![0; self.bodies.len()];
        for body in 0..self.bodies.len() {
            let root = partition.root(body);
            if of_root[root] == usize::MAX {
                of_root[root] = clusters.len();
                let (parent, is_bound) = (self.bodies[body].parent, bound[body]);
                clusters.push(Cluster { parent, is_bound, ..Cluster::default() });
            }
            clusters[of_root[root]].bodies.push(body);
            self.cluster_of[body] = of_root[root];
        }
        for cluster in &mut clusters {
            self.complete_cluster(cluster);
        }
        for (number, group) in self.groups.iter().enumerate() {
            let Some(&first) = group.coordinates.first() else { continue };
            let body = self.body_of_coordinate(first);
            let cluster = &mut clusters[self.cluster_of[body]];
            let place = |c: &usize| cluster.coordinates.partition_point(|other| other < c);
            let coordinates = group.coordinates.iter().map(place).collect();
            cluster.groups.push(ClusterGroup { group: number, coordinates });
        }
        // A parent cluster has a lower number than its children, because clusters are numbered by their first bodies.
        clusters.reverse();
        let last = clusters.len().saturating_sub(1);
        self.cluster_of.iter_mut().for_each(|c| *c = last - *c);
        self.clusters = clusters;
    }

    fn body_of_coordinate(&self, coordinate: usize) -> usize {
        let joint = self.coordinates[coordinate].joint;
        joint.and_then(|id| self.body_of_joint[id.index()]).unwrap_or(0)
    }

    /// Sets of bodies with coupled velocities: of each group, and of each master with its mimics.
    fn bound_bodies(&self) -> Vec<Vec<usize>> {
        let mut of_coordinate: Vec<Vec<usize>> = vec![Vec::new(); self.coordinates.len()];
        for (i, body) in self.bodies.iter().enumerate() {
            for f in body.v.clone().filter_map(|v| self.velocity_coordinates[v]) {
                if of_coordinate[f.index].last() != Some(&i) {
                    of_coordinate[f.index].push(i);
                }
            }
        }
        let mut sets: Vec<Vec<usize>> = Vec::new();
        for group in &self.groups {
            let set: Vec<usize> = group.coordinates.iter().flat_map(|&c| of_coordinate[c].clone()).collect();
            sets.push(set);
        }
        sets.extend(of_coordinate.into_iter().filter(|bodies| bodies.len() > 1));
        sets.retain(|set| !set.is_empty());
        sets
    }

    /// The given bodies and the bodies on the paths between them, without their common ancestor; each joined set is
    /// represented by its root. The sum over all sets is linear in the number of bodies.
    fn with_all_between(&self, bodies: &[usize], joined: &mut Partition) -> Vec<usize> {
        // Set of each end of a path, with the body at which the path enters the set; `None` if the whole set belongs
        // to the result. Bodies are numbered parents first, so the body with the highest number is no ancestor of the
        // others. The key `None` is the ground.
        let mut ends: BTreeMap<Option<usize>, Option<usize>> =
            bodies.iter().map(|&b| (Some(joined.root(b)), None)).collect();
        let mut all = Vec::new();
        while ends.len() > 1 {
            let Some((Some(body), _)) = ends.pop_last() else { break };
            all.push(body);
            let parent = self.bodies[body].parent;
            let entry = ends.entry(parent.map(|parent| joined.root(parent))).or_insert(parent);
            // Two paths that enter a set at different bodies are connected through it.
            if *entry != parent {
                *entry = None;
            }
        }
        // All paths meet in the last set: in one body, the common ancestor, or through the set.
        all.extend(ends.into_iter().filter(|(_, entry)| entry.is_none()).filter_map(|(root, _)| root));
        all
    }

    /// Fills parents, coordinates and velocities of a cluster.
    fn complete_cluster(&self, cluster: &mut Cluster) {
        for (at, &body) in cluster.bodies.iter().enumerate() {
            let parent = self.bodies[body].parent;
            cluster.parents.push(parent.and_then(|p| cluster.bodies[..at].binary_search(&p).ok()));
            cluster.coordinates.extend(
                self.bodies[body].v.clone().filter_map(|v| self.velocity_coordinates[v]).map(|f| f.index),
            );
        }
        cluster.coordinates.sort_unstable();
        cluster.coordinates.dedup();
        for (at, &body) in cluster.bodies.iter().enumerate() {
            for (component, v) in self.bodies[body].v.clone().enumerate() {
                let Some(f) = self.velocity_coordinates[v] else { continue };
                cluster.velocities.push(ClusterVelocity {
                    body: at,
                    component,
                    coordinate: cluster.coordinates.partition_point(|&c| c < f.index),
                    multiplier: f.multiplier,
                    armature: self.bodies[body].armature[component],
                    index: v,
                });
            }
        }
    }
}
