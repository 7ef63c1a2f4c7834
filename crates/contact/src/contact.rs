//! Compliant contact: effective mass and spring.

use crate::ContactLawError;
use crate::error::{LawParameter, positive};

/// Effective mass of a contact, and the spring between the two surfaces: force k xᵖ at the penetration x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CompliantContact {
    mass: f64,
    stiffness: f64,
    exponent: f64,
}

impl CompliantContact {
    /// Smallest and largest exponent of the spring.
    pub const EXPONENTS: std::ops::RangeInclusive<f64> = 1.0..=10.0;

    /// Contact with a linear spring.
    ///
    /// `mass` is the effective mass m̄ along the normal, in kg; `stiffness` is k, in N/m. Errors: one of the two is not
    /// a finite number above zero.
    pub fn new(mass: f64, stiffness: f64) -> Result<Self, ContactLawError> {
        let mass = positive(LawParameter::Mass, mass)?;
        let stiffness = positive(LawParameter::Stiffness, stiffness)?;
        Ok(Self { mass, stiffness, exponent: 1.0 })
    }

    /// Contact with the spring force k xᵖ, k in N/mᵖ: p = 1 for a linear spring, 3/2 for spheres (Hertz).
    ///
    /// Errors: as [`new`](Self::new); p is not from 1 to 10.
    pub fn with_exponent(self, exponent: f64) -> Result<Self, ContactLawError> {
        if Self::EXPONENTS.contains(&exponent) {
            return Ok(Self { exponent, ..self });
        }
        Err(ContactLawError::OutOfRange {
            what: LawParameter::Exponent,
            got: exponent,
            valid: "a number from 1 to 10",
        })
    }

    /// m̄, in kg.
    pub fn mass(self) -> f64 {
        self.mass
    }

    /// k, in N/mᵖ.
    pub fn stiffness(self) -> f64 {
        self.stiffness
    }

    /// p.
    pub fn exponent(self) -> f64 {
        self.exponent
    }
}
