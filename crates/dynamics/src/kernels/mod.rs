//! Compiled kernels, evaluated for one configuration or for SIMD lanes.

pub(crate) mod aligned;
pub(crate) mod estimate;
pub(crate) mod lanes;
pub(crate) mod linkage;
pub(crate) mod own_axes;
