//! Numbers as typed by users: SI units, or with a unit suffix.

use percuss_dynamics::input::not_a_number;
use percuss_mechanism::JointKind;
use std::fmt;

/// Dimension of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dimension {
    /// Length, m.
    Length,
    /// Angle, rad.
    Angle,
    /// Mass, kg.
    Mass,
    /// Dimensionless, or a unit without a suffix in this module.
    Plain,
}

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
        "\"{text}\" is no number; expected one such as 0.5, 30deg, 12mm, 1e-3 (units: deg rad mm cm m g kg)"
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

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Dimension::Length => "a length (m)",
            Dimension::Angle => "an angle (rad)",
            Dimension::Mass => "a mass (kg)",
            Dimension::Plain => "a plain number",
        })
    }
}

impl Dimension {
    /// SI unit of the dimension; empty for a plain number.
    pub(crate) fn unit(self) -> &'static str {
        match self {
            Dimension::Length => "m",
            Dimension::Angle => "rad",
            Dimension::Mass => "kg",
            Dimension::Plain => "",
        }
    }
}

/// Units by suffix. `mm` and `cm` precede `m`, so that the suffix `m` does not match first.
const UNITS: [(&str, f64, Dimension); 7] = [
    ("deg", std::f64::consts::PI / 180.0, Dimension::Angle),
    ("rad", 1.0, Dimension::Angle),
    ("mm", 1e-3, Dimension::Length),
    ("cm", 1e-2, Dimension::Length),
    ("kg", 1.0, Dimension::Mass),
    ("m", 1.0, Dimension::Length),
    ("g", 1e-3, Dimension::Mass),
];

/// Unit of a number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Unit {
    factor: f64,
    pub dimension: Dimension,
}

impl Unit {
    /// Unit of a number without a suffix.
    pub const SI: Self = Self { factor: 1.0, dimension: Dimension::Plain };

    /// Unit with the suffix `name`.
    pub fn named(name: &str) -> Option<Self> {
        let found = UNITS.iter().find(|(known, ..)| *known == name);
        found.map(|&(_, factor, dimension)| Self { factor, dimension })
    }

    /// Converts a number in this unit to SI units.
    pub fn to_si(self, number: f64) -> f64 {
        match self.dimension {
            // Division keeps 12mm = 0.012 exact; 1/1000 is not a binary number.
            Dimension::Length | Dimension::Mass => number / (1.0 / self.factor).round(),
            Dimension::Angle | Dimension::Plain => number * self.factor,
        }
    }
}

impl fmt::Display for Quantity {
    /// Value in SI units with the unit.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let unit = match self.dimension {
            Some(Dimension::Length) => " m",
            Some(Dimension::Angle) => " rad",
            Some(Dimension::Mass) => " kg",
            Some(Dimension::Plain) | None => "",
        };
        write!(f, "{}{unit}", self.value)
    }
}

impl Quantity {
    /// Number in SI units without a unit suffix.
    ///
    /// # Errors
    /// [`QuantityError::NotFinite`].
    pub fn number(value: f64) -> Result<Self, QuantityError> {
        if not_a_number(&[value]).is_some() {
            return Err(QuantityError::NotFinite { text: value.to_string() });
        }
        Ok(Self { value, dimension: None })
    }

    /// Reads a number with an optional unit: `0.5`, `30deg`, `12mm`, `-1e-3`.
    ///
    /// # Errors
    /// [`QuantityError`]: no number, or no finite number of at most 1e100.
    pub fn parse(text: &str) -> Result<Self, QuantityError> {
        let trimmed = text.trim();
        let unit = UNITS.iter().find(|(suffix, ..)| trimmed.ends_with(suffix));
        let digits = unit.map_or(trimmed, |(suffix, ..)| trimmed[..trimmed.len() - suffix.len()].trim_end());
        let Ok(number) = digits.parse::<f64>() else {
            return Err(QuantityError::NoNumber { text: text.to_owned() });
        };
        let unit = unit.and_then(|(name, ..)| Unit::named(name));
        let value = unit.unwrap_or(Unit::SI).to_si(number);
        if not_a_number(&[value]).is_some() {
            return Err(QuantityError::NotFinite { text: text.to_owned() });
        }
        Ok(Self { value, dimension: unit.map(|unit| unit.dimension) })
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
        Dimension::Angle | Dimension::Mass | Dimension::Plain => "0,0,1",
    };
    <[f64; 3]>::try_from(list.as_slice()).map_err(|_| QuantityError::Count {
        text: text.to_owned(),
        got: list.len(),
        expected: 3,
        example,
    })
}

/// Dimension of component `i` of the position of a joint.
pub(crate) fn position_dimension(kind: JointKind, i: usize) -> Dimension {
    match kind {
        JointKind::Revolute | JointKind::Continuous => Dimension::Angle,
        JointKind::Prismatic => Dimension::Length,
        JointKind::Planar if i == 2 => Dimension::Angle,
        JointKind::Planar => Dimension::Length,
        JointKind::Floating if i < 3 => Dimension::Length,
        JointKind::Floating | JointKind::Spherical | JointKind::Fixed => Dimension::Plain,
    }
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
        assert_eq!(value(" -1e-3 "), -1e-3);
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
}
