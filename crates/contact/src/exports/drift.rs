//! Effect of a changing effective mass on the restitution.

use super::{Export, Request};

/// Adds the effect of the request's [`MassDrift`](super::MassDrift) to the error bound: δ (ln(1/e) + 1) e/2, δ the
/// relative change of m̄ over the tool's own penetration.
///
/// First term: e = f(ζ) with ζ ∝ 1/√m̄, and |de/d ln m̄| ≤ e ln(1/e)/2 for the linear spring and damper; the term is the effect
/// of the deepest m̄ during the whole impact. Second term: change δ/2 of the speed between the end of the force and the
/// closed gap. Integration with m̄ linear in the penetration gives at most 0.55 of the first term for e = 0.05 to 0.9.
/// The penetration of rigid contacts is the travel of one time step.
///
/// Returns the export and the effect of the drift.
pub(super) fn add_drift_error(request: &Request, mut export: Export) -> (Export, f64) {
    let (Some(drift), Some(bound)) = (request.options.drift, export.error_bound) else {
        return (export, 0.0);
    };
    let travel = request.speed.zip(export.time_step).map(|(speed, step)| speed * step);
    let own = export.penetrations.iter().map(|p| p.value).reduce(f64::max).or(travel);
    let ratio = own.map_or(1.0, |own| own / drift.penetration);
    // m̄ changes with the penetration or, at a stationary value, with its square.
    let change = drift.relative.abs() * if ratio > 1.0 { ratio * ratio } else { ratio };
    let e = request.restitution;
    let effect = if e > 0.0 { change * (1.0 - e.ln()) * e / 2.0 } else { 0.0 };
    export.error_bound = Some(bound + effect);
    if effect > 0.0 {
        export.add_assumption(format!(
            "The effective mass changes by {:.1e} (relative) over the compression; {effect:.1e} of the stated error is for that.",
            change
        ));
    }
    (export, effect)
}
