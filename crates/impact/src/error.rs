//! Errors of an impact.

use crate::reactions::unit_impulse::ReactionError;

/// Error of an impact.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
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
    /// Friction at a contact with several relative motions.
    #[error(
        "friction requires a contact whose sides have one relative motion, as a linkage of one degree of freedom; this \
         contact point can move in several directions"
    )]
    SeveralMotions,
    /// The reactions cannot be computed.
    #[error(transparent)]
    Reactions(#[from] ReactionError),
}
