//! Selection of pivots at every pose, by the size of the terms of each pivot.

use super::elimination::{ClusterElimination, JointElimination};
use crate::mobility::GroupMobility;
use crate::model::{Body, Model};
use crate::tolerances::{
    LATE_PIVOT, MASSLESS_CLOSING, NEGATIVE_PIVOT, PIVOT, PIVOT_SQUARED, RESOLVED, ROUTE_ROUNDINGS,
};
use percuss_spatial::{ArticulatedInertia, Transform, Twist, Wrench};

/// Massless motion: a pivot that does not count.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum FreeMotion {
    /// Body with a plain joint, and index of the tree velocity.
    Joint(usize, usize),
    /// Bound cluster, and index of its independent coordinate.
    Cluster(usize, usize),
}

/// Decides the order of elimination, and which pivots count as zero, by the size of the terms of each pivot.
#[derive(Clone, Debug)]
pub(crate) struct Pivoting<const K: usize> {
    /// Size of the terms of every body's articulated inertia: moment (kg·m²) and mass (kg).
    inertia: Vec<(f64, f64)>,
    /// Sizes of every body's own inertia: trace of the rotational inertia, first moment, mass.
    own: Vec<(f64, f64, f64)>,
    /// Distance of every body's origin from the contact point, m.
    arm: Vec<f64>,
    /// Sizes of the current motion column.
    step_size: (f64, f64),
    /// Sizes of the terms of every body's test wrenches, moment and force.
    wrench: Vec<[(f64, f64); K]>,
    /// Current cluster: size of the terms of each pivot, and its zero threshold.
    pivot_size: Vec<f64>,
    pivot_zero: Vec<f64>,
    /// Size of the terms of D's diagonal without cancellation in G.
    pivot_terms: Vec<f64>,
    /// Current cluster: size of the terms of t for each coordinate and test wrench.
    test_size: Vec<[f64; K]>,
    /// Current cluster: sizes of the terms of each body's twist (angular, linear) per coordinate.
    motion_size: Vec<(f64, f64)>,
    /// Current cluster: sizes of the terms of the entries of G.
    rate_size: Vec<f64>,
    /// True if a massless motion closes the gap, for each test wrench.
    pub massless: [bool; K],
    /// Largest effective mass (kg) hidden by rounding in a massless result, for each test wrench.
    pub massless_limit: [f64; K],
    /// Massless motion with the largest relative closing speed for test wrench 0.
    pub best_free: Option<FreeMotion>,
    best_closing: f64,
    /// Number of massless motions.
    pub dropped: usize,
    /// True if a motion has a negative mass beyond rounding.
    pub indefinite: bool,
    /// Change of the response to test wrench 0 if all terms of its pivots and tests were in error by their own size,
    /// 1/kg: Σ (2|t| τ + t² δ/d)/d with τ and δ the sizes of the terms of t and d. A few ε of it bound the rounding
    /// of the recursion.
    pub terms: f64,
    /// `terms` weighted per pivot with [`ROUTE_ROUNDINGS`], or with the loss of its inertia if larger. ε of it bounds
    /// the rounding of the recursion.
    pub roundings: f64,
    /// Per body: largest ratio of a pivot's summed terms to the pivot, over the subtree. The rounding of U D⁻¹ Uᵀ is
    /// amplified by this factor.
    loss: Vec<f64>,
    /// `loss` of the current cluster.
    cluster_loss: f64,
    /// True if a direction classified as massless still couples to its parent: its pivot is small, not zero.
    pub couples_to_parent: bool,
    /// True if a massless motion of a plain joint closes the gap beyond rounding, but by less than
    /// [`MASSLESS_CLOSING`]: the true m̄ can be any value below the result.
    pub closes_faintly: bool,
}

impl<const K: usize> Pivoting<K> {
    /// State before the first body, with buffers of the size of the model.
    pub fn new(model: &Model) -> Self {
        let bodies = model.bodies.len();
        let own = |body: &Body| {
            let inertia = &body.inertia;
            (inertia.rotational.trace().abs(), inertia.first_moment.norm(), inertia.mass.abs())
        };
        Self {
            own: model.bodies.iter().map(own).collect(),
            inertia: vec![(0.0, 0.0); bodies],
            arm: vec![0.0; bodies],
            step_size: (0.0, 0.0),
            wrench: vec![[(0.0, 0.0); K]; bodies],
            pivot_size: Vec::new(),
            pivot_zero: Vec::new(),
            pivot_terms: Vec::new(),
            test_size: Vec::new(),
            motion_size: Vec::new(),
            rate_size: Vec::new(),
            massless: [false; K],
            massless_limit: [0.0; K],
            best_free: None,
            best_closing: 0.0,
            dropped: 0,
            indefinite: false,
            terms: 0.0,
            roundings: 0.0,
            loss: vec![ROUTE_ROUNDINGS; bodies],
            cluster_loss: ROUTE_ROUNDINGS,
            couples_to_parent: false,
            closes_faintly: false,
        }
    }

    /// Resets the decisions; called before every elimination.
    pub fn reset(&mut self) {
        self.massless = [false; K];
        self.massless_limit = [0.0; K];
        self.best_free = None;
        self.best_closing = 0.0;
        self.dropped = 0;
        self.indefinite = false;
        self.terms = 0.0;
        self.roundings = 0.0;
        self.couples_to_parent = false;
        self.closes_faintly = false;
    }

    /// Sizes of a motion column. The terms of its lever at the contact point are as large as the arm.
    fn sizes(&self, body: usize, s: &Twist<f64>) -> (f64, f64) {
        let square = s.angular.norm_squared();
        // The axis is a unit vector within rounding, or zero.
        let turn = if square == 0.0 { 0.0 } else { 0.5 + 0.5 * square };
        (turn, s.linear.norm() + turn * self.arm[body])
    }

    /// Sizes of the entries of a cluster's G, coordinates × d.
    fn fill_rate_sizes(&mut self, model: &Model, number: usize, groups: &[GroupMobility], d: usize) {
        let cluster = &model.clusters[number];
        let n = cluster.coordinates.len();
        self.rate_size.clear();
        self.rate_size.resize(n * d, 0.0);
        let mut next = 0;
        for own in &cluster.groups {
            let (group, known) = (&model.groups[own.group], &groups[own.group]);
            let count = known.independent.len();
            for (y, &free) in known.independent.iter().enumerate() {
                self.rate_size[own.coordinates[free] * d + next + y] = 1.0;
                for (i, &c) in known.pivots.columns.iter().enumerate() {
                    let size = known.size(i, y) * group.lengths[free] / group.lengths[c];
                    self.rate_size[own.coordinates[c] * d + next + y] = size;
                }
            }
            next += count;
        }
        for c in (0..n).filter(|c| !cluster.groups.iter().any(|g| g.coordinates.binary_search(c).is_ok())) {
            self.rate_size[c * d + next] = 1.0;
            next += 1;
        }
    }

    /// Starts a body with its frame (root axes, at the contact point), its own rigid inertia and test wrenches.
    #[inline]
    pub(super) fn start_body(&mut self, body: usize, x: &Transform<f64>, wrenches: &[Wrench<f64>; K]) {
        // Terms of the inertia about the contact point, which may cancel there.
        let arm = x.translation.norm();
        let (trace, first, mass) = self.own[body];
        self.arm[body] = arm;
        self.loss[body] = ROUTE_ROUNDINGS;
        self.inertia[body] = (trace + 2.0 * arm * (2.0 * first + arm * mass), mass);
        let size = |f: &Wrench<f64>| {
            if *f == Wrench::zero() { (0.0, 0.0) } else { (f.moment.norm(), f.force.norm()) }
        };
        self.wrench[body] = wrenches.each_ref().map(size);
    }

    /// True if this velocity of a joint outside clusters is eliminated next; false if its pivot is small and another of
    /// the `dofs` remaining candidates may be better. The last candidate is always accepted.
    #[inline]
    pub(super) fn eliminates_next(
        &mut self,
        body: usize,
        candidate: usize,
        dofs: usize,
        step: &JointElimination<K>,
    ) -> bool {
        self.step_size = self.sizes(body, &step.s);
        if dofs == 1 {
            return true;
        }
        let (turn, slide) = self.step_size;
        let (moment, mass) = self.inertia[body];
        let part = step.d / (turn * turn * moment + slide * slide * mass);
        // A small pivot may be rounding of the other eliminations, so the others come first.
        part >= LATE_PIVOT || candidate + 1 == dofs
    }

    /// True if the pivot of a plain joint's velocity counts, for this articulated inertia.
    #[inline]
    pub(super) fn counts_pivot(
        &mut self,
        body: usize,
        velocity: usize,
        step: &JointElimination<K>,
        inertia: &ArticulatedInertia<f64>,
    ) -> bool {
        let (turn, slide) = self.step_size;
        let (moment, mass) = self.inertia[body];
        // sᵀIs is below this size for every rigid body, also after the eliminations of its children; an armature is
        // exact.
        let size = turn * turn * moment + slide * slide * mass;
        let counts = step.d > PIVOT * size;
        if counts {
            // Rounding is relative to the remaining inertia, not to that of the frozen subtree.
            let left =
                turn * turn * inertia.angular.trace() + step.s.linear.norm_squared() * inertia.linear.trace();
            self.loss[body] = self.loss[body].max(left / step.d);
        } else {
            let root = (moment * mass).sqrt();
            self.couples_to_parent |= step.u.moment.norm() > PIVOT * (turn * moment + slide * root)
                || step.u.force.norm() > PIVOT * (turn * root + slide * mass);
        }
        for k in 0..K {
            let (about, along) = &mut self.wrench[body][k];
            let t = step.t[k].abs();
            if t == 0.0 {
                continue;
            }
            if counts {
                if k == 0 {
                    let part = t / step.d;
                    let terms = part * (2.0 * (turn * *about + slide * *along) + part * size);
                    self.terms += terms;
                    self.roundings += self.loss[body] * terms;
                }
                *about += step.u.moment.norm() * t / step.d;
                *along += step.u.force.norm() * t / step.d;
            } else {
                let test_size = turn * *about + slide * *along;
                if t > MASSLESS_CLOSING * test_size {
                    self.massless[k] = true;
                    self.massless_limit[k] = self.massless_limit[k].max(PIVOT * size / (t * t));
                } else if k == 0 && t > RESOLVED * test_size {
                    self.closes_faintly = true;
                }
                let size = test_size;
                if k == 0 && t > self.best_closing * size {
                    (self.best_closing, self.best_free) = (t / size, Some(FreeMotion::Joint(body, velocity)));
                }
            }
        }
        self.indefinite |= step.d < -NEGATIVE_PIVOT * size;
        self.dropped += usize::from(!counts);
        counts
    }

    /// Called when the blocks of a cluster are formed.
    pub(super) fn start_cluster(
        &mut self,
        model: &Model,
        number: usize,
        groups: &[GroupMobility],
        elimination: &ClusterElimination<K>,
        armature: &[f64],
    ) {
        let (cluster, d) = (&model.clusters[number], elimination.d);
        self.fill_rate_sizes(model, number, groups, d);
        self.cluster_loss = cluster.bodies.iter().map(|&b| self.loss[b]).fold(ROUTE_ROUNDINGS, f64::max);
        self.pivot_size.clear();
        self.pivot_size.resize(d, 0.0);
        self.pivot_zero.clear();
        self.pivot_zero.resize(d, 0.0);
        self.pivot_terms.clear();
        self.pivot_terms.resize(d, 0.0);
        self.test_size.clear();
        self.test_size.resize(d, [0.0; K]);
        self.motion_size.clear();
        self.motion_size.resize(cluster.bodies.len() * d, (0.0, 0.0));
        let mut velocities = cluster.velocities.iter().zip(&elimination.s).peekable();
        for (at, &b) in cluster.bodies.iter().enumerate() {
            if let Some(parent) = cluster.parents[at] {
                self.motion_size.copy_within(parent * d..(parent + 1) * d, at * d);
            }
            while let Some((v, s)) = velocities.next_if(|(v, _)| v.body == at) {
                let (turn, slide) = self.sizes(b, s);
                for y in 0..d {
                    let rate = self.rate_size[v.coordinate * d + y] * v.multiplier.abs();
                    let size = &mut self.motion_size[at * d + y];
                    *size = (size.0 + turn * rate, size.1 + slide * rate);
                    let own = elimination.g[v.coordinate * d + y] * v.multiplier;
                    self.pivot_size[y] += armature[v.index] * own * own;
                    self.pivot_terms[y] += armature[v.index] * rate * rate;
                }
            }
            let (moment, mass) = self.inertia[b];
            for y in 0..d {
                let psi = &elimination.psi[at * d + y];
                let (turn, slide) = self.motion_size[at * d + y];
                let actual = psi.angular.norm_squared() * moment + psi.linear.norm_squared() * mass;
                self.pivot_size[y] += actual;
                self.pivot_zero[y] += PIVOT * actual;
                self.pivot_terms[y] += turn * turn * moment + slide * slide * mass;
                for k in 0..K {
                    let (about, along) = self.wrench[b][k];
                    self.test_size[y][k] += turn * about + slide * along;
                }
            }
        }
    }

    /// Independent coordinate to eliminate next in the bound cluster `place`; `None` if the remaining motions are massless.
    pub(super) fn next_pivot(&mut self, elimination: &ClusterElimination<K>) -> Option<usize> {
        let d = elimination.d;
        if elimination.order.is_empty() {
            self.pivot_zero
                .iter_mut()
                .zip(&self.pivot_terms)
                .for_each(|(z, terms)| *z += PIVOT_SQUARED * terms);
        }
        let left = |y: usize| elimination.factor[y * d + y];
        let part = |y: usize| left(y) / self.pivot_size[y];
        let open = (0..d).filter(|y| elimination.open[*y] && left(*y) > self.pivot_zero[*y]);
        let pivot = open.max_by(|&a, &b| part(a).total_cmp(&part(b)));
        if let Some(pivot) = pivot {
            let t = elimination.t[pivot][0].abs();
            let ratio = t / left(pivot);
            let terms = ratio * (2.0 * self.test_size[pivot][0] + ratio * self.pivot_terms[pivot]);
            self.cluster_loss = self.cluster_loss.max(self.pivot_size[pivot] / left(pivot));
            self.terms += terms;
            self.roundings += self.cluster_loss * terms;
        }
        pivot
    }

    /// Records the dropped (massless) coordinates of the bound cluster `place` after its last pivot: whether they close the
    /// gap, and whether their remaining pivot is negative beyond rounding.
    pub(super) fn record_dropped(&mut self, place: usize, elimination: &ClusterElimination<K>) {
        for &y in &elimination.dropped {
            self.indefinite |= elimination.factor[y * elimination.d + y]
                < -NEGATIVE_PIVOT * self.pivot_size[y] - self.pivot_zero[y];
            for k in 0..K {
                // Updates through entries of D that are rounding.
                let passed = |p: &usize| {
                    let terms = (self.pivot_terms[y] * self.pivot_terms[*p]).sqrt();
                    elimination.t[*p][k].abs() / elimination.factor[p * elimination.d + p] * terms
                };
                let rounding: f64 = elimination.order.iter().map(passed).sum();
                let (t, size) = (elimination.t[y][k].abs(), self.test_size[y][k] + rounding);
                if t > MASSLESS_CLOSING * size {
                    self.massless[k] = true;
                    self.massless_limit[k] = self.massless_limit[k].max(self.pivot_zero[y] / (t * t));
                }
                if k == 0 && t > self.best_closing * size {
                    (self.best_closing, self.best_free) = (t / size, Some(FreeMotion::Cluster(place, y)));
                }
            }
        }
        self.dropped += elimination.dropped.len();
    }

    /// Adds the sizes of a body's articulated inertia and test wrenches to another body's.
    pub(super) fn propagate_sizes(&mut self, from: usize, to: usize) {
        let (moment, mass) = self.inertia[from];
        self.inertia[to].0 += moment;
        self.inertia[to].1 += mass;
        self.loss[to] = self.loss[to].max(self.loss[from]);
        for k in 0..K {
            let (about, along) = self.wrench[from][k];
            self.wrench[to][k].0 += about;
            self.wrench[to][k].1 += along;
        }
    }

    /// Records the change of the parent's wrench by a pivot of a cluster.
    pub(super) fn propagate_wrench_change(
        &mut self,
        to: usize,
        elimination: &ClusterElimination<K>,
        pivot: usize,
    ) {
        self.loss[to] = self.loss[to].max(self.cluster_loss);
        let d = elimination.factor[pivot * elimination.d + pivot];
        for k in 0..K {
            let part = elimination.t[pivot][k].abs() / d;
            self.wrench[to][k].0 += elimination.u[pivot].moment.norm() * part;
            self.wrench[to][k].1 += elimination.u[pivot].force.norm() * part;
        }
    }
}
