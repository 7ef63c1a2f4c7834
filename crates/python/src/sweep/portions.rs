//! Portions of rows, with a check for Ctrl-C after each.

use crate::conversion::errors;
use crate::conversion::threads::{Threads, detached, interruptible_on};
use pyo3::prelude::*;
use std::ops::Range;
use std::time::{Duration, Instant};

/// Number of path rows between two checks for Ctrl-C. Fixed, because other portions change the last digits of a
/// followed path. A single row takes up to some milliseconds.
const PATH_PORTION: usize = 512;
/// Portion sizes in configurations: limit of the first portion, limit of all portions, and growth factor. Ctrl-C is
/// checked between portions and within them. Rows that are solved independently do not depend on the portions.
const FIRST_PORTION: usize = 1024;
const LARGEST_PORTION: usize = 1 << 22;
const GROWTH: f64 = 8.0;
/// Number of rows that take at most some milliseconds each by the slowest route, together less than 0.1 s.
const FEW: usize = 16;
/// Target duration of a portion.
const PORTION_DURATION: Duration = Duration::from_millis(50);

/// Function of the caller that receives the number of finished rows and of all rows.
pub struct Progress<'a>(Option<&'a Bound<'a, PyAny>>);

impl<'a> Progress<'a> {
    /// Checks that the object can be called.
    pub fn of(given: Option<&'a Bound<'a, PyAny>>) -> PyResult<Self> {
        match given {
            Some(given) if !given.is_callable() => Err(errors::argument_type(format_args!(
                "progress is {}; expected a function of two numbers, the finished rows and all rows",
                given.repr()?
            ))),
            _ => Ok(Self(given)),
        }
    }

    /// Reports finished rows; an exception of the function stops the sweep.
    fn report(&self, done: usize, count: usize) -> PyResult<()> {
        self.0.map_or(Ok(()), |function| function.call1((done, count)).map(|_| ()))
    }
}

/// Runs portions of configurations, with sizes adapted to [`PORTION_DURATION`]; checks for Ctrl-C after each.
pub fn run_timed_portions(
    py: Python<'_>,
    count: usize,
    (threads, progress): (Threads, &Progress<'_>),
    mut portion: impl FnMut(Range<usize>) -> PyResult<()> + Send,
) -> PyResult<()> {
    let (mut first, mut size) = (0, FIRST_PORTION);
    while first < count {
        let count_of_portion = size.min(count - first);
        let start = Instant::now();
        let rows = first..first + count_of_portion;
        // Few rows have no second thread: a sweep of one row would take twice as long.
        match count <= FEW {
            true => detached(py, threads, || portion(rows))??,
            false => interruptible_on(py, threads, || portion(rows))??,
        }
        py.check_signals()?;
        first += count_of_portion;
        progress.report(first, count)?;
        let duration = start.elapsed().as_secs_f64().max(1e-9);
        let factor = (PORTION_DURATION.as_secs_f64() / duration).clamp(1.0 / GROWTH, GROWTH);
        size = ((count_of_portion as f64 * factor) as usize).clamp(16, LARGEST_PORTION);
    }
    Ok(())
}

/// Runs portions of a path, of [`PATH_PORTION`] rows; checks for Ctrl-C after each.
pub fn run_fixed_portions(
    py: Python<'_>,
    count: usize,
    (threads, progress): (Threads, &Progress<'_>),
    mut portion: impl FnMut(Range<usize>) -> PyResult<()> + Send,
) -> PyResult<()> {
    for first in (0..count).step_by(PATH_PORTION) {
        let end = count.min(first + PATH_PORTION);
        interruptible_on(py, threads, || portion(first..end))??;
        py.check_signals()?;
        progress.report(end, count)?;
    }
    Ok(())
}
