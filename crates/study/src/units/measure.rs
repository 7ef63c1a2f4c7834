//! Quantities with their own units: stiffness, speed, force and others.

use crate::units::quantity::QuantityError;
use percuss_dynamics::input::not_a_number;

/// Kind of quantity; determines the accepted units.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// Stiffness, N/m.
    Stiffness,
    /// Rotational stiffness, N·m/rad.
    TurnStiffness,
    /// Speed, m/s.
    Speed,
    /// Angular speed, rad/s.
    TurnSpeed,
    /// Force, N.
    Force,
    /// Pressure. Default unit N/cm²; the value is in Pa.
    Pressure,
    /// Area. Default unit cm²; the value is in m².
    Area,
    /// Energy, J.
    Energy,
    /// Momentum, N·s.
    Momentum,
    /// Time, s.
    Time,
    /// Ratio: a plain number or per cent.
    Ratio,
}

/// Value in SI units, and the kind of the given unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// Value in SI units.
    pub value: f64,
    /// Quantity measured by the given unit; `None` without a unit.
    pub unit: Option<Measure>,
}

impl Measure {
    /// Units as (name, factor, divisor): SI value = number · factor / divisor. The first unit is the default.
    /// Divisors keep 12 mm/s exact, because 1/1000 is not a binary number.
    fn units(self) -> &'static [(&'static str, f64, f64)] {
        match self {
            Measure::Stiffness => &[
                ("N/m", 1.0, 1.0),
                ("MN/m", 1e6, 1.0),
                ("kN/mm", 1e6, 1.0),
                ("kN/m", 1e3, 1.0),
                ("N/mm", 1e3, 1.0),
            ],
            Measure::TurnStiffness => &[
                ("N·m/rad", 1.0, 1.0),
                ("Nm/rad", 1.0, 1.0),
                ("N·m/deg", 180.0, std::f64::consts::PI),
                ("Nm/deg", 180.0, std::f64::consts::PI),
            ],
            Measure::TurnSpeed => &[("rad/s", 1.0, 1.0), ("deg/s", std::f64::consts::PI, 180.0)],
            Measure::Speed => {
                &[("m/s", 1.0, 1.0), ("mm/s", 1.0, 1e3), ("cm/s", 1.0, 100.0), ("km/h", 1.0, 3.6)]
            }
            Measure::Force => &[("N", 1.0, 1.0), ("kN", 1e3, 1.0)],
            Measure::Pressure => &[
                ("N/cm2", 1e4, 1.0),
                ("N/mm2", 1e6, 1.0),
                ("MPa", 1e6, 1.0),
                ("kPa", 1e3, 1.0),
                ("Pa", 1.0, 1.0),
            ],
            Measure::Area => &[("cm2", 1.0, 1e4), ("mm2", 1.0, 1e6), ("m2", 1.0, 1.0)],
            Measure::Energy => &[("J", 1.0, 1.0), ("mJ", 1.0, 1e3), ("kJ", 1e3, 1.0)],
            Measure::Momentum => {
                &[("N·s", 1.0, 1.0), ("Ns", 1.0, 1.0), ("kg·m/s", 1.0, 1.0), ("kg*m/s", 1.0, 1.0)]
            }
            Measure::Time => &[("s", 1.0, 1.0), ("ms", 1.0, 1e3), ("us", 1.0, 1e6)],
            Measure::Ratio => &[("", 1.0, 1.0), ("%", 1.0, 100.0)],
        }
    }

    /// Reads a number with an optional unit: `4e5`, `400N/mm`, `-0.5 m/s`.
    ///
    /// # Errors
    /// [`QuantityError`]: no number with one of these units, or not finite.
    pub fn parse(self, text: &str) -> Result<Measured, QuantityError> {
        let trimmed = text.trim();
        let units = self.units();
        let fits = |(unit, ..): &&(&str, f64, f64)| !unit.is_empty() && trimmed.ends_with(unit);
        // The longest matching unit: `mm/s` ends in `m/s`.
        let unit = units.iter().filter(fits).max_by_key(|(unit, ..)| unit.len());
        let digits = unit.map_or(trimmed, |(unit, ..)| trimmed[..trimmed.len() - unit.len()].trim_end());
        let number: f64 = digits.parse().map_err(|_| QuantityError::NoMeasure {
            text: text.to_owned(),
            first: if units[0].0.is_empty() { String::new() } else { format!(" in {}", units[0].0) },
            units: units
                .iter()
                .map(|(unit, ..)| *unit)
                .filter(|u| !u.is_empty())
                .collect::<Vec<_>>()
                .join(", "),
        })?;
        let (_, times, over) = unit.unwrap_or(&units[0]);
        let value = number * times / over;
        if not_a_number(&[value]).is_some() {
            return Err(QuantityError::NotFinite { text: text.to_owned() });
        }
        Ok(Measured { value, unit: unit.map(|_| self) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_read() {
        for (measure, text, value) in [
            (Measure::Stiffness, "400N/mm", 4e5),
            (Measure::Stiffness, "4e5", 4e5),
            (Measure::Stiffness, "0.4 kN/mm", 4e5),
            (Measure::Stiffness, "400 kN/m", 4e5),
            (Measure::Stiffness, "4e5N/m", 4e5),
            (Measure::TurnStiffness, "2 N·m/deg", 360.0 / std::f64::consts::PI),
            (Measure::TurnStiffness, "2e3Nm/rad", 2e3),
            (Measure::TurnSpeed, "180deg/s", std::f64::consts::PI),
            (Measure::Speed, "500mm/s", 0.5),
            (Measure::Speed, "3.6km/h", 1.0),
            (Measure::Speed, "0.5m/s", 0.5),
            (Measure::Force, "0.28kN", 280.0),
            (Measure::Pressure, "170", 1.7e6),
            (Measure::Pressure, "1.7MPa", 1.7e6),
            (Measure::Area, "1", 1e-4),
            (Measure::Area, "100mm2", 1e-4),
            (Measure::Time, "0.1ms", 1e-4),
            (Measure::Ratio, "40%", 0.4),
            (Measure::Ratio, "-0.4", -0.4),
        ] {
            let got = measure.parse(text).expect(text).value;
            assert!((got - value).abs() <= 1e-15 * value.abs(), "{text}: {got}");
        }
        for (measure, text) in [
            (Measure::Stiffness, "400mm"),
            (Measure::Speed, "1N"),
            (Measure::Ratio, "1kg"),
            (Measure::Force, ""),
        ] {
            assert!(matches!(measure.parse(text), Err(QuantityError::NoMeasure { .. })), "{text}");
        }
        assert!(matches!(Measure::Force.parse("nan"), Err(QuantityError::NotFinite { .. })));
    }
}
