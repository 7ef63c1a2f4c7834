//! Typed access to the keys of a file; every finding has a key path and a position.

use super::json::{Array, Object};
use crate::findings::{Findings, Spot};
use crate::limits::MAX_KEYS;
use crate::sheet::{Place, WrittenPoint};
use crate::text::offset_of;
use crate::units::{Frame, check_size};
use percuss_formats::Diagnostic;
use percuss_formats::reading::{quoted, shortened};
use percuss_mechanism::near_names;
use percuss_spatial::Vector3;
use serde_json::value::RawValue;
use std::ops::{Deref, DerefMut};

struct Entry<'t> {
    key: String,
    value: &'t RawValue,
    used: bool,
}

/// Object of the file. All reads from an absent section return zeros, because its absence is already an error.
pub(in super::super) struct Section<'t> {
    pub spot: Spot,
    entries: Option<Vec<Entry<'t>>>,
}

impl Section<'_> {
    /// True if the section has the key.
    pub fn has(&self, key: &str) -> bool {
        self.entries.iter().flatten().any(|e| e.key == key)
    }
}

/// Reads values and collects findings.
pub(in super::super) struct Reader<'t> {
    text: &'t str,
    findings: Findings,
    /// Unit and axes of the file.
    pub frame: Frame,
    /// Largest coordinate by absolute value, m, and its position.
    farthest: Option<(f64, Spot)>,
    /// Section with nonzero products of inertia.
    pub products: Option<Spot>,
    /// Displacements of hardpoints, m, in the axes of the file.
    moves: Vec<(String, [f64; 3])>,
    /// Hardpoints as written.
    pub written: Vec<WrittenPoint>,
}

impl Deref for Reader<'_> {
    type Target = Findings;
    fn deref(&self) -> &Findings {
        &self.findings
    }
}

impl DerefMut for Reader<'_> {
    fn deref_mut(&mut self) -> &mut Findings {
        &mut self.findings
    }
}

impl<'t> Reader<'t> {
    /// Creates a reader of JSON text without comments. `moves`: displacements of hardpoints, m, in the axes of the file.
    pub fn new(text: &'t str, frame: Frame, moves: &[(String, [f64; 3])]) -> Self {
        let (findings, moves) = (Findings::default(), moves.to_vec());
        Self { text, findings, frame, farthest: None, products: None, moves, written: Vec::new() }
    }

    /// Returns all findings in the order of the file, findings without a position first.
    pub fn finish(self, path: &str) -> Vec<Diagnostic> {
        self.findings.finish(&[(path, self.text)])
    }

    /// Parses the whole file as an object; `None` after an error for invalid JSON.
    pub fn root(&mut self) -> Option<Section<'t>> {
        match serde_json::from_str::<Object<'t>>(self.text) {
            Ok(object) => Some(self.section_of(Spot::default(), object)),
            Err(error) => {
                let at = offset_of(self.text, error.line(), error.column());
                let full = error.to_string();
                // The parser's message repeats the position; only the part before it is used.
                let message = full.split(" at line ").next().unwrap_or(&full);
                let hint = if self.text.trim_ascii_start().starts_with('<') {
                    ": this is XML; a suspension file of Chrono::Vehicle is JSON"
                } else if error.is_eof() {
                    ": the file ends too early; was it cut off?"
                } else {
                    ""
                };
                let spot = Spot { at: Some(at), ..Spot::default() };
                self.error("not-json", &spot, format!("not JSON: {}{hint}", shortened(message)));
                None
            }
        }
    }

    /// Converts an object to a section; too many keys and repeated keys are errors.
    fn section_of(&mut self, spot: Spot, object: Object<'t>) -> Section<'t> {
        if object.too_many {
            self.error("too-complex", &spot, format!("more than {MAX_KEYS} keys in one object"));
        }
        let mut entries: Vec<Entry<'t>> = Vec::with_capacity(object.entries.len());
        for (key, value) in object.entries {
            if entries.iter().any(|e| e.key == key) {
                let spot = self.spot(&spot, &key, Some(value));
                self.error("duplicate-key", &spot, "the key is given twice".to_owned());
                continue;
            }
            entries.push(Entry { key, value, used: false });
        }
        Section { spot, entries: Some(entries) }
    }

    /// Position of a key of an object; position of the object if the key is missing.
    fn spot(&self, parent: &Spot, key: &str, value: Option<&RawValue>) -> Spot {
        let key = shortened(key);
        let path = match &parent.path {
            Some(path) => format!("{path}/{key}"),
            None => key,
        };
        Spot { path: Some(path), at: value.map(|v| self.offset(v)).or(parent.at), file: 0 }
    }

    /// Byte offset of a value, which is a slice of the text.
    fn offset(&self, value: &RawValue) -> usize {
        (value.get().as_ptr() as usize).wrapping_sub(self.text.as_ptr() as usize)
    }

    /// Value of a key; marks the key as read.
    fn optional(&mut self, section: &mut Section<'t>, key: &str) -> Option<(&'t RawValue, Spot)> {
        let entry = section.entries.as_mut()?.iter_mut().find(|e| e.key == key)?;
        entry.used = true;
        let value = entry.value;
        Some((value, self.spot(&section.spot, key, Some(value))))
    }

    /// Value of a key, as `optional`; a missing key is an error.
    fn required(
        &mut self,
        section: &mut Section<'t>,
        key: &str,
        expected: &str,
    ) -> Option<(&'t RawValue, Spot)> {
        let found = self.optional(section, key);
        if let (None, Some(entries)) = (&found, &section.entries) {
            let spot = self.spot(&section.spot, key, None);
            let mut message = format!("the key is missing; {expected} is expected");
            let near = near_names(key, entries.iter().filter(|e| !e.used).map(|e| e.key.as_str()));
            if !near.is_empty() {
                let near: Vec<String> = near.iter().map(|n| quoted(n)).collect();
                message.push_str(&format!("; there is {}", near.join(", ")));
            }
            self.error("missing-key", &spot, message);
        }
        found
    }

    fn report_wrong_type(&mut self, spot: &Spot, value: &RawValue, expected: &str) {
        let got = match value.get().as_bytes().first() {
            Some(b'{') => "an object",
            Some(b'[') => "an array",
            Some(b'"') => "a string",
            Some(b't' | b'f') => "true or false",
            Some(b'n') => "null",
            Some(_) | None => "a number",
        };
        self.error("wrong-type", spot, format!("{got} ({}); {expected} is expected", shortened(value.get())));
    }

    /// Reads the object under a key.
    pub fn section(&mut self, parent: &mut Section<'t>, key: &str) -> Section<'t> {
        let absent = Section { spot: self.spot(&parent.spot, key, None), entries: None };
        let Some((value, spot)) = self.required(parent, key, "an object") else { return absent };
        match serde_json::from_str::<Object<'t>>(value.get()) {
            Ok(object) => self.section_of(spot, object),
            Err(_) => {
                self.report_wrong_type(&spot, value, "an object");
                absent
            }
        }
    }

    /// Warns about keys of a section that were not read, except those in `ignored`.
    pub fn warn_unread_keys(&mut self, section: Section<'t>, ignored: &[&str]) {
        let unknown = section.entries.iter().flatten().filter(|e| !e.used && !ignored.contains(&&*e.key));
        for entry in unknown {
            let spot = self.spot(&section.spot, &entry.key, Some(entry.value));
            if entry.key.starts_with("Bushing Data") {
                let message = "this bushing is not read: the joint is rigid, as without this key".to_owned();
                self.warning("bushing", &spot, message);
            } else {
                self.warning("unknown-key", &spot, "the key is not known; it is ignored".to_owned());
            }
        }
    }

    /// Reads a mandatory string; `None`, with an error, if missing or of another type.
    pub fn string(&mut self, section: &mut Section<'t>, key: &str) -> Option<(String, Spot)> {
        let (value, spot) = self.required(section, key, "a string")?;
        match serde_json::from_str(value.get()) {
            Ok(text) => Some((text, spot)),
            Err(_) => {
                self.report_wrong_type(&spot, value, "a string");
                None
            }
        }
    }

    /// Reads a flag; false if absent.
    pub fn flag(&mut self, section: &mut Section<'t>, key: &str) -> bool {
        let Some((value, spot)) = self.optional(section, key) else { return false };
        match value.get() {
            "true" => true,
            "false" => false,
            _ => {
                self.report_wrong_type(&spot, value, "true or false");
                false
            }
        }
    }

    /// Reads a mandatory number; `expected` names the quantity with its unit.
    pub fn number(&mut self, section: &mut Section<'t>, key: &str, expected: &str) -> f64 {
        match self.required(section, key, expected) {
            Some((value, spot)) => self.parse_number(value, &spot, expected),
            None => 0.0,
        }
    }

    /// Reads a number; 0 if absent.
    pub fn number_or_zero(&mut self, section: &mut Section<'t>, key: &str, expected: &str) -> f64 {
        match self.optional(section, key) {
            Some((value, spot)) => self.parse_number(value, &spot, expected),
            None => 0.0,
        }
    }

    /// Parses a number with the standard library: serde_json may be wrong in the last digit.
    fn parse_number(&mut self, value: &RawValue, spot: &Spot, expected: &str) -> f64 {
        let is_number = value.get().starts_with(|c: char| c == '-' || c.is_ascii_digit());
        match value.get().parse::<f64>() {
            Ok(number) if is_number && number.is_finite() => number,
            Ok(_) if is_number => {
                let message = format!("{} is too large; {expected} is expected", shortened(value.get()));
                self.error("not-finite", spot, message);
                0.0
            }
            Ok(_) | Err(_) => {
                self.report_wrong_type(spot, value, expected);
                0.0
            }
        }
    }

    /// Reads three mandatory numbers.
    pub fn triple(&mut self, section: &mut Section<'t>, key: &str, expected: &str) -> Vector3<f64> {
        let Some((value, spot)) = self.required(section, key, expected) else { return Vector3::zeros() };
        let Ok(array) = serde_json::from_str::<Array<'t>>(value.get()) else {
            self.report_wrong_type(&spot, value, expected);
            return Vector3::zeros();
        };
        let [Some(x), Some(y), Some(z)] = array.first else {
            self.report_wrong_length(&spot, array.length, expected);
            return Vector3::zeros();
        };
        if array.length != 3 {
            self.report_wrong_length(&spot, array.length, expected);
        }
        let mut entry = |i: usize, value: &'t RawValue| {
            let path = Some(format!("{}[{i}]", spot.label()));
            let spot = Spot { path, at: Some(self.offset(value)), file: 0 };
            self.parse_number(value, &spot, "a number")
        };
        Vector3::new(entry(0, x), entry(1, y), entry(2, z))
    }

    fn report_wrong_length(&mut self, spot: &Spot, length: usize, expected: &str) {
        self.error("wrong-length", spot, format!("an array of {length}; {expected} is expected"));
    }

    /// Reads a mandatory direction and converts it to the axes of ISO 8855.
    pub fn direction(&mut self, section: &mut Section<'t>, key: &str) -> Vector3<f64> {
        let direction = self.triple(section, key, "a direction [x, y, z]");
        self.frame.axes.to_iso(direction)
    }

    /// Reads a mandatory point, m, in the axes of ISO 8855.
    pub fn point(&mut self, section: &mut Section<'t>, key: &str) -> Vector3<f64> {
        let expected = format!("a point, [x, y, z] in {},", self.frame.unit.name());
        let point = self.triple(section, key, &expected);
        let point = self.frame.point(point);
        if self.farthest.as_ref().is_none_or(|(far, _)| point.amax() > *far) {
            let value = section.entries.iter().flatten().find(|e| e.key == key).map(|e| e.value);
            self.farthest = Some((point.amax(), self.spot(&section.spot, key, value)));
        }
        point
    }

    /// Reads a mandatory hardpoint with its displacement, m, in the axes of ISO 8855.
    pub fn hardpoint(&mut self, section: &mut Section<'t>, key: &str, name: &'static str) -> Vector3<f64> {
        let at = self.point(section, key);
        let value = section.entries.iter().flatten().find(|entry| entry.key == key).map(|entry| entry.value);
        let array = value.and_then(|value| serde_json::from_str::<Array<'t>>(value.get()).ok());
        if let Some(Array { first: [Some(x), Some(y), Some(z)], .. }) = array {
            let unit = self.frame.unit.to_metres(1.0);
            let number = |value: &'t RawValue| {
                let (text, begin) = (value.get(), self.offset(value));
                (text.parse().unwrap_or_default(), unit, vec![Place::Text(begin..begin + text.len())])
            };
            let numbers = [x, y, z].map(number);
            self.written.push(WrittenPoint { name: name.to_owned(), file: 0, numbers });
        }
        let by = self.moves.iter().filter(|(known, _)| known == name).map(|(_, by)| Vector3::from(*by)).sum();
        at + self.frame.axes.to_iso(by)
    }

    /// Hardpoints with their displacements, m, in the axes of the file.
    pub fn coordinates(&self) -> Vec<(String, [f64; 3])> {
        let of = |point: &WrittenPoint| {
            let moves = self.moves.iter().filter(|(known, _)| *known == point.name);
            let by: Vector3<f64> = moves.map(|(_, by)| Vector3::from(*by)).sum();
            let at = |k: usize| point.numbers[k].0 * point.numbers[k].1 + by[k];
            (point.name.to_owned(), [0, 1, 2].map(at))
        };
        self.written.iter().map(of).collect()
    }

    /// Refuses coordinates that are implausible for a vehicle in the unit of the file.
    pub fn check_unit(&mut self) {
        if let Some((far, spot)) = self.farthest.take()
            && !self.has_errors()
        {
            check_size(&mut self.findings, far, &spot, self.frame.unit);
        }
    }
}
