//! Nonlinear least squares with per-record and common unknowns, and the covariance of the result.

use super::motion::{Contact, Filter, Motion};
use super::start::{Start, StartSignal, median};
use super::{
    DamperForm, EXPONENTS, Estimate, Identification, IdentifiedRecord, IdentifiedSignal, Known, Measured,
    Record,
};
use crate::ContactLawError;
use nalgebra::{DMatrix, DVector};

/// Steps of the integration over the estimated duration: the error of the motion is 1e-8.
const STEPS: f64 = 200.0;
/// The same for key figures: the largest of the samples lies 1e-6 below the maximum.
const STEPS_OF_FIGURES: f64 = 2000.0;
/// Exponents and dampings from which the search begins.
const FIRST_EXPONENTS: [f64; 3] = [1.1, 1.5, 2.5];
const FIRST_DAMPINGS: [f64; 2] = [0.05, 0.5];
/// Factors of the damping from which the search is repeated, because there is often a second minimum, and the least damping.
const OTHER_DAMPINGS: [f64; 2] = [0.25, 4.0];
const LEAST_DAMPING: f64 = 0.02;
/// Iterations before the best beginning is chosen, and at most.
const FIRST_ITERATIONS: usize = 20;
const MOST_ITERATIONS: usize = 80;
/// Relative decrease of the sum of squares at which the search ends.
const CONVERGED: f64 = 1e-10;
/// Step of a difference quotient, relative to the scale of the unknown: the errors of the quotient and of rounding are both 1e-8.
const DIFFERENCE: f64 = 1e-5;
/// Residuals beyond this many robust standard deviations are outliers, if they are at most this part of the samples: one sample of 10⁸ of
/// normal noise lies beyond.
const OUTLIER: f64 = 6.0;
const MOST_OUTLIERS: f64 = 0.02;
/// Time after which the answer to a step is within 1e-3 of its end, multiplied by the channel frequency class.
const FILTER_RISE: f64 = 0.5;
/// Standard deviations below the limit of a sensor within which samples are not used.
const NEAR_LIMIT: f64 = 3.0;
/// Standard deviation of normal noise divided by the median of its magnitudes.
const NORMAL: f64 = 1.4826;
/// Part of the amplitude below which residuals are rounding.
const LEAST_RESIDUAL: f64 = 1e-9;
/// Rounds of fit and estimation of variances.
const ROUNDS: usize = 4;

/// Search of the unknowns of records.
#[derive(Clone, Debug)]
pub(super) struct Fit<'a> {
    known: &'a Known,
    form: DamperForm,
    records: &'a [Record],
    starts: Vec<Start>,
    filters: Vec<Option<Filter>>,
    /// Scale of penetrations, m: the stiffness is given by the force at this penetration.
    depth: f64,
    mass: f64,
    finds_mass: bool,
    /// Index of the first unknown of each record; the first are common.
    firsts: Vec<usize>,
    /// Standard deviation of each signal of each record.
    deviations: Vec<Vec<f64>>,
    unknowns: DVector<f64>,
    other_form: Option<f64>,
}

/// Residuals of a record, signal after signal, divided by their standard deviation; 0 for samples that are not used.
type Residuals = DVector<f64>;

impl<'a> Fit<'a> {
    /// First estimates.
    pub fn new(records: &'a [Record], known: &'a Known, form: DamperForm) -> Result<Self, ContactLawError> {
        let starts: Vec<Start> = (0..)
            .zip(records)
            .map(|(number, record)| Start::new(record, number))
            .collect::<Result<_, _>>()?;
        let filter = |(number, start): (usize, &Start)| {
            let Some(class) = known.filter_class else { return Ok(None) };
            let refuse = |why: String| Err(ContactLawError::Record { record: Some(number), why });
            let uneven = |pair: &[f64]| (pair[1] - pair[0] - start.spacing).abs() > 0.01 * start.spacing;
            if start.times.windows(2).any(uneven) {
                return refuse("a filter class is given, and the samples have no equal distances".into());
            }
            match Filter::new(class, start.spacing) {
                Some(filter) => Ok(Some(filter)),
                None => refuse(format!(
                    "filter class {class}: expected one below {:.1} Hz, for this distance of samples",
                    0.25 / 2.0775 / start.spacing
                )),
            }
        };
        let filters = (0..).zip(&starts).map(filter).collect::<Result<_, _>>()?;
        let finds_mass = records.iter().any(super::finds_mass);
        let estimates: Vec<[f64; 3]> =
            starts.iter().zip(records).map(|(start, record)| start.estimates(record, known.mass)).collect();
        let of_mass = records.iter().position(super::finds_mass).unwrap_or(0);
        let mass = if finds_mass { estimates[of_mass][1] } else { known.mass.unwrap_or(1.0) };
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
            firsts,
            deviations,
            unknowns,
            other_form: None,
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

    /// Logarithm of the likelihood of normal residuals, negative and without constants; equal scales for both forms of a damper.
    pub fn misfit(&self) -> f64 {
        let mut sum = 0.0;
        for (start, deviations) in self.starts.iter().zip(&self.deviations) {
            for (signal, deviation) in start.signals.iter().zip(deviations) {
                let used = signal.is_used.iter().filter(|is_used| **is_used).count() as f64;
                sum += used * (deviation / signal.amplitude).max(LEAST_RESIDUAL).ln();
            }
        }
        sum
    }

    /// The fit with the comparison to that with the other form.
    pub fn with_other(self, other: &Self) -> Self {
        let samples: usize =
            self.starts.iter().map(|start| start.times.len() * start.signals.len()).sum();
        let ratio = (2.0 * (other.misfit() - self.misfit()) / samples as f64).exp();
        Self { other_form: Some(ratio), ..self }
    }

    /// The best fit from several beginnings.
    pub fn best(mut self) -> Result<Self, ContactLawError> {
        let exponents = match self.known.exponent {
            Some(exponent) => vec![exponent],
            None => FIRST_EXPONENTS.to_vec(),
        };
        let at = usize::from(self.finds_mass);
        let first = self.unknowns.clone();
        let mut best: Option<(f64, DVector<f64>)> = None;
        for (exponent, damping) in
            exponents.into_iter().flat_map(|exponent| FIRST_DAMPINGS.map(|damping| (exponent, damping)))
        {
            let mut unknowns = first.clone();
            // A stiffer end at the same energy.
            unknowns[at] += (0.5 * (exponent + 1.0)).ln();
            if self.known.exponent.is_none() {
                unknowns[at + 1] = exponent;
            }
            unknowns[self.damping_at()] = damping;
            // First with this exponent, because far from the motion a search of all runs to a limit of the exponents.
            let held = self.known.exponent.is_none().then_some(at + 1);
            let found = self.search(unknowns, FIRST_ITERATIONS, held);
            let found = found.and_then(|(_, unknowns)| self.search(unknowns, FIRST_ITERATIONS, None));
            if let Some(found) = found.filter(|found| best.as_ref().is_none_or(|best| found.0 < best.0)) {
                best = Some(found);
            }
        }
        let failed = || ContactLawError::Record {
            record: None,
            why: "no motion of a mass on a spring and a damper is near the records: check units and columns, and that they contain one impact \
                  each"
            .into(),
        };
        let (_, mut unknowns) = best.ok_or_else(failed)?;
        for round in 0..ROUNDS {
            let mut found = self.search(unknowns, MOST_ITERATIONS, None).ok_or_else(failed)?;
            for factor in OTHER_DAMPINGS.into_iter().filter(|_| round == 0) {
                let damping = self.damping_at();
                let mut other = found.1.clone();
                other[damping] = factor * other[damping].abs().max(LEAST_DAMPING);
                let near = self.search(other, FIRST_ITERATIONS, Some(damping));
                let other = near.and_then(|(_, other)| self.search(other, MOST_ITERATIONS, None));
                if let Some(better) = other.filter(|other| other.0 < found.0) {
                    found = better;
                }
            }
            unknowns = found.1;
            self.unknowns = unknowns.clone();
            let has_changed = self.update_deviations(round > 0);
            if !has_changed {
                break;
            }
        }
        Ok(self)
    }

    fn damping_at(&self) -> usize {
        self.firsts[0] - 1
    }

    /// Contact of the unknowns.
    fn contact(&self, unknowns: &DVector<f64>) -> Option<Contact> {
        let mut values = unknowns.iter().copied();
        let mass = if self.finds_mass { values.next()?.exp() } else { self.mass };
        let force = values.next()?.exp();
        let exponent = match self.known.exponent {
            Some(exponent) => exponent,
            None => values.next()?,
        };
        let damping = values.next()?;
        let speed = self.scale_of_speed();
        let stiffness = force / self.depth.powf(exponent);
        let damping = match self.form {
            DamperForm::HuntCrossley => damping / speed,
            DamperForm::KelvinVoigt => damping * force / speed / self.depth.powf(0.5 * (exponent - 1.0).max(0.0)),
        };
        let is_valid = EXPONENTS.contains(&exponent)
            && [mass, stiffness].iter().all(|x| x.is_normal())
            && damping.is_finite();
        is_valid.then_some(Contact {
            mass,
            stiffness,
            exponent,
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
    fn approach(&self, unknowns: &DVector<f64>, record: usize) -> (f64, f64) {
        let (start, first) = (&self.starts[record], self.firsts[record]);
        let touch = start.touch + start.duration * unknowns[first];
        (touch, self.records[record].speed.unwrap_or_else(|| unknowns[first + 1].exp()))
    }

    fn motion(&self, unknowns: &DVector<f64>, record: usize, steps: f64) -> Option<Motion> {
        let (_, speed) = self.approach(unknowns, record);
        let step = self.starts[record].duration / steps;
        Motion::new(self.contact(unknowns)?, speed, step).filter(|_| speed.is_normal())
    }

    /// Values of all signals of a record, signal after signal.
    fn values(&self, unknowns: &DVector<f64>, record: usize) -> Option<DVector<f64>> {
        let motion = self.motion(unknowns, record, STEPS)?;
        let (start, (touch, _)) = (&self.starts[record], self.approach(unknowns, record));
        let count = start.times.len();
        let mut at = self.firsts[record] + 1 + usize::from(self.records[record].speed.is_none());
        let mut all = Vec::with_capacity(count * start.signals.len());
        let (first, last) = (start.times[0], start.times[count - 1]);
        for signal in &start.signals {
            let mut cursor = 0;
            let width = self.filters[record].map_or(0.0, |_| start.spacing);
            let mut value = |time: f64| motion.signal(signal.quantity, time - touch, width, &mut cursor);
            let begin = all.len();
            match &self.filters[record] {
                Some(filter) => {
                    let reach = filter.reach as isize;
                    let time = |i: isize| first + (last - first) * i as f64 / (count - 1) as f64;
                    let mut longer: Vec<f64> =
                        (-reach..count as isize + reach).map(|i| value(time(i))).collect();
                    filter.run(&mut longer);
                    all.extend_from_slice(&longer[filter.reach..filter.reach + count]);
                }
                None => all.extend(start.times.iter().map(|time| value(*time))),
            }
            let drifts = drifts(signal.quantity);
            let offset = |k: usize| if k < drifts { signal.amplitude * unknowns[at + k] } else { 0.0 };
            let (constant, slope) = (signal.offset + offset(0), offset(1) / (last - first));
            for (value, time) in all[begin..].iter_mut().zip(&start.times) {
                *value += constant + slope * (time - start.touch);
            }
            at += drifts;
        }
        Some(DVector::from_vec(all))
    }

    /// Weight of a sample at a time after the touch, s: 0 near the jump of a damper's force, which neither a sensor nor samples follow. Near is
    /// within a sample, or within the rise of the filter; from twice that on the weight is 1.
    fn weight_beside_jump(&self, quantity: Measured, record: usize, time: f64) -> f64 {
        let has_jump = self.form == DamperForm::KelvinVoigt
            && matches!(quantity, Measured::Force | Measured::Acceleration);
        if !has_jump {
            return 1.0;
        }
        let width = self.known.filter_class.map_or(self.starts[record].spacing, |class| FILTER_RISE / class);
        let t = (time.abs() / width - 1.0).clamp(0.0, 1.0);
        t * t * (3.0 - 2.0 * t)
    }

    /// Weighted residuals of a record.
    fn residuals(&self, unknowns: &DVector<f64>, record: usize) -> Option<Residuals> {
        let mut residuals = self.values(unknowns, record)?;
        let start = &self.starts[record];
        let (touch, _) = self.approach(unknowns, record);
        let mut at = 0;
        for (signal, deviation) in start.signals.iter().zip(&self.deviations[record]) {
            let weight = |time: f64| self.weight_beside_jump(signal.quantity, record, time - touch);
            for ((value, is_used), time) in signal.values.iter().zip(&signal.is_used).zip(&start.times) {
                residuals[at] = if *is_used { weight(*time) * (residuals[at] - value) / deviation } else { 0.0 };
                at += 1;
            }
        }
        Some(residuals)
    }

    /// Sum of squares.
    fn squares(&self, unknowns: &DVector<f64>) -> Option<f64> {
        let mut sum = 0.0;
        for record in 0..self.records.len() {
            sum += self.residuals(unknowns, record)?.norm_squared();
        }
        sum.is_finite().then_some(sum)
    }

    /// Indices of the unknowns of a record.
    fn unknowns_of(&self, record: usize) -> impl Iterator<Item = usize> {
        let end = self.firsts.get(record + 1).copied().unwrap_or(self.unknowns.len());
        (0..self.firsts[0]).chain(self.firsts[record]..end)
    }

    /// Derivatives of the residuals of a record by its unknowns: central differences.
    fn jacobian(&self, unknowns: &DVector<f64>, record: usize) -> Option<(Vec<usize>, DMatrix<f64>)> {
        let columns: Vec<usize> = self.unknowns_of(record).collect();
        let mut derivatives = Vec::with_capacity(columns.len());
        for &column in &columns {
            let shifted = |by: f64| {
                let mut shifted = unknowns.clone();
                shifted[column] += by;
                self.residuals(&shifted, record)
            };
            derivatives.push((shifted(DIFFERENCE)? - shifted(-DIFFERENCE)?) / (2.0 * DIFFERENCE));
        }
        Some((columns, DMatrix::from_columns(&derivatives)))
    }

    /// JᵀJ and Jᵀr of all records.
    fn normal(&self, unknowns: &DVector<f64>) -> Option<(DMatrix<f64>, DVector<f64>)> {
        let size = unknowns.len();
        let (mut normal, mut gradient) = (DMatrix::zeros(size, size), DVector::zeros(size));
        for record in 0..self.records.len() {
            let (columns, jacobian) = self.jacobian(unknowns, record)?;
            let residuals = self.residuals(unknowns, record)?;
            add(&mut normal, &columns, &jacobian.tr_mul(&jacobian));
            let own = jacobian.tr_mul(&residuals);
            for (k, &column) in columns.iter().enumerate() {
                gradient[column] += own[k];
            }
        }
        Some((normal, gradient))
    }

    /// Levenberg–Marquardt search: sum of squares and unknowns. `held`: an unknown that keeps its value. `None`: the beginning has no motion.
    fn search(
        &self,
        mut unknowns: DVector<f64>,
        iterations: usize,
        held: Option<usize>,
    ) -> Option<(f64, DVector<f64>)> {
        let mut squares = self.squares(&unknowns)?;
        let mut damping = 1e-2;
        for _ in 0..iterations {
            let Some((mut normal, mut gradient)) = self.normal(&unknowns) else { break };
            if let Some(held) = held {
                normal.row_mut(held).fill(0.0);
                normal.column_mut(held).fill(0.0);
                (normal[(held, held)], gradient[held]) = (1.0, 0.0);
            }
            let before = squares;
            while damping < 1e12 {
                let mut damped = normal.clone();
                let largest = normal.diagonal().max();
                for k in 0..unknowns.len() {
                    damped[(k, k)] += damping * normal[(k, k)].max(1e-14 * largest);
                }
                let step = damped.cholesky().map(|factor| factor.solve(&gradient));
                let trial = step.map(|step| &unknowns - step);
                let found = trial.and_then(|trial| Some((self.squares(&trial)?, trial)));
                match found {
                    Some((smaller, trial)) if smaller < squares => {
                        (squares, unknowns) = (smaller, trial);
                        damping = (0.1 * damping).max(1e-12);
                        break;
                    }
                    _ => damping *= 10.0,
                }
            }
            if before - squares <= CONVERGED * before {
                break;
            }
        }
        Some((squares, unknowns))
    }

    /// Takes the variances from the residuals, and outliers out of use. Returns false if nothing has changed much.
    fn update_deviations(&mut self, finds_outliers: bool) -> bool {
        let mut has_changed = false;
        for record in 0..self.records.len() {
            let Some(residuals) = self.residuals(&self.unknowns, record) else { continue };
            let Some(fitted) = self.values(&self.unknowns, record) else { continue };
            let Self { starts, deviations, unknowns, .. } = self;
            let Start { signals, times, .. } = &mut starts[record];
            for (number, signal) in signals.iter_mut().enumerate() {
                let own = residuals.rows(number * times.len(), times.len());
                let used = |signal: &StartSignal| -> Vec<usize> {
                    (0..own.len()).filter(|at| signal.is_used[*at]).collect()
                };
                let before = used(signal);
                if finds_outliers {
                    let mut sizes: Vec<f64> = before.iter().map(|at| own[*at].abs()).collect();
                    let limit = OUTLIER * NORMAL * median(&mut sizes);
                    let outside: Vec<usize> =
                        before.iter().copied().filter(|at| limit > 0.0 && own[*at].abs() > limit).collect();
                    if outside.len() as f64 <= MOST_OUTLIERS * before.len() as f64 {
                        outside.iter().for_each(|at| signal.is_used[*at] = false);
                        has_changed |= !outside.is_empty();
                    }
                }
                if let Some(limit) = signal.limit {
                    // Next to the limit only the samples with noise towards zero are left.
                    let near = limit - NEAR_LIMIT * deviations[record][number];
                    for at in used(signal) {
                        if fitted[number * times.len() + at] > near {
                            signal.is_used[at] = false;
                            signal.clipped += 1;
                            has_changed = true;
                        }
                    }
                }
                let kept = used(signal);
                let squares: f64 = kept.iter().map(|at| own[*at] * own[*at]).sum();
                let freedoms = kept.len() as f64 * (1.0 - unknowns.len() as f64 / residuals.len() as f64);
                let factor = (squares / freedoms.max(1.0)).sqrt();
                let old = deviations[record][number];
                let new = (factor * old).max(LEAST_RESIDUAL * signal.amplitude);
                has_changed |= (new / old - 1.0).abs() > 0.02;
                deviations[record][number] = new;
            }
        }
        has_changed
    }

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
                while total > 0.0 && length < count / 4 {
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
        // Sums of estimated correlations may lie below the variance without them.
        let factors: Vec<f64> =
            (0..size).map(|k| (inverse[(k, k)] / covariance[(k, k)].abs()).max(1.0).sqrt()).collect();
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
            why: "the records do not determine the unknowns; give the exponent, the approach speed or the mass".into(),
        })
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
            if scale > 0.0 { (of_figures[(i, j)] / scale).clamp(-1.0, 1.0) } else { f64::from(u8::from(i == j)) }
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
            let residuals = fitted.iter().zip(&signal.values).zip(&signal.is_used);
            let used: Vec<f64> =
                residuals.filter(|(_, is_used)| **is_used).map(|((a, b), _)| a - b).collect();
            let residual = (used.iter().map(|r| r * r).sum::<f64>() / used.len().max(1) as f64).sqrt();
            // Samples at and near the limit are the only others that are not used.
            let near = signal.limit.map_or(f64::INFINITY, |limit| {
                limit - NEAR_LIMIT * self.deviations[record][number]
            });
            let is_outlier = |at: &usize| {
                let residual = (signal.values[*at] - fitted[*at]).abs();
                !signal.is_used[*at] && fitted[*at] < near && residual > OUTLIER * self.deviations[record][number]
            };
            let outliers = (0..count).filter(is_outlier).map(|at| start.times[at]);
            all.push(IdentifiedSignal {
                quantity: signal.quantity,
                is_reversed: signal.is_reversed,
                offset: linear(0, signal.amplitude, signal.offset),
                drift: linear(1, signal.amplitude / span, 0.0),
                residual,
                relative_residual: residual / signal.amplitude,
                correlation_time: lengths[number] as f64 * start.spacing,
                clipped: signal.clipped,
                outliers: outliers.collect(),
                fitted: fitted.iter().map(|value| sign * value).collect(),
            });
            at += drifts;
        }
        Some(all)
    }
}

/// Number of unknowns of the zero of a sensor: offset and drift of a force and an acceleration; the offset of a displacement.
fn drifts(quantity: Measured) -> usize {
    match quantity {
        Measured::Force | Measured::Acceleration => 2,
        Measured::Displacement => 1,
        Measured::Velocity => 0,
    }
}

/// Adds a matrix of some unknowns to that of all.
fn add(all: &mut DMatrix<f64>, columns: &[usize], part: &DMatrix<f64>) {
    for (i, &row) in columns.iter().enumerate() {
        for (j, &column) in columns.iter().enumerate() {
            all[(row, column)] += part[(i, j)];
        }
    }
}

/// Inverse of a positive definite matrix, scaled to a diagonal of ones; `None` if it is singular to rounding.
fn inverse(matrix: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let scales: Vec<f64> = matrix.diagonal().iter().map(|x| x.sqrt()).collect();
    if scales.iter().any(|scale| !scale.is_normal()) {
        return None;
    }
    let scaled = DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, j| matrix[(i, j)] / scales[i] / scales[j]);
    let inverse = scaled.cholesky()?.inverse();
    // 1e-12: the derivatives have errors of 1e-8, their products of 1e-16.
    let is_determined = inverse.diagonal().max() < 1e12;
    is_determined.then(|| {
        DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, j| inverse[(i, j)] / scales[i] / scales[j])
    })
}
