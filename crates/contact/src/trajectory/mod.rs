//! The motion of an impact in units of its own.
//!
//! | quantity    | unit                                          |
//! |-------------|-----------------------------------------------|
//! | speed       | v, the approach speed                         |
//! | penetration | X = ((p+1) m̄ v²/(2k))^(1/(p+1)): the greatest without damping |
//! | time        | X/v                                           |
//! | force       | k Xᵖ                                          |
//!
//! Each law's motion is known in closed form along a parameter s; only the time needs an integral, ∫ (dt/ds) ds. The
//! integrand dt/ds is singular, if at all, where the contact begins and where it ends, so s is measured from both.

mod dissipative;
mod oscillator;

pub(crate) use dissipative::Dissipative;
pub(crate) use oscillator::Oscillator;

use crate::quadrature::from_singular_end;

/// The state at one instant of the impact, in its units.
#[derive(Clone, Copy, Debug)]
pub(crate) struct State {
    pub penetration: f64,
    pub rate: f64,
    pub force: f64,
}

/// The motion of an impact.
pub(crate) trait Trajectory {
    /// 1 − e.
    fn loss(&self) -> f64;
    /// e.
    fn restitution(&self) -> f64;
    /// The length in s from the first touch to the greatest penetration.
    fn compression(&self) -> f64;
    /// The length in s from there to the end of the contact, or to rest where it does not end.
    fn expansion(&self) -> f64;
    /// Whether the contact ends in finite time.
    fn ends(&self) -> bool;
    /// The greatest penetration.
    fn greatest_penetration(&self) -> f64;
    /// Where the force is greatest, as s from the first touch, and the force there.
    fn peak(&self) -> (f64, f64);
    /// The state s after the first touch, not beyond the greatest penetration.
    fn after_touch(&self, s: f64) -> State;
    /// The state s before the end, not before the greatest penetration.
    fn before_end(&self, s: f64) -> State;
    /// The α for which dt/ds is like s⁻ᵅ near the first touch, and near the end.
    fn singularities(&self) -> [f64; 2];
    /// dt/ds where [`Trajectory::after_touch`] gives the state.
    fn time_rate_after_touch(&self, s: f64) -> f64;
    /// dt/ds where [`Trajectory::before_end`] gives the state.
    fn time_rate_before_end(&self, s: f64) -> f64;

    /// The time from the first touch to s after it.
    fn time_after_touch(&self, s: f64) -> f64 {
        from_singular_end(s, |s| self.time_rate_after_touch(s))
    }

    /// The time from s before the end to the end.
    fn time_before_end(&self, s: f64) -> f64 {
        from_singular_end(s, |s| self.time_rate_before_end(s))
    }
}
