//! Command `percuss identify`.

use crate::args::{CheckFormat, IdentifyArgs};
use crate::document::{self, Document};
use crate::files::contents::{self, Contents, TABLES_AND_PICTURES};
use crate::files::csv::Cell;
use crate::files::output::record_input;
use crate::terminal::explanation::named_contact;
use crate::terminal::failure::Failure;
use crate::terminal::number::{fixed, number, signed, within_uncertainty};
use crate::terminal::report::{details_are_shown, with_findings, write_diagnostics};
use crate::terminal::text::Table;
use percuss_render::{Figure, Panel, Picture, Series, Sheet, Style};
use percuss_study::contact::identification::{DamperForm, Estimate};
use percuss_study::{
    ComparedMass, IdentificationReport, MeasuredImpact, identify_contact, identify_contact_of,
};

/// Ratio of mean square residuals below which both forms of a damper fit.
const SAME_FORM: f64 = 1.02;
/// Standard uncertainties behind ±.
const SHOWN: f64 = 2.0;

/// Runs the command.
pub fn run(args: &IdentifyArgs) -> Result<(), Failure> {
    args.identify.check()?;
    let output = args.identify.output.as_deref();
    output.map_or(Ok(()), |path| contents::check(path, &TABLES_AND_PICTURES))?;
    if args.mass_from.is_none() && args.contact.is_given() {
        return Err(Failure::bad_input("a contact is given without its model; give --mass-from MODEL"));
    }
    let report = match &args.mass_from {
        Some(path) => {
            let (question, model) = (args.contact.question()?, args.reading.load(path)?);
            with_findings(identify_contact_of(&model, &question, &args.identify), &model)?
        }
        None => identify_contact(&args.identify, args.mass.map(|mass| mass.0))?,
    };
    show(&report, output, args.format, args.reading.strict)
}

/// Writes the warnings, the file and the report.
pub fn show(
    report: &IdentificationReport,
    output: Option<&str>,
    format: CheckFormat,
    strict: bool,
) -> Result<(), Failure> {
    write_diagnostics(&report.diagnostics, strict)?;
    output.map_or(Ok(()), |path| write_output(report, path))?;
    document::print(report, format, || document(report))
}

/// Writes the data and the fit as a table or a picture.
pub fn write_output(report: &IdentificationReport, path: &str) -> Result<(), Failure> {
    report.inputs.iter().for_each(|input| record_input(&input.path));
    let picture = || Ok(Box::new(sheet(report)) as Box<dyn Picture>);
    let (table, picture) = (Some(&(|| cells(report)) as _), Some(&picture as _));
    Contents { name: "identification", table, picture, ..Contents::default() }.write(path)
}

/// The contact, the comparison of its mass, the impacts and the signals, with data and fit over time.
pub fn document(report: &IdentificationReport) -> Document<'_> {
    let mut out = Document::default();
    out.facts(facts(report));
    out.table(impacts(report));
    out.table(signals(report));
    report.impacts.iter().flat_map(left_out).for_each(|text| out.note(text));
    if details_are_shown() {
        out.table(correlations(report));
    }
    out.note("± two standard uncertainties, within which the value lies in 95 of 100 cases");
    let caption = "Data and fit over time, and below the residuals; dots that the line leaves are at the limit of the sensor, or outliers.";
    out.picture(|| sheet(report).to_svg(), "Measured and identified impact", caption);
    out
}

/// Value with the digits that its uncertainty supports; `factor`: of the unit.
fn plus_minus(estimate: Estimate, factor: f64, unit: &str) -> String {
    let (value, spread) = (factor * estimate.value, factor * SHOWN * estimate.uncertainty);
    let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
    if spread == 0.0 {
        return format!("{}{unit}", number(value));
    }
    format!("{} ± {}{unit}", within_uncertainty(value, spread), within_uncertainty(spread, spread))
}

/// Name of a damper.
fn form_name(form: DamperForm) -> &'static str {
    match form {
        DamperForm::KelvinVoigt => "Kelvin–Voigt, c x^((p−1)/2) v",
        DamperForm::HuntCrossley => "Hunt–Crossley, d k x^p v",
    }
}

fn facts(report: &IdentificationReport) -> Vec<(&'static str, String)> {
    let power = |exponent: f64| {
        if (exponent - 1.0).abs() < 5e-4 { String::new() } else { format!("^{}", number(exponent)) }
    };
    let p = report.exponent.value;
    let mass = plus_minus(report.effective_mass, 1.0, "kg");
    let mass =
        if report.finds_mass { mass } else { format!("{mass}, as given: the data do not determine it") };
    let mut facts = vec![("effective mass", mass)];
    facts.extend(report.named_contact.as_ref().map_or_else(Vec::new, named_contact));
    facts.extend(report.compared.as_ref().map(|compared| ("expected mass", comparison(compared))));
    facts.push(("stiffness", plus_minus(report.stiffness, 1.0, &format!("N/m{}", power(p)))));
    facts.push(("exponent", plus_minus(report.exponent, 1.0, "")));
    if let (Some(second), Some(q)) = (report.second_stiffness, report.second_exponent) {
        let unit = format!("N/m{0}, of x{0}", power(q));
        facts.push(("second term", plus_minus(second, 1.0, &unit)));
    }
    if let Some(damping) = report.damping {
        let unit = format!("N·s/m{}", power(0.5 * (p + 1.0)));
        facts.push(("damping", plus_minus(damping, 1.0, &unit)));
    }
    let time =
        report.impacts.iter().flat_map(|impact| &impact.columns).find(|column| column.quantity == "time");
    let time = time.map(|column| ("time", format!("{} in {}", column.column, column.unit)));
    facts.extend(report.dissipation.map(|d| ("dissipation", plus_minus(d, 1.0, "s/m"))));
    let other = report.other_form.map_or_else(String::new, |ratio| {
        if ratio < SAME_FORM {
            return "; the data do not distinguish the two forms".to_owned();
        }
        format!("; the other form has {} times its mean square residual", number(ratio))
    });
    facts.push(("damper", format!("{}{other}", form_name(report.damper))));
    facts.extend(time);
    facts
}

/// Expected mass, difference, and what would explain it.
fn comparison(compared: &ComparedMass) -> String {
    let expected = number(compared.expected);
    match compared.agrees {
        Some(true) => return format!("{expected} kg, agrees"),
        None => return format!("{expected} kg; the identified mass is too uncertain for a comparison"),
        Some(false) => {}
    }
    let difference = signed(compared.difference, 3);
    let each = compared.explanations.iter().map(|found| {
        format!(
            "{} by {} kg ({} %)",
            found.link,
            signed(found.change, 3),
            signed(100.0 * found.relative_change, 1)
        )
    });
    let each: Vec<String> = each.collect();
    let explained = if each.is_empty() {
        String::new()
    } else {
        format!("; explained by the mass of {}", each.join(", or of "))
    };
    format!(
        "{expected} kg; the identified mass differs by {difference} kg, more than its uncertainty{explained}"
    )
}

fn impacts(report: &IdentificationReport) -> Table {
    let is_one = report.impacts.len() == 1;
    let head = ["file", "speed m/s", "restitution", "peak N", "compression mm", "lasts ms"];
    let row = |impact: &MeasuredImpact| {
        let found = &impact.identified;
        vec![
            impact.file.clone(),
            plus_minus(found.speed, 1.0, ""),
            plus_minus(found.restitution, 1.0, ""),
            plus_minus(found.peak_force, 1.0, ""),
            plus_minus(found.max_penetration, 1e3, ""),
            plus_minus(found.contact_duration, 1e3, ""),
        ]
    };
    let rows = [head.map(str::to_owned).to_vec()].into_iter().chain(report.impacts.iter().map(row));
    Table::from_rows(rows.map(|row| row[usize::from(is_one)..].to_vec()))
}

fn signals(report: &IdentificationReport) -> Table {
    let is_one = report.impacts.len() == 1;
    let head =
        ["file", "signal", "column", "offset", "drift per s", "residual %"].map(str::to_owned).to_vec();
    let mut rows = vec![head];
    for impact in &report.impacts {
        for signal in &impact.identified.signals {
            let (name, unit) = signal.quantity.name_and_unit();
            let column = impact.columns.iter().find(|column| column.quantity == name);
            let estimate = |found: Option<Estimate>| {
                found.map_or_else(|| "–".to_owned(), |found| plus_minus(found, 1.0, unit))
            };
            let reversed = if signal.is_reversed { ", reversed" } else { "" };
            rows.push(vec![
                impact.file.clone(),
                format!("{name}{reversed}"),
                column.map_or_else(String::new, |column| format!("{} in {}", column.column, column.unit)),
                estimate(signal.offset),
                estimate(signal.drift),
                number(100.0 * signal.relative_residual),
            ]);
        }
    }
    Table::from_rows(rows.into_iter().map(|row| row[usize::from(is_one)..].to_vec()))
}

/// Samples of a file that are not used, and the time over which residuals are correlated.
fn left_out(impact: &MeasuredImpact) -> Vec<String> {
    let mut texts = Vec::new();
    let found = &impact.identified;
    if found.unused_samples > 0 {
        let [first, last] = found.used.map(|time| number(1e3 * time));
        texts.push(format!(
            "{} samples before {first} ms or after {last} ms are not used",
            found.unused_samples
        ));
    }
    for signal in &found.signals {
        let (name, _) = signal.quantity.name_and_unit();
        if signal.clipped > 0 {
            texts.push(format!("{name}: {} samples at the limit of the sensor are not used", signal.clipped));
        }
        if signal.at_touch > 0 {
            texts.push(format!(
                "{name}: {} samples beside the jump of the force at the touch are not used",
                signal.at_touch
            ));
        }
        if !signal.outliers.is_empty() {
            let times: Vec<String> =
                signal.outliers.iter().take(3).map(|time| fixed(1e3 * time, 3)).collect();
            let more = if signal.outliers.len() > 3 { ", …" } else { "" };
            let count = signal.outliers.len();
            let plural = if count == 1 { " is" } else { "s are" };
            texts.push(format!("{name}: {count} outlier{plural} not used, at {} ms{more}", times.join(", ")));
        }
        if signal.correlation_time > 0.0 && !signal.contradicts(found.contact_duration.value) {
            let time = number(1e3 * signal.correlation_time);
            texts.push(format!(
                "{name}: residuals are correlated over {time} ms; the uncertainties include the correlation"
            ));
        }
    }
    texts.into_iter().map(|text| format!("{}: {text}", impact.file)).collect()
}

fn correlations(report: &IdentificationReport) -> Table {
    let names = ["mass", "stiffness", "exponent", "damping"];
    let head = ["correlation"].into_iter().chain(names).map(str::to_owned).collect();
    let row = |(name, values): (&str, &[f64; 4])| {
        let cells = values.iter().map(|value| fixed(*value, 3));
        std::iter::once(name.to_owned()).chain(cells).collect::<Vec<String>>()
    };
    Table::from_rows([head].into_iter().chain(names.into_iter().zip(&report.correlation).map(row)))
}

/// Data and fit of all impacts as a table, SI units.
fn cells(report: &IdentificationReport) -> contents::Cells {
    let names = ["impact", "time [s]", "quantity", "measured", "fitted", "residual", "use"]
        .map(str::to_owned)
        .to_vec();
    let mut rows = Vec::new();
    for impact in &report.impacts {
        for (quantity, times, data, fit, uses) in impact.signals() {
            let (name, unit) = quantity.name_and_unit();
            for (((time, data), fit), state) in times.iter().zip(data).zip(fit).zip(uses) {
                rows.push(vec![
                    Cell::Text(impact.file.clone().into()),
                    Cell::Number(*time),
                    Cell::Text(format!("{name} [{unit}]").into()),
                    Cell::Number(*data),
                    Cell::Number(*fit),
                    Cell::Number(data - fit),
                    Cell::Text(state.name().into()),
                ]);
            }
        }
    }
    (names, rows)
}

/// A figure for each impact: data and fit of each signal, then its residuals.
fn sheet(report: &IdentificationReport) -> Sheet {
    let figures = report.impacts.iter().map(|impact| {
        let mut panels = Vec::new();
        for (quantity, times, data, fit, _) in impact.signals() {
            let (name, unit) = quantity.name_and_unit();
            let curve = |name: &str, style, values: Vec<f64>| Series {
                name: name.into(),
                style,
                points: times.iter().zip(values).map(|(time, value)| (1e3 * time, Some(value))).collect(),
            };
            let residuals = data.iter().zip(fit).map(|(data, fit)| data - fit).collect();
            panels.push(Panel {
                y_label: format!("{name} ({unit})"),
                series: vec![
                    curve("fit", Style::Line, fit.to_vec()),
                    curve("data", Style::Dots, data.to_vec()),
                ],
                ..Panel::default()
            });
            panels.push(Panel {
                y_label: format!("data − fit ({unit})"),
                series: vec![curve("data − fit", Style::Dots, residuals)],
                ..Panel::default()
            });
        }
        Figure {
            title: format!(
                "{}: restitution {}",
                impact.file,
                plus_minus(impact.identified.restitution, 1.0, "")
            ),
            subtitle: form_name(report.damper).to_owned(),
            x_label: "time (ms)".into(),
            panels,
            ..Figure::default()
        }
    });
    Sheet { figures: figures.collect() }
}
