//! Kinematics table of a study file: wheel angles, motion ratios and rates of a suspension over a travel.

use crate::model::loading::Model;
use crate::model::wheel_points::RACK;
use crate::question::errors::refusal::InvalidKey;
use crate::question::mass_question::MassQuestion;
#[cfg(feature = "flags")]
use crate::question::tables::headings::VEHICLE;
use crate::question::travel::moved::{Moved, WheelMotion};
use crate::reports::kinematics::question::{
    AxlePosition, KinematicVariable, KinematicsError, KinematicsQuestion, TorqueReaction, VehicleData,
};
use crate::reports::kinematics::report::{KinematicsReport, kinematics};
use crate::values::quantities::{Length, PositiveMass, Ratio, Stiffness};
use percuss_mechanism::JointKind;
use schemars::JsonSchema;
use serde::Deserialize;
use std::path::Path;

/// Data of the vehicle that no suspension sheet contains.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::Args))]
#[serde(deny_unknown_fields, default)]
pub struct VehicleTable {
    /// Position of the axle: front, rear.
    #[cfg_attr(feature = "flags", arg(long, value_name = "AXLE", value_enum, help_heading = VEHICLE))]
    pub axle: Option<AxlePosition>,
    /// Share of the front axle in the braking force: 0.6, 60%.
    #[cfg_attr(feature = "flags", arg(long, value_name = "SHARE", help_heading = VEHICLE))]
    pub brake_bias: Option<Ratio>,
    /// Share of this axle in the driving force: 1, 40%.
    #[cfg_attr(feature = "flags", arg(long, value_name = "SHARE", help_heading = VEHICLE))]
    pub drive_share: Option<Ratio>,
    /// Height of the vehicle's centre of mass above the ground.
    #[cfg_attr(feature = "flags", arg(long, value_name = "LENGTH", help_heading = VEHICLE))]
    pub cg_height: Option<Length>,
    /// Distance of the axles.
    #[cfg_attr(feature = "flags", arg(long, value_name = "LENGTH", help_heading = VEHICLE))]
    pub wheelbase: Option<Length>,
    /// The brakes are on the vehicle body: the braking force acts at the wheel centre.
    #[cfg_attr(feature = "flags", arg(long, help_heading = VEHICLE))]
    pub inboard_brakes: bool,
    /// The driving torque comes from the vehicle body by a shaft: the driving force acts at the wheel centre.
    #[cfg_attr(feature = "flags", arg(long, help_heading = VEHICLE))]
    pub inboard_drive: bool,
    /// Sprung mass above one wheel (kg), for the natural frequencies.
    #[cfg_attr(feature = "flags", arg(long, value_name = "KG", help_heading = VEHICLE))]
    pub sprung_mass: Option<PositiveMass>,
    /// Vertical rate of the tyre, with its unit: 200N/mm; without it, the tyre is rigid.
    #[cfg_attr(feature = "flags", arg(long, value_name = "RATE", help_heading = VEHICLE))]
    pub tyre_rate: Option<Stiffness>,
}

impl VehicleTable {
    /// Converts the table.
    ///
    /// # Errors
    /// Key of a study and the reason: a length or a rate of at most 0, a share outside 0 to 1.
    pub fn data(&self) -> Result<VehicleData, (&'static str, String)> {
        let reaction = |inboard| if inboard { TorqueReaction::Inboard } else { TorqueReaction::Outboard };
        let positive = |name: &'static str, value: Option<f64>| match value {
            Some(x) if !(x.is_finite() && x > 0.0) => Err((name, format!("{x}; more than 0 is expected"))),
            value => Ok(value),
        };
        let share = |name: &'static str, value: Option<Ratio>| match value {
            Some(Ratio(x)) if !(0.0..=1.0).contains(&x) => {
                Err((name, format!("{x}; a share between 0 and 1 is expected")))
            }
            value => Ok(value.map(|Ratio(x)| x)),
        };
        Ok(VehicleData {
            axle: self.axle,
            brake_bias: share("kinematics.vehicle.brake_bias", self.brake_bias)?,
            drive_share: share("kinematics.vehicle.drive_share", self.drive_share)?,
            cg_height: positive("kinematics.vehicle.cg_height", self.cg_height.map(|Length(x)| x))?,
            wheelbase: positive("kinematics.vehicle.wheelbase", self.wheelbase.map(|Length(x)| x))?,
            brakes: reaction(self.inboard_brakes),
            drive: reaction(self.inboard_drive),
            sprung_mass: self.sprung_mass.map(|PositiveMass(mass)| mass),
            tyre_rate: positive(
                "kinematics.vehicle.tyre_rate",
                self.tyre_rate.map(|Stiffness(rate)| rate.value),
            )?,
        })
    }
}

/// Camber, toe, motion ratios and further quantities of a suspension over a travel: percuss kinematics.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct KinematicsTable {
    /// Range of the travel: wheel-travel=FROM:TO:COUNT, or heave, roll, steer.
    pub vary: String,
    /// Quantities, such as camber, toe, bump_stop.motion_ratio; default: all in a table, the usual ones in a figure.
    pub columns: Vec<String>,
    /// Output file: .csv, .json, .txt, .svg, .png or .pdf.
    pub output: Option<String>,
    /// Data of the vehicle, for anti-dive, rates and frequencies: axle, brake_bias, drive_share, cg_height, wheelbase, sprung_mass, tyre_rate,
    /// inboard_brakes, inboard_drive.
    pub vehicle: VehicleTable,
}

/// Kinematics requested by a study.
#[derive(Clone, Debug)]
pub struct StudyKinematics {
    /// Range of the travel.
    pub question: KinematicsQuestion,
    /// Selected quantities. Empty: all quantities in a table, camber, toe and the other usual ones in a figure.
    pub columns: Vec<String>,
    /// Output file.
    pub output: Option<String>,
}

impl KinematicsTable {
    /// Converts the table; `folder`: folder of the study.
    pub fn kinematics(&self, folder: &Path) -> Result<StudyKinematics, InvalidKey> {
        let refuse = |why: String| InvalidKey::new("kinematics.vary", why);
        let expected = "expected wheel-travel=FROM:TO:COUNT, or heave, roll or steer in its place";
        let (name, range) = self.vary.split_once('=').ok_or_else(|| refuse(expected.to_owned()))?;
        let variable = match (name.trim(), WheelMotion::from_name(name.trim())) {
            ("steer", _) => KinematicVariable::Steer,
            (_, Some(motion)) => KinematicVariable::Wheels(motion),
            (_, None) => return Err(refuse(expected.to_owned())),
        };
        let values = variable.range(range).map_err(|error| refuse(error.to_string()))?;
        let vehicle = self.vehicle.data();
        let vehicle = vehicle.map_err(|(key, why)| InvalidKey::new(key, why))?;
        let range = Some((variable, values));
        Ok(StudyKinematics {
            question: KinematicsQuestion { range, vehicle, ..KinematicsQuestion::default() },
            columns: self.columns.clone(),
            output: self.output.as_ref().map(|output| folder.join(output).to_string_lossy().into_owned()),
        })
    }
}

impl StudyKinematics {
    /// Adds the travels of the wheels and the position of the rack of a pose, apart from the motion that the rows vary.
    pub(crate) fn add_pose(&mut self, pose: &MassQuestion) {
        let varied = self.question.range.as_ref().map(|(variable, _)| *variable);
        for travel in &pose.travel {
            let Moved::Wheels(motion) = travel.moved else { continue };
            let is_beside = match varied {
                Some(KinematicVariable::Wheels(varied)) => travel.moved.is_beside(&Moved::Wheels(varied)),
                Some(KinematicVariable::Steer) | None => true,
            };
            if is_beside {
                self.question.state.push((KinematicVariable::Wheels(motion), travel.distance));
            }
        }
        let rack = pose.set.iter().find(|(joint, _)| joint == RACK);
        let at = rack.and_then(|(_, position)| position.values_for_joint(JointKind::Prismatic).ok());
        if let Some(&[at]) = at.as_deref().filter(|_| varied != Some(KinematicVariable::Steer)) {
            self.question.state.push((KinematicVariable::Steer, at));
        }
    }

    /// Evaluates the quantities of the table.
    ///
    /// # Errors
    /// As [`kinematics`]; an unknown quantity.
    pub fn report(&self, model: &Model) -> Result<KinematicsReport, KinematicsError> {
        kinematics(model, &self.question)?.with_columns(&self.columns)
    }
}
