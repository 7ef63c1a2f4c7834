//! The safe speed of a study file.

use crate::error::StudyError;
use crate::model::Model;
use crate::question::MassQuestion;
use crate::refusal::Refusal;
use crate::row_source::{PositionFile, RowSource};
use crate::safe_speed::{
    SafeSpeedQuestion, SafeSpeedReport, StatedLimits, safe_speed, safe_speed_along, safe_speed_directions,
};
use crate::study_value::{self, NumberOrText, Words};
use schemars::JsonSchema;
use serde::Deserialize;
use std::path::Path;

/// The safe speed that a study asks for.
#[derive(Clone, Debug, PartialEq)]
pub struct StudySafeSpeed {
    /// The contact; without a normal where directions take its place.
    pub contact: MassQuestion,
    /// Who is struck, and what may happen.
    pub asked: SafeSpeedQuestion,
    /// Directions in the place of the normal, world axes.
    pub directions: Vec<[f64; 3]>,
    /// Whether the direction of the greatest mass is one.
    pub worst_direction: bool,
    /// Rows of positions, the slowest of which counts.
    pub rows: Option<RowSource>,
}

impl StudySafeSpeed {
    /// The answer: one for each direction, where there are some.
    ///
    /// # Errors
    /// [`StudyError`], as for [`safe_speed`].
    pub fn reports(&self, model: &Model) -> Result<Vec<SafeSpeedReport>, StudyError> {
        let Self { contact, asked, directions, worst_direction, rows } = self;
        if *worst_direction || !directions.is_empty() {
            return safe_speed_directions(model, contact, asked, directions, *worst_direction);
        }
        let report = match rows {
            None => safe_speed(model, contact, asked)?,
            Some(rows) => safe_speed_along(model, contact, asked, rows)?,
        };
        Ok(vec![report])
    }
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct SafeSpeedText {
    /// The region of the body that is hit; percuss safe-speed --list-regions. Without it what is struck does not give way.
    pub region: Option<String>,
    /// Greatest force, N.
    #[serde(default, deserialize_with = "study_value::force")]
    #[schemars(with = "Option<NumberOrText>")]
    pub force: Option<f64>,
    /// Greatest pressure, a number in N/cm²; with area.
    #[serde(default, deserialize_with = "study_value::pressure")]
    #[schemars(with = "Option<NumberOrText>")]
    pub pressure: Option<f64>,
    /// Contact area, a number in cm²; with pressure.
    #[serde(default, deserialize_with = "study_value::area")]
    #[schemars(with = "Option<NumberOrText>")]
    pub area: Option<f64>,
    /// Greatest energy of the impact, J.
    #[serde(default, deserialize_with = "study_value::energy")]
    #[schemars(with = "Option<NumberOrText>")]
    pub energy: Option<f64>,
    /// Greatest momentum that is exchanged, N·s.
    #[serde(default, deserialize_with = "study_value::momentum")]
    #[schemars(with = "Option<NumberOrText>")]
    pub momentum: Option<f64>,
    /// Directions in the place of the contact's normal, world axes; the slowest counts.
    #[serde(default, deserialize_with = "study_value::directions")]
    pub direction: Vec<[f64; 3]>,
    /// The direction in which the contact is heaviest, in the place of the normal.
    #[serde(default)]
    pub worst_direction: bool,
    /// A file of positions: the slowest of its rows counts.
    pub input: Option<String>,
    /// Columns of input that are left out.
    #[serde(default, deserialize_with = "study_value::words")]
    #[schemars(with = "Option<Words>")]
    pub ignore: Vec<String>,
    /// Load with its tool that the model does not hold, kg.
    #[serde(default, deserialize_with = "study_value::load")]
    #[schemars(with = "Option<NumberOrText>")]
    pub load: f64,
}

impl SafeSpeedText {
    /// Whether directions take the place of the contact's normal.
    pub fn has_directions(&self) -> bool {
        self.worst_direction || !self.direction.is_empty()
    }

    /// The safe speed at a contact.
    pub fn safe_speed(
        &self,
        contact: &MassQuestion,
        folder: &Path,
        max_size: u64,
    ) -> Result<StudySafeSpeed, Refusal> {
        let refuse = |key, why: &str| Err(Refusal::new(key, why));
        let Self { force, pressure, area, energy, momentum, .. } = *self;
        let limit = StatedLimits { force, pressure, area, energy, momentum }.one();
        let limit = limit.map_err(|error| Refusal::new("safe_speed", error.to_string()))?;
        if self.input.is_none() && !self.ignore.is_empty() {
            return refuse("safe_speed.ignore", "it leaves out columns of input; give input");
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
            asked: SafeSpeedQuestion { region: self.region.clone(), limit, load: self.load },
            directions: self.direction.clone(),
            worst_direction: self.worst_direction,
            rows,
        })
    }
}
