//! Question about a map: surfaces of links, or directions at a point.

#[cfg(feature = "flags")]
use super::headings::{OUTPUT, READING, SURFACE};
use crate::question::errors::refusal::InvalidKey;
use crate::question::mass_question::MassQuestion;
use crate::question::tables::contact::ContactTable;
use crate::question::tables::sweep::{DecimalSign, StudyTable, TableUnit};
#[cfg(feature = "flags")]
use crate::values::named;
use crate::values::quantities::{Length, Point};
use crate::values::value::{self, Words, path_in};
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Selection of the shapes that form the surface of a link.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::ValueEnum))]
#[serde(rename_all = "lowercase")]
pub enum MapShapes {
    /// `<collision>`; `<visual>` for links without `<collision>`.
    #[default]
    Auto,
    /// `<collision>`.
    Collision,
    /// `<visual>`.
    Visual,
}

/// Surfaces or directions of a map, and its files. The command line takes the link and the point from the contact.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "flags", derive(clap::Args), command(next_help_heading = SURFACE))]
#[serde(deny_unknown_fields, default)]
pub struct MapQuestion {
    /// Links to map; default: the contact's link.
    #[cfg_attr(feature = "flags", arg(skip))]
    #[serde(deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub link: Vec<String>,
    /// Map every link with a shape.
    ///
    /// Links that cannot be mapped are skipped and listed.
    #[cfg_attr(feature = "flags", arg(long, conflicts_with_all = ["link", "point"]))]
    pub all: bool,
    /// With directions: the point, m, in the link's frame; default: the contact point.
    #[cfg_attr(feature = "flags", arg(skip))]
    pub point: Option<Point>,
    /// Number of directions at a point.
    ///
    /// Maps the directions at one point instead of the surface, and adds the principal directions (the belted
    /// ellipsoid).
    #[cfg_attr(feature = "flags", arg(long, value_name = "COUNT", requires = "point"))]
    pub directions: Option<usize>,
    /// Shapes of the URDF that form the surface.
    #[cfg_attr(feature = "flags", arg(long, value_enum, default_value_t))]
    pub shapes: MapShapes,
    /// Longest edge of a facet (m).
    ///
    /// Default: 1/60 of the size of the link. Triangles of meshes are divided, never merged.
    #[cfg_attr(feature = "flags", arg(long, value_name = "M"))]
    pub edge: Option<Length>,
    /// Folder of a ROS package with meshes.
    ///
    /// Used for mesh names of the form package://NAME/…. Otherwise ROS_PACKAGE_PATH, AMENT_PREFIX_PATH and the parent
    /// folders of the model are searched.
    #[cfg_attr(feature = "flags", arg(long, value_name = "NAME=FOLDER", value_parser = named::package))]
    #[serde(deserialize_with = "value::by_name")]
    #[schemars(with = "BTreeMap<String, String>")]
    pub package: Vec<(String, PathBuf)>,
    /// Refuse mesh files larger than this many bytes; default: 268435456.
    #[cfg_attr(feature = "flags", arg(long, value_name = "BYTES", help_heading = READING))]
    pub max_mesh_size: Option<u64>,
    /// .ply .glb .gltf .png .svg .pdf .csv .json
    ///
    /// Output file; several are possible. PLY and glTF contain the effective mass as a property; pictures show two
    /// sides.
    #[cfg_attr(feature = "flags", arg(long, short, value_name = "FILE", help_heading = OUTPUT))]
    #[serde(deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub output: Vec<String>,
    /// Units of the lengths in CSV; column names then contain the units.
    #[cfg_attr(feature = "flags", arg(skip))]
    #[serde(deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub unit: Vec<TableUnit>,
    /// The decimal sign in CSV.
    #[cfg_attr(feature = "flags", arg(skip))]
    pub decimal: DecimalSign,
}

impl MapQuestion {
    /// Question about the surfaces of all links.
    pub fn all() -> Self {
        Self { all: true, ..Self::default() }
    }

    /// Question with checked keys, and with the link of a contact, which may be incomplete, if none is given. Paths are relative to
    /// `folder`.
    ///
    /// # Errors
    /// [`InvalidKey`]: no link, or keys that exclude each other.
    pub fn checked(&self, contact: &MassQuestion, folder: &Path) -> Result<Self, InvalidKey> {
        let refuse = |key, why: &'static str| Err(InvalidKey::new(key, why));
        let of_contact = contact.contact.link.clone();
        let link = if self.link.is_empty() { of_contact.into_iter().collect() } else { self.link.clone() };
        if self.all && !self.link.is_empty() {
            return refuse("map", "give either `link` or `all`");
        }
        if link.is_empty() && !self.all {
            return refuse("map", "give a link (`link`), or `all` for every link");
        }
        let of_surfaces = [("map.edge", self.edge.is_some()), ("map.package", !self.package.is_empty())];
        if self.directions.is_some() {
            if let Some((key, _)) = of_surfaces.into_iter().find(|(_, is_given)| *is_given) {
                return refuse(key, "it belongs to a map of surfaces; remove it, or remove `directions`");
            }
            if link.len() != 1 {
                return refuse("map.directions", "directions apply to a point of one link; give one `link`");
            }
            if self.all {
                return refuse("map.directions", "directions apply to a point of one link; remove `all`");
            }
            if self.point.is_none() && !self.link.is_empty() {
                return refuse("map.directions", "directions require a point; give `point`");
            }
        } else if self.point.is_some() {
            let why = "not used for a surface; add `directions` to map the directions at this point";
            return refuse("map.point", why);
        }
        Ok(Self {
            link,
            package: self.package.iter().map(|(name, path)| (name.clone(), folder.join(path))).collect(),
            output: self.output.iter().map(|output| path_in(folder, output)).collect(),
            ..self.clone()
        })
    }

    /// Question at the point of the directions.
    pub(crate) fn point_question(&self, contact: &MassQuestion) -> MassQuestion {
        let given = &contact.contact;
        let contact_of_map = ContactTable {
            link: self.link.first().or(given.link.as_ref()).cloned(),
            point: self.point.or(given.point),
            estimate: None,
            ..given.clone()
        };
        MassQuestion { contact: contact_of_map, ..contact.clone() }
    }

    /// Style of the tables.
    pub fn table(&self) -> StudyTable {
        StudyTable { units: self.unit.clone(), decimal: self.decimal }
    }
}
