//! Command `percuss sweep`, and the output of all sweeps.

use crate::args::SweepArgs;
use crate::commands::mass::refuse_several_contacts;
use crate::commands::sweep_text::SweepText;
use crate::document::Document;
use crate::files::contents::{PICTURES, picture_bytes};
use crate::files::output::{Output, check_writable, ending_of, record_input, write_file};
use crate::files::parquet_rows;
use crate::files::sweep_rows;
use crate::files::table_style::TableStyle;
use crate::files::xlsx_rows;
use crate::pictures::clipping::note_clipping;
use crate::pictures::sweep_figure::sweep_figure;
use crate::terminal::console;
use crate::terminal::failure::Failure;
use crate::terminal::limits;
use crate::terminal::report::{warn, with_findings, write_diagnostics, write_text};
use indicatif::{ProgressBar, ProgressStyle};
use percuss_mechanism::JointKind;
use percuss_study::{
    MassQuestion, Model, Quantity, RowSource, StudyError, StudyFigure, Sweep, SweepEnd, TableUnit, Varied,
};
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::cell::OnceCell;
use std::ops::ControlFlow;

thread_local! {
    /// Threads of the runs on this thread; `None` if they cannot be created.
    static POOL: OnceCell<Option<ThreadPool>> = const { OnceCell::new() };
}

/// Runs the command.
pub fn run(args: &SweepArgs) -> Result<(), Failure> {
    use_threads(args.threads);
    args.writing.apply();
    let model = args.model.load()?;
    refuse_several_contacts(&model, args.contact.contact.at.as_deref(), "a sweep")?;
    warn_plain_angles(args, &model);
    let (question, requested) = (args.contact.question_of_rows()?, args.question()?);
    let source = requested.rows();
    let destination = SweepOutput {
        output: args.sweep.output.as_deref(),
        table: TableStyle::from_study(&args.table),
        figure: args.figure.clone(),
        strict: args.model.reading.strict,
    };
    let sweep = Sweep::new(&model, &question, &source);
    let sweep = sweep.map(|sweep| if args.sweep.gradient { sweep.with_gradient() } else { sweep });
    ReadySweep::new(&model, &question, &source, sweep, destination)?.run()
}

/// Warns about ranges of turning joints without a unit beside `--unit deg`, which is the unit of the output only.
fn warn_plain_angles(args: &SweepArgs, model: &Model) {
    if !args.table.units.contains(&TableUnit::Degree) {
        return;
    }
    for vary in &args.sweep.vary {
        let Varied::Joint(name) = &vary.quantity else { continue };
        let turns = model.mechanism.find_joint(name).is_ok_and(|id| {
            matches!(model.mechanism.joint(id).kind(), JointKind::Revolute | JointKind::Continuous)
        });
        let is_plain = |end: Quantity| end.dimension.is_none() && end.value != 0.0;
        if turns && (is_plain(vary.from) || is_plain(vary.to)) {
            warn(&format!(
                "--vary {name}: numbers without a unit are in rad; --unit deg is the unit of the table. For degrees write \
                 {name}={}deg:{}deg:{}",
                vary.from.value, vary.to.value, vary.count
            ));
        }
    }
}

/// Sets the number of threads, including the calling thread; the default is the number of processors.
pub fn use_threads(count: Option<u16>) {
    let count = count.map_or(0, usize::from);
    // Only the first call on a thread creates threads. If no thread can be created, the calling thread does all work.
    let build = || ThreadPoolBuilder::new().num_threads(count).use_current_thread().build().ok();
    POOL.with(|pool| {
        pool.get_or_init(build);
    });
}

/// Output options of a sweep.
pub struct SweepOutput<'a> {
    pub output: Option<&'a str>,
    pub table: TableStyle,
    pub figure: StudyFigure,
    pub strict: bool,
}

/// Sweep that is ready to run: format of its output, and its rows.
pub struct ReadySweep<'a> {
    format: Format,
    sweep: Sweep<'a>,
    model: &'a Model,
    question: &'a MassQuestion,
    destination: SweepOutput<'a>,
}

impl<'a> ReadySweep<'a> {
    /// Checks everything before the first row. `question`: that of the rows.
    pub fn new(
        model: &'a Model,
        question: &'a MassQuestion,
        source: &RowSource,
        sweep: Result<Sweep<'a>, StudyError>,
        destination: SweepOutput<'a>,
    ) -> Result<Self, Failure> {
        let format = Format::from_output(destination.output)?;
        model.inputs.iter().for_each(|input| record_input(&input.path));
        if let RowSource::File(file) = source {
            record_input(&file.path);
        }
        destination.output.map_or(Ok(()), check_writable)?;
        Ok(Self { format, sweep: with_findings(sweep, model)?, model, question, destination })
    }

    /// Runs the sweep, with a progress bar, and writes each row when it is computed.
    pub fn run(self) -> Result<(), Failure> {
        let Self { format, sweep, model, question, destination } = self;
        let strict = destination.strict;
        write_diagnostics(&model.diagnostics, strict)?;
        let bar = match sweep.count() {
            _ if !console::stderr().is_terminal() => ProgressBar::hidden(),
            Some(count) => ProgressBar::new(count as u64).with_style(
                ProgressStyle::with_template("{bar:40} {pos}/{len} rows, {eta} left")
                    .unwrap_or_else(|_| ProgressStyle::default_bar()),
            ),
            None => ProgressBar::no_length().with_style(
                ProgressStyle::with_template("{pos} rows").unwrap_or_else(|_| ProgressStyle::default_bar()),
            ),
        };
        let end = write(sweep, model, format, &destination, question, &bar);
        bar.finish_and_clear();
        let end = end?;
        write_diagnostics(&end.diagnostics, strict)?;
        summary(&end)
    }

    /// Writes the rows to a file, without a progress bar and without findings.
    pub fn write_rows(self) -> Result<(), Failure> {
        let Self { format, sweep, model, question, destination } = self;
        write(sweep, model, format, &destination, question, &ProgressBar::hidden()).map(|_| ())
    }
}

/// Writes the rows in a format while the sweep runs.
fn write(
    sweep: Sweep,
    model: &Model,
    format: Format,
    destination: &SweepOutput,
    question: &MassQuestion,
    bar: &ProgressBar,
) -> Result<SweepEnd, Failure> {
    let (output, path) = (destination.output, destination.output.unwrap_or_default());
    let (figure, end) = match format {
        Format::Csv if output.is_none() && console::stdout().is_terminal() => {
            return write_table(sweep, bar);
        }
        Format::Csv => return sweep_rows::csv(sweep, model, destination.table, Output::open(output)?, bar),
        Format::Xlsx => return xlsx_rows::write(sweep, model, destination.table, path, bar),
        Format::Json => return sweep_rows::json(sweep, model, Output::open(output)?, bar),
        Format::JsonLines => return sweep_rows::json_lines(sweep, Output::open(output)?, bar),
        Format::Parquet => return parquet_rows::write(sweep, model, path, bar),
        Format::Picture => sweep_figure(sweep, question, &destination.figure, bar)?,
    };
    let mut figure = figure;
    note_clipping(&mut figure);
    // A picture always has an output file, because the file name determines the format.
    write_file(path, &picture_bytes(&figure, ending_of(path, &PICTURES)?)?)?;
    Ok(end)
}

/// Writes a table for people to the terminal.
fn write_table(sweep: Sweep, bar: &ProgressBar) -> Result<SweepEnd, Failure> {
    let mut text = SweepText::new(sweep.heading());
    let end = sweep.run(&mut |row| {
        bar.inc(1);
        text.add(&row);
        ControlFlow::Continue(())
    })?;
    bar.finish_and_clear();
    let mut out = Document::default();
    out.table(text.table(limits::SWEEP_ROWS_ON_TERMINAL));
    out.remark(format!("{}\nall rows and columns: -o FILE.csv, or a pipe", text.summary()));
    write_text(&out.text())?;
    Ok(end)
}

/// Output format of a sweep.
#[derive(Clone, Copy)]
enum Format {
    Csv,
    Json,
    JsonLines,
    Parquet,
    Xlsx,
    Picture,
}

impl Format {
    /// Determines the format from the file extension; CSV on stdout.
    fn from_output(output: Option<&str>) -> Result<Self, Failure> {
        let Some(path) = output else { return Ok(Format::Csv) };
        Ok(match ending_of(path, &["csv", "xlsx", "json", "jsonl", "parquet", "svg", "png", "pdf"])? {
            "xlsx" => Format::Xlsx,
            "json" => Format::Json,
            "jsonl" => Format::JsonLines,
            "parquet" => Format::Parquet,
            "svg" | "png" | "pdf" => Format::Picture,
            _ => Format::Csv,
        })
    }
}

/// Reports the number of rows without a result; exit code 1 if no row has a result.
fn summary(end: &SweepEnd) -> Result<(), Failure> {
    let Some(first) = &end.first_error else { return Ok(()) };
    let message =
        format!("{} of {} rows have no result; the first: {first}", end.rows_without_result, end.rows);
    if end.rows_without_result == end.rows {
        return Err(Failure::NoAnswer(message));
    }
    warn(&message);
    Ok(())
}
