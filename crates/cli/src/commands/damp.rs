//! `percuss damp`, and the damper in the output of an effective mass.

use crate::args::{CheckFormat, DampArgs};
use crate::document::{self, Document};
use crate::files::contents::{self, Contents, TABLES_AND_PICTURES};
use crate::files::csv::Cell;
use crate::files::output::record_input;
use crate::terminal::explanation::named_contact;
use crate::terminal::failure::Failure;
use crate::terminal::limits;
use crate::terminal::report::{with_findings, write_diagnostics, write_out};
use crate::terminal::text::{Table, number, short_number, upper_bound};
use crate::terminal::units::ContactUnits;
use crate::terminal::wrap::wrap_hanging;
use percuss_render::{Figure, Mark, Panel, Picture, Series, Sheet, Style};
use percuss_study::contact::exports::{Measurement, StopMotion, Tool};
use percuss_study::contact::{Law, Sample};
use percuss_study::{
    DampingReport, ExportRecord, ForceCurveRecord, Tools, damp, damp_contact, damp_stop, impact_history,
};
use std::fmt::Write;

/// Runs the command.
pub fn run(args: &DampArgs) -> Result<(), Failure> {
    if args.list_laws {
        return write_out(&laws());
    }
    if args.list_tools {
        return write_out(&tools());
    }
    args.writing.apply();
    let Some(question) = args.damping.checked()? else {
        return Err(Failure::bad_input(
            "--restitution E (the required restitution) is required, with --stiffness N/m (the contact spring) or a force curve",
        ));
    };
    args.output.as_deref().map_or(Ok(()), |path| contents::check(path, &TABLES_AND_PICTURES))?;
    let mut question = question.clone();
    if args.format == CheckFormat::Json && question.tools.is_empty() {
        question.tools = vec![Tools(Tool::ALL.to_vec())];
    }
    if args.mass.is_some() {
        question.check_units(false)?;
    }
    let contact = &args.contact;
    let report = match (args.mass, &args.mass_from) {
        (Some(mass), None) if !contact.is_given() => damp(&question, mass.0)?,
        (None, Some(path)) => match &args.limit {
            Some(stop) => {
                let model = args.reading.load(path)?;
                question.check_units(stop.motion(&model)? == StopMotion::Turn)?;
                with_findings(damp_stop(&model, stop, contact.conditions()?, &question), &model)?
            }
            None => {
                let (of_contact, model) = (contact.question()?, args.reading.load(path)?);
                question.check_units(of_contact.is_moment(&model.mechanism))?;
                with_findings(damp_contact(&model, &of_contact, &question), &model)?
            }
        },
        (Some(_), _) => {
            return Err(Failure::bad_input(
                "--link, --point and similar flags require --mass-from MODEL; they do not apply to --mass",
            ));
        }
        _ => {
            return Err(Failure::bad_input(
                "either --mass KG or --mass-from MODEL with a contact is required",
            ));
        }
    };
    write_diagnostics(&report.diagnostics, args.reading.strict)?;
    args.mass_from.iter().for_each(|path| record_input(path));
    if let Some(path) = &args.output {
        write_history(&report, path)?;
    }
    print(&report, args.format)
}

/// Writes a report.
pub fn print(report: &DampingReport, format: CheckFormat) -> Result<(), Failure> {
    document::print(report, format, || {
        let mut out = Document::default();
        let contact = report.named_contact.as_ref().map_or_else(Vec::new, named_contact);
        out.facts([headline(report)].into_iter().chain(contact).chain(facts(report)));
        add_exports(report, &mut out);
        out
    })
}

/// Adds the parameters of all requested simulators.
pub fn add_exports<'a>(report: &'a DampingReport, out: &mut Document<'a>) {
    for (name, export) in &report.exports {
        out.heading(format!("{} ({name})", export.title));
        if let Some(error) = &export.error {
            out.problem(format!("  cannot: {error}"));
            continue;
        }
        out.facts(export_facts(export).into_iter().map(|(name, value)| (format!("  {name}"), value)));
        for snippet in &export.snippets {
            out.code(snippet.title, &*snippet.text);
        }
        if !export.sources.is_empty() {
            out.note(format!("  sources: {}", export.sources.join("; ")));
        }
    }
}

/// Section of a damper on a page, with the history of the impact.
pub fn document(report: &DampingReport) -> Result<Document<'_>, Failure> {
    let mut out = Document::default();
    out.facts(report.stop.is_some().then(|| headline(report)).into_iter().chain(facts(report)));
    if report.damper.speed.is_some() {
        let samples = samples(report)?;
        let caption = "Force over time, and over the penetration; the loop encloses the energy that is lost.";
        let figure = move || history_sheet(report, &samples).to_svg();
        out.picture(figure, "Force over time and over penetration", caption);
    } else {
        out.note("Without damping.speed there is no force to draw.");
    }
    add_exports(report, &mut out);
    Ok(out)
}

/// Force history of the impact.
fn samples(report: &DampingReport) -> Result<Vec<Sample>, Failure> {
    let samples = impact_history(&report.question, report.effective_mass, limits::HISTORY_SAMPLES);
    Ok(samples.map_err(percuss_study::StudyError::from)?)
}

/// Name and value of the effective mass, or of the effective inertia for a rotational stop.
fn headline(report: &DampingReport) -> (&'static str, String) {
    let units = units(report);
    (units.name, format!("{} {}", number(report.effective_mass), units.mass))
}

/// Factor from the SI unit of penetrations (m, rad) to the displayed unit (mm, mrad).
const SMALL: f64 = 1e3;

/// Units of the contact of a report.
fn units(report: &DampingReport) -> ContactUnits {
    ContactUnits::new(report.is_moment)
}

/// Damper, impact and validity as names with values.
pub fn facts(report: &DampingReport) -> Vec<(&'static str, String)> {
    let damper = &report.damper;
    let ContactUnits { length, small_length: shown, force, mass: mass_unit, .. } = units(report);
    let factor = SMALL;
    let e = damper.restitution;
    let mut facts = Vec::new();
    let law = match damper.separation {
        Some("gap") => format!("{}, ending when the gap closes (the damper pulls at the end)", damper.law),
        Some(_) => format!("{}, ending when the force vanishes", damper.law),
        None => damper.law.to_owned(),
    };
    let law = damper.law_alias.map_or(law.clone(), |alias| format!("{law} (given as {alias})"));
    facts.push(("law", law));
    facts.push(("stiffness", stiffness(report)));
    match (damper.damping_ratio, damper.damping) {
        (ratio, Some(c)) => {
            let power = unit_power(damper.exponent.map_or(1.0, |p| 0.5 * (p + 1.0)));
            let ratio = ratio.map_or_else(String::new, |ratio| format!("   (ratio {})", number(ratio)));
            let value = format!("{} {force}·s/{length}{power}{ratio}", number(c));
            facts.push(("damping", value));
            if let Some(d) = damper.dissipation {
                facts.push((
                    "or Hunt–Crossley",
                    format!("{} s/{length} at this speed, in place of the damping", number(d)),
                ));
            }
        }
        _ => facts
            .push(("dissipation", format!("{} s/{length}", number(damper.dissipation.unwrap_or_default())))),
    }
    let achieved = damper.achieved_restitution;
    let off = if damper.law_is_exact {
        "exactly".to_owned()
    } else {
        format!("error {:+.4}: this law is an approximation", achieved - e)
    };
    let weight = if report.exports.values().any(|export| export.weight_prevents_rebound) {
        "; without gravity: a weight that no spring carries leaves almost no rebound. Use a faster impact or a stiffer contact"
    } else {
        ""
    };
    facts.push(("restitution", format!("{} (required {}, {off}){weight}", number(achieved), number(e))));
    let metric = |value: Option<f64>, scale: f64, unit: &str| {
        value.map(|v| scale * v).filter(|v| v.is_finite()).map(|v| format!("{} {unit}", number(v)))
    };
    let mut add = |name, text: Option<String>| {
        if let Some(text) = text {
            facts.push((name, text));
        }
    };
    add("approach speed", metric(damper.speed, 1.0, &format!("{length}/s")));
    add("rebound speed", metric(damper.rebound_speed, 1.0, &format!("{length}/s")));
    add("contact lasts", metric(damper.contact_duration, 1e3, "ms"));
    add("penetration", metric(damper.max_penetration, factor, shown));
    let when = damper.time_of_peak_force.unwrap_or_default();
    add(
        "peak force",
        damper.peak_force.map(|f| format!("{} {force}, at {} ms", number(f), number(1e3 * when))),
    );
    add("energy lost", metric(damper.energy_lost, 1.0, "J"));
    if let Some(drift) = report.drift {
        // A value that rounds to zero is shown without a sign.
        let percent = |p: f64| format!("{:+.3} %", if p.abs() < limits::DRIFT_ROUNDING { 0.0 } else { p });
        let slope = drift.per_metre.map(|s| percent(0.1 * s) + &format!(" per {shown} of penetration"));
        let over = drift.over_penetration.map(|o| percent(100.0 * o) + " over the penetration");
        let ends = drift
            .ends_at
            .map(|depth| format!("unknown: the motion ends after {} {shown}", number(factor * depth)));
        let text: Vec<String> = [over, ends, slope].into_iter().flatten().collect();
        facts.push(("m̄ over the stroke", if text.is_empty() { "unknown".into() } else { text.join(", ") }));
    }
    if let Some(stroke) = report.over_stroke {
        facts.push((
            "with varying m̄",
            format!(
                "restitution {}, penetration {} {shown}, {} {mass_unit} at the largest penetration",
                short_number(stroke.restitution),
                short_number(factor * stroke.max_penetration),
                short_number(stroke.mass_at_max_penetration)
            ),
        ));
    }
    if let Some(alone) = report.body_alone {
        let wrong = alone.restitution.map_or_else(String::new, |e| {
            format!("; a damper for this mass gives the restitution {}", number(e))
        });
        facts.push(("contact link alone", format!("{} kg{wrong}", number(alone.mass))));
    }
    facts
}

/// Stiffness with its unit.
fn stiffness(report: &DampingReport) -> String {
    let damper = &report.damper;
    stiffness_text(damper.stiffness, damper.exponent, damper.stiffness_curve.as_ref(), &units(report))
}

/// Stiffness with its unit, or the ends of a force curve.
pub fn stiffness_text(
    stiffness: Option<f64>,
    exponent: Option<f64>,
    curve: Option<&ForceCurveRecord>,
    units: &ContactUnits,
) -> String {
    let ContactUnits { length, small_length, force, .. } = units;
    let Some(ForceCurveRecord { stop, deflections, forces }) = curve else {
        let power = unit_power(exponent.unwrap_or(1.0));
        return format!("{} {force}/{length}{power}", number(stiffness.unwrap_or_default()));
    };
    let of = stop.as_ref().map_or_else(|| "as given".to_owned(), |stop| format!("of {stop} in the sheet"));
    let [depth, last] = [deflections, forces].map(|values| values.last().copied().unwrap_or_default());
    format!(
        "force curve {of}, {} points to {} {force} at {} {small_length}",
        forces.len(),
        number(last),
        number(SMALL * depth)
    )
}

/// Exponent of a unit, if any.
fn unit_power(exponent: f64) -> String {
    if exponent == 1.0 { String::new() } else { format!("^{}", number(exponent)) }
}

/// Parameters, errors and assumptions of one simulator.
fn export_facts(export: &ExportRecord) -> Vec<(String, String)> {
    let mut facts = Vec::new();
    let mut line = |name: &str, text: &str| facts.push((name.to_owned(), text.to_owned()));
    line("integrates", export.law);
    for (name, value) in &export.parameters {
        let unit = export.units.get(name).copied().unwrap_or_default();
        let value = serde_json::to_string(value).unwrap_or_default();
        line(name, format!("{value} {unit}").trim_end());
    }
    if let Some(step) = export.time_step {
        let bound = export
            .error_bound
            .map_or_else(String::new, |b| format!(", restitution within {}", upper_bound(b)));
        line("time step", &format!("{} s{bound}", number(step)));
    }
    for penetration in &export.penetrations {
        let solver =
            if penetration.solver.is_empty() { String::new() } else { format!(" ({})", penetration.solver) };
        line("penetration", &format!("{} m{}{solver}", number(1e3 * penetration.value), penetration.unit));
    }
    line("two sides", export.combines);
    if export.measured.is_empty() {
        line("measured", "not measured: based on source or manual, and tested in a model of the law");
    }
    for measured in export.measured {
        line("measured", &measurement(measured));
    }
    line("watch for", export.caution);
    for missing in &export.missing {
        line("missing", missing);
    }
    for assumption in &export.assumptions {
        line("assumes", assumption);
    }
    for cannot in &export.cannot {
        line("cannot", cannot);
    }
    facts
}

/// Solver and worst error of a measured restitution, in words.
fn measurement(measured: &Measurement) -> String {
    let solver = if measured.solver.is_empty() { String::new() } else { format!(", {}", measured.solver) };
    let worst = measured.worst.map(|worst| worst.map_or_else(|| "refused".into(), |w| format!("{w:.1e}")));
    let [low, middle, high] = worst;
    let by_hand = measured.by_hand.map_or_else(String::new, |day| format!(", by hand on {day}"));
    let (engine, scenes) = (measured.engine, measured.scenes);
    format!("{engine}{solver}: {scenes}; errors {low}, {middle}, {high} for e = 0.2, 0.5, 0.8{by_hand}")
}

/// Table of the contact laws.
fn laws() -> String {
    let mut out = String::new();
    for law in Law::ALL {
        let kind = if law.is_exact() { "exact" } else { "approximation" };
        let speed = if law.needs_speed() { ", needs --speed" } else { "" };
        let _ = writeln!(out, "{}  ({kind}{speed})", law.name());
        for text in [law.title(), law.formula(), law.source()] {
            out += &(wrap_hanging(&format!("    {text}"), 6) + "\n");
        }
        for alias in Law::ALIASES.iter().filter(|alias| alias.law == law) {
            out += &(wrap_hanging(&format!("    also {}: {}", alias.name, alias.note), 6) + "\n");
        }
    }
    out
}

/// Table of the simulators.
fn tools() -> String {
    let mut table = Table::new(["name", "simulator", "also"]);
    for tool in Tool::ALL {
        table.row([tool.name().into(), tool.title().into(), tool.aliases().join(", ")]);
    }
    table.to_string()
}

/// Writes the force history of the impact as a plot or as numbers.
pub fn write_history(report: &DampingReport, path: &str) -> Result<(), Failure> {
    report.inputs.iter().for_each(|input| record_input(&input.path));
    let samples = samples(report)?;
    let table = || {
        let row = |s: &Sample| [s.time, s.penetration, s.rate, s.force].map(Cell::Number).to_vec();
        let names = ["time", "penetration", "rate", "force"].map(str::to_owned).to_vec();
        (names, samples.iter().map(row).collect())
    };
    let picture = || Ok(Box::new(history_sheet(report, &samples)) as Box<dyn Picture>);
    Contents { name: "impact", table: Some(&table), picture: Some(&picture), ..Contents::default() }
        .write(path)
}

/// Force over time, and over penetration; the loop encloses the dissipated energy.
fn history_sheet(report: &DampingReport, samples: &[Sample]) -> Sheet {
    let damper = &report.damper;
    let (units, factor) = (units(report), SMALL);
    let panel = |x: &dyn Fn(&Sample) -> f64| Panel {
        y_label: format!("force ({})", units.force),
        series: vec![Series {
            name: damper.law.into(),
            style: Style::Line,
            points: samples.iter().map(|s| (x(s), Some(s.force))).collect(),
        }],
        ..Panel::default()
    };
    let deepest = damper.time_of_max_penetration.map(|t| Mark { x: 1e3 * t, label: "deepest".into() });
    let over_time = Figure {
        title: format!(
            "Impact of {} {} at {} {}/s: restitution {}",
            number(report.effective_mass),
            units.mass,
            number(damper.speed.unwrap_or_default()),
            units.length,
            number(damper.achieved_restitution)
        ),
        subtitle: format!("{}, stiffness {}", damper.law, stiffness(report)),
        x_label: "time (ms)".into(),
        panels: vec![panel(&|s| 1e3 * s.time)],
        marks: deepest.into_iter().collect(),
        ..Figure::default()
    };
    let over_penetration = Figure {
        x_label: format!("penetration ({})", units.small_length),
        panels: vec![panel(&|s| factor * s.penetration)],
        ..Figure::default()
    };
    Sheet { figures: vec![over_time, over_penetration] }
}
