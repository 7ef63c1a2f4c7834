//! The contact laws, one a file.

pub mod hunt_crossley;
pub mod kelvin_voigt;
