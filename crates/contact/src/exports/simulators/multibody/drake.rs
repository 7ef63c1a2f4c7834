//! Drake: point contact of `MultibodyPlant`, continuous (Hunt–Crossley) and discrete (SAP, lagged).

use crate::limits;
use std::f64::consts::PI;

use crate::exports::linear::Linear;
use crate::exports::simulators::simulated::{ContactModel, Given, SimulatedContact};
use crate::exports::{Export, ExportError, Facts, Measurement, Request, Tool};
use crate::{Damper, hunt_crossley};

const TOOL: Tool = Tool::of(&FACTS);

pub(crate) const FACTS: Facts = Facts {
    name: "drake",
    title: "Drake",
    aliases: &["sap"],
    law: "continuous and lagged: Hunt–Crossley k x (1 + d ẋ), never pulling; SAP: linear spring and damper",
    combines: "stiffnesses in series, dissipations by the share of the deformation, relaxation times added",
    measured: &[
        Measurement {
            engine: "Drake 1.58.0",
            solver: "continuous",
            scenes: "ball; pendulums with rotors",
            worst: [Some(1.0e-5), Some(1.3e-4), Some(3.2e-4)],
            by_hand: None,
        },
        Measurement {
            engine: "Drake 1.58.0",
            solver: "lagged",
            scenes: "ball; pendulums with rotors",
            worst: [Some(1.3e-4), Some(6.3e-4), Some(9.0e-4)],
            by_hand: None,
        },
        Measurement {
            engine: "Drake 1.58.0",
            solver: "sap",
            scenes: "ball; pendulums with rotors",
            worst: [Some(5.0e-4), Some(4.2e-4), Some(3.5e-4)],
            by_hand: None,
        },
    ],
    caution: "the relaxation time is for SAP at its step; continuous and lagged plants use the dissipation, \
        which is for one speed",
    sources: &[
        "Drake 1.51.1, multibody/plant/contact_model_doxygen.h, \"Modeling point contact\"",
        "Drake 1.51.1, multibody/plant/contact_properties.cc",
        "Drake 1.51.1, multibody/contact_solvers/sap/sap_friction_cone_constraint.cc",
    ],
};

/// For each of two equal geometries: point stiffness 2k, Hunt–Crossley dissipation d = a(e)/v, and for SAP the
/// relaxation time ζ'/ω, half of the pair's τ = c/k.
///
/// Drake combines k = k₁k₂/(k₁+k₂), d = (k₂d₁+k₁d₂)/(k₁+k₂), τ = τ₁+τ₂. SAP integrates max(0, −k φ − k τ v) by implicit
/// Euler, so ζ' = ζ − ωh/2.
///
/// Measured in Drake 1.51.1 at accuracy 1e-3, the worst of 25 phases for e = 0.05, 0.2, 0.5, 0.8, 0.95, 0.99:
/// continuous (runge_kutta3, accuracy 1e-3, greatest step 0.1/ω) 1e-10, 1.4e-5, 1.1e-4, 2.4e-4, 3.2e-4, 3.5e-4;
/// discrete lagged 1e-6, 1.2e-4, 6.2e-4, 8.9e-4, 9.7e-4, 9.9e-4; SAP 5.9e-4, 5.1e-4, 4.2e-4, 3.6e-4, 2.9e-4, 1e-5.
/// Pendulums with rotor inertia the same. With the 1.5 kg of the contact link alone for m̄ = 6.19 kg SAP shows 0.395,
/// 0.693, 0.894 for 0.2, 0.5, 0.8; continuous and lagged plants need no m̄ for the restitution. With a greatest step
/// of 10/ω the error of this integrator is 1.6e-2 at accuracy 1e-3 and 1.4e-4 at 1e-5; runge_kutta5 can step over the
/// contact; the error of implicit_euler is 2e-2 at 1e-5. Lagged and similar lose 0.001, 0.04, 0.48, 1.10, 1.45 ωh for
/// e = 0.1, 0.2, 0.5, 0.8, 0.95: below (π/2)e ωh. SAP's step: [`Linear::implicit_error_bound`].
pub(crate) fn export(request: &Request) -> Result<Export, ExportError> {
    let linear = Linear::of(request, TOOL)?;
    let mut export = Export::new(TOOL);
    let stiffness = 2.0 * linear.stiffness;
    export.set("point_contact_stiffness", stiffness, "N/m");
    let number = hunt_crossley::dissipation_number(request.restitution)?;
    let dissipation = request.speed.map(|speed| number / speed);
    match dissipation {
        Some(d) => export.set("hunt_crossley_dissipation", d, "s/m"),
        None => export.missing.push(
            "closing speed, m/s: the dissipation of continuous and lagged plants is proportional to 1/speed",
        ),
    }
    let relaxation = set_discrete_parameters(&mut export, &linear, request.options.time_step)?;
    if relaxation.is_some() {
        export.add_penetration("SAP", linear.penetration(request.speed));
    }
    if let Some((d, speed)) = dissipation.zip(request.speed) {
        let impact = Damper::hunt_crossley(d).and_then(|damper| damper.impact(request.contact, speed));
        export.add_penetration("continuous, lagged", impact.ok().map(|impact| impact.max_penetration));
    }
    set_integrator(&mut export, request, &linear);
    add_snippets(&mut export, stiffness, dissipation, relaxation);
    add_assumptions(&mut export, request, number);
    Ok(export)
}

/// Sets the parameters of discrete plants. Returns the relaxation time of each geometry; `None` if SAP cannot reach e.
fn set_discrete_parameters(
    export: &mut Export,
    linear: &Linear,
    requested: Option<f64>,
) -> Result<Option<f64>, ExportError> {
    let lagged = requested.unwrap_or_else(|| linear.lagged_step());
    export.set("time_step_lagged", lagged, "s");
    let step = linear.implicit_step();
    let ratio = match linear.implicit_ratio(step) {
        Ok(ratio) => ratio,
        Err(ExportError::Unreachable { .. }) => {
            export.cannot.push("SAP with restitution 1: implicit Euler has numerical damping at every step");
            return Ok(None);
        }
        Err(error) => return Err(error),
    };
    let relaxation = ratio / linear.frequency;
    export.set("relaxation_time", relaxation, "s");
    export.set("time_step_sap", step, "s");
    export.time_step = Some(step);
    let (sap, lagged_error) = (linear.implicit_error_bound(step), linear.lagged_error(lagged));
    export.error_bound = Some(sap.max(lagged_error));
    export.add_assumption(linear.implicit_assumption(step));
    export.add_assumption(format!(
        "The stated error is the greater of SAP's at {step:?} s, {sap:.1e}, and of that of lagged and similar at {lagged:?} s, {lagged_error:.1e}."
    ));
    export.add_assumption(format!(
        "A discrete plant with the lagged or similar approximation (lagged is Drake's default) loses up to \
         (π/2)·e·ωh of the restitution, {:.1e} at {lagged:?} s, and cannot be corrected by another dissipation.",
        linear.lagged_error(lagged)
    ));
    Ok(Some(relaxation))
}

impl Linear {
    /// Error bound of Hunt–Crossley with implicit Euler: (π/2) e ωh.
    fn lagged_error(&self, time_step: f64) -> f64 {
        PI / 2.0 * self.restitution * self.frequency * time_step
    }

    /// Time step at which [`Self::lagged_error`] equals the accuracy.
    fn lagged_step(&self) -> f64 {
        self.accuracy * (2.0 / PI) / self.restitution / self.frequency
    }
}

/// Sets accuracy and greatest step of the integrator of a continuous plant.
fn set_integrator(export: &mut Export, request: &Request, linear: &Linear) {
    let accuracy = request.options.accuracy;
    let largest =
        limits::LONGEST_STEP * (accuracy / limits::DEFAULT_ACCURACY).sqrt().min(1.0) / linear.frequency;
    export.set("integration_scheme", "runge_kutta3", "");
    export.set("accuracy", accuracy.min(limits::DRAKE_ACCURACY), "");
    export.set("max_step_size", largest, "s");
    export.add_assumption(format!(
        "A continuous plant is integrated by runge_kutta3 in steps of at most {largest:?} s: error control \
         alone detects the contact too late, and schemes of higher order can step over the contact."
    ));
}

/// Adds the snippets in Python and SDF.
fn add_snippets(export: &mut Export, stiffness: f64, dissipation: Option<f64>, relaxation: Option<f64>) {
    let largest = export.number("max_step_size").unwrap_or_default();
    let accuracy = export.number("accuracy").unwrap_or_default();
    let mut python = String::from(
        "from pydrake.geometry import AddContactMaterial, ProximityProperties\n\
         from pydrake.multibody.plant import CoulombFriction\n\
         from pydrake.systems.analysis import SimulatorConfig\n\n\
         # For both geometries of the pair.\n\
         properties = ProximityProperties()\n",
    );
    let d = dissipation.map_or_else(|| "0.0".to_owned(), |d| format!("{d:?}"));
    if dissipation.is_none() {
        python += "# Without the closing speed this is for SAP alone: continuous and lagged plants need a dissipation.\n";
    }
    python += &format!(
        "AddContactMaterial(\n    dissipation={d},\n    point_stiffness={stiffness:?},\n    \
         friction=CoulombFriction(0.0, 0.0),\n    properties=properties,\n)\n"
    );
    if let Some(tau) = relaxation {
        let step = export.time_step.unwrap_or_default();
        python += &format!(
            "# SAP only; with MultibodyPlantConfig(time_step={step:?}, discrete_contact_approximation=\"sap\").\n\
             properties.AddProperty(\"material\", \"relaxation_time\", {tau:?})\n"
        );
    }
    python += &format!(
        "# A continuous plant: ApplySimulatorConfig(config, simulator).\n\
         config = SimulatorConfig()\n\
         config.integration_scheme = \"runge_kutta3\"\n\
         config.accuracy = {accuracy:?}\n\
         config.max_step_size = {largest:?}\n"
    );
    export.add_snippet("pydrake", "python", python);
    let mut urdf = format!(
        "<drake:proximity_properties xmlns:drake=\"http://drake.mit.edu\">\n  \
         <drake:point_contact_stiffness value=\"{stiffness:?}\"/>\n"
    );
    let mut sdf = format!(
        "<drake:proximity_properties xmlns:drake=\"http://drake.mit.edu\">\n  \
         <drake:point_contact_stiffness>{stiffness:?}</drake:point_contact_stiffness>\n"
    );
    for (name, value) in [("hunt_crossley_dissipation", dissipation), ("relaxation_time", relaxation)] {
        if let Some(value) = value {
            urdf += &format!("  <drake:{name} value=\"{value:?}\"/>\n");
            sdf += &format!("  <drake:{name}>{value:?}</drake:{name}>\n");
        }
    }
    export.add_snippet("in a URDF's <collision>", "xml", urdf + "</drake:proximity_properties>\n");
    export.add_snippet("in an SDF's <collision>", "xml", sdf + "</drake:proximity_properties>\n");
}

/// Adds the assumptions and limitations.
fn add_assumptions(export: &mut Export, request: &Request, number: f64) {
    export.add_assumption(
        "Both geometries of the pair have these values. Against a much stiffer one, the soft one has half the \
         stiffness and the same dissipation, and all of the relaxation time, the stiff one 0.",
    );
    export.add_assumption(
        "Point contact (ContactModel.kPoint, or a pair without a hydroelastic representation).",
    );
    if let Some(speed) = request.speed {
        export.add_assumption(format!(
            "The dissipation is for approach at {speed:?} m/s (d·v = {number:?}); faster impacts bounce less. It does \
             not depend on the effective mass."
        ));
    }
    export.add_assumption(
        "penetration_allowance is not used: Drake derives a spring from the mass of the heaviest body, not from m̄.",
    );
    if request.options.constrained || request.options.closed_loops {
        export
            .cannot
            .push("constraints (loops, mimics, locks) in a continuous plant: its constraints are for discrete plants (SAP) only");
    }
}

/// Contact of given parameters.
pub(crate) fn simulated(given: &mut Given) -> Result<Vec<SimulatedContact<'static>>, ExportError> {
    let stiffness = given.positive("point_contact_stiffness")? / 2.0;
    let dissipation = given.optional("hunt_crossley_dissipation")?;
    let relaxation = given.optional("relaxation_time")?;
    let step = given.optional("time_step_sap")?;
    for name in ["time_step_lagged", "accuracy", "max_step_size"] {
        given.optional(name)?;
    }
    let mut found = Vec::new();
    if let Some(dissipation) = dissipation {
        let contact = given.contact(stiffness, 1.0)?;
        let model = ContactModel::Compliant(contact, Damper::hunt_crossley(dissipation)?);
        found.push(SimulatedContact::of(model).of_solver("continuous, lagged"));
    }
    if let Some(relaxation) = relaxation {
        let step =
            step.ok_or_else(|| given.refuse("time_step_sap", "it is required with relaxation_time"))?;
        let damping = 2.0 * relaxation * stiffness;
        found.push(SimulatedContact::implicit(given, stiffness, damping, step)?.of_solver("SAP"));
    }
    if found.is_empty() {
        let why = "it is required, or relaxation_time with time_step_sap";
        return Err(given.refuse("hunt_crossley_dissipation", why));
    }
    Ok(found)
}
