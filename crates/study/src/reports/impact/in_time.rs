//! Impact in time with the contact law, as a record.

use crate::checks::finding::Finding;
use crate::checks::finding_kind::FindingKind;
use crate::damper::damped_contact::no_damper;
use crate::damper::damping::{contact, contact_damper, impact_over_stroke};
use crate::damper::penetration::PenetrationPath;
use crate::damper::sheet_forces::{ElementForce, SheetElement, sheet_elements};
use crate::evaluation::prepared_question::EvaluatedQuestion;
use crate::evaluation::status::Status;
use crate::question::errors::question_error::{Fault, StudyError};
use crate::question::field::Field;
use crate::question::tables::impact::{ImpactQuestion, SheetSprings};
use crate::reports::impact::additions::find_joint;
use crate::reports::impact::errors::impact_error;
use crate::reports::impact::reactions::{ReactionPlace, ReactionRecord, records};
use crate::thresholds::{CREATED_RESTITUTION, STROKES};
use crate::values::drives::GivenSpring;
use crate::values::point_force::{Ends, GivenDrive};
use crate::values::rates::rate_dimension;
use percuss_contact::{Damper, Separation, StiffnessLaw, VaryingMassImpact};
use percuss_dynamics::Pose;
use percuss_impact::{
    ImpactInTime, ImpactSample, JointSpring, PointSpring, RigidImpact, TimeConditions, impact_in_time,
    peak_over_time,
};
use percuss_mechanism::{JointId, LinkId};
use percuss_spatial::Vector3;
use percuss_units::Dimension;
use schemars::JsonSchema;
use serde::Serialize;
use std::sync::Arc;

/// Further samples within each step of the integration, for smooth curves and for maxima between the steps.
const SAMPLES_WITHIN_STEPS: usize = 9;

/// Force in one bearing over the time of an impact.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct BearingForceRecord {
    /// Place.
    pub place: ReactionPlace,
    /// Name of the joint or closure; of the held link; of the root link.
    pub name: String,
    /// Magnitude of the force at each time, N: of the components that redundant loops leave determinate.
    pub force: Vec<f64>,
    /// Largest magnitude, N.
    pub peak_force: f64,
    /// Time of the largest magnitude, s.
    pub peak_time: f64,
    /// For comparison: reaction per unit impulse at the touch, times the largest contact force of the impact in time, N.
    pub estimate: f64,
    /// True for each component (two transverse directions, the axis of the joint) that redundant loops leave open.
    pub open_components: [bool; 3],
}

/// Motion of a joint over the time of an impact.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct JointMotionRecord {
    /// The joint.
    pub joint: String,
    /// Velocities of the joint at each time, rad/s or m/s.
    pub rates: Vec<Vec<f64>>,
}

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

/// Energies of an impact in time, J. Kinetic energies include a free body on the other side.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct EnergyRecord {
    /// Kinetic energy at the touch.
    pub kinetic_before: f64,
    /// Kinetic energy at the end.
    pub kinetic_after: f64,
    /// Work that the contact takes.
    pub taken_by_contact: f64,
    /// Work of gravity, springs and dampers on the mechanism.
    pub work_of_other_forces: f64,
    /// Error of the balance: after − before + taken by the contact − work of the other forces.
    pub residual: f64,
}

/// Impact in time with a compliant contact.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ImpactTimeRecord {
    /// Restitution that is reached: separation speed divided by closing speed.
    pub restitution: f64,
    /// Duration of the contact, s.
    pub duration: f64,
    /// Largest penetration, m.
    pub max_penetration: f64,
    /// Largest force of the contact, N.
    pub peak_force: f64,
    /// Relative change of m̄ from the touch to the largest penetration; null if m̄ is not finite there. The change is unbounded near a pose
    /// at which the contact is immovable.
    pub mass_change: Option<f64>,
    /// The impact of a mechanism of one degree of freedom by m̄ over the penetration alone; null for others, with gravity, or if the
    /// motion ends before.
    pub one_freedom: Option<VaryingMassImpact>,
    /// Gravity, world axes, m/s².
    pub gravity_world: [f64; 3],
    /// Springs between points that act.
    pub springs: Vec<PointSpringRecord>,
    /// Dampers between points that act.
    pub dampers: Vec<PointDamperRecord>,
    /// Drives that act.
    pub drives: Vec<DriveRecord>,
    /// Effective weight of absorber catalogues, kg (kg·m² for a moment): m̄ + 2W/v² with the work W of the drives until the largest
    /// penetration and the closing speed v. It is no mass of the mechanism; null without drives.
    pub effective_weight: Option<f64>,
    /// Springs and dampers of the suspension sheet that are left out.
    pub springs_left_out: Vec<String>,
    /// Energies of the motion.
    pub energy: EnergyRecord,
    /// Largest gap of the loops during the motion, m: error of the integration.
    pub loop_gap: f64,
    /// Times since the touch, s.
    pub times: Vec<f64>,
    /// Penetration at each time, m.
    pub penetration: Vec<f64>,
    /// Closing speed at each time, m/s.
    pub closing_speed: Vec<f64>,
    /// Force of the contact at each time, N.
    pub force: Vec<f64>,
    /// m̄ at each time, kg; null if not finite.
    pub effective_mass: Vec<Option<f64>>,
    /// Velocities of the movable joints.
    pub joints: Vec<JointMotionRecord>,
    /// Forces in the bearings.
    pub bearings: Vec<BearingForceRecord>,
}

/// Impact in time; `None` unless requested.
pub(crate) fn in_time(
    evaluated: &EvaluatedQuestion,
    impact: &ImpactQuestion,
    rigid: &RigidImpact,
    held: &[String],
) -> Result<Option<ImpactTimeRecord>, StudyError> {
    let EvaluatedQuestion { prepared, pose, contact: touched, result } = evaluated;
    let law = impact.contact_law(rigid.closing_speed).filter(|_| impact.in_time);
    let Some(law) = law else { return Ok(None) };
    let own = result.mechanism_response().effective_mass;
    let mass = result.response.effective_mass.kilograms();
    let mass = mass.ok_or_else(|| StudyError::NoDamper(no_damper(Status::Immovable)))?;
    let compliant = contact(&law, mass)?;
    let damper = contact_damper(&law, compliant)?;
    let gravity = impact.gravity().unwrap_or_default();
    let (mut lines, springs_left_out) = point_springs(evaluated, impact)?;
    let drives = drives(pose, impact)?;
    lines.extend(drives.iter().filter_map(|drive| match drive.acts {
        Drive::Points(ends) => Some((
            drive.name.clone(),
            PointSpring { drive: drive.value, ..PointSpring::new(ends, 0.0, None) },
        )),
        Drive::Joint(_) => None,
    }));
    let of_joints = drives.iter().filter_map(|drive| match drive.acts {
        Drive::Joint(joint) => {
            Some(JointSpring { joint, stiffness: 0.0, damping: 0.0, free_position: None, drive: drive.value })
        }
        Drive::Points(_) => None,
    });
    let conditions = TimeConditions {
        gravity: Vector3::from(gravity),
        other_mass: prepared.other_mass(),
        ends_without_force: matches!(
            damper,
            Damper::KelvinVoigt { separation: Separation::ForceVanishes, .. }
        ),
        springs: springs(pose, impact)?.into_iter().chain(of_joints).collect(),
        point_springs: lines.iter().map(|(_, spring)| spring.clone()).collect(),
        corners: match compliant.stiffness() {
            StiffnessLaw::Curve(curve) => curve.deflections()[1..].to_vec(),
            StiffnessLaw::Power { .. } => Vec::new(),
        },
        samples_within_steps: SAMPLES_WITHIN_STEPS,
    };
    let force = |penetration: f64, rate: f64| damper.force(compliant, penetration, rate);
    let found = impact_in_time(pose, touched, rigid.closing_speed, &rigid.before, &force, &conditions)
        .map_err(|error| impact_error(error, impact))?;
    let is_single = pose.degrees_of_freedom() == 1 && prepared.other_mass().is_none();
    let is_free = impact.gravity.is_empty() && conditions.springs.is_empty() && lines.is_empty();
    let one_freedom = if is_single && is_free {
        let path = PenetrationPath { prepared, contact: touched };
        STROKES.into_iter().find_map(|factor| {
            let depth = factor * found.max_penetration;
            let masses = path.masses_to(pose, depth).ok()?;
            let impact = impact_over_stroke(&law, &masses).ok()??;
            (impact.max_penetration <= depth).then_some(impact)
        })
    } else {
        None
    };
    let drives = drive_records(pose, &found, &drives);
    let work: f64 = drives.iter().map(|drive| drive.work).sum();
    let effective_weight = (!drives.is_empty()).then(|| mass + 2.0 * work / rigid.closing_speed.powi(2));
    Ok(Some(ImpactTimeRecord {
        restitution: found.restitution,
        duration: found.duration,
        max_penetration: found.max_penetration,
        peak_force: found.peak_force,
        mass_change: found.mass_at_max_penetration.zip(own.kilograms()).map(|(most, m)| most / m - 1.0),
        one_freedom,
        gravity_world: gravity,
        springs: spring_records(pose, &found, &lines),
        dampers: damper_records(&lines),
        drives,
        effective_weight,
        springs_left_out,
        energy: EnergyRecord {
            kinetic_before: found.energy.kinetic_before,
            kinetic_after: found.energy.kinetic_after,
            taken_by_contact: found.energy.taken_by_contact,
            work_of_other_forces: found.energy.work_of_other_forces,
            residual: found.energy.residual(),
        },
        loop_gap: found.samples.iter().map(|s| s.loop_gap).fold(0.0, f64::max),
        times: found.samples.iter().map(|s| s.time).collect(),
        penetration: found.samples.iter().map(|s| s.penetration).collect(),
        closing_speed: found.samples.iter().map(|s| s.rate).collect(),
        force: found.samples.iter().map(|s| s.force).collect(),
        effective_mass: found.samples.iter().map(|s| s.effective_mass).collect(),
        joints: joints(pose, &found),
        bearings: bearings(pose, &found, rigid, held),
    }))
}

/// Warning about an impact in time whose separation speed is larger than the closing speed.
pub(crate) fn restitution_finding(found: &ImpactTimeRecord) -> Option<Finding> {
    let reached = found.restitution;
    (reached > 1.0 + CREATED_RESTITUTION).then(|| {
        let message = format!(
            "the impact in time reaches a restitution of {reached:.4}, above 1: gravity, springs or the change of the effective mass \
             accelerate the separation; check them, or use a stiffer contact"
        );
        Finding::about_result(FindingKind::RestitutionAboveOne, message)
    })
}

/// Spring, damper or drive between points with its name.
type NamedSpring = (String, PointSpring);

/// Springs and dampers between points: those of the sheet and the given ones, each with its name; and those of the sheet that are left out.
fn point_springs(
    evaluated: &EvaluatedQuestion,
    impact: &ImpactQuestion,
) -> Result<(Vec<NamedSpring>, Vec<String>), StudyError> {
    let EvaluatedQuestion { prepared, pose, .. } = evaluated;
    let (mut acting, mut left_out) = (Vec::new(), Vec::new());
    let mode = impact.springs.unwrap_or_default();
    for SheetElement { name, ends, force } in sheet_elements(prepared.model) {
        let element = match (mode, force) {
            (SheetSprings::None, _) => {
                left_out.push(name.to_owned());
                continue;
            }
            (_, ElementForce::Damper(curve)) => {
                PointSpring { damper: Some(curve), ..PointSpring::new(ends, 0.0, None) }
            }
            (SheetSprings::Change, ElementForce::Spring(spring)) => PointSpring::new(ends, spring.rate, None),
            (SheetSprings::Full, ElementForce::Spring(spring)) => {
                let missing = || {
                    let why = format!(
                        "{name}: the sheet has no preload, which determines the whole force of the spring"
                    );
                    StudyError::input(Field::SheetSprings, why)
                };
                let preload = spring.preload.ok_or_else(missing)?;
                let drawn =
                    prepared.system.pose(&prepared.system.configuration()).map_err(StudyError::from)?;
                let [a, b] = ends.map(|(link, point)| drawn.link(link).point(&point));
                PointSpring::new(ends, spring.rate, Some((b - a).norm() + preload / spring.rate))
            }
        };
        acting.push((name.to_owned(), element));
    }
    for given in &impact.spring {
        let ends = find_ends(pose, &given.ends, Field::PointSpring)?;
        acting.push((name_of(&given.ends), PointSpring::new(ends, given.rate, given.free_length)));
    }
    for given in &impact.damper {
        let ends = find_ends(pose, &given.ends, Field::PointDamper)?;
        let damper = Some(Arc::clone(&given.curve));
        acting.push((name_of(&given.ends), PointSpring { damper, ..PointSpring::new(ends, 0.0, None) }));
    }
    Ok((acting, left_out))
}

/// Ends of a line in the mechanism of a pose.
fn find_ends(pose: &Pose, ends: &Ends, field: Field) -> Result<[(LinkId, Vector3<f64>); 2], StudyError> {
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
            acts: Drive::Points(find_ends(pose, ends, Field::Drive)?),
        }),
        GivenDrive::Joint(name, value) => {
            let joint = find_joint(pose.mechanism(), Field::Drive, name)?;
            let kind = pose.mechanism().joint(joint).kind();
            if kind.dofs() != 1 {
                let why =
                    format!("joint \"{name}\" has {} velocities; expected a joint with one", kind.dofs());
                return Err(StudyError::input(Field::Drive, why));
            }
            let turns = rate_dimension(kind, 0) == Dimension::AngularSpeed;
            let (dimension, unit) = if turns { (Dimension::Moment, "N·m") } else { (Dimension::Force, "N") };
            let wrong =
                |source| StudyError::input(Field::Drive, Fault::Position { joint: name.clone(), source });
            let value = value.in_dimension(dimension, &value.to_string()).map_err(wrong)?;
            Ok(NamedDrive { name: name.clone(), value, unit, acts: Drive::Joint(joint) })
        }
    };
    impact.drive.iter().map(drive).collect()
}

/// Drives with their work until the largest penetration.
fn drive_records(touch: &Pose, found: &ImpactInTime, drives: &[NamedDrive]) -> Vec<DriveRecord> {
    if drives.is_empty() {
        return Vec::new();
    }
    let samples = &found.samples;
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
        let travel: f64 = near.clone().map(|i| weight(i) * travel(&drive.acts, &samples[i])).sum();
        DriveRecord {
            name: drive.name.clone(),
            value: drive.value,
            unit: drive.unit,
            work: drive.value * travel,
        }
    };
    drives.iter().map(&mut record).collect()
}

/// Dampers between points.
fn damper_records(lines: &[NamedSpring]) -> Vec<PointDamperRecord> {
    let record = |(name, line): &NamedSpring| {
        let curve = line.damper.as_ref()?;
        let (speeds, forces) = (curve.speeds().to_vec(), curve.forces().to_vec());
        Some(PointDamperRecord { name: name.clone(), speeds, forces })
    };
    lines.iter().filter_map(record).collect()
}

/// Springs between points with their forces at the touch and at the end.
fn spring_records(touch: &Pose, found: &ImpactInTime, springs: &[NamedSpring]) -> Vec<PointSpringRecord> {
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
    springs.iter().filter(|(_, spring)| spring.rate > 0.0).map(record).collect()
}

/// Springs of the joints.
fn springs(pose: &Pose, impact: &ImpactQuestion) -> Result<Vec<JointSpring>, StudyError> {
    let spring = |(number, (name, given)): (usize, &(String, GivenSpring))| {
        if impact.joint_spring[..number].iter().any(|(earlier, _)| earlier == name) {
            let why = format!("joint \"{name}\" is given twice; give it once");
            return Err(StudyError::input(Field::JointSpring, why));
        }
        let joint = find_joint(pose.mechanism(), Field::JointSpring, name)?;
        let refuse = |fault: Fault| StudyError::input(Field::JointSpring, fault);
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
        Ok(JointSpring { joint, stiffness, damping, free_position, drive: 0.0 })
    };
    impact.joint_spring.iter().enumerate().map(spring).collect()
}

/// Velocities of the movable joints.
fn joints(pose: &Pose, found: &ImpactInTime) -> Vec<JointMotionRecord> {
    let mechanism = pose.mechanism();
    let movable = mechanism.joint_ids().filter(|id| mechanism.joint(*id).kind().dofs() > 0);
    let record = |id| JointMotionRecord {
        joint: mechanism.joint(id).name().to_owned(),
        rates: found.samples.iter().map(|sample| sample.rates.joint(id).to_vec()).collect(),
    };
    movable.map(record).collect()
}

/// Forces in all bearings, with the estimate of the rigid impact.
fn bearings(
    pose: &Pose,
    found: &ImpactInTime,
    rigid: &RigidImpact,
    held: &[String],
) -> Vec<BearingForceRecord> {
    let size = |record: &ReactionRecord| record.force.iter().flatten().map(|f| f * f).sum::<f64>().sqrt();
    let estimates = records(pose, &rigid.reactions, held, None);
    let per_impulse = found.peak_force / rigid.impulse;
    let start = |estimate: &ReactionRecord| BearingForceRecord {
        place: estimate.place,
        name: estimate.name.clone(),
        force: Vec::with_capacity(found.samples.len()),
        peak_force: 0.0,
        peak_time: 0.0,
        estimate: size(estimate) * per_impulse,
        open_components: estimate.force.map(|f| f.is_none()),
    };
    let mut bearings: Vec<BearingForceRecord> = estimates.iter().map(start).collect();
    for sample in &found.samples {
        for (bearing, record) in bearings.iter_mut().zip(records(pose, &sample.reactions, held, None)) {
            bearing.force.push(size(&record));
        }
    }
    let times: Vec<f64> = found.samples.iter().map(|sample| sample.time).collect();
    for bearing in &mut bearings {
        let peak = peak_over_time(&times, &bearing.force);
        (bearing.peak_force, bearing.peak_time) = peak.filter(|(force, _)| *force > 0.0).unwrap_or_default();
    }
    bearings
}
