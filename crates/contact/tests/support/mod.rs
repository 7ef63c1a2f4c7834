//! What the tests of this crate share.

#[allow(dead_code, reason = "not every test integrates")]
pub mod integrated;

/// The relative difference.
pub fn apart(got: f64, expected: f64) -> f64 {
    if got == expected { 0.0 } else { ((got - expected) / expected).abs() }
}
