//! What to build of a suspension file.

use percuss_mechanism::Accept;

/// Which side of the vehicle to build. Files describe the left side; the right one is its mirror image.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Side {
    /// The file's own side.
    #[default]
    Left,
    /// Its mirror image.
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

/// What the inner ends of the tie rods are held by.
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
#[derive(Clone, Copy, Debug, Default)]
pub struct ImportOptions {
    /// Which side.
    pub side: Side,
    /// The wheel; without one, its mass is not in the answer, which a warning states.
    pub wheel: Option<Wheel>,
    /// Whether the vehicle steers.
    pub rack: Rack,
    /// Findings that the user accepts.
    pub accept: Accept,
}
