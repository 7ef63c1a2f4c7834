//! Safe-speed table of a study file.

use crate::model::loading::Model;
use crate::question::errors::question_error::StudyError;
use crate::question::errors::refusal::InvalidKey;
use crate::question::mass_question::MassQuestion;
use crate::question::row_source::{PositionFile, RowSource};
use crate::reports::safe_speed::{
    SafeSpeedQuestion, SafeSpeedReport, StatedLimits, safe_speed, safe_speed_along, safe_speed_directions,
};
use crate::values::value::{self, NumberOrText, Words};
use schemars::JsonSchema;
use serde::Deserialize;
use std::path::Path;

/// Safe speed requested by a study.
#[derive(Clone, Debug, PartialEq)]
pub struct StudySafeSpeed {
    /// Contact; the normal is absent if directions are given.
    pub contact: MassQuestion,
    /// Body region, limit and load.
    pub limit_question: SafeSpeedQuestion,
    /// Directions that replace the normal, world axes.
    pub directions: Vec<[f64; 3]>,
    /// True to add the direction of the largest mass.
    pub worst_direction: bool,
    /// Rows of positions; the slowest row determines the speed.
    pub rows: Option<RowSource>,
}

impl StudySafeSpeed {
    /// Reports: one per direction, or one for the contact.
    ///
    /// # Errors
    /// [`StudyError`], as for [`safe_speed`].
    pub fn reports(&self, model: &Model) -> Result<Vec<SafeSpeedReport>, StudyError> {
        let Self { contact, limit_question, directions, worst_direction, rows } = self;
        if *worst_direction || !directions.is_empty() {
            return safe_speed_directions(model, contact, limit_question, directions, *worst_direction);
        }
        let report = match rows {
            None => safe_speed(model, contact, limit_question)?,
            Some(rows) => safe_speed_along(model, contact, limit_question, rows)?,
        };
        Ok(vec![report])
    }
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct SafeSpeedText {
    /// The body region that is hit; percuss safe-speed --list-regions. Without a region the body cannot move.
    pub region: Option<String>,
    /// Largest force, N.
    #[serde(default, deserialize_with = "value::force")]
    #[schemars(with = "Option<NumberOrText>")]
    pub force: Option<f64>,
    /// Largest pressure, a number in N/cm²; with area.
    #[serde(default, deserialize_with = "value::pressure")]
    #[schemars(with = "Option<NumberOrText>")]
    pub pressure: Option<f64>,
    /// Contact area, a number in cm²; with pressure.
    #[serde(default, deserialize_with = "value::area")]
    #[schemars(with = "Option<NumberOrText>")]
    pub area: Option<f64>,
    /// Largest energy of the impact, J.
    #[serde(default, deserialize_with = "value::energy")]
    #[schemars(with = "Option<NumberOrText>")]
    pub energy: Option<f64>,
    /// Largest exchanged momentum, N·s.
    #[serde(default, deserialize_with = "value::momentum")]
    #[schemars(with = "Option<NumberOrText>")]
    pub momentum: Option<f64>,
    /// Directions in place of the contact's normal, world axes; the slowest result counts.
    #[serde(default, deserialize_with = "value::directions")]
    pub direction: Vec<[f64; 3]>,
    /// In place of the normal: the direction with the largest effective mass.
    #[serde(default)]
    pub worst_direction: bool,
    /// A file of positions; the slowest row counts.
    pub input: Option<String>,
    /// Columns of input to ignore.
    #[serde(default, deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub ignore: Vec<String>,
    /// Load including the tool, if not part of the model, kg.
    #[serde(default, deserialize_with = "value::load")]
    #[schemars(with = "Option<NumberOrText>")]
    pub load: f64,
}

impl SafeSpeedText {
    /// True if directions replace the contact's normal.
    pub fn has_directions(&self) -> bool {
        self.worst_direction || !self.direction.is_empty()
    }

    /// Converts the table to a safe speed at a contact.
    pub fn safe_speed(
        &self,
        contact: &MassQuestion,
        folder: &Path,
        max_size: u64,
    ) -> Result<StudySafeSpeed, InvalidKey> {
        let refuse = |key, why: &str| Err(InvalidKey::new(key, why));
        let Self { force, pressure, area, energy, momentum, .. } = *self;
        let limit = StatedLimits { force, pressure, area, energy, momentum }.one();
        let limit = limit.map_err(|error| InvalidKey::new("safe_speed", error.to_string()))?;
        if self.input.is_none() && !self.ignore.is_empty() {
            return refuse("safe_speed.ignore", "ignore removes columns of input; give input");
        }
        if self.input.is_some() && self.has_directions() {
            return refuse("safe_speed", "give either input or directions");
        }
        let rows = self.input.as_ref().map(|path| {
            let path = folder.join(path).to_string_lossy().into_owned();
            RowSource::File(PositionFile { path, ignore: self.ignore.clone(), max_size })
        });
        Ok(StudySafeSpeed {
            contact: contact.clone(),
            limit_question: SafeSpeedQuestion { region: self.region.clone(), limit, load: self.load },
            directions: self.direction.clone(),
            worst_direction: self.worst_direction,
            rows,
        })
    }
}
