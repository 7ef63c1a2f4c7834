//! Limits of tables, with units and reasons: they bound time and memory for hostile files.

/// Longest record of a table, bytes: a thousand joints with 17 digits take 20 kB.
pub(crate) const LONGEST_RECORD: usize = 1 << 20;

/// Limits of Parquet files.
#[cfg(feature = "parquet")]
pub(crate) mod parquet {
    /// Largest description of the columns in a Parquet file, bytes. The columns of a robot take some 100 kB; a thousand columns
    /// in a thousand row groups take some 100 MB, more than is used in practice.
    pub(crate) const LARGEST_DESCRIPTION: u64 = 1 << 26;
    /// Largest number of entries of a list in this description: columns, or row groups.
    pub(crate) const LONGEST_METADATA_LIST: u64 = 1 << 20;
    /// Deepest nesting of columns in a Parquet file: lists of records nest some ten deep.
    pub(crate) const DEEPEST_COLUMN: usize = 64;
    /// Largest memory of the pages of a Parquet file, all columns together, bytes.
    pub(crate) const LARGEST_PAGE_MEMORY: u64 = 1 << 30;
    /// Page size, bytes, that is accepted for any number of columns: writers make pages of 1 MiB, or somewhat more.
    pub(crate) const ALWAYS_ACCEPTED_PAGE: u64 = 1 << 22;
    /// Usual upper bound of a page header, bytes: twenty bytes and the statistics.
    pub(crate) const USUAL_PAGE_HEADER: u64 = 1 << 12;
    /// Longest page header, bytes: statistics may be long texts.
    pub(crate) const LONGEST_PAGE_HEADER: u64 = 1 << 20;
    /// Number of rows read from the pages of a Parquet file at once.
    pub(crate) const PARQUET_ROWS: usize = 1024;
}
