//! Effect of single precision on the restitution.

use super::{Export, ExportError, Request, Tool};
use crate::limits;

/// Error of the restitution r/(v h), r = 1.5e-8 m: positions are rounded at every step, a coordinate from 0.25 to 0.5
/// m by up to r. In successive steps of nearly constant travel v h the rounding is the same, so the relative error of
/// the travel is r/(v h).
///
/// Measured on levers with the hinge at the origin (k = 1e4 to 6e5 N/m, 0.03 to 1.8 m/s), as a part of this error:
/// Bullet 3.24 0.4; PhysX 5 with TGS, h the step of one position iteration, 0.5. `None` without a speed.
pub(super) fn error(request: &Request, step: f64) -> Option<f64> {
    Some(limits::SINGLE_PRECISION_ROUNDING / (request.speed? * step))
}

/// Adds [`error`] at the step `step` to the error bound of an export, with the condition. Error: the sum is above 0.1.
pub(super) fn add(
    export: &mut Export,
    tool: Tool,
    request: &Request,
    step: f64,
    coordinate: &str,
) -> Result<(), ExportError> {
    let Some(single) = error(request, step) else {
        export.error_bound = None;
        export.missing.push("closing speed: what single precision adds to the error depends on it");
        return Ok(());
    };
    let Some(bound) = export.error_bound else { return Ok(()) };
    if bound + single > *limits::ACCURACIES.end() {
        return Err(ExportError::Unreachable {
            tool,
            restitution: request.restitution,
            why: "in a time step the contact travels so little that the rounding of single precision (1.5e-8 m at 0.25 to 0.5 m) alone \
                  can change the restitution by 0.1",
            remedy: "use a higher speed, a lower stiffness or a longer time step, or choose a tool with double \
                precision",
        });
    }
    export.error_bound = Some(bound + single);
    export.add_assumption(format!(
        "Single precision: coordinates of 0.25 to 0.5 {coordinate} are rounded by 1.5e-8 {coordinate}; over the travel in a time step that is \
         {single:.1e}, which is a part of the stated error. The error is proportional to the coordinates: place \
         the contact near the origin."
    ));
    Ok(())
}
