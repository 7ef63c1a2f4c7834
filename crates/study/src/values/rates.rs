//! Velocities of a joint as given by the user.

use percuss_mechanism::JointKind;
use percuss_units::{Dimension, Quantity, QuantityError};
use std::str::FromStr;

/// Velocities of a joint, in the layout of the joint's kind. Each number keeps the dimension of its unit until the kind
/// of the joint is known.
#[derive(Clone, Debug, PartialEq)]
pub struct GivenRates {
    values: Vec<Quantity>,
}

impl FromStr for GivenRates {
    type Err = QuantityError;
    /// Reads comma-separated numbers with optional units: `2`, `30deg/s`, `1500rpm`, `0.1,0,2`.
    fn from_str(text: &str) -> Result<Self, QuantityError> {
        let value = |part: &str| Quantity::parse_as(part, &[Dimension::AngularSpeed, Dimension::Speed]);
        Ok(Self { values: text.split(',').map(value).collect::<Result<_, _>>()? })
    }
}

impl GivenRates {
    /// Velocities from numbers in SI units.
    ///
    /// # Errors
    /// [`QuantityError::NotFinite`].
    pub fn from_numbers(numbers: &[f64]) -> Result<Self, QuantityError> {
        Ok(Self { values: numbers.iter().map(|x| Quantity::number(*x)).collect::<Result<_, _>>()? })
    }

    /// Values in SI units, if the units match the kind of the joint.
    ///
    /// # Errors
    /// [`QuantityError::WrongUnit`].
    pub(crate) fn values_for_joint(&self, kind: JointKind) -> Result<Vec<f64>, QuantityError> {
        let value = |(k, quantity): (usize, &Quantity)| {
            quantity.in_dimension(rate_dimension(kind, k), &quantity.to_string())
        };
        self.values.iter().enumerate().map(value).collect()
    }
}

/// Dimension of velocity `k` of a joint.
pub(crate) fn rate_dimension(kind: JointKind, k: usize) -> Dimension {
    if kind.turns(k) { Dimension::AngularSpeed } else { Dimension::Speed }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_checked_against_the_kind_of_the_joint() {
        let rates: GivenRates = "180deg/s".parse().expect("a rate");
        let values = rates.values_for_joint(JointKind::Revolute).expect("an angular speed");
        assert!((values[0] - std::f64::consts::PI).abs() < 1e-15);
        assert!(rates.values_for_joint(JointKind::Prismatic).is_err());
        let turning: GivenRates = "30rpm".parse().expect("a rate");
        let values = turning.values_for_joint(JointKind::Continuous).expect("an angular speed");
        assert!((values[0] - std::f64::consts::PI).abs() < 1e-15);
        let wrong = "2deg".parse::<GivenRates>().expect_err("an angle is no rate").to_string();
        assert!(
            wrong.contains("in rad/s or m/s") && wrong.contains("deg/s") && wrong.contains("mm/s"),
            "{wrong}"
        );
        let planar: GivenRates = "10mm/s,1,2".parse().expect("rates");
        assert_eq!(planar.values_for_joint(JointKind::Planar).expect("planar rates"), [0.01, 1.0, 2.0]);
    }
}
