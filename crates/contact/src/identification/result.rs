//! Uncertainties of the unknowns, and the quantities that follow from them.

use super::fit::{DIFFERENCE, Fit, add, drifts};
use super::record::{Estimate, Identification, IdentifiedRecord, IdentifiedSignal, SampleUse};
use crate::ContactLawError;
use nalgebra::{DMatrix, DVector};

/// Most lags of an autocorrelation: a longer one is an error of the law.
const MOST_LAGS: usize = 500;
/// Steps of the integration for key figures: the largest of the samples lies 1e-6 below the maximum.
const STEPS_OF_FIGURES: f64 = 2000.0;

impl Fit<'_> {
    /// Covariance of the unknowns with the correlations of the residuals, and the number of correlated samples of each signal.
    fn covariance(&self) -> Option<(DMatrix<f64>, Vec<Vec<usize>>)> {
        let size = self.unknowns.len();
        let (mut normal, mut scores) = (DMatrix::zeros(size, size), DMatrix::zeros(size, size));
        let mut lengths = Vec::new();
        for record in 0..self.records.len() {
            let (columns, jacobian) = self.jacobian(&self.unknowns, record)?;
            let residuals = self.residuals(&self.unknowns, record)?;
            let count = self.starts[record].times.len();
            let mut of_record = Vec::new();
            for number in 0..self.starts[record].signals.len() {
                let own = residuals.rows(number * count, count);
                let rows = jacobian.rows(number * count, count);
                let square = rows.tr_mul(&rows);
                add(&mut normal, &columns, &square);
                let mut sum = square;
                let mut length = 0;
                let total = own.norm_squared();
                let significant = 2.0 / (count as f64).sqrt();
                while total > 0.0 && length < MOST_LAGS.min(count / 4) {
                    let lag = length + 1;
                    let product = own.rows(0, count - lag).dot(&own.rows(lag, count - lag));
                    if product / total <= significant {
                        break;
                    }
                    let pairs = rows.rows(0, count - lag).tr_mul(&rows.rows(lag, count - lag));
                    sum += (&pairs + pairs.transpose()) * (product / total);
                    length = lag;
                }
                of_record.push(length);
                add(&mut scores, &columns, &sum);
            }
            lengths.push(of_record);
        }
        let inverse = inverse(&normal)?;
        let mut covariance = &inverse * scores * &inverse;
        // Estimated correlations may give less than the variance without them, or a negative one.
        let factor = |k: usize| {
            let (plain, correlated) = (inverse[(k, k)], covariance[(k, k)]);
            if correlated > 0.0 { (plain / correlated).max(1.0).sqrt() } else { f64::NAN }
        };
        let factors: Vec<f64> = (0..size).map(factor).collect();
        if factors.iter().any(|factor| factor.is_nan()) {
            return Some((inverse, lengths));
        }
        for i in 0..size {
            for j in 0..size {
                covariance[(i, j)] *= factors[i] * factors[j];
            }
        }
        Some((covariance, lengths))
    }

    /// Quantities of the result: mass, stiffness, exponent, damping, then of each record speed, restitution, force, penetration, duration and
    /// touch.
    fn figures(&self, unknowns: &DVector<f64>) -> Option<DVector<f64>> {
        let contact = self.contact(unknowns)?;
        let mut all = vec![contact.mass, contact.stiffness, contact.exponent, contact.damping];
        for record in 0..self.records.len() {
            let (touch, speed) = self.approach(unknowns, record);
            all.push(speed);
            all.extend(self.motion(unknowns, record, STEPS_OF_FIGURES)?.key_figures());
            all.push(touch);
        }
        Some(DVector::from_vec(all))
    }

    /// Result with uncertainties.
    pub fn identification(&self) -> Result<Identification, ContactLawError> {
        self.result().ok_or_else(|| ContactLawError::Record {
            record: None,
            why: format!("the records do not determine all unknowns{}", self.more()),
        })
    }

    /// What else may be given, for a refusal.
    fn more(&self) -> String {
        let open = [
            ("the exponent", self.known.exponent.is_none()),
            ("the mass", self.finds_mass),
            ("the approach speed", self.records.iter().any(|record| record.speed.is_none())),
        ];
        let names: Vec<&str> =
            open.into_iter().filter(|(_, is_open)| *is_open).map(|(name, _)| name).collect();
        if names.is_empty() { String::new() } else { format!("; give {}", names.join(" or ")) }
    }

    fn result(&self) -> Option<Identification> {
        let (covariance, lengths) = self.covariance()?;
        let figures = self.figures(&self.unknowns)?;
        let mut slopes = DMatrix::zeros(figures.len(), self.unknowns.len());
        for k in 0..self.unknowns.len() {
            let shifted = |by: f64| {
                let mut shifted = self.unknowns.clone();
                shifted[k] += by;
                self.figures(&shifted)
            };
            let slope = (shifted(DIFFERENCE)? - shifted(-DIFFERENCE)?) / (2.0 * DIFFERENCE);
            slopes.set_column(k, &slope);
        }
        let of_figures = &slopes * &covariance * slopes.transpose();
        let deviation = |k: usize| of_figures[(k, k)].max(0.0).sqrt();
        let estimate = |k: usize| Estimate { value: figures[k], uncertainty: deviation(k) };
        let correlation = |i: usize, j: usize| {
            let scale = deviation(i) * deviation(j);
            if scale > 0.0 {
                (of_figures[(i, j)] / scale).clamp(-1.0, 1.0)
            } else {
                f64::from(u8::from(i == j))
            }
        };
        let all_are_finite = (0..figures.len()).all(|k| figures[k].is_finite() && deviation(k).is_finite());
        let records: Option<Vec<IdentifiedRecord>> = (0..self.records.len())
            .map(|record| {
                let first = 4 + 6 * record;
                let start = &self.starts[record];
                let [speed, restitution, peak_force, max_penetration, contact_duration, touch] =
                    [0, 1, 2, 3, 4, 5].map(|k| estimate(first + k));
                Some(IdentifiedRecord {
                    speed,
                    restitution,
                    peak_force,
                    max_penetration,
                    contact_duration,
                    touch,
                    used: [start.times[0], start.times[start.times.len() - 1]],
                    unused_samples: self.records[record].times.len() - start.times.len(),
                    first: start.first,
                    signals: self.signals(record, &covariance, &lengths[record])?,
                })
            })
            .collect();
        all_are_finite.then_some(Identification {
            damper: self.form,
            other_form: self.other_form,
            mass: estimate(0),
            finds_mass: self.finds_mass,
            stiffness: estimate(1),
            exponent: estimate(2),
            damping: estimate(3),
            correlation: std::array::from_fn(|i| std::array::from_fn(|j| correlation(i, j))),
            records: records?,
        })
    }

    /// Signals of a record with offsets, residuals and the fitted values.
    fn signals(
        &self,
        record: usize,
        covariance: &DMatrix<f64>,
        lengths: &[usize],
    ) -> Option<Vec<IdentifiedSignal>> {
        let values = self.values(&self.unknowns, record)?;
        let start = &self.starts[record];
        let count = start.times.len();
        let mut at = self.firsts[record] + 1 + usize::from(self.records[record].speed.is_none());
        let mut all = Vec::new();
        for (number, signal) in start.signals.iter().enumerate() {
            let sign = if signal.is_reversed { -1.0 } else { 1.0 };
            let drifts = drifts(signal.quantity);
            let linear = |k: usize, scale: f64, from: f64| {
                (k < drifts).then(|| Estimate {
                    value: sign * (from + scale * self.unknowns[at + k]),
                    uncertainty: scale * covariance[(at + k, at + k)].max(0.0).sqrt(),
                })
            };
            let span = start.times[count - 1] - start.times[0];
            let fitted = values.rows(number * count, count);
            let parts = fitted.iter().zip(&signal.values).zip(&signal.uses);
            let used = parts.filter(|(_, state)| **state == SampleUse::Used).map(|((a, b), _)| a - b);
            let used: Vec<f64> = used.collect();
            let residual = (used.iter().map(|r| r * r).sum::<f64>() / used.len().max(1) as f64).sqrt();
            let times_of = |state| {
                let found = signal.uses.iter().zip(&start.times).filter(move |(own, _)| **own == state);
                found.map(|(_, time)| *time)
            };
            all.push(IdentifiedSignal {
                quantity: signal.quantity,
                is_reversed: signal.is_reversed,
                offset: linear(0, signal.amplitude, signal.offset),
                drift: linear(1, signal.amplitude / span, 0.0),
                residual,
                relative_residual: residual / signal.amplitude,
                correlation_time: lengths[number] as f64 * start.spacing,
                clipped: times_of(SampleUse::AtLimit).count(),
                outliers: times_of(SampleUse::Outlier).collect(),
                uses: signal.uses.clone(),
                fitted: fitted.iter().map(|value| sign * value).collect(),
            });
            at += drifts;
        }
        Some(all)
    }
}

/// Inverse of a positive definite matrix, scaled to a diagonal of ones; `None` if it is singular to rounding.
fn inverse(matrix: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let scales: Vec<f64> = matrix.diagonal().iter().map(|x| x.sqrt()).collect();
    if scales.iter().any(|scale| !scale.is_normal()) {
        return None;
    }
    let scaled =
        DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, j| matrix[(i, j)] / scales[i] / scales[j]);
    let inverse = scaled.cholesky()?.inverse();
    // 1e-12: the derivatives have errors of 1e-8, their products of 1e-16.
    let is_determined = inverse.diagonal().max() < 1e12;
    is_determined.then(|| {
        DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, j| inverse[(i, j)] / scales[i] / scales[j])
    })
}
