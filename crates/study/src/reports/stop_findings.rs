//! Findings about the way of a stop to its touch.

use crate::checks::finding::Finding;
use crate::checks::finding_kind::FindingKind;
use crate::evaluation::named_contact::NamedContactRecord;
use crate::reports::motion_ratio::MotionRatioRecord;
use crate::thresholds::{FAR_TOUCH, SLOW_STOP, TOUCH_WRONG_WAY};

/// Findings about the way to the touch: a bump stop that touches while the wheel moves down, or a rebound stop while it moves
/// up; a long travel; a stop that hardly closes. Each has a common cause in the sheet.
pub(crate) fn stop_findings(contact: &NamedContactRecord, ratios: &[MotionRatioRecord]) -> Vec<Finding> {
    let mut found = Vec::new();
    let (true, Some(wheel)) = (contact.brought_to_touch, contact.wheel_travel.first()) else { return found };
    let (name, millimetres) = (&contact.name, 1e3 * wheel.travel.abs());
    let ways = [("bump_stop", 1.0, "down"), ("rebound_stop", -1.0, "up")];
    for (stop, sign, sense) in ways.into_iter().filter(|(stop, ..)| name.starts_with(stop)) {
        let other = ways.iter().find(|(other, ..)| *other != stop).map_or("", |(other, ..)| other);
        if sign * wheel.travel < -TOUCH_WRONG_WAY {
            let message = format!(
                "{name} touches after the wheel has moved {sense} by {millimetres:.0} mm: is it the {other}, or are its pad and \
                 face exchanged, or its direction reversed?"
            );
            found.push(Finding::about_result(FindingKind::WrongWayStop, message));
        }
    }
    if wheel.travel.abs() > FAR_TOUCH {
        let message = format!(
            "{name} touches after {millimetres:.0} mm of wheel travel: check its gap with the unit, its points and its direction"
        );
        found.push(Finding::about_result(FindingKind::FarContactTravel, message));
    }
    let closing =
        ratios.iter().find(|ratio| ratio.link == wheel.link).and_then(|ratio| ratio.contact_per_wheel);
    if let Some(closing) = closing.map(f64::abs).filter(|closing| *closing < SLOW_STOP) {
        let message = format!(
            "{name} closes by {closing:.2} mm per millimetre of wheel travel: does its direction follow the motion of its pad?"
        );
        found.push(Finding::about_result(FindingKind::SlowStop, message));
    }
    found
}
