//! Table in Parquet (apache/parquet-format), read row by row in bounded memory: one page per column.

use crate::format_fault::FormatFault;
use crate::limits::parquet::{MAX_PAGE_MEMORY, MIN_PAGE_LIMIT, ROWS_PER_READ};
use crate::parquet_file::ParquetStorage;
use crate::parquet_source::{CheckedPages, ParquetSource, reader_error_text};
use parquet::basic::{Compression, ConvertedType, LogicalType, Type as Physical};
use parquet::column::reader::{ColumnReaderImpl, get_column_reader, get_typed_column_reader};
use parquet::data_type::{DataType, DoubleType, FloatType, Int32Type, Int64Type};
use parquet::file::metadata::ParquetMetaData;
use parquet::file::serialized_reader::SerializedPageReader;
use parquet::schema::types::{ColumnDescriptor, Type};
use std::sync::Arc;

/// Number type of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum NumberType {
    Double,
    Float,
    /// Integer of 32 bits.
    Int {
        signed: bool,
    },
    /// Integer of 64 bits.
    Long {
        signed: bool,
    },
}

impl NumberType {
    /// Size of a value, bytes.
    fn size(self) -> usize {
        match self {
            NumberType::Float | NumberType::Int { .. } => 4,
            NumberType::Double | NumberType::Long { .. } => 8,
        }
    }
}

/// Selected column.
struct SelectedColumn {
    /// Index among the columns of the table.
    number: usize,
    /// Index among the leaf columns; nested columns have several leaves.
    leaf: usize,
    kind: NumberType,
    /// Reader of the current row group; `None` before the first group.
    reader: Option<ColumnValueReader>,
    /// Values of the rows read last; `None` for a null.
    values: Vec<Option<f64>>,
}

/// Table and the current row.
pub struct ParquetTable {
    source: Arc<ParquetSource>,
    metadata: ParquetMetaData,
    names: Vec<String>,
    columns: Vec<SelectedColumn>,
    /// Index of the next row group.
    next_group: usize,
    /// Number of rows of the current group that are not in `values` yet.
    rows_left: usize,
    /// Index of the next row in `values`.
    next_value: usize,
    /// Number of rows in `values`.
    value_count: usize,
    /// Number of the last row, from 0.
    row: Option<usize>,
}

impl ParquetTable {
    /// Opens a table: reads the file metadata, and no rows.
    ///
    /// # Errors
    /// [`FormatFault`]: unreadable, malformed, or more rows than `max_rows`.
    pub fn open(storage: ParquetStorage, max_rows: usize) -> Result<Self, FormatFault> {
        let source = ParquetSource::new(storage).map_err(|error| FormatFault::from(&error))?;
        let metadata = catch_reader_panic(|| source.read_metadata())?;
        let names: Vec<String> =
            top_level_columns(&metadata).iter().map(|field| field.name().to_owned()).collect();
        let rows = metadata.row_groups().iter().map(|group| u128::try_from(group.num_rows()).unwrap_or(0));
        let rows: u128 = rows.sum();
        if rows > max_rows as u128 {
            return Err(FormatFault::Rows { rows, most: max_rows });
        }
        let source = Arc::new(source);
        Ok(Self {
            source,
            metadata,
            names,
            columns: Vec::new(),
            next_group: 0,
            rows_left: 0,
            next_value: 0,
            value_count: 0,
            row: None,
        })
    }

    /// Names of the columns.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// Selects the columns to read, by index. The columns must hold plain numbers.
    ///
    /// # Errors
    /// Index of a column, and its fault.
    pub fn select_columns(
        &mut self,
        numbers: impl Iterator<Item = usize>,
    ) -> Result<(), (usize, FormatFault)> {
        for number in numbers {
            let fault_of = |fault| (number, fault);
            let (leaf, kind) = catch_reader_panic(|| self.column_type(number)).map_err(fault_of)?;
            self.columns.push(SelectedColumn { number, leaf, kind, reader: None, values: Vec::new() });
        }
        let max_page_size = (MAX_PAGE_MEMORY / self.columns.len().max(1) as u64).max(MIN_PAGE_LIMIT);
        match Arc::get_mut(&mut self.source) {
            Some(source) => source.set_max_page_size(max_page_size),
            None => debug_assert!(false, "no column is read yet"),
        }
        Ok(())
    }

    /// Leaf index and number type of a column. Error: no plain numbers, a damaged description, or an unsupported compression.
    fn column_type(&self, number: usize) -> Result<(usize, NumberType), FormatFault> {
        let fault_of = |got: String| FormatFault::ColumnKind { got };
        let all = top_level_columns(&self.metadata);
        let leaf: usize = all[..number].iter().map(|field| leaf_count(field)).sum();
        if all[number].is_group() {
            return Err(fault_of("lists or records".into()));
        }
        let schema = self.metadata.file_metadata().schema_descr();
        let column = schema.column(leaf);
        if column.max_rep_level() > 0 || column.max_def_level() > 1 {
            return Err(fault_of("lists or records".into()));
        }
        let kind = number_type(&column).map_err(fault_of)?;
        for group in self.metadata.row_groups() {
            let Some(chunk) = group.columns().get(leaf) else {
                return Err(malformed("a group of rows lacks a column"));
            };
            let start = chunk.dictionary_page_offset().unwrap_or_else(|| chunk.data_page_offset());
            if start < 0 || chunk.compressed_size() < 0 {
                return Err(malformed("a column has a negative position or a negative size"));
            }
            match chunk.compression() {
                Compression::UNCOMPRESSED
                | Compression::SNAPPY
                | Compression::ZSTD(_)
                | Compression::LZ4
                | Compression::LZ4_RAW => {}
                other @ (Compression::GZIP(_) | Compression::BROTLI(_) | Compression::LZO) => {
                    let name = other.to_string();
                    let name = name.split('(').next().unwrap_or_default().to_lowercase();
                    return Err(FormatFault::Codec { name });
                }
            }
        }
        Ok((leaf, kind))
    }

    /// Advances to the next row. Returns false at the end.
    ///
    /// # Errors
    /// [`FormatFault`].
    pub fn next_row(&mut self) -> Result<bool, FormatFault> {
        if self.next_value == self.value_count && !self.read_rows()? {
            return Ok(false);
        }
        self.next_value += 1;
        self.row = Some(self.row.map_or(0, |row| row + 1));
        Ok(true)
    }

    /// Column index and number of each selected column in the current row; `None` for a null.
    pub fn numbers(&self) -> impl Iterator<Item = (usize, Option<f64>)> {
        self.columns.iter().map(|column| (column.number, column.values[self.next_value - 1]))
    }

    /// Number of the current row, from 0; `None` before the first row.
    pub fn row(&self) -> Option<usize> {
        self.row
    }

    /// Reads the next block of rows into the `values` of the columns. Returns false at the end.
    fn read_rows(&mut self) -> Result<bool, FormatFault> {
        while self.rows_left == 0 {
            if self.next_group == self.metadata.num_row_groups() {
                return Ok(false);
            }
            catch_reader_panic(|| self.begin_group())?;
        }
        let count = self.rows_left.min(ROWS_PER_READ);
        for column in &mut self.columns {
            column.values.clear();
            let Some(reader) = &mut column.reader else { continue };
            catch_reader_panic(|| reader.read(count, &mut column.values))?;
        }
        (self.next_value, self.value_count) = (0, count);
        self.rows_left -= count;
        Ok(true)
    }

    /// Opens the column readers of the next row group.
    fn begin_group(&mut self) -> Result<(), FormatFault> {
        let group = self.metadata.row_group(self.next_group);
        self.next_group += 1;
        self.rows_left = usize::try_from(group.num_rows())
            .map_err(|_| malformed("a group of rows has a negative number of them"))?;
        for column in &mut self.columns {
            let chunk = group.column(column.leaf);
            let source = Arc::clone(&self.source);
            let pages = SerializedPageReader::new(source, chunk, self.rows_left, None);
            let pages = pages.map_err(|error| malformed(reader_error_text(error)))?;
            let descriptor = chunk.column_descr_ptr();
            let has_levels = descriptor.max_def_level() > 0;
            let reader = get_column_reader(
                descriptor,
                Box::new(CheckedPages::new(pages, has_levels, column.kind.size())),
            );
            column.reader = Some(match column.kind {
                NumberType::Double => ColumnValueReader::Double(get_typed_column_reader(reader)),
                NumberType::Float => ColumnValueReader::Float(get_typed_column_reader(reader)),
                NumberType::Int { signed } => ColumnValueReader::Int(get_typed_column_reader(reader), signed),
                NumberType::Long { signed } => {
                    ColumnValueReader::Long(get_typed_column_reader(reader), signed)
                }
            });
        }
        Ok(())
    }
}

/// Fault of a damaged file.
fn malformed(why: impl Into<String>) -> FormatFault {
    FormatFault::Malformed { why: why.into() }
}

/// Top-level columns; a nested column counts once.
fn top_level_columns(metadata: &ParquetMetaData) -> &[Arc<Type>] {
    metadata.file_metadata().schema().get_fields()
}

/// Number of leaf columns of a top-level column.
fn leaf_count(field: &Type) -> usize {
    if field.is_group() { field.get_fields().iter().map(|part| leaf_count(part)).sum() } else { 1 }
}

/// Number type of a column, or the name of the type if the values are no plain numbers.
fn number_type(column: &ColumnDescriptor) -> Result<NumberType, String> {
    let signed = match (column.logical_type_ref(), column.converted_type()) {
        (Some(LogicalType::Integer(integer)), _) => integer.is_signed,
        (Some(LogicalType::Timestamp(_)), _) => return Err("times of day and date".into()),
        (Some(LogicalType::String), _) => return Err("text".into()),
        (Some(LogicalType::Float16), _) => return Err("numbers of 16 bits".into()),
        (Some(other), converted) => {
            return Err(match converted {
                ConvertedType::NONE => format!("{other:?}").to_lowercase(),
                converted => format!("{converted} values").to_lowercase(),
            });
        }
        (
            None,
            ConvertedType::UINT_8 | ConvertedType::UINT_16 | ConvertedType::UINT_32 | ConvertedType::UINT_64,
        ) => false,
        (
            None,
            ConvertedType::NONE
            | ConvertedType::INT_8
            | ConvertedType::INT_16
            | ConvertedType::INT_32
            | ConvertedType::INT_64,
        ) => true,
        (None, other) => return Err(format!("{other} values").to_lowercase()),
    };
    match column.physical_type() {
        Physical::DOUBLE => Ok(NumberType::Double),
        Physical::FLOAT => Ok(NumberType::Float),
        Physical::INT32 => Ok(NumberType::Int { signed }),
        Physical::INT64 => Ok(NumberType::Long { signed }),
        Physical::BOOLEAN => Err("true and false".into()),
        Physical::INT96 => Err("times of day and date".into()),
        Physical::BYTE_ARRAY | Physical::FIXED_LEN_BYTE_ARRAY => Err("bytes".into()),
    }
}

/// Reader of the values of a column in a row group.
enum ColumnValueReader {
    Double(ColumnReaderImpl<DoubleType>),
    Float(ColumnReaderImpl<FloatType>),
    Int(ColumnReaderImpl<Int32Type>, bool),
    Long(ColumnReaderImpl<Int64Type>, bool),
}

impl ColumnValueReader {
    /// Appends the next `count` values as numbers; nulls are `None`.
    fn read(&mut self, count: usize, values: &mut Vec<Option<f64>>) -> Result<(), FormatFault> {
        match self {
            ColumnValueReader::Double(column) => append_values(column, count, values, |x| x),
            ColumnValueReader::Float(column) => append_values(column, count, values, f64::from),
            ColumnValueReader::Int(column, true) => append_values(column, count, values, f64::from),
            ColumnValueReader::Int(column, false) => {
                append_values(column, count, values, |x| f64::from(x.cast_unsigned()))
            }
            // Rounded beyond 2⁵³, as a decimal text would be.
            ColumnValueReader::Long(column, true) => append_values(column, count, values, |x| x as f64),
            ColumnValueReader::Long(column, false) => {
                append_values(column, count, values, |x| x.cast_unsigned() as f64)
            }
        }
    }
}

/// Appends the next values of a column; nulls are `None`.
fn append_values<T: DataType>(
    column: &mut ColumnReaderImpl<T>,
    count: usize,
    values: &mut Vec<Option<f64>>,
    number: impl Fn(T::T) -> f64,
) -> Result<(), FormatFault> {
    let (mut read, mut levels) = (Vec::with_capacity(count), Vec::new());
    let (rows, ..) = column
        .read_records(count, Some(&mut levels), None, &mut read)
        .map_err(|error| malformed(reader_error_text(error)))?;
    if rows != count {
        return Err(malformed("a column ends before its rows do"));
    }
    let mut read = read.into_iter();
    if levels.is_empty() {
        values.extend(read.map(|x| Some(number(x))));
    } else {
        values.extend(levels.iter().map(|level| if *level > 0 { read.next().map(&number) } else { None }));
    }
    if values.len() == count {
        Ok(())
    } else {
        Err(malformed("a column has another number of values than rows"))
    }
}

/// Converts a panic of the reader into an error. The reader asserts properties of well-formed files; the checks
/// above do not cover all of them.
fn catch_reader_panic<T>(read: impl FnOnce() -> Result<T, FormatFault>) -> Result<T, FormatFault> {
    std::panic::catch_unwind(std::panic::AssertUnwindSafe(read))
        .unwrap_or_else(|_| Err(malformed("its pages contradict its description")))
}
