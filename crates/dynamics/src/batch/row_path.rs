//! Rows of a path on one branch: several rows at once while the branch is certain, otherwise one pose per row.

use crate::analysis::pose::Pose;
use crate::batch::driven_path::{DrivenPath, PathAnswer};
use crate::tolerances::{LEAST_FOLLOWED_ROWS, MOST_PATH_STARTS};
use std::sync::Arc;

/// Result of one row of a [`RowPath`]. `S`: data of the [`DrivenPath`]; `E`: reason of a row without a pose.
#[derive(Debug)]
pub enum RowAnswer<'a, S, E> {
    /// Row with a result for m̄, without a pose.
    Followed {
        /// Data of the path.
        shared: &'a S,
        /// m̄ and its error, kg.
        mass: (f64, f64),
        /// Residual of the loops and findings.
        answer: &'a PathAnswer,
        /// Positions of all joints.
        positions: &'a [f64],
    },
    /// Pose of the row; m̄ is not evaluated.
    Posed(Arc<Pose>),
    /// Row without a pose.
    Unreached(E),
}

/// Caller of a [`RowPath`]: supplies the poses of single rows and receives the results.
pub trait RowHandler {
    /// Data of a [`DrivenPath`] that all its rows share.
    type Shared;
    /// Reason of a row without a pose.
    type Error;

    /// Pose of a row that cannot be followed, from the pose of the last row reached. `row`: number in the call.
    ///
    /// # Errors
    /// The reason of a row without a pose.
    fn pose(&mut self, row: usize, values: &[f64], last: Option<&Pose>) -> Result<Arc<Pose>, Self::Error>;

    /// Path for the rows after a pose, with its data; `None` if each row requires a pose.
    fn driven_path(&mut self, pose: &Pose) -> Option<(DrivenPath, Self::Shared)>;

    /// Receives the result of a row. Rows are in order.
    fn receive(&mut self, row: usize, values: &[f64], answer: RowAnswer<'_, Self::Shared, Self::Error>);
}

/// Consecutive rows of the drivers on one branch.
///
/// Each row starts from the last row reached. A [`DrivenPath`] follows several rows at once until a row is in doubt. This
/// row is posed alone, and the path restarts from its pose. After an unreached row, the next row is posed alone too.
#[derive(Debug)]
pub struct RowPath<S> {
    /// Pose of the last row reached.
    last: Option<Arc<Pose>>,
    driven: Option<(DrivenPath, S)>,
    /// Number of paths built.
    starts: usize,
    answers: Vec<PathAnswer>,
    positions: Vec<f64>,
}

impl<S> RowPath<S> {
    /// Path whose first row starts from a pose, if given.
    pub fn new(start: Option<Arc<Pose>>) -> Self {
        Self { last: start, driven: None, starts: 0, answers: Vec::new(), positions: Vec::new() }
    }

    /// Follows `count` rows, each with one number per joint of the path. Another call continues from the last row reached.
    pub fn follow<H: RowHandler<Shared = S>>(&mut self, rows: &[f64], count: usize, handler: &mut H) {
        let width = rows.len() / count.max(1);
        let values = |row: usize| &rows[row * width..(row + 1) * width];
        let mut next = 0;
        while next < count {
            next += self.follow_several(&rows[next * width..], |row, answer| {
                handler.receive(next + row, values(next + row), answer);
            });
            if next == count {
                break;
            }
            let answer = match handler.pose(next, values(next), self.last.as_deref()) {
                Ok(pose) => {
                    self.start_path(&pose, count - next - 1, handler);
                    self.last = Some(Arc::clone(&pose));
                    RowAnswer::Posed(pose)
                }
                Err(error) => {
                    self.driven = None;
                    RowAnswer::Unreached(error)
                }
            };
            handler.receive(next, values(next), answer);
            next += 1;
        }
    }

    /// Follows rows until a row is in doubt. Returns the number of completed rows.
    fn follow_several<E>(&mut self, rows: &[f64], mut each: impl FnMut(usize, RowAnswer<'_, S, E>)) -> usize {
        let Self { last, driven: Some((path, shared)), answers, positions, .. } = self else { return 0 };
        answers.clear();
        positions.clear();
        let reached = path.follow(rows, answers, positions);
        let width = positions.len() / reached.max(1);
        for (row, answer) in answers.iter().enumerate() {
            let positions = &positions[row * width..(row + 1) * width];
            let result = match answer.mass {
                Some(mass) => RowAnswer::Followed { shared: &*shared, mass, answer, positions },
                None => RowAnswer::Posed(Arc::new(path.pose_from_positions(positions, answer.residual))),
            };
            each(row, result);
        }
        if reached > 0 {
            *last = Some(Arc::new(path.pose()));
        }
        reached
    }

    /// Restarts the path from a pose, or builds a new path if enough rows are `left` and few paths were built.
    fn start_path<H: RowHandler<Shared = S>>(&mut self, pose: &Pose, left: usize, handler: &mut H) {
        if self.driven.as_mut().is_some_and(|(path, _)| path.restart(pose)) {
            return;
        }
        self.driven = None;
        if left >= LEAST_FOLLOWED_ROWS && self.starts < MOST_PATH_STARTS {
            self.starts += 1;
            self.driven = handler.driven_path(pose);
        }
    }
}
