//! Validation of the numbers of positions and velocities.

use percuss_mechanism::Mechanism;

/// Error of positions or velocities that do not fit the mechanism.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum StateSizeError {
    /// The number of lists differs from the number of joints.
    #[error(
        "velocities of {got} joints are given, the mechanism has {expected}: one list a joint, in joint order"
    )]
    Joints {
        /// Number of given lists.
        got: usize,
        /// Number of joints.
        expected: usize,
    },
    /// A list has the wrong length.
    #[error("joint \"{joint}\" has {expected} velocities; {got} are given")]
    VelocityCount {
        /// The joint.
        joint: String,
        /// Number of given velocities.
        got: usize,
        /// Number of velocities of the joint.
        expected: usize,
    },
    /// The number of positions is wrong.
    #[error("{got} positions are given, the mechanism has {expected}")]
    PositionCount {
        /// Number of given positions.
        got: usize,
        /// Number of positions of the mechanism.
        expected: usize,
    },
}

/// Checks for one list of velocities per joint, each of the correct length.
pub(crate) fn check_velocities<V: AsRef<[f64]>>(
    mechanism: &Mechanism,
    velocities: &[V],
) -> Result<(), StateSizeError> {
    let (got, expected) = (velocities.len(), mechanism.joints().len());
    if got != expected {
        return Err(StateSizeError::Joints { got, expected });
    }
    for (joint, v) in mechanism.joints().iter().zip(velocities) {
        let (got, expected) = (v.as_ref().len(), joint.kind().dofs());
        if got != expected {
            return Err(StateSizeError::VelocityCount { joint: joint.name().to_owned(), got, expected });
        }
    }
    Ok(())
}

/// Checks the number of positions.
pub(crate) fn check_positions(got: usize, expected: usize) -> Result<(), StateSizeError> {
    if got == expected { Ok(()) } else { Err(StateSizeError::PositionCount { got, expected }) }
}
