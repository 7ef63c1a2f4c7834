//! Reader of the entries of a sheet in TOML.

use super::entries::{Cell, Entries, Place};
use super::sections::bush_file::BUSH;
use super::sections::contacts::CONTACT;
use crate::findings::{Findings, Spot};
use crate::limits::MAX_SHEET_BYTES;
use percuss_formats::reading::LONGEST_NAME;
use percuss_formats::reading::shortened;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Reads the text; false after a TOML error in the report. `file`: index of the file among the files of the import.
pub(super) fn read(text: &str, file: usize, entries: &mut Entries, findings: &mut Findings) -> bool {
    if text.len() > MAX_SHEET_BYTES {
        let message = format!("a sheet of {} bytes; at most {MAX_SHEET_BYTES} are read", text.len());
        findings.error("too-large-file", &Spot { file, ..Spot::default() }, message);
        return false;
    }
    let table = match DeTable::parse(text) {
        Ok(table) => table.into_inner(),
        Err(error) => {
            let spot = Spot { at: error.span().map(|span| span.start), file, ..Spot::default() };
            let message = format!("not TOML: {}", shortened(error.message()));
            findings.error("not-toml", &spot, message);
            return false;
        }
    };
    let mut found: Vec<(usize, String, &Spanned<DeValue<'_>>)> = Vec::new();
    for (key, value) in &table {
        let inner = value.get_ref().as_table().into_iter().flat_map(|section| section.keys());
        let longest = inner.map(|key| key.get_ref().len()).max().unwrap_or(0).max(key.get_ref().len());
        if longest > LONGEST_NAME {
            let spot = Spot { at: Some(key.span().start), file, ..Spot::default() };
            let message = format!("a key of {longest} bytes; at most {LONGEST_NAME} are expected");
            findings.error("too-complex", &spot, message);
            return false;
        }
        match value.get_ref() {
            DeValue::Table(section) => {
                for (inner, value) in section {
                    let name = format!("{}.{}", key.get_ref(), inner.get_ref());
                    match value.get_ref() {
                        DeValue::Table(named)
                            if [CONTACT, BUSH].contains(&&**key.get_ref())
                                || ["points.left", "points.right"].contains(&&*name) =>
                        {
                            for (last, value) in named {
                                found.push((last.span().start, format!("{name}.{}", last.get_ref()), value));
                            }
                        }
                        _ => found.push((inner.span().start, name, value)),
                    }
                }
            }
            _ => found.push((key.span().start, key.get_ref().to_string(), value)),
        }
    }
    // Order of the file; the parser sorts keys alphabetically.
    found.sort_by_key(|(at, ..)| *at);
    for (at, key, value) in found {
        let spot = Spot { path: Some(shortened(&key)), at: Some(at), file };
        match cells(value.get_ref()) {
            Some(cells) => {
                entries.add(findings, key.clone(), cells, spot);
                if let DeValue::Array(list) = value.get_ref() {
                    entries.set_places(&key, list.iter().map(|value| Place::Text(value.span())).collect());
                }
            }
            None => {
                let expected = "a number, a text, true or false, or a list of numbers";
                findings.error("wrong-type", &spot, format!("{expected} is expected"));
            }
        }
    }
    true
}

/// Values of a key, which is a list or one value; `None` for an unsupported type.
fn cells(value: &DeValue<'_>) -> Option<Vec<Cell>> {
    match value {
        DeValue::Array(list) => list.iter().map(|value| cell(value.get_ref())).collect(),
        value => Some(vec![cell(value)?]),
    }
}

/// One value; `None` for an unsupported type.
fn cell(value: &DeValue<'_>) -> Option<Cell> {
    match value {
        DeValue::String(text) => Some(Cell::Text(text.to_string())),
        // Rust parses both notations. Numbers out of range are refused with the other invalid numbers.
        DeValue::Integer(number) if number.radix() == 10 => Some(Cell::Number(number.as_str().parse().ok()?)),
        DeValue::Float(number) => Some(Cell::Number(number.as_str().parse().ok()?)),
        DeValue::Boolean(on) => Some(Cell::Switch(*on)),
        DeValue::Integer(_) | DeValue::Datetime(_) | DeValue::Array(_) | DeValue::Table(_) => None,
    }
}
