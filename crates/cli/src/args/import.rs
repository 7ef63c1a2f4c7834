//! Flags of `percuss import` and `percuss template`.

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

/// Flags of `percuss import`.
#[derive(Debug, Args)]
pub struct ImportArgs {
    /// A sheet (TOML), a table of hardpoints (CSV, XLSX), or a suspension of Chrono::Vehicle (JSON); - reads the standard
    /// input.
    pub hardpoints: String,
    /// The URDF+ file to write; - writes to stdout.
    #[arg(long, short, value_name = "MODEL.urdf")]
    pub output: String,
    /// Draws what was understood from the front and from the side, to check it against the drawing.
    #[arg(long, value_name = "FILE.svg|.png|.pdf")]
    pub picture: Option<String>,
    #[command(flatten)]
    pub writing: WritingArgs,
    /// Unit of the file's lengths; a sheet says it itself, a JSON is in m without this.
    #[arg(long, value_enum)]
    pub unit: Option<UnitArg>,
    /// Axes of the file's vehicle; a sheet says them itself, a JSON has those of ISO 8855 without this.
    #[arg(long, value_enum)]
    pub axes: Option<AxesArg>,
    /// The template of a table that does not name its own (percuss template --list).
    #[arg(long, value_name = "NAME")]
    pub template: Option<String>,
    /// Which side to build; without this the sheet's, or the left one.
    #[arg(long, value_enum)]
    pub side: Option<SideArg>,
    /// Mass of the wheel with its tyre (kg), in the place of the sheet's; a JSON has none.
    #[arg(long, value_name = "KG", value_parser = kilograms)]
    pub wheel_mass: Option<f64>,
    /// Moments of the wheel about its centre (kg·m²), y along the spin axis.
    #[arg(long, value_name = "IX,IY,IZ", value_parser = moments, requires = "wheel_mass")]
    pub wheel_inertia: Option<[f64; 3]>,
    /// Radius of the wheel (m): names the contact patch.
    #[arg(long, value_name = "M", value_parser = metres, requires = "wheel_mass")]
    pub wheel_radius: Option<f64>,
    /// Lets the rack slide, with this mass (kg); otherwise it is as the sheet says, or fixed to the chassis.
    #[arg(long, value_name = "KG", value_parser = kilograms)]
    pub rack_mass: Option<f64>,
    /// Moves a hardpoint of the sheet, in the sheet's axes; numbers without a unit are m.
    #[arg(long = "move", value_name = "POINT=X,Y,Z", value_parser = moved_point, allow_hyphen_values = true)]
    pub moves: Vec<(String, [f64; 3])>,
    /// Refuse files larger than this many bytes.
    #[arg(long, default_value_t = DEFAULT_MAX_SIZE, value_name = "BYTES")]
    pub max_size: u64,
    /// Make warnings errors (exit 2).
    #[arg(long)]
    pub strict: bool,
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
    /// Unit of the sheet's lengths.
    #[arg(long, value_enum, default_value_t = UnitArg::Mm)]
    pub unit: UnitArg,
    /// Axes of the sheet's vehicle.
    #[arg(long, value_enum, default_value_t = AxesArg::Iso)]
    pub axes: AxesArg,
    /// The sheet to write; without it, to stdout. A file that is there is not replaced.
    #[arg(long, short, value_name = "SHEET.toml")]
    pub output: Option<String>,
    /// Replace a file that is there.
    #[arg(long, requires = "output")]
    pub force: bool,
}
