//! Impact in time against a compliant contact.

use crate::error::ImpactError;
use crate::motion::joint_rates::JointRates;
use crate::numerics::extrapolation::state_after;
use crate::time::conditions::{TimeConditions, refuse_grounded_base, spring_forces, stopping_depth};
use crate::time::history::{EnergyBalance, ImpactInTime};
use crate::time::motion::{Instant, Motion, finite_mass};
use crate::time::sampler::Sampler;
use crate::tolerances::{MOST_TIME_STEPS, NO_REBOUND, STEPS_WITHOUT_REBOUND, TIME_STEP_ERROR};
use percuss_dynamics::{Contact, EffectiveMass, Pose};

/// Time after the contact in which a second touch is searched, over the duration of the contact.
const WATCHED: f64 = 3.0;

/// Impact of any mechanism in time: equations of motion with the force F(δ, δ̇) of a compliant contact, δ̇ = j u.
///
/// `before`: admissible rates before the impact; `closing_speed` is their closing speed, with a free body on the other side the
/// difference of both speeds. `force`: F over penetration (m) and closing speed (m/s), N. Trees and loops, redundant constraints,
/// fixed and floating bases; m̄, normal and contact row follow the pose. Without friction.
///
/// The accelerations have a closed form at each pose. The integration uses a predictor and corrector of order 10, started by
/// extrapolation, with an error of 1e-12 per step, relative to the penetration and the largest rate. The gaps of the loops are not
/// corrected, so that [`loop_gap`](crate::ImpactSample::loop_gap) shows the error of the integration. Sources: Featherstone 2008,
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

impl Motion<'_> {
    fn run(&self) -> Result<ImpactInTime, ImpactError> {
        let f = |y: &[f64], out: &mut [f64]| self.derivative(y, out);
        let lost = || ImpactError::LostContact;
        let (mut y, mut time) = (self.initial.clone(), 0.0);
        let mut sampler = Sampler::new(self);
        let mut rate = vec![0.0; y.len()];
        f(&y, &mut rate);
        let at = self.take_instant(&mut sampler.pose).ok_or_else(lost)?;
        sampler.add(self, time, &at, (&y, &rate));
        let mut deepest: Option<(f64, Option<f64>)> = None;
        let (mut closing, mut penetration) = (at.closing, at.penetration);
        let mut integrator = self.integrator(rate);
        let (mut reversed, mut at_corner) = (sampler.pose.clone(), sampler.pose.clone());
        // Steps in a row with a speed below each of two parts of the closing speed: a step is a part of the time of a half oscillation.
        let mut slow = [0; 2];
        for _ in 0..MOST_TIME_STEPS {
            let (next, taken) = integrator.advance(&f, &y, &|| self.is_over.get());
            // The integrator evaluates the derivative at the next state last.
            let then = next.as_ref().and_then(|_| self.take_instant(&mut sampler.pose));
            let reversal = self.reversal(&y, taken, &mut reversed);
            let within = reversal.as_ref().map_or(taken, |(_, _, h)| *h);
            let passed = self.corner(&y, within, (penetration, closing), &mut at_corner);
            // The contact can end before the point within the same step.
            let passed = passed.filter(|(_, at, _)| !self.is_end(at));
            if let (None, Some((state, at, taken))) = (&passed, reversal) {
                let states = |h: f64| state_after(&f, &y, h, TIME_STEP_ERROR);
                std::mem::swap(&mut sampler.pose, &mut reversed);
                // Both ends of the jump are samples.
                sampler.add_within(self, time, taken, &states);
                time += taken;
                deepest = deeper(deepest, Some((at.penetration, finite_mass(&sampler.pose, self.contact))));
                let mut rate = vec![0.0; state.len()];
                f(&state, &mut rate);
                sampler.add(self, time, &at, (&state, &rate));
                self.is_closing.set(!self.is_closing.get());
                f(&state, &mut rate);
                let then = self.take_instant(&mut sampler.pose).ok_or_else(lost)?;
                sampler.add(self, time, &then, (&state, &rate));
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
                std::mem::swap(&mut sampler.pose, &mut at_corner);
                let states = |h: f64| state_after(&f, &y, h, TIME_STEP_ERROR);
                if closing > 0.0 && at.closing <= 0.0 {
                    deepest = deeper(deepest, self.turning_point(&y, taken, &states));
                }
                sampler.add_within(self, time, taken, &states);
                time += taken;
                let mut rate = vec![0.0; state.len()];
                f(&state, &mut rate);
                (y, closing, penetration) = (state, at.closing, at.penetration);
                sampler.add(self, time, &at, (&y, &rate));
                integrator = self.integrator(rate);
                continue;
            }
            let Some(next) = next else {
                // The contact ends within one step after y. The polynomial is compared with an extrapolation step, which replaces it if
                // the states differ.
                let single = |h: f64| state_after(&f, &y, h, TIME_STEP_ERROR);
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
            let then = then.filter(|at| at.closing.is_finite()).ok_or_else(lost)?;
            let single = |h: f64| state_after(&f, &y, h, TIME_STEP_ERROR);
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
            sampler.add(self, time, &then, (&y, integrator.rate()));
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
        sampler.add(self, time, &at, (&end, &rate));
        let found = self.result(sampler, time, &end, deepest.unwrap_or((at.penetration, None)));
        // A search for a damping has no samples within the steps, and no motion after the contact.
        let is_watched = self.conditions.samples_within_steps > 0;
        let second_touch = if is_watched { self.second_touch(&end, WATCHED * time) } else { None };
        Ok(ImpactInTime { restitution: -at.closing / self.speed, second_touch, ..found })
    }

    /// Result with the restitution 0 at the scaled state `end`.
    fn result(
        &self,
        mut sampler: Sampler,
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
            bearing_peaks: sampler.bearing_peaks(self),
            mass_at_max_penetration,
            energy,
            second_touch: None,
            samples: sampler.samples,
        }
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
