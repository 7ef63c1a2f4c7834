//! Unknowns and required values of a search in a suspension sheet.

use crate::question::mass_question::MassQuestion;
use crate::question::tables::damping::DampingQuestion;
use crate::reports::kinematics::column_names::column_name;
use percuss_units::{Dimension, Quantity};
use std::str::FromStr;

/// Unknown of a search: coordinate of a hardpoint, `POINT.AXIS`, or mass of a link, `LINK.mass`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SearchUnknown {
    /// Coordinate of a hardpoint in the axes of the sheet: 0 to 2 for x, y, z.
    Coordinate(String, usize),
    /// Mass of a link; its moments of inertia change in proportion.
    Mass(String),
}

/// Names of the axes.
const AXES: [&str; 3] = ["x", "y", "z"];

impl FromStr for SearchUnknown {
    type Err = String;
    fn from_str(text: &str) -> Result<Self, String> {
        let (name, last) = text.rsplit_once('.').unwrap_or_default();
        match AXES.iter().position(|axis| *axis == last) {
            Some(axis) if !name.is_empty() => Ok(Self::Coordinate(name.to_owned(), axis)),
            None if !name.is_empty() && last == "mass" => Ok(Self::Mass(name.to_owned())),
            _ => Err("expected POINT.AXIS or LINK.mass, such as rocker_back.z or lower_arm.mass".to_owned()),
        }
    }
}

impl SearchUnknown {
    /// Name `POINT.AXIS` or `LINK.mass`.
    pub fn name(&self) -> String {
        match self {
            Self::Coordinate(point, axis) => format!("{point}.{}", AXES[*axis]),
            Self::Mass(link) => format!("{link}.mass"),
        }
    }
}

/// Required value of a quantity: `QUANTITY=VALUE`.
#[derive(Clone, Debug, PartialEq)]
pub struct KinematicTarget {
    /// Column of `percuss kinematics`, with or without the suffix of the side; see `column_name`.
    pub quantity: String,
    /// Value with its unit; without a unit SI, or a plain number.
    pub value: Quantity,
    /// Unit of a quotient, such as deg/m, in which the value is given.
    pub quotient: Option<&'static str>,
}

/// Units of quotients, as in tables.
pub(crate) const QUOTIENTS: [&str; 6] = ["deg/m", "1/m", "deg/kN", "mm/kN", "deg/(kN·m)", "mm/(kN·m)"];

impl FromStr for KinematicTarget {
    type Err = String;
    fn from_str(text: &str) -> Result<Self, String> {
        let (quantity, value) =
            text.split_once('=').ok_or("expected QUANTITY=VALUE, such as spring.motion_ratio=0.75")?;
        // The unit of a quotient has no dimension of its own.
        let split =
            |unit: &'static str| Some((unit, value.trim().strip_suffix(unit.trim_start_matches('1'))?));
        let quotient = QUOTIENTS.into_iter().find_map(split);
        let (quotient, value) = quotient.map_or((None, value), |(unit, number)| (Some(unit), number));
        let parse = |dimension: Dimension| dimension.parse(value);
        // Per cent and units of stiffness have no dimension in a plain number.
        let value = Quantity::parse(value).or_else(|error| {
            parse(Dimension::Ratio)
                .or_else(|_| parse(Dimension::Stiffness))
                .or_else(|_| parse(Dimension::Force))
                .map_err(|_| error)
        });
        let value = value.map_err(|error| error.to_string())?;
        Ok(Self { quantity: column_name(quantity.trim()), value, quotient })
    }
}

/// Search for coordinates and masses.
#[derive(Clone, Debug, PartialEq)]
pub struct TargetSearch {
    /// Unknown coordinates and masses.
    pub unknowns: Vec<SearchUnknown>,
    /// Required values, as many as unknowns.
    pub targets: Vec<KinematicTarget>,
    /// Largest change of each coordinate, m. A mass changes by at most half.
    pub within: f64,
    /// Question of the quantity `effective_mass`; `None` without such a target.
    pub mass: Option<MassQuestion>,
    /// Speed, restitution and stiffness of the contacts, for the quantities `CONTACT.peak_force` and `CONTACT.compression`; the default stiffness
    /// is the force curve of the stop in the sheet.
    pub impact: Option<DampingQuestion>,
}
