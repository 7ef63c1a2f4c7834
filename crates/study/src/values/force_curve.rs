//! Force curve of a contact as given by the user, or by a suspension sheet.

use crate::model::loading::refuse_pipe;
use crate::values::quantities::{Force, Length, schema_of};
use percuss_contact::ForceCurve;
use percuss_units::QuantityError;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::io::Read;
use std::sync::Arc;

/// Largest file of a curve, bytes.
const LARGEST_FILE: u64 = 1 << 20;

/// Force curve of a contact: force over the penetration after the touch, linear between the points.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(try_from = "CurveText")]
pub struct GivenCurve {
    pub(crate) curve: Arc<ForceCurve>,
    /// Named contact of the suspension sheet that has the curve; `None` for a given curve.
    pub(crate) stop: Option<String>,
}

/// Points of a curve.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct CurveText {
    /// Penetrations (m), increasing from 0.
    deflections: Vec<Length>,
    /// Force at each penetration (N).
    forces: Vec<Force>,
}

schema_of!(GivenCurve, CurveText);

impl TryFrom<CurveText> for GivenCurve {
    type Error = String;
    fn try_from(text: CurveText) -> Result<Self, String> {
        let x = text.deflections.into_iter().map(|length| length.0).collect();
        let f = text.forces.into_iter().map(|force| force.0).collect();
        let curve = ForceCurve::new(x, f).map_err(|error| error.to_string())?;
        Ok(Self { curve: Arc::new(curve), stop: None })
    }
}

impl GivenCurve {
    /// Curve of a stop in a suspension sheet.
    pub(crate) fn of_stop(name: &str, curve: &ForceCurve) -> Self {
        Self { curve: Arc::new(curve.clone()), stop: Some(name.to_owned()) }
    }

    /// Reads a table of two columns, deflection and force, separated by commas, semicolons or tabs. Lines from `#` on are ignored. Numbers
    /// have units (`2mm`, `1.5kN`), or the units in brackets of a header (`deflection (mm), force (N)`), or are in m and N.
    ///
    /// # Errors
    /// A message: an unreadable file, a line without two quantities, points that are no curve.
    pub fn read(path: &str) -> Result<Self, String> {
        refuse_pipe(path).map_err(|error| error.to_string())?;
        let mut text = String::new();
        let read =
            std::fs::File::open(path).and_then(|file| file.take(LARGEST_FILE + 1).read_to_string(&mut text));
        read.map_err(|error| format!("{path}: {error}"))?;
        if text.len() as u64 > LARGEST_FILE {
            return Err(format!(
                "{path}: more than {LARGEST_FILE} bytes; expected a table of deflection and force"
            ));
        }
        Self::parse(&text).map_err(|(line, why)| format!("{path}:{line}: {why}"))
    }

    /// Reads the text of a table; the error has the number of the line.
    fn parse(text: &str) -> Result<Self, (usize, String)> {
        let mut units = [String::new(), String::new()];
        let (mut points, mut last) = ([Vec::new(), Vec::new()], 0);
        let text = text.trim_start_matches('\u{feff}');
        for (number, line) in text.lines().enumerate().map(|(i, line)| (i + 1, line)) {
            let line = line.split('#').next().unwrap_or_default().trim();
            if line.is_empty() {
                continue;
            }
            let separator = [';', '\t', ','].into_iter().find(|c| line.contains(*c)).unwrap_or(' ');
            let cells: Vec<&str> =
                line.split(separator).map(str::trim).filter(|cell| !cell.is_empty()).collect();
            let [x, f] = cells[..] else {
                return Err((number, format!("{} cells; expected two, deflection and force", cells.len())));
            };
            let is_header = |cell: &str| cell.starts_with(|c: char| c.is_alphabetic());
            if last == 0 && is_header(x) && is_header(f) {
                units = [x, f].map(|cell| {
                    let unit =
                        cell.rsplit_once(['(', '[']).map(|(_, rest)| rest.trim_end_matches([')', ']']));
                    unit.unwrap_or_default().trim().to_owned()
                });
            } else {
                // A number takes the unit of its column.
                let with_unit = |cell: &str, unit: &str| match cell.parse::<f64>() {
                    Ok(_) => format!("{cell}{unit}"),
                    Err(_) => cell.to_owned(),
                };
                let fault = |error: QuantityError| (number, error.to_string());
                points[0].push(with_unit(x, &units[0]).parse::<Length>().map_err(fault)?.0);
                points[1].push(with_unit(f, &units[1]).parse::<Force>().map_err(fault)?.0);
            }
            last = number;
        }
        let [x, f] = points;
        let curve = ForceCurve::new(x, f).map_err(|error| (last.max(1), error.to_string()))?;
        Ok(Self { curve: Arc::new(curve), stop: None })
    }
}

/// Force curve of a contact, in a report.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ForceCurveRecord {
    /// Named contact of the suspension sheet that has the curve; null for a given curve.
    pub stop: Option<String>,
    /// Penetrations, m.
    pub deflections: Vec<f64>,
    /// Force at each penetration, N.
    pub forces: Vec<f64>,
}

impl From<&GivenCurve> for ForceCurveRecord {
    fn from(given: &GivenCurve) -> Self {
        let (deflections, forces) = (given.curve.deflections().to_vec(), given.curve.forces().to_vec());
        Self { stop: given.stop.clone(), deflections, forces }
    }
}

#[cfg(test)]
mod tests {
    use super::GivenCurve;

    #[test]
    fn tables_have_units() {
        let curve = |text: &str| GivenCurve::parse(text).map(|given| given.curve);
        let expected = curve("0,0\n0.002,80\n0.01 , 1500 # end\n").expect("a curve");
        for text in [
            "deflection (mm); force [kN]\n0;0\n2;0.08\n\n10;1.5\n",
            "\u{feff}# of the supplier\n0mm\t0\n2mm\t80N\n1cm\t1.5kN\n",
            "0 0\n0.002 80\n0.01 1500",
        ] {
            let found = curve(text).expect("a curve");
            for (a, b) in found.deflections().iter().zip(expected.deflections()) {
                assert!((a - b).abs() < 1e-15, "{text}");
            }
            assert_eq!(found.forces(), expected.forces(), "{text}");
        }
        for (text, line) in [("", 1), ("0,0\n1,2,3", 2), ("0,0\n1N,5", 2), ("0,0\nx,y", 2), ("0,0\n1,-1", 2)]
        {
            assert_eq!(curve(text).expect_err("no curve").0, line, "{text}");
        }
    }
}
