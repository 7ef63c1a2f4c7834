//! Values of a study file that have several forms in TOML: a number or text with a unit (`"350 mm"`), one value or a list, a
//! table of names.

use crate::values::position::GivenPosition;
use percuss_units::{Dimension, Quantity, QuantityError};
use schemars::JsonSchema;
use serde::de::{DeserializeOwned, Error};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::collections::BTreeMap;
use std::fmt::Display;
use std::path::Path;
use std::str::FromStr;

/// A number in SI units, or text with a unit.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged, expecting = "a number, or text with a unit such as \"350mm\"")]
pub enum NumberOrText {
    /// Number in the default unit.
    Number(f64),
    /// Text with a unit.
    Text(String),
}

impl NumberOrText {
    /// Text as on the command line.
    pub(crate) fn text(self) -> String {
        match self {
            NumberOrText::Number(number) => number.to_string(),
            NumberOrText::Text(text) => text,
        }
    }

    /// Number in SI units, after a check of the dimension of its unit.
    pub(crate) fn in_dimension(self, dimension: Dimension) -> Result<f64, QuantityError> {
        match self {
            NumberOrText::Number(number) => Ok(number),
            NumberOrText::Text(text) => Quantity::parse(&text)?.in_dimension(dimension, &text),
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

/// A value, or a list of values.
#[derive(Deserialize, JsonSchema)]
#[serde(untagged, expecting = "a value, or a list of values")]
pub(crate) enum OneOrMany<T> {
    One(T),
    Many(Vec<T>),
}

impl<T> OneOrMany<T> {
    /// The values as a list.
    pub(crate) fn list(self) -> Vec<T> {
        match self {
            OneOrMany::One(one) => vec![one],
            OneOrMany::Many(many) => many,
        }
    }
}

/// One word, or several.
#[derive(Deserialize, JsonSchema)]
#[serde(untagged, expecting = "a name, or a list of names")]
pub(crate) enum Words {
    One(String),
    Many(Vec<String>),
}

/// Path relative to a folder; an absolute path is kept.
pub(crate) fn path_in(folder: &Path, path: &str) -> String {
    folder.join(path).to_string_lossy().into_owned()
}

/// Reads one value or several.
pub(crate) fn one_or_many<'de, D: Deserializer<'de>, T: Deserialize<'de>>(
    from: D,
) -> Result<Vec<T>, D::Error> {
    Ok(OneOrMany::deserialize(from)?.list())
}

/// Reads one word or several words, each parsed as on the command line.
pub(crate) fn words<'de, D: Deserializer<'de>, T: FromStr<Err: Display>>(
    from: D,
) -> Result<Vec<T>, D::Error> {
    let words = match Words::deserialize(from)? {
        Words::One(word) => vec![word],
        Words::Many(words) => words,
    };
    let read = |word: String| word.parse().map_err(|error| D::Error::custom(format!("\"{word}\": {error}")));
    words.into_iter().map(read).collect()
}

/// Reads one word, parsed as on the command line.
pub(crate) fn word<'de, D: Deserializer<'de>, T: FromStr<Err: Display>>(from: D) -> Result<T, D::Error> {
    let word = String::deserialize(from)?;
    word.parse().map_err(|error| D::Error::custom(format!("\"{word}\": {error}")))
}

/// Reads an optional word, parsed as on the command line.
pub(crate) fn some_word<'de, D: Deserializer<'de>, T: FromStr<Err: Display>>(
    from: D,
) -> Result<Option<T>, D::Error> {
    word(from).map(Some)
}

/// Reads a table of names in the order of the names.
pub(crate) fn by_name<'de, D: Deserializer<'de>, T: DeserializeOwned>(
    from: D,
) -> Result<Vec<(String, T)>, D::Error> {
    Ok(BTreeMap::<String, T>::deserialize(from)?.into_iter().collect())
}

/// Reads positions by joint.
pub(crate) fn positions<'de, D: Deserializer<'de>>(
    from: D,
) -> Result<Vec<(String, GivenPosition)>, D::Error> {
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

/// Values by name, as a table.
pub(crate) mod named_values {
    pub(crate) use super::{by_name as deserialize, by_name_entries as serialize};
}

/// Armatures by joint, as a table.
pub(crate) mod named_armatures {
    pub(crate) use super::{armatures as deserialize, by_name_entries as serialize};
}

/// Positions by joint, as a table of texts.
pub(crate) mod named_positions {
    pub(crate) use super::{by_name_texts as serialize, positions as deserialize};
}

/// Words, as a list of texts.
pub(crate) mod text_list {
    pub(crate) use super::{texts as serialize, words as deserialize};
}

/// Writes values as a list of texts.
pub(crate) fn texts<S: Serializer, T: Display>(values: &[T], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(values.iter().map(ToString::to_string))
}

/// Writes values by name.
pub(crate) fn by_name_entries<S: Serializer, T: Serialize>(
    values: &[(String, T)],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.collect_map(values.iter().map(|(name, value)| (name, value)))
}

/// Writes texts by name.
pub(crate) fn by_name_texts<S: Serializer, T: Display>(
    values: &[(String, T)],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.collect_map(values.iter().map(|(name, value)| (name, value.to_string())))
}

/// Reflected inertias separated by commas (kg·m² or kg, optional units), each a value or RATIO:ROTOR, the ratio of a gear and the inertia of
/// the rotor about its own axis: ratio² · inertia.
pub(crate) fn reflected_inertias(text: &str) -> Result<Vec<f64>, String> {
    let inertia = |text: &str, dimensions: &[Dimension]| {
        Quantity::parse_as(text, dimensions)
            .map(|inertia| inertia.value)
            .map_err(|error: QuantityError| error.to_string())
    };
    let one = |part: &str| match part.split_once(':') {
        Some((ratio, rotor)) => {
            let ratio = Dimension::Plain.parse(ratio).map_err(|error| error.to_string())?.value;
            if ratio == 0.0 {
                return Err(format!(
                    "{part}: the ratio of the gear is 0; rotor turns per turn of the joint are expected, such as 100"
                ));
            }
            Ok(ratio * ratio * inertia(rotor, &[Dimension::Inertia])?)
        }
        None => inertia(part, &[Dimension::Inertia, Dimension::Mass]),
    };
    text.split(',').map(one).collect()
}

/// `shapes` or `shapes:DENSITY`: density of the shapes, kg/m³.
pub(crate) fn density_of_shapes(text: &str) -> Result<f64, String> {
    let density = match text.split_once(':') {
        Some(("shapes", density)) => {
            density.trim().trim_end_matches("kg/m3").trim_end_matches("kg/m³").trim().parse().ok()
        }
        None if text == "shapes" => Some(1e3),
        _ => None,
    };
    let valid = density.filter(|density: &f64| density.is_finite() && *density > 0.0);
    valid.ok_or_else(|| {
        format!(
            "\"{text}\"; shapes is expected, or shapes:DENSITY with a density in kg/m³, such as shapes:2700"
        )
    })
}

/// Reads the density of the shapes, as on the command line.
pub(crate) fn shape_density<'de, D: Deserializer<'de>>(from: D) -> Result<Option<f64>, D::Error> {
    let text = String::deserialize(from)?;
    density_of_shapes(&text).map(Some).map_err(D::Error::custom)
}

/// Writes the density of the shapes.
pub(crate) fn shape_density_text<S: Serializer>(
    density: &Option<f64>,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.collect_str(&format_args!("shapes:{}", density.unwrap_or(1e3)))
}

/// Reads armatures by joint: one value, or one value per velocity, or text as on the command line.
pub(crate) fn armatures<'de, D: Deserializer<'de>>(from: D) -> Result<Vec<(String, Vec<f64>)>, D::Error> {
    let given = |(joint, values): (String, PositionText)| {
        let values = match values {
            PositionText::Text(text) => reflected_inertias(&text)
                .map_err(|error| D::Error::custom(format!("joint \"{joint}\": {error}")))?,
            PositionText::One(x) => vec![x],
            PositionText::Many(xs) => xs,
        };
        Ok((joint, values))
    };
    by_name::<D, PositionText>(from)?.into_iter().map(given).collect()
}
