//! Compliance of the bushes at a contact: free mass, residual stiffness, and the range in which the rigid mass holds.

use crate::checks::finding::Finding;
use crate::checks::finding_kind::FindingKind;
use crate::damper::sheet_forces::{
    ElementForce, SheetElement, SheetTyre, joint_springs, sheet_bars, sheet_elements, sheet_tyres,
    torsion_moment,
};
use crate::evaluation::prepared_question::EvaluatedQuestion;
use crate::evaluation::status::Status;
use crate::question::errors::question_error::{Fault, StudyError};
use crate::question::tables::damping::DampingQuestion;
use crate::thresholds::{DAMPER_SLOPE_SPEED, FORCE_CHANGE, IMPULSE_CHANGE, SAME_MASS};
use crate::values::drives::GivenSpring;
use percuss_dynamics::{
    ComplianceError, ElasticSystem, ElementMotion, LinearElement, Load, ResidualCompliance,
};
use percuss_impact::{ContactEnd, ForcesAtTouch, compliant_impact_of};
use percuss_mechanism::{Bush, JointId, SpringDamper};
use percuss_spatial::Vector3;
use percuss_suspension::kinematics::{SuspensionParts, sliding_rack};
use schemars::JsonSchema;
use serde::Serialize;
use std::f64::consts::{PI, TAU};

/// Compliance of the bushes and gears at a contact. Units of a contact along a normal; N·m for N and rad for m at a moment.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ComplianceRecord {
    /// Elastic parts: `bushes`, `gears`, or `bushes and gears`. "Bushes" in the descriptions of the other keys means all of them.
    pub elastic: &'static str,
    /// m̄ with all bushes free, the limit of stiff contacts, in the unit of the report; null unless finite.
    pub free_mass: Option<f64>,
    /// Kind of result with all bushes free.
    pub free_status: Status,
    /// Residual compliance c_res of the bushes, m/N; null if the contact is massless or immovable.
    pub residual_compliance: Option<f64>,
    /// Residual stiffness 1/c_res, N/m; null if no bush gives way.
    pub residual_stiffness: Option<f64>,
    /// Shares of the bushes in the elastic energy of the residual compliance, the largest first.
    pub rows: Vec<BushShareRecord>,
    /// True if no spring, damper, tyre, anti-roll bar or free rotation of a bush with stiffness acts along the motion of the rigid mechanism: the lower bounds
    /// of an impact hold.
    pub lower_bounds_hold: bool,
    /// Springs, dampers, tyres and anti-roll bars of the sheet; joints with a spring or a damper.
    pub beside: Vec<String>,
    /// Largest stiffnesses of a contact, N/m, up to which the rigid mass is right within 1 % and within 5 %, by the rule of thumb.
    pub rigid_up_to: Option<[f64; 2]>,
    /// Contact of the given stiffness; null without a stiffness.
    pub contact: Option<CompliantContactRecord>,
}

/// Share of a bush.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct BushShareRecord {
    /// The bush, or the joint of a gear.
    pub bush: String,
    /// Direction in the bush: `radial x`, `radial y`, `axial`, `conical x`, `conical y`, `torsional`; `twist` of a gear.
    pub direction: &'static str,
    /// Share of the elastic energy, from 0 to 1.
    pub share: f64,
}

/// Contact of a given stiffness on the mechanism with bushes.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CompliantContactRecord {
    /// Stiffness k of the contact, N/m.
    pub stiffness: f64,
    /// Frequency √(k/m̄)/2π of the rigid mechanism on the contact, Hz; null unless m̄ is finite.
    pub frequency: Option<f64>,
    /// Duration π√(m̄/k) of the contact of the rigid mechanism, s; null unless m̄ is finite.
    pub duration: Option<f64>,
    /// Estimated relative change of the impulse by the bushes, 1.3 k c_res: a rule of thumb for small values.
    pub impulse_change: Option<f64>,
    /// Estimated relative change of the peak force by the bushes, 1.2 k c_res: a rule of thumb for small values.
    pub force_change: Option<f64>,
    /// Proved bounds of the peak force per approach speed, N·s/m: √(k m_free) and √(k m̄). The lower bound is null if a stiffness or a damping acts
    /// along the motion, the upper bound if m̄ is not finite.
    pub peak_force_per_speed: [Option<f64>; 2],
    /// The same bounds at the given approach speed, N.
    pub peak_force: Option<[Option<f64>; 2]>,
    /// Least duration of the contact, π√(m_free/k), s: proved without contact damping; null if a stiffness or a damping acts along the motion.
    pub least_duration: Option<f64>,
    /// Impact on this contact without damping, with the elastic bushes and gears and without springs and dampers of the sheet, from the motion of
    /// least energy; null if the contact is immovable or massless.
    pub impact: Option<UndampedImpactRecord>,
}

/// Impact of a mechanism with elastic bushes and gears on a linear contact without damping.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct UndampedImpactRecord {
    /// Stiffness k of the contact, N/m.
    pub stiffness: f64,
    /// m_imp = P/(v⁻ + v⁺), kg: mass of a free body with the same impulse P between the same speeds.
    pub impulse_mass: f64,
    /// F²/(k v²), kg: mass of a free body with the same peak force F.
    pub force_mass: f64,
    /// Separation speed divided by closing speed.
    pub restitution: f64,
    /// Duration of the contact, s; null without a separation.
    pub duration: Option<f64>,
    /// Largest m_imp by the proof, 2 m̄/(1 + e), kg; null if a stiffness or a damping acts along the motion. The least is the free mass.
    pub most_impulse_mass: Option<f64>,
}

/// Springs, dampers, tyres and the anti-roll bar of the suspension sheet, and springs of joints, as linear elements; a damper has its slope at speed 0.
fn linear_elements(evaluated: &EvaluatedQuestion) -> Vec<LinearElement> {
    let model = evaluated.prepared.model;
    let linear = |element: SheetElement<'_>| {
        let force = element.whole_force(evaluated).unwrap_or(0.0);
        let (stiffness, damping) = match element.force {
            ElementForce::Spring(spring) => (spring.rate, 0.0),
            ElementForce::Damper(curve) => {
                let change = curve.force(DAMPER_SLOPE_SPEED) - curve.force(-DAMPER_SLOPE_SPEED);
                (0.0, change / (2.0 * DAMPER_SLOPE_SPEED))
            }
        };
        let motion = ElementMotion::Length(element.ends);
        LinearElement { damping, force, ..LinearElement::spring(element.name, motion, stiffness) }
    };
    let tyre = |tyre: SheetTyre<'_>| {
        let motion = ElementMotion::Along(tyre.link, Vector3::zeros(), Vector3::z());
        let spring = LinearElement::spring(format!("tyre at {}", tyre.name), motion, tyre.force.rate);
        LinearElement { damping: tyre.force.damping, ..spring }
    };
    let bar = sheet_bars(model).map(|bar| bar.element());
    let at_joint = |(joint, spring): (JointId, SpringDamper)| {
        let name = model.mechanism.joint(joint).name();
        let element = LinearElement::spring(name, ElementMotion::Twist(joint, None), spring.stiffness);
        let force = torsion_moment(model, &evaluated.pose, joint, &spring);
        LinearElement { damping: spring.damping, force, ..element }
    };
    let elements = sheet_elements(model).into_iter().map(linear);
    let elements = elements.chain(sheet_tyres(model).into_iter().map(tyre)).chain(bar);
    elements.chain(joint_springs(&evaluated.pose).map(at_joint)).collect()
}

/// Mechanism with elastic bushes at the evaluated contact, with springs and dampers, and with the geometric stiffness of preloads and springs; a finding
/// if the latter is left out.
pub(crate) fn elastic_system(
    evaluated: &EvaluatedQuestion,
) -> Result<(ElasticSystem, Option<Finding>), StudyError> {
    let elements = linear_elements(evaluated).into_iter().chain(gear_elements(evaluated)?);
    let elements: Vec<LinearElement> = elements.collect();
    let system = elastic_system_with(evaluated, &elements)?;
    let forces = elements.iter().map(|element| element.force).collect();
    let Some(forces) = balanced_forces(evaluated, forces) else { return Ok((system, None)) };
    let loaded = forces.and_then(|ForcesAtTouch { loads, held, .. }| {
        let loaded = system.clone().with_geometric_stiffness(&loads, &held);
        let stable = loaded.and_then(|loaded| loaded.modes().map(|_| loaded));
        stable.map_err(|error| error.to_string())
    });
    match loaded {
        Ok(loaded) => Ok((loaded, None)),
        Err(why) => {
            let message = format!("the geometric stiffness of preloads and springs is left out: {why}");
            Ok((system, Some(Finding::about_result(FindingKind::NoGeometricStiffness, message))))
        }
    }
}

/// Forces of elements at the pose with the wheel loads and the drive that balance them and the preloads of bushes, or the reason for their absence;
/// `None` without forces.
pub(crate) fn balanced_forces(
    evaluated: &EvaluatedQuestion,
    elements: Vec<f64>,
) -> Option<Result<ForcesAtTouch, String>> {
    let mechanism = evaluated.pose.mechanism();
    let bushes = mechanism.bushes();
    let is_unloaded = |bush: &Bush| bush.description().preload == [0.0; 6];
    if bushes.iter().all(is_unloaded) && elements.iter().all(|force| *force == 0.0) {
        return None;
    }
    let is_replaced = |rack: &JointId| bushes.iter().any(|bush| bush.joints().contains(rack));
    let held = sliding_rack(mechanism).filter(|rack| !is_replaced(rack)).into_iter().collect();
    Some(wheel_loads(evaluated).map(|loads| ForcesAtTouch { elements, loads, held }))
}

/// Forces on the wheels of a suspension that balance springs and preloads; empty for other models.
fn wheel_loads(evaluated: &EvaluatedQuestion) -> Result<Vec<Load>, String> {
    let EvaluatedQuestion { prepared, pose, .. } = evaluated;
    let Some(sheet) = prepared.model.origin.sheet.as_deref() else { return Ok(Vec::new()) };
    let drawn = prepared.system.pose(&prepared.system.configuration()).map_err(|error| error.to_string())?;
    let parts = SuspensionParts::new(drawn, &sheet.understood).map_err(|error| error.to_string())?;
    parts.wheel_loads(pose)
}

/// Mechanism with elastic bushes at the evaluated contact, with the given elements.
fn elastic_system_with(
    evaluated: &EvaluatedQuestion,
    elements: &[LinearElement],
) -> Result<ElasticSystem, StudyError> {
    let EvaluatedQuestion { prepared, pose, result, .. } = evaluated;
    let system = ElasticSystem::new(pose, &result.response.contact, elements, prepared.other_mass());
    system.map_err(compliance_error)
}

/// Error of a mechanism with bushes and gears.
pub(crate) fn compliance_error(error: ComplianceError) -> StudyError {
    match error {
        ComplianceError::Gear { .. } => StudyError::input("conditions.gear_stiffness", error.to_string()),
        error => StudyError::NoResult(error.to_string()),
    }
}

/// Elastic gears: those of the question, and those of the model for other joints. A gear of the model at a locked joint, or one whose rotor the
/// question removes, has no effect.
pub(crate) fn gear_elements(evaluated: &EvaluatedQuestion) -> Result<Vec<LinearElement>, StudyError> {
    let EvaluatedQuestion { prepared, pose, .. } = evaluated;
    let given = &prepared.question.conditions.gear_stiffness;
    let gear = |(number, (name, gear)): (usize, &(String, GivenSpring))| {
        let refuse = |why: String| Err(StudyError::input("conditions.gear_stiffness", why));
        if given[..number].iter().any(|(earlier, _)| earlier == name) {
            return refuse(format!("joint \"{name}\" is given twice; give it once"));
        }
        let mechanism = pose.mechanism();
        let joint = mechanism.find_joint(name);
        let joint = joint.map_err(StudyError::about("conditions.gear_stiffness"))?;
        let kind = mechanism.joint(joint).kind();
        if kind.dofs() != 1 {
            let dofs = kind.dofs();
            return refuse(format!("joint \"{name}\" has {dofs} velocities; expected a joint with one"));
        }
        let wrong = |source| {
            StudyError::input("conditions.gear_stiffness", Fault::Position { joint: name.clone(), source })
        };
        let (stiffness, damping) = match gear.values_for_joint(kind).map_err(wrong)?[..] {
            [stiffness] => (stiffness, 0.0),
            [stiffness, damping] => (stiffness, damping),
            _ => {
                return refuse(format!(
                    "joint \"{name}\": expected K or K,D: stiffness and damping of the gear"
                ));
            }
        };
        if !(stiffness > 0.0 && damping >= 0.0) {
            return refuse(format!(
                "joint \"{name}\": {gear} is given; expected a stiffness above 0 and a damping of at least 0"
            ));
        }
        let gear = LinearElement::spring(name, ElementMotion::Gear(joint), stiffness);
        Ok(LinearElement { damping, ..gear })
    };
    let mut gears = given.iter().enumerate().map(gear).collect::<Result<Vec<_>, _>>()?;
    gears.extend(
        model_gears(evaluated)
            .filter(|(name, _)| given.iter().all(|(other, _)| other != name))
            .map(|found| found.1),
    );
    Ok(gears)
}

/// Elastic gears of the model that act at the pose, with the names of their joints.
fn model_gears<'e>(evaluated: &'e EvaluatedQuestion) -> impl Iterator<Item = (&'e str, LinearElement)> {
    let pose = &evaluated.pose;
    pose.mechanism().joint_ids().filter_map(move |id| {
        let joint = pose.mechanism().joint(id);
        let gear = joint.gear()?;
        let acts = !pose.is_locked(id) && pose.armature(id).iter().any(|inertia| *inertia > 0.0);
        let element = LinearElement::spring(joint.name(), ElementMotion::Gear(id), gear.stiffness);
        acts.then(|| (joint.name(), LinearElement { damping: gear.damping, ..element }))
    })
}

/// True if the question or the model has an elastic gear.
fn has_gears(evaluated: &EvaluatedQuestion) -> bool {
    !evaluated.prepared.question.conditions.gear_stiffness.is_empty()
        || model_gears(evaluated).next().is_some()
}

/// True if the model has bushes in place of joints.
fn has_bushes(evaluated: &EvaluatedQuestion) -> bool {
    let bushes = evaluated.prepared.model.mechanism.bushes();
    bushes.iter().any(|bush| bush.description().rigid.contains(&true))
}

/// True if the model has bushes in place of joints, or elastic gears.
pub(crate) fn has_elastic_joints(evaluated: &EvaluatedQuestion) -> bool {
    has_bushes(evaluated) || has_gears(evaluated)
}

/// Compliance of the bushes and gears at a contact; `None` for a model without them, or with the reason as a finding; and findings. `damping`: contact whose
/// stiffness is judged.
///
/// # Errors
/// [`StudyError`]: an invalid gear.
pub(crate) fn compliance(
    evaluated: &EvaluatedQuestion,
    damping: Option<&DampingQuestion>,
) -> Result<(Option<ComplianceRecord>, Vec<Finding>), StudyError> {
    if !has_elastic_joints(evaluated) {
        return Ok((None, Vec::new()));
    }
    let system = elastic_system(evaluated);
    let found =
        system.and_then(|(system, left_out)| Ok((system.residual().map_err(compliance_error)?, left_out)));
    match found {
        Ok((found, left_out)) => {
            let soft = Status::classify(found.rigid).1;
            let rigid = Status::classify(evaluated.result.response.effective_mass).1;
            let differs = soft.zip(rigid).is_some_and(|(soft, rigid)| (soft / rigid - 1.0).abs() > SAME_MASS);
            let finding = differs.then(|| {
                let message = format!(
                    "a bush without the stiffness leaves a rotation free that its joint holds, such as the spin of a rod: the limit of soft \
                     contacts is {:.4} kg, not the rigid mass; give torsional and conical of the bushes of rods",
                    soft.unwrap_or_default()
                );
                Finding::about_result(FindingKind::NoCompliance, message)
            });
            let mut record = record(evaluated, damping, found)?;
            if differs {
                record.rigid_up_to = None;
                if let Some(contact) = &mut record.contact {
                    (contact.impulse_change, contact.force_change) = (None, None);
                }
            }
            Ok((Some(record), finding.into_iter().chain(left_out).collect()))
        }
        Err(StudyError::NoResult(error)) => {
            let message = format!("the compliance of the bushes and gears is not computed: {error}");
            Ok((None, vec![Finding::about_result(FindingKind::NoCompliance, message)]))
        }
        Err(error) => Err(error),
    }
}

/// Impacts on contacts of several stiffnesses (N/m) without damping, with the elastic bushes and gears alone; a contact without a result is left out.
///
/// # Errors
/// [`StudyError`]: an invalid gear.
pub(crate) fn undamped_impacts(
    evaluated: &EvaluatedQuestion,
    stiffnesses: &[f64],
) -> Result<Vec<UndampedImpactRecord>, StudyError> {
    let system = elastic_system_with(evaluated, &gear_elements(evaluated)?)?;
    let rigid = system.residual().map_err(compliance_error)?;
    let impact = |&stiffness: &f64| {
        let found = compliant_impact_of(&system, [stiffness, 0.0], 1.0).ok()?;
        let separates = found.end != ContactEnd::NoRebound;
        let most = rigid.rigid.kilograms().filter(|_| rigid.is_free_along_motion && separates);
        Some(UndampedImpactRecord {
            stiffness,
            impulse_mass: found.impulse_mass,
            force_mass: found.peak_force.powi(2) / stiffness,
            restitution: found.restitution,
            duration: separates.then_some(found.duration),
            most_impulse_mass: most.map(|mass| 2.0 * mass / (1.0 + found.restitution)),
        })
    };
    Ok(stiffnesses.iter().filter_map(impact).collect())
}

/// Record of a residual compliance.
fn record(
    evaluated: &EvaluatedQuestion,
    damping: Option<&DampingQuestion>,
    found: ResidualCompliance,
) -> Result<ComplianceRecord, StudyError> {
    let (free_status, free_mass) = Status::classify(found.free);
    let compliance = found.compliance;
    let positive = compliance.filter(|c| *c > 0.0);
    let rows = found.shares.iter().map(|row| BushShareRecord {
        bush: row.element.clone(),
        direction: row.direction.name(),
        share: row.share,
    });
    let linear = damping.filter(|damping| damping.stiffness.is_some() && damping.exponent() == 1.0);
    let contact = |damping: &DampingQuestion| {
        let (stiffness, rigid) =
            (damping.stiffness(), Status::classify(evaluated.result.response.effective_mass).1);
        let bound = |mass: Option<f64>| mass.map(|mass| (stiffness * mass).sqrt());
        let free = if free_status == Status::Massless { Some(0.0) } else { free_mass };
        let bounds = [bound(free).filter(|_| found.is_free_along_motion), bound(rigid)];
        let impacts = undamped_impacts(evaluated, &[stiffness])?;
        let applies = |mass: &f64| found.is_free_along_motion && *mass > 0.0;
        Ok::<_, StudyError>(CompliantContactRecord {
            stiffness,
            frequency: rigid.map(|mass| (stiffness / mass).sqrt() / TAU),
            duration: rigid.map(|mass| PI * (mass / stiffness).sqrt()),
            impulse_change: compliance.map(|c| IMPULSE_CHANGE * stiffness * c),
            force_change: compliance.map(|c| FORCE_CHANGE * stiffness * c),
            peak_force_per_speed: bounds,
            peak_force: damping.speed().map(|speed| bounds.map(|bound| bound.map(|force| force * speed))),
            least_duration: free.filter(applies).map(|mass| PI * (mass / stiffness).sqrt()),
            impact: impacts.first().copied(),
        })
    };
    let contact = linear.map(contact).transpose()?;
    let elastic = match (has_bushes(evaluated), has_gears(evaluated)) {
        (true, false) => "bushes",
        (true, true) => "bushes and gears",
        (false, _) => "gears",
    };
    Ok(ComplianceRecord {
        elastic,
        free_mass,
        free_status,
        residual_compliance: compliance,
        residual_stiffness: positive.map(|c| 1.0 / c),
        rows: rows.collect(),
        lower_bounds_hold: found.is_free_along_motion,
        beside: linear_elements(evaluated).into_iter().map(|element| element.name).collect(),
        rigid_up_to: positive.map(|c| [0.01, 0.05].map(|change| change / (IMPULSE_CHANGE * c))),
        contact,
    })
}
