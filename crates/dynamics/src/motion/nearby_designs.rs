//! Effective masses of designs near that of a pose, to first order, without an assembly.
//!
//! With the response v* at the pose q of a design, and its multipliers λ (M v* + Aᵀλ = m̄ jᵀ), a nearby design has
//!
//! ```text
//! m̄' ≈ v*ᵀ M' v* + 2 λᵀ A' v* + 2 m̄ (1 − j' v*),    M', A', j' at the pose q' of the nearby design
//! ```
//!
//! up to terms of second order, since m̄ is the least value of vᵀMv under Av = 0, jv = 1. q' follows from q by a Newton step on the closed
//! loops and the conditions of the pose, with the derivatives at q; drivers that these conditions do not move keep their positions.
//!
//! Cost for a design: frames, rows and energies of all bodies once, O(n), and two triangular solutions. Source: derivative of a constrained
//! minimum (envelope theorem): Nocedal and Wright 2006, §12.3; the terms are those of [`MassGradient`](crate::MassGradient).

use crate::analysis::pose::Pose;
use crate::analysis::response::ContactResponse;
use crate::analysis::system::System;
use crate::kinematics::contact::{Contact, LocatedContact};
use crate::kinematics::frames::Kinematics;
use crate::kinematics::gap::Gap;
use crate::kinematics::outcome::EffectiveMass;
use crate::kinematics::remarks::RemarkFlags;
use crate::kinematics::rows::GroupRows;
use crate::linear::determined_system::DeterminedSystem;
use crate::model::{LinkFrame, Model};
use crate::motion::gap::speed_along;
use crate::motion::mass_gradient::{BodyResponse, about};
use crate::motion::points::lowest_point::LowestPoint;
use crate::tolerances::{CLOSED_PART, CLOSED_ROUNDING, HELD_POSITION, SAME_DIRECTION};
use nalgebra::{DMatrix, DVector, Vector3};
use percuss_mechanism::LinkId;
use percuss_spatial::{Transform, Twist};
use std::borrow::Cow;

/// Condition of a pose besides closed loops and held drivers.
#[derive(Clone, Debug, PartialEq)]
pub enum PoseCondition {
    /// The named contact touches: its gap is 0.
    Touch(String),
    /// Displacement of a point since the start, n · (p − p₀) = s.
    Displacement {
        /// The link.
        link: LinkId,
        /// Point p, m, frame of the link.
        point: Vector3<f64>,
        /// Direction n, world axes, any length.
        direction: Vector3<f64>,
        /// Displacement s, m.
        distance: f64,
    },
}

/// A pose with its response, from which effective masses of nearby designs follow. Immutable and `Send + Sync`.
#[derive(Debug)]
pub struct NearbyDesigns {
    /// Pose from which displacements count; `None` without displacements.
    start: Option<LinearPose>,
    posed: LinearPose,
    /// Conditions that drive the pose.
    conditions: Vec<PoseCondition>,
    mass: f64,
    /// Contact point, m, frame of the root link.
    point: Vector3<f64>,
    /// Tree velocities v*.
    velocities: Vec<f64>,
    /// Velocities v* of the coordinates.
    rates: Vec<f64>,
    /// Multipliers λ of the rows of each group.
    multipliers: Vec<Vec<f64>>,
}

/// A pose with the derivatives of its residuals.
#[derive(Debug)]
struct LinearPose {
    pose: Pose,
    /// Coordinates that follow from the residuals.
    unknown: Vec<usize>,
    /// Derivatives of the residuals by these coordinates; `None` without unknown coordinates.
    system: Option<DeterminedSystem>,
    /// Residuals at the pose: rounding of the file and of the closing, m.
    residuals: DVector<f64>,
}

impl NearbyDesigns {
    /// Neighbourhood of a pose. `start`: pose from which the conditions have moved the mechanism, which is the pose itself without
    /// conditions; `response`: response of the contact at the pose, without a body on the other side.
    ///
    /// `None` unless m̄ is finite with an error of at most 1e-6 m̄; with held contacts; and if the pose is singular or the joints that the
    /// conditions drive are ambiguous.
    pub fn new(
        start: &Pose,
        pose: &Pose,
        response: &ContactResponse,
        contact: &Contact,
        conditions: &[PoseCondition],
    ) -> Option<Self> {
        let EffectiveMass::Finite(mass) = response.effective_mass else { return None };
        let is_accurate =
            RemarkFlags::of_error(response.effective_mass, response.effective_mass_error()).is_empty();
        if !is_accurate || !pose.assembly.has_single_model() || response.singular_pose {
            return None;
        }
        let (conditions, held) = driven(start, pose, conditions)?;
        let has_displacement = conditions.iter().any(|c| matches!(c, PoseCondition::Displacement { .. }));
        let at_start = match has_displacement {
            true => Some(LinearPose::new(start, &[], &independent(start)?, None)?),
            false => None,
        };
        let origins = at_start.as_ref().map(|start| &start.pose.kinematics);
        let posed = LinearPose::new(pose, &conditions, &held, origins)?;
        let (bodies, multipliers) = BodyResponse::with_multipliers(pose, response, mass, contact);
        let (velocities, model) = (bodies.velocities, pose.assembly.model());
        let mut rates = vec![0.0; model.coordinates.len()];
        for (velocity, follows) in velocities.iter().zip(&model.velocity_coordinates) {
            if let Some(follows) = follows.filter(|follows| follows.multiplier != 0.0) {
                rates[follows.index] = velocity / follows.multiplier;
            }
        }
        let point = response.contact.point_root;
        Some(Self { start: at_start, posed, conditions, mass, point, velocities, rates, multipliers })
    }

    /// m̄ at the pose, kg.
    pub fn effective_mass(&self) -> f64 {
        self.mass
    }

    /// m̄ of a nearby design of the same structure at its contact, kg, exact to first order; `wheel`: wheel whose lowest point is the
    /// contact point. `None` if the structures or the directions of corresponding frames differ, or the loops do not close.
    pub fn effective_mass_of(
        &self,
        design: &System,
        contact: &Contact,
        wheel: Option<&LowestPoint>,
    ) -> Option<f64> {
        let own = self.posed.pose.assembly.model();
        let model = corresponding(own, design.model())?;
        let start = match &self.start {
            Some(start) => Some(start.of_design(&model, &[], None)?),
            None => None,
        };
        let kinematics = self.posed.of_design(&model, &self.conditions, start.as_ref())?;
        let base = &self.posed.pose.base;
        let world = |link: LinkId| *base * kinematics.link_frame(&model, link);
        let lowest = wheel.and_then(|wheel| wheel.at_frames(&model.mechanism, world));
        let contact = Contact { point: lowest.unwrap_or(contact.point), ..*contact };
        let located = model.locate(&kinematics, base, &contact).ok()?;
        Some(self.energy(&model, &kinematics, &located)).filter(|mass| mass.is_finite())
    }

    /// v*ᵀ M v* + 2 λᵀ A v* + 2 m̄ (1 − j v*) at given frames.
    fn energy(&self, model: &Model, kinematics: &Kinematics, located: &LocatedContact) -> f64 {
        let mut twists: Vec<Twist<f64>> = Vec::with_capacity(model.bodies.len());
        let mut energy = 0.0;
        for (i, body) in model.bodies.iter().enumerate() {
            let mut twist = body.parent.map_or_else(Twist::zero, |p| twists[p]);
            for (k, v) in body.v.clone().enumerate() {
                let velocity = self.velocities[v];
                twist += kinematics.column_at(model, i, k, &self.point) * velocity;
                energy += body.armature[k] * velocity * velocity;
            }
            let inertia = about(&kinematics.frames[i], &self.point).inertia(&body.inertia);
            energy += inertia.momentum(&twist).power(&twist);
            twists.push(twist);
        }
        let mut rows = GroupRows::default();
        for (group, multipliers) in model.groups.iter().zip(&self.multipliers) {
            rows.fill(model, group, kinematics);
            rows.for_each(group, |row, column, value| {
                energy += 2.0 * multipliers[row] * value * self.rates[group.coordinates[column]];
            });
        }
        let row = model.contact_row(kinematics, located);
        let closing: f64 =
            row.entries.iter().map(|entry| entry.value * self.velocities[entry.velocity]).sum();
        energy + 2.0 * self.mass * (1.0 - closing)
    }
}

impl LinearPose {
    /// Derivatives at a pose. `held`: coordinates that keep their positions; `origins`: frames from which displacements count.
    fn new(
        pose: &Pose,
        conditions: &[PoseCondition],
        held: &[usize],
        origins: Option<&Kinematics>,
    ) -> Option<Self> {
        let model = pose.assembly.pose_model();
        let moves = |c: &usize| model.coordinates[*c].joint.is_some() && !held.contains(c);
        let unknown: Vec<usize> = (0..model.coordinates.len()).filter(moves).collect();
        let count = model.groups.iter().map(|group| group.rows).sum::<usize>() + conditions.len();
        let mut matrix = DMatrix::zeros(count, unknown.len());
        let (mut first, mut rows) = (0, GroupRows::default());
        for group in &model.groups {
            rows.fill(model, group, &pose.kinematics);
            rows.for_each(group, |row, column, value| {
                if let Ok(at) = unknown.binary_search(&group.coordinates[column]) {
                    matrix[(first + row, at)] += value;
                }
            });
            first += group.rows;
        }
        let mut u = vec![0.0; model.coordinates.len()];
        for (row, condition) in (first..).zip(conditions) {
            for (at, c) in unknown.iter().enumerate() {
                u[*c] = 1.0;
                matrix[(row, at)] = condition.rate(pose, &u)?;
                u[*c] = 0.0;
            }
        }
        let residuals = residuals(model, &pose.base, &pose.kinematics, conditions, origins)?;
        let system = match unknown.len() {
            0 => None,
            columns if columns > count => return None,
            _ => Some(DeterminedSystem::new(matrix)?),
        };
        Some(Self { pose: pose.clone(), unknown, system, residuals })
    }

    /// Frames of a nearby design at its pose; `None` if its loops do not close.
    fn of_design(
        &self,
        model: &Model,
        conditions: &[PoseCondition],
        origins: Option<&Kinematics>,
    ) -> Option<Kinematics> {
        let mut kinematics = Kinematics::new(model);
        kinematics.q.copy_from_slice(&self.pose.kinematics.q);
        kinematics.refill(model);
        let open = |kinematics: &Kinematics| -> Option<DVector<f64>> {
            Some(residuals(model, &self.pose.base, kinematics, conditions, origins)? - &self.residuals)
        };
        let before = open(&kinematics)?;
        if let Some(system) = &self.system {
            let step = system.nearest(&before)?;
            let mut u = vec![0.0; model.coordinates.len()];
            self.unknown.iter().zip(step.iter()).for_each(|(c, step)| u[*c] = -step);
            model.advance(&mut kinematics, &u);
        }
        let rounding = CLOSED_ROUNDING * model.mechanism.characteristic_length();
        let is_closed = open(&kinematics)?.amax() <= CLOSED_PART * before.amax() + rounding;
        is_closed.then_some(kinematics)
    }
}

impl PoseCondition {
    /// Change of the residual per unit time at rates of the coordinates, m/s.
    fn rate(&self, pose: &Pose, u: &[f64]) -> Option<f64> {
        let model = pose.assembly.pose_model();
        Some(match self {
            Self::Touch(name) => {
                let contact = model.mechanism.find_contact(name).ok()?;
                -Gap::named(model, contact)?.closing_speed(pose, u)
            }
            Self::Displacement { link, point, direction, .. } => {
                let along = pose.base.inverse_vector(&direction.normalize());
                speed_along(model, pose, (*link, point), &along, u)
            }
        })
    }

    /// Residual at given frames, m.
    fn residual(
        &self,
        model: &Model,
        base: &Transform<f64>,
        kinematics: &Kinematics,
        origins: Option<&Kinematics>,
    ) -> Option<f64> {
        Some(match self {
            Self::Touch(name) => {
                let contact = model.mechanism.find_contact(name).ok()?;
                Gap::named(model, contact)?.at_frames(model, kinematics)
            }
            Self::Displacement { link, point, direction, distance } => {
                let at = |frames: &Kinematics| frames.link_frame(model, *link).point(point);
                let along = base.inverse_vector(&direction.normalize());
                along.dot(&(at(kinematics) - at(origins?))) - distance
            }
        })
    }

    /// True if the condition holds at the start.
    fn is_at_start(&self) -> bool {
        matches!(self, Self::Displacement { distance, .. } if *distance == 0.0)
    }
}

/// Residuals of all groups and conditions, m.
fn residuals(
    model: &Model,
    base: &Transform<f64>,
    kinematics: &Kinematics,
    conditions: &[PoseCondition],
    origins: Option<&Kinematics>,
) -> Option<DVector<f64>> {
    let mut all = Vec::new();
    let mut of_group = Vec::new();
    for group in &model.groups {
        model.group_residuals_into(kinematics, group, &mut of_group);
        all.extend_from_slice(&of_group);
    }
    for condition in conditions {
        all.push(condition.residual(model, base, kinematics, origins)?);
    }
    let all = DVector::from_vec(all);
    all.iter().all(|residual| residual.is_finite()).then_some(all)
}

/// Coordinates of the drivers of a pose and of free joints, ascending; `None` without the state of its loops.
fn independent(pose: &Pose) -> Option<Vec<usize>> {
    let model = pose.assembly.pose_model();
    let in_loops = |c: &usize| model.groups.iter().any(|group| group.column(*c).is_some());
    let is_free = |c: &usize| model.coordinates[*c].joint.is_some() && !in_loops(c);
    let mut all: Vec<usize> = (0..model.coordinates.len()).filter(is_free).collect();
    if !model.groups.is_empty() {
        let dependent = &pose.loops.as_ref()?.dependent;
        for (group, dependent) in model.groups.iter().zip(dependent) {
            let own = group.movable.iter().filter(|at| !dependent.contains(at));
            all.extend(own.map(|at| group.coordinates[*at]));
        }
    }
    all.sort_unstable();
    Some(all)
}

/// Conditions that drive a pose, and the coordinates that keep the position of the start; `None` if more or fewer drivers have moved than
/// there are conditions. A condition that holds at the start holds at that of nearby designs too, and drives nothing.
fn driven(
    start: &Pose,
    pose: &Pose,
    conditions: &[PoseCondition],
) -> Option<(Vec<PoseCondition>, Vec<usize>)> {
    let model = pose.assembly.pose_model();
    let is_held = |c: &usize| {
        let range = model.coordinates[*c].joint.map(|joint| model.joint_q[joint.index()].clone());
        range.is_some_and(|range| {
            let pairs = start.kinematics.q[range.clone()].iter().zip(&pose.kinematics.q[range]);
            pairs.into_iter().all(|(from, to)| (from - to).abs() <= HELD_POSITION)
        })
    };
    let all = independent(pose)?;
    let held: Vec<usize> = all.iter().copied().filter(is_held).collect();
    let moved = all.len() - held.len();
    let mut conditions = conditions.to_vec();
    if moved < conditions.len() {
        conditions.retain(|condition| !condition.is_at_start());
    }
    (moved == conditions.len()).then_some((conditions, held))
}

/// The model of a nearby design, with the normals of its closures in the directions of those of `own`, which its multipliers refer to;
/// `None` if structures differ, or directions that correspond.
fn corresponding<'m>(own: &Model, other: &'m Model) -> Option<Cow<'m, Model>> {
    let is_same_structure = own.positions == other.positions
        && own.base == other.base
        && own.coordinates == other.coordinates
        && own.velocity_coordinates == other.velocity_coordinates
        && own.bodies.len() == other.bodies.len()
        && own.closures.len() == other.closures.len()
        && own.couplings.len() == other.couplings.len()
        && own.link_frames.len() == other.link_frames.len()
        && own.groups.len() == other.groups.len();
    if !is_same_structure {
        return None;
    }
    let near = |a: &Vector3<f64>, b: &Vector3<f64>| (a - b).amax() <= SAME_DIRECTION;
    let turned = |a: &Transform<f64>, b: &Transform<f64>| (a.rotation - b.rotation).amax() <= SAME_DIRECTION;
    let frames = |a: &LinkFrame, b: &LinkFrame| a.body == b.body && turned(&a.frame, &b.frame);
    let bodies = own.bodies.iter().zip(&other.bodies).all(|(a, b)| {
        a.parent == b.parent
            && a.joint == b.joint
            && a.v == b.v
            && turned(&a.origin, &b.origin)
            && a.motion.is_near(&b.motion, SAME_DIRECTION)
    });
    let closures = own.closures.iter().zip(&other.closures).all(|(a, b)| {
        a.kind == b.kind
            && frames(&a.predecessor, &b.predecessor)
            && frames(&a.successor, &b.successor)
            && near(&a.axis, &b.axis)
            && near(&a.successor_axis, &b.successor_axis)
            && near(&a.axis2, &b.axis2)
    });
    let links = own.link_frames.iter().zip(&other.link_frames).all(|(a, b)| frames(a, b));
    let groups = own.groups.iter().zip(&other.groups).all(|(a, b)| {
        let constraints = a.constraints.iter().zip(&b.constraints);
        a.rows == b.rows
            && a.coordinates == b.coordinates
            && a.constraints.len() == b.constraints.len()
            && constraints.into_iter().all(|(a, b)| a.constraint == b.constraint && a.first == b.first)
    });
    if !(bodies && closures && links && groups) {
        return None;
    }
    let normals = own.closures.iter().zip(&other.closures);
    if normals.into_iter().all(|(a, b)| a.normals.iter().zip(&b.normals).all(|(a, b)| near(a, b))) {
        return Some(Cow::Borrowed(other));
    }
    let mut model = other.clone();
    for (closure, known) in model.closures.iter_mut().zip(&own.closures) {
        let axis = closure.axis;
        closure.normals = known.normals.map(|normal| (normal - axis * axis.dot(&normal)).normalize());
    }
    Some(Cow::Owned(model))
}
