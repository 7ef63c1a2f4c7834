//! Numbers of a study file: plain (SI), or text with a unit (`"350 mm"`).

use crate::values::position::GivenPosition;
use percuss_units::{Dimension, Quantity};
use schemars::JsonSchema;
use serde::de::Error;
use serde::{Deserialize, Deserializer};
use std::collections::BTreeMap;

/// Three numbers, or texts with units.
pub(crate) type Triple = [NumberOrText; 3];

/// A number in SI units, or text with a unit.
#[derive(Deserialize, JsonSchema)]
#[serde(untagged, expecting = "a number, or text with a unit such as \"350mm\"")]
pub(crate) enum NumberOrText {
    Number(f64),
    Text(String),
}

impl NumberOrText {
    /// Number in SI units, after a check of the dimension of its unit.
    fn in_dimension<E: Error>(self, dimension: Dimension) -> Result<f64, E> {
        match self {
            NumberOrText::Number(number) => Ok(number),
            NumberOrText::Text(text) => Quantity::parse(&text)
                .and_then(|quantity| quantity.in_dimension(dimension, &text))
                .map_err(E::custom),
        }
    }
}

/// A position: a number, numbers, or text with units.
#[derive(Deserialize, JsonSchema)]
#[serde(untagged, expecting = "a number, a list of numbers, or text with units")]
pub(crate) enum PositionText {
    Text(String),
    One(f64),
    Many(Vec<f64>),
}

/// Reads positions by joint.
pub(crate) fn positions<'de, D: Deserializer<'de>>(
    from: D,
) -> Result<BTreeMap<String, GivenPosition>, D::Error> {
    let given = |(joint, text): (String, PositionText)| {
        let position = match text {
            PositionText::Text(text) => GivenPosition::parse(&text),
            PositionText::One(x) => GivenPosition::from_numbers(&[x]),
            PositionText::Many(xs) => GivenPosition::from_numbers(&xs),
        };
        let position = position.map_err(|error| D::Error::custom(format!("joint \"{joint}\": {error}")))?;
        Ok((joint, position))
    };
    BTreeMap::<String, PositionText>::deserialize(from)?.into_iter().map(given).collect()
}

/// Deserializes three quantities of a dimension.
fn triple<'de, D: Deserializer<'de>>(from: D, dimension: Dimension) -> Result<[f64; 3], D::Error> {
    let values: Vec<f64> = Vec::<NumberOrText>::deserialize(from)?
        .into_iter()
        .map(|v| v.in_dimension(dimension))
        .collect::<Result<_, _>>()?;
    <[f64; 3]>::try_from(values)
        .map_err(|given| D::Error::custom(format!("{} numbers; expected 3", given.len())))
}

/// Reads three numbers without a unit.
pub(crate) fn plain<'de, D: Deserializer<'de>>(from: D) -> Result<Option<[f64; 3]>, D::Error> {
    triple(from, Dimension::Plain).map(Some)
}

/// Reads three lengths, m.
pub(crate) fn lengths<'de, D: Deserializer<'de>>(from: D) -> Result<[f64; 3], D::Error> {
    triple(from, Dimension::Length)
}

/// Reads three lengths of an optional key, m.
pub(crate) fn some_lengths<'de, D: Deserializer<'de>>(from: D) -> Result<Option<[f64; 3]>, D::Error> {
    lengths(from).map(Some)
}

/// Reads three angles, rad.
pub(crate) fn angles<'de, D: Deserializer<'de>>(from: D) -> Result<[f64; 3], D::Error> {
    triple(from, Dimension::Angle)
}

/// Deserializes a number with a unit of a dimension.
fn parse_measure<'de, D: Deserializer<'de>>(from: D, dimension: Dimension) -> Result<f64, D::Error> {
    match NumberOrText::deserialize(from)? {
        NumberOrText::Number(number) => Ok(number),
        NumberOrText::Text(text) => dimension.parse(&text).map(|m| m.value).map_err(D::Error::custom),
    }
}

/// Reads a number from 0 to 1, or per cent.
pub(crate) fn ratio<'de, D: Deserializer<'de>>(from: D) -> Result<f64, D::Error> {
    parse_measure(from, Dimension::Ratio)
}

/// Reads an optional number from 0 to 1, or per cent.
pub(crate) fn some_ratio<'de, D: Deserializer<'de>>(from: D) -> Result<Option<f64>, D::Error> {
    ratio(from).map(Some)
}

/// Reads a quantity of a contact or of a rotating joint; the application is determined later.
fn measured_with_either_unit<'de, D: Deserializer<'de>>(
    from: D,
    dimension: Dimension,
    rotational: Dimension,
) -> Result<Quantity, D::Error> {
    match NumberOrText::deserialize(from)? {
        NumberOrText::Number(value) => Ok(Quantity { value, dimension: None }),
        NumberOrText::Text(text) => {
            let read = dimension.parse(&text).or_else(|error| rotational.parse(&text).map_err(|_| error));
            read.map_err(D::Error::custom)
        }
    }
}

/// Reads a stiffness, N/m or N·m/rad.
pub(crate) fn stiffness<'de, D: Deserializer<'de>>(from: D) -> Result<Quantity, D::Error> {
    measured_with_either_unit(from, Dimension::Stiffness, Dimension::RotationalStiffness)
}

/// Reads a speed, m/s or rad/s.
pub(crate) fn speed<'de, D: Deserializer<'de>>(from: D) -> Result<Option<Quantity>, D::Error> {
    measured_with_either_unit(from, Dimension::Speed, Dimension::AngularSpeed).map(Some)
}

/// Reads a force, N.
pub(crate) fn force<'de, D: Deserializer<'de>>(from: D) -> Result<Option<f64>, D::Error> {
    in_default_unit(from, Dimension::Force).map(Some)
}

/// Reads a pressure in Pa; a plain number is in N/cm².
pub(crate) fn pressure<'de, D: Deserializer<'de>>(from: D) -> Result<Option<f64>, D::Error> {
    in_default_unit(from, Dimension::Pressure).map(Some)
}

/// Reads an area in m²; a plain number is in cm².
pub(crate) fn area<'de, D: Deserializer<'de>>(from: D) -> Result<Option<f64>, D::Error> {
    in_default_unit(from, Dimension::Area).map(Some)
}

/// Reads an energy, J.
pub(crate) fn energy<'de, D: Deserializer<'de>>(from: D) -> Result<Option<f64>, D::Error> {
    in_default_unit(from, Dimension::Energy).map(Some)
}

/// Reads a momentum, N·s.
pub(crate) fn momentum<'de, D: Deserializer<'de>>(from: D) -> Result<Option<f64>, D::Error> {
    in_default_unit(from, Dimension::Momentum).map(Some)
}

/// Reads a number in the default unit, as on the command line, or text with a unit.
fn in_default_unit<'de, D: Deserializer<'de>>(from: D, dimension: Dimension) -> Result<f64, D::Error> {
    let text = match NumberOrText::deserialize(from)? {
        NumberOrText::Number(number) => number.to_string(),
        NumberOrText::Text(text) => text,
    };
    dimension.parse(&text).map(|m| m.value).map_err(D::Error::custom)
}

/// Reads a time, s.
pub(crate) fn time<'de, D: Deserializer<'de>>(from: D) -> Result<Option<f64>, D::Error> {
    parse_measure(from, Dimension::Time).map(Some)
}

/// One word, or several.
#[derive(Deserialize, JsonSchema)]
#[serde(untagged, expecting = "a name, or a list of names")]
pub(crate) enum Words {
    One(String),
    Many(Vec<String>),
}

/// Reads one word or several words.
pub(crate) fn words<'de, D: Deserializer<'de>>(from: D) -> Result<Vec<String>, D::Error> {
    Ok(match Words::deserialize(from)? {
        Words::One(word) => vec![word],
        Words::Many(words) => words,
    })
}

/// Reads directions without a unit.
pub(crate) fn directions<'de, D: Deserializer<'de>>(from: D) -> Result<Vec<[f64; 3]>, D::Error> {
    let read = |numbers: Vec<f64>| {
        <[f64; 3]>::try_from(numbers)
            .map_err(|given| D::Error::custom(format!("{} numbers; expected 3", given.len())))
    };
    Vec::<Vec<f64>>::deserialize(from)?.into_iter().map(read).collect()
}

/// Reads the two ends of an axis.
pub(crate) fn ends<'de, D: Deserializer<'de>>(from: D) -> Result<Option<(f64, f64)>, D::Error> {
    match Vec::<f64>::deserialize(from)?[..] {
        [from, to] if from < to && from.is_finite() && to.is_finite() => Ok(Some((from, to))),
        [from, to] => Err(D::Error::custom(format!("{from} is not below {to}"))),
        ref other => Err(D::Error::custom(format!("{} numbers; expected 2, from and to", other.len()))),
    }
}

/// Reads masses by link, kg.
pub(crate) fn masses<'de, D: Deserializer<'de>>(from: D) -> Result<BTreeMap<String, f64>, D::Error> {
    let read = |(link, mass): (String, NumberOrText)| {
        let mass = mass.in_dimension::<D::Error>(Dimension::Mass);
        mass.map(|mass| (link.clone(), mass)).map_err(|e| D::Error::custom(format!("link \"{link}\": {e}")))
    };
    BTreeMap::<String, NumberOrText>::deserialize(from)?.into_iter().map(read).collect()
}

/// Reads points by name, m.
pub(crate) fn places<'de, D: Deserializer<'de>>(from: D) -> Result<BTreeMap<String, [f64; 3]>, D::Error> {
    let read = |(name, place): (String, Vec<NumberOrText>)| {
        let place: Result<Vec<f64>, D::Error> =
            place.into_iter().map(|number| number.in_dimension(Dimension::Length)).collect();
        let place = place.and_then(|place| {
            <[f64; 3]>::try_from(place)
                .map_err(|given| D::Error::custom(format!("{} numbers; expected 3", given.len())))
        });
        place.map(|place| (name.clone(), place)).map_err(|e| D::Error::custom(format!("\"{name}\": {e}")))
    };
    BTreeMap::<String, Vec<NumberOrText>>::deserialize(from)?.into_iter().map(read).collect()
}

/// Reads armatures by joint: one value, or one value per velocity.
pub(crate) fn armatures<'de, D: Deserializer<'de>>(from: D) -> Result<BTreeMap<String, Vec<f64>>, D::Error> {
    let read = |(joint, values)| match values {
        OneOrMany::One(x) => (joint, vec![x]),
        OneOrMany::Many(xs) => (joint, xs),
    };
    Ok(BTreeMap::<String, OneOrMany>::deserialize(from)?.into_iter().map(read).collect())
}

/// A number, or a list of numbers.
#[derive(Deserialize, JsonSchema)]
#[serde(untagged, expecting = "a number, or a list of numbers")]
pub(crate) enum OneOrMany {
    One(f64),
    Many(Vec<f64>),
}

/// Reads a length, m.
pub(crate) fn length<'de, D: Deserializer<'de>>(from: D) -> Result<Option<f64>, D::Error> {
    NumberOrText::deserialize(from)?.in_dimension(Dimension::Length).map(Some)
}

/// Reads a mass, kg.
pub(crate) fn mass<'de, D: Deserializer<'de>>(from: D) -> Result<Option<f64>, D::Error> {
    NumberOrText::deserialize(from)?.in_dimension(Dimension::Mass).map(Some)
}

/// Reads a mass, kg.
pub(crate) fn load<'de, D: Deserializer<'de>>(from: D) -> Result<f64, D::Error> {
    NumberOrText::deserialize(from)?.in_dimension(Dimension::Mass)
}
