//! Continuation along consecutive rows: each pose starts from the last pose reached, and a row out of reach
//! provides limits for the following rows.

use crate::pose::driver::Driver;
use crate::pose::point_travel::PointTravel;
use crate::pose::unreachable_range::{UnreachableExtent, UnreachableRange, UnreachedRow};
use crate::question::error::{Fault, StudyError};
use crate::question::field::{Field, Names, assembly_error_message};
use crate::sweep::path_follower::PathFollower;
use crate::sweep::row_layout::RowLayout;
use percuss_dynamics::{AssemblyError, Pose, System};
use std::sync::Arc;

/// Number of a row that measures the distance along a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum DistanceMeasure {
    /// Last number: the values of a range.
    LastNumber,
    /// No number: all numbers change from row to row.
    Undefined,
}

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
    /// Pose of the last row reached.
    last: Option<Arc<Pose>>,
    pub unreachable: UnreachableRange,
    pub step_limit: StepLimit,
    /// Path follower from the last pose, if rows can be followed several at once, and the number of followers
    /// built.
    pub path_follower: Option<Box<PathFollower>>,
    pub followers_built: usize,
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
            last: None,
            unreachable: UnreachableRange::default(),
            step_limit: too_far,
            path_follower: None,
            followers_built: 0,
        }
    }

    /// Continues from a pose reached by the path follower; `value` is the last number of the row.
    pub fn continue_from(&mut self, pose: Pose, value: f64) {
        self.unreachable.record_reached(value);
        self.last = Some(Arc::new(pose));
    }

    /// True if no row has been reached.
    pub fn has_no_pose(&self) -> bool {
        self.last.is_none()
    }

    /// Travel along this line.
    pub fn travel(&self) -> Option<Arc<(PointTravel, Driver)>> {
        self.travel.clone()
    }

    /// Pose of the next row, or the reason why the row is not reached.
    pub fn pose(
        &mut self,
        system: &System,
        setting: &RowLayout,
        names: Names,
        row: usize,
        values: &[f64],
    ) -> Result<Result<Arc<Pose>, String>, StudyError> {
        let value = match (self.distance_measure, values.last()) {
            (DistanceMeasure::LastNumber, Some(value)) => *value,
            _ => 0.0,
        };
        let distance = setting.largest_displacement(values, |joint| match &self.last {
            Some(pose) => pose.joint(joint).first().copied().unwrap_or_default(),
            None => 0.0,
        });
        let beyond = self.step_limit.filter(|(far, _)| distance > *far).map(|(_, found_by)| found_by);
        if let Some(found_by) = beyond.or_else(|| self.unreachable.excluding_row(value)) {
            return Ok(Err(self.unreachable.skip(row, found_by)));
        }
        let missed = match self.pose_on_branch(system, setting, names, values)? {
            Ok(pose) => {
                let pose = Arc::new(pose);
                self.unreachable.record_reached(value);
                self.last = Some(Arc::clone(&pose));
                return Ok(Ok(pose));
            }
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
                    return Ok(Err((missed, self.distance_followed(&error))));
                }
                Err(error) => return Err(error),
            }
        }
        if let (Some(travel), Some(&requested)) = (&self.travel, values.last()) {
            let (travel, driver) = &**travel;
            let last = self.last.as_deref().unwrap_or(&travel.start);
            return Ok(travel
                .pose_at_displacement(driver, last, requested, names)?
                .map_err(|missed| (missed, None)));
        }
        let configuration = setting.configuration(values, self.last.is_some())?;
        let pose = match &self.last {
            Some(last) => system.pose_from(last, &configuration),
            None => system.pose(&configuration),
        };
        match pose {
            Ok(pose) => Ok(Ok(pose)),
            Err(error) if !error.is_bad_input() => {
                let extent = self.failure_extent(&error, setting);
                let walked = self.distance_followed(&error);
                Ok(Err((UnreachedRow { reason: assembly_error_message(&error, names), extent }, walked)))
            }
            Err(error) => Err(error.into()),
        }
    }

    /// Largest displacement of a driver, rad or m, up to which the loops were followed; `None` unless the work
    /// limit was exceeded.
    fn distance_followed(&self, error: &AssemblyError) -> Option<f64> {
        let AssemblyError::TooFar { reached, .. } = error else { return None };
        let from = |name: &str| match &self.last {
            Some(pose) => {
                let joint = pose.mechanism().find_joint(name).ok();
                joint.and_then(|joint| pose.joint(joint).first().copied()).unwrap_or_default()
            }
            None => 0.0,
        };
        Some(reached.iter().map(|(name, value)| (value - from(name)).abs()).fold(0.0, f64::max))
    }

    /// Consequence of a failed row for the other rows of the line.
    fn failure_extent(&self, error: &AssemblyError, setting: &RowLayout) -> UnreachableExtent {
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
                    (Some(_), Some(end)) if self.last.is_some() => UnreachableExtent::BeyondEnd(end),
                    // The assembly of a first row uses many starts; one of them may reach another row.
                    (Some(_), _) => UnreachableExtent::ThisRowOnly,
                    (None, _) => UnreachableExtent::Everywhere,
                }
            }
            _ => UnreachableExtent::ThisRowOnly,
        }
    }
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
            Err(StudyError::input(Field::Frame, Fault::NoReferencePose { source }))
        }
        other => Ok(other?),
    }
}
