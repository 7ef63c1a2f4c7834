//! Results over ranges of joint positions and paths: extreme effective masses, reflected inertia of a driver.

pub(crate) mod bearing_load;
pub(crate) mod extreme_question;
pub(crate) mod extremes;
pub(crate) mod extremes_error;
mod kept_points;
pub(crate) mod mimic_substitute;
mod path;
mod quasi_newton;
pub(crate) mod reflected;
pub(crate) mod reflected_range;
mod search;
mod self_motion;
mod varied_contact;
