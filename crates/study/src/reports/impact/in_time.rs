//! Impact in time with the contact law, as a record.

use crate::checks::finding::Finding;
use crate::checks::finding_kind::FindingKind;
use crate::damper::damped_contact::no_damper;
use crate::damper::damping::{contact, contact_damper, impact_over_stroke};
use crate::damper::penetration::PenetrationPath;
use crate::evaluation::prepared_question::EvaluatedQuestion;
use crate::evaluation::status::Status;
use crate::question::errors::question_error::StudyError;
use crate::question::tables::impact::ImpactQuestion;
use crate::reports::impact::errors::impact_error;
use crate::reports::impact::forces_in_time::{
    ActingForces, AntiRollBarRecord, DriveRecord, PointDamperRecord, PointSpringRecord, TyreRecord,
};
use crate::reports::impact::reactions::{ReactionPlace, ReactionRecord, records};
use crate::thresholds::{CREATED_RESTITUTION, STROKES};
use percuss_contact::{Damper, Separation, StiffnessLaw, VaryingMassImpact};
use percuss_dynamics::Pose;
use percuss_impact::{ImpactInTime, RigidImpact, TimeConditions, impact_in_time, peak_over_time};
use percuss_spatial::Vector3;
use schemars::JsonSchema;
use serde::Serialize;

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
    /// Tyres that act.
    pub tyres: Vec<TyreRecord>,
    /// Anti-roll bars that act.
    pub anti_roll_bars: Vec<AntiRollBarRecord>,
    /// Drives that act.
    pub drives: Vec<DriveRecord>,
    /// Effective weight of absorber catalogues, kg (kg·m² for a moment): m̄ + 2W/v² with the work W of the drives until the largest
    /// penetration and the closing speed v. It is no mass of the mechanism; null without drives.
    pub effective_weight: Option<f64>,
    /// Springs, dampers, tyres and anti-roll bars of the suspension sheet that are left out.
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
    let acting = ActingForces::new(evaluated, impact)?;
    let conditions = TimeConditions {
        gravity: Vector3::from(gravity),
        other_mass: prepared.other_mass(),
        ends_without_force: matches!(
            damper,
            Damper::KelvinVoigt { separation: Separation::ForceVanishes, .. }
        ),
        springs: acting.joints.clone(),
        point_springs: acting.lines.iter().map(|(_, spring)| spring.clone()).collect(),
        supports: acting.tyres.iter().map(|(_, support)| *support).collect(),
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
    let is_free = impact.gravity.is_empty() && acting.is_empty();
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
    let drives = acting.drive_records(pose, &found);
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
        springs: acting.spring_records(pose, &found),
        dampers: acting.damper_records(),
        tyres: acting.tyre_records(pose, &found),
        drives,
        effective_weight,
        anti_roll_bars: acting.bars,
        springs_left_out: acting.left_out,
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
