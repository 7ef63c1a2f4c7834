//! Reader of hardpoint tables: CSV (comma, semicolon or tab; decimal point or comma) or a worksheet of an XLSX workbook.
//!
//! A row contains a key and its values: `lower_ball; 5; 720; 180`. Keys other than points contain the section,
//! `lower_arm.mass; 4.2`; keys of the head have no section, `unit; mm`. A header names the columns; columns with other names are
//! not used. Its unit applies to the points of the table, and by default to all lengths. Titles may precede the header or the first
//! key. Rows that begin with # are comments, except a header above a table without another one.

#[cfg(feature = "xlsx")]
mod changed_workbook;
mod header;
mod places;
mod settings;
mod titles;
#[cfg(feature = "xlsx")]
mod workbook;

use super::catalogue::HEAD;
use super::entries::{Cell, Entries, Place, TableRow, parse_number};
use super::names::vocabulary;
use crate::findings::{Findings, Spot};
use crate::limits::{MAX_SHEET_KEYS, MAX_TABLE_COLUMNS};
use crate::options::Side;
pub(super) use header::unit_of;
use header::{Columns, Row};
use percuss_formats::reading::{quoted, shortened};
use percuss_units::LengthUnit;
use places::cell_places;
use std::borrow::Cow;
use titles::{MAX_TITLE_ROWS, is_blank, is_comment, is_key, number_of, read_comments, title_rows, word_of};

/// Reason of a refused title.
const OTHER_ORDER: &str = "it names the axes in another order in one cell";

/// Workbook with other numbers in some cells of a worksheet, `None` for the first one.
///
/// # Errors
/// The reason, in words.
pub(in super::super) fn changed_workbook(
    bytes: &[u8],
    worksheet: Option<&str>,
    changes: &[(Place, f64, f64)],
) -> Result<Vec<u8>, String> {
    #[cfg(feature = "xlsx")]
    return changed_workbook::changed_workbook(bytes, worksheet, changes);
    #[cfg(not(feature = "xlsx"))]
    {
        let (_, _, _) = (bytes, worksheet, changes);
        Err("this build does not write XLSX".to_owned())
    }
}

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
                || matches!(header::read(&cells, Side::Left), Row::Header(_))
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
    // "#" as the name of the first column, or a header in a comment above a table without one; other rows that begin with # are comments.
    let numbered = format!("#{separator}");
    let is_header = |line: &str| {
        let cells = line.split(separator).map(|cell| Cell::Text(cell.trim().to_owned())).collect::<Vec<_>>();
        matches!(header::read(&cells, Side::Left), Row::Header(_))
    };
    let has_header = text.lines().any(|line| !line.starts_with('#') && is_header(line));
    let is_commented = |line: &&str| {
        line.starts_with('#') && !has_header && is_header(line.trim_start_matches(['#', ' ', '\t']))
    };
    let text = match text.lines().find(|line| line.starts_with(&numbered) && is_header(line)) {
        Some(line) => Cow::Owned(text.replacen(line, &format!("n{}", &line[1..]), 1)),
        None => match text.lines().find(is_commented) {
            Some(line) => {
                let names = line.trim_start_matches('#');
                Cow::Owned(text.replacen(line, &format!("{names:>width$}", width = line.len()), 1))
            }
            None => Cow::Borrowed(text),
        },
    };
    let has_header = has_header || matches!(text, Cow::Owned(_));
    let mut titles = text.lines().take(MAX_TITLE_ROWS);
    if let Some(line) = titles.find(|line| !has_header && header::names_other_order(line)) {
        let cells = [Cell::Text(line.trim_start_matches('#').trim().to_owned())];
        let spot = Spot { file, ..Spot::default() };
        findings.error("unknown-header", &spot, unclear_header(&cells, OTHER_ORDER));
        return;
    }
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
        let cells: Vec<Cell> = record.iter().map(|cell| Cell::Text(cell.to_owned())).collect();
        let mut places = cell_places(&text, at.unwrap_or_default(), separator);
        places.resize(cells.len(), Place::Text(0..0));
        rows.push(TableRow { cells, places, spot });
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
            entries.worksheet = Some(found.name.clone());
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

/// Adds an entry for each row, with the key in the first cell or in the column of the names.
fn add_rows(mut rows: Vec<TableRow>, entries: &mut Entries, findings: &mut Findings) {
    if let Some((text, spot)) = read_comments(&mut rows) {
        findings.error("unknown-header", &spot, unclear_header(&[Cell::Text(text)], OTHER_ORDER));
        return;
    }
    let rows = rows.into_iter().filter(|row| !is_comment(row) && !row.cells.iter().all(is_blank));
    let mut rows: Vec<TableRow> = rows.collect();
    drop_columns(&mut rows, findings);
    let side_of_rows =
        rows.iter().find(|row| matches!(row.cells.first(), Some(Cell::Text(key)) if key.trim() == "side"));
    let side =
        side_of_rows.and_then(|row| row.cells.get(1)).map_or_else(|| entries.given("side"), Cell::to_text);
    let side = if side.contains("right") { Side::Right } else { Side::Left };
    let below_sides = |i: usize| header::with_sides(&rows.get(i)?.cells, &rows.get(i + 1)?.cells);
    let kind = |i: usize| {
        let cells = &rows[i].cells;
        if below_sides(i).is_some() {
            return Row::Sides;
        }
        match i.checked_sub(1).and_then(below_sides) {
            Some(merged) => header::read(&merged, side),
            None if is_key(cells) || is_setting(cells) => Row::Other,
            None => header::read(cells, side),
        }
    };
    let kinds: Vec<Row> = (0..rows.len()).map(kind).collect();
    let titles = title_rows(&rows, &kinds);
    let of_title = |row: &TableRow| Some((header::unit_of_title(&row.cells)?, row.spot.clone()));
    let of_settings = rows.iter().find_map(|row| {
        let cells: Vec<&Cell> = row.cells.iter().skip(1).collect();
        match settings::read(word_of(row.cells.first()?)?, &cells)? {
            ("unit", Cell::Text(unit)) => Some((unit_of(&unit)?, row.spot.clone())),
            _ => None,
        }
    });
    let title_unit = rows[..titles].iter().rev().find_map(of_title).or(of_settings);
    if let Some(last) = titles.checked_sub(1).and_then(|last| rows.get(last)) {
        let text = rows[0].cells.iter().find(|cell| !is_blank(cell)).map_or_else(String::new, Cell::to_text);
        let unit = title_unit.as_ref().map_or_else(String::new, |(unit, _)| {
            format!("; the points are in {}, unless a header states another unit", unit.name())
        });
        let message = if titles == 1 {
            format!("the row {text} is taken as a title; it has no key and no numbers{unit}")
        } else {
            format!(
                "the first {titles} rows, from {text}, are taken as titles; they have no key and no numbers{unit}"
            )
        };
        findings.note("title-row", &last.spot.clone(), message);
    }
    let has_header = kinds.iter().any(|kind| matches!(kind, Row::Header(_)));
    let mut columns = title_unit.as_ref().filter(|_| !has_header).map(|_| Columns::without_header());
    let mut table_unit = title_unit.clone();
    // The first header as written, without the column of the names.
    let mut header: Option<Columns> = None;
    let (mut nameless, mut is_below_header, mut has_points) = (Vec::new(), false, false);
    let mut others = OtherRows::default();
    for (i, (row, kind)) in rows.iter().zip(kinds).enumerate().skip(titles) {
        let spot = row.spot.clone();
        if let (true, Some(columns)) = (std::mem::take(&mut is_below_header), &mut columns) {
            match columns.add_units(&row.cells) {
                Ok(false) => {}
                Ok(true) => {
                    table_unit = columns.common_unit().map(|unit| (unit, spot));
                    continue;
                }
                Err(reason) => {
                    findings.error("unknown-header", &spot, unclear_header(&row.cells, &reason));
                    continue;
                }
            }
        }
        match kind {
            Row::Other => {}
            Row::Sides => continue,
            Row::Header(mut found) => {
                let defect = match &header {
                    Some(known) if *known != found => Some("a row above names other columns"),
                    None if has_points && (found.xyz != [1, 2, 3] || found.units.is_some()) => {
                        Some("it is below rows of points")
                    }
                    _ => None,
                };
                match (defect, &header) {
                    (Some(reason), _) => {
                        findings.error("unknown-header", &spot, unclear_header(&row.cells, reason));
                    }
                    (None, Some(_)) => {}
                    (None, None) => {
                        header = Some(found.clone());
                        found.find_names(&row.cells, rows[i + 1..].iter().map(|row| &row.cells[..]));
                        if let Some(message) = found.message(&row.cells) {
                            findings.note("columns", &spot, message);
                        }
                        if found.units.is_some() {
                            table_unit = found.common_unit().map(|unit| (unit, spot));
                        }
                        if found.has_directions {
                            entries.directions = Some(row.spot.clone());
                        }
                        is_below_header = true;
                        columns = Some(found);
                    }
                }
                continue;
            }
            Row::Unclear { reason, .. } => {
                findings.error("unknown-header", &spot, unclear_header(&row.cells, &reason));
                continue;
            }
        }
        let name = columns.as_ref().map_or(0, |columns| columns.name);
        let key = match row.cells.get(name) {
            Some(Cell::Text(text)) if !text.trim().is_empty() && parse_number(text).is_none() => {
                text.trim().to_owned()
            }
            _ if header.is_some() && !has_number(&row.cells, columns.as_ref()) => {
                let first =
                    row.cells.iter().find(|cell| !is_blank(cell)).map_or_else(String::new, Cell::to_text);
                others.unused.push((first, spot));
                continue;
            }
            first => {
                nameless.push((
                    first.filter(|cell| !is_blank(cell)).map_or_else(|| "nothing".to_owned(), Cell::to_text),
                    spot,
                ));
                continue;
            }
        };
        if !is_key(&row.cells[name..]) && !HEAD.contains(&&*key) && !has_numbers(&row.cells, columns.as_ref())
        {
            let is_used = others.read(
                &key,
                row,
                columns.as_ref(),
                table_unit.as_ref().map(|(unit, _)| *unit),
                (entries, findings),
            );
            if is_used {
                continue;
            }
            let is_name = has_number(&row.cells, columns.as_ref()) && vocabulary::has_known_words(&key);
            if header.is_some() && !is_name && !key.contains('.') {
                others.unused.push((quoted(&key), spot));
                continue;
            }
        }
        // A name such as "lwb.front" with three numbers.
        let is_dotted_point =
            || has_numbers(&row.cells, columns.as_ref()) && vocabulary::has_known_words(&key);
        let is_point = !HEAD.contains(&&*key) && (!key.contains('.') || is_dotted_point());
        let key = if is_point { format!("points.{key}") } else { key };
        has_points |= key.starts_with("points.");
        let of_other = columns.as_ref().filter(|_| key.starts_with("points.")).and_then(|columns| {
            let other = columns.of_other_side().filter(|other| has_numbers(&row.cells, Some(other)))?;
            Some((other.values(&row.cells, title_unit.as_ref().map(|(unit, _)| *unit)), other.xyz))
        });
        if let Some((values, xyz)) = of_other {
            // The other side has points of its own.
            let other = format!("points.{}.{}", side.other_word(), key.trim_start_matches("points."));
            let path = Some(shortened(&other));
            entries.add(findings, other.clone(), values, Spot { path, ..spot.clone() });
            entries.set_places(&other, xyz.into_iter().filter_map(|i| row.places.get(i).cloned()).collect());
        }
        let mut values: Vec<Cell> = match columns.as_ref().filter(|_| key.starts_with("points.")) {
            Some(columns) => columns.values(&row.cells, title_unit.as_ref().map(|(unit, _)| *unit)),
            None => row.cells.iter().skip(name + 1).cloned().collect(),
        };
        while values.last().is_some_and(is_blank) {
            values.pop();
        }
        let path = match &spot.path {
            Some(place) => format!("{} ({place})", shortened(&key)),
            None => shortened(&key),
        };
        if key.starts_with("points.") {
            let xyz = columns.as_ref().map_or([1, 2, 3].map(|i| name + i), |columns| columns.xyz);
            let places = xyz.into_iter().filter_map(|i| row.places.get(i).cloned()).collect();
            entries.add(findings, key.clone(), values, Spot { path: Some(path), ..spot });
            entries.set_places(&key, places);
        } else {
            entries.add(findings, key, values, Spot { path: Some(path), ..spot });
        }
    }
    others.report(findings);
    if let Some((first, spot)) = nameless.first() {
        let more = if nameless.len() > 1 {
            format!(", and so do {} more rows", nameless.len() - 1)
        } else {
            String::new()
        };
        let message = format!(
            "the row begins with {first}, which is no name{more}; name, x, y, z are expected, or a row above the points that names \
             the columns (a row that begins with # is a comment)"
        );
        findings.error("wrong-type", spot, message);
    }
    if let Some((unit, spot)) = table_unit.filter(|_| !entries.has("unit")) {
        let spot = Spot { path: Some("unit".to_owned()), ..spot };
        entries.add(findings, "unit".to_owned(), vec![Cell::Text(unit.name().to_owned())], spot);
    }
}

/// Removes empty columns before the first one, a column of section titles before the column of the names, and, of a table without a
/// header, a column of numbers before the names.
fn drop_columns(rows: &mut Vec<TableRow>, findings: &mut Findings) {
    let leading = |row: &TableRow| row.cells.iter().take_while(|cell| is_blank(cell)).count();
    let blank_columns = rows.iter().map(leading).min().unwrap_or_default();
    rows.iter_mut().for_each(|row| row.drop_first(blank_columns));
    let points =
        rows.iter().filter(|row| row.cells.iter().filter(|cell| number_of(cell).is_some()).count() >= 3);
    let mut has_points = false;
    let has_title_column = points.into_iter().all(|row| {
        has_points = true;
        is_blank(&row.cells[0]) && row.cells.get(1).and_then(word_of).is_some()
    });
    if has_points && has_title_column {
        rows.retain(|row| row.cells.iter().skip(1).any(|cell| !is_blank(cell)));
        rows.iter_mut().for_each(|row| row.drop_first(1));
    }
    let is_numbered = |row: &TableRow| {
        let numbers = row.cells.iter().filter(|cell| number_of(cell).is_some()).count();
        numbers >= 4 && number_of(&row.cells[0]).is_some() && row.cells.get(1).and_then(word_of).is_some()
    };
    let has_header = || rows.iter().any(|row| matches!(header::read(&row.cells, Side::Left), Row::Header(_)));
    let is_name_first =
        |row: &TableRow| row.cells.iter().skip(1).filter(|cell| number_of(cell).is_some()).count() >= 3;
    if let Some(first) = rows.iter().find(|row| is_numbered(row))
        && !rows.iter().any(|row| is_name_first(row) && !is_numbered(row))
        && !has_header()
    {
        let message =
            "the column of numbers before the names is not used; a row that names the columns is missing";
        findings.note("columns", &first.spot.clone(), message.to_owned());
        rows.iter_mut().filter(|row| is_numbered(row)).for_each(|row| row.drop_first(1));
    }
}

/// Cells of the coordinates of a row.
fn coordinates<'r>(cells: &'r [Cell], columns: Option<&Columns>) -> impl Iterator<Item = &'r Cell> {
    let xyz = columns.map_or([1, 2, 3], |columns| columns.xyz);
    xyz.into_iter().filter_map(|i| cells.get(i))
}

/// True if all three coordinates are numbers.
fn has_numbers(cells: &[Cell], columns: Option<&Columns>) -> bool {
    coordinates(cells, columns).filter(|cell| number_of(cell).is_some()).count() == 3
}

/// True if a coordinate is a number, or a cell without a usable value.
fn has_number(cells: &[Cell], columns: Option<&Columns>) -> bool {
    coordinates(cells, columns).any(|cell| number_of(cell).is_some() || matches!(cell, Cell::Unreadable(_)))
}

/// True if the first word of a row is the label of a setting, and the row is no header.
fn is_setting(cells: &[Cell]) -> bool {
    cells.iter().find_map(word_of).is_some_and(settings::is_label)
        && !matches!(header::read(cells, Side::Left), Row::Header(_))
}

/// Rows of a table that are no points.
#[derive(Default)]
struct OtherRows {
    settings: Vec<(String, Spot)>,
    unused: Vec<(String, Spot)>,
}

impl OtherRows {
    /// Adds the key that a row states; true if the row is a setting. A key that the sheet has too is not replaced.
    fn read(
        &mut self,
        label: &str,
        row: &TableRow,
        columns: Option<&Columns>,
        unit: Option<LengthUnit>,
        (entries, findings): (&mut Entries, &mut Findings),
    ) -> bool {
        let first = columns.map_or(1, |columns| columns.name + 1);
        let side = columns.map_or(first, |columns| columns.xyz[0]).max(first);
        let cells: Vec<&Cell> =
            row.cells.iter().skip(side).chain(row.cells.iter().take(side).skip(first)).collect();
        let Some((key, value)) = settings::read(label, &cells) else { return false };
        let value = match (value, unit) {
            (Cell::Number(x), Some(unit)) if key.starts_with("wheel.") => {
                Cell::Text(format!("{x} {}", unit.name()))
            }
            (value, _) => value,
        };
        let spot = Spot { path: Some(key.to_owned()), ..row.spot.clone() };
        if key == "unit" {
            return true;
        }
        if entries.has(key) {
            self.unused.push((format!("{} (the sheet has {key})", quoted(label)), spot));
            return true;
        }
        self.settings.push((format!("{} → {key} = {}", quoted(label), value.to_text()), spot.clone()));
        entries.add(findings, key.to_owned(), vec![value], spot);
        true
    }

    /// Reports the rows, each kind in one finding.
    fn report(&self, findings: &mut Findings) {
        let list = |rows: &[(String, Spot)]| {
            let names: Vec<&str> = rows.iter().take(MAX_TITLE_ROWS).map(|(text, _)| &**text).collect();
            format!("{}{}", names.join(", "), if rows.len() > MAX_TITLE_ROWS { ", …" } else { "" })
        };
        if let Some((_, spot)) = self.settings.first() {
            findings.note("settings", spot, format!("rows of the table: {}", list(&self.settings)));
        }
        if let Some((_, spot)) = self.unused.first() {
            let message = format!("rows without coordinates, which are not used: {}", list(&self.unused));
            findings.warning("unused-rows", spot, message);
        }
    }
}

/// Message about a row of words that determines no columns.
fn unclear_header(cells: &[Cell], reason: &str) -> String {
    let words: Vec<String> = cells.iter().filter(|cell| !is_blank(cell)).take(8).map(Cell::to_text).collect();
    format!(
        "the row {} is no header that is understood: {reason}. Name the columns, in the order of the table, by name, x (longitudinal), \
         y (lateral) and z (vertical), each with its unit m, cm, mm or in, or all without one: name, y [mm], x [mm], z [mm]. A title is \
         one cell, or a row that begins with #",
        words.join(", ")
    )
}
