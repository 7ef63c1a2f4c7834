//! Sweep table of a study file, and the style of tables and figures.

use crate::question::errors::refusal::InvalidKey;
use crate::question::row_source::{PositionFile, RowSource};
use crate::question::travel::vary::Vary;
use crate::values::value::{self, Words};
use schemars::JsonSchema;
use serde::Deserialize;
use std::path::Path;

/// Unit in a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TableUnit {
    /// Lengths in metres.
    Metre,
    /// Lengths in millimetres.
    Millimetre,
    /// Angles in radians.
    Radian,
    /// Angles in degrees.
    Degree,
}

/// Style of the tables of a study.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct StudyTable {
    /// Units of lengths and angles; the last unit of a kind applies. Column names contain the units if any are
    /// given.
    pub units: Vec<TableUnit>,
    /// True for decimal commas with semicolons between cells.
    pub comma: bool,
}

/// Style of the figures of a study.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StudyFigure {
    /// The heading.
    pub title: Option<String>,
    /// Limits of the horizontal axis, in the axis unit.
    pub x_limits: Option<(f64, f64)>,
    /// Limits of the m̄ axis, kg.
    pub y_limits: Option<(f64, f64)>,
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct SweepText {
    /// JOINT=FROM:TO:COUNT, travel:LINK:X,Y,Z:DX,DY,DZ=FROM:TO:COUNT, or a list of them: a grid.
    #[serde(default, deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub vary: Vec<String>,
    /// In place of vary: a file of positions, row by row (.csv, .parquet).
    pub input: Option<String>,
    /// Columns of input to ignore.
    #[serde(default, deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub ignore: Vec<String>,
    /// In place of vary: number of random positions within the limits of the joints.
    pub random: Option<usize>,
    /// The seed of random; default 0.
    pub seed: Option<u64>,
    /// The file of the rows (.csv, .xlsx, .parquet, .json, .jsonl) or of the figure (.svg, .png, .pdf).
    pub output: Option<String>,
    /// Units of the table's lengths and angles; column names then contain the units.
    #[serde(default, deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub unit: Vec<String>,
    /// The decimal sign in CSV.
    #[schemars(extend("enum" = ["point", "comma"]))]
    pub decimal: Option<String>,
    /// The figure's heading.
    pub title: Option<String>,
    /// Limits of the figure's horizontal axis, in the axis unit.
    #[serde(default, deserialize_with = "value::ends")]
    #[schemars(with = "Option<[f64; 2]>")]
    pub x_limits: Option<(f64, f64)>,
    /// Limits of the figure's axis of the effective mass, kg.
    #[serde(default, deserialize_with = "value::ends")]
    #[schemars(with = "Option<[f64; 2]>")]
    pub y_limits: Option<(f64, f64)>,
}

/// Keys of the table style, for messages.
pub(crate) struct TableKeyNames {
    pub unit: &'static str,
    pub decimal: &'static str,
}

/// Table style from the words of a study.
pub(crate) fn parse_table_style(
    units: &[String],
    decimal: Option<&str>,
    keys: &TableKeyNames,
) -> Result<StudyTable, InvalidKey> {
    let unit = |word: &String| match word.as_str() {
        "m" => Ok(TableUnit::Metre),
        "mm" => Ok(TableUnit::Millimetre),
        "rad" => Ok(TableUnit::Radian),
        "deg" => Ok(TableUnit::Degree),
        other => Err(InvalidKey::new(keys.unit, format!("\"{other}\"; expected m, mm, rad or deg"))),
    };
    let comma = match decimal {
        None | Some("point") => false,
        Some("comma") => true,
        Some(other) => {
            return Err(InvalidKey::new(keys.decimal, format!("\"{other}\"; expected point or comma")));
        }
    };
    Ok(StudyTable { units: units.iter().map(unit).collect::<Result<_, _>>()?, comma })
}

impl SweepText {
    /// Source of the rows. Paths are relative to the study's folder.
    pub fn source(&self, folder: &Path, max_size: u64) -> Result<RowSource, InvalidKey> {
        let refuse = |why: &str| Err(InvalidKey::new("sweep", why));
        if self.input.is_none() && !self.ignore.is_empty() {
            return refuse("ignore removes columns of input; give input");
        }
        if self.random.is_none() && self.seed.is_some() {
            return refuse("seed requires random; give random");
        }
        match (&self.vary[..], &self.input, self.random) {
            ([_, ..], None, None) => {
                let range = |text: &String| {
                    Vary::parse(text).map_err(|error| InvalidKey::new("sweep.vary", error.to_string()))
                };
                self.vary.iter().map(range).collect::<Result<_, _>>().map(RowSource::Grid)
            }
            ([], Some(path), None) => {
                let path = folder.join(path).to_string_lossy().into_owned();
                Ok(RowSource::File(PositionFile { path, ignore: self.ignore.clone(), max_size }))
            }
            ([], None, Some(count)) => Ok(RowSource::Random { count, seed: self.seed.unwrap_or_default() }),
            _ => refuse("give one of vary, input and random"),
        }
    }

    /// Style of the table.
    pub fn table(&self) -> Result<StudyTable, InvalidKey> {
        let keys = TableKeyNames { unit: "sweep.unit", decimal: "sweep.decimal" };
        parse_table_style(&self.unit, self.decimal.as_deref(), &keys)
    }

    /// Style of the figure.
    pub fn figure(&self) -> StudyFigure {
        StudyFigure { title: self.title.clone(), x_limits: self.x_limits, y_limits: self.y_limits }
    }
}
