//! Model of a mechanism: links, joints, loop closures, and their validation.
//!
//! A [`Mechanism`] is immutable and shared. It is built by a [`MechanismBuilder`], which does all validation
//! and reports each finding as a [`Problem`]. Locked joints, held contacts and a floating base belong to an
//! analysis, not to the mechanism. This crate contains no file formats and no algorithms.

mod axis;
mod builder;
mod checks;
mod closure;
mod contact;
mod describe;
mod description;
mod inertial;
mod joint;
mod limits;
mod link;
mod mechanism;
mod name_mark;
mod names;
mod problem;
mod tree;

pub use builder::{BuildError, Built, MechanismBuilder};
pub use closure::{Closure, ClosureId, ClosureKind, Coupling, LoopFrame};
pub use contact::{ContactDescription, ContactKind, ContactNormal, NamedContact};
pub use description::{
    ClosureDescription, CouplingDescription, JointDescription, LinkDescription, MimicDescription,
};
pub use inertial::Inertial;
pub use joint::{Joint, JointId, JointKind, Limits, Mimic};
pub use link::{Geometry, Link, LinkId};
pub use mechanism::Mechanism;
pub use names::{NameKind, UnknownName, near_names};
pub use problem::{Accept, Problem, Severity, Subject};
