//! 1/m̄ as the stationary value of an energy.
//!
//! 1/m̄ is the stationary value of L(u, λ) = 2ju − uᵀMu − 2λᵀAu. Rates u and multipliers λ with the residual θ = j −
//! Mu − Aᵀλ, and with the correction δ such that A(u + δ) = 0, give 1/m̄ up to a second-order error:
//!
//! ```text
//! |L − 1/m̄| ≤ 2|θᵀδ| + 3 δᵀMδ + 2 θᵀKθ,   K = G(GᵀMG)⁻¹Gᵀ
//! ```
//!
//! L is a sum over the bodies, of locally transmitted wrenches and local speeds. Its rounding error does not depend
//! on the subtree inertia, unlike the rounding error of the pivots of a long loop.

use crate::kinematics::contact::LocatedContact;
use crate::kinematics::frames::Kinematics;
use crate::linear::dense::solve_square;
use crate::linear::jacobian::Jacobian;
use crate::mobility::GroupMobility;
use crate::model::{Cluster, Group, Model};
use crate::recursion::Recursion;
use crate::tolerances::{DENSE_LIMIT, SUM_ROUNDINGS};
use percuss_spatial::{SpatialInertia, Transform, Twist, Wrench};

/// Result of the recursion for a unit impulse along the normal.
pub(crate) struct Stationary<'a> {
    pub model: &'a Model,
    pub kinematics: &'a Kinematics,
    pub groups: &'a [GroupMobility],
    pub contact: &'a LocatedContact,
    pub recursion: &'a Recursion<1>,
    /// Twists of the bodies, in root axes at the contact point.
    pub twists: &'a [Twist<f64>],
    /// Tree velocities.
    pub velocities: &'a [f64],
}

/// Residuals of the equations.
struct EnergyResiduals {
    /// θ on the tree velocities of plain joints, and on the coordinates of every cluster with constraints.
    joints: Vec<f64>,
    clusters: Vec<Vec<f64>>,
    /// 2 λᵀA u.
    constraint_term: f64,
    /// δ over the tree velocities.
    change: Vec<f64>,
    /// Sum of |θᵢ δᵢ|, a bound for |θᵀδ|.
    work: f64,
}

impl Stationary<'_> {
    /// L (1/kg) at the rates of the recursion, and its error bound. `None` if a motion has zero or negative mass.
    pub fn value(&self) -> Option<(f64, f64)> {
        let (model, recursion) = (self.model, self.recursion);
        let counts = |(cluster, place): (&Cluster, &Option<usize>)| match place {
            None => model.bodies[cluster.bodies[0]].v.clone().all(|v| recursion.joints[v].is_positive()),
            Some(place) => recursion.clusters[*place].is_positive(),
        };
        if !model.clusters.iter().zip(&recursion.cluster_index).all(counts) {
            return None;
        }
        let (twists, slack) = self.body_twists(self.velocities, Some(self.twists));
        let inertias: Vec<SpatialInertia<f64>> = (0..model.bodies.len()).map(|i| self.inertia(i)).collect();
        let transmitted = self.transmitted(&inertias, &twists);
        let left = self.residuals(&transmitted);
        let mut value = Compensated::default();
        value.add(2.0 * self.closing_speed(&twists));
        value.add(-left.constraint_term);
        let mut rounding = 0.0;
        for (i, body) in model.bodies.iter().enumerate() {
            let momentum = inertias[i].momentum(&twists[i]);
            value.add(-momentum.power(&twists[i]));
            rounding += SUM_ROUNDINGS * sizes(&momentum, &magnitude(&twists[i]));
            rounding += SUM_ROUNDINGS * sizes(&transmitted[i], &slack[i]);
            for (v, armature) in body.v.clone().zip(&body.armature) {
                let energy = armature * self.velocities[v] * self.velocities[v];
                value.add(-energy);
                rounding += SUM_ROUNDINGS * energy;
            }
        }
        rounding += SUM_ROUNDINGS * value.total().abs();
        let second = 2.0 * recursion.compliance(model, &left.joints, &left.clusters)
            + 2.0 * left.work
            + 3.0 * self.energy(&inertias, &left.change);
        Some((value.total(), f64::EPSILON * rounding + second))
    }

    /// Twists of the bodies from the root to the tips, and the sum of the magnitudes of the terms of each twist. The
    /// twist of an unconstrained free base is taken from `base`, or zero.
    fn body_twists(&self, rates: &[f64], base: Option<&[Twist<f64>]>) -> (Vec<Twist<f64>>, Vec<Twist<f64>>) {
        let model = self.model;
        let (mut twists, mut slack): (Vec<Twist<f64>>, Vec<Twist<f64>>) = (Vec::new(), Vec::new());
        for (i, body) in model.bodies.iter().enumerate() {
            let mut twist = body.parent.map_or_else(Twist::zero, |p| twists[p]);
            let mut terms = magnitude(&twist);
            if self.is_free_base(i) {
                twist = base.map_or_else(Twist::zero, |twists| twists[i]);
            } else {
                for (k, v) in body.v.clone().enumerate() {
                    let part = self.kinematics.column_at(model, i, k, &self.contact.point_root) * rates[v];
                    twist += part;
                    terms += magnitude(&part);
                }
            }
            twists.push(twist);
            slack.push(terms);
        }
        (twists, slack)
    }

    /// True if the body is a floating base without constraints.
    fn is_free_base(&self, body: usize) -> bool {
        self.model.bodies[body].joint.is_none()
            && self.recursion.cluster_index[self.model.cluster_of[body]].is_none()
    }

    /// Inertia of a body, in root axes at the contact point.
    fn inertia(&self, i: usize) -> SpatialInertia<f64> {
        let frame = &self.kinematics.frames[i];
        let x = Transform::new(frame.rotation, frame.translation - self.contact.point_root);
        x.inertia(&self.model.bodies[i].inertia)
    }

    /// Per body: impulse wrench left over for its joint: the contact's unit impulses on the subtree minus the subtree's
    /// momentum at `twists`. Loop constraints are not included. Root axes, at the contact point.
    fn transmitted(&self, inertias: &[SpatialInertia<f64>], twists: &[Twist<f64>]) -> Vec<Wrench<f64>> {
        let model = self.model;
        let mut transmitted: Vec<Wrench<f64>> =
            inertias.iter().zip(twists).map(|(inertia, twist)| -inertia.momentum(twist)).collect();
        let unit = self.contact.wrench_root();
        for (link, sign) in [(Some(self.contact.link), 1.0), (self.contact.against, -1.0)] {
            if let Some(body) = link.and_then(|link| model.body_of(link)) {
                transmitted[body] += unit * sign;
            }
        }
        for i in (0..model.bodies.len()).rev() {
            if let Some(parent) = model.bodies[i].parent {
                let below = transmitted[i];
                transmitted[parent] += below;
            }
        }
        transmitted
    }

    /// Closing speed of the contact at given twists.
    fn closing_speed(&self, twists: &[Twist<f64>]) -> f64 {
        let unit = self.contact.wrench_root();
        let speed = |link| self.model.body_of(link).map_or(0.0, |b| unit.power(&twists[b]));
        speed(self.contact.link) - self.contact.against.map_or(0.0, speed)
    }

    /// Residuals of the equations of motion along the tree velocities and of the loop constraints, for the wrenches of
    /// [`transmitted`](Self::transmitted).
    fn residuals(&self, transmitted: &[Wrench<f64>]) -> EnergyResiduals {
        let model = self.model;
        let mut left = EnergyResiduals {
            joints: vec![0.0; self.velocities.len()],
            clusters: vec![Vec::new(); self.recursion.clusters.len()],
            constraint_term: 0.0,
            change: vec![0.0; self.velocities.len()],
            work: 0.0,
        };
        for (number, cluster) in model.clusters.iter().enumerate() {
            let Some(place) = self.recursion.cluster_index[number] else {
                let i = cluster.bodies[0];
                for v in model.bodies[i].v.clone() {
                    let inertial = if self.is_free_base(i) {
                        0.0
                    } else {
                        self.recursion.armature[v] * self.velocities[v]
                    };
                    left.joints[v] = transmitted[i].power(&self.recursion.joints[v].s) - inertial;
                }
                continue;
            };
            let n = cluster.coordinates.len();
            let (mut forces, mut rates, mut change) = (vec![0.0; n], vec![0.0; n], vec![0.0; n]);
            for (v, s) in cluster.velocities.iter().zip(&self.recursion.clusters[place].s) {
                let inertial = v.armature * self.velocities[v.index];
                forces[v.coordinate] +=
                    v.multiplier * (transmitted[cluster.bodies[v.body]].power(s) - inertial);
                if v.multiplier != 0.0 {
                    rates[v.coordinate] = self.velocities[v.index] / v.multiplier;
                }
            }
            for own in &cluster.groups {
                let (group, known) = (&model.groups[own.group], &self.groups[own.group]);
                let pivots = Pivoted::new(group, known);
                let force = |c: usize| forces[own.coordinates[c]] / group.lengths[c];
                let multipliers =
                    pivots.multipliers(&known.pivots.columns.iter().map(|&c| force(c)).collect::<Vec<_>>());
                let mut open = vec![0.0; multipliers.len()];
                known.rows.for_each(group, |r, c, a| {
                    let i = pivots.row_of[r];
                    if i != usize::MAX {
                        forces[own.coordinates[c]] -= multipliers[i] * a;
                        open[i] += a * rates[own.coordinates[c]];
                    }
                });
                left.constraint_term += 2.0 * multipliers.iter().zip(&open).map(|(l, o)| l * o).sum::<f64>();
                for (step, &c) in pivots.solve_closing_step(&open).iter().zip(&known.pivots.columns) {
                    change[own.coordinates[c]] = -step / group.lengths[c];
                }
            }
            left.work += forces.iter().zip(&change).map(|(f, d)| (f * d).abs()).sum::<f64>();
            cluster
                .velocities
                .iter()
                .for_each(|v| left.change[v.index] = change[v.coordinate] * v.multiplier);
            left.clusters[place] = forces;
        }
        left
    }

    /// Twice the kinetic energy of a motion of the tree.
    fn energy(&self, inertias: &[SpatialInertia<f64>], rates: &[f64]) -> f64 {
        let (twists, _) = self.body_twists(rates, None);
        let bodies: f64 = inertias.iter().zip(&twists).map(|(i, t)| i.twice_energy(t).abs()).sum();
        bodies + self.recursion.armature.iter().zip(rates).map(|(a, v)| a * v * v).sum::<f64>()
    }
}

/// K = A[rows, columns] of a group, over coordinates scaled by lengths.
pub(crate) struct Pivoted {
    /// For each row of A: the index of its pivot.
    pub row_of: Vec<usize>,
    count: usize,
    /// (row, column, value), by pivot indices.
    entries: Vec<(usize, usize, f64)>,
}

impl Pivoted {
    /// Takes the pivot rows and columns of a group from its decided mobility.
    pub fn new(group: &Group, known: &GroupMobility) -> Self {
        let (mut row_of, mut column_of) =
            (vec![usize::MAX; group.rows], vec![usize::MAX; group.coordinates.len()]);
        known.pivots.rows.iter().enumerate().for_each(|(i, r)| row_of[*r] = i);
        known.pivots.columns.iter().enumerate().for_each(|(i, c)| column_of[*c] = i);
        let mut entries = Vec::new();
        known.rows.for_each(group, |r, c, a| {
            if row_of[r] != usize::MAX && column_of[c] != usize::MAX {
                entries.push((row_of[r], column_of[c], a / group.lengths[c]));
            }
        });
        Self { row_of, count: known.pivots.rows.len(), entries }
    }

    /// Solves Kᵀλ = force on the dependent coordinates.
    pub fn multipliers(&self, forces: &[f64]) -> Vec<f64> {
        self.solve(self.entries.iter().map(|&(r, c, a)| (c, r, a)).collect(), forces)
    }

    /// Solves K x = open; `open`: residual rates of the pivot rows.
    pub fn solve_closing_step(&self, open: &[f64]) -> Vec<f64> {
        self.solve(self.entries.clone(), open)
    }

    /// Solution of the square system with the given (row, column, value) entries and right side; dense for small systems.
    fn solve(&self, entries: Vec<(usize, usize, f64)>, right: &[f64]) -> Vec<f64> {
        let count = self.count;
        if count > DENSE_LIMIT {
            return Jacobian { rows: count, columns: count, entries }.shortest(right, f64::EPSILON);
        }
        let (mut square, mut right) = (vec![0.0; count * count], right.to_vec());
        entries.into_iter().for_each(|(i, k, a)| square[i * count + k] += a);
        solve_square(&mut square, &mut right);
        right
    }
}

/// Compensated sum (Neumaier 1974; cited from memory).
#[derive(Default)]
struct Compensated {
    sum: f64,
    lost: f64,
}

impl Compensated {
    fn add(&mut self, x: f64) {
        let sum = self.sum + x;
        self.lost += if self.sum.abs() >= x.abs() { (self.sum - sum) + x } else { (x - sum) + self.sum };
        self.sum = sum;
    }

    fn total(&self) -> f64 {
        self.sum + self.lost
    }
}

fn magnitude(twist: &Twist<f64>) -> Twist<f64> {
    Twist::new(twist.angular.abs(), twist.linear.abs())
}

/// Sum of the magnitudes of the terms of the power of a wrench on a twist of magnitudes.
fn sizes(wrench: &Wrench<f64>, twist: &Twist<f64>) -> f64 {
    Wrench::new(wrench.moment.abs(), wrench.force.abs()).power(twist)
}
