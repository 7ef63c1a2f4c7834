//! Command line: flags, help texts, and parsers of the values.

mod compare;
mod contact;
mod damping;
mod exports;
mod help;
mod impact;
mod import;
mod kinematics;
mod map;
mod model;
mod output;
#[cfg(test)]
mod study_keys_tests;
mod value_parsers;

pub use compare::CompareArgs;
pub use contact::ContactArgs;
pub use damping::{DampArgs, IdentifyArgs, ResponseArgs, RestitutionArgs, SafeSpeedArgs};
pub use exports::{ConvertArgs, ExploreArgs, ExportArgs, GenerateArgs};
pub use help::short_help::{requested_command, short_help};
pub use help::usage_error::usage_error;
pub use impact::{ExtremesArgs, ImpactArgs};
pub use import::{ImportArgs, SideArg, TemplateArgs, UnitArg};
pub use kinematics::KinematicsArgs;
pub use map::MapArgs;
pub use model::ModelArgs;
pub use output::{CheckFormat, KinematicsFormat, MassFormat, SchemaFormat, WritingArgs};

use crate::terminal::failure::Failure;
use crate::unread_flags::mark_unread;
use clap::{Args, CommandFactory, Parser, Subcommand};
use help::examples;
use percuss_formats::DEFAULT_MAX_SIZE;
use percuss_study::headings::{ANSWER, OUTPUT};
use percuss_study::{DampingQuestion, MassOptions, StudyFigure, StudyTable, SweepQuestion};
use std::path::Path;

/// The effective mass of a mechanism at a contact.
///
/// percuss reads a URDF, MJCF or SDF and computes the effective mass at a contact point along the impact normal.
#[derive(Debug, Parser)]
#[command(name = "percuss", version, arg_required_else_help = true, max_term_width = 80, after_help = examples::TOP)]
pub struct Cli {
    /// Command to run.
    #[command(subcommand)]
    pub command: Command,
    /// Show every note; default: only their number.
    #[arg(long, global = true)]
    pub notes: bool,
    /// Show the details of a result: points, axes, joints, method.
    #[arg(long, global = true)]
    pub details: bool,
    /// Significant digits of texts, up to 9; default: 4. JSON and CSV have all digits.
    #[arg(long, global = true, value_name = "COUNT", value_parser = clap::value_parser!(u8).range(2..=9))]
    pub digits: Option<u8>,
}

impl Cli {
    /// Command line; the help of a command has the flags that it reads.
    pub fn definition() -> clap::Command {
        let with_minus = |argument: clap::Arg| match percuss_study::is_number_flag(&argument) {
            true => argument.allow_hyphen_values(true),
            false => argument,
        };
        // Fixed name: on Windows the file name has an extension.
        mark_unread(
            Self::command().bin_name("percuss").mut_subcommands(|command| command.mut_args(with_minus)),
        )
    }
}

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Contents of a model: links, joints, mobility, mass, diagnostics.
    #[command(after_help = examples::CHECK)]
    Check(CheckArgs),
    /// Effective mass at a contact point along the normal.
    #[command(
        after_help = examples::MASS,
        override_usage = "percuss mass MODEL (--at NAME | --link L --point X,Y,Z\n                    (--normal X,Y,Z | --along-line LINK:X,Y,Z)) …"
    )]
    Mass(Box<MassArgs>),
    /// Effective mass over a range of positions; loops stay on one branch.
    #[command(
        after_help = examples::SWEEP,
        override_usage = "percuss sweep MODEL (--at NAME | --link L --point X,Y,Z\n                     (--normal X,Y,Z | --along-line LINK:X,Y,Z))\n                     (--vary RANGE… | --input FILE | --random COUNT) …"
    )]
    Sweep(Box<SweepArgs>),
    /// Several designs at the same contact, with differences in per cent.
    ///
    /// The result is one table and one figure.
    #[command(
        after_help = examples::COMPARE,
        override_usage = "percuss compare STUDY.toml…\n       percuss compare MODEL… (--at NAME | --link L --point X,Y,Z --normal X,Y,Z)\n                       [--vary RANGE] …"
    )]
    Compare(Box<CompareArgs>),
    /// Effective mass over a surface, or over all directions at a point.
    ///
    /// The surface is that of one link or of a whole robot.
    #[command(
        after_help = examples::MAP,
        override_usage = "percuss map MODEL (--link L | --all) [--output FILE]… …\n       percuss map MODEL --link L --point X,Y,Z --directions COUNT …"
    )]
    Map(Box<MapArgs>),
    /// Wheel angles, roll centre, motion ratios, wheel rates over travel.
    #[command(after_help = examples::KINEMATICS)]
    Kinematics(Box<KinematicsArgs>),
    /// Write a blank suspension sheet: hardpoints, masses, units, axes.
    #[command(after_help = examples::TEMPLATE)]
    Template(TemplateArgs),
    /// Convert a suspension sheet, table or Chrono JSON to URDF+.
    ///
    /// The model contains explanatory comments.
    #[command(after_help = examples::IMPORT)]
    Import(Box<ImportArgs>),
    /// Damper for a required restitution, and parameters for simulators.
    #[command(
        after_help = examples::DAMP,
        override_usage = "percuss damp (--mass KG | --mass-from MODEL --at NAME …) --restitution E\n                    [--stiffness K] [--speed V] [--law NAME] [--for TOOL] …"
    )]
    Damp(Box<DampArgs>),
    /// Restitution of given contact parameters: the inverse of damp.
    ///
    /// With peak force and penetration, for a spring and damper or for the parameters of a simulator.
    #[command(
        after_help = examples::RESTITUTION,
        override_usage = "percuss restitution (MODEL (--at NAME | --link L …) | --mass KG)\n        (--stiffness K (--damping C | --hunt-crossley D | --loss-factor E)\n         | --tool NAME --parameter NAME=VALUE…) --speed V"
    )]
    Restitution(Box<RestitutionArgs>),
    /// Stiffness, damping and mass from measured impacts.
    ///
    /// Each with its uncertainty. The data are forces, accelerations, velocities or displacements over time, of one impact or of several. The effective mass is
    /// compared with that of a model.
    #[command(
        after_help = examples::IDENTIFY,
        override_usage = "percuss identify DATA.csv… [--mass-from MODEL --at NAME | --mass KG]\n                        [--speed V | --drop H] [--exponent P] …"
    )]
    Identify(Box<IdentifyArgs>),
    /// Apparent mass over frequency and natural modes with bushes.
    ///
    /// The joints with bushes are elastic; springs, dampers and tyre of the sheet act too. Apparent mass, accelerance, mobility and dynamic
    /// stiffness at the contact; natural frequencies with the links that move, participation and damping.
    #[command(
        after_help = examples::RESPONSE,
        override_usage = "percuss response MODEL (--at NAME | --link L --point X,Y,Z …)\n                        [--frequency FROM:TO:COUNT] [-o FILE] …"
    )]
    Response(Box<ResponseArgs>),
    /// Largest safe speed of a robot that may hit a person.
    ///
    /// Transient contact of ISO/TS 15066, computed with the effective mass.
    #[command(
        after_help = examples::SAFE_SPEED,
        override_usage = "percuss safe-speed MODEL --link L --point X,Y,Z --normal X,Y,Z …\n                          --region NAME (--force F | --pressure P --area A)\n                          [--load KG]"
    )]
    SafeSpeed(Box<SafeSpeedArgs>),
    /// Rigid impact: impulse, rates after it, and reactions in all joints and loop closures.
    #[command(
        after_help = examples::IMPACT,
        override_usage = "percuss impact MODEL (--at NAME | --link L --point X,Y,Z\n                      (--normal X,Y,Z | --along-line LINK:X,Y,Z))\n                      --restitution E (--speed V | --rates JOINT=RATE…) …"
    )]
    Impact(Box<ImpactArgs>),
    /// Smallest and largest effective mass over joint ranges or a path.
    #[command(
        after_help = examples::EXTREMES,
        override_usage = "percuss extremes MODEL (--at NAME | --link L --point X,Y,Z\n                        (--normal X,Y,Z | --along-line LINK:X,Y,Z))\n                        [--range JOINT=FROM:TO]… [--keep LINK] [--path FILE] …"
    )]
    Extremes(Box<ExtremesArgs>),
    /// Page in which the mechanism moves and the effective mass follows.
    ///
    /// One HTML file without requests: joints, wheel travel, contact and hardpoints are dragged, and the curve follows.
    #[command(
        after_help = examples::EXPLORE,
        override_usage = "percuss explore MODEL|STUDY [--at NAME | --link L --point X,Y,Z --normal X,Y,Z] …\n                       [-o FILE.html] [--open]"
    )]
    Explore(Box<ExploreArgs>),
    /// Write C or Rust code that computes the effective mass from a configuration.
    ///
    /// The code needs no library: for controllers, simulation models and microcontrollers.
    #[command(
        after_help = examples::GENERATE,
        override_usage = "percuss generate MODEL (--at NAME | --link L --point X,Y,Z\n                        (--normal X,Y,Z | --along-line LINK:X,Y,Z))\n                        [--language c|rust] [-o FOLDER] …"
    )]
    Generate(Box<GenerateArgs>),
    /// Convert a model to MJCF, SDFormat or URDF, with its loops.
    #[command(after_help = examples::CONVERT)]
    Convert(Box<ConvertArgs>),
    /// Write a model for simulators; for MuJoCo with an impact that runs.
    ///
    /// The file of an impact contains the mechanism with its loops, the contact with its parameters, and the pose and velocity at
    /// the touch. The script prints the restitution. Without a contact, the result is that of `percuss convert`.
    #[command(
        after_help = examples::EXPORT,
        override_usage = "percuss export MODEL (--at NAME | --link L --point X,Y,Z\n                      (--normal X,Y,Z | --along-line LINK:X,Y,Z))\n                      --restitution E --stiffness K [--speed V] -o FILE.xml\n       percuss export MODEL -o FILE"
    )]
    Export(Box<ExportArgs>),
    /// Run a study: flags of mass, sweep and damp, kept in a TOML file.
    #[command(after_help = examples::RUN)]
    Run(RunArgs),
    /// Write a first study of a model, with comments: names of links and joints, and a contact with a result.
    #[command(after_help = examples::INIT)]
    Init(Box<InitArgs>),
    /// Print the JSON schema of studies or of reports, for editors and programs: every key with its meaning.
    #[command(after_help = "Example:\n  percuss schema > study.schema.json")]
    Schema {
        /// JSON schema of studies or of reports, or a page of all keys of studies.
        #[arg(long, value_enum, default_value_t = SchemaFormat::Json)]
        format: SchemaFormat,
    },
    /// Print a completion script for a shell.
    #[command(after_help = "Examples:\n  percuss completions bash\n  percuss completions zsh > _percuss")]
    Completions {
        /// Shell of the script.
        shell: clap_complete::Shell,
    },
}

/// Flags of `percuss check`.
#[derive(Debug, Args)]
pub struct CheckArgs {
    #[command(flatten)]
    pub model: ModelArgs,
    /// Format of the result.
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
    #[command(flatten)]
    pub requests: MassOptions,
    /// Format of the result.
    #[arg(long, value_enum, default_value_t = MassFormat::Text, help_heading = ANSWER)]
    pub format: MassFormat,
    #[command(flatten)]
    pub damping: DampingQuestion,
}

/// Flags of `percuss sweep`.
#[derive(Debug, Args)]
pub struct SweepArgs {
    #[command(flatten)]
    pub model: ModelArgs,
    #[command(flatten)]
    pub contact: ContactArgs,
    #[command(flatten)]
    pub sweep: SweepQuestion,
    #[command(flatten)]
    pub table: StudyTable,
    #[command(flatten)]
    pub figure: StudyFigure,
    #[command(flatten)]
    pub writing: WritingArgs,
    /// Number of threads; default: the number of processors. Results do not depend on it.
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u16).range(1..=1024), help_heading = OUTPUT)]
    pub threads: Option<u16>,
}

impl SweepArgs {
    /// Converts the flags to a question about the rows.
    pub fn question(&self) -> Result<SweepQuestion, Failure> {
        if self.sweep.input.as_deref() == Some("-") && self.model.model == "-" {
            return Err(Failure::bad_input(
                "--input -: the model is already read from the standard input; give a file name for one of the two",
            ));
        }
        let (sweep, ranges) = (&self.sweep, self.contact.ranges()?);
        if sweep.input.is_none() && sweep.random.is_none() && sweep.vary.is_empty() && ranges.is_empty() {
            return Err(Failure::bad_input(
                "no range is given: --vary JOINT=FROM:TO:COUNT, or a motion of the wheels such as --heave -80mm:80mm:33",
            ));
        }
        Ok(sweep.checked(ranges, Path::new(""), self.model.reading.max_size)?)
    }
}

/// Flags of `percuss init`.
#[derive(Debug, Args)]
pub struct InitArgs {
    /// Output file of the study; default: stdout.
    #[arg(long, short, value_name = "STUDY.toml")]
    pub output: Option<String>,
    #[command(flatten)]
    pub model: ModelArgs,
    #[command(flatten)]
    pub writing: WritingArgs,
}

/// Flags of `percuss run`.
#[derive(Debug, Args)]
pub struct RunArgs {
    /// Study file; - reads the standard input.
    pub study: String,
    /// Show the contact at the study's pose in this format.
    ///
    /// The sweep of the study is not run.
    #[arg(long, value_enum)]
    pub format: Option<MassFormat>,
    /// Refuse files larger than this many bytes.
    #[arg(long, default_value_t = DEFAULT_MAX_SIZE, value_name = "BYTES")]
    pub max_size: u64,
    /// Number of threads of a sweep.
    ///
    /// Default: the number of processors.
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,
    /// Treat warnings as errors (exit 2).
    #[arg(long)]
    pub strict: bool,
    #[command(flatten)]
    pub writing: WritingArgs,
    /// Write a report as one HTML file.
    ///
    /// The report shows the mechanism, contributions, sweep and damper. The result as JSON and the sweep as CSV are
    /// written to the same folder.
    #[arg(long, value_name = "FILE.html", conflicts_with = "format")]
    pub report: Option<String>,
    /// Write the page of percuss explore as well, and link to it in the report.
    #[arg(long, value_name = "FILE.html", requires = "report")]
    pub explorer: Option<String>,
    /// Allow the study to write outside its own folder.
    #[arg(long)]
    pub allow_outside: bool,
}
