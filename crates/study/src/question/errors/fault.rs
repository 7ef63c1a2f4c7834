//! Faults of the parts of a question.

use crate::question::errors::fault_texts::{no_limits, no_reference_pose, varied_is_set};
use crate::question::errors::table_error::TableError;
use crate::question::names::{Names, assembly_error_message, contact_error_message};
use crate::question::pose_file::GivenPoseError;
use percuss_dynamics::{AssemblyError, ConditionsError, ConfigurationError, ContactError, TravelError};
use percuss_impact::{ExtremesError, ImpactError, PercussionError, RangeError, RatesError, ReflectedError};
use percuss_mechanism::{JointKind, UnknownName};
use percuss_units::QuantityError;

/// Fault of one part of a question.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Fault {
    /// Reason with the received and the expected value, and the remedy.
    #[error("{0}")]
    Text(String),
    /// Invalid contact.
    #[error(transparent)]
    Contact(#[from] ContactError),
    /// Number in the wrong unit.
    #[error("joint \"{joint}\": {source}")]
    Position {
        /// Joint.
        joint: String,
        /// Cause.
        source: QuantityError,
    },
    /// Requested result that requires a contact point.
    #[error("{contact} has no {result}: it has no contact point; give a contact by link, point and normal")]
    NoContactPoint {
        /// Kind of the contact.
        contact: &'static str,
        /// The result.
        result: &'static str,
    },
    /// Joint without motion.
    #[error("joint \"{joint}\" is fixed; expected a joint that moves")]
    NoMotion {
        /// Joint.
        joint: String,
    },
    /// Joint stop of a joint without exactly one position.
    #[error("joint \"{joint}\" is {}; expected a revolute, continuous or prismatic joint: only these have a \
        stop", kind.name())]
    NoStop {
        /// Joint.
        joint: String,
        /// Kind of the joint.
        kind: JointKind,
    },
    /// Joint without limits.
    #[error(
        "joint \"{joint}\" has no <limit>; omit the end of the range and set the joint to the position of \
        the stop"
    )]
    NoLimit {
        /// Joint.
        joint: String,
    },
    /// Varied joint with more or fewer than one position.
    #[error("\"{joint}\": a {} joint has no single position to vary", kind.name())]
    NoSinglePosition {
        /// Joint.
        joint: String,
        /// Kind of the joint.
        kind: JointKind,
    },
    /// Varied joint that is set as well.
    #[error("{}", varied_is_set(joint, Names::Fields))]
    VariedIsSet {
        /// Joint.
        joint: String,
    },
    /// Joint without limits to sample between.
    #[error("{}", no_limits(joint, *kind, Names::Fields))]
    NothingToSampleBetween {
        /// Joint.
        joint: String,
        /// Kind of the joint.
        kind: JointKind,
    },
    /// Fault of a file of positions.
    #[error(transparent)]
    Table(#[from] Box<TableError>),
    /// Invalid travel, or a travel without a driving joint.
    #[error(transparent)]
    Travel(#[from] TravelError),
    /// Varied joint that depends on other joints.
    #[error(transparent)]
    Dependent(Box<AssemblyError>),
    /// Point in a frame that requires a reference pose, and the reference pose is unreachable.
    #[error("{}", no_reference_pose(source, Names::Fields))]
    NoReferencePose {
        /// Cause.
        source: AssemblyError,
    },
}

impl Fault {
    /// Message with the names of `names`: flags, study keys or fields.
    pub(crate) fn message(&self, names: Names) -> String {
        match self {
            Fault::VariedIsSet { joint } => varied_is_set(joint, names),
            Fault::NoReferencePose { source } => no_reference_pose(source, names),
            Fault::Table(error) => error.message(names),
            Fault::NothingToSampleBetween { joint, kind } => no_limits(joint, *kind, names),
            Fault::Dependent(error) => assembly_error_message(error, names),
            Fault::Contact(error) => contact_error_message(error, names),
            Fault::Travel(TravelError::Assembly(error)) => assembly_error_message(error, names),
            other => other.to_string(),
        }
    }
}

/// Converts errors and texts to the text of a fault.
macro_rules! text_of {
    ($($error:ty)*) => {$(
        impl From<$error> for Fault {
            fn from(error: $error) -> Self {
                Fault::Text(error.to_string())
            }
        }
    )*};
}

text_of! {
    &str String UnknownName QuantityError ConfigurationError ConditionsError GivenPoseError
    ImpactError RatesError ReflectedError PercussionError RangeError ExtremesError
}
