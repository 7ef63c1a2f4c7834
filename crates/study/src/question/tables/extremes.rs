//! Question about extremes over positions.

use super::damping::{DampingQuestion, LawName, SeparationName};
#[cfg(feature = "flags")]
use super::headings::{ANSWER, IMPACT};
use crate::question::errors::refusal::InvalidKey;
use crate::question::link_points::triples;
use crate::question::row_source::{PositionFile, RowSource};
use crate::question::travel::vary::Vary;
use crate::values::quantities::{Plain, Ratio, Speed, Stiffness};
use crate::values::value::{self, Words};
use percuss_formats::DEFAULT_MAX_SIZE;
use percuss_impact::NormalRange;
use percuss_units::{Dimension, Quantity};
use schemars::JsonSchema;
use serde::Deserialize;
use std::f64::consts::FRAC_PI_2;
use std::path::Path;
use std::str::FromStr;

/// Number of starts without a given one.
pub(crate) const DEFAULT_STARTS: usize = 32;
/// Largest number of starts.
pub(crate) const MOST_STARTS: usize = 2_000;

/// Number of boxes of a proof without a given one.
pub(crate) const DEFAULT_BOXES: u32 = 200_000;
/// Largest number of boxes of a proof.
const MOST_BOXES: u32 = 100_000_000;

/// Path of positions: a file, or a range of a joint or a travel.
#[derive(Clone, Debug, PartialEq)]
pub struct GivenPath(pub RowSource);

impl FromStr for GivenPath {
    type Err = String;
    /// Reads a range `QUANTITY=FROM:TO:COUNT`, or the name of a file; `-` is the standard input. A name with an equals sign ends in .csv
    /// or .parquet.
    fn from_str(text: &str) -> Result<Self, String> {
        let is_file = Path::new(text)
            .extension()
            .is_some_and(|end| ["csv", "parquet"].iter().any(|kind| end.eq_ignore_ascii_case(kind)));
        if is_file || !text.contains('=') {
            let (path, ignore, max_size) = (text.to_owned(), Vec::new(), DEFAULT_MAX_SIZE);
            return Ok(Self(RowSource::File(PositionFile { path, ignore, max_size })));
        }
        let range = Vary::parse(text).map(|range| Self(range.into()));
        range.map_err(|error| {
            format!("a file of positions, or a range such as heave=-80mm:80mm:33, is expected: {error}")
        })
    }
}

/// Normals of the contact among which extremes are searched.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct GivenNormals(pub NormalRange);

impl FromStr for GivenNormals {
    type Err = String;
    /// Reads `given`, `any`, `across:X,Y,Z` or `cone:ANGLE`.
    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "given" => return Ok(Self(NormalRange::Given)),
            "any" => return Ok(Self(NormalRange::Any)),
            _ => {}
        }
        if let Some(angle) = text.strip_prefix("cone:") {
            let found = Quantity::parse(angle).and_then(|found| found.in_dimension(Dimension::Angle, angle));
            let angle = found.map_err(|error| format!("cone:ANGLE is expected: {error}"))?;
            return match (0.0..=FRAC_PI_2).contains(&angle) && angle > 0.0 {
                true => Ok(Self(NormalRange::Cone(angle))),
                false => Err("expected a cone:ANGLE of more than 0 and at most 90deg".to_owned()),
            };
        }
        let wrong = || {
            "expected given, any, across:X,Y,Z (world axes) or cone:ANGLE, such as across:0,0,1 or cone:15deg"
                .to_owned()
        };
        let axis = text.strip_prefix("across:").ok_or_else(wrong)?;
        let axis = percuss_units::parse_triple(axis, Dimension::Plain)
            .map_err(|error| format!("across:X,Y,Z is expected: {error}"))?;
        Ok(Self(NormalRange::Across(axis.into())))
    }
}

/// Edge of a patch of contact points, in the frame of the contact link, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GivenEdge(pub [f64; 3]);

impl FromStr for GivenEdge {
    type Err = String;
    /// Reads `X,Y,Z`, other than 0,0,0.
    fn from_str(text: &str) -> Result<Self, String> {
        let edge = percuss_units::parse_triple(text, Dimension::Length)
            .map_err(|error| format!("X,Y,Z of an edge is expected: {error}"))?;
        match edge.iter().any(|x| *x != 0.0) {
            true => Ok(Self(edge)),
            false => Err("the edge has no length; expected X,Y,Z other than 0,0,0".to_owned()),
        }
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
    /// Impulse in a bearing (joint, closure or `ground`) per closing speed, of a plastic impact.
    Bearing(String),
    /// Peak force in a bearing with the contact law of the question.
    Peak(String),
}

impl FromStr for GivenQuantity {
    type Err = String;
    /// Reads `mass`, `reflected:JOINT`, `held:JOINT`, `bearing:JOINT` or `peak:JOINT`.
    fn from_str(text: &str) -> Result<Self, String> {
        if text == "mass" {
            return Ok(Self::Mass);
        }
        match text.split_once(':') {
            Some(("reflected", joint)) => Ok(Self::Reflected(joint.to_owned())),
            Some(("held", joint)) => Ok(Self::Held(joint.to_owned())),
            Some(("bearing", joint)) => Ok(Self::Bearing(joint.to_owned())),
            Some(("peak", joint)) => Ok(Self::Peak(joint.to_owned())),
            _ => Err("expected mass, reflected:JOINT, held:JOINT, bearing:JOINT or peak:JOINT; for bearing and peak, JOINT can also be a \
                      loop closure or ground"
                .to_owned()),
        }
    }
}

impl GivenQuantity {
    /// Name of the quantity in reports: `effective_mass`, `reflected_inertia`, `held_inertia`, `bearing_impulse` or `bearing_peak_force`.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Mass => "effective_mass",
            Self::Reflected(_) => "reflected_inertia",
            Self::Held(_) => "held_inertia",
            Self::Bearing(_) => "bearing_impulse",
            Self::Peak(_) => "bearing_peak_force",
        }
    }

    /// Joint or bearing of the quantity; `None` for the effective mass.
    pub fn joint(&self) -> Option<&str> {
        match self {
            Self::Mass => None,
            Self::Reflected(joint) | Self::Held(joint) | Self::Bearing(joint) | Self::Peak(joint) => {
                Some(joint)
            }
        }
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

impl FromStr for GivenRange {
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

impl FromStr for Keep {
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

/// Smallest and largest effective mass of the contact, or another quantity, over positions.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::Args), command(next_help_heading = ANSWER))]
#[serde(deny_unknown_fields, default)]
pub struct ExtremesQuestion {
    /// Range of a driving joint, JOINT=FROM:TO; default: the limits of all.
    ///
    /// With a range only the given joints vary, and the other joints are held at their set positions (0 without one). Without ranges all
    /// driving joints with limits vary over their limits, except those with a set position.
    #[cfg_attr(feature = "flags", arg(long, value_name = "JOINT=FROM:TO", allow_hyphen_values = true))]
    #[serde(deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub range: Vec<GivenRange>,
    /// Link or point that stays in place: LINK, LINK:X,Y,Z, LINK:X,Y,Z:NX,NY,NZ.
    ///
    /// The search covers the self-motion, for example of a redundant arm with a fixed tool point. LINK keeps position and orientation;
    /// with a direction (world axes) only the coordinate of the point (m, link's frame) along it is kept. The place is that at the set
    /// pose, and joints with a set position vary too. The point is free in the impact, unlike a held point.
    #[cfg_attr(feature = "flags", arg(long, value_name = "LINK[:X,Y,Z]"))]
    #[serde(deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub keep: Vec<Keep>,
    /// Path instead of ranges: FILE.csv, FILE.parquet, or a travel such as heave=FROM:TO:COUNT.
    ///
    /// The rows of the file are positions as for percuss sweep; the drivers move on straight lines between them. In place of a file, the
    /// range of a joint or of a travel gives the rows.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "FILE|RANGE", allow_hyphen_values = true, conflicts_with_all = ["range", "keep"])
    )]
    #[serde(deserialize_with = "value::some_word")]
    #[schemars(with = "Option<String>")]
    pub path: Option<GivenPath>,
    /// Ignore a column of the file of the path.
    #[cfg_attr(feature = "flags", arg(long, value_name = "COLUMN", requires = "path"))]
    #[serde(deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub ignore: Vec<String>,
    /// Quantity: mass, reflected:JOINT, held:JOINT, bearing:JOINT, peak:JOINT.
    ///
    /// reflected, held: inertia at a joint with the other drivers free, or at rest. bearing: impulse in a joint, per closing speed of a
    /// plastic impact; an impact with the restitution e has (1+e) times this impulse. peak: peak force in a joint (N), with the contact law
    /// given by stiffness, restitution and speed. For bearing and peak, JOINT can also be a loop closure, or ground.
    #[cfg_attr(feature = "flags", arg(long, value_name = "QUANTITY"))]
    #[serde(deserialize_with = "value::some_word")]
    #[schemars(with = "Option<String>")]
    pub quantity: Option<GivenQuantity>,
    /// Stiffness of the contact (N/m; 200N/mm), for peak:JOINT.
    #[cfg_attr(feature = "flags", arg(long, value_name = "K", help_heading = IMPACT))]
    pub stiffness: Option<Stiffness>,
    /// Coefficient of restitution, from 0 to 1, for peak:JOINT.
    #[cfg_attr(feature = "flags", arg(long, value_name = "E", help_heading = IMPACT))]
    pub restitution: Option<Ratio>,
    /// Closing speed (m/s, km/h; rad/s for a moment), for peak:JOINT.
    #[cfg_attr(feature = "flags", arg(long, value_name = "V", help_heading = IMPACT))]
    pub speed: Option<Speed>,
    /// Exponent p of the spring force k x^p, for peak:JOINT.
    #[cfg_attr(feature = "flags", arg(long, value_name = "P", requires = "stiffness", help_heading = IMPACT))]
    pub exponent: Option<Plain>,
    /// Contact law (damp --list-laws), for peak:JOINT.
    #[cfg_attr(feature = "flags", arg(long, value_name = "NAME", requires = "stiffness", help_heading = IMPACT))]
    #[serde(deserialize_with = "value::some_word")]
    #[schemars(with = "Option<String>")]
    pub law: Option<LawName>,
    /// Normals among which the extremes are searched: given, any, across:X,Y,Z, cone:ANGLE.
    ///
    /// across: all normals perpendicular to an axis (world axes), such as those in the plane of a planar mechanism. cone: all normals within
    /// an angle of the given one.
    #[cfg_attr(feature = "flags", arg(long, value_name = "NORMALS", allow_hyphen_values = true))]
    #[serde(deserialize_with = "value::some_word")]
    #[schemars(with = "Option<String>")]
    pub normals: Option<GivenNormals>,
    /// Edge X,Y,Z of a patch of contact points, from the point; twice: a parallelogram.
    ///
    /// The extremes are those of all points p + s a + t b with the edges a and b (link's frame) and s, t from 0 to 1: a line or a facet.
    #[cfg_attr(feature = "flags", arg(long, value_name = "X,Y,Z", allow_hyphen_values = true))]
    #[serde(deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub edge: Vec<GivenEdge>,
    /// Prove bounds of the extremes of m̄ within a relative tolerance, such as 2%.
    ///
    /// Branch and bound over the ranges with interval arithmetic: trees, and loops along one or two ranges. The report gives the best
    /// proved bounds if the number of boxes is not sufficient. With stiffness and speed also a bound of the peak force v √(k m̄).
    #[cfg_attr(feature = "flags", arg(long, value_name = "TOLERANCE"))]
    pub certify: Option<Ratio>,
    /// Largest number of boxes of each proof; default 200000.
    #[cfg_attr(feature = "flags", arg(long, value_name = "N", requires = "certify"))]
    pub boxes: Option<u32>,
    /// Relative tolerance of all masses, moments of inertia and rotor inertias in the proof, such as 1%.
    #[cfg_attr(feature = "flags", arg(long, value_name = "RATIO", requires = "certify"))]
    pub mass_tolerance: Option<Ratio>,
    /// Number of starts of the search; default 32.
    #[cfg_attr(feature = "flags", arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=2_000)))]
    pub starts: Option<u16>,
    /// End of the contact of the law; no key gives it.
    #[cfg_attr(feature = "flags", arg(skip))]
    #[serde(skip)]
    pub separation: Option<SeparationName>,
}

impl ExtremesQuestion {
    /// Question with checked keys. `motions`: ranges of wheel motions, which form the path. Paths of files are relative to `folder`. A file
    /// read as a stream has at most `max_size` bytes.
    ///
    /// # Errors
    /// [`InvalidKey`]: more than one path, a path with ranges or kept points, ignored columns without a file, a number of starts out of
    /// range.
    pub fn checked(&self, motions: Vec<Vary>, folder: &Path, max_size: u64) -> Result<Self, InvalidKey> {
        let refuse = |key, why: &'static str| Err(InvalidKey::new(key, why));
        self.check_ignored()?;
        if motions.len() + usize::from(self.path.is_some()) > 1 {
            return refuse(
                "extremes.path",
                "a search has one path; expected one file, or one range of a motion",
            );
        }
        let motion = motions.into_iter().next().map(|motion| GivenPath(motion.into()));
        let path = self.path.clone().or(motion);
        let path = path.map(|GivenPath(rows)| GivenPath(rows.in_folder(folder, max_size)));
        let names = self.range.iter().map(|range| range.joint.as_str());
        if let Some(twice) =
            names.clone().enumerate().find(|(i, name)| names.clone().take(*i).any(|other| other == *name))
        {
            let why = format!("joint \"{}\" is given twice; give it one range", twice.1);
            return Err(InvalidKey::new("extremes.range", why));
        }
        if path.is_some() && !(self.range.is_empty() && self.keep.is_empty()) {
            return refuse(
                "extremes.path",
                "it gives all positions of the search; expected neither `range` nor `keep`",
            );
        }
        if !(1..=MOST_STARTS).contains(&self.starts.map_or(DEFAULT_STARTS, usize::from)) {
            return refuse("extremes.starts", "expected a number from 1 to 2000");
        }
        self.check_proof()?;
        if self.edge.len() > 2 {
            return refuse(
                "extremes.edge",
                "a patch has one or two edges; expected a line or a parallelogram",
            );
        }
        if let Some(law) = self.contact_law().filter(|_| self.certify.is_none()) {
            if !matches!(self.quantity, Some(GivenQuantity::Peak(_))) {
                return refuse(
                    "extremes.quantity",
                    "a contact law applies only to a peak force; expected the quantity peak:JOINT, or no contact law",
                );
            }
            if law.missing().is_some() || law.speed.is_none() {
                return refuse(
                    "extremes.stiffness",
                    "the contact law of a peak force is incomplete; expected `stiffness`, `restitution` and `speed`",
                );
            }
            law.check_law().map_err(|error| InvalidKey::new("extremes.law", error.to_string()))?;
        }
        Ok(Self { path, ..self.clone() })
    }

    /// Checks the keys of the proof.
    fn check_proof(&self) -> Result<(), InvalidKey> {
        let refuse = |key, why: &'static str| Err(InvalidKey::new(key, why));
        let Some(Ratio(tolerance)) = self.certify else {
            return match (self.boxes, self.mass_tolerance) {
                (Some(_), _) => refuse("extremes.boxes", "it limits a proof; give `certify`, such as 2%"),
                (_, Some(_)) => {
                    refuse("extremes.mass_tolerance", "it belongs to a proof; give `certify`, such as 2%")
                }
                _ => Ok(()),
            };
        };
        if !(1e-9..=1.0).contains(&tolerance) {
            return refuse("extremes.certify", "expected a relative tolerance from 1e-9 to 1, such as 2%");
        }
        if !(0.0..=0.5).contains(&self.mass_tolerance.map_or(0.0, |Ratio(masses)| masses)) {
            return refuse("extremes.mass_tolerance", "expected a relative tolerance from 0 to 50%");
        }
        if !(1..=MOST_BOXES).contains(&self.boxes.unwrap_or(DEFAULT_BOXES)) {
            return refuse("extremes.boxes", "expected a number from 1 to 100000000");
        }
        let is_mass = self.quantity() == &GivenQuantity::Mass;
        let is_given =
            matches!(self.normals.unwrap_or_default().0, NormalRange::Given | NormalRange::Cone(_));
        if !is_mass || !is_given || self.path.is_some() || !self.keep.is_empty() {
            return refuse(
                "extremes.certify",
                "the proof covers m̄ over ranges of joints, with the normal of the contact or a cone around it; expected neither another \
                 quantity, other `normals`, `path` nor `keep`",
            );
        }
        let law = self.restitution.is_some() || self.exponent.is_some() || self.law.is_some();
        if law || self.stiffness.is_some() != self.speed.is_some() {
            return refuse(
                "extremes.stiffness",
                "the proved peak force is that of a linear spring; expected `stiffness` and `speed`, and no other part of a contact law",
            );
        }
        Ok(())
    }

    /// Refuses ignored columns without a file.
    pub(crate) fn check_ignored(&self) -> Result<(), InvalidKey> {
        match &self.path {
            Some(GivenPath(RowSource::File(_))) => Ok(()),
            _ if self.ignore.is_empty() => Ok(()),
            _ => {
                let why = "it removes columns of the file of `path`; give that file";
                Err(InvalidKey::new("extremes.ignore", why))
            }
        }
    }

    /// Quantity whose extremes are searched.
    pub fn quantity(&self) -> &GivenQuantity {
        self.quantity.as_ref().unwrap_or(&GivenQuantity::Mass)
    }

    /// Rows of the path, in place of ranges and kept points, without the ignored columns; `None` for a search over ranges.
    pub fn rows(&self) -> Option<RowSource> {
        let GivenPath(mut rows) = self.path.clone()?;
        if let RowSource::File(file) = &mut rows {
            file.ignore.extend_from_slice(&self.ignore);
        }
        Some(rows)
    }

    /// Contact law with restitution and closing speed, of a peak force; `None` if no part of it is given.
    pub(crate) fn contact_law(&self) -> Option<DampingQuestion> {
        let Self { restitution, stiffness, speed, exponent, law, separation, .. } = *self;
        let law = DampingQuestion {
            restitution,
            stiffness,
            speed,
            exponent,
            law,
            separation,
            ..DampingQuestion::default()
        };
        (law != DampingQuestion::default()).then_some(law)
    }
}
