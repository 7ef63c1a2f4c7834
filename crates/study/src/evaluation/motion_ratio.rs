//! Motion ratios: closing speed of the contact per speed of a wheel or of a given point.

use crate::evaluation::prepared_question::{EvaluatedQuestion, compile};
use crate::pose::point_travel::reference_link;
use crate::question::errors::question_error::StudyError;
use crate::question::link_points::RatioPoint;
use crate::thresholds::{INVERSE_RATIO_TOLERANCE, SHORTEST_DIRECTION};
use nalgebra::Vector3;
use percuss_dynamics::{
    Configuration, Contact, ContactResponse, Direction, EffectiveMass, Frame, LocatedContact, PointVelocity,
    Pose,
};
use percuss_mechanism::LinkId;
use percuss_suspension::kinematics::{WHEEL_CENTRE, sliding_rack, wheel_points};
use schemars::JsonSchema;
use serde::Serialize;

/// Motion ratio of the contact relative to a point, in the motion v*: closing of the contact per travel of the point, such as
/// spring compression per wheel travel.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MotionRatioRecord {
    /// Link of the point: `wheel_centre` or `contact_patch` if the model has these links, or the requested
    /// link.
    pub link: String,
    /// The point in the link's frame, m.
    pub point: [f64; 3],
    /// Direction of the speed, a unit vector in world axes.
    pub direction: [f64; 3],
    /// Closing speed of the contact per speed of the point along the direction (rad/m for a moment); negative if the contact closes while
    /// the point moves against the direction. Null if the point does not move.
    pub contact_per_wheel: Option<f64>,
    /// True if every motion of the mechanism has this ratio; otherwise the ratio holds for the motion v* only.
    pub one_travel: bool,
    /// Joint that is held for this ratio, although it moves in the impact: the rack of a steered axle; null if none is.
    pub held: Option<String>,
}

/// Motion ratios of the requested points.
pub(crate) fn requested_ratios(
    evaluated: &EvaluatedQuestion,
    given: &[RatioPoint],
) -> Result<Vec<MotionRatioRecord>, StudyError> {
    let mechanism = &evaluated.prepared.model.mechanism;
    let response = evaluated.result.mechanism_response();
    let mut found = Vec::new();
    for ratio_point in given {
        let link = mechanism.find_link(&ratio_point.link);
        let link = link.map_err(StudyError::about("contact.ratio_at"))?;
        let (point, direction) = (Vector3::from(ratio_point.point), Vector3::from(ratio_point.direction));
        if !(direction.norm() > SHORTEST_DIRECTION && direction.norm().is_finite()) {
            let why = "the direction has no length; expected a vector such as 0,0,1";
            return Err(StudyError::input("contact.ratio_at", why));
        }
        found.extend(ratio(&evaluated.pose, response, link, point, direction.normalize()));
    }
    Ok(found)
}

/// Motion ratios of the wheels, as far as they hold for every motion.
///
/// 1/r = d · v_P per unit closing speed in v*. Let r′ be the speed of the contact per unit speed of the point in
/// the response of a contact at the point. r holds for every motion if r′ = r; r′/r is the squared cosine
/// between both motions in the metric of M.
pub(crate) fn wheel_ratios(evaluated: &EvaluatedQuestion) -> Vec<MotionRatioRecord> {
    let mechanism = &evaluated.prepared.model.mechanism;
    let wheels = wheel_points(mechanism, evaluated.prepared.question.contact.link());
    let of_wheels = |pose: &Pose, response: &ContactResponse| -> Vec<MotionRatioRecord> {
        let ratio = |link| ratio(pose, response, link, Vector3::zeros(), Vector3::z());
        wheels.iter().filter_map(|link| ratio(*link)).filter(|ratio| ratio.one_travel).collect()
    };
    let free = of_wheels(&evaluated.pose, evaluated.result.mechanism_response());
    // The travel of a wheel is that of its centre. A contact patch moves with itself in every motion, which determines no travel.
    let is_of_centre = |ratio: &MotionRatioRecord| ratio.link.starts_with(WHEEL_CENTRE);
    let has_centre = wheels.is_empty() || free.iter().any(is_of_centre);
    let held = if has_centre { None } else { with_rack_held(evaluated) };
    let held = held.map_or_else(Vec::new, |(pose, response, rack)| {
        let with_rack = |ratio| MotionRatioRecord { held: Some(rack.clone()), ..ratio };
        of_wheels(&pose, &response).into_iter().map(with_rack).collect()
    });
    if held.is_empty() { free } else { held }
}

/// The pose and the response with the rack held at its position, and the name of the rack; `None` without a rack that can slide.
fn with_rack_held(evaluated: &EvaluatedQuestion) -> Option<(Pose, ContactResponse, String)> {
    let EvaluatedQuestion { prepared, pose, contact, .. } = evaluated;
    let mechanism = &prepared.model.mechanism;
    let rack = sliding_rack(mechanism).filter(|rack| !pose.is_locked(*rack))?;
    let name = mechanism.joint(rack).name().to_owned();
    let mut question = prepared.question.clone().into_owned();
    question.conditions.lock.push(name.clone());
    let system = compile(mechanism, &question, None).ok()?;
    let mut positions = Configuration::from_positions(mechanism, pose.positions()).ok()?;
    positions.set_base(*pose.base());
    let held = system.pose(&positions).ok()?;
    let response = held.respond(contact).ok()?;
    Some((held, response, name))
}

/// Motion ratio of a point along a direction; `None` if the velocity is undetermined.
fn ratio(
    pose: &Pose,
    response: &ContactResponse,
    link: LinkId,
    point: Vector3<f64>,
    direction: Vector3<f64>,
) -> Option<MotionRatioRecord> {
    if response.singular_pose {
        return None;
    }
    let speed_of_point = speed(pose, response, link, &point, &direction)?;
    let own = Contact {
        link,
        against: reference_link(pose, response),
        point,
        normal: Direction::Along(direction, Frame::World),
    };
    let own_ratio = pose.respond(&own).ok().filter(|own| !own.singular_pose).and_then(|own| {
        let EffectiveMass::Finite(_) = own.effective_mass else { return None };
        let LocatedContact { link, against, point_link, normal_world, .. } = &response.contact;
        let velocity = pose.point_velocity_against(&own, *link, point_link, *against)?;
        along(pose, velocity, normal_world)
    });
    let one_travel = match response.contact.is_moment {
        // A moment has no contact point whose velocity could be compared.
        true => pose.degrees_of_freedom() == 1,
        false => own_ratio.is_some_and(|own| (speed_of_point * own - 1.0).abs() <= INVERSE_RATIO_TOLERANCE),
    };
    Some(MotionRatioRecord {
        link: pose.mechanism().link(link).name().to_owned(),
        point: point.into(),
        direction: direction.into(),
        contact_per_wheel: (speed_of_point != 0.0).then(|| speed_of_point.recip()),
        one_travel,
        held: None,
    })
}

/// Speed of a point along a world direction in a response, relative to [`reference_link`].
fn speed(
    pose: &Pose,
    response: &ContactResponse,
    link: LinkId,
    point: &Vector3<f64>,
    direction: &Vector3<f64>,
) -> Option<f64> {
    along(
        pose,
        pose.point_velocity_against(response, link, point, reference_link(pose, response))?,
        direction,
    )
}

/// Component of a velocity along a world direction; `None` if undetermined.
fn along(pose: &Pose, velocity: PointVelocity, direction: &Vector3<f64>) -> Option<f64> {
    match velocity {
        PointVelocity::Known(v) => Some(pose.base().vector(&v).dot(direction)),
        PointVelocity::Undetermined => None,
    }
}
