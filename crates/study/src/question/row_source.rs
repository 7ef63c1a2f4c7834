//! Source of the rows of a sweep.

use crate::question::mass_question::MassQuestion;
use crate::question::travel::vary::{Varied, Vary};
use crate::values::value::path_in;
use std::path::Path;

/// Source of the rows of a sweep.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum RowSource {
    /// Every combination of the values of some ranges; the first range varies slowest.
    Grid(Vec<Vary>),
    /// Rows of a file, in order along one path.
    File(PositionFile),
    /// Random positions within the limits of the joints; they depend only on the seed and the row number.
    Random {
        /// Number of rows.
        count: usize,
        /// Seed of the random numbers.
        seed: u64,
    },
}

/// File of positions: a header with the names of joints, then a row for each configuration. A joint with several numbers has
/// the columns `JOINT[0]`, `JOINT[1]`, …; a unit other than SI follows the name, such as `[deg]`.
#[derive(Clone, Debug, PartialEq)]
pub struct PositionFile {
    /// Path of the file, `-` for the standard input. A file with the first bytes of a Parquet file is read as one, whatever its name.
    pub path: String,
    /// Names of ignored columns.
    pub ignore: Vec<String>,
    /// Largest number of bytes read from the standard input, a pipe or a device.
    pub max_size: u64,
}

impl RowSource {
    /// Source with the path of its file relative to a folder; a file read as a stream has at most `max_size` bytes.
    pub(crate) fn in_folder(mut self, folder: &Path, max_size: u64) -> Self {
        if let RowSource::File(file) = &mut self {
            file.max_size = max_size;
            if file.path != "-" {
                file.path = path_in(folder, &file.path);
            }
        }
        self
    }

    /// Question of the rows. Rows that vary a travel replace the travels of the pose; only a roll with a range of heave, or a heave with a
    /// range of roll, remains.
    pub fn question_of_rows(&self, question: &MassQuestion) -> MassQuestion {
        let varied = match self {
            RowSource::Grid(ranges) => ranges.iter().find_map(|vary| match &vary.quantity {
                Varied::Travel(moved) => Some(moved),
                Varied::Joint(_) => None,
            }),
            RowSource::File(_) | RowSource::Random { .. } => None,
        };
        let mut question = question.clone();
        if let Some(varied) = varied {
            question.pose.travel.retain(|travel| travel.moved.is_beside(varied));
        }
        question
    }
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
