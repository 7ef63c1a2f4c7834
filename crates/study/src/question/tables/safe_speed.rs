//! Question about the safe speed of a robot that may hit a person.

use super::extremes::{GivenEdge, GivenNormals, GivenRange};
#[cfg(feature = "flags")]
use super::headings::{LIMIT, WHICH};
use crate::question::errors::refusal::InvalidKey;
use crate::question::row_source::{PositionFile, RowSource};
use crate::values::quantities::{Area, Energy, Force, Mass, Momentum, Pressure, Ratio, Vector};
use crate::values::value::{self, Words};
use percuss_formats::DEFAULT_MAX_SIZE;
use percuss_impact::NormalRange;
use percuss_units::{Dimension, Quantity};
use schemars::JsonSchema;
use serde::Deserialize;
use std::path::Path;
use std::str::FromStr;

/// Limit of the impact, taken by the user from the applicable edition of the standard.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Limit {
    /// Largest force, N.
    Force(f64),
    /// Largest pressure, Pa, and contact area, m².
    Pressure(f64, f64),
    /// Largest energy of the impact, J.
    Energy(f64),
    /// Largest exchanged momentum, N·s.
    Momentum(f64),
}

/// Error: no limit, several limits, or an incomplete limit.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error(
    "one limit is required: force, pressure with area, energy or momentum, from the edition of the standard that applies to you; \
     given: {}",
    if given.is_empty() { "none".to_owned() } else { given.join(" and ") }
)]
pub struct LimitError {
    /// Names of the given values.
    pub given: Vec<&'static str>,
}

/// Tracking error: an angle of hinges, rad, or a length of slides, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GivenTracking {
    /// True for an angle.
    pub is_angle: bool,
    /// Largest distance from the position, rad or m.
    pub error: f64,
}

impl FromStr for GivenTracking {
    type Err = String;
    /// Reads `1deg` or `1mm`.
    fn from_str(text: &str) -> Result<Self, String> {
        let found = Quantity::parse(text).map_err(|error| error.to_string())?;
        let wrong = || {
            format!(
                "\"{text}\" is no error of positions; expected an angle or a length above 0, such as 1deg or 1mm"
            )
        };
        match found.dimension {
            Some(Dimension::Angle) if found.value > 0.0 => Ok(Self { is_angle: true, error: found.value }),
            Some(Dimension::Length) if found.value > 0.0 => Ok(Self { is_angle: false, error: found.value }),
            _ => Err(wrong()),
        }
    }
}

/// Limit of the impact of a robot on a person.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::Args), command(next_help_heading = LIMIT))]
#[serde(deny_unknown_fields, default)]
pub struct SafeSpeedQuestion {
    /// Region of the body; --list-regions shows all.
    ///
    /// The robot hits this region. Without a region, the other side is rigid and fixed (a person held against a wall;
    /// doors, guards), and energy or momentum is the limit.
    #[cfg_attr(feature = "flags", arg(long, value_name = "NAME"))]
    pub region: Option<String>,
    /// Largest permitted force (N), from the standard.
    #[cfg_attr(feature = "flags", arg(long, value_name = "F", conflicts_with = "pressure"))]
    pub force: Option<Force>,
    /// Largest pressure (N/cm²), with an area.
    ///
    /// The value is given by the standard. Units: N/cm2, N/mm2, MPa.
    #[cfg_attr(feature = "flags", arg(long, value_name = "P", requires = "area"))]
    pub pressure: Option<Pressure>,
    /// Contact area (cm², mm2), for a pressure.
    #[cfg_attr(feature = "flags", arg(long, value_name = "A", requires = "pressure"))]
    pub area: Option<Area>,
    /// Largest energy of the impact (J): 1/2 μ v².
    ///
    /// The value is given by the standard. Without a region, μ is the effective mass of the robot.
    #[cfg_attr(feature = "flags", arg(long, value_name = "E", conflicts_with_all = ["force", "pressure", "momentum"]))]
    pub energy: Option<Energy>,
    /// Largest exchanged momentum (N·s): μ v.
    ///
    /// The value is given by the standard.
    #[cfg_attr(feature = "flags", arg(long, value_name = "P", conflicts_with_all = ["force", "pressure"]))]
    pub momentum: Option<Momentum>,
    /// Directions (world axes); the slowest counts.
    ///
    /// They replace the normal; the lowest speed is the result.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "X,Y,Z", conflicts_with_all = ["normal", "along_line"], help_heading = WHICH)
    )]
    pub direction: Vec<Vector>,
    /// Direction with the largest effective mass.
    ///
    /// It replaces the normal.
    #[cfg_attr(feature = "flags", arg(long, conflicts_with_all = ["normal", "along_line"], help_heading = WHICH))]
    pub worst_direction: bool,
    /// File of positions; the slowest row counts.
    ///
    /// The format is that of percuss sweep. The row with the lowest speed is the result.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "FILE.csv|.parquet", conflicts_with_all = ["direction", "worst_direction"], help_heading = WHICH)
    )]
    pub input: Option<String>,
    /// Ignore a column of the file of positions.
    #[cfg_attr(feature = "flags", arg(long, value_name = "COLUMN", requires = "input", help_heading = WHICH))]
    #[serde(deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub ignore: Vec<String>,
    /// Range of a joint for a proof, JOINT=FROM:TO.
    ///
    /// With certify: a speed that holds for all positions in the ranges, at the contact point and the normal of the question.
    #[cfg_attr(
        feature = "flags",
        arg(
            long,
            value_name = "JOINT=FROM:TO",
            allow_hyphen_values = true,
            requires = "certify",
            conflicts_with = "input",
            help_heading = WHICH
        )
    )]
    #[serde(deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub range: Vec<GivenRange>,
    /// Prove a speed for all positions in the ranges or along `input`, within a relative tolerance of the mass, such as 2%.
    #[cfg_attr(feature = "flags", arg(long, value_name = "TOLERANCE", help_heading = WHICH))]
    pub certify: Option<Ratio>,
    /// Tracking error of the joints (1deg, 1mm) for a proof along `input`.
    ///
    /// An angle applies to hinges, a length to slides. The proof covers all positions between two rows and within this error of them.
    #[cfg_attr(feature = "flags", arg(long, value_name = "ERROR", requires = "input", help_heading = WHICH))]
    #[serde(deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub tracking: Vec<GivenTracking>,
    /// Normals of a proof: given, or cone:ANGLE around the given one.
    #[cfg_attr(feature = "flags", arg(long, value_name = "NORMALS", requires = "certify", help_heading = WHICH))]
    #[serde(deserialize_with = "value::some_word")]
    #[schemars(with = "Option<String>")]
    pub normals: Option<GivenNormals>,
    /// Edge X,Y,Z of a patch of contact points of a proof; twice: a parallelogram.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, requires = "certify", help_heading = WHICH)
    )]
    #[serde(deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub edge: Vec<GivenEdge>,
    /// Prove the speed for all contacts on the surface of the link.
    ///
    /// Along the normals of its collision shapes, or of its visual shapes if there are none. At edges and corners, normals between those of
    /// the neighbouring faces have no proof.
    #[cfg_attr(
        feature = "flags",
        arg(long, requires = "certify", conflicts_with_all = ["normals", "edge"], help_heading = WHICH)
    )]
    pub surface: bool,
    /// Load that is missing in the model (kg); default 0.
    ///
    /// Load and tool: a point mass at the contact, and m_L in the standard's M/2 + m_L.
    #[cfg_attr(feature = "flags", arg(long, value_name = "KG"))]
    pub load: Option<Mass>,
    /// Rows of positions in place of `input`; the slowest row counts.
    #[cfg_attr(feature = "flags", arg(skip))]
    #[serde(skip)]
    pub rows: Option<RowSource>,
}

impl SafeSpeedQuestion {
    /// True if directions replace the contact's normal.
    pub fn has_directions(&self) -> bool {
        self.worst_direction || !self.direction.is_empty()
    }

    /// Question with checked keys. Paths are relative to `folder`; a file read as a stream has at most `max_size` bytes.
    ///
    /// # Errors
    /// As for [`check`](Self::check).
    pub fn checked(&self, folder: &Path, max_size: u64) -> Result<Self, InvalidKey> {
        self.check()?;
        let rows = self.rows().map(|rows| rows.in_folder(folder, max_size));
        Ok(Self { rows, ..self.clone() })
    }

    /// Checks the keys.
    ///
    /// # Errors
    /// [`InvalidKey`]: not exactly one limit, or keys that exclude each other.
    pub fn check(&self) -> Result<(), InvalidKey> {
        let refuse = |key, why: &'static str| Err(InvalidKey::new(key, why));
        self.only_limit()?;
        if self.input.is_none() && !self.ignore.is_empty() {
            return refuse("safe_speed.ignore", "it removes columns of `input`; give that file");
        }
        if self.certify.is_some() && self.range.is_empty() == self.rows().is_none() {
            return refuse(
                "safe_speed.certify",
                "a proof covers either `range` or the rows of `input`; give one of them",
            );
        }
        let has_proof_keys = !(self.range.is_empty() && self.tracking.is_empty() && self.edge.is_empty());
        if self.certify.is_none() && (has_proof_keys || self.normals.is_some() || self.surface) {
            return refuse(
                "safe_speed.certify",
                "`range`, `tracking`, `normals`, `edge` and `surface` belong to a proof; give `certify`, such as 2%",
            );
        }
        if self.surface && (self.normals.is_some() || !self.edge.is_empty()) {
            return refuse(
                "safe_speed.surface",
                "the shapes give points and normals; expected neither `normals` nor `edge`",
            );
        }
        if self.surface && self.has_directions() {
            return refuse("safe_speed.surface", "the shapes give the normals; expected no directions");
        }
        if !self.tracking.is_empty() && self.rows().is_none() {
            return refuse("safe_speed.tracking", "it is the error of the rows of `input`; give that file");
        }
        if !matches!(self.normals.unwrap_or_default().0, NormalRange::Given | NormalRange::Cone(_)) {
            return refuse(
                "safe_speed.normals",
                "a proof covers the given normal or a cone around it; expected cone:ANGLE",
            );
        }
        if self.edge.len() > 2 {
            return refuse(
                "safe_speed.edge",
                "a patch has one or two edges; expected a line or a parallelogram",
            );
        }
        if !(1e-9..=1.0).contains(&self.certify.map_or(1.0, |Ratio(tolerance)| tolerance)) {
            return refuse("safe_speed.certify", "expected a relative tolerance from 1e-9 to 1, such as 2%");
        }
        if self.rows().is_some() && self.has_directions() {
            return refuse("safe_speed", "give either `input` or directions");
        }
        Ok(())
    }

    /// Rows of positions; `None` for the pose of the question.
    pub fn rows(&self) -> Option<RowSource> {
        let file = |path: &String| {
            let (path, ignore, max_size) = (path.clone(), self.ignore.clone(), DEFAULT_MAX_SIZE);
            RowSource::File(PositionFile { path, ignore, max_size })
        };
        self.rows.clone().or_else(|| self.input.as_ref().map(file))
    }

    /// The given limit.
    ///
    /// # Errors
    /// [`LimitError`]: no limit, several limits, a pressure without an area or an area without a pressure.
    pub fn limit(&self) -> Result<Limit, LimitError> {
        match (self.force, self.pressure, self.area, self.energy, self.momentum) {
            (Some(force), None, None, None, None) => Ok(Limit::Force(force.0)),
            (None, Some(pressure), Some(area), None, None) => Ok(Limit::Pressure(pressure.0, area.0)),
            (None, None, None, Some(energy), None) => Ok(Limit::Energy(energy.0)),
            (None, None, None, None, Some(momentum)) => Ok(Limit::Momentum(momentum.0)),
            (force, pressure, area, energy, momentum) => {
                let values = [
                    ("force", force.is_some()),
                    ("pressure", pressure.is_some()),
                    ("area", area.is_some()),
                    ("energy", energy.is_some()),
                    ("momentum", momentum.is_some()),
                ];
                let given = values.into_iter().filter(|(_, is_given)| *is_given).map(|(name, _)| name);
                Err(LimitError { given: given.collect() })
            }
        }
    }

    /// The given limit; an error names the keys.
    pub(crate) fn only_limit(&self) -> Result<Limit, InvalidKey> {
        self.limit().map_err(|error| {
            let given = if error.given.is_empty() { "none".to_owned() } else { error.given.join(", ") };
            let why = format!(
                "one limit is required: `force` (N), `pressure` (N/cm²) with `area` (cm²) of the region, `energy` (J) or \
                 `momentum` (N·s), from the edition of the standard that applies to you; given: {given}"
            );
            InvalidKey::with_names("safe_speed", why)
        })
    }

    /// Load including the tool, if not part of the model, kg.
    pub fn load(&self) -> f64 {
        self.load.unwrap_or_default().0
    }
}
