//! Reader of the hardpoints of a subsystem of Adams/Car (`.sub`, a TeimOrbit file).
//!
//! The section `[HARDPOINT]` has a row `'lca_front' 'left/right' -200.0 -400.0 150.0` for each point. Points with the
//! symmetry `left/right` describe the left side. Lengths are in the unit of the section `[UNITS]`; the axes are those of
//! Adams/Car: x backward, y right, z up.

use crate::findings::{Findings, Spot};
use crate::limits::MAX_SHEET_KEYS;
use crate::sheet::entries::{Cell, Entries, Place};
use crate::units::VehicleAxes;
use percuss_formats::reading::{quoted, shortened};
use percuss_units::LengthUnit;

/// True if a text is a TeimOrbit file with hardpoints.
pub(in super::super) fn is_subsystem(text: &str) -> bool {
    text.lines().any(|line| line.trim().eq_ignore_ascii_case("[HARDPOINT]"))
        && text.lines().any(|line| line.trim_start().starts_with('{'))
}

/// Reads the hardpoints, with the unit of the file, in the given axes; `file`: index of the file among those of the import.
pub(in super::super) fn read(
    text: &str,
    file: usize,
    axes: VehicleAxes,
    entries: &mut Entries,
    findings: &mut Findings,
) {
    let (mut section, mut unit, mut count, mut offset) = (String::new(), LengthUnit::Millimetre, 0, 0);
    let mut rows: Vec<(String, [f64; 3], Vec<Place>, Spot)> = Vec::new();
    for line in text.split_inclusive('\n') {
        let at = offset;
        offset += line.len();
        let line = line.trim();
        let spot = |path: &str| Spot { path: Some(shortened(path)), at: Some(at), file };
        if let Some(name) = line.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) {
            section = name.to_ascii_uppercase();
        } else if section == "UNITS"
            && let Some((key, value)) = line.split_once('=')
            && key.trim().eq_ignore_ascii_case("LENGTH")
        {
            let name = value.trim().trim_matches(['\'', '"', ' ']).to_ascii_lowercase();
            match crate::sheet::table::unit_of(&name) {
                Some(known) => unit = known,
                None => {
                    let message = format!(
                        "the unit of length {} is not known; mm, cm, meter or inch is expected",
                        quoted(&name)
                    );
                    findings.error("unknown-word", &spot("UNITS.LENGTH"), message);
                }
            }
        } else if section == "HARDPOINT" && line.starts_with('\'') {
            count += 1;
            if count > MAX_SHEET_KEYS {
                let message = format!("more than {MAX_SHEET_KEYS} hardpoints");
                findings.error("too-complex", &spot("HARDPOINT"), message);
                return;
            }
            match row(line) {
                Some((name, at, numbers)) => {
                    let place = |number: &str| {
                        let begin = number.as_ptr() as usize - text.as_ptr() as usize;
                        Place::Text(begin..begin + number.len())
                    };
                    rows.push((name.clone(), at, numbers.into_iter().map(place).collect(), spot(&name)));
                }
                None => {
                    let message = format!(
                        "{} is no hardpoint; 'NAME' 'left/right' X Y Z is expected",
                        quoted(&shortened(line))
                    );
                    findings.error("wrong-type", &spot("HARDPOINT"), message);
                }
            }
        }
    }
    if rows.is_empty() && !findings.has_errors() {
        let spot = Spot { path: Some("HARDPOINT".to_owned()), at: None, file };
        findings.error("missing-key", &spot, "the section has no hardpoint".to_owned());
    }
    entries.axes_of_file = Some(VehicleAxes::ADAMS);
    for (name, at, places, spot) in rows {
        let at: [f64; 3] = axes.from_iso(VehicleAxes::ADAMS.to_iso(at.into())).into();
        let cells = at.map(|x| Cell::Text(format!("{x} {}", unit.name()))).to_vec();
        entries.add(findings, format!("points.{name}"), cells, spot);
        entries.set_places(&format!("points.{name}"), places);
    }
}

/// Name, coordinates and their texts of a row; `None` for another row.
fn row(line: &str) -> Option<(String, [f64; 3], Vec<&str>)> {
    let mut parts = line.split('\'');
    let name = parts.nth(1)?.trim().to_owned();
    let (_, numbers) = (parts.nth(1)?, parts.next()?);
    let texts: Vec<&str> = numbers.split_whitespace().take(3).collect();
    let numbers: Vec<f64> = texts.iter().map_while(|x| x.parse().ok()).collect();
    let [x, y, z] = <[f64; 3]>::try_from(numbers).ok()?;
    (!name.is_empty() && [x, y, z].iter().all(|x| x.is_finite())).then_some((name, [x, y, z], texts))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_of_adams_are_read() {
        let line =
            " 'lca_front                   '  'left/right'   -200.0   -400.0   150.5   'remark'".trim();
        let found = row(line).map(|(name, at, _)| (name, at));
        assert_eq!(found, Some(("lca_front".to_owned(), [-200.0, -400.0, 150.5])));
        assert_eq!(row("'lca_front' 'left/right' -200.0 x 1"), None);
    }
}
