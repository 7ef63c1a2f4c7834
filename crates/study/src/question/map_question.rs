//! Question of a map: links, shapes and resolution.

use crate::question::mass_question::MassQuestion;
use percuss_formats::DEFAULT_MAX_MESH_SIZE;
use schemars::JsonSchema;
use serde::Deserialize;
use std::path::PathBuf;

/// Selection of links.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum MapLinks {
    /// Links by name.
    Named(Vec<String>),
    /// All links with a readable shape.
    All,
}

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

/// Question about the surfaces of links. The contact of `conditions` is ignored; all other fields apply.
#[derive(Clone, Debug, PartialEq)]
pub struct MapQuestion {
    /// Pose, held parts and other side.
    pub conditions: MassQuestion,
    /// Links.
    pub links: MapLinks,
    /// Shapes.
    pub shapes: MapShapes,
    /// Longest edge of a facet, m; `None` for a fraction of the link's size.
    pub edge: Option<f64>,
    /// ROS package names and folders.
    pub packages: Vec<(String, PathBuf)>,
    /// Largest mesh file, bytes.
    pub max_mesh_size: u64,
}

impl MapQuestion {
    /// Question about the surfaces of all links.
    pub fn all(conditions: MassQuestion) -> Self {
        Self {
            conditions,
            links: MapLinks::All,
            shapes: MapShapes::Auto,
            edge: None,
            packages: Vec::new(),
            max_mesh_size: DEFAULT_MAX_MESH_SIZE,
        }
    }
}
