//! Options for the import of a suspension file.

use super::units::VehicleAxes;
use percuss_mechanism::Accept;
use percuss_units::LengthUnit;

/// Side of the vehicle to build. Files of Chrono describe the left side; the right side is the mirror image.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Side {
    /// Left side.
    #[default]
    Left,
    /// Right side.
    Right,
    /// Both sides on one chassis; names end in `_left` and `_right`.
    Both,
}

impl Side {
    /// Word of the side opposite to that of the points.
    pub(super) fn other_word(self) -> &'static str {
        if self == Side::Right { "left" } else { "right" }
    }
}

/// Wheel with the tyre. The centre of the wheel is the centre of the spindle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wheel {
    /// Mass with the tyre, kg.
    pub mass: f64,
    /// Moments of inertia about the wheel centre along the spindle's axes, kg·m²: y is the spin axis.
    pub inertia: [f64; 3],
    /// Radius, m; with a radius, the lowest point of the wheel is named `contact_patch`.
    pub radius: Option<f64>,
}

/// Link with the inner ends of the tie rods.
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

/// Options for the import of a suspension file.
#[derive(Clone, Debug, Default)]
pub struct ImportOptions {
    /// Unit of the file's lengths; `None`: the unit in the file, or m for a file of Chrono.
    pub unit: Option<LengthUnit>,
    /// Vehicle axes of the file; `None`: the axes in the file, or the axes of ISO 8855 for a file of Chrono.
    pub axes: Option<VehicleAxes>,
    /// Side to build; `None`: the side in the file, or the left one.
    pub side: Option<Side>,
    /// Wheel in place of the wheel in the file. Without any wheel, the mechanism has no wheel mass, and a warning is reported.
    pub wheel: Option<Wheel>,
    /// Rack, fixed or sliding; `None`: as in the file, fixed by default.
    pub rack: Option<Rack>,
    /// Template for a table without a template name.
    pub template: Option<String>,
    /// Worksheet of a workbook; `None`: the worksheet named in the sheet, or the first one.
    pub worksheet: Option<String>,
    /// File of the names of a table's points, `lower_ball = "LBJ"`, besides those of the sheet.
    pub names: Option<String>,
    /// Moved hardpoints of a sheet: name and displacement, m, in the axes of the sheet.
    pub moves: Vec<(String, [f64; 3])>,
    /// True if a rod without mass becomes a massless link on a universal joint instead of a distance closure: its joints can
    /// drive the suspension. The motion is the same.
    pub movable: bool,
    /// True if the masses, centres of mass and inertias of a sheet may be missing: they are zero, which is sufficient for kinematics.
    pub masses_optional: bool,
    /// Findings that the user accepts.
    pub accept: Accept,
    /// True if a sheet may refer to a table of points outside the folder of the sheet. Messages quote text from the table.
    pub allow_outside: bool,
}
