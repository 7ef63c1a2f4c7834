//! Quantities of a question, read from text (flags, `350mm`) or from TOML (a number in the default unit, or text).

use crate::values::value::NumberOrText;
use percuss_units::{Dimension, Quantity, QuantityError, parse_triple};
use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, Serialize};
#[cfg(feature = "flags")]
use std::any::TypeId;
use std::str::FromStr;

/// Gives a type the JSON schema of the type from which it is converted, or as which it is serialized.
macro_rules! schema_of {
    ($name:ident, $from:ty) => {
        impl schemars::JsonSchema for $name {
            fn schema_name() -> std::borrow::Cow<'static, str> {
                stringify!($name).into()
            }

            fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
                <$from>::json_schema(generator)
            }
        }
    };
}
pub(crate) use schema_of;

/// Number of a dimension, in SI units.
fn in_dimension(dimension: Dimension, text: &str) -> Result<f64, QuantityError> {
    match dimension {
        // The error for another unit names both dimensions.
        Dimension::Length | Dimension::Mass | Dimension::Angle | Dimension::Plain => {
            Quantity::parse(text)?.in_dimension(dimension, text)
        }
        _ => dimension.parse(text).map(|quantity| quantity.value),
    }
}

/// Defines types for one number of a dimension, in SI units.
macro_rules! quantities {
    ($($(#[$doc:meta])* $name:ident)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize, Serialize)]
        #[serde(try_from = "NumberOrText")]
        pub struct $name(pub f64);

        impl From<f64> for $name {
            fn from(value: f64) -> Self {
                Self(value)
            }
        }

        impl FromStr for $name {
            type Err = QuantityError;
            fn from_str(text: &str) -> Result<Self, QuantityError> {
                in_dimension(Dimension::$name, text).map(Self)
            }
        }

        impl TryFrom<NumberOrText> for $name {
            type Error = QuantityError;
            fn try_from(given: NumberOrText) -> Result<Self, QuantityError> {
                given.text().parse()
            }
        }

        schema_of!($name, NumberOrText);
    )*};
}

quantities! {
    /// Number without a unit.
    Plain
    /// Number, or per cent.
    Ratio
    /// Length, m.
    Length
    /// Mass, kg.
    Mass
    /// Time, s.
    Time
    /// Force, N.
    Force
    /// Pressure, Pa. The default unit is N/cm².
    Pressure
    /// Area, m². The default unit is cm².
    Area
    /// Energy, J.
    Energy
    /// Momentum, N·s.
    Momentum
}

/// Mass above 0, kg.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
#[serde(try_from = "NumberOrText")]
pub struct PositiveMass(pub f64);

impl FromStr for PositiveMass {
    type Err = String;
    fn from_str(text: &str) -> Result<Self, String> {
        let Mass(mass) = text.parse().map_err(|error: QuantityError| error.to_string())?;
        if mass > 0.0 { Ok(Self(mass)) } else { Err(format!("{mass} kg; a mass above 0 is expected")) }
    }
}

impl TryFrom<NumberOrText> for PositiveMass {
    type Error = String;
    fn try_from(given: NumberOrText) -> Result<Self, String> {
        given.text().parse()
    }
}

schema_of!(PositiveMass, NumberOrText);

/// Defines types for a quantity of a translation or of a rotation; the motion is known later.
macro_rules! quantities_of_a_motion {
    ($($(#[$doc:meta])* $name:ident $rotational:ident)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
        #[serde(try_from = "NumberOrText")]
        pub struct $name(pub Quantity);

        impl From<f64> for $name {
            fn from(value: f64) -> Self {
                Self(Quantity { value, dimension: None })
            }
        }

        impl FromStr for $name {
            type Err = QuantityError;
            fn from_str(text: &str) -> Result<Self, QuantityError> {
                let translation = Dimension::$name.parse(text);
                let quantity =
                    translation.or_else(|error| Dimension::$rotational.parse(text).map_err(|_| error));
                quantity.map(Self)
            }
        }

        impl TryFrom<NumberOrText> for $name {
            type Error = QuantityError;
            fn try_from(given: NumberOrText) -> Result<Self, QuantityError> {
                given.text().parse()
            }
        }

        schema_of!($name, NumberOrText);
    )*};
}

quantities_of_a_motion! {
    /// Stiffness, N/m or N·m/rad.
    Stiffness RotationalStiffness
    /// Speed, m/s or rad/s.
    Speed AngularSpeed
    /// Damping, N·s/m or N·m·s/rad.
    Damping RotationalDamping
}

/// Defines types for three numbers of a dimension, in SI units.
macro_rules! triples {
    ($($(#[$doc:meta])* $name:ident $dimension:ident)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize, Serialize)]
        #[serde(try_from = "Vec<NumberOrText>")]
        pub struct $name(pub [f64; 3]);

        impl FromStr for $name {
            type Err = QuantityError;
            fn from_str(text: &str) -> Result<Self, QuantityError> {
                parse_triple(text, Dimension::$dimension).map(Self)
            }
        }

        impl TryFrom<Vec<NumberOrText>> for $name {
            type Error = String;
            fn try_from(given: Vec<NumberOrText>) -> Result<Self, String> {
                let numbers = given.into_iter().map(|number| number.in_dimension(Dimension::$dimension));
                let numbers: Vec<f64> = numbers.collect::<Result<_, _>>().map_err(|e| e.to_string())?;
                let three = <[f64; 3]>::try_from(numbers);
                three.map(Self).map_err(|given| format!("{} numbers; expected 3", given.len()))
            }
        }

        schema_of!($name, [NumberOrText; 3]);
    )*};
}

triples! {
    /// Point, m.
    Point Length
    /// Vector of any length, without a unit.
    Vector Plain
    /// Three angles, rad.
    Angles Angle
}

/// Three moments of inertia, kg·m².
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(try_from = "Vec<NumberOrText>")]
pub struct Moments(pub [f64; 3]);

impl Moments {
    fn from_texts(texts: impl Iterator<Item = impl AsRef<str>>) -> Result<Self, String> {
        let moments = texts.map(|text| in_dimension(Dimension::Inertia, text.as_ref()));
        let moments: Vec<f64> = moments.collect::<Result<_, _>>().map_err(|error| error.to_string())?;
        let three = <[f64; 3]>::try_from(moments);
        three.map(Self).map_err(|given| format!("{} moments of inertia; expected 3", given.len()))
    }
}

impl FromStr for Moments {
    type Err = String;
    fn from_str(text: &str) -> Result<Self, String> {
        Self::from_texts(text.split(','))
    }
}

impl TryFrom<Vec<NumberOrText>> for Moments {
    type Error = String;
    fn try_from(given: Vec<NumberOrText>) -> Result<Self, String> {
        Self::from_texts(given.into_iter().map(NumberOrText::text))
    }
}

schema_of!(Moments, [NumberOrText; 3]);

/// Point of a link, m, in the frame of the link: `LINK:X,Y,Z`.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LinkPoint {
    /// The link.
    pub link: String,
    /// The point, m, in the link's frame.
    pub point: Point,
}

impl FromStr for LinkPoint {
    type Err = String;
    /// Splits at the last colon, because link names may contain colons.
    fn from_str(text: &str) -> Result<Self, String> {
        match text.rsplit_once(':') {
            Some((link, numbers)) if !link.is_empty() => {
                let point = numbers.parse().map_err(|error: QuantityError| error.to_string())?;
                Ok(Self { link: link.to_owned(), point })
            }
            _ => Err("expected LINK:X,Y,Z, such as chassis:0.3,0,0.4".into()),
        }
    }
}

/// Reads a point, m.
pub(crate) fn point<'de, D: Deserializer<'de>>(from: D) -> Result<[f64; 3], D::Error> {
    Point::deserialize(from).map(|point| point.0)
}

/// Reads a vector without a unit.
pub(crate) fn vector<'de, D: Deserializer<'de>>(from: D) -> Result<[f64; 3], D::Error> {
    Vector::deserialize(from).map(|vector| vector.0)
}

/// Reads a vector of an optional key, without a unit.
pub(crate) fn some_vector<'de, D: Deserializer<'de>>(from: D) -> Result<Option<[f64; 3]>, D::Error> {
    vector(from).map(Some)
}

/// True for a flag whose value is a number or three numbers, and may begin with a minus sign.
#[cfg(feature = "flags")]
pub fn is_number_flag(argument: &clap::Arg) -> bool {
    let of_value = argument.get_value_parser().type_id();
    let is_of = |number: TypeId| of_value == number;
    [
        TypeId::of::<Area>(),
        TypeId::of::<Damping>(),
        TypeId::of::<Energy>(),
        TypeId::of::<Force>(),
        TypeId::of::<Length>(),
        TypeId::of::<Mass>(),
        TypeId::of::<Momentum>(),
        TypeId::of::<Plain>(),
        TypeId::of::<Point>(),
        TypeId::of::<PositiveMass>(),
        TypeId::of::<Pressure>(),
        TypeId::of::<Ratio>(),
        TypeId::of::<Speed>(),
        TypeId::of::<Stiffness>(),
        TypeId::of::<Time>(),
        TypeId::of::<Vector>(),
    ]
    .into_iter()
    .any(is_of)
}
