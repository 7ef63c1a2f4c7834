//! Rigid contacts of mechanisms: the mechanism moves within the time step of the impact.

use super::{Export, Request};
use crate::limits;

/// Reason of a missing error bound.
pub(super) const SPEED_MISSING: &str =
    "closing speed, m/s: the error of a mechanism is proportional to the travel in a time step";

/// Time step of the request. For a mechanism without a requested step: the step at which [`travel_error`] is half of
/// the accuracy, with a travel of [`limits::RIGID_TRAVEL`] at most. `None` for a free body and without a speed.
pub(super) fn time_step(request: &Request) -> Option<f64> {
    let recommended = || {
        let speed = request.speed.filter(|_| request.is_jointed() == Some(true))?;
        let travel = request.options.accuracy / (2.0 * (1.0 + request.restitution) * curvature(request));
        Some(travel.min(limits::RIGID_TRAVEL) / speed)
    };
    request.options.time_step.or_else(recommended)
}

/// Error of the restitution by the motion of a mechanism within a step: (1 + e) κ v h, κ the
/// [curvature of the motion](super::Options::motion_curvature).
///
/// The closing speed of a mechanism in free motion changes by at most about κ v² h in a step. Solvers in maximal
/// coordinates move a centre of mass along a straight line in a step: for a lever with the centre of mass at a distance
/// y from the line between hinge and contact, of length l, the error is e v h y/l² (Jolt, 14 levers, within 10 %), and
/// y/l² < κ. `None` if the step or the speed is unknown.
pub(super) fn travel_error(request: &Request, step: Option<f64>) -> Option<f64> {
    if request.is_jointed() == Some(true) {
        return Some((1.0 + request.restitution) * curvature(request) * request.speed? * step?);
    }
    Some(0.0)
}

/// Curvature κ of the motion, 1/m: that of the request, or a default for an unknown mechanism.
fn curvature(request: &Request) -> f64 {
    request.options.motion_curvature.unwrap_or(limits::RIGID_CURVATURE).max(limits::MIN_CURVATURE)
}

/// Adds the assumption that a mechanism moves little within the step, with the [`travel_error`]. A free body gets no assumption.
pub(super) fn add_travel_assumption(export: &mut Export, request: &Request) {
    if request.is_jointed() == Some(false) {
        return;
    }
    let length = 1.0 / curvature(request);
    let stated = match travel_error(request, export.time_step) {
        Some(error) if error > 0.0 => format!("{error:.1e} here, included in the stated error"),
        _ => "not included in the stated error, which is for a free body".to_owned(),
    };
    export.add_assumption(format!(
        "A mechanism moves within the step of the impact. Error of the restitution: up to (1 + e)·v·h/L ({stated}), v the \
         speed, h the step, L = {length:.2} m; for one hinge 1/L = 1/l + r/l², l the distance from the hinge to the contact, \
         r that to the centre of mass."
    ));
}
