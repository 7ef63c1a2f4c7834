//! `percuss sweep`, and the output of any sweep.

use crate::args::SweepArgs;
use crate::failure::Failure;
use crate::output::Output;
use crate::parquet_rows;
use crate::report::{warn, write_diagnostics};
use crate::sweep_figure::drawn;
use crate::sweep_rows;
use indicatif::{ProgressBar, ProgressStyle};
use percuss_study::{MassQuestion, Model, RowSource, Sweep, SweepEnd};
use std::io::Write;
use std::path::Path;

/// Runs the command.
pub fn run(args: &SweepArgs) -> Result<(), Failure> {
    use_threads(args.threads);
    let model = args.model.load()?;
    go_through(
        &model,
        &args.contact.question()?,
        &args.source()?,
        args.output.as_deref(),
        args.model.reading.strict,
    )
}

/// Takes so many threads, the calling one included; as many as there are processors where none are asked for.
pub fn use_threads(count: Option<u16>) {
    let count = count.map_or(0, usize::from);
    // Only the first call makes threads; a program that can make none has the calling one.
    let _ = rayon::ThreadPoolBuilder::new().num_threads(count).use_current_thread().build_global();
}

/// Sweeps, with a progress bar where it takes long, and writes the rows as they are computed.
pub fn go_through(
    model: &Model,
    question: &MassQuestion,
    source: &RowSource,
    output: Option<&str>,
    strict: bool,
) -> Result<(), Failure> {
    let format = Format::of(output)?;
    let sweep = Sweep::new(model, question, source)?;
    write_diagnostics(&model.diagnostics, strict)?;
    // Hidden where stderr is no terminal.
    let bar = match sweep.count() {
        Some(count) => ProgressBar::new(count as u64).with_style(
            ProgressStyle::with_template("{bar:40} {pos}/{len} rows, {eta} left")
                .unwrap_or_else(|_| ProgressStyle::default_bar()),
        ),
        None => ProgressBar::no_length().with_style(
            ProgressStyle::with_template("{pos} rows").unwrap_or_else(|_| ProgressStyle::default_bar()),
        ),
    };
    let end = write(sweep, model, format, output, &bar);
    bar.finish_and_clear();
    let end = end?;
    write_diagnostics(&end.diagnostics, strict)?;
    summary(&end)
}

fn write(
    sweep: Sweep,
    model: &Model,
    format: Format,
    output: Option<&str>,
    bar: &ProgressBar,
) -> Result<SweepEnd, Failure> {
    let (figure, end) = match format {
        Format::Csv => return sweep_rows::csv(sweep, Output::open(output)?, bar),
        Format::Json => return sweep_rows::json(sweep, model, Output::open(output)?, bar),
        Format::JsonLines => return sweep_rows::json_lines(sweep, Output::open(output)?, bar),
        Format::Parquet => return parquet_rows::write(sweep, output.unwrap_or_default(), bar),
        Format::Svg | Format::Png => drawn(sweep, bar)?,
    };
    let bytes = match format {
        Format::Png => figure.to_png(2.0).map_err(|e| Failure::NoAnswer(e.to_string()))?,
        _ => figure.to_svg().into_bytes(),
    };
    // A picture always has a file: its format is that of the file's name.
    let mut out = Output::open(output)?;
    out.write_all(&bytes).map_err(|error| out.failure(error))?;
    out.finish()?;
    Ok(end)
}

/// What a sweep is written as.
#[derive(Clone, Copy)]
enum Format {
    Csv,
    Json,
    JsonLines,
    Parquet,
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
            "jsonl" => Ok(Format::JsonLines),
            "parquet" => Ok(Format::Parquet),
            "svg" => Ok(Format::Svg),
            "png" => Ok(Format::Png),
            _ => Err(Failure::bad_input(format!(
                "--output {path}: its name must end in .csv, .json, .jsonl, .parquet, .svg or .png"
            ))),
        }
    }
}

/// Says how many rows have no answer; exit code 1 where none has one.
fn summary(end: &SweepEnd) -> Result<(), Failure> {
    let Some(first) = &end.first_error else { return Ok(()) };
    let message = format!("{} of {} rows have no answer; the first: {first}", end.unanswered, end.rows);
    if end.unanswered == end.rows {
        return Err(Failure::NoAnswer(message));
    }
    warn(&message);
    Ok(())
}
