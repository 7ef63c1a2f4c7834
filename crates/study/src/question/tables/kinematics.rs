//! Question about the kinematics of a suspension: wheel angles, motion ratios and rates over a travel.

use crate::question::errors::refusal::InvalidKey;
use crate::question::mass_question::MassQuestion;
#[cfg(feature = "flags")]
use crate::question::tables::headings::VEHICLE;
use crate::question::travel::given_travel::{GivenTravel, GivenTravelError};
use crate::question::travel::moved::{Moved, WheelMotion};
use crate::question::travel::vary::{Vary, VaryError};
use crate::values::quantities::{Length, PositiveMass, Ratio, Speed, Stiffness};
use crate::values::value::{NumberOrText, path_in};
use percuss_mechanism::JointKind;
use percuss_suspension::kinematics::{ComplianceLoads, LoadedWheels, RACK, Vehicle};
use percuss_units::{Dimension, Quantity};
use schemars::JsonSchema;
use serde::de::Error;
use serde::{Deserialize, Deserializer};
use std::collections::BTreeMap;
use std::path::Path;

/// Variable of the state of a suspension.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum KinematicVariable {
    /// Travel of the wheel centres, m.
    Wheels(WheelMotion),
    /// Position of the rack, m.
    Steer,
}

impl KinematicVariable {
    /// Name of the flag and of the column.
    pub fn name(self) -> &'static str {
        match self {
            KinematicVariable::Wheels(motion) => motion.name(),
            KinematicVariable::Steer => "steer",
        }
    }

    /// Reads a length, m.
    ///
    /// # Errors
    /// [`GivenTravelError`]: no length, or a travel of the wheel that no suspension has.
    pub fn length(self, text: &str) -> Result<f64, GivenTravelError> {
        match self {
            KinematicVariable::Wheels(motion) => {
                Ok(GivenTravel::parse(&format!("{}={text}", motion.name()))?.distance)
            }
            KinematicVariable::Steer => Ok(Quantity::parse(text)?.in_dimension(Dimension::Length, text)?),
        }
    }

    /// Reads a range `FROM:TO:COUNT` of lengths, m.
    ///
    /// # Errors
    /// [`VaryError`]: missing parts, a count out of range, an invalid length.
    pub fn range(self, text: &str) -> Result<Vec<f64>, VaryError> {
        let values = Vary::parse(&format!("{}={text}", self.name()))?.values(Dimension::Length)?;
        Ok((0..values.count).map(|i| values.value_at(i)).collect())
    }
}

/// Position of the axle in the vehicle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::ValueEnum))]
#[serde(rename_all = "lowercase")]
pub enum AxlePosition {
    /// Front axle.
    Front,
    /// Rear axle.
    Rear,
}

/// Data of the vehicle that no suspension sheet contains.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::Args), command(next_help_heading = VEHICLE))]
#[serde(deny_unknown_fields, default)]
pub struct VehicleData {
    /// Position of the axle: front, rear.
    #[cfg_attr(feature = "flags", arg(long, value_name = "AXLE", value_enum))]
    pub axle: Option<AxlePosition>,
    /// Share of the front axle in the braking force: 0.6, 60%.
    #[cfg_attr(feature = "flags", arg(long, value_name = "SHARE"))]
    pub brake_bias: Option<Ratio>,
    /// Share of this axle in the driving force: 1, 40%.
    #[cfg_attr(feature = "flags", arg(long, value_name = "SHARE"))]
    pub drive_share: Option<Ratio>,
    /// Height of the vehicle's centre of mass above the ground.
    #[cfg_attr(feature = "flags", arg(long, value_name = "LENGTH"))]
    pub cg_height: Option<Length>,
    /// Distance of the axles.
    #[cfg_attr(feature = "flags", arg(long, value_name = "LENGTH"))]
    pub wheelbase: Option<Length>,
    /// The brakes are on the vehicle body: the braking force acts at the wheel centre.
    #[cfg_attr(feature = "flags", arg(long))]
    pub inboard_brakes: bool,
    /// The driving torque comes from the vehicle body by a shaft: the driving force acts at the wheel centre.
    #[cfg_attr(feature = "flags", arg(long))]
    pub inboard_drive: bool,
    /// Sprung mass above one wheel (kg), for the natural frequencies.
    #[cfg_attr(feature = "flags", arg(long, value_name = "KG"))]
    pub sprung_mass: Option<PositiveMass>,
    /// Vertical rate of the tyre, with its unit: 200N/mm; without it, the tyre is rigid.
    #[cfg_attr(feature = "flags", arg(long, value_name = "RATE"))]
    pub tyre_rate: Option<Stiffness>,
    /// Motion of the wheels per load, with the bushes of the sheet: loads on a single wheel, parallel or opposed on both; default: single.
    #[cfg_attr(feature = "flags", arg(long, value_name = "WHEELS", value_enum, num_args = 0..=1, default_missing_value = "single"))]
    pub compliance: Option<WheelLoads>,
    /// With the compliance, the heights of the wheel centres are held; without this, the springs hold the wheels.
    #[cfg_attr(feature = "flags", arg(long, requires = "compliance"))]
    pub travel_held: bool,
}

/// Wheels on which a load of the compliance acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::ValueEnum))]
#[serde(rename_all = "lowercase")]
pub enum WheelLoads {
    /// The wheel of the quantity alone.
    Single,
    /// Both wheels, the same load.
    Parallel,
    /// Both wheels, opposite loads.
    Opposed,
}

/// Camber, toe, motion ratios and further quantities of a suspension over a travel: percuss kinematics.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct KinematicsQuestion {
    /// Range of the travel: wheel-travel=FROM:TO:COUNT, or heave, roll, steer.
    #[serde(rename = "vary", deserialize_with = "range")]
    #[schemars(with = "String")]
    pub range: Option<(KinematicVariable, Vec<f64>)>,
    /// Quantities, such as camber, toe, bump_stop.motion_ratio; default: all in a table, the usual ones in a figure.
    pub columns: Vec<String>,
    /// Output file: .csv, .xlsx, .parquet, .json, .txt, .svg, .png or .pdf.
    pub output: Option<String>,
    /// Data of the vehicle, for anti-dive, rates and frequencies: axle, brake_bias, drive_share, cg_height, wheelbase, sprung_mass, tyre_rate,
    /// inboard_brakes, inboard_drive; and loads for the bushes: compliance, travel_held.
    pub vehicle: VehicleData,
    /// Variables with one value for all rows, m.
    #[serde(skip)]
    pub state: Vec<(KinematicVariable, f64)>,
}

/// Search for coordinates, masses, stop curves and dampers of a suspension that give quantities required values: percuss kinematics --solve. The pose is
/// that of the study, the data of the vehicle are those of `[kinematics]`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TargetsQuestion {
    /// Unknowns: POINT.AXIS, LINK.mass, CONTACT.curve or CONTACT.damping.
    pub solve: Vec<String>,
    /// Required values by quantity, as many as unknowns: "bump_stop.peak_force" = "6 kN".
    pub values: BTreeMap<String, NumberOrText>,
    /// Largest change of each coordinate; default: 20 mm.
    pub within: Option<Length>,
    /// Closing speed of the contacts, for peak_force, compression and restitution.
    pub speed: Option<Speed>,
    /// Restitution at this speed, for the damping without springs, dampers and tyre; default: 1, no damping.
    pub restitution: Option<Ratio>,
    /// Stiffness of the contacts in place of the curve of the sheet.
    pub stiffness: Option<Stiffness>,
    /// Question at the pose of the study.
    #[serde(skip)]
    pub question: KinematicsQuestion,
}

impl VehicleData {
    /// Data as plain numbers.
    pub(crate) fn vehicle(&self) -> Vehicle {
        Vehicle {
            is_front: self.axle.map(|axle| axle == AxlePosition::Front),
            brake_bias: self.brake_bias.map(|Ratio(bias)| bias),
            drive_share: self.drive_share.map(|Ratio(share)| share),
            cg_height: self.cg_height.map(|Length(height)| height),
            wheelbase: self.wheelbase.map(|Length(length)| length),
            inboard_brakes: self.inboard_brakes,
            inboard_drive: self.inboard_drive,
            sprung_mass: self.sprung_mass.map(|mass| mass.0),
            tyre_rate: self.tyre_rate.map(|rate| rate.0.value),
            loads: self.compliance.map(|loaded| ComplianceLoads {
                wheels: match loaded {
                    WheelLoads::Single => LoadedWheels::Single,
                    WheelLoads::Parallel => LoadedWheels::Parallel,
                    WheelLoads::Opposed => LoadedWheels::Opposed,
                },
                travel_held: self.travel_held,
            }),
        }
    }

    /// Checks the numbers.
    ///
    /// # Errors
    /// [`InvalidKey`]: a length or a rate of at most 0, a share outside 0 to 1.
    pub fn check(&self) -> Result<(), InvalidKey> {
        if self.travel_held && self.compliance.is_none() {
            let why =
                "it belongs to the compliance; give compliance = \"single\", \"parallel\" or \"opposed\" too";
            return Err(InvalidKey::new("kinematics.vehicle.travel_held", why));
        }
        let shares = [
            ("kinematics.vehicle.brake_bias", self.brake_bias),
            ("kinematics.vehicle.drive_share", self.drive_share),
        ];
        for (key, share) in shares {
            if let Some(Ratio(x)) = share.filter(|Ratio(x)| !(0.0..=1.0).contains(x)) {
                return Err(InvalidKey::new(key, format!("{x}; a share between 0 and 1 is expected")));
            }
        }
        let positive = [
            ("kinematics.vehicle.cg_height", self.cg_height.map(|Length(x)| x)),
            ("kinematics.vehicle.wheelbase", self.wheelbase.map(|Length(x)| x)),
            ("kinematics.vehicle.tyre_rate", self.tyre_rate.map(|Stiffness(rate)| rate.value)),
        ];
        for (key, value) in positive {
            if let Some(x) = value.filter(|x| !(x.is_finite() && *x > 0.0)) {
                return Err(InvalidKey::new(key, format!("{x}; more than 0 is expected")));
            }
        }
        Ok(())
    }
}

/// Forms of the range of the travel, for messages.
const RANGES: &str = "expected wheel-travel=FROM:TO:COUNT, or heave, roll or steer in its place";

/// Reads the range of the travel.
fn range<'de, D: Deserializer<'de>>(from: D) -> Result<Option<(KinematicVariable, Vec<f64>)>, D::Error> {
    let text = String::deserialize(from)?;
    let (name, range) = text.split_once('=').ok_or_else(|| D::Error::custom(RANGES))?;
    let variable = match (name.trim(), WheelMotion::from_name(name.trim())) {
        ("steer", _) => KinematicVariable::Steer,
        (_, Some(motion)) => KinematicVariable::Wheels(motion),
        (_, None) => return Err(D::Error::custom(RANGES)),
    };
    Ok(Some((variable, variable.range(range).map_err(D::Error::custom)?)))
}

impl KinematicsQuestion {
    /// Question with checked keys, with the travels of the wheels and the position of the rack of `pose`, apart from the motion that the
    /// rows vary. Paths are relative to `folder`.
    ///
    /// # Errors
    /// [`InvalidKey`]: no range, or invalid data of the vehicle.
    pub(crate) fn checked(&self, pose: &MassQuestion, folder: &Path) -> Result<Self, InvalidKey> {
        let Some((varied, _)) = self.range else { return Err(InvalidKey::new("kinematics.vary", RANGES)) };
        self.vehicle.check()?;
        let mut question = self.clone();
        question.output = self.output.as_ref().map(|output| path_in(folder, output));
        question.set_state(pose, Some(varied));
        Ok(question)
    }

    /// Sets the travels of the wheels and the position of the rack of a pose, apart from the variable of the rows.
    pub(crate) fn set_state(&mut self, pose: &MassQuestion, varied: Option<KinematicVariable>) {
        for travel in &pose.pose.travel {
            let Moved::Wheels(motion) = travel.moved else { continue };
            let is_beside = match varied {
                Some(KinematicVariable::Wheels(varied)) => travel.moved.is_beside(&Moved::Wheels(varied)),
                Some(KinematicVariable::Steer) | None => true,
            };
            if is_beside {
                self.state.push((KinematicVariable::Wheels(motion), travel.distance));
            }
        }
        let rack = pose.pose.set.iter().find(|(joint, _)| joint == RACK);
        let at = rack.and_then(|(_, position)| position.values_for_joint(JointKind::Prismatic).ok());
        if let Some(&[at]) = at.as_deref().filter(|_| varied != Some(KinematicVariable::Steer)) {
            self.state.push((KinematicVariable::Steer, at));
        }
    }

    /// True if the rack moves.
    pub(crate) fn steers(&self) -> bool {
        let variables = self.state.iter().map(|(variable, _)| *variable);
        variables
            .chain(self.range.iter().map(|(variable, _)| *variable))
            .any(|v| v == KinematicVariable::Steer)
    }
}
