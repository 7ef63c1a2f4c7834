//! Errors of an impact.

use crate::mobility::delassus::DelassusError;
use crate::reactions::reaction_map::ReactionError;
use percuss_dynamics::{ComplianceError, ResponseError};

/// Error of an impact.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ImpactError {
    /// The coefficient of restitution is outside its range.
    #[error("the coefficient of restitution is {got}; expected a number from 0 to 1")]
    Restitution {
        /// Given value.
        got: f64,
    },
    /// The closing speed is not positive.
    #[error("the closing speed is {got} m/s; expected a number above zero: the sides approach each other")]
    ClosingSpeed {
        /// Given value, m/s.
        got: f64,
    },
    /// No motion of the mechanism closes the gap.
    #[error("the mechanism is immovable: no motion closes this gap, so no impact occurs")]
    Immovable,
    /// The coefficient of friction is outside its range.
    #[error("the coefficient of friction is {got}; expected a finite number of at least 0")]
    Friction {
        /// Given value.
        got: f64,
    },
    /// Friction at a contact that is a moment about an axis.
    #[error(
        "the contact is a moment about an axis, which has no tangential friction; expected a contact point with a normal"
    )]
    FrictionOfMoment,
    /// The law of restitution has no solution, or the integration found no end.
    #[error(
        "the impact has no end by the {law} law of restitution; expected another law, or other coefficients of restitution or \
         friction"
    )]
    NoEnd {
        /// Name of the law.
        law: &'static str,
    },
    /// The integration of the energetic law of several contacts has too many steps, because one contact is far slower than another.
    #[error(
        "the energetic law has no result within its largest number of steps: contact number {contact} (from 1) can hardly move or is soft, \
         and its impact takes {ratio:.1e} times as long as that of another contact; expected similar mobilities and stiffnesses, or the \
         question without this contact"
    )]
    SlowContact {
        /// Number of the contact, from 1.
        contact: usize,
        /// Ratio of the durations.
        ratio: f64,
    },
    /// Too many simultaneous contacts.
    #[error("{got} simultaneous contacts; at most {most} are supported")]
    TooManyContacts {
        /// Given number.
        got: usize,
        /// Largest number.
        most: usize,
    },
    /// A list has another length than the list of contacts.
    #[error("{got} values of {what} for {expected} contacts; expected one for each contact")]
    ContactValues {
        /// Quantity.
        what: &'static str,
        /// Given number.
        got: usize,
        /// Number of contacts.
        expected: usize,
    },
    /// A ratio of stiffnesses or the exponent is out of range.
    #[error("{what} is {got}; expected {valid}")]
    OutOfRange {
        /// Quantity.
        what: &'static str,
        /// Given value.
        got: f64,
        /// Valid values.
        valid: &'static str,
    },
    /// No subset of sticking contacts satisfies the conditions.
    #[error("for every subset of sticking contacts, a contact pulls or closes its gap")]
    NoConsistentSubset,
    /// The contact of an impact in time does not end.
    #[error(
        "the contact does not end within {time:.3e} s; expected a force that grows with the penetration, and no gravity or other \
         motion that keeps the sides together"
    )]
    EndlessContact {
        /// Time reached, s.
        time: f64,
    },
    /// A closure or held point between a floating mechanism and the ground.
    #[error(
        "impact in time: a closure or a held point connects a mechanism with a floating base to the ground; expected a fixed base, \
         or a joint between the ground and the mechanism"
    )]
    GroundedBase,
    /// A spring at a joint without exactly one velocity.
    #[error("joint \"{joint}\" does not have exactly one velocity; a spring requires a hinge or a slide")]
    SpringJoint {
        /// The joint.
        joint: String,
    },
    /// A number of a spring is out of range.
    #[error(
        "joint \"{joint}\": a spring with the stiffness {stiffness} (N·m/rad or N/m), the damping {damping} (N·m·s/rad or \
         N·s/m), the free position {free_position} (rad or m) and the drive {drive} (N·m or N); expected finite numbers, the first two of at \
         least 0"
    )]
    Spring {
        /// The joint.
        joint: String,
        /// Stiffness, N·m/rad or N/m.
        stiffness: f64,
        /// Damping, N·m·s/rad or N·s/m.
        damping: f64,
        /// Position without force, rad or m.
        free_position: f64,
        /// Force or moment of the drive, N·m or N.
        drive: f64,
    },
    /// A number of a spring between points is out of range.
    #[error(
        "a spring between points with the rate {rate} N/m, the free length {free_length} m and the drive {drive} N; expected finite numbers, the \
         first two of at least 0"
    )]
    PointSpring {
        /// Rate, N/m.
        rate: f64,
        /// Length without force, m.
        free_length: f64,
        /// Force of the drive, N.
        drive: f64,
    },
    /// A number of a support is out of range.
    #[error(
        "a support with the stiffness {rate} N/m, the damping {damping} N·s/m and the force {force} N; expected a direction of length 1 and \
         finite numbers of at least 0"
    )]
    Support {
        /// Stiffness, N/m.
        rate: f64,
        /// Damping, N·s/m.
        damping: f64,
        /// Force at the touch, N.
        force: f64,
    },
    /// The motion of an impact in time leads to a pose without a contact normal, or out of the range of numbers.
    #[error(
        "the motion of the impact leads to a pose at which the contact has no normal or the loops break; expected a stiffer contact"
    )]
    LostContact,
    /// The contact of a mechanism with free bushes has no mass, or its motion is not determined.
    #[error(
        "a motion without mass, stiffness and damping closes the gap of the mechanism with bushes; expected a mass at the contact, or a stiffness"
    )]
    MasslessContact,
    /// The mechanism with free bushes cannot be computed.
    #[error(transparent)]
    Compliance(#[from] ComplianceError),
    /// The mobility of the contacts cannot be computed.
    #[error(transparent)]
    Mobility(#[from] DelassusError),
    /// The contact is invalid.
    #[error(transparent)]
    Response(#[from] ResponseError),
    /// The reactions cannot be computed.
    #[error(transparent)]
    Reactions(#[from] ReactionError),
}
