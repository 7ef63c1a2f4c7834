//! Output files: text, CSV, XLSX, Parquet, HTML, pictures.

pub(crate) mod contents;
pub(crate) mod csv;
pub(crate) mod html;
#[cfg(not(feature = "tables"))]
mod no_tables;
pub(crate) mod output;
pub(crate) mod own_files;
#[cfg(feature = "tables")]
pub(crate) mod parquet_rows;
pub(crate) mod sweep_rows;
pub(crate) mod table_style;
#[cfg(feature = "tables")]
pub(crate) mod xlsx_rows;

#[cfg(not(feature = "tables"))]
pub(crate) use no_tables::{parquet_rows, xlsx_rows};
