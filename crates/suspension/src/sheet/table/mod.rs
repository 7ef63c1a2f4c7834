//! Reader of hardpoint tables: CSV (comma, semicolon or tab; decimal point or comma) or a worksheet of an XLSX workbook.
//!
//! A row contains a key and its values: `lower_ball; 5; 720; 180`. Keys other than points contain the section,
//! `lower_arm.mass; 4.2`; keys of the head have no section, `unit; mm`. A header with the names x, y and z, optionally with
//! a unit (`x [mm]`), defines these columns; columns with other names are ignored. The unit applies to the points of the
//! table, and by default to all lengths. Titles may precede the header or the first key. Rows that begin with # are comments.

#[cfg(feature = "xlsx")]
mod workbook;

use super::catalogue::{self, HEAD};
use super::entries::{Cell, Entries, TableRow, parse_number};
use crate::corner::design::STOPS;
use crate::findings::{Findings, Spot};
use crate::limits::{MAX_SHEET_KEYS, MAX_TABLE_COLUMNS};
use percuss_formats::reading::{quoted, shortened};
use percuss_units::LengthUnit;

/// Largest number of title rows.
const MAX_TITLE_ROWS: usize = 20;

/// Names of the columns of coordinates in headers, also those that Adams/Car writes.
const COLUMNS: [[&str; 4]; 3] = [
    ["x", "loc_x", "x_value", "loc x"],
    ["y", "loc_y", "y_value", "loc y"],
    ["z", "loc_z", "z_value", "loc z"],
];

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

/// Separator of the columns, from the first line with a header, a key of the head or numbers: a title may contain a comma.
fn separator_of(text: &str) -> char {
    const SEPARATORS: [char; 3] = [';', '\t', ','];
    let lines = text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#'));
    let of_table = lines.clone().take(MAX_TITLE_ROWS + 1).find_map(|line| {
        SEPARATORS.into_iter().find(|separator| {
            let cells: Vec<Cell> = line.split(*separator).map(|cell| Cell::Text(cell.to_owned())).collect();
            let is_number = |cell: &&Cell| matches!(cell, Cell::Text(text) if parse_number(text).is_some());
            let is_of_head =
                cells.len() > 1 && matches!(&cells[0], Cell::Text(text) if HEAD.contains(&text.trim()));
            is_of_head
                || find_columns(&cells).is_some()
                || cells.iter().skip(1).filter(is_number).count() >= 3
        })
    });
    let of_first =
        || lines.clone().next().and_then(|line| SEPARATORS.into_iter().find(|c| line.contains(*c)));
    of_table.or_else(of_first).unwrap_or(';')
}

/// Reads CSV; `file`: index of the file among the files of the import.
pub(super) fn read_text(text: &str, file: usize, entries: &mut Entries, findings: &mut Findings) {
    let separator = separator_of(text);
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
            "{} has a decimal comma and {} a decimal point; use one of them in the whole table, without separators of thousands",
            quoted(&comma),
            quoted(&point)
        );
        findings.error("decimal-mark", &spot, message);
        return;
    }
    add_rows(rows, entries, findings);
}

/// Reads a worksheet of a workbook, the first one if no name is given; `file`: index of the file among the files of the import.
pub(super) fn read_workbook(
    bytes: &[u8],
    file: usize,
    worksheet: Option<&str>,
    entries: &mut Entries,
    findings: &mut Findings,
) {
    #[cfg(feature = "xlsx")]
    match workbook::worksheet(bytes, file, worksheet) {
        Ok(found) => {
            add_rows(found.rows, entries, findings);
            if worksheet.is_none() && !found.others.is_empty() {
                let spot = Spot { file, ..Spot::default() };
                let message = format!(
                    "the workbook has {} worksheets; the first one, {}, is read, and not {}. To read another one: \
                     --worksheet NAME, or the key worksheet of a sheet",
                    found.others.len() + 1,
                    quoted(&found.name),
                    workbook::list_of(&found.others)
                );
                findings.note(crate::findings::FIRST_WORKSHEET, &spot, message);
            }
        }
        Err(error) => findings.error(error.code, &Spot { file, ..Spot::default() }, error.message),
    }
    #[cfg(not(feature = "xlsx"))]
    {
        let (_, _, _) = (bytes, entries, worksheet);
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
    let mut rows: Vec<TableRow> = rows.collect();
    let titles = title_rows(&rows);
    if let Some(last) = titles.checked_sub(1).and_then(|last| rows.get(last)) {
        let text = rows[0].cells.iter().find(|cell| !is_blank(cell)).map_or_else(String::new, Cell::to_text);
        let message = if titles == 1 {
            format!("the row {text} is taken as a title; it has no key and no numbers")
        } else {
            format!(
                "the first {titles} rows, from {text}, are taken as titles; they have no key and no numbers"
            )
        };
        findings.note("title-row", &last.spot.clone(), message);
    }
    rows.drain(..titles);
    let mut columns: Option<[usize; 3]> = None;
    let mut points_unit: Option<(String, Spot)> = None;
    for row in rows {
        if columns.is_none()
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
            first => {
                let found = first.map_or_else(|| "nothing".to_owned(), Cell::to_text);
                let message =
                    format!("the row begins with {found}, which is no name; name, x, y, z are expected");
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

/// Number of title rows before the header or the first key. A title has no number, and its first cell is no key.
fn title_rows(rows: &[TableRow]) -> usize {
    let is_title = |row: &&TableRow| {
        let filled = |cell: &&Cell| !matches!(cell, Cell::Text(text) if text.trim().is_empty());
        let is_value = |cell: &Cell| !matches!(cell, Cell::Text(text) if parse_number(text).is_none());
        let first = match row.cells.iter().find(filled) {
            Some(Cell::Text(text)) => text.trim(),
            _ => return false,
        };
        let is_key = HEAD.contains(&first)
            || catalogue::keys().points.iter().any(|(key, _)| key == first)
            || first.split_once('.').is_some_and(|(section, _)| is_section(section));
        let has_values = row.cells.iter().any(is_value);
        find_columns(&row.cells).is_none() && !is_key && !has_values
    };
    let titles = rows.iter().take(MAX_TITLE_ROWS).take_while(is_title).count();
    if titles < rows.len() { titles } else { 0 }
}

/// True for the name of a section of a sheet.
fn is_section(name: &str) -> bool {
    let is_body = || catalogue::keys().bodies.iter().any(|(key, _)| key == name);
    ["points", "wheel", "rack", "spring", "damper"].contains(&name) || STOPS.contains(&name) || is_body()
}

/// Gives a number the unit of its column, unless the number has a unit.
fn append_unit(cell: &mut Cell, unit: &str) {
    let with_unit = match &*cell {
        Cell::Number(x) => format!("{x} {unit}"),
        Cell::Text(text) if parse_number(text).is_some() => format!("{} {unit}", text.trim()),
        Cell::Text(_) | Cell::Switch(_) | Cell::Unreadable(_) => return,
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
        let Some(axis) = COLUMNS.iter().position(|names| names.contains(&&*name)) else { continue };
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
