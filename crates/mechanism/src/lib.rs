#![doc = include_str!("../README.md")]
//!
//! A [`Mechanism`] is shared. It is built by a [`MechanismBuilder`], which does all validation and reports each finding as a [`Problem`].

mod axis;
mod builder;
mod checks;
mod describe;
mod elements;
mod limits;
mod mechanism;
mod names;
mod problem;
mod released;
mod tree;

pub use builder::{BuildError, Built, MechanismBuilder};
pub use elements::bush::{Bush, BushDescription};
pub use elements::closure::{Closure, ClosureId, ClosureKind, LoopFrame};
pub use elements::contact::{ContactDescription, ContactKind, ContactNormal, NamedContact};
pub use elements::coupling::{Coupling, Curve, LinkRatio};
pub use elements::description::{
    ClosureDescription, CouplingDescription, CurveDescription, JointDescription, LinkDescription,
    MimicDescription, RelationDescription,
};
pub use elements::inertial::Inertial;
pub use elements::joint::{ElasticGear, Joint, JointId, JointKind, Limits, Mimic, SpringDamper};
pub use elements::link::{Geometry, Link, LinkId};
pub use mechanism::Mechanism;
pub use names::{NameKind, UnknownName, near_names};
pub use problem::{Accept, Problem, Severity, Subject};
