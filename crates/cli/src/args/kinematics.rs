//! Flags of `percuss kinematics`.

use crate::args::model::ModelArgs;
use crate::args::output::{KinematicsFormat, WritingArgs};
use crate::terminal::failure::Failure;
use clap::Args;
use percuss_study::headings::{ANSWER, OUTPUT, POSE};
use percuss_study::{
    DampingQuestion, KinematicTarget, KinematicVariable, KinematicsQuestion, Length, Ratio, SearchUnknown,
    Speed, Stiffness, TargetSearch, VehicleData, WheelMotion,
};

/// Heading of the search for coordinates.
const SEARCH: &str = "Search";
/// Flags of `percuss kinematics`.
#[derive(Debug, Args)]
pub struct KinematicsArgs {
    #[command(flatten)]
    pub model: ModelArgs,
    /// Upward travel of the wheel: a length, or FROM:TO:COUNT for rows.
    #[arg(long, value_name = "TRAVEL", allow_hyphen_values = true, help_heading = POSE)]
    pub wheel_travel: Option<String>,
    /// Equal upward travel of both wheels.
    #[arg(long, value_name = "TRAVEL", allow_hyphen_values = true, help_heading = POSE)]
    pub heave: Option<String>,
    /// Opposite travel: the left wheel up, the right wheel down.
    ///
    /// With a range, all derivatives (gradients, motion ratios, rates) are those of roll, per travel of the own wheel.
    #[arg(long, value_name = "TRAVEL", allow_hyphen_values = true, help_heading = POSE)]
    pub roll: Option<String>,
    /// Displacement of the rack to the left.
    #[arg(long, value_name = "TRAVEL", allow_hyphen_values = true, help_heading = POSE)]
    pub steer: Option<String>,
    #[command(flatten)]
    pub vehicle: VehicleData,
    /// Search a coordinate, a mass, a curve or a damper: rocker_back.z, upright.mass, bump_stop.curve.
    ///
    /// POINT.AXIS: x, y or z in the axes of the sheet. LINK.mass: the mass of a link, by at most half; its moments of inertia change in
    /// proportion. CONTACT.curve: factor on the forces of the curve (or on the stiffness) of a stop, and CONTACT.damping: its damping, each between a
    /// quarter and four times; both require --speed.
    #[arg(long, value_name = "POINT.AXIS", requires = "required", help_heading = SEARCH)]
    pub solve: Vec<SearchUnknown>,
    /// Required value of a quantity: spring.motion_ratio=0.75, caster=4deg; as many as --solve.
    ///
    /// A quantity of a spring, damper or stop names it: bump_stop.motion_ratio, bump_stop_left.motion_ratio; the same as the column
    /// motion_ratio_bump_stop. bump_stop.mass is the effective mass at the touch of the stop, and so for every named contact.
    #[arg(long = "for", id = "required", value_name = "QUANTITY=VALUE", requires = "solve", help_heading = SEARCH)]
    pub required: Vec<KinematicTarget>,
    /// Closing speed of the contact, for --for bump_stop.peak_force=4kN, .compression=25mm, .restitution=0.3.
    ///
    /// The impact is that of `percuss damp` on the force curve of the stop in the sheet, or with --stiffness; the restitution is that with the
    /// springs, dampers, tyre and anti-roll bar of the sheet, to first order.
    #[arg(long, value_name = "V", requires = "solve", help_heading = SEARCH)]
    pub speed: Option<Speed>,
    /// Restitution at this speed, for the damping without these forces; default: 1, no damping.
    #[arg(long, value_name = "E", requires = "speed", help_heading = SEARCH)]
    pub restitution: Option<Ratio>,
    /// Stiffness of the contact in place of the curve of the sheet.
    #[arg(long, value_name = "K", requires = "speed", help_heading = SEARCH)]
    pub stiffness: Option<Stiffness>,
    /// Largest change of each coordinate.
    #[arg(long, value_name = "LENGTH", default_value = "20mm", help_heading = SEARCH)]
    pub within: Length,
    /// Quantities of the output: camber,toe,bump_stop.motion_ratio.
    ///
    /// A name without a side stands for both sides; a quantity of a spring, damper or stop names it. Without this flag a table has all
    /// quantities, and a picture camber, toe, half track change, motion ratios, wheel rate and roll centre height.
    #[arg(long, value_name = "QUANTITY,…", value_delimiter = ',', help_heading = ANSWER)]
    pub columns: Vec<String>,
    /// Format; default: by the file's ending, or table.
    #[arg(long, value_enum, help_heading = ANSWER)]
    pub format: Option<KinematicsFormat>,
    /// File: .txt, .csv, .json, .svg, .png or .pdf; with --solve, the changed sheet in the format that was read.
    #[arg(long, short, value_name = "FILE", help_heading = OUTPUT)]
    pub output: Option<String>,
    #[command(flatten)]
    pub writing: WritingArgs,
}

impl KinematicsArgs {
    /// Converts the flags to a question.
    pub fn question(&self) -> Result<KinematicsQuestion, Failure> {
        let given = [
            (KinematicVariable::Steer, &self.steer),
            (KinematicVariable::Wheels(WheelMotion::WheelTravel), &self.wheel_travel),
            (KinematicVariable::Wheels(WheelMotion::Heave), &self.heave),
            (KinematicVariable::Wheels(WheelMotion::Roll), &self.roll),
        ];
        self.vehicle.check()?;
        let (vehicle, columns) = (self.vehicle, self.columns.clone());
        let mut question = KinematicsQuestion { vehicle, columns, ..KinematicsQuestion::default() };
        for (variable, text) in given {
            let Some(text) = text else { continue };
            let name = variable.name();
            let refuse = |why: String| Failure::bad_input(format!("--{name}: {why}"));
            if !text.contains(':') {
                let length = variable.length(text).map_err(|error| refuse(error.to_string()))?;
                question.state.push((variable, length));
            } else if let Some((other, _)) = &question.range {
                return Err(refuse(format!("--{} has a range already; give one length here", other.name())));
            } else {
                let values = variable.range(text).map_err(|error| refuse(error.to_string()))?;
                question.range = Some((variable, values));
            }
        }
        Ok(question)
    }

    /// Search for coordinates, if the flags request one.
    pub fn search(&self) -> Result<Option<TargetSearch>, Failure> {
        let Length(within) = self.within;
        if !(within.is_finite() && within > 0.0) {
            return Err(Failure::bad_input(format!("--within is {within} m; more than 0 is expected")));
        }
        let (unknowns, targets) = (self.solve.clone(), self.required.clone());
        let impact = self.speed.map(|speed| DampingQuestion {
            speed: Some(speed),
            restitution: self.restitution.or(Some(Ratio(1.0))),
            stiffness: self.stiffness,
            ..DampingQuestion::default()
        });
        if let Some(impact) = &impact {
            impact.checked()?;
        }
        let search = TargetSearch { unknowns, targets, within, mass: None, impact };
        Ok((!self.solve.is_empty()).then_some(search))
    }
}
