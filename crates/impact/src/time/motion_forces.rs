//! Forces in joints and loops that are caused by a motion alone.

use crate::motion::joint_rates::JointRates;
use crate::reactions::force_elements::SpringForces;
use crate::reactions::reaction::Reactions;
use crate::reactions::reaction_map::{ReactionBuffers, ReactionMap};

use crate::time::equations::MotionEquations;
use nalgebra::Vector3;
use percuss_dynamics::{LocatedContact, Pose};

/// Forces (N) and moments (N·m) in all joints and loops of a mechanism that moves with the rates `rates` without external forces. They are
/// quadratic in the rates (centrifugal, Coriolis and gyroscopic forces). `None` if the rates violate the constraints at the pose.
///
/// M u̇ + h = Aᵀλ with A u̇ = −Ȧ u. `contact`: any contact at the pose; no force acts at it.
pub fn forces_of_motion(pose: &Pose, contact: &LocatedContact, rates: &JointRates) -> Option<Reactions> {
    let (u, gravity) = (rates.coordinates(pose), Vector3::zeros());
    let change = MotionEquations::new(pose, SpringForces::default())
        .accelerations(pose, contact, &u, 0.0, &gravity)?;
    let (mut buffers, mut reactions) = (ReactionBuffers::default(), Reactions::none());
    let map = ReactionMap::new(pose);
    map.reactions_in_motion(pose, contact, 0.0, (&u, &change), &gravity, &mut buffers, &mut reactions);
    Some(reactions)
}
