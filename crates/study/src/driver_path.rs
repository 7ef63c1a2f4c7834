//! How the value of a row becomes a pose.

use crate::answer::Prepared;
use crate::driver::Driver;
use crate::error::{Fault, StudyError};
use crate::field::{Field, Names, about_assembly};
use crate::quantity::{Dimension, position_dimension};
use crate::reach::{Extent, Missed};
use crate::travel::Travel;
use crate::vary::{Varied, Vary};
use nalgebra::Vector3;
use percuss_dynamics::{AssemblyError, ContactResponse, Pose, System};
use percuss_mechanism::JointId;

/// What is varied, resolved: a driving joint, or the travel of a point with the joint that drives it.
#[derive(Debug)]
pub(crate) struct DriverPath {
    driver: Driver,
    travel: Option<Travel>,
    /// By what names messages call the parts of the question.
    names: Names,
}

impl DriverPath {
    pub fn new(prepared: &Prepared, vary: &Vary) -> Result<Self, StudyError> {
        let question = prepared.question;
        let names = question.names;
        match &vary.what {
            Varied::Joint(name) => {
                let driver = Driver { joint: joint(prepared, name)?, base: prepared.configuration.clone() };
                Ok(Self { driver, travel: None, names })
            }
            Varied::Travel { link, point, direction } => {
                let mechanism = prepared.system.mechanism();
                let refuse = |error| StudyError::input(Field::Vary, error);
                let link = mechanism.find_link(link).map_err(|error| refuse(Fault::from(error)))?;
                let is_set =
                    |id: JointId| question.set.iter().any(|(set, _)| set == mechanism.joint(id).name());
                let (travel, driver) = Travel::new(
                    &prepared.system,
                    &prepared.configuration,
                    link,
                    Vector3::from(*point),
                    Vector3::from(*direction),
                    &is_set,
                )?;
                Ok(Self { driver, travel: Some(travel), names })
            }
        }
    }

    /// What a value measures.
    pub fn dimension(&self) -> Dimension {
        match self.travel {
            Some(_) => Dimension::Length,
            None => position_dimension(self.driver.kind(), 0),
        }
    }

    /// The pose that the first row is followed from, where there is one.
    pub fn start(&self) -> Option<&Pose> {
        self.travel.as_ref().map(|travel| &travel.start)
    }

    /// The pose with the value at 0, whatever the rows are: where points in other frames are converted.
    pub fn reference(&self, system: &System) -> Result<Pose, StudyError> {
        if let Some(start) = self.start() {
            return Ok(start.clone());
        }
        match self.driver.pose(system, None, 0.0) {
            Err(StudyError::Assembly(source)) if !source.is_bad_input() => {
                Err(StudyError::input(Field::Frame, Fault::NoReferencePose { source }))
            }
            other => other,
        }
    }

    /// Where the reference pose is, in words.
    pub fn reference_place(&self) -> String {
        match &self.travel {
            Some(_) => "where the travel is 0".into(),
            None => format!("where \"{}\" is 0", self.driver.name()),
        }
    }

    /// The pose at a value, on the branch of the last one.
    pub fn pose(
        &self,
        system: &System,
        last: Option<&Pose>,
        value: f64,
    ) -> Result<Result<Pose, Missed>, StudyError> {
        match (&self.travel, last.or(self.start())) {
            (Some(travel), Some(last)) => travel.reach(&self.driver, last, value, self.names),
            (_, last) => match self.driver.pose(system, last, value) {
                Ok(pose) => Ok(Ok(pose)),
                Err(StudyError::Assembly(error)) if !error.is_bad_input() => {
                    let extent = self.extent(&error, last.is_some());
                    Ok(Err(Missed { why: about_assembly(&error, self.names), extent }))
                }
                Err(error) => Err(error),
            },
        }
    }

    /// What the failure of a row says of the others.
    fn extent(&self, error: &AssemblyError, followed: bool) -> Extent {
        let of_driver = |places: &[(String, f64)]| {
            places.iter().find(|(name, _)| name == self.driver.name()).map(|(_, value)| *value)
        };
        match error {
            AssemblyError::TooFar { reached, .. } => {
                of_driver(reached).map_or(Extent::Everywhere, Extent::TooFar)
            }
            AssemblyError::Unreachable { requested, nearest, .. } => {
                match (of_driver(requested), of_driver(nearest)) {
                    (Some(_), Some(end)) if followed => Extent::Beyond(end),
                    // A first row is looked for from many starts, and another may be reached from one of them.
                    (Some(_), _) => Extent::Nothing,
                    (None, _) => Extent::Everywhere,
                }
            }
            AssemblyError::DoesNotClose { .. } => Extent::Everywhere,
            _ => Extent::Nothing,
        }
    }

    /// The motion ratio of the point that travels.
    pub fn motion_ratio(&self, pose: &Pose, response: &ContactResponse) -> Option<f64> {
        self.travel.as_ref()?.motion_ratio(pose, response)
    }
}

/// The joint of this name, if it can be varied.
fn joint(prepared: &Prepared, name: &str) -> Result<JointId, StudyError> {
    let refuse = |fault: Fault| StudyError::input(Field::Vary, fault);
    let mechanism = prepared.system.mechanism();
    let joint = mechanism.find_joint(name).map_err(|error| refuse(error.into()))?;
    let found = mechanism.joint(joint);
    if found.kind().positions() != 1 {
        return Err(refuse(Fault::NoSinglePosition { joint: name.to_owned(), kind: found.kind() }));
    }
    if let Some(mimic) = found.mimic() {
        let master = mechanism.joint(mimic.master).name().to_owned();
        return Err(refuse(Fault::VariedMimic { joint: name.to_owned(), master }));
    }
    if prepared.question.set.iter().any(|(set, _)| set == name) {
        return Err(refuse(Fault::VariedIsSet { joint: name.to_owned() }));
    }
    Ok(joint)
}
