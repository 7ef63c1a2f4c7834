//! Unknowns and required values of a search in a suspension sheet.

use crate::question::errors::refusal::InvalidKey;
use crate::question::mass_question::MassQuestion;
use crate::question::tables::damping::DampingQuestion;
use crate::question::tables::kinematics::TargetsQuestion;
use crate::reports::kinematics::column_names::column_name;
use crate::values::quantities::{Length, Ratio};
use crate::values::value::NumberOrText;
use percuss_suspension::kinematics::KinematicUnit;
use percuss_units::{Dimension, LengthUnit, Quantity};
use std::str::FromStr;

/// Unknown of a search: coordinate of a hardpoint, `POINT.AXIS`, mass of a link, `LINK.mass`, force curve (or stiffness) of a stop,
/// `CONTACT.curve`, or its damping, `CONTACT.damping`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SearchUnknown {
    /// Coordinate of a hardpoint in the axes of the sheet: 0 to 2 for x, y, z.
    Coordinate(String, usize),
    /// Mass of a link; its moments of inertia change in proportion.
    Mass(String),
    /// Factor on the forces of the curve of a contact, or on its stiffness.
    Curve(String),
    /// Factor on the damping of a contact.
    Damping(String),
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
            None if !name.is_empty() && last == "curve" => Ok(Self::Curve(name.to_owned())),
            None if !name.is_empty() && last == "damping" => Ok(Self::Damping(name.to_owned())),
            _ => Err("expected POINT.AXIS, LINK.mass, CONTACT.curve or CONTACT.damping, such as rocker_back.z, lower_arm.mass or \
                      bump_stop.curve"
                .to_owned()),
        }
    }
}

impl SearchUnknown {
    /// Name `POINT.AXIS`, `LINK.mass`, `CONTACT.curve` or `CONTACT.damping`.
    pub fn name(&self) -> String {
        match self {
            Self::Coordinate(point, axis) => format!("{point}.{}", AXES[*axis]),
            Self::Mass(link) => format!("{link}.mass"),
            Self::Curve(contact) => format!("{contact}.curve"),
            Self::Damping(contact) => format!("{contact}.damping"),
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
const QUOTIENTS: [&str; 6] = ["deg/m", "1/m", "deg/kN", "mm/kN", "deg/(kN·m)", "mm/(kN·m)"];

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

/// Dimension of a value of a unit.
fn dimension(unit: KinematicUnit) -> Dimension {
    match unit {
        KinematicUnit::Length => Dimension::Length,
        KinematicUnit::Angle => Dimension::Angle,
        KinematicUnit::Ratio | KinematicUnit::Percent => Dimension::Ratio,
        KinematicUnit::Stiffness => Dimension::Stiffness,
        KinematicUnit::Force => Dimension::Force,
        KinematicUnit::Moment => Dimension::Moment,
        KinematicUnit::Mass => Dimension::Mass,
        KinematicUnit::AnglePerLength
        | KinematicUnit::PerLength
        | KinematicUnit::Frequency
        | KinematicUnit::AnglePerForce
        | KinematicUnit::AnglePerMoment
        | KinematicUnit::LengthPerForce
        | KinematicUnit::LengthPerMoment => Dimension::Plain,
    }
}

impl KinematicTarget {
    /// Required value in SI units, for a quantity of a unit. Error: a value without its unit or with another one.
    pub(crate) fn goal(&self, unit: KinematicUnit, length_unit: LengthUnit) -> Result<f64, String> {
        let Self { quantity, value, .. } = self;
        let text = value.to_string();
        let (in_table, factor, _) = unit.of_table(length_unit);
        // A number without a unit is in SI units, which few users mean.
        let needs_unit =
            matches!(unit, KinematicUnit::Length | KinematicUnit::Angle | KinematicUnit::Stiffness);
        if needs_unit && value.dimension.is_none() && value.value != 0.0 {
            return Err(format!("--for {quantity}={text}: the number has no unit; write {text}{in_table}"));
        }
        let is_quotient = QUOTIENTS.contains(&in_table);
        let is_other = self.quotient.is_some_and(|given| given != in_table);
        let goal = value.in_dimension(dimension(unit), &text).map_err(|error| error.to_string());
        let goal = goal.and_then(|goal| {
            if is_other { Err(format!("it is in {}", self.quotient.unwrap_or_default())) } else { Ok(goal) }
        });
        let goal = goal.map_err(|why| {
            if is_quotient {
                format!(
                    "--for {quantity}={text}: a number in {in_table} is expected, such as -3{}",
                    in_table.trim_start_matches('1')
                )
            } else {
                format!("--for {quantity}: {why}")
            }
        })?;
        // Quotients are given in the unit of the tables.
        Ok(if is_quotient { goal / factor } else { goal })
    }
}

/// Search for coordinates, masses, curves and dampers.
#[derive(Clone, Debug, PartialEq)]
pub struct TargetSearch {
    /// Unknowns.
    pub unknowns: Vec<SearchUnknown>,
    /// Required values, as many as unknowns.
    pub targets: Vec<KinematicTarget>,
    /// Largest change of each coordinate, m. A mass changes by at most half, a curve or a damping by a factor between a quarter and four.
    pub within: f64,
    /// Question of the quantity `effective_mass`; `None` without such a target.
    pub mass: Option<MassQuestion>,
    /// Speed, restitution and stiffness of the contacts, for the quantities `CONTACT.peak_force`, `CONTACT.compression` and
    /// `CONTACT.restitution`; the default stiffness
    /// is the force curve of the stop in the sheet.
    pub impact: Option<DampingQuestion>,
}

impl TargetSearch {
    /// Search of a table of a study. `mass`: question of the quantity `effective_mass`.
    ///
    /// # Errors
    /// [`InvalidKey`]: an unknown or a value without the expected form, numbers out of range.
    pub(crate) fn of_table(asked: &TargetsQuestion, mass: Option<MassQuestion>) -> Result<Self, InvalidKey> {
        let unknown = |text: &String| {
            text.parse().map_err(|why| InvalidKey::new("targets.solve", format!("{text}: {why}")))
        };
        let target = |(quantity, value): (&String, &NumberOrText)| {
            let text = format!("{quantity}={}", value.clone().text());
            text.parse().map_err(|why| InvalidKey::new("targets.values", format!("{text}: {why}")))
        };
        let Length(within) = asked.within.unwrap_or(DEFAULT_CHANGE);
        if !(within.is_finite() && within > 0.0) {
            return Err(InvalidKey::new("targets.within", format!("{within} m; more than 0 is expected")));
        }
        let with_speed = [
            ("targets.restitution", asked.restitution.is_some()),
            ("targets.stiffness", asked.stiffness.is_some()),
        ];
        if let Some((key, _)) =
            with_speed.into_iter().find(|(_, is_given)| *is_given && asked.speed.is_none())
        {
            return Err(InvalidKey::new(key, "it requires `speed`, the closing speed of the contacts"));
        }
        let impact = asked.speed.map(|speed| DampingQuestion {
            speed: Some(speed),
            restitution: asked.restitution.or(Some(Ratio(1.0))),
            stiffness: asked.stiffness,
            ..DampingQuestion::default()
        });
        impact.as_ref().map_or(Ok(()), |impact| impact.checked().map(drop))?;
        Ok(Self {
            unknowns: asked.solve.iter().map(unknown).collect::<Result<_, _>>()?,
            targets: asked.values.iter().map(target).collect::<Result<_, _>>()?,
            within,
            mass,
            impact,
        })
    }
}

/// Largest change of a coordinate without another value.
const DEFAULT_CHANGE: Length = Length(0.02);
