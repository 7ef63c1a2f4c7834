//! Rows of a tree, many at once: where m̄ is all that is asked, no pose is made for it.
//!
//! What is told of a row is the same as with a pose. A row that lanes leave in doubt is posed and answered by itself.

use crate::answer::Prepared;
use crate::far_point;
use crate::finding::{Finding, Tally};
use crate::findings::outside_limits;
use crate::positions::{PoseLayout, Positions};
use crate::rows::Block;
use crate::setting::Setting;
use percuss_dynamics::{Batch, BatchAnswer, BatchPositions, Contact, EffectiveMass, Pose};
use percuss_mechanism::{JointId, Limits};
use std::ops::Range;
use std::sync::Arc;

/// What a row with a finite m̄ may be told besides, wherever it stands.
const OF_ANY_ROW: [&str; 2] = ["outside-limits", "far-point"];

/// A contact, ready for many rows at once.
#[derive(Debug)]
pub(crate) struct InLanes {
    batch: Batch,
    /// The positions of all joints where nothing is varied.
    base: Vec<f64>,
    /// Where each number of a row stands among them.
    places: Vec<usize>,
    limits: Vec<(JointId, usize, Limits)>,
    far_point: Option<Finding>,
}

/// Some rows that were asked at once.
pub(crate) struct Asked {
    rows: usize,
    columns: Vec<f64>,
    answers: Vec<BatchAnswer>,
}

impl InLanes {
    /// None where rows must be posed: loops, mimics, or more asked than m̄.
    pub fn new(prepared: &Prepared, setting: &Setting, contact: &Contact) -> Option<Self> {
        let system = &prepared.system;
        let has_loops = system.mechanism().joint_ids().any(|joint| system.is_bound(joint));
        let plain = prepared.is_plain() && !setting.travels() && !has_loops;
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
        let far_point = far_point::doubt(mechanism, contact.link, &contact.point, prepared.question.names);
        let lanes = Self { batch, places, limits: limits.collect(), base, far_point };
        lanes.tell_all(prepared, setting, contact).then_some(lanes)
    }

    /// Whether a row is told nothing but what lanes know: asked at a pose that is none in particular.
    fn tell_all(&self, prepared: &Prepared, setting: &Setting, contact: &Contact) -> bool {
        let values: Vec<f64> = (0..setting.width()).map(|i| 0.1 + (0.618 * i as f64).fract()).collect();
        let pose = setting.configuration(&values, false).ok().and_then(|c| prepared.system.pose(&c).ok());
        let answer = pose.and_then(|pose| prepared.answer(&pose, contact).ok());
        answer.is_some_and(|answer| {
            matches!(answer.response.effective_mass, EffectiveMass::Finite(_))
                && answer.findings.iter().all(|finding| OF_ANY_ROW.contains(&finding.code()))
        })
    }

    /// Asks for some rows of a block.
    pub fn ask(&self, block: &Block, rows: Range<usize>) -> Asked {
        let count = rows.len();
        let mut columns = vec![0.0; self.base.len() * count];
        for (column, value) in columns.chunks_exact_mut(count).zip(&self.base) {
            column.fill(*value);
        }
        for (number, place) in self.places.iter().enumerate() {
            let column = &mut columns[place * count..][..count];
            for (to, row) in column.iter_mut().zip(rows.clone()) {
                *to = block.values(row)[number];
            }
        }
        let mut answers = vec![BatchAnswer::NONE; count];
        let positions = BatchPositions::Columns { values: &columns, stride: count };
        // As many columns as the mechanism has positions, each as long as there are answers.
        if self.batch.run_here(positions, &mut answers).is_err() {
            answers.fill(BatchAnswer::NONE);
        }
        Asked { rows: count, columns, answers }
    }

    /// What the reader should know of a row that has an answer.
    pub fn find(&self, prepared: &Prepared, asked: &Asked, i: usize, row: usize, tally: &mut Tally) {
        if let Some(far_point) = &self.far_point {
            tally.add(row, [far_point.clone()]);
        }
        for &(joint, place, limits) in &self.limits {
            let value = asked.columns[place * asked.rows + i];
            if Pose::is_outside(value, limits) {
                tally.add(row, [outside_limits(prepared.system.mechanism(), joint, value, limits)]);
            }
        }
    }
}

impl Asked {
    /// m̄ of a row and what rounding may amount to, kg; none where that is in doubt.
    pub fn mass(&self, i: usize) -> Option<(f64, f64)> {
        match self.answers[i] {
            BatchAnswer { mass: Some(EffectiveMass::Finite(mass)), error: Some(error), .. } => {
                Some((mass, error))
            }
            _ => None,
        }
    }

    /// Where the joints of a row stand.
    pub fn positions(&self, layout: &Arc<PoseLayout>, i: usize) -> Positions {
        Positions::of_columns(layout, &self.columns, self.rows, i)
    }
}
