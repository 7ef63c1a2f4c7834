//! Command `percuss extremes`.

use crate::args::{CheckFormat, ExtremesArgs};
use crate::commands::mass::certificate;
use crate::document::{self, Document};
use crate::files::output::record_input;
use crate::terminal::failure::Failure;
use crate::terminal::number::{number, triple};
use crate::terminal::report::{with_findings, write_diagnostics};
use crate::terminal::units::{ContactUnits, varied_name};
use percuss_study::{
    ExtremeRecord, ExtremesCertificateRecord, ExtremesReport, KeptRecord, PathPlace, RowSource, Status,
    extremes,
};
use percuss_suspension::LengthUnit;

/// Gap, m, up to which a stop counts as closed: far below any clearance.
const RESTING_GAP: f64 = 1e-6;

/// Runs the command.
pub fn run(args: &ExtremesArgs) -> Result<(), Failure> {
    let contact = args.contact.question_of_rows()?;
    let question = args.question()?;
    let model = args.model.load()?;
    if let Some(RowSource::File(file)) = question.rows() {
        record_input(&file.path);
    }
    let report = with_findings(extremes(&model, &contact, &question), &model)?;
    write(&report, args.format, args.model.reading.strict)
}

/// Writes extremes and their findings.
pub fn write(report: &ExtremesReport, format: CheckFormat, strict: bool) -> Result<(), Failure> {
    write_diagnostics(&report.diagnostics, strict)?;
    document::print(report, format, || document(report))
}

/// Extremes with their positions, and the limits of the search.
pub fn document(report: &ExtremesReport) -> Document<'_> {
    let mut out = Document::default();
    out.facts(facts(report));
    out.paragraph(note(report));
    if let Some(certificate) = &report.certificate {
        out.section("Proof");
        out.facts(proof(certificate, report.unit));
        let brackets = [&certificate.least, &certificate.most].into_iter().flatten();
        if brackets.into_iter().any(|bracket| bracket.lower.is_some() || bracket.upper.is_some()) {
            out.note(certificate::MEANING);
        }
    }
    out
}

/// Proved bounds.
fn proof(certificate: &ExtremesCertificateRecord, unit: &str) -> Vec<(&'static str, String)> {
    if let Some(reason) = &certificate.reason {
        return vec![("no certificate", reason.clone())];
    }
    let mut facts = Vec::new();
    for (name, bracket) in [("smallest", &certificate.least), ("largest", &certificate.most)] {
        let Some(bracket) = bracket else { continue };
        let bounds = certificate::bounds(bracket.lower, bracket.upper, unit);
        let state = match bracket.is_proved {
            true => format!("proved with {} boxes", bracket.boxes),
            false => format!(
                "the best bounds after {} boxes, not within {} %: more boxes (--boxes), or smaller ranges",
                bracket.boxes,
                number(100.0 * certificate.tolerance)
            ),
        };
        facts.push((name, format!("{bounds}   ({state})")));
    }
    if certificate.mass_tolerance > 0.0 {
        facts.push(("masses", format!("each link within ±{} %", number(100.0 * certificate.mass_tolerance))));
    }
    if let Some(force) = certificate.peak_force {
        let unit = if unit == "kg" { "N" } else { "N·m" };
        facts.push((
            "peak force",
            format!("at most {} {unit}, of a linear spring without damping", number(force)),
        ));
    }
    if let Some(pieces) = certificate.pieces {
        facts.push(("assembly", format!("proved on {pieces} boxes, which are one branch")));
    }
    facts.extend(certificate::assumption(&certificate.omitted));
    facts
}

/// Limits of the search.
fn note(report: &ExtremesReport) -> &'static str {
    match report.path {
        Some(_) => {
            "Local searches from the best samples of the path: an extreme between two samples can be missed."
        }
        None if report.least.is_stopped || report.most.is_stopped => {
            "Local searches from several starts: no proof of a global extreme. The limit of work ended a search: vary fewer joints \
             (--range)."
        }
        None => {
            "Local searches from several starts: no proof of a global extreme. If few starts agree, increase their number \
             (--starts)."
        }
    }
}

/// Extremes with their positions, and the ranges of the search.
fn facts(report: &ExtremesReport) -> Vec<(&'static str, String)> {
    let mut facts = Vec::new();
    for (name, record) in [("smallest", &report.least), ("largest", &report.most)] {
        facts.push((name, value(report, record)));
        facts.push(("  at", positions(record)));
        if let Some(row) = record.row {
            let row = format!("row {} of the path (from 0)", number((1e4 * row).round() / 1e4));
            facts.push((
                "  place",
                record.place.as_ref().map_or(row.clone(), |place| format!("{}, {row}", on_path(place))),
            ));
        }
        if let Some(gap) = record.gap.filter(|gap| gap.abs() > RESTING_GAP) {
            let state = if gap > 0.0 { "open: it does not touch" } else { "pressed in" };
            facts.push(("  gap", format!("{}, the stop is {state} here", LengthUnit::Millimetre.text(gap))));
        }
        if let Some(point) = &record.point_link {
            facts.push(("  point", format!("{} m (of the contact link)", triple(point))));
        }
        if let Some(normal) = &record.normal_world {
            let direction = if report.is_moment { "  axis" } else { "  normal" };
            facts.push((direction, format!("{} (world, up to its sign)", triple(normal))));
        }
        let starts = if report.path.is_some() { "local searches" } else { "starts" };
        let kept = record
            .kept_error
            .map_or_else(String::new, |error| format!("; error of kept points {} m", number(error)));
        let stopped = match record.is_stopped {
            true => format!(
                "; stopped by the limit of work in start {} of {}: the best value found",
                record.starts, report.starts
            ),
            false => String::new(),
        };
        facts.push((
            "  search",
            format!(
                "{} of {} {starts} agree; optimality residual {}{kept}{stopped}",
                record.agreeing,
                record.starts,
                number(record.residual)
            ),
        ));
    }
    if let Some(path) = &report.path {
        let unreached = match path.unreached {
            0 => String::new(),
            count => format!("; unreachable rows: {count}"),
        };
        facts.push(("path", format!("{} rows of {}{unreached}", path.rows, path.joints.join(", "))));
    }
    if let Some(angle) = report.cone {
        facts.push(("normals", format!("within {}° of the given one", number(angle.to_degrees()))));
    }
    if !report.edges.is_empty() {
        let edges: Vec<String> = report.edges.iter().map(triple).collect();
        facts.push(("points", format!("from the contact point along {} m", edges.join(" and "))));
    }
    if !report.kept.is_empty() {
        let kept: Vec<String> = report.kept.iter().map(kept_text).collect();
        facts.push(("kept", kept.join("; ")));
    }
    let range = |(joint, lower, upper): &(String, f64, f64)| {
        format!("{joint} {} to {}", number(*lower), number(*upper))
    };
    let ranges: Vec<String> = report.ranges.iter().map(range).collect();
    if !ranges.is_empty() {
        facts.push(("ranges", format!("{} (rad or m)", ranges.join(", "))));
    }
    if !report.held.is_empty() {
        let list = |values: &[f64]| values.iter().map(|x| number(*x)).collect::<Vec<_>>().join(",");
        let held = |(joint, values): &(String, Vec<f64>)| format!("{joint} at {}", list(values));
        let held: Vec<String> = report.held.iter().map(held).collect();
        facts.push(("held", format!("{} (rad or m; give a range to vary it)", held.join(", "))));
    }
    facts
}

/// Name and value of the varied number of a path, in degrees or millimetres.
fn on_path(place: &PathPlace) -> String {
    let shown = place.unit.display_unit();
    let (scale, unit) = shown.map_or((1.0, place.unit.si_unit()), |unit| (unit.per_si, unit.name));
    format!("{} {} {unit}", varied_name(&place.name), number(scale * place.value)).trim_end().to_owned()
}

/// Kept link or point as text.
fn kept_text(kept: &KeptRecord) -> String {
    match (&kept.point, &kept.normal) {
        (None, _) => format!("{}: position and orientation", kept.link),
        (Some(point), None) => format!("{}: point {} m", kept.link, triple(point)),
        (Some(point), Some(normal)) => {
            format!("{}: point {} m along {} (world)", kept.link, triple(point), triple(normal))
        }
    }
}

/// Value as text.
fn value(report: &ExtremesReport, record: &ExtremeRecord) -> String {
    let what = match (report.quantity, &report.joint) {
        ("held_inertia", Some(joint)) => format!(" at {joint}, the other drivers at rest"),
        ("bearing_impulse", Some(joint)) => {
            let speed = ContactUnits::new(report.is_moment).speed;
            format!(" (N·s in {joint} per {speed} of a plastic impact)")
        }
        ("bearing_peak_force", Some(joint)) => format!(" (peak force in {joint})"),
        (_, Some(joint)) => format!(" at {joint}"),
        _ => String::new(),
    };
    match (record.status, record.value) {
        (Status::Finite, Some(value)) => format!("{} {}{what}", number(value), report.unit),
        (Status::Immovable, _) if report.quantity.starts_with("bearing_") => {
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
