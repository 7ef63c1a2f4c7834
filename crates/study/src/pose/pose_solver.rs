//! Pose of a question: joints at their set positions, then the travels.

use crate::pose::driver::Driver;
use crate::pose::joined_travels::JoinedTravels;
use crate::pose::nearest_approach::{ClosingPath, PathEnd};
use crate::pose::point_travel::PointTravel;
use crate::pose::touch::{Stop, StopOfJoint, touching_stops};
use crate::pose::unreachable_range::UnreachedRow;
use crate::question::errors::question_error::{Fault, StudyError};
use crate::question::mass_question::MassQuestion;
use crate::question::names::Names;
use crate::question::travel::given_travel::GivenTravel;
use crate::question::travel::moved::{Moved, MovedPoint};
use crate::thresholds::{
    HALVINGS, LEAST_PART, LEAST_PART_OF_HALVING, LEAST_PART_OF_LONG_HALVING, LONG_HALVING, LONG_TRAVEL,
    NEAREST_HALVINGS, SAME_START,
};
use percuss_dynamics::{AssemblyError, Configuration, Pose, System, Travel, TravelError};
use percuss_mechanism::{JointId, JointKind, Mechanism};
use percuss_units::LengthUnit;

/// Pose of a question.
///
/// A stop is brought to the touch, see [`touching_stops`]. The driver of a travel is selected among the joints that are
/// neither set nor drivers of another travel, by the rule of `percuss_dynamics::Travel::driver`; a sweep over a travel uses
/// the same rule. A travel starts at the pose of the set joints. Several travels are solved together by Newton's method.
///
/// # Errors
/// [`StudyError`]: loops that do not close, an invalid travel, or an unreachable travel.
pub(crate) fn pose(
    system: &System,
    configuration: &Configuration,
    question: &MassQuestion,
) -> Result<Pose, StudyError> {
    let start = match system.pose(configuration) {
        Ok(start) => start,
        Err(error) => return dependent_stop_pose(system, configuration, question, error),
    };
    let mechanism = system.mechanism();
    let mut driven: Vec<JointId> =
        question.pose.set.iter().filter_map(|(name, _)| mechanism.find_joint(name).ok()).collect();
    let mut travels = Vec::new();
    for point in moved_points(mechanism, question)? {
        let travel = DrivenTravel::new(system, configuration, &point, &driven)?;
        driven.push(travel.driver.joint);
        travels.push(travel);
    }
    let stops = touching_stops(mechanism, question, &start)?;
    if let [(stop, _), ..] = &stops[..] {
        let name = stop.name();
        let stops: Vec<Stop> = stops.into_iter().map(|(_, gap)| Stop::Contact(gap)).collect();
        return touch_pose(system, configuration, question, &driven, (name, &stops), start);
    }
    let solved = solve_all(&travels, &start, Search::Full { least_part: LEAST_PART }, question.names);
    let motion = question.pose.travel.iter().find_map(|travel| match &travel.moved {
        Moved::Wheels(motion) => Some(motion.name()),
        Moved::Point { .. } => None,
    });
    solved.map_err(|error| match error {
        StudyError::TravelNotReached { why, nearest, .. } => {
            StudyError::TravelNotReached { why, nearest, motion }
        }
        other => other,
    })
}

/// Pose at the stop of a joint whose position follows from loops. The only driving joint that moves this joint and is not set drives the
/// mechanism to the stop. If the question sets all of them, returns the pose at the given positions. `error`: error of setting the joint to
/// its limit; returned if the question has no such stop.
///
/// # Errors
/// Several driving joints move the joint; the stop is not reached.
fn dependent_stop_pose(
    system: &System,
    configuration: &Configuration,
    question: &MassQuestion,
    error: AssemblyError,
) -> Result<Pose, StudyError> {
    let mechanism = system.mechanism();
    let AssemblyError::Dependent { joint: name, .. } = &error else { return Err(error.into()) };
    let stop = StopOfJoint::of_question(mechanism, question)?
        .filter(|stop| mechanism.joint(stop.joint).name() == name && stop.is_requested(mechanism, question));
    let Some(stop) = stop else { return Err(error.into()) };
    let mut released = configuration.clone();
    released.release(stop.joint);
    let start = system.pose(&released)?;
    let set = question.pose.set.iter().filter_map(|(name, _)| mechanism.find_joint(name).ok());
    let driven: Vec<JointId> = set.filter(|joint| *joint != stop.joint).collect();
    let Some(travel) = Travel::of_joint(&start, stop.joint, stop.is_upper) else { return Err(error.into()) };
    let drivers = start.loops().map_or(&[][..], |loops| &loops.drivers);
    // The rate is `None` at a dead centre; the driver can move the joint from there.
    let moves = |driver: &JointId| !driven.contains(driver) && travel.rate(&start, *driver) != Some(0.0);
    let moving: Vec<JointId> = drivers.iter().copied().filter(moves).collect();
    match moving.len() {
        0 => return Ok(start),
        1 => {}
        _ => {
            let drivers: Vec<&str> = moving.iter().map(|driver| mechanism.joint(*driver).name()).collect();
            let why = format!(
                "the position of joint \"{name}\" follows from loops or couplings, and several driving joints move it to its stop: {}; \
                 set all of them except one",
                drivers.join(", ")
            );
            return Err(StudyError::input("contact.at", why));
        }
    }
    let held: Vec<JointId> = drivers.iter().copied().filter(|driver| !moving.contains(driver)).collect();
    let taken: Vec<JointId> = driven.into_iter().chain(held).collect();
    let stops = [Stop::Joint(stop.clone())];
    let posed = touch_pose(system, &released, question, &taken, (name, &stops), start);
    posed.map_err(|error| match error {
        StudyError::StopNotReached { gap, nearest, is_smallest, why, .. } => {
            let sign = if stop.is_upper { 1.0 } else { -1.0 };
            StudyError::JointStopNotReached {
                joint: name.as_str().into(),
                limit: stop.limit,
                nearest: nearest.map(|nearest| stop.limit - sign * (gap - nearest) / stop.length),
                turns: mechanism.joint(stop.joint).kind() != JointKind::Prismatic,
                is_smallest,
                driver: mechanism.joint(moving[0]).name().into(),
                why,
            }
        }
        other => other,
    })
}

/// Effort of a search for the pose of travels.
#[derive(Clone, Copy)]
enum Search {
    /// One driver for each travel, in long steps: cheap if the pose does not exist.
    Direct,
    /// All drivers. `least_part`: smallest step, as a fraction of the path, if several travels are solved together.
    Full { least_part: f64 },
}

impl Search {
    /// Smallest step, as a fraction of the path, if several travels are solved together.
    fn least_part(self) -> f64 {
        match self {
            Search::Direct => LEAST_PART_OF_HALVING,
            Search::Full { least_part } => least_part,
        }
    }
}

/// Pose at which every travel has its displacement.
fn solve_all(
    travels: &[DrivenTravel],
    start: &Pose,
    search: Search,
    names: Names,
) -> Result<Pose, StudyError> {
    match travels {
        [] => Ok(start.clone()),
        [alone] => match search {
            Search::Direct => alone.solve_with_driver(start),
            Search::Full { .. } => alone.solve_pose(start.clone(), names),
        },
        [first, ..] => {
            let distances: Vec<f64> = travels.iter().map(|travel| travel.distance).collect();
            let is_elsewhere = |travel: &DrivenTravel| travel.travel.displacement(start).abs() > SAME_START;
            let selects_drivers = travels.iter().any(is_elsewhere);
            // The configuration of the first travel holds the rack.
            joined_travels(travels, search.least_part(), selects_drivers).pose(
                &first.driver.configuration,
                start,
                &distances,
                names,
            )
        }
    }
}

/// Pose at which stops touch. `driven`: joints that are set.
fn touch_pose(
    system: &System,
    configuration: &Configuration,
    question: &MassQuestion,
    driven: &[JointId],
    (name, stops): (&str, &[Stop]),
    start: Pose,
) -> Result<Pose, StudyError> {
    let gap = stops[0].gap(&start);
    let toward = |stop: &Stop, driven: &[JointId]| match DrivenTravel::toward_stop(
        system,
        configuration,
        stop,
        driven,
    ) {
        Ok(travel) => Ok(Some(travel)),
        Err(StudyError::Input { fault, .. }) if is_immobile(&fault) => Ok(None),
        Err(error) => Err(error),
    };
    let mut taken = driven.to_vec();
    let mut travels: Vec<DrivenTravel> = Vec::new();
    for stop in stops {
        match toward(stop, &taken)? {
            Some(travel) => {
                taken.push(travel.driver.joint);
                travels.push(travel);
            }
            // The joint that drives the first stop moves this one too.
            None if !travels.is_empty() => {}
            // All joints that move the stop are set: the question is about this pose.
            None if toward(stop, &[])?.is_some() => return Ok(start),
            None => {
                return Err(StudyError::StopNotReached {
                    name: name.into(),
                    gap,
                    nearest: None,
                    is_smallest: true,
                    alone: None,
                    unit: LengthUnit::Millimetre,
                    why: "no joint with a single position moves it (in a suspension, give one of the massless rods a mass)".into(),
                });
            }
        }
    }
    let drivers: Vec<JointId> = travels.iter().map(|travel| travel.driver.joint).collect();
    let kept = travels[0].travel.kept_joint(&drivers);
    let not_reached = |nearest, is_smallest, why: String| StudyError::StopNotReached {
        name: name.into(),
        gap,
        nearest,
        is_smallest,
        alone: kept.map(|kept| {
            Box::new([drivers[0], kept].map(|joint| system.mechanism().joint(joint).name().to_owned()))
        }),
        unit: LengthUnit::Millimetre,
        why: why.into(),
    };
    let full = Search::Full { least_part: LEAST_PART };
    // Pose with a part of the gaps closed, on the branch of the start: the path back ends at the start.
    let with_part = |part: f64, from: &Pose, search: Search| -> Result<Pose, StudyError> {
        let scaled: Vec<DrivenTravel> = travels.iter().map(|travel| travel.part(part)).collect();
        let pose = solve_all(&scaled, from, search, question.names)?;
        let back: Vec<DrivenTravel> = travels.iter().map(|travel| travel.part(0.0)).collect();
        let returned = solve_all(&back, &pose, full, question.names)?;
        let is_same = is_same_pose(&returned, &start);
        is_same.then_some(pose).ok_or_else(|| StudyError::TravelNotReached {
            why: "the gap has a minimum on the path".to_owned(),
            nearest: None,
            motion: None,
        })
    };
    let why = match with_part(1.0, &start, Search::Direct) {
        Err(StudyError::TravelNotReached { why, .. }) => why,
        reached => return reached,
    };
    // The path from the start usually ends at the smallest gap; the full search and the halvings take a hundred times as long.
    if let Some(end) = closing_path_end(&travels, &start).filter(|end| end.is_minimum) {
        return Err(not_reached(Some(end.closed * gap), true, why));
    }
    let why = match with_part(1.0, &start, full) {
        Err(StudyError::TravelNotReached { why, .. }) => why,
        reached => return reached,
    };
    let (mut low, mut high) = (0.0, 1.0);
    let mut from = start.clone();
    for _ in 0..NEAREST_HALVINGS {
        let middle = 0.5 * (low + high);
        let search = |least_part| with_part(middle, &from, Search::Full { least_part });
        let found = search(LEAST_PART_OF_HALVING);
        // The first halvings are large displacements; with several travels, coarse steps may fail on them.
        let is_long = travels.len() > 1 && high - low > LONG_HALVING;
        let found =
            found.or_else(|error| if is_long { search(LEAST_PART_OF_LONG_HALVING) } else { Err(error) });
        match found {
            Ok(pose) => (low, from) = (middle, pose),
            Err(_) => high = middle,
        }
    }
    // The parameter of the halvings is the closed part of the gap, so they fail near the smallest gap. The parameter of the path is the arc
    // length.
    match closing_path_end(&travels, &from) {
        Some(end) if end.closed >= 1.0 => match with_part(1.0, &end.pose, full) {
            Err(StudyError::TravelNotReached { .. }) => Err(not_reached(Some(low * gap), false, why)),
            reached => reached,
        },
        Some(end) => Err(not_reached(Some(low.max(end.closed) * gap), end.is_minimum, why)),
        None => Err(not_reached(Some(low * gap), false, why)),
    }
}

/// End of the path on which the travels close the gaps of their stops, followed from `near`.
fn closing_path_end(travels: &[DrivenTravel], near: &Pose) -> Option<PathEnd> {
    let first = travels.first()?;
    let joined = joined_travels(travels, LEAST_PART, true);
    let gaps = travels.iter().map(|travel| travel.distance).collect();
    ClosingPath { travels: &joined, configuration: &first.driver.configuration, gaps }.nearest(near)
}

/// Travels that are solved together.
fn joined_travels(travels: &[DrivenTravel], least_part: f64, selects_drivers: bool) -> JoinedTravels {
    JoinedTravels {
        travels: travels.iter().map(|travel| travel.travel.travel().clone()).collect(),
        drivers: travels.iter().map(|travel| travel.driver.joint).collect(),
        set: travels.first().map_or_else(Vec::new, |first| first.travel.set().to_vec()),
        least_part,
        selects_drivers,
    }
}

/// True if all positions of two poses agree, rad or m, within [`SAME_START`].
fn is_same_pose(one: &Pose, other: &Pose) -> bool {
    let pairs = one.positions().iter().zip(other.positions());
    pairs.fold(0.0f64, |most, (a, b)| most.max((a - b).abs())) <= SAME_START
}

/// True if no free joint moves the point of a travel.
fn is_immobile(fault: &Fault) -> bool {
    matches!(fault, Fault::Travel(TravelError::NothingMoves { .. }))
}

/// Points of the travels of a question. A wheel that heaves and rolls moves by the sum.
pub(crate) fn moved_points(
    mechanism: &Mechanism,
    question: &MassQuestion,
) -> Result<Vec<MovedPoint>, StudyError> {
    for (i, one) in question.pose.travel.iter().enumerate() {
        let is_wheel = |travel: &&GivenTravel| matches!(travel.moved, Moved::Wheels(_));
        let others = question.pose.travel[..i].iter().filter(is_wheel);
        if let Some(other) =
            Some(one).filter(is_wheel).and(others.clone().find(|other| !other.moved.is_beside(&one.moved)))
        {
            let [first, second] = [other.moved.name(), one.moved.name()];
            let why = format!(
                "{first} and {second} both move the wheel; give one of them, or heave and roll of an axle"
            );
            return Err(StudyError::input("pose.travel", why));
        }
    }
    let mut all: Vec<(bool, MovedPoint)> = Vec::new();
    for given in &question.pose.travel {
        let is_wheel = matches!(given.moved, Moved::Wheels(_));
        for point in given.moved.points(mechanism, "pose.travel", given.distance)? {
            match all.iter_mut().find(|(of_wheel, known)| *of_wheel && is_wheel && known.link == point.link) {
                Some((_, known)) => known.distance += point.distance,
                None => all.push((is_wheel, point)),
            }
        }
    }
    Ok(all.into_iter().map(|(_, point)| point).collect())
}

/// Travel and the joint that drives the travel.
#[derive(Clone)]
struct DrivenTravel {
    travel: PointTravel,
    driver: Driver,
    distance: f64,
}

impl DrivenTravel {
    fn new(
        system: &System,
        base: &Configuration,
        moved: &MovedPoint,
        driven: &[JointId],
    ) -> Result<Self, StudyError> {
        let is_set = |joint| driven.contains(&joint);
        let (travel, driver) = PointTravel::new(system, base, "pose.travel", moved, &is_set)?;
        Ok(Self { travel, driver, distance: moved.distance })
    }

    /// Travel that closes the gap of a stop.
    fn toward_stop(
        system: &System,
        base: &Configuration,
        stop: &Stop,
        driven: &[JointId],
    ) -> Result<Self, StudyError> {
        let is_set = |joint| driven.contains(&joint);
        let (travel, driver) = PointTravel::toward_stop(system, base, stop, &is_set)?;
        let distance = stop.gap(&travel.start);
        Ok(Self { travel, driver, distance })
    }

    /// Travel by a part of the distance.
    fn part(&self, part: f64) -> Self {
        Self { distance: part * self.distance, ..self.clone() }
    }

    /// Pose with the requested displacement of the point by the selected driver alone.
    fn solve_with_driver(&self, from: &Pose) -> Result<Pose, StudyError> {
        let Driver { joint, configuration } = &self.driver;
        let pose = self.travel.travel().pose(from, configuration, *joint, self.distance);
        pose.map_err(|error| StudyError::TravelNotReached {
            why: error.to_string(),
            nearest: None,
            motion: None,
        })
    }

    /// Pose with the requested displacement of the point, through intermediate poses if the displacement
    /// exceeds the work limit.
    fn solve_pose(&self, from: Pose, names: Names) -> Result<Pose, StudyError> {
        let mut pose = from;
        let mut parts = 0;
        let mut to = self.distance;
        loop {
            match self.travel.pose_at_displacement(&self.driver, &pose, to, names)? {
                Ok(reached) if to == self.distance => return Ok(reached),
                Ok(reached) => {
                    pose = reached;
                    to = self.distance;
                }
                Err(UnreachedRow { extent, .. }) if extent.exceeds_work_limit() && parts < HALVINGS => {
                    parts += 1;
                    to = 0.5 * (self.travel.displacement(&pose) + to);
                }
                Err(UnreachedRow { reason: why, extent }) => {
                    let nearest = extent.nearest();
                    let why = why + &unit_hint(self.distance);
                    return Err(StudyError::TravelNotReached { why, nearest, motion: None });
                }
            }
        }
    }
}

/// Hint for an unreached travel that is too long for a number in metres.
fn unit_hint(distance: f64) -> String {
    if distance.abs() < LONG_TRAVEL {
        return String::new();
    }
    format!("; a number without a unit is in m: for millimetres write {distance}mm")
}
