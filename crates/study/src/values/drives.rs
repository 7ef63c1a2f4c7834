//! Springs of joints and limits of gears as given by the user.

use crate::values::rates::rate_dimension;
use crate::values::value::{self, NumberOrText, OneOrMany};
use percuss_mechanism::JointKind;
use percuss_units::{Dimension, Quantity, QuantityError};
use serde::Deserializer;
use std::fmt::{self, Display, Formatter};
use std::str::FromStr;

/// Dimensions of the limit of a gear: impulses, then torques and forces.
const OF_GEAR: [Dimension; 4] =
    [Dimension::AngularMomentum, Dimension::Momentum, Dimension::Moment, Dimension::Force];
/// Dimensions of the numbers of a spring: stiffness, damping, position without force.
const OF_SPRING: [[Dimension; 2]; 3] = [
    [Dimension::RotationalStiffness, Dimension::Stiffness],
    [Dimension::RotationalDamping, Dimension::Damping],
    [Dimension::Angle, Dimension::Length],
];

/// Numbers without units.
fn numbers(numbers: &[f64]) -> Result<Vec<Quantity>, QuantityError> {
    numbers.iter().map(|x| Quantity::number(*x)).collect()
}

/// Limits of the gear of a joint, one for each velocity. The unit distinguishes impulses and torques; without a unit, an impulse is meant.
#[derive(Clone, Debug, PartialEq)]
pub struct GivenGearLimits(Vec<Quantity>);

/// Limit of a gear.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum GearLimit {
    /// Largest impulse, N·m·s or N·s.
    Impulse(f64),
    /// Largest torque or force, N·m or N.
    Torque(f64),
}

impl FromStr for GivenGearLimits {
    type Err = QuantityError;
    /// Reads comma-separated numbers: `0.5`, `0.5N·m·s`, `80N·m`.
    fn from_str(text: &str) -> Result<Self, QuantityError> {
        text.split(',').map(|part| Quantity::parse_as(part, &OF_GEAR)).collect::<Result<_, _>>().map(Self)
    }
}

impl GivenGearLimits {
    /// Largest impulses, N·m·s or N·s.
    ///
    /// # Errors
    /// [`QuantityError::NotFinite`].
    pub fn from_numbers(impulses: &[f64]) -> Result<Self, QuantityError> {
        numbers(impulses).map(Self)
    }

    /// Limits in SI units, if the units match the kind of the joint.
    pub(crate) fn limits_for_joint(&self, kind: JointKind) -> Result<Vec<GearLimit>, QuantityError> {
        let limit = |(k, given): (usize, &Quantity)| {
            let turns = rate_dimension(kind, k) == Dimension::AngularSpeed;
            let (impulse, torque) = match turns {
                true => (Dimension::AngularMomentum, Dimension::Moment),
                false => (Dimension::Momentum, Dimension::Force),
            };
            match given.dimension {
                Some(dimension) if dimension == torque => Ok(GearLimit::Torque(given.value)),
                _ => given.in_dimension(impulse, &given.to_string()).map(GearLimit::Impulse),
            }
        };
        self.0.iter().enumerate().map(limit).collect()
    }
}

/// Spring and damper of a joint: stiffness, then, if given, damping and the position without force.
#[derive(Clone, Debug, PartialEq)]
pub struct GivenSpring(Vec<Quantity>);

impl FromStr for GivenSpring {
    type Err = QuantityError;
    /// Reads `K`, `K,D` or `K,D,FREE` with optional units: `900,4`, `10N·m/deg,0.2,30deg`. The count is not checked.
    fn from_str(text: &str) -> Result<Self, QuantityError> {
        let number = |(k, part): (usize, &str)| Quantity::parse_as(part, &OF_SPRING[k.min(2)]);
        text.split(',').enumerate().map(number).collect::<Result<_, _>>().map(Self)
    }
}

impl Display for GivenSpring {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let texts: Vec<String> = self.0.iter().map(ToString::to_string).collect();
        f.write_str(&texts.join(","))
    }
}

impl GivenSpring {
    /// Stiffness (N·m/rad or N/m), damping (N·m·s/rad or N·s/m) and position without force (rad or m).
    ///
    /// # Errors
    /// [`QuantityError::NotFinite`].
    pub fn from_numbers(given: &[f64]) -> Result<Self, QuantityError> {
        numbers(given).map(Self)
    }

    /// Values in SI units, if the units match the kind of the joint. The count is not checked.
    pub(crate) fn values_for_joint(&self, kind: JointKind) -> Result<Vec<f64>, QuantityError> {
        let turns = rate_dimension(kind, 0) == Dimension::AngularSpeed;
        let value = |(k, given): (usize, &Quantity)| {
            given.in_dimension(OF_SPRING[k.min(2)][usize::from(!turns)], &given.to_string())
        };
        self.0.iter().enumerate().map(value).collect()
    }
}

/// Reads values by joint: a number, a text with a unit, or a list of numbers and texts.
pub(crate) fn by_joint<'de, D: Deserializer<'de>, T: FromStr<Err: Display>>(
    from: D,
) -> Result<Vec<(String, T)>, D::Error> {
    let given = |(joint, values): (String, OneOrMany<NumberOrText>)| {
        let texts: Vec<String> = values.list().into_iter().map(NumberOrText::text).collect();
        let read = texts.join(",").parse();
        let read = read.map_err(|error| serde::de::Error::custom(format!("joint \"{joint}\": {error}")))?;
        Ok((joint, read))
    };
    value::by_name::<D, OneOrMany<NumberOrText>>(from)?.into_iter().map(given).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_decide_between_impulse_and_torque() {
        let limits = |text: &str, kind| {
            let given: GivenGearLimits = text.parse().expect("limits");
            given.limits_for_joint(kind)
        };
        let hinge = JointKind::Revolute;
        assert_eq!(limits("0.5", hinge), Ok(vec![GearLimit::Impulse(0.5)]));
        assert_eq!(limits("0.5N·m·s", hinge), Ok(vec![GearLimit::Impulse(0.5)]));
        assert_eq!(limits("80 Nm", hinge), Ok(vec![GearLimit::Torque(80.0)]));
        assert_eq!(limits("2kN", JointKind::Prismatic), Ok(vec![GearLimit::Torque(2000.0)]));
        assert_eq!(limits("1N·s", JointKind::Prismatic), Ok(vec![GearLimit::Impulse(1.0)]));
        assert!(limits("1N·s", hinge).is_err() && limits("80 Nm", JointKind::Prismatic).is_err());
        let wrong = "3mm".parse::<GivenGearLimits>().expect_err("a length").to_string();
        assert!(wrong.contains("N·m·s or N·s or N·m or N") && wrong.contains("kN·m"), "{wrong}");
    }
}
