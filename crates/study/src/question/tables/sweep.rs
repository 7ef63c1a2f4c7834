//! Question about the rows of a sweep, and the style of tables and figures.

#[cfg(feature = "flags")]
use super::headings::{OUTPUT, ROWS};
use crate::question::errors::refusal::InvalidKey;
use crate::question::row_source::{PositionFile, RowSource};
use crate::question::travel::vary::Vary;
use crate::values::value::{self, Words, path_in};
use percuss_formats::DEFAULT_MAX_SIZE;
use schemars::JsonSchema;
use serde::Deserialize;
use std::path::Path;
use std::str::FromStr;

/// Unit in a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "flags", derive(clap::ValueEnum))]
pub enum TableUnit {
    /// Lengths in metres.
    #[cfg_attr(feature = "flags", value(name = "m"))]
    Metre,
    /// Lengths in millimetres.
    #[cfg_attr(feature = "flags", value(name = "mm"))]
    Millimetre,
    /// Lengths in inches.
    #[cfg_attr(feature = "flags", value(name = "in"))]
    Inch,
    /// Angles in radians.
    #[cfg_attr(feature = "flags", value(name = "rad"))]
    Radian,
    /// Angles in degrees.
    #[cfg_attr(feature = "flags", value(name = "deg"))]
    Degree,
}

impl FromStr for TableUnit {
    type Err = &'static str;
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        match text {
            "m" => Ok(TableUnit::Metre),
            "mm" => Ok(TableUnit::Millimetre),
            "in" => Ok(TableUnit::Inch),
            "rad" => Ok(TableUnit::Radian),
            "deg" => Ok(TableUnit::Degree),
            _ => Err("expected m, mm, in, rad or deg"),
        }
    }
}

/// Decimal sign of CSV.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::ValueEnum))]
#[serde(rename_all = "lowercase")]
pub enum DecimalSign {
    /// Decimal point; cells are separated by commas.
    #[default]
    Point,
    /// Decimal comma; cells are separated by semicolons.
    Comma,
}

/// Style of the tables of a study.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "flags", derive(clap::Args), command(next_help_heading = OUTPUT))]
pub struct StudyTable {
    /// Units of a table: mm,deg.
    ///
    /// Units of lengths and of angles; the last unit of a kind applies. The column names then contain the units, and
    /// numbers are rounded to their significant digits.
    #[cfg_attr(
        feature = "flags",
        arg(long = "unit", id = "unit", value_name = "UNIT", value_enum, value_delimiter = ',')
    )]
    pub units: Vec<TableUnit>,
    /// Decimal sign in CSV.
    #[cfg_attr(feature = "flags", arg(long, value_enum, default_value_t))]
    pub decimal: DecimalSign,
}

/// Limits of an axis.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(try_from = "[f64; 2]")]
pub struct AxisLimits(pub f64, pub f64);

impl AxisLimits {
    /// Lower and upper limit.
    pub fn ends(self) -> (f64, f64) {
        (self.0, self.1)
    }
}

impl TryFrom<[f64; 2]> for AxisLimits {
    type Error = String;
    fn try_from([from, to]: [f64; 2]) -> Result<Self, String> {
        if from < to && from.is_finite() && to.is_finite() {
            return Ok(Self(from, to));
        }
        Err(format!("{from} is not below {to}"))
    }
}

impl FromStr for AxisLimits {
    type Err = String;
    /// Reads `FROM:TO`.
    fn from_str(text: &str) -> Result<Self, String> {
        let number = |text: &str| text.trim().parse::<f64>().ok().filter(|x| x.is_finite());
        let numbers = text.split_once(':').and_then(|(from, to)| Some([number(from)?, number(to)?]));
        numbers.ok_or("expected FROM:TO, two numbers such as -80:80")?.try_into()
    }
}

/// Style of the figures of a study.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "flags", derive(clap::Args), command(next_help_heading = OUTPUT))]
pub struct StudyFigure {
    /// Title of the figure.
    #[cfg_attr(feature = "flags", arg(long, value_name = "TEXT"))]
    pub title: Option<String>,
    /// Ends of the horizontal axis, in its unit.
    #[cfg_attr(feature = "flags", arg(long, value_name = "FROM:TO", allow_hyphen_values = true))]
    pub x_limits: Option<AxisLimits>,
    /// Ends of the axis of the effective mass (kg).
    #[cfg_attr(feature = "flags", arg(long, value_name = "FROM:TO", allow_hyphen_values = true))]
    pub y_limits: Option<AxisLimits>,
}

/// Rows of a sweep, and the files of its results. The command line has the last five keys in [`StudyTable`] and
/// [`StudyFigure`].
#[derive(Clone, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::Args), command(next_help_heading = ROWS))]
#[serde(deny_unknown_fields, default)]
pub struct SweepQuestion {
    /// Range of a joint, or of the travel of a point.
    ///
    /// The varied quantity is a driving joint, or the travel of a point: travel:LINK:X,Y,Z:DX,DY,DZ=FROM:TO:COUNT,
    /// point in m in the link frame, direction in world axes. Several ranges make a grid of all combinations; the
    /// first range varies slowest. A travel must be the last range.
    #[cfg_attr(
        feature = "flags",
        arg(
            long,
            value_name = "JOINT=FROM:TO:COUNT",
            required_unless_present_any = ["input", "random", "wheel_travel", "heave", "roll", "steer"]
        )
    )]
    #[serde(deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub vary: Vec<Vary>,
    /// Positions from a file, row by row.
    ///
    /// The rows are followed as a path. Each joint has a column (`JOINT[0]`, `JOINT[1]`, … if the joint has several
    /// numbers). A unit other than SI follows the name: `elbow [deg]`. - reads the standard input.
    #[cfg_attr(feature = "flags", arg(long, value_name = "FILE.csv|.parquet", conflicts_with_all = ["vary", "random"]))]
    pub input: Option<String>,
    /// Ignore a column of the file of positions.
    #[cfg_attr(feature = "flags", arg(long, value_name = "COLUMN"))]
    #[serde(deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub ignore: Vec<String>,
    /// Number of random positions within joint limits.
    ///
    /// Joints with a set position keep it.
    #[cfg_attr(feature = "flags", arg(long, value_name = "COUNT", conflicts_with = "vary"))]
    pub random: Option<usize>,
    /// Random seed; default 0. The numbers are the same on every machine.
    #[cfg_attr(feature = "flags", arg(long, value_name = "NUMBER"))]
    pub seed: Option<u64>,
    /// Adds the gradient g of m̄, one number per velocity of every movable joint, kg/rad or kg/m.
    ///
    /// Columns `gradient_JOINT`: dm̄/dt = Σ g q̇ over all joint velocities q̇ of an admissible motion. With
    /// closed loops the joint velocities depend on each other: only this sum is defined, not the single numbers.
    #[cfg_attr(feature = "flags", arg(long, help_heading = OUTPUT))]
    pub gradient: bool,
    /// .csv .xlsx .parquet .json .jsonl .svg .png .pdf
    ///
    /// Output file; the extension selects the format. Default: CSV on the standard output.
    #[cfg_attr(feature = "flags", arg(long, short, value_name = "FILE", help_heading = OUTPUT))]
    pub output: Option<String>,
    /// Units of the table's lengths and angles; column names then contain the units.
    #[cfg_attr(feature = "flags", arg(skip))]
    #[serde(deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub unit: Vec<TableUnit>,
    /// The decimal sign in CSV.
    #[cfg_attr(feature = "flags", arg(skip))]
    pub decimal: DecimalSign,
    /// The figure's heading.
    #[cfg_attr(feature = "flags", arg(skip))]
    pub title: Option<String>,
    /// Limits of the figure's horizontal axis, in the axis unit.
    #[cfg_attr(feature = "flags", arg(skip))]
    #[schemars(with = "Option<[f64; 2]>")]
    pub x_limits: Option<AxisLimits>,
    /// Limits of the figure's axis of the effective mass, kg.
    #[cfg_attr(feature = "flags", arg(skip))]
    #[schemars(with = "Option<[f64; 2]>")]
    pub y_limits: Option<AxisLimits>,
    /// Largest number of bytes of a file that is read as a stream; `None` for the default.
    #[cfg_attr(feature = "flags", arg(skip))]
    #[serde(skip)]
    pub max_size: Option<u64>,
}

impl SweepQuestion {
    /// Question with checked keys and with the ranges of the wheels, `motions`. Paths are relative to `folder`; a file read as a stream has
    /// at most `max_size` bytes.
    ///
    /// # Errors
    /// [`InvalidKey`]: not exactly one source of rows, or a key that belongs to another one.
    pub fn checked(&self, motions: Vec<Vary>, folder: &Path, max_size: u64) -> Result<Self, InvalidKey> {
        let refuse = |key, why: &'static str| Err(InvalidKey::new(key, why));
        if self.input.is_none() && !self.ignore.is_empty() {
            return refuse("sweep.ignore", "it removes columns of `input`; give that file");
        }
        if self.random.is_none() && self.seed.is_some() {
            return refuse("sweep.seed", "it requires `random`, the number of random positions");
        }
        let vary: Vec<Vary> = self.vary.iter().cloned().chain(motions).collect();
        if [!vary.is_empty(), self.input.is_some(), self.random.is_some()]
            .map(usize::from)
            .iter()
            .sum::<usize>()
            != 1
        {
            return refuse("sweep", "give one of `vary`, `input` and `random`");
        }
        let place = |path: &String| path_in(folder, path);
        let (input, output) = (self.input.as_ref().map(place), self.output.as_ref().map(place));
        Ok(Self { vary, input, output, max_size: Some(max_size), ..self.clone() })
    }

    /// Source of the rows: a file, random positions, or ranges.
    pub fn rows(&self) -> RowSource {
        match (&self.input, self.random) {
            (Some(path), _) => RowSource::File(PositionFile {
                path: path.clone(),
                ignore: self.ignore.clone(),
                max_size: self.max_size.unwrap_or(DEFAULT_MAX_SIZE),
            }),
            (None, Some(count)) => RowSource::Random { count, seed: self.seed.unwrap_or_default() },
            (None, None) => RowSource::Grid(self.vary.clone()),
        }
    }

    /// Style of the table.
    pub fn table(&self) -> StudyTable {
        StudyTable { units: self.unit.clone(), decimal: self.decimal }
    }

    /// Style of the figure.
    pub fn figure(&self) -> StudyFigure {
        StudyFigure { title: self.title.clone(), x_limits: self.x_limits, y_limits: self.y_limits }
    }
}
