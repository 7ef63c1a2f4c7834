//! Coulomb friction at one contact.
//!
//! One relative motion: [`one_motion`]. Motions in a plane: [`planar`], piecewise quadratic. All others: [`spatial`], by
//! integration over the normal impulse.

pub(crate) mod collision;
pub(crate) mod impulse;
pub(crate) mod one_motion;
pub(crate) mod phases;
pub(crate) mod planar;
pub(crate) mod rounding;
pub(crate) mod spatial;
pub(crate) mod thresholds;
