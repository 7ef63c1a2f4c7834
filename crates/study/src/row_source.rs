//! Source of the rows of a sweep.

use crate::vary::Vary;

/// Source of the rows of a sweep.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum RowSource {
    /// Every combination of the values of some ranges, the first the slowest.
    Grid(Vec<Vary>),
    /// The rows of a file, one path.
    File(PositionFile),
    /// Random positions within the limits of the joints; a row's numbers depend on the seed and its own number alone.
    Random {
        /// How many rows.
        count: usize,
        /// Other seeds give other positions.
        seed: u64,
    },
}

/// A file of positions: a header with the names of joints, `JOINT[0]`, `JOINT[1]`, … for one with several numbers, a unit
/// such as `[deg]` behind where it is not SI; then a row for each configuration.
#[derive(Clone, Debug, PartialEq)]
pub struct PositionFile {
    /// Its path, `-` for the standard input.
    pub path: String,
    /// Columns that are left out.
    pub ignore: Vec<String>,
    /// No more bytes are taken from the standard input, a pipe or a device.
    pub max_size: u64,
}

impl From<Vary> for RowSource {
    fn from(vary: Vary) -> Self {
        RowSource::Grid(vec![vary])
    }
}

impl From<&Vary> for RowSource {
    fn from(vary: &Vary) -> Self {
        vary.clone().into()
    }
}

impl From<&RowSource> for RowSource {
    fn from(source: &RowSource) -> Self {
        source.clone()
    }
}
