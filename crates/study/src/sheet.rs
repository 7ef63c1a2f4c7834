//! A suspension's file in memory, to be imported again with points moved.

use percuss_formats::suspension::{ImportOptions, Imported, import};
use percuss_formats::{LoadError, Source};
use percuss_mechanism::Accept;
use std::path::Path;

/// A suspension's sheet, table or JSON in memory, and how it is imported.
#[derive(Clone, Debug)]
pub struct Sheet {
    source: Source,
    options: ImportOptions,
}

/// Endings of the files that are imported as suspensions.
const SHEETS: [&str; 4] = ["toml", "csv", "xlsx", "json"];

impl Sheet {
    /// A source as a sheet, where the ending of its name says that it is one.
    pub(crate) fn of(source: &Source, accept: Accept) -> Option<Self> {
        let ending = Path::new(&source.name).extension()?.to_str()?;
        let is_sheet = SHEETS.iter().any(|known| ending.eq_ignore_ascii_case(known));
        let options = ImportOptions { accept, ..ImportOptions::default() };
        is_sheet.then(|| Self { source: source.clone(), options })
    }

    /// What is made of it with points moved: names, and by how much, m, in the sheet's axes.
    pub(crate) fn import(&self, moves: &[(String, [f64; 3])]) -> Result<Imported, LoadError> {
        let mut options = self.options.clone();
        options.moves.extend_from_slice(moves);
        import(&self.source, &options)
    }
}
