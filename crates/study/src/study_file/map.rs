//! Map table of a study file.

use crate::question::errors::refusal::InvalidKey;
use crate::question::map_question::{MapLinks, MapQuestion, MapShapes};
use crate::question::mass_question::MassQuestion;
use crate::study_file::sweep::{StudyTable, TableKeyNames, parse_table_style};
use crate::values::value::{self, NumberOrText, Triple, Words};
use percuss_formats::DEFAULT_MAX_MESH_SIZE;
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::Path;

/// Map requested by a study.
#[derive(Clone, Debug, PartialEq)]
pub struct StudyMap {
    /// Surfaces or directions.
    pub question: StudyMapQuestion,
    /// Output files.
    pub outputs: Vec<String>,
    /// Style of the tables.
    pub table: StudyTable,
}

/// Kind of a map.
#[derive(Clone, Debug, PartialEq)]
pub enum StudyMapQuestion {
    /// The surfaces of links.
    Surfaces(MapQuestion),
    /// This number of directions at the point of a question.
    Directions(MassQuestion, usize),
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct MapText {
    /// Links to map; default: the contact's link.
    #[serde(default, deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub link: Vec<String>,
    /// Every link that has a shape.
    #[serde(default)]
    pub all: bool,
    /// With directions: the point, m, in the link's frame; default: the contact point.
    #[serde(default, deserialize_with = "value::some_lengths")]
    #[schemars(with = "Option<Triple>")]
    pub point: Option<[f64; 3]>,
    /// In place of the surface: number of directions at the point, in addition to the principal directions.
    pub directions: Option<usize>,
    /// Shapes of the URDF that form the surface.
    #[schemars(extend("enum" = ["auto", "collision", "visual"]))]
    pub shapes: Option<String>,
    /// Longest edge of a facet, m; default 1/60 of the link's size.
    #[serde(default, deserialize_with = "value::length")]
    #[schemars(with = "Option<NumberOrText>")]
    pub edge: Option<f64>,
    /// Folders of ROS packages by name, for meshes named package://NAME/….
    #[serde(default)]
    pub package: BTreeMap<String, String>,
    /// Largest size of a mesh file, bytes.
    pub max_mesh_size: Option<u64>,
    /// The files of the map (.ply, .glb, .gltf, .png, .svg, .pdf, .csv, .json).
    #[serde(default, deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub output: Vec<String>,
    /// Units of the lengths in CSV; column names then contain the units.
    #[serde(default, deserialize_with = "value::words")]
    #[schemars(with = "Option<Words>")]
    pub unit: Vec<String>,
    /// The decimal sign in CSV.
    #[schemars(extend("enum" = ["point", "comma"]))]
    pub decimal: Option<String>,
}

impl MapText {
    /// Converts the table to a map. The contact of the study may be incomplete.
    pub fn map(&self, contact: &MassQuestion, folder: &Path) -> Result<StudyMap, InvalidKey> {
        let refuse = |key, why: &str| Err(InvalidKey::new(key, why));
        let of_contact = Some(contact.link.clone()).filter(|link| !link.is_empty());
        let links = if self.link.is_empty() { of_contact.into_iter().collect() } else { self.link.clone() };
        if self.all && !self.link.is_empty() {
            return refuse("map", "give either link or all");
        }
        if links.is_empty() && !self.all {
            return refuse("map", "give links (link), or all = true");
        }
        let shapes = match self.shapes.as_deref() {
            None | Some("auto") => MapShapes::Auto,
            Some("collision") => MapShapes::Collision,
            Some("visual") => MapShapes::Visual,
            Some(other) => {
                let why = format!("\"{other}\"; expected auto, collision or visual");
                return Err(InvalidKey::new("map.shapes", why));
            }
        };
        let mut conditions = contact.clone();
        conditions.estimate = None;
        let question = match self.directions {
            Some(count) => {
                let [link] = &links[..] else {
                    return refuse(
                        "map.directions",
                        "directions apply to a point of one link; give one link",
                    );
                };
                if self.all {
                    return refuse("map.directions", "directions apply to a point of one link; remove all");
                }
                if self.point.is_none() && !self.link.is_empty() {
                    return refuse("map.directions", "directions require a point; give point");
                }
                conditions.link.clone_from(link);
                conditions.point = self.point.unwrap_or(contact.point);
                StudyMapQuestion::Directions(conditions, count)
            }
            None if self.point.is_some() => {
                return refuse("map.point", "a point is not used for a surface; add directions");
            }
            None => StudyMapQuestion::Surfaces(MapQuestion {
                conditions,
                links: if self.all { MapLinks::All } else { MapLinks::Named(links) },
                shapes,
                edge: self.edge,
                packages: self.package.iter().map(|(name, path)| (name.clone(), folder.join(path))).collect(),
                max_mesh_size: self.max_mesh_size.unwrap_or(DEFAULT_MAX_MESH_SIZE),
            }),
        };
        let keys = TableKeyNames { unit: "map.unit", decimal: "map.decimal" };
        Ok(StudyMap {
            question,
            outputs: self.output.iter().map(|o| folder.join(o).to_string_lossy().into_owned()).collect(),
            table: parse_table_style(&self.unit, self.decimal.as_deref(), &keys)?,
        })
    }
}
