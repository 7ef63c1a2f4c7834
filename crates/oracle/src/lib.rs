//! Reference results for the tests of percuss: closed forms, test mechanisms, and an independent route to m̄.
//!
//! - [`maximal`]: route C, the effective mass in maximal coordinates (six velocities per link, constraint rows
//!   for every joint), with poses from products of 4×4 matrices.
//! - [`closed_form`]: effective masses in closed form.
//! - [`linkage`]: mechanisms with closed loops, each with its driving joints and a start position.
//! - [`zoo`]: one mechanism per tested property; [`random`]: random mechanisms from a seed.
//! - [`alter`]: mechanisms in other units, on another ground, or as descriptions.
//!
//! This crate depends on `percuss-mechanism` and `percuss-spatial`, never on `percuss-dynamics`: a reference
//! with shared code proves nothing. It is only for tests and panics on invalid questions.

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
