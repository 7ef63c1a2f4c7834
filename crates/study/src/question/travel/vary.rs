//! Ranges of a sweep: the varied quantity and its values.

use crate::question::travel::moved::{LongTravelError, Moved, WheelMotion};
use crate::thresholds::ROWS;
use percuss_units::{Dimension, Quantity, QuantityError};
use std::str::FromStr;

/// Varied quantity.
#[derive(Clone, Debug, PartialEq)]
pub enum Varied {
    /// Driving joint with one position.
    Joint(String),
    /// Displacement of a point of a link along a direction, or of the wheels, relative to the pose of the set joints.
    Travel(Moved),
}

/// Range of evenly spaced values, including both ends.
#[derive(Clone, Debug, PartialEq)]
pub struct Vary {
    /// Varied quantity.
    pub quantity: Varied,
    /// First value; the dimension of the unit is checked once the joint is known.
    pub from: Quantity,
    /// Last value.
    pub to: Quantity,
    /// Number of values, 1 to 1,000,000.
    pub count: usize,
}

/// Error in the text of a range.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum VaryError {
    /// Missing parts.
    #[error(
        "expected JOINT=FROM:TO:COUNT, such as hinge=-30deg:30deg:61, travel:LINK:X,Y,Z:DX,DY,DZ=FROM:TO:COUNT, or \
         wheel-travel, heave or roll=FROM:TO:COUNT"
    )]
    Form,
    /// COUNT is not a whole number.
    #[error("COUNT is \"{text}\"; expected a whole number")]
    NoCount {
        /// Given text.
        text: String,
    },
    /// COUNT out of range.
    #[error("COUNT is {count}; {} to {} rows are possible", ROWS.start(), ROWS.end())]
    Count {
        /// Given number.
        count: usize,
    },
    /// Invalid end of the range, point or direction.
    #[error(transparent)]
    Number(#[from] QuantityError),
    /// Wheel travel that no suspension has.
    #[error(transparent)]
    Long(#[from] LongTravelError),
}

impl FromStr for Vary {
    type Err = VaryError;
    fn from_str(text: &str) -> Result<Self, VaryError> {
        Self::parse(text)
    }
}

impl Vary {
    /// Reads `JOINT=FROM:TO:COUNT`, `travel:LINK:X,Y,Z:DX,DY,DZ=FROM:TO:COUNT`, or the name of a [`WheelMotion`] in place
    /// of a joint.
    ///
    /// # Errors
    /// [`VaryError`] with the cause and the expected form.
    pub fn parse(text: &str) -> Result<Self, VaryError> {
        let (what, range) = text.rsplit_once('=').ok_or(VaryError::Form)?;
        let parts: Vec<&str> = range.split(':').collect();
        let [from, to, count] = parts[..] else { return Err(VaryError::Form) };
        let count: usize = count.trim().parse().map_err(|_| VaryError::NoCount { text: count.to_owned() })?;
        if !ROWS.contains(&count) {
            return Err(VaryError::Count { count });
        }
        let (first, last) = (Quantity::parse(from)?, Quantity::parse(to)?);
        let what = match (what.strip_prefix("travel:"), WheelMotion::from_name(what)) {
            (None, None) if what.is_empty() => return Err(VaryError::Form),
            // The prefix of a travel may be left out, as in `--travel`.
            (None, None) if Moved::parse_point(what).is_some_and(|point| point.is_ok()) => {
                return Self::parse(&format!("travel:{text}"));
            }
            (None, None) => Varied::Joint(what.to_owned()),
            (None, Some(motion)) => {
                motion.check_distance(first.value)?;
                motion.check_distance(last.value)?;
                Varied::Travel(Moved::Wheels(motion))
            }
            (Some(rest), _) => {
                let moved = Moved::parse_point(rest).ok_or(VaryError::Form)??;
                first.in_dimension(Dimension::Length, from)?;
                last.in_dimension(Dimension::Length, to)?;
                Varied::Travel(moved)
            }
        };
        Ok(Self { quantity: what, from: first, to: last, count })
    }

    /// Name of the column.
    pub fn name(&self) -> String {
        match &self.quantity {
            Varied::Joint(joint) => joint.clone(),
            Varied::Travel(moved) => moved.name(),
        }
    }

    /// Values in SI units, if the units of both ends have the given dimension.
    ///
    /// # Errors
    /// [`QuantityError::WrongUnit`].
    pub(crate) fn values(&self, dimension: Dimension) -> Result<EvenlySpacedValues, QuantityError> {
        let value = |end: Quantity| end.in_dimension(dimension, &end.to_string());
        Ok(EvenlySpacedValues { from: value(self.from)?, to: value(self.to)?, count: self.count })
    }
}

/// Evenly spaced values.
#[derive(Clone, Copy, Debug)]
pub(crate) struct EvenlySpacedValues {
    from: f64,
    to: f64,
    /// Number of values.
    pub count: usize,
}

impl EvenlySpacedValues {
    /// Value of row `row`, from 0.
    pub fn value_at(&self, row: usize) -> f64 {
        let steps = self.count.saturating_sub(1).max(1) as f64;
        let value = self.from + (self.to - self.from) * (row as f64 / steps);
        let largest = self.from.abs().max(self.to.abs());
        // Values are rounded only if both ends are decimals; 5 degrees in radians is not.
        let is_decimal = |end: f64| round_to_largest(end, largest) == end;
        // Adding 0.0 turns −0 into 0.
        0.0 + if is_decimal(self.from) && is_decimal(self.to) {
            round_to_largest(value, largest)
        } else {
            value
        }
    }
}

/// Value rounded to fifteen digits of `largest`: 0.05, not 0.050000000000000044.
fn round_to_largest(value: f64, largest: f64) -> f64 {
    let decimals = 14.0 - largest.log10().floor();
    // Powers of ten above 10²² are not exact.
    if !(0.0..=22.0).contains(&decimals) {
        return value;
    }
    let scale = 10_f64.powi(decimals as i32);
    (value * scale).round() / scale
}
