//! Continuation along consecutive rows: each pose starts from the last pose reached, and a row out of reach
//! provides limits for the following rows.

use crate::pose::driver::Driver;
use crate::pose::travel::Travel;
use crate::pose::unreachable_range::{Extent, Missed, Reach};
use crate::question::error::{Fault, StudyError};
use crate::question::field::{Field, Names, about_assembly};
use crate::sweep::path_follower::Following;
use crate::sweep::row_layout::Setting;
use percuss_dynamics::{AssemblyError, Pose, System};
use std::sync::Arc;

/// Number of a row that measures the distance along a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Along {
    /// Last number: the values of a range.
    Last,
    /// No number: all numbers change from row to row.
    Anything,
}

/// Step limit: joint travel (rad or m) from the last pose reached, or from 0 for a first row, at which
/// following the loops exceeded the work limit; and the row that found the limit. Rows with a longer step are
/// not tried.
pub(crate) type TooFar = Option<(f64, usize)>;

/// Smaller of two limits.
pub(crate) fn nearer(a: TooFar, b: TooFar) -> TooFar {
    match (a, b) {
        (Some(one), Some(other)) => Some(if other.0 < one.0 { other } else { one }),
        (one, other) => one.or(other),
    }
}

/// State of the continuation along a line of rows.
#[derive(Debug)]
pub(crate) struct Line {
    along: Along,
    travel: Option<Arc<(Travel, Driver)>>,
    /// Pose of the last row reached.
    last: Option<Arc<Pose>>,
    pub unreachable: Reach,
    pub step_limit: TooFar,
    /// Path follower from the last pose, if rows can be followed several at once, and the number of followers
    /// built.
    pub following: Option<Box<Following>>,
    pub begun: usize,
}

impl Line {
    /// Line that starts at the pose of the question; `travel` is given if known.
    pub fn new(along: Along, travel: Option<Arc<(Travel, Driver)>>, too_far: TooFar) -> Self {
        Self {
            along,
            travel,
            last: None,
            unreachable: Reach::default(),
            step_limit: too_far,
            following: None,
            begun: 0,
        }
    }

    /// Continues from a pose reached by the path follower; `value` is the last number of the row.
    pub fn continue_from(&mut self, pose: Pose, value: f64) {
        self.unreachable.record_reached(value);
        self.last = Some(Arc::new(pose));
    }

    /// True if no row has been reached.
    pub fn is_new(&self) -> bool {
        self.last.is_none()
    }

    /// Travel along this line.
    pub fn travel(&self) -> Option<Arc<(Travel, Driver)>> {
        self.travel.clone()
    }

    /// Pose of the next row, or the reason why the row is not reached.
    pub fn pose(
        &mut self,
        system: &System,
        setting: &Setting,
        names: Names,
        row: usize,
        values: &[f64],
    ) -> Result<Result<Arc<Pose>, String>, StudyError> {
        let value = match (self.along, values.last()) {
            (Along::Last, Some(value)) => *value,
            _ => 0.0,
        };
        let distance = setting.distance(values, |joint| match &self.last {
            Some(pose) => pose.joint(joint).first().copied().unwrap_or_default(),
            None => 0.0,
        });
        let beyond = self.step_limit.filter(|(far, _)| distance > *far).map(|(_, found_by)| found_by);
        if let Some(found_by) = beyond.or_else(|| self.unreachable.excludes(value)) {
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
                self.step_limit = nearer(self.step_limit, walked.map(|walked| (walked, row)));
                missed
            }
        };
        self.unreachable.record_unreached(row, value, missed.extent);
        Ok(Err(missed.why))
    }

    /// Pose on the branch of the last pose, or the reason for failure. The distance is the joint travel
    /// followed so far, if the work limit was exceeded.
    #[allow(clippy::type_complexity, reason = "read in one place")]
    fn pose_on_branch(
        &mut self,
        system: &System,
        setting: &Setting,
        names: Names,
        values: &[f64],
    ) -> Result<Result<Pose, (Missed, Option<f64>)>, StudyError> {
        if setting.travels() && self.travel.is_none() {
            match setting.travel(system, values) {
                Ok(travel) => self.travel = travel.map(Arc::new),
                Err(StudyError::Assembly(error)) if !error.is_bad_input() => {
                    // The joints before the travel have the same values along the whole line.
                    let missed = Missed { why: about_assembly(&error, names), extent: Extent::Everywhere };
                    return Ok(Err((missed, self.walked(&error))));
                }
                Err(error) => return Err(error),
            }
        }
        if let (Some(travel), Some(&requested)) = (&self.travel, values.last()) {
            let (travel, driver) = &**travel;
            let last = self.last.as_deref().unwrap_or(&travel.start);
            return Ok(travel.reach(driver, last, requested, names)?.map_err(|missed| (missed, None)));
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
                let walked = self.walked(&error);
                Ok(Err((Missed { why: about_assembly(&error, names), extent }, walked)))
            }
            Err(error) => Err(error.into()),
        }
    }

    /// Largest displacement of a driver, rad or m, up to which the loops were followed; `None` unless the work
    /// limit was exceeded.
    fn walked(&self, error: &AssemblyError) -> Option<f64> {
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
    fn failure_extent(&self, error: &AssemblyError, setting: &Setting) -> Extent {
        let of_driver = |places: &[(String, f64)]| {
            let own = |(name, _): &&(String, f64)| Some(name.as_str()) == setting.last_joint();
            places.iter().find(own).map(|(_, value)| *value)
        };
        match (error, self.along) {
            (AssemblyError::DoesNotClose { .. }, _) => Extent::Everywhere,
            (AssemblyError::TooFar { reached, .. }, Along::Last) => {
                of_driver(reached).map_or(Extent::Everywhere, Extent::TooFar)
            }
            (AssemblyError::Unreachable { requested, nearest, .. }, Along::Last) => {
                match (of_driver(requested), of_driver(nearest)) {
                    (Some(_), Some(end)) if self.last.is_some() => Extent::Beyond(end),
                    // The assembly of a first row uses many starts; one of them may reach another row.
                    (Some(_), _) => Extent::Nothing,
                    (None, _) => Extent::Everywhere,
                }
            }
            _ => Extent::Nothing,
        }
    }
}

/// Pose with all varied values at 0, for the conversion of points given in other frames. Independent of the
/// rows.
pub(crate) fn reference(
    system: &System,
    setting: &Setting,
    travel: Option<&Travel>,
) -> Result<Pose, StudyError> {
    if let Some(travel) = travel {
        return Ok(travel.start.clone());
    }
    match system.pose(&setting.at_zero()?) {
        Err(source) if !source.is_bad_input() => {
            Err(StudyError::input(Field::Frame, Fault::NoReferencePose { source }))
        }
        other => Ok(other?),
    }
}
