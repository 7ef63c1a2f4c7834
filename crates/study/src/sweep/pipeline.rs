//! Pipeline of the rows of a sweep: rows are posed, evaluated and handed out in order, one block at a time.
//!
//! While the calling thread hands out one block, the threads of rayon's pool evaluate the next block and pose
//! the block after that. Whole lines are independent and are distributed over the threads. Block boundaries
//! depend on row numbers only, and limits are exchanged between blocks at fixed points, so results do not
//! depend on the number of threads.

use crate::checks::finding::FindingTally;
use crate::pose::driver::Driver;
use crate::pose::point_travel::PointTravel;
use crate::pose::unreachable_range::SkippedRows;
use crate::question::errors::question_error::StudyError;
use crate::sweep::continuation::{LineContinuation, StepLimit, min_limit};
use crate::sweep::row_blocks::{RowBlock, RowReader};
use crate::sweep::sweep_context::{PortionResults, RowConversion, RowOutcome, RowPose, SweepContext};
use crate::sweep::sweep_report::SweepEnd;
use crate::thresholds::{
    BATCH_BLOCK_ROWS, BATCH_ROWS_PER_TASK, FIRST_BLOCK, MOST_UNREACHED_ROWS, POSED_BLOCK_LINKS,
    POSED_BLOCK_ROWS, POSED_ROWS_PER_TASK,
};
use rayon::prelude::*;
use std::ops::{ControlFlow, Range};
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
    let mut out = OutputStage::new(each);
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
                    || {
                        let PosedBlock { block, portions } = to_answer?;
                        let evaluate = |portion| evaluate_portion(context, &block, portion, convert, too_far);
                        Some(portions.into_par_iter().map(evaluate).collect::<Vec<_>>())
                    },
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
        let found = evaluated.iter().flatten().map(|portion: &PortionResults<T>| portion.step_limit);
        posing.step_limit = found.fold(posing.step_limit, min_limit);
        if posed.is_none() && evaluated.is_none() {
            break;
        }
    }
    Ok(out.result)
}

/// Block of rows in portions.
struct PosedBlock {
    block: RowBlock,
    portions: Vec<Portion>,
}

/// Rows of a block that one thread evaluates.
struct Portion {
    rows: Range<usize>,
    work: PortionWork,
}

enum PortionWork {
    /// A line; it is posed and evaluated separately.
    Line,
    /// Posed rows of a line.
    Posed {
        row_poses: Vec<RowPose>,
        travel: Option<Arc<(PointTravel, Driver)>>,
        skipped: Option<SkippedRows>,
    },
    /// Rows of a tree, for the SIMD evaluation without poses.
    Tree,
    /// Rows that are not tried because of row `found_by`.
    Skipped { found_by: usize },
}

/// Portions of a block of `count` rows.
fn split(count: usize, rows: usize, mut work: impl FnMut() -> PortionWork) -> Vec<Portion> {
    let ranges = (0..count).step_by(rows.max(1)).map(|first| first..(first + rows).min(count));
    ranges.map(|rows| Portion { rows, work: work() }).collect()
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
        let largest = match &context.tree_rows {
            Some(_) => {
                (POSED_BLOCK_LINKS * BATCH_ROWS_PER_TASK / links.max(1)).clamp(FIRST_BLOCK, BATCH_BLOCK_ROWS)
            }
            None => (POSED_BLOCK_LINKS / links.max(1)).clamp(FIRST_BLOCK, POSED_BLOCK_ROWS),
        };
        let line = context.new_line(None);
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
        let is_tree = self.context.tree_rows.is_some();
        let line = if is_tree { None } else { self.rows.rows_per_line() };
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
        let portions = match (self.abandoned_after, whole) {
            (Some(found_by), _) => split(block.count, block.count, || PortionWork::Skipped { found_by }),
            (None, Some(rows)) => split(block.count, rows, || PortionWork::Line),
            (None, None) if is_tree => split(block.count, BATCH_ROWS_PER_TASK, || PortionWork::Tree),
            (None, None) => {
                if starts_line {
                    self.step_limit = min_limit(self.step_limit, self.line.step_limit);
                    self.line = self.context.new_line(self.step_limit);
                }
                self.pose(&block)
            }
        };
        Ok(Some(PosedBlock { block, portions }))
    }

    /// Poses the rows of a block, each from the last row reached.
    fn pose(&mut self, block: &RowBlock) -> Vec<Portion> {
        let line = &mut self.line;
        let mut row_poses = self.context.next_poses(line, block, 0..block.count).into_iter();
        split(block.count, POSED_ROWS_PER_TASK, || PortionWork::Posed {
            row_poses: row_poses.by_ref().take(POSED_ROWS_PER_TASK).collect(),
            travel: line.travel(),
            skipped: line.unreachable.drain_skipped(),
        })
    }
}

/// Second stage: evaluates rows.
fn evaluate_portion<T>(
    context: &SweepContext<'_>,
    block: &RowBlock,
    Portion { rows, work }: Portion,
    convert: RowConversion<'_, T>,
    too_far: StepLimit,
) -> PortionResults<T> {
    let mut results = PortionResults::new(rows.len());
    let mut line = context.new_line(too_far);
    let mut evaluate = |travel: Option<&PointTravel>, row_poses: &mut dyn Iterator<Item = RowPose>| {
        for (i, row_pose) in rows.clone().zip(row_poses) {
            context.evaluate_row(&mut results, block, i, row_pose, travel, convert);
        }
    };
    let skipped = match work {
        PortionWork::Line => {
            let row_poses = context.next_poses(&mut line, block, rows.clone());
            evaluate(line.travel().as_ref().map(|t| &t.0), &mut row_poses.into_iter());
            line.unreachable.drain_skipped()
        }
        PortionWork::Posed { row_poses, travel, skipped } => {
            evaluate(travel.as_ref().map(|t| &t.0), &mut row_poses.into_iter());
            skipped
        }
        PortionWork::Tree => {
            let tree = context.tree_rows.iter();
            evaluate(None, &mut tree.flat_map(|tree| context.rows_of_tree(tree, block, rows.clone())));
            None
        }
        PortionWork::Skipped { found_by } => {
            let mut skip = |i| RowPose::Unreached(Ok(line.unreachable.skip(block.first + i, found_by)));
            evaluate(None, &mut rows.clone().map(&mut skip));
            line.unreachable.drain_skipped()
        }
    };
    (results.skipped, results.step_limit) = (skipped, line.step_limit);
    results
}

/// Third stage: hands out the rows in order.
struct OutputStage<'o, T> {
    each: &'o mut dyn FnMut(T) -> ControlFlow<()>,
    result: PipelineResult,
    /// Number of consecutive rows that were not reached.
    unreached: usize,
}

impl<'o, T> OutputStage<'o, T> {
    fn new(each: &'o mut dyn FnMut(T) -> ControlFlow<()>) -> Self {
        let end = SweepEnd { rows: 0, rows_without_result: 0, first_error: None, diagnostics: Vec::new() };
        let result = PipelineResult { end, tally: FindingTally::default(), skipped: None };
        Self { each, result, unreached: 0 }
    }

    /// Last row, if too many consecutive rows were not reached; the following rows are then not tried.
    fn abandoned_after(&self) -> Option<usize> {
        (self.unreached >= MOST_UNREACHED_ROWS).then(|| self.result.end.rows.saturating_sub(1))
    }

    /// Passes the rows of a block on in order, and merges their findings.
    fn output_results(&mut self, portions: Vec<PortionResults<T>>) -> Result<ControlFlow<()>, StudyError> {
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
        // An input error before the first result is an error of the question; a later error belongs to the row.
        if let Some(refusal) = outcome.refusal.filter(|_| end.rows == end.rows_without_result) {
            return Err(refusal);
        }
        end.rows += 1;
        self.unreached = if outcome.reached { 0 } else { self.unreached + 1 };
        if let Some(error) = outcome.error {
            end.rows_without_result += 1;
            end.first_error.get_or_insert(error);
        }
        Ok((self.each)(outcome.converted))
    }
}
