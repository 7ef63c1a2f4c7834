//! Error budget of m̄: rounding, closing error of the loops, and inexactness of the file.
//!
//! First-order perturbation of 1/m̄ under a unit impulse, with the twists V, the wrenches h transmitted by the
//! joints, the rates u and the multipliers λ of the constraints:
//!
//! ```text
//! δ(1/m̄) = −VᵀδI V + 2 Vᵀδf + 2u δSᵀh + 2λᵀδA u
//! ```
//!
//! The terms are changes of a body's inertia, of a wrench on a body, of a joint's column, and of rows of A. λ
//! balances the forces τ of the tree on the dependent coordinates: λᵀK = τ. An error in the summation of Iᴬ is
//! equivalent to an error of the body's inertia, so the terms of the recursion bound the error. Each elimination is
//! weighted by the articulated inertia below the joint, not by the composite inertia of the frozen subtree. Method:
//! running error analysis, Higham, Accuracy and Stability of Numerical Algorithms, 2002, §3.3 (cited from memory).

mod frozen;
mod multipliers;
mod rows;

use self::multipliers::MultiplierWorkspace;
use crate::error::stationary::Stationary;
use crate::kinematics::contact::LocatedContact;
use crate::kinematics::frames::Kinematics;
use crate::mobility::GroupMobility;
use crate::model::{Cluster, Model};
use crate::recursion::{ClusterElimination, Recursion};
use crate::tolerances::{NOTHING_LEFT, REPEATED_ROUNDINGS, SUM_ROUNDINGS, TURN_ROUNDINGS, VAGUE_RESPONSE};
use nalgebra::{Vector3, Vector6};
use percuss_mechanism::LinkId;
use percuss_spatial::{ArticulatedInertia, Transform, Twist, Wrench};

/// First-order error of m̄, kg, in three parts. A part without a measure is `None`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ErrorBudget {
    /// Rounding of positions, frames, constraint rows and of the route.
    pub rounding: Option<f64>,
    /// Error due to the residual of the loops; 0 without loops.
    pub closing: Option<f64>,
    /// Error due to the misfit of the file's loops. Only redundant rows measure the misfit; `None` without redundant
    /// rows.
    pub file: Option<f64>,
}

impl ErrorBudget {
    /// Sum of the known parts, kg: rounding, closing, and the file's part if redundant rows measure this part. `None`
    /// if rounding or closing is unknown; both normally have a measure.
    #[inline(never)] // Inlined, the comparison of an absent part may precede the test of its presence.
    pub fn known(&self) -> Option<f64> {
        Some(self.rounding? + self.closing? + self.file.unwrap_or(0.0))
    }

    pub(crate) fn scaled(self, factor: f64) -> Self {
        let part = |p: Option<f64>| p.map(|p| p * factor);
        Self { rounding: part(self.rounding), closing: part(self.closing), file: part(self.file) }
    }
}

/// Error bounds of the body frames, in units of ε.
#[derive(Clone, Debug, Default)]
struct FrameErrors {
    /// For every body: orientation (rad) and position (m).
    bounds: Vec<(f64, f64)>,
    /// For every body: squared random walks of orientation and position, and the number of joints from the root.
    walks: Vec<(f64, f64, f64)>,
}

impl FrameErrors {
    /// Accumulates the error bounds from the root to the tips.
    fn fill(&mut self, model: &Model, kinematics: &Kinematics) {
        self.bounds.clear();
        self.walks.clear();
        for (i, body) in model.bodies.iter().enumerate() {
            let (turn, place, depth) = body.parent.map_or((0.0, 0.0, 0.0), |p| self.walks[p]);
            let (parent_turn, parent_position) =
                body.parent.map_or((0.0, 0.0), |p| (self.bounds[p].0, self.bounds[p].1 - place.sqrt()));
            let step = kinematics.parent_transforms[i].translation.norm();
            let position = kinematics.frames[i].translation.norm();
            let own = SUM_ROUNDINGS * step + 2.0 * position;
            let walk = (turn + TURN_ROUNDINGS * TURN_ROUNDINGS, place + own * own, depth + 1.0);
            self.bounds.push((
                walk.0.sqrt() + REPEATED_ROUNDINGS * walk.2,
                parent_position + parent_turn * step + walk.1.sqrt(),
            ));
            self.walks.push(walk);
        }
    }

    /// Error bounds of a body: orientation (rad) and position (m); zero for the ground.
    fn at(&self, body: Option<usize>) -> (f64, f64) {
        body.map_or((0.0, 0.0), |b| self.bounds[b])
    }
}

/// Accumulation of frame position errors.
#[derive(Clone, Copy, Debug, PartialEq)]
enum FrameErrorMode {
    /// Summed from the root to each body.
    Accumulated,
    /// Per joint, weighted by the transmitted wrench. The errors of a long chain are then not summed.
    ByJoint,
}

/// Buffers for the terms of an error budget; refilled in place.
#[derive(Clone, Debug, Default)]
pub(crate) struct BudgetWorkspace {
    frames: FrameErrors,
    /// Wrench transmitted by each body's joint. Within a cluster with constraints, constraint wrenches are excluded.
    transmitted: Vec<Wrench<f64>>,
    /// For every body: moment (kg·m²) and mass (kg) of the subtree with frozen joints. Filled on first use.
    composites: Vec<(f64, f64)>,
    /// Result 1/m̄ of the recursion, a sum over all joints; with `composites`.
    response: f64,
    /// Change of 1/m̄ due to motions dropped (frozen) as massless, 1/kg.
    frozen: f64,
    /// Forces of the tree on the coordinates of the current cluster, and the rates of the coordinates.
    forces: Vec<f64>,
    rates: Vec<f64>,
    /// Rates of the independent coordinates of the current cluster.
    independent: Vec<f64>,
    /// Sum of the terms and largest entry of each row of the current group.
    terms: Vec<f64>,
    largest: Vec<f64>,
    multipliers: MultiplierWorkspace,
    /// Constraint wrenches on each body of the current cluster.
    closing: Vec<Wrench<f64>>,
}

impl BudgetWorkspace {
    /// True if errors were computed before, so that the buffers are allocated.
    pub fn is_filled(&self) -> bool {
        !self.frames.bounds.is_empty()
    }
}

/// Result of a route for a unit impulse along the normal: the input of the error budget.
pub(crate) struct UnitImpulse<'a> {
    pub model: &'a Model,
    pub kinematics: &'a Kinematics,
    pub groups: &'a [GroupMobility],
    /// For each group: residual misfit of its loops, relative to the group's size.
    pub misfits: &'a [f64],
    pub contact: &'a LocatedContact,
    /// Twists of the bodies, in root axes at the contact point.
    pub twists: &'a [Twist<f64>],
    /// Tree velocities.
    pub velocities: &'a [f64],
}

/// Parts of the error of 1/m̄, relative to 1/m̄.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct RelativeErrors {
    pub rounding: f64,
    /// Part of `rounding` caused by the route itself; another route could avoid this part.
    pub route: f64,
    /// Part of `route` caused by motions dropped because their mass is below rounding, although the motions couple to
    /// the contact.
    pub frozen: f64,
    /// Error due to constraint rows that are wrong by the misfit of their loops.
    pub file: f64,
    /// Largest misfit of a moving group.
    pub misfit: f64,
    /// True if a moving group has redundant rows, which measure the misfit.
    pub is_measured: bool,
    /// Stationary value of the energy (1/kg), if the pivot sum of the recursion is too inaccurate; `rounding` then
    /// applies to this value.
    pub stationary: Option<f64>,
}

impl RelativeErrors {
    /// Adds the relative change of 1/m̄ by frozen motions; 1 puts all of m̄ in doubt.
    pub fn with_frozen(self, change: f64) -> Self {
        let Self { rounding, route, frozen, .. } = self;
        Self { rounding: rounding + change, route: route + change, frozen: frozen + change, ..self }
    }
}

impl UnitImpulse<'_> {
    /// Errors of the recursion's result. `is_clear`: the rounding of the recursion is known to be negligible.
    pub fn recursion_errors(
        &self,
        workspace: &mut BudgetWorkspace,
        recursion: &Recursion<1>,
        is_clear: bool,
    ) -> RelativeErrors {
        let (mut route, mut stationary) = (self.elimination_error(workspace, recursion), None);
        let response = recursion.response(0, 0);
        // Pivots of a tree contain only inertia transmitted from below the joint, so the energy is not needed.
        if !is_clear && !recursion.clusters.is_empty() && f64::EPSILON * route > VAGUE_RESPONSE * response {
            let found = self.stationary(recursion).value().filter(|(value, error)| {
                *value > 0.0 && *error < NOTHING_LEFT * value && *error < f64::EPSILON * route
            });
            if let Some((value, error)) = found {
                route = error / f64::EPSILON;
                stationary = Some(value);
            }
        }
        let places = if stationary.is_some() { FrameErrorMode::ByJoint } else { FrameErrorMode::Accumulated };
        let mut sum = self.data_errors(workspace, recursion, places);
        sum.rounding += route;
        sum.route = route;
        sum.frozen = workspace.frozen;
        sum.stationary = stationary;
        self.relative(sum, response)
    }

    /// Relative error of the recursion itself, from its eliminations alone. Equal to `route` of
    /// [`of_recursion`](Self::of_recursion), if small.
    pub fn route_error(&self, workspace: &mut BudgetWorkspace, recursion: &Recursion<1>) -> f64 {
        f64::EPSILON * self.elimination_error(workspace, recursion) / recursion.response(0, 0)
    }

    /// Sum of the errors of all eliminations, in units of ε.
    fn elimination_error(&self, workspace: &mut BudgetWorkspace, recursion: &Recursion<1>) -> f64 {
        workspace.composites.clear();
        workspace.frozen = 0.0;
        let of_cluster = |(number, cluster): (usize, &Cluster)| match recursion.cluster_index[number] {
            None => self.joint_elimination_error(workspace, recursion, cluster.bodies[0]),
            Some(place) => {
                self.cluster_elimination_error(workspace, recursion, cluster, &recursion.clusters[place])
            }
        };
        self.model.clusters.iter().enumerate().map(of_cluster).sum()
    }

    /// The same result as the stationary value of the energy.
    pub fn stationary<'b>(&'b self, recursion: &'b Recursion<1>) -> Stationary<'b> {
        Stationary {
            model: self.model,
            kinematics: self.kinematics,
            groups: self.groups,
            contact: self.contact,
            recursion,
            twists: self.twists,
            velocities: self.velocities,
        }
    }

    /// Divides a sum of errors by the response 1/m̄.
    fn relative(&self, sum: RelativeErrors, response: f64) -> RelativeErrors {
        RelativeErrors {
            rounding: f64::EPSILON * sum.rounding / response,
            route: f64::EPSILON * sum.route / response,
            frozen: sum.frozen / response,
            file: sum.file / response,
            is_measured: sum.is_measured,
            misfit: sum.misfit,
            stationary: sum.stationary,
        }
    }

    /// Wrench transmitted by the joint of every body, accumulated along the tree within clusters with constraints.
    fn fill_transmitted(&self, transmitted: &mut Vec<Wrench<f64>>, recursion: &Recursion<1>) {
        let own = |i: usize| {
            recursion.wrenches[i][0] - self.propagated_inertia(recursion, i).apply(&self.twists[i])
        };
        transmitted.clear();
        transmitted.extend((0..self.model.bodies.len()).map(own));
        for cluster in self.model.clusters.iter().filter(|c| c.is_bound) {
            for at in (0..cluster.bodies.len()).rev() {
                if let Some(parent) = cluster.parents[at] {
                    let below = transmitted[cluster.bodies[at]];
                    transmitted[cluster.bodies[parent]] += below;
                }
            }
        }
    }

    /// Errors common to all routes: frames, body inertias, joint columns, the contact, rows of A.
    fn data_errors(
        &self,
        workspace: &mut BudgetWorkspace,
        recursion: &Recursion<1>,
        places: FrameErrorMode,
    ) -> RelativeErrors {
        let (model, kinematics) = (self.model, self.kinematics);
        self.fill_transmitted(&mut workspace.transmitted, recursion);
        workspace.frames.fill(model, kinematics);
        let mut sum = RelativeErrors::default();
        self.add_row_errors(workspace, places, &mut sum);
        let BudgetWorkspace { frames, transmitted, .. } = &*workspace;
        let on = frames.at(model.body_of(self.contact.link));
        let against = frames.at(self.contact.against.and_then(|l| model.body_of(l)));
        let point = &self.contact.point_root;
        let reach = point.norm();
        let own_contact_error = 2.0 * reach + (on.0 + SUM_ROUNDINGS) * self.contact.point_link.norm();
        let contact_error = (on.0.max(against.0), on.1 + own_contact_error);
        // The normal rotates with a link; a rotation error is multiplied by the relative velocity.
        let relative = self.relative_velocity().norm();
        sum.rounding += 2.0 * (TURN_ROUNDINGS + contact_error.0) * relative;
        if let Some((end, at)) = self.contact.line {
            // A line rotates by the position errors of its ends divided by its length.
            let far = frames.at(model.body_of(end));
            let position = kinematics.link_frame(model, end).point(&at);
            let off = far.1 + 2.0 * position.norm() + (far.0 + SUM_ROUNDINGS) * at.norm();
            let length = (position - point).norm();
            sum.rounding += 2.0 * (contact_error.1 + off) / length * relative;
            sum.file += 2.0 * self.largest_misfit([self.contact.link, end]) / length * relative;
        }
        let by_joint = places == FrameErrorMode::ByJoint;
        let has_point = by_joint && !self.contact.is_moment;
        if let Some(other) = self.contact.against.and_then(|l| model.body_of(l)).filter(|_| has_point) {
            // The contact point belongs to the contact link; relative to the other link it has a position error.
            sum.rounding += 2.0 * self.position_error_between(frames) * self.twists[other].angular.norm();
        }
        for (i, body) in model.bodies.iter().enumerate() {
            let (turn, place) = frames.bounds[i];
            let arm = kinematics.frames[i].translation - point;
            let off = if by_joint {
                own_contact_error + 2.0 * kinematics.frames[i].translation.norm() + arm.norm()
            } else {
                place + contact_error.1 + arm.norm()
            };
            let twist = &self.twists[i];
            let x = Transform::new(kinematics.frames[i].rotation, arm);
            let own = x.inertia(&body.inertia);
            let (omega, speed) = (twist.angular.norm(), twist.linear.norm());
            let root = own.rotational.trace().abs().sqrt() * omega + own.mass.abs().sqrt() * speed;
            sum.rounding += SUM_ROUNDINGS * root * root;
            let at_origin = twist.velocity_at(&arm);
            let own_root = body.inertia.rotational.trace().abs().sqrt() * omega
                + body.inertia.mass.abs().sqrt() * at_origin.norm();
            sum.rounding += 2.0 * (turn + TURN_ROUNDINGS) * own_root * own_root;
            sum.rounding += 2.0 * omega * off * own.momentum(twist).force.norm();
            if by_joint {
                sum.rounding += self.joint_frame_error(i, turn, off, &transmitted[i]);
                continue;
            }
            // A free base has no frame error: all frames are relative to the base.
            for (k, v) in body.v.clone().enumerate().filter(|_| body.joint.is_some()) {
                let rate = self.velocities[v].abs();
                let s = kinematics.column_at(model, i, k, point);
                let (axis, lever) = (s.angular.norm(), s.linear.norm());
                sum.rounding += 2.0
                    * rate
                    * ((turn + TURN_ROUNDINGS) * axis * transmitted[i].moment.norm()
                        + (axis * off + (turn + TURN_ROUNDINGS) * lever) * transmitted[i].force.norm());
            }
        }
        sum
    }

    /// Position error of the contact point on the other side, caused by the joints between the two sides.
    fn position_error_between(&self, frames: &FrameErrors) -> f64 {
        let (model, kinematics, point) = (self.model, self.kinematics, &self.contact.point_root);
        let (mut alike, mut squares) = (0.0, 0.0);
        let on = model.body_of(self.contact.link);
        let against = self.contact.against.and_then(|link| model.body_of(link));
        model.for_each_support(on, against, |i, _| {
            let place = &kinematics.frames[i].translation;
            let arm = (place - point).norm();
            // Products of rotations accumulate scaling errors as large as the orientation errors.
            let own = (SUM_ROUNDINGS + frames.walks[i].0.sqrt())
                * kinematics.parent_transforms[i].translation.norm()
                + 2.0 * place.norm();
            alike += REPEATED_ROUNDINGS * arm;
            squares += (TURN_ROUNDINGS * arm).powi(2) + own * own;
        });
        2.0 * point.norm() + SUM_ROUNDINGS * self.contact.point_link.norm() + alike + squares.sqrt()
    }

    /// Error of 1/m̄ due to the frame error of one joint. The frame error moves the subtree rigidly, so only the
    /// transmitted wrench matters.
    fn joint_frame_error(&self, i: usize, turn: f64, off: f64, transmitted: &Wrench<f64>) -> f64 {
        let (model, kinematics, point) = (self.model, self.kinematics, &self.contact.point_root);
        let body = &model.bodies[i];
        // A free base has no frame error: all frames are relative to the base.
        if body.joint.is_none() {
            return 0.0;
        }
        let arm = kinematics.frames[i].translation - point;
        let force = transmitted.force.norm();
        let moment = (transmitted.moment - arm.cross(&transmitted.force)).norm();
        let (own, carrier) = (&self.twists[i], body.parent.map_or_else(Twist::zero, |p| self.twists[p]));
        let turning = own.angular.norm() + carrier.angular.norm();
        let moving = own.velocity_at(&arm).norm() + carrier.velocity_at(&arm).norm();
        let shift = (SUM_ROUNDINGS + turn) * kinematics.parent_transforms[i].translation.norm()
            + 2.0 * kinematics.frames[i].translation.norm();
        let mut sum = TURN_ROUNDINGS * (turning * moment + moving * force) + shift * turning * force;
        for (k, v) in body.v.clone().enumerate() {
            let s = kinematics.column_at(model, i, k, point);
            let (axis, lever) = (s.angular.norm(), s.velocity_at(&arm).norm());
            sum += self.velocities[v].abs()
                * ((turn + TURN_ROUNDINGS) * (axis * moment + lever * force) + 2.0 * axis * off * force);
        }
        2.0 * sum
    }

    /// Velocity of the contact link at the contact point relative to the other side; the angular velocity for a moment.
    fn relative_velocity(&self) -> Vector3<f64> {
        let velocity = |body: Option<usize>| {
            body.map_or_else(Vector3::zeros, |b| self.contact.conjugate_velocity(&self.twists[b]))
        };
        velocity(self.model.body_of(self.contact.link))
            - velocity(self.contact.against.and_then(|l| self.model.body_of(l)))
    }

    /// Largest misfit, m, of the loops that contain an ancestor of one of the links.
    fn largest_misfit(&self, links: [LinkId; 2]) -> f64 {
        let mut carriers = vec![false; self.model.bodies.len()];
        for body in links.into_iter().filter_map(|link| self.model.body_of(link)) {
            std::iter::successors(Some(body), |&b| self.model.bodies[b].parent)
                .for_each(|b| carriers[b] = true);
        }
        let groups = self.model.groups.iter().zip(self.misfits);
        let carrying = groups.filter(|(group, _)| group.bodies.iter().any(|&b| carriers[b]));
        carrying.map(|(group, misfit)| misfit * group.size).fold(0.0, f64::max)
    }

    /// Iᴬ propagated to a body, before the elimination of the body's own joint.
    fn propagated_inertia(&self, recursion: &Recursion<1>, i: usize) -> ArticulatedInertia<f64> {
        let mut inertia = recursion.inertias[i];
        if recursion.cluster_index[self.model.cluster_of[i]].is_none() {
            for e in self.model.bodies[i].v.clone().map(|v| &recursion.joints[v]).filter(|e| e.counts) {
                inertia.subtract_dyad(&(e.u * (-1.0 / e.d)), &e.u);
            }
        }
        inertia
    }

    /// Error of the elimination of a plain joint. The inertia left after each pivot is weighted by the motion of the
    /// body with the eliminated velocities at zero. This motion can be much faster than the motion of the body and
    /// its parent.
    fn joint_elimination_error(
        &self,
        workspace: &mut BudgetWorkspace,
        recursion: &Recursion<1>,
        i: usize,
    ) -> f64 {
        let body = &self.model.bodies[i];
        let mut squares = diagonal(&recursion.inertias[i]);
        let mut twist = body.parent.map_or_else(Twist::zero, |p| self.twists[p]);
        let mut sum = 0.0;
        // From the last pivot back to the first; each pivot adds the terms that its elimination subtracted.
        for &v in recursion.order[body.v.clone()].iter().rev() {
            let (e, rate) = (&recursion.joints[v], self.velocities[v]);
            if !e.counts {
                continue;
            }
            let (m, f) = (&e.u.moment, &e.u.force);
            let u = Vector6::new(m.x, m.y, m.z, f.x, f.y, f.z);
            squares += u.component_mul(&u) * (1.0 / e.d);
            let moving = components(&twist);
            let left = energy_root(&squares.map(|x| x.abs().sqrt()), &moving);
            let passed = dot_abs(&e.u, &moving) * (e.t[0] / e.d).abs();
            sum += SUM_ROUNDINGS * (left * left + passed + e.d * rate * rate + (e.t[0] * rate).abs());
            twist += e.s * rate;
        }
        let roots = squares.map(|x| x.abs().sqrt());
        let own = energy_root(&roots, &components(&self.twists[i]));
        sum += SUM_ROUNDINGS * own * own;
        if body.v.clone().any(|v| !recursion.joints[v].counts) {
            let frozen = self.frozen_change(workspace, recursion, i, &roots);
            workspace.frozen += frozen;
            sum += frozen / f64::EPSILON;
        }
        sum + 2.0 * SUM_ROUNDINGS * dot_abs(&recursion.wrenches[i][0], &components(&self.twists[i]))
    }

    /// Error of the elimination of a cluster with constraints.
    fn cluster_elimination_error(
        &self,
        workspace: &mut BudgetWorkspace,
        recursion: &Recursion<1>,
        cluster: &Cluster,
        eliminated: &ClusterElimination<1>,
    ) -> f64 {
        let d = eliminated.d;
        let carrier = cluster.parent.map_or_else(Twist::zero, |p| self.twists[p]);
        let u = &mut workspace.independent;
        eliminated.fill_independent_rates(&carrier, true, None, u);
        let parent_motion = components(&carrier);
        let mut sum = 0.0;
        for (at, &b) in cluster.bodies.iter().enumerate() {
            // Roundings of many terms are added as a random walk.
            let mut squares = parent_motion.component_mul(&parent_motion);
            for (psi, u) in eliminated.psi[at * d..(at + 1) * d].iter().zip(&*u) {
                let part = components(psi) * *u;
                squares += part.component_mul(&part);
            }
            let terms = squares.map(f64::sqrt);
            let root = energy_root(&roots(&recursion.inertias[b]), &terms);
            sum += (SUM_ROUNDINGS + (d as f64).sqrt()) * root * root;
            sum += 2.0 * SUM_ROUNDINGS * dot_abs(&recursion.wrenches[b][0], &terms);
        }
        for &y in &eliminated.order {
            let part = eliminated.t[y][0] / eliminated.factor[y * d + y];
            sum += SUM_ROUNDINGS
                * (eliminated.t[y][0] * part + 2.0 * dot_abs(&eliminated.u[y], &parent_motion) * part.abs());
        }
        sum
    }

    /// Errors of the dense route: a backward error of n ε in M scaled to unit diagonal, and in the rows A and j. `mass_size`: term sizes of
    /// the diagonal entries of M. The last argument: 1/m̄ and the sensitivity to the rows.
    pub fn dense_errors(
        &self,
        workspace: &mut BudgetWorkspace,
        recursion: &Recursion<1>,
        mass_size: &[f64],
        coordinates: &[f64],
        (response, row_sensitivity): (f64, f64),
    ) -> RelativeErrors {
        let mut sum = self.data_errors(workspace, recursion, FrameErrorMode::Accumulated);
        let root: f64 = mass_size.iter().zip(coordinates).map(|(m, v)| m.abs().sqrt() * v.abs()).sum();
        sum.route = SUM_ROUNDINGS * coordinates.len() as f64 * (root * root + row_sensitivity * response);
        sum.rounding += sum.route;
        self.relative(sum, response)
    }
}

/// Square roots of the diagonal of an inertia. The entries of a positive inertia are bounded by the products of two
/// of these roots.
fn roots(inertia: &ArticulatedInertia<f64>) -> Vector6<f64> {
    diagonal(inertia).map(|x| x.abs().sqrt())
}

/// Diagonal of an inertia: angular, then linear components.
fn diagonal(inertia: &ArticulatedInertia<f64>) -> Vector6<f64> {
    let (a, l) = (&inertia.angular, &inertia.linear);
    Vector6::new(a.m11, a.m22, a.m33, l.m11, l.m22, l.m33)
}

/// Magnitudes of the components of a twist.
fn components(twist: &Twist<f64>) -> Vector6<f64> {
    let (w, v) = (&twist.angular, &twist.linear);
    Vector6::new(w.x, w.y, w.z, v.x, v.y, v.z).map(f64::abs)
}

/// Bound for the root energy of a motion: roots of the inertia's diagonal times component magnitudes.
fn energy_root(roots: &Vector6<f64>, components: &Vector6<f64>) -> f64 {
    roots.dot(components)
}

/// Sum of the term magnitudes of the power of a wrench.
fn dot_abs(wrench: &Wrench<f64>, components: &Vector6<f64>) -> f64 {
    let (m, f) = (&wrench.moment, &wrench.force);
    Vector6::new(m.x, m.y, m.z, f.x, f.y, f.z).map(f64::abs).dot(components)
}
