//! Units of a table, and number of significant digits.

use percuss_study::{DecimalSign, StudyTable, TableUnit};
use percuss_suspension::LengthUnit;

/// Unit of angles in a table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Angle {
    #[default]
    Radian,
    Degree,
}

/// Style of a table.
#[derive(Clone, Copy, Debug, Default)]
pub struct TableStyle {
    pub length: LengthUnit,
    pub angle: Angle,
    /// True if column names contain units and numbers are rounded.
    pub names_units: bool,
    /// True for a decimal comma.
    pub comma: bool,
}

/// Unit of a column, and the factor from SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColumnUnit {
    pub name: &'static str,
    pub factor: f64,
}

/// Number of digits for a number without a known error.
const DIGITS: i32 = 12;
/// Positions below this value are rounding errors of loop closure, rad or m.
const ZERO_POSITION: f64 = 1e-14;

impl TableStyle {
    /// Creates the style of a study; for two units of one kind, the last counts.
    pub fn from_study(table: &StudyTable) -> Self {
        let mut style = Self { comma: table.decimal == DecimalSign::Comma, ..Self::default() };
        for unit in &table.units {
            style.names_units = true;
            match unit {
                TableUnit::Metre => style.length = LengthUnit::Metre,
                TableUnit::Millimetre => style.length = LengthUnit::Millimetre,
                TableUnit::Inch => style.length = LengthUnit::Inch,
                TableUnit::Radian => style.angle = Angle::Radian,
                TableUnit::Degree => style.angle = Angle::Degree,
            }
        }
        style
    }

    /// Name with the unit appended, if columns name their units.
    pub fn name_with_unit(&self, name: &str, unit: &str) -> String {
        if self.names_units && !unit.is_empty() { format!("{name}_{unit}") } else { name.to_owned() }
    }

    /// Unit of a column for a quantity in `rad`, `m`, or another SI unit.
    pub fn unit(&self, si: &'static str) -> ColumnUnit {
        let (name, factor) = match (si, self.angle) {
            ("m", _) => (self.length.name(), self.length.of_metres(1.0)),
            ("rad", Angle::Degree) => ("deg", 1.0_f64.to_degrees()),
            _ => (si, 1.0),
        };
        ColumnUnit { name, factor }
    }

    /// Rounds a number for output; `error` is a bound on its error, if known.
    pub fn number(&self, value: f64, error: Option<f64>) -> f64 {
        if !self.names_units {
            return value;
        }
        match error {
            Some(error) if error > 0.0 => round_to_decimals(value, (-error.log10()).floor() as i32),
            _ => round_to_digits(value, DIGITS),
        }
    }

    /// Rounds a position (rad or m) for output; a value below the rounding of loop closure becomes 0.
    pub fn position(&self, value: f64, unit: &ColumnUnit) -> f64 {
        let shown = if self.names_units && value.abs() < ZERO_POSITION { 0.0 } else { value };
        self.number(shown * unit.factor, None)
    }
}

/// Rounds to a number of significant digits.
pub fn round_to_digits(value: f64, count: i32) -> f64 {
    if value == 0.0 || !value.is_finite() {
        return value;
    }
    round_to_decimals(value, count - 1 - value.abs().log10().floor() as i32)
}

/// Rounds to a number of decimals; a negative number rounds to tens, hundreds and so on.
fn round_to_decimals(value: f64, decimals: i32) -> f64 {
    // Largest number of decimals in a double.
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
