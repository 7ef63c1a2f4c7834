//! In which units a table is written, and how many digits of its numbers are true.

use percuss_study::{StudyTable, TableUnit};
use std::f64::consts::PI;

/// The unit of a table's lengths.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Length {
    #[default]
    Metre,
    Millimetre,
}

/// The unit of a table's angles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Angle {
    #[default]
    Radian,
    Degree,
}

/// How a table is written.
#[derive(Clone, Copy, Debug, Default)]
pub struct TableStyle {
    pub length: Length,
    pub angle: Angle,
    /// Columns name their units, and numbers are rounded.
    pub names_units: bool,
    /// A decimal comma.
    pub comma: bool,
}

/// What the numbers of a column are measured in: SI, and how they are written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColumnUnit {
    pub name: &'static str,
    pub factor: f64,
}

/// Digits of a number of which no error is known.
const DIGITS: i32 = 12;
/// A position below this is where loops were closed to rounding, rad or m.
const NO_POSITION: f64 = 1e-14;

impl TableStyle {
    /// Of two units of one kind the last counts.
    pub fn of(table: &StudyTable) -> Self {
        let mut style = Self { comma: table.comma, ..Self::default() };
        for unit in &table.units {
            style.names_units = true;
            match unit {
                TableUnit::Metre => style.length = Length::Metre,
                TableUnit::Millimetre => style.length = Length::Millimetre,
                TableUnit::Radian => style.angle = Angle::Radian,
                TableUnit::Degree => style.angle = Angle::Degree,
            }
        }
        style
    }

    /// A name with the unit behind it, where columns name their units.
    pub fn named(&self, name: &str, unit: &str) -> String {
        if self.names_units && !unit.is_empty() { format!("{name}_{unit}") } else { name.to_owned() }
    }

    /// The unit of numbers that are `rad`, `m`, or anything else in SI.
    pub fn unit(&self, si: &'static str) -> ColumnUnit {
        match (si, self.length, self.angle) {
            ("m", Length::Millimetre, _) => ColumnUnit { name: "mm", factor: 1e3 },
            ("rad", _, Angle::Degree) => ColumnUnit { name: "deg", factor: 180.0 / PI },
            _ => ColumnUnit { name: si, factor: 1.0 },
        }
    }

    /// A number as it is written; `error` is a bound on its error where one is known.
    pub fn number(&self, value: f64, error: Option<f64>) -> f64 {
        if !self.names_units {
            return value;
        }
        match error {
            Some(error) if error > 0.0 => to_decimals(value, (-error.log10()).floor() as i32),
            _ => digits(value, DIGITS),
        }
    }

    /// The same of a position, rad or m: what is less than rounding of the loops is none.
    pub fn position(&self, value: f64, unit: &ColumnUnit) -> f64 {
        let shown = if self.names_units && value.abs() < NO_POSITION { 0.0 } else { value };
        self.number(shown * unit.factor, None)
    }
}

/// So many digits of a number.
pub fn digits(value: f64, count: i32) -> f64 {
    if value == 0.0 || !value.is_finite() {
        return value;
    }
    to_decimals(value, count - 1 - value.abs().log10().floor() as i32)
}

/// So many decimals; tens and hundreds where that is negative.
fn to_decimals(value: f64, decimals: i32) -> f64 {
    // More than a double has.
    let most = if value == 0.0 { 0 } else { 15 - value.abs().log10().floor() as i32 };
    let decimals = decimals.min(most);
    match decimals {
        0..=300 => format!("{value:.0$}", decimals as usize).parse().unwrap_or(value),
        -300..0 => {
            let scale = 10_f64.powi(-decimals);
            (value / scale).round() * scale
        }
        _ => value,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_rounded_to_what_is_known() {
        let style = TableStyle { names_units: true, ..TableStyle::default() };
        assert_eq!(style.number(0.050000000000000044, None), 0.05);
        assert_eq!(style.number(207.342164123456, Some(2e-7)), 207.342164);
        assert_eq!(style.number(-123456.0, Some(80.0)), -123500.0);
        assert_eq!(style.number(0.0, Some(1e-9)), 0.0);
        assert_eq!(style.number(1e-320, Some(1e-322)), 1e-320);
        assert_eq!(TableStyle::default().number(0.050000000000000044, None), 0.050000000000000044);
        for value in [1e300, -3.5e-200, f64::MAX, f64::MIN_POSITIVE] {
            assert!((style.number(value, None) / value - 1.0).abs() < 1e-11, "{value}");
        }
    }
}
