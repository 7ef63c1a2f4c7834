//! Key figures and history of an impact.

use crate::error::{LawParameter, positive, representable};
use crate::limits;
use crate::trajectory::{State, Trajectory};
use crate::{CompliantContact, ContactLawError};
use serde::Serialize;

/// Key figures of one impact, from the first touch to the end of the contact.
///
/// Restitution, penetration, force and energy have closed forms, and so have the times of a linear Kelvin–Voigt
/// contact. Other times are integrals with a relative error of 1e-12.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Impact {
    /// Rebound speed divided by approach speed.
    pub restitution: f64,
    /// Duration from the first touch to the end, in s. `None` if the gap never closes (a Kelvin–Voigt contact that
    /// ends when the gap closes, with a damping ratio of 1 or more).
    pub duration: Option<f64>,
    /// Largest penetration, in m.
    pub max_penetration: f64,
    /// Time of the largest penetration after the first touch, in s.
    pub time_of_max_penetration: f64,
    /// Largest force, in N.
    pub peak_force: f64,
    /// Time of the largest force after the first touch, in s; 0 if the jump of the damper force at the touch is the
    /// maximum.
    pub time_of_peak_force: f64,
    /// Lost energy ½ m̄ v² (1 − e²), in J.
    pub energy_lost: f64,
    /// Rebound speed e v, in m/s.
    pub rebound_speed: f64,
}

/// State at one instant of an impact.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Sample {
    /// Time since the first touch, in s.
    pub time: f64,
    /// Penetration, in m.
    pub penetration: f64,
    /// Rate of the penetration, in m/s.
    pub rate: f64,
    /// Compressive force between the two sides, in N.
    pub force: f64,
}

/// Units of a trajectory.
#[derive(Clone, Copy, Debug)]
struct Units {
    speed: f64,
    length: f64,
    time: f64,
    force: f64,
}

impl Units {
    fn new(contact: CompliantContact, speed: f64) -> Result<Self, ContactLawError> {
        let speed = positive(LawParameter::Speed, speed)?;
        let length = contact.undamped_penetration(speed)?;
        let time = representable("duration, s", length / speed)?;
        // k Xᵖ = (p+1)/2 m̄ v²/X.
        let factor = contact.power_law().map_or(1.0, |(_, p)| 0.5 * (p + 1.0));
        let force = representable("force, N", factor * contact.mass() * (speed / time))?;
        Ok(Self { speed, length, time, force })
    }

    /// Converts a dimensionless time and state to SI units.
    fn sample(&self, time: f64, state: State) -> Sample {
        Sample {
            time: time * self.time,
            penetration: state.penetration * self.length,
            rate: state.rate * self.speed,
            force: state.force * self.force,
        }
    }
}

/// Key figures of a trajectory.
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
        max_penetration: representable("compression, m", trajectory.max_penetration() * units.length)?,
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

/// Checks the number of samples of a history.
pub(crate) fn check_count(count: usize) -> Result<(), ContactLawError> {
    if limits::SAMPLES.contains(&count) {
        return Ok(());
    }
    let valid = "a whole number from 2 to 1000000";
    Err(ContactLawError::OutOfRange { what: "number of samples".into(), got: count as f64, valid })
}

/// History of a trajectory at `count` instants, including the touch and the end.
///
/// The instants are nearly uniform in time near both ends, because the force of a stiffening spring starts there, and
/// uniform in the parameter of the trajectory in between.
pub(crate) fn history(
    trajectory: &dyn Trajectory,
    contact: CompliantContact,
    speed: f64,
    count: usize,
) -> Result<Vec<Sample>, ContactLawError> {
    check_count(count)?;
    let units = Units::new(contact, speed)?;
    let compression = trajectory.time_after_touch(trajectory.compression());
    let total = compression + trajectory.time_before_end(trajectory.expansion());
    let [from_touch, to_end] = trajectory.singularities().map(|power| 1.0 / (1.0 - power));
    let compression_part = compression / total;
    let state = |i: usize| {
        let fraction = i as f64 / (count - 1) as f64;
        if fraction <= compression_part {
            let s = trajectory.compression() * (fraction / compression_part).powf(from_touch);
            (trajectory.time_after_touch(s), trajectory.after_touch(s))
        } else {
            let s = trajectory.expansion() * ((1.0 - fraction) / (1.0 - compression_part)).powf(to_end);
            (total - trajectory.time_before_end(s), trajectory.before_end(s))
        }
    };
    (0..count)
        .map(|i| {
            let (time, state) = state(i);
            let sample = units.sample(time, state);
            let all = [sample.time, sample.penetration, sample.rate, sample.force];
            if all.iter().all(|value| value.is_finite()) {
                return Ok(sample);
            }
            Err(ContactLawError::NotRepresentable { what: "history of the impact" })
        })
        .collect()
}
