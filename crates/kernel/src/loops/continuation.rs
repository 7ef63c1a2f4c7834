//! Continuation of a linkage along a path of its driving joints: Newton's method closes the loops of each sweep row
//! from the last closed pose, one row per lane.
//!
//! ```text
//! q₀ = q + G Δx + ½ G′ Δx²,   A[d] δ = −r(q),  q ← q + δ  until r is rounding
//! 1/m̄ from the A already eliminated
//! ```
//!
//! Source: Allgower and Georg, Introduction to Numerical Continuation Methods, 2003, ch. 2. A row has a result if its
//! pose lies in a neighbourhood of a pose of the branch without any other branch (Newton and Kantorovich): ‖A\[d\]⁻¹‖
//! · ‖A′‖ · distance is below a third. In this neighbourhood the dependent coordinates are a smooth function of the
//! driving ones, without a limit.

use super::LoopKernel;
use super::energy::{LoopContact, response_after_elimination};
use super::frames::fill_frames;
use super::layout::{get, store};
use super::plan::{LoopMotion, LoopPlan};
use super::rows::{eliminate, fill_rows, fill_steps, matrix_at};
use crate::aligned::Aligned;
use crate::columns::{CertifiedMass, MassColumns, PositionColumns, WIDEST};
use crate::contact::Contact;
use crate::mechanism::{JointPosition, Linkage};
use crate::tolerances::{
    CLOSED, CLOSED_IN_LANES, CLOSING_PASSES, CURVATURE_STEP, DRIFT_ITERATIONS, FOLLOWERS_DRIFT,
    LONGEST_BRANCH_STEP, LONGEST_FOLLOWED, SMALL_CORRECTION, STRAIGHT,
};
use percuss_spatial::Scalar;
use percuss_spatial::lanes::{Lanes, Single, Work};

/// Positions that change with a dependent coordinate.
#[derive(Clone, Copy, Debug)]
enum DependentPosition {
    /// One position of a hinge or slide; `factor`: its change per metre of the column.
    Single { q: usize, column: usize, factor: f64 },
    /// Quaternion: for each rotation its column, if dependent.
    Spherical { q: usize, turns: [Option<(usize, f64)>; 3] },
}

/// Position given by the sweep rows.
#[derive(Clone, Copy, Debug)]
struct DrivenPosition {
    q: usize,
    /// Independent coordinate, and its change (m) per unit of the position.
    y: usize,
    length: f64,
}

/// Position of a mimic joint.
#[derive(Clone, Copy, Debug)]
struct Mimicked {
    q: usize,
    follows: JointPosition,
}

/// Neighbourhood of a pose of the branch without any other branch. Distances are over all coordinates in metres.
#[derive(Clone, Debug, Default)]
struct Neighbourhood {
    /// ‖A′‖, 1/m: change of A over a motion.
    curvature: f64,
    /// Radius of the neighbourhood, m.
    radius: f64,
    /// Upper bound of the distance of the current pose from the centre, m.
    distance: f64,
    /// Product of 1/pivots at the first pose: its sign is the sign of det A\[d\] and identifies the assembly mode.
    orientation: f64,
    scratch: Vec<f64>,
}

/// Closed pose, with the rates of the dependent coordinates.
#[derive(Clone, Debug, Default)]
struct ClosedPose {
    positions: Vec<f64>,
    /// G: pivots × freedoms.
    rates: Vec<f64>,
}

/// Result of a sweep row on the branch.
#[derive(Clone, Copy, Debug)]
pub struct FollowedRow {
    /// `None` if rounding leaves a doubt.
    pub mass: Option<CertifiedMass>,
    /// Largest residual of a loop, m.
    pub residual: f64,
}

/// Linkage with its contact and its current pose.
#[derive(Clone, Debug)]
pub struct LoopContinuation {
    linkage: LoopKernel,
    dependent_positions: Vec<DependentPosition>,
    driven_positions: Vec<DrivenPosition>,
    mimics: Vec<Mimicked>,
    neighbourhood: Neighbourhood,
    /// Smallest size of a group, m.
    size: f64,
    current: ClosedPose,
    previous: ClosedPose,
    /// Positions, and steps of the dependent coordinates (m), of some lanes by columns.
    positions: Aligned,
    steps: Aligned,
    /// Displacements of the given positions, of some lanes (m).
    displacements: Vec<f64>,
}

impl LoopContinuation {
    /// Starts at a closed pose. `dependent`: true for each coordinate that can be dependent; `given`: indices of the positions that the
    /// rows give. `None` if the linkage is not supported, or the given positions do not drive it.
    pub fn of(
        linkage: &Linkage,
        contact: &Contact,
        positions: &[f64],
        dependent: &[bool],
        given: &[usize],
    ) -> Option<Self> {
        let plan = LoopPlan::compile_driven(linkage, positions, &|column| f64::from(dependent[column]))?;
        let bodies = &linkage.mechanism.bodies;
        let rank = plan.layout.count;
        let (mut following, mut free) = (Vec::new(), Vec::new());
        for (body, own) in plan.bodies.iter().zip(bodies).filter(|(_, own)| own.mimic.is_none()) {
            match body.motion {
                LoopMotion::Fixed | LoopMotion::Base | LoopMotion::Floating(_) | LoopMotion::Planar(_) => {}
                LoopMotion::Turn(position) | LoopMotion::Slide(position) => {
                    let Some(velocity) = body.velocities.first() else { continue };
                    let (q, column, factor) = (position.q, velocity.column, velocity.factor);
                    if column < rank {
                        following.push(DependentPosition::Single { q, column, factor });
                    } else {
                        free.push(DrivenPosition { q, y: column - rank, length: 1.0 / factor });
                    }
                }
                LoopMotion::Ball(q) => {
                    let turn = |k: usize| {
                        let velocity = body.velocities.get(k).filter(|velocity| velocity.column < rank)?;
                        Some((velocity.column, velocity.factor))
                    };
                    debug_assert_eq!(own.q, q);
                    following.push(DependentPosition::Spherical { q, turns: [turn(0), turn(1), turn(2)] });
                }
            }
        }
        let given = given.iter().map(|&q| free.iter().find(|free| free.q == q).copied());
        let given: Vec<DrivenPosition> = given.collect::<Option<_>>()?;
        let mimicked = bodies.iter().filter_map(|body| Some(Mimicked { q: body.q, follows: body.mimic? }));
        let mut kernel = LoopKernel::from_plan(plan);
        if !kernel.set_contact(contact) {
            return None;
        }
        let mut driven = Self {
            size: linkage.smallest_loop_size,
            current: ClosedPose::default(),
            previous: ClosedPose::default(),
            positions: Aligned::zeros(positions.len() * WIDEST),
            steps: Aligned::zeros(rank * WIDEST),
            displacements: vec![0.0; given.len() * WIDEST],
            linkage: kernel,
            dependent_positions: following,
            driven_positions: given,
            mimics: mimicked.collect(),
            neighbourhood: Neighbourhood::default(),
        };
        driven.set_pose(positions).then_some(driven)
    }

    /// Sets a closed pose of the same branch; returns false if the branch is uncertain.
    pub fn set_pose(&mut self, positions: &[f64]) -> bool {
        let plan = &self.linkage.plan;
        self.current =
            ClosedPose { positions: positions.to_vec(), rates: vec![0.0; plan.layout.count * plan.freedoms] };
        self.previous = ClosedPose::default();
        let row: Vec<f64> = self.driven_positions.iter().map(|given| positions[given.q]).collect();
        self.neighbourhood.radius = f64::INFINITY;
        let seen = self.predict_and_close(&row, 1, 1);
        self.neighbourhood.orientation = seen.orientation[0];
        let stands = self.is_on_branch(&seen, 0, 1);
        self.commit_lane(0, 1);
        self.neighbourhood.curvature = self.curvature(positions);
        self.centre(0, 1);
        stands
    }

    /// ‖A′‖ (1/m) at a pose, by differences over every coordinate that moves.
    fn curvature(&self, positions: &[f64]) -> f64 {
        let plan = &self.linkage.plan;
        let step = CURVATURE_STEP * self.size;
        let here = matrix_at(plan, positions);
        let mut moved = positions.to_vec();
        let mut square = 0.0;
        let mut change = |moved: &[f64]| {
            let differences =
                matrix_at(plan, moved).iter().zip(&here).map(|(a, b)| a - b).collect::<Vec<f64>>();
            square += differences.iter().map(|d| d * d).sum::<f64>() / (step * step);
        };
        for one in &self.dependent_positions {
            match one {
                DependentPosition::Single { q, factor, .. } => {
                    moved[*q] += factor * step;
                    change(&moved);
                    moved[*q] = positions[*q];
                }
                DependentPosition::Spherical { q, turns } => {
                    for (k, turn) in turns.iter().enumerate() {
                        let Some((_, factor)) = turn else { continue };
                        let mut half = [Single::from_f64(0.0); 3];
                        half[k] = Single::from_f64(0.5 * factor * step);
                        rotate_quaternion(&mut moved, *q, &half);
                        change(&moved);
                        moved[*q..*q + 4].copy_from_slice(&positions[*q..*q + 4]);
                    }
                }
            }
        }
        for one in &self.driven_positions {
            moved[one.q] += step / one.length;
            change(&moved);
            moved[one.q] = positions[one.q];
        }
        square.sqrt()
    }

    /// Centres the neighbourhood at a lane whose A is eliminated.
    fn centre(&mut self, lane: usize, lanes: usize) {
        let inverse = self.inverse_norm(lane, lanes);
        let own = &mut self.neighbourhood;
        own.distance = 0.0;
        // With a NaN radius every row is refused.
        own.radius = FOLLOWERS_DRIFT / (own.curvature * inverse).max(f64::MIN_POSITIVE);
    }

    /// ‖A\[d\]⁻¹‖ at a lane, by power iterations with the factors of the elimination.
    fn inverse_norm(&mut self, lane: usize, lanes: usize) -> f64 {
        let plan = &self.linkage.plan;
        let rank = plan.layout.count;
        let scratch = &self.linkage.scratch;
        let entry = |entry: usize| scratch[(plan.layout.entries + entry) * lanes + lane];
        let over = |k: usize| scratch[(plan.layout.inverse_pivots + k) * lanes + lane];
        let below = |k: usize| plan.pivots[k].rows.iter().copied().filter(|(r, _)| *r < rank);
        let ahead = |k: usize| plan.pivots[k].columns.iter().copied().filter(|(c, _)| *c < rank);
        let v = &mut self.neighbourhood.scratch;
        v.clear();
        v.extend((0..rank).map(|k| 1.0 + 0.1 * k as f64));
        let mut norm = 0.0;
        for _ in 0..DRIFT_ITERATIONS {
            let length = v.iter().map(|v| v * v).sum::<f64>().sqrt();
            v.iter_mut().for_each(|v| *v /= length);
            // L y = v, U x = y.
            for k in 0..rank {
                let known = v[k] * over(k);
                below(k).for_each(|(r, at)| v[r] -= entry(at) * known);
            }
            for k in (0..rank).rev() {
                let known: f64 = ahead(k).map(|(c, at)| entry(at) * v[c]).sum();
                v[k] = (v[k] - known) * over(k);
            }
            norm = v.iter().map(|v| v * v).sum::<f64>().sqrt();
            // Uᵀ y = x, Lᵀ z = y.
            for k in 0..rank {
                v[k] *= over(k);
                let known = v[k];
                ahead(k).for_each(|(c, at)| v[c] -= entry(at) * known);
            }
            for k in (0..rank).rev() {
                let known: f64 = below(k).map(|(r, at)| entry(at) * v[r]).sum();
                v[k] -= known * over(k);
            }
        }
        norm
    }

    /// Positions at the current pose.
    pub fn positions(&self) -> &[f64] {
        &self.current.positions
    }

    /// Follows the branch over rows of given positions, one after another, until the branch of a row is uncertain.
    /// Calls `each` for every row on the branch with all its positions. Returns the number of these rows; the last of
    /// them becomes the current pose.
    pub fn follow(&mut self, values: &[f64], each: &mut dyn FnMut(FollowedRow, Positions<'_>)) -> usize {
        let width = self.driven_positions.len().max(1);
        let (rows, widest) = (values.len() / width, self.linkage.instructions.width());
        let mut done = 0;
        while done < rows {
            let count = widest.min(rows - done);
            // A single row uses scalar code. Several rows use all lanes; spare lanes repeat the last row.
            let lanes = if count == 1 { 1 } else { widest };
            let seen = self.predict_and_close(&values[done * width..(done + count) * width], count, lanes);
            let mut answered = 0;
            while answered < count
                && let Some(followed) = self.row_result(&seen, answered, lanes)
            {
                each(followed, Positions { values: &self.positions, stride: lanes, lane: answered });
                answered += 1;
            }
            if answered == 0 {
                break;
            }
            self.commit_lane(answered - 1, lanes);
            if self.neighbourhood.distance > 0.5 * self.neighbourhood.radius {
                self.centre(answered - 1, lanes);
            }
            done += answered;
        }
        done
    }

    /// Predicts the positions of some rows and closes their loops.
    fn predict_and_close(&mut self, values: &[f64], count: usize, lanes: usize) -> Outcome {
        let Self {
            linkage,
            dependent_positions: following,
            driven_positions: given,
            mimics,
            current: here,
            previous: before,
            positions,
            steps,
            displacements: moved,
            size,
            ..
        } = self;
        let LoopKernel { plan, contact, scratch, instructions } = linkage;
        let (rank, f) = (plan.layout.count, plan.freedoms);
        for (lanes, value) in positions.chunks_exact_mut(lanes).zip(&here.positions) {
            lanes.fill(*value);
        }
        steps[..rank * lanes].fill(0.0);
        for (number, one) in given.iter().enumerate() {
            for lane in 0..lanes {
                let value = values[lane.min(count - 1) * given.len() + number];
                positions[one.q * lanes + lane] = value;
                let step = (value - here.positions[one.q]) * one.length;
                moved[number * lanes + lane] = step;
                for k in 0..rank {
                    steps[k * lanes + lane] += here.rates[k * f + one.y] * step;
                }
            }
        }
        // Along a single driving joint, the second derivative is the difference of the rates at the last two poses.
        if let ([one], false) = (&given[..], before.rates.is_empty()) {
            let gone = (here.positions[one.q] - before.positions[one.q]) * one.length;
            if gone != 0.0 {
                for k in 0..rank {
                    let bend = (here.rates[k * f + one.y] - before.rates[k * f + one.y]) / (2.0 * gone);
                    for lane in 0..lanes {
                        steps[k * lanes + lane] += bend * moved[lane] * moved[lane];
                    }
                }
            }
        }
        let unknown = [f64::NAN; WIDEST];
        let mut seen = Outcome {
            masses: unknown,
            errors: unknown,
            residuals: unknown,
            corrections: unknown,
            orientation: unknown,
        };
        if let Some(contact) = contact.as_ref() {
            let closed = CLOSED_IN_LANES * *size;
            let outcome = &mut seen;
            let group = Closing {
                plan,
                contact,
                dependent_positions: following,
                positions,
                steps,
                closed,
                scratch,
                outcome,
            };
            if lanes == 1 { instructions.run_one(group) } else { instructions.run(group) }
        }
        for mimic in mimics {
            for lane in 0..lanes {
                let JointPosition { q, multiplier, offset } = mimic.follows;
                positions[mimic.q * lanes + lane] = multiplier * positions[q * lanes + lane] + offset;
            }
        }
        seen
    }

    /// Result of a lane whose branch is certain.
    fn row_result(&self, seen: &Outcome, lane: usize, lanes: usize) -> Option<FollowedRow> {
        let answered = CertifiedMass { mass: seen.masses[lane], error: seen.errors[lane] };
        let mass = Some(answered).filter(|mass| mass.is_clear(self.linkage.trusted_error()));
        self.is_on_branch(seen, lane, lanes).then_some(FollowedRow { mass, residual: seen.residuals[lane] })
    }

    /// True if the loops of a lane are closed on the branch: the correction of the prediction is small, and the
    /// tangent turns little.
    fn is_on_branch(&self, seen: &Outcome, lane: usize, lanes: usize) -> bool {
        let plan = &self.linkage.plan;
        let (rank, f, rates) = (plan.layout.count, plan.freedoms, plan.layout.rates);
        let moved = |number: usize| self.displacements[number * lanes + lane];
        let mut driven = 0.0;
        for number in 0..self.driven_positions.len() {
            driven += moved(number) * moved(number);
        }
        let (mut ahead, mut now, mut both, mut most) = (driven, driven, driven, driven.sqrt());
        for k in 0..rank {
            let (mut old, mut new) = (0.0, 0.0);
            for (number, one) in self.driven_positions.iter().enumerate() {
                old += self.current.rates[k * f + one.y] * moved(number);
                new += self.linkage.scratch[(rates + k * f + one.y) * lanes + lane] * moved(number);
            }
            (ahead, now, both) = (ahead + old * old, now + new * new, both + old * new);
            most = f64::max(most, old.abs());
        }
        let blurred = (CLOSED * self.size * self.size).sqrt();
        let own = &self.neighbourhood;
        seen.residuals[lane] <= CLOSED * self.size
            && seen.orientation[lane] * own.orientation > 0.0
            && own.distance + LONGEST_FOLLOWED * ahead.sqrt() <= own.radius
            && seen.corrections[lane] <= SMALL_CORRECTION * ahead.sqrt() + blurred
            && most <= LONGEST_BRANCH_STEP * self.size
            && (driven == 0.0 || both >= STRAIGHT * (ahead * now).sqrt())
    }

    /// Upper bound of the distance of a lane's pose from the last pose, m. Within the neighbourhood, the rates of the
    /// dependent coordinates grow by less than half of themselves plus half of the driving rates.
    fn distance(&self, lane: usize, lanes: usize) -> f64 {
        let (rank, f) = (self.linkage.plan.layout.count, self.linkage.plan.freedoms);
        let moved = |number: usize| self.displacements[number * lanes + lane];
        let mut square: f64 =
            (0..self.driven_positions.len()).map(|number| moved(number) * moved(number)).sum();
        for k in 0..rank {
            let given = self.driven_positions.iter().enumerate();
            let own: f64 = given.map(|(number, one)| self.current.rates[k * f + one.y] * moved(number)).sum();
            square += own * own;
        }
        LONGEST_FOLLOWED * square.sqrt()
    }

    /// Makes the pose of a lane the current pose.
    fn commit_lane(&mut self, lane: usize, lanes: usize) {
        self.neighbourhood.distance += self.distance(lane, lanes);
        std::mem::swap(&mut self.current, &mut self.previous);
        let plan = &self.linkage.plan;
        let count = plan.layout.count * plan.freedoms;
        let ClosedPose { positions, rates } = &mut self.current;
        positions.resize(self.previous.positions.len(), 0.0);
        rates.resize(count, 0.0);
        for (q, to) in positions.iter_mut().enumerate() {
            *to = self.positions[q * lanes + lane];
        }
        for (k, to) in rates.iter_mut().enumerate() {
            *to = self.linkage.scratch[(plan.layout.rates + k) * lanes + lane];
        }
    }
}

/// Results of some lanes.
struct Outcome {
    /// See [`Answers`].
    masses: [f64; WIDEST],
    errors: [f64; WIDEST],
    /// Largest residual of a row, m.
    residuals: [f64; WIDEST],
    /// Distance of the dependent coordinates from their prediction, m.
    corrections: [f64; WIDEST],
    /// Product of 1/pivots.
    orientation: [f64; WIDEST],
}

/// All positions of one row, in the columns of some lanes.
#[derive(Clone, Copy, Debug)]
pub struct Positions<'a> {
    values: &'a [f64],
    stride: usize,
    lane: usize,
}

impl Positions<'_> {
    /// Position with the index `q`.
    pub fn at(&self, q: usize) -> f64 {
        self.values[q * self.stride + self.lane]
    }
}

/// Closure of the loops of some lanes by Newton's method.
struct Closing<'a> {
    plan: &'a LoopPlan,
    contact: &'a LoopContact,
    dependent_positions: &'a [DependentPosition],
    positions: &'a mut [f64],
    steps: &'a [f64],
    /// Residual (m) up to which a loop counts as closed: the size of rounding.
    closed: f64,
    scratch: &'a mut [f64],
    outcome: &'a mut Outcome,
}

impl Work for Closing<'_> {
    /// Closes the loops from the predicted positions; writes m̄, errors, residuals and sizes of the corrections to `outcome`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run<T: Lanes>(self) {
        let Self {
            plan,
            contact,
            dependent_positions: following,
            positions,
            steps,
            closed,
            scratch,
            outcome,
        } = self;
        for k in 0..plan.layout.count {
            store(scratch, plan.layout.steps + k, get::<T>(steps, k));
        }
        apply_newton_steps::<T>(plan, following, positions, scratch);
        let mut corrected = T::zero();
        let mut passes = 1;
        let (sizes, seen, least) = loop {
            let sizes: (T, T) =
                fill_frames(plan, PositionColumns { values: positions, stride: T::WIDTH }, 0, scratch);
            let seen = fill_rows::<T, true>(plan, scratch);
            let least: T = eliminate(plan, scratch);
            let mut open = [0.0; WIDEST];
            seen.residual.store(&mut open);
            // A NaN residual never counts as closed.
            let mut all = true;
            for open in &open[..T::WIDTH] {
                all &= *open <= closed;
            }
            if all || passes == CLOSING_PASSES {
                break (sizes, seen, least);
            }
            corrected += fill_steps::<T>(plan, scratch);
            apply_newton_steps::<T>(plan, following, positions, scratch);
            passes += 1;
        };
        let mut orientation = T::one();
        for k in 0..plan.layout.count {
            orientation *= get::<T>(scratch, plan.layout.inverse_pivots + k);
        }
        orientation.store(&mut outcome.orientation);
        let answer = response_after_elimination(plan, (contact, None), sizes, seen.roundings, least, scratch);
        let mut answers = MassColumns { masses: &mut outcome.masses, errors: &mut outcome.errors };
        answers.store(0, answer.response, answer.error);
        seen.residual.store(&mut outcome.residuals);
        corrected.store(&mut outcome.corrections);
    }
}

/// Adds the Newton steps to the positions of the dependent coordinates.
#[cfg_attr(not(debug_assertions), inline(always))]
fn apply_newton_steps<T: Lanes>(
    plan: &LoopPlan,
    following: &[DependentPosition],
    positions: &mut [f64],
    scratch: &[f64],
) {
    let steps = plan.layout.steps;
    for one in following {
        match one {
            DependentPosition::Single { q, column, factor } => {
                let step: T = get(scratch, steps + column);
                store(positions, *q, step.mul_add(T::from_f64(*factor), get(positions, *q)));
            }
            DependentPosition::Spherical { q, turns } => {
                let mut half = [T::zero(); 3];
                let mut k = 0;
                while k < 3 {
                    if let Some((column, factor)) = turns[k] {
                        half[k] = get::<T>(scratch, steps + column) * T::from_f64(0.5 * factor);
                    }
                    k += 1;
                }
                rotate_quaternion(positions, *q, &half);
            }
        }
    }
}

/// Rotates a unit quaternion, q ← q ∘ (√(1 − |h|²), h). `h`: half of a small rotation vector in the rotated axes.
#[cfg_attr(not(debug_assertions), inline(always))]
fn rotate_quaternion<T: Lanes>(positions: &mut [f64], q: usize, h: &[T; 3]) {
    let (w, x) = (get::<T>(positions, q), get::<T>(positions, q + 1));
    let (y, z) = (get::<T>(positions, q + 2), get::<T>(positions, q + 3));
    let square = h[2].mul_add(h[2], h[1].mul_add(h[1], h[0] * h[0]));
    let c = (T::one() - square).sqrt();
    let turned = [
        w * c - (x * h[0] + y * h[1] + z * h[2]),
        x * c + (w * h[0] + y * h[2] - z * h[1]),
        y * c + (w * h[1] + z * h[0] - x * h[2]),
        z * c + (w * h[2] + x * h[1] - y * h[0]),
    ];
    let norm = turned[0] * turned[0] + turned[1] * turned[1] + turned[2] * turned[2] + turned[3] * turned[3];
    let over = T::one() / norm.sqrt();
    let mut k = 0;
    while k < 4 {
        store(positions, q + k, turned[k] * over);
        k += 1;
    }
}
