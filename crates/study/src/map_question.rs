//! The question of a map: which links, which of their shapes, how fine.

use crate::question::MassQuestion;
use percuss_formats::DEFAULT_MAX_MESH_SIZE;
use std::path::PathBuf;

/// Which links are mapped.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum MapLinks {
    /// Those of these names.
    Named(Vec<String>),
    /// All that have a shape that can be read.
    All,
}

/// Which shapes of a link make its surface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum MapShapes {
    /// `<collision>`; `<visual>` for links that have none.
    #[default]
    Auto,
    /// `<collision>`.
    Collision,
    /// `<visual>`.
    Visual,
}

/// A question about the surfaces of links. Its contact is left open; the rest of `conditions` counts.
#[derive(Clone, Debug, PartialEq)]
pub struct MapQuestion {
    /// The pose, what is held, the other side.
    pub conditions: MassQuestion,
    /// Which links.
    pub links: MapLinks,
    /// Which of their shapes.
    pub shapes: MapShapes,
    /// Longest edge of a facet, m; none: a part of the link's size.
    pub edge: Option<f64>,
    /// Folders of packages by name.
    pub packages: Vec<(String, PathBuf)>,
    /// Largest mesh file, bytes.
    pub max_mesh_size: u64,
}

impl MapQuestion {
    /// The whole skin under conditions.
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
