//! Rigid contacts of mechanisms: the mechanism moves on within the time step of the impact.

use super::{Export, Request};
use crate::limits;

/// Reason of a missing error bound.
pub(super) const SPEED_MISSING: &str =
    "approach speed, m/s: the error of a mechanism is in proportion to its travel in a time step";

/// The request's time step; for a mechanism without one, the step of which half of the accuracy is the error of
/// [`travel_error`]. `None` for a free body, and without a speed.
pub(super) fn time_step(request: &Request) -> Option<f64> {
    let travel = request.options.accuracy / (2.0 * (1.0 + request.restitution) * limits::RIGID_CURVATURE);
    let recommended = || Some(travel / request.speed.filter(|_| request.jointed() == Some(true))?);
    request.options.time_step.or_else(recommended)
}

/// Effect of a mechanism's motion within a step on the restitution: (1 + e) κ v h, κ = 10/m.
///
/// The closing speed of a mechanism that moves freely changes by about v² h over a length of it. Solvers in maximal coordinates
/// move a centre of mass along a straight line in a step: one hinge, with the centre of mass at a distance y from the line from
/// hinge to contact, l long, costs e v h y/l² (Jolt, 14 levers: within 10 % of that).
/// `None` if the step or the speed is unknown.
pub(super) fn travel_error(request: &Request, step: Option<f64>) -> Option<f64> {
    if request.jointed() == Some(true) {
        let travel = request.speed? * step?;
        return Some((1.0 + request.restitution) * limits::RIGID_CURVATURE * travel);
    }
    Some(0.0)
}

/// The condition of [`travel_error`].
pub(super) fn assume_travel(export: &mut Export, request: &Request) {
    if request.jointed() == Some(false) {
        return;
    }
    let stated = match export.time_step.zip(request.speed) {
        Some((step, speed)) if request.jointed() == Some(true) => {
            format!(
                " ({:.1e} here, in the stated error)",
                (1.0 + request.restitution) * limits::RIGID_CURVATURE * speed * step
            )
        }
        _ => " (not in the stated error, which is for a free body)".to_owned(),
    };
    export.assume(format!(
        "A mechanism moves on within the step of the impact: up to (1 + e)·v·h/L{stated}, v the speed, h the step, L = 0.1 m or more the \
         lengths l²/y of the mechanism (l from hinge to contact, y from the centre of mass to that line)."
    ));
}
