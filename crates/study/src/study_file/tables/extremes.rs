//! Table of a search for extremes.

use super::damping::LawName;
#[cfg(feature = "flags")]
use super::headings::{ANSWER, IMPACT};
use super::impact::contact_law;
use super::sweep::path_in;
use crate::question::damping_question::DampingQuestion;
use crate::question::errors::refusal::InvalidKey;
use crate::question::row_source::{PositionFile, RowSource};
use crate::question::travel::vary::Vary;
use crate::reports::impact::extremes::{DEFAULT_STARTS, MOST_STARTS};
use crate::reports::impact::extremes_question::{
    ExtremesQuestion, GivenNormals, GivenQuantity, GivenRange, Keep,
};
use crate::values::quantities::{Plain, Ratio, Speed, Stiffness};
use crate::values::value::{self, Words};
use schemars::JsonSchema;
use serde::Deserialize;
use std::path::Path;

/// Path of positions: a file, or a range of a joint or a travel.
#[derive(Clone, Debug, PartialEq)]
pub enum GivenPath {
    /// File of positions.
    File(String),
    /// Range `JOINT=FROM:TO:COUNT` or `TRAVEL=FROM:TO:COUNT`.
    Range(Vary),
}

impl std::str::FromStr for GivenPath {
    type Err = String;
    /// Reads a range, or the name of a file that ends in .csv or .parquet; `-` is the standard input.
    fn from_str(text: &str) -> Result<Self, String> {
        let is_file = Path::new(text)
            .extension()
            .is_some_and(|end| ["csv", "parquet"].iter().any(|kind| end.eq_ignore_ascii_case(kind)));
        if is_file || text == "-" {
            return Ok(Self::File(text.to_owned()));
        }
        let range = Vary::parse(text).map(Self::Range);
        range.map_err(|error| {
            format!("a file of positions (.csv, .parquet), or a range such as heave=-80mm:80mm:33, is expected: {error}")
        })
    }
}

/// Smallest and largest effective mass of the contact, or another quantity, over positions.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::Args))]
#[serde(deny_unknown_fields, default)]
pub struct ExtremesTable {
    /// Range of a driving joint, JOINT=FROM:TO; default: the limits of all.
    ///
    /// With a range only the given joints vary, and the other joints are held at their set positions (0 without one). Without ranges all
    /// driving joints with limits vary over their limits, except those with a set position.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "JOINT=FROM:TO", allow_hyphen_values = true, help_heading = ANSWER)
    )]
    #[serde(deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub range: Vec<GivenRange>,
    /// Link or point that stays in place: LINK, LINK:X,Y,Z, LINK:X,Y,Z:NX,NY,NZ.
    ///
    /// The search covers the self-motion, for example of a redundant arm with a fixed tool point. LINK keeps position and orientation;
    /// with a direction (world axes) only the coordinate of the point (m, link's frame) along it is kept. The place is that at the set
    /// pose, and joints with a set position vary too. The point is free in the impact, unlike a held point.
    #[cfg_attr(feature = "flags", arg(long, value_name = "LINK[:X,Y,Z]", help_heading = ANSWER))]
    #[serde(deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub keep: Vec<Keep>,
    /// Path instead of ranges: FILE.csv, FILE.parquet, or a travel such as heave=FROM:TO:COUNT.
    ///
    /// The rows of the file are positions as for percuss sweep; the drivers move on straight lines between them. In place of a file, the
    /// range of a joint or of a travel gives the rows.
    #[cfg_attr(
        feature = "flags",
        arg(
            long,
            value_name = "FILE|RANGE",
            allow_hyphen_values = true,
            conflicts_with_all = ["range", "keep"],
            help_heading = ANSWER
        )
    )]
    #[serde(deserialize_with = "value::some_word")]
    #[schemars(with = "Option<String>")]
    pub path: Option<GivenPath>,
    /// Ignore a column of the file of the path.
    #[cfg_attr(feature = "flags", arg(long, value_name = "COLUMN", requires = "path", help_heading = ANSWER))]
    #[serde(deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub ignore: Vec<String>,
    /// Quantity: mass, reflected:JOINT, held:JOINT, bearing:JOINT, peak:JOINT.
    ///
    /// reflected, held: inertia at a joint with the other drivers free, or at rest. bearing: impulse in a joint, per closing speed of a
    /// plastic impact; an impact with the restitution e has (1+e) times this impulse. peak: peak force in a joint (N), with the contact law
    /// given by stiffness, restitution and speed. For bearing and peak, JOINT can also be a loop closure, or ground.
    #[cfg_attr(feature = "flags", arg(long, value_name = "QUANTITY", help_heading = ANSWER))]
    #[serde(deserialize_with = "value::some_word")]
    #[schemars(with = "Option<String>")]
    pub quantity: Option<GivenQuantity>,
    /// Stiffness of the contact (N/m; 200N/mm), for peak:JOINT.
    #[cfg_attr(feature = "flags", arg(long, value_name = "K", allow_hyphen_values = true, help_heading = IMPACT))]
    pub stiffness: Option<Stiffness>,
    /// Coefficient of restitution, from 0 to 1, for peak:JOINT.
    #[cfg_attr(feature = "flags", arg(long, value_name = "E", allow_hyphen_values = true, help_heading = IMPACT))]
    pub restitution: Option<Ratio>,
    /// Closing speed (m/s, km/h; rad/s for a moment), for peak:JOINT.
    #[cfg_attr(feature = "flags", arg(long, value_name = "V", allow_hyphen_values = true, help_heading = IMPACT))]
    pub speed: Option<Speed>,
    /// Exponent p of the spring force k x^p, for peak:JOINT.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "P", allow_hyphen_values = true, requires = "stiffness", help_heading = IMPACT)
    )]
    pub exponent: Option<Plain>,
    /// Contact law (damp --list-laws), for peak:JOINT.
    #[cfg_attr(feature = "flags", arg(long, value_name = "NAME", requires = "stiffness", help_heading = IMPACT))]
    #[serde(deserialize_with = "value::some_word")]
    #[schemars(with = "Option<String>")]
    pub law: Option<LawName>,
    /// Normals among which the extremes are searched: given, any, across:X,Y,Z.
    ///
    /// across: all normals perpendicular to an axis (world axes), such as those in the plane of a planar mechanism.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "NORMALS", allow_hyphen_values = true, help_heading = ANSWER)
    )]
    #[serde(deserialize_with = "value::some_word")]
    #[schemars(with = "Option<String>")]
    pub normals: Option<GivenNormals>,
    /// Number of starts of the search; default 32.
    #[cfg_attr(
        feature = "flags",
        arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=2_000), help_heading = ANSWER)
    )]
    pub starts: Option<u16>,
}

impl ExtremesTable {
    /// Converts the table to a question. `motions`: ranges of wheel motions, which form the path. Paths of files are relative to `folder`.
    /// A file read as a stream has at most `max_size` bytes.
    ///
    /// # Errors
    /// [`InvalidKey`]: more than one path, a path with ranges or kept points, ignored columns without a file, a number of starts out of
    /// range.
    pub fn question(
        &self,
        motions: Vec<Vary>,
        folder: &Path,
        max_size: u64,
    ) -> Result<ExtremesQuestion, InvalidKey> {
        let refuse = |key, why: &str| Err(InvalidKey::new(key, why));
        let is_file = matches!(self.path, Some(GivenPath::File(_)));
        if !self.ignore.is_empty() && !is_file {
            return refuse("extremes.ignore", "it removes columns of the file of `path`; give that file");
        }
        if motions.len() + usize::from(self.path.is_some()) > 1 {
            return refuse(
                "extremes.path",
                "a search has one path; expected one file, or one range of a motion",
            );
        }
        let path = match (&self.path, motions.into_iter().next()) {
            (Some(GivenPath::File(file)), _) => Some(RowSource::File(PositionFile {
                path: if file == "-" { file.clone() } else { path_in(folder, file) },
                ignore: self.ignore.clone(),
                max_size,
            })),
            (Some(GivenPath::Range(range)), _) => Some(RowSource::from(range)),
            (None, motion) => motion.map(RowSource::from),
        };
        let names = self.range.iter().map(|range| range.joint.as_str());
        if let Some(twice) =
            names.clone().enumerate().find(|(i, name)| names.clone().take(*i).any(|other| other == *name))
        {
            return refuse(
                "extremes.range",
                &format!("joint \"{}\" is given twice; give it one range", twice.1),
            );
        }
        if path.is_some() && !(self.range.is_empty() && self.keep.is_empty()) {
            return refuse(
                "extremes.path",
                "it gives all positions of the search; expected neither `range` nor `keep`",
            );
        }
        let starts = self.starts.map_or(DEFAULT_STARTS, usize::from);
        if !(1..=MOST_STARTS).contains(&starts) {
            return refuse("extremes.starts", "expected a number from 1 to 2000");
        }
        let is_shaped = self.exponent.is_some() || self.law.is_some();
        let law = match (self.stiffness, self.restitution, self.speed) {
            (None, None, None) if !is_shaped => None,
            _ if !matches!(self.quantity, Some(GivenQuantity::Peak(_))) => {
                return refuse(
                    "extremes.quantity",
                    "a contact law applies only to a peak force; expected the quantity peak:JOINT, or no contact law",
                );
            }
            (Some(stiffness), Some(restitution), Some(speed)) => {
                let law =
                    contact_law("extremes.law", restitution.0, stiffness, self.exponent, self.law.as_ref())?;
                Some(DampingQuestion { speed: Some(speed.0.value), ..law })
            }
            _ => {
                return refuse(
                    "extremes.stiffness",
                    "the contact law of a peak force is incomplete; expected `stiffness`, `restitution` and `speed`",
                );
            }
        };
        Ok(ExtremesQuestion {
            law,
            dimensions: [
                self.speed.and_then(|speed| speed.0.dimension),
                self.stiffness.and_then(|stiffness| stiffness.0.dimension),
            ],
            ranges: self.range.clone(),
            keep: self.keep.clone(),
            path,
            quantity: self.quantity.clone().unwrap_or_default(),
            normals: self.normals.unwrap_or_default(),
            starts,
        })
    }
}
