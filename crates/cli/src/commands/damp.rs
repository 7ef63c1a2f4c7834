//! `percuss damp`, and the damper in the output of an effective mass.

use crate::args::{CheckFormat, DampArgs};
use crate::document::{self, Document};
use crate::files::contents::{self, Contents, TABLES_AND_PICTURES};
use crate::files::csv::Cell;
use crate::files::output::record_input;
use crate::terminal::explanation::{CONTACT, body_of, named_contact};
use crate::terminal::failure::Failure;
use crate::terminal::limits;
use crate::terminal::number::{self, load, number, signed, upper_bound, with_unit};
use crate::terminal::report::{details_are_shown, with_findings, write_diagnostics, write_text};
use crate::terminal::text::Table;
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
        return write_text(&laws());
    }
    if args.list_tools {
        return write_text(&tools());
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
        (None, Some(path)) => match &question.limit {
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
        add_results(report, &mut out);
        add_exports(report, &mut out);
        out
    })
}

/// Adds the damper, its impact, and what limits the result.
pub fn add_results<'a>(report: &'a DampingReport, out: &mut Document<'a>) {
    out.results(results(report));
    let contact = report.named_contact.as_ref().map_or_else(Vec::new, named_contact);
    let contact = contact.into_iter().filter(|(name, _)| *name != CONTACT);
    out.facts([headline(report)].into_iter().chain(contact).chain(facts(report)));
}

/// Adds the parameters of all requested simulators: the text to paste first, then its limits; the other numbers are details.
pub fn add_exports<'a>(report: &'a DampingReport, out: &mut Document<'a>) {
    for (name, export) in &report.exports {
        out.heading(format!("{} ({name})", export.title));
        if let Some(error) = &export.error {
            out.problem(format!("  cannot: {error}"));
            continue;
        }
        let is_short = !details_are_shown() && !export.snippets.is_empty();
        let shown = if is_short { 1 } else { export.snippets.len() };
        for snippet in export.snippets.iter().take(shown) {
            out.code(snippet.title, &*snippet.text);
        }
        // The last assumption of a force curve is the spring in its place.
        let first =
            export.assumptions.len().saturating_sub(usize::from(report.damper.stiffness_curve.is_some()));
        let facts = export_facts(export, is_short, if is_short { first } else { 0 });
        out.facts(facts.into_iter().map(|(name, value)| (format!("  {name}"), value)));
        if is_short {
            let others = export.snippets.iter().skip(1).map(|snippet| format!("{}, ", snippet.title));
            let (others, count) = (others.collect::<String>(), export.assumptions.len());
            out.note(format!("  {others}{count} assumptions, measurements, sources: --details"));
        } else if !export.sources.is_empty() {
            out.note(format!("  sources: {}", export.sources.join("; ")));
        }
    }
}

/// Section of a damper on a page, with the history of the impact.
pub fn document(report: &DampingReport) -> Result<Document<'_>, Failure> {
    let mut out = Document::default();
    out.results(results(report));
    out.facts(report.stop.is_some().then(|| headline(report)).into_iter().chain(facts(report)));
    if report.damper.speed.is_some() {
        let samples = samples(report)?;
        let caption = "Force over time, and over the compression; the loop encloses the energy that is lost.";
        let figure = move || history_sheet(report, &samples).to_svg();
        out.picture(figure, "Force over time and over compression", caption);
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

/// Name and value of the effective mass, or of the effective inertia for a rotational stop, with its named contact.
fn headline(report: &DampingReport) -> (&'static str, String) {
    let units = units(report);
    let place = report.named_contact.as_ref().map_or_else(String::new, |contact| {
        format!(" at {} ({}), on {}", contact.name, contact.kind, body_of(contact))
    });
    (units.name, format!("{} {}{place}", number(report.effective_mass), units.mass))
}

/// Factor from the SI unit of compressions (m, rad) to the displayed unit (mm, mrad).
const SMALL: f64 = 1e3;

/// Units of the contact of a report.
fn units(report: &DampingReport) -> ContactUnits {
    ContactUnits::new(report.is_moment)
}

/// Damper, then the impact: value, and its meaning.
fn results(report: &DampingReport) -> Vec<(String, String)> {
    let damper = &report.damper;
    let ContactUnits { length, small_length, force, speed, .. } = units(report);
    let law = format!("{}, {}", law_name(damper.law), stiffness(report));
    let for_restitution = format!("for the restitution {}", number(damper.restitution));
    let mut results = Vec::new();
    match (damper.damping_ratio, damper.damping) {
        (None, None) if damper.loss_factor.is_some() => results.push((
            number(damper.loss_factor.unwrap_or_default()),
            format!("loss factor {for_restitution} ({})", stiffness(report)),
        )),
        (ratio, Some(c)) => {
            let power = unit_power(damper.exponent.map_or(1.0, |p| 0.5 * (p + 1.0)));
            let ratio = ratio.map_or_else(String::new, |ratio| format!(", damping ratio {}", number(ratio)));
            results.push((
                format!("{} {force}·s/{length}{power}", number(c)),
                format!("damping {for_restitution} ({law}{ratio})"),
            ));
            results.extend(damper.dissipation.map(|d| {
                let meaning = "or Hunt–Crossley dissipation at this speed";
                (format!("{} s/{length}", number(d)), meaning.to_owned())
            }));
        }
        _ => results.push((
            format!("{} s/{length}", number(damper.dissipation.unwrap_or_default())),
            format!("dissipation {for_restitution} ({law})"),
        )),
    }
    let mut add = |value: Option<f64>, text: &dyn Fn(f64) -> String, meaning: String| {
        results.extend(value.filter(|v| v.is_finite()).map(|v| (text(v), meaning)));
    };
    let peak_time =
        damper.time_of_peak_force.map_or_else(String::new, |t| format!(", at {} ms", number(1e3 * t)));
    let what = if report.is_moment { "peak moment" } else { "peak force" };
    add(damper.peak_force, &|f| load(f, force), format!("{what}{peak_time}"));
    add(damper.max_penetration, &|x| with_unit(SMALL * x, small_length), "compression".to_owned());
    add(damper.contact_duration, &|t| with_unit(1e3 * t, "ms"), "contact time".to_owned());
    let rebound = damper.rebound_speed.map_or_else(String::new, |v| format!(", {} {speed} after", number(v)));
    let closing =
        damper.speed.map_or_else(String::new, |v| format!("; closing speed {} {speed}{rebound}", number(v)));
    add(damper.energy_lost, &|x| with_unit(x, "J"), format!("energy lost{closing}"));
    results
}

/// Name of a contact law in texts.
pub fn law_name(law: &str) -> &str {
    Law::ALL.iter().find(|known| known.name() == law).map_or(law, |known| known.title())
}

/// Limits of the result, and with the details the form of the law.
pub fn facts(report: &DampingReport) -> Vec<(&'static str, String)> {
    let damper = &report.damper;
    let ContactUnits { small_length: shown, mass: mass_unit, .. } = units(report);
    let e = damper.restitution;
    let mut facts = Vec::new();
    let ending = match damper.separation {
        Some("gap") => Some("ends when the gap closes (the damper pulls at the end)"),
        Some(_) if details_are_shown() => Some("ends when the force vanishes"),
        _ => None,
    };
    let given = damper.law_alias.map(|alias| format!("given as {alias}"));
    let law: Vec<String> = ending.map(str::to_owned).into_iter().chain(given).collect();
    if !law.is_empty() {
        facts.push(("contact law", format!("{}: {}", damper.law, law.join("; "))));
    }
    let weight = report.exports.values().any(|export| export.weight_prevents_rebound);
    if !damper.law_is_exact || weight {
        let mut text = format!("{} without gravity", number(damper.achieved_restitution));
        if !damper.law_is_exact {
            let error = signed(damper.achieved_restitution - e, 4);
            text += &format!(", {} requested (error {error}: this law is an approximation)", number(e));
        }
        if weight {
            text += "; near 0 if no spring carries the weight";
        }
        facts.push(("restitution", text));
    }
    if let Some(drift) = report.drift {
        let percent = |p: f64| format!("{} %", signed(p, 2));
        let slope = drift.per_metre.map(|s| format!("{} per {shown}", percent(0.1 * s)));
        let over = drift.over_penetration.map(|o| format!("{} over the compression", percent(100.0 * o)));
        let ends = drift
            .ends_at
            .map(|depth| format!("unknown: the motion ends after {} {shown}", number(SMALL * depth)));
        let text: Vec<String> = [over, ends, slope].into_iter().flatten().collect();
        // The result with varying m̄ contains the change.
        if details_are_shown() || report.over_stroke.is_none() {
            facts.push(("change of m̄", if text.is_empty() { "unknown".into() } else { text.join(", ") }));
        }
    }
    if let Some(stroke) = report.over_stroke {
        let change = 100.0 * (stroke.mass_at_max_penetration / report.effective_mass - 1.0);
        facts.push((
            "with varying m̄",
            format!(
                "restitution {}, compression {} {shown}, m̄ {} % to {} {mass_unit}",
                number(stroke.restitution),
                number(SMALL * stroke.max_penetration),
                signed(change, 2),
                number(stroke.mass_at_max_penetration)
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
pub fn stiffness(report: &DampingReport) -> String {
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
    let Some(curve) = curve else {
        let (k, p) = (stiffness.unwrap_or_default(), exponent.unwrap_or(1.0));
        return number::stiffness(k, force, length, p);
    };
    let ForceCurveRecord { stop, deflections, forces, coefficients, exponents } = curve;
    let of = stop.as_ref().map_or_else(|| "as given".to_owned(), |stop| format!("of {stop} in the sheet"));
    let [depth, last] = [deflections, forces].map(|values| values.last().copied().unwrap_or_default());
    let term = |(c, p): (&f64, &f64)| format!("{} x{}", number(*c), unit_power(*p));
    let form = match coefficients.is_empty() {
        true => format!("{} points", forces.len()),
        false => {
            coefficients.iter().zip(exponents).map(term).collect::<Vec<_>>().join(" + ").replace("+ -", "− ")
        }
    };
    format!(
        "force curve {of}, {form} to {} {force} at {} {small_length}",
        number(last),
        number(SMALL * depth)
    )
}

/// Exponent of a unit, if any.
pub fn unit_power(exponent: f64) -> String {
    if exponent == 1.0 { String::new() } else { format!("^{}", number(exponent)) }
}

/// Parameters, errors and assumptions of one simulator. `is_short`: only what limits the text to paste; `first`: first assumption shown.
fn export_facts(export: &ExportRecord, is_short: bool, first: usize) -> Vec<(String, String)> {
    let mut facts = Vec::new();
    let mut line = |name: &str, text: &str| facts.push((name.to_owned(), text.to_owned()));
    if !is_short {
        line("integrates", export.law);
        for (name, value) in &export.parameters {
            let unit = export.units.get(name).copied().unwrap_or_default();
            let value = serde_json::to_string(value).unwrap_or_default();
            line(name, format!("{value} {unit}").trim_end());
        }
    }
    if let Some(step) = export.time_step {
        let bound = export
            .error_bound
            .map_or_else(String::new, |b| format!(", restitution within {}", upper_bound(b)));
        line("time step", &format!("{} s{bound}", number(step)));
    }
    for penetration in export.penetrations.iter().filter(|_| !is_short) {
        let solver =
            if penetration.solver.is_empty() { String::new() } else { format!(" ({})", penetration.solver) };
        line("compression", &format!("{} m{}{solver}", number(1e3 * penetration.value), penetration.unit));
    }
    if !is_short {
        line("two sides", export.combines);
        if export.measured.is_empty() {
            line("measured", "not measured: based on source or manual, and tested in a model of the law");
        }
        for measured in export.measured {
            line("measured", &measurement(measured));
        }
    }
    line("watch for", export.caution);
    for missing in &export.missing {
        line("missing", missing);
    }
    for (i, assumption) in export.assumptions.iter().enumerate().skip(first) {
        line("assumes", &format!("{}. {assumption}", i + 1));
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

/// Force over time, and over the compression; the loop encloses the dissipated energy.
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
        subtitle: format!("{}, stiffness {}", law_name(damper.law), stiffness(report)),
        x_label: "time (ms)".into(),
        panels: vec![panel(&|s| 1e3 * s.time)],
        marks: deepest.into_iter().collect(),
        ..Figure::default()
    };
    let over_penetration = Figure {
        x_label: format!("compression ({})", units.small_length),
        panels: vec![panel(&|s| factor * s.penetration)],
        ..Figure::default()
    };
    Sheet { figures: vec![over_time, over_penetration] }
}
