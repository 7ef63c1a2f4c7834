//! File of positions as rows of a sweep. The file is read twice: first completely, for checks before the first result, and
//! then row by row.

use crate::evaluation::prepared_question::PreparedQuestion;
use crate::model::loading::Input;
use crate::question::errors::table_error::{TableError, TableFault};
use crate::question::row_source::PositionFile;
use crate::tables::columns::{Columns, check_separator};
use crate::thresholds::{GRID_ROWS, LARGEST_COORDINATE};
use percuss_dynamics::{AssemblyError, Configuration};
use percuss_mechanism::JointId;
use percuss_tables::{CsvRecords, ParquetStorage, ParquetTable, begins_as_parquet, is_parquet_file};
use sha2::{Digest, Sha256};
use std::fmt;
use std::fs::File;
use std::io::{self, BufRead, BufReader, Cursor, Read};
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

/// Text read row by row.
type RowText = Box<dyn BufRead + Send + Sync>;

/// File of positions with resolved columns and checked rows.
pub(crate) struct Trajectory {
    columns: Columns,
    positions: PositionCheck,
    count: usize,
    pub input: Input,
    table: TableReader,
}

/// Reader of the rows of a file.
struct TableReader {
    /// Name of the file.
    path: String,
    rows: FileRows,
}

/// Rows in the format of the file.
enum FileRows {
    Csv(CsvRecords<RowText>),
    /// The mutex makes the reader shareable between threads; no thread waits for the lock.
    Parquet(Box<Mutex<ParquetTable>>),
}

impl fmt::Debug for Trajectory {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Trajectory").field("input", &self.input).field("columns", &self.columns).finish()
    }
}

impl Trajectory {
    /// Opens a file, checks all rows, and returns to the first row.
    pub fn open(prepared: &PreparedQuestion, file: &PositionFile) -> Result<Self, TableError> {
        let bytes = TableBytes::open(file)?;
        let name = bytes.name();
        let sha256 = bytes.sha256()?;
        let mut table = bytes.table()?;
        let columns = table.header(prepared, file)?;
        let missing = columns.unset_outside_loops(prepared);
        if !missing.is_empty() {
            return Err(table.row_error(TableFault::Missing { columns: missing }));
        }
        if columns.width == 0 {
            let why = "no column has the name of a joint; expected at least one";
            return Err(table.row_error(why.into()));
        }
        let positions = PositionCheck::new(prepared, &columns);
        let mut values = vec![0.0; columns.width];
        let mut count = 0;
        while table.read_row(&columns, &positions, &mut values)? {
            if count == 0 {
                check_drivers(prepared, &columns, &positions, &values, &table)?;
            }
            count += 1;
        }
        if count == 0 {
            let why = "it has a header and no rows; expected a row for each configuration";
            return Err(TableError::in_file(name, why));
        }
        let mut table = bytes.table()?;
        table.header(prepared, file)?;
        let input = Input { path: name.to_owned(), sha256 };
        Ok(Self { columns, positions, count, input, table })
    }

    /// Joints that the columns set.
    pub fn joints(&self) -> &[JointId] {
        &self.columns.joints
    }

    /// Number of numbers in a row.
    pub fn width(&self) -> usize {
        self.columns.width
    }

    /// Number of rows.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Reads the numbers of the next `count` rows, row by row; fewer at the end of the file.
    pub fn read(&mut self, count: usize) -> Result<Vec<f64>, TableError> {
        let width = self.columns.width;
        let mut values = vec![0.0; count * width];
        for row in 0..count {
            let of_row = &mut values[row * width..][..width];
            if !self.table.read_row(&self.columns, &self.positions, of_row)? {
                values.truncate(row * width);
                break;
            }
        }
        Ok(values)
    }
}

impl TableReader {
    /// Reads the names of the columns.
    fn header(&mut self, prepared: &PreparedQuestion, file: &PositionFile) -> Result<Columns, TableError> {
        let path = &self.path;
        match &mut self.rows {
            FileRows::Csv(records) => {
                let read = records.read();
                let at = |fault: TableFault| TableError::at_line(path, records.line, fault);
                if !read.map_err(|fault| at(fault.into()))? {
                    let why = "it is empty; expected a header with the names of joints, then a row for each configuration";
                    return Err(TableError::in_file(path, why));
                }
                let names: Vec<String> = records.cells().map(str::to_owned).collect();
                check_separator(&names).map_err(at)?;
                Columns::new(prepared, names, &file.ignore, at)
            }
            FileRows::Parquet(table) => {
                let table = locked_table(table);
                let names = table.names().to_vec();
                let at = |fault: TableFault| TableError::in_file(path, fault);
                let columns = Columns::new(prepared, names, &file.ignore, at)?;
                let selected = table.select_columns(columns.selected_columns());
                selected.map_err(|(column, fault)| {
                    TableError::in_file(path, fault).in_column(column, &table.names()[column])
                })?;
                Ok(columns)
            }
        }
    }

    /// Reads the next row; false at the end.
    fn read_row(
        &mut self,
        columns: &Columns,
        positions: &PositionCheck,
        values: &mut [f64],
    ) -> Result<bool, TableError> {
        let path = &self.path;
        match &mut self.rows {
            FileRows::Csv(records) => {
                let read = records.read();
                let at = |fault: TableFault| TableError::at_line(path, records.line, fault);
                if !read.map_err(|fault| at(fault.into()))? {
                    return Ok(false);
                }
                columns.parse_row(records.cells(), values, at)?;
                positions.check(values).map_err(at)?;
            }
            FileRows::Parquet(table) => {
                let table = locked_table(table);
                if !table.next_row().map_err(|fault| TableError::in_file(path, fault))? {
                    return Ok(false);
                }
                let at = |fault: TableFault| TableError::at_row(path, table.row(), fault);
                columns.store_row(table.numbers(), values, at)?;
                positions.check(values).map_err(at)?;
            }
        }
        Ok(true)
    }

    /// Error of the last row, or of the header before the first row.
    fn row_error(&mut self, fault: TableFault) -> TableError {
        match &mut self.rows {
            FileRows::Csv(records) => TableError::at_line(&self.path, records.line, fault),
            FileRows::Parquet(table) => TableError::at_row(&self.path, locked_table(table).row(), fault),
        }
    }

    /// Error of the column names.
    fn column_name_error(&self, fault: TableFault) -> TableError {
        match &self.rows {
            FileRows::Csv(_) => TableError::at_line(&self.path, 1, fault),
            FileRows::Parquet(_) => TableError::in_file(&self.path, fault),
        }
    }
}

/// Table behind a mutex, without locking.
fn locked_table(table: &mut Mutex<ParquetTable>) -> &mut ParquetTable {
    table.get_mut().unwrap_or_else(PoisonError::into_inner)
}

/// Checks that the columns set all driving joints of the loops, and no dependent joint.
fn check_drivers(
    prepared: &PreparedQuestion,
    columns: &Columns,
    positions: &PositionCheck,
    values: &[f64],
    table: &TableReader,
) -> Result<(), TableError> {
    let mechanism = prepared.system.mechanism();
    let at_header = |fault: TableFault| table.column_name_error(fault);
    let configuration = positions.configuration(values).map_err(at_header)?;
    match prepared.system.pose(&configuration) {
        Ok(pose) => {
            let drivers = pose.loops().map_or(&[][..], |loops| &loops.drivers);
            // The components of a spherical joint cannot be set separately.
            let single = |joint: &JointId| mechanism.joint(*joint).kind().positions() == 1;
            let missing = columns.unset(prepared, drivers.iter().copied().filter(single));
            if missing.is_empty() { Ok(()) } else { Err(at_header(TableFault::Missing { columns: missing })) }
        }
        Err(error @ AssemblyError::Dependent { .. }) => {
            let AssemblyError::Dependent { joint, .. } = &error else { return Ok(()) };
            let column = mechanism.find_joint(joint).ok().and_then(|id| columns.joint_column(id, mechanism));
            column.map_or(Ok(()), |(number, name)| {
                Err(at_header(TableFault::Dependent(Box::new(error.clone()))).in_column(number, name))
            })
        }
        // Other errors are reported by the rows.
        Err(_) => Ok(()),
    }
}

/// Check of the positions in a row against the joints, such as the norm of a quaternion.
#[derive(Debug)]
struct PositionCheck {
    base: Configuration,
    /// Joint name, range of its numbers, and true if the numbers are coupled, as in a quaternion.
    joints: Vec<(String, std::ops::Range<usize>, bool)>,
}

impl PositionCheck {
    /// Check of the joints that have columns in the table.
    fn new(prepared: &PreparedQuestion, columns: &Columns) -> Self {
        let mechanism = prepared.system.mechanism();
        let mut first = 0;
        let joint = |&joint: &JointId| {
            let found = mechanism.joint(joint);
            let numbers = first..first + found.kind().positions();
            first = numbers.end;
            (found.name().to_owned(), numbers, found.kind().positions() > found.kind().dofs())
        };
        let joints = columns.joints.iter().map(joint).collect();
        Self { base: prepared.configuration.clone(), joints }
    }

    /// Checks the quaternions and large coordinates of a row.
    fn check(&self, values: &[f64]) -> Result<(), TableFault> {
        for (name, numbers, is_quaternion) in &self.joints {
            let own = &values[numbers.clone()];
            if *is_quaternion || own.iter().any(|x| x.abs() > LARGEST_COORDINATE) {
                self.base.clone().set(name, own)?;
            }
        }
        Ok(())
    }

    /// Configuration of a row.
    fn configuration(&self, values: &[f64]) -> Result<Configuration, TableFault> {
        let mut configuration = self.base.clone();
        for (name, numbers, _) in &self.joints {
            configuration.set(name, &values[numbers.clone()])?;
        }
        Ok(configuration)
    }
}

/// True if a file name has this extension, in lower or upper case.
fn has_extension(path: &str, kind: &str) -> bool {
    Path::new(path).extension().is_some_and(|ending| ending.eq_ignore_ascii_case(kind))
}

/// Source of the bytes of a file.
enum TableBytes<'f> {
    Path(&'f str),
    /// Name and bytes of the standard input, a pipe or a device, which can be read only once.
    Memory(&'f str, Arc<[u8]>),
}

impl<'f> TableBytes<'f> {
    /// Opens a file by path, or reads a stream into memory. Error: an unknown kind of file, or too large.
    fn open(file: &'f PositionFile) -> Result<Self, TableError> {
        if file.path != "-" {
            let is_named = ["csv", "parquet"].iter().any(|kind| has_extension(&file.path, kind));
            if !is_named && !is_parquet_file(&file.path) {
                let why = "its name ends in neither .csv nor .parquet, and it does not begin as a Parquet file; expected a table of one of \
                           these kinds";
                return Err(TableError::in_file(&file.path, why));
            }
            // A regular file is read several times; a pipe or a device once, and only up to the limit.
            if std::fs::metadata(&file.path).map_or(true, |found| found.is_file()) {
                return Ok(TableBytes::Path(&file.path));
            }
        }
        let (mut bytes, limit) = (Vec::new(), file.max_size);
        let read = if file.path == "-" {
            io::stdin().lock().take(limit.saturating_add(1)).read_to_end(&mut bytes)
        } else {
            let opened =
                File::open(&file.path).map_err(|error| TableError::unreadable(&file.path, &error))?;
            opened.take(limit.saturating_add(1)).read_to_end(&mut bytes)
        };
        let name = if file.path == "-" { "<stdin>" } else { &file.path };
        let kept = TableBytes::Memory(name, bytes.into());
        read.map_err(|error| TableError::unreadable(kept.name(), &error))?;
        match &kept {
            TableBytes::Memory(_, bytes) if bytes.len() as u64 > limit => {
                let why = format!(
                    "larger than the limit of {limit} bytes; name a file instead of -, which is read row by row"
                );
                Err(TableError::in_file(kept.name(), why))
            }
            _ => Ok(kept),
        }
    }

    /// Name for messages.
    fn name(&self) -> &'f str {
        match self {
            TableBytes::Path(path) => path,
            TableBytes::Memory(name, _) => name,
        }
    }

    /// Reader of the bytes from the beginning.
    fn text(&self) -> Result<RowText, TableError> {
        Ok(match self {
            TableBytes::Path(path) => {
                let file = File::open(path).map_err(|error| TableError::unreadable(path, &error))?;
                Box::new(BufReader::with_capacity(1 << 16, file))
            }
            TableBytes::Memory(_, bytes) => Box::new(Cursor::new(Arc::clone(bytes))),
        })
    }

    /// Opens the table: Parquet for bytes that begin as Parquet and for a regular file with the extension `parquet`; otherwise
    /// CSV.
    fn table(&self) -> Result<TableReader, TableError> {
        let reader = |rows: FileRows| TableReader { path: self.name().to_owned(), rows };
        let stored = match self {
            TableBytes::Path(path) if has_extension(path, "parquet") || is_parquet_file(path) => {
                let file = File::open(path).map_err(|error| TableError::unreadable(path, &error))?;
                ParquetStorage::File(Mutex::new(file))
            }
            TableBytes::Memory(_, bytes) if begins_as_parquet(bytes) => {
                ParquetStorage::Memory(Arc::clone(bytes))
            }
            TableBytes::Path(_) | TableBytes::Memory(..) => {
                return Ok(reader(FileRows::Csv(CsvRecords::new(self.text()?))));
            }
        };
        let table = ParquetTable::open(stored, GRID_ROWS);
        let table = table.map_err(|fault| TableError::in_file(self.name(), fault))?;
        Ok(reader(FileRows::Parquet(Box::new(Mutex::new(table)))))
    }

    /// SHA-256 of all bytes.
    fn sha256(&self) -> Result<String, TableError> {
        let mut hash = Sha256::new();
        io::copy(&mut self.text()?, &mut hash)
            .map_err(|error| TableError::unreadable(self.name(), &error))?;
        Ok(crate::model::loading::hexadecimal(&hash.finalize()))
    }
}
