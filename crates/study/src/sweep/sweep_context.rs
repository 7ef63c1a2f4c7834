//! Evaluation of the rows of a sweep: pose of a row, and result of the contact.

use crate::checks::finding::{Finding, FindingTally};
use crate::checks::findings::open_gap_finding;
use crate::evaluation::passed_stops::PassedStops;
use crate::evaluation::prepared_question::{ContactResult, PreparedQuestion};
use crate::evaluation::status::Status;
use crate::pose::driver::Driver;
use crate::pose::point_travel::PointTravel;
use crate::pose::positions::Positions;
use crate::pose::unreachable_range::SkippedRows;
use crate::question::errors::question_error::StudyError;
use crate::question::travel::varied_values::VariedValues;
use crate::sweep::batch_evaluator::BatchEvaluator;
use crate::sweep::continuation::{DistanceMeasure, LineContinuation, StepLimit};
use crate::sweep::followed_rows::{FollowedRow, PathFindings};
use crate::sweep::row_blocks::RowBlock;
use crate::sweep::row_gradient::RowGradient;
use crate::sweep::row_layout::RowLayout;
use crate::sweep::sweep_report::{SweepHeading, SweepRow};
use percuss_dynamics::{Contact, DrivenPath, Gap, Pose, RowAnswer, RowHandler, RowPath};
use std::ops::Range;
use std::sync::Arc;

/// Contact of a sweep and layout of the rows.
#[derive(Debug)]
pub(crate) struct SweepContext<'a> {
    pub prepared: PreparedQuestion<'a>,
    pub row_layout: RowLayout,
    /// Travel, if all rows share the same starting pose.
    pub travel: Option<Arc<(PointTravel, Driver)>>,
    pub contact: Contact,
    pub heading: SweepHeading,
    /// Number of a row that measures the distance along a line.
    pub distance_measure: DistanceMeasure,
    /// Gap of the named contact, with the pose as drawn.
    pub gap: Option<(Gap, Pose)>,
    /// Stops that a row may pass.
    pub passed_stops: Option<PassedStops<'a>>,
    /// SIMD evaluation, if rows need no poses.
    pub batch_evaluator: Option<BatchEvaluator>,
}

/// Pose of a row, or the reason for a missing pose.
#[derive(Debug)]
pub(crate) enum RowPose {
    /// Row with a pose. `first`: true for the first row of its line that is reached.
    Posed { pose: Arc<Pose>, first: bool },
    /// Row reached and evaluated by the path follower.
    Followed(Box<FollowedRow>),
    /// Unreached row, with the reason.
    Unreached(String),
    /// Error of the question.
    Failed(StudyError),
}

/// Outcome of a row.
#[derive(Debug)]
pub(crate) enum RowOutcome<T> {
    /// Converted row, true if the pose was reached, and the reason for a missing result.
    Row { converted: T, reached: bool, error: Option<String> },
    /// Row in error. An input error before the first row with a result ends the sweep; any other error leaves
    /// the row without a result.
    Failed { row: usize, varied: VariedValues, error: StudyError },
}

/// Consecutive rows evaluated together.
#[derive(Debug)]
pub(crate) struct RowResults<T> {
    pub rows: Vec<RowOutcome<T>>,
    pub tally: FindingTally,
    pub skipped: Option<SkippedRows>,
    pub step_limit: StepLimit,
    /// Findings shared by consecutive rows, the first row, and the number of rows.
    shared_findings: Option<(Arc<[Finding]>, usize, usize)>,
}

impl<T> RowResults<T> {
    pub fn new(rows: usize) -> Self {
        let tally = FindingTally::default();
        Self { rows: Vec::with_capacity(rows), tally, skipped: None, step_limit: None, shared_findings: None }
    }

    /// Counts a row for findings shared by the whole branch.
    fn add_shared_findings(&mut self, row: usize, findings: &Arc<[Finding]>) {
        match &mut self.shared_findings {
            Some((last_findings, _, rows)) if Arc::ptr_eq(last_findings, findings) => *rows += 1,
            _ => {
                self.flush_shared_findings();
                self.shared_findings = Some((Arc::clone(findings), row, 1));
            }
        }
    }

    /// Adds the pending shared findings, with their number of rows, to the tally.
    fn flush_shared_findings(&mut self) {
        if let Some((findings, first, rows)) = self.shared_findings.take() {
            self.tally.add_repeated(first, rows, &findings);
        }
    }

    /// All findings of the portion.
    pub fn drain_findings(&mut self) -> FindingTally {
        self.flush_shared_findings();
        std::mem::take(&mut self.tally)
    }
}

/// Collector of the poses of a line, and of the results that need no pose.
struct LineHandler<'r, 'a> {
    context: &'r SweepContext<'a>,
    line: &'r mut LineContinuation,
    /// Number of the first row.
    first: usize,
    /// True if the row posed last starts the line.
    starts_line: bool,
    row_poses: Vec<RowPose>,
}

impl RowHandler for LineHandler<'_, '_> {
    type Shared = PathFindings;
    type Error = RowPose;

    fn pose(&mut self, row: usize, values: &[f64], last: Option<&Pose>) -> Result<Arc<Pose>, RowPose> {
        self.starts_line = last.is_none();
        self.context.pose_row(self.line, self.first + row, values, last)
    }

    fn driven_path(&mut self, pose: &Pose) -> Option<(DrivenPath, PathFindings)> {
        let SweepContext { prepared, row_layout, contact, heading, .. } = self.context;
        if heading.gradient.is_some() {
            // A gradient needs the pose of its row.
            return None;
        }
        PathFindings::of_path(prepared, row_layout, contact, pose)
    }

    fn receive(&mut self, _: usize, values: &[f64], answer: RowAnswer<'_, PathFindings, RowPose>) {
        let SweepContext { prepared, heading, .. } = self.context;
        let row_pose = match answer {
            RowAnswer::Unreached(outcome) => return self.row_poses.push(outcome),
            RowAnswer::Posed(pose) => RowPose::Posed { pose, first: std::mem::take(&mut self.starts_line) },
            RowAnswer::Followed { shared, mass, answer, positions } => {
                let row = shared.row(prepared, &heading.joints, mass, answer.residual, positions);
                RowPose::Followed(Box::new(row))
            }
        };
        self.line.record_reached(values);
        self.row_poses.push(row_pose);
    }
}

/// Conversion of a row to the caller's type, callable from any thread.
pub(crate) type RowConversion<'m, T> = &'m (dyn Fn(SweepRow) -> T + Sync);

impl SweepContext<'_> {
    /// Pose of a row of a line, from the pose of the last row reached.
    ///
    /// # Errors
    /// The outcome of a row without a pose.
    fn pose_row(
        &self,
        line: &mut LineContinuation,
        row: usize,
        values: &[f64],
        last: Option<&Pose>,
    ) -> Result<Arc<Pose>, RowPose> {
        let names = self.prepared.question.names;
        match line.pose(&self.prepared.system, &self.row_layout, names, row, values, last) {
            Ok(Ok(pose)) => Ok(pose),
            Ok(Err(why)) => Err(RowPose::Unreached(why)),
            Err(error) => Err(RowPose::Failed(error)),
        }
    }

    /// Poses of consecutive rows of a line.
    pub fn next_poses(
        &self,
        line: &mut LineContinuation,
        block: &RowBlock,
        rows: Range<usize>,
    ) -> Vec<RowPose> {
        let mut path = std::mem::replace(&mut line.path, RowPath::new(None));
        let (first, count) = (block.first + rows.start, rows.len());
        let values = block.values_from(rows.start, rows.end);
        let row_poses = Vec::with_capacity(count);
        let mut handler = LineHandler { context: self, line, first, starts_line: false, row_poses };
        path.follow(values, count, &mut handler);
        let row_poses = handler.row_poses;
        line.path = path;
        row_poses
    }

    /// Evaluates rows, given by their numbers in the block with their poses.
    pub fn evaluate_rows<T>(
        &self,
        portion: &mut RowResults<T>,
        block: &RowBlock,
        rows: impl Iterator<Item = (usize, RowPose)>,
        travel: Option<&PointTravel>,
        convert: RowConversion<'_, T>,
    ) {
        for (i, row_pose) in rows {
            self.evaluate_row(portion, block, i, row_pose, travel, convert);
        }
    }

    /// Evaluates a row and appends the outcome to the portion.
    pub fn evaluate_row<T>(
        &self,
        portion: &mut RowResults<T>,
        block: &RowBlock,
        i: usize,
        row_pose: RowPose,
        travel: Option<&PointTravel>,
        convert: RowConversion<'_, T>,
    ) {
        let row = block.first + i;
        let varied = VariedValues::new(&self.row_layout.columns, block.values(i));
        let failed = |varied, error| RowOutcome::Failed { row, varied, error };
        let outcome = match row_pose {
            RowPose::Failed(error) => failed(varied, error),
            RowPose::Unreached(why) => {
                let converted = convert(self.row_without_result(row, varied, UNREACHABLE, why.clone()));
                RowOutcome::Row { converted, reached: false, error: Some(why) }
            }
            RowPose::Followed(followed) => {
                portion.tally.add(row, followed.own);
                portion.add_shared_findings(row, &followed.shared_findings);
                self.add_gap_findings(portion, row, &followed.positions);
                let (mass, error) = followed.mass;
                let positions = followed.positions;
                let sweep_row =
                    self.without_pose(row, varied, (mass, error), Some(followed.residual), positions, None);
                RowOutcome::Row { converted: convert(sweep_row), reached: true, error: None }
            }
            RowPose::Posed { pose, first } => {
                if first {
                    portion.tally.add(row, self.prepared.guess_findings(&pose));
                }
                match self.prepared.evaluate(&pose, &self.prepared.contact_of_row(&self.contact, &pose)) {
                    Err(error) => failed(varied, error),
                    Ok(answer) => {
                        let sweep_row = self.row_with_pose(row, varied, &pose, &answer, travel);
                        portion.tally.add(row, answer.findings);
                        let passed = self.passed_stops.iter().flat_map(|stops| stops.findings(&pose));
                        portion.tally.add(row, passed);
                        RowOutcome::Row { converted: convert(sweep_row), reached: true, error: None }
                    }
                }
            }
        };
        portion.rows.push(outcome);
    }

    /// Evaluates rows of a block without poses. Uncertain rows are posed and evaluated separately.
    pub fn evaluate_batch<T>(
        &self,
        block: &RowBlock,
        rows: Range<usize>,
        convert: RowConversion<'_, T>,
    ) -> RowResults<T> {
        let mut portion = RowResults::new(rows.len());
        let Some(lanes) = &self.batch_evaluator else { return portion };
        let batch_results = lanes.evaluate(block, rows.clone());
        for (at, i) in rows.enumerate() {
            let Some((mass, error)) = batch_results.mass(at) else {
                let mut line = LineContinuation::new(self.distance_measure, None, None);
                let row_pose = match self.pose_row(&mut line, block.first + i, block.values(i), None) {
                    Ok(pose) => RowPose::Posed { pose, first: true },
                    Err(outcome) => outcome,
                };
                self.evaluate_row(&mut portion, block, i, row_pose, None, convert);
                continue;
            };
            let row = block.first + i;
            lanes.add_findings(&self.prepared, &batch_results, at, row, &mut portion.tally);
            let varied = VariedValues::new(&self.row_layout.columns, block.values(i));
            let positions = batch_results.positions(&self.heading.joints, at);
            self.add_gap_findings(&mut portion, row, &positions);
            let gradient = self.gradient_of(|| batch_results.gradient(at));
            let sweep_row = self.without_pose(row, varied, (mass, error), None, positions, gradient);
            portion.rows.push(RowOutcome::Row { converted: convert(sweep_row), reached: true, error: None });
        }
        portion
    }

    /// Adds the findings about the gap of a row without a pose, and about the stops that it passes.
    fn add_gap_findings<T>(&self, portion: &mut RowResults<T>, row: usize, positions: &Positions) {
        if let Some(stops) = &self.passed_stops {
            portion.tally.add(row, stops.findings_at(&positions.in_joint_order()));
        }
        if let Some((gap, drawn)) = &self.gap {
            let gap = gap.at_positions(drawn, &positions.in_joint_order());
            let is_open = Gap::is_open(gap, self.prepared.system.mechanism());
            portion.tally.add(row, is_open.then(|| open_gap_finding(gap).into_note()));
        }
    }

    /// Gradient of a row if gradients are requested; `values`: one number per velocity of all joints.
    fn gradient_of(&self, values: impl FnOnce() -> Vec<f64>) -> Option<RowGradient> {
        self.heading.gradient.as_ref().map(|layout| RowGradient::new(layout, values()))
    }

    /// Row with a finite m̄, evaluated without a pose.
    fn without_pose(
        &self,
        row: usize,
        varied: VariedValues,
        (mass, error): (f64, f64),
        closure_residual: Option<f64>,
        pose: Positions,
        gradient: Option<RowGradient>,
    ) -> SweepRow {
        SweepRow {
            row,
            varied,
            status: Status::Finite.name(),
            effective_mass: Some(mass),
            effective_mass_error: Some(error),
            closure_residual,
            singular_pose: Some(false),
            motion_ratio: None,
            estimate: None,
            estimate_error_percent: None,
            gap: self.gap.as_ref().map(|(gap, drawn)| Some(gap.at_positions(drawn, &pose.in_joint_order()))),
            gradient,
            pose,
            error: None,
        }
    }

    /// Row of a result at a pose.
    fn row_with_pose(
        &self,
        row: usize,
        varied: VariedValues,
        pose: &Pose,
        answer: &ContactResult,
        travel: Option<&PointTravel>,
    ) -> SweepRow {
        let estimate = answer.estimate.as_ref();
        let motion_ratio = match travel {
            Some(travel) => {
                let contact = self.prepared.contact_of_row(&self.contact, pose);
                travel.motion_ratio(pose, &contact, answer.mechanism_response())
            }
            None => estimate.and_then(|estimate| estimate.motion_ratio),
        };
        let (status, effective_mass) = Status::classify(answer.response.effective_mass);
        SweepRow {
            row,
            varied,
            status: status.name(),
            effective_mass,
            effective_mass_error: answer.response.effective_mass_error(),
            closure_residual: pose.loops().map(|l| l.residual),
            singular_pose: Some(answer.response.singular_pose),
            motion_ratio,
            estimate: estimate.and_then(|e| e.estimate),
            estimate_error_percent: estimate.and_then(|e| e.error_percent),
            gap: self.gap.as_ref().map(|(gap, _)| Some(gap.at(pose))),
            gradient: self.gradient_of(|| {
                let contact = self.prepared.contact_of_row(&self.contact, pose);
                let found = pose.effective_mass_gradient(&contact).ok().flatten();
                found.map(|gradient| gradient.joints.concat()).unwrap_or_default()
            }),
            pose: Positions::from_pose(&self.heading.joints, pose),
            error: None,
        }
    }

    /// Row with a status and an error message.
    pub fn row_without_result(
        &self,
        row: usize,
        varied: VariedValues,
        status: &'static str,
        error: String,
    ) -> SweepRow {
        SweepRow {
            row,
            varied,
            status,
            effective_mass: None,
            effective_mass_error: None,
            closure_residual: None,
            singular_pose: None,
            motion_ratio: None,
            estimate: None,
            estimate_error_percent: None,
            gap: self.gap.as_ref().map(|_| None),
            gradient: self.gradient_of(Vec::new),
            pose: Positions::none(&self.heading.joints),
            error: Some(error),
        }
    }
}

/// Status of a row without an existing pose.
const UNREACHABLE: &str = "unreachable";
/// Status of a row with a pose and without a result.
pub(crate) const NO_RESULT_STATUS: &str = "no answer";
