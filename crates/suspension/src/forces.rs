//! Forces of springs, dampers and stops as given in a sheet. They have no influence on the mechanism.

use percuss_contact::{DamperCurve, ForceCurve};
use std::sync::Arc;

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
    /// Dampers: force over the speed of their length, positive in rebound.
    pub dampers: Vec<(String, Arc<DamperCurve>)>,
    /// Stops: force over the compression after the touch.
    pub stops: Vec<(String, ForceCurve)>,
}
