//! What a mechanism does when it is struck.
//!
//! [`Conditions`] (base, locks, armatures) compiled with a [`Mechanism`](percuss_mechanism::Mechanism) give a
//! [`System`]; a [`System`] at a [`Configuration`] gives a [`Pose`]; a pose and a [`Contact`] give a [`Strike`]:
//! the effective mass, the velocity field of the blow, and who carries the mass.
//!
//! All poses are taken in the frame of the root link, also where the base floats: nothing is lost when the whole
//! mechanism stands ten kilometres from the world's origin. This crate knows no files and no contact laws.

mod articulated;
mod conditions;
mod configuration;
mod contact;
mod forward_dynamics;
mod joint_motion;
mod kinematics;
mod least_energy;
mod loops;
mod mass_matrix;
mod motion;
mod operational_inertia;
mod pose;
mod push;
mod rigid_body;
mod strike;
mod support;
mod system;
mod tangent;
mod workspace;

pub use conditions::{Base, Conditions, ConditionsError};
pub use configuration::{Configuration, ConfigurationError};
pub use contact::{Contact, ContactError, Direction, Frame, LocatedContact};
pub use forward_dynamics::{Accelerations, PointForce};
pub use loops::assembly::AssemblyError;
pub use loops::freedom::{PoseRank, Singularity};
pub use loops::limits::BranchLimits;
pub use loops::posing::LoopState;
pub use motion::PointVelocity;
pub use operational_inertia::InverseOperationalInertia;
pub use pose::Pose;
pub use strike::{EffectiveMass, Remark, Route, RouteChoice, RouteError, Shares, Strike, StrikeError};
pub use system::System;
pub use workspace::Workspace;
