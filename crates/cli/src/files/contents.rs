//! Output files with a table, a picture or JSON, in the format of their ending.

use crate::files::csv::{Cell, styled_table};
use crate::files::output::{check_writable, ending_of, write_file};
use crate::files::table_style::TableStyle;
use crate::files::{parquet_rows, xlsx_rows};
use crate::terminal::failure::Failure;
use percuss_render::Picture;

/// Endings of pictures.
pub const PICTURES: [&str; 3] = ["svg", "png", "pdf"];
/// Endings of files with a table or a picture.
pub const TABLES_AND_PICTURES: [&str; 6] = ["csv", "xlsx", "parquet", "svg", "png", "pdf"];
/// Endings of files with a table, a picture or JSON.
pub const ALL: [&str; 7] = ["csv", "xlsx", "parquet", "json", "svg", "png", "pdf"];

/// Checks the ending and the place of a file before the computation.
pub fn check(path: &str, endings: &[&'static str]) -> Result<(), Failure> {
    ending_of(path, endings)?;
    check_writable(path)
}

/// Names of columns, and rows.
pub type Cells = (Vec<String>, Vec<Vec<Cell>>);

/// Contents that a file can have, computed when they are written.
#[derive(Default)]
pub struct Contents<'a> {
    /// Name of the sheet of a workbook.
    pub name: &'a str,
    pub style: TableStyle,
    pub table: Option<&'a dyn Fn() -> Cells>,
    pub picture: Option<&'a dyn Fn() -> Result<Box<dyn Picture + 'a>, Failure>>,
    pub json: Option<&'a dyn Fn() -> String>,
}

impl Contents<'_> {
    /// Endings of the files.
    fn endings(&self) -> Vec<&'static str> {
        let is_possible = |ending: &&&str| match **ending {
            "json" => self.json.is_some(),
            "svg" | "png" | "pdf" => self.picture.is_some(),
            _ => self.table.is_some(),
        };
        ALL.iter().filter(is_possible).copied().collect()
    }

    /// Writes a file.
    ///
    /// # Errors
    /// Another ending; a file that cannot be written.
    pub fn write(&self, path: &str) -> Result<(), Failure> {
        let ending = ending_of(path, &self.endings())?;
        let bytes = match (ending, self.table, self.picture, self.json) {
            ("json", _, _, Some(json)) => json().into_bytes(),
            ("svg" | "png" | "pdf", _, Some(picture), _) => picture_bytes(&*picture()?, ending)?,
            (_, Some(table), ..) => {
                let (columns, rows) = table();
                match ending {
                    "xlsx" => xlsx_rows::workbook(path, self.name, &columns, rows)?,
                    "parquet" => return parquet_rows::write_table(path, &columns, &rows),
                    _ => styled_table(&columns, &rows, self.style).into_bytes(),
                }
            }
            // The ending is one of the possible ones.
            _ => Vec::new(),
        };
        write_file(path, &bytes)
    }
}

/// Encodes a picture.
pub fn picture_bytes(picture: &dyn Picture, ending: &str) -> Result<Vec<u8>, Failure> {
    match ending {
        "png" => picture.to_png(2.0).map_err(Failure::from),
        "pdf" => picture.to_pdf().map_err(Failure::from),
        _ => Ok(picture.to_svg().into_bytes()),
    }
}
