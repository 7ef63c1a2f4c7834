//! Kinematics table of a study file: wheel angles, motion ratios and rates of a suspension over a travel.

use crate::model::loading::Model;
use crate::question::errors::refusal::InvalidKey;
use crate::question::travel::moved::WheelMotion;
use crate::reports::kinematics::question::{KinematicVariable, KinematicsError, KinematicsQuestion};
use crate::reports::kinematics::report::{KinematicsReport, kinematics};
use schemars::JsonSchema;
use serde::Deserialize;
use std::path::Path;

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
        Ok(StudyKinematics {
            question: KinematicsQuestion { range: Some((variable, values)), ..KinematicsQuestion::default() },
            columns: self.columns.clone(),
            output: self.output.as_ref().map(|output| folder.join(output).to_string_lossy().into_owned()),
        })
    }
}

impl StudyKinematics {
    /// Evaluates the quantities of the table.
    ///
    /// # Errors
    /// As [`kinematics`]; an unknown quantity.
    pub fn report(&self, model: &Model) -> Result<KinematicsReport, KinematicsError> {
        kinematics(model, &self.question)?.with_columns(&self.columns)
    }
}
