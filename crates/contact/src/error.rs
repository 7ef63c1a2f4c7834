//! Errors of this crate.

use thiserror::Error;

/// Error of a contact law.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum ContactLawError {
    /// Number outside its range, including NaN and infinity.
    #[error("{what}: {got:?} is out of range; expected {valid}")]
    OutOfRange {
        /// Name of the number, with its unit.
        what: &'static str,
        /// Given value.
        got: f64,
        /// Permitted range, in words.
        valid: &'static str,
    },
    /// No damping of the law gives the required restitution.
    #[error("{law}: no damping gives the restitution {restitution:?}: {why}; {remedy}")]
    Unreachable {
        /// Name of the law.
        law: &'static str,
        /// Required restitution.
        restitution: f64,
        /// Range that the law can reach.
        why: &'static str,
        /// Remedy.
        remedy: &'static str,
    },
    /// Missing approach speed: the damping of the law depends on the speed.
    #[error("{law}: the damping depends on the approach speed: give the speed, in m/s")]
    SpeedNeeded {
        /// Name of the law.
        law: &'static str,
    },
    /// Overflow or underflow of the result or of an intermediate value.
    #[error("{what}: too large or too small for a 64-bit float (about 1e-308 to 1e308); check the units")]
    NotRepresentable {
        /// Name of the quantity, with its unit.
        what: &'static str,
    },
    /// Unknown name of a law.
    #[error("\"{name}\" is not a contact law{}; known: {known}", suggestion(.nearest))]
    UnknownLaw {
        /// Given value.
        name: String,
        /// Most similar name, if one is close.
        nearest: Option<&'static str>,
        /// All names, separated by commas.
        known: String,
    },
    /// Conflict between a name of a law, which implies an exponent or an end of the contact, and the given value.
    #[error(
        "{name} implies the {what} {fixed}, but {got} is given: omit the value, or use a law name that does not \
         imply it"
    )]
    Contradicts {
        /// Name of the law.
        name: &'static str,
        /// Quantity in conflict: exponent or separation.
        what: &'static str,
        /// Value implied by the name.
        fixed: String,
        /// Given value.
        got: String,
    },
    /// Unknown region of the body.
    #[error("\"{name}\" is not a region of the body in the table{}; known: {known}", suggestion(.nearest))]
    UnknownRegion {
        /// Given value.
        name: String,
        /// Most similar name, if one is close.
        nearest: Option<&'static str>,
        /// All names, separated by commas.
        known: String,
    },
}

/// Text "did you mean …" at the end of an error message; empty without a similar name.
pub(crate) fn suggestion(nearest: &Option<&'static str>) -> String {
    nearest.map_or_else(String::new, |name| format!(", did you mean \"{name}\"?"))
}

/// Returns the name in `known` that is most similar to a given name, if one is close.
pub(crate) fn nearest(name: &str, known: impl Iterator<Item = &'static str>) -> Option<&'static str> {
    let normalised = name.to_lowercase();
    known
        .map(|other| (strsim::jaro_winkler(&normalised, other), other))
        .filter(|(likeness, _)| *likeness > 0.8)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, other)| other)
}

/// Checks a number: above zero, finite, and not subnormal.
pub(crate) fn positive(what: &'static str, value: f64) -> Result<f64, ContactLawError> {
    if value.is_normal() && value > 0.0 {
        return Ok(value);
    }
    Err(ContactLawError::OutOfRange { what, got: value, valid: "a finite number above 0" })
}

/// Checks a number: finite, zero or above.
pub(crate) fn not_negative(what: &'static str, value: f64) -> Result<f64, ContactLawError> {
    if value.is_finite() && value >= 0.0 {
        return Ok(value);
    }
    Err(ContactLawError::OutOfRange { what, got: value, valid: "a finite number, 0 or above" })
}

/// Checks a coefficient of restitution e, or 1 − e: 0 to 1.
pub(crate) fn unit_interval(what: &'static str, value: f64) -> Result<f64, ContactLawError> {
    if (0.0..=1.0).contains(&value) {
        return Ok(value);
    }
    Err(ContactLawError::OutOfRange { what, got: value, valid: "a number from 0 to 1" })
}

/// Checks a result that is above zero in theory: no overflow, no underflow.
pub(crate) fn representable(what: &'static str, value: f64) -> Result<f64, ContactLawError> {
    if value.is_normal() && value > 0.0 { Ok(value) } else { Err(ContactLawError::NotRepresentable { what }) }
}
