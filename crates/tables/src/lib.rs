#![doc = include_str!("../README.md")]

mod csv_records;
mod format_fault;
mod limits;
#[cfg(not(feature = "parquet"))]
mod no_parquet;
#[cfg(feature = "parquet")]
mod parquet_bounds;
mod parquet_file;
#[cfg(feature = "parquet")]
mod parquet_source;
#[cfg(feature = "parquet")]
mod parquet_table;

pub use csv_records::CsvRecords;
pub use format_fault::FormatFault;
#[cfg(not(feature = "parquet"))]
pub use no_parquet::ParquetTable;
pub use parquet_file::{ParquetStorage, begins_as_parquet, is_parquet_file};
#[cfg(feature = "parquet")]
pub use parquet_table::ParquetTable;
