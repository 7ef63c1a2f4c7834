//! Continuation along consecutive rows: each pose starts from the last pose reached, and a row out of reach
//! provides limits for the following rows.

use crate::pose::driver::Driver;
use crate::pose::point_travel::PointTravel;
use crate::pose::unreachable_range::{UnreachableExtent, UnreachableRange, UnreachedRow};
use crate::question::errors::question_error::{Fault, StudyError};
use crate::question::names::{Names, assembly_error_message};
use crate::sweep::plain_rows::PlainFindings;
use crate::sweep::row_blocks::DistanceMeasure;
use crate::sweep::row_layout::RowLayout;
use percuss_dynamics::{AssemblyError, Pose, RowPath, System};
use std::sync::Arc;

/// Step limit: joint travel (rad or m) from the last pose reached, or from 0 for a first row, at which
/// following the loops exceeded the work limit; and the row that found the limit. Rows with a longer step are
/// not tried.
pub(crate) type StepLimit = Option<(f64, usize)>;

/// Smaller of two limits.
pub(crate) fn min_limit(a: StepLimit, b: StepLimit) -> StepLimit {
    match (a, b) {
        (Some(one), Some(other)) => Some(if other.0 < one.0 { other } else { one }),
        (one, other) => one.or(other),
    }
}

/// State of the continuation along a line of rows.
#[derive(Debug)]
pub(crate) struct LineContinuation {
    distance_measure: DistanceMeasure,
    travel: Option<Arc<(PointTravel, Driver)>>,
    pub unreachable: UnreachableRange,
    pub step_limit: StepLimit,
    /// Path along the line.
    pub path: RowPath<PlainFindings>,
}

impl LineContinuation {
    /// Line that starts at the pose of the question; `travel` is given if known.
    pub fn new(
        along: DistanceMeasure,
        travel: Option<Arc<(PointTravel, Driver)>>,
        too_far: StepLimit,
    ) -> Self {
        Self {
            distance_measure: along,
            travel,
            unreachable: UnreachableRange::default(),
            step_limit: too_far,
            path: RowPath::new(None),
        }
    }

    /// Distance of a row along the line.
    fn distance(&self, values: &[f64]) -> f64 {
        match (self.distance_measure, values.last()) {
            (DistanceMeasure::LastNumber, Some(value)) => *value,
            _ => 0.0,
        }
    }

    /// Records a row that is reached.
    pub fn record_reached(&mut self, values: &[f64]) {
        self.unreachable.record_reached(self.distance(values));
    }

    /// Travel along this line.
    pub fn travel(&self) -> Option<Arc<(PointTravel, Driver)>> {
        self.travel.clone()
    }

    /// Pose of the next row, from the pose of the last row reached, or the reason why the row is not reached.
    pub fn pose(
        &mut self,
        system: &System,
        setting: &RowLayout,
        names: Names,
        row: usize,
        values: &[f64],
        last: Option<&Pose>,
    ) -> Result<Result<Arc<Pose>, String>, StudyError> {
        let value = self.distance(values);
        let distance = setting.largest_displacement(values, |joint| match last {
            Some(pose) => pose.joint(joint).first().copied().unwrap_or_default(),
            None => 0.0,
        });
        let beyond = self.step_limit.filter(|(far, _)| distance > *far).map(|(_, found_by)| found_by);
        if let Some(found_by) = beyond.or_else(|| self.unreachable.excluding_row(value)) {
            return Ok(Err(self.unreachable.skip(row, found_by)));
        }
        let missed = match self.pose_on_branch(system, setting, names, values, last)? {
            Ok(pose) => return Ok(Ok(Arc::new(pose))),
            Err((missed, walked)) => {
                self.step_limit = min_limit(self.step_limit, walked.map(|walked| (walked, row)));
                missed
            }
        };
        self.unreachable.record_unreached(row, value, missed.extent);
        Ok(Err(missed.reason))
    }

    /// Pose on the branch of the last pose, or the reason for failure. The distance is the joint travel
    /// followed so far, if the work limit was exceeded.
    #[allow(clippy::type_complexity, reason = "read in one place")]
    fn pose_on_branch(
        &mut self,
        system: &System,
        setting: &RowLayout,
        names: Names,
        values: &[f64],
        last: Option<&Pose>,
    ) -> Result<Result<Pose, (UnreachedRow, Option<f64>)>, StudyError> {
        if setting.travels() && self.travel.is_none() {
            match setting.travel(system, values) {
                Ok(travel) => self.travel = travel.map(Arc::new),
                Err(StudyError::Assembly(error)) if !error.is_bad_input() => {
                    // The joints before the travel have the same values along the whole line.
                    let missed = UnreachedRow {
                        reason: assembly_error_message(&error, names),
                        extent: UnreachableExtent::Everywhere,
                    };
                    return Ok(Err((missed, distance_followed(&error, last))));
                }
                Err(error) => return Err(error),
            }
        }
        if let (Some(travel), Some(&requested)) = (&self.travel, values.last()) {
            let (travel, driver) = &**travel;
            let last = last.unwrap_or(&travel.start);
            return Ok(travel
                .pose_at_displacement(driver, last, requested, names)?
                .map_err(|missed| (missed, None)));
        }
        let configuration = setting.configuration(values, last.is_some())?;
        let pose = match last {
            Some(last) => system.pose_from(last, &configuration),
            None => system.pose(&configuration),
        };
        match pose {
            Ok(pose) => Ok(Ok(pose)),
            Err(error) if !error.is_bad_input() => {
                let extent = self.failure_extent(&error, setting, last.is_some());
                let walked = distance_followed(&error, last);
                Ok(Err((UnreachedRow { reason: assembly_error_message(&error, names), extent }, walked)))
            }
            Err(error) => Err(error.into()),
        }
    }

    /// Consequence of a failed row for the other rows of the line. `continued`: the row started from another row.
    fn failure_extent(
        &self,
        error: &AssemblyError,
        setting: &RowLayout,
        continued: bool,
    ) -> UnreachableExtent {
        let of_driver = |places: &[(String, f64)]| {
            let own = |(name, _): &&(String, f64)| Some(name.as_str()) == setting.last_joint();
            places.iter().find(own).map(|(_, value)| *value)
        };
        match (error, self.distance_measure) {
            (AssemblyError::DoesNotClose { .. }, _) => UnreachableExtent::Everywhere,
            (AssemblyError::TooFar { reached, .. }, DistanceMeasure::LastNumber) => {
                of_driver(reached).map_or(UnreachableExtent::Everywhere, UnreachableExtent::BeyondWorkLimit)
            }
            (AssemblyError::Unreachable { requested, nearest, .. }, DistanceMeasure::LastNumber) => {
                match (of_driver(requested), of_driver(nearest)) {
                    (Some(_), Some(end)) if continued => UnreachableExtent::BeyondEnd(end),
                    // The assembly of a first row uses many starts; one of them may reach another row.
                    (Some(_), _) => UnreachableExtent::ThisRowOnly,
                    (None, _) => UnreachableExtent::Everywhere,
                }
            }
            _ => UnreachableExtent::ThisRowOnly,
        }
    }
}

/// Largest displacement of a driver from the last pose, rad or m, up to which the loops were followed; `None` unless the
/// work limit was exceeded.
fn distance_followed(error: &AssemblyError, last: Option<&Pose>) -> Option<f64> {
    let AssemblyError::TooFar { reached, .. } = error else { return None };
    let from = |name: &str| {
        let joint = last.and_then(|pose| Some(pose.joint(pose.mechanism().find_joint(name).ok()?)));
        joint.and_then(|positions| positions.first().copied()).unwrap_or_default()
    };
    Some(reached.iter().map(|(name, value)| (value - from(name)).abs()).fold(0.0, f64::max))
}

/// Pose with all varied values at 0, for the conversion of points given in other frames. Independent of the
/// rows.
pub(crate) fn reference(
    system: &System,
    setting: &RowLayout,
    travel: Option<&PointTravel>,
) -> Result<Pose, StudyError> {
    if let Some(travel) = travel {
        return Ok(travel.start.clone());
    }
    match system.pose(&setting.zero_configuration()?) {
        Err(source) if !source.is_bad_input() => {
            Err(StudyError::input("contact.frame", Fault::NoReferencePose { source }))
        }
        other => Ok(other?),
    }
}
