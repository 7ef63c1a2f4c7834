//! How far m̄ may be off: rounding, closing, file.
//!
//! First-order perturbations of 1/m̄ under a unit impulse, with V the twists, h the wrenches that joints transmit, u the rates
//! and λ the multipliers of the constraints:
//!
//! ```text
//! δ(1/m̄) = −VᵀδI V + 2 Vᵀδf + 2u δSᵀh + 2λᵀδA u
//! ```
//!
//! for changes of a body's inertia, of a wrench on it, of a joint's column, of rows of A. λ balances what the tree leaves on the
//! coordinates that depend: λᵀK = τ. An error made while Iᴬ is summed up is an error of the body's inertia, so the
//! recursion's own terms bound it: each step counts by what is left below it, not by all that hangs there frozen. Running
//! error analysis: Higham, Accuracy and Stability of Numerical Algorithms, 2002, §3.3 (cited from memory).

mod frozen;
mod multipliers;
mod rows;

use self::multipliers::MultiplierRoom;
use crate::contact::LocatedContact;
use crate::kinematics::Kinematics;
use crate::mobility::GroupMobility;
use crate::model::{Cluster, Model};
use crate::recursion::{ClusterElimination, Recursion};
use crate::stationary::Stationary;
use crate::tolerances::{NOTHING_LEFT, REPEATED_ROUNDINGS, SUM_ROUNDINGS, TURN_ROUNDINGS, VAGUE_RESPONSE};
use nalgebra::{Vector3, Vector6};
use percuss_mechanism::LinkId;
use percuss_spatial::{ArticulatedInertia, Transform, Twist, Wrench};

/// What m̄ may be off by, kg, to first order. A part that nothing measures is none.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ErrorBudget {
    /// Rounding of positions, frames, rows and of the route itself.
    pub rounding: Option<f64>,
    /// What the loops' residual leaves open; 0 where nothing closes.
    pub closing: Option<f64>,
    /// How far the file's loops are from fitting. Only redundant rows measure it: none, unknown, where there are none.
    pub file: Option<f64>,
}

impl ErrorBudget {
    /// The sum of what is known, kg: rounding, closing, and the file's part where redundant rows measure it. None where
    /// rounding or closing is unknown: these always have a measure.
    pub fn known(&self) -> Option<f64> {
        Some(self.rounding? + self.closing? + self.file.unwrap_or(0.0))
    }

    pub(crate) fn scaled(self, factor: f64) -> Self {
        let part = |p: Option<f64>| p.map(|p| p * factor);
        Self { rounding: part(self.rounding), closing: part(self.closing), file: part(self.file) }
    }
}

/// How far the frames of bodies may be off, in units of ε.
#[derive(Clone, Debug, Default)]
struct FrameErrors {
    /// For every body: orientation (rad) and position (m).
    of: Vec<(f64, f64)>,
    /// For every body: the squares of its random walks, and how many joints carry it.
    walks: Vec<(f64, f64, f64)>,
}

impl FrameErrors {
    fn fill(&mut self, model: &Model, kinematics: &Kinematics<f64>) {
        self.of.clear();
        self.walks.clear();
        for (i, body) in model.bodies.iter().enumerate() {
            let (turn, place, depth) = body.parent.map_or((0.0, 0.0, 0.0), |p| self.walks[p]);
            let (carried, from) =
                body.parent.map_or((0.0, 0.0), |p| (self.of[p].0, self.of[p].1 - place.sqrt()));
            let step = kinematics.steps[i].translation.norm();
            let position = kinematics.frames[i].translation.norm();
            let own = SUM_ROUNDINGS * step + 2.0 * position;
            let walk = (turn + TURN_ROUNDINGS * TURN_ROUNDINGS, place + own * own, depth + 1.0);
            self.of
                .push((walk.0.sqrt() + REPEATED_ROUNDINGS * walk.2, from + carried * step + walk.1.sqrt()));
            self.walks.push(walk);
        }
    }

    fn at(&self, body: Option<usize>) -> (f64, f64) {
        body.map_or((0.0, 0.0), |b| self.of[b])
    }
}

/// How errors of the frames' places are counted.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Places {
    /// Added up from the root to each body.
    Added,
    /// Each joint's own, by what it transmits: those of a long chain do not add up.
    ByJoint,
}

/// Room for the terms of an error budget; refilled in place.
#[derive(Clone, Debug, Default)]
pub(crate) struct BudgetRoom {
    frames: FrameErrors,
    /// The wrench that each body's joint transmits; within a bound cluster without those of its constraints.
    transmitted: Vec<Wrench<f64>>,
    /// For every body: the size of all that it carries, were its joints frozen: moment (kg·m²) and mass (kg). Filled where it
    /// is asked for.
    composites: Vec<(f64, f64)>,
    /// The change of 1/m̄ by motions that were frozen, 1/kg.
    frozen: f64,
    /// Of the cluster at hand, over its coordinates: the forces that the tree leaves, and the rates.
    forces: Vec<f64>,
    rates: Vec<f64>,
    /// Of the cluster at hand: the rates of its independent coordinates.
    independent: Vec<f64>,
    /// Of each row of the group at hand: the size of its terms, and its largest entry.
    terms: Vec<f64>,
    largest: Vec<f64>,
    multipliers: MultiplierRoom,
    /// Of the cluster at hand, for each of its bodies: the wrenches on it that close loops.
    closing: Vec<Wrench<f64>>,
}

impl BudgetRoom {
    /// Whether errors were counted before, so that there is room for them.
    pub fn is_filled(&self) -> bool {
        !self.frames.of.is_empty()
    }
}

/// What an error budget is asked about: a route's answer to a unit impulse along the normal.
pub(crate) struct UnitImpulse<'a> {
    pub model: &'a Model,
    pub kinematics: &'a Kinematics<f64>,
    pub groups: &'a [GroupMobility],
    /// For each group, how far its loops are from fitting, as a part of its size.
    pub misfits: &'a [f64],
    pub contact: &'a LocatedContact,
    /// Twists of the bodies, root axes at the contact point.
    pub twists: &'a [Twist<f64>],
    /// Velocities of the tree.
    pub velocities: &'a [f64],
}

/// The parts of the error of 1/m̄, relative to it.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct RelativeErrors {
    pub rounding: f64,
    /// What of it is the route's own: another route has the rest too.
    pub route: f64,
    /// What of that is due to motions that were frozen because their mass is below rounding, though they couple to the contact.
    pub frozen: f64,
    /// What rows of A do that are off by as much as their loops are from fitting.
    pub file: f64,
    /// The greatest misfit of a group that moves.
    pub misfit: f64,
    /// Whether a group that moves has redundant rows, which measure the misfit.
    pub is_measured: bool,
    /// The response (1/kg) by its energy, where the recursion's own is vague; `rounding` is its then.
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
    /// The error of the recursion's answer; `is_clear`: whose own rounding is beyond doubt.
    pub fn of_recursion(
        &self,
        room: &mut BudgetRoom,
        recursion: &Recursion<f64, 1>,
        is_clear: bool,
    ) -> RelativeErrors {
        let (mut route, mut stationary) = (self.of_eliminations(room, recursion), None);
        let response = recursion.response(0, 0);
        // A tree's pivots are sums over what is left below each joint only.
        if !is_clear && !recursion.clusters.is_empty() && f64::EPSILON * route > VAGUE_RESPONSE * response {
            let found = self.stationary(recursion).value().filter(|(value, error)| {
                *value > 0.0 && *error < NOTHING_LEFT * value && *error < f64::EPSILON * route
            });
            if let Some((value, error)) = found {
                route = error / f64::EPSILON;
                stationary = Some(value);
            }
        }
        let places = if stationary.is_some() { Places::ByJoint } else { Places::Added };
        let mut sum = self.of_data(room, recursion, places);
        sum.rounding += route;
        sum.route = route;
        sum.frozen = room.frozen;
        sum.stationary = stationary;
        self.relative(sum, response)
    }

    /// The relative error that the recursion itself makes, of no more than its eliminations: where it is small, that of
    /// [`of_recursion`](Self::of_recursion).
    pub fn of_route(&self, room: &mut BudgetRoom, recursion: &Recursion<f64, 1>) -> f64 {
        f64::EPSILON * self.of_eliminations(room, recursion) / recursion.response(0, 0)
    }

    fn of_eliminations(&self, room: &mut BudgetRoom, recursion: &Recursion<f64, 1>) -> f64 {
        room.composites.clear();
        room.frozen = 0.0;
        let of_cluster = |(number, cluster): (usize, &Cluster)| match recursion.place[number] {
            None => self.of_joint(room, recursion, cluster.bodies[0]),
            Some(place) => self.of_cluster(room, recursion, cluster, &recursion.clusters[place]),
        };
        self.model.clusters.iter().enumerate().map(of_cluster).sum()
    }

    /// The same answer by its energy.
    pub fn stationary<'b>(&'b self, recursion: &'b Recursion<f64, 1>) -> Stationary<'b> {
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

    fn fill_transmitted(&self, transmitted: &mut Vec<Wrench<f64>>, recursion: &Recursion<f64, 1>) {
        let own = |i: usize| recursion.wrenches[i][0] - self.carried(recursion, i).apply(&self.twists[i]);
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

    /// What every route shares: frames, bodies' inertias, joints' columns, the contact, rows of A.
    fn of_data(
        &self,
        room: &mut BudgetRoom,
        recursion: &Recursion<f64, 1>,
        places: Places,
    ) -> RelativeErrors {
        let (model, kinematics) = (self.model, self.kinematics);
        self.fill_transmitted(&mut room.transmitted, recursion);
        room.frames.fill(model, kinematics);
        let mut sum = RelativeErrors::default();
        self.add_rows(room, places, &mut sum);
        let BudgetRoom { frames, transmitted, .. } = &*room;
        let on = frames.at(model.body_of(self.contact.link));
        let against = frames.at(self.contact.against.and_then(|l| model.body_of(l)));
        let point = &self.contact.point_root;
        let reach = point.norm();
        let own_struck = 2.0 * reach + (on.0 + SUM_ROUNDINGS) * self.contact.point_link.norm();
        let struck = (on.0.max(against.0), on.1 + own_struck);
        // The normal turns with a link; the relative velocity there is what it is multiplied with.
        let relative = self.relative_velocity().norm();
        sum.rounding += 2.0 * (TURN_ROUNDINGS + struck.0) * relative;
        if let Some((end, at)) = self.contact.line {
            // A line turns by what its ends are off, over its length.
            let far = frames.at(model.body_of(end));
            let position = kinematics.link_frame(model, end).point(&at);
            let off = far.1 + 2.0 * position.norm() + (far.0 + SUM_ROUNDINGS) * at.norm();
            let length = (position - point).norm();
            sum.rounding += 2.0 * (struck.1 + off) / length * relative;
            sum.file += 2.0 * self.misfit_of([self.contact.link, end]) / length * relative;
        }
        let by_joint = places == Places::ByJoint;
        if let Some(other) = self.contact.against.and_then(|l| model.body_of(l)).filter(|_| by_joint) {
            // The point is the struck link's: it is off on the other one.
            sum.rounding += 2.0 * self.off_between(frames) * self.twists[other].angular.norm();
        }
        for (i, body) in model.bodies.iter().enumerate() {
            let (turn, place) = frames.of[i];
            let arm = kinematics.frames[i].translation - point;
            let off = if by_joint {
                own_struck + 2.0 * kinematics.frames[i].translation.norm() + arm.norm()
            } else {
                place + struck.1 + arm.norm()
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
                sum.rounding += self.of_place(i, turn, off, &transmitted[i]);
                continue;
            }
            // A free base is seen from itself.
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

    /// How far the contact point is off on the other side: what the joints between the two sides turn and shift wrongly.
    fn off_between(&self, frames: &FrameErrors) -> f64 {
        let (model, kinematics, point) = (self.model, self.kinematics, &self.contact.point_root);
        let (mut alike, mut squares) = (0.0, 0.0);
        let on = model.body_of(self.contact.link);
        let against = self.contact.against.and_then(|link| model.body_of(link));
        model.for_each_support(on, against, |i, _| {
            let place = &kinematics.frames[i].translation;
            let arm = (place - point).norm();
            // Products of rotations are stretched as far as they are turned.
            let own = (SUM_ROUNDINGS + frames.walks[i].0.sqrt()) * kinematics.steps[i].translation.norm()
                + 2.0 * place.norm();
            alike += REPEATED_ROUNDINGS * arm;
            squares += (TURN_ROUNDINGS * arm).powi(2) + own * own;
        });
        2.0 * point.norm() + SUM_ROUNDINGS * self.contact.point_link.norm() + alike + squares.sqrt()
    }

    /// What a joint turns and shifts wrongly it carries along as it is: only what it transmits knows of it.
    fn of_place(&self, i: usize, turn: f64, off: f64, transmitted: &Wrench<f64>) -> f64 {
        let (model, kinematics, point) = (self.model, self.kinematics, &self.contact.point_root);
        let body = &model.bodies[i];
        // A free base is seen from itself.
        if body.joint.is_none() {
            return 0.0;
        }
        let arm = kinematics.frames[i].translation - point;
        let force = transmitted.force.norm();
        let moment = (transmitted.moment - arm.cross(&transmitted.force)).norm();
        let (own, carrier) = (&self.twists[i], body.parent.map_or_else(Twist::zero, |p| self.twists[p]));
        let turning = own.angular.norm() + carrier.angular.norm();
        let moving = own.velocity_at(&arm).norm() + carrier.velocity_at(&arm).norm();
        let shift = (SUM_ROUNDINGS + turn) * kinematics.steps[i].translation.norm()
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

    /// Velocity of the struck link at the contact point against the other side.
    fn relative_velocity(&self) -> Vector3<f64> {
        let twist = |body: Option<usize>| body.map_or_else(Vector3::zeros, |b| self.twists[b].linear);
        twist(self.model.body_of(self.contact.link))
            - twist(self.contact.against.and_then(|l| self.model.body_of(l)))
    }

    /// How far loops that carry any of these links are from fitting, m.
    fn misfit_of(&self, links: [LinkId; 2]) -> f64 {
        let mut carriers = vec![false; self.model.bodies.len()];
        for body in links.into_iter().filter_map(|link| self.model.body_of(link)) {
            std::iter::successors(Some(body), |&b| self.model.bodies[b].parent)
                .for_each(|b| carriers[b] = true);
        }
        let groups = self.model.groups.iter().zip(self.misfits);
        let carrying = groups.filter(|(group, _)| group.bodies.iter().any(|&b| carriers[b]));
        carrying.map(|(group, misfit)| misfit * group.size).fold(0.0, f64::max)
    }

    /// Iᴬ as it arrives at a body, before its own joint is eliminated.
    fn carried(&self, recursion: &Recursion<f64, 1>, i: usize) -> ArticulatedInertia<f64> {
        let mut inertia = recursion.inertias[i];
        if recursion.place[self.model.cluster_of[i]].is_none() {
            for e in self.model.bodies[i].v.clone().map(|v| &recursion.joints[v]).filter(|e| e.counts) {
                inertia.subtract_dyad(&(e.u * (-1.0 / e.d)), &e.u);
            }
        }
        inertia
    }

    /// The elimination of a plain joint. What is left after some of its velocities moves as the body would if these stood
    /// still, which can be much faster than the body and what carries it.
    fn of_joint(&self, room: &mut BudgetRoom, recursion: &Recursion<f64, 1>, i: usize) -> f64 {
        let body = &self.model.bodies[i];
        let mut squares = diagonal(&recursion.inertias[i]);
        let mut twist = body.parent.map_or_else(Twist::zero, |p| self.twists[p]);
        let mut sum = 0.0;
        // From what is left at last back to what there was at first: what each pivot took is added again.
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
            let frozen = self.of_frozen(room, recursion, i, &roots);
            room.frozen += frozen;
            sum += frozen / f64::EPSILON;
        }
        sum + 2.0 * SUM_ROUNDINGS * dot_abs(&recursion.wrenches[i][0], &components(&self.twists[i]))
    }

    /// The elimination of a bound cluster.
    fn of_cluster(
        &self,
        room: &mut BudgetRoom,
        recursion: &Recursion<f64, 1>,
        cluster: &Cluster,
        eliminated: &ClusterElimination<f64, 1>,
    ) -> f64 {
        let d = eliminated.d;
        let carrier = cluster.parent.map_or_else(Twist::zero, |p| self.twists[p]);
        let u = &mut room.independent;
        eliminated.fill_independent_rates(&carrier, true, None, u);
        let carried = components(&carrier);
        let mut sum = 0.0;
        for (at, &b) in cluster.bodies.iter().enumerate() {
            // Roundings of many terms add as a random walk.
            let mut squares = carried.component_mul(&carried);
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
                * (eliminated.t[y][0] * part + 2.0 * dot_abs(&eliminated.u[y], &carried) * part.abs());
        }
        sum
    }

    /// The error of the careful route's answer: a backward error of n ε in M scaled to unit diagonal. `mass`: M's diagonal
    /// entries and the sizes of their terms.
    pub fn of_least_energy(
        &self,
        room: &mut BudgetRoom,
        recursion: &Recursion<f64, 1>,
        mass_size: &[f64],
        coordinates: &[f64],
        response: f64,
    ) -> RelativeErrors {
        let mut sum = self.of_data(room, recursion, Places::Added);
        let root: f64 = mass_size.iter().zip(coordinates).map(|(m, v)| m.abs().sqrt() * v.abs()).sum();
        sum.route = SUM_ROUNDINGS * coordinates.len() as f64 * root * root;
        sum.rounding += sum.route;
        self.relative(sum, response)
    }
}

/// Square roots of the diagonal of an inertia: entries of a positive one are at most products of two of them.
fn roots(inertia: &ArticulatedInertia<f64>) -> Vector6<f64> {
    diagonal(inertia).map(|x| x.abs().sqrt())
}

fn diagonal(inertia: &ArticulatedInertia<f64>) -> Vector6<f64> {
    let (a, l) = (&inertia.angular, &inertia.linear);
    Vector6::new(a.m11, a.m22, a.m33, l.m11, l.m22, l.m33)
}

fn components(twist: &Twist<f64>) -> Vector6<f64> {
    let (w, v) = (&twist.angular, &twist.linear);
    Vector6::new(w.x, w.y, w.z, v.x, v.y, v.z).map(f64::abs)
}

fn energy_root(roots: &Vector6<f64>, components: &Vector6<f64>) -> f64 {
    roots.dot(components)
}

fn dot_abs(wrench: &Wrench<f64>, components: &Vector6<f64>) -> f64 {
    let (m, f) = (&wrench.moment, &wrench.force);
    Vector6::new(m.x, m.y, m.z, f.x, f.y, f.z).map(f64::abs).dot(components)
}
