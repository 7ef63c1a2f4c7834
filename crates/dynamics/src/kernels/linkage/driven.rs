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

use super::Linkage;
use super::motion::{Struck, answer};
use super::place::place;
use super::plan::{Motion, Plan};
use super::room::{get, put};
use super::rows::{eliminate, fill_rows, fill_steps, rows_at};
use crate::analysis::assembly::Assembly;
use crate::kernels::aligned::Aligned;
use crate::kernels::estimate::{Answered, Answers, Columns, WIDEST};
use crate::kinematics::contact::Contact;
use crate::tolerances::{
    CLOSED, CLOSED_IN_LANES, CLOSING_PASSES, CURVATURE_STEP, DRIFT_ITERATIONS, FOLLOWERS_DRIFT,
    LONGEST_BRANCH_STEP, LONGEST_FOLLOWED, SMALL_CORRECTION, STRAIGHT,
};
use percuss_spatial::Scalar;
use percuss_spatial::lanes::{Lanes, Portable, Work};

/// Positions that change with a dependent coordinate.
#[derive(Clone, Copy, Debug)]
enum Following {
    /// One position of a hinge or slide; `factor`: its change per metre of the column.
    Single { q: usize, column: usize, factor: f64 },
    /// Quaternion: for each rotation its column, if dependent.
    Ball { q: usize, turns: [Option<(usize, f64)>; 3] },
}

/// Position given by the sweep rows.
#[derive(Clone, Copy, Debug)]
struct Given {
    q: usize,
    /// Independent coordinate, and its change (m) per unit of the position.
    y: usize,
    length: f64,
}

/// Position of a mimic joint: `multiplier · positions[master] + offset`.
#[derive(Clone, Copy, Debug)]
struct Mimicked {
    q: usize,
    master: usize,
    multiplier: f64,
    offset: f64,
}

/// Neighbourhood of a pose of the branch without any other branch. Distances are over all coordinates in metres.
#[derive(Clone, Debug, Default)]
struct Neighbourhood {
    /// ‖A′‖, 1/m: change of A over a motion.
    curvature: f64,
    /// Radius of the neighbourhood, m.
    radius: f64,
    /// Upper bound of the distance of the current pose from the centre, m.
    gone: f64,
    /// Product of 1/pivots at the first pose: its sign is the sign of det A\[d\] and identifies the assembly mode.
    orientation: f64,
    scratch: Vec<f64>,
}

/// Closed pose, with the rates of the dependent coordinates.
#[derive(Clone, Debug, Default)]
struct Stand {
    positions: Vec<f64>,
    /// G: pivots × freedoms.
    rates: Vec<f64>,
}

/// Result of a sweep row on the branch.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Followed {
    /// `None` if rounding leaves a doubt.
    pub mass: Option<Answered>,
    /// Largest residual of a loop, m.
    pub residual: f64,
}

/// Linkage with its contact and its current pose.
#[derive(Clone, Debug)]
pub(crate) struct Driven {
    linkage: Linkage,
    following: Vec<Following>,
    given: Vec<Given>,
    mimics: Vec<Mimicked>,
    neighbourhood: Neighbourhood,
    /// Smallest size of a group, m.
    size: f64,
    here: Stand,
    before: Stand,
    /// Positions, and steps of the dependent coordinates (m), of some lanes by columns.
    positions: Aligned,
    steps: Aligned,
    /// Displacements of the given positions, of some lanes (m).
    moved: Vec<f64>,
}

impl Driven {
    /// Starts at a closed pose. `dependent`: true for each coordinate that can be dependent; `given`: indices of the
    /// positions that the rows give. `None` if the assembly is not a supported linkage, or the given positions do not
    /// drive it.
    pub fn of(
        assembly: &Assembly,
        contact: &Contact,
        positions: &[f64],
        dependent: &[bool],
        given: &[usize],
    ) -> Option<Self> {
        let model = assembly.model();
        let plan = Plan::driven(assembly, positions, &|column| dependent[column])?;
        let rank = plan.layout.count;
        let (mut following, mut free) = (Vec::new(), Vec::new());
        for (body, own) in plan.bodies.iter().zip(&model.bodies).filter(|(_, own)| own.mimic.is_none()) {
            match body.motion {
                Motion::Fixed | Motion::Free => {}
                Motion::Turn(position) | Motion::Slide(position) => {
                    let Some(velocity) = body.velocities.first() else { continue };
                    let (q, column, factor) = (position.q, velocity.column, velocity.factor);
                    if column < rank {
                        following.push(Following::Single { q, column, factor });
                    } else {
                        free.push(Given { q, y: column - rank, length: 1.0 / factor });
                    }
                }
                Motion::Ball(q) => {
                    let turn = |k: usize| {
                        let velocity = body.velocities.get(k).filter(|velocity| velocity.column < rank)?;
                        Some((velocity.column, velocity.factor))
                    };
                    debug_assert_eq!(own.q.start, q);
                    following.push(Following::Ball { q, turns: [turn(0), turn(1), turn(2)] });
                }
            }
        }
        let given = given.iter().map(|&q| free.iter().find(|free| free.q == q).copied());
        let given: Vec<Given> = given.collect::<Option<_>>()?;
        let mimicked = model.bodies.iter().filter_map(|body| {
            let mimic = body.mimic?;
            let (master, multiplier, offset) = (mimic.master, mimic.multiplier, mimic.offset);
            Some(Mimicked { q: body.q.start, master, multiplier, offset })
        });
        let mut linkage = Linkage::with(plan);
        linkage.aim(model, contact);
        let mut driven = Self {
            size: model.groups.iter().map(|group| group.size).fold(f64::INFINITY, f64::min),
            here: Stand::default(),
            before: Stand::default(),
            positions: Aligned::zeros(positions.len() * WIDEST),
            steps: Aligned::zeros(rank * WIDEST),
            moved: vec![0.0; given.len() * WIDEST],
            linkage,
            following,
            given,
            mimics: mimicked.collect(),
            neighbourhood: Neighbourhood::default(),
        };
        driven.stand(positions).then_some(driven)
    }

    /// Sets a closed pose of the same branch; returns false if the branch is uncertain.
    pub fn stand(&mut self, positions: &[f64]) -> bool {
        let plan = &self.linkage.plan;
        self.here =
            Stand { positions: positions.to_vec(), rates: vec![0.0; plan.layout.count * plan.freedoms] };
        self.before = Stand::default();
        let row: Vec<f64> = self.given.iter().map(|given| positions[given.q]).collect();
        self.neighbourhood.radius = f64::INFINITY;
        let seen = self.go(&row, 1, 1);
        self.neighbourhood.orientation = seen.orientation[0];
        let stands = self.is_on_branch(&seen, 0, 1);
        self.settle(0, 1);
        self.neighbourhood.curvature = self.curvature(positions);
        self.centre(0, 1);
        stands
    }

    /// ‖A′‖ (1/m) at a pose, by differences over every coordinate that moves.
    fn curvature(&self, positions: &[f64]) -> f64 {
        let plan = &self.linkage.plan;
        let step = CURVATURE_STEP * self.size;
        let here = rows_at(plan, positions);
        let mut moved = positions.to_vec();
        let mut square = 0.0;
        let mut change = |moved: &[f64]| {
            let differences =
                rows_at(plan, moved).iter().zip(&here).map(|(a, b)| a - b).collect::<Vec<f64>>();
            square += differences.iter().map(|d| d * d).sum::<f64>() / (step * step);
        };
        for one in &self.following {
            match one {
                Following::Single { q, factor, .. } => {
                    moved[*q] += factor * step;
                    change(&moved);
                    moved[*q] = positions[*q];
                }
                Following::Ball { q, turns } => {
                    for (k, turn) in turns.iter().enumerate() {
                        let Some((_, factor)) = turn else { continue };
                        let mut half = [Portable::<1>::from_f64(0.0); 3];
                        half[k] = Portable::from_f64(0.5 * factor * step);
                        turn_further(&mut moved, *q, &half);
                        change(&moved);
                        moved[*q..*q + 4].copy_from_slice(&positions[*q..*q + 4]);
                    }
                }
            }
        }
        for one in &self.given {
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
        own.gone = 0.0;
        // With a NaN radius every row is refused.
        own.radius = FOLLOWERS_DRIFT / (own.curvature * inverse).max(f64::MIN_POSITIVE);
    }

    /// ‖A\[d\]⁻¹‖ at a lane, by power iterations with the factors of the elimination.
    fn inverse_norm(&mut self, lane: usize, lanes: usize) -> f64 {
        let plan = &self.linkage.plan;
        let (n, rank, rows) = (plan.columns, plan.layout.count, plan.layout.rows);
        let room = &self.linkage.room;
        let entry = |r: usize, c: usize| room[(rows + r * n + c) * lanes + lane];
        let over = |k: usize| room[(plan.layout.over + k) * lanes + lane];
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
                plan.pivots[k].rows.iter().for_each(|&r| v[r] -= entry(r, k) * known);
            }
            for k in (0..rank).rev() {
                let ahead = plan.pivots[k].columns.iter().filter(|c| **c < rank);
                let known: f64 = ahead.map(|&c| entry(k, c) * v[c]).sum();
                v[k] = (v[k] - known) * over(k);
            }
            norm = v.iter().map(|v| v * v).sum::<f64>().sqrt();
            // Uᵀ y = x, Lᵀ z = y.
            for k in 0..rank {
                v[k] *= over(k);
                let known = v[k];
                let ahead = plan.pivots[k].columns.iter().filter(|c| **c < rank);
                ahead.for_each(|&c| v[c] -= entry(k, c) * known);
            }
            for k in (0..rank).rev() {
                let known: f64 = plan.pivots[k].rows.iter().map(|&r| entry(r, k) * v[r]).sum();
                v[k] -= known * over(k);
            }
        }
        norm
    }

    /// Positions at the current pose.
    pub fn positions(&self) -> &[f64] {
        &self.here.positions
    }

    /// Follows the branch over rows of given positions, one after another, until the branch of a row is uncertain.
    /// Calls `each` for every row on the branch with all its positions. Returns the number of these rows; the last of
    /// them becomes the current pose.
    pub fn follow(&mut self, values: &[f64], each: &mut dyn FnMut(Followed, Positions<'_>)) -> usize {
        let width = self.given.len().max(1);
        let (rows, widest) = (values.len() / width, self.linkage.instructions.width());
        let mut done = 0;
        while done < rows {
            let count = widest.min(rows - done);
            // A single row uses scalar code. Several rows use all lanes; spare lanes repeat the last row.
            let lanes = if count == 1 { 1 } else { widest };
            let seen = self.go(&values[done * width..(done + count) * width], count, lanes);
            let mut answered = 0;
            while answered < count
                && let Some(followed) = self.followed(&seen, answered, lanes)
            {
                each(followed, Positions { values: &self.positions, stride: lanes, lane: answered });
                answered += 1;
            }
            if answered == 0 {
                break;
            }
            self.settle(answered - 1, lanes);
            if self.neighbourhood.gone > 0.5 * self.neighbourhood.radius {
                self.centre(answered - 1, lanes);
            }
            done += answered;
        }
        done
    }

    /// Predicts the positions of some rows and closes their loops.
    fn go(&mut self, values: &[f64], count: usize, lanes: usize) -> Outcome {
        let Self { linkage, following, given, mimics, here, before, positions, steps, moved, size, .. } =
            self;
        let Linkage { plan, struck, room, instructions } = linkage;
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
            open: unknown,
            corrected: unknown,
            orientation: unknown,
        };
        if let Some(struck) = struck.as_ref() {
            let closed = CLOSED_IN_LANES * *size;
            let outcome = &mut seen;
            let group = Closing { plan, struck, following, positions, steps, closed, room, outcome };
            if lanes == 1 { instructions.run_one(group) } else { instructions.run(group) }
        }
        for mimic in mimics {
            for lane in 0..lanes {
                let master = positions[mimic.master * lanes + lane];
                positions[mimic.q * lanes + lane] = mimic.multiplier * master + mimic.offset;
            }
        }
        seen
    }

    /// Result of a lane whose branch is certain.
    fn followed(&self, seen: &Outcome, lane: usize, lanes: usize) -> Option<Followed> {
        let answered = Answered { mass: seen.masses[lane], error: seen.errors[lane] };
        let mass = Some(answered).filter(Answered::is_clear);
        self.is_on_branch(seen, lane, lanes).then_some(Followed { mass, residual: seen.open[lane] })
    }

    /// True if the loops of a lane are closed on the branch: the correction of the prediction is small, and the
    /// tangent turns little.
    fn is_on_branch(&self, seen: &Outcome, lane: usize, lanes: usize) -> bool {
        let plan = &self.linkage.plan;
        let (rank, f, rates) = (plan.layout.count, plan.freedoms, plan.layout.rates);
        let moved = |number: usize| self.moved[number * lanes + lane];
        let mut driven = 0.0;
        for number in 0..self.given.len() {
            driven += moved(number) * moved(number);
        }
        let (mut ahead, mut now, mut both, mut most) = (driven, driven, driven, driven.sqrt());
        for k in 0..rank {
            let (mut old, mut new) = (0.0, 0.0);
            for (number, one) in self.given.iter().enumerate() {
                old += self.here.rates[k * f + one.y] * moved(number);
                new += self.linkage.room[(rates + k * f + one.y) * lanes + lane] * moved(number);
            }
            (ahead, now, both) = (ahead + old * old, now + new * new, both + old * new);
            most = f64::max(most, old.abs());
        }
        let blurred = (CLOSED * self.size * self.size).sqrt();
        let own = &self.neighbourhood;
        seen.open[lane] <= CLOSED * self.size
            && seen.orientation[lane] * own.orientation > 0.0
            && own.gone + LONGEST_FOLLOWED * ahead.sqrt() <= own.radius
            && seen.corrected[lane] <= SMALL_CORRECTION * ahead.sqrt() + blurred
            && most <= LONGEST_BRANCH_STEP * self.size
            && (driven == 0.0 || both >= STRAIGHT * (ahead * now).sqrt())
    }

    /// Upper bound of the distance of a lane's pose from the last pose, m. Within the neighbourhood, the rates of the
    /// dependent coordinates grow by less than half of themselves plus half of the driving rates.
    fn distance(&self, lane: usize, lanes: usize) -> f64 {
        let (rank, f) = (self.linkage.plan.layout.count, self.linkage.plan.freedoms);
        let moved = |number: usize| self.moved[number * lanes + lane];
        let mut square: f64 = (0..self.given.len()).map(|number| moved(number) * moved(number)).sum();
        for k in 0..rank {
            let given = self.given.iter().enumerate();
            let own: f64 = given.map(|(number, one)| self.here.rates[k * f + one.y] * moved(number)).sum();
            square += own * own;
        }
        LONGEST_FOLLOWED * square.sqrt()
    }

    /// Makes the pose of a lane the current pose.
    fn settle(&mut self, lane: usize, lanes: usize) {
        self.neighbourhood.gone += self.distance(lane, lanes);
        std::mem::swap(&mut self.here, &mut self.before);
        let plan = &self.linkage.plan;
        let count = plan.layout.count * plan.freedoms;
        let Stand { positions, rates } = &mut self.here;
        positions.resize(self.before.positions.len(), 0.0);
        rates.resize(count, 0.0);
        for (q, to) in positions.iter_mut().enumerate() {
            *to = self.positions[q * lanes + lane];
        }
        for (k, to) in rates.iter_mut().enumerate() {
            *to = self.linkage.room[(plan.layout.rates + k) * lanes + lane];
        }
    }
}

/// Results of some lanes.
struct Outcome {
    /// See [`Answers`].
    masses: [f64; WIDEST],
    errors: [f64; WIDEST],
    /// Largest residual of a row, m.
    open: [f64; WIDEST],
    /// Distance of the dependent coordinates from their prediction, m.
    corrected: [f64; WIDEST],
    /// Product of 1/pivots.
    orientation: [f64; WIDEST],
}

/// All positions of one row, in the columns of some lanes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Positions<'a> {
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
    plan: &'a Plan,
    struck: &'a Struck,
    following: &'a [Following],
    positions: &'a mut [f64],
    steps: &'a [f64],
    /// Residual (m) up to which a loop counts as closed: the size of rounding.
    closed: f64,
    room: &'a mut [f64],
    outcome: &'a mut Outcome,
}

impl Work for Closing<'_> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run<T: Lanes>(self) {
        let Self { plan, struck, following, positions, steps, closed, room, outcome } = self;
        for k in 0..plan.layout.count {
            put(room, plan.layout.steps + k, get::<T>(steps, k));
        }
        go::<T>(plan, following, positions, room);
        let mut corrected = T::zero();
        let mut passes = 1;
        let (placed, seen, least) = loop {
            let placed: (T, T) = place(plan, Columns { values: positions, stride: T::WIDTH }, 0, room);
            let seen = fill_rows::<T, true>(plan, room);
            let least: T = eliminate::<T, true>(plan, room);
            let mut open = [0.0; WIDEST];
            seen.open.store(&mut open);
            // A NaN residual never counts as closed.
            let mut all = true;
            for open in &open[..T::WIDTH] {
                all &= *open <= closed;
            }
            if all || passes == CLOSING_PASSES {
                break (placed, seen, least);
            }
            corrected += fill_steps::<T>(plan, room);
            go::<T>(plan, following, positions, room);
            passes += 1;
        };
        let mut orientation = T::one();
        for k in 0..plan.layout.count {
            orientation *= get::<T>(room, plan.layout.over + k);
        }
        orientation.store(&mut outcome.orientation);
        let answer = answer(plan, struck, placed, seen.roundings, least, room);
        let mut answers = Answers { masses: &mut outcome.masses, errors: &mut outcome.errors };
        answers.put(0, answer.response, answer.error);
        seen.open.store(&mut outcome.open);
        corrected.store(&mut outcome.corrected);
    }
}

/// Adds the Newton steps to the positions of the dependent coordinates.
#[cfg_attr(not(debug_assertions), inline(always))]
fn go<T: Lanes>(plan: &Plan, following: &[Following], positions: &mut [f64], room: &[f64]) {
    let steps = plan.layout.steps;
    for one in following {
        match one {
            Following::Single { q, column, factor } => {
                let step: T = get(room, steps + column);
                put(positions, *q, step.mul_add(T::from_f64(*factor), get(positions, *q)));
            }
            Following::Ball { q, turns } => {
                let mut half = [T::zero(); 3];
                let mut k = 0;
                while k < 3 {
                    if let Some((column, factor)) = turns[k] {
                        half[k] = get::<T>(room, steps + column) * T::from_f64(0.5 * factor);
                    }
                    k += 1;
                }
                turn_further(positions, *q, &half);
            }
        }
    }
}

/// Rotates a unit quaternion by a small rotation vector in the rotated axes; `h`: half the vector. q ← q ∘ (√(1 −
/// |h|²), h).
#[cfg_attr(not(debug_assertions), inline(always))]
fn turn_further<T: Lanes>(positions: &mut [f64], q: usize, h: &[T; 3]) {
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
        put(positions, q + k, turned[k] * over);
        k += 1;
    }
}
