//! Command `percuss extremes`.

use crate::args::{CheckFormat, ExtremesArgs};
use crate::terminal::escape::line;
use crate::terminal::failure::Failure;
use crate::terminal::report::{write_diagnostics, write_json, write_out};
use crate::terminal::text::{number, short_number, triple};
use crate::terminal::wrap::{fact_line, wrap_lines};
use percuss_study::{ExtremeRecord, ExtremesReport, Status, extremes};

/// Gap, m, up to which a stop counts as closed: far below any clearance.
const RESTING_GAP: f64 = 1e-6;

/// Runs the command.
pub fn run(args: &ExtremesArgs) -> Result<(), Failure> {
    let contact = args.contact.question()?;
    let model = args.model.load()?;
    let report = extremes(&model, &contact, &args.question())?;
    write_diagnostics(&report.diagnostics, args.model.reading.strict)?;
    match args.format {
        CheckFormat::Json => write_json(&report),
        CheckFormat::Text => write_out(&text(&report)),
    }
}

/// Report as text.
fn text(report: &ExtremesReport) -> String {
    let mut out = String::new();
    for (name, record) in [("smallest", &report.least), ("largest", &report.most)] {
        out += &fact_line(name, &line(&value(report, record)));
        out += &fact_line("  at", &line(&positions(record)));
        if let Some(gap) = record.gap.filter(|gap| gap.abs() > RESTING_GAP) {
            let state = if gap > 0.0 { "open: it does not touch" } else { "pressed in" };
            out += &fact_line("  gap", &format!("{} m, the stop is {state} here", short_number(gap)));
        }
        if let Some(normal) = &record.normal_world {
            out += &fact_line("  normal", &format!("{} (world, up to its sign)", triple(normal)));
        }
        out += &fact_line(
            "  search",
            &format!(
                "{} of {} starts agree; optimality residual {}",
                record.agreeing,
                report.starts,
                short_number(record.residual)
            ),
        );
    }
    let range = |(joint, lower, upper): &(String, f64, f64)| {
        format!("{joint} {} to {}", short_number(*lower), short_number(*upper))
    };
    let ranges: Vec<String> = report.ranges.iter().map(range).collect();
    out += &fact_line("ranges", &line(&format!("{} (rad or m)", ranges.join(", "))));
    if !report.held.is_empty() {
        let list = |values: &[f64]| values.iter().map(|x| short_number(*x)).collect::<Vec<_>>().join(",");
        let held = |(joint, values): &(String, Vec<f64>)| format!("{joint} at {}", list(values));
        let held: Vec<String> = report.held.iter().map(held).collect();
        out += &fact_line("held", &line(&format!("{} (rad or m; give a range to vary it)", held.join(", "))));
    }
    out + &wrap_lines(
        "\nLocal searches from several starts: no proof of a global extreme. If few starts agree, increase their number (--starts).\n",
    )
}

/// Value as text.
fn value(report: &ExtremesReport, record: &ExtremeRecord) -> String {
    let what = match (report.quantity, &report.joint) {
        ("held_inertia", Some(joint)) => format!(" at {joint}, the other drivers at rest"),
        ("bearing_impulse", Some(joint)) => format!(" (N·s in {joint} per m/s of a plastic impact)"),
        (_, Some(joint)) => format!(" at {joint}"),
        _ => String::new(),
    };
    match (record.status, record.value) {
        (Status::Finite, Some(value)) => format!("{} {}{what}", number(value), report.unit),
        (Status::Immovable, _) if report.quantity == "bearing_impulse" => {
            "unbounded: it grows towards these positions, at which the contact is immovable".to_owned()
        }
        (status, _) => status.name().to_owned(),
    }
}

/// Positions as text.
fn positions(record: &ExtremeRecord) -> String {
    let one = |position: &percuss_study::ExtremePosition| {
        let limit = position.limit.map_or_else(String::new, |limit| format!(" ({limit} limit)"));
        format!("{} {}{limit}", position.joint, number(position.position))
    };
    record.positions.iter().map(one).collect::<Vec<_>>().join(", ")
}
