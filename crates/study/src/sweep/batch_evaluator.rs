//! SIMD evaluation of tree rows: m̄ of many rows at once without poses, if only m̄ is requested.
//!
//! The results and findings equal those of an evaluation with a pose. An uncertain row is posed and evaluated
//! separately.

use crate::checks::far_point_check;
use crate::checks::finding::{Finding, FindingTally};
use crate::checks::findings::joint_limit_finding;
use crate::evaluation::prepared_question::PreparedQuestion;
use crate::pose::positions::{PoseLayout, Positions};
use crate::sweep::row_blocks::RowBlock;
use crate::sweep::row_layout::RowLayout;
use percuss_dynamics::{Batch, BatchAnswer, BatchPositions, Contact, EffectiveMass, Pose};
use percuss_mechanism::{JointId, Limits};
use std::ops::Range;
use std::sync::Arc;

/// Codes of findings that may occur for any row with a finite m̄.
const ROW_FINDING_CODES: [&str; 2] = ["outside-limits", "far-point"];

/// Contact prepared for the SIMD evaluation of many rows.
#[derive(Debug)]
pub(crate) struct BatchEvaluator {
    batch: Batch,
    /// Positions of all joints of the question, in joint order.
    base: Vec<f64>,
    /// Index in `base` of each number of a row.
    base_indices: Vec<usize>,
    limits: Vec<(JointId, usize, Limits)>,
    far_point: Option<Finding>,
}

/// Results of one batch of rows.
pub(crate) struct BatchResults {
    rows: usize,
    columns: Vec<f64>,
    results: Vec<BatchAnswer>,
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
        let limits = mechanism.joint_ids().filter_map(|id| {
            let joint = mechanism.joint(id);
            let limits = joint.limits().filter(|_| joint.kind().positions() == 1)?;
            Some((id, starts[id.index()], limits))
        });
        let far_point = far_point_check::far_point_finding(
            mechanism,
            contact.link,
            &contact.point,
            prepared.question.names,
        );
        let lanes = Self { batch, base_indices: places, limits: limits.collect(), base, far_point };
        lanes.has_only_row_findings(prepared, setting, contact).then_some(lanes)
    }

    /// True if a generic sample pose has a finite m̄ and no other findings than those in `ROW_FINDING_CODES`.
    fn has_only_row_findings(
        &self,
        prepared: &PreparedQuestion,
        setting: &RowLayout,
        contact: &Contact,
    ) -> bool {
        let values: Vec<f64> = (0..setting.width()).map(|i| 0.1 + (0.618 * i as f64).fract()).collect();
        let pose = setting.configuration(&values, false).ok().and_then(|c| prepared.system.pose(&c).ok());
        let answer = pose.and_then(|pose| prepared.evaluate(&pose, contact).ok());
        answer.is_some_and(|answer| {
            matches!(answer.response.effective_mass, EffectiveMass::Finite(_))
                && answer.findings.iter().all(|finding| ROW_FINDING_CODES.contains(&finding.code()))
        })
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
        let mut answers = vec![BatchAnswer::NONE; count];
        let positions = BatchPositions::Columns { values: &columns, stride: count };
        // The layout always fits: one column per position of the mechanism, one entry per result.
        if self.batch.run_here(positions, &mut answers).is_err() {
            answers.fill(BatchAnswer::NONE);
        }
        BatchResults { rows: count, columns, results: answers }
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
        if let Some(far_point) = &self.far_point {
            tally.add(row, [far_point.clone()]);
        }
        for &(joint, place, limits) in &self.limits {
            let value = results.columns[place * results.rows + i];
            if Pose::is_outside(value, limits) {
                tally.add(row, [joint_limit_finding(prepared.system.mechanism(), joint, value, limits)]);
            }
        }
    }
}

impl BatchResults {
    /// m̄ of a row and the rounding error bound, kg; `None` if uncertain.
    pub fn mass(&self, i: usize) -> Option<(f64, f64)> {
        match self.results[i] {
            BatchAnswer { mass: Some(EffectiveMass::Finite(mass)), error: Some(error), .. } => {
                Some((mass, error))
            }
            _ => None,
        }
    }

    /// Joint positions of a row.
    pub fn positions(&self, layout: &Arc<PoseLayout>, i: usize) -> Positions {
        Positions::from_columns(layout, &self.columns, self.rows, i)
    }
}
