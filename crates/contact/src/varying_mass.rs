//! Impact with an effective mass that changes over the penetration.

use crate::error::{LawParameter, positive};
use crate::{CompliantContact, ContactLawError, Damper, Sample, Separation, kelvin_voigt};
use serde::Serialize;
use std::f64::consts::TAU;

/// Steps of the integration over the duration of the impact with the mass at the touch.
const STEPS: f64 = 4000.0;
/// Greatest number of steps: an impact that takes longer has no end.
const MOST_STEPS: usize = 100_000;
/// Step of the difference quotient for m̄′, relative to the depth of the profile. m̄ is smooth over a sixteenth of the depth, and the
/// rounding of the quotient is 1e-10 of the change of m̄ over the depth.
const DERIVATIVE_STEP: f64 = 1e-6;

/// Key figures of an impact with an effective mass that changes over the penetration.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct VaryingMassImpact {
    /// Rebound speed divided by approach speed.
    pub restitution: f64,
    /// Largest penetration, m.
    pub max_penetration: f64,
    /// m̄ at the largest penetration, kg.
    pub mass_at_max_penetration: f64,
    /// Largest force, N.
    pub peak_force: f64,
}

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
    integrate(damper, contact, profile, speed, |_| ())
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
    let ended = integrate(damper, contact, profile, speed, |sample| samples.push(sample))?;
    Ok(ended.map(|_| samples))
}

/// Integrates the impact and passes the state at the touch, after every step and at the end to `record`.
fn integrate(
    damper: Damper,
    contact: CompliantContact,
    profile: &[(f64, f64)],
    speed: f64,
    mut record: impl FnMut(Sample),
) -> Result<Option<VaryingMassImpact>, ContactLawError> {
    let speed = positive(LawParameter::Speed, speed)?;
    checked_depth(profile)?;
    let constant = damper.impact(contact, speed)?;
    let step = constant.duration.unwrap_or(4.0 * constant.time_of_max_penetration) / STEPS;
    let force = |x: f64, rate: f64| damper.force(contact, x, rate);
    // Without damping the force stays zero after the separation, so the penetration determines the end.
    let ends_at_zero_force = matches!(
        damper,
        Damper::KelvinVoigt { separation: Separation::ForceVanishes, coefficient, .. } if coefficient > 0.0
    );
    let mass = |x: f64| interpolate(profile, x);
    let rates = |(x, w): (f64, f64)| {
        let root = mass(x).sqrt();
        (w / root, -force(x, w / root) / root)
    };
    let rate = |(x, w): (f64, f64)| w / mass(x).sqrt();
    let mut state = (0.0, mass(0.0).sqrt() * speed);
    let (mut deepest, mut peak_force) = (0.0f64, force(0.0, speed));
    let sample = |time: f64, state: (f64, f64)| Sample {
        time,
        penetration: state.0,
        rate: rate(state),
        force: force(state.0, rate(state)),
    };
    record(sample(0.0, state));
    for number in 0..MOST_STEPS {
        let time = number as f64 * step;
        let next = runge_kutta_step(state, step, &rates);
        // The contact ends where this quantity falls below zero during the expansion.
        let remaining =
            |state: (f64, f64)| if ends_at_zero_force { force(state.0, rate(state)) } else { state.0 };
        if next.1 < 0.0 && remaining(next) <= 0.0 {
            let (before, after) = (remaining(state), remaining(next));
            let fraction = if before > after { (before / (before - after)).clamp(0.0, 1.0) } else { 1.0 };
            let end = (state.0 + fraction * (next.0 - state.0), state.1 + fraction * (next.1 - state.1));
            record(sample(time + fraction * step, end));
            return Ok(Some(VaryingMassImpact {
                restitution: -rate(end) / speed,
                max_penetration: deepest,
                mass_at_max_penetration: mass(deepest),
                peak_force,
            }));
        }
        deepest = deepest.max(next.0);
        peak_force = peak_force.max(force(next.0, rate(next)));
        state = next;
        record(sample(time + step, state));
    }
    Ok(None)
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
    let frequency = (contact.stiffness() / contact.mass()).sqrt();
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

/// State after a step of the classical Runge–Kutta method of fourth order; `rates`: derivatives of a state with respect to time.
fn runge_kutta_step(state: (f64, f64), step: f64, rates: &dyn Fn((f64, f64)) -> (f64, f64)) -> (f64, f64) {
    let along = |(x, v): (f64, f64), (dx, dv): (f64, f64), h: f64| (x + h * dx, v + h * dv);
    let a = rates(state);
    let b = rates(along(state, a, 0.5 * step));
    let c = rates(along(state, b, 0.5 * step));
    let d = rates(along(state, c, step));
    let mean = |a: f64, b: f64, c: f64, d: f64| (a + 2.0 * b + 2.0 * c + d) / 6.0;
    along(state, (mean(a.0, b.0, c.0, d.0), mean(a.1, b.1, c.1, d.1)), step)
}

/// Depth of the last point of a profile, m.
fn checked_depth(profile: &[(f64, f64)]) -> Result<f64, ContactLawError> {
    for (_, mass) in profile {
        positive(LawParameter::Mass, *mass)?;
    }
    match profile {
        [_, .., (depth, _)] => positive("depth of the last mass, m", *depth),
        _ => {
            let (what, valid) = ("points of the mass".into(), "at least 2");
            Err(ContactLawError::OutOfRange { what, got: profile.len() as f64, valid })
        }
    }
}

/// Cubic through the values and slopes at the ends of an interval; slopes of the parabolas through three neighbours.
fn interpolate(points: &[(f64, f64)], x: f64) -> f64 {
    let last = points.len() - 1;
    if x <= points[0].0 {
        return points[0].1;
    }
    if x >= points[last].0 {
        return points[last].1;
    }
    let right = points.partition_point(|(at, _)| *at <= x).clamp(1, last);
    let ((x0, y0), (x1, y1)) = (points[right - 1], points[right]);
    let chord = |i: usize| (points[i + 1].1 - points[i].1) / (points[i + 1].0 - points[i].0);
    let slope = |i: usize| match i {
        0 => chord(0),
        i if i == last => chord(last - 1),
        i => {
            let (before, after) = (points[i].0 - points[i - 1].0, points[i + 1].0 - points[i].0);
            (chord(i - 1) * after + chord(i) * before) / (before + after)
        }
    };
    let (h, t) = (x1 - x0, (x - x0) / (x1 - x0));
    let (t2, t3) = (t * t, t * t * t);
    (2.0 * t3 - 3.0 * t2 + 1.0) * y0
        + (t3 - 2.0 * t2 + t) * h * slope(right - 1)
        + (3.0 * t2 - 2.0 * t3) * y1
        + (t3 - t2) * h * slope(right)
}
