//! Stand-in for the reader of Parquet files in a build without the feature `parquet`.

use crate::format_fault::FormatFault;
use crate::parquet_file::ParquetStorage;

/// Table in Parquet: no value of this type exists in this build.
#[derive(Debug)]
pub enum ParquetTable {}

impl ParquetTable {
    /// Refuses every file.
    ///
    /// # Errors
    /// [`FormatFault::NotBuiltIn`].
    pub fn open(_: ParquetStorage, _: usize) -> Result<Self, FormatFault> {
        Err(FormatFault::NotBuiltIn)
    }

    /// Never called.
    pub fn names(&self) -> &[String] {
        match *self {}
    }

    /// Never called.
    ///
    /// # Errors
    /// None.
    pub fn select_columns(&mut self, _: impl Iterator<Item = usize>) -> Result<(), (usize, FormatFault)> {
        match *self {}
    }

    /// Never called.
    ///
    /// # Errors
    /// None.
    pub fn next_row(&mut self) -> Result<bool, FormatFault> {
        match *self {}
    }

    /// Never called.
    pub fn numbers(&self) -> std::iter::Empty<(usize, Option<f64>)> {
        match *self {}
    }

    /// Never called.
    pub fn row(&self) -> Option<usize> {
        match *self {}
    }
}
