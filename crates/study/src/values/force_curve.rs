//! Force curve of a contact as given by the user, or by a suspension sheet.

use crate::model::loading::refuse_pipe;
use crate::values::quantities::{Force, Length, schema_of};
use crate::values::text_layout::{ColumnKind, DecimalMark, no_unit, separator, unit};
use percuss_contact::ForceCurve;
use percuss_units::{Dimension, QuantityError, Unit};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::io::Read;
use std::sync::Arc;

/// Largest deflection without any unit in the table, m: a contact is not compressed by metres.
const DEEPEST_WITHOUT_UNIT: f64 = 3.0;

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

/// Points of a curve, or a sum of powers Σ cᵢ x^pᵢ.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
#[derive(Default)]
struct CurveText {
    /// Penetrations (m), increasing from 0.
    deflections: Vec<Length>,
    /// Force at each penetration (N).
    forces: Vec<Force>,
    /// Coefficients of powers (N/m^p), in place of points.
    coefficients: Vec<f64>,
    /// Exponents of the powers; default: 1, 2, 3, ….
    exponents: Vec<f64>,
    /// Last penetration of the sum of powers (m); its slope continues beyond.
    to: Option<Length>,
}

schema_of!(GivenCurve, CurveText);

impl TryFrom<CurveText> for GivenCurve {
    type Error = String;
    fn try_from(text: CurveText) -> Result<Self, String> {
        let CurveText { deflections, forces, coefficients, exponents, to } = text;
        let is_points = coefficients.is_empty() && exponents.is_empty() && to.is_none();
        let curve = if is_points {
            let x = deflections.into_iter().map(|length| length.0).collect();
            ForceCurve::new(x, forces.into_iter().map(|force| force.0).collect())
        } else {
            let count = coefficients.len();
            let exponents =
                if exponents.is_empty() { (1..=count).map(|p| p as f64).collect() } else { exponents };
            let (Some(to), true, true) =
                (to, exponents.len() == count, deflections.is_empty() && forces.is_empty())
            else {
                return Err(
                    "expected `coefficients` and `to`, with an exponent for each or none, without points"
                        .into(),
                );
            };
            ForceCurve::powers(coefficients.into_iter().zip(exponents).collect(), to.0)
        };
        Ok(Self { curve: Arc::new(curve.map_err(|error| error.to_string())?), stop: None })
    }
}

/// Curve in one text: points `0:0,10mm:500N,20mm:3kN`, or powers with their last penetration `x:200N/mm,x^3:0.4N/mm^3,to:40mm`. `None` for a
/// text of another form, such as the name of a file.
fn curve_in_text(text: &str) -> Option<Result<ForceCurve, String>> {
    let pairs: Vec<(&str, &str)> =
        text.split(',').map(|pair| pair.split_once(':')).collect::<Option<Vec<_>>>()?;
    let is_curve =
        |(x, _): &(&str, &str)| *x == "to" || x.starts_with(|c: char| c == 'x' || c.is_ascii_digit());
    pairs.iter().all(is_curve).then(|| {
        let wrong = |error: QuantityError| error.to_string();
        if !pairs[0].0.starts_with('x') {
            let x = pairs.iter().map(|(x, _)| x.parse::<Length>().map(|x| x.0)).collect::<Result<_, _>>();
            let f = pairs.iter().map(|(_, f)| f.parse::<Force>().map(|f| f.0)).collect::<Result<_, _>>();
            return ForceCurve::new(x.map_err(wrong)?, f.map_err(wrong)?).map_err(|error| error.to_string());
        }
        let Some((("to", last), powers)) = pairs.split_last() else {
            return Err("expected the last penetration of this law at the end, such as to:40mm".into());
        };
        let power = |(x, c): &(&str, &str)| {
            let exponent = match *x {
                "x" => "1",
                other => other.strip_prefix("x^").ok_or_else(|| format!("\"{x}\"; expected x or x^P"))?,
            };
            let p = exponent.parse::<f64>().map_err(|_| format!("\"{exponent}\" is not an exponent"))?;
            coefficient(c, exponent, p).map(|c| (c, p)).ok_or_else(|| {
                format!("\"{c}\"; expected a number in N/m^{exponent}, or with N/mm^{exponent} behind")
            })
        };
        let powers = powers.iter().map(power).collect::<Result<Vec<_>, String>>()?;
        ForceCurve::powers(powers, last.parse::<Length>().map_err(wrong)?.0)
            .map_err(|error| error.to_string())
    })
}

/// Coefficient of x^p in N/m^p, from a number without unit or with `N/m^p`, `N/mm^p`, `kN/mm^p`.
fn coefficient(text: &str, exponent: &str, p: f64) -> Option<f64> {
    let (number, unit) = percuss_units::split(text);
    let number = number.trim().parse::<f64>().ok()?;
    let power = if p == 1.0 { String::new() } else { format!("^{exponent}") };
    let units =
        [("", 1.0, 0.0), ("N/m", 1.0, 0.0), ("N/mm", 1.0, 3.0), ("kN/m", 1e3, 0.0), ("kN/mm", 1e3, 3.0)];
    let (_, factor, digits) = units.into_iter().find(|(name, ..)| match *name {
        "" => unit.is_empty(),
        name => unit == format!("{name}{power}"),
    })?;
    Some(number * factor * 10f64.powf(digits * p))
}

impl GivenCurve {
    /// Curve of a stop in a suspension sheet.
    pub(crate) fn of_stop(name: &str, curve: &ForceCurve) -> Self {
        Self { curve: Arc::new(curve.clone()), stop: Some(name.to_owned()) }
    }

    /// Reads the points or powers of a text (`0:0,10mm:500N`, `x:200N/mm,x^3:0.4N/mm^3,to:40mm`), or a file with a table of two columns, deflection and force, separated by commas, semicolons or tabs. Lines from `#` on are ignored. Numbers
    /// have a decimal point or comma, and units (`2mm`, `1.5kN`), or the units of a header (`deflection (mm), force (N)`; `mm, N`), or are in m and N.
    ///
    /// # Errors
    /// A message: an unreadable file, a line without two quantities, points that are no curve.
    pub fn read(path: &str) -> Result<Self, String> {
        if let Some(curve) = curve_in_text(path) {
            return curve.map(|curve| Self { curve: Arc::new(curve), stop: None });
        }
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
        let mut units = [None, None];
        let (mut points, mut last, mut is_exchanged) = ([Vec::new(), Vec::new()], 0, false);
        let mut mark = DecimalMark::default();
        let text = text.trim_start_matches('\u{feff}');
        for (number, line) in text.lines().enumerate().map(|(i, line)| (i + 1, line)) {
            let line = line.split('#').next().unwrap_or_default().trim();
            if line.is_empty() {
                continue;
            }
            let cells: Vec<&str> =
                line.split(separator(line)).map(str::trim).filter(|cell| !cell.is_empty()).collect();
            let [x, f] = cells[..] else {
                return Err((number, format!("{} cells; expected two, deflection and force", cells.len())));
            };
            let is_header = |cell: &str| cell.starts_with(|c: char| c.is_alphabetic() || "[(".contains(c));
            let is_head = last == 0 && is_header(x) && is_header(f);
            is_exchanged |= is_head && force_is_first([x, f]).map_err(|why| (number, why))?;
            let [x, f] = if is_exchanged { [f, x] } else { [x, f] };
            if is_head {
                for (own, (cell, dimension)) in
                    units.iter_mut().zip([(x, Dimension::Length), (f, Dimension::Force)])
                {
                    *own = unit_of_head(cell, dimension).map_err(|why| (number, why))?.or(*own);
                }
                continue;
            }
            // A number takes the unit of its column.
            let mut with_unit = |cell: &str, unit: Option<&Unit>| -> Result<String, (usize, String)> {
                let cell = mark.with_point(cell).map_err(|why| (number, why))?;
                let unit = unit.filter(|_| cell.parse::<f64>().is_ok()).map_or("", |unit| unit.name);
                Ok(format!("{cell}{unit}"))
            };
            let fault = |error: QuantityError| (number, error.to_string());
            points[0].push(with_unit(x, units[0])?.parse::<Length>().map_err(fault)?.0);
            points[1].push(with_unit(f, units[1])?.parse::<Force>().map_err(fault)?.0);
            last = number;
        }
        let [x, f] = points;
        let deepest = x.last().copied().filter(|_| units[0].is_none() && !text.contains(char::is_alphabetic));
        if let Some(deepest) = deepest.filter(|deepest| *deepest > DEEPEST_WITHOUT_UNIT) {
            let why = format!(
                "a deflection of {deepest} m: numbers without a unit are in m; name the columns with their units, such as \
                 \"deflection (mm), force (N)\""
            );
            return Err((last, why));
        }
        let curve = ForceCurve::new(x, f).map_err(|error| (last.max(1), error.to_string()))?;
        Ok(Self { curve: Arc::new(curve), stop: None })
    }
}

/// True for a head with the force first and the deflection second. Error: a head that names neither column, or another quantity.
fn force_is_first(heads: [&str; 2]) -> Result<bool, String> {
    use ColumnKind::{Displacement, Force};
    let kind = |head: &str| {
        let of_unit = [(Dimension::Length, Displacement), (Dimension::Force, Force)];
        let of_unit = of_unit.into_iter().find(|(dimension, _)| unit(head, *dimension).is_some());
        let of_words = || ColumnKind::of_head(head.split(['(', '[']).next().unwrap_or_default());
        of_unit.map(|(_, kind)| kind).or_else(|| of_words().ok().map(|(kind, _)| kind))
    };
    match heads.map(kind) {
        [Some(Force), Some(Displacement)] => Ok(true),
        [Some(Displacement), Some(Force) | None] | [None, Some(Force)] => Ok(false),
        _ => Err(format!(
            "the columns {:?} and {:?} are no deflection and force; expected a head such as \"deflection (mm), force (N)\"",
            heads[0], heads[1]
        )),
    }
}

/// Unit in a head of a column: alone, in brackets, or behind a word. Error: a unit that is not known.
fn unit_of_head(head: &str, dimension: Dimension) -> Result<Option<&'static Unit>, String> {
    let bracket = head.split_once(['(', '[']).map(|(_, rest)| rest);
    let behind = bracket.or_else(|| head.rsplit_once(['_', ' ', '/']).map(|(_, rest)| rest));
    match (unit(head, dimension).or_else(|| unit(behind?, dimension)), ColumnKind::of_head(head)) {
        (Some(unit), _) => Ok(Some(unit)),
        // A word without a unit, or words that are all known.
        (None, found) if behind.is_none() || bracket.is_none() && found.is_ok() => Ok(None),
        (None, _) => Err(no_unit(behind.unwrap_or_default().trim_end_matches([')', ']']), dimension)),
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
    /// Coefficients of the sum of powers between both penetrations, N/m^p; empty for points with lines.
    pub coefficients: Vec<f64>,
    /// Exponents p of the powers.
    pub exponents: Vec<f64>,
}

impl From<&GivenCurve> for ForceCurveRecord {
    fn from(given: &GivenCurve) -> Self {
        let (deflections, forces) = (given.curve.deflections().to_vec(), given.curve.forces().to_vec());
        let (coefficients, exponents) = given.curve.terms().iter().copied().unzip();
        Self { stop: given.stop.clone(), deflections, forces, coefficients, exponents }
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
            "Weg [mm];Kraft [kN]\n0;0\n2;0,08\n10,0;1,5\n",
            "mm,N\n0,0\n2,80\n10,1500",
            "deflection,force\nmm,N\n0,0\n2,80\n10,1500",
            "force,deflection\n0,0\n80,0.002\n1500,0.01",
            "Kraft [N];Weg [mm]\n0;0\n80;2\n1500;10",
            "kN,mm\n0,0\n0.08,2\n1.5,10",
            "x (mm), F (N)\n0,0\n2,80\n10,1500",
        ] {
            let found = curve(text).expect("a curve");
            for (a, b) in found.deflections().iter().zip(expected.deflections()) {
                assert!((a - b).abs() < 1e-15, "{text}");
            }
            assert_eq!(found.forces(), expected.forces(), "{text}");
        }
        for text in
            ["x:200N/mm,x^3:0.4N/mm^3,to:40mm", "x:2e5,x^3:4e8,to:0.04", "x:0.2kN/mm,x^3:4e8N/m^3,to:4cm"]
        {
            let found = GivenCurve::read(text).expect("powers").curve;
            assert!((found.at(0.01).0 - 2400.0).abs() < 1e-9, "{text}: {:?}", found.at(0.01));
        }
        let points = GivenCurve::read("0:0,2mm:80N,1cm:1.5kN").expect("points").curve;
        assert_eq!(points.forces(), expected.forces());
        for wrong in ["x:200N/mm", "x^2:3N/mm,to:1cm", "y:3,to:1", "x^11:1,to:1cm", "x:-3,to:1cm", "0:0,1cm"]
        {
            assert!(GivenCurve::read(wrong).is_err(), "{wrong}");
        }
        for (text, line) in [
            ("a,b\n0,0\n1,2", 1),
            ("time,force\n0,0\n1,2", 1),
            ("0,0\n2,80\n10,1500", 3),
            ("", 1),
            ("0,0\n1,2,3", 2),
            ("0,0\n1N,5", 2),
            ("0,0\nx,y", 2),
            ("0,0\n1,-1", 2),
        ] {
            assert_eq!(curve(text).expect_err("no curve").0, line, "{text}");
        }
    }
}
