//! Limits of tables, with units and reasons: they bound time and memory for hostile files.

/// Longest record of a table, bytes: a thousand joints with 17 digits take 20 kB.
pub(crate) const MAX_RECORD_BYTES: usize = 1 << 20;

/// Limits of Parquet files.
#[cfg(feature = "parquet")]
pub(crate) mod parquet {
    /// Largest size of the file metadata of a Parquet file, bytes. The metadata of a robot's columns take some 100 kB; a
    /// thousand columns in a thousand row groups take some 100 MB, more than is used in practice.
    pub(crate) const MAX_METADATA_BYTES: u64 = 1 << 26;
    /// Largest number of entries of a list in the file metadata: columns, or row groups.
    pub(crate) const MAX_METADATA_LIST: u64 = 1 << 20;
    /// Deepest nesting of columns in a Parquet file: lists of records nest some ten deep.
    pub(crate) const MAX_COLUMN_DEPTH: usize = 64;
    /// Largest memory for the current pages of all columns of a Parquet file, bytes.
    pub(crate) const MAX_PAGE_MEMORY: u64 = 1 << 30;
    /// Smallest limit of the page size, bytes, for any number of columns: writers make pages of 1 MiB, or somewhat more.
    pub(crate) const MIN_PAGE_LIMIT: u64 = 1 << 22;
    /// Usual upper bound of a page header, bytes: twenty bytes and the statistics.
    pub(crate) const USUAL_PAGE_HEADER: u64 = 1 << 12;
    /// Longest page header, bytes: statistics may be long texts.
    pub(crate) const MAX_PAGE_HEADER: u64 = 1 << 20;
    /// Number of rows read from the pages of a Parquet file at once.
    pub(crate) const ROWS_PER_READ: usize = 1024;
}
