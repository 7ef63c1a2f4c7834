//! Linear spring and damper of several tools: damping ratio, and effect of the time step.

use super::{ExportError, Request, Tool};
use crate::error::representable;
use crate::limits;
use crate::{Separation, kelvin_voigt};
use std::f64::consts::PI;

/// Linear contact with a force that never pulls: m̄ ẍ = −max(0, k x + c ẋ).
#[derive(Clone, Copy, Debug)]
pub(super) struct Linear {
    pub(super) tool: Tool,
    pub(super) restitution: f64,
    pub(super) mass: f64,
    pub(super) stiffness: f64,
    /// ζ of the contact that ends when the force vanishes.
    pub(super) ratio: f64,
    /// ω = √(k/m̄), in rad/s.
    pub(super) frequency: f64,
    /// Permitted error of e.
    pub(super) accuracy: f64,
    time_step: Option<f64>,
}

/// ζ of a restitution of a contact that ends when the force vanishes; exactly 0 for e = 1.
fn ratio(restitution: f64) -> Result<f64, ExportError> {
    if restitution == 1.0 {
        return Ok(0.0);
    }
    Ok(kelvin_voigt::ratio(restitution, Separation::ForceVanishes)?)
}

impl Linear {
    /// Linear contact of a request.
    ///
    /// Errors: the exponent is not 1; e = 0, unreachable for every damping if the force never pulls; k/m̄ overflows.
    pub(super) fn of(request: &Request, tool: Tool) -> Result<Self, ExportError> {
        let contact = request.contact;
        let (stiffness, exponent) = request.power_law();
        if exponent != 1.0 {
            return Err(ExportError::Exponent {
                tool,
                exponent,
                takes: "it is linear, exponent 1",
                remedy: "choose a linear stiffness that stores the same energy at the same compression",
            });
        }
        let frequency =
            representable("ω² = stiffness over effective mass, 1/s²", stiffness / contact.mass())?;
        Ok(Self {
            tool,
            restitution: request.restitution,
            mass: contact.mass(),
            stiffness,
            ratio: ratio(request.restitution)?,
            frequency: frequency.sqrt(),
            accuracy: request.options.accuracy,
            time_step: request.options.time_step,
        })
    }

    /// c = 2ζ√(k m̄) of a damping ratio ζ, N·s/m, computed without the product k m̄, which can overflow.
    pub(super) fn damping(&self, ratio: f64) -> f64 {
        2.0 * ratio * self.mass * self.frequency
    }

    /// Greatest penetration (v/ω) e^(−ζC(ζ)), also for a damper that pulls at the end. `None` without a speed.
    pub(super) fn penetration(&self, speed: Option<f64>) -> Option<f64> {
        let root = if self.ratio > 0.0 {
            kelvin_voigt::restitution(self.ratio, Separation::ForceVanishes).ok()?.sqrt()
        } else {
            1.0
        };
        Some(speed? / self.frequency * root)
    }

    /// Error bound of e at a time step of semi-implicit Euler, for every start of the contact within a step:
    /// 2ζe ωh + (ωh)²/8.
    ///
    /// First term: the first damper force is up to one step late. Second term: error without damping. Measured in
    /// MuJoCo 4.0.0 (Euler and implicitfast; ball and pendulum, m̄ = 1.5 … 6.2 kg) as the worst |Δe|/(ωh) over
    /// fifteen phases: 0.207, 0.222, 0.158, 0.062, 0.015 for e = 0.1, 0.2, 0.5, 0.8, 0.95, where 2ζe is 0.249, 0.292,
    /// 0.255, 0.119, 0.031; RK4 0.083, 0.098, 0.085, 0.040, 0.011, of first order too; e = 1 at ωh = 0.1: 0.0011.
    pub(super) fn error_bound(&self, time_step: f64) -> f64 {
        self.quadratic_bound(self.error_slope(1.0), time_step)
    }

    /// Error bound of e for implicit Euler with the ratio of [`Self::implicit_ratio`]: 3ζe ωh + (ωh)²/8.
    ///
    /// Measured in Drake 1.51.1 with SAP as the worst |Δe|/(ωh): 0.206, 0.222, 0.158, 0.063, 0.017 for e = 0.1, 0.2,
    /// 0.5, 0.8, 0.95. Engines with a contact force one step before the touch have the errors 0.28, 0.35, 0.34, 0.16,
    /// 0.03 (computed).
    pub(super) fn implicit_error_bound(&self, time_step: f64) -> f64 {
        self.quadratic_bound(self.error_slope(1.5), time_step)
    }

    /// Coefficient `factor` · 2ζe of ωh in the error bound.
    fn error_slope(&self, factor: f64) -> f64 {
        factor * 2.0 * self.ratio * self.restitution
    }

    /// Error bound `error_slope` · ωh + (ωh)²/8.
    fn quadratic_bound(&self, error_slope: f64, time_step: f64) -> f64 {
        let step = self.frequency * time_step;
        error_slope * step + step * step / 8.0
    }

    /// Step of the request, or the longest step with an [`Self::error_bound`] within the accuracy.
    ///
    /// Error: the requested step is too long for an explicit method (ωh or 2ζωh above twice the limits of the
    /// recommended step); the error bound is invalid there.
    pub(super) fn explicit_step(&self) -> Result<f64, ExportError> {
        self.explicit_step_for_slope(self.error_slope(1.0))
    }

    /// [`Self::explicit_step`] for an error bound with this coefficient of ωh.
    fn explicit_step_for_slope(&self, error_slope: f64) -> Result<f64, ExportError> {
        let Some(step) = self.time_step else { return Ok(self.accurate_step(error_slope)) };
        let largest =
            2.0 * limits::LONGEST_STEP.min(limits::STIFFEST_STEP / (2.0 * self.ratio)) / self.frequency;
        if step > largest {
            return Err(ExportError::StepTooCoarse { tool: self.tool, time_step: step, largest });
        }
        Ok(step)
    }

    /// Step of the request, or the longest step with an [`Self::implicit_error_bound`] within the accuracy and at most
    /// half of the damping by the step.
    pub(super) fn implicit_step(&self) -> f64 {
        self.implicit_step_for_slope(self.error_slope(1.5))
    }

    /// [`Self::implicit_step`] for an error bound with this coefficient of ωh.
    fn implicit_step_for_slope(&self, error_slope: f64) -> f64 {
        self.time_step.unwrap_or_else(|| self.accurate_step(error_slope).min(self.ratio / self.frequency))
    }

    /// Step with an error bound equal to the accuracy, within the limits of the step.
    fn accurate_step(&self, error_slope: f64) -> f64 {
        let step =
            2.0 * self.accuracy / (error_slope + (error_slope * error_slope + self.accuracy / 2.0).sqrt());
        step.min(limits::LONGEST_STEP).min(limits::STIFFEST_STEP / (2.0 * self.ratio)) / self.frequency
    }

    /// Damping ratio for implicit Euler, which adds ωh/2: ζ − ωh/2.
    ///
    /// Errors: the ratio is not above zero; e = 1, unreachable at every step.
    pub(super) fn implicit_ratio(&self, time_step: f64) -> Result<f64, ExportError> {
        if self.ratio == 0.0 {
            return Err(ExportError::Unreachable {
                tool: self.tool,
                restitution: self.restitution,
                why: "the integrator has numerical damping at every step",
                remedy: "use a restitution below 1",
            });
        }
        let numerical_ratio = self.frequency * time_step / 2.0;
        if numerical_ratio < self.ratio {
            return Ok(self.ratio - numerical_ratio);
        }
        Err(ExportError::StepTooLong {
            tool: self.tool,
            time_step,
            restitution: self.restitution,
            reached: kelvin_voigt::restitution(numerical_ratio, Separation::ForceVanishes)?,
            largest: 2.0 * self.ratio / self.frequency,
        })
    }

    /// Sentence of the export: for which time step the damping ratio is corrected.
    pub(super) fn implicit_assumption(&self, time_step: f64) -> String {
        format!(
            "The damping is for the time step {time_step:?} s: implicit Euler adds ωh/2 = {:.3e} to the damping ratio, \
             which is subtracted in advance. A different step needs a different damping.",
            self.frequency * time_step / 2.0
        )
    }
}

/// Linear stop without the clamp of the force to positive values: the damper pulls until the joint is back at the
/// stop.
#[derive(Clone, Copy, Debug)]
pub(super) struct UnclampedLinear(pub(super) Linear);

impl UnclampedLinear {
    /// [`Linear::of`] with the ζ of a contact that ends at the closed gap, e = exp(−πζ/√(1−ζ²)).
    pub(super) fn of(request: &Request, tool: Tool) -> Result<Self, ExportError> {
        let mut linear = Linear::of(request, tool)?;
        if linear.restitution < 1.0 {
            linear.ratio = kelvin_voigt::ratio(linear.restitution, Separation::GapCloses)?;
        }
        Ok(Self(linear))
    }

    /// Error bound of e, for semi-implicit Euler and for implicit Euler with the corrected ratio:
    /// (4ζ + πζ²/√(1−ζ²)³) e ωh + (ωh)²/8.
    ///
    /// The damper force starts and ends up to one step late, 2ζe ωh each; the step changes ζ by about ζ² ωh, with the
    /// sensitivity πe/√(1−ζ²)³ of e. Computed for 40 phases, accuracies of 1e-4 … 1e-2 and e = 0.005 … 0.99: the
    /// error is at most 0.65 of the bound.
    pub(super) fn error_bound(&self, time_step: f64) -> f64 {
        self.0.quadratic_bound(self.error_slope(), time_step)
    }

    /// Coefficient of ωh in the error bound.
    fn error_slope(&self) -> f64 {
        let (ratio, e) = (self.0.ratio, self.0.restitution);
        e * (4.0 * ratio + PI * ratio * ratio / (1.0 - ratio * ratio).powf(1.5))
    }

    /// [`Linear::explicit_step`] with the bound of this law.
    pub(super) fn explicit_step(&self) -> Result<f64, ExportError> {
        self.0.explicit_step_for_slope(self.error_slope())
    }

    /// [`Linear::implicit_step`] with the bound of this law.
    pub(super) fn implicit_step(&self) -> f64 {
        self.0.implicit_step_for_slope(self.error_slope())
    }

    /// [`Linear::implicit_ratio`] with the restitution of this law in the error.
    pub(super) fn implicit_ratio(&self, time_step: f64) -> Result<f64, ExportError> {
        self.0.implicit_ratio(time_step).map_err(|mut error| {
            if let ExportError::StepTooLong { reached, .. } = &mut error {
                let numerical_ratio = self.0.frequency * time_step / 2.0;
                // For ζ ≥ 1 the gap does not close again.
                *reached = kelvin_voigt::restitution(numerical_ratio, Separation::GapCloses).unwrap_or(0.0);
            }
            error
        })
    }
}
