//! What is asked of every row of a sweep: where it stands, and what its contact is answered there.

use crate::answer::{Answer, Prepared};
use crate::driver::Driver;
use crate::error::StudyError;
use crate::finding::Tally;
use crate::in_lanes::InLanes;
use crate::line::{Along, Line, TooFar};
use crate::mass_report::Status;
use crate::positions::Positions;
use crate::reach::Untried;
use crate::rows::Block;
use crate::setting::Setting;
use crate::sweep_report::{SweepHeading, SweepRow};
use crate::travel::Travel;
use crate::varied_values::VariedValues;
use percuss_dynamics::{Contact, Pose};
use std::ops::Range;
use std::sync::Arc;

/// The contact of a sweep, and what its rows set.
#[derive(Debug)]
pub(crate) struct Swept<'a> {
    pub prepared: Prepared<'a>,
    pub setting: Setting,
    /// The travel, where it begins at the same place in every row.
    pub travel: Option<Arc<(Travel, Driver)>>,
    pub contact: Contact,
    pub heading: SweepHeading,
    /// Which number tells how far out a row of a line lies.
    pub along: Along,
    /// Where rows need no poses.
    pub lanes: Option<InLanes>,
}

/// Where a row stands.
#[derive(Debug)]
pub(crate) enum Stand {
    /// `first`: the first of its line.
    Posed { pose: Arc<Pose>, first: bool },
    /// Why it is not reached.
    Unreached(String),
    /// What is wrong with the question.
    Failed(StudyError),
}

/// A row, and what it says of the sweep.
#[derive(Debug)]
pub(crate) enum Outcome<T> {
    /// What was made of it; whether its pose was reached; why it has no answer.
    Row { made: T, reached: bool, error: Option<String> },
    /// It is in error: it has no answer, or the sweep ends, where no row before it has one.
    Failed { row: usize, varied: VariedValues, error: StudyError },
}

/// Rows that were answered together, in order.
#[derive(Debug)]
pub(crate) struct Portion<T> {
    pub rows: Vec<Outcome<T>>,
    pub tally: Tally,
    pub untried: Option<Untried>,
    pub too_far: TooFar,
}

impl<T> Portion<T> {
    pub fn new(rows: usize) -> Self {
        Self { rows: Vec::with_capacity(rows), tally: Tally::default(), untried: None, too_far: None }
    }
}

/// What is made of a row, by any thread.
pub(crate) type Made<'m, T> = &'m (dyn Fn(SweepRow) -> T + Sync);

impl Swept<'_> {
    /// Where the next row of a line stands.
    pub fn stand(&self, line: &mut Line, block: &Block, i: usize) -> Stand {
        let first = line.is_new();
        let (names, values) = (self.prepared.question.names, block.values(i));
        match line.pose(&self.prepared.system, &self.setting, names, block.first + i, values) {
            Ok(Ok(pose)) => Stand::Posed { pose, first },
            Ok(Err(why)) => Stand::Unreached(why),
            Err(error) => Stand::Failed(error),
        }
    }

    /// Answers a row.
    pub fn answer<T>(
        &self,
        portion: &mut Portion<T>,
        block: &Block,
        i: usize,
        stand: Stand,
        travel: Option<&Travel>,
        made: Made<'_, T>,
    ) {
        let row = block.first + i;
        let varied = VariedValues::new(&self.setting.columns, block.values(i));
        let failed = |varied, error| Outcome::Failed { row, varied, error };
        let outcome = match stand {
            Stand::Failed(error) => failed(varied, error),
            Stand::Unreached(why) => {
                let made = made(self.unanswered(row, varied, UNREACHABLE, why.clone()));
                Outcome::Row { made, reached: false, error: Some(why) }
            }
            Stand::Posed { pose, first } => {
                if first {
                    portion.tally.add(row, self.prepared.about_guesses(&pose));
                }
                match self.prepared.answer(&pose, &self.contact) {
                    Err(error) => failed(varied, error),
                    Ok(answer) => {
                        let answered = self.answered(row, varied, &pose, &answer, travel);
                        portion.tally.add(row, answer.findings);
                        Outcome::Row { made: made(answered), reached: true, error: None }
                    }
                }
            }
        };
        portion.rows.push(outcome);
    }

    /// Answers rows of a block without poses.
    pub fn answer_in_lanes<T>(&self, block: &Block, rows: Range<usize>, made: Made<'_, T>) -> Portion<T> {
        let mut portion = Portion::new(rows.len());
        let Some(lanes) = &self.lanes else { return portion };
        let asked = lanes.ask(block, rows.clone());
        for (at, i) in rows.enumerate() {
            let Some((mass, error)) = asked.mass(at) else {
                let mut line = Line::new(self.along, None, None);
                let stand = self.stand(&mut line, block, i);
                self.answer(&mut portion, block, i, stand, None, made);
                continue;
            };
            let row = block.first + i;
            lanes.find(&self.prepared, &asked, at, row, &mut portion.tally);
            let answered = SweepRow {
                row,
                varied: VariedValues::new(&self.setting.columns, block.values(i)),
                status: Status::Finite.name(),
                effective_mass: Some(mass),
                effective_mass_error: Some(error),
                closure_residual: None,
                singular_pose: Some(false),
                motion_ratio: None,
                estimate: None,
                estimate_error_percent: None,
                pose: asked.positions(&self.heading.joints, at),
                error: None,
            };
            portion.rows.push(Outcome::Row { made: made(answered), reached: true, error: None });
        }
        portion
    }

    fn answered(
        &self,
        row: usize,
        varied: VariedValues,
        pose: &Pose,
        answer: &Answer,
        travel: Option<&Travel>,
    ) -> SweepRow {
        let estimate = answer.estimate.as_ref();
        let motion_ratio = match estimate {
            Some(estimate) => estimate.motion_ratio,
            None => travel.and_then(|travel| travel.motion_ratio(pose, answer.of_mechanism())),
        };
        let (status, effective_mass) = Status::of(answer.response.effective_mass);
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
            pose: Positions::of(&self.heading.joints, pose),
            error: None,
        }
    }

    pub fn unanswered(
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
            pose: Positions::none(&self.heading.joints),
            error: Some(error),
        }
    }
}

/// The status of a row whose pose does not exist.
const UNREACHABLE: &str = "unreachable";
/// The status of a row whose question has no answer there.
pub(crate) const NO_ANSWER: &str = "no answer";
