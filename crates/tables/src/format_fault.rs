//! Faults of files that are read as tables.

use crate::limits::MAX_RECORD_BYTES;
use std::io;

/// Fault of a file, independent of the meaning of its columns.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FormatFault {
    /// Unreadable file.
    #[error("cannot be read: {why}")]
    Unreadable {
        /// Message of the operating system.
        why: String,
    },
    /// File is not UTF-8 text.
    #[error("not UTF-8 text; a table is comma-separated text")]
    NotText,
    /// Quote that is not closed.
    #[error("a quote is not closed")]
    OpenQuote,
    /// Line longer than the limit.
    #[error("the line is longer than {MAX_RECORD_BYTES} bytes")]
    TooLong,
    /// File is not a Parquet file, or is incomplete.
    #[error("it is not a complete Parquet file: it does not begin and end with PAR1")]
    NoParquet,
    /// Parquet file, in a build without their reader.
    #[error(
        "it is a Parquet file, and this build does not read Parquet; save the table as CSV, or build it with the feature \
         \"tables\" (`cargo build --release --features tables`)"
    )]
    NotBuiltIn,
    /// Encrypted Parquet file.
    #[error("it is encrypted; expected a Parquet file that is not")]
    Encrypted,
    /// Malformed Parquet file.
    #[error("it is no well-formed Parquet file: {why}")]
    Malformed {
        /// Cause.
        why: String,
    },
    /// Unsupported compression: codecs without a stated size in memory, or without practical use.
    #[error("it is compressed with {name}; expected no compression, Snappy, Zstandard or LZ4")]
    Codec {
        /// Name of the codec.
        name: String,
    },
    /// Parquet column without numbers.
    #[error("the column holds {got}; expected floating-point numbers or integers")]
    ColumnKind {
        /// Kind of the values.
        got: String,
    },
    /// Number of rows above the limit of a sweep.
    #[error("it has {rows} rows; expected {most} at most")]
    Rows {
        /// Stated number of rows.
        rows: u128,
        /// Largest number of rows.
        most: usize,
    },
}

impl From<&io::Error> for FormatFault {
    fn from(error: &io::Error) -> Self {
        Self::Unreadable { why: error.to_string() }
    }
}
