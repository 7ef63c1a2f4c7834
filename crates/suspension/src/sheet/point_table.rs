//! The table of points that a sheet names, read from the sheet's folder.
//!
//! A sheet may come from somebody else, and messages quote the table: no other folder is read unless the user allows it.

use super::entries::{Cell, Entries};
use super::foreign::{self, adams};
use super::names::NAMES;
use super::{catalogue, table, toml_text};
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

/// File that a sheet names, in the folder of the sheet; `None` after an error. `what`: kind of file, for messages.
pub(super) fn read_beside(
    source: &Source,
    (path, spot): (&str, &Spot),
    what: &str,
    options: &ImportOptions,
    findings: &mut Findings,
) -> Option<(String, Source)> {
    let folder = Path::new(&source.name).parent().unwrap_or(Path::new(""));
    let file = folder.join(path);
    let path = file.to_string_lossy().into_owned();
    let kind = source.files.kind(&file);
    // Reading a pipe or a device could block or never end.
    if kind.as_ref().is_ok_and(|kind| *kind != FileKind::File) {
        findings.error("no-table", spot, format!("{what} {} is no file", quoted(&path)));
        return None;
    }
    if kind.is_ok() && !options.allow_outside && !is_inside(&*source.files, folder, &file) {
        let message = format!(
            "{what} {} is outside the sheet's folder; move it there, or import the sheet with --allow-outside \
             (allow_outside=True in Python)",
            quoted(&path)
        );
        findings.error("outside-folder", spot, message);
        return None;
    }
    match Source::read_from(&source.files, &path, DEFAULT_MAX_SIZE) {
        Ok(read) => Some((path, read)),
        Err(error) => {
            let why = error.diagnostics.first().map_or(String::new(), |d| d.message.clone());
            findings.error("no-table", spot, format!("{what} {}: {why}", quoted(&path)));
            None
        }
    }
}

/// Reads the names of points from the file that the sheet or the option names, as entries of the section `names`.
pub(super) fn read_names(
    source: &Source,
    options: &ImportOptions,
    entries: &mut Entries,
    findings: &mut Findings,
    files: &mut Files,
) {
    let of_sheet = entries
        .text(findings, NAMES, "the name of a file of names")
        .and_then(|(path, spot)| read_beside(source, (&path, &spot), "the file of names", options, findings));
    let of_flag = options.names.as_ref().and_then(|path| {
        let read = Source::read_from(&source.files, path, DEFAULT_MAX_SIZE);
        read.map_err(|error| findings.error("no-table", &Spot::default(), format!("--names: {error}")))
            .ok()
            .map(|read| (path.clone(), read))
    });
    for (path, read) in [of_sheet, of_flag].into_iter().flatten() {
        let text = encoding::decode(&read.bytes).text.into_owned();
        let (mut own, file) = (Entries::default(), files.len());
        toml_text::read(&text, file, &mut own, findings);
        files.push((path, text));
        for entry in own.unread() {
            let key = entry.key.strip_prefix("names.").unwrap_or(&entry.key);
            entries.add(findings, format!("{NAMES}.{key}"), entry.cells.clone(), entry.spot.clone());
        }
    }
}

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
    let Some((path, read)) = read_beside(source, (&path, &spot), "the table", options, findings) else {
        return;
    };
    let file = files.len();
    let worksheet = entries.text(findings, "worksheet", "the name of a worksheet");
    let worksheet = options.worksheet.clone().or(worksheet.map(|(name, _)| name));
    if table::is_workbook(&read.bytes) {
        files.push((path, String::new()));
        table::read_workbook(&read.bytes, file, worksheet.as_deref(), entries, findings);
        return;
    }
    let decoded = encoding::decode(&read.bytes);
    if foreign::is_foreign(&path, &decoded.text) {
        let part = worksheet.as_deref();
        foreign::read((&path, &decoded.text), file, options, part, (entries, findings));
        files.push((path, decoded.text.into_owned()));
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
    if let Some(note) = decoded.note {
        findings.note("windows-1252", &Spot { file, ..Spot::default() }, note);
    }
    let text = decoded.text;
    if adams::is_subsystem(&text) {
        read_subsystem(&text, file, options, entries, findings, &spot);
    } else {
        table::read_text(&text, file, entries, findings);
    }
    files.push((path, text.into_owned()));
}

/// Reads the hardpoints of a subsystem of Adams/Car in the axes of the sheet.
fn read_subsystem(
    text: &str,
    file: usize,
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
    if axes != VehicleAxes::ADAMS {
        let message = "the axes of Adams/Car (x backward, y right, z up) are converted to those of the sheet";
        findings.note("adams-axes", &Spot { file, ..Spot::default() }, message.to_owned());
    }
    adams::read(text, file, axes, entries, findings);
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
    if findings.has_errors() {
        return;
    }
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
