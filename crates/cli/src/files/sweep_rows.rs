//! Rows of a sweep, written while they are computed; no row is kept.

use crate::files::csv::SweepTable;
use crate::files::output::Output;
use crate::files::table_style::TableStyle;
use crate::terminal::failure::Failure;
use indicatif::ProgressBar;
use percuss_study::{DiagnosticRecord, Model, StudyError, Sweep, SweepEnd, SweepHeading, SweepRow};
use serde::ser::{Error as _, Serialize, SerializeSeq, Serializer};
use std::cell::{Cell, RefCell};
use std::io::{self, Write};
use std::ops::ControlFlow;

/// Writes rows as CSV.
pub fn csv(
    sweep: Sweep,
    model: &Model,
    style: TableStyle,
    out: Output,
    bar: &ProgressBar,
) -> Result<SweepEnd, Failure> {
    let table = SweepTable::new(sweep.heading(), &model.mechanism, style);
    lines(sweep, table.header(), &|row| table.row(&row), out, bar)
}

/// Writes rows as JSON lines.
pub fn json_lines(sweep: Sweep, out: Output, bar: &ProgressBar) -> Result<SweepEnd, Failure> {
    // The keys of a row are strings and its numbers are finite, so the conversion cannot fail.
    lines(sweep, "", &|row| serde_json::to_string(&row).unwrap_or_default() + "\n", out, bar)
}

/// Writes a header and the text `row_text` of each row.
fn lines(
    sweep: Sweep,
    header: &str,
    row_text: &(dyn Fn(SweepRow) -> String + Sync),
    mut out: Output,
    bar: &ProgressBar,
) -> Result<SweepEnd, Failure> {
    let mut written = Ok(());
    let mut header = Some(header);
    let end = sweep.run_with_conversion(row_text, &mut |row| {
        bar.inc(1);
        // The header is written with the first row: a sweep without rows writes nothing.
        let header_result = out.write_all(header.take().unwrap_or_default().as_bytes());
        written = header_result.and_then(|()| out.write_all(row.as_bytes()));
        if written.is_ok() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    })?;
    written.map_err(|error| out.failure(error))?;
    out.finish()?;
    Ok(end)
}

/// Writes a sweep as JSON, in the form of a [`SweepReport`](percuss_study::SweepReport), without storing the report.
pub fn json(sweep: Sweep, model: &Model, mut out: Output, bar: &ProgressBar) -> Result<SweepEnd, Failure> {
    let heading = sweep.heading().clone();
    let rows = SerializedRows { sweep: Cell::new(Some(sweep)), end: RefCell::new(None), bar };
    let document = Document { heading, rows: &rows, diagnostics: Diagnostics { model, rows: &rows } };
    let written = document.serialize(&mut serde_json::Serializer::pretty(&mut out));
    let written = written.map_err(io::Error::from);
    match rows.end.take() {
        Some(Err(error)) => {
            out.discard();
            Err(error.into())
        }
        end => {
            written.map_err(|error| out.failure(error))?;
            out.finish()?;
            end.and_then(Result::ok)
                .ok_or_else(|| Failure::NoAnswer("the sweep was written without its rows".into()))
        }
    }
}

#[derive(serde::Serialize)]
struct Document<'a> {
    #[serde(flatten)]
    heading: SweepHeading,
    rows: &'a SerializedRows<'a>,
    diagnostics: Diagnostics<'a>,
}

/// Rows of the document; serialisation computes them, once.
struct SerializedRows<'a> {
    sweep: Cell<Option<Sweep<'a>>>,
    end: RefCell<Option<Result<SweepEnd, StudyError>>>,
    bar: &'a ProgressBar,
}

impl Serialize for SerializedRows<'_> {
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

/// Diagnostics of the file and of the rows; complete after the rows are written.
struct Diagnostics<'a> {
    model: &'a Model,
    rows: &'a SerializedRows<'a>,
}

impl Serialize for Diagnostics<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let end = self.rows.end.borrow();
        let of_rows = end.iter().flatten().flat_map(|end| &end.diagnostics);
        let all: Vec<&DiagnosticRecord> = self.model.diagnostics.iter().chain(of_rows).collect();
        all.serialize(serializer)
    }
}
