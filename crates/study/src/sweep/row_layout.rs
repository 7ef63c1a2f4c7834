//! Layout of the numbers of a row: joint positions first, then the travel of a point.

use crate::evaluation::prepared_question::PreparedQuestion;
use crate::pose::driver::Driver;
use crate::pose::point_travel::PointTravel;
use crate::question::errors::question_error::{Fault, StudyError};
use crate::question::travel::moved::{Moved, MovedPoint};
use crate::question::travel::varied_values::VariedColumn;
use crate::question::travel::vary::{Varied, Vary};
use crate::values::position::position_dimension;
use percuss_dynamics::{Configuration, System};
use percuss_mechanism::JointId;
use percuss_units::Dimension;
use std::ops::Range;
use std::sync::Arc;

/// Row layout with resolved names.
#[derive(Debug)]
pub(crate) struct RowLayout {
    /// Positions set and guessed by the question.
    base: Configuration,
    /// `base` without guesses, for a row that continues from another row.
    base_without_guesses: Configuration,
    joints: Vec<LayoutJoint>,
    travel: Option<LayoutTravel>,
    pub columns: Arc<[VariedColumn]>,
    /// Key that defines the rows.
    field: &'static str,
}

/// Joint set by the rows, and the range of its numbers in a row.
#[derive(Debug)]
struct LayoutJoint {
    joint: JointId,
    name: String,
    numbers: Range<usize>,
}

/// Travel that starts at the pose of the joints set before.
#[derive(Debug)]
struct LayoutTravel {
    /// Moved points; the distances are those at a unit of the travel.
    points: Vec<MovedPoint>,
    /// Displacement of each point at travel 0, m.
    offsets: Vec<f64>,
    /// Set joints; these cannot drive the travel.
    set: Vec<JointId>,
    moved: Moved,
}

impl RowLayout {
    /// Layout of the ranges of a grid.
    pub fn from_grid(prepared: &PreparedQuestion, ranges: &[Vary]) -> Result<Self, StudyError> {
        let mechanism = prepared.system.mechanism();
        let refuse = |fault: Fault| StudyError::input("sweep.vary", fault);
        let mut travel = None;
        let mut joints = Vec::new();
        for (number, vary) in ranges.iter().enumerate() {
            match &vary.quantity {
                Varied::Joint(name) => {
                    let joint = single_joint(prepared, name)?;
                    if joints.contains(&joint) {
                        return Err(refuse(format!("\"{name}\" is varied twice; give it one range").into()));
                    }
                    joints.push(joint);
                }
                // A joint of the model has precedence over a motion of the wheels.
                Varied::Travel(Moved::Wheels(motion)) if mechanism.find_joint(motion.name()).is_ok() => {
                    joints.push(single_joint(prepared, motion.name())?);
                }
                Varied::Travel(_) if number + 1 < ranges.len() => {
                    let why = format!(
                        "\"{}\" is not the last of the ranges: only one travel may have a range, and it comes last, because each of its \
                         rows starts from the joint positions of the other ranges; give another travel one length",
                        vary.name()
                    );
                    return Err(refuse(why.into()));
                }
                Varied::Travel(moved) => {
                    let points = moved.points(mechanism, "sweep.vary", 1.0)?;
                    let offsets = constant_displacements(prepared, moved, &points)?;
                    travel = Some((points, offsets, moved.clone()));
                }
            }
        }
        let mut setting = Self::from_joints(prepared, &joints, "sweep.vary");
        if let Some((points, offsets, moved)) = travel {
            let by_question =
                prepared.question.pose.set.iter().filter_map(|(set, _)| mechanism.find_joint(set).ok());
            let set = joints.into_iter().chain(by_question).collect();
            setting.travel = Some(LayoutTravel { points, offsets, set, moved });
            let column = VariedColumn {
                name: ranges.last().map_or_else(String::new, Vary::name),
                unit: Dimension::Length,
                joint: None,
            };
            setting.columns = setting.columns.iter().cloned().chain([column]).collect();
        }
        Ok(setting)
    }

    /// Layout of the positions of some joints, with all components in sequence.
    pub fn from_joints(prepared: &PreparedQuestion, joints: &[JointId], field: &'static str) -> Self {
        let mechanism = prepared.system.mechanism();
        let (mut set, mut columns, mut first) = (Vec::new(), Vec::new(), 0);
        for &joint in joints {
            let (name, kind) = (mechanism.joint(joint).name(), mechanism.joint(joint).kind());
            let numbers = first..first + kind.positions();
            first = numbers.end;
            columns.extend((0..kind.positions()).map(|i| VariedColumn {
                name: if kind.positions() == 1 { name.to_owned() } else { format!("{name}[{i}]") },
                unit: position_dimension(kind, i),
                joint: Some(name.to_owned()),
            }));
            set.push(LayoutJoint { joint, name: name.to_owned(), numbers });
        }
        Self {
            base: prepared.configuration.clone(),
            base_without_guesses: prepared.configuration.clone().without_guesses(),
            joints: set,
            travel: None,
            columns: columns.into(),
            field,
        }
    }

    /// Number of values in a row.
    pub fn width(&self) -> usize {
        self.columns.len()
    }

    /// True if the last number is a travel.
    pub fn travels(&self) -> bool {
        self.travel.is_some()
    }

    /// Moved part of the travel; `None` if the last number is no travel.
    pub fn moved(&self) -> Option<&Moved> {
        self.travel.as_ref().map(|travel| &travel.moved)
    }

    /// Dimension of the numbers of a column.
    pub fn dimension(&self, column: usize) -> Dimension {
        let mechanism = self.base.mechanism();
        let joint = self.joints.iter().find(|set| set.numbers.contains(&column));
        joint.map_or(Dimension::Length, |set| {
            position_dimension(mechanism.joint(set.joint).kind(), column - set.numbers.start)
        })
    }

    /// Description of the varied quantities for messages.
    pub fn varied_description(&self) -> String {
        match (&self.travel, &self.joints[..]) {
            (Some(_), _) => "the travel".into(),
            (None, [one]) => format!("\"{}\"", one.name),
            (None, _) => "what is varied".into(),
        }
    }

    /// Name of the joint of the last number.
    pub fn last_joint(&self) -> Option<&str> {
        self.joints.last().map(|set| set.name.as_str())
    }

    /// Joints set by the rows, each with the range of its numbers.
    pub fn joints(&self) -> impl Iterator<Item = (JointId, &Range<usize>)> {
        self.joints.iter().map(|set| (set.joint, &set.numbers))
    }

    /// Configuration of a row. `followed`: the row continues from another row, so guesses are ignored.
    pub fn configuration(&self, values: &[f64], followed: bool) -> Result<Configuration, StudyError> {
        let mut configuration = if followed { self.base_without_guesses.clone() } else { self.base.clone() };
        for LayoutJoint { name, numbers, .. } in &self.joints {
            configuration
                .set(name, &values[numbers.clone()])
                .map_err(|error| StudyError::input(self.field, error))?;
        }
        Ok(configuration)
    }

    /// Configuration with all varied values at 0; quaternions are the identity.
    pub fn zero_configuration(&self) -> Result<Configuration, StudyError> {
        let zeros: Vec<f64> =
            self.joints.iter().flat_map(|set| self.base.get(set.joint)).copied().chain([0.0]).collect();
        self.configuration(&zeros, false)
    }

    /// Travel from the pose of the joints of a row, and the driver of the travel; `None` without a travel.
    pub fn travel(
        &self,
        system: &System,
        values: &[f64],
    ) -> Result<Option<(PointTravel, Driver)>, StudyError> {
        let Some(along) = &self.travel else { return Ok(None) };
        let base = self.configuration(values, false)?;
        let is_set = |joint: JointId| along.set.contains(&joint);
        PointTravel::joined(system, &base, self.field, &along.points, &along.offsets, &is_set).map(Some)
    }

    /// Largest displacement of a joint of a row from the positions `from`, rad or m, over joints with one
    /// number.
    pub fn largest_displacement(&self, values: &[f64], from: impl Fn(JointId) -> f64) -> f64 {
        let single = self.joints.iter().filter(|set| set.numbers.len() == 1);
        single.map(|set| (values[set.numbers.start] - from(set.joint)).abs()).fold(0.0, f64::max)
    }
}

/// Displacements of the varied points by the other motions of the wheels in the question, m: a roll beside a range of heave.
fn constant_displacements(
    prepared: &PreparedQuestion,
    varied: &Moved,
    points: &[MovedPoint],
) -> Result<Vec<f64>, StudyError> {
    let mechanism = prepared.system.mechanism();
    let mut offsets = vec![0.0; points.len()];
    for travel in prepared.question.pose.travel.iter().filter(|travel| travel.moved != *varied) {
        for moved in travel.moved.points(mechanism, "pose.travel", travel.distance)? {
            let of_point = points.iter().zip(&mut offsets).find(|(point, _)| point.link == moved.link);
            if let Some((_, offset)) = of_point {
                *offset += moved.distance;
            }
        }
    }
    Ok(offsets)
}

/// Joint with this name, if a range can vary the joint.
fn single_joint(prepared: &PreparedQuestion, name: &str) -> Result<JointId, StudyError> {
    let refuse = |fault: Fault| StudyError::input("sweep.vary", fault);
    let mechanism = prepared.system.mechanism();
    let joint = mechanism.find_joint(name).map_err(|error| match mechanism.find_link(name) {
        Ok(link) => {
            let parent = mechanism.parent_joint(link).map(|joint| mechanism.joint(joint).name());
            let parent = parent.map_or_else(String::new, |joint| format!(" (its joint to the parent is \"{joint}\")"));
            let why = format!(
                "\"{name}\" is a link, and no joint{parent}; a point of a link is moved by travel:{name}:0,0,0:0,0,1=FROM:TO:COUNT, the \
                 wheels of a suspension by wheel-travel=FROM:TO:COUNT"
            );
            refuse(why.into())
        }
        Err(_) => refuse(error.into()),
    })?;
    let found = mechanism.joint(joint);
    if found.kind().positions() != 1 {
        return Err(refuse(Fault::NoSinglePosition { joint: name.to_owned(), kind: found.kind() }));
    }
    if let Some(mimic) = found.mimic() {
        let master = mechanism.joint(mimic.master).name();
        return Err(refuse(format!("\"{name}\": it mimics \"{master}\"; vary that joint").into()));
    }
    if prepared.question.pose.set.iter().any(|(set, _)| set == name) {
        return Err(refuse(Fault::VariedIsSet { joint: name.to_owned() }));
    }
    Ok(joint)
}
