//! What a mechanism under conditions compiles to: plain immutable data. No algorithm but the compilation itself.

mod body;
mod cluster;
mod clusters;
mod compile;
mod constraint;
mod constraints;
mod group;
mod groups;

pub(crate) use body::{Body, Coordinate, Follows, LinkFrame};
pub(crate) use cluster::{Cluster, ClusterGroup};
pub(crate) use constraint::{CompiledClosure, CompiledCoupling};
pub(crate) use group::{Constraint, ConstraintRows, Group, Term};

use crate::conditions::{Base, CompiledHold};
use percuss_mechanism::{JointId, LinkId, Mechanism};
use std::ops::Range;
use std::sync::Arc;

/// A mechanism under conditions, compiled.
#[derive(Clone, Debug)]
pub(crate) struct Model {
    pub mechanism: Arc<Mechanism>,
    pub base: Base,
    /// Parents before children.
    pub bodies: Vec<Body>,
    /// For every link.
    pub link_frames: Vec<LinkFrame>,
    /// For every tree velocity; none is never met after the compilation.
    pub follows: Vec<Option<Follows>>,
    /// For every joint.
    pub locked: Vec<bool>,
    /// For every joint.
    pub joint_q: Vec<Range<usize>>,
    /// For every joint: its body; none where a fixed joint holds links together.
    pub body_of_joint: Vec<Option<usize>>,
    /// How many positions.
    pub positions: usize,
    pub coordinates: Vec<Coordinate>,
    pub redundant_locks: usize,
    /// Whether any joint that moves follows another.
    pub has_active_mimics: bool,
    pub closures: Vec<CompiledClosure>,
    pub couplings: Vec<CompiledCoupling>,
    pub holds: Vec<CompiledHold>,
    pub groups: Vec<Group>,
    /// Children before the clusters that carry them.
    pub clusters: Vec<Cluster>,
    /// For every body: its cluster.
    pub cluster_of: Vec<usize>,
}

impl Model {
    /// The body of a link; none: the ground.
    pub fn body_of(&self, link: LinkId) -> Option<usize> {
        self.link_frames[link.index()].body
    }

    /// Visits the bodies that carry `on` but not `against`, with +1, and the reverse, with −1.
    pub fn for_each_support(
        &self,
        mut on: Option<usize>,
        mut against: Option<usize>,
        mut visit: impl FnMut(usize, f64),
    ) {
        // Bodies are numbered parents first: the higher number cannot carry the lower one.
        while on != against {
            if on > against {
                let Some(i) = on else { return };
                visit(i, 1.0);
                on = self.bodies[i].parent;
            } else {
                let Some(i) = against else { return };
                visit(i, -1.0);
                against = self.bodies[i].parent;
            }
        }
    }

    /// Name of a joint.
    pub fn joint_name(&self, joint: JointId) -> &str {
        self.mechanism.joint(joint).name()
    }

    /// Tree velocities at the coordinates `u`: G u.
    pub fn expand(&self, u: &[f64]) -> Vec<f64> {
        self.follows.iter().map(|f| f.map_or(0.0, |f| f.multiplier * u[f.index])).collect()
    }

    /// Sums entries over tree velocities into ones over the coordinates, each times a function of its multiplier:
    /// Gᵀ x with the identity.
    pub fn reduce_vector(&self, tree: &[f64], weight: impl Fn(f64) -> f64) -> Vec<f64> {
        let mut reduced = vec![0.0; self.coordinates.len()];
        for (value, follows) in tree.iter().zip(&self.follows) {
            if let Some(f) = follows {
                reduced[f.index] += value * weight(f.multiplier);
            }
        }
        reduced
    }
}
