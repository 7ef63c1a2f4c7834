//! The damper of a contact, and the speed at which a person may be struck.

use super::words::{kilograms, law, plain, plain_kilograms, tools};
use super::{CheckFormat, ContactArgs, ReadingArgs};
use clap::{Args, ValueEnum};
use percuss_study::DampingQuestion;
use percuss_study::contact::exports::{Options, Tool};
use percuss_study::contact::{Law, Separation};

/// The damper of the contact: what `percuss damp` and `percuss mass` share.
#[derive(Debug, Args)]
pub struct DampingArgs {
    /// Coefficient of restitution wanted, from 0 to 1.
    #[arg(long, value_name = "E", allow_hyphen_values = true, value_parser = plain, requires = "stiffness")]
    pub restitution: Option<f64>,
    /// Stiffness of the contact (N/m; N/m^p with --exponent).
    #[arg(long, value_name = "N/M", allow_hyphen_values = true, value_parser = plain, requires = "restitution")]
    pub stiffness: Option<f64>,
    /// Exponent p of the spring's force k x^p: 1 linear, 1.5 Hertz.
    #[arg(long, default_value = "1", value_name = "P", allow_hyphen_values = true, value_parser = plain, requires = "restitution")]
    pub exponent: f64,
    /// Approach speed (m/s): for penetration, force and energy, and for laws that depend on it.
    #[arg(long, value_name = "M/S", allow_hyphen_values = true, value_parser = plain, requires = "restitution")]
    pub speed: Option<f64>,
    /// Law of the damper; see `percuss damp --list-laws`.
    #[arg(long, default_value = "kelvin-voigt", value_name = "NAME", value_parser = law, requires = "restitution")]
    pub law: Law,
    /// When the contact ends: as the force vanishes, or as the gap closes (then the damper pulls at the end).
    #[arg(long, value_enum, default_value_t = SeparationArg::Force, requires = "restitution")]
    pub separation: SeparationArg,
    /// Parameters for a simulator, or `all`: mujoco, drake, gazebo, ode, bullet, physx, rapier, chrono, adams, simscape.
    #[arg(long = "for", value_name = "TOOL", value_parser = tools, requires = "restitution")]
    pub tools: Vec<Tools>,
    /// How far the simulator's restitution may be off; chooses the time step.
    #[arg(long, default_value = "0.001", value_name = "E", allow_hyphen_values = true, value_parser = plain, requires = "restitution")]
    pub accuracy: f64,
    /// The simulator's time step (s), where it is given.
    #[arg(long, value_name = "S", allow_hyphen_values = true, value_parser = plain, requires = "restitution")]
    pub time_step: Option<f64>,
    /// Mass (kg) of the struck body by itself, for simulators that divide by it; a model tells.
    #[arg(long, value_name = "KG", value_parser = kilograms, requires = "restitution")]
    pub own_mass: Option<f64>,
}

/// When a contact ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum SeparationArg {
    /// When the force vanishes.
    Force,
    /// When the gap closes.
    Gap,
}

/// What `--for` names: one tool, or all.
pub type Tools = Vec<Tool>;

impl DampingArgs {
    /// As a question; none where no restitution is asked for.
    pub fn question(&self) -> Option<DampingQuestion> {
        let (restitution, stiffness) = (self.restitution?, self.stiffness?);
        let mut tools = self.tools.concat();
        tools.dedup();
        Some(DampingQuestion {
            exponent: self.exponent,
            speed: self.speed,
            law: self.law,
            separation: match self.separation {
                SeparationArg::Force => Separation::ForceVanishes,
                SeparationArg::Gap => Separation::GapCloses,
            },
            tools,
            options: Options {
                accuracy: self.accuracy,
                time_step: self.time_step,
                own_mass: self.own_mass,
                ..Options::default()
            },
            ..DampingQuestion::new(restitution, stiffness)
        })
    }
}

/// Flags of `percuss damp`.
#[derive(Debug, Args)]
pub struct DampArgs {
    /// The effective mass (kg).
    #[arg(
        long,
        value_name = "KG",
        allow_hyphen_values = true,
        value_parser = plain_kilograms,
        conflicts_with = "mass_from"
    )]
    pub mass: Option<f64>,
    /// Takes the effective mass from a contact of this model, with the flags of `percuss mass`.
    #[arg(long, value_name = "MODEL")]
    pub mass_from: Option<String>,
    #[command(flatten)]
    pub reading: ReadingArgs,
    #[command(flatten)]
    pub damping: DampingArgs,
    #[command(flatten, next_help_heading = "The contact of --mass-from")]
    pub contact: Option<ContactArgs>,
    /// Lists the laws and ends.
    #[arg(long, exclusive = true)]
    pub list_laws: bool,
    /// Lists the simulators and ends.
    #[arg(long, exclusive = true)]
    pub list_tools: bool,
    /// Draws force over time and over penetration.
    #[arg(long, short, value_name = "FILE.svg|.png|.csv", requires = "speed")]
    pub output: Option<String>,
    /// How the result is shown.
    #[arg(long, value_enum, default_value_t = CheckFormat::Text)]
    pub format: CheckFormat,
}

/// Flags of `percuss safe-speed`.
#[derive(Debug, Args)]
pub struct SafeSpeedArgs {
    /// The URDF file; - reads the standard input.
    #[arg(required_unless_present = "list_regions")]
    pub model: Option<String>,
    #[command(flatten)]
    pub reading: ReadingArgs,
    #[command(flatten)]
    pub contact: Option<ContactArgs>,
    /// The region of the body that is struck; see --list-regions.
    #[arg(long, value_name = "NAME", required_unless_present = "list_regions")]
    pub region: Option<String>,
    /// Greatest force allowed (N), from the standard.
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = plain)]
    pub force: Option<f64>,
    /// Greatest pressure allowed (N/cm²), from the standard; with --area.
    #[arg(long, value_name = "N/CM2", allow_hyphen_values = true, value_parser = plain, requires = "area")]
    pub pressure: Option<f64>,
    /// Contact area (cm²), for --pressure.
    #[arg(long, value_name = "CM2", allow_hyphen_values = true, value_parser = plain, requires = "pressure")]
    pub area: Option<f64>,
    /// Load with its tool that the model does not hold (kg): enters the standard's estimate M/2 + m_L.
    #[arg(long, default_value = "0", value_name = "KG", allow_hyphen_values = true, value_parser = plain_kilograms)]
    pub load: f64,
    /// Lists the regions and ends.
    #[arg(long, exclusive = true)]
    pub list_regions: bool,
    /// How the result is shown.
    #[arg(long, value_enum, default_value_t = CheckFormat::Text)]
    pub format: CheckFormat,
}
