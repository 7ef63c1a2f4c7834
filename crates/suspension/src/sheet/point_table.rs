//! The table of points that a sheet names, read from the sheet's folder.
//!
//! A sheet may come from somebody else, and messages quote the table: no other folder is read unless the user allows it.

use super::entries::Entries;
use super::table;
use crate::findings::Findings;
use crate::options::ImportOptions;
use percuss_formats::reading::quoted;
use percuss_formats::{DEFAULT_MAX_SIZE, Source};
use std::fs;
use std::path::Path;

/// The files that were read together: their names and texts.
pub(in super::super) type Files = Vec<(String, String)>;

/// Table of points named by the sheet.
pub(super) fn read(
    source: &Source,
    options: &ImportOptions,
    entries: &mut Entries,
    findings: &mut Findings,
    files: &mut Files,
) {
    let Some((path, spot)) = entries.text(findings, "points", "the name of a table of points") else {
        return;
    };
    let folder = Path::new(&source.name).parent().unwrap_or(Path::new(""));
    let table = folder.join(&path);
    let path = table.to_string_lossy().into_owned();
    let kind = fs::metadata(&table);
    // A pipe or a device could wait, or not end.
    if kind.as_ref().is_ok_and(|found| !found.is_file()) {
        findings.error("no-table", &spot, format!("the table {} is no file", quoted(&path)));
        return;
    }
    if kind.is_ok() && !options.allow_outside && !is_inside(folder, &table) {
        let message = format!(
            "the table {} is outside the sheet's folder; move it there, or import the sheet with --allow-outside \
             (allow_outside=True in Python)",
            quoted(&path)
        );
        findings.error("outside-folder", &spot, message);
        return;
    }
    let read = match Source::read(&path, DEFAULT_MAX_SIZE) {
        Ok(read) => read,
        Err(error) => {
            let why = error.diagnostics.first().map_or(String::new(), |d| d.message.clone());
            findings.error("no-table", &spot, format!("the table {}: {why}", quoted(&path)));
            return;
        }
    };
    if table::is_workbook(&read.bytes) {
        files.push((path, String::new()));
        table::read_workbook(&read.bytes, 1, entries, findings);
        return;
    }
    match std::str::from_utf8(read.bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(&read.bytes)) {
        Ok(text) => {
            table::read_text(text, 1, entries, findings);
            files.push((path, text.to_owned()));
        }
        Err(_) => {
            let message = format!("the table {} is no UTF-8 text and no XLSX workbook", quoted(&path));
            findings.error("not-utf-8", &spot, message);
        }
    }
}

/// True if a file is in a folder or below it, links resolved.
fn is_inside(folder: &Path, file: &Path) -> bool {
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    match (fs::canonicalize(folder), fs::canonicalize(file)) {
        (Ok(folder), Ok(file)) => file.starts_with(folder),
        _ => false,
    }
}
