//! Tables of positions in files (CSV, XLSX, Parquet).

pub(crate) mod columns;
pub(crate) mod csv_records;
pub(crate) mod parquet_bounds;
pub(crate) mod parquet_source;
pub(crate) mod parquet_table;
pub(crate) mod trajectory;
