//! Safe-speed table of a study file.

#[cfg(feature = "flags")]
use super::headings::{LIMIT, WHICH};
use crate::model::loading::Model;
use crate::question::errors::question_error::StudyError;
use crate::question::errors::refusal::InvalidKey;
use crate::question::mass_question::MassQuestion;
use crate::question::row_source::{PositionFile, RowSource, path_in};
use crate::reports::safe_speed::{
    SafeSpeedQuestion, SafeSpeedReport, StatedLimits, safe_speed, safe_speed_along, safe_speed_directions,
};

use crate::values::quantities::{Area, Energy, Force, Mass, Momentum, Pressure, Vector};
use crate::values::value::{self, Words};
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

/// Limit of the impact of a robot on a person.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::Args))]
#[serde(deny_unknown_fields, default)]
pub struct SafeSpeedTable {
    /// Region of the body; --list-regions shows all.
    ///
    /// The robot hits this region. Without a region, the other side is rigid and fixed (a person held against a wall;
    /// doors, guards), and energy or momentum is the limit.
    #[cfg_attr(feature = "flags", arg(long, value_name = "NAME", help_heading = LIMIT))]
    pub region: Option<String>,
    /// Largest permitted force (N), from the standard.
    #[cfg_attr(feature = "flags", arg(long, value_name = "F", allow_hyphen_values = true, conflicts_with = "pressure", help_heading = LIMIT))]
    pub force: Option<Force>,
    /// Largest pressure (N/cm²), with an area.
    ///
    /// The value is given by the standard. Units: N/cm2, N/mm2, MPa.
    #[cfg_attr(feature = "flags", arg(long, value_name = "P", allow_hyphen_values = true, requires = "area", help_heading = LIMIT))]
    pub pressure: Option<Pressure>,
    /// Contact area (cm², mm2), for a pressure.
    #[cfg_attr(feature = "flags", arg(long, value_name = "A", allow_hyphen_values = true, requires = "pressure", help_heading = LIMIT))]
    pub area: Option<Area>,
    /// Largest energy of the impact (J): 1/2 μ v².
    ///
    /// The value is given by the standard. Without a region, μ is the effective mass of the robot.
    #[cfg_attr(feature = "flags", arg(long, value_name = "E", allow_hyphen_values = true, conflicts_with_all = ["force", "pressure", "momentum"], help_heading = LIMIT))]
    pub energy: Option<Energy>,
    /// Largest exchanged momentum (N·s): μ v.
    ///
    /// The value is given by the standard.
    #[cfg_attr(feature = "flags", arg(long, value_name = "P", allow_hyphen_values = true, conflicts_with_all = ["force", "pressure"], help_heading = LIMIT))]
    pub momentum: Option<Momentum>,
    /// Directions (world axes); the slowest counts.
    ///
    /// They replace the normal; the lowest speed is the result.
    #[cfg_attr(feature = "flags", arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, conflicts_with_all = ["normal", "along_line"], help_heading = WHICH))]
    pub direction: Vec<Vector>,
    /// Direction with the largest effective mass.
    ///
    /// It replaces the normal.
    #[cfg_attr(feature = "flags", arg(long, conflicts_with_all = ["normal", "along_line"], help_heading = WHICH))]
    pub worst_direction: bool,
    /// File of positions; the slowest row counts.
    ///
    /// The format is that of percuss sweep. The row with the lowest speed is the result.
    #[cfg_attr(feature = "flags", arg(long, value_name = "FILE.csv|.parquet", conflicts_with_all = ["direction", "worst_direction"], help_heading = WHICH))]
    pub input: Option<String>,
    /// Ignore a column of the file of positions.
    #[cfg_attr(feature = "flags", arg(long, value_name = "COLUMN", requires = "input", help_heading = WHICH))]
    #[serde(deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub ignore: Vec<String>,
    /// Load that is missing in the model (kg); default 0.
    ///
    /// Load and tool: a point mass at the contact, and m_L in the standard's M/2 + m_L.
    #[cfg_attr(feature = "flags", arg(long, value_name = "KG", allow_hyphen_values = true, help_heading = LIMIT))]
    pub load: Option<Mass>,
}

impl SafeSpeedTable {
    /// True if directions replace the contact's normal.
    pub fn has_directions(&self) -> bool {
        self.worst_direction || !self.direction.is_empty()
    }

    /// Converts the table to a safe speed at a contact. Paths are relative to `folder`; a file read as a stream has at
    /// most `max_size` bytes.
    ///
    /// # Errors
    /// [`InvalidKey`]: not exactly one limit, or keys that exclude each other.
    pub fn safe_speed(
        &self,
        contact: &MassQuestion,
        folder: &Path,
        max_size: u64,
    ) -> Result<StudySafeSpeed, InvalidKey> {
        let refuse = |key, why: &str| Err(InvalidKey::new(key, why));
        let limit = StatedLimits {
            force: self.force.map(|force| force.0),
            pressure: self.pressure.map(|pressure| pressure.0),
            area: self.area.map(|area| area.0),
            energy: self.energy.map(|energy| energy.0),
            momentum: self.momentum.map(|momentum| momentum.0),
        }
        .one();
        let limit = limit.map_err(|error| {
            let given = if error.given.is_empty() { "none".to_owned() } else { error.given.join(", ") };
            let why = format!(
                "one limit is required: `force` (N), `pressure` (N/cm²) with `area` (cm²) of the region, `energy` (J) or \
                 `momentum` (N·s), from the edition of the standard that applies to you; given: {given}"
            );
            InvalidKey::new("safe_speed", why)
        })?;
        if self.input.is_none() && !self.ignore.is_empty() {
            return refuse("safe_speed.ignore", "it removes columns of `input`; give that file");
        }
        if self.input.is_some() && self.has_directions() {
            return refuse("safe_speed", "give either `input` or directions");
        }
        let rows = self.input.as_ref().map(|path| {
            let path = path_in(folder, path);
            RowSource::File(PositionFile { path, ignore: self.ignore.clone(), max_size })
        });
        Ok(StudySafeSpeed {
            contact: contact.clone(),
            limit_question: SafeSpeedQuestion {
                region: self.region.clone(),
                limit,
                load: self.load.unwrap_or_default().0,
            },
            directions: self.direction.iter().map(|direction| direction.0).collect(),
            worst_direction: self.worst_direction,
            rows,
        })
    }
}
