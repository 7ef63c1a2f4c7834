//! Bushes and rack stiffness of a sheet.

use crate::corner::bushes::bush_points;
use crate::corner::design::{BushData, GivenBush};
use crate::findings::{Findings, Spot};
use crate::limits::{BUSH_STIFFNESS, MAX_LOSS_FACTOR};
use crate::options::Side;
use crate::sheet::entries::{Entries, Quantity};
use crate::sheet::template::Template;
use crate::units::Frame;
use percuss_formats::reading::quoted;
use std::collections::BTreeMap;

/// First part of the name of a section.
pub(in crate::sheet) const BUSH: &str = "bush";
/// Keys of a section.
const KEYS: [&str; 8] =
    ["radial", "axial", "torsional", "conical", "axis", "damping", "loss_factor", "dynamic_factor"];

/// Keys of all bushes in the sheet.
pub(in crate::sheet) fn bush_keys(entries: &Entries) -> Vec<String> {
    let sections = entries.sections_of(BUSH).into_iter();
    sections.flat_map(|(name, _)| KEYS.map(|key| format!("{BUSH}.{name}.{key}"))).collect()
}

/// Reads the bushes, by the point in whose place they are.
pub(in crate::sheet) fn read_bushes(
    entries: &mut Entries,
    findings: &mut Findings,
    template: &'static Template,
    (frame, points_side): (Frame, Side),
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
        if let Some(bush) = section.read((frame, side), spot) {
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

    /// Reads the bush; `None` without its radial and axial stiffness.
    fn read(mut self, (frame, side): (Frame, Side), spot: Spot) -> Option<GivenBush> {
        let stiffness = ["radial", "axial"].map(|key| {
            let found = self.positive(key, Quantity::Stiffness, &[1]);
            let path = format!("{}.{key}", self.name);
            if found.is_none() && !self.entries.has(&path) {
                self.entries.missing(self.findings, &path, "a stiffness with its unit, such as \"9 kN/mm\",");
            }
            let (values, spot) = found?;
            if values[0] == 0.0 {
                let message = "the stiffness is 0; more than 0 is expected: the bush carries the wheel";
                self.findings.error("bad-bush", &spot, message.to_owned());
                return None;
            }
            if !BUSH_STIFFNESS.contains(&values[0]) {
                let message = format!(
                    "{}; a bush has usually {} N/mm to {} kN/mm: check the unit",
                    self.entries.given(&path),
                    BUSH_STIFFNESS.start() / 1e3,
                    BUSH_STIFFNESS.end() / 1e6
                );
                self.findings.warning("implausible-force", &spot, message);
            }
            Some(values[0])
        });
        let [torsional, conical] = ["torsional", "conical"]
            .map(|key| self.number(key, Quantity::RotationalStiffness).unwrap_or(0.0));
        let damping = self.positive("damping", Quantity::Damping, &[1, 2]).map(|(values, _)| values);
        let damping = damping.map_or([0.0; 2], |values| [values[0], values[values.len() - 1]]);
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
        let axis = format!("{}.axis", self.name);
        let axis = self.entries.direction(self.findings, &axis, frame, side).map(|(axis, _)| axis);
        let [Some(radial), Some(axial)] = stiffness else { return None };
        let data = BushData::Rates { radial, axial, conical, torsional, damping };
        Some(GivenBush { data, loss_factor, dynamic_factor, axis, spot })
    }
}

/// Reads the stiffness of the rack along y, N/m.
pub(in crate::sheet) fn read_rack(entries: &mut Entries, findings: &mut Findings) -> Option<f64> {
    let stiffness =
        Section { entries, findings, name: "rack".to_owned() }.number("stiffness", Quantity::Stiffness);
    stiffness.filter(|stiffness| *stiffness > 0.0)
}
