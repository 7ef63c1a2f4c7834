//! Command `percuss safe-speed`.

use crate::args::{CheckFormat, SafeSpeedArgs};
use crate::commands::mass::conditions::NO_ROTORS;
use crate::document::{self, Document};
use crate::terminal::failure::Failure;
use crate::terminal::number::{number, triple};
use crate::terminal::report::{with_findings, write_diagnostics, write_json, write_text};
use crate::terminal::text::Table;
use percuss_study::contact::BodyRegion;
use percuss_study::{SafeSpeedReport, SpeedRecord, safe_speeds};
use std::path::Path;

/// Runs the command.
pub fn run(args: &SafeSpeedArgs) -> Result<(), Failure> {
    if args.list_regions {
        return write_text(&regions());
    }
    let Some(path) = &args.model else {
        return Err(Failure::bad_input(
            "a model and --region, the region of the body that the robot hits, are required",
        ));
    };
    let (safe_speed, contact) = (&args.safe_speed, &args.contact);
    let question = if safe_speed.has_directions() {
        if contact.contact.link.is_none() || contact.contact.point.is_none() {
            return Err(Failure::bad_input("--direction: --link LINK and --point X,Y,Z are required too"));
        }
        contact.conditions()?
    } else {
        contact.question()?
    };
    let safe_speed = safe_speed.checked(Path::new(""), args.reading.max_size)?;
    let model = args.reading.load(path)?;
    show(
        &with_findings(safe_speeds(&model, &question, &safe_speed), &model)?,
        args.format,
        args.reading.strict,
    )
}

/// Report with the lowest speed.
pub fn slowest(reports: &[SafeSpeedReport]) -> &SafeSpeedReport {
    let mut slowest = &reports[0];
    for report in &reports[1..] {
        if report.reflected.speed < slowest.reflected.speed {
            slowest = report;
        }
    }
    slowest
}

/// Writes the slowest report in full and the others as a table.
pub fn show(reports: &[SafeSpeedReport], format: CheckFormat, strict: bool) -> Result<(), Failure> {
    let slowest = slowest(reports);
    write_diagnostics(&slowest.diagnostics, strict)?;
    match format {
        CheckFormat::Json if reports.len() > 1 => write_json(&reports),
        _ => document::print(slowest, format, || document(reports)),
    }
}

/// Lowest speed, the speeds of all directions, and the limits of the standard.
pub fn document(reports: &[SafeSpeedReport]) -> Document<'_> {
    let mut out = Document::default();
    out.facts(facts(slowest(reports)));
    out.table(direction_table(reports));
    out.paragraph(DISCLAIMER);
    out
}

const DISCLAIMER: &str = "An engineering aid, not a certification. v = F/√(μ k), the transient contact of ISO/TS 15066:2016, now part of \
     ISO 10218-2:2025. The data are from public secondary sources; the standards themselves were not read. The standard's M/2 + m_L \
     depends neither on the pose nor on the direction. Compare regions and limits with the purchased standard.";

/// Table of all directions; empty for a single direction.
fn direction_table(reports: &[SafeSpeedReport]) -> Table {
    let mut table = Table::new(["direction", "greatest m/s", "kg", "by the standard m/s"]);
    for report in reports.iter().filter(|_| reports.len() > 1) {
        let mass = report.reflected.robot_mass.map_or_else(|| "immovable".to_owned(), number);
        let (by_standard, speed) = (number(report.standard.speed), number(report.reflected.speed));
        table.row([triple(&report.normal_world), speed, mass, by_standard]);
    }
    table
}

/// Values and conditions of a speed limit.
fn facts(report: &SafeSpeedReport) -> Vec<(&'static str, String)> {
    let mut facts = Vec::new();
    let mut fact = |name, value: String| facts.push((name, value));
    let speed = |record: &SpeedRecord, mass: &str| {
        let robot = record.robot_mass.map_or("no bounded mass".to_owned(), |m| format!("{} kg", number(m)));
        let reduced = record.reduced_mass.filter(|_| report.region.is_some());
        let both = reduced.map_or_else(String::new, |m| format!(", two-body mass {} kg", number(m)));
        format!("{} m/s   with {robot} ({mass}){both}", number(record.speed))
    };
    let load = if report.load > 0.0 { " and the load" } else { "" };
    fact("greatest speed", speed(&report.reflected, &format!("effective mass at the contact{load}")));
    let is_too_high = report.standard.speed > report.reflected.speed;
    let compared = if is_too_high { "; too high here" } else { "" };
    let (name, mass) = match report.region {
        Some(_) => ("by the standard", "M/2 + m_L"),
        None => ("with all that moves", "M + m_L, all at the contact's speed"),
    };
    fact(name, speed(&report.standard, mass) + compared);
    if let Some(along) = &report.along {
        fact("slowest of the rows", speed(&along.slowest, &format!("row {} of {}", along.row, along.rows)));
    }
    if let Some(proved) = &report.proved {
        let ranges = match (&proved.speed, &proved.certificate.reason) {
            (Some(record), _) => {
                let is_sharp = proved.is_sharp || record.robot_mass.is_none();
                let sharp = if is_sharp { "" } else { "; not sharp: smaller ranges give a higher speed" };
                let description = match proved.segments.zip(proved.slowest_segment) {
                    Some((count, slowest)) => {
                        format!(
                            "upper bound between rows {slowest} and {}, the largest of {count} segments",
                            slowest + 1
                        )
                    }
                    None => "upper bound for all positions in the ranges".to_owned(),
                };
                let description = match record.robot_mass {
                    Some(_) => description,
                    None => format!(
                        "no {description}: the speed for an immovable robot; smaller ranges help unless the normal passes through all axes"
                    ),
                };
                format!("{}{sharp}", speed(record, &description))
            }
            (None, reason) => format!("no certificate: {}", reason.as_deref().unwrap_or_default()),
        };
        fact("proved speed", ranges);
        if let Some(part) = &proved.surface {
            let what = if part.is_curved { "axis" } else { "normal" };
            let text = format!(
                "{} parts of the shapes of \"{}\" that are read; the largest bound is that of the part at {} with the {what} {}",
                part.patches,
                part.link,
                triple(&part.point),
                triple(&part.normal)
            );
            fact("  surface", text);
        }
        let share = proved.share_above_standard.filter(|_| report.region.is_some());
        if let Some(share) = share.filter(|share| *share > 0.0) {
            let what = if proved.segments.is_some() { "segments" } else { "sampled positions" };
            let text = format!(
                "M/2 + m_L is too small in {} % of the {what}",
                number((1000.0 * share).round() / 10.0)
            );
            fact("the standard's mass", text);
        }
    }
    if let Some(reachable) = &report.reachable {
        let compared =
            if reachable.speed <= report.reflected.speed { ", not above the greatest speed" } else { "" };
        let joints = reachable.limited_by.join(", ");
        let text =
            format!("{} m/s at most within velocity limits of {joints}{compared}", number(reachable.speed));
        fact("reachable speed", text);
    }
    match (&report.region, report.region_mass, report.region_stiffness) {
        (Some(region), Some(mass), Some(stiffness)) => {
            fact("body region", format!("{region}: {} kg on {} N/m", number(mass), number(stiffness)));
        }
        _ => fact("other side", "a rigid, fixed body".to_owned()),
    }
    fact("direction", format!("{} in the world", triple(&report.normal_world)));
    if let Some(note) = &report.region_note {
        fact("", note.clone());
    }
    let force = report.force.map_or_else(String::new, |force| format!("force {} N, ", number(force)));
    fact("at that", format!("{force}energy {} J, limited by {}", number(report.energy), report.limited_by));
    fact("robot", format!("{} kg that move, load {} kg", number(report.moving_mass), number(report.load)));
    if report.lacks_rotors {
        fact("rotor inertias", NO_ROTORS.to_owned());
    }
    facts
}

/// Table of the body regions.
fn regions() -> String {
    let mut table = Table::new(["name", "region", "kg", "N/m", "note"]);
    for r in BodyRegion::all() {
        let note = r.note.unwrap_or_default().to_owned();
        table.row([r.name.to_owned(), r.title.to_owned(), number(r.mass), number(r.stiffness), note]);
    }
    format!("{table}\nInformative, from public secondary sources: compare with the purchased\nstandard.\n")
}
