//! Contact and conditions of a suspension, by the names of the parts in its sheet.

use crate::commands::mass::conditions::{held_points, loop_facts, method, other_side, point_in_sheet_text};
use crate::terminal::text::number;
use percuss_study::{JointDisplacement, MassReport, SheetPoint};

/// Suffixes of joint names, and the kind of joint for each. Ball joints have the names of their hardpoints.
const JOINTS: [(&str, &str); 5] = [
    ("_hinge", "hinge"),
    ("_slide", "slide"),
    ("_free", "position"),
    ("_first_pin", "universal joint"),
    ("_second_pin", "universal joint"),
];

/// Facts about the contact and the conditions of a suspension with a sheet.
pub fn facts(report: &MassReport, contact: &SheetPoint) -> Vec<(&'static str, String)> {
    let assumed = &report.assumptions;
    let mut facts = vec![
        ("contact", point_in_sheet_text(contact)),
        ("contact link", format!("{}, against {}", report.contact.link, other_side(report))),
        ("base", assumed.base.clone()),
    ];
    let lists =
        [("displacements", &assumed.free), ("mimic joints", &assumed.mimics), ("locked", &assumed.locked)];
    for (label, names) in lists {
        let text = displacements(report, names);
        if !text.is_empty() {
            facts.push((label, text));
        }
    }
    facts.extend(held_points(report));
    facts.extend(loop_facts(report));
    facts.push(method(report));
    facts
}

/// Part and joint of the name of a joint, with the side of the vehicle at the end of the part.
fn part_and_joint(name: &str) -> Option<(String, &'static str)> {
    ["", "_left", "_right"].into_iter().find_map(|side| {
        let stem = name.strip_suffix(side)?;
        let (part, joint) =
            JOINTS.iter().find_map(|(ending, joint)| Some((stem.strip_suffix(ending)?, *joint)))?;
        Some((format!("{part}{side}"), joint))
    })
}

/// Words for a joint: its part in the sheet, and its kind.
fn words(name: &str) -> String {
    part_and_joint(name).map_or_else(|| name.to_owned(), |(part, joint)| format!("{part} ({joint})"))
}

/// Displacements of joints from the drawing; both axes of a universal joint are one entry.
fn displacements(report: &MassReport, names: &[String]) -> String {
    let mut entries: Vec<(String, String)> = Vec::new();
    for name in names {
        let (label, text) = (words(name), report.pose.displacement(name).map_or_else(String::new, text));
        match entries.last_mut() {
            Some((last, known)) if *last == label => *known += &format!(" and {text}"),
            _ => entries.push((label, text)),
        }
    }
    let entries: Vec<String> = entries.into_iter().map(|(label, text)| format!("{label} {text}")).collect();
    entries.join(", ")
}

/// Displacement in degrees with two decimals, and in millimetres with two decimals.
fn text(displacement: JointDisplacement) -> String {
    let rounded = |x: f64| number((1e2 * x).round() / 1e2 + 0.0);
    let degrees = |angle: f64| format!("{}°", rounded(angle.to_degrees()));
    match displacement {
        JointDisplacement::Turn(angle) => degrees(angle),
        JointDisplacement::Shift(shift) => format!("{} mm", rounded(1e3 * shift)),
        JointDisplacement::TurnAndShift { angle, shift } => {
            let [x, y, z] = shift.map(|x| rounded(1e3 * x));
            format!("({x}, {y}, {z}) mm and {}", degrees(angle))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{text, words};
    use percuss_study::JointDisplacement;

    #[test]
    fn joints_are_named_by_their_parts() {
        for (joint, expected) in [
            ("lower_arm_hinge", "lower_arm (hinge)"),
            ("tie_rod_second_pin_left", "tie_rod_left (universal joint)"),
            ("axle_free", "axle (position)"),
            ("spin", "spin"),
        ] {
            assert_eq!(words(joint), expected);
        }
        assert_eq!(text(JointDisplacement::Turn(0.1)), "5.73°");
        let both = JointDisplacement::TurnAndShift { angle: 0.0, shift: [0.0, -0.001, 0.0305] };
        assert_eq!(text(both), "(0, -1, 30.5) mm and 0°");
    }
}
