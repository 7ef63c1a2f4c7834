//! Compiled form of a mechanism under conditions: plain immutable data, and the compilation.

mod body;
mod compile;
pub(crate) mod conditions;
pub(crate) mod configuration;
mod constraint;
mod constraints;
pub mod input;
pub mod interruption;
pub(crate) mod joint_motion;
pub(crate) mod structure;
pub(crate) mod tangent;
pub(crate) mod velocities;

pub(crate) use body::{Body, Coordinate, LinkFrame, VelocityCoordinate};
pub(crate) use constraint::{CompiledClosure, CompiledCoupling, CouplingTerm};
pub(crate) use structure::cluster::{Cluster, ClusterGroup, ClusterVelocity};
pub(crate) use structure::group::{Constraint, ConstraintRows, ConstraintTerm, Group};

use crate::model::conditions::{Base, CompiledHold};
use nalgebra::Vector3;
use percuss_mechanism::{JointId, LinkId, Mechanism};
use percuss_spatial::Twist;
use std::ops::Range;
use std::sync::Arc;

/// A compiled mechanism under conditions.
#[derive(Clone, Debug)]
pub(crate) struct Model {
    pub mechanism: Arc<Mechanism>,
    pub base: Base,
    /// Bodies, parents before children.
    pub bodies: Vec<Body>,
    /// Frame of every link.
    pub link_frames: Vec<LinkFrame>,
    /// Coordinate of every tree velocity; always `Some` after the compilation.
    pub velocity_coordinates: Vec<Option<VelocityCoordinate>>,
    /// Lock flag of every joint; also true for mimics and masters of locked joints.
    pub locked: Vec<bool>,
    /// For every joint: true if the conditions lock this joint itself.
    pub own_locks: Vec<bool>,
    /// Range of positions of every joint.
    pub joint_q: Vec<Range<usize>>,
    /// Body of every joint; `None` for a fixed joint inside a body.
    pub body_of_joint: Vec<Option<usize>>,
    /// Number of positions.
    pub positions: usize,
    pub coordinates: Vec<Coordinate>,
    pub redundant_locks: usize,
    /// True if any movable joint is a mimic.
    pub has_active_mimics: bool,
    pub closures: Vec<CompiledClosure>,
    pub couplings: Vec<CompiledCoupling>,
    pub holds: Vec<CompiledHold>,
    pub groups: Vec<Group>,
    /// Clusters, children before parents.
    pub clusters: Vec<Cluster>,
    /// Cluster of every body.
    pub cluster_of: Vec<usize>,
}

impl Model {
    /// Body of a link; `None` for the ground.
    pub fn body_of(&self, link: LinkId) -> Option<usize> {
        self.link_frames[link.index()].body
    }

    /// Calls `visit` with +1 for the bodies on the path from `on` to the common ancestor, and with −1 for the bodies
    /// on the path from `against`.
    pub fn for_each_support(
        &self,
        mut on: Option<usize>,
        mut against: Option<usize>,
        mut visit: impl FnMut(usize, f64),
    ) {
        // Parents have lower numbers than children: the body of the higher number is not an ancestor of the other.
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
        self.velocity_coordinates.iter().map(|f| f.map_or(0.0, |f| f.multiplier * u[f.index])).collect()
    }

    /// Splits tree velocities into the velocities of every joint, in joint order, and the twist of a floating base.
    pub fn split_velocities(&self, tree: &[f64]) -> (Vec<Vec<f64>>, Twist<f64>) {
        let mut joints: Vec<Vec<f64>> =
            self.mechanism.joints().iter().map(|j| vec![0.0; j.kind().dofs()]).collect();
        let mut base = Twist::zero();
        for body in self.bodies.iter().filter(|b| !b.v.is_empty()) {
            let v = &tree[body.v.clone()];
            match body.joint {
                Some(id) => joints[id.index()].copy_from_slice(v),
                None => base = Twist::new(Vector3::new(v[0], v[1], v[2]), Vector3::new(v[3], v[4], v[5])),
            }
        }
        (joints, base)
    }

    /// Sums entries over tree velocities into entries over coordinates. Each entry is multiplied by
    /// `weight(multiplier)`; with the identity the result is Gᵀ x.
    pub fn reduce_vector(&self, tree: &[f64], weight: impl Fn(f64) -> f64) -> Vec<f64> {
        let mut reduced = vec![0.0; self.coordinates.len()];
        for (value, follows) in tree.iter().zip(&self.velocity_coordinates) {
            if let Some(f) = follows {
                reduced[f.index] += value * weight(f.multiplier);
            }
        }
        reduced
    }
}
