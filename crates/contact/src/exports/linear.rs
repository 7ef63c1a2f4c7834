//! What the tools with a linear spring and damper share: the damping ratio, and what a time step costs.

use super::{ExportError, Request, Tool};
use crate::error::representable;
use crate::limits;
use crate::{Separation, kelvin_voigt};
use std::f64::consts::PI;

/// A linear contact whose force never pulls: m̄ ẍ = −max(0, k x + c ẋ).
#[derive(Clone, Copy, Debug)]
pub(super) struct Linear {
    pub(super) tool: Tool,
    pub(super) restitution: f64,
    pub(super) mass: f64,
    pub(super) stiffness: f64,
    /// ζ, of the contact that ends when the force vanishes.
    pub(super) ratio: f64,
    /// ω = √(k/m̄), in rad/s.
    pub(super) frequency: f64,
    /// How far e may be off.
    pub(super) accuracy: f64,
    time_step: Option<f64>,
}

/// ζ, exactly 0 for e = 1.
fn ratio(restitution: f64) -> Result<f64, ExportError> {
    if restitution == 1.0 {
        return Ok(0.0);
    }
    Ok(kelvin_voigt::ratio(restitution, Separation::ForceVanishes)?)
}

impl Linear {
    /// Errors: the exponent is not 1; e = 0, which no damping reaches where the force never pulls; k/m̄ is beyond a
    /// float.
    pub(super) fn of(request: &Request, tool: Tool) -> Result<Self, ExportError> {
        let contact = request.contact;
        if contact.exponent() != 1.0 {
            return Err(ExportError::Exponent {
                tool,
                exponent: contact.exponent(),
                takes: "it is linear, exponent 1",
                remedy: "choose a linear stiffness that stores the same energy at the same penetration",
            });
        }
        let frequency =
            representable("ω² = stiffness over effective mass, 1/s²", contact.stiffness() / contact.mass())?;
        Ok(Self {
            tool,
            restitution: request.restitution,
            mass: contact.mass(),
            stiffness: contact.stiffness(),
            ratio: ratio(request.restitution)?,
            frequency: frequency.sqrt(),
            accuracy: request.options.accuracy,
            time_step: request.options.time_step,
        })
    }

    /// c = 2ζ√(k m̄) for a damping ratio ζ, in N·s/m. Written so that k m̄ cannot overflow.
    pub(super) fn damping(&self, ratio: f64) -> f64 {
        2.0 * ratio * self.mass * self.frequency
    }

    /// (v/ω) e^(−ζC(ζ)): greatest penetration of this ζ, also where the damper pulls at the end. `None` without a speed.
    pub(super) fn penetration(&self, speed: Option<f64>) -> Option<f64> {
        let root = if self.ratio > 0.0 {
            kelvin_voigt::restitution(self.ratio, Separation::ForceVanishes).ok()?.sqrt()
        } else {
            1.0
        };
        Some(speed? / self.frequency * root)
    }

    /// How far e can be off at a time step of semi-implicit Euler, wherever within the step the contact begins:
    /// 2ζe ωh + (ωh)²/8.
    ///
    /// The damper's first force comes up to one step late, which is the first term; the second is what is left of it
    /// without damping. Measured in MuJoCo 4.0.0 (Euler and implicitfast alike; ball and pendulum, m̄ = 1.5 … 6.2 kg)
    /// as the worst |Δe|/(ωh) over fifteen phases: 0.207, 0.222, 0.158, 0.062, 0.015 for e = 0.1, 0.2, 0.5, 0.8,
    /// 0.95, where 2ζe is 0.249, 0.292, 0.255, 0.119, 0.031; RK4 0.083, 0.098, 0.085, 0.040, 0.011, of first order
    /// too; e = 1 at ωh = 0.1: 0.0011.
    pub(super) fn error_bound(&self, time_step: f64) -> f64 {
        self.bound(self.slope(1.0), time_step)
    }

    /// The same for implicit Euler whose ratio is corrected as in [`Self::implicit_ratio`]: 3ζe ωh + (ωh)²/8.
    ///
    /// Measured in Drake 1.51.1 with SAP as the worst |Δe|/(ωh): 0.206, 0.222, 0.158, 0.063, 0.017 for e = 0.1, 0.2,
    /// 0.5, 0.8, 0.95. An engine that acts on a contact a step before it touches is off by 0.28, 0.35, 0.34, 0.16, 0.03
    /// (computed).
    pub(super) fn implicit_error_bound(&self, time_step: f64) -> f64 {
        self.bound(self.slope(1.5), time_step)
    }

    fn slope(&self, factor: f64) -> f64 {
        factor * 2.0 * self.ratio * self.restitution
    }

    fn bound(&self, slope: f64, time_step: f64) -> f64 {
        let step = self.frequency * time_step;
        slope * step + step * step / 8.0
    }

    /// The request's step, else the longest whose [`Self::error_bound`] is within the accuracy.
    ///
    /// Error: the request's is too long for an explicit step to follow the contact, ωh or 2ζωh above twice what holds
    /// for the recommended one; the bound is no bound there.
    pub(super) fn explicit_step(&self) -> Result<f64, ExportError> {
        self.explicit_step_by(self.slope(1.0))
    }

    fn explicit_step_by(&self, slope: f64) -> Result<f64, ExportError> {
        let Some(step) = self.time_step else { return Ok(self.accurate_step(slope)) };
        let largest =
            2.0 * limits::LONGEST_STEP.min(limits::STIFFEST_STEP / (2.0 * self.ratio)) / self.frequency;
        if step > largest {
            return Err(ExportError::StepTooCoarse { tool: self.tool, time_step: step, largest });
        }
        Ok(step)
    }

    /// The same by [`Self::implicit_error_bound`]; the step's own damping is to be at most half of all.
    pub(super) fn implicit_step(&self) -> f64 {
        self.implicit_step_by(self.slope(1.5))
    }

    fn implicit_step_by(&self, slope: f64) -> f64 {
        self.time_step.unwrap_or_else(|| self.accurate_step(slope).min(self.ratio / self.frequency))
    }

    /// The zero of the bound less the accuracy.
    fn accurate_step(&self, slope: f64) -> f64 {
        let step = 2.0 * self.accuracy / (slope + (slope * slope + self.accuracy / 2.0).sqrt());
        step.min(limits::LONGEST_STEP).min(limits::STIFFEST_STEP / (2.0 * self.ratio)) / self.frequency
    }

    /// The ratio to command where the contact is integrated by implicit Euler, which adds ωh/2 to it: ζ − ωh/2.
    ///
    /// Error: that is not above zero, or e = 1, for which no step is short enough.
    pub(super) fn implicit_ratio(&self, time_step: f64) -> Result<f64, ExportError> {
        if self.ratio == 0.0 {
            return Err(ExportError::Unreachable {
                tool: self.tool,
                restitution: self.restitution,
                why: "its integrator damps the contact a little at every step",
                remedy: "ask for a restitution below 1",
            });
        }
        let own = self.frequency * time_step / 2.0;
        if own < self.ratio {
            return Ok(self.ratio - own);
        }
        Err(ExportError::StepTooLong {
            tool: self.tool,
            time_step,
            restitution: self.restitution,
            reached: kelvin_voigt::restitution(own, Separation::ForceVanishes)?,
            largest: 2.0 * self.ratio / self.frequency,
        })
    }

    /// The sentence about the corrected ratio.
    pub(super) fn implicit_words(&self, time_step: f64) -> String {
        format!(
            "The damping is for the time step {time_step:?} s: implicit Euler adds ωh/2 = {:.3e} to the damping ratio, \
             which is taken off beforehand. Another step needs another damping.",
            self.frequency * time_step / 2.0
        )
    }
}

/// A linear stop that is not clamped: the damper pulls until the joint is back at the stop.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pulling(pub(super) Linear);

impl Pulling {
    /// As [`Linear::of`], with the ζ of a contact that ends where the gap closes, e = exp(−πζ/√(1−ζ²)).
    pub(super) fn of(request: &Request, tool: Tool) -> Result<Self, ExportError> {
        let mut linear = Linear::of(request, tool)?;
        if linear.restitution < 1.0 {
            linear.ratio = kelvin_voigt::ratio(linear.restitution, Separation::GapCloses)?;
        }
        Ok(Self(linear))
    }

    /// How far e can be off, with semi-implicit Euler and with implicit Euler whose ratio is corrected:
    /// (4ζ + πζ²/√(1−ζ²)³) e ωh + (ωh)²/8.
    ///
    /// The damper comes up to one step late and goes up to one step late, 2ζe ωh each; and the step changes ζ by about ζ² ωh, to which e is
    /// sensitive by πe/√(1−ζ²)³. Computed as the worst of 40 phases at accuracies of 1e-4 … 1e-2 and e = 0.005 … 0.99: at most 0.65 of it.
    pub(super) fn error_bound(&self, time_step: f64) -> f64 {
        self.0.bound(self.slope(), time_step)
    }

    fn slope(&self) -> f64 {
        let (ratio, e) = (self.0.ratio, self.0.restitution);
        e * (4.0 * ratio + PI * ratio * ratio / (1.0 - ratio * ratio).powf(1.5))
    }

    /// As [`Linear::explicit_step`].
    pub(super) fn explicit_step(&self) -> Result<f64, ExportError> {
        self.0.explicit_step_by(self.slope())
    }

    /// As [`Linear::implicit_step`].
    pub(super) fn implicit_step(&self) -> f64 {
        self.0.implicit_step_by(self.slope())
    }

    /// As [`Linear::implicit_ratio`].
    pub(super) fn implicit_ratio(&self, time_step: f64) -> Result<f64, ExportError> {
        self.0.implicit_ratio(time_step).map_err(|mut error| {
            if let ExportError::StepTooLong { reached, .. } = &mut error {
                let own = self.0.frequency * time_step / 2.0;
                // From ζ = 1 on the gap does not close again.
                *reached = kelvin_voigt::restitution(own, Separation::GapCloses).unwrap_or(0.0);
            }
            error
        })
    }
}
