//! Programs for multibody dynamics.

pub(in crate::exports) mod adams;
pub(in crate::exports) mod chrono;
pub(in crate::exports) mod drake;
pub(in crate::exports) mod exudyn;
pub(in crate::exports) mod opensim;
pub(in crate::exports) mod simscape;
