//! Keys and values of a sheet or table, independent of the file format: numbers with units, texts, points.

mod forces;

use super::catalogue::near_keys;
use crate::findings::{Findings, Spot};
use crate::limits::MAX_SHEET_KEYS;
use crate::options::Side;
use crate::units::{Frame, VehicleAxes, short};
use percuss_formats::reading::{quoted, shortened};
use percuss_spatial::Vector3;
use percuss_units::{Dimension, LengthUnit, Unit};
use std::ops::Range;

/// Single value.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Cell {
    Number(f64),
    Text(String),
    Switch(bool),
    /// Cell of a workbook without a usable value; the text contains its address, the reason and the remedy.
    #[cfg_attr(not(feature = "xlsx"), allow(dead_code, reason = "only workbooks have such cells"))]
    Unreadable(String),
}

impl Cell {
    /// Text of the value for a message.
    pub fn to_text(&self) -> String {
        match self {
            Cell::Number(x) => format!("{x}"),
            Cell::Text(text) => quoted(text),
            Cell::Switch(x) => format!("{x}"),
            Cell::Unreadable(reason) => reason.clone(),
        }
    }
}

/// Place of a value in its file.
#[derive(Clone, Debug, PartialEq)]
pub(in super::super) enum Place {
    /// Bytes of the text.
    Text(Range<usize>),
    /// Row and column of a worksheet, from 0.
    #[cfg_attr(not(feature = "xlsx"), allow(dead_code, reason = "only workbooks have such places"))]
    Cell(u32, u32),
}

/// Row of a table.
pub(super) struct TableRow {
    pub cells: Vec<Cell>,
    /// Place of each cell.
    pub places: Vec<Place>,
    pub spot: Spot,
}

impl TableRow {
    /// Removes the first cells.
    pub fn drop_first(&mut self, count: usize) {
        drop(self.cells.drain(..count));
        drop(self.places.drain(..count));
    }
}

/// Hardpoint as written in a file.
#[derive(Clone, Debug)]
pub(in super::super) struct WrittenPoint {
    /// Name; of a point of the other side `right.NAME` or `left.NAME`.
    pub name: String,
    /// Index of the file among those of the import.
    pub file: usize,
    /// Each coordinate: number, length of its unit (m), its places: several if the file repeats the point.
    pub numbers: [(f64, f64, Vec<Place>); 3],
}

impl WrittenPoint {
    /// Same point with the numbers of the file: they were converted from the axes of the file to those of the sheet.
    pub fn in_axes(self, sheet: VehicleAxes, file: VehicleAxes) -> Self {
        let numbers = Vector3::from(self.numbers.each_ref().map(|(number, ..)| *number));
        let of_file = file.from_iso(sheet.to_iso(numbers));
        let [x, y, z] = self.numbers;
        let numbers = [(of_file.x, x.1, x.2), (of_file.y, y.1, y.2), (of_file.z, z.1, z.2)];
        Self { numbers, ..self }
    }
}

/// Key with its values.
#[derive(Clone, Debug)]
pub(super) struct Entry {
    /// `section.key`, or a key of the head.
    pub key: String,
    pub cells: Vec<Cell>,
    pub spot: Spot,
    /// Place of each value, of a repeated point again for each repetition; empty if unknown.
    places: Vec<Place>,
    used: bool,
}

/// All entries of a sheet.
#[derive(Default)]
pub(super) struct Entries {
    list: Vec<Entry>,
    /// Keys of the template; empty before the template is known.
    known: Vec<String>,
    /// Name of the worksheet of the points.
    pub worksheet: Option<String>,
    /// Axes of the points in their file, if they are not those of the sheet.
    pub axes_of_file: Option<VehicleAxes>,
    /// Header of a table that names directions of the vehicle in place of x, y, z.
    pub directions: Option<Spot>,
    /// True if masses, centres of mass and inertias may be missing.
    pub masses_optional: bool,
    /// Those that are missing: key, message, place.
    pub missing_masses: Vec<(String, String, Spot)>,
}

/// Quantity of a number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Quantity {
    /// Length; the unit applies to values without a unit.
    Length(LengthUnit),
    /// Mass; kg for values without a unit.
    Mass,
    /// Inertia; the unit applies to values without a unit.
    Inertia(&'static Unit),
    /// Angle; the unit deg or rad is mandatory.
    Angle,
    /// Component of a direction, without unit.
    Component,
    /// Stiffness; the unit is mandatory.
    Stiffness,
    /// Stiffness about an axis; the unit is mandatory.
    RotationalStiffness,
    /// Damping about an axis; the unit is mandatory.
    RotationalDamping,
    /// Force; N for values without a unit.
    Force,
    /// Moment of a force; N·m for values without a unit.
    Moment,
    /// Speed; m/s for values without a unit.
    Speed,
    /// Damping; the unit is mandatory.
    Damping,
}

impl Quantity {
    fn dimension(self) -> Dimension {
        match self {
            Quantity::Length(_) => Dimension::Length,
            Quantity::Mass => Dimension::Mass,
            Quantity::Inertia(_) => Dimension::Inertia,
            Quantity::Angle => Dimension::Angle,
            Quantity::Component => Dimension::Plain,
            Quantity::Stiffness => Dimension::Stiffness,
            Quantity::RotationalStiffness => Dimension::RotationalStiffness,
            Quantity::RotationalDamping => Dimension::RotationalDamping,
            Quantity::Force => Dimension::Force,
            Quantity::Moment => Dimension::Moment,
            Quantity::Speed => Dimension::Speed,
            Quantity::Damping => Dimension::Damping,
        }
    }

    /// Description of a valid value, for messages.
    fn expected(self) -> String {
        match self {
            Quantity::Length(unit) => format!("a length in {0}, such as 12.5 or \"12.5 {0}\"", unit.name()),
            Quantity::Mass => "a mass in kg, such as 3.2 or \"3.2 kg\"".to_owned(),
            Quantity::Inertia(_) => "an inertia, such as 0.05".to_owned(),
            Quantity::Angle => "an angle with its unit, such as \"-1.5 deg\"".to_owned(),
            Quantity::Component => "a number without unit, such as 0.5".to_owned(),
            Quantity::Stiffness => "a stiffness with its unit, such as \"28 N/mm\"".to_owned(),
            Quantity::RotationalStiffness => {
                "a torsional stiffness with its unit, such as \"12 N·m/deg\"".to_owned()
            }
            Quantity::RotationalDamping => "a damping with its unit, such as \"2 N·m·s/rad\"".to_owned(),
            Quantity::Moment => "a moment in N·m, such as 12 or \"12 N·m\"".to_owned(),
            Quantity::Force => "a force in N, such as 3200 or \"3.2 kN\"".to_owned(),
            Quantity::Speed => "a speed in m/s, such as 0.1 or \"100 mm/s\"".to_owned(),
            Quantity::Damping => "a damping with its unit, such as \"1500 N·s/m\"".to_owned(),
        }
    }

    /// Value in SI units; `None` if the cell is not of this quantity.
    fn value(self, cell: &Cell) -> Option<f64> {
        let (number, unit) = match cell {
            Cell::Number(number) => (*number, ""),
            Cell::Text(text) => {
                let (digits, unit) = percuss_units::split(text);
                (parse_number(digits)?, unit)
            }
            Cell::Switch(_) | Cell::Unreadable(_) => return None,
        };
        let value = match (self, unit) {
            (Quantity::Length(default), "") => default.to_metres(number),
            (
                Quantity::Mass | Quantity::Component | Quantity::Force | Quantity::Moment | Quantity::Speed,
                "",
            ) => number,
            (Quantity::Inertia(default), "") => default.to_si(number),
            (
                Quantity::Angle
                | Quantity::Stiffness
                | Quantity::RotationalStiffness
                | Quantity::Damping
                | Quantity::RotationalDamping,
                "",
            ) => return None,
            (_, unit) => Unit::named(unit, &[self.dimension()])?.to_si(number),
        };
        value.is_finite().then_some(value)
    }
}

/// Parses a number with a decimal point or a decimal comma.
pub(super) fn parse_number(text: &str) -> Option<f64> {
    let text = text.trim();
    if text.is_empty() || !text.ends_with(|c: char| c.is_ascii_digit() || c == '.') {
        return None;
    }
    let value = match (text.matches(',').count(), text.contains('.')) {
        (0, _) => text.parse::<f64>().ok()?,
        (1, false) => text.replace(',', ".").parse::<f64>().ok()?,
        _ => return None,
    };
    value.is_finite().then_some(value)
}

impl Entries {
    /// Adds a key; a repeated key, or one beyond the limit, is an error.
    pub fn add(&mut self, findings: &mut Findings, key: String, cells: Vec<Cell>, spot: Spot) {
        if self.list.len() == MAX_SHEET_KEYS {
            findings.error("too-complex", &Spot::default(), format!("more than {MAX_SHEET_KEYS} keys"));
        } else if self.list.len() > MAX_SHEET_KEYS {
            return;
        }
        if self.has(&key) {
            findings.error("duplicate-key", &spot, format!("{key} is given twice"));
            return;
        }
        self.list.push(Entry { key, cells, spot, places: Vec::new(), used: false });
    }

    /// Sets the places of the values of a key.
    pub fn set_places(&mut self, key: &str, places: Vec<Place>) {
        if let Some(entry) = self.list.iter_mut().find(|entry| entry.key == key) {
            entry.places = places;
        }
    }

    /// Places of the values of a key.
    pub fn places_of(&self, key: &str) -> Vec<Place> {
        self.list.iter().find(|entry| entry.key == key).map_or_else(Vec::new, |entry| entry.places.clone())
    }

    /// Hardpoint as written; `None` if its numbers have no place in a file. `unit`: unit of numbers without one.
    pub fn written_point(&self, name: &str, unit: LengthUnit) -> Option<WrittenPoint> {
        let entry = self.list.iter().find(|entry| entry.key.strip_prefix("points.") == Some(name))?;
        let number = |k: usize| {
            let (number, metres) = match entry.cells.get(k)? {
                Cell::Number(number) => (*number, unit.to_metres(1.0)),
                Cell::Text(text) => {
                    let (digits, own) = percuss_units::split(text);
                    let metres = match own {
                        "" => unit.to_metres(1.0),
                        own => Unit::named(own, &[Dimension::Length])?.to_si(1.0),
                    };
                    (parse_number(digits)?, metres)
                }
                Cell::Switch(_) | Cell::Unreadable(_) => return None,
            };
            let places: Vec<Place> = entry.places.iter().skip(k).step_by(3).cloned().collect();
            (!places.is_empty()).then_some((number, metres, places))
        };
        Some(WrittenPoint {
            name: name.to_owned(),
            file: entry.spot.file,
            numbers: [number(0)?, number(1)?, number(2)?],
        })
    }

    /// True if the key exists.
    pub fn has(&self, key: &str) -> bool {
        self.list.iter().any(|e| e.key == key)
    }

    /// True if a key of this section exists.
    pub fn has_section(&self, section: &str) -> bool {
        self.list.iter().any(|e| e.key.split_once('.').is_some_and(|(head, _)| head == section))
    }

    /// Names of the keys of a section.
    pub fn keys_in(&self, section: &str) -> Vec<&str> {
        let keys = self.list.iter().filter_map(|entry| entry.key.split_once('.'));
        keys.filter(|(head, _)| *head == section).map(|(_, key)| key).collect()
    }

    /// Place of the first key that begins with `prefix`.
    pub fn spot_in(&self, prefix: &str) -> Option<Spot> {
        self.list.iter().find(|entry| entry.key.starts_with(prefix)).map(|entry| entry.spot.clone())
    }

    /// Names of the sections `HEAD.NAME`, each once, with the place of the first key.
    pub fn sections_of(&self, head: &str) -> Vec<(String, Spot)> {
        let mut names: Vec<(String, Spot)> = Vec::new();
        for entry in &self.list {
            let section = entry.key.rsplit_once('.').and_then(|(section, _)| section.split_once('.'));
            let Some((_, name)) = section.filter(|(of, _)| *of == head) else { continue };
            if names.iter().all(|(known, _)| known != name) {
                names.push((name.to_owned(), entry.spot.clone()));
            }
        }
        names
    }

    /// Values of a key as written, for messages; empty if absent.
    pub fn given(&self, key: &str) -> String {
        self.list
            .iter()
            .find(|entry| entry.key == key)
            .map_or_else(String::new, |entry| cells_text(&entry.cells))
    }

    /// Values of a key.
    pub fn cells_of(&self, key: &str) -> Option<Vec<Cell>> {
        self.list.iter().find(|e| e.key == key).map(|e| e.cells.clone())
    }

    /// Values of a key; marks the key as read.
    pub fn find(&mut self, key: &str) -> Option<(Vec<Cell>, Spot)> {
        let entry = self.list.iter_mut().find(|e| e.key == key)?;
        entry.used = true;
        Some((entry.cells.clone(), entry.spot.clone()))
    }

    /// Keys that were not read.
    pub fn unread(&self) -> impl Iterator<Item = &Entry> {
        self.list.iter().filter(|e| !e.used)
    }

    /// Renames a key; nothing happens if the key is absent.
    pub fn rename(&mut self, key: &str, new_key: &str) {
        if let Some(entry) = self.list.iter_mut().find(|e| e.key == key) {
            entry.key = new_key.to_owned();
        }
    }

    /// Sets the keys that the template has; only other keys are suggested in place of a missing key.
    pub fn set_known_keys(&mut self, keys: Vec<String>) {
        self.known = keys;
    }

    /// Reports a missing key, with the most similar key of the sheet that the template does not have. Missing masses, centres of mass and
    /// inertias are collected.
    pub fn missing(&mut self, findings: &mut Findings, key: &str, expected: &str) {
        let mut message = format!("the key is missing; {expected} is expected");
        let unknown =
            self.unread().map(|e| e.key.as_str()).filter(|key| !self.known.iter().any(|k| k == key));
        if let Some(near) = near_keys(key, unknown).first() {
            message.push_str(&format!("; is {} this key, misspelled?", quoted(near)));
        }
        // The place of the other keys of the section.
        let section = key.rsplit_once('.').map(|(section, _)| format!("{section}."));
        let place = section.and_then(|section| self.spot_in(&section)).unwrap_or_default();
        let spot = Spot { path: Some(shortened(key)), ..place };
        if [".mass", ".com", ".inertia"].iter().any(|end| key.ends_with(end)) {
            self.missing_masses.push((key.to_owned(), message, spot));
        } else {
            findings.error("missing-key", &spot, message);
        }
    }

    /// Reports the missing masses unless they are optional: many of them in one error. Returns their keys.
    pub fn report_missing_masses(&mut self, findings: &mut Findings) -> Vec<String> {
        const MOST: usize = 2;
        let missing = std::mem::take(&mut self.missing_masses);
        let keys: Vec<String> = missing.iter().map(|(key, ..)| key.clone()).collect();
        if self.masses_optional {
            return keys;
        }
        match &missing[..] {
            [(_, _, first), ..] if missing.len() > MOST => {
                let message = format!(
                    "{} masses of bodies are missing: {}. Give them (0 kg is legal), or write masses = \"estimate\" in the head for estimates \
                     from the size of each part; percuss kinematics needs no masses",
                    keys.len(),
                    keys.join(", ")
                );
                findings.error(
                    "missing-key",
                    &Spot { path: Some("masses".to_owned()), ..first.clone() },
                    message,
                );
            }
            few => {
                few.iter().for_each(|(_, message, spot)| findings.error("missing-key", spot, message.clone()))
            }
        }
        keys
    }

    /// Reads a text; `None` if absent or, with an error, if of another type.
    pub fn text(&mut self, findings: &mut Findings, key: &str, expected: &str) -> Option<(String, Spot)> {
        let (cells, spot) = self.find(key)?;
        match &cells[..] {
            [Cell::Text(text)] => Some((text.trim().to_owned(), spot)),
            cells => {
                findings.error("wrong-type", &spot, format!("{}; {expected} is expected", cells_text(cells)));
                None
            }
        }
    }

    /// Reads a direction, in the axes of ISO 8855 and mirrored from the side of the points to the left.
    pub fn direction(
        &mut self,
        findings: &mut Findings,
        key: &str,
        frame: Frame,
        points_side: Side,
    ) -> Option<(Vector3<f64>, Spot)> {
        self.vector(findings, (key, Quantity::Component), frame, points_side)
    }

    /// Reads a vector of a quantity as [`direction`](Self::direction).
    pub fn vector(
        &mut self,
        findings: &mut Findings,
        (key, kind): (&str, Quantity),
        frame: Frame,
        points_side: Side,
    ) -> Option<(Vector3<f64>, Spot)> {
        let (values, spot) = self.numbers(findings, key, kind, &[3])?;
        let mirror = if points_side == Side::Right { -1.0 } else { 1.0 };
        let along = frame.axes.to_iso(Vector3::new(values[0], values[1], values[2]));
        Some((Vector3::new(along.x, mirror * along.y, along.z), spot))
    }

    /// Reads true or false; `None` if absent or, with an error, if of another type.
    pub fn switch(&mut self, findings: &mut Findings, key: &str) -> Option<bool> {
        let (cells, spot) = self.find(key)?;
        let found = match &cells[..] {
            [Cell::Switch(on)] => Some(*on),
            [Cell::Text(text)] if text.eq_ignore_ascii_case("true") => Some(true),
            [Cell::Text(text)] if text.eq_ignore_ascii_case("false") => Some(false),
            _ => None,
        };
        if found.is_none() {
            findings.error("wrong-type", &spot, format!("{}; true or false is expected", cells_text(&cells)));
        }
        found
    }

    /// Reads numbers, converted to SI units; `counts` lists the permitted lengths. `None` if absent or, with an error, if invalid.
    pub fn numbers(
        &mut self,
        findings: &mut Findings,
        key: &str,
        kind: Quantity,
        counts: &[usize],
    ) -> Option<(Vec<f64>, Spot)> {
        let (cells, spot) = self.find(key)?;
        if !counts.contains(&cells.len()) {
            let counts = counts.iter().map(usize::to_string).collect::<Vec<_>>().join(" or ");
            let message = format!("{} numbers ({}); {counts} expected", cells.len(), cells_text(&cells));
            findings.error("wrong-length", &spot, message);
            return None;
        }
        let mut values = Vec::with_capacity(cells.len());
        for cell in &cells {
            match kind.value(cell) {
                Some(value) => values.push(value),
                None => {
                    let message = format!("{}; {} is expected", cell.to_text(), kind.expected());
                    findings.error("wrong-type", &spot, message);
                    return None;
                }
            }
        }
        Some((values, spot))
    }

    /// Reads an angle of the wheel, rad; 0 if absent. Warns about an angle beyond `most`.
    pub fn wheel_angle(&mut self, findings: &mut Findings, key: &str, most: f64) -> f64 {
        let Some((values, spot)) = self.numbers(findings, key, Quantity::Angle, &[1]) else { return 0.0 };
        if values[0].abs() > most {
            let message = format!(
                "{} is {}°; at most {}° are usual: check the value and its unit (deg or rad)",
                self.given(key),
                short(values[0].to_degrees()),
                short(most.to_degrees())
            );
            findings.warning("implausible-angle", &spot, message);
        }
        values[0]
    }

    /// Reads a point, m, in the axes of ISO 8855.
    pub fn point(
        &mut self,
        findings: &mut Findings,
        key: &str,
        frame: Frame,
    ) -> Option<(Vector3<f64>, Spot)> {
        let (values, spot) = self.numbers(findings, key, Quantity::Length(frame.unit), &[3])?;
        Some((frame.axes.to_iso(Vector3::new(values[0], values[1], values[2])), spot))
    }
}

/// Text of the values for a message, at most six.
fn cells_text(cells: &[Cell]) -> String {
    let list: Vec<String> = cells.iter().take(6).map(Cell::to_text).collect();
    match &list[..] {
        [] => "nothing".to_owned(),
        [one] => one.clone(),
        list => format!("[{}{}]", list.join(", "), if cells.len() > 6 { ", …" } else { "" }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_a_point_or_a_comma() {
        for (text, value) in [("1.5", 1.5), ("1,5", 1.5), ("-0,25", -0.25), (" 12 ", 12.0), ("1e-3", 1e-3)] {
            assert_eq!(parse_number(text), Some(value), "{text}");
        }
        for text in ["", "1.234,5", "1,2,3", "x", "nan", "inf", "1e999", "-"] {
            assert_eq!(parse_number(text), None, "{text}");
        }
    }

    #[test]
    fn units_stand_behind_numbers() {
        let text = |t: &str| Cell::Text(t.to_owned());
        let inertia = |unit| Quantity::Inertia(Unit::named(unit, &[Dimension::Inertia]).unwrap());
        for (kind, cell, value) in [
            (Quantity::Length(LengthUnit::Millimetre), Cell::Number(12.0), 0.012),
            (Quantity::Length(LengthUnit::Millimetre), text("1 in"), 0.0254),
            (Quantity::Length(LengthUnit::Metre), text("12,5mm"), 0.0125),
            (Quantity::Mass, text("850 g"), 0.85),
            (inertia("kg mm2"), Cell::Number(5e4), 0.05),
            (inertia("kg m2"), text("5e4 kg·mm²"), 0.05),
            (inertia("kg m2"), text("50000 kg mm^2"), 0.05),
            (Quantity::Angle, text("180 deg"), std::f64::consts::PI),
        ] {
            assert_eq!(kind.value(&cell), Some(value), "{cell:?}");
        }
        for (kind, cell) in [
            (Quantity::Angle, Cell::Number(1.0)),
            (Quantity::Mass, text("3 mm")),
            (Quantity::Length(LengthUnit::Metre), text("3 kg")),
            (Quantity::Mass, Cell::Number(f64::NAN)),
            (Quantity::Mass, Cell::Switch(true)),
        ] {
            assert_eq!(kind.value(&cell), None, "{cell:?}");
        }
    }
}
