#![doc = include_str!("../README.md")]
//!
//! [`Conditions`] (base, locks, held contacts, armatures) and a [`Mechanism`](percuss_mechanism::Mechanism) are
//! compiled into a [`System`]. Closing the loops of a system gives an [`Assembly`]. An assembly at a
//! [`Configuration`] gives a [`Pose`]. A pose and a [`Contact`] give a [`ContactResponse`]. All of these are values: the
//! same call always returns the same result, regardless of earlier calls.

mod analysis;
mod batch;
mod dense;
mod error;
mod kernels;
mod kinematics;
mod linear;
mod loops;
mod mobility;
mod model;
mod motion;
mod recursion;
mod tolerances;

pub use analysis::assembly::{Assembly, DrawnGap};
pub use analysis::certificate::{
    BranchProof, CertifiedTree, ExtremeBracket, ExtremesCertificate, MassCertificate, NoCertificate,
    RangeProof,
};
pub use analysis::compliance::elements::{ElasticDirection, ElementMotion, LinearElement};
pub use analysis::compliance::joint_forces::JointForce;
pub use analysis::compliance::modes::Mode;
pub use analysis::compliance::residual::{ResidualCompliance, RowShare};
pub use analysis::compliance::response::Receptance;
pub use analysis::compliance::statics::{Load, StaticDisplacement, StaticSystem};
pub use analysis::compliance::system::{ComplianceError, ElasticSystem};
pub use analysis::compliance::transient::{ElasticInput, ElasticMotion, ElasticOutput, ElasticRowOutput};
pub use analysis::pose::{Pose, PoseRank};
pub use analysis::response::{ContactResponse, Contributions};
pub use analysis::rigid_loops::{DepartingAxis, RigidLoops};
pub use analysis::system::System;
pub use batch::contact_map::{ContactColumns, ContactMap, MapAnswers, MapError, PrincipalMass};
pub use batch::driven_path::{DrivenPath, PathAnswer};
pub use batch::error::BatchError;
pub use batch::row_inputs::{BatchContacts, BatchPositions, BatchRows, GivenPositions};
pub use batch::row_path::{RowAnswer, RowHandler, RowPath};
pub use batch::row_results::{BatchAnswer, ContactStatus, RowColumns, RowResults};
pub use batch::rows::Batch;
pub use batch::workspace::{ResponseAtPose, Workspace, WorkspaceResponse};
pub use dense::matrices::{
    ConstraintRank, LayoutError, MatrixError, MatrixName, MatrixOptions, MatrixResponse, MatrixView,
    RegularMatrices, effective_mass,
};
pub use error::budget::ErrorBudget;
pub use kinematics::contact::{Contact, ContactError, ContactPart, Direction, Frame, LocatedContact};
pub use kinematics::gap::Gap;
pub use kinematics::outcome::{
    DenseReason, EffectiveMass, Remark, ResponseError, Route, RouteChoice, RouteError,
};
pub use kinematics::remarks::RemarkFlags;
pub use linear::determined_system::DeterminedSystem;
pub use loops::assembling::{AssemblyError, LoopState};
pub use mobility::Singularity;
pub use model::conditions::{Base, ConditionOfJoint, Conditions, ConditionsError};
pub use model::configuration::{Configuration, ConfigurationError};
pub use model::input;
pub use model::interruption;
pub use model::velocities::StateSizeError;
pub use motion::constraint_action::{ConstraintAction, ConstraintGroup, ConstraintSource};
pub use motion::forward_dynamics::{Accelerations, PointForce};
pub use motion::limits::BranchLimits;
pub use motion::mass_gradient::MassGradient;
pub use motion::nearby_designs::{NearbyDesigns, PoseCondition};
pub use motion::operational_inertia::InverseOperationalInertia;
pub use motion::points::lowest_point::LowestPoint;
pub use motion::points::point_velocity::PointVelocity;
pub use motion::travel::{Travel, TravelError};
