//! `percuss safe-speed`.

use crate::args::{CheckFormat, ContactArgs, SafeSpeedArgs};
use crate::escape::line;
use crate::failure::Failure;
use crate::report::{write_diagnostics, write_json, write_out};
use crate::text::{Table, number};
use percuss_study::contact::BodyRegion;
use percuss_study::{Limit, SafeSpeedQuestion, SafeSpeedReport, SpeedRecord, safe_speed};
use std::fmt::Write;

/// Runs the command.
pub fn run(args: &SafeSpeedArgs) -> Result<(), Failure> {
    if args.list_regions {
        return write_out(&regions());
    }
    let (Some(path), Some(region)) = (&args.model, &args.region) else {
        return Err(Failure::bad_input(
            "a model and --region, the region of the body that the robot hits, are required",
        ));
    };
    let contact = ContactArgs::needed(args.contact.as_ref())?;
    let limit = match (args.force, args.pressure, args.area) {
        (Some(force), None, None) => Limit::Force(force),
        (None, Some(pressure), Some(area)) => Limit::Pressure(pressure, area),
        _ => {
            return Err(Failure::bad_input(
                "either --force N or --pressure N/cm² with --area cm² is required: the limit of the region, from the \
                 edition of the standard that applies to you",
            ));
        }
    };
    let asked = SafeSpeedQuestion { region: region.clone(), limit, load: args.load };
    let report = safe_speed(&args.reading.load(path)?, &contact.question()?, &asked)?;
    write_diagnostics(&report.diagnostics, args.reading.strict)?;
    match args.format {
        CheckFormat::Json => write_json(&report),
        CheckFormat::Text => write_out(&text(&report)),
    }
}

fn text(report: &SafeSpeedReport) -> String {
    let mut out = String::new();
    let mut fact = |name: &str, value: String| {
        let _ = writeln!(out, "{name:<20} {}", line(&value));
    };
    let speed = |record: &SpeedRecord, mass: &str| {
        let robot = record.robot_mass.map_or("no bounded mass".to_owned(), |m| format!("{} kg", number(m)));
        format!(
            "{} m/s   with {robot} ({mass}), two-body mass {} kg",
            number(record.speed),
            number(record.reduced_mass)
        )
    };
    let load = if report.load > 0.0 { " and the load" } else { "" };
    fact("greatest speed", speed(&report.reflected, &format!("effective mass at the contact{load}")));
    fact("by the standard", speed(&report.standard, "M/2 + m_L"));
    fact(
        "struck",
        format!(
            "{}: {} kg on {} N/m",
            report.region,
            number(report.region_mass),
            number(report.region_stiffness)
        ),
    );
    if let Some(note) = &report.region_note {
        fact("", note.clone());
    }
    fact("greatest force", format!("{} N, energy {} J", number(report.force), number(report.energy)));
    fact("robot", format!("{} kg that move, load {} kg", number(report.moving_mass), number(report.load)));
    out + "\nAn engineering aid, not a certification. v = F/√(μ k), the transient contact of ISO/TS 15066 (now ISO 10218-2); the\n\
           standard's M/2 + m_L knows neither pose nor direction. The table of regions is informative, from public secondary\n\
           sources: check it, and the limit you gave, against the purchased standard.\n"
}

fn regions() -> String {
    let mut table = Table::new(["name", "region", "kg", "N/m", "note"]);
    for r in BodyRegion::all() {
        let note = r.note.clone().unwrap_or_default();
        table.row([r.name.clone(), r.title.clone(), number(r.mass), number(r.stiffness), note]);
    }
    format!("{table}\nInformative, from public secondary sources: check against the purchased standard.\n")
}
