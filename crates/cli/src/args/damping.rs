//! Flags of the damper of a contact, of `percuss damp` and of `percuss safe-speed`.

use super::contact::ContactArgs;
use super::format::CheckFormat;
use super::model::ReadingArgs;
use super::value_parsers::{
    Tools, area, energy, force, joint_stop, kilograms, law, momentum, normal, plain_kilograms, plain_number,
    pressure, ratio, speed, stiffness, time, tools,
};
use super::writing::WritingArgs;
use crate::terminal::failure::Failure;
use clap::{Args, ValueEnum};
use percuss_study::contact::Separation;
use percuss_study::contact::exports::Options;
use percuss_study::{DampingQuestion, JointStop, Quantity, StudyError, check_units};

/// Heading in the help.
const DAMPER: &str = "Damper";

/// Flags of the damper, shared by `percuss damp` and `percuss mass`.
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
    /// Units: N/m, N/mm, kN/m, kN/mm; with --exponent p the number is in N/m^p. The stop of a revolute joint has
    /// N·m/rad (Nm/rad, Nm/deg).
    #[arg(
        long,
        value_name = "K",
        allow_hyphen_values = true,
        value_parser = stiffness,
        requires = "restitution",
        help_heading = DAMPER
    )]
    pub stiffness: Option<Quantity>,
    /// Exponent p of the spring force k x^p.
    ///
    /// 1 is a linear spring (the default), 1.5 a Hertz contact.
    #[arg(
        long,
        value_name = "P",
        allow_hyphen_values = true,
        value_parser = plain_number,
        requires = "restitution",
        help_heading = DAMPER
    )]
    pub exponent: Option<f64>,
    /// Approach speed (m/s): penetration, force, energy.
    ///
    /// Adds penetration, force and energy to the result. Units: m/s, mm/s, km/h; for the stop of a revolute joint
    /// rad/s, deg/s. Some laws depend on the speed.
    #[arg(
        long,
        value_name = "V",
        allow_hyphen_values = true,
        value_parser = speed,
        requires = "restitution",
        help_heading = DAMPER
    )]
    pub speed: Option<Quantity>,
    /// Law of the damper (damp --list-laws).
    ///
    /// `percuss damp --list-laws` lists the laws.
    #[arg(
        long,
        default_value = "kelvin-voigt",
        value_name = "NAME",
        value_parser = law,
        requires = "restitution",
        help_heading = DAMPER
    )]
    pub law: String,
    /// End of the contact: when the force vanishes (the default), or when the gap closes (the damper then pulls at
    /// the end).
    #[arg(long, value_enum, requires = "restitution", help_heading = DAMPER)]
    pub separation: Option<SeparationArg>,
    /// Parameters for one simulator, or for all.
    ///
    /// mujoco, drake, gazebo, gazebo-classic, ode, bullet, physx, rapier, chrono, adams, simscape, dart, opensim,
    /// exudyn, newton, jolt, or all; separate several names by commas.
    #[arg(
        long = "for",
        value_name = "TOOL",
        value_parser = tools,
        value_delimiter = ',',
        requires = "restitution",
        help_heading = DAMPER
    )]
    pub tools: Vec<Tools>,
    /// Permitted error of the simulator's restitution; determines the time step.
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
    /// Time step of the simulator (s, ms); default: the step that --accuracy requires.
    #[arg(
        long,
        value_name = "S",
        allow_hyphen_values = true,
        value_parser = time,
        requires = "restitution",
        help_heading = DAMPER
    )]
    pub time_step: Option<f64>,
    /// Mass (kg) of the contact link alone, for simulators that need it; default: from the model, if any.
    #[arg(
        long,
        value_name = "KG",
        allow_hyphen_values = true,
        value_parser = kilograms,
        requires = "restitution",
        help_heading = DAMPER
    )]
    pub own_mass: Option<f64>,
    /// Mass (kg) of the other body alone, as --own-mass.
    #[arg(
        long,
        value_name = "KG",
        allow_hyphen_values = true,
        value_parser = kilograms,
        requires = "restitution",
        help_heading = DAMPER
    )]
    pub other_own_mass: Option<f64>,
    /// MuJoCo's α = Â·m̄; Â is the sum of body_invweight0 of both bodies. Default: from the model, if any.
    #[arg(
        long,
        value_name = "A",
        allow_hyphen_values = true,
        value_parser = plain_number,
        requires = "restitution",
        help_heading = DAMPER
    )]
    pub diagonal_ratio: Option<f64>,
}

/// End of a contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum SeparationArg {
    /// When the force vanishes.
    Force,
    /// When the gap closes.
    Gap,
}

impl DampingArgs {
    /// Converts the flags to a question; `None` without --restitution.
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
    /// Refuses rotational units for a translation, and translational units for a rotation.
    pub fn check_units(&self, question: &DampingQuestion, turns: bool) -> Result<(), Failure> {
        let Some(stiffness) = self.stiffness else { return Ok(()) };
        Ok(check_units(question, stiffness, self.speed, turns)?)
    }
}

/// Heading in the help: source of the effective mass.
const FROM: &str = "Effective mass";
/// Heading in the help.
const OUTPUT: &str = "Output";

/// Flags of `percuss damp`.
#[derive(Debug, Args)]
pub struct DampArgs {
    /// Effective mass (kg).
    #[arg(
        long,
        value_name = "KG",
        allow_hyphen_values = true,
        value_parser = plain_kilograms,
        conflicts_with = "mass_from",
        help_heading = FROM
    )]
    pub mass: Option<f64>,
    /// Effective mass at a contact of this model.
    ///
    /// The flags of `percuss mass` define the contact.
    #[arg(long, value_name = "MODEL", help_heading = FROM)]
    pub mass_from: Option<String>,
    /// Stop of a joint of the model, not a contact.
    ///
    /// The damper uses the effective inertia at the joint, loops included. The joint is at its --set position, or at
    /// its lower or upper limit. --for supports mujoco, ode, newton and physx.
    #[arg(
        long,
        value_name = "JOINT[:lower|:upper]",
        value_parser = joint_stop,
        requires = "mass_from",
        help_heading = FROM,
        conflicts_with_all = ["at", "link", "point", "normal", "along_line", "against", "against_mass"]
    )]
    pub limit: Option<JointStop>,
    #[command(flatten)]
    pub reading: ReadingArgs,
    #[command(flatten)]
    pub damping: DampingArgs,
    /// List the laws and exit.
    #[arg(long, exclusive = true, help_heading = "Lists")]
    pub list_laws: bool,
    /// List the simulators and exit.
    #[arg(long, exclusive = true, help_heading = "Lists")]
    pub list_tools: bool,
    /// Force over time: .svg .png .pdf .csv
    ///
    /// The figure shows the force over time and over penetration; CSV contains its numbers.
    #[arg(long, short, value_name = "FILE", requires = "speed", help_heading = OUTPUT)]
    pub output: Option<String>,
    #[command(flatten)]
    pub writing: WritingArgs,
    /// Format of the result.
    #[arg(long, value_enum, default_value_t = CheckFormat::Text, help_heading = OUTPUT)]
    pub format: CheckFormat,
    #[command(flatten)]
    pub contact: Option<ContactArgs>,
}

/// Headings in the help.
const LIMIT: &str = "Person and limit";
const WHICH: &str = "Directions, positions";

/// Flags of `percuss safe-speed`.
#[derive(Debug, Args)]
pub struct SafeSpeedArgs {
    /// URDF file; - reads the standard input.
    #[arg(required_unless_present = "list_regions")]
    pub model: Option<String>,
    #[command(flatten)]
    pub reading: ReadingArgs,
    /// Region of the body; --list-regions shows all.
    ///
    /// The robot hits this region. Without a region, the other side is rigid and fixed (a person held against a wall;
    /// doors, guards), and --energy or --momentum is the limit.
    #[arg(long, value_name = "NAME", help_heading = LIMIT)]
    pub region: Option<String>,
    /// Largest permitted force (N), from the standard.
    #[arg(
        long,
        value_name = "F",
        allow_hyphen_values = true,
        value_parser = force,
        conflicts_with = "pressure",
        help_heading = LIMIT
    )]
    pub force: Option<f64>,
    /// Largest pressure (N/cm²), with --area.
    ///
    /// The value is given by the standard. Units: N/cm2, N/mm2, MPa.
    #[arg(
        long,
        value_name = "P",
        allow_hyphen_values = true,
        value_parser = pressure,
        requires = "area",
        help_heading = LIMIT
    )]
    pub pressure: Option<f64>,
    /// Contact area (cm², mm2), for --pressure.
    #[arg(
        long,
        value_name = "A",
        allow_hyphen_values = true,
        value_parser = area,
        requires = "pressure",
        help_heading = LIMIT
    )]
    pub area: Option<f64>,
    /// Largest energy of the impact (J): 1/2 μ v².
    ///
    /// The value is given by the standard. Without a region, μ is the effective mass of the robot.
    #[arg(
        long,
        value_name = "E",
        allow_hyphen_values = true,
        value_parser = energy,
        conflicts_with_all = ["force", "pressure", "momentum"],
        help_heading = LIMIT
    )]
    pub energy: Option<f64>,
    /// Largest exchanged momentum (N·s): μ v.
    ///
    /// The value is given by the standard.
    #[arg(
        long,
        value_name = "P",
        allow_hyphen_values = true,
        value_parser = momentum,
        conflicts_with_all = ["force", "pressure"],
        help_heading = LIMIT
    )]
    pub momentum: Option<f64>,
    /// Directions (world axes); the slowest counts.
    ///
    /// Replaces --normal. Give the flag once for each direction; the lowest speed is the result.
    #[arg(
        long,
        value_name = "X,Y,Z",
        allow_hyphen_values = true,
        value_parser = normal,
        conflicts_with_all = ["normal", "along_line"],
        help_heading = WHICH
    )]
    pub direction: Vec<[f64; 3]>,
    /// Direction with the largest effective mass.
    ///
    /// Replaces --normal.
    #[arg(long, conflicts_with_all = ["normal", "along_line"], help_heading = WHICH)]
    pub worst_direction: bool,
    /// File of positions; the slowest row counts.
    ///
    /// The format is that of percuss sweep --input. The row with the lowest speed is the result.
    #[arg(
        long,
        value_name = "FILE.csv|.parquet",
        conflicts_with_all = ["direction", "worst_direction"],
        help_heading = WHICH
    )]
    pub input: Option<String>,
    /// Ignore a column of --input.
    #[arg(long, value_name = "COLUMN", requires = "input", help_heading = WHICH)]
    pub ignore: Vec<String>,
    /// Load that is missing in the model (kg).
    ///
    /// Load and tool: a point mass at the contact, and m_L in the standard's M/2 + m_L.
    #[arg(
        long,
        default_value = "0",
        value_name = "KG",
        allow_hyphen_values = true,
        value_parser = plain_kilograms,
        help_heading = LIMIT
    )]
    pub load: f64,
    /// List the regions and exit.
    #[arg(long, exclusive = true, help_heading = LIMIT)]
    pub list_regions: bool,
    /// Format of the result.
    #[arg(long, value_enum, default_value_t = CheckFormat::Text, help_heading = OUTPUT)]
    pub format: CheckFormat,
    #[command(flatten)]
    pub contact: Option<ContactArgs>,
}
