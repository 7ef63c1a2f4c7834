//! Flags of `percuss import` and `percuss template`.

use super::headings::OUTPUT;
use super::words::{kilograms, metres, moments, moved_point};
use super::writing::WritingArgs;
use clap::{Args, ValueEnum};
use percuss_formats::DEFAULT_MAX_SIZE;

/// Which side of the vehicle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum SideArg {
    /// The left one.
    Left,
    /// The right one.
    Right,
    /// Both on one chassis.
    Both,
}

/// The unit of a file's lengths.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum UnitArg {
    /// Metres.
    M,
    /// Centimetres.
    Cm,
    /// Millimetres.
    Mm,
    /// Inches.
    In,
}

/// The axes of a file's vehicle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum AxesArg {
    /// ISO 8855: x forward, y left, z up.
    Iso,
    /// As in Adams/Car: x backward, y right, z up.
    Adams,
}

/// Headings of the help.
const FILE: &str = "File";
const CAR: &str = "Car";

/// Flags of `percuss import`.
#[derive(Debug, Args)]
pub struct ImportArgs {
    /// A sheet, a table, or a Chrono JSON.
    ///
    /// A sheet (TOML), a table of hardpoints (CSV, XLSX), or a suspension of Chrono::Vehicle (JSON); - reads the standard input.
    pub hardpoints: String,
    /// The URDF+ file to write; - writes to stdout.
    #[arg(long, short, value_name = "MODEL.urdf", help_heading = OUTPUT)]
    pub output: String,
    /// Draws what was understood, from two sides.
    ///
    /// From the front and from the side, to check it against the drawing.
    #[arg(long, value_name = "FILE.svg|.png|.pdf", help_heading = OUTPUT)]
    pub picture: Option<String>,
    #[command(flatten)]
    pub writing: WritingArgs,
    /// Unit of the file's lengths.
    ///
    /// A sheet says it itself, a JSON is in m without this.
    #[arg(long, value_name = "UNIT", value_enum, help_heading = FILE)]
    pub unit: Option<UnitArg>,
    /// Axes of the file's vehicle: iso, adams.
    ///
    /// A sheet says them itself, a JSON has those of ISO 8855 without this.
    #[arg(long, value_name = "AXES", value_enum, help_heading = FILE)]
    pub axes: Option<AxesArg>,
    /// The template of a table.
    ///
    /// Of one that does not name its own (percuss template --list).
    #[arg(long, value_name = "NAME", help_heading = FILE)]
    pub template: Option<String>,
    /// Which side to build: left, right, both.
    ///
    /// Without this the sheet's, or the left one.
    #[arg(long, value_name = "SIDE", value_enum, help_heading = CAR)]
    pub side: Option<SideArg>,
    /// Mass of the wheel with its tyre (kg).
    ///
    /// In the place of the sheet's; a JSON has none.
    #[arg(long, value_name = "KG", value_parser = kilograms, help_heading = CAR)]
    pub wheel_mass: Option<f64>,
    /// Moments of the wheel about its centre (kg·m²), y along the spin axis.
    #[arg(long, value_name = "IX,IY,IZ", value_parser = moments, requires = "wheel_mass", help_heading = CAR)]
    pub wheel_inertia: Option<[f64; 3]>,
    /// Radius of the wheel (m): names the contact patch.
    #[arg(long, value_name = "M", value_parser = metres, requires = "wheel_mass", help_heading = CAR)]
    pub wheel_radius: Option<f64>,
    /// Lets the rack slide, with this mass (kg); otherwise it is as the sheet says, or fixed to the chassis.
    #[arg(long, value_name = "KG", value_parser = kilograms, help_heading = CAR)]
    pub rack_mass: Option<f64>,
    /// Moves a hardpoint of the sheet (m; 5mm).
    ///
    /// In the sheet's axes; numbers without a unit are m.
    #[arg(
        long = "move",
        value_name = "POINT=X,Y,Z",
        value_parser = moved_point,
        allow_hyphen_values = true,
        help_heading = CAR
    )]
    pub moves: Vec<(String, [f64; 3])>,
    /// Refuse files larger than this many bytes.
    #[arg(long, default_value_t = DEFAULT_MAX_SIZE, value_name = "BYTES", help_heading = FILE)]
    pub max_size: u64,
    /// Make warnings errors (exit 2).
    #[arg(long, help_heading = FILE)]
    pub strict: bool,
    /// Let the sheet name a table of points outside its folder.
    #[arg(long, help_heading = FILE)]
    pub allow_outside: bool,
}

/// Flags of `percuss template`.
#[derive(Debug, Args)]
pub struct TemplateArgs {
    /// Which template; --list shows them.
    #[arg(required_unless_present = "list")]
    pub name: Option<String>,
    /// List the templates.
    #[arg(long, conflicts_with = "name")]
    pub list: bool,
    /// Unit of the sheet's lengths: m, cm, mm, in.
    #[arg(long, value_name = "UNIT", value_enum, default_value_t = UnitArg::Mm)]
    pub unit: UnitArg,
    /// Axes of the sheet's vehicle: iso, adams.
    #[arg(long, value_name = "AXES", value_enum, default_value_t = AxesArg::Iso)]
    pub axes: AxesArg,
    /// The sheet to write; without it, to stdout.
    ///
    /// A file that is there is not replaced.
    #[arg(long, short, value_name = "SHEET.toml")]
    pub output: Option<String>,
    /// Replace a file that is there.
    #[arg(long, requires = "output")]
    pub force: bool,
}
