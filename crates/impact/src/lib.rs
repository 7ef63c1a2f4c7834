#![doc = include_str!("../README.md")]
//!
//! A [`Pose`](percuss_dynamics::Pose) and a [`ContactResponse`](percuss_dynamics::ContactResponse) give the
//! [`Reactions`] to a unit impulse at the contact. With a closing speed and a coefficient of restitution e,
//! [`RigidImpact`] has the impulse p = (1+e) m̄ c, the rates after the impact q̇⁺ = q̇⁻ − (1+e) c v*, and the energy
//! loss ½ m̄ (1−e²) c². Trees and loops, redundant constraints, massless links, fixed and floating bases are covered.
//! Components of a reaction that redundant constraints leave open are reported as [`Component::Indeterminate`].
//!
//! [`Friction`] describes Coulomb friction at one contact, with the laws of restitution of Stronge, Poisson and Newton. [`Delassus`] is
//! the mobility of several contact points. [`simultaneous_impact`] applies three laws of restitution to several contacts without
//! friction; [`sticking_impact`] computes the plastic impact with sticking points.
//!
//! A rigid impact is instantaneous: gravity, springs and dampers have no effect. [`impact_in_time`] integrates the motion with a given
//! contact force, with gravity, springs and dampers. This crate reads no files and contains no laws of compliant contacts.

mod error;
mod friction;
mod group_rows;
mod mobility;
mod motion;
mod numerics;
mod percussion;
mod ranges;
mod reactions;
mod rigid;
mod several;
mod time;
mod tolerances;

pub use error::ImpactError;
pub use friction::collision::{frictional_collision, jamming_threshold, sticking_threshold};
pub use friction::impulse::{Friction, FrictionLaw, FrictionalCompression, LawResult};
pub use friction::phases::{Collision, Phase, PhaseKind, RestitutionLaw};
pub use friction::thresholds::{FrictionThresholds, friction_thresholds};
pub use mobility::delassus::{Delassus, DelassusError};
pub use motion::driver_rates::{DriverRate, RatesError, rates_from_drivers};
pub use motion::joint_rates::JointRates;
pub use motion::reachable_speed::{ReachableSpeed, reachable_closing_speed};
pub use percussion::{
    PercussionCentre, PercussionError, WorstReaction, centre_of_percussion, centre_of_percussion_in_plane,
    worst_reaction_within,
};
pub use ranges::extreme_question::{
    DriverPath, ExtremeKind, ExtremeMass, ExtremeOnPath, JointRange, KeptPoint, NormalRange, PeakForceLaw,
    SearchedContact, SearchedPoses, SearchedQuantity,
};
pub use ranges::extremes::{extreme_along_path, extreme_effective_mass, extreme_quantity};
pub use ranges::extremes_error::ExtremesError;
pub use ranges::mimic_substitute::{MimicJoint, MimicSubstitute, NoSubstitute};
pub use ranges::reflected::{
    ReflectedError, ReflectedInertia, driving_joints, driving_joints_with, held_point_mass,
    locked_body_masses, reflected_inertia, reflected_inertia_with,
};
pub use ranges::reflected_range::{
    RangeError, ReflectedRange, ReflectedSample, reflected_inertia_over, reflected_inertia_over_with,
};
pub use reactions::bearing::Bearing;
pub use reactions::force_elements::{JointSpring, PointSpring, Support};
pub use reactions::reaction::{
    Component, DriveImpulse, JointConstraint, JointConstraintReaction, JointReaction, Reaction, Reactions,
};
pub use reactions::reaction_map::{ReactionError, ReactionMap};
pub use reactions::unit_impulse::reactions_to_unit_impulse;
pub use rigid::impact::{
    RigidImpact, closing_speed, greatest_closing_speed, greatest_closing_speed_of_gears,
};
pub use rigid::workspace::{ImpactWorkspace, ImpactsAtPose};
pub use several::energetic::ContactStiffness;
pub use several::laws::{
    SimultaneousImpact, SimultaneousLaw, simultaneous_impact, simultaneous_impact_of_matrix,
};
pub use several::state_impact::{ContactsLaw, StateImpact, state_impact};
pub use several::sticking::{StickingContact, StickingImpact, sticking_impact};
pub use time::compliant::impact::{
    CompliantEnergy, CompliantImpact, CompliantLaw, CompliantSample, ContactEnd, ElementPeak, ForcesAtTouch,
    SecondHit, compliant_impact, compliant_impact_of, compliant_impact_with_forces,
};
pub use time::conditions::TimeConditions;
pub use time::history::{EnergyBalance, ImpactInTime, ImpactSample, SecondTouch, peak_over_time};
pub use time::impact_in_time::impact_in_time;
pub use time::motion_forces::forces_of_motion;
