//! Evaluation of the rows of a sweep: pose of a row, and result of the contact.

use crate::checks::finding::{Finding, Tally};
use crate::evaluation::answer::{Answer, Prepared};
use crate::evaluation::status::Status;
use crate::pose::driver::Driver;
use crate::pose::positions::Positions;
use crate::pose::travel::Travel;
use crate::pose::unreachable_range::Untried;
use crate::question::error::StudyError;
use crate::question::varied_values::VariedValues;
use crate::sweep::continuation::{Along, Line, TooFar};
use crate::sweep::lanes::InLanes;
use crate::sweep::path_follower::{FollowedRow, Following, Reached};
use crate::sweep::row_blocks::Block;
use crate::sweep::row_layout::Setting;
use crate::sweep::sweep_report::{SweepHeading, SweepRow};
use crate::thresholds::{FOLLOWED_BEGINNINGS, FOLLOWED_ROWS};
use percuss_dynamics::{Contact, Pose};
use std::ops::Range;
use std::sync::Arc;

/// Contact of a sweep and layout of the rows.
#[derive(Debug)]
pub(crate) struct Swept<'a> {
    pub prepared: Prepared<'a>,
    pub setting: Setting,
    /// Travel, if all rows share the same starting pose.
    pub travel: Option<Arc<(Travel, Driver)>>,
    pub contact: Contact,
    pub heading: SweepHeading,
    /// Number of a row that measures the distance along a line.
    pub along: Along,
    /// SIMD evaluation, if rows need no poses.
    pub lanes: Option<InLanes>,
}

/// Pose of a row, or the reason for a missing pose.
#[derive(Debug)]
pub(crate) enum Stand {
    /// Row with a pose. `first`: first row reached of its line.
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
pub(crate) enum Outcome<T> {
    /// Value made of the row, true if the pose was reached, and the reason for a missing result.
    Row { made: T, reached: bool, error: Option<String> },
    /// Row in error. An input error before the first row with a result ends the sweep; any other error leaves
    /// the row without a result.
    Failed { row: usize, varied: VariedValues, error: StudyError },
}

/// Consecutive rows evaluated together.
#[derive(Debug)]
pub(crate) struct Portion<T> {
    pub rows: Vec<Outcome<T>>,
    pub tally: Tally,
    pub skipped: Option<Untried>,
    pub step_limit: TooFar,
    /// Findings shared by consecutive rows, the first row, and the number of rows.
    shared_findings: Option<(Arc<[Finding]>, usize, usize)>,
}

impl<T> Portion<T> {
    pub fn new(rows: usize) -> Self {
        let tally = Tally::default();
        Self { rows: Vec::with_capacity(rows), tally, skipped: None, step_limit: None, shared_findings: None }
    }

    /// Counts a row for findings shared by the whole branch.
    fn add_shared_findings(&mut self, row: usize, findings: &Arc<[Finding]>) {
        match &mut self.shared_findings {
            Some((said, _, rows)) if Arc::ptr_eq(said, findings) => *rows += 1,
            _ => {
                self.count_alike();
                self.shared_findings = Some((Arc::clone(findings), row, 1));
            }
        }
    }

    fn count_alike(&mut self) {
        if let Some((findings, first, rows)) = self.shared_findings.take() {
            self.tally.add_alike(first, rows, &findings);
        }
    }

    /// All findings of the portion.
    pub fn drain_findings(&mut self) -> Tally {
        self.count_alike();
        std::mem::take(&mut self.tally)
    }
}

/// Conversion of a row to the caller's type, callable from any thread.
pub(crate) type Made<'m, T> = &'m (dyn Fn(SweepRow) -> T + Sync);

impl Swept<'_> {
    /// Pose of the next row of a line.
    pub fn next_pose(&self, line: &mut Line, block: &Block, i: usize) -> Stand {
        let first = line.is_new();
        let (names, values) = (self.prepared.question.names, block.values(i));
        match line.pose(&self.prepared.system, &self.setting, names, block.first + i, values) {
            Ok(Ok(pose)) => Stand::Posed { pose, first },
            Ok(Err(why)) => Stand::Unreached(why),
            Err(error) => Stand::Failed(error),
        }
    }

    /// Poses of consecutive rows of a line.
    pub fn next_poses(&self, line: &mut Line, block: &Block, rows: Range<usize>) -> Vec<Stand> {
        let mut stands = Vec::with_capacity(rows.len());
        let mut next = rows.start;
        while next < rows.end {
            if let Some(following) = &mut line.following {
                let values = block.values_from(next, rows.end);
                let layout = &self.heading.joints;
                let reached = following.follow(&self.prepared, layout, values, |reached| {
                    stands.push(match reached {
                        Reached::Evaluated(row) => Stand::Followed(Box::new(row)),
                        Reached::Posed(pose) => Stand::Posed { pose, first: false },
                    });
                });
                if reached > 0 {
                    let pose = following.pose();
                    next += reached;
                    line.continue_from(pose, block.values(next - 1).last().copied().unwrap_or_default());
                }
                if next == rows.end {
                    break;
                }
            }
            let stand = self.next_pose(line, block, next);
            next += 1;
            if let Stand::Posed { pose, .. } = &stand {
                self.follow_from(line, pose, rows.end - next);
            } else {
                line.following = None;
            }
            stands.push(stand);
        }
        stands
    }

    /// Prepares the path follower from a pose, if enough rows are left and the number of followers built on the
    /// line is below the limit.
    fn follow_from(&self, line: &mut Line, pose: &Pose, left: usize) {
        if line.following.as_mut().is_some_and(|following| following.restart(pose)) {
            return;
        }
        line.following = None;
        if left >= FOLLOWED_ROWS && line.begun < FOLLOWED_BEGINNINGS && self.lanes.is_none() {
            line.begun += 1;
            let following = Following::from(&self.prepared, &self.setting, &self.contact, pose);
            line.following = following.map(Box::new);
        }
    }

    /// Evaluates a row and appends the outcome to the portion.
    pub fn evaluate_row<T>(
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
            Stand::Followed(followed) => {
                portion.tally.add(row, followed.own);
                portion.add_shared_findings(row, &followed.shared_findings);
                let (mass, error) = followed.mass;
                let answered =
                    self.without_pose(row, varied, mass, error, Some(followed.residual), followed.positions);
                Outcome::Row { made: made(answered), reached: true, error: None }
            }
            Stand::Posed { pose, first } => {
                if first {
                    portion.tally.add(row, self.prepared.about_guesses(&pose));
                }
                match self.prepared.answer(&pose, &self.contact) {
                    Err(error) => failed(varied, error),
                    Ok(answer) => {
                        let answered = self.row_with_pose(row, varied, &pose, &answer, travel);
                        portion.tally.add(row, answer.findings);
                        Outcome::Row { made: made(answered), reached: true, error: None }
                    }
                }
            }
        };
        portion.rows.push(outcome);
    }

    /// Evaluates rows of a block without poses. Uncertain rows are posed and evaluated separately.
    pub fn answer_in_lanes<T>(&self, block: &Block, rows: Range<usize>, made: Made<'_, T>) -> Portion<T> {
        let mut portion = Portion::new(rows.len());
        let Some(lanes) = &self.lanes else { return portion };
        let asked = lanes.ask(block, rows.clone());
        for (at, i) in rows.enumerate() {
            let Some((mass, error)) = asked.mass(at) else {
                let mut line = Line::new(self.along, None, None);
                let stand = self.next_pose(&mut line, block, i);
                self.evaluate_row(&mut portion, block, i, stand, None, made);
                continue;
            };
            let row = block.first + i;
            lanes.find(&self.prepared, &asked, at, row, &mut portion.tally);
            let varied = VariedValues::new(&self.setting.columns, block.values(i));
            let positions = asked.positions(&self.heading.joints, at);
            let answered = self.without_pose(row, varied, mass, error, None, positions);
            portion.rows.push(Outcome::Row { made: made(answered), reached: true, error: None });
        }
        portion
    }

    /// Row with a finite m̄, evaluated without a pose.
    fn without_pose(
        &self,
        row: usize,
        varied: VariedValues,
        mass: f64,
        error: f64,
        closure_residual: Option<f64>,
        pose: Positions,
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
            pose,
            error: None,
        }
    }

    fn row_with_pose(
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

/// Status of a row without an existing pose.
const UNREACHABLE: &str = "unreachable";
/// Status of a row with a pose and without a result.
pub(crate) const NO_ANSWER: &str = "no answer";
