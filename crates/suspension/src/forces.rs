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

/// Torsion bar on the hinge of a link on the chassis.
#[derive(Clone, Debug, PartialEq)]
pub struct TorsionBar {
    /// Link that twists the bar.
    pub link: String,
    /// Rate k, N·m/rad.
    pub rate: f64,
    /// Moment at the design position, N·m; positive: the bar is twisted as by a wheel that moves up. `None` if the sheet does not state it.
    pub preload: Option<f64>,
}

impl TorsionBar {
    /// Name of the hinge, with the ending of its side.
    pub fn joint(&self, side: &str) -> String {
        format!("{}_hinge{side}", self.link)
    }
}

/// Vertical force of a tyre on the wheel centre. It never pulls: the tyre leaves the road.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TyreForce {
    /// Vertical stiffness, N/m.
    pub rate: f64,
    /// Damping, N·s/m.
    pub damping: f64,
    /// Force at the touch of a contact, N; `None`: the force that balances the springs of the sheet.
    pub load: Option<f64>,
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
    /// Tyre.
    pub tyre: Option<TyreForce>,
    /// Torsion bar.
    pub torsion_bar: Option<TorsionBar>,
    /// Torsional stiffness of the anti-roll bar between its two arms, N·m/rad.
    pub anti_roll_bar: Option<f64>,
}
