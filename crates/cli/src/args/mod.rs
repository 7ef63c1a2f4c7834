//! The command line: flags, help, and how their values are parsed.

mod compare;
mod contact;
mod damping;
mod examples;
mod format;
mod headings;
mod import;
mod map;
mod model;
mod short_help;
#[cfg(test)]
mod study_keys_tests;
mod table;
mod words;
mod writing;

pub use compare::CompareArgs;
pub use contact::ContactArgs;
pub use damping::{DampArgs, DampingArgs, SafeSpeedArgs};
pub use format::{CheckFormat, MassFormat};
pub use import::{AxesArg, ImportArgs, SideArg, TemplateArgs, UnitArg};
pub use map::MapArgs;
pub use model::ModelArgs;
pub use short_help::{asked_of, short_help};
pub use table::{FigureArgs, TableArgs};
pub use writing::WritingArgs;

use crate::terminal::failure::Failure;
use clap::builder::Resettable;
use clap::{Args, CommandFactory, Parser, Subcommand};
use headings::{ANSWER, BESIDE, OUTPUT};
use percuss_formats::DEFAULT_MAX_SIZE;
use percuss_study::{PositionFile, RowSource, Sampling, Vary};
pub use words::ToleranceArg;
use words::{any_tolerance, kilograms};

/// Where the rows of a sweep come from.
const ROWS: &str = "Rows";

/// The effective mass of a mechanism at a contact.
///
/// percuss reads a URDF and computes the effective mass at a contact point along the impact normal.
#[derive(Debug, Parser)]
#[command(name = "percuss", version, arg_required_else_help = true, max_term_width = 80, after_help = examples::TOP)]
pub struct Cli {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
    /// Show every note; without this, their number.
    #[arg(long, global = true)]
    pub notes: bool,
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
        let hidden = |argument: clap::Arg| match argument.get_id().as_str() {
            "normal" | "along_line" | "turning_normal" | "normal_frame" | "estimate" => argument.hide(true),
            _ => argument,
        };
        ["damp", "safe-speed", "compare"]
            .into_iter()
            // Not the file's name, which on Windows has an ending.
            .fold(Self::command().bin_name("percuss"), |cli, name| {
                cli.mut_subcommand(name, |c| c.mut_args(optional))
            })
            .mut_subcommand("map", |c| c.mut_args(hidden))
    }
}

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// List what is in a model: links, joints, mobility, mass, diagnostics.
    #[command(after_help = examples::CHECK)]
    Check(CheckArgs),
    /// Effective mass at a contact point along the normal.
    #[command(
        after_help = examples::MASS,
        override_usage = "percuss mass MODEL --link L --point X,Y,Z\n                    (--normal X,Y,Z | --along-line LINK:X,Y,Z) …"
    )]
    Mass(Box<MassArgs>),
    /// The same contact over a range of positions, loops closed along one branch.
    #[command(
        after_help = examples::SWEEP,
        override_usage = "percuss sweep MODEL --link L --point X,Y,Z\n                     (--normal X,Y,Z | --along-line LINK:X,Y,Z)\n                     (--vary RANGE… | --input FILE | --random COUNT) …"
    )]
    Sweep(Box<SweepArgs>),
    /// The same question asked of several designs, with differences in per cent.
    ///
    /// In one table, and one figure.
    #[command(
        after_help = examples::COMPARE,
        override_usage = "percuss compare STUDY.toml…\n       percuss compare MODEL… --link L --point X,Y,Z --normal X,Y,Z\n                       [--vary RANGE] …"
    )]
    Compare(Box<CompareArgs>),
    /// Effective mass over a surface, or over all directions at a point.
    ///
    /// Over the surface of a link, or of a whole robot.
    #[command(
        after_help = examples::MAP,
        override_usage = "percuss map MODEL (--link L | --all) [--output FILE]… …\n       percuss map MODEL --link L --point X,Y,Z --directions COUNT …"
    )]
    Map(Box<MapArgs>),
    /// Write a suspension's sheet to fill in: hardpoints, masses, units, axes.
    #[command(after_help = examples::TEMPLATE)]
    Template(TemplateArgs),
    /// Turn a suspension's sheet, table or Chrono::Vehicle JSON into a URDF+ model.
    ///
    /// The model is commented.
    #[command(after_help = examples::IMPORT)]
    Import(Box<ImportArgs>),
    /// The damper of a required restitution, and the parameters for simulators.
    #[command(
        after_help = examples::DAMP,
        override_usage = "percuss damp (--mass KG | --mass-from MODEL --link L --point X,Y,Z\n                    --normal X,Y,Z …) --stiffness K --restitution E [--speed V]\n                    [--law NAME] [--for TOOL] …"
    )]
    Damp(Box<DampArgs>),
    /// The greatest speed of a robot where it may hit a person.
    ///
    /// Transient contact as in ISO/TS 15066, with the effective mass.
    #[command(
        after_help = examples::SAFE_SPEED,
        override_usage = "percuss safe-speed MODEL --link L --point X,Y,Z --normal X,Y,Z …\n                          --region NAME (--force F | --pressure P --area A)\n                          [--load KG]"
    )]
    SafeSpeed(Box<SafeSpeedArgs>),
    /// Run a study: the flags of mass, sweep and damp, kept in a TOML file.
    #[command(after_help = examples::RUN)]
    Run(RunArgs),
    /// Write a commented study of a model to start from: its links and joints by name, and a contact that has an answer.
    #[command(after_help = examples::INIT)]
    Init(Box<InitArgs>),
    /// Print the JSON schema of studies: every key with what it means, for editors and other programs.
    #[command(after_help = "Example:\n  percuss schema > study.schema.json")]
    Schema,
    /// Print a completion script for a shell.
    #[command(after_help = "Examples:\n  percuss completions bash\n  percuss completions zsh > _percuss")]
    Completions {
        /// For which shell.
        shell: clap_complete::Shell,
    },
}

/// Flags of `percuss check`.
#[derive(Debug, Args)]
pub struct CheckArgs {
    #[command(flatten)]
    pub model: ModelArgs,
    /// How the result is shown.
    #[arg(long, value_enum, default_value_t = CheckFormat::Text, help_heading = ANSWER)]
    pub format: CheckFormat,
}

/// Flags of `percuss mass`.
#[derive(Debug, Args)]
pub struct MassArgs {
    #[command(flatten)]
    pub model: ModelArgs,
    #[command(flatten)]
    pub contact: ContactArgs,
    /// Compare with this effective mass (kg); exit 1 if it is missed.
    #[arg(long, value_name = "KG", value_parser = kilograms, help_heading = ANSWER)]
    pub expect: Option<f64>,
    /// ± on it: mass=2%,com=1mm,point=0.5mm,armature=10%.
    ///
    /// How far off the model's parts may be, and what that leaves of the effective mass: mass and armature in per cent, com and
    /// point (of a sheet) as lengths. Or a number: the relative tolerance of --expect (1e-9 without this).
    #[arg(long, value_name = "PART=VALUE,…", value_parser = any_tolerance, help_heading = BESIDE)]
    pub tolerance: Vec<ToleranceArg>,
    /// So many random designs within --tolerance, beside the first order.
    #[arg(long, value_name = "COUNT", requires = "tolerance", help_heading = BESIDE)]
    pub samples: Option<usize>,
    /// The seed of --samples, 0 without it.
    #[arg(long, value_name = "NUMBER", requires = "samples", help_heading = BESIDE)]
    pub seed: Option<u64>,
    /// What it depends on, and what lowers it most.
    ///
    /// Its rate with each link's mass and centre of mass, each armature and each hardpoint of a sheet, and the changes that lower
    /// it most.
    #[arg(long, help_heading = BESIDE)]
    pub explain: bool,
    /// How the result is shown.
    #[arg(long, value_enum, default_value_t = MassFormat::Text, help_heading = ANSWER)]
    pub format: MassFormat,
    #[command(flatten)]
    pub damping: DampingArgs,
}

impl MassArgs {
    /// The samples asked for.
    pub fn sampling(&self) -> Option<Sampling> {
        let seed = self.seed.unwrap_or_default();
        self.samples.map(|count| Sampling { count, seed })
    }
}

/// Flags of `percuss sweep`.
#[derive(Debug, Args)]
pub struct SweepArgs {
    #[command(flatten)]
    pub model: ModelArgs,
    #[command(flatten)]
    pub contact: ContactArgs,
    /// A joint's range, or a point's travel.
    ///
    /// The varied quantity: a driving joint, or travel:LINK:X,Y,Z:DX,DY,DZ=FROM:TO:COUNT, the travel of a point (m, link's
    /// frame) along a direction (world axes). Given again it makes a grid: every combination, the first the slowest; a travel is
    /// given last.
    #[arg(
        long,
        value_name = "JOINT=FROM:TO:COUNT",
        value_parser = Vary::parse,
        required_unless_present_any = ["input", "random"],
        help_heading = ROWS
    )]
    pub vary: Vec<Vary>,
    /// Positions from a file, row by row.
    ///
    /// Along a path: a column for each joint (JOINT[0], JOINT[1], … for several numbers), a unit behind its name where it is not
    /// SI: "elbow [deg]". - reads the standard input.
    #[arg(
        long,
        value_name = "FILE.csv|.parquet",
        conflicts_with_all = ["vary", "random"],
        help_heading = ROWS
    )]
    pub input: Option<String>,
    /// Leaves a column of --input out.
    #[arg(long, value_name = "COLUMN", help_heading = ROWS)]
    pub ignore: Vec<String>,
    /// Random positions within the joints' limits.
    ///
    /// So many; joints of --set stay where they are.
    #[arg(long, value_name = "COUNT", conflicts_with = "vary", help_heading = ROWS)]
    pub random: Option<usize>,
    /// The seed of --random, 0 without it: the same numbers on every machine.
    #[arg(long, value_name = "NUMBER", help_heading = ROWS)]
    pub seed: Option<u64>,
    /// .csv .xlsx .parquet .json .jsonl .svg .png .pdf
    ///
    /// The output file; its ending chooses the format. Without it, CSV goes to the standard output.
    #[arg(long, short, value_name = "FILE", help_heading = OUTPUT)]
    pub output: Option<String>,
    #[command(flatten)]
    pub table: TableArgs,
    #[command(flatten)]
    pub figure: FigureArgs,
    #[command(flatten)]
    pub writing: WritingArgs,
    /// How many threads compute; by default as many as there are processors. No answer depends on it.
    #[arg(
        long,
        value_name = "COUNT",
        value_parser = clap::value_parser!(u16).range(1..=1024),
        help_heading = OUTPUT
    )]
    pub threads: Option<u16>,
}

impl SweepArgs {
    /// Where the rows come from.
    pub fn source(&self) -> Result<RowSource, Failure> {
        // Not left to clap, which asks for nothing that another flag excludes.
        if self.input.is_none() && !self.ignore.is_empty() {
            return Err(Failure::bad_input("--ignore leaves out columns of --input; give that file"));
        }
        if self.random.is_none() && self.seed.is_some() {
            return Err(Failure::bad_input("--seed is that of --random; give its COUNT"));
        }
        Ok(match (&self.input, self.random) {
            (Some(path), _) => {
                if path == "-" && self.model.model == "-" {
                    return Err(Failure::bad_input(
                        "--input -: the standard input is the model already; name a file for one of them",
                    ));
                }
                let (ignore, max_size) = (self.ignore.clone(), self.model.reading.max_size);
                RowSource::File(PositionFile { path: path.clone(), ignore, max_size })
            }
            (None, Some(count)) => RowSource::Random { count, seed: self.seed.unwrap_or_default() },
            (None, None) => RowSource::Grid(self.vary.clone()),
        })
    }
}

/// Flags of `percuss init`.
#[derive(Debug, Args)]
pub struct InitArgs {
    #[command(flatten)]
    pub model: ModelArgs,
    /// The study; without it stdout.
    #[arg(long, short, value_name = "STUDY.toml")]
    pub output: Option<String>,
    #[command(flatten)]
    pub writing: WritingArgs,
}

/// Flags of `percuss run`.
#[derive(Debug, Args)]
pub struct RunArgs {
    /// The study; - reads the standard input.
    pub study: String,
    /// Show the contact at the study's pose in this format.
    ///
    /// Its sweep is left out.
    #[arg(long, value_enum)]
    pub format: Option<MassFormat>,
    /// Refuse files larger than this many bytes.
    #[arg(long, default_value_t = DEFAULT_MAX_SIZE, value_name = "BYTES")]
    pub max_size: u64,
    /// How many threads compute a sweep.
    ///
    /// By default as many as there are processors.
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,
    /// Make warnings errors (exit 2).
    #[arg(long)]
    pub strict: bool,
    #[command(flatten)]
    pub writing: WritingArgs,
    /// Write a report: one HTML file.
    ///
    /// With the mechanism, contributions, sweep and damper; the answer as JSON and the sweep as CSV beside it.
    #[arg(long, value_name = "FILE.html", conflicts_with = "format")]
    pub report: Option<String>,
    /// Let the study write outside its own folder.
    #[arg(long)]
    pub allow_outside: bool,
}
