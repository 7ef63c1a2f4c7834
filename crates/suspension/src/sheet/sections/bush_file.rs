//! Reader of the bushing files of Adams/Car (`.bus`, TeimOrbit): the slopes of the curves at zero, damping, preload.
//!
//! The sections `[FX_CURVE]` to `[TZ_CURVE]` have a row `deflection force` for each point; `[DAMPING]` has a number for each direction. A curve is the
//! restoring force: its slope is a stiffness, and its value at zero a preload of the other sign. Between the points it is a spline of Akima (1970, J.
//! ACM 17), as in Adams.

use crate::findings::{Findings, Spot};
use crate::limits::{CURVED_BUSH, MAX_CURVE_POINTS, NEAR_ZERO_ANGLE, NEAR_ZERO_LENGTH};
use crate::units::short;
use percuss_formats::reading::{quoted, shortened};
use std::f64::consts::PI;

/// First part of the name of a section of a bush.
pub(in crate::sheet) const BUSH: &str = "bush";
/// Directions, in the order of the rows of a bush: rotations, then translations.
const DIRECTIONS: [&str; 6] = ["TX", "TY", "TZ", "FX", "FY", "FZ"];
/// Units of `[UNITS]` with their values in SI units.
const UNITS: [(&str, &[(&str, f64)]); 4] = [
    (
        "LENGTH",
        &[
            ("mm", 1e-3),
            ("millimeter", 1e-3),
            ("cm", 1e-2),
            ("m", 1.0),
            ("meter", 1.0),
            ("inch", 0.0254),
            ("foot", 0.3048),
        ],
    ),
    (
        "FORCE",
        &[
            ("newton", 1.0),
            ("n", 1.0),
            ("kilo_newton", 1e3),
            ("knewton", 1e3),
            ("kn", 1e3),
            ("kilogram_force", 9.80665),
            ("pound_force", 4.448_221_615_260_5),
        ],
    ),
    (
        "ANGLE",
        &[
            ("degrees", PI / 180.0),
            ("degree", PI / 180.0),
            ("deg", PI / 180.0),
            ("radians", 1.0),
            ("radian", 1.0),
            ("rad", 1.0),
        ],
    ),
    (
        "TIME",
        &[("second", 1.0), ("sec", 1.0), ("s", 1.0), ("millisecond", 1e-3), ("ms", 1e-3), ("minute", 60.0)],
    ),
];

/// Number of slopes on each side of zero that are compared with that at zero.
const COMPARED: i32 = 8;

/// Data of a bushing file in the axes of the bush, SI units; rotations first.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::sheet) struct BushFile {
    pub stiffness: [f64; 6],
    pub damping: [f64; 6],
    /// Force and moment on the link of the bush at the design position.
    pub preload: [f64; 6],
}

/// True if a text is a bushing file.
fn is_bush_file(text: &str) -> bool {
    text.lines().any(|line| {
        DIRECTIONS.iter().any(|name| line.trim().eq_ignore_ascii_case(&format!("[{name}_CURVE]")))
    })
}

/// Reads a bushing file; `file`: its index among those of the import. `None` after an error.
pub(in crate::sheet) fn read(text: &str, file: usize, findings: &mut Findings) -> Option<BushFile> {
    let at_file = |path: &str, at| Spot { path: Some(shortened(path)), at, file };
    if !is_bush_file(text) {
        let message = "the file has no curve such as [FX_CURVE]: it is no bushing file of Adams/Car";
        findings.error("wrong-kind", &at_file("", None), message.to_owned());
        return None;
    }
    let mut units: [Option<f64>; 4] = [None; 4];
    let mut numbers: Vec<(String, f64, Spot)> = Vec::new();
    let mut curves: [Option<(Vec<[f64; 2]>, Spot)>; 6] = Default::default();
    let (mut section, mut offset, mut is_comment, mut is_valid) = (String::new(), 0, false, true);
    for line in text.split_inclusive('\n') {
        let spot = at_file(&section, Some(offset));
        offset += line.len();
        let line = line.split('$').next().unwrap_or_default().trim();
        let mut refuse = |code, message: String| {
            findings.error(code, &spot, message);
            is_valid = false;
        };
        let curve = DIRECTIONS.iter().position(|name| section == format!("{name}_CURVE"));
        if line.starts_with('(') {
            is_comment = line.to_ascii_uppercase().contains("COMMENT");
        } else if let Some(name) = line.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) {
            (section, is_comment) = (name.trim().to_ascii_uppercase(), false);
        } else if is_comment || line.is_empty() || line.starts_with(['!', '{', '#']) {
            // Comments and heads of tables.
        } else if let Some((key, value)) = line.split_once('=') {
            let key = key.trim().to_ascii_uppercase();
            let value = value.trim().trim_matches(['\'', '"', ' ']).to_ascii_lowercase();
            let unit = UNITS.iter().position(|(name, _)| section == "UNITS" && *name == key);
            match (unit, value.parse::<f64>()) {
                (Some(unit), _) => {
                    let (name, known) = UNITS[unit];
                    units[unit] = known.iter().find(|(word, _)| *word == value).map(|(_, si)| *si);
                    if units[unit].is_none() {
                        let words: Vec<&str> = known.iter().map(|(word, _)| *word).collect();
                        let expected = words.join(", ");
                        refuse(
                            "unknown-word",
                            format!("{name} = {}; expected one of {expected}", quoted(&shortened(&value))),
                        );
                    }
                }
                (None, Ok(number)) if number.is_finite() => {
                    numbers.push((key, number, at_file(&section, spot.at)))
                }
                (None, Ok(_)) => {
                    refuse("not-finite", format!("{key} = {value}; a finite number is expected"))
                }
                (None, Err(_)) if section == "MDI_HEADER" || section == "UNITS" => {
                    if key == "FILE_TYPE" && value != "bus" {
                        refuse(
                            "wrong-kind",
                            format!("FILE_TYPE = {}; 'bus' is expected", quoted(&shortened(&value))),
                        );
                    }
                }
                (None, Err(_)) => {
                    let message = format!("{key} = {} is not read", quoted(&shortened(&value)));
                    findings.warning("not-read", &spot, message);
                }
            }
        } else if let Some(curve) = curve {
            let row: Vec<f64> = line.split_whitespace().map_while(|word| word.parse().ok()).collect();
            let points = &mut curves[curve].get_or_insert_with(|| (Vec::new(), spot.clone())).0;
            match (<[f64; 2]>::try_from(&row[..]), points.last()) {
                (Ok([x, force]), last)
                    if x.is_finite() && force.is_finite() && last.is_none_or(|[before, _]| *before < x) =>
                {
                    if points.len() == MAX_CURVE_POINTS {
                        refuse("too-complex", format!("more than {MAX_CURVE_POINTS} points"));
                        return None;
                    }
                    points.push([x, force]);
                }
                _ => refuse(
                    "bad-curve",
                    format!(
                        "{}; a row `deflection force` with increasing deflections is expected",
                        quoted(&shortened(line))
                    ),
                ),
            }
        } else {
            refuse(
                "unknown-key",
                format!(
                    "{} in [{section}] is not read; delete it, or give the bush in the sheet",
                    quoted(&shortened(line))
                ),
            );
        }
    }
    let missing = UNITS
        .iter()
        .zip(units)
        .filter(|((name, _), unit)| unit.is_none() && (*name != "TIME" || !numbers.is_empty()));
    let missing: Vec<&str> = missing.map(|((name, _), _)| *name).collect();
    if is_valid && !missing.is_empty() {
        let message = format!("the section [UNITS] has no {}", missing.join(", "));
        findings.error("missing-key", &at_file("UNITS", None), message);
        return None;
    }
    let [length, force, angle, time] = units.map(Option::unwrap_or_default);
    // Units of deflection and force of a direction.
    let scales = |row: usize| if row < 3 { [angle, force * length] } else { [length, force] };
    let mut found = BushFile::default();
    for (row, curve) in curves.iter().enumerate() {
        let [x_unit, f_unit] = scales(row);
        let Some((points, spot)) = curve else { continue };
        let points: Vec<[f64; 2]> = points.iter().map(|[x, f]| [x * x_unit, f * f_unit]).collect();
        let zero = points
            .len()
            .checked_sub(1)
            .filter(|last| *last > 0 && points[0][0] <= 0.0 && points[*last][0] >= 0.0);
        if zero.is_none() {
            let message = format!("the curve {} has no two points with zero between them", DIRECTIONS[row]);
            findings.error("bad-curve", spot, message);
            is_valid = false;
            continue;
        }
        let [value, slope] = akima(&points, 0.0);
        (found.stiffness[row], found.preload[row]) = (slope, -value);
        if !(slope >= 0.0 && slope.is_finite() && value.is_finite()) {
            let message = format!(
                "the curve {} falls at zero: its slope is {}; a restoring force is expected",
                DIRECTIONS[row],
                short(slope)
            );
            findings.error("bad-curve", spot, message);
            is_valid = false;
        }
        let near = if row < 3 { NEAR_ZERO_ANGLE } else { NEAR_ZERO_LENGTH };
        let slope_at = |part: i32| {
            let x = near * f64::from(part) / f64::from(COMPARED);
            akima(&points, x.clamp(points[0][0], points[points.len() - 1][0]))[1]
        };
        let slopes = (-COMPARED..=COMPARED).map(slope_at);
        let farthest = slopes.max_by(|a, b| (a - slope).abs().total_cmp(&(b - slope).abs()));
        if let Some(other) = farthest.filter(|other| (other - slope).abs() > CURVED_BUSH * slope.abs()) {
            let (unit, range) = if row < 3 { ("N·m/rad", "1 deg") } else { ("N/m", "1 mm") };
            let message = format!(
                "the curve {} is not linear: its slope is {} {unit} at zero, which is used, and {} {unit} within ±{range}",
                DIRECTIONS[row],
                short(slope),
                short(other)
            );
            findings.warning("curved-bush", spot, message);
        }
    }
    for (key, number, spot) in numbers {
        let row = DIRECTIONS.iter().position(|name| key.starts_with(&format!("{name}_")));
        match (row, key.get(3..).unwrap_or_default()) {
            (Some(row), "DAMPING") if number >= 0.0 => {
                let [x_unit, f_unit] = scales(row);
                found.damping[row] = number * f_unit * time / x_unit;
            }
            (Some(row), "PRELOAD") => found.preload[row] += number * scales(row)[1],
            _ if number == 0.0 || ["MDI_HEADER", "UNITS"].contains(&spot.label()) => {}
            _ => {
                let message = format!(
                    "{key} = {number} is not read; 0 is expected: offsets, scales and couplings have no counterpart in a bush"
                );
                findings.error("unknown-key", &spot, message);
                is_valid = false;
            }
        }
    }
    is_valid.then_some(found)
}

/// Value and slope at x of the spline of Akima through at least two points with increasing x.
fn akima(points: &[[f64; 2]], x: f64) -> [f64; 2] {
    let slopes: Vec<f64> =
        points.windows(2).map(|pair| (pair[1][1] - pair[0][1]) / (pair[1][0] - pair[0][0])).collect();
    let last = slopes.len() as isize - 1;
    // Slopes beyond the ends continue in a parabola.
    let slope = |i: isize| match i {
        i if i < 0 => {
            let [a, b] = [slopes[0], slopes[usize::from(last > 0)]];
            a + (a - b) * i.unsigned_abs() as f64
        }
        i if i > last => {
            let [a, b] = [slopes[last as usize], slopes[(last - 1).max(0) as usize]];
            a + (a - b) * (i - last) as f64
        }
        i => slopes[i as usize],
    };
    let tangent = |i: isize| {
        let [before, left, right, after] = [i - 2, i - 1, i, i + 1].map(slope);
        let [a, b] = [(after - right).abs(), (left - before).abs()];
        // Four slopes in pairs of equal ones: the mean.
        if a + b == 0.0 { (left + right) / 2.0 } else { (a * left + b * right) / (a + b) }
    };
    let interval = points.partition_point(|point| point[0] <= x).clamp(1, points.len() - 1) - 1;
    let [[x0, f0], [x1, _]] = [points[interval], points[interval + 1]];
    let (h, s, i) = (x1 - x0, x - x0, interval as isize);
    let [t0, t1, m] = [tangent(i), tangent(i + 1), slopes[interval]];
    let [c2, c3] = [(3.0 * m - 2.0 * t0 - t1) / h, (t0 + t1 - 2.0 * m) / (h * h)];
    [f0 + s * (t0 + s * (c2 + s * c3)), t0 + s * (2.0 * c2 + s * 3.0 * c3)]
}

#[cfg(test)]
mod tests {
    use super::akima;

    /// On equidistant points of a parabola all differences of slopes are equal, with the slopes beyond the ends too: the tangents are those of
    /// the parabola, and the spline is the parabola.
    #[test]
    fn a_parabola_is_reproduced_to_its_ends() {
        let parabola = |x: f64| [3.0 - 2.0 * x + 0.7 * x * x, -2.0 + 1.4 * x];
        for count in [3, 4, 5, 9] {
            let points: Vec<[f64; 2]> =
                (0..count).map(|i| f64::from(i) - 1.5).map(|x| [x, parabola(x)[0]]).collect();
            for k in 0..=10 * (count - 1) {
                let x = 0.1 * f64::from(k) - 1.5;
                let (found, expected) = (akima(&points, x), parabola(x));
                for (a, b) in found.into_iter().zip(expected) {
                    assert!((a - b).abs() < 1e-13 * (1.0 + b.abs()), "{count} points, {x}: {found:?}");
                }
            }
        }
    }

    /// Straight parts stay straight: with two equal slopes on one side of a point, its tangent is that slope.
    #[test]
    fn a_corner_does_not_bend_straight_parts() {
        let points = [[-3.0, 3.0], [-1.0, 1.0], [0.0, 0.0], [0.5, 2.0], [2.0, 8.0]];
        for (x, value, slope) in [(-2.0, 2.0, -1.0), (1.0, 4.0, 4.0)] {
            let found = akima(&points, x);
            assert!((found[0] - value).abs() < 1e-14 && (found[1] - slope).abs() < 1e-14, "{x}: {found:?}");
        }
    }
}
