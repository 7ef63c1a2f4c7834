//! What a sweep varies, and over which values.

use crate::quantity::{Dimension, Quantity, QuantityError, parse_triple};
use crate::thresholds::ROWS;

/// What is varied.
#[derive(Clone, Debug, PartialEq)]
pub enum Varied {
    /// A driving joint with one position.
    Joint(String),
    /// The displacement of a point (m, link's frame) of a link along a direction (world axes), from where it is with
    /// the joints as set.
    Travel {
        /// The link.
        link: String,
        /// The point.
        point: [f64; 3],
        /// The direction; its length does not matter.
        direction: [f64; 3],
    },
}

/// A range of values, ends included.
#[derive(Clone, Debug, PartialEq)]
pub struct Vary {
    /// What is varied.
    pub what: Varied,
    /// First value; the dimension of its unit is compared with the joint's when names are resolved.
    pub from: Quantity,
    /// Last value.
    pub to: Quantity,
    /// How many values, 1 to 1,000,000.
    pub count: usize,
}

/// A text that is no range.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum VaryError {
    /// Parts are missing.
    #[error(
        "wanted JOINT=FROM:TO:COUNT, such as hinge=-30deg:30deg:61, or travel:LINK:X,Y,Z:DX,DY,DZ=FROM:TO:COUNT"
    )]
    Form,
    /// COUNT is no whole number.
    #[error("COUNT is \"{text}\"; expected a whole number")]
    NoCount {
        /// What was given.
        text: String,
    },
    /// Too few rows, or too many.
    #[error("COUNT is {count}; {} to {} rows are possible", ROWS.start(), ROWS.end())]
    Count {
        /// What was given.
        count: usize,
    },
    /// An end of the range, the point or the direction.
    #[error(transparent)]
    Number(#[from] QuantityError),
}

impl Vary {
    /// Reads `JOINT=FROM:TO:COUNT` or `travel:LINK:X,Y,Z:DX,DY,DZ=FROM:TO:COUNT`.
    ///
    /// # Errors
    /// [`VaryError`]: what is wrong, and how it should look.
    pub fn parse(text: &str) -> Result<Self, VaryError> {
        let (what, range) = text.rsplit_once('=').ok_or(VaryError::Form)?;
        let parts: Vec<&str> = range.split(':').collect();
        let [from, to, count] = parts[..] else { return Err(VaryError::Form) };
        let count: usize = count.trim().parse().map_err(|_| VaryError::NoCount { text: count.to_owned() })?;
        if !ROWS.contains(&count) {
            return Err(VaryError::Count { count });
        }
        let (first, last) = (Quantity::parse(from)?, Quantity::parse(to)?);
        let what = match what.strip_prefix("travel:") {
            None if what.is_empty() => return Err(VaryError::Form),
            None => Varied::Joint(what.to_owned()),
            Some(rest) => {
                let (link, point, direction) = split(rest).ok_or(VaryError::Form)?;
                first.of(Dimension::Length, from)?;
                last.of(Dimension::Length, to)?;
                Varied::Travel {
                    link: link.to_owned(),
                    point: parse_triple(point, Dimension::Length)?,
                    direction: parse_triple(direction, Dimension::Plain)?,
                }
            }
        };
        Ok(Self { what, from: first, to: last, count })
    }

    /// As a column is headed.
    pub fn name(&self) -> String {
        match &self.what {
            Varied::Joint(joint) => joint.clone(),
            Varied::Travel { link, .. } => format!("travel:{link}"),
        }
    }

    /// The values in SI units, where the units of the ends are those of what is varied.
    ///
    /// # Errors
    /// [`QuantityError::WrongUnit`].
    pub(crate) fn values(&self, dimension: Dimension) -> Result<Values, QuantityError> {
        let value = |end: Quantity| end.of(dimension, &end.to_string());
        Ok(Values { from: value(self.from)?, to: value(self.to)?, count: self.count })
    }
}

/// `LINK:X,Y,Z:DX,DY,DZ`, split from the right: link names may have colons of their own.
pub(crate) fn split(text: &str) -> Option<(&str, &str, &str)> {
    let mut parts = text.rsplitn(3, ':');
    let (direction, point, link) = (parts.next()?, parts.next()?, parts.next()?);
    (!link.is_empty()).then_some((link, point, direction))
}

/// Evenly spaced values.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Values {
    from: f64,
    to: f64,
    /// How many.
    pub count: usize,
}

impl Values {
    /// The value of a row, the first being 0.
    pub fn of_row(&self, row: usize) -> f64 {
        let steps = self.count.saturating_sub(1).max(1) as f64;
        let value = self.from + (self.to - self.from) * (row as f64 / steps);
        let largest = self.from.abs().max(self.to.abs());
        // Of ends that are not decimals, such as 5 degrees in radians, no value is rounded.
        let is_decimal = |end: f64| rounded(end, largest) == end;
        // Zero has no sign.
        0.0 + if is_decimal(self.from) && is_decimal(self.to) { rounded(value, largest) } else { value }
    }
}

/// A value to fifteen digits of the largest of its range: 0.05, not 0.050000000000000044.
fn rounded(value: f64, largest: f64) -> f64 {
    let decimals = 14.0 - largest.log10().floor();
    // Beyond this, powers of ten are not exact.
    if !(0.0..=22.0).contains(&decimals) {
        return value;
    }
    let scale = 10_f64.powi(decimals as i32);
    (value * scale).round() / scale
}
