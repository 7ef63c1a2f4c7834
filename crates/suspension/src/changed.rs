//! File of a suspension with moved hardpoints: only the numbers of these points change.

use crate::chrono::Reader;
use crate::findings::Findings;
use crate::options::ImportOptions;
use crate::sheet::{self, Place, WrittenPoint};
use crate::units::Frame;
use percuss_formats::reading::Report;
use percuss_formats::reading::quoted;
use percuss_formats::{DEFAULT_MAX_SIZE, Source};
use percuss_spatial::Vector3;

/// File with changed coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct ChangedFile {
    /// Name of the file that was read: the sheet, or the table with its points.
    pub name: String,
    /// Content with the new coordinates, in the same format: order, comments and all other values as read.
    pub bytes: Vec<u8>,
}

/// File that contains the hardpoints of a sheet, with the points moved (m, in the axes of the sheet and on the side of its points).
///
/// The file is the sheet itself (TOML, CSV, XLSX, JSON of Chrono::Vehicle, YAML, `.pm`) or the table that it names (also `.sub` of Adams/Car).
/// A coordinate keeps its unit and its decimal mark; numbers have at most thirteen significant digits. Of a table with columns of both
/// sides, those of the side of the sheet change. Texts that were not UTF-8 are written in UTF-8.
///
/// # Errors
/// The reason, in words: a sheet that cannot be read; a point without a number of its own in the file (a wheel centre from the half track, an
/// axis from one point); two points that are one point of the file; a point that the file repeats with other digits; a cell of a workbook with a formula or a text.
pub fn changed_file(
    source: &Source,
    options: &ImportOptions,
    moves: &[(String, [f64; 3])],
) -> Result<ChangedFile, String> {
    let (mut findings, mut files, mut report) = (Findings::default(), sheet::Files::new(), Report::default());
    let decoded = if sheet::is_workbook(&source.bytes) {
        None
    } else {
        Some(crate::reading::decode(source, &mut report).ok_or("the file is no text and no workbook")?.text)
    };
    let text = decoded.as_deref().unwrap_or_default();
    let (written, axes, frame, worksheet, mirrored) = if decoded.is_some()
        && crate::reading::is_json(source, text)
    {
        files.push((source.name.clone(), text.to_owned()));
        let clean = crate::text::blank_comments(text).map_err(|defect| defect.message.to_owned())?;
        let frame = Frame { unit: options.unit.unwrap_or_default(), axes: options.axes.unwrap_or_default() };
        let mut reader = Reader::new(&clean, frame, &[]);
        crate::read_chrono(&mut reader, source, &ImportOptions { moves: Vec::new(), ..options.clone() });
        (reader.written, frame.axes, frame, None, Vec::new())
    } else {
        let read = sheet::read(source, text, options, &mut findings, &mut files);
        let read = read.ok_or("the file is no sheet and no table that can be read")?;
        let mirrored = read.mirrored.iter().map(|name| (*name, read.points_side.other_word())).collect();
        (read.written.0, read.written.1, read.frame, read.worksheet, mirrored)
    };
    // The mirror image that the file has too moves with its point.
    let mirror_image = |(name, by): &(String, [f64; 3])| {
        let (_, word) = mirrored.iter().find(|(known, _)| known == name)?;
        let by = frame.axes.to_iso(Vector3::from(*by));
        let by = frame.axes.from_iso(Vector3::new(by.x, 0.0 - by.y, by.z));
        Some((format!("{word}.{name}"), by.into()))
    };
    let moves: Vec<(String, [f64; 3])> =
        moves.iter().flat_map(|moved| [Some(moved.clone()), mirror_image(moved)]).flatten().collect();
    // Place, old and new number.
    let mut changes: Vec<(Place, f64, f64)> = Vec::new();
    let mut changed_index = None;
    for (name, by) in moves.iter().filter(|(_, by)| *by != [0.0; 3]) {
        let point = written.iter().find(|point| point.name == *name);
        let point = point.ok_or_else(|| format!("{name} has no coordinates of its own in the file"))?;
        let shift_of =
            |name: &str| moves.iter().find(|(known, _)| known == name).map_or([0.0; 3], |(_, by)| *by);
        let is_same =
            |other: &&WrittenPoint| other.numbers[0].2 == point.numbers[0].2 && other.file == point.file;
        if let Some(twin) = written.iter().filter(is_same).find(|other| shift_of(&other.name) != *by) {
            return Err(format!("{name} and {} are one point of the file: move both by the same", twin.name));
        }
        if *changed_index.get_or_insert(point.file) != point.file {
            return Err("the moved points are in several files".to_owned());
        }
        let by = axes.from_iso(frame.axes.to_iso(Vector3::from(*by)));
        for (k, (number, unit, places)) in point.numbers.iter().enumerate().filter(|(k, _)| by[*k] != 0.0) {
            for place in places {
                let change = (place.clone(), *number, rounded(number + by[k] / unit));
                if !changes.contains(&change) {
                    changes.push(change);
                }
            }
        }
    }
    let index = changed_index.unwrap_or_default();
    let (name, text) = files.get(index).cloned().unwrap_or_default();
    let is_text = changes.iter().all(|(place, ..)| matches!(place, Place::Text(_)));
    let bytes = if is_text && !text.is_empty() {
        changed_text(&text, changes)?.into_bytes()
    } else if index == 0 {
        sheet::changed_workbook(&source.bytes, worksheet.as_deref(), &changes)?
    } else {
        let table = Source::read_from(&source.files, &name, DEFAULT_MAX_SIZE);
        let table = table.map_err(|error| format!("{}: {error}", quoted(&name)))?;
        sheet::changed_workbook(&table.bytes, worksheet.as_deref(), &changes)?
    };
    Ok(ChangedFile { name, bytes })
}

/// Text with other numbers at some places.
fn changed_text(text: &str, changes: Vec<(Place, f64, f64)>) -> Result<String, String> {
    let mut places = Vec::new();
    for (place, old, new) in changes {
        if let Place::Text(range) = place {
            places.push((range, old, new));
        }
    }
    places.sort_by_key(|(range, ..)| std::cmp::Reverse(range.start));
    let mut changed = text.to_owned();
    for (range, old, new) in places {
        let value = text.get(range.clone()).unwrap_or_default();
        let (digits, _) = percuss_units::split(value.trim().trim_matches('"').trim());
        // Notations such as 1_000 are not replaced in part.
        let is_old = digits.replace(',', ".").parse() == Ok(old);
        let begin = value.find(digits).filter(|_| is_old);
        let begin =
            range.start + begin.ok_or_else(|| format!("{} is no plain number in the file", quoted(value)))?;
        let number = format!("{new:?}");
        let number = if digits.contains(',') { number.replace('.', ",") } else { number };
        changed.replace_range(begin..begin + digits.len(), &number);
    }
    Ok(changed)
}

/// Number with thirteen significant digits: the last digits of a sum of coordinates are rounding errors.
fn rounded(x: f64) -> f64 {
    format!("{x:.12e}").parse().unwrap_or(x)
}
