//! Reactions to a unit impulse at a contact.

use crate::reactions::reaction::Reactions;
use crate::reactions::reaction_map::{ReactionError, ReactionMap};
use percuss_dynamics::{ContactResponse, Pose};

/// Reactions in all joints, closures and held contacts to a unit impulse (1 N·s) at the contact of a response: those of a
/// [`ReactionMap`] at the pose, for a single contact.
///
/// # Errors
/// [`ReactionError`]: a massless contact; a response of another mechanism.
pub fn reactions_to_unit_impulse(
    pose: &Pose,
    response: &ContactResponse,
) -> Result<Reactions, ReactionError> {
    if response.joint_velocities.len() != pose.mechanism().joints().len() {
        return Err(ReactionError::ForeignResponse);
    }
    ReactionMap::new(pose).reactions(response, 1.0)
}
