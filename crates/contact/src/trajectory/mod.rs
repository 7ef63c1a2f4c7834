//! Motion of an impact in dimensionless form.
//!
//! | quantity    | unit                                          |
//! |-------------|-----------------------------------------------|
//! | speed       | v, the approach speed                         |
//! | penetration | X = ((p+1) m̄ v²/(2k))^(1/(p+1)): the greatest without damping |
//! | time        | X/v                                           |
//! | force       | k Xᵖ                                          |
//!
//! On a force curve the unit of the penetration is also the greatest without damping, and the unit of the force is m̄ v²/X.
//!
//! The motion of each law has a closed form in a parameter s; only the time needs an integral, ∫ (dt/ds) ds. The
//! integrand dt/ds can be singular only at the start and at the end of the contact, so s is measured from both.

mod dissipative;
mod hysteretic;
mod on_curve;
mod oscillator;
mod quadrature;

pub(crate) use dissipative::Dissipative;
pub(crate) use hysteretic::Hysteretic;
pub(crate) use on_curve::OnCurve;
pub(crate) use oscillator::Oscillator;

use quadrature::from_singular_end;

/// Dimensionless state at one instant of an impact.
#[derive(Clone, Copy, Debug)]
pub(crate) struct State {
    pub penetration: f64,
    pub rate: f64,
    pub force: f64,
}

/// Motion of an impact.
pub(crate) trait Trajectory {
    /// Loss 1 − e.
    fn loss(&self) -> f64;
    /// Restitution e.
    fn restitution(&self) -> f64;
    /// Interval of s from the first touch to the largest penetration.
    fn compression(&self) -> f64;
    /// Interval of s from the largest penetration to the end of the contact; to rest if the contact does not end.
    fn expansion(&self) -> f64;
    /// True if the contact ends in finite time.
    fn ends(&self) -> bool;
    /// Largest penetration, in units of X.
    fn max_penetration(&self) -> f64;
    /// s after the first touch at the largest force, and this force in units of k Xᵖ.
    fn peak(&self) -> (f64, f64);
    /// State at s after the first touch, up to the largest penetration.
    fn after_touch(&self, s: f64) -> State;
    /// State at s before the end, back to the largest penetration.
    fn before_end(&self, s: f64) -> State;
    /// Exponents α of dt/ds ∼ s⁻ᵅ near the first touch and near the end.
    fn singularities(&self) -> [f64; 2];
    /// dt/ds at the state of [`Trajectory::after_touch`].
    fn time_rate_after_touch(&self, s: f64) -> f64;
    /// dt/ds at the state of [`Trajectory::before_end`].
    fn time_rate_before_end(&self, s: f64) -> f64;

    /// Time from the first touch to s.
    fn time_after_touch(&self, s: f64) -> f64 {
        from_singular_end(s, |s| self.time_rate_after_touch(s))
    }

    /// Time from s before the end to the end.
    fn time_before_end(&self, s: f64) -> f64 {
        from_singular_end(s, |s| self.time_rate_before_end(s))
    }
}
