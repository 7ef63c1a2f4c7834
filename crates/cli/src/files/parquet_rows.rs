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
    let status = 1 + heading.varied.len();
    let column = |at| match at {
        0 => Column::new(Values::Whole(Vec::new()), true),
        _ if at == status => Column::new(Values::Texts(Vec::new()), true),
        _ if at == status + SINGULAR_POSE_COLUMN => Column::new(Values::Logical(Vec::new()), false),
        _ => Column::new(Values::Numbers(Vec::new()), at < status),
    };
    let mut columns: Vec<Column> = (0..table.names().len()).map(column).collect();
    let group = (CELLS_OF_A_GROUP / columns.len()).clamp(*ROWS_OF_A_GROUP.start(), *ROWS_OF_A_GROUP.end());
    let mut writer = match new_writer(&table, &columns, &heading, out) {
        Ok(writer) => writer,
        Err(error) => return Err(io::Error::other(error).into()),
    };
    let mut written = Ok(());
    let end = sweep.run(&mut |row| {
        bar.inc(1);
        push_row(&mut columns, status, &table, &row);
        if columns[0].levels.len() == group {
            written = write_group(&mut columns, &mut writer);
        }
        if written.is_ok() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    })?;
    if written.is_ok() && !columns[0].levels.is_empty() {
        written = write_group(&mut columns, &mut writer);
    }
    written.map_err(|error| writer.inner().failure(io_cause(error)))?;
    // The footer with the schema is written last.
    writer.into_inner().map_err(|error| cannot_write(path, &io_cause(error)))?.finish()?;
    Ok(end)
}

/// Appends a row to the columns; `status`: index of the column of the status.
fn push_row(columns: &mut [Column], status: usize, table: &SweepTable, row: &SweepRow) {
    columns[0].push(&Cell::Number(row.row as f64));
    columns[1..].iter_mut().zip(row.varied.values()).for_each(|(column, x)| column.push_number(Some(*x)));
    columns[status].push(&Cell::Text(row.status.into()));
    columns[status + 1].push_number(row.effective_mass);
    columns[status + 2].push_number(row.closure_residual);
    columns[status + SINGULAR_POSE_COLUMN].push(&row.singular_pose.map_or(Cell::Empty, Cell::Logical));
    let further = [row.motion_ratio, row.estimate, row.estimate_error_percent].into_iter().chain(row.gap);
    let gradient = row.gradient.iter().flat_map(|gradient| gradient.numbers());
    let further = further.chain(gradient).chain(table.other_numbers(row));
    columns[status + 4..].iter_mut().zip(further).for_each(|(column, x)| column.push_number(x));
}

/// Writes a table of numbers and texts as Parquet, in one row group. A column that contains a text has the type string, every other column
/// the type double. Empty cells are nulls, and so are numbers in a column of strings.
pub fn write_table(path: &str, columns: &[String], rows: &[Vec<Cell>]) -> std::result::Result<(), Failure> {
    let out = Output::open(Some(path))?;
    let bytes = table_bytes(columns, rows, out).map_err(|error| cannot_write(path, &io_cause(error)))?;
    bytes.finish()
}

/// Writes the columns of a table.
fn table_bytes(names: &[String], rows: &[Vec<Cell>], out: Output) -> Result<Output> {
    let has_text = |at: usize| rows.iter().any(|row| matches!(row[at], Cell::Text(_)));
    let values = |at| if has_text(at) { Values::Texts(Vec::new()) } else { Values::Numbers(Vec::new()) };
    let mut columns: Vec<Column> = (0..names.len()).map(|at| Column::new(values(at), false)).collect();
    for row in rows {
        columns.iter_mut().zip(row).for_each(|(column, cell)| column.push(cell));
    }
    let properties = WriterProperties::builder()
        .set_created_by(CREATED_BY.to_owned())
        .set_compression(Compression::SNAPPY)
        .build();
    let mut writer = SerializedFileWriter::new(out, schema(names, &columns)?, Arc::new(properties))?;
    write_group(&mut columns, &mut writer)?;
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

/// Schema with the names of columns.
fn schema(names: &[String], columns: &[Column]) -> Result<Arc<Type>> {
    let field = |(name, column): (&String, &Column)| {
        let physical = match column.values {
            Values::Whole(_) => Physical::INT64,
            Values::Numbers(_) => Physical::DOUBLE,
            Values::Texts(_) => Physical::BYTE_ARRAY,
            Values::Logical(_) => Physical::BOOLEAN,
        };
        let repetition = if column.is_required { Repetition::REQUIRED } else { Repetition::OPTIONAL };
        let text = (physical == Physical::BYTE_ARRAY).then_some(LogicalType::String);
        let field = Type::primitive_type_builder(name, physical);
        field.with_repetition(repetition).with_logical_type(text).build().map(Arc::new)
    };
    let fields = names.iter().zip(columns).map(field).collect::<Result<Vec<_>>>()?;
    Type::group_type_builder("percuss").with_fields(fields).build().map(Arc::new)
}

/// Writer with the schema of the table; the heading is in the file metadata.
fn new_writer(
    table: &SweepTable,
    columns: &[Column],
    heading: &SweepHeading,
    out: Output,
) -> Result<SerializedFileWriter<Output>> {
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
    SerializedFileWriter::new(out, schema(table.names(), columns)?, Arc::new(properties))
}

/// Index of `singular_pose` among the fixed columns.
const SINGULAR_POSE_COLUMN: usize = 3;

/// Values of a column without nulls.
enum Values {
    Whole(Vec<i64>),
    Numbers(Vec<f64>),
    Texts(Vec<ByteArray>),
    Logical(Vec<bool>),
}

/// Buffered column: its values, and the definition level of each row, 0 for a null.
struct Column {
    values: Values,
    levels: Vec<i16>,
    /// True for a column without nulls.
    is_required: bool,
}

impl Column {
    fn new(values: Values, is_required: bool) -> Self {
        Self { values, levels: Vec::new(), is_required }
    }

    /// Appends a cell; a cell of another type is a null.
    fn push(&mut self, cell: &Cell) {
        match (&mut self.values, cell) {
            (Values::Whole(values), Cell::Number(x)) => values.push(*x as i64),
            (Values::Numbers(values), Cell::Number(x)) => values.push(*x),
            (Values::Texts(values), Cell::Text(text)) => values.push(ByteArray::from(text.as_ref())),
            (Values::Logical(values), Cell::Logical(value)) => values.push(*value),
            _ => return self.levels.push(0),
        }
        self.levels.push(1);
    }

    /// Appends a number to a column of numbers.
    fn push_number(&mut self, number: Option<f64>) {
        if let (Values::Numbers(values), Some(number)) = (&mut self.values, number) {
            values.push(number);
        }
        self.levels.push(number.is_some().into());
    }

    /// Writes the values as the next column of a row group, and removes them.
    fn write(&mut self, group: &mut SerializedRowGroupWriter<'_, Output>) -> Result<()> {
        let Some(mut column) = group.next_column()? else {
            return Err(ParquetError::General("a row has more columns than the table".into()));
        };
        let levels = Some(&self.levels[..]).filter(|_| !self.is_required);
        macro_rules! write_values {
            ($values:ident, $type:ty) => {{
                column.typed::<$type>().write_batch($values, levels, None)?;
                $values.clear();
            }};
        }
        match &mut self.values {
            Values::Whole(values) => write_values!(values, Int64Type),
            Values::Numbers(values) => write_values!(values, DoubleType),
            Values::Texts(values) => write_values!(values, ByteArrayType),
            Values::Logical(values) => write_values!(values, BoolType),
        }
        self.levels.clear();
        column.close()
    }
}

/// Writes the buffered columns as a row group, and removes their values.
fn write_group(columns: &mut [Column], writer: &mut SerializedFileWriter<Output>) -> Result<()> {
    let mut group = writer.next_row_group()?;
    columns.iter_mut().try_for_each(|column| column.write(&mut group))?;
    group.close().map(|_| ())
}
