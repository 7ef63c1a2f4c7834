//! Hardpoints, and bodies, in the files of other programs, as entries of a sheet.

pub(super) mod adams;
mod explorer;
mod rfactor;
mod yaml;

use super::entries::{Cell, Entries, Place};
use crate::findings::{Findings, Spot};
use crate::options::ImportOptions;
use crate::units::VehicleAxes;
use percuss_formats::reading::shortened;
use percuss_spatial::Vector3;

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

/// Camber and toe (rad) of the left wheel from its outward spin axis, in the axes of ISO 8855: the axis of R_z(−toe) R_x(−camber) y.
fn wheel_angles(outward: Vector3<f64>) -> [f64; 2] {
    let along = outward.normalize();
    [-along.z.asin(), along.x.atan2(along.y)]
}

/// File of another program, on the way into the entries of a sheet. Keys that the sheet states itself are not replaced.
struct ForeignFile<'e> {
    entries: &'e mut Entries,
    findings: &'e mut Findings,
    file: usize,
    /// Axes of the file.
    axes: VehicleAxes,
    /// Axes of the sheet, if stated.
    stated: Option<VehicleAxes>,
    /// Keys of the file that the sheet states too.
    given: Vec<String>,
}

impl ForeignFile<'_> {
    fn spot(&self, path: &str, at: usize) -> Spot {
        Spot { path: (!path.is_empty()).then(|| shortened(path)), at: Some(at), file: self.file }
    }

    fn error(&mut self, code: &'static str, path: &str, at: usize, message: String) {
        self.findings.error(code, &self.spot(path, at), message);
    }

    fn warning(&mut self, code: &'static str, path: &str, at: usize, message: String) {
        self.findings.warning(code, &self.spot(path, at), message);
    }

    fn note(&mut self, code: &'static str, message: String) {
        self.findings.note(code, &Spot { file: self.file, ..Spot::default() }, message);
    }

    /// Axes of the sheet.
    fn axes_of_sheet(&self) -> VehicleAxes {
        self.stated.unwrap_or(self.axes)
    }

    /// Adds a key, unless the sheet states it.
    fn key(&mut self, key: &str, cells: Vec<Cell>, at: usize) {
        if self.entries.has(key) {
            if self.entries.cells_of(key) != Some(cells) {
                self.given.push(key.to_owned());
            }
            return;
        }
        let spot = self.spot(key, at);
        self.entries.add(self.findings, key.to_owned(), cells, spot);
    }

    /// Adds a point in the unit and the axes of the file.
    fn point(&mut self, name: &str, at: [f64; 3], unit: &str, places: Vec<Place>, byte: usize) {
        let at = self.axes_of_sheet().from_iso(self.axes.to_iso(at.into()));
        let cells = [at.x, at.y, at.z].map(|x| Cell::Text(format!("{x} {unit}"))).to_vec();
        let key = format!("points.{name}");
        let spot = self.spot(name, byte);
        self.entries.add(self.findings, key.clone(), cells, spot);
        self.entries.set_places(&key, places);
    }

    /// Adds the unit and the axes, and notes which keys of the file the sheet replaces.
    fn finish(mut self) {
        let axes = self.axes_of_sheet();
        let text = |text: &str| vec![Cell::Text(text.to_owned())];
        for (key, value) in [("unit", "mm".to_owned()), ("axes", axes.name())] {
            let is_stated = self.entries.has(key) || key == "axes" && self.stated.is_some();
            if !is_stated {
                self.key(key, text(&value), 0);
            }
        }
        self.entries.axes_of_file = Some(self.axes);
        if axes != self.axes {
            let message =
                format!("the axes of the file ({}) are converted to those of the sheet", self.axes.words());
            self.note("axes-of-file", message);
        }
        if !self.given.is_empty() {
            let message =
                format!("the sheet states {}; the values of the file are not used", self.given.join(", "));
            self.note("stated-by-sheet", message);
        }
    }
}
