//! m̄ at the maximum penetration of an impact. The mechanism follows the motion of impact v* from first touch
//! to this depth.
//!
//! ```text
//! dq/dδ = v*(q),  A v* = 0,  j v* = 1,  from δ = 0 at first touch
//! ```
//!
//! Source: midpoint rule; error estimate from one whole step and two half steps (Hairer, Nørsett and Wanner
//! 1993, §II.4). The loops are closed after each step.

use crate::evaluation::prepared_question::PreparedQuestion;
use crate::question::errors::question_error::StudyError;
use crate::thresholds::{
    FIRST_PENETRATION, LARGEST_PENETRATION, LEAST_PENETRATION, PENETRATION_GROWTH, PENETRATION_MASS,
    PENETRATION_MOTION,
};
use percuss_dynamics::{Contact, ContactResponse, EffectiveMass, Pose};

/// Reason for an unreachable depth.
#[derive(Debug)]
pub(crate) struct PenetrationEnd<T = f64> {
    /// Depth reached, m.
    pub depth: f64,
    /// Error of the question at this depth; `None` if the motion itself ends.
    pub error: Option<StudyError>,
    /// Values over the penetration (m) up to this depth, such as m̄ (kg).
    pub values: Vec<(f64, T)>,
}

/// Motion of impact from first touch on.
pub(crate) struct PenetrationPath<'a> {
    pub prepared: &'a PreparedQuestion<'a>,
    pub contact: &'a Contact,
}

/// Pose during the penetration and the contact response at the pose.
pub(crate) struct PathPoint {
    pub pose: Pose,
    pub response: ContactResponse,
    /// m̄, kg.
    pub mass: f64,
}

impl PenetrationPath<'_> {
    /// m̄ (kg) over the penetration (m): pairs from first touch to a depth, at most a sixteenth of the depth apart.
    ///
    /// # Errors
    /// [`PenetrationEnd`]: the gap cannot close to this depth on the branch, or the contact has no finite mass there.
    pub fn masses_to(&self, pose: &Pose, depth: f64) -> Result<Vec<(f64, f64)>, PenetrationEnd> {
        self.values_to(pose, depth, |point| point.mass)
    }

    /// Pairs of penetration (m) and a value of the point of the path, as by [`masses_to`](Self::masses_to).
    ///
    /// # Errors
    /// As for [`masses_to`](Self::masses_to).
    pub fn values_to<T>(
        &self,
        pose: &Pose,
        depth: f64,
        value: impl Fn(&PathPoint) -> T,
    ) -> Result<Vec<(f64, T)>, PenetrationEnd<T>> {
        let mut done = 0.0;
        let mut step = depth * FIRST_PENETRATION;
        let mut at = self.point(pose.clone()).map_err(|error| PenetrationEnd {
            depth: done,
            error,
            values: Vec::new(),
        })?;
        let mut error = None;
        let mut values = vec![(0.0, value(&at))];
        while done < depth {
            step = step.min(LARGEST_PENETRATION * depth);
            // No tiny last step: its error would be rounding only.
            if step > (1.0 - LEAST_PENETRATION) * (depth - done) {
                step = depth - done;
            }
            match self.step_with_error_control(&at, step) {
                Ok(next) => {
                    at = next;
                    // Exact end at `depth`, without rounding.
                    done = if step < depth - done { done + step } else { depth };
                    values.push((done, value(&at)));
                    step *= PENETRATION_GROWTH;
                    error = None;
                }
                Err(why) => {
                    error = why.or(error);
                    step /= 2.0;
                    if step < LEAST_PENETRATION * depth {
                        return Err(PenetrationEnd { depth: done, error, values });
                    }
                }
            }
        }
        Ok(values)
    }

    /// Point after a step, if one whole step and two half steps agree; `Err(None)` otherwise.
    fn step_with_error_control(&self, at: &PathPoint, step: f64) -> Result<PathPoint, Option<StudyError>> {
        let whole = self.step(at, step)?;
        let half = self.step(at, step / 2.0)?;
        let twice = self.step(&half, step / 2.0)?;
        let contact_point = |point: &PathPoint| point.pose.link(self.contact.link).point(&self.contact.point);
        let distance = (contact_point(&whole) - contact_point(&twice)).norm();
        let agree = (whole.mass / twice.mass - 1.0).abs() <= PENETRATION_MASS
            && distance <= PENETRATION_MOTION * step.abs();
        if agree { Ok(twice) } else { Err(None) }
    }

    /// Point after one step of the midpoint rule.
    fn step(&self, at: &PathPoint, step: f64) -> Result<PathPoint, Option<StudyError>> {
        let middle = self.point(at.pose.advanced_along(&at.response, step / 2.0).ok_or(None)?)?;
        self.point(at.pose.advanced_along(&middle.response, step).ok_or(None)?)
    }

    /// Response at a pose of the path. Error: `None` if the mass is not finite or nothing moves.
    fn point(&self, pose: Pose) -> Result<PathPoint, Option<StudyError>> {
        let contact = self.prepared.contact_of_row(self.contact, &pose);
        let response = self.prepared.response(&pose, &contact).map_err(Some)?;
        match response.effective_mass {
            EffectiveMass::Finite(mass) if response.mechanism_moves() => {
                Ok(PathPoint { pose, response, mass })
            }
            _ => Err(None),
        }
    }
}
