//! Computation of the clusters of a model.

use super::Model;
use super::cluster::{Cluster, ClusterGroup, ClusterVelocity};
use crate::union::Partition;

impl Model {
    /// Partitions the bodies into clusters.
    pub(super) fn compile_clusters(&mut self) {
        let mut partition = Partition::new(self.bodies.len());
        let mut bound = vec![false; self.bodies.len()];
        for bodies in self.bound_bodies() {
            let all = self.with_all_between(&bodies);
            all.iter().for_each(|&b| bound[b] = true);
            all.windows(2).for_each(|pair| partition.join(pair[0], pair[1]));
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
            for f in body.v.clone().filter_map(|v| self.follows[v]) {
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

    /// The given bodies and the bodies on the paths between them, without their common ancestor.
    fn with_all_between(&self, bodies: &[usize]) -> Vec<usize> {
        // Bodies on all paths to the ground, with the number of their children on the paths.
        let mut on_path: std::collections::BTreeMap<usize, usize> = bodies.iter().map(|&b| (b, 0)).collect();
        let mut roots = 0;
        for &start in on_path.clone().keys() {
            let mut body = start;
            loop {
                let Some(parent) = self.bodies[body].parent else {
                    roots += 1;
                    break;
                };
                let known = on_path.contains_key(&parent);
                *on_path.entry(parent).or_insert(0) += 1;
                if known {
                    break;
                }
                body = parent;
            }
        }
        // Removes the path from the ground to the first branching or to a given body.
        let wanted: std::collections::BTreeSet<usize> = bodies.iter().copied().collect();
        if roots == 1 {
            while let Some((&first, &children)) = on_path.iter().next() {
                if children != 1 || wanted.contains(&first) {
                    break;
                }
                on_path.pop_first();
            }
            // The body at the branching is the common ancestor.
            if let Some((&first, _)) = on_path.iter().next()
                && !wanted.contains(&first)
            {
                on_path.pop_first();
            }
        }
        on_path.into_keys().collect()
    }

    /// Fills parents, coordinates and velocities of a cluster.
    fn complete_cluster(&self, cluster: &mut Cluster) {
        for (at, &body) in cluster.bodies.iter().enumerate() {
            let parent = self.bodies[body].parent;
            cluster.parents.push(parent.and_then(|p| cluster.bodies[..at].binary_search(&p).ok()));
            cluster
                .coordinates
                .extend(self.bodies[body].v.clone().filter_map(|v| self.follows[v]).map(|f| f.index));
        }
        cluster.coordinates.sort_unstable();
        cluster.coordinates.dedup();
        for (at, &body) in cluster.bodies.iter().enumerate() {
            for (component, v) in self.bodies[body].v.clone().enumerate() {
                let Some(f) = self.follows[v] else { continue };
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
