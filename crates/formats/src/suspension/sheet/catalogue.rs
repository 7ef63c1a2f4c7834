//! Templates of sheets as data. This table defines the contents of sheets for reading, building, writing and
//! documentation.

use super::axles::AXLES;
use super::independent::INDEPENDENT;
use super::parts::{Part, Template};
use super::trailing::TRAILING;

/// All templates.
pub(crate) fn templates() -> impl Iterator<Item = &'static Template> {
    INDEPENDENT.iter().chain(TRAILING).chain(AXLES)
}

/// Meaning of each hardpoint key, the same in every template.
pub(crate) const POINTS: &[(&str, &str)] = &[
    ("wheel_centre", "the wheel's centre"),
    ("lower_front", "lower arm, front bush on the chassis"),
    ("lower_back", "lower arm, rear bush on the chassis"),
    ("lower_ball", "lower arm, ball joint on the upright"),
    ("upper_front", "upper arm, front bush on the chassis"),
    ("upper_back", "upper arm, rear bush on the chassis"),
    ("upper_ball", "upper arm, ball joint on the upright"),
    ("strut_top", "strut, upper mount on the chassis"),
    ("strut_bottom", "strut, a point of its line on the upright"),
    ("arm_outer", "trailing arm, outer bush on the chassis"),
    ("arm_inner", "trailing arm, inner bush on the chassis"),
    ("arm_chassis", "trailing arm, ball joint on the chassis"),
    ("upper_link_chassis", "upper link, end on the chassis"),
    ("upper_link_outer", "upper link, end on the wheel's side"),
    ("lower_link_chassis", "lower link, end on the chassis"),
    ("lower_link_outer", "lower link, end on the wheel's side"),
    ("lateral_chassis", "lateral link, end on the chassis"),
    ("lateral_outer", "lateral link, end on the upright"),
    ("trailing_link_chassis", "trailing link, end on the chassis"),
    ("trailing_link_outer", "trailing link, end on the upright"),
    ("tie_rod_inner", "tie rod, end on the rack (or on the chassis)"),
    ("tie_rod_outer", "tie rod, end on the upright"),
    ("pushrod_outer", "pushrod, end on the wheel's side"),
    ("pushrod_rocker", "pushrod, end on the rocker"),
    ("rocker_front", "rocker, front point of its axis on the chassis"),
    ("rocker_back", "rocker, rear point of its axis on the chassis"),
    ("pivot_front", "axle tube, front point of its pivot on the chassis"),
    ("pivot_back", "axle tube, rear point of its pivot on the chassis"),
    ("middle_link_chassis", "upper link in the middle, end on the chassis"),
    ("middle_link_axle", "upper link in the middle, end on the axle"),
    ("panhard_chassis", "Panhard rod, end on the chassis"),
    ("panhard_axle", "Panhard rod, end on the axle"),
    ("watt_pivot", "Watt's crank, its pivot on the axle; it turns about the vehicle's x"),
    ("watt_left_chassis", "Watt's left rod, end on the chassis"),
    ("watt_left_crank", "Watt's left rod, end on the crank"),
    ("watt_right_chassis", "Watt's right rod, end on the chassis"),
    ("watt_right_crank", "Watt's right rod, end on the crank"),
    ("spring_seat", "spring, seat on the moving link"),
    ("spring_chassis_seat", "spring, seat on the chassis"),
    ("damper_seat", "damper, end on the moving link"),
    ("damper_chassis_seat", "damper, end on the chassis"),
    ("bump_stop_pad", "bump stop, its pad on the moving link"),
    ("bump_stop", "bump stop, on the chassis"),
    ("rebound_stop_pad", "rebound stop, its pad on the moving link"),
    ("rebound_stop", "rebound stop, on the chassis"),
    ("anti_roll_bar_outer", "anti-roll bar, outer point of its axis"),
    ("anti_roll_bar_inner", "anti-roll bar, inner point of its axis"),
    ("drop_link_bar", "drop link, end on the anti-roll bar"),
    ("drop_link_end", "drop link, end on the suspension"),
];

/// Optional pairs of points between two bodies: section, points. A pair is given or left out as a whole.
pub(crate) const SEATS: [(&str, [&str; 2]); 4] = [
    ("spring", ["spring_seat", "spring_chassis_seat"]),
    ("damper", ["damper_seat", "damper_chassis_seat"]),
    ("bump_stop", ["bump_stop_pad", "bump_stop"]),
    ("rebound_stop", ["rebound_stop_pad", "rebound_stop"]),
];

/// Points of the anti-roll bar, optional as a whole.
pub(crate) const BAR: [&str; 4] =
    ["anti_roll_bar_outer", "anti_roll_bar_inner", "drop_link_bar", "drop_link_end"];

/// Parts of the anti-roll bar.
pub(crate) const BAR_PARTS: [Part; 2] = [
    Part::Hinge {
        link: "anti_roll_bar",
        parent: "chassis",
        points: ["anti_roll_bar_outer", "anti_roll_bar_inner"],
    },
    Part::Rod {
        link: "drop_link",
        ends: [("anti_roll_bar", "drop_link_bar"), ("drop_link.on", "drop_link_end")],
    },
];

/// Description of each body.
pub(crate) const BODIES: &[(&str, &str)] = &[
    ("lower_arm", "the lower arm"),
    ("upper_arm", "the upper arm"),
    ("upright", "the upright (knuckle) with caliper and all that does not turn with the wheel"),
    ("spindle", "what turns with the wheel but the wheel: hub, disc"),
    ("tie_rod", "the tie rod"),
    ("strut", "the part of the strut that stays with the chassis' mount"),
    ("trailing_arm", "the trailing arm with all that is fixed to it"),
    ("upper_link", "the upper link"),
    ("lower_link", "the lower link"),
    ("lateral", "the lateral link"),
    ("trailing_link", "the trailing link"),
    ("upper_front_rod", "the upper arm's front rod"),
    ("upper_back_rod", "the upper arm's rear rod"),
    ("lower_front_rod", "the lower arm's front rod"),
    ("lower_back_rod", "the lower arm's rear rod"),
    ("pushrod", "the pushrod"),
    ("rocker", "the rocker"),
    ("beam", "this side's half of the beam, fixed to the arm"),
    ("axle_tube", "the axle tube with all that does not turn with the wheel"),
    ("axle", "the whole axle with all that does not turn with the wheels"),
    ("middle_link", "the upper link in the middle"),
    ("panhard_rod", "the Panhard rod"),
    ("watt_crank", "Watt's crank"),
    ("watt_left_rod", "Watt's left rod"),
    ("watt_right_rod", "Watt's right rod"),
    ("anti_roll_bar", "this side's half of the anti-roll bar: its inertia counts, its stiffness does not"),
    ("drop_link", "the drop link"),
];

/// Description of a key.
pub(crate) fn text_of(table: &[(&'static str, &'static str)], key: &str) -> &'static str {
    table.iter().find(|(known, _)| *known == key).map_or("", |(_, text)| text)
}

impl Template {
    /// True if a hardpoint belongs to the axle as a whole, not to one side.
    pub fn is_central(&self, point: &str) -> bool {
        self.axle && ["middle_link", "panhard", "watt"].iter().any(|start| point.starts_with(start))
    }

    /// Points that are optional together with this point; `None` for a mandatory point.
    pub fn group_of(point: &str) -> Option<&'static [&'static str]> {
        let seats = SEATS.iter().find(|(_, pair)| pair.contains(&point));
        seats.map(|(_, pair)| &pair[..]).or_else(|| BAR.contains(&point).then_some(&BAR[..]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_key_has_its_words_and_every_part_its_points() {
        for template in templates() {
            let has = |key: &str| template.points.iter().any(|(known, _)| *known == key);
            for (key, _) in template.points {
                assert_ne!(text_of(POINTS, key), "", "{}: {key}", template.name);
            }
            for body in template.bodies {
                assert_ne!(text_of(BODIES, body.key), "", "{}: {}", template.name, body.key);
            }
            let points = template.parts.iter().flat_map(|part| match part {
                Part::Hinge { points, .. } | Part::Strut { line: points, .. } => points.to_vec(),
                Part::Swivel { at, .. }
                | Part::Ball { at, .. }
                | Part::Free { at, .. }
                | Part::Fixed { at, .. }
                | Part::Close { at, .. } => vec![*at],
                Part::Rod { ends, .. } => ends.map(|(_, point)| point).to_vec(),
                Part::Axle | Part::Wheel { .. } => vec!["wheel_centre"],
            });
            for point in points {
                assert!(has(point), "{}: {point}", template.name);
            }
            for key in SEATS.iter().flat_map(|(_, pair)| pair).chain(&BAR) {
                assert!(has(key), "{}: the example lacks {key}", template.name);
            }
            for section in ["spring", "damper", "bump_stop", "rebound_stop", "drop_link"] {
                assert!(template.on.iter().any(|(key, _)| *key == section), "{}: {section}", template.name);
            }
        }
        assert_eq!(templates().count(), 12);
    }
}
