//! Simscape Multibody: the Spatial Contact Force block.

use crate::exports::linear::Linear;
use crate::exports::simulators::simulated::{Given, SimulatedContact};
use crate::exports::{Export, ExportError, Facts, Request, Tool};
use crate::limits;

const TOOL: Tool = Tool::of(&FACTS);

pub(crate) const FACTS: Facts = Facts {
    name: "simscape",
    title: "Simscape Multibody",
    aliases: &["simscape-multibody", "matlab", "simulink"],
    law: "linear spring and damper, never pulling, faded in over a transition region",
    combines: "none: the values apply to the pair",
    measured: &[],
    caution: "for one closing speed; the automatic absolute tolerance is too large for small compressions",
    sources: &[
        "Simscape Multibody, reference page \"Spatial Contact Force\" (mathworks.com/help/sm/ref/spatialcontactforce.html)",
    ],
};

/// Stiffness k, damping c = 2ζ√(k m̄), transition region width w = accuracy/0.32 · v/ω.
///
/// f = s(x, w)(k x + b ẋ), never pulling, s rising from 0 to 1 with level ends over w. The documentation of the block
/// does not give s; integration with 3u²−2u³ gives a restitution that is too high by (0.12, 0.15, 0.15, 0.13, 0.06) w
/// ω/v for e = 0.1, 0.2, 0.3, 0.5, 0.8, up to w = 0.1 v/ω. The width uses half of the accuracy.
///
/// The other half is for the solver, at RelTol = accuracy/1000 and AbsTol = RelTol·v/ω. Not run in Simscape: SciPy's
/// BDF (of the kind of ode15s) and a trapezoidal rule with error control (ode23t), both started at the contact as by
/// zero-crossing detection, have an error of at most 5.4e-4, including the width, for e = 0.05 … 0.95, k = 1e5 and
/// 1e8 N/m, 2 kg, 0.03 … 3 m/s; with AbsTol 1e-6 the latter by 1.8e-3 (tests/external/contact/integrators.py).
pub(crate) fn export(request: &Request) -> Result<Export, ExportError> {
    let linear = Linear::of(request, TOOL)?;
    let damping = linear.damping(linear.ratio);
    let mut export = Export::new(TOOL);
    export.add_penetration("", linear.penetration(request.speed));
    export.set("Stiffness", linear.stiffness, "N/m");
    export.set("Damping", damping, "N·s/m");
    let mut text = format!(
        "% Spatial Contact Force, Normal Force > Method: Smooth Spring-Damper\n\
         contact_stiffness = {:?}; % N/m\n\
         contact_damping = {damping:?}; % N/(m/s)\n",
        linear.stiffness
    );
    match request.speed {
        Some(speed) => {
            let width = limits::SIMSCAPE_WIDEST.min(linear.accuracy / (2.0 * limits::SIMSCAPE_ERROR_PER_WIDTH)) * speed / linear.frequency;
            export.set("Transition Region Width", width, "m");
            text += &format!("contact_transition_width = {width:?}; % m\n");
            let relative = limits::SIMSCAPE_TOLERANCE * linear.accuracy;
            let absolute = relative * speed / linear.frequency;
            export.set("RelTol", relative, "");
            export.set("AbsTol", absolute, "m");
            text += &format!(
                "set_param(gcs, 'Solver', 'ode15s', 'RelTol', '{relative:?}', 'AbsTol', '{absolute:?}', 'AutoScaleAbsTol', 'off');\n"
            );
            export.error_bound = Some(linear.accuracy);
            export.add_assumption(format!(
                "The transition region is for approach at {speed:?} m/s; slower impacts bounce higher."
            ));
        }
        None => export.missing.push(
            "closing speed, m/s: the transition region must be thin compared with the compression, speed over ω",
        ),
    }
    export.add_snippet("MATLAB", "matlab", text);
    export.add_assumption(
        "ode15s or ode23t with the tolerances given, and the block's zero-crossing detection on.",
    );
    export.add_assumption(
        "The block's smoothing function is not published; a cubic was assumed. Not measured in Simscape: the error is that of other \
         integrators of these kinds.",
    );
    export.add_assumption("Friction off.");
    Ok(export)
}

/// Contact of given parameters.
pub(crate) fn simulated(given: &mut Given) -> Result<Vec<SimulatedContact<'static>>, ExportError> {
    let (stiffness, damping) = (given.positive("Stiffness")?, given.number("Damping")?);
    for name in ["Transition Region Width", "RelTol", "AbsTol"] {
        given.optional(name)?;
    }
    Ok(vec![SimulatedContact::explicit(given, stiffness, damping, None)?])
}
