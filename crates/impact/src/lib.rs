//! Rigid impacts of mechanisms: impulse, rates after the impact, and reactions in all joints and loop closures.
//!
//! A [`Pose`](percuss_dynamics::Pose) and a [`ContactResponse`](percuss_dynamics::ContactResponse) give the
//! [`Reactions`] to a unit impulse at the contact. With a closing speed and a coefficient of restitution e,
//! [`RigidImpact`] has the impulse p = (1+e) m̄ c, the rates after the impact q̇⁺ = q̇⁻ − (1+e) c v*, and the energy
//! loss ½ m̄ (1−e²) c². Trees and loops, redundant constraints, massless links, fixed and floating bases are covered.
//! Components of a reaction that redundant constraints leave open are reported as [`Component::Indeterminate`].
//!
//! Contacts of one relative motion may have Coulomb [`Friction`]. The impact is instantaneous: gravity, springs and
//! dampers have no effect. This crate reads no files and contains no contact laws.

mod error;
mod friction;
mod group_rows;
mod motion;
mod percussion;
mod reactions;
mod reflected;
mod rigid_impact;
mod tolerances;

pub use error::ImpactError;
pub use friction::Friction;
pub use motion::driver_rates::{DriverRate, RatesError, rates_from_drivers};
pub use motion::joint_rates::JointRates;
pub use percussion::{
    PercussionCentre, PercussionError, centre_of_percussion, centre_of_percussion_in_plane,
};
pub use reactions::reaction::{Component, DriveImpulse, JointReaction, Reaction, Reactions};
pub use reactions::unit_impulse::{ReactionError, reactions_to_unit_impulse};
pub use reflected::{ReflectedError, ReflectedInertia, held_point_mass, reflected_inertia};
pub use rigid_impact::{RigidImpact, closing_speed, greatest_closing_speed};
