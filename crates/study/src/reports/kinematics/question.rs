//! Question about the kinematics of a suspension.

use crate::checks::design_variant::DesignError;
use crate::question::errors::question_error::StudyError;
use crate::question::travel::given_travel::{GivenTravel, GivenTravelError};
use crate::question::travel::moved::WheelMotion;
use crate::question::travel::vary::{Vary, VaryError};
use percuss_units::{Dimension, Quantity};
use schemars::JsonSchema;
use serde::Deserialize;

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

/// Part of the vehicle that takes the reaction of a torque about the wheel's axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TorqueReaction {
    /// Wheel carrier (outboard brake, motor in the wheel, live axle): the wheel does not turn relative to it.
    #[default]
    Outboard,
    /// Vehicle body (inboard brake, drive shaft): the force acts at the wheel centre.
    Inboard,
}

/// Data of the vehicle that no suspension sheet contains.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct VehicleData {
    /// Position of the axle.
    pub axle: Option<AxlePosition>,
    /// Share of the front axle in the braking force.
    pub brake_bias: Option<f64>,
    /// Share of this axle in the driving force.
    pub drive_share: Option<f64>,
    /// Height of the centre of mass above the ground, m.
    pub cg_height: Option<f64>,
    /// Wheelbase, m.
    pub wheelbase: Option<f64>,
    /// Reaction of the brake torque.
    pub brakes: TorqueReaction,
    /// Reaction of the driving torque.
    pub drive: TorqueReaction,
    /// Sprung mass above one wheel, kg.
    pub sprung_mass: Option<f64>,
    /// Vertical rate of the tyre, N/m.
    pub tyre_rate: Option<f64>,
}

/// Question about the kinematics of a suspension.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct KinematicsQuestion {
    /// Variables with one value for all rows, m.
    pub state: Vec<(KinematicVariable, f64)>,
    /// Variable of the rows and its values, m; without it, one row.
    pub range: Option<(KinematicVariable, Vec<f64>)>,
    /// Data of the vehicle.
    pub vehicle: VehicleData,
}

impl KinematicsQuestion {
    /// True if the rack moves.
    pub(crate) fn steers(&self) -> bool {
        let variables = self.state.iter().map(|(variable, _)| *variable);
        variables
            .chain(self.range.iter().map(|(variable, _)| *variable))
            .any(|v| v == KinematicVariable::Steer)
    }
}

/// Error of a question about kinematics.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum KinematicsError {
    /// Model without a suspension sheet.
    #[error(
        "\"{path}\" is no suspension sheet: the kinematics of a suspension need its sheet, table or JSON file, in which the \
         parts are named"
    )]
    NoSheet {
        /// Path of the model.
        path: String,
    },
    /// Sheet without a wheel that the kinematics can follow.
    #[error("the model has no {missing}: the kinematics need a wheel on a spin joint")]
    NoWheel {
        /// Missing link or joint.
        missing: String,
    },
    /// Joint without a definition of its rates.
    #[error("{why}")]
    Unsupported {
        /// Reason.
        why: String,
    },
    /// Search that cannot start.
    #[error("{why}")]
    Search {
        /// Reason.
        why: String,
    },
    /// Steering of a suspension without a rack.
    #[error("the suspension has no tie rod, so there is no rack to move (--steer)")]
    NoRack,
    /// Error of a pose.
    #[error(transparent)]
    Study(#[from] StudyError),
    /// Error of a changed design.
    #[error(transparent)]
    Design(#[from] Box<DesignError>),
}

impl From<DesignError> for KinematicsError {
    fn from(error: DesignError) -> Self {
        KinematicsError::Design(Box::new(error))
    }
}
