//! Spring of a tool in place of a force curve.

use super::curve;
use crate::exports::{Export, ExportError, Request, Tool, Value};
use crate::stepping::runge_kutta_step;
use crate::{CompliantContact, ContactLawError, Damper, Impact, Law, LawParameter, Separation, StiffnessLaw};

/// Steps of the integration of Adams' function over the time x_max/v.
const STEPS: f64 = 2000.0;

/// Parameters of a tool for a spring k xᵖ with the penetration of the force curve, which has Hunt–Crossley damping. Adams gets the exponent of
/// the force and the work of the curve at this penetration; the other tools their own exponent, 1 or 3/2. An assumption states the peak force.
pub(crate) fn export(tool: Tool, request: &Request) -> Result<Export, ExportError> {
    let Some(speed) = request.speed else {
        let why = "the spring in place of the force curve depends on it";
        return Err(ExportError::Missing { tool, what: LawParameter::Speed, why });
    };
    let (mass, curve) = (request.contact.mass(), request.contact.stiffness());
    let damper = |law: Law, contact: CompliantContact| {
        // The stops of these two pull until the joint is back.
        let pulls = request.options.stop.is_some() && [Tool::NEWTON, Tool::PHYSX].contains(&tool);
        let separation = if pulls { Separation::GapCloses } else { Separation::ForceVanishes };
        law.damper(contact, request.restitution, Some(speed), separation)
    };
    let law = |law: Law, contact: CompliantContact| -> Result<Impact, ContactLawError> {
        damper(law, contact)?.impact(contact, speed)
    };
    let of_curve = damper(Law::HuntCrossley, request.contact)?;
    let exact = of_curve.impact(request.contact, speed)?;
    let depth = exact.max_penetration;
    let StiffnessLaw::Curve(points) = curve else { return tool.export(request) };
    let work = points.work(0.0, depth);
    let best = (curve.force(depth) * depth / work - 1.0)
        .clamp(*CompliantContact::EXPONENTS.start(), *CompliantContact::EXPONENTS.end());
    let mut refused = None;
    for p in if tool == Tool::ADAMS { [best, best] } else { [1.0, 1.5] } {
        let replaced = |stiffness: f64| -> Result<(Request, Export), ExportError> {
            let contact = CompliantContact::new(mass, stiffness)?.with_exponent(p)?;
            let replaced = Request { contact, ..*request };
            Ok((replaced, tool.export(&replaced)?))
        };
        let guess = (p + 1.0) * work / depth.powf(p + 1.0);
        let found = replaced(guess).and_then(|(found, export)| match export.penetrations.first() {
            // The penetration of every tool is proportional to k^(−1/(p+1)).
            Some(given) => replaced(guess * (given.value / depth).powf(p + 1.0)),
            None => Ok((found, export)),
        });
        let (replaced, mut export) = match found {
            Err(error @ ExportError::Exponent { .. }) => {
                refused = Some(error);
                continue;
            }
            found => found?,
        };
        if export.penetrations.is_empty() {
            return Ok(export);
        }
        let peak = if tool == Tool::ADAMS {
            peak_of_impact_function(&export, mass, speed)
        } else if request.options.stop.is_some() {
            law(Law::KelvinVoigt, replaced.contact)?.peak_force
        } else {
            let contacts = tool.simulated(mass, &numbers(&export, request))?;
            let peaks = contacts.iter().map(|contact| contact.impact(mass, speed));
            let peaks = peaks.map(|impact| Ok(impact?.peak_force.unwrap_or(f64::NAN)));
            peaks.collect::<Result<Vec<f64>, ContactLawError>>()?.into_iter().fold(f64::NAN, f64::max)
        };
        let (stiffness, exponent) = replaced.power_law();
        let power = if exponent == 1.0 { String::new() } else { format!("^{exponent:.4}") };
        let error = 100.0 * (peak / exact.peak_force - 1.0);
        export.add_assumption(format!(
            "Not the force curve: a spring of {stiffness:.6e} N/m{power} with the penetration of the curve with Hunt-Crossley damping, \
             {:.3} mm at {speed:?} m/s, and with the required restitution. Its peak force is {peak:.1} N in place of {:.1} N ({error:+.1} %); \
             at another speed penetration and peak force are wrong.",
            1e3 * depth,
            exact.peak_force
        ));
        if let Damper::HuntCrossley { dissipation } = of_curve {
            curve::add_snippet(&mut export, points, dissipation);
        }
        return Ok(export);
    }
    Err(refused.unwrap_or(ExportError::Missing {
        tool,
        what: LawParameter::Stiffness,
        why: "the tool has no spring in place of the force curve",
    }))
}

/// Exported numbers that determine the impact in the tool.
fn numbers(export: &Export, request: &Request) -> Vec<(String, Vec<f64>)> {
    let is_read = |name: &str| name != "solref_standard" && !name.starts_with("equality_");
    let read = export.parameters.iter().filter(|parameter| is_read(parameter.name));
    let numbers = read.filter_map(|parameter| match &parameter.value {
        Value::Number(number) => Some((parameter.name.to_owned(), vec![*number])),
        Value::Numbers(numbers) => Some((parameter.name.to_owned(), numbers.clone())),
        Value::Word(_) => None,
    });
    let ratio = request.options.diagonal_ratio.filter(|_| export.tool == Tool::MUJOCO);
    numbers.chain(ratio.map(|ratio| ("diagonal_ratio".to_owned(), vec![ratio]))).collect()
}

/// Largest force of Adams' function at the exported parameters, N.
fn peak_of_impact_function(export: &Export, mass: f64, speed: f64) -> f64 {
    let number = |name| export.number(name).unwrap_or(f64::NAN);
    let (k, p, damping, ramp) = (number("stiffness"), number("exponent"), number("cmax"), number("d"));
    let force = |(x, v): (f64, f64)| {
        let part = (x / ramp).clamp(0.0, 1.0);
        k * x.max(0.0).powf(p) + damping * part * part * (3.0 - 2.0 * part) * v
    };
    let step = export.penetrations.first().map_or(f64::NAN, |depth| depth.value) / speed / STEPS;
    let (mut state, mut peak) = ((0.0, speed), 0.0f64);
    while state.1 > 0.0 {
        state = runge_kutta_step(state, step, &|state| (state.1, -force(state) / mass));
        peak = peak.max(force(state));
    }
    peak
}
