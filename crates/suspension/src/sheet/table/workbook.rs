//! Reader of one sheet of an XLSX workbook, in bounded memory.
//!
//! Limits are checked before the library reads the workbook. The library allocates memory for the counts stated in a workbook,
//! and copies a cell format for every cell style that refers to the format.

use super::super::entries::{Cell, Place, TableRow};
use crate::findings::Spot;
use crate::limits::workbook::{
    MAX_CELL_FORMAT_BYTES, MAX_CELL_FORMATS, MAX_SHARED_FORMULAS, MAX_TABLE_TEXT_BYTES, MAX_UNPACKED_BYTES,
    MAX_WORKBOOK_BYTES, MAX_WORKBOOK_PARTS, MAX_WORKSHEET_CELLS,
};
use crate::limits::{MAX_SHEET_KEYS, MAX_TABLE_COLUMNS};
use calamine::{DataRef, Reader, Xlsx};
use percuss_formats::reading::{cut, quoted, shortened};
use std::io::{Cursor, Read};
use zip::ZipArchive;

/// Digits of the last row, 1,048,576.
const MAX_ROW_DIGITS: usize = 7;
/// Letters of the last column, XFD, with a dollar sign for each half of the reference.
const MAX_COLUMN_LETTERS: usize = 5;

/// Remedy for a number that a spreadsheet program has changed to a date.
const DATE_REMEDY: &str = ": format the cell as a number and enter the number again";

/// Error of a workbook, with the code of its finding.
pub(super) struct WorkbookError {
    pub code: &'static str,
    pub message: String,
}

/// Rows of a worksheet, with the names of the other worksheets.
pub(super) struct Worksheet {
    pub name: String,
    pub others: Vec<String>,
    pub rows: Vec<TableRow>,
}

/// Reads the worksheet of the given name, or the first one; `file`: index of the file among the files of the import.
///
/// # Errors
/// A workbook above a limit, or invalid; an unknown worksheet.
pub(super) fn worksheet(bytes: &[u8], file: usize, wanted: Option<&str>) -> Result<Worksheet, WorkbookError> {
    if bytes.len() > MAX_WORKBOOK_BYTES {
        let message = format!(
            "a workbook of {} bytes; at most {MAX_WORKBOOK_BYTES} are read: keep only the table in it",
            bytes.len()
        );
        return Err(WorkbookError { code: "too-large-file", message });
    }
    let unreadable = |reason: String| WorkbookError {
        code: "not-table",
        message: format!("no XLSX workbook that can be read: {reason}"),
    };
    check_workbook(bytes).map_err(unreadable)?;
    let mut workbook: Xlsx<_> =
        Xlsx::new(Cursor::new(bytes)).map_err(|error| unreadable(shortened(&error.to_string())))?;
    let names = workbook.sheet_names();
    let name = match wanted {
        None => names.first().cloned().ok_or_else(|| unreadable("it has no sheet".to_owned()))?,
        Some(wanted) => match names.iter().find(|name| name.trim() == wanted.trim()) {
            Some(name) => name.clone(),
            None => {
                let message = format!(
                    "no worksheet is named {}; the workbook has: {}",
                    quoted(wanted),
                    list_of(&names)
                );
                return Err(WorkbookError { code: "unknown-worksheet", message });
            }
        },
    };
    let mut rows = read_rows(&mut workbook, &name, file).map_err(unreadable)?;
    // The reader has noted the place of the first cell.
    for row in &mut rows {
        if let Some(Place::Cell(number, _)) = row.places.first() {
            let number = *number;
            row.places = (0..row.cells.len() as u32).map(|column| Place::Cell(number, column)).collect();
        }
    }
    let others = names.into_iter().filter(|other| *other != name).collect();
    Ok(Worksheet { name, others, rows })
}

/// List of names of worksheets for messages, at most twenty.
pub(super) fn list_of(names: &[String]) -> String {
    let list: Vec<String> = names.iter().take(20).map(|name| quoted(name)).collect();
    format!("{}{}", list.join(", "), if names.len() > 20 { ", …" } else { "" })
}

/// True for no value and for an empty text.
fn is_blank(value: &DataRef<'_>) -> bool {
    match value {
        DataRef::Empty => true,
        DataRef::String(text) => text.is_empty(),
        DataRef::SharedString(text) => text.is_empty(),
        _ => false,
    }
}

/// Address of a cell, `C12`, from the indices of its row and column.
pub(super) fn address(row: u32, column: u32) -> String {
    let (mut letters, mut rest) = (Vec::new(), column + 1);
    while rest > 0 {
        letters.insert(0, char::from(b'A' + ((rest - 1) % 26) as u8));
        rest = (rest - 1) / 26;
    }
    format!("{}{}", letters.into_iter().collect::<String>(), row + 1)
}

/// Reads the rows cell by cell: memory for the range of the whole sheet would depend on the farthest cell.
fn read_rows(workbook: &mut Xlsx<Cursor<&[u8]>>, name: &str, file: usize) -> Result<Vec<TableRow>, String> {
    let shortened_text = |error: calamine::XlsxError| shortened(&error.to_string());
    let mut reader = workbook.worksheet_cells_reader(name).map_err(shortened_text)?;
    let mut rows: Vec<TableRow> = Vec::new();
    let (mut current, mut count, mut text_bytes) = (None, 0usize, 0usize);
    while let Some(cell) = reader.next_cell_with_formula_metadata().map_err(shortened_text)? {
        let (row, column) = cell.pos;
        count += 1;
        if count > MAX_WORKSHEET_CELLS || rows.len() > MAX_SHEET_KEYS {
            return Err(format!("more than {MAX_SHEET_KEYS} rows or {MAX_WORKSHEET_CELLS} cells"));
        }
        // Columns far to the right contain remarks.
        if column as usize >= MAX_TABLE_COLUMNS {
            continue;
        }
        let at = || address(row, column);
        let value = match &cell.value {
            // Some programs write an empty text in place of the value.
            value if cell.formula.is_some() && is_blank(value) => Cell::Unreadable(format!(
                "cell {} has a formula without a stored value (open the workbook in a spreadsheet program and save it, \
                 or enter the number)",
                at()
            )),
            DataRef::Empty => continue,
            DataRef::Int(x) => Cell::Number(*x as f64),
            DataRef::Float(x) => Cell::Number(*x),
            DataRef::Bool(x) => Cell::Switch(*x),
            DataRef::Error(error) => Cell::Unreadable(format!("cell {} has the error {error}", at())),
            DataRef::DateTimeIso(text) | DataRef::DurationIso(text) => {
                Cell::Unreadable(format!("cell {} is a date or a time, {}{DATE_REMEDY}", at(), quoted(text)))
            }
            DataRef::String(text) => Cell::Text(text.clone()),
            DataRef::SharedString(text) => Cell::Text((*text).to_owned()),
            DataRef::DateTime(date) => Cell::Unreadable(format!(
                "cell {} is a date or a time (day {}){DATE_REMEDY}",
                at(),
                date.as_f64()
            )),
        };
        if let Cell::Text(text) | Cell::Unreadable(text) = &value {
            text_bytes += text.len();
        }
        // Many cells may refer to one shared text.
        if text_bytes > MAX_TABLE_TEXT_BYTES {
            return Err(format!("its cells have more than {MAX_TABLE_TEXT_BYTES} bytes of text"));
        }
        if current != Some(row) {
            current = Some(row);
            let path = Some(format!("{}, row {}", cut(name, 40), row + 1));
            let spot = Spot { path, at: None, file };
            rows.push(TableRow { cells: Vec::new(), places: vec![Place::Cell(row, 0)], spot });
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
pub(super) fn check_workbook(bytes: &[u8]) -> Result<(), String> {
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
            check_shared_formulas(&part)?;
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
        let stated_count = attribute_value(rest);
        if stated_count > part.len() {
            return Err(format!("it states {stated_count} shared texts in a part of {} bytes", part.len()));
        }
    }
    Ok(())
}

/// Refuses indices of shared formulas above a limit: the library allocates an entry for each smaller index.
fn check_shared_formulas(part: &[u8]) -> Result<(), String> {
    for rest in after_each(part, b"si") {
        let index = attribute_value(rest);
        if index > MAX_SHARED_FORMULAS {
            return Err(format!("it has the shared formula {index}; at most {MAX_SHARED_FORMULAS} are read"));
        }
    }
    Ok(())
}

/// Value of an attribute from the text after its name: a decimal number, saturated; 0 without one.
fn attribute_value(rest: &[u8]) -> usize {
    let digits = rest.trim_ascii_start().strip_prefix(b"=").unwrap_or_default().trim_ascii_start();
    let digits = digits.strip_prefix(b"\"").or_else(|| digits.strip_prefix(b"'")).unwrap_or_default();
    let digits = digits.iter().take_while(|byte| byte.is_ascii_digit());
    digits.fold(0, |sum: usize, digit| sum.saturating_mul(10).saturating_add(usize::from(digit - b'0')))
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
