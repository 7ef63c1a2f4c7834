//! Errors of this crate.

use std::fmt;
use thiserror::Error;

/// Number or name that a user gives for a contact law, a simulator or a safe speed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum LawParameter {
    /// Coefficient of restitution.
    Restitution,
    /// Stiffness of the contact.
    Stiffness,
    /// Force curve of the contact.
    Curve,
    /// Exponent of the spring.
    Exponent,
    /// Approach speed.
    Speed,
    /// Effective mass.
    Mass,
    /// Mass of the contact link alone.
    OwnMass,
    /// Mass of the other body alone.
    OtherOwnMass,
    /// Time step of the simulator.
    TimeStep,
    /// Diagonal ratio of MuJoCo.
    DiagonalRatio,
    /// Accuracy of the restitution.
    Accuracy,
    /// Greatest force of a safe speed.
    Force,
    /// Greatest pressure of a safe speed.
    Pressure,
    /// Area of the pressure.
    Area,
    /// Greatest energy of a safe speed.
    Energy,
    /// Greatest momentum of a safe speed.
    Momentum,
    /// Load at the contact of a safe speed.
    Load,
    /// Contact law.
    Law,
    /// End of the contact.
    Separation,
    /// Region of the body of a safe speed.
    Region,
    /// Number that no user gives: its description.
    Other(&'static str),
}

impl LawParameter {
    /// Last part of the key in a study, which is the flag with dashes in place of underscores, and description with its unit.
    fn texts(self) -> (Option<&'static str>, &'static str) {
        let (key, description) = match self {
            Self::Restitution => ("restitution", "restitution"),
            Self::Stiffness => ("stiffness", "stiffness, N/m^p"),
            Self::Curve => ("stiffness_curve", "force curve"),
            Self::Exponent => ("exponent", "exponent of the spring"),
            Self::Speed => ("speed", "closing speed, m/s"),
            Self::Mass => ("mass", "effective mass, kg"),
            Self::OwnMass => ("own_mass", "mass of the contact link alone, kg"),
            Self::OtherOwnMass => ("other_own_mass", "mass of the other body alone, kg"),
            Self::TimeStep => ("time_step", "time step, s"),
            Self::DiagonalRatio => ("diagonal_ratio", "MuJoCo's diagonal ratio"),
            Self::Accuracy => ("accuracy", "accuracy of the restitution"),
            Self::Force => ("force", "greatest force, N"),
            Self::Pressure => ("pressure", "greatest pressure, Pa"),
            Self::Area => ("area", "area of the contact, m^2"),
            Self::Energy => ("energy", "greatest energy, J"),
            Self::Momentum => ("momentum", "greatest momentum, N·s"),
            Self::Load => ("load", "load, kg"),
            Self::Law => ("law", "contact law"),
            Self::Separation => ("separation", "separation"),
            Self::Region => ("region", "region of the body"),
            Self::Other(description) => return (None, description),
        };
        (Some(key), description)
    }

    /// Last part of the key in a study; `None` for a number that no user gives.
    pub fn key(self) -> Option<&'static str> {
        self.texts().0
    }
}

impl From<&'static str> for LawParameter {
    fn from(description: &'static str) -> Self {
        Self::Other(description)
    }
}

impl fmt::Display for LawParameter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.texts().1)
    }
}

/// Error of a contact law.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum ContactLawError {
    /// Number outside its range, including NaN and infinity.
    #[error("{what}: {got:?} is out of range; expected {valid}")]
    OutOfRange {
        /// The number.
        what: LawParameter,
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
    #[error("{law}: the damping depends on the closing speed: give the speed, in m/s")]
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
    /// Points that are no force curve.
    #[error("force curve: {why}")]
    Curve {
        /// Received and expected points.
        why: String,
    },
    /// Records from which no contact is identified.
    #[error("{}{why}", record.map_or_else(String::new, |record| format!("record {}: ", record + 1)))]
    Record {
        /// Number of the record, from 0; `None` for all.
        record: Option<usize>,
        /// Received and expected record.
        why: String,
    },
    /// Force curve that never does the work of the impact: its last slope is negative, or all its forces are zero.
    #[error(
        "force curve: it never does the work {energy:.4} J that stops the mass, because its last slope is not positive; give points up to \
         a larger deflection, or a slower speed"
    )]
    NotStopped {
        /// Energy, J.
        energy: f64,
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
        what: LawParameter,
        /// Value implied by the name.
        fixed: Box<str>,
        /// Given value.
        got: Box<str>,
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
pub(crate) fn positive(what: impl Into<LawParameter>, value: f64) -> Result<f64, ContactLawError> {
    if value.is_normal() && value > 0.0 {
        return Ok(value);
    }
    Err(ContactLawError::OutOfRange { what: what.into(), got: value, valid: "a finite number above 0" })
}

/// Checks a number: finite, zero or above.
pub(crate) fn not_negative(what: impl Into<LawParameter>, value: f64) -> Result<f64, ContactLawError> {
    if value.is_finite() && value >= 0.0 {
        return Ok(value);
    }
    Err(ContactLawError::OutOfRange { what: what.into(), got: value, valid: "a finite number, 0 or above" })
}

/// Checks a coefficient of restitution e, or 1 − e: 0 to 1.
pub(crate) fn unit_interval(what: impl Into<LawParameter>, value: f64) -> Result<f64, ContactLawError> {
    if (0.0..=1.0).contains(&value) {
        return Ok(value);
    }
    Err(ContactLawError::OutOfRange { what: what.into(), got: value, valid: "a number from 0 to 1" })
}

/// Checks a result that is above zero in theory: no overflow, no underflow.
pub(crate) fn representable(what: &'static str, value: f64) -> Result<f64, ContactLawError> {
    if value.is_normal() && value > 0.0 { Ok(value) } else { Err(ContactLawError::NotRepresentable { what }) }
}

impl ContactLawError {
    /// Parameter that is missing or invalid.
    pub fn parameter(&self) -> Option<LawParameter> {
        match self {
            Self::OutOfRange { what, .. } | Self::Contradicts { what, .. } => Some(*what),
            Self::Curve { .. } | Self::NotStopped { .. } => Some(LawParameter::Curve),
            Self::SpeedNeeded { .. } => Some(LawParameter::Speed),
            Self::UnknownLaw { .. } => Some(LawParameter::Law),
            Self::UnknownRegion { .. } => Some(LawParameter::Region),
            Self::Unreachable { .. } => Some(LawParameter::Restitution),
            Self::NotRepresentable { .. } | Self::Record { .. } => None,
        }
    }
}
