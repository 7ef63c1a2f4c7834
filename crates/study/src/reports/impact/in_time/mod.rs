//! Impact in time with the contact law, as a record.

pub(crate) mod compliant;
pub(crate) mod forces;

use crate::checks::finding::Finding;
use crate::checks::finding_kind::FindingKind;
use crate::damper::damped_contact::no_damper;
use crate::damper::damping::{contact, contact_damper, impact_over_stroke};
use crate::damper::penetration::PenetrationPath;
use crate::evaluation::passed_stops::PassedStops;
use crate::evaluation::prepared_question::EvaluatedQuestion;
use crate::evaluation::status::Status;
use crate::question::errors::question_error::StudyError;
use crate::question::tables::impact::ImpactQuestion;
use crate::reports::impact::errors::impact_error;
use crate::reports::impact::in_time::compliant::{CompliantImpactRecord, compliant};
use crate::reports::impact::in_time::forces::{
    ActingForces, AntiRollBarRecord, DirectionChangeRecord, DriveRecord, JointSpringRecord,
    PointDamperRecord, PointSpringRecord, TyreRecord,
};
use crate::reports::impact::reactions::{ReactionPlace, ReactionRecord, records};
use crate::thresholds::{
    CREATED_RESTITUTION, LARGEST_LOSS_FACTOR, REACHED_RESTITUTION, STEPS_TO_REACH, STROKES,
};
use percuss_contact::{Damper, Separation, StiffnessLaw, VaryingMassImpact};
use percuss_dynamics::Pose;
use percuss_impact::{ImpactInTime, RigidImpact, TimeConditions, impact_in_time};
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

/// Second touch of a contact after its end.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SecondTouchRecord {
    /// Time since the first touch, s.
    pub time: f64,
    /// Closing speed, m/s.
    pub speed: f64,
}

/// Impact in time with a compliant contact.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ImpactTimeRecord {
    /// Restitution that is reached: separation speed divided by closing speed; 0 if the sides do not separate.
    pub restitution: f64,
    /// Duration of the contact, s; null if the sides do not separate.
    pub duration: Option<f64>,
    /// Largest penetration, m.
    pub max_penetration: f64,
    /// Largest force of the contact, N.
    pub peak_force: f64,
    /// Relative change of m̄ from the touch to the largest penetration; null if m̄ is not finite there. The change is unbounded near a pose
    /// at which the contact is immovable.
    pub mass_change: Option<f64>,
    /// True if the damping was found for the requested restitution of the impact in time, and false if it is that of the contact alone.
    pub restitution_is_reached: bool,
    /// Damping of the contact law, N·s/m^((p+1)/2); null for other laws than Kelvin–Voigt.
    pub damping: Option<f64>,
    /// Dissipation of the contact law, s/m; null for other laws than those of the Hunt–Crossley family.
    pub dissipation: Option<f64>,
    /// Loss factor of the contact law; null for other laws.
    pub loss_factor: Option<f64>,
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
    /// Springs and dampers of joints that act: those of the model, and given ones.
    pub joint_springs: Vec<JointSpringRecord>,
    /// Drives that act.
    pub drives: Vec<DriveRecord>,
    /// Effective weight of absorber catalogues, kg (kg·m² for a moment): m̄ + 2W/v² with the work W of the drives until the largest
    /// penetration and the closing speed v. It is no mass of the mechanism; null without drives.
    pub effective_weight: Option<f64>,
    /// Springs, dampers, tyres and anti-roll bars of the suspension sheet and springs of joints that are left out.
    pub springs_left_out: Vec<String>,
    /// Size of an assumption: only the change of the forces of the springs since the touch acts; here the same impact with their whole forces, which
    /// change their direction, and with constant vertical forces on the wheel centres that balance them at the touch. Null if the whole forces act
    /// or are unknown.
    pub with_whole_forces: Option<DirectionChangeRecord>,
    /// Second touch of the contact within three of its durations after its end, without the force of the contact in between; null if there is none.
    pub second_touch: Option<SecondTouchRecord>,
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
    /// The same impact with elastic bushes and gears; null unless requested.
    pub compliant: Option<CompliantImpactRecord>,
}

/// Impact in time, and findings about dampers and other stops; `None` unless requested.
pub(crate) fn in_time(
    evaluated: &EvaluatedQuestion,
    impact: &ImpactQuestion,
    rigid: &RigidImpact,
    held: &[String],
) -> Result<Option<(ImpactTimeRecord, Vec<Finding>)>, StudyError> {
    let EvaluatedQuestion { prepared, pose, contact: touched, result } = evaluated;
    let law = impact.contact_law(rigid.closing_speed).filter(|_| impact.in_time);
    let Some(law) = law else { return Ok(None) };
    let own = result.mechanism_response().effective_mass;
    let mass = result.response.effective_mass.kilograms();
    let mass = mass.ok_or_else(|| StudyError::NoDamper(no_damper(Status::Immovable)))?;
    let compliant_contact = contact(&law, mass)?;
    let mut damper = contact_damper(&law, compliant_contact)?;
    let gravity = impact.gravity().unwrap_or_default();
    let acting = ActingForces::new(evaluated, impact)?;
    let conditions = TimeConditions {
        gravity: Vector3::from(gravity),
        other_mass: prepared.other_mass(),
        ends_without_force: matches!(
            damper,
            Damper::KelvinVoigt { separation: Separation::ForceVanishes, .. }
        ),
        jumps_at_reversal: damper.jumps_at_reversal(),
        springs: acting.joints.clone(),
        point_springs: acting.lines.iter().map(|(_, spring)| spring.clone()).collect(),
        supports: acting.tyres.iter().map(|(_, support)| *support).collect(),
        corners: match compliant_contact.stiffness() {
            StiffnessLaw::Curve(curve) => curve.deflections()[1..].to_vec(),
            StiffnessLaw::Power { .. } => Vec::new(),
        },
        samples_within_steps: SAMPLES_WITHIN_STEPS,
    };
    let run = |damper: Damper, conditions: &TimeConditions| {
        let force = |penetration: f64, rate: f64| damper.force(compliant_contact, penetration, rate);
        impact_in_time(pose, touched, rigid.closing_speed, &rigid.before, &force, conditions)
            .map_err(|error| impact_error(error, impact))
    };
    if impact.reach {
        let coarse = TimeConditions { samples_within_steps: 0, ..conditions.clone() };
        damper = reaching(damper, impact.restitution(), &|damper| Ok(run(damper, &coarse)?.restitution))?;
    }
    let found = run(damper, &conditions)?;
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
    let whole = acting.with_whole_forces(evaluated, &conditions);
    let whole = whole.map(|whole| run(damper, &whole)).transpose()?;
    let (with_bushes, left_out) =
        compliant(evaluated, impact, rigid, (damper, compliant_contact), (&conditions, &acting), &found)?;
    let drives = acting.drive_records(pose, &found);
    let work: f64 = drives.iter().map(|drive| drive.work).sum();
    let effective_weight = (!drives.is_empty()).then(|| mass + 2.0 * work / rigid.closing_speed.powi(2));
    let mut findings = acting.damper_findings(pose, &found);
    findings.extend(left_out);
    let states = found.samples.iter().map(|sample| (sample.time, &sample.positions[..]));
    findings.extend(PassedStops::of_joints(prepared).map(|stops| stops.reached(states)).unwrap_or_default());
    let record = ImpactTimeRecord {
        restitution: found.restitution,
        duration: found.separates.then_some(found.duration),
        max_penetration: found.max_penetration,
        peak_force: found.peak_force,
        restitution_is_reached: impact.reach,
        damping: match damper {
            Damper::KelvinVoigt { coefficient, .. } => Some(coefficient),
            _ => None,
        },
        dissipation: match damper {
            Damper::HuntCrossley { dissipation } => Some(dissipation),
            _ => None,
        },
        loss_factor: match damper {
            Damper::LossFactor { loss_factor } => Some(loss_factor),
            _ => None,
        },
        mass_change: found.mass_at_max_penetration.zip(own.kilograms()).map(|(most, m)| most / m - 1.0),
        one_freedom,
        gravity_world: gravity,
        springs: acting.spring_records(pose, &found),
        dampers: acting.damper_records(),
        tyres: acting.tyre_records(pose, &found),
        joint_springs: acting.joint_records(pose),
        drives,
        effective_weight,
        anti_roll_bars: acting.bars,
        springs_left_out: acting.left_out,
        with_whole_forces: whole.map(|whole| DirectionChangeRecord {
            restitution: whole.restitution,
            peak_force: whole.peak_force,
        }),
        second_touch: found.second_touch.map(|touch| SecondTouchRecord {
            time: found.duration + touch.after_end,
            speed: touch.closing_speed,
        }),
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
        compliant: with_bushes,
    };
    Ok(Some((record, findings)))
}

/// Damper of the kind of `start` with which the impact in time reaches a restitution. `restitution` of a damper; it falls with the damping.
///
/// # Errors
/// [`StudyError`]: those of the impact; a restitution that no damping reaches.
fn reaching(
    start: Damper,
    wanted: f64,
    restitution: &dyn Fn(Damper) -> Result<f64, StudyError>,
) -> Result<Damper, StudyError> {
    let with = |x: f64| match start {
        Damper::KelvinVoigt { separation, ratio, coefficient } => {
            let unit = if coefficient > 0.0 { ratio / coefficient } else { 0.0 };
            Damper::KelvinVoigt { separation, ratio: unit * x, coefficient: x }
        }
        Damper::HuntCrossley { .. } => Damper::HuntCrossley { dissipation: x },
        Damper::LossFactor { .. } => Damper::LossFactor { loss_factor: x },
    };
    let (first, most) = match start {
        Damper::KelvinVoigt { coefficient, .. } => (coefficient, f64::INFINITY),
        Damper::HuntCrossley { dissipation } => (dissipation, f64::INFINITY),
        Damper::LossFactor { loss_factor } => (loss_factor, LARGEST_LOSS_FACTOR),
    };
    let elastic = restitution(with(0.0))?;
    if elastic <= wanted + REACHED_RESTITUTION {
        if (elastic - wanted).abs() <= REACHED_RESTITUTION {
            return Ok(with(0.0));
        }
        let why = format!(
            "no damping of the contact reaches {wanted}: without damping the impact in time has {elastic:.4}, because of the other forces and \
             the change of the effective mass; expected a smaller restitution"
        );
        return Err(StudyError::input("impact.restitution", why));
    }
    // The excess over the wanted restitution is above 0 at `low` and below 0 at `high`.
    let (mut low, mut high) = ((0.0, elastic - wanted), (first.max(f64::MIN_POSITIVE), f64::NAN));
    for _ in 0..STEPS_TO_REACH {
        high.1 = restitution(with(high.0))? - wanted;
        if high.1 <= 0.0 || high.0 >= most {
            break;
        }
        (low, high.0) = (high, (2.0 * high.0).min(most));
    }
    if high.1 > 0.0 {
        let why = format!("no damping reaches {wanted}; the impact in time has still {:.4}", high.1 + wanted);
        return Err(StudyError::input("impact.restitution", why));
    }
    // Illinois method.
    let mut side = 0;
    for _ in 0..STEPS_TO_REACH {
        let middle = (low.0 * high.1 - high.0 * low.1) / (high.1 - low.1);
        let value = restitution(with(middle))? - wanted;
        if value.abs() <= REACHED_RESTITUTION {
            return Ok(with(middle));
        }
        if value > 0.0 {
            (low, high.1) = ((middle, value), if side == 1 { 0.5 * high.1 } else { high.1 });
            side = 1;
        } else {
            (high, low.1) = ((middle, value), if side == -1 { 0.5 * low.1 } else { low.1 });
            side = -1;
        }
    }
    Ok(with(low.0))
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
        let forces = sample.reactions.determinate_forces();
        bearings.iter_mut().zip(forces).for_each(|(bearing, force)| bearing.force.push(force));
    }
    for (bearing, peak) in bearings.iter_mut().zip(&found.bearing_peaks) {
        (bearing.peak_force, bearing.peak_time) = *peak;
    }
    bearings
}
