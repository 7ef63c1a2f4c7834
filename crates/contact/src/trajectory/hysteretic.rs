//! Impact on a contact with a loss factor, F = F_s(x) (1 + h sgn ẋ).
//!
//! The force is a multiple of that of the spring in each direction: the compression is that of the spring alone with the mass m̄/(1 + h), and
//! the expansion the same motion with all speeds multiplied by e.

use super::{State, Trajectory};
use crate::solutions::loss_factor::rebound;

pub(crate) struct Hysteretic<'a> {
    /// Motion on the spring alone with the mass m̄/(1 + h).
    elastic: Box<dyn Trajectory + 'a>,
    /// Unit of its lengths and times over those of the impact.
    scale: f64,
    restitution: f64,
    loss: f64,
}

impl<'a> Hysteretic<'a> {
    /// Impact with the part h of the hysteresis. `elastic`: motion with the mass m̄/(1 + h); `scale`: unit of its lengths over that of the
    /// impact. Its unit of force times 1 + h is `1/scale` times that of the impact.
    pub(crate) fn new(h: f64, elastic: Box<dyn Trajectory + 'a>, scale: f64) -> Self {
        let (restitution, loss) = rebound(h);
        Self { elastic, scale, restitution, loss }
    }

    /// State with the rate multiplied by `speed`: 1 in compression, e in expansion, where the force is multiplied by e².
    fn state(&self, State { penetration, rate, force }: State, speed: f64) -> State {
        State {
            penetration: penetration * self.scale,
            rate: rate * speed,
            force: force / self.scale * speed * speed,
        }
    }
}

impl Trajectory for Hysteretic<'_> {
    fn loss(&self) -> f64 {
        self.loss
    }

    fn restitution(&self) -> f64 {
        self.restitution
    }

    fn compression(&self) -> f64 {
        self.elastic.compression()
    }

    fn expansion(&self) -> f64 {
        self.elastic.expansion()
    }

    fn ends(&self) -> bool {
        true
    }

    fn max_penetration(&self) -> f64 {
        self.elastic.max_penetration() * self.scale
    }

    fn peak(&self) -> (f64, f64) {
        let (s, force) = self.elastic.peak();
        (s, force / self.scale)
    }

    fn after_touch(&self, s: f64) -> State {
        self.state(self.elastic.after_touch(s), 1.0)
    }

    fn before_end(&self, s: f64) -> State {
        self.state(self.elastic.before_end(s), self.restitution)
    }

    fn singularities(&self) -> [f64; 2] {
        self.elastic.singularities()
    }

    fn time_rate_after_touch(&self, s: f64) -> f64 {
        self.elastic.time_rate_after_touch(s) * self.scale
    }

    fn time_rate_before_end(&self, s: f64) -> f64 {
        self.elastic.time_rate_before_end(s) * self.scale / self.restitution
    }

    fn time_after_touch(&self, s: f64) -> f64 {
        self.elastic.time_after_touch(s) * self.scale
    }

    fn time_before_end(&self, s: f64) -> f64 {
        self.elastic.time_before_end(s) * self.scale / self.restitution
    }
}
