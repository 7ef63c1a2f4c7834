//! Impact with an effective mass that changes over the penetration.

use crate::error::{LawParameter, positive};
use crate::stepping::{
    MOST_STEPS, STEPS, Stepping, VaryingMassImpact, checked_depth, interpolate, runge_kutta_step,
    step_on_curve,
};
use crate::{CompliantContact, ContactLawError, Damper, Sample, Separation, StiffnessLaw, kelvin_voigt};
use std::f64::consts::TAU;

/// Step of the difference quotient for m̄′, relative to the depth of the profile. m̄ is smooth over a sixteenth of the depth, and the
/// rounding of the quotient is 1e-10 of the change of m̄ over the depth.
const DERIVATIVE_STEP: f64 = 1e-6;

/// Impact of a mechanism with one degree of freedom on a contact: m̄ δ̈ + ½ m̄′ δ̇² = −F(δ, δ̇).
///
/// `profile`: pairs of penetration (m, increasing from 0) and m̄ (kg); interpolated by cubics, constant beyond the last.
/// With w = √m̄ δ̇ the equation is ẇ = −F/√m̄, without the derivative of m̄; it is integrated by the classical
/// Runge–Kutta method with a fixed step. The mass of `contact` is that at the touch. `None`: the contact does not end.
///
/// # Errors
/// As for [`Damper::impact`]; a profile with less than two points or a mass that is not above 0.
pub fn impact_with_varying_mass(
    damper: Damper,
    contact: CompliantContact,
    profile: &[(f64, f64)],
    speed: f64,
) -> Result<Option<VaryingMassImpact>, ContactLawError> {
    integrate(damper, contact, profile, speed, &|_, _| 0.0, |_| ())
}

/// Motion of an impact with an effective mass that changes over the penetration, at every step of the integration: time,
/// penetration, rate and contact force, from the touch to the end. See [`impact_with_varying_mass`]. `None`: the contact does not
/// end.
///
/// # Errors
/// As for [`impact_with_varying_mass`].
pub fn history_with_varying_mass(
    damper: Damper,
    contact: CompliantContact,
    profile: &[(f64, f64)],
    speed: f64,
) -> Result<Option<Vec<Sample>>, ContactLawError> {
    let mut samples = Vec::new();
    let ended = integrate(damper, contact, profile, speed, &|_, _| 0.0, |sample| samples.push(sample))?;
    Ok(ended.map(|_| samples))
}

/// Restitution of the impact with the constant mass of the contact and other forces beside it, such as springs and dampers; at the closed gap.
/// `beside`: their force (N), positive against the penetration, over penetration (m) and rate (m/s). `None`: the contact does not end.
///
/// # Errors
/// As for [`Damper::impact`].
pub fn restitution_with_parallel_forces(
    damper: Damper,
    contact: CompliantContact,
    speed: f64,
    beside: &dyn Fn(f64, f64) -> f64,
) -> Result<Option<f64>, ContactLawError> {
    let profile = [(0.0, contact.mass()), (1.0, contact.mass())];
    let found = integrate(damper, contact, &profile, speed, beside, |_| ())?;
    Ok(found.map(|found| found.restitution))
}

/// Integrates the impact and passes the state at the touch, after every step and at the end to `record`. `beside`: force beside the
/// contact, N.
fn integrate(
    damper: Damper,
    contact: CompliantContact,
    profile: &[(f64, f64)],
    speed: f64,
    beside: &dyn Fn(f64, f64) -> f64,
    record: impl FnMut(Sample),
) -> Result<Option<VaryingMassImpact>, ContactLawError> {
    let speed = positive(LawParameter::Speed, speed)?;
    checked_depth(profile)?;
    let (corners, step) = match contact.stiffness() {
        StiffnessLaw::Power { .. } => {
            let constant = damper.impact(contact, speed)?;
            (&[][..], constant.duration.unwrap_or(4.0 * constant.time_of_max_penetration) / STEPS)
        }
        StiffnessLaw::Curve(curve) => (&curve.deflections()[1..], step_on_curve(contact, speed)?),
    };
    let force = |x: f64, rate: f64| damper.force(contact, x, rate);
    Ok(Stepping {
        force: &force,
        ends_at_zero_force: damper.ends_at_zero_force(),
        jumps_at_reversal: damper.jumps_at_reversal(),
        corners,
        step,
        speed,
        beside,
        most_steps: MOST_STEPS,
    }
    .run(profile, record))
}

/// Restitution of a contact that prescribes accelerations of the joints, as MuJoCo's contacts do: j q̈ = −(ω² δ + 2ζω δ̇) while the
/// force pushes. ω = √(k/m̄) with m̄ at the touch, and ζ is that of the required restitution for a constant mass.
///
/// The penetration has the acceleration δ̈ = j q̈ + β δ̇²; β (1/m) is its acceleration at constant joint rates and a closing speed of 1 m/s.
/// MuJoCo's contacts prescribe j q̈ without the term β δ̇². Without a force m̄ δ̈ + ½ m̄′ δ̇² = 0, so j q̈ = −(p + β) δ̇² with p = m̄′/(2 m̄).
/// A contact cannot pull, so in general δ̈ = β δ̇² − max(ω² δ + 2ζω δ̇, (p + β) δ̇²). The contact ends at δ = 0.
///
/// `masses` and `accelerations`: pairs of penetration (m, increasing from 0) and m̄ (kg) or β (1/m), interpolated as for
/// [`impact_with_varying_mass`]. Returns the restitution and the largest penetration, m. `None`: the contact does not end.
///
/// # Errors
/// As for [`impact_with_varying_mass`]; a required restitution of 0.
pub fn restitution_with_prescribed_acceleration(
    contact: CompliantContact,
    restitution: f64,
    masses: &[(f64, f64)],
    accelerations: &[(f64, f64)],
    speed: f64,
) -> Result<Option<(f64, f64)>, ContactLawError> {
    let (speed, depth) = (positive(LawParameter::Speed, speed)?, checked_depth(masses)?);
    let ratio = match restitution {
        1.0 => 0.0,
        e => kelvin_voigt::ratio(e, Separation::ForceVanishes)?,
    };
    let Some((stiffness, _)) = contact.power_law() else { return Ok(None) };
    let frequency = (stiffness / contact.mass()).sqrt();
    let difference = DERIVATIVE_STEP * depth;
    let mass_slope = |x: f64| {
        let at = x.clamp(0.0, depth - difference);
        let (near, far) = (interpolate(masses, at), interpolate(masses, at + difference));
        (far / near - 1.0) / (2.0 * difference)
    };
    let acceleration = |(x, v): (f64, f64)| {
        let beta = interpolate(accelerations, x);
        let wanted = frequency * (frequency * x + 2.0 * ratio * v);
        beta * v * v - wanted.max((mass_slope(x) + beta) * v * v)
    };
    // A fraction of the period without damping. An impact with a constant mass lasts about half of this period.
    let step = TAU / frequency / STEPS;
    let rates = |state: (f64, f64)| (state.1, acceleration(state));
    let mut state = (0.0, speed);
    let mut deepest = 0.0f64;
    for _ in 0..MOST_STEPS {
        let next = runge_kutta_step(state, step, &rates);
        if next.0 <= 0.0 && next.1 < 0.0 {
            let fraction = state.0 / (state.0 - next.0);
            return Ok(Some((-(state.1 + fraction * (next.1 - state.1)) / speed, deepest)));
        }
        state = next;
        deepest = deepest.max(state.0);
    }
    Ok(None)
}
