//! Quantities with units as text (`12 mm`, `30deg`, `400N/mm`): one table of units, and one parser for flags, studies, sheets and
//! column names.
//!
//! [`Unit`] is a row of the table, [`Quantity`] a number in SI units with the dimension of its unit.

mod length;
mod quantity;
mod unit;

pub use length::LengthUnit;
pub use quantity::{LARGEST_NUMBER, Quantity, QuantityError, parse_list, parse_triple, split};
pub use unit::{Dimension, Unit};
