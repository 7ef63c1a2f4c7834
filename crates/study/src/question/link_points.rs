//! Points of links in a question: held contacts, the classical estimate and motion ratios.

use crate::values::quantities::{self, Point, Vector};
use percuss_units::QuantityError;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::str::FromStr;

/// Held contact: a point (m, link's frame) of a link that stays in place along a normal (world axes, out of the
/// link) or in all directions.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Hold {
    /// The link.
    pub link: String,
    /// The point, m, in the link's frame.
    #[serde(deserialize_with = "quantities::point")]
    #[schemars(with = "Point")]
    pub point: [f64; 3],
    /// The normal, world axes, out of the link; without a normal all directions are held.
    #[serde(default, deserialize_with = "quantities::some_vector", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<Vector>")]
    pub normal: Option<[f64; 3]>,
}

/// Splits `NAME[:X,Y,Z[:X,Y,Z]]` into the name, which may contain colons, and the texts of the triples.
pub(crate) fn triples(text: &str) -> (&str, Vec<&str>) {
    let (mut name, mut found) = (text, Vec::new());
    while found.len() < 2
        && let Some((rest, last)) = name.rsplit_once(':')
        && last.contains(',')
        && last.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c))
    {
        found.insert(0, last);
        name = rest;
    }
    (name, found)
}

/// Point of a flag.
fn parse_point(text: &str) -> Result<[f64; 3], String> {
    text.parse().map(|Point(point)| point).map_err(|error: QuantityError| error.to_string())
}

/// Vector of a flag.
fn parse_vector(text: &str) -> Result<[f64; 3], String> {
    text.parse().map(|Vector(vector)| vector).map_err(|error: QuantityError| error.to_string())
}

impl FromStr for Hold {
    type Err = String;
    /// Reads `LINK:X,Y,Z[:NX,NY,NZ]`.
    fn from_str(text: &str) -> Result<Self, String> {
        let (link, found) = triples(text);
        let (point, normal) = match found[..] {
            [point] => (point, None),
            [point, normal] => (point, Some(parse_vector(normal)?)),
            _ => return Err("expected LINK:X,Y,Z or LINK:X,Y,Z:NX,NY,NZ, such as foot:0,0,0:0,0,-1".into()),
        };
        Ok(Self { link: link.to_owned(), point: parse_point(point)?, normal })
    }
}

/// Request for the classical estimate: mass of some links, moving with a point of the first link.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EstimateQuestion {
    /// Links with a mass counted in the estimate.
    pub links: Vec<String>,
    /// Point A, m, in the first link's frame; default origin.
    #[serde(default, deserialize_with = "quantities::point")]
    #[schemars(with = "Option<Point>")]
    pub point: [f64; 3],
    /// Direction of the counted component of A's velocity, world axes; default: upwards in a suspension, otherwise the full speed.
    #[serde(default, deserialize_with = "quantities::some_vector", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<Vector>")]
    pub direction: Option<[f64; 3]>,
}

impl FromStr for EstimateQuestion {
    type Err = String;
    /// Reads `LINK[,LINK…][:X,Y,Z[:DX,DY,DZ]]`.
    fn from_str(text: &str) -> Result<Self, String> {
        let (links, found) = triples(text);
        let links: Vec<String> = links.split(',').map(str::to_owned).collect();
        if links.iter().any(String::is_empty) {
            return Err(
                "expected LINK[,LINK…][:X,Y,Z[:DX,DY,DZ]], such as spindle,upright:0,0,0:0,0,1".into()
            );
        }
        let point = found.first().map_or(Ok([0.0; 3]), |text| parse_point(text))?;
        let direction = found.get(1).map(|text| parse_vector(text)).transpose()?;
        Ok(Self { links, point, direction })
    }
}

/// Default direction of a motion ratio: upwards, as for wheel travel.
pub const UPWARDS: [f64; 3] = [0.0, 0.0, 1.0];

/// Point of a motion ratio relative to the contact.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RatioPoint {
    /// The link.
    pub link: String,
    /// The point, m, in the link's frame.
    #[serde(default, deserialize_with = "quantities::point")]
    #[schemars(with = "Option<Point>")]
    pub point: [f64; 3],
    /// Direction of the speed, world axes, of any length; default z.
    #[serde(default = "upwards", deserialize_with = "quantities::vector")]
    #[schemars(with = "Option<Vector>")]
    pub direction: [f64; 3],
}

/// Default of the `direction` key.
fn upwards() -> [f64; 3] {
    UPWARDS
}

impl FromStr for RatioPoint {
    type Err = String;
    /// Reads `LINK:X,Y,Z[:DX,DY,DZ]`.
    fn from_str(text: &str) -> Result<Self, String> {
        let (link, found) = triples(text);
        let (point, direction) = match found[..] {
            [point] => (point, UPWARDS),
            [point, direction] => (point, parse_vector(direction)?),
            _ => return Err("expected LINK:X,Y,Z or LINK:X,Y,Z:DX,DY,DZ, such as wheel:0,0,0:0,0,1".into()),
        };
        Ok(Self { link: link.to_owned(), point: parse_point(point)?, direction })
    }
}
