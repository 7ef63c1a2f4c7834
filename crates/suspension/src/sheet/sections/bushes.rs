//! Bushes and rack stiffness of a sheet.

use crate::corner::bushes::bush_points;
use crate::corner::design::{BushData, GivenBush};
use crate::findings::{Findings, Spot};
use crate::limits::{BUSH_STIFFNESS, MAX_LOSS_FACTOR};
use crate::options::{ImportOptions, Side};
use crate::sheet::entries::{Entries, Quantity};
use crate::sheet::point_table::{Files, read_beside};
use crate::sheet::sections::bush_file::{self, BUSH, BushFile};
use crate::sheet::template::Template;
use crate::units::Frame;
use crate::units::short;
use percuss_formats::Source;
use percuss_formats::reading::{encoding, quoted};
use std::collections::BTreeMap;

/// Keys of a section.
const KEYS: [&str; 13] = [
    "file",
    "radial",
    "axial",
    "torsional",
    "conical",
    "axis",
    "x_axis",
    "damping",
    "rotational_damping",
    "loss_factor",
    "dynamic_factor",
    "preload",
    "preload_torque",
];
/// Keys in place of which a file gives the values.
const OF_FILE: [&str; 6] = ["radial", "axial", "torsional", "conical", "damping", "rotational_damping"];

/// Keys of all bushes in the sheet.
pub(in crate::sheet) fn bush_keys(entries: &Entries) -> Vec<String> {
    let sections = entries.sections_of(BUSH).into_iter();
    sections.flat_map(|(name, _)| KEYS.map(|key| format!("{BUSH}.{name}.{key}"))).collect()
}

/// Reads the bushes, by the point in whose place they are. `files`: bushing files by the names of the bushes.
pub(in crate::sheet) fn read_bushes(
    entries: &mut Entries,
    findings: &mut Findings,
    template: &'static Template,
    (frame, points_side): (Frame, Side),
    files: &BTreeMap<String, BushFile>,
) -> BTreeMap<String, GivenBush> {
    let points: Vec<&str> = template.parts_with_bar().flat_map(bush_points).collect();
    let mut bushes = BTreeMap::new();
    for (name, spot) in entries.sections_of(BUSH) {
        let spot = Spot { path: Some(format!("{BUSH}.{name}")), ..spot };
        if !points.contains(&name.as_str()) {
            let near = crate::sheet::catalogue::suggestion(&name, points.iter().copied());
            let message = format!(
                "no two links are joined at {}{near} (bushes are possible at {})",
                quoted(&name),
                points.join(", ")
            );
            findings.error("unknown-point", &spot, message);
        } else if !entries.has(&format!("points.{name}")) {
            findings.error("missing-key", &spot, format!("the point {name} of the bush is not given"));
        }
        let side = if template.is_central(&name) { Side::Left } else { points_side };
        let section = Section { entries, findings, name: format!("{BUSH}.{name}") };
        if let Some(bush) = section.read((frame, side), spot, files.get(&name)) {
            bushes.insert(name, bush);
        }
    }
    bushes
}

/// Section of a bush.
struct Section<'e> {
    entries: &'e mut Entries,
    findings: &'e mut Findings,
    name: String,
}

impl Section<'_> {
    /// Reads numbers of at least 0.
    fn positive(&mut self, key: &str, kind: Quantity, counts: &[usize]) -> Option<(Vec<f64>, Spot)> {
        let key = format!("{}.{key}", self.name);
        let (values, spot) = self.entries.numbers(self.findings, &key, kind, counts)?;
        if let Some(value) = values.iter().find(|value| **value < 0.0) {
            let message = format!("{value}; a number of at least 0 is expected");
            self.findings.error("bad-bush", &spot, message);
            return None;
        }
        Some((values, spot))
    }

    /// One number of at least 0; `None` if absent or invalid.
    fn number(&mut self, key: &str, kind: Quantity) -> Option<f64> {
        Some(self.positive(key, kind, &[1])?.0[0])
    }

    /// Numbers of at least 0 of the directions x, y and z: one for all, two for across and along the axis, or three. `is_across`: only x and y, one
    /// for both or two.
    fn directions(&mut self, key: &str, kind: Quantity, is_across: bool) -> Option<[f64; 3]> {
        let counts: &[usize] = if is_across { &[1, 2] } else { &[1, 2, 3] };
        let (values, _) = self.positive(key, kind, counts)?;
        match values[..] {
            [x, y] if is_across => Some([x, y, 0.0]),
            [across, along] => Some([across, across, along]),
            [x, y, z] => Some([x, y, z]),
            [all, ..] => Some([all; 3]),
            [] => None,
        }
    }

    /// Reads the rates of the keys; `None` without radial and axial stiffness.
    fn rates(&mut self) -> Option<BushData> {
        let stiffness = ["radial", "axial"].map(|key| {
            let counts: &[usize] = if key == "radial" { &[1, 2] } else { &[1] };
            let found = self.positive(key, Quantity::Stiffness, counts);
            let path = format!("{}.{key}", self.name);
            if found.is_none() && !self.entries.has(&path) {
                self.entries.missing(self.findings, &path, "a stiffness with its unit, such as \"9 kN/mm\",");
            }
            let (values, spot) = found?;
            if values.contains(&0.0) {
                let message = "the stiffness is 0; more than 0 is expected: the bush carries the wheel";
                self.findings.error("bad-bush", &spot, message.to_owned());
                return None;
            }
            if values.iter().any(|value| !BUSH_STIFFNESS.contains(value)) {
                let message = format!(
                    "{}; a bush has usually {} N/mm to {} kN/mm: check the unit",
                    self.entries.given(&path),
                    BUSH_STIFFNESS.start() / 1e3,
                    BUSH_STIFFNESS.end() / 1e6
                );
                self.findings.warning("implausible-force", &spot, message);
            }
            Some([values[0], values[values.len() - 1]])
        });
        let rotational = Quantity::RotationalStiffness;
        let [cx, cy, _] = self.directions("conical", rotational, true).unwrap_or_default();
        let torsional = self.number("torsional", rotational).unwrap_or(0.0);
        let [dx, dy, dz] = self.directions("damping", Quantity::Damping, false).unwrap_or_default();
        let [rx, ry, rz] =
            self.directions("rotational_damping", Quantity::RotationalDamping, false).unwrap_or_default();
        let [Some([x, y]), Some([axial, _])] = stiffness else { return None };
        Some(BushData::Rates {
            stiffness: [cx, cy, torsional, x, y, axial],
            damping: [rx, ry, rz, dx, dy, dz],
        })
    }

    /// Reads the bush; `None` without its radial and axial stiffness.
    fn read(
        mut self,
        (frame, side): (Frame, Side),
        spot: Spot,
        file: Option<&BushFile>,
    ) -> Option<GivenBush> {
        let path = |key: &str| format!("{}.{key}", self.name);
        let [axis, x_axis, preload, torque] = ["axis", "x_axis", "preload", "preload_torque"].map(path);
        let (data, own_preload) = match file {
            Some(BushFile { stiffness, damping, preload }) => {
                if stiffness[3..].contains(&0.0) {
                    let message = "the file has no stiffness along one of its axes; more than 0 is expected: the bush carries the wheel";
                    self.findings.error("bad-bush", &spot, message.to_owned());
                }
                if stiffness[3..].iter().any(|k| *k > 0.0 && !BUSH_STIFFNESS.contains(k)) {
                    let all: Vec<String> = stiffness[3..].iter().map(|k| short(*k).to_string()).collect();
                    let message = format!("the file gives {} N/m: check its units", all.join(", "));
                    self.findings.warning("implausible-force", &spot, message);
                }
                // A mirrored bush keeps its axes x and z.
                let sign = |i: usize| if side == Side::Right && [0, 2, 4].contains(&i) { -1.0 } else { 1.0 };
                let preload = std::array::from_fn(|i| sign(i) * preload[i]);
                (Some(BushData::Rates { stiffness: *stiffness, damping: *damping }), preload)
            }
            None if self.entries.has(&path("file")) => (None, [0.0; 6]),
            None => (self.rates(), [0.0; 6]),
        };
        let loss_factor = self.number("loss_factor", Quantity::Component).unwrap_or(0.0);
        if loss_factor > MAX_LOSS_FACTOR {
            let message =
                format!("loss_factor = {loss_factor}; rubber has at most {MAX_LOSS_FACTOR}: check the value");
            self.findings.warning("implausible-force", &spot, message);
        }
        let dynamic_factor = self.number("dynamic_factor", Quantity::Component).unwrap_or(1.0);
        if dynamic_factor == 0.0 {
            let message = "dynamic_factor = 0; the dynamic stiffness divided by the static one is expected, such as 1.4";
            self.findings.error("bad-bush", &spot, message.to_owned());
        }
        let [axis, x_axis, force, torque] = [
            (axis, Quantity::Component),
            (x_axis, Quantity::Component),
            (preload, Quantity::Force),
            (torque, Quantity::Moment),
        ]
        .map(|(key, kind)| Some(self.entries.vector(self.findings, (&key, kind), frame, side)?.0));
        // The mirror image of a moment.
        let sign = if side == Side::Right { -1.0 } else { 1.0 };
        let preload = [force.unwrap_or_default(), torque.unwrap_or_default() * sign];
        Some(GivenBush {
            loss_factor,
            dynamic_factor,
            axis,
            x_axis,
            preload,
            own_preload,
            ..GivenBush::new(data?, spot)
        })
    }
}

/// Reads the bushing files that sections of bushes name, by the names of the bushes.
pub(in crate::sheet) fn read_files(
    source: &Source,
    options: &ImportOptions,
    entries: &mut Entries,
    findings: &mut Findings,
    files: &mut Files,
) -> BTreeMap<String, BushFile> {
    let mut found = BTreeMap::new();
    for (name, _) in entries.sections_of(BUSH) {
        let key = format!("{BUSH}.{name}.file");
        let Some((path, spot)) = entries.text(findings, &key, "the name of a bushing file (.bus)") else {
            continue;
        };
        let both: Vec<&str> =
            OF_FILE.into_iter().filter(|key| entries.has(&format!("{BUSH}.{name}.{key}"))).collect();
        if !both.is_empty() {
            findings.error(
                "conflict",
                &spot,
                format!("the file gives the rates; delete {}", both.join(", ")),
            );
            continue;
        }
        let Some((path, read)) = read_beside(source, (&path, &spot), "the bushing file", options, findings)
        else {
            continue;
        };
        let (text, file) = (encoding::decode(&read.bytes).text.into_owned(), files.len());
        found.extend(bush_file::read(&text, file, findings).map(|data| (name, data)));
        files.push((path, text));
    }
    found
}

/// Reads the stiffness of the rack along y, N/m.
pub(in crate::sheet) fn read_rack(entries: &mut Entries, findings: &mut Findings) -> Option<f64> {
    let stiffness =
        Section { entries, findings, name: "rack".to_owned() }.number("stiffness", Quantity::Stiffness);
    stiffness.filter(|stiffness| *stiffness > 0.0)
}
