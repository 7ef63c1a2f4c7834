//! SIMD evaluation of tree rows: m̄ of many rows at once without poses, if only m̄ is requested.
//!
//! The results and findings equal those of an evaluation with a pose. An uncertain row is posed and evaluated
//! separately.

use crate::checks::finding::{Finding, FindingTally};
use crate::checks::joint_limits::LimitedJoints;
use crate::evaluation::prepared_question::PreparedQuestion;
use crate::pose::positions::{PoseLayout, Positions};
use crate::sweep::row_blocks::RowBlock;
use crate::sweep::row_layout::RowLayout;
use percuss_dynamics::{BatchDerivatives, BatchPositions, Contact};
use std::ops::Range;
use std::sync::Arc;

/// Contact prepared for the SIMD evaluation of many rows.
#[derive(Debug)]
pub(crate) struct BatchEvaluator {
    batch: BatchDerivatives,
    /// True if the gradient of each row is computed.
    has_gradient: bool,
    /// Positions of all joints of the question, in joint order.
    base: Vec<f64>,
    /// Index in `base` of each number of a row.
    base_indices: Vec<usize>,
    limits: LimitedJoints,
    /// Findings that hold for all rows.
    shared_findings: Vec<Finding>,
}

/// Findings that hold for all rows; `None` if a generic sample pose has no finite m̄, or has findings that depend on its
/// response.
fn shared_findings(
    prepared: &PreparedQuestion,
    setting: &RowLayout,
    contact: &Contact,
) -> Option<Vec<Finding>> {
    let values: Vec<f64> = (0..setting.width()).map(|i| 0.1 + (0.618 * i as f64).fract()).collect();
    let pose = prepared.system.pose(&setting.configuration(&values, false).ok()?).ok()?;
    let mut shared = prepared.evaluate(&pose, contact).ok()?.into_branch_findings()?;
    shared.extend(prepared.guess_findings(&pose));
    Some(shared)
}

/// Results of one batch of rows.
pub(crate) struct BatchResults {
    rows: usize,
    columns: Vec<f64>,
    /// m̄ and its rounding error, kg; NaN if uncertain.
    masses: Vec<f64>,
    errors: Vec<f64>,
    /// Gradients, row by row: one number per velocity of all joints; empty unless requested.
    gradients: Vec<f64>,
}

impl BatchEvaluator {
    /// SIMD evaluation; `None` if the rows require poses: loops, mimics, or other requests than m̄.
    pub fn new(prepared: &PreparedQuestion, setting: &RowLayout, contact: &Contact) -> Option<Self> {
        let system = &prepared.system;
        let has_loops = system.mechanism().joint_ids().any(|joint| system.is_bound(joint));
        let plain = prepared.needs_only_mass() && !setting.travels() && !has_loops;
        let batch = plain.then(|| prepared.system.reference().ok()?.batch(contact).ok()).flatten()?;
        if !batch.has_lanes() {
            return None;
        }
        let mechanism = prepared.system.mechanism();
        let sizes = mechanism.joints().iter().map(|joint| joint.kind().positions());
        let starts: Vec<usize> = sizes
            .scan(0, |next, size| {
                let start = *next;
                *next += size;
                Some(start)
            })
            .collect();
        let base: Vec<f64> =
            mechanism.joint_ids().flat_map(|id| prepared.configuration.get(id)).copied().collect();
        let mut places = vec![0; setting.width()];
        for (joint, numbers) in setting.joints() {
            for (component, number) in numbers.clone().enumerate() {
                places[number] = starts[joint.index()] + component;
            }
        }
        let limits = LimitedJoints::of(mechanism);
        let shared_findings = shared_findings(prepared, setting, contact)?;
        let batch = batch.derivatives();
        Some(Self { batch, has_gradient: false, base, base_indices: places, limits, shared_findings })
    }

    /// The same with the gradient of each row.
    pub fn with_gradient(self) -> Self {
        Self { has_gradient: true, ..self }
    }

    /// Evaluates some rows of a block.
    pub fn evaluate(&self, block: &RowBlock, rows: Range<usize>) -> BatchResults {
        let count = rows.len();
        let mut columns = vec![0.0; self.base.len() * count];
        for (column, value) in columns.chunks_exact_mut(count).zip(&self.base) {
            column.fill(*value);
        }
        for (number, place) in self.base_indices.iter().enumerate() {
            let column = &mut columns[place * count..][..count];
            for (to, row) in column.iter_mut().zip(rows.clone()) {
                *to = block.values(row)[number];
            }
        }
        let [mut masses, mut errors] = [(); 2].map(|()| vec![f64::NAN; count]);
        let positions = BatchPositions::Columns { values: &columns, stride: count };
        let velocities = if self.has_gradient { self.batch.velocities() } else { 0 };
        let mut gradients = vec![f64::NAN; count * velocities];
        let results = (&mut masses[..], &mut errors[..]);
        let done = if self.has_gradient {
            self.batch.gradients(positions, None, results, &mut gradients, |_, _| {})
        } else {
            self.batch.batch().run_columns(positions, results.0, results.1, |_, _| {})
        };
        // The layout always fits: one column per position of the mechanism, one entry per result.
        if done.is_err() {
            masses.fill(f64::NAN);
        }
        BatchResults { rows: count, columns, masses, errors, gradients }
    }

    /// Adds the findings of a row with a result.
    pub fn add_findings(
        &self,
        prepared: &PreparedQuestion,
        results: &BatchResults,
        i: usize,
        row: usize,
        tally: &mut FindingTally,
    ) {
        tally.add_repeated(row, 1, &self.shared_findings);
        let position = |index: usize| results.columns[index * results.rows + i];
        tally.add(row, self.limits.findings(prepared.system.mechanism(), position));
    }
}

impl BatchResults {
    /// m̄ of a row and the rounding error bound, kg; `None` if uncertain.
    pub fn mass(&self, i: usize) -> Option<(f64, f64)> {
        let (mass, error) = (self.masses[i], self.errors[i]);
        (mass.is_finite() && error.is_finite()).then_some((mass, error))
    }

    /// Gradient of m̄ at a row, one number per velocity of all joints; empty unless requested.
    pub fn gradient(&self, i: usize) -> Vec<f64> {
        let velocities = self.gradients.len() / self.rows.max(1);
        self.gradients[i * velocities..][..velocities].to_vec()
    }

    /// Joint positions of a row.
    pub fn positions(&self, layout: &Arc<PoseLayout>, i: usize) -> Positions {
        Positions::from_columns(layout, &self.columns, self.rows, i)
    }
}
