//! Reader of hardpoint tables: CSV (comma, semicolon or tab; decimal point or comma) or the first sheet of an XLSX workbook.
//!
//! A row contains a key and its values: `lower_ball; 5; 720; 180`. Keys other than points contain the section,
//! `lower_arm.mass; 4.2`; keys of the head have no section, `unit; mm`. A first row with the names x, y and z, optionally with
//! a unit (`x [mm]`), defines these columns; columns with other names are ignored. The unit applies to the points of the
//! table, and by default to all lengths. Rows that begin with # are comments.

use super::entries::{Cell, Entries, TableRow, parse_number};
#[cfg(feature = "xlsx")]
use super::workbook;
use crate::findings::{Findings, Spot};
use crate::limits::{MAX_SHEET_KEYS, MAX_TABLE_COLUMNS};
use percuss_formats::reading::{quoted, shortened};
use percuss_units::LengthUnit;

/// Keys of the head; any other key without a section is a point.
pub(super) const HEAD: [&str; 8] =
    ["template", "name", "unit", "inertia_unit", "axes", "side", "build", "points"];

/// True if the bytes begin like an XLSX workbook (a ZIP archive).
pub(in super::super) fn is_workbook(bytes: &[u8]) -> bool {
    bytes.starts_with(b"PK\x03\x04")
}

/// True if a text looks like a table, not TOML: the first row has a separator, no equals sign and no section.
pub(super) fn looks_like_table(text: &str) -> bool {
    let first = text.lines().map(str::trim).find(|line| !line.is_empty() && !line.starts_with('#'));
    first.is_some_and(|line| {
        line.contains([',', ';', '\t']) && !line.contains('=') && !line.starts_with(['[', '{', '/', '<'])
    })
}

/// Reads CSV; `file`: index of the file among the files of the import.
pub(super) fn read_text(text: &str, file: usize, entries: &mut Entries, findings: &mut Findings) {
    let first = text.lines().map(str::trim).find(|line| !line.is_empty() && !line.starts_with('#'));
    let separator = first.and_then(|line| [';', '\t', ','].into_iter().find(|c| line.contains(*c)));
    let separator = separator.unwrap_or(';');
    let mut reader = csv::ReaderBuilder::new()
        .delimiter(separator as u8)
        .comment(Some(b'#'))
        .has_headers(false)
        .flexible(true)
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    let (mut rows, mut commas, mut points) = (Vec::new(), None, None);
    for record in reader.records() {
        let record = match record {
            Ok(record) => record,
            Err(error) => {
                let spot = Spot { file, ..Spot::default() };
                findings.error("not-table", &spot, format!("no table: {}", shortened(&error.to_string())));
                return;
            }
        };
        let at = record.position().map(|p| p.byte() as usize);
        let spot = Spot { path: None, at, file };
        if rows.len() > MAX_SHEET_KEYS || record.len() > MAX_TABLE_COLUMNS {
            let message = format!("more than {MAX_SHEET_KEYS} rows, or {MAX_TABLE_COLUMNS} columns");
            findings.error("too-complex", &spot, message);
            return;
        }
        for cell in record.iter().skip(1).filter(|cell| parse_number(cell).is_some()) {
            if cell.contains(',') {
                commas.get_or_insert_with(|| (cell.to_owned(), spot.clone()));
            } else if cell.contains('.') {
                points.get_or_insert_with(|| cell.to_owned());
            }
        }
        rows.push(TableRow { cells: record.iter().map(|cell| Cell::Text(cell.to_owned())).collect(), spot });
    }
    if let (Some((comma, spot)), Some(point)) = (commas, points) {
        let message = format!(
            "{} has a decimal comma and {} a decimal point; one table has one of them (no separators of thousands)",
            quoted(&comma),
            quoted(&point)
        );
        findings.error("decimal-mark", &spot, message);
        return;
    }
    add_rows(rows, entries, findings);
}

/// Reads the first sheet of a workbook; `file`: index of the file among the files of the import.
pub(super) fn read_workbook(bytes: &[u8], file: usize, entries: &mut Entries, findings: &mut Findings) {
    #[cfg(feature = "xlsx")]
    match workbook::rows(bytes, file) {
        Ok(rows) => add_rows(rows, entries, findings),
        Err(error) => findings.error(error.code, &Spot { file, ..Spot::default() }, error.message),
    }
    #[cfg(not(feature = "xlsx"))]
    {
        let (_, _) = (bytes, entries);
        let message = "this is an XLSX workbook, and this build does not read XLSX: save the table as CSV, or build it with the \
                       feature \"tables\" (`cargo build --release --features tables`)";
        findings.error("not-built-in", &Spot { file, ..Spot::default() }, message.to_owned());
    }
}

/// Adds an entry for each row, with the key in the first cell.
fn add_rows(rows: Vec<TableRow>, entries: &mut Entries, findings: &mut Findings) {
    let is_blank = |cell: &Cell| matches!(cell, Cell::Text(text) if text.trim().is_empty());
    let rows = rows.into_iter().filter(|row| {
        let comment =
            matches!(row.cells.first(), Some(Cell::Text(text)) if text.trim_start().starts_with('#'));
        !comment && !row.cells.iter().all(is_blank)
    });
    let mut columns: Option<[usize; 3]> = None;
    let mut points_unit: Option<(String, Spot)> = None;
    for (i, row) in rows.enumerate() {
        if i == 0
            && let Some((found, unit)) = find_columns(&row.cells)
        {
            columns = Some(found);
            let spot = Spot { path: Some("unit".to_owned()), ..row.spot };
            match unit {
                Some(unit) if LengthUnit::from_name(&unit).is_none() => {
                    let message = format!(
                        "{} is not known; a unit of length (m, cm, mm, in) is expected",
                        quoted(&unit)
                    );
                    findings.error("unknown-word", &spot, message);
                }
                unit => points_unit = unit.map(|unit| (unit, spot)),
            }
            continue;
        }
        let key = match row.cells.first() {
            Some(Cell::Text(text)) if !text.trim().is_empty() => text.trim().to_owned(),
            _ => {
                let message = "the row's first cell is no name; name, x, y, z are expected".to_owned();
                findings.error("wrong-type", &row.spot, message);
                continue;
            }
        };
        let key = if key.contains('.') || HEAD.contains(&&*key) { key } else { format!("points.{key}") };
        let named_columns = columns.filter(|_| key.starts_with("points."));
        let mut values: Vec<Cell> = match named_columns {
            Some(columns) => columns.iter().filter_map(|i| row.cells.get(*i).cloned()).collect(),
            None => row.cells.into_iter().skip(1).collect(),
        };
        if let (Some(_), Some((unit, _))) = (named_columns, &points_unit) {
            values.iter_mut().for_each(|cell| append_unit(cell, unit));
        }
        while values.last().is_some_and(is_blank) {
            values.pop();
        }
        let path = match &row.spot.path {
            Some(place) => format!("{} ({place})", shortened(&key)),
            None => shortened(&key),
        };
        let spot = Spot { path: Some(path), ..row.spot };
        entries.add(findings, key, values, spot);
    }
    if let Some((unit, spot)) = points_unit.filter(|_| !entries.has("unit")) {
        entries.add(findings, "unit".to_owned(), vec![Cell::Text(unit)], spot);
    }
}

/// Gives a number the unit of its column, unless the number has a unit.
fn append_unit(cell: &mut Cell, unit: &str) {
    let with_unit = match &*cell {
        Cell::Number(x) => format!("{x} {unit}"),
        Cell::Text(text) if parse_number(text).is_some() => format!("{} {unit}", text.trim()),
        Cell::Text(_) | Cell::Switch(_) => return,
    };
    *cell = Cell::Text(with_unit);
}

/// Columns named x, y and z, and their unit, if the row is a header.
fn find_columns(cells: &[Cell]) -> Option<([usize; 3], Option<String>)> {
    let mut columns = [None; 3];
    let mut unit: Option<String> = None;
    for (i, cell) in cells.iter().enumerate() {
        let Cell::Text(text) = cell else { continue };
        let (name, rest) = match text.split_once(['[', '(']) {
            Some((name, rest)) => (name, rest.trim().trim_end_matches([']', ')'])),
            None => (text.as_str(), ""),
        };
        let name = name.trim().to_ascii_lowercase();
        let Some(axis) = ["x", "y", "z"].iter().position(|axis| *axis == name) else { continue };
        columns[axis].get_or_insert(i);
        // Different units of the columns give a text that is no valid unit.
        match &unit {
            None if !rest.is_empty() => unit = Some(rest.to_owned()),
            Some(known) if known != rest => unit = Some(format!("{known} and {rest}")),
            Some(_) | None => {}
        }
    }
    let [Some(x), Some(y), Some(z)] = columns else { return None };
    Some(([x, y, z], unit))
}
