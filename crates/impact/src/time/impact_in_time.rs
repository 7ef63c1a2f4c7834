//! Impact in time against a compliant contact.

use crate::error::ImpactError;
use crate::motion::driver_rates::lengths;
use crate::motion::joint_rates::JointRates;
use crate::numerics::extrapolation::step;
use crate::numerics::multistep::MultistepIntegrator;
use crate::reactions::force_elements::SpringForces;
use crate::reactions::reaction::Reactions;
use crate::reactions::reaction_map::{ReactionBuffers, ReactionMap};

use crate::time::conditions::{TimeConditions, refuse_grounded_base, spring_forces, stopping_depth};
use crate::time::equations::{MotionEquations, base_motion, rates_of};
use crate::time::history::{EnergyBalance, ImpactInTime, ImpactSample, peak_over_time};
use crate::tolerances::{
    CORNER_DISTANCE, GOLDEN, LARGEST_TIME_STEP, MOST_TIME_STEPS, NEAR_PEAK, NO_REBOUND, PEAK_PLACE,
    STEPS_WITHOUT_REBOUND, TIME_STEP_ERROR,
};
use nalgebra::{DVector, Vector3};
use percuss_dynamics::{Contact, EffectiveMass, LocatedContact, Pose, Workspace, interruption};
use percuss_spatial::quaternion_product;
use std::cell::{Cell, RefCell};

/// Unit of the works, over the kinetic energy ½ m̄ c²: so large that their errors do not shorten the steps.
const WORK_UNIT: f64 = 1e3;
/// Time after the contact in which a second touch is searched, over the duration of the contact.
const WATCHED: f64 = 3.0;
/// Numbers that describe the motion of a base: position and quaternion w, x, y, z.
const BASE: usize = 7;

/// Impact of any mechanism in time: equations of motion with the force F(δ, δ̇) of a compliant contact, δ̇ = j u.
///
/// `before`: admissible rates before the impact; `closing_speed` is their closing speed, with a free body on the other side the
/// difference of both speeds. `force`: F over penetration (m) and closing speed (m/s), N. Trees and loops, redundant constraints,
/// fixed and floating bases; m̄, normal and contact row follow the pose. Without friction.
///
/// The accelerations have a closed form at each pose. The integration uses a predictor and corrector of order 10, started by
/// extrapolation, with an error of 1e-12 per step, relative to the penetration and the largest rate. The gaps of the loops are not
/// corrected, so that [`loop_gap`](ImpactSample::loop_gap) shows the error of the integration. Sources: Featherstone 2008,
/// §8; Hairer, Nørsett and Wanner 1993, §II.9 and §III.1.
///
/// # Errors
/// [`ImpactError`]: a closing speed out of range; a contact that does not end; a pose without a contact; an invalid spring.
pub fn impact_in_time(
    pose: &Pose,
    contact: &Contact,
    closing_speed: f64,
    before: &JointRates,
    force: &dyn Fn(f64, f64) -> f64,
    conditions: &TimeConditions,
) -> Result<ImpactInTime, ImpactError> {
    if !(closing_speed.is_finite() && closing_speed > 0.0) {
        return Err(ImpactError::ClosingSpeed { got: closing_speed });
    }
    refuse_grounded_base(pose)?;
    let springs = spring_forces(pose, conditions)?;
    let mass = match pose.respond(contact).map(|response| response.effective_mass) {
        Ok(EffectiveMass::Finite(mass)) => mass,
        Ok(EffectiveMass::Massless) => return Err(crate::ReactionError::Massless.into()),
        _ => return Err(ImpactError::Immovable),
    };
    let mass = conditions.other_mass.map_or(mass, |other| mass * other / (mass + other));
    let energy = 0.5 * mass * closing_speed * closing_speed;
    let depth = stopping_depth(force, energy)?;
    Motion::new(pose, contact, closing_speed, before, force, conditions, (depth, energy), springs).run()
}

/// Motion in scaled variables, each of order one: displacements of the joints and of the base over `depth`, rates over the largest
/// rate, penetration over `depth`, speed of the other body over the closing speed, work taken by the contact and work of the other forces over
/// `work`; time over `depth`/closing speed.
pub(super) struct Motion<'a> {
    pub(super) start: &'a Pose,
    pub(super) contact: &'a Contact,
    force: &'a dyn Fn(f64, f64) -> f64,
    pub(super) conditions: &'a TimeConditions,
    pub(super) speed: f64,
    pub(super) depth: f64,
    /// Largest rate before the impact, m/s over scaled coordinates.
    rate: f64,
    /// Factor from a coordinate's rate to the rate of a displacement in metres.
    lengths: Vec<f64>,
    /// State at the touch.
    initial: Vec<f64>,
    evaluation: RefCell<Evaluation>,
    /// True if the last evaluation is beyond the end of the contact.
    is_over: Cell<bool>,
    /// Direction of the motion, for a force that jumps at the reversal.
    pub(super) is_closing: Cell<bool>,
    /// True after the contact: its force is 0.
    pub(super) is_free: Cell<bool>,
    springs: SpringForces,
    /// Unit of the works, J.
    work: f64,
}

/// Last evaluation of the derivative.
struct Evaluation {
    pose: Pose,
    equations: MotionEquations,
    /// `None` if the contact did not exist.
    instant: Option<Instant>,
}

/// Contact, rates and contact force at one state (SI units).
pub(super) struct Instant {
    contact: LocatedContact,
    rates: Vec<f64>,
    pub(super) penetration: f64,
    pub(super) closing: f64,
    force: f64,
}

impl<'a> Motion<'a> {
    #[allow(clippy::too_many_arguments, reason = "parts of one question")]
    fn new(
        start: &'a Pose,
        contact: &'a Contact,
        speed: f64,
        before: &JointRates,
        force: &'a dyn Fn(f64, f64) -> f64,
        conditions: &'a TimeConditions,
        (depth, energy): (f64, f64),
        springs: SpringForces,
    ) -> Self {
        let lengths = lengths(start, &start.coordinate_joints());
        let u = before.coordinates(start);
        let scaled = |(u, length): (&f64, &f64)| (u * length).abs();
        let rate = u.iter().zip(&lengths).map(scaled).fold(speed, f64::max);
        let row = start.locate(contact).map(|located| start.contact_row(&located)).unwrap_or_default();
        let own: f64 = row.iter().zip(&u).map(|(j, u)| j * u).sum();
        let mut initial = vec![0.0; start.positions().len() + BASE];
        initial.extend(u.iter().zip(&lengths).map(|(u, length)| u * length / rate));
        initial.extend([
            0.0,
            if conditions.other_mass.is_some() { (speed - own) / speed } else { 0.0 },
            0.0,
            0.0,
        ]);
        let equations = MotionEquations::new(start, springs.clone());
        let evaluation = RefCell::new(Evaluation { pose: start.clone(), equations, instant: None });
        Self {
            start,
            contact,
            force,
            conditions,
            speed,
            depth,
            rate,
            lengths,
            initial,
            evaluation,
            is_over: Cell::new(false),
            is_closing: Cell::new(true),
            is_free: Cell::new(false),
            springs,
            work: WORK_UNIT * energy,
        }
    }

    /// Integrator from a state with the scaled rates `rate`.
    pub(super) fn integrator(&self, rate: Vec<f64>) -> MultistepIntegrator {
        let integrator = MultistepIntegrator::new(rate, LARGEST_TIME_STEP, TIME_STEP_ERROR);
        integrator.with_kinks(self.springs.has_kinks())
    }

    /// Displacement of positions, rad or m, per unit of a scaled position.
    fn displacement(&self) -> f64 {
        self.depth * self.rate / self.speed
    }

    /// Contact, rates and force at a scaled state. Moves `pose` to the state; `None` if the contact does not exist there.
    pub(super) fn instant(&self, y: &[f64], pose: &mut Pose) -> Option<Instant> {
        interruption::check();
        let (positions, rest) = y.split_at(self.start.positions().len());
        let (base, rest) = rest.split_at(BASE);
        let (rates, rest) = rest.split_at(self.lengths.len());
        let size = self.displacement();
        let q: Vec<f64> = self.start.positions().iter().zip(positions).map(|(q, x)| q + size * x).collect();
        pose.move_to(&q, *self.start.base() * base_motion(base, size)).ok()?;
        let contact = pose.locate(self.contact).ok()?;
        let rates: Vec<f64> = rates.iter().zip(&self.lengths).map(|(x, l)| x * self.rate / l).collect();
        let own: f64 = pose.contact_row(&contact).iter().zip(&rates).map(|(j, u)| j * u).sum();
        let (penetration, closing) = (self.depth * rest[0], own + self.speed * rest[1]);
        let rate = match (self.conditions.jumps_at_reversal, self.is_closing.get()) {
            (false, _) => closing,
            (true, true) => closing.max(f64::MIN_POSITIVE),
            (true, false) => closing.min(-f64::MIN_POSITIVE),
        };
        let force = if self.is_free.get() { 0.0 } else { (self.force)(penetration, rate) };
        Some(Instant { contact, rates, penetration, closing, force })
    }

    /// True if springs, dampers, drives, supports or gravity act.
    pub(super) fn has_other_forces(&self) -> bool {
        !self.springs.is_empty() || self.conditions.gravity != Vector3::zeros()
    }

    /// Gravity in root axes.
    fn gravity(&self, pose: &Pose) -> Vector3<f64> {
        pose.base().inverse_vector(&self.conditions.gravity)
    }

    /// Rates of the scaled state over scaled time; NaN if the contact does not exist.
    pub(super) fn derivative(&self, y: &[f64], out: &mut [f64]) {
        if self.try_derivative(y, out).is_none() {
            out.fill(f64::NAN);
        }
    }

    fn try_derivative(&self, y: &[f64], out: &mut [f64]) -> Option<()> {
        let mut evaluation = self.evaluation.borrow_mut();
        evaluation.instant = None;
        let Evaluation { pose, equations, instant } = &mut *evaluation;
        let at = self.instant(y, pose)?;
        self.is_over.set(self.is_end(&at));
        let time = self.depth / self.speed;
        let change = equations.accelerations(pose, &at.contact, &at.rates, at.force, &self.gravity(pose))?;
        let (n, m) = (self.start.positions().len(), self.lengths.len());
        let size = self.displacement();
        let (of_positions, twist) = equations.position_rates(pose, &at.rates)?;
        out[..n].iter_mut().zip(&of_positions).for_each(|(out, rate)| *out = rate * time / size);
        let base = &y[n..n + BASE];
        let spin = twist.angular * 0.5;
        let slide = base_motion(base, size).vector(&twist.linear);
        let quaternion = [1.0 + size * base[3], size * base[4], size * base[5], size * base[6]];
        let turn = quaternion_product(quaternion, [0.0, spin.x, spin.y, spin.z]);
        for (out, rate) in out[n..n + BASE].iter_mut().zip(slide.iter().chain(&turn)) {
            *out = rate * time / size;
        }
        let scaled = change.iter().zip(&self.lengths).map(|(a, length)| a * length * time / self.rate);
        out[n + BASE..n + BASE + m].iter_mut().zip(scaled).for_each(|(out, rate)| *out = rate);
        out[n + BASE + m] = at.closing * time / self.depth;
        out[n + BASE + m + 1] =
            self.conditions.other_mass.map_or(0.0, |mass| -at.force / mass * time / self.speed);
        let gravity = self.gravity(pose);
        let others = match self.springs.is_empty() && gravity == Vector3::zeros() {
            true => 0.0,
            false => equations.applied_power(pose, &at.contact, &at.rates, &gravity),
        };
        out[n + BASE + m + 2] = at.force * at.closing * time / self.work;
        out[n + BASE + m + 3] = others * time / self.work;
        *instant = Some(at);
        Some(())
    }

    /// Values at the state of the last derivative. Exchanges `pose` for the pose there.
    fn take_instant(&self, pose: &mut Pose) -> Option<Instant> {
        let mut evaluation = self.evaluation.borrow_mut();
        std::mem::swap(&mut evaluation.pose, pose);
        evaluation.instant.take()
    }

    /// Quantity that falls through zero at the end of the contact, of order one.
    fn remaining(&self, at: &Instant) -> f64 {
        // A force curve can have a force at the touch: the gap closes before the force vanishes.
        if self.conditions.ends_without_force && (self.force)(0.0, at.closing) <= 0.0 {
            at.force / (self.force)(self.depth, 0.0)
        } else {
            at.penetration / self.depth
        }
    }

    fn run(&self) -> Result<ImpactInTime, ImpactError> {
        let f = |y: &[f64], out: &mut [f64]| self.derivative(y, out);
        let lost = || ImpactError::LostContact;
        let (mut y, mut time) = (self.initial.clone(), 0.0);
        let mut sampler = Sampler::new(self);
        let mut rate = vec![0.0; y.len()];
        f(&y, &mut rate);
        let at = self.take_instant(&mut sampler.pose).ok_or_else(lost)?;
        sampler.add(self, time, &at, &rate);
        let mut deepest: Option<(f64, Option<f64>)> = None;
        let (mut closing, mut penetration) = (at.closing, at.penetration);
        let mut integrator = self.integrator(rate);
        // Steps in a row with a speed below each of two parts of the closing speed: a step is a part of the time of a half oscillation.
        let mut slow = [0; 2];
        for _ in 0..MOST_TIME_STEPS {
            let (next, taken) = integrator.advance(&f, &y, &|| self.is_over.get());
            let reversal = self.reversal(&y, taken, &mut sampler.pose);
            let within = reversal.as_ref().map_or(taken, |(_, _, h)| *h);
            let passed = self.corner(&y, within, (penetration, closing), &mut sampler.pose);
            // The contact can end before the point within the same step.
            let passed = passed.filter(|(_, at, _)| !self.is_end(at));
            if let (None, Some((state, at, taken))) = (&passed, reversal) {
                let states = |h: f64| step(&f, &y, h, TIME_STEP_ERROR).0;
                // Both ends of the jump are samples.
                sampler.add_within(self, time, taken, &states);
                time += taken;
                deepest = deeper(deepest, Some((at.penetration, finite_mass(&sampler.pose, self.contact))));
                let mut rate = vec![0.0; state.len()];
                f(&state, &mut rate);
                sampler.add(self, time, &at, &rate);
                self.is_closing.set(!self.is_closing.get());
                f(&state, &mut rate);
                let then = self.take_instant(&mut sampler.pose).ok_or_else(lost)?;
                sampler.add(self, time, &then, &rate);
                (y, closing, penetration) = (state, then.closing, then.penetration);
                if self.sticks(&y) {
                    // With more freedoms the sides can separate later.
                    let is_single =
                        self.start.degrees_of_freedom() == 1 && self.conditions.other_mass.is_none();
                    slow[1] = if is_single { STEPS_WITHOUT_REBOUND + 1 } else { 0 };
                    break;
                }
                integrator = self.integrator(rate);
                continue;
            }
            if let Some((state, at, taken)) = passed {
                let states = |h: f64| step(&f, &y, h, TIME_STEP_ERROR).0;
                if closing > 0.0 && at.closing <= 0.0 {
                    deepest = deeper(deepest, self.turning_point(&y, taken, &states));
                }
                sampler.add_within(self, time, taken, &states);
                time += taken;
                let mut rate = vec![0.0; state.len()];
                f(&state, &mut rate);
                (y, closing, penetration) = (state, at.closing, at.penetration);
                sampler.add(self, time, &at, &rate);
                integrator = self.integrator(rate);
                continue;
            }
            let Some(next) = next else {
                // The contact ends within one step after y. The polynomial is compared with an extrapolation step, which replaces it if
                // the states differ.
                let single = |h: f64| step(&f, &y, h, TIME_STEP_ERROR).0;
                let dense = |h: f64| integrator.state_after(&y, h);
                let locate = |states: &dyn Fn(f64) -> Vec<f64>, pose: &mut Pose| {
                    self.locate(&y, taken, states, &|at| self.remaining(at), pose).ok_or_else(lost)
                };
                let mut end = locate(&dense, &mut sampler.pose)?;
                let is_exact = are_close(&end.0, &single(end.2));
                if !is_exact {
                    end = locate(&single, &mut sampler.pose)?;
                }
                let states: &dyn Fn(f64) -> Vec<f64> = if is_exact { &dense } else { &single };
                if closing > 0.0 {
                    deepest = deeper(deepest, self.turning_point(&y, taken, states));
                }
                sampler.add_within(self, time, end.2, states);
                return self.finish(sampler, time, end, deepest);
            };
            // The integrator evaluates the derivative at the next state last.
            let then = self.take_instant(&mut sampler.pose).filter(|at| at.closing.is_finite());
            let then = then.ok_or_else(lost)?;
            let single = |h: f64| step(&f, &y, h, TIME_STEP_ERROR).0;
            let dense = |h: f64| integrator.state_before(&y, h);
            let states: &dyn Fn(f64) -> Vec<f64> = if integrator.is_dense() { &dense } else { &single };
            // The penetration can have several maxima: the contact link can approach again before the sides separate.
            if closing > 0.0 && then.closing <= 0.0 {
                let turn = self.turning_point(&y, taken, states).ok_or_else(lost)?;
                deepest = deeper(deepest, Some(turn));
            }
            (closing, penetration) = (then.closing, then.penetration);
            if self.is_end(&then) {
                let end = self.locate(&y, taken, &single, &|at| self.remaining(at), &mut sampler.pose);
                let end = end.ok_or_else(lost)?;
                sampler.add_within(self, time, end.2, &single);
                return self.finish(sampler, time, end, deepest);
            }
            sampler.add_within(self, time, taken, states);
            time += taken;
            y = next;
            sampler.add(self, time, &then, integrator.rate());
            for (steps, part) in slow.iter_mut().zip(NO_REBOUND) {
                *steps = if then.closing.abs() < part * self.speed { *steps + 1 } else { 0 };
            }
            if slow[0] > STEPS_WITHOUT_REBOUND {
                break;
            }
        }
        if slow[1] <= STEPS_WITHOUT_REBOUND {
            return Err(ImpactError::EndlessContact { time: time * self.depth / self.speed });
        }
        let at = self.instant(&y, &mut sampler.pose).ok_or_else(lost)?;
        let found = self.result(sampler, time, &y, deepest.unwrap_or((at.penetration, None)));
        Ok(ImpactInTime { restitution: 0.0, separates: false, ..found })
    }

    /// True if a state is at or beyond the end of the contact: the sides separate, and the force or the penetration is not positive.
    fn is_end(&self, at: &Instant) -> bool {
        at.closing < 0.0 && self.remaining(at) <= 0.0
    }

    /// Result at the end of the contact. `time`: scaled time of the last sample; the tuple: scaled state at the end, its values, and the
    /// scaled time since the last sample.
    fn finish(
        &self,
        mut sampler: Sampler,
        time: f64,
        (end, at, taken): (Vec<f64>, Instant, f64),
        deepest: Option<(f64, Option<f64>)>,
    ) -> Result<ImpactInTime, ImpactError> {
        let time = time + taken;
        let mut rate = vec![0.0; end.len()];
        self.derivative(&end, &mut rate);
        sampler.add(self, time, &at, &rate);
        let found = self.result(sampler, time, &end, deepest.unwrap_or((at.penetration, None)));
        // A search for a damping has no samples within the steps, and no motion after the contact.
        let is_watched = self.conditions.samples_within_steps > 0;
        let second_touch = if is_watched { self.second_touch(&end, WATCHED * time) } else { None };
        Ok(ImpactInTime { restitution: -at.closing / self.speed, second_touch, ..found })
    }

    /// Result with the restitution 0 at the scaled state `end`.
    fn result(
        &self,
        sampler: Sampler,
        time: f64,
        end: &[f64],
        (max_penetration, mass_at_max_penetration): (f64, Option<f64>),
    ) -> ImpactInTime {
        let works = end.len() - 2;
        let energy = EnergyBalance {
            kinetic_before: self.kinetic_energy(&self.initial),
            kinetic_after: self.kinetic_energy(end),
            taken_by_contact: self.work * end[works],
            work_of_other_forces: self.work * end[works + 1],
        };
        ImpactInTime {
            restitution: 0.0,
            duration: time * self.depth / self.speed,
            separates: true,
            max_penetration,
            peak_force: sampler.peak_force(self),
            mass_at_max_penetration,
            energy,
            second_touch: None,
            samples: sampler.samples,
        }
    }

    /// Kinetic energy at a scaled state, with a free body on the other side, J; 0 if the contact does not exist there.
    fn kinetic_energy(&self, y: &[f64]) -> f64 {
        let mut pose = self.start.clone();
        let Some(at) = self.instant(y, &mut pose) else { return 0.0 };
        let rates = DVector::from_vec(at.rates);
        let own = 0.5 * rates.dot(&(pose.mass_matrix() * &rates));
        let other = self.speed * y[y.len() - 3];
        own + self.conditions.other_mass.map_or(0.0, |mass| 0.5 * mass * other * other)
    }
}

/// The larger of two penetrations, with its m̄.
fn deeper(a: Option<(f64, Option<f64>)>, b: Option<(f64, Option<f64>)>) -> Option<(f64, Option<f64>)> {
    [a, b].into_iter().flatten().max_by(|a, b| a.0.total_cmp(&b.0))
}

/// True if two scaled states differ by at most the error of a step.
fn are_close(a: &[f64], b: &[f64]) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= TIME_STEP_ERROR * (1.0 + b.abs()))
}

/// Samples of an impact, with reused buffers.
struct Sampler {
    /// Pose of the sample.
    pose: Pose,
    map: ReactionMap,
    buffers: ReactionBuffers,
    masses: Workspace,
    samples: Vec<ImpactSample>,
    /// Largest force within the steps, N.
    peak: f64,
}

impl Sampler {
    fn new(motion: &Motion) -> Self {
        let pose = motion.start.clone();
        let (map, masses) = (ReactionMap::new(&pose), pose.assembly().workspace());
        Self { pose, map, buffers: ReactionBuffers::default(), masses, samples: Vec::new(), peak: 0.0 }
    }

    /// Adds a sample at the current pose. `time`: scaled time; `rate`: derivative of the scaled state by scaled time.
    fn add(&mut self, motion: &Motion, time: f64, at: &Instant, rate: &[f64]) {
        let pose = &self.pose;
        let gravity = motion.gravity(pose);
        let unit = motion.rate * motion.speed / motion.depth;
        let first = motion.start.positions().len() + BASE;
        let scaled = rate[first..].iter().zip(&motion.lengths);
        let change: Vec<f64> = scaled.map(|(scaled, length)| scaled * unit / length).collect();
        self.map.update(pose);
        self.map.apply_springs(pose, &motion.springs, &at.rates);
        let (motion_of, buffers, mut reactions) =
            ((&at.rates[..], &change[..]), &mut self.buffers, Reactions::none());
        self.map.reactions_in_motion(
            pose,
            &at.contact,
            at.force,
            motion_of,
            &gravity,
            buffers,
            &mut reactions,
        );
        let effective_mass = self.effective_mass(motion.contact);
        let pose = &self.pose;
        self.samples.push(ImpactSample {
            time: time * motion.depth / motion.speed,
            penetration: at.penetration,
            rate: at.closing,
            force: at.force,
            effective_mass,
            loop_gap: pose.loops().map_or(0.0, |loops| loops.residual),
            reactions,
            positions: pose.positions().to_vec(),
            base: *pose.base(),
            rates: rates_of(pose, &at.rates),
        });
    }

    /// Adds the samples within a step that starts at the scaled time `time` and has the scaled duration `h`. `states`: state at a scaled
    /// time after the start of the step.
    fn add_within(&mut self, motion: &Motion, time: f64, h: f64, states: &dyn Fn(f64) -> Vec<f64>) {
        let count = motion.conditions.samples_within_steps;
        if count == 0 {
            return;
        }
        let end = self.pose.clone();
        self.find_peak(motion, h, states);
        for k in 1..=count {
            let part = h * k as f64 / (count + 1) as f64;
            let state = states(part);
            let Some(at) = motion.instant(&state, &mut self.pose) else { continue };
            let mut rate = vec![0.0; state.len()];
            motion.derivative(&state, &mut rate);
            self.add(motion, time + part, &at, &rate);
        }
        self.pose = end;
    }

    /// Raises the largest force by golden sections within a step, about the largest of the forces at its samples.
    fn find_peak(&mut self, motion: &Motion, h: f64, states: &dyn Fn(f64) -> Vec<f64>) {
        let parts = motion.conditions.samples_within_steps + 1;
        let pose = &mut self.pose;
        let mut force = |part: f64| motion.instant(&states(part), pose).map_or(0.0, |at| at.force);
        let place = |k: usize| h * k as f64 / parts as f64;
        // The last sample is the start of the step.
        let start = self.samples.last().map_or(0.0, |sample| sample.force);
        let grid: Vec<f64> = (0..=parts).map(|k| if k == 0 { start } else { force(place(k)) }).collect();
        let top = (0..=parts).max_by(|&a, &b| grid[a].total_cmp(&grid[b])).unwrap_or(0);
        let mut peak = self.peak.max(grid[top]);
        if grid[top] >= NEAR_PEAK * self.peak {
            let (mut from, mut to) = (place(top.saturating_sub(1)), place((top + 1).min(parts)));
            while to - from > PEAK_PLACE * h {
                let width = GOLDEN * (to - from);
                let (low, high) = (force(to - width), force(from + width));
                (from, to) = if low > high { (from, from + width) } else { (to - width, to) };
                peak = peak.max(low).max(high);
            }
        }
        self.peak = peak;
    }

    /// Largest force of the contact.
    fn peak_force(&self, motion: &Motion) -> f64 {
        let largest = self.samples.iter().max_by(|a, b| a.force.total_cmp(&b.force));
        if motion.conditions.samples_within_steps > 0 {
            return largest.map_or(0.0, |sample| sample.force.max(self.peak));
        }
        let is_corner = |sample: &&ImpactSample| {
            let near = |x: &f64| (x - sample.penetration).abs() <= CORNER_DISTANCE * motion.depth;
            motion.conditions.corners.iter().any(near)
        };
        // No parabola across a point of the force curve.
        if let Some(sample) = largest.filter(is_corner) {
            return sample.force;
        }
        let times: Vec<f64> = self.samples.iter().map(|sample| sample.time).collect();
        let forces: Vec<f64> = self.samples.iter().map(|sample| sample.force).collect();
        peak_over_time(&times, &forces).map_or(0.0, |(force, _)| force)
    }

    /// m̄ at the pose; `None` if it is not finite.
    fn effective_mass(&mut self, contact: &Contact) -> Option<f64> {
        // The compiled kernel of the workspace is several times as fast as the recursion at a pose.
        let masses = &mut self.masses;
        let is_set =
            masses.set_positions(self.pose.positions()).is_ok() && masses.set_base(self.pose.base()).is_ok();
        match masses.effective_mass(contact) {
            Ok(mass) if is_set => mass.kilograms(),
            _ => finite_mass(&self.pose, contact),
        }
    }
}

/// m̄ at a pose; `None` if it is not finite.
pub(super) fn finite_mass(pose: &Pose, contact: &Contact) -> Option<f64> {
    pose.respond(contact).ok()?.effective_mass.kilograms()
}
