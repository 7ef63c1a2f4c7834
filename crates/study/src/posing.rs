//! The pose of a question: where its joints are set, and where its travels drive the mechanism from there.

use crate::driver::Driver;
use crate::error::{Fault, StudyError};
use crate::field::Field;
use crate::given_travel::GivenTravel;
use crate::question::MassQuestion;
use crate::reach::Missed;
use crate::thresholds::{HALVINGS, TRAVEL_MET, TRAVEL_ROUNDS};
use crate::travel::Travel;
use nalgebra::Vector3;
use percuss_dynamics::{Configuration, Pose, System};
use percuss_mechanism::JointId;

/// The pose that a question asks about.
///
/// Each travel is driven by the joint that moves its point most among those that are not set and drive no other travel, as a
/// sweep over it is; it starts where the joints as set put the point. Travels that move one another's points are driven in
/// turn until all are met.
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
    let mut pose = start;
    let within = TRAVEL_MET * mechanism.characteristic_length();
    for round in 0..TRAVEL_ROUNDS {
        for number in 0..travels.len() {
            let others = travels.iter().enumerate().filter(|(other, _)| *other != number);
            let others: Vec<JointId> = others.map(|(_, travel)| travel.driver.joint).collect();
            travels[number].hold(configuration, &pose, &others)?;
            pose = travels[number].reach(pose, question)?;
        }
        let met = |travel: &Driven| (travel.travel.displacement(&pose) - travel.distance).abs() <= within;
        if travels.iter().all(met) {
            break;
        }
        if round + 1 == TRAVEL_ROUNDS {
            return Err(StudyError::input(Field::Travel, Fault::TravelsAtOdds { count: travels.len() }));
        }
    }
    Ok(pose)
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

    /// Keeps the joints that drive other travels where they are.
    fn hold(&mut self, base: &Configuration, pose: &Pose, others: &[JointId]) -> Result<(), StudyError> {
        let mut held = base.clone();
        for &joint in others {
            held.set(pose.mechanism().joint(joint).name(), pose.joint(joint))
                .map_err(|error| StudyError::input(Field::Travel, error))?;
        }
        self.driver.base = held;
        Ok(())
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
