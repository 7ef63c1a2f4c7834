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

/// Runs portions of configurations; checks for Ctrl-C after each. `is_path`: rows of a path, with portions of [`PATH_PORTION`];
/// otherwise the sizes are adapted to [`PORTION_DURATION`].
pub fn run_portions(
    py: Python<'_>,
    count: usize,
    is_path: bool,
    (threads, progress): (Threads, &Progress<'_>),
    mut portion: impl FnMut(Range<usize>) -> PyResult<()> + Send,
) -> PyResult<()> {
    let (mut first, mut size) = (0, if is_path { PATH_PORTION } else { FIRST_PORTION });
    while first < count {
        let rows = first..count.min(first + size);
        let (done, end) = (rows.len(), rows.end);
        let start = Instant::now();
        // Few rows have no second thread: a sweep of one row would take twice as long.
        match count <= FEW && !is_path {
            true => detached(py, threads, || portion(rows))??,
            false => interruptible_on(py, threads, || portion(rows))??,
        }
        py.check_signals()?;
        first = end;
        progress.report(first, count)?;
        if !is_path {
            let duration = start.elapsed().as_secs_f64().max(1e-9);
            let factor = (PORTION_DURATION.as_secs_f64() / duration).clamp(1.0 / GROWTH, GROWTH);
            size = ((done as f64 * factor) as usize).clamp(16, LARGEST_PORTION);
        }
    }
    Ok(())
}
