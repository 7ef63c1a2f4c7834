//! What an impact amounts to, and its history.

use crate::error::{positive, representable};
use crate::limits;
use crate::trajectory::{State, Trajectory};
use crate::{CompliantContact, ContactLawError};
use serde::Serialize;

/// The figures of one impact: a contact met at some approach speed, until it ends.
///
/// The restitution, penetration, force and energy are closed forms, the times too where a Kelvin–Voigt contact is
/// linear; other times are integrals, to 1e-12 of themselves.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Impact {
    /// Rebound speed over approach speed.
    pub restitution: f64,
    /// From the first touch to the end, in s; none where the gap takes forever to close (a Kelvin–Voigt contact
    /// that ends when the gap closes, damping ratio 1 or more).
    pub duration: Option<f64>,
    /// In m.
    pub max_penetration: f64,
    /// From the first touch, in s.
    pub time_of_max_penetration: f64,
    /// The greatest push, in N.
    pub peak_force: f64,
    /// From the first touch, in s: 0 where the damper's jump at the touch is the greatest.
    pub time_of_peak_force: f64,
    /// ½ m̄ v² (1 − e²), in J.
    pub energy_lost: f64,
    /// e v, in m/s.
    pub rebound_speed: f64,
}

/// The state at one instant of an impact.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Sample {
    /// Since the first touch, in s.
    pub time: f64,
    /// In m.
    pub penetration: f64,
    /// The speed at which the penetration grows, in m/s.
    pub rate: f64,
    /// The push between the two sides, in N.
    pub force: f64,
}

/// The units of a trajectory.
#[derive(Clone, Copy, Debug)]
struct Units {
    speed: f64,
    length: f64,
    time: f64,
    force: f64,
}

impl Units {
    fn new(contact: CompliantContact, speed: f64) -> Result<Self, ContactLawError> {
        let p = contact.exponent();
        let speed = positive("approach speed, m/s", speed)?;
        // √(m̄/k) v first: no square overflows on the way.
        let root = contact.mass().sqrt() / contact.stiffness().sqrt() * speed;
        let scale = (0.5 * (p + 1.0)).sqrt() * representable("penetration, m", root)?;
        let length = representable("penetration, m", scale.powf(2.0 / (p + 1.0)))?;
        let time = representable("duration, s", length / speed)?;
        // k Xᵖ = (p+1)/2 m̄ v²/X.
        let force = representable("force, N", 0.5 * (p + 1.0) * contact.mass() * (speed / time))?;
        Ok(Self { speed, length, time, force })
    }

    fn sample(&self, time: f64, moment: State) -> Sample {
        Sample {
            time: time * self.time,
            penetration: moment.penetration * self.length,
            rate: moment.rate * self.speed,
            force: moment.force * self.force,
        }
    }
}

/// The figures of this trajectory.
pub(crate) fn impact(
    trajectory: &dyn Trajectory,
    contact: CompliantContact,
    speed: f64,
) -> Result<Impact, ContactLawError> {
    let units = Units::new(contact, speed)?;
    let (at_peak, peak) = trajectory.peak();
    let compression = trajectory.time_after_touch(trajectory.compression());
    let duration =
        trajectory.ends().then(|| compression + trajectory.time_before_end(trajectory.expansion()));
    let (loss, restitution) = (trajectory.loss(), trajectory.restitution());
    let energy_lost = 0.5 * (contact.mass() * speed) * speed * loss * (1.0 + restitution);
    let rebound_speed = restitution * speed;
    let to_peak = trajectory.time_after_touch(at_peak);
    let time = |value: f64| representable("duration, s", value * units.time);
    Ok(Impact {
        restitution: if trajectory.ends() { representable("restitution", restitution)? } else { restitution },
        duration: duration.map(time).transpose()?,
        max_penetration: representable("penetration, m", trajectory.greatest_penetration() * units.length)?,
        time_of_max_penetration: time(compression)?,
        peak_force: representable("force, N", peak * units.force)?,
        time_of_peak_force: if to_peak == 0.0 { 0.0 } else { time(to_peak)? },
        energy_lost: if loss == 0.0 { 0.0 } else { representable("energy lost, J", energy_lost)? },
        rebound_speed: if trajectory.ends() {
            representable("rebound speed, m/s", rebound_speed)?
        } else {
            0.0
        },
    })
}

/// The history of this trajectory at `count` instants, the touch and the end included.
///
/// They are nearly evenly spaced in time near both ends, where the force of a stiffening spring sets in, and along
/// the trajectory's own parameter between.
pub(crate) fn history(
    trajectory: &dyn Trajectory,
    contact: CompliantContact,
    speed: f64,
    count: usize,
) -> Result<Vec<Sample>, ContactLawError> {
    if !limits::SAMPLES.contains(&count) {
        let valid = "a whole number from 2 to 1000000";
        return Err(ContactLawError::OutOfRange { what: "number of samples", got: count as f64, valid });
    }
    let units = Units::new(contact, speed)?;
    let compression = trajectory.time_after_touch(trajectory.compression());
    let total = compression + trajectory.time_before_end(trajectory.expansion());
    let [from_touch, to_end] = trajectory.singularities().map(|power| 1.0 / (1.0 - power));
    let turn = compression / total;
    let moment = |i: usize| {
        let fraction = i as f64 / (count - 1) as f64;
        if fraction <= turn {
            let s = trajectory.compression() * (fraction / turn).powf(from_touch);
            (trajectory.time_after_touch(s), trajectory.after_touch(s))
        } else {
            let s = trajectory.expansion() * ((1.0 - fraction) / (1.0 - turn)).powf(to_end);
            (total - trajectory.time_before_end(s), trajectory.before_end(s))
        }
    };
    (0..count)
        .map(|i| {
            let (time, moment) = moment(i);
            let sample = units.sample(time, moment);
            let all = [sample.time, sample.penetration, sample.rate, sample.force];
            if all.iter().all(|value| value.is_finite()) {
                return Ok(sample);
            }
            Err(ContactLawError::NotRepresentable { what: "history of the impact" })
        })
        .collect()
}
