//! Command `percuss check`.

use crate::args::{CheckArgs, CheckFormat};
use crate::document::{self, Document};
use crate::terminal::failure::Failure;
use crate::terminal::number::number;
use crate::terminal::report::write_diagnostics;
use crate::terminal::text::Table;
use percuss_mechanism::Severity;
use percuss_study::{CheckReport, RelationTermRecord, check};
use std::fmt::Write;

/// Runs the command.
pub fn run(args: &CheckArgs) -> Result<(), Failure> {
    let model = args.model.load()?;
    write(&check(&model)?, args.format, args.model.reading.strict)
}

/// Writes the findings and the report.
pub fn write(report: &CheckReport, format: CheckFormat, strict: bool) -> Result<(), Failure> {
    write_diagnostics(&report.diagnostics, strict)?;
    document::print(report, format, || document(report))
}

/// Properties of a model, and tables of links, joints and loops.
pub fn document(report: &CheckReport) -> Document<'_> {
    let mut out = Document::default();
    let poses = (!report.poses.is_empty())
        .then(|| ("named poses", format!("{} (--pose NAME)", report.poses.join(", "))));
    out.facts(facts(report).into_iter().chain(poses));
    tables(report).into_iter().for_each(|table| out.table(table));
    out
}

/// Properties of a model, one line each.
fn facts(report: &CheckReport) -> [(&'static str, String); 8] {
    let movable = report.pose.len();
    [
        ("mechanism", report.name.clone()),
        ("root link", report.root.clone()),
        ("links", format!("{} ({} kg in all)", report.links.len(), number(report.total_mass))),
        ("joints", format!("{} ({movable} can move)", report.joints.len())),
        ("loops", report.closures.len().to_string()),
        ("degrees of freedom", degrees_of_freedom_text(report)),
        ("redundant constraints", redundancy_text(report)),
        ("diagnostics", diagnostics_text(report)),
    ]
}

/// Tables of links, joints and loops.
fn tables(report: &CheckReport) -> [Table; 3] {
    let mut links = Table::new(["link", "mass", "centre of mass"]);
    for link in &report.links {
        let mass = if link.has_inertial { format!("{} kg", number(link.mass)) } else { "massless".into() };
        let com = link.com.map_or_else(String::new, |c| crate::terminal::number::triple(&c) + " m");
        links.row([link.name.clone(), mass, com]);
    }
    let mut joints = Table::new(["joint", "kind", "parent → child", "axis", "limits", "notes"]);
    for joint in &report.joints {
        let mut notes: Vec<String> = joint.mimics.iter().map(|m| format!("mimics {m}")).collect();
        if joint.armature.iter().any(|a| *a > 0.0) {
            let values: Vec<String> = joint.armature.iter().map(|a| number(*a)).collect();
            notes.push(format!("armature {}", values.join(", ")));
        }
        if let Some([stiffness, damping, reference]) = joint.spring {
            let [stiffness, damping, reference] = [stiffness, damping, reference].map(number);
            notes.push(format!("spring {stiffness}, damping {damping}, free at {reference}"));
        }
        if let Some([stiffness, damping]) = joint.gear {
            notes.push(format!("elastic gear {}, damping {}", number(stiffness), number(damping)));
        }
        joints.row([
            joint.name.clone(),
            joint.kind.to_owned(),
            format!("{} → {}", joint.parent, joint.child),
            joint.axis.map_or_else(String::new, |a| crate::terminal::number::triple(&a)),
            joint.limits.map_or_else(String::new, |[l, u]| format!("{} … {}", number(l), number(u))),
            notes.join("; "),
        ]);
    }
    let has_relations = report.closures.iter().any(|closure| !closure.joints.is_empty());
    let between =
        if has_relations { "predecessor → successor, or joints" } else { "predecessor → successor" };
    let mut loops = Table::new(["loop", "kind", between, "rows"]);
    for closure in &report.closures {
        let kind =
            closure.ratio.map_or(closure.kind.to_owned(), |r| format!("{} {}", closure.kind, number(r)));
        let between = match (&closure.predecessor, &closure.successor) {
            (Some(predecessor), Some(successor)) => format!("{predecessor} → {successor}"),
            _ => relation_text(&closure.joints),
        };
        loops.row([closure.name.clone(), kind, between, closure.rows.to_string()]);
    }
    [links, joints, loops]
}

/// Sum of the joints of a relation, each with its coefficient.
fn relation_text(joints: &[RelationTermRecord]) -> String {
    let mut text = String::new();
    for RelationTermRecord { joint, coefficient } in joints {
        let sign = match (text.is_empty(), *coefficient < 0.0) {
            (true, false) => "",
            (true, true) => "−",
            (false, false) => " + ",
            (false, true) => " − ",
        };
        let factor =
            if coefficient.abs() == 1.0 { String::new() } else { format!("{}·", number(coefficient.abs())) };
        let _ = write!(text, "{sign}{factor}{joint}");
    }
    text
}

/// Number of redundant rows, with the loops that contain them.
fn redundancy_text(report: &CheckReport) -> String {
    let loops: Vec<String> = report.redundant_loops.iter().map(|names| names.join("+")).collect();
    let suffix = if loops.is_empty() { String::new() } else { format!(" (in {})", loops.join("; ")) };
    format!("{}{suffix}", report.redundant_constraints)
}

/// Degrees of freedom with a fixed root, with a remark for a singular pose and the driving joints.
fn degrees_of_freedom_text(report: &CheckReport) -> String {
    let generic = report.generic_degrees_of_freedom;
    let at_pose = report.degrees_of_freedom;
    let suffix =
        if at_pose == generic { String::new() } else { format!(" ({at_pose} at this singular pose)") };
    let drivers = if report.drivers.is_empty() {
        String::new()
    } else {
        format!("; loops driven by {}", report.drivers.join(", "))
    };
    format!("{generic} with the root fixed{suffix}{drivers}")
}

/// "2 warning(s), 1 note(s)", or "none".
fn diagnostics_text(report: &CheckReport) -> String {
    let count = |severity| report.diagnostics.iter().filter(|d| d.severity == severity).count();
    match (count(Severity::Warning), count(Severity::Note)) {
        (0, 0) => "none".into(),
        (warnings, notes) => format!("{warnings} warning(s), {notes} note(s)"),
    }
}
