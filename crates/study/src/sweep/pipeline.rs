//! Pipeline of the rows of a sweep: rows are posed, evaluated and handed out in order, one block at a time.
//!
//! While the calling thread hands out one block, the threads of rayon's pool evaluate the next block and pose
//! the block after that. Whole lines are independent and are distributed over the threads. Block boundaries
//! depend on row numbers only, and limits are exchanged between blocks at fixed points, so results do not
//! depend on the number of threads.

use crate::checks::finding::Tally;
use crate::pose::driver::Driver;
use crate::pose::travel::Travel;
use crate::pose::unreachable_range::{Reach, Untried};
use crate::question::error::StudyError;
use crate::question::varied_values::VariedValues;
use crate::sweep::context::{Made, NO_ANSWER, Outcome, Portion, Stand, Swept};
use crate::sweep::continuation::{Line, TooFar, nearer};
use crate::sweep::row_blocks::{Block, Rows};
use crate::sweep::sweep_report::SweepEnd;
use crate::thresholds::{
    BLOCK_IN_LANES, BLOCK_OF_LINKS, BLOCK_OF_POSES, FIRST_BLOCK, PORTION, PORTION_IN_LANES, UNRELATED,
};
use rayon::prelude::*;
use std::ops::ControlFlow;
use std::sync::Arc;

/// Result of a sweep.
#[derive(Debug)]
pub(crate) struct Came {
    pub end: SweepEnd,
    pub tally: Tally,
    pub skipped: Option<Untried>,
}

/// Runs all rows through the pipeline.
pub(crate) fn run<T: Send>(
    swept: &Swept<'_>,
    rows: Rows,
    made: Made<'_, T>,
    each: &mut dyn FnMut(T) -> ControlFlow<()>,
) -> Result<Came, StudyError> {
    let mut posing = Posing::new(swept, rows);
    let mut out = HandingOut::new(swept, made, each);
    let (mut posed, mut answered) = (None, None);
    loop {
        let (to_answer, to_hand_out) = (posed.take(), answered.take());
        let too_far = posing.step_limit;
        let (mut next_posed, mut next_answered) = (Ok(None), None);
        let mut stopped = Ok(ControlFlow::Continue(()));
        rayon::in_place_scope(|scope| {
            scope.spawn(|_| {
                (next_posed, next_answered) = rayon::join(
                    || posing.next(),
                    || to_answer.map(|posed| evaluate_block(swept, posed, made, too_far)),
                );
            });
            if let Some(portions) = to_hand_out {
                stopped = out.output_results(portions);
            }
        });
        if stopped?.is_break() {
            break;
        }
        (posed, answered) = (next_posed?, next_answered);
        posing.abandoned_after = out.abandoned_after();
        let found = answered.iter().flatten().map(|portion: &Portion<T>| portion.step_limit);
        posing.step_limit = found.fold(posing.step_limit, nearer);
        if posed.is_none() && answered.is_none() {
            break;
        }
    }
    Ok(out.result)
}

/// Block and the remaining work.
struct Posed {
    block: Block,
    work: Work,
}

enum Work {
    /// Lines of this number of rows; each line is posed and evaluated separately.
    Lines(usize),
    /// Portions of posed rows of one line.
    Portions {
        portions: Vec<(usize, Vec<Stand>)>,
        travel: Option<Arc<(Travel, Driver)>>,
        untried: Option<Untried>,
    },
    /// Rows for the SIMD evaluation without poses.
    InLanes,
    /// Rows that are not tried because of row `found_by`.
    Skipped { found_by: usize },
}

/// First stage: forms blocks and poses consecutive rows.
struct Posing<'s, 'a> {
    context: &'s Swept<'a>,
    rows: Rows,
    line: Line,
    /// Number of the next row.
    row: usize,
    /// Approximate number of rows of the next block.
    size: usize,
    largest: usize,
    step_limit: TooFar,
    abandoned_after: Option<usize>,
}

impl<'s, 'a> Posing<'s, 'a> {
    fn new(swept: &'s Swept<'a>, rows: Rows) -> Self {
        let links = swept.prepared.system.mechanism().links().len();
        let largest = match &swept.lanes {
            Some(_) => (BLOCK_OF_LINKS * PORTION_IN_LANES / links.max(1)).clamp(FIRST_BLOCK, BLOCK_IN_LANES),
            None => (BLOCK_OF_LINKS / links.max(1)).clamp(FIRST_BLOCK, BLOCK_OF_POSES),
        };
        let line = Line::new(rows.along(), swept.travel.clone(), None);
        Self {
            context: swept,
            rows,
            line,
            row: 0,
            size: FIRST_BLOCK,
            largest,
            step_limit: None,
            abandoned_after: None,
        }
    }

    /// Next block; `None` at the end.
    fn next(&mut self) -> Result<Option<Posed>, StudyError> {
        // Without poses, rows are independent.
        let line = if self.context.lanes.is_some() { None } else { self.rows.rows_per_line() };
        let whole = line.filter(|rows| *rows <= self.largest);
        let count = match (whole, line) {
            (Some(rows), _) => rows * (self.size / rows).max(1),
            (None, Some(rows)) => self.size.min(rows - self.row % rows),
            (None, None) => self.size,
        };
        let block = self.rows.block(self.row, count)?;
        if block.count == 0 {
            return Ok(None);
        }
        let starts_line = line.is_some_and(|rows| self.row.is_multiple_of(rows));
        self.row += block.count;
        self.size = (2 * self.size).min(self.largest);
        let work = match (self.abandoned_after, whole) {
            (Some(found_by), _) => Work::Skipped { found_by },
            (None, Some(rows)) => Work::Lines(rows),
            (None, None) if self.context.lanes.is_some() => Work::InLanes,
            (None, None) => {
                if starts_line {
                    self.step_limit = nearer(self.step_limit, self.line.step_limit);
                    self.line = Line::new(self.rows.along(), self.context.travel.clone(), self.step_limit);
                }
                self.pose(&block)
            }
        };
        Ok(Some(Posed { block, work }))
    }

    /// Poses the rows of a block, each from the last row reached.
    fn pose(&mut self, block: &Block) -> Work {
        let (swept, line) = (self.context, &mut self.line);
        let mut portions = Vec::with_capacity(block.count.div_ceil(PORTION));
        let mut stands = swept.next_poses(line, block, 0..block.count).into_iter();
        for first in (0..block.count).step_by(PORTION) {
            portions.push((first, stands.by_ref().take(PORTION).collect()));
        }
        Work::Portions { portions, travel: line.travel(), untried: line.unreachable.take_untried() }
    }
}

/// Second stage: evaluates the rows in parallel.
fn evaluate_block<T: Send>(
    swept: &Swept<'_>,
    posed: Posed,
    made: Made<'_, T>,
    too_far: TooFar,
) -> Vec<Portion<T>> {
    let Posed { block, work } = posed;
    let block = &block;
    match work {
        Work::Lines(rows) => {
            let of_line = |first: usize| {
                let mut line = Line::new(swept.along, swept.travel.clone(), too_far);
                let mut portion = Portion::new(rows);
                let stands = swept.next_poses(&mut line, block, first..first + rows);
                let travel = line.travel();
                for (i, stand) in (first..).zip(stands) {
                    swept.evaluate_row(&mut portion, block, i, stand, travel.as_ref().map(|t| &t.0), made);
                }
                (portion.skipped, portion.step_limit) = (line.unreachable.take_untried(), line.step_limit);
                portion
            };
            let lines: Vec<usize> = (0..block.count).step_by(rows).collect();
            lines.into_par_iter().map(of_line).collect()
        }
        Work::Portions { portions, travel, untried } => {
            let of_portion = |(first, stands): (usize, Vec<Stand>)| {
                let mut portion = Portion::new(stands.len());
                for (i, stand) in (first..).zip(stands) {
                    swept.evaluate_row(&mut portion, block, i, stand, travel.as_ref().map(|t| &t.0), made);
                }
                portion
            };
            let mut portions: Vec<Portion<T>> = portions.into_par_iter().map(of_portion).collect();
            if let Some(first) = portions.first_mut() {
                first.skipped = untried;
            }
            portions
        }
        Work::InLanes => {
            let starts: Vec<usize> = (0..block.count).step_by(PORTION_IN_LANES).collect();
            let rows = |first: usize| first..(first + PORTION_IN_LANES).min(block.count);
            starts.into_par_iter().map(|first| swept.answer_in_lanes(block, rows(first), made)).collect()
        }
        Work::Skipped { found_by } => {
            let mut portion = Portion::new(block.count);
            let mut reach = Reach::default();
            for i in 0..block.count {
                let stand = Stand::Unreached(reach.skip(block.first + i, found_by));
                swept.evaluate_row(&mut portion, block, i, stand, None, made);
            }
            portion.skipped = reach.take_untried();
            vec![portion]
        }
    }
}

/// Third stage: hands out the rows in order.
struct HandingOut<'o, 's, 'a, T> {
    context: &'s Swept<'a>,
    convert: Made<'o, T>,
    each: &'o mut dyn FnMut(T) -> ControlFlow<()>,
    result: Came,
    /// Number of consecutive rows that were not reached.
    unreached: usize,
}

impl<'o, 's, 'a, T> HandingOut<'o, 's, 'a, T> {
    fn new(swept: &'s Swept<'a>, made: Made<'o, T>, each: &'o mut dyn FnMut(T) -> ControlFlow<()>) -> Self {
        let end = SweepEnd { rows: 0, unanswered: 0, first_error: None, diagnostics: Vec::new() };
        let came = Came { end, tally: Tally::default(), skipped: None };
        Self { context: swept, convert: made, each, result: came, unreached: 0 }
    }

    /// Last row, if too many consecutive rows were not reached; the following rows are then not tried.
    fn abandoned_after(&self) -> Option<usize> {
        (self.unreached >= UNRELATED).then(|| self.result.end.rows.saturating_sub(1))
    }

    fn output_results(&mut self, portions: Vec<Portion<T>>) -> Result<ControlFlow<()>, StudyError> {
        for mut portion in portions {
            self.result.tally.append(portion.drain_findings());
            if let Some(untried) = portion.skipped {
                let so_far = self.result.skipped.get_or_insert(Untried { count: 0, ..untried });
                so_far.count += untried.count;
            }
            for outcome in portion.rows {
                if self.output_row(outcome)?.is_break() {
                    return Ok(ControlFlow::Break(()));
                }
            }
        }
        Ok(ControlFlow::Continue(()))
    }

    fn output_row(&mut self, outcome: Outcome<T>) -> Result<ControlFlow<()>, StudyError> {
        let end = &mut self.result.end;
        let (made, reached, error) = match outcome {
            Outcome::Row { made, reached, error } => (made, reached, error),
            // An input error before the first result is an error of the question; a later error belongs to the
            // row.
            Outcome::Failed { error, .. } if end.rows == end.unanswered && !error.is_no_answer() => {
                return Err(error);
            }
            Outcome::Failed { row, varied, error } => self.failed_row(row, varied, &error),
        };
        let end = &mut self.result.end;
        end.rows += 1;
        self.unreached = if reached { 0 } else { self.unreached + 1 };
        if let Some(error) = error {
            end.unanswered += 1;
            end.first_error.get_or_insert(error);
        }
        Ok((self.each)(made))
    }

    fn failed_row(&self, row: usize, varied: VariedValues, error: &StudyError) -> (T, bool, Option<String>) {
        let why = error.message(self.context.prepared.question.names);
        let row = self.context.unanswered(row, varied, NO_ANSWER, why.clone());
        ((self.convert)(row), true, Some(why))
    }
}
