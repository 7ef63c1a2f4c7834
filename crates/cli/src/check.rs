//! `percuss check`.

use crate::args::{CheckArgs, CheckFormat};
use crate::failure::Failure;
use crate::report::{tell, write_json, write_out};
use crate::text::{Table, number};
use percuss_study::{CheckReport, Model, check};
use std::fmt::Write;

/// Runs the command.
pub fn run(args: &CheckArgs) -> Result<(), Failure> {
    let model = Model::load(&args.model.model, args.model.max_size, &args.model.options())?;
    let report = check(&model).map_err(|error| Failure::bad_input(error.to_string()))?;
    tell(&report.diagnostics, args.model.strict)?;
    match args.format {
        CheckFormat::Json => write_json(&report),
        CheckFormat::Text => write_out(&text(&report)),
    }
}

fn text(report: &CheckReport) -> String {
    let movable = report.pose.len();
    let mut out = String::new();
    let facts = [
        ("mechanism", report.name.clone()),
        ("root link", report.root.clone()),
        ("links", format!("{} ({} kg in all)", report.links.len(), number(report.total_mass))),
        ("joints", format!("{} ({movable} can move)", report.joints.len())),
        ("loops", report.closures.len().to_string()),
        ("degrees of freedom", format!("{} with the root fixed", report.degrees_of_freedom)),
        ("redundant constraints", report.redundant_constraints.to_string()),
        ("diagnostics", summary(report)),
    ];
    for (name, value) in facts {
        let _ = writeln!(out, "{name:<22} {value}");
    }
    let mut links = Table::new(["link", "mass", "centre of mass"]);
    for link in &report.links {
        let mass = if link.has_inertial { format!("{} kg", number(link.mass)) } else { "massless".into() };
        let com = link.com.map_or_else(String::new, |c| crate::text::triple(&c) + " m");
        links.row([link.name.clone(), mass, com]);
    }
    let mut joints = Table::new(["joint", "kind", "parent → child", "axis", "limits", "notes"]);
    for joint in &report.joints {
        let mut notes: Vec<String> = joint.mimics.iter().map(|m| format!("mimics {m}")).collect();
        if joint.armature.iter().any(|a| *a > 0.0) {
            let values: Vec<String> = joint.armature.iter().map(|a| number(*a)).collect();
            notes.push(format!("armature {}", values.join(", ")));
        }
        joints.row([
            joint.name.clone(),
            joint.kind.to_owned(),
            format!("{} → {}", joint.parent, joint.child),
            joint.axis.map_or_else(String::new, |a| crate::text::triple(&a)),
            joint.limits.map_or_else(String::new, |[l, u]| format!("{} … {}", number(l), number(u))),
            notes.join("; "),
        ]);
    }
    let _ = write!(out, "\n{links}\n{joints}");
    out
}

fn summary(report: &CheckReport) -> String {
    let count = |severity| report.diagnostics.iter().filter(|d| d.severity == severity).count();
    match (count("warning"), count("note")) {
        (0, 0) => "none".into(),
        (warnings, notes) => format!("{warnings} warning(s), {notes} note(s)"),
    }
}
