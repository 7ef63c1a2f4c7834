//! Closed-form solutions of the equation of motion: restitution and damping of the linear and the Hunt–Crossley damper, and of a loss factor.

pub mod hunt_crossley;
pub mod kelvin_voigt;
pub(crate) mod loss_factor;
