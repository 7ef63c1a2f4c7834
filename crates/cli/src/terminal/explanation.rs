//! Friction thresholds, motion ratios and named contacts, as text.

use crate::terminal::number::{number, triple};
use percuss_study::{
    EstimateRecord, FrictionThresholdsRecord, MotionRatioRecord, NamedContactRecord, UPWARDS,
    WheelTravelRecord,
};

/// Coefficients of friction for sticking, jamming and wedging as text; `None` for a contact point that does not slide while the gap closes.
pub fn friction_thresholds(found: &FrictionThresholdsRecord) -> Option<String> {
    match found.slope {
        None => Some(match (found.sticking.map(number), found.jamming.map(number)) {
            (Some(sticks), Some(jams)) => {
                format!("the contact can stick from a coefficient of {sticks}, and jam from {jams}")
            }
            (Some(sticks), None) => {
                format!("the contact can stick from a coefficient of {sticks}; it cannot jam")
            }
            (None, Some(jams)) => {
                format!("the contact cannot stick; it can jam from a coefficient of {jams}")
            }
            (None, None) => "the contact can neither stick nor jam".to_owned(),
        }),
        Some(_) => {
            found.jamming.map(|wedges| format!("the contact wedges from a coefficient of {}", number(wedges)))
        }
    }
}

/// Motion ratio with its definition.
pub fn motion_ratio(ratio: &MotionRatioRecord) -> String {
    let whole = match &ratio.held {
        Some(joint) => format!("; with the joint {joint} held"),
        None if ratio.one_travel => String::new(),
        None => "; for the motion of this impact only".to_owned(),
    };
    format!("{}{whole}", ratio_per_travel(ratio.contact_per_wheel, &ratio.link, Some(ratio.direction)))
}

/// Motion ratio of the estimate with its definition.
pub fn estimate_ratio(estimate: &EstimateRecord) -> String {
    let point = if estimate.point_link == [0.0; 3] {
        estimate.links[0].clone()
    } else {
        format!("{} m of {}", triple(&estimate.point_link), estimate.links[0])
    };
    ratio_per_travel(estimate.motion_ratio, &point, estimate.direction)
}

/// Motion ratio per travel of a point along a direction, or along its path.
fn ratio_per_travel(ratio: Option<f64>, point: &str, direction: Option<[f64; 3]>) -> String {
    let travel = match direction {
        Some(UPWARDS) => format!("upward travel of {point}"),
        Some(direction) => format!("travel of {point} along {} (world axes)", triple(&direction)),
        None => format!("length of the path of {point}"),
    };
    let ratio = ratio.map_or_else(|| "infinite".to_owned(), number);
    format!("{ratio}, closing of the contact per {travel}")
}

/// Name, gap and wheel travel of a named contact.
pub fn named_contact(contact: &NamedContactRecord) -> Vec<(&'static str, String)> {
    let mut facts = vec![(CONTACT, format!("{} ({}), on {}", contact.name, contact.kind, body_of(contact)))];
    facts.extend(travel_and_gap(contact).map(|text| ("travel and gap", text)));
    facts.extend(both_stops(contact));
    facts
}

/// Wheel travel at the pose of the result, and the gap of the contact; `None` for parts that always touch.
pub fn travel_and_gap(contact: &NamedContactRecord) -> Option<String> {
    let (drawn, gap) = contact.gap_as_drawn.zip(contact.gap)?;
    let with_name = contact.wheel_travel.len() > 1;
    let travel = |wheel: &WheelTravelRecord| {
        let sense = if wheel.travel < 0.0 { "down" } else { "up" };
        let name = if with_name { &*wheel.link } else { "wheel" };
        format!("{name} {} {sense}", contact.unit.text(wheel.travel.abs()))
    };
    let travels: Vec<String> = contact.wheel_travel.iter().map(travel).collect();
    let drawn = contact.unit.text(drawn);
    let gap = match gap {
        _ if contact.brought_to_touch && contact.touching.is_empty() => format!("gap of {drawn} closed"),
        _ if contact.brought_to_touch => {
            format!("gap of {drawn} closed, as that of {}", contact.touching.join(", "))
        }
        gap if gap < 0.0 => {
            format!("pressed in by {}; gap in the design position {drawn}", contact.unit.text(-gap))
        }
        gap => format!("no touch: gap {} here, {drawn} in the design position", contact.unit.text(gap)),
    };
    let place = if travels.is_empty() {
        String::new()
    } else {
        format!("{} from the design position; ", travels.join(", "))
    };
    Some(place + &gap)
}

/// m̄ of the motion in which the stop of the other side closes too; `None` without one.
pub fn both_stops(contact: &NamedContactRecord) -> Option<(&'static str, String)> {
    let together = contact.effective_mass_together?;
    let others = contact.touching.join(", ");
    let text =
        format!("{} kg if {others} closes at the same speed; above: this stop alone", number(together));
    Some(("both stops", text))
}

/// Name of the fact with the name and the body of a named contact.
pub const CONTACT: &str = "contact";

/// Body of a named contact, with the damper of a stop on its rod.
pub fn body_of(contact: &NamedContactRecord) -> String {
    match &contact.element {
        Some(element) => format!("{element} of {}", contact.on),
        None => contact.on.clone(),
    }
}
