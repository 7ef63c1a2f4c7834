//! Flags of tables and figures.

use super::headings::OUTPUT;
use crate::files::table_style::TableStyle;
use clap::{Args, ValueEnum};
use percuss_study as study;

/// Unit of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum TableUnit {
    /// Lengths in metres.
    M,
    /// Lengths in millimetres.
    Mm,
    /// Angles in radians.
    Rad,
    /// Angles in degrees.
    Deg,
}

/// Decimal sign.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Decimal {
    /// Decimal point; cells are separated by commas.
    #[default]
    Point,
    /// Decimal comma; cells are separated by semicolons.
    Comma,
}

/// Flags of tables.
#[derive(Debug, Args)]
pub struct TableArgs {
    /// Units of a table: mm,deg.
    ///
    /// Units of lengths and of angles. The column names then contain the units, and numbers are rounded to their
    /// significant digits.
    #[arg(long, value_name = "UNIT", value_enum, value_delimiter = ',', help_heading = OUTPUT)]
    pub unit: Vec<TableUnit>,
    /// Decimal sign in CSV.
    #[arg(long, value_enum, default_value_t, help_heading = OUTPUT)]
    pub decimal: Decimal,
}

impl TableArgs {
    /// Converts the flags to a style.
    pub fn style(&self) -> TableStyle {
        let unit = |unit: &TableUnit| match unit {
            TableUnit::M => study::TableUnit::Metre,
            TableUnit::Mm => study::TableUnit::Millimetre,
            TableUnit::Rad => study::TableUnit::Radian,
            TableUnit::Deg => study::TableUnit::Degree,
        };
        let units = self.unit.iter().map(unit).collect();
        TableStyle::from_study(&study::StudyTable { units, comma: self.decimal == Decimal::Comma })
    }
}

/// Flags of figures.
#[derive(Debug, Default, Args)]
pub struct FigureArgs {
    /// Title of the figure.
    #[arg(long, value_name = "TEXT", help_heading = OUTPUT)]
    pub title: Option<String>,
    /// Ends of the horizontal axis, in its unit.
    #[arg(long, value_name = "FROM:TO", allow_hyphen_values = true, value_parser = axis_limits, help_heading = OUTPUT)]
    pub x_limits: Option<(f64, f64)>,
    /// Ends of the axis of the effective mass (kg).
    #[arg(long, value_name = "FROM:TO", allow_hyphen_values = true, value_parser = axis_limits, help_heading = OUTPUT)]
    pub y_limits: Option<(f64, f64)>,
}

impl FigureArgs {
    /// Converts the flags to the figure options of a study.
    pub fn figure(&self) -> study::StudyFigure {
        let Self { title, x_limits, y_limits } = self;
        study::StudyFigure { title: title.clone(), x_limits: *x_limits, y_limits: *y_limits }
    }
}

/// `LOW,HIGH`: the two ends of an axis.
fn axis_limits(text: &str) -> Result<(f64, f64), String> {
    let number = |text: &str| text.trim().parse::<f64>().ok().filter(|x| x.is_finite());
    let axis_limits = text.split_once(':').and_then(|(from, to)| Some((number(from)?, number(to)?)));
    match axis_limits {
        Some((from, to)) if from < to => Ok((from, to)),
        Some((from, to)) => Err(format!("{from} is not below {to}")),
        None => Err("expected FROM:TO, two numbers such as -80:80".into()),
    }
}
