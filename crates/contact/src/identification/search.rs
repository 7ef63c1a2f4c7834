//! Levenberg–Marquardt search from several beginnings, and the samples that it uses.

use super::fit::{Fit, LEAST_RESIDUAL, Residuals, STEPS};
use super::record::{DamperForm, EXPONENTS, Measured, SampleUse};
use super::start::median;
use crate::ContactLawError;
use nalgebra::{DMatrix, DVector};

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
/// Step of a difference quotient, relative to the scale of the unknown: the errors of the central quotient and of rounding are both 1e-8.
const DIFFERENCE: f64 = 1e-5;
/// Residuals beyond this many robust standard deviations are outliers, if they are at most this part of the samples: one sample of 10⁸ of
/// normal noise lies beyond.
const OUTLIER: f64 = 6.0;
const MOST_OUTLIERS: f64 = 0.02;
/// Rise time of the filter multiplied by its channel frequency class: after it, the response to a step is within 1e-3 of the end value.
const FILTER_RISE: f64 = 0.5;
/// Standard deviations below the limit of a sensor within which samples are not used.
const NEAR_LIMIT: f64 = 3.0;
/// Standard deviation of normal noise divided by the median of its magnitudes.
const NORMAL: f64 = 1.4826;
/// Samples beside the estimated touch among which a jump is searched, and standard deviations of noise above which it is found.
const NEAR_TOUCH: usize = 8;
const JUMP: f64 = 8.0;
/// Standard deviation of a touch between two samples, in their distance: above the 1/√12 of an even distribution, because a sensor takes
/// the mean over a sample.
const TOUCH: f64 = 0.5;
/// Restitution above which a contact gains energy, not only by its uncertainty.
const MOST_RESTITUTION: f64 = 1.05;
/// Rounds of fit and estimation of variances.
const ROUNDS: usize = 5;

/// Derivative of a quantity by an unknown; `by`: the quantity after a change of the unknown. One-sided at the end of a range.
pub(super) fn derivative(
    base: &DVector<f64>,
    is_central: bool,
    by: impl Fn(f64) -> Option<DVector<f64>>,
) -> Option<DVector<f64>> {
    let above = by(DIFFERENCE);
    let below = if is_central || above.is_none() { by(-DIFFERENCE) } else { None };
    match (above, below) {
        (Some(above), Some(below)) => Some((above - below) / (2.0 * DIFFERENCE)),
        (Some(above), None) => Some((above - base) / DIFFERENCE),
        (None, Some(below)) => Some((base - below) / DIFFERENCE),
        (None, None) => None,
    }
}

/// Error of a search without a result.
pub(super) fn no_motion() -> ContactLawError {
    let why = "no motion of a mass on a spring and a damper is near the records: check units and columns, and that they contain one impact \
               each";
    ContactLawError::Record { record: None, why: why.into() }
}

impl Fit<'_> {
    /// The best fit from several beginnings.
    pub fn best(mut self) -> Result<Self, ContactLawError> {
        let thin = self.thinned();
        let exponents = match self.known.exponent {
            Some(exponent) => vec![exponent],
            None => FIRST_EXPONENTS.map(|p| if self.second.is_some() { p + 1.0 } else { p }).to_vec(),
        };
        let mut best: Option<(f64, DVector<f64>)> = None;
        let mut keep = |found: Option<(f64, DVector<f64>)>| {
            // A contact that gains energy is kept only if no other is found.
            let rank = |(squares, unknowns): &(f64, DVector<f64>)| (thin.gains_energy(unknowns), *squares);
            if let Some(found) =
                found.filter(|found| best.as_ref().is_none_or(|best| rank(found) < rank(best)))
            {
                best = Some(found);
            }
            best.clone()
        };
        let damping = self.damping_at();
        for (exponent, first) in
            exponents.into_iter().flat_map(|exponent| FIRST_DAMPINGS.map(|damping| (exponent, damping)))
        {
            let mut unknowns = self.unknowns.clone();
            // A stiffer end at the same energy.
            unknowns[usize::from(self.finds_mass)] += (0.5 * (exponent + 1.0)).ln();
            if let Some(at) = self.exponent_at() {
                unknowns[at] = exponent;
            }
            unknowns[damping] = first;
            // First with this exponent: far from the motion a search of all unknowns ends at a limit of the exponents.
            let found = thin.search(unknowns, FIRST_ITERATIONS, self.exponent_at());
            keep(found.and_then(|(_, unknowns)| thin.search(unknowns, FIRST_ITERATIONS, None)));
        }
        let (_, first) = keep(None).ok_or_else(no_motion)?;
        let first = keep(thin.search(first, MOST_ITERATIONS, None)).ok_or_else(no_motion)?.1;
        for factor in OTHER_DAMPINGS {
            let mut other = first.clone();
            other[damping] = factor * other[damping].abs().max(LEAST_DAMPING);
            let near = thin.search(other, FIRST_ITERATIONS, Some(damping));
            keep(near.and_then(|(_, other)| thin.search(other, MOST_ITERATIONS, None)));
        }
        (_, self.unknowns) = keep(None).ok_or_else(no_motion)?;
        self.refined().ok_or_else(no_motion)
    }

    /// True if the restitution of a record is clearly above 1.
    pub fn gains_energy(&self, unknowns: &DVector<f64>) -> bool {
        let restitution = |record| self.motion(unknowns, record, STEPS).map(|motion| motion.key_figures()[0]);
        (0..self.records.len()).any(|record| restitution(record).is_some_and(|e| e > MOST_RESTITUTION))
    }

    /// The fit after rounds of estimation of variances and search.
    pub fn refined(mut self) -> Option<Self> {
        for round in 0..ROUNDS {
            if !self.update_deviations() && round > 0 {
                break;
            }
            (_, self.unknowns) = self.search(self.unknowns.clone(), MOST_ITERATIONS, None)?;
        }
        Some(self)
    }

    /// Sum of squares.
    fn squares(&self, unknowns: &DVector<f64>) -> Option<f64> {
        let mut sum = 0.0;
        for record in 0..self.records.len() {
            sum += self.residuals(unknowns, record)?.norm_squared();
        }
        sum.is_finite().then_some(sum)
    }

    /// Derivatives of the residuals of a record by its unknowns: difference quotients, and exact ones for the zeros of sensors.
    pub fn jacobian(
        &self,
        unknowns: &DVector<f64>,
        record: usize,
        residuals: &Residuals,
        is_central: bool,
    ) -> Option<(Vec<usize>, DMatrix<f64>)> {
        let columns: Vec<usize> = self.unknowns_of(record).collect();
        let mut jacobian = DMatrix::zeros(residuals.len(), columns.len());
        let of_motion = columns.iter().take_while(|column| **column < self.zeros_at(record)).count();
        for (k, &column) in columns[..of_motion].iter().enumerate() {
            let shifted = |by: f64| {
                let mut shifted = unknowns.clone();
                shifted[column] += by;
                self.residuals(&shifted, record)
            };
            jacobian.set_column(k, &derivative(residuals, is_central, shifted)?);
        }
        let count = self.starts[record].times.len();
        for (k, (signal, slopes)) in (of_motion..).zip(self.slopes_of_zeros(record)) {
            jacobian.view_mut((signal * count, k), (count, 1)).copy_from_slice(&slopes);
        }
        Some((columns, jacobian))
    }

    /// JᵀJ and Jᵀr of all records.
    fn normal(&self, unknowns: &DVector<f64>) -> Option<(DMatrix<f64>, DVector<f64>)> {
        let size = unknowns.len();
        let (mut normal, mut gradient) = (DMatrix::zeros(size, size), DVector::zeros(size));
        for record in 0..self.records.len() {
            let residuals = self.residuals(unknowns, record)?;
            let (columns, jacobian) = self.jacobian(unknowns, record, &residuals, false)?;
            add(&mut normal, &columns, &jacobian.tr_mul(&jacobian));
            let own = jacobian.tr_mul(&residuals);
            for (k, &column) in columns.iter().enumerate() {
                gradient[column] += own[k];
            }
        }
        Some((normal, gradient))
    }

    /// Search in the range of exponents: sum of squares and unknowns. `held`: an unknown that keeps its value. `None`: the beginning has no
    /// motion.
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
            let leaves = |at: &usize| {
                let (value, slope) = (unknowns[*at], gradient[*at]);
                value >= *EXPONENTS.end() && slope < 0.0 || value <= *EXPONENTS.start() && slope > 0.0
            };
            for at in self.exponent_at().filter(leaves).into_iter().chain(held) {
                hold(&mut normal, at);
                gradient[at] = 0.0;
            }
            let before = squares;
            while damping < 1e12 {
                let mut damped = normal.clone();
                let largest = normal.diagonal().max();
                for k in 0..unknowns.len() {
                    damped[(k, k)] += damping * normal[(k, k)].max(1e-14 * largest);
                }
                let step = damped.cholesky().map(|factor| factor.solve(&gradient));
                let trial = step.map(|step| &unknowns - step).map(|mut trial| {
                    if let Some(at) = self.exponent_at() {
                        trial[at] = trial[at].clamp(*EXPONENTS.start(), *EXPONENTS.end());
                    }
                    trial
                });
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

    /// First sample after the jump of the force at the touch; `None` if the jump is not above the noise.
    fn sample_after_jump(&self, record: usize, fitted: &DVector<f64>) -> Option<usize> {
        if self.form != DamperForm::KelvinVoigt {
            return None;
        }
        let motion = self.motion(&self.unknowns, record, STEPS)?;
        let (start, (touch, _)) = (&self.starts[record], self.approach(&self.unknowns, record));
        let count = start.times.len();
        let near = start.times.partition_point(|time| *time < touch);
        let range = near.saturating_sub(NEAR_TOUCH)..(near + NEAR_TOUCH).min(count);
        let times = || start.times[range.clone()].iter().map(|time| time - touch);
        // A damper that is nearly linear has its force only after the touch.
        let at_touch = 0.25 * start.spacing;
        let (own, pushed) = (motion.states(times()), motion.states(times().map(|time| time.max(at_touch))));
        let at_touch = motion.states(std::iter::once(at_touch))[0];
        let mut costs = vec![0.0; range.len()];
        let mut jump = 0.0;
        let signals = start.signals.iter().zip(&self.deviations[record]).enumerate();
        for (number, (signal, deviation)) in signals.filter(|(_, (signal, _))| has_jump(signal.quantity)) {
            let value = |state| motion.signal(signal.quantity, state, 0.0);
            for (i, at) in range.clone().enumerate() {
                let free = fitted[number * count + at] - value(&own[i]) - signal.values[at];
                let (before, after) = (free.powi(2), (free + value(&pushed[i])).powi(2));
                for (first, cost) in costs.iter_mut().enumerate() {
                    *cost += if i < first { before } else { after } / deviation.powi(2);
                }
            }
            jump += (value(&at_touch) / deviation).powi(2);
        }
        let least = (1..costs.len()).min_by(|a, b| costs[*a].total_cmp(&costs[*b]))?;
        (jump > JUMP * JUMP).then_some(range.start + least)
    }

    /// Takes the variances from the residuals, and decides which samples are outliers, near the limit of the sensor or at a jump of the force.
    /// Returns false if nothing has changed much.
    fn update_deviations(&mut self) -> bool {
        let mut has_changed = false;
        let common = self.firsts[0] as f64 / self.records.len() as f64;
        for record in 0..self.records.len() {
            let Some(fitted) = self.values(&self.unknowns, record) else { continue };
            let (touch, _) = self.approach(&self.unknowns, record);
            let start = &self.starts[record];
            let count = start.times.len();
            let own_unknowns = self.unknowns_of(record).count() - self.firsts[0];
            let after = self.sample_after_jump(record, &fitted);
            let at_touch = match (after, self.known.filter_class) {
                (None, _) => 0..0,
                (Some(after), None) => after - 1..after + 1,
                (Some(_), Some(class)) => {
                    let at = |time: f64| start.times.partition_point(|other| *other < time);
                    at(touch - FILTER_RISE / class)..at(touch + FILTER_RISE / class)
                }
            };
            let unfiltered = after.filter(|_| self.known.filter_class.is_none());
            let of_touch = unfiltered.map(|after| {
                let (before, after) = (start.times[after - 1], start.times[after]);
                (0.5 * (before + after), TOUCH * (after - before))
            });
            let mut of_record = Vec::new();
            for (number, signal) in start.signals.iter().enumerate() {
                let deviation = self.deviations[record][number];
                let near = signal.limit.map_or(f64::INFINITY, |limit| limit - NEAR_LIMIT * deviation);
                let own = fitted.rows(number * count, count);
                // Next to the limit only the samples with noise towards zero are left.
                let is_near = |at: usize| own[at] > near || signal.limit == Some(signal.values[at]);
                let is_at_jump = |at: usize| has_jump(signal.quantity) && at_touch.contains(&at);
                let residual = |at: usize| own[at] - signal.values[at];
                let free: Vec<usize> = (0..count).filter(|at| !is_near(*at) && !is_at_jump(*at)).collect();
                let mut sizes: Vec<f64> = free.iter().map(|at| residual(*at).abs()).collect();
                let limit = if free.is_empty() { 0.0 } else { OUTLIER * NORMAL * median(&mut sizes) };
                let is_outlier = |at: &usize| limit > 0.0 && residual(*at).abs() > limit;
                let outliers: Vec<usize> = free.iter().copied().filter(is_outlier).collect();
                let has_outliers = outliers.len() as f64 <= MOST_OUTLIERS * free.len() as f64;
                let state = |at| if is_at_jump(at) { SampleUse::AtTouch } else { SampleUse::AtLimit };
                let mut uses: Vec<SampleUse> = (0..count).map(state).collect();
                free.iter().for_each(|at| uses[*at] = SampleUse::Used);
                outliers.iter().filter(|_| has_outliers).for_each(|at| uses[*at] = SampleUse::Outlier);
                let used: Vec<usize> = free.into_iter().filter(|at| uses[*at] == SampleUse::Used).collect();
                let squares: f64 = used.iter().map(|at| residual(*at).powi(2)).sum();
                of_record.push((uses, used.len(), squares));
            }
            self.touches[record] = of_touch;
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

/// True if a signal follows a jump of the force.
fn has_jump(quantity: Measured) -> bool {
    matches!(quantity, Measured::Force | Measured::Acceleration)
}

/// Keeps an unknown of normal equations at its value.
pub(super) fn hold(normal: &mut DMatrix<f64>, at: usize) {
    normal.row_mut(at).fill(0.0);
    normal.column_mut(at).fill(0.0);
    normal[(at, at)] = 1.0;
}

/// Adds a matrix of some unknowns to that of all.
pub(super) fn add(all: &mut DMatrix<f64>, columns: &[usize], part: &DMatrix<f64>) {
    for (i, &row) in columns.iter().enumerate() {
        for (j, &column) in columns.iter().enumerate() {
            all[(row, column)] += part[(i, j)];
        }
    }
}
