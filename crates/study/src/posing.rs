//! The pose of a question: where its joints are set, and where its travels drive the mechanism from there.

use crate::driver::Driver;
use crate::error::StudyError;
use crate::field::{Field, Names};
use crate::given_travel::GivenTravel;
use crate::question::MassQuestion;
use crate::reach::Missed;
use crate::thresholds::{HALVINGS, LEAST_PART, TRAVEL_MET, TRAVEL_PARTS, TRAVEL_ROUNDS};
use crate::travel::Travel;
use nalgebra::{DMatrix, DVector, Vector3};
use percuss_dynamics::{Configuration, Pose, System};
use percuss_mechanism::JointId;

/// The pose that a question asks about.
///
/// Each travel is driven by the joint that turns furthest with its point among those that are not set and drive no other
/// travel, as a sweep over it is; it starts where the joints as set put the point. Several are driven together, by Newton's
/// method.
///
/// # Errors
/// [`StudyError`]: loops that do not close there, a travel that means nothing, or that is not reached.
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
        let travel = Driven::new(system, configuration, given, &driven)?;
        driven.push(travel.driver.joint);
        travels.push(travel);
    }
    match &travels[..] {
        [] => Ok(start),
        [alone] => alone.reach(start, question),
        several => together(system, configuration, several, start, question.names),
    }
}

/// The pose where several travels are where they should be: Newton's method on all their drivers, by way of places between.
fn together(
    system: &System,
    configuration: &Configuration,
    travels: &[Driven],
    start: Pose,
    names: Names,
) -> Result<Pose, StudyError> {
    let within = TRAVEL_MET * system.mechanism().characteristic_length();
    let mut at: Vec<f64> = travels.iter().map(|travel| start.joint(travel.driver.joint)[0]).collect();
    let mut pose = moved(system, configuration, travels, &start, &at)?;
    let (mut reached, mut part) = (0.0, 1.0 / TRAVEL_PARTS);
    while reached < 1.0 {
        let to = f64::min(reached + part, 1.0);
        match met(system, configuration, travels, (&pose, &at), to, within) {
            Ok((next, there)) => {
                (pose, at, reached) = (next, there, to);
                part *= 2.0;
            }
            Err(error) if part < LEAST_PART => {
                let why = match error {
                    Some(StudyError::Assembly(error)) if error.is_bad_input() => return Err(error.into()),
                    Some(error) => format!(" ({})", error.message(names)),
                    None => String::new(),
                };
                let percent = (100.0 * reached).floor();
                return Err(StudyError::TravelNotReached {
                    why: format!("the travels are not reached together; {percent} % of the way is{why}"),
                });
            }
            Err(_) => part *= 0.5,
        }
    }
    Ok(pose)
}

/// The pose at a part of the way, and where its drivers stand; none where the travels' rates do not lead there.
#[allow(clippy::type_complexity, reason = "read in one place")]
fn met(
    system: &System,
    configuration: &Configuration,
    travels: &[Driven],
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
            for (j, other) in travels.iter().enumerate() {
                rates[(i, j)] = travel.travel.rate(&pose, other.driver.joint).ok_or(None)?;
            }
        }
        let step =
            rates.lu().solve(&missing).filter(|step| step.iter().all(|x| x.is_finite())).ok_or(None)?;
        at.iter_mut().zip(step.iter()).for_each(|(at, step)| *at += step);
        pose = moved(system, configuration, travels, &pose, &at).map_err(Some)?;
    }
    Err(None)
}

/// The pose with the drivers set, on the branch of another.
fn moved(
    system: &System,
    configuration: &Configuration,
    travels: &[Driven],
    from: &Pose,
    at: &[f64],
) -> Result<Pose, StudyError> {
    let mut set = configuration.clone().without_guesses();
    for (travel, value) in travels.iter().zip(at) {
        set.set(system.mechanism().joint(travel.driver.joint).name(), &[*value])
            .map_err(|error| StudyError::input(Field::Travel, error))?;
    }
    Ok(system.pose_from(from, &set)?)
}

/// A travel with the joint that drives it.
struct Driven {
    travel: Travel,
    driver: Driver,
    distance: f64,
}

impl Driven {
    fn new(
        system: &System,
        base: &Configuration,
        given: &GivenTravel,
        driven: &[JointId],
    ) -> Result<Self, StudyError> {
        let link = system.mechanism().find_link(&given.link);
        let link = link.map_err(|error| StudyError::input(Field::Travel, error))?;
        let [point, direction] = [given.point, given.direction].map(Vector3::from);
        let (travel, driver) = Travel::new(system, base, Field::Travel, link, point, direction, &|joint| {
            driven.contains(&joint)
        })?;
        Ok(Self { travel, driver, distance: given.distance })
    }

    /// The pose where the point is displaced as asked, by way of poses between where that is far.
    fn reach(&self, from: Pose, question: &MassQuestion) -> Result<Pose, StudyError> {
        let mut pose = from;
        let mut parts = 0;
        let mut to = self.distance;
        loop {
            match self.travel.reach(&self.driver, &pose, to, question.names)? {
                Ok(reached) if to == self.distance => return Ok(reached),
                Ok(reached) => {
                    pose = reached;
                    to = self.distance;
                }
                Err(Missed { extent, .. }) if extent.is_too_far() && parts < HALVINGS => {
                    parts += 1;
                    to = 0.5 * (self.travel.displacement(&pose) + to);
                }
                Err(Missed { why, .. }) => return Err(StudyError::TravelNotReached { why }),
            }
        }
    }
}
