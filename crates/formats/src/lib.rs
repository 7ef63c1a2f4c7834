#![doc = include_str!("../README.md")]
//!
//! For a URDF, [`load`] works in five steps, each of which may refuse the file:
//!
//! 1. check that the bytes are text and bounded in size, tags, nesting and entities (before any parser runs);
//! 2. parse the text by roxmltree to a tree with positions;
//! 3. treat every element and attribute according to [the table of the dialect](crate#the-dialect);
//! 4. check every number and reference;
//! 5. build the mechanism; findings of the builder get their positions in the file.
//!
//! # The dialect
//! Plain URDF 1.0 to 1.2 and loop closures: URDF+ (`<loop>`, `<coupling>`, `independent`), `<loop_joint>`, a link with two
//! parent joints (the first joint in the file belongs to the tree), and SDF's `<joint>` in a `<gazebo>`. Elements without
//! effect on the mechanics (looks, sensors, controllers, simulator settings) are ignored without a message; unknown elements
//! are ignored with a warning; unsupported elements that would change the result are errors. The table is
//! `src/urdf/elements/dialect.rs`. Read with a note: white space before the XML declaration, missing blanks between attributes, bytes in
//! Windows-1252; the same in MJCF and SDFormat.
//!
//! ```xml
//! <loop name="pin" type="revolute">        <!-- fixed revolute continuous prismatic cylindrical universal planar
//!                                               spherical distance; links may be "world" -->
//!   <predecessor link="coupler"><origin xyz="0.7 0 0"/></predecessor>
//!   <successor link="rocker"><origin xyz="0.5 0 0" rpy="0 0 0"/></successor>
//!   <axis xyz="0 0 1"/>                    <!-- in both loop frames; 1 0 0 where there is none -->
//!   <axis2 xyz="0 1 0"/>                   <!-- universal: the successor's pin, in its loop frame -->
//!   <distance value="0.4"/>                <!-- distance: m; else the distance with all joints at 0 -->
//! </loop>
//! <coupling name="gear"><predecessor link="arm"/><successor link="rotor"/><ratio value="6"/></coupling>
//! <loop_joint name="ball" type="spherical"><link1 link="a" xyz="0 0 0" rpy="0 0 0"/><link2 link="b"/></loop_joint>
//! ```

pub mod reading;

mod adams;
#[cfg(feature = "urdf-rs")]
mod from_urdf_rs;
mod hull;
mod load;
mod meshes;
mod mjcf;
mod parts;
mod sdf;
mod shape;
mod shape_inertia;
mod urdf;
mod writing;
#[cfg(feature = "urdf-rs")]
pub use from_urdf_rs::from_urdf_rs;
pub use hull::inertias_beyond_meshes;
pub use load::{foreign_format, load, load_file};
pub use meshes::files::{DEFAULT_MAX_MESH_SIZE, MeshError, MeshFolders, Triangles, read_mesh};
pub use meshes::surface::{Facet, Orientation, Surface, SurfaceError};
pub use mjcf::write::{
    ImpactContact, ImpactSurfaces, MjcfError, MjcfImpact, balance_inertia, write_mjcf, write_mjcf_impact,
};
pub use reading::diagnostic::{Diagnostic, LoadError};
pub use reading::document::qpos::{QposError, QposLayout};
pub use reading::files::{FileKind, FileStore, FileSystem, MemoryFiles, OpenFile, SharedFiles};
pub use reading::report::NOT_READ;
pub use reading::source::{DEFAULT_MAX_SIZE, Source};
pub use reading::xml::root_name;
pub use sdf::write::{SdfError, write_sdf};
pub use shape::{Purpose, Shape, Solid};
pub use shape_inertia::inertia_of_shapes;
pub use urdf::load::{KNOWN_WARNING, LoadOptions, Loaded, NamedPose};
pub use urdf::write::{Comments, write_urdf, write_urdf_model, write_urdf_with};
pub use writing::changes::{Change, Effect, ModelText, lost_pose};
pub use writing::parts::{FindMesh, MeshFile, ModelParts};
pub use writing::state::MechanismState;
