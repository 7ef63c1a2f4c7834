//! Reader of the first sheet of an XLSX workbook, in bounded memory.
//!
//! Limits are checked before the library reads the workbook. The library allocates memory for the counts stated in a workbook,
//! and copies a cell format for every cell style that refers to the format.

use super::entries::{Cell, TableRow};
use crate::findings::Spot;
use crate::limits::workbook::{
    MAX_CELL_FORMAT_BYTES, MAX_CELL_FORMATS, MAX_TABLE_TEXT_BYTES, MAX_UNPACKED_BYTES, MAX_WORKBOOK_BYTES,
    MAX_WORKBOOK_PARTS, MAX_WORKSHEET_CELLS,
};
use crate::limits::{MAX_SHEET_KEYS, MAX_TABLE_COLUMNS};
use calamine::{DataRef, Reader, Xlsx};
use percuss_formats::reading::{cut, shortened};
use std::io::{Cursor, Read};
use zip::ZipArchive;

/// Digits of the last row, 1,048,576.
const MAX_ROW_DIGITS: usize = 7;
/// Letters of the last column, XFD, with a dollar sign for each half of the reference.
const MAX_COLUMN_LETTERS: usize = 5;

/// Error of a workbook, with the code of its finding.
pub(super) struct WorkbookError {
    pub code: &'static str,
    pub message: String,
}

/// Rows of the first sheet; `file`: index of the file among the files of the import.
///
/// # Errors
/// A workbook above a limit, or invalid.
pub(super) fn rows(bytes: &[u8], file: usize) -> Result<Vec<TableRow>, WorkbookError> {
    if bytes.len() > MAX_WORKBOOK_BYTES {
        let message = format!(
            "a workbook of {} bytes; at most {MAX_WORKBOOK_BYTES} are read: keep only the table in it",
            bytes.len()
        );
        return Err(WorkbookError { code: "too-large-file", message });
    }
    check_workbook(bytes).and_then(|()| read_rows(bytes, file)).map_err(|reason| WorkbookError {
        code: "not-table",
        message: format!("no XLSX workbook that can be read: {reason}"),
    })
}

/// Reads the rows cell by cell: memory for the range of the whole sheet would depend on the farthest cell.
fn read_rows(bytes: &[u8], file: usize) -> Result<Vec<TableRow>, String> {
    let shortened_text = |error: calamine::XlsxError| shortened(&error.to_string());
    let mut workbook: Xlsx<_> = Xlsx::new(Cursor::new(bytes)).map_err(shortened_text)?;
    let name = workbook.sheet_names().first().cloned().ok_or_else(|| "it has no sheet".to_owned())?;
    let mut reader = workbook.worksheet_cells_reader(&name).map_err(shortened_text)?;
    let mut rows: Vec<TableRow> = Vec::new();
    let (mut current, mut count, mut text_bytes) = (None, 0usize, 0usize);
    while let Some(cell) = reader.next_cell().map_err(shortened_text)? {
        let (row, column) = cell.get_position();
        count += 1;
        if count > MAX_WORKSHEET_CELLS || rows.len() > MAX_SHEET_KEYS {
            return Err(format!("more than {MAX_SHEET_KEYS} rows or {MAX_WORKSHEET_CELLS} cells"));
        }
        // Columns far to the right contain remarks.
        if column as usize >= MAX_TABLE_COLUMNS {
            continue;
        }
        let value = match cell.get_value() {
            DataRef::Empty => continue,
            DataRef::Int(x) => Cell::Number(*x as f64),
            DataRef::Float(x) => Cell::Number(*x),
            DataRef::Bool(x) => Cell::Switch(*x),
            DataRef::Error(error) => Cell::Text(format!("{error:?}")),
            DataRef::String(text) | DataRef::DateTimeIso(text) | DataRef::DurationIso(text) => {
                Cell::Text(text.clone())
            }
            DataRef::SharedString(text) => Cell::Text((*text).to_owned()),
            DataRef::DateTime(date) => Cell::Text(format!("the date {}", date.as_f64())),
        };
        if let Cell::Text(text) = &value {
            text_bytes += text.len();
        }
        // Many cells may refer to one shared text.
        if text_bytes > MAX_TABLE_TEXT_BYTES {
            return Err(format!("its cells have more than {MAX_TABLE_TEXT_BYTES} bytes of text"));
        }
        if current != Some(row) {
            current = Some(row);
            let path = Some(format!("{}, row {}", cut(&name, 40), row + 1));
            rows.push(TableRow { cells: Vec::new(), spot: Spot { path, at: None, file } });
        }
        if let Some(last) = rows.last_mut() {
            let blank = || Cell::Text(String::new());
            last.cells.resize_with((column as usize + 1).max(last.cells.len()), blank);
            last.cells[column as usize] = value;
        }
    }
    Ok(rows)
}

/// Checks the sizes and counts of a workbook. Work and memory are bounded by the size of the unpacked parts.
///
/// # Errors
/// An exceeded limit, or an invalid archive.
fn check_workbook(bytes: &[u8]) -> Result<(), String> {
    let mut archive = ZipArchive::new(Cursor::new(bytes)).map_err(|error| error.to_string())?;
    if archive.len() > MAX_WORKBOOK_PARTS {
        return Err(format!("it has {} parts; at most {MAX_WORKBOOK_PARTS} are read", archive.len()));
    }
    let (mut unpacked, mut part) = (0, Vec::new());
    for index in 0..archive.len() {
        let file = archive.by_index(index).map_err(|error| error.to_string())?;
        let name = file.name().map_err(|error| error.to_string())?.to_ascii_lowercase();
        part.clear();
        let remaining = MAX_UNPACKED_BYTES - unpacked;
        // The size stated in the archive may be wrong.
        let read = file.take(remaining as u64 + 1).read_to_end(&mut part);
        if part.len() > remaining {
            return Err(format!(
                "its parts have more than {MAX_UNPACKED_BYTES} bytes when they are unpacked: keep only the table in it"
            ));
        }
        read.map_err(|error| error.to_string())?;
        unpacked += part.len();
        check_stated_counts(&part)?;
        if name.contains("worksheets") {
            check_cell_references(&part)?;
        }
        if name.ends_with("styles.xml") {
            check_cell_formats(&part)?;
        }
    }
    Ok(())
}

/// Refuses a count of texts that the part cannot hold: a text has more than one byte.
fn check_stated_counts(part: &[u8]) -> Result<(), String> {
    for rest in after_each(part, b"uniqueCount") {
        let digits = rest.trim_ascii_start().strip_prefix(b"=").unwrap_or_default().trim_ascii_start();
        let digits = digits.strip_prefix(b"\"").or_else(|| digits.strip_prefix(b"'")).unwrap_or_default();
        let digits: Vec<u8> = digits.iter().copied().take_while(u8::is_ascii_digit).collect();
        // Zeros before the number do not make it larger.
        let stated_count = digits
            .iter()
            .fold(0_usize, |sum, digit| sum.saturating_mul(10).saturating_add(usize::from(digit - b'0')));
        if stated_count > part.len() {
            return Err(format!("it states {stated_count} shared texts in a part of {} bytes", part.len()));
        }
    }
    Ok(())
}

/// Refuses cell references beyond the last cell of a sheet, XFD1048576: the library multiplies their letters and digits
/// without a check for overflow.
fn check_cell_references(part: &[u8]) -> Result<(), String> {
    for attribute in [b"r".as_slice(), b"ref".as_slice()] {
        let starts = (1..part.len()).filter(|&at| part[at - 1].is_ascii_whitespace());
        for rest in starts.filter_map(|at| part[at..].strip_prefix(attribute)) {
            let Some(value) = rest.trim_ascii_start().strip_prefix(b"=").map(<[u8]>::trim_ascii_start) else {
                continue;
            };
            let Some((quote, value)) = value.split_first().filter(|(quote, _)| b"\"'".contains(quote)) else {
                continue;
            };
            let value = value.split(|byte| byte == quote).next().unwrap_or_default();
            let is_long = |cell: &[u8]| {
                let digits = cell.iter().filter(|byte| byte.is_ascii_digit()).count();
                digits > MAX_ROW_DIGITS || cell.len() - digits > MAX_COLUMN_LETTERS
            };
            // A text between tags may look like an attribute: only values of letters and digits are references.
            let is_reference = value.iter().all(|byte| byte.is_ascii_alphanumeric() || b":$".contains(byte));
            if is_reference && value.split(|byte| *byte == b':').any(is_long) {
                let shown: String = String::from_utf8_lossy(value).chars().take(40).collect();
                return Err(format!(
                    "it has a cell reference \"{shown}\"; the last cell of a sheet is XFD1048576"
                ));
            }
        }
    }
    Ok(())
}

/// Limits the cell formats: the library copies the font, the fill and the number format into each cell format.
fn check_cell_formats(part: &[u8]) -> Result<(), String> {
    let formats = after_each(part, b"xf").count();
    let longest = part.split(|byte| *byte == b'>').map(<[u8]>::len).max().unwrap_or(0);
    if formats > MAX_CELL_FORMATS {
        return Err(format!("it has {formats} cell formats; at most {MAX_CELL_FORMATS} are read"));
    }
    if formats.saturating_mul(longest) > MAX_CELL_FORMAT_BYTES {
        return Err(format!(
            "its {formats} cell formats name fonts or number formats of up to {longest} bytes; at most \
             {MAX_CELL_FORMAT_BYTES} bytes are read together"
        ));
    }
    Ok(())
}

/// Bytes of `part` after each occurrence of a word.
fn after_each<'p>(part: &'p [u8], word: &'static [u8]) -> impl Iterator<Item = &'p [u8]> {
    let starts = part.windows(word.len()).enumerate().filter(move |(_, window)| *window == word);
    starts.map(move |(at, _)| &part[at + word.len()..])
}
