//! Contact, conditions and method of an effective mass.

use crate::terminal::explanation::{self, body_of, motion_ratio, named_contact, travel_and_gap};
use crate::terminal::limits;
use crate::terminal::number::{fixed, number, trim_zeros, triple, upper_bound, with_unit};
use crate::terminal::report::{details_are_shown, notes_are_shown};
use crate::terminal::units::ContactUnits;
use percuss_study::{
    ConditionsRecord, FrictionThresholdsRecord, JointDisplacement, MassReport, MotionRatioRecord, SheetPoint,
    UPWARDS,
};

/// Link at the centre of the wheel of a suspension.
const WHEEL_CENTRE: &str = "wheel_centre";

/// Suffixes of joint names, and the kind of joint for each. Ball joints have the names of their hardpoints.
const JOINTS: [(&str, &str); 5] = [
    ("_hinge", "hinge"),
    ("_slide", "slide"),
    ("_free", "position"),
    ("_first_pin", "universal joint"),
    ("_second_pin", "universal joint"),
];

/// Text for a robot arm without rotor inertias.
pub const NO_ROTORS: &str = "none in the model; geared drives make a robot heavier (--armature JOINT=KG·M²)";

/// Contact, conditions, motion ratios and method of the result.
pub fn facts(report: &MassReport) -> Vec<(&'static str, String)> {
    let mut facts = report.named_contact.as_ref().map_or_else(Vec::new, named_contact);
    facts.extend(conditions(report));
    facts.extend(report.motion_ratios.iter().map(|ratio| ("motion ratio", motion_ratio(ratio))));
    facts.push(method(report));
    facts
}

/// Place of the contact, then its travel, gap, pose and motion ratio: further lines of the meaning of the main result.
pub fn place(report: &MassReport) -> String {
    let ContactUnits { name, .. } = ContactUnits::new(report.contact.is_moment);
    let mut lines = Vec::new();
    match (&report.named_contact, &report.joint_stop) {
        (Some(contact), _) => {
            let touch = if contact.brought_to_touch { ", at the touch" } else { "" };
            lines.push(format!(
                "{name} at {} ({}), on {}{touch}",
                contact.name,
                contact.kind,
                body_of(contact)
            ));
            lines.extend(travel_and_gap(contact));
        }
        (None, Some(stop)) => lines.push(format!("{name} at the stop of {}", stop.joint)),
        (None, None) if report.contact.is_moment => {
            let axis = triple(&report.contact.normal_link);
            lines.push(format!(
                "{name} of {} about {axis}, against {}",
                report.contact.link,
                other_side(report)
            ));
        }
        (None, None) => {
            let (point, normal) = (triple(&report.contact.point_link), triple(&report.contact.normal_link));
            lines.push(format!("{name} at {}, against {}", report.contact.link, other_side(report)));
            lines.push(format!("point {point} m, normal {normal} in the axes of {}", report.contact.link));
        }
    }
    if !report.assumptions.set.is_empty() {
        lines.push(format!("pose: {}", displacements(report, &report.assumptions.set)));
    }
    // The ratios of the wheel centre and of the contact patch are equal in many suspensions.
    let mut ratios: Vec<&MotionRatioRecord> = Vec::new();
    for ratio in &report.motion_ratios {
        let is_same = |other: &&MotionRatioRecord| {
            let near = |(a, b): (f64, f64)| (a - b).abs() <= limits::EQUAL_CURVES * b.abs();
            other.direction == ratio.direction
                && other.held == ratio.held
                && other.contact_per_wheel.zip(ratio.contact_per_wheel).is_some_and(near)
        };
        if !ratios.iter().any(is_same) {
            ratios.push(ratio);
        }
    }
    lines.extend(ratios.into_iter().map(|ratio| ratio_line(report, ratio)));
    if !report.branch_limits.is_empty() {
        lines.push(format!("at this singular pose, along the branches: {}", branch_limits(report)));
    }
    lines.join("\n")
}

/// Motion ratio, and for the wheel its part in m̄.
fn ratio_line(report: &MassReport, ratio: &MotionRatioRecord) -> String {
    let of_wheel = ratio.one_travel && ratio.held.is_none() && ratio.direction == UPWARDS;
    let at_wheel = report.effective_mass.zip(ratio.contact_per_wheel);
    match at_wheel.filter(|_| of_wheel && ratio.link == WHEEL_CENTRE && !report.contact.is_moment) {
        Some((m, r)) => {
            let mass = with_unit(m * r * r, report.unit);
            format!("motion ratio {} (contact per wheel travel): {mass} / {}²", number(r), number(r.abs()))
        }
        None => format!("motion ratio {}", motion_ratio(ratio)),
    }
}

/// Base, with the pose of the root link if the question moves it.
pub fn base_text(conditions: &ConditionsRecord) -> String {
    match conditions.base_pose {
        Some(pose) => {
            let [position, quaternion] = [&pose[..3], &pose[3..]]
                .map(|part| part.iter().map(|x| number(*x)).collect::<Vec<_>>().join(", "));
            format!("{}, root link at {position} m, quaternion {quaternion}", conditions.base)
        }
        None => conditions.base.to_owned(),
    }
}

/// Conditions of the result in one line.
pub fn summary(report: &MassReport) -> String {
    let (conditions, assumed) = (&report.conditions, &report.assumptions);
    let freedoms = degrees_of_freedom_text(report);
    let plural = if freedoms == "1" { "degree" } else { "degrees" };
    let mut parts =
        vec![format!("base {}", base_text(conditions)), format!("{freedoms} {plural} of freedom")];
    if !assumed.locked.is_empty() {
        parts.push(format!("locked: {}", assumed.locked.join(", ")));
    }
    parts.extend(conditions.hold.iter().map(|hold| format!("held: {}", hold.link)));
    parts.push("rigid links, no friction".to_owned());
    parts.extend(assumed.lacks_rotors.then(|| format!("rotor inertias: {NO_ROTORS}")));
    parts.extend(error_text(report).map(|error| format!("error < {error}")));
    parts.join(" · ")
}

/// Coefficients of friction for sticking, jamming and wedging.
pub fn thresholds_text(found: &FrictionThresholdsRecord) -> String {
    explanation::friction_thresholds(found)
        .unwrap_or_else(|| "has no effect: the contact point does not slide while the gap closes".to_owned())
}

/// m̄ with the other kind of base, for a suspension whose chassis has a mass.
pub fn other_base(report: &MassReport) -> Option<(String, String)> {
    let other = report.other_base.as_ref()?;
    let state = if other.base == "floating" { "free" } else { "held" };
    let value = match (other.effective_mass, other.status) {
        (Some(m), _) => with_unit(m, report.unit),
        (None, status) => status.name().to_owned(),
    };
    Some((format!("{} {state}", other.link), format!("{value}, base {}", other.base)))
}

/// True if the output has the details of the solution: for any model that is no suspension, with --details and with --notes.
fn has_solver_details(report: &MassReport) -> bool {
    report.point_in_sheet.is_none() || notes_are_shown() || details_are_shown()
}

/// Method of the result, with its condition number and its error; for a suspension only the error.
pub fn method(report: &MassReport) -> (&'static str, String) {
    if !has_solver_details(report) {
        return ("accuracy", error_suffix(report).trim_start_matches(", ").to_owned());
    }
    let condition = report.condition.map_or_else(String::new, |c| format!(", condition {c:.1e}"));
    ("computed by", format!("{} route{condition}{}", report.route, error_suffix(report)))
}

/// Contact and conditions of a suspension with a sheet, by the names of its parts.
pub fn facts_in_sheet(report: &MassReport, contact: &SheetPoint) -> Vec<(&'static str, String)> {
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

/// Contact and conditions of the result.
pub fn conditions(report: &MassReport) -> Vec<(&'static str, String)> {
    let contact = &report.contact;
    let list = |names: &[String]| {
        let text = displacements(report, names);
        if text.is_empty() { "none".to_owned() } else { text }
    };
    let assumed = &report.assumptions;
    let of_point = vec![
        ("contact link", format!("{} at {} m, in the link frame", contact.link, triple(&contact.point_link))),
        ("normal", format!("{} in the link frame, out of {}", triple(&contact.normal_link), contact.link)),
        (
            "in the world",
            format!(
                "point {} m, normal {}{}",
                triple(&contact.point_world),
                triple(&contact.normal_world),
                if report.point_in_sheet.is_some() { VEHICLE_AXES } else { "" }
            ),
        ),
    ];
    let of_axis = || {
        vec![
            ("contact link", contact.link.clone()),
            ("moment about", format!("{} in the link frame", triple(&contact.normal_link))),
            ("in the world", format!("axis {}", triple(&contact.normal_world))),
        ]
    };
    let mut facts = match &report.joint_stop {
        Some(stop) => vec![("stop of joint", stop.joint.clone())],
        None if contact.is_moment => of_axis(),
        None => of_point,
    };
    let in_sheet = report.point_in_sheet.filter(|_| !contact.is_moment);
    facts.extend(in_sheet.map(|at| ("in the sheet", point_in_sheet_text(&at))));
    facts.extend([
        ("against", other_side(report)),
        ("base", assumed.base.clone()),
        ("free joints", list(&assumed.free)),
    ]);
    if assumed.lacks_rotors {
        facts.push(("rotor inertias", NO_ROTORS.to_owned()));
    }
    if !assumed.mimics.is_empty() {
        facts.push(("following joints", list(&assumed.mimics)));
    }
    if !assumed.locked.is_empty() {
        facts.push(("locked joints", list(&assumed.locked)));
    }
    facts.extend(held_points(report));
    if !assumed.drivers.is_empty() && has_solver_details(report) {
        facts.push(("loops driven by", list(&assumed.drivers)));
    }
    facts.extend(loop_facts(report));
    facts
}

/// World axes of a model from a sheet.
const VEHICLE_AXES: &str = ", axes of the vehicle (x forward, y left, z up)";

/// The other side of the contact.
pub fn other_side(report: &MassReport) -> String {
    match (report.conditions.against_mass, report.contact.against.as_deref()) {
        (Some(mass), _) => format!("a free body of {} kg", number(mass)),
        (None, Some(link)) => link.to_owned(),
        (None, None) => "the ground".to_owned(),
    }
}

/// Contact point and normal in the unit and the axes of the sheet.
pub fn point_in_sheet_text(at: &SheetPoint) -> String {
    let rounded = |values: [f64; 3]| triple(&values.map(|x| (x * 1e6).round() / 1e6 + 0.0));
    let normal = at.normal.map_or_else(String::new, |normal| format!(", normal {}", rounded(normal)));
    let text = format!("point {} {}{normal}", rounded(at.point), at.unit.name());
    format!("{text}, axes {} ({})", at.axes.name(), at.axes.words())
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
pub fn words(name: &str) -> String {
    part_and_joint(name).map_or_else(|| name.to_owned(), |(part, joint)| format!("{part} ({joint})"))
}

/// Displacements of joints from the design position; both axes of a universal joint are one entry.
pub fn displacements(report: &MassReport, names: &[String]) -> String {
    let mut entries: Vec<(String, String)> = Vec::new();
    for name in names {
        let (label, text) =
            (words(name), report.pose.displacement(name).map_or_else(String::new, displacement_text));
        match entries.last_mut() {
            Some((last, known)) if *last == label => *known += &format!(" and {text}"),
            _ => entries.push((label, text)),
        }
    }
    let entries: Vec<String> = entries.into_iter().map(|(label, text)| format!("{label} {text}")).collect();
    entries.join(", ")
}

/// Displacement in degrees with two decimals, and in millimetres with two decimals.
fn displacement_text(displacement: JointDisplacement) -> String {
    let rounded = |x: f64| trim_zeros(&fixed(x, 2)).to_owned();
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

/// Points that are held.
pub fn held_points(report: &MassReport) -> impl Iterator<Item = (&'static str, String)> {
    report.conditions.hold.iter().map(|hold| {
        let along =
            hold.normal.map_or_else(|| "in all directions".to_owned(), |n| format!("along {}", triple(&n)));
        ("held", format!("{} at {} m, {along}", hold.link, triple(&hold.point)))
    })
}

/// Assembly mode, degrees of freedom, residual and branches of the loops.
pub fn loop_facts(report: &MassReport) -> Vec<(&'static str, String)> {
    let mut facts = Vec::new();
    let has_details = has_solver_details(report);
    if !report.assumptions.drivers.is_empty() && has_details {
        let modes: Vec<&str> =
            report.assembly_modes.iter().map(|m| ["−", "singular", "+"][(m + 1) as usize]).collect();
        facts.push(("assembly mode", modes.join(" ")));
    }
    facts.push(("degrees of freedom", degrees_of_freedom_text(report)));
    if report.redundant_constraints > 0 {
        let loops: Vec<String> = report.redundant_loops.iter().map(|names| names.join("+")).collect();
        let suffix = if loops.is_empty() { String::new() } else { format!(" (in {})", loops.join("; ")) };
        facts.push(("redundant rows", format!("{}{suffix}", report.redundant_constraints)));
    }
    if let Some(residual) = report.closure_residual.filter(|_| has_details) {
        let gap = report.rank_gap.map_or_else(String::new, |g| format!(", rank gap {g:.1e}"));
        facts.push(("loops closed to", format!("{residual:.1e} m{gap}")));
    }
    if !report.branch_limits.is_empty() {
        facts.push(("along the branches", branch_limits(report)));
    }
    facts
}

/// Limits of m̄ along the branches of a singular pose.
fn branch_limits(report: &MassReport) -> String {
    let limit = |m: &Option<f64>| m.map_or_else(|| "immovable".to_owned(), |m| with_unit(m, report.unit));
    report.branch_limits.iter().map(limit).collect::<Vec<_>>().join(", ")
}

/// Degrees of freedom and redundant constraints as text.
fn degrees_of_freedom_text(report: &MassReport) -> String {
    if report.degrees_of_freedom == report.generic_degrees_of_freedom {
        report.degrees_of_freedom.to_string()
    } else {
        format!("{} here, {} at a generic pose", report.degrees_of_freedom, report.generic_degrees_of_freedom)
    }
}

/// Upper bound of the relative error, to be appended to the mass; empty if unknown.
fn error_suffix(report: &MassReport) -> String {
    error_text(report).map_or_else(String::new, |error| format!(", relative error below {error}"))
}

/// Upper bound of the relative error; `None` if unknown.
fn error_text(report: &MassReport) -> Option<String> {
    let (error, m) = report.effective_mass_error.zip(report.effective_mass)?;
    Some(upper_bound((error / m).max(f64::EPSILON)))
}

#[cfg(test)]
mod tests {
    use super::{displacement_text, words};
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
        assert_eq!(displacement_text(JointDisplacement::Turn(0.1)), "5.73°");
        let both = JointDisplacement::TurnAndShift { angle: 0.0, shift: [0.0, -0.001, 0.0305] };
        assert_eq!(displacement_text(both), "(0, −1, 30.5) mm and 0°");
    }
}
