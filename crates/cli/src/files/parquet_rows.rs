//! Rows of a sweep in Parquet (apache/parquet-format): the columns of the CSV, in row groups.

use crate::files::csv::{Cell, FIXED_COLUMNS, SweepTable};
use crate::files::output::{Output, cannot_write};
use crate::files::own_files::CREATED_BY;
use crate::files::table_style::TableStyle;
use crate::terminal::failure::Failure;
use crate::terminal::limits::{CELLS_OF_A_GROUP, ROWS_OF_A_GROUP};
use indicatif::ProgressBar;
use parquet::basic::{Compression, LogicalType, Repetition, Type as Physical};
use parquet::data_type::{BoolType, ByteArray, ByteArrayType, DoubleType, Int64Type};
use parquet::errors::{ParquetError, Result};
use parquet::file::metadata::KeyValue;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::types::Type;
use percuss_study::{Model, Sweep, SweepEnd, SweepHeading, SweepRow};
use std::io;
use std::ops::ControlFlow;
use std::sync::Arc;

/// Writes rows as Parquet: columns of doubles and a text, with nulls for the empty cells of the CSV. Data common to
/// all rows are in the file metadata, under `percuss.heading`, as in the JSON.
pub fn write(
    sweep: Sweep,
    model: &Model,
    path: &str,
    bar: &ProgressBar,
) -> std::result::Result<SweepEnd, Failure> {
    let out = Output::open(Some(path))?;
    let heading = sweep.heading().clone();
    let table = SweepTable::new(&heading, &model.mechanism, TableStyle::default());
    let mut rows = RowBuffer::new(&table, heading.varied.len());
    let group =
        (CELLS_OF_A_GROUP / table.names().len()).clamp(*ROWS_OF_A_GROUP.start(), *ROWS_OF_A_GROUP.end());
    let mut writer = match new_writer(&table, &heading, out) {
        Ok(writer) => writer,
        Err(error) => return Err(io::Error::other(error).into()),
    };
    let mut written = Ok(());
    let end = sweep.run(&mut |row| {
        bar.inc(1);
        rows.push(&table, &row);
        if rows.numbers.len() == group {
            written = rows.write(&mut writer);
        }
        if written.is_ok() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    })?;
    if written.is_ok() && !rows.numbers.is_empty() {
        written = rows.write(&mut writer);
    }
    written.map_err(|error| writer.inner().failure(io_cause(error)))?;
    // The footer with the schema is written last.
    writer.into_inner().map_err(|error| cannot_write(path, &io_cause(error)))?.finish()?;
    Ok(end)
}

/// Writes a table of numbers and texts as Parquet, in one row group. A column that contains a text has the type string, every other column
/// the type double. Empty cells are nulls, and so are numbers in a column of strings.
pub fn write_table(path: &str, columns: &[String], rows: &[Vec<Cell>]) -> std::result::Result<(), Failure> {
    let out = Output::open(Some(path))?;
    let bytes = table_bytes(columns, rows, out).map_err(|error| cannot_write(path, &io_cause(error)))?;
    bytes.finish()
}

/// Writes the columns of a table.
fn table_bytes(columns: &[String], rows: &[Vec<Cell>], out: Output) -> Result<Output> {
    let has_text = |at: usize| rows.iter().any(|row| matches!(row[at], Cell::Text(_)));
    let field = |(at, name): (usize, &String)| {
        let physical = if has_text(at) { Physical::BYTE_ARRAY } else { Physical::DOUBLE };
        let text = has_text(at).then_some(LogicalType::String);
        let column = Type::primitive_type_builder(name, physical).with_repetition(Repetition::OPTIONAL);
        column.with_logical_type(text).build().map(Arc::new)
    };
    let fields = columns.iter().enumerate().map(field).collect::<Result<Vec<_>>>()?;
    let schema = Type::group_type_builder("percuss").with_fields(fields).build()?;
    let properties = WriterProperties::builder()
        .set_created_by(CREATED_BY.to_owned())
        .set_compression(Compression::SNAPPY)
        .build();
    let mut writer = SerializedFileWriter::new(out, Arc::new(schema), Arc::new(properties))?;
    let mut group = writer.next_row_group()?;
    for at in 0..columns.len() {
        if has_text(at) {
            let mut texts = Nullable::new();
            rows.iter().for_each(|row| match &row[at] {
                Cell::Text(text) => texts.push(Some(ByteArray::from(text.as_ref()))),
                _ => texts.push(None),
            });
            let (values, levels) = (&texts.values, Some(&texts.levels[..]));
            write_column(&mut group, |c| c.typed::<ByteArrayType>().write_batch(values, levels, None))?;
        } else {
            let mut numbers = Nullable::new();
            rows.iter().for_each(|row| match &row[at] {
                Cell::Number(number) => numbers.push(Some(*number)),
                _ => numbers.push(None),
            });
            let (values, levels) = (&numbers.values, Some(&numbers.levels[..]));
            write_column(&mut group, |c| c.typed::<DoubleType>().write_batch(values, levels, None))?;
        }
    }
    group.close()?;
    writer.into_inner()
}

/// Error of the operating system inside a Parquet error, if any.
fn io_cause(error: ParquetError) -> io::Error {
    match error {
        ParquetError::External(error) => match error.downcast::<io::Error>() {
            Ok(error) => *error,
            Err(other) => io::Error::other(other),
        },
        other => io::Error::other(other),
    }
}

/// Writer with the schema of the table; the heading is in the file metadata.
fn new_writer(
    table: &SweepTable,
    heading: &SweepHeading,
    out: Output,
) -> Result<SerializedFileWriter<Output>> {
    let status = 1 + heading.varied.len();
    let column = |(at, name): (usize, &String)| {
        let (physical, needed) = match at {
            0 => (Physical::INT64, true),
            _ if at < status => (Physical::DOUBLE, true),
            _ if at == status => (Physical::BYTE_ARRAY, true),
            _ if name == FIXED_COLUMNS[SINGULAR_POSE_COLUMN] && at == status + SINGULAR_POSE_COLUMN => {
                (Physical::BOOLEAN, false)
            }
            _ => (Physical::DOUBLE, false),
        };
        let repetition = if needed { Repetition::REQUIRED } else { Repetition::OPTIONAL };
        let text = (physical == Physical::BYTE_ARRAY).then_some(LogicalType::String);
        let column = Type::primitive_type_builder(name, physical);
        column.with_repetition(repetition).with_logical_type(text).build().map(Arc::new)
    };
    let columns = table.names().iter().enumerate().map(column).collect::<Result<Vec<_>>>()?;
    let schema = Type::group_type_builder("percuss").with_fields(columns).build()?;
    let heading = serde_json::to_string(heading).map_err(|error| ParquetError::External(error.into()))?;
    let properties = WriterProperties::builder()
        .set_created_by(CREATED_BY.to_owned())
        .set_key_value_metadata(Some(vec![KeyValue::new("percuss.heading".to_owned(), heading)]))
        .set_compression(Compression::SNAPPY)
        // Masses rarely repeat; only the status benefits from a dictionary.
        .set_dictionary_enabled(false)
        .set_column_dictionary_enabled(FIXED_COLUMNS[0].into(), true)
        .set_statistics_enabled(EnabledStatistics::Chunk)
        .build();
    SerializedFileWriter::new(out, Arc::new(schema), Arc::new(properties))
}

/// Index of `singular_pose` among the fixed columns.
const SINGULAR_POSE_COLUMN: usize = 3;

/// Column with nulls: the values that are not null, and the definition level of each row.
struct Nullable<T> {
    values: Vec<T>,
    levels: Vec<i16>,
}

impl<T> Nullable<T> {
    fn new() -> Self {
        Self { values: Vec::new(), levels: Vec::new() }
    }

    /// Appends a value or a null.
    fn push(&mut self, value: Option<T>) {
        self.levels.push(value.is_some().into());
        self.values.extend(value);
    }

    /// Removes all values.
    fn clear(&mut self) {
        self.values.clear();
        self.levels.clear();
    }
}

/// Buffered rows, by columns.
struct RowBuffer {
    numbers: Vec<i64>,
    varied: Vec<Vec<f64>>,
    status: Vec<&'static str>,
    singular: Nullable<bool>,
    /// Other columns in order: five of the result, the gap if the contact has one, the gradient if requested, then the joints.
    others: Vec<Nullable<f64>>,
}

impl RowBuffer {
    fn new(table: &SweepTable, varied: usize) -> Self {
        // The row number, the status and the singular pose have separate columns.
        let others = table.names().len() - varied - 3;
        Self {
            numbers: Vec::new(),
            varied: vec![Vec::new(); varied],
            status: Vec::new(),
            singular: Nullable::new(),
            others: (0..others).map(|_| Nullable::new()).collect(),
        }
    }

    /// Buffers a row.
    fn push(&mut self, table: &SweepTable, row: &SweepRow) {
        self.numbers.push(row.row.try_into().unwrap_or(i64::MAX));
        for (column, value) in self.varied.iter_mut().zip(row.varied.values()) {
            column.push(*value);
        }
        self.status.push(row.status);
        self.singular.push(row.singular_pose);
        let answer = [
            row.effective_mass,
            row.closure_residual,
            row.motion_ratio,
            row.estimate,
            row.estimate_error_percent,
        ];
        let gradient = row.gradient.iter().flat_map(|gradient| gradient.numbers());
        let numbers = answer.into_iter().chain(row.gap).chain(gradient).chain(table.other_numbers(row));
        for (column, value) in self.others.iter_mut().zip(numbers) {
            column.push(value);
        }
    }

    /// Writes the buffered rows as a row group and clears the buffer.
    fn write(&mut self, writer: &mut SerializedFileWriter<Output>) -> Result<()> {
        let mut group = writer.next_row_group()?;
        write_column(&mut group, |c| c.typed::<Int64Type>().write_batch(&self.numbers, None, None))?;
        for values in &self.varied {
            write_column(&mut group, |c| c.typed::<DoubleType>().write_batch(values, None, None))?;
        }
        let status: Vec<ByteArray> = self.status.iter().map(|status| ByteArray::from(*status)).collect();
        write_column(&mut group, |c| c.typed::<ByteArrayType>().write_batch(&status, None, None))?;
        let (before, after) = self.others.split_at(SINGULAR_POSE_COLUMN - 1);
        let double = |group: &mut _, numbers: &Nullable<f64>| {
            let (values, levels) = (&numbers.values, Some(&numbers.levels[..]));
            write_column(group, |c| c.typed::<DoubleType>().write_batch(values, levels, None))
        };
        before.iter().try_for_each(|numbers| double(&mut group, numbers))?;
        let (values, levels) = (&self.singular.values, Some(&self.singular.levels[..]));
        write_column(&mut group, |c| c.typed::<BoolType>().write_batch(values, levels, None))?;
        after.iter().try_for_each(|numbers| double(&mut group, numbers))?;
        group.close()?;
        self.numbers.clear();
        self.varied.iter_mut().for_each(Vec::clear);
        self.status.clear();
        self.singular.clear();
        self.others.iter_mut().for_each(Nullable::clear);
        Ok(())
    }
}

/// Writes the next column of a row group.
fn write_column(
    group: &mut SerializedRowGroupWriter<'_, Output>,
    write: impl FnOnce(&mut parquet::file::writer::SerializedColumnWriter<'_>) -> Result<usize>,
) -> Result<()> {
    let Some(mut column) = group.next_column()? else {
        return Err(ParquetError::General("a row has more columns than the table".into()));
    };
    write(&mut column)?;
    column.close()
}
