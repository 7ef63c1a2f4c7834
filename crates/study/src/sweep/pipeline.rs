//! Pipeline of the rows of a sweep: rows are posed, evaluated and handed out in order, one block at a time.
//!
//! While the calling thread hands out one block, the threads of rayon's pool evaluate the next block and pose
//! the block after that. Whole lines are independent and are distributed over the threads. Block boundaries
//! depend on row numbers only, and limits are exchanged between blocks at fixed points, so results do not
//! depend on the number of threads.

use crate::checks::finding::FindingTally;
use crate::pose::driver::Driver;
use crate::pose::point_travel::PointTravel;
use crate::pose::unreachable_range::{SkippedRows, UnreachableRange};
use crate::question::errors::question_error::StudyError;
use crate::question::travel::varied_values::VariedValues;
use crate::sweep::continuation::{LineContinuation, StepLimit, min_limit};
use crate::sweep::row_blocks::{RowBlock, RowReader};
use crate::sweep::sweep_context::{
    NO_RESULT_STATUS, RowConversion, RowOutcome, RowPose, RowResults, SweepContext,
};
use crate::sweep::sweep_report::SweepEnd;
use crate::thresholds::{
    BATCH_BLOCK_ROWS, BATCH_ROWS_PER_TASK, FIRST_BLOCK, MOST_UNREACHED_ROWS, POSED_BLOCK_LINKS,
    POSED_BLOCK_ROWS, POSED_ROWS_PER_TASK,
};
use rayon::prelude::*;
use std::ops::ControlFlow;
use std::sync::Arc;

/// Result of a sweep.
#[derive(Debug)]
pub(crate) struct PipelineResult {
    pub end: SweepEnd,
    pub tally: FindingTally,
    pub skipped: Option<SkippedRows>,
}

/// Runs all rows through the pipeline.
pub(crate) fn run<T: Send>(
    context: &SweepContext<'_>,
    rows: RowReader,
    convert: RowConversion<'_, T>,
    each: &mut dyn FnMut(T) -> ControlFlow<()>,
) -> Result<PipelineResult, StudyError> {
    let mut posing = PosingStage::new(context, rows);
    let mut out = OutputStage::new(context, convert, each);
    let (mut posed, mut evaluated) = (None, None);
    loop {
        let (to_answer, to_hand_out) = (posed.take(), evaluated.take());
        let too_far = posing.step_limit;
        let (mut next_posed, mut next_answered) = (Ok(None), None);
        let mut stopped = Ok(ControlFlow::Continue(()));
        rayon::in_place_scope(|scope| {
            scope.spawn(|_| {
                (next_posed, next_answered) = rayon::join(
                    || posing.next(),
                    || to_answer.map(|posed| evaluate_block(context, posed, convert, too_far)),
                );
            });
            if let Some(portions) = to_hand_out {
                stopped = out.output_results(portions);
            }
        });
        if stopped?.is_break() {
            break;
        }
        (posed, evaluated) = (next_posed?, next_answered);
        posing.abandoned_after = out.abandoned_after();
        let found = evaluated.iter().flatten().map(|portion: &RowResults<T>| portion.step_limit);
        posing.step_limit = found.fold(posing.step_limit, min_limit);
        if posed.is_none() && evaluated.is_none() {
            break;
        }
    }
    Ok(out.result)
}

/// Block and the remaining work.
struct PosedBlock {
    block: RowBlock,
    work: BlockWork,
}

enum BlockWork {
    /// Lines of this number of rows; each line is posed and evaluated separately.
    Lines(usize),
    /// Portions of posed rows of one line.
    Portions {
        portions: Vec<(usize, Vec<RowPose>)>,
        travel: Option<Arc<(PointTravel, Driver)>>,
        untried: Option<SkippedRows>,
    },
    /// Rows for the SIMD evaluation without poses.
    Batches,
    /// Rows that are not tried because of row `found_by`.
    Skipped { found_by: usize },
}

/// First stage: forms blocks and poses consecutive rows.
struct PosingStage<'s, 'a> {
    context: &'s SweepContext<'a>,
    rows: RowReader,
    line: LineContinuation,
    /// Number of the next row.
    row: usize,
    /// Approximate number of rows of the next block.
    size: usize,
    max_block_size: usize,
    step_limit: StepLimit,
    abandoned_after: Option<usize>,
}

impl<'s, 'a> PosingStage<'s, 'a> {
    fn new(context: &'s SweepContext<'a>, rows: RowReader) -> Self {
        let links = context.prepared.system.mechanism().links().len();
        let largest = match &context.batch_evaluator {
            Some(_) => {
                (POSED_BLOCK_LINKS * BATCH_ROWS_PER_TASK / links.max(1)).clamp(FIRST_BLOCK, BATCH_BLOCK_ROWS)
            }
            None => (POSED_BLOCK_LINKS / links.max(1)).clamp(FIRST_BLOCK, POSED_BLOCK_ROWS),
        };
        let line = LineContinuation::new(rows.distance_measure(), context.travel.clone(), None);
        Self {
            context,
            rows,
            line,
            row: 0,
            size: FIRST_BLOCK,
            max_block_size: largest,
            step_limit: None,
            abandoned_after: None,
        }
    }

    /// Next block; `None` at the end.
    fn next(&mut self) -> Result<Option<PosedBlock>, StudyError> {
        // Without poses, rows are independent.
        let line = if self.context.batch_evaluator.is_some() { None } else { self.rows.rows_per_line() };
        let whole = line.filter(|rows| *rows <= self.max_block_size);
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
        self.size = (2 * self.size).min(self.max_block_size);
        let work = match (self.abandoned_after, whole) {
            (Some(found_by), _) => BlockWork::Skipped { found_by },
            (None, Some(rows)) => BlockWork::Lines(rows),
            (None, None) if self.context.batch_evaluator.is_some() => BlockWork::Batches,
            (None, None) => {
                if starts_line {
                    self.step_limit = min_limit(self.step_limit, self.line.step_limit);
                    self.line = LineContinuation::new(
                        self.rows.distance_measure(),
                        self.context.travel.clone(),
                        self.step_limit,
                    );
                }
                self.pose(&block)
            }
        };
        Ok(Some(PosedBlock { block, work }))
    }

    /// Poses the rows of a block, each from the last row reached.
    fn pose(&mut self, block: &RowBlock) -> BlockWork {
        let (context, line) = (self.context, &mut self.line);
        let mut portions = Vec::with_capacity(block.count.div_ceil(POSED_ROWS_PER_TASK));
        let mut row_poses = context.next_poses(line, block, 0..block.count).into_iter();
        for first in (0..block.count).step_by(POSED_ROWS_PER_TASK) {
            portions.push((first, row_poses.by_ref().take(POSED_ROWS_PER_TASK).collect()));
        }
        BlockWork::Portions { portions, travel: line.travel(), untried: line.unreachable.drain_skipped() }
    }
}

/// Second stage: evaluates the rows in parallel.
fn evaluate_block<T: Send>(
    context: &SweepContext<'_>,
    posed: PosedBlock,
    convert: RowConversion<'_, T>,
    too_far: StepLimit,
) -> Vec<RowResults<T>> {
    let PosedBlock { block, work } = posed;
    let block = &block;
    match work {
        BlockWork::Lines(rows) => {
            let of_line = |first: usize| {
                let mut line =
                    LineContinuation::new(context.distance_measure, context.travel.clone(), too_far);
                let mut portion = RowResults::new(rows);
                let row_poses = context.next_poses(&mut line, block, first..first + rows);
                let travel = line.travel();
                let travel = travel.as_ref().map(|t| &t.0);
                context.evaluate_rows(&mut portion, block, (first..).zip(row_poses), travel, convert);
                (portion.skipped, portion.step_limit) = (line.unreachable.drain_skipped(), line.step_limit);
                portion
            };
            let lines: Vec<usize> = (0..block.count).step_by(rows).collect();
            lines.into_par_iter().map(of_line).collect()
        }
        BlockWork::Portions { portions, travel, untried } => {
            let of_portion = |(first, row_poses): (usize, Vec<RowPose>)| {
                let mut portion = RowResults::new(row_poses.len());
                let travel = travel.as_ref().map(|t| &t.0);
                context.evaluate_rows(&mut portion, block, (first..).zip(row_poses), travel, convert);
                portion
            };
            let mut portions: Vec<RowResults<T>> = portions.into_par_iter().map(of_portion).collect();
            if let Some(first) = portions.first_mut() {
                first.skipped = untried;
            }
            portions
        }
        BlockWork::Batches => {
            let starts: Vec<usize> = (0..block.count).step_by(BATCH_ROWS_PER_TASK).collect();
            let rows = |first: usize| first..(first + BATCH_ROWS_PER_TASK).min(block.count);
            starts.into_par_iter().map(|first| context.evaluate_batch(block, rows(first), convert)).collect()
        }
        BlockWork::Skipped { found_by } => {
            let mut portion = RowResults::new(block.count);
            let mut reach = UnreachableRange::default();
            for i in 0..block.count {
                let row_pose = RowPose::Unreached(reach.skip(block.first + i, found_by));
                context.evaluate_row(&mut portion, block, i, row_pose, None, convert);
            }
            portion.skipped = reach.drain_skipped();
            vec![portion]
        }
    }
}

/// Third stage: hands out the rows in order.
struct OutputStage<'o, 's, 'a, T> {
    context: &'s SweepContext<'a>,
    convert: RowConversion<'o, T>,
    each: &'o mut dyn FnMut(T) -> ControlFlow<()>,
    result: PipelineResult,
    /// Number of consecutive rows that were not reached.
    unreached: usize,
}

impl<'o, 's, 'a, T> OutputStage<'o, 's, 'a, T> {
    fn new(
        context: &'s SweepContext<'a>,
        convert: RowConversion<'o, T>,
        each: &'o mut dyn FnMut(T) -> ControlFlow<()>,
    ) -> Self {
        let end = SweepEnd { rows: 0, rows_without_result: 0, first_error: None, diagnostics: Vec::new() };
        let result = PipelineResult { end, tally: FindingTally::default(), skipped: None };
        Self { context, convert, each, result, unreached: 0 }
    }

    /// Last row, if too many consecutive rows were not reached; the following rows are then not tried.
    fn abandoned_after(&self) -> Option<usize> {
        (self.unreached >= MOST_UNREACHED_ROWS).then(|| self.result.end.rows.saturating_sub(1))
    }

    /// Passes the rows of a block on in order, and merges their findings.
    fn output_results(&mut self, portions: Vec<RowResults<T>>) -> Result<ControlFlow<()>, StudyError> {
        for mut portion in portions {
            self.result.tally.append(portion.drain_findings());
            if let Some(untried) = portion.skipped {
                let so_far = self.result.skipped.get_or_insert(SkippedRows { count: 0, ..untried });
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

    /// Passes one row on and counts it.
    fn output_row(&mut self, outcome: RowOutcome<T>) -> Result<ControlFlow<()>, StudyError> {
        let end = &mut self.result.end;
        let (converted, reached, error) = match outcome {
            RowOutcome::Row { converted, reached, error } => (converted, reached, error),
            // An input error before the first result is an error of the question; a later error belongs to the
            // row.
            RowOutcome::Failed { error, .. }
                if end.rows == end.rows_without_result && !error.has_no_result() =>
            {
                return Err(error);
            }
            RowOutcome::Failed { row, varied, error } => self.failed_row(row, varied, &error),
        };
        let end = &mut self.result.end;
        end.rows += 1;
        self.unreached = if reached { 0 } else { self.unreached + 1 };
        if let Some(error) = error {
            end.rows_without_result += 1;
            end.first_error.get_or_insert(error);
        }
        Ok((self.each)(converted))
    }

    /// Row without a result because of an error.
    fn failed_row(&self, row: usize, varied: VariedValues, error: &StudyError) -> (T, bool, Option<String>) {
        let why = error.message(self.context.prepared.question.names);
        let row = self.context.row_without_result(row, varied, NO_RESULT_STATUS, why.clone());
        ((self.convert)(row), true, Some(why))
    }
}
