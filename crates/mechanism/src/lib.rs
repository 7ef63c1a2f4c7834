//! What a mechanism is: links, joints, what closes loops, and the rules they must keep.
//!
//! A [`Mechanism`] is immutable and shared; it is made by a [`MechanismBuilder`], which does all the validation
//! and says what it found as [`Problem`]s. What is locked, held or floating belongs to an analysis, not to the
//! mechanism. This crate knows no files and no algorithms.

mod builder;
mod closure;
mod closure_check;
mod describe;
mod description;
mod inertia_check;
mod joint;
mod link;
mod mechanism;
mod names;
mod problem;
mod tree;

pub use builder::{Accept, BuildError, Built, MechanismBuilder};
pub use closure::{Closure, ClosureId, ClosureKind, Coupling, LoopFrame};
pub use description::{
    ClosureDescription, CouplingDescription, Inertial, JointDescription, LinkDescription, MimicDescription,
};
pub use joint::{Joint, JointId, JointKind, Limits, Mimic};
pub use link::{Geometry, Link, LinkId};
pub use mechanism::Mechanism;
pub use names::{NameKind, UnknownName, near_names};
pub use problem::{Problem, Severity, Subject};
