//! Suspension file in memory, for repeated imports with moved points.

use crate::thresholds::LARGEST_STUDY;
use percuss_formats::{LoadError, SharedFiles, Source};
use percuss_suspension::{ChangedFile, ImportOptions, Imported, Rack, ReadFile, changed_file};
use std::path::Path;
use std::sync::{Arc, OnceLock};

/// Sheet, table or JSON file of a suspension in memory, with import options.
#[derive(Clone, Debug)]
pub struct Sheet {
    source: Source,
    options: ImportOptions,
    /// The file as read by the first import.
    read: Arc<OnceLock<Result<ReadFile, LoadError>>>,
}

/// File name extensions of suspension files.
const SHEETS: [&str; 9] = ["toml", "csv", "xlsx", "xlsm", "json", "sub", "yaml", "yml", "pm"];

/// True if a file is a study: TOML with a table `model`.
pub(crate) fn is_study(source: &Source) -> bool {
    let text = std::str::from_utf8(&source.bytes).ok().filter(|text| text.len() as u64 <= LARGEST_STUDY);
    let table = text.and_then(|text| text.parse::<toml::Table>().ok());
    table.is_some_and(|table| table.get("model").is_some_and(toml::Value::is_table))
}

impl Sheet {
    /// True if the file name has an extension of a suspension file.
    pub(crate) fn is_sheet(source: &Source) -> bool {
        let ending = Path::new(&source.name).extension().and_then(|ending| ending.to_str());
        ending.is_some_and(|ending| SHEETS.iter().any(|known| ending.eq_ignore_ascii_case(known)))
    }

    /// Suspension file with import options.
    pub(crate) fn with_options(source: &Source, options: &ImportOptions) -> Self {
        Self { source: source.clone(), options: options.clone(), read: Arc::default() }
    }

    /// Store of the file and of the table that it names.
    pub(crate) fn files(&self) -> &SharedFiles {
        &self.source.files
    }

    /// True if the file is a study instead: TOML with a table `model`.
    pub(crate) fn is_study(&self) -> bool {
        is_study(&self.source)
    }

    /// File with the hardpoints, moved by `moves` (m, in the axes of the sheet).
    pub(crate) fn changed(&self, moves: &[(String, [f64; 3])]) -> Result<ChangedFile, String> {
        changed_file(&self.source, &self.options, moves)
    }

    /// Same sheet, imported with joints in place of massless rods, and with a massless rack that slides if it `steers`.
    pub(crate) fn as_movable(&self, steers: bool) -> Self {
        let mut sheet = Self::with_options(&self.source, &self.options);
        sheet.options.movable = true;
        if steers {
            sheet.options.rack = Some(Rack::Sliding { mass: 0.0 });
        }
        sheet
    }

    /// Imports the file with moved points; `moves`: name of the point and displacement, m, in the axes of the sheet.
    pub(crate) fn import(&self, moves: &[(String, [f64; 3])]) -> Result<Imported, LoadError> {
        let read = self.read.get_or_init(|| ReadFile::new(&self.source, &self.options));
        read.as_ref().map_err(Clone::clone)?.import(moves)
    }
}
