//! Contact laws and exports.

/// The laws of one spring and one damper.
mod closed_forms {
    mod durations;
    mod history;
    mod hunt_crossley;
    mod integration;
    mod kelvin_voigt;
}

/// Parameters for simulators.
mod exports {
    mod measured;
    mod simulated;
    mod snippets;
    mod stops;
}

mod conditions;
mod errors;
mod extremes;
mod identification;
mod laws;
mod on_curves;
mod support;
mod transient_contact;
mod varying_mass;
