//! The articulated recursion over clusters: the route of every mechanism. No matrix of the whole, O(n) in clusters.
//!
//! A cluster is what constraints and mimics bind together, with everything between; a plain joint is a cluster of one.
//! All in root axes with the origin at the contact point, so that articulated inertias and wrenches add without being
//! transformed. With G the rates of a cluster's coordinates over its independent ones,
//!
//! ```text
//! Ψ_b = Σ S_k G_k over the path to body b;  D = Σ_b Ψ_bᵀ I_bᴬ Ψ_b + Gᵀ diag(armature) G;  U = Σ_b I_bᴬ Ψ_b;  t = Σ_b Ψ_bᵀ f_b
//! I_pᴬ += Σ_b I_bᴬ − U D⁻¹ Uᵀ;  f_p += Σ_b f_b − U D⁻¹ t;  response += tᵀ D⁻¹ t
//! ```
//!
//! Featherstone 2008, §7.3; the test-force form: Wensing et al. 2012, eq. 12; over clusters: Chignoli et al. 2023 (cited
//! as DESIGN cites them).

mod budget;
mod cluster;
mod elimination;
mod joint;
mod loss;
mod pivoting;

pub(crate) use elimination::{ClusterElimination, JointElimination, Motion};
pub(crate) use pivoting::{Deciding, Decisions, Following, FreeMotion, Pivoting};

use crate::kinematics::Kinematics;
use crate::mobility::GroupMobility;
use crate::model::Model;
use nalgebra::Vector3;
use percuss_spatial::{ArticulatedInertia, Scalar, SpatialInertia, Transform, Twist, Wrench};

/// Room for the recursion with `K` test wrenches at once; refilled in place.
#[derive(Clone, Debug)]
pub(crate) struct Recursion<T: Scalar, const K: usize> {
    /// Rigid inertia of every body, about its own origin in its own axes.
    pub bodies: Vec<SpatialInertia<T>>,
    /// Armature of every tree velocity.
    pub armature: Vec<T>,
    /// Articulated inertia of every body, before its own joint is eliminated where a cluster is bound.
    pub inertias: Vec<ArticulatedInertia<T>>,
    /// Test wrenches that arrive at every body.
    pub wrenches: Vec<[Wrench<T>; K]>,
    /// For every tree velocity of a plain joint.
    pub joints: Vec<JointElimination<T, K>>,
    /// For every body, in its part of the tree's velocities: these in the order of their elimination.
    pub order: Vec<usize>,
    /// For every bound cluster.
    pub clusters: Vec<ClusterElimination<T, K>>,
    /// For every cluster: its place in `clusters`, if it is bound.
    pub place: Vec<Option<usize>>,
}

impl<T: Scalar, const K: usize> Recursion<T, K> {
    pub fn new(model: &Model) -> Self {
        let bodies = model.bodies.len();
        let mut armature = vec![T::zero(); model.follows.len()];
        for body in &model.bodies {
            for (v, a) in body.v.clone().zip(&body.armature) {
                armature[v] = T::from_f64(*a);
            }
        }
        let mut bound = 0;
        let place = model.clusters.iter().map(|c| c.is_bound.then(|| (bound, bound += 1).0)).collect();
        Self {
            bodies: model.bodies.iter().map(|b| b.inertia.cast()).collect(),
            armature,
            inertias: vec![ArticulatedInertia::zero(); bodies],
            wrenches: vec![[Wrench::zero(); K]; bodies],
            joints: vec![JointElimination::blank(); model.follows.len()],
            order: (0..model.follows.len()).collect(),
            clusters: (0..bound).map(|_| ClusterElimination::default()).collect(),
            place,
        }
    }

    /// Takes all test wrenches off.
    pub fn clear(&mut self) {
        self.wrenches.fill([Wrench::zero(); K]);
    }

    /// Adds a wrench (root axes, about the contact point) on a body to one of the test wrenches; one on the ground moves
    /// nothing.
    pub fn add_wrench(&mut self, body: Option<usize>, test: usize, wrench: Wrench<T>) {
        if let Some(body) = body {
            self.wrenches[body][test] += wrench;
        }
    }

    /// Eliminates every cluster, those carried before those that carry.
    pub fn eliminate(
        &mut self,
        model: &Model,
        kinematics: &Kinematics<T>,
        groups: &[GroupMobility],
        point: &Vector3<T>,
        pivoting: &mut impl Pivoting<T, K>,
    ) {
        for (i, frame) in kinematics.frames.iter().enumerate() {
            let x = Transform::new(frame.rotation, frame.translation - point);
            pivoting.body(i, &x, &self.wrenches[i]);
            self.inertias[i] = ArticulatedInertia::from(&x.inertia(&self.bodies[i]));
        }
        for (number, cluster) in model.clusters.iter().enumerate() {
            match self.place[number] {
                None => self.eliminate_joint(model, kinematics, cluster.bodies[0], point, pivoting),
                Some(place) => {
                    self.eliminate_cluster(model, kinematics, groups, number, place, point, pivoting);
                }
            }
        }
    }

    /// Σ tₐᵀ D⁻¹ t_b over all clusters: entry (a, b) of Φ for the test wrenches. With one along the normal, 1/m̄.
    pub fn response(&self, a: usize, b: usize) -> T {
        let joints = self.joints.iter().filter(|e| e.counts);
        let sum = joints.fold(T::zero(), |sum, e| sum + e.t[a] * e.t[b] / e.d);
        self.clusters.iter().fold(sum, |sum, cluster| sum + cluster.response(a, b))
    }

    /// θᵀKθ for forces θ on the tree's velocities of plain joints and on the coordinates of bound clusters, K the response of
    /// the velocities to forces: tᵀ D⁻¹ t once more.
    pub fn compliance(&self, model: &Model, joints: &[T], clusters: &[Vec<T>]) -> T {
        let mut wrenches = vec![Wrench::zero(); model.bodies.len()];
        let mut sum = T::zero();
        for (number, cluster) in model.clusters.iter().enumerate() {
            let passed = match self.place[number] {
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
                Some(place) => self.clusters[place].push(cluster, &wrenches, &clusters[place], &mut sum),
            };
            if let Some(parent) = cluster.parent {
                wrenches[parent] += passed;
            }
        }
        sum
    }

    /// Velocities of the tree and twists of the bodies (root axes, at the contact point) after a unit impulse of test
    /// wrench 0: M⁻¹ jᵀ. Found from the root to the tips.
    pub fn velocities(&self, model: &Model, point: &Vector3<T>, motion: &mut Motion<T>) {
        for (number, cluster) in model.clusters.iter().enumerate().rev() {
            match self.place[number] {
                None => self.joint_velocities(model, cluster.bodies[0], true, motion),
                Some(place) => self.clusters[place].velocities(cluster, motion, None),
            }
        }
        self.base_velocities(model, point, motion);
    }

    /// A free base's velocities are those at its own origin, the root's.
    fn base_velocities(&self, model: &Model, point: &Vector3<T>, motion: &mut Motion<T>) {
        let Motion { velocities, twists, .. } = motion;
        let Some(body) = model.bodies.first().filter(|b| b.joint.is_none()) else { return };
        if self.place[model.cluster_of[0]].is_none() {
            let at_origin = twists[0].velocity_at(&-point);
            velocities[body.v.clone()][..3].copy_from_slice(twists[0].angular.as_slice());
            velocities[body.v.clone()][3..].copy_from_slice(at_origin.as_slice());
        }
    }

    /// Velocities of the tree in a motion without mass: the bodies that carry stand still, those that are carried follow
    /// without energy.
    pub fn free_motion(&self, model: &Model, point: &Vector3<T>, free: FreeMotion) -> Vec<T> {
        let mut motion = Motion::new(model);
        let number = match free {
            FreeMotion::Joint(body, v) => {
                let Motion { velocities, twists, .. } = &mut motion;
                // Velocities of the same joint that were eliminated before follow.
                velocities[v] = T::one();
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
            FreeMotion::Bound(place, y) => {
                let number = self.place.iter().position(|p| *p == Some(place)).unwrap_or(0);
                self.clusters[place].velocities(&model.clusters[number], &mut motion, Some(y));
                number
            }
        };
        let mut moved = vec![false; model.bodies.len()];
        model.clusters[number].bodies.iter().for_each(|&b| moved[b] = true);
        for carried in (0..number).rev() {
            let cluster = &model.clusters[carried];
            if !cluster.parent.is_some_and(|p| moved[p]) {
                continue;
            }
            cluster.bodies.iter().for_each(|&b| moved[b] = true);
            match self.place[carried] {
                None => self.joint_velocities(model, cluster.bodies[0], false, &mut motion),
                Some(place) => self.clusters[place].follows(cluster, &mut motion),
            }
        }
        self.base_velocities(model, point, &mut motion);
        motion.velocities
    }
}

impl<const K: usize> Recursion<f64, K> {
    /// Hands over every pivot: what the tests give along it, the pivot where it counts, and where it does not, the motion that
    /// they act on. Ends, and is false, where the taker is.
    pub fn for_each_pivot(&self, mut take: impl FnMut(&[f64; K], Option<f64>, &Twist<f64>) -> bool) -> bool {
        self.joints.iter().all(|e| take(&e.t, e.counts.then_some(e.d), &e.s))
            && self.clusters.iter().all(|cluster| cluster.for_each_pivot(&mut take))
    }
}
