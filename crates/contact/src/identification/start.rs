//! Part of a record around its first impact, samples at the limit of a sensor, and values from which the search begins.

use super::record::{LEAST_SAMPLES, Measured, Record, SampleUse, Signal, has};
use crate::ContactLawError;

/// Part of the largest deviation at which the contact is taken to begin and to end.
const THRESHOLD: f64 = 0.15;
/// Part of the duration that a record needs before the touch, for the zero of the sensors.
const LEAST_FREE: f64 = 0.02;
/// Durations of the contact before the touch, and after the separation, that are used.
const USED_BEFORE: f64 = 2.0;
const USED_AFTER: f64 = 1.0;
/// Fewest equal samples in a row at a limit of a sensor.
const LEAST_CLIPPED: usize = 3;
/// Part of the largest deviation by which a spike differs from the median of its neighbours; more than the curvature of a contact of this
/// many samples.
const SPIKE: f64 = 0.2;
const DENSE: f64 = 20.0;
/// Steps of the resolution by which the neighbours of clipped samples differ. A smooth peak of equal samples has neighbours within a few.
const STEPS_BESIDE_CLIPPED: f64 = 8.0;

/// Record, cut around its impact, and first estimates.
#[derive(Clone, Debug)]
pub(super) struct Start {
    /// Index of the first sample in the record.
    pub first: usize,
    pub times: Vec<f64>,
    pub signals: Vec<StartSignal>,
    /// Time of the touch, s.
    pub touch: f64,
    /// Duration of the contact, s.
    pub duration: f64,
    /// Median distance of two samples, s.
    pub spacing: f64,
}

/// Signal in the direction of the penetration.
#[derive(Clone, Debug)]
pub(super) struct StartSignal {
    pub quantity: Measured,
    pub is_reversed: bool,
    pub values: Vec<f64>,
    pub uses: Vec<SampleUse>,
    /// Limit of the sensor, if a sample is at it.
    pub limit: Option<f64>,
    /// Value at the touch.
    pub offset: f64,
    /// Largest deviation from the offset.
    pub amplitude: f64,
}

impl Start {
    /// Finds the impact of a record; `number` counts the records from 0.
    pub fn new(record: &Record, number: usize) -> Result<Self, ContactLawError> {
        let refuse = |why: &str| Err(ContactLawError::Record { record: Some(number), why: why.to_owned() });
        let times = &record.times;
        let by_quantity = |quantity| record.signals.iter().find(|signal| signal.quantity == quantity);
        let pulse = by_quantity(Measured::Force).or_else(|| by_quantity(Measured::Acceleration));
        let found = match (pulse, by_quantity(Measured::Velocity)) {
            (Some(pulse), _) => of_pulse(times, &without_outliers(&pulse.values)),
            (None, Some(velocity)) => of_velocity(times, &without_outliers(&velocity.values)),
            (None, None) => of_displacement(times, &without_outliers(&record.signals[0].values)),
        };
        let Some([touch, end]) = found else {
            return refuse(
                "no impact is found; expected one pulse of the force or the acceleration, or a reversal of the motion",
            );
        };
        let duration = end - touch;
        if touch < times[0] + LEAST_FREE * duration {
            return refuse(
                "it begins during the contact; expected a part before the touch, at least a tenth of the contact",
            );
        }
        let (from, to) = (touch - USED_BEFORE * duration, end + USED_AFTER * duration);
        let first = times.partition_point(|time| *time < from);
        let last = times.partition_point(|time| *time <= to);
        if last - first < LEAST_SAMPLES {
            return refuse("less than 20 samples around the impact; record at a higher rate");
        }
        let times = times[first..last].to_vec();
        let at_touch = times.partition_point(|time| *time < touch).min(times.len() - 1);
        let mut spacings: Vec<f64> = times.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let spacing = median(&mut spacings);
        let signals = record.signals.iter().map(|signal| StartSignal::new(signal, first..last, at_touch));
        let is_dense = duration > DENSE * spacing;
        let signals: Vec<StartSignal> =
            signals.map(|signal| if is_dense { signal.without_spikes() } else { signal }).collect();
        let free =
            |signal: &StartSignal| signal.uses.iter().filter(|state| **state == SampleUse::Used).count();
        let is_idle = |signal: &&StartSignal| {
            signal.amplitude.is_nan() || signal.amplitude <= 0.0 || free(signal) < LEAST_SAMPLES
        };
        if let Some(signal) = signals.iter().find(is_idle) {
            let (name, _) = signal.quantity.name_and_unit();
            return refuse(&format!("the {name} has no impact in its values; remove or ignore it"));
        }
        Ok(Self { first, times, signals, touch, duration, spacing })
    }

    /// Every `stride`-th sample.
    pub fn thin(&mut self, stride: usize) {
        fn thin<T: Copy>(values: &mut Vec<T>, stride: usize) {
            *values = values.iter().copied().step_by(stride).collect();
        }
        thin(&mut self.times, stride);
        for signal in &mut self.signals {
            thin(&mut signal.values, stride);
            thin(&mut signal.uses, stride);
        }
        self.spacing *= stride as f64;
    }

    /// First estimates of approach speed (m/s), mass (kg) and penetration (m).
    pub fn estimates(&self, record: &Record, mass: Option<f64>) -> [f64; 3] {
        let amplitude = |quantity| {
            let found = self.signals.iter().find(|signal| signal.quantity == quantity);
            found.map(|signal| signal.amplitude).filter(|amplitude| *amplitude > 0.0)
        };
        let force = amplitude(Measured::Force);
        let acceleration = amplitude(Measured::Acceleration).or_else(|| Some(force? / mass?));
        // The pulse of a linear spring: acceleration a, speed a/w, penetration a/w^2 with the half period pi/w.
        let frequency = std::f64::consts::PI / self.duration;
        let depth = amplitude(Measured::Displacement);
        let speed = record
            .speed
            .or_else(|| amplitude(Measured::Velocity))
            .or_else(|| Some(acceleration? / frequency))
            .or_else(|| Some(depth? * frequency))
            .unwrap_or(1.0);
        let depth = depth.unwrap_or(speed / frequency);
        let acceleration = acceleration.unwrap_or(speed * frequency);
        let mass = match force {
            Some(force) if has(record, Measured::Force) => force / acceleration,
            _ => mass.unwrap_or(1.0),
        };
        [speed, mass, depth]
    }
}

impl StartSignal {
    fn new(signal: &Signal, range: std::ops::Range<usize>, at_touch: usize) -> Self {
        let quantity = signal.quantity;
        let values = &signal.values[range];
        let smooth = without_outliers(values);
        let (least, most) = (minimum(&smooth), maximum(&smooth));
        let (start, end) = (smooth[0], smooth[smooth.len() - 1]);
        let offset = match quantity {
            Measured::Force | Measured::Acceleration => baseline(values),
            Measured::Velocity => 0.0,
            Measured::Displacement => smooth[at_touch],
        };
        let is_reversed = match quantity {
            Measured::Force | Measured::Acceleration => offset - least > most - offset,
            Measured::Velocity => start < end,
            // The turning point is inside, the ends are not.
            Measured::Displacement => start.min(end) - least > most - start.max(end),
        };
        let sign = if is_reversed { -1.0 } else { 1.0 };
        let turned: Vec<f64> = values.iter().map(|value| sign * value).collect();
        let limit = clip_limit(&turned, sign * offset, if is_reversed { -least } else { most });
        let is_at_limit = |value: &f64| limit.is_some_and(|limit| *value == limit);
        let uses = turned
            .iter()
            .map(|value| if is_at_limit(value) { SampleUse::AtLimit } else { SampleUse::Used })
            .collect();
        let offset = sign * offset;
        let amplitude = match quantity {
            Measured::Velocity => least.abs().max(most.abs()),
            _ => {
                if is_reversed {
                    -least - offset
                } else {
                    most - offset
                }
            }
        };
        Self { quantity, is_reversed, values: turned, uses, limit, offset, amplitude }
    }
}

impl StartSignal {
    /// The signal without samples that are far from the median of their neighbours, for the first fit: the search would begin at a wrong
    /// place.
    fn without_spikes(mut self) -> Self {
        let smooth = without_outliers(&self.values);
        for (number, value) in self.values.iter().enumerate() {
            if self.uses[number] == SampleUse::Used && (value - smooth[number]).abs() > SPIKE * self.amplitude
            {
                self.uses[number] = SampleUse::Outlier;
            }
        }
        self
    }
}

/// Value of a sensor at its limit: equal samples in a row, with neighbours that are far away for the resolution. `limit`: largest value
/// without outliers.
fn clip_limit(values: &[f64], offset: f64, limit: f64) -> Option<f64> {
    if limit <= offset {
        return None;
    }
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let differences = sorted.windows(2).map(|pair| pair[1] - pair[0]).filter(|difference| *difference > 0.0);
    let resolution = differences.fold(f64::INFINITY, f64::min);
    let mut first = 0;
    for run in values.chunk_by(|a, b| (*a == limit) == (*b == limit)) {
        let end = first + run.len();
        if run[0] == limit && run.len() >= LEAST_CLIPPED {
            let beside = [first.checked_sub(1), Some(end)].into_iter().flatten();
            let mut beside = beside.filter_map(|at| values.get(at));
            if beside.all(|value| (limit - value).abs() > STEPS_BESIDE_CLIPPED * resolution) {
                return Some(limit);
            }
        }
        first = end;
    }
    None
}

/// Beginning and end of a pulse, from the threshold to the base by the mean slope.
fn of_pulse(times: &[f64], values: &[f64]) -> Option<[f64; 2]> {
    let base = baseline(values);
    let deviation: Vec<f64> = values.iter().map(|value| (value - base).abs()).collect();
    let peak = (0..values.len()).max_by(|a, b| deviation[*a].total_cmp(&deviation[*b]))?;
    let limit = THRESHOLD * deviation[peak];
    if limit == 0.0 {
        return None;
    }
    let is_pulse = |at: &usize| deviation[*at] > limit;
    let first = (0..=peak).rev().take_while(is_pulse).last()?;
    let last = (peak..values.len()).take_while(is_pulse).last()?;
    let beyond = 0.5 * THRESHOLD * (times[last] - times[first]);
    (last > first + 2).then(|| [times[first] - beyond, times[last] + beyond])
}

/// Beginning and end of the reversal of a speed: from its largest value, which a free fall reaches at the touch.
fn of_velocity(times: &[f64], values: &[f64]) -> Option<[f64; 2]> {
    let last = values.len() - 1;
    let peak = (0..last).max_by(|a, b| values[*a].abs().total_cmp(&values[*b].abs()))?;
    let part = |at: usize| values[at] / values[peak];
    let turn = (peak..=last).find(|at| part(*at) < 0.0)?;
    let first = (peak..turn).rev().find(|at| part(*at) > 1.0 - THRESHOLD)?;
    (turn > first).then(|| [times[first], times[first] + 2.0 * (times[turn] - times[first])])
}

/// Beginning and end of the reversal of a displacement: where it leaves the line of its first part, to as long after the turn.
fn of_displacement(times: &[f64], values: &[f64]) -> Option<[f64; 2]> {
    let (count, start, end) = (values.len(), values[0], values[values.len() - 1]);
    let is_reversed = start.min(end) - minimum(values) > maximum(values) - start.max(end);
    let sign = if is_reversed { -1.0 } else { 1.0 };
    let turn = (0..count).max_by(|a, b| (sign * values[*a]).total_cmp(&(sign * values[*b])))?;
    let part = (turn / 3).max(2);
    if part >= turn {
        return None;
    }
    let slope = (values[part] - start) / (times[part] - times[0]);
    let from_line = |at: usize| (values[at] - start - slope * (times[at] - times[0])).abs();
    let first = (0..turn).rev().take_while(|at| from_line(*at) > THRESHOLD * from_line(turn)).last()?;
    (turn > first).then(|| [times[first], times[first] + 2.0 * (times[turn] - times[first])])
}

/// Medians of five neighbours.
fn without_outliers(values: &[f64]) -> Vec<f64> {
    let last = values.len() - 1;
    (0..=last).map(|at| median(&mut values[at.saturating_sub(2)..=(at + 2).min(last)].to_vec())).collect()
}

/// Value of a signal without contact: the median of its first twentieth.
fn baseline(values: &[f64]) -> f64 {
    median(&mut values[..(values.len() / 20).max(3)].to_vec())
}

/// Median.
pub(super) fn median(values: &mut [f64]) -> f64 {
    let middle = values.len() / 2;
    *values.select_nth_unstable_by(middle, f64::total_cmp).1
}

fn minimum(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::INFINITY, f64::min)
}

fn maximum(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::NEG_INFINITY, f64::max)
}
