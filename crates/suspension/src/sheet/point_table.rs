//! The table of points that a sheet names, read from the sheet's folder.
//!
//! A sheet may come from somebody else, and messages quote the table: no other folder is read unless the user allows it.

use super::entries::{Cell, Entries};
use super::{adams, catalogue, table};
use crate::corner::design::SEATS;
use crate::findings::{Findings, Spot};
use crate::options::ImportOptions;
use crate::units::VehicleAxes;
use percuss_formats::reading::encoding;
use percuss_formats::reading::quoted;
use percuss_formats::{DEFAULT_MAX_SIZE, FileKind, FileStore, Source};
use std::path::Path;

/// Files of one import: names and texts.
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
    let kind = source.files.kind(&table);
    // Reading a pipe or a device could block or never end.
    if kind.as_ref().is_ok_and(|kind| *kind != FileKind::File) {
        findings.error("no-table", &spot, format!("the table {} is no file", quoted(&path)));
        return;
    }
    if kind.is_ok() && !options.allow_outside && !is_inside(&*source.files, folder, &table) {
        let message = format!(
            "the table {} is outside the sheet's folder; move it there, or import the sheet with --allow-outside \
             (allow_outside=True in Python)",
            quoted(&path)
        );
        findings.error("outside-folder", &spot, message);
        return;
    }
    let read = match Source::read_from(&source.files, &path, DEFAULT_MAX_SIZE) {
        Ok(read) => read,
        Err(error) => {
            let why = error.diagnostics.first().map_or(String::new(), |d| d.message.clone());
            findings.error("no-table", &spot, format!("the table {}: {why}", quoted(&path)));
            return;
        }
    };
    let worksheet = entries.text(findings, "worksheet", "the name of a worksheet");
    let worksheet = options.worksheet.clone().or(worksheet.map(|(name, _)| name));
    if table::is_workbook(&read.bytes) {
        files.push((path, String::new()));
        table::read_workbook(&read.bytes, 1, worksheet.as_deref(), entries, findings);
        return;
    }
    if let Some(worksheet) = worksheet {
        let message = format!(
            "the worksheet {} is given, and the table {} is no workbook",
            quoted(&worksheet),
            quoted(&path)
        );
        findings.error("conflict", &spot, message);
        return;
    }
    if read.bytes.contains(&0) {
        let message = format!("the table {} is no text and no XLSX workbook", quoted(&path));
        findings.error("not-utf-8", &spot, message);
        return;
    }
    let decoded = encoding::decode(&read.bytes);
    if let Some(note) = decoded.note {
        findings.note("windows-1252", &Spot { file: 1, ..Spot::default() }, note);
    }
    let text = decoded.text;
    if adams::is_subsystem(&text) {
        read_subsystem(&text, options, entries, findings, &spot);
    } else {
        table::read_text(&text, 1, entries, findings);
    }
    files.push((path, text.into_owned()));
}

/// Reads the hardpoints of a subsystem of Adams/Car in the axes of the sheet.
fn read_subsystem(
    text: &str,
    options: &ImportOptions,
    entries: &mut Entries,
    findings: &mut Findings,
    spot: &Spot,
) {
    let word =
        |entries: &mut Entries, key: &str| match entries.find(key).as_ref().map(|(cells, _)| &cells[..]) {
            Some([Cell::Text(word)]) => Some(word.trim().to_owned()),
            _ => None,
        };
    if word(entries, "side").is_some_and(|side| side == "right") {
        let message = "a subsystem of Adams/Car describes the left side: write side = \"left\", and build = \"right\" for \
                       the right side";
        findings.error("conflict", spot, message.to_owned());
        return;
    }
    let axes = options.axes.or_else(|| VehicleAxes::from_name(&word(entries, "axes")?)).unwrap_or_default();
    if axes != VehicleAxes::Adams {
        let message = "the axes of Adams/Car (x backward, y right, z up) are converted to those of the sheet";
        findings.note("adams-axes", &Spot { file: 1, ..Spot::default() }, message.to_owned());
    }
    adams::read(text, 1, axes, entries, findings);
}

/// True if a file is in a folder or below it, links resolved.
fn is_inside(files: &dyn FileStore, folder: &Path, file: &Path) -> bool {
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    match (files.canonical(folder), files.canonical(file)) {
        (Ok(folder), Ok(file)) => file.starts_with(folder),
        _ => false,
    }
}

/// True for a plain table of points, without a template and properties of bodies.
pub(super) fn has_points_only(entries: &Entries) -> bool {
    let bodies = catalogue::keys().bodies.iter().map(|(key, _)| &**key);
    let is_headless = !["template", "points"].iter().any(|key| entries.has(key));
    is_headless
        && entries.has_section("points")
        && !bodies.chain(["wheel"]).any(|body| entries.has_section(body))
}

/// Refuses a table without masses; the message states how to use the table.
pub(super) fn refuse_points_only(findings: &mut Findings, source: &Source, options: &ImportOptions) {
    let file = source.name.rsplit(['/', '\\']).next().unwrap_or_default();
    let template = options.template.as_deref().unwrap_or("TEMPLATE");
    let list = if options.template.is_none() { " (percuss template --list)" } else { "" };
    let message = format!(
        "the file has hardpoints and no masses. Write a sheet by `percuss template {template} -o my.toml`{list}, enter the \
         masses, and replace its section [points] by points = {} at the head of the sheet",
        quoted(file)
    );
    findings.error("missing-key", &Spot::default(), message);
}

/// Warns about sections of parts that are not built because their points are missing: their masses and rates have no effect.
pub(super) fn warn_unbuilt_parts(entries: &Entries, findings: &mut Findings) {
    let bar = (&["anti_roll_bar", "drop_link"][..], &catalogue::BAR_POINTS[..]);
    let seats = SEATS.iter().map(|(section, pair)| (std::slice::from_ref(section), &pair[..]));
    for (sections, points) in seats.chain([bar]) {
        // A stop with a gap may be on the damper; without a damper it is an error.
        let has_gap = entries.has(&format!("{}.gap", sections[0]));
        if has_gap || points.iter().any(|point| entries.has(&format!("points.{point}"))) {
            continue;
        }
        let given = sections.iter().map(|section| (section, entries.keys_in(section)));
        let given = given.filter(|(_, keys)| !keys.is_empty());
        let given: Vec<String> =
            given.map(|(section, keys)| format!("[{section}] ({})", keys.join(", "))).collect();
        let spot = sections.iter().find_map(|section| entries.spot_in(&format!("{section}.")));
        if let Some(spot) = spot {
            let message = format!(
                "{}: without effect, because the part is not built. Its points are missing: {}; give them, or delete the section",
                given.join(" and "),
                points.join(", ")
            );
            findings.warning("section-without-points", &spot, message);
        }
    }
}
