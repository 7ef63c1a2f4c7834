//! Forces of springs and stops as given in a sheet. They have no influence on the mechanism.

use percuss_contact::ForceCurve;

/// Spring with a constant rate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpringForce {
    /// Rate k, N/m: the force grows by k per compression.
    pub rate: f64,
    /// Force at the design position, N; positive: the spring is compressed. `None` if the sheet does not state the force.
    pub preload: Option<f64>,
}

/// Forces of one side, by the section of the sheet.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ForceElements {
    /// Springs.
    pub springs: Vec<(String, SpringForce)>,
    /// Stops: force over the compression after the touch.
    pub stops: Vec<(String, ForceCurve)>,
}
