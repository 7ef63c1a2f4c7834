//! Rows without poses, if only m̄ is requested: linkages along a path, and trees in SIMD lanes. The results and findings equal those of an
//! evaluation with a pose.

use crate::checks::finding::Finding;
use crate::checks::joint_limits::LimitedJoints;
use crate::evaluation::prepared_question::PreparedQuestion;
use crate::pose::positions::{PoseLayout, Positions};
use crate::sweep::row_blocks::RowBlock;
use crate::sweep::row_gradient::RowGradient;
use crate::sweep::row_layout::RowLayout;
use crate::sweep::sweep_report::SweepHeading;
use percuss_dynamics::{
    Batch, BatchPositions, BatchRows, Contact, DrivenPath, GivenPositions, Pose, RemarkFlags, RowColumns,
    RowResults,
};
use percuss_mechanism::{JointId, Mimic};
use std::ops::Range;
use std::sync::Arc;

/// Row with a finite m̄, evaluated without a pose.
#[derive(Debug)]
pub(crate) struct PlainRow {
    pub positions: Positions,
    /// m̄ and the error bound, kg.
    pub mass: (f64, f64),
    /// Closure residual of a linkage, m.
    pub residual: Option<f64>,
    pub gradient: Option<RowGradient>,
    /// Findings that hold for all rows of the branch.
    pub shared_findings: Arc<[Finding]>,
    /// Findings about this row only: joints outside their limits.
    pub own: Vec<Finding>,
}

/// Findings of rows without poses.
#[derive(Debug)]
pub(crate) struct PlainFindings {
    /// Findings that hold for all rows.
    shared: Arc<[Finding]>,
    limits: LimitedJoints,
}

impl PlainFindings {
    /// Findings of the rows near a pose; `None` if m̄ is not finite there, or if findings depend on the response of a pose.
    fn near(prepared: &PreparedQuestion, contact: &Contact, pose: &Pose) -> Option<Self> {
        let mut shared = prepared.evaluate(pose, contact).ok()?.into_branch_findings()?;
        shared.extend(prepared.guess_findings(pose));
        Some(Self { shared: shared.into(), limits: LimitedJoints::of(prepared.system.mechanism()) })
    }

    /// Path from a pose, and the findings of its rows; `None` if the rows require separate poses.
    pub fn of_path(
        prepared: &PreparedQuestion,
        layout: &RowLayout,
        contact: &Contact,
        pose: &Pose,
    ) -> Option<(DrivenPath, Self)> {
        if !prepared.needs_only_mass() || layout.travels() || pose.loops().is_none() {
            return None;
        }
        let single = |(joint, numbers): (JointId, &Range<usize>)| {
            (numbers.len() == 1).then_some((numbers.start, joint))
        };
        let mut joints: Vec<(usize, JointId)> = layout.joints().map(single).collect::<Option<_>>()?;
        joints.sort_unstable();
        let joints: Vec<JointId> = joints.into_iter().map(|(_, joint)| joint).collect();
        let path = pose.driven_path(contact, &joints).ok().flatten()?;
        Some((path, Self::near(prepared, contact, pose)?))
    }

    /// Row with a result for m̄. `positions`: positions of all joints.
    pub fn row(
        &self,
        prepared: &PreparedQuestion,
        layout: &Arc<PoseLayout>,
        mass: (f64, f64),
        residual: Option<f64>,
        positions: &[f64],
    ) -> PlainRow {
        PlainRow {
            positions: Positions::from_list(layout, positions),
            mass,
            residual,
            gradient: None,
            shared_findings: Arc::clone(&self.shared),
            own: self.limits.findings(prepared.system.mechanism(), |index| positions[index]).collect(),
        }
    }
}

/// Contact of a tree, prepared for the SIMD evaluation of many rows.
#[derive(Debug)]
pub(crate) struct TreeRows {
    batch: Batch,
    /// True if the gradient of each row is computed.
    has_gradient: bool,
    /// Positions of all joints of the question, in joint order.
    base: Vec<f64>,
    /// Index in `base` of each number of a row.
    indices: Vec<usize>,
    /// Index of the position of each joint that mimics another, with that of the other and the relation.
    mimics: Vec<(usize, usize, Mimic)>,
    findings: PlainFindings,
}

/// Results of consecutive rows of a tree.
#[derive(Debug)]
pub(crate) struct TreeResults {
    rows: RowResults,
    /// Gradients, row by row: one number per velocity of all joints; empty unless requested.
    gradients: Vec<f64>,
}

impl TreeRows {
    /// SIMD evaluation; `None` if the rows require poses: loops, or other requests than m̄.
    pub fn new(prepared: &PreparedQuestion, layout: &RowLayout, contact: &Contact) -> Option<Self> {
        let system = &prepared.system;
        let mechanism = system.mechanism();
        let has_loops = mechanism.joint_ids().any(|joint| system.is_bound(joint));
        if !prepared.needs_only_mass() || layout.travels() || has_loops {
            return None;
        }
        let batch = system.reference().ok()?.batch(contact).ok().filter(|batch| batch.has_lanes())?;
        let places: Vec<Range<usize>> = mechanism.position_ranges().collect();
        let mut indices = vec![0; layout.width()];
        for (joint, numbers) in layout.joints() {
            numbers.clone().zip(places[joint.index()].clone()).for_each(|(number, to)| indices[number] = to);
        }
        let mimic = |id: JointId| {
            let mimic = mechanism.joint(id).mimic()?;
            Some((places[id.index()].start, places[mimic.master.index()].start, mimic))
        };
        // A generic sample.
        let values: Vec<f64> = (0..layout.width()).map(|i| 0.1 + (0.618 * i as f64).fract()).collect();
        let pose = system.pose(&layout.configuration(&values, false).ok()?).ok()?;
        Some(Self {
            batch,
            has_gradient: false,
            base: mechanism.joint_ids().flat_map(|id| prepared.configuration.get(id)).copied().collect(),
            indices,
            mimics: mechanism.joint_ids().filter_map(mimic).collect(),
            findings: PlainFindings::near(prepared, contact, &pose)?,
        })
    }

    /// The same with the gradient of each row.
    pub fn with_gradient(self) -> Self {
        Self { has_gradient: true, ..self }
    }

    /// Evaluates some rows of a block.
    pub fn evaluate(&self, block: &RowBlock, rows: Range<usize>) -> TreeResults {
        let count = rows.len();
        let mut results = RowResults::new(count);
        let velocities = if self.has_gradient { self.batch.velocities() } else { 0 };
        let mut gradients = vec![f64::NAN; count * velocities];
        let values = block.values_from(rows.start, rows.end);
        let positions = BatchPositions::Rows { values, stride: self.indices.len() };
        let given = Some(GivenPositions { indices: &self.indices, others: &self.base });
        let wanted = self.has_gradient.then_some(&mut gradients[..]);
        let columns = RowColumns { gradients: wanted, ..results.columns() };
        // The layout always fits: one number per column of the rows, one entry per result.
        if self.batch.run(BatchRows { given, ..positions.into() }, columns, count).is_err() {
            results.columns().clear();
        }
        TreeResults { rows: results, gradients }
    }

    /// Row `at` of the results, with the numbers `values`; `None` if the result is uncertain, so that the row requires a pose.
    pub fn row(
        &self,
        prepared: &PreparedQuestion,
        heading: &SweepHeading,
        results: &TreeResults,
        at: usize,
        values: &[f64],
    ) -> Option<PlainRow> {
        let mass = (results.rows.masses[at], results.rows.errors[at]);
        // The findings of the row contain these remarks.
        let known = self.batch.remarks()
            | RemarkFlags::OUTSIDE_LIMITS
            | RemarkFlags::MANY_TURNS
            | RemarkFlags::OPEN_GAP;
        if !(mass.0.is_finite() && mass.1.is_finite()) || results.rows.remarks[at] & !known.bits() != 0 {
            return None;
        }
        let mut positions = self.base.clone();
        self.indices.iter().zip(values).for_each(|(index, value)| positions[*index] = *value);
        for (own, master, mimic) in &self.mimics {
            positions[*own] = mimic.multiplier * positions[*master] + mimic.offset;
        }
        let velocities = results.gradients.len() / results.rows.masses.len();
        let gradient = || results.gradients[at * velocities..][..velocities].to_vec();
        Some(PlainRow {
            gradient: heading.gradient.as_ref().map(|layout| RowGradient::new(layout, gradient())),
            ..self.findings.row(prepared, &heading.joints, mass, None, &positions)
        })
    }
}
