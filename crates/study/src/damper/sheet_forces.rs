//! Forces of a suspension sheet at a contact: the curve of its stop, springs and dampers.

use crate::checks::finding::Finding;
use crate::checks::finding_kind::FindingKind;
use crate::checks::findings::joint_list;
use crate::evaluation::prepared_question::EvaluatedQuestion;
use crate::model::loading::Model;
use crate::question::errors::question_error::StudyError;
use crate::question::errors::refusal::InvalidKey;
use crate::question::mass_question::MassQuestion;
use crate::question::tables::damping::DampingQuestion;
use crate::thresholds::SPRING_EFFECT;
use crate::values::force_curve::GivenCurve;
use percuss_contact::{CompliantContact, Damper, DamperCurve, restitution_with_parallel_forces};
use percuss_dynamics::{PointVelocity, Pose};
use percuss_mechanism::{ContactKind, ContactNormal, JointId, LinkId, SpringDamper};
use percuss_spatial::Vector3;
use percuss_suspension::kinematics::AntiRollBar;
use percuss_suspension::{SpringForce, TorsionBar, TyreForce};
use std::sync::Arc;

/// Spring or damper of a sheet: named contact, and ends (link, and point in its axes, m).
pub(crate) struct SheetElement<'a> {
    pub name: &'a str,
    pub ends: [(LinkId, Vector3<f64>); 2],
    pub force: ElementForce,
}

/// Force of a spring or a damper.
pub(crate) enum ElementForce {
    Spring(SpringForce),
    Damper(Arc<DamperCurve>),
}

/// Section of the sheet with the name of a contact, which can end in the side.
fn section(name: &str) -> &str {
    name.strip_suffix("_left").or(name.strip_suffix("_right")).unwrap_or(name)
}

/// Springs with a rate and dampers with a curve in the suspension sheet of a model.
pub(crate) fn sheet_elements(model: &Model) -> Vec<SheetElement<'_>> {
    let Some(sheet) = model.origin.sheet.as_deref() else { return Vec::new() };
    let forces = &sheet.understood.forces;
    let mechanism = &model.mechanism;
    let element = |contact: &'_ percuss_mechanism::NamedContact| {
        let (ContactNormal::Toward(other) | ContactNormal::Away(other)) = *contact.normal() else {
            return None;
        };
        let section = section(contact.name());
        let force = match contact.kind() {
            ContactKind::Spring => {
                let (_, spring) = forces.springs.iter().find(|(name, _)| name == section)?;
                ElementForce::Spring(Some(*spring).filter(|spring| spring.rate > 0.0)?)
            }
            ContactKind::Damper => {
                let (_, damper) = forces.dampers.iter().find(|(name, _)| name == section)?;
                ElementForce::Damper(Arc::clone(damper))
            }
            _ => return None,
        };
        let against = contact.against().unwrap_or(mechanism.root());
        Some(([(contact.link(), *contact.point()), (against, other)], force))
    };
    let found = mechanism.contacts().iter().filter_map(|contact| {
        let (ends, force) = element(contact)?;
        Some(SheetElement { name: contact.name(), ends, force })
    });
    found.collect()
}

/// Tyre of a sheet.
pub(crate) struct SheetTyre<'a> {
    /// Name of the link at the wheel centre.
    pub name: &'a str,
    pub link: LinkId,
    pub force: TyreForce,
}

/// Links of a section, with one side or both.
fn links_of<'a>(model: &'a Model, name: &'static str) -> impl Iterator<Item = (LinkId, &'a str)> {
    let links = model.mechanism.link_ids().map(|id| (id, model.mechanism.link(id).name()));
    links.filter(move |(_, link)| section(link) == name)
}

/// Tyres in the suspension sheet of a model, at the wheel centres.
pub(crate) fn sheet_tyres(model: &Model) -> Vec<SheetTyre<'_>> {
    let sheet = model.origin.sheet.as_deref();
    let Some(force) = sheet.and_then(|sheet| sheet.understood.forces.tyre) else { return Vec::new() };
    links_of(model, "wheel_centre").map(|(link, name)| SheetTyre { name, link, force }).collect()
}

/// Anti-roll bar with a stiffness in the suspension sheet of a model.
pub(crate) fn sheet_bars(model: &Model) -> Option<AntiRollBar> {
    let stiffness = model.origin.sheet.as_deref()?.understood.forces.anti_roll_bar?;
    AntiRollBar::of_suspension(&model.mechanism, stiffness)
}

/// Torsion bar of the suspension sheet of a model on this joint.
pub(crate) fn torsion_bar_of(model: &Model, joint: JointId) -> Option<&TorsionBar> {
    let bar = model.origin.sheet.as_deref()?.understood.forces.torsion_bar.as_ref()?;
    (section(model.mechanism.joint(joint).name()) == bar.joint("")).then_some(bar)
}

/// Moment of the spring of a joint at a pose (N·m): of a torsion bar of a sheet with a stated moment; 0 for others.
pub(crate) fn torsion_moment(model: &Model, pose: &Pose, joint: JointId, spring: &SpringDamper) -> f64 {
    match torsion_bar_of(model, joint).and_then(|bar| bar.preload) {
        Some(_) => spring.stiffness * (spring.reference - pose.joint(joint)[0]),
        None => 0.0,
    }
}

/// Springs and dampers of the joints of a model that move at a pose.
pub(crate) fn joint_springs(pose: &Pose) -> impl Iterator<Item = (JointId, SpringDamper)> {
    let of_joint = |id: JointId| Some((id, pose.mechanism().joint(id).spring()?));
    pose.mechanism().joint_ids().filter_map(of_joint).filter(|(id, _)| !pose.is_locked(*id))
}

impl SheetElement<'_> {
    /// Ends at a pose, world axes, m.
    fn points(&self, pose: &Pose) -> [Vector3<f64>; 2] {
        self.ends.map(|(link, point)| pose.link(link).point(&point))
    }

    /// Length at a pose, m.
    pub(crate) fn length(&self, pose: &Pose) -> f64 {
        let [a, b] = self.points(pose);
        (b - a).norm()
    }

    /// Change of the length per penetration of the contact; `None` if the motion does not determine it.
    fn length_rate(&self, evaluated: &EvaluatedQuestion) -> Option<f64> {
        let [a, b] = self.points(&evaluated.pose);
        let line = evaluated.pose.base().inverse_vector(&(b - a).try_normalize(0.0)?);
        let [va, vb] = self.ends.map(|(link, point)| velocity(evaluated, link, &point));
        Some(line.dot(&(vb? - va?)))
    }

    /// Whole force of a spring at the pose of the contact, N; `None` if the sheet has no preload.
    pub(crate) fn whole_force(&self, evaluated: &EvaluatedQuestion) -> Option<f64> {
        let ElementForce::Spring(spring) = self.force else { return None };
        let system = &evaluated.prepared.system;
        let drawn = system.pose(&system.configuration()).ok()?;
        Some(spring.preload? + spring.rate * (self.length(&drawn) - self.length(&evaluated.pose)))
    }
}

/// Velocity of a point of a link over the ground per closing speed of the contact, root axes.
fn velocity(evaluated: &EvaluatedQuestion, link: LinkId, point: &Vector3<f64>) -> Option<Vector3<f64>> {
    let response = evaluated.result.mechanism_response();
    match evaluated.pose.point_velocity_over_ground(response, link, point)? {
        PointVelocity::Known(velocity) => Some(velocity),
        PointVelocity::Undetermined => None,
    }
}

impl SheetTyre<'_> {
    /// Rise of the wheel centre per penetration of the contact: over the ground, and over the root link.
    fn rise(&self, evaluated: &EvaluatedQuestion) -> Option<(f64, f64)> {
        let pose = &evaluated.pose;
        let up = pose.base().inverse_vector(&Vector3::z());
        let own = velocity(evaluated, self.link, &Vector3::zeros())?;
        let root = pose.mechanism().root();
        let place = pose.link(root).inverse().point(&pose.link(self.link).point(&Vector3::zeros()));
        let of_root = velocity(evaluated, root, &place)?;
        Some((up.dot(&own), up.dot(&(own - of_root))))
    }

    /// Force at the touch, N: as given, or the force that balances the springs on the same side along the motion of the contact, without the
    /// weight of the wheel. Error: the reason why the tyre does not act.
    pub(crate) fn force_at_touch(&self, evaluated: &EvaluatedQuestion) -> Result<f64, String> {
        let rise = self.rise(evaluated).map(|(_, rise)| rise);
        if rise.is_some_and(|rise| rise < 0.0) {
            return Err("the closing motion lowers the wheel".to_owned());
        }
        if let Some(load) = self.force.load {
            return Ok(load);
        }
        let at_rest = || "its wheel is at rest in the motion of the contact: give tyre.load".to_owned();
        let rise = rise.filter(|rise| *rise > 0.0).ok_or_else(at_rest)?;
        let unknown = || "its force at the touch is unknown: give tyre.load, or spring.preload".to_owned();
        let side = self.name.strip_prefix("wheel_centre").unwrap_or_default();
        spring_balance(evaluated, side, rise).map(|force| force.max(0.0)).ok_or_else(unknown)
    }
}

/// Vertical force on a wheel, N, that balances the springs on its side along the motion of the contact. `rise`: rise of the wheel centre per
/// penetration. `None` without a spring, or if the force of one is unknown.
fn spring_balance(evaluated: &EvaluatedQuestion, side: &str, rise: f64) -> Option<f64> {
    let mut sum = None;
    for element in sheet_elements(evaluated.prepared.model) {
        if matches!(element.force, ElementForce::Spring(_)) && element.name.ends_with(side) {
            let power = element.whole_force(evaluated)? * element.length_rate(evaluated)?;
            sum = Some(sum.unwrap_or(0.0) - power / rise);
        }
    }
    let (model, pose) = (evaluated.prepared.model, &evaluated.pose);
    let bar = joint_springs(pose).find_map(|(joint, spring)| {
        let is_of_side = model.mechanism.joint(joint).name().ends_with(side);
        Some((joint, spring, torsion_bar_of(model, joint).filter(|_| is_of_side)?))
    });
    if let Some((joint, spring, bar)) = bar {
        bar.preload?;
        let rates = &evaluated.result.mechanism_response().joint_velocities;
        let rate = rates.get(joint.index())?.first()?;
        sum = Some(sum.unwrap_or(0.0) - torsion_moment(model, pose, joint, &spring) * rate / rise);
    }
    sum
}

/// Vertical forces on the wheels, N, that balance the springs of the sheet along the motion of the contact, with the links of the wheel centres.
/// `None` if a force is unknown, or if a wheel is at rest.
pub(crate) fn balancing_wheel_forces(evaluated: &EvaluatedQuestion) -> Option<Vec<(LinkId, f64)>> {
    let force = |(link, name): (LinkId, &str)| {
        let up = evaluated.pose.base().inverse_vector(&Vector3::z());
        let rise = up.dot(&velocity(evaluated, link, &Vector3::zeros())?);
        let side = name.strip_prefix("wheel_centre").unwrap_or_default();
        let force = spring_balance(evaluated, side, rise)?;
        force.is_finite().then_some((link, force))
    };
    links_of(evaluated.prepared.model, "wheel_centre").map(force).collect()
}

/// Forces of a model that act during a contact, in parallel with that of the contact.
pub(crate) struct ParallelForces<'e> {
    /// Names of springs, dampers, tyre and anti-roll bar of the sheet, and of joints with springs.
    pub names: Vec<String>,
    /// Tyres whose force at the touch is unknown, with the reason: they act, and `force` does not contain them.
    pub unknown: Vec<String>,
    /// Force against the penetration, over penetration (m) and rate (m/s).
    pub force: Box<dyn Fn(f64, f64) -> f64 + 'e>,
}

/// Springs, dampers, tyres and the anti-roll bar of the sheet, and springs of joints that act during the contact. To first order they act
/// on the contact as the change Σ k i² x of the spring forces since the touch, the damper forces Σ i F(i ẋ), and the same for a tyre until it
/// leaves the road; i is the change of the length, the twist or the height of the wheel per penetration. `None`: none acts.
pub(crate) fn parallel_forces<'e>(evaluated: &EvaluatedQuestion<'e>) -> Option<ParallelForces<'e>> {
    let EvaluatedQuestion { prepared, result, .. } = evaluated;
    if result.response.contact.is_moment {
        return None;
    }
    let model = prepared.model;
    let acting: Vec<(f64, SheetElement<'e>)> = sheet_elements(model)
        .into_iter()
        .filter_map(|element| Some((element.length_rate(evaluated)?, element)))
        .filter(|(ratio, _)| *ratio != 0.0)
        .collect();
    let mut tyres: Vec<(f64, f64, SheetTyre<'e>)> = Vec::new();
    let mut unknown = Vec::new();
    for tyre in sheet_tyres(model) {
        // A tyre that the motion lowers does not act.
        let Some((rise, _)) = tyre.rise(evaluated).filter(|rise| rise.0 != 0.0 && rise.1 >= 0.0) else {
            continue;
        };
        match tyre.force_at_touch(evaluated) {
            Ok(force) => tyres.push((rise, force, tyre)),
            Err(why) => unknown.push(format!("tyre at {} ({why})", tyre.name)),
        }
    }
    let rates = &result.mechanism_response().joint_velocities;
    let rate = |joint: JointId| rates.get(joint.index()).and_then(|rates| rates.first().copied());
    let bar = sheet_bars(model).and_then(|bar| {
        let twist = rate(bar.joint)? - bar.other.map_or(Some(0.0), rate)?;
        (twist != 0.0).then_some(bar.stiffness * twist * twist)
    });
    let mut names: Vec<String> = acting.iter().map(|(_, element)| element.name.to_owned()).collect();
    names.extend(bar.map(|_| "anti-roll bar".to_owned()));
    names.extend(tyres.first().map(|_| "tyre".to_owned()));
    // Stiffness and damping of the springs of joints at the contact.
    let (mut sprung, mut at_joints) = (Vec::new(), [0.0; 2]);
    for (joint, spring) in joint_springs(&evaluated.pose) {
        let squared = rate(joint).unwrap_or(0.0).powi(2);
        if squared > 0.0 {
            sprung.push(joint);
            at_joints[0] += spring.stiffness * squared;
            at_joints[1] += spring.damping * squared;
        }
    }
    if !sprung.is_empty() {
        names.push(format!("joints {}", joint_list(&model.mechanism, &sprung)));
    }
    if names.is_empty() && unknown.is_empty() {
        return None;
    }
    let beside = move |x: f64, v: f64| -> f64 {
        let force = |(i, element): &(f64, SheetElement)| match &element.force {
            ElementForce::Spring(spring) => spring.rate * i * i * x,
            ElementForce::Damper(curve) => i * curve.force(i * v),
        };
        let of_tyre = |(i, force, tyre): &(f64, f64, SheetTyre)| {
            let TyreForce { rate, damping, .. } = tyre.force;
            i * (force - (force - i * (rate * x + damping * v)).max(0.0))
        };
        acting.iter().map(force).sum::<f64>()
            + tyres.iter().map(of_tyre).sum::<f64>()
            + (bar.unwrap_or(0.0) + at_joints[0]) * x
            + at_joints[1] * v
    };
    Some(ParallelForces { names, unknown, force: Box::new(beside) })
}

/// Warning about springs, dampers, tyres and the anti-roll bar of the sheet that act during the contact, with both restitutions. `duration` (s)
/// and `alone`: duration and restitution without these forces.
pub(crate) fn springs_finding(
    evaluated: &EvaluatedQuestion,
    (compliant, damper): (CompliantContact, Damper),
    speed: f64,
    (duration, alone): (f64, f64),
) -> Result<Option<Finding>, StudyError> {
    let Some(ParallelForces { names, unknown, force }) = parallel_forces(evaluated) else { return Ok(None) };
    let left_out = match unknown.is_empty() {
        true => String::new(),
        false => format!("; not estimated: {}", unknown.join(", ")),
    };
    let lasts = format!("the contact lasts {:.1} ms, in which", 1e3 * duration);
    if names.is_empty() {
        let message = format!("{lasts} forces act that are not estimated: {}", unknown.join(", "));
        return Ok(Some(Finding::about_result(FindingKind::SpringsAct, message)));
    }
    let beside = restitution_with_parallel_forces(damper, compliant, speed, &force)?;
    let message = match beside {
        Some(e) if (e - alone).abs() <= SPRING_EFFECT && unknown.is_empty() => return Ok(None),
        Some(e) => format!("the restitution is about {e:.3} in place of {alone:.3}"),
        None => format!("the contact does not end; without them the restitution is {alone:.3}"),
    };
    let message = format!(
        "{lasts} springs and dampers of the model act ({}): {message}{left_out}; an impact in time includes them",
        names.join(", "),
    );
    Ok(Some(Finding::about_result(FindingKind::SpringsAct, message)))
}

/// Question with the force curve of the stop in the suspension sheet, if neither a stiffness nor a curve is given; a note about the default
/// law, or about a curve that is not used.
pub(crate) fn with_sheet_curve(
    evaluated: &EvaluatedQuestion,
    damping: &DampingQuestion,
) -> Result<(DampingQuestion, Option<Finding>), StudyError> {
    let mut damping = damping.clone();
    let of_sheet = sheet_curve(evaluated.prepared.model, &evaluated.prepared.question)?
        .filter(|_| damping.options.stop.is_none());
    let finding = match of_sheet {
        Some(given) if damping.has_stiffness() => (damping.stiffness_curve.as_ref() != Some(&given)).then(|| {
            let name = given.stop.as_deref().unwrap_or_default();
            let message = format!(
                "the force curve of {name} in the sheet is not used, because a stiffness or another curve is given{}",
                evaluated.prepared.question.names.hint("damping.stiffness")
            );
            Finding::about_result(FindingKind::CurveNotUsed, message)
        }),
        Some(given) => {
            damping.stiffness_curve = Some(given);
            // Exponent and alias with an exponent belong to a stiffness.
            if damping.exponent.is_some() {
                let why = "it is the exponent of a stiffness, but the force curve of the sheet is used; give `stiffness` too";
                return Err(InvalidKey::new("damping.exponent", why).into());
            }
            None
        }
        None => None,
    };
    let is_default =
        damping.stiffness_curve.is_some() && damping.law.is_none() && damping.separation.is_none();
    let finding = finding.or_else(|| {
        is_default.then(|| {
            let message = "law hunt-crossley, F = F_s(x)(1 + d ẋ) on the force curve F_s: a linear damper (kelvin-voigt) gives a soft stop its \
                           largest force at zero penetration";
            Finding::about_result(FindingKind::LawOfCurve, message.to_owned())
        })
    });
    Ok((damping, finding))
}

/// Force curve of the named contact in the suspension sheet of the model.
pub(crate) fn sheet_curve(model: &Model, question: &MassQuestion) -> Result<Option<GivenCurve>, StudyError> {
    let Some(sheet) = model.origin.sheet.as_deref() else { return Ok(None) };
    let Some(contact) = question.named_contact(&model.mechanism)? else { return Ok(None) };
    let name = contact.name();
    let stop = sheet.understood.forces.stops.iter().find(|(stop, _)| stop == section(name));
    Ok(stop.map(|(_, curve)| GivenCurve::of_stop(name, curve)))
}
