//! Errors of this crate.

use thiserror::Error;

/// Why there is no answer.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum ContactLawError {
    /// A number outside its range, NaN and infinity included.
    #[error("{what}: {got:?} is out of range; expected {valid}")]
    OutOfRange {
        /// Which number, with its unit.
        what: &'static str,
        /// As given.
        got: f64,
        /// The range in words.
        valid: &'static str,
    },
    /// The law has no damping that gives this restitution.
    #[error("{law}: no damping gives the restitution {restitution:?}: {why}; {remedy}")]
    Unreachable {
        /// The law's name.
        law: &'static str,
        /// As asked for.
        restitution: f64,
        /// What the law does instead.
        why: &'static str,
        /// What to ask for instead.
        remedy: &'static str,
    },
    /// The damping depends on the approach speed, which was not given.
    #[error("{law}: its damping is a number over the approach speed: give the speed, in m/s")]
    SpeedNeeded {
        /// The law's name.
        law: &'static str,
    },
    /// The answer, or a step to it, is beyond what a 64-bit float holds.
    #[error("{what}: too large or too small for a 64-bit float (about 1e-308 to 1e308); check the units")]
    NotRepresentable {
        /// Which quantity, with its unit.
        what: &'static str,
    },
    /// A law of this name is not known.
    #[error("\"{name}\" is no contact law{}; known: {known}", suggestion(.nearest))]
    UnknownLaw {
        /// As given.
        name: String,
        /// The most similar name, where one is close.
        nearest: Option<&'static str>,
        /// All names, commas between.
        known: String,
    },
    /// The name of a law stands for another exponent, or another end of the contact, than was given.
    #[error(
        "{name} stands for the {what} {fixed}; {got} was given: leave it out, or name the law without that"
    )]
    Contradicts {
        /// The name.
        name: &'static str,
        /// Exponent or separation.
        what: &'static str,
        /// What the name stands for.
        fixed: String,
        /// What was given.
        got: String,
    },
    /// A region of the body of this name is not in the table.
    #[error("\"{name}\" is no region of the body in the table{}; known: {known}", suggestion(.nearest))]
    UnknownRegion {
        /// As given.
        name: String,
        /// The most similar name, where one is close.
        nearest: Option<&'static str>,
        /// All names, commas between.
        known: String,
    },
}

/// What an error adds where a name is close.
pub(crate) fn suggestion(nearest: &Option<&'static str>) -> String {
    nearest.map_or_else(String::new, |name| format!(", did you mean \"{name}\"?"))
}

/// The name among `known` that is most like the one given, where one is close.
pub(crate) fn nearest(name: &str, known: impl Iterator<Item = &'static str>) -> Option<&'static str> {
    let wanted = name.to_lowercase();
    known
        .map(|other| (strsim::jaro_winkler(&wanted, other), other))
        .filter(|(likeness, _)| *likeness > 0.8)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, other)| other)
}

/// A number above zero, neither infinite nor so small that it has lost digits.
pub(crate) fn positive(what: &'static str, value: f64) -> Result<f64, ContactLawError> {
    if value.is_normal() && value > 0.0 {
        return Ok(value);
    }
    Err(ContactLawError::OutOfRange { what, got: value, valid: "a finite number above 0" })
}

/// A finite number, zero or above.
pub(crate) fn not_negative(what: &'static str, value: f64) -> Result<f64, ContactLawError> {
    if value.is_finite() && value >= 0.0 {
        return Ok(value);
    }
    Err(ContactLawError::OutOfRange { what, got: value, valid: "a finite number, 0 or above" })
}

/// A coefficient of restitution, or its complement to one.
pub(crate) fn unit_interval(what: &'static str, value: f64) -> Result<f64, ContactLawError> {
    if (0.0..=1.0).contains(&value) {
        return Ok(value);
    }
    Err(ContactLawError::OutOfRange { what, got: value, valid: "a number from 0 to 1" })
}

/// A result that is above zero by its formula: it must not have overflowed or vanished.
pub(crate) fn representable(what: &'static str, value: f64) -> Result<f64, ContactLawError> {
    if value.is_normal() && value > 0.0 { Ok(value) } else { Err(ContactLawError::NotRepresentable { what }) }
}
