//! A file of positions as the rows of a sweep. It is read twice: checked to its end before the first row is answered, and
//! then row by row.

use crate::answer::Prepared;
use crate::csv_records::Records;
use crate::model::Input;
use crate::row_source::PositionFile;
use crate::table_columns::Columns;
use crate::table_error::{TableError, TableFault};
use crate::thresholds::LARGEST_COORDINATE;
use percuss_dynamics::{AssemblyError, Configuration};
use percuss_mechanism::JointId;
use sha2::{Digest, Sha256};
use std::fmt;
use std::fs::File;
use std::io::{self, BufRead, BufReader, Cursor, Read};
use std::sync::Arc;

/// Text that is read row by row.
type Text = Box<dyn BufRead + Send + Sync>;

/// A file of positions, its columns resolved and its rows checked.
pub(crate) struct Trajectory {
    columns: Columns,
    positions: Positions,
    count: usize,
    pub input: Input,
    records: Records<Text>,
}

impl fmt::Debug for Trajectory {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Trajectory").field("input", &self.input).field("columns", &self.columns).finish()
    }
}

impl Trajectory {
    /// Reads a file to its end, and goes back to its first row.
    pub fn open(prepared: &Prepared, file: &PositionFile) -> Result<Self, TableError> {
        let bytes = Bytes::of(file)?;
        let name = bytes.name();
        let sha256 = bytes.sha256()?;
        let mut records = bytes.records()?;
        let columns = header(prepared, &mut records, file)?;
        let missing = columns.unset_outside_loops(prepared);
        if !missing.is_empty() {
            return Err(records.fault(TableFault::Missing { columns: missing }));
        }
        if columns.width == 0 {
            return Err(records.fault(TableFault::NoColumns));
        }
        let positions = Positions::new(prepared, &columns);
        let mut values = vec![0.0; columns.width];
        let mut count = 0;
        while read_row(&mut records, &columns, &positions, &mut values)? {
            if count == 0 {
                check_drivers(prepared, &columns, &positions, &values, name)?;
            }
            count += 1;
        }
        if count == 0 {
            return Err(TableError::of_file(name, TableFault::NoRows));
        }
        let mut records = bytes.records()?;
        header(prepared, &mut records, file)?;
        let input = Input { path: name.to_owned(), sha256 };
        Ok(Self { columns, positions, count, input, records })
    }

    /// The joints that its columns set.
    pub fn joints(&self) -> &[JointId] {
        &self.columns.joints
    }

    /// How many numbers a row has.
    pub fn width(&self) -> usize {
        self.columns.width
    }

    /// How many rows it has.
    pub fn count(&self) -> usize {
        self.count
    }

    /// The numbers of some rows after those that were read, one row after another; fewer at the end.
    pub fn read(&mut self, count: usize) -> Result<Vec<f64>, TableError> {
        let width = self.columns.width;
        let mut values = vec![0.0; count * width];
        for row in 0..count {
            let of_row = &mut values[row * width..][..width];
            if !read_row(&mut self.records, &self.columns, &self.positions, of_row)? {
                values.truncate(row * width);
                break;
            }
        }
        Ok(values)
    }
}

/// Reads the header.
fn header(
    prepared: &Prepared,
    records: &mut Records<Text>,
    file: &PositionFile,
) -> Result<Columns, TableError> {
    let path = records.path().to_owned();
    if !records.read()? {
        return Err(TableError::of_file(&path, TableFault::NoHeader));
    }
    Columns::new(prepared, &path, records.line, records.cells(), &file.ignore)
}

/// Reads the next row; false at the end.
fn read_row(
    records: &mut Records<Text>,
    columns: &Columns,
    positions: &Positions,
    values: &mut [f64],
) -> Result<bool, TableError> {
    if !records.read()? {
        return Ok(false);
    }
    columns.read(records.cells(), values, |fault| records.fault(fault))?;
    positions.check(values).map_err(|fault| records.fault(fault))?;
    Ok(true)
}

/// Whether the columns set all that drives the loops, and nothing that follows from them.
fn check_drivers(
    prepared: &Prepared,
    columns: &Columns,
    positions: &Positions,
    values: &[f64],
    path: &str,
) -> Result<(), TableError> {
    let mechanism = prepared.system.mechanism();
    let at_header = |fault: TableFault| TableError::at_line(path, 1, fault);
    let configuration = positions.set(values).map_err(at_header)?;
    match prepared.system.pose(&configuration) {
        Ok(pose) => {
            let drivers = pose.loops().map_or(&[][..], |loops| &loops.drivers);
            // A component of a ball is no number that could be set.
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
        // The rows say so themselves.
        Err(_) => Ok(()),
    }
}

/// What positions must be, beyond numbers.
#[derive(Debug)]
struct Positions {
    base: Configuration,
    /// The joints, their numbers, and whether those are bound to one another: a quaternion.
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

/// Where the bytes of a file are.
enum Bytes<'f> {
    Of(&'f str),
    /// The standard input, which is read once.
    Kept(Arc<[u8]>),
}

impl<'f> Bytes<'f> {
    fn of(file: &'f PositionFile) -> Result<Self, TableError> {
        if file.path != "-" {
            let csv = std::path::Path::new(&file.path).extension();
            if !csv.is_some_and(|ending| ending.eq_ignore_ascii_case("csv")) {
                return Err(TableError::of_file(&file.path, TableFault::Kind));
            }
            return Ok(Bytes::Of(&file.path));
        }
        let (mut bytes, limit) = (Vec::new(), file.max_size);
        let read = io::stdin().lock().take(limit.saturating_add(1)).read_to_end(&mut bytes);
        let kept = Bytes::Kept(bytes.into());
        read.map_err(|error| TableError::unreadable(kept.name(), &error))?;
        match &kept {
            Bytes::Kept(bytes) if bytes.len() as u64 > limit => {
                Err(TableError::of_file(kept.name(), TableFault::TooLarge { limit }))
            }
            _ => Ok(kept),
        }
    }

    fn name(&self) -> &'f str {
        match self {
            Bytes::Of(path) => path,
            Bytes::Kept(_) => "<stdin>",
        }
    }

    fn text(&self) -> Result<Text, TableError> {
        Ok(match self {
            Bytes::Of(path) => {
                let file = File::open(path).map_err(|error| TableError::unreadable(path, &error))?;
                Box::new(BufReader::with_capacity(1 << 16, file))
            }
            Bytes::Kept(bytes) => Box::new(Cursor::new(Arc::clone(bytes))),
        })
    }

    fn records(&self) -> Result<Records<Text>, TableError> {
        Ok(Records::new(self.text()?, self.name()))
    }

    fn sha256(&self) -> Result<String, TableError> {
        let mut hash = Sha256::new();
        io::copy(&mut self.text()?, &mut hash)
            .map_err(|error| TableError::unreadable(self.name(), &error))?;
        Ok(crate::model::hexadecimal(&hash.finalize()))
    }
}
