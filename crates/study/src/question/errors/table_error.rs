//! Errors of a file of positions: place, cause, expected value and remedy.

use crate::question::field::{Field, Names};
use percuss_dynamics::{AssemblyError, ConfigurationError};
use percuss_mechanism::UnknownName;
use percuss_tables::FormatFault;
use percuss_units::Dimension;
use std::io;

/// Error of a file of positions, with its place.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{}", self.message(Names::Fields))]
pub struct TableError {
    /// File, as named by the user.
    pub path: String,
    /// Line, from 1; `None` for an error of the whole file, and for files without lines.
    pub line: Option<usize>,
    /// Row, from 0, for files without lines.
    pub row: Option<usize>,
    /// Column number, from 1, and column name.
    pub column: Option<(usize, String)>,
    /// Cause.
    pub fault: Box<TableFault>,
}

/// Cause of an error of a file of positions.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TableFault {
    /// Unreadable or malformed file.
    #[error(transparent)]
    Format(#[from] FormatFault),
    /// Standard input larger than the limit.
    #[error("larger than the limit of {limit} bytes; name a file instead of -, which is read row by row")]
    TooLarge {
        /// Limit, bytes.
        limit: u64,
    },
    /// File without a header.
    #[error("it is empty; expected a header with the names of joints, then a row for each configuration")]
    NoHeader,
    /// All columns are ignored.
    #[error("no column has the name of a joint; expected at least one")]
    NoColumns,
    /// File without rows.
    #[error("it has a header and no rows; expected a row for each configuration")]
    NoRows,
    /// Cells with another separator than a comma.
    #[error("the header has no comma and {} \"{separator}\"; expected cells separated by commas", count)]
    Separator {
        /// Separator in the header.
        separator: char,
        /// Number of separators.
        count: usize,
    },
    /// Unknown kind of file.
    #[error(
        "its name ends in neither .csv nor .parquet, and it does not begin as a Parquet file; expected a table of one of these kinds"
    )]
    Kind,
    /// Null value in a Parquet file.
    #[error("the value is null; expected a number")]
    Null,
    /// Column name that is not a joint name.
    #[error(transparent)]
    UnknownColumn(#[from] UnknownName),
    /// A column without a name.
    #[error("it has no name; expected the name of a joint")]
    NoName,
    /// Wrong column names for a joint with several numbers.
    #[error("joint \"{joint}\" has {numbers} numbers; expected columns \"{joint}[0]\" to \"{joint}[{}]\"", numbers - 1)]
    Components {
        /// Joint.
        joint: String,
        /// Number of values of the joint.
        numbers: usize,
    },
    /// Fixed joint.
    #[error("joint \"{joint}\" is fixed, and has no position")]
    Fixed {
        /// Joint.
        joint: String,
    },
    /// Joint that mimics another joint.
    #[error("joint \"{joint}\" mimics \"{master}\", and its position follows from that joint")]
    Mimic {
        /// Joint.
        joint: String,
        /// Master joint.
        master: String,
    },
    /// Joint that the question sets as well.
    #[error("joint \"{joint}\" is already set; use only one of the two")]
    IsSet {
        /// Joint.
        joint: String,
    },
    /// Two columns for the same number.
    #[error("column {first} gives the same position")]
    Twice {
        /// First of the two columns, from 1.
        first: usize,
    },
    /// Unknown unit.
    #[error("\"{unit}\" is no unit of a position; expected {expected}, in {}", unit_names(*expected))]
    UnknownUnit {
        /// Given unit.
        unit: String,
        /// Dimension of the position.
        expected: Dimension,
    },
    /// Unit of another dimension.
    #[error("[{unit}] is the unit of {got}; expected {expected}")]
    WrongUnit {
        /// Given unit.
        unit: String,
        /// Dimension of the given unit.
        got: Dimension,
        /// Dimension of the position.
        expected: Dimension,
    },
    /// Missing columns.
    #[error("{} without a column: {}; their positions are undetermined", column_count_text(columns.len()), quoted(columns))]
    Missing {
        /// Names of the columns.
        columns: Vec<String>,
    },
    /// Column of a joint whose position the loops determine.
    #[error(transparent)]
    Dependent(Box<AssemblyError>),
    /// Row with another number of cells than the header.
    #[error("{got} cells; the header has {expected}")]
    Cells {
        /// Number of cells.
        got: usize,
        /// Expected number of cells.
        expected: usize,
    },
    /// An empty cell.
    #[error("the cell is empty; expected a number")]
    Empty,
    /// Cell without a number.
    #[error("\"{text}\" is no number; expected one such as 0.5 or -1e-3, its unit in the header")]
    NoNumber {
        /// Text of the cell.
        text: String,
    },
    /// NaN or infinite.
    #[error("\"{text}\" is not finite; expected a finite number")]
    NotFinite {
        /// Text of the cell.
        text: String,
    },
    /// Invalid position.
    #[error(transparent)]
    Position(#[from] ConfigurationError),
}

/// Text for a number of columns.
fn column_count_text(columns: usize) -> String {
    if columns == 1 { "1 position is".into() } else { format!("{columns} positions are") }
}

/// Names of the units of a dimension.
fn unit_names(dimension: Dimension) -> String {
    dimension.units().map(|unit| unit.name).collect::<Vec<_>>().join(", ")
}

/// First eight names and the number of further names.
fn quoted(names: &[String]) -> String {
    let some: Vec<String> = names.iter().take(8).map(|name| format!("\"{name}\"")).collect();
    let more = names.len() - some.len();
    if more > 0 { format!("{} and {more} more", some.join(", ")) } else { some.join(", ") }
}

impl TableError {
    /// Error of a whole file.
    pub(crate) fn in_file(path: &str, fault: impl Into<TableFault>) -> Self {
        Self { path: path.to_owned(), line: None, row: None, column: None, fault: Box::new(fault.into()) }
    }

    /// Error at a line of a file.
    pub(crate) fn at_line(path: &str, line: usize, fault: impl Into<TableFault>) -> Self {
        Self { line: Some(line), ..Self::in_file(path, fault) }
    }

    /// Error in a row, from 0, or in the header before the first row, of a file without lines.
    pub(crate) fn at_row(path: &str, row: Option<usize>, fault: impl Into<TableFault>) -> Self {
        Self { row, ..Self::in_file(path, fault) }
    }

    /// The same error in a column, given by number and name.
    pub(crate) fn in_column(self, number: usize, name: &str) -> Self {
        Self { column: Some((number + 1, name.to_owned())), ..self }
    }

    /// Error of reading a file.
    pub(crate) fn unreadable(path: &str, error: &io::Error) -> Self {
        Self::in_file(path, FormatFault::from(error))
    }

    /// Message with the names of `names`: flags, study keys or fields.
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

    /// Remedy for the end of the message, with the flag or key.
    fn remedy(&self, names: Names) -> String {
        let given = |field: Field, value: &str| match names {
            Names::Flags => format!(" ({} {value})", field.flag()),
            Names::Keys(_) => format!(" ({})", field.key()),
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
