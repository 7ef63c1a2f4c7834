//! Effect of gravity on a compliant contact.

use super::{Export, ImpactFunction, Request};
use crate::limits;

impl Request {
    /// Restitution that gravity along the normal takes from a compliant contact: about 1.2 ln(1/e) g/(v ω), g = 9.81 m/s², v/ω the
    /// penetration without damping.
    ///
    /// The weight of m̄ presses the contact and shortens the rebound. Integrated for a linear contact with g/(v ω) = 0.01: 0.13, 0.27, 0.78,
    /// 1.33, 2.30 times g/(v ω) for e = 0.9, 0.8, 0.5, 0.3, 0.15; from g/(v ω) of about e/3 on there is no rebound.
    /// `None` without a speed, for e = 0 and for the stop of a joint.
    pub fn gravity_loss(&self) -> Option<f64> {
        let speed = self.speed.filter(|_| self.restitution > 0.0 && self.options.stop.is_none())?;
        let (mass, stiffness) = (self.contact.mass(), self.contact.stiffness());
        let depth =
            ImpactFunction::undamped_penetration(self.contact.exponent(), mass, stiffness, speed).ok()?;
        Some(1.2 * -self.restitution.ln() * limits::GRAVITY * depth / (speed * speed))
    }
}

/// The condition for a compliant contact without gravity.
pub(super) fn assume(request: &Request, export: &mut Export) {
    let Some(loss) = request.gravity_loss().filter(|_| !export.penetrations.is_empty()) else { return };
    let accuracy = request.options.accuracy;
    let condition = if loss <= accuracy {
        format!("it is below {accuracy:?} here")
    } else {
        format!(
            "the speed times √(stiffness/mass) must be {:.0} times as large for {accuracy:?}",
            (loss / accuracy).ceil()
        )
    };
    export.assume(format!(
        "No gravity along the normal during the impact: the weight takes about 1.2·ln(1/e)·g/(v·ω) = {loss:.1e} from e at 9.81 m/s²; {condition}."
    ));
}
