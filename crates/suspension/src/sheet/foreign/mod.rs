//! Hardpoints, and bodies, in the files of other programs, as entries of a sheet.

pub(super) mod adams;
mod explorer;
mod foreign_file;
mod rfactor;
mod yaml;

use super::entries::{Cell, Entries};
use crate::findings::Findings;
use crate::options::ImportOptions;
use crate::units::VehicleAxes;
use foreign_file::ForeignFile;

/// True if the text is a file of another program that is read: YAML of Suspension Explorer, or a suspension of rFactor.
pub(in super::super) fn is_foreign(name: &str, text: &str) -> bool {
    let name = name.to_ascii_lowercase();
    let is_yaml = name.ends_with(".yaml") || name.ends_with(".yml");
    is_yaml && explorer::is_geometry(text) || name.ends_with(".pm") && rfactor::is_suspension(text)
}

/// Reads such a file; `file`: index of the file among those of the import, `part`: the axle of a file with several.
pub(super) fn read(
    (name, text): (&str, &str),
    file: usize,
    options: &ImportOptions,
    part: Option<&str>,
    (entries, findings): (&mut Entries, &mut Findings),
) {
    let given = |entries: &Entries, key: &str| match entries.cells_of(key).as_deref() {
        Some([Cell::Text(word)]) => Some(word.trim().to_owned()),
        _ => None,
    };
    let is_right = given(entries, "side").is_some_and(|side| side == "right");
    let stated = options.axes.or_else(|| VehicleAxes::from_name(&given(entries, "axes")?));
    let mut into = ForeignFile { entries, findings, file, axes: VehicleAxes::ISO, stated, given: Vec::new() };
    if name.to_ascii_lowercase().ends_with(".pm") {
        rfactor::read(text, is_right, part, &mut into);
    } else {
        explorer::read(text, is_right, &mut into);
    }
    into.finish();
}
