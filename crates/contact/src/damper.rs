//! Damper in parallel with the spring of a contact.

use crate::error::{LawParameter, not_negative, positive, representable};
use crate::impact::{self, Impact, Sample};
use crate::limits;
use crate::solutions::loss_factor;
use crate::stepping::{MOST_STEPS, Stepping, step_on_curve};
use crate::trajectory::{Dissipative, Hysteretic, OnCurve, Oscillator, Trajectory};
use crate::{CompliantContact, ContactLawError, Separation, StiffnessLaw, kelvin_voigt};
use std::f64::consts::FRAC_PI_2;

/// Damper law with its coefficient. A [`CompliantContact`], a damper and an approach speed define an impact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Damper {
    /// F = k xᵖ + c x^((p−1)/2) ẋ, or F_s(x) + c ẋ on a force curve F_s.
    KelvinVoigt {
        /// Damping ratio ζ = c/(2√((p+1)/2)√(k m̄)) for the contact of the constructor. The force depends on the
        /// coefficient c, so the ratio differs for another contact. On a force curve, k is the quotient of its last force and deflection.
        ratio: f64,
        /// c, in N·s/m^((p+1)/2): N·s/m for a linear contact.
        coefficient: f64,
        /// End of the contact.
        separation: Separation,
    },
    /// F = F_s(x) (1 + d ẋ), F_s = k xᵖ or a force curve. The force does not pull: it is 0 for a rebound faster than 1/d, which other forces on
    /// the mechanism or a growing mass can cause.
    HuntCrossley {
        /// d, in s/m.
        dissipation: f64,
    },
    /// F = F_s(x) (1 + (π/2) η sgn ẋ), F_s = k xᵖ or a force curve: hysteresis that does not depend on the speed. The force jumps where the
    /// rate changes its sign.
    LossFactor {
        /// η, from 0 to less than 2/π: energy lost in a full cycle over 2π times the largest stored energy.
        loss_factor: f64,
    },
}

impl Damper {
    /// Kelvin–Voigt damper with a damping ratio at a contact: c = 2ζ√((p+1)/2)√(k m̄).
    ///
    /// Errors: ζ is negative, NaN or infinite; c is beyond a 64-bit float.
    pub fn kelvin_voigt(
        contact: CompliantContact,
        ratio: f64,
        separation: Separation,
    ) -> Result<Self, ContactLawError> {
        let ratio = not_negative("damping ratio", ratio)?;
        let coefficient = match ratio * critical_coefficient(contact) {
            _ if ratio == 0.0 => 0.0,
            c => representable("damping coefficient, N s/m^((p+1)/2)", c)?,
        };
        Ok(Self::KelvinVoigt { ratio, coefficient, separation })
    }

    /// Kelvin–Voigt damper with a coefficient c, in N·s/m^((p+1)/2), at a contact.
    ///
    /// Errors: c is negative, NaN or infinite; ζ is beyond a 64-bit float.
    pub fn kelvin_voigt_from_coefficient(
        contact: CompliantContact,
        coefficient: f64,
        separation: Separation,
    ) -> Result<Self, ContactLawError> {
        let ratio = damping_ratio(contact, coefficient)?;
        Ok(Self::KelvinVoigt { ratio, coefficient, separation })
    }

    /// Hunt–Crossley damper with a dissipation d, in s/m. Errors: d is negative, NaN or infinite.
    pub fn hunt_crossley(dissipation: f64) -> Result<Self, ContactLawError> {
        Ok(Self::HuntCrossley { dissipation: not_negative("dissipation, s/m", dissipation)? })
    }

    /// Hysteresis with a loss factor η. Errors: η is not from 0 to less than 2/π.
    pub fn loss_factor(loss_factor: f64) -> Result<Self, ContactLawError> {
        loss_factor::hysteresis(loss_factor).map(|_| Self::LossFactor { loss_factor })
    }

    /// Linear damper c beside a force curve that gives the restitution e at the approach speed (m/s), by a search over c with the integrated
    /// impact.
    pub(crate) fn linear_on_curve(
        contact: CompliantContact,
        restitution: f64,
        speed: f64,
        separation: Separation,
    ) -> Result<Self, ContactLawError> {
        let ratio = kelvin_voigt::ratio(restitution, separation)?;
        let unreachable = || ContactLawError::Unreachable {
            law: "kelvin-voigt",
            restitution,
            why: "no linear damper beside this force curve gives it",
            remedy: "use a larger restitution, or the law hunt-crossley",
        };
        // k m̄ = (m̄ v/X)² for a linear spring with the penetration X.
        let critical = 2.0 * contact.mass() * speed / contact.undamped_penetration(speed)?;
        let damper = |log: f64| Self::kelvin_voigt_from_coefficient(contact, log.exp(), separation);
        let excess = |log: f64| -> Result<f64, ContactLawError> {
            let reached =
                damper(log)?.stepped(contact, speed, |motion| motion.impact(contact.mass()))?.restitution;
            Ok((reached.max(f64::MIN_POSITIVE) / restitution).ln())
        };
        if ratio == 0.0 {
            return Self::kelvin_voigt_from_coefficient(contact, 0.0, separation);
        }
        if restitution < limits::MIN_RESTITUTION {
            return Err(unreachable());
        }
        let start = (ratio * critical).ln();
        let (mut low, mut high) = ((start, excess(start)?), (start, excess(start)?));
        for _ in 0..limits::MAX_ITERATIONS {
            if low.1 >= 0.0 && high.1 <= 0.0 {
                break;
            }
            low = if low.1 < 0.0 { (low.0 - 1.0, excess(low.0 - 1.0)?) } else { low };
            high = if high.1 > 0.0 { (high.0 + 1.0, excess(high.0 + 1.0)?) } else { high };
        }
        if !(low.1 >= 0.0 && high.1 <= 0.0) {
            return Err(unreachable());
        }
        // Illinois method.
        let mut side = 0;
        for _ in 0..limits::MAX_SEARCH_STEPS {
            if high.0 - low.0 <= limits::BRACKET_TOLERANCE * start.abs().max(1.0) || low.1 == high.1 {
                break;
            }
            let middle = (low.0 * high.1 - high.0 * low.1) / (high.1 - low.1);
            let value = excess(middle)?;
            if value.abs() <= limits::RESTITUTION_TOLERANCE {
                return damper(middle);
            }
            if value > 0.0 {
                (low, high.1) = ((middle, value), if side == 1 { 0.5 * high.1 } else { high.1 });
                side = 1;
            } else {
                (high, low.1) = ((middle, value), if side == -1 { 0.5 * low.1 } else { low.1 });
                side = -1;
            }
        }
        damper(low.0)
    }

    /// Force in newtons at a penetration (m) and its rate (m/s), as given at the variants. A negative penetration counts as 0.
    pub fn force(self, contact: CompliantContact, penetration: f64, rate: f64) -> f64 {
        let x = penetration.max(0.0);
        let spring = contact.stiffness().force(x);
        match self {
            Self::KelvinVoigt { coefficient, .. } => {
                let power = contact.power_law().map_or(0.0, |(_, p)| 0.5 * (p - 1.0));
                spring + coefficient * x.powf(power) * rate
            }
            Self::HuntCrossley { dissipation } => spring * (1.0 + dissipation * rate).max(0.0),
            Self::LossFactor { .. } if rate == 0.0 => spring,
            Self::LossFactor { loss_factor } => spring * (1.0 + (FRAC_PI_2 * loss_factor).copysign(rate)),
        }
    }

    /// Same damper with its coefficient multiplied by a factor. Errors: as for [`hunt_crossley`](Self::hunt_crossley) and
    /// [`loss_factor`](Self::loss_factor).
    pub fn scaled(self, factor: f64) -> Result<Self, ContactLawError> {
        match self {
            Self::KelvinVoigt { ratio, coefficient, separation } => {
                let coefficient = not_negative("damping coefficient, N s/m^((p+1)/2)", coefficient * factor)?;
                Ok(Self::KelvinVoigt { ratio: ratio * factor, coefficient, separation })
            }
            Self::HuntCrossley { dissipation } => Self::hunt_crossley(dissipation * factor),
            Self::LossFactor { loss_factor } => Self::loss_factor(loss_factor * factor),
        }
    }

    /// True if the force jumps where the rate changes its sign.
    pub fn jumps_at_reversal(self) -> bool {
        matches!(self, Self::LossFactor { loss_factor } if loss_factor > 0.0)
    }

    /// Restitution at a contact for an approach speed, in m/s. The value is exact for the force of the damper, also
    /// if an approximate formula determined the coefficient. The restitution of a Kelvin–Voigt damper does not depend
    /// on the speed.
    ///
    /// Errors: the speed is not a finite number above zero; a coefficient is out of range; overflow.
    pub fn restitution(self, contact: CompliantContact, speed: f64) -> Result<f64, ContactLawError> {
        match self {
            Self::KelvinVoigt { .. } if contact.power_law().is_none() => {
                Ok(self.stepped(contact, speed, |motion| motion.impact(contact.mass()))?.restitution)
            }
            _ => Ok(self.trajectory(contact, speed)?.restitution()),
        }
    }

    /// 1 − e, without loss of digits for light damping. Errors: as [`Damper::restitution`].
    pub fn restitution_loss(self, contact: CompliantContact, speed: f64) -> Result<f64, ContactLawError> {
        match self {
            Self::KelvinVoigt { .. } if contact.power_law().is_none() => {
                Ok(1.0 - self.restitution(contact, speed)?)
            }
            _ => Ok(self.trajectory(contact, speed)?.loss()),
        }
    }

    /// Key figures of the impact at a contact for an approach speed, in m/s. Errors: as [`Damper::restitution`].
    pub fn impact(self, contact: CompliantContact, speed: f64) -> Result<Impact, ContactLawError> {
        match self {
            Self::KelvinVoigt { .. } if contact.power_law().is_none() => {
                self.stepped(contact, speed, |motion| motion.impact(contact.mass()))
            }
            _ => impact::impact(&*self.trajectory(contact, speed)?, contact, speed),
        }
    }

    /// History of the impact at `samples` instants from the first touch to the end: force over time and over
    /// penetration. The loop of force over penetration encloses the lost energy.
    ///
    /// The last sample is the end of the contact. The force there is 0, or the pull of a Kelvin–Voigt damper that
    /// ends when the gap closes. If the gap never closes, the history covers eight time constants of the slow return.
    /// Errors: as [`Damper::restitution`]; fewer than 2 or more than 1 000 000 samples.
    pub fn history(
        self,
        contact: CompliantContact,
        speed: f64,
        samples: usize,
    ) -> Result<Vec<Sample>, ContactLawError> {
        match self {
            Self::KelvinVoigt { .. } if contact.power_law().is_none() => {
                self.stepped(contact, speed, |motion| motion.history(contact.mass(), samples))?
            }
            _ => impact::history(&*self.trajectory(contact, speed)?, contact, speed, samples),
        }
    }

    /// True if the contact ends when its force vanishes. Without damping the force stays zero after the separation, so the penetration
    /// determines the end.
    pub(crate) fn ends_at_zero_force(self) -> bool {
        matches!(
            self,
            Self::KelvinVoigt { separation: Separation::ForceVanishes, coefficient, .. } if coefficient > 0.0
        )
    }

    /// Result of the impact on a force curve, integrated with fixed steps.
    fn stepped<T>(
        self,
        contact: CompliantContact,
        speed: f64,
        result: impl FnOnce(&Stepping) -> T,
    ) -> Result<T, ContactLawError> {
        let speed = positive(LawParameter::Speed, speed)?;
        let corners = match contact.stiffness() {
            StiffnessLaw::Curve(curve) => &curve.deflections()[1..],
            StiffnessLaw::Power { .. } => &[],
        };
        let force = |x: f64, rate: f64| self.force(contact, x, rate);
        let (step, ends_at_zero_force) = (step_on_curve(contact, speed)?, self.ends_at_zero_force());
        Ok(result(&Stepping {
            force: &force,
            ends_at_zero_force,
            jumps_at_reversal: false,
            corners,
            step,
            speed,
            beside: &|_, _| 0.0,
            most_steps: MOST_STEPS,
        }))
    }

    /// Dimensionless motion of an impact on the contact at the speed; not for a linear damper beside a force curve.
    fn trajectory<'a>(
        self,
        contact: CompliantContact<'a>,
        speed: f64,
    ) -> Result<Box<dyn Trajectory + 'a>, ContactLawError> {
        let speed = positive(LawParameter::Speed, speed)?;
        match self {
            Self::KelvinVoigt { coefficient, separation, .. } => {
                let (_, exponent) = power_or_secant(contact);
                Ok(Box::new(Oscillator::new(damping_ratio(contact, coefficient)?, exponent, separation)))
            }
            Self::HuntCrossley { dissipation } => {
                let number = not_negative("dissipation, s/m", dissipation)? * speed;
                if number > limits::MAX_DISSIPATION_NUMBER {
                    return Err(ContactLawError::NotRepresentable {
                        what: "dissipation times closing speed",
                    });
                }
                Ok(match contact.stiffness() {
                    StiffnessLaw::Power { exponent, .. } => Box::new(Dissipative::new(number, exponent)),
                    StiffnessLaw::Curve(curve) => {
                        let unit = contact.undamped_penetration(speed)?;
                        Box::new(OnCurve::new(curve, contact.mass(), speed, number, unit)?)
                    }
                })
            }
            Self::LossFactor { loss_factor } => {
                let h = loss_factor::hysteresis(loss_factor)?;
                let (elastic, scale): (Box<dyn Trajectory>, f64) = match contact.stiffness() {
                    StiffnessLaw::Power { exponent, .. } => {
                        (Box::new(Dissipative::new(0.0, exponent)), (1.0 + h).powf(-1.0 / (exponent + 1.0)))
                    }
                    StiffnessLaw::Curve(curve) => {
                        let unit = contact.undamped_penetration(speed)?;
                        (Box::new(OnCurve::new(curve, contact.mass() / (1.0 + h), speed, 0.0, unit)?), 1.0)
                    }
                };
                Ok(Box::new(Hysteretic::new(h, elastic, scale)))
            }
        }
    }
}

/// 2√((p+1)/2)√(k m̄): the coefficient of the damping ratio 1.
fn critical_coefficient(contact: CompliantContact) -> f64 {
    let (stiffness, exponent) = power_or_secant(contact);
    2.0 * (0.5 * (exponent + 1.0)).sqrt() * stiffness.sqrt() * contact.mass().sqrt()
}

/// k and p of the power law; for a force curve the quotient of its last force and deflection, and 1.
fn power_or_secant(contact: CompliantContact) -> (f64, f64) {
    match contact.stiffness() {
        StiffnessLaw::Power { coefficient, exponent } => (coefficient, exponent),
        StiffnessLaw::Curve(curve) => (curve.end().1 / curve.end().0, 1.0),
    }
}

/// ζ of the coefficient c on a contact. Error: ζ overflows.
fn damping_ratio(contact: CompliantContact, coefficient: f64) -> Result<f64, ContactLawError> {
    let coefficient = not_negative("damping coefficient, N s/m^((p+1)/2)", coefficient)?;
    if coefficient == 0.0 {
        return Ok(0.0);
    }
    representable("damping ratio", coefficient / critical_coefficient(contact))
}
