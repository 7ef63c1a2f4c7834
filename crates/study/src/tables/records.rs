//! Measured impacts: tables with a column of times and columns of forces, accelerations, velocities or displacements.

use crate::checks::finding::Finding;
use crate::checks::finding_kind::FindingKind;
use crate::model::loading::{Input, hexadecimal};
use crate::model::record::DiagnosticRecord;
use crate::question::errors::table_error::TableError;
use crate::question::tables::identify::IdentifyQuestion;
use crate::values::text_layout::{ColumnKind, DecimalMark, no_unit, separator, unit};
use percuss_contact::identification::{Record, Signal};
use percuss_formats::reading::encoding::decode;
use percuss_tables::CsvRecords;
use percuss_units::{Dimension, Unit};
use schemars::JsonSchema;
use serde::Serialize;
use sha2::{Digest, Sha256};
use std::fs::File;
use std::io::Read;

/// Largest file, bytes, and most numbers of all files: they are read before the records are cut around the impacts.
const MOST_BYTES: u64 = 64 << 20;
pub(crate) const MOST_NUMBERS: usize = 10_000_000;
/// Rows above the first row of numbers among which the header is searched.
const MOST_HEADS: usize = 4;

/// Column of a record and what it is taken for.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct RecordColumn {
    /// Name in the file.
    pub column: String,
    /// `time`, `force`, `acceleration`, `velocity` or `displacement`.
    pub quantity: &'static str,
    /// Unit.
    pub unit: String,
}

/// Record of a file.
pub(crate) struct ReadRecord {
    pub record: Record,
    pub columns: Vec<RecordColumn>,
    pub input: Input,
    /// Findings about columns and lines.
    pub findings: Vec<DiagnosticRecord>,
}

/// Use of a column: the index of its signal, or the time if `None`, and the SI value of a number.
type Target = (Option<usize>, Box<dyn Fn(f64) -> f64>);

/// Rows of a text as lines of cells, without comments and empty lines.
struct Rows<'t> {
    records: CsvRecords<&'t [u8]>,
    is_blank_separated: bool,
}

impl<'t> Rows<'t> {
    fn new(text: &'t str, separator: char) -> Self {
        let records = CsvRecords::new(text.as_bytes()).separated_by(separator);
        Self { records, is_blank_separated: separator == ' ' }
    }

    /// Line and cells of the next row; `None` at the end.
    fn next(&mut self, path: &str) -> Result<Option<(usize, Vec<String>)>, TableError> {
        let read = self.records.read();
        let line = self.records.line;
        if !read.map_err(|fault| TableError::at_line(path, line, fault))? {
            return Ok(None);
        }
        let cells = self.records.cells().filter(|cell| !(self.is_blank_separated && cell.is_empty()));
        Ok(Some((line, cells.map(str::to_owned).collect())))
    }
}

/// True for a line that is a comment.
fn is_comment(cells: &[String]) -> bool {
    cells.first().is_some_and(|cell| cell.starts_with(['#', '%']))
}

/// True if most of the cells are numbers.
fn is_numbers(cells: &[String]) -> bool {
    let filled = cells.iter().filter(|cell| !cell.is_empty()).count();
    let is_number = |cell: &&String| cell.replacen(',', ".", 1).parse::<f64>().is_ok();
    2 * cells.iter().filter(is_number).count() > filled
}

/// Removes the last cell if it is empty: a separator at the end of the line.
fn without_last_empty(mut cells: Vec<String>) -> Vec<String> {
    if cells.len() > 1 && cells.last().is_some_and(|cell| cell.is_empty()) {
        cells.pop();
    }
    cells
}

/// True for a cell that is a unit of a quantity, or empty.
fn is_unit(cell: &str) -> bool {
    use Dimension::{Acceleration, Force, Length, Speed, Time};
    let is_none = cell.trim_matches(['[', ']', '(', ')', '-', ' ']).is_empty();
    is_none || [Time, Force, Acceleration, Speed, Length].into_iter().any(|one| unit(cell, one).is_some())
}

/// Header of a table.
struct Header {
    separator: char,
    /// Line of the header, from 1; 0 without one.
    line: usize,
    names: Vec<String>,
    /// Units of a second row.
    units: Option<Vec<String>>,
    /// First line of numbers.
    data: usize,
    /// Lines before it that are not read.
    passed: Vec<usize>,
}

/// Finds the first row of numbers and the header above it.
fn header(path: &str, text: &str) -> Result<Header, TableError> {
    let lines: Vec<(usize, &str)> =
        (1..).zip(text.lines()).filter(|(_, line)| !line.trim().is_empty()).take(1000).collect();
    let cells = |line: &str, separator: char| -> Vec<String> {
        let mut rows = Rows::new(line, separator);
        rows.next(path).ok().flatten().map_or_else(Vec::new, |(_, cells)| without_last_empty(cells))
    };
    let is_data = |at: usize| {
        let own = separator(lines[at].1);
        let first = cells(lines[at].1, own);
        let next = lines.get(at + 1).map(|(_, line)| cells(line, own));
        let agrees = next.is_none_or(|next| next.len() == first.len() && is_numbers(&next));
        !is_comment(&first) && is_numbers(&first) && agrees
    };
    let Some(data) = (0..lines.len()).find(|at| is_data(*at)) else {
        let why = "no rows of numbers are found; expected a header such as time [ms], force [kN] and a row for each sample";
        return Err(TableError::in_file(path, why));
    };
    let separator = separator(lines[data].1);
    let width = cells(lines[data].1, separator).len();
    let heads = (0..data).rev().map(|at| {
        let text = lines[at].1.trim_start_matches(['#', '%', ' ']);
        (lines[at].0, cells(text, separator))
    });
    let heads: Vec<(usize, Vec<String>)> =
        heads.filter(|(_, cells)| cells.len() == width).take(MOST_HEADS).collect();
    let understood = |cells: &[String]| cells.iter().filter(|cell| ColumnKind::of_head(cell).is_ok()).count();
    let units_at =
        heads.first().filter(|(_, cells)| cells.iter().all(|cell| is_unit(cell)) && heads.len() > 1);
    let named = heads.iter().skip(usize::from(units_at.is_some()));
    // The nearest row of the best ones.
    let best = named.rev().max_by_key(|(_, cells)| understood(cells));
    let (line, names) = best.cloned().unwrap_or_default();
    let units = units_at.map(|(_, cells)| cells.clone());
    let used = [Some(line), units_at.map(|(line, _)| *line)];
    // A row below the header with a number is a row of the table, which is refused if it is not readable.
    let begins_with_digit = |cell: &String| cell.starts_with(|c: char| c.is_ascii_digit());
    let is_row = |at: &usize| {
        let cells = cells(lines[*at].1, separator);
        line > 0
            && used.iter().flatten().all(|used| lines[*at].0 > *used)
            && cells.len() == width
            && !is_comment(&cells)
            && cells.iter().any(begins_with_digit)
    };
    let data = (0..data).find(is_row).unwrap_or(data);
    let passed = lines[..data].iter().map(|(line, _)| *line).filter(|line| !used.contains(&Some(*line)));
    Ok(Header { separator, line, names, units, data: lines[data].0, passed: passed.collect() })
}

/// Kind and unit of a column, with the unit of a second row.
fn meaning(name: &str, second: Option<&String>) -> Result<(ColumnKind, Option<&'static Unit>), String> {
    let (kind, unit_of_name) = ColumnKind::of_head(name)?;
    let of_row = second.zip(kind.dimension()).filter(|(text, _)| !text.is_empty());
    let of_row =
        of_row.map(|(text, dimension)| unit(text, dimension).ok_or_else(|| no_unit(text, dimension)));
    match (unit_of_name, of_row.transpose()?) {
        (Some(one), Some(other)) if one != other => Err(format!(
            "the unit {} of the name and the unit {} below it; expected one",
            one.name, other.name
        )),
        (one, other) => Ok((kind, one.or(other))),
    }
}

/// Reads a record.
pub(crate) fn read_record(path: &str, asked: &IdentifyQuestion) -> Result<ReadRecord, TableError> {
    let unreadable = |error| TableError::unreadable(path, &error);
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(unreadable)?;
    // A pipe has no size.
    file.take(MOST_BYTES + 1).read_to_end(&mut bytes).map_err(unreadable)?;
    let refuse = |why: String| Err(TableError::in_file(path, why));
    if bytes.len() as u64 > MOST_BYTES {
        return refuse(format!("more than {MOST_BYTES} bytes; cut the file around the impact"));
    }
    if bytes.is_empty() {
        return refuse("it is empty; expected a header such as time [ms], force [kN]".into());
    }
    if bytes.contains(&0) {
        return refuse("it is no text in UTF-8 or Windows-1252; save the table as CSV".into());
    }
    let decoded = decode(&bytes);
    let text = &*decoded.text;
    let Header { separator, line, mut names, units, data, passed } = header(path, text)?;
    let mut notes: Vec<String> = decoded.note.into_iter().collect();
    if !asked.columns.is_empty() {
        names = asked.columns.clone();
    }
    let head = if line == 0 { data } else { line };
    let at_head = |fault: String| TableError::at_line(path, head, fault);
    if names.is_empty() {
        let why = "no header names the columns; give their names, such as --columns \"time [ms],force [kN],-\" (- for a column that is not used)";
        return Err(at_head(why.into()));
    }
    if let Some(unknown) = asked.ignore.iter().find(|name| !names.contains(name)) {
        return Err(at_head(format!(
            "it has no column \"{unknown}\" to ignore; its columns are {}",
            names.join(", ")
        )));
    }
    let mut record = Record::default();
    let (mut columns, mut targets): (Vec<RecordColumn>, Vec<Option<Target>>) = (Vec::new(), Vec::new());
    let (mut assumed, mut left_out, mut counter) = (Vec::new(), Vec::new(), None);
    for (number, name) in names.iter().enumerate() {
        let refuse = |why: String| at_head(why).in_column(number, name);
        if asked.ignore.contains(name) || name == "-" {
            targets.push(None);
            continue;
        }
        let remedy =
            format!("; or leave the column out by --ignore \"{name}\", or name all columns by --columns");
        let found = meaning(name, units.as_ref().and_then(|units| units.get(number)));
        let (kind, unit) = found.map_err(|why| refuse(why + &remedy))?;
        let (Some(dimension), word) =
            (kind.dimension(), kind.measured().map_or("time", |quantity| quantity.name_and_unit().0))
        else {
            if kind == ColumnKind::Counter && counter.is_none() {
                counter = Some(number);
            }
            left_out.push(name.clone());
            targets.push(None);
            continue;
        };
        if let Some(other) = columns.iter().find(|column| column.quantity == word) {
            let why = format!(
                "a second column of {word}, beside \"{}\"; leave one out by --ignore \"{name}\"",
                other.column
            );
            return Err(refuse(why));
        }
        if unit.is_none() {
            assumed.push(name.clone());
        }
        // Every dimension of the table has units.
        let unit = unit.or(dimension.default_unit()).ok_or_else(|| refuse("it has no unit".into()))?;
        columns.push(RecordColumn { column: name.clone(), quantity: word, unit: unit.name.to_owned() });
        targets.push(Some((
            kind.measured().map(|_| record.signals.len()),
            Box::new(|number| unit.to_si(number)),
        )));
        record.signals.extend(kind.measured().map(|quantity| Signal { quantity, values: Vec::new() }));
    }
    let has_time = columns.iter().any(|column| column.quantity == "time");
    match asked.rate.map(|rate| rate.0) {
        Some(_) if has_time => {
            return Err(at_head("a column of the time is there, and --rate is given; remove it, or leave the column out by --ignore".into()));
        }
        Some(rate) => {
            let column = counter.map_or_else(|| "row number".to_owned(), |at| names[at].clone());
            columns.push(RecordColumn { column, quantity: "time", unit: format!("samples at {rate} Hz") });
            if let Some(at) = counter {
                left_out.retain(|name| *name != names[at]);
                targets[at] = Some((None, Box::new(move |number| number / rate)));
            }
        }
        None if !has_time => {
            return Err(at_head("a column of the time is missing; give the sampling rate by --rate HZ, or name the columns by --columns".into()));
        }
        None => {}
    }
    if record.signals.is_empty() {
        return Err(at_head(
            "a column of a force, an acceleration, a velocity or a displacement is missing".into(),
        ));
    }
    let rate = asked.rate.filter(|_| counter.is_none()).map(|rate| rate.0);
    let mut rows = Rows::new(text, separator);
    let mut mark = DecimalMark::default();
    let mut comments = 0;
    while let Some((line, cells)) = rows.next(path)? {
        if line < data {
            continue;
        }
        if is_comment(&cells) {
            comments += 1;
            continue;
        }
        let at = |fault: String| TableError::at_line(path, line, fault);
        if cells.len() != names.len() && without_last_empty(cells.clone()).len() != names.len() {
            return Err(at(format!("{} cells; the header has {}", cells.len(), names.len())));
        }
        if (record.times.len() + 1) * (1 + record.signals.len()) > MOST_NUMBERS {
            return Err(at(format!("more than {MOST_NUMBERS} numbers; cut the file around the impact")));
        }
        if let Some(rate) = rate {
            record.times.push(record.times.len() as f64 / rate);
        }
        for (number, (text, target)) in cells.iter().zip(&targets).enumerate() {
            let Some((signal, to_si)) = target else { continue };
            let in_column = |fault: String| at(fault).in_column(number, &names[number]);
            let value = mark.with_point(text).map_err(in_column)?.parse::<f64>().ok();
            let value = value
                .filter(|value| value.is_finite())
                .ok_or_else(|| in_column(format!("\"{text}\" is no finite number")))?;
            match signal {
                Some(signal) => record.signals[*signal].values.push(to_si(value)),
                None => record.times.push(to_si(value)),
            }
        }
    }
    if comments > 0 {
        notes.push(format!("comments that are not used: {comments}"));
    }
    if !left_out.is_empty() {
        notes.push(format!("columns that are not used: {}", left_out.join(", ")));
    }
    if !passed.is_empty() {
        let numbers: Vec<String> = passed.iter().map(usize::to_string).collect();
        notes.push(format!("lines that are not used: {}", numbers.join(", ")));
    }
    let note =
        |text: String| Finding::about_result(FindingKind::PartsNotUsed, format!("{path}: {text}")).into();
    let mut findings: Vec<DiagnosticRecord> = notes.into_iter().map(note).collect();
    if !assumed.is_empty() {
        let units = assumed.iter().filter_map(|name| columns.iter().find(|column| column.column == *name));
        let units: Vec<String> =
            units.map(|column| format!("{} in {}", column.column, column.unit)).collect();
        let message = format!(
            "{path}: no unit is given for {}; these units are assumed: name them in the header or by --columns",
            units.join(", ")
        );
        findings.push(Finding::about_result(FindingKind::UnitsAssumed, message).into());
    }
    let input = Input { path: path.to_owned(), sha256: hexadecimal(&Sha256::digest(&bytes)) };
    Ok(ReadRecord { record, columns, input, findings })
}
