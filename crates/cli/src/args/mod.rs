//! The command line: flags, help, and how their words are read.

mod contact;
mod damping;
mod import;
mod model;
mod words;

pub use contact::ContactArgs;
pub use damping::{DampArgs, DampingArgs, SafeSpeedArgs, Tools};
pub use import::{ImportArgs, SideArg};
pub use model::{ModelArgs, ReadingArgs};

use clap::builder::Resettable;
use clap::{Args, CommandFactory, Parser, Subcommand, ValueEnum};
use percuss_formats::DEFAULT_MAX_SIZE;
use percuss_study::Vary;
use words::{kilograms, tolerance};

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

impl Cli {
    /// The command line. A contact is not asked for where a mass or a list may stand in its place.
    pub fn definition() -> clap::Command {
        let optional = |argument: clap::Arg| match argument.get_id().as_str() {
            "link" | "point" | "normal" => {
                argument.required(false).required_unless_present(Resettable::Reset)
            }
            _ => argument,
        };
        ["damp", "safe-speed"]
            .into_iter()
            .fold(Self::command(), |cli, name| cli.mut_subcommand(name, |c| c.mut_args(optional)))
    }
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
    /// The damper that gives a contact a restitution, and the parameters to type into simulators.
    #[command(after_help = DAMP_EXAMPLES)]
    Damp(Box<DampArgs>),
    /// How fast a robot may move where it may strike a person: transient contact as in ISO/TS 15066, with the effective mass.
    #[command(after_help = SAFE_SPEED_EXAMPLES)]
    SafeSpeed(Box<SafeSpeedArgs>),
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

const DAMP_EXAMPLES: &str = "\
Examples:
  Steel on a rubber stop, 12 kg felt at the contact:
    percuss damp --mass 12kg --stiffness 4e5 --restitution 0.4 --speed 0.5
  For MuJoCo and Drake, ready to paste:
    percuss damp --mass 12kg --stiffness 4e5 --restitution 0.4 --speed 0.5 --for mujoco --for drake
  A suspension on its bump stop, from the model:
    percuss damp --mass-from models/double_wishbone.urdf --link bump_stop_pad --point 0,0,0 \\
        --along-line bump_stop:0,0,0 --against chassis --stiffness 2e5 --restitution 0.3 --speed 0.5
  Which laws there are:
    percuss damp --list-laws

The default law is the linear one, exactly, ending when the force vanishes: no contact pulls, and simulators cut there. With
--separation gap it is the half-period formula of textbooks.";

const SAFE_SPEED_EXAMPLES: &str = "\
Examples:
  percuss safe-speed models/six_r_arm.urdf --link tool --point 0.08,0,0 --normal 1,0,0 --set elbow=70deg \\
      --region chest --force 280 --load 2kg
  percuss safe-speed --list-regions

An engineering aid, no certification: the limits of force or pressure are yours to give, from the edition of the standard that
applies to you, and the table of regions is informative.";

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
    #[command(flatten, next_help_heading = "The damper of the contact")]
    pub damping: DampingArgs,
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
