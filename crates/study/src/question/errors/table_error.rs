//! Errors of a file of positions: place, cause, expected value and remedy.

use crate::question::names::{Names, flag};
use percuss_dynamics::{AssemblyError, ConfigurationError};
use percuss_mechanism::UnknownName;
use percuss_tables::FormatFault;
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
    /// Reason, with the received and the expected value.
    #[error("{0}")]
    Text(String),
    /// Column name that is not a joint name.
    #[error(transparent)]
    UnknownColumn(#[from] UnknownName),
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
    /// Missing columns.
    #[error("{} without a column: {}; their positions are undetermined", column_count_text(columns.len()), quoted(columns))]
    Missing {
        /// Names of the columns.
        columns: Vec<String>,
    },
    /// Column of a joint whose position the loops determine.
    #[error(transparent)]
    Dependent(Box<AssemblyError>),
}

/// Converts errors and texts to the text of a fault.
macro_rules! text_of {
    ($($error:ty)*) => {$(
        impl From<$error> for TableFault {
            fn from(error: $error) -> Self {
                TableFault::Text(error.to_string())
            }
        }
    )*};
}

text_of! { &str String FormatFault ConfigurationError }

/// Text for a number of columns.
fn column_count_text(columns: usize) -> String {
    if columns == 1 { "1 position is".into() } else { format!("{columns} positions are") }
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
        let given = |field: &'static str, value: &str| match names {
            Names::Flags => format!(" ({} {value})", flag(field)),
            Names::Keys(_) => format!(" ({field})"),
            Names::Fields => String::new(),
        };
        let name = self.column.as_ref().map_or("", |(_, name)| name.as_str());
        match &*self.fault {
            TableFault::UnknownColumn(_)
            | TableFault::Mimic { .. }
            | TableFault::Fixed { .. }
            | TableFault::Dependent(_) => {
                format!("; or leave the column out{}", given("sweep.ignore", &format!("\"{name}\"")))
            }
            TableFault::Missing { columns } => {
                let joint = columns.first().map_or("JOINT", |c| c.split('[').next().unwrap_or(c));
                format!("; add them, or set them{}", given("pose.set", &format!("{joint}=VALUE")))
            }
            TableFault::IsSet { .. } => given("pose.set", ""),
            _ => String::new(),
        }
    }
}
