//! Damper in parallel with the spring of a contact.

use crate::error::{LawParameter, not_negative, positive, representable};
use crate::impact::{self, Impact, Sample};
use crate::limits;
use crate::trajectory::{Dissipative, Oscillator, Trajectory};
use crate::{CompliantContact, ContactLawError, Separation};

/// Damper law with its coefficient. A [`CompliantContact`], a damper and an approach speed define an impact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Damper {
    /// F = k xᵖ + c x^((p−1)/2) ẋ.
    KelvinVoigt {
        /// Damping ratio ζ = c/(2√((p+1)/2)√(k m̄)) for the contact of the constructor. The force depends on the
        /// coefficient c, so the ratio differs for another contact.
        ratio: f64,
        /// c, in N·s/m^((p+1)/2): N·s/m for a linear contact.
        coefficient: f64,
        /// End of the contact.
        separation: Separation,
    },
    /// F = k xᵖ (1 + d ẋ).
    HuntCrossley {
        /// d, in s/m.
        dissipation: f64,
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

    /// Force in newtons at a penetration (m) and its rate (m/s): k xᵖ + c x^((p−1)/2) ẋ, or k xᵖ (1 + d ẋ). A negative
    /// penetration counts as 0.
    pub fn force(self, contact: CompliantContact, penetration: f64, rate: f64) -> f64 {
        let (k, p, x) = (contact.stiffness(), contact.exponent(), penetration.max(0.0));
        match self {
            Self::KelvinVoigt { coefficient, .. } => {
                k * x.powf(p) + coefficient * x.powf(0.5 * (p - 1.0)) * rate
            }
            Self::HuntCrossley { dissipation } => k * x.powf(p) * (1.0 + dissipation * rate),
        }
    }

    /// Restitution at a contact for an approach speed, in m/s. The value is exact for the force of the damper, also
    /// if an approximate formula determined the coefficient. The restitution of a Kelvin–Voigt damper does not depend
    /// on the speed.
    ///
    /// Errors: the speed is not a finite number above zero; a coefficient is out of range; overflow.
    pub fn restitution(self, contact: CompliantContact, speed: f64) -> Result<f64, ContactLawError> {
        Ok(self.trajectory(contact, speed)?.restitution())
    }

    /// 1 − e, without loss of digits for light damping. Errors: as [`Damper::restitution`].
    pub fn restitution_loss(self, contact: CompliantContact, speed: f64) -> Result<f64, ContactLawError> {
        Ok(self.trajectory(contact, speed)?.loss())
    }

    /// Key figures of the impact at a contact for an approach speed, in m/s. Errors: as [`Damper::restitution`].
    pub fn impact(self, contact: CompliantContact, speed: f64) -> Result<Impact, ContactLawError> {
        impact::impact(&*self.trajectory(contact, speed)?, contact, speed)
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
        impact::history(&*self.trajectory(contact, speed)?, contact, speed, samples)
    }

    /// Dimensionless motion of an impact on the contact at the speed.
    fn trajectory(
        self,
        contact: CompliantContact,
        speed: f64,
    ) -> Result<Box<dyn Trajectory>, ContactLawError> {
        let speed = positive(LawParameter::Speed, speed)?;
        match self {
            Self::KelvinVoigt { coefficient, separation, .. } => Ok(Box::new(Oscillator::new(
                damping_ratio(contact, coefficient)?,
                contact.exponent(),
                separation,
            ))),
            Self::HuntCrossley { dissipation } => {
                let number = not_negative("dissipation, s/m", dissipation)? * speed;
                if number > limits::MAX_DISSIPATION_NUMBER {
                    return Err(ContactLawError::NotRepresentable {
                        what: "dissipation times closing speed",
                    });
                }
                Ok(Box::new(Dissipative::new(number, contact.exponent())))
            }
        }
    }
}

/// 2√((p+1)/2)√(k m̄): the coefficient of the damping ratio 1.
fn critical_coefficient(contact: CompliantContact) -> f64 {
    2.0 * (0.5 * (contact.exponent() + 1.0)).sqrt() * contact.stiffness().sqrt() * contact.mass().sqrt()
}

/// ζ of the coefficient c on a contact. Error: ζ overflows.
fn damping_ratio(contact: CompliantContact, coefficient: f64) -> Result<f64, ContactLawError> {
    let coefficient = not_negative("damping coefficient, N s/m^((p+1)/2)", coefficient)?;
    if coefficient == 0.0 {
        return Ok(0.0);
    }
    representable("damping ratio", coefficient / critical_coefficient(contact))
}
