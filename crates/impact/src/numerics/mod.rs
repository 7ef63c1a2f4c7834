//! Integration of ordinary differential equations, and the QR decomposition of small matrices.

pub(crate) mod extrapolation;
pub(crate) mod multistep;
pub(crate) mod pivoted_qr;
pub(crate) mod runge_kutta;
