//! Impact that a simulator computes with given parameters: the inverse of an export.

use crate::error::{LawParameter, not_negative, positive};
use crate::exports::linear::Linear;
use crate::exports::{ExportError, ImpactFunction, Options, Request, Tool};
use crate::stepping::{MOST_STEPS, STEPS, Stepping};
use crate::{CompliantContact, ContactLawError, Damper, Impact, Separation, StiffnessLaw, limits};
use std::f64::consts::PI;

/// Contact as a simulator integrates it, in the limit of small time steps. Implicit Euler adds the damping of its step.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum ContactModel<'a> {
    /// Spring and damper.
    Compliant(CompliantContact<'a>, Damper),
    /// Spring, and a damper that acts only during the approach.
    ApproachDamper(CompliantContact<'static>, Damper),
    /// Spring k xᵖ, and a damping that increases to c over the depth d (the function IMPACT of Adams).
    ImpactFunction {
        /// Effective mass and spring.
        contact: CompliantContact<'static>,
        /// c, N·s/m.
        damping: f64,
        /// d, m.
        depth: f64,
    },
    /// MuJoCo's spring and damper with an impedance.
    Impedance(Impedance),
    /// Newton's restitution.
    Rigid {
        /// Coefficient of restitution.
        restitution: f64,
        /// Approach speed below which there is no rebound, m/s.
        slowest: f64,
    },
}

/// Contact of MuJoCo: F = s(x) (b ẋ + κ d(x) x) m̄, not below 0, s = d/(d + (1−d)α). The impedance d(x) increases from d₀ to d_w over the width w
/// by two powers that meet at the midpoint; κ = ω²/d_w², b = 2ζω/d_w. Sources as in the facts of the tool (`mj_makeImpedance`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Impedance {
    /// m̄, kg.
    pub(in crate::exports) mass: f64,
    /// ω², 1/s², and 2ζω, 1/s.
    pub(in crate::exports) per_mass: [f64; 2],
    /// d₀, d_w, w (m), midpoint, power.
    pub(in crate::exports) solimp: [f64; 5],
    /// α.
    pub(in crate::exports) diagonal_ratio: f64,
}

impl Impedance {
    /// d at a penetration (m).
    fn at(&self, penetration: f64) -> f64 {
        let [first, last, width, middle, power] = self.solimp;
        let part = if width > 0.0 { (penetration.max(0.0) / width).min(1.0) } else { 1.0 };
        let rise = if power == 1.0 {
            part
        } else if part <= middle {
            middle * (part / middle).powf(power)
        } else {
            1.0 - (1.0 - middle) * ((1.0 - part) / (1.0 - middle)).powf(power)
        };
        first + rise * (last - first)
    }

    /// Force (N) at a penetration (m) and its rate (m/s).
    fn force(&self, penetration: f64, rate: f64) -> f64 {
        let (d, last) = (self.at(penetration), self.solimp[1]);
        let pull =
            self.per_mass[1] / last * rate + self.per_mass[0] / (last * last) * d * penetration.max(0.0);
        self.mass * (d / (d + (1.0 - d) * self.diagonal_ratio) * pull).max(0.0)
    }

    /// Linear contact if the impedance is constant.
    fn linear(&self) -> Result<Option<(CompliantContact<'static>, Damper)>, ContactLawError> {
        let [first, last, ..] = self.solimp;
        if first != last {
            return Ok(None);
        }
        let [stiffness, damping] =
            self.per_mass.map(|x| x * self.mass / (last + (1.0 - last) * self.diagonal_ratio));
        let contact = CompliantContact::new(self.mass, stiffness)?;
        let damper = Damper::kelvin_voigt_from_coefficient(contact, damping, Separation::ForceVanishes)?;
        Ok(Some((contact, damper)))
    }

    /// Impact at an approach speed (m/s), integrated with fixed steps for a variable impedance.
    fn impact(&self, speed: f64) -> Result<Impact, ContactLawError> {
        if let Some((contact, damper)) = self.linear()? {
            return damper.impact(contact, speed);
        }
        let force = |x: f64, v: f64| self.force(x, v);
        let stiffest = self.per_mass[0] / self.solimp[1].min(self.solimp[0]);
        // Half a period, and the decay of a strong damper.
        let step = PI / stiffest.sqrt().max(self.per_mass[1]) / STEPS;
        let motion = Stepping {
            force: &force,
            ends_at_zero_force: self.per_mass[1] > 0.0,
            jumps_at_reversal: false,
            corners: &self.solimp[2..3],
            step,
            speed,
            beside: &|_, _| 0.0,
            most_steps: MOST_STEPS,
        };
        Ok(motion.impact(self.mass))
    }

    /// Penetration (m) at rest under a force (N): κ d² x = (1−d) α F/m̄. The force acts on the row too, so it is not F/k.
    fn penetration_at_rest(&self, force: f64) -> f64 {
        let [first, last, width, ..] = self.solimp;
        let side = |d: f64| {
            (1.0 - d) / (d * d) * self.diagonal_ratio * force * last * last / self.mass / self.per_mass[0]
        };
        let (mut low, mut high) = (0.0, side(first.min(last)).max(width));
        for _ in 0..limits::MAX_SEARCH_STEPS {
            let middle = 0.5 * (low + high);
            *(if side(self.at(middle)) > middle { &mut low } else { &mut high }) = middle;
        }
        high
    }
}

/// Contact in one solver of a simulator.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SimulatedContact<'a> {
    /// Solver or mode of the tool, empty if there is only one.
    pub solver: &'static str,
    /// Law of the contact.
    pub model: ContactModel<'a>,
    step: Step,
}

/// Time step of a linear contact with a known error bound.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Step {
    Unknown,
    Explicit(f64),
    Implicit(f64),
}

/// Impact in a simulator.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SimulatedImpact {
    /// Rebound speed divided by approach speed.
    pub restitution: f64,
    /// Error bound of the restitution at the time step, for every start of the contact within a step. `None` if unknown.
    pub error_bound: Option<f64>,
    /// Duration of the contact, s. `None` for a rigid contact, for the function IMPACT, and for a gap that never closes.
    pub duration: Option<f64>,
    /// Largest penetration, m. `None` for a rigid contact.
    pub max_penetration: Option<f64>,
    /// Largest force, N. `None` for a rigid contact and for the function IMPACT.
    pub peak_force: Option<f64>,
    /// Lost energy ½ m̄ v² (1 − e²), J.
    pub energy_lost: f64,
}

impl<'a> SimulatedContact<'a> {
    /// Contact of the only solver, without an error bound.
    pub fn of(model: ContactModel<'a>) -> Self {
        Self { solver: "", model, step: Step::Unknown }
    }

    /// Contact of MuJoCo for a time step (s), if given. Error: a number out of range.
    pub(in crate::exports) fn of_impedance(row: Impedance, step: Option<f64>) -> Result<Self, ExportError> {
        row.linear()?;
        let step = step.map_or(Step::Unknown, Step::Explicit);
        Ok(Self { step, ..Self::of(ContactModel::Impedance(row)) })
    }

    /// Linear contact with the damping c (N·s/m) that ends when the force vanishes, for an explicit method with a time step (s), if given.
    pub(in crate::exports) fn explicit(
        given: &Given,
        stiffness: f64,
        damping: f64,
        step: Option<f64>,
    ) -> Result<Self, ExportError> {
        let (contact, damper) = given.linear(stiffness, damping, Separation::ForceVanishes)?;
        let step = step.map_or(Step::Unknown, Step::Explicit);
        Ok(Self { step, ..Self::of(ContactModel::Compliant(contact, damper)) })
    }

    /// As [`explicit`](Self::explicit) for implicit Euler, which adds h k to the damping.
    pub(in crate::exports) fn implicit(
        given: &Given,
        stiffness: f64,
        damping: f64,
        step: f64,
    ) -> Result<Self, ExportError> {
        let explicit = Self::explicit(given, stiffness, damping + step * stiffness, None)?;
        Ok(Self { step: Step::Implicit(step), ..explicit })
    }

    /// The same contact of a named solver.
    pub(in crate::exports) fn of_solver(self, solver: &'static str) -> Self {
        Self { solver, ..self }
    }

    /// Impact of the effective mass m̄ (kg) at an approach speed (m/s).
    ///
    /// Errors: a number is out of range; overflow; the contact of IMPACT does not end.
    pub fn impact(&self, mass: f64, speed: f64) -> Result<SimulatedImpact, ContactLawError> {
        let (mass, speed) = (positive(LawParameter::Mass, mass)?, positive(LawParameter::Speed, speed)?);
        let energy_lost = |e: f64| 0.5 * mass * speed * speed * (1.0 - e * e);
        let rigid = |restitution| SimulatedImpact {
            restitution,
            error_bound: None,
            duration: None,
            max_penetration: None,
            peak_force: None,
            energy_lost: energy_lost(restitution),
        };
        Ok(match self.model {
            ContactModel::Compliant(contact, damper) => {
                let impact = damper.impact(contact, speed)?;
                SimulatedImpact {
                    error_bound: self.error_bound(contact, impact.restitution),
                    duration: impact.duration,
                    max_penetration: Some(impact.max_penetration),
                    peak_force: Some(impact.peak_force),
                    ..rigid(impact.restitution)
                }
            }
            ContactModel::Impedance(row) => {
                let impact = row.impact(speed)?;
                let linear = row.linear()?;
                SimulatedImpact {
                    error_bound: linear
                        .and_then(|(contact, _)| self.error_bound(contact, impact.restitution)),
                    duration: impact.duration,
                    max_penetration: Some(impact.max_penetration),
                    peak_force: Some(impact.peak_force),
                    ..rigid(impact.restitution)
                }
            }
            ContactModel::ApproachDamper(contact, damper) => {
                // Approach as with the damper. Return on the spring alone: the speed ω x_m of the largest penetration x_m = (v/ω)√e_b, after
                // a quarter of a period.
                let approach = damper.impact(contact, speed)?;
                let (stiffness, _) = contact.power_law().unwrap_or((f64::NAN, 1.0));
                let frequency = (stiffness / contact.mass()).sqrt();
                let quarter = std::f64::consts::FRAC_PI_2 / frequency;
                SimulatedImpact {
                    duration: Some(approach.time_of_max_penetration + quarter),
                    max_penetration: Some(approach.max_penetration),
                    peak_force: Some(approach.peak_force),
                    ..rigid(approach.restitution.sqrt())
                }
            }
            ContactModel::ImpactFunction { contact, damping, depth } => {
                let (k, p) = contact.power_law().unwrap_or((f64::NAN, 1.0));
                let undamped = ImpactFunction::undamped_penetration(p, mass, k, speed)?;
                let function = ImpactFunction::new(p, depth / undamped)?;
                // k x₀ᵖ/v = (p+1)/2 · m̄ v/x₀.
                let number = damping * undamped / (0.5 * (p + 1.0) * mass * speed);
                SimulatedImpact {
                    max_penetration: Some(function.penetration(number)? * undamped),
                    error_bound: Some(limits::ADAMS_ERROR),
                    ..rigid(function.restitution(number)?)
                }
            }
            ContactModel::Rigid { restitution, slowest } => {
                rigid(if speed < slowest { 0.0 } else { restitution })
            }
        })
    }

    /// Error bound of the restitution of a linear contact at the time step.
    fn error_bound(&self, contact: CompliantContact, restitution: f64) -> Option<f64> {
        let options = Options::default();
        let linear =
            Linear::of(&Request { contact, restitution, speed: None, options }, Tool::MUJOCO).ok()?;
        match self.step {
            Step::Unknown => None,
            Step::Explicit(step) => Some(linear.error_bound(step)),
            Step::Implicit(step) => Some(linear.implicit_error_bound(step)),
        }
    }

    /// Penetration at rest under a force (N) along the normal: k xᵖ = F, m, or the first of a force curve. `None` for a rigid contact. Error: the
    /// force is negative, not finite, or beyond the curve.
    pub fn penetration_at_rest(&self, force: f64) -> Result<Option<f64>, ContactLawError> {
        let force = not_negative(LawParameter::Load, force)?;
        Ok(match self.model {
            ContactModel::Compliant(contact, _)
            | ContactModel::ApproachDamper(contact, _)
            | ContactModel::ImpactFunction { contact, .. } => match contact.stiffness() {
                StiffnessLaw::Power { coefficient, exponent } => {
                    Some((force / coefficient).powf(1.0 / exponent))
                }
                StiffnessLaw::Curve(curve) => {
                    let depth = curve.penetration(force);
                    Some(depth.ok_or(ContactLawError::OutOfRange {
                        what: LawParameter::Load,
                        got: force,
                        valid: "a force that the curve reaches",
                    })?)
                }
            },
            ContactModel::Impedance(row) => Some(row.penetration_at_rest(force)),
            ContactModel::Rigid { .. } => None,
        })
    }
}

/// Parameters of a tool, by their names in an [`Export`](crate::exports::Export); each is read once.
pub(in crate::exports) struct Given<'a> {
    tool: Tool,
    mass: f64,
    parameters: &'a [(String, Vec<f64>)],
    known: Vec<&'static str>,
}

impl<'a> Given<'a> {
    /// Parameters for a contact with the effective mass m̄, kg. Errors: m̄ is not above 0; a name is given twice; a number is not finite.
    pub(in crate::exports) fn new(
        tool: Tool,
        mass: f64,
        parameters: &'a [(String, Vec<f64>)],
    ) -> Result<Self, ExportError> {
        let given = Self { tool, mass: positive(LawParameter::Mass, mass)?, parameters, known: Vec::new() };
        for (index, (name, numbers)) in parameters.iter().enumerate() {
            if parameters[..index].iter().any(|(other, _)| other == name) {
                return Err(given.refuse(name, "it is given twice"));
            }
            if numbers.is_empty() || !numbers.iter().all(|number| number.is_finite()) {
                return Err(given.refuse(name, "expected finite numbers"));
            }
        }
        Ok(given)
    }

    /// Effective mass, kg.
    pub(in crate::exports) fn mass(&self) -> f64 {
        self.mass
    }

    /// Error of a parameter.
    pub(in crate::exports) fn refuse(&self, name: &str, why: impl Into<String>) -> ExportError {
        ExportError::Parameter { tool: self.tool, name: name.to_owned(), why: why.into() }
    }

    /// N numbers; `None` if they are not given. Error: another count.
    pub(in crate::exports) fn numbers<const N: usize>(
        &mut self,
        name: &'static str,
    ) -> Result<Option<[f64; N]>, ExportError> {
        self.known.push(name);
        let Some((_, numbers)) = self.parameters.iter().find(|(given, _)| given == name) else {
            return Ok(None);
        };
        let wrong_count = || {
            let why = format!("{} numbers; expected {N}", numbers.len());
            self.refuse(name, why)
        };
        numbers.as_slice().try_into().map(Some).map_err(|_| wrong_count())
    }

    /// A number; `None` if it is not given. Error: several numbers.
    pub(in crate::exports) fn optional(&mut self, name: &'static str) -> Result<Option<f64>, ExportError> {
        Ok(self.numbers::<1>(name)?.map(|[number]| number))
    }

    /// A number. Error: it is missing.
    pub(in crate::exports) fn number(&mut self, name: &'static str) -> Result<f64, ExportError> {
        self.optional(name)?.ok_or_else(|| self.refuse(name, "it is required"))
    }

    /// A number above 0. Errors: it is missing, or not above 0.
    pub(in crate::exports) fn positive(&mut self, name: &'static str) -> Result<f64, ExportError> {
        let number = self.number(name)?;
        if number > 0.0 {
            Ok(number)
        } else {
            Err(self.refuse(name, format!("{number:?}; expected a number above 0")))
        }
    }

    /// A parameter with the only value for which the impact is known. Error: another value.
    pub(in crate::exports) fn assume(&mut self, name: &'static str, value: f64) -> Result<(), ExportError> {
        match self.optional(name)? {
            Some(number) if number != value => {
                Err(self.refuse(name, format!("{number:?}; the impact is known for {value:?}")))
            }
            _ => Ok(()),
        }
    }

    /// A coefficient of restitution. Errors: it is missing, or not from 0 to 1.
    pub(in crate::exports) fn restitution(&mut self, name: &'static str) -> Result<f64, ExportError> {
        let number = self.number(name)?;
        if (0.0..=1.0).contains(&number) {
            return Ok(number);
        }
        Err(self.refuse(name, format!("{number:?}; expected a number from 0 to 1")))
    }

    /// Spring k xᵖ. Errors: as [`CompliantContact`].
    pub(in crate::exports) fn contact(
        &self,
        stiffness: f64,
        exponent: f64,
    ) -> Result<CompliantContact<'static>, ExportError> {
        Ok(CompliantContact::new(self.mass, stiffness)?.with_exponent(exponent)?)
    }

    /// Linear spring and damper. Errors: as [`Damper::kelvin_voigt_from_coefficient`].
    pub(in crate::exports) fn linear(
        &self,
        stiffness: f64,
        damping: f64,
        separation: Separation,
    ) -> Result<(CompliantContact<'static>, Damper), ExportError> {
        let contact = self.contact(stiffness, 1.0)?;
        let damper = Damper::kelvin_voigt_from_coefficient(contact, damping, separation)?;
        Ok((contact, damper))
    }

    /// Refuses a parameter that was not read.
    pub(in crate::exports) fn finish(&self) -> Result<(), ExportError> {
        match self.parameters.iter().find(|(name, _)| !self.known.contains(&name.as_str())) {
            None => Ok(()),
            Some((name, _)) => {
                let why = format!("it is not read; known: {}", self.known.join(", "));
                Err(self.refuse(name, why))
            }
        }
    }
}
