//! Springs, dampers, tyres, anti-roll bars and drives during an impact in time.

use crate::checks::finding::Finding;
use crate::checks::finding_kind::FindingKind;
use crate::damper::sheet_forces::{
    ElementForce, SheetElement, balancing_wheel_forces, joint_springs, sheet_bars, sheet_elements,
    sheet_tyres, torsion_bar_of, torsion_moment,
};
use crate::evaluation::joint_ranges::find_joint;
use crate::evaluation::prepared_question::EvaluatedQuestion;
use crate::question::errors::question_error::{Fault, StudyError};
use crate::question::tables::impact::{ImpactQuestion, SheetSprings};
use crate::values::drives::GivenSpring;
use crate::values::point_force::{Ends, GivenDrive};
use crate::values::rates::rate_dimension;
use percuss_dynamics::Pose;
use percuss_impact::{
    ImpactInTime, ImpactSample, JointSpring, PointSpring, Support, TimeConditions, peak_over_time,
};
use percuss_mechanism::{JointId, LinkId, SpringDamper};
use percuss_spatial::Vector3;
use percuss_units::Dimension;
use schemars::JsonSchema;
use serde::Serialize;
use std::sync::Arc;

/// Spring between two points during an impact in time.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PointSpringRecord {
    /// Named contact of the suspension sheet, or both links of a given spring.
    pub name: String,
    /// Rate, N/m.
    pub rate: f64,
    /// Force at the touch, N, positive in compression; 0 if only the change of the force acts.
    pub force_at_touch: f64,
    /// Force at the end of the contact, N.
    pub force_at_end: f64,
}

/// Damper between two points during an impact in time.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PointDamperRecord {
    /// Named contact of the suspension sheet, or both links of a given damper.
    pub name: String,
    /// Speeds of the force curve, m/s, positive in rebound.
    pub speeds: Vec<f64>,
    /// Force at each speed, N.
    pub forces: Vec<f64>,
}

/// Drive with a constant force during an impact in time.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DriveRecord {
    /// Joint, or both links of a line.
    pub name: String,
    /// Force (N) or moment (N·m): along the motion of the joint, or apart along the line.
    pub value: f64,
    /// Unit of the value.
    pub unit: &'static str,
    /// Work until the largest penetration, J.
    pub work: f64,
}

/// Tyre during an impact in time: a vertical force on the wheel centre that never pulls.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct TyreRecord {
    /// Link of the wheel centre.
    pub name: String,
    /// Vertical stiffness, N/m.
    pub rate: f64,
    /// Damping, N·s/m.
    pub damping: f64,
    /// Force at the touch, N: as given, or the force that balances the springs of this side.
    pub force_at_touch: f64,
    /// Time of the first sample without force, s: the tyre has left the road; null if it keeps contact.
    pub leaves_road_at: Option<f64>,
}

/// Anti-roll bar during an impact in time: the moment of its twist since the touch.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct AntiRollBarRecord {
    /// Hinges of the halves of the bar: one if the model has one side, with the other half at rest.
    pub hinges: Vec<String>,
    /// Torsional stiffness, N·m/rad.
    pub stiffness: f64,
}

/// Spring and damper parallel to a joint during an impact in time: of the model, or given.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct JointSpringRecord {
    /// The joint.
    pub joint: String,
    /// Stiffness, N·m/rad or N/m.
    pub stiffness: f64,
    /// Damping, N·m·s/rad or N·s/m.
    pub damping: f64,
    /// Force or moment of the spring at the touch on the joint, N·m or N; 0 if only the change of the force acts.
    pub force_at_touch: f64,
}

/// The same impact with the change of direction of the forces at the touch.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DirectionChangeRecord {
    /// Restitution.
    pub restitution: f64,
    /// Largest force of the contact, N.
    pub peak_force: f64,
}

/// Spring, damper or drive between points with its name.
type NamedSpring = (String, PointSpring);

/// Forces beside the contact during an impact in time.
pub(super) struct ActingForces {
    /// Springs, dampers and drives between points.
    pub lines: Vec<NamedSpring>,
    /// Springs and drives of joints, and anti-roll bars.
    pub joints: Vec<JointSpring>,
    pub tyres: Vec<(String, Support)>,
    pub bars: Vec<AntiRollBarRecord>,
    drives: Vec<NamedDrive>,
    /// Elements of the sheet that do not act.
    pub left_out: Vec<String>,
}

impl ActingForces {
    /// Forces of the sheet and of the question.
    pub fn new(evaluated: &EvaluatedQuestion, impact: &ImpactQuestion) -> Result<Self, StudyError> {
        let EvaluatedQuestion { prepared, pose, .. } = evaluated;
        let (lines, left_out) = point_springs(evaluated, impact)?;
        let (drives, joints) = (drives(pose, impact)?, springs(pose, impact)?);
        let mode = impact.springs.unwrap_or_default();
        let mut acting = Self { lines, joints, drives, left_out, tyres: Vec::new(), bars: Vec::new() };
        for (joint, spring) in joint_springs(pose) {
            // A given spring takes the place of that of the model.
            if acting.joints.iter().any(|given| given.joint == joint) {
                continue;
            }
            if mode == SheetSprings::None {
                let kind = match (spring.stiffness > 0.0, spring.damping > 0.0) {
                    (true, true) => "spring and damper",
                    (true, false) => "spring",
                    (false, _) => "damper",
                };
                acting.left_out.push(format!("{kind} of {}", pose.mechanism().joint(joint).name()));
                continue;
            }
            let bar = torsion_bar_of(prepared.model, joint);
            if mode == SheetSprings::Full && bar.is_some_and(|bar| bar.preload.is_none()) {
                let why =
                    "torsion_bar: the sheet has no preload, which determines the whole moment of the bar";
                return Err(StudyError::input("impact.springs", why.to_owned()));
            }
            let free_position = (mode == SheetSprings::Full).then_some(spring.reference);
            let SpringDamper { stiffness, damping, .. } = spring;
            acting.joints.push(JointSpring {
                damping,
                free_position,
                ..twist_spring(joint, None, stiffness)
            });
        }
        for drive in &acting.drives {
            match drive.acts {
                Drive::Points(ends) => {
                    let line = PointSpring { drive: drive.value, ..PointSpring::new(ends, 0.0, None) };
                    acting.lines.push((drive.name.clone(), line));
                }
                Drive::Joint(joint) => {
                    acting.joints.push(JointSpring { drive: drive.value, ..twist_spring(joint, None, 0.0) });
                }
            }
        }
        match sheet_bars(prepared.model) {
            Some(_) if mode == SheetSprings::None => acting.left_out.push("anti-roll bar".to_owned()),
            Some(bar) => {
                acting.joints.push(twist_spring(bar.joint, bar.other, bar.stiffness));
                let name = |joint| pose.mechanism().joint(joint).name().to_owned();
                let hinges = [Some(bar.joint), bar.other].into_iter().flatten().map(name).collect();
                acting.bars.push(AntiRollBarRecord { hinges, stiffness: bar.stiffness });
            }
            None => {}
        }
        for tyre in sheet_tyres(prepared.model) {
            let force = match mode {
                SheetSprings::None => Err(String::new()),
                _ => tyre.force_at_touch(evaluated).map_err(|why| format!(" ({why})")),
            };
            match force {
                Ok(force) => acting.tyres.push((
                    tyre.name.to_owned(),
                    Support {
                        link: tyre.link,
                        point: Vector3::zeros(),
                        direction: Vector3::z(),
                        rate: tyre.force.rate,
                        damping: tyre.force.damping,
                        force,
                        is_balanced: mode == SheetSprings::Change,
                    },
                )),
                Err(why) => acting.left_out.push(format!("tyre at {}{why}", tyre.name)),
            }
        }
        Ok(acting)
    }

    /// True without any force.
    pub fn is_empty(&self) -> bool {
        self.lines.is_empty() && self.joints.is_empty() && self.tyres.is_empty()
    }

    /// Forces of all elements at the touch along their motion, N or N·m, for their geometric stiffness: lines, joints, then supports. The springs of the
    /// sheet have their whole forces.
    pub fn at_touch(&self, evaluated: &EvaluatedQuestion) -> Vec<f64> {
        let pose = &evaluated.pose;
        let elements = sheet_elements(evaluated.prepared.model);
        let of_line = |(name, line): &NamedSpring| {
            let element = elements.iter().find(|element| element.name == name);
            let [a, b] = line.ends.map(|(link, point)| pose.link(link).point(&point));
            let own = line.free_length.map(|free| line.rate * (free - (b - a).norm()));
            own.or_else(|| element?.whole_force(evaluated)).unwrap_or(0.0) + line.drive
        };
        let of_joint = |acting: &JointSpring| {
            let own = joint_springs(pose).find(|(joint, _)| *joint == acting.joint && acting.stiffness > 0.0);
            own.map_or(0.0, |(joint, spring)| torsion_moment(evaluated.prepared.model, pose, joint, &spring))
        };
        let of_tyre = |(_, tyre): &(String, Support)| if tyre.is_balanced { 0.0 } else { tyre.force };
        let lines = self.lines.iter().map(of_line).chain(self.joints.iter().map(of_joint));
        lines.chain(self.tyres.iter().map(of_tyre)).collect()
    }

    /// Conditions with the whole forces of the springs of the sheet, which constant vertical forces on the wheel centres balance at the touch. `None` if
    /// the whole forces act in `conditions`, or are unknown.
    pub fn with_whole_forces(
        &self,
        evaluated: &EvaluatedQuestion,
        conditions: &TimeConditions,
    ) -> Option<TimeConditions> {
        let mut whole = TimeConditions { samples_within_steps: 0, ..conditions.clone() };
        let mut has_spring = false;
        for element in sheet_elements(evaluated.prepared.model) {
            let ElementForce::Spring(spring) = &element.force else { continue };
            let is_own = |(name, line): &NamedSpring| name == element.name && line.free_length.is_none();
            let line = self.lines.iter().position(is_own)?;
            let force = element.whole_force(evaluated)?;
            whole.point_springs[line].free_length =
                Some(element.length(&evaluated.pose) + force / spring.rate);
            has_spring |= force != 0.0;
        }
        for (joint, spring) in joint_springs(&evaluated.pose) {
            let Some(bar) = torsion_bar_of(evaluated.prepared.model, joint) else { continue };
            has_spring |= bar.preload? != 0.0;
            let own = whole.springs.iter_mut().find(|own| own.joint == joint && own.stiffness > 0.0)?;
            if own.free_position.is_some() {
                return None;
            }
            own.free_position = Some(spring.reference);
        }
        for (link, force) in balancing_wheel_forces(evaluated)?.into_iter().filter(|_| has_spring) {
            whole.supports.push(Support {
                link,
                point: Vector3::zeros(),
                direction: Vector3::z() * force.signum(),
                rate: 0.0,
                damping: 0.0,
                force: force.abs(),
                is_balanced: false,
            });
        }
        has_spring.then_some(whole)
    }

    /// Drives with their work until the largest penetration.
    pub fn drive_records(&self, touch: &Pose, found: &ImpactInTime) -> Vec<DriveRecord> {
        if self.drives.is_empty() {
            return Vec::new();
        }
        // A force that jumps has two samples at one time.
        let mut samples: Vec<&ImpactSample> = found.samples.iter().collect();
        samples.dedup_by(|a, b| a.time == b.time);
        let times: Vec<f64> = samples.iter().map(|sample| sample.time).collect();
        let depths: Vec<f64> = samples.iter().map(|sample| sample.penetration).collect();
        let deepest = peak_over_time(&times, &depths).map_or(0.0, |(_, time)| time);
        let mut pose = touch.clone();
        let mut travel = |acts: &Drive, sample: &ImpactSample| {
            let moved = pose.move_to(&sample.positions, sample.base).is_ok();
            let value = |pose: &Pose| match acts {
                Drive::Joint(joint) => pose.joint(*joint)[0],
                Drive::Points(ends) => {
                    let [a, b] = ends.map(|(link, point)| pose.link(link).point(&point));
                    (b - a).norm()
                }
            };
            if moved { value(&pose) - value(touch) } else { f64::NAN }
        };
        // The travel at the largest penetration, by the parabola through the nearest three samples.
        let after = times.partition_point(|time| *time < deepest);
        let first = after.saturating_sub(1).min(samples.len().saturating_sub(3));
        let near = first..(first + 3).min(samples.len());
        let mut record = |drive: &NamedDrive| {
            let weight = |i: usize| {
                near.clone()
                    .filter(|j| *j != i)
                    .map(|j| (deepest - times[j]) / (times[i] - times[j]))
                    .product::<f64>()
            };
            let travel: f64 = near.clone().map(|i| weight(i) * travel(&drive.acts, samples[i])).sum();
            DriveRecord {
                name: drive.name.clone(),
                value: drive.value,
                unit: drive.unit,
                work: drive.value * travel,
            }
        };
        self.drives.iter().map(&mut record).collect()
    }

    /// Springs of joints.
    pub fn joint_records(&self, touch: &Pose) -> Vec<JointSpringRecord> {
        let is_spring = |spring: &&JointSpring| {
            spring.other.is_none() && (spring.stiffness > 0.0 || spring.damping > 0.0)
        };
        let record = |spring: &JointSpring| {
            let position = touch.joint(spring.joint)[0];
            JointSpringRecord {
                joint: touch.mechanism().joint(spring.joint).name().to_owned(),
                stiffness: spring.stiffness,
                damping: spring.damping,
                force_at_touch: spring.stiffness * (spring.free_position.unwrap_or(position) - position),
            }
        };
        let bars = self.bars.iter().flat_map(|bar| &bar.hinges);
        let is_bar = |record: &JointSpringRecord| bars.clone().any(|hinge| *hinge == record.joint);
        self.joints.iter().filter(is_spring).map(record).filter(|record| !is_bar(record)).collect()
    }

    /// Dampers between points.
    pub fn damper_records(&self) -> Vec<PointDamperRecord> {
        let record = |(name, line): &NamedSpring| {
            let curve = line.damper.as_ref()?;
            let (speeds, forces) = (curve.speeds().to_vec(), curve.forces().to_vec());
            Some(PointDamperRecord { name: name.clone(), speeds, forces })
        };
        self.lines.iter().filter_map(record).collect()
    }

    /// Warnings about dampers that are faster than their force curves.
    pub fn damper_findings(&self, touch: &Pose, found: &ImpactInTime) -> Vec<Finding> {
        let mut pose = touch.clone();
        let finding = |(name, line): &NamedSpring| {
            let curve = line.damper.as_ref().filter(|curve| curve.speeds().len() > 2)?;
            let mut lengths = Vec::with_capacity(found.samples.len());
            for sample in &found.samples {
                pose.move_to(&sample.positions, sample.base).ok()?;
                let [a, b] = line.ends.map(|(link, point)| pose.link(link).point(&point));
                lengths.push(((b - a).norm(), sample.time));
            }
            let pairs = lengths.windows(2).filter(|pair| pair[1].1 > pair[0].1);
            let speed = |pair: &[(f64, f64)]| (pair[1].0 - pair[0].0) / (pair[1].1 - pair[0].1);
            let (first, last) = (*curve.speeds().first()?, *curve.speeds().last()?);
            let beyond = pairs.map(speed).map(|v| (v, (v - last).max(first - v)));
            let (speed, beyond) = beyond.max_by(|a, b| a.1.total_cmp(&b.1))?;
            (beyond > 0.0).then(|| {
                let message = format!(
                    "{name}: the damper reaches {speed:.2} m/s, and its force curve is given from {first:.2} to {last:.2} m/s; the last slope is \
                     extrapolated"
                );
                Finding::about_result(FindingKind::ForceBeyondData, message)
            })
        };
        self.lines.iter().filter_map(finding).collect()
    }

    /// Springs between points with their forces at the touch and at the end.
    pub fn spring_records(&self, touch: &Pose, found: &ImpactInTime) -> Vec<PointSpringRecord> {
        let mut end = touch.clone();
        let moved = found.samples.last().is_some_and(|last| end.move_to(&last.positions, last.base).is_ok());
        let record = |(name, spring): &NamedSpring| {
            let length = |pose: &Pose| {
                let [a, b] = spring.ends.map(|(link, point)| pose.link(link).point(&point));
                (b - a).norm()
            };
            let free = spring.free_length.unwrap_or_else(|| length(touch));
            let force = |pose: &Pose| spring.rate * (free - length(pose));
            let force_at_end = if moved { force(&end) } else { f64::NAN };
            PointSpringRecord {
                name: name.clone(),
                rate: spring.rate,
                force_at_touch: force(touch),
                force_at_end,
            }
        };
        self.lines.iter().filter(|(_, spring)| spring.rate > 0.0).map(record).collect()
    }

    /// Tyres with their forces at the touch.
    pub fn tyre_records(&self, touch: &Pose, found: &ImpactInTime) -> Vec<TyreRecord> {
        let mut pose = touch.clone();
        let mut record = |(name, support): &(String, Support)| {
            let height = |pose: &Pose| support.direction.dot(&pose.link(support.link).point(&support.point));
            let start = height(touch);
            let mut last = None;
            let mut has_left = |sample: &&ImpactSample| {
                let moved = pose.move_to(&sample.positions, sample.base).is_ok();
                let at = if moved { height(&pose) - start } else { f64::NAN };
                let rate = last.replace((sample.time, at)).map_or(0.0, |(time, before): (f64, f64)| {
                    if sample.time > time { (at - before) / (sample.time - time) } else { 0.0 }
                });
                support.force > 0.0 && support.force_at(at, rate) == 0.0
            };
            TyreRecord {
                name: name.clone(),
                rate: support.rate,
                damping: support.damping,
                force_at_touch: support.force,
                leaves_road_at: found.samples.iter().find(&mut has_left).map(|sample| sample.time),
            }
        };
        self.tyres.iter().map(&mut record).collect()
    }
}

/// Spring that resists the change of the position of a joint since the touch, or of the difference of two.
fn twist_spring(joint: JointId, other: Option<JointId>, stiffness: f64) -> JointSpring {
    JointSpring { joint, other, stiffness, damping: 0.0, free_position: None, drive: 0.0 }
}

/// Springs and dampers between points: those of the sheet and the given ones, each with its name; and those of the sheet that are left out.
fn point_springs(
    evaluated: &EvaluatedQuestion,
    impact: &ImpactQuestion,
) -> Result<(Vec<NamedSpring>, Vec<String>), StudyError> {
    let EvaluatedQuestion { prepared, pose, .. } = evaluated;
    let (mut acting, mut left_out) = (Vec::new(), Vec::new());
    let mode = impact.springs.unwrap_or_default();
    for element in sheet_elements(prepared.model) {
        let SheetElement { name, ends, force } = &element;
        let line = match (mode, force) {
            (SheetSprings::None, _) => {
                left_out.push((*name).to_owned());
                continue;
            }
            (_, ElementForce::Damper(curve)) => {
                PointSpring { damper: Some(Arc::clone(curve)), ..PointSpring::new(*ends, 0.0, None) }
            }
            (SheetSprings::Change, ElementForce::Spring(spring)) => {
                PointSpring::new(*ends, spring.rate, None)
            }
            (SheetSprings::Full, ElementForce::Spring(spring)) => {
                let missing = || {
                    let why = format!(
                        "{name}: the sheet has no preload, which determines the whole force of the spring"
                    );
                    StudyError::input("impact.springs", why)
                };
                let force = element.whole_force(evaluated).ok_or_else(missing)?;
                PointSpring::new(*ends, spring.rate, Some(element.length(pose) + force / spring.rate))
            }
        };
        acting.push(((*name).to_owned(), line));
    }
    for given in &impact.spring {
        let ends = find_ends(pose, &given.ends, "impact.spring")?;
        acting.push((name_of(&given.ends), PointSpring::new(ends, given.rate, given.free_length)));
    }
    for given in &impact.damper {
        let ends = find_ends(pose, &given.ends, "impact.damper")?;
        let damper = Some(Arc::clone(&given.curve));
        acting.push((name_of(&given.ends), PointSpring { damper, ..PointSpring::new(ends, 0.0, None) }));
    }
    Ok((acting, left_out))
}

/// Ends of a line in the mechanism of a pose.
fn find_ends(
    pose: &Pose,
    ends: &Ends,
    field: &'static str,
) -> Result<[(LinkId, Vector3<f64>); 2], StudyError> {
    let find = |(link, point): &(String, [f64; 3])| match pose.mechanism().find_link(link) {
        Ok(link) => Ok((link, Vector3::from(*point))),
        Err(error) => Err(StudyError::input(field, error)),
    };
    Ok([find(&ends[0])?, find(&ends[1])?])
}

/// Name of a line: both links.
fn name_of([(a, _), (b, _)]: &Ends) -> String {
    format!("{a} to {b}")
}

/// Place at which a drive acts.
enum Drive {
    Joint(JointId),
    Points([(LinkId, Vector3<f64>); 2]),
}

/// Drive with its name and its force or moment.
struct NamedDrive {
    name: String,
    value: f64,
    unit: &'static str,
    acts: Drive,
}

/// Given drives.
fn drives(pose: &Pose, impact: &ImpactQuestion) -> Result<Vec<NamedDrive>, StudyError> {
    let drive = |given: &GivenDrive| match given {
        GivenDrive::Points(ends, force) => Ok(NamedDrive {
            name: name_of(ends),
            value: *force,
            unit: "N",
            acts: Drive::Points(find_ends(pose, ends, "impact.drive")?),
        }),
        GivenDrive::Joint(name, value) => {
            let joint = find_joint(pose.mechanism(), "impact.drive", name)?;
            let kind = pose.mechanism().joint(joint).kind();
            if kind.dofs() != 1 {
                let why =
                    format!("joint \"{name}\" has {} velocities; expected a joint with one", kind.dofs());
                return Err(StudyError::input("impact.drive", why));
            }
            let turns = rate_dimension(kind, 0) == Dimension::AngularSpeed;
            let (dimension, unit) = if turns { (Dimension::Moment, "N·m") } else { (Dimension::Force, "N") };
            let wrong =
                |source| StudyError::input("impact.drive", Fault::Position { joint: name.clone(), source });
            let value = value.in_dimension(dimension, &value.to_string()).map_err(wrong)?;
            Ok(NamedDrive { name: name.clone(), value, unit, acts: Drive::Joint(joint) })
        }
    };
    impact.drive.iter().map(drive).collect()
}

/// Springs of the joints.
fn springs(pose: &Pose, impact: &ImpactQuestion) -> Result<Vec<JointSpring>, StudyError> {
    let spring = |(number, (name, given)): (usize, &(String, GivenSpring))| {
        if impact.joint_spring[..number].iter().any(|(earlier, _)| earlier == name) {
            let why = format!("joint \"{name}\" is given twice; give it once");
            return Err(StudyError::input("impact.joint_spring", why));
        }
        let joint = find_joint(pose.mechanism(), "impact.joint_spring", name)?;
        let refuse = |fault: Fault| StudyError::input("impact.joint_spring", fault);
        let values = given.values_for_joint(pose.mechanism().joint(joint).kind());
        let values = values.map_err(|source| refuse(Fault::Position { joint: name.clone(), source }))?;
        let (stiffness, damping, free_position) = match values[..] {
            [stiffness] => (stiffness, 0.0, None),
            [stiffness, damping] => (stiffness, damping, None),
            [stiffness, damping, free] => (stiffness, damping, Some(free)),
            _ => {
                let got = values.len();
                let why = format!("joint \"{name}\": {got} numbers are given; expected K, K,D or K,D,FREE");
                return Err(refuse(why.into()));
            }
        };
        Ok(JointSpring { joint, other: None, stiffness, damping, free_position, drive: 0.0 })
    };
    impact.joint_spring.iter().enumerate().map(spring).collect()
}
