//! The rows of a sweep, written as they are computed: none is kept.

use crate::csv;
use crate::failure::Failure;
use indicatif::ProgressBar;
use percuss_study::{DiagnosticRecord, Model, StudyError, Sweep, SweepEnd, SweepHeading, SweepRow};
use serde::ser::{Error as _, Serialize, SerializeSeq, Serializer};
use std::cell::{Cell, RefCell};
use std::fs::{File, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

/// Rows are passed on at least this often, so that whoever reads them sees that there are some.
const PASSED_ON: Duration = Duration::from_millis(200);

/// Where rows go: stdout, or a file.
pub struct Target {
    out: BufWriter<Box<dyn Write>>,
    path: Option<String>,
    passed_on: Instant,
}

impl Target {
    /// Opens it. What a file held before is kept until the first row is written.
    pub fn open(path: Option<&str>) -> Result<Self, Failure> {
        let out: Box<dyn Write> = match path {
            None => Box::new(io::stdout()),
            Some(path) => {
                let file = OpenOptions::new().write(true).create(true).truncate(false).open(path);
                Box::new(Replaced { file: file.map_err(|error| cannot_write(path, &error))?, begun: false })
            }
        };
        let path = path.map(str::to_owned);
        Ok(Self { out: BufWriter::new(out), path, passed_on: Instant::now() })
    }

    /// Leaves out what was not passed on yet.
    fn discard(self) {
        let _ = self.out.into_parts();
    }

    /// Why it cannot be written.
    fn failure(&self, error: io::Error) -> Failure {
        match &self.path {
            None => error.into(),
            Some(path) => cannot_write(path, &error),
        }
    }
}

impl Write for Target {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.out.write(bytes)?;
        if self.passed_on.elapsed() > PASSED_ON {
            self.flush()?;
        }
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.passed_on = Instant::now();
        self.out.flush()
    }
}

fn cannot_write(path: &str, error: &io::Error) -> Failure {
    Failure::bad_input(format!("{path} cannot be written: {error}"))
}

/// A file whose old contents go when the first new ones come.
struct Replaced {
    file: File,
    begun: bool,
}

impl Write for Replaced {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if !std::mem::replace(&mut self.begun, true) {
            // A device has no length to set.
            let _ = self.file.set_len(0);
        }
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

/// Writes rows as CSV.
pub fn csv(sweep: Sweep, mut target: Target, bar: &ProgressBar) -> Result<SweepEnd, Failure> {
    let heading = sweep.heading().clone();
    let mut header = Some(csv::sweep_header(&heading));
    let mut written = Ok(());
    let end = sweep.run(&mut |row| {
        bar.inc(1);
        let text = header.take().unwrap_or_default() + &csv::sweep_row(&heading, &row);
        written = target.write_all(text.as_bytes());
        if written.is_ok() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    })?;
    written.and_then(|()| target.flush()).map_err(|error| target.failure(error))?;
    Ok(end)
}

/// Writes a sweep as JSON: what a [`SweepReport`](percuss_study::SweepReport) is, without ever having one.
pub fn json(sweep: Sweep, model: &Model, mut target: Target, bar: &ProgressBar) -> Result<SweepEnd, Failure> {
    let heading = sweep.heading().clone();
    let rows = Rows { sweep: Cell::new(Some(sweep)), end: RefCell::new(None), bar };
    let document = Document { heading, rows: &rows, diagnostics: Diagnostics { model, rows: &rows } };
    let written = document.serialize(&mut serde_json::Serializer::pretty(&mut target));
    let written = written.map_err(io::Error::from).and_then(|()| target.flush());
    match rows.end.take() {
        Some(Err(error)) => {
            target.discard();
            Err(error.into())
        }
        end => {
            written.map_err(|error| target.failure(error))?;
            end.and_then(Result::ok)
                .ok_or_else(|| Failure::NoAnswer("the sweep was written without its rows".into()))
        }
    }
}

#[derive(serde::Serialize)]
struct Document<'a> {
    #[serde(flatten)]
    heading: SweepHeading,
    rows: &'a Rows<'a>,
    diagnostics: Diagnostics<'a>,
}

/// The rows: computed while they are written, once.
struct Rows<'a> {
    sweep: Cell<Option<Sweep<'a>>>,
    end: RefCell<Option<Result<SweepEnd, StudyError>>>,
    bar: &'a ProgressBar,
}

impl Serialize for Rows<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut list = serializer.serialize_seq(None)?;
        let mut written = Ok(());
        if let Some(sweep) = self.sweep.take() {
            let end = sweep.run(&mut |row: SweepRow| {
                self.bar.inc(1);
                written = list.serialize_element(&row);
                if written.is_ok() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
            });
            let failed = end.is_err();
            self.end.replace(Some(end));
            written?;
            if failed {
                return Err(S::Error::custom("the sweep ended early"));
            }
        }
        list.end()
    }
}

/// What was found, in the file and in the rows: known when those are written.
struct Diagnostics<'a> {
    model: &'a Model,
    rows: &'a Rows<'a>,
}

impl Serialize for Diagnostics<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let end = self.rows.end.borrow();
        let of_rows = end.iter().flatten().flat_map(|end| &end.diagnostics);
        let all: Vec<&DiagnosticRecord> = self.model.diagnostics.iter().chain(of_rows).collect();
        all.serialize(serializer)
    }
}
