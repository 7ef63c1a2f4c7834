//! Tables of a question: the only description of its parts. Each key is a key of studies, and a flag of the command line unless it
//! says `arg(skip)`; its documentation is the help of the flag and the description in the JSON schema.

pub(crate) mod contact;
pub(crate) mod damping;
pub(crate) mod exports;
pub(crate) mod extremes;
#[cfg(feature = "flags")]
pub mod headings;
pub(crate) mod impact;
pub(crate) mod kinematics;
pub(crate) mod map;
pub(crate) mod mass;
pub(crate) mod model;
pub(crate) mod restitution;
pub(crate) mod safe_speed;
pub(crate) mod sweep;
