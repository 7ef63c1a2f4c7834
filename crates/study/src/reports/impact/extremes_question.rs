//! Question about extremes over positions.

use crate::evaluation::status::mass_unit;
use crate::question::errors::question_error::StudyError;
use crate::question::field::Field;
use crate::question::mass_question::triples;
use crate::question::row_source::RowSource;
use crate::reports::impact::additions::find_joint;
use percuss_impact::{NormalRange, SearchedQuantity};
use percuss_mechanism::{JointKind, Mechanism};
use percuss_units::{Dimension, Quantity};

/// Positions of the search, quantity and number of starts.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ExtremesQuestion {
    /// Ranges of the joints that vary. Empty for the limits of all driving joints with limits, except (without `keep`) those with a given
    /// position.
    pub ranges: Vec<GivenRange>,
    /// Links and points that stay in place over the ranges: the search covers the self-motion of the mechanism.
    pub keep: Vec<Keep>,
    /// Path of positions, in place of `ranges` and `keep`; `None` for a search over ranges.
    pub path: Option<RowSource>,
    /// Quantity whose extremes are searched.
    pub quantity: GivenQuantity,
    /// Normals among which the extremes are searched.
    pub normals: GivenNormals,
    /// Number of starts of the search; 0 for the default.
    pub starts: usize,
}

/// Normals of the contact among which extremes are searched.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct GivenNormals(pub NormalRange);

impl std::str::FromStr for GivenNormals {
    type Err = String;
    /// Reads `given`, `any` or `across:X,Y,Z`.
    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "given" => return Ok(Self(NormalRange::Given)),
            "any" => return Ok(Self(NormalRange::Any)),
            _ => {}
        }
        let wrong = || "expected given, any or across:X,Y,Z (world axes), such as across:0,0,1".to_owned();
        let axis = text.strip_prefix("across:").ok_or_else(wrong)?;
        let axis = percuss_units::parse_triple(axis, Dimension::Plain)
            .map_err(|error| format!("across:X,Y,Z is expected: {error}"))?;
        Ok(Self(NormalRange::Across(axis.into())))
    }
}

/// Quantity whose extremes are searched.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum GivenQuantity {
    /// Effective mass of the contact.
    #[default]
    Mass,
    /// Inertia reflected to a joint, with the other drivers free.
    Reflected(String),
    /// Inertia reflected to a joint, with the other drivers at rest.
    Held(String),
    /// Impulse in the bearing of a joint per closing speed, of a plastic impact.
    Bearing(String),
}

impl std::str::FromStr for GivenQuantity {
    type Err = String;
    /// Reads `mass`, `reflected:JOINT`, `held:JOINT` or `bearing:JOINT`.
    fn from_str(text: &str) -> Result<Self, String> {
        if text == "mass" {
            return Ok(Self::Mass);
        }
        match text.split_once(':') {
            Some(("reflected", joint)) => Ok(Self::Reflected(joint.to_owned())),
            Some(("held", joint)) => Ok(Self::Held(joint.to_owned())),
            Some(("bearing", joint)) => Ok(Self::Bearing(joint.to_owned())),
            _ => Err("expected mass, reflected:JOINT, held:JOINT or bearing:JOINT".to_owned()),
        }
    }
}

impl GivenQuantity {
    /// Name of the quantity in reports: `effective_mass`, `reflected_inertia`, `held_inertia` or `bearing_impulse`.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Mass => "effective_mass",
            Self::Reflected(_) => "reflected_inertia",
            Self::Held(_) => "held_inertia",
            Self::Bearing(_) => "bearing_impulse",
        }
    }

    /// Joint of the quantity; `None` for the effective mass.
    pub fn joint(&self) -> Option<&str> {
        match self {
            Self::Mass => None,
            Self::Reflected(joint) | Self::Held(joint) | Self::Bearing(joint) => Some(joint),
        }
    }

    /// Quantity of the search, and its unit. `is_moment`: the contact is a moment about an axis.
    pub(crate) fn searched(
        &self,
        mechanism: &Mechanism,
        is_moment: bool,
    ) -> Result<(SearchedQuantity, &'static str), StudyError> {
        let Some(name) = self.joint() else {
            return Ok((SearchedQuantity::EffectiveMass, mass_unit(is_moment)));
        };
        let joint = find_joint(mechanism, Field::Quantity, name)?;
        let held = matches!(self, Self::Held(_));
        Ok(match (self, mechanism.joint(joint).kind()) {
            (Self::Bearing(_), _) => {
                (SearchedQuantity::BearingImpulse { joint }, if is_moment { "kg·m" } else { "kg" })
            }
            (_, JointKind::Prismatic) => (SearchedQuantity::ReflectedInertia { joint, held }, "kg"),
            _ => (SearchedQuantity::ReflectedInertia { joint, held }, "kg·m²"),
        })
    }
}

/// Range of a joint.
#[derive(Clone, Debug, PartialEq)]
pub struct GivenRange {
    /// The joint.
    pub joint: String,
    /// Lower end.
    pub lower: Quantity,
    /// Upper end.
    pub upper: Quantity,
}

impl std::str::FromStr for GivenRange {
    type Err = String;
    /// Reads `JOINT=FROM:TO`.
    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || "expected JOINT=FROM:TO, such as elbow=10deg:170deg".to_owned();
        let (joint, range) =
            text.rsplit_once('=').filter(|(joint, _)| !joint.is_empty()).ok_or_else(wrong)?;
        let (lower, upper) = range.split_once(':').ok_or_else(wrong)?;
        let end = |text: &str| Quantity::parse(text).map_err(|error| error.to_string());
        Ok(Self { joint: joint.to_owned(), lower: end(lower)?, upper: end(upper)? })
    }
}

/// Link or point that stays in place: a link with its orientation, a point of a link (m, link's frame), or the coordinate of this point
/// along a direction (world axes).
#[derive(Clone, Debug, PartialEq)]
pub struct Keep {
    /// The link.
    pub link: String,
    /// The point; `None` for the position and the orientation of the link.
    pub point: Option<[f64; 3]>,
    /// The direction; `None` for all directions.
    pub normal: Option<[f64; 3]>,
}

impl std::str::FromStr for Keep {
    type Err = String;
    /// Reads `LINK`, `LINK:X,Y,Z` or `LINK:X,Y,Z:NX,NY,NZ`.
    fn from_str(text: &str) -> Result<Self, String> {
        let (link, found) = triples(text);
        if link.is_empty() {
            return Err("expected LINK, LINK:X,Y,Z or LINK:X,Y,Z:NX,NY,NZ, such as tool:0,0,0.1".into());
        }
        let read = |text: &&str, dimension| percuss_units::parse_triple(text, dimension);
        let point = found.first().map(|text| read(text, Dimension::Length)).transpose();
        let normal = found.get(1).map(|text| read(text, Dimension::Plain)).transpose();
        Ok(Self {
            link: link.to_owned(),
            point: point.map_err(|error| error.to_string())?,
            normal: normal.map_err(|error| error.to_string())?,
        })
    }
}
