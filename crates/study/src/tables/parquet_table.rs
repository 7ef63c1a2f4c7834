//! Table in Parquet (apache/parquet-format), read row by row in bounded memory: one page per column.

use crate::question::table_error::{TableError, TableFault};
use crate::tables::parquet_source::{Pages, Source, Stored, words};
use crate::thresholds::{GRID_ROWS, PAGES, PARQUET_ROWS, SMALLEST_LARGEST_PAGE};
use parquet::basic::{Compression, ConvertedType, LogicalType, Type as Physical};
use parquet::column::reader::{ColumnReaderImpl, get_column_reader, get_typed_column_reader};
use parquet::data_type::{DataType, DoubleType, FloatType, Int32Type, Int64Type};
use parquet::file::metadata::ParquetMetaData;
use parquet::file::serialized_reader::SerializedPageReader;
use parquet::schema::types::{ColumnDescriptor, Type};
use std::sync::Arc;

/// Number type of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
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

impl Kind {
    /// Size of a value, bytes.
    fn width(self) -> usize {
        match self {
            Kind::Float | Kind::Int { .. } => 4,
            Kind::Double | Kind::Long { .. } => 8,
        }
    }
}

/// Selected column.
struct Column {
    /// Index among the columns of the table.
    number: usize,
    /// Index among the leaf columns; nested columns have several leaves.
    leaf: usize,
    kind: Kind,
    /// Reader of the current row group; `None` before the first group.
    reader: Option<Reader>,
    values: Vec<Option<f64>>,
}

/// Table and the current row.
pub(crate) struct ParquetTable {
    path: String,
    source: Arc<Source>,
    description: ParquetMetaData,
    names: Vec<String>,
    columns: Vec<Column>,
    /// Index of the next row group.
    group: usize,
    /// Number of rows of the current group that are not in `values` yet.
    left: usize,
    /// Index of the next row in `values`, and the number of rows in `values`.
    next: usize,
    held: usize,
    /// Number of the last row, from 0.
    row: Option<usize>,
}

impl ParquetTable {
    /// Reads the file metadata.
    pub fn open(stored: Stored, path: &str) -> Result<Self, TableError> {
        let refuse = |fault| TableError::of_file(path, fault);
        let source = Source::new(stored).map_err(|error| TableError::unreadable(path, &error))?;
        let description = guarded(|| source.description()).map_err(refuse)?;
        let names: Vec<String> = fields(&description).iter().map(|field| field.name().to_owned()).collect();
        let rows = description.row_groups().iter().map(|group| u128::try_from(group.num_rows()).unwrap_or(0));
        let rows: u128 = rows.sum();
        if rows > GRID_ROWS as u128 {
            return Err(refuse(TableFault::Rows { rows, most: GRID_ROWS }));
        }
        let source = Arc::new(source);
        let path = path.to_owned();
        Ok(Self {
            path,
            source,
            description,
            names,
            columns: Vec::new(),
            group: 0,
            left: 0,
            next: 0,
            held: 0,
            row: None,
        })
    }

    /// Names of the columns.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// Selects the columns to read, by index. The columns must hold plain numbers.
    pub fn choose(&mut self, numbers: impl Iterator<Item = usize>) -> Result<(), TableError> {
        for number in numbers {
            let refuse = |fault: TableFault| {
                TableError::of_file(&self.path, fault).in_column(number, &self.names[number])
            };
            let (leaf, kind) = guarded(|| self.kind(number)).map_err(refuse)?;
            self.columns.push(Column { number, leaf, kind, reader: None, values: Vec::new() });
        }
        let each = (PAGES / self.columns.len().max(1) as u64).max(SMALLEST_LARGEST_PAGE);
        match Arc::get_mut(&mut self.source) {
            Some(source) => source.limit_pages(each),
            None => debug_assert!(false, "no column is read yet"),
        }
        Ok(())
    }

    /// Leaf index and number type of a column.
    fn kind(&self, number: usize) -> Result<(usize, Kind), TableFault> {
        let refuse = |got: String| TableFault::ColumnKind { got };
        let all = fields(&self.description);
        let leaf: usize = all[..number].iter().map(|field| leaves(field)).sum();
        if all[number].is_group() {
            return Err(refuse("lists or records".into()));
        }
        let schema = self.description.file_metadata().schema_descr();
        let column = schema.column(leaf);
        if column.max_rep_level() > 0 || column.max_def_level() > 1 {
            return Err(refuse("lists or records".into()));
        }
        let kind = kind(&column).map_err(refuse)?;
        for group in self.description.row_groups() {
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
                    return Err(TableFault::Codec { name });
                }
            }
        }
        Ok((leaf, kind))
    }

    /// Advances to the next row. Returns false at the end.
    pub fn read(&mut self) -> Result<bool, TableError> {
        if self.next == self.held
            && !self.read_some().map_err(|fault| TableError::of_file(&self.path, fault))?
        {
            return Ok(false);
        }
        self.next += 1;
        self.row = Some(self.row.map_or(0, |row| row + 1));
        Ok(true)
    }

    /// Numbers of the current row with the column indices; `None` for a null.
    pub fn numbers(&self) -> impl Iterator<Item = (usize, Option<f64>)> {
        self.columns.iter().map(|column| (column.number, column.values[self.next - 1]))
    }

    /// Error at the current row.
    pub fn fault(&self, fault: TableFault) -> TableError {
        TableError { row: self.row, ..TableError::of_file(&self.path, fault) }
    }

    /// Reads the next rows into `values`. Returns false at the end.
    fn read_some(&mut self) -> Result<bool, TableFault> {
        while self.left == 0 {
            if self.group == self.description.num_row_groups() {
                return Ok(false);
            }
            guarded(|| self.begin_group())?;
        }
        let count = self.left.min(PARQUET_ROWS);
        for column in &mut self.columns {
            column.values.clear();
            let Some(reader) = &mut column.reader else { continue };
            guarded(|| reader.read(count, &mut column.values))?;
        }
        (self.next, self.held) = (0, count);
        self.left -= count;
        Ok(true)
    }

    fn begin_group(&mut self) -> Result<(), TableFault> {
        let group = self.description.row_group(self.group);
        self.group += 1;
        self.left = usize::try_from(group.num_rows())
            .map_err(|_| malformed("a group of rows has a negative number of them"))?;
        for column in &mut self.columns {
            let chunk = group.column(column.leaf);
            let source = Arc::clone(&self.source);
            let pages = SerializedPageReader::new(source, chunk, self.left, None);
            let pages = pages.map_err(|error| malformed(words(error)))?;
            let descriptor = chunk.column_descr_ptr();
            let has_levels = descriptor.max_def_level() > 0;
            let reader =
                get_column_reader(descriptor, Box::new(Pages::new(pages, has_levels, column.kind.width())));
            column.reader = Some(match column.kind {
                Kind::Double => Reader::Double(get_typed_column_reader(reader)),
                Kind::Float => Reader::Float(get_typed_column_reader(reader)),
                Kind::Int { signed } => Reader::Int(get_typed_column_reader(reader), signed),
                Kind::Long { signed } => Reader::Long(get_typed_column_reader(reader), signed),
            });
        }
        Ok(())
    }
}

fn malformed(why: impl Into<String>) -> TableFault {
    TableFault::Malformed { why: why.into() }
}

/// Top-level columns; a nested column counts once.
fn fields(description: &ParquetMetaData) -> &[Arc<Type>] {
    description.file_metadata().schema().get_fields()
}

/// Number of leaf columns of a column.
fn leaves(field: &Type) -> usize {
    if field.is_group() { field.get_fields().iter().map(|part| leaves(part)).sum() } else { 1 }
}

/// Number type of a column, or the name of the type if the values are no plain numbers.
fn kind(column: &ColumnDescriptor) -> Result<Kind, String> {
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
        Physical::DOUBLE => Ok(Kind::Double),
        Physical::FLOAT => Ok(Kind::Float),
        Physical::INT32 => Ok(Kind::Int { signed }),
        Physical::INT64 => Ok(Kind::Long { signed }),
        Physical::BOOLEAN => Err("true and false".into()),
        Physical::INT96 => Err("times of day and date".into()),
        Physical::BYTE_ARRAY | Physical::FIXED_LEN_BYTE_ARRAY => Err("bytes".into()),
    }
}

/// Reader of the values of a column in a row group.
enum Reader {
    Double(ColumnReaderImpl<DoubleType>),
    Float(ColumnReaderImpl<FloatType>),
    Int(ColumnReaderImpl<Int32Type>, bool),
    Long(ColumnReaderImpl<Int64Type>, bool),
}

impl Reader {
    /// Appends `count` values.
    fn read(&mut self, count: usize, values: &mut Vec<Option<f64>>) -> Result<(), TableFault> {
        match self {
            Reader::Double(column) => append(column, count, values, |x| x),
            Reader::Float(column) => append(column, count, values, f64::from),
            Reader::Int(column, true) => append(column, count, values, f64::from),
            Reader::Int(column, false) => append(column, count, values, |x| f64::from(x.cast_unsigned())),
            // Rounded beyond 2⁵³, as a decimal text would be.
            Reader::Long(column, true) => append(column, count, values, |x| x as f64),
            Reader::Long(column, false) => append(column, count, values, |x| x.cast_unsigned() as f64),
        }
    }
}

fn append<T: DataType>(
    column: &mut ColumnReaderImpl<T>,
    count: usize,
    values: &mut Vec<Option<f64>>,
    number: impl Fn(T::T) -> f64,
) -> Result<(), TableFault> {
    let (mut read, mut levels) = (Vec::with_capacity(count), Vec::new());
    let (rows, ..) = column
        .read_records(count, Some(&mut levels), None, &mut read)
        .map_err(|error| malformed(words(error)))?;
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
fn guarded<T>(read: impl FnOnce() -> Result<T, TableFault>) -> Result<T, TableFault> {
    std::panic::catch_unwind(std::panic::AssertUnwindSafe(read))
        .unwrap_or_else(|_| Err(malformed("its pages contradict its description")))
}
