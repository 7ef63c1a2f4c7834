//! Output files: text, CSV, XLSX, Parquet, HTML, pictures.

pub(crate) mod csv;
pub(crate) mod html;
pub(crate) mod output;
pub(crate) mod own_files;
pub(crate) mod parquet_rows;
pub(crate) mod picture;
pub(crate) mod sweep_rows;
pub(crate) mod table_style;
pub(crate) mod xlsx_rows;
