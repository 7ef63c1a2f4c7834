//! Effective mass of mechanisms at contacts.
//!
//! [`Conditions`] (base, locks, held contacts, armatures) and a [`Mechanism`](percuss_mechanism::Mechanism) are
//! compiled into a [`System`]. Closing the loops of a system gives an [`Assembly`]. An assembly at a
//! [`Configuration`] gives a [`Pose`]. A pose and a [`Contact`] give a [`ContactResponse`]: the effective mass, the
//! motion of the mechanism at unit closing speed, and the contribution of each link. All of these are values: the
//! same call always returns the same result, regardless of earlier calls.
//!
//! All poses are computed in the frame of the root link, also for a floating base. A mechanism ten kilometres from
//! the world's origin therefore loses no precision. This crate reads no files and contains no contact laws.

mod advance;
mod aligned;
mod answered;
mod assembling;
mod assembly;
mod batch;
mod careful;
mod closing;
mod closing_speed;
mod conditions;
mod configuration;
mod contact;
mod contact_map;
mod displacement;
mod driven_path;
mod error_budget;
mod forward_dynamics;
mod idle;
mod in_lanes;
pub mod input;
mod joint_motion;
mod kinematics;
mod limits;
mod linear;
mod linkage;
mod matrices;
mod mobility;
mod model;
mod operational_inertia;
mod outcome;
mod own_axes;
mod point_velocity;
mod pose;
mod posing;
mod recursion;
mod remarks;
mod response;
mod rigid_body;
mod rigid_loops;
mod routes;
mod rows;
mod singular;
mod stationary;
mod system;
mod tangent;
mod tolerances;
mod travel;
mod travel_search;
mod union;
mod velocities;
mod workspace;

pub use assembling::{AssemblyError, LoopState};
pub use assembly::{Assembly, DrawnGap};
pub use batch::{Batch, BatchAnswer, BatchError, BatchPositions};
pub use conditions::{Base, ConditionOfJoint, Conditions, ConditionsError};
pub use configuration::{Configuration, ConfigurationError};
pub use contact::{Contact, ContactError, ContactPart, Direction, Frame, LocatedContact};
pub use contact_map::{ContactColumns, ContactMap, ContactStatus, MapAnswers, MapError, PrincipalMass};
pub use driven_path::{DrivenPath, PathAnswer};
pub use error_budget::ErrorBudget;
pub use forward_dynamics::{Accelerations, PointForce};
pub use limits::BranchLimits;
pub use matrices::{
    ConstraintRank, LayoutError, MatrixError, MatrixName, MatrixOptions, MatrixResponse, MatrixView,
    effective_mass,
};
pub use mobility::Singularity;
pub use operational_inertia::InverseOperationalInertia;
pub use outcome::{CarefulReason, EffectiveMass, Remark, ResponseError, Route, RouteChoice, RouteError};
pub use point_velocity::PointVelocity;
pub use pose::{Pose, PoseRank};
pub use remarks::RemarkFlags;
pub use response::{ContactResponse, Contributions};
pub use rigid_loops::{DepartingAxis, RigidLoops};
pub use system::System;
pub use travel::{Travel, TravelError};
pub use velocities::VelocityError;
pub use workspace::{ScalarWorkspace, Workspace};
