#![doc = include_str!("../README.md")]
//!
//! A [`Mechanism`] is compiled into a plan: a tree into a list of joint steps ([`tree`]), a linkage with closed loops into rows and their
//! elimination ([`loops`]). The same plan evaluates one configuration or several SIMD lanes.

mod aligned;
mod columns;
mod contact;
pub mod derivatives;
mod kernel;
pub mod loops;
mod mechanism;
pub mod tolerances;
pub mod tree;

pub use aligned::Aligned;
pub use columns::{CertifiedMass, LaneContacts, MassColumns, PositionColumns, WIDEST};
pub use contact::{Contact, ContactConversion, LinkFrame, Normal, NormalFrame};
pub use kernel::Kernel;
pub use mechanism::{
    Body, BodyDirection, BodyPoint, Cluster, ClusterVelocity, JointMotion, JointPosition, Linkage, Mechanism,
    Relation, RelationJoint, RowBlock, RowForm, RowTerm, Velocity,
};
