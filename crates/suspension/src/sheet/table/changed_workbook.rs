//! Workbook with other numbers in some cells of a worksheet; all other parts are copied as they are.

use super::workbook::{address, check_workbook};
use crate::sheet::entries::Place;
use percuss_formats::reading::quoted;
use roxmltree::{Document, Node};
use std::io::{Cursor, Read, Write};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipArchive, ZipWriter};

type Archive<'b> = ZipArchive<Cursor<&'b [u8]>>;

/// Changes the numbers of cells: place, old and new number; `worksheet`: its name, `None` for the first one.
///
/// # Errors
/// The reason, in words: an invalid workbook; a cell with a formula or without a number.
pub(in super::super) fn changed_workbook(
    bytes: &[u8],
    worksheet: Option<&str>,
    changes: &[(Place, f64, f64)],
) -> Result<Vec<u8>, String> {
    check_workbook(bytes)?;
    let mut archive = ZipArchive::new(Cursor::new(bytes)).map_err(|error| error.to_string())?;
    let part = path_of_worksheet(&mut archive, worksheet)?;
    let text = text_of(&mut archive, &part)?;
    let changed = with_numbers(&text, changes)?;
    let mut out = ZipWriter::new(Cursor::new(Vec::new()));
    for index in 0..archive.len() {
        let file = archive.by_index_raw(index).map_err(|error| error.to_string())?;
        let is_changed = file.name().is_ok_and(|name| name == part);
        let done = if is_changed {
            let options = SimpleFileOptions::default().compression_method(CompressionMethod::Deflated);
            out.start_file(&*part, options).and_then(|()| Ok(out.write_all(changed.as_bytes())?))
        } else {
            out.raw_copy_file(file)
        };
        done.map_err(|error| error.to_string())?;
    }
    Ok(out.finish().map_err(|error| error.to_string())?.into_inner())
}

/// Text of a part.
fn text_of(archive: &mut Archive<'_>, name: &str) -> Result<String, String> {
    let (mut text, mut file) = (String::new(), archive.by_name(name).map_err(|error| error.to_string())?);
    file.read_to_string(&mut text).map_err(|error| error.to_string())?;
    Ok(text)
}

/// Children with this local name, at any depth.
fn named<'a, 'i>(document: &'a Document<'i>, name: &'a str) -> impl Iterator<Item = Node<'a, 'i>> {
    document.descendants().filter(move |node| node.tag_name().name() == name)
}

/// Attribute by its local name.
fn attribute<'a>(node: &Node<'a, '_>, name: &str) -> Option<&'a str> {
    node.attributes().find(|attribute| attribute.name() == name).map(|attribute| attribute.value())
}

/// Path of the part of a worksheet.
fn path_of_worksheet(archive: &mut Archive<'_>, worksheet: Option<&str>) -> Result<String, String> {
    let missing = || "the workbook has no such worksheet".to_owned();
    let text = text_of(archive, "xl/workbook.xml")?;
    let workbook = Document::parse(&text).map_err(|error| error.to_string())?;
    let is_wanted =
        |sheet: &Node<'_, '_>| worksheet.is_none_or(|name| attribute(sheet, "name") == Some(name));
    let sheet = named(&workbook, "sheet").find(is_wanted).ok_or_else(missing)?;
    let id = attribute(&sheet, "id").ok_or_else(missing)?.to_owned();
    let text = text_of(archive, "xl/_rels/workbook.xml.rels")?;
    let relations = Document::parse(&text).map_err(|error| error.to_string())?;
    let relation = named(&relations, "Relationship").find(|relation| attribute(relation, "Id") == Some(&id));
    let target = relation.as_ref().and_then(|relation| attribute(relation, "Target")).ok_or_else(missing)?;
    Ok(match target.strip_prefix('/') {
        Some(absolute) => absolute.to_owned(),
        None => format!("xl/{target}"),
    })
}

/// Text of a worksheet with other numbers.
fn with_numbers(text: &str, changes: &[(Place, f64, f64)]) -> Result<String, String> {
    let document = Document::parse(text).map_err(|error| error.to_string())?;
    let mut edits = Vec::new();
    for (place, _, new) in changes {
        let Place::Cell(row, column) = place else { continue };
        let at = address(*row, *column);
        let cell = named(&document, "c").find(|cell| attribute(cell, "r") == Some(&at));
        let child =
            |name: &str| cell.and_then(|cell| cell.children().find(|node| node.tag_name().name() == name));
        let kind = cell.and_then(|cell| attribute(&cell, "t")).unwrap_or("n");
        let value = child("v").and_then(|value| value.first_child()).filter(|node| node.is_text());
        match value {
            Some(value) if kind == "n" && child("f").is_none() => {
                edits.push((value.range(), format!("{new}")))
            }
            _ => {
                let why = if child("f").is_some() { "has a formula" } else { "is no number" };
                return Err(format!("the cell {} {why}: enter the number", quoted(&at)));
            }
        }
    }
    edits.sort_by_key(|(range, _)| std::cmp::Reverse(range.start));
    let mut changed = text.to_owned();
    edits.into_iter().for_each(|(range, number)| changed.replace_range(range, &number));
    Ok(changed)
}
