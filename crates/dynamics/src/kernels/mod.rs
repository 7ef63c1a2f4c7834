//! Compiled kernels, evaluated for one configuration or for SIMD lanes.

pub(crate) mod aligned;
pub(crate) mod derivative_kernel;
pub(crate) mod estimate;
pub(crate) mod lane_kernel;
pub(crate) mod loop_kernel;
pub(crate) mod massless_root;
pub(crate) mod tree_kernel;
