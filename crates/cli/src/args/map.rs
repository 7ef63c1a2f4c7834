//! Flags of `percuss map`.

use super::headings::{OUTPUT, READING};
use super::value_parsers::{edge, package};
use super::{ContactArgs, MassFormat, ModelArgs, TableArgs, WritingArgs};
use crate::terminal::failure::Failure;
use clap::{Args, ValueEnum};
use percuss_formats::DEFAULT_MAX_MESH_SIZE;
use percuss_study::{MapLinks, MapQuestion, MapShapes};
use std::path::PathBuf;

/// Values of `--shapes`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ShapesArg {
    /// <collision>; <visual> for links without <collision>.
    Auto,
    /// <collision>.
    Collision,
    /// <visual>.
    Visual,
}

/// Heading in the help.
const SURFACE: &str = "Surface or directions";

/// Flags of `percuss map`.
#[derive(Debug, Args)]
pub struct MapArgs {
    #[command(flatten)]
    pub model: ModelArgs,
    #[command(flatten)]
    pub contact: ContactArgs,
    /// Map every link with a shape.
    ///
    /// Links that cannot be mapped are skipped and listed.
    #[arg(long, conflicts_with_all = ["link", "point"], help_heading = SURFACE)]
    pub all: bool,
    /// Number of directions at --point.
    ///
    /// Maps the directions at one point instead of the surface, and adds the principal directions (the belted
    /// ellipsoid).
    #[arg(long, value_name = "COUNT", requires = "point", help_heading = SURFACE)]
    pub directions: Option<usize>,
    /// Shapes of the URDF that form the surface.
    #[arg(long, value_enum, default_value_t = ShapesArg::Auto, help_heading = SURFACE)]
    pub shapes: ShapesArg,
    /// Longest edge of a facet (m).
    ///
    /// Default: 1/60 of the size of the link. Triangles of meshes are divided, never merged.
    #[arg(long, value_name = "M", value_parser = edge, help_heading = SURFACE)]
    pub edge: Option<f64>,
    /// Folder of a ROS package with meshes.
    ///
    /// Used for mesh names of the form package://NAME/…. Otherwise ROS_PACKAGE_PATH, AMENT_PREFIX_PATH and the parent
    /// folders of the model are searched.
    #[arg(long, value_name = "NAME=FOLDER", value_parser = package, help_heading = SURFACE)]
    pub package: Vec<(String, PathBuf)>,
    /// Refuse mesh files larger than this many bytes.
    #[arg(long, default_value_t = DEFAULT_MAX_MESH_SIZE, value_name = "BYTES", help_heading = READING)]
    pub max_mesh_size: u64,
    /// .ply .glb .gltf .png .svg .pdf .csv .json
    ///
    /// Output file; can be repeated. PLY and glTF contain the effective mass as a property; pictures show two sides.
    #[arg(long, short, value_name = "FILE", help_heading = OUTPUT)]
    pub output: Vec<String>,
    #[command(flatten)]
    pub table: TableArgs,
    #[command(flatten)]
    pub writing: WritingArgs,
    /// Format of the result on stdout.
    #[arg(long, value_enum, default_value_t = MassFormat::Text, help_heading = OUTPUT)]
    pub format: MassFormat,
    /// Number of threads; default: the number of processors. Results do not depend on it.
    #[arg(
        long,
        value_name = "COUNT",
        value_parser = clap::value_parser!(u16).range(1..=1024),
        help_heading = OUTPUT
    )]
    pub threads: Option<u16>,
}

impl MapArgs {
    /// Refuses flags of a contact that do not apply to a map.
    pub fn check(&self) -> Result<(), Failure> {
        let contact = &self.contact;
        if contact.normal.is_some() || contact.along_line.is_some() {
            return Err(Failure::bad_input(
                "--normal, --along-line: a map uses the outward normals of the surface, or with --directions all directions; \
                 use percuss mass for a single normal",
            ));
        }
        if contact.estimate.is_some() {
            return Err(Failure::bad_input(
                "--estimate: not available in a map; use percuss mass or percuss sweep",
            ));
        }
        if contact.link.is_none() && !self.all {
            return Err(Failure::bad_input("give a link (--link LINK), or --all for every link"));
        }
        if contact.point.is_some() && self.directions.is_none() {
            return Err(Failure::bad_input(
                "--point: not used for a surface; add --directions COUNT to map the directions at this point",
            ));
        }
        Ok(())
    }

    /// Converts the flags to a map question.
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
