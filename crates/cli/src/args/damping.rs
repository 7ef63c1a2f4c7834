//! The damper of a contact, and the speed at which a robot may hit a person.

use super::contact::ContactArgs;
use super::format::CheckFormat;
use super::model::ReadingArgs;
use super::words::{
    Tools, area, energy, force, joint_stop, kilograms, law, momentum, normal, plain, plain_kilograms,
    pressure, ratio, speed, stiffness, time, tools,
};
use super::writing::WritingArgs;
use crate::failure::Failure;
use clap::{Args, ValueEnum};
use percuss_study::contact::Separation;
use percuss_study::contact::exports::Options;
use percuss_study::{DampingQuestion, JointStop, Measured, StudyError, check_units};

/// The damper of the contact: what `percuss damp` and `percuss mass` share.
#[derive(Debug, Args)]
pub struct DampingArgs {
    /// Required coefficient of restitution, from 0 to 1.
    #[arg(long, value_name = "E", allow_hyphen_values = true, value_parser = ratio, requires = "stiffness")]
    pub restitution: Option<f64>,
    /// Stiffness of the contact (N/m; N/mm, kN/m, kN/mm may follow); with --exponent p in N/m^p; of the stop of a joint that
    /// turns in N·m/rad (Nm/rad, Nm/deg may follow).
    #[arg(long, value_name = "K", allow_hyphen_values = true, value_parser = stiffness, requires = "restitution")]
    pub stiffness: Option<Measured>,
    /// Exponent p of the spring's force k x^p: 1 linear (the default), 1.5 Hertz.
    #[arg(long, value_name = "P", allow_hyphen_values = true, value_parser = plain, requires = "restitution")]
    pub exponent: Option<f64>,
    /// Approach speed (m/s; mm/s, km/h may follow; of a joint that turns rad/s, deg/s): for penetration, force and energy, and for laws that depend on it.
    #[arg(long, value_name = "V", allow_hyphen_values = true, value_parser = speed, requires = "restitution")]
    pub speed: Option<Measured>,
    /// Law of the damper; see `percuss damp --list-laws`.
    #[arg(long, default_value = "kelvin-voigt", value_name = "NAME", value_parser = law, requires = "restitution")]
    pub law: String,
    /// When the contact ends: as the force vanishes (the default), or as the gap closes (then the damper pulls at the end).
    #[arg(long, value_enum, requires = "restitution")]
    pub separation: Option<SeparationArg>,
    /// Parameters for a simulator, or `all`: mujoco, drake, gazebo, gazebo-classic, ode, bullet, physx, rapier, chrono, adams,
    /// simscape, dart, opensim, exudyn, newton, jolt.
    #[arg(long = "for", value_name = "TOOL", value_parser = tools, value_delimiter = ',', requires = "restitution")]
    pub tools: Vec<Tools>,
    /// How far the simulator's restitution may be off; chooses the time step.
    #[arg(
        long,
        default_value = "0.001",
        value_name = "E",
        allow_hyphen_values = true,
        value_parser = ratio,
        requires = "restitution"
    )]
    pub accuracy: f64,
    /// The simulator's time step (s; ms may follow), where it is given.
    #[arg(long, value_name = "S", allow_hyphen_values = true, value_parser = time, requires = "restitution")]
    pub time_step: Option<f64>,
    /// Mass (kg) of the struck body by itself, for simulators that divide by it; taken from the model where one is given.
    #[arg(long, value_name = "KG", allow_hyphen_values = true, value_parser = kilograms, requires = "restitution")]
    pub own_mass: Option<f64>,
    /// The same of the other body.
    #[arg(long, value_name = "KG", allow_hyphen_values = true, value_parser = kilograms, requires = "restitution")]
    pub other_own_mass: Option<f64>,
    /// MuJoCo's α = Â·m̄, Â the sum of both bodies' body_invweight0; taken from the model where one is given.
    #[arg(long, value_name = "A", allow_hyphen_values = true, value_parser = plain, requires = "restitution")]
    pub diagonal_ratio: Option<f64>,
}

/// When a contact ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum SeparationArg {
    /// When the force vanishes.
    Force,
    /// When the gap closes.
    Gap,
}

impl DampingArgs {
    /// As a question; none where no restitution is asked for.
    pub fn question(&self) -> Result<Option<DampingQuestion>, Failure> {
        let (Some(restitution), Some(stiffness)) = (self.restitution, self.stiffness) else {
            return Ok(None);
        };
        let mut question = DampingQuestion::new(restitution, stiffness.value);
        let separation = self.separation.map(|end| match end {
            SeparationArg::Force => Separation::ForceVanishes,
            SeparationArg::Gap => Separation::GapCloses,
        });
        question.choose(&self.law, self.exponent, separation).map_err(StudyError::from)?;
        question.speed = self.speed.map(|speed| speed.value);
        for tool in self.tools.iter().flatten() {
            if !question.tools.contains(tool) {
                question.tools.push(*tool);
            }
        }
        question.options = Options {
            accuracy: self.accuracy,
            time_step: self.time_step,
            own_mass: self.own_mass,
            other_own_mass: self.other_own_mass,
            diagonal_ratio: self.diagonal_ratio,
            ..Options::default()
        };
        Ok(Some(question))
    }
}

impl DampingArgs {
    /// Refuses units of a turn for what does not turn, and the other way round.
    pub fn check_units(&self, question: &DampingQuestion, turns: bool) -> Result<(), Failure> {
        let Some(stiffness) = self.stiffness else { return Ok(()) };
        Ok(check_units(question, stiffness, self.speed, turns)?)
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
    /// The stop of a joint in place of a contact, with the inertia that the joint feels through the loops: the joint where
    /// --set has it, or at an end of its range. With --for mujoco, ode, newton, physx.
    #[arg(
        long,
        value_name = "JOINT[:lower|:upper]",
        value_parser = joint_stop,
        requires = "mass_from",
        conflicts_with_all = ["link", "point", "normal", "along_line", "against", "against_mass"]
    )]
    pub limit: Option<JointStop>,
    #[command(flatten)]
    pub reading: ReadingArgs,
    #[command(flatten)]
    pub damping: DampingArgs,
    /// Lists the laws and ends.
    #[arg(long, exclusive = true)]
    pub list_laws: bool,
    /// Lists the simulators and ends.
    #[arg(long, exclusive = true)]
    pub list_tools: bool,
    /// Draws force over time and over penetration.
    #[arg(long, short, value_name = "FILE.svg|.png|.pdf|.csv", requires = "speed")]
    pub output: Option<String>,
    #[command(flatten)]
    pub writing: WritingArgs,
    /// How the result is shown.
    #[arg(long, value_enum, default_value_t = CheckFormat::Text)]
    pub format: CheckFormat,
    #[command(flatten, next_help_heading = "The contact of --mass-from")]
    pub contact: Option<ContactArgs>,
}

/// Flags of `percuss safe-speed`.
#[derive(Debug, Args)]
pub struct SafeSpeedArgs {
    /// The URDF file; - reads the standard input.
    #[arg(required_unless_present = "list_regions")]
    pub model: Option<String>,
    #[command(flatten)]
    pub reading: ReadingArgs,
    /// The region of the body that the robot hits; see --list-regions. Without one what is struck does not give way (a person
    /// held against a wall; doors, guards), and --energy or --momentum is the limit.
    #[arg(long, value_name = "NAME")]
    pub region: Option<String>,
    /// Greatest force allowed (N), from the standard.
    #[arg(long, value_name = "F", allow_hyphen_values = true, value_parser = force, conflicts_with = "pressure")]
    pub force: Option<f64>,
    /// Greatest pressure allowed (N/cm²; N/mm2, MPa may follow), from the standard; with --area.
    #[arg(long, value_name = "P", allow_hyphen_values = true, value_parser = pressure, requires = "area")]
    pub pressure: Option<f64>,
    /// Contact area (cm²; mm2 may follow), for --pressure.
    #[arg(long, value_name = "A", allow_hyphen_values = true, value_parser = area, requires = "pressure")]
    pub area: Option<f64>,
    /// Greatest energy of the impact (J), from the standard: 1/2 μ v², without a region that of all that comes to the contact.
    #[arg(long, value_name = "E", allow_hyphen_values = true, value_parser = energy, conflicts_with_all = ["force", "pressure", "momentum"])]
    pub energy: Option<f64>,
    /// Greatest momentum that is exchanged (N·s), from the standard: μ v.
    #[arg(long, value_name = "P", allow_hyphen_values = true, value_parser = momentum, conflicts_with_all = ["force", "pressure"])]
    pub momentum: Option<f64>,
    /// A direction (world axes) in the place of --normal; once for each. The slowest counts.
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = normal, conflicts_with_all = ["normal", "along_line"])]
    pub direction: Vec<[f64; 3]>,
    /// The direction in which the contact is heaviest, in the place of --normal.
    #[arg(long, conflicts_with_all = ["normal", "along_line"])]
    pub worst_direction: bool,
    /// A file of positions, as that of percuss sweep: the slowest of its rows counts.
    #[arg(long, value_name = "FILE.csv|.parquet", conflicts_with_all = ["direction", "worst_direction"])]
    pub input: Option<String>,
    /// Leaves a column of --input out.
    #[arg(long, value_name = "COLUMN", requires = "input")]
    pub ignore: Vec<String>,
    /// Load with its tool that the model does not hold (kg): a point mass at the contact, and m_L of M/2 + m_L.
    #[arg(long, default_value = "0", value_name = "KG", allow_hyphen_values = true, value_parser = plain_kilograms)]
    pub load: f64,
    /// Lists the regions and ends.
    #[arg(long, exclusive = true)]
    pub list_regions: bool,
    /// How the result is shown.
    #[arg(long, value_enum, default_value_t = CheckFormat::Text)]
    pub format: CheckFormat,
    #[command(flatten, next_help_heading = "The contact")]
    pub contact: Option<ContactArgs>,
}
