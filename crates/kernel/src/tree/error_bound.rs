//! Bound of the rounding error by the kinetic energy, for a contact of a tree.
//!
//! At each velocity the recursion subtracts U t/D from the propagated force, with |U_k| ≤ √(I_kk D) for each component k and
//! Σ t²/D = 1/m̄. The sizes of its terms are therefore at most `a + b √(1/m̄)`, with constants of the contact and the tree.

use super::branches::Branches;
use super::cluster::MimicCluster;
use super::plan::ScheduledStep;
use super::propagation::smaller;
use super::workspace::EnergyShare;
use crate::tolerances::{
    LARGEST_AMPLIFICATION, LARGEST_ENERGY_ERROR, LOSS_ROUNDINGS, NO_BOUND, NORMAL_ROUNDINGS, ROUTE_ROUNDINGS,
};
use percuss_spatial::lanes::Lanes;

/// Sizes of the terms of a transmitted force and of its moment, for a unit contact force at the distance `arm` (m) from the origin of its
/// body: force + force_per_root·√(1/m̄), and moment_per_arm·arm + moment + moment_per_root·√(1/m̄), m.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct WrenchSize {
    moment_per_arm: f64,
    moment: f64,
    moment_per_root: f64,
    force: f64,
    force_per_root: f64,
}

impl WrenchSize {
    /// Unit force at the contact point, `reach` (m) farther away than the arm; or a unit moment.
    fn unit(reach: f64, is_moment: bool) -> Self {
        match is_moment {
            true => Self { moment: 1.0, ..Self::default() },
            false => Self { moment_per_arm: 1.0, moment: reach, force: 1.0, ..Self::default() },
        }
    }

    fn add(&mut self, other: &Self) {
        self.moment_per_arm += other.moment_per_arm;
        self.moment += other.moment;
        self.moment_per_root += other.moment_per_root;
        self.force += other.force;
        self.force_per_root += other.force_per_root;
    }

    /// Adds bounds of the terms U t/D of some velocities of a body. The entries of U are bounded by the diagonal of the articulated inertia:
    /// three moments with a sum of twice `moment` (kg·m²), and three times `mass` (kg).
    fn add_velocities(&mut self, velocities: usize, moment: f64, mass: f64) {
        let count = velocities as f64;
        self.moment_per_root += (6.0 * moment * count).sqrt();
        self.force_per_root = self.force_per_root.hypot(3.0 * (mass * count).sqrt());
    }

    /// Moves the reference point by at most `reach`, m.
    fn shift(&mut self, reach: f64) {
        self.moment += reach * self.force;
        self.moment_per_root += reach * self.force_per_root;
    }

    /// Power for the twists `angular` (rad/s) and `linear` (m/s), with the arm (m) and `root`, √(1/m̄).
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn power<T: Lanes>(&self, arm: T, root: T, angular: T, linear: T) -> T {
        let of = T::from_f64;
        let moment =
            root.mul_add(of(self.moment_per_root), arm.mul_add(of(self.moment_per_arm), of(self.moment)));
        let force = root.mul_add(of(self.force_per_root), of(self.force));
        moment.mul_add(angular, force * linear)
    }
}

/// A body whose twist is computed: a light body, or a body between a light body and the root of its subtree.
#[derive(Clone, Copy, Debug)]
pub(super) struct TwistStep {
    /// Index of the step.
    pub at: usize,
    /// Sizes of the transmitted forces, for a light body on a contact path.
    pub size: WrenchSize,
    /// Error of the contact force on this body by rotations, relative to that of a transmitted force.
    pub contact_error: f64,
}

/// Bound of the rounding error for a contact.
#[derive(Clone, Debug)]
pub(super) struct ErrorBound {
    /// True if the constants below, or the amplification of a light body, are too large or missing. Then the sizes of terms are computed at
    /// each configuration.
    pub tracks_sizes: bool,
    /// Largest [`amplification`](EnergyShare::amplification) of the bodies that affect the result, except light ones.
    amplification: f64,
    /// Power of the sizes of the forces for the largest twists, all bodies added, √(1/kg):
    /// `constant + per_arm · arm + per_root · √(1/m̄)`. If sizes are tracked, only the power of the contact errors.
    constant: f64,
    per_arm: f64,
    per_root: f64,
    /// Upper bound of the distance between the origins of the two bodies in contact, added over the joints between them, m.
    pub reach: f64,
    /// Error of the contact forces by rotations, relative to that of a transmitted force: the larger one of both bodies.
    contact_error: f64,
    /// Power of these errors for the largest twists, √(1/kg): `contact_constant + contact_per_arm · arm`.
    contact_constant: f64,
    contact_per_arm: f64,
    /// Parents first.
    pub twist_steps: Vec<TwistStep>,
    needs_twist: Vec<bool>,
}

impl ErrorBound {
    pub fn none(steps: usize) -> Self {
        Self {
            tracks_sizes: true,
            amplification: NO_BOUND,
            constant: 0.0,
            per_arm: 0.0,
            per_root: 0.0,
            reach: 0.0,
            contact_error: 0.0,
            contact_constant: 0.0,
            contact_per_arm: 0.0,
            twist_steps: Vec::with_capacity(steps),
            needs_twist: vec![false; steps],
        }
    }

    /// Bound of the rounding error of the `response` 1/m̄ from constants, light bodies excluded, in units of ε, 1/kg.
    ///
    /// A rounding error of an articulated inertia has the effect of an error δI of the inertia of the body itself, with
    /// vᵀ δI v ≤ κ ε vᵀ I v for every twist v. Therefore the relative error of the mass matrix, and of 1/m̄, is at most ε times the
    /// largest κ. An error δf of the force on a body changes 1/m̄ by 2 δf·v, where the twist v satisfies vᵀ I v ≤ 1/m̄.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn of_constants<T: Lanes>(&self, response: T, arm: T) -> EnergyError<T> {
        let of = T::from_f64;
        let root = response.sqrt();
        let sizes = root.mul_add(of(self.per_root), arm.mul_add(of(self.per_arm), of(self.constant)));
        EnergyError { of_inertias: of(self.amplification) * response, of_wrenches: sizes * root }
    }

    /// Bound from tracked sizes: `power` of the sizes for the largest twists, √(1/kg).
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn of_power<T: Lanes>(&self, response: T, arm: T, power: T) -> EnergyError<T> {
        let mut error = self.of_constants(response, arm);
        error.of_wrenches += power * response.sqrt();
        error
    }

    /// Error of 1/m̄ by rotations of the contact forces, in units of ε, 1/kg: the smaller of a bound by the energy and the contact error
    /// times the `terms` (1/kg) of 1/m̄.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn of_contact<T: Lanes>(&self, response: T, arm: T, terms: T) -> T {
        let (constant, per_arm) = (T::from_f64(self.contact_constant), T::from_f64(self.contact_per_arm));
        let by_energy = T::from_f64(2.0) * arm.mul_add(per_arm, constant) * response.sqrt();
        T::from_f64(ROUTE_ROUNDINGS) * smaller(by_energy, T::from_f64(self.contact_error) * terms)
    }

    /// Finds the bound for a contact, or for a moment. `rotations`: number of rotations whose rounding the normal has.
    pub fn find(
        &mut self,
        (steps, clusters): (&[ScheduledStep], &[MimicCluster]),
        branches: &Branches,
        (rotations, is_moment): (f64, bool),
    ) {
        let Branches { path, other, shared, .. } = branches;
        let route = path.len() + other.len() - 2 * shared;
        let reach = |path: &[usize]| path[*shared..].iter().map(|&at| steps[at].step.reach).sum::<f64>();
        let error = |rotations: f64| NORMAL_ROUNDINGS / ROUTE_ROUNDINGS * rotations;
        // The force on the other body is moved to it from the contact link: twice as many rotations as for a normal alone.
        let both = rotations + (2 * route) as f64;
        let errors = [error(rotations), if other.is_empty() { 0.0 } else { error(both) }];
        self.contact_error = errors[0].max(errors[1]);
        self.reach = reach(path) + reach(other);
        self.amplification = self.find_light_bodies(steps, branches);
        let sides = [(path, 0.0, errors[0]), (other, self.reach, errors[1])];
        (self.contact_constant, self.contact_per_arm) = (0.0, 0.0);
        (self.constant, self.per_arm, self.per_root) = (0.0, 0.0, 0.0);
        for (path, reach, error) in sides {
            let Some(&at) = path.last() else { continue };
            let share = &steps[at].step.share;
            let power = match is_moment {
                true => [error * share.angular, 0.0],
                false => [error * (reach * share.angular + share.linear), error * share.angular],
            };
            self.contact_constant += power[0];
            self.contact_per_arm += power[1];
            match self.twist_step(at) {
                Some(light) if share.is_light() => light.contact_error = error,
                _ => {
                    self.constant += power[0];
                    self.per_arm += power[1];
                }
            }
        }
        if self.tracks_sizes {
            return;
        }
        let of_contact = (self.constant, self.per_arm);
        for (path, reach, _) in sides {
            let mut size = WrenchSize::unit(reach, is_moment);
            for &at in path.iter().rev().take_while(|&&at| branches.roles[at].is_on_path()) {
                let step = &steps[at].step;
                let velocities = step.free.iter().filter(|free| **free).count();
                size.add_velocities(velocities, step.moment, step.mass);
                size.shift(step.reach);
                self.add(at, &step.share, &size);
                let leaves_cluster = step.cluster_joint.as_ref().filter(|joint| joint.parent.is_none());
                if let (Some(joint), Some(parent)) = (leaves_cluster, step.parent) {
                    let parent = &steps[steps.len() - 1 - parent].step;
                    let freedoms = clusters[joint.cluster].freedoms;
                    size.add_velocities(freedoms, parent.moment, parent.mass);
                }
            }
        }
        let relative =
            2.0 * f64::EPSILON * (LOSS_ROUNDINGS * self.amplification + ROUTE_ROUNDINGS * self.per_root);
        self.tracks_sizes = relative > LARGEST_ENERGY_ERROR;
        if self.tracks_sizes {
            (self.constant, self.per_arm, self.per_root) = (of_contact.0, of_contact.1, 0.0);
        }
    }

    /// Entry of a step whose twist is computed.
    fn twist_step(&mut self, at: usize) -> Option<&mut TwistStep> {
        // Parents first: in decreasing order.
        let found = self.twist_steps.binary_search_by(|light| at.cmp(&light.at));
        found.ok().map(|index| &mut self.twist_steps[index])
    }

    /// Adds the power of the sizes of the force on a body. The twist of a light body is not known before the evaluation.
    fn add(&mut self, at: usize, share: &EnergyShare, size: &WrenchSize) {
        if share.is_light() {
            if let Some(light) = self.twist_step(at) {
                light.size.add(size);
            }
            return;
        }
        let (angular, linear) = (share.angular, share.linear);
        self.constant += size.moment * angular + size.force * linear;
        self.per_arm += size.moment_per_arm * angular;
        self.per_root += size.moment_per_root * angular + size.force_per_root * linear;
    }

    /// Finds the light bodies that affect the contact, and sets `tracks_sizes` if a constant bound is too large or missing. Returns the
    /// largest [`amplification`](EnergyShare::amplification) of the other bodies. If a body has no bound, or a twist of a cluster would be
    /// needed, no twists are computed, and the result is [`NO_BOUND`].
    fn find_light_bodies(&mut self, steps: &[ScheduledStep], branches: &Branches) -> f64 {
        self.twist_steps.clear();
        self.needs_twist.fill(false);
        self.tracks_sizes = false;
        let last = steps.len() - 1;
        let mut amplification = 0.0_f64;
        // Children before parents.
        for (at, placed) in steps.iter().enumerate().filter(|(at, _)| branches.roles[*at].is_eliminated()) {
            let share = &placed.step.share;
            self.needs_twist[at] |= share.is_light();
            // The twists of clusters are not computed.
            let in_cluster = placed.step.cluster_joint.is_some();
            self.tracks_sizes |= share.amplification > LARGEST_AMPLIFICATION;
            if share.amplification >= NO_BOUND || (in_cluster && self.needs_twist[at]) {
                self.tracks_sizes = true;
                self.twist_steps.clear();
                return NO_BOUND;
            }
            if !share.is_light() {
                amplification = amplification.max(share.amplification);
            }
            if let (true, Some(parent)) = (self.needs_twist[at] && !placed.is_root(), placed.step.parent) {
                self.needs_twist[last - parent] = true;
            }
        }
        let light = (0..steps.len()).rev().filter(|&at| self.needs_twist[at]);
        self.twist_steps.extend(light.map(|at| TwistStep {
            at,
            size: WrenchSize::default(),
            contact_error: 0.0,
        }));
        amplification
    }
}

/// Parts of the error of 1/m̄, 1/kg.
pub(super) struct EnergyError<T> {
    /// By errors of inertias, per unit of relative error.
    pub of_inertias: T,
    /// Power of the sizes of the forces.
    pub of_wrenches: T,
}

impl<T: Lanes> EnergyError<T> {
    /// Adds the effect of the rounding of an inertia, (√moment · angular + √mass · linear)². `roots`: √moment (√(kg·m²)) and √mass (√kg) of
    /// its terms; `angular` (rad/s) and `linear` (m/s): magnitudes of the twist.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn add_inertia(&mut self, roots: [T; 2], angular: T, linear: T) {
        let root = roots[0].mul_add(angular, roots[1] * linear);
        self.of_inertias = root.mul_add(root, self.of_inertias);
    }

    /// Error in units of ε, 1/kg. The factor 2 counts for inertias the roundings of the body and of its children; for forces, the change of
    /// 1/m̄ is 2 δf·v.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn sum(&self) -> T {
        let of = T::from_f64;
        of(2.0 * LOSS_ROUNDINGS).mul_add(self.of_inertias, of(2.0 * ROUTE_ROUNDINGS) * self.of_wrenches)
    }
}
