//! Unknowns of the records and of their common contact, the computed signals and their residuals.

use super::motion::{Contact, Filter, Motion};
use super::record::{DamperForm, EXPONENTS, Known, MOST_SAMPLES, Measured, Record, SampleUse, finds_mass};
use super::start::Start;
use crate::ContactLawError;
use nalgebra::DVector;

/// Steps of the integration over the estimated duration: the error of the motion is 1e-8.
pub(super) const STEPS: f64 = 200.0;
/// Lengths of the used record over which a filter may reach.
const MOST_REACH: usize = 3;
/// Samples over which a filter reaches at least when samples are left out: 40 per radian of its angle.
const LEAST_REACH: usize = 60;
/// Part of the amplitude below which residuals are rounding.
pub(super) const LEAST_RESIDUAL: f64 = 1e-9;
/// Samples of a record that suffice for a search far from the result, and samples that a contact needs.
const FEW: usize = 300;
const FEW_IN_CONTACT: f64 = 60.0;
/// First coefficient of the second term of a spring, as a part of the force.
const SECOND: f64 = 0.1;
/// Exponent above which the second term of a spring is linear; below it is cubic.
const PROGRESSIVE: f64 = 1.25;

/// Search of the unknowns of records.
#[derive(Clone, Debug)]
pub(super) struct Fit<'a> {
    pub known: Known,
    pub form: DamperForm,
    pub records: &'a [Record],
    pub starts: Vec<Start>,
    pub filters: Vec<Option<Filter>>,
    /// Scale of penetrations, m: the stiffness is given by the force at this penetration.
    pub depth: f64,
    pub mass: f64,
    pub finds_mass: bool,
    /// Exponent of a second term of the spring, if its coefficient is unknown.
    pub second: Option<f64>,
    /// Index of the first unknown of each record; the first are common.
    pub firsts: Vec<usize>,
    /// Standard deviation of each signal of each record.
    pub deviations: Vec<Vec<f64>>,
    /// Time of the touch that a jump of the force determines, and its standard deviation, s.
    pub touches: Vec<Option<(f64, f64)>>,
    pub unknowns: DVector<f64>,
}

/// Residuals of a record, signal after signal, divided by their standard deviation; 0 for samples that are not used. The last one is that of
/// the touch.
pub(super) type Residuals = DVector<f64>;

impl<'a> Fit<'a> {
    /// First estimates.
    pub fn new(records: &'a [Record], known: Known, form: DamperForm) -> Result<Self, ContactLawError> {
        let starts: Vec<Start> = (0..)
            .zip(records)
            .map(|(number, record)| Start::new(record, number))
            .collect::<Result<_, _>>()?;
        let samples: usize = starts.iter().map(|start| start.times.len() * start.signals.len()).sum();
        if samples > MOST_SAMPLES {
            let why = format!(
                "{samples} samples around the impacts; expected {MOST_SAMPLES} at most: take every tenth sample"
            );
            return Err(ContactLawError::Record { record: None, why });
        }
        let filter = |(number, start): (usize, &Start)| {
            let Some(class) = known.filter_class else { return Ok(None) };
            let refuse = |why: String| Err(ContactLawError::Record { record: Some(number), why });
            let uneven = |pair: &[f64]| (pair[1] - pair[0] - start.spacing).abs() > 0.01 * start.spacing;
            if start.times.windows(2).any(uneven) {
                return refuse("a filter class is given, and the samples have no equal distances".into());
            }
            match Filter::new(class, start.spacing) {
                Some(filter) if filter.reach <= MOST_REACH * start.times.len() => Ok(Some(filter)),
                Some(_) => refuse(format!(
                    "filter class {class}: the filter is slower than the record; state its class in Hz"
                )),
                None => refuse(format!(
                    "filter class {class}: expected one below {:.1} Hz, for this distance of samples",
                    0.5 / 2.0775 / start.spacing
                )),
            }
        };
        let filters = (0..).zip(&starts).map(filter).collect::<Result<_, _>>()?;
        let of_mass = records.iter().position(finds_mass);
        let finds_mass = of_mass.is_some();
        let estimates: Vec<[f64; 3]> =
            starts.iter().zip(records).map(|(start, record)| start.estimates(record, known.mass)).collect();
        let mass = of_mass.map_or(known.mass.unwrap_or(1.0), |record| estimates[record][1]);
        let depth = estimates.iter().map(|estimate| estimate[2]).fold(0.0, f64::max);
        let common = usize::from(finds_mass) + 2 + usize::from(known.exponent.is_none());
        let mut unknowns = vec![0.0; common];
        let mut firsts = Vec::new();
        let mut deviations = Vec::new();
        for ((start, record), [speed, ..]) in starts.iter().zip(records).zip(&estimates) {
            firsts.push(unknowns.len());
            unknowns.push(0.0);
            if record.speed.is_none() {
                unknowns.push(speed.ln());
            }
            for signal in &start.signals {
                unknowns.extend(std::iter::repeat_n(0.0, drifts(signal.quantity)));
            }
            deviations.push(start.signals.iter().map(|signal| 0.05 * signal.amplitude).collect());
        }
        let unknowns = DVector::from_vec(unknowns);
        let mut fit = Self {
            known,
            form,
            records,
            starts,
            filters,
            depth,
            mass,
            finds_mass,
            second: None,
            firsts,
            deviations,
            touches: vec![None; records.len()],
            unknowns,
        };
        // The energy of the approach: k x^(p+1)/(p+1) = m v^2/2 at the scale of penetrations.
        let speed = estimates[0][0];
        let force = mass * speed * speed / depth;
        if finds_mass {
            fit.unknowns[0] = mass.ln();
        }
        fit.unknowns[usize::from(finds_mass)] = force.ln();
        Ok(fit)
    }

    /// Negative log-likelihood of normal residuals without constants; with equal scales for both forms of a damper.
    pub fn misfit(&self) -> f64 {
        let mut sum = 0.0;
        for (start, deviations) in self.starts.iter().zip(&self.deviations) {
            for (signal, deviation) in start.signals.iter().zip(deviations) {
                let used = signal.uses.iter().filter(|state| **state == SampleUse::Used).count() as f64;
                sum += used * (deviation / signal.amplitude).max(LEAST_RESIDUAL).ln();
            }
        }
        sum
    }

    /// The fit with every n-th sample, for a search far from the result.
    pub fn thinned(&self) -> Self {
        let mut thin = self.clone();
        for (start, filter) in thin.starts.iter_mut().zip(&mut thin.filters) {
            let of_contact = start.duration / start.spacing / FEW_IN_CONTACT;
            let stride = (start.times.len() / FEW).min(of_contact as usize).max(1);
            let coarse =
                self.known.filter_class.and_then(|class| Filter::new(class, stride as f64 * start.spacing));
            if filter.is_none() || coarse.is_some_and(|coarse| coarse.reach > LEAST_REACH) {
                *filter = coarse;
                start.thin(stride);
            }
        }
        thin
    }

    /// First estimates with a second term of the spring, with the variances and the used samples of this fit.
    pub fn with_second_term(&self) -> Option<Self> {
        let exponent = self.contact(&self.unknowns)?.exponent;
        let first = Self::new(self.records, self.known, self.form).ok()?;
        let unknowns = first.unknowns.insert_row(self.damping_at() + 1, SECOND);
        let firsts = self.firsts.iter().map(|first| first + 1).collect();
        let second = Some(if exponent > PROGRESSIVE { 1.0 } else { 3.0 });
        Some(Self { second, unknowns, firsts, ..self.clone() })
    }

    /// Index of an unknown exponent.
    pub fn exponent_at(&self) -> Option<usize> {
        self.known.exponent.is_none().then_some(usize::from(self.finds_mass) + 1)
    }

    /// Index of the damping.
    pub fn damping_at(&self) -> usize {
        self.firsts[0] - 1 - usize::from(self.second.is_some())
    }

    /// Index of the first zero of a sensor of a record.
    pub fn zeros_at(&self, record: usize) -> usize {
        self.firsts[record] + 1 + usize::from(self.records[record].speed.is_none())
    }

    /// Contact of the unknowns.
    pub fn contact(&self, unknowns: &DVector<f64>) -> Option<Contact> {
        let mut values = unknowns.iter().copied();
        let mass = if self.finds_mass { values.next()?.exp() } else { self.mass };
        let force = values.next()?.exp();
        let exponent = match self.known.exponent {
            Some(exponent) => exponent,
            None => values.next()?,
        };
        let damping = values.next()?;
        let second = match self.second {
            Some(power) => (values.next()? * force / self.depth.powf(power), power),
            None => (0.0, 1.0),
        };
        let speed = self.scale_of_speed();
        let stiffness = force / self.depth.powf(exponent);
        let damping = match self.form {
            DamperForm::HuntCrossley => damping / speed,
            DamperForm::KelvinVoigt => {
                damping * force / speed / self.depth.powf(0.5 * (exponent - 1.0).max(0.0))
            }
        };
        let is_valid = EXPONENTS.contains(&exponent)
            && [mass, stiffness].iter().all(|x| x.is_normal())
            && damping.is_finite();
        is_valid.then_some(Contact {
            mass,
            stiffness,
            exponent,
            second,
            damping,
            form: self.form,
            gravity: self.known.gravity,
        })
    }

    /// Scale of speeds, m/s.
    fn scale_of_speed(&self) -> f64 {
        self.depth * std::f64::consts::PI / self.starts[0].duration
    }

    /// Touch (s) and approach speed (m/s) of a record.
    pub fn approach(&self, unknowns: &DVector<f64>, record: usize) -> (f64, f64) {
        let (start, first) = (&self.starts[record], self.firsts[record]);
        let touch = start.touch + start.duration * unknowns[first];
        (touch, self.records[record].speed.unwrap_or_else(|| unknowns[first + 1].exp()))
    }

    pub fn motion(&self, unknowns: &DVector<f64>, record: usize, steps: f64) -> Option<Motion> {
        let (_, speed) = self.approach(unknowns, record);
        Motion::new(self.contact(unknowns)?, speed, self.starts[record].duration, steps)
            .filter(|_| speed.is_normal())
    }

    /// Values of all signals of a record, signal after signal.
    pub fn values(&self, unknowns: &DVector<f64>, record: usize) -> Option<DVector<f64>> {
        let motion = self.motion(unknowns, record, STEPS)?;
        let (start, (touch, _)) = (&self.starts[record], self.approach(unknowns, record));
        let count = start.times.len();
        let mut at = self.zeros_at(record);
        let (first, last) = (start.times[0], start.times[count - 1]);
        let filter = self.filters[record].as_ref();
        let reach = filter.map_or(0, |filter| filter.reach);
        let states = match filter {
            Some(_) => {
                let step = (last - first) / (count - 1) as f64;
                let time = |i: usize| first + step * (i as f64 - reach as f64) - touch;
                motion.states((0..count + 2 * reach).map(time))
            }
            None => motion.states(start.times.iter().map(|time| time - touch)),
        };
        let mut all = Vec::with_capacity(count * start.signals.len());
        for signal in &start.signals {
            let mut values: Vec<f64> =
                states.iter().map(|state| motion.signal(signal.quantity, state, start.spacing)).collect();
            if let Some(filter) = filter {
                filter.run(&mut values);
            }
            let drifts = drifts(signal.quantity);
            let offset = |k: usize| if k < drifts { signal.amplitude * unknowns[at + k] } else { 0.0 };
            let (constant, slope) = (signal.offset + offset(0), offset(1) / (last - first));
            let zero = start.times.iter().map(|time| constant + slope * (time - start.touch));
            all.extend(values[reach..].iter().zip(zero).map(|(value, zero)| value + zero));
            at += drifts;
        }
        Some(DVector::from_vec(all))
    }

    /// Weighted residuals of a record.
    pub fn residuals(&self, unknowns: &DVector<f64>, record: usize) -> Option<Residuals> {
        let mut residuals = self.values(unknowns, record)?;
        let start = &self.starts[record];
        let mut at = 0;
        for (signal, deviation) in start.signals.iter().zip(&self.deviations[record]) {
            for (value, state) in signal.values.iter().zip(&signal.uses) {
                let is_used = *state == SampleUse::Used;
                residuals[at] = if is_used { (residuals[at] - value) / deviation } else { 0.0 };
                at += 1;
            }
        }
        let (touch, _) = self.approach(unknowns, record);
        let of_touch = self.touches[record].map_or(0.0, |(time, deviation)| (touch - time) / deviation);
        Some(residuals.push(of_touch))
    }

    /// Derivatives of the residuals of a record by the zeros of its sensors, which are linear: index of the signal, and the values.
    pub fn slopes_of_zeros(&self, record: usize) -> impl Iterator<Item = (usize, Vec<f64>)> {
        let start = &self.starts[record];
        let span = start.times[start.times.len() - 1] - start.times[0];
        (0..).zip(&start.signals).zip(&self.deviations[record]).flat_map(
            move |((number, signal), deviation)| {
                (0..drifts(signal.quantity)).map(move |k| {
                    let slope = |(time, state): (&f64, &SampleUse)| {
                        let part = if k == 0 { 1.0 } else { (time - start.touch) / span };
                        if *state == SampleUse::Used { signal.amplitude * part / deviation } else { 0.0 }
                    };
                    (number, start.times.iter().zip(&signal.uses).map(slope).collect())
                })
            },
        )
    }

    /// Indices of the unknowns of a record.
    pub fn unknowns_of(&self, record: usize) -> impl Iterator<Item = usize> {
        let end = self.firsts.get(record + 1).copied().unwrap_or(self.unknowns.len());
        (0..self.firsts[0]).chain(self.firsts[record]..end)
    }
}

/// Number of unknowns of the zero of a sensor: offset and drift of a force and an acceleration; the offset of a displacement.
pub(super) fn drifts(quantity: Measured) -> usize {
    match quantity {
        Measured::Force | Measured::Acceleration => 2,
        Measured::Displacement => 1,
        Measured::Velocity => 0,
    }
}
