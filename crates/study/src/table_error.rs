//! What is wrong with a file of positions: where, what was expected, and the remedy.

use crate::field::{Field, Names};
use crate::quantity::Dimension;
use crate::thresholds::LONGEST_RECORD;
use percuss_dynamics::{AssemblyError, ConfigurationError};
use percuss_mechanism::UnknownName;
use std::io;

/// What is wrong with a file of positions, and where.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{}", self.message(Names::Fields))]
pub struct TableError {
    /// The file, as it was named.
    pub path: String,
    /// The line, from 1, where the file has lines; none where it is about the whole.
    pub line: Option<usize>,
    /// The row, from 0, where the file has no lines.
    pub row: Option<usize>,
    /// The column, from 1, and its name.
    pub column: Option<(usize, String)>,
    /// What is wrong.
    pub fault: Box<TableFault>,
}

/// What is wrong with a file of positions.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TableFault {
    /// It cannot be read.
    #[error("cannot be read: {why}")]
    Unreadable {
        /// What the operating system says.
        why: String,
    },
    /// More bytes on the standard input than are kept.
    #[error("larger than the limit of {limit} bytes; name a file instead of -, which is read row by row")]
    TooLarge {
        /// The limit.
        limit: u64,
    },
    /// It holds no header.
    #[error("it is empty; expected a header with the names of joints, then a row for each configuration")]
    NoHeader,
    /// All its columns are left out.
    #[error("no column is a joint's; expected one at least")]
    NoColumns,
    /// It holds no rows.
    #[error("it has a header and no rows; expected a row for each configuration")]
    NoRows,
    /// Not text.
    #[error("not UTF-8 text; a table is comma-separated text")]
    NotText,
    /// A quote without its end.
    #[error("a quote is not closed")]
    OpenQuote,
    /// A line that does not end.
    #[error("the line is longer than {LONGEST_RECORD} bytes")]
    TooLong,
    /// Separated by something else.
    #[error("the header has no comma and {} \"{separator}\"; expected cells separated by commas", count)]
    Separator {
        /// What separates.
        separator: char,
        /// How many there are.
        count: usize,
    },
    /// A kind of file that is not read.
    #[error("its name ends in neither .csv nor .parquet; expected a table of one of these kinds")]
    Kind,
    /// Not Parquet.
    #[error("it is no Parquet file, or not all of one: it does not begin and end with PAR1")]
    NoParquet,
    /// Parquet that needs a key.
    #[error("it is encrypted; expected a Parquet file that is not")]
    Encrypted,
    /// Parquet whose parts contradict one another.
    #[error("it is no well-formed Parquet file: {why}")]
    Malformed {
        /// What is wrong.
        why: String,
    },
    /// Compressed by means that are not built in: their sizes in memory are not stated, or nobody uses them.
    #[error("it is compressed with {name}; expected no compression, Snappy, Zstandard or LZ4")]
    Codec {
        /// Its name.
        name: String,
    },
    /// A column of Parquet that holds no numbers.
    #[error("the column holds {got}; expected floating-point numbers or integers")]
    ColumnKind {
        /// What it holds.
        got: String,
    },
    /// A value of Parquet that is not there.
    #[error("the value is null; expected a number")]
    Null,
    /// More rows than a sweep goes through.
    #[error("it has {rows} rows; expected {most} at most")]
    Rows {
        /// How many it states.
        rows: u128,
        /// How many there may be.
        most: usize,
    },
    /// A name that is no joint's.
    #[error(transparent)]
    UnknownColumn(#[from] UnknownName),
    /// A column without a name.
    #[error("it has no name; expected that of a joint")]
    NoName,
    /// A joint whose columns are named otherwise.
    #[error("joint \"{joint}\" has {numbers} numbers; expected columns \"{joint}[0]\" to \"{joint}[{}]\"", numbers - 1)]
    Components {
        /// The joint.
        joint: String,
        /// How many numbers it has.
        numbers: usize,
    },
    /// A joint that does not move.
    #[error("joint \"{joint}\" is fixed, and has no position")]
    Fixed {
        /// The joint.
        joint: String,
    },
    /// A joint that follows another.
    #[error("joint \"{joint}\" mimics \"{master}\", and its position follows from that")]
    Mimic {
        /// The joint.
        joint: String,
        /// What it follows.
        master: String,
    },
    /// A joint that the question sets too.
    #[error("joint \"{joint}\" is set already; give it one or the other")]
    IsSet {
        /// The joint.
        joint: String,
    },
    /// A number that has two columns.
    #[error("column {first} is of the same number")]
    Twice {
        /// The first of them, from 1.
        first: usize,
    },
    /// A unit that is not known.
    #[error("\"{unit}\" is no unit of a position; expected {expected}, in deg, rad, mm, cm or m")]
    UnknownUnit {
        /// What was given.
        unit: String,
        /// What is measured.
        expected: Dimension,
    },
    /// A unit of another dimension.
    #[error("[{unit}] is the unit of {got}; expected {expected}")]
    WrongUnit {
        /// What was given.
        unit: String,
        /// What it measures.
        got: Dimension,
        /// What is measured.
        expected: Dimension,
    },
    /// Columns that lack.
    #[error("{} of no column: {}; nothing else determines where they stand", plural(columns.len()), quoted(columns))]
    Missing {
        /// Their names.
        columns: Vec<String>,
    },
    /// A column of a joint that loops determine.
    #[error(transparent)]
    Dependent(Box<AssemblyError>),
    /// A row of another length than the header.
    #[error("{got} cells; the header has {expected}")]
    Cells {
        /// How many there are.
        got: usize,
        /// How many there should be.
        expected: usize,
    },
    /// An empty cell.
    #[error("the cell is empty; expected a number")]
    Empty,
    /// A cell that is no number.
    #[error("\"{text}\" is no number; expected one such as 0.5 or -1e-3, its unit in the header")]
    NoNumber {
        /// What it holds.
        text: String,
    },
    /// NaN or infinite.
    #[error("\"{text}\" is not finite; expected a finite number")]
    NotFinite {
        /// What it holds.
        text: String,
    },
    /// A position that is none.
    #[error(transparent)]
    Position(#[from] ConfigurationError),
}

fn plural(columns: usize) -> String {
    if columns == 1 { "1 position is".into() } else { format!("{columns} positions are") }
}

/// The first few of many names.
fn quoted(names: &[String]) -> String {
    let some: Vec<String> = names.iter().take(8).map(|name| format!("\"{name}\"")).collect();
    let more = names.len() - some.len();
    if more > 0 { format!("{} and {more} more", some.join(", ")) } else { some.join(", ") }
}

impl TableError {
    pub(crate) fn of_file(path: &str, fault: TableFault) -> Self {
        Self { path: path.to_owned(), line: None, row: None, column: None, fault: Box::new(fault) }
    }

    pub(crate) fn at_line(path: &str, line: usize, fault: TableFault) -> Self {
        Self { line: Some(line), ..Self::of_file(path, fault) }
    }

    pub(crate) fn in_column(self, number: usize, name: &str) -> Self {
        Self { column: Some((number + 1, name.to_owned())), ..self }
    }

    pub(crate) fn unreadable(path: &str, error: &io::Error) -> Self {
        Self::of_file(path, TableFault::Unreadable { why: error.to_string() })
    }

    /// The message, with the names of where the question was asked.
    pub(crate) fn message(&self, names: Names) -> String {
        let mut text = self.path.clone();
        if let Some(line) = self.line {
            text += &format!(":{line}");
        }
        text += ": ";
        if let Some(row) = self.row {
            text += &format!("row {row}: ");
        }
        match &self.column {
            Some((number, name)) if name.is_empty() => text += &format!("column {number}: "),
            Some((number, name)) => text += &format!("column {number} (\"{name}\"): "),
            None => {}
        }
        text + &self.fault.to_string() + &self.remedy(names)
    }

    /// What helps, by the name it has where the question was asked.
    fn remedy(&self, names: Names) -> String {
        let given = |field: Field, value: &str| match names {
            Names::Flags => format!(" ({} {value})", field.flag()),
            Names::Keys => format!(" ({})", field.key()),
            Names::Fields => String::new(),
        };
        let name = self.column.as_ref().map_or("", |(_, name)| name.as_str());
        match &*self.fault {
            TableFault::UnknownColumn(_)
            | TableFault::Mimic { .. }
            | TableFault::Fixed { .. }
            | TableFault::Dependent(_) => {
                format!("; or leave the column out{}", given(Field::Ignore, &format!("\"{name}\"")))
            }
            TableFault::Missing { columns } => {
                let joint = columns.first().map_or("JOINT", |c| c.split('[').next().unwrap_or(c));
                format!("; add them, or set them{}", given(Field::Set, &format!("{joint}=VALUE")))
            }
            TableFault::IsSet { .. } => given(Field::Set, ""),
            _ => String::new(),
        }
    }
}
