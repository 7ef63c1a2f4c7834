//! Uncertainties of the unknowns, and the quantities that follow from them.

use super::fit::{Fit, drifts};
use super::record::{
    EXPONENTS, Estimate, Identification, IdentifiedRecord, IdentifiedSignal, Known, OtherModel, SampleUse,
};
use super::search::{add, derivative, hold};
use crate::ContactLawError;
use nalgebra::{DMatrix, DVector};

/// Most lags of an autocorrelation: a longer one is an error of the law.
const MOST_LAGS: usize = 500;
/// Steps of the integration for key figures: the largest of the samples lies 1e-6 below the maximum.
const STEPS_OF_FIGURES: f64 = 2000.0;
/// Decrease of twice the negative log-likelihood, with independent residuals, above which another unknown is significant: five standard
/// deviations.
const SIGNIFICANT: f64 = 25.0;
/// Part of the scaled normal equations that is added where they are singular: the derivatives have errors of 1e-8, their products of 1e-16.
const SINGULAR: f64 = 1e-12;
/// Standard acceleration of free fall, m/s².
const FREE_FALL: f64 = 9.80665;
/// Standard deviations by which the mean square of the residuals during the contact exceeds that beside it.
const EXCESS: f64 = 4.0;
/// Standard uncertainties by which two results differ.
const AGREEMENT: f64 = 2.0;

/// Covariance of the unknowns, and the correlation of the residuals.
struct Covariance {
    matrix: DMatrix<f64>,
    /// Correlation of the residuals of each signal of each record.
    correlations: Vec<Vec<Autocorrelation>>,
}

/// Autocorrelation of residuals.
#[derive(Clone, Copy, Debug)]
struct Autocorrelation {
    /// Number of correlated samples.
    length: usize,
    /// Samples for an independent one: 1 + 2 Σ ρ.
    per_independent: f64,
}

/// Comparison of a fit with other models of the records.
#[derive(Debug)]
pub(super) struct Comparison {
    /// Mean square of the residuals with the other form of the damper, divided by that of the fit.
    other_form: Option<f64>,
    /// The fit with one term of the spring, or with two; `None` if two are not significantly better.
    other_spring: Option<(f64, DVector<f64>)>,
    weighed: Option<OtherWeight>,
}

/// The fit with the weight, or without a given weight.
#[derive(Debug)]
struct OtherWeight {
    gain: f64,
    ratio: f64,
    figures: DVector<f64>,
}

impl Fit<'_> {
    /// Mean square of the residuals of another fit divided by that of this fit.
    pub fn ratio_of(&self, other: &Self) -> f64 {
        let samples: usize = self.starts.iter().map(|start| start.times.len() * start.signals.len()).sum();
        (2.0 * (other.misfit() - self.misfit()) / samples as f64).exp()
    }

    /// Twice the increase of the log-likelihood by another fit, for correlated residuals.
    fn gain(&self, other: &Self) -> Option<f64> {
        let all = other.covariance()?.correlations.concat();
        let per_independent = all.iter().map(|own| own.per_independent).fold(1.0, f64::max);
        Some(2.0 * (self.misfit() - other.misfit()) / per_independent)
    }

    /// True if a fit with two terms of the spring is significantly better.
    pub fn needs_second_term(&self, second: &Self) -> bool {
        let gain = 2.0 * (self.misfit() - second.misfit());
        let is_contradicted = || self.covariance().is_none_or(|own| self.largest_excess(&own) > 1.0);
        let is_significant = |gain: f64| gain > SIGNIFICANT;
        is_significant(gain) && (self.gain(second).is_some_and(is_significant) || is_contradicted())
    }

    /// Comparison with another spring, and with the weight or without it.
    pub fn compared(&self, other_form: Option<f64>, other_spring: Option<&Self>) -> Comparison {
        let figures = |fit: &Self| fit.figures(&fit.unknowns);
        let gravity = if self.known.gravity == 0.0 { FREE_FALL } else { 0.0 };
        let weighed = Self { known: Known { gravity, ..self.known }, ..self.clone() }.refined();
        let weighed = weighed.and_then(|other| {
            let (gain, ratio) = (self.gain(&other)?, self.ratio_of(&other));
            Some(OtherWeight { gain, ratio, figures: figures(&other)? })
        });
        let other_spring = other_spring.and_then(|other| Some((self.ratio_of(other), figures(other)?)));
        Comparison { other_form, other_spring, weighed }
    }

    /// Largest [`excess`](Self::excess) of all signals; 1 if none is significant.
    fn largest_excess(&self, covariance: &Covariance) -> f64 {
        let mut largest = 1.0f64;
        for (record, correlations) in covariance.correlations.iter().enumerate() {
            let Some(values) = self.values(&self.unknowns, record) else { continue };
            let count = self.starts[record].times.len();
            for (number, own) in correlations.iter().enumerate() {
                let fitted = values.rows(number * count, count).into_owned();
                largest = largest.max(self.excess(record, number, &fitted, *own).unwrap_or(1.0));
            }
        }
        largest
    }

    /// Root mean square of the residuals of a signal during the contact, divided by that before and after it; `None` if the contact has no
    /// significantly larger residuals.
    fn excess(
        &self,
        record: usize,
        number: usize,
        fitted: &DVector<f64>,
        own: Autocorrelation,
    ) -> Option<f64> {
        if own.length == 0 {
            return None;
        }
        let start = &self.starts[record];
        let (signal, end) = (&start.signals[number], start.touch + start.duration);
        let (mut inside, mut outside) = ((0.0, 0.0), (0.0, 0.0));
        for (at, time) in start.times.iter().enumerate().filter(|(at, _)| signal.uses[*at] == SampleUse::Used)
        {
            let is_inside = (start.touch..end).contains(time);
            let (count, sum) = if is_inside { &mut inside } else { &mut outside };
            (*count, *sum) = (*count + 1.0, *sum + (fitted[at] - signal.values[at]).powi(2));
        }
        let ratio = (inside.1 / inside.0) / (outside.1 / outside.0);
        // The variance of a mean square of n independent residuals is 2/n.
        let deviation = (2.0 * own.per_independent * (1.0 / inside.0 + 1.0 / outside.0)).sqrt();
        (ratio > 1.0 + EXCESS * deviation).then(|| ratio.sqrt())
    }

    /// True if the exponent is at an end of its range.
    fn exponent_is_at_end(&self) -> bool {
        let at = self.exponent_at().map(|at| self.unknowns[at]);
        at.is_some_and(|exponent| exponent <= *EXPONENTS.start() || exponent >= *EXPONENTS.end())
    }

    /// Covariance of the unknowns with the correlations of the residuals.
    fn covariance(&self) -> Option<Covariance> {
        let size = self.unknowns.len();
        let (mut normal, mut scores) = (DMatrix::zeros(size, size), DMatrix::zeros(size, size));
        let mut correlations = Vec::new();
        for record in 0..self.records.len() {
            let residuals = self.residuals(&self.unknowns, record)?;
            let (columns, jacobian) = self.jacobian(&self.unknowns, record, &residuals, true)?;
            let count = self.starts[record].times.len();
            let of_touch = jacobian.rows(residuals.len() - 1, 1);
            let of_touch = of_touch.tr_mul(&of_touch);
            add(&mut normal, &columns, &of_touch);
            add(&mut scores, &columns, &of_touch);
            let mut of_record = Vec::new();
            for number in 0..self.starts[record].signals.len() {
                let own = residuals.rows(number * count, count);
                let rows = jacobian.rows(number * count, count);
                let square = rows.tr_mul(&rows);
                add(&mut normal, &columns, &square);
                let mut sum = square;
                let (mut length, mut per_independent) = (0, 1.0);
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
                    per_independent += 2.0 * product / total;
                    length = lag;
                }
                of_record.push(Autocorrelation { length, per_independent });
                add(&mut scores, &columns, &sum);
            }
            correlations.push(of_record);
        }
        if let Some(at) = self.exponent_at().filter(|_| self.exponent_is_at_end()) {
            hold(&mut normal, at);
            hold(&mut scores, at);
            scores[(at, at)] = 0.0;
        }
        let inverse = inverse(&normal)?;
        let mut matrix = &inverse * scores * &inverse;
        // Estimated correlations may give less than the variance without them, or a negative one.
        let factor = |k: usize| {
            let (plain, correlated) = (inverse[(k, k)], matrix[(k, k)]);
            if correlated > 0.0 { (plain / correlated).max(1.0).sqrt() } else { f64::NAN }
        };
        let held = self.exponent_at().filter(|_| self.exponent_is_at_end());
        let factors: Vec<f64> = (0..size).map(|k| if Some(k) == held { 1.0 } else { factor(k) }).collect();
        if factors.iter().any(|factor| factor.is_nan()) {
            matrix = inverse;
            if let Some(at) = held {
                matrix[(at, at)] = 0.0;
            }
            return Some(Covariance { matrix, correlations });
        }
        for i in 0..size {
            for j in 0..size {
                matrix[(i, j)] *= factors[i] * factors[j];
            }
        }
        Some(Covariance { matrix, correlations })
    }

    /// Quantities of the result: mass, stiffness, exponent, damping, then of each record speed, restitution, force, penetration, duration and
    /// touch; last the coefficient of a second term.
    fn figures(&self, unknowns: &DVector<f64>) -> Option<DVector<f64>> {
        let contact = self.contact(unknowns)?;
        let mut all = vec![contact.mass, contact.stiffness, contact.exponent, contact.damping];
        for record in 0..self.records.len() {
            let (touch, speed) = self.approach(unknowns, record);
            all.push(speed);
            all.extend(self.motion(unknowns, record, STEPS_OF_FIGURES)?.key_figures());
            all.push(touch);
        }
        all.extend(self.second.map(|_| contact.second.0));
        Some(DVector::from_vec(all))
    }

    /// Result with uncertainties.
    pub fn identification(&self, comparison: &Comparison) -> Result<Identification, ContactLawError> {
        self.result(comparison).ok_or_else(|| ContactLawError::Record {
            record: None,
            why: "the result is not finite: check units and columns, and that the records contain one impact each"
                .into(),
        })
    }

    fn result(&self, comparison: &Comparison) -> Option<Identification> {
        let covariance = self.covariance()?;
        // The ratio of Birge: the unknowns absorb an error of the law that is as large as the one that is left.
        let excess = self.largest_excess(&covariance);
        let Covariance { matrix, correlations } = covariance;
        let covariance = matrix * (excess * excess);
        let figures = self.figures(&self.unknowns)?;
        let mut slopes = DMatrix::zeros(figures.len(), self.unknowns.len());
        for k in 0..self.unknowns.len() {
            let shifted = |by: f64| {
                let mut shifted = self.unknowns.clone();
                shifted[k] += by;
                self.figures(&shifted)
            };
            slopes.set_column(k, &derivative(&figures, true, shifted)?);
        }
        let of_figures = &slopes * &covariance * slopes.transpose();
        // A spring with one term that is contradicted; its stiffness, exponent and damping have no value with two.
        let change = |k: usize| {
            let other =
                comparison.other_spring.as_ref().filter(|_| self.second.is_none() && !(1..4).contains(&k));
            other.map_or(0.0, |(_, other)| other[k] - figures[k])
        };
        let deviation = |k: usize| of_figures[(k, k)].max(0.0).sqrt().hypot(change(k));
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
                    signals: self.signals(record, &covariance, &correlations[record])?,
                })
            })
            .collect();
        all_are_finite.then_some(Identification {
            damper: self.form,
            other_form: comparison.other_form,
            second_term: self.second.map(|exponent| (estimate(figures.len() - 1), exponent)),
            other_spring: comparison
                .other_spring
                .as_ref()
                .map(|(ratio, other)| OtherModel::new(*ratio, other)),
            other_weight: comparison.weighed.as_ref().and_then(|other| {
                let differs = |k: usize| (other.figures[k] - figures[k]).abs() > AGREEMENT * deviation(k);
                let is_near = other.gain > -SIGNIFICANT;
                let model = OtherModel::new(other.ratio, &other.figures);
                (other.gain > SIGNIFICANT || is_near && (4..9).any(differs))
                    .then_some((other.gain > SIGNIFICANT, model))
            }),
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
        correlations: &[Autocorrelation],
    ) -> Option<Vec<IdentifiedSignal>> {
        let values = self.values(&self.unknowns, record)?;
        let start = &self.starts[record];
        let count = start.times.len();
        let mut at = self.zeros_at(record);
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
                correlation_time: correlations[number].length as f64 * start.spacing,
                excess: self.excess(record, number, &fitted.into_owned(), correlations[number]),
                clipped: times_of(SampleUse::AtLimit).count(),
                outliers: times_of(SampleUse::Outlier).collect(),
                at_touch: times_of(SampleUse::AtTouch).count(),
                uses: signal.uses.clone(),
                fitted: fitted.iter().map(|value| sign * value).collect(),
            });
            at += drifts;
        }
        Some(all)
    }
}

/// Inverse of a positive semidefinite matrix, scaled to a diagonal of ones; a singular one with [`SINGULAR`] on the diagonal, which gives
/// directions that nothing determines a large variance.
fn inverse(matrix: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let scale = |x: &f64| if *x > 0.0 { x.sqrt() } else { 1.0 };
    let scales: Vec<f64> = matrix.diagonal().iter().map(scale).collect();
    let scaled =
        DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, j| matrix[(i, j)] / scales[i] / scales[j]);
    let plain = scaled.clone().cholesky().map(|factor| factor.inverse());
    let inverse = plain.filter(|inverse| inverse.diagonal().max() < 1.0 / SINGULAR).or_else(|| {
        let identity = DMatrix::identity(matrix.nrows(), matrix.ncols());
        [1.0, 1e3].into_iter().find_map(|factor| {
            let regular = &scaled + &identity * (factor * SINGULAR);
            regular.cholesky().map(|factor| factor.inverse())
        })
    })?;
    Some(DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, j| inverse[(i, j)] / scales[i] / scales[j]))
}
