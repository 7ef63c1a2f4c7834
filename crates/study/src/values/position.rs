//! Position of a joint as given by the user. Each number keeps the dimension of its unit until the kind of the
//! joint is known.

use percuss_mechanism::JointKind;
use percuss_units::{Dimension, Quantity, QuantityError};
use std::fmt;
use std::str::FromStr;

/// Position of a joint, in the layout of the joint's kind.
#[derive(Clone, Debug, PartialEq)]
pub struct GivenPosition {
    values: Vec<Quantity>,
    /// Text as typed, for reports only.
    text: String,
}

impl FromStr for GivenPosition {
    type Err = QuantityError;
    fn from_str(text: &str) -> Result<Self, QuantityError> {
        Self::parse(text)
    }
}

impl fmt::Display for GivenPosition {
    /// Writes the position as typed.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl GivenPosition {
    /// Reads comma-separated numbers with optional units: `30deg`, `1,0,0,0`.
    ///
    /// # Errors
    /// [`QuantityError`] of the first invalid number.
    pub fn parse(text: &str) -> Result<Self, QuantityError> {
        let values = text.split(',').map(Quantity::parse).collect::<Result<_, _>>()?;
        Ok(Self { values, text: text.to_owned() })
    }

    /// Position from numbers in SI units.
    ///
    /// # Errors
    /// [`QuantityError::NotFinite`].
    pub fn from_numbers(numbers: &[f64]) -> Result<Self, QuantityError> {
        let values = numbers.iter().map(|x| Quantity::number(*x)).collect::<Result<_, _>>()?;
        let text = numbers.iter().map(f64::to_string).collect::<Vec<_>>().join(",");
        Ok(Self { values, text })
    }

    /// The single number of a position, with the dimension of its unit; `None` for several numbers.
    pub(crate) fn single(&self) -> Option<Quantity> {
        let [quantity] = self.values[..] else { return None };
        Some(quantity)
    }

    /// Text as typed.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Values in SI units, if the units match the kind of the joint.
    ///
    /// # Errors
    /// [`QuantityError::WrongUnit`].
    pub(crate) fn values_for_joint(&self, kind: JointKind) -> Result<Vec<f64>, QuantityError> {
        let value = |(i, quantity): (usize, &Quantity)| {
            quantity.in_dimension(position_dimension(kind, i), &quantity.to_string())
        };
        self.values.iter().enumerate().map(value).collect()
    }
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
    fn units_are_checked_against_the_kind_of_the_joint() {
        let planar = GivenPosition::parse("12mm,1,90deg").unwrap();
        assert_eq!(
            planar.values_for_joint(JointKind::Planar).unwrap(),
            [0.012, 1.0, std::f64::consts::FRAC_PI_2]
        );
        assert!(matches!(planar.values_for_joint(JointKind::Revolute), Err(QuantityError::WrongUnit { .. })));
        assert_eq!(
            GivenPosition::from_numbers(&[0.5]).unwrap().values_for_joint(JointKind::Prismatic).unwrap(),
            [0.5]
        );
        assert!(matches!(GivenPosition::from_numbers(&[f64::NAN]), Err(QuantityError::NotFinite { .. })));
    }
}
