#![doc = include_str!("../README.md")]
//!
//! - [`maximal`]: route C, the effective mass in maximal coordinates, with poses from products of 4×4 matrices.
//! - [`closed_form`]: effective masses in closed form.
//! - [`linkage`]: mechanisms with closed loops, each with its driving joints and a start position.
//! - [`zoo`]: one mechanism per tested property; [`random`]: random mechanisms from a seed.
//! - [`alter`]: mechanisms in other units, on another ground, or as descriptions.

pub mod alter;
pub mod closed_form;
mod closures;
mod limits;
pub mod linkage;
pub mod maximal;
mod parts;
mod positions;
pub mod random;
pub mod zoo;
