//! The command line: flags, help, and how their words are read.

use clap::{Args, Parser, Subcommand, ValueEnum};
use percuss_dynamics::{Base, Frame};
use percuss_formats::{DEFAULT_MAX_SIZE, LoadOptions};
use percuss_mechanism::Accept;
use percuss_study::{Dimension, EstimateQuestion, Hold, MassQuestion, Normal, Quantity, Vary, parse_triple};

/// How heavy is a mechanism where it is struck?
///
/// percuss reads a URDF and answers the effective mass at a contact point along the impact normal.
#[derive(Debug, Parser)]
#[command(name = "percuss", version, arg_required_else_help = true, after_help = TOP_EXAMPLES)]
pub struct Cli {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

const TOP_EXAMPLES: &str = "\
Examples:
  percuss check models/six_r_arm.urdf
  percuss mass models/point_mass_pendulum.urdf --link rod --point 0,0,-0.8 --normal 1,0,0
  percuss completions bash > /etc/bash_completion.d/percuss

Exit codes: 0 an answer (immovable and massless are answers), 1 no answer, 2 bad input or usage.";

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Say what is in a model: links, joints, mobility, mass, diagnostics.
    #[command(after_help = CHECK_EXAMPLES)]
    Check(CheckArgs),
    /// Effective mass at a contact point along the normal.
    #[command(after_help = MASS_EXAMPLES)]
    Mass(Box<MassArgs>),
    /// The same contact over a range of positions, loops closed along one branch.
    #[command(after_help = SWEEP_EXAMPLES)]
    Sweep(Box<SweepArgs>),
    /// Turn a suspension's hardpoints (Chrono::Vehicle JSON) into a commented URDF+ model.
    #[command(after_help = IMPORT_EXAMPLES)]
    Import(ImportArgs),
    /// Run a study: the flags of mass and sweep, kept in a TOML file.
    #[command(after_help = RUN_EXAMPLES)]
    Run(RunArgs),
    /// Print a completion script for a shell.
    #[command(after_help = "Examples:\n  percuss completions bash\n  percuss completions zsh > _percuss")]
    Completions {
        /// For which shell.
        shell: clap_complete::Shell,
    },
}

const CHECK_EXAMPLES: &str = "\
Examples:
  percuss check models/double_pendulum.urdf
  percuss check robot.urdf --format json
  xacro robot.urdf.xacro | percuss check -
  percuss check robot.urdf --strict          warnings are errors (exit 2)";

const SWEEP_EXAMPLES: &str = "\
Examples:
  Over a joint's range, as CSV:
    percuss sweep models/four_bar.urdf --link coupler --point 0.35,0.1,0 --normal 0,1,0 --vary crank_hinge=0:360deg:361
  Over the travel of a wheel's centre, as a plot:
    percuss sweep models/double_wishbone.urdf --link spring_seat --point 0,0,0 \\
        --along-line spring_chassis_seat:0,0,0 --vary travel:spindle:0,0,0:0,0,1=-80mm:80mm:161 \\
        --estimate spindle,upright --output travel.svg

The file's ending chooses the format: .csv, .json, .svg or .png; without --output, CSV goes to stdout. A row that cannot be
reached says so and the sweep goes on; exit 1 if none can.";

const IMPORT_EXAMPLES: &str = "\
Examples:
  percuss import HMMWV_DoubleWishboneFront.json -o front_left.urdf
  percuss import Sedan_DoubleWishbone.json -o axle.urdf --side both --wheel-mass 18kg --wheel-inertia 0.6,1.1,0.6 \\
      --wheel-radius 0.31

Templates: DoubleWishbone, DoubleWishboneReduced, MacPhersonStrut, SemiTrailingArm, ThreeLinkIRS, MultiLink. See
docs/SUSPENSIONS.md for bodies, joints and frames.";

const RUN_EXAMPLES: &str = "\
Examples:
  percuss run models/four_bar.toml                 its sweep, if it has one, else the contact
  percuss run models/four_bar.toml --format json   the contact at its pose";

const MASS_EXAMPLES: &str = "\
Examples:
  A pendulum strikes a stop 0.8 m below its hinge:
    percuss mass models/point_mass_pendulum.urdf --link rod --point 0,0,-0.8 --normal 1,0,0
  An arm in a pose, its tool pushed down along the world's z:
    percuss mass models/six_r_arm.urdf --link tool --point 0.08,0,0 --normal 0,0,-1 --normal-frame world \\
        --set shoulder=-40deg --set elbow=70deg
  Felt by a spring, along its line to a seat on another link:
    percuss mass models/double_wishbone.urdf --link spring_seat --point 0,0,0 --along-line spring_chassis_seat:0,0,0
  The classical estimate beside it, and why it is off:
    percuss mass models/double_wishbone.urdf --link spring_seat --point 0,0,0 \\
        --along-line spring_chassis_seat:0,0,0 --estimate spindle,upright:0,0,0:0,0,1
  A free body of 2 kg strikes it:
    percuss mass models/physical_pendulum.urdf --link body --point 0,0,-0.5 --normal 1,0,0 --against-mass 2kg
  In a regression test, against a closed form:
    percuss mass models/point_mass_pendulum.urdf --link rod --point 0,0,-0.8 --normal 1,0,0 --expect 0.78125

Numbers are SI; deg, rad, mm, cm, m, g, kg may follow them. The normal points out of the struck link into the
other side; its length does not matter.";

/// Which model, and how it is read.
#[derive(Debug, Args)]
pub struct ModelArgs {
    /// The URDF file; - reads the standard input.
    pub model: String,
    /// Take a finding as it is, against the loader's advice.
    #[arg(long, value_enum, value_name = "FINDING")]
    pub accept: Vec<Acceptable>,
    /// Refuse files larger than this many bytes.
    #[arg(long, default_value_t = DEFAULT_MAX_SIZE, value_name = "BYTES")]
    pub max_size: u64,
    /// Make warnings errors (exit 2).
    #[arg(long)]
    pub strict: bool,
}

/// What `--accept` takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Acceptable {
    /// Inertias with a negative principal moment.
    IndefiniteInertia,
}

impl ModelArgs {
    /// As the loader wants it.
    pub fn options(&self) -> LoadOptions {
        let indefinite_inertia = self.accept.contains(&Acceptable::IndefiniteInertia);
        LoadOptions { accept: Accept { indefinite_inertia } }
    }
}

/// Flags of `percuss check`.
#[derive(Debug, Args)]
pub struct CheckArgs {
    #[command(flatten)]
    pub model: ModelArgs,
    /// How the result is shown.
    #[arg(long, value_enum, default_value_t = CheckFormat::Text)]
    pub format: CheckFormat,
}

/// Formats of `percuss check`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum CheckFormat {
    /// For people.
    Text,
    /// For programs.
    Json,
}

/// Formats of `percuss mass`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum MassFormat {
    /// For people.
    Text,
    /// For programs.
    Json,
    /// One row with a header, the columns of a sweep.
    Csv,
}

/// In which frame point and normal are given.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum FrameArg {
    /// The struck link's.
    Link,
    /// The root link's at its reference pose.
    World,
    /// The other link's.
    Against,
}

impl From<FrameArg> for Frame {
    fn from(frame: FrameArg) -> Self {
        match frame {
            FrameArg::Link => Frame::Link,
            FrameArg::World => Frame::World,
            FrameArg::Against => Frame::Against,
        }
    }
}

/// How the root link stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum BaseArg {
    /// It is the ground.
    Fixed,
    /// It moves freely.
    Floating,
}

/// The contact and the conditions: what `percuss mass` and `percuss sweep` share.
#[derive(Debug, Args)]
pub struct ContactArgs {
    /// The struck link.
    #[arg(long, value_name = "LINK")]
    pub link: String,
    /// The contact point (m).
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = point)]
    pub point: [f64; 3],
    /// The normal, out of the struck link into the other side.
    #[arg(
        long,
        value_name = "X,Y,Z",
        allow_hyphen_values = true,
        value_parser = normal,
        required_unless_present = "along_line",
        conflicts_with = "along_line"
    )]
    pub normal: Option<[f64; 3]>,
    /// The normal points from the contact point towards this point (m) of a link, in that link's frame.
    #[arg(long, value_name = "LINK:X,Y,Z", value_parser = line)]
    pub along_line: Option<(String, [f64; 3])>,
    /// In which frame the point and the normal are given, both.
    #[arg(long, value_enum, default_value_t = FrameArg::Link)]
    pub frame: FrameArg,
    /// In which frame the normal is given, where it is not that of the point.
    #[arg(long, value_enum)]
    pub normal_frame: Option<FrameArg>,
    /// The other link; the ground if none is given.
    #[arg(long, value_name = "LINK")]
    pub against: Option<String>,
    /// A free body of this mass (kg) on the other side.
    #[arg(long, value_name = "KG", allow_hyphen_values = true, value_parser = kilograms, conflicts_with = "against")]
    pub against_mass: Option<f64>,
    /// Sets a driving joint; the others stand at 0. Spherical: w,x,y,z; planar: x,y,angle; floating: x,y,z,w,x,y,z.
    #[arg(long, value_name = "JOINT=VALUE", value_parser = assignment)]
    pub set: Vec<(String, String)>,
    /// Says where to look for a joint that follows from loops: which way to put them together is meant.
    #[arg(long, value_name = "JOINT=VALUE", value_parser = assignment)]
    pub guess: Vec<(String, String)>,
    /// Holds a joint where it stands.
    #[arg(long, value_name = "JOINT")]
    pub lock: Vec<String>,
    /// Holds a point (m, link's frame) of a link to the ground: along a normal (world axes, out of the link), or in all
    /// directions.
    #[arg(long, value_name = "LINK:X,Y,Z[:NX,NY,NZ]", value_parser = hold)]
    pub hold: Vec<Hold>,
    /// Rotor inertia reflected to a joint (kg·m² or kg): one value, or one for each velocity between commas.
    #[arg(long, value_name = "JOINT=VALUE", value_parser = armature)]
    pub armature: Vec<(String, Vec<f64>)>,
    /// How the root link stands.
    #[arg(long, value_enum, default_value_t = BaseArg::Fixed)]
    pub base: BaseArg,
    /// Sets the classical estimate beside the answer: the mass of these links, moved with point A (m, first link's frame;
    /// default its origin), by A's full speed or its component along a direction (world axes).
    #[arg(long, value_name = "LINK[,LINK…][:X,Y,Z[:DX,DY,DZ]]", value_parser = estimate)]
    pub estimate: Option<EstimateQuestion>,
}

/// Flags of `percuss mass`.
#[derive(Debug, Args)]
pub struct MassArgs {
    #[command(flatten)]
    pub model: ModelArgs,
    #[command(flatten)]
    pub contact: ContactArgs,
    /// Compare with this effective mass (kg); exit 1 if it is missed.
    #[arg(long, value_name = "KG", value_parser = kilograms)]
    pub expect: Option<f64>,
    /// Relative tolerance of --expect.
    #[arg(long, default_value_t = 1e-9, value_name = "RELATIVE", value_parser = tolerance, requires = "expect")]
    pub tolerance: f64,
    /// How the result is shown.
    #[arg(long, value_enum, default_value_t = MassFormat::Text)]
    pub format: MassFormat,
}

/// Flags of `percuss sweep`.
#[derive(Debug, Args)]
pub struct SweepArgs {
    #[command(flatten)]
    pub model: ModelArgs,
    #[command(flatten)]
    pub contact: ContactArgs,
    /// What is varied: a driving joint, or the travel of a point (m, link's frame) along a direction (world axes).
    #[arg(
        long,
        value_name = "JOINT=FROM:TO:COUNT | travel:LINK:X,Y,Z:DX,DY,DZ=FROM:TO:COUNT",
        value_parser = Vary::parse
    )]
    pub vary: Vary,
    /// Where the rows go.
    #[arg(long, short, value_name = "FILE.csv|.json|.svg|.png")]
    pub output: Option<String>,
}

/// Which side of the vehicle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum SideArg {
    /// As the file has it.
    Left,
    /// Its mirror image.
    Right,
    /// Both on one chassis.
    Both,
}

/// Flags of `percuss import`.
#[derive(Debug, Args)]
pub struct ImportArgs {
    /// The hardpoint file; - reads the standard input.
    pub hardpoints: String,
    /// The URDF+ file to write; - writes to stdout.
    #[arg(long, short, value_name = "MODEL.urdf")]
    pub output: String,
    /// Which side.
    #[arg(long, value_enum, default_value_t = SideArg::Left)]
    pub side: SideArg,
    /// Mass of the wheel with its tyre (kg); the file has none.
    #[arg(long, value_name = "KG", value_parser = kilograms)]
    pub wheel_mass: Option<f64>,
    /// Moments of the wheel about its centre (kg·m²), y along the spin axis.
    #[arg(long, value_name = "IX,IY,IZ", value_parser = moments, requires = "wheel_mass")]
    pub wheel_inertia: Option<[f64; 3]>,
    /// Radius of the wheel (m): names the contact patch.
    #[arg(long, value_name = "M", value_parser = metres, requires = "wheel_mass")]
    pub wheel_radius: Option<f64>,
    /// Lets the rack slide, with this mass (kg); otherwise it is fixed to the chassis.
    #[arg(long, value_name = "KG", value_parser = kilograms)]
    pub rack_mass: Option<f64>,
    /// Refuse files larger than this many bytes.
    #[arg(long, default_value_t = DEFAULT_MAX_SIZE, value_name = "BYTES")]
    pub max_size: u64,
    /// Make warnings errors (exit 2).
    #[arg(long)]
    pub strict: bool,
}

/// Flags of `percuss run`.
#[derive(Debug, Args)]
pub struct RunArgs {
    /// The study; - reads the standard input.
    pub study: String,
    /// Show the contact at the study's pose in this format; its sweep is left out.
    #[arg(long, value_enum)]
    pub format: Option<MassFormat>,
    /// Refuse files larger than this many bytes.
    #[arg(long, default_value_t = DEFAULT_MAX_SIZE, value_name = "BYTES")]
    pub max_size: u64,
    /// Make warnings errors (exit 2).
    #[arg(long)]
    pub strict: bool,
}

impl ContactArgs {
    /// As a question.
    pub fn question(&self) -> MassQuestion {
        let normal = match (&self.along_line, self.normal) {
            (Some((link, point)), _) => Normal::Toward(link.clone(), *point),
            // clap sees to it that one of them is given.
            (None, normal) => Normal::Along(normal.unwrap_or_default()),
        };
        MassQuestion {
            link: self.link.clone(),
            point: self.point,
            normal,
            frame: self.frame.into(),
            normal_frame: self.normal_frame.unwrap_or(self.frame).into(),
            against: self.against.clone(),
            against_mass: self.against_mass,
            set: self.set.clone(),
            guess: self.guess.clone(),
            lock: self.lock.clone(),
            hold: self.hold.clone(),
            armature: self.armature.clone(),
            base: match self.base {
                BaseArg::Fixed => Base::Fixed,
                BaseArg::Floating => Base::Floating,
            },
            estimate: self.estimate.clone(),
        }
    }
}

fn point(text: &str) -> Result<[f64; 3], String> {
    parse_triple(text, Dimension::Length).map_err(|e| e.to_string())
}

fn normal(text: &str) -> Result<[f64; 3], String> {
    parse_triple(text, Dimension::Plain).map_err(|e| e.to_string())
}

fn kilograms(text: &str) -> Result<f64, String> {
    let mass = Quantity::parse(text).and_then(|q| q.of(Dimension::Mass, text)).map_err(|e| e.to_string())?;
    if mass > 0.0 { Ok(mass) } else { Err(format!("{mass} kg; a mass above 0 is wanted")) }
}

fn metres(text: &str) -> Result<f64, String> {
    let length =
        Quantity::parse(text).and_then(|q| q.of(Dimension::Length, text)).map_err(|e| e.to_string())?;
    if length > 0.0 { Ok(length) } else { Err(format!("{length} m; a length above 0 is wanted")) }
}

fn moments(text: &str) -> Result<[f64; 3], String> {
    let moments = parse_triple(text, Dimension::Plain).map_err(|e| e.to_string())?;
    if moments.iter().all(|i| *i >= 0.0) {
        Ok(moments)
    } else {
        Err("moments of 0 or more are wanted".into())
    }
}

fn tolerance(text: &str) -> Result<f64, String> {
    let value =
        Quantity::parse(text).and_then(|q| q.of(Dimension::Plain, text)).map_err(|e| e.to_string())?;
    if value >= 0.0 { Ok(value) } else { Err(format!("{value}; a tolerance of 0 or more is wanted")) }
}

/// `LINK:X,Y,Z`, split at the last colon: link names may have some of their own.
fn line(text: &str) -> Result<(String, [f64; 3]), String> {
    match text.rsplit_once(':') {
        Some((link, numbers)) if !link.is_empty() => Ok((link.to_owned(), point(numbers)?)),
        _ => Err("wanted LINK:X,Y,Z, such as chassis:0.3,0,0.4".into()),
    }
}

/// `JOINT=VALUE`, split at the last equals sign.
fn assignment(text: &str) -> Result<(String, String), String> {
    match text.rsplit_once('=') {
        Some((joint, value)) if !joint.is_empty() && !value.is_empty() => {
            Ok((joint.to_owned(), value.to_owned()))
        }
        _ => Err("wanted JOINT=VALUE, such as elbow=30deg".into()),
    }
}

fn armature(text: &str) -> Result<(String, Vec<f64>), String> {
    let (joint, value) = assignment(text)?;
    let values = percuss_study::parse_list(&value, |_| Dimension::Plain).map_err(|e| e.to_string())?;
    Ok((joint, values))
}

/// Up to two triples behind a name, split from the right.
fn triples(text: &str) -> (&str, Vec<&str>) {
    let (mut name, mut found) = (text, Vec::new());
    while found.len() < 2
        && let Some((rest, last)) = name.rsplit_once(':')
        && last.contains(',')
        && last.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c))
    {
        found.insert(0, last);
        name = rest;
    }
    (name, found)
}

fn hold(text: &str) -> Result<Hold, String> {
    let (link, found) = triples(text);
    let (at, along) = match found[..] {
        [at] => (at, None),
        [at, along] => (at, Some(normal(along)?)),
        _ => return Err("wanted LINK:X,Y,Z or LINK:X,Y,Z:NX,NY,NZ, such as foot:0,0,0:0,0,-1".into()),
    };
    Ok(Hold { link: link.to_owned(), point: point(at)?, normal: along })
}

fn estimate(text: &str) -> Result<EstimateQuestion, String> {
    let (links, found) = triples(text);
    let links: Vec<String> = links.split(',').map(str::to_owned).collect();
    if links.iter().any(String::is_empty) {
        return Err("wanted LINK[,LINK…][:X,Y,Z[:DX,DY,DZ]], such as spindle,upright:0,0,0:0,0,1".into());
    }
    let at = found.first().map_or(Ok([0.0; 3]), |text| point(text))?;
    let direction = found.get(1).map(|text| normal(text)).transpose()?;
    Ok(EstimateQuestion { links, point: at, direction })
}
