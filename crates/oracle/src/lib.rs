//! What percuss is tested against: closed forms, mechanisms to try, and an independent route to m̄.
//!
//! - [`maximal`]: route C, the effective mass in maximal coordinates (six velocities a link, every joint a set of
//!   constraint rows), on poses of its own built from 4×4 matrices.
//! - [`closed_form`]: effective masses that can be written down.
//! - [`linkage`]: mechanisms with closed loops, each with the joints that drive it and a position to start from.
//! - [`zoo`]: one mechanism for every property to test; [`random`]: any number of others, from a seed.
//! - [`alter`]: the same mechanism in other units, on another ground, or taken apart to be changed.
//!
//! Knows `percuss-mechanism` and `percuss-spatial`, never `percuss-dynamics`: an oracle that shares code with what
//! it tests proves nothing. For tests only, so it panics on a question that makes no sense.

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
