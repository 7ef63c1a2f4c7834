//! What a mechanism is: links, joints, loop closures, and the rules they obey.
//!
//! A [`Mechanism`] is immutable and shared; it is made by a [`MechanismBuilder`], which does all the validation
//! and reports what it finds as [`Problem`]s. What is locked, held or floating belongs to an analysis, not to the
//! mechanism. This crate knows no files and no algorithms.

mod axis;
mod builder;
mod check;
mod closure;
mod closure_check;
mod describe;
mod description;
mod inertia_check;
mod inertial;
mod joint;
mod limits;
mod link;
mod mechanism;
mod name_mark;
mod names;
mod plausibility;
mod problem;
mod tree;

pub use builder::{Accept, BuildError, Built, MechanismBuilder};
pub use closure::{Closure, ClosureId, ClosureKind, Coupling, LoopFrame};
pub use description::{
    ClosureDescription, CouplingDescription, JointDescription, LinkDescription, MimicDescription,
};
pub use inertial::Inertial;
pub use joint::{Joint, JointId, JointKind, Limits, Mimic};
pub use link::{Geometry, Link, LinkId};
pub use mechanism::Mechanism;
pub use names::{NameKind, UnknownName, near_names};
pub use problem::{Problem, Severity, Subject};
