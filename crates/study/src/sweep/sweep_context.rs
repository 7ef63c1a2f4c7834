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
use crate::sweep::continuation::{LineContinuation, StepLimit};
use crate::sweep::plain_rows::{PlainFindings, PlainRow, TreeRows};
use crate::sweep::row_blocks::{DistanceMeasure, RowBlock};
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
    /// SIMD evaluation of a tree, if rows need no poses.
    pub tree_rows: Option<TreeRows>,
}

/// Pose of a row, or the reason for a missing pose.
#[derive(Debug)]
pub(crate) enum RowPose {
    /// Row with a pose. `first`: true for the first row of its line that is reached.
    Posed { pose: Arc<Pose>, first: bool },
    /// Row evaluated without a pose.
    Plain(PlainRow),
    /// Row that is not reached.
    Unreached(NoPose),
}

/// Reason of a row without a pose, or error of the question.
pub(crate) type NoPose = Result<String, StudyError>;

/// Outcome of a row.
#[derive(Debug)]
pub(crate) struct RowOutcome<T> {
    /// Converted row.
    pub converted: T,
    /// True if the pose was reached.
    pub reached: bool,
    /// Reason for a missing result.
    pub error: Option<String>,
    /// Input error, which ends the sweep before the first row with a result.
    pub refusal: Option<StudyError>,
}

/// Consecutive rows evaluated together.
#[derive(Debug)]
pub(crate) struct PortionResults<T> {
    pub rows: Vec<RowOutcome<T>>,
    pub tally: FindingTally,
    pub skipped: Option<SkippedRows>,
    pub step_limit: StepLimit,
    /// Findings shared by consecutive rows, the first row, and the number of rows.
    shared_findings: Option<(Arc<[Finding]>, usize, usize)>,
}

impl<T> PortionResults<T> {
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
    type Shared = PlainFindings;
    type Error = NoPose;

    fn pose(&mut self, row: usize, values: &[f64], last: Option<&Pose>) -> Result<Arc<Pose>, NoPose> {
        self.starts_line = last.is_none();
        self.context.pose_row(self.line, self.first + row, values, last)
    }

    fn driven_path(&mut self, pose: &Pose) -> Option<(DrivenPath, PlainFindings)> {
        let SweepContext { prepared, row_layout, contact, heading, .. } = self.context;
        if heading.gradient.is_some() {
            // A gradient needs the pose of its row.
            return None;
        }
        PlainFindings::of_path(prepared, row_layout, contact, pose)
    }

    fn receive(&mut self, _: usize, values: &[f64], answer: RowAnswer<'_, PlainFindings, NoPose>) {
        let SweepContext { prepared, heading, .. } = self.context;
        let row_pose = match answer {
            RowAnswer::Unreached(reason) => return self.row_poses.push(RowPose::Unreached(reason)),
            RowAnswer::Posed(pose) => RowPose::Posed { pose, first: std::mem::take(&mut self.starts_line) },
            RowAnswer::Followed { shared, mass, answer, positions } => {
                let residual = Some(answer.residual);
                RowPose::Plain(shared.row(prepared, &heading.joints, mass, residual, positions))
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
    /// The reason of a row without a pose.
    fn pose_row(
        &self,
        line: &mut LineContinuation,
        row: usize,
        values: &[f64],
        last: Option<&Pose>,
    ) -> Result<Arc<Pose>, NoPose> {
        let names = self.prepared.question.names;
        let pose = line.pose(&self.prepared.system, &self.row_layout, names, row, values, last);
        pose.map_err(Err)?.map_err(Ok)
    }

    /// Line whose first row starts from the pose of the question.
    pub fn new_line(&self, too_far: StepLimit) -> LineContinuation {
        LineContinuation::new(self.distance_measure, self.travel.clone(), too_far)
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

    /// Rows of a tree; an uncertain row is posed alone.
    pub fn rows_of_tree<'s>(
        &'s self,
        tree: &'s TreeRows,
        block: &'s RowBlock,
        rows: Range<usize>,
    ) -> impl Iterator<Item = RowPose> {
        let results = tree.evaluate(block, rows.clone());
        rows.enumerate().map(move |(at, i)| {
            let values = block.values(i);
            if let Some(row) = tree.row(&self.prepared, &self.heading, &results, at, values) {
                return RowPose::Plain(row);
            }
            let mut line = self.new_line(None);
            let pose = self.pose_row(&mut line, block.first + i, values, None);
            pose.map_or_else(RowPose::Unreached, |pose| RowPose::Posed { pose, first: true })
        })
    }

    /// Evaluates a row and appends the outcome to the portion.
    pub fn evaluate_row<T>(
        &self,
        portion: &mut PortionResults<T>,
        block: &RowBlock,
        i: usize,
        row_pose: RowPose,
        travel: Option<&PointTravel>,
        convert: RowConversion<'_, T>,
    ) {
        let row = block.first + i;
        let varied = VariedValues::new(&self.row_layout.columns, block.values(i));
        let reached = !matches!(row_pose, RowPose::Unreached(Ok(_)));
        let mut refusal = None;
        let sweep_row = match row_pose {
            RowPose::Unreached(Ok(why)) => self.row_without_result(row, varied, UNREACHABLE, why),
            RowPose::Plain(PlainRow { positions, mass, residual, gradient, shared_findings, own }) => {
                portion.tally.add(row, own);
                portion.add_shared_findings(row, &shared_findings);
                let needs_list = self.passed_stops.is_some() || self.gap.is_some();
                let all = if needs_list { positions.in_joint_order() } else { Vec::new() };
                if let Some(stops) = &self.passed_stops {
                    portion.tally.add(row, stops.findings_at(&all));
                }
                if let Some((gap, drawn)) = &self.gap {
                    let gap = gap.at_positions(drawn, &all);
                    let is_open = Gap::is_open(gap, self.prepared.system.mechanism());
                    portion.tally.add(row, is_open.then(|| open_gap_finding(gap).into_note()));
                }
                SweepRow {
                    effective_mass: Some(mass.0),
                    effective_mass_error: Some(mass.1),
                    closure_residual: residual,
                    singular_pose: Some(false),
                    gap: self.gap.as_ref().map(|(gap, drawn)| Some(gap.at_positions(drawn, &all))),
                    ..self.row(row, varied, Status::Finite.name(), positions, gradient)
                }
            }
            RowPose::Posed { pose, first } => {
                if first {
                    portion.tally.add(row, self.prepared.guess_findings(&pose));
                }
                match self.prepared.evaluate(&pose, &self.prepared.contact_of_row(&self.contact, &pose)) {
                    Err(error) => self.row_in_error(row, varied, error, &mut refusal),
                    Ok(answer) => {
                        let sweep_row = self.row_with_pose(row, varied, &pose, &answer, travel);
                        portion.tally.add(row, answer.findings);
                        let passed = self.passed_stops.iter().flat_map(|stops| stops.findings(&pose));
                        portion.tally.add(row, passed);
                        sweep_row
                    }
                }
            }
            RowPose::Unreached(Err(error)) => self.row_in_error(row, varied, error, &mut refusal),
        };
        let error = sweep_row.error.clone();
        portion.rows.push(RowOutcome { converted: convert(sweep_row), reached, error, refusal });
    }

    /// Row without a result because of an error; `refusal` receives an error of the input.
    fn row_in_error(
        &self,
        row: usize,
        varied: VariedValues,
        error: StudyError,
        refusal: &mut Option<StudyError>,
    ) -> SweepRow {
        let why = error.message(self.prepared.question.names);
        *refusal = Some(error).filter(|error| !error.has_no_result());
        self.row_without_result(row, varied, NO_RESULT_STATUS, why)
    }

    /// Gradient of a row if gradients are requested; `values`: one number per velocity of all joints.
    fn gradient_of(&self, values: impl FnOnce() -> Vec<f64>) -> Option<RowGradient> {
        self.heading.gradient.as_ref().map(|layout| RowGradient::new(layout, values()))
    }

    /// Row without further results.
    fn row(
        &self,
        row: usize,
        varied: VariedValues,
        status: &'static str,
        pose: Positions,
        gradient: Option<RowGradient>,
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
        let gradient = self.gradient_of(|| {
            let contact = self.prepared.contact_of_row(&self.contact, pose);
            let found = pose.effective_mass_gradient(&contact).ok().flatten();
            found.map(|gradient| gradient.joints.concat()).unwrap_or_default()
        });
        let positions = Positions::from_pose(&self.heading.joints, pose);
        SweepRow {
            effective_mass,
            effective_mass_error: answer.response.effective_mass_error(),
            closure_residual: pose.loops().map(|l| l.residual),
            singular_pose: Some(answer.response.singular_pose),
            motion_ratio,
            estimate: estimate.and_then(|e| e.estimate),
            estimate_error_percent: estimate.and_then(|e| e.error_percent),
            gap: self.gap.as_ref().map(|(gap, _)| Some(gap.at(pose))),
            ..self.row(row, varied, status.name(), positions, gradient)
        }
    }

    /// Row with a status and an error message.
    fn row_without_result(
        &self,
        row: usize,
        varied: VariedValues,
        status: &'static str,
        error: String,
    ) -> SweepRow {
        let positions = Positions::none(&self.heading.joints);
        SweepRow {
            error: Some(error),
            ..self.row(row, varied, status, positions, self.gradient_of(Vec::new))
        }
    }
}

/// Status of a row without an existing pose.
const UNREACHABLE: &str = "unreachable";
/// Status of a row with a pose and without a result.
const NO_RESULT_STATUS: &str = "no answer";
