//! Command `percuss response`.

use crate::args::{CheckFormat, ResponseArgs};
use crate::commands::mass::compliance;
use crate::document::{self, Document};
use crate::files::contents::{self, Contents, TABLES_AND_PICTURES};
use crate::files::csv::Cell;
use crate::terminal::explanation::named_contact;
use crate::terminal::failure::Failure;
use crate::terminal::limits::{MODES_SHOWN, SEEN_SHARE};
use crate::terminal::number::{fixed, number, with_unit};
use crate::terminal::report::{details_are_shown, with_findings, write_diagnostics};
use crate::terminal::text::{Table, TableCell};
use crate::terminal::units::ContactUnits;
use percuss_render::{Figure, LabelledPoint, Mark, Panel, Picture, Series, Style};
use percuss_study::{ComplexSeries, ModeRecord, ModeShareRecord, ResponseReport, response};

/// Runs the command.
pub fn run(args: &ResponseArgs) -> Result<(), Failure> {
    args.response.check()?;
    let output = args.response.output.as_deref();
    output.map_or(Ok(()), |path| contents::check(path, &TABLES_AND_PICTURES))?;
    let (question, model) = (args.contact.question()?, args.model.load()?);
    let report = with_findings(response(&model, &question, &args.response), &model)?;
    show(&report, output, args.format, args.model.reading.strict)
}

/// Writes the warnings, the file and the report.
pub fn show(
    report: &ResponseReport,
    output: Option<&str>,
    format: CheckFormat,
    strict: bool,
) -> Result<(), Failure> {
    write_diagnostics(&report.diagnostics, strict)?;
    output.map_or(Ok(()), |path| write_output(report, path))?;
    document::print(report, format, || document(report))
}

/// Writes the responses as a table or a picture.
pub fn write_output(report: &ResponseReport, path: &str) -> Result<(), Failure> {
    let picture = || Ok(Box::new(figure(report)) as Box<dyn Picture>);
    let (table, picture) = (Some(&(|| cells(report)) as _), Some(&picture as _));
    Contents { name: "response", table, picture, ..Contents::default() }.write(path)
}

/// Masses, residual stiffness, natural modes, and the apparent mass over frequency.
pub fn document(report: &ResponseReport) -> Document<'_> {
    let mut out = Document::default();
    let units = ContactUnits::new(report.is_moment);
    let mass =
        report.effective_mass.map_or_else(|| report.status.name().to_owned(), |m| with_unit(m, report.unit));
    out.facts([(
        units.name,
        format!("{mass}   ({} rigid)", report.compliance.as_ref().map_or("bushes", |found| found.elastic)),
    )]);
    out.facts(report.named_contact.as_ref().map_or_else(Vec::new, named_contact));
    if let Some(found) = &report.compliance {
        out.facts(compliance::facts_of(found, &mass, report.unit, &units));
    }
    let stiffness = report.static_stiffness.map(|k| compliance::stiffness(k, &units));
    out.facts([(
        "static stiffness",
        stiffness.unwrap_or_else(|| "0: a motion without stiffness closes the gap".to_owned()),
    )]);
    out.table(over_stiffness(report, &units));
    out.table(modes(report));
    let left = report.modes.len().saturating_sub(MODES_SHOWN);
    if left > 0 && !details_are_shown() {
        out.note(format!("{left} further modes: --details, or --format json"));
    }
    out.note("participation: part of the mode in the inverse of the free mass; damping to first order");
    let caption = "Apparent mass over frequency, with the rigid and the free mass; lines at the natural frequencies with a participation.";
    out.picture(|| figure(report).to_svg(), "Apparent mass over frequency", caption);
    out
}

/// Impacts over the stiffness of the contact; empty without elastic bushes and gears.
fn over_stiffness(report: &ResponseReport, units: &ContactUnits) -> Table {
    let mut table = Table::new([
        "contact without damping",
        &format!("m_imp {}", report.unit),
        &format!("of the peak force {}", report.unit),
        "restitution",
        "contact ms",
    ]);
    for impact in &report.over_stiffness {
        table.row([
            TableCell::from(compliance::stiffness(impact.stiffness, units)),
            TableCell::Part(Some(impact.impulse_mass)),
            TableCell::Part(Some(impact.force_mass)),
            TableCell::Part(Some(impact.restitution)),
            TableCell::Part(impact.duration.map(|time| 1e3 * time)),
        ]);
    }
    table
}

/// Natural modes, at most [`MODES_SHOWN`] without details.
fn modes(report: &ResponseReport) -> Table {
    let mut table = Table::new(["mode Hz", "participation %", "damping %", "moves", "in"]);
    let most = if details_are_shown() { usize::MAX } else { MODES_SHOWN };
    let names = |parts: &[ModeShareRecord]| {
        let shown = parts.iter().filter(|part| part.share >= SEEN_SHARE).take(2);
        let texts: Vec<String> =
            shown.map(|part| format!("{} {} %", part.name, fixed(100.0 * part.share, 0))).collect();
        texts.join(", ")
    };
    for mode in report.modes.iter().take(most) {
        let share = mode.share.map_or_else(|| "–".to_owned(), |share| fixed(100.0 * share, 1));
        table.row([
            number(mode.frequency),
            share,
            fixed(100.0 * mode.damping_ratio, 1),
            names(&mode.links),
            names(&mode.elements),
        ]);
    }
    table
}

/// Columns of a table: name with unit, and values.
fn columns(report: &ResponseReport) -> Vec<(String, &[Option<f64>])> {
    let ContactUnits { mass, force, length, .. } = ContactUnits::new(report.is_moment);
    let all: [(&str, String, &ComplexSeries); 4] = [
        ("apparent mass", mass.to_owned(), &report.apparent_mass),
        ("accelerance", format!("1/{mass}"), &report.accelerance),
        ("mobility", format!("{length}/({force}·s)"), &report.mobility),
        ("dynamic stiffness", format!("{force}/{length}"), &report.dynamic_stiffness),
    ];
    let parts = all.into_iter().flat_map(|(name, unit, series)| {
        [("real", &series.real), ("imaginary", &series.imaginary)]
            .map(|(part, values)| (format!("{name}, {part} [{unit}]"), &values[..]))
    });
    parts.collect()
}

/// Responses over frequency as a table, SI units.
fn cells(report: &ResponseReport) -> contents::Cells {
    let columns = columns(report);
    let names = std::iter::once("frequency [Hz]".to_owned());
    let names = names.chain(columns.iter().map(|(name, _)| name.clone())).collect();
    let row = |(i, frequency): (usize, &f64)| {
        let values = columns.iter().map(|(_, values)| Cell::from_value(values[i]));
        std::iter::once(Cell::Number(*frequency)).chain(values).collect()
    };
    (names, report.frequency.iter().enumerate().map(row).collect())
}

/// Magnitude of the apparent mass over frequency, both logarithmic.
fn figure(report: &ResponseReport) -> Figure {
    let frequency = || report.frequency.iter().map(|f| f.log10());
    let line = |name: &str, style, value: &dyn Fn(usize) -> Option<f64>| Series {
        name: name.to_owned(),
        style,
        points: frequency()
            .enumerate()
            .map(|(i, x)| (x, value(i).filter(|y| *y > 0.0).map(f64::log10)))
            .collect(),
    };
    let series = &report.apparent_mass;
    let size = |i: usize| Some(series.real[i]?.hypot(series.imaginary[i]?));
    let mut lines = vec![line("apparent mass", Style::Line, &size)];
    let free = report.compliance.as_ref().and_then(|found| found.free_mass);
    for (name, value) in [("rigid", report.effective_mass), ("free", free)] {
        if value.is_some() {
            lines.push(line(name, Style::Dashed, &|_| value));
        }
    }
    let participates =
        |mode: &&ModeRecord| mode.share.is_none_or(|share| share >= SEEN_SHARE) && mode.frequency > 0.0;
    let name = |mode: &ModeRecord| mode.links.first().map_or_else(String::new, |link| link.name.clone());
    let marks = report
        .modes
        .iter()
        .filter(participates)
        .map(|mode| Mark { x: mode.frequency.log10(), label: name(mode) });
    let ContactUnits { mass, .. } = ContactUnits::new(report.is_moment);
    Figure {
        title: "Apparent mass of the contact".to_owned(),
        subtitle: report
            .named_contact
            .as_ref()
            .map_or_else(|| report.link.clone(), |contact| contact.name.clone()),
        x_label: "frequency (Hz)".to_owned(),
        panels: vec![Panel {
            y_label: format!("|apparent mass| ({mass})"),
            series: lines,
            values: Vec::<LabelledPoint>::new(),
            ..Panel::default()
        }],
        marks: marks.collect(),
        is_logarithmic: true,
        ..Figure::default()
    }
}
