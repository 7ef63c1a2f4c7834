//! `percuss sweep`, and the output of any sweep.

use crate::args::SweepArgs;
use crate::csv;
use crate::failure::Failure;
use crate::report::{warn, write_diagnostics, write_file, write_out};
use indicatif::{ProgressBar, ProgressStyle};
use percuss_render::{Figure, Mark, Panel, Series, Style};
use percuss_study::{MassQuestion, Model, SweepReport, Vary, sweep};
use std::path::Path;

/// Runs the command.
pub fn run(args: &SweepArgs) -> Result<(), Failure> {
    let model = args.model.load()?;
    go_through(
        &model,
        &args.contact.question(),
        &args.vary,
        args.output.as_deref(),
        args.model.reading.strict,
    )
}

/// Sweeps, with a progress bar where it takes long, and writes the rows.
pub fn go_through(
    model: &Model,
    question: &MassQuestion,
    vary: &Vary,
    output: Option<&str>,
    strict: bool,
) -> Result<(), Failure> {
    let format = Format::of(output)?;
    // Hidden where stderr is no terminal.
    let bar = ProgressBar::new(vary.count as u64).with_style(
        ProgressStyle::with_template("{bar:40} {pos}/{len} rows, {eta} left")
            .unwrap_or_else(|_| ProgressStyle::default_bar()),
    );
    let report = sweep(model, question, vary, &mut |done, _| bar.set_position(done as u64));
    bar.finish_and_clear();
    let report = report?;
    write_diagnostics(&report.diagnostics, strict)?;
    let bytes = match format {
        Format::Csv => csv::of_sweep(&report).into_bytes(),
        Format::Json => {
            let text = serde_json::to_string_pretty(&report);
            text.map_err(|e| Failure::NoAnswer(format!("the result has no JSON form: {e}")))?.into_bytes()
        }
        Format::Svg => figure(&report).to_svg().into_bytes(),
        Format::Png => figure(&report).to_png(2.0).map_err(|e| Failure::NoAnswer(e.to_string()))?,
    };
    match output {
        None => write_out(&String::from_utf8_lossy(&bytes))?,
        Some(path) => write_file(path, &bytes)?,
    }
    summary(&report)
}

/// What a sweep is written as.
#[derive(Clone, Copy)]
enum Format {
    Csv,
    Json,
    Svg,
    Png,
}

impl Format {
    /// By the ending of the file; CSV on stdout.
    fn of(output: Option<&str>) -> Result<Self, Failure> {
        let Some(path) = output else { return Ok(Format::Csv) };
        let ending = Path::new(path).extension().and_then(|e| e.to_str()).unwrap_or("");
        match ending.to_ascii_lowercase().as_str() {
            "csv" => Ok(Format::Csv),
            "json" => Ok(Format::Json),
            "svg" => Ok(Format::Svg),
            "png" => Ok(Format::Png),
            _ => Err(Failure::bad_input(format!(
                "--output {path}: its name must end in .csv, .json, .svg or .png"
            ))),
        }
    }
}

/// Says how many rows have no answer; exit code 1 where none has one.
fn summary(report: &SweepReport) -> Result<(), Failure> {
    let failed: Vec<_> = report.rows.iter().filter(|row| row.error.is_some()).collect();
    let Some(first) = failed.first().and_then(|row| row.error.clone()) else { return Ok(()) };
    let message =
        format!("{} of {} rows have no answer; the first: {first}", failed.len(), report.rows.len());
    if failed.len() == report.rows.len() {
        return Err(Failure::NoAnswer(message));
    }
    warn(&message);
    Ok(())
}

/// Effective mass with the estimate, and the motion ratio below it.
fn figure(report: &SweepReport) -> Figure {
    let (scale, unit) = if report.unit == "m" { (1e3, "mm") } else { (180.0 / std::f64::consts::PI, "deg") };
    let series = |name: &str, style, value: &dyn Fn(&percuss_study::SweepRow) -> Option<f64>| Series {
        name: name.into(),
        style,
        points: report.rows.iter().map(|row| (scale * row.value, value(row))).collect(),
    };
    let mut masses = vec![series("effective mass", Style::Line, &|row| row.effective_mass)];
    if report.rows.iter().any(|row| row.estimate.is_some()) {
        masses.push(series("estimate", Style::Dashed, &|row| row.estimate));
    }
    let mut panels = vec![Panel { y_label: "m̄ (kg)".into(), series: masses }];
    if report.rows.iter().any(|row| row.motion_ratio.is_some()) {
        let ratio = series("A over contact", Style::Line, &|row| row.motion_ratio);
        panels.push(Panel { y_label: "motion ratio".into(), series: vec![ratio] });
    }
    let mark = |row: &percuss_study::SweepRow| Mark { x: scale * row.value, label: "singular".into() };
    Figure {
        title: format!("Effective mass at {}", report.link),
        subtitle: report.inputs.first().map_or_else(String::new, |input| input.path.clone()),
        x_label: format!("{} ({unit})", report.varied),
        panels,
        marks: report.rows.iter().filter(|row| row.singular_pose == Some(true)).map(mark).collect(),
    }
}
