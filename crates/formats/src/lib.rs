//! URDF to a [`Mechanism`](percuss_mechanism::Mechanism), with diagnostics that say where; and back.
//!
//! [`load`] works in five steps, each of which may refuse the file:
//!
//! 1. the bytes are text, not too many, and bounded in tags, nesting and entities (before any parser runs);
//! 2. roxmltree makes a tree with positions;
//! 3. [the table of the dialect](crate#the-dialect) says how every element and attribute is treated;
//! 4. every number and reference is checked;
//! 5. the mechanism's builder checks the whole; what it finds is given its place in the file.
//!
//! # The dialect
//! Plain URDF 1.0 to 1.2, and what closes loops: URDF+ (`<loop>`, `<coupling>`, `independent`), `<loop_joint>`, and
//! a link with two parent joints (the first in the file is the tree's), and SDF's `<joint>` in a `<gazebo>`. What does not affect the mechanics (looks,
//! sensors, controllers, simulator settings) is ignored without a message; what is not known is ignored with a
//! warning; what would change the answer and is not supported is an error. The table is `src/dialect.rs`.
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
//!
//! This crate knows no dynamics.

mod armature;
mod closure;
mod consistency;
mod diagnostic;
mod dialect;
mod gazebo_joint;
mod geometry;
mod joint;
mod limits;
mod link;
mod load;
mod loops;
mod mesh;
mod nodes;
mod numbers;
mod origin;
mod prescan;
mod references;
mod report;
mod shape;
mod source;
mod standard;
mod surface;
mod survey;
pub mod suspension;
mod texts;
mod transmission;
mod write;

pub use diagnostic::{Diagnostic, LoadError};
pub use load::{KNOWN_WARNING, LoadOptions, Loaded, load};
pub use mesh::{DEFAULT_MAX_MESH_SIZE, MeshError, MeshFolders, Triangles, read_mesh};
pub use shape::{Purpose, Shape, Solid};
pub use source::{DEFAULT_MAX_SIZE, Source};
pub use surface::{Facet, Orientation, Surface, SurfaceError};
pub use write::{Comments, write_urdf, write_urdf_with};
