//! Questions of the study crate, from the package's dataclasses.

use crate::analysis::contact::{GivenContact, frame};
use crate::analysis::pose::Pose;
use crate::analysis::system::{base, link_point_vector, numbers};
use crate::conversion::arrays::{list, triple};
use crate::conversion::errors::{input, of_argument};
use percuss::contact::Separation;
use percuss::contact::exports::Tool;
use percuss::spatial::Transform;
use percuss::study::{
    DampingQuestion, EstimateQuestion, GivenPose, GivenPosition, GivenTravel, Hold, MassQuestion, Moved,
    Normal, Quantity, RatioPoint, RowSource, UPWARDS, Varied, Vary,
};
use percuss::{DEFAULT_MAX_SIZE, Mechanism};
use pyo3::prelude::*;
use pyo3::types::{PyAny, PyDict};

/// Python class `percuss.Conditions`.
#[derive(FromPyObject)]
pub struct Conditions<'py> {
    frame: String,
    against_mass: Option<f64>,
    set: Option<Bound<'py, PyDict>>,
    guess: Option<Bound<'py, PyDict>>,
    travel: Vec<Bound<'py, PyAny>>,
    pose: Option<PositionsOf<'py>>,
    lock: Vec<String>,
    hold: Vec<Bound<'py, PyAny>>,
    armature: Option<Bound<'py, PyDict>>,
    base: Option<String>,
    estimate: Option<Bound<'py, PyAny>>,
    ratio_at: Vec<Bound<'py, PyAny>>,
}

/// Positions by joint, from numbers or text such as "30deg".
fn positions(given: Option<&Bound<'_, PyDict>>, what: &str) -> PyResult<Vec<(String, GivenPosition)>> {
    let Some(given) = given else { return Ok(Vec::new()) };
    let one = |(joint, value): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
        let joint: String = joint.extract()?;
        let position = match value.extract::<String>() {
            Ok(text) => GivenPosition::parse(&text),
            Err(_) => GivenPosition::from_numbers(&list(&value, &format!("{what} of \"{joint}\""))?),
        };
        let position = position.map_err(|error| input(format_args!("{what} of \"{joint}\": {error}")))?;
        Ok((joint, position))
    };
    given.iter().map(one).collect()
}

/// Estimate of m̄ from the masses of some links: (links,), (links, point) or (links, point, direction).
fn estimate(given: &Bound<'_, PyAny>) -> PyResult<EstimateQuestion> {
    let parts: Vec<Bound<'_, PyAny>> = given.extract()?;
    let (links, point, direction) = match &parts[..] {
        [links] => (links, None, None),
        [links, point] => (links, Some(point), None),
        [links, point, direction] => (links, Some(point), Some(direction)),
        _ => return Err(input("estimate: expected (links,), (links, point) or (links, point, direction)")),
    };
    let links: Vec<String> = match links.extract::<String>() {
        Ok(one) => vec![one],
        Err(_) => links.extract()?,
    };
    if links.is_empty() {
        return Err(input("estimate: it names no link; name at least one"));
    }
    let point = point.map(|point| triple(point, "point of estimate")).transpose()?.unwrap_or_default();
    let direction = direction.map(|along| triple(along, "direction of estimate")).transpose()?;
    Ok(EstimateQuestion { links, point, direction })
}

/// Travel, from text in command-line syntax or from (link, point, direction, distance) in SI units.
fn travel(given: &Bound<'_, PyAny>) -> PyResult<GivenTravel> {
    if let Ok(text) = given.extract::<String>() {
        return GivenTravel::parse(&text).map_err(|error| input(format_args!("travel: \"{text}\": {error}")));
    }
    let (link, point, direction, distance): (String, Bound<'_, PyAny>, Bound<'_, PyAny>, f64) =
        given.extract().map_err(|_| input("travel: expected text, or (link, point, direction, distance)"))?;
    let point = triple(&point, "point of travel")?;
    let direction = triple(&direction, "direction of travel")?;
    let distance =
        Quantity::number(distance).map_err(|error| input(format_args!("distance of travel: {error}")))?;
    Ok(GivenTravel { moved: Moved::Point { link, point, direction }, distance: distance.value })
}

/// Positions of all joints: a file, or a pose of the model.
#[derive(FromPyObject)]
enum PositionsOf<'py> {
    Pose(Bound<'py, Pose>),
    File(String),
}

impl PositionsOf<'_> {
    /// Reads the positions.
    fn read(&self) -> PyResult<GivenPose> {
        let read = match self {
            Self::File(path) => GivenPose::read(path, DEFAULT_MAX_SIZE).map_err(input),
            Self::Pose(pose) if *pose.get().pose.base() != Transform::identity() => Err(input(
                "the pose has a base_pose, and a report has the root link at the world's origin; expected a pose without \
                 base_pose, and vectors in the axes of the root link",
            )),
            Self::Pose(pose) => {
                let Pose { model, pose, .. } = pose.get();
                GivenPose::from_pose(pose, model.read.inputs.first().cloned()).map_err(input)
            }
        };
        read.map_err(of_argument("pose"))
    }
}

/// Point of a motion ratio from (link, point) or (link, point, direction).
fn ratio_point(given: &Bound<'_, PyAny>) -> PyResult<RatioPoint> {
    let (link, point, direction) = link_point_vector(given, "ratio_at", "direction")?;
    Ok(RatioPoint { link, point, direction: direction.unwrap_or(UPWARDS) })
}

impl Conditions<'_> {
    /// Mass question without a contact.
    pub fn question(&self) -> PyResult<MassQuestion> {
        let hold = |hold: &Bound<'_, PyAny>| {
            let (link, point, normal) = link_point_vector(hold, "hold", "normal")?;
            PyResult::Ok(Hold { link, point, normal })
        };
        let frame = frame(&self.frame, "frame")?;
        Ok(MassQuestion {
            frame,
            normal_frame: frame,
            against_mass: self.against_mass,
            set: positions(self.set.as_ref(), "set").map_err(of_argument("set"))?,
            guess: positions(self.guess.as_ref(), "guess").map_err(of_argument("guess"))?,
            travel: self.travel.iter().map(travel).collect::<PyResult<_>>().map_err(of_argument("travel"))?,
            pose: self.pose.as_ref().map(PositionsOf::read).transpose()?,
            lock: self.lock.clone(),
            hold: self.hold.iter().map(hold).collect::<PyResult<_>>().map_err(of_argument("hold"))?,
            armature: numbers(self.armature.as_ref(), "armature").map_err(of_argument("armature"))?,
            base: base(self.base.as_deref().unwrap_or("fixed"))?,
            estimate: self.estimate.as_ref().map(estimate).transpose().map_err(of_argument("estimate"))?,
            ratio_at: self
                .ratio_at
                .iter()
                .map(ratio_point)
                .collect::<PyResult<_>>()
                .map_err(of_argument("ratio_at"))?,
            ..MassQuestion::without_contact()
        })
    }

    /// Mass question for a contact of the mechanism.
    pub fn question_at(&self, mechanism: &Mechanism, contact: &GivenContact<'_>) -> PyResult<MassQuestion> {
        let question = self.question()?;
        let contact = match contact {
            GivenContact::Named(name) => return Ok(MassQuestion { at: Some(name.clone()), ..question }),
            GivenContact::Contact(contact) => contact.get(),
        };
        let resolved = contact.resolve(mechanism)?;
        let name = |link| mechanism.link(link).name().to_owned();
        if resolved.against.is_some() && question.against_mass.is_some() {
            return Err(input("give one of against and against_mass"));
        }
        let (normal, normal_frame) = Normal::of_direction(resolved.normal, name);
        Ok(MassQuestion {
            link: contact.link.clone(),
            point: resolved.point.into(),
            normal,
            normal_frame,
            against: resolved.against.map(name),
            ..question
        })
    }
}

/// Python class `percuss.Damping`.
#[derive(FromPyObject)]
pub struct Damping {
    restitution: f64,
    stiffness: f64,
    exponent: Option<f64>,
    speed: Option<f64>,
    law: String,
    separation: Option<String>,
    tools: Vec<String>,
    accuracy: Option<f64>,
    time_step: Option<f64>,
    own_mass: Option<f64>,
    other_own_mass: Option<f64>,
    diagonal_ratio: Option<f64>,
    closed_loops: Option<bool>,
}

impl Damping {
    /// Converts the fields to a damping question of the study crate.
    pub fn question(&self) -> PyResult<DampingQuestion> {
        let mut question = DampingQuestion::new(self.restitution, self.stiffness);
        let end = |name: &String| {
            Separation::from_name(name)
                .ok_or_else(|| input(format_args!("separation is \"{name}\"; expected \"force\" or \"gap\"")))
        };
        let separation = self.separation.as_ref().map(end).transpose()?;
        question.choose(&self.law, self.exponent, separation).map_err(input)?;
        question.speed = self.speed;
        let options = &mut question.options;
        options.accuracy = self.accuracy.unwrap_or(options.accuracy);
        options.time_step = self.time_step;
        options.own_mass = self.own_mass;
        options.other_own_mass = self.other_own_mass;
        options.diagonal_ratio = self.diagonal_ratio;
        options.loops_unknown = self.closed_loops.is_none();
        options.closed_loops = self.closed_loops.unwrap_or_default();
        options.constrained = options.closed_loops;
        for name in &self.tools {
            match name.as_str() {
                "all" => question.tools.extend(Tool::ALL),
                name => question
                    .tools
                    .push(Tool::from_name(name).map_err(|error| of_argument("tools")(input(error)))?),
            }
        }
        question.tools.dedup();
        Ok(question)
    }
}

/// Range of a sweep, from text in command-line syntax or from (joint, from, to, count) in SI units.
pub fn vary(given: &Bound<'_, PyAny>) -> PyResult<Vary> {
    if let Ok(text) = given.extract::<String>() {
        return Vary::parse(&text).map_err(|error| input(format_args!("vary: \"{text}\": {error}")));
    }
    let (joint, from, to, count): (String, f64, f64, usize) =
        given.extract().map_err(|_| input("vary: expected text, or (joint, from, to, count)"))?;
    let number = |value| Quantity::number(value).map_err(|error| input(format_args!("vary: {error}")));
    Ok(Vary { quantity: Varied::Joint(joint), from: number(from)?, to: number(to)?, count })
}

/// Source of the rows of a sweep; `None` if no source is given.
pub fn optional_rows(
    ranges: Option<Vec<Bound<'_, PyAny>>>,
    file: Option<(String, Vec<String>)>,
    random: Option<(usize, u64)>,
) -> PyResult<Option<RowSource>> {
    if ranges.is_none() && file.is_none() && random.is_none() {
        return Ok(None);
    }
    rows(ranges, file, random).map(Some)
}

/// Source of the rows of a sweep. Exactly one source must be given.
pub fn rows(
    ranges: Option<Vec<Bound<'_, PyAny>>>,
    file: Option<(String, Vec<String>)>,
    random: Option<(usize, u64)>,
) -> PyResult<RowSource> {
    match (ranges, file, random) {
        (Some(ranges), ..) if ranges.is_empty() => {
            Err(input("vary: the list is empty; expected at least one range"))
        }
        (Some(ranges), None, None) => Ok(RowSource::Grid(ranges.iter().map(vary).collect::<PyResult<_>>()?)),
        (None, Some((path, ignore)), None) => {
            Ok(RowSource::File(percuss::study::PositionFile { path, ignore, max_size: DEFAULT_MAX_SIZE }))
        }
        (None, None, Some((count, seed))) => Ok(RowSource::Random { count, seed }),
        _ => Err(input("give one of vary, input and random")),
    }
}
