//! Contact, conditions and method of an effective mass.

use crate::terminal::explanation::{self, motion_ratio, named_contact};
use crate::terminal::limits;
use crate::terminal::report::notes_are_shown;
use crate::terminal::text::{number, triple, upper_bound};
use percuss_study::{FrictionThresholdsRecord, MassReport, SheetPoint};
use std::fmt::Write;

/// Text for a robot arm without rotor inertias.
pub const NO_ROTORS: &str = "none in the model; geared drives make a robot heavier (--armature JOINT=KG·M²)";

/// Contact, conditions, motion ratios and method of the result.
pub fn facts(report: &MassReport) -> Vec<(&'static str, String)> {
    let mut facts = report.named_contact.as_ref().map_or_else(Vec::new, named_contact);
    facts.extend(conditions(report));
    facts.extend(report.motion_ratios.iter().map(|ratio| ("motion ratio", motion_ratio(ratio))));
    let thresholds = report.friction_thresholds.as_ref();
    facts.extend(thresholds.map(|found| ("friction", thresholds_text(found))));
    facts.push(method(report));
    facts
}

/// Coefficients of friction for sticking, jamming and wedging.
pub fn thresholds_text(found: &FrictionThresholdsRecord) -> String {
    explanation::friction_thresholds(found)
        .unwrap_or_else(|| "has no effect: the contact point does not slide while the gap closes".to_owned())
}

/// True if the output has the details of the solution: for any model that is no suspension, and with --notes.
fn has_solver_details(report: &MassReport) -> bool {
    report.point_in_sheet.is_none() || notes_are_shown()
}

/// Method of the result, with its condition number and its error; for a suspension only the error.
pub fn method(report: &MassReport) -> (&'static str, String) {
    if !has_solver_details(report) {
        return ("accuracy", error_suffix(report).trim_start_matches(", ").to_owned());
    }
    let condition = report.condition.map_or_else(String::new, |c| format!(", condition {c:.1e}"));
    ("computed by", format!("{} route{condition}{}", report.route, error_suffix(report)))
}

/// Contact and conditions of the result.
pub fn conditions(report: &MassReport) -> Vec<(&'static str, String)> {
    let contact = &report.contact;
    let list = |names: &[String]| {
        let position = |name: &String| match report.pose.get(name) {
            Some([value]) => format!("{name} = {}", number(*value)),
            Some(values) => {
                format!("{name} = {}", values.iter().map(|v| number(*v)).collect::<Vec<_>>().join(","))
            }
            None => name.clone(),
        };
        let mut text = names.iter().take(limits::JOINTS_SHOWN).map(position).collect::<Vec<_>>().join("  ");
        if names.len() > limits::JOINTS_SHOWN {
            let _ = write!(text, "  and {} more", names.len() - limits::JOINTS_SHOWN);
        }
        if text.is_empty() { "none".into() } else { text }
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
        let limit = |m: &Option<f64>| {
            m.map_or_else(|| "immovable".to_owned(), |m| format!("{} {}", number(m), report.unit))
        };
        facts.push((
            "along the branches",
            report.branch_limits.iter().map(limit).collect::<Vec<_>>().join(", "),
        ));
    }
    facts
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
    match (report.effective_mass_error, report.effective_mass) {
        (Some(error), Some(m)) => {
            format!(", relative error below {}", upper_bound((error / m).max(f64::EPSILON)))
        }
        _ => String::new(),
    }
}
