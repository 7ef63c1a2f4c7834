//! XLSX and Parquet in a build without the feature `tables`. [`check_writable`](super::output::check_writable) refuses these
//! files before.

use super::output::not_built;
use crate::terminal::failure::Failure;

pub(crate) mod parquet_rows {
    use super::*;
    use crate::files::csv::Cell;
    use indicatif::ProgressBar;
    use percuss_study::{Model, Sweep, SweepEnd};

    pub fn write(_: Sweep, _: &Model, path: &str, _: &ProgressBar) -> Result<SweepEnd, Failure> {
        Err(not_built(path, "Parquet", "tables"))
    }

    pub fn write_table(path: &str, _: &[String], _: &[Vec<Cell>]) -> Result<(), Failure> {
        Err(not_built(path, "Parquet", "tables"))
    }
}

pub(crate) mod xlsx_rows {
    use super::*;
    use crate::files::csv::Cell;
    use crate::files::table_style::TableStyle;
    use indicatif::ProgressBar;
    use percuss_study::{Model, Sweep, SweepEnd};

    pub fn write(
        _: Sweep,
        _: &Model,
        _: TableStyle,
        path: &str,
        _: &ProgressBar,
    ) -> Result<SweepEnd, Failure> {
        Err(not_built(path, "XLSX", "tables"))
    }

    pub fn workbook(path: &str, _: &str, _: &[String], _: Vec<Vec<Cell>>) -> Result<Vec<u8>, Failure> {
        Err(not_built(path, "XLSX", "tables"))
    }
}
