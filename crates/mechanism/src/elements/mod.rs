//! Parts of a mechanism, and their descriptions for the builder.

pub(crate) mod bush;
pub(crate) mod closure;
pub(crate) mod contact;
pub(crate) mod coupling;
pub(crate) mod description;
pub(crate) mod inertial;
pub(crate) mod joint;
pub(crate) mod link;
