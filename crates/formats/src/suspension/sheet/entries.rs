//! What a sheet or a table says, key by key, wherever it stands: numbers with their units, texts, places.

use super::super::findings::{Findings, Spot};
use super::super::units::{Frame, LengthUnit};
use crate::limits::MOST_SHEET_KEYS;
use crate::report::{quoted, shortened};
use percuss_mechanism::near_names;
use percuss_spatial::Vector3;

/// One value.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Cell {
    Number(f64),
    Text(String),
    Switch(bool),
}

impl Cell {
    fn shown(&self) -> String {
        match self {
            Cell::Number(x) => format!("{x}"),
            Cell::Text(text) => quoted(text),
            Cell::Switch(x) => format!("{x}"),
        }
    }
}

/// A key with its values.
#[derive(Clone, Debug)]
pub(super) struct Entry {
    /// `section.key`, or a key of the head.
    pub key: String,
    pub cells: Vec<Cell>,
    pub spot: Spot,
    used: bool,
}

/// All of a sheet.
#[derive(Default)]
pub(super) struct Entries {
    list: Vec<Entry>,
}

/// What a number measures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Kind {
    /// In the sheet's unit of length, unless its own is given.
    Length(LengthUnit),
    /// kg, unless g is given.
    Mass,
    /// kg·m² times this factor, unless a unit is given.
    Inertia(f64),
    /// deg or rad, which must be given.
    Angle,
}

/// kg·m², and what the other units of an inertia are in it: what divides.
pub(super) const INERTIA_UNITS: [(&str, f64); 5] =
    [("kg m2", 1.0), ("kg cm2", 1e4), ("kg mm2", 1e6), ("g mm2", 1e9), ("t mm2", 1e3)];

/// The factor that divides a number in this unit of inertia.
pub(super) fn inertia_unit(name: &str) -> Option<f64> {
    let plain: String = name.replace(['·', '*'], " ").replace('²', "2").replace('^', "");
    let plain = plain.split_whitespace().collect::<Vec<_>>().join(" ");
    INERTIA_UNITS.iter().find(|(known, _)| *known == plain).map(|(_, over)| *over)
}

impl Kind {
    fn expected(self) -> String {
        match self {
            Kind::Length(unit) => format!("a length in {0}, such as 12.5 or \"12.5 {0}\"", unit.name()),
            Kind::Mass => "a mass in kg, such as 3.2 or \"3.2 kg\"".to_owned(),
            Kind::Inertia(_) => "an inertia, such as 0.05".to_owned(),
            Kind::Angle => "an angle with its unit, such as \"-1.5 deg\"".to_owned(),
        }
    }

    /// The value in SI units; none where it is none of this kind.
    fn value(self, cell: &Cell) -> Option<f64> {
        let (number, unit) = match cell {
            Cell::Number(number) => (*number, ""),
            Cell::Text(text) => split_unit(text)?,
            Cell::Switch(_) => return None,
        };
        let value = match (self, unit) {
            (Kind::Length(default), "") => default.to_metres(number),
            (Kind::Length(_), unit) => LengthUnit::from_name(unit)?.to_metres(number),
            (Kind::Mass, "" | "kg") => number,
            (Kind::Mass, "g") => number / 1000.0,
            (Kind::Mass, "t") => number * 1000.0,
            (Kind::Inertia(over), "") => number / over,
            (Kind::Inertia(_), unit) => number / inertia_unit(unit)?,
            (Kind::Angle, "deg" | "°") => number.to_radians(),
            (Kind::Angle, "rad") => number,
            (Kind::Mass | Kind::Angle, _) => return None,
        };
        value.is_finite().then_some(value)
    }
}

/// `-1,5 deg` to −1.5 and `deg`; a single comma without a point is a decimal comma.
fn split_unit(text: &str) -> Option<(f64, &str)> {
    let text = text.trim();
    let is_part = |c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '.' | ',' | 'e' | 'E');
    let end = text.find(|c| !is_part(c)).unwrap_or(text.len());
    Some((number(&text[..end])?, text[end..].trim()))
}

/// A number with a decimal point or a decimal comma.
pub(super) fn number(text: &str) -> Option<f64> {
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
    /// Adds a key; one that was there before, or one too many, is an error.
    pub fn add(&mut self, findings: &mut Findings, key: String, cells: Vec<Cell>, spot: Spot) {
        if self.list.len() == MOST_SHEET_KEYS {
            findings.error("too-complex", &Spot::default(), format!("more than {MOST_SHEET_KEYS} keys"));
        } else if self.list.len() > MOST_SHEET_KEYS {
            return;
        }
        if self.has(&key) {
            findings.error("duplicate-key", &spot, format!("{key} is given twice"));
            return;
        }
        self.list.push(Entry { key, cells, spot, used: false });
    }

    /// Whether it has this key.
    pub fn has(&self, key: &str) -> bool {
        self.list.iter().any(|e| e.key == key)
    }

    /// Whether it has a key of this section.
    pub fn has_section(&self, section: &str) -> bool {
        self.list.iter().any(|e| e.key.split_once('.').is_some_and(|(head, _)| head == section))
    }

    /// The values of a key.
    pub fn find(&mut self, key: &str) -> Option<(Vec<Cell>, Spot)> {
        let entry = self.list.iter_mut().find(|e| e.key == key)?;
        entry.used = true;
        Some((entry.cells.clone(), entry.spot.clone()))
    }

    /// The keys that were not read.
    pub fn unread(&self) -> impl Iterator<Item = &Entry> {
        self.list.iter().filter(|e| !e.used)
    }

    /// Says that a key is missing, and which one nearly fits.
    pub fn missing(&self, findings: &mut Findings, key: &str, expected: &str) {
        let mut message = format!("the key is missing; {expected} is expected");
        let near = near_names(key, self.unread().map(|e| e.key.as_str()));
        if !near.is_empty() {
            let near: Vec<String> = near.iter().map(|n| quoted(n)).collect();
            message.push_str(&format!("; there is {}", near.join(", ")));
        }
        let spot = Spot { path: Some(shortened(key)), ..Spot::default() };
        findings.error("missing-key", &spot, message);
    }

    /// A text.
    pub fn text(&mut self, findings: &mut Findings, key: &str, expected: &str) -> Option<(String, Spot)> {
        let (cells, spot) = self.find(key)?;
        match &cells[..] {
            [Cell::Text(text)] => Some((text.trim().to_owned(), spot)),
            cells => {
                findings.error("wrong-type", &spot, format!("{}; {expected} is expected", shown(cells)));
                None
            }
        }
    }

    /// A switch.
    pub fn switch(&mut self, findings: &mut Findings, key: &str) -> Option<bool> {
        let (cells, spot) = self.find(key)?;
        let found = match &cells[..] {
            [Cell::Switch(on)] => Some(*on),
            [Cell::Text(text)] if text.eq_ignore_ascii_case("true") => Some(true),
            [Cell::Text(text)] if text.eq_ignore_ascii_case("false") => Some(false),
            _ => None,
        };
        if found.is_none() {
            findings.error("wrong-type", &spot, format!("{}; true or false is expected", shown(&cells)));
        }
        found
    }

    /// So many numbers; for a list of several lengths, `counts` has them all.
    pub fn numbers(
        &mut self,
        findings: &mut Findings,
        key: &str,
        kind: Kind,
        counts: &[usize],
    ) -> Option<(Vec<f64>, Spot)> {
        let (cells, spot) = self.find(key)?;
        if !counts.contains(&cells.len()) {
            let counts = counts.iter().map(usize::to_string).collect::<Vec<_>>().join(" or ");
            let message = format!("{} numbers ({}); {counts} expected", cells.len(), shown(&cells));
            findings.error("wrong-length", &spot, message);
            return None;
        }
        let mut values = Vec::with_capacity(cells.len());
        for cell in &cells {
            match kind.value(cell) {
                Some(value) => values.push(value),
                None => {
                    let message = format!("{}; {} is expected", cell.shown(), kind.expected());
                    findings.error("wrong-type", &spot, message);
                    return None;
                }
            }
        }
        Some((values, spot))
    }

    /// A point in metres, in the axes of ISO 8855.
    pub fn point(
        &mut self,
        findings: &mut Findings,
        key: &str,
        frame: Frame,
    ) -> Option<(Vector3<f64>, Spot)> {
        let (values, spot) = self.numbers(findings, key, Kind::Length(frame.unit), &[3])?;
        Some((frame.axes.to_iso(Vector3::new(values[0], values[1], values[2])), spot))
    }
}

fn shown(cells: &[Cell]) -> String {
    let list: Vec<String> = cells.iter().take(6).map(Cell::shown).collect();
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
            assert_eq!(number(text), Some(value), "{text}");
        }
        for text in ["", "1.234,5", "1,2,3", "x", "nan", "inf", "1e999", "-"] {
            assert_eq!(number(text), None, "{text}");
        }
    }

    #[test]
    fn units_stand_behind_numbers() {
        let text = |t: &str| Cell::Text(t.to_owned());
        for (kind, cell, value) in [
            (Kind::Length(LengthUnit::Millimetre), Cell::Number(12.0), 0.012),
            (Kind::Length(LengthUnit::Millimetre), text("1 in"), 0.0254),
            (Kind::Length(LengthUnit::Metre), text("12,5mm"), 0.0125),
            (Kind::Mass, text("850 g"), 0.85),
            (Kind::Inertia(1e6), Cell::Number(5e4), 0.05),
            (Kind::Inertia(1.0), text("5e4 kg·mm²"), 0.05),
            (Kind::Inertia(1.0), text("50000 kg mm^2"), 0.05),
            (Kind::Angle, text("180 deg"), std::f64::consts::PI),
        ] {
            assert_eq!(kind.value(&cell), Some(value), "{cell:?}");
        }
        for (kind, cell) in [
            (Kind::Angle, Cell::Number(1.0)),
            (Kind::Mass, text("3 mm")),
            (Kind::Length(LengthUnit::Metre), text("3 kg")),
            (Kind::Mass, Cell::Number(f64::NAN)),
            (Kind::Mass, Cell::Switch(true)),
        ] {
            assert_eq!(kind.value(&cell), None, "{cell:?}");
        }
    }
}
