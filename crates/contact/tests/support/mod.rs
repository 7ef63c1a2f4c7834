//! Support code of the tests of this crate.

#[allow(dead_code, reason = "not every test integrates")]
pub mod integrated;

/// Relative difference of two numbers.
pub fn relative_difference(got: f64, expected: f64) -> f64 {
    if got == expected { 0.0 } else { ((got - expected) / expected).abs() }
}
