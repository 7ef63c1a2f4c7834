//! What the numbers of a row set: the positions of joints, and last the travel of a point.

use crate::answer::Prepared;
use crate::driver::Driver;
use crate::error::{Fault, StudyError};
use crate::field::Field;
use crate::quantity::{Dimension, position_dimension};
use crate::travel::Travel;
use crate::varied_values::VariedColumn;
use crate::vary::{Varied, Vary};
use nalgebra::Vector3;
use percuss_dynamics::{Configuration, System};
use percuss_mechanism::{JointId, LinkId};
use std::ops::Range;
use std::sync::Arc;

/// What the numbers of a row set, resolved.
#[derive(Debug)]
pub(crate) struct Setting {
    /// What the question sets and guesses.
    base: Configuration,
    /// The same without guesses, for a row that is followed from another.
    following: Configuration,
    joints: Vec<SetJoint>,
    travel: Option<TravelAlong>,
    pub columns: Arc<[VariedColumn]>,
    /// What asked for them.
    field: Field,
}

/// A joint that rows set, and which of their numbers it takes.
#[derive(Debug)]
struct SetJoint {
    joint: JointId,
    name: String,
    numbers: Range<usize>,
}

/// A travel whose start depends on the joints set before it.
#[derive(Debug)]
struct TravelAlong {
    link: LinkId,
    point: Vector3<f64>,
    direction: Vector3<f64>,
    /// Joints that do not drive it: they are set.
    set: Vec<JointId>,
}

impl Setting {
    /// What the ranges of a grid set.
    pub fn of_grid(prepared: &Prepared, ranges: &[Vary]) -> Result<Self, StudyError> {
        let mechanism = prepared.system.mechanism();
        let refuse = |fault: Fault| StudyError::input(Field::Vary, fault);
        let mut travel = None;
        let mut joints = Vec::new();
        for (number, vary) in ranges.iter().enumerate() {
            match &vary.what {
                Varied::Joint(name) => {
                    let joint = single_joint(prepared, name)?;
                    if joints.contains(&joint) {
                        return Err(refuse(Fault::VariedTwice { joint: name.clone() }));
                    }
                    joints.push(joint);
                }
                Varied::Travel { .. } if number + 1 < ranges.len() => {
                    return Err(refuse(Fault::TravelNotLast { name: vary.name() }));
                }
                Varied::Travel { link, point, direction } => {
                    let link = mechanism.find_link(link).map_err(|error| refuse(error.into()))?;
                    travel = Some((link, Vector3::from(*point), Vector3::from(*direction)));
                }
            }
        }
        let mut setting = Self::of_joints(prepared, &joints, Field::Vary);
        if let Some((link, point, direction)) = travel {
            let by_question =
                prepared.question.set.iter().filter_map(|(set, _)| mechanism.find_joint(set).ok());
            let set = joints.into_iter().chain(by_question).collect();
            setting.travel = Some(TravelAlong { link, point, direction, set });
            let column = VariedColumn {
                name: ranges.last().map_or_else(String::new, Vary::name),
                unit: "m",
                joint: None,
            };
            setting.columns = setting.columns.iter().cloned().chain([column]).collect();
        }
        Ok(setting)
    }

    /// The positions of some joints, all their numbers one after another.
    pub fn of_joints(prepared: &Prepared, joints: &[JointId], field: Field) -> Self {
        let mechanism = prepared.system.mechanism();
        let (mut set, mut columns, mut first) = (Vec::new(), Vec::new(), 0);
        for &joint in joints {
            let (name, kind) = (mechanism.joint(joint).name(), mechanism.joint(joint).kind());
            let numbers = first..first + kind.positions();
            first = numbers.end;
            columns.extend((0..kind.positions()).map(|i| VariedColumn {
                name: if kind.positions() == 1 { name.to_owned() } else { format!("{name}[{i}]") },
                unit: position_dimension(kind, i).unit(),
                joint: Some(name.to_owned()),
            }));
            set.push(SetJoint { joint, name: name.to_owned(), numbers });
        }
        Self {
            base: prepared.configuration.clone(),
            following: prepared.configuration.clone().without_guesses(),
            joints: set,
            travel: None,
            columns: columns.into(),
            field,
        }
    }

    /// How many numbers a row has.
    pub fn width(&self) -> usize {
        self.columns.len()
    }

    /// Whether the last number is a travel.
    pub fn travels(&self) -> bool {
        self.travel.is_some()
    }

    /// What the number of a column measures.
    pub fn dimension(&self, column: usize) -> Dimension {
        let mechanism = self.base.mechanism();
        let joint = self.joints.iter().find(|set| set.numbers.contains(&column));
        joint.map_or(Dimension::Length, |set| {
            position_dimension(mechanism.joint(set.joint).kind(), column - set.numbers.start)
        })
    }

    /// What the numbers are set of, in words.
    pub fn what(&self) -> String {
        match (&self.travel, &self.joints[..]) {
            (Some(_), _) => "the travel".into(),
            (None, [one]) => format!("\"{}\"", one.name),
            (None, _) => "what is varied".into(),
        }
    }

    /// The name of the joint that takes the last number.
    pub fn last_joint(&self) -> Option<&str> {
        self.joints.last().map(|set| set.name.as_str())
    }

    /// The joints that are set, and whether each has one number.
    pub fn joints(&self) -> impl Iterator<Item = (JointId, &Range<usize>)> {
        self.joints.iter().map(|set| (set.joint, &set.numbers))
    }

    /// The configuration of a row; `followed`: from another row, whatever was guessed.
    pub fn configuration(&self, values: &[f64], followed: bool) -> Result<Configuration, StudyError> {
        let mut configuration = if followed { self.following.clone() } else { self.base.clone() };
        for SetJoint { name, numbers, .. } in &self.joints {
            configuration
                .set(name, &values[numbers.clone()])
                .map_err(|error| StudyError::input(self.field, error))?;
        }
        Ok(configuration)
    }

    /// The configuration with all that rows set at 0: quaternions at identity.
    pub fn at_zero(&self) -> Result<Configuration, StudyError> {
        let zeros: Vec<f64> =
            self.joints.iter().flat_map(|set| self.base.get(set.joint)).copied().chain([0.0]).collect();
        self.configuration(&zeros, false)
    }

    /// The travel from where the joints of a row put the point, and what drives it.
    pub fn travel(&self, system: &System, values: &[f64]) -> Result<Option<(Travel, Driver)>, StudyError> {
        let Some(along) = &self.travel else { return Ok(None) };
        let base = self.configuration(values, false)?;
        let is_set = |joint: JointId| along.set.contains(&joint);
        Travel::new(system, &base, self.field, along.link, along.point, along.direction, &is_set).map(Some)
    }

    /// How far the joints of a row are from where they stand, the most of any that has one number; rad or m.
    pub fn distance(&self, values: &[f64], from: impl Fn(JointId) -> f64) -> f64 {
        let single = self.joints.iter().filter(|set| set.numbers.len() == 1);
        single.map(|set| (values[set.numbers.start] - from(set.joint)).abs()).fold(0.0, f64::max)
    }
}

/// The joint of this name, if it can be varied.
fn single_joint(prepared: &Prepared, name: &str) -> Result<JointId, StudyError> {
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
