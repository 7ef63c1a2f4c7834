#![doc = include_str!("../README.md")]
//!
//! [`Unit`] is a row of the table, [`Quantity`] a number in SI units with the dimension of its unit.

mod length;
mod quantity;
mod unit;

pub use length::LengthUnit;
pub use quantity::{LARGEST_NUMBER, Quantity, QuantityError, parse_list, parse_triple, split};
pub use unit::{Dimension, Unit};
