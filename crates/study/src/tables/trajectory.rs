//! File of positions as rows of a sweep. The file is read twice: first completely, for checks before the first result, and
//! then row by row.

use crate::evaluation::answer::Prepared;
use crate::model::loading::Input;
use crate::question::row_source::PositionFile;
use crate::question::table_error::{TableError, TableFault};
use crate::tables::columns::{Columns, separated_by_commas};
use crate::tables::csv_records::Records;
use crate::tables::parquet_source::{Stored, begins_as_parquet, is_parquet_file};
use crate::tables::parquet_table::ParquetTable;
use crate::thresholds::LARGEST_COORDINATE;
use percuss_dynamics::{AssemblyError, Configuration};
use percuss_mechanism::JointId;
use sha2::{Digest, Sha256};
use std::fmt;
use std::fs::File;
use std::io::{self, BufRead, BufReader, Cursor, Read};
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

/// Text read row by row.
type Text = Box<dyn BufRead + Send + Sync>;

/// File of positions with resolved columns and checked rows.
pub(crate) struct Trajectory {
    columns: Columns,
    positions: Positions,
    count: usize,
    pub input: Input,
    table: Table,
}

/// Reader of the rows of a file.
enum Table {
    Csv(Records<Text>),
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
    pub fn open(prepared: &Prepared, file: &PositionFile) -> Result<Self, TableError> {
        let bytes = Bytes::of(file)?;
        let name = bytes.name();
        let sha256 = bytes.sha256()?;
        let mut table = bytes.table()?;
        let columns = table.header(prepared, file)?;
        let missing = columns.unset_outside_loops(prepared);
        if !missing.is_empty() {
            return Err(table.fault(TableFault::Missing { columns: missing }));
        }
        if columns.width == 0 {
            return Err(table.fault(TableFault::NoColumns));
        }
        let positions = Positions::new(prepared, &columns);
        let mut values = vec![0.0; columns.width];
        let mut count = 0;
        while table.read_row(&columns, &positions, &mut values)? {
            if count == 0 {
                check_drivers(prepared, &columns, &positions, &values, &mut table)?;
            }
            count += 1;
        }
        if count == 0 {
            return Err(TableError::of_file(name, TableFault::NoRows));
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

impl Table {
    /// Reads the names of the columns.
    fn header(&mut self, prepared: &Prepared, file: &PositionFile) -> Result<Columns, TableError> {
        match self {
            Table::Csv(records) => {
                let path = records.path().to_owned();
                if !records.read()? {
                    return Err(TableError::of_file(&path, TableFault::NoHeader));
                }
                let names: Vec<String> = records.cells().map(str::to_owned).collect();
                separated_by_commas(&names).map_err(|fault| records.fault(fault))?;
                Columns::new(prepared, names, &file.ignore, |fault| records.fault(fault))
            }
            Table::Parquet(table) => {
                let table = unlocked(table);
                let names = table.names().to_vec();
                let columns = Columns::new(prepared, names, &file.ignore, |fault| table.fault(fault))?;
                table.choose(columns.chosen())?;
                Ok(columns)
            }
        }
    }

    /// Reads the next row; false at the end.
    fn read_row(
        &mut self,
        columns: &Columns,
        positions: &Positions,
        values: &mut [f64],
    ) -> Result<bool, TableError> {
        match self {
            Table::Csv(records) => {
                if !records.read()? {
                    return Ok(false);
                }
                columns.read(records.cells(), values, |fault| records.fault(fault))?;
                positions.check(values).map_err(|fault| records.fault(fault))?;
            }
            Table::Parquet(table) => {
                let table = unlocked(table);
                if !table.read()? {
                    return Ok(false);
                }
                columns.take(table.numbers(), values, |fault| table.fault(fault))?;
                positions.check(values).map_err(|fault| table.fault(fault))?;
            }
        }
        Ok(true)
    }

    /// Error of the last row, or of the header before the first row.
    fn fault(&mut self, fault: TableFault) -> TableError {
        match self {
            Table::Csv(records) => records.fault(fault),
            Table::Parquet(table) => unlocked(table).fault(fault),
        }
    }

    /// Error of the column names.
    fn fault_of_names(&mut self, fault: TableFault) -> TableError {
        match self {
            Table::Csv(records) => TableError::at_line(records.path(), 1, fault),
            Table::Parquet(table) => TableError { row: None, ..unlocked(table).fault(fault) },
        }
    }
}

fn unlocked(table: &mut Mutex<ParquetTable>) -> &mut ParquetTable {
    table.get_mut().unwrap_or_else(PoisonError::into_inner)
}

/// Checks that the columns set all driving joints of the loops, and no dependent joint.
fn check_drivers(
    prepared: &Prepared,
    columns: &Columns,
    positions: &Positions,
    values: &[f64],
    table: &mut Table,
) -> Result<(), TableError> {
    let mechanism = prepared.system.mechanism();
    let mut at_header = |fault: TableFault| table.fault_of_names(fault);
    let configuration = positions.set(values).map_err(&mut at_header)?;
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
            let column = mechanism.find_joint(joint).ok().and_then(|id| columns.of_joint(id, mechanism));
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
struct Positions {
    base: Configuration,
    /// Joint name, range of its numbers, and true if the numbers are coupled, as in a quaternion.
    joints: Vec<(String, std::ops::Range<usize>, bool)>,
}

impl Positions {
    fn new(prepared: &Prepared, columns: &Columns) -> Self {
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

    fn check(&self, values: &[f64]) -> Result<(), TableFault> {
        for (name, numbers, is_quaternion) in &self.joints {
            let own = &values[numbers.clone()];
            if *is_quaternion || own.iter().any(|x| x.abs() > LARGEST_COORDINATE) {
                self.base.clone().set(name, own)?;
            }
        }
        Ok(())
    }

    fn set(&self, values: &[f64]) -> Result<Configuration, TableFault> {
        let mut configuration = self.base.clone();
        for (name, numbers, _) in &self.joints {
            configuration.set(name, &values[numbers.clone()])?;
        }
        Ok(configuration)
    }
}

/// True if a file name has this extension, in lower or upper case.
fn ends_in(path: &str, kind: &str) -> bool {
    Path::new(path).extension().is_some_and(|ending| ending.eq_ignore_ascii_case(kind))
}

/// Source of the bytes of a file.
enum Bytes<'f> {
    Of(&'f str),
    /// Name and bytes of the standard input, a pipe or a device, which can be read only once.
    Kept(&'f str, Arc<[u8]>),
}

impl<'f> Bytes<'f> {
    fn of(file: &'f PositionFile) -> Result<Self, TableError> {
        if file.path != "-" {
            let is_named = ["csv", "parquet"].iter().any(|kind| ends_in(&file.path, kind));
            if !is_named && !is_parquet_file(&file.path) {
                return Err(TableError::of_file(&file.path, TableFault::Kind));
            }
            // A regular file is read several times; a pipe or a device once, and only up to the limit.
            if std::fs::metadata(&file.path).map_or(true, |found| found.is_file()) {
                return Ok(Bytes::Of(&file.path));
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
        let kept = Bytes::Kept(name, bytes.into());
        read.map_err(|error| TableError::unreadable(kept.name(), &error))?;
        match &kept {
            Bytes::Kept(_, bytes) if bytes.len() as u64 > limit => {
                Err(TableError::of_file(kept.name(), TableFault::TooLarge { limit }))
            }
            _ => Ok(kept),
        }
    }

    fn name(&self) -> &'f str {
        match self {
            Bytes::Of(path) => path,
            Bytes::Kept(name, _) => name,
        }
    }

    fn text(&self) -> Result<Text, TableError> {
        Ok(match self {
            Bytes::Of(path) => {
                let file = File::open(path).map_err(|error| TableError::unreadable(path, &error))?;
                Box::new(BufReader::with_capacity(1 << 16, file))
            }
            Bytes::Kept(_, bytes) => Box::new(Cursor::new(Arc::clone(bytes))),
        })
    }

    /// Opens the table: Parquet for bytes that begin as Parquet and for a regular file with the extension `parquet`; otherwise
    /// CSV.
    fn table(&self) -> Result<Table, TableError> {
        let stored = match self {
            Bytes::Of(path) if ends_in(path, "parquet") || is_parquet_file(path) => {
                let file = File::open(path).map_err(|error| TableError::unreadable(path, &error))?;
                Stored::File(Mutex::new(file))
            }
            Bytes::Kept(_, bytes) if begins_as_parquet(bytes) => Stored::Kept(Arc::clone(bytes)),
            Bytes::Of(_) | Bytes::Kept(..) => {
                return Ok(Table::Csv(Records::new(self.text()?, self.name())));
            }
        };
        Ok(Table::Parquet(Box::new(Mutex::new(ParquetTable::open(stored, self.name())?))))
    }

    fn sha256(&self) -> Result<String, TableError> {
        let mut hash = Sha256::new();
        io::copy(&mut self.text()?, &mut hash)
            .map_err(|error| TableError::unreadable(self.name(), &error))?;
        Ok(crate::model::loading::hexadecimal(&hash.finalize()))
    }
}
