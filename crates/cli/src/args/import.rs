//! Flags of `percuss import` and `percuss template`.

use super::output::WritingArgs;
use super::value_parsers::{kilograms, metres, moments};
use clap::{Args, ValueEnum};
use percuss_formats::DEFAULT_MAX_SIZE;
use percuss_study::headings::OUTPUT;
use percuss_study::{Point, point_shift};
use percuss_suspension::VehicleAxes;

/// Side of the vehicle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum SideArg {
    /// Left.
    Left,
    /// Right.
    Right,
    /// Both sides on one chassis.
    Both,
}

/// Unit of lengths in a file.
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

/// Vehicle axes of a flag.
fn vehicle_axes(text: &str) -> Result<VehicleAxes, String> {
    VehicleAxes::from_name(text).ok_or_else(|| format!("{} is expected", VehicleAxes::CHOICES))
}

/// Headings in the help.
const FILE: &str = "File";
const CAR: &str = "Car";

/// Flags of `percuss import`.
#[derive(Debug, Args)]
pub struct ImportArgs {
    /// Sheet, table, or Chrono JSON.
    ///
    /// A sheet is TOML, a table of hardpoints CSV or XLSX, a suspension of Chrono::Vehicle JSON. - reads the standard
    /// input.
    pub hardpoints: String,
    /// URDF+ file to write; - writes to stdout.
    #[arg(long, short, value_name = "MODEL.urdf", help_heading = OUTPUT)]
    pub output: String,
    /// Draw the imported suspension from two sides.
    ///
    /// Views from the front and from the side, for comparison with the drawing.
    #[arg(long, value_name = "FILE.svg|.png|.pdf", help_heading = OUTPUT)]
    pub picture: Option<String>,
    #[command(flatten)]
    pub writing: WritingArgs,
    /// Unit of lengths in the file.
    ///
    /// Not for a sheet, which contains its unit. Default of a JSON: m.
    #[arg(long, value_name = "UNIT", value_enum, help_heading = FILE)]
    pub unit: Option<UnitArg>,
    /// Vehicle axes of the file: iso, adams, sae, rfactor, or such as "-z x y".
    ///
    /// Three axes of the file with their signs: those that point forward, left and up. Not for a sheet, which contains its axes. Default of a JSON: ISO 8855.
    #[arg(long, value_name = "AXES", value_parser = vehicle_axes, allow_hyphen_values = true, help_heading = FILE)]
    pub axes: Option<VehicleAxes>,
    /// Template of a table.
    ///
    /// Required if the table does not name its template (percuss template --list).
    #[arg(long, value_name = "NAME", help_heading = FILE)]
    pub template: Option<String>,
    /// Names of the points in the table: TOML with lines such as lower_ball = "LBJ".
    ///
    /// Usual names are read without it. A sheet may contain them in a section [names].
    #[arg(long, value_name = "FILE.toml", help_heading = FILE)]
    pub names: Option<String>,
    /// Worksheet of a workbook; default: the first one.
    ///
    /// A workbook that a sheet names as its table of points is meant too.
    #[arg(long, value_name = "NAME", help_heading = FILE)]
    pub worksheet: Option<String>,
    /// Side to build: left, right, both.
    ///
    /// Default: the side given in the sheet, otherwise left.
    #[arg(long, value_name = "SIDE", value_enum, help_heading = CAR)]
    pub side: Option<SideArg>,
    /// Mass of the wheel with its tyre (kg).
    ///
    /// Replaces the mass of the sheet; a JSON contains no wheel mass.
    #[arg(long, value_name = "KG", value_parser = kilograms, help_heading = CAR)]
    pub wheel_mass: Option<f64>,
    /// Moments of inertia of the wheel about its centre (kg·m²), y along the spin axis.
    #[arg(long, value_name = "IX,IY,IZ", value_parser = moments, requires = "wheel_mass", help_heading = CAR)]
    pub wheel_inertia: Option<[f64; 3]>,
    /// Radius of the wheel (m): defines the contact patch.
    #[arg(long, value_name = "M", value_parser = metres, requires = "wheel_mass", help_heading = CAR)]
    pub wheel_radius: Option<f64>,
    /// Mass (kg) of a sliding rack. Default: the rack of the sheet, otherwise a rack fixed to the chassis.
    #[arg(long, value_name = "KG", value_parser = kilograms, help_heading = CAR)]
    pub rack_mass: Option<f64>,
    /// Shift a hardpoint of the sheet (m; 5mm).
    ///
    /// The shift is in the axes of the sheet; numbers without a unit are in m.
    #[arg(long = "move", value_name = "POINT=X,Y,Z", value_parser = point_shift, allow_hyphen_values = true, help_heading = CAR)]
    pub moves: Vec<(String, Point)>,
    /// Refuse files larger than this many bytes.
    #[arg(long, default_value_t = DEFAULT_MAX_SIZE, value_name = "BYTES", help_heading = FILE)]
    pub max_size: u64,
    /// Treat warnings as errors (exit 2).
    #[arg(long, help_heading = FILE)]
    pub strict: bool,
    /// Allow a sheet to name a table of points outside its folder.
    #[arg(long, help_heading = FILE)]
    pub allow_outside: bool,
}

/// Flags of `percuss template`.
#[derive(Debug, Args)]
pub struct TemplateArgs {
    /// Name of the template; --list shows all.
    pub name: Option<String>,
    /// List the templates.
    #[arg(long, conflicts_with = "name")]
    pub list: bool,
    /// Unit of lengths in the sheet: m, cm, mm, in.
    #[arg(long, value_name = "UNIT", value_enum, default_value_t = UnitArg::Mm)]
    pub unit: UnitArg,
    /// Vehicle axes of the sheet: iso, adams, sae, rfactor, or such as "-z x y".
    #[arg(long, value_name = "AXES", value_parser = vehicle_axes, allow_hyphen_values = true, default_value = "iso")]
    pub axes: VehicleAxes,
    /// Sheet to write: .toml, .csv or .xlsx; default: stdout.
    ///
    /// An existing file is not replaced without --force.
    #[arg(long, short, value_name = "SHEET.toml")]
    pub output: Option<String>,
    /// Replace an existing file.
    #[arg(long, requires = "output")]
    pub force: bool,
}
