//! The same contact over a range of positions; loops stay closed along one branch.

use crate::estimate::estimate;
use crate::mass::{Status, pose_record};
use crate::quantity::{Dimension, Quantity, parse_triple, position_dimension};
use crate::question::{MassQuestion, StudyError};
use crate::{DiagnosticRecord, Model, findings};
use nalgebra::Vector3;
use percuss_dynamics::{
    Configuration, Contact, EffectiveMass, PointVelocity, Pose, RouteChoice, Strike, System,
};
use percuss_mechanism::{JointId, JointKind, LinkId, Mechanism};
use serde::Serialize;
use std::collections::BTreeMap;
use std::sync::Arc;

/// What is varied.
#[derive(Clone, Debug, PartialEq)]
pub enum Varied {
    /// A driving joint with one position.
    Joint(String),
    /// The displacement of a point (m, link's frame) of a link along a direction (world axes), from where it is with
    /// the joints as set.
    Travel {
        /// The link.
        link: String,
        /// The point.
        point: [f64; 3],
        /// The direction; its length does not matter.
        direction: [f64; 3],
    },
}

/// A range of values, ends included, rad or m.
#[derive(Clone, Debug, PartialEq)]
pub struct Vary {
    /// What is varied.
    pub what: Varied,
    /// First value, as typed.
    pub from: String,
    /// Last value, as typed.
    pub to: String,
    /// How many values.
    pub count: usize,
}

/// Rows are limited to so many.
const MOST_ROWS: usize = 1_000_000;

impl Vary {
    /// Reads `JOINT=FROM:TO:COUNT` or `travel:LINK:X,Y,Z:DX,DY,DZ=FROM:TO:COUNT`.
    ///
    /// # Errors
    /// What is wrong, and how it should look.
    pub fn parse(text: &str) -> Result<Self, String> {
        let wanted = "wanted JOINT=FROM:TO:COUNT, such as hinge=-30deg:30deg:61, or \
                      travel:LINK:X,Y,Z:DX,DY,DZ=FROM:TO:COUNT";
        let (what, range) = text.rsplit_once('=').ok_or(wanted)?;
        let parts: Vec<&str> = range.split(':').collect();
        let [from, to, count] = parts[..] else { return Err(wanted.into()) };
        let count: usize =
            count.trim().parse().map_err(|_| format!("COUNT is \"{count}\"; a whole number is wanted"))?;
        if count == 0 || count > MOST_ROWS {
            return Err(format!("COUNT is {count}; 1 to {MOST_ROWS} rows are possible"));
        }
        for end in [from, to] {
            Quantity::parse(end).map_err(|e| e.to_string())?;
        }
        let what = match what.strip_prefix("travel:") {
            None if what.is_empty() => return Err(wanted.into()),
            None => Varied::Joint(what.to_owned()),
            Some(rest) => {
                let mut parts = rest.rsplitn(3, ':');
                let (direction, point, link) = (parts.next(), parts.next(), parts.next());
                let (Some(direction), Some(point), Some(link)) = (direction, point, link) else {
                    return Err(wanted.into());
                };
                Varied::Travel {
                    link: link.to_owned(),
                    point: parse_triple(point, Dimension::Length).map_err(|e| e.to_string())?,
                    direction: parse_triple(direction, Dimension::Plain).map_err(|e| e.to_string())?,
                }
            }
        };
        Ok(Self { what, from: from.to_owned(), to: to.to_owned(), count })
    }

    /// As a column is headed.
    pub fn name(&self) -> String {
        match &self.what {
            Varied::Joint(joint) => joint.clone(),
            Varied::Travel { link, .. } => format!("travel:{link}"),
        }
    }

    fn values(&self, dimension: Dimension) -> Result<Vec<f64>, StudyError> {
        let value = |text: &str| {
            Quantity::parse(text)
                .and_then(|q| q.of(dimension, text))
                .map_err(|e| StudyError::Vary { what: self.name(), why: e.to_string() })
        };
        let (from, to) = (value(&self.from)?, value(&self.to)?);
        let steps = self.count.saturating_sub(1).max(1) as f64;
        Ok((0..self.count).map(|i| from + (to - from) * (i as f64 / steps)).collect())
    }
}

/// A row of a sweep.
#[derive(Clone, Debug, Serialize)]
pub struct SweepRow {
    /// Its number, from 0.
    pub row: usize,
    /// Value of what is varied, rad or m.
    pub value: f64,
    /// `finite`, `immovable`, `massless`, `unreachable`, or `no answer` where the contact means nothing here.
    pub status: &'static str,
    /// m̄, kg; null unless finite.
    pub effective_mass: Option<f64>,
    /// First-order bound on its error, kg.
    pub effective_mass_error: Option<f64>,
    /// How far loops are from closed, m.
    pub closure_residual: Option<f64>,
    /// Whether branches cross here; null where the row was not reached.
    pub singular_pose: Option<bool>,
    /// Speed of the estimate's point A, or of the travelling point along its direction, per unit closing speed
    /// ("A over contact"); its inverse is "contact over A".
    pub motion_ratio: Option<f64>,
    /// The classical estimate, kg.
    pub estimate: Option<f64>,
    /// By how much it is off, per cent.
    pub estimate_error_percent: Option<f64>,
    /// Position of every movable joint.
    pub pose: BTreeMap<String, Vec<f64>>,
    /// Why there is no answer.
    pub error: Option<String>,
}

/// A sweep.
#[derive(Clone, Debug, Serialize)]
pub struct SweepReport {
    /// `percuss.sweep/1`.
    pub schema: &'static str,
    /// Version of percuss.
    pub percuss: &'static str,
    /// The file.
    pub inputs: Vec<crate::Input>,
    /// What is varied.
    pub varied: String,
    /// `rad` or `m`.
    pub unit: &'static str,
    /// The struck link.
    pub link: String,
    /// All rows.
    pub rows: Vec<SweepRow>,
    /// What was found, in the file and in the rows.
    pub diagnostics: Vec<DiagnosticRecord>,
}

/// Answers a contact over a range; `progress` is told rows done and rows in all.
///
/// A point or normal given in another frame is taken over at the first row's pose. A row that cannot be reached says so,
/// and the sweep goes on from the last that was.
///
/// # Errors
/// [`StudyError`]: names that nothing bears, something that cannot be varied, a contact that means nothing.
pub fn sweep(
    model: &Model,
    question: &MassQuestion,
    vary: &Vary,
    progress: &mut dyn FnMut(usize, usize),
) -> Result<SweepReport, StudyError> {
    let mechanism = &model.mechanism;
    let system = question.system(mechanism)?;
    let course = Course::new(&system, question, vary)?;
    let values = vary.values(course.dimension())?;
    let mut rows: Vec<SweepRow> = Vec::with_capacity(values.len());
    let mut last: Option<Pose> = course.start.clone();
    let mut contact: Option<Contact> = None;
    let mut findings = Findings::default();
    for (row, value) in values.into_iter().enumerate() {
        let answer = match course.pose(&system, last.as_ref(), value) {
            Ok(Err(missed)) => Ok(unanswered(row, value, UNREACHABLE, missed)),
            Ok(Ok(pose)) => {
                let located = match contact {
                    Some(contact) => contact,
                    None => *contact.insert(question.contact(&system, &pose)?),
                };
                let answer =
                    answered(model, &system, question, &course, &pose, &located, row, value, &mut findings);
                last = Some(pose);
                answer
            }
            Err(error) if error.is_no_answer() => Ok(unanswered(row, value, UNREACHABLE, error.to_string())),
            Err(error) => Err(error),
        };
        rows.push(match answer {
            Ok(answer) => answer,
            // What is wrong from the start is wrong with the question; later it is wrong with a row.
            Err(error) if rows.iter().any(|row| row.error.is_none()) => {
                unanswered(row, value, "no answer", error.to_string())
            }
            Err(error) => return Err(error),
        });
        progress(row + 1, vary.count);
    }
    let diagnostics = model.diagnostics.iter().cloned().chain(findings.told(rows.len())).collect();
    Ok(SweepReport {
        schema: "percuss.sweep/1",
        percuss: env!("CARGO_PKG_VERSION"),
        inputs: model.inputs.clone(),
        varied: vary.name(),
        unit: if course.dimension() == Dimension::Angle { "rad" } else { "m" },
        link: question.link.clone(),
        rows,
        diagnostics,
    })
}

const UNREACHABLE: &str = "unreachable";

/// What was found in the rows: each thing once, with where and how often.
#[derive(Default)]
struct Findings {
    /// Finding, first row, number of rows, by code and what it is about.
    kinds: BTreeMap<(&'static str, String), (DiagnosticRecord, usize, usize)>,
}

impl Findings {
    fn add(&mut self, row: usize, records: impl IntoIterator<Item = DiagnosticRecord>) {
        for record in records {
            let about = record.message.split('"').nth(1).unwrap_or_default().to_owned();
            self.kinds.entry((record.code, about)).or_insert((record, row, 0)).2 += 1;
        }
    }

    fn told(self, rows: usize) -> impl Iterator<Item = DiagnosticRecord> {
        self.kinds.into_values().map(move |(mut record, first, count)| {
            if count < rows {
                record.message += &match count {
                    1 => format!(" (row {first})"),
                    _ => format!(" (row {first}, and {} more)", count - 1),
                };
            }
            record
        })
    }
}

fn unanswered(row: usize, value: f64, status: &'static str, error: String) -> SweepRow {
    SweepRow {
        row,
        value,
        status,
        effective_mass: None,
        effective_mass_error: None,
        closure_residual: None,
        singular_pose: None,
        motion_ratio: None,
        estimate: None,
        estimate_error_percent: None,
        pose: BTreeMap::new(),
        error: Some(error),
    }
}

#[expect(clippy::too_many_arguments, reason = "one row of `sweep`, which owns all of these")]
fn answered(
    model: &Model,
    system: &System,
    question: &MassQuestion,
    course: &Course,
    pose: &Pose,
    contact: &Contact,
    row: usize,
    value: f64,
    findings: &mut Findings,
) -> Result<SweepRow, StudyError> {
    let strike = system.strike(pose, contact, RouteChoice::Auto)?;
    findings.add(row, findings::about_pose(system, pose));
    findings.add(row, findings::about_strike(system, contact, &strike));
    if strike.singular_pose {
        let limits = system.branch_limits(pose, contact);
        findings.add(row, findings::about_branches(system, pose, &strike, &limits));
    }
    findings.add(row, findings::about_holds(model, question, pose, contact)?);
    let beside = question.estimate.as_ref().map(|e| estimate(system, pose, &strike, e)).transpose()?;
    let motion_ratio = match &beside {
        Some(estimate) => estimate.motion_ratio,
        None => course.motion_ratio(system, pose, &strike),
    };
    let strike = match question.against_mass {
        Some(other) => strike.against_mass(other),
        None => strike,
    };
    let (status, effective_mass) = match strike.effective_mass {
        EffectiveMass::Finite(m) => (Status::Finite, Some(m)),
        EffectiveMass::Immovable => (Status::Immovable, None),
        EffectiveMass::Massless => (Status::Massless, None),
    };
    Ok(SweepRow {
        row,
        value,
        status: status.name(),
        effective_mass,
        effective_mass_error: strike.effective_mass_error,
        closure_residual: pose.loops().map(|l| l.residual),
        singular_pose: Some(strike.singular_pose),
        motion_ratio,
        estimate: beside.as_ref().and_then(|e| e.estimate),
        estimate_error_percent: beside.as_ref().and_then(|e| e.error_percent),
        pose: pose_record(system.mechanism(), pose),
        error: None,
    })
}

/// How a value becomes a pose.
struct Course {
    joint: JointId,
    base: Configuration,
    travel: Option<Travel>,
    /// The pose that travel is measured from.
    start: Option<Pose>,
}

struct Travel {
    link: LinkId,
    point: Vector3<f64>,
    direction: Vector3<f64>,
    origin: Vector3<f64>,
}

impl Course {
    fn new(system: &System, question: &MassQuestion, vary: &Vary) -> Result<Self, StudyError> {
        let mechanism = system.mechanism();
        let base = question.configuration(mechanism)?;
        let refuse = |why: String| StudyError::Vary { what: vary.name(), why };
        match &vary.what {
            Varied::Joint(name) => {
                let joint = mechanism.find_joint(name)?;
                let found = mechanism.joint(joint);
                if found.kind().positions() != 1 {
                    return Err(refuse(format!(
                        "a {} joint has no single position to vary",
                        found.kind().name()
                    )));
                }
                if let Some(mimic) = found.mimic() {
                    return Err(refuse(format!(
                        "it mimics \"{}\"; vary that",
                        mechanism.joint(mimic.master).name()
                    )));
                }
                if question.set.iter().any(|(set, _)| set == name) {
                    return Err(refuse("it is --set already; give it one or the other".into()));
                }
                Ok(Self { joint, base, travel: None, start: None })
            }
            Varied::Travel { link, point, direction } => {
                let link = mechanism.find_link(link)?;
                let (point, direction) = (Vector3::from(*point), Vector3::from(*direction));
                if !(direction.norm() >= 1e-9 && direction.norm().is_finite()) {
                    return Err(refuse("its direction has no length".into()));
                }
                let direction = direction.normalize();
                let start = system.pose(&base)?;
                let origin = start.link(system, link).point(&point);
                let travel = Travel { link, point, direction, origin };
                let joint = driver_of(system, question, &base, &start, &travel)?.ok_or_else(|| {
                    refuse("no joint that is free to drive moves this point that way".into())
                })?;
                Ok(Self { joint, base, travel: Some(travel), start: Some(start) })
            }
        }
    }

    fn dimension(&self) -> Dimension {
        match self.travel {
            Some(_) => Dimension::Length,
            None => position_dimension(self.kind(), 0),
        }
    }

    fn kind(&self) -> JointKind {
        self.base.mechanism().joint(self.joint).kind()
    }

    /// The pose at a value of what is varied, on the branch of the last one; or why the point does not get there.
    fn pose(
        &self,
        system: &System,
        last: Option<&Pose>,
        value: f64,
    ) -> Result<Result<Pose, String>, StudyError> {
        match (&self.travel, last) {
            (None, last) => at(system, &self.base, last, self.joint, value).map(Ok),
            (Some(travel), Some(last)) => self.travelled(system, last, travel, value),
            (Some(_), None) => unreachable!("travel starts from a pose"),
        }
    }

    /// Moves the driver until the point has gone the way that is wanted: secant steps, to 1e-12 of the size. A step beyond
    /// the end of the mechanism's range is halved until it is none.
    fn travelled(
        &self,
        system: &System,
        last: &Pose,
        travel: &Travel,
        wanted: f64,
    ) -> Result<Result<Pose, String>, StudyError> {
        const STEPS: usize = 60;
        let size = system.mechanism().characteristic_length();
        let gone = |pose: &Pose| {
            travel.direction.dot(&(pose.link(system, travel.link).point(&travel.point) - travel.origin))
        };
        let value = |pose: &Pose| pose.joint(self.joint)[0];
        let mut from = last.clone();
        let probe = 1e-4 * if self.kind() == JointKind::Prismatic { size } else { 1.0 };
        let mut to = at(system, &self.base, Some(&from), self.joint, value(&from) + probe)
            .or_else(|_| at(system, &self.base, Some(&from), self.joint, value(&from) - probe))?;
        let mut nearest = gone(&from);
        for _ in 0..STEPS {
            let (miss, before) = (gone(&to) - wanted, gone(&from) - wanted);
            if miss.abs() <= 1e-12 * size {
                return Ok(Ok(to));
            }
            if miss.abs() < (nearest - wanted).abs() {
                nearest = gone(&to);
            }
            let slope = (miss - before) / (value(&to) - value(&from));
            let limit = 0.2 * probe / 1e-4;
            let mut step = (-miss / slope).clamp(-limit, limit);
            let next = loop {
                if !step.is_finite() || value(&to) + step == value(&to) {
                    break None;
                }
                match at(system, &self.base, Some(&to), self.joint, value(&to) + step) {
                    Ok(next) => break Some(next),
                    Err(error) if error.is_no_answer() => step *= 0.5,
                    Err(error) => return Err(error),
                }
            };
            let Some(next) = next else { break };
            from = std::mem::replace(&mut to, next);
        }
        // Rounding of the pose, not a miss, where a point far from the joint moves fast.
        if (gone(&to) - wanted).abs() <= 1e-9 * size {
            return Ok(Ok(to));
        }
        Ok(Err(format!("a travel of {wanted} m cannot be reached; nearest reached: {nearest:.6} m")))
    }

    fn motion_ratio(&self, system: &System, pose: &Pose, strike: &Strike) -> Option<f64> {
        let travel = self.travel.as_ref()?;
        match system.point_velocity(pose, strike, travel.link, &travel.point)? {
            PointVelocity::Known(v) => Some(pose.base().vector(&v).dot(&travel.direction).abs()),
            PointVelocity::Undetermined => None,
        }
    }
}

/// The pose with one more joint set, followed from another pose where there is one.
fn at(
    system: &System,
    base: &Configuration,
    last: Option<&Pose>,
    joint: JointId,
    value: f64,
) -> Result<Pose, StudyError> {
    let mut configuration = base.clone();
    configuration.set(system.mechanism().joint(joint).name(), &[value])?;
    Ok(match last {
        Some(last) => system.pose_from(last, &configuration.without_guesses())?,
        None => system.pose(&configuration)?,
    })
}

/// The free joint that moves the point most along its direction.
fn driver_of(
    system: &System,
    question: &MassQuestion,
    base: &Configuration,
    start: &Pose,
    travel: &Travel,
) -> Result<Option<JointId>, StudyError> {
    let mechanism: &Arc<Mechanism> = system.mechanism();
    let candidates: Vec<JointId> = mechanism
        .joint_ids()
        .filter(|id| {
            let joint = mechanism.joint(*id);
            joint.kind().positions() == 1
                && joint.mimic().is_none()
                && !question.set.iter().any(|(set, _)| set == joint.name())
        })
        .collect();
    let size = mechanism.characteristic_length();
    let mut best: Option<(f64, JointId)> = None;
    for joint in candidates {
        let small = 1e-4 * if mechanism.joint(joint).kind() == JointKind::Prismatic { size } else { 1.0 };
        let value = start.joint(joint)[0];
        // A joint that follows from loops cannot be set, or only with others: then it drives nothing here.
        let Ok(moved) = at(system, base, Some(start), joint, value + small) else { continue };
        let way =
            travel.direction.dot(&(moved.link(system, travel.link).point(&travel.point) - travel.origin));
        let speed = (way / small).abs();
        if speed > 1e-6 * size && best.is_none_or(|(most, _)| speed > most) {
            best = Some((speed, joint));
        }
    }
    Ok(best.map(|(_, joint)| joint))
}
