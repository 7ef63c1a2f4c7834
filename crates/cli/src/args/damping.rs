//! The damper of a contact, and the speed at which a robot may hit a person.

use super::contact::ContactArgs;
use super::format::CheckFormat;
use super::model::ReadingArgs;
use super::words::{
    Tools, area, energy, force, joint_stop, kilograms, law, momentum, normal, plain, plain_kilograms,
    pressure, ratio, speed, stiffness, time, tools,
};
use super::writing::WritingArgs;
use crate::terminal::failure::Failure;
use clap::{Args, ValueEnum};
use percuss_study::contact::Separation;
use percuss_study::contact::exports::Options;
use percuss_study::{DampingQuestion, JointStop, Measured, StudyError, check_units};

/// A heading of the help.
const DAMPER: &str = "Damper";

/// The damper of the contact: what `percuss damp` and `percuss mass` share.
#[derive(Debug, Args)]
pub struct DampingArgs {
    /// Required coefficient of restitution, from 0 to 1.
    #[arg(
        long,
        value_name = "E",
        allow_hyphen_values = true,
        value_parser = ratio,
        requires = "stiffness",
        help_heading = DAMPER
    )]
    pub restitution: Option<f64>,
    /// Stiffness of the contact (N/m; 200N/mm).
    ///
    /// N/mm, kN/m, kN/mm may follow the number; with --exponent p it is in N/m^p; of the stop of a joint that turns in N·m/rad
    /// (Nm/rad, Nm/deg may follow).
    #[arg(
        long,
        value_name = "K",
        allow_hyphen_values = true,
        value_parser = stiffness,
        requires = "restitution",
        help_heading = DAMPER
    )]
    pub stiffness: Option<Measured>,
    /// p of the spring's force k x^p; 1.5 is Hertz.
    ///
    /// Its exponent: 1 linear (the default), 1.5 Hertz.
    #[arg(
        long,
        value_name = "P",
        allow_hyphen_values = true,
        value_parser = plain,
        requires = "restitution",
        help_heading = DAMPER
    )]
    pub exponent: Option<f64>,
    /// Approach speed (m/s): penetration, force, energy.
    ///
    /// mm/s, km/h may follow the number; of a joint that turns rad/s, deg/s. Some laws depend on it.
    #[arg(
        long,
        value_name = "V",
        allow_hyphen_values = true,
        value_parser = speed,
        requires = "restitution",
        help_heading = DAMPER
    )]
    pub speed: Option<Measured>,
    /// Law of the damper (damp --list-laws).
    ///
    /// `percuss damp --list-laws` shows them.
    #[arg(
        long,
        default_value = "kelvin-voigt",
        value_name = "NAME",
        value_parser = law,
        requires = "restitution",
        help_heading = DAMPER
    )]
    pub law: String,
    /// When the contact ends: as the force vanishes (the default), or as the gap closes (then the damper pulls at the end).
    #[arg(long, value_enum, requires = "restitution", help_heading = DAMPER)]
    pub separation: Option<SeparationArg>,
    /// Parameters for a simulator, or for all.
    ///
    /// mujoco, drake, gazebo, gazebo-classic, ode, bullet, physx, rapier, chrono, adams, simscape, dart, opensim, exudyn,
    /// newton, jolt, or all; several between commas.
    #[arg(
        long = "for",
        value_name = "TOOL",
        value_parser = tools,
        value_delimiter = ',',
        requires = "restitution",
        help_heading = DAMPER
    )]
    pub tools: Vec<Tools>,
    /// How far the simulator's restitution may be off; chooses the time step.
    #[arg(
        long,
        default_value = "0.001",
        value_name = "E",
        allow_hyphen_values = true,
        value_parser = ratio,
        requires = "restitution",
        help_heading = DAMPER
    )]
    pub accuracy: f64,
    /// The simulator's time step (s; ms may follow), where it is given.
    #[arg(
        long,
        value_name = "S",
        allow_hyphen_values = true,
        value_parser = time,
        requires = "restitution",
        help_heading = DAMPER
    )]
    pub time_step: Option<f64>,
    /// Mass (kg) of the struck body by itself, for simulators that divide by it; taken from the model where one is given.
    #[arg(
        long,
        value_name = "KG",
        allow_hyphen_values = true,
        value_parser = kilograms,
        requires = "restitution",
        help_heading = DAMPER
    )]
    pub own_mass: Option<f64>,
    /// The same of the other body.
    #[arg(
        long,
        value_name = "KG",
        allow_hyphen_values = true,
        value_parser = kilograms,
        requires = "restitution",
        help_heading = DAMPER
    )]
    pub other_own_mass: Option<f64>,
    /// MuJoCo's α = Â·m̄, Â the sum of both bodies' body_invweight0; taken from the model where one is given.
    #[arg(
        long,
        value_name = "A",
        allow_hyphen_values = true,
        value_parser = plain,
        requires = "restitution",
        help_heading = DAMPER
    )]
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

/// A heading of the help: where the effective mass is from.
const FROM: &str = "Effective mass";
/// A heading of the help.
const OUTPUT: &str = "Output";

/// Flags of `percuss damp`.
#[derive(Debug, Args)]
pub struct DampArgs {
    /// The effective mass (kg).
    #[arg(
        long,
        value_name = "KG",
        allow_hyphen_values = true,
        value_parser = plain_kilograms,
        conflicts_with = "mass_from",
        help_heading = FROM
    )]
    pub mass: Option<f64>,
    /// Or from a contact of this model.
    ///
    /// With the flags of `percuss mass`.
    #[arg(long, value_name = "MODEL", help_heading = FROM)]
    pub mass_from: Option<String>,
    /// Or of the stop of a joint of it.
    ///
    /// In place of a contact, with the inertia that the joint feels through the loops: the joint where --set has it, or at an
    /// end of its range. With --for mujoco, ode, newton, physx.
    #[arg(
        long,
        value_name = "JOINT[:lower|:upper]",
        value_parser = joint_stop,
        requires = "mass_from",
        help_heading = FROM,
        conflicts_with_all = ["link", "point", "normal", "along_line", "against", "against_mass"]
    )]
    pub limit: Option<JointStop>,
    #[command(flatten)]
    pub reading: ReadingArgs,
    #[command(flatten)]
    pub damping: DampingArgs,
    /// Lists the laws and ends.
    #[arg(long, exclusive = true, help_heading = "Lists")]
    pub list_laws: bool,
    /// Lists the simulators and ends.
    #[arg(long, exclusive = true, help_heading = "Lists")]
    pub list_tools: bool,
    /// Force over time: .svg .png .pdf .csv
    ///
    /// And over penetration: a figure, or as CSV its numbers.
    #[arg(long, short, value_name = "FILE", requires = "speed", help_heading = OUTPUT)]
    pub output: Option<String>,
    #[command(flatten)]
    pub writing: WritingArgs,
    /// How the result is shown.
    #[arg(long, value_enum, default_value_t = CheckFormat::Text, help_heading = OUTPUT)]
    pub format: CheckFormat,
    #[command(flatten)]
    pub contact: Option<ContactArgs>,
}

/// Headings of the help.
const LIMIT: &str = "Person and limit";
const WHICH: &str = "Directions, positions";

/// Flags of `percuss safe-speed`.
#[derive(Debug, Args)]
pub struct SafeSpeedArgs {
    /// The URDF file; - reads the standard input.
    #[arg(required_unless_present = "list_regions")]
    pub model: Option<String>,
    #[command(flatten)]
    pub reading: ReadingArgs,
    /// The region of the body; --list-regions shows them.
    ///
    /// That which the robot hits. Without one what is struck does not give way (a person held against a wall; doors, guards),
    /// and --energy or --momentum is the limit.
    #[arg(long, value_name = "NAME", help_heading = LIMIT)]
    pub region: Option<String>,
    /// Greatest force allowed (N), from the standard.
    #[arg(
        long,
        value_name = "F",
        allow_hyphen_values = true,
        value_parser = force,
        conflicts_with = "pressure",
        help_heading = LIMIT
    )]
    pub force: Option<f64>,
    /// Greatest pressure (N/cm²), with --area.
    ///
    /// From the standard; N/mm2, MPa may follow the number.
    #[arg(
        long,
        value_name = "P",
        allow_hyphen_values = true,
        value_parser = pressure,
        requires = "area",
        help_heading = LIMIT
    )]
    pub pressure: Option<f64>,
    /// Contact area (cm²; mm2 may follow), for --pressure.
    #[arg(
        long,
        value_name = "A",
        allow_hyphen_values = true,
        value_parser = area,
        requires = "pressure",
        help_heading = LIMIT
    )]
    pub area: Option<f64>,
    /// Greatest energy of the impact (J): 1/2 μ v².
    ///
    /// From the standard; without a region that of all that comes to the contact.
    #[arg(
        long,
        value_name = "E",
        allow_hyphen_values = true,
        value_parser = energy,
        conflicts_with_all = ["force", "pressure", "momentum"],
        help_heading = LIMIT
    )]
    pub energy: Option<f64>,
    /// Greatest momentum that is exchanged (N·s): μ v.
    ///
    /// From the standard.
    #[arg(
        long,
        value_name = "P",
        allow_hyphen_values = true,
        value_parser = momentum,
        conflicts_with_all = ["force", "pressure"],
        help_heading = LIMIT
    )]
    pub momentum: Option<f64>,
    /// Directions (world) for --normal; slowest counts.
    ///
    /// In world axes, in the place of --normal; once for each. The slowest counts.
    #[arg(
        long,
        value_name = "X,Y,Z",
        allow_hyphen_values = true,
        value_parser = normal,
        conflicts_with_all = ["normal", "along_line"],
        help_heading = WHICH
    )]
    pub direction: Vec<[f64; 3]>,
    /// Or the one in which it is heaviest.
    ///
    /// The direction in which the contact is heaviest, in the place of --normal.
    #[arg(long, conflicts_with_all = ["normal", "along_line"], help_heading = WHICH)]
    pub worst_direction: bool,
    /// Positions; the slowest row counts.
    ///
    /// A file of positions, as that of percuss sweep: the slowest of its rows counts.
    #[arg(
        long,
        value_name = "FILE.csv|.parquet",
        conflicts_with_all = ["direction", "worst_direction"],
        help_heading = WHICH
    )]
    pub input: Option<String>,
    /// Leaves a column of --input out.
    #[arg(long, value_name = "COLUMN", requires = "input", help_heading = WHICH)]
    pub ignore: Vec<String>,
    /// Load that the model does not hold (kg).
    ///
    /// With its tool: a point mass at the contact, and m_L of M/2 + m_L.
    #[arg(
        long,
        default_value = "0",
        value_name = "KG",
        allow_hyphen_values = true,
        value_parser = plain_kilograms,
        help_heading = LIMIT
    )]
    pub load: f64,
    /// Lists the regions and ends.
    #[arg(long, exclusive = true, help_heading = LIMIT)]
    pub list_regions: bool,
    /// How the result is shown.
    #[arg(long, value_enum, default_value_t = CheckFormat::Text, help_heading = OUTPUT)]
    pub format: CheckFormat,
    #[command(flatten)]
    pub contact: Option<ContactArgs>,
}
