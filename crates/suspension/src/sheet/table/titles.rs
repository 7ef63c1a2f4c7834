//! Titles and keys of tables, and comments that are headers.

use super::super::catalogue::{self, HEAD};
use super::super::entries::{Cell, TableRow, parse_number};
use super::header::{self, Row};
use super::settings;
use crate::corner::design::STOPS;
use crate::findings::Spot;
use crate::options::Side;

/// Largest number of title rows.
pub(super) const MAX_TITLE_ROWS: usize = 20;

/// True for a row whose first cell begins with #.
pub(super) fn is_comment(row: &TableRow) -> bool {
    matches!(row.cells.first(), Some(Cell::Text(text)) if text.trim_start().starts_with('#'))
}

/// Makes a comment with a header the header of a worksheet without one. Returns a title that names the axes in another order.
pub(super) fn read_comments(rows: &mut [TableRow]) -> Option<(String, Spot)> {
    let is_header = |cells: &[Cell]| matches!(header::read(cells, Side::Left), Row::Header(_));
    if rows.iter().any(|row| !is_comment(row) && is_header(&row.cells)) {
        return None;
    }
    for row in rows.iter_mut().filter(|row| is_comment(row)) {
        let first = Cell::Text(row.cells[0].to_text().replace(['#', '"'], "").trim().to_owned());
        let cells: Vec<Cell> = std::iter::once(first).chain(row.cells.iter().skip(1).cloned()).collect();
        if is_header(&cells) {
            row.cells = cells;
            return None;
        }
    }
    let mut texts = rows.iter().take(MAX_TITLE_ROWS).map(|row| {
        let words: Vec<String> = row.cells.iter().filter_map(word_of).map(str::to_owned).collect();
        (words.join(" "), row.spot.clone())
    });
    texts.find(|(text, _)| header::names_other_order(text))
}

/// Number of title rows before the header or the first key. A title has no number, and its first cell is no key.
pub(super) fn title_rows(rows: &[TableRow], kinds: &[Row]) -> usize {
    let header = kinds.iter().position(|kind| matches!(kind, Row::Header(_)));
    let is_title = |(i, (row, kind)): &(usize, (&TableRow, &Row))| {
        let is_value = |cell: &Cell| !matches!(cell, Cell::Text(text) if parse_number(text).is_none());
        let is_of_head = || {
            let first = row.cells.iter().find(|cell| !is_blank(cell));
            matches!(first, Some(Cell::Text(first)) if HEAD.contains(&first.trim()) || settings::is_label(first))
        };
        // Words above a header are a title unless they name an axis, a unit or a side.
        let is_words = match kind {
            Row::Other => true,
            Row::Header(_) | Row::Sides => false,
            Row::Unclear { has_parts, .. } => !has_parts && header.is_some_and(|header| *i < header),
        };
        is_words && !is_key(&row.cells) && !is_of_head() && !row.cells.iter().any(is_value)
    };
    let titles = rows.iter().zip(kinds).enumerate().take(MAX_TITLE_ROWS).take_while(is_title).count();
    if titles < rows.len() { titles } else { 0 }
}

/// Text of a cell that is no number and not empty.
pub(super) fn word_of(cell: &Cell) -> Option<&str> {
    match cell {
        Cell::Text(text) if !text.trim().is_empty() && number_of(cell).is_none() => Some(text.trim()),
        _ => None,
    }
}

/// Number of a cell, with or without a unit.
pub(super) fn number_of(cell: &Cell) -> Option<f64> {
    match cell {
        Cell::Number(x) => Some(*x),
        Cell::Text(text) => parse_number(percuss_units::split(text).0),
        Cell::Switch(_) | Cell::Unreadable(_) => None,
    }
}

/// True for an empty cell.
pub(super) fn is_blank(cell: &Cell) -> bool {
    matches!(cell, Cell::Text(text) if text.trim().is_empty())
}

/// True if the first cell is a point or a key of a section; `name` and `points` may also be in a header.
pub(super) fn is_key(cells: &[Cell]) -> bool {
    let Some(Cell::Text(first)) = cells.iter().find(|cell| !is_blank(cell)) else { return false };
    let first = first.trim();
    catalogue::keys().points.iter().any(|(key, _)| key == first)
        || first.split_once('.').is_some_and(|(section, _)| is_section(section))
}

/// True for the name of a section of a sheet.
pub(super) fn is_section(name: &str) -> bool {
    let is_body = || catalogue::keys().bodies.iter().any(|(key, _)| key == name);
    ["points", "wheel", "rack", "spring", "damper"].contains(&name) || STOPS.contains(&name) || is_body()
}
