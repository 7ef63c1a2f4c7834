//! The same contact over a range of positions; loops stay closed along one branch. Rows are handed out as they are
//! computed, and none is kept.

use crate::answer::{Answer, Prepared};
use crate::driver_path::DriverPath;
use crate::error::{Fault, StudyError};
use crate::field::Field;
use crate::finding::{Finding, Subject, Tally};
use crate::mass_report::Status;
use crate::model::Model;
use crate::positions::{PoseLayout, Positions};
use crate::quantity::Dimension;
use crate::question::MassQuestion;
use crate::reach::Reach;
use crate::record::DiagnosticRecord;
use crate::sweep_report::{SweepEnd, SweepHeading, SweepReport, SweepRow};
use crate::thresholds::ROWS;
use crate::vary::{Values, Vary};
use percuss_dynamics::{Contact, Pose};
use std::ops::ControlFlow;

/// A sweep that is prepared: names resolved, numbers checked, the contact known.
#[derive(Debug)]
pub struct Sweep<'a> {
    prepared: Prepared<'a>,
    path: DriverPath,
    values: Values,
    contact: Contact,
    /// Where the point of the contact was found.
    about_point: Option<Finding>,
    heading: SweepHeading,
}

/// Answers a contact over a range, row by row; `each` takes a row and may end the sweep.
///
/// A point given in another frame than the struck link's is converted once, at the pose that the question sets with the
/// varied joint (or the travel) at 0, whatever the range is; it moves with the link. A row that cannot be reached states
/// so, and the sweep goes on from the last that was; rows that are known to lie beyond it are not tried.
///
/// # Errors
/// [`StudyError`]: names that nothing bears, something that cannot be varied, a contact that means nothing.
pub fn sweep(
    model: &Model,
    question: &MassQuestion,
    vary: &Vary,
    each: &mut dyn FnMut(SweepRow) -> ControlFlow<()>,
) -> Result<SweepEnd, StudyError> {
    Sweep::new(model, question, vary)?.run(each)
}

/// A sweep with all its rows in memory: some hundred bytes each.
///
/// # Errors
/// [`StudyError`], as for [`sweep()`].
pub fn sweep_report(model: &Model, question: &MassQuestion, vary: &Vary) -> Result<SweepReport, StudyError> {
    let sweep = Sweep::new(model, question, vary)?;
    let heading = sweep.heading().clone();
    let mut rows = Vec::new();
    let end = sweep.run(&mut |row| {
        rows.push(row);
        ControlFlow::Continue(())
    })?;
    let diagnostics = model.diagnostics.iter().cloned().chain(end.diagnostics).collect();
    Ok(SweepReport { heading, rows, diagnostics })
}

impl<'a> Sweep<'a> {
    /// Prepares a sweep.
    ///
    /// # Errors
    /// [`StudyError`], as for [`sweep()`], where no row needs to be computed to find out.
    pub fn new(model: &'a Model, question: &'a MassQuestion, vary: &Vary) -> Result<Self, StudyError> {
        let prepared = Prepared::new(model, question)?;
        if !ROWS.contains(&vary.count) {
            return Err(StudyError::input(Field::Vary, Fault::Rows { count: vary.count }));
        }
        let path = DriverPath::new(&prepared, vary)?;
        let wrong_unit = |error| StudyError::input(Field::Vary, Fault::Range(error));
        let values = vary.values(path.dimension()).map_err(wrong_unit)?;
        let contact = match prepared.contact_in_link() {
            Some(contact) => contact,
            None => prepared.contact_at(&path.reference(&prepared.system)?),
        };
        let about_point = prepared.about_point(&contact, &path.reference_place());
        let heading = SweepHeading {
            schema: "percuss.sweep/1",
            percuss: env!("CARGO_PKG_VERSION"),
            inputs: model.inputs.clone(),
            varied: vary.name(),
            unit: if path.dimension() == Dimension::Angle { "rad" } else { "m" },
            link: question.link.clone(),
            joints: PoseLayout::new(&model.mechanism),
        };
        Ok(Self { prepared, path, values, contact, about_point, heading })
    }

    /// What is the same for all rows.
    pub fn heading(&self) -> &SweepHeading {
        &self.heading
    }

    /// How many rows there will be.
    pub fn count(&self) -> usize {
        self.values.count
    }

    /// Computes the rows one after another; `each` takes them and may end the sweep.
    ///
    /// # Errors
    /// [`StudyError`], as for [`sweep()`]; after the first row that has an answer, errors stand in their rows.
    pub fn run(self, each: &mut dyn FnMut(SweepRow) -> ControlFlow<()>) -> Result<SweepEnd, StudyError> {
        let mut progress = Progress::default();
        let (mut rows, mut unanswered, mut first_error) = (0, 0, None);
        for number in 0..self.values.count {
            let row = self.row(&mut progress, number)?;
            rows += 1;
            if let Some(error) = &row.error {
                unanswered += 1;
                first_error.get_or_insert_with(|| error.clone());
            }
            if each(row).is_break() {
                break;
            }
        }
        let of_all = self.about_point.into_iter().chain(progress.about_untried()).map(DiagnosticRecord::from);
        let diagnostics = of_all.chain(progress.tally.into_records(rows)).collect();
        Ok(SweepEnd { rows, unanswered, first_error, diagnostics })
    }

    /// The next row.
    fn row(&self, progress: &mut Progress, row: usize) -> Result<SweepRow, StudyError> {
        let value = self.values.of_row(row);
        if let Some(found_by) = progress.reach.excludes(value) {
            return Ok(self.unanswered(row, value, UNREACHABLE, progress.reach.skip(row, found_by)));
        }
        let answer = match self.path.pose(&self.prepared.system, progress.last.as_ref(), value) {
            Ok(Ok(pose)) => self.answered(progress, row, value, pose),
            Ok(Err(missed)) => {
                progress.reach.missed(row, value, missed.extent);
                return Ok(self.unanswered(row, value, UNREACHABLE, missed.why));
            }
            Err(error) => Err(error),
        };
        match answer {
            // What is wrong from the start is wrong with the question; later it is wrong with a row.
            Err(error) if progress.answered || error.is_no_answer() => {
                Ok(self.unanswered(row, value, NO_ANSWER, error.message(self.prepared.question.names)))
            }
            answer => answer,
        }
    }

    /// The row of a pose.
    fn answered(
        &self,
        progress: &mut Progress,
        row: usize,
        value: f64,
        pose: Pose,
    ) -> Result<SweepRow, StudyError> {
        if progress.last.is_none() {
            progress.tally.add(row, self.prepared.about_guesses(&pose));
        }
        let answer = self.prepared.answer(&pose, &self.contact);
        let row = answer.map(|answer| self.row_of(row, value, &pose, answer, &mut progress.tally));
        progress.answered |= row.is_ok();
        progress.reach.answered(value);
        progress.last = Some(pose);
        row
    }

    fn row_of(&self, row: usize, value: f64, pose: &Pose, answer: Answer, tally: &mut Tally) -> SweepRow {
        let motion_ratio = match &answer.estimate {
            Some(estimate) => estimate.motion_ratio,
            None => self.path.motion_ratio(pose, answer.of_mechanism()),
        };
        let (status, effective_mass) = Status::of(answer.response.effective_mass);
        let estimate = answer.estimate.as_ref();
        let row_of_answer = SweepRow {
            row,
            value,
            status: status.name(),
            effective_mass,
            effective_mass_error: answer.response.effective_mass_error(),
            closure_residual: pose.loops().map(|l| l.residual),
            singular_pose: Some(answer.response.singular_pose),
            motion_ratio,
            estimate: estimate.and_then(|e| e.estimate),
            estimate_error_percent: estimate.and_then(|e| e.error_percent),
            pose: Positions::of(&self.heading.joints, pose),
            error: None,
        };
        tally.add(row, answer.findings);
        row_of_answer
    }

    fn unanswered(&self, row: usize, value: f64, status: &'static str, error: String) -> SweepRow {
        SweepRow {
            row,
            value,
            status,
            effective_mass: None,
            effective_mass_error: None,
            closure_residual: None,
            singular_pose: None,
            motion_ratio: None,
            estimate: None,
            estimate_error_percent: None,
            pose: Positions::none(&self.heading.joints),
            error: Some(error),
        }
    }
}

const UNREACHABLE: &str = "unreachable";
const NO_ANSWER: &str = "no answer";

/// What a row takes over from the rows before.
#[derive(Debug, Default)]
struct Progress {
    /// The pose of the last row that was reached.
    last: Option<Pose>,
    /// Whether any row has an answer.
    answered: bool,
    reach: Reach,
    tally: Tally,
}

impl Progress {
    /// How many rows were not tried, and why.
    fn about_untried(&self) -> Option<Finding> {
        let (count, first, found_by) = self.reach.untried()?;
        let message = format!(
            "{count} row(s) were not tried, row {first} the first: they lie at least as far out as where row {found_by} \
             ended (its error has the reason)"
        );
        Some(Finding::note("rows-not-tried", Subject::Answer, message))
    }
}
