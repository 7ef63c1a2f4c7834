//! Numbers as typed by users: SI units, or with a unit suffix.

use crate::unit::{Dimension, Unit};
use std::fmt;

/// Largest magnitude of a number.
pub const LARGEST_NUMBER: f64 = 1e100;

/// Dimensions of the numbers that [`Quantity::parse`] reads.
const GEOMETRIC: [Dimension; 3] = [Dimension::Length, Dimension::Angle, Dimension::Mass];

/// Number and the dimension of its unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantity {
    /// Value in SI units.
    pub value: f64,
    /// Dimension of the unit; `None` without a unit.
    pub dimension: Option<Dimension>,
}

/// Error of a number: not a number, or in the wrong unit.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum QuantityError {
    /// Text is not a number with one of the units.
    #[error(
        "\"{text}\" is no number; expected one such as 0.5, 30deg, 12mm, 1e-3 (units: {})", unit_names(&GEOMETRIC, " ")
    )]
    NoNumber {
        /// Given text.
        text: String,
    },
    /// Text is not a number with one of the units of the quantity.
    #[error("\"{text}\" is no number here; expected a number{first}, or with one of the units {units}")]
    NoMeasure {
        /// Given text.
        text: String,
        /// Default unit, preceded by `in`; empty if the quantity needs no unit.
        first: String,
        /// Accepted units.
        units: String,
    },
    /// NaN, infinite or above 1e100 in magnitude.
    #[error("\"{text}\" is not finite or above 1e100; expected a finite number of at most 1e100")]
    NotFinite {
        /// Given text.
        text: String,
    },
    /// Unit of another dimension.
    #[error("\"{text}\" is {got}; expected {expected}")]
    WrongUnit {
        /// Given text.
        text: String,
        /// Dimension of the given unit.
        got: Dimension,
        /// Expected dimension.
        expected: Dimension,
    },
    /// List of the wrong length.
    #[error("\"{text}\" has {got} numbers; expected {expected}, as in {example}")]
    Count {
        /// Given text.
        text: String,
        /// Number of values.
        got: usize,
        /// Expected number of values.
        expected: usize,
        /// Example of the expected form.
        example: &'static str,
    },
}

/// Names of the units of some dimensions.
fn unit_names(dimensions: &[Dimension], separator: &str) -> String {
    let units = dimensions.iter().flat_map(|dimension| dimension.units());
    units.map(|unit| unit.name).collect::<Vec<_>>().join(separator)
}

/// Splits a text into its number and the name of its unit, which may be empty: `-1,5 deg` into `-1,5` and `deg`.
pub fn split(text: &str) -> (&str, &str) {
    let text = text.trim();
    let is_part = |c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '.' | ',' | 'e' | 'E');
    let end = text.find(|c| !is_part(c)).unwrap_or(text.len());
    (&text[..end], text[end..].trim())
}

/// Number and unit of a text; `None` unless the text is a number with a unit of one of the dimensions, or without a unit.
fn number_and_unit(text: &str, dimensions: &[Dimension]) -> Option<(f64, Option<&'static Unit>)> {
    // Words for numbers, such as `inf`, are numbers without a unit.
    if let Ok(number) = text.trim().parse() {
        return Some((number, None));
    }
    let (number, name) = product(text)?;
    Some((number, if name.is_empty() { None } else { Some(Unit::named(name, dimensions)?) }))
}

/// Value of a product at the beginning of a text, and the rest: `1e-5*100^2 kg m2` is 0.1 and `kg m2`. The signs are *, / and ^; a sign before
/// a unit, as in `5 N/m`, belongs to the unit.
fn product(text: &str) -> Option<(f64, &str)> {
    let begins_number = |text: &str| text.trim_start().starts_with(|c: char| c.is_ascii_digit() || c == '.');
    let power = |text| {
        let (base, rest) = split(text);
        let base: f64 = base.parse().ok()?;
        match rest.strip_prefix('^').filter(|exponent| begins_number(exponent)) {
            // The sign of −2² is ambiguous.
            Some(_) if base.is_sign_negative() => None,
            Some(exponent) => {
                let (exponent, rest) = split(exponent);
                Some((base.powf(exponent.parse().ok()?), rest))
            }
            None => Some((base, rest)),
        }
    };
    let (mut value, mut rest) = power(text)?;
    while let Some(factor) = rest.strip_prefix(['*', '×', '/']).filter(|factor| begins_number(factor)) {
        let (other, after) = power(factor)?;
        if rest.starts_with('/') {
            value /= other;
        } else {
            value *= other;
        }
        rest = after;
    }
    Some((value, rest))
}

/// Value in SI units with the unit.
impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.dimension.map_or("", Dimension::si_unit) {
            "" => write!(f, "{}", self.value),
            unit => write!(f, "{} {unit}", self.value),
        }
    }
}

impl Quantity {
    /// Number without a unit, taken as SI.
    ///
    /// # Errors
    /// [`QuantityError::NotFinite`].
    pub fn number(value: f64) -> Result<Self, QuantityError> {
        Self::checked(value, None, &value.to_string())
    }

    /// Reads a length, an angle or a mass, or a number without a unit: `0.5`, `30deg`, `12mm`, `-1e-3`.
    ///
    /// # Errors
    /// [`QuantityError`]: no number, or no finite number of at most 1e100.
    pub fn parse(text: &str) -> Result<Self, QuantityError> {
        let Some((number, unit)) = number_and_unit(text, &GEOMETRIC) else {
            return Err(QuantityError::NoNumber { text: text.to_owned() });
        };
        Self::checked(unit.map_or(number, |unit| unit.to_si(number)), unit.map(|unit| unit.dimension), text)
    }

    /// Reads a number in SI units, or with a unit of one of the dimensions.
    ///
    /// # Errors
    /// [`QuantityError`]: no number with one of these units, or no finite number of at most 1e100.
    pub fn parse_as(text: &str, dimensions: &[Dimension]) -> Result<Self, QuantityError> {
        let Some((number, unit)) = number_and_unit(text, dimensions) else {
            let units: Vec<&str> = dimensions.iter().map(|dimension| dimension.si_unit()).collect();
            return Err(QuantityError::NoMeasure {
                text: text.to_owned(),
                first: format!(" in {}", units.join(" or ")),
                units: unit_names(dimensions, ", "),
            });
        };
        Self::checked(unit.map_or(number, |unit| unit.to_si(number)), unit.map(|unit| unit.dimension), text)
    }

    fn checked(value: f64, dimension: Option<Dimension>, text: &str) -> Result<Self, QuantityError> {
        if value.abs() <= LARGEST_NUMBER {
            Ok(Self { value, dimension })
        } else {
            Err(QuantityError::NotFinite { text: text.to_owned() })
        }
    }

    /// Value in SI units, if the number has no unit or a unit of dimension `expected`.
    ///
    /// # Errors
    /// [`QuantityError::WrongUnit`].
    pub fn in_dimension(self, expected: Dimension, text: &str) -> Result<f64, QuantityError> {
        match self.dimension {
            Some(got) if got != expected => {
                Err(QuantityError::WrongUnit { text: text.trim().to_owned(), got, expected })
            }
            _ => Ok(self.value),
        }
    }
}

impl Dimension {
    /// Reads a number in the default unit, or with a unit of this dimension: `4e5`, `400N/mm`, `-0.5 m/s`.
    ///
    /// # Errors
    /// [`QuantityError`]: no number with one of these units, or no finite number of at most 1e100.
    pub fn parse(self, text: &str) -> Result<Quantity, QuantityError> {
        let Some((number, unit)) = number_and_unit(text, &[self]) else {
            return Err(QuantityError::NoMeasure {
                text: text.to_owned(),
                first: self.default_unit().map_or_else(String::new, |unit| format!(" in {}", unit.name)),
                units: unit_names(&[self], ", "),
            });
        };
        let value = unit.or(self.default_unit()).map_or(number, |unit| unit.to_si(number));
        Quantity::checked(value, unit.map(|unit| unit.dimension), text)
    }
}

/// Reads comma-separated numbers; `dimensions(i)` is the dimension of number `i`.
///
/// # Errors
/// [`QuantityError`] of the first invalid number.
pub fn parse_list(text: &str, dimensions: impl Fn(usize) -> Dimension) -> Result<Vec<f64>, QuantityError> {
    text.split(',')
        .enumerate()
        .map(|(i, part)| Quantity::parse(part)?.in_dimension(dimensions(i), part))
        .collect()
}

/// Reads three comma-separated numbers of one dimension.
///
/// # Errors
/// [`QuantityError`]: not three, no numbers, the wrong unit.
pub fn parse_triple(text: &str, dimension: Dimension) -> Result<[f64; 3], QuantityError> {
    let list = parse_list(text, |_| dimension)?;
    let example = match dimension {
        Dimension::Length => "0.5,0,-20mm",
        _ => "0,0,1",
    };
    <[f64; 3]>::try_from(list.as_slice()).map_err(|_| QuantityError::Count {
        text: text.to_owned(),
        got: list.len(),
        expected: 3,
        example,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_exact() {
        let value = |text| Quantity::parse(text).unwrap().value;
        assert_eq!(value("12mm"), 0.012);
        assert_eq!(value("-3 cm"), -0.03);
        assert_eq!(value("250g"), 0.25);
        assert_eq!(value("2kg"), 2.0);
        assert_eq!(value("1.5m"), 1.5);
        assert_eq!(value("180deg"), std::f64::consts::PI);
        assert_eq!(value("180 °"), std::f64::consts::PI);
        assert_eq!(value("1in"), 0.0254);
        assert_eq!(value("1.5t"), 1500.0);
        assert_eq!(value(" -1e-3 "), -1e-3);
    }

    #[test]
    fn products_are_computed() {
        for (text, value) in
            [("1e-5*100^2", 0.1), ("1/4", 0.25), ("2 * 3 ^ 2 / 9", 2.0), ("-2*3", -6.0), ("0.5×4", 2.0)]
        {
            assert!((Dimension::Plain.parse(text).unwrap().value - value).abs() < 1e-15, "{text}");
        }
        assert!((Dimension::Inertia.parse("1e-5*100^2 kg m2").unwrap().value - 0.1).abs() < 1e-15);
        assert_eq!(Dimension::Stiffness.parse("5 N/m").unwrap().value, 5.0);
        assert_eq!(Quantity::parse("2*12mm").unwrap().value, 0.024);
        for text in ["2*", "*2", "2^", "-2^2", "2//3", "2*3*", "1/0", "2**3"] {
            assert!(Quantity::parse(text).is_err(), "{text}");
        }
    }

    #[test]
    fn nonsense_is_refused() {
        for text in ["", "m", "1,5", "1..2", "abc", "1kgm", "--1"] {
            assert!(matches!(Quantity::parse(text), Err(QuantityError::NoNumber { .. })), "{text}");
        }
        for text in ["nan", "inf", "-inf", "1e999"] {
            assert!(matches!(Quantity::parse(text), Err(QuantityError::NotFinite { .. })), "{text}");
        }
        assert!(matches!(parse_triple("1,2", Dimension::Length), Err(QuantityError::Count { got: 2, .. })));
        assert!(matches!(parse_triple("1deg,2,3", Dimension::Length), Err(QuantityError::WrongUnit { .. })));
    }

    #[test]
    fn units_of_a_dimension_are_read() {
        for (dimension, text, value) in [
            (Dimension::Stiffness, "400N/mm", 4e5),
            (Dimension::Stiffness, "4e5", 4e5),
            (Dimension::Stiffness, "0.4 kN/mm", 4e5),
            (Dimension::Stiffness, "400 kN/m", 4e5),
            (Dimension::Stiffness, "4e5N/m", 4e5),
            (Dimension::Stiffness, "160 lbf/in", 160.0 * 4.4482216152605 / 0.0254),
            (Dimension::Mass, "10 lb", 4.5359237),
            (Dimension::Force, "1 lbf", 4.4482216152605),
            (Dimension::Inertia, "1000 lb in2", 453.59237 * 0.0254 * 0.0254),
            (Dimension::RotationalStiffness, "2 N·m/deg", 360.0 / std::f64::consts::PI),
            (Dimension::RotationalStiffness, "2e3Nm/rad", 2e3),
            (Dimension::AngularSpeed, "180deg/s", std::f64::consts::PI),
            (Dimension::AngularSpeed, "30rpm", std::f64::consts::PI),
            (Dimension::Moment, "2 kN·m", 2e3),
            (Dimension::AngularMomentum, "0.5Nms", 0.5),
            (Dimension::RotationalDamping, "1N·m·s/deg", 180.0 / std::f64::consts::PI),
            (Dimension::Damping, "3 N·s/mm", 3e3),
            (Dimension::Speed, "500mm/s", 0.5),
            (Dimension::Speed, "3.6km/h", 1.0),
            (Dimension::Speed, "0.5m/s", 0.5),
            (Dimension::Force, "0.28kN", 280.0),
            (Dimension::Pressure, "170", 1.7e6),
            (Dimension::Pressure, "1.7MPa", 1.7e6),
            (Dimension::Area, "1", 1e-4),
            (Dimension::Area, "100mm2", 1e-4),
            (Dimension::Time, "0.1ms", 1e-4),
            (Dimension::Ratio, "40%", 0.4),
            (Dimension::Ratio, "-0.4", -0.4),
        ] {
            let got = dimension.parse(text).expect(text).value;
            assert!((got - value).abs() <= 1e-15 * value.abs(), "{text}: {got}");
        }
        for (dimension, text) in [
            (Dimension::Stiffness, "400mm"),
            (Dimension::Speed, "1N"),
            (Dimension::Ratio, "1kg"),
            (Dimension::Force, ""),
        ] {
            assert!(matches!(dimension.parse(text), Err(QuantityError::NoMeasure { .. })), "{text}");
        }
        assert!(matches!(Dimension::Force.parse("nan"), Err(QuantityError::NotFinite { .. })));
    }
}
