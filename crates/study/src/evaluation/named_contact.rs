//! Named contact of a result: its gap, the travel of the wheels, and findings about both.

use crate::checks::finding::Finding;
use crate::checks::finding_kind::FindingKind;
use crate::evaluation::motion_ratio::{MotionRatioRecord, wheel_ratios};
use crate::evaluation::prepared_question::{EvaluatedQuestion, PreparedQuestion};
use crate::model::loading::Model;
use crate::pose::touch::touching_stops;
use crate::question::errors::question_error::StudyError;
use crate::question::mass_question::MassQuestion;
use crate::thresholds::{FAR_TOUCH, STOP_ALIGNMENT, TOUCH_TOLERANCE, TOUCH_WRONG_WAY};
use nalgebra::DVector;
use percuss_dynamics::{Contact, Gap, PointVelocity, Pose};
use percuss_impact::Delassus;
use percuss_mechanism::{ContactKind, JointKind, LinkId, Mechanism, NamedContact};
use percuss_suspension::kinematics::wheel_centres;
use percuss_units::LengthUnit;
use schemars::JsonSchema;
use serde::Serialize;

/// Named contact of a result. Lengths in m.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct NamedContactRecord {
    /// Name.
    pub name: String,
    /// `stop`, `spring`, `damper`, `patch` or `other`.
    pub kind: &'static str,
    /// Body of the contact link: the link to which the contact link is fixed.
    pub on: String,
    /// Spring or damper between the same two links, such as the damper of a stop on its rod; null without one.
    pub element: Option<String>,
    /// Gap as drawn (all joints at 0); null if the parts always touch.
    pub gap_as_drawn: Option<f64>,
    /// Gap at the pose of the result; null if the parts always touch.
    pub gap: Option<f64>,
    /// True if the mechanism was moved until the stop touches.
    pub brought_to_touch: bool,
    /// Other stops that touch at this pose: the same stop of the other side of the vehicle.
    pub touching: Vec<String>,
    /// Effective mass of this stop, kg, in the motion in which all touching stops close at the same speed; null if no other
    /// stop touches, or if no impulses cause this motion.
    pub effective_mass_together: Option<f64>,
    /// Upward travel of each wheel centre from the pose as drawn to the pose of the result.
    pub wheel_travel: Vec<WheelTravelRecord>,
    /// Unit of lengths in texts.
    #[serde(skip)]
    pub unit: LengthUnit,
}

impl NamedContactRecord {
    /// True for a spring or damper, whose parts always touch.
    pub fn always_touches(&self) -> bool {
        [ContactKind::Spring, ContactKind::Damper].iter().any(|kind| kind.name() == self.kind)
    }
}

/// Upward travel of a wheel centre, m.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WheelTravelRecord {
    /// Link at the wheel centre.
    pub link: String,
    /// Travel, m.
    pub travel: f64,
}

/// Record of the named contact of a question; `None` without a named contact.
pub(crate) fn named_contact(evaluated: &EvaluatedQuestion) -> Result<Option<NamedContactRecord>, StudyError> {
    let EvaluatedQuestion { prepared, pose, .. } = evaluated;
    let mechanism = prepared.system.mechanism();
    let Some(contact) = prepared.question.named_contact(mechanism)? else { return Ok(None) };
    let gap = Gap::new(pose, contact);
    let touches = |gap: &Gap| gap.at(pose).abs() <= TOUCH_TOLERANCE * mechanism.characteristic_length();
    let mut stops = touching_stops(mechanism, &prepared.question, pose)?;
    stops.retain(|(_, gap)| touches(gap));
    let touching: Vec<String> = stops.iter().map(|(stop, _)| stop.name().to_owned()).collect();
    let stops: Vec<&NamedContact> = stops.into_iter().map(|(stop, _)| stop).collect();
    Ok(Some(NamedContactRecord {
        name: contact.name().to_owned(),
        kind: contact.kind().name(),
        on: mechanism.link(rigid_body_of(mechanism, contact.link())).name().to_owned(),
        element: element_of(mechanism, contact).map(|element| element.name().to_owned()),
        gap_as_drawn: contact.gap(),
        gap: gap.as_ref().map(|gap| gap.at(pose)),
        brought_to_touch: touching.iter().any(|name| name == contact.name()),
        effective_mass_together: mass_together(pose, &stops),
        touching: touching.into_iter().filter(|name| name != contact.name()).collect(),
        wheel_travel: wheel_travels(prepared, pose, contact.name()),
        unit: prepared.model.length_unit(),
    }))
}

/// Link that carries a link: the nearest ancestor without a fixed joint to its parent.
fn rigid_body_of(mechanism: &Mechanism, link: LinkId) -> LinkId {
    let fixed = |link: LinkId| {
        let joint = mechanism.joint(mechanism.parent_joint(link)?);
        (joint.kind() == JointKind::Fixed).then(|| joint.parent())
    };
    std::iter::successors(Some(link), |link| fixed(*link)).last().unwrap_or(link)
}

/// Spring or damper between the two links of a stop.
fn element_of<'m>(mechanism: &'m Mechanism, stop: &NamedContact) -> Option<&'m NamedContact> {
    let is_element = |other: &&NamedContact| {
        matches!(other.kind(), ContactKind::Spring | ContactKind::Damper)
            && other.link() == stop.link()
            && other.against() == stop.against()
    };
    mechanism.contacts().iter().find(is_element).filter(|_| stop.kind() == ContactKind::Stop)
}

/// Upward travels of the wheel centres on the side of a contact, from the pose as drawn to a pose.
pub(crate) fn wheel_travels(
    prepared: &PreparedQuestion,
    pose: &Pose,
    contact: &str,
) -> Vec<WheelTravelRecord> {
    let mechanism = prepared.system.mechanism();
    let wheels = wheel_centres(mechanism, contact);
    let drawn =
        (!wheels.is_empty()).then(|| prepared.system.pose(&prepared.system.configuration()).ok()).flatten();
    let travel = |link: LinkId| {
        let height = |pose: &Pose| pose.link(link).translation.z;
        let travel = height(pose) - height(drawn.as_ref()?);
        Some(WheelTravelRecord { link: mechanism.link(link).name().to_owned(), travel })
    };
    wheels.into_iter().filter_map(travel).collect()
}

/// Effective mass of the first of several stops, kg, in the motion in which all close at the same speed: the first impulse of
/// W p = 1, with the inverse masses W over the normals. `None` for one stop, or if an impulse would pull.
fn mass_together(pose: &Pose, stops: &[&NamedContact]) -> Option<f64> {
    if stops.len() < 2 {
        return None;
    }
    let root = pose.mechanism().root();
    let located = stops.iter().map(|stop| pose.locate(&Contact::named(stop, root)).ok());
    let located: Vec<_> = located.collect::<Option<_>>()?;
    let matrix = Delassus::new(pose, &located).ok()?.normal_matrix();
    let impulses = matrix.cholesky()?.solve(&DVector::from_element(stops.len(), 1.0));
    impulses.iter().all(|impulse| *impulse > 0.0 && impulse.is_finite()).then(|| impulses[0])
}

/// Findings about the named contact of a result: the path of a stop to its touch, and the motion of a spring or damper as drawn. `ratios`:
/// motion ratios of the wheels.
pub(crate) fn named_contact_findings(
    evaluated: &EvaluatedQuestion,
    contact: &NamedContactRecord,
    ratios: &[MotionRatioRecord],
) -> Vec<Finding> {
    // At another pose a rocker may have passed its dead centre.
    let is_drawn = !evaluated.prepared.question.gives_pose();
    let extension = extension_finding(contact, ratios).filter(|_| is_drawn);
    stop_findings(evaluated, contact, ratios).into_iter().chain(extension).collect()
}

/// Findings about the named contact of a question at its own pose, for results at other poses; empty if this pose has no result.
pub(crate) fn findings_at_touch(model: &Model, question: &MassQuestion) -> Vec<Finding> {
    let found = || {
        question.named_contact(&model.mechanism).ok()??;
        let evaluated = EvaluatedQuestion::new(model, question).ok()?;
        let contact = named_contact(&evaluated).ok()??;
        Some(named_contact_findings(&evaluated, &contact, &wheel_ratios(&evaluated)))
    };
    found().unwrap_or_default()
}

/// Finding about a spring or damper that extends while the wheel moves up.
fn extension_finding(contact: &NamedContactRecord, ratios: &[MotionRatioRecord]) -> Option<Finding> {
    let wheel = contact.wheel_travel.first().filter(|_| contact.always_touches())?;
    let ratio = ratios.iter().find(|ratio| ratio.link == wheel.link)?.contact_per_wheel?;
    let message = format!(
        "the {} {} extends while the wheel moves up (motion ratio {ratio:.3}): are its two points exchanged?",
        contact.kind, contact.name
    );
    (ratio < 0.0).then(|| Finding::about_result(FindingKind::ExtendingElement, message))
}

/// Findings about the path to the touch: a bump stop that touches while the wheel moves down, or a rebound stop while it moves
/// up; a long travel; a pad that hardly moves along the direction of the stop. Each has a common cause in the sheet.
fn stop_findings(
    evaluated: &EvaluatedQuestion,
    contact: &NamedContactRecord,
    ratios: &[MotionRatioRecord],
) -> Vec<Finding> {
    let mut found = Vec::new();
    let (true, Some(wheel)) = (contact.brought_to_touch, contact.wheel_travel.first()) else { return found };
    let (name, travel) = (&contact.name, contact.unit.text(wheel.travel.abs()));
    let mut warn = |kind, message| found.push(Finding::about_result(kind, message));
    // The gap closes on the whole path; a wheel that moves back at its end has passed a dead centre.
    let ratio =
        ratios.iter().find(|ratio| ratio.link == wheel.link).and_then(|ratio| ratio.contact_per_wheel);
    if ratio.is_some_and(|ratio| ratio * wheel.travel < 0.0) && wheel.travel.abs() > TOUCH_WRONG_WAY {
        let message = format!(
            "{name} touches after {travel} of wheel travel, while the wheel moves back: the suspension passes a dead centre before the \
             touch; check the gap, the points and the direction of the stop"
        );
        warn(FindingKind::BehindDeadCentre, message);
    }
    let stops = [("bump_stop", "rebound_stop", 1.0, "down"), ("rebound_stop", "bump_stop", -1.0, "up")];
    for (stop, other, sign, sense) in stops {
        if name.starts_with(stop) && sign * wheel.travel < -TOUCH_WRONG_WAY {
            let message = format!(
                "{name} touches after the wheel has moved {sense} by {travel}: is it the {other}, or are its pad and \
                 face exchanged, or its direction reversed?"
            );
            warn(FindingKind::WrongWayStop, message);
        }
    }
    if wheel.travel.abs() > FAR_TOUCH {
        let message = format!(
            "{name} touches after {travel} of wheel travel: check its gap with the unit, its points and its direction"
        );
        warn(FindingKind::FarContactTravel, message);
    }
    if let Some(cosine) = alignment(evaluated).filter(|cosine| *cosine < STOP_ALIGNMENT) {
        let message = format!(
            "the pad of {name} moves at {:.0}° to the direction of the stop: check this direction and the points of the stop",
            cosine.acos().to_degrees()
        );
        warn(FindingKind::ObliqueStop, message);
    }
    found
}

/// Cosine of the angle between the normal of a contact and the motion of the contact point relative to the other side: its
/// inverse is the relative speed per unit closing speed. `None` if a velocity is undetermined.
fn alignment(evaluated: &EvaluatedQuestion) -> Option<f64> {
    let EvaluatedQuestion { pose, contact, result, .. } = evaluated;
    let at = pose.link(contact.link).point(&contact.point);
    let velocity = |link| {
        let point = pose.link(link).inverse_point(&at);
        match pose.point_velocity(result.mechanism_response(), link, &point)? {
            PointVelocity::Known(velocity) => Some(velocity),
            PointVelocity::Undetermined => None,
        }
    };
    let mut relative = velocity(contact.link)?;
    if let Some(other) = contact.against {
        relative -= velocity(other)?;
    }
    Some(1.0 / relative.norm())
}
