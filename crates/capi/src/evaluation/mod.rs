//! Effective masses of contacts: at a pose, in a workspace, in a batch.

pub(crate) mod batch;
pub(crate) mod contact;
pub(crate) mod contact_map;
pub(crate) mod derivatives;
pub(crate) mod impact;
pub(crate) mod path;
pub(crate) mod pose;
pub(crate) mod response;
#[cfg(feature = "suspensions")]
pub(crate) mod touch;
pub(crate) mod workspace;
