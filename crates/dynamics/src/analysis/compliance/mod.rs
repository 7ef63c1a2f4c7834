//! Compliance: a mechanism at a pose with elastic bushes in place of ideal joints.
//!
//! Coordinates z of the null space N of the ideal rows, u = N z, with M, K, C and j reduced by it. K and C are sums over the rows of the
//! elastic elements, kᵢ bᵢᵀbᵢ and cᵢ bᵢᵀbᵢ. Sources: Ewins, Modal Testing, 2000, §2 (receptance); Craig, Kurdila, Fundamentals of
//! Structural Dynamics, 2006, §12 (inertia relief, residual flexibility); cited from memory.

pub(crate) mod elements;
pub(crate) mod joint_forces;
pub(crate) mod modes;
pub(crate) mod residual;
pub(crate) mod response;
pub(crate) mod statics;
mod subspace;
pub(crate) mod system;
pub(crate) mod transient;
