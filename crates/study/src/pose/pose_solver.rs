//! Pose of a question: joints at their set positions, then the travels.

use crate::pose::driver::Driver;
use crate::pose::point_travel::PointTravel;
use crate::pose::touch::touching_stops;
use crate::pose::unreachable_range::UnreachedRow;
use crate::question::error::{Fault, StudyError};
use crate::question::field::{Field, Names};
use crate::question::given_travel::GivenTravel;
use crate::question::mass_question::MassQuestion;
use crate::thresholds::{HALVINGS, LEAST_PART, OTHER_DRIVERS, TRAVEL_PARTS, TRAVEL_ROUNDS, TRAVEL_TOLERANCE};
use nalgebra::{DMatrix, DVector, Vector3};
use percuss_dynamics::{Configuration, Gap, Pose, System, TravelError};
use percuss_mechanism::JointId;

/// Pose of a question.
///
/// A stop is brought to the touch, see [`touching_stops`]. The driver of a travel is selected among the joints that are neither set nor drivers of another travel, by
/// the rule of `percuss_dynamics::Travel::driver`; a sweep over a travel uses the same rule. A travel starts at
/// the pose of the set joints. Several travels are solved together by Newton's method.
///
/// # Errors
/// [`StudyError`]: loops that do not close, an invalid travel, or an unreachable travel.
pub(crate) fn pose(
    system: &System,
    configuration: &Configuration,
    question: &MassQuestion,
) -> Result<Pose, StudyError> {
    let start = system.pose(configuration)?;
    let mechanism = system.mechanism();
    let mut driven: Vec<JointId> =
        question.set.iter().filter_map(|(name, _)| mechanism.find_joint(name).ok()).collect();
    let mut travels = Vec::new();
    for given in &question.travel {
        let travel = DrivenTravel::new(system, configuration, given, &driven)?;
        driven.push(travel.driver.joint);
        travels.push(travel);
    }
    let stops = touching_stops(mechanism, question, &start)?;
    for (_, gap) in &stops {
        match DrivenTravel::toward_stop(system, configuration, gap, &driven) {
            Ok(travel) => {
                driven.push(travel.driver.joint);
                travels.push(travel);
            }
            // All joints that move the stop are set: the question is about this pose.
            Err(StudyError::Input { fault, .. }) if is_immobile(&fault) => {}
            Err(error) => return Err(error),
        }
    }
    let reached = match &travels[..] {
        [] => Ok(start.clone()),
        [alone] => alone.solve_pose(start.clone(), question),
        several => solve_travels(system, configuration, several, start.clone(), question.names),
    };
    match (reached, &stops[..]) {
        (Err(StudyError::TravelNotReached { why, nearest }), [(stop, gap), ..]) => {
            let (name, gap) = (stop.name().to_owned(), gap.at(&start));
            Err(StudyError::StopNotReached { name, gap, nearest, why })
        }
        (reached, _) => reached,
    }
}

/// True if no free joint moves the point of a travel.
fn is_immobile(fault: &Fault) -> bool {
    matches!(fault, Fault::Travel(TravelError::NothingMoves { .. }))
}

/// Pose at which several travels have the requested displacements. Newton's method on all drivers, with
/// intermediate targets.
fn solve_travels(
    system: &System,
    configuration: &Configuration,
    travels: &[DrivenTravel],
    start: Pose,
    names: Names,
) -> Result<Pose, StudyError> {
    let within = TRAVEL_TOLERANCE * system.mechanism().characteristic_length();
    let mut drivers: Vec<JointId> = travels.iter().map(|travel| travel.driver.joint).collect();
    let mut at = positions(&start, &drivers);
    let mut pose = move_drivers(system, configuration, &drivers, &start, &at)?;
    let (mut reached, mut part, mut changes) = (0.0, 1.0 / TRAVEL_PARTS, 0);
    while reached < 1.0 {
        let to = f64::min(reached + part, 1.0);
        match solve_travel_fraction(system, configuration, travels, &drivers, (&pose, &at), to, within) {
            Ok((next, there)) => {
                (pose, at, reached) = (next, there, to);
                part *= 2.0;
            }
            Err(_) if part < LEAST_PART && changes < OTHER_DRIVERS => {
                // A driver may be at a dead centre; other drivers continue from this pose.
                changes = if reached > 0.0 { changes + 1 } else { OTHER_DRIVERS };
                let Some(others) = select_drivers(travels, &pose) else { continue };
                let there = positions(&pose, &others);
                if let Ok(same) = move_drivers(system, configuration, &others, &pose, &there) {
                    (drivers, at, pose, part) = (others, there, same, 1.0 / TRAVEL_PARTS);
                }
            }
            Err(error) if part < LEAST_PART => {
                let why = match error {
                    Some(StudyError::Assembly(error)) if error.is_bad_input() => return Err(error.into()),
                    Some(error) => format!(" ({})", error.message(names)),
                    None => String::new(),
                };
                let percent = (100.0 * reached).floor();
                return Err(StudyError::TravelNotReached {
                    why: format!("the travels cannot be reached together; reached: {percent} %{why}"),
                    nearest: None,
                });
            }
            Err(_) => part *= 0.5,
        }
    }
    Ok(pose)
}

/// Pose at the fraction `part` of the displacements, and the positions of the drivers. `Err(None)` if Newton's
/// method does not converge to `within` (m).
#[allow(clippy::type_complexity, reason = "read in one place")]
fn solve_travel_fraction(
    system: &System,
    configuration: &Configuration,
    travels: &[DrivenTravel],
    drivers: &[JointId],
    (from, at): (&Pose, &[f64]),
    part: f64,
    within: f64,
) -> Result<(Pose, Vec<f64>), Option<StudyError>> {
    let (mut pose, mut at, count) = (from.clone(), at.to_vec(), travels.len());
    for _ in 0..TRAVEL_ROUNDS {
        let missing = travels.iter().map(|t| part * t.distance - t.travel.displacement(&pose));
        let missing = DVector::from_iterator(count, missing);
        if missing.amax() <= within {
            return Ok((pose, at));
        }
        let mut rates = DMatrix::zeros(count, count);
        for (i, travel) in travels.iter().enumerate() {
            for (j, driver) in drivers.iter().enumerate() {
                rates[(i, j)] = travel.travel.rate(&pose, *driver).ok_or(None)?;
            }
        }
        let step =
            rates.lu().solve(&missing).filter(|step| step.iter().all(|x| x.is_finite())).ok_or(None)?;
        at.iter_mut().zip(step.iter()).for_each(|(at, step)| *at += step);
        pose = move_drivers(system, configuration, drivers, &pose, &at).map_err(Some)?;
    }
    Err(None)
}

/// Pose with the drivers at given positions, on the branch of the pose `from`.
fn move_drivers(
    system: &System,
    configuration: &Configuration,
    drivers: &[JointId],
    from: &Pose,
    at: &[f64],
) -> Result<Pose, StudyError> {
    let mut set = configuration.clone().without_guesses();
    for (driver, value) in drivers.iter().zip(at) {
        set.set(system.mechanism().joint(*driver).name(), &[*value])
            .map_err(|error| StudyError::input(Field::Travel, error))?;
    }
    Ok(system.pose_from(from, &set)?)
}

/// Positions of joints with one position each.
fn positions(pose: &Pose, joints: &[JointId]) -> Vec<f64> {
    joints.iter().map(|joint| pose.joint(*joint)[0]).collect()
}

/// Drivers of the travels, selected at a pose; a joint drives one travel at most, and set joints drive none.
fn select_drivers(travels: &[DrivenTravel], pose: &Pose) -> Option<Vec<JointId>> {
    // The drivers of the first travel exclude the set joints only.
    let set = travels.first()?.travel.set();
    let mut drivers = Vec::new();
    for travel in travels {
        drivers.push(travel.travel.select_driver(pose, &[set, &drivers].concat())?);
    }
    Some(drivers)
}

/// Travel and the joint that drives the travel.
struct DrivenTravel {
    travel: PointTravel,
    driver: Driver,
    distance: f64,
}

impl DrivenTravel {
    fn new(
        system: &System,
        base: &Configuration,
        given: &GivenTravel,
        driven: &[JointId],
    ) -> Result<Self, StudyError> {
        let link = system.mechanism().find_link(&given.link);
        let link = link.map_err(|error| StudyError::input(Field::Travel, error))?;
        let [point, direction] = [given.point, given.direction].map(Vector3::from);
        let (travel, driver) =
            PointTravel::new(system, base, Field::Travel, link, point, direction, &|joint| {
                driven.contains(&joint)
            })?;
        Ok(Self { travel, driver, distance: given.distance })
    }

    /// Travel that closes the gap of a stop.
    fn toward_stop(
        system: &System,
        base: &Configuration,
        gap: &Gap,
        driven: &[JointId],
    ) -> Result<Self, StudyError> {
        let is_set = |joint| driven.contains(&joint);
        let (travel, driver) = PointTravel::toward_stop(system, base, gap, &is_set)?;
        let distance = gap.at(&travel.start);
        Ok(Self { travel, driver, distance })
    }

    /// Pose with the requested displacement of the point, through intermediate poses if the displacement
    /// exceeds the work limit.
    fn solve_pose(&self, from: Pose, question: &MassQuestion) -> Result<Pose, StudyError> {
        let mut pose = from;
        let mut parts = 0;
        let mut to = self.distance;
        loop {
            match self.travel.pose_at_displacement(&self.driver, &pose, to, question.names)? {
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
                    return Err(StudyError::TravelNotReached { why, nearest });
                }
            }
        }
    }
}
