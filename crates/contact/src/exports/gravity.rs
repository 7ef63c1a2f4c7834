//! Effect of gravity on a compliant contact.

use super::{Export, Request};
use crate::limits;

impl Request<'_> {
    /// Loss of restitution of a compliant contact by gravity along the normal: 1.2 ln(1/e) g/(v ω), g = 9.81 m/s², v/ω
    /// the penetration without damping.
    ///
    /// The weight of m̄ presses the contact during the impact and reduces the rebound. First-order approximation:
    /// integration of a linear contact with g/(v ω) = 0.01 gives 0.13, 0.27, 0.78, 1.33, 2.30 times g/(v ω) for e =
    /// 0.9, 0.8, 0.5, 0.3, 0.15; above g/(v ω) ≈ e/3 the body does not rebound.
    /// `None` without a speed, for e = 0 and for the stop of a joint.
    pub fn gravity_loss(&self) -> Option<f64> {
        let speed = self.speed.filter(|_| self.restitution > 0.0 && self.options.stop.is_none())?;
        let depth = self.contact.undamped_penetration(speed).ok()?;
        Some(1.2 * self.restitution.recip().ln() * limits::GRAVITY * depth / (speed * speed))
    }
}

/// Adds the assumption of an impact without gravity, with the loss of restitution by gravity; marks the export if the weight
/// prevents the rebound.
pub(super) fn add_assumption(request: &Request, export: &mut Export) {
    let Some(loss) = request.gravity_loss().filter(|_| !export.penetrations.is_empty()) else { return };
    let (accuracy, e) = (request.options.accuracy, request.restitution);
    let consequence = if loss <= accuracy {
        format!("the loss is smaller than the accuracy {accuracy:?}")
    } else if loss < e / 3.0 {
        format!(
            "a loss of at most {accuracy:?} needs {:.0} times the product of speed and √(stiffness/mass)",
            (loss / accuracy).ceil()
        )
    } else {
        "with gravity there is almost no rebound: use a faster impact or a stiffer contact".to_owned()
    };
    export.weight_prevents_rebound = loss >= e / 3.0 && loss > accuracy;
    export.add_assumption(format!(
        "No gravity along the normal during the impact: at 9.81 m/s² the weight reduces e by about 1.2·ln(1/e)·g/(v·ω) = {loss:.1e}; {consequence}."
    ));
}
