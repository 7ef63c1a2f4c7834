//! Nonlinear least squares with per-record and common unknowns, and the covariance of the result.

use super::motion::{Contact, Filter, Motion};
use super::record::{DamperForm, EXPONENTS, Known, Measured, Record, SampleUse, finds_mass};
use super::start::{Start, median};
use crate::ContactLawError;
use nalgebra::{DMatrix, DVector};

/// Steps of the integration over the estimated duration: the error of the motion is 1e-8.
const STEPS: f64 = 200.0;
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
pub(super) const DIFFERENCE: f64 = 1e-5;
/// Residuals beyond this many robust standard deviations are outliers, if they are at most this part of the samples: one sample of 10⁸ of
/// normal noise lies beyond.
pub(super) const OUTLIER: f64 = 6.0;
const MOST_OUTLIERS: f64 = 0.02;
/// Lengths of the used record over which a filter may reach.
const MOST_REACH: usize = 3;
/// Rise time of the filter multiplied by its channel frequency class: after it, the response to a step is within 1e-3 of the end value.
const FILTER_RISE: f64 = 0.5;
/// Standard deviations below the limit of a sensor within which samples are not used.
pub(super) const NEAR_LIMIT: f64 = 3.0;
/// Standard deviation of normal noise divided by the median of its magnitudes.
const NORMAL: f64 = 1.4826;
/// Part of the amplitude below which residuals are rounding.
const LEAST_RESIDUAL: f64 = 1e-9;
/// Rounds of fit and estimation of variances.
const ROUNDS: usize = 4;

/// Search of the unknowns of records.
#[derive(Clone, Debug)]
pub(super) struct Fit<'a> {
    pub known: &'a Known,
    pub form: DamperForm,
    pub records: &'a [Record],
    pub starts: Vec<Start>,
    pub filters: Vec<Option<Filter>>,
    /// Scale of penetrations, m: the stiffness is given by the force at this penetration.
    pub depth: f64,
    pub mass: f64,
    pub finds_mass: bool,
    /// Index of the first unknown of each record; the first are common.
    pub firsts: Vec<usize>,
    /// Standard deviation of each signal of each record.
    pub deviations: Vec<Vec<f64>>,
    pub unknowns: DVector<f64>,
    pub other_form: Option<f64>,
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

    /// The fit with the comparison to that with the other form.
    pub fn with_other(self, other: &Self) -> Self {
        let samples: usize = self.starts.iter().map(|start| start.times.len() * start.signals.len()).sum();
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
            // First with this exponent: far from the motion a search of all unknowns ends at a limit of the exponents.
            let held = self.known.exponent.is_none().then_some(at + 1);
            let found = self.search(unknowns, FIRST_ITERATIONS, held);
            let found = found.and_then(|(_, unknowns)| self.search(unknowns, FIRST_ITERATIONS, None));
            if let Some(found) = found.filter(|found| best.as_ref().is_none_or(|best| found.0 < best.0)) {
                best = Some(found);
            }
        }
        let failed = || {
            ContactLawError::Record {
            record: None,
            why: "no motion of a mass on a spring and a damper is near the records: check units and columns, and that they contain one impact \
                  each"
            .into(),
        }
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
            if !self.update_deviations() {
                break;
            }
        }
        // The variances and samples of the last round.
        (_, self.unknowns) = self.search(self.unknowns.clone(), MOST_ITERATIONS, None).ok_or_else(failed)?;
        Ok(self)
    }

    fn damping_at(&self) -> usize {
        self.firsts[0] - 1
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

    /// Weight of a sample at a time after the touch, s. The force of a damper jumps at the touch, and no sensor follows the jump: the weight is 0
    /// within one distance of samples, or within the rise of the filter, and 1 beyond twice that time.
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
    pub fn residuals(&self, unknowns: &DVector<f64>, record: usize) -> Option<Residuals> {
        let mut residuals = self.values(unknowns, record)?;
        let start = &self.starts[record];
        let (touch, _) = self.approach(unknowns, record);
        let mut at = 0;
        for (signal, deviation) in start.signals.iter().zip(&self.deviations[record]) {
            let weight = |time: f64| self.weight_beside_jump(signal.quantity, record, time - touch);
            for ((value, state), time) in signal.values.iter().zip(&signal.uses).zip(&start.times) {
                residuals[at] = if *state == SampleUse::Used {
                    weight(*time) * (residuals[at] - value) / deviation
                } else {
                    0.0
                };
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
    pub fn jacobian(&self, unknowns: &DVector<f64>, record: usize) -> Option<(Vec<usize>, DMatrix<f64>)> {
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

    /// Takes the variances from the residuals, and decides which samples are outliers or near the limit of the sensor. Returns false if nothing
    /// has changed much.
    fn update_deviations(&mut self) -> bool {
        let mut has_changed = false;
        let common = self.firsts[0] as f64 / self.records.len() as f64;
        for record in 0..self.records.len() {
            let Some(fitted) = self.values(&self.unknowns, record) else { continue };
            let (touch, _) = self.approach(&self.unknowns, record);
            let start = &self.starts[record];
            let count = start.times.len();
            let own_unknowns = self.unknowns_of(record).count() - self.firsts[0];
            let mut of_record = Vec::new();
            for (number, signal) in start.signals.iter().enumerate() {
                let deviation = self.deviations[record][number];
                let near = signal.limit.map_or(f64::INFINITY, |limit| limit - NEAR_LIMIT * deviation);
                let own = fitted.rows(number * count, count);
                // Next to the limit only the samples with noise towards zero are left.
                let is_near = |at: usize| own[at] > near || signal.limit == Some(signal.values[at]);
                let weight =
                    |at: usize| self.weight_beside_jump(signal.quantity, record, start.times[at] - touch);
                let residual = |at: usize| weight(at) * (own[at] - signal.values[at]);
                let free: Vec<usize> = (0..count).filter(|at| !is_near(*at)).collect();
                let mut sizes: Vec<f64> = free.iter().map(|at| residual(*at).abs()).collect();
                let limit = if free.is_empty() { 0.0 } else { OUTLIER * NORMAL * median(&mut sizes) };
                let is_outlier = |at: &usize| limit > 0.0 && residual(*at).abs() > limit;
                let outliers: Vec<usize> = free.iter().copied().filter(is_outlier).collect();
                let has_outliers = outliers.len() as f64 <= MOST_OUTLIERS * free.len() as f64;
                let mut uses = vec![SampleUse::AtLimit; count];
                free.iter().for_each(|at| uses[*at] = SampleUse::Used);
                outliers.iter().filter(|_| has_outliers).for_each(|at| uses[*at] = SampleUse::Outlier);
                let used: Vec<usize> = free.into_iter().filter(|at| uses[*at] == SampleUse::Used).collect();
                let squares: f64 = used.iter().map(|at| residual(*at).powi(2)).sum();
                of_record.push((uses, used.len(), squares));
            }
            let used: usize = of_record.iter().map(|(_, used, _)| used).sum();
            let freedom = 1.0 - (own_unknowns as f64 + common) / used.max(1) as f64;
            for (number, (uses, used, squares)) in of_record.into_iter().enumerate() {
                let signal = &mut self.starts[record].signals[number];
                let old = self.deviations[record][number];
                let new = (squares / (used as f64 * freedom).max(1.0))
                    .sqrt()
                    .max(LEAST_RESIDUAL * signal.amplitude);
                has_changed |= (new / old - 1.0).abs() > 0.02 || uses != signal.uses;
                signal.uses = uses;
                self.deviations[record][number] = new;
            }
        }
        has_changed
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

/// Adds a matrix of some unknowns to that of all.
pub(super) fn add(all: &mut DMatrix<f64>, columns: &[usize], part: &DMatrix<f64>) {
    for (i, &row) in columns.iter().enumerate() {
        for (j, &column) in columns.iter().enumerate() {
            all[(row, column)] += part[(i, j)];
        }
    }
}
