//! What to build of a suspension file.

use super::units::{LengthUnit, VehicleAxes};
use percuss_mechanism::Accept;

/// Which side of the vehicle to build. Files of Chrono describe the left side; the right one is its mirror image.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Side {
    /// The left one.
    #[default]
    Left,
    /// The right one.
    Right,
    /// Both on one chassis; names end in `_left` and `_right`.
    Both,
}

/// A wheel, which suspension files do not hold. Its centre is the spindle's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wheel {
    /// Mass with the tyre, kg.
    pub mass: f64,
    /// Moments about its centre along the spindle's axes, kg·m²: y is the axis of spin.
    pub inertia: [f64; 3],
    /// Radius, m; with it the wheel's lowest point is named `contact_patch`.
    pub radius: Option<f64>,
}

/// Part that holds the inner ends of the tie rods.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Rack {
    /// The link `rack` is fixed to the chassis.
    #[default]
    Fixed,
    /// The joint `rack` slides along the vehicle's y: one degree of freedom more.
    Sliding {
        /// Mass of the rack, kg; 0 is legal.
        mass: f64,
    },
}

/// What to build of a file.
#[derive(Clone, Debug, Default)]
pub struct ImportOptions {
    /// Unit of the file's lengths; `None`: the unit in the file, or m for a file of Chrono.
    pub unit: Option<LengthUnit>,
    /// The axes of the file's vehicle; none: what the file says, or those of ISO 8855 for a file of Chrono.
    pub axes: Option<VehicleAxes>,
    /// Side to build; `None`: the side in the file, or the left one.
    pub side: Option<Side>,
    /// The wheel; it replaces the file's, if that has one. Without any, no mass of a wheel is in the answer, which a warning states.
    pub wheel: Option<Wheel>,
    /// True if the vehicle steers; `None`: as in the file, otherwise false.
    pub rack: Option<Rack>,
    /// The template of a table that does not name its own.
    pub template: Option<String>,
    /// Hardpoints of a sheet to be moved: name, and by how much, m, in the sheet's own axes.
    pub moves: Vec<(String, [f64; 3])>,
    /// Findings that the user accepts.
    pub accept: Accept,
    /// True if a sheet may name a table of points outside its own folder. Messages quote what is read of it.
    pub allow_outside: bool,
}
