//! File of another program on the way into the entries of a sheet.

use crate::findings::{Findings, Spot};
use crate::sheet::entries::{Cell, Entries, Place};
use crate::units::VehicleAxes;
use percuss_formats::reading::shortened;
use percuss_spatial::Vector3;

/// Camber and toe (rad) of the left wheel from its outward spin axis, in the axes of ISO 8855: the axis of R_z(−toe) R_x(−camber) y.
pub(super) fn wheel_angles(outward: Vector3<f64>) -> [f64; 2] {
    let along = outward.normalize();
    [-along.z.asin(), along.x.atan2(along.y)]
}

/// File of another program, on the way into the entries of a sheet. Keys that the sheet states itself are not replaced.
pub(super) struct ForeignFile<'e> {
    pub entries: &'e mut Entries,
    pub findings: &'e mut Findings,
    pub file: usize,
    /// Axes of the file.
    pub axes: VehicleAxes,
    /// Axes of the sheet, if stated.
    pub stated: Option<VehicleAxes>,
    /// Keys of the file that the sheet states too.
    pub given: Vec<String>,
}

impl ForeignFile<'_> {
    pub fn spot(&self, path: &str, at: usize) -> Spot {
        Spot { path: (!path.is_empty()).then(|| shortened(path)), at: Some(at), file: self.file }
    }

    pub fn error(&mut self, code: &'static str, path: &str, at: usize, message: impl Into<String>) {
        self.findings.error(code, &self.spot(path, at), message.into());
    }

    pub fn warning(&mut self, code: &'static str, path: &str, at: usize, message: impl Into<String>) {
        self.findings.warning(code, &self.spot(path, at), message.into());
    }

    pub fn note(&mut self, code: &'static str, message: String) {
        self.findings.note(code, &Spot { file: self.file, ..Spot::default() }, message);
    }

    /// Axes of the sheet.
    pub fn axes_of_sheet(&self) -> VehicleAxes {
        self.stated.unwrap_or(self.axes)
    }

    /// Adds a key, unless the sheet states it.
    pub fn key(&mut self, key: &str, cells: Vec<Cell>, at: usize) {
        if self.entries.has(key) {
            if self.entries.cells_of(key) != Some(cells) {
                self.given.push(key.to_owned());
            }
            return;
        }
        let spot = self.spot(key, at);
        self.entries.add(self.findings, key.to_owned(), cells, spot);
    }

    /// Adds a key with a text, unless the sheet states it.
    pub fn word(&mut self, key: &str, text: &str, at: usize) {
        self.key(key, vec![Cell::Text(text.to_owned())], at);
    }

    /// Adds a point in the unit and the axes of the file.
    pub fn point(&mut self, name: &str, at: [f64; 3], unit: &str, places: Vec<Place>, byte: usize) {
        let at = self.axes_of_sheet().from_iso(self.axes.to_iso(at.into()));
        let cells = [at.x, at.y, at.z].map(|x| Cell::Text(format!("{x} {unit}"))).to_vec();
        let key = format!("points.{name}");
        let spot = self.spot(name, byte);
        self.entries.add(self.findings, key.clone(), cells, spot);
        self.entries.set_places(&key, places);
    }

    /// Adds the unit and the axes, and notes which keys of the file the sheet replaces.
    pub fn finish(mut self) {
        let axes = self.axes_of_sheet();
        for (key, value) in [("unit", "mm".to_owned()), ("axes", axes.name())] {
            let is_stated = self.entries.has(key) || key == "axes" && self.stated.is_some();
            if !is_stated {
                self.word(key, &value, 0);
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
