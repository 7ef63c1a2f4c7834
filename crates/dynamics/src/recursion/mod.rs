//! Articulated-body recursion over clusters, for every mechanism: O(n) in the number of clusters, without a matrix of
//! the whole.
//!
//! A cluster contains all bodies bound together by constraints and mimics, and the bodies between them; a plain joint
//! is a cluster of one body. All quantities are in root axes with the origin at the contact point, so that
//! articulated inertias and wrenches add without a transform. With G the rates of a cluster's coordinates over its
//! independent ones,
//!
//! ```text
//! Ψ_b = Σ S_k G_k over the path to body b;  D = Σ_b Ψ_bᵀ I_bᴬ Ψ_b + Gᵀ diag(armature) G
//! U = Σ_b I_bᴬ Ψ_b;  t = Σ_b Ψ_bᵀ f_b
//! I_pᴬ += Σ_b I_bᴬ − U D⁻¹ Uᵀ;  f_p += Σ_b f_b − U D⁻¹ t;  response += tᵀ D⁻¹ t
//! ```
//!
//! Featherstone 2008, §7.3; test-force form: Wensing et al. 2012, eq. 12; over clusters: Chignoli et al. 2023 (cited
//! from DESIGN).

mod budget;
pub(crate) mod closing_speed;
mod cluster;
mod elimination;
mod joint;
mod pivoting;

pub(crate) use elimination::{ClusterElimination, JointElimination, RecursionMotion};
pub(crate) use pivoting::{FreeMotion, Pivoting};

use crate::kinematics::frames::Kinematics;
use crate::mobility::GroupMobility;
use crate::model::Model;
use nalgebra::Vector3;
use percuss_spatial::{ArticulatedInertia, SpatialInertia, Transform, Twist, Wrench};

/// Workspace of the recursion with `K` simultaneous test wrenches; refilled in place.
#[derive(Clone, Debug)]
pub(crate) struct Recursion<const K: usize> {
    /// Rigid inertia of every body, about its own origin in its own axes.
    pub bodies: Vec<SpatialInertia<f64>>,
    /// Armature of every tree velocity.
    pub armature: Vec<f64>,
    /// Articulated inertia of every body; in a bound cluster before the elimination of the body's own joint.
    pub inertias: Vec<ArticulatedInertia<f64>>,
    /// Test wrenches on every body, with the contributions of its children.
    pub wrenches: Vec<[Wrench<f64>; K]>,
    /// Elimination of every tree velocity of a plain joint.
    pub joints: Vec<JointElimination<K>>,
    /// Tree velocities of every body, in the order of their elimination.
    pub order: Vec<usize>,
    /// Elimination of every bound cluster.
    pub clusters: Vec<ClusterElimination<K>>,
    /// Index in `clusters` for every cluster; `None` if the cluster is a plain joint.
    pub cluster_index: Vec<Option<usize>>,
}

impl<const K: usize> Recursion<K> {
    /// Workspace for a model; without test wrenches.
    pub fn new(model: &Model) -> Self {
        let bodies = model.bodies.len();
        let mut armature = vec![0.0; model.velocity_coordinates.len()];
        for body in &model.bodies {
            for (v, a) in body.v.clone().zip(&body.armature) {
                armature[v] = *a;
            }
        }
        let mut bound = 0;
        let place = model.clusters.iter().map(|c| c.is_bound.then(|| (bound, bound += 1).0)).collect();
        Self {
            bodies: model.bodies.iter().map(|b| b.inertia).collect(),
            armature,
            inertias: vec![ArticulatedInertia::zero(); bodies],
            wrenches: vec![[Wrench::zero(); K]; bodies],
            joints: vec![JointElimination::zero(); model.velocity_coordinates.len()],
            order: (0..model.velocity_coordinates.len()).collect(),
            clusters: (0..bound).map(|_| ClusterElimination::default()).collect(),
            cluster_index: place,
        }
    }

    /// Removes all test wrenches.
    pub fn clear(&mut self) {
        self.wrenches.fill([Wrench::zero(); K]);
    }

    /// Adds a wrench (root axes, about the contact point) on a body to a test wrench. A wrench on the ground has no
    /// effect.
    pub fn add_wrench(&mut self, body: Option<usize>, test: usize, wrench: Wrench<f64>) {
        if let Some(body) = body {
            self.wrenches[body][test] += wrench;
        }
    }

    /// Eliminates every cluster, children before parents.
    pub fn eliminate(
        &mut self,
        model: &Model,
        kinematics: &Kinematics,
        groups: &[GroupMobility],
        point: &Vector3<f64>,
        pivoting: &mut Pivoting<K>,
    ) {
        for (i, frame) in kinematics.frames.iter().enumerate() {
            let x = Transform::new(frame.rotation, frame.translation - point);
            pivoting.start_body(i, &x, &self.wrenches[i]);
            self.inertias[i] = ArticulatedInertia::from(&x.inertia(&self.bodies[i]));
        }
        for (number, cluster) in model.clusters.iter().enumerate() {
            match self.cluster_index[number] {
                None => self.eliminate_joint(model, kinematics, cluster.bodies[0], point, pivoting),
                Some(place) => {
                    self.eliminate_cluster(model, kinematics, groups, number, place, point, pivoting);
                }
            }
        }
    }

    /// Σ tₐᵀ D⁻¹ t_b over all clusters: entry (a, b) of Φ for the test wrenches; 1/m̄ for a unit wrench along the
    /// normal.
    pub fn response(&self, a: usize, b: usize) -> f64 {
        let joints = self.joints.iter().filter(|e| e.counts);
        let sum = joints.fold(0.0, |sum, e| sum + e.t[a] * e.t[b] / e.d);
        self.clusters.iter().fold(sum, |sum, cluster| sum + cluster.response(a, b))
    }

    /// θᵀKθ for forces θ on the tree velocities of plain joints and on the coordinates of bound clusters. K is the
    /// response of the velocities to forces, again as tᵀ D⁻¹ t.
    pub fn compliance(&self, model: &Model, joints: &[f64], clusters: &[Vec<f64>]) -> f64 {
        let mut wrenches = vec![Wrench::zero(); model.bodies.len()];
        let mut sum = 0.0;
        for (number, cluster) in model.clusters.iter().enumerate() {
            let passed = match self.cluster_index[number] {
                None => {
                    let i = cluster.bodies[0];
                    let mut f = wrenches[i];
                    for &v in &self.order[model.bodies[i].v.clone()] {
                        let e = &self.joints[v];
                        let t = joints[v] + f.power(&e.s);
                        sum += t * t / e.d;
                        f -= e.u * (t / e.d);
                    }
                    f
                }
                Some(place) => {
                    self.clusters[place].propagate_wrench(cluster, &wrenches, &clusters[place], &mut sum)
                }
            };
            if let Some(parent) = cluster.parent {
                wrenches[parent] += passed;
            }
        }
        sum
    }

    /// Velocities of the tree and twists of the bodies (root axes, at the contact point) after a unit impulse of test
    /// wrench 0: M⁻¹ jᵀ. Computed from the root to the tips.
    pub fn velocities(&self, model: &Model, point: &Vector3<f64>, motion: &mut RecursionMotion) {
        for (number, cluster) in model.clusters.iter().enumerate().rev() {
            match self.cluster_index[number] {
                None => self.joint_velocities(model, cluster.bodies[0], true, motion),
                Some(place) => self.clusters[place].velocities(cluster, motion, None),
            }
        }
        self.base_velocities(model, point, motion);
    }

    /// Sets the velocities of a floating base without constraints: the twist of the base, transferred from the contact point
    /// (`point`) to the origin of the root.
    fn base_velocities(&self, model: &Model, point: &Vector3<f64>, motion: &mut RecursionMotion) {
        let RecursionMotion { velocities, twists, .. } = motion;
        let Some(body) = model.bodies.first().filter(|b| b.joint.is_none()) else { return };
        if self.cluster_index[model.cluster_of[0]].is_none() {
            let at_origin = twists[0].velocity_at(&-point);
            velocities[body.v.clone()][..3].copy_from_slice(twists[0].angular.as_slice());
            velocities[body.v.clone()][3..].copy_from_slice(at_origin.as_slice());
        }
    }

    /// Velocities of the tree in a massless motion: ancestors are at rest, and the subtree follows without
    /// energy.
    pub fn massless_velocities(&self, model: &Model, point: &Vector3<f64>, free: FreeMotion) -> Vec<f64> {
        let mut motion = RecursionMotion::new(model);
        let number = match free {
            FreeMotion::Joint(body, v) => {
                let RecursionMotion { velocities, twists, .. } = &mut motion;
                // Velocities of the same joint that were eliminated earlier follow.
                velocities[v] = 1.0;
                let mut twist = self.joints[v].s;
                let order = &self.order[model.bodies[body].v.clone()];
                for &earlier in order.iter().take_while(|o| **o != v).collect::<Vec<_>>().into_iter().rev() {
                    let e = &self.joints[earlier];
                    if e.counts {
                        velocities[earlier] = -(e.u.power(&twist) / e.d);
                        twist += e.s * velocities[earlier];
                    }
                }
                twists[body] = twist;
                model.cluster_of[body]
            }
            FreeMotion::Cluster(place, y) => {
                let number = self.cluster_index.iter().position(|p| *p == Some(place)).unwrap_or(0);
                self.clusters[place].velocities(&model.clusters[number], &mut motion, Some(y));
                number
            }
        };
        let mut moved = vec![false; model.bodies.len()];
        model.clusters[number].bodies.iter().for_each(|&b| moved[b] = true);
        for cluster_number in (0..number).rev() {
            let cluster = &model.clusters[cluster_number];
            if !cluster.parent.is_some_and(|p| moved[p]) {
                continue;
            }
            cluster.bodies.iter().for_each(|&b| moved[b] = true);
            match self.cluster_index[cluster_number] {
                None => self.joint_velocities(model, cluster.bodies[0], false, &mut motion),
                Some(place) => self.clusters[place].follow_parent(cluster, &mut motion),
            }
        }
        self.base_velocities(model, point, &mut motion);
        motion.velocities
    }
}

impl<const K: usize> Recursion<K> {
    /// Calls `take` for every pivot with the test wrenches along its motion, the pivot (`None` if it does not count),
    /// and the motion. Stops and returns false as soon as `take` returns false.
    pub fn for_each_pivot(&self, mut take: impl FnMut(&[f64; K], Option<f64>, &Twist<f64>) -> bool) -> bool {
        self.joints.iter().all(|e| take(&e.t, e.counts.then_some(e.d), &e.s))
            && self.clusters.iter().all(|cluster| cluster.for_each_pivot(&mut take))
    }
}
