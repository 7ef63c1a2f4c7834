//! Rows of the drivers of a linkage, followed along one branch.

use crate::conversion::errors::input;
use crate::sweep::portions::run_portions;
use crate::sweep::rows::{RowQuestion, refused_rows};
use numpy::ndarray::s;
use numpy::{PyReadonlyArray2, PyUntypedArrayMethods};
use percuss::{
    Batch, BatchAnswer, BatchContacts, BatchPositions, BatchRows, Configuration, Contact as Resolved,
    DrivenPath, JointId, Pose as Posed, RemarkFlags, RowAnswer, RowColumns, RowHandler, RowPath,
};
use pyo3::prelude::*;
use std::ops::Range;
use std::sync::Arc;

/// Rows of the drivers of a linkage, with the columns of their results.
pub struct PathColumns<'a> {
    /// Pose at which the path starts; its positions stand for those of rows without a pose, whose results are discarded.
    pub start: Arc<Posed>,
    pub zero: Configuration,
    pub contact: Resolved,
    pub joints: Vec<JointId>,
    /// True if rows on another assembly mode are solved.
    pub other_assembly: bool,
    /// True if a number that is not finite is an error; otherwise its row has no answer.
    pub finite_only: bool,
    pub columns: RowColumns<'a, u8>,
    /// Number of the first row of the portion.
    pub first: usize,
    /// Reason for the first missing answer.
    pub no_answer: Option<String>,
    /// Positions of all joints of the rows of the portion, row by row.
    pub positions: Vec<f64>,
    /// Rows of the portion without a pose.
    pub unreached: Vec<usize>,
}

/// Findings about a pose. They do not depend on the contact.
const POSE_FINDINGS: u32 = RemarkFlags::SINGULAR_POSE.bits()
    | RemarkFlags::OTHER_ASSEMBLY.bits()
    | RemarkFlags::DRAWN_OPEN.bits()
    | RemarkFlags::INEXACT_LOOPS.bits()
    | RemarkFlags::DRIVER_OFF_ZERO.bits()
    | RemarkFlags::OFF_TARGET.bits()
    | RemarkFlags::OUTSIDE_LIMITS.bits()
    | RemarkFlags::WEAKLY_CONSTRAINED.bits()
    | RemarkFlags::UNCLEAR_MOBILITY.bits();

/// Number of rows that a thread solves at once.
const PATH_BLOCK: usize = 64;

impl PathColumns<'_> {
    /// Solves all rows; returns the reason of the first row without an answer.
    pub fn solve(
        mut self,
        py: Python<'_>,
        q: &PyReadonlyArray2<'_, f64>,
        question: RowQuestion<'_>,
        contacts: Option<BatchContacts<'_>>,
    ) -> PyResult<Option<String>> {
        let mut path = RowPath::new(Some(Arc::clone(&self.start)));
        let is_followed_only =
            contacts.is_none() && self.columns.gradients.is_none() && self.columns.inverse_inertias.is_none();
        let RowQuestion { batch, threads, progress } = question;
        let (view, width) = (q.as_array(), q.shape()[1]);
        let mut values = Vec::new();
        // Row before a row with numbers that are not finite: the path waits there.
        let (mut before, mut not_finite) = (vec![0.0; width], Vec::new());
        run_portions(py, view.nrows(), true, (threads, progress), |rows| {
            values.clear();
            view.slice(s![rows.clone(), ..]).rows().into_iter().for_each(|row| values.extend(row));
            let checked =
                BatchPositions::Rows { values: &values, stride: width }.refuse_not_finite(width, rows.len());
            if self.finite_only {
                checked.map_err(|error| refused_rows(error.in_rows_from(rows.start)))?;
            } else if checked.is_err() {
                for (row, own) in rows.clone().zip(values.chunks_mut(width.max(1))) {
                    if own.iter().all(|x| x.is_finite()) {
                        before.copy_from_slice(own);
                    } else {
                        own.copy_from_slice(&before);
                        not_finite.push(row);
                    }
                }
            } else if let Some(last) = values.rchunks(width.max(1)).next() {
                before.copy_from_slice(last);
            }
            self.first = rows.start;
            self.positions.clear();
            self.unreached.clear();
            path.follow(&values, rows.len(), &mut self);
            match is_followed_only {
                true => Ok(()),
                false => self.solve_at_positions(batch, contacts.map(|all| all.part(&rows)), rows),
            }
        })?;
        for row in not_finite {
            self.columns.part(row..row + 1).clear();
            self.columns
                .set(row, &BatchAnswer { remarks: RemarkFlags::NOT_FINITE, ..BatchAnswer::UNREACHED });
        }
        Ok(self.no_answer)
    }

    /// Solves the rows of a portion at the positions that the path reached: with a contact for each row, gradients or inverse inertias.
    fn solve_at_positions(
        &mut self,
        batch: &Batch,
        contacts: Option<BatchContacts<'_>>,
        rows: Range<usize>,
    ) -> PyResult<()> {
        let mut columns = self.columns.part(rows.clone());
        let of_poses: Vec<u32> =
            columns.remarks.iter().flat_map(|bits| bits.iter()).map(|bits| bits & POSE_FINDINGS).collect();
        let stride = self.start.positions().len();
        let positions = BatchPositions::Rows { values: &self.positions, stride };
        let all = 0..rows.len();
        batch
            .run(BatchRows { contacts, ..positions.into() }, columns.part(all), PATH_BLOCK)
            .map_err(input)?;
        for (bits, of_pose) in columns.remarks.iter_mut().flat_map(|bits| bits.iter_mut()).zip(of_poses) {
            *bits |= of_pose;
        }
        for row in self.unreached.drain(..).map(|row| row - rows.start) {
            columns.part(row..row + 1).clear();
            columns.set(row, &BatchAnswer::UNREACHED);
        }
        Ok(())
    }
}

impl RowHandler for PathColumns<'_> {
    type Shared = ();
    type Error = String;

    fn pose(&mut self, _: usize, row: &[f64], last: Option<&Posed>) -> Result<Arc<Posed>, String> {
        let assembly = self.start.assembly();
        let mut configuration = self.zero.clone();
        if self.other_assembly {
            configuration.allow_other_assembly();
        }
        for (joint, value) in self.joints.iter().zip(row) {
            configuration
                .set(self.start.mechanism().joint(*joint).name(), &[*value])
                .map_err(|error| error.to_string())?;
        }
        let pose = match last {
            Some(last) => assembly.pose_from(last, &configuration),
            None => assembly.pose(&configuration),
        };
        pose.map(Arc::new).map_err(|error| error.to_string())
    }

    fn driven_path(&mut self, pose: &Posed) -> Option<(DrivenPath, ())> {
        pose.driven_path(&self.contact, &self.joints).ok().flatten().map(|path| (path, ()))
    }

    fn receive(&mut self, row: usize, _: &[f64], answer: RowAnswer<'_, (), String>) {
        let at = self.first + row;
        let answer = match answer {
            RowAnswer::Followed { mass: (mass, error), answer, positions, .. } => {
                self.positions.extend_from_slice(positions);
                Ok(BatchAnswer::finite(mass, error, answer.remarks))
            }
            RowAnswer::Posed(pose) => {
                self.positions.extend_from_slice(pose.positions());
                let response = pose.respond(&self.contact);
                response.map(|response| BatchAnswer::from(&response)).map_err(|error| error.to_string())
            }
            RowAnswer::Unreached(reason) => {
                self.positions.extend_from_slice(self.start.positions());
                self.unreached.push(at);
                Err(reason)
            }
        };
        let answer = answer.unwrap_or_else(|reason| {
            self.no_answer.get_or_insert(reason);
            BatchAnswer::UNREACHED
        });
        self.columns.set(at, &answer);
    }
}
