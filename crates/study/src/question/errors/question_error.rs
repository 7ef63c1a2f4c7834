//! Errors of a question: the cause and the flag or key at fault.

pub use crate::question::errors::fault::Fault;
use crate::question::errors::refusal::InvalidKey;
use crate::question::names::{Names, TableKeys, assembly_error_message, contact_error_key, flag};
use percuss_contact::exports::ExportError;
use percuss_contact::{ContactLawError, LawParameter};
use percuss_dynamics::{AssemblyError, EffectiveMass, ResponseError, RouteError};
use percuss_impact::ImpactError;
use percuss_units::LengthUnit;

/// Error of a question. [`message`](Self::message) uses the names of flags or study keys, depending on the
/// source of the question.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum StudyError {
    /// Error in the evaluation of a table of a study.
    #[error("{error}")]
    InTable {
        /// Keys of the table.
        table: &'static TableKeys,
        /// The error.
        error: Box<StudyError>,
    },
    /// Invalid part of a question.
    #[error("{}: {fault}", Names::Fields.name_of(field))]
    Input {
        /// Part of the question.
        field: &'static str,
        /// Fault.
        fault: Box<Fault>,
    },
    /// Invalid key of a question.
    #[error(transparent)]
    Key(#[from] InvalidKey),
    /// Loops that do not close, or do not close at the requested positions.
    #[error(transparent)]
    Assembly(#[from] AssemblyError),
    /// Travel that ends before the requested displacement.
    #[error("{}: {why}", Names::Fields.name_of("pose.travel"))]
    TravelNotReached {
        /// Reason, and the reachable displacement.
        why: String,
        /// Nearest displacement found, m, if a single travel is requested.
        nearest: Option<f64>,
        /// Name of the motion of the wheels that gives the travel; `None` for a travel of a point.
        motion: Option<&'static str>,
    },
    /// Stop that the mechanism cannot reach.
    #[error("{}", stop_not_reached(name, (*gap, *nearest, *is_smallest), alone.as_deref(), *unit, why, Names::Fields))]
    StopNotReached {
        /// Name of the stop.
        name: Box<str>,
        /// Gap as drawn, m.
        gap: f64,
        /// Largest closing of the gap, m, if known.
        nearest: Option<f64>,
        /// True if the gap increases again behind this pose; false if the search ended there.
        is_smallest: bool,
        /// The only joint that the search moves, and another joint that moves the stop; `None` if there is no other.
        alone: Option<Box<[String; 2]>>,
        /// Unit of lengths in the message.
        unit: LengthUnit,
        /// Reason.
        why: Box<str>,
    },
    /// Stop of a dependent joint that the mechanism cannot reach.
    #[error("{}", joint_stop_not_reached(joint, *limit, *nearest, (*turns, *is_smallest), driver, why))]
    JointStopNotReached {
        /// The joint.
        joint: Box<str>,
        /// Its limit, rad or m.
        limit: f64,
        /// Nearest position of the joint, rad or m, if known.
        nearest: Option<f64>,
        /// True if the joint turns.
        turns: bool,
        /// True if the joint reverses its motion at the nearest position; false if the search ended there.
        is_smallest: bool,
        /// Joint that drives the search.
        driver: Box<str>,
        /// Reason.
        why: Box<str>,
    },
    /// Invalid mass matrix.
    #[error(transparent)]
    Route(#[from] RouteError),
    /// Other error of the dynamics.
    #[error(transparent)]
    Response(ResponseError),
    /// Restitution, stiffness or speed out of range, or a restitution out of the range of the law.
    #[error(transparent)]
    Damping(#[from] ContactLawError),
    /// Simulator that does not support the contact.
    #[error(transparent)]
    Export(Box<ExportError>),
    /// Safe speed of a question with another side (link or free body); the other side must be the person.
    #[error("{}", person_is_other_side_message(Names::Fields))]
    PersonIsOtherSide,
    /// Force or pressure limit without a body region.
    #[error("{}", missing_region_message(Names::Fields))]
    NoRegion,
    /// Safe speed of a contact without mass.
    #[error("{}", missing_mass_message(Names::Fields))]
    NoMass,
    /// Valid question without a result.
    #[error("{0}")]
    NoResult(String),
    /// Impact of a contact that transmits no impulse, or without a closing motion.
    #[error(transparent)]
    NoImpact(ImpactError),
    /// No damper gives the restitution: the mass is not finite, or differs between branches.
    #[error("{0}")]
    NoDamper(String),
}

impl StudyError {
    /// Error about one part of the question.
    pub(crate) fn input(field: &'static str, fault: impl Into<Fault>) -> Self {
        StudyError::Input { field, fault: Box::new(fault.into()) }
    }

    /// Conversion of a fault to an error about one part of the question.
    pub(crate) fn about<F: Into<Fault>>(field: &'static str) -> impl Fn(F) -> Self {
        move |fault| Self::input(field, fault)
    }

    /// Same error about another part of the question.
    pub(crate) fn with_field(self, replace: impl Fn(&'static str) -> &'static str) -> Self {
        match self {
            StudyError::Input { field, fault } => StudyError::Input { field: replace(field), fault },
            other => other,
        }
    }

    /// Same error in the evaluation of a table of a study.
    pub(crate) fn in_table(self, table: &'static TableKeys) -> Self {
        match self {
            StudyError::InTable { .. } => self,
            error => StudyError::InTable { table, error: Box::new(error) },
        }
    }

    /// The error without its table.
    pub fn without_table(&self) -> &Self {
        match self {
            StudyError::InTable { error, .. } => error,
            error => error,
        }
    }

    /// Key of the invalid or missing part of the question, with the name of its table; `None` if no part is at fault.
    pub fn key(&self) -> Option<String> {
        let table = if let StudyError::InTable { table, .. } = self { Some(*table) } else { None };
        match self.without_table() {
            StudyError::Input { field, .. } => Some(Names::Keys(table).name_of(field)),
            StudyError::Key(error) => Some(error.key.to_owned()),
            StudyError::Assembly(AssemblyError::Dependent { .. }) => {
                Some(Names::Keys(table).name_of("pose.set"))
            }
            error => error.parameter().and_then(|parameter| parameter_key(parameter, table)),
        }
    }

    /// Number of a contact law or a simulator that is missing or invalid.
    fn parameter(&self) -> Option<LawParameter> {
        match self {
            StudyError::Damping(error) => error.parameter(),
            StudyError::Export(error) => error.parameter(),
            _ => None,
        }
    }

    /// Replaces an error about a dependent joint by a fault of the `Vary` field if the joint is varied, not
    /// set.
    pub(crate) fn into_varied_fault(self, is_varied: impl Fn(&str) -> bool) -> Self {
        match self {
            StudyError::Assembly(error @ AssemblyError::Dependent { .. }) => match &error {
                AssemblyError::Dependent { joint, .. } if is_varied(joint) => {
                    StudyError::input("sweep.vary", Fault::Dependent(Box::new(error)))
                }
                _ => StudyError::Assembly(error),
            },
            other => other,
        }
    }

    /// Same error with lengths in this unit, for errors that have one.
    pub(crate) fn in_unit(self, unit: LengthUnit) -> Self {
        match self {
            StudyError::StopNotReached { name, gap, nearest, is_smallest, alone, why, .. } => {
                StudyError::StopNotReached { name, gap, nearest, is_smallest, alone, unit, why }
            }
            other => other,
        }
    }

    /// True if the question is valid but has no result (exit code 1, not 2).
    pub fn has_no_result(&self) -> bool {
        match self {
            StudyError::NoDamper(_)
            | StudyError::NoResult(_)
            | StudyError::NoImpact(_)
            | StudyError::NoMass
            | StudyError::TravelNotReached { .. }
            | StudyError::StopNotReached { .. }
            | StudyError::JointStopNotReached { .. }
            | StudyError::Route(_) => true,
            StudyError::Assembly(error) => !error.is_bad_input(),
            StudyError::InTable { error, .. } => error.has_no_result(),
            _ => false,
        }
    }

    /// Message with the names of `names`: flags, study keys or fields.
    pub fn message(&self, names: Names) -> String {
        match self {
            StudyError::InTable { table, error } => error.message(names.in_table(table)),
            StudyError::Key(error) => error.message(names),
            StudyError::Input { field, fault } => {
                format!("{}: {}", names.name_of(field), fault.message(names))
            }
            StudyError::Assembly(error @ AssemblyError::Dependent { .. }) if names != Names::Fields => {
                format!("{}: {}", names.name_of("pose.set"), assembly_error_message(error, names))
            }
            StudyError::Assembly(error) => assembly_error_message(error, names),
            StudyError::TravelNotReached { why, motion: Some(motion), .. } if names == Names::Flags => {
                format!("--{motion}: {why}")
            }
            StudyError::TravelNotReached { why, .. } => format!("{}: {why}", names.name_of("pose.travel")),
            StudyError::StopNotReached { name, gap, nearest, is_smallest, alone, unit, why } => {
                stop_not_reached(name, (*gap, *nearest, *is_smallest), alone.as_deref(), *unit, why, names)
            }
            StudyError::PersonIsOtherSide => person_is_other_side_message(names),
            StudyError::NoMass => missing_mass_message(names),
            StudyError::NoRegion => missing_region_message(names),
            other => {
                let key = match names {
                    Names::Fields => None,
                    Names::Flags => other.parameter().and_then(|parameter| Some(flag(parameter.key()?))),
                    Names::Keys(table) => other.parameter().and_then(|found| parameter_key(found, table)),
                };
                format!("{other}{}", key.map_or_else(String::new, |key| format!(" ({key})")))
            }
        }
    }
}

/// Key of a number in a table, otherwise in the table of safe speeds or of dampers.
fn parameter_key(parameter: LawParameter, table: Option<&'static TableKeys>) -> Option<String> {
    use LawParameter::{Area, Energy, Force, Load, Momentum, Pressure, Region};
    let last = parameter.key()?;
    let default = match parameter {
        Force | Pressure | Area | Energy | Momentum | Load | Region => "safe_speed",
        _ => "damping",
    };
    let own = table.and_then(|table| table.find(last));
    Some(own.map_or_else(|| format!("{default}.{last}"), str::to_owned))
}

/// Message: the mechanism cannot reach a stop.
fn stop_not_reached(
    name: &str,
    (gap, nearest, is_smallest): (f64, Option<f64>, bool),
    alone: Option<&[String; 2]>,
    unit: LengthUnit,
    why: &str,
    names: Names,
) -> String {
    let travel = match names {
        Names::Fields => "",
        Names::Flags => " (--wheel-travel, --heave or --travel)",
        Names::Keys(_) => " (pose.travel)",
    };
    let why = match nearest {
        Some(nearest) => {
            let [nearest, remaining] = [nearest, gap - nearest].map(|length| unit.text(length));
            let found = if is_smallest {
                format!("it closes by {nearest} only, and {remaining} remain")
            } else {
                format!("the search ends after {nearest}, and {remaining} remain there")
            };
            let set = alone.map_or_else(String::new, |[_, kept]| {
                let hint = names.hint("pose.set");
                format!("joint \"{kept}\" moves the stop too and keeps its position: set it{hint}, or ")
            });
            format!("{found}; {set}give a travel{travel} for the mass at another pose")
        }
        None => why.to_owned(),
    };
    let outcome = match alone {
        Some([driver, _]) => format!("is not reached by a motion of joint \"{driver}\" alone"),
        None if is_smallest => "cannot be reached".to_owned(),
        None => "was not reached".to_owned(),
    };
    format!("the stop \"{name}\" with a gap of {} {outcome}: {why}", unit.text(gap))
}

/// Message: a joint cannot reach its stop.
fn joint_stop_not_reached(
    joint: &str,
    limit: f64,
    nearest: Option<f64>,
    (turns, is_smallest): (bool, bool),
    driver: &str,
    why: &str,
) -> String {
    const PER_UNIT: f64 = 1e6;
    let rounded = |position: f64| (position * PER_UNIT).round() / PER_UNIT + 0.0;
    let unit = if turns { "rad" } else { "m" };
    let why = match nearest {
        Some(nearest) if is_smallest => {
            format!("the joint reverses its motion at {} {unit}", rounded(nearest))
        }
        Some(nearest) => format!("the search ends at {} {unit}", rounded(nearest)),
        None => why.to_owned(),
    };
    format!(
        "joint \"{joint}\", whose position follows from loops or couplings, does not reach its stop at {limit} {unit} by a motion of \
         \"{driver}\": {why}; expected a limit within reach; set \"{driver}\" to compute the contact at a given pose"
    )
}

/// Message: another side is given in a question about a person.
fn person_is_other_side_message(names: Names) -> String {
    let [against, mass] = ["contact.against", "contact.against_mass"].map(|field| names.name_of(field));
    format!("the other side is the person: leave {against} and {mass} out")
}

/// Message: a limit of force or pressure without a body region.
fn missing_region_message(names: Names) -> String {
    let region = match names {
        Names::Flags => "--region",
        Names::Fields | Names::Keys(_) => "region",
    };
    format!(
        "a limit of force or pressure requires a region of the body: give {region}; without a region, give an \
         energy or a momentum"
    )
}

/// Message: a massless contact without a load.
fn missing_mass_message(names: Names) -> String {
    let load = match names {
        Names::Flags => "--load",
        Names::Fields | Names::Keys(_) => "load",
    };
    format!("the contact is massless: every speed is permitted; give the load, if any, by {load}")
}

/// Limits of m̄ along the branches, as text.
pub(crate) fn branch_limits_text(limits: &[EffectiveMass], complete: bool) -> String {
    let limit = |limit: &EffectiveMass| match limit {
        EffectiveMass::Finite(m) => format!("{m} kg"),
        EffectiveMass::Immovable => "immovable".into(),
        EffectiveMass::Massless => "massless".into(),
    };
    if limits.is_empty() {
        return "no branch with a mass was found".into();
    }
    let all = limits.iter().map(limit).collect::<Vec<_>>().join(", ");
    let more = if complete { "" } else { ", and there may be more" };
    format!("along its branches it is {all}{more}")
}

impl From<ResponseError> for StudyError {
    fn from(error: ResponseError) -> Self {
        match error {
            ResponseError::Contact(error) => StudyError::input(contact_error_key(&error), error),
            ResponseError::Route(error) => StudyError::Route(error),
            other => StudyError::Response(other),
        }
    }
}
