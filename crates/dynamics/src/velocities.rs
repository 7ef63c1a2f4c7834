//! Whether positions and velocities fit a mechanism.

use percuss_mechanism::Mechanism;

/// Positions or velocities that do not fit the mechanism.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum VelocityError {
    /// Not one list a joint.
    #[error(
        "velocities of {got} joints are given, the mechanism has {expected}: one list a joint, in joint order"
    )]
    Joints {
        /// How many lists were given.
        got: usize,
        /// How many joints there are.
        expected: usize,
    },
    /// A list of the wrong length.
    #[error("joint \"{joint}\" has {expected} velocities; {got} are given")]
    Count {
        /// The joint.
        joint: String,
        /// How many were given.
        got: usize,
        /// How many it has.
        expected: usize,
    },
    /// Not the mechanism's number of positions.
    #[error("{got} positions are given, the mechanism has {expected}")]
    Positions {
        /// How many were given.
        got: usize,
        /// How many there are.
        expected: usize,
    },
}

/// Refuses velocities that are not one list a joint, each of the joint's own length.
pub(crate) fn check_velocities<T>(mechanism: &Mechanism, velocities: &[Vec<T>]) -> Result<(), VelocityError> {
    let (got, expected) = (velocities.len(), mechanism.joints().len());
    if got != expected {
        return Err(VelocityError::Joints { got, expected });
    }
    for (joint, v) in mechanism.joints().iter().zip(velocities) {
        let (got, expected) = (v.len(), joint.kind().dofs());
        if got != expected {
            return Err(VelocityError::Count { joint: joint.name().to_owned(), got, expected });
        }
    }
    Ok(())
}

/// Refuses positions that are not as many as the mechanism's.
pub(crate) fn check_positions(got: usize, expected: usize) -> Result<(), VelocityError> {
    if got == expected { Ok(()) } else { Err(VelocityError::Positions { got, expected }) }
}
