//! Contact laws and exports.

mod conditions;
mod durations;
mod errors;
mod exports;
mod extremes;
mod history;
mod hunt_crossley;
mod integration;
mod kelvin_voigt;
mod laws;
mod measured;
mod stops;
mod support;
mod transient_contact;
mod varying_mass;
