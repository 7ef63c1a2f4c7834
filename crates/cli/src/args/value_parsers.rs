//! Parsers of the values of flags that no study has.

use percuss_study::{Length, PositiveMass, Vector};

/// Mass above zero, kg; a number without a unit is in kg.
pub fn kilograms(text: &str) -> Result<f64, String> {
    text.parse().map(|PositiveMass(mass)| mass)
}

/// Length above zero, m; a number without a unit is in m.
pub fn metres(text: &str) -> Result<f64, String> {
    let Length(length) = text.parse().map_err(|error: percuss_study::QuantityError| error.to_string())?;
    if length > 0.0 { Ok(length) } else { Err(format!("{length} m; a length above 0 is expected")) }
}

/// Three moments of inertia, kg·m², not negative.
pub fn moments(text: &str) -> Result<[f64; 3], String> {
    let Vector(moments) = text.parse().map_err(|error: percuss_study::QuantityError| error.to_string())?;
    if moments.iter().all(|i| *i >= 0.0) {
        Ok(moments)
    } else {
        Err("moments of 0 or more are expected".into())
    }
}
