//! Frames of a model: links, joints, named frames and models, and their poses as drawn.

pub(crate) mod poses;
pub(crate) mod scopes;
pub(crate) mod walk;
