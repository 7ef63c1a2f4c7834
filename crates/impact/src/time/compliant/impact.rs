//! Impact in time of a mechanism with elastic bushes and gears.

use super::flow::{Flow, Law, Scales};
use super::forces::{ElementForce, ElementLaw, elements};
use super::peaks::{Quantity, Trace, peak};
use crate::error::ImpactError;
use crate::motion::joint_rates::JointRates;
use crate::time::conditions::TimeConditions;
use nalgebra::DVector;
use percuss_dynamics::{
    ElasticDirection, ElasticInput, ElasticMotion, ElasticSystem, JointForce, LinearElement, Load,
    LocatedContact, Pose,
};
use percuss_mechanism::JointId;
use std::f64::consts::PI;

/// Angle of the highest natural mode in a step: the samples are half as far apart.
const STEP_ANGLE: f64 = 0.4;
/// Least and largest number of steps in the duration of the contact of the rigid mechanism.
const STEPS: [f64; 2] = [200.0, 20_000.0];
/// Levels of halving of the first step: massless motions with damping can decay fast.
const FIRST_LEVEL: usize = 12;
/// Largest level of halving for forces that are not linear, at a corner of a curve.
const LAST_LEVEL: usize = 24;
/// Levels of halving that locate the end of the contact.
const END_LEVELS: usize = 28;
/// Error of a step with forces that are not linear, relative to the closing speed and the rigid contact.
const STEP_ERROR: f64 = 1e-11;
/// Ratio of the errors of two levels.
const ERROR_RATIO: f64 = 256.0;
/// Longest contact, in durations of the contact of the rigid mechanism.
const LONGEST: f64 = 20.0;
/// Part of the closing speed below which a contact that stays so slow for the duration of a rigid contact does not rebound.
const NO_REBOUND: f64 = 1e-3;
/// Restitution below which a contact only grazes its end: its duration is uncertain.
const GRAZING: f64 = 0.02;
/// Largest number of samples in the result.
const MOST_SAMPLES: usize = 500;

/// Law of the contact of a [`compliant_impact`].
#[derive(Clone, Copy)]
pub struct CompliantLaw<'a> {
    /// Stiffness (N/m) and damping (N·s/m) of the linear law, or of a linear law near the one of `force`: above 0.
    pub linear: [f64; 2],
    /// Force (N) over the penetration (m) and its rate (m/s); `None`: the linear law.
    pub force: Option<&'a dyn Fn(f64, f64) -> f64>,
}

/// End of the contact of a compliant impact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContactEnd {
    /// The sides separate.
    Separates,
    /// The sides separate at less than a fiftieth of the closing speed: the duration depends on details of the contact.
    Grazes,
    /// The sides do not separate.
    NoRebound,
}

/// Second touch after the separation, caused by the vibration of the mechanism.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SecondHit {
    /// Time since the first touch, s.
    pub time: f64,
    /// Closing speed, m/s.
    pub speed: f64,
}

/// Largest force of a row of a bush, of a spring, a damper, a support, a gear or an ideal joint.
#[derive(Clone, Debug, PartialEq)]
pub struct ElementPeak {
    /// Name of the bush, element or joint.
    pub element: String,
    /// Direction in the bush; `None` for the magnitude of the three forces of a bush or a joint.
    pub direction: Option<ElasticDirection>,
    /// Number of the element: lines, joint springs and supports of the conditions, then gears; `None` for a bush or a joint.
    pub number: Option<usize>,
    /// True for a moment in N·m.
    pub is_moment: bool,
    /// Largest magnitude until the end of the contact, N or N·m.
    pub force: f64,
    /// Its time, s.
    pub time: f64,
    /// Largest magnitude after the contact, for as long as the contact lasted or until the second touch, N or N·m; `None` without an end.
    pub force_after: Option<f64>,
}

/// Energies of a compliant impact, J.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CompliantEnergy {
    /// Kinetic energy at the touch.
    pub kinetic_before: f64,
    /// Kinetic energy at the end of the contact, vibrations included.
    pub kinetic_after: f64,
    /// Energy that bushes, springs and gears store at the end.
    pub stored: f64,
    /// Energy that bushes, dampers and gears take.
    pub dissipated: f64,
    /// Work that the contact takes.
    pub taken_by_contact: f64,
    /// Work of gravity, preloads, drives and curves.
    pub work_of_other_forces: f64,
}

impl CompliantEnergy {
    /// Error of the balance, J.
    pub fn residual(self) -> f64 {
        self.kinetic_after + self.stored + self.dissipated + self.taken_by_contact
            - self.kinetic_before
            - self.work_of_other_forces
    }
}

/// State at one time.
#[derive(Clone, Debug, PartialEq)]
pub struct CompliantSample {
    /// Time since the touch, s.
    pub time: f64,
    /// Penetration, m.
    pub penetration: f64,
    /// Closing speed, m/s.
    pub rate: f64,
    /// Force of the contact, N.
    pub force: f64,
    /// Forces of the elements, in the order of [`CompliantImpact::elements`], N or N·m.
    pub elements: Vec<f64>,
}

/// Impact in time of a mechanism with elastic bushes and gears, from the touch to the separation.
#[derive(Clone, Debug)]
pub struct CompliantImpact {
    /// Separation speed divided by closing speed; 0 without rebound.
    pub restitution: f64,
    /// End of the contact.
    pub end: ContactEnd,
    /// Duration of the contact, s; time reached without rebound.
    pub duration: f64,
    /// Largest penetration, m.
    pub max_penetration: f64,
    /// Largest force, N.
    pub peak_force: f64,
    /// Impulse P of the contact, N·s.
    pub impulse: f64,
    /// m_imp = P/(v⁻ + v⁺), kg: mass of a free body with this impulse, between the closing and the separation speed.
    pub impulse_mass: f64,
    /// Frequency of the dampers in place of loss factors, rad/s: c = ηk/ω.
    pub loss_frequency: f64,
    /// Energies.
    pub energy: CompliantEnergy,
    /// Largest forces of bushes, elements and gears.
    pub elements: Vec<ElementPeak>,
    /// Second touch, if there is one within the duration of the first contact.
    pub second_hit: Option<SecondHit>,
    /// Samples.
    pub samples: Vec<CompliantSample>,
}

/// Impact in time with elastic bushes and gears, linear about the touch: small displacements, no geometric stiffness (with it:
/// [`compliant_impact_with_forces`]).
///
/// ```text
/// M z̈ + C ż + K z = −jᵀF(δ, δ̇) + other forces,   ż(0): the motion of the rigid mechanism before the impact
/// ```
///
/// A linear contact is exact (exponential of the matrix of first order); a contact law, a damper curve or a support that is not linear is a force
/// polynomial within steps of controlled error. `gears`: elements with [`ElementMotion::Gear`](percuss_dynamics::ElementMotion::Gear);
/// `before`: rates before the impact; springs, dampers, drives, supports and gravity are those of `conditions`.
///
/// # Errors
/// [`ImpactError`]: those of [`ElasticSystem::new`]; a contact without mass; numbers of springs out of range.
pub fn compliant_impact(
    pose: &Pose,
    contact: &LocatedContact,
    (closing_speed, before): (f64, &JointRates),
    law: CompliantLaw<'_>,
    gears: &[LinearElement],
    conditions: &TimeConditions,
) -> Result<CompliantImpact, ImpactError> {
    impact_of_elements(pose, contact, (closing_speed, before), law, gears, conditions, None)
}

/// Forces at the touch that are in balance, and whose change of direction acts as the geometric stiffness G.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ForcesAtTouch {
    /// Force of each element of the conditions along its motion, N or N·m: lines, joints, then supports. A compressed spring has a positive force.
    pub elements: Vec<f64>,
    /// Loads, such as vertical forces on the wheels.
    pub loads: Vec<Load>,
    /// Joints with one velocity whose drives carry the rest, such as a steering rack.
    pub held: Vec<JointId>,
}

/// Same as [`compliant_impact`], with the geometric stiffness of forces at the touch:
/// [`ElasticSystem::with_geometric_stiffness`]. The result is without forces of ideal joints.
///
/// # Errors
/// Those of [`compliant_impact`]; forces that are not in balance; an unstable equilibrium.
pub fn compliant_impact_with_forces(
    pose: &Pose,
    contact: &LocatedContact,
    motion: (f64, &JointRates),
    law: CompliantLaw<'_>,
    gears: &[LinearElement],
    conditions: &TimeConditions,
    forces: &ForcesAtTouch,
) -> Result<CompliantImpact, ImpactError> {
    impact_of_elements(pose, contact, motion, law, gears, conditions, Some(forces))
}

/// Impact with springs, dampers, drives, supports and gears. `at_touch`: forces with geometric stiffness.
fn impact_of_elements(
    pose: &Pose,
    contact: &LocatedContact,
    (closing_speed, before): (f64, &JointRates),
    law: CompliantLaw<'_>,
    gears: &[LinearElement],
    conditions: &TimeConditions,
    at_touch: Option<&ForcesAtTouch>,
) -> Result<CompliantImpact, ImpactError> {
    let (mut linear, forces): (Vec<LinearElement>, Vec<ElementForce>) =
        elements(pose, conditions)?.into_iter().unzip();
    let of_elements = at_touch.iter().flat_map(|at_touch| &at_touch.elements);
    linear.iter_mut().zip(of_elements).for_each(|(element, force)| element.force = *force);
    let all: Vec<LinearElement> = linear.into_iter().chain(gears.iter().cloned()).collect();
    let mut system = ElasticSystem::new(pose, contact, &all, conditions.other_mass)?;
    if let Some(at_touch) = at_touch {
        system = system.with_geometric_stiffness(&at_touch.loads, &at_touch.held)?;
    }
    let masses = system.residual()?;
    let mass = masses.rigid.kilograms().or(masses.free.kilograms()).ok_or(ImpactError::MasslessContact)?;
    let start = system.rigid_velocities(pose, &before.coordinates(pose), closing_speed);
    let start = start.ok_or(ImpactError::MasslessContact)?;
    let frequency = (law.linear[0] / mass).sqrt();
    let problem = Problem {
        system: &system,
        law,
        forces: &forces,
        gravity: pose.base().inverse_vector(&conditions.gravity),
        scales: Scales { frequency, mass, speed: closing_speed },
        ends_without_force: conditions.ends_without_force,
        has_joints: at_touch.is_none(),
    };
    let found = problem.solve(&start, false)?;
    // A support that leaves the ground is not linear.
    match found {
        Some(found) => Ok(found),
        None => problem.solve(&start, true)?.ok_or(ImpactError::MasslessContact),
    }
}

/// Impact of a mechanism with elastic bushes and gears on a linear contact of stiffness k (N/m) and damping c (N·s/m), as in
/// [`compliant_impact`], from the rigid motion of least energy at a closing speed (m/s).
///
/// # Errors
/// [`ImpactError`]: a contact without mass, or one that the rigid mechanism does not close.
pub fn compliant_impact_of(
    system: &ElasticSystem,
    law: [f64; 2],
    closing_speed: f64,
) -> Result<CompliantImpact, ImpactError> {
    let masses = system.residual()?;
    let motion = masses.rigid_motion.ok_or(ImpactError::Immovable)?;
    let mass = masses.rigid.kilograms().ok_or(ImpactError::MasslessContact)?;
    let problem = Problem {
        system,
        law: CompliantLaw { linear: law, force: None },
        forces: &[],
        gravity: nalgebra::Vector3::zeros(),
        scales: Scales { frequency: (law[0] / mass).sqrt(), mass, speed: closing_speed },
        ends_without_force: true,
        has_joints: false,
    };
    problem.solve(&(motion * closing_speed), true)?.ok_or(ImpactError::MasslessContact)
}

/// Contact, forces and scales of a compliant impact.
struct Problem<'a> {
    system: &'a ElasticSystem,
    law: CompliantLaw<'a>,
    forces: &'a [ElementForce],
    gravity: nalgebra::Vector3<f64>,
    scales: Scales,
    ends_without_force: bool,
    /// True for the forces of the ideal joints.
    has_joints: bool,
}

impl<'a> Problem<'a> {
    /// Inputs with their constant values: the contact, the elements with further forces, gravity.
    fn inputs(&self) -> (Vec<ElasticInput>, DVector<f64>) {
        let mut inputs = vec![ElasticInput::Contact];
        let mut constants = vec![0.0];
        for (number, force) in self.forces.iter().enumerate() {
            if force.constant != 0.0 || force.law.force().is_some() {
                inputs.push(ElasticInput::Element(number));
                constants.push(force.constant);
            }
        }
        if self.gravity.norm() > 0.0 {
            inputs.push(ElasticInput::Gravity(self.gravity));
            constants.push(1.0);
        }
        (inputs, DVector::from_vec(constants))
    }

    /// Motion and its flow. `in_contact`: with the contact; `supports_leave`: supports never pull.
    fn flow(
        &self,
        in_contact: bool,
        supports_leave: bool,
    ) -> Result<(ElasticMotion, Vec<JointForce>, Flow<'a>), ImpactError> {
        let (inputs, constants) = self.inputs();
        let contact = if in_contact { self.law.linear } else { [0.0; 2] };
        let motion = self.system.motion(contact, &inputs, self.scales.frequency)?;
        let motion = motion.ok_or(ImpactError::MasslessContact)?;
        let mut laws: Vec<(usize, Option<usize>, Law<'a>)> = Vec::new();
        if let Some(force) = self.law.force.filter(|_| in_contact) {
            let [k, c] = self.law.linear;
            laws.push((0, None, Box::new(move |x, v| force(x, v) - k * x - c * v)));
        }
        for (number, force) in self.forces.iter().enumerate() {
            let input = inputs.iter().position(|input| *input == ElasticInput::Element(number));
            let row = motion.rows.iter().position(|row| row.number == Some(number));
            let is_linear = matches!(force.law, ElementLaw::Support(_)) && !supports_leave;
            if let (Some(law), Some(input), Some(row)) = (force.law.force(), input, row)
                && !is_linear
            {
                laws.push((input, Some(row), law));
            }
        }
        let duration = PI / self.scales.frequency;
        let steps = duration * motion.highest_frequency / STEP_ANGLE;
        let step = duration / steps.clamp(STEPS[0], STEPS[1]);
        let joints =
            if self.has_joints { self.system.joint_forces(&motion, contact, &inputs) } else { Vec::new() };
        let flow = Flow::new(&motion, &constants, laws, contact, (self.scales, step), &joints);
        Ok((motion, joints, flow))
    }

    /// Impact; `None` if a support would pull and `supports_leave` is false.
    fn solve(
        &self,
        start: &DVector<f64>,
        supports_leave: bool,
    ) -> Result<Option<CompliantImpact>, ImpactError> {
        let Scales { frequency, speed, .. } = self.scales;
        let (motion, joints, mut flow) = self.flow(true, supports_leave)?;
        let duration = PI / frequency;
        let by_force = self.ends_without_force;
        let is_end = |flow: &Flow, state: &DVector<f64>, forces: &DVector<f64>, _: f64| {
            let (x, rate) = flow.contact.at(state, forces);
            rate < 0.0 && (x <= 0.0 || by_force && flow.contact_force(state, forces) <= 0.0)
        };
        let first = flow.scaled(&motion.start(start));
        let mut fast = 0.0;
        let gives_up = |flow: &Flow, trace: &Trace| {
            let (Some(state), Some(forces)) = (trace.states.last(), trace.forces.last()) else { return true };
            let time = trace.times[trace.times.len() - 1];
            if flow.contact.at(state, forces).1.abs() >= NO_REBOUND * speed {
                fast = time;
            }
            time > LONGEST * duration || time > fast + duration
        };
        let (trace, ends) = follow(&mut flow, first, 0.0, &is_end, gives_up);
        if !supports_leave && self.is_lifted(&motion, &flow, &trace) {
            return Ok(None);
        }
        let (inputs, _) = self.inputs();
        let input_of = |number: usize| inputs.iter().position(|x| *x == ElasticInput::Element(number));
        let quantities = Quantity::all(&motion, &joints, input_of);
        let contact_force = |flow: &Flow, y: &DVector<f64>, u: &DVector<f64>| flow.contact_force(y, u);
        let depth = |flow: &Flow, y: &DVector<f64>, u: &DVector<f64>| flow.contact.at(y, u).0.max(0.0);
        let (peak_force, max_penetration) =
            (peak(&mut flow, &trace, contact_force).0, peak(&mut flow, &trace, depth).0);
        let mut elements: Vec<ElementPeak> = Vec::new();
        for quantity in &quantities {
            let (force, time) = peak(&mut flow, &trace, |flow, y, u| quantity.at(flow, y, u));
            elements.push(ElementPeak {
                element: quantity.element.clone(),
                direction: quantity.direction,
                number: quantity.number,
                is_moment: quantity.is_moment,
                force,
                time,
                force_after: None,
            });
        }
        let last = trace.times.len() - 1;
        let (state, forces, end_time) = (&trace.states[last], &trace.forces[last], trace.times[last]);
        let (x, rate) = flow.contact.at(state, forces);
        let impulse = flow.impulse(state);
        let mut second_hit = None;
        if ends {
            let (after, joints, mut free) = self.flow(false, true)?;
            let begin = after.continued(&motion, &flow.unscaled(state), &flow.inputs(forces));
            let begin = free.scaled(&begin);
            let [k, c] = self.law.linear;
            let surface = |time: f64| match x > 0.0 && c > 0.0 {
                true => x * (-k / c * (time - end_time)).exp(),
                false => 0.0,
            };
            let touches = |flow: &Flow, y: &DVector<f64>, u: &DVector<f64>, time: f64| {
                let (x, rate) = flow.contact.at(y, u);
                rate > 0.0 && x >= surface(time)
            };
            let gives_up = |_: &Flow, trace: &Trace| trace.times[trace.times.len() - 1] >= 2.0 * end_time;
            let (later, hits) = follow(&mut free, begin, end_time, &touches, gives_up);
            let quantities = Quantity::all(&after, &joints, input_of);
            for (element, quantity) in elements.iter_mut().zip(&quantities) {
                let found = peak(&mut free, &later, |flow, y, u| quantity.at(flow, y, u));
                element.force_after = Some(found.0);
            }
            if hits {
                let last = later.times.len() - 1;
                let (_, speed) = free.contact.at(&later.states[last], &later.forces[last]);
                second_hit = Some(SecondHit { time: later.times[last], speed });
            }
        }
        let restitution = if ends { -rate / speed } else { 0.0 };
        let end = match ends {
            false => ContactEnd::NoRebound,
            true if restitution < GRAZING => ContactEnd::Grazes,
            true => ContactEnd::Separates,
        };
        Ok(Some(CompliantImpact {
            restitution,
            end,
            duration: end_time,
            max_penetration,
            peak_force,
            impulse,
            impulse_mass: impulse / (speed - rate),
            loss_frequency: frequency,
            energy: energy(&motion, &flow, &trace),
            samples: samples(&flow, &trace, &quantities),
            elements,
            second_hit,
        }))
    }

    /// True if a support pulls at a sample.
    fn is_lifted(&self, motion: &ElasticMotion, flow: &Flow, trace: &Trace) -> bool {
        self.forces.iter().enumerate().any(|(number, force)| {
            let ElementLaw::Support(support) = &force.law else { return false };
            let row = motion.rows.iter().position(|row| row.number == Some(number));
            row.is_some_and(|row| {
                let pull = |y: &DVector<f64>, u: &DVector<f64>| {
                    let (x, v) = flow.rows[row].at(y, u);
                    ElementLaw::pull(support, x, v)
                };
                trace.values(pull).into_iter().any(|pull| pull < 0.0)
            })
        })
    }
}

/// True at the end of a motion: flow, scaled state, forces that are not linear, time.
type EndTest<'t> = dyn Fn(&Flow, &DVector<f64>, &DVector<f64>, f64) -> bool + 't;

/// Follows a motion from a scaled state at a time until `is_end` is true or `gives_up`; true in the first case, with the end as the last sample.
fn follow(
    flow: &mut Flow,
    start: DVector<f64>,
    time: f64,
    is_end: &EndTest,
    mut gives_up: impl FnMut(&Flow, &Trace) -> bool,
) -> (Trace, bool) {
    let mut trace = Trace::default();
    trace.add(flow, time, 0, start);
    let (mut level, mut first) = (0, FIRST_LEVEL);
    let has_laws = !flow.laws.is_empty();
    loop {
        let last = trace.times.len() - 1;
        let (time, state) = (trace.times[last], trace.states[last].clone());
        let halved = level.max(first) + 1;
        let middle = flow.advance(&state, halved);
        let end = flow.advance(&middle, halved);
        if has_laws {
            let error = (flow.advance(&state, halved - 1) - &end).amax();
            let is_exact = error <= STEP_ERROR;
            if !is_exact && halved <= LAST_LEVEL {
                level = halved;
                continue;
            }
            if error * ERROR_RATIO < STEP_ERROR {
                level = level.saturating_sub(1);
            }
        }
        first = first.saturating_sub(1);
        let part = flow.step_of(halved);
        for (count, next) in [(1.0, middle), (2.0, end)] {
            let at = time + count * part;
            let forces = flow.forces(&next);
            if is_end(flow, &next, &forces, at) {
                let last = trace.times.len() - 1;
                let (mut at, mut state) = (trace.times[last], trace.states[last].clone());
                for finer in halved + 1..=halved + END_LEVELS {
                    let next = flow.advance(&state, finer);
                    let later = at + flow.step_of(finer);
                    if !is_end(flow, &next, &flow.forces(&next), later) {
                        (at, state) = (later, next);
                    }
                }
                trace.add(flow, at, halved, state);
                return (trace, true);
            }
            trace.add(flow, at, halved, next);
        }
        if gives_up(flow, &trace) {
            return (trace, false);
        }
    }
}

/// Energies over a trace, by Simpson's rule.
fn energy(motion: &ElasticMotion, flow: &Flow, trace: &Trace) -> CompliantEnergy {
    let last = trace.times.len() - 1;
    let powers = |k: usize| {
        let (state, forces) = (&trace.states[k], &trace.forces[k]);
        let damped = motion
            .rows
            .iter()
            .zip(&flow.rows)
            .map(|(row, line)| row.damping * line.at(state, forces).1.powi(2));
        let inputs = flow.inputs(forces);
        // The first input is the contact.
        let applied = flow.applied.iter().enumerate().skip(1);
        let others = applied.map(|(i, (line, _))| inputs[i] * line.at(state, forces).1);
        let rate = flow.contact.at(state, forces).1;
        [flow.contact_force(state, forces) * rate, damped.sum(), others.sum::<f64>()]
    };
    let all: Vec<[f64; 3]> = (0..=last).map(powers).collect();
    let mut works = [0.0; 3];
    let mut add = |weight: f64, k: usize| (0..3).for_each(|i| works[i] += weight * all[k][i]);
    let mut k = 0;
    while k < last {
        let step = trace.times[k + 1] - trace.times[k];
        let next = trace.times.get(k + 2).map(|time| time - trace.times[k + 1]);
        if next.is_some_and(|next| (next - step).abs() <= 1e-6 * step) {
            [(1.0, k), (4.0, k + 1), (1.0, k + 2)].into_iter().for_each(|(w, at)| add(w * step / 3.0, at));
            k += 2;
        } else {
            [k, k + 1].into_iter().for_each(|at| add(0.5 * step, at));
            k += 1;
        }
    }
    let stored = |k: usize| {
        let (state, forces) = (&trace.states[k], &trace.forces[k]);
        let rows = motion.rows.iter().zip(&flow.rows);
        rows.map(|(row, line)| 0.5 * row.stiffness * line.at(state, forces).0.powi(2)).sum::<f64>()
    };
    let kinetic = |k: usize| motion.kinetic_energy(&flow.unscaled(&trace.states[k]));
    CompliantEnergy {
        kinetic_before: kinetic(0),
        kinetic_after: kinetic(last),
        stored: stored(last),
        taken_by_contact: works[0],
        dissipated: works[1],
        work_of_other_forces: works[2],
    }
}

/// Samples of the result: equally spread numbers of the trace.
fn samples(flow: &Flow, trace: &Trace, quantities: &[Quantity]) -> Vec<CompliantSample> {
    let last = trace.times.len() - 1;
    let stride = last.div_ceil(MOST_SAMPLES).max(1);
    let sample = |k: usize| {
        let (state, forces) = (&trace.states[k], &trace.forces[k]);
        let (penetration, rate) = flow.contact.at(state, forces);
        CompliantSample {
            time: trace.times[k],
            penetration,
            rate,
            force: flow.contact_force(state, forces),
            elements: quantities.iter().map(|quantity| quantity.at(flow, state, forces)).collect(),
        }
    };
    (0..last).step_by(stride).chain([last]).map(sample).collect()
}
