//! Report of a rigid impact, as JSON.

use crate::checks::finding::Finding;
use crate::checks::finding_kind::FindingKind;
use crate::damper::damped_contact::{damping_report, finite_mass};
use crate::damper::damping::{beyond_curve, contact, damper};
use crate::damper::sheet_forces::with_sheet_curve;
use crate::evaluation::contact_point::{contact_without_point, require_contact_point};
use crate::evaluation::prepared_question::EvaluatedQuestion;
use crate::evaluation::status::Status;
use crate::model::loading::Model;
use crate::model::record::DiagnosticRecord;
use crate::question::errors::question_error::StudyError;
use crate::question::mass_question::MassQuestion;
use crate::question::tables::damping::DampingQuestion;
use crate::question::tables::impact::ImpactQuestion;
use crate::reports::answer_mass::build_mass_report;
use crate::reports::impact::additions::{
    GreatestSpeedRecord, PercussionRecord, greatest_speed, limits_without_effect, percussion, rates_of,
};
use crate::reports::impact::errors::impact_error;
use crate::reports::impact::friction::{FrictionRecord, friction_record};
use crate::reports::impact::further_contacts::stop_findings;
use crate::reports::impact::in_time::{ImpactTimeRecord, in_time, restitution_finding};
use crate::reports::impact::masses::{MassStateRecord, mass_states};
use crate::reports::impact::reactions::{
    JointConstraintRecord, ReactionPlace, ReactionRecord, joint_constraint_records, records,
};
use crate::reports::impact::reflected::{
    PosedModel, ReflectedRangeRecord, ReflectedRecord, reflected, reflected_over,
};
use crate::reports::impact::simultaneous::{SimultaneousRecord, simultaneous, unit_finding};
use crate::reports::mass_report::MassReport;
use crate::thresholds::SAME_SPEED;
use crate::values::force_curve::ForceCurveRecord;
use crate::values::quantities::Ratio;
use percuss_contact::{Damper, Law};
use percuss_dynamics::{Base, Pose};
use percuss_impact::{
    DriverRate, FrictionLaw, JointRates, RigidImpact, closing_speed, forces_of_motion, held_point_mass,
    rates_from_drivers,
};
use percuss_spatial::{Twist, Vector3};
use percuss_units::Dimension;
use schemars::JsonSchema;
use serde::Serialize;

/// Rates of a joint before and after the impact.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct JointRateRecord {
    /// The joint.
    pub joint: String,
    /// Velocities before the impact, rad/s or m/s, in the layout of the joint's kind.
    pub before: Vec<f64>,
    /// Velocities after the impact.
    pub after: Vec<f64>,
    /// True if a motion without mass moves the joint: its rates after the impact are not determined.
    pub undetermined: bool,
}

/// Velocity of a floating base, world axes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct BaseRateRecord {
    /// Angular velocity before the impact, rad/s.
    pub angular_before: [f64; 3],
    /// Velocity of the root's origin before the impact, m/s.
    pub linear_before: [f64; 3],
    /// Angular velocity after the impact, rad/s.
    pub angular_after: [f64; 3],
    /// Velocity of the root's origin after the impact, m/s.
    pub linear_after: [f64; 3],
}

/// Free body on the other side.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct OtherBodyRecord {
    /// Mass, kg.
    pub mass: f64,
    /// Change of its velocity along the normal, m/s.
    pub speed_change: f64,
}

/// Compliant contact with the peak force of the impact.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ImpactLawRecord {
    /// Contact law.
    pub law: &'static str,
    /// Stiffness, N/m^p; null for a force curve.
    pub stiffness: Option<f64>,
    /// Exponent p; null for a force curve.
    pub exponent: Option<f64>,
    /// Force curve of the contact; null for a stiffness.
    pub stiffness_curve: Option<ForceCurveRecord>,
    /// Duration of the contact, s; null if infinite, and with friction.
    pub duration: Option<f64>,
    /// Largest penetration, m.
    pub max_penetration: Option<f64>,
    /// Largest normal force at the contact, N.
    pub peak_force: f64,
    /// Mass of a frictionless contact with the same work of compression, kg; null without friction.
    pub mass_in_compression: Option<f64>,
    /// True if the direction of the contact force changes during compression; the peaks of the bearings are then for its mean direction.
    pub direction_changes: bool,
    /// Relative change of m̄ over the penetration: order of magnitude of the relative error of all peak forces, apart from the forces of
    /// `motion_force`; null if the penetration is not reachable.
    pub mass_change_over_penetration: Option<f64>,
    /// Force of the velocities before the impact in the bearing with the largest ratio of this force to its peak force. Null if no bearing
    /// has a finite ratio. The peak forces exclude these forces.
    pub motion_force: Option<MotionForceRecord>,
}

/// Force in a bearing that the velocities before the impact cause alone; it is quadratic in the rates.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MotionForceRecord {
    /// Place.
    pub place: ReactionPlace,
    /// Name of the joint or closure; of the held link; of the root link.
    pub name: String,
    /// Magnitude of the determinate components of the force, N.
    pub force: f64,
    /// Ratio of this force to the peak force of the bearing.
    pub ratio: f64,
}

/// Report of `percuss impact`, as JSON. All keys are always present; a value is null if not applicable.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct ImpactReport {
    /// `percuss.impact/1`.
    #[schemars(extend("const" = "percuss.impact/1"))]
    pub schema: &'static str,
    /// Version of percuss.
    pub percuss: &'static str,
    /// Effective mass, contact, pose and conditions: the report of `percuss mass`. Its findings are in `diagnostics`.
    pub mass: MassReport,
    /// Coefficient of restitution e; with friction the energetic one.
    pub restitution: f64,
    /// Closing speed before the impact, m/s; rad/s for a moment (`mass.contact.is_moment`).
    pub closing_speed: f64,
    /// Normal impulse between the two sides, N·s (N·m·s for a moment); −impulse · normal acts on the contact link.
    pub impulse: f64,
    /// Lost kinetic energy, J.
    pub energy_loss: f64,
    /// Friction, if requested.
    pub friction: Option<FrictionRecord>,
    /// Several contacts at once, if further contacts or sticking points are requested. All other results are those of the first
    /// contact alone.
    pub simultaneous: Option<SimultaneousRecord>,
    /// Mass of the contact point if it cannot slide in the tangent plane (nᵀΛn), kg; null if not finite. The effective
    /// mass is that of a sliding contact, 1/(nᵀΛ⁻¹n). Null for contacts without a contact point: a moment, the stop of a joint, a cable, a
    /// spring or a rod.
    pub sticking_mass: Option<f64>,
    /// Kind of the sticking mass; null for contacts without a contact point.
    pub sticking_status: Option<Status>,
    /// Sliding and sticking masses with rotors decoupled, with rotors coupled, and with locked joints. Empty for contacts without a contact
    /// point.
    pub mass_states: Vec<MassStateRecord>,
    /// Motion before the impact: `given`, or `least-energy`, the motion v* times the closing speed.
    pub motion_before: &'static str,
    /// Rates of every movable joint.
    pub rates: Vec<JointRateRecord>,
    /// Velocity of a floating base; null for a fixed base.
    pub base: Option<BaseRateRecord>,
    /// Free body on the other side; null without one.
    pub other_body: Option<OtherBodyRecord>,
    /// Reactions in all joints, closures and held points, and that of the ground.
    pub reactions: Vec<ReactionRecord>,
    /// Impulses of the locks, mimics and couplings on their joints.
    pub joint_constraints: Vec<JointConstraintRecord>,
    /// Largest unbalanced impulse of the reactions, relative to the impulse.
    pub reaction_residual: f64,
    /// Compliant contact, if a contact law was requested.
    pub contact_law: Option<ImpactLawRecord>,
    /// Impact in time with the contact law, if requested.
    pub in_time: Option<ImpactTimeRecord>,
    /// Greatest closing speed by limits of joint rates and gears, if requested.
    pub greatest_closing_speed: Option<GreatestSpeedRecord>,
    /// Joints with a limit of the rate or of the gear that has no effect: the impact does not change their rates.
    pub limits_without_effect: Vec<String>,
    /// Reflected inertias, if requested.
    pub reflected_inertia: Vec<ReflectedRecord>,
    /// Reflected inertias over ranges of positions, if requested.
    pub reflected_over: Vec<ReflectedRangeRecord>,
    /// Centres of percussion, if requested.
    pub percussion: Vec<PercussionRecord>,
    /// Findings about the file and the result.
    pub diagnostics: Vec<DiagnosticRecord>,
}

/// Rigid impact at a contact of a model.
///
/// # Errors
/// [`StudyError`], as for [`mass`](crate::mass()); a restitution or a speed out of range, rates that the constraints do
/// not allow or that do not close the gap; an immovable or massless contact, a singular pose.
pub fn impact(
    model: &Model,
    question: &MassQuestion,
    impact: &ImpactQuestion,
) -> Result<ImpactReport, StudyError> {
    impact.check()?;
    let evaluated = EvaluatedQuestion::new(model, question)?;
    let EvaluatedQuestion { prepared, pose, result, .. } = &evaluated;
    let response = &result.response;
    let (impact, of_curve) = &with_curve_of_sheet(&evaluated, impact)?;
    let units = DampingQuestion { speed: impact.speed, ..impact.contact_law(1.0).unwrap_or_default() };
    units.check_dimensions("impact.stiffness", "impact.speed", response.contact.is_moment)?;
    let has_point = contact_without_point(&evaluated).is_none();
    refuse_results_at_point(&evaluated, impact)?;
    if response.singular_pose {
        let why = "the pose is singular: the motion of an impact depends on the branch; use a nearby pose on the required branch";
        return Err(StudyError::NoResult(why.to_owned()));
    }
    let (speed, before) = motion_before(&evaluated, impact)?;
    let is_given = before.is_some();
    let impact = &with_restitution(&evaluated, impact, speed)?;
    let rigid = match impact.friction() {
        None => RigidImpact::new(pose, response, speed, impact.restitution(), before),
        Some(friction) => {
            let friction = FrictionLaw {
                coefficient: friction,
                restitution: impact.restitution_law.unwrap_or_default().law(),
            };
            RigidImpact::with_friction(pose, response, speed, impact.restitution(), friction, before)
        }
    };
    let rigid = rigid.map_err(|error| impact_error(error, impact))?;
    let mut mass = build_mass_report(&evaluated)?;
    let mut diagnostics = std::mem::take(&mut mass.diagnostics);
    let mut contact_law = match impact.contact_law(rigid.closing_speed) {
        None => None,
        Some(law) => {
            let (record, found) = peak_force(&evaluated, &law, &rigid)?;
            let codes: Vec<&str> = found.iter().map(|finding| finding.code).collect();
            diagnostics.retain(|finding| !codes.contains(&finding.code));
            diagnostics.extend(found);
            Some(record)
        }
    };
    diagnostics.extend(of_curve.clone().map(DiagnosticRecord::from));
    let held: Vec<String> = prepared.question.hold.iter().map(|hold| hold.link.clone()).collect();
    diagnostics.extend(base_at_rest_finding(&evaluated, impact).map(DiagnosticRecord::from));
    diagnostics.extend(without_friction_finding(&evaluated, impact).map(DiagnosticRecord::from));
    let (several, of_masses) = simultaneous(&evaluated, impact, &rigid)?.unzip();
    diagnostics.extend(of_masses.into_iter().flatten().map(DiagnosticRecord::from));
    let found = several.iter().filter_map(|several| unit_finding(&evaluated, impact, several));
    diagnostics
        .extend(stop_findings(&evaluated, impact).into_iter().chain(found).map(DiagnosticRecord::from));
    // With friction the normal force is largest in compression, so the peaks are scaled from the reactions to its impulse.
    let compression = rigid.friction.as_ref().map(|friction| &friction.compression);
    let (of_peak, per_impulse) = match compression {
        Some(compression) => (&compression.reactions, compression.normal_impulse),
        None => (&rigid.reactions, rigid.impulse),
    };
    let peak = contact_law.as_ref().map(|law| (of_peak, law.peak_force / per_impulse));
    let reactions = records(pose, &rigid.reactions, &held, peak);
    if let Some(law) = &mut contact_law {
        law.motion_force = motion_force(&evaluated, &rigid, &held, &reactions);
    }
    let (in_time, of_dampers) = in_time(&evaluated, impact, &rigid, &held)?.unzip();
    if let Some(found) = &in_time {
        // The impact in time has these effects.
        let estimated = [
            FindingKind::SpringsAct,
            FindingKind::MassDrifts,
            FindingKind::ForceBeyondData,
            FindingKind::JointSprings,
        ];
        diagnostics.retain(|found| !estimated.iter().any(|kind| kind.code() == found.code));
        if found.compliant.is_some() {
            diagnostics.retain(|found| !FindingKind::ELASTIC.iter().any(|kind| kind.code() == found.code));
        }
        diagnostics.extend(beyond_curve(impact.stiffness_curve.as_ref(), Some(found.max_penetration)));
        let findings = restitution_finding(found).into_iter().chain(of_dampers.into_iter().flatten());
        diagnostics.extend(findings.map(DiagnosticRecord::from));
    }
    let posed = PosedModel::from(&evaluated);
    let (reflected_inertia, of_drivers) = reflected(&posed, &impact.reflected)?;
    let (reflected_over, found) = reflected_over(&posed, &impact.reflected)?;
    diagnostics.extend(of_drivers.into_iter().chain(found).map(DiagnosticRecord::from));
    let sticking = match has_point {
        true => {
            let alone = held_point_mass(pose, &response.contact);
            let alone = alone.map_err(StudyError::about("contact.link"))?;
            Some(Status::classify(alone.against_mass(prepared.other_mass())))
        }
        false => None,
    };
    Ok(ImpactReport {
        schema: "percuss.impact/1",
        percuss: env!("CARGO_PKG_VERSION"),
        restitution: rigid.restitution,
        closing_speed: rigid.closing_speed,
        impulse: rigid.impulse,
        energy_loss: rigid.energy_loss,
        friction: friction_record(&evaluated, &rigid),
        simultaneous: several,
        sticking_mass: sticking.and_then(|(_, mass)| mass),
        sticking_status: sticking.map(|(status, _)| status),
        mass_states: if has_point { mass_states(&evaluated)? } else { Vec::new() },
        motion_before: if is_given { "given" } else { "least-energy" },
        rates: joint_rates(pose, &rigid),
        base: base_rates(&evaluated, &rigid),
        other_body: prepared
            .other_mass()
            .map(|mass| OtherBodyRecord { mass, speed_change: rigid.impulse / mass }),
        reactions,
        joint_constraints: joint_constraint_records(pose.mechanism(), &rigid.reactions),
        reaction_residual: rigid.reactions.residual,
        in_time,
        contact_law,
        greatest_closing_speed: greatest_speed(&evaluated, impact)?,
        limits_without_effect: limits_without_effect(&evaluated, impact),
        reflected_inertia,
        reflected_over,
        percussion: percussion(&evaluated, impact)?,
        mass,
        diagnostics,
    })
}

/// Question with the force curve of the stop in the suspension sheet, unless a stiffness is given, and a finding about it.
fn with_curve_of_sheet(
    evaluated: &EvaluatedQuestion,
    impact: &ImpactQuestion,
) -> Result<(ImpactQuestion, Option<Finding>), StudyError> {
    // The closing speed has no influence on the curve.
    let law =
        impact.contact_law(1.0).unwrap_or(DampingQuestion { law: impact.law, ..DampingQuestion::default() });
    let (law, finding) = with_sheet_curve(evaluated, &law)?;
    if !law.has_stiffness() && (impact.in_time || impact.law.is_some()) {
        let why = "it is missing; an impact in time and a contact law require the stiffness of the contact, or a force curve (of a stop in a \
                   suspension sheet, or given)";
        return Err(StudyError::input("impact.stiffness", why));
    }
    Ok((ImpactQuestion { stiffness_curve: law.stiffness_curve, ..impact.clone() }, finding))
}

/// Question with the restitution of its damping at the closing speed (m/s), if a damping is given.
fn with_restitution(
    evaluated: &EvaluatedQuestion,
    impact: &ImpactQuestion,
    speed: f64,
) -> Result<ImpactQuestion, StudyError> {
    let (field, law) = match (impact.damping, impact.hunt_crossley, impact.loss_factor) {
        (Some(_), _, _) => ("impact.damping", Law::KelvinVoigt),
        (_, Some(_), _) => ("impact.hunt_crossley", Law::HuntCrossley),
        (_, _, Some(_)) => ("impact.loss_factor", Law::LossFactor),
        _ => return Ok(impact.clone()),
    };
    let Some(question) = impact.contact_law(speed) else {
        let why = "it requires the stiffness of the contact, or a force curve (of a stop in a suspension sheet, or given)";
        return Err(StudyError::input(field, why));
    };
    let compliant = contact(&question, finite_mass(evaluated)?)?;
    let damper = match (impact.damping, impact.hunt_crossley) {
        (Some(damping), _) => {
            let given = damping.0.dimension;
            let expected = if evaluated.result.response.contact.is_moment {
                Dimension::RotationalDamping
            } else {
                Dimension::Damping
            };
            if given.is_some_and(|found| found != expected || question.exponent() != 1.0) {
                let why = format!(
                    "its unit is not that of this contact; expected {}, or a plain number with an exponent",
                    expected.si_unit()
                );
                return Err(StudyError::input(field, why));
            }
            Damper::kelvin_voigt_from_coefficient(compliant, damping.0.value, question.separation())?
        }
        (None, Some(dissipation)) => Damper::hunt_crossley(dissipation.0)?,
        (None, None) => Damper::loss_factor(impact.loss_factor.map_or(0.0, |loss| loss.0))?,
    };
    let restitution = Some(Ratio(damper.restitution(compliant, speed)?));
    Ok(ImpactQuestion { restitution, law: Some(law.into()), ..impact.clone() })
}

/// Refuses results that require a contact point, for a contact without one.
fn refuse_results_at_point(evaluated: &EvaluatedQuestion, impact: &ImpactQuestion) -> Result<(), StudyError> {
    let results = [
        (impact.friction.is_some(), "impact.friction", "friction"),
        (!impact.percussion.is_empty(), "impact.percussion", "centre of percussion"),
        (impact.sticking, "impact.sticking", "sticking contact point"),
    ];
    match results.into_iter().find(|(is_requested, ..)| *is_requested) {
        Some((_, field, result)) => require_contact_point(evaluated, field, result),
        None => Ok(()),
    }
}

/// Force of the rates before the impact in the bearing with the largest ratio of this force to its peak force.
fn motion_force(
    evaluated: &EvaluatedQuestion,
    rigid: &RigidImpact,
    held: &[String],
    reactions: &[ReactionRecord],
) -> Option<MotionForceRecord> {
    let pose = &evaluated.pose;
    let size = |force: &[Option<f64>; 3]| force.iter().flatten().map(|f| f * f).sum::<f64>().sqrt();
    let forces = forces_of_motion(pose, &evaluated.result.response.contact, &rigid.before)?;
    let of_motion = records(pose, &forces, held, None);
    let of_bearing = |(motion, peak): (&ReactionRecord, &ReactionRecord)| {
        let (force, largest) = (size(&motion.force), size(&peak.peak_force?));
        let ratio = if force == 0.0 { 0.0 } else { force / largest };
        Some(MotionForceRecord { place: motion.place, name: motion.name.clone(), force, ratio })
    };
    // The ground repeats the bearings of the root link.
    let bearings =
        of_motion.iter().zip(reactions).filter(|(motion, _)| motion.place != ReactionPlace::Ground);
    let all = bearings.filter_map(of_bearing);
    all.filter(|record| record.ratio.is_finite()).max_by(|a, b| a.ratio.total_cmp(&b.ratio))
}

/// Closing speed and rates before the impact; no rates for the motion of least energy.
fn motion_before(
    evaluated: &EvaluatedQuestion,
    impact: &ImpactQuestion,
) -> Result<(f64, Option<JointRates>), StudyError> {
    let EvaluatedQuestion { prepared, pose, result, .. } = evaluated;
    let is_fixed = prepared.question.conditions.base() == Base::Fixed;
    if !impact.base_twist.is_empty() && is_fixed {
        let why = "the base is fixed; a velocity requires a floating base";
        return Err(StudyError::input("impact.base_twist", why));
    }
    if impact.rates.is_empty() && impact.base_twist.is_empty() {
        let why = "no motion before the impact is given; expected the closing speed, or the rates of the driving joints";
        let speed = impact.speed().ok_or_else(|| StudyError::input("impact.speed", why))?;
        return Ok((speed, None));
    }
    let driver = |given| {
        let (joint, rates) = rates_of(&prepared.model.mechanism, "impact.rates", given)?;
        Ok(DriverRate { joint, rates })
    };
    let drivers: Vec<DriverRate> = impact.rates.iter().map(driver).collect::<Result<_, StudyError>>()?;
    let [wx, wy, wz, vx, vy, vz] = impact.base_twist().unwrap_or_default();
    let base = Twist::new(
        pose.base().inverse_vector(&Vector3::new(wx, wy, wz)),
        pose.base().inverse_vector(&Vector3::new(vx, vy, vz)),
    );
    let given = if impact.rates.is_empty() { "impact.base_twist" } else { "impact.rates" };
    let rates = rates_from_drivers(pose, &drivers, base).map_err(StudyError::about(given))?;
    let contact = &result.response.contact;
    let unit = if contact.is_moment { "rad/s" } else { "m/s" };
    let closing = closing_speed(pose, contact, &rates);
    let speed = match (impact.speed(), prepared.other_mass()) {
        // The other body moves with the difference of both speeds.
        (Some(speed), Some(_)) => speed,
        (Some(speed), None) if (speed - closing).abs() > SAME_SPEED * speed.abs().max(closing.abs()) => {
            let why = format!(
                "{speed} {unit} is given, but the given rates close the gap at {closing} {unit}; leave one of the two out"
            );
            return Err(StudyError::input("impact.speed", why));
        }
        _ => closing,
    };
    if speed.is_nan() || speed <= 0.0 {
        // Speed rounded to six significant digits.
        let rounded: f64 = format!("{speed:.5e}").parse().unwrap_or(speed);
        let rates = match speed < 0.0 {
            true => "open the gap; opposite rates close it",
            false => "do not change the gap",
        };
        let why = format!(
            "the closing speed of these rates is {rounded} {unit}; expected a speed above zero: the rates {rates}"
        );
        return Err(StudyError::input(given, why));
    }
    Ok((speed, Some(rates)))
}

/// Finding about a floating base without a given velocity, if rates of joints are given.
fn base_at_rest_finding(evaluated: &EvaluatedQuestion, impact: &ImpactQuestion) -> Option<Finding> {
    let question = &evaluated.prepared.question;
    let is_assumed = question.conditions.base() == Base::Floating
        && !impact.rates.is_empty()
        && impact.base_twist.is_empty();
    let mechanism = &evaluated.prepared.model.mechanism;
    is_assumed.then(|| {
        let message = format!(
            "the base \"{}\" floats and is at rest before the impact, because rates of joints are given without its \
             velocity{}",
            mechanism.link(mechanism.root()).name(),
            question.names.hint("impact.base_twist")
        );
        Finding::about_result(FindingKind::BaseAtRest, message)
    })
}

/// Warning about results that do not include the friction of the impact.
fn without_friction_finding(evaluated: &EvaluatedQuestion, impact: &ImpactQuestion) -> Option<Finding> {
    let parts = [
        (!impact.rate_limit.is_empty() || !impact.gear_limit.is_empty(), "the greatest closing speed"),
        (!impact.percussion.is_empty(), "the centre of percussion"),
    ];
    let parts: Vec<&str> =
        parts.into_iter().filter(|(is_requested, _)| *is_requested).map(|(_, part)| part).collect();
    let is_affected = impact.friction.is_some() && !parts.is_empty();
    is_affected.then(|| {
        let message = format!(
            "computed without friction: {}{}",
            parts.join(", "),
            evaluated.prepared.question.names.hint("impact.friction")
        );
        Finding::about_result(FindingKind::WithoutFriction, message)
    })
}

/// Rates of every movable joint.
fn joint_rates(pose: &Pose, rigid: &RigidImpact) -> Vec<JointRateRecord> {
    let mechanism = pose.mechanism();
    let movable = mechanism.joint_ids().filter(|id| mechanism.joint(*id).kind().dofs() > 0);
    let record = |id| JointRateRecord {
        joint: mechanism.joint(id).name().to_owned(),
        before: rigid.before.joint(id).to_vec(),
        after: rigid.after.joint(id).to_vec(),
        undetermined: rigid.undetermined.contains(&id),
    };
    movable.map(record).collect()
}

/// Velocity of a floating base in world axes.
fn base_rates(evaluated: &EvaluatedQuestion, rigid: &RigidImpact) -> Option<BaseRateRecord> {
    let x_wr = evaluated.pose.base();
    let world = |v: &Vector3<f64>| x_wr.vector(v).into();
    (evaluated.prepared.question.conditions.base() == Base::Floating).then(|| BaseRateRecord {
        angular_before: world(&rigid.before.base.angular),
        linear_before: world(&rigid.before.base.linear),
        angular_after: world(&rigid.after.base.angular),
        linear_after: world(&rigid.after.base.linear),
    })
}

/// Peak force of a compliant contact with the restitution and the closing speed of the impact, and all findings.
fn peak_force(
    evaluated: &EvaluatedQuestion,
    damping: &DampingQuestion,
    rigid: &RigidImpact,
) -> Result<(ImpactLawRecord, Vec<DiagnosticRecord>), StudyError> {
    let report = damping_report(evaluated, damping)?;
    // With friction, the peak is that of a frictionless contact with the same work of compression.
    let compression = rigid.friction.as_ref().map(|friction| &friction.compression);
    let damper = match compression {
        Some(compression) => damper(damping, compression.equivalent_mass)?,
        None => report.damper,
    };
    let record = ImpactLawRecord {
        law: damper.law,
        stiffness: damper.stiffness,
        exponent: damper.exponent,
        stiffness_curve: damper.stiffness_curve,
        duration: damper.contact_duration.filter(|_| compression.is_none()),
        max_penetration: damper.max_penetration,
        peak_force: damper.peak_force.unwrap_or_default(),
        mass_in_compression: compression.map(|compression| compression.equivalent_mass),
        direction_changes: compression.is_some_and(|compression| !compression.has_constant_direction),
        mass_change_over_penetration: report.drift.and_then(|drift| drift.over_penetration),
        motion_force: None,
    };
    Ok((record, report.diagnostics))
}
