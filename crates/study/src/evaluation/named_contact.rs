//! Named contact of a result: its gap and the travel of the wheels.

use crate::evaluation::prepared_question::EvaluatedQuestion;
use crate::model::wheel_points::wheel_centres;
use crate::pose::touch::touching_stops;
use crate::question::errors::question_error::StudyError;
use crate::thresholds::TOUCH_TOLERANCE;
use percuss_dynamics::{Gap, Pose};
use percuss_mechanism::LinkId;
use serde::Serialize;

/// Named contact of a result. Lengths in m.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct NamedContactRecord {
    /// Name.
    pub name: String,
    /// `stop`, `spring`, `damper`, `patch` or `other`.
    pub kind: &'static str,
    /// Gap as drawn (all joints at 0); null if the parts always touch.
    pub gap_as_drawn: Option<f64>,
    /// Gap at the pose of the result; null if the parts always touch.
    pub gap: Option<f64>,
    /// True if the mechanism was moved until the stop touches.
    pub brought_to_touch: bool,
    /// Stops that touch with it: those of the other side of the vehicle.
    pub touching: Vec<String>,
    /// Upward travel of each wheel centre from the pose as drawn to the pose of the result.
    pub wheel_travel: Vec<WheelTravelRecord>,
}

/// Upward travel of a wheel centre, m.
#[derive(Clone, Debug, PartialEq, Serialize)]
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
    let stops = touching_stops(mechanism, &prepared.question, pose)?;
    let touching = stops.iter().filter(|(_, gap)| touches(gap)).map(|(stop, _)| stop.name().to_owned());
    let touching: Vec<String> = touching.collect();
    let wheels = wheel_centres(mechanism, contact.name());
    let drawn =
        (!wheels.is_empty()).then(|| prepared.system.pose(&prepared.system.configuration()).ok()).flatten();
    let travel = |link: LinkId| {
        let height = |pose: &Pose| pose.link(link).translation.z;
        let travel = height(pose) - height(drawn.as_ref()?);
        Some(WheelTravelRecord { link: mechanism.link(link).name().to_owned(), travel })
    };
    Ok(Some(NamedContactRecord {
        name: contact.name().to_owned(),
        kind: contact.kind().name(),
        gap_as_drawn: contact.gap(),
        gap: gap.as_ref().map(|gap| gap.at(pose)),
        brought_to_touch: touching.iter().any(|name| name == contact.name()),
        touching: touching.into_iter().filter(|name| name != contact.name()).collect(),
        wheel_travel: wheels.into_iter().filter_map(travel).collect(),
    }))
}
