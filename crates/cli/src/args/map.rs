//! Flags of `percuss map`.

use super::headings::{OUTPUT, READING};
use super::words::{edge, package};
use super::{ContactArgs, MassFormat, ModelArgs, TableArgs, WritingArgs};
use crate::terminal::failure::Failure;
use clap::{Args, ValueEnum};
use percuss_formats::DEFAULT_MAX_MESH_SIZE;
use percuss_study::{MapLinks, MapQuestion, MapShapes};
use std::path::PathBuf;

/// What `--shapes` takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ShapesArg {
    /// <collision>, and <visual> for links that have none.
    Auto,
    /// <collision>.
    Collision,
    /// <visual>.
    Visual,
}

/// A heading of the help.
const SURFACE: &str = "Surface or directions";

/// Flags of `percuss map`.
#[derive(Debug, Args)]
pub struct MapArgs {
    #[command(flatten)]
    pub model: ModelArgs,
    #[command(flatten)]
    pub contact: ContactArgs,
    /// Every link that has a shape.
    ///
    /// Those that cannot be mapped are left out, and listed.
    #[arg(long, conflicts_with_all = ["link", "point"], help_heading = SURFACE)]
    pub all: bool,
    /// Or so many directions at --point.
    ///
    /// Instead of the surface; the principal ones too (the belted ellipsoid).
    #[arg(long, value_name = "COUNT", requires = "point", help_heading = SURFACE)]
    pub directions: Option<usize>,
    /// Which shapes of the URDF make the surface.
    #[arg(long, value_enum, default_value_t = ShapesArg::Auto, help_heading = SURFACE)]
    pub shapes: ShapesArg,
    /// Longest edge of a facet (m).
    ///
    /// By default 1/60 of the link. Triangles of meshes are divided, never joined.
    #[arg(long, value_name = "M", value_parser = edge, help_heading = SURFACE)]
    pub edge: Option<f64>,
    /// The folder of a ROS package of meshes.
    ///
    /// For meshes named package://NAME/…; else ROS_PACKAGE_PATH, AMENT_PREFIX_PATH, and the folders above the model are searched.
    #[arg(long, value_name = "NAME=FOLDER", value_parser = package, help_heading = SURFACE)]
    pub package: Vec<(String, PathBuf)>,
    /// Refuse mesh files larger than this many bytes.
    #[arg(long, default_value_t = DEFAULT_MAX_MESH_SIZE, value_name = "BYTES", help_heading = READING)]
    pub max_mesh_size: u64,
    /// .ply .glb .gltf .png .svg .pdf .csv .json
    ///
    /// An output file; may be given again. PLY and glTF have the effective mass as a property, pictures show two sides.
    #[arg(long, short, value_name = "FILE", help_heading = OUTPUT)]
    pub output: Vec<String>,
    #[command(flatten)]
    pub table: TableArgs,
    #[command(flatten)]
    pub writing: WritingArgs,
    /// How the result is shown on stdout.
    #[arg(long, value_enum, default_value_t = MassFormat::Text, help_heading = OUTPUT)]
    pub format: MassFormat,
    /// How many threads compute; by default as many as there are processors. No answer depends on it.
    #[arg(
        long,
        value_name = "COUNT",
        value_parser = clap::value_parser!(u16).range(1..=1024),
        help_heading = OUTPUT
    )]
    pub threads: Option<u16>,
}

impl MapArgs {
    /// Refuses flags of a contact that a map has no use for.
    pub fn check(&self) -> Result<(), Failure> {
        let contact = &self.contact;
        if contact.normal.is_some() || contact.along_line.is_some() {
            return Err(Failure::bad_input(
                "--normal, --along-line: a map takes the outward normals of the surface, or with --directions all directions; \
                 percuss mass answers one",
            ));
        }
        if contact.estimate.is_some() {
            return Err(Failure::bad_input(
                "--estimate: a map has no estimate; percuss mass and percuss sweep do",
            ));
        }
        if contact.link.is_none() && !self.all {
            return Err(Failure::bad_input("name a link (--link LINK), or take --all"));
        }
        if contact.point.is_some() && self.directions.is_none() {
            return Err(Failure::bad_input(
                "--point: a surface has points of its own; with --directions COUNT the point is mapped over directions",
            ));
        }
        Ok(())
    }

    /// As a question about surfaces.
    pub fn question(&self) -> Result<MapQuestion, Failure> {
        let named = self.contact.link.iter().cloned().collect();
        Ok(MapQuestion {
            conditions: self.contact.conditions()?,
            links: if self.all { MapLinks::All } else { MapLinks::Named(named) },
            shapes: match self.shapes {
                ShapesArg::Auto => MapShapes::Auto,
                ShapesArg::Collision => MapShapes::Collision,
                ShapesArg::Visual => MapShapes::Visual,
            },
            edge: self.edge,
            packages: self.package.clone(),
            max_mesh_size: self.max_mesh_size,
        })
    }
}
