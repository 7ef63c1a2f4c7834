//! Errors of the rows of A, and the constraint wrenches that close the loops.

use super::{BudgetWorkspace, FrameErrorMode, FrameErrors, RelativeErrors, UnitImpulse};
use crate::kinematics::rows::{MOST, closure_wrenches};
use crate::model::{Cluster, Constraint, ConstraintRows, Group};
use crate::tolerances::ROW_ROUNDINGS;
use nalgebra::Vector3;
use percuss_spatial::{Twist, Wrench};

/// Bodies on the two sides of a constraint.
struct Sides {
    on: Option<usize>,
    against: Option<usize>,
}

impl UnitImpulse<'_> {
    /// Adds the effect of errors in the rows of A on the rates of the dependent coordinates. With `Places::ByJoint`,
    /// the constraint wrenches are also added to the transmitted wrenches.
    pub(super) fn add_row_errors(
        &self,
        workspace: &mut BudgetWorkspace,
        places: FrameErrorMode,
        sum: &mut RelativeErrors,
    ) {
        for cluster in self.model.clusters.iter().filter(|c| !c.groups.is_empty()) {
            self.fill_tree_forces(&mut workspace.forces, cluster, &workspace.transmitted);
            let BudgetWorkspace { frames, forces, rates, terms, largest, multipliers, closing, .. } =
                workspace;
            rates.clear();
            rates.resize(cluster.coordinates.len(), 0.0);
            for v in cluster.velocities.iter().filter(|v| v.multiplier != 0.0) {
                rates[v.coordinate] = self.velocities[v.index] / v.multiplier;
            }
            closing.clear();
            closing.resize(cluster.bodies.len(), Wrench::zero());
            for own in &cluster.groups {
                let (group, known) = (&self.model.groups[own.group], &self.groups[own.group]);
                let scaled = |c: usize| rates[own.coordinates[c]].abs() * group.lengths[c];
                if (0..group.coordinates.len()).all(|c| scaled(c) == 0.0) {
                    continue;
                }
                sum.misfit = sum.misfit.max(self.misfits[own.group]);
                sum.is_measured |= group.rows > known.pivots.rows.len();
                // δ(1/m̄) = 2 λᵀδA u: the multipliers balance the forces of the tree on the dependent coordinates.
                let force = |c: usize| forces[own.coordinates[c]] / group.lengths[c];
                multipliers.solve(group, known, &force);
                terms.clear();
                terms.resize(group.rows, 0.0);
                largest.clear();
                largest.resize(group.rows, 0.0);
                known.rows.for_each(group, |r, c, a| {
                    terms[r] += (a / group.lengths[c]).abs() * scaled(c);
                    largest[r] = largest[r].max((a / group.lengths[c]).abs());
                });
                let speed = (0..group.coordinates.len()).map(scaled).fold(0.0, f64::max);
                for constraint in &group.constraints {
                    let balance = |r: usize| multipliers.row_multiplier(r);
                    let held = constraint.first..constraint.first + constraint.count;
                    if held.clone().all(|r| balance(r).is_none()) {
                        continue;
                    }
                    let sides = self.sides(constraint);
                    let row = self.row_error(frames, constraint, &sides, group.size, places);
                    for r in held.clone() {
                        let Some(multiplier) = balance(r) else { continue };
                        // An entry that vanishes is a sum of terms as large as the largest entry of the row.
                        let change = multiplier.abs() * terms[r].max(largest[r] * speed);
                        sum.file += 2.0 * self.misfits[own.group] * change;
                        sum.rounding += 2.0 * row * change;
                    }
                    if places == FrameErrorMode::Accumulated {
                        continue;
                    }
                    let (arm, wrenches) = self.wrenches(constraint, group);
                    let mut push = Wrench::zero();
                    for (r, wrench) in held.zip(&wrenches) {
                        let Some(multiplier) = balance(r) else { continue };
                        let off = self.frame_error_power(frames, &sides, &arm, wrench);
                        sum.rounding += 2.0 * multiplier.abs() * off;
                        push += *wrench * -multiplier;
                    }
                    let push = Wrench::new(push.moment + arm.cross(&push.force), push.force);
                    for (body, sign) in [(sides.on, 1.0), (sides.against, -1.0)] {
                        let at = body.and_then(|b| cluster.bodies.binary_search(&b).ok());
                        if let Some(at) = at {
                            closing[at] += push * sign;
                        }
                    }
                }
            }
            for at in (0..cluster.bodies.len()).rev().filter(|_| places == FrameErrorMode::ByJoint) {
                let own = closing[at];
                if let Some(parent) = cluster.parents[at] {
                    closing[parent] += own;
                }
                workspace.transmitted[cluster.bodies[at]] += own;
            }
        }
    }

    /// Bodies on the two sides of a constraint; none for a coupling.
    fn sides(&self, constraint: &ConstraintRows) -> Sides {
        match constraint.constraint {
            Constraint::Closure(i) => {
                let closure = &self.model.closures[i];
                Sides { on: closure.successor.body, against: closure.predecessor.body }
            }
            Constraint::Coupling(_) => Sides { on: None, against: None },
            Constraint::Hold(i) => Sides { on: self.model.body_of(self.model.holds[i].link), against: None },
        }
    }

    /// Error of the entries of a constraint's rows, in roundings.
    fn row_error(
        &self,
        frames: &FrameErrors,
        constraint: &ConstraintRows,
        sides: &Sides,
        size: f64,
        places: FrameErrorMode,
    ) -> f64 {
        let curve = match constraint.constraint {
            Constraint::Coupling(i) => self.model.couplings[i].slope_roundings(&self.kinematics.q),
            Constraint::Closure(_) | Constraint::Hold(_) => 0.0,
        };
        let moving = constraint.terms.iter().map(|term| term.body);
        let bodies = moving.chain(sides.on).chain(sides.against);
        match places {
            FrameErrorMode::Accumulated => {
                let (turn, place) = bodies.fold((0.0_f64, 0.0_f64), |(turn, place), b| {
                    (turn.max(frames.bounds[b].0), place.max(frames.bounds[b].1))
                });
                ROW_ROUNDINGS + curve + turn + place / size
            }
            // An arm is a difference of two positions.
            FrameErrorMode::ByJoint => {
                let far = bodies.map(|b| self.kinematics.frames[b].translation.norm()).fold(0.0, f64::max);
                ROW_ROUNDINGS + curve + 4.0 * far / size
            }
        }
    }

    /// Position of a constraint relative to the contact point, and one wrench per row. The power of the wrench on the
    /// first side equals the row. Root axes, about that position.
    fn wrenches(&self, constraint: &ConstraintRows, group: &Group) -> (Vector3<f64>, [Wrench<f64>; MOST]) {
        let (model, kinematics) = (self.model, self.kinematics);
        let mut wrenches = [Wrench::zero(); MOST];
        let mut place = Vector3::zeros();
        match constraint.constraint {
            Constraint::Closure(i) => {
                let closure = &model.closures[i];
                let x_rp = kinematics.frame_of(&closure.predecessor);
                let x_rs = kinematics.frame_of(&closure.successor);
                place = x_rs.translation;
                wrenches = closure_wrenches(closure, &x_rp, &x_rs, group.size);
            }
            Constraint::Coupling(_) => {}
            Constraint::Hold(i) => {
                let hold = &model.holds[i];
                place = kinematics.link_frame(model, hold.link).point(&hold.point);
                for (wrench, d) in wrenches.iter_mut().zip(hold.directions()) {
                    *wrench = Wrench::new(Vector3::zeros(), d);
                }
            }
        }
        (place - self.contact.point_root, wrenches)
    }

    /// Power of a row's wrench on the free relative motion, after a rotation and displacement by the frame errors of
    /// both sides.
    fn frame_error_power(
        &self,
        frames: &FrameErrors,
        sides: &Sides,
        arm: &Vector3<f64>,
        wrench: &Wrench<f64>,
    ) -> f64 {
        let twist = |body: Option<usize>| body.map_or_else(Twist::zero, |b| self.twists[b]);
        let relative = twist(sides.on) + twist(sides.against) * -1.0;
        let (turning, sliding) = (relative.angular.norm(), relative.velocity_at(arm).norm());
        let (moment, force) = (wrench.moment.norm(), wrench.force.norm());
        let (on, against) = (frames.at(sides.on), frames.at(sides.against));
        (on.0 + against.0) * (moment * turning + force * sliding) + (on.1 + against.1) * force * turning
    }

    /// Forces of the tree on the coordinates of a cluster: τ = Σ Sᵀh, where h excludes constraint wrenches.
    fn fill_tree_forces(&self, forces: &mut Vec<f64>, cluster: &Cluster, transmitted: &[Wrench<f64>]) {
        forces.clear();
        forces.resize(cluster.coordinates.len(), 0.0);
        for v in &cluster.velocities {
            let body = cluster.bodies[v.body];
            let s = self.kinematics.column_at(self.model, body, v.component, &self.contact.point_root);
            let inertial = v.armature * self.velocities[v.index];
            forces[v.coordinate] += v.multiplier * (transmitted[body].power(&s) - inertial);
        }
    }
}
